/* Generated from derive/ (digest bfd9ab80ef38709d) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`. */
/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
#define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
#define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
#define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
#define CASADI_PREFIX(ID) equilibrium_ ## ID
#endif
#include <math.h>
#ifndef casadi_real
#define casadi_real double
#endif
#ifndef casadi_int
#define casadi_int long long int
#endif
/* Add prefix to internal symbols */
#define casadi_f0 CASADI_PREFIX(f0)
#define casadi_f1 CASADI_PREFIX(f1)
#define casadi_f2 CASADI_PREFIX(f2)
#define casadi_f3 CASADI_PREFIX(f3)
#define casadi_s0 CASADI_PREFIX(s0)
#define casadi_s1 CASADI_PREFIX(s1)
#define casadi_sq CASADI_PREFIX(sq)
/* Symbol visibility in DLLs */
#ifndef CASADI_SYMBOL_EXPORT
#if defined(_WIN32) || defined(__WIN32__) || defined(__CYGWIN__)
#if defined(STATIC_LINKED)
#define CASADI_SYMBOL_EXPORT
#else
#define CASADI_SYMBOL_EXPORT __declspec(dllexport)
#endif
#elif defined(__GNUC__) && defined(GCC_HASCLASSVISIBILITY)
#define CASADI_SYMBOL_EXPORT __attribute__ ((visibility ("default")))
#else
#define CASADI_SYMBOL_EXPORT
#endif
#endif
casadi_real casadi_sq(casadi_real x) { return x*x;}
/* Configuration this file was compiled with */
CASADI_SYMBOL_EXPORT void equilibrium_casadi_version(int* major, int* minor, int* patch) {
*major = 3;
*minor = 8;
*patch = 2;
}
CASADI_SYMBOL_EXPORT int equilibrium_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int equilibrium_casadi_real_size(void) { return (int) sizeof(casadi_real); }
static const casadi_int casadi_s0[3] = {1, 1, 1};
static const casadi_int casadi_s1[4] = {1, 1, 0, 0};
/* linear_equilibrium:(alpha,F_disturbance,m,a,b,u,rho,Ap,CL_gamma,C_alpha,Ct)->(sum_M,d_sum_M_d_alpha,d_M_gear_d_alpha,v,r) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
a00=arg[4]? arg[4][0] : 0;
a01=arg[9]? arg[9][0] : 0;
a02=arg[0]? arg[0][0] : 0;
a03=a01*a02;
a03=2.*a03;
a04=arg[2]? arg[2][0] : 0;
a04=a00*a04;
a05=arg[5]? arg[5][0] : 0;
a04=a04*a05;
a06=a03/a04;
a07=arg[3]? arg[3][0] : 0;
a08=a07+a00;
a06=a06*a08;
a08=a00*a06;
a09=a07*a06;
a02=a02*a05;
a09=a09+a02;
a08=a08+a09;
a08=a08/a05;
a02=5.0000000000000000e-01;
a10=arg[7]? arg[7][0] : 0;
a02=a02*a10;
a10=arg[8]? arg[8][0] : 0;
a02=a02*a10;
a10=arg[6]? arg[6][0] : 0;
a02=a02*a10;
a10=casadi_sq(a05);
a02=a02*a10;
a10=a08*a02;
a10=a10*a00;
a11=arg[1]? arg[1][0] : 0;
a11=a11*a00;
a03=a03*a07;
a11=a11+a03;
a10=a10-a11;
a11=arg[10]? arg[10][0] : 0;
a08=a11*a08;
a08=a08*a00;
a10=a10+a08;
if (res[0]!=0) res[0][0]=a10;
a01=2.*a01;
a10=a07+a00;
a10=a01*a10;
a04=a10/a04;
a08=a00*a04;
a08=a08/a05;
a04=a07*a04;
a04=a04+a05;
a04=a04/a05;
a08=a08+a04;
a02=a08*a02;
a02=a00*a02;
a07=a07*a01;
a02=a02-a07;
a11=a11*a08;
a00=a00*a11;
a02=a02+a00;
if (res[1]!=0) res[1][0]=a02;
if (res[2]!=0) res[2][0]=a10;
if (res[3]!=0) res[3][0]=a09;
a06=-a06;
if (res[4]!=0) res[4][0]=a06;
return 0;
}
CASADI_SYMBOL_EXPORT int linear_equilibrium(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f0(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int linear_equilibrium_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void linear_equilibrium_release(int mem) {
}
CASADI_SYMBOL_EXPORT void linear_equilibrium_incref(void) {
}
CASADI_SYMBOL_EXPORT void linear_equilibrium_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int linear_equilibrium_n_in(void) { return 11;}
CASADI_SYMBOL_EXPORT casadi_int linear_equilibrium_n_out(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_real linear_equilibrium_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* linear_equilibrium_name_in(casadi_int i) {
switch (i) {
case 0: return "alpha";
case 1: return "F_disturbance";
case 2: return "m";
case 3: return "a";
case 4: return "b";
case 5: return "u";
case 6: return "rho";
case 7: return "Ap";
case 8: return "CL_gamma";
case 9: return "C_alpha";
case 10: return "Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* linear_equilibrium_name_out(casadi_int i) {
switch (i) {
case 0: return "sum_M";
case 1: return "d_sum_M_d_alpha";
case 2: return "d_M_gear_d_alpha";
case 3: return "v";
case 4: return "r";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* linear_equilibrium_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
case 8: return casadi_s0;
case 9: return casadi_s0;
case 10: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* linear_equilibrium_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int linear_equilibrium_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 11;
if (sz_res) *sz_res = 5;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int linear_equilibrium_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 11*sizeof(const casadi_real*);
if (sz_res) *sz_res = 5*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_linear_equilibrium:(alpha,F_disturbance,m,a,b,u,rho,Ap,CL_gamma,C_alpha,Ct,out_sum_M[1x1,0nz],out_d_sum_M_d_alpha[1x1,0nz],out_d_M_gear_d_alpha[1x1,0nz],out_v[1x1,0nz],out_r[1x1,0nz],fwd_alpha,fwd_F_disturbance,fwd_m,fwd_a,fwd_b,fwd_u,fwd_rho,fwd_Ap,fwd_CL_gamma,fwd_C_alpha,fwd_Ct)->(fwd_sum_M,fwd_d_sum_M_d_alpha,fwd_d_M_gear_d_alpha,fwd_v,fwd_r) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27;
a00=arg[4]? arg[4][0] : 0;
a01=5.0000000000000000e-01;
a02=arg[7]? arg[7][0] : 0;
a02=a01*a02;
a03=arg[8]? arg[8][0] : 0;
a04=a02*a03;
a05=arg[6]? arg[6][0] : 0;
a06=a04*a05;
a07=arg[5]? arg[5][0] : 0;
a08=casadi_sq(a07);
a09=a06*a08;
a10=arg[9]? arg[9][0] : 0;
a11=arg[0]? arg[0][0] : 0;
a12=a10*a11;
a12=2.*a12;
a13=arg[2]? arg[2][0] : 0;
a14=a00*a13;
a15=a14*a07;
a16=a12/a15;
a17=arg[3]? arg[3][0] : 0;
a18=a17+a00;
a19=a16*a18;
a20=arg[20]? arg[20][0] : 0;
a21=a19*a20;
a22=arg[25]? arg[25][0] : 0;
a23=a11*a22;
a24=arg[16]? arg[16][0] : 0;
a25=a10*a24;
a23=a23+a25;
a23=2.*a23;
a25=a23/a15;
a26=a16/a15;
a13=a13*a20;
a27=arg[18]? arg[18][0] : 0;
a27=a00*a27;
a13=a13+a27;
a13=a07*a13;
a27=arg[21]? arg[21][0] : 0;
a14=a14*a27;
a13=a13+a14;
a26=a26*a13;
a25=a25-a26;
a18=a18*a25;
a25=arg[19]? arg[19][0] : 0;
a26=a25+a20;
a16=a16*a26;
a18=a18+a16;
a16=a00*a18;
a21=a21+a16;
a16=a19*a25;
a26=a17*a18;
a16=a16+a26;
a24=a07*a24;
a26=a11*a27;
a24=a24+a26;
a16=a16+a24;
a21=a21+a16;
a21=a21/a07;
a24=a00*a19;
a19=a17*a19;
a11=a11*a07;
a19=a19+a11;
a24=a24+a19;
a24=a24/a07;
a19=a24/a07;
a19=a19*a27;
a21=a21-a19;
a19=a09*a21;
a11=arg[23]? arg[23][0] : 0;
a01=a01*a11;
a03=a03*a01;
a01=arg[24]? arg[24][0] : 0;
a02=a02*a01;
a03=a03+a02;
a05=a05*a03;
a03=arg[22]? arg[22][0] : 0;
a04=a04*a03;
a05=a05+a04;
a08=a08*a05;
a05=2.*a07;
a05=a05*a27;
a06=a06*a05;
a08=a08+a06;
a06=a24*a08;
a19=a19+a06;
a19=a00*a19;
a06=a24*a09;
a06=a06*a20;
a19=a19+a06;
a06=arg[17]? arg[17][0] : 0;
a06=a00*a06;
a05=arg[1]? arg[1][0] : 0;
a05=a05*a20;
a06=a06+a05;
a23=a17*a23;
a12=a12*a25;
a23=a23+a12;
a06=a06+a23;
a19=a19-a06;
a06=arg[26]? arg[26][0] : 0;
a23=a24*a06;
a12=arg[10]? arg[10][0] : 0;
a21=a12*a21;
a23=a23+a21;
a23=a00*a23;
a24=a12*a24;
a24=a24*a20;
a23=a23+a24;
a19=a19+a23;
if (res[0]!=0) res[0][0]=a19;
a10=2.*a10;
a19=a17+a00;
a23=a10*a19;
a23=a23/a15;
a24=a00*a23;
a24=a24/a07;
a21=a17*a23;
a21=a21+a07;
a21=a21/a07;
a05=a24+a21;
a04=a05*a09;
a04=a04*a20;
a03=a23*a20;
a22=2.*a22;
a19=a19*a22;
a02=a25+a20;
a02=a10*a02;
a19=a19+a02;
a02=a19/a15;
a15=a23/a15;
a15=a15*a13;
a02=a02-a15;
a15=a00*a02;
a03=a03+a15;
a03=a03/a07;
a24=a24/a07;
a24=a24*a27;
a03=a03-a24;
a23=a23*a25;
a02=a17*a02;
a23=a23+a02;
a23=a23+a27;
a23=a23/a07;
a21=a21/a07;
a21=a21*a27;
a23=a23-a21;
a03=a03+a23;
a09=a09*a03;
a08=a05*a08;
a09=a09+a08;
a09=a00*a09;
a04=a04+a09;
a10=a10*a25;
a17=a17*a22;
a10=a10+a17;
a04=a04-a10;
a10=a12*a05;
a10=a10*a20;
a05=a05*a06;
a12=a12*a03;
a05=a05+a12;
a00=a00*a05;
a10=a10+a00;
a04=a04+a10;
if (res[1]!=0) res[1][0]=a04;
if (res[2]!=0) res[2][0]=a19;
if (res[3]!=0) res[3][0]=a16;
a18=-a18;
if (res[4]!=0) res[4][0]=a18;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_linear_equilibrium(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f1(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_linear_equilibrium_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_linear_equilibrium_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_linear_equilibrium_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_linear_equilibrium_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_linear_equilibrium_n_in(void) { return 27;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_linear_equilibrium_n_out(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_linear_equilibrium_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_linear_equilibrium_name_in(casadi_int i) {
switch (i) {
case 0: return "alpha";
case 1: return "F_disturbance";
case 2: return "m";
case 3: return "a";
case 4: return "b";
case 5: return "u";
case 6: return "rho";
case 7: return "Ap";
case 8: return "CL_gamma";
case 9: return "C_alpha";
case 10: return "Ct";
case 11: return "out_sum_M";
case 12: return "out_d_sum_M_d_alpha";
case 13: return "out_d_M_gear_d_alpha";
case 14: return "out_v";
case 15: return "out_r";
case 16: return "fwd_alpha";
case 17: return "fwd_F_disturbance";
case 18: return "fwd_m";
case 19: return "fwd_a";
case 20: return "fwd_b";
case 21: return "fwd_u";
case 22: return "fwd_rho";
case 23: return "fwd_Ap";
case 24: return "fwd_CL_gamma";
case 25: return "fwd_C_alpha";
case 26: return "fwd_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_linear_equilibrium_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_sum_M";
case 1: return "fwd_d_sum_M_d_alpha";
case 2: return "fwd_d_M_gear_d_alpha";
case 3: return "fwd_v";
case 4: return "fwd_r";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_linear_equilibrium_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
case 8: return casadi_s0;
case 9: return casadi_s0;
case 10: return casadi_s0;
case 11: return casadi_s1;
case 12: return casadi_s1;
case 13: return casadi_s1;
case 14: return casadi_s1;
case 15: return casadi_s1;
case 16: return casadi_s0;
case 17: return casadi_s0;
case 18: return casadi_s0;
case 19: return casadi_s0;
case 20: return casadi_s0;
case 21: return casadi_s0;
case 22: return casadi_s0;
case 23: return casadi_s0;
case 24: return casadi_s0;
case 25: return casadi_s0;
case 26: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_linear_equilibrium_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_linear_equilibrium_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 27;
if (sz_res) *sz_res = 5;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_linear_equilibrium_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 27*sizeof(const casadi_real*);
if (sz_res) *sz_res = 5*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_linear_equilibrium:(alpha,F_disturbance,m,a,b,u,rho,Ap,CL_gamma,C_alpha,Ct,out_sum_M[1x1,0nz],out_d_sum_M_d_alpha[1x1,0nz],out_d_M_gear_d_alpha[1x1,0nz],out_v[1x1,0nz],out_r[1x1,0nz],adj_sum_M,adj_d_sum_M_d_alpha,adj_d_M_gear_d_alpha,adj_v,adj_r)->(adj_alpha,adj_F_disturbance,adj_m,adj_a,adj_b,adj_u,adj_rho,adj_Ap,adj_CL_gamma,adj_C_alpha,adj_Ct) */
static int casadi_f2(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40;
a00=arg[5]? arg[5][0] : 0;
a01=arg[19]? arg[19][0] : 0;
a02=arg[10]? arg[10][0] : 0;
a03=arg[4]? arg[4][0] : 0;
a04=arg[16]? arg[16][0] : 0;
a05=a03*a04;
a06=a02*a05;
a07=5.0000000000000000e-01;
a08=arg[7]? arg[7][0] : 0;
a08=a07*a08;
a09=arg[8]? arg[8][0] : 0;
a10=a08*a09;
a11=arg[6]? arg[6][0] : 0;
a12=a10*a11;
a13=casadi_sq(a00);
a14=a12*a13;
a15=a03*a04;
a16=a14*a15;
a06=a06+a16;
a16=a06/a00;
a01=a01+a16;
a17=a00*a01;
a18=arg[9]? arg[9][0] : 0;
a19=arg[3]? arg[3][0] : 0;
a20=a19+a03;
a21=a19*a01;
a22=arg[20]? arg[20][0] : 0;
a21=a21-a22;
a22=a03*a16;
a21=a21+a22;
a22=a20*a21;
a23=arg[2]? arg[2][0] : 0;
a24=a03*a23;
a25=a24*a00;
a26=a22/a25;
a27=a19*a04;
a26=a26-a27;
a26=2.*a26;
a27=a18*a26;
a17=a17+a27;
if (res[0]!=0) res[0][0]=a17;
a17=a03*a04;
a17=-a17;
if (res[1]!=0) res[1][0]=a17;
a17=2.*a18;
a27=a19+a03;
a28=a17*a27;
a28=a28/a25;
a29=a28/a25;
a30=arg[17]? arg[17][0] : 0;
a31=a03*a30;
a32=a02*a31;
a33=a03*a30;
a34=a14*a33;
a32=a32+a34;
a34=a32/a00;
a35=a19*a34;
a36=a32/a00;
a37=a03*a36;
a35=a35+a37;
a29=a29*a35;
a37=arg[0]? arg[0][0] : 0;
a18=a18*a37;
a18=2.*a18;
a38=a18/a25;
a39=a38/a25;
a39=a39*a22;
a29=a29+a39;
a39=a00*a29;
a22=a03*a39;
a22=-a22;
if (res[2]!=0) res[2][0]=a22;
a22=a28*a34;
a40=a17*a30;
a22=a22-a40;
a40=arg[18]? arg[18][0] : 0;
a35=a35/a25;
a40=a40+a35;
a17=a17*a40;
a22=a22+a17;
a18=a18*a04;
a22=a22-a18;
a20=a38*a20;
a18=a20*a01;
a22=a22+a18;
a38=a38*a21;
a22=a22+a38;
if (res[3]!=0) res[3][0]=a22;
a22=a03*a28;
a22=a22/a00;
a21=a19*a28;
a21=a21+a00;
a21=a21/a00;
a18=a22+a21;
a35=a02*a18;
a35=a35*a30;
a25=a18*a14;
a25=a25*a30;
a35=a35+a25;
a28=a28*a36;
a35=a35+a28;
a35=a35+a17;
a03=a03*a20;
a17=a19*a20;
a28=a37*a00;
a17=a17+a28;
a03=a03+a17;
a03=a03/a00;
a02=a02*a03;
a02=a02*a04;
a35=a35+a02;
a02=arg[1]? arg[1][0] : 0;
a02=a02*a04;
a35=a35-a02;
a14=a03*a14;
a14=a14*a04;
a35=a35+a14;
a20=a20*a16;
a35=a35+a20;
a35=a35+a38;
a23=a23*a39;
a35=a35-a23;
if (res[4]!=0) res[4][0]=a35;
a21=a21/a00;
a21=a21*a32;
a34=a34-a21;
a22=a22/a00;
a22=a22*a32;
a34=a34-a22;
a22=2.*a00;
a33=a18*a33;
a15=a03*a15;
a33=a33+a15;
a12=a12*a33;
a22=a22*a12;
a34=a34+a22;
a00=a03/a00;
a00=a00*a06;
a34=a34-a00;
a01=a37*a01;
a34=a34+a01;
a24=a24*a29;
a34=a34-a24;
if (res[5]!=0) res[5][0]=a34;
a13=a13*a33;
a10=a10*a13;
if (res[6]!=0) res[6][0]=a10;
a11=a11*a13;
a09=a09*a11;
a07=a07*a09;
if (res[7]!=0) res[7][0]=a07;
a08=a08*a11;
if (res[8]!=0) res[8][0]=a08;
a27=a27*a40;
a19=a19*a30;
a27=a27-a19;
a27=2.*a27;
a37=a37*a26;
a27=a27+a37;
if (res[9]!=0) res[9][0]=a27;
a18=a18*a31;
a03=a03*a05;
a18=a18+a03;
if (res[10]!=0) res[10][0]=a18;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_linear_equilibrium(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f2(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_linear_equilibrium_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_linear_equilibrium_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_linear_equilibrium_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_linear_equilibrium_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_linear_equilibrium_n_in(void) { return 21;}
CASADI_SYMBOL_EXPORT casadi_int adj1_linear_equilibrium_n_out(void) { return 11;}
CASADI_SYMBOL_EXPORT casadi_real adj1_linear_equilibrium_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_linear_equilibrium_name_in(casadi_int i) {
switch (i) {
case 0: return "alpha";
case 1: return "F_disturbance";
case 2: return "m";
case 3: return "a";
case 4: return "b";
case 5: return "u";
case 6: return "rho";
case 7: return "Ap";
case 8: return "CL_gamma";
case 9: return "C_alpha";
case 10: return "Ct";
case 11: return "out_sum_M";
case 12: return "out_d_sum_M_d_alpha";
case 13: return "out_d_M_gear_d_alpha";
case 14: return "out_v";
case 15: return "out_r";
case 16: return "adj_sum_M";
case 17: return "adj_d_sum_M_d_alpha";
case 18: return "adj_d_M_gear_d_alpha";
case 19: return "adj_v";
case 20: return "adj_r";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_linear_equilibrium_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_alpha";
case 1: return "adj_F_disturbance";
case 2: return "adj_m";
case 3: return "adj_a";
case 4: return "adj_b";
case 5: return "adj_u";
case 6: return "adj_rho";
case 7: return "adj_Ap";
case 8: return "adj_CL_gamma";
case 9: return "adj_C_alpha";
case 10: return "adj_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_linear_equilibrium_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
case 8: return casadi_s0;
case 9: return casadi_s0;
case 10: return casadi_s0;
case 11: return casadi_s1;
case 12: return casadi_s1;
case 13: return casadi_s1;
case 14: return casadi_s1;
case 15: return casadi_s1;
case 16: return casadi_s0;
case 17: return casadi_s0;
case 18: return casadi_s0;
case 19: return casadi_s0;
case 20: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_linear_equilibrium_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
case 8: return casadi_s0;
case 9: return casadi_s0;
case 10: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_linear_equilibrium_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 21;
if (sz_res) *sz_res = 11;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_linear_equilibrium_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 21*sizeof(const casadi_real*);
if (sz_res) *sz_res = 11*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_linear_equilibrium:(alpha,F_disturbance,m,a,b,u,rho,Ap,CL_gamma,C_alpha,Ct,out_sum_M[1x1,0nz],out_d_sum_M_d_alpha[1x1,0nz],out_d_M_gear_d_alpha[1x1,0nz],out_v[1x1,0nz],out_r[1x1,0nz],adj_sum_M,adj_d_sum_M_d_alpha,adj_d_M_gear_d_alpha,adj_v,adj_r,out_adj_alpha[1x1,0nz],out_adj_F_disturbance[1x1,0nz],out_adj_m[1x1,0nz],out_adj_a[1x1,0nz],out_adj_b[1x1,0nz],out_adj_u[1x1,0nz],out_adj_rho[1x1,0nz],out_adj_Ap[1x1,0nz],out_adj_CL_gamma[1x1,0nz],out_adj_C_alpha[1x1,0nz],out_adj_Ct[1x1,0nz],fwd_alpha,fwd_F_disturbance,fwd_m,fwd_a,fwd_b,fwd_u,fwd_rho,fwd_Ap,fwd_CL_gamma,fwd_C_alpha,fwd_Ct,fwd_out_sum_M[1x1,0nz],fwd_out_d_sum_M_d_alpha[1x1,0nz],fwd_out_d_M_gear_d_alpha[1x1,0nz],fwd_out_v[1x1,0nz],fwd_out_r[1x1,0nz],fwd_adj_sum_M,fwd_adj_d_sum_M_d_alpha,fwd_adj_d_M_gear_d_alpha,fwd_adj_v,fwd_adj_r)->(fwd_adj_alpha,fwd_adj_F_disturbance,fwd_adj_m,fwd_adj_a,fwd_adj_b,fwd_adj_u,fwd_adj_rho,fwd_adj_Ap,fwd_adj_CL_gamma,fwd_adj_C_alpha,fwd_adj_Ct) */
static int casadi_f3(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
casadi_real a72, a73, a74, a75, a76, a77, a78, a79, a80, a81, a82;
a00=arg[19]? arg[19][0] : 0;
a01=arg[10]? arg[10][0] : 0;
a02=arg[4]? arg[4][0] : 0;
a03=arg[16]? arg[16][0] : 0;
a04=a02*a03;
a05=a01*a04;
a06=5.0000000000000000e-01;
a07=arg[7]? arg[7][0] : 0;
a07=a06*a07;
a08=arg[8]? arg[8][0] : 0;
a09=a07*a08;
a10=arg[6]? arg[6][0] : 0;
a11=a09*a10;
a12=arg[5]? arg[5][0] : 0;
a13=casadi_sq(a12);
a14=a11*a13;
a15=a02*a03;
a16=a14*a15;
a05=a05+a16;
a16=a05/a12;
a00=a00+a16;
a17=arg[37]? arg[37][0] : 0;
a18=a00*a17;
a19=arg[51]? arg[51][0] : 0;
a20=arg[42]? arg[42][0] : 0;
a21=a04*a20;
a22=arg[36]? arg[36][0] : 0;
a23=a03*a22;
a24=arg[48]? arg[48][0] : 0;
a25=a02*a24;
a23=a23+a25;
a25=a01*a23;
a21=a21+a25;
a25=arg[39]? arg[39][0] : 0;
a25=a06*a25;
a26=a08*a25;
a27=arg[40]? arg[40][0] : 0;
a28=a07*a27;
a26=a26+a28;
a28=a10*a26;
a29=arg[38]? arg[38][0] : 0;
a30=a09*a29;
a28=a28+a30;
a30=a13*a28;
a31=2.*a12;
a31=a31*a17;
a32=a11*a31;
a30=a30+a32;
a32=a15*a30;
a33=a03*a22;
a34=a02*a24;
a33=a33+a34;
a34=a14*a33;
a32=a32+a34;
a21=a21+a32;
a32=a21/a12;
a34=a16/a12;
a34=a34*a17;
a32=a32-a34;
a19=a19+a32;
a34=a12*a19;
a18=a18+a34;
a34=arg[3]? arg[3][0] : 0;
a35=a34+a02;
a36=a34*a00;
a37=arg[20]? arg[20][0] : 0;
a36=a36-a37;
a37=a02*a16;
a36=a36+a37;
a37=a35*a36;
a38=arg[2]? arg[2][0] : 0;
a39=a02*a38;
a40=a39*a12;
a41=a37/a40;
a42=a34*a03;
a42=a41-a42;
a42=2.*a42;
a43=arg[41]? arg[41][0] : 0;
a44=a42*a43;
a45=arg[9]? arg[9][0] : 0;
a46=arg[35]? arg[35][0] : 0;
a47=a46+a22;
a48=a36*a47;
a49=a00*a46;
a50=a34*a19;
a49=a49+a50;
a50=arg[52]? arg[52][0] : 0;
a49=a49-a50;
a50=a16*a22;
a51=a02*a32;
a50=a50+a51;
a49=a49+a50;
a50=a35*a49;
a48=a48+a50;
a50=a48/a40;
a41=a41/a40;
a51=a38*a22;
a52=arg[34]? arg[34][0] : 0;
a53=a02*a52;
a51=a51+a53;
a53=a12*a51;
a54=a39*a17;
a53=a53+a54;
a41=a41*a53;
a50=a50-a41;
a41=a03*a46;
a54=a34*a24;
a41=a41+a54;
a50=a50-a41;
a50=2.*a50;
a41=a45*a50;
a44=a44+a41;
a18=a18+a44;
if (res[0]!=0) res[0][0]=a18;
a18=a03*a22;
a44=a02*a24;
a18=a18+a44;
a18=-a18;
if (res[1]!=0) res[1][0]=a18;
a18=2.*a45;
a44=a34+a02;
a41=a18*a44;
a41=a41/a40;
a54=a41/a40;
a55=arg[17]? arg[17][0] : 0;
a56=a02*a55;
a57=a01*a56;
a58=a02*a55;
a59=a14*a58;
a57=a57+a59;
a59=a57/a12;
a60=a34*a59;
a61=a57/a12;
a62=a02*a61;
a60=a60+a62;
a62=a54*a60;
a63=arg[0]? arg[0][0] : 0;
a64=a45*a63;
a64=2.*a64;
a65=a64/a40;
a66=a65/a40;
a67=a66*a37;
a62=a62+a67;
a67=a12*a62;
a68=a67*a22;
a69=a62*a17;
a70=2.*a43;
a71=a44*a70;
a72=a46+a22;
a73=a18*a72;
a71=a71+a73;
a71=a71/a40;
a73=a41/a40;
a73=a73*a53;
a71=a71-a73;
a73=a71/a40;
a74=a54/a40;
a74=a74*a53;
a73=a73-a74;
a73=a60*a73;
a74=a59*a46;
a75=a56*a20;
a76=a55*a22;
a77=arg[49]? arg[49][0] : 0;
a78=a02*a77;
a76=a76+a78;
a78=a01*a76;
a75=a75+a78;
a78=a58*a30;
a79=a55*a22;
a80=a02*a77;
a79=a79+a80;
a80=a14*a79;
a78=a78+a80;
a75=a75+a78;
a78=a75/a12;
a80=a59/a12;
a80=a80*a17;
a78=a78-a80;
a80=a34*a78;
a74=a74+a80;
a80=a61*a22;
a81=a75/a12;
a82=a61/a12;
a82=a82*a17;
a81=a81-a82;
a82=a02*a81;
a80=a80+a82;
a74=a74+a80;
a54=a54*a74;
a73=a73+a54;
a43=a63*a43;
a54=arg[32]? arg[32][0] : 0;
a45=a45*a54;
a43=a43+a45;
a43=2.*a43;
a45=a43/a40;
a80=a65/a40;
a80=a80*a53;
a45=a45-a80;
a80=a45/a40;
a82=a66/a40;
a82=a82*a53;
a80=a80-a82;
a37=a37*a80;
a66=a66*a48;
a37=a37+a66;
a73=a73+a37;
a37=a12*a73;
a69=a69+a37;
a37=a02*a69;
a68=a68+a37;
a68=-a68;
if (res[2]!=0) res[2][0]=a68;
a59=a59*a71;
a68=a41*a78;
a59=a59+a68;
a68=a55*a70;
a37=a18*a77;
a68=a68+a37;
a59=a59-a68;
a68=arg[18]? arg[18][0] : 0;
a60=a60/a40;
a68=a68+a60;
a70=a68*a70;
a37=arg[50]? arg[50][0] : 0;
a74=a74/a40;
a60=a60/a40;
a60=a60*a53;
a74=a74-a60;
a37=a37+a74;
a18=a18*a37;
a70=a70+a18;
a59=a59+a70;
a43=a03*a43;
a64=a64*a24;
a43=a43+a64;
a59=a59-a43;
a43=a35*a45;
a47=a65*a47;
a43=a43+a47;
a47=a00*a43;
a35=a65*a35;
a64=a35*a19;
a47=a47+a64;
a59=a59+a47;
a36=a36*a45;
a65=a65*a49;
a36=a36+a65;
a59=a59+a36;
if (res[3]!=0) res[3][0]=a59;
a59=a02*a41;
a59=a59/a12;
a65=a34*a41;
a65=a65+a12;
a65=a65/a12;
a49=a59+a65;
a45=a49*a20;
a47=a41*a22;
a64=a02*a71;
a47=a47+a64;
a47=a47/a12;
a64=a59/a12;
a64=a64*a17;
a47=a47-a64;
a64=a41*a46;
a18=a34*a71;
a64=a64+a18;
a64=a64+a17;
a64=a64/a12;
a18=a65/a12;
a18=a18*a17;
a64=a64-a18;
a18=a47+a64;
a74=a01*a18;
a45=a45+a74;
a45=a55*a45;
a74=a01*a49;
a74=a74*a77;
a45=a45+a74;
a74=a14*a18;
a60=a49*a30;
a74=a74+a60;
a74=a55*a74;
a60=a49*a14;
a60=a60*a77;
a74=a74+a60;
a45=a45+a74;
a61=a61*a71;
a41=a41*a81;
a61=a61+a41;
a45=a45+a61;
a45=a45+a70;
a70=a02*a35;
a61=a34*a35;
a41=a63*a12;
a61=a61+a41;
a70=a70+a61;
a70=a70/a12;
a20=a70*a20;
a22=a35*a22;
a02=a02*a43;
a22=a22+a02;
a02=a35*a46;
a61=a34*a43;
a02=a02+a61;
a61=a12*a54;
a41=a63*a17;
a61=a61+a41;
a02=a02+a61;
a22=a22+a02;
a22=a22/a12;
a02=a70/a12;
a02=a02*a17;
a22=a22-a02;
a02=a01*a22;
a20=a20+a02;
a20=a03*a20;
a01=a01*a70;
a01=a01*a24;
a20=a20+a01;
a45=a45+a20;
a20=arg[33]? arg[33][0] : 0;
a20=a03*a20;
a01=arg[1]? arg[1][0] : 0;
a01=a01*a24;
a20=a20+a01;
a45=a45-a20;
a20=a14*a22;
a30=a70*a30;
a20=a20+a30;
a03=a03*a20;
a14=a70*a14;
a14=a14*a24;
a03=a03+a14;
a45=a45+a03;
a16=a16*a43;
a35=a35*a32;
a16=a16+a35;
a45=a45+a16;
a45=a45+a36;
a67=a67*a52;
a38=a38*a69;
a67=a67+a38;
a45=a45-a67;
if (res[4]!=0) res[4][0]=a45;
a64=a64/a12;
a65=a65/a12;
a45=a65/a12;
a45=a45*a17;
a64=a64-a45;
a64=a57*a64;
a65=a65*a75;
a64=a64+a65;
a78=a78-a64;
a47=a47/a12;
a59=a59/a12;
a64=a59/a12;
a64=a64*a17;
a47=a47-a64;
a57=a57*a47;
a59=a59*a75;
a57=a57+a59;
a78=a78-a57;
a57=a49*a58;
a59=a70*a15;
a57=a57+a59;
a59=a11*a57;
a75=2.*a17;
a59=a59*a75;
a75=2.*a12;
a28=a57*a28;
a58=a58*a18;
a79=a49*a79;
a58=a58+a79;
a15=a15*a22;
a33=a70*a33;
a15=a15+a33;
a58=a58+a15;
a11=a11*a58;
a28=a28+a11;
a75=a75*a28;
a59=a59+a75;
a78=a78+a59;
a59=a22/a12;
a75=a70/a12;
a12=a75/a12;
a12=a12*a17;
a59=a59-a12;
a05=a05*a59;
a75=a75*a21;
a05=a05+a75;
a78=a78-a05;
a00=a00*a54;
a19=a63*a19;
a00=a00+a19;
a78=a78+a00;
a62=a62*a51;
a39=a39*a73;
a62=a62+a39;
a78=a78-a62;
if (res[5]!=0) res[5][0]=a78;
a78=a13*a57;
a26=a78*a26;
a57=a57*a31;
a13=a13*a58;
a57=a57+a13;
a09=a09*a57;
a26=a26+a09;
if (res[6]!=0) res[6][0]=a26;
a26=a10*a78;
a27=a26*a27;
a78=a78*a29;
a10=a10*a57;
a78=a78+a10;
a08=a08*a78;
a27=a27+a08;
a06=a06*a27;
if (res[7]!=0) res[7][0]=a06;
a26=a26*a25;
a07=a07*a78;
a26=a26+a07;
if (res[8]!=0) res[8][0]=a26;
a68=a68*a72;
a44=a44*a37;
a68=a68+a44;
a55=a55*a46;
a34=a34*a77;
a55=a55+a34;
a68=a68-a55;
a68=2.*a68;
a42=a42*a54;
a63=a63*a50;
a42=a42+a63;
a68=a68+a42;
if (res[9]!=0) res[9][0]=a68;
a56=a56*a18;
a49=a49*a76;
a56=a56+a49;
a04=a04*a22;
a70=a70*a23;
a04=a04+a70;
a56=a56+a04;
if (res[10]!=0) res[10][0]=a56;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_linear_equilibrium(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f3(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_linear_equilibrium_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_linear_equilibrium_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_linear_equilibrium_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_linear_equilibrium_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_linear_equilibrium_n_in(void) { return 53;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_linear_equilibrium_n_out(void) { return 11;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_linear_equilibrium_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_linear_equilibrium_name_in(casadi_int i) {
switch (i) {
case 0: return "alpha";
case 1: return "F_disturbance";
case 2: return "m";
case 3: return "a";
case 4: return "b";
case 5: return "u";
case 6: return "rho";
case 7: return "Ap";
case 8: return "CL_gamma";
case 9: return "C_alpha";
case 10: return "Ct";
case 11: return "out_sum_M";
case 12: return "out_d_sum_M_d_alpha";
case 13: return "out_d_M_gear_d_alpha";
case 14: return "out_v";
case 15: return "out_r";
case 16: return "adj_sum_M";
case 17: return "adj_d_sum_M_d_alpha";
case 18: return "adj_d_M_gear_d_alpha";
case 19: return "adj_v";
case 20: return "adj_r";
case 21: return "out_adj_alpha";
case 22: return "out_adj_F_disturbance";
case 23: return "out_adj_m";
case 24: return "out_adj_a";
case 25: return "out_adj_b";
case 26: return "out_adj_u";
case 27: return "out_adj_rho";
case 28: return "out_adj_Ap";
case 29: return "out_adj_CL_gamma";
case 30: return "out_adj_C_alpha";
case 31: return "out_adj_Ct";
case 32: return "fwd_alpha";
case 33: return "fwd_F_disturbance";
case 34: return "fwd_m";
case 35: return "fwd_a";
case 36: return "fwd_b";
case 37: return "fwd_u";
case 38: return "fwd_rho";
case 39: return "fwd_Ap";
case 40: return "fwd_CL_gamma";
case 41: return "fwd_C_alpha";
case 42: return "fwd_Ct";
case 43: return "fwd_out_sum_M";
case 44: return "fwd_out_d_sum_M_d_alpha";
case 45: return "fwd_out_d_M_gear_d_alpha";
case 46: return "fwd_out_v";
case 47: return "fwd_out_r";
case 48: return "fwd_adj_sum_M";
case 49: return "fwd_adj_d_sum_M_d_alpha";
case 50: return "fwd_adj_d_M_gear_d_alpha";
case 51: return "fwd_adj_v";
case 52: return "fwd_adj_r";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_linear_equilibrium_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_alpha";
case 1: return "fwd_adj_F_disturbance";
case 2: return "fwd_adj_m";
case 3: return "fwd_adj_a";
case 4: return "fwd_adj_b";
case 5: return "fwd_adj_u";
case 6: return "fwd_adj_rho";
case 7: return "fwd_adj_Ap";
case 8: return "fwd_adj_CL_gamma";
case 9: return "fwd_adj_C_alpha";
case 10: return "fwd_adj_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_linear_equilibrium_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
case 8: return casadi_s0;
case 9: return casadi_s0;
case 10: return casadi_s0;
case 11: return casadi_s1;
case 12: return casadi_s1;
case 13: return casadi_s1;
case 14: return casadi_s1;
case 15: return casadi_s1;
case 16: return casadi_s0;
case 17: return casadi_s0;
case 18: return casadi_s0;
case 19: return casadi_s0;
case 20: return casadi_s0;
case 21: return casadi_s1;
case 22: return casadi_s1;
case 23: return casadi_s1;
case 24: return casadi_s1;
case 25: return casadi_s1;
case 26: return casadi_s1;
case 27: return casadi_s1;
case 28: return casadi_s1;
case 29: return casadi_s1;
case 30: return casadi_s1;
case 31: return casadi_s1;
case 32: return casadi_s0;
case 33: return casadi_s0;
case 34: return casadi_s0;
case 35: return casadi_s0;
case 36: return casadi_s0;
case 37: return casadi_s0;
case 38: return casadi_s0;
case 39: return casadi_s0;
case 40: return casadi_s0;
case 41: return casadi_s0;
case 42: return casadi_s0;
case 43: return casadi_s1;
case 44: return casadi_s1;
case 45: return casadi_s1;
case 46: return casadi_s1;
case 47: return casadi_s1;
case 48: return casadi_s0;
case 49: return casadi_s0;
case 50: return casadi_s0;
case 51: return casadi_s0;
case 52: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_linear_equilibrium_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
case 8: return casadi_s0;
case 9: return casadi_s0;
case 10: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_linear_equilibrium_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 53;
if (sz_res) *sz_res = 11;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_linear_equilibrium_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 53*sizeof(const casadi_real*);
if (sz_res) *sz_res = 11*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
