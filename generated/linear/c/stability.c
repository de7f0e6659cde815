/* Generated from derive/ (digest bfd9ab80ef38709d) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`. */
/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
#define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
#define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
#define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
#define CASADI_PREFIX(ID) stability_ ## ID
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
#define casadi_f10 CASADI_PREFIX(f10)
#define casadi_f11 CASADI_PREFIX(f11)
#define casadi_f12 CASADI_PREFIX(f12)
#define casadi_f13 CASADI_PREFIX(f13)
#define casadi_f14 CASADI_PREFIX(f14)
#define casadi_f15 CASADI_PREFIX(f15)
#define casadi_f16 CASADI_PREFIX(f16)
#define casadi_f17 CASADI_PREFIX(f17)
#define casadi_f18 CASADI_PREFIX(f18)
#define casadi_f19 CASADI_PREFIX(f19)
#define casadi_f2 CASADI_PREFIX(f2)
#define casadi_f20 CASADI_PREFIX(f20)
#define casadi_f21 CASADI_PREFIX(f21)
#define casadi_f22 CASADI_PREFIX(f22)
#define casadi_f23 CASADI_PREFIX(f23)
#define casadi_f24 CASADI_PREFIX(f24)
#define casadi_f25 CASADI_PREFIX(f25)
#define casadi_f26 CASADI_PREFIX(f26)
#define casadi_f27 CASADI_PREFIX(f27)
#define casadi_f28 CASADI_PREFIX(f28)
#define casadi_f29 CASADI_PREFIX(f29)
#define casadi_f3 CASADI_PREFIX(f3)
#define casadi_f30 CASADI_PREFIX(f30)
#define casadi_f31 CASADI_PREFIX(f31)
#define casadi_f32 CASADI_PREFIX(f32)
#define casadi_f33 CASADI_PREFIX(f33)
#define casadi_f34 CASADI_PREFIX(f34)
#define casadi_f35 CASADI_PREFIX(f35)
#define casadi_f36 CASADI_PREFIX(f36)
#define casadi_f37 CASADI_PREFIX(f37)
#define casadi_f38 CASADI_PREFIX(f38)
#define casadi_f39 CASADI_PREFIX(f39)
#define casadi_f4 CASADI_PREFIX(f4)
#define casadi_f40 CASADI_PREFIX(f40)
#define casadi_f41 CASADI_PREFIX(f41)
#define casadi_f42 CASADI_PREFIX(f42)
#define casadi_f43 CASADI_PREFIX(f43)
#define casadi_f44 CASADI_PREFIX(f44)
#define casadi_f45 CASADI_PREFIX(f45)
#define casadi_f46 CASADI_PREFIX(f46)
#define casadi_f47 CASADI_PREFIX(f47)
#define casadi_f48 CASADI_PREFIX(f48)
#define casadi_f49 CASADI_PREFIX(f49)
#define casadi_f5 CASADI_PREFIX(f5)
#define casadi_f50 CASADI_PREFIX(f50)
#define casadi_f51 CASADI_PREFIX(f51)
#define casadi_f52 CASADI_PREFIX(f52)
#define casadi_f53 CASADI_PREFIX(f53)
#define casadi_f54 CASADI_PREFIX(f54)
#define casadi_f55 CASADI_PREFIX(f55)
#define casadi_f56 CASADI_PREFIX(f56)
#define casadi_f57 CASADI_PREFIX(f57)
#define casadi_f58 CASADI_PREFIX(f58)
#define casadi_f59 CASADI_PREFIX(f59)
#define casadi_f6 CASADI_PREFIX(f6)
#define casadi_f60 CASADI_PREFIX(f60)
#define casadi_f61 CASADI_PREFIX(f61)
#define casadi_f62 CASADI_PREFIX(f62)
#define casadi_f63 CASADI_PREFIX(f63)
#define casadi_f64 CASADI_PREFIX(f64)
#define casadi_f65 CASADI_PREFIX(f65)
#define casadi_f66 CASADI_PREFIX(f66)
#define casadi_f67 CASADI_PREFIX(f67)
#define casadi_f7 CASADI_PREFIX(f7)
#define casadi_f8 CASADI_PREFIX(f8)
#define casadi_f9 CASADI_PREFIX(f9)
#define casadi_fabs CASADI_PREFIX(fabs)
#define casadi_fmax CASADI_PREFIX(fmax)
#define casadi_s0 CASADI_PREFIX(s0)
#define casadi_s1 CASADI_PREFIX(s1)
#define casadi_sign CASADI_PREFIX(sign)
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
casadi_real casadi_fabs(casadi_real x) {
/* Pre-c99 compatibility */
#if __STDC_VERSION__ < 199901L
return x>0 ? x : -x;
#else
return fabs(x);
#endif
}
casadi_real casadi_sign(casadi_real x) { return x<0 ? -1 : x>0 ? 1 : x;}
casadi_real casadi_fmax(casadi_real x, casadi_real y) {
/* Pre-c99 compatibility */
#if __STDC_VERSION__ < 199901L
return x>y ? x : y;
#else
return fmax(x, y);
#endif
}
/* Configuration this file was compiled with */
CASADI_SYMBOL_EXPORT void stability_casadi_version(int* major, int* minor, int* patch) {
*major = 3;
*minor = 8;
*patch = 2;
}
CASADI_SYMBOL_EXPORT int stability_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int stability_casadi_real_size(void) { return (int) sizeof(casadi_real); }
static const casadi_int casadi_s0[3] = {1, 1, 1};
static const casadi_int casadi_s1[4] = {1, 1, 0, 0};
/* state_matrix:(m,Izz,a,b,u,rho,Ap,CL_gamma,C_alpha,Ct)->(A_vv,A_vr,A_rv,A_rr) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5, a6, a7, a8;
a0=arg[8]? arg[8][0] : 0;
a0=2.*a0;
a1=arg[9]? arg[9][0] : 0;
a2=5.0000000000000000e-01;
a3=arg[6]? arg[6][0] : 0;
a2=a2*a3;
a3=arg[7]? arg[7][0] : 0;
a2=a2*a3;
a3=arg[5]? arg[5][0] : 0;
a2=a2*a3;
a3=arg[4]? arg[4][0] : 0;
a4=casadi_sq(a3);
a2=a2*a4;
a1=a1+a2;
a2=a0+a1;
a4=arg[0]? arg[0][0] : 0;
a5=a4*a3;
a2=a2/a5;
a2=-a2;
if (res[0]!=0) res[0][0]=a2;
a2=casadi_sq(a3);
a4=a4*a2;
a2=arg[2]? arg[2][0] : 0;
a6=a0*a2;
a7=arg[3]? arg[3][0] : 0;
a8=a1*a7;
a6=a6-a8;
a4=a4+a6;
a4=a4/a5;
a4=-a4;
if (res[1]!=0) res[1][0]=a4;
a4=arg[1]? arg[1][0] : 0;
a4=a4*a3;
a6=a6/a4;
a6=-a6;
if (res[2]!=0) res[2][0]=a6;
a2=casadi_sq(a2);
a0=a0*a2;
a7=casadi_sq(a7);
a1=a1*a7;
a0=a0+a1;
a0=a0/a4;
a0=-a0;
if (res[3]!=0) res[3][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int state_matrix(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f0(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int state_matrix_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void state_matrix_release(int mem) {
}
CASADI_SYMBOL_EXPORT void state_matrix_incref(void) {
}
CASADI_SYMBOL_EXPORT void state_matrix_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int state_matrix_n_in(void) { return 10;}
CASADI_SYMBOL_EXPORT casadi_int state_matrix_n_out(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_real state_matrix_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* state_matrix_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "Izz";
case 2: return "a";
case 3: return "b";
case 4: return "u";
case 5: return "rho";
case 6: return "Ap";
case 7: return "CL_gamma";
case 8: return "C_alpha";
case 9: return "Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* state_matrix_name_out(casadi_int i) {
switch (i) {
case 0: return "A_vv";
case 1: return "A_vr";
case 2: return "A_rv";
case 3: return "A_rr";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* state_matrix_sparsity_in(casadi_int i) {
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
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* state_matrix_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int state_matrix_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 10;
if (sz_res) *sz_res = 4;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int state_matrix_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
if (sz_res) *sz_res = 4*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_state_matrix:(m,Izz,a,b,u,rho,Ap,CL_gamma,C_alpha,Ct,out_A_vv[1x1,0nz],out_A_vr[1x1,0nz],out_A_rv[1x1,0nz],out_A_rr[1x1,0nz],fwd_m,fwd_Izz,fwd_a,fwd_b,fwd_u,fwd_rho,fwd_Ap,fwd_CL_gamma,fwd_C_alpha,fwd_Ct)->(fwd_A_vv,fwd_A_vr,fwd_A_rv,fwd_A_rr) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17;
a00=arg[22]? arg[22][0] : 0;
a00=2.*a00;
a01=arg[23]? arg[23][0] : 0;
a02=arg[4]? arg[4][0] : 0;
a03=casadi_sq(a02);
a04=arg[5]? arg[5][0] : 0;
a05=arg[7]? arg[7][0] : 0;
a06=5.0000000000000000e-01;
a07=arg[20]? arg[20][0] : 0;
a07=a06*a07;
a07=a05*a07;
a08=arg[6]? arg[6][0] : 0;
a06=a06*a08;
a08=arg[21]? arg[21][0] : 0;
a08=a06*a08;
a07=a07+a08;
a07=a04*a07;
a06=a06*a05;
a05=arg[19]? arg[19][0] : 0;
a05=a06*a05;
a07=a07+a05;
a07=a03*a07;
a06=a06*a04;
a04=2.*a02;
a05=arg[18]? arg[18][0] : 0;
a04=a04*a05;
a04=a06*a04;
a07=a07+a04;
a01=a01+a07;
a07=a00+a01;
a04=arg[0]? arg[0][0] : 0;
a08=a04*a02;
a07=a07/a08;
a09=arg[8]? arg[8][0] : 0;
a09=2.*a09;
a10=arg[9]? arg[9][0] : 0;
a06=a06*a03;
a10=a10+a06;
a06=a09+a10;
a06=a06/a08;
a06=a06/a08;
a03=arg[14]? arg[14][0] : 0;
a11=a02*a03;
a12=a04*a05;
a11=a11+a12;
a06=a06*a11;
a07=a07-a06;
a07=-a07;
if (res[0]!=0) res[0][0]=a07;
a07=casadi_sq(a02);
a03=a07*a03;
a06=2.*a02;
a06=a06*a05;
a06=a04*a06;
a03=a03+a06;
a06=arg[2]? arg[2][0] : 0;
a12=a06*a00;
a13=arg[16]? arg[16][0] : 0;
a14=a09*a13;
a12=a12+a14;
a14=arg[3]? arg[3][0] : 0;
a15=a14*a01;
a16=arg[17]? arg[17][0] : 0;
a17=a10*a16;
a15=a15+a17;
a12=a12-a15;
a03=a03+a12;
a03=a03/a08;
a04=a04*a07;
a07=a09*a06;
a15=a10*a14;
a07=a07-a15;
a04=a04+a07;
a04=a04/a08;
a04=a04/a08;
a04=a04*a11;
a03=a03-a04;
a03=-a03;
if (res[1]!=0) res[1][0]=a03;
a03=arg[1]? arg[1][0] : 0;
a04=a03*a02;
a12=a12/a04;
a07=a07/a04;
a07=a07/a04;
a11=arg[15]? arg[15][0] : 0;
a02=a02*a11;
a03=a03*a05;
a02=a02+a03;
a07=a07*a02;
a12=a12-a07;
a12=-a12;
if (res[2]!=0) res[2][0]=a12;
a12=casadi_sq(a06);
a00=a12*a00;
a06=2.*a06;
a06=a06*a13;
a06=a09*a06;
a00=a00+a06;
a06=casadi_sq(a14);
a01=a06*a01;
a14=2.*a14;
a14=a14*a16;
a14=a10*a14;
a01=a01+a14;
a00=a00+a01;
a00=a00/a04;
a09=a09*a12;
a10=a10*a06;
a09=a09+a10;
a09=a09/a04;
a09=a09/a04;
a09=a09*a02;
a00=a00-a09;
a00=-a00;
if (res[3]!=0) res[3][0]=a00;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_state_matrix(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f1(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_state_matrix_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_state_matrix_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_state_matrix_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_state_matrix_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_state_matrix_n_in(void) { return 24;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_state_matrix_n_out(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_state_matrix_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_state_matrix_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "Izz";
case 2: return "a";
case 3: return "b";
case 4: return "u";
case 5: return "rho";
case 6: return "Ap";
case 7: return "CL_gamma";
case 8: return "C_alpha";
case 9: return "Ct";
case 10: return "out_A_vv";
case 11: return "out_A_vr";
case 12: return "out_A_rv";
case 13: return "out_A_rr";
case 14: return "fwd_m";
case 15: return "fwd_Izz";
case 16: return "fwd_a";
case 17: return "fwd_b";
case 18: return "fwd_u";
case 19: return "fwd_rho";
case 20: return "fwd_Ap";
case 21: return "fwd_CL_gamma";
case 22: return "fwd_C_alpha";
case 23: return "fwd_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_state_matrix_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_A_vv";
case 1: return "fwd_A_vr";
case 2: return "fwd_A_rv";
case 3: return "fwd_A_rr";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_state_matrix_sparsity_in(casadi_int i) {
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
case 10: return casadi_s1;
case 11: return casadi_s1;
case 12: return casadi_s1;
case 13: return casadi_s1;
case 14: return casadi_s0;
case 15: return casadi_s0;
case 16: return casadi_s0;
case 17: return casadi_s0;
case 18: return casadi_s0;
case 19: return casadi_s0;
case 20: return casadi_s0;
case 21: return casadi_s0;
case 22: return casadi_s0;
case 23: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_state_matrix_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_state_matrix_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 24;
if (sz_res) *sz_res = 4;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_state_matrix_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 24*sizeof(const casadi_real*);
if (sz_res) *sz_res = 4*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_state_matrix:(m,Izz,a,b,u,rho,Ap,CL_gamma,C_alpha,Ct,out_A_vv[1x1,0nz],out_A_vr[1x1,0nz],out_A_rv[1x1,0nz],out_A_rr[1x1,0nz],adj_A_vv,adj_A_vr,adj_A_rv,adj_A_rr)->(adj_m,adj_Izz,adj_a,adj_b,adj_u,adj_rho,adj_Ap,adj_CL_gamma,adj_C_alpha,adj_Ct) */
static int casadi_f2(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25;
a00=arg[4]? arg[4][0] : 0;
a01=arg[0]? arg[0][0] : 0;
a02=casadi_sq(a00);
a03=a01*a02;
a04=arg[8]? arg[8][0] : 0;
a04=2.*a04;
a05=arg[2]? arg[2][0] : 0;
a06=a04*a05;
a07=arg[9]? arg[9][0] : 0;
a08=5.0000000000000000e-01;
a09=arg[6]? arg[6][0] : 0;
a09=a08*a09;
a10=arg[7]? arg[7][0] : 0;
a11=a09*a10;
a12=arg[5]? arg[5][0] : 0;
a13=a11*a12;
a14=casadi_sq(a00);
a15=a13*a14;
a07=a07+a15;
a15=arg[3]? arg[3][0] : 0;
a16=a07*a15;
a06=a06-a16;
a03=a03+a06;
a16=a01*a00;
a03=a03/a16;
a03=a03/a16;
a17=arg[15]? arg[15][0] : 0;
a03=a03*a17;
a18=a04+a07;
a18=a18/a16;
a18=a18/a16;
a19=arg[14]? arg[14][0] : 0;
a18=a18*a19;
a03=a03+a18;
a18=a00*a03;
a17=a17/a16;
a02=a02*a17;
a18=a18-a02;
if (res[0]!=0) res[0][0]=a18;
a18=casadi_sq(a05);
a02=a04*a18;
a20=casadi_sq(a15);
a21=a07*a20;
a02=a02+a21;
a21=arg[1]? arg[1][0] : 0;
a22=a21*a00;
a02=a02/a22;
a02=a02/a22;
a23=arg[17]? arg[17][0] : 0;
a02=a02*a23;
a06=a06/a22;
a06=a06/a22;
a24=arg[16]? arg[16][0] : 0;
a06=a06*a24;
a02=a02+a06;
a06=a00*a02;
if (res[1]!=0) res[1][0]=a06;
a06=2.*a05;
a23=a23/a22;
a25=a04*a23;
a06=a06*a25;
a24=a24/a22;
a24=a24+a17;
a04=a04*a24;
a06=a06+a04;
a06=-a06;
if (res[2]!=0) res[2][0]=a06;
a06=a07*a24;
a04=2.*a15;
a07=a07*a23;
a04=a04*a07;
a06=a06-a04;
if (res[3]!=0) res[3][0]=a06;
a21=a21*a02;
a02=2.*a00;
a17=a01*a17;
a02=a02*a17;
a21=a21-a02;
a01=a01*a03;
a21=a21+a01;
a00=2.*a00;
a15=a15*a24;
a20=a20*a23;
a15=a15-a20;
a19=a19/a16;
a15=a15-a19;
a13=a13*a15;
a00=a00*a13;
a21=a21+a00;
if (res[4]!=0) res[4][0]=a21;
a14=a14*a15;
a11=a11*a14;
if (res[5]!=0) res[5][0]=a11;
a12=a12*a14;
a10=a10*a12;
a08=a08*a10;
if (res[6]!=0) res[6][0]=a08;
a09=a09*a12;
if (res[7]!=0) res[7][0]=a09;
a18=a18*a23;
a05=a05*a24;
a18=a18+a05;
a18=a18+a19;
a18=-a18;
a18=2.*a18;
if (res[8]!=0) res[8][0]=a18;
if (res[9]!=0) res[9][0]=a15;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_state_matrix(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f2(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_state_matrix_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_state_matrix_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_state_matrix_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_state_matrix_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_state_matrix_n_in(void) { return 18;}
CASADI_SYMBOL_EXPORT casadi_int adj1_state_matrix_n_out(void) { return 10;}
CASADI_SYMBOL_EXPORT casadi_real adj1_state_matrix_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_state_matrix_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "Izz";
case 2: return "a";
case 3: return "b";
case 4: return "u";
case 5: return "rho";
case 6: return "Ap";
case 7: return "CL_gamma";
case 8: return "C_alpha";
case 9: return "Ct";
case 10: return "out_A_vv";
case 11: return "out_A_vr";
case 12: return "out_A_rv";
case 13: return "out_A_rr";
case 14: return "adj_A_vv";
case 15: return "adj_A_vr";
case 16: return "adj_A_rv";
case 17: return "adj_A_rr";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_state_matrix_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_m";
case 1: return "adj_Izz";
case 2: return "adj_a";
case 3: return "adj_b";
case 4: return "adj_u";
case 5: return "adj_rho";
case 6: return "adj_Ap";
case 7: return "adj_CL_gamma";
case 8: return "adj_C_alpha";
case 9: return "adj_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_state_matrix_sparsity_in(casadi_int i) {
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
case 10: return casadi_s1;
case 11: return casadi_s1;
case 12: return casadi_s1;
case 13: return casadi_s1;
case 14: return casadi_s0;
case 15: return casadi_s0;
case 16: return casadi_s0;
case 17: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_state_matrix_sparsity_out(casadi_int i) {
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
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_state_matrix_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 18;
if (sz_res) *sz_res = 10;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_state_matrix_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 18*sizeof(const casadi_real*);
if (sz_res) *sz_res = 10*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_state_matrix:(m,Izz,a,b,u,rho,Ap,CL_gamma,C_alpha,Ct,out_A_vv[1x1,0nz],out_A_vr[1x1,0nz],out_A_rv[1x1,0nz],out_A_rr[1x1,0nz],adj_A_vv,adj_A_vr,adj_A_rv,adj_A_rr,out_adj_m[1x1,0nz],out_adj_Izz[1x1,0nz],out_adj_a[1x1,0nz],out_adj_b[1x1,0nz],out_adj_u[1x1,0nz],out_adj_rho[1x1,0nz],out_adj_Ap[1x1,0nz],out_adj_CL_gamma[1x1,0nz],out_adj_C_alpha[1x1,0nz],out_adj_Ct[1x1,0nz],fwd_m,fwd_Izz,fwd_a,fwd_b,fwd_u,fwd_rho,fwd_Ap,fwd_CL_gamma,fwd_C_alpha,fwd_Ct,fwd_out_A_vv[1x1,0nz],fwd_out_A_vr[1x1,0nz],fwd_out_A_rv[1x1,0nz],fwd_out_A_rr[1x1,0nz],fwd_adj_A_vv,fwd_adj_A_vr,fwd_adj_A_rv,fwd_adj_A_rr)->(fwd_adj_m,fwd_adj_Izz,fwd_adj_a,fwd_adj_b,fwd_adj_u,fwd_adj_rho,fwd_adj_Ap,fwd_adj_CL_gamma,fwd_adj_C_alpha,fwd_adj_Ct) */
static int casadi_f3(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
casadi_real a48, a49, a50, a51;
a00=arg[0]? arg[0][0] : 0;
a01=arg[4]? arg[4][0] : 0;
a02=casadi_sq(a01);
a03=a00*a02;
a04=arg[8]? arg[8][0] : 0;
a04=2.*a04;
a05=arg[2]? arg[2][0] : 0;
a06=a04*a05;
a07=arg[9]? arg[9][0] : 0;
a08=5.0000000000000000e-01;
a09=arg[6]? arg[6][0] : 0;
a09=a08*a09;
a10=arg[7]? arg[7][0] : 0;
a11=a09*a10;
a12=arg[5]? arg[5][0] : 0;
a13=a11*a12;
a14=casadi_sq(a01);
a15=a13*a14;
a07=a07+a15;
a15=arg[3]? arg[3][0] : 0;
a16=a07*a15;
a06=a06-a16;
a03=a03+a06;
a16=a00*a01;
a03=a03/a16;
a17=a03/a16;
a18=arg[15]? arg[15][0] : 0;
a19=a17*a18;
a20=a04+a07;
a20=a20/a16;
a21=a20/a16;
a22=arg[14]? arg[14][0] : 0;
a23=a21*a22;
a19=a19+a23;
a23=arg[32]? arg[32][0] : 0;
a24=a19*a23;
a25=arg[28]? arg[28][0] : 0;
a26=a02*a25;
a27=2.*a01;
a27=a27*a23;
a28=a00*a27;
a26=a26+a28;
a28=arg[36]? arg[36][0] : 0;
a28=2.*a28;
a29=a05*a28;
a30=arg[30]? arg[30][0] : 0;
a31=a04*a30;
a29=a29+a31;
a31=arg[37]? arg[37][0] : 0;
a32=arg[34]? arg[34][0] : 0;
a32=a08*a32;
a33=a10*a32;
a34=arg[35]? arg[35][0] : 0;
a35=a09*a34;
a33=a33+a35;
a35=a12*a33;
a36=arg[33]? arg[33][0] : 0;
a37=a11*a36;
a35=a35+a37;
a37=a14*a35;
a38=2.*a01;
a38=a38*a23;
a39=a13*a38;
a37=a37+a39;
a31=a31+a37;
a37=a15*a31;
a39=arg[31]? arg[31][0] : 0;
a40=a07*a39;
a37=a37+a40;
a29=a29-a37;
a26=a26+a29;
a26=a26/a16;
a03=a03/a16;
a37=a01*a25;
a40=a00*a23;
a37=a37+a40;
a03=a03*a37;
a26=a26-a03;
a26=a26/a16;
a03=a17/a16;
a03=a03*a37;
a26=a26-a03;
a26=a18*a26;
a03=arg[43]? arg[43][0] : 0;
a17=a17*a03;
a26=a26+a17;
a17=a28+a31;
a17=a17/a16;
a20=a20/a16;
a20=a20*a37;
a17=a17-a20;
a17=a17/a16;
a20=a21/a16;
a20=a20*a37;
a17=a17-a20;
a17=a22*a17;
a20=arg[42]? arg[42][0] : 0;
a21=a21*a20;
a17=a17+a21;
a26=a26+a17;
a17=a01*a26;
a24=a24+a17;
a18=a18/a16;
a27=a18*a27;
a03=a03/a16;
a17=a18/a16;
a17=a17*a37;
a03=a03-a17;
a02=a02*a03;
a27=a27+a02;
a24=a24-a27;
if (res[0]!=0) res[0][0]=a24;
a24=casadi_sq(a05);
a27=a04*a24;
a02=casadi_sq(a15);
a17=a07*a02;
a27=a27+a17;
a17=arg[1]? arg[1][0] : 0;
a21=a17*a01;
a27=a27/a21;
a40=a27/a21;
a41=arg[17]? arg[17][0] : 0;
a42=a40*a41;
a06=a06/a21;
a43=a06/a21;
a44=arg[16]? arg[16][0] : 0;
a45=a43*a44;
a42=a42+a45;
a45=a42*a23;
a46=a24*a28;
a47=2.*a05;
a47=a47*a30;
a48=a04*a47;
a46=a46+a48;
a48=a02*a31;
a49=2.*a15;
a49=a49*a39;
a50=a07*a49;
a48=a48+a50;
a46=a46+a48;
a46=a46/a21;
a27=a27/a21;
a48=arg[29]? arg[29][0] : 0;
a50=a01*a48;
a51=a17*a23;
a50=a50+a51;
a27=a27*a50;
a46=a46-a27;
a46=a46/a21;
a27=a40/a21;
a27=a27*a50;
a46=a46-a27;
a46=a41*a46;
a27=arg[45]? arg[45][0] : 0;
a40=a40*a27;
a46=a46+a40;
a29=a29/a21;
a06=a06/a21;
a06=a06*a50;
a29=a29-a06;
a29=a29/a21;
a06=a43/a21;
a06=a06*a50;
a29=a29-a06;
a29=a44*a29;
a06=arg[44]? arg[44][0] : 0;
a43=a43*a06;
a29=a29+a43;
a46=a46+a29;
a29=a01*a46;
a45=a45+a29;
if (res[1]!=0) res[1][0]=a45;
a41=a41/a21;
a45=a04*a41;
a29=2.*a30;
a45=a45*a29;
a29=2.*a05;
a43=a41*a28;
a27=a27/a21;
a40=a41/a21;
a40=a40*a50;
a27=a27-a40;
a40=a04*a27;
a43=a43+a40;
a29=a29*a43;
a45=a45+a29;
a44=a44/a21;
a29=a44+a18;
a28=a29*a28;
a06=a06/a21;
a44=a44/a21;
a44=a44*a50;
a06=a06-a44;
a06=a06+a03;
a04=a04*a06;
a28=a28+a04;
a45=a45+a28;
a45=-a45;
if (res[2]!=0) res[2][0]=a45;
a45=a29*a31;
a28=a07*a06;
a45=a45+a28;
a28=a07*a41;
a04=2.*a39;
a28=a28*a04;
a04=2.*a15;
a31=a41*a31;
a07=a07*a27;
a31=a31+a07;
a04=a04*a31;
a28=a28+a04;
a45=a45-a28;
if (res[3]!=0) res[3][0]=a45;
a42=a42*a48;
a17=a17*a46;
a42=a42+a17;
a17=a00*a18;
a46=2.*a23;
a17=a17*a46;
a46=2.*a01;
a18=a18*a25;
a03=a00*a03;
a18=a18+a03;
a46=a46*a18;
a17=a17+a46;
a42=a42-a17;
a19=a19*a25;
a00=a00*a26;
a19=a19+a00;
a42=a42+a19;
a19=a15*a29;
a00=a02*a41;
a19=a19-a00;
a22=a22/a16;
a19=a19-a22;
a00=a13*a19;
a23=2.*a23;
a00=a00*a23;
a01=2.*a01;
a35=a19*a35;
a39=a29*a39;
a15=a15*a06;
a39=a39+a15;
a49=a41*a49;
a02=a02*a27;
a49=a49+a02;
a39=a39-a49;
a20=a20/a16;
a22=a22/a16;
a22=a22*a37;
a20=a20-a22;
a39=a39-a20;
a13=a13*a39;
a35=a35+a13;
a01=a01*a35;
a00=a00+a01;
a42=a42+a00;
if (res[4]!=0) res[4][0]=a42;
a42=a14*a19;
a33=a42*a33;
a19=a19*a38;
a14=a14*a39;
a19=a19+a14;
a11=a11*a19;
a33=a33+a11;
if (res[5]!=0) res[5][0]=a33;
a33=a12*a42;
a34=a33*a34;
a42=a42*a36;
a12=a12*a19;
a42=a42+a12;
a10=a10*a42;
a34=a34+a10;
a08=a08*a34;
if (res[6]!=0) res[6][0]=a08;
a33=a33*a32;
a09=a09*a42;
a33=a33+a09;
if (res[7]!=0) res[7][0]=a33;
a41=a41*a47;
a24=a24*a27;
a41=a41+a24;
a29=a29*a30;
a05=a05*a06;
a29=a29+a05;
a41=a41+a29;
a41=a41+a20;
a41=-a41;
a41=2.*a41;
if (res[8]!=0) res[8][0]=a41;
if (res[9]!=0) res[9][0]=a39;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_state_matrix(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f3(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_state_matrix_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_state_matrix_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_state_matrix_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_state_matrix_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_state_matrix_n_in(void) { return 46;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_state_matrix_n_out(void) { return 10;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_state_matrix_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_state_matrix_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "Izz";
case 2: return "a";
case 3: return "b";
case 4: return "u";
case 5: return "rho";
case 6: return "Ap";
case 7: return "CL_gamma";
case 8: return "C_alpha";
case 9: return "Ct";
case 10: return "out_A_vv";
case 11: return "out_A_vr";
case 12: return "out_A_rv";
case 13: return "out_A_rr";
case 14: return "adj_A_vv";
case 15: return "adj_A_vr";
case 16: return "adj_A_rv";
case 17: return "adj_A_rr";
case 18: return "out_adj_m";
case 19: return "out_adj_Izz";
case 20: return "out_adj_a";
case 21: return "out_adj_b";
case 22: return "out_adj_u";
case 23: return "out_adj_rho";
case 24: return "out_adj_Ap";
case 25: return "out_adj_CL_gamma";
case 26: return "out_adj_C_alpha";
case 27: return "out_adj_Ct";
case 28: return "fwd_m";
case 29: return "fwd_Izz";
case 30: return "fwd_a";
case 31: return "fwd_b";
case 32: return "fwd_u";
case 33: return "fwd_rho";
case 34: return "fwd_Ap";
case 35: return "fwd_CL_gamma";
case 36: return "fwd_C_alpha";
case 37: return "fwd_Ct";
case 38: return "fwd_out_A_vv";
case 39: return "fwd_out_A_vr";
case 40: return "fwd_out_A_rv";
case 41: return "fwd_out_A_rr";
case 42: return "fwd_adj_A_vv";
case 43: return "fwd_adj_A_vr";
case 44: return "fwd_adj_A_rv";
case 45: return "fwd_adj_A_rr";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_state_matrix_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_m";
case 1: return "fwd_adj_Izz";
case 2: return "fwd_adj_a";
case 3: return "fwd_adj_b";
case 4: return "fwd_adj_u";
case 5: return "fwd_adj_rho";
case 6: return "fwd_adj_Ap";
case 7: return "fwd_adj_CL_gamma";
case 8: return "fwd_adj_C_alpha";
case 9: return "fwd_adj_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_state_matrix_sparsity_in(casadi_int i) {
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
case 10: return casadi_s1;
case 11: return casadi_s1;
case 12: return casadi_s1;
case 13: return casadi_s1;
case 14: return casadi_s0;
case 15: return casadi_s0;
case 16: return casadi_s0;
case 17: return casadi_s0;
case 18: return casadi_s1;
case 19: return casadi_s1;
case 20: return casadi_s1;
case 21: return casadi_s1;
case 22: return casadi_s1;
case 23: return casadi_s1;
case 24: return casadi_s1;
case 25: return casadi_s1;
case 26: return casadi_s1;
case 27: return casadi_s1;
case 28: return casadi_s0;
case 29: return casadi_s0;
case 30: return casadi_s0;
case 31: return casadi_s0;
case 32: return casadi_s0;
case 33: return casadi_s0;
case 34: return casadi_s0;
case 35: return casadi_s0;
case 36: return casadi_s0;
case 37: return casadi_s0;
case 38: return casadi_s1;
case 39: return casadi_s1;
case 40: return casadi_s1;
case 41: return casadi_s1;
case 42: return casadi_s0;
case 43: return casadi_s0;
case 44: return casadi_s0;
case 45: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_state_matrix_sparsity_out(casadi_int i) {
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
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_state_matrix_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 46;
if (sz_res) *sz_res = 10;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_state_matrix_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 46*sizeof(const casadi_real*);
if (sz_res) *sz_res = 10*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* routh_hurwitz:(m,Izz,a,b,u,rho,Ap,CL_gamma,C_alpha,Ct)->(trace,det,discriminant) */
static int casadi_f4(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10;
a00=arg[8]? arg[8][0] : 0;
a00=2.*a00;
a01=arg[2]? arg[2][0] : 0;
a02=casadi_sq(a01);
a03=arg[1]? arg[1][0] : 0;
a04=arg[4]? arg[4][0] : 0;
a05=a03*a04;
a02=a02/a05;
a06=arg[0]? arg[0][0] : 0;
a07=a06*a04;
a07=1./a07;
a02=a02+a07;
a02=a00*a02;
a08=arg[9]? arg[9][0] : 0;
a09=5.0000000000000000e-01;
a10=arg[6]? arg[6][0] : 0;
a09=a09*a10;
a10=arg[7]? arg[7][0] : 0;
a09=a09*a10;
a10=arg[5]? arg[5][0] : 0;
a09=a09*a10;
a10=casadi_sq(a04);
a09=a09*a10;
a08=a08+a09;
a09=arg[3]? arg[3][0] : 0;
a10=casadi_sq(a09);
a10=a10/a05;
a10=a10+a07;
a10=a08*a10;
a02=a02+a10;
a10=-a02;
if (res[0]!=0) res[0][0]=a10;
a10=a00*a08;
a07=a01+a09;
a07=casadi_sq(a07);
a10=a10*a07;
a06=a03*a06;
a04=casadi_sq(a04);
a06=a06*a04;
a10=a10/a06;
a00=a00*a01;
a00=a00/a03;
a10=a10-a00;
a08=a08*a09;
a08=a08/a03;
a10=a10+a08;
if (res[1]!=0) res[1][0]=a10;
a08=-4.;
a08=a08*a10;
a02=casadi_sq(a02);
a08=a08+a02;
if (res[2]!=0) res[2][0]=a08;
return 0;
}
CASADI_SYMBOL_EXPORT int routh_hurwitz(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f4(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int routh_hurwitz_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void routh_hurwitz_release(int mem) {
}
CASADI_SYMBOL_EXPORT void routh_hurwitz_incref(void) {
}
CASADI_SYMBOL_EXPORT void routh_hurwitz_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int routh_hurwitz_n_in(void) { return 10;}
CASADI_SYMBOL_EXPORT casadi_int routh_hurwitz_n_out(void) { return 3;}
CASADI_SYMBOL_EXPORT casadi_real routh_hurwitz_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* routh_hurwitz_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "Izz";
case 2: return "a";
case 3: return "b";
case 4: return "u";
case 5: return "rho";
case 6: return "Ap";
case 7: return "CL_gamma";
case 8: return "C_alpha";
case 9: return "Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* routh_hurwitz_name_out(casadi_int i) {
switch (i) {
case 0: return "trace";
case 1: return "det";
case 2: return "discriminant";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* routh_hurwitz_sparsity_in(casadi_int i) {
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
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* routh_hurwitz_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int routh_hurwitz_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 10;
if (sz_res) *sz_res = 3;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int routh_hurwitz_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
if (sz_res) *sz_res = 3*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_routh_hurwitz:(m,Izz,a,b,u,rho,Ap,CL_gamma,C_alpha,Ct,out_trace[1x1,0nz],out_det[1x1,0nz],out_discriminant[1x1,0nz],fwd_m,fwd_Izz,fwd_a,fwd_b,fwd_u,fwd_rho,fwd_Ap,fwd_CL_gamma,fwd_C_alpha,fwd_Ct)->(fwd_trace,fwd_det,fwd_discriminant) */
static int casadi_f5(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24;
a00=arg[2]? arg[2][0] : 0;
a01=casadi_sq(a00);
a02=arg[1]? arg[1][0] : 0;
a03=arg[4]? arg[4][0] : 0;
a04=a02*a03;
a01=a01/a04;
a05=arg[0]? arg[0][0] : 0;
a06=a05*a03;
a07=1./a06;
a08=a01+a07;
a09=arg[21]? arg[21][0] : 0;
a09=2.*a09;
a10=a08*a09;
a11=arg[8]? arg[8][0] : 0;
a11=2.*a11;
a12=2.*a00;
a13=arg[15]? arg[15][0] : 0;
a12=a12*a13;
a12=a12/a04;
a01=a01/a04;
a14=arg[14]? arg[14][0] : 0;
a15=a03*a14;
a16=arg[17]? arg[17][0] : 0;
a17=a02*a16;
a15=a15+a17;
a01=a01*a15;
a12=a12-a01;
a06=a07/a06;
a01=arg[13]? arg[13][0] : 0;
a17=a03*a01;
a18=a05*a16;
a17=a17+a18;
a06=a06*a17;
a12=a12-a06;
a12=a11*a12;
a10=a10+a12;
a12=arg[3]? arg[3][0] : 0;
a17=casadi_sq(a12);
a17=a17/a04;
a07=a17+a07;
a18=arg[22]? arg[22][0] : 0;
a19=casadi_sq(a03);
a20=arg[5]? arg[5][0] : 0;
a21=arg[7]? arg[7][0] : 0;
a22=5.0000000000000000e-01;
a23=arg[19]? arg[19][0] : 0;
a23=a22*a23;
a23=a21*a23;
a24=arg[6]? arg[6][0] : 0;
a22=a22*a24;
a24=arg[20]? arg[20][0] : 0;
a24=a22*a24;
a23=a23+a24;
a23=a20*a23;
a22=a22*a21;
a21=arg[18]? arg[18][0] : 0;
a21=a22*a21;
a23=a23+a21;
a23=a19*a23;
a22=a22*a20;
a20=2.*a03;
a20=a20*a16;
a20=a22*a20;
a23=a23+a20;
a18=a18+a23;
a23=a07*a18;
a20=arg[9]? arg[9][0] : 0;
a22=a22*a19;
a20=a20+a22;
a22=2.*a12;
a19=arg[16]? arg[16][0] : 0;
a22=a22*a19;
a22=a22/a04;
a17=a17/a04;
a17=a17*a15;
a22=a22-a17;
a22=a22-a06;
a22=a20*a22;
a23=a23+a22;
a10=a10+a23;
a23=-a10;
if (res[0]!=0) res[0][0]=a23;
a23=a00+a12;
a22=casadi_sq(a23);
a06=a20*a09;
a17=a11*a18;
a06=a06+a17;
a06=a22*a06;
a17=a11*a20;
a23=2.*a23;
a15=a13+a19;
a23=a23*a15;
a23=a17*a23;
a06=a06+a23;
a23=a02*a05;
a15=casadi_sq(a03);
a04=a23*a15;
a06=a06/a04;
a17=a17*a22;
a17=a17/a04;
a17=a17/a04;
a05=a05*a14;
a01=a02*a01;
a05=a05+a01;
a15=a15*a05;
a03=2.*a03;
a03=a03*a16;
a23=a23*a03;
a15=a15+a23;
a17=a17*a15;
a06=a06-a17;
a09=a00*a09;
a13=a11*a13;
a09=a09+a13;
a09=a09/a02;
a00=a11*a00;
a00=a00/a02;
a00=a00/a02;
a00=a00*a14;
a09=a09-a00;
a06=a06-a09;
a18=a12*a18;
a19=a20*a19;
a18=a18+a19;
a18=a18/a02;
a12=a20*a12;
a12=a12/a02;
a12=a12/a02;
a12=a12*a14;
a18=a18-a12;
a06=a06+a18;
if (res[1]!=0) res[1][0]=a06;
a18=-4.;
a18=a18*a06;
a11=a11*a08;
a20=a20*a07;
a11=a11+a20;
a11=2.*a11;
a11=a11*a10;
a18=a18+a11;
if (res[2]!=0) res[2][0]=a18;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_routh_hurwitz(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f5(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_routh_hurwitz_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_routh_hurwitz_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_routh_hurwitz_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_routh_hurwitz_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_routh_hurwitz_n_in(void) { return 23;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_routh_hurwitz_n_out(void) { return 3;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_routh_hurwitz_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_routh_hurwitz_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "Izz";
case 2: return "a";
case 3: return "b";
case 4: return "u";
case 5: return "rho";
case 6: return "Ap";
case 7: return "CL_gamma";
case 8: return "C_alpha";
case 9: return "Ct";
case 10: return "out_trace";
case 11: return "out_det";
case 12: return "out_discriminant";
case 13: return "fwd_m";
case 14: return "fwd_Izz";
case 15: return "fwd_a";
case 16: return "fwd_b";
case 17: return "fwd_u";
case 18: return "fwd_rho";
case 19: return "fwd_Ap";
case 20: return "fwd_CL_gamma";
case 21: return "fwd_C_alpha";
case 22: return "fwd_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_routh_hurwitz_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_trace";
case 1: return "fwd_det";
case 2: return "fwd_discriminant";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_routh_hurwitz_sparsity_in(casadi_int i) {
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
case 10: return casadi_s1;
case 11: return casadi_s1;
case 12: return casadi_s1;
case 13: return casadi_s0;
case 14: return casadi_s0;
case 15: return casadi_s0;
case 16: return casadi_s0;
case 17: return casadi_s0;
case 18: return casadi_s0;
case 19: return casadi_s0;
case 20: return casadi_s0;
case 21: return casadi_s0;
case 22: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_routh_hurwitz_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_routh_hurwitz_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 23;
if (sz_res) *sz_res = 3;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_routh_hurwitz_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 23*sizeof(const casadi_real*);
if (sz_res) *sz_res = 3*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_routh_hurwitz:(m,Izz,a,b,u,rho,Ap,CL_gamma,C_alpha,Ct,out_trace[1x1,0nz],out_det[1x1,0nz],out_discriminant[1x1,0nz],adj_trace,adj_det,adj_discriminant)->(adj_m,adj_Izz,adj_a,adj_b,adj_u,adj_rho,adj_Ap,adj_CL_gamma,adj_C_alpha,adj_Ct) */
static int casadi_f6(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32;
a00=arg[1]? arg[1][0] : 0;
a01=arg[4]? arg[4][0] : 0;
a02=casadi_sq(a01);
a03=arg[8]? arg[8][0] : 0;
a03=2.*a03;
a04=arg[9]? arg[9][0] : 0;
a05=5.0000000000000000e-01;
a06=arg[6]? arg[6][0] : 0;
a06=a05*a06;
a07=arg[7]? arg[7][0] : 0;
a08=a06*a07;
a09=arg[5]? arg[5][0] : 0;
a10=a08*a09;
a11=casadi_sq(a01);
a12=a10*a11;
a04=a04+a12;
a12=a03*a04;
a13=arg[2]? arg[2][0] : 0;
a14=arg[3]? arg[3][0] : 0;
a15=a13+a14;
a16=casadi_sq(a15);
a17=a12*a16;
a18=arg[0]? arg[0][0] : 0;
a19=a00*a18;
a20=a19*a02;
a17=a17/a20;
a17=a17/a20;
a21=-4.;
a22=arg[15]? arg[15][0] : 0;
a21=a21*a22;
a23=arg[14]? arg[14][0] : 0;
a21=a21+a23;
a17=a17*a21;
a02=a02*a17;
a23=a00*a02;
a24=a18*a01;
a25=1./a24;
a24=a25/a24;
a26=casadi_sq(a13);
a27=a00*a01;
a26=a26/a27;
a28=a26+a25;
a29=a03*a28;
a30=casadi_sq(a14);
a30=a30/a27;
a25=a30+a25;
a31=a04*a25;
a29=a29+a31;
a29=2.*a29;
a29=a29*a22;
a22=arg[13]? arg[13][0] : 0;
a29=a29-a22;
a22=a04*a29;
a31=a03*a29;
a32=a22+a31;
a24=a24*a32;
a32=a01*a24;
a23=a23+a32;
a23=-a23;
if (res[0]!=0) res[0][0]=a23;
a23=a03*a13;
a23=a23/a00;
a23=a23/a00;
a23=a23*a21;
a32=a04*a14;
a32=a32/a00;
a32=a32/a00;
a32=a32*a21;
a23=a23-a32;
a02=a18*a02;
a23=a23-a02;
a30=a30/a27;
a30=a30*a22;
a26=a26/a27;
a26=a26*a31;
a30=a30+a26;
a26=a01*a30;
a23=a23-a26;
if (res[1]!=0) res[1][0]=a23;
a15=2.*a15;
a20=a21/a20;
a12=a12*a20;
a15=a15*a12;
a12=a21/a00;
a23=a03*a12;
a23=a15-a23;
a26=2.*a13;
a31=a31/a27;
a26=a26*a31;
a23=a23+a26;
if (res[2]!=0) res[2][0]=a23;
a21=a21/a00;
a23=a04*a21;
a23=a23+a15;
a15=2.*a14;
a22=a22/a27;
a15=a15*a22;
a23=a23+a15;
if (res[3]!=0) res[3][0]=a23;
a23=2.*a01;
a14=a14*a21;
a16=a16*a20;
a03=a03*a16;
a14=a14+a03;
a25=a25*a29;
a14=a14+a25;
a10=a10*a14;
a23=a23*a10;
a01=2.*a01;
a19=a19*a17;
a01=a01*a19;
a23=a23-a01;
a18=a18*a24;
a23=a23-a18;
a00=a00*a30;
a23=a23-a00;
if (res[4]!=0) res[4][0]=a23;
a11=a11*a14;
a08=a08*a11;
if (res[5]!=0) res[5][0]=a08;
a09=a09*a11;
a07=a07*a09;
a05=a05*a07;
if (res[6]!=0) res[6][0]=a05;
a06=a06*a09;
if (res[7]!=0) res[7][0]=a06;
a04=a04*a16;
a13=a13*a12;
a04=a04-a13;
a28=a28*a29;
a04=a04+a28;
a04=2.*a04;
if (res[8]!=0) res[8][0]=a04;
if (res[9]!=0) res[9][0]=a14;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_routh_hurwitz(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f6(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_routh_hurwitz_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_routh_hurwitz_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_routh_hurwitz_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_routh_hurwitz_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_routh_hurwitz_n_in(void) { return 16;}
CASADI_SYMBOL_EXPORT casadi_int adj1_routh_hurwitz_n_out(void) { return 10;}
CASADI_SYMBOL_EXPORT casadi_real adj1_routh_hurwitz_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_routh_hurwitz_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "Izz";
case 2: return "a";
case 3: return "b";
case 4: return "u";
case 5: return "rho";
case 6: return "Ap";
case 7: return "CL_gamma";
case 8: return "C_alpha";
case 9: return "Ct";
case 10: return "out_trace";
case 11: return "out_det";
case 12: return "out_discriminant";
case 13: return "adj_trace";
case 14: return "adj_det";
case 15: return "adj_discriminant";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_routh_hurwitz_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_m";
case 1: return "adj_Izz";
case 2: return "adj_a";
case 3: return "adj_b";
case 4: return "adj_u";
case 5: return "adj_rho";
case 6: return "adj_Ap";
case 7: return "adj_CL_gamma";
case 8: return "adj_C_alpha";
case 9: return "adj_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_routh_hurwitz_sparsity_in(casadi_int i) {
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
case 10: return casadi_s1;
case 11: return casadi_s1;
case 12: return casadi_s1;
case 13: return casadi_s0;
case 14: return casadi_s0;
case 15: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_routh_hurwitz_sparsity_out(casadi_int i) {
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
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_routh_hurwitz_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 16;
if (sz_res) *sz_res = 10;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_routh_hurwitz_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
if (sz_res) *sz_res = 10*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_routh_hurwitz:(m,Izz,a,b,u,rho,Ap,CL_gamma,C_alpha,Ct,out_trace[1x1,0nz],out_det[1x1,0nz],out_discriminant[1x1,0nz],adj_trace,adj_det,adj_discriminant,out_adj_m[1x1,0nz],out_adj_Izz[1x1,0nz],out_adj_a[1x1,0nz],out_adj_b[1x1,0nz],out_adj_u[1x1,0nz],out_adj_rho[1x1,0nz],out_adj_Ap[1x1,0nz],out_adj_CL_gamma[1x1,0nz],out_adj_C_alpha[1x1,0nz],out_adj_Ct[1x1,0nz],fwd_m,fwd_Izz,fwd_a,fwd_b,fwd_u,fwd_rho,fwd_Ap,fwd_CL_gamma,fwd_C_alpha,fwd_Ct,fwd_out_trace[1x1,0nz],fwd_out_det[1x1,0nz],fwd_out_discriminant[1x1,0nz],fwd_adj_trace,fwd_adj_det,fwd_adj_discriminant)->(fwd_adj_m,fwd_adj_Izz,fwd_adj_a,fwd_adj_b,fwd_adj_u,fwd_adj_rho,fwd_adj_Ap,fwd_adj_CL_gamma,fwd_adj_C_alpha,fwd_adj_Ct) */
static int casadi_f7(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70;
a00=arg[4]? arg[4][0] : 0;
a01=casadi_sq(a00);
a02=arg[8]? arg[8][0] : 0;
a02=2.*a02;
a03=arg[9]? arg[9][0] : 0;
a04=5.0000000000000000e-01;
a05=arg[6]? arg[6][0] : 0;
a05=a04*a05;
a06=arg[7]? arg[7][0] : 0;
a07=a05*a06;
a08=arg[5]? arg[5][0] : 0;
a09=a07*a08;
a10=casadi_sq(a00);
a11=a09*a10;
a03=a03+a11;
a11=a02*a03;
a12=arg[2]? arg[2][0] : 0;
a13=arg[3]? arg[3][0] : 0;
a14=a12+a13;
a15=casadi_sq(a14);
a16=a11*a15;
a17=arg[1]? arg[1][0] : 0;
a18=arg[0]? arg[0][0] : 0;
a19=a17*a18;
a20=a19*a01;
a16=a16/a20;
a21=a16/a20;
a22=-4.;
a23=arg[15]? arg[15][0] : 0;
a24=a22*a23;
a25=arg[14]? arg[14][0] : 0;
a24=a24+a25;
a25=a21*a24;
a26=a01*a25;
a27=arg[27]? arg[27][0] : 0;
a28=a26*a27;
a29=2.*a00;
a30=arg[30]? arg[30][0] : 0;
a29=a29*a30;
a31=a25*a29;
a32=arg[34]? arg[34][0] : 0;
a32=2.*a32;
a33=a03*a32;
a34=arg[35]? arg[35][0] : 0;
a35=arg[32]? arg[32][0] : 0;
a35=a04*a35;
a36=a06*a35;
a37=arg[33]? arg[33][0] : 0;
a38=a05*a37;
a36=a36+a38;
a38=a08*a36;
a39=arg[31]? arg[31][0] : 0;
a40=a07*a39;
a38=a38+a40;
a40=a10*a38;
a41=2.*a00;
a41=a41*a30;
a42=a09*a41;
a40=a40+a42;
a34=a34+a40;
a40=a02*a34;
a33=a33+a40;
a40=a15*a33;
a42=2.*a14;
a43=arg[28]? arg[28][0] : 0;
a44=arg[29]? arg[29][0] : 0;
a45=a43+a44;
a42=a42*a45;
a46=a11*a42;
a40=a40+a46;
a40=a40/a20;
a16=a16/a20;
a46=a18*a27;
a47=arg[26]? arg[26][0] : 0;
a48=a17*a47;
a46=a46+a48;
a48=a01*a46;
a29=a19*a29;
a48=a48+a29;
a16=a16*a48;
a40=a40-a16;
a40=a40/a20;
a16=a21/a20;
a16=a16*a48;
a40=a40-a16;
a40=a24*a40;
a16=arg[41]? arg[41][0] : 0;
a22=a22*a16;
a29=arg[40]? arg[40][0] : 0;
a22=a22+a29;
a21=a21*a22;
a40=a40+a21;
a01=a01*a40;
a31=a31+a01;
a01=a17*a31;
a28=a28+a01;
a01=a18*a00;
a21=1./a01;
a29=a21/a01;
a49=casadi_sq(a12);
a50=a17*a00;
a49=a49/a50;
a51=a49+a21;
a52=a02*a51;
a53=casadi_sq(a13);
a53=a53/a50;
a54=a53+a21;
a55=a03*a54;
a52=a52+a55;
a52=2.*a52;
a55=a52*a23;
a56=arg[13]? arg[13][0] : 0;
a55=a55-a56;
a56=a03*a55;
a57=a02*a55;
a58=a56+a57;
a59=a29*a58;
a60=a59*a30;
a61=a55*a34;
a62=a51*a32;
a63=2.*a12;
a63=a63*a43;
a63=a63/a50;
a64=a49/a50;
a65=a00*a27;
a66=a17*a30;
a65=a65+a66;
a64=a64*a65;
a63=a63-a64;
a21=a21/a01;
a64=a00*a47;
a66=a18*a30;
a64=a64+a66;
a21=a21*a64;
a66=a63-a21;
a67=a02*a66;
a62=a62+a67;
a67=a54*a34;
a68=2.*a13;
a68=a68*a44;
a68=a68/a50;
a69=a53/a50;
a69=a69*a65;
a68=a68-a69;
a69=a68-a21;
a70=a03*a69;
a67=a67+a70;
a62=a62+a67;
a62=2.*a62;
a23=a23*a62;
a52=a52*a16;
a23=a23+a52;
a52=arg[39]? arg[39][0] : 0;
a23=a23-a52;
a52=a03*a23;
a61=a61+a52;
a52=a55*a32;
a16=a02*a23;
a52=a52+a16;
a16=a61+a52;
a16=a29*a16;
a21=a21/a01;
a29=a29/a01;
a29=a29*a64;
a21=a21+a29;
a58=a58*a21;
a16=a16-a58;
a58=a00*a16;
a60=a60+a58;
a28=a28+a60;
a28=-a28;
if (res[0]!=0) res[0][0]=a28;
a28=a12*a32;
a60=a02*a43;
a28=a28+a60;
a28=a28/a17;
a60=a02*a12;
a60=a60/a17;
a58=a60/a17;
a58=a58*a27;
a28=a28-a58;
a28=a28/a17;
a60=a60/a17;
a58=a60/a17;
a58=a58*a27;
a28=a28-a58;
a28=a24*a28;
a60=a60*a22;
a28=a28+a60;
a60=a13*a34;
a58=a03*a44;
a60=a60+a58;
a60=a60/a17;
a58=a03*a13;
a58=a58/a17;
a21=a58/a17;
a21=a21*a27;
a60=a60-a21;
a60=a60/a17;
a58=a58/a17;
a21=a58/a17;
a21=a21*a27;
a60=a60-a21;
a60=a24*a60;
a58=a58*a22;
a60=a60+a58;
a28=a28-a60;
a26=a26*a47;
a31=a18*a31;
a26=a26+a31;
a28=a28-a26;
a53=a53/a50;
a26=a53*a56;
a49=a49/a50;
a31=a49*a57;
a26=a26+a31;
a31=a26*a30;
a68=a68/a50;
a60=a53/a50;
a60=a60*a65;
a68=a68-a60;
a68=a56*a68;
a53=a53*a61;
a68=a68+a53;
a63=a63/a50;
a53=a49/a50;
a53=a53*a65;
a63=a63-a53;
a63=a57*a63;
a49=a49*a52;
a63=a63+a49;
a68=a68+a63;
a63=a00*a68;
a31=a31+a63;
a28=a28-a31;
if (res[1]!=0) res[1][0]=a28;
a28=a24/a20;
a31=a11*a28;
a45=2.*a45;
a31=a31*a45;
a14=2.*a14;
a33=a28*a33;
a45=a22/a20;
a20=a28/a20;
a20=a20*a48;
a45=a45-a20;
a11=a11*a45;
a33=a33+a11;
a14=a14*a33;
a31=a31+a14;
a14=a24/a17;
a33=a14*a32;
a11=a22/a17;
a20=a14/a17;
a20=a20*a27;
a11=a11-a20;
a20=a02*a11;
a33=a33+a20;
a33=a31-a33;
a57=a57/a50;
a20=2.*a43;
a20=a57*a20;
a48=2.*a12;
a52=a52/a50;
a57=a57/a50;
a57=a57*a65;
a52=a52-a57;
a48=a48*a52;
a20=a20+a48;
a33=a33+a20;
if (res[2]!=0) res[2][0]=a33;
a24=a24/a17;
a33=a24*a34;
a22=a22/a17;
a20=a24/a17;
a20=a20*a27;
a22=a22-a20;
a20=a03*a22;
a33=a33+a20;
a33=a33+a31;
a56=a56/a50;
a31=2.*a44;
a31=a56*a31;
a20=2.*a13;
a61=a61/a50;
a56=a56/a50;
a56=a56*a65;
a61=a61-a56;
a20=a20*a61;
a31=a31+a20;
a33=a33+a31;
if (res[3]!=0) res[3][0]=a33;
a33=a13*a24;
a31=a15*a28;
a20=a02*a31;
a33=a33+a20;
a20=a54*a55;
a33=a33+a20;
a20=a09*a33;
a61=2.*a30;
a20=a20*a61;
a61=2.*a00;
a38=a33*a38;
a24=a24*a44;
a13=a13*a22;
a24=a24+a13;
a32=a31*a32;
a28=a28*a42;
a15=a15*a45;
a28=a28+a15;
a02=a02*a28;
a32=a32+a02;
a24=a24+a32;
a69=a55*a69;
a54=a54*a23;
a69=a69+a54;
a24=a24+a69;
a09=a09*a24;
a38=a38+a09;
a61=a61*a38;
a20=a20+a61;
a61=a19*a25;
a30=2.*a30;
a61=a61*a30;
a00=2.*a00;
a25=a25*a46;
a19=a19*a40;
a25=a25+a19;
a00=a00*a25;
a61=a61+a00;
a20=a20-a61;
a59=a59*a47;
a18=a18*a16;
a59=a59+a18;
a20=a20-a59;
a26=a26*a27;
a17=a17*a68;
a26=a26+a17;
a20=a20-a26;
if (res[4]!=0) res[4][0]=a20;
a20=a10*a33;
a36=a20*a36;
a33=a33*a41;
a10=a10*a24;
a33=a33+a10;
a07=a07*a33;
a36=a36+a07;
if (res[5]!=0) res[5][0]=a36;
a36=a08*a20;
a37=a36*a37;
a20=a20*a39;
a08=a08*a33;
a20=a20+a08;
a06=a06*a20;
a37=a37+a06;
a04=a04*a37;
if (res[6]!=0) res[6][0]=a04;
a36=a36*a35;
a05=a05*a20;
a36=a36+a05;
if (res[7]!=0) res[7][0]=a36;
a31=a31*a34;
a03=a03*a28;
a31=a31+a03;
a14=a14*a43;
a12=a12*a11;
a14=a14+a12;
a31=a31-a14;
a55=a55*a66;
a51=a51*a23;
a55=a55+a51;
a31=a31+a55;
a31=2.*a31;
if (res[8]!=0) res[8][0]=a31;
if (res[9]!=0) res[9][0]=a24;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_routh_hurwitz(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f7(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_routh_hurwitz_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_routh_hurwitz_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_routh_hurwitz_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_routh_hurwitz_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_routh_hurwitz_n_in(void) { return 42;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_routh_hurwitz_n_out(void) { return 10;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_routh_hurwitz_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_routh_hurwitz_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "Izz";
case 2: return "a";
case 3: return "b";
case 4: return "u";
case 5: return "rho";
case 6: return "Ap";
case 7: return "CL_gamma";
case 8: return "C_alpha";
case 9: return "Ct";
case 10: return "out_trace";
case 11: return "out_det";
case 12: return "out_discriminant";
case 13: return "adj_trace";
case 14: return "adj_det";
case 15: return "adj_discriminant";
case 16: return "out_adj_m";
case 17: return "out_adj_Izz";
case 18: return "out_adj_a";
case 19: return "out_adj_b";
case 20: return "out_adj_u";
case 21: return "out_adj_rho";
case 22: return "out_adj_Ap";
case 23: return "out_adj_CL_gamma";
case 24: return "out_adj_C_alpha";
case 25: return "out_adj_Ct";
case 26: return "fwd_m";
case 27: return "fwd_Izz";
case 28: return "fwd_a";
case 29: return "fwd_b";
case 30: return "fwd_u";
case 31: return "fwd_rho";
case 32: return "fwd_Ap";
case 33: return "fwd_CL_gamma";
case 34: return "fwd_C_alpha";
case 35: return "fwd_Ct";
case 36: return "fwd_out_trace";
case 37: return "fwd_out_det";
case 38: return "fwd_out_discriminant";
case 39: return "fwd_adj_trace";
case 40: return "fwd_adj_det";
case 41: return "fwd_adj_discriminant";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_routh_hurwitz_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_m";
case 1: return "fwd_adj_Izz";
case 2: return "fwd_adj_a";
case 3: return "fwd_adj_b";
case 4: return "fwd_adj_u";
case 5: return "fwd_adj_rho";
case 6: return "fwd_adj_Ap";
case 7: return "fwd_adj_CL_gamma";
case 8: return "fwd_adj_C_alpha";
case 9: return "fwd_adj_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_routh_hurwitz_sparsity_in(casadi_int i) {
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
case 10: return casadi_s1;
case 11: return casadi_s1;
case 12: return casadi_s1;
case 13: return casadi_s0;
case 14: return casadi_s0;
case 15: return casadi_s0;
case 16: return casadi_s1;
case 17: return casadi_s1;
case 18: return casadi_s1;
case 19: return casadi_s1;
case 20: return casadi_s1;
case 21: return casadi_s1;
case 22: return casadi_s1;
case 23: return casadi_s1;
case 24: return casadi_s1;
case 25: return casadi_s1;
case 26: return casadi_s0;
case 27: return casadi_s0;
case 28: return casadi_s0;
case 29: return casadi_s0;
case 30: return casadi_s0;
case 31: return casadi_s0;
case 32: return casadi_s0;
case 33: return casadi_s0;
case 34: return casadi_s0;
case 35: return casadi_s0;
case 36: return casadi_s1;
case 37: return casadi_s1;
case 38: return casadi_s1;
case 39: return casadi_s0;
case 40: return casadi_s0;
case 41: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_routh_hurwitz_sparsity_out(casadi_int i) {
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
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_routh_hurwitz_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 42;
if (sz_res) *sz_res = 10;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_routh_hurwitz_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 42*sizeof(const casadi_real*);
if (sz_res) *sz_res = 10*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* modes:(A_vv,A_vr,A_rv,A_rr)->(re_1,im_1,re_2,im_2,decay_rate,natural_frequency,damped_frequency,damping_ratio) */
static int casadi_f8(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13;
a00=0.;
a01=4.;
a02=arg[2]? arg[2][0] : 0;
a01=a01*a02;
a03=arg[1]? arg[1][0] : 0;
a01=a01*a03;
a04=arg[0]? arg[0][0] : 0;
a05=arg[3]? arg[3][0] : 0;
a06=a04-a05;
a06=casadi_sq(a06);
a01=a01+a06;
a06=a00<a01;
a07=5.0000000000000000e-01;
a08=casadi_fabs(a01);
a08=sqrt(a08);
a08=a07*a08;
a09=a05+a04;
a10=a08*a09;
a10=a06?a10:0;
a11=-2.5000000000000000e-01;
a12=casadi_sq(a09);
a11=a11*a12;
a10=a10<a11;
a11=a05*a04;
a12=a02*a03;
a11=a11-a12;
a12=casadi_fabs(a11);
a13=3.5527136788005009e-15;
a05=a05*a04;
a05=casadi_fabs(a05);
a05=a13*a05;
a02=a02*a03;
a02=casadi_fabs(a02);
a13=a13*a02;
a05=a05+a13;
a12=a12<a05;
a12=!a12;
a12=a12?a11:0;
a11=a07*a09;
a06=a06?a08:0;
a11=a11-a06;
a05=a12/a11;
a05=a10?a05:0;
a10=!a10;
a07=a07*a09;
a06=a06+a07;
a10=a10?a06:0;
a05=a05+a10;
if (res[0]!=0) res[0][0]=a05;
a01=a01<a00;
a01=a01?a08:0;
if (res[1]!=0) res[1][0]=a01;
if (res[2]!=0) res[2][0]=a11;
a11=-a01;
if (res[3]!=0) res[3][0]=a11;
a11=casadi_fabs(a05);
a11=a11<=a00;
a11=!a11;
a05=-a05;
a11=a11?a05:0;
if (res[4]!=0) res[4][0]=a11;
a12=sqrt(a12);
if (res[5]!=0) res[5][0]=a12;
if (res[6]!=0) res[6][0]=a01;
a01=-5.0000000000000000e-01;
a01=a01*a09;
a01=a01/a12;
if (res[7]!=0) res[7][0]=a01;
return 0;
}
CASADI_SYMBOL_EXPORT int modes(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f8(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int modes_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void modes_release(int mem) {
}
CASADI_SYMBOL_EXPORT void modes_incref(void) {
}
CASADI_SYMBOL_EXPORT void modes_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int modes_n_in(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_int modes_n_out(void) { return 8;}
CASADI_SYMBOL_EXPORT casadi_real modes_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* modes_name_in(casadi_int i) {
switch (i) {
case 0: return "A_vv";
case 1: return "A_vr";
case 2: return "A_rv";
case 3: return "A_rr";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* modes_name_out(casadi_int i) {
switch (i) {
case 0: return "re_1";
case 1: return "im_1";
case 2: return "re_2";
case 3: return "im_2";
case 4: return "decay_rate";
case 5: return "natural_frequency";
case 6: return "damped_frequency";
case 7: return "damping_ratio";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* modes_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* modes_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int modes_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 4;
if (sz_res) *sz_res = 8;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int modes_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 4*sizeof(const casadi_real*);
if (sz_res) *sz_res = 8*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_modes:(A_vv,A_vr,A_rv,A_rr,out_re_1[1x1,0nz],out_im_1[1x1,0nz],out_re_2[1x1,0nz],out_im_2[1x1,0nz],out_decay_rate[1x1,0nz],out_natural_frequency[1x1,0nz],out_damped_frequency[1x1,0nz],out_damping_ratio[1x1,0nz],fwd_A_vv,fwd_A_vr,fwd_A_rv,fwd_A_rr)->(fwd_re_1,fwd_im_1,fwd_re_2,fwd_im_2,fwd_decay_rate,fwd_natural_frequency,fwd_damped_frequency,fwd_damping_ratio) */
static int casadi_f9(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24;
a00=0.;
a01=4.;
a02=arg[2]? arg[2][0] : 0;
a03=a01*a02;
a04=arg[1]? arg[1][0] : 0;
a05=a03*a04;
a06=arg[0]? arg[0][0] : 0;
a07=arg[3]? arg[3][0] : 0;
a08=a06-a07;
a09=casadi_sq(a08);
a05=a05+a09;
a09=a00<a05;
a10=5.0000000000000000e-01;
a11=casadi_fabs(a05);
a11=sqrt(a11);
a12=a10*a11;
a13=a07+a06;
a14=a12*a13;
a14=a09?a14:0;
a15=-2.5000000000000000e-01;
a16=casadi_sq(a13);
a15=a15*a16;
a14=a14<a15;
a15=a07*a06;
a16=a02*a04;
a15=a15-a16;
a16=casadi_fabs(a15);
a17=3.5527136788005009e-15;
a18=a07*a06;
a18=casadi_fabs(a18);
a18=a17*a18;
a19=a02*a04;
a19=casadi_fabs(a19);
a17=a17*a19;
a18=a18+a17;
a16=a16<a18;
a16=!a16;
a18=arg[15]? arg[15][0] : 0;
a06=a06*a18;
a17=arg[12]? arg[12][0] : 0;
a07=a07*a17;
a06=a06+a07;
a07=arg[14]? arg[14][0] : 0;
a19=a04*a07;
a20=arg[13]? arg[13][0] : 0;
a02=a02*a20;
a19=a19+a02;
a06=a06-a19;
a19=a10*a13;
a12=a09?a12:0;
a19=a19-a12;
a02=a06/a19;
a02=a16?a02:0;
a15=a16?a15:0;
a21=a15/a19;
a19=a21/a19;
a22=a18+a17;
a23=a10*a22;
a24=casadi_sign(a05);
a01=a01*a07;
a04=a04*a01;
a03=a03*a20;
a04=a04+a03;
a08=2.*a08;
a17=a17-a18;
a08=a08*a17;
a04=a04+a08;
a24=a24*a04;
a11=2.*a11;
a24=a24/a11;
a24=a10*a24;
a11=-a24;
a11=a09?a11:0;
a23=a23+a11;
a19=a19*a23;
a02=a02-a19;
a02=a14?a02:0;
a19=!a14;
a09=a09?a24:0;
a11=a10*a22;
a09=a09+a11;
a09=a19?a09:0;
a02=a02+a09;
if (res[0]!=0) res[0][0]=a02;
a05=a05<a00;
a09=a05?a24:0;
if (res[1]!=0) res[1][0]=a09;
if (res[2]!=0) res[2][0]=a23;
a24=-a24;
a05=a05?a24:0;
if (res[3]!=0) res[3][0]=a05;
a14=a14?a21:0;
a10=a10*a13;
a12=a12+a10;
a19=a19?a12:0;
a14=a14+a19;
a14=casadi_fabs(a14);
a14=a14<=a00;
a14=!a14;
a02=-a02;
a14=a14?a02:0;
if (res[4]!=0) res[4][0]=a14;
a15=sqrt(a15);
a14=2.*a15;
a06=a06/a14;
a14=a16?a06:0;
if (res[5]!=0) res[5][0]=a14;
if (res[6]!=0) res[6][0]=a09;
a09=-5.0000000000000000e-01;
a22=a09*a22;
a22=a22/a15;
a09=a09*a13;
a09=a09/a15;
a09=a09/a15;
a09=a09*a06;
a09=-a09;
a16=a16?a09:0;
a22=a22+a16;
if (res[7]!=0) res[7][0]=a22;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_modes(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f9(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_modes_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_modes_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_modes_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_modes_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_modes_n_in(void) { return 16;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_modes_n_out(void) { return 8;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_modes_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_modes_name_in(casadi_int i) {
switch (i) {
case 0: return "A_vv";
case 1: return "A_vr";
case 2: return "A_rv";
case 3: return "A_rr";
case 4: return "out_re_1";
case 5: return "out_im_1";
case 6: return "out_re_2";
case 7: return "out_im_2";
case 8: return "out_decay_rate";
case 9: return "out_natural_frequency";
case 10: return "out_damped_frequency";
case 11: return "out_damping_ratio";
case 12: return "fwd_A_vv";
case 13: return "fwd_A_vr";
case 14: return "fwd_A_rv";
case 15: return "fwd_A_rr";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_modes_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_re_1";
case 1: return "fwd_im_1";
case 2: return "fwd_re_2";
case 3: return "fwd_im_2";
case 4: return "fwd_decay_rate";
case 5: return "fwd_natural_frequency";
case 6: return "fwd_damped_frequency";
case 7: return "fwd_damping_ratio";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_modes_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s1;
case 5: return casadi_s1;
case 6: return casadi_s1;
case 7: return casadi_s1;
case 8: return casadi_s1;
case 9: return casadi_s1;
case 10: return casadi_s1;
case 11: return casadi_s1;
case 12: return casadi_s0;
case 13: return casadi_s0;
case 14: return casadi_s0;
case 15: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_modes_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_modes_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 16;
if (sz_res) *sz_res = 8;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_modes_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
if (sz_res) *sz_res = 8*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_modes:(A_vv,A_vr,A_rv,A_rr,out_re_1[1x1,0nz],out_im_1[1x1,0nz],out_re_2[1x1,0nz],out_im_2[1x1,0nz],out_decay_rate[1x1,0nz],out_natural_frequency[1x1,0nz],out_damped_frequency[1x1,0nz],out_damping_ratio[1x1,0nz],adj_re_1,adj_im_1,adj_re_2,adj_im_2,adj_decay_rate,adj_natural_frequency,adj_damped_frequency,adj_damping_ratio)->(adj_A_vv,adj_A_vr,adj_A_rv,adj_A_rr) */
static int casadi_f10(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
a00=arg[3]? arg[3][0] : 0;
a01=arg[0]? arg[0][0] : 0;
a02=a00*a01;
a03=arg[2]? arg[2][0] : 0;
a04=arg[1]? arg[1][0] : 0;
a05=a03*a04;
a02=a02-a05;
a05=casadi_fabs(a02);
a06=3.5527136788005009e-15;
a07=a00*a01;
a07=casadi_fabs(a07);
a07=a06*a07;
a08=a03*a04;
a08=casadi_fabs(a08);
a06=a06*a08;
a07=a07+a06;
a05=a05<a07;
a05=!a05;
a07=arg[17]? arg[17][0] : 0;
a06=-5.0000000000000000e-01;
a08=a00+a01;
a09=a06*a08;
a02=a05?a02:0;
a10=sqrt(a02);
a09=a09/a10;
a09=a09/a10;
a11=arg[19]? arg[19][0] : 0;
a09=a09*a11;
a07=a07-a09;
a09=2.*a10;
a07=a07/a09;
a09=0.;
a12=4.;
a13=a12*a03;
a14=a13*a04;
a15=a01-a00;
a16=casadi_sq(a15);
a14=a14+a16;
a16=a09<a14;
a17=5.0000000000000000e-01;
a18=casadi_fabs(a14);
a18=sqrt(a18);
a19=a17*a18;
a20=a19*a08;
a20=a16?a20:0;
a21=-2.5000000000000000e-01;
a22=casadi_sq(a08);
a21=a21*a22;
a20=a20<a21;
a21=a17*a08;
a19=a16?a19:0;
a21=a21-a19;
a02=a02/a21;
a22=a20?a02:0;
a23=!a20;
a08=a17*a08;
a19=a19+a08;
a19=a23?a19:0;
a22=a22+a19;
a22=casadi_fabs(a22);
a22=a22<=a09;
a22=!a22;
a19=arg[16]? arg[16][0] : 0;
a19=-a19;
a22=a22?a19:0;
a19=arg[12]? arg[12][0] : 0;
a22=a22+a19;
a19=a22/a21;
a19=a20?a19:0;
a07=a07+a19;
a00=a00*a07;
a00=a05?a00:0;
a11=a11/a10;
a06=a06*a11;
a11=a17*a22;
a11=a23?a11:0;
a06=a06+a11;
a11=arg[14]? arg[14][0] : 0;
a02=a02/a21;
a02=a02*a22;
a02=-a02;
a20=a20?a02:0;
a11=a11+a20;
a20=a17*a11;
a06=a06+a20;
a00=a00+a06;
a15=2.*a15;
a20=casadi_sign(a14);
a14=a14<a09;
a09=arg[18]? arg[18][0] : 0;
a02=arg[15]? arg[15][0] : 0;
a09=a09-a02;
a02=arg[13]? arg[13][0] : 0;
a09=a09+a02;
a14=a14?a09:0;
a23=a23?a22:0;
a23=a23-a11;
a16=a16?a23:0;
a14=a14+a16;
a17=a17*a14;
a18=2.*a18;
a17=a17/a18;
a20=a20*a17;
a15=a15*a20;
a00=a00+a15;
if (res[0]!=0) res[0][0]=a00;
a03=a03*a07;
a03=-a03;
a03=a05?a03:0;
a13=a13*a20;
a03=a03+a13;
if (res[1]!=0) res[1][0]=a03;
a03=a04*a07;
a03=-a03;
a03=a05?a03:0;
a04=a04*a20;
a12=a12*a04;
a03=a03+a12;
if (res[2]!=0) res[2][0]=a03;
a01=a01*a07;
a05=a05?a01:0;
a05=a05+a06;
a05=a05-a15;
if (res[3]!=0) res[3][0]=a05;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_modes(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f10(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_modes_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_modes_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_modes_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_modes_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_modes_n_in(void) { return 20;}
CASADI_SYMBOL_EXPORT casadi_int adj1_modes_n_out(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_real adj1_modes_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_modes_name_in(casadi_int i) {
switch (i) {
case 0: return "A_vv";
case 1: return "A_vr";
case 2: return "A_rv";
case 3: return "A_rr";
case 4: return "out_re_1";
case 5: return "out_im_1";
case 6: return "out_re_2";
case 7: return "out_im_2";
case 8: return "out_decay_rate";
case 9: return "out_natural_frequency";
case 10: return "out_damped_frequency";
case 11: return "out_damping_ratio";
case 12: return "adj_re_1";
case 13: return "adj_im_1";
case 14: return "adj_re_2";
case 15: return "adj_im_2";
case 16: return "adj_decay_rate";
case 17: return "adj_natural_frequency";
case 18: return "adj_damped_frequency";
case 19: return "adj_damping_ratio";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_modes_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_A_vv";
case 1: return "adj_A_vr";
case 2: return "adj_A_rv";
case 3: return "adj_A_rr";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_modes_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s1;
case 5: return casadi_s1;
case 6: return casadi_s1;
case 7: return casadi_s1;
case 8: return casadi_s1;
case 9: return casadi_s1;
case 10: return casadi_s1;
case 11: return casadi_s1;
case 12: return casadi_s0;
case 13: return casadi_s0;
case 14: return casadi_s0;
case 15: return casadi_s0;
case 16: return casadi_s0;
case 17: return casadi_s0;
case 18: return casadi_s0;
case 19: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_modes_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_modes_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 20;
if (sz_res) *sz_res = 4;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_modes_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
if (sz_res) *sz_res = 4*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_modes:(A_vv,A_vr,A_rv,A_rr,out_re_1[1x1,0nz],out_im_1[1x1,0nz],out_re_2[1x1,0nz],out_im_2[1x1,0nz],out_decay_rate[1x1,0nz],out_natural_frequency[1x1,0nz],out_damped_frequency[1x1,0nz],out_damping_ratio[1x1,0nz],adj_re_1,adj_im_1,adj_re_2,adj_im_2,adj_decay_rate,adj_natural_frequency,adj_damped_frequency,adj_damping_ratio,out_adj_A_vv[1x1,0nz],out_adj_A_vr[1x1,0nz],out_adj_A_rv[1x1,0nz],out_adj_A_rr[1x1,0nz],fwd_A_vv,fwd_A_vr,fwd_A_rv,fwd_A_rr,fwd_out_re_1[1x1,0nz],fwd_out_im_1[1x1,0nz],fwd_out_re_2[1x1,0nz],fwd_out_im_2[1x1,0nz],fwd_out_decay_rate[1x1,0nz],fwd_out_natural_frequency[1x1,0nz],fwd_out_damped_frequency[1x1,0nz],fwd_out_damping_ratio[1x1,0nz],fwd_adj_re_1,fwd_adj_im_1,fwd_adj_re_2,fwd_adj_im_2,fwd_adj_decay_rate,fwd_adj_natural_frequency,fwd_adj_damped_frequency,fwd_adj_damping_ratio)->(fwd_adj_A_vv,fwd_adj_A_vr,fwd_adj_A_rv,fwd_adj_A_rr) */
static int casadi_f11(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38;
a00=arg[3]? arg[3][0] : 0;
a01=arg[0]? arg[0][0] : 0;
a02=a00*a01;
a03=arg[2]? arg[2][0] : 0;
a04=arg[1]? arg[1][0] : 0;
a05=a03*a04;
a02=a02-a05;
a05=casadi_fabs(a02);
a06=3.5527136788005009e-15;
a07=a00*a01;
a07=casadi_fabs(a07);
a07=a06*a07;
a08=a03*a04;
a08=casadi_fabs(a08);
a06=a06*a08;
a07=a07+a06;
a05=a05<a07;
a05=!a05;
a07=arg[17]? arg[17][0] : 0;
a06=-5.0000000000000000e-01;
a08=a00+a01;
a09=a06*a08;
a02=a05?a02:0;
a10=sqrt(a02);
a09=a09/a10;
a11=a09/a10;
a12=arg[19]? arg[19][0] : 0;
a13=a11*a12;
a07=a07-a13;
a13=2.*a10;
a07=a07/a13;
a14=0.;
a15=4.;
a16=a15*a03;
a17=a16*a04;
a18=a01-a00;
a19=casadi_sq(a18);
a17=a17+a19;
a19=a14<a17;
a20=5.0000000000000000e-01;
a21=casadi_fabs(a17);
a21=sqrt(a21);
a22=a20*a21;
a23=a22*a08;
a23=a19?a23:0;
a24=-2.5000000000000000e-01;
a25=casadi_sq(a08);
a24=a24*a25;
a23=a23<a24;
a24=a20*a08;
a22=a19?a22:0;
a24=a24-a22;
a02=a02/a24;
a25=a23?a02:0;
a26=!a23;
a08=a20*a08;
a22=a22+a08;
a22=a26?a22:0;
a25=a25+a22;
a25=casadi_fabs(a25);
a25=a25<=a14;
a25=!a25;
a22=arg[16]? arg[16][0] : 0;
a22=-a22;
a22=a25?a22:0;
a08=arg[12]? arg[12][0] : 0;
a22=a22+a08;
a08=a22/a24;
a27=a23?a08:0;
a27=a07+a27;
a28=arg[27]? arg[27][0] : 0;
a29=a27*a28;
a30=arg[41]? arg[41][0] : 0;
a31=arg[24]? arg[24][0] : 0;
a32=a28+a31;
a33=a06*a32;
a33=a33/a10;
a09=a09/a10;
a34=a01*a28;
a35=a00*a31;
a34=a34+a35;
a35=arg[26]? arg[26][0] : 0;
a36=a04*a35;
a37=arg[25]? arg[25][0] : 0;
a38=a03*a37;
a36=a36+a38;
a34=a34-a36;
a36=2.*a10;
a36=a34/a36;
a09=a09*a36;
a09=-a09;
a09=a05?a09:0;
a33=a33+a09;
a33=a33/a10;
a09=a11/a10;
a09=a09*a36;
a09=-a09;
a09=a05?a09:0;
a33=a33+a09;
a33=a12*a33;
a09=arg[43]? arg[43][0] : 0;
a11=a11*a09;
a33=a33+a11;
a30=a30-a33;
a30=a30/a13;
a07=a07/a13;
a13=2.*a36;
a07=a07*a13;
a07=-a07;
a07=a05?a07:0;
a30=a30+a07;
a07=arg[40]? arg[40][0] : 0;
a07=-a07;
a25=a25?a07:0;
a07=arg[36]? arg[36][0] : 0;
a25=a25+a07;
a07=a25/a24;
a08=a08/a24;
a32=a20*a32;
a13=casadi_sign(a17);
a33=a15*a35;
a11=a04*a33;
a38=a16*a37;
a11=a11+a38;
a38=2.*a18;
a28=a31-a28;
a38=a38*a28;
a11=a11+a38;
a13=a13*a11;
a11=2.*a21;
a13=a13/a11;
a11=a20*a13;
a11=-a11;
a11=a19?a11:0;
a32=a32+a11;
a08=a08*a32;
a07=a07-a08;
a07=a23?a07:0;
a30=a30+a07;
a00=a00*a30;
a29=a29+a00;
a29=a05?a29:0;
a09=a09/a10;
a12=a12/a10;
a12=a12/a10;
a12=a12*a36;
a12=-a12;
a12=a05?a12:0;
a09=a09+a12;
a06=a06*a09;
a09=a20*a25;
a09=a26?a09:0;
a06=a06+a09;
a09=arg[38]? arg[38][0] : 0;
a34=a34/a24;
a34=a05?a34:0;
a12=a02/a24;
a12=a12*a32;
a34=a34-a12;
a34=a34/a24;
a02=a02/a24;
a24=a02/a24;
a24=a24*a32;
a34=a34-a24;
a34=a22*a34;
a24=a02*a25;
a34=a34+a24;
a34=-a34;
a34=a23?a34:0;
a09=a09+a34;
a34=a20*a09;
a06=a06+a34;
a29=a29+a06;
a34=casadi_sign(a17);
a17=a17<a14;
a14=arg[18]? arg[18][0] : 0;
a24=arg[15]? arg[15][0] : 0;
a14=a14-a24;
a24=arg[13]? arg[13][0] : 0;
a14=a14+a24;
a14=a17?a14:0;
a24=a26?a22:0;
a32=arg[14]? arg[14][0] : 0;
a02=a02*a22;
a02=-a02;
a23=a23?a02:0;
a32=a32+a23;
a24=a24-a32;
a24=a19?a24:0;
a14=a14+a24;
a14=a20*a14;
a21=2.*a21;
a14=a14/a21;
a24=a34*a14;
a28=2.*a28;
a28=a24*a28;
a18=2.*a18;
a32=arg[42]? arg[42][0] : 0;
a23=arg[39]? arg[39][0] : 0;
a32=a32-a23;
a23=arg[37]? arg[37][0] : 0;
a32=a32+a23;
a17=a17?a32:0;
a26=a26?a25:0;
a26=a26-a09;
a19=a19?a26:0;
a17=a17+a19;
a20=a20*a17;
a20=a20/a21;
a14=a14/a21;
a13=2.*a13;
a14=a14*a13;
a20=a20-a14;
a34=a34*a20;
a18=a18*a34;
a28=a28+a18;
a29=a29+a28;
if (res[0]!=0) res[0][0]=a29;
a35=a27*a35;
a03=a03*a30;
a35=a35+a03;
a35=-a35;
a35=a05?a35:0;
a33=a24*a33;
a16=a16*a34;
a33=a33+a16;
a35=a35+a33;
if (res[1]!=0) res[1][0]=a35;
a35=a27*a37;
a33=a04*a30;
a35=a35+a33;
a35=-a35;
a35=a05?a35:0;
a24=a24*a37;
a04=a04*a34;
a24=a24+a04;
a15=a15*a24;
a35=a35+a15;
if (res[2]!=0) res[2][0]=a35;
a27=a27*a31;
a01=a01*a30;
a27=a27+a01;
a05=a05?a27:0;
a05=a05+a06;
a05=a05-a28;
if (res[3]!=0) res[3][0]=a05;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_modes(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f11(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_modes_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_modes_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_modes_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_modes_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_modes_n_in(void) { return 44;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_modes_n_out(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_modes_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_modes_name_in(casadi_int i) {
switch (i) {
case 0: return "A_vv";
case 1: return "A_vr";
case 2: return "A_rv";
case 3: return "A_rr";
case 4: return "out_re_1";
case 5: return "out_im_1";
case 6: return "out_re_2";
case 7: return "out_im_2";
case 8: return "out_decay_rate";
case 9: return "out_natural_frequency";
case 10: return "out_damped_frequency";
case 11: return "out_damping_ratio";
case 12: return "adj_re_1";
case 13: return "adj_im_1";
case 14: return "adj_re_2";
case 15: return "adj_im_2";
case 16: return "adj_decay_rate";
case 17: return "adj_natural_frequency";
case 18: return "adj_damped_frequency";
case 19: return "adj_damping_ratio";
case 20: return "out_adj_A_vv";
case 21: return "out_adj_A_vr";
case 22: return "out_adj_A_rv";
case 23: return "out_adj_A_rr";
case 24: return "fwd_A_vv";
case 25: return "fwd_A_vr";
case 26: return "fwd_A_rv";
case 27: return "fwd_A_rr";
case 28: return "fwd_out_re_1";
case 29: return "fwd_out_im_1";
case 30: return "fwd_out_re_2";
case 31: return "fwd_out_im_2";
case 32: return "fwd_out_decay_rate";
case 33: return "fwd_out_natural_frequency";
case 34: return "fwd_out_damped_frequency";
case 35: return "fwd_out_damping_ratio";
case 36: return "fwd_adj_re_1";
case 37: return "fwd_adj_im_1";
case 38: return "fwd_adj_re_2";
case 39: return "fwd_adj_im_2";
case 40: return "fwd_adj_decay_rate";
case 41: return "fwd_adj_natural_frequency";
case 42: return "fwd_adj_damped_frequency";
case 43: return "fwd_adj_damping_ratio";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_modes_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_A_vv";
case 1: return "fwd_adj_A_vr";
case 2: return "fwd_adj_A_rv";
case 3: return "fwd_adj_A_rr";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_modes_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s1;
case 5: return casadi_s1;
case 6: return casadi_s1;
case 7: return casadi_s1;
case 8: return casadi_s1;
case 9: return casadi_s1;
case 10: return casadi_s1;
case 11: return casadi_s1;
case 12: return casadi_s0;
case 13: return casadi_s0;
case 14: return casadi_s0;
case 15: return casadi_s0;
case 16: return casadi_s0;
case 17: return casadi_s0;
case 18: return casadi_s0;
case 19: return casadi_s0;
case 20: return casadi_s1;
case 21: return casadi_s1;
case 22: return casadi_s1;
case 23: return casadi_s1;
case 24: return casadi_s0;
case 25: return casadi_s0;
case 26: return casadi_s0;
case 27: return casadi_s0;
case 28: return casadi_s1;
case 29: return casadi_s1;
case 30: return casadi_s1;
case 31: return casadi_s1;
case 32: return casadi_s1;
case 33: return casadi_s1;
case 34: return casadi_s1;
case 35: return casadi_s1;
case 36: return casadi_s0;
case 37: return casadi_s0;
case 38: return casadi_s0;
case 39: return casadi_s0;
case 40: return casadi_s0;
case 41: return casadi_s0;
case 42: return casadi_s0;
case 43: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_modes_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_modes_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 44;
if (sz_res) *sz_res = 4;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_modes_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 44*sizeof(const casadi_real*);
if (sz_res) *sz_res = 4*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* linear_modes:(m,Izz,a,b,u,rho,Ap,CL_gamma,C_alpha,Ct)->(re_1,im_1,re_2,im_2,decay_rate,natural_frequency,damped_frequency,damping_ratio) */
static int casadi_f12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13;
a00=0.;
a01=4.;
a02=arg[8]? arg[8][0] : 0;
a02=2.*a02;
a03=arg[2]? arg[2][0] : 0;
a04=a02*a03;
a05=arg[9]? arg[9][0] : 0;
a06=5.0000000000000000e-01;
a07=arg[6]? arg[6][0] : 0;
a07=a06*a07;
a08=arg[7]? arg[7][0] : 0;
a07=a07*a08;
a08=arg[5]? arg[5][0] : 0;
a07=a07*a08;
a08=arg[4]? arg[4][0] : 0;
a09=casadi_sq(a08);
a07=a07*a09;
a05=a05+a07;
a07=arg[3]? arg[3][0] : 0;
a09=a05*a07;
a04=a04-a09;
a09=arg[1]? arg[1][0] : 0;
a09=a09*a08;
a10=a04/a09;
a01=a01*a10;
a11=arg[0]? arg[0][0] : 0;
a12=casadi_sq(a08);
a12=a11*a12;
a12=a12+a04;
a11=a11*a08;
a12=a12/a11;
a01=a01*a12;
a03=casadi_sq(a03);
a03=a02*a03;
a07=casadi_sq(a07);
a07=a05*a07;
a03=a03+a07;
a03=a03/a09;
a02=a02+a05;
a02=a02/a11;
a11=a03-a02;
a11=casadi_sq(a11);
a01=a01+a11;
a11=a00<a01;
a05=casadi_fabs(a01);
a05=sqrt(a05);
a05=a06*a05;
a09=a03+a02;
a07=a05*a09;
a07=-a07;
a07=a11?a07:0;
a08=-2.5000000000000000e-01;
a04=casadi_sq(a09);
a08=a08*a04;
a07=a07<a08;
a08=a03*a02;
a04=a10*a12;
a08=a08-a04;
a04=casadi_fabs(a08);
a13=3.5527136788005009e-15;
a03=a03*a02;
a03=casadi_fabs(a03);
a03=a13*a03;
a10=a10*a12;
a10=casadi_fabs(a10);
a13=a13*a10;
a03=a03+a13;
a04=a04<a03;
a04=!a04;
a04=a04?a08:0;
a11=a11?a05:0;
a08=a06*a09;
a08=a11+a08;
a03=a04/a08;
a03=-a03;
a03=a07?a03:0;
a07=!a07;
a06=a06*a09;
a11=a11-a06;
a07=a07?a11:0;
a03=a03+a07;
if (res[0]!=0) res[0][0]=a03;
a01=a01<a00;
a01=a01?a05:0;
if (res[1]!=0) res[1][0]=a01;
a08=-a08;
if (res[2]!=0) res[2][0]=a08;
a08=-a01;
if (res[3]!=0) res[3][0]=a08;
a08=casadi_fabs(a03);
a08=a08<=a00;
a08=!a08;
a03=-a03;
a08=a08?a03:0;
if (res[4]!=0) res[4][0]=a08;
a04=sqrt(a04);
if (res[5]!=0) res[5][0]=a04;
if (res[6]!=0) res[6][0]=a01;
a01=-5.0000000000000000e-01;
a01=a01*a09;
a01=a01/a04;
a01=-a01;
if (res[7]!=0) res[7][0]=a01;
return 0;
}
CASADI_SYMBOL_EXPORT int linear_modes(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f12(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int linear_modes_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void linear_modes_release(int mem) {
}
CASADI_SYMBOL_EXPORT void linear_modes_incref(void) {
}
CASADI_SYMBOL_EXPORT void linear_modes_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int linear_modes_n_in(void) { return 10;}
CASADI_SYMBOL_EXPORT casadi_int linear_modes_n_out(void) { return 8;}
CASADI_SYMBOL_EXPORT casadi_real linear_modes_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* linear_modes_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "Izz";
case 2: return "a";
case 3: return "b";
case 4: return "u";
case 5: return "rho";
case 6: return "Ap";
case 7: return "CL_gamma";
case 8: return "C_alpha";
case 9: return "Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* linear_modes_name_out(casadi_int i) {
switch (i) {
case 0: return "re_1";
case 1: return "im_1";
case 2: return "re_2";
case 3: return "im_2";
case 4: return "decay_rate";
case 5: return "natural_frequency";
case 6: return "damped_frequency";
case 7: return "damping_ratio";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* linear_modes_sparsity_in(casadi_int i) {
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
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* linear_modes_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int linear_modes_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 10;
if (sz_res) *sz_res = 8;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int linear_modes_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
if (sz_res) *sz_res = 8*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_linear_modes:(m,Izz,a,b,u,rho,Ap,CL_gamma,C_alpha,Ct,out_re_1[1x1,0nz],out_im_1[1x1,0nz],out_re_2[1x1,0nz],out_im_2[1x1,0nz],out_decay_rate[1x1,0nz],out_natural_frequency[1x1,0nz],out_damped_frequency[1x1,0nz],out_damping_ratio[1x1,0nz],fwd_m,fwd_Izz,fwd_a,fwd_b,fwd_u,fwd_rho,fwd_Ap,fwd_CL_gamma,fwd_C_alpha,fwd_Ct)->(fwd_re_1,fwd_im_1,fwd_re_2,fwd_im_2,fwd_decay_rate,fwd_natural_frequency,fwd_damped_frequency,fwd_damping_ratio) */
static int casadi_f13(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38;
a00=0.;
a01=4.;
a02=arg[8]? arg[8][0] : 0;
a02=2.*a02;
a03=arg[2]? arg[2][0] : 0;
a04=a02*a03;
a05=arg[9]? arg[9][0] : 0;
a06=5.0000000000000000e-01;
a07=arg[6]? arg[6][0] : 0;
a07=a06*a07;
a08=arg[7]? arg[7][0] : 0;
a09=a07*a08;
a10=arg[5]? arg[5][0] : 0;
a11=a09*a10;
a12=arg[4]? arg[4][0] : 0;
a13=casadi_sq(a12);
a14=a11*a13;
a05=a05+a14;
a14=arg[3]? arg[3][0] : 0;
a15=a05*a14;
a04=a04-a15;
a15=arg[1]? arg[1][0] : 0;
a16=a15*a12;
a17=a04/a16;
a18=a01*a17;
a19=arg[0]? arg[0][0] : 0;
a20=casadi_sq(a12);
a21=a19*a20;
a21=a21+a04;
a04=a19*a12;
a21=a21/a04;
a22=a18*a21;
a23=casadi_sq(a03);
a24=a02*a23;
a25=casadi_sq(a14);
a26=a05*a25;
a24=a24+a26;
a24=a24/a16;
a26=a02+a05;
a26=a26/a04;
a27=a24-a26;
a28=casadi_sq(a27);
a22=a22+a28;
a28=a00<a22;
a29=casadi_fabs(a22);
a29=sqrt(a29);
a30=a06*a29;
a31=a24+a26;
a32=a30*a31;
a32=-a32;
a32=a28?a32:0;
a33=-2.5000000000000000e-01;
a34=casadi_sq(a31);
a33=a33*a34;
a32=a32<a33;
a33=a24*a26;
a34=a17*a21;
a33=a33-a34;
a34=casadi_fabs(a33);
a35=3.5527136788005009e-15;
a36=a24*a26;
a36=casadi_fabs(a36);
a36=a35*a36;
a37=a17*a21;
a37=casadi_fabs(a37);
a35=a35*a37;
a36=a36+a35;
a34=a34<a36;
a34=!a34;
a36=arg[26]? arg[26][0] : 0;
a36=2.*a36;
a23=a23*a36;
a35=2.*a03;
a37=arg[20]? arg[20][0] : 0;
a35=a35*a37;
a35=a02*a35;
a23=a23+a35;
a35=arg[27]? arg[27][0] : 0;
a38=arg[24]? arg[24][0] : 0;
a38=a06*a38;
a08=a08*a38;
a38=arg[25]? arg[25][0] : 0;
a07=a07*a38;
a08=a08+a07;
a10=a10*a08;
a08=arg[23]? arg[23][0] : 0;
a09=a09*a08;
a10=a10+a09;
a13=a13*a10;
a10=2.*a12;
a09=arg[22]? arg[22][0] : 0;
a10=a10*a09;
a11=a11*a10;
a13=a13+a11;
a35=a35+a13;
a25=a25*a35;
a13=2.*a14;
a11=arg[21]? arg[21][0] : 0;
a13=a13*a11;
a13=a05*a13;
a25=a25+a13;
a23=a23+a25;
a23=a23/a16;
a25=a24/a16;
a13=arg[19]? arg[19][0] : 0;
a13=a12*a13;
a15=a15*a09;
a13=a13+a15;
a25=a25*a13;
a23=a23-a25;
a25=a26*a23;
a15=a36+a35;
a15=a15/a04;
a26=a26/a04;
a10=arg[18]? arg[18][0] : 0;
a08=a12*a10;
a07=a19*a09;
a08=a08+a07;
a26=a26*a08;
a15=a15-a26;
a24=a24*a15;
a25=a25+a24;
a03=a03*a36;
a02=a02*a37;
a03=a03+a02;
a14=a14*a35;
a05=a05*a11;
a14=a14+a05;
a03=a03-a14;
a14=a03/a16;
a16=a17/a16;
a16=a16*a13;
a14=a14-a16;
a16=a21*a14;
a20=a20*a10;
a12=2.*a12;
a12=a12*a09;
a19=a19*a12;
a20=a20+a19;
a20=a20+a03;
a20=a20/a04;
a04=a21/a04;
a04=a04*a08;
a20=a20-a04;
a17=a17*a20;
a16=a16+a17;
a25=a25-a16;
a30=a28?a30:0;
a16=a06*a31;
a16=a30+a16;
a17=a25/a16;
a17=a34?a17:0;
a33=a34?a33:0;
a04=a33/a16;
a16=a04/a16;
a08=casadi_sign(a22);
a01=a01*a14;
a21=a21*a01;
a18=a18*a20;
a21=a21+a18;
a27=2.*a27;
a18=a23-a15;
a27=a27*a18;
a21=a21+a27;
a08=a08*a21;
a29=2.*a29;
a08=a08/a29;
a08=a06*a08;
a29=a28?a08:0;
a23=a23+a15;
a15=a06*a23;
a29=a29+a15;
a16=a16*a29;
a17=a17-a16;
a17=-a17;
a17=a32?a17:0;
a16=!a32;
a28=a28?a08:0;
a15=a06*a23;
a28=a28-a15;
a28=a16?a28:0;
a17=a17+a28;
if (res[0]!=0) res[0][0]=a17;
a22=a22<a00;
a28=a22?a08:0;
if (res[1]!=0) res[1][0]=a28;
a29=-a29;
if (res[2]!=0) res[2][0]=a29;
a08=-a08;
a22=a22?a08:0;
if (res[3]!=0) res[3][0]=a22;
a04=-a04;
a32=a32?a04:0;
a06=a06*a31;
a30=a30-a06;
a16=a16?a30:0;
a32=a32+a16;
a32=casadi_fabs(a32);
a32=a32<=a00;
a32=!a32;
a17=-a17;
a32=a32?a17:0;
if (res[4]!=0) res[4][0]=a32;
a33=sqrt(a33);
a32=2.*a33;
a25=a25/a32;
a32=a34?a25:0;
if (res[5]!=0) res[5][0]=a32;
if (res[6]!=0) res[6][0]=a28;
a28=-5.0000000000000000e-01;
a23=a28*a23;
a23=a23/a33;
a28=a28*a31;
a28=a28/a33;
a28=a28/a33;
a28=a28*a25;
a28=-a28;
a34=a34?a28:0;
a23=a23+a34;
a23=-a23;
if (res[7]!=0) res[7][0]=a23;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_linear_modes(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f13(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_linear_modes_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_linear_modes_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_linear_modes_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_linear_modes_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_linear_modes_n_in(void) { return 28;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_linear_modes_n_out(void) { return 8;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_linear_modes_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_linear_modes_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "Izz";
case 2: return "a";
case 3: return "b";
case 4: return "u";
case 5: return "rho";
case 6: return "Ap";
case 7: return "CL_gamma";
case 8: return "C_alpha";
case 9: return "Ct";
case 10: return "out_re_1";
case 11: return "out_im_1";
case 12: return "out_re_2";
case 13: return "out_im_2";
case 14: return "out_decay_rate";
case 15: return "out_natural_frequency";
case 16: return "out_damped_frequency";
case 17: return "out_damping_ratio";
case 18: return "fwd_m";
case 19: return "fwd_Izz";
case 20: return "fwd_a";
case 21: return "fwd_b";
case 22: return "fwd_u";
case 23: return "fwd_rho";
case 24: return "fwd_Ap";
case 25: return "fwd_CL_gamma";
case 26: return "fwd_C_alpha";
case 27: return "fwd_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_linear_modes_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_re_1";
case 1: return "fwd_im_1";
case 2: return "fwd_re_2";
case 3: return "fwd_im_2";
case 4: return "fwd_decay_rate";
case 5: return "fwd_natural_frequency";
case 6: return "fwd_damped_frequency";
case 7: return "fwd_damping_ratio";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_linear_modes_sparsity_in(casadi_int i) {
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
case 10: return casadi_s1;
case 11: return casadi_s1;
case 12: return casadi_s1;
case 13: return casadi_s1;
case 14: return casadi_s1;
case 15: return casadi_s1;
case 16: return casadi_s1;
case 17: return casadi_s1;
case 18: return casadi_s0;
case 19: return casadi_s0;
case 20: return casadi_s0;
case 21: return casadi_s0;
case 22: return casadi_s0;
case 23: return casadi_s0;
case 24: return casadi_s0;
case 25: return casadi_s0;
case 26: return casadi_s0;
case 27: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_linear_modes_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_linear_modes_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 28;
if (sz_res) *sz_res = 8;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_linear_modes_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 28*sizeof(const casadi_real*);
if (sz_res) *sz_res = 8*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_linear_modes:(m,Izz,a,b,u,rho,Ap,CL_gamma,C_alpha,Ct,out_re_1[1x1,0nz],out_im_1[1x1,0nz],out_re_2[1x1,0nz],out_im_2[1x1,0nz],out_decay_rate[1x1,0nz],out_natural_frequency[1x1,0nz],out_damped_frequency[1x1,0nz],out_damping_ratio[1x1,0nz],adj_re_1,adj_im_1,adj_re_2,adj_im_2,adj_decay_rate,adj_natural_frequency,adj_damped_frequency,adj_damping_ratio)->(adj_m,adj_Izz,adj_a,adj_b,adj_u,adj_rho,adj_Ap,adj_CL_gamma,adj_C_alpha,adj_Ct) */
static int casadi_f14(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42;
a00=arg[4]? arg[4][0] : 0;
a01=casadi_sq(a00);
a02=arg[8]? arg[8][0] : 0;
a02=2.*a02;
a03=arg[2]? arg[2][0] : 0;
a04=casadi_sq(a03);
a05=a02*a04;
a06=arg[9]? arg[9][0] : 0;
a07=5.0000000000000000e-01;
a08=arg[6]? arg[6][0] : 0;
a08=a07*a08;
a09=arg[7]? arg[7][0] : 0;
a10=a08*a09;
a11=arg[5]? arg[5][0] : 0;
a12=a10*a11;
a13=casadi_sq(a00);
a14=a12*a13;
a06=a06+a14;
a14=arg[3]? arg[3][0] : 0;
a15=casadi_sq(a14);
a16=a06*a15;
a05=a05+a16;
a16=arg[1]? arg[1][0] : 0;
a17=a16*a00;
a05=a05/a17;
a18=a02+a06;
a19=arg[0]? arg[0][0] : 0;
a20=a19*a00;
a18=a18/a20;
a21=a05*a18;
a22=a02*a03;
a23=a06*a14;
a22=a22-a23;
a23=a22/a17;
a24=a19*a01;
a24=a24+a22;
a24=a24/a20;
a22=a23*a24;
a21=a21-a22;
a22=casadi_fabs(a21);
a25=3.5527136788005009e-15;
a26=a05*a18;
a26=casadi_fabs(a26);
a26=a25*a26;
a27=a23*a24;
a27=casadi_fabs(a27);
a25=a25*a27;
a26=a26+a25;
a22=a22<a26;
a22=!a22;
a26=-5.0000000000000000e-01;
a25=a05+a18;
a27=a26*a25;
a21=a22?a21:0;
a28=sqrt(a21);
a27=a27/a28;
a27=a27/a28;
a29=arg[25]? arg[25][0] : 0;
a27=a27*a29;
a30=arg[23]? arg[23][0] : 0;
a27=a27+a30;
a30=2.*a28;
a27=a27/a30;
a30=0.;
a31=4.;
a32=a31*a23;
a33=a32*a24;
a34=a05-a18;
a35=casadi_sq(a34);
a33=a33+a35;
a35=a30<a33;
a36=casadi_fabs(a33);
a36=sqrt(a36);
a37=a07*a36;
a38=a37*a25;
a38=-a38;
a38=a35?a38:0;
a39=-2.5000000000000000e-01;
a40=casadi_sq(a25);
a39=a39*a40;
a38=a38<a39;
a37=a35?a37:0;
a39=a07*a25;
a39=a37+a39;
a21=a21/a39;
a40=-a21;
a40=a38?a40:0;
a41=!a38;
a25=a07*a25;
a37=a37-a25;
a37=a41?a37:0;
a40=a40+a37;
a40=casadi_fabs(a40);
a40=a40<=a30;
a40=!a40;
a37=arg[22]? arg[22][0] : 0;
a37=-a37;
a40=a40?a37:0;
a37=arg[18]? arg[18][0] : 0;
a40=a40+a37;
a37=a40/a39;
a37=-a37;
a37=a38?a37:0;
a27=a27+a37;
a37=a23*a27;
a37=-a37;
a37=a22?a37:0;
a25=casadi_sign(a33);
a33=a33<a30;
a30=arg[24]? arg[24][0] : 0;
a42=arg[21]? arg[21][0] : 0;
a30=a30-a42;
a42=arg[19]? arg[19][0] : 0;
a30=a30+a42;
a33=a33?a30:0;
a30=a41?a40:0;
a21=a21/a39;
a21=a21*a40;
a38=a38?a21:0;
a21=arg[20]? arg[20][0] : 0;
a38=a38-a21;
a30=a30+a38;
a35=a35?a30:0;
a33=a33+a35;
a33=a07*a33;
a36=2.*a36;
a33=a33/a36;
a25=a25*a33;
a32=a32*a25;
a37=a37+a32;
a32=a37/a20;
a01=a01*a32;
a33=a18/a20;
a36=a05*a27;
a36=a22?a36:0;
a40=a07*a40;
a40=-a40;
a41=a41?a40:0;
a29=a29/a28;
a26=a26*a29;
a41=a41-a26;
a38=a07*a38;
a41=a41+a38;
a36=a36+a41;
a34=2.*a34;
a34=a34*a25;
a36=a36-a34;
a33=a33*a36;
a38=a24/a20;
a38=a38*a37;
a33=a33+a38;
a38=a00*a33;
a01=a01-a38;
if (res[0]!=0) res[0][0]=a01;
a05=a05/a17;
a18=a18*a27;
a18=a22?a18:0;
a18=a18+a41;
a18=a18+a34;
a05=a05*a18;
a23=a23/a17;
a27=a24*a27;
a27=-a27;
a22=a22?a27:0;
a24=a24*a25;
a31=a31*a24;
a22=a22+a31;
a23=a23*a22;
a05=a05+a23;
a23=a00*a05;
a23=-a23;
if (res[1]!=0) res[1][0]=a23;
a23=2.*a03;
a18=a18/a17;
a31=a02*a18;
a23=a23*a31;
a22=a22/a17;
a22=a32+a22;
a02=a02*a22;
a23=a23+a02;
if (res[2]!=0) res[2][0]=a23;
a23=2.*a14;
a02=a06*a18;
a23=a23*a02;
a06=a06*a22;
a23=a23-a06;
if (res[3]!=0) res[3][0]=a23;
a23=2.*a00;
a32=a19*a32;
a23=a23*a32;
a19=a19*a33;
a23=a23-a19;
a16=a16*a05;
a23=a23-a16;
a00=2.*a00;
a36=a36/a20;
a15=a15*a18;
a15=a36+a15;
a14=a14*a22;
a15=a15-a14;
a12=a12*a15;
a00=a00*a12;
a23=a23+a00;
if (res[4]!=0) res[4][0]=a23;
a13=a13*a15;
a10=a10*a13;
if (res[5]!=0) res[5][0]=a10;
a11=a11*a13;
a09=a09*a11;
a07=a07*a09;
if (res[6]!=0) res[6][0]=a07;
a08=a08*a11;
if (res[7]!=0) res[7][0]=a08;
a04=a04*a18;
a36=a36+a04;
a03=a03*a22;
a36=a36+a03;
a36=2.*a36;
if (res[8]!=0) res[8][0]=a36;
if (res[9]!=0) res[9][0]=a15;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_linear_modes(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f14(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_linear_modes_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_linear_modes_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_linear_modes_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_linear_modes_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_linear_modes_n_in(void) { return 26;}
CASADI_SYMBOL_EXPORT casadi_int adj1_linear_modes_n_out(void) { return 10;}
CASADI_SYMBOL_EXPORT casadi_real adj1_linear_modes_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_linear_modes_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "Izz";
case 2: return "a";
case 3: return "b";
case 4: return "u";
case 5: return "rho";
case 6: return "Ap";
case 7: return "CL_gamma";
case 8: return "C_alpha";
case 9: return "Ct";
case 10: return "out_re_1";
case 11: return "out_im_1";
case 12: return "out_re_2";
case 13: return "out_im_2";
case 14: return "out_decay_rate";
case 15: return "out_natural_frequency";
case 16: return "out_damped_frequency";
case 17: return "out_damping_ratio";
case 18: return "adj_re_1";
case 19: return "adj_im_1";
case 20: return "adj_re_2";
case 21: return "adj_im_2";
case 22: return "adj_decay_rate";
case 23: return "adj_natural_frequency";
case 24: return "adj_damped_frequency";
case 25: return "adj_damping_ratio";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_linear_modes_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_m";
case 1: return "adj_Izz";
case 2: return "adj_a";
case 3: return "adj_b";
case 4: return "adj_u";
case 5: return "adj_rho";
case 6: return "adj_Ap";
case 7: return "adj_CL_gamma";
case 8: return "adj_C_alpha";
case 9: return "adj_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_linear_modes_sparsity_in(casadi_int i) {
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
case 10: return casadi_s1;
case 11: return casadi_s1;
case 12: return casadi_s1;
case 13: return casadi_s1;
case 14: return casadi_s1;
case 15: return casadi_s1;
case 16: return casadi_s1;
case 17: return casadi_s1;
case 18: return casadi_s0;
case 19: return casadi_s0;
case 20: return casadi_s0;
case 21: return casadi_s0;
case 22: return casadi_s0;
case 23: return casadi_s0;
case 24: return casadi_s0;
case 25: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_linear_modes_sparsity_out(casadi_int i) {
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
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_linear_modes_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 26;
if (sz_res) *sz_res = 10;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_linear_modes_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 26*sizeof(const casadi_real*);
if (sz_res) *sz_res = 10*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_linear_modes:(m,Izz,a,b,u,rho,Ap,CL_gamma,C_alpha,Ct,out_re_1[1x1,0nz],out_im_1[1x1,0nz],out_re_2[1x1,0nz],out_im_2[1x1,0nz],out_decay_rate[1x1,0nz],out_natural_frequency[1x1,0nz],out_damped_frequency[1x1,0nz],out_damping_ratio[1x1,0nz],adj_re_1,adj_im_1,adj_re_2,adj_im_2,adj_decay_rate,adj_natural_frequency,adj_damped_frequency,adj_damping_ratio,out_adj_m[1x1,0nz],out_adj_Izz[1x1,0nz],out_adj_a[1x1,0nz],out_adj_b[1x1,0nz],out_adj_u[1x1,0nz],out_adj_rho[1x1,0nz],out_adj_Ap[1x1,0nz],out_adj_CL_gamma[1x1,0nz],out_adj_C_alpha[1x1,0nz],out_adj_Ct[1x1,0nz],fwd_m,fwd_Izz,fwd_a,fwd_b,fwd_u,fwd_rho,fwd_Ap,fwd_CL_gamma,fwd_C_alpha,fwd_Ct,fwd_out_re_1[1x1,0nz],fwd_out_im_1[1x1,0nz],fwd_out_re_2[1x1,0nz],fwd_out_im_2[1x1,0nz],fwd_out_decay_rate[1x1,0nz],fwd_out_natural_frequency[1x1,0nz],fwd_out_damped_frequency[1x1,0nz],fwd_out_damping_ratio[1x1,0nz],fwd_adj_re_1,fwd_adj_im_1,fwd_adj_re_2,fwd_adj_im_2,fwd_adj_decay_rate,fwd_adj_natural_frequency,fwd_adj_damped_frequency,fwd_adj_damping_ratio)->(fwd_adj_m,fwd_adj_Izz,fwd_adj_a,fwd_adj_b,fwd_adj_u,fwd_adj_rho,fwd_adj_Ap,fwd_adj_CL_gamma,fwd_adj_C_alpha,fwd_adj_Ct) */
static int casadi_f15(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
casadi_real a72, a73, a74, a75, a76, a77, a78, a79, a80, a81, a82;
a00=arg[8]? arg[8][0] : 0;
a00=2.*a00;
a01=arg[2]? arg[2][0] : 0;
a02=casadi_sq(a01);
a03=a00*a02;
a04=arg[9]? arg[9][0] : 0;
a05=5.0000000000000000e-01;
a06=arg[6]? arg[6][0] : 0;
a06=a05*a06;
a07=arg[7]? arg[7][0] : 0;
a08=a06*a07;
a09=arg[5]? arg[5][0] : 0;
a10=a08*a09;
a11=arg[4]? arg[4][0] : 0;
a12=casadi_sq(a11);
a13=a10*a12;
a04=a04+a13;
a13=arg[3]? arg[3][0] : 0;
a14=casadi_sq(a13);
a15=a04*a14;
a03=a03+a15;
a15=arg[1]? arg[1][0] : 0;
a16=a15*a11;
a03=a03/a16;
a17=a00+a04;
a18=arg[0]? arg[0][0] : 0;
a19=a18*a11;
a17=a17/a19;
a20=a03*a17;
a21=a00*a01;
a22=a04*a13;
a21=a21-a22;
a22=a21/a16;
a23=casadi_sq(a11);
a24=a18*a23;
a24=a24+a21;
a24=a24/a19;
a21=a22*a24;
a20=a20-a21;
a21=casadi_fabs(a20);
a25=3.5527136788005009e-15;
a26=a03*a17;
a26=casadi_fabs(a26);
a26=a25*a26;
a27=a22*a24;
a27=casadi_fabs(a27);
a25=a25*a27;
a26=a26+a25;
a21=a21<a26;
a21=!a21;
a26=-5.0000000000000000e-01;
a25=a03+a17;
a27=a26*a25;
a20=a21?a20:0;
a28=sqrt(a20);
a27=a27/a28;
a29=a27/a28;
a30=arg[25]? arg[25][0] : 0;
a31=a29*a30;
a32=arg[23]? arg[23][0] : 0;
a31=a31+a32;
a32=2.*a28;
a31=a31/a32;
a33=0.;
a34=4.;
a35=a34*a22;
a36=a35*a24;
a37=a03-a17;
a38=casadi_sq(a37);
a36=a36+a38;
a38=a33<a36;
a39=casadi_fabs(a36);
a39=sqrt(a39);
a40=a05*a39;
a41=a40*a25;
a41=-a41;
a41=a38?a41:0;
a42=-2.5000000000000000e-01;
a43=casadi_sq(a25);
a42=a42*a43;
a41=a41<a42;
a40=a38?a40:0;
a42=a05*a25;
a42=a40+a42;
a20=a20/a42;
a43=-a20;
a43=a41?a43:0;
a44=!a41;
a25=a05*a25;
a40=a40-a25;
a40=a44?a40:0;
a43=a43+a40;
a43=casadi_fabs(a43);
a43=a43<=a33;
a43=!a43;
a40=arg[22]? arg[22][0] : 0;
a40=-a40;
a40=a43?a40:0;
a25=arg[18]? arg[18][0] : 0;
a40=a40+a25;
a25=a40/a42;
a45=-a25;
a45=a41?a45:0;
a45=a31+a45;
a46=a22*a45;
a46=-a46;
a46=a21?a46:0;
a47=casadi_sign(a36);
a33=a36<a33;
a48=arg[24]? arg[24][0] : 0;
a49=arg[21]? arg[21][0] : 0;
a48=a48-a49;
a49=arg[19]? arg[19][0] : 0;
a48=a48+a49;
a48=a33?a48:0;
a49=a44?a40:0;
a50=a20/a42;
a51=a50*a40;
a51=a41?a51:0;
a52=arg[20]? arg[20][0] : 0;
a51=a51-a52;
a49=a49+a51;
a49=a38?a49:0;
a48=a48+a49;
a48=a05*a48;
a49=2.*a39;
a48=a48/a49;
a52=a47*a48;
a53=a35*a52;
a46=a46+a53;
a53=a46/a19;
a54=2.*a11;
a55=arg[40]? arg[40][0] : 0;
a54=a54*a55;
a56=a53*a54;
a57=arg[44]? arg[44][0] : 0;
a57=2.*a57;
a58=a01*a57;
a59=arg[38]? arg[38][0] : 0;
a60=a00*a59;
a58=a58+a60;
a60=arg[45]? arg[45][0] : 0;
a61=arg[42]? arg[42][0] : 0;
a61=a05*a61;
a62=a07*a61;
a63=arg[43]? arg[43][0] : 0;
a64=a06*a63;
a62=a62+a64;
a64=a09*a62;
a65=arg[41]? arg[41][0] : 0;
a66=a08*a65;
a64=a64+a66;
a66=a12*a64;
a67=2.*a11;
a67=a67*a55;
a68=a10*a67;
a66=a66+a68;
a60=a60+a66;
a66=a13*a60;
a68=arg[39]? arg[39][0] : 0;
a69=a04*a68;
a66=a66+a69;
a58=a58-a66;
a66=a58/a16;
a69=a22/a16;
a70=arg[37]? arg[37][0] : 0;
a71=a11*a70;
a72=a15*a55;
a71=a71+a72;
a69=a69*a71;
a66=a66-a69;
a69=a45*a66;
a72=a02*a57;
a73=2.*a01;
a73=a73*a59;
a74=a00*a73;
a72=a72+a74;
a74=a14*a60;
a75=2.*a13;
a75=a75*a68;
a76=a04*a75;
a74=a74+a76;
a72=a72+a74;
a72=a72/a16;
a74=a03/a16;
a74=a74*a71;
a72=a72-a74;
a74=a57+a60;
a74=a74/a19;
a76=a17/a19;
a77=arg[36]? arg[36][0] : 0;
a78=a11*a77;
a79=a18*a55;
a78=a78+a79;
a76=a76*a78;
a74=a74-a76;
a76=a72+a74;
a79=a26*a76;
a79=a79/a28;
a27=a27/a28;
a80=a17*a72;
a81=a03*a74;
a80=a80+a81;
a81=a24*a66;
a82=a23*a77;
a54=a18*a54;
a82=a82+a54;
a82=a82+a58;
a82=a82/a19;
a58=a24/a19;
a58=a58*a78;
a82=a82-a58;
a58=a22*a82;
a81=a81+a58;
a80=a80-a81;
a81=2.*a28;
a81=a80/a81;
a27=a27*a81;
a27=-a27;
a27=a21?a27:0;
a79=a79+a27;
a79=a79/a28;
a27=a29/a28;
a27=a27*a81;
a27=-a27;
a27=a21?a27:0;
a79=a79+a27;
a79=a30*a79;
a27=arg[61]? arg[61][0] : 0;
a29=a29*a27;
a79=a79+a29;
a29=arg[59]? arg[59][0] : 0;
a79=a79+a29;
a79=a79/a32;
a31=a31/a32;
a32=2.*a81;
a31=a31*a32;
a31=-a31;
a31=a21?a31:0;
a79=a79+a31;
a31=arg[58]? arg[58][0] : 0;
a31=-a31;
a43=a43?a31:0;
a31=arg[54]? arg[54][0] : 0;
a43=a43+a31;
a31=a43/a42;
a25=a25/a42;
a36=casadi_sign(a36);
a32=a34*a66;
a29=a24*a32;
a58=a35*a82;
a29=a29+a58;
a58=2.*a37;
a54=a72-a74;
a58=a58*a54;
a29=a29+a58;
a36=a36*a29;
a39=2.*a39;
a36=a36/a39;
a39=a05*a36;
a39=a38?a39:0;
a76=a05*a76;
a39=a39+a76;
a25=a25*a39;
a31=a31-a25;
a31=-a31;
a31=a41?a31:0;
a79=a79+a31;
a31=a22*a79;
a69=a69+a31;
a69=-a69;
a69=a21?a69:0;
a32=a52*a32;
a31=arg[60]? arg[60][0] : 0;
a25=arg[57]? arg[57][0] : 0;
a31=a31-a25;
a25=arg[55]? arg[55][0] : 0;
a31=a31+a25;
a33=a33?a31:0;
a31=a44?a43:0;
a80=a80/a42;
a80=a21?a80:0;
a20=a20/a42;
a20=a20*a39;
a80=a80-a20;
a80=a80/a42;
a42=a50/a42;
a42=a42*a39;
a80=a80-a42;
a80=a40*a80;
a50=a50*a43;
a80=a80+a50;
a41=a41?a80:0;
a80=arg[56]? arg[56][0] : 0;
a41=a41-a80;
a31=a31+a41;
a38=a38?a31:0;
a33=a33+a38;
a33=a05*a33;
a33=a33/a49;
a48=a48/a49;
a36=2.*a36;
a48=a48*a36;
a33=a33-a48;
a47=a47*a33;
a35=a35*a47;
a32=a32+a35;
a69=a69+a32;
a32=a69/a19;
a35=a53/a19;
a35=a35*a78;
a32=a32-a35;
a23=a23*a32;
a56=a56+a23;
a23=a17/a19;
a35=a03*a45;
a35=a21?a35:0;
a40=a05*a40;
a40=-a40;
a40=a44?a40:0;
a30=a30/a28;
a33=a26*a30;
a40=a40-a33;
a51=a05*a51;
a40=a40+a51;
a35=a35+a40;
a37=2.*a37;
a51=a37*a52;
a35=a35-a51;
a33=a23*a35;
a48=a24/a19;
a36=a48*a46;
a33=a33+a36;
a36=a33*a55;
a49=a74/a19;
a38=a23/a19;
a38=a38*a78;
a49=a49-a38;
a49=a35*a49;
a38=a45*a72;
a31=a03*a79;
a38=a38+a31;
a38=a21?a38:0;
a43=a05*a43;
a43=-a43;
a44=a44?a43:0;
a27=a27/a28;
a30=a30/a28;
a30=a30*a81;
a30=-a30;
a30=a21?a30:0;
a27=a27+a30;
a26=a26*a27;
a44=a44-a26;
a41=a05*a41;
a44=a44+a41;
a38=a38+a44;
a54=2.*a54;
a54=a52*a54;
a37=a37*a47;
a54=a54+a37;
a38=a38-a54;
a23=a23*a38;
a49=a49+a23;
a23=a82/a19;
a37=a48/a19;
a37=a37*a78;
a23=a23-a37;
a46=a46*a23;
a48=a48*a69;
a46=a46+a48;
a49=a49+a46;
a46=a11*a49;
a36=a36+a46;
a56=a56-a36;
if (res[0]!=0) res[0][0]=a56;
a03=a03/a16;
a56=a17*a45;
a56=a21?a56:0;
a56=a56+a40;
a56=a56+a51;
a51=a03*a56;
a22=a22/a16;
a40=a24*a45;
a40=-a40;
a40=a21?a40:0;
a36=a24*a52;
a36=a34*a36;
a40=a40+a36;
a36=a22*a40;
a51=a51+a36;
a36=a51*a55;
a72=a72/a16;
a46=a03/a16;
a46=a46*a71;
a72=a72-a46;
a72=a56*a72;
a74=a45*a74;
a17=a17*a79;
a74=a74+a17;
a74=a21?a74:0;
a74=a74+a44;
a74=a74+a54;
a03=a03*a74;
a72=a72+a03;
a66=a66/a16;
a03=a22/a16;
a03=a03*a71;
a66=a66-a03;
a66=a40*a66;
a45=a45*a82;
a79=a24*a79;
a45=a45+a79;
a45=-a45;
a21=a21?a45:0;
a52=a52*a82;
a24=a24*a47;
a52=a52+a24;
a34=a34*a52;
a21=a21+a34;
a22=a22*a21;
a66=a66+a22;
a72=a72+a66;
a66=a11*a72;
a36=a36+a66;
a36=-a36;
if (res[1]!=0) res[1][0]=a36;
a56=a56/a16;
a36=a00*a56;
a66=2.*a59;
a36=a36*a66;
a66=2.*a01;
a22=a56*a57;
a74=a74/a16;
a34=a56/a16;
a34=a34*a71;
a74=a74-a34;
a34=a00*a74;
a22=a22+a34;
a66=a66*a22;
a36=a36+a66;
a40=a40/a16;
a66=a53+a40;
a57=a66*a57;
a21=a21/a16;
a40=a40/a16;
a40=a40*a71;
a21=a21-a40;
a21=a32+a21;
a00=a00*a21;
a57=a57+a00;
a36=a36+a57;
if (res[2]!=0) res[2][0]=a36;
a36=a04*a56;
a57=2.*a68;
a36=a36*a57;
a57=2.*a13;
a00=a56*a60;
a40=a04*a74;
a00=a00+a40;
a57=a57*a00;
a36=a36+a57;
a60=a66*a60;
a04=a04*a21;
a60=a60+a04;
a36=a36-a60;
if (res[3]!=0) res[3][0]=a36;
a36=a18*a53;
a60=2.*a55;
a36=a36*a60;
a60=2.*a11;
a53=a53*a77;
a32=a18*a32;
a53=a53+a32;
a60=a60*a53;
a36=a36+a60;
a33=a33*a77;
a18=a18*a49;
a33=a33+a18;
a36=a36-a33;
a51=a51*a70;
a15=a15*a72;
a51=a51+a15;
a36=a36-a51;
a35=a35/a19;
a51=a14*a56;
a51=a35+a51;
a15=a13*a66;
a51=a51-a15;
a15=a10*a51;
a55=2.*a55;
a15=a15*a55;
a11=2.*a11;
a64=a51*a64;
a38=a38/a19;
a35=a35/a19;
a35=a35*a78;
a38=a38-a35;
a75=a56*a75;
a14=a14*a74;
a75=a75+a14;
a75=a38+a75;
a68=a66*a68;
a13=a13*a21;
a68=a68+a13;
a75=a75-a68;
a10=a10*a75;
a64=a64+a10;
a11=a11*a64;
a15=a15+a11;
a36=a36+a15;
if (res[4]!=0) res[4][0]=a36;
a36=a12*a51;
a62=a36*a62;
a51=a51*a67;
a12=a12*a75;
a51=a51+a12;
a08=a08*a51;
a62=a62+a08;
if (res[5]!=0) res[5][0]=a62;
a62=a09*a36;
a63=a62*a63;
a36=a36*a65;
a09=a09*a51;
a36=a36+a09;
a07=a07*a36;
a63=a63+a07;
a05=a05*a63;
if (res[6]!=0) res[6][0]=a05;
a62=a62*a61;
a06=a06*a36;
a62=a62+a06;
if (res[7]!=0) res[7][0]=a62;
a56=a56*a73;
a02=a02*a74;
a56=a56+a02;
a38=a38+a56;
a66=a66*a59;
a01=a01*a21;
a66=a66+a01;
a38=a38+a66;
a38=2.*a38;
if (res[8]!=0) res[8][0]=a38;
if (res[9]!=0) res[9][0]=a75;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_linear_modes(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f15(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_linear_modes_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_linear_modes_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_linear_modes_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_linear_modes_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_linear_modes_n_in(void) { return 62;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_linear_modes_n_out(void) { return 10;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_linear_modes_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_linear_modes_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "Izz";
case 2: return "a";
case 3: return "b";
case 4: return "u";
case 5: return "rho";
case 6: return "Ap";
case 7: return "CL_gamma";
case 8: return "C_alpha";
case 9: return "Ct";
case 10: return "out_re_1";
case 11: return "out_im_1";
case 12: return "out_re_2";
case 13: return "out_im_2";
case 14: return "out_decay_rate";
case 15: return "out_natural_frequency";
case 16: return "out_damped_frequency";
case 17: return "out_damping_ratio";
case 18: return "adj_re_1";
case 19: return "adj_im_1";
case 20: return "adj_re_2";
case 21: return "adj_im_2";
case 22: return "adj_decay_rate";
case 23: return "adj_natural_frequency";
case 24: return "adj_damped_frequency";
case 25: return "adj_damping_ratio";
case 26: return "out_adj_m";
case 27: return "out_adj_Izz";
case 28: return "out_adj_a";
case 29: return "out_adj_b";
case 30: return "out_adj_u";
case 31: return "out_adj_rho";
case 32: return "out_adj_Ap";
case 33: return "out_adj_CL_gamma";
case 34: return "out_adj_C_alpha";
case 35: return "out_adj_Ct";
case 36: return "fwd_m";
case 37: return "fwd_Izz";
case 38: return "fwd_a";
case 39: return "fwd_b";
case 40: return "fwd_u";
case 41: return "fwd_rho";
case 42: return "fwd_Ap";
case 43: return "fwd_CL_gamma";
case 44: return "fwd_C_alpha";
case 45: return "fwd_Ct";
case 46: return "fwd_out_re_1";
case 47: return "fwd_out_im_1";
case 48: return "fwd_out_re_2";
case 49: return "fwd_out_im_2";
case 50: return "fwd_out_decay_rate";
case 51: return "fwd_out_natural_frequency";
case 52: return "fwd_out_damped_frequency";
case 53: return "fwd_out_damping_ratio";
case 54: return "fwd_adj_re_1";
case 55: return "fwd_adj_im_1";
case 56: return "fwd_adj_re_2";
case 57: return "fwd_adj_im_2";
case 58: return "fwd_adj_decay_rate";
case 59: return "fwd_adj_natural_frequency";
case 60: return "fwd_adj_damped_frequency";
case 61: return "fwd_adj_damping_ratio";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_linear_modes_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_m";
case 1: return "fwd_adj_Izz";
case 2: return "fwd_adj_a";
case 3: return "fwd_adj_b";
case 4: return "fwd_adj_u";
case 5: return "fwd_adj_rho";
case 6: return "fwd_adj_Ap";
case 7: return "fwd_adj_CL_gamma";
case 8: return "fwd_adj_C_alpha";
case 9: return "fwd_adj_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_linear_modes_sparsity_in(casadi_int i) {
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
case 10: return casadi_s1;
case 11: return casadi_s1;
case 12: return casadi_s1;
case 13: return casadi_s1;
case 14: return casadi_s1;
case 15: return casadi_s1;
case 16: return casadi_s1;
case 17: return casadi_s1;
case 18: return casadi_s0;
case 19: return casadi_s0;
case 20: return casadi_s0;
case 21: return casadi_s0;
case 22: return casadi_s0;
case 23: return casadi_s0;
case 24: return casadi_s0;
case 25: return casadi_s0;
case 26: return casadi_s1;
case 27: return casadi_s1;
case 28: return casadi_s1;
case 29: return casadi_s1;
case 30: return casadi_s1;
case 31: return casadi_s1;
case 32: return casadi_s1;
case 33: return casadi_s1;
case 34: return casadi_s1;
case 35: return casadi_s1;
case 36: return casadi_s0;
case 37: return casadi_s0;
case 38: return casadi_s0;
case 39: return casadi_s0;
case 40: return casadi_s0;
case 41: return casadi_s0;
case 42: return casadi_s0;
case 43: return casadi_s0;
case 44: return casadi_s0;
case 45: return casadi_s0;
case 46: return casadi_s1;
case 47: return casadi_s1;
case 48: return casadi_s1;
case 49: return casadi_s1;
case 50: return casadi_s1;
case 51: return casadi_s1;
case 52: return casadi_s1;
case 53: return casadi_s1;
case 54: return casadi_s0;
case 55: return casadi_s0;
case 56: return casadi_s0;
case 57: return casadi_s0;
case 58: return casadi_s0;
case 59: return casadi_s0;
case 60: return casadi_s0;
case 61: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_linear_modes_sparsity_out(casadi_int i) {
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
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_linear_modes_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 62;
if (sz_res) *sz_res = 10;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_linear_modes_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 62*sizeof(const casadi_real*);
if (sz_res) *sz_res = 10*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* times:(decay_rate)->(T_half,T_double) */
static int casadi_f16(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2;
a0=1.3862943611198906e+00;
a1=arg[0]? arg[0][0] : 0;
a2=casadi_fabs(a1);
a2=a1+a2;
a2=a0/a2;
if (res[0]!=0) res[0][0]=a2;
a2=casadi_fabs(a1);
a2=a2-a1;
a0=a0/a2;
if (res[1]!=0) res[1][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int times(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f16(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int times_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void times_release(int mem) {
}
CASADI_SYMBOL_EXPORT void times_incref(void) {
}
CASADI_SYMBOL_EXPORT void times_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int times_n_in(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_int times_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real times_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* times_name_in(casadi_int i) {
switch (i) {
case 0: return "decay_rate";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* times_name_out(casadi_int i) {
switch (i) {
case 0: return "T_half";
case 1: return "T_double";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* times_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* times_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int times_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 1;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int times_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 1*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_times:(decay_rate,out_T_half[1x1,0nz],out_T_double[1x1,0nz],fwd_decay_rate)->(fwd_T_half,fwd_T_double) */
static int casadi_f17(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4;
a0=1.3862943611198906e+00;
a1=arg[0]? arg[0][0] : 0;
a2=casadi_fabs(a1);
a2=a1+a2;
a3=a0/a2;
a3=a3/a2;
a2=arg[3]? arg[3][0] : 0;
a4=casadi_sign(a1);
a4=a4*a2;
a4=a2+a4;
a3=a3*a4;
a3=-a3;
if (res[0]!=0) res[0][0]=a3;
a3=casadi_fabs(a1);
a3=a3-a1;
a0=a0/a3;
a0=a0/a3;
a1=casadi_sign(a1);
a1=a1*a2;
a1=a1-a2;
a0=a0*a1;
a0=-a0;
if (res[1]!=0) res[1][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_times(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f17(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_times_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_times_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_times_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_times_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_times_n_in(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_times_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_times_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_times_name_in(casadi_int i) {
switch (i) {
case 0: return "decay_rate";
case 1: return "out_T_half";
case 2: return "out_T_double";
case 3: return "fwd_decay_rate";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_times_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_T_half";
case 1: return "fwd_T_double";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_times_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s1;
case 2: return casadi_s1;
case 3: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_times_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_times_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 4;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_times_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 4*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_times:(decay_rate,out_T_half[1x1,0nz],out_T_double[1x1,0nz],adj_T_half,adj_T_double)->(adj_decay_rate) */
static int casadi_f18(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3;
a0=1.3862943611198906e+00;
a1=arg[0]? arg[0][0] : 0;
a2=casadi_fabs(a1);
a2=a2-a1;
a3=a0/a2;
a3=a3/a2;
a2=arg[4]? arg[4][0] : 0;
a3=a3*a2;
a2=casadi_sign(a1);
a2=a2*a3;
a3=a3-a2;
a2=casadi_fabs(a1);
a2=a1+a2;
a0=a0/a2;
a0=a0/a2;
a2=arg[3]? arg[3][0] : 0;
a0=a0*a2;
a3=a3-a0;
a1=casadi_sign(a1);
a1=a1*a0;
a3=a3-a1;
if (res[0]!=0) res[0][0]=a3;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_times(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f18(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_times_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_times_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_times_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_times_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_times_n_in(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_int adj1_times_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real adj1_times_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_times_name_in(casadi_int i) {
switch (i) {
case 0: return "decay_rate";
case 1: return "out_T_half";
case 2: return "out_T_double";
case 3: return "adj_T_half";
case 4: return "adj_T_double";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_times_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_decay_rate";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_times_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s1;
case 2: return casadi_s1;
case 3: return casadi_s0;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_times_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_times_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_times_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_times:(decay_rate,out_T_half[1x1,0nz],out_T_double[1x1,0nz],adj_T_half,adj_T_double,out_adj_decay_rate[1x1,0nz],fwd_decay_rate,fwd_out_T_half[1x1,0nz],fwd_out_T_double[1x1,0nz],fwd_adj_T_half,fwd_adj_T_double)->(fwd_adj_decay_rate) */
static int casadi_f19(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5, a6, a7, a8;
a0=1.3862943611198906e+00;
a1=arg[0]? arg[0][0] : 0;
a2=casadi_fabs(a1);
a2=a2-a1;
a3=a0/a2;
a4=a3/a2;
a5=arg[10]? arg[10][0] : 0;
a5=a4*a5;
a6=arg[4]? arg[4][0] : 0;
a3=a3/a2;
a7=casadi_sign(a1);
a8=arg[6]? arg[6][0] : 0;
a7=a7*a8;
a7=a7-a8;
a3=a3*a7;
a3=a3/a2;
a4=a4/a2;
a4=a4*a7;
a3=a3+a4;
a6=a6*a3;
a5=a5-a6;
a6=casadi_sign(a1);
a6=a6*a5;
a5=a5-a6;
a6=casadi_fabs(a1);
a6=a1+a6;
a0=a0/a6;
a3=a0/a6;
a4=arg[9]? arg[9][0] : 0;
a4=a3*a4;
a7=arg[3]? arg[3][0] : 0;
a0=a0/a6;
a2=casadi_sign(a1);
a2=a2*a8;
a8=a8+a2;
a0=a0*a8;
a0=a0/a6;
a3=a3/a6;
a3=a3*a8;
a0=a0+a3;
a7=a7*a0;
a4=a4-a7;
a5=a5-a4;
a1=casadi_sign(a1);
a1=a1*a4;
a5=a5-a1;
if (res[0]!=0) res[0][0]=a5;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_times(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f19(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_times_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_times_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_times_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_times_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_times_n_in(void) { return 11;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_times_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_times_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_times_name_in(casadi_int i) {
switch (i) {
case 0: return "decay_rate";
case 1: return "out_T_half";
case 2: return "out_T_double";
case 3: return "adj_T_half";
case 4: return "adj_T_double";
case 5: return "out_adj_decay_rate";
case 6: return "fwd_decay_rate";
case 7: return "fwd_out_T_half";
case 8: return "fwd_out_T_double";
case 9: return "fwd_adj_T_half";
case 10: return "fwd_adj_T_double";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_times_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_decay_rate";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_times_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s1;
case 2: return casadi_s1;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s1;
case 6: return casadi_s0;
case 7: return casadi_s1;
case 8: return casadi_s1;
case 9: return casadi_s0;
case 10: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_times_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_times_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 11;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_times_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 11*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* speed_window:(m,a,b,rho,Ap,CL_gamma,C_alpha,Ct)->(u_low,u_high) */
static int casadi_f20(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12;
a00=1.4142135623730951e+00;
a01=arg[6]? arg[6][0] : 0;
a02=2.*a01;
a03=arg[7]? arg[7][0] : 0;
a04=a02*a03;
a05=arg[1]? arg[1][0] : 0;
a06=arg[2]? arg[2][0] : 0;
a07=a05+a06;
a07=casadi_sq(a07);
a04=a04*a07;
a07=-4.;
a07=a07*a04;
a08=5.0000000000000000e-01;
a09=arg[4]? arg[4][0] : 0;
a08=a08*a09;
a09=arg[5]? arg[5][0] : 0;
a08=a08*a09;
a09=arg[3]? arg[3][0] : 0;
a08=a08*a09;
a09=a06*a08;
a10=arg[0]? arg[0][0] : 0;
a09=a09*a10;
a07=a07*a09;
a11=casadi_sq(a05);
a11=a02*a11;
a11=a11*a08;
a12=4.;
a12=a12*a01;
a12=a12*a05;
a12=a12*a06;
a12=a12*a08;
a11=a11+a12;
a05=a02*a05;
a05=a05*a10;
a11=a11-a05;
a05=casadi_sq(a06);
a02=a02*a05;
a02=a02*a08;
a11=a11+a02;
a03=a03*a06;
a03=a03*a10;
a11=a11+a03;
a03=casadi_sq(a11);
a07=a07+a03;
a07=sqrt(a07);
a07=a07-a11;
a04=a04*a07;
a04=sqrt(a04);
a00=a00*a04;
a00=a00/a07;
if (res[0]!=0) res[0][0]=a00;
a00=7.0710678118654757e-01;
a00=a00*a07;
a09=a09*a07;
a09=sqrt(a09);
a00=a00/a09;
if (res[1]!=0) res[1][0]=a00;
return 0;
}
CASADI_SYMBOL_EXPORT int speed_window(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f20(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int speed_window_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void speed_window_release(int mem) {
}
CASADI_SYMBOL_EXPORT void speed_window_incref(void) {
}
CASADI_SYMBOL_EXPORT void speed_window_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int speed_window_n_in(void) { return 8;}
CASADI_SYMBOL_EXPORT casadi_int speed_window_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real speed_window_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* speed_window_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "a";
case 2: return "b";
case 3: return "rho";
case 4: return "Ap";
case 5: return "CL_gamma";
case 6: return "C_alpha";
case 7: return "Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* speed_window_name_out(casadi_int i) {
switch (i) {
case 0: return "u_low";
case 1: return "u_high";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* speed_window_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* speed_window_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int speed_window_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 8;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int speed_window_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 8*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_speed_window:(m,a,b,rho,Ap,CL_gamma,C_alpha,Ct,out_u_low[1x1,0nz],out_u_high[1x1,0nz],fwd_m,fwd_a,fwd_b,fwd_rho,fwd_Ap,fwd_CL_gamma,fwd_C_alpha,fwd_Ct)->(fwd_u_low,fwd_u_high) */
static int casadi_f21(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38;
a00=1.4142135623730951e+00;
a01=-4.;
a02=arg[6]? arg[6][0] : 0;
a03=2.*a02;
a04=arg[7]? arg[7][0] : 0;
a05=a03*a04;
a06=arg[1]? arg[1][0] : 0;
a07=arg[2]? arg[2][0] : 0;
a08=a06+a07;
a09=casadi_sq(a08);
a10=a05*a09;
a11=a01*a10;
a12=5.0000000000000000e-01;
a13=arg[4]? arg[4][0] : 0;
a13=a12*a13;
a14=arg[5]? arg[5][0] : 0;
a15=a13*a14;
a16=arg[3]? arg[3][0] : 0;
a17=a15*a16;
a18=a07*a17;
a19=arg[0]? arg[0][0] : 0;
a20=a18*a19;
a21=a11*a20;
a22=casadi_sq(a06);
a23=a03*a22;
a24=a23*a17;
a25=4.;
a02=a25*a02;
a26=a02*a06;
a27=a26*a07;
a28=a27*a17;
a24=a24+a28;
a28=a03*a06;
a29=a28*a19;
a24=a24-a29;
a29=casadi_sq(a07);
a30=a03*a29;
a31=a30*a17;
a24=a24+a31;
a31=a04*a07;
a32=a31*a19;
a24=a24+a32;
a32=casadi_sq(a24);
a21=a21+a32;
a21=sqrt(a21);
a32=a21-a24;
a33=arg[16]? arg[16][0] : 0;
a34=2.*a33;
a35=a04*a34;
a36=arg[17]? arg[17][0] : 0;
a37=a03*a36;
a35=a35+a37;
a09=a09*a35;
a08=2.*a08;
a35=arg[11]? arg[11][0] : 0;
a37=arg[12]? arg[12][0] : 0;
a38=a35+a37;
a08=a08*a38;
a05=a05*a08;
a09=a09+a05;
a05=a32*a09;
a01=a01*a09;
a01=a20*a01;
a09=a17*a37;
a08=arg[14]? arg[14][0] : 0;
a12=a12*a08;
a14=a14*a12;
a12=arg[15]? arg[15][0] : 0;
a13=a13*a12;
a14=a14+a13;
a16=a16*a14;
a14=arg[13]? arg[13][0] : 0;
a15=a15*a14;
a16=a16+a15;
a15=a07*a16;
a09=a09+a15;
a09=a19*a09;
a15=arg[10]? arg[10][0] : 0;
a18=a18*a15;
a09=a09+a18;
a11=a11*a09;
a01=a01+a11;
a24=2.*a24;
a22=a22*a34;
a11=2.*a06;
a11=a11*a35;
a11=a03*a11;
a22=a22+a11;
a22=a17*a22;
a23=a23*a16;
a22=a22+a23;
a25=a25*a33;
a25=a06*a25;
a02=a02*a35;
a25=a25+a02;
a25=a07*a25;
a26=a26*a37;
a25=a25+a26;
a25=a17*a25;
a27=a27*a16;
a25=a25+a27;
a22=a22+a25;
a06=a06*a34;
a35=a03*a35;
a06=a06+a35;
a06=a19*a06;
a28=a28*a15;
a06=a06+a28;
a22=a22-a06;
a29=a29*a34;
a34=2.*a07;
a34=a34*a37;
a03=a03*a34;
a29=a29+a03;
a17=a17*a29;
a30=a30*a16;
a17=a17+a30;
a22=a22+a17;
a07=a07*a36;
a04=a04*a37;
a07=a07+a04;
a19=a19*a07;
a31=a31*a15;
a19=a19+a31;
a22=a22+a19;
a24=a24*a22;
a01=a01+a24;
a21=2.*a21;
a01=a01/a21;
a01=a01-a22;
a22=a10*a01;
a05=a05+a22;
a10=a10*a32;
a10=sqrt(a10);
a22=2.*a10;
a05=a05/a22;
a05=a00*a05;
a05=a05/a32;
a00=a00*a10;
a00=a00/a32;
a00=a00/a32;
a00=a00*a01;
a05=a05-a00;
if (res[0]!=0) res[0][0]=a05;
a05=7.0710678118654757e-01;
a00=a05*a01;
a10=a20*a32;
a10=sqrt(a10);
a00=a00/a10;
a05=a05*a32;
a05=a05/a10;
a05=a05/a10;
a32=a32*a09;
a20=a20*a01;
a32=a32+a20;
a10=2.*a10;
a32=a32/a10;
a05=a05*a32;
a00=a00-a05;
if (res[1]!=0) res[1][0]=a00;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_speed_window(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f21(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_speed_window_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_speed_window_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_speed_window_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_speed_window_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_speed_window_n_in(void) { return 18;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_speed_window_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_speed_window_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_speed_window_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "a";
case 2: return "b";
case 3: return "rho";
case 4: return "Ap";
case 5: return "CL_gamma";
case 6: return "C_alpha";
case 7: return "Ct";
case 8: return "out_u_low";
case 9: return "out_u_high";
case 10: return "fwd_m";
case 11: return "fwd_a";
case 12: return "fwd_b";
case 13: return "fwd_rho";
case 14: return "fwd_Ap";
case 15: return "fwd_CL_gamma";
case 16: return "fwd_C_alpha";
case 17: return "fwd_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_speed_window_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_u_low";
case 1: return "fwd_u_high";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_speed_window_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
case 8: return casadi_s1;
case 9: return casadi_s1;
case 10: return casadi_s0;
case 11: return casadi_s0;
case 12: return casadi_s0;
case 13: return casadi_s0;
case 14: return casadi_s0;
case 15: return casadi_s0;
case 16: return casadi_s0;
case 17: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_speed_window_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_speed_window_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 18;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_speed_window_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 18*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_speed_window:(m,a,b,rho,Ap,CL_gamma,C_alpha,Ct,out_u_low[1x1,0nz],out_u_high[1x1,0nz],adj_u_low,adj_u_high)->(adj_m,adj_a,adj_b,adj_rho,adj_Ap,adj_CL_gamma,adj_C_alpha,adj_Ct) */
static int casadi_f22(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37;
a00=arg[7]? arg[7][0] : 0;
a01=arg[2]? arg[2][0] : 0;
a02=a00*a01;
a03=arg[6]? arg[6][0] : 0;
a04=2.*a03;
a05=arg[1]? arg[1][0] : 0;
a06=casadi_sq(a05);
a07=a04*a06;
a08=5.0000000000000000e-01;
a09=arg[4]? arg[4][0] : 0;
a09=a08*a09;
a10=arg[5]? arg[5][0] : 0;
a11=a09*a10;
a12=arg[3]? arg[3][0] : 0;
a13=a11*a12;
a14=a07*a13;
a15=4.;
a03=a15*a03;
a16=a03*a05;
a17=a16*a01;
a18=a17*a13;
a14=a14+a18;
a18=a04*a05;
a19=arg[0]? arg[0][0] : 0;
a20=a18*a19;
a14=a14-a20;
a20=casadi_sq(a01);
a21=a04*a20;
a22=a21*a13;
a14=a14+a22;
a22=a02*a19;
a14=a14+a22;
a22=2.*a14;
a23=7.0710678118654757e-01;
a24=arg[11]? arg[11][0] : 0;
a25=a01*a13;
a26=a25*a19;
a27=-4.;
a28=a04*a00;
a29=a05+a01;
a30=casadi_sq(a29);
a31=a28*a30;
a32=a27*a31;
a33=a32*a26;
a34=casadi_sq(a14);
a33=a33+a34;
a33=sqrt(a33);
a14=a33-a14;
a34=a26*a14;
a34=sqrt(a34);
a35=a24/a34;
a35=a23*a35;
a23=a23*a14;
a23=a23/a34;
a23=a23/a34;
a23=a23*a24;
a34=2.*a34;
a23=a23/a34;
a34=a26*a23;
a35=a35-a34;
a34=1.4142135623730951e+00;
a24=a31*a14;
a24=sqrt(a24);
a36=a34*a24;
a36=a36/a14;
a36=a36/a14;
a37=arg[10]? arg[10][0] : 0;
a36=a36*a37;
a35=a35-a36;
a37=a37/a14;
a34=a34*a37;
a24=2.*a24;
a34=a34/a24;
a31=a31*a34;
a35=a35+a31;
a33=2.*a33;
a33=a35/a33;
a22=a22*a33;
a22=a22-a35;
a02=a02*a22;
a18=a18*a22;
a02=a02-a18;
a32=a32*a33;
a23=a14*a23;
a32=a32-a23;
a25=a25*a32;
a02=a02+a25;
if (res[0]!=0) res[0][0]=a02;
a02=a13*a22;
a25=a01*a02;
a03=a03*a25;
a23=a19*a22;
a18=a04*a23;
a03=a03-a18;
a18=2.*a05;
a35=a13*a22;
a31=a04*a35;
a18=a18*a31;
a03=a03+a18;
a29=2.*a29;
a14=a14*a34;
a26=a26*a33;
a27=a27*a26;
a14=a14+a27;
a28=a28*a14;
a29=a29*a28;
a03=a03+a29;
if (res[1]!=0) res[1][0]=a03;
a03=a19*a22;
a28=a00*a03;
a27=2.*a01;
a26=a13*a22;
a33=a04*a26;
a27=a27*a33;
a28=a28+a27;
a16=a16*a02;
a28=a28+a16;
a19=a19*a32;
a13=a13*a19;
a28=a28+a13;
a28=a28+a29;
if (res[2]!=0) res[2][0]=a28;
a21=a21*a22;
a17=a17*a22;
a21=a21+a17;
a07=a07*a22;
a21=a21+a07;
a19=a01*a19;
a21=a21+a19;
a11=a11*a21;
if (res[3]!=0) res[3][0]=a11;
a12=a12*a21;
a10=a10*a12;
a08=a08*a10;
if (res[4]!=0) res[4][0]=a08;
a09=a09*a12;
if (res[5]!=0) res[5][0]=a09;
a25=a05*a25;
a15=a15*a25;
a20=a20*a26;
a05=a05*a23;
a20=a20-a05;
a06=a06*a35;
a20=a20+a06;
a30=a30*a14;
a00=a00*a30;
a20=a20+a00;
a20=2.*a20;
a15=a15+a20;
if (res[6]!=0) res[6][0]=a15;
a01=a01*a03;
a04=a04*a30;
a01=a01+a04;
if (res[7]!=0) res[7][0]=a01;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_speed_window(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f22(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_speed_window_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_speed_window_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_speed_window_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_speed_window_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_speed_window_n_in(void) { return 12;}
CASADI_SYMBOL_EXPORT casadi_int adj1_speed_window_n_out(void) { return 8;}
CASADI_SYMBOL_EXPORT casadi_real adj1_speed_window_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_speed_window_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "a";
case 2: return "b";
case 3: return "rho";
case 4: return "Ap";
case 5: return "CL_gamma";
case 6: return "C_alpha";
case 7: return "Ct";
case 8: return "out_u_low";
case 9: return "out_u_high";
case 10: return "adj_u_low";
case 11: return "adj_u_high";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_speed_window_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_m";
case 1: return "adj_a";
case 2: return "adj_b";
case 3: return "adj_rho";
case 4: return "adj_Ap";
case 5: return "adj_CL_gamma";
case 6: return "adj_C_alpha";
case 7: return "adj_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_speed_window_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
case 8: return casadi_s1;
case 9: return casadi_s1;
case 10: return casadi_s0;
case 11: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_speed_window_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_speed_window_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 12;
if (sz_res) *sz_res = 8;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_speed_window_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
if (sz_res) *sz_res = 8*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_speed_window:(m,a,b,rho,Ap,CL_gamma,C_alpha,Ct,out_u_low[1x1,0nz],out_u_high[1x1,0nz],adj_u_low,adj_u_high,out_adj_m[1x1,0nz],out_adj_a[1x1,0nz],out_adj_b[1x1,0nz],out_adj_rho[1x1,0nz],out_adj_Ap[1x1,0nz],out_adj_CL_gamma[1x1,0nz],out_adj_C_alpha[1x1,0nz],out_adj_Ct[1x1,0nz],fwd_m,fwd_a,fwd_b,fwd_rho,fwd_Ap,fwd_CL_gamma,fwd_C_alpha,fwd_Ct,fwd_out_u_low[1x1,0nz],fwd_out_u_high[1x1,0nz],fwd_adj_u_low,fwd_adj_u_high)->(fwd_adj_m,fwd_adj_a,fwd_adj_b,fwd_adj_rho,fwd_adj_Ap,fwd_adj_CL_gamma,fwd_adj_C_alpha,fwd_adj_Ct) */
static int casadi_f23(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
casadi_real a72, a73, a74, a75, a76, a77, a78, a79, a80, a81, a82, a83;
casadi_real a84;
a00=arg[6]? arg[6][0] : 0;
a01=2.*a00;
a02=arg[1]? arg[1][0] : 0;
a03=casadi_sq(a02);
a04=a01*a03;
a05=5.0000000000000000e-01;
a06=arg[4]? arg[4][0] : 0;
a06=a05*a06;
a07=arg[5]? arg[5][0] : 0;
a08=a06*a07;
a09=arg[3]? arg[3][0] : 0;
a10=a08*a09;
a11=a04*a10;
a12=4.;
a00=a12*a00;
a13=a00*a02;
a14=arg[2]? arg[2][0] : 0;
a15=a13*a14;
a16=a15*a10;
a11=a11+a16;
a16=a01*a02;
a17=arg[0]? arg[0][0] : 0;
a18=a16*a17;
a11=a11-a18;
a18=casadi_sq(a14);
a19=a01*a18;
a20=a19*a10;
a11=a11+a20;
a20=arg[7]? arg[7][0] : 0;
a21=a20*a14;
a22=a21*a17;
a11=a11+a22;
a22=2.*a11;
a23=7.0710678118654757e-01;
a24=arg[11]? arg[11][0] : 0;
a25=a14*a10;
a26=a25*a17;
a27=-4.;
a28=a01*a20;
a29=a02+a14;
a30=casadi_sq(a29);
a31=a28*a30;
a32=a27*a31;
a33=a32*a26;
a34=casadi_sq(a11);
a33=a33+a34;
a33=sqrt(a33);
a34=a33-a11;
a35=a26*a34;
a35=sqrt(a35);
a36=a24/a35;
a37=a23*a36;
a38=a23*a34;
a38=a38/a35;
a39=a38/a35;
a40=a39*a24;
a41=2.*a35;
a40=a40/a41;
a42=a26*a40;
a37=a37-a42;
a42=1.4142135623730951e+00;
a43=a31*a34;
a43=sqrt(a43);
a44=a42*a43;
a44=a44/a34;
a45=a44/a34;
a46=arg[10]? arg[10][0] : 0;
a47=a45*a46;
a37=a37-a47;
a47=a46/a34;
a48=a42*a47;
a49=2.*a43;
a48=a48/a49;
a50=a31*a48;
a37=a37+a50;
a50=2.*a33;
a51=a37/a50;
a52=a22*a51;
a52=a52-a37;
a37=arg[27]? arg[27][0] : 0;
a53=a14*a37;
a54=arg[22]? arg[22][0] : 0;
a55=a20*a54;
a53=a53+a55;
a55=a52*a53;
a56=arg[26]? arg[26][0] : 0;
a57=2.*a56;
a58=a03*a57;
a59=2.*a02;
a60=arg[21]? arg[21][0] : 0;
a59=a59*a60;
a61=a01*a59;
a58=a58+a61;
a61=a10*a58;
a62=arg[24]? arg[24][0] : 0;
a62=a05*a62;
a63=a07*a62;
a64=arg[25]? arg[25][0] : 0;
a65=a06*a64;
a63=a63+a65;
a65=a09*a63;
a66=arg[23]? arg[23][0] : 0;
a67=a08*a66;
a65=a65+a67;
a67=a04*a65;
a61=a61+a67;
a56=a12*a56;
a67=a02*a56;
a68=a00*a60;
a67=a67+a68;
a68=a14*a67;
a69=a13*a54;
a68=a68+a69;
a69=a10*a68;
a70=a15*a65;
a69=a69+a70;
a61=a61+a69;
a69=a02*a57;
a70=a01*a60;
a69=a69+a70;
a70=a17*a69;
a71=arg[20]? arg[20][0] : 0;
a72=a16*a71;
a70=a70+a72;
a61=a61-a70;
a70=a18*a57;
a72=2.*a14;
a72=a72*a54;
a73=a01*a72;
a70=a70+a73;
a73=a10*a70;
a74=a19*a65;
a73=a73+a74;
a61=a61+a73;
a53=a17*a53;
a73=a21*a71;
a53=a53+a73;
a61=a61+a53;
a53=2.*a61;
a53=a51*a53;
a73=arg[31]? arg[31][0] : 0;
a74=a73/a35;
a36=a36/a35;
a75=a10*a54;
a76=a14*a65;
a75=a75+a76;
a76=a17*a75;
a77=a25*a71;
a76=a76+a77;
a77=a34*a76;
a78=a20*a57;
a79=a01*a37;
a78=a78+a79;
a79=a30*a78;
a80=2.*a29;
a81=a60+a54;
a80=a80*a81;
a82=a28*a80;
a79=a79+a82;
a82=a27*a79;
a83=a26*a82;
a84=a32*a76;
a83=a83+a84;
a11=2.*a11;
a11=a11*a61;
a83=a83+a11;
a33=2.*a33;
a83=a83/a33;
a61=a83-a61;
a33=a26*a61;
a77=a77+a33;
a33=2.*a35;
a77=a77/a33;
a36=a36*a77;
a74=a74-a36;
a74=a23*a74;
a36=a40*a76;
a23=a23*a61;
a23=a23/a35;
a38=a38/a35;
a38=a38*a77;
a23=a23-a38;
a23=a23/a35;
a35=a39/a35;
a35=a35*a77;
a23=a23-a35;
a24=a24*a23;
a39=a39*a73;
a24=a24+a39;
a24=a24/a41;
a41=a40/a41;
a77=2.*a77;
a41=a41*a77;
a24=a24-a41;
a41=a26*a24;
a36=a36+a41;
a74=a74-a36;
a36=a34*a79;
a41=a31*a61;
a36=a36+a41;
a43=2.*a43;
a36=a36/a43;
a43=a42*a36;
a43=a43/a34;
a44=a44/a34;
a44=a44*a61;
a43=a43-a44;
a43=a43/a34;
a44=a45/a34;
a44=a44*a61;
a43=a43-a44;
a46=a46*a43;
a43=arg[30]? arg[30][0] : 0;
a45=a45*a43;
a46=a46+a45;
a74=a74-a46;
a79=a48*a79;
a43=a43/a34;
a47=a47/a34;
a47=a47*a61;
a43=a43-a47;
a42=a42*a43;
a42=a42/a49;
a49=a48/a49;
a36=2.*a36;
a49=a49*a36;
a42=a42-a49;
a31=a31*a42;
a79=a79+a31;
a74=a74+a79;
a79=a74/a50;
a50=a51/a50;
a83=2.*a83;
a50=a50*a83;
a79=a79-a50;
a22=a22*a79;
a53=a53+a22;
a53=a53-a74;
a21=a21*a53;
a55=a55+a21;
a69=a52*a69;
a16=a16*a53;
a69=a69+a16;
a55=a55-a69;
a69=a32*a51;
a16=a34*a40;
a69=a69-a16;
a75=a69*a75;
a82=a51*a82;
a32=a32*a79;
a82=a82+a32;
a40=a40*a61;
a24=a34*a24;
a40=a40+a24;
a82=a82-a40;
a25=a25*a82;
a75=a75+a25;
a55=a55+a75;
if (res[0]!=0) res[0][0]=a55;
a55=a10*a52;
a75=a14*a55;
a56=a75*a56;
a25=a55*a54;
a40=a52*a65;
a24=a10*a53;
a40=a40+a24;
a24=a14*a40;
a25=a25+a24;
a00=a00*a25;
a56=a56+a00;
a00=a17*a52;
a24=a00*a57;
a32=a52*a71;
a16=a17*a53;
a32=a32+a16;
a16=a01*a32;
a24=a24+a16;
a56=a56-a24;
a24=a10*a52;
a16=a01*a24;
a21=2.*a60;
a16=a16*a21;
a21=2.*a02;
a74=a24*a57;
a22=a52*a65;
a50=a10*a53;
a22=a22+a50;
a50=a01*a22;
a74=a74+a50;
a21=a21*a74;
a16=a16+a21;
a56=a56+a16;
a16=a34*a48;
a21=a26*a51;
a21=a27*a21;
a16=a16+a21;
a21=a28*a16;
a81=2.*a81;
a21=a21*a81;
a29=2.*a29;
a78=a16*a78;
a48=a48*a61;
a34=a34*a42;
a48=a48+a34;
a51=a51*a76;
a26=a26*a79;
a51=a51+a26;
a27=a27*a51;
a48=a48+a27;
a28=a28*a48;
a78=a78+a28;
a29=a29*a78;
a21=a21+a29;
a56=a56+a21;
if (res[1]!=0) res[1][0]=a56;
a56=a17*a52;
a29=a56*a37;
a78=a52*a71;
a28=a17*a53;
a78=a78+a28;
a28=a20*a78;
a29=a29+a28;
a28=a10*a52;
a27=a01*a28;
a51=2.*a54;
a27=a27*a51;
a51=2.*a14;
a26=a28*a57;
a79=a52*a65;
a76=a10*a53;
a79=a79+a76;
a76=a01*a79;
a26=a26+a76;
a51=a51*a26;
a27=a27+a51;
a29=a29+a27;
a55=a55*a67;
a13=a13*a40;
a55=a55+a13;
a29=a29+a55;
a55=a17*a69;
a65=a55*a65;
a69=a69*a71;
a17=a17*a82;
a69=a69+a17;
a10=a10*a69;
a65=a65+a10;
a29=a29+a65;
a29=a29+a21;
if (res[2]!=0) res[2][0]=a29;
a29=a19*a52;
a21=a15*a52;
a29=a29+a21;
a21=a04*a52;
a29=a29+a21;
a21=a14*a55;
a29=a29+a21;
a63=a29*a63;
a70=a52*a70;
a19=a19*a53;
a70=a70+a19;
a68=a52*a68;
a15=a15*a53;
a68=a68+a15;
a70=a70+a68;
a52=a52*a58;
a04=a04*a53;
a52=a52+a04;
a70=a70+a52;
a55=a55*a54;
a69=a14*a69;
a55=a55+a69;
a70=a70+a55;
a08=a08*a70;
a63=a63+a08;
if (res[3]!=0) res[3][0]=a63;
a63=a09*a29;
a64=a63*a64;
a29=a29*a66;
a09=a09*a70;
a29=a29+a09;
a07=a07*a29;
a64=a64+a07;
a05=a05*a64;
if (res[4]!=0) res[4][0]=a05;
a63=a63*a62;
a06=a06*a29;
a63=a63+a06;
if (res[5]!=0) res[5][0]=a63;
a75=a75*a60;
a25=a02*a25;
a75=a75+a25;
a12=a12*a75;
a28=a28*a72;
a18=a18*a79;
a28=a28+a18;
a00=a00*a60;
a02=a02*a32;
a00=a00+a02;
a28=a28-a00;
a24=a24*a59;
a03=a03*a22;
a24=a24+a03;
a28=a28+a24;
a24=a30*a16;
a37=a24*a37;
a16=a16*a80;
a30=a30*a48;
a16=a16+a30;
a20=a20*a16;
a37=a37+a20;
a28=a28+a37;
a28=2.*a28;
a12=a12+a28;
if (res[6]!=0) res[6][0]=a12;
a56=a56*a54;
a14=a14*a78;
a56=a56+a14;
a24=a24*a57;
a01=a01*a16;
a24=a24+a01;
a56=a56+a24;
if (res[7]!=0) res[7][0]=a56;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_speed_window(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f23(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_speed_window_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_speed_window_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_speed_window_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_speed_window_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_speed_window_n_in(void) { return 32;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_speed_window_n_out(void) { return 8;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_speed_window_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_speed_window_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "a";
case 2: return "b";
case 3: return "rho";
case 4: return "Ap";
case 5: return "CL_gamma";
case 6: return "C_alpha";
case 7: return "Ct";
case 8: return "out_u_low";
case 9: return "out_u_high";
case 10: return "adj_u_low";
case 11: return "adj_u_high";
case 12: return "out_adj_m";
case 13: return "out_adj_a";
case 14: return "out_adj_b";
case 15: return "out_adj_rho";
case 16: return "out_adj_Ap";
case 17: return "out_adj_CL_gamma";
case 18: return "out_adj_C_alpha";
case 19: return "out_adj_Ct";
case 20: return "fwd_m";
case 21: return "fwd_a";
case 22: return "fwd_b";
case 23: return "fwd_rho";
case 24: return "fwd_Ap";
case 25: return "fwd_CL_gamma";
case 26: return "fwd_C_alpha";
case 27: return "fwd_Ct";
case 28: return "fwd_out_u_low";
case 29: return "fwd_out_u_high";
case 30: return "fwd_adj_u_low";
case 31: return "fwd_adj_u_high";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_speed_window_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_m";
case 1: return "fwd_adj_a";
case 2: return "fwd_adj_b";
case 3: return "fwd_adj_rho";
case 4: return "fwd_adj_Ap";
case 5: return "fwd_adj_CL_gamma";
case 6: return "fwd_adj_C_alpha";
case 7: return "fwd_adj_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_speed_window_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
case 8: return casadi_s1;
case 9: return casadi_s1;
case 10: return casadi_s0;
case 11: return casadi_s0;
case 12: return casadi_s1;
case 13: return casadi_s1;
case 14: return casadi_s1;
case 15: return casadi_s1;
case 16: return casadi_s1;
case 17: return casadi_s1;
case 18: return casadi_s1;
case 19: return casadi_s1;
case 20: return casadi_s0;
case 21: return casadi_s0;
case 22: return casadi_s0;
case 23: return casadi_s0;
case 24: return casadi_s0;
case 25: return casadi_s0;
case 26: return casadi_s0;
case 27: return casadi_s0;
case 28: return casadi_s1;
case 29: return casadi_s1;
case 30: return casadi_s0;
case 31: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_speed_window_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_speed_window_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 32;
if (sz_res) *sz_res = 8;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_speed_window_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 32*sizeof(const casadi_real*);
if (sz_res) *sz_res = 8*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* weakest_speed:(m,Izz,a,b,rho,Ap,CL_gamma,C_alpha,Ct)->(u_weakest,det_weakest) */
static int casadi_f24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10;
a00=arg[7]? arg[7][0] : 0;
a01=2.*a00;
a02=arg[8]? arg[8][0] : 0;
a03=a01*a02;
a04=arg[2]? arg[2][0] : 0;
a05=arg[3]? arg[3][0] : 0;
a06=a04+a05;
a06=casadi_sq(a06);
a03=a03*a06;
a06=5.0000000000000000e-01;
a07=arg[5]? arg[5][0] : 0;
a06=a06*a07;
a07=arg[6]? arg[6][0] : 0;
a06=a06*a07;
a07=arg[4]? arg[4][0] : 0;
a06=a06*a07;
a07=a05*a06;
a08=arg[0]? arg[0][0] : 0;
a07=a07*a08;
a09=a03/a07;
a09=sqrt(a09);
a09=sqrt(a09);
if (res[0]!=0) res[0][0]=a09;
a09=casadi_sq(a04);
a09=a01*a09;
a09=a09*a06;
a10=4.;
a10=a10*a00;
a10=a10*a04;
a10=a10*a05;
a10=a10*a06;
a09=a09+a10;
a04=a01*a04;
a04=a04*a08;
a09=a09-a04;
a04=casadi_sq(a05);
a01=a01*a04;
a01=a01*a06;
a09=a09+a01;
a02=a02*a05;
a02=a02*a08;
a09=a09+a02;
a03=a03*a07;
a03=sqrt(a03);
a03=2.*a03;
a09=a09+a03;
a03=arg[1]? arg[1][0] : 0;
a03=a03*a08;
a09=a09/a03;
if (res[1]!=0) res[1][0]=a09;
return 0;
}
CASADI_SYMBOL_EXPORT int weakest_speed(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f24(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int weakest_speed_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void weakest_speed_release(int mem) {
}
CASADI_SYMBOL_EXPORT void weakest_speed_incref(void) {
}
CASADI_SYMBOL_EXPORT void weakest_speed_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int weakest_speed_n_in(void) { return 9;}
CASADI_SYMBOL_EXPORT casadi_int weakest_speed_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real weakest_speed_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* weakest_speed_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "Izz";
case 2: return "a";
case 3: return "b";
case 4: return "rho";
case 5: return "Ap";
case 6: return "CL_gamma";
case 7: return "C_alpha";
case 8: return "Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* weakest_speed_name_out(casadi_int i) {
switch (i) {
case 0: return "u_weakest";
case 1: return "det_weakest";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* weakest_speed_sparsity_in(casadi_int i) {
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
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* weakest_speed_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int weakest_speed_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 9;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int weakest_speed_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 9*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_weakest_speed:(m,Izz,a,b,rho,Ap,CL_gamma,C_alpha,Ct,out_u_weakest[1x1,0nz],out_det_weakest[1x1,0nz],fwd_m,fwd_Izz,fwd_a,fwd_b,fwd_rho,fwd_Ap,fwd_CL_gamma,fwd_C_alpha,fwd_Ct)->(fwd_u_weakest,fwd_det_weakest) */
static int casadi_f25(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25;
a00=arg[2]? arg[2][0] : 0;
a01=arg[3]? arg[3][0] : 0;
a02=a00+a01;
a03=casadi_sq(a02);
a04=arg[8]? arg[8][0] : 0;
a05=arg[18]? arg[18][0] : 0;
a06=2.*a05;
a07=a04*a06;
a08=arg[7]? arg[7][0] : 0;
a09=2.*a08;
a10=arg[19]? arg[19][0] : 0;
a11=a09*a10;
a07=a07+a11;
a07=a03*a07;
a11=a09*a04;
a02=2.*a02;
a12=arg[13]? arg[13][0] : 0;
a13=arg[14]? arg[14][0] : 0;
a14=a12+a13;
a02=a02*a14;
a02=a11*a02;
a07=a07+a02;
a02=5.0000000000000000e-01;
a14=arg[5]? arg[5][0] : 0;
a14=a02*a14;
a15=arg[6]? arg[6][0] : 0;
a16=a14*a15;
a17=arg[4]? arg[4][0] : 0;
a18=a16*a17;
a19=a01*a18;
a20=arg[0]? arg[0][0] : 0;
a21=a19*a20;
a22=a07/a21;
a11=a11*a03;
a03=a11/a21;
a23=a03/a21;
a24=a18*a13;
a25=arg[16]? arg[16][0] : 0;
a02=a02*a25;
a15=a15*a02;
a02=arg[17]? arg[17][0] : 0;
a14=a14*a02;
a15=a15+a14;
a17=a17*a15;
a15=arg[15]? arg[15][0] : 0;
a16=a16*a15;
a17=a17+a16;
a16=a01*a17;
a24=a24+a16;
a24=a20*a24;
a16=arg[11]? arg[11][0] : 0;
a19=a19*a16;
a24=a24+a19;
a23=a23*a24;
a22=a22-a23;
a03=sqrt(a03);
a23=2.*a03;
a22=a22/a23;
a03=sqrt(a03);
a03=2.*a03;
a22=a22/a03;
if (res[0]!=0) res[0][0]=a22;
a22=casadi_sq(a00);
a03=a22*a06;
a23=2.*a00;
a23=a23*a12;
a23=a09*a23;
a03=a03+a23;
a03=a18*a03;
a22=a09*a22;
a23=a22*a17;
a03=a03+a23;
a23=4.;
a05=a23*a05;
a05=a00*a05;
a23=a23*a08;
a08=a23*a12;
a05=a05+a08;
a05=a01*a05;
a23=a23*a00;
a08=a23*a13;
a05=a05+a08;
a05=a18*a05;
a23=a23*a01;
a08=a23*a17;
a05=a05+a08;
a03=a03+a05;
a05=a00*a06;
a12=a09*a12;
a05=a05+a12;
a05=a20*a05;
a00=a09*a00;
a12=a00*a16;
a05=a05+a12;
a03=a03-a05;
a05=casadi_sq(a01);
a06=a05*a06;
a12=2.*a01;
a12=a12*a13;
a12=a09*a12;
a06=a06+a12;
a06=a18*a06;
a09=a09*a05;
a17=a09*a17;
a06=a06+a17;
a03=a03+a06;
a10=a01*a10;
a13=a04*a13;
a10=a10+a13;
a10=a20*a10;
a04=a04*a01;
a01=a04*a16;
a10=a10+a01;
a03=a03+a10;
a07=a21*a07;
a24=a11*a24;
a07=a07+a24;
a11=a11*a21;
a11=sqrt(a11);
a21=2.*a11;
a07=a07/a21;
a07=2.*a07;
a03=a03+a07;
a07=arg[1]? arg[1][0] : 0;
a21=a07*a20;
a03=a03/a21;
a22=a22*a18;
a23=a23*a18;
a22=a22+a23;
a00=a00*a20;
a22=a22-a00;
a09=a09*a18;
a22=a22+a09;
a04=a04*a20;
a22=a22+a04;
a11=2.*a11;
a22=a22+a11;
a22=a22/a21;
a22=a22/a21;
a21=arg[12]? arg[12][0] : 0;
a20=a20*a21;
a07=a07*a16;
a20=a20+a07;
a22=a22*a20;
a03=a03-a22;
if (res[1]!=0) res[1][0]=a03;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_weakest_speed(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f25(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_weakest_speed_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_weakest_speed_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_weakest_speed_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_weakest_speed_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_weakest_speed_n_in(void) { return 20;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_weakest_speed_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_weakest_speed_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_weakest_speed_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "Izz";
case 2: return "a";
case 3: return "b";
case 4: return "rho";
case 5: return "Ap";
case 6: return "CL_gamma";
case 7: return "C_alpha";
case 8: return "Ct";
case 9: return "out_u_weakest";
case 10: return "out_det_weakest";
case 11: return "fwd_m";
case 12: return "fwd_Izz";
case 13: return "fwd_a";
case 14: return "fwd_b";
case 15: return "fwd_rho";
case 16: return "fwd_Ap";
case 17: return "fwd_CL_gamma";
case 18: return "fwd_C_alpha";
case 19: return "fwd_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_weakest_speed_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_u_weakest";
case 1: return "fwd_det_weakest";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_weakest_speed_sparsity_in(casadi_int i) {
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
case 9: return casadi_s1;
case 10: return casadi_s1;
case 11: return casadi_s0;
case 12: return casadi_s0;
case 13: return casadi_s0;
case 14: return casadi_s0;
case 15: return casadi_s0;
case 16: return casadi_s0;
case 17: return casadi_s0;
case 18: return casadi_s0;
case 19: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_weakest_speed_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_weakest_speed_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 20;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_weakest_speed_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_weakest_speed:(m,Izz,a,b,rho,Ap,CL_gamma,C_alpha,Ct,out_u_weakest[1x1,0nz],out_det_weakest[1x1,0nz],adj_u_weakest,adj_det_weakest)->(adj_m,adj_Izz,adj_a,adj_b,adj_rho,adj_Ap,adj_CL_gamma,adj_C_alpha,adj_Ct) */
static int casadi_f26(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33;
a00=arg[8]? arg[8][0] : 0;
a01=arg[3]? arg[3][0] : 0;
a02=a00*a01;
a03=arg[12]? arg[12][0] : 0;
a04=arg[1]? arg[1][0] : 0;
a05=arg[0]? arg[0][0] : 0;
a06=a04*a05;
a07=a03/a06;
a08=a02*a07;
a09=arg[7]? arg[7][0] : 0;
a10=2.*a09;
a11=arg[2]? arg[2][0] : 0;
a12=casadi_sq(a11);
a13=a10*a12;
a14=5.0000000000000000e-01;
a15=arg[5]? arg[5][0] : 0;
a15=a14*a15;
a16=arg[6]? arg[6][0] : 0;
a17=a15*a16;
a18=arg[4]? arg[4][0] : 0;
a19=a17*a18;
a20=a13*a19;
a21=4.;
a09=a21*a09;
a22=a09*a11;
a23=a22*a01;
a24=a23*a19;
a20=a20+a24;
a24=a10*a11;
a25=a24*a05;
a20=a20-a25;
a25=casadi_sq(a01);
a26=a10*a25;
a27=a26*a19;
a20=a20+a27;
a02=a02*a05;
a20=a20+a02;
a02=a10*a00;
a27=a11+a01;
a28=casadi_sq(a27);
a29=a02*a28;
a30=a01*a19;
a31=a30*a05;
a32=a29*a31;
a32=sqrt(a32);
a33=2.*a32;
a20=a20+a33;
a20=a20/a06;
a20=a20/a06;
a20=a20*a03;
a04=a04*a20;
a08=a08-a04;
a24=a24*a07;
a08=a08-a24;
a32=a07/a32;
a24=a29*a32;
a29=a29/a31;
a04=a29/a31;
a03=arg[11]? arg[11][0] : 0;
a29=sqrt(a29);
a06=sqrt(a29);
a06=2.*a06;
a03=a03/a06;
a29=2.*a29;
a03=a03/a29;
a04=a04*a03;
a24=a24-a04;
a30=a30*a24;
a08=a08+a30;
if (res[0]!=0) res[0][0]=a08;
a20=a05*a20;
a20=-a20;
if (res[1]!=0) res[1][0]=a20;
a20=a19*a07;
a08=a01*a20;
a09=a09*a08;
a30=a05*a07;
a04=a10*a30;
a09=a09-a04;
a04=2.*a11;
a29=a19*a07;
a06=a10*a29;
a04=a04*a06;
a09=a09+a04;
a27=2.*a27;
a32=a31*a32;
a03=a03/a31;
a32=a32+a03;
a02=a02*a32;
a27=a27*a02;
a09=a09+a27;
if (res[2]!=0) res[2][0]=a09;
a09=a05*a07;
a02=a00*a09;
a03=2.*a01;
a31=a19*a07;
a04=a10*a31;
a03=a03*a04;
a02=a02+a03;
a22=a22*a20;
a02=a02+a22;
a05=a05*a24;
a19=a19*a05;
a02=a02+a19;
a02=a02+a27;
if (res[3]!=0) res[3][0]=a02;
a26=a26*a07;
a23=a23*a07;
a26=a26+a23;
a13=a13*a07;
a26=a26+a13;
a05=a01*a05;
a26=a26+a05;
a17=a17*a26;
if (res[4]!=0) res[4][0]=a17;
a18=a18*a26;
a16=a16*a18;
a14=a14*a16;
if (res[5]!=0) res[5][0]=a14;
a15=a15*a18;
if (res[6]!=0) res[6][0]=a15;
a08=a11*a08;
a21=a21*a08;
a25=a25*a31;
a11=a11*a30;
a25=a25-a11;
a12=a12*a29;
a25=a25+a12;
a28=a28*a32;
a00=a00*a28;
a25=a25+a00;
a25=2.*a25;
a21=a21+a25;
if (res[7]!=0) res[7][0]=a21;
a01=a01*a09;
a10=a10*a28;
a01=a01+a10;
if (res[8]!=0) res[8][0]=a01;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_weakest_speed(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f26(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_weakest_speed_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_weakest_speed_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_weakest_speed_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_weakest_speed_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_weakest_speed_n_in(void) { return 13;}
CASADI_SYMBOL_EXPORT casadi_int adj1_weakest_speed_n_out(void) { return 9;}
CASADI_SYMBOL_EXPORT casadi_real adj1_weakest_speed_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_weakest_speed_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "Izz";
case 2: return "a";
case 3: return "b";
case 4: return "rho";
case 5: return "Ap";
case 6: return "CL_gamma";
case 7: return "C_alpha";
case 8: return "Ct";
case 9: return "out_u_weakest";
case 10: return "out_det_weakest";
case 11: return "adj_u_weakest";
case 12: return "adj_det_weakest";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_weakest_speed_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_m";
case 1: return "adj_Izz";
case 2: return "adj_a";
case 3: return "adj_b";
case 4: return "adj_rho";
case 5: return "adj_Ap";
case 6: return "adj_CL_gamma";
case 7: return "adj_C_alpha";
case 8: return "adj_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_weakest_speed_sparsity_in(casadi_int i) {
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
case 9: return casadi_s1;
case 10: return casadi_s1;
case 11: return casadi_s0;
case 12: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_weakest_speed_sparsity_out(casadi_int i) {
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
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_weakest_speed_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 13;
if (sz_res) *sz_res = 9;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_weakest_speed_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 13*sizeof(const casadi_real*);
if (sz_res) *sz_res = 9*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_weakest_speed:(m,Izz,a,b,rho,Ap,CL_gamma,C_alpha,Ct,out_u_weakest[1x1,0nz],out_det_weakest[1x1,0nz],adj_u_weakest,adj_det_weakest,out_adj_m[1x1,0nz],out_adj_Izz[1x1,0nz],out_adj_a[1x1,0nz],out_adj_b[1x1,0nz],out_adj_rho[1x1,0nz],out_adj_Ap[1x1,0nz],out_adj_CL_gamma[1x1,0nz],out_adj_C_alpha[1x1,0nz],out_adj_Ct[1x1,0nz],fwd_m,fwd_Izz,fwd_a,fwd_b,fwd_rho,fwd_Ap,fwd_CL_gamma,fwd_C_alpha,fwd_Ct,fwd_out_u_weakest[1x1,0nz],fwd_out_det_weakest[1x1,0nz],fwd_adj_u_weakest,fwd_adj_det_weakest)->(fwd_adj_m,fwd_adj_Izz,fwd_adj_a,fwd_adj_b,fwd_adj_rho,fwd_adj_Ap,fwd_adj_CL_gamma,fwd_adj_C_alpha,fwd_adj_Ct) */
static int casadi_f27(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
casadi_real a60, a61, a62, a63, a64, a65, a66;
a00=arg[12]? arg[12][0] : 0;
a01=arg[1]? arg[1][0] : 0;
a02=arg[0]? arg[0][0] : 0;
a03=a01*a02;
a04=a00/a03;
a05=arg[3]? arg[3][0] : 0;
a06=arg[30]? arg[30][0] : 0;
a07=a05*a06;
a08=arg[8]? arg[8][0] : 0;
a09=arg[25]? arg[25][0] : 0;
a10=a08*a09;
a07=a07+a10;
a10=a04*a07;
a11=a08*a05;
a12=arg[34]? arg[34][0] : 0;
a13=a12/a03;
a14=a04/a03;
a15=arg[23]? arg[23][0] : 0;
a16=a02*a15;
a17=arg[22]? arg[22][0] : 0;
a18=a01*a17;
a16=a16+a18;
a14=a14*a16;
a13=a13-a14;
a14=a11*a13;
a10=a10+a14;
a14=arg[7]? arg[7][0] : 0;
a18=2.*a14;
a19=arg[2]? arg[2][0] : 0;
a20=casadi_sq(a19);
a21=a18*a20;
a22=5.0000000000000000e-01;
a23=arg[5]? arg[5][0] : 0;
a23=a22*a23;
a24=arg[6]? arg[6][0] : 0;
a25=a23*a24;
a26=arg[4]? arg[4][0] : 0;
a27=a25*a26;
a28=a21*a27;
a29=4.;
a14=a29*a14;
a30=a14*a19;
a31=a30*a05;
a32=a31*a27;
a28=a28+a32;
a32=a18*a19;
a33=a32*a02;
a28=a28-a33;
a33=casadi_sq(a05);
a34=a18*a33;
a35=a34*a27;
a28=a28+a35;
a35=a11*a02;
a28=a28+a35;
a35=a18*a08;
a36=a19+a05;
a37=casadi_sq(a36);
a38=a35*a37;
a39=a05*a27;
a40=a39*a02;
a41=a38*a40;
a41=sqrt(a41);
a42=2.*a41;
a28=a28+a42;
a28=a28/a03;
a42=a28/a03;
a43=a42*a00;
a15=a43*a15;
a44=arg[29]? arg[29][0] : 0;
a45=2.*a44;
a46=a20*a45;
a47=2.*a19;
a48=arg[24]? arg[24][0] : 0;
a47=a47*a48;
a49=a18*a47;
a46=a46+a49;
a49=a27*a46;
a50=arg[27]? arg[27][0] : 0;
a50=a22*a50;
a51=a24*a50;
a52=arg[28]? arg[28][0] : 0;
a53=a23*a52;
a51=a51+a53;
a53=a26*a51;
a54=arg[26]? arg[26][0] : 0;
a55=a25*a54;
a53=a53+a55;
a55=a21*a53;
a49=a49+a55;
a44=a29*a44;
a55=a19*a44;
a56=a14*a48;
a55=a55+a56;
a56=a05*a55;
a57=a30*a09;
a56=a56+a57;
a57=a27*a56;
a58=a31*a53;
a57=a57+a58;
a49=a49+a57;
a57=a19*a45;
a58=a18*a48;
a57=a57+a58;
a58=a02*a57;
a59=a32*a17;
a58=a58+a59;
a49=a49-a58;
a58=a33*a45;
a59=2.*a05;
a59=a59*a09;
a60=a18*a59;
a58=a58+a60;
a60=a27*a58;
a61=a34*a53;
a60=a60+a61;
a49=a49+a60;
a07=a02*a07;
a11=a11*a17;
a07=a07+a11;
a49=a49+a07;
a07=a08*a45;
a11=a18*a06;
a07=a07+a11;
a11=a37*a07;
a60=2.*a36;
a61=a48+a09;
a60=a60*a61;
a62=a35*a60;
a11=a11+a62;
a62=a40*a11;
a63=a27*a09;
a64=a05*a53;
a63=a63+a64;
a64=a02*a63;
a65=a39*a17;
a64=a64+a65;
a65=a38*a64;
a62=a62+a65;
a65=2.*a41;
a62=a62/a65;
a65=2.*a62;
a49=a49+a65;
a49=a49/a03;
a28=a28/a03;
a28=a28*a16;
a49=a49-a28;
a49=a49/a03;
a03=a42/a03;
a03=a03*a16;
a49=a49-a03;
a00=a00*a49;
a42=a42*a12;
a00=a00+a42;
a01=a01*a00;
a15=a15+a01;
a10=a10-a15;
a57=a04*a57;
a32=a32*a13;
a57=a57+a32;
a10=a10-a57;
a57=a04/a41;
a32=a38*a57;
a15=a38/a40;
a01=a15/a40;
a42=arg[11]? arg[11][0] : 0;
a12=sqrt(a15);
a49=sqrt(a12);
a03=2.*a49;
a42=a42/a03;
a16=2.*a12;
a28=a42/a16;
a65=a01*a28;
a32=a32-a65;
a63=a32*a63;
a65=a57*a11;
a66=a13/a41;
a41=a57/a41;
a41=a41*a62;
a66=a66-a41;
a38=a38*a66;
a65=a65+a38;
a11=a11/a40;
a15=a15/a40;
a15=a15*a64;
a11=a11-a15;
a15=a11/a40;
a38=a01/a40;
a38=a38*a64;
a15=a15-a38;
a15=a28*a15;
a38=arg[33]? arg[33][0] : 0;
a38=a38/a03;
a42=a42/a03;
a12=2.*a12;
a11=a11/a12;
a49=2.*a49;
a49=a11/a49;
a49=2.*a49;
a42=a42*a49;
a38=a38-a42;
a38=a38/a16;
a16=a28/a16;
a11=2.*a11;
a16=a16*a11;
a38=a38-a16;
a01=a01*a38;
a15=a15+a01;
a65=a65-a15;
a39=a39*a65;
a63=a63+a39;
a10=a10+a63;
if (res[0]!=0) res[0][0]=a10;
a43=a43*a17;
a00=a02*a00;
a43=a43+a00;
a43=-a43;
if (res[1]!=0) res[1][0]=a43;
a43=a27*a04;
a00=a05*a43;
a44=a00*a44;
a10=a43*a09;
a63=a04*a53;
a39=a27*a13;
a63=a63+a39;
a39=a05*a63;
a10=a10+a39;
a14=a14*a10;
a44=a44+a14;
a14=a02*a04;
a39=a14*a45;
a15=a04*a17;
a01=a02*a13;
a15=a15+a01;
a01=a18*a15;
a39=a39+a01;
a44=a44-a39;
a39=a27*a04;
a01=a18*a39;
a16=2.*a48;
a01=a01*a16;
a16=2.*a19;
a11=a39*a45;
a42=a04*a53;
a49=a27*a13;
a42=a42+a49;
a49=a18*a42;
a11=a11+a49;
a16=a16*a11;
a01=a01+a16;
a44=a44+a01;
a01=a40*a57;
a28=a28/a40;
a01=a01+a28;
a16=a35*a01;
a61=2.*a61;
a16=a16*a61;
a36=2.*a36;
a07=a01*a07;
a57=a57*a64;
a66=a40*a66;
a57=a57+a66;
a38=a38/a40;
a28=a28/a40;
a28=a28*a64;
a38=a38-a28;
a57=a57+a38;
a35=a35*a57;
a07=a07+a35;
a36=a36*a07;
a16=a16+a36;
a44=a44+a16;
if (res[2]!=0) res[2][0]=a44;
a44=a02*a04;
a36=a44*a06;
a07=a04*a17;
a35=a02*a13;
a07=a07+a35;
a35=a08*a07;
a36=a36+a35;
a35=a27*a04;
a38=a18*a35;
a28=2.*a09;
a38=a38*a28;
a28=2.*a05;
a64=a35*a45;
a40=a04*a53;
a66=a27*a13;
a40=a40+a66;
a66=a18*a40;
a64=a64+a66;
a28=a28*a64;
a38=a38+a28;
a36=a36+a38;
a43=a43*a55;
a30=a30*a63;
a43=a43+a30;
a36=a36+a43;
a43=a02*a32;
a53=a43*a53;
a32=a32*a17;
a02=a02*a65;
a32=a32+a02;
a27=a27*a32;
a53=a53+a27;
a36=a36+a53;
a36=a36+a16;
if (res[3]!=0) res[3][0]=a36;
a36=a34*a04;
a16=a31*a04;
a36=a36+a16;
a16=a21*a04;
a36=a36+a16;
a16=a05*a43;
a36=a36+a16;
a51=a36*a51;
a58=a04*a58;
a34=a34*a13;
a58=a58+a34;
a56=a04*a56;
a31=a31*a13;
a56=a56+a31;
a58=a58+a56;
a04=a04*a46;
a21=a21*a13;
a04=a04+a21;
a58=a58+a04;
a43=a43*a09;
a32=a05*a32;
a43=a43+a32;
a58=a58+a43;
a25=a25*a58;
a51=a51+a25;
if (res[4]!=0) res[4][0]=a51;
a51=a26*a36;
a52=a51*a52;
a36=a36*a54;
a26=a26*a58;
a36=a36+a26;
a24=a24*a36;
a52=a52+a24;
a22=a22*a52;
if (res[5]!=0) res[5][0]=a22;
a51=a51*a50;
a23=a23*a36;
a51=a51+a23;
if (res[6]!=0) res[6][0]=a51;
a00=a00*a48;
a10=a19*a10;
a00=a00+a10;
a29=a29*a00;
a35=a35*a59;
a33=a33*a40;
a35=a35+a33;
a14=a14*a48;
a19=a19*a15;
a14=a14+a19;
a35=a35-a14;
a39=a39*a47;
a20=a20*a42;
a39=a39+a20;
a35=a35+a39;
a39=a37*a01;
a06=a39*a06;
a01=a01*a60;
a37=a37*a57;
a01=a01+a37;
a08=a08*a01;
a06=a06+a08;
a35=a35+a06;
a35=2.*a35;
a29=a29+a35;
if (res[7]!=0) res[7][0]=a29;
a44=a44*a09;
a05=a05*a07;
a44=a44+a05;
a39=a39*a45;
a18=a18*a01;
a39=a39+a18;
a44=a44+a39;
if (res[8]!=0) res[8][0]=a44;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_weakest_speed(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f27(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_weakest_speed_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_weakest_speed_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_weakest_speed_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_weakest_speed_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_weakest_speed_n_in(void) { return 35;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_weakest_speed_n_out(void) { return 9;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_weakest_speed_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_weakest_speed_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "Izz";
case 2: return "a";
case 3: return "b";
case 4: return "rho";
case 5: return "Ap";
case 6: return "CL_gamma";
case 7: return "C_alpha";
case 8: return "Ct";
case 9: return "out_u_weakest";
case 10: return "out_det_weakest";
case 11: return "adj_u_weakest";
case 12: return "adj_det_weakest";
case 13: return "out_adj_m";
case 14: return "out_adj_Izz";
case 15: return "out_adj_a";
case 16: return "out_adj_b";
case 17: return "out_adj_rho";
case 18: return "out_adj_Ap";
case 19: return "out_adj_CL_gamma";
case 20: return "out_adj_C_alpha";
case 21: return "out_adj_Ct";
case 22: return "fwd_m";
case 23: return "fwd_Izz";
case 24: return "fwd_a";
case 25: return "fwd_b";
case 26: return "fwd_rho";
case 27: return "fwd_Ap";
case 28: return "fwd_CL_gamma";
case 29: return "fwd_C_alpha";
case 30: return "fwd_Ct";
case 31: return "fwd_out_u_weakest";
case 32: return "fwd_out_det_weakest";
case 33: return "fwd_adj_u_weakest";
case 34: return "fwd_adj_det_weakest";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_weakest_speed_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_m";
case 1: return "fwd_adj_Izz";
case 2: return "fwd_adj_a";
case 3: return "fwd_adj_b";
case 4: return "fwd_adj_rho";
case 5: return "fwd_adj_Ap";
case 6: return "fwd_adj_CL_gamma";
case 7: return "fwd_adj_C_alpha";
case 8: return "fwd_adj_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_weakest_speed_sparsity_in(casadi_int i) {
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
case 9: return casadi_s1;
case 10: return casadi_s1;
case 11: return casadi_s0;
case 12: return casadi_s0;
case 13: return casadi_s1;
case 14: return casadi_s1;
case 15: return casadi_s1;
case 16: return casadi_s1;
case 17: return casadi_s1;
case 18: return casadi_s1;
case 19: return casadi_s1;
case 20: return casadi_s1;
case 21: return casadi_s1;
case 22: return casadi_s0;
case 23: return casadi_s0;
case 24: return casadi_s0;
case 25: return casadi_s0;
case 26: return casadi_s0;
case 27: return casadi_s0;
case 28: return casadi_s0;
case 29: return casadi_s0;
case 30: return casadi_s0;
case 31: return casadi_s1;
case 32: return casadi_s1;
case 33: return casadi_s0;
case 34: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_weakest_speed_sparsity_out(casadi_int i) {
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
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_weakest_speed_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 35;
if (sz_res) *sz_res = 9;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_weakest_speed_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 35*sizeof(const casadi_real*);
if (sz_res) *sz_res = 9*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* stationary_decay:(m,Izz,a,b,rho,Ap,CL_gamma,C_alpha,Ct)->(e_0,e_1,e_2,e_3,e_4,u_trace) */
static int casadi_f28(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16;
a00=arg[7]? arg[7][0] : 0;
a01=2.*a00;
a02=arg[8]? arg[8][0] : 0;
a03=a01*a02;
a04=arg[2]? arg[2][0] : 0;
a05=arg[3]? arg[3][0] : 0;
a06=a04+a05;
a06=casadi_sq(a06);
a03=a03*a06;
a06=-4.;
a07=a06*a03;
a08=arg[1]? arg[1][0] : 0;
a09=arg[0]? arg[0][0] : 0;
a10=a08*a09;
a11=1./a09;
a12=casadi_sq(a04);
a12=a12/a08;
a11=a11+a12;
a11=a01*a11;
a12=1./a09;
a13=casadi_sq(a05);
a13=a13/a08;
a12=a12+a13;
a13=a02*a12;
a11=a11+a13;
a13=casadi_sq(a11);
a10=a10*a13;
a07=a07+a10;
a07=a03*a07;
a07=-a07;
if (res[0]!=0) res[0][0]=a07;
a07=a08*a09;
a07=a07*a11;
a13=2.*a03;
a14=5.0000000000000000e-01;
a15=arg[5]? arg[5][0] : 0;
a14=a14*a15;
a15=arg[6]? arg[6][0] : 0;
a14=a14*a15;
a15=arg[4]? arg[4][0] : 0;
a14=a14*a15;
a12=a14*a12;
a13=a13*a12;
a15=casadi_sq(a04);
a15=a01*a15;
a15=a15*a14;
a16=4.;
a16=a16*a00;
a16=a16*a04;
a16=a16*a05;
a16=a16*a14;
a15=a15+a16;
a04=a01*a04;
a04=a04*a09;
a15=a15-a04;
a04=casadi_sq(a05);
a01=a01*a04;
a01=a01*a14;
a15=a15+a01;
a02=a02*a05;
a02=a02*a09;
a15=a15+a02;
a02=a15*a11;
a13=a13-a02;
a07=a07*a13;
a07=-a07;
if (res[1]!=0) res[1][0]=a07;
a07=-2.;
a07=a07*a08;
a07=a07*a09;
a07=a07*a15;
a07=a07*a12;
a07=a07*a11;
a13=8.;
a13=a13*a03;
a05=a05*a14;
a05=a05*a09;
a13=a13*a05;
a07=a07-a13;
a13=3.;
a03=a13*a03;
a14=a08*a09;
a02=casadi_sq(a12);
a14=a14*a02;
a03=a03*a14;
a07=a07+a03;
a13=a13*a05;
a13=a13*a10;
a07=a07+a13;
if (res[2]!=0) res[2][0]=a07;
a08=a08*a09;
a08=a08*a12;
a15=a15*a12;
a09=2.*a05;
a09=a09*a11;
a15=a15-a09;
a08=a08*a15;
if (res[3]!=0) res[3][0]=a08;
a06=a06*a05;
a06=a06+a14;
a05=a05*a06;
a05=-a05;
if (res[4]!=0) res[4][0]=a05;
a11=a11/a12;
a11=sqrt(a11);
if (res[5]!=0) res[5][0]=a11;
return 0;
}
CASADI_SYMBOL_EXPORT int stationary_decay(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f28(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int stationary_decay_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void stationary_decay_release(int mem) {
}
CASADI_SYMBOL_EXPORT void stationary_decay_incref(void) {
}
CASADI_SYMBOL_EXPORT void stationary_decay_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int stationary_decay_n_in(void) { return 9;}
CASADI_SYMBOL_EXPORT casadi_int stationary_decay_n_out(void) { return 6;}
CASADI_SYMBOL_EXPORT casadi_real stationary_decay_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* stationary_decay_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "Izz";
case 2: return "a";
case 3: return "b";
case 4: return "rho";
case 5: return "Ap";
case 6: return "CL_gamma";
case 7: return "C_alpha";
case 8: return "Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* stationary_decay_name_out(casadi_int i) {
switch (i) {
case 0: return "e_0";
case 1: return "e_1";
case 2: return "e_2";
case 3: return "e_3";
case 4: return "e_4";
case 5: return "u_trace";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* stationary_decay_sparsity_in(casadi_int i) {
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
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* stationary_decay_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int stationary_decay_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 9;
if (sz_res) *sz_res = 6;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int stationary_decay_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 9*sizeof(const casadi_real*);
if (sz_res) *sz_res = 6*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_stationary_decay:(m,Izz,a,b,rho,Ap,CL_gamma,C_alpha,Ct,out_e_0[1x1,0nz],out_e_1[1x1,0nz],out_e_2[1x1,0nz],out_e_3[1x1,0nz],out_e_4[1x1,0nz],out_u_trace[1x1,0nz],fwd_m,fwd_Izz,fwd_a,fwd_b,fwd_rho,fwd_Ap,fwd_CL_gamma,fwd_C_alpha,fwd_Ct)->(fwd_e_0,fwd_e_1,fwd_e_2,fwd_e_3,fwd_e_4,fwd_u_trace) */
static int casadi_f29(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44;
a00=-4.;
a01=arg[7]? arg[7][0] : 0;
a02=2.*a01;
a03=arg[8]? arg[8][0] : 0;
a04=a02*a03;
a05=arg[2]? arg[2][0] : 0;
a06=arg[3]? arg[3][0] : 0;
a07=a05+a06;
a08=casadi_sq(a07);
a09=a04*a08;
a10=a00*a09;
a11=arg[1]? arg[1][0] : 0;
a12=arg[0]? arg[0][0] : 0;
a13=a11*a12;
a14=1./a12;
a15=casadi_sq(a05);
a15=a15/a11;
a16=a14+a15;
a17=a02*a16;
a18=1./a12;
a19=casadi_sq(a06);
a19=a19/a11;
a20=a18+a19;
a21=a03*a20;
a17=a17+a21;
a21=casadi_sq(a17);
a22=a13*a21;
a10=a10+a22;
a23=arg[22]? arg[22][0] : 0;
a24=2.*a23;
a25=a03*a24;
a26=arg[23]? arg[23][0] : 0;
a27=a02*a26;
a25=a25+a27;
a08=a08*a25;
a07=2.*a07;
a25=arg[17]? arg[17][0] : 0;
a27=arg[18]? arg[18][0] : 0;
a28=a25+a27;
a07=a07*a28;
a04=a04*a07;
a08=a08+a04;
a10=a10*a08;
a04=a00*a08;
a07=arg[16]? arg[16][0] : 0;
a28=a12*a07;
a29=arg[15]? arg[15][0] : 0;
a30=a11*a29;
a28=a28+a30;
a21=a21*a28;
a28=2.*a17;
a16=a16*a24;
a30=2.*a05;
a30=a30*a25;
a30=a30/a11;
a15=a15/a11;
a15=a15*a07;
a30=a30-a15;
a14=a14/a12;
a14=a14*a29;
a30=a30-a14;
a30=a02*a30;
a16=a16+a30;
a30=a20*a26;
a14=2.*a06;
a14=a14*a27;
a14=a14/a11;
a19=a19/a11;
a19=a19*a07;
a14=a14-a19;
a18=a18/a12;
a18=a18*a29;
a14=a14-a18;
a18=a03*a14;
a30=a30+a18;
a16=a16+a30;
a28=a28*a16;
a13=a13*a28;
a21=a21+a13;
a04=a04+a21;
a04=a09*a04;
a10=a10+a04;
a10=-a10;
if (res[0]!=0) res[0][0]=a10;
a10=2.*a09;
a04=5.0000000000000000e-01;
a13=arg[5]? arg[5][0] : 0;
a13=a04*a13;
a28=arg[6]? arg[6][0] : 0;
a30=a13*a28;
a18=arg[4]? arg[4][0] : 0;
a19=a30*a18;
a15=a19*a20;
a31=a10*a15;
a32=casadi_sq(a05);
a33=a02*a32;
a34=a33*a19;
a35=4.;
a01=a35*a01;
a36=a01*a05;
a37=a36*a06;
a38=a37*a19;
a34=a34+a38;
a38=a02*a05;
a39=a38*a12;
a34=a34-a39;
a39=casadi_sq(a06);
a40=a02*a39;
a41=a40*a19;
a34=a34+a41;
a41=a03*a06;
a42=a41*a12;
a34=a34+a42;
a42=a34*a17;
a31=a31-a42;
a42=a12*a07;
a43=a11*a29;
a42=a42+a43;
a42=a17*a42;
a43=a11*a12;
a44=a43*a16;
a42=a42+a44;
a31=a31*a42;
a43=a43*a17;
a42=2.*a08;
a42=a15*a42;
a44=arg[20]? arg[20][0] : 0;
a04=a04*a44;
a28=a28*a04;
a04=arg[21]? arg[21][0] : 0;
a13=a13*a04;
a28=a28+a13;
a18=a18*a28;
a28=arg[19]? arg[19][0] : 0;
a30=a30*a28;
a18=a18+a30;
a20=a20*a18;
a14=a19*a14;
a20=a20+a14;
a10=a10*a20;
a42=a42+a10;
a32=a32*a24;
a10=2.*a05;
a10=a10*a25;
a10=a02*a10;
a32=a32+a10;
a32=a19*a32;
a33=a33*a18;
a32=a32+a33;
a35=a35*a23;
a35=a05*a35;
a01=a01*a25;
a35=a35+a01;
a35=a06*a35;
a36=a36*a27;
a35=a35+a36;
a35=a19*a35;
a37=a37*a18;
a35=a35+a37;
a32=a32+a35;
a05=a05*a24;
a25=a02*a25;
a05=a05+a25;
a05=a12*a05;
a38=a38*a29;
a05=a05+a38;
a32=a32-a05;
a39=a39*a24;
a24=2.*a06;
a24=a24*a27;
a02=a02*a24;
a39=a39+a02;
a39=a19*a39;
a40=a40*a18;
a39=a39+a40;
a32=a32+a39;
a26=a06*a26;
a03=a03*a27;
a26=a26+a03;
a26=a12*a26;
a41=a41*a29;
a26=a26+a41;
a32=a32+a26;
a26=a17*a32;
a41=a34*a16;
a26=a26+a41;
a42=a42-a26;
a43=a43*a42;
a31=a31+a43;
a31=-a31;
if (res[1]!=0) res[1][0]=a31;
a31=-2.;
a43=a31*a07;
a43=a12*a43;
a31=a31*a11;
a42=a31*a29;
a43=a43+a42;
a43=a34*a43;
a31=a31*a12;
a42=a31*a32;
a43=a43+a42;
a43=a15*a43;
a31=a31*a34;
a42=a31*a20;
a43=a43+a42;
a43=a17*a43;
a31=a31*a15;
a31=a31*a16;
a43=a43+a31;
a31=a06*a19;
a42=a31*a12;
a26=8.;
a41=a26*a08;
a41=a42*a41;
a26=a26*a09;
a19=a19*a27;
a06=a06*a18;
a19=a19+a06;
a19=a12*a19;
a31=a31*a29;
a19=a19+a31;
a26=a26*a19;
a41=a41+a26;
a43=a43-a41;
a41=a11*a12;
a26=casadi_sq(a15);
a31=a41*a26;
a06=3.;
a08=a06*a08;
a08=a31*a08;
a09=a06*a09;
a18=a12*a07;
a27=a11*a29;
a18=a18+a27;
a26=a26*a18;
a18=2.*a15;
a18=a18*a20;
a41=a41*a18;
a26=a26+a41;
a09=a09*a26;
a08=a08+a09;
a43=a43+a08;
a08=a06*a19;
a22=a22*a08;
a06=a06*a42;
a06=a06*a21;
a22=a22+a06;
a43=a43+a22;
if (res[2]!=0) res[2][0]=a43;
a43=a34*a15;
a22=2.*a42;
a06=a22*a17;
a43=a43-a06;
a07=a12*a07;
a29=a11*a29;
a07=a07+a29;
a07=a15*a07;
a11=a11*a12;
a12=a11*a20;
a07=a07+a12;
a43=a43*a07;
a11=a11*a15;
a32=a15*a32;
a34=a34*a20;
a32=a32+a34;
a34=2.*a19;
a34=a17*a34;
a22=a22*a16;
a34=a34+a22;
a32=a32-a34;
a11=a11*a32;
a43=a43+a11;
if (res[3]!=0) res[3][0]=a43;
a43=a00*a42;
a43=a43+a31;
a43=a43*a19;
a00=a00*a19;
a00=a00+a26;
a42=a42*a00;
a43=a43+a42;
a43=-a43;
if (res[4]!=0) res[4][0]=a43;
a16=a16/a15;
a17=a17/a15;
a15=a17/a15;
a15=a15*a20;
a16=a16-a15;
a17=sqrt(a17);
a17=2.*a17;
a16=a16/a17;
if (res[5]!=0) res[5][0]=a16;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_stationary_decay(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f29(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_stationary_decay_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_stationary_decay_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_stationary_decay_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_stationary_decay_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_stationary_decay_n_in(void) { return 24;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_stationary_decay_n_out(void) { return 6;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_stationary_decay_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_stationary_decay_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "Izz";
case 2: return "a";
case 3: return "b";
case 4: return "rho";
case 5: return "Ap";
case 6: return "CL_gamma";
case 7: return "C_alpha";
case 8: return "Ct";
case 9: return "out_e_0";
case 10: return "out_e_1";
case 11: return "out_e_2";
case 12: return "out_e_3";
case 13: return "out_e_4";
case 14: return "out_u_trace";
case 15: return "fwd_m";
case 16: return "fwd_Izz";
case 17: return "fwd_a";
case 18: return "fwd_b";
case 19: return "fwd_rho";
case 20: return "fwd_Ap";
case 21: return "fwd_CL_gamma";
case 22: return "fwd_C_alpha";
case 23: return "fwd_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_stationary_decay_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_e_0";
case 1: return "fwd_e_1";
case 2: return "fwd_e_2";
case 3: return "fwd_e_3";
case 4: return "fwd_e_4";
case 5: return "fwd_u_trace";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_stationary_decay_sparsity_in(casadi_int i) {
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
case 9: return casadi_s1;
case 10: return casadi_s1;
case 11: return casadi_s1;
case 12: return casadi_s1;
case 13: return casadi_s1;
case 14: return casadi_s1;
case 15: return casadi_s0;
case 16: return casadi_s0;
case 17: return casadi_s0;
case 18: return casadi_s0;
case 19: return casadi_s0;
case 20: return casadi_s0;
case 21: return casadi_s0;
case 22: return casadi_s0;
case 23: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_stationary_decay_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_stationary_decay_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 24;
if (sz_res) *sz_res = 6;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_stationary_decay_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 24*sizeof(const casadi_real*);
if (sz_res) *sz_res = 6*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_stationary_decay:(m,Izz,a,b,rho,Ap,CL_gamma,C_alpha,Ct,out_e_0[1x1,0nz],out_e_1[1x1,0nz],out_e_2[1x1,0nz],out_e_3[1x1,0nz],out_e_4[1x1,0nz],out_u_trace[1x1,0nz],adj_e_0,adj_e_1,adj_e_2,adj_e_3,adj_e_4,adj_u_trace)->(adj_m,adj_Izz,adj_a,adj_b,adj_rho,adj_Ap,adj_CL_gamma,adj_C_alpha,adj_Ct) */
static int casadi_f30(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
casadi_real a60, a61, a62, a63, a64, a65;
a00=arg[1]? arg[1][0] : 0;
a01=5.0000000000000000e-01;
a02=arg[5]? arg[5][0] : 0;
a02=a01*a02;
a03=arg[6]? arg[6][0] : 0;
a04=a02*a03;
a05=arg[4]? arg[4][0] : 0;
a06=a04*a05;
a07=arg[0]? arg[0][0] : 0;
a08=1./a07;
a09=arg[3]? arg[3][0] : 0;
a10=casadi_sq(a09);
a10=a10/a00;
a11=a08+a10;
a12=a06*a11;
a13=arg[7]? arg[7][0] : 0;
a14=2.*a13;
a15=arg[2]? arg[2][0] : 0;
a16=casadi_sq(a15);
a17=a14*a16;
a18=a17*a06;
a19=4.;
a13=a19*a13;
a20=a13*a15;
a21=a20*a09;
a22=a21*a06;
a18=a18+a22;
a22=a14*a15;
a23=a22*a07;
a18=a18-a23;
a23=casadi_sq(a09);
a24=a14*a23;
a25=a24*a06;
a18=a18+a25;
a25=arg[8]? arg[8][0] : 0;
a26=a25*a09;
a27=a26*a07;
a18=a18+a27;
a27=a18*a12;
a28=a09*a06;
a29=a28*a07;
a30=2.*a29;
a31=1./a07;
a32=casadi_sq(a15);
a32=a32/a00;
a33=a31+a32;
a34=a14*a33;
a35=a25*a11;
a34=a34+a35;
a35=a30*a34;
a27=a27-a35;
a35=arg[18]? arg[18][0] : 0;
a27=a27*a35;
a36=a12*a27;
a37=a00*a36;
a38=casadi_sq(a12);
a39=3.;
a40=a14*a25;
a41=a15+a09;
a42=casadi_sq(a41);
a43=a40*a42;
a44=a39*a43;
a45=arg[17]? arg[17][0] : 0;
a44=a44*a45;
a46=arg[19]? arg[19][0] : 0;
a47=a29*a46;
a44=a44-a47;
a48=a38*a44;
a49=a00*a48;
a37=a37+a49;
a49=a00*a07;
a50=a49*a12;
a50=a50*a35;
a35=a34*a50;
a35=-a35;
a35=2.*a35;
a51=-4.;
a52=a51*a29;
a53=a00*a07;
a38=a53*a38;
a52=a52+a38;
a52=a52*a46;
a47=a51*a47;
a52=a52+a47;
a35=a35-a52;
a52=a00*a07;
a47=casadi_sq(a34);
a46=a52*a47;
a54=a46*a45;
a54=a39*a54;
a35=a35+a54;
a54=8.;
a55=a54*a43;
a55=a55*a45;
a35=a35-a55;
a28=a28*a35;
a37=a37+a28;
a28=-2.;
a55=a28*a00;
a56=a34*a45;
a57=a12*a56;
a58=a18*a57;
a59=a55*a58;
a37=a37+a59;
a59=a12*a50;
a55=a55*a07;
a57=a55*a57;
a59=a59+a57;
a57=a00*a07;
a60=a57*a34;
a61=arg[16]? arg[16][0] : 0;
a60=a60*a61;
a62=a34*a60;
a59=a59+a62;
a26=a26*a59;
a37=a37+a26;
a22=a22*a59;
a37=a37-a22;
a22=2.*a43;
a26=a22*a12;
a62=a18*a34;
a26=a26-a62;
a26=a26*a61;
a61=a34*a26;
a62=a00*a61;
a37=a37-a62;
a08=a08/a07;
a62=a18*a50;
a63=a34/a12;
a64=a63/a12;
a65=arg[20]? arg[20][0] : 0;
a63=sqrt(a63);
a63=2.*a63;
a65=a65/a63;
a64=a64*a65;
a62=a62-a64;
a49=a49*a27;
a62=a62+a49;
a49=2.*a12;
a53=a53*a44;
a49=a49*a53;
a62=a62+a49;
a55=a55*a18;
a56=a55*a56;
a62=a62+a56;
a22=a22*a60;
a62=a62-a22;
a22=a06*a62;
a65=a65/a12;
a30=a30*a50;
a65=a65-a30;
a55=a55*a12;
a55=a55*a45;
a65=a65+a55;
a18=a18*a60;
a65=a65+a18;
a57=a57*a26;
a65=a65-a57;
a34=2.*a34;
a57=a39*a29;
a57=a57*a45;
a26=arg[15]? arg[15][0] : 0;
a18=a43*a26;
a57=a57-a18;
a52=a52*a57;
a34=a34*a52;
a65=a65+a34;
a34=a25*a65;
a22=a22+a34;
a08=a08*a22;
a37=a37-a08;
a31=a31/a07;
a08=a14*a65;
a31=a31*a08;
a37=a37-a31;
a47=a47*a57;
a57=a00*a47;
a37=a37+a57;
if (res[0]!=0) res[0][0]=a37;
a36=a07*a36;
a48=a07*a48;
a36=a36+a48;
a58=a07*a58;
a28=a28*a58;
a36=a36+a28;
a61=a07*a61;
a36=a36-a61;
a10=a10/a00;
a10=a10*a22;
a36=a36-a10;
a32=a32/a00;
a32=a32*a08;
a36=a36-a32;
a47=a07*a47;
a36=a36+a47;
if (res[1]!=0) res[1][0]=a36;
a36=a06*a59;
a47=a09*a36;
a13=a13*a47;
a32=a07*a59;
a10=a14*a32;
a13=a13-a10;
a10=2.*a15;
a61=a06*a59;
a28=a14*a61;
a10=a10*a28;
a13=a13+a10;
a10=2.*a15;
a08=a08/a00;
a10=a10*a08;
a13=a13+a10;
a41=2.*a41;
a38=a38*a45;
a39=a39*a38;
a29=a29*a45;
a54=a54*a29;
a39=a39-a54;
a12=a12*a60;
a12=-a12;
a12=2.*a12;
a39=a39+a12;
a43=a51*a43;
a43=a43+a46;
a43=a43*a26;
a39=a39-a43;
a51=a51*a18;
a39=a39-a51;
a40=a40*a39;
a41=a41*a40;
a13=a13+a41;
if (res[2]!=0) res[2][0]=a13;
a35=a07*a35;
a13=a06*a35;
a07=a07*a59;
a40=a25*a07;
a13=a13+a40;
a40=2.*a09;
a06=a06*a59;
a51=a14*a06;
a40=a40*a51;
a13=a13+a40;
a20=a20*a36;
a13=a13+a20;
a20=2.*a09;
a22=a22/a00;
a20=a20*a22;
a13=a13+a20;
a13=a13+a41;
if (res[3]!=0) res[3][0]=a13;
a35=a09*a35;
a24=a24*a59;
a35=a35+a24;
a21=a21*a59;
a35=a35+a21;
a17=a17*a59;
a35=a35+a17;
a62=a11*a62;
a35=a35+a62;
a04=a04*a35;
if (res[4]!=0) res[4][0]=a04;
a05=a05*a35;
a03=a03*a05;
a01=a01*a03;
if (res[5]!=0) res[5][0]=a01;
a02=a02*a05;
if (res[6]!=0) res[6][0]=a02;
a47=a15*a47;
a19=a19*a47;
a23=a23*a06;
a15=a15*a32;
a23=a23-a15;
a16=a16*a61;
a23=a23+a16;
a33=a33*a65;
a23=a23+a33;
a42=a42*a39;
a25=a25*a42;
a23=a23+a25;
a23=2.*a23;
a19=a19+a23;
if (res[7]!=0) res[7][0]=a19;
a09=a09*a07;
a11=a11*a65;
a09=a09+a11;
a14=a14*a42;
a09=a09+a14;
if (res[8]!=0) res[8][0]=a09;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_stationary_decay(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f30(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_stationary_decay_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_stationary_decay_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_stationary_decay_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_stationary_decay_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_stationary_decay_n_in(void) { return 21;}
CASADI_SYMBOL_EXPORT casadi_int adj1_stationary_decay_n_out(void) { return 9;}
CASADI_SYMBOL_EXPORT casadi_real adj1_stationary_decay_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_stationary_decay_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "Izz";
case 2: return "a";
case 3: return "b";
case 4: return "rho";
case 5: return "Ap";
case 6: return "CL_gamma";
case 7: return "C_alpha";
case 8: return "Ct";
case 9: return "out_e_0";
case 10: return "out_e_1";
case 11: return "out_e_2";
case 12: return "out_e_3";
case 13: return "out_e_4";
case 14: return "out_u_trace";
case 15: return "adj_e_0";
case 16: return "adj_e_1";
case 17: return "adj_e_2";
case 18: return "adj_e_3";
case 19: return "adj_e_4";
case 20: return "adj_u_trace";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_stationary_decay_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_m";
case 1: return "adj_Izz";
case 2: return "adj_a";
case 3: return "adj_b";
case 4: return "adj_rho";
case 5: return "adj_Ap";
case 6: return "adj_CL_gamma";
case 7: return "adj_C_alpha";
case 8: return "adj_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_stationary_decay_sparsity_in(casadi_int i) {
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
case 9: return casadi_s1;
case 10: return casadi_s1;
case 11: return casadi_s1;
case 12: return casadi_s1;
case 13: return casadi_s1;
case 14: return casadi_s1;
case 15: return casadi_s0;
case 16: return casadi_s0;
case 17: return casadi_s0;
case 18: return casadi_s0;
case 19: return casadi_s0;
case 20: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_stationary_decay_sparsity_out(casadi_int i) {
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
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_stationary_decay_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 21;
if (sz_res) *sz_res = 9;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_stationary_decay_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 21*sizeof(const casadi_real*);
if (sz_res) *sz_res = 9*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_stationary_decay:(m,Izz,a,b,rho,Ap,CL_gamma,C_alpha,Ct,out_e_0[1x1,0nz],out_e_1[1x1,0nz],out_e_2[1x1,0nz],out_e_3[1x1,0nz],out_e_4[1x1,0nz],out_u_trace[1x1,0nz],adj_e_0,adj_e_1,adj_e_2,adj_e_3,adj_e_4,adj_u_trace,out_adj_m[1x1,0nz],out_adj_Izz[1x1,0nz],out_adj_a[1x1,0nz],out_adj_b[1x1,0nz],out_adj_rho[1x1,0nz],out_adj_Ap[1x1,0nz],out_adj_CL_gamma[1x1,0nz],out_adj_C_alpha[1x1,0nz],out_adj_Ct[1x1,0nz],fwd_m,fwd_Izz,fwd_a,fwd_b,fwd_rho,fwd_Ap,fwd_CL_gamma,fwd_C_alpha,fwd_Ct,fwd_out_e_0[1x1,0nz],fwd_out_e_1[1x1,0nz],fwd_out_e_2[1x1,0nz],fwd_out_e_3[1x1,0nz],fwd_out_e_4[1x1,0nz],fwd_out_u_trace[1x1,0nz],fwd_adj_e_0,fwd_adj_e_1,fwd_adj_e_2,fwd_adj_e_3,fwd_adj_e_4,fwd_adj_u_trace)->(fwd_adj_m,fwd_adj_Izz,fwd_adj_a,fwd_adj_b,fwd_adj_rho,fwd_adj_Ap,fwd_adj_CL_gamma,fwd_adj_C_alpha,fwd_adj_Ct) */
static int casadi_f31(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a000, a001, a002, a003, a004, a005, a006, a007, a008, a009, a010, a011;
casadi_real a012, a013, a014, a015, a016, a017, a018, a019, a020, a021, a022, a023;
casadi_real a024, a025, a026, a027, a028, a029, a030, a031, a032, a033, a034, a035;
casadi_real a036, a037, a038, a039, a040, a041, a042, a043, a044, a045, a046, a047;
casadi_real a048, a049, a050, a051, a052, a053, a054, a055, a056, a057, a058, a059;
casadi_real a060, a061, a062, a063, a064, a065, a066, a067, a068, a069, a070, a071;
casadi_real a072, a073, a074, a075, a076, a077, a078, a079, a080, a081, a082, a083;
casadi_real a084, a085, a086, a087, a088, a089, a090, a091, a092, a093, a094, a095;
casadi_real a096, a097, a098, a099, a100, a101, a102, a103, a104, a105, a106, a107;
casadi_real a108, a109, a110, a111, a112, a113, a114, a115, a116, a117, a118, a119;
casadi_real a120, a121, a122, a123, a124, a125, a126, a127, a128, a129;
a000=5.0000000000000000e-01;
a001=arg[5]? arg[5][0] : 0;
a001=a000*a001;
a002=arg[6]? arg[6][0] : 0;
a003=a001*a002;
a004=arg[4]? arg[4][0] : 0;
a005=a003*a004;
a006=arg[0]? arg[0][0] : 0;
a007=1./a006;
a008=arg[3]? arg[3][0] : 0;
a009=casadi_sq(a008);
a010=arg[1]? arg[1][0] : 0;
a009=a009/a010;
a011=a007+a009;
a012=a005*a011;
a013=arg[7]? arg[7][0] : 0;
a014=2.*a013;
a015=arg[2]? arg[2][0] : 0;
a016=casadi_sq(a015);
a017=a014*a016;
a018=a017*a005;
a019=4.;
a013=a019*a013;
a020=a013*a015;
a021=a020*a008;
a022=a021*a005;
a018=a018+a022;
a022=a014*a015;
a023=a022*a006;
a018=a018-a023;
a023=casadi_sq(a008);
a024=a014*a023;
a025=a024*a005;
a018=a018+a025;
a025=arg[8]? arg[8][0] : 0;
a026=a025*a008;
a027=a026*a006;
a018=a018+a027;
a027=a018*a012;
a028=a008*a005;
a029=a028*a006;
a030=2.*a029;
a031=1./a006;
a032=casadi_sq(a015);
a032=a032/a010;
a033=a031+a032;
a034=a014*a033;
a035=a025*a011;
a034=a034+a035;
a035=a030*a034;
a027=a027-a035;
a035=arg[18]? arg[18][0] : 0;
a036=a027*a035;
a037=a012*a036;
a038=arg[31]? arg[31][0] : 0;
a039=a037*a038;
a040=arg[35]? arg[35][0] : 0;
a040=a000*a040;
a041=a002*a040;
a042=arg[36]? arg[36][0] : 0;
a043=a001*a042;
a041=a041+a043;
a043=a004*a041;
a044=arg[34]? arg[34][0] : 0;
a045=a003*a044;
a043=a043+a045;
a045=a011*a043;
a046=2.*a008;
a047=arg[33]? arg[33][0] : 0;
a046=a046*a047;
a046=a046/a010;
a048=a009/a010;
a048=a048*a038;
a046=a046-a048;
a048=a007/a006;
a049=arg[30]? arg[30][0] : 0;
a048=a048*a049;
a050=a046-a048;
a051=a005*a050;
a045=a045+a051;
a051=a036*a045;
a052=arg[37]? arg[37][0] : 0;
a053=2.*a052;
a054=a016*a053;
a055=2.*a015;
a056=arg[32]? arg[32][0] : 0;
a055=a055*a056;
a057=a014*a055;
a054=a054+a057;
a057=a005*a054;
a058=a017*a043;
a057=a057+a058;
a052=a019*a052;
a058=a015*a052;
a059=a013*a056;
a058=a058+a059;
a059=a008*a058;
a060=a020*a047;
a059=a059+a060;
a060=a005*a059;
a061=a021*a043;
a060=a060+a061;
a057=a057+a060;
a060=a015*a053;
a061=a014*a056;
a060=a060+a061;
a061=a006*a060;
a062=a022*a049;
a061=a061+a062;
a057=a057-a061;
a061=a023*a053;
a062=2.*a008;
a062=a062*a047;
a063=a014*a062;
a061=a061+a063;
a063=a005*a061;
a064=a024*a043;
a063=a063+a064;
a057=a057+a063;
a063=arg[38]? arg[38][0] : 0;
a064=a008*a063;
a065=a025*a047;
a064=a064+a065;
a065=a006*a064;
a066=a026*a049;
a065=a065+a066;
a057=a057+a065;
a065=a012*a057;
a066=a018*a045;
a065=a065+a066;
a066=a005*a047;
a067=a008*a043;
a066=a066+a067;
a067=a006*a066;
a068=a028*a049;
a067=a067+a068;
a068=2.*a067;
a069=a034*a068;
a070=a033*a053;
a071=2.*a015;
a071=a071*a056;
a071=a071/a010;
a072=a032/a010;
a072=a072*a038;
a071=a071-a072;
a072=a031/a006;
a072=a072*a049;
a073=a071-a072;
a074=a014*a073;
a070=a070+a074;
a074=a011*a063;
a075=a025*a050;
a074=a074+a075;
a070=a070+a074;
a074=a030*a070;
a069=a069+a074;
a065=a065-a069;
a065=a035*a065;
a069=arg[48]? arg[48][0] : 0;
a027=a027*a069;
a065=a065+a027;
a027=a012*a065;
a051=a051+a027;
a027=a010*a051;
a039=a039+a027;
a027=casadi_sq(a012);
a074=3.;
a075=a014*a025;
a076=a015+a008;
a077=casadi_sq(a076);
a078=a075*a077;
a079=a074*a078;
a080=arg[17]? arg[17][0] : 0;
a081=a079*a080;
a082=arg[19]? arg[19][0] : 0;
a083=a029*a082;
a081=a081-a083;
a084=a027*a081;
a085=a084*a038;
a086=2.*a012;
a086=a086*a045;
a087=a081*a086;
a088=a025*a053;
a089=a014*a063;
a088=a088+a089;
a089=a077*a088;
a090=2.*a076;
a091=a056+a047;
a090=a090*a091;
a092=a075*a090;
a089=a089+a092;
a092=a074*a089;
a092=a080*a092;
a093=arg[47]? arg[47][0] : 0;
a079=a079*a093;
a092=a092+a079;
a079=a082*a067;
a094=arg[49]? arg[49][0] : 0;
a095=a029*a094;
a079=a079+a095;
a092=a092-a079;
a095=a027*a092;
a087=a087+a095;
a095=a010*a087;
a085=a085+a095;
a039=a039+a085;
a085=a010*a006;
a095=a085*a012;
a096=a095*a035;
a097=a034*a096;
a097=-a097;
a097=2.*a097;
a098=-4.;
a099=a098*a029;
a100=a010*a006;
a101=a100*a027;
a099=a099+a101;
a102=a099*a082;
a083=a098*a083;
a102=a102+a083;
a097=a097-a102;
a102=a010*a006;
a083=casadi_sq(a034);
a103=a102*a083;
a104=a103*a080;
a104=a074*a104;
a097=a097+a104;
a104=8.;
a105=a104*a078;
a106=a105*a080;
a097=a097-a106;
a066=a097*a066;
a106=a096*a070;
a107=a006*a038;
a108=a010*a049;
a107=a107+a108;
a108=a012*a107;
a109=a085*a045;
a108=a108+a109;
a035=a035*a108;
a095=a095*a069;
a035=a035+a095;
a095=a034*a035;
a106=a106+a095;
a106=-a106;
a106=2.*a106;
a095=a098*a067;
a069=a006*a038;
a108=a010*a049;
a069=a069+a108;
a027=a027*a069;
a086=a100*a086;
a027=a027+a086;
a095=a095+a027;
a082=a082*a095;
a099=a099*a094;
a082=a082+a099;
a079=a098*a079;
a082=a082+a079;
a106=a106-a082;
a082=a006*a038;
a079=a010*a049;
a082=a082+a079;
a079=a083*a082;
a099=2.*a034;
a099=a099*a070;
a094=a102*a099;
a079=a079+a094;
a094=a080*a079;
a095=a103*a093;
a094=a094+a095;
a094=a074*a094;
a106=a106+a094;
a094=a104*a089;
a094=a080*a094;
a105=a105*a093;
a094=a094+a105;
a106=a106-a094;
a028=a028*a106;
a066=a066+a028;
a039=a039+a066;
a066=a034*a080;
a028=a012*a066;
a094=a018*a028;
a105=-2.;
a095=a105*a038;
a086=a094*a095;
a108=a105*a010;
a109=a028*a057;
a110=a066*a045;
a111=a080*a070;
a112=a034*a093;
a111=a111+a112;
a112=a012*a111;
a110=a110+a112;
a112=a018*a110;
a109=a109+a112;
a112=a108*a109;
a086=a086+a112;
a039=a039+a086;
a086=a012*a096;
a112=a108*a006;
a113=a112*a028;
a086=a086+a113;
a113=a010*a006;
a114=a113*a034;
a115=arg[16]? arg[16][0] : 0;
a116=a114*a115;
a117=a034*a116;
a086=a086+a117;
a064=a086*a064;
a117=a096*a045;
a118=a012*a035;
a117=a117+a118;
a095=a006*a095;
a108=a108*a049;
a095=a095+a108;
a028=a028*a095;
a110=a112*a110;
a028=a028+a110;
a117=a117+a028;
a028=a116*a070;
a110=a006*a038;
a108=a010*a049;
a110=a110+a108;
a108=a034*a110;
a118=a113*a070;
a108=a108+a118;
a108=a115*a108;
a118=arg[46]? arg[46][0] : 0;
a114=a114*a118;
a108=a108+a114;
a114=a034*a108;
a028=a028+a114;
a117=a117+a028;
a026=a026*a117;
a064=a064+a026;
a039=a039+a064;
a060=a086*a060;
a022=a022*a117;
a060=a060+a022;
a039=a039-a060;
a060=2.*a078;
a022=a060*a012;
a064=a018*a034;
a022=a022-a064;
a064=a022*a115;
a026=a034*a064;
a028=a026*a038;
a114=a064*a070;
a119=2.*a089;
a120=a012*a119;
a121=a060*a045;
a120=a120+a121;
a121=a034*a057;
a122=a018*a070;
a121=a121+a122;
a120=a120-a121;
a115=a115*a120;
a022=a022*a118;
a115=a115+a022;
a022=a034*a115;
a114=a114+a022;
a022=a010*a114;
a028=a028+a022;
a039=a039-a028;
a007=a007/a006;
a028=a018*a096;
a022=a034/a012;
a118=a022/a012;
a120=arg[20]? arg[20][0] : 0;
a121=sqrt(a022);
a122=2.*a121;
a120=a120/a122;
a123=a118*a120;
a028=a028-a123;
a123=a085*a036;
a028=a028+a123;
a123=2.*a012;
a124=a100*a081;
a125=a123*a124;
a028=a028+a125;
a125=a112*a018;
a126=a125*a066;
a028=a028+a126;
a126=a060*a116;
a028=a028-a126;
a126=a028*a043;
a127=a096*a057;
a128=a018*a035;
a127=a127+a128;
a128=a070/a012;
a022=a022/a012;
a022=a022*a045;
a128=a128-a022;
a022=a128/a012;
a129=a118/a012;
a129=a129*a045;
a022=a022-a129;
a022=a120*a022;
a129=arg[50]? arg[50][0] : 0;
a129=a129/a122;
a122=a120/a122;
a121=2.*a121;
a128=a128/a121;
a128=2.*a128;
a122=a122*a128;
a129=a129-a122;
a118=a118*a129;
a022=a022+a118;
a127=a127-a022;
a036=a036*a107;
a085=a085*a065;
a036=a036+a085;
a127=a127+a036;
a036=2.*a045;
a124=a124*a036;
a081=a081*a069;
a100=a100*a092;
a081=a081+a100;
a123=a123*a081;
a124=a124+a123;
a127=a127+a124;
a095=a018*a095;
a112=a112*a057;
a095=a095+a112;
a066=a066*a095;
a111=a125*a111;
a066=a066+a111;
a127=a127+a066;
a119=a116*a119;
a060=a060*a108;
a119=a119+a060;
a127=a127-a119;
a119=a005*a127;
a126=a126+a119;
a120=a120/a012;
a119=a030*a096;
a119=a120-a119;
a060=a125*a012;
a066=a060*a080;
a119=a119+a066;
a066=a018*a116;
a119=a119+a066;
a066=a113*a064;
a119=a119-a066;
a034=2.*a034;
a066=a074*a029;
a111=a066*a080;
a112=arg[15]? arg[15][0] : 0;
a124=a078*a112;
a111=a111-a124;
a123=a102*a111;
a081=a034*a123;
a119=a119+a081;
a081=a119*a063;
a129=a129/a012;
a120=a120/a012;
a120=a120*a045;
a129=a129-a120;
a096=a096*a068;
a030=a030*a035;
a096=a096+a030;
a129=a129-a096;
a095=a012*a095;
a125=a125*a045;
a095=a095+a125;
a095=a080*a095;
a060=a060*a093;
a095=a095+a060;
a129=a129+a095;
a057=a116*a057;
a018=a018*a108;
a057=a057+a018;
a129=a129+a057;
a064=a064*a110;
a113=a113*a115;
a064=a064+a113;
a129=a129-a064;
a070=2.*a070;
a123=a123*a070;
a082=a111*a082;
a070=a074*a067;
a070=a080*a070;
a066=a066*a093;
a070=a070+a066;
a066=a112*a089;
a064=arg[45]? arg[45][0] : 0;
a113=a078*a064;
a066=a066+a113;
a070=a070-a066;
a102=a102*a070;
a082=a082+a102;
a034=a034*a082;
a123=a123+a034;
a129=a129+a123;
a123=a025*a129;
a081=a081+a123;
a126=a126+a081;
a081=a007*a126;
a123=a005*a028;
a034=a025*a119;
a123=a123+a034;
a048=a048/a006;
a007=a007/a006;
a007=a007*a049;
a048=a048+a007;
a048=a123*a048;
a081=a081-a048;
a039=a039-a081;
a031=a031/a006;
a081=a119*a053;
a048=a014*a129;
a081=a081+a048;
a048=a031*a081;
a007=a014*a119;
a072=a072/a006;
a031=a031/a006;
a031=a031*a049;
a072=a072+a031;
a072=a007*a072;
a048=a048-a072;
a039=a039-a048;
a048=a083*a111;
a072=a048*a038;
a111=a111*a099;
a083=a083*a070;
a111=a111+a083;
a083=a010*a111;
a072=a072+a083;
a039=a039+a072;
if (res[0]!=0) res[0][0]=a039;
a037=a037*a049;
a051=a006*a051;
a037=a037+a051;
a084=a084*a049;
a087=a006*a087;
a084=a084+a087;
a037=a037+a084;
a094=a094*a049;
a109=a006*a109;
a094=a094+a109;
a105=a105*a094;
a037=a037+a105;
a026=a026*a049;
a114=a006*a114;
a026=a026+a114;
a037=a037-a026;
a046=a046/a010;
a009=a009/a010;
a026=a009/a010;
a026=a026*a038;
a046=a046-a026;
a046=a123*a046;
a009=a009*a126;
a046=a046+a009;
a037=a037-a046;
a071=a071/a010;
a032=a032/a010;
a046=a032/a010;
a046=a046*a038;
a071=a071-a046;
a071=a007*a071;
a032=a032*a081;
a071=a071+a032;
a037=a037-a071;
a048=a048*a049;
a111=a006*a111;
a048=a048+a111;
a037=a037+a048;
if (res[1]!=0) res[1][0]=a037;
a037=a005*a086;
a048=a008*a037;
a052=a048*a052;
a111=a037*a047;
a071=a086*a043;
a032=a005*a117;
a071=a071+a032;
a032=a008*a071;
a111=a111+a032;
a013=a013*a111;
a052=a052+a013;
a013=a006*a086;
a032=a013*a053;
a046=a086*a049;
a009=a006*a117;
a046=a046+a009;
a009=a014*a046;
a032=a032+a009;
a052=a052-a032;
a032=a005*a086;
a009=a014*a032;
a026=2.*a056;
a009=a009*a026;
a026=2.*a015;
a114=a032*a053;
a105=a086*a043;
a094=a005*a117;
a105=a105+a094;
a094=a014*a105;
a114=a114+a094;
a026=a026*a114;
a009=a009+a026;
a052=a052+a009;
a007=a007/a010;
a009=2.*a056;
a009=a007*a009;
a026=2.*a015;
a081=a081/a010;
a007=a007/a010;
a007=a007*a038;
a081=a081-a007;
a026=a026*a081;
a009=a009+a026;
a052=a052+a009;
a009=a101*a080;
a009=a074*a009;
a026=a029*a080;
a026=a104*a026;
a009=a009-a026;
a026=a012*a116;
a026=-a026;
a026=2.*a026;
a009=a009+a026;
a078=a098*a078;
a078=a078+a103;
a103=a078*a112;
a009=a009-a103;
a124=a098*a124;
a009=a009-a124;
a124=a075*a009;
a091=2.*a091;
a124=a124*a091;
a076=2.*a076;
a088=a009*a088;
a027=a080*a027;
a101=a101*a093;
a027=a027+a101;
a074=a074*a027;
a080=a080*a067;
a029=a029*a093;
a080=a080+a029;
a104=a104*a080;
a074=a074-a104;
a116=a116*a045;
a012=a012*a108;
a116=a116+a012;
a116=-a116;
a116=2.*a116;
a074=a074+a116;
a089=a098*a089;
a089=a089+a079;
a112=a112*a089;
a078=a078*a064;
a112=a112+a078;
a074=a074-a112;
a098=a098*a066;
a074=a074-a098;
a075=a075*a074;
a088=a088+a075;
a076=a076*a088;
a124=a124+a076;
a052=a052+a124;
if (res[2]!=0) res[2][0]=a052;
a052=a006*a097;
a076=a052*a043;
a097=a097*a049;
a106=a006*a106;
a097=a097+a106;
a106=a005*a097;
a076=a076+a106;
a106=a006*a086;
a088=a106*a063;
a049=a086*a049;
a006=a006*a117;
a049=a049+a006;
a006=a025*a049;
a088=a088+a006;
a076=a076+a088;
a088=a005*a086;
a006=a014*a088;
a075=2.*a047;
a006=a006*a075;
a075=2.*a008;
a098=a088*a053;
a043=a086*a043;
a005=a005*a117;
a043=a043+a005;
a005=a014*a043;
a098=a098+a005;
a075=a075*a098;
a006=a006+a075;
a076=a076+a006;
a037=a037*a058;
a020=a020*a071;
a037=a037+a020;
a076=a076+a037;
a123=a123/a010;
a037=2.*a047;
a037=a123*a037;
a020=2.*a008;
a126=a126/a010;
a123=a123/a010;
a123=a123*a038;
a126=a126-a123;
a020=a020*a126;
a037=a037+a020;
a076=a076+a037;
a076=a076+a124;
if (res[3]!=0) res[3][0]=a076;
a076=a008*a052;
a124=a024*a086;
a076=a076+a124;
a124=a021*a086;
a076=a076+a124;
a124=a017*a086;
a076=a076+a124;
a124=a011*a028;
a076=a076+a124;
a041=a076*a041;
a052=a052*a047;
a097=a008*a097;
a052=a052+a097;
a061=a086*a061;
a024=a024*a117;
a061=a061+a024;
a052=a052+a061;
a059=a086*a059;
a021=a021*a117;
a059=a059+a021;
a052=a052+a059;
a086=a086*a054;
a017=a017*a117;
a086=a086+a017;
a052=a052+a086;
a028=a028*a050;
a127=a011*a127;
a028=a028+a127;
a052=a052+a028;
a003=a003*a052;
a041=a041+a003;
if (res[4]!=0) res[4][0]=a041;
a041=a004*a076;
a042=a041*a042;
a076=a076*a044;
a004=a004*a052;
a076=a076+a004;
a002=a002*a076;
a042=a042+a002;
a000=a000*a042;
if (res[5]!=0) res[5][0]=a000;
a041=a041*a040;
a001=a001*a076;
a041=a041+a001;
if (res[6]!=0) res[6][0]=a041;
a048=a048*a056;
a111=a015*a111;
a048=a048+a111;
a019=a019*a048;
a088=a088*a062;
a023=a023*a043;
a088=a088+a023;
a013=a013*a056;
a015=a015*a046;
a013=a013+a015;
a088=a088-a013;
a032=a032*a055;
a016=a016*a105;
a032=a032+a016;
a088=a088+a032;
a073=a119*a073;
a033=a033*a129;
a073=a073+a033;
a088=a088+a073;
a073=a077*a009;
a063=a073*a063;
a009=a009*a090;
a077=a077*a074;
a009=a009+a077;
a025=a025*a009;
a063=a063+a025;
a088=a088+a063;
a088=2.*a088;
a019=a019+a088;
if (res[7]!=0) res[7][0]=a019;
a106=a106*a047;
a008=a008*a049;
a106=a106+a008;
a119=a119*a050;
a011=a011*a129;
a119=a119+a011;
a106=a106+a119;
a073=a073*a053;
a014=a014*a009;
a073=a073+a014;
a106=a106+a073;
if (res[8]!=0) res[8][0]=a106;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_stationary_decay(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f31(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_stationary_decay_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_stationary_decay_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_stationary_decay_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_stationary_decay_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_stationary_decay_n_in(void) { return 51;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_stationary_decay_n_out(void) { return 9;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_stationary_decay_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_stationary_decay_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "Izz";
case 2: return "a";
case 3: return "b";
case 4: return "rho";
case 5: return "Ap";
case 6: return "CL_gamma";
case 7: return "C_alpha";
case 8: return "Ct";
case 9: return "out_e_0";
case 10: return "out_e_1";
case 11: return "out_e_2";
case 12: return "out_e_3";
case 13: return "out_e_4";
case 14: return "out_u_trace";
case 15: return "adj_e_0";
case 16: return "adj_e_1";
case 17: return "adj_e_2";
case 18: return "adj_e_3";
case 19: return "adj_e_4";
case 20: return "adj_u_trace";
case 21: return "out_adj_m";
case 22: return "out_adj_Izz";
case 23: return "out_adj_a";
case 24: return "out_adj_b";
case 25: return "out_adj_rho";
case 26: return "out_adj_Ap";
case 27: return "out_adj_CL_gamma";
case 28: return "out_adj_C_alpha";
case 29: return "out_adj_Ct";
case 30: return "fwd_m";
case 31: return "fwd_Izz";
case 32: return "fwd_a";
case 33: return "fwd_b";
case 34: return "fwd_rho";
case 35: return "fwd_Ap";
case 36: return "fwd_CL_gamma";
case 37: return "fwd_C_alpha";
case 38: return "fwd_Ct";
case 39: return "fwd_out_e_0";
case 40: return "fwd_out_e_1";
case 41: return "fwd_out_e_2";
case 42: return "fwd_out_e_3";
case 43: return "fwd_out_e_4";
case 44: return "fwd_out_u_trace";
case 45: return "fwd_adj_e_0";
case 46: return "fwd_adj_e_1";
case 47: return "fwd_adj_e_2";
case 48: return "fwd_adj_e_3";
case 49: return "fwd_adj_e_4";
case 50: return "fwd_adj_u_trace";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_stationary_decay_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_m";
case 1: return "fwd_adj_Izz";
case 2: return "fwd_adj_a";
case 3: return "fwd_adj_b";
case 4: return "fwd_adj_rho";
case 5: return "fwd_adj_Ap";
case 6: return "fwd_adj_CL_gamma";
case 7: return "fwd_adj_C_alpha";
case 8: return "fwd_adj_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_stationary_decay_sparsity_in(casadi_int i) {
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
case 9: return casadi_s1;
case 10: return casadi_s1;
case 11: return casadi_s1;
case 12: return casadi_s1;
case 13: return casadi_s1;
case 14: return casadi_s1;
case 15: return casadi_s0;
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
case 30: return casadi_s0;
case 31: return casadi_s0;
case 32: return casadi_s0;
case 33: return casadi_s0;
case 34: return casadi_s0;
case 35: return casadi_s0;
case 36: return casadi_s0;
case 37: return casadi_s0;
case 38: return casadi_s0;
case 39: return casadi_s1;
case 40: return casadi_s1;
case 41: return casadi_s1;
case 42: return casadi_s1;
case 43: return casadi_s1;
case 44: return casadi_s1;
case 45: return casadi_s0;
case 46: return casadi_s0;
case 47: return casadi_s0;
case 48: return casadi_s0;
case 49: return casadi_s0;
case 50: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_stationary_decay_sparsity_out(casadi_int i) {
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
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_stationary_decay_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 51;
if (sz_res) *sz_res = 9;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_stationary_decay_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 51*sizeof(const casadi_real*);
if (sz_res) *sz_res = 9*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* steady_margins:(m,a,b,u,rho,Ap,CL_gamma,C_alpha,Ct)->(x_neutral,static_margin,K_us) */
static int casadi_f32(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5;
a0=arg[7]? arg[7][0] : 0;
a0=2.*a0;
a1=arg[1]? arg[1][0] : 0;
a2=a0*a1;
a3=arg[8]? arg[8][0] : 0;
a4=5.0000000000000000e-01;
a5=arg[5]? arg[5][0] : 0;
a4=a4*a5;
a5=arg[6]? arg[6][0] : 0;
a4=a4*a5;
a5=arg[4]? arg[4][0] : 0;
a4=a4*a5;
a5=arg[3]? arg[3][0] : 0;
a5=casadi_sq(a5);
a4=a4*a5;
a3=a3+a4;
a4=arg[2]? arg[2][0] : 0;
a5=a3*a4;
a2=a2-a5;
a5=a0+a3;
a5=a2/a5;
if (res[0]!=0) res[0][0]=a5;
a1=a1+a4;
a5=a5/a1;
a5=-a5;
if (res[1]!=0) res[1][0]=a5;
a5=arg[0]? arg[0][0] : 0;
a5=a5*a2;
a0=a0*a3;
a0=a0*a1;
a5=a5/a0;
a5=-a5;
if (res[2]!=0) res[2][0]=a5;
return 0;
}
CASADI_SYMBOL_EXPORT int steady_margins(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f32(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int steady_margins_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void steady_margins_release(int mem) {
}
CASADI_SYMBOL_EXPORT void steady_margins_incref(void) {
}
CASADI_SYMBOL_EXPORT void steady_margins_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int steady_margins_n_in(void) { return 9;}
CASADI_SYMBOL_EXPORT casadi_int steady_margins_n_out(void) { return 3;}
CASADI_SYMBOL_EXPORT casadi_real steady_margins_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* steady_margins_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "a";
case 2: return "b";
case 3: return "u";
case 4: return "rho";
case 5: return "Ap";
case 6: return "CL_gamma";
case 7: return "C_alpha";
case 8: return "Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* steady_margins_name_out(casadi_int i) {
switch (i) {
case 0: return "x_neutral";
case 1: return "static_margin";
case 2: return "K_us";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* steady_margins_sparsity_in(casadi_int i) {
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
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* steady_margins_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int steady_margins_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 9;
if (sz_res) *sz_res = 3;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int steady_margins_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 9*sizeof(const casadi_real*);
if (sz_res) *sz_res = 3*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_steady_margins:(m,a,b,u,rho,Ap,CL_gamma,C_alpha,Ct,out_x_neutral[1x1,0nz],out_static_margin[1x1,0nz],out_K_us[1x1,0nz],fwd_m,fwd_a,fwd_b,fwd_u,fwd_rho,fwd_Ap,fwd_CL_gamma,fwd_C_alpha,fwd_Ct)->(fwd_x_neutral,fwd_static_margin,fwd_K_us) */
static int casadi_f33(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13;
a00=arg[1]? arg[1][0] : 0;
a01=arg[19]? arg[19][0] : 0;
a01=2.*a01;
a02=a00*a01;
a03=arg[7]? arg[7][0] : 0;
a03=2.*a03;
a04=arg[13]? arg[13][0] : 0;
a05=a03*a04;
a02=a02+a05;
a05=arg[2]? arg[2][0] : 0;
a06=arg[20]? arg[20][0] : 0;
a07=arg[3]? arg[3][0] : 0;
a08=casadi_sq(a07);
a09=arg[4]? arg[4][0] : 0;
a10=arg[6]? arg[6][0] : 0;
a11=5.0000000000000000e-01;
a12=arg[17]? arg[17][0] : 0;
a12=a11*a12;
a12=a10*a12;
a13=arg[5]? arg[5][0] : 0;
a11=a11*a13;
a13=arg[18]? arg[18][0] : 0;
a13=a11*a13;
a12=a12+a13;
a12=a09*a12;
a11=a11*a10;
a10=arg[16]? arg[16][0] : 0;
a10=a11*a10;
a12=a12+a10;
a12=a08*a12;
a11=a11*a09;
a07=2.*a07;
a09=arg[15]? arg[15][0] : 0;
a07=a07*a09;
a07=a11*a07;
a12=a12+a07;
a06=a06+a12;
a12=a05*a06;
a07=arg[8]? arg[8][0] : 0;
a11=a11*a08;
a07=a07+a11;
a11=arg[14]? arg[14][0] : 0;
a08=a07*a11;
a12=a12+a08;
a02=a02-a12;
a12=a03+a07;
a08=a02/a12;
a09=a03*a00;
a10=a07*a05;
a09=a09-a10;
a10=a09/a12;
a12=a10/a12;
a13=a01+a06;
a12=a12*a13;
a08=a08-a12;
if (res[0]!=0) res[0][0]=a08;
a00=a00+a05;
a08=a08/a00;
a10=a10/a00;
a10=a10/a00;
a04=a04+a11;
a10=a10*a04;
a08=a08-a10;
a08=-a08;
if (res[1]!=0) res[1][0]=a08;
a08=arg[12]? arg[12][0] : 0;
a08=a09*a08;
a10=arg[0]? arg[0][0] : 0;
a02=a10*a02;
a08=a08+a02;
a02=a03*a07;
a11=a02*a00;
a08=a08/a11;
a10=a10*a09;
a10=a10/a11;
a10=a10/a11;
a07=a07*a01;
a03=a03*a06;
a07=a07+a03;
a00=a00*a07;
a02=a02*a04;
a00=a00+a02;
a10=a10*a00;
a08=a08-a10;
a08=-a08;
if (res[2]!=0) res[2][0]=a08;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_steady_margins(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f33(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_steady_margins_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_steady_margins_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_steady_margins_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_steady_margins_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_steady_margins_n_in(void) { return 21;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_steady_margins_n_out(void) { return 3;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_steady_margins_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_steady_margins_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "a";
case 2: return "b";
case 3: return "u";
case 4: return "rho";
case 5: return "Ap";
case 6: return "CL_gamma";
case 7: return "C_alpha";
case 8: return "Ct";
case 9: return "out_x_neutral";
case 10: return "out_static_margin";
case 11: return "out_K_us";
case 12: return "fwd_m";
case 13: return "fwd_a";
case 14: return "fwd_b";
case 15: return "fwd_u";
case 16: return "fwd_rho";
case 17: return "fwd_Ap";
case 18: return "fwd_CL_gamma";
case 19: return "fwd_C_alpha";
case 20: return "fwd_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_steady_margins_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_x_neutral";
case 1: return "fwd_static_margin";
case 2: return "fwd_K_us";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_steady_margins_sparsity_in(casadi_int i) {
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
case 9: return casadi_s1;
case 10: return casadi_s1;
case 11: return casadi_s1;
case 12: return casadi_s0;
case 13: return casadi_s0;
case 14: return casadi_s0;
case 15: return casadi_s0;
case 16: return casadi_s0;
case 17: return casadi_s0;
case 18: return casadi_s0;
case 19: return casadi_s0;
case 20: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_steady_margins_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_steady_margins_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 21;
if (sz_res) *sz_res = 3;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_steady_margins_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 21*sizeof(const casadi_real*);
if (sz_res) *sz_res = 3*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_steady_margins:(m,a,b,u,rho,Ap,CL_gamma,C_alpha,Ct,out_x_neutral[1x1,0nz],out_static_margin[1x1,0nz],out_K_us[1x1,0nz],adj_x_neutral,adj_static_margin,adj_K_us)->(adj_m,adj_a,adj_b,adj_u,adj_rho,adj_Ap,adj_CL_gamma,adj_C_alpha,adj_Ct) */
static int casadi_f34(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20;
a00=arg[7]? arg[7][0] : 0;
a00=2.*a00;
a01=arg[1]? arg[1][0] : 0;
a02=a00*a01;
a03=arg[8]? arg[8][0] : 0;
a04=5.0000000000000000e-01;
a05=arg[5]? arg[5][0] : 0;
a05=a04*a05;
a06=arg[6]? arg[6][0] : 0;
a07=a05*a06;
a08=arg[4]? arg[4][0] : 0;
a09=a07*a08;
a10=arg[3]? arg[3][0] : 0;
a11=casadi_sq(a10);
a12=a09*a11;
a03=a03+a12;
a12=arg[2]? arg[2][0] : 0;
a13=a03*a12;
a02=a02-a13;
a13=arg[14]? arg[14][0] : 0;
a14=a00*a03;
a15=a01+a12;
a16=a14*a15;
a17=a13/a16;
a18=a02*a17;
a18=-a18;
if (res[0]!=0) res[0][0]=a18;
a18=arg[0]? arg[0][0] : 0;
a19=a18*a02;
a19=a19/a16;
a19=a19/a16;
a19=a19*a13;
a14=a14*a19;
a13=a00+a03;
a02=a02/a13;
a16=a02/a15;
a16=a16/a15;
a20=arg[13]? arg[13][0] : 0;
a16=a16*a20;
a14=a14+a16;
a16=arg[12]? arg[12][0] : 0;
a20=a20/a15;
a16=a16-a20;
a20=a16/a13;
a18=a18*a17;
a20=a20-a18;
a18=a00*a20;
a18=a14+a18;
if (res[1]!=0) res[1][0]=a18;
a18=a03*a20;
a14=a14-a18;
if (res[2]!=0) res[2][0]=a14;
a10=2.*a10;
a15=a15*a19;
a00=a00*a15;
a02=a02/a13;
a02=a02*a16;
a00=a00-a02;
a12=a12*a20;
a00=a00-a12;
a09=a09*a00;
a10=a10*a09;
if (res[3]!=0) res[3][0]=a10;
a11=a11*a00;
a07=a07*a11;
if (res[4]!=0) res[4][0]=a07;
a08=a08*a11;
a06=a06*a08;
a04=a04*a06;
if (res[5]!=0) res[5][0]=a04;
a05=a05*a08;
if (res[6]!=0) res[6][0]=a05;
a03=a03*a15;
a03=a03-a02;
a01=a01*a20;
a03=a03+a01;
a03=2.*a03;
if (res[7]!=0) res[7][0]=a03;
if (res[8]!=0) res[8][0]=a00;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_steady_margins(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f34(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_steady_margins_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_steady_margins_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_steady_margins_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_steady_margins_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_steady_margins_n_in(void) { return 15;}
CASADI_SYMBOL_EXPORT casadi_int adj1_steady_margins_n_out(void) { return 9;}
CASADI_SYMBOL_EXPORT casadi_real adj1_steady_margins_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_steady_margins_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "a";
case 2: return "b";
case 3: return "u";
case 4: return "rho";
case 5: return "Ap";
case 6: return "CL_gamma";
case 7: return "C_alpha";
case 8: return "Ct";
case 9: return "out_x_neutral";
case 10: return "out_static_margin";
case 11: return "out_K_us";
case 12: return "adj_x_neutral";
case 13: return "adj_static_margin";
case 14: return "adj_K_us";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_steady_margins_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_m";
case 1: return "adj_a";
case 2: return "adj_b";
case 3: return "adj_u";
case 4: return "adj_rho";
case 5: return "adj_Ap";
case 6: return "adj_CL_gamma";
case 7: return "adj_C_alpha";
case 8: return "adj_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_steady_margins_sparsity_in(casadi_int i) {
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
case 9: return casadi_s1;
case 10: return casadi_s1;
case 11: return casadi_s1;
case 12: return casadi_s0;
case 13: return casadi_s0;
case 14: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_steady_margins_sparsity_out(casadi_int i) {
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
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_steady_margins_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 15;
if (sz_res) *sz_res = 9;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_steady_margins_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 15*sizeof(const casadi_real*);
if (sz_res) *sz_res = 9*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_steady_margins:(m,a,b,u,rho,Ap,CL_gamma,C_alpha,Ct,out_x_neutral[1x1,0nz],out_static_margin[1x1,0nz],out_K_us[1x1,0nz],adj_x_neutral,adj_static_margin,adj_K_us,out_adj_m[1x1,0nz],out_adj_a[1x1,0nz],out_adj_b[1x1,0nz],out_adj_u[1x1,0nz],out_adj_rho[1x1,0nz],out_adj_Ap[1x1,0nz],out_adj_CL_gamma[1x1,0nz],out_adj_C_alpha[1x1,0nz],out_adj_Ct[1x1,0nz],fwd_m,fwd_a,fwd_b,fwd_u,fwd_rho,fwd_Ap,fwd_CL_gamma,fwd_C_alpha,fwd_Ct,fwd_out_x_neutral[1x1,0nz],fwd_out_static_margin[1x1,0nz],fwd_out_K_us[1x1,0nz],fwd_adj_x_neutral,fwd_adj_static_margin,fwd_adj_K_us)->(fwd_adj_m,fwd_adj_a,fwd_adj_b,fwd_adj_u,fwd_adj_rho,fwd_adj_Ap,fwd_adj_CL_gamma,fwd_adj_C_alpha,fwd_adj_Ct) */
static int casadi_f35(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42;
a00=arg[14]? arg[14][0] : 0;
a01=arg[7]? arg[7][0] : 0;
a01=2.*a01;
a02=arg[8]? arg[8][0] : 0;
a03=5.0000000000000000e-01;
a04=arg[5]? arg[5][0] : 0;
a04=a03*a04;
a05=arg[6]? arg[6][0] : 0;
a06=a04*a05;
a07=arg[4]? arg[4][0] : 0;
a08=a06*a07;
a09=arg[3]? arg[3][0] : 0;
a10=casadi_sq(a09);
a11=a08*a10;
a02=a02+a11;
a11=a01*a02;
a12=arg[1]? arg[1][0] : 0;
a13=arg[2]? arg[2][0] : 0;
a14=a12+a13;
a15=a11*a14;
a16=a00/a15;
a17=arg[31]? arg[31][0] : 0;
a17=2.*a17;
a18=a12*a17;
a19=arg[25]? arg[25][0] : 0;
a20=a01*a19;
a18=a18+a20;
a20=arg[32]? arg[32][0] : 0;
a21=arg[29]? arg[29][0] : 0;
a21=a03*a21;
a22=a05*a21;
a23=arg[30]? arg[30][0] : 0;
a24=a04*a23;
a22=a22+a24;
a24=a07*a22;
a25=arg[28]? arg[28][0] : 0;
a26=a06*a25;
a24=a24+a26;
a26=a10*a24;
a27=2.*a09;
a28=arg[27]? arg[27][0] : 0;
a27=a27*a28;
a29=a08*a27;
a26=a26+a29;
a20=a20+a26;
a26=a13*a20;
a29=arg[26]? arg[26][0] : 0;
a30=a02*a29;
a26=a26+a30;
a18=a18-a26;
a26=a16*a18;
a30=a01*a12;
a31=a02*a13;
a30=a30-a31;
a31=arg[38]? arg[38][0] : 0;
a32=a31/a15;
a33=a16/a15;
a34=a02*a17;
a35=a01*a20;
a34=a34+a35;
a35=a14*a34;
a36=a19+a29;
a37=a11*a36;
a35=a35+a37;
a33=a33*a35;
a32=a32-a33;
a33=a30*a32;
a26=a26+a33;
a26=-a26;
if (res[0]!=0) res[0][0]=a26;
a26=arg[0]? arg[0][0] : 0;
a33=a26*a30;
a33=a33/a15;
a37=a33/a15;
a38=a37*a00;
a34=a38*a34;
a39=arg[24]? arg[24][0] : 0;
a40=a30*a39;
a41=a26*a18;
a40=a40+a41;
a40=a40/a15;
a33=a33/a15;
a33=a33*a35;
a40=a40-a33;
a40=a40/a15;
a15=a37/a15;
a15=a15*a35;
a40=a40-a15;
a00=a00*a40;
a37=a37*a31;
a00=a00+a37;
a11=a11*a00;
a34=a34+a11;
a11=arg[13]? arg[13][0] : 0;
a37=a01+a02;
a18=a18/a37;
a30=a30/a37;
a31=a30/a37;
a40=a17+a20;
a31=a31*a40;
a18=a18-a31;
a31=a18/a14;
a15=a30/a14;
a35=a15/a14;
a35=a35*a36;
a31=a31-a35;
a31=a31/a14;
a15=a15/a14;
a35=a15/a14;
a35=a35*a36;
a31=a31-a35;
a31=a11*a31;
a35=arg[37]? arg[37][0] : 0;
a15=a15*a35;
a31=a31+a15;
a34=a34+a31;
a31=arg[12]? arg[12][0] : 0;
a11=a11/a14;
a31=a31-a11;
a15=a31/a37;
a33=a26*a16;
a33=a15-a33;
a41=a33*a17;
a42=arg[36]? arg[36][0] : 0;
a35=a35/a14;
a11=a11/a14;
a11=a11*a36;
a35=a35-a11;
a42=a42-a35;
a35=a42/a37;
a15=a15/a37;
a15=a15*a40;
a35=a35-a15;
a16=a16*a39;
a26=a26*a32;
a16=a16+a26;
a35=a35-a16;
a16=a01*a35;
a41=a41+a16;
a41=a34+a41;
if (res[1]!=0) res[1][0]=a41;
a41=a33*a20;
a16=a02*a35;
a41=a41+a16;
a34=a34-a41;
if (res[2]!=0) res[2][0]=a34;
a34=a14*a38;
a41=a01*a34;
a30=a30/a37;
a16=a30*a31;
a41=a41-a16;
a16=a13*a33;
a41=a41-a16;
a16=a08*a41;
a28=2.*a28;
a16=a16*a28;
a09=2.*a09;
a24=a41*a24;
a17=a34*a17;
a38=a38*a36;
a14=a14*a00;
a38=a38+a14;
a01=a01*a38;
a17=a17+a01;
a18=a18/a37;
a37=a30/a37;
a37=a37*a40;
a18=a18-a37;
a31=a31*a18;
a30=a30*a42;
a31=a31+a30;
a17=a17-a31;
a29=a33*a29;
a13=a13*a35;
a29=a29+a13;
a17=a17-a29;
a08=a08*a17;
a24=a24+a08;
a09=a09*a24;
a16=a16+a09;
if (res[3]!=0) res[3][0]=a16;
a16=a10*a41;
a22=a16*a22;
a41=a41*a27;
a10=a10*a17;
a41=a41+a10;
a06=a06*a41;
a22=a22+a06;
if (res[4]!=0) res[4][0]=a22;
a22=a07*a16;
a23=a22*a23;
a16=a16*a25;
a07=a07*a41;
a16=a16+a07;
a05=a05*a16;
a23=a23+a05;
a03=a03*a23;
if (res[5]!=0) res[5][0]=a03;
a22=a22*a21;
a04=a04*a16;
a22=a22+a04;
if (res[6]!=0) res[6][0]=a22;
a34=a34*a20;
a02=a02*a38;
a34=a34+a02;
a34=a34-a31;
a33=a33*a19;
a12=a12*a35;
a33=a33+a12;
a34=a34+a33;
a34=2.*a34;
if (res[7]!=0) res[7][0]=a34;
if (res[8]!=0) res[8][0]=a17;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_steady_margins(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f35(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_steady_margins_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_steady_margins_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_steady_margins_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_steady_margins_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_steady_margins_n_in(void) { return 39;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_steady_margins_n_out(void) { return 9;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_steady_margins_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_steady_margins_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "a";
case 2: return "b";
case 3: return "u";
case 4: return "rho";
case 5: return "Ap";
case 6: return "CL_gamma";
case 7: return "C_alpha";
case 8: return "Ct";
case 9: return "out_x_neutral";
case 10: return "out_static_margin";
case 11: return "out_K_us";
case 12: return "adj_x_neutral";
case 13: return "adj_static_margin";
case 14: return "adj_K_us";
case 15: return "out_adj_m";
case 16: return "out_adj_a";
case 17: return "out_adj_b";
case 18: return "out_adj_u";
case 19: return "out_adj_rho";
case 20: return "out_adj_Ap";
case 21: return "out_adj_CL_gamma";
case 22: return "out_adj_C_alpha";
case 23: return "out_adj_Ct";
case 24: return "fwd_m";
case 25: return "fwd_a";
case 26: return "fwd_b";
case 27: return "fwd_u";
case 28: return "fwd_rho";
case 29: return "fwd_Ap";
case 30: return "fwd_CL_gamma";
case 31: return "fwd_C_alpha";
case 32: return "fwd_Ct";
case 33: return "fwd_out_x_neutral";
case 34: return "fwd_out_static_margin";
case 35: return "fwd_out_K_us";
case 36: return "fwd_adj_x_neutral";
case 37: return "fwd_adj_static_margin";
case 38: return "fwd_adj_K_us";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_steady_margins_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_m";
case 1: return "fwd_adj_a";
case 2: return "fwd_adj_b";
case 3: return "fwd_adj_u";
case 4: return "fwd_adj_rho";
case 5: return "fwd_adj_Ap";
case 6: return "fwd_adj_CL_gamma";
case 7: return "fwd_adj_C_alpha";
case 8: return "fwd_adj_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_steady_margins_sparsity_in(casadi_int i) {
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
case 9: return casadi_s1;
case 10: return casadi_s1;
case 11: return casadi_s1;
case 12: return casadi_s0;
case 13: return casadi_s0;
case 14: return casadi_s0;
case 15: return casadi_s1;
case 16: return casadi_s1;
case 17: return casadi_s1;
case 18: return casadi_s1;
case 19: return casadi_s1;
case 20: return casadi_s1;
case 21: return casadi_s1;
case 22: return casadi_s1;
case 23: return casadi_s1;
case 24: return casadi_s0;
case 25: return casadi_s0;
case 26: return casadi_s0;
case 27: return casadi_s0;
case 28: return casadi_s0;
case 29: return casadi_s0;
case 30: return casadi_s0;
case 31: return casadi_s0;
case 32: return casadi_s0;
case 33: return casadi_s1;
case 34: return casadi_s1;
case 35: return casadi_s1;
case 36: return casadi_s0;
case 37: return casadi_s0;
case 38: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_steady_margins_sparsity_out(casadi_int i) {
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
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_steady_margins_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 39;
if (sz_res) *sz_res = 9;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_steady_margins_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 39*sizeof(const casadi_real*);
if (sz_res) *sz_res = 9*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* tail_wheel_needed:(m,a,b,u,rho,Ap,CL_gamma,C_alpha)->(Ct_needed) */
static int casadi_f36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5, a6, a7;
a0=arg[7]? arg[7][0] : 0;
a1=2.*a0;
a2=arg[1]? arg[1][0] : 0;
a3=a1*a2;
a4=arg[0]? arg[0][0] : 0;
a5=arg[3]? arg[3][0] : 0;
a6=casadi_sq(a5);
a4=a4*a6;
a3=a3*a4;
a6=casadi_sq(a2);
a6=a1*a6;
a7=4.;
a7=a7*a0;
a7=a7*a2;
a2=arg[2]? arg[2][0] : 0;
a7=a7*a2;
a6=a6+a7;
a7=casadi_sq(a2);
a1=a1*a7;
a6=a6+a1;
a2=a2*a4;
a6=a6+a2;
a3=a3/a6;
a6=5.0000000000000000e-01;
a2=arg[5]? arg[5][0] : 0;
a6=a6*a2;
a2=arg[6]? arg[6][0] : 0;
a6=a6*a2;
a2=arg[4]? arg[4][0] : 0;
a6=a6*a2;
a5=casadi_sq(a5);
a6=a6*a5;
a3=a3-a6;
if (res[0]!=0) res[0][0]=a3;
return 0;
}
CASADI_SYMBOL_EXPORT int tail_wheel_needed(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f36(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int tail_wheel_needed_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void tail_wheel_needed_release(int mem) {
}
CASADI_SYMBOL_EXPORT void tail_wheel_needed_incref(void) {
}
CASADI_SYMBOL_EXPORT void tail_wheel_needed_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int tail_wheel_needed_n_in(void) { return 8;}
CASADI_SYMBOL_EXPORT casadi_int tail_wheel_needed_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real tail_wheel_needed_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* tail_wheel_needed_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "a";
case 2: return "b";
case 3: return "u";
case 4: return "rho";
case 5: return "Ap";
case 6: return "CL_gamma";
case 7: return "C_alpha";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* tail_wheel_needed_name_out(casadi_int i) {
switch (i) {
case 0: return "Ct_needed";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* tail_wheel_needed_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* tail_wheel_needed_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int tail_wheel_needed_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 8;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int tail_wheel_needed_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 8*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_tail_wheel_needed:(m,a,b,u,rho,Ap,CL_gamma,C_alpha,out_Ct_needed[1x1,0nz],fwd_m,fwd_a,fwd_b,fwd_u,fwd_rho,fwd_Ap,fwd_CL_gamma,fwd_C_alpha)->(fwd_Ct_needed) */
static int casadi_f37(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18;
a00=arg[0]? arg[0][0] : 0;
a01=arg[3]? arg[3][0] : 0;
a02=casadi_sq(a01);
a03=a00*a02;
a04=arg[1]? arg[1][0] : 0;
a05=arg[16]? arg[16][0] : 0;
a06=2.*a05;
a07=a04*a06;
a08=arg[7]? arg[7][0] : 0;
a09=2.*a08;
a10=arg[10]? arg[10][0] : 0;
a11=a09*a10;
a07=a07+a11;
a07=a03*a07;
a11=a09*a04;
a12=arg[9]? arg[9][0] : 0;
a02=a02*a12;
a12=2.*a01;
a13=arg[12]? arg[12][0] : 0;
a12=a12*a13;
a00=a00*a12;
a02=a02+a00;
a00=a11*a02;
a07=a07+a00;
a00=casadi_sq(a04);
a12=a09*a00;
a14=4.;
a08=a14*a08;
a15=a08*a04;
a16=arg[2]? arg[2][0] : 0;
a17=a15*a16;
a12=a12+a17;
a17=casadi_sq(a16);
a18=a09*a17;
a12=a12+a18;
a18=a16*a03;
a12=a12+a18;
a07=a07/a12;
a11=a11*a03;
a11=a11/a12;
a11=a11/a12;
a00=a00*a06;
a12=2.*a04;
a12=a12*a10;
a12=a09*a12;
a00=a00+a12;
a14=a14*a05;
a04=a04*a14;
a08=a08*a10;
a04=a04+a08;
a04=a16*a04;
a08=arg[11]? arg[11][0] : 0;
a15=a15*a08;
a04=a04+a15;
a00=a00+a04;
a17=a17*a06;
a06=2.*a16;
a06=a06*a08;
a09=a09*a06;
a17=a17+a09;
a00=a00+a17;
a03=a03*a08;
a16=a16*a02;
a03=a03+a16;
a00=a00+a03;
a11=a11*a00;
a07=a07-a11;
a11=casadi_sq(a01);
a00=arg[4]? arg[4][0] : 0;
a03=arg[6]? arg[6][0] : 0;
a16=5.0000000000000000e-01;
a02=arg[14]? arg[14][0] : 0;
a02=a16*a02;
a02=a03*a02;
a08=arg[5]? arg[5][0] : 0;
a16=a16*a08;
a08=arg[15]? arg[15][0] : 0;
a08=a16*a08;
a02=a02+a08;
a02=a00*a02;
a16=a16*a03;
a03=arg[13]? arg[13][0] : 0;
a03=a16*a03;
a02=a02+a03;
a11=a11*a02;
a16=a16*a00;
a01=2.*a01;
a01=a01*a13;
a16=a16*a01;
a11=a11+a16;
a07=a07-a11;
if (res[0]!=0) res[0][0]=a07;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_tail_wheel_needed(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f37(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_tail_wheel_needed_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_tail_wheel_needed_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_tail_wheel_needed_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_tail_wheel_needed_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_tail_wheel_needed_n_in(void) { return 17;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_tail_wheel_needed_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_tail_wheel_needed_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_tail_wheel_needed_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "a";
case 2: return "b";
case 3: return "u";
case 4: return "rho";
case 5: return "Ap";
case 6: return "CL_gamma";
case 7: return "C_alpha";
case 8: return "out_Ct_needed";
case 9: return "fwd_m";
case 10: return "fwd_a";
case 11: return "fwd_b";
case 12: return "fwd_u";
case 13: return "fwd_rho";
case 14: return "fwd_Ap";
case 15: return "fwd_CL_gamma";
case 16: return "fwd_C_alpha";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_tail_wheel_needed_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_Ct_needed";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_tail_wheel_needed_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
case 8: return casadi_s1;
case 9: return casadi_s0;
case 10: return casadi_s0;
case 11: return casadi_s0;
case 12: return casadi_s0;
case 13: return casadi_s0;
case 14: return casadi_s0;
case 15: return casadi_s0;
case 16: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_tail_wheel_needed_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_tail_wheel_needed_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 17;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_tail_wheel_needed_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 17*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_tail_wheel_needed:(m,a,b,u,rho,Ap,CL_gamma,C_alpha,out_Ct_needed[1x1,0nz],adj_Ct_needed)->(adj_m,adj_a,adj_b,adj_u,adj_rho,adj_Ap,adj_CL_gamma,adj_C_alpha) */
static int casadi_f38(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18;
a00=arg[3]? arg[3][0] : 0;
a01=casadi_sq(a00);
a02=arg[7]? arg[7][0] : 0;
a03=2.*a02;
a04=arg[1]? arg[1][0] : 0;
a05=a03*a04;
a06=arg[9]? arg[9][0] : 0;
a07=casadi_sq(a04);
a08=a03*a07;
a09=4.;
a02=a09*a02;
a10=a02*a04;
a11=arg[2]? arg[2][0] : 0;
a12=a10*a11;
a08=a08+a12;
a12=casadi_sq(a11);
a13=a03*a12;
a08=a08+a13;
a13=arg[0]? arg[0][0] : 0;
a14=a13*a01;
a15=a11*a14;
a08=a08+a15;
a15=a06/a08;
a16=a05*a15;
a05=a05*a14;
a05=a05/a08;
a05=a05/a08;
a05=a05*a06;
a08=a11*a05;
a16=a16-a08;
a01=a01*a16;
if (res[0]!=0) res[0][0]=a01;
a15=a14*a15;
a01=a03*a15;
a08=a11*a05;
a02=a02*a08;
a17=2.*a04;
a18=a03*a05;
a17=a17*a18;
a02=a02+a17;
a01=a01-a02;
if (res[1]!=0) res[1][0]=a01;
a14=a14*a05;
a11=2.*a11;
a03=a03*a05;
a11=a11*a03;
a14=a14+a11;
a10=a10*a05;
a14=a14+a10;
a14=-a14;
if (res[2]!=0) res[2][0]=a14;
a14=2.*a00;
a13=a13*a16;
a14=a14*a13;
a13=2.*a00;
a16=5.0000000000000000e-01;
a10=arg[5]? arg[5][0] : 0;
a10=a16*a10;
a11=arg[6]? arg[6][0] : 0;
a03=a10*a11;
a01=arg[4]? arg[4][0] : 0;
a02=a03*a01;
a02=a02*a06;
a13=a13*a02;
a14=a14-a13;
if (res[3]!=0) res[3][0]=a14;
a00=casadi_sq(a00);
a00=a00*a06;
a03=a03*a00;
a03=-a03;
if (res[4]!=0) res[4][0]=a03;
a01=a01*a00;
a11=a11*a01;
a16=a16*a11;
a16=-a16;
if (res[5]!=0) res[5][0]=a16;
a10=a10*a01;
a10=-a10;
if (res[6]!=0) res[6][0]=a10;
a15=a04*a15;
a12=a12*a05;
a07=a07*a05;
a12=a12+a07;
a15=a15-a12;
a15=2.*a15;
a04=a04*a08;
a09=a09*a04;
a15=a15-a09;
if (res[7]!=0) res[7][0]=a15;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_tail_wheel_needed(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f38(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_tail_wheel_needed_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_tail_wheel_needed_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_tail_wheel_needed_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_tail_wheel_needed_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_tail_wheel_needed_n_in(void) { return 10;}
CASADI_SYMBOL_EXPORT casadi_int adj1_tail_wheel_needed_n_out(void) { return 8;}
CASADI_SYMBOL_EXPORT casadi_real adj1_tail_wheel_needed_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_tail_wheel_needed_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "a";
case 2: return "b";
case 3: return "u";
case 4: return "rho";
case 5: return "Ap";
case 6: return "CL_gamma";
case 7: return "C_alpha";
case 8: return "out_Ct_needed";
case 9: return "adj_Ct_needed";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_tail_wheel_needed_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_m";
case 1: return "adj_a";
case 2: return "adj_b";
case 3: return "adj_u";
case 4: return "adj_rho";
case 5: return "adj_Ap";
case 6: return "adj_CL_gamma";
case 7: return "adj_C_alpha";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_tail_wheel_needed_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
case 8: return casadi_s1;
case 9: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_tail_wheel_needed_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_tail_wheel_needed_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 10;
if (sz_res) *sz_res = 8;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_tail_wheel_needed_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
if (sz_res) *sz_res = 8*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_tail_wheel_needed:(m,a,b,u,rho,Ap,CL_gamma,C_alpha,out_Ct_needed[1x1,0nz],adj_Ct_needed,out_adj_m[1x1,0nz],out_adj_a[1x1,0nz],out_adj_b[1x1,0nz],out_adj_u[1x1,0nz],out_adj_rho[1x1,0nz],out_adj_Ap[1x1,0nz],out_adj_CL_gamma[1x1,0nz],out_adj_C_alpha[1x1,0nz],fwd_m,fwd_a,fwd_b,fwd_u,fwd_rho,fwd_Ap,fwd_CL_gamma,fwd_C_alpha,fwd_out_Ct_needed[1x1,0nz],fwd_adj_Ct_needed)->(fwd_adj_m,fwd_adj_a,fwd_adj_b,fwd_adj_u,fwd_adj_rho,fwd_adj_Ap,fwd_adj_CL_gamma,fwd_adj_C_alpha) */
static int casadi_f39(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38;
a00=arg[7]? arg[7][0] : 0;
a01=2.*a00;
a02=arg[1]? arg[1][0] : 0;
a03=a01*a02;
a04=arg[9]? arg[9][0] : 0;
a05=casadi_sq(a02);
a06=a01*a05;
a07=4.;
a00=a07*a00;
a08=a00*a02;
a09=arg[2]? arg[2][0] : 0;
a10=a08*a09;
a06=a06+a10;
a10=casadi_sq(a09);
a11=a01*a10;
a06=a06+a11;
a11=arg[0]? arg[0][0] : 0;
a12=arg[3]? arg[3][0] : 0;
a13=casadi_sq(a12);
a14=a11*a13;
a15=a09*a14;
a06=a06+a15;
a15=a04/a06;
a16=a03*a15;
a17=a03*a14;
a17=a17/a06;
a18=a17/a06;
a19=a18*a04;
a20=a09*a19;
a16=a16-a20;
a20=2.*a12;
a21=arg[21]? arg[21][0] : 0;
a20=a20*a21;
a22=a16*a20;
a23=arg[25]? arg[25][0] : 0;
a24=2.*a23;
a25=a02*a24;
a26=arg[19]? arg[19][0] : 0;
a27=a01*a26;
a25=a25+a27;
a27=a15*a25;
a28=arg[27]? arg[27][0] : 0;
a29=a28/a06;
a30=a15/a06;
a31=a05*a24;
a32=2.*a02;
a32=a32*a26;
a33=a01*a32;
a31=a31+a33;
a23=a07*a23;
a33=a02*a23;
a34=a00*a26;
a33=a33+a34;
a34=a09*a33;
a35=arg[20]? arg[20][0] : 0;
a36=a08*a35;
a34=a34+a36;
a31=a31+a34;
a34=a10*a24;
a36=2.*a09;
a36=a36*a35;
a37=a01*a36;
a34=a34+a37;
a31=a31+a34;
a34=a14*a35;
a37=arg[18]? arg[18][0] : 0;
a38=a13*a37;
a20=a11*a20;
a38=a38+a20;
a20=a09*a38;
a34=a34+a20;
a31=a31+a34;
a30=a30*a31;
a29=a29-a30;
a30=a03*a29;
a27=a27+a30;
a30=a19*a35;
a25=a14*a25;
a03=a03*a38;
a25=a25+a03;
a25=a25/a06;
a17=a17/a06;
a17=a17*a31;
a25=a25-a17;
a25=a25/a06;
a06=a18/a06;
a06=a06*a31;
a25=a25-a06;
a25=a04*a25;
a18=a18*a28;
a25=a25+a18;
a18=a09*a25;
a30=a30+a18;
a27=a27-a30;
a13=a13*a27;
a22=a22+a13;
if (res[0]!=0) res[0][0]=a22;
a22=a14*a15;
a13=a22*a24;
a15=a15*a38;
a29=a14*a29;
a15=a15+a29;
a29=a01*a15;
a13=a13+a29;
a29=a09*a19;
a23=a29*a23;
a30=a19*a35;
a18=a09*a25;
a30=a30+a18;
a00=a00*a30;
a23=a23+a00;
a00=a01*a19;
a18=2.*a26;
a00=a00*a18;
a18=2.*a02;
a06=a19*a24;
a31=a01*a25;
a06=a06+a31;
a18=a18*a06;
a00=a00+a18;
a23=a23+a00;
a13=a13-a23;
if (res[1]!=0) res[1][0]=a13;
a38=a19*a38;
a14=a14*a25;
a38=a38+a14;
a14=a01*a19;
a35=2.*a35;
a14=a14*a35;
a09=2.*a09;
a24=a19*a24;
a01=a01*a25;
a24=a24+a01;
a09=a09*a24;
a14=a14+a09;
a38=a38+a14;
a33=a19*a33;
a08=a08*a25;
a33=a33+a08;
a38=a38+a33;
a38=-a38;
if (res[2]!=0) res[2][0]=a38;
a38=a11*a16;
a33=2.*a21;
a38=a38*a33;
a33=2.*a12;
a16=a16*a37;
a11=a11*a27;
a16=a16+a11;
a33=a33*a16;
a38=a38+a33;
a33=5.0000000000000000e-01;
a16=arg[5]? arg[5][0] : 0;
a16=a33*a16;
a11=arg[6]? arg[6][0] : 0;
a27=a16*a11;
a37=arg[4]? arg[4][0] : 0;
a08=a27*a37;
a14=a08*a04;
a09=2.*a21;
a14=a14*a09;
a09=2.*a12;
a24=arg[23]? arg[23][0] : 0;
a24=a33*a24;
a01=a11*a24;
a35=arg[24]? arg[24][0] : 0;
a13=a16*a35;
a01=a01+a13;
a13=a37*a01;
a23=arg[22]? arg[22][0] : 0;
a00=a27*a23;
a13=a13+a00;
a13=a04*a13;
a08=a08*a28;
a13=a13+a08;
a09=a09*a13;
a14=a14+a09;
a38=a38-a14;
if (res[3]!=0) res[3][0]=a38;
a38=casadi_sq(a12);
a14=a38*a04;
a01=a14*a01;
a12=2.*a12;
a12=a12*a21;
a04=a04*a12;
a38=a38*a28;
a04=a04+a38;
a27=a27*a04;
a01=a01+a27;
a01=-a01;
if (res[4]!=0) res[4][0]=a01;
a01=a37*a14;
a35=a01*a35;
a14=a14*a23;
a37=a37*a04;
a14=a14+a37;
a11=a11*a14;
a35=a35+a11;
a33=a33*a35;
a33=-a33;
if (res[5]!=0) res[5][0]=a33;
a01=a01*a24;
a16=a16*a14;
a01=a01+a16;
a01=-a01;
if (res[6]!=0) res[6][0]=a01;
a22=a22*a26;
a15=a02*a15;
a22=a22+a15;
a36=a19*a36;
a10=a10*a25;
a36=a36+a10;
a19=a19*a32;
a05=a05*a25;
a19=a19+a05;
a36=a36+a19;
a22=a22-a36;
a22=2.*a22;
a29=a29*a26;
a02=a02*a30;
a29=a29+a02;
a07=a07*a29;
a22=a22-a07;
if (res[7]!=0) res[7][0]=a22;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_tail_wheel_needed(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f39(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_tail_wheel_needed_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_tail_wheel_needed_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_tail_wheel_needed_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_tail_wheel_needed_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_tail_wheel_needed_n_in(void) { return 28;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_tail_wheel_needed_n_out(void) { return 8;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_tail_wheel_needed_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_tail_wheel_needed_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "a";
case 2: return "b";
case 3: return "u";
case 4: return "rho";
case 5: return "Ap";
case 6: return "CL_gamma";
case 7: return "C_alpha";
case 8: return "out_Ct_needed";
case 9: return "adj_Ct_needed";
case 10: return "out_adj_m";
case 11: return "out_adj_a";
case 12: return "out_adj_b";
case 13: return "out_adj_u";
case 14: return "out_adj_rho";
case 15: return "out_adj_Ap";
case 16: return "out_adj_CL_gamma";
case 17: return "out_adj_C_alpha";
case 18: return "fwd_m";
case 19: return "fwd_a";
case 20: return "fwd_b";
case 21: return "fwd_u";
case 22: return "fwd_rho";
case 23: return "fwd_Ap";
case 24: return "fwd_CL_gamma";
case 25: return "fwd_C_alpha";
case 26: return "fwd_out_Ct_needed";
case 27: return "fwd_adj_Ct_needed";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_tail_wheel_needed_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_m";
case 1: return "fwd_adj_a";
case 2: return "fwd_adj_b";
case 3: return "fwd_adj_u";
case 4: return "fwd_adj_rho";
case 5: return "fwd_adj_Ap";
case 6: return "fwd_adj_CL_gamma";
case 7: return "fwd_adj_C_alpha";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_tail_wheel_needed_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
case 8: return casadi_s1;
case 9: return casadi_s0;
case 10: return casadi_s1;
case 11: return casadi_s1;
case 12: return casadi_s1;
case 13: return casadi_s1;
case 14: return casadi_s1;
case 15: return casadi_s1;
case 16: return casadi_s1;
case 17: return casadi_s1;
case 18: return casadi_s0;
case 19: return casadi_s0;
case 20: return casadi_s0;
case 21: return casadi_s0;
case 22: return casadi_s0;
case 23: return casadi_s0;
case 24: return casadi_s0;
case 25: return casadi_s0;
case 26: return casadi_s1;
case 27: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_tail_wheel_needed_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_tail_wheel_needed_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 28;
if (sz_res) *sz_res = 8;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_tail_wheel_needed_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 28*sizeof(const casadi_real*);
if (sz_res) *sz_res = 8*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* tail_wheel_always:(m,a,b,rho,Ap,CL_gamma,C_alpha,Ct)->(Ct_always,speed_margin) */
static int casadi_f40(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5, a6, a7;
a0=0.;
a1=arg[6]? arg[6][0] : 0;
a1=2.*a1;
a1=sqrt(a1);
a2=arg[0]? arg[0][0] : 0;
a2=sqrt(a2);
a3=arg[1]? arg[1][0] : 0;
a4=casadi_fmax(a0,a3);
a4=sqrt(a4);
a4=a2*a4;
a5=arg[2]? arg[2][0] : 0;
a3=a3+a5;
a6=5.0000000000000000e-01;
a7=arg[4]? arg[4][0] : 0;
a6=a6*a7;
a7=arg[5]? arg[5][0] : 0;
a6=a6*a7;
a7=arg[3]? arg[3][0] : 0;
a6=a6*a7;
a6=sqrt(a6);
a6=a3*a6;
a4=a4-a6;
a4=a1*a4;
a5=sqrt(a5);
a2=a5*a2;
a4=a4/a2;
a0=casadi_fmax(a0,a4);
a0=casadi_sq(a0);
if (res[0]!=0) res[0][0]=a0;
a0=arg[7]? arg[7][0] : 0;
a0=sqrt(a0);
a0=a0-a4;
a5=a5*a0;
a3=sqrt(a3);
a3=a3*a1;
a5=a5/a3;
if (res[1]!=0) res[1][0]=a5;
return 0;
}
CASADI_SYMBOL_EXPORT int tail_wheel_always(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f40(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int tail_wheel_always_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void tail_wheel_always_release(int mem) {
}
CASADI_SYMBOL_EXPORT void tail_wheel_always_incref(void) {
}
CASADI_SYMBOL_EXPORT void tail_wheel_always_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int tail_wheel_always_n_in(void) { return 8;}
CASADI_SYMBOL_EXPORT casadi_int tail_wheel_always_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real tail_wheel_always_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* tail_wheel_always_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "a";
case 2: return "b";
case 3: return "rho";
case 4: return "Ap";
case 5: return "CL_gamma";
case 6: return "C_alpha";
case 7: return "Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* tail_wheel_always_name_out(casadi_int i) {
switch (i) {
case 0: return "Ct_always";
case 1: return "speed_margin";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* tail_wheel_always_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* tail_wheel_always_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int tail_wheel_always_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 8;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int tail_wheel_always_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 8*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_tail_wheel_always:(m,a,b,rho,Ap,CL_gamma,C_alpha,Ct,out_Ct_always[1x1,0nz],out_speed_margin[1x1,0nz],fwd_m,fwd_a,fwd_b,fwd_rho,fwd_Ap,fwd_CL_gamma,fwd_C_alpha,fwd_Ct)->(fwd_Ct_always,fwd_speed_margin) */
static int casadi_f41(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21;
a00=0.;
a01=arg[6]? arg[6][0] : 0;
a01=2.*a01;
a01=sqrt(a01);
a02=arg[0]? arg[0][0] : 0;
a02=sqrt(a02);
a03=arg[1]? arg[1][0] : 0;
a04=casadi_fmax(a00,a03);
a04=sqrt(a04);
a05=a02*a04;
a06=arg[2]? arg[2][0] : 0;
a07=a03+a06;
a08=5.0000000000000000e-01;
a09=arg[4]? arg[4][0] : 0;
a09=a08*a09;
a10=arg[5]? arg[5][0] : 0;
a11=a09*a10;
a12=arg[3]? arg[3][0] : 0;
a13=a11*a12;
a13=sqrt(a13);
a14=a07*a13;
a05=a05-a14;
a14=a01*a05;
a06=sqrt(a06);
a15=a06*a02;
a14=a14/a15;
a16=casadi_fmax(a00,a14);
a16=2.*a16;
a17=a00<=a14;
a18=a14<=a00;
a18=a18+a17;
a17=a17/a18;
a18=arg[16]? arg[16][0] : 0;
a18=a18/a01;
a05=a05*a18;
a19=arg[10]? arg[10][0] : 0;
a20=2.*a02;
a19=a19/a20;
a20=a04*a19;
a21=a00<=a03;
a03=a03<=a00;
a03=a03+a21;
a21=a21/a03;
a03=arg[11]? arg[11][0] : 0;
a21=a21*a03;
a04=2.*a04;
a21=a21/a04;
a21=a02*a21;
a20=a20+a21;
a21=arg[12]? arg[12][0] : 0;
a03=a03+a21;
a04=a13*a03;
a00=arg[14]? arg[14][0] : 0;
a08=a08*a00;
a10=a10*a08;
a08=arg[15]? arg[15][0] : 0;
a09=a09*a08;
a10=a10+a09;
a12=a12*a10;
a10=arg[13]? arg[13][0] : 0;
a11=a11*a10;
a12=a12+a11;
a13=2.*a13;
a12=a12/a13;
a12=a07*a12;
a04=a04+a12;
a20=a20-a04;
a20=a01*a20;
a05=a05+a20;
a05=a05/a15;
a15=a14/a15;
a20=2.*a06;
a21=a21/a20;
a02=a02*a21;
a19=a06*a19;
a02=a02+a19;
a15=a15*a02;
a05=a05-a15;
a17=a17*a05;
a16=a16*a17;
if (res[0]!=0) res[0][0]=a16;
a16=arg[7]? arg[7][0] : 0;
a16=sqrt(a16);
a14=a16-a14;
a21=a14*a21;
a17=arg[17]? arg[17][0] : 0;
a16=2.*a16;
a17=a17/a16;
a17=a17-a05;
a17=a06*a17;
a21=a21+a17;
a07=sqrt(a07);
a17=a07*a01;
a21=a21/a17;
a06=a06*a14;
a06=a06/a17;
a06=a06/a17;
a17=2.*a07;
a03=a03/a17;
a01=a01*a03;
a07=a07*a18;
a01=a01+a07;
a06=a06*a01;
a21=a21-a06;
if (res[1]!=0) res[1][0]=a21;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_tail_wheel_always(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f41(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_tail_wheel_always_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_tail_wheel_always_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_tail_wheel_always_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_tail_wheel_always_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_tail_wheel_always_n_in(void) { return 18;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_tail_wheel_always_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_tail_wheel_always_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_tail_wheel_always_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "a";
case 2: return "b";
case 3: return "rho";
case 4: return "Ap";
case 5: return "CL_gamma";
case 6: return "C_alpha";
case 7: return "Ct";
case 8: return "out_Ct_always";
case 9: return "out_speed_margin";
case 10: return "fwd_m";
case 11: return "fwd_a";
case 12: return "fwd_b";
case 13: return "fwd_rho";
case 14: return "fwd_Ap";
case 15: return "fwd_CL_gamma";
case 16: return "fwd_C_alpha";
case 17: return "fwd_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_tail_wheel_always_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_Ct_always";
case 1: return "fwd_speed_margin";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_tail_wheel_always_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
case 8: return casadi_s1;
case 9: return casadi_s1;
case 10: return casadi_s0;
case 11: return casadi_s0;
case 12: return casadi_s0;
case 13: return casadi_s0;
case 14: return casadi_s0;
case 15: return casadi_s0;
case 16: return casadi_s0;
case 17: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_tail_wheel_always_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_tail_wheel_always_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 18;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_tail_wheel_always_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 18*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_tail_wheel_always:(m,a,b,rho,Ap,CL_gamma,C_alpha,Ct,out_Ct_always[1x1,0nz],out_speed_margin[1x1,0nz],adj_Ct_always,adj_speed_margin)->(adj_m,adj_a,adj_b,adj_rho,adj_Ap,adj_CL_gamma,adj_C_alpha,adj_Ct) */
static int casadi_f42(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24;
a00=0.;
a01=arg[1]? arg[1][0] : 0;
a02=casadi_fmax(a00,a01);
a02=sqrt(a02);
a03=arg[6]? arg[6][0] : 0;
a03=2.*a03;
a03=sqrt(a03);
a04=arg[0]? arg[0][0] : 0;
a04=sqrt(a04);
a05=a04*a02;
a06=arg[2]? arg[2][0] : 0;
a07=a01+a06;
a08=5.0000000000000000e-01;
a09=arg[4]? arg[4][0] : 0;
a09=a08*a09;
a10=arg[5]? arg[5][0] : 0;
a11=a09*a10;
a12=arg[3]? arg[3][0] : 0;
a13=a11*a12;
a13=sqrt(a13);
a14=a07*a13;
a05=a05-a14;
a14=a03*a05;
a06=sqrt(a06);
a15=a06*a04;
a14=a14/a15;
a16=a00<=a14;
a17=a14<=a00;
a17=a17+a16;
a16=a16/a17;
a17=casadi_fmax(a00,a14);
a17=2.*a17;
a18=arg[10]? arg[10][0] : 0;
a17=a17*a18;
a16=a16*a17;
a17=arg[11]? arg[11][0] : 0;
a18=sqrt(a07);
a19=a18*a03;
a20=a17/a19;
a21=a06*a20;
a16=a16-a21;
a22=a16/a15;
a23=a03*a22;
a24=a02*a23;
a15=a14/a15;
a15=a15*a16;
a16=a06*a15;
a24=a24-a16;
a16=2.*a04;
a24=a24/a16;
if (res[0]!=0) res[0][0]=a24;
a24=a00<=a01;
a01=a01<=a00;
a01=a01+a24;
a24=a24/a01;
a01=a04*a23;
a02=2.*a02;
a01=a01/a02;
a24=a24*a01;
a01=arg[7]? arg[7][0] : 0;
a01=sqrt(a01);
a14=a01-a14;
a02=a06*a14;
a02=a02/a19;
a02=a02/a19;
a02=a02*a17;
a17=a03*a02;
a19=2.*a18;
a17=a17/a19;
a19=a13*a23;
a17=a17+a19;
a24=a24-a17;
if (res[1]!=0) res[1][0]=a24;
a14=a14*a20;
a04=a04*a15;
a14=a14-a04;
a06=2.*a06;
a14=a14/a06;
a14=a14-a17;
if (res[2]!=0) res[2][0]=a14;
a07=a07*a23;
a13=2.*a13;
a07=a07/a13;
a11=a11*a07;
a11=-a11;
if (res[3]!=0) res[3][0]=a11;
a12=a12*a07;
a10=a10*a12;
a08=a08*a10;
a08=-a08;
if (res[4]!=0) res[4][0]=a08;
a09=a09*a12;
a09=-a09;
if (res[5]!=0) res[5][0]=a09;
a05=a05*a22;
a18=a18*a02;
a05=a05-a18;
a03=2.*a03;
a05=a05/a03;
a05=2.*a05;
if (res[6]!=0) res[6][0]=a05;
a01=2.*a01;
a21=a21/a01;
if (res[7]!=0) res[7][0]=a21;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_tail_wheel_always(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f42(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_tail_wheel_always_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_tail_wheel_always_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_tail_wheel_always_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_tail_wheel_always_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_tail_wheel_always_n_in(void) { return 12;}
CASADI_SYMBOL_EXPORT casadi_int adj1_tail_wheel_always_n_out(void) { return 8;}
CASADI_SYMBOL_EXPORT casadi_real adj1_tail_wheel_always_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_tail_wheel_always_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "a";
case 2: return "b";
case 3: return "rho";
case 4: return "Ap";
case 5: return "CL_gamma";
case 6: return "C_alpha";
case 7: return "Ct";
case 8: return "out_Ct_always";
case 9: return "out_speed_margin";
case 10: return "adj_Ct_always";
case 11: return "adj_speed_margin";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_tail_wheel_always_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_m";
case 1: return "adj_a";
case 2: return "adj_b";
case 3: return "adj_rho";
case 4: return "adj_Ap";
case 5: return "adj_CL_gamma";
case 6: return "adj_C_alpha";
case 7: return "adj_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_tail_wheel_always_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
case 8: return casadi_s1;
case 9: return casadi_s1;
case 10: return casadi_s0;
case 11: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_tail_wheel_always_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_tail_wheel_always_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 12;
if (sz_res) *sz_res = 8;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_tail_wheel_always_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
if (sz_res) *sz_res = 8*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_tail_wheel_always:(m,a,b,rho,Ap,CL_gamma,C_alpha,Ct,out_Ct_always[1x1,0nz],out_speed_margin[1x1,0nz],adj_Ct_always,adj_speed_margin,out_adj_m[1x1,0nz],out_adj_a[1x1,0nz],out_adj_b[1x1,0nz],out_adj_rho[1x1,0nz],out_adj_Ap[1x1,0nz],out_adj_CL_gamma[1x1,0nz],out_adj_C_alpha[1x1,0nz],out_adj_Ct[1x1,0nz],fwd_m,fwd_a,fwd_b,fwd_rho,fwd_Ap,fwd_CL_gamma,fwd_C_alpha,fwd_Ct,fwd_out_Ct_always[1x1,0nz],fwd_out_speed_margin[1x1,0nz],fwd_adj_Ct_always,fwd_adj_speed_margin)->(fwd_adj_m,fwd_adj_a,fwd_adj_b,fwd_adj_rho,fwd_adj_Ap,fwd_adj_CL_gamma,fwd_adj_C_alpha,fwd_adj_Ct) */
static int casadi_f43(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
casadi_real a48, a49;
a00=arg[6]? arg[6][0] : 0;
a00=2.*a00;
a00=sqrt(a00);
a01=0.;
a02=arg[0]? arg[0][0] : 0;
a02=sqrt(a02);
a03=arg[1]? arg[1][0] : 0;
a04=casadi_fmax(a01,a03);
a04=sqrt(a04);
a05=a02*a04;
a06=arg[2]? arg[2][0] : 0;
a07=a03+a06;
a08=5.0000000000000000e-01;
a09=arg[4]? arg[4][0] : 0;
a09=a08*a09;
a10=arg[5]? arg[5][0] : 0;
a11=a09*a10;
a12=arg[3]? arg[3][0] : 0;
a13=a11*a12;
a13=sqrt(a13);
a14=a07*a13;
a05=a05-a14;
a14=a00*a05;
a06=sqrt(a06);
a15=a06*a02;
a14=a14/a15;
a16=a01<=a14;
a17=a14<=a01;
a17=a17+a16;
a16=a16/a17;
a17=casadi_fmax(a01,a14);
a17=2.*a17;
a18=arg[10]? arg[10][0] : 0;
a19=a17*a18;
a19=a16*a19;
a20=arg[11]? arg[11][0] : 0;
a21=sqrt(a07);
a22=a21*a00;
a23=a20/a22;
a24=a06*a23;
a19=a19-a24;
a25=a19/a15;
a26=a00*a25;
a27=a01<=a03;
a28=a03<=a01;
a28=a28+a27;
a27=a27/a28;
a28=arg[21]? arg[21][0] : 0;
a27=a27*a28;
a29=2.*a04;
a27=a27/a29;
a29=a26*a27;
a30=arg[26]? arg[26][0] : 0;
a30=a30/a00;
a31=a25*a30;
a32=a01<=a14;
a33=a14<=a01;
a33=a33+a32;
a32=a32/a33;
a33=a05*a30;
a34=arg[20]? arg[20][0] : 0;
a35=2.*a02;
a34=a34/a35;
a35=a04*a34;
a36=a02*a27;
a35=a35+a36;
a36=arg[22]? arg[22][0] : 0;
a28=a28+a36;
a37=a13*a28;
a38=arg[24]? arg[24][0] : 0;
a38=a08*a38;
a39=a10*a38;
a40=arg[25]? arg[25][0] : 0;
a41=a09*a40;
a39=a39+a41;
a41=a12*a39;
a42=arg[23]? arg[23][0] : 0;
a43=a11*a42;
a41=a41+a43;
a43=2.*a13;
a41=a41/a43;
a43=a07*a41;
a37=a37+a43;
a35=a35-a37;
a37=a00*a35;
a33=a33+a37;
a33=a33/a15;
a37=a14/a15;
a43=2.*a06;
a36=a36/a43;
a43=a02*a36;
a44=a06*a34;
a43=a43+a44;
a37=a37*a43;
a33=a33-a37;
a32=a32*a33;
a32=2.*a32;
a18=a18*a32;
a32=arg[30]? arg[30][0] : 0;
a17=a17*a32;
a18=a18+a17;
a16=a16*a18;
a18=a23*a36;
a17=arg[31]? arg[31][0] : 0;
a32=a17/a22;
a37=a23/a22;
a44=2.*a21;
a44=a28/a44;
a45=a00*a44;
a46=a21*a30;
a45=a45+a46;
a37=a37*a45;
a32=a32-a37;
a37=a06*a32;
a18=a18+a37;
a16=a16-a18;
a37=a16/a15;
a46=a25/a15;
a46=a46*a43;
a37=a37-a46;
a46=a00*a37;
a31=a31+a46;
a46=a04*a31;
a29=a29+a46;
a46=a14/a15;
a47=a46*a19;
a48=a47*a36;
a49=a33/a15;
a15=a46/a15;
a15=a15*a43;
a49=a49-a15;
a19=a19*a49;
a46=a46*a16;
a19=a19+a46;
a46=a06*a19;
a48=a48+a46;
a29=a29-a48;
a48=2.*a02;
a29=a29/a48;
a46=a04*a26;
a16=a06*a47;
a46=a46-a16;
a46=a46/a48;
a46=a46/a48;
a48=2.*a34;
a46=a46*a48;
a29=a29-a46;
if (res[0]!=0) res[0][0]=a29;
a29=a01<=a03;
a03=a03<=a01;
a03=a03+a29;
a29=a29/a03;
a03=a26*a34;
a01=a02*a31;
a03=a03+a01;
a04=2.*a04;
a03=a03/a04;
a01=a02*a26;
a01=a01/a04;
a01=a01/a04;
a27=2.*a27;
a01=a01*a27;
a03=a03-a01;
a29=a29*a03;
a03=arg[7]? arg[7][0] : 0;
a03=sqrt(a03);
a14=a03-a14;
a01=a06*a14;
a01=a01/a22;
a27=a01/a22;
a04=a27*a20;
a46=a04*a30;
a48=a14*a36;
a16=arg[27]? arg[27][0] : 0;
a49=2.*a03;
a16=a16/a49;
a33=a16-a33;
a49=a06*a33;
a48=a48+a49;
a48=a48/a22;
a01=a01/a22;
a01=a01*a45;
a48=a48-a01;
a48=a48/a22;
a22=a27/a22;
a22=a22*a45;
a48=a48-a22;
a20=a20*a48;
a27=a27*a17;
a20=a20+a27;
a27=a00*a20;
a46=a46+a27;
a27=2.*a21;
a46=a46/a27;
a17=a00*a04;
a17=a17/a27;
a17=a17/a27;
a27=2.*a44;
a17=a17*a27;
a46=a46-a17;
a17=a26*a41;
a27=a13*a31;
a17=a17+a27;
a46=a46+a17;
a29=a29-a46;
if (res[1]!=0) res[1][0]=a29;
a33=a23*a33;
a32=a14*a32;
a33=a33+a32;
a34=a47*a34;
a19=a02*a19;
a34=a34+a19;
a33=a33-a34;
a06=2.*a06;
a33=a33/a06;
a14=a14*a23;
a02=a02*a47;
a14=a14-a02;
a14=a14/a06;
a14=a14/a06;
a36=2.*a36;
a14=a14*a36;
a33=a33-a14;
a33=a33-a46;
if (res[2]!=0) res[2][0]=a33;
a33=a07*a26;
a13=2.*a13;
a33=a33/a13;
a39=a33*a39;
a26=a26*a28;
a07=a07*a31;
a26=a26+a07;
a26=a26/a13;
a13=a33/a13;
a41=2.*a41;
a13=a13*a41;
a26=a26-a13;
a11=a11*a26;
a39=a39+a11;
a39=-a39;
if (res[3]!=0) res[3][0]=a39;
a39=a12*a33;
a40=a39*a40;
a33=a33*a42;
a12=a12*a26;
a33=a33+a12;
a10=a10*a33;
a40=a40+a10;
a08=a08*a40;
a08=-a08;
if (res[4]!=0) res[4][0]=a08;
a39=a39*a38;
a09=a09*a33;
a39=a39+a09;
a39=-a39;
if (res[5]!=0) res[5][0]=a39;
a35=a25*a35;
a37=a05*a37;
a35=a35+a37;
a44=a04*a44;
a20=a21*a20;
a44=a44+a20;
a35=a35-a44;
a00=2.*a00;
a35=a35/a00;
a05=a05*a25;
a21=a21*a04;
a05=a05-a21;
a05=a05/a00;
a05=a05/a00;
a30=2.*a30;
a05=a05*a30;
a35=a35-a05;
a35=2.*a35;
if (res[6]!=0) res[6][0]=a35;
a03=2.*a03;
a18=a18/a03;
a24=a24/a03;
a24=a24/a03;
a16=2.*a16;
a24=a24*a16;
a18=a18-a24;
if (res[7]!=0) res[7][0]=a18;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_tail_wheel_always(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f43(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_tail_wheel_always_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_tail_wheel_always_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_tail_wheel_always_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_tail_wheel_always_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_tail_wheel_always_n_in(void) { return 32;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_tail_wheel_always_n_out(void) { return 8;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_tail_wheel_always_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_tail_wheel_always_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "a";
case 2: return "b";
case 3: return "rho";
case 4: return "Ap";
case 5: return "CL_gamma";
case 6: return "C_alpha";
case 7: return "Ct";
case 8: return "out_Ct_always";
case 9: return "out_speed_margin";
case 10: return "adj_Ct_always";
case 11: return "adj_speed_margin";
case 12: return "out_adj_m";
case 13: return "out_adj_a";
case 14: return "out_adj_b";
case 15: return "out_adj_rho";
case 16: return "out_adj_Ap";
case 17: return "out_adj_CL_gamma";
case 18: return "out_adj_C_alpha";
case 19: return "out_adj_Ct";
case 20: return "fwd_m";
case 21: return "fwd_a";
case 22: return "fwd_b";
case 23: return "fwd_rho";
case 24: return "fwd_Ap";
case 25: return "fwd_CL_gamma";
case 26: return "fwd_C_alpha";
case 27: return "fwd_Ct";
case 28: return "fwd_out_Ct_always";
case 29: return "fwd_out_speed_margin";
case 30: return "fwd_adj_Ct_always";
case 31: return "fwd_adj_speed_margin";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_tail_wheel_always_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_m";
case 1: return "fwd_adj_a";
case 2: return "fwd_adj_b";
case 3: return "fwd_adj_rho";
case 4: return "fwd_adj_Ap";
case 5: return "fwd_adj_CL_gamma";
case 6: return "fwd_adj_C_alpha";
case 7: return "fwd_adj_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_tail_wheel_always_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
case 8: return casadi_s1;
case 9: return casadi_s1;
case 10: return casadi_s0;
case 11: return casadi_s0;
case 12: return casadi_s1;
case 13: return casadi_s1;
case 14: return casadi_s1;
case 15: return casadi_s1;
case 16: return casadi_s1;
case 17: return casadi_s1;
case 18: return casadi_s1;
case 19: return casadi_s1;
case 20: return casadi_s0;
case 21: return casadi_s0;
case 22: return casadi_s0;
case 23: return casadi_s0;
case 24: return casadi_s0;
case 25: return casadi_s0;
case 26: return casadi_s0;
case 27: return casadi_s0;
case 28: return casadi_s1;
case 29: return casadi_s1;
case 30: return casadi_s0;
case 31: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_tail_wheel_always_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_tail_wheel_always_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 32;
if (sz_res) *sz_res = 8;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_tail_wheel_always_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 32*sizeof(const casadi_real*);
if (sz_res) *sz_res = 8*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* gear_position:(m,b,u,rho,Ap,CL_gamma,C_alpha,Ct)->(a_lost,a_regained) */
static int casadi_f44(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5, a6, a7, a8, a9;
a0=arg[7]? arg[7][0] : 0;
a1=5.0000000000000000e-01;
a2=arg[4]? arg[4][0] : 0;
a2=a1*a2;
a3=arg[5]? arg[5][0] : 0;
a2=a2*a3;
a3=arg[3]? arg[3][0] : 0;
a2=a2*a3;
a3=arg[2]? arg[2][0] : 0;
a4=casadi_sq(a3);
a2=a2*a4;
a0=a0+a2;
a2=2.*a0;
a4=arg[1]? arg[1][0] : 0;
a2=a2*a4;
a5=arg[6]? arg[6][0] : 0;
a6=2.*a5;
a6=a6*a4;
a4=arg[0]? arg[0][0] : 0;
a7=casadi_sq(a3);
a7=a4*a7;
a6=a6+a7;
a6=a2*a6;
a7=2.*a6;
a8=-4.;
a6=a8*a6;
a9=4.;
a9=a9*a5;
a9=a9*a0;
a6=a6*a9;
a8=a8*a5;
a3=casadi_sq(a3);
a4=a4*a3;
a4=a4-a2;
a8=a8*a4;
a4=casadi_sq(a8);
a6=a6+a4;
a6=sqrt(a6);
a6=a6-a8;
a7=a7/a6;
if (res[0]!=0) res[0][0]=a7;
a1=a1*a6;
a1=a1/a9;
if (res[1]!=0) res[1][0]=a1;
return 0;
}
CASADI_SYMBOL_EXPORT int gear_position(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f44(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int gear_position_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void gear_position_release(int mem) {
}
CASADI_SYMBOL_EXPORT void gear_position_incref(void) {
}
CASADI_SYMBOL_EXPORT void gear_position_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int gear_position_n_in(void) { return 8;}
CASADI_SYMBOL_EXPORT casadi_int gear_position_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real gear_position_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* gear_position_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "b";
case 2: return "u";
case 3: return "rho";
case 4: return "Ap";
case 5: return "CL_gamma";
case 6: return "C_alpha";
case 7: return "Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* gear_position_name_out(casadi_int i) {
switch (i) {
case 0: return "a_lost";
case 1: return "a_regained";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* gear_position_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* gear_position_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int gear_position_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 8;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int gear_position_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 8*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_gear_position:(m,b,u,rho,Ap,CL_gamma,C_alpha,Ct,out_a_lost[1x1,0nz],out_a_regained[1x1,0nz],fwd_m,fwd_b,fwd_u,fwd_rho,fwd_Ap,fwd_CL_gamma,fwd_C_alpha,fwd_Ct)->(fwd_a_lost,fwd_a_regained) */
static int casadi_f45(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22;
a00=arg[6]? arg[6][0] : 0;
a01=2.*a00;
a02=arg[1]? arg[1][0] : 0;
a03=a01*a02;
a04=arg[0]? arg[0][0] : 0;
a05=arg[2]? arg[2][0] : 0;
a06=casadi_sq(a05);
a07=a04*a06;
a03=a03+a07;
a07=arg[17]? arg[17][0] : 0;
a08=casadi_sq(a05);
a09=arg[3]? arg[3][0] : 0;
a10=arg[5]? arg[5][0] : 0;
a11=5.0000000000000000e-01;
a12=arg[14]? arg[14][0] : 0;
a12=a11*a12;
a12=a10*a12;
a13=arg[4]? arg[4][0] : 0;
a13=a11*a13;
a14=arg[15]? arg[15][0] : 0;
a14=a13*a14;
a12=a12+a14;
a12=a09*a12;
a13=a13*a10;
a10=arg[13]? arg[13][0] : 0;
a10=a13*a10;
a12=a12+a10;
a12=a08*a12;
a13=a13*a09;
a09=2.*a05;
a10=arg[12]? arg[12][0] : 0;
a09=a09*a10;
a09=a13*a09;
a12=a12+a09;
a07=a07+a12;
a12=2.*a07;
a12=a02*a12;
a09=arg[7]? arg[7][0] : 0;
a13=a13*a08;
a09=a09+a13;
a13=2.*a09;
a08=arg[11]? arg[11][0] : 0;
a14=a13*a08;
a12=a12+a14;
a14=a03*a12;
a13=a13*a02;
a15=arg[16]? arg[16][0] : 0;
a16=2.*a15;
a02=a02*a16;
a01=a01*a08;
a02=a02+a01;
a01=arg[10]? arg[10][0] : 0;
a06=a06*a01;
a08=2.*a05;
a08=a08*a10;
a08=a04*a08;
a06=a06+a08;
a02=a02+a06;
a02=a13*a02;
a14=a14+a02;
a02=2.*a14;
a06=-4.;
a03=a13*a03;
a08=a06*a03;
a16=4.;
a17=a16*a00;
a18=a17*a09;
a19=a08*a18;
a00=a06*a00;
a20=casadi_sq(a05);
a21=a04*a20;
a21=a21-a13;
a13=a00*a21;
a22=casadi_sq(a13);
a19=a19+a22;
a19=sqrt(a19);
a22=a19-a13;
a02=a02/a22;
a03=2.*a03;
a03=a03/a22;
a03=a03/a22;
a14=a06*a14;
a14=a18*a14;
a16=a16*a15;
a09=a09*a16;
a17=a17*a07;
a09=a09+a17;
a08=a08*a09;
a14=a14+a08;
a13=2.*a13;
a06=a06*a15;
a21=a21*a06;
a20=a20*a01;
a05=2.*a05;
a05=a05*a10;
a04=a04*a05;
a20=a20+a04;
a20=a20-a12;
a00=a00*a20;
a21=a21+a00;
a13=a13*a21;
a14=a14+a13;
a19=2.*a19;
a14=a14/a19;
a14=a14-a21;
a03=a03*a14;
a02=a02-a03;
if (res[0]!=0) res[0][0]=a02;
a14=a11*a14;
a14=a14/a18;
a11=a11*a22;
a11=a11/a18;
a11=a11/a18;
a11=a11*a09;
a14=a14-a11;
if (res[1]!=0) res[1][0]=a14;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_gear_position(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f45(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_gear_position_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_gear_position_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_gear_position_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_gear_position_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_gear_position_n_in(void) { return 18;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_gear_position_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_gear_position_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_gear_position_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "b";
case 2: return "u";
case 3: return "rho";
case 4: return "Ap";
case 5: return "CL_gamma";
case 6: return "C_alpha";
case 7: return "Ct";
case 8: return "out_a_lost";
case 9: return "out_a_regained";
case 10: return "fwd_m";
case 11: return "fwd_b";
case 12: return "fwd_u";
case 13: return "fwd_rho";
case 14: return "fwd_Ap";
case 15: return "fwd_CL_gamma";
case 16: return "fwd_C_alpha";
case 17: return "fwd_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_gear_position_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_a_lost";
case 1: return "fwd_a_regained";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_gear_position_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
case 8: return casadi_s1;
case 9: return casadi_s1;
case 10: return casadi_s0;
case 11: return casadi_s0;
case 12: return casadi_s0;
case 13: return casadi_s0;
case 14: return casadi_s0;
case 15: return casadi_s0;
case 16: return casadi_s0;
case 17: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_gear_position_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_gear_position_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 18;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_gear_position_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 18*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_gear_position:(m,b,u,rho,Ap,CL_gamma,C_alpha,Ct,out_a_lost[1x1,0nz],out_a_regained[1x1,0nz],adj_a_lost,adj_a_regained)->(adj_m,adj_b,adj_u,adj_rho,adj_Ap,adj_CL_gamma,adj_C_alpha,adj_Ct) */
static int casadi_f46(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30;
a00=arg[2]? arg[2][0] : 0;
a01=casadi_sq(a00);
a02=-4.;
a03=arg[6]? arg[6][0] : 0;
a04=a02*a03;
a05=arg[0]? arg[0][0] : 0;
a06=a05*a01;
a07=arg[7]? arg[7][0] : 0;
a08=5.0000000000000000e-01;
a09=arg[4]? arg[4][0] : 0;
a09=a08*a09;
a10=arg[5]? arg[5][0] : 0;
a11=a09*a10;
a12=arg[3]? arg[3][0] : 0;
a13=a11*a12;
a14=casadi_sq(a00);
a15=a13*a14;
a07=a07+a15;
a15=2.*a07;
a16=arg[1]? arg[1][0] : 0;
a17=a15*a16;
a06=a06-a17;
a18=a04*a06;
a19=2.*a18;
a20=arg[11]? arg[11][0] : 0;
a21=4.;
a22=a21*a03;
a23=a22*a07;
a24=a20/a23;
a24=a08*a24;
a03=2.*a03;
a25=a03*a16;
a26=casadi_sq(a00);
a27=a05*a26;
a25=a25+a27;
a27=a17*a25;
a28=2.*a27;
a27=a02*a27;
a29=a27*a23;
a30=casadi_sq(a18);
a29=a29+a30;
a29=sqrt(a29);
a18=a29-a18;
a28=a28/a18;
a28=a28/a18;
a30=arg[10]? arg[10][0] : 0;
a28=a28*a30;
a24=a24-a28;
a29=2.*a29;
a29=a24/a29;
a19=a19*a29;
a19=a19-a24;
a04=a04*a19;
a01=a01*a04;
a24=a23*a29;
a24=a02*a24;
a30=a30/a18;
a30=2.*a30;
a24=a24+a30;
a17=a17*a24;
a26=a26*a17;
a01=a01+a26;
if (res[0]!=0) res[0][0]=a01;
a03=a03*a17;
a25=a25*a24;
a25=a25-a04;
a15=a15*a25;
a03=a03+a15;
if (res[1]!=0) res[1][0]=a03;
a03=2.*a00;
a04=a05*a04;
a03=a03*a04;
a04=2.*a00;
a05=a05*a17;
a04=a04*a05;
a03=a03+a04;
a00=2.*a00;
a27=a27*a29;
a18=a08*a18;
a18=a18/a23;
a18=a18/a23;
a18=a18*a20;
a27=a27-a18;
a22=a22*a27;
a25=a16*a25;
a25=2.*a25;
a22=a22+a25;
a13=a13*a22;
a00=a00*a13;
a03=a03+a00;
if (res[2]!=0) res[2][0]=a03;
a14=a14*a22;
a11=a11*a14;
if (res[3]!=0) res[3][0]=a11;
a12=a12*a14;
a10=a10*a12;
a08=a08*a10;
if (res[4]!=0) res[4][0]=a08;
a09=a09*a12;
if (res[5]!=0) res[5][0]=a09;
a06=a06*a19;
a02=a02*a06;
a07=a07*a27;
a21=a21*a07;
a02=a02+a21;
a16=a16*a17;
a16=2.*a16;
a02=a02+a16;
if (res[6]!=0) res[6][0]=a02;
if (res[7]!=0) res[7][0]=a22;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_gear_position(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f46(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_gear_position_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_gear_position_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_gear_position_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_gear_position_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_gear_position_n_in(void) { return 12;}
CASADI_SYMBOL_EXPORT casadi_int adj1_gear_position_n_out(void) { return 8;}
CASADI_SYMBOL_EXPORT casadi_real adj1_gear_position_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_gear_position_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "b";
case 2: return "u";
case 3: return "rho";
case 4: return "Ap";
case 5: return "CL_gamma";
case 6: return "C_alpha";
case 7: return "Ct";
case 8: return "out_a_lost";
case 9: return "out_a_regained";
case 10: return "adj_a_lost";
case 11: return "adj_a_regained";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_gear_position_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_m";
case 1: return "adj_b";
case 2: return "adj_u";
case 3: return "adj_rho";
case 4: return "adj_Ap";
case 5: return "adj_CL_gamma";
case 6: return "adj_C_alpha";
case 7: return "adj_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_gear_position_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
case 8: return casadi_s1;
case 9: return casadi_s1;
case 10: return casadi_s0;
case 11: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_gear_position_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_gear_position_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 12;
if (sz_res) *sz_res = 8;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_gear_position_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
if (sz_res) *sz_res = 8*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_gear_position:(m,b,u,rho,Ap,CL_gamma,C_alpha,Ct,out_a_lost[1x1,0nz],out_a_regained[1x1,0nz],adj_a_lost,adj_a_regained,out_adj_m[1x1,0nz],out_adj_b[1x1,0nz],out_adj_u[1x1,0nz],out_adj_rho[1x1,0nz],out_adj_Ap[1x1,0nz],out_adj_CL_gamma[1x1,0nz],out_adj_C_alpha[1x1,0nz],out_adj_Ct[1x1,0nz],fwd_m,fwd_b,fwd_u,fwd_rho,fwd_Ap,fwd_CL_gamma,fwd_C_alpha,fwd_Ct,fwd_out_a_lost[1x1,0nz],fwd_out_a_regained[1x1,0nz],fwd_adj_a_lost,fwd_adj_a_regained)->(fwd_adj_m,fwd_adj_b,fwd_adj_u,fwd_adj_rho,fwd_adj_Ap,fwd_adj_CL_gamma,fwd_adj_C_alpha,fwd_adj_Ct) */
static int casadi_f47(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
casadi_real a60, a61, a62, a63;
a00=-4.;
a01=arg[6]? arg[6][0] : 0;
a02=a00*a01;
a03=arg[0]? arg[0][0] : 0;
a04=arg[2]? arg[2][0] : 0;
a05=casadi_sq(a04);
a06=a03*a05;
a07=arg[7]? arg[7][0] : 0;
a08=5.0000000000000000e-01;
a09=arg[4]? arg[4][0] : 0;
a09=a08*a09;
a10=arg[5]? arg[5][0] : 0;
a11=a09*a10;
a12=arg[3]? arg[3][0] : 0;
a13=a11*a12;
a14=casadi_sq(a04);
a15=a13*a14;
a07=a07+a15;
a15=2.*a07;
a16=arg[1]? arg[1][0] : 0;
a17=a15*a16;
a06=a06-a17;
a18=a02*a06;
a19=2.*a18;
a20=arg[11]? arg[11][0] : 0;
a21=4.;
a22=a21*a01;
a23=a22*a07;
a24=a20/a23;
a25=a08*a24;
a01=2.*a01;
a26=a01*a16;
a27=casadi_sq(a04);
a28=a03*a27;
a26=a26+a28;
a28=a17*a26;
a29=2.*a28;
a28=a00*a28;
a30=a28*a23;
a31=casadi_sq(a18);
a30=a30+a31;
a30=sqrt(a30);
a31=a30-a18;
a29=a29/a31;
a32=a29/a31;
a33=arg[10]? arg[10][0] : 0;
a34=a32*a33;
a25=a25-a34;
a34=2.*a30;
a35=a25/a34;
a36=a19*a35;
a36=a36-a25;
a25=a02*a36;
a37=2.*a04;
a38=arg[22]? arg[22][0] : 0;
a37=a37*a38;
a39=a25*a37;
a40=arg[26]? arg[26][0] : 0;
a41=a00*a40;
a42=a36*a41;
a41=a06*a41;
a43=arg[20]? arg[20][0] : 0;
a44=a05*a43;
a37=a03*a37;
a44=a44+a37;
a37=arg[27]? arg[27][0] : 0;
a45=arg[24]? arg[24][0] : 0;
a45=a08*a45;
a46=a10*a45;
a47=arg[25]? arg[25][0] : 0;
a48=a09*a47;
a46=a46+a48;
a48=a12*a46;
a49=arg[23]? arg[23][0] : 0;
a50=a11*a49;
a48=a48+a50;
a50=a14*a48;
a51=2.*a04;
a51=a51*a38;
a52=a13*a51;
a50=a50+a52;
a37=a37+a50;
a50=2.*a37;
a52=a16*a50;
a53=arg[21]? arg[21][0] : 0;
a54=a15*a53;
a52=a52+a54;
a44=a44-a52;
a54=a02*a44;
a41=a41+a54;
a54=2.*a41;
a54=a35*a54;
a55=arg[31]? arg[31][0] : 0;
a56=a55/a23;
a24=a24/a23;
a57=a21*a40;
a58=a07*a57;
a59=a22*a37;
a58=a58+a59;
a24=a24*a58;
a56=a56-a24;
a56=a08*a56;
a24=a26*a52;
a40=2.*a40;
a59=a16*a40;
a60=a01*a53;
a59=a59+a60;
a60=a27*a43;
a61=2.*a04;
a61=a61*a38;
a62=a03*a61;
a60=a60+a62;
a59=a59+a60;
a60=a17*a59;
a24=a24+a60;
a60=2.*a24;
a60=a60/a31;
a29=a29/a31;
a24=a00*a24;
a62=a23*a24;
a63=a28*a58;
a62=a62+a63;
a18=2.*a18;
a18=a18*a41;
a62=a62+a18;
a30=2.*a30;
a62=a62/a30;
a41=a62-a41;
a29=a29*a41;
a60=a60-a29;
a60=a60/a31;
a29=a32/a31;
a29=a29*a41;
a60=a60-a29;
a60=a33*a60;
a29=arg[30]? arg[30][0] : 0;
a32=a32*a29;
a60=a60+a32;
a56=a56-a60;
a60=a56/a34;
a34=a35/a34;
a62=2.*a62;
a34=a34*a62;
a60=a60-a34;
a19=a19*a60;
a54=a54+a19;
a54=a54-a56;
a02=a02*a54;
a42=a42+a02;
a05=a05*a42;
a39=a39+a05;
a05=a23*a35;
a05=a00*a05;
a33=a33/a31;
a02=2.*a33;
a05=a05+a02;
a02=a17*a05;
a61=a02*a61;
a52=a05*a52;
a56=a35*a58;
a19=a23*a60;
a56=a56+a19;
a56=a00*a56;
a29=a29/a31;
a33=a33/a31;
a33=a33*a41;
a29=a29-a33;
a29=2.*a29;
a56=a56+a29;
a17=a17*a56;
a52=a52+a17;
a27=a27*a52;
a61=a61+a27;
a39=a39+a61;
if (res[0]!=0) res[0][0]=a39;
a40=a02*a40;
a01=a01*a52;
a40=a40+a01;
a01=a26*a05;
a01=a01-a25;
a50=a01*a50;
a05=a05*a59;
a26=a26*a56;
a05=a05+a26;
a05=a05-a42;
a15=a15*a05;
a50=a50+a15;
a40=a40+a50;
if (res[1]!=0) res[1][0]=a40;
a40=a03*a25;
a50=2.*a38;
a40=a40*a50;
a50=2.*a04;
a25=a25*a43;
a42=a03*a42;
a25=a25+a42;
a50=a50*a25;
a40=a40+a50;
a50=a03*a02;
a25=2.*a38;
a50=a50*a25;
a25=2.*a04;
a43=a02*a43;
a03=a03*a52;
a43=a43+a03;
a25=a25*a43;
a50=a50+a25;
a40=a40+a50;
a50=a28*a35;
a31=a08*a31;
a31=a31/a23;
a25=a31/a23;
a43=a25*a20;
a50=a50-a43;
a43=a22*a50;
a03=a16*a01;
a03=2.*a03;
a43=a43+a03;
a03=a13*a43;
a38=2.*a38;
a03=a03*a38;
a04=2.*a04;
a48=a43*a48;
a57=a50*a57;
a35=a35*a24;
a28=a28*a60;
a35=a35+a28;
a41=a08*a41;
a41=a41/a23;
a31=a31/a23;
a31=a31*a58;
a41=a41-a31;
a41=a41/a23;
a23=a25/a23;
a23=a23*a58;
a41=a41-a23;
a20=a20*a41;
a25=a25*a55;
a20=a20+a25;
a35=a35-a20;
a22=a22*a35;
a57=a57+a22;
a01=a01*a53;
a05=a16*a05;
a01=a01+a05;
a01=2.*a01;
a57=a57+a01;
a13=a13*a57;
a48=a48+a13;
a04=a04*a48;
a03=a03+a04;
a40=a40+a03;
if (res[2]!=0) res[2][0]=a40;
a40=a14*a43;
a46=a40*a46;
a43=a43*a51;
a14=a14*a57;
a43=a43+a14;
a11=a11*a43;
a46=a46+a11;
if (res[3]!=0) res[3][0]=a46;
a46=a12*a40;
a47=a46*a47;
a40=a40*a49;
a12=a12*a43;
a40=a40+a12;
a10=a10*a40;
a47=a47+a10;
a08=a08*a47;
if (res[4]!=0) res[4][0]=a08;
a46=a46*a45;
a09=a09*a40;
a46=a46+a09;
if (res[5]!=0) res[5][0]=a46;
a36=a36*a44;
a06=a06*a54;
a36=a36+a06;
a00=a00*a36;
a50=a50*a37;
a07=a07*a35;
a50=a50+a07;
a21=a21*a50;
a00=a00+a21;
a02=a02*a53;
a16=a16*a52;
a02=a02+a16;
a02=2.*a02;
a00=a00+a02;
if (res[6]!=0) res[6][0]=a00;
if (res[7]!=0) res[7][0]=a57;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_gear_position(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f47(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_gear_position_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_gear_position_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_gear_position_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_gear_position_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_gear_position_n_in(void) { return 32;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_gear_position_n_out(void) { return 8;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_gear_position_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_gear_position_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "b";
case 2: return "u";
case 3: return "rho";
case 4: return "Ap";
case 5: return "CL_gamma";
case 6: return "C_alpha";
case 7: return "Ct";
case 8: return "out_a_lost";
case 9: return "out_a_regained";
case 10: return "adj_a_lost";
case 11: return "adj_a_regained";
case 12: return "out_adj_m";
case 13: return "out_adj_b";
case 14: return "out_adj_u";
case 15: return "out_adj_rho";
case 16: return "out_adj_Ap";
case 17: return "out_adj_CL_gamma";
case 18: return "out_adj_C_alpha";
case 19: return "out_adj_Ct";
case 20: return "fwd_m";
case 21: return "fwd_b";
case 22: return "fwd_u";
case 23: return "fwd_rho";
case 24: return "fwd_Ap";
case 25: return "fwd_CL_gamma";
case 26: return "fwd_C_alpha";
case 27: return "fwd_Ct";
case 28: return "fwd_out_a_lost";
case 29: return "fwd_out_a_regained";
case 30: return "fwd_adj_a_lost";
case 31: return "fwd_adj_a_regained";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_gear_position_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_m";
case 1: return "fwd_adj_b";
case 2: return "fwd_adj_u";
case 3: return "fwd_adj_rho";
case 4: return "fwd_adj_Ap";
case 5: return "fwd_adj_CL_gamma";
case 6: return "fwd_adj_C_alpha";
case 7: return "fwd_adj_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_gear_position_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
case 8: return casadi_s1;
case 9: return casadi_s1;
case 10: return casadi_s0;
case 11: return casadi_s0;
case 12: return casadi_s1;
case 13: return casadi_s1;
case 14: return casadi_s1;
case 15: return casadi_s1;
case 16: return casadi_s1;
case 17: return casadi_s1;
case 18: return casadi_s1;
case 19: return casadi_s1;
case 20: return casadi_s0;
case 21: return casadi_s0;
case 22: return casadi_s0;
case 23: return casadi_s0;
case 24: return casadi_s0;
case 25: return casadi_s0;
case 26: return casadi_s0;
case 27: return casadi_s0;
case 28: return casadi_s1;
case 29: return casadi_s1;
case 30: return casadi_s0;
case 31: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_gear_position_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_gear_position_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 32;
if (sz_res) *sz_res = 8;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_gear_position_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 32*sizeof(const casadi_real*);
if (sz_res) *sz_res = 8*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* gear_position_envelope:(m,b,rho,Ap,CL_gamma,C_alpha,Ct)->(a_always,u_touch) */
static int casadi_f48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5, a6, a7, a8, a9;
a0=arg[1]? arg[1][0] : 0;
a1=arg[5]? arg[5][0] : 0;
a1=2.*a1;
a1=sqrt(a1);
a2=a0*a1;
a3=5.0000000000000000e-01;
a4=arg[3]? arg[3][0] : 0;
a3=a3*a4;
a4=arg[4]? arg[4][0] : 0;
a3=a3*a4;
a4=arg[2]? arg[2][0] : 0;
a3=a3*a4;
a3=sqrt(a3);
a2=a2*a3;
a4=arg[6]? arg[6][0] : 0;
a4=sqrt(a4);
a5=sqrt(a0);
a6=a4*a5;
a7=arg[0]? arg[0][0] : 0;
a7=sqrt(a7);
a6=a6*a7;
a2=a2+a6;
a6=2.*a2;
a8=a1*a7;
a9=-4.;
a9=a9*a2;
a2=a1*a3;
a9=a9*a2;
a2=casadi_sq(a8);
a9=a9+a2;
a9=sqrt(a9);
a8=a8+a9;
a6=a6/a8;
a6=casadi_sq(a6);
if (res[0]!=0) res[0][0]=a6;
a1=a1*a4;
a6=a6+a0;
a1=a1*a6;
a3=a3*a5;
a3=a3*a7;
a1=a1/a3;
a1=sqrt(a1);
if (res[1]!=0) res[1][0]=a1;
return 0;
}
CASADI_SYMBOL_EXPORT int gear_position_envelope(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f48(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int gear_position_envelope_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void gear_position_envelope_release(int mem) {
}
CASADI_SYMBOL_EXPORT void gear_position_envelope_incref(void) {
}
CASADI_SYMBOL_EXPORT void gear_position_envelope_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int gear_position_envelope_n_in(void) { return 7;}
CASADI_SYMBOL_EXPORT casadi_int gear_position_envelope_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real gear_position_envelope_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* gear_position_envelope_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "b";
case 2: return "rho";
case 3: return "Ap";
case 4: return "CL_gamma";
case 5: return "C_alpha";
case 6: return "Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* gear_position_envelope_name_out(casadi_int i) {
switch (i) {
case 0: return "a_always";
case 1: return "u_touch";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* gear_position_envelope_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* gear_position_envelope_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int gear_position_envelope_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 7;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int gear_position_envelope_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 7*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_gear_position_envelope:(m,b,rho,Ap,CL_gamma,C_alpha,Ct,out_a_always[1x1,0nz],out_u_touch[1x1,0nz],fwd_m,fwd_b,fwd_rho,fwd_Ap,fwd_CL_gamma,fwd_C_alpha,fwd_Ct)->(fwd_a_always,fwd_u_touch) */
static int casadi_f49(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24;
a00=arg[1]? arg[1][0] : 0;
a01=arg[5]? arg[5][0] : 0;
a01=2.*a01;
a01=sqrt(a01);
a02=a00*a01;
a03=5.0000000000000000e-01;
a04=arg[3]? arg[3][0] : 0;
a04=a03*a04;
a05=arg[4]? arg[4][0] : 0;
a06=a04*a05;
a07=arg[2]? arg[2][0] : 0;
a08=a06*a07;
a08=sqrt(a08);
a09=a02*a08;
a10=arg[6]? arg[6][0] : 0;
a10=sqrt(a10);
a11=sqrt(a00);
a12=a10*a11;
a13=arg[0]? arg[0][0] : 0;
a13=sqrt(a13);
a14=a12*a13;
a09=a09+a14;
a14=2.*a09;
a15=a01*a13;
a16=-4.;
a09=a16*a09;
a17=a01*a08;
a18=a09*a17;
a19=casadi_sq(a15);
a18=a18+a19;
a18=sqrt(a18);
a19=a15+a18;
a14=a14/a19;
a20=2.*a14;
a21=arg[10]? arg[10][0] : 0;
a22=a01*a21;
a23=arg[14]? arg[14][0] : 0;
a23=a23/a01;
a24=a00*a23;
a22=a22+a24;
a22=a08*a22;
a24=arg[12]? arg[12][0] : 0;
a03=a03*a24;
a05=a05*a03;
a03=arg[13]? arg[13][0] : 0;
a04=a04*a03;
a05=a05+a04;
a07=a07*a05;
a05=arg[11]? arg[11][0] : 0;
a06=a06*a05;
a07=a07+a06;
a06=2.*a08;
a07=a07/a06;
a02=a02*a07;
a22=a22+a02;
a02=arg[15]? arg[15][0] : 0;
a06=2.*a10;
a02=a02/a06;
a06=a11*a02;
a05=2.*a11;
a05=a21/a05;
a04=a10*a05;
a06=a06+a04;
a06=a13*a06;
a04=arg[9]? arg[9][0] : 0;
a03=2.*a13;
a04=a04/a03;
a12=a12*a04;
a06=a06+a12;
a22=a22+a06;
a06=2.*a22;
a06=a06/a19;
a19=a14/a19;
a12=a13*a23;
a03=a01*a04;
a12=a12+a03;
a16=a16*a22;
a17=a17*a16;
a16=a08*a23;
a22=a01*a07;
a16=a16+a22;
a09=a09*a16;
a17=a17+a09;
a15=2.*a15;
a15=a15*a12;
a17=a17+a15;
a18=2.*a18;
a17=a17/a18;
a12=a12+a17;
a19=a19*a12;
a06=a06-a19;
a20=a20*a06;
if (res[0]!=0) res[0][0]=a20;
a14=casadi_sq(a14);
a14=a14+a00;
a23=a10*a23;
a02=a01*a02;
a23=a23+a02;
a23=a14*a23;
a01=a01*a10;
a20=a20+a21;
a20=a01*a20;
a23=a23+a20;
a20=a08*a11;
a21=a20*a13;
a23=a23/a21;
a01=a01*a14;
a01=a01/a21;
a21=a01/a21;
a11=a11*a07;
a08=a08*a05;
a11=a11+a08;
a13=a13*a11;
a20=a20*a04;
a13=a13+a20;
a21=a21*a13;
a23=a23-a21;
a01=sqrt(a01);
a01=2.*a01;
a23=a23/a01;
if (res[1]!=0) res[1][0]=a23;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_gear_position_envelope(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f49(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_gear_position_envelope_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_gear_position_envelope_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_gear_position_envelope_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_gear_position_envelope_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_gear_position_envelope_n_in(void) { return 16;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_gear_position_envelope_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_gear_position_envelope_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_gear_position_envelope_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "b";
case 2: return "rho";
case 3: return "Ap";
case 4: return "CL_gamma";
case 5: return "C_alpha";
case 6: return "Ct";
case 7: return "out_a_always";
case 8: return "out_u_touch";
case 9: return "fwd_m";
case 10: return "fwd_b";
case 11: return "fwd_rho";
case 12: return "fwd_Ap";
case 13: return "fwd_CL_gamma";
case 14: return "fwd_C_alpha";
case 15: return "fwd_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_gear_position_envelope_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_a_always";
case 1: return "fwd_u_touch";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_gear_position_envelope_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s1;
case 8: return casadi_s1;
case 9: return casadi_s0;
case 10: return casadi_s0;
case 11: return casadi_s0;
case 12: return casadi_s0;
case 13: return casadi_s0;
case 14: return casadi_s0;
case 15: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_gear_position_envelope_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_gear_position_envelope_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 16;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_gear_position_envelope_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_gear_position_envelope:(m,b,rho,Ap,CL_gamma,C_alpha,Ct,out_a_always[1x1,0nz],out_u_touch[1x1,0nz],adj_a_always,adj_u_touch)->(adj_m,adj_b,adj_rho,adj_Ap,adj_CL_gamma,adj_C_alpha,adj_Ct) */
static int casadi_f50(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28;
a00=arg[6]? arg[6][0] : 0;
a00=sqrt(a00);
a01=arg[1]? arg[1][0] : 0;
a02=sqrt(a01);
a03=a00*a02;
a04=arg[5]? arg[5][0] : 0;
a04=2.*a04;
a04=sqrt(a04);
a05=a01*a04;
a06=5.0000000000000000e-01;
a07=arg[3]? arg[3][0] : 0;
a07=a06*a07;
a08=arg[4]? arg[4][0] : 0;
a09=a07*a08;
a10=arg[2]? arg[2][0] : 0;
a11=a09*a10;
a11=sqrt(a11);
a12=a05*a11;
a13=arg[0]? arg[0][0] : 0;
a13=sqrt(a13);
a14=a03*a13;
a12=a12+a14;
a14=2.*a12;
a15=a04*a13;
a16=-4.;
a12=a16*a12;
a17=a04*a11;
a18=a12*a17;
a19=casadi_sq(a15);
a18=a18+a19;
a18=sqrt(a18);
a19=a15+a18;
a14=a14/a19;
a20=2.*a14;
a21=a04*a00;
a22=arg[10]? arg[10][0] : 0;
a23=casadi_sq(a14);
a23=a23+a01;
a24=a21*a23;
a25=a11*a02;
a26=a25*a13;
a24=a24/a26;
a27=sqrt(a24);
a27=2.*a27;
a22=a22/a27;
a27=a22/a26;
a21=a21*a27;
a28=arg[9]? arg[9][0] : 0;
a28=a21+a28;
a20=a20*a28;
a28=a20/a19;
a28=2.*a28;
a14=a14/a19;
a14=a14*a20;
a18=2.*a18;
a18=a14/a18;
a17=a17*a18;
a16=a16*a17;
a28=a28-a16;
a03=a03*a28;
a24=a24/a26;
a24=a24*a22;
a25=a25*a24;
a15=2.*a15;
a15=a15*a18;
a14=a14+a15;
a15=a04*a14;
a25=a25+a15;
a03=a03-a25;
a25=2.*a13;
a03=a03/a25;
if (res[0]!=0) res[0][0]=a03;
a03=a13*a28;
a25=a00*a03;
a24=a13*a24;
a15=a11*a24;
a25=a25-a15;
a15=2.*a02;
a25=a25/a15;
a21=a21+a25;
a25=a11*a28;
a15=a04*a25;
a21=a21+a15;
if (res[1]!=0) res[1][0]=a21;
a05=a05*a28;
a24=a02*a24;
a12=a12*a18;
a18=a04*a12;
a24=a24+a18;
a05=a05-a24;
a24=2.*a11;
a05=a05/a24;
a09=a09*a05;
if (res[2]!=0) res[2][0]=a09;
a10=a10*a05;
a08=a08*a10;
a06=a06*a08;
if (res[3]!=0) res[3][0]=a06;
a07=a07*a10;
if (res[4]!=0) res[4][0]=a07;
a23=a23*a27;
a27=a00*a23;
a11=a11*a12;
a27=a27-a11;
a13=a13*a14;
a27=a27-a13;
a01=a01*a25;
a27=a27+a01;
a01=2.*a04;
a27=a27/a01;
a27=2.*a27;
if (res[5]!=0) res[5][0]=a27;
a04=a04*a23;
a02=a02*a03;
a04=a04+a02;
a00=2.*a00;
a04=a04/a00;
if (res[6]!=0) res[6][0]=a04;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_gear_position_envelope(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f50(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_gear_position_envelope_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_gear_position_envelope_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_gear_position_envelope_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_gear_position_envelope_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_gear_position_envelope_n_in(void) { return 11;}
CASADI_SYMBOL_EXPORT casadi_int adj1_gear_position_envelope_n_out(void) { return 7;}
CASADI_SYMBOL_EXPORT casadi_real adj1_gear_position_envelope_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_gear_position_envelope_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "b";
case 2: return "rho";
case 3: return "Ap";
case 4: return "CL_gamma";
case 5: return "C_alpha";
case 6: return "Ct";
case 7: return "out_a_always";
case 8: return "out_u_touch";
case 9: return "adj_a_always";
case 10: return "adj_u_touch";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_gear_position_envelope_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_m";
case 1: return "adj_b";
case 2: return "adj_rho";
case 3: return "adj_Ap";
case 4: return "adj_CL_gamma";
case 5: return "adj_C_alpha";
case 6: return "adj_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_gear_position_envelope_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s1;
case 8: return casadi_s1;
case 9: return casadi_s0;
case 10: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_gear_position_envelope_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_gear_position_envelope_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 11;
if (sz_res) *sz_res = 7;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_gear_position_envelope_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 11*sizeof(const casadi_real*);
if (sz_res) *sz_res = 7*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_gear_position_envelope:(m,b,rho,Ap,CL_gamma,C_alpha,Ct,out_a_always[1x1,0nz],out_u_touch[1x1,0nz],adj_a_always,adj_u_touch,out_adj_m[1x1,0nz],out_adj_b[1x1,0nz],out_adj_rho[1x1,0nz],out_adj_Ap[1x1,0nz],out_adj_CL_gamma[1x1,0nz],out_adj_C_alpha[1x1,0nz],out_adj_Ct[1x1,0nz],fwd_m,fwd_b,fwd_rho,fwd_Ap,fwd_CL_gamma,fwd_C_alpha,fwd_Ct,fwd_out_a_always[1x1,0nz],fwd_out_u_touch[1x1,0nz],fwd_adj_a_always,fwd_adj_u_touch)->(fwd_adj_m,fwd_adj_b,fwd_adj_rho,fwd_adj_Ap,fwd_adj_CL_gamma,fwd_adj_C_alpha,fwd_adj_Ct) */
static int casadi_f51(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
casadi_real a60, a61;
a00=arg[1]? arg[1][0] : 0;
a01=arg[5]? arg[5][0] : 0;
a01=2.*a01;
a01=sqrt(a01);
a02=a00*a01;
a03=5.0000000000000000e-01;
a04=arg[3]? arg[3][0] : 0;
a04=a03*a04;
a05=arg[4]? arg[4][0] : 0;
a06=a04*a05;
a07=arg[2]? arg[2][0] : 0;
a08=a06*a07;
a08=sqrt(a08);
a09=a02*a08;
a10=arg[6]? arg[6][0] : 0;
a10=sqrt(a10);
a11=sqrt(a00);
a12=a10*a11;
a13=arg[0]? arg[0][0] : 0;
a13=sqrt(a13);
a14=a12*a13;
a09=a09+a14;
a14=2.*a09;
a15=a01*a13;
a16=-4.;
a09=a16*a09;
a17=a01*a08;
a18=a09*a17;
a19=casadi_sq(a15);
a18=a18+a19;
a18=sqrt(a18);
a19=a15+a18;
a14=a14/a19;
a20=2.*a14;
a21=a01*a10;
a22=arg[10]? arg[10][0] : 0;
a23=casadi_sq(a14);
a23=a23+a00;
a24=a21*a23;
a25=a08*a11;
a26=a25*a13;
a24=a24/a26;
a27=sqrt(a24);
a28=2.*a27;
a22=a22/a28;
a29=a22/a26;
a30=a21*a29;
a31=arg[9]? arg[9][0] : 0;
a30=a30+a31;
a31=a20*a30;
a32=a31/a19;
a33=2.*a32;
a34=a14/a19;
a35=a34*a31;
a36=2.*a18;
a37=a35/a36;
a38=a17*a37;
a38=a16*a38;
a33=a33-a38;
a38=arg[24]? arg[24][0] : 0;
a39=2.*a10;
a38=a38/a39;
a39=a11*a38;
a40=arg[19]? arg[19][0] : 0;
a41=2.*a11;
a41=a40/a41;
a42=a10*a41;
a39=a39+a42;
a42=a33*a39;
a43=a01*a40;
a44=arg[23]? arg[23][0] : 0;
a44=a44/a01;
a45=a00*a44;
a43=a43+a45;
a45=a08*a43;
a46=arg[21]? arg[21][0] : 0;
a46=a03*a46;
a47=a05*a46;
a48=arg[22]? arg[22][0] : 0;
a49=a04*a48;
a47=a47+a49;
a49=a07*a47;
a50=arg[20]? arg[20][0] : 0;
a51=a06*a50;
a49=a49+a51;
a51=2.*a08;
a49=a49/a51;
a51=a02*a49;
a45=a45+a51;
a39=a13*a39;
a51=arg[18]? arg[18][0] : 0;
a52=2.*a13;
a51=a51/a52;
a52=a12*a51;
a39=a39+a52;
a45=a45+a39;
a39=2.*a45;
a39=a39/a19;
a52=a14/a19;
a53=a13*a44;
a54=a01*a51;
a53=a53+a54;
a45=a16*a45;
a54=a17*a45;
a55=a08*a44;
a56=a01*a49;
a55=a55+a56;
a56=a09*a55;
a54=a54+a56;
a56=2.*a15;
a56=a56*a53;
a54=a54+a56;
a18=2.*a18;
a54=a54/a18;
a18=a53+a54;
a52=a52*a18;
a39=a39-a52;
a52=2.*a39;
a30=a30*a52;
a52=a10*a44;
a56=a01*a38;
a52=a52+a56;
a56=a29*a52;
a57=arg[28]? arg[28][0] : 0;
a57=a57/a28;
a28=a22/a28;
a52=a23*a52;
a14=2.*a14;
a14=a14*a39;
a14=a14+a40;
a58=a21*a14;
a52=a52+a58;
a52=a52/a26;
a58=a24/a26;
a59=a11*a49;
a60=a08*a41;
a59=a59+a60;
a60=a13*a59;
a61=a25*a51;
a60=a60+a61;
a58=a58*a60;
a52=a52-a58;
a27=2.*a27;
a27=a52/a27;
a27=2.*a27;
a28=a28*a27;
a57=a57-a28;
a28=a57/a26;
a27=a29/a26;
a27=a27*a60;
a28=a28-a27;
a21=a21*a28;
a56=a56+a21;
a21=arg[27]? arg[27][0] : 0;
a21=a56+a21;
a20=a20*a21;
a30=a30+a20;
a20=a30/a19;
a32=a32/a19;
a32=a32*a18;
a20=a20-a32;
a20=2.*a20;
a55=a37*a55;
a39=a39/a19;
a19=a34/a19;
a19=a19*a18;
a39=a39-a19;
a31=a31*a39;
a34=a34*a30;
a31=a31+a34;
a34=a31/a36;
a36=a37/a36;
a54=2.*a54;
a36=a36*a54;
a34=a34-a36;
a17=a17*a34;
a55=a55+a17;
a16=a16*a55;
a20=a20-a16;
a16=a12*a20;
a42=a42+a16;
a24=a24/a26;
a16=a24*a22;
a59=a16*a59;
a52=a52/a26;
a26=a24/a26;
a26=a26*a60;
a52=a52-a26;
a22=a22*a52;
a24=a24*a57;
a22=a22+a24;
a24=a25*a22;
a59=a59+a24;
a15=2.*a15;
a24=a15*a37;
a35=a35+a24;
a24=a35*a44;
a53=2.*a53;
a53=a37*a53;
a15=a15*a34;
a53=a53+a15;
a31=a31+a53;
a53=a01*a31;
a24=a24+a53;
a59=a59+a24;
a42=a42-a59;
a59=2.*a13;
a42=a42/a59;
a12=a12*a33;
a25=a25*a16;
a24=a01*a35;
a25=a25+a24;
a12=a12-a25;
a12=a12/a59;
a12=a12/a59;
a59=2.*a51;
a12=a12*a59;
a42=a42-a12;
if (res[0]!=0) res[0][0]=a42;
a42=a13*a33;
a12=a42*a38;
a59=a33*a51;
a25=a13*a20;
a59=a59+a25;
a25=a10*a59;
a12=a12+a25;
a25=a13*a16;
a24=a25*a49;
a16=a16*a51;
a22=a13*a22;
a16=a16+a22;
a22=a08*a16;
a24=a24+a22;
a12=a12-a24;
a24=2.*a11;
a12=a12/a24;
a22=a10*a42;
a53=a08*a25;
a22=a22-a53;
a22=a22/a24;
a22=a22/a24;
a24=2.*a41;
a22=a22*a24;
a12=a12-a22;
a56=a56+a12;
a12=a08*a33;
a22=a12*a44;
a24=a33*a49;
a53=a08*a20;
a24=a24+a53;
a53=a01*a24;
a22=a22+a53;
a56=a56+a22;
if (res[1]!=0) res[1][0]=a56;
a56=a02*a33;
a22=a11*a25;
a53=a09*a37;
a15=a01*a53;
a22=a22+a15;
a56=a56-a22;
a22=2.*a08;
a56=a56/a22;
a47=a56*a47;
a33=a33*a43;
a02=a02*a20;
a33=a33+a02;
a25=a25*a41;
a16=a11*a16;
a25=a25+a16;
a16=a53*a44;
a37=a37*a45;
a09=a09*a34;
a37=a37+a09;
a09=a01*a37;
a16=a16+a09;
a25=a25+a16;
a33=a33-a25;
a33=a33/a22;
a22=a56/a22;
a25=2.*a49;
a22=a22*a25;
a33=a33-a22;
a06=a06*a33;
a47=a47+a06;
if (res[2]!=0) res[2][0]=a47;
a47=a07*a56;
a48=a47*a48;
a56=a56*a50;
a07=a07*a33;
a56=a56+a07;
a05=a05*a56;
a48=a48+a05;
a03=a03*a48;
if (res[3]!=0) res[3][0]=a03;
a47=a47*a46;
a04=a04*a56;
a47=a47+a04;
if (res[4]!=0) res[4][0]=a47;
a47=a23*a29;
a04=a47*a38;
a29=a29*a14;
a23=a23*a28;
a29=a29+a23;
a23=a10*a29;
a04=a04+a23;
a49=a53*a49;
a37=a08*a37;
a49=a49+a37;
a04=a04-a49;
a51=a35*a51;
a31=a13*a31;
a51=a51+a31;
a04=a04-a51;
a40=a12*a40;
a24=a00*a24;
a40=a40+a24;
a04=a04+a40;
a40=2.*a01;
a04=a04/a40;
a24=a10*a47;
a08=a08*a53;
a24=a24-a08;
a13=a13*a35;
a24=a24-a13;
a00=a00*a12;
a24=a24+a00;
a24=a24/a40;
a24=a24/a40;
a40=2.*a44;
a24=a24*a40;
a04=a04-a24;
a04=2.*a04;
if (res[5]!=0) res[5][0]=a04;
a44=a47*a44;
a29=a01*a29;
a44=a44+a29;
a41=a42*a41;
a59=a11*a59;
a41=a41+a59;
a44=a44+a41;
a10=2.*a10;
a44=a44/a10;
a01=a01*a47;
a11=a11*a42;
a01=a01+a11;
a01=a01/a10;
a01=a01/a10;
a38=2.*a38;
a01=a01*a38;
a44=a44-a01;
if (res[6]!=0) res[6][0]=a44;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_gear_position_envelope(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f51(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_gear_position_envelope_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_gear_position_envelope_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_gear_position_envelope_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_gear_position_envelope_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_gear_position_envelope_n_in(void) { return 29;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_gear_position_envelope_n_out(void) { return 7;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_gear_position_envelope_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_gear_position_envelope_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "b";
case 2: return "rho";
case 3: return "Ap";
case 4: return "CL_gamma";
case 5: return "C_alpha";
case 6: return "Ct";
case 7: return "out_a_always";
case 8: return "out_u_touch";
case 9: return "adj_a_always";
case 10: return "adj_u_touch";
case 11: return "out_adj_m";
case 12: return "out_adj_b";
case 13: return "out_adj_rho";
case 14: return "out_adj_Ap";
case 15: return "out_adj_CL_gamma";
case 16: return "out_adj_C_alpha";
case 17: return "out_adj_Ct";
case 18: return "fwd_m";
case 19: return "fwd_b";
case 20: return "fwd_rho";
case 21: return "fwd_Ap";
case 22: return "fwd_CL_gamma";
case 23: return "fwd_C_alpha";
case 24: return "fwd_Ct";
case 25: return "fwd_out_a_always";
case 26: return "fwd_out_u_touch";
case 27: return "fwd_adj_a_always";
case 28: return "fwd_adj_u_touch";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_gear_position_envelope_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_m";
case 1: return "fwd_adj_b";
case 2: return "fwd_adj_rho";
case 3: return "fwd_adj_Ap";
case 4: return "fwd_adj_CL_gamma";
case 5: return "fwd_adj_C_alpha";
case 6: return "fwd_adj_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_gear_position_envelope_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s1;
case 8: return casadi_s1;
case 9: return casadi_s0;
case 10: return casadi_s0;
case 11: return casadi_s1;
case 12: return casadi_s1;
case 13: return casadi_s1;
case 14: return casadi_s1;
case 15: return casadi_s1;
case 16: return casadi_s1;
case 17: return casadi_s1;
case 18: return casadi_s0;
case 19: return casadi_s0;
case 20: return casadi_s0;
case 21: return casadi_s0;
case 22: return casadi_s0;
case 23: return casadi_s0;
case 24: return casadi_s0;
case 25: return casadi_s1;
case 26: return casadi_s1;
case 27: return casadi_s0;
case 28: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_gear_position_envelope_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_gear_position_envelope_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 29;
if (sz_res) *sz_res = 7;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_gear_position_envelope_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 29*sizeof(const casadi_real*);
if (sz_res) *sz_res = 7*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* loaded_gear_position:(m,b,u,rho,Ap,CL_gamma,B3,C3,g,K1,K2,K3,K4)->(p_0,p_1,p_2,p_3,p_4,p_5) */
static int casadi_f52(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13;
a00=arg[1]? arg[1][0] : 0;
a01=arg[8]? arg[8][0] : 0;
a02=a00*a01;
a03=5.0000000000000000e-01;
a04=arg[4]? arg[4][0] : 0;
a03=a03*a04;
a04=arg[5]? arg[5][0] : 0;
a03=a03*a04;
a04=arg[3]? arg[3][0] : 0;
a03=a03*a04;
a02=a02*a03;
a04=arg[6]? arg[6][0] : 0;
a05=2.*a04;
a06=arg[7]? arg[7][0] : 0;
a07=a06*a01;
a08=arg[0]? arg[0][0] : 0;
a07=a07*a08;
a05=a05+a07;
a02=a02*a05;
a09=arg[2]? arg[2][0] : 0;
a10=casadi_sq(a09);
a02=a02*a10;
a10=2.*a03;
a11=casadi_sq(a09);
a11=casadi_sq(a11);
a10=a10*a11;
a02=a02+a10;
if (res[0]!=0) res[0][0]=a02;
a02=arg[9]? arg[9][0] : 0;
a10=a02*a00;
a11=casadi_sq(a01);
a10=a10*a11;
a10=a10*a08;
a10=a10*a05;
a11=a01*a08;
a12=a06*a00;
a12=a12*a01;
a12=a12*a03;
a13=2.*a02;
a12=a12-a13;
a12=a12+a05;
a11=a11*a12;
a12=casadi_sq(a09);
a11=a11*a12;
a10=a10-a11;
a11=-2.;
a03=a11*a03;
a12=casadi_sq(a09);
a12=casadi_sq(a12);
a03=a03*a12;
a10=a10+a03;
if (res[1]!=0) res[1][0]=a10;
a10=casadi_sq(a01);
a10=a01*a10;
a10=a00*a10;
a03=casadi_sq(a08);
a10=a10*a03;
a03=2.*a04;
a12=arg[10]? arg[10][0] : 0;
a03=a03*a12;
a05=a06*a02;
a03=a03-a05;
a05=a06*a12;
a05=a05*a01;
a05=a05*a08;
a03=a03+a05;
a10=a10*a03;
a03=2.*a01;
a03=a03*a08;
a02=a04-a02;
a05=a12*a01;
a05=a05*a08;
a02=a02+a05;
a02=a02+a07;
a03=a03*a02;
a02=casadi_sq(a09);
a03=a03*a02;
a10=a10+a03;
if (res[2]!=0) res[2][0]=a10;
a10=casadi_sq(a01);
a10=casadi_sq(a10);
a10=a00*a10;
a03=casadi_sq(a08);
a03=a08*a03;
a10=a10*a03;
a03=2.*a04;
a02=arg[11]? arg[11][0] : 0;
a03=a03*a02;
a05=a06*a12;
a03=a03-a05;
a05=a06*a02;
a05=a05*a01;
a05=a05*a08;
a03=a03+a05;
a10=a10*a03;
a03=casadi_sq(a01);
a05=casadi_sq(a08);
a03=a03*a05;
a05=2.*a02;
a05=a05*a01;
a05=a05*a08;
a12=2.*a12;
a12=a06+a12;
a05=a05-a12;
a03=a03*a05;
a05=casadi_sq(a09);
a03=a03*a05;
a10=a10+a03;
if (res[3]!=0) res[3][0]=a10;
a10=casadi_sq(a01);
a10=casadi_sq(a10);
a10=a01*a10;
a10=a00*a10;
a03=casadi_sq(a08);
a03=casadi_sq(a03);
a10=a10*a03;
a04=2.*a04;
a03=arg[12]? arg[12][0] : 0;
a04=a04*a03;
a05=a06*a02;
a04=a04-a05;
a07=a03*a07;
a04=a04+a07;
a10=a10*a04;
a04=casadi_sq(a01);
a04=a01*a04;
a04=2.*a04;
a07=casadi_sq(a08);
a07=a08*a07;
a04=a04*a07;
a07=a03*a01;
a07=a07*a08;
a07=a07-a02;
a04=a04*a07;
a07=casadi_sq(a09);
a04=a04*a07;
a10=a10+a04;
if (res[4]!=0) res[4][0]=a10;
a11=a11*a03;
a10=casadi_sq(a01);
a10=casadi_sq(a10);
a11=a11*a10;
a10=casadi_sq(a08);
a10=casadi_sq(a10);
a11=a11*a10;
a09=casadi_sq(a09);
a11=a11*a09;
a06=a06*a03;
a06=a06*a00;
a00=casadi_sq(a01);
a01=a01*a00;
a01=casadi_sq(a01);
a06=a06*a01;
a01=casadi_sq(a08);
a01=casadi_sq(a01);
a08=a08*a01;
a06=a06*a08;
a11=a11-a06;
if (res[5]!=0) res[5][0]=a11;
return 0;
}
CASADI_SYMBOL_EXPORT int loaded_gear_position(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f52(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int loaded_gear_position_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void loaded_gear_position_release(int mem) {
}
CASADI_SYMBOL_EXPORT void loaded_gear_position_incref(void) {
}
CASADI_SYMBOL_EXPORT void loaded_gear_position_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int loaded_gear_position_n_in(void) { return 13;}
CASADI_SYMBOL_EXPORT casadi_int loaded_gear_position_n_out(void) { return 6;}
CASADI_SYMBOL_EXPORT casadi_real loaded_gear_position_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* loaded_gear_position_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "b";
case 2: return "u";
case 3: return "rho";
case 4: return "Ap";
case 5: return "CL_gamma";
case 6: return "B3";
case 7: return "C3";
case 8: return "g";
case 9: return "K1";
case 10: return "K2";
case 11: return "K3";
case 12: return "K4";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* loaded_gear_position_name_out(casadi_int i) {
switch (i) {
case 0: return "p_0";
case 1: return "p_1";
case 2: return "p_2";
case 3: return "p_3";
case 4: return "p_4";
case 5: return "p_5";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* loaded_gear_position_sparsity_in(casadi_int i) {
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
case 11: return casadi_s0;
case 12: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* loaded_gear_position_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int loaded_gear_position_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 13;
if (sz_res) *sz_res = 6;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int loaded_gear_position_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 13*sizeof(const casadi_real*);
if (sz_res) *sz_res = 6*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_loaded_gear_position:(m,b,u,rho,Ap,CL_gamma,B3,C3,g,K1,K2,K3,K4,out_p_0[1x1,0nz],out_p_1[1x1,0nz],out_p_2[1x1,0nz],out_p_3[1x1,0nz],out_p_4[1x1,0nz],out_p_5[1x1,0nz],fwd_m,fwd_b,fwd_u,fwd_rho,fwd_Ap,fwd_CL_gamma,fwd_B3,fwd_C3,fwd_g,fwd_K1,fwd_K2,fwd_K3,fwd_K4)->(fwd_p_0,fwd_p_1,fwd_p_2,fwd_p_3,fwd_p_4,fwd_p_5) */
static int casadi_f53(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27;
a00=arg[2]? arg[2][0] : 0;
a01=casadi_sq(a00);
a02=arg[6]? arg[6][0] : 0;
a03=2.*a02;
a04=arg[7]? arg[7][0] : 0;
a05=arg[8]? arg[8][0] : 0;
a06=a04*a05;
a07=arg[0]? arg[0][0] : 0;
a08=a06*a07;
a03=a03+a08;
a09=5.0000000000000000e-01;
a10=arg[4]? arg[4][0] : 0;
a10=a09*a10;
a11=arg[5]? arg[5][0] : 0;
a12=a10*a11;
a13=arg[3]? arg[3][0] : 0;
a14=a12*a13;
a15=arg[20]? arg[20][0] : 0;
a16=a05*a15;
a17=arg[1]? arg[1][0] : 0;
a18=arg[27]? arg[27][0] : 0;
a19=a17*a18;
a16=a16+a19;
a16=a14*a16;
a19=a17*a05;
a20=arg[23]? arg[23][0] : 0;
a09=a09*a20;
a11=a11*a09;
a09=arg[24]? arg[24][0] : 0;
a10=a10*a09;
a11=a11+a10;
a13=a13*a11;
a11=arg[22]? arg[22][0] : 0;
a12=a12*a11;
a13=a13+a12;
a12=a19*a13;
a16=a16+a12;
a16=a03*a16;
a19=a19*a14;
a12=arg[25]? arg[25][0] : 0;
a11=2.*a12;
a10=arg[26]? arg[26][0] : 0;
a09=a05*a10;
a20=a04*a18;
a09=a09+a20;
a09=a07*a09;
a20=arg[19]? arg[19][0] : 0;
a06=a06*a20;
a09=a09+a06;
a11=a11+a09;
a06=a19*a11;
a16=a16+a06;
a01=a01*a16;
a19=a19*a03;
a16=2.*a00;
a06=arg[21]? arg[21][0] : 0;
a16=a16*a06;
a19=a19*a16;
a01=a01+a19;
a19=casadi_sq(a00);
a16=casadi_sq(a19);
a21=2.*a13;
a16=a16*a21;
a21=2.*a14;
a19=2.*a19;
a22=2.*a00;
a22=a22*a06;
a19=a19*a22;
a21=a21*a19;
a16=a16+a21;
a01=a01+a16;
if (res[0]!=0) res[0][0]=a01;
a01=casadi_sq(a05);
a16=arg[28]? arg[28][0] : 0;
a21=a17*a16;
a19=arg[9]? arg[9][0] : 0;
a22=a19*a15;
a21=a21+a22;
a21=a01*a21;
a22=a19*a17;
a23=2.*a05;
a23=a23*a18;
a23=a22*a23;
a21=a21+a23;
a21=a07*a21;
a22=a22*a01;
a01=a22*a20;
a21=a21+a01;
a21=a03*a21;
a22=a22*a07;
a22=a22*a11;
a21=a21+a22;
a22=casadi_sq(a00);
a01=a04*a17;
a23=a01*a05;
a24=a23*a14;
a25=2.*a19;
a24=a24-a25;
a24=a24+a03;
a03=a07*a18;
a25=a05*a20;
a03=a03+a25;
a03=a24*a03;
a25=a05*a07;
a26=a17*a10;
a27=a04*a15;
a26=a26+a27;
a26=a05*a26;
a01=a01*a18;
a26=a26+a01;
a26=a14*a26;
a23=a23*a13;
a26=a26+a23;
a23=2.*a16;
a26=a26-a23;
a26=a26+a11;
a26=a25*a26;
a03=a03+a26;
a22=a22*a03;
a25=a25*a24;
a24=2.*a00;
a24=a24*a06;
a25=a25*a24;
a22=a22+a25;
a21=a21-a22;
a22=casadi_sq(a00);
a25=casadi_sq(a22);
a24=-2.;
a13=a24*a13;
a25=a25*a13;
a14=a24*a14;
a22=2.*a22;
a13=2.*a00;
a13=a13*a06;
a22=a22*a13;
a14=a14*a22;
a25=a25+a14;
a21=a21+a25;
if (res[1]!=0) res[1][0]=a21;
a21=2.*a02;
a25=arg[10]? arg[10][0] : 0;
a14=a21*a25;
a22=a04*a19;
a14=a14-a22;
a22=a04*a25;
a13=a22*a05;
a03=a13*a07;
a14=a14+a03;
a03=casadi_sq(a07);
a26=casadi_sq(a05);
a11=a05*a26;
a23=a11*a15;
a26=a26*a18;
a01=2.*a05;
a01=a01*a18;
a01=a05*a01;
a26=a26+a01;
a26=a17*a26;
a23=a23+a26;
a23=a03*a23;
a11=a17*a11;
a26=2.*a07;
a26=a26*a20;
a26=a11*a26;
a23=a23+a26;
a14=a14*a23;
a11=a11*a03;
a03=2.*a12;
a03=a25*a03;
a23=arg[29]? arg[29][0] : 0;
a21=a21*a23;
a03=a03+a21;
a21=a19*a10;
a26=a04*a16;
a21=a21+a26;
a03=a03-a21;
a21=a25*a10;
a26=a04*a23;
a21=a21+a26;
a21=a05*a21;
a22=a22*a18;
a21=a21+a22;
a21=a07*a21;
a13=a13*a20;
a21=a21+a13;
a03=a03+a21;
a11=a11*a03;
a14=a14+a11;
a11=casadi_sq(a00);
a19=a02-a19;
a03=a25*a05;
a21=a03*a07;
a19=a19+a21;
a19=a19+a08;
a21=2.*a18;
a21=a07*a21;
a13=2.*a05;
a22=a13*a20;
a21=a21+a22;
a21=a19*a21;
a13=a13*a07;
a16=a12-a16;
a22=a05*a23;
a26=a25*a18;
a22=a22+a26;
a22=a07*a22;
a03=a03*a20;
a22=a22+a03;
a16=a16+a22;
a16=a16+a09;
a16=a13*a16;
a21=a21+a16;
a11=a11*a21;
a13=a13*a19;
a19=2.*a00;
a19=a19*a06;
a13=a13*a19;
a11=a11+a13;
a14=a14+a11;
if (res[2]!=0) res[2][0]=a14;
a14=2.*a02;
a11=arg[11]? arg[11][0] : 0;
a13=a14*a11;
a19=a04*a25;
a13=a13-a19;
a19=a04*a11;
a21=a19*a05;
a16=a21*a07;
a13=a13+a16;
a16=casadi_sq(a07);
a22=a07*a16;
a03=casadi_sq(a05);
a26=casadi_sq(a03);
a01=a26*a15;
a03=2.*a03;
a27=2.*a05;
a27=a27*a18;
a03=a03*a27;
a03=a17*a03;
a01=a01+a03;
a01=a22*a01;
a26=a17*a26;
a16=a16*a20;
a03=2.*a07;
a03=a03*a20;
a03=a07*a03;
a16=a16+a03;
a16=a26*a16;
a01=a01+a16;
a13=a13*a01;
a26=a26*a22;
a22=2.*a12;
a22=a11*a22;
a01=arg[30]? arg[30][0] : 0;
a14=a14*a01;
a22=a22+a14;
a14=a25*a10;
a16=a04*a23;
a14=a14+a16;
a22=a22-a14;
a14=a11*a10;
a16=a04*a01;
a14=a14+a16;
a14=a05*a14;
a19=a19*a18;
a14=a14+a19;
a14=a07*a14;
a21=a21*a20;
a14=a14+a21;
a22=a22+a14;
a26=a26*a22;
a13=a13+a26;
a26=casadi_sq(a00);
a22=2.*a11;
a14=a22*a05;
a21=a14*a07;
a25=2.*a25;
a25=a04+a25;
a21=a21-a25;
a25=casadi_sq(a07);
a19=2.*a05;
a19=a19*a18;
a19=a25*a19;
a16=casadi_sq(a05);
a03=2.*a07;
a03=a03*a20;
a03=a16*a03;
a19=a19+a03;
a19=a21*a19;
a16=a16*a25;
a25=2.*a01;
a25=a05*a25;
a22=a22*a18;
a25=a25+a22;
a25=a07*a25;
a14=a14*a20;
a25=a25+a14;
a23=2.*a23;
a23=a10+a23;
a25=a25-a23;
a25=a16*a25;
a19=a19+a25;
a26=a26*a19;
a16=a16*a21;
a21=2.*a00;
a21=a21*a06;
a16=a16*a21;
a26=a26+a16;
a13=a13+a26;
if (res[3]!=0) res[3][0]=a13;
a02=2.*a02;
a13=arg[12]? arg[12][0] : 0;
a26=a02*a13;
a16=a04*a11;
a26=a26-a16;
a16=a13*a08;
a26=a26+a16;
a16=casadi_sq(a07);
a21=casadi_sq(a16);
a19=casadi_sq(a05);
a25=casadi_sq(a19);
a23=a05*a25;
a14=a23*a15;
a25=a25*a18;
a19=2.*a19;
a22=2.*a05;
a22=a22*a18;
a19=a19*a22;
a19=a05*a19;
a25=a25+a19;
a25=a17*a25;
a14=a14+a25;
a14=a21*a14;
a23=a17*a23;
a16=2.*a16;
a25=2.*a07;
a25=a25*a20;
a16=a16*a25;
a16=a23*a16;
a14=a14+a16;
a26=a26*a14;
a23=a23*a21;
a12=2.*a12;
a12=a13*a12;
a21=arg[31]? arg[31][0] : 0;
a02=a02*a21;
a12=a12+a02;
a02=a11*a10;
a14=a04*a01;
a02=a02+a14;
a12=a12-a02;
a08=a08*a21;
a09=a13*a09;
a08=a08+a09;
a12=a12+a08;
a23=a23*a12;
a26=a26+a23;
a23=casadi_sq(a00);
a12=a13*a05;
a08=a12*a07;
a08=a08-a11;
a11=casadi_sq(a07);
a09=a07*a11;
a02=casadi_sq(a05);
a14=a02*a18;
a16=2.*a05;
a16=a16*a18;
a16=a05*a16;
a14=a14+a16;
a14=2.*a14;
a14=a09*a14;
a02=a05*a02;
a02=2.*a02;
a11=a11*a20;
a16=2.*a07;
a16=a16*a20;
a16=a07*a16;
a11=a11+a16;
a11=a02*a11;
a14=a14+a11;
a14=a08*a14;
a02=a02*a09;
a09=a05*a21;
a11=a13*a18;
a09=a09+a11;
a09=a07*a09;
a12=a12*a20;
a09=a09+a12;
a09=a09-a01;
a09=a02*a09;
a14=a14+a09;
a23=a23*a14;
a02=a02*a08;
a08=2.*a00;
a08=a08*a06;
a02=a02*a08;
a23=a23+a02;
a26=a26+a23;
if (res[4]!=0) res[4][0]=a26;
a26=casadi_sq(a00);
a23=casadi_sq(a07);
a02=casadi_sq(a23);
a08=casadi_sq(a05);
a14=casadi_sq(a08);
a09=a24*a21;
a09=a14*a09;
a24=a24*a13;
a08=2.*a08;
a01=2.*a05;
a01=a01*a18;
a08=a08*a01;
a08=a24*a08;
a09=a09+a08;
a09=a02*a09;
a24=a24*a14;
a23=2.*a23;
a14=2.*a07;
a14=a14*a20;
a23=a23*a14;
a23=a24*a23;
a09=a09+a23;
a26=a26*a09;
a24=a24*a02;
a00=2.*a00;
a00=a00*a06;
a24=a24*a00;
a26=a26+a24;
a24=casadi_sq(a07);
a00=casadi_sq(a24);
a06=a07*a00;
a02=casadi_sq(a05);
a09=a05*a02;
a23=casadi_sq(a09);
a10=a13*a10;
a21=a04*a21;
a10=a10+a21;
a10=a17*a10;
a04=a04*a13;
a15=a04*a15;
a10=a10+a15;
a10=a23*a10;
a04=a04*a17;
a09=2.*a09;
a02=a02*a18;
a17=2.*a05;
a17=a17*a18;
a05=a05*a17;
a02=a02+a05;
a09=a09*a02;
a09=a04*a09;
a10=a10+a09;
a06=a06*a10;
a04=a04*a23;
a00=a00*a20;
a24=2.*a24;
a23=2.*a07;
a23=a23*a20;
a24=a24*a23;
a07=a07*a24;
a00=a00+a07;
a04=a04*a00;
a06=a06+a04;
a26=a26-a06;
if (res[5]!=0) res[5][0]=a26;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_loaded_gear_position(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f53(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_loaded_gear_position_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_loaded_gear_position_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_loaded_gear_position_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_loaded_gear_position_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_loaded_gear_position_n_in(void) { return 32;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_loaded_gear_position_n_out(void) { return 6;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_loaded_gear_position_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_loaded_gear_position_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "b";
case 2: return "u";
case 3: return "rho";
case 4: return "Ap";
case 5: return "CL_gamma";
case 6: return "B3";
case 7: return "C3";
case 8: return "g";
case 9: return "K1";
case 10: return "K2";
case 11: return "K3";
case 12: return "K4";
case 13: return "out_p_0";
case 14: return "out_p_1";
case 15: return "out_p_2";
case 16: return "out_p_3";
case 17: return "out_p_4";
case 18: return "out_p_5";
case 19: return "fwd_m";
case 20: return "fwd_b";
case 21: return "fwd_u";
case 22: return "fwd_rho";
case 23: return "fwd_Ap";
case 24: return "fwd_CL_gamma";
case 25: return "fwd_B3";
case 26: return "fwd_C3";
case 27: return "fwd_g";
case 28: return "fwd_K1";
case 29: return "fwd_K2";
case 30: return "fwd_K3";
case 31: return "fwd_K4";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_loaded_gear_position_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_p_0";
case 1: return "fwd_p_1";
case 2: return "fwd_p_2";
case 3: return "fwd_p_3";
case 4: return "fwd_p_4";
case 5: return "fwd_p_5";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_loaded_gear_position_sparsity_in(casadi_int i) {
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
case 11: return casadi_s0;
case 12: return casadi_s0;
case 13: return casadi_s1;
case 14: return casadi_s1;
case 15: return casadi_s1;
case 16: return casadi_s1;
case 17: return casadi_s1;
case 18: return casadi_s1;
case 19: return casadi_s0;
case 20: return casadi_s0;
case 21: return casadi_s0;
case 22: return casadi_s0;
case 23: return casadi_s0;
case 24: return casadi_s0;
case 25: return casadi_s0;
case 26: return casadi_s0;
case 27: return casadi_s0;
case 28: return casadi_s0;
case 29: return casadi_s0;
case 30: return casadi_s0;
case 31: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_loaded_gear_position_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_loaded_gear_position_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 32;
if (sz_res) *sz_res = 6;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_loaded_gear_position_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 32*sizeof(const casadi_real*);
if (sz_res) *sz_res = 6*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_loaded_gear_position:(m,b,u,rho,Ap,CL_gamma,B3,C3,g,K1,K2,K3,K4,out_p_0[1x1,0nz],out_p_1[1x1,0nz],out_p_2[1x1,0nz],out_p_3[1x1,0nz],out_p_4[1x1,0nz],out_p_5[1x1,0nz],adj_p_0,adj_p_1,adj_p_2,adj_p_3,adj_p_4,adj_p_5)->(adj_m,adj_b,adj_u,adj_rho,adj_Ap,adj_CL_gamma,adj_B3,adj_C3,adj_g,adj_K1,adj_K2,adj_K3,adj_K4) */
static int casadi_f54(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
casadi_real a72, a73, a74, a75, a76, a77, a78, a79, a80, a81, a82, a83;
casadi_real a84, a85, a86, a87, a88, a89;
a00=arg[0]? arg[0][0] : 0;
a01=2.*a00;
a02=casadi_sq(a00);
a03=2.*a02;
a04=-2.;
a05=arg[12]? arg[12][0] : 0;
a06=a04*a05;
a07=arg[8]? arg[8][0] : 0;
a08=casadi_sq(a07);
a09=casadi_sq(a08);
a10=a06*a09;
a11=arg[2]? arg[2][0] : 0;
a12=casadi_sq(a11);
a13=arg[24]? arg[24][0] : 0;
a12=a12*a13;
a14=a10*a12;
a03=a03*a14;
a01=a01*a03;
a03=casadi_sq(a00);
a14=casadi_sq(a03);
a15=arg[7]? arg[7][0] : 0;
a16=a15*a05;
a17=arg[1]? arg[1][0] : 0;
a18=a16*a17;
a19=casadi_sq(a07);
a20=a07*a19;
a21=casadi_sq(a20);
a22=a18*a21;
a22=a22*a13;
a23=a14*a22;
a24=2.*a00;
a03=2.*a03;
a22=a00*a22;
a03=a03*a22;
a24=a24*a03;
a23=a23+a24;
a01=a01-a23;
a23=a05*a07;
a24=casadi_sq(a07);
a03=a07*a24;
a03=2.*a03;
a22=casadi_sq(a00);
a25=a00*a22;
a26=a03*a25;
a27=casadi_sq(a11);
a28=arg[23]? arg[23][0] : 0;
a27=a27*a28;
a29=a26*a27;
a30=a23*a29;
a01=a01+a30;
a23=a23*a00;
a30=arg[11]? arg[11][0] : 0;
a23=a23-a30;
a27=a23*a27;
a03=a03*a27;
a22=a22*a03;
a01=a01+a22;
a22=2.*a00;
a03=a00*a03;
a22=a22*a03;
a01=a01+a22;
a22=2.*a00;
a03=casadi_sq(a00);
a31=2.*a03;
a32=casadi_sq(a07);
a33=casadi_sq(a32);
a34=a07*a33;
a35=a17*a34;
a36=arg[6]? arg[6][0] : 0;
a37=2.*a36;
a38=a37*a05;
a39=a15*a30;
a38=a38-a39;
a39=a15*a07;
a40=a39*a00;
a41=a05*a40;
a38=a38+a41;
a38=a38*a28;
a41=a35*a38;
a31=a31*a41;
a22=a22*a31;
a01=a01+a22;
a22=2.*a30;
a31=a22*a07;
a41=casadi_sq(a07);
a42=casadi_sq(a00);
a43=a41*a42;
a44=casadi_sq(a11);
a45=arg[22]? arg[22][0] : 0;
a44=a44*a45;
a46=a43*a44;
a47=a31*a46;
a01=a01+a47;
a47=2.*a00;
a31=a31*a00;
a48=arg[10]? arg[10][0] : 0;
a49=2.*a48;
a49=a15+a49;
a31=a31-a49;
a44=a31*a44;
a41=a41*a44;
a47=a47*a41;
a01=a01+a47;
a47=a15*a30;
a41=a47*a07;
a49=casadi_sq(a07);
a50=casadi_sq(a49);
a51=a17*a50;
a52=casadi_sq(a00);
a53=a00*a52;
a54=a51*a53;
a54=a54*a45;
a55=a41*a54;
a01=a01+a55;
a55=2.*a36;
a56=a55*a30;
a57=a15*a48;
a56=a56-a57;
a41=a41*a00;
a56=a56+a41;
a56=a56*a45;
a51=a51*a56;
a52=a52*a51;
a01=a01+a52;
a52=2.*a00;
a51=a00*a51;
a52=a52*a51;
a01=a01+a52;
a52=a48*a07;
a51=2.*a07;
a41=a51*a00;
a57=casadi_sq(a11);
a58=arg[21]? arg[21][0] : 0;
a57=a57*a58;
a59=a41*a57;
a60=a52*a59;
a01=a01+a60;
a60=arg[9]? arg[9][0] : 0;
a61=a36-a60;
a52=a52*a00;
a61=a61+a52;
a61=a61+a40;
a57=a61*a57;
a51=a51*a57;
a01=a01+a51;
a51=a15*a48;
a52=a51*a07;
a62=casadi_sq(a07);
a63=a07*a62;
a64=a17*a63;
a65=casadi_sq(a00);
a66=a64*a65;
a66=a66*a58;
a67=a52*a66;
a01=a01+a67;
a67=2.*a00;
a68=2.*a36;
a69=a68*a48;
a70=a15*a60;
a69=a69-a70;
a52=a52*a00;
a69=a69+a52;
a69=a69*a58;
a64=a64*a69;
a67=a67*a64;
a01=a01+a67;
a67=a15*a17;
a64=a67*a07;
a52=5.0000000000000000e-01;
a70=arg[4]? arg[4][0] : 0;
a70=a52*a70;
a71=arg[5]? arg[5][0] : 0;
a72=a70*a71;
a73=arg[3]? arg[3][0] : 0;
a74=a72*a73;
a75=a64*a74;
a76=2.*a60;
a75=a75-a76;
a36=2.*a36;
a36=a36+a40;
a75=a75+a36;
a76=casadi_sq(a11);
a77=arg[20]? arg[20][0] : 0;
a76=a76*a77;
a78=a75*a76;
a79=a07*a78;
a01=a01-a79;
a79=a60*a17;
a80=casadi_sq(a07);
a81=a79*a80;
a82=a36*a77;
a83=a81*a82;
a01=a01+a83;
a03=casadi_sq(a03);
a35=a35*a03;
a35=a35*a28;
a83=a05*a35;
a83=a83+a59;
a81=a81*a00;
a81=a81*a77;
a84=a07*a00;
a76=a84*a76;
a81=a81-a76;
a85=a17*a07;
a86=a85*a74;
a87=casadi_sq(a11);
a88=arg[19]? arg[19][0] : 0;
a87=a87*a88;
a89=a86*a87;
a81=a81+a89;
a83=a83+a81;
a39=a39*a83;
a01=a01+a39;
if (res[0]!=0) res[0][0]=a01;
a03=a03*a38;
a34=a34*a03;
a14=a00*a14;
a14=a14*a13;
a21=a21*a14;
a16=a16*a21;
a34=a34-a16;
a53=a53*a56;
a50=a50*a53;
a34=a34+a50;
a65=a65*a69;
a63=a63*a65;
a34=a34+a63;
a63=a74*a76;
a69=a07*a63;
a50=a15*a69;
a34=a34-a50;
a82=a00*a82;
a80=a80*a82;
a50=a60*a80;
a34=a34+a50;
a87=a36*a87;
a50=a74*a87;
a56=a07*a50;
a34=a34+a56;
if (res[1]!=0) res[1][0]=a34;
a34=2.*a11;
a02=casadi_sq(a02);
a10=a10*a02;
a10=a10*a13;
a34=a34*a10;
a10=2.*a11;
a26=a26*a23;
a26=a26*a28;
a10=a10*a26;
a34=a34+a10;
a10=2.*a11;
a43=a43*a31;
a43=a43*a45;
a10=a10*a43;
a34=a34+a10;
a10=2.*a11;
a41=a41*a61;
a41=a41*a58;
a10=a10*a41;
a34=a34+a10;
a10=2.*a11;
a41=casadi_sq(a11);
a58=2.*a41;
a61=a04*a74;
a61=a61*a77;
a58=a58*a61;
a10=a10*a58;
a34=a34+a10;
a10=2.*a11;
a84=a84*a75;
a84=a84*a77;
a10=a10*a84;
a34=a34-a10;
a10=2.*a11;
a84=casadi_sq(a11);
a75=2.*a84;
a74=2.*a74;
a74=a74*a88;
a75=a75*a74;
a10=a10*a75;
a34=a34+a10;
a11=2.*a11;
a86=a86*a36;
a86=a86*a88;
a11=a11*a86;
a34=a34+a11;
if (res[2]!=0) res[2][0]=a34;
a41=casadi_sq(a41);
a41=a41*a77;
a41=a04*a41;
a64=a64*a76;
a41=a41-a64;
a84=casadi_sq(a84);
a84=a84*a88;
a84=2.*a84;
a41=a41+a84;
a85=a85*a87;
a41=a41+a85;
a72=a72*a41;
if (res[3]!=0) res[3][0]=a72;
a73=a73*a41;
a71=a71*a73;
a52=a52*a71;
if (res[4]!=0) res[4][0]=a52;
a70=a70*a73;
if (res[5]!=0) res[5][0]=a70;
a70=a05*a35;
a70=2.*a70;
a73=a30*a54;
a73=2.*a73;
a70=a70+a73;
a70=a70+a59;
a73=a48*a66;
a73=2.*a73;
a70=a70+a73;
a81=2.*a81;
a70=a70+a81;
if (res[6]!=0) res[6][0]=a70;
a70=a00*a54;
a81=a07*a70;
a73=a30*a81;
a21=a17*a21;
a52=a05*a21;
a30=a30*a35;
a52=a52+a30;
a52=a52+a46;
a73=a73-a52;
a52=a48*a54;
a73=a73-a52;
a52=a00*a66;
a30=a07*a52;
a71=a48*a30;
a73=a73+a71;
a60=a60*a66;
a73=a73-a60;
a69=a17*a69;
a73=a73-a69;
a83=a00*a83;
a69=a07*a83;
a73=a73+a69;
if (res[7]!=0) res[7][0]=a73;
a73=2.*a07;
a08=2.*a08;
a02=a02*a12;
a06=a06*a02;
a08=a08*a06;
a73=a73*a08;
a20=2.*a20;
a18=a18*a14;
a20=a20*a18;
a19=a19*a20;
a18=2.*a07;
a20=a07*a20;
a18=a18*a20;
a19=a19+a18;
a73=a73-a19;
a19=a00*a29;
a05=a05*a19;
a73=a73+a05;
a25=a25*a27;
a25=2.*a25;
a24=a24*a25;
a73=a73+a24;
a24=2.*a07;
a25=a07*a25;
a24=a24*a25;
a73=a73+a24;
a03=a17*a03;
a33=a33*a03;
a73=a73+a33;
a33=2.*a07;
a32=2.*a32;
a03=a07*a03;
a32=a32*a03;
a33=a33*a32;
a73=a73+a33;
a33=a00*a46;
a22=a22*a33;
a73=a73+a22;
a22=2.*a07;
a42=a42*a44;
a22=a22*a42;
a73=a73+a22;
a47=a47*a70;
a73=a73+a47;
a47=2.*a07;
a49=2.*a49;
a53=a17*a53;
a49=a49*a53;
a47=a47*a49;
a73=a73+a47;
a47=a00*a59;
a48=a48*a47;
a73=a73+a48;
a57=a00*a57;
a57=2.*a57;
a73=a73+a57;
a51=a51*a52;
a73=a73+a51;
a65=a17*a65;
a62=a62*a65;
a73=a73+a62;
a62=2.*a07;
a65=a07*a65;
a62=a62*a65;
a73=a73+a62;
a67=a67*a63;
a73=a73-a67;
a00=a00*a78;
a73=a73-a00;
a00=2.*a07;
a79=a79*a82;
a00=a00*a79;
a73=a73+a00;
a83=a15*a83;
a73=a73+a83;
a50=a17*a50;
a73=a73+a50;
if (res[8]!=0) res[8][0]=a73;
a76=2.*a76;
a73=a15*a66;
a59=a59+a73;
a76=a76-a59;
a17=a17*a80;
a76=a76+a17;
if (res[9]!=0) res[9][0]=a76;
a46=-a46;
a46=2.*a46;
a76=a15*a54;
a46=a46-a76;
a47=a07*a47;
a46=a46+a47;
a30=a15*a30;
a46=a46+a30;
a68=a68*a66;
a46=a46+a68;
if (res[10]!=0) res[10][0]=a46;
a33=a07*a33;
a33=2.*a33;
a46=a15*a35;
a29=a29+a46;
a33=a33-a29;
a81=a15*a81;
a33=a33+a81;
a55=a55*a54;
a33=a33+a55;
if (res[11]!=0) res[11][0]=a33;
a09=a09*a02;
a04=a04*a09;
a15=a15*a21;
a04=a04-a15;
a07=a07*a19;
a04=a04+a07;
a40=a40*a35;
a04=a04+a40;
a37=a37*a35;
a04=a04+a37;
if (res[12]!=0) res[12][0]=a04;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_loaded_gear_position(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f54(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_loaded_gear_position_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_loaded_gear_position_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_loaded_gear_position_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_loaded_gear_position_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_loaded_gear_position_n_in(void) { return 25;}
CASADI_SYMBOL_EXPORT casadi_int adj1_loaded_gear_position_n_out(void) { return 13;}
CASADI_SYMBOL_EXPORT casadi_real adj1_loaded_gear_position_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_loaded_gear_position_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "b";
case 2: return "u";
case 3: return "rho";
case 4: return "Ap";
case 5: return "CL_gamma";
case 6: return "B3";
case 7: return "C3";
case 8: return "g";
case 9: return "K1";
case 10: return "K2";
case 11: return "K3";
case 12: return "K4";
case 13: return "out_p_0";
case 14: return "out_p_1";
case 15: return "out_p_2";
case 16: return "out_p_3";
case 17: return "out_p_4";
case 18: return "out_p_5";
case 19: return "adj_p_0";
case 20: return "adj_p_1";
case 21: return "adj_p_2";
case 22: return "adj_p_3";
case 23: return "adj_p_4";
case 24: return "adj_p_5";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_loaded_gear_position_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_m";
case 1: return "adj_b";
case 2: return "adj_u";
case 3: return "adj_rho";
case 4: return "adj_Ap";
case 5: return "adj_CL_gamma";
case 6: return "adj_B3";
case 7: return "adj_C3";
case 8: return "adj_g";
case 9: return "adj_K1";
case 10: return "adj_K2";
case 11: return "adj_K3";
case 12: return "adj_K4";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_loaded_gear_position_sparsity_in(casadi_int i) {
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
case 11: return casadi_s0;
case 12: return casadi_s0;
case 13: return casadi_s1;
case 14: return casadi_s1;
case 15: return casadi_s1;
case 16: return casadi_s1;
case 17: return casadi_s1;
case 18: return casadi_s1;
case 19: return casadi_s0;
case 20: return casadi_s0;
case 21: return casadi_s0;
case 22: return casadi_s0;
case 23: return casadi_s0;
case 24: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_loaded_gear_position_sparsity_out(casadi_int i) {
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
case 11: return casadi_s0;
case 12: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_loaded_gear_position_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 25;
if (sz_res) *sz_res = 13;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_loaded_gear_position_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 25*sizeof(const casadi_real*);
if (sz_res) *sz_res = 13*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_loaded_gear_position:(m,b,u,rho,Ap,CL_gamma,B3,C3,g,K1,K2,K3,K4,out_p_0[1x1,0nz],out_p_1[1x1,0nz],out_p_2[1x1,0nz],out_p_3[1x1,0nz],out_p_4[1x1,0nz],out_p_5[1x1,0nz],adj_p_0,adj_p_1,adj_p_2,adj_p_3,adj_p_4,adj_p_5,out_adj_m[1x1,0nz],out_adj_b[1x1,0nz],out_adj_u[1x1,0nz],out_adj_rho[1x1,0nz],out_adj_Ap[1x1,0nz],out_adj_CL_gamma[1x1,0nz],out_adj_B3[1x1,0nz],out_adj_C3[1x1,0nz],out_adj_g[1x1,0nz],out_adj_K1[1x1,0nz],out_adj_K2[1x1,0nz],out_adj_K3[1x1,0nz],out_adj_K4[1x1,0nz],fwd_m,fwd_b,fwd_u,fwd_rho,fwd_Ap,fwd_CL_gamma,fwd_B3,fwd_C3,fwd_g,fwd_K1,fwd_K2,fwd_K3,fwd_K4,fwd_out_p_0[1x1,0nz],fwd_out_p_1[1x1,0nz],fwd_out_p_2[1x1,0nz],fwd_out_p_3[1x1,0nz],fwd_out_p_4[1x1,0nz],fwd_out_p_5[1x1,0nz],fwd_adj_p_0,fwd_adj_p_1,fwd_adj_p_2,fwd_adj_p_3,fwd_adj_p_4,fwd_adj_p_5)->(fwd_adj_m,fwd_adj_b,fwd_adj_u,fwd_adj_rho,fwd_adj_Ap,fwd_adj_CL_gamma,fwd_adj_B3,fwd_adj_C3,fwd_adj_g,fwd_adj_K1,fwd_adj_K2,fwd_adj_K3,fwd_adj_K4) */
static int casadi_f55(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a000, a001, a002, a003, a004, a005, a006, a007, a008, a009, a010, a011;
casadi_real a012, a013, a014, a015, a016, a017, a018, a019, a020, a021, a022, a023;
casadi_real a024, a025, a026, a027, a028, a029, a030, a031, a032, a033, a034, a035;
casadi_real a036, a037, a038, a039, a040, a041, a042, a043, a044, a045, a046, a047;
casadi_real a048, a049, a050, a051, a052, a053, a054, a055, a056, a057, a058, a059;
casadi_real a060, a061, a062, a063, a064, a065, a066, a067, a068, a069, a070, a071;
casadi_real a072, a073, a074, a075, a076, a077, a078, a079, a080, a081, a082, a083;
casadi_real a084, a085, a086, a087, a088, a089, a090, a091, a092, a093, a094, a095;
casadi_real a096, a097, a098, a099, a100, a101, a102, a103, a104, a105, a106, a107;
casadi_real a108, a109, a110, a111, a112, a113, a114, a115, a116, a117, a118, a119;
casadi_real a120, a121, a122, a123, a124, a125, a126, a127, a128, a129, a130, a131;
casadi_real a132, a133, a134, a135, a136, a137, a138, a139, a140, a141, a142, a143;
casadi_real a144, a145, a146, a147, a148, a149, a150, a151, a152, a153, a154, a155;
casadi_real a156, a157, a158, a159, a160, a161, a162, a163, a164, a165, a166, a167;
casadi_real a168, a169, a170, a171, a172, a173, a174, a175, a176;
a000=arg[0]? arg[0][0] : 0;
a001=casadi_sq(a000);
a002=2.*a001;
a003=-2.;
a004=arg[12]? arg[12][0] : 0;
a005=a003*a004;
a006=arg[8]? arg[8][0] : 0;
a007=casadi_sq(a006);
a008=casadi_sq(a007);
a009=a005*a008;
a010=arg[2]? arg[2][0] : 0;
a011=casadi_sq(a010);
a012=arg[24]? arg[24][0] : 0;
a013=a011*a012;
a014=a009*a013;
a015=a002*a014;
a016=arg[38]? arg[38][0] : 0;
a017=2.*a016;
a015=a015*a017;
a017=2.*a000;
a018=2.*a000;
a018=a018*a016;
a019=2.*a018;
a014=a014*a019;
a019=arg[50]? arg[50][0] : 0;
a020=a003*a019;
a021=a008*a020;
a022=2.*a007;
a023=2.*a006;
a024=arg[46]? arg[46][0] : 0;
a023=a023*a024;
a022=a022*a023;
a025=a005*a022;
a021=a021+a025;
a025=a013*a021;
a026=2.*a010;
a027=arg[40]? arg[40][0] : 0;
a026=a026*a027;
a026=a012*a026;
a028=arg[62]? arg[62][0] : 0;
a011=a011*a028;
a026=a026+a011;
a011=a009*a026;
a025=a025+a011;
a002=a002*a025;
a014=a014+a002;
a017=a017*a014;
a015=a015+a017;
a017=arg[7]? arg[7][0] : 0;
a014=a017*a004;
a002=arg[1]? arg[1][0] : 0;
a025=a014*a002;
a011=casadi_sq(a006);
a029=a006*a011;
a030=casadi_sq(a029);
a031=a025*a030;
a032=a031*a012;
a033=casadi_sq(a000);
a034=2.*a033;
a035=2.*a000;
a035=a035*a016;
a034=a034*a035;
a036=a032*a034;
a037=casadi_sq(a033);
a038=arg[45]? arg[45][0] : 0;
a039=a004*a038;
a040=a017*a019;
a039=a039+a040;
a040=a002*a039;
a041=arg[39]? arg[39][0] : 0;
a042=a014*a041;
a040=a040+a042;
a042=a030*a040;
a043=2.*a029;
a044=a011*a024;
a045=2.*a006;
a045=a045*a024;
a046=a006*a045;
a044=a044+a046;
a043=a043*a044;
a046=a025*a043;
a042=a042+a046;
a042=a012*a042;
a031=a031*a028;
a042=a042+a031;
a031=a037*a042;
a036=a036+a031;
a033=2.*a033;
a031=a000*a032;
a046=a033*a031;
a047=2.*a016;
a046=a046*a047;
a047=2.*a000;
a035=2.*a035;
a031=a031*a035;
a032=a032*a016;
a042=a000*a042;
a032=a032+a042;
a033=a033*a032;
a031=a031+a033;
a047=a047*a031;
a046=a046+a047;
a036=a036+a046;
a015=a015-a036;
a036=casadi_sq(a006);
a046=a006*a036;
a046=2.*a046;
a047=casadi_sq(a000);
a031=a000*a047;
a033=a046*a031;
a032=casadi_sq(a010);
a042=arg[23]? arg[23][0] : 0;
a035=a032*a042;
a048=a033*a035;
a049=a006*a019;
a050=a004*a024;
a049=a049+a050;
a050=a048*a049;
a051=a004*a006;
a052=a036*a024;
a053=2.*a006;
a053=a053*a024;
a054=a006*a053;
a052=a052+a054;
a052=2.*a052;
a054=a031*a052;
a055=a047*a016;
a056=2.*a000;
a056=a056*a016;
a057=a000*a056;
a055=a055+a057;
a057=a046*a055;
a054=a054+a057;
a057=a035*a054;
a058=2.*a010;
a058=a058*a027;
a058=a042*a058;
a059=arg[61]? arg[61][0] : 0;
a032=a032*a059;
a058=a058+a032;
a032=a033*a058;
a057=a057+a032;
a032=a051*a057;
a050=a050+a032;
a015=a015+a050;
a050=a051*a000;
a032=arg[11]? arg[11][0] : 0;
a050=a050-a032;
a060=a050*a035;
a061=a046*a060;
a056=a061*a056;
a052=a060*a052;
a049=a000*a049;
a051=a051*a016;
a049=a049+a051;
a051=arg[49]? arg[49][0] : 0;
a049=a049-a051;
a035=a035*a049;
a058=a050*a058;
a035=a035+a058;
a046=a046*a035;
a052=a052+a046;
a047=a047*a052;
a056=a056+a047;
a015=a015+a056;
a056=a000*a061;
a047=2.*a016;
a056=a056*a047;
a047=2.*a000;
a061=a061*a016;
a052=a000*a052;
a061=a061+a052;
a047=a047*a061;
a056=a056+a047;
a015=a015+a056;
a056=casadi_sq(a000);
a047=2.*a056;
a061=casadi_sq(a006);
a052=casadi_sq(a061);
a046=a006*a052;
a058=a002*a046;
a062=arg[6]? arg[6][0] : 0;
a063=2.*a062;
a064=a063*a004;
a065=a017*a032;
a064=a064-a065;
a065=a017*a006;
a066=a065*a000;
a067=a004*a066;
a064=a064+a067;
a067=a064*a042;
a068=a058*a067;
a069=a047*a068;
a070=2.*a016;
a069=a069*a070;
a070=2.*a000;
a071=2.*a000;
a071=a071*a016;
a072=2.*a071;
a068=a068*a072;
a072=a046*a041;
a073=a052*a024;
a074=2.*a061;
a075=2.*a006;
a075=a075*a024;
a074=a074*a075;
a076=a006*a074;
a073=a073+a076;
a076=a002*a073;
a072=a072+a076;
a076=a067*a072;
a077=arg[44]? arg[44][0] : 0;
a078=2.*a077;
a079=a004*a078;
a080=a063*a019;
a079=a079+a080;
a080=a032*a038;
a081=a017*a051;
a080=a080+a081;
a079=a079-a080;
a080=a066*a019;
a081=a006*a038;
a082=a017*a024;
a081=a081+a082;
a082=a000*a081;
a083=a065*a016;
a082=a082+a083;
a083=a004*a082;
a080=a080+a083;
a079=a079+a080;
a079=a042*a079;
a064=a064*a059;
a079=a079+a064;
a064=a058*a079;
a076=a076+a064;
a047=a047*a076;
a068=a068+a047;
a070=a070*a068;
a069=a069+a070;
a015=a015+a069;
a069=casadi_sq(a006);
a070=casadi_sq(a000);
a068=a069*a070;
a047=casadi_sq(a010);
a076=arg[22]? arg[22][0] : 0;
a064=a047*a076;
a080=a068*a064;
a083=2.*a051;
a084=a006*a083;
a085=2.*a032;
a086=a085*a024;
a084=a084+a086;
a086=a080*a084;
a087=a085*a006;
a088=2.*a006;
a088=a088*a024;
a089=a070*a088;
a090=2.*a000;
a090=a090*a016;
a091=a069*a090;
a089=a089+a091;
a091=a064*a089;
a092=2.*a010;
a092=a092*a027;
a092=a076*a092;
a093=arg[60]? arg[60][0] : 0;
a047=a047*a093;
a092=a092+a047;
a047=a068*a092;
a091=a091+a047;
a047=a087*a091;
a086=a086+a047;
a015=a015+a086;
a086=a087*a000;
a047=arg[10]? arg[10][0] : 0;
a094=2.*a047;
a094=a017+a094;
a086=a086-a094;
a094=a086*a064;
a095=a069*a094;
a096=2.*a016;
a095=a095*a096;
a096=2.*a000;
a088=a094*a088;
a084=a000*a084;
a087=a087*a016;
a084=a084+a087;
a087=arg[48]? arg[48][0] : 0;
a097=2.*a087;
a097=a038+a097;
a084=a084-a097;
a064=a064*a084;
a092=a086*a092;
a064=a064+a092;
a069=a069*a064;
a088=a088+a069;
a096=a096*a088;
a095=a095+a096;
a015=a015+a095;
a095=casadi_sq(a006);
a096=casadi_sq(a095);
a088=a002*a096;
a069=casadi_sq(a000);
a092=a000*a069;
a097=a088*a092;
a098=a097*a076;
a099=a032*a038;
a100=a017*a051;
a099=a099+a100;
a100=a006*a099;
a101=a017*a032;
a102=a101*a024;
a100=a100+a102;
a102=a098*a100;
a103=a101*a006;
a104=a096*a041;
a105=2.*a095;
a106=2.*a006;
a106=a106*a024;
a105=a105*a106;
a107=a002*a105;
a104=a104+a107;
a107=a092*a104;
a108=a069*a016;
a109=2.*a000;
a109=a109*a016;
a110=a000*a109;
a108=a108+a110;
a110=a088*a108;
a107=a107+a110;
a107=a076*a107;
a097=a097*a093;
a107=a107+a097;
a097=a103*a107;
a102=a102+a097;
a015=a015+a102;
a102=2.*a062;
a097=a102*a032;
a110=a017*a047;
a097=a097-a110;
a110=a103*a000;
a097=a097+a110;
a110=a097*a076;
a111=a088*a110;
a109=a111*a109;
a104=a110*a104;
a112=2.*a077;
a113=a032*a112;
a114=a102*a051;
a113=a113+a114;
a114=a047*a038;
a115=a017*a087;
a114=a114+a115;
a113=a113-a114;
a100=a000*a100;
a103=a103*a016;
a100=a100+a103;
a113=a113+a100;
a113=a076*a113;
a097=a097*a093;
a113=a113+a097;
a088=a088*a113;
a104=a104+a088;
a069=a069*a104;
a109=a109+a069;
a015=a015+a109;
a109=a000*a111;
a069=2.*a016;
a109=a109*a069;
a069=2.*a000;
a111=a111*a016;
a104=a000*a104;
a111=a111+a104;
a069=a069*a111;
a109=a109+a069;
a015=a015+a109;
a109=2.*a006;
a069=a109*a000;
a111=casadi_sq(a010);
a104=arg[21]? arg[21][0] : 0;
a088=a111*a104;
a097=a069*a088;
a100=a006*a087;
a103=a047*a024;
a100=a100+a103;
a103=a097*a100;
a114=a047*a006;
a115=2.*a024;
a116=a000*a115;
a117=a109*a016;
a116=a116+a117;
a117=a088*a116;
a118=2.*a010;
a118=a118*a027;
a118=a104*a118;
a119=arg[59]? arg[59][0] : 0;
a111=a111*a119;
a118=a118+a111;
a111=a069*a118;
a117=a117+a111;
a111=a114*a117;
a103=a103+a111;
a015=a015+a103;
a103=arg[9]? arg[9][0] : 0;
a111=a062-a103;
a120=a114*a000;
a111=a111+a120;
a111=a111+a066;
a120=a111*a088;
a115=a120*a115;
a121=arg[47]? arg[47][0] : 0;
a122=a077-a121;
a100=a000*a100;
a114=a114*a016;
a100=a100+a114;
a122=a122+a100;
a122=a122+a082;
a088=a088*a122;
a118=a111*a118;
a088=a088+a118;
a109=a109*a088;
a115=a115+a109;
a015=a015+a115;
a115=casadi_sq(a006);
a109=a006*a115;
a118=a002*a109;
a100=casadi_sq(a000);
a114=a118*a100;
a123=a114*a104;
a124=a047*a038;
a125=a017*a087;
a124=a124+a125;
a125=a006*a124;
a126=a017*a047;
a127=a126*a024;
a125=a125+a127;
a127=a123*a125;
a128=a126*a006;
a129=a109*a041;
a130=a115*a024;
a131=2.*a006;
a131=a131*a024;
a132=a006*a131;
a130=a130+a132;
a132=a002*a130;
a129=a129+a132;
a132=a100*a129;
a133=2.*a000;
a133=a133*a016;
a134=a118*a133;
a132=a132+a134;
a132=a104*a132;
a114=a114*a119;
a132=a132+a114;
a114=a128*a132;
a127=a127+a114;
a015=a015+a127;
a127=2.*a062;
a114=a127*a047;
a134=a017*a103;
a114=a114-a134;
a134=a128*a000;
a114=a114+a134;
a134=a114*a104;
a135=a118*a134;
a136=2.*a016;
a135=a135*a136;
a136=2.*a000;
a129=a134*a129;
a137=2.*a077;
a138=a047*a137;
a139=a127*a087;
a138=a138+a139;
a139=a103*a038;
a140=a017*a121;
a139=a139+a140;
a138=a138-a139;
a125=a000*a125;
a128=a128*a016;
a125=a125+a128;
a138=a138+a125;
a138=a104*a138;
a114=a114*a119;
a138=a138+a114;
a118=a118*a138;
a129=a129+a118;
a136=a136*a129;
a135=a135+a136;
a015=a015+a135;
a135=a017*a002;
a136=a135*a006;
a129=5.0000000000000000e-01;
a118=arg[4]? arg[4][0] : 0;
a118=a129*a118;
a114=arg[5]? arg[5][0] : 0;
a125=a118*a114;
a128=arg[3]? arg[3][0] : 0;
a139=a125*a128;
a140=a136*a139;
a141=2.*a103;
a140=a140-a141;
a062=2.*a062;
a062=a062+a066;
a140=a140+a062;
a141=casadi_sq(a010);
a142=arg[20]? arg[20][0] : 0;
a143=a141*a142;
a144=a140*a143;
a145=a144*a024;
a146=a002*a038;
a147=a017*a041;
a146=a146+a147;
a147=a006*a146;
a148=a135*a024;
a147=a147+a148;
a148=a139*a147;
a149=arg[42]? arg[42][0] : 0;
a149=a129*a149;
a150=a114*a149;
a151=arg[43]? arg[43][0] : 0;
a152=a118*a151;
a150=a150+a152;
a152=a128*a150;
a153=arg[41]? arg[41][0] : 0;
a154=a125*a153;
a152=a152+a154;
a154=a136*a152;
a148=a148+a154;
a154=2.*a121;
a148=a148-a154;
a077=2.*a077;
a077=a077+a082;
a148=a148+a077;
a154=a143*a148;
a155=2.*a010;
a155=a155*a027;
a155=a142*a155;
a156=arg[58]? arg[58][0] : 0;
a141=a141*a156;
a155=a155+a141;
a141=a140*a155;
a154=a154+a141;
a141=a006*a154;
a145=a145+a141;
a015=a015-a145;
a145=a062*a142;
a141=casadi_sq(a006);
a157=a002*a121;
a158=a103*a041;
a157=a157+a158;
a158=a141*a157;
a159=a103*a002;
a160=2.*a006;
a160=a160*a024;
a161=a159*a160;
a158=a158+a161;
a161=a145*a158;
a162=a159*a141;
a163=a142*a077;
a164=a062*a156;
a163=a163+a164;
a164=a162*a163;
a161=a161+a164;
a015=a015+a161;
a161=casadi_sq(a056);
a164=a058*a161;
a165=a164*a042;
a166=a004*a165;
a166=a166+a097;
a167=a162*a000;
a168=a167*a142;
a169=a006*a000;
a170=a169*a143;
a168=a168-a170;
a171=a002*a006;
a172=a171*a139;
a173=casadi_sq(a010);
a174=arg[19]? arg[19][0] : 0;
a175=a173*a174;
a176=a172*a175;
a168=a168+a176;
a166=a166+a168;
a081=a166*a081;
a168=a165*a019;
a072=a161*a072;
a056=2.*a056;
a056=a056*a071;
a058=a058*a056;
a072=a072+a058;
a072=a042*a072;
a164=a164*a059;
a072=a072+a164;
a164=a004*a072;
a168=a168+a164;
a168=a168+a117;
a158=a000*a158;
a162=a162*a016;
a158=a158+a162;
a158=a142*a158;
a167=a167*a156;
a158=a158+a167;
a167=a000*a024;
a162=a006*a016;
a167=a167+a162;
a143=a143*a167;
a155=a169*a155;
a143=a143+a155;
a158=a158-a143;
a155=a006*a041;
a162=a002*a024;
a155=a155+a162;
a162=a139*a155;
a164=a171*a152;
a162=a162+a164;
a164=a175*a162;
a058=2.*a010;
a058=a058*a027;
a058=a174*a058;
a071=arg[57]? arg[57][0] : 0;
a173=a173*a071;
a058=a058+a173;
a173=a172*a058;
a164=a164+a173;
a158=a158+a164;
a168=a168+a158;
a065=a065*a168;
a081=a081+a065;
a015=a015+a081;
if (res[0]!=0) res[0][0]=a015;
a015=a161*a067;
a073=a015*a073;
a067=a067*a056;
a161=a161*a079;
a067=a067+a161;
a046=a046*a067;
a073=a073+a046;
a046=a000*a037;
a161=a046*a012;
a079=a030*a161;
a039=a079*a039;
a043=a161*a043;
a037=a037*a016;
a034=a000*a034;
a037=a037+a034;
a037=a012*a037;
a046=a046*a028;
a037=a037+a046;
a030=a030*a037;
a043=a043+a030;
a014=a014*a043;
a039=a039+a014;
a073=a073-a039;
a039=a092*a110;
a105=a039*a105;
a110=a110*a108;
a092=a092*a113;
a110=a110+a092;
a096=a096*a110;
a105=a105+a096;
a073=a073+a105;
a105=a100*a134;
a130=a105*a130;
a134=a134*a133;
a100=a100*a138;
a134=a134+a100;
a109=a109*a134;
a130=a130+a109;
a073=a073+a130;
a130=a139*a170;
a109=a006*a130;
a100=a109*a038;
a138=a130*a024;
a133=a170*a152;
a096=a139*a143;
a133=a133+a096;
a096=a006*a133;
a138=a138+a096;
a096=a017*a138;
a100=a100+a096;
a073=a073-a100;
a100=a000*a145;
a096=a141*a100;
a092=a096*a121;
a160=a100*a160;
a145=a145*a016;
a163=a000*a163;
a145=a145+a163;
a141=a141*a145;
a160=a160+a141;
a141=a103*a160;
a092=a092+a141;
a073=a073+a092;
a092=a062*a175;
a141=a139*a092;
a163=a141*a024;
a113=a092*a152;
a175=a175*a077;
a058=a062*a058;
a175=a175+a058;
a058=a139*a175;
a113=a113+a058;
a058=a006*a113;
a163=a163+a058;
a073=a073+a163;
if (res[1]!=0) res[1][0]=a073;
a073=casadi_sq(a001);
a163=a009*a073;
a058=a163*a012;
a108=2.*a027;
a058=a058*a108;
a108=2.*a010;
a021=a073*a021;
a001=2.*a001;
a001=a001*a018;
a009=a009*a001;
a021=a021+a009;
a012=a012*a021;
a163=a163*a028;
a012=a012+a163;
a108=a108*a012;
a058=a058+a108;
a108=a033*a050;
a012=a108*a042;
a163=2.*a027;
a012=a012*a163;
a163=2.*a010;
a050=a050*a054;
a033=a033*a049;
a050=a050+a033;
a042=a042*a050;
a108=a108*a059;
a042=a042+a108;
a163=a163*a042;
a012=a012+a163;
a058=a058+a012;
a012=a068*a086;
a163=a012*a076;
a042=2.*a027;
a163=a163*a042;
a042=2.*a010;
a086=a086*a089;
a068=a068*a084;
a086=a086+a068;
a076=a076*a086;
a012=a012*a093;
a076=a076+a012;
a042=a042*a076;
a163=a163+a042;
a058=a058+a163;
a163=a069*a111;
a042=a163*a104;
a076=2.*a027;
a042=a042*a076;
a076=2.*a010;
a111=a111*a116;
a069=a069*a122;
a111=a111+a069;
a104=a104*a111;
a163=a163*a119;
a104=a104+a163;
a076=a076*a104;
a042=a042+a076;
a058=a058+a042;
a042=casadi_sq(a010);
a076=2.*a042;
a104=a003*a139;
a163=a104*a142;
a119=a076*a163;
a111=2.*a027;
a119=a119*a111;
a111=2.*a010;
a069=2.*a010;
a069=a069*a027;
a122=2.*a069;
a163=a163*a122;
a122=a003*a152;
a122=a142*a122;
a104=a104*a156;
a122=a122+a104;
a076=a076*a122;
a163=a163+a076;
a111=a111*a163;
a119=a119+a111;
a058=a058+a119;
a119=a169*a140;
a111=a119*a142;
a163=2.*a027;
a111=a111*a163;
a163=2.*a010;
a140=a140*a167;
a169=a169*a148;
a140=a140+a169;
a140=a142*a140;
a119=a119*a156;
a140=a140+a119;
a163=a163*a140;
a111=a111+a163;
a058=a058-a111;
a111=casadi_sq(a010);
a163=2.*a111;
a139=2.*a139;
a140=a139*a174;
a119=a163*a140;
a169=2.*a027;
a119=a119*a169;
a169=2.*a010;
a148=2.*a010;
a148=a148*a027;
a167=2.*a148;
a140=a140*a167;
a152=2.*a152;
a152=a174*a152;
a139=a139*a071;
a152=a152+a139;
a163=a163*a152;
a140=a140+a163;
a169=a169*a140;
a119=a119+a169;
a058=a058+a119;
a119=a172*a062;
a169=a119*a174;
a027=2.*a027;
a169=a169*a027;
a010=2.*a010;
a062=a062*a162;
a172=a172*a077;
a062=a062+a172;
a062=a174*a062;
a119=a119*a071;
a062=a062+a119;
a010=a010*a062;
a169=a169+a010;
a058=a058+a169;
if (res[2]!=0) res[2][0]=a058;
a058=casadi_sq(a042);
a169=a058*a142;
a169=a003*a169;
a010=a136*a170;
a169=a169-a010;
a010=casadi_sq(a111);
a062=a010*a174;
a062=2.*a062;
a169=a169+a062;
a062=a171*a092;
a169=a169+a062;
a150=a169*a150;
a042=2.*a042;
a042=a042*a069;
a142=a142*a042;
a058=a058*a156;
a142=a142+a058;
a142=a003*a142;
a170=a170*a147;
a136=a136*a143;
a170=a170+a136;
a142=a142-a170;
a111=2.*a111;
a111=a111*a148;
a174=a174*a111;
a010=a010*a071;
a174=a174+a010;
a174=2.*a174;
a142=a142+a174;
a092=a092*a155;
a171=a171*a175;
a092=a092+a171;
a142=a142+a092;
a125=a125*a142;
a150=a150+a125;
if (res[3]!=0) res[3][0]=a150;
a150=a128*a169;
a151=a150*a151;
a169=a169*a153;
a128=a128*a142;
a169=a169+a128;
a114=a114*a169;
a151=a151+a114;
a129=a129*a151;
if (res[4]!=0) res[4][0]=a129;
a150=a150*a149;
a118=a118*a169;
a150=a150+a118;
if (res[5]!=0) res[5][0]=a150;
a150=a165*a019;
a118=a004*a072;
a150=a150+a118;
a150=2.*a150;
a118=a098*a051;
a169=a032*a107;
a118=a118+a169;
a118=2.*a118;
a150=a150+a118;
a150=a150+a117;
a118=a123*a087;
a169=a047*a132;
a118=a118+a169;
a118=2.*a118;
a150=a150+a118;
a158=2.*a158;
a150=a150+a158;
if (res[6]!=0) res[6][0]=a150;
a150=a000*a098;
a158=a006*a150;
a118=a158*a051;
a169=a150*a024;
a149=a098*a016;
a129=a000*a107;
a149=a149+a129;
a129=a006*a149;
a169=a169+a129;
a129=a032*a169;
a118=a118+a129;
a129=a002*a079;
a151=a129*a019;
a079=a079*a041;
a043=a002*a043;
a079=a079+a043;
a043=a004*a079;
a151=a151+a043;
a051=a165*a051;
a032=a032*a072;
a051=a051+a032;
a151=a151+a051;
a151=a151+a091;
a118=a118-a151;
a151=a098*a087;
a051=a047*a107;
a151=a151+a051;
a118=a118-a151;
a151=a000*a123;
a051=a006*a151;
a032=a051*a087;
a043=a151*a024;
a114=a123*a016;
a128=a000*a132;
a114=a114+a128;
a128=a006*a114;
a043=a043+a128;
a128=a047*a043;
a032=a032+a128;
a118=a118+a032;
a121=a123*a121;
a103=a103*a132;
a121=a121+a103;
a118=a118-a121;
a109=a109*a041;
a138=a002*a138;
a109=a109+a138;
a118=a118-a109;
a109=a000*a166;
a138=a109*a024;
a166=a166*a016;
a168=a000*a168;
a166=a166+a168;
a168=a006*a166;
a138=a138+a168;
a118=a118+a138;
if (res[7]!=0) res[7][0]=a118;
a007=2.*a007;
a118=a073*a013;
a138=a005*a118;
a168=a007*a138;
a121=2.*a024;
a168=a168*a121;
a121=2.*a006;
a023=2.*a023;
a138=a138*a023;
a020=a118*a020;
a013=a013*a001;
a073=a073*a026;
a013=a013+a073;
a005=a005*a013;
a020=a020+a005;
a007=a007*a020;
a138=a138+a007;
a121=a121*a138;
a168=a168+a121;
a029=2.*a029;
a121=a025*a161;
a138=a029*a121;
a045=a138*a045;
a044=2.*a044;
a121=a121*a044;
a161=a161*a040;
a025=a025*a037;
a161=a161+a025;
a029=a029*a161;
a121=a121+a029;
a011=a011*a121;
a045=a045+a011;
a011=a006*a138;
a029=2.*a024;
a011=a011*a029;
a029=2.*a006;
a138=a138*a024;
a121=a006*a121;
a138=a138+a121;
a029=a029*a138;
a011=a011+a029;
a045=a045+a011;
a168=a168-a045;
a045=a000*a048;
a019=a045*a019;
a048=a048*a016;
a011=a000*a057;
a048=a048+a011;
a004=a004*a048;
a019=a019+a004;
a168=a168+a019;
a019=a031*a060;
a019=2.*a019;
a053=a019*a053;
a060=a060*a055;
a031=a031*a035;
a060=a060+a031;
a060=2.*a060;
a036=a036*a060;
a053=a053+a036;
a168=a168+a053;
a053=a006*a019;
a036=2.*a024;
a053=a053*a036;
a036=2.*a006;
a019=a019*a024;
a060=a006*a060;
a019=a019+a060;
a036=a036*a019;
a053=a053+a036;
a168=a168+a053;
a053=a002*a015;
a074=a053*a074;
a015=a015*a041;
a067=a002*a067;
a015=a015+a067;
a052=a052*a015;
a074=a074+a052;
a168=a168+a074;
a061=2.*a061;
a074=a006*a053;
a052=a061*a074;
a067=2.*a024;
a052=a052*a067;
a067=2.*a006;
a075=2.*a075;
a074=a074*a075;
a053=a053*a024;
a015=a006*a015;
a053=a053+a015;
a061=a061*a053;
a074=a074+a061;
a067=a067*a074;
a052=a052+a067;
a168=a168+a052;
a052=a000*a080;
a083=a052*a083;
a080=a080*a016;
a067=a000*a091;
a080=a080+a067;
a085=a085*a080;
a083=a083+a085;
a168=a168+a083;
a083=a070*a094;
a085=2.*a024;
a083=a083*a085;
a085=2.*a006;
a094=a094*a090;
a070=a070*a064;
a094=a094+a070;
a085=a085*a094;
a083=a083+a085;
a168=a168+a083;
a150=a150*a099;
a101=a101*a149;
a150=a150+a101;
a168=a168+a150;
a095=2.*a095;
a150=a002*a039;
a101=a095*a150;
a149=2.*a024;
a101=a101*a149;
a149=2.*a006;
a106=2.*a106;
a150=a150*a106;
a039=a039*a041;
a110=a002*a110;
a039=a039+a110;
a095=a095*a039;
a150=a150+a095;
a149=a149*a150;
a101=a101+a149;
a168=a168+a101;
a101=a000*a097;
a087=a101*a087;
a097=a097*a016;
a149=a000*a117;
a097=a097+a149;
a047=a047*a097;
a087=a087+a047;
a168=a168+a087;
a120=a120*a016;
a088=a000*a088;
a120=a120+a088;
a120=2.*a120;
a168=a168+a120;
a151=a151*a124;
a126=a126*a114;
a151=a151+a126;
a168=a168+a151;
a151=a002*a105;
a131=a151*a131;
a105=a105*a041;
a134=a002*a134;
a105=a105+a134;
a115=a115*a105;
a131=a131+a115;
a168=a168+a131;
a131=a006*a151;
a115=2.*a024;
a131=a131*a115;
a115=2.*a006;
a151=a151*a024;
a105=a006*a105;
a151=a151+a105;
a115=a115*a151;
a131=a131+a115;
a168=a168+a131;
a130=a130*a146;
a135=a135*a133;
a130=a130+a135;
a168=a168-a130;
a144=a144*a016;
a000=a000*a154;
a144=a144+a000;
a168=a168-a144;
a144=a159*a100;
a000=2.*a024;
a144=a144*a000;
a000=2.*a006;
a100=a100*a157;
a159=a159*a145;
a100=a100+a159;
a000=a000*a100;
a144=a144+a000;
a168=a168+a144;
a109=a109*a038;
a166=a017*a166;
a109=a109+a166;
a168=a168+a109;
a141=a141*a041;
a113=a002*a113;
a141=a141+a113;
a168=a168+a141;
if (res[8]!=0) res[8][0]=a168;
a143=2.*a143;
a168=a123*a038;
a141=a017*a132;
a168=a168+a141;
a117=a117+a168;
a143=a143-a117;
a096=a096*a041;
a002=a002*a160;
a096=a096+a002;
a143=a143+a096;
if (res[9]!=0) res[9][0]=a143;
a091=-a091;
a091=2.*a091;
a143=a098*a038;
a096=a017*a107;
a143=a143+a096;
a091=a091-a143;
a101=a101*a024;
a097=a006*a097;
a101=a101+a097;
a091=a091+a101;
a051=a051*a038;
a043=a017*a043;
a051=a051+a043;
a091=a091+a051;
a123=a123*a137;
a127=a127*a132;
a123=a123+a127;
a091=a091+a123;
if (res[10]!=0) res[10][0]=a091;
a052=a052*a024;
a080=a006*a080;
a052=a052+a080;
a052=2.*a052;
a080=a165*a038;
a091=a017*a072;
a080=a080+a091;
a057=a057+a080;
a052=a052-a057;
a158=a158*a038;
a169=a017*a169;
a158=a158+a169;
a052=a052+a158;
a098=a098*a112;
a102=a102*a107;
a098=a098+a102;
a052=a052+a098;
if (res[11]!=0) res[11][0]=a052;
a118=a118*a022;
a008=a008*a013;
a118=a118+a008;
a003=a003*a118;
a129=a129*a038;
a017=a017*a079;
a129=a129+a017;
a003=a003-a129;
a045=a045*a024;
a006=a006*a048;
a045=a045+a006;
a003=a003+a045;
a082=a165*a082;
a066=a066*a072;
a082=a082+a066;
a003=a003+a082;
a165=a165*a078;
a063=a063*a072;
a165=a165+a063;
a003=a003+a165;
if (res[12]!=0) res[12][0]=a003;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_loaded_gear_position(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f55(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_loaded_gear_position_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_loaded_gear_position_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_loaded_gear_position_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_loaded_gear_position_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_loaded_gear_position_n_in(void) { return 63;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_loaded_gear_position_n_out(void) { return 13;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_loaded_gear_position_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_loaded_gear_position_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "b";
case 2: return "u";
case 3: return "rho";
case 4: return "Ap";
case 5: return "CL_gamma";
case 6: return "B3";
case 7: return "C3";
case 8: return "g";
case 9: return "K1";
case 10: return "K2";
case 11: return "K3";
case 12: return "K4";
case 13: return "out_p_0";
case 14: return "out_p_1";
case 15: return "out_p_2";
case 16: return "out_p_3";
case 17: return "out_p_4";
case 18: return "out_p_5";
case 19: return "adj_p_0";
case 20: return "adj_p_1";
case 21: return "adj_p_2";
case 22: return "adj_p_3";
case 23: return "adj_p_4";
case 24: return "adj_p_5";
case 25: return "out_adj_m";
case 26: return "out_adj_b";
case 27: return "out_adj_u";
case 28: return "out_adj_rho";
case 29: return "out_adj_Ap";
case 30: return "out_adj_CL_gamma";
case 31: return "out_adj_B3";
case 32: return "out_adj_C3";
case 33: return "out_adj_g";
case 34: return "out_adj_K1";
case 35: return "out_adj_K2";
case 36: return "out_adj_K3";
case 37: return "out_adj_K4";
case 38: return "fwd_m";
case 39: return "fwd_b";
case 40: return "fwd_u";
case 41: return "fwd_rho";
case 42: return "fwd_Ap";
case 43: return "fwd_CL_gamma";
case 44: return "fwd_B3";
case 45: return "fwd_C3";
case 46: return "fwd_g";
case 47: return "fwd_K1";
case 48: return "fwd_K2";
case 49: return "fwd_K3";
case 50: return "fwd_K4";
case 51: return "fwd_out_p_0";
case 52: return "fwd_out_p_1";
case 53: return "fwd_out_p_2";
case 54: return "fwd_out_p_3";
case 55: return "fwd_out_p_4";
case 56: return "fwd_out_p_5";
case 57: return "fwd_adj_p_0";
case 58: return "fwd_adj_p_1";
case 59: return "fwd_adj_p_2";
case 60: return "fwd_adj_p_3";
case 61: return "fwd_adj_p_4";
case 62: return "fwd_adj_p_5";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_loaded_gear_position_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_m";
case 1: return "fwd_adj_b";
case 2: return "fwd_adj_u";
case 3: return "fwd_adj_rho";
case 4: return "fwd_adj_Ap";
case 5: return "fwd_adj_CL_gamma";
case 6: return "fwd_adj_B3";
case 7: return "fwd_adj_C3";
case 8: return "fwd_adj_g";
case 9: return "fwd_adj_K1";
case 10: return "fwd_adj_K2";
case 11: return "fwd_adj_K3";
case 12: return "fwd_adj_K4";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_loaded_gear_position_sparsity_in(casadi_int i) {
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
case 11: return casadi_s0;
case 12: return casadi_s0;
case 13: return casadi_s1;
case 14: return casadi_s1;
case 15: return casadi_s1;
case 16: return casadi_s1;
case 17: return casadi_s1;
case 18: return casadi_s1;
case 19: return casadi_s0;
case 20: return casadi_s0;
case 21: return casadi_s0;
case 22: return casadi_s0;
case 23: return casadi_s0;
case 24: return casadi_s0;
case 25: return casadi_s1;
case 26: return casadi_s1;
case 27: return casadi_s1;
case 28: return casadi_s1;
case 29: return casadi_s1;
case 30: return casadi_s1;
case 31: return casadi_s1;
case 32: return casadi_s1;
case 33: return casadi_s1;
case 34: return casadi_s1;
case 35: return casadi_s1;
case 36: return casadi_s1;
case 37: return casadi_s1;
case 38: return casadi_s0;
case 39: return casadi_s0;
case 40: return casadi_s0;
case 41: return casadi_s0;
case 42: return casadi_s0;
case 43: return casadi_s0;
case 44: return casadi_s0;
case 45: return casadi_s0;
case 46: return casadi_s0;
case 47: return casadi_s0;
case 48: return casadi_s0;
case 49: return casadi_s0;
case 50: return casadi_s0;
case 51: return casadi_s1;
case 52: return casadi_s1;
case 53: return casadi_s1;
case 54: return casadi_s1;
case 55: return casadi_s1;
case 56: return casadi_s1;
case 57: return casadi_s0;
case 58: return casadi_s0;
case 59: return casadi_s0;
case 60: return casadi_s0;
case 61: return casadi_s0;
case 62: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_loaded_gear_position_sparsity_out(casadi_int i) {
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
case 11: return casadi_s0;
case 12: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_loaded_gear_position_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 63;
if (sz_res) *sz_res = 13;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_loaded_gear_position_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 63*sizeof(const casadi_real*);
if (sz_res) *sz_res = 13*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* loaded_gear_envelope:(m,b,rho,Ap,CL_gamma,B3,C3,g,K1,K2,K3,K4)->(g_0,g_1,g_2,g_3,g_4,g_5,g_6,g_7,g_8,g_9,g_10) */
static int casadi_f56(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20;
a00=arg[1]? arg[1][0] : 0;
a01=arg[7]? arg[7][0] : 0;
a02=a00*a01;
a03=5.0000000000000000e-01;
a04=arg[3]? arg[3][0] : 0;
a03=a03*a04;
a04=arg[4]? arg[4][0] : 0;
a03=a03*a04;
a04=arg[2]? arg[2][0] : 0;
a03=a03*a04;
a02=a02*a03;
a04=arg[5]? arg[5][0] : 0;
a05=2.*a04;
a06=arg[6]? arg[6][0] : 0;
a07=a06*a01;
a08=arg[0]? arg[0][0] : 0;
a07=a07*a08;
a05=a05+a07;
a02=a02*a05;
a09=casadi_sq(a02);
if (res[0]!=0) res[0][0]=a09;
a09=4.;
a10=arg[8]? arg[8][0] : 0;
a11=a10*a00;
a12=casadi_sq(a01);
a11=a11*a12;
a11=a11*a08;
a11=a11*a05;
a12=a09*a11;
a13=2.*a03;
a12=a12*a13;
a14=2.*a02;
a15=a01*a08;
a16=a06*a00;
a16=a16*a01;
a16=a16*a03;
a17=2.*a10;
a16=a16-a17;
a16=a16+a05;
a15=a15*a16;
a14=a14*a15;
a12=a12+a14;
a12=-a12;
if (res[1]!=0) res[1][0]=a12;
a12=-4.;
a11=a12*a11;
a14=-2.;
a03=a14*a03;
a11=a11*a03;
a16=casadi_sq(a01);
a16=a01*a16;
a16=a00*a16;
a05=casadi_sq(a08);
a16=a16*a05;
a05=2.*a04;
a17=arg[9]? arg[9][0] : 0;
a05=a05*a17;
a18=a06*a10;
a05=a05-a18;
a18=a06*a17;
a18=a18*a01;
a18=a18*a08;
a05=a05+a18;
a16=a16*a05;
a05=a09*a16;
a05=a05*a13;
a11=a11-a05;
a05=2.*a02;
a18=2.*a01;
a18=a18*a08;
a10=a04-a10;
a19=a17*a01;
a19=a19*a08;
a10=a10+a19;
a10=a10+a07;
a18=a18*a10;
a05=a05*a18;
a11=a11+a05;
a05=casadi_sq(a15);
a11=a11+a05;
if (res[2]!=0) res[2][0]=a11;
a16=a12*a16;
a16=a16*a03;
a11=casadi_sq(a01);
a11=casadi_sq(a11);
a11=a00*a11;
a05=casadi_sq(a08);
a05=a08*a05;
a11=a11*a05;
a05=2.*a04;
a10=arg[10]? arg[10][0] : 0;
a05=a05*a10;
a19=a06*a17;
a05=a05-a19;
a19=a06*a10;
a19=a19*a01;
a19=a19*a08;
a05=a05+a19;
a11=a11*a05;
a05=a09*a11;
a05=a05*a13;
a16=a16-a05;
a05=2.*a02;
a19=casadi_sq(a01);
a20=casadi_sq(a08);
a19=a19*a20;
a20=2.*a10;
a20=a20*a01;
a20=a20*a08;
a17=2.*a17;
a17=a06+a17;
a20=a20-a17;
a19=a19*a20;
a05=a05*a19;
a16=a16+a05;
a15=-a15;
a05=2.*a15;
a05=a05*a18;
a16=a16+a05;
if (res[3]!=0) res[3][0]=a16;
a11=a12*a11;
a11=a11*a03;
a16=casadi_sq(a01);
a16=casadi_sq(a16);
a16=a01*a16;
a16=a00*a16;
a05=casadi_sq(a08);
a05=casadi_sq(a05);
a16=a16*a05;
a04=2.*a04;
a05=arg[11]? arg[11][0] : 0;
a04=a04*a05;
a20=a06*a10;
a04=a04-a20;
a07=a05*a07;
a04=a04+a07;
a16=a16*a04;
a04=a09*a16;
a04=a04*a13;
a11=a11-a04;
a04=2.*a02;
a07=casadi_sq(a01);
a07=a01*a07;
a07=2.*a07;
a20=casadi_sq(a08);
a20=a08*a20;
a07=a07*a20;
a20=a05*a01;
a20=a20*a08;
a20=a20-a10;
a07=a07*a20;
a04=a04*a07;
a11=a11+a04;
a04=2.*a15;
a04=a04*a19;
a11=a11+a04;
a04=casadi_sq(a18);
a11=a11+a04;
if (res[4]!=0) res[4][0]=a11;
a16=a12*a16;
a16=a16*a03;
a06=a06*a05;
a06=a06*a00;
a00=casadi_sq(a01);
a00=a01*a00;
a00=casadi_sq(a00);
a06=a06*a00;
a00=casadi_sq(a08);
a00=casadi_sq(a00);
a00=a08*a00;
a06=a06*a00;
a09=a09*a06;
a09=a09*a13;
a16=a16+a09;
a02=2.*a02;
a14=a14*a05;
a01=casadi_sq(a01);
a01=casadi_sq(a01);
a14=a14*a01;
a08=casadi_sq(a08);
a08=casadi_sq(a08);
a14=a14*a08;
a02=a02*a14;
a16=a16+a02;
a02=2.*a15;
a02=a02*a07;
a16=a16+a02;
a02=2.*a18;
a02=a02*a19;
a16=a16+a02;
if (res[5]!=0) res[5][0]=a16;
a15=2.*a15;
a15=a15*a14;
a12=a12*a06;
a12=a12*a03;
a15=a15-a12;
a12=2.*a18;
a12=a12*a07;
a15=a15+a12;
a12=casadi_sq(a19);
a15=a15+a12;
if (res[6]!=0) res[6][0]=a15;
a18=2.*a18;
a18=a18*a14;
a15=2.*a19;
a15=a15*a07;
a18=a18+a15;
if (res[7]!=0) res[7][0]=a18;
a19=2.*a19;
a19=a19*a14;
a18=casadi_sq(a07);
a19=a19+a18;
if (res[8]!=0) res[8][0]=a19;
a07=2.*a07;
a07=a07*a14;
if (res[9]!=0) res[9][0]=a07;
a14=casadi_sq(a14);
if (res[10]!=0) res[10][0]=a14;
return 0;
}
CASADI_SYMBOL_EXPORT int loaded_gear_envelope(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f56(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int loaded_gear_envelope_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void loaded_gear_envelope_release(int mem) {
}
CASADI_SYMBOL_EXPORT void loaded_gear_envelope_incref(void) {
}
CASADI_SYMBOL_EXPORT void loaded_gear_envelope_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int loaded_gear_envelope_n_in(void) { return 12;}
CASADI_SYMBOL_EXPORT casadi_int loaded_gear_envelope_n_out(void) { return 11;}
CASADI_SYMBOL_EXPORT casadi_real loaded_gear_envelope_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* loaded_gear_envelope_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "b";
case 2: return "rho";
case 3: return "Ap";
case 4: return "CL_gamma";
case 5: return "B3";
case 6: return "C3";
case 7: return "g";
case 8: return "K1";
case 9: return "K2";
case 10: return "K3";
case 11: return "K4";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* loaded_gear_envelope_name_out(casadi_int i) {
switch (i) {
case 0: return "g_0";
case 1: return "g_1";
case 2: return "g_2";
case 3: return "g_3";
case 4: return "g_4";
case 5: return "g_5";
case 6: return "g_6";
case 7: return "g_7";
case 8: return "g_8";
case 9: return "g_9";
case 10: return "g_10";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* loaded_gear_envelope_sparsity_in(casadi_int i) {
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
case 11: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* loaded_gear_envelope_sparsity_out(casadi_int i) {
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
CASADI_SYMBOL_EXPORT int loaded_gear_envelope_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 12;
if (sz_res) *sz_res = 11;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int loaded_gear_envelope_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
if (sz_res) *sz_res = 11*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_loaded_gear_envelope:(m,b,rho,Ap,CL_gamma,B3,C3,g,K1,K2,K3,K4,out_g_0[1x1,0nz],out_g_1[1x1,0nz],out_g_2[1x1,0nz],out_g_3[1x1,0nz],out_g_4[1x1,0nz],out_g_5[1x1,0nz],out_g_6[1x1,0nz],out_g_7[1x1,0nz],out_g_8[1x1,0nz],out_g_9[1x1,0nz],out_g_10[1x1,0nz],fwd_m,fwd_b,fwd_rho,fwd_Ap,fwd_CL_gamma,fwd_B3,fwd_C3,fwd_g,fwd_K1,fwd_K2,fwd_K3,fwd_K4)->(fwd_g_0,fwd_g_1,fwd_g_2,fwd_g_3,fwd_g_4,fwd_g_5,fwd_g_6,fwd_g_7,fwd_g_8,fwd_g_9,fwd_g_10) */
static int casadi_f57(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40;
a00=arg[1]? arg[1][0] : 0;
a01=arg[7]? arg[7][0] : 0;
a02=a00*a01;
a03=5.0000000000000000e-01;
a04=arg[3]? arg[3][0] : 0;
a04=a03*a04;
a05=arg[4]? arg[4][0] : 0;
a06=a04*a05;
a07=arg[2]? arg[2][0] : 0;
a08=a06*a07;
a09=a02*a08;
a10=arg[5]? arg[5][0] : 0;
a11=2.*a10;
a12=arg[6]? arg[6][0] : 0;
a13=a12*a01;
a14=arg[0]? arg[0][0] : 0;
a15=a13*a14;
a11=a11+a15;
a16=a09*a11;
a17=2.*a16;
a18=arg[24]? arg[24][0] : 0;
a19=a01*a18;
a20=arg[30]? arg[30][0] : 0;
a21=a00*a20;
a19=a19+a21;
a19=a08*a19;
a21=arg[26]? arg[26][0] : 0;
a03=a03*a21;
a05=a05*a03;
a03=arg[27]? arg[27][0] : 0;
a04=a04*a03;
a05=a05+a04;
a07=a07*a05;
a05=arg[25]? arg[25][0] : 0;
a06=a06*a05;
a07=a07+a06;
a02=a02*a07;
a19=a19+a02;
a19=a11*a19;
a02=arg[28]? arg[28][0] : 0;
a06=2.*a02;
a05=arg[29]? arg[29][0] : 0;
a04=a01*a05;
a03=a12*a20;
a04=a04+a03;
a04=a14*a04;
a03=arg[23]? arg[23][0] : 0;
a13=a13*a03;
a04=a04+a13;
a06=a06+a04;
a09=a09*a06;
a19=a19+a09;
a17=a17*a19;
if (res[0]!=0) res[0][0]=a17;
a17=2.*a08;
a09=4.;
a13=casadi_sq(a01);
a21=arg[31]? arg[31][0] : 0;
a22=a00*a21;
a23=arg[8]? arg[8][0] : 0;
a24=a23*a18;
a22=a22+a24;
a22=a13*a22;
a24=a23*a00;
a25=2.*a01;
a25=a25*a20;
a25=a24*a25;
a22=a22+a25;
a22=a14*a22;
a24=a24*a13;
a13=a24*a03;
a22=a22+a13;
a22=a11*a22;
a24=a24*a14;
a13=a24*a06;
a22=a22+a13;
a13=a09*a22;
a13=a17*a13;
a24=a24*a11;
a25=a09*a24;
a26=2.*a07;
a25=a25*a26;
a13=a13+a25;
a25=a01*a14;
a27=a12*a00;
a28=a27*a01;
a29=a28*a08;
a30=2.*a23;
a29=a29-a30;
a29=a29+a11;
a11=a25*a29;
a30=2.*a19;
a30=a11*a30;
a31=2.*a16;
a32=a14*a20;
a33=a01*a03;
a32=a32+a33;
a29=a29*a32;
a32=a00*a05;
a33=a12*a18;
a32=a32+a33;
a32=a01*a32;
a27=a27*a20;
a32=a32+a27;
a32=a08*a32;
a28=a28*a07;
a32=a32+a28;
a28=2.*a21;
a32=a32-a28;
a32=a32+a06;
a25=a25*a32;
a29=a29+a25;
a31=a31*a29;
a30=a30+a31;
a13=a13+a30;
a13=-a13;
if (res[1]!=0) res[1][0]=a13;
a13=-2.;
a08=a13*a08;
a30=-4.;
a22=a30*a22;
a22=a08*a22;
a24=a30*a24;
a07=a13*a07;
a24=a24*a07;
a22=a22+a24;
a24=2.*a10;
a31=arg[9]? arg[9][0] : 0;
a25=a24*a31;
a32=a12*a23;
a25=a25-a32;
a32=a12*a31;
a06=a32*a01;
a28=a06*a14;
a25=a25+a28;
a28=casadi_sq(a14);
a27=casadi_sq(a01);
a33=a01*a27;
a34=a33*a18;
a27=a27*a20;
a35=2.*a01;
a35=a35*a20;
a35=a01*a35;
a27=a27+a35;
a27=a00*a27;
a34=a34+a27;
a34=a28*a34;
a33=a00*a33;
a27=2.*a14;
a27=a27*a03;
a27=a33*a27;
a34=a34+a27;
a34=a25*a34;
a33=a33*a28;
a28=2.*a02;
a28=a31*a28;
a27=arg[32]? arg[32][0] : 0;
a24=a24*a27;
a28=a28+a24;
a24=a23*a05;
a35=a12*a21;
a24=a24+a35;
a28=a28-a24;
a24=a31*a05;
a35=a12*a27;
a24=a24+a35;
a24=a01*a24;
a32=a32*a20;
a24=a24+a32;
a24=a14*a24;
a06=a06*a03;
a24=a24+a06;
a28=a28+a24;
a28=a33*a28;
a34=a34+a28;
a28=a09*a34;
a28=a17*a28;
a33=a33*a25;
a25=a09*a33;
a25=a25*a26;
a28=a28+a25;
a22=a22-a28;
a28=2.*a01;
a25=a28*a14;
a23=a10-a23;
a24=a31*a01;
a06=a24*a14;
a23=a23+a06;
a23=a23+a15;
a06=a25*a23;
a32=2.*a19;
a32=a06*a32;
a35=2.*a16;
a36=2.*a20;
a36=a14*a36;
a28=a28*a03;
a36=a36+a28;
a23=a23*a36;
a21=a02-a21;
a36=a01*a27;
a28=a31*a20;
a36=a36+a28;
a36=a14*a36;
a24=a24*a03;
a36=a36+a24;
a21=a21+a36;
a21=a21+a04;
a25=a25*a21;
a23=a23+a25;
a35=a35*a23;
a32=a32+a35;
a22=a22+a32;
a32=2.*a11;
a32=a32*a29;
a22=a22+a32;
if (res[2]!=0) res[2][0]=a22;
a34=a30*a34;
a34=a08*a34;
a33=a30*a33;
a33=a33*a07;
a34=a34+a33;
a33=2.*a10;
a22=arg[10]? arg[10][0] : 0;
a32=a33*a22;
a35=a12*a31;
a32=a32-a35;
a35=a12*a22;
a25=a35*a01;
a21=a25*a14;
a32=a32+a21;
a21=casadi_sq(a14);
a36=a14*a21;
a24=casadi_sq(a01);
a28=casadi_sq(a24);
a37=a28*a18;
a24=2.*a24;
a38=2.*a01;
a38=a38*a20;
a24=a24*a38;
a24=a00*a24;
a37=a37+a24;
a37=a36*a37;
a28=a00*a28;
a21=a21*a03;
a24=2.*a14;
a24=a24*a03;
a24=a14*a24;
a21=a21+a24;
a21=a28*a21;
a37=a37+a21;
a37=a32*a37;
a28=a28*a36;
a36=2.*a02;
a36=a22*a36;
a21=arg[33]? arg[33][0] : 0;
a33=a33*a21;
a36=a36+a33;
a33=a31*a05;
a24=a12*a27;
a33=a33+a24;
a36=a36-a33;
a33=a22*a05;
a24=a12*a21;
a33=a33+a24;
a33=a01*a33;
a35=a35*a20;
a33=a33+a35;
a33=a14*a33;
a25=a25*a03;
a33=a33+a25;
a36=a36+a33;
a36=a28*a36;
a37=a37+a36;
a36=a09*a37;
a36=a17*a36;
a28=a28*a32;
a32=a09*a28;
a32=a32*a26;
a36=a36+a32;
a34=a34-a36;
a36=casadi_sq(a01);
a32=casadi_sq(a14);
a33=a36*a32;
a25=2.*a22;
a35=a25*a01;
a24=a35*a14;
a31=2.*a31;
a31=a12+a31;
a24=a24-a31;
a31=a33*a24;
a38=2.*a19;
a38=a31*a38;
a39=2.*a16;
a40=2.*a01;
a40=a40*a20;
a32=a32*a40;
a40=2.*a14;
a40=a40*a03;
a36=a36*a40;
a32=a32+a36;
a24=a24*a32;
a32=2.*a21;
a32=a01*a32;
a25=a25*a20;
a32=a32+a25;
a32=a14*a32;
a35=a35*a03;
a32=a32+a35;
a27=2.*a27;
a27=a05+a27;
a32=a32-a27;
a33=a33*a32;
a24=a24+a33;
a39=a39*a24;
a38=a38+a39;
a34=a34+a38;
a29=-a29;
a38=2.*a29;
a38=a06*a38;
a11=-a11;
a39=2.*a11;
a39=a39*a23;
a38=a38+a39;
a34=a34+a38;
if (res[3]!=0) res[3][0]=a34;
a37=a30*a37;
a37=a08*a37;
a28=a30*a28;
a28=a28*a07;
a37=a37+a28;
a10=2.*a10;
a28=arg[11]? arg[11][0] : 0;
a34=a10*a28;
a38=a12*a22;
a34=a34-a38;
a38=a28*a15;
a34=a34+a38;
a38=casadi_sq(a14);
a39=casadi_sq(a38);
a33=casadi_sq(a01);
a32=casadi_sq(a33);
a27=a01*a32;
a35=a27*a18;
a32=a32*a20;
a33=2.*a33;
a25=2.*a01;
a25=a25*a20;
a33=a33*a25;
a33=a01*a33;
a32=a32+a33;
a32=a00*a32;
a35=a35+a32;
a35=a39*a35;
a27=a00*a27;
a38=2.*a38;
a32=2.*a14;
a32=a32*a03;
a38=a38*a32;
a38=a27*a38;
a35=a35+a38;
a35=a34*a35;
a27=a27*a39;
a02=2.*a02;
a02=a28*a02;
a39=arg[34]? arg[34][0] : 0;
a10=a10*a39;
a02=a02+a10;
a10=a22*a05;
a38=a12*a21;
a10=a10+a38;
a02=a02-a10;
a15=a15*a39;
a04=a28*a04;
a15=a15+a04;
a02=a02+a15;
a02=a27*a02;
a35=a35+a02;
a02=a09*a35;
a02=a17*a02;
a27=a27*a34;
a34=a09*a27;
a34=a34*a26;
a02=a02+a34;
a37=a37-a02;
a02=casadi_sq(a01);
a34=a01*a02;
a34=2.*a34;
a15=casadi_sq(a14);
a04=a14*a15;
a10=a34*a04;
a38=a28*a01;
a32=a38*a14;
a32=a32-a22;
a22=a10*a32;
a33=2.*a19;
a33=a22*a33;
a25=2.*a16;
a02=a02*a20;
a36=2.*a01;
a36=a36*a20;
a36=a01*a36;
a02=a02+a36;
a02=2.*a02;
a04=a04*a02;
a15=a15*a03;
a02=2.*a14;
a02=a02*a03;
a02=a14*a02;
a15=a15+a02;
a34=a34*a15;
a04=a04+a34;
a32=a32*a04;
a04=a01*a39;
a34=a28*a20;
a04=a04+a34;
a04=a14*a04;
a38=a38*a03;
a04=a04+a38;
a04=a04-a21;
a10=a10*a04;
a32=a32+a10;
a25=a25*a32;
a33=a33+a25;
a37=a37+a33;
a33=2.*a29;
a33=a31*a33;
a25=2.*a11;
a25=a25*a24;
a33=a33+a25;
a37=a37+a33;
a33=2.*a06;
a33=a33*a23;
a37=a37+a33;
if (res[4]!=0) res[4][0]=a37;
a35=a30*a35;
a35=a08*a35;
a27=a30*a27;
a27=a27*a07;
a35=a35+a27;
a27=casadi_sq(a14);
a37=casadi_sq(a27);
a33=a14*a37;
a25=casadi_sq(a01);
a10=a01*a25;
a04=casadi_sq(a10);
a05=a28*a05;
a21=a12*a39;
a05=a05+a21;
a05=a00*a05;
a12=a12*a28;
a18=a12*a18;
a05=a05+a18;
a05=a04*a05;
a12=a12*a00;
a10=2.*a10;
a25=a25*a20;
a00=2.*a01;
a00=a00*a20;
a00=a01*a00;
a25=a25+a00;
a10=a10*a25;
a10=a12*a10;
a05=a05+a10;
a05=a33*a05;
a12=a12*a04;
a37=a37*a03;
a27=2.*a27;
a04=2.*a14;
a04=a04*a03;
a27=a27*a04;
a27=a14*a27;
a37=a37+a27;
a37=a12*a37;
a05=a05+a37;
a37=a09*a05;
a17=a17*a37;
a12=a12*a33;
a09=a09*a12;
a09=a09*a26;
a17=a17+a09;
a35=a35+a17;
a28=a13*a28;
a17=casadi_sq(a01);
a09=casadi_sq(a17);
a26=a28*a09;
a33=casadi_sq(a14);
a37=casadi_sq(a33);
a27=a26*a37;
a19=2.*a19;
a19=a27*a19;
a16=2.*a16;
a13=a13*a39;
a09=a09*a13;
a17=2.*a17;
a01=2.*a01;
a01=a01*a20;
a17=a17*a01;
a28=a28*a17;
a09=a09+a28;
a37=a37*a09;
a33=2.*a33;
a14=2.*a14;
a14=a14*a03;
a33=a33*a14;
a26=a26*a33;
a37=a37+a26;
a16=a16*a37;
a19=a19+a16;
a35=a35+a19;
a19=2.*a29;
a19=a22*a19;
a16=2.*a11;
a16=a16*a32;
a19=a19+a16;
a35=a35+a19;
a19=2.*a23;
a19=a31*a19;
a16=2.*a06;
a16=a16*a24;
a19=a19+a16;
a35=a35+a19;
if (res[5]!=0) res[5][0]=a35;
a29=2.*a29;
a29=a27*a29;
a11=2.*a11;
a11=a11*a37;
a29=a29+a11;
a05=a30*a05;
a08=a08*a05;
a30=a30*a12;
a30=a30*a07;
a08=a08+a30;
a29=a29-a08;
a08=2.*a23;
a08=a22*a08;
a30=2.*a06;
a30=a30*a32;
a08=a08+a30;
a29=a29+a08;
a08=2.*a31;
a08=a08*a24;
a29=a29+a08;
if (res[6]!=0) res[6][0]=a29;
a23=2.*a23;
a23=a27*a23;
a06=2.*a06;
a06=a06*a37;
a23=a23+a06;
a06=2.*a24;
a06=a22*a06;
a29=2.*a31;
a29=a29*a32;
a06=a06+a29;
a23=a23+a06;
if (res[7]!=0) res[7][0]=a23;
a24=2.*a24;
a24=a27*a24;
a31=2.*a31;
a31=a31*a37;
a24=a24+a31;
a31=2.*a22;
a31=a31*a32;
a24=a24+a31;
if (res[8]!=0) res[8][0]=a24;
a32=2.*a32;
a32=a27*a32;
a22=2.*a22;
a22=a22*a37;
a32=a32+a22;
if (res[9]!=0) res[9][0]=a32;
a27=2.*a27;
a27=a27*a37;
if (res[10]!=0) res[10][0]=a27;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_loaded_gear_envelope(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f57(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_loaded_gear_envelope_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_loaded_gear_envelope_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_loaded_gear_envelope_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_loaded_gear_envelope_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_loaded_gear_envelope_n_in(void) { return 35;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_loaded_gear_envelope_n_out(void) { return 11;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_loaded_gear_envelope_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_loaded_gear_envelope_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "b";
case 2: return "rho";
case 3: return "Ap";
case 4: return "CL_gamma";
case 5: return "B3";
case 6: return "C3";
case 7: return "g";
case 8: return "K1";
case 9: return "K2";
case 10: return "K3";
case 11: return "K4";
case 12: return "out_g_0";
case 13: return "out_g_1";
case 14: return "out_g_2";
case 15: return "out_g_3";
case 16: return "out_g_4";
case 17: return "out_g_5";
case 18: return "out_g_6";
case 19: return "out_g_7";
case 20: return "out_g_8";
case 21: return "out_g_9";
case 22: return "out_g_10";
case 23: return "fwd_m";
case 24: return "fwd_b";
case 25: return "fwd_rho";
case 26: return "fwd_Ap";
case 27: return "fwd_CL_gamma";
case 28: return "fwd_B3";
case 29: return "fwd_C3";
case 30: return "fwd_g";
case 31: return "fwd_K1";
case 32: return "fwd_K2";
case 33: return "fwd_K3";
case 34: return "fwd_K4";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_loaded_gear_envelope_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_g_0";
case 1: return "fwd_g_1";
case 2: return "fwd_g_2";
case 3: return "fwd_g_3";
case 4: return "fwd_g_4";
case 5: return "fwd_g_5";
case 6: return "fwd_g_6";
case 7: return "fwd_g_7";
case 8: return "fwd_g_8";
case 9: return "fwd_g_9";
case 10: return "fwd_g_10";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_loaded_gear_envelope_sparsity_in(casadi_int i) {
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
case 11: return casadi_s0;
case 12: return casadi_s1;
case 13: return casadi_s1;
case 14: return casadi_s1;
case 15: return casadi_s1;
case 16: return casadi_s1;
case 17: return casadi_s1;
case 18: return casadi_s1;
case 19: return casadi_s1;
case 20: return casadi_s1;
case 21: return casadi_s1;
case 22: return casadi_s1;
case 23: return casadi_s0;
case 24: return casadi_s0;
case 25: return casadi_s0;
case 26: return casadi_s0;
case 27: return casadi_s0;
case 28: return casadi_s0;
case 29: return casadi_s0;
case 30: return casadi_s0;
case 31: return casadi_s0;
case 32: return casadi_s0;
case 33: return casadi_s0;
case 34: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_loaded_gear_envelope_sparsity_out(casadi_int i) {
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
CASADI_SYMBOL_EXPORT int fwd1_loaded_gear_envelope_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 35;
if (sz_res) *sz_res = 11;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_loaded_gear_envelope_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 35*sizeof(const casadi_real*);
if (sz_res) *sz_res = 11*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_loaded_gear_envelope:(m,b,rho,Ap,CL_gamma,B3,C3,g,K1,K2,K3,K4,out_g_0[1x1,0nz],out_g_1[1x1,0nz],out_g_2[1x1,0nz],out_g_3[1x1,0nz],out_g_4[1x1,0nz],out_g_5[1x1,0nz],out_g_6[1x1,0nz],out_g_7[1x1,0nz],out_g_8[1x1,0nz],out_g_9[1x1,0nz],out_g_10[1x1,0nz],adj_g_0,adj_g_1,adj_g_2,adj_g_3,adj_g_4,adj_g_5,adj_g_6,adj_g_7,adj_g_8,adj_g_9,adj_g_10)->(adj_m,adj_b,adj_rho,adj_Ap,adj_CL_gamma,adj_B3,adj_C3,adj_g,adj_K1,adj_K2,adj_K3,adj_K4) */
static int casadi_f58(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
casadi_real a72, a73, a74, a75, a76, a77, a78, a79, a80, a81, a82, a83;
casadi_real a84, a85, a86, a87, a88, a89, a90, a91, a92, a93, a94, a95;
a00=arg[0]? arg[0][0] : 0;
a01=2.*a00;
a02=casadi_sq(a00);
a03=2.*a02;
a04=-2.;
a05=arg[11]? arg[11][0] : 0;
a06=a04*a05;
a07=arg[7]? arg[7][0] : 0;
a08=casadi_sq(a07);
a09=casadi_sq(a08);
a10=a06*a09;
a02=casadi_sq(a02);
a11=a10*a02;
a12=2.*a11;
a13=arg[33]? arg[33][0] : 0;
a12=a12*a13;
a13=casadi_sq(a07);
a14=a07*a13;
a14=2.*a14;
a15=casadi_sq(a00);
a16=a00*a15;
a17=a14*a16;
a18=a05*a07;
a19=a18*a00;
a20=arg[10]? arg[10][0] : 0;
a19=a19-a20;
a21=a17*a19;
a22=2.*a21;
a23=arg[32]? arg[32][0] : 0;
a22=a22*a23;
a12=a12+a22;
a22=casadi_sq(a07);
a24=casadi_sq(a00);
a25=a22*a24;
a26=2.*a20;
a27=a26*a07;
a28=a27*a00;
a29=arg[6]? arg[6][0] : 0;
a30=arg[9]? arg[9][0] : 0;
a31=2.*a30;
a31=a29+a31;
a28=a28-a31;
a31=a25*a28;
a32=2.*a31;
a33=arg[31]? arg[31][0] : 0;
a32=a32*a33;
a12=a12+a32;
a32=2.*a07;
a34=a32*a00;
a35=arg[5]? arg[5][0] : 0;
a36=arg[8]? arg[8][0] : 0;
a37=a35-a36;
a38=a30*a07;
a39=a38*a00;
a37=a37+a39;
a39=a29*a07;
a40=a39*a00;
a37=a37+a40;
a41=a34*a37;
a42=2.*a41;
a43=arg[30]? arg[30][0] : 0;
a42=a42*a43;
a12=a12+a42;
a42=a07*a00;
a44=arg[1]? arg[1][0] : 0;
a45=a29*a44;
a46=a45*a07;
a47=5.0000000000000000e-01;
a48=arg[3]? arg[3][0] : 0;
a48=a47*a48;
a49=arg[4]? arg[4][0] : 0;
a50=a48*a49;
a51=arg[2]? arg[2][0] : 0;
a52=a50*a51;
a53=a46*a52;
a54=2.*a36;
a53=a53-a54;
a54=2.*a35;
a54=a54+a40;
a53=a53+a54;
a55=a42*a53;
a56=-a55;
a57=2.*a56;
a58=arg[29]? arg[29][0] : 0;
a57=a57*a58;
a12=a12+a57;
a57=a44*a07;
a59=a57*a52;
a60=a59*a54;
a61=2.*a60;
a62=arg[28]? arg[28][0] : 0;
a61=a61*a62;
a12=a12+a61;
a10=a10*a12;
a03=a03*a10;
a01=a01*a03;
a03=casadi_sq(a00);
a10=casadi_sq(a03);
a61=a29*a05;
a63=a61*a44;
a64=casadi_sq(a07);
a65=a07*a64;
a66=casadi_sq(a65);
a67=a63*a66;
a68=4.;
a69=2.*a52;
a70=a69*a62;
a70=a68*a70;
a71=-4.;
a72=a04*a52;
a73=a72*a58;
a73=a71*a73;
a70=a70-a73;
a73=a67*a70;
a74=a10*a73;
a01=a01+a74;
a74=2.*a00;
a03=2.*a03;
a73=a00*a73;
a03=a03*a73;
a74=a74*a03;
a01=a01+a74;
a23=a11*a23;
a23=2.*a23;
a74=2.*a21;
a74=a74*a33;
a23=a23+a74;
a74=2.*a31;
a74=a74*a43;
a23=a23+a74;
a74=2.*a41;
a74=a74*a58;
a23=a23+a74;
a74=2.*a56;
a74=a74*a62;
a23=a23+a74;
a74=2.*a60;
a03=arg[27]? arg[27][0] : 0;
a74=a74*a03;
a23=a23+a74;
a17=a17*a23;
a18=a18*a17;
a01=a01+a18;
a19=a19*a23;
a14=a14*a19;
a15=a15*a14;
a01=a01+a15;
a15=2.*a00;
a14=a00*a14;
a15=a15*a14;
a01=a01+a15;
a15=2.*a00;
a14=casadi_sq(a00);
a23=2.*a14;
a18=casadi_sq(a07);
a74=casadi_sq(a18);
a73=a07*a74;
a75=a44*a73;
a76=2.*a35;
a77=a76*a05;
a78=a29*a20;
a77=a77-a78;
a78=a05*a40;
a77=a77+a78;
a78=a72*a62;
a78=a71*a78;
a79=a69*a03;
a79=a68*a79;
a78=a78-a79;
a79=a77*a78;
a80=a75*a79;
a23=a23*a80;
a15=a15*a23;
a01=a01+a15;
a33=a11*a33;
a33=2.*a33;
a15=a21*a43;
a15=2.*a15;
a33=a33+a15;
a15=2.*a31;
a15=a15*a58;
a33=a33+a15;
a15=2.*a41;
a15=a15*a62;
a33=a33+a15;
a15=2.*a56;
a15=a15*a03;
a33=a33+a15;
a15=2.*a60;
a23=arg[26]? arg[26][0] : 0;
a15=a15*a23;
a33=a33+a15;
a25=a25*a33;
a27=a27*a25;
a01=a01+a27;
a27=2.*a00;
a28=a28*a33;
a22=a22*a28;
a27=a27*a22;
a01=a01+a27;
a27=a29*a20;
a22=a27*a07;
a33=casadi_sq(a07);
a15=casadi_sq(a33);
a80=a44*a15;
a81=casadi_sq(a00);
a82=a00*a81;
a83=a80*a82;
a84=a72*a03;
a84=a71*a84;
a85=a69*a23;
a85=a68*a85;
a84=a84-a85;
a85=a83*a84;
a86=a22*a85;
a01=a01+a86;
a86=2.*a35;
a87=a86*a20;
a88=a29*a30;
a87=a87-a88;
a22=a22*a00;
a87=a87+a22;
a84=a87*a84;
a80=a80*a84;
a81=a81*a80;
a01=a01+a81;
a81=2.*a00;
a80=a00*a80;
a81=a81*a80;
a01=a01+a81;
a43=a11*a43;
a43=2.*a43;
a81=a21*a58;
a81=2.*a81;
a43=a43+a81;
a81=a31*a62;
a81=2.*a81;
a43=a43+a81;
a81=2.*a41;
a81=a81*a03;
a43=a43+a81;
a56=2.*a56;
a56=a56*a23;
a43=a43+a56;
a56=2.*a60;
a81=arg[25]? arg[25][0] : 0;
a56=a56*a81;
a43=a43+a56;
a34=a34*a43;
a38=a38*a34;
a01=a01+a38;
a37=a37*a43;
a32=a32*a37;
a01=a01+a32;
a32=a29*a30;
a43=a32*a07;
a38=casadi_sq(a07);
a56=a07*a38;
a80=a44*a56;
a22=casadi_sq(a00);
a88=a80*a22;
a89=a72*a23;
a89=a71*a89;
a90=a69*a81;
a90=a68*a90;
a89=a89-a90;
a90=a88*a89;
a91=a43*a90;
a01=a01+a91;
a91=2.*a00;
a35=2.*a35;
a92=a35*a30;
a93=a29*a36;
a92=a92-a93;
a43=a43*a00;
a92=a92+a43;
a89=a92*a89;
a80=a80*a89;
a91=a91*a80;
a01=a01+a91;
a91=2.*a55;
a91=a91*a81;
a80=a11*a58;
a80=2.*a80;
a43=a21*a62;
a43=2.*a43;
a80=a80+a43;
a43=a31*a03;
a43=2.*a43;
a80=a80+a43;
a43=a41*a23;
a43=2.*a43;
a80=a80+a43;
a91=a91-a80;
a80=2.*a60;
a43=arg[24]? arg[24][0] : 0;
a80=a80*a43;
a91=a91-a80;
a53=a53*a91;
a80=a07*a53;
a01=a01+a80;
a80=a36*a44;
a93=casadi_sq(a07);
a94=a80*a93;
a72=a72*a81;
a72=a71*a72;
a69=a69*a43;
a69=a68*a69;
a72=a72-a69;
a69=a54*a72;
a95=a94*a69;
a01=a01+a95;
a14=casadi_sq(a14);
a75=a75*a14;
a78=a75*a78;
a95=a05*a78;
a95=a95+a34;
a42=a42*a91;
a94=a94*a00;
a72=a94*a72;
a72=a42+a72;
a11=a11*a62;
a11=2.*a11;
a21=a21*a03;
a21=2.*a21;
a11=a11+a21;
a31=a31*a23;
a31=2.*a31;
a11=a11+a31;
a41=a41*a81;
a41=2.*a41;
a11=a11+a41;
a55=a55*a43;
a55=-a55;
a55=2.*a55;
a11=a11+a55;
a60=2.*a60;
a55=arg[23]? arg[23][0] : 0;
a60=a60*a55;
a11=a11+a60;
a59=a59*a11;
a72=a72+a59;
a95=a95+a72;
a39=a39*a95;
a01=a01+a39;
if (res[0]!=0) res[0][0]=a01;
a10=a00*a10;
a70=a10*a70;
a66=a66*a70;
a61=a61*a66;
a14=a14*a79;
a73=a73*a14;
a61=a61+a73;
a82=a82*a84;
a15=a15*a82;
a61=a61+a15;
a22=a22*a89;
a56=a56*a22;
a61=a61+a56;
a56=a52*a42;
a89=a07*a56;
a15=a29*a89;
a61=a61+a15;
a69=a00*a69;
a93=a93*a69;
a15=a36*a93;
a61=a61+a15;
a11=a54*a11;
a52=a52*a11;
a15=a07*a52;
a61=a61+a15;
if (res[1]!=0) res[1][0]=a61;
a75=a75*a77;
a77=a71*a75;
a77=a77*a62;
a67=a67*a10;
a10=a71*a67;
a10=a10*a58;
a77=a77-a10;
a83=a83*a87;
a87=a71*a83;
a87=a87*a03;
a77=a77+a87;
a88=a88*a92;
a92=a71*a88;
a92=a92*a23;
a77=a77+a92;
a94=a94*a54;
a71=a71*a94;
a71=a71*a81;
a77=a77+a71;
a77=a04*a77;
a46=a46*a42;
a77=a77+a46;
a67=a68*a67;
a67=a67*a62;
a75=a68*a75;
a75=a75*a03;
a67=a67-a75;
a83=a68*a83;
a83=a83*a23;
a67=a67-a83;
a88=a68*a88;
a88=a88*a81;
a67=a67-a88;
a68=a68*a94;
a68=a68*a43;
a67=a67-a68;
a67=2.*a67;
a77=a77+a67;
a57=a57*a11;
a77=a77+a57;
a50=a50*a77;
if (res[2]!=0) res[2][0]=a50;
a51=a51*a77;
a49=a49*a51;
a47=a47*a49;
if (res[3]!=0) res[3][0]=a47;
a48=a48*a51;
if (res[4]!=0) res[4][0]=a48;
a48=a05*a78;
a48=2.*a48;
a51=a20*a85;
a51=2.*a51;
a48=a48+a51;
a48=a48+a34;
a51=a30*a90;
a51=2.*a51;
a48=a48+a51;
a72=2.*a72;
a48=a48+a72;
if (res[5]!=0) res[5][0]=a48;
a66=a44*a66;
a48=a05*a66;
a72=a20*a78;
a48=a48-a72;
a48=a48-a25;
a72=a00*a85;
a51=a07*a72;
a20=a20*a51;
a48=a48+a20;
a20=a30*a85;
a48=a48-a20;
a20=a00*a90;
a47=a07*a20;
a49=a30*a47;
a48=a48+a49;
a36=a36*a90;
a48=a48-a36;
a89=a44*a89;
a48=a48+a89;
a95=a00*a95;
a89=a07*a95;
a48=a48+a89;
if (res[6]!=0) res[6][0]=a48;
a48=2.*a07;
a08=2.*a08;
a02=a02*a12;
a06=a06*a02;
a08=a08*a06;
a48=a48*a08;
a65=2.*a65;
a63=a63*a70;
a65=a65*a63;
a64=a64*a65;
a48=a48+a64;
a64=2.*a07;
a65=a07*a65;
a64=a64*a65;
a48=a48+a64;
a64=a00*a17;
a05=a05*a64;
a48=a48+a05;
a16=a16*a19;
a16=2.*a16;
a13=a13*a16;
a48=a48+a13;
a13=2.*a07;
a16=a07*a16;
a13=a13*a16;
a48=a48+a13;
a14=a44*a14;
a74=a74*a14;
a48=a48+a74;
a74=2.*a07;
a18=2.*a18;
a14=a07*a14;
a18=a18*a14;
a74=a74*a18;
a48=a48+a74;
a74=a00*a25;
a26=a26*a74;
a48=a48+a26;
a26=2.*a07;
a24=a24*a28;
a26=a26*a24;
a48=a48+a26;
a27=a27*a72;
a48=a48+a27;
a27=2.*a07;
a33=2.*a33;
a82=a44*a82;
a33=a33*a82;
a27=a27*a33;
a48=a48+a27;
a27=a00*a34;
a30=a30*a27;
a48=a48+a30;
a37=a00*a37;
a37=2.*a37;
a48=a48+a37;
a32=a32*a20;
a48=a48+a32;
a22=a44*a22;
a38=a38*a22;
a48=a48+a38;
a38=2.*a07;
a22=a07*a22;
a38=a38*a22;
a48=a48+a38;
a45=a45*a56;
a48=a48+a45;
a00=a00*a53;
a48=a48+a00;
a00=2.*a07;
a80=a80*a69;
a00=a00*a80;
a48=a48+a00;
a95=a29*a95;
a48=a48+a95;
a52=a44*a52;
a48=a48+a52;
if (res[7]!=0) res[7][0]=a48;
a42=-a42;
a42=2.*a42;
a48=a29*a90;
a34=a34+a48;
a42=a42-a34;
a44=a44*a93;
a42=a42+a44;
if (res[8]!=0) res[8][0]=a42;
a25=-a25;
a25=2.*a25;
a42=a29*a85;
a25=a25-a42;
a27=a07*a27;
a25=a25+a27;
a47=a29*a47;
a25=a25+a47;
a35=a35*a90;
a25=a25+a35;
if (res[9]!=0) res[9][0]=a25;
a74=a07*a74;
a74=2.*a74;
a25=a29*a78;
a17=a17+a25;
a74=a74-a17;
a51=a29*a51;
a74=a74+a51;
a86=a86*a85;
a74=a74+a86;
if (res[10]!=0) res[10][0]=a74;
a09=a09*a02;
a04=a04*a09;
a29=a29*a66;
a04=a04+a29;
a07=a07*a64;
a04=a04+a07;
a40=a40*a78;
a04=a04+a40;
a76=a76*a78;
a04=a04+a76;
if (res[11]!=0) res[11][0]=a04;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_loaded_gear_envelope(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f58(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_loaded_gear_envelope_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_loaded_gear_envelope_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_loaded_gear_envelope_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_loaded_gear_envelope_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_loaded_gear_envelope_n_in(void) { return 34;}
CASADI_SYMBOL_EXPORT casadi_int adj1_loaded_gear_envelope_n_out(void) { return 12;}
CASADI_SYMBOL_EXPORT casadi_real adj1_loaded_gear_envelope_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_loaded_gear_envelope_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "b";
case 2: return "rho";
case 3: return "Ap";
case 4: return "CL_gamma";
case 5: return "B3";
case 6: return "C3";
case 7: return "g";
case 8: return "K1";
case 9: return "K2";
case 10: return "K3";
case 11: return "K4";
case 12: return "out_g_0";
case 13: return "out_g_1";
case 14: return "out_g_2";
case 15: return "out_g_3";
case 16: return "out_g_4";
case 17: return "out_g_5";
case 18: return "out_g_6";
case 19: return "out_g_7";
case 20: return "out_g_8";
case 21: return "out_g_9";
case 22: return "out_g_10";
case 23: return "adj_g_0";
case 24: return "adj_g_1";
case 25: return "adj_g_2";
case 26: return "adj_g_3";
case 27: return "adj_g_4";
case 28: return "adj_g_5";
case 29: return "adj_g_6";
case 30: return "adj_g_7";
case 31: return "adj_g_8";
case 32: return "adj_g_9";
case 33: return "adj_g_10";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_loaded_gear_envelope_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_m";
case 1: return "adj_b";
case 2: return "adj_rho";
case 3: return "adj_Ap";
case 4: return "adj_CL_gamma";
case 5: return "adj_B3";
case 6: return "adj_C3";
case 7: return "adj_g";
case 8: return "adj_K1";
case 9: return "adj_K2";
case 10: return "adj_K3";
case 11: return "adj_K4";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_loaded_gear_envelope_sparsity_in(casadi_int i) {
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
case 11: return casadi_s0;
case 12: return casadi_s1;
case 13: return casadi_s1;
case 14: return casadi_s1;
case 15: return casadi_s1;
case 16: return casadi_s1;
case 17: return casadi_s1;
case 18: return casadi_s1;
case 19: return casadi_s1;
case 20: return casadi_s1;
case 21: return casadi_s1;
case 22: return casadi_s1;
case 23: return casadi_s0;
case 24: return casadi_s0;
case 25: return casadi_s0;
case 26: return casadi_s0;
case 27: return casadi_s0;
case 28: return casadi_s0;
case 29: return casadi_s0;
case 30: return casadi_s0;
case 31: return casadi_s0;
case 32: return casadi_s0;
case 33: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_loaded_gear_envelope_sparsity_out(casadi_int i) {
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
case 11: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_loaded_gear_envelope_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 34;
if (sz_res) *sz_res = 12;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_loaded_gear_envelope_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 34*sizeof(const casadi_real*);
if (sz_res) *sz_res = 12*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_loaded_gear_envelope:(m,b,rho,Ap,CL_gamma,B3,C3,g,K1,K2,K3,K4,out_g_0[1x1,0nz],out_g_1[1x1,0nz],out_g_2[1x1,0nz],out_g_3[1x1,0nz],out_g_4[1x1,0nz],out_g_5[1x1,0nz],out_g_6[1x1,0nz],out_g_7[1x1,0nz],out_g_8[1x1,0nz],out_g_9[1x1,0nz],out_g_10[1x1,0nz],adj_g_0,adj_g_1,adj_g_2,adj_g_3,adj_g_4,adj_g_5,adj_g_6,adj_g_7,adj_g_8,adj_g_9,adj_g_10,out_adj_m[1x1,0nz],out_adj_b[1x1,0nz],out_adj_rho[1x1,0nz],out_adj_Ap[1x1,0nz],out_adj_CL_gamma[1x1,0nz],out_adj_B3[1x1,0nz],out_adj_C3[1x1,0nz],out_adj_g[1x1,0nz],out_adj_K1[1x1,0nz],out_adj_K2[1x1,0nz],out_adj_K3[1x1,0nz],out_adj_K4[1x1,0nz],fwd_m,fwd_b,fwd_rho,fwd_Ap,fwd_CL_gamma,fwd_B3,fwd_C3,fwd_g,fwd_K1,fwd_K2,fwd_K3,fwd_K4,fwd_out_g_0[1x1,0nz],fwd_out_g_1[1x1,0nz],fwd_out_g_2[1x1,0nz],fwd_out_g_3[1x1,0nz],fwd_out_g_4[1x1,0nz],fwd_out_g_5[1x1,0nz],fwd_out_g_6[1x1,0nz],fwd_out_g_7[1x1,0nz],fwd_out_g_8[1x1,0nz],fwd_out_g_9[1x1,0nz],fwd_out_g_10[1x1,0nz],fwd_adj_g_0,fwd_adj_g_1,fwd_adj_g_2,fwd_adj_g_3,fwd_adj_g_4,fwd_adj_g_5,fwd_adj_g_6,fwd_adj_g_7,fwd_adj_g_8,fwd_adj_g_9,fwd_adj_g_10)->(fwd_adj_m,fwd_adj_b,fwd_adj_rho,fwd_adj_Ap,fwd_adj_CL_gamma,fwd_adj_B3,fwd_adj_C3,fwd_adj_g,fwd_adj_K1,fwd_adj_K2,fwd_adj_K3,fwd_adj_K4) */
static int casadi_f59(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a000, a001, a002, a003, a004, a005, a006, a007, a008, a009, a010, a011;
casadi_real a012, a013, a014, a015, a016, a017, a018, a019, a020, a021, a022, a023;
casadi_real a024, a025, a026, a027, a028, a029, a030, a031, a032, a033, a034, a035;
casadi_real a036, a037, a038, a039, a040, a041, a042, a043, a044, a045, a046, a047;
casadi_real a048, a049, a050, a051, a052, a053, a054, a055, a056, a057, a058, a059;
casadi_real a060, a061, a062, a063, a064, a065, a066, a067, a068, a069, a070, a071;
casadi_real a072, a073, a074, a075, a076, a077, a078, a079, a080, a081, a082, a083;
casadi_real a084, a085, a086, a087, a088, a089, a090, a091, a092, a093, a094, a095;
casadi_real a096, a097, a098, a099, a100, a101, a102, a103, a104, a105, a106, a107;
casadi_real a108, a109, a110, a111, a112, a113, a114, a115, a116, a117, a118, a119;
casadi_real a120, a121, a122, a123, a124, a125, a126, a127, a128, a129, a130, a131;
casadi_real a132, a133, a134, a135, a136, a137, a138, a139, a140, a141, a142, a143;
casadi_real a144, a145, a146, a147, a148, a149, a150, a151, a152, a153, a154, a155;
casadi_real a156, a157, a158, a159, a160, a161, a162, a163, a164, a165, a166, a167;
casadi_real a168, a169, a170, a171, a172, a173, a174, a175, a176, a177, a178, a179;
casadi_real a180, a181, a182, a183, a184, a185, a186, a187, a188, a189, a190, a191;
casadi_real a192, a193, a194;
a000=arg[0]? arg[0][0] : 0;
a001=casadi_sq(a000);
a002=2.*a001;
a003=-2.;
a004=arg[11]? arg[11][0] : 0;
a005=a003*a004;
a006=arg[7]? arg[7][0] : 0;
a007=casadi_sq(a006);
a008=casadi_sq(a007);
a009=a005*a008;
a010=casadi_sq(a001);
a011=a009*a010;
a012=2.*a011;
a013=arg[33]? arg[33][0] : 0;
a014=a012*a013;
a015=casadi_sq(a006);
a016=a006*a015;
a016=2.*a016;
a017=casadi_sq(a000);
a018=a000*a017;
a019=a016*a018;
a020=a004*a006;
a021=a020*a000;
a022=arg[10]? arg[10][0] : 0;
a021=a021-a022;
a023=a019*a021;
a024=2.*a023;
a025=arg[32]? arg[32][0] : 0;
a026=a024*a025;
a014=a014+a026;
a026=casadi_sq(a006);
a027=casadi_sq(a000);
a028=a026*a027;
a029=2.*a022;
a030=a029*a006;
a031=a030*a000;
a032=arg[6]? arg[6][0] : 0;
a033=arg[9]? arg[9][0] : 0;
a034=2.*a033;
a034=a032+a034;
a031=a031-a034;
a034=a028*a031;
a035=2.*a034;
a036=arg[31]? arg[31][0] : 0;
a037=a035*a036;
a014=a014+a037;
a037=2.*a006;
a038=a037*a000;
a039=arg[5]? arg[5][0] : 0;
a040=arg[8]? arg[8][0] : 0;
a041=a039-a040;
a042=a033*a006;
a043=a042*a000;
a041=a041+a043;
a043=a032*a006;
a044=a043*a000;
a041=a041+a044;
a045=a038*a041;
a046=2.*a045;
a047=arg[30]? arg[30][0] : 0;
a048=a046*a047;
a014=a014+a048;
a048=a006*a000;
a049=arg[1]? arg[1][0] : 0;
a050=a032*a049;
a051=a050*a006;
a052=5.0000000000000000e-01;
a053=arg[3]? arg[3][0] : 0;
a053=a052*a053;
a054=arg[4]? arg[4][0] : 0;
a055=a053*a054;
a056=arg[2]? arg[2][0] : 0;
a057=a055*a056;
a058=a051*a057;
a059=2.*a040;
a058=a058-a059;
a059=2.*a039;
a059=a059+a044;
a058=a058+a059;
a060=a048*a058;
a061=-a060;
a062=2.*a061;
a063=arg[29]? arg[29][0] : 0;
a064=a062*a063;
a014=a014+a064;
a064=a049*a006;
a065=a064*a057;
a066=a065*a059;
a067=2.*a066;
a068=arg[28]? arg[28][0] : 0;
a069=a067*a068;
a014=a014+a069;
a069=a009*a014;
a070=a002*a069;
a071=arg[46]? arg[46][0] : 0;
a072=2.*a071;
a070=a070*a072;
a072=2.*a000;
a073=2.*a000;
a073=a073*a071;
a074=2.*a073;
a069=a069*a074;
a074=arg[57]? arg[57][0] : 0;
a075=a003*a074;
a076=a008*a075;
a077=2.*a007;
a078=2.*a006;
a079=arg[53]? arg[53][0] : 0;
a078=a078*a079;
a077=a077*a078;
a080=a005*a077;
a076=a076+a080;
a080=a014*a076;
a076=a010*a076;
a001=2.*a001;
a001=a001*a073;
a073=a009*a001;
a076=a076+a073;
a073=2.*a076;
a013=a013*a073;
a073=arg[79]? arg[79][0] : 0;
a012=a012*a073;
a013=a013+a012;
a012=a015*a079;
a073=2.*a006;
a073=a073*a079;
a081=a006*a073;
a012=a012+a081;
a012=2.*a012;
a081=a018*a012;
a082=a017*a071;
a083=2.*a000;
a083=a083*a071;
a084=a000*a083;
a082=a082+a084;
a084=a016*a082;
a081=a081+a084;
a084=a021*a081;
a085=a006*a074;
a086=a004*a079;
a085=a085+a086;
a086=a000*a085;
a087=a020*a071;
a086=a086+a087;
a087=arg[56]? arg[56][0] : 0;
a086=a086-a087;
a088=a019*a086;
a084=a084+a088;
a088=2.*a084;
a088=a025*a088;
a089=arg[78]? arg[78][0] : 0;
a024=a024*a089;
a088=a088+a024;
a013=a013+a088;
a088=2.*a006;
a088=a088*a079;
a024=a027*a088;
a090=2.*a000;
a090=a090*a071;
a091=a026*a090;
a024=a024+a091;
a091=a031*a024;
a092=2.*a087;
a093=a006*a092;
a094=a029*a079;
a093=a093+a094;
a094=a000*a093;
a095=a030*a071;
a094=a094+a095;
a095=arg[52]? arg[52][0] : 0;
a096=arg[55]? arg[55][0] : 0;
a097=2.*a096;
a097=a095+a097;
a094=a094-a097;
a097=a028*a094;
a091=a091+a097;
a097=2.*a091;
a097=a036*a097;
a098=arg[77]? arg[77][0] : 0;
a035=a035*a098;
a097=a097+a035;
a013=a013+a097;
a097=2.*a079;
a035=a000*a097;
a099=a037*a071;
a035=a035+a099;
a099=a041*a035;
a100=arg[51]? arg[51][0] : 0;
a101=arg[54]? arg[54][0] : 0;
a102=a100-a101;
a103=a006*a096;
a104=a033*a079;
a103=a103+a104;
a104=a000*a103;
a105=a042*a071;
a104=a104+a105;
a102=a102+a104;
a104=a006*a095;
a105=a032*a079;
a104=a104+a105;
a105=a000*a104;
a106=a043*a071;
a105=a105+a106;
a102=a102+a105;
a106=a038*a102;
a099=a099+a106;
a106=2.*a099;
a106=a047*a106;
a107=arg[76]? arg[76][0] : 0;
a046=a046*a107;
a106=a106+a046;
a013=a013+a106;
a106=a000*a079;
a046=a006*a071;
a106=a106+a046;
a046=a058*a106;
a108=a049*a095;
a109=arg[47]? arg[47][0] : 0;
a110=a032*a109;
a108=a108+a110;
a110=a006*a108;
a111=a050*a079;
a110=a110+a111;
a111=a057*a110;
a112=arg[49]? arg[49][0] : 0;
a112=a052*a112;
a113=a054*a112;
a114=arg[50]? arg[50][0] : 0;
a115=a053*a114;
a113=a113+a115;
a115=a056*a113;
a116=arg[48]? arg[48][0] : 0;
a117=a055*a116;
a115=a115+a117;
a117=a051*a115;
a111=a111+a117;
a117=2.*a101;
a111=a111-a117;
a117=2.*a100;
a117=a117+a105;
a111=a111+a117;
a118=a048*a111;
a046=a046+a118;
a118=-a046;
a119=2.*a118;
a119=a063*a119;
a120=arg[75]? arg[75][0] : 0;
a062=a062*a120;
a119=a119+a062;
a013=a013+a119;
a119=a006*a109;
a062=a049*a079;
a119=a119+a062;
a062=a057*a119;
a121=a064*a115;
a062=a062+a121;
a121=a059*a062;
a122=a065*a117;
a121=a121+a122;
a122=2.*a121;
a122=a068*a122;
a123=arg[74]? arg[74][0] : 0;
a067=a067*a123;
a122=a122+a067;
a013=a013+a122;
a009=a009*a013;
a080=a080+a009;
a002=a002*a080;
a069=a069+a002;
a072=a072*a069;
a070=a070+a072;
a072=a032*a004;
a069=a072*a049;
a002=casadi_sq(a006);
a080=a006*a002;
a009=casadi_sq(a080);
a122=a069*a009;
a067=4.;
a124=2.*a057;
a125=a124*a068;
a125=a067*a125;
a126=-4.;
a127=a003*a057;
a128=a127*a063;
a128=a126*a128;
a125=a125-a128;
a128=a122*a125;
a129=casadi_sq(a000);
a130=2.*a129;
a131=2.*a000;
a131=a131*a071;
a130=a130*a131;
a132=a128*a130;
a133=casadi_sq(a129);
a134=a004*a095;
a135=a032*a074;
a134=a134+a135;
a135=a049*a134;
a136=a072*a109;
a135=a135+a136;
a136=a009*a135;
a137=2.*a080;
a138=a002*a079;
a139=2.*a006;
a139=a139*a079;
a140=a006*a139;
a138=a138+a140;
a137=a137*a138;
a140=a069*a137;
a136=a136+a140;
a140=a125*a136;
a141=2.*a115;
a142=a068*a141;
a143=a124*a123;
a142=a142+a143;
a142=a067*a142;
a143=a003*a115;
a144=a063*a143;
a145=a127*a120;
a144=a144+a145;
a144=a126*a144;
a142=a142-a144;
a144=a122*a142;
a140=a140+a144;
a144=a133*a140;
a132=a132+a144;
a070=a070+a132;
a129=2.*a129;
a132=a000*a128;
a144=a129*a132;
a145=2.*a071;
a144=a144*a145;
a145=2.*a000;
a131=2.*a131;
a132=a132*a131;
a128=a128*a071;
a140=a000*a140;
a128=a128+a140;
a129=a129*a128;
a132=a132+a129;
a145=a145*a132;
a144=a144+a145;
a070=a070+a144;
a144=a011*a025;
a144=2.*a144;
a145=2.*a023;
a132=a145*a036;
a144=a144+a132;
a132=2.*a034;
a129=a132*a047;
a144=a144+a129;
a129=2.*a045;
a128=a129*a063;
a144=a144+a128;
a128=2.*a061;
a140=a128*a068;
a144=a144+a140;
a140=2.*a066;
a131=arg[27]? arg[27][0] : 0;
a146=a140*a131;
a144=a144+a146;
a146=a019*a144;
a085=a146*a085;
a081=a144*a081;
a025=a025*a076;
a089=a011*a089;
a025=a025+a089;
a025=2.*a025;
a089=2.*a084;
a089=a036*a089;
a145=a145*a098;
a089=a089+a145;
a025=a025+a089;
a089=2.*a091;
a089=a047*a089;
a132=a132*a107;
a089=a089+a132;
a025=a025+a089;
a089=2.*a099;
a089=a063*a089;
a129=a129*a120;
a089=a089+a129;
a025=a025+a089;
a089=2.*a118;
a089=a068*a089;
a128=a128*a123;
a089=a089+a128;
a025=a025+a089;
a089=2.*a121;
a089=a131*a089;
a128=arg[73]? arg[73][0] : 0;
a140=a140*a128;
a089=a089+a140;
a025=a025+a089;
a019=a019*a025;
a081=a081+a019;
a020=a020*a081;
a085=a085+a020;
a070=a070+a085;
a085=a021*a144;
a020=a016*a085;
a083=a020*a083;
a012=a085*a012;
a144=a144*a086;
a021=a021*a025;
a144=a144+a021;
a016=a016*a144;
a012=a012+a016;
a017=a017*a012;
a083=a083+a017;
a070=a070+a083;
a083=a000*a020;
a017=2.*a071;
a083=a083*a017;
a017=2.*a000;
a020=a020*a071;
a012=a000*a012;
a020=a020+a012;
a017=a017*a020;
a083=a083+a017;
a070=a070+a083;
a083=casadi_sq(a000);
a017=2.*a083;
a020=casadi_sq(a006);
a012=casadi_sq(a020);
a016=a006*a012;
a021=a049*a016;
a025=2.*a039;
a086=a025*a004;
a019=a032*a022;
a086=a086-a019;
a019=a004*a044;
a086=a086+a019;
a019=a127*a068;
a019=a126*a019;
a089=a124*a131;
a089=a067*a089;
a019=a019-a089;
a089=a086*a019;
a140=a021*a089;
a129=a017*a140;
a132=2.*a071;
a129=a129*a132;
a132=2.*a000;
a145=2.*a000;
a145=a145*a071;
a147=2.*a145;
a140=a140*a147;
a147=a016*a109;
a148=a012*a079;
a149=2.*a020;
a150=2.*a006;
a150=a150*a079;
a149=a149*a150;
a151=a006*a149;
a148=a148+a151;
a151=a049*a148;
a147=a147+a151;
a151=a089*a147;
a152=2.*a100;
a153=a004*a152;
a154=a025*a074;
a153=a153+a154;
a154=a022*a095;
a155=a032*a087;
a154=a154+a155;
a153=a153-a154;
a154=a044*a074;
a155=a004*a105;
a154=a154+a155;
a153=a153+a154;
a154=a019*a153;
a155=a068*a143;
a156=a127*a123;
a155=a155+a156;
a155=a126*a155;
a156=a131*a141;
a157=a124*a128;
a156=a156+a157;
a156=a067*a156;
a155=a155-a156;
a156=a086*a155;
a154=a154+a156;
a156=a021*a154;
a151=a151+a156;
a017=a017*a151;
a140=a140+a017;
a132=a132*a140;
a129=a129+a132;
a070=a070+a129;
a129=a011*a036;
a129=2.*a129;
a132=a023*a047;
a132=2.*a132;
a129=a129+a132;
a132=2.*a034;
a140=a132*a063;
a129=a129+a140;
a140=2.*a045;
a017=a140*a068;
a129=a129+a017;
a017=2.*a061;
a151=a017*a131;
a129=a129+a151;
a151=2.*a066;
a156=arg[26]? arg[26][0] : 0;
a157=a151*a156;
a129=a129+a157;
a157=a028*a129;
a093=a157*a093;
a024=a129*a024;
a036=a036*a076;
a098=a011*a098;
a036=a036+a098;
a036=2.*a036;
a098=a047*a084;
a158=a023*a107;
a098=a098+a158;
a098=2.*a098;
a036=a036+a098;
a098=2.*a091;
a098=a063*a098;
a132=a132*a120;
a098=a098+a132;
a036=a036+a098;
a098=2.*a099;
a098=a068*a098;
a140=a140*a123;
a098=a098+a140;
a036=a036+a098;
a098=2.*a118;
a098=a131*a098;
a017=a017*a128;
a098=a098+a017;
a036=a036+a098;
a098=2.*a121;
a098=a156*a098;
a017=arg[72]? arg[72][0] : 0;
a151=a151*a017;
a098=a098+a151;
a036=a036+a098;
a028=a028*a036;
a024=a024+a028;
a030=a030*a024;
a093=a093+a030;
a070=a070+a093;
a093=a031*a129;
a030=a026*a093;
a028=2.*a071;
a030=a030*a028;
a028=2.*a000;
a088=a093*a088;
a129=a129*a094;
a031=a031*a036;
a129=a129+a031;
a026=a026*a129;
a088=a088+a026;
a028=a028*a088;
a030=a030+a028;
a070=a070+a030;
a030=casadi_sq(a006);
a028=casadi_sq(a030);
a088=a049*a028;
a026=casadi_sq(a000);
a031=a000*a026;
a036=a088*a031;
a094=a127*a131;
a094=a126*a094;
a098=a124*a156;
a098=a067*a098;
a094=a094-a098;
a098=a036*a094;
a151=a022*a095;
a140=a032*a087;
a151=a151+a140;
a140=a006*a151;
a132=a032*a022;
a158=a132*a079;
a140=a140+a158;
a158=a098*a140;
a159=a132*a006;
a160=a028*a109;
a161=2.*a030;
a162=2.*a006;
a162=a162*a079;
a161=a161*a162;
a163=a049*a161;
a160=a160+a163;
a163=a031*a160;
a164=a026*a071;
a165=2.*a000;
a165=a165*a071;
a166=a000*a165;
a164=a164+a166;
a166=a088*a164;
a163=a163+a166;
a166=a094*a163;
a167=a131*a143;
a168=a127*a128;
a167=a167+a168;
a167=a126*a167;
a168=a156*a141;
a169=a124*a017;
a168=a168+a169;
a168=a067*a168;
a167=a167-a168;
a168=a036*a167;
a166=a166+a168;
a168=a159*a166;
a158=a158+a168;
a070=a070+a158;
a158=2.*a039;
a168=a158*a022;
a169=a032*a033;
a168=a168-a169;
a169=a159*a000;
a168=a168+a169;
a169=a168*a094;
a170=a088*a169;
a165=a170*a165;
a160=a169*a160;
a171=2.*a100;
a172=a022*a171;
a173=a158*a087;
a172=a172+a173;
a173=a033*a095;
a174=a032*a096;
a173=a173+a174;
a172=a172-a173;
a140=a000*a140;
a159=a159*a071;
a140=a140+a159;
a172=a172+a140;
a094=a094*a172;
a167=a168*a167;
a094=a094+a167;
a088=a088*a094;
a160=a160+a088;
a026=a026*a160;
a165=a165+a026;
a070=a070+a165;
a165=a000*a170;
a026=2.*a071;
a165=a165*a026;
a026=2.*a000;
a170=a170*a071;
a160=a000*a160;
a170=a170+a160;
a026=a026*a170;
a165=a165+a026;
a070=a070+a165;
a165=a011*a047;
a165=2.*a165;
a026=a023*a063;
a026=2.*a026;
a165=a165+a026;
a026=a034*a068;
a026=2.*a026;
a165=a165+a026;
a026=2.*a045;
a170=a026*a131;
a165=a165+a170;
a061=2.*a061;
a170=a061*a156;
a165=a165+a170;
a170=2.*a066;
a160=arg[25]? arg[25][0] : 0;
a088=a170*a160;
a165=a165+a088;
a088=a038*a165;
a103=a088*a103;
a035=a165*a035;
a047=a047*a076;
a107=a011*a107;
a047=a047+a107;
a047=2.*a047;
a107=a063*a084;
a167=a023*a120;
a107=a107+a167;
a107=2.*a107;
a047=a047+a107;
a107=a068*a091;
a167=a034*a123;
a107=a107+a167;
a107=2.*a107;
a047=a047+a107;
a107=2.*a099;
a107=a131*a107;
a026=a026*a128;
a107=a107+a026;
a047=a047+a107;
a118=2.*a118;
a118=a156*a118;
a061=a061*a017;
a118=a118+a061;
a047=a047+a118;
a118=2.*a121;
a118=a160*a118;
a061=arg[71]? arg[71][0] : 0;
a170=a170*a061;
a118=a118+a170;
a047=a047+a118;
a038=a038*a047;
a035=a035+a038;
a042=a042*a035;
a103=a103+a042;
a070=a070+a103;
a103=a041*a165;
a097=a103*a097;
a165=a165*a102;
a041=a041*a047;
a165=a165+a041;
a037=a037*a165;
a097=a097+a037;
a070=a070+a097;
a097=casadi_sq(a006);
a037=a006*a097;
a041=a049*a037;
a047=casadi_sq(a000);
a102=a041*a047;
a042=a127*a156;
a042=a126*a042;
a038=a124*a160;
a038=a067*a038;
a042=a042-a038;
a038=a102*a042;
a118=a033*a095;
a170=a032*a096;
a118=a118+a170;
a170=a006*a118;
a107=a032*a033;
a026=a107*a079;
a170=a170+a026;
a026=a038*a170;
a167=a107*a006;
a140=a037*a109;
a159=a097*a079;
a173=2.*a006;
a173=a173*a079;
a174=a006*a173;
a159=a159+a174;
a174=a049*a159;
a140=a140+a174;
a174=a047*a140;
a175=2.*a000;
a175=a175*a071;
a176=a041*a175;
a174=a174+a176;
a176=a042*a174;
a177=a156*a143;
a178=a127*a017;
a177=a177+a178;
a177=a126*a177;
a178=a160*a141;
a179=a124*a061;
a178=a178+a179;
a178=a067*a178;
a177=a177-a178;
a178=a102*a177;
a176=a176+a178;
a178=a167*a176;
a026=a026+a178;
a070=a070+a026;
a039=2.*a039;
a026=a039*a033;
a178=a032*a040;
a026=a026-a178;
a178=a167*a000;
a026=a026+a178;
a178=a026*a042;
a179=a041*a178;
a180=2.*a071;
a179=a179*a180;
a180=2.*a000;
a140=a178*a140;
a100=2.*a100;
a181=a033*a100;
a182=a039*a096;
a181=a181+a182;
a182=a040*a095;
a183=a032*a101;
a182=a182+a183;
a181=a181-a182;
a170=a000*a170;
a167=a167*a071;
a170=a170+a167;
a181=a181+a170;
a042=a042*a181;
a177=a026*a177;
a042=a042+a177;
a041=a041*a042;
a140=a140+a041;
a180=a180*a140;
a179=a179+a180;
a070=a070+a179;
a179=2.*a060;
a180=a179*a160;
a140=a011*a063;
a140=2.*a140;
a041=a023*a068;
a041=2.*a041;
a140=a140+a041;
a041=a034*a131;
a041=2.*a041;
a140=a140+a041;
a041=a045*a156;
a041=2.*a041;
a140=a140+a041;
a180=a180-a140;
a140=2.*a066;
a041=arg[24]? arg[24][0] : 0;
a177=a140*a041;
a180=a180-a177;
a177=a058*a180;
a170=a177*a079;
a111=a180*a111;
a167=2.*a046;
a167=a160*a167;
a179=a179*a061;
a167=a167+a179;
a179=a063*a076;
a182=a011*a120;
a179=a179+a182;
a179=2.*a179;
a182=a068*a084;
a183=a023*a123;
a182=a182+a183;
a182=2.*a182;
a179=a179+a182;
a182=a131*a091;
a183=a034*a128;
a182=a182+a183;
a182=2.*a182;
a179=a179+a182;
a182=a156*a099;
a183=a045*a017;
a182=a182+a183;
a182=2.*a182;
a179=a179+a182;
a167=a167-a179;
a179=2.*a121;
a179=a041*a179;
a182=arg[70]? arg[70][0] : 0;
a140=a140*a182;
a179=a179+a140;
a167=a167-a179;
a058=a058*a167;
a111=a111+a058;
a058=a006*a111;
a170=a170+a058;
a070=a070+a170;
a170=a127*a160;
a170=a126*a170;
a058=a124*a041;
a058=a067*a058;
a170=a170-a058;
a058=a059*a170;
a179=casadi_sq(a006);
a140=a049*a101;
a183=a040*a109;
a140=a140+a183;
a183=a179*a140;
a184=a040*a049;
a185=2.*a006;
a185=a185*a079;
a186=a184*a185;
a183=a183+a186;
a186=a058*a183;
a187=a184*a179;
a188=a170*a117;
a143=a160*a143;
a127=a127*a061;
a143=a143+a127;
a143=a126*a143;
a141=a041*a141;
a124=a124*a182;
a141=a141+a124;
a141=a067*a141;
a143=a143-a141;
a141=a059*a143;
a188=a188+a141;
a141=a187*a188;
a186=a186+a141;
a070=a070+a186;
a186=casadi_sq(a083);
a141=a021*a186;
a124=a141*a019;
a127=a004*a124;
a127=a127+a088;
a189=a048*a180;
a190=a187*a000;
a191=a190*a170;
a191=a189+a191;
a192=a011*a068;
a192=2.*a192;
a193=a023*a131;
a193=2.*a193;
a192=a192+a193;
a193=a034*a156;
a193=2.*a193;
a192=a192+a193;
a193=a045*a160;
a193=2.*a193;
a192=a192+a193;
a193=a060*a041;
a193=-a193;
a193=2.*a193;
a192=a192+a193;
a066=2.*a066;
a193=arg[23]? arg[23][0] : 0;
a194=a066*a193;
a192=a192+a194;
a194=a065*a192;
a191=a191+a194;
a127=a127+a191;
a104=a127*a104;
a191=a124*a074;
a147=a186*a147;
a083=2.*a083;
a083=a083*a145;
a021=a021*a083;
a147=a147+a021;
a019=a019*a147;
a155=a141*a155;
a019=a019+a155;
a155=a004*a019;
a191=a191+a155;
a191=a191+a035;
a180=a180*a106;
a048=a048*a167;
a180=a180+a048;
a183=a000*a183;
a187=a187*a071;
a183=a183+a187;
a170=a170*a183;
a143=a190*a143;
a170=a170+a143;
a170=a180+a170;
a062=a192*a062;
a076=a068*a076;
a011=a011*a123;
a076=a076+a011;
a076=2.*a076;
a084=a131*a084;
a023=a023*a128;
a084=a084+a023;
a084=2.*a084;
a076=a076+a084;
a091=a156*a091;
a034=a034*a017;
a091=a091+a034;
a091=2.*a091;
a076=a076+a091;
a099=a160*a099;
a045=a045*a061;
a099=a099+a045;
a099=2.*a099;
a076=a076+a099;
a046=a041*a046;
a060=a060*a182;
a046=a046+a060;
a046=-a046;
a046=2.*a046;
a076=a076+a046;
a121=2.*a121;
a193=a193*a121;
a121=arg[69]? arg[69][0] : 0;
a066=a066*a121;
a193=a193+a066;
a076=a076+a193;
a065=a065*a076;
a062=a062+a065;
a170=a170+a062;
a191=a191+a170;
a043=a043*a191;
a104=a104+a043;
a070=a070+a104;
if (res[0]!=0) res[0][0]=a070;
a070=a000*a133;
a104=a070*a125;
a043=a009*a104;
a134=a043*a134;
a137=a104*a137;
a133=a133*a071;
a130=a000*a130;
a133=a133+a130;
a125=a125*a133;
a142=a070*a142;
a125=a125+a142;
a009=a009*a125;
a137=a137+a009;
a072=a072*a137;
a134=a134+a072;
a072=a186*a089;
a148=a072*a148;
a089=a089*a083;
a186=a186*a154;
a089=a089+a186;
a016=a016*a089;
a148=a148+a016;
a134=a134+a148;
a148=a031*a169;
a161=a148*a161;
a169=a169*a164;
a031=a031*a094;
a169=a169+a031;
a028=a028*a169;
a161=a161+a028;
a134=a134+a161;
a161=a047*a178;
a159=a161*a159;
a178=a178*a175;
a047=a047*a042;
a178=a178+a047;
a037=a037*a178;
a159=a159+a037;
a134=a134+a159;
a159=a057*a189;
a037=a006*a159;
a047=a037*a095;
a042=a159*a079;
a175=a189*a115;
a028=a057*a180;
a175=a175+a028;
a028=a006*a175;
a042=a042+a028;
a028=a032*a042;
a047=a047+a028;
a134=a134+a047;
a047=a000*a058;
a028=a179*a047;
a031=a028*a101;
a185=a047*a185;
a058=a058*a071;
a188=a000*a188;
a058=a058+a188;
a179=a179*a058;
a185=a185+a179;
a179=a040*a185;
a031=a031+a179;
a134=a134+a031;
a031=a059*a192;
a179=a057*a031;
a188=a179*a079;
a115=a031*a115;
a192=a192*a117;
a076=a059*a076;
a192=a192+a076;
a057=a057*a192;
a115=a115+a057;
a057=a006*a115;
a188=a188+a057;
a134=a134+a188;
if (res[1]!=0) res[1][0]=a134;
a134=a141*a086;
a188=a126*a134;
a057=a188*a068;
a076=a122*a070;
a094=a126*a076;
a164=a094*a063;
a057=a057-a164;
a164=a036*a168;
a016=a126*a164;
a186=a016*a131;
a057=a057+a186;
a186=a102*a026;
a154=a126*a186;
a083=a154*a156;
a057=a057+a083;
a083=a190*a059;
a009=a126*a083;
a142=a009*a160;
a057=a057+a142;
a057=a003*a057;
a142=a051*a189;
a057=a057+a142;
a076=a067*a076;
a142=a076*a068;
a134=a067*a134;
a130=a134*a131;
a142=a142-a130;
a164=a067*a164;
a130=a164*a156;
a142=a142-a130;
a186=a067*a186;
a130=a186*a160;
a142=a142-a130;
a083=a067*a083;
a130=a083*a041;
a142=a142-a130;
a142=2.*a142;
a057=a057+a142;
a142=a064*a031;
a057=a057+a142;
a113=a057*a113;
a086=a086*a147;
a141=a141*a153;
a086=a086+a141;
a141=a126*a086;
a141=a068*a141;
a188=a188*a123;
a141=a141+a188;
a070=a070*a136;
a122=a122*a133;
a070=a070+a122;
a122=a126*a070;
a063=a063*a122;
a094=a094*a120;
a063=a063+a094;
a141=a141-a063;
a168=a168*a163;
a036=a036*a172;
a168=a168+a036;
a036=a126*a168;
a036=a131*a036;
a016=a016*a128;
a036=a036+a016;
a141=a141+a036;
a026=a026*a174;
a102=a102*a181;
a026=a026+a102;
a102=a126*a026;
a102=a156*a102;
a154=a154*a017;
a102=a102+a154;
a141=a141+a102;
a059=a059*a183;
a190=a190*a117;
a059=a059+a190;
a126=a126*a059;
a126=a160*a126;
a009=a009*a061;
a126=a126+a009;
a141=a141+a126;
a141=a003*a141;
a189=a189*a110;
a051=a051*a180;
a189=a189+a051;
a141=a141+a189;
a070=a067*a070;
a068=a068*a070;
a076=a076*a123;
a068=a068+a076;
a086=a067*a086;
a131=a131*a086;
a134=a134*a128;
a131=a131+a134;
a068=a068-a131;
a168=a067*a168;
a156=a156*a168;
a164=a164*a017;
a156=a156+a164;
a068=a068-a156;
a026=a067*a026;
a160=a160*a026;
a186=a186*a061;
a160=a160+a186;
a068=a068-a160;
a067=a067*a059;
a041=a041*a067;
a083=a083*a182;
a041=a041+a083;
a068=a068-a041;
a068=2.*a068;
a141=a141+a068;
a031=a031*a119;
a064=a064*a192;
a031=a031+a064;
a141=a141+a031;
a055=a055*a141;
a113=a113+a055;
if (res[2]!=0) res[2][0]=a113;
a113=a056*a057;
a114=a113*a114;
a057=a057*a116;
a056=a056*a141;
a057=a057+a056;
a054=a054*a057;
a114=a114+a054;
a052=a052*a114;
if (res[3]!=0) res[3][0]=a052;
a113=a113*a112;
a053=a053*a057;
a113=a113+a053;
if (res[4]!=0) res[4][0]=a113;
a113=a124*a074;
a053=a004*a019;
a113=a113+a053;
a113=2.*a113;
a053=a098*a087;
a057=a022*a166;
a053=a053+a057;
a053=2.*a053;
a113=a113+a053;
a113=a113+a035;
a053=a038*a096;
a057=a033*a176;
a053=a053+a057;
a053=2.*a053;
a113=a113+a053;
a170=2.*a170;
a113=a113+a170;
if (res[5]!=0) res[5][0]=a113;
a113=a049*a043;
a170=a113*a074;
a043=a043*a109;
a137=a049*a137;
a043=a043+a137;
a137=a004*a043;
a170=a170+a137;
a137=a124*a087;
a053=a022*a019;
a137=a137+a053;
a170=a170-a137;
a170=a170-a024;
a137=a000*a098;
a053=a006*a137;
a087=a053*a087;
a057=a137*a079;
a112=a098*a071;
a052=a000*a166;
a112=a112+a052;
a052=a006*a112;
a057=a057+a052;
a022=a022*a057;
a087=a087+a022;
a170=a170+a087;
a087=a098*a096;
a022=a033*a166;
a087=a087+a022;
a170=a170-a087;
a087=a000*a038;
a022=a006*a087;
a052=a022*a096;
a114=a087*a079;
a054=a038*a071;
a056=a000*a176;
a054=a054+a056;
a056=a006*a054;
a114=a114+a056;
a056=a033*a114;
a052=a052+a056;
a170=a170+a052;
a101=a038*a101;
a040=a040*a176;
a101=a101+a040;
a170=a170-a101;
a037=a037*a109;
a042=a049*a042;
a037=a037+a042;
a170=a170+a037;
a037=a000*a127;
a042=a037*a079;
a127=a127*a071;
a191=a000*a191;
a127=a127+a191;
a191=a006*a127;
a042=a042+a191;
a170=a170+a042;
if (res[6]!=0) res[6][0]=a170;
a007=2.*a007;
a170=a010*a014;
a042=a005*a170;
a191=a007*a042;
a101=2.*a079;
a191=a191*a101;
a101=2.*a006;
a078=2.*a078;
a042=a042*a078;
a075=a170*a075;
a014=a014*a001;
a010=a010*a013;
a014=a014+a010;
a005=a005*a014;
a075=a075+a005;
a007=a007*a075;
a042=a042+a007;
a101=a101*a042;
a191=a191+a101;
a080=2.*a080;
a101=a069*a104;
a042=a080*a101;
a139=a042*a139;
a138=2.*a138;
a101=a101*a138;
a104=a104*a135;
a069=a069*a125;
a104=a104+a069;
a080=a080*a104;
a101=a101+a080;
a002=a002*a101;
a139=a139+a002;
a191=a191+a139;
a139=a006*a042;
a002=2.*a079;
a139=a139*a002;
a002=2.*a006;
a042=a042*a079;
a101=a006*a101;
a042=a042+a101;
a002=a002*a042;
a139=a139+a002;
a191=a191+a139;
a139=a000*a146;
a074=a139*a074;
a146=a146*a071;
a002=a000*a081;
a146=a146+a002;
a004=a004*a146;
a074=a074+a004;
a191=a191+a074;
a074=a018*a085;
a074=2.*a074;
a073=a074*a073;
a085=a085*a082;
a018=a018*a144;
a085=a085+a018;
a085=2.*a085;
a015=a015*a085;
a073=a073+a015;
a191=a191+a073;
a073=a006*a074;
a015=2.*a079;
a073=a073*a015;
a015=2.*a006;
a074=a074*a079;
a085=a006*a085;
a074=a074+a085;
a015=a015*a074;
a073=a073+a015;
a191=a191+a073;
a073=a049*a072;
a149=a073*a149;
a072=a072*a109;
a089=a049*a089;
a072=a072+a089;
a012=a012*a072;
a149=a149+a012;
a191=a191+a149;
a020=2.*a020;
a149=a006*a073;
a012=a020*a149;
a089=2.*a079;
a012=a012*a089;
a089=2.*a006;
a150=2.*a150;
a149=a149*a150;
a073=a073*a079;
a072=a006*a072;
a073=a073+a072;
a020=a020*a073;
a149=a149+a020;
a089=a089*a149;
a012=a012+a089;
a191=a191+a012;
a012=a000*a157;
a092=a012*a092;
a157=a157*a071;
a089=a000*a024;
a157=a157+a089;
a029=a029*a157;
a092=a092+a029;
a191=a191+a092;
a092=a027*a093;
a029=2.*a079;
a092=a092*a029;
a029=2.*a006;
a093=a093*a090;
a027=a027*a129;
a093=a093+a027;
a029=a029*a093;
a092=a092+a029;
a191=a191+a092;
a137=a137*a151;
a132=a132*a112;
a137=a137+a132;
a191=a191+a137;
a030=2.*a030;
a137=a049*a148;
a132=a030*a137;
a112=2.*a079;
a132=a132*a112;
a112=2.*a006;
a162=2.*a162;
a137=a137*a162;
a148=a148*a109;
a169=a049*a169;
a148=a148+a169;
a030=a030*a148;
a137=a137+a030;
a112=a112*a137;
a132=a132+a112;
a191=a191+a132;
a132=a000*a088;
a096=a132*a096;
a088=a088*a071;
a112=a000*a035;
a088=a088+a112;
a033=a033*a088;
a096=a096+a033;
a191=a191+a096;
a103=a103*a071;
a165=a000*a165;
a103=a103+a165;
a103=2.*a103;
a191=a191+a103;
a087=a087*a118;
a107=a107*a054;
a087=a087+a107;
a191=a191+a087;
a087=a049*a161;
a173=a087*a173;
a161=a161*a109;
a178=a049*a178;
a161=a161+a178;
a097=a097*a161;
a173=a173+a097;
a191=a191+a173;
a173=a006*a087;
a097=2.*a079;
a173=a173*a097;
a097=2.*a006;
a087=a087*a079;
a161=a006*a161;
a087=a087+a161;
a097=a097*a087;
a173=a173+a097;
a191=a191+a173;
a159=a159*a108;
a050=a050*a175;
a159=a159+a050;
a191=a191+a159;
a177=a177*a071;
a000=a000*a111;
a177=a177+a000;
a191=a191+a177;
a177=a184*a047;
a000=2.*a079;
a177=a177*a000;
a000=2.*a006;
a047=a047*a140;
a184=a184*a058;
a047=a047+a184;
a000=a000*a047;
a177=a177+a000;
a191=a191+a177;
a037=a037*a095;
a127=a032*a127;
a037=a037+a127;
a191=a191+a037;
a179=a179*a109;
a115=a049*a115;
a179=a179+a115;
a191=a191+a179;
if (res[7]!=0) res[7][0]=a191;
a180=-a180;
a180=2.*a180;
a191=a038*a095;
a179=a032*a176;
a191=a191+a179;
a035=a035+a191;
a180=a180-a035;
a028=a028*a109;
a049=a049*a185;
a028=a028+a049;
a180=a180+a028;
if (res[8]!=0) res[8][0]=a180;
a024=-a024;
a024=2.*a024;
a180=a098*a095;
a028=a032*a166;
a180=a180+a028;
a024=a024-a180;
a132=a132*a079;
a088=a006*a088;
a132=a132+a088;
a024=a024+a132;
a022=a022*a095;
a114=a032*a114;
a022=a022+a114;
a024=a024+a022;
a038=a038*a100;
a039=a039*a176;
a038=a038+a039;
a024=a024+a038;
if (res[9]!=0) res[9][0]=a024;
a012=a012*a079;
a157=a006*a157;
a012=a012+a157;
a012=2.*a012;
a157=a124*a095;
a024=a032*a019;
a157=a157+a024;
a081=a081+a157;
a012=a012-a081;
a053=a053*a095;
a057=a032*a057;
a053=a053+a057;
a012=a012+a053;
a098=a098*a171;
a158=a158*a166;
a098=a098+a158;
a012=a012+a098;
if (res[10]!=0) res[10][0]=a012;
a170=a170*a077;
a008=a008*a014;
a170=a170+a008;
a003=a003*a170;
a113=a113*a095;
a032=a032*a043;
a113=a113+a032;
a003=a003+a113;
a139=a139*a079;
a006=a006*a146;
a139=a139+a006;
a003=a003+a139;
a105=a124*a105;
a044=a044*a019;
a105=a105+a044;
a003=a003+a105;
a124=a124*a152;
a025=a025*a019;
a124=a124+a025;
a003=a003+a124;
if (res[11]!=0) res[11][0]=a003;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_loaded_gear_envelope(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f59(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_loaded_gear_envelope_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_loaded_gear_envelope_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_loaded_gear_envelope_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_loaded_gear_envelope_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_loaded_gear_envelope_n_in(void) { return 80;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_loaded_gear_envelope_n_out(void) { return 12;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_loaded_gear_envelope_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_loaded_gear_envelope_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "b";
case 2: return "rho";
case 3: return "Ap";
case 4: return "CL_gamma";
case 5: return "B3";
case 6: return "C3";
case 7: return "g";
case 8: return "K1";
case 9: return "K2";
case 10: return "K3";
case 11: return "K4";
case 12: return "out_g_0";
case 13: return "out_g_1";
case 14: return "out_g_2";
case 15: return "out_g_3";
case 16: return "out_g_4";
case 17: return "out_g_5";
case 18: return "out_g_6";
case 19: return "out_g_7";
case 20: return "out_g_8";
case 21: return "out_g_9";
case 22: return "out_g_10";
case 23: return "adj_g_0";
case 24: return "adj_g_1";
case 25: return "adj_g_2";
case 26: return "adj_g_3";
case 27: return "adj_g_4";
case 28: return "adj_g_5";
case 29: return "adj_g_6";
case 30: return "adj_g_7";
case 31: return "adj_g_8";
case 32: return "adj_g_9";
case 33: return "adj_g_10";
case 34: return "out_adj_m";
case 35: return "out_adj_b";
case 36: return "out_adj_rho";
case 37: return "out_adj_Ap";
case 38: return "out_adj_CL_gamma";
case 39: return "out_adj_B3";
case 40: return "out_adj_C3";
case 41: return "out_adj_g";
case 42: return "out_adj_K1";
case 43: return "out_adj_K2";
case 44: return "out_adj_K3";
case 45: return "out_adj_K4";
case 46: return "fwd_m";
case 47: return "fwd_b";
case 48: return "fwd_rho";
case 49: return "fwd_Ap";
case 50: return "fwd_CL_gamma";
case 51: return "fwd_B3";
case 52: return "fwd_C3";
case 53: return "fwd_g";
case 54: return "fwd_K1";
case 55: return "fwd_K2";
case 56: return "fwd_K3";
case 57: return "fwd_K4";
case 58: return "fwd_out_g_0";
case 59: return "fwd_out_g_1";
case 60: return "fwd_out_g_2";
case 61: return "fwd_out_g_3";
case 62: return "fwd_out_g_4";
case 63: return "fwd_out_g_5";
case 64: return "fwd_out_g_6";
case 65: return "fwd_out_g_7";
case 66: return "fwd_out_g_8";
case 67: return "fwd_out_g_9";
case 68: return "fwd_out_g_10";
case 69: return "fwd_adj_g_0";
case 70: return "fwd_adj_g_1";
case 71: return "fwd_adj_g_2";
case 72: return "fwd_adj_g_3";
case 73: return "fwd_adj_g_4";
case 74: return "fwd_adj_g_5";
case 75: return "fwd_adj_g_6";
case 76: return "fwd_adj_g_7";
case 77: return "fwd_adj_g_8";
case 78: return "fwd_adj_g_9";
case 79: return "fwd_adj_g_10";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_loaded_gear_envelope_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_m";
case 1: return "fwd_adj_b";
case 2: return "fwd_adj_rho";
case 3: return "fwd_adj_Ap";
case 4: return "fwd_adj_CL_gamma";
case 5: return "fwd_adj_B3";
case 6: return "fwd_adj_C3";
case 7: return "fwd_adj_g";
case 8: return "fwd_adj_K1";
case 9: return "fwd_adj_K2";
case 10: return "fwd_adj_K3";
case 11: return "fwd_adj_K4";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_loaded_gear_envelope_sparsity_in(casadi_int i) {
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
case 11: return casadi_s0;
case 12: return casadi_s1;
case 13: return casadi_s1;
case 14: return casadi_s1;
case 15: return casadi_s1;
case 16: return casadi_s1;
case 17: return casadi_s1;
case 18: return casadi_s1;
case 19: return casadi_s1;
case 20: return casadi_s1;
case 21: return casadi_s1;
case 22: return casadi_s1;
case 23: return casadi_s0;
case 24: return casadi_s0;
case 25: return casadi_s0;
case 26: return casadi_s0;
case 27: return casadi_s0;
case 28: return casadi_s0;
case 29: return casadi_s0;
case 30: return casadi_s0;
case 31: return casadi_s0;
case 32: return casadi_s0;
case 33: return casadi_s0;
case 34: return casadi_s1;
case 35: return casadi_s1;
case 36: return casadi_s1;
case 37: return casadi_s1;
case 38: return casadi_s1;
case 39: return casadi_s1;
case 40: return casadi_s1;
case 41: return casadi_s1;
case 42: return casadi_s1;
case 43: return casadi_s1;
case 44: return casadi_s1;
case 45: return casadi_s1;
case 46: return casadi_s0;
case 47: return casadi_s0;
case 48: return casadi_s0;
case 49: return casadi_s0;
case 50: return casadi_s0;
case 51: return casadi_s0;
case 52: return casadi_s0;
case 53: return casadi_s0;
case 54: return casadi_s0;
case 55: return casadi_s0;
case 56: return casadi_s0;
case 57: return casadi_s0;
case 58: return casadi_s1;
case 59: return casadi_s1;
case 60: return casadi_s1;
case 61: return casadi_s1;
case 62: return casadi_s1;
case 63: return casadi_s1;
case 64: return casadi_s1;
case 65: return casadi_s1;
case 66: return casadi_s1;
case 67: return casadi_s1;
case 68: return casadi_s1;
case 69: return casadi_s0;
case 70: return casadi_s0;
case 71: return casadi_s0;
case 72: return casadi_s0;
case 73: return casadi_s0;
case 74: return casadi_s0;
case 75: return casadi_s0;
case 76: return casadi_s0;
case 77: return casadi_s0;
case 78: return casadi_s0;
case 79: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_loaded_gear_envelope_sparsity_out(casadi_int i) {
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
case 11: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_loaded_gear_envelope_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 80;
if (sz_res) *sz_res = 12;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_loaded_gear_envelope_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 80*sizeof(const casadi_real*);
if (sz_res) *sz_res = 12*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* at_tail_load:(tail_fraction,m,b,rho,Ap,CL_gamma,B3,C3,g,K1,K2,K3,K4)->(a_loaded,u_touch) */
static int casadi_f60(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
a00=arg[2]? arg[2][0] : 0;
a01=arg[0]? arg[0][0] : 0;
a02=a00*a01;
a03=1.;
a03=a01-a03;
a02=a02/a03;
a02=-a02;
if (res[0]!=0) res[0][0]=a02;
a02=arg[8]? arg[8][0] : 0;
a03=arg[1]? arg[1][0] : 0;
a04=a02*a03;
a05=arg[7]? arg[7][0] : 0;
a00=a00*a02;
a06=5.0000000000000000e-01;
a07=arg[4]? arg[4][0] : 0;
a06=a06*a07;
a07=arg[5]? arg[5][0] : 0;
a06=a06*a07;
a07=arg[3]? arg[3][0] : 0;
a06=a06*a07;
a00=a00*a06;
a07=a05*a00;
a08=arg[9]? arg[9][0] : 0;
a09=2.*a08;
a07=a07-a09;
a09=arg[6]? arg[6][0] : 0;
a10=2.*a09;
a11=a05*a02;
a11=a11*a03;
a10=a10+a11;
a07=a07+a10;
a04=a04*a07;
a04=a04*a01;
a10=a10*a00;
a04=a04-a10;
a10=2.*a02;
a10=a10*a03;
a09=a09-a08;
a08=arg[10]? arg[10][0] : 0;
a00=a08*a02;
a00=a00*a03;
a09=a09+a00;
a09=a09+a11;
a10=a10*a09;
a09=casadi_sq(a01);
a10=a10*a09;
a04=a04-a10;
a10=casadi_sq(a02);
a09=casadi_sq(a03);
a10=a10*a09;
a09=arg[11]? arg[11][0] : 0;
a11=2.*a09;
a11=a11*a02;
a11=a11*a03;
a08=2.*a08;
a05=a05+a08;
a11=a11-a05;
a10=a10*a11;
a11=casadi_sq(a01);
a11=a01*a11;
a10=a10*a11;
a04=a04-a10;
a10=casadi_sq(a02);
a10=a02*a10;
a10=2.*a10;
a11=casadi_sq(a03);
a11=a03*a11;
a10=a10*a11;
a11=arg[12]? arg[12][0] : 0;
a05=a11*a02;
a05=a05*a03;
a05=a05-a09;
a10=a10*a05;
a05=casadi_sq(a01);
a05=casadi_sq(a05);
a10=a10*a05;
a04=a04-a10;
a10=-2.;
a10=a10*a11;
a02=casadi_sq(a02);
a02=casadi_sq(a02);
a10=a10*a02;
a03=casadi_sq(a03);
a03=casadi_sq(a03);
a10=a10*a03;
a03=casadi_sq(a01);
a03=casadi_sq(a03);
a03=a01*a03;
a10=a10*a03;
a04=a04-a10;
a10=4.;
a10=a10*a06;
a03=-4.;
a03=a03*a06;
a03=a03*a01;
a10=a10+a03;
a04=a04/a10;
a04=sqrt(a04);
if (res[1]!=0) res[1][0]=a04;
return 0;
}
CASADI_SYMBOL_EXPORT int at_tail_load(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f60(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int at_tail_load_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void at_tail_load_release(int mem) {
}
CASADI_SYMBOL_EXPORT void at_tail_load_incref(void) {
}
CASADI_SYMBOL_EXPORT void at_tail_load_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int at_tail_load_n_in(void) { return 13;}
CASADI_SYMBOL_EXPORT casadi_int at_tail_load_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real at_tail_load_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* at_tail_load_name_in(casadi_int i) {
switch (i) {
case 0: return "tail_fraction";
case 1: return "m";
case 2: return "b";
case 3: return "rho";
case 4: return "Ap";
case 5: return "CL_gamma";
case 6: return "B3";
case 7: return "C3";
case 8: return "g";
case 9: return "K1";
case 10: return "K2";
case 11: return "K3";
case 12: return "K4";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* at_tail_load_name_out(casadi_int i) {
switch (i) {
case 0: return "a_loaded";
case 1: return "u_touch";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* at_tail_load_sparsity_in(casadi_int i) {
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
case 11: return casadi_s0;
case 12: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* at_tail_load_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int at_tail_load_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 13;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int at_tail_load_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 13*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_at_tail_load:(tail_fraction,m,b,rho,Ap,CL_gamma,B3,C3,g,K1,K2,K3,K4,out_a_loaded[1x1,0nz],out_u_touch[1x1,0nz],fwd_tail_fraction,fwd_m,fwd_b,fwd_rho,fwd_Ap,fwd_CL_gamma,fwd_B3,fwd_C3,fwd_g,fwd_K1,fwd_K2,fwd_K3,fwd_K4)->(fwd_a_loaded,fwd_u_touch) */
static int casadi_f61(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27;
a00=arg[0]? arg[0][0] : 0;
a01=arg[17]? arg[17][0] : 0;
a02=a00*a01;
a03=arg[2]? arg[2][0] : 0;
a04=arg[15]? arg[15][0] : 0;
a05=a03*a04;
a02=a02+a05;
a05=1.;
a05=a00-a05;
a02=a02/a05;
a06=a03*a00;
a06=a06/a05;
a06=a06/a05;
a06=a06*a04;
a02=a02-a06;
a02=-a02;
if (res[0]!=0) res[0][0]=a02;
a02=arg[7]? arg[7][0] : 0;
a06=arg[8]? arg[8][0] : 0;
a05=a03*a06;
a07=5.0000000000000000e-01;
a08=arg[4]? arg[4][0] : 0;
a08=a07*a08;
a09=arg[5]? arg[5][0] : 0;
a10=a08*a09;
a11=arg[3]? arg[3][0] : 0;
a12=a10*a11;
a13=a05*a12;
a14=a02*a13;
a15=arg[9]? arg[9][0] : 0;
a16=2.*a15;
a14=a14-a16;
a16=arg[6]? arg[6][0] : 0;
a17=2.*a16;
a18=a02*a06;
a19=arg[1]? arg[1][0] : 0;
a20=a18*a19;
a17=a17+a20;
a14=a14+a17;
a21=arg[23]? arg[23][0] : 0;
a22=a19*a21;
a23=arg[16]? arg[16][0] : 0;
a24=a06*a23;
a22=a22+a24;
a22=a14*a22;
a24=a06*a19;
a25=arg[22]? arg[22][0] : 0;
a26=a13*a25;
a01=a06*a01;
a03=a03*a21;
a01=a01+a03;
a01=a12*a01;
a03=arg[19]? arg[19][0] : 0;
a07=a07*a03;
a09=a09*a07;
a07=arg[20]? arg[20][0] : 0;
a08=a08*a07;
a09=a09+a08;
a11=a11*a09;
a09=arg[18]? arg[18][0] : 0;
a10=a10*a09;
a11=a11+a10;
a05=a05*a11;
a01=a01+a05;
a05=a02*a01;
a26=a26+a05;
a05=arg[24]? arg[24][0] : 0;
a10=2.*a05;
a26=a26-a10;
a10=arg[21]? arg[21][0] : 0;
a09=2.*a10;
a08=a06*a25;
a07=a02*a21;
a08=a08+a07;
a08=a19*a08;
a18=a18*a23;
a08=a08+a18;
a09=a09+a08;
a26=a26+a09;
a26=a24*a26;
a22=a22+a26;
a22=a00*a22;
a24=a24*a14;
a14=a24*a04;
a22=a22+a14;
a09=a13*a09;
a01=a17*a01;
a09=a09+a01;
a22=a22-a09;
a09=casadi_sq(a00);
a16=a16-a15;
a15=arg[10]? arg[10][0] : 0;
a01=a15*a06;
a14=a01*a19;
a16=a16+a14;
a16=a16+a20;
a20=2.*a21;
a20=a19*a20;
a14=2.*a06;
a26=a14*a23;
a20=a20+a26;
a20=a16*a20;
a14=a14*a19;
a10=a10-a05;
a05=arg[25]? arg[25][0] : 0;
a26=a06*a05;
a18=a15*a21;
a26=a26+a18;
a26=a19*a26;
a01=a01*a23;
a26=a26+a01;
a10=a10+a26;
a10=a10+a08;
a10=a14*a10;
a20=a20+a10;
a20=a09*a20;
a14=a14*a16;
a16=2.*a00;
a16=a16*a04;
a16=a14*a16;
a20=a20+a16;
a22=a22-a20;
a20=casadi_sq(a00);
a16=a00*a20;
a10=arg[11]? arg[11][0] : 0;
a08=2.*a10;
a26=a08*a06;
a01=a26*a19;
a15=2.*a15;
a02=a02+a15;
a01=a01-a02;
a02=casadi_sq(a19);
a15=2.*a06;
a15=a15*a21;
a15=a02*a15;
a18=casadi_sq(a06);
a07=2.*a19;
a07=a07*a23;
a07=a18*a07;
a15=a15+a07;
a15=a01*a15;
a18=a18*a02;
a02=arg[26]? arg[26][0] : 0;
a07=2.*a02;
a07=a06*a07;
a08=a08*a21;
a07=a07+a08;
a07=a19*a07;
a26=a26*a23;
a07=a07+a26;
a05=2.*a05;
a25=a25+a05;
a07=a07-a25;
a07=a18*a07;
a15=a15+a07;
a15=a16*a15;
a18=a18*a01;
a20=a20*a04;
a01=2.*a00;
a01=a01*a04;
a01=a00*a01;
a20=a20+a01;
a20=a18*a20;
a15=a15+a20;
a22=a22-a15;
a15=casadi_sq(a00);
a20=casadi_sq(a15);
a01=arg[12]? arg[12][0] : 0;
a07=a01*a06;
a25=a07*a19;
a25=a25-a10;
a10=casadi_sq(a19);
a05=a19*a10;
a26=casadi_sq(a06);
a08=a26*a21;
a03=2.*a06;
a03=a03*a21;
a03=a06*a03;
a08=a08+a03;
a08=2.*a08;
a08=a05*a08;
a26=a06*a26;
a26=2.*a26;
a10=a10*a23;
a03=2.*a19;
a03=a03*a23;
a03=a19*a03;
a10=a10+a03;
a10=a26*a10;
a08=a08+a10;
a08=a25*a08;
a26=a26*a05;
a05=arg[27]? arg[27][0] : 0;
a10=a06*a05;
a03=a01*a21;
a10=a10+a03;
a10=a19*a10;
a07=a07*a23;
a10=a10+a07;
a10=a10-a02;
a10=a26*a10;
a08=a08+a10;
a08=a20*a08;
a26=a26*a25;
a15=2.*a15;
a25=2.*a00;
a25=a25*a04;
a15=a15*a25;
a15=a26*a15;
a08=a08+a15;
a22=a22-a08;
a08=casadi_sq(a00);
a15=casadi_sq(a08);
a25=a00*a15;
a10=casadi_sq(a19);
a02=casadi_sq(a10);
a07=casadi_sq(a06);
a03=casadi_sq(a07);
a27=-2.;
a05=a27*a05;
a05=a03*a05;
a27=a27*a01;
a07=2.*a07;
a06=2.*a06;
a06=a06*a21;
a07=a07*a06;
a07=a27*a07;
a05=a05+a07;
a05=a02*a05;
a27=a27*a03;
a10=2.*a10;
a19=2.*a19;
a19=a19*a23;
a10=a10*a19;
a10=a27*a10;
a05=a05+a10;
a05=a25*a05;
a27=a27*a02;
a15=a15*a04;
a08=2.*a08;
a02=2.*a00;
a02=a02*a04;
a08=a08*a02;
a08=a00*a08;
a15=a15+a08;
a15=a27*a15;
a05=a05+a15;
a22=a22-a05;
a05=4.;
a15=a05*a12;
a08=-4.;
a12=a08*a12;
a02=a12*a00;
a15=a15+a02;
a22=a22/a15;
a24=a24*a00;
a17=a17*a13;
a24=a24-a17;
a14=a14*a09;
a24=a24-a14;
a18=a18*a16;
a24=a24-a18;
a26=a26*a20;
a24=a24-a26;
a27=a27*a25;
a24=a24-a27;
a24=a24/a15;
a15=a24/a15;
a05=a05*a11;
a08=a08*a11;
a00=a00*a08;
a12=a12*a04;
a00=a00+a12;
a05=a05+a00;
a15=a15*a05;
a22=a22-a15;
a24=sqrt(a24);
a24=2.*a24;
a22=a22/a24;
if (res[1]!=0) res[1][0]=a22;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_at_tail_load(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f61(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_at_tail_load_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_at_tail_load_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_at_tail_load_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_at_tail_load_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_at_tail_load_n_in(void) { return 28;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_at_tail_load_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_at_tail_load_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_at_tail_load_name_in(casadi_int i) {
switch (i) {
case 0: return "tail_fraction";
case 1: return "m";
case 2: return "b";
case 3: return "rho";
case 4: return "Ap";
case 5: return "CL_gamma";
case 6: return "B3";
case 7: return "C3";
case 8: return "g";
case 9: return "K1";
case 10: return "K2";
case 11: return "K3";
case 12: return "K4";
case 13: return "out_a_loaded";
case 14: return "out_u_touch";
case 15: return "fwd_tail_fraction";
case 16: return "fwd_m";
case 17: return "fwd_b";
case 18: return "fwd_rho";
case 19: return "fwd_Ap";
case 20: return "fwd_CL_gamma";
case 21: return "fwd_B3";
case 22: return "fwd_C3";
case 23: return "fwd_g";
case 24: return "fwd_K1";
case 25: return "fwd_K2";
case 26: return "fwd_K3";
case 27: return "fwd_K4";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_at_tail_load_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_a_loaded";
case 1: return "fwd_u_touch";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_at_tail_load_sparsity_in(casadi_int i) {
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
case 11: return casadi_s0;
case 12: return casadi_s0;
case 13: return casadi_s1;
case 14: return casadi_s1;
case 15: return casadi_s0;
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
case 27: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_at_tail_load_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_at_tail_load_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 28;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_at_tail_load_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 28*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_at_tail_load:(tail_fraction,m,b,rho,Ap,CL_gamma,B3,C3,g,K1,K2,K3,K4,out_a_loaded[1x1,0nz],out_u_touch[1x1,0nz],adj_a_loaded,adj_u_touch)->(adj_tail_fraction,adj_m,adj_b,adj_rho,adj_Ap,adj_CL_gamma,adj_B3,adj_C3,adj_g,adj_K1,adj_K2,adj_K3,adj_K4) */
static int casadi_f62(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
casadi_real a60, a61, a62;
a00=arg[8]? arg[8][0] : 0;
a01=arg[1]? arg[1][0] : 0;
a02=a00*a01;
a03=arg[7]? arg[7][0] : 0;
a04=arg[2]? arg[2][0] : 0;
a05=a04*a00;
a06=5.0000000000000000e-01;
a07=arg[4]? arg[4][0] : 0;
a07=a06*a07;
a08=arg[5]? arg[5][0] : 0;
a09=a07*a08;
a10=arg[3]? arg[3][0] : 0;
a11=a09*a10;
a12=a05*a11;
a13=a03*a12;
a14=arg[9]? arg[9][0] : 0;
a15=2.*a14;
a13=a13-a15;
a15=arg[6]? arg[6][0] : 0;
a16=2.*a15;
a17=a03*a00;
a18=a17*a01;
a16=a16+a18;
a13=a13+a16;
a19=a02*a13;
a20=arg[16]? arg[16][0] : 0;
a21=arg[0]? arg[0][0] : 0;
a22=a19*a21;
a23=a16*a12;
a22=a22-a23;
a23=2.*a00;
a24=a23*a01;
a15=a15-a14;
a14=arg[10]? arg[10][0] : 0;
a25=a14*a00;
a26=a25*a01;
a15=a15+a26;
a15=a15+a18;
a18=a24*a15;
a26=casadi_sq(a21);
a27=a18*a26;
a22=a22-a27;
a27=casadi_sq(a00);
a28=casadi_sq(a01);
a29=a27*a28;
a30=arg[11]? arg[11][0] : 0;
a31=2.*a30;
a32=a31*a00;
a33=a32*a01;
a34=2.*a14;
a34=a03+a34;
a33=a33-a34;
a34=a29*a33;
a35=casadi_sq(a21);
a36=a21*a35;
a37=a34*a36;
a22=a22-a37;
a37=casadi_sq(a00);
a38=a00*a37;
a38=2.*a38;
a39=casadi_sq(a01);
a40=a01*a39;
a41=a38*a40;
a42=arg[12]? arg[12][0] : 0;
a43=a42*a00;
a44=a43*a01;
a44=a44-a30;
a30=a41*a44;
a45=casadi_sq(a21);
a46=casadi_sq(a45);
a47=a30*a46;
a22=a22-a47;
a47=-2.;
a48=a47*a42;
a49=casadi_sq(a00);
a50=casadi_sq(a49);
a51=a48*a50;
a52=casadi_sq(a01);
a53=casadi_sq(a52);
a54=a51*a53;
a55=casadi_sq(a21);
a56=casadi_sq(a55);
a57=a21*a56;
a58=a54*a57;
a22=a22-a58;
a58=4.;
a59=a58*a11;
a60=-4.;
a61=a60*a11;
a62=a61*a21;
a59=a59+a62;
a22=a22/a59;
a62=sqrt(a22);
a62=2.*a62;
a20=a20/a62;
a62=a20/a59;
a19=a19*a62;
a22=a22/a59;
a22=a22*a20;
a61=a61*a22;
a54=a54*a62;
a56=a56*a54;
a61=a61+a56;
a56=2.*a21;
a55=2.*a55;
a54=a21*a54;
a55=a55*a54;
a56=a56*a55;
a61=a61+a56;
a56=2.*a21;
a45=2.*a45;
a30=a30*a62;
a45=a45*a30;
a56=a56*a45;
a61=a61+a56;
a34=a34*a62;
a35=a35*a34;
a61=a61+a35;
a35=2.*a21;
a34=a21*a34;
a35=a35*a34;
a61=a61+a35;
a35=2.*a21;
a18=a18*a62;
a35=a35*a18;
a61=a61+a35;
a19=a19-a61;
a61=a04*a21;
a35=1.;
a35=a21-a35;
a61=a61/a35;
a61=a61/a35;
a18=arg[15]? arg[15][0] : 0;
a61=a61*a18;
a19=a19+a61;
a18=a18/a35;
a35=a04*a18;
a19=a19-a35;
if (res[0]!=0) res[0][0]=a19;
a19=a21*a62;
a02=a02*a19;
a35=a12*a62;
a35=a02-a35;
a26=a26*a62;
a24=a24*a26;
a61=a35-a24;
a17=a17*a61;
a34=2.*a01;
a52=2.*a52;
a57=a57*a62;
a51=a51*a57;
a52=a52*a51;
a34=a34*a52;
a46=a46*a62;
a41=a41*a46;
a43=a43*a41;
a34=a34+a43;
a44=a44*a46;
a38=a38*a44;
a39=a39*a38;
a34=a34+a39;
a39=2.*a01;
a38=a01*a38;
a39=a39*a38;
a34=a34+a39;
a36=a36*a62;
a29=a29*a36;
a32=a32*a29;
a34=a34+a32;
a32=2.*a01;
a33=a33*a36;
a27=a27*a33;
a32=a32*a27;
a34=a34+a32;
a25=a25*a24;
a34=a34+a25;
a15=a15*a26;
a23=a23*a15;
a34=a34+a23;
a17=a17-a34;
a13=a13*a19;
a19=a00*a13;
a17=a17+a19;
if (res[1]!=0) res[1][0]=a17;
a17=a03*a02;
a16=a16*a62;
a17=a17-a16;
a11=a11*a17;
a16=a00*a11;
a18=a21*a18;
a16=a16-a18;
if (res[2]!=0) res[2][0]=a16;
a05=a05*a17;
a21=a21*a22;
a60=a60*a21;
a58=a58*a22;
a60=a60+a58;
a05=a05-a60;
a09=a09*a05;
if (res[3]!=0) res[3][0]=a09;
a10=a10*a05;
a08=a08*a10;
a06=a06*a08;
if (res[4]!=0) res[4][0]=a06;
a07=a07*a10;
if (res[5]!=0) res[5][0]=a07;
a35=2.*a35;
a35=a35-a24;
if (res[6]!=0) res[6][0]=a35;
a61=a01*a61;
a35=a00*a61;
a35=a29+a35;
a12=a12*a02;
a35=a35+a12;
if (res[7]!=0) res[7][0]=a35;
a40=a40*a44;
a40=-a40;
a40=2.*a40;
a37=a37*a40;
a44=2.*a00;
a49=2.*a49;
a53=a53*a57;
a48=a48*a53;
a49=a49*a48;
a44=a44*a49;
a49=a01*a41;
a42=a42*a49;
a44=a44+a42;
a37=a37-a44;
a44=2.*a00;
a40=a00*a40;
a44=a44*a40;
a37=a37+a44;
a44=a01*a29;
a31=a31*a44;
a37=a37-a31;
a31=2.*a00;
a28=a28*a33;
a31=a31*a28;
a37=a37-a31;
a31=a01*a24;
a14=a14*a31;
a37=a37-a14;
a15=a01*a15;
a15=-a15;
a15=2.*a15;
a37=a37+a15;
a03=a03*a61;
a37=a37+a03;
a04=a04*a11;
a37=a37+a04;
a01=a01*a13;
a37=a37+a01;
if (res[8]!=0) res[8][0]=a37;
a02=-a02;
a02=2.*a02;
a24=a24+a02;
if (res[9]!=0) res[9][0]=a24;
a29=2.*a29;
a31=a00*a31;
a29=a29-a31;
if (res[10]!=0) res[10][0]=a29;
a44=a00*a44;
a44=-a44;
a44=2.*a44;
a41=a41+a44;
if (res[11]!=0) res[11][0]=a41;
a50=a50*a53;
a47=a47*a50;
a00=a00*a49;
a47=a47+a00;
a47=-a47;
if (res[12]!=0) res[12][0]=a47;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_at_tail_load(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f62(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_at_tail_load_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_at_tail_load_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_at_tail_load_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_at_tail_load_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_at_tail_load_n_in(void) { return 17;}
CASADI_SYMBOL_EXPORT casadi_int adj1_at_tail_load_n_out(void) { return 13;}
CASADI_SYMBOL_EXPORT casadi_real adj1_at_tail_load_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_at_tail_load_name_in(casadi_int i) {
switch (i) {
case 0: return "tail_fraction";
case 1: return "m";
case 2: return "b";
case 3: return "rho";
case 4: return "Ap";
case 5: return "CL_gamma";
case 6: return "B3";
case 7: return "C3";
case 8: return "g";
case 9: return "K1";
case 10: return "K2";
case 11: return "K3";
case 12: return "K4";
case 13: return "out_a_loaded";
case 14: return "out_u_touch";
case 15: return "adj_a_loaded";
case 16: return "adj_u_touch";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_at_tail_load_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_tail_fraction";
case 1: return "adj_m";
case 2: return "adj_b";
case 3: return "adj_rho";
case 4: return "adj_Ap";
case 5: return "adj_CL_gamma";
case 6: return "adj_B3";
case 7: return "adj_C3";
case 8: return "adj_g";
case 9: return "adj_K1";
case 10: return "adj_K2";
case 11: return "adj_K3";
case 12: return "adj_K4";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_at_tail_load_sparsity_in(casadi_int i) {
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
case 11: return casadi_s0;
case 12: return casadi_s0;
case 13: return casadi_s1;
case 14: return casadi_s1;
case 15: return casadi_s0;
case 16: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_at_tail_load_sparsity_out(casadi_int i) {
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
case 11: return casadi_s0;
case 12: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_at_tail_load_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 17;
if (sz_res) *sz_res = 13;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_at_tail_load_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 17*sizeof(const casadi_real*);
if (sz_res) *sz_res = 13*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_at_tail_load:(tail_fraction,m,b,rho,Ap,CL_gamma,B3,C3,g,K1,K2,K3,K4,out_a_loaded[1x1,0nz],out_u_touch[1x1,0nz],adj_a_loaded,adj_u_touch,out_adj_tail_fraction[1x1,0nz],out_adj_m[1x1,0nz],out_adj_b[1x1,0nz],out_adj_rho[1x1,0nz],out_adj_Ap[1x1,0nz],out_adj_CL_gamma[1x1,0nz],out_adj_B3[1x1,0nz],out_adj_C3[1x1,0nz],out_adj_g[1x1,0nz],out_adj_K1[1x1,0nz],out_adj_K2[1x1,0nz],out_adj_K3[1x1,0nz],out_adj_K4[1x1,0nz],fwd_tail_fraction,fwd_m,fwd_b,fwd_rho,fwd_Ap,fwd_CL_gamma,fwd_B3,fwd_C3,fwd_g,fwd_K1,fwd_K2,fwd_K3,fwd_K4,fwd_out_a_loaded[1x1,0nz],fwd_out_u_touch[1x1,0nz],fwd_adj_a_loaded,fwd_adj_u_touch)->(fwd_adj_tail_fraction,fwd_adj_m,fwd_adj_b,fwd_adj_rho,fwd_adj_Ap,fwd_adj_CL_gamma,fwd_adj_B3,fwd_adj_C3,fwd_adj_g,fwd_adj_K1,fwd_adj_K2,fwd_adj_K3,fwd_adj_K4) */
static int casadi_f63(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a000, a001, a002, a003, a004, a005, a006, a007, a008, a009, a010, a011;
casadi_real a012, a013, a014, a015, a016, a017, a018, a019, a020, a021, a022, a023;
casadi_real a024, a025, a026, a027, a028, a029, a030, a031, a032, a033, a034, a035;
casadi_real a036, a037, a038, a039, a040, a041, a042, a043, a044, a045, a046, a047;
casadi_real a048, a049, a050, a051, a052, a053, a054, a055, a056, a057, a058, a059;
casadi_real a060, a061, a062, a063, a064, a065, a066, a067, a068, a069, a070, a071;
casadi_real a072, a073, a074, a075, a076, a077, a078, a079, a080, a081, a082, a083;
casadi_real a084, a085, a086, a087, a088, a089, a090, a091, a092, a093, a094, a095;
casadi_real a096, a097, a098, a099, a100, a101, a102, a103, a104, a105, a106, a107;
casadi_real a108, a109, a110, a111, a112, a113, a114, a115, a116, a117, a118, a119;
casadi_real a120, a121, a122, a123, a124, a125;
a000=arg[16]? arg[16][0] : 0;
a001=arg[8]? arg[8][0] : 0;
a002=arg[1]? arg[1][0] : 0;
a003=a001*a002;
a004=arg[7]? arg[7][0] : 0;
a005=arg[2]? arg[2][0] : 0;
a006=a005*a001;
a007=5.0000000000000000e-01;
a008=arg[4]? arg[4][0] : 0;
a008=a007*a008;
a009=arg[5]? arg[5][0] : 0;
a010=a008*a009;
a011=arg[3]? arg[3][0] : 0;
a012=a010*a011;
a013=a006*a012;
a014=a004*a013;
a015=arg[9]? arg[9][0] : 0;
a016=2.*a015;
a014=a014-a016;
a016=arg[6]? arg[6][0] : 0;
a017=2.*a016;
a018=a004*a001;
a019=a018*a002;
a017=a017+a019;
a014=a014+a017;
a020=a003*a014;
a021=arg[0]? arg[0][0] : 0;
a022=a020*a021;
a023=a017*a013;
a022=a022-a023;
a023=2.*a001;
a024=a023*a002;
a016=a016-a015;
a015=arg[10]? arg[10][0] : 0;
a025=a015*a001;
a026=a025*a002;
a016=a016+a026;
a016=a016+a019;
a019=a024*a016;
a026=casadi_sq(a021);
a027=a019*a026;
a022=a022-a027;
a027=casadi_sq(a001);
a028=casadi_sq(a002);
a029=a027*a028;
a030=arg[11]? arg[11][0] : 0;
a031=2.*a030;
a032=a031*a001;
a033=a032*a002;
a034=2.*a015;
a034=a004+a034;
a033=a033-a034;
a034=a029*a033;
a035=casadi_sq(a021);
a036=a021*a035;
a037=a034*a036;
a022=a022-a037;
a037=casadi_sq(a001);
a038=a001*a037;
a038=2.*a038;
a039=casadi_sq(a002);
a040=a002*a039;
a041=a038*a040;
a042=arg[12]? arg[12][0] : 0;
a043=a042*a001;
a044=a043*a002;
a044=a044-a030;
a030=a041*a044;
a045=casadi_sq(a021);
a046=casadi_sq(a045);
a047=a030*a046;
a022=a022-a047;
a047=-2.;
a048=a047*a042;
a049=casadi_sq(a001);
a050=casadi_sq(a049);
a051=a048*a050;
a052=casadi_sq(a002);
a053=casadi_sq(a052);
a054=a051*a053;
a055=casadi_sq(a021);
a056=casadi_sq(a055);
a057=a021*a056;
a058=a054*a057;
a022=a022-a058;
a058=4.;
a059=a058*a012;
a060=-4.;
a061=a060*a012;
a062=a061*a021;
a059=a059+a062;
a022=a022/a059;
a062=sqrt(a022);
a063=2.*a062;
a000=a000/a063;
a064=a000/a059;
a065=arg[38]? arg[38][0] : 0;
a066=a002*a065;
a067=arg[31]? arg[31][0] : 0;
a068=a001*a067;
a066=a066+a068;
a068=a014*a066;
a069=arg[37]? arg[37][0] : 0;
a070=a013*a069;
a071=arg[32]? arg[32][0] : 0;
a072=a001*a071;
a073=a005*a065;
a072=a072+a073;
a073=a012*a072;
a074=arg[34]? arg[34][0] : 0;
a074=a007*a074;
a075=a009*a074;
a076=arg[35]? arg[35][0] : 0;
a077=a008*a076;
a075=a075+a077;
a077=a011*a075;
a078=arg[33]? arg[33][0] : 0;
a079=a010*a078;
a077=a077+a079;
a079=a006*a077;
a073=a073+a079;
a079=a004*a073;
a070=a070+a079;
a079=arg[39]? arg[39][0] : 0;
a080=2.*a079;
a070=a070-a080;
a080=arg[36]? arg[36][0] : 0;
a081=2.*a080;
a082=a001*a069;
a083=a004*a065;
a082=a082+a083;
a083=a002*a082;
a084=a018*a067;
a083=a083+a084;
a081=a081+a083;
a070=a070+a081;
a084=a003*a070;
a068=a068+a084;
a084=a064*a068;
a085=arg[46]? arg[46][0] : 0;
a085=a085/a063;
a063=a000/a063;
a068=a021*a068;
a086=arg[30]? arg[30][0] : 0;
a087=a020*a086;
a068=a068+a087;
a087=a013*a081;
a088=a017*a073;
a087=a087+a088;
a068=a068-a087;
a087=2.*a065;
a088=a002*a087;
a089=a023*a067;
a088=a088+a089;
a089=a016*a088;
a080=a080-a079;
a079=arg[40]? arg[40][0] : 0;
a090=a001*a079;
a091=a015*a065;
a090=a090+a091;
a091=a002*a090;
a092=a025*a067;
a091=a091+a092;
a080=a080+a091;
a080=a080+a083;
a083=a024*a080;
a089=a089+a083;
a083=a026*a089;
a091=2.*a021;
a091=a091*a086;
a092=a019*a091;
a083=a083+a092;
a068=a068-a083;
a083=2.*a001;
a083=a083*a065;
a092=a028*a083;
a093=2.*a002;
a093=a093*a067;
a094=a027*a093;
a092=a092+a094;
a094=a033*a092;
a095=arg[41]? arg[41][0] : 0;
a096=2.*a095;
a097=a001*a096;
a098=a031*a065;
a097=a097+a098;
a098=a002*a097;
a099=a032*a067;
a098=a098+a099;
a099=2.*a079;
a099=a069+a099;
a098=a098-a099;
a099=a029*a098;
a094=a094+a099;
a099=a036*a094;
a100=a035*a086;
a101=2.*a021;
a101=a101*a086;
a102=a021*a101;
a100=a100+a102;
a102=a034*a100;
a099=a099+a102;
a068=a068-a099;
a099=a037*a065;
a102=2.*a001;
a102=a102*a065;
a103=a001*a102;
a099=a099+a103;
a099=2.*a099;
a103=a040*a099;
a104=a039*a067;
a105=2.*a002;
a105=a105*a067;
a106=a002*a105;
a104=a104+a106;
a106=a038*a104;
a103=a103+a106;
a106=a044*a103;
a107=arg[42]? arg[42][0] : 0;
a108=a001*a107;
a109=a042*a065;
a108=a108+a109;
a109=a002*a108;
a110=a043*a067;
a109=a109+a110;
a109=a109-a095;
a095=a041*a109;
a106=a106+a095;
a095=a046*a106;
a110=2.*a045;
a111=2.*a021;
a111=a111*a086;
a110=a110*a111;
a112=a030*a110;
a095=a095+a112;
a068=a068-a095;
a095=a047*a107;
a112=a050*a095;
a113=2.*a049;
a114=2.*a001;
a114=a114*a065;
a113=a113*a114;
a115=a048*a113;
a112=a112+a115;
a115=a053*a112;
a116=2.*a052;
a117=2.*a002;
a117=a117*a067;
a116=a116*a117;
a118=a051*a116;
a115=a115+a118;
a118=a057*a115;
a119=a056*a086;
a120=2.*a055;
a121=2.*a021;
a121=a121*a086;
a120=a120*a121;
a122=a021*a120;
a119=a119+a122;
a122=a054*a119;
a118=a118+a122;
a068=a068-a118;
a068=a068/a059;
a118=a022/a059;
a122=a058*a077;
a123=a060*a077;
a124=a021*a123;
a125=a061*a086;
a124=a124+a125;
a122=a122+a124;
a118=a118*a122;
a068=a068-a118;
a062=2.*a062;
a062=a068/a062;
a062=2.*a062;
a063=a063*a062;
a085=a085-a063;
a063=a085/a059;
a062=a064/a059;
a062=a062*a122;
a063=a063-a062;
a020=a020*a063;
a084=a084+a020;
a022=a022/a059;
a020=a022*a000;
a123=a020*a123;
a068=a068/a059;
a059=a022/a059;
a059=a059*a122;
a068=a068-a059;
a000=a000*a068;
a022=a022*a085;
a000=a000+a022;
a061=a061*a000;
a123=a123+a061;
a061=a054*a064;
a120=a061*a120;
a115=a064*a115;
a054=a054*a063;
a115=a115+a054;
a056=a056*a115;
a120=a120+a056;
a123=a123+a120;
a055=2.*a055;
a120=a021*a061;
a056=a055*a120;
a054=2.*a086;
a056=a056*a054;
a054=2.*a021;
a121=2.*a121;
a120=a120*a121;
a061=a061*a086;
a115=a021*a115;
a061=a061+a115;
a055=a055*a061;
a120=a120+a055;
a054=a054*a120;
a056=a056+a054;
a123=a123+a056;
a045=2.*a045;
a056=a030*a064;
a054=a045*a056;
a120=2.*a086;
a054=a054*a120;
a120=2.*a021;
a111=2.*a111;
a056=a056*a111;
a106=a064*a106;
a030=a030*a063;
a106=a106+a030;
a045=a045*a106;
a056=a056+a045;
a120=a120*a056;
a054=a054+a120;
a123=a123+a054;
a054=a034*a064;
a101=a054*a101;
a094=a064*a094;
a034=a034*a063;
a094=a094+a034;
a035=a035*a094;
a101=a101+a035;
a123=a123+a101;
a101=a021*a054;
a035=2.*a086;
a101=a101*a035;
a035=2.*a021;
a054=a054*a086;
a094=a021*a094;
a054=a054+a094;
a035=a035*a054;
a101=a101+a035;
a123=a123+a101;
a101=a019*a064;
a035=2.*a086;
a101=a101*a035;
a035=2.*a021;
a089=a064*a089;
a019=a019*a063;
a089=a089+a019;
a035=a035*a089;
a101=a101+a035;
a123=a123+a101;
a084=a084-a123;
a123=arg[15]? arg[15][0] : 0;
a101=a021*a071;
a035=a005*a086;
a101=a101+a035;
a035=1.;
a035=a021-a035;
a101=a101/a035;
a089=a005*a021;
a089=a089/a035;
a019=a089/a035;
a019=a019*a086;
a101=a101-a019;
a101=a101/a035;
a089=a089/a035;
a019=a089/a035;
a019=a019*a086;
a101=a101-a019;
a101=a123*a101;
a019=arg[45]? arg[45][0] : 0;
a089=a089*a019;
a101=a101+a089;
a084=a084+a101;
a123=a123/a035;
a101=a123*a071;
a019=a019/a035;
a035=a123/a035;
a035=a035*a086;
a019=a019-a035;
a035=a005*a019;
a101=a101+a035;
a084=a084-a101;
if (res[0]!=0) res[0][0]=a084;
a084=a021*a064;
a101=a003*a084;
a035=a013*a064;
a035=a101-a035;
a089=a026*a064;
a054=a024*a089;
a035=a035-a054;
a082=a035*a082;
a066=a084*a066;
a094=a064*a086;
a034=a021*a063;
a094=a094+a034;
a003=a003*a094;
a066=a066+a003;
a003=a064*a073;
a034=a013*a063;
a003=a003+a034;
a003=a066-a003;
a088=a089*a088;
a091=a064*a091;
a026=a026*a063;
a091=a091+a026;
a024=a024*a091;
a088=a088+a024;
a024=a003-a088;
a018=a018*a024;
a082=a082+a018;
a052=2.*a052;
a018=a057*a064;
a026=a051*a018;
a034=a052*a026;
a120=2.*a067;
a034=a034*a120;
a120=2.*a002;
a117=2.*a117;
a026=a026*a117;
a112=a018*a112;
a119=a064*a119;
a057=a057*a063;
a119=a119+a057;
a051=a051*a119;
a112=a112+a051;
a052=a052*a112;
a026=a026+a052;
a120=a120*a026;
a034=a034+a120;
a120=a046*a064;
a026=a041*a120;
a108=a026*a108;
a103=a120*a103;
a110=a064*a110;
a046=a046*a063;
a110=a110+a046;
a041=a041*a110;
a103=a103+a041;
a043=a043*a103;
a108=a108+a043;
a034=a034+a108;
a108=a044*a120;
a043=a038*a108;
a105=a043*a105;
a099=a108*a099;
a120=a120*a109;
a044=a044*a110;
a120=a120+a044;
a038=a038*a120;
a099=a099+a038;
a039=a039*a099;
a105=a105+a039;
a034=a034+a105;
a105=a002*a043;
a039=2.*a067;
a105=a105*a039;
a039=2.*a002;
a043=a043*a067;
a099=a002*a099;
a043=a043+a099;
a039=a039*a043;
a105=a105+a039;
a034=a034+a105;
a105=a036*a064;
a039=a029*a105;
a097=a039*a097;
a092=a105*a092;
a100=a064*a100;
a036=a036*a063;
a100=a100+a036;
a029=a029*a100;
a092=a092+a029;
a032=a032*a092;
a097=a097+a032;
a034=a034+a097;
a097=a033*a105;
a032=a027*a097;
a029=2.*a067;
a032=a032*a029;
a029=2.*a002;
a083=a097*a083;
a105=a105*a098;
a033=a033*a100;
a105=a105+a033;
a027=a027*a105;
a083=a083+a027;
a029=a029*a083;
a032=a032+a029;
a034=a034+a032;
a090=a054*a090;
a025=a025*a088;
a090=a090+a025;
a034=a034+a090;
a090=a016*a089;
a087=a090*a087;
a089=a089*a080;
a016=a016*a091;
a089=a089+a016;
a023=a023*a089;
a087=a087+a023;
a034=a034+a087;
a082=a082-a034;
a034=a014*a084;
a087=a034*a065;
a084=a084*a070;
a014=a014*a094;
a084=a084+a014;
a014=a001*a084;
a087=a087+a014;
a082=a082+a087;
if (res[1]!=0) res[1][0]=a082;
a082=a004*a101;
a087=a017*a064;
a082=a082-a087;
a087=a012*a082;
a014=a087*a065;
a077=a082*a077;
a094=a101*a069;
a070=a004*a066;
a094=a094+a070;
a064=a064*a081;
a017=a017*a063;
a064=a064+a017;
a094=a094-a064;
a012=a012*a094;
a077=a077+a012;
a012=a001*a077;
a014=a014+a012;
a123=a123*a086;
a019=a021*a019;
a123=a123+a019;
a014=a014-a123;
if (res[2]!=0) res[2][0]=a014;
a014=a006*a082;
a123=a021*a020;
a123=a060*a123;
a019=a058*a020;
a123=a123+a019;
a014=a014-a123;
a075=a014*a075;
a082=a082*a072;
a006=a006*a094;
a082=a082+a006;
a020=a020*a086;
a021=a021*a000;
a020=a020+a021;
a060=a060*a020;
a058=a058*a000;
a060=a060+a058;
a082=a082-a060;
a010=a010*a082;
a075=a075+a010;
if (res[3]!=0) res[3][0]=a075;
a075=a011*a014;
a076=a075*a076;
a014=a014*a078;
a011=a011*a082;
a014=a014+a011;
a009=a009*a014;
a076=a076+a009;
a007=a007*a076;
if (res[4]!=0) res[4][0]=a007;
a075=a075*a074;
a008=a008*a014;
a075=a075+a008;
if (res[5]!=0) res[5][0]=a075;
a003=2.*a003;
a003=a003-a088;
if (res[6]!=0) res[6][0]=a003;
a003=a002*a035;
a075=a003*a065;
a035=a035*a067;
a024=a002*a024;
a035=a035+a024;
a024=a001*a035;
a075=a075+a024;
a075=a092+a075;
a101=a101*a073;
a013=a013*a066;
a101=a101+a013;
a075=a075+a101;
if (res[7]!=0) res[7][0]=a075;
a075=a040*a108;
a075=-a075;
a075=2.*a075;
a102=a075*a102;
a108=a108*a104;
a040=a040*a120;
a108=a108+a040;
a108=-a108;
a108=2.*a108;
a037=a037*a108;
a102=a102+a037;
a049=2.*a049;
a037=a053*a018;
a040=a048*a037;
a120=a049*a040;
a104=2.*a065;
a120=a120*a104;
a104=2.*a001;
a114=2.*a114;
a040=a040*a114;
a095=a037*a095;
a018=a018*a116;
a053=a053*a119;
a018=a018+a053;
a048=a048*a018;
a095=a095+a048;
a049=a049*a095;
a040=a040+a049;
a104=a104*a040;
a120=a120+a104;
a104=a002*a026;
a107=a104*a107;
a026=a026*a067;
a040=a002*a103;
a026=a026+a040;
a042=a042*a026;
a107=a107+a042;
a120=a120+a107;
a102=a102-a120;
a120=a001*a075;
a107=2.*a065;
a120=a120*a107;
a107=2.*a001;
a075=a075*a065;
a108=a001*a108;
a075=a075+a108;
a107=a107*a075;
a120=a120+a107;
a102=a102+a120;
a120=a002*a039;
a096=a120*a096;
a039=a039*a067;
a107=a002*a092;
a039=a039+a107;
a031=a031*a039;
a096=a096+a031;
a102=a102-a096;
a096=a028*a097;
a031=2.*a065;
a096=a096*a031;
a031=2.*a001;
a097=a097*a093;
a028=a028*a105;
a097=a097+a028;
a031=a031*a097;
a096=a096+a031;
a102=a102-a096;
a096=a002*a054;
a079=a096*a079;
a054=a054*a067;
a031=a002*a088;
a054=a054+a031;
a015=a015*a054;
a079=a079+a015;
a102=a102-a079;
a090=a090*a067;
a089=a002*a089;
a090=a090+a089;
a090=-a090;
a090=2.*a090;
a102=a102+a090;
a003=a003*a069;
a004=a004*a035;
a003=a003+a004;
a102=a102+a003;
a087=a087*a071;
a005=a005*a077;
a087=a087+a005;
a102=a102+a087;
a034=a034*a067;
a002=a002*a084;
a034=a034+a002;
a102=a102+a034;
if (res[8]!=0) res[8][0]=a102;
a066=-a066;
a066=2.*a066;
a088=a088+a066;
if (res[9]!=0) res[9][0]=a088;
a092=2.*a092;
a096=a096*a065;
a054=a001*a054;
a096=a096+a054;
a092=a092-a096;
if (res[10]!=0) res[10][0]=a092;
a120=a120*a065;
a039=a001*a039;
a120=a120+a039;
a120=-a120;
a120=2.*a120;
a103=a103+a120;
if (res[11]!=0) res[11][0]=a103;
a037=a037*a113;
a050=a050*a018;
a037=a037+a050;
a047=a047*a037;
a104=a104*a065;
a001=a001*a026;
a104=a104+a001;
a047=a047+a104;
a047=-a047;
if (res[12]!=0) res[12][0]=a047;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_at_tail_load(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f63(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_at_tail_load_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_at_tail_load_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_at_tail_load_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_at_tail_load_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_at_tail_load_n_in(void) { return 47;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_at_tail_load_n_out(void) { return 13;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_at_tail_load_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_at_tail_load_name_in(casadi_int i) {
switch (i) {
case 0: return "tail_fraction";
case 1: return "m";
case 2: return "b";
case 3: return "rho";
case 4: return "Ap";
case 5: return "CL_gamma";
case 6: return "B3";
case 7: return "C3";
case 8: return "g";
case 9: return "K1";
case 10: return "K2";
case 11: return "K3";
case 12: return "K4";
case 13: return "out_a_loaded";
case 14: return "out_u_touch";
case 15: return "adj_a_loaded";
case 16: return "adj_u_touch";
case 17: return "out_adj_tail_fraction";
case 18: return "out_adj_m";
case 19: return "out_adj_b";
case 20: return "out_adj_rho";
case 21: return "out_adj_Ap";
case 22: return "out_adj_CL_gamma";
case 23: return "out_adj_B3";
case 24: return "out_adj_C3";
case 25: return "out_adj_g";
case 26: return "out_adj_K1";
case 27: return "out_adj_K2";
case 28: return "out_adj_K3";
case 29: return "out_adj_K4";
case 30: return "fwd_tail_fraction";
case 31: return "fwd_m";
case 32: return "fwd_b";
case 33: return "fwd_rho";
case 34: return "fwd_Ap";
case 35: return "fwd_CL_gamma";
case 36: return "fwd_B3";
case 37: return "fwd_C3";
case 38: return "fwd_g";
case 39: return "fwd_K1";
case 40: return "fwd_K2";
case 41: return "fwd_K3";
case 42: return "fwd_K4";
case 43: return "fwd_out_a_loaded";
case 44: return "fwd_out_u_touch";
case 45: return "fwd_adj_a_loaded";
case 46: return "fwd_adj_u_touch";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_at_tail_load_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_tail_fraction";
case 1: return "fwd_adj_m";
case 2: return "fwd_adj_b";
case 3: return "fwd_adj_rho";
case 4: return "fwd_adj_Ap";
case 5: return "fwd_adj_CL_gamma";
case 6: return "fwd_adj_B3";
case 7: return "fwd_adj_C3";
case 8: return "fwd_adj_g";
case 9: return "fwd_adj_K1";
case 10: return "fwd_adj_K2";
case 11: return "fwd_adj_K3";
case 12: return "fwd_adj_K4";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_at_tail_load_sparsity_in(casadi_int i) {
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
case 11: return casadi_s0;
case 12: return casadi_s0;
case 13: return casadi_s1;
case 14: return casadi_s1;
case 15: return casadi_s0;
case 16: return casadi_s0;
case 17: return casadi_s1;
case 18: return casadi_s1;
case 19: return casadi_s1;
case 20: return casadi_s1;
case 21: return casadi_s1;
case 22: return casadi_s1;
case 23: return casadi_s1;
case 24: return casadi_s1;
case 25: return casadi_s1;
case 26: return casadi_s1;
case 27: return casadi_s1;
case 28: return casadi_s1;
case 29: return casadi_s1;
case 30: return casadi_s0;
case 31: return casadi_s0;
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
case 45: return casadi_s0;
case 46: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_at_tail_load_sparsity_out(casadi_int i) {
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
case 11: return casadi_s0;
case 12: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_at_tail_load_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 47;
if (sz_res) *sz_res = 13;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_at_tail_load_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 47*sizeof(const casadi_real*);
if (sz_res) *sz_res = 13*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* toe_effects:(m,Izz,a,b,u,rho,Ap,CL_gamma,C_alpha,Ct,Fz,B3,C3,h_cg,track)->(toe_pull,toe_load,toe_yaw_stiffness,toe_determinant) */
static int casadi_f64(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12;
a00=arg[8]? arg[8][0] : 0;
a01=arg[14]? arg[14][0] : 0;
a02=a00*a01;
if (res[0]!=0) res[0][0]=a02;
a03=arg[11]? arg[11][0] : 0;
a04=arg[12]? arg[12][0] : 0;
a04=2.*a04;
a05=arg[10]? arg[10][0] : 0;
a04=a04*a05;
a03=a03+a04;
a04=2.*a03;
a05=arg[2]? arg[2][0] : 0;
a04=a04*a05;
a06=arg[13]? arg[13][0] : 0;
a04=a04*a06;
a07=2.*a00;
a08=arg[9]? arg[9][0] : 0;
a09=5.0000000000000000e-01;
a10=arg[6]? arg[6][0] : 0;
a09=a09*a10;
a10=arg[7]? arg[7][0] : 0;
a09=a09*a10;
a10=arg[5]? arg[5][0] : 0;
a09=a09*a10;
a10=arg[4]? arg[4][0] : 0;
a11=casadi_sq(a10);
a09=a09*a11;
a08=a08+a09;
a07=a07+a08;
a04=a04*a07;
a04=a04/a01;
if (res[1]!=0) res[1][0]=a04;
a02=a02-a04;
if (res[2]!=0) res[2][0]=a02;
a02=4.;
a04=a02*a00;
a04=a04*a03;
a04=a04*a05;
a04=a04*a06;
a07=arg[0]? arg[0][0] : 0;
a04=a04*a07;
a09=casadi_sq(a10);
a04=a04*a09;
a09=a00*a08;
a09=a09*a05;
a11=casadi_sq(a01);
a09=a09*a11;
a04=a04+a09;
a09=a00*a08;
a11=arg[3]? arg[3][0] : 0;
a09=a09*a11;
a12=casadi_sq(a01);
a09=a09*a12;
a04=a04+a09;
a09=a00*a07;
a12=casadi_sq(a01);
a09=a09*a12;
a12=casadi_sq(a10);
a09=a09*a12;
a04=a04-a09;
a09=2.*a03;
a09=a09*a08;
a09=a09*a05;
a09=a09*a06;
a09=a09*a07;
a12=casadi_sq(a10);
a09=a09*a12;
a04=a04+a09;
a09=8.;
a09=a09*a08;
a09=a09*a05;
a09=a09*a11;
a00=a00*a03;
a00=a00*a06;
a09=a09*a00;
a04=a04-a09;
a05=casadi_sq(a05);
a02=a02*a08;
a02=a02*a00;
a05=a05*a02;
a04=a04-a05;
a11=casadi_sq(a11);
a11=a11*a02;
a04=a04-a11;
a11=arg[1]? arg[1][0] : 0;
a11=a11*a07;
a11=a11*a01;
a10=casadi_sq(a10);
a11=a11*a10;
a04=a04/a11;
a04=-a04;
if (res[3]!=0) res[3][0]=a04;
return 0;
}
CASADI_SYMBOL_EXPORT int toe_effects(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f64(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int toe_effects_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void toe_effects_release(int mem) {
}
CASADI_SYMBOL_EXPORT void toe_effects_incref(void) {
}
CASADI_SYMBOL_EXPORT void toe_effects_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int toe_effects_n_in(void) { return 15;}
CASADI_SYMBOL_EXPORT casadi_int toe_effects_n_out(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_real toe_effects_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* toe_effects_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "Izz";
case 2: return "a";
case 3: return "b";
case 4: return "u";
case 5: return "rho";
case 6: return "Ap";
case 7: return "CL_gamma";
case 8: return "C_alpha";
case 9: return "Ct";
case 10: return "Fz";
case 11: return "B3";
case 12: return "C3";
case 13: return "h_cg";
case 14: return "track";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* toe_effects_name_out(casadi_int i) {
switch (i) {
case 0: return "toe_pull";
case 1: return "toe_load";
case 2: return "toe_yaw_stiffness";
case 3: return "toe_determinant";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* toe_effects_sparsity_in(casadi_int i) {
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
case 11: return casadi_s0;
case 12: return casadi_s0;
case 13: return casadi_s0;
case 14: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* toe_effects_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int toe_effects_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 15;
if (sz_res) *sz_res = 4;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int toe_effects_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 15*sizeof(const casadi_real*);
if (sz_res) *sz_res = 4*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_toe_effects:(m,Izz,a,b,u,rho,Ap,CL_gamma,C_alpha,Ct,Fz,B3,C3,h_cg,track,out_toe_pull[1x1,0nz],out_toe_load[1x1,0nz],out_toe_yaw_stiffness[1x1,0nz],out_toe_determinant[1x1,0nz],fwd_m,fwd_Izz,fwd_a,fwd_b,fwd_u,fwd_rho,fwd_Ap,fwd_CL_gamma,fwd_C_alpha,fwd_Ct,fwd_Fz,fwd_B3,fwd_C3,fwd_h_cg,fwd_track)->(fwd_toe_pull,fwd_toe_load,fwd_toe_yaw_stiffness,fwd_toe_determinant) */
static int casadi_f65(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34;
a00=arg[14]? arg[14][0] : 0;
a01=arg[27]? arg[27][0] : 0;
a02=a00*a01;
a03=arg[8]? arg[8][0] : 0;
a04=arg[33]? arg[33][0] : 0;
a05=a03*a04;
a02=a02+a05;
if (res[0]!=0) res[0][0]=a02;
a05=2.*a03;
a06=arg[9]? arg[9][0] : 0;
a07=5.0000000000000000e-01;
a08=arg[6]? arg[6][0] : 0;
a08=a07*a08;
a09=arg[7]? arg[7][0] : 0;
a10=a08*a09;
a11=arg[5]? arg[5][0] : 0;
a12=a10*a11;
a13=arg[4]? arg[4][0] : 0;
a14=casadi_sq(a13);
a15=a12*a14;
a06=a06+a15;
a05=a05+a06;
a15=arg[13]? arg[13][0] : 0;
a16=arg[2]? arg[2][0] : 0;
a17=arg[30]? arg[30][0] : 0;
a18=arg[10]? arg[10][0] : 0;
a19=arg[31]? arg[31][0] : 0;
a19=2.*a19;
a19=a18*a19;
a20=arg[12]? arg[12][0] : 0;
a20=2.*a20;
a21=arg[29]? arg[29][0] : 0;
a21=a20*a21;
a19=a19+a21;
a17=a17+a19;
a19=2.*a17;
a19=a16*a19;
a21=arg[11]? arg[11][0] : 0;
a20=a20*a18;
a21=a21+a20;
a20=2.*a21;
a18=arg[21]? arg[21][0] : 0;
a22=a20*a18;
a19=a19+a22;
a19=a15*a19;
a20=a20*a16;
a22=arg[32]? arg[32][0] : 0;
a23=a20*a22;
a19=a19+a23;
a19=a05*a19;
a20=a20*a15;
a23=2.*a01;
a24=arg[28]? arg[28][0] : 0;
a25=arg[25]? arg[25][0] : 0;
a07=a07*a25;
a09=a09*a07;
a07=arg[26]? arg[26][0] : 0;
a08=a08*a07;
a09=a09+a08;
a11=a11*a09;
a09=arg[24]? arg[24][0] : 0;
a10=a10*a09;
a11=a11+a10;
a14=a14*a11;
a11=2.*a13;
a10=arg[23]? arg[23][0] : 0;
a11=a11*a10;
a12=a12*a11;
a14=a14+a12;
a24=a24+a14;
a23=a23+a24;
a23=a20*a23;
a19=a19+a23;
a19=a19/a00;
a20=a20*a05;
a20=a20/a00;
a20=a20/a00;
a20=a20*a04;
a19=a19-a20;
if (res[1]!=0) res[1][0]=a19;
a02=a02-a19;
if (res[2]!=0) res[2][0]=a02;
a02=casadi_sq(a13);
a19=arg[0]? arg[0][0] : 0;
a20=4.;
a05=a20*a01;
a05=a21*a05;
a23=a20*a03;
a14=a23*a17;
a05=a05+a14;
a05=a16*a05;
a23=a23*a21;
a14=a23*a18;
a05=a05+a14;
a05=a15*a05;
a23=a23*a16;
a14=a23*a22;
a05=a05+a14;
a05=a19*a05;
a23=a23*a15;
a14=arg[19]? arg[19][0] : 0;
a12=a23*a14;
a05=a05+a12;
a05=a02*a05;
a23=a23*a19;
a12=2.*a13;
a12=a12*a10;
a12=a23*a12;
a05=a05+a12;
a12=casadi_sq(a00);
a11=a06*a01;
a09=a03*a24;
a11=a11+a09;
a11=a16*a11;
a09=a03*a06;
a08=a09*a18;
a11=a11+a08;
a11=a12*a11;
a09=a09*a16;
a08=2.*a00;
a08=a08*a04;
a08=a09*a08;
a11=a11+a08;
a05=a05+a11;
a11=casadi_sq(a00);
a08=arg[3]? arg[3][0] : 0;
a07=a06*a01;
a25=a03*a24;
a07=a07+a25;
a07=a08*a07;
a25=a03*a06;
a26=arg[22]? arg[22][0] : 0;
a27=a25*a26;
a07=a07+a27;
a07=a11*a07;
a25=a25*a08;
a27=2.*a00;
a27=a27*a04;
a27=a25*a27;
a07=a07+a27;
a05=a05+a07;
a07=casadi_sq(a13);
a27=casadi_sq(a00);
a28=a19*a01;
a29=a03*a14;
a28=a28+a29;
a28=a27*a28;
a29=a03*a19;
a30=2.*a00;
a30=a30*a04;
a30=a29*a30;
a28=a28+a30;
a28=a07*a28;
a29=a29*a27;
a27=2.*a13;
a27=a27*a10;
a27=a29*a27;
a28=a28+a27;
a05=a05-a28;
a28=casadi_sq(a13);
a27=2.*a17;
a27=a06*a27;
a30=2.*a21;
a31=a30*a24;
a27=a27+a31;
a27=a16*a27;
a30=a30*a06;
a31=a30*a18;
a27=a27+a31;
a27=a15*a27;
a30=a30*a16;
a31=a30*a22;
a27=a27+a31;
a27=a19*a27;
a30=a30*a15;
a31=a30*a14;
a27=a27+a31;
a27=a28*a27;
a30=a30*a19;
a31=2.*a13;
a31=a31*a10;
a31=a30*a31;
a27=a27+a31;
a05=a05+a27;
a27=a03*a21;
a31=a27*a15;
a32=8.;
a33=a32*a24;
a33=a16*a33;
a32=a32*a06;
a34=a32*a18;
a33=a33+a34;
a33=a08*a33;
a32=a32*a16;
a34=a32*a26;
a33=a33+a34;
a33=a31*a33;
a32=a32*a08;
a21=a21*a01;
a03=a03*a17;
a21=a21+a03;
a15=a15*a21;
a27=a27*a22;
a15=a15+a27;
a27=a32*a15;
a33=a33+a27;
a05=a05-a33;
a06=a20*a06;
a33=a06*a31;
a27=2.*a16;
a27=a27*a18;
a27=a33*a27;
a16=casadi_sq(a16);
a20=a20*a24;
a20=a31*a20;
a06=a06*a15;
a20=a20+a06;
a06=a16*a20;
a27=a27+a06;
a05=a05-a27;
a27=2.*a08;
a27=a27*a26;
a27=a33*a27;
a08=casadi_sq(a08);
a20=a08*a20;
a27=a27+a20;
a05=a05-a27;
a27=arg[1]? arg[1][0] : 0;
a20=a27*a19;
a26=a20*a00;
a06=casadi_sq(a13);
a15=a26*a06;
a05=a05/a15;
a23=a23*a02;
a09=a09*a12;
a23=a23+a09;
a25=a25*a11;
a23=a23+a25;
a29=a29*a07;
a23=a23-a29;
a30=a30*a28;
a23=a23+a30;
a32=a32*a31;
a23=a23-a32;
a16=a16*a33;
a23=a23-a16;
a08=a08*a33;
a23=a23-a08;
a23=a23/a15;
a23=a23/a15;
a15=arg[20]? arg[20][0] : 0;
a19=a19*a15;
a27=a27*a14;
a19=a19+a27;
a00=a00*a19;
a20=a20*a04;
a00=a00+a20;
a06=a06*a00;
a13=2.*a13;
a13=a13*a10;
a26=a26*a13;
a06=a06+a26;
a23=a23*a06;
a05=a05-a23;
a05=-a05;
if (res[3]!=0) res[3][0]=a05;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_toe_effects(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f65(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_toe_effects_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_toe_effects_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_toe_effects_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_toe_effects_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_toe_effects_n_in(void) { return 34;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_toe_effects_n_out(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_toe_effects_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_toe_effects_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "Izz";
case 2: return "a";
case 3: return "b";
case 4: return "u";
case 5: return "rho";
case 6: return "Ap";
case 7: return "CL_gamma";
case 8: return "C_alpha";
case 9: return "Ct";
case 10: return "Fz";
case 11: return "B3";
case 12: return "C3";
case 13: return "h_cg";
case 14: return "track";
case 15: return "out_toe_pull";
case 16: return "out_toe_load";
case 17: return "out_toe_yaw_stiffness";
case 18: return "out_toe_determinant";
case 19: return "fwd_m";
case 20: return "fwd_Izz";
case 21: return "fwd_a";
case 22: return "fwd_b";
case 23: return "fwd_u";
case 24: return "fwd_rho";
case 25: return "fwd_Ap";
case 26: return "fwd_CL_gamma";
case 27: return "fwd_C_alpha";
case 28: return "fwd_Ct";
case 29: return "fwd_Fz";
case 30: return "fwd_B3";
case 31: return "fwd_C3";
case 32: return "fwd_h_cg";
case 33: return "fwd_track";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_toe_effects_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_toe_pull";
case 1: return "fwd_toe_load";
case 2: return "fwd_toe_yaw_stiffness";
case 3: return "fwd_toe_determinant";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_toe_effects_sparsity_in(casadi_int i) {
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
case 11: return casadi_s0;
case 12: return casadi_s0;
case 13: return casadi_s0;
case 14: return casadi_s0;
case 15: return casadi_s1;
case 16: return casadi_s1;
case 17: return casadi_s1;
case 18: return casadi_s1;
case 19: return casadi_s0;
case 20: return casadi_s0;
case 21: return casadi_s0;
case 22: return casadi_s0;
case 23: return casadi_s0;
case 24: return casadi_s0;
case 25: return casadi_s0;
case 26: return casadi_s0;
case 27: return casadi_s0;
case 28: return casadi_s0;
case 29: return casadi_s0;
case 30: return casadi_s0;
case 31: return casadi_s0;
case 32: return casadi_s0;
case 33: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_toe_effects_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_toe_effects_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 34;
if (sz_res) *sz_res = 4;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_toe_effects_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 34*sizeof(const casadi_real*);
if (sz_res) *sz_res = 4*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_toe_effects:(m,Izz,a,b,u,rho,Ap,CL_gamma,C_alpha,Ct,Fz,B3,C3,h_cg,track,out_toe_pull[1x1,0nz],out_toe_load[1x1,0nz],out_toe_yaw_stiffness[1x1,0nz],out_toe_determinant[1x1,0nz],adj_toe_pull,adj_toe_load,adj_toe_yaw_stiffness,adj_toe_determinant)->(adj_m,adj_Izz,adj_a,adj_b,adj_u,adj_rho,adj_Ap,adj_CL_gamma,adj_C_alpha,adj_Ct,adj_Fz,adj_B3,adj_C3,adj_h_cg,adj_track) */
static int casadi_f66(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
casadi_real a60, a61, a62;
a00=arg[1]? arg[1][0] : 0;
a01=arg[14]? arg[14][0] : 0;
a02=arg[4]? arg[4][0] : 0;
a03=casadi_sq(a02);
a04=4.;
a05=arg[8]? arg[8][0] : 0;
a06=a04*a05;
a07=arg[11]? arg[11][0] : 0;
a08=arg[12]? arg[12][0] : 0;
a08=2.*a08;
a09=arg[10]? arg[10][0] : 0;
a10=a08*a09;
a07=a07+a10;
a10=a06*a07;
a11=arg[2]? arg[2][0] : 0;
a12=a10*a11;
a13=arg[13]? arg[13][0] : 0;
a14=a12*a13;
a15=arg[0]? arg[0][0] : 0;
a16=a14*a15;
a17=casadi_sq(a02);
a18=a16*a17;
a19=arg[9]? arg[9][0] : 0;
a20=5.0000000000000000e-01;
a21=arg[6]? arg[6][0] : 0;
a21=a20*a21;
a22=arg[7]? arg[7][0] : 0;
a23=a21*a22;
a24=arg[5]? arg[5][0] : 0;
a25=a23*a24;
a26=casadi_sq(a02);
a27=a25*a26;
a19=a19+a27;
a27=a05*a19;
a28=a27*a11;
a29=casadi_sq(a01);
a30=a28*a29;
a18=a18+a30;
a30=a05*a19;
a31=arg[3]? arg[3][0] : 0;
a32=a30*a31;
a33=casadi_sq(a01);
a34=a32*a33;
a18=a18+a34;
a34=a05*a15;
a35=casadi_sq(a01);
a36=a34*a35;
a37=casadi_sq(a02);
a38=a36*a37;
a18=a18-a38;
a38=2.*a07;
a39=a38*a19;
a40=a39*a11;
a41=a40*a13;
a42=a41*a15;
a43=casadi_sq(a02);
a44=a42*a43;
a18=a18+a44;
a44=8.;
a45=a44*a19;
a46=a45*a11;
a47=a46*a31;
a48=a05*a07;
a49=a48*a13;
a50=a47*a49;
a18=a18-a50;
a50=casadi_sq(a11);
a51=a04*a19;
a52=a51*a49;
a53=a50*a52;
a18=a18-a53;
a53=casadi_sq(a31);
a54=a53*a52;
a18=a18-a54;
a54=a00*a15;
a55=a54*a01;
a56=a55*a03;
a18=a18/a56;
a18=a18/a56;
a57=arg[22]? arg[22][0] : 0;
a18=a18*a57;
a03=a03*a18;
a58=a01*a03;
a00=a00*a58;
a57=a57/a56;
a43=a43*a57;
a41=a41*a43;
a00=a00-a41;
a37=a37*a57;
a35=a35*a37;
a41=a05*a35;
a00=a00+a41;
a17=a17*a57;
a14=a14*a17;
a00=a00-a14;
if (res[0]!=0) res[0][0]=a00;
a58=a15*a58;
if (res[1]!=0) res[1][0]=a58;
a58=2.*a11;
a00=a52*a57;
a58=a58*a00;
a00=a49*a57;
a14=a31*a00;
a45=a45*a14;
a58=a58+a45;
a43=a15*a43;
a45=a13*a43;
a39=a39*a45;
a58=a58-a39;
a29=a29*a57;
a27=a27*a29;
a58=a58-a27;
a17=a15*a17;
a27=a13*a17;
a10=a10*a27;
a58=a58-a10;
a10=2.*a07;
a39=2.*a05;
a39=a39+a19;
a41=arg[20]? arg[20][0] : 0;
a56=arg[21]? arg[21][0] : 0;
a41=a41-a56;
a59=a41/a01;
a60=a39*a59;
a61=a13*a60;
a62=a10*a61;
a58=a58+a62;
if (res[2]!=0) res[2][0]=a58;
a58=2.*a31;
a52=a52*a57;
a58=a58*a52;
a46=a46*a00;
a58=a58+a46;
a33=a33*a57;
a30=a30*a33;
a58=a58-a30;
if (res[3]!=0) res[3][0]=a58;
a58=2.*a02;
a55=a55*a18;
a58=a58*a55;
a55=2.*a02;
a42=a42*a57;
a55=a55*a42;
a58=a58-a55;
a55=2.*a02;
a36=a36*a57;
a55=a55*a36;
a58=a58+a55;
a55=2.*a02;
a16=a16*a57;
a55=a55*a16;
a58=a58-a55;
a02=2.*a02;
a53=a53*a57;
a50=a50*a57;
a53=a53+a50;
a49=a49*a53;
a49=a04*a49;
a14=a11*a14;
a44=a44*a14;
a49=a49+a44;
a45=a11*a45;
a38=a38*a45;
a49=a49-a38;
a31=a31*a33;
a33=a05*a31;
a49=a49-a33;
a29=a11*a29;
a33=a05*a29;
a49=a49-a33;
a10=a10*a11;
a33=a10*a13;
a59=a33*a59;
a49=a49+a59;
a25=a25*a49;
a02=a02*a25;
a58=a58+a02;
if (res[4]!=0) res[4][0]=a58;
a26=a26*a49;
a23=a23*a26;
if (res[5]!=0) res[5][0]=a23;
a24=a24*a26;
a22=a22*a24;
a20=a20*a22;
if (res[6]!=0) res[6][0]=a20;
a21=a21*a24;
if (res[7]!=0) res[7][0]=a21;
a51=a51*a53;
a47=a47*a57;
a51=a51+a47;
a13=a13*a51;
a47=a07*a13;
a15=a15*a35;
a47=a47+a15;
a31=a19*a31;
a47=a47-a31;
a29=a19*a29;
a47=a47-a29;
a27=a11*a27;
a07=a07*a27;
a04=a04*a07;
a47=a47-a04;
a59=2.*a59;
a47=a47+a59;
a59=arg[19]? arg[19][0] : 0;
a56=a56+a59;
a59=a01*a56;
a47=a47+a59;
if (res[8]!=0) res[8][0]=a47;
if (res[9]!=0) res[9][0]=a49;
a13=a05*a13;
a19=a19*a45;
a19=-a19;
a19=2.*a19;
a13=a13+a19;
a06=a06*a27;
a13=a13-a06;
a11=a11*a61;
a11=2.*a11;
a13=a13+a11;
a08=a08*a13;
if (res[10]!=0) res[10][0]=a08;
if (res[11]!=0) res[11][0]=a13;
a09=a09*a13;
a09=2.*a09;
if (res[12]!=0) res[12][0]=a09;
a48=a48*a51;
a40=a40*a43;
a48=a48-a40;
a12=a12*a17;
a48=a48-a12;
a10=a10*a60;
a48=a48+a10;
if (res[13]!=0) res[13][0]=a48;
a54=a54*a03;
a03=2.*a01;
a34=a34*a37;
a03=a03*a34;
a54=a54+a03;
a03=2.*a01;
a32=a32*a57;
a03=a03*a32;
a54=a54-a03;
a03=2.*a01;
a28=a28*a57;
a03=a03*a28;
a54=a54-a03;
a33=a33*a39;
a33=a33/a01;
a33=a33/a01;
a33=a33*a41;
a54=a54-a33;
a05=a05*a56;
a54=a54+a05;
if (res[14]!=0) res[14][0]=a54;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_toe_effects(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f66(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_toe_effects_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_toe_effects_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_toe_effects_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_toe_effects_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_toe_effects_n_in(void) { return 23;}
CASADI_SYMBOL_EXPORT casadi_int adj1_toe_effects_n_out(void) { return 15;}
CASADI_SYMBOL_EXPORT casadi_real adj1_toe_effects_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_toe_effects_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "Izz";
case 2: return "a";
case 3: return "b";
case 4: return "u";
case 5: return "rho";
case 6: return "Ap";
case 7: return "CL_gamma";
case 8: return "C_alpha";
case 9: return "Ct";
case 10: return "Fz";
case 11: return "B3";
case 12: return "C3";
case 13: return "h_cg";
case 14: return "track";
case 15: return "out_toe_pull";
case 16: return "out_toe_load";
case 17: return "out_toe_yaw_stiffness";
case 18: return "out_toe_determinant";
case 19: return "adj_toe_pull";
case 20: return "adj_toe_load";
case 21: return "adj_toe_yaw_stiffness";
case 22: return "adj_toe_determinant";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_toe_effects_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_m";
case 1: return "adj_Izz";
case 2: return "adj_a";
case 3: return "adj_b";
case 4: return "adj_u";
case 5: return "adj_rho";
case 6: return "adj_Ap";
case 7: return "adj_CL_gamma";
case 8: return "adj_C_alpha";
case 9: return "adj_Ct";
case 10: return "adj_Fz";
case 11: return "adj_B3";
case 12: return "adj_C3";
case 13: return "adj_h_cg";
case 14: return "adj_track";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_toe_effects_sparsity_in(casadi_int i) {
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
case 11: return casadi_s0;
case 12: return casadi_s0;
case 13: return casadi_s0;
case 14: return casadi_s0;
case 15: return casadi_s1;
case 16: return casadi_s1;
case 17: return casadi_s1;
case 18: return casadi_s1;
case 19: return casadi_s0;
case 20: return casadi_s0;
case 21: return casadi_s0;
case 22: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_toe_effects_sparsity_out(casadi_int i) {
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
case 11: return casadi_s0;
case 12: return casadi_s0;
case 13: return casadi_s0;
case 14: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_toe_effects_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 23;
if (sz_res) *sz_res = 15;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_toe_effects_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 23*sizeof(const casadi_real*);
if (sz_res) *sz_res = 15*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_toe_effects:(m,Izz,a,b,u,rho,Ap,CL_gamma,C_alpha,Ct,Fz,B3,C3,h_cg,track,out_toe_pull[1x1,0nz],out_toe_load[1x1,0nz],out_toe_yaw_stiffness[1x1,0nz],out_toe_determinant[1x1,0nz],adj_toe_pull,adj_toe_load,adj_toe_yaw_stiffness,adj_toe_determinant,out_adj_m[1x1,0nz],out_adj_Izz[1x1,0nz],out_adj_a[1x1,0nz],out_adj_b[1x1,0nz],out_adj_u[1x1,0nz],out_adj_rho[1x1,0nz],out_adj_Ap[1x1,0nz],out_adj_CL_gamma[1x1,0nz],out_adj_C_alpha[1x1,0nz],out_adj_Ct[1x1,0nz],out_adj_Fz[1x1,0nz],out_adj_B3[1x1,0nz],out_adj_C3[1x1,0nz],out_adj_h_cg[1x1,0nz],out_adj_track[1x1,0nz],fwd_m,fwd_Izz,fwd_a,fwd_b,fwd_u,fwd_rho,fwd_Ap,fwd_CL_gamma,fwd_C_alpha,fwd_Ct,fwd_Fz,fwd_B3,fwd_C3,fwd_h_cg,fwd_track,fwd_out_toe_pull[1x1,0nz],fwd_out_toe_load[1x1,0nz],fwd_out_toe_yaw_stiffness[1x1,0nz],fwd_out_toe_determinant[1x1,0nz],fwd_adj_toe_pull,fwd_adj_toe_load,fwd_adj_toe_yaw_stiffness,fwd_adj_toe_determinant)->(fwd_adj_m,fwd_adj_Izz,fwd_adj_a,fwd_adj_b,fwd_adj_u,fwd_adj_rho,fwd_adj_Ap,fwd_adj_CL_gamma,fwd_adj_C_alpha,fwd_adj_Ct,fwd_adj_Fz,fwd_adj_B3,fwd_adj_C3,fwd_adj_h_cg,fwd_adj_track) */
static int casadi_f67(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a000, a001, a002, a003, a004, a005, a006, a007, a008, a009, a010, a011;
casadi_real a012, a013, a014, a015, a016, a017, a018, a019, a020, a021, a022, a023;
casadi_real a024, a025, a026, a027, a028, a029, a030, a031, a032, a033, a034, a035;
casadi_real a036, a037, a038, a039, a040, a041, a042, a043, a044, a045, a046, a047;
casadi_real a048, a049, a050, a051, a052, a053, a054, a055, a056, a057, a058, a059;
casadi_real a060, a061, a062, a063, a064, a065, a066, a067, a068, a069, a070, a071;
casadi_real a072, a073, a074, a075, a076, a077, a078, a079, a080, a081, a082, a083;
casadi_real a084, a085, a086, a087, a088, a089, a090, a091, a092, a093, a094, a095;
casadi_real a096, a097, a098, a099, a100, a101, a102, a103, a104, a105, a106, a107;
casadi_real a108, a109, a110, a111, a112, a113, a114, a115, a116, a117, a118, a119;
casadi_real a120, a121;
a000=arg[14]? arg[14][0] : 0;
a001=arg[4]? arg[4][0] : 0;
a002=casadi_sq(a001);
a003=4.;
a004=arg[8]? arg[8][0] : 0;
a005=a003*a004;
a006=arg[11]? arg[11][0] : 0;
a007=arg[12]? arg[12][0] : 0;
a007=2.*a007;
a008=arg[10]? arg[10][0] : 0;
a009=a007*a008;
a006=a006+a009;
a009=a005*a006;
a010=arg[2]? arg[2][0] : 0;
a011=a009*a010;
a012=arg[13]? arg[13][0] : 0;
a013=a011*a012;
a014=arg[0]? arg[0][0] : 0;
a015=a013*a014;
a016=casadi_sq(a001);
a017=a015*a016;
a018=arg[9]? arg[9][0] : 0;
a019=5.0000000000000000e-01;
a020=arg[6]? arg[6][0] : 0;
a020=a019*a020;
a021=arg[7]? arg[7][0] : 0;
a022=a020*a021;
a023=arg[5]? arg[5][0] : 0;
a024=a022*a023;
a025=casadi_sq(a001);
a026=a024*a025;
a018=a018+a026;
a026=a004*a018;
a027=a026*a010;
a028=casadi_sq(a000);
a029=a027*a028;
a017=a017+a029;
a029=a004*a018;
a030=arg[3]? arg[3][0] : 0;
a031=a029*a030;
a032=casadi_sq(a000);
a033=a031*a032;
a017=a017+a033;
a033=a004*a014;
a034=casadi_sq(a000);
a035=a033*a034;
a036=casadi_sq(a001);
a037=a035*a036;
a017=a017-a037;
a037=2.*a006;
a038=a037*a018;
a039=a038*a010;
a040=a039*a012;
a041=a040*a014;
a042=casadi_sq(a001);
a043=a041*a042;
a017=a017+a043;
a043=8.;
a044=a043*a018;
a045=a044*a010;
a046=a045*a030;
a047=a004*a006;
a048=a047*a012;
a049=a046*a048;
a017=a017-a049;
a049=casadi_sq(a010);
a050=a003*a018;
a051=a050*a048;
a052=a049*a051;
a017=a017-a052;
a052=casadi_sq(a030);
a053=a052*a051;
a017=a017-a053;
a053=arg[1]? arg[1][0] : 0;
a054=a053*a014;
a055=a054*a000;
a056=a055*a002;
a017=a017/a056;
a057=a017/a056;
a058=arg[22]? arg[22][0] : 0;
a059=a057*a058;
a060=a002*a059;
a061=a000*a060;
a062=arg[39]? arg[39][0] : 0;
a063=a061*a062;
a064=arg[52]? arg[52][0] : 0;
a065=a060*a064;
a066=2.*a001;
a067=arg[42]? arg[42][0] : 0;
a066=a066*a067;
a068=a059*a066;
a069=arg[46]? arg[46][0] : 0;
a070=a003*a069;
a071=a006*a070;
a072=arg[49]? arg[49][0] : 0;
a073=arg[50]? arg[50][0] : 0;
a073=2.*a073;
a074=a008*a073;
a075=arg[48]? arg[48][0] : 0;
a076=a007*a075;
a074=a074+a076;
a072=a072+a074;
a074=a005*a072;
a071=a071+a074;
a074=a010*a071;
a076=arg[40]? arg[40][0] : 0;
a077=a009*a076;
a074=a074+a077;
a077=a012*a074;
a078=arg[51]? arg[51][0] : 0;
a079=a011*a078;
a077=a077+a079;
a079=a014*a077;
a080=arg[38]? arg[38][0] : 0;
a081=a013*a080;
a079=a079+a081;
a081=a016*a079;
a082=2.*a001;
a082=a082*a067;
a083=a015*a082;
a081=a081+a083;
a083=a018*a069;
a084=arg[47]? arg[47][0] : 0;
a085=arg[44]? arg[44][0] : 0;
a085=a019*a085;
a086=a021*a085;
a087=arg[45]? arg[45][0] : 0;
a088=a020*a087;
a086=a086+a088;
a088=a023*a086;
a089=arg[43]? arg[43][0] : 0;
a090=a022*a089;
a088=a088+a090;
a090=a025*a088;
a091=2.*a001;
a091=a091*a067;
a092=a024*a091;
a090=a090+a092;
a084=a084+a090;
a090=a004*a084;
a083=a083+a090;
a090=a010*a083;
a092=a026*a076;
a090=a090+a092;
a092=a028*a090;
a093=2.*a000;
a093=a093*a064;
a094=a027*a093;
a092=a092+a094;
a081=a081+a092;
a092=a018*a069;
a094=a004*a084;
a092=a092+a094;
a094=a030*a092;
a095=arg[41]? arg[41][0] : 0;
a096=a029*a095;
a094=a094+a096;
a096=a032*a094;
a097=2.*a000;
a097=a097*a064;
a098=a031*a097;
a096=a096+a098;
a081=a081+a096;
a096=a014*a069;
a098=a004*a080;
a096=a096+a098;
a098=a034*a096;
a099=2.*a000;
a099=a099*a064;
a100=a033*a099;
a098=a098+a100;
a100=a036*a098;
a101=2.*a001;
a101=a101*a067;
a102=a035*a101;
a100=a100+a102;
a081=a081-a100;
a100=2.*a072;
a102=a018*a100;
a103=a037*a084;
a102=a102+a103;
a103=a010*a102;
a104=a038*a076;
a103=a103+a104;
a104=a012*a103;
a105=a039*a078;
a104=a104+a105;
a105=a014*a104;
a106=a040*a080;
a105=a105+a106;
a106=a042*a105;
a107=2.*a001;
a107=a107*a067;
a108=a041*a107;
a106=a106+a108;
a081=a081+a106;
a106=a043*a084;
a108=a010*a106;
a109=a044*a076;
a108=a108+a109;
a109=a030*a108;
a110=a045*a095;
a109=a109+a110;
a110=a048*a109;
a111=a006*a069;
a112=a004*a072;
a111=a111+a112;
a112=a012*a111;
a113=a047*a078;
a112=a112+a113;
a113=a046*a112;
a110=a110+a113;
a081=a081-a110;
a110=2.*a010;
a110=a110*a076;
a113=a051*a110;
a114=a003*a084;
a115=a048*a114;
a116=a050*a112;
a115=a115+a116;
a116=a049*a115;
a113=a113+a116;
a081=a081-a113;
a113=2.*a030;
a113=a113*a095;
a116=a051*a113;
a117=a052*a115;
a116=a116+a117;
a081=a081-a116;
a081=a081/a056;
a017=a017/a056;
a062=a014*a062;
a116=a053*a080;
a062=a062+a116;
a116=a000*a062;
a117=a054*a064;
a116=a116+a117;
a117=a002*a116;
a066=a055*a066;
a117=a117+a066;
a017=a017*a117;
a081=a081-a017;
a081=a081/a056;
a017=a057/a056;
a017=a017*a117;
a081=a081-a017;
a081=a058*a081;
a017=arg[60]? arg[60][0] : 0;
a057=a057*a017;
a081=a081+a057;
a002=a002*a081;
a068=a068+a002;
a002=a000*a068;
a065=a065+a002;
a053=a053*a065;
a063=a063+a053;
a058=a058/a056;
a053=a042*a058;
a104=a053*a104;
a107=a058*a107;
a017=a017/a056;
a056=a058/a056;
a056=a056*a117;
a017=a017-a056;
a042=a042*a017;
a107=a107+a042;
a040=a040*a107;
a104=a104+a040;
a063=a063-a104;
a104=a036*a058;
a040=a034*a104;
a042=a040*a069;
a099=a104*a099;
a101=a058*a101;
a036=a036*a017;
a101=a101+a036;
a034=a034*a101;
a099=a099+a034;
a034=a004*a099;
a042=a042+a034;
a063=a063+a042;
a042=a016*a058;
a077=a042*a077;
a082=a058*a082;
a016=a016*a017;
a082=a082+a016;
a013=a013*a082;
a077=a077+a013;
a063=a063-a077;
if (res[0]!=0) res[0][0]=a063;
a061=a061*a080;
a065=a014*a065;
a061=a061+a065;
if (res[1]!=0) res[1][0]=a061;
a061=a051*a058;
a065=2.*a076;
a061=a061*a065;
a065=2.*a010;
a063=a058*a115;
a077=a051*a017;
a063=a063+a077;
a065=a065*a063;
a061=a061+a065;
a065=a048*a058;
a063=a030*a065;
a106=a063*a106;
a077=a065*a095;
a013=a058*a112;
a016=a048*a017;
a013=a013+a016;
a016=a030*a013;
a077=a077+a016;
a044=a044*a077;
a106=a106+a044;
a061=a061+a106;
a106=a014*a053;
a044=a012*a106;
a102=a044*a102;
a016=a106*a078;
a053=a053*a080;
a107=a014*a107;
a053=a053+a107;
a107=a012*a053;
a016=a016+a107;
a038=a038*a016;
a102=a102+a038;
a061=a061-a102;
a102=a028*a058;
a083=a102*a083;
a093=a058*a093;
a028=a028*a017;
a093=a093+a028;
a026=a026*a093;
a083=a083+a026;
a061=a061-a083;
a083=a014*a042;
a026=a012*a083;
a071=a026*a071;
a028=a083*a078;
a042=a042*a080;
a082=a014*a082;
a042=a042+a082;
a082=a012*a042;
a028=a028+a082;
a009=a009*a028;
a071=a071+a009;
a061=a061-a071;
a071=2.*a004;
a071=a071+a018;
a009=arg[20]? arg[20][0] : 0;
a082=arg[21]? arg[21][0] : 0;
a009=a009-a082;
a038=a009/a000;
a107=a071*a038;
a034=a012*a107;
a036=2.*a072;
a056=a034*a036;
a117=2.*a006;
a002=a107*a078;
a057=2.*a069;
a057=a057+a084;
a066=a038*a057;
a118=arg[58]? arg[58][0] : 0;
a119=arg[59]? arg[59][0] : 0;
a118=a118-a119;
a120=a118/a000;
a121=a038/a000;
a121=a121*a064;
a120=a120-a121;
a121=a071*a120;
a066=a066+a121;
a121=a012*a066;
a002=a002+a121;
a121=a117*a002;
a056=a056+a121;
a061=a061+a056;
if (res[2]!=0) res[2][0]=a061;
a061=a051*a058;
a056=2.*a095;
a061=a061*a056;
a056=2.*a030;
a115=a058*a115;
a051=a051*a017;
a115=a115+a051;
a056=a056*a115;
a061=a061+a056;
a065=a065*a108;
a045=a045*a013;
a065=a065+a045;
a061=a061+a065;
a065=a032*a058;
a092=a065*a092;
a097=a058*a097;
a032=a032*a017;
a097=a097+a032;
a029=a029*a097;
a092=a092+a029;
a061=a061-a092;
if (res[3]!=0) res[3][0]=a061;
a061=a055*a059;
a092=2.*a067;
a061=a061*a092;
a092=2.*a001;
a059=a059*a116;
a055=a055*a081;
a059=a059+a055;
a092=a092*a059;
a061=a061+a092;
a092=a041*a058;
a059=2.*a067;
a092=a092*a059;
a059=2.*a001;
a105=a058*a105;
a041=a041*a017;
a105=a105+a041;
a059=a059*a105;
a092=a092+a059;
a061=a061-a092;
a092=a035*a058;
a059=2.*a067;
a092=a092*a059;
a059=2.*a001;
a098=a058*a098;
a035=a035*a017;
a098=a098+a035;
a059=a059*a098;
a092=a092+a059;
a061=a061+a092;
a092=a015*a058;
a059=2.*a067;
a092=a092*a059;
a059=2.*a001;
a079=a058*a079;
a015=a015*a017;
a079=a079+a015;
a059=a059*a079;
a092=a092+a059;
a061=a061-a092;
a092=a052*a058;
a059=a049*a058;
a092=a092+a059;
a059=a048*a092;
a059=a003*a059;
a079=a010*a063;
a079=a043*a079;
a059=a059+a079;
a079=a010*a044;
a015=a037*a079;
a059=a059-a015;
a015=a030*a065;
a098=a004*a015;
a059=a059-a098;
a098=a010*a102;
a035=a004*a098;
a059=a059-a035;
a035=a117*a010;
a105=a035*a012;
a041=a105*a038;
a059=a059+a041;
a041=a024*a059;
a067=2.*a067;
a041=a041*a067;
a001=2.*a001;
a088=a059*a088;
a112=a092*a112;
a113=a058*a113;
a052=a052*a017;
a113=a113+a052;
a110=a058*a110;
a049=a049*a017;
a110=a110+a049;
a113=a113+a110;
a048=a048*a113;
a112=a112+a048;
a112=a003*a112;
a063=a063*a076;
a077=a010*a077;
a063=a063+a077;
a043=a043*a063;
a112=a112+a043;
a100=a079*a100;
a044=a044*a076;
a016=a010*a016;
a044=a044+a016;
a037=a037*a044;
a100=a100+a037;
a112=a112-a100;
a100=a015*a069;
a065=a065*a095;
a030=a030*a097;
a065=a065+a030;
a030=a004*a065;
a100=a100+a030;
a112=a112-a100;
a100=a098*a069;
a102=a102*a076;
a093=a010*a093;
a102=a102+a093;
a093=a004*a102;
a100=a100+a093;
a112=a112-a100;
a036=a010*a036;
a117=a117*a076;
a036=a036+a117;
a117=a012*a036;
a100=a035*a078;
a117=a117+a100;
a038=a038*a117;
a120=a105*a120;
a038=a038+a120;
a112=a112+a038;
a024=a024*a112;
a088=a088+a024;
a001=a001*a088;
a041=a041+a001;
a061=a061+a041;
if (res[4]!=0) res[4][0]=a061;
a061=a025*a059;
a086=a061*a086;
a059=a059*a091;
a025=a025*a112;
a059=a059+a025;
a022=a022*a059;
a086=a086+a022;
if (res[5]!=0) res[5][0]=a086;
a086=a023*a061;
a087=a086*a087;
a061=a061*a089;
a023=a023*a059;
a061=a061+a023;
a021=a021*a061;
a087=a087+a021;
a019=a019*a087;
if (res[6]!=0) res[6][0]=a019;
a086=a086*a085;
a020=a020*a061;
a086=a086+a020;
if (res[7]!=0) res[7][0]=a086;
a086=a050*a092;
a020=a046*a058;
a086=a086+a020;
a020=a012*a086;
a061=a020*a072;
a078=a086*a078;
a092=a092*a114;
a050=a050*a113;
a092=a092+a050;
a109=a058*a109;
a046=a046*a017;
a109=a109+a046;
a092=a092+a109;
a012=a012*a092;
a078=a078+a012;
a012=a006*a078;
a061=a061+a012;
a040=a040*a080;
a014=a014*a099;
a040=a040+a014;
a061=a061+a040;
a015=a015*a084;
a065=a018*a065;
a015=a015+a065;
a061=a061-a015;
a098=a098*a084;
a102=a018*a102;
a098=a098+a102;
a061=a061-a098;
a098=a010*a026;
a072=a098*a072;
a026=a026*a076;
a028=a010*a028;
a026=a026+a028;
a006=a006*a026;
a072=a072+a006;
a003=a003*a072;
a061=a061-a003;
a038=2.*a038;
a061=a061+a038;
a038=arg[19]? arg[19][0] : 0;
a082=a082+a038;
a038=a082*a064;
a003=arg[57]? arg[57][0] : 0;
a119=a119+a003;
a003=a000*a119;
a038=a038+a003;
a061=a061+a038;
if (res[8]!=0) res[8][0]=a061;
if (res[9]!=0) res[9][0]=a112;
a112=a004*a020;
a061=a018*a079;
a061=-a061;
a061=2.*a061;
a112=a112+a061;
a061=a005*a098;
a112=a112-a061;
a061=a010*a034;
a061=2.*a061;
a112=a112+a061;
a073=a112*a073;
a020=a020*a069;
a078=a004*a078;
a020=a020+a078;
a079=a079*a084;
a018=a018*a044;
a079=a079+a018;
a079=-a079;
a079=2.*a079;
a020=a020+a079;
a098=a098*a070;
a005=a005*a026;
a098=a098+a005;
a020=a020-a098;
a034=a034*a076;
a010=a010*a002;
a034=a034+a010;
a034=2.*a034;
a020=a020+a034;
a007=a007*a020;
a073=a073+a007;
if (res[10]!=0) res[10][0]=a073;
if (res[11]!=0) res[11][0]=a020;
a112=a112*a075;
a008=a008*a020;
a112=a112+a008;
a112=2.*a112;
if (res[12]!=0) res[12][0]=a112;
a086=a086*a111;
a047=a047*a092;
a086=a086+a047;
a106=a106*a103;
a039=a039*a053;
a106=a106+a039;
a086=a086-a106;
a083=a083*a074;
a011=a011*a042;
a083=a083+a011;
a086=a086-a083;
a107=a107*a036;
a035=a035*a066;
a107=a107+a035;
a086=a086+a107;
if (res[13]!=0) res[13][0]=a086;
a060=a060*a062;
a054=a054*a068;
a060=a060+a054;
a054=a033*a104;
a068=2.*a064;
a054=a054*a068;
a068=2.*a000;
a104=a104*a096;
a033=a033*a101;
a104=a104+a033;
a068=a068*a104;
a054=a054+a068;
a060=a060+a054;
a054=a031*a058;
a068=2.*a064;
a054=a054*a068;
a068=2.*a000;
a094=a058*a094;
a031=a031*a017;
a094=a094+a031;
a068=a068*a094;
a054=a054+a068;
a060=a060-a054;
a054=a027*a058;
a068=2.*a064;
a054=a054*a068;
a068=2.*a000;
a058=a058*a090;
a027=a027*a017;
a058=a058+a027;
a068=a068*a058;
a054=a054+a068;
a060=a060-a054;
a117=a071*a117;
a057=a105*a057;
a117=a117+a057;
a117=a117/a000;
a105=a105*a071;
a105=a105/a000;
a071=a105/a000;
a071=a071*a064;
a117=a117-a071;
a117=a117/a000;
a105=a105/a000;
a000=a105/a000;
a000=a000*a064;
a117=a117-a000;
a009=a009*a117;
a105=a105*a118;
a009=a009+a105;
a060=a060-a009;
a082=a082*a069;
a004=a004*a119;
a082=a082+a004;
a060=a060+a082;
if (res[14]!=0) res[14][0]=a060;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_toe_effects(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f67(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_toe_effects_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_toe_effects_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_toe_effects_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_toe_effects_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_toe_effects_n_in(void) { return 61;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_toe_effects_n_out(void) { return 15;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_toe_effects_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_toe_effects_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "Izz";
case 2: return "a";
case 3: return "b";
case 4: return "u";
case 5: return "rho";
case 6: return "Ap";
case 7: return "CL_gamma";
case 8: return "C_alpha";
case 9: return "Ct";
case 10: return "Fz";
case 11: return "B3";
case 12: return "C3";
case 13: return "h_cg";
case 14: return "track";
case 15: return "out_toe_pull";
case 16: return "out_toe_load";
case 17: return "out_toe_yaw_stiffness";
case 18: return "out_toe_determinant";
case 19: return "adj_toe_pull";
case 20: return "adj_toe_load";
case 21: return "adj_toe_yaw_stiffness";
case 22: return "adj_toe_determinant";
case 23: return "out_adj_m";
case 24: return "out_adj_Izz";
case 25: return "out_adj_a";
case 26: return "out_adj_b";
case 27: return "out_adj_u";
case 28: return "out_adj_rho";
case 29: return "out_adj_Ap";
case 30: return "out_adj_CL_gamma";
case 31: return "out_adj_C_alpha";
case 32: return "out_adj_Ct";
case 33: return "out_adj_Fz";
case 34: return "out_adj_B3";
case 35: return "out_adj_C3";
case 36: return "out_adj_h_cg";
case 37: return "out_adj_track";
case 38: return "fwd_m";
case 39: return "fwd_Izz";
case 40: return "fwd_a";
case 41: return "fwd_b";
case 42: return "fwd_u";
case 43: return "fwd_rho";
case 44: return "fwd_Ap";
case 45: return "fwd_CL_gamma";
case 46: return "fwd_C_alpha";
case 47: return "fwd_Ct";
case 48: return "fwd_Fz";
case 49: return "fwd_B3";
case 50: return "fwd_C3";
case 51: return "fwd_h_cg";
case 52: return "fwd_track";
case 53: return "fwd_out_toe_pull";
case 54: return "fwd_out_toe_load";
case 55: return "fwd_out_toe_yaw_stiffness";
case 56: return "fwd_out_toe_determinant";
case 57: return "fwd_adj_toe_pull";
case 58: return "fwd_adj_toe_load";
case 59: return "fwd_adj_toe_yaw_stiffness";
case 60: return "fwd_adj_toe_determinant";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_toe_effects_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_m";
case 1: return "fwd_adj_Izz";
case 2: return "fwd_adj_a";
case 3: return "fwd_adj_b";
case 4: return "fwd_adj_u";
case 5: return "fwd_adj_rho";
case 6: return "fwd_adj_Ap";
case 7: return "fwd_adj_CL_gamma";
case 8: return "fwd_adj_C_alpha";
case 9: return "fwd_adj_Ct";
case 10: return "fwd_adj_Fz";
case 11: return "fwd_adj_B3";
case 12: return "fwd_adj_C3";
case 13: return "fwd_adj_h_cg";
case 14: return "fwd_adj_track";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_toe_effects_sparsity_in(casadi_int i) {
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
case 11: return casadi_s0;
case 12: return casadi_s0;
case 13: return casadi_s0;
case 14: return casadi_s0;
case 15: return casadi_s1;
case 16: return casadi_s1;
case 17: return casadi_s1;
case 18: return casadi_s1;
case 19: return casadi_s0;
case 20: return casadi_s0;
case 21: return casadi_s0;
case 22: return casadi_s0;
case 23: return casadi_s1;
case 24: return casadi_s1;
case 25: return casadi_s1;
case 26: return casadi_s1;
case 27: return casadi_s1;
case 28: return casadi_s1;
case 29: return casadi_s1;
case 30: return casadi_s1;
case 31: return casadi_s1;
case 32: return casadi_s1;
case 33: return casadi_s1;
case 34: return casadi_s1;
case 35: return casadi_s1;
case 36: return casadi_s1;
case 37: return casadi_s1;
case 38: return casadi_s0;
case 39: return casadi_s0;
case 40: return casadi_s0;
case 41: return casadi_s0;
case 42: return casadi_s0;
case 43: return casadi_s0;
case 44: return casadi_s0;
case 45: return casadi_s0;
case 46: return casadi_s0;
case 47: return casadi_s0;
case 48: return casadi_s0;
case 49: return casadi_s0;
case 50: return casadi_s0;
case 51: return casadi_s0;
case 52: return casadi_s0;
case 53: return casadi_s1;
case 54: return casadi_s1;
case 55: return casadi_s1;
case 56: return casadi_s1;
case 57: return casadi_s0;
case 58: return casadi_s0;
case 59: return casadi_s0;
case 60: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_toe_effects_sparsity_out(casadi_int i) {
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
case 11: return casadi_s0;
case 12: return casadi_s0;
case 13: return casadi_s0;
case 14: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_toe_effects_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 61;
if (sz_res) *sz_res = 15;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_toe_effects_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 61*sizeof(const casadi_real*);
if (sz_res) *sz_res = 15*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
