/* Generated from derive/ (digest 0a06213221c378cc) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`. */
/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
#define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
#define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
#define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
#define CASADI_PREFIX(ID) placement_ ## ID
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
#define casadi_f3 CASADI_PREFIX(f3)
#define casadi_f4 CASADI_PREFIX(f4)
#define casadi_f5 CASADI_PREFIX(f5)
#define casadi_f6 CASADI_PREFIX(f6)
#define casadi_f7 CASADI_PREFIX(f7)
#define casadi_f8 CASADI_PREFIX(f8)
#define casadi_f9 CASADI_PREFIX(f9)
#define casadi_fabs CASADI_PREFIX(fabs)
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
/* Configuration this file was compiled with */
CASADI_SYMBOL_EXPORT void placement_casadi_version(int* major, int* minor, int* patch) {
*major = 3;
*minor = 8;
*patch = 2;
}
CASADI_SYMBOL_EXPORT int placement_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int placement_casadi_real_size(void) { return (int) sizeof(casadi_real); }
static const casadi_int casadi_s0[3] = {1, 1, 1};
static const casadi_int casadi_s1[4] = {1, 1, 0, 0};
/* placement_following:(x_main,x_third,x_tail,kappa,u,x_cg,m,w,tau,eta,g,u_lift,B3,C3,K1,K2,K3,K4)->(a,b,Fz,F_tail_load,C_alpha,Ct) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5, a6;
a0=arg[5]? arg[5][0] : 0;
a1=arg[0]? arg[0][0] : 0;
a2=a0-a1;
if (res[0]!=0) res[0][0]=a2;
a2=arg[2]? arg[2][0] : 0;
a2=a2-a0;
if (res[1]!=0) res[1][0]=a2;
a2=5.0000000000000000e-01;
a3=arg[1]? arg[1][0] : 0;
a0=a3-a0;
a3=a3-a1;
a0=a0/a3;
a2=a2*a0;
a3=arg[10]? arg[10][0] : 0;
a1=arg[6]? arg[6][0] : 0;
a3=a3*a1;
a1=arg[7]? arg[7][0] : 0;
a4=1.;
a5=arg[4]? arg[4][0] : 0;
a5=casadi_sq(a5);
a6=arg[11]? arg[11][0] : 0;
a6=casadi_sq(a6);
a5=a5/a6;
a5=a4-a5;
a1=a1*a5;
a3=a3*a1;
a2=a2*a3;
if (res[2]!=0) res[2][0]=a2;
a1=arg[8]? arg[8][0] : 0;
a1=a1*a3;
a4=a4-a0;
a1=a1*a4;
if (res[3]!=0) res[3][0]=a1;
a4=arg[12]? arg[12][0] : 0;
a0=arg[9]? arg[9][0] : 0;
a4=a4*a0;
a3=arg[13]? arg[13][0] : 0;
a3=a3*a0;
a3=a3*a2;
a4=a4+a3;
a2=a2*a4;
if (res[4]!=0) res[4][0]=a2;
a2=arg[3]? arg[3][0] : 0;
a0=a0*a2;
a2=casadi_sq(a1);
a2=casadi_sq(a2);
a4=arg[17]? arg[17][0] : 0;
a2=a2*a4;
a4=casadi_sq(a1);
a4=a1*a4;
a3=arg[16]? arg[16][0] : 0;
a4=a4*a3;
a2=a2+a4;
a4=casadi_sq(a1);
a3=arg[15]? arg[15][0] : 0;
a4=a4*a3;
a2=a2+a4;
a4=arg[14]? arg[14][0] : 0;
a1=a1*a4;
a2=a2+a1;
a0=a0*a2;
if (res[5]!=0) res[5][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int placement_following(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f0(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int placement_following_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void placement_following_release(int mem) {
}
CASADI_SYMBOL_EXPORT void placement_following_incref(void) {
}
CASADI_SYMBOL_EXPORT void placement_following_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int placement_following_n_in(void) { return 18;}
CASADI_SYMBOL_EXPORT casadi_int placement_following_n_out(void) { return 6;}
CASADI_SYMBOL_EXPORT casadi_real placement_following_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* placement_following_name_in(casadi_int i) {
switch (i) {
case 0: return "x_main";
case 1: return "x_third";
case 2: return "x_tail";
case 3: return "kappa";
case 4: return "u";
case 5: return "x_cg";
case 6: return "m";
case 7: return "w";
case 8: return "tau";
case 9: return "eta";
case 10: return "g";
case 11: return "u_lift";
case 12: return "B3";
case 13: return "C3";
case 14: return "K1";
case 15: return "K2";
case 16: return "K3";
case 17: return "K4";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* placement_following_name_out(casadi_int i) {
switch (i) {
case 0: return "a";
case 1: return "b";
case 2: return "Fz";
case 3: return "F_tail_load";
case 4: return "C_alpha";
case 5: return "Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* placement_following_sparsity_in(casadi_int i) {
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
case 15: return casadi_s0;
case 16: return casadi_s0;
case 17: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* placement_following_sparsity_out(casadi_int i) {
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
CASADI_SYMBOL_EXPORT int placement_following_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 18;
if (sz_res) *sz_res = 6;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int placement_following_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 18*sizeof(const casadi_real*);
if (sz_res) *sz_res = 6*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_placement_following:(x_main,x_third,x_tail,kappa,u,x_cg,m,w,tau,eta,g,u_lift,B3,C3,K1,K2,K3,K4,out_a[1x1,0nz],out_b[1x1,0nz],out_Fz[1x1,0nz],out_F_tail_load[1x1,0nz],out_C_alpha[1x1,0nz],out_Ct[1x1,0nz],fwd_x_main,fwd_x_third,fwd_x_tail,fwd_kappa,fwd_u,fwd_x_cg,fwd_m,fwd_w,fwd_tau,fwd_eta,fwd_g,fwd_u_lift,fwd_B3,fwd_C3,fwd_K1,fwd_K2,fwd_K3,fwd_K4)->(fwd_a,fwd_b,fwd_Fz,fwd_F_tail_load,fwd_C_alpha,fwd_Ct) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18;
a00=arg[29]? arg[29][0] : 0;
a01=arg[24]? arg[24][0] : 0;
a02=a00-a01;
if (res[0]!=0) res[0][0]=a02;
a02=arg[26]? arg[26][0] : 0;
a02=a02-a00;
if (res[1]!=0) res[1][0]=a02;
a02=arg[10]? arg[10][0] : 0;
a03=arg[6]? arg[6][0] : 0;
a04=a02*a03;
a05=arg[7]? arg[7][0] : 0;
a06=1.;
a07=arg[4]? arg[4][0] : 0;
a08=casadi_sq(a07);
a09=arg[11]? arg[11][0] : 0;
a10=casadi_sq(a09);
a08=a08/a10;
a11=a06-a08;
a12=a05*a11;
a13=a04*a12;
a14=5.0000000000000000e-01;
a15=arg[25]? arg[25][0] : 0;
a00=a15-a00;
a16=arg[1]? arg[1][0] : 0;
a17=arg[0]? arg[0][0] : 0;
a17=a16-a17;
a00=a00/a17;
a18=arg[5]? arg[5][0] : 0;
a16=a16-a18;
a16=a16/a17;
a17=a16/a17;
a15=a15-a01;
a17=a17*a15;
a00=a00-a17;
a17=a14*a00;
a17=a13*a17;
a14=a14*a16;
a15=arg[34]? arg[34][0] : 0;
a03=a03*a15;
a15=arg[30]? arg[30][0] : 0;
a02=a02*a15;
a03=a03+a02;
a12=a12*a03;
a03=arg[31]? arg[31][0] : 0;
a11=a11*a03;
a07=2.*a07;
a03=arg[28]? arg[28][0] : 0;
a07=a07*a03;
a07=a07/a10;
a08=a08/a10;
a09=2.*a09;
a10=arg[35]? arg[35][0] : 0;
a09=a09*a10;
a08=a08*a09;
a07=a07-a08;
a05=a05*a07;
a11=a11-a05;
a04=a04*a11;
a12=a12+a04;
a04=a14*a12;
a17=a17+a04;
if (res[2]!=0) res[2][0]=a17;
a06=a06-a16;
a16=arg[32]? arg[32][0] : 0;
a16=a13*a16;
a04=arg[8]? arg[8][0] : 0;
a12=a04*a12;
a16=a16+a12;
a16=a06*a16;
a04=a04*a13;
a00=a04*a00;
a16=a16-a00;
if (res[3]!=0) res[3][0]=a16;
a00=arg[12]? arg[12][0] : 0;
a12=arg[9]? arg[9][0] : 0;
a11=a00*a12;
a05=arg[13]? arg[13][0] : 0;
a07=a05*a12;
a14=a14*a13;
a13=a07*a14;
a11=a11+a13;
a11=a11*a17;
a13=arg[36]? arg[36][0] : 0;
a13=a12*a13;
a08=arg[33]? arg[33][0] : 0;
a00=a00*a08;
a13=a13+a00;
a00=arg[37]? arg[37][0] : 0;
a00=a12*a00;
a05=a05*a08;
a00=a00+a05;
a00=a14*a00;
a07=a07*a17;
a00=a00+a07;
a13=a13+a00;
a14=a14*a13;
a11=a11+a14;
if (res[4]!=0) res[4][0]=a11;
a04=a04*a06;
a06=casadi_sq(a04);
a11=casadi_sq(a06);
a14=arg[17]? arg[17][0] : 0;
a13=a11*a14;
a00=casadi_sq(a04);
a07=a04*a00;
a17=arg[16]? arg[16][0] : 0;
a05=a07*a17;
a13=a13+a05;
a05=casadi_sq(a04);
a09=arg[15]? arg[15][0] : 0;
a10=a05*a09;
a13=a13+a10;
a10=arg[14]? arg[14][0] : 0;
a03=a04*a10;
a13=a13+a03;
a03=arg[3]? arg[3][0] : 0;
a08=a03*a08;
a02=arg[27]? arg[27][0] : 0;
a02=a12*a02;
a08=a08+a02;
a13=a13*a08;
a12=a12*a03;
a06=2.*a06;
a03=2.*a04;
a03=a03*a16;
a06=a06*a03;
a14=a14*a06;
a06=arg[41]? arg[41][0] : 0;
a11=a11*a06;
a14=a14+a11;
a00=a00*a16;
a11=2.*a04;
a11=a11*a16;
a11=a04*a11;
a00=a00+a11;
a17=a17*a00;
a00=arg[40]? arg[40][0] : 0;
a07=a07*a00;
a17=a17+a07;
a14=a14+a17;
a17=2.*a04;
a17=a17*a16;
a09=a09*a17;
a17=arg[39]? arg[39][0] : 0;
a05=a05*a17;
a09=a09+a05;
a14=a14+a09;
a10=a10*a16;
a16=arg[38]? arg[38][0] : 0;
a04=a04*a16;
a10=a10+a04;
a14=a14+a10;
a12=a12*a14;
a13=a13+a12;
if (res[5]!=0) res[5][0]=a13;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_placement_following(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f1(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_placement_following_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_placement_following_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_placement_following_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_placement_following_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_placement_following_n_in(void) { return 42;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_placement_following_n_out(void) { return 6;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_placement_following_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_placement_following_name_in(casadi_int i) {
switch (i) {
case 0: return "x_main";
case 1: return "x_third";
case 2: return "x_tail";
case 3: return "kappa";
case 4: return "u";
case 5: return "x_cg";
case 6: return "m";
case 7: return "w";
case 8: return "tau";
case 9: return "eta";
case 10: return "g";
case 11: return "u_lift";
case 12: return "B3";
case 13: return "C3";
case 14: return "K1";
case 15: return "K2";
case 16: return "K3";
case 17: return "K4";
case 18: return "out_a";
case 19: return "out_b";
case 20: return "out_Fz";
case 21: return "out_F_tail_load";
case 22: return "out_C_alpha";
case 23: return "out_Ct";
case 24: return "fwd_x_main";
case 25: return "fwd_x_third";
case 26: return "fwd_x_tail";
case 27: return "fwd_kappa";
case 28: return "fwd_u";
case 29: return "fwd_x_cg";
case 30: return "fwd_m";
case 31: return "fwd_w";
case 32: return "fwd_tau";
case 33: return "fwd_eta";
case 34: return "fwd_g";
case 35: return "fwd_u_lift";
case 36: return "fwd_B3";
case 37: return "fwd_C3";
case 38: return "fwd_K1";
case 39: return "fwd_K2";
case 40: return "fwd_K3";
case 41: return "fwd_K4";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_placement_following_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_a";
case 1: return "fwd_b";
case 2: return "fwd_Fz";
case 3: return "fwd_F_tail_load";
case 4: return "fwd_C_alpha";
case 5: return "fwd_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_placement_following_sparsity_in(casadi_int i) {
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
case 15: return casadi_s0;
case 16: return casadi_s0;
case 17: return casadi_s0;
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
case 33: return casadi_s0;
case 34: return casadi_s0;
case 35: return casadi_s0;
case 36: return casadi_s0;
case 37: return casadi_s0;
case 38: return casadi_s0;
case 39: return casadi_s0;
case 40: return casadi_s0;
case 41: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_placement_following_sparsity_out(casadi_int i) {
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
CASADI_SYMBOL_EXPORT int fwd1_placement_following_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 42;
if (sz_res) *sz_res = 6;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_placement_following_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 42*sizeof(const casadi_real*);
if (sz_res) *sz_res = 6*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_placement_following:(x_main,x_third,x_tail,kappa,u,x_cg,m,w,tau,eta,g,u_lift,B3,C3,K1,K2,K3,K4,out_a[1x1,0nz],out_b[1x1,0nz],out_Fz[1x1,0nz],out_F_tail_load[1x1,0nz],out_C_alpha[1x1,0nz],out_Ct[1x1,0nz],adj_a,adj_b,adj_Fz,adj_F_tail_load,adj_C_alpha,adj_Ct)->(adj_x_main,adj_x_third,adj_x_tail,adj_kappa,adj_u,adj_x_cg,adj_m,adj_w,adj_tau,adj_eta,adj_g,adj_u_lift,adj_B3,adj_C3,adj_K1,adj_K2,adj_K3,adj_K4) */
static int casadi_f2(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37;
a00=arg[1]? arg[1][0] : 0;
a01=arg[5]? arg[5][0] : 0;
a01=a00-a01;
a02=arg[0]? arg[0][0] : 0;
a00=a00-a02;
a01=a01/a00;
a02=a01/a00;
a03=5.0000000000000000e-01;
a04=arg[10]? arg[10][0] : 0;
a05=arg[6]? arg[6][0] : 0;
a06=a04*a05;
a07=arg[7]? arg[7][0] : 0;
a08=1.;
a09=arg[4]? arg[4][0] : 0;
a10=casadi_sq(a09);
a11=arg[11]? arg[11][0] : 0;
a12=casadi_sq(a11);
a10=a10/a12;
a13=a08-a10;
a14=a07*a13;
a15=a06*a14;
a16=arg[12]? arg[12][0] : 0;
a17=arg[9]? arg[9][0] : 0;
a18=a16*a17;
a19=arg[13]? arg[13][0] : 0;
a20=a19*a17;
a21=a03*a01;
a22=a21*a15;
a23=a20*a22;
a18=a18+a23;
a23=arg[28]? arg[28][0] : 0;
a18=a18*a23;
a23=a22*a23;
a20=a20*a23;
a18=a18+a20;
a20=arg[26]? arg[26][0] : 0;
a18=a18+a20;
a20=a15*a18;
a03=a03*a20;
a20=arg[8]? arg[8][0] : 0;
a24=a20*a15;
a25=arg[14]? arg[14][0] : 0;
a26=arg[3]? arg[3][0] : 0;
a27=a17*a26;
a28=arg[29]? arg[29][0] : 0;
a27=a27*a28;
a29=a25*a27;
a08=a08-a01;
a01=a24*a08;
a30=2.*a01;
a31=arg[15]? arg[15][0] : 0;
a32=a31*a27;
a30=a30*a32;
a29=a29+a30;
a30=casadi_sq(a01);
a32=arg[16]? arg[16][0] : 0;
a33=a32*a27;
a34=a30*a33;
a29=a29+a34;
a34=2.*a01;
a33=a01*a33;
a34=a34*a33;
a29=a29+a34;
a34=2.*a01;
a33=casadi_sq(a01);
a35=2.*a33;
a36=arg[17]? arg[17][0] : 0;
a37=a36*a27;
a35=a35*a37;
a34=a34*a35;
a29=a29+a34;
a34=arg[27]? arg[27][0] : 0;
a29=a29+a34;
a24=a24*a29;
a03=a03-a24;
a02=a02*a03;
a24=arg[24]? arg[24][0] : 0;
a34=a02-a24;
if (res[0]!=0) res[0][0]=a34;
a03=a03/a00;
a02=a03-a02;
if (res[1]!=0) res[1][0]=a02;
a02=arg[25]? arg[25][0] : 0;
if (res[2]!=0) res[2][0]=a02;
a33=casadi_sq(a33);
a36=a33*a36;
a30=a01*a30;
a32=a30*a32;
a36=a36+a32;
a32=casadi_sq(a01);
a31=a32*a31;
a36=a36+a31;
a25=a01*a25;
a36=a36+a25;
a36=a36*a28;
a28=a17*a36;
if (res[3]!=0) res[3][0]=a28;
a09=2.*a09;
a08=a08*a29;
a20=a20*a08;
a21=a21*a18;
a20=a20+a21;
a06=a06*a20;
a07=a07*a06;
a21=a07/a12;
a09=a09*a21;
a09=-a09;
if (res[4]!=0) res[4][0]=a09;
a03=a03+a02;
a24=a24-a03;
if (res[5]!=0) res[5][0]=a24;
a14=a14*a20;
a04=a04*a14;
if (res[6]!=0) res[6][0]=a04;
a13=a13*a06;
if (res[7]!=0) res[7][0]=a13;
a15=a15*a08;
if (res[8]!=0) res[8][0]=a15;
a26=a26*a36;
a22=a22*a23;
a19=a19*a22;
a26=a26+a19;
a16=a16*a23;
a26=a26+a16;
if (res[9]!=0) res[9][0]=a26;
a05=a05*a14;
if (res[10]!=0) res[10][0]=a05;
a11=2.*a11;
a10=a10/a12;
a10=a10*a07;
a11=a11*a10;
if (res[11]!=0) res[11][0]=a11;
a23=a17*a23;
if (res[12]!=0) res[12][0]=a23;
a17=a17*a22;
if (res[13]!=0) res[13][0]=a17;
a01=a01*a27;
if (res[14]!=0) res[14][0]=a01;
a32=a32*a27;
if (res[15]!=0) res[15][0]=a32;
a30=a30*a27;
if (res[16]!=0) res[16][0]=a30;
a33=a33*a27;
if (res[17]!=0) res[17][0]=a33;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_placement_following(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f2(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_placement_following_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_placement_following_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_placement_following_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_placement_following_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_placement_following_n_in(void) { return 30;}
CASADI_SYMBOL_EXPORT casadi_int adj1_placement_following_n_out(void) { return 18;}
CASADI_SYMBOL_EXPORT casadi_real adj1_placement_following_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_placement_following_name_in(casadi_int i) {
switch (i) {
case 0: return "x_main";
case 1: return "x_third";
case 2: return "x_tail";
case 3: return "kappa";
case 4: return "u";
case 5: return "x_cg";
case 6: return "m";
case 7: return "w";
case 8: return "tau";
case 9: return "eta";
case 10: return "g";
case 11: return "u_lift";
case 12: return "B3";
case 13: return "C3";
case 14: return "K1";
case 15: return "K2";
case 16: return "K3";
case 17: return "K4";
case 18: return "out_a";
case 19: return "out_b";
case 20: return "out_Fz";
case 21: return "out_F_tail_load";
case 22: return "out_C_alpha";
case 23: return "out_Ct";
case 24: return "adj_a";
case 25: return "adj_b";
case 26: return "adj_Fz";
case 27: return "adj_F_tail_load";
case 28: return "adj_C_alpha";
case 29: return "adj_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_placement_following_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_x_main";
case 1: return "adj_x_third";
case 2: return "adj_x_tail";
case 3: return "adj_kappa";
case 4: return "adj_u";
case 5: return "adj_x_cg";
case 6: return "adj_m";
case 7: return "adj_w";
case 8: return "adj_tau";
case 9: return "adj_eta";
case 10: return "adj_g";
case 11: return "adj_u_lift";
case 12: return "adj_B3";
case 13: return "adj_C3";
case 14: return "adj_K1";
case 15: return "adj_K2";
case 16: return "adj_K3";
case 17: return "adj_K4";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_placement_following_sparsity_in(casadi_int i) {
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
case 15: return casadi_s0;
case 16: return casadi_s0;
case 17: return casadi_s0;
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
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_placement_following_sparsity_out(casadi_int i) {
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
case 15: return casadi_s0;
case 16: return casadi_s0;
case 17: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_placement_following_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 30;
if (sz_res) *sz_res = 18;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_placement_following_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 30*sizeof(const casadi_real*);
if (sz_res) *sz_res = 18*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_placement_following:(x_main,x_third,x_tail,kappa,u,x_cg,m,w,tau,eta,g,u_lift,B3,C3,K1,K2,K3,K4,out_a[1x1,0nz],out_b[1x1,0nz],out_Fz[1x1,0nz],out_F_tail_load[1x1,0nz],out_C_alpha[1x1,0nz],out_Ct[1x1,0nz],adj_a,adj_b,adj_Fz,adj_F_tail_load,adj_C_alpha,adj_Ct,out_adj_x_main[1x1,0nz],out_adj_x_third[1x1,0nz],out_adj_x_tail[1x1,0nz],out_adj_kappa[1x1,0nz],out_adj_u[1x1,0nz],out_adj_x_cg[1x1,0nz],out_adj_m[1x1,0nz],out_adj_w[1x1,0nz],out_adj_tau[1x1,0nz],out_adj_eta[1x1,0nz],out_adj_g[1x1,0nz],out_adj_u_lift[1x1,0nz],out_adj_B3[1x1,0nz],out_adj_C3[1x1,0nz],out_adj_K1[1x1,0nz],out_adj_K2[1x1,0nz],out_adj_K3[1x1,0nz],out_adj_K4[1x1,0nz],fwd_x_main,fwd_x_third,fwd_x_tail,fwd_kappa,fwd_u,fwd_x_cg,fwd_m,fwd_w,fwd_tau,fwd_eta,fwd_g,fwd_u_lift,fwd_B3,fwd_C3,fwd_K1,fwd_K2,fwd_K3,fwd_K4,fwd_out_a[1x1,0nz],fwd_out_b[1x1,0nz],fwd_out_Fz[1x1,0nz],fwd_out_F_tail_load[1x1,0nz],fwd_out_C_alpha[1x1,0nz],fwd_out_Ct[1x1,0nz],fwd_adj_a,fwd_adj_b,fwd_adj_Fz,fwd_adj_F_tail_load,fwd_adj_C_alpha,fwd_adj_Ct)->(fwd_adj_x_main,fwd_adj_x_third,fwd_adj_x_tail,fwd_adj_kappa,fwd_adj_u,fwd_adj_x_cg,fwd_adj_m,fwd_adj_w,fwd_adj_tau,fwd_adj_eta,fwd_adj_g,fwd_adj_u_lift,fwd_adj_B3,fwd_adj_C3,fwd_adj_K1,fwd_adj_K2,fwd_adj_K3,fwd_adj_K4) */
static int casadi_f3(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
casadi_real a72, a73, a74, a75, a76;
a00=5.0000000000000000e-01;
a01=arg[10]? arg[10][0] : 0;
a02=arg[6]? arg[6][0] : 0;
a03=a01*a02;
a04=arg[7]? arg[7][0] : 0;
a05=1.;
a06=arg[4]? arg[4][0] : 0;
a07=casadi_sq(a06);
a08=arg[11]? arg[11][0] : 0;
a09=casadi_sq(a08);
a07=a07/a09;
a10=a05-a07;
a11=a04*a10;
a12=a03*a11;
a13=arg[12]? arg[12][0] : 0;
a14=arg[9]? arg[9][0] : 0;
a15=a13*a14;
a16=arg[13]? arg[13][0] : 0;
a17=a16*a14;
a18=arg[1]? arg[1][0] : 0;
a19=arg[5]? arg[5][0] : 0;
a19=a18-a19;
a20=arg[0]? arg[0][0] : 0;
a18=a18-a20;
a19=a19/a18;
a20=a00*a19;
a21=a20*a12;
a22=a17*a21;
a15=a15+a22;
a22=arg[28]? arg[28][0] : 0;
a23=a15*a22;
a24=a21*a22;
a25=a17*a24;
a23=a23+a25;
a25=arg[26]? arg[26][0] : 0;
a23=a23+a25;
a25=a12*a23;
a25=a00*a25;
a26=arg[8]? arg[8][0] : 0;
a27=a26*a12;
a28=arg[14]? arg[14][0] : 0;
a29=arg[3]? arg[3][0] : 0;
a30=a14*a29;
a31=arg[29]? arg[29][0] : 0;
a32=a30*a31;
a33=a28*a32;
a05=a05-a19;
a34=a27*a05;
a35=2.*a34;
a36=arg[15]? arg[15][0] : 0;
a37=a36*a32;
a38=a35*a37;
a33=a33+a38;
a38=casadi_sq(a34);
a39=arg[16]? arg[16][0] : 0;
a40=a39*a32;
a41=a38*a40;
a33=a33+a41;
a41=2.*a34;
a42=a34*a40;
a43=a41*a42;
a33=a33+a43;
a43=2.*a34;
a44=casadi_sq(a34);
a45=2.*a44;
a46=arg[17]? arg[17][0] : 0;
a47=a46*a32;
a48=a45*a47;
a49=a43*a48;
a33=a33+a49;
a49=arg[27]? arg[27][0] : 0;
a33=a33+a49;
a49=a27*a33;
a25=a25-a49;
a49=arg[49]? arg[49][0] : 0;
a50=arg[53]? arg[53][0] : 0;
a50=a49-a50;
a50=a50/a18;
a51=a19/a18;
a52=arg[48]? arg[48][0] : 0;
a49=a49-a52;
a51=a51*a49;
a50=a50-a51;
a51=a50/a18;
a19=a19/a18;
a52=a19/a18;
a52=a52*a49;
a51=a51-a52;
a51=a25*a51;
a52=arg[58]? arg[58][0] : 0;
a53=a02*a52;
a54=arg[54]? arg[54][0] : 0;
a55=a01*a54;
a53=a53+a55;
a55=a11*a53;
a56=arg[55]? arg[55][0] : 0;
a57=a10*a56;
a58=2.*a06;
a59=arg[52]? arg[52][0] : 0;
a58=a58*a59;
a58=a58/a09;
a60=a07/a09;
a61=2.*a08;
a62=arg[59]? arg[59][0] : 0;
a61=a61*a62;
a60=a60*a61;
a58=a58-a60;
a60=a04*a58;
a57=a57-a60;
a60=a03*a57;
a55=a55+a60;
a60=a23*a55;
a63=arg[60]? arg[60][0] : 0;
a64=a14*a63;
a65=arg[57]? arg[57][0] : 0;
a66=a13*a65;
a64=a64+a66;
a66=arg[61]? arg[61][0] : 0;
a67=a14*a66;
a68=a16*a65;
a67=a67+a68;
a68=a21*a67;
a69=a00*a50;
a70=a12*a69;
a71=a20*a55;
a70=a70+a71;
a71=a17*a70;
a68=a68+a71;
a64=a64+a68;
a64=a22*a64;
a68=arg[76]? arg[76][0] : 0;
a15=a15*a68;
a64=a64+a15;
a67=a24*a67;
a22=a22*a70;
a68=a21*a68;
a22=a22+a68;
a17=a17*a22;
a67=a67+a17;
a64=a64+a67;
a67=arg[74]? arg[74][0] : 0;
a64=a64+a67;
a67=a12*a64;
a60=a60+a67;
a00=a00*a60;
a60=arg[56]? arg[56][0] : 0;
a67=a12*a60;
a17=a26*a55;
a67=a67+a17;
a17=a33*a67;
a68=arg[62]? arg[62][0] : 0;
a15=a32*a68;
a71=a29*a65;
a72=arg[51]? arg[51][0] : 0;
a73=a14*a72;
a71=a71+a73;
a71=a31*a71;
a73=arg[77]? arg[77][0] : 0;
a30=a30*a73;
a71=a71+a30;
a30=a28*a71;
a15=a15+a30;
a67=a05*a67;
a30=a27*a50;
a67=a67-a30;
a30=2.*a67;
a37=a37*a30;
a30=arg[63]? arg[63][0] : 0;
a74=a32*a30;
a75=a36*a71;
a74=a74+a75;
a35=a35*a74;
a37=a37+a35;
a15=a15+a37;
a37=2.*a34;
a37=a37*a67;
a35=a40*a37;
a74=arg[64]? arg[64][0] : 0;
a75=a32*a74;
a76=a39*a71;
a75=a75+a76;
a76=a38*a75;
a35=a35+a76;
a15=a15+a35;
a35=2.*a67;
a42=a42*a35;
a40=a40*a67;
a75=a34*a75;
a40=a40+a75;
a41=a41*a40;
a42=a42+a41;
a15=a15+a42;
a42=2.*a67;
a48=a48*a42;
a42=2.*a34;
a42=a42*a67;
a41=2.*a42;
a47=a47*a41;
a41=arg[65]? arg[65][0] : 0;
a40=a32*a41;
a75=a46*a71;
a40=a40+a75;
a45=a45*a40;
a47=a47+a45;
a43=a43*a47;
a48=a48+a43;
a15=a15+a48;
a48=arg[75]? arg[75][0] : 0;
a15=a15+a48;
a27=a27*a15;
a17=a17+a27;
a00=a00-a17;
a19=a19*a00;
a51=a51+a19;
a19=arg[72]? arg[72][0] : 0;
a17=a51-a19;
if (res[0]!=0) res[0][0]=a17;
a00=a00/a18;
a25=a25/a18;
a25=a25/a18;
a25=a25*a49;
a00=a00-a25;
a51=a00-a51;
if (res[1]!=0) res[1][0]=a51;
a51=arg[73]? arg[73][0] : 0;
if (res[2]!=0) res[2][0]=a51;
a25=casadi_sq(a44);
a49=a25*a46;
a18=a34*a38;
a17=a18*a39;
a49=a49+a17;
a17=casadi_sq(a34);
a27=a17*a36;
a49=a49+a27;
a27=a34*a28;
a49=a49+a27;
a27=a49*a31;
a48=a27*a65;
a44=2.*a44;
a44=a44*a42;
a46=a46*a44;
a41=a25*a41;
a46=a46+a41;
a38=a38*a67;
a37=a34*a37;
a38=a38+a37;
a39=a39*a38;
a74=a18*a74;
a39=a39+a74;
a46=a46+a39;
a39=2.*a34;
a39=a39*a67;
a36=a36*a39;
a30=a17*a30;
a36=a36+a30;
a46=a46+a36;
a28=a28*a67;
a68=a34*a68;
a28=a28+a68;
a46=a46+a28;
a31=a31*a46;
a49=a49*a73;
a31=a31+a49;
a49=a14*a31;
a48=a48+a49;
if (res[3]!=0) res[3][0]=a48;
a48=a05*a33;
a49=a26*a48;
a73=a20*a23;
a49=a49+a73;
a73=a03*a49;
a46=a04*a73;
a28=a46/a09;
a59=2.*a59;
a59=a28*a59;
a06=2.*a06;
a56=a73*a56;
a53=a49*a53;
a60=a48*a60;
a05=a05*a15;
a33=a33*a50;
a05=a05-a33;
a26=a26*a05;
a60=a60+a26;
a23=a23*a69;
a20=a20*a64;
a23=a23+a20;
a60=a60+a23;
a03=a03*a60;
a53=a53+a03;
a04=a04*a53;
a56=a56+a04;
a04=a56/a09;
a28=a28/a09;
a28=a28*a61;
a04=a04-a28;
a06=a06*a04;
a59=a59+a06;
a59=-a59;
if (res[4]!=0) res[4][0]=a59;
a00=a00+a51;
a19=a19-a00;
if (res[5]!=0) res[5][0]=a19;
a19=a11*a49;
a52=a19*a52;
a49=a49*a57;
a11=a11*a60;
a49=a49+a11;
a01=a01*a49;
a52=a52+a01;
if (res[6]!=0) res[6][0]=a52;
a10=a10*a53;
a73=a73*a58;
a10=a10-a73;
if (res[7]!=0) res[7][0]=a10;
a48=a48*a55;
a12=a12*a05;
a48=a48+a12;
if (res[8]!=0) res[8][0]=a48;
a27=a27*a72;
a29=a29*a31;
a27=a27+a29;
a29=a21*a24;
a66=a29*a66;
a70=a24*a70;
a21=a21*a22;
a70=a70+a21;
a16=a16*a70;
a66=a66+a16;
a27=a27+a66;
a63=a24*a63;
a13=a13*a22;
a63=a63+a13;
a27=a27+a63;
if (res[9]!=0) res[9][0]=a27;
a19=a19*a54;
a02=a02*a49;
a19=a19+a02;
if (res[10]!=0) res[10][0]=a19;
a07=a07/a09;
a19=a07*a46;
a62=2.*a62;
a19=a19*a62;
a08=2.*a08;
a58=a58/a09;
a09=a07/a09;
a09=a09*a61;
a58=a58-a09;
a46=a46*a58;
a07=a07*a56;
a46=a46+a07;
a08=a08*a46;
a19=a19+a08;
if (res[11]!=0) res[11][0]=a19;
a24=a24*a65;
a22=a14*a22;
a24=a24+a22;
if (res[12]!=0) res[12][0]=a24;
a29=a29*a65;
a14=a14*a70;
a29=a29+a14;
if (res[13]!=0) res[13][0]=a29;
a67=a32*a67;
a34=a34*a71;
a67=a67+a34;
if (res[14]!=0) res[14][0]=a67;
a39=a32*a39;
a17=a17*a71;
a39=a39+a17;
if (res[15]!=0) res[15][0]=a39;
a38=a32*a38;
a18=a18*a71;
a38=a38+a18;
if (res[16]!=0) res[16][0]=a38;
a32=a32*a44;
a25=a25*a71;
a32=a32+a25;
if (res[17]!=0) res[17][0]=a32;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_placement_following(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f3(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_placement_following_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_placement_following_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_placement_following_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_placement_following_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_placement_following_n_in(void) { return 78;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_placement_following_n_out(void) { return 18;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_placement_following_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_placement_following_name_in(casadi_int i) {
switch (i) {
case 0: return "x_main";
case 1: return "x_third";
case 2: return "x_tail";
case 3: return "kappa";
case 4: return "u";
case 5: return "x_cg";
case 6: return "m";
case 7: return "w";
case 8: return "tau";
case 9: return "eta";
case 10: return "g";
case 11: return "u_lift";
case 12: return "B3";
case 13: return "C3";
case 14: return "K1";
case 15: return "K2";
case 16: return "K3";
case 17: return "K4";
case 18: return "out_a";
case 19: return "out_b";
case 20: return "out_Fz";
case 21: return "out_F_tail_load";
case 22: return "out_C_alpha";
case 23: return "out_Ct";
case 24: return "adj_a";
case 25: return "adj_b";
case 26: return "adj_Fz";
case 27: return "adj_F_tail_load";
case 28: return "adj_C_alpha";
case 29: return "adj_Ct";
case 30: return "out_adj_x_main";
case 31: return "out_adj_x_third";
case 32: return "out_adj_x_tail";
case 33: return "out_adj_kappa";
case 34: return "out_adj_u";
case 35: return "out_adj_x_cg";
case 36: return "out_adj_m";
case 37: return "out_adj_w";
case 38: return "out_adj_tau";
case 39: return "out_adj_eta";
case 40: return "out_adj_g";
case 41: return "out_adj_u_lift";
case 42: return "out_adj_B3";
case 43: return "out_adj_C3";
case 44: return "out_adj_K1";
case 45: return "out_adj_K2";
case 46: return "out_adj_K3";
case 47: return "out_adj_K4";
case 48: return "fwd_x_main";
case 49: return "fwd_x_third";
case 50: return "fwd_x_tail";
case 51: return "fwd_kappa";
case 52: return "fwd_u";
case 53: return "fwd_x_cg";
case 54: return "fwd_m";
case 55: return "fwd_w";
case 56: return "fwd_tau";
case 57: return "fwd_eta";
case 58: return "fwd_g";
case 59: return "fwd_u_lift";
case 60: return "fwd_B3";
case 61: return "fwd_C3";
case 62: return "fwd_K1";
case 63: return "fwd_K2";
case 64: return "fwd_K3";
case 65: return "fwd_K4";
case 66: return "fwd_out_a";
case 67: return "fwd_out_b";
case 68: return "fwd_out_Fz";
case 69: return "fwd_out_F_tail_load";
case 70: return "fwd_out_C_alpha";
case 71: return "fwd_out_Ct";
case 72: return "fwd_adj_a";
case 73: return "fwd_adj_b";
case 74: return "fwd_adj_Fz";
case 75: return "fwd_adj_F_tail_load";
case 76: return "fwd_adj_C_alpha";
case 77: return "fwd_adj_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_placement_following_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_x_main";
case 1: return "fwd_adj_x_third";
case 2: return "fwd_adj_x_tail";
case 3: return "fwd_adj_kappa";
case 4: return "fwd_adj_u";
case 5: return "fwd_adj_x_cg";
case 6: return "fwd_adj_m";
case 7: return "fwd_adj_w";
case 8: return "fwd_adj_tau";
case 9: return "fwd_adj_eta";
case 10: return "fwd_adj_g";
case 11: return "fwd_adj_u_lift";
case 12: return "fwd_adj_B3";
case 13: return "fwd_adj_C3";
case 14: return "fwd_adj_K1";
case 15: return "fwd_adj_K2";
case 16: return "fwd_adj_K3";
case 17: return "fwd_adj_K4";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_placement_following_sparsity_in(casadi_int i) {
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
case 15: return casadi_s0;
case 16: return casadi_s0;
case 17: return casadi_s0;
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
case 30: return casadi_s1;
case 31: return casadi_s1;
case 32: return casadi_s1;
case 33: return casadi_s1;
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
case 46: return casadi_s1;
case 47: return casadi_s1;
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
case 58: return casadi_s0;
case 59: return casadi_s0;
case 60: return casadi_s0;
case 61: return casadi_s0;
case 62: return casadi_s0;
case 63: return casadi_s0;
case 64: return casadi_s0;
case 65: return casadi_s0;
case 66: return casadi_s1;
case 67: return casadi_s1;
case 68: return casadi_s1;
case 69: return casadi_s1;
case 70: return casadi_s1;
case 71: return casadi_s1;
case 72: return casadi_s0;
case 73: return casadi_s0;
case 74: return casadi_s0;
case 75: return casadi_s0;
case 76: return casadi_s0;
case 77: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_placement_following_sparsity_out(casadi_int i) {
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
case 15: return casadi_s0;
case 16: return casadi_s0;
case 17: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_placement_following_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 78;
if (sz_res) *sz_res = 18;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_placement_following_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 78*sizeof(const casadi_real*);
if (sz_res) *sz_res = 18*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* placement_constant:(x_main,x_third,x_tail,kappa,u,x_cg,m,w,tau,eta,g,u_lift,C_alpha_0,Fz_0,Ct_0,F_0,K1,K2,K3,K4)->(a,b,Fz,F_tail_load,C_alpha,Ct) */
static int casadi_f4(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5, a6, a7, a8;
a0=arg[5]? arg[5][0] : 0;
a1=arg[0]? arg[0][0] : 0;
a2=a0-a1;
if (res[0]!=0) res[0][0]=a2;
a2=arg[2]? arg[2][0] : 0;
a2=a2-a0;
if (res[1]!=0) res[1][0]=a2;
a2=arg[13]? arg[13][0] : 0;
a3=arg[7]? arg[7][0] : 0;
a4=1.;
a5=arg[4]? arg[4][0] : 0;
a5=casadi_sq(a5);
a6=arg[11]? arg[11][0] : 0;
a6=casadi_sq(a6);
a5=a5/a6;
a5=a4-a5;
a3=a3*a5;
a2=a2*a3;
if (res[2]!=0) res[2][0]=a2;
a2=arg[10]? arg[10][0] : 0;
a5=arg[6]? arg[6][0] : 0;
a2=a2*a5;
a5=arg[8]? arg[8][0] : 0;
a2=a2*a5;
a2=a2*a3;
a6=arg[1]? arg[1][0] : 0;
a0=a6-a0;
a6=a6-a1;
a0=a0/a6;
a4=a4-a0;
a2=a2*a4;
if (res[3]!=0) res[3][0]=a2;
a2=arg[12]? arg[12][0] : 0;
a4=arg[9]? arg[9][0] : 0;
a2=a2*a4;
a2=a2*a3;
if (res[4]!=0) res[4][0]=a2;
a2=arg[14]? arg[14][0] : 0;
a2=a2*a4;
a4=arg[3]? arg[3][0] : 0;
a2=a2*a4;
a2=a2*a5;
a4=arg[15]? arg[15][0] : 0;
a3=arg[17]? arg[17][0] : 0;
a0=a4*a3;
a0=a0*a5;
a6=arg[16]? arg[16][0] : 0;
a0=a0+a6;
a1=casadi_sq(a5);
a1=a5*a1;
a7=casadi_sq(a4);
a7=a4*a7;
a8=arg[19]? arg[19][0] : 0;
a7=a7*a8;
a1=a1*a7;
a0=a0+a1;
a5=casadi_sq(a5);
a1=casadi_sq(a4);
a8=arg[18]? arg[18][0] : 0;
a1=a1*a8;
a5=a5*a1;
a0=a0+a5;
a2=a2*a0;
a4=a4*a3;
a4=a4+a6;
a4=a4+a1;
a4=a4+a7;
a2=a2/a4;
if (res[5]!=0) res[5][0]=a2;
return 0;
}
CASADI_SYMBOL_EXPORT int placement_constant(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f4(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int placement_constant_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void placement_constant_release(int mem) {
}
CASADI_SYMBOL_EXPORT void placement_constant_incref(void) {
}
CASADI_SYMBOL_EXPORT void placement_constant_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int placement_constant_n_in(void) { return 20;}
CASADI_SYMBOL_EXPORT casadi_int placement_constant_n_out(void) { return 6;}
CASADI_SYMBOL_EXPORT casadi_real placement_constant_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* placement_constant_name_in(casadi_int i) {
switch (i) {
case 0: return "x_main";
case 1: return "x_third";
case 2: return "x_tail";
case 3: return "kappa";
case 4: return "u";
case 5: return "x_cg";
case 6: return "m";
case 7: return "w";
case 8: return "tau";
case 9: return "eta";
case 10: return "g";
case 11: return "u_lift";
case 12: return "C_alpha_0";
case 13: return "Fz_0";
case 14: return "Ct_0";
case 15: return "F_0";
case 16: return "K1";
case 17: return "K2";
case 18: return "K3";
case 19: return "K4";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* placement_constant_name_out(casadi_int i) {
switch (i) {
case 0: return "a";
case 1: return "b";
case 2: return "Fz";
case 3: return "F_tail_load";
case 4: return "C_alpha";
case 5: return "Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* placement_constant_sparsity_in(casadi_int i) {
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
case 15: return casadi_s0;
case 16: return casadi_s0;
case 17: return casadi_s0;
case 18: return casadi_s0;
case 19: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* placement_constant_sparsity_out(casadi_int i) {
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
CASADI_SYMBOL_EXPORT int placement_constant_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 20;
if (sz_res) *sz_res = 6;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int placement_constant_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
if (sz_res) *sz_res = 6*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_placement_constant:(x_main,x_third,x_tail,kappa,u,x_cg,m,w,tau,eta,g,u_lift,C_alpha_0,Fz_0,Ct_0,F_0,K1,K2,K3,K4,out_a[1x1,0nz],out_b[1x1,0nz],out_Fz[1x1,0nz],out_F_tail_load[1x1,0nz],out_C_alpha[1x1,0nz],out_Ct[1x1,0nz],fwd_x_main,fwd_x_third,fwd_x_tail,fwd_kappa,fwd_u,fwd_x_cg,fwd_m,fwd_w,fwd_tau,fwd_eta,fwd_g,fwd_u_lift,fwd_C_alpha_0,fwd_Fz_0,fwd_Ct_0,fwd_F_0,fwd_K1,fwd_K2,fwd_K3,fwd_K4)->(fwd_a,fwd_b,fwd_Fz,fwd_F_tail_load,fwd_C_alpha,fwd_Ct) */
static int casadi_f5(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22;
a00=arg[31]? arg[31][0] : 0;
a01=arg[26]? arg[26][0] : 0;
a02=a00-a01;
if (res[0]!=0) res[0][0]=a02;
a02=arg[28]? arg[28][0] : 0;
a02=a02-a00;
if (res[1]!=0) res[1][0]=a02;
a02=arg[7]? arg[7][0] : 0;
a03=1.;
a04=arg[4]? arg[4][0] : 0;
a05=casadi_sq(a04);
a06=arg[11]? arg[11][0] : 0;
a07=casadi_sq(a06);
a05=a05/a07;
a08=a03-a05;
a09=a02*a08;
a10=arg[39]? arg[39][0] : 0;
a10=a09*a10;
a11=arg[13]? arg[13][0] : 0;
a12=arg[33]? arg[33][0] : 0;
a08=a08*a12;
a04=2.*a04;
a12=arg[30]? arg[30][0] : 0;
a04=a04*a12;
a04=a04/a07;
a05=a05/a07;
a06=2.*a06;
a07=arg[37]? arg[37][0] : 0;
a06=a06*a07;
a05=a05*a06;
a04=a04-a05;
a02=a02*a04;
a08=a08-a02;
a11=a11*a08;
a10=a10+a11;
if (res[2]!=0) res[2][0]=a10;
a10=arg[1]? arg[1][0] : 0;
a11=arg[5]? arg[5][0] : 0;
a11=a10-a11;
a02=arg[0]? arg[0][0] : 0;
a10=a10-a02;
a11=a11/a10;
a03=a03-a11;
a02=arg[8]? arg[8][0] : 0;
a04=arg[6]? arg[6][0] : 0;
a05=arg[36]? arg[36][0] : 0;
a05=a04*a05;
a06=arg[10]? arg[10][0] : 0;
a07=arg[32]? arg[32][0] : 0;
a07=a06*a07;
a05=a05+a07;
a05=a02*a05;
a06=a06*a04;
a04=arg[34]? arg[34][0] : 0;
a07=a06*a04;
a05=a05+a07;
a05=a09*a05;
a06=a06*a02;
a07=a06*a08;
a05=a05+a07;
a03=a03*a05;
a06=a06*a09;
a05=arg[27]? arg[27][0] : 0;
a00=a05-a00;
a00=a00/a10;
a11=a11/a10;
a05=a05-a01;
a11=a11*a05;
a00=a00-a11;
a06=a06*a00;
a03=a03-a06;
if (res[3]!=0) res[3][0]=a03;
a03=arg[9]? arg[9][0] : 0;
a06=arg[38]? arg[38][0] : 0;
a06=a03*a06;
a00=arg[12]? arg[12][0] : 0;
a11=arg[35]? arg[35][0] : 0;
a05=a00*a11;
a06=a06+a05;
a09=a09*a06;
a00=a00*a03;
a00=a00*a08;
a09=a09+a00;
if (res[4]!=0) res[4][0]=a09;
a09=arg[15]? arg[15][0] : 0;
a00=arg[17]? arg[17][0] : 0;
a08=a09*a00;
a06=a08*a02;
a05=arg[16]? arg[16][0] : 0;
a06=a06+a05;
a01=casadi_sq(a02);
a10=a02*a01;
a07=casadi_sq(a09);
a12=a09*a07;
a13=arg[19]? arg[19][0] : 0;
a14=a12*a13;
a15=a10*a14;
a06=a06+a15;
a15=casadi_sq(a02);
a16=casadi_sq(a09);
a17=arg[18]? arg[18][0] : 0;
a18=a16*a17;
a19=a15*a18;
a06=a06+a19;
a19=arg[3]? arg[3][0] : 0;
a20=arg[40]? arg[40][0] : 0;
a20=a03*a20;
a21=arg[14]? arg[14][0] : 0;
a11=a21*a11;
a20=a20+a11;
a20=a19*a20;
a21=a21*a03;
a03=arg[29]? arg[29][0] : 0;
a03=a21*a03;
a20=a20+a03;
a20=a02*a20;
a21=a21*a19;
a19=a21*a04;
a20=a20+a19;
a20=a06*a20;
a21=a21*a02;
a19=arg[41]? arg[41][0] : 0;
a03=a00*a19;
a11=arg[43]? arg[43][0] : 0;
a22=a09*a11;
a03=a03+a22;
a03=a02*a03;
a08=a08*a04;
a03=a03+a08;
a08=arg[42]? arg[42][0] : 0;
a03=a03+a08;
a01=a01*a04;
a22=2.*a02;
a22=a22*a04;
a22=a02*a22;
a01=a01+a22;
a01=a14*a01;
a07=a07*a19;
a22=2.*a09;
a22=a22*a19;
a22=a09*a22;
a07=a07+a22;
a13=a13*a07;
a07=arg[45]? arg[45][0] : 0;
a12=a12*a07;
a13=a13+a12;
a10=a10*a13;
a01=a01+a10;
a03=a03+a01;
a02=2.*a02;
a02=a02*a04;
a02=a18*a02;
a04=2.*a09;
a04=a04*a19;
a17=a17*a04;
a04=arg[44]? arg[44][0] : 0;
a16=a16*a04;
a17=a17+a16;
a15=a15*a17;
a02=a02+a15;
a03=a03+a02;
a03=a21*a03;
a20=a20+a03;
a03=a09*a00;
a03=a03+a05;
a03=a03+a18;
a03=a03+a14;
a20=a20/a03;
a21=a21*a06;
a21=a21/a03;
a21=a21/a03;
a00=a00*a19;
a09=a09*a11;
a00=a00+a09;
a00=a00+a08;
a00=a00+a17;
a00=a00+a13;
a21=a21*a00;
a20=a20-a21;
if (res[5]!=0) res[5][0]=a20;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_placement_constant(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f5(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_placement_constant_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_placement_constant_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_placement_constant_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_placement_constant_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_placement_constant_n_in(void) { return 46;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_placement_constant_n_out(void) { return 6;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_placement_constant_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_placement_constant_name_in(casadi_int i) {
switch (i) {
case 0: return "x_main";
case 1: return "x_third";
case 2: return "x_tail";
case 3: return "kappa";
case 4: return "u";
case 5: return "x_cg";
case 6: return "m";
case 7: return "w";
case 8: return "tau";
case 9: return "eta";
case 10: return "g";
case 11: return "u_lift";
case 12: return "C_alpha_0";
case 13: return "Fz_0";
case 14: return "Ct_0";
case 15: return "F_0";
case 16: return "K1";
case 17: return "K2";
case 18: return "K3";
case 19: return "K4";
case 20: return "out_a";
case 21: return "out_b";
case 22: return "out_Fz";
case 23: return "out_F_tail_load";
case 24: return "out_C_alpha";
case 25: return "out_Ct";
case 26: return "fwd_x_main";
case 27: return "fwd_x_third";
case 28: return "fwd_x_tail";
case 29: return "fwd_kappa";
case 30: return "fwd_u";
case 31: return "fwd_x_cg";
case 32: return "fwd_m";
case 33: return "fwd_w";
case 34: return "fwd_tau";
case 35: return "fwd_eta";
case 36: return "fwd_g";
case 37: return "fwd_u_lift";
case 38: return "fwd_C_alpha_0";
case 39: return "fwd_Fz_0";
case 40: return "fwd_Ct_0";
case 41: return "fwd_F_0";
case 42: return "fwd_K1";
case 43: return "fwd_K2";
case 44: return "fwd_K3";
case 45: return "fwd_K4";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_placement_constant_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_a";
case 1: return "fwd_b";
case 2: return "fwd_Fz";
case 3: return "fwd_F_tail_load";
case 4: return "fwd_C_alpha";
case 5: return "fwd_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_placement_constant_sparsity_in(casadi_int i) {
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
case 15: return casadi_s0;
case 16: return casadi_s0;
case 17: return casadi_s0;
case 18: return casadi_s0;
case 19: return casadi_s0;
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
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_placement_constant_sparsity_out(casadi_int i) {
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
CASADI_SYMBOL_EXPORT int fwd1_placement_constant_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 46;
if (sz_res) *sz_res = 6;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_placement_constant_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 46*sizeof(const casadi_real*);
if (sz_res) *sz_res = 6*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_placement_constant:(x_main,x_third,x_tail,kappa,u,x_cg,m,w,tau,eta,g,u_lift,C_alpha_0,Fz_0,Ct_0,F_0,K1,K2,K3,K4,out_a[1x1,0nz],out_b[1x1,0nz],out_Fz[1x1,0nz],out_F_tail_load[1x1,0nz],out_C_alpha[1x1,0nz],out_Ct[1x1,0nz],adj_a,adj_b,adj_Fz,adj_F_tail_load,adj_C_alpha,adj_Ct)->(adj_x_main,adj_x_third,adj_x_tail,adj_kappa,adj_u,adj_x_cg,adj_m,adj_w,adj_tau,adj_eta,adj_g,adj_u_lift,adj_C_alpha_0,adj_Fz_0,adj_Ct_0,adj_F_0,adj_K1,adj_K2,adj_K3,adj_K4) */
static int casadi_f6(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42;
a00=arg[1]? arg[1][0] : 0;
a01=arg[5]? arg[5][0] : 0;
a01=a00-a01;
a02=arg[0]? arg[0][0] : 0;
a00=a00-a02;
a01=a01/a00;
a02=a01/a00;
a03=arg[10]? arg[10][0] : 0;
a04=arg[6]? arg[6][0] : 0;
a05=a03*a04;
a06=arg[8]? arg[8][0] : 0;
a07=a05*a06;
a08=arg[7]? arg[7][0] : 0;
a09=1.;
a10=arg[4]? arg[4][0] : 0;
a11=casadi_sq(a10);
a12=arg[11]? arg[11][0] : 0;
a13=casadi_sq(a12);
a11=a11/a13;
a14=a09-a11;
a15=a08*a14;
a16=a07*a15;
a17=arg[29]? arg[29][0] : 0;
a16=a16*a17;
a02=a02*a16;
a18=arg[26]? arg[26][0] : 0;
a19=a02+a18;
a19=-a19;
if (res[0]!=0) res[0][0]=a19;
a16=a16/a00;
a02=a02-a16;
if (res[1]!=0) res[1][0]=a02;
a02=arg[27]? arg[27][0] : 0;
if (res[2]!=0) res[2][0]=a02;
a00=arg[14]? arg[14][0] : 0;
a19=arg[9]? arg[9][0] : 0;
a20=a00*a19;
a21=arg[15]? arg[15][0] : 0;
a22=arg[17]? arg[17][0] : 0;
a23=a21*a22;
a24=a23*a06;
a25=arg[16]? arg[16][0] : 0;
a24=a24+a25;
a26=casadi_sq(a06);
a27=a06*a26;
a28=casadi_sq(a21);
a29=a21*a28;
a30=arg[19]? arg[19][0] : 0;
a31=a29*a30;
a32=a27*a31;
a24=a24+a32;
a32=casadi_sq(a06);
a33=casadi_sq(a21);
a34=arg[18]? arg[18][0] : 0;
a35=a33*a34;
a36=a32*a35;
a24=a24+a36;
a36=arg[31]? arg[31][0] : 0;
a37=a21*a22;
a37=a37+a25;
a37=a37+a35;
a37=a37+a31;
a25=a36/a37;
a38=a24*a25;
a39=a06*a38;
a40=a20*a39;
if (res[3]!=0) res[3][0]=a40;
a10=2.*a10;
a40=arg[12]? arg[12][0] : 0;
a41=a40*a19;
a42=arg[30]? arg[30][0] : 0;
a41=a41*a42;
a09=a09-a01;
a09=a09*a17;
a07=a07*a09;
a41=a41+a07;
a07=arg[13]? arg[13][0] : 0;
a17=arg[28]? arg[28][0] : 0;
a07=a07*a17;
a41=a41+a07;
a08=a08*a41;
a07=a08/a13;
a10=a10*a07;
a10=-a10;
if (res[4]!=0) res[4][0]=a10;
a16=a16-a02;
a16=a16+a18;
if (res[5]!=0) res[5][0]=a16;
a09=a15*a09;
a16=a06*a09;
a03=a03*a16;
if (res[6]!=0) res[6][0]=a03;
a14=a14*a41;
if (res[7]!=0) res[7][0]=a14;
a14=2.*a06;
a41=arg[3]? arg[3][0] : 0;
a20=a20*a41;
a03=a20*a06;
a25=a03*a25;
a35=a35*a25;
a14=a14*a35;
a31=a31*a25;
a26=a26*a31;
a14=a14+a26;
a26=2.*a06;
a31=a06*a31;
a26=a26*a31;
a14=a14+a26;
a23=a23*a25;
a14=a14+a23;
a20=a20*a38;
a14=a14+a20;
a05=a05*a09;
a14=a14+a05;
if (res[8]!=0) res[8][0]=a14;
a41=a41*a39;
a00=a00*a41;
a42=a15*a42;
a40=a40*a42;
a00=a00+a40;
if (res[9]!=0) res[9][0]=a00;
a04=a04*a16;
if (res[10]!=0) res[10][0]=a04;
a12=2.*a12;
a11=a11/a13;
a11=a11*a08;
a12=a12*a11;
if (res[11]!=0) res[11][0]=a12;
a42=a19*a42;
if (res[12]!=0) res[12][0]=a42;
a15=a15*a17;
if (res[13]!=0) res[13][0]=a15;
a19=a19*a41;
if (res[14]!=0) res[14][0]=a19;
a19=2.*a21;
a32=a32*a25;
a03=a03*a24;
a03=a03/a37;
a03=a03/a37;
a03=a03*a36;
a32=a32-a03;
a34=a34*a32;
a19=a19*a34;
a34=a22*a03;
a19=a19-a34;
a27=a27*a25;
a27=a27-a03;
a30=a30*a27;
a28=a28*a30;
a19=a19+a28;
a28=2.*a21;
a30=a21*a30;
a28=a28*a30;
a19=a19+a28;
a06=a06*a25;
a22=a22*a06;
a19=a19+a22;
if (res[15]!=0) res[15][0]=a19;
a25=a25-a03;
if (res[16]!=0) res[16][0]=a25;
a06=a21*a06;
a21=a21*a03;
a06=a06-a21;
if (res[17]!=0) res[17][0]=a06;
a33=a33*a32;
if (res[18]!=0) res[18][0]=a33;
a29=a29*a27;
if (res[19]!=0) res[19][0]=a29;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_placement_constant(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f6(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_placement_constant_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_placement_constant_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_placement_constant_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_placement_constant_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_placement_constant_n_in(void) { return 32;}
CASADI_SYMBOL_EXPORT casadi_int adj1_placement_constant_n_out(void) { return 20;}
CASADI_SYMBOL_EXPORT casadi_real adj1_placement_constant_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_placement_constant_name_in(casadi_int i) {
switch (i) {
case 0: return "x_main";
case 1: return "x_third";
case 2: return "x_tail";
case 3: return "kappa";
case 4: return "u";
case 5: return "x_cg";
case 6: return "m";
case 7: return "w";
case 8: return "tau";
case 9: return "eta";
case 10: return "g";
case 11: return "u_lift";
case 12: return "C_alpha_0";
case 13: return "Fz_0";
case 14: return "Ct_0";
case 15: return "F_0";
case 16: return "K1";
case 17: return "K2";
case 18: return "K3";
case 19: return "K4";
case 20: return "out_a";
case 21: return "out_b";
case 22: return "out_Fz";
case 23: return "out_F_tail_load";
case 24: return "out_C_alpha";
case 25: return "out_Ct";
case 26: return "adj_a";
case 27: return "adj_b";
case 28: return "adj_Fz";
case 29: return "adj_F_tail_load";
case 30: return "adj_C_alpha";
case 31: return "adj_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_placement_constant_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_x_main";
case 1: return "adj_x_third";
case 2: return "adj_x_tail";
case 3: return "adj_kappa";
case 4: return "adj_u";
case 5: return "adj_x_cg";
case 6: return "adj_m";
case 7: return "adj_w";
case 8: return "adj_tau";
case 9: return "adj_eta";
case 10: return "adj_g";
case 11: return "adj_u_lift";
case 12: return "adj_C_alpha_0";
case 13: return "adj_Fz_0";
case 14: return "adj_Ct_0";
case 15: return "adj_F_0";
case 16: return "adj_K1";
case 17: return "adj_K2";
case 18: return "adj_K3";
case 19: return "adj_K4";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_placement_constant_sparsity_in(casadi_int i) {
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
case 15: return casadi_s0;
case 16: return casadi_s0;
case 17: return casadi_s0;
case 18: return casadi_s0;
case 19: return casadi_s0;
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
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_placement_constant_sparsity_out(casadi_int i) {
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
case 15: return casadi_s0;
case 16: return casadi_s0;
case 17: return casadi_s0;
case 18: return casadi_s0;
case 19: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_placement_constant_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 32;
if (sz_res) *sz_res = 20;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_placement_constant_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 32*sizeof(const casadi_real*);
if (sz_res) *sz_res = 20*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_placement_constant:(x_main,x_third,x_tail,kappa,u,x_cg,m,w,tau,eta,g,u_lift,C_alpha_0,Fz_0,Ct_0,F_0,K1,K2,K3,K4,out_a[1x1,0nz],out_b[1x1,0nz],out_Fz[1x1,0nz],out_F_tail_load[1x1,0nz],out_C_alpha[1x1,0nz],out_Ct[1x1,0nz],adj_a,adj_b,adj_Fz,adj_F_tail_load,adj_C_alpha,adj_Ct,out_adj_x_main[1x1,0nz],out_adj_x_third[1x1,0nz],out_adj_x_tail[1x1,0nz],out_adj_kappa[1x1,0nz],out_adj_u[1x1,0nz],out_adj_x_cg[1x1,0nz],out_adj_m[1x1,0nz],out_adj_w[1x1,0nz],out_adj_tau[1x1,0nz],out_adj_eta[1x1,0nz],out_adj_g[1x1,0nz],out_adj_u_lift[1x1,0nz],out_adj_C_alpha_0[1x1,0nz],out_adj_Fz_0[1x1,0nz],out_adj_Ct_0[1x1,0nz],out_adj_F_0[1x1,0nz],out_adj_K1[1x1,0nz],out_adj_K2[1x1,0nz],out_adj_K3[1x1,0nz],out_adj_K4[1x1,0nz],fwd_x_main,fwd_x_third,fwd_x_tail,fwd_kappa,fwd_u,fwd_x_cg,fwd_m,fwd_w,fwd_tau,fwd_eta,fwd_g,fwd_u_lift,fwd_C_alpha_0,fwd_Fz_0,fwd_Ct_0,fwd_F_0,fwd_K1,fwd_K2,fwd_K3,fwd_K4,fwd_out_a[1x1,0nz],fwd_out_b[1x1,0nz],fwd_out_Fz[1x1,0nz],fwd_out_F_tail_load[1x1,0nz],fwd_out_C_alpha[1x1,0nz],fwd_out_Ct[1x1,0nz],fwd_adj_a,fwd_adj_b,fwd_adj_Fz,fwd_adj_F_tail_load,fwd_adj_C_alpha,fwd_adj_Ct)->(fwd_adj_x_main,fwd_adj_x_third,fwd_adj_x_tail,fwd_adj_kappa,fwd_adj_u,fwd_adj_x_cg,fwd_adj_m,fwd_adj_w,fwd_adj_tau,fwd_adj_eta,fwd_adj_g,fwd_adj_u_lift,fwd_adj_C_alpha_0,fwd_adj_Fz_0,fwd_adj_Ct_0,fwd_adj_F_0,fwd_adj_K1,fwd_adj_K2,fwd_adj_K3,fwd_adj_K4) */
static int casadi_f7(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
casadi_real a72, a73, a74, a75, a76, a77, a78, a79, a80, a81, a82, a83;
casadi_real a84, a85;
a00=arg[10]? arg[10][0] : 0;
a01=arg[6]? arg[6][0] : 0;
a02=a00*a01;
a03=arg[8]? arg[8][0] : 0;
a04=a02*a03;
a05=arg[7]? arg[7][0] : 0;
a06=1.;
a07=arg[4]? arg[4][0] : 0;
a08=casadi_sq(a07);
a09=arg[11]? arg[11][0] : 0;
a10=casadi_sq(a09);
a08=a08/a10;
a11=a06-a08;
a12=a05*a11;
a13=a04*a12;
a14=arg[29]? arg[29][0] : 0;
a15=a13*a14;
a16=arg[53]? arg[53][0] : 0;
a17=arg[57]? arg[57][0] : 0;
a17=a16-a17;
a18=arg[1]? arg[1][0] : 0;
a19=arg[0]? arg[0][0] : 0;
a19=a18-a19;
a17=a17/a19;
a20=arg[5]? arg[5][0] : 0;
a18=a18-a20;
a18=a18/a19;
a20=a18/a19;
a21=arg[52]? arg[52][0] : 0;
a16=a16-a21;
a20=a20*a16;
a17=a17-a20;
a20=a17/a19;
a21=a18/a19;
a22=a21/a19;
a22=a22*a16;
a20=a20-a22;
a20=a15*a20;
a22=arg[62]? arg[62][0] : 0;
a23=a01*a22;
a24=arg[58]? arg[58][0] : 0;
a25=a00*a24;
a23=a23+a25;
a25=a03*a23;
a26=arg[60]? arg[60][0] : 0;
a27=a02*a26;
a25=a25+a27;
a27=a12*a25;
a28=arg[59]? arg[59][0] : 0;
a29=a11*a28;
a30=2.*a07;
a31=arg[56]? arg[56][0] : 0;
a30=a30*a31;
a30=a30/a10;
a32=a08/a10;
a33=2.*a09;
a34=arg[63]? arg[63][0] : 0;
a33=a33*a34;
a32=a32*a33;
a30=a30-a32;
a32=a05*a30;
a29=a29-a32;
a32=a04*a29;
a27=a27+a32;
a27=a14*a27;
a32=arg[81]? arg[81][0] : 0;
a13=a13*a32;
a27=a27+a13;
a21=a21*a27;
a20=a20+a21;
a21=arg[78]? arg[78][0] : 0;
a13=a20+a21;
a13=-a13;
if (res[0]!=0) res[0][0]=a13;
a27=a27/a19;
a15=a15/a19;
a15=a15/a19;
a15=a15*a16;
a27=a27-a15;
a20=a20-a27;
if (res[1]!=0) res[1][0]=a20;
a20=arg[79]? arg[79][0] : 0;
if (res[2]!=0) res[2][0]=a20;
a15=arg[15]? arg[15][0] : 0;
a16=arg[17]? arg[17][0] : 0;
a19=a15*a16;
a13=a19*a03;
a35=arg[16]? arg[16][0] : 0;
a13=a13+a35;
a36=casadi_sq(a03);
a37=a03*a36;
a38=casadi_sq(a15);
a39=a15*a38;
a40=arg[19]? arg[19][0] : 0;
a41=a39*a40;
a42=a37*a41;
a13=a13+a42;
a42=casadi_sq(a03);
a43=casadi_sq(a15);
a44=arg[18]? arg[18][0] : 0;
a45=a43*a44;
a46=a42*a45;
a13=a13+a46;
a46=arg[31]? arg[31][0] : 0;
a47=a15*a16;
a47=a47+a35;
a47=a47+a45;
a47=a47+a41;
a35=a46/a47;
a48=a13*a35;
a49=a03*a48;
a50=arg[9]? arg[9][0] : 0;
a51=arg[66]? arg[66][0] : 0;
a52=a50*a51;
a53=arg[14]? arg[14][0] : 0;
a54=arg[61]? arg[61][0] : 0;
a55=a53*a54;
a52=a52+a55;
a55=a49*a52;
a56=a53*a50;
a57=a48*a26;
a58=arg[67]? arg[67][0] : 0;
a59=a16*a58;
a60=arg[69]? arg[69][0] : 0;
a61=a15*a60;
a59=a59+a61;
a61=a03*a59;
a62=a19*a26;
a61=a61+a62;
a62=arg[68]? arg[68][0] : 0;
a61=a61+a62;
a63=a36*a26;
a64=2.*a03;
a64=a64*a26;
a65=a03*a64;
a63=a63+a65;
a65=a41*a63;
a66=a38*a58;
a67=2.*a15;
a67=a67*a58;
a68=a15*a67;
a66=a66+a68;
a68=a40*a66;
a69=arg[71]? arg[71][0] : 0;
a70=a39*a69;
a68=a68+a70;
a70=a37*a68;
a65=a65+a70;
a61=a61+a65;
a65=2.*a03;
a65=a65*a26;
a70=a45*a65;
a71=2.*a15;
a71=a71*a58;
a72=a44*a71;
a73=arg[70]? arg[70][0] : 0;
a74=a43*a73;
a72=a72+a74;
a74=a42*a72;
a70=a70+a74;
a61=a61+a70;
a70=a35*a61;
a74=arg[83]? arg[83][0] : 0;
a75=a74/a47;
a76=a35/a47;
a77=a16*a58;
a78=a15*a60;
a77=a77+a78;
a77=a77+a62;
a77=a77+a72;
a77=a77+a68;
a76=a76*a77;
a75=a75-a76;
a76=a13*a75;
a70=a70+a76;
a76=a03*a70;
a57=a57+a76;
a76=a56*a57;
a55=a55+a76;
if (res[3]!=0) res[3][0]=a55;
a55=arg[12]? arg[12][0] : 0;
a76=a55*a50;
a62=arg[30]? arg[30][0] : 0;
a78=a76*a62;
a06=a06-a18;
a18=a06*a14;
a79=a04*a18;
a78=a78+a79;
a79=arg[13]? arg[13][0] : 0;
a80=arg[28]? arg[28][0] : 0;
a81=a79*a80;
a78=a78+a81;
a81=a05*a78;
a82=a81/a10;
a31=2.*a31;
a31=a82*a31;
a07=2.*a07;
a28=a78*a28;
a83=arg[64]? arg[64][0] : 0;
a84=a50*a83;
a85=a55*a54;
a84=a84+a85;
a84=a62*a84;
a85=arg[82]? arg[82][0] : 0;
a76=a76*a85;
a84=a84+a76;
a25=a18*a25;
a06=a06*a32;
a14=a14*a17;
a06=a06-a14;
a04=a04*a06;
a25=a25+a04;
a84=a84+a25;
a25=arg[65]? arg[65][0] : 0;
a25=a80*a25;
a04=arg[80]? arg[80][0] : 0;
a79=a79*a04;
a25=a25+a79;
a84=a84+a25;
a05=a05*a84;
a28=a28+a05;
a05=a28/a10;
a82=a82/a10;
a82=a82*a33;
a05=a05-a82;
a07=a07*a05;
a31=a31+a07;
a31=-a31;
if (res[4]!=0) res[4][0]=a31;
a27=a27-a20;
a27=a27+a21;
if (res[5]!=0) res[5][0]=a27;
a27=a12*a18;
a21=a03*a27;
a22=a21*a22;
a20=a27*a26;
a18=a18*a29;
a06=a12*a06;
a18=a18+a06;
a06=a03*a18;
a20=a20+a06;
a00=a00*a20;
a22=a22+a00;
if (res[6]!=0) res[6][0]=a22;
a11=a11*a84;
a78=a78*a30;
a11=a11-a78;
if (res[7]!=0) res[7][0]=a11;
a11=arg[3]? arg[3][0] : 0;
a78=a56*a11;
a84=a78*a03;
a22=a84*a35;
a00=a45*a22;
a06=2.*a26;
a00=a00*a06;
a06=2.*a03;
a72=a22*a72;
a52=a11*a52;
a31=arg[55]? arg[55][0] : 0;
a56=a56*a31;
a52=a52+a56;
a56=a03*a52;
a07=a78*a26;
a56=a56+a07;
a35=a35*a56;
a75=a84*a75;
a35=a35+a75;
a45=a45*a35;
a72=a72+a45;
a06=a06*a72;
a00=a00+a06;
a06=a41*a22;
a64=a06*a64;
a68=a22*a68;
a41=a41*a35;
a68=a68+a41;
a36=a36*a68;
a64=a64+a36;
a00=a00+a64;
a64=a03*a06;
a36=2.*a26;
a64=a64*a36;
a36=2.*a03;
a06=a06*a26;
a68=a03*a68;
a06=a06+a68;
a36=a36*a06;
a64=a64+a36;
a00=a00+a64;
a59=a22*a59;
a19=a19*a35;
a59=a59+a19;
a00=a00+a59;
a48=a48*a52;
a78=a78*a70;
a48=a48+a78;
a00=a00+a48;
a27=a27*a23;
a02=a02*a18;
a27=a27+a02;
a00=a00+a27;
if (res[8]!=0) res[8][0]=a00;
a00=a11*a49;
a51=a00*a51;
a49=a49*a31;
a11=a11*a57;
a49=a49+a11;
a53=a53*a49;
a51=a51+a53;
a53=a12*a62;
a83=a53*a83;
a62=a62*a29;
a85=a12*a85;
a62=a62+a85;
a55=a55*a62;
a83=a83+a55;
a51=a51+a83;
if (res[9]!=0) res[9][0]=a51;
a21=a21*a24;
a01=a01*a20;
a21=a21+a01;
if (res[10]!=0) res[10][0]=a21;
a08=a08/a10;
a21=a08*a81;
a34=2.*a34;
a21=a21*a34;
a09=2.*a09;
a30=a30/a10;
a10=a08/a10;
a10=a10*a33;
a30=a30-a10;
a81=a81*a30;
a08=a08*a28;
a81=a81+a08;
a09=a09*a81;
a21=a21+a09;
if (res[11]!=0) res[11][0]=a21;
a53=a53*a54;
a62=a50*a62;
a53=a53+a62;
if (res[12]!=0) res[12][0]=a53;
a80=a80*a29;
a12=a12*a04;
a80=a80+a12;
if (res[13]!=0) res[13][0]=a80;
a00=a00*a54;
a50=a50*a49;
a00=a00+a50;
if (res[14]!=0) res[14][0]=a00;
a00=a42*a22;
a50=a84*a13;
a50=a50/a47;
a49=a50/a47;
a54=a49*a46;
a00=a00-a54;
a80=a44*a00;
a12=2.*a58;
a80=a80*a12;
a12=2.*a15;
a73=a00*a73;
a65=a22*a65;
a42=a42*a35;
a65=a65+a42;
a13=a13*a56;
a84=a84*a61;
a13=a13+a84;
a13=a13/a47;
a50=a50/a47;
a50=a50*a77;
a13=a13-a50;
a13=a13/a47;
a47=a49/a47;
a47=a47*a77;
a13=a13-a47;
a46=a46*a13;
a49=a49*a74;
a46=a46+a49;
a65=a65-a46;
a44=a44*a65;
a73=a73+a44;
a12=a12*a73;
a80=a80+a12;
a12=a54*a60;
a73=a16*a46;
a12=a12+a73;
a80=a80-a12;
a12=a37*a22;
a12=a12-a54;
a73=a40*a12;
a67=a73*a67;
a69=a12*a69;
a63=a22*a63;
a37=a37*a35;
a63=a63+a37;
a63=a63-a46;
a40=a40*a63;
a69=a69+a40;
a38=a38*a69;
a67=a67+a38;
a80=a80+a67;
a67=a15*a73;
a38=2.*a58;
a67=a67*a38;
a38=2.*a15;
a73=a73*a58;
a69=a15*a69;
a73=a73+a69;
a38=a38*a73;
a67=a67+a38;
a80=a80+a67;
a67=a03*a22;
a60=a67*a60;
a22=a22*a26;
a03=a03*a35;
a22=a22+a03;
a16=a16*a22;
a60=a60+a16;
a80=a80+a60;
if (res[15]!=0) res[15][0]=a80;
a35=a35-a46;
if (res[16]!=0) res[16][0]=a35;
a67=a67*a58;
a22=a15*a22;
a67=a67+a22;
a54=a54*a58;
a15=a15*a46;
a54=a54+a15;
a67=a67-a54;
if (res[17]!=0) res[17][0]=a67;
a00=a00*a71;
a43=a43*a65;
a00=a00+a43;
if (res[18]!=0) res[18][0]=a00;
a12=a12*a66;
a39=a39*a63;
a12=a12+a39;
if (res[19]!=0) res[19][0]=a12;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_placement_constant(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f7(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_placement_constant_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_placement_constant_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_placement_constant_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_placement_constant_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_placement_constant_n_in(void) { return 84;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_placement_constant_n_out(void) { return 20;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_placement_constant_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_placement_constant_name_in(casadi_int i) {
switch (i) {
case 0: return "x_main";
case 1: return "x_third";
case 2: return "x_tail";
case 3: return "kappa";
case 4: return "u";
case 5: return "x_cg";
case 6: return "m";
case 7: return "w";
case 8: return "tau";
case 9: return "eta";
case 10: return "g";
case 11: return "u_lift";
case 12: return "C_alpha_0";
case 13: return "Fz_0";
case 14: return "Ct_0";
case 15: return "F_0";
case 16: return "K1";
case 17: return "K2";
case 18: return "K3";
case 19: return "K4";
case 20: return "out_a";
case 21: return "out_b";
case 22: return "out_Fz";
case 23: return "out_F_tail_load";
case 24: return "out_C_alpha";
case 25: return "out_Ct";
case 26: return "adj_a";
case 27: return "adj_b";
case 28: return "adj_Fz";
case 29: return "adj_F_tail_load";
case 30: return "adj_C_alpha";
case 31: return "adj_Ct";
case 32: return "out_adj_x_main";
case 33: return "out_adj_x_third";
case 34: return "out_adj_x_tail";
case 35: return "out_adj_kappa";
case 36: return "out_adj_u";
case 37: return "out_adj_x_cg";
case 38: return "out_adj_m";
case 39: return "out_adj_w";
case 40: return "out_adj_tau";
case 41: return "out_adj_eta";
case 42: return "out_adj_g";
case 43: return "out_adj_u_lift";
case 44: return "out_adj_C_alpha_0";
case 45: return "out_adj_Fz_0";
case 46: return "out_adj_Ct_0";
case 47: return "out_adj_F_0";
case 48: return "out_adj_K1";
case 49: return "out_adj_K2";
case 50: return "out_adj_K3";
case 51: return "out_adj_K4";
case 52: return "fwd_x_main";
case 53: return "fwd_x_third";
case 54: return "fwd_x_tail";
case 55: return "fwd_kappa";
case 56: return "fwd_u";
case 57: return "fwd_x_cg";
case 58: return "fwd_m";
case 59: return "fwd_w";
case 60: return "fwd_tau";
case 61: return "fwd_eta";
case 62: return "fwd_g";
case 63: return "fwd_u_lift";
case 64: return "fwd_C_alpha_0";
case 65: return "fwd_Fz_0";
case 66: return "fwd_Ct_0";
case 67: return "fwd_F_0";
case 68: return "fwd_K1";
case 69: return "fwd_K2";
case 70: return "fwd_K3";
case 71: return "fwd_K4";
case 72: return "fwd_out_a";
case 73: return "fwd_out_b";
case 74: return "fwd_out_Fz";
case 75: return "fwd_out_F_tail_load";
case 76: return "fwd_out_C_alpha";
case 77: return "fwd_out_Ct";
case 78: return "fwd_adj_a";
case 79: return "fwd_adj_b";
case 80: return "fwd_adj_Fz";
case 81: return "fwd_adj_F_tail_load";
case 82: return "fwd_adj_C_alpha";
case 83: return "fwd_adj_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_placement_constant_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_x_main";
case 1: return "fwd_adj_x_third";
case 2: return "fwd_adj_x_tail";
case 3: return "fwd_adj_kappa";
case 4: return "fwd_adj_u";
case 5: return "fwd_adj_x_cg";
case 6: return "fwd_adj_m";
case 7: return "fwd_adj_w";
case 8: return "fwd_adj_tau";
case 9: return "fwd_adj_eta";
case 10: return "fwd_adj_g";
case 11: return "fwd_adj_u_lift";
case 12: return "fwd_adj_C_alpha_0";
case 13: return "fwd_adj_Fz_0";
case 14: return "fwd_adj_Ct_0";
case 15: return "fwd_adj_F_0";
case 16: return "fwd_adj_K1";
case 17: return "fwd_adj_K2";
case 18: return "fwd_adj_K3";
case 19: return "fwd_adj_K4";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_placement_constant_sparsity_in(casadi_int i) {
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
case 15: return casadi_s0;
case 16: return casadi_s0;
case 17: return casadi_s0;
case 18: return casadi_s0;
case 19: return casadi_s0;
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
case 32: return casadi_s1;
case 33: return casadi_s1;
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
case 46: return casadi_s1;
case 47: return casadi_s1;
case 48: return casadi_s1;
case 49: return casadi_s1;
case 50: return casadi_s1;
case 51: return casadi_s1;
case 52: return casadi_s0;
case 53: return casadi_s0;
case 54: return casadi_s0;
case 55: return casadi_s0;
case 56: return casadi_s0;
case 57: return casadi_s0;
case 58: return casadi_s0;
case 59: return casadi_s0;
case 60: return casadi_s0;
case 61: return casadi_s0;
case 62: return casadi_s0;
case 63: return casadi_s0;
case 64: return casadi_s0;
case 65: return casadi_s0;
case 66: return casadi_s0;
case 67: return casadi_s0;
case 68: return casadi_s0;
case 69: return casadi_s0;
case 70: return casadi_s0;
case 71: return casadi_s0;
case 72: return casadi_s1;
case 73: return casadi_s1;
case 74: return casadi_s1;
case 75: return casadi_s1;
case 76: return casadi_s1;
case 77: return casadi_s1;
case 78: return casadi_s0;
case 79: return casadi_s0;
case 80: return casadi_s0;
case 81: return casadi_s0;
case 82: return casadi_s0;
case 83: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_placement_constant_sparsity_out(casadi_int i) {
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
case 15: return casadi_s0;
case 16: return casadi_s0;
case 17: return casadi_s0;
case 18: return casadi_s0;
case 19: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_placement_constant_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 84;
if (sz_res) *sz_res = 20;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_placement_constant_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 84*sizeof(const casadi_real*);
if (sz_res) *sz_res = 20*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* placement_tire:(eta,B3,C3)->(B3_worn,C3_worn) */
static int casadi_f8(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1;
a0=arg[1]? arg[1][0] : 0;
a1=arg[0]? arg[0][0] : 0;
a0=a0*a1;
if (res[0]!=0) res[0][0]=a0;
a0=arg[2]? arg[2][0] : 0;
a0=a0*a1;
if (res[1]!=0) res[1][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int placement_tire(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f8(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int placement_tire_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void placement_tire_release(int mem) {
}
CASADI_SYMBOL_EXPORT void placement_tire_incref(void) {
}
CASADI_SYMBOL_EXPORT void placement_tire_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int placement_tire_n_in(void) { return 3;}
CASADI_SYMBOL_EXPORT casadi_int placement_tire_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real placement_tire_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* placement_tire_name_in(casadi_int i) {
switch (i) {
case 0: return "eta";
case 1: return "B3";
case 2: return "C3";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* placement_tire_name_out(casadi_int i) {
switch (i) {
case 0: return "B3_worn";
case 1: return "C3_worn";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* placement_tire_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* placement_tire_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int placement_tire_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 3;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int placement_tire_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 3*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_placement_tire:(eta,B3,C3,out_B3_worn[1x1,0nz],out_C3_worn[1x1,0nz],fwd_eta,fwd_B3,fwd_C3)->(fwd_B3_worn,fwd_C3_worn) */
static int casadi_f9(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3;
a0=arg[0]? arg[0][0] : 0;
a1=arg[6]? arg[6][0] : 0;
a1=a0*a1;
a2=arg[1]? arg[1][0] : 0;
a3=arg[5]? arg[5][0] : 0;
a2=a2*a3;
a1=a1+a2;
if (res[0]!=0) res[0][0]=a1;
a1=arg[7]? arg[7][0] : 0;
a0=a0*a1;
a1=arg[2]? arg[2][0] : 0;
a1=a1*a3;
a0=a0+a1;
if (res[1]!=0) res[1][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_placement_tire(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f9(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_placement_tire_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_placement_tire_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_placement_tire_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_placement_tire_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_placement_tire_n_in(void) { return 8;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_placement_tire_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_placement_tire_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_placement_tire_name_in(casadi_int i) {
switch (i) {
case 0: return "eta";
case 1: return "B3";
case 2: return "C3";
case 3: return "out_B3_worn";
case 4: return "out_C3_worn";
case 5: return "fwd_eta";
case 6: return "fwd_B3";
case 7: return "fwd_C3";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_placement_tire_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_B3_worn";
case 1: return "fwd_C3_worn";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_placement_tire_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s1;
case 4: return casadi_s1;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_placement_tire_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_placement_tire_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 8;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_placement_tire_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 8*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_placement_tire:(eta,B3,C3,out_B3_worn[1x1,0nz],out_C3_worn[1x1,0nz],adj_B3_worn,adj_C3_worn)->(adj_eta,adj_B3,adj_C3) */
static int casadi_f10(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3;
a0=arg[2]? arg[2][0] : 0;
a1=arg[6]? arg[6][0] : 0;
a0=a0*a1;
a2=arg[1]? arg[1][0] : 0;
a3=arg[5]? arg[5][0] : 0;
a2=a2*a3;
a0=a0+a2;
if (res[0]!=0) res[0][0]=a0;
a0=arg[0]? arg[0][0] : 0;
a3=a0*a3;
if (res[1]!=0) res[1][0]=a3;
a0=a0*a1;
if (res[2]!=0) res[2][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_placement_tire(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f10(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_placement_tire_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_placement_tire_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_placement_tire_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_placement_tire_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_placement_tire_n_in(void) { return 7;}
CASADI_SYMBOL_EXPORT casadi_int adj1_placement_tire_n_out(void) { return 3;}
CASADI_SYMBOL_EXPORT casadi_real adj1_placement_tire_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_placement_tire_name_in(casadi_int i) {
switch (i) {
case 0: return "eta";
case 1: return "B3";
case 2: return "C3";
case 3: return "out_B3_worn";
case 4: return "out_C3_worn";
case 5: return "adj_B3_worn";
case 6: return "adj_C3_worn";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_placement_tire_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_eta";
case 1: return "adj_B3";
case 2: return "adj_C3";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_placement_tire_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s1;
case 4: return casadi_s1;
case 5: return casadi_s0;
case 6: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_placement_tire_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_placement_tire_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 7;
if (sz_res) *sz_res = 3;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_placement_tire_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 7*sizeof(const casadi_real*);
if (sz_res) *sz_res = 3*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_placement_tire:(eta,B3,C3,out_B3_worn[1x1,0nz],out_C3_worn[1x1,0nz],adj_B3_worn,adj_C3_worn,out_adj_eta[1x1,0nz],out_adj_B3[1x1,0nz],out_adj_C3[1x1,0nz],fwd_eta,fwd_B3,fwd_C3,fwd_out_B3_worn[1x1,0nz],fwd_out_C3_worn[1x1,0nz],fwd_adj_B3_worn,fwd_adj_C3_worn)->(fwd_adj_eta,fwd_adj_B3,fwd_adj_C3) */
static int casadi_f11(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5, a6;
a0=arg[6]? arg[6][0] : 0;
a1=arg[12]? arg[12][0] : 0;
a1=a0*a1;
a2=arg[2]? arg[2][0] : 0;
a3=arg[16]? arg[16][0] : 0;
a2=a2*a3;
a1=a1+a2;
a2=arg[5]? arg[5][0] : 0;
a4=arg[11]? arg[11][0] : 0;
a4=a2*a4;
a5=arg[1]? arg[1][0] : 0;
a6=arg[15]? arg[15][0] : 0;
a5=a5*a6;
a4=a4+a5;
a1=a1+a4;
if (res[0]!=0) res[0][0]=a1;
a1=arg[10]? arg[10][0] : 0;
a2=a2*a1;
a4=arg[0]? arg[0][0] : 0;
a6=a4*a6;
a2=a2+a6;
if (res[1]!=0) res[1][0]=a2;
a0=a0*a1;
a4=a4*a3;
a0=a0+a4;
if (res[2]!=0) res[2][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_placement_tire(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f11(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_placement_tire_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_placement_tire_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_placement_tire_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_placement_tire_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_placement_tire_n_in(void) { return 17;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_placement_tire_n_out(void) { return 3;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_placement_tire_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_placement_tire_name_in(casadi_int i) {
switch (i) {
case 0: return "eta";
case 1: return "B3";
case 2: return "C3";
case 3: return "out_B3_worn";
case 4: return "out_C3_worn";
case 5: return "adj_B3_worn";
case 6: return "adj_C3_worn";
case 7: return "out_adj_eta";
case 8: return "out_adj_B3";
case 9: return "out_adj_C3";
case 10: return "fwd_eta";
case 11: return "fwd_B3";
case 12: return "fwd_C3";
case 13: return "fwd_out_B3_worn";
case 14: return "fwd_out_C3_worn";
case 15: return "fwd_adj_B3_worn";
case 16: return "fwd_adj_C3_worn";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_placement_tire_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_eta";
case 1: return "fwd_adj_B3";
case 2: return "fwd_adj_C3";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_placement_tire_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s1;
case 4: return casadi_s1;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s1;
case 8: return casadi_s1;
case 9: return casadi_s1;
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_placement_tire_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_placement_tire_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 17;
if (sz_res) *sz_res = 3;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_placement_tire_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 17*sizeof(const casadi_real*);
if (sz_res) *sz_res = 3*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* placement_margins:(m,Izz,a,b,u,rho,Ap,CL_gamma,C_alpha,Ct,d,zeta)->(trace,det,trace_d,det_d,damping) */
static int casadi_f12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
a08=arg[10]? arg[10][0] : 0;
a03=2.*a08;
a03=a03-a02;
if (res[2]!=0) res[2][0]=a03;
a03=casadi_sq(a08);
a08=a08*a02;
a03=a03-a08;
a03=a03+a10;
if (res[3]!=0) res[3][0]=a03;
a03=-4.;
a03=a03*a10;
a10=arg[11]? arg[11][0] : 0;
a10=casadi_sq(a10);
a03=a03*a10;
a02=casadi_sq(a02);
a03=a03+a02;
if (res[4]!=0) res[4][0]=a03;
return 0;
}
CASADI_SYMBOL_EXPORT int placement_margins(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f12(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int placement_margins_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void placement_margins_release(int mem) {
}
CASADI_SYMBOL_EXPORT void placement_margins_incref(void) {
}
CASADI_SYMBOL_EXPORT void placement_margins_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int placement_margins_n_in(void) { return 12;}
CASADI_SYMBOL_EXPORT casadi_int placement_margins_n_out(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_real placement_margins_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* placement_margins_name_in(casadi_int i) {
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
case 10: return "d";
case 11: return "zeta";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* placement_margins_name_out(casadi_int i) {
switch (i) {
case 0: return "trace";
case 1: return "det";
case 2: return "trace_d";
case 3: return "det_d";
case 4: return "damping";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* placement_margins_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* placement_margins_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int placement_margins_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 12;
if (sz_res) *sz_res = 5;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int placement_margins_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
if (sz_res) *sz_res = 5*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_placement_margins:(m,Izz,a,b,u,rho,Ap,CL_gamma,C_alpha,Ct,d,zeta,out_trace[1x1,0nz],out_det[1x1,0nz],out_trace_d[1x1,0nz],out_det_d[1x1,0nz],out_damping[1x1,0nz],fwd_m,fwd_Izz,fwd_a,fwd_b,fwd_u,fwd_rho,fwd_Ap,fwd_CL_gamma,fwd_C_alpha,fwd_Ct,fwd_d,fwd_zeta)->(fwd_trace,fwd_det,fwd_trace_d,fwd_det_d,fwd_damping) */
static int casadi_f13(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
a09=arg[25]? arg[25][0] : 0;
a09=2.*a09;
a10=a08*a09;
a11=arg[8]? arg[8][0] : 0;
a11=2.*a11;
a12=2.*a00;
a13=arg[19]? arg[19][0] : 0;
a12=a12*a13;
a12=a12/a04;
a01=a01/a04;
a14=arg[18]? arg[18][0] : 0;
a15=a03*a14;
a16=arg[21]? arg[21][0] : 0;
a17=a02*a16;
a15=a15+a17;
a01=a01*a15;
a12=a12-a01;
a06=a07/a06;
a01=arg[17]? arg[17][0] : 0;
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
a18=arg[26]? arg[26][0] : 0;
a19=casadi_sq(a03);
a20=arg[5]? arg[5][0] : 0;
a21=arg[7]? arg[7][0] : 0;
a22=5.0000000000000000e-01;
a23=arg[23]? arg[23][0] : 0;
a23=a22*a23;
a23=a21*a23;
a24=arg[6]? arg[6][0] : 0;
a22=a22*a24;
a24=arg[24]? arg[24][0] : 0;
a24=a22*a24;
a23=a23+a24;
a23=a20*a23;
a22=a22*a21;
a21=arg[22]? arg[22][0] : 0;
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
a19=arg[20]? arg[20][0] : 0;
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
a04=a17/a04;
a05=a05*a14;
a01=a02*a01;
a05=a05+a01;
a15=a15*a05;
a03=2.*a03;
a03=a03*a16;
a23=a23*a03;
a15=a15+a23;
a04=a04*a15;
a06=a06-a04;
a09=a00*a09;
a13=a11*a13;
a09=a09+a13;
a09=a09/a02;
a00=a11*a00;
a00=a00/a02;
a13=a00/a02;
a13=a13*a14;
a09=a09-a13;
a06=a06-a09;
a18=a12*a18;
a19=a20*a19;
a18=a18+a19;
a18=a18/a02;
a12=a20*a12;
a12=a12/a02;
a02=a12/a02;
a02=a02*a14;
a18=a18-a02;
a06=a06+a18;
if (res[1]!=0) res[1][0]=a06;
a18=arg[27]? arg[27][0] : 0;
a02=2.*a18;
a02=a02-a10;
if (res[2]!=0) res[2][0]=a02;
a02=arg[10]? arg[10][0] : 0;
a14=2.*a02;
a14=a14*a18;
a11=a11*a08;
a20=a20*a07;
a11=a11+a20;
a18=a11*a18;
a02=a02*a10;
a18=a18+a02;
a14=a14-a18;
a14=a14+a06;
if (res[3]!=0) res[3][0]=a14;
a14=arg[11]? arg[11][0] : 0;
a18=casadi_sq(a14);
a02=-4.;
a06=a02*a06;
a18=a18*a06;
a17=a17-a00;
a17=a17+a12;
a02=a02*a17;
a14=2.*a14;
a17=arg[28]? arg[28][0] : 0;
a14=a14*a17;
a02=a02*a14;
a18=a18+a02;
a11=2.*a11;
a11=a11*a10;
a18=a18+a11;
if (res[4]!=0) res[4][0]=a18;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_placement_margins(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f13(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_placement_margins_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_placement_margins_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_placement_margins_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_placement_margins_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_placement_margins_n_in(void) { return 29;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_placement_margins_n_out(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_placement_margins_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_placement_margins_name_in(casadi_int i) {
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
case 10: return "d";
case 11: return "zeta";
case 12: return "out_trace";
case 13: return "out_det";
case 14: return "out_trace_d";
case 15: return "out_det_d";
case 16: return "out_damping";
case 17: return "fwd_m";
case 18: return "fwd_Izz";
case 19: return "fwd_a";
case 20: return "fwd_b";
case 21: return "fwd_u";
case 22: return "fwd_rho";
case 23: return "fwd_Ap";
case 24: return "fwd_CL_gamma";
case 25: return "fwd_C_alpha";
case 26: return "fwd_Ct";
case 27: return "fwd_d";
case 28: return "fwd_zeta";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_placement_margins_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_trace";
case 1: return "fwd_det";
case 2: return "fwd_trace_d";
case 3: return "fwd_det_d";
case 4: return "fwd_damping";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_placement_margins_sparsity_in(casadi_int i) {
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
case 28: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_placement_margins_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_placement_margins_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 29;
if (sz_res) *sz_res = 5;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_placement_margins_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 29*sizeof(const casadi_real*);
if (sz_res) *sz_res = 5*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_placement_margins:(m,Izz,a,b,u,rho,Ap,CL_gamma,C_alpha,Ct,d,zeta,out_trace[1x1,0nz],out_det[1x1,0nz],out_trace_d[1x1,0nz],out_det_d[1x1,0nz],out_damping[1x1,0nz],adj_trace,adj_det,adj_trace_d,adj_det_d,adj_damping)->(adj_m,adj_Izz,adj_a,adj_b,adj_u,adj_rho,adj_Ap,adj_CL_gamma,adj_C_alpha,adj_Ct,adj_d,adj_zeta) */
static int casadi_f14(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42;
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
a21=a17/a20;
a22=-4.;
a23=arg[11]? arg[11][0] : 0;
a24=casadi_sq(a23);
a25=arg[21]? arg[21][0] : 0;
a24=a24*a25;
a24=a22*a24;
a26=arg[20]? arg[20][0] : 0;
a24=a24+a26;
a27=arg[18]? arg[18][0] : 0;
a24=a24+a27;
a21=a21*a24;
a02=a02*a21;
a27=a00*a02;
a28=a18*a01;
a29=1./a28;
a28=a29/a28;
a30=casadi_sq(a13);
a31=a00*a01;
a30=a30/a31;
a32=a30+a29;
a33=a03*a32;
a34=casadi_sq(a14);
a34=a34/a31;
a29=a34+a29;
a35=a04*a29;
a33=a33+a35;
a35=2.*a33;
a35=a35*a25;
a36=arg[10]? arg[10][0] : 0;
a37=a36*a26;
a35=a35-a37;
a37=arg[19]? arg[19][0] : 0;
a35=a35-a37;
a38=arg[17]? arg[17][0] : 0;
a35=a35-a38;
a38=a04*a35;
a39=a03*a35;
a40=a38+a39;
a28=a28*a40;
a40=a01*a28;
a27=a27+a40;
a27=-a27;
if (res[0]!=0) res[0][0]=a27;
a27=a03*a13;
a27=a27/a00;
a40=a27/a00;
a40=a40*a24;
a41=a04*a14;
a41=a41/a00;
a42=a41/a00;
a42=a42*a24;
a40=a40-a42;
a02=a18*a02;
a40=a40-a02;
a34=a34/a31;
a34=a34*a38;
a30=a30/a31;
a30=a30*a39;
a34=a34+a30;
a30=a01*a34;
a40=a40-a30;
if (res[1]!=0) res[1][0]=a40;
a15=2.*a15;
a20=a24/a20;
a12=a12*a20;
a15=a15*a12;
a12=a24/a00;
a40=a03*a12;
a40=a15-a40;
a30=2.*a13;
a39=a39/a31;
a30=a30*a39;
a40=a40+a30;
if (res[2]!=0) res[2][0]=a40;
a24=a24/a00;
a40=a04*a24;
a40=a40+a15;
a15=2.*a14;
a38=a38/a31;
a15=a15*a38;
a40=a40+a15;
if (res[3]!=0) res[3][0]=a40;
a40=2.*a01;
a14=a14*a24;
a16=a16*a20;
a03=a03*a16;
a14=a14+a03;
a29=a29*a35;
a14=a14+a29;
a10=a10*a14;
a40=a40*a10;
a01=2.*a01;
a19=a19*a21;
a01=a01*a19;
a40=a40-a01;
a18=a18*a28;
a40=a40-a18;
a00=a00*a34;
a40=a40-a00;
if (res[4]!=0) res[4][0]=a40;
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
a32=a32*a35;
a04=a04+a32;
a04=2.*a04;
if (res[8]!=0) res[8][0]=a04;
if (res[9]!=0) res[9][0]=a14;
a36=2.*a36;
a36=a36*a26;
a33=a33*a26;
a36=a36-a33;
a37=2.*a37;
a36=a36+a37;
if (res[10]!=0) res[10][0]=a36;
a23=2.*a23;
a17=a17-a27;
a17=a17+a41;
a22=a22*a17;
a22=a22*a25;
a23=a23*a22;
if (res[11]!=0) res[11][0]=a23;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_placement_margins(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f14(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_placement_margins_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_placement_margins_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_placement_margins_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_placement_margins_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_placement_margins_n_in(void) { return 22;}
CASADI_SYMBOL_EXPORT casadi_int adj1_placement_margins_n_out(void) { return 12;}
CASADI_SYMBOL_EXPORT casadi_real adj1_placement_margins_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_placement_margins_name_in(casadi_int i) {
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
case 10: return "d";
case 11: return "zeta";
case 12: return "out_trace";
case 13: return "out_det";
case 14: return "out_trace_d";
case 15: return "out_det_d";
case 16: return "out_damping";
case 17: return "adj_trace";
case 18: return "adj_det";
case 19: return "adj_trace_d";
case 20: return "adj_det_d";
case 21: return "adj_damping";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_placement_margins_name_out(casadi_int i) {
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
case 10: return "adj_d";
case 11: return "adj_zeta";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_placement_margins_sparsity_in(casadi_int i) {
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
case 17: return casadi_s0;
case 18: return casadi_s0;
case 19: return casadi_s0;
case 20: return casadi_s0;
case 21: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_placement_margins_sparsity_out(casadi_int i) {
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
CASADI_SYMBOL_EXPORT int adj1_placement_margins_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 22;
if (sz_res) *sz_res = 12;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_placement_margins_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
if (sz_res) *sz_res = 12*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_placement_margins:(m,Izz,a,b,u,rho,Ap,CL_gamma,C_alpha,Ct,d,zeta,out_trace[1x1,0nz],out_det[1x1,0nz],out_trace_d[1x1,0nz],out_det_d[1x1,0nz],out_damping[1x1,0nz],adj_trace,adj_det,adj_trace_d,adj_det_d,adj_damping,out_adj_m[1x1,0nz],out_adj_Izz[1x1,0nz],out_adj_a[1x1,0nz],out_adj_b[1x1,0nz],out_adj_u[1x1,0nz],out_adj_rho[1x1,0nz],out_adj_Ap[1x1,0nz],out_adj_CL_gamma[1x1,0nz],out_adj_C_alpha[1x1,0nz],out_adj_Ct[1x1,0nz],out_adj_d[1x1,0nz],out_adj_zeta[1x1,0nz],fwd_m,fwd_Izz,fwd_a,fwd_b,fwd_u,fwd_rho,fwd_Ap,fwd_CL_gamma,fwd_C_alpha,fwd_Ct,fwd_d,fwd_zeta,fwd_out_trace[1x1,0nz],fwd_out_det[1x1,0nz],fwd_out_trace_d[1x1,0nz],fwd_out_det_d[1x1,0nz],fwd_out_damping[1x1,0nz],fwd_adj_trace,fwd_adj_det,fwd_adj_trace_d,fwd_adj_det_d,fwd_adj_damping)->(fwd_adj_m,fwd_adj_Izz,fwd_adj_a,fwd_adj_b,fwd_adj_u,fwd_adj_rho,fwd_adj_Ap,fwd_adj_CL_gamma,fwd_adj_C_alpha,fwd_adj_Ct,fwd_adj_d,fwd_adj_zeta) */
static int casadi_f15(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
casadi_real a72, a73, a74, a75, a76, a77, a78, a79, a80, a81, a82;
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
a23=arg[11]? arg[11][0] : 0;
a24=casadi_sq(a23);
a25=arg[21]? arg[21][0] : 0;
a26=a24*a25;
a26=a22*a26;
a27=arg[20]? arg[20][0] : 0;
a26=a26+a27;
a28=arg[18]? arg[18][0] : 0;
a26=a26+a28;
a28=a21*a26;
a29=a01*a28;
a30=arg[35]? arg[35][0] : 0;
a31=a29*a30;
a32=2.*a00;
a33=arg[38]? arg[38][0] : 0;
a32=a32*a33;
a34=a28*a32;
a35=arg[42]? arg[42][0] : 0;
a35=2.*a35;
a36=a03*a35;
a37=arg[43]? arg[43][0] : 0;
a38=arg[40]? arg[40][0] : 0;
a38=a04*a38;
a39=a06*a38;
a40=arg[41]? arg[41][0] : 0;
a41=a05*a40;
a39=a39+a41;
a41=a08*a39;
a42=arg[39]? arg[39][0] : 0;
a43=a07*a42;
a41=a41+a43;
a43=a10*a41;
a44=2.*a00;
a44=a44*a33;
a45=a09*a44;
a43=a43+a45;
a37=a37+a43;
a43=a02*a37;
a36=a36+a43;
a43=a15*a36;
a45=2.*a14;
a46=arg[36]? arg[36][0] : 0;
a47=arg[37]? arg[37][0] : 0;
a48=a46+a47;
a45=a45*a48;
a49=a11*a45;
a43=a43+a49;
a43=a43/a20;
a49=a16/a20;
a50=a18*a30;
a51=arg[34]? arg[34][0] : 0;
a52=a17*a51;
a50=a50+a52;
a52=a01*a50;
a32=a19*a32;
a52=a52+a32;
a49=a49*a52;
a43=a43-a49;
a49=a43/a20;
a32=a21/a20;
a32=a32*a52;
a49=a49-a32;
a49=a26*a49;
a32=2.*a23;
a53=arg[45]? arg[45][0] : 0;
a32=a32*a53;
a32=a25*a32;
a54=arg[55]? arg[55][0] : 0;
a24=a24*a54;
a32=a32+a24;
a32=a22*a32;
a24=arg[54]? arg[54][0] : 0;
a32=a32+a24;
a55=arg[52]? arg[52][0] : 0;
a32=a32+a55;
a21=a21*a32;
a49=a49+a21;
a01=a01*a49;
a34=a34+a01;
a01=a17*a34;
a31=a31+a01;
a01=a18*a00;
a21=1./a01;
a55=a21/a01;
a56=casadi_sq(a12);
a57=a17*a00;
a56=a56/a57;
a58=a56+a21;
a59=a02*a58;
a60=casadi_sq(a13);
a60=a60/a57;
a61=a60+a21;
a62=a03*a61;
a59=a59+a62;
a62=2.*a59;
a63=a62*a25;
a64=arg[10]? arg[10][0] : 0;
a65=a64*a27;
a63=a63-a65;
a65=arg[19]? arg[19][0] : 0;
a63=a63-a65;
a65=arg[17]? arg[17][0] : 0;
a63=a63-a65;
a65=a03*a63;
a66=a02*a63;
a67=a65+a66;
a68=a55*a67;
a69=a68*a33;
a70=a63*a37;
a71=a58*a35;
a72=2.*a12;
a72=a72*a46;
a72=a72/a57;
a73=a56/a57;
a74=a00*a30;
a75=a17*a33;
a74=a74+a75;
a73=a73*a74;
a72=a72-a73;
a21=a21/a01;
a73=a00*a51;
a75=a18*a33;
a73=a73+a75;
a21=a21*a73;
a75=a72-a21;
a76=a02*a75;
a71=a71+a76;
a76=a61*a37;
a77=2.*a13;
a77=a77*a47;
a77=a77/a57;
a78=a60/a57;
a78=a78*a74;
a77=a77-a78;
a78=a77-a21;
a79=a03*a78;
a76=a76+a79;
a71=a71+a76;
a76=2.*a71;
a76=a25*a76;
a62=a62*a54;
a76=a76+a62;
a62=arg[44]? arg[44][0] : 0;
a79=a27*a62;
a80=a64*a24;
a79=a79+a80;
a76=a76-a79;
a79=arg[53]? arg[53][0] : 0;
a76=a76-a79;
a80=arg[51]? arg[51][0] : 0;
a76=a76-a80;
a80=a03*a76;
a70=a70+a80;
a80=a63*a35;
a81=a02*a76;
a80=a80+a81;
a81=a70+a80;
a81=a55*a81;
a21=a21/a01;
a55=a55/a01;
a55=a55*a73;
a21=a21+a55;
a67=a67*a21;
a81=a81-a67;
a67=a00*a81;
a69=a69+a67;
a31=a31+a69;
a31=-a31;
if (res[0]!=0) res[0][0]=a31;
a31=a12*a35;
a69=a02*a46;
a31=a31+a69;
a31=a31/a17;
a69=a02*a12;
a69=a69/a17;
a67=a69/a17;
a67=a67*a30;
a31=a31-a67;
a67=a31/a17;
a21=a69/a17;
a55=a21/a17;
a55=a55*a30;
a67=a67-a55;
a67=a26*a67;
a21=a21*a32;
a67=a67+a21;
a21=a13*a37;
a55=a03*a47;
a21=a21+a55;
a21=a21/a17;
a55=a03*a13;
a55=a55/a17;
a73=a55/a17;
a73=a73*a30;
a21=a21-a73;
a73=a21/a17;
a01=a55/a17;
a82=a01/a17;
a82=a82*a30;
a73=a73-a82;
a73=a26*a73;
a01=a01*a32;
a73=a73+a01;
a67=a67-a73;
a29=a29*a51;
a34=a18*a34;
a29=a29+a34;
a67=a67-a29;
a60=a60/a57;
a29=a60*a65;
a56=a56/a57;
a34=a56*a66;
a29=a29+a34;
a34=a29*a33;
a77=a77/a57;
a73=a60/a57;
a73=a73*a74;
a77=a77-a73;
a77=a65*a77;
a60=a60*a70;
a77=a77+a60;
a72=a72/a57;
a60=a56/a57;
a60=a60*a74;
a72=a72-a60;
a72=a66*a72;
a56=a56*a80;
a72=a72+a56;
a77=a77+a72;
a72=a00*a77;
a34=a34+a72;
a67=a67-a34;
if (res[1]!=0) res[1][0]=a67;
a67=a26/a20;
a34=a11*a67;
a48=2.*a48;
a34=a34*a48;
a14=2.*a14;
a36=a67*a36;
a48=a32/a20;
a20=a67/a20;
a20=a20*a52;
a48=a48-a20;
a11=a11*a48;
a36=a36+a11;
a14=a14*a36;
a34=a34+a14;
a14=a26/a17;
a36=a14*a35;
a11=a32/a17;
a20=a14/a17;
a20=a20*a30;
a11=a11-a20;
a20=a02*a11;
a36=a36+a20;
a36=a34-a36;
a66=a66/a57;
a20=2.*a46;
a20=a66*a20;
a52=2.*a12;
a80=a80/a57;
a66=a66/a57;
a66=a66*a74;
a80=a80-a66;
a52=a52*a80;
a20=a20+a52;
a36=a36+a20;
if (res[2]!=0) res[2][0]=a36;
a26=a26/a17;
a36=a26*a37;
a32=a32/a17;
a20=a26/a17;
a20=a20*a30;
a32=a32-a20;
a20=a03*a32;
a36=a36+a20;
a36=a36+a34;
a65=a65/a57;
a34=2.*a47;
a34=a65*a34;
a20=2.*a13;
a70=a70/a57;
a65=a65/a57;
a65=a65*a74;
a70=a70-a65;
a20=a20*a70;
a34=a34+a20;
a36=a36+a34;
if (res[3]!=0) res[3][0]=a36;
a36=a13*a26;
a34=a15*a67;
a20=a02*a34;
a36=a36+a20;
a20=a61*a63;
a36=a36+a20;
a20=a09*a36;
a70=2.*a33;
a20=a20*a70;
a70=2.*a00;
a41=a36*a41;
a26=a26*a47;
a13=a13*a32;
a26=a26+a13;
a35=a34*a35;
a67=a67*a45;
a15=a15*a48;
a67=a67+a15;
a02=a02*a67;
a35=a35+a02;
a26=a26+a35;
a78=a63*a78;
a61=a61*a76;
a78=a78+a61;
a26=a26+a78;
a09=a09*a26;
a41=a41+a09;
a70=a70*a41;
a20=a20+a70;
a70=a19*a28;
a33=2.*a33;
a70=a70*a33;
a00=2.*a00;
a28=a28*a50;
a19=a19*a49;
a28=a28+a19;
a00=a00*a28;
a70=a70+a00;
a20=a20-a70;
a68=a68*a51;
a18=a18*a81;
a68=a68+a18;
a20=a20-a68;
a29=a29*a30;
a17=a17*a77;
a29=a29+a17;
a20=a20-a29;
if (res[4]!=0) res[4][0]=a20;
a20=a10*a36;
a39=a20*a39;
a36=a36*a44;
a10=a10*a26;
a36=a36+a10;
a07=a07*a36;
a39=a39+a07;
if (res[5]!=0) res[5][0]=a39;
a39=a08*a20;
a40=a39*a40;
a20=a20*a42;
a08=a08*a36;
a20=a20+a08;
a06=a06*a20;
a40=a40+a06;
a04=a04*a40;
if (res[6]!=0) res[6][0]=a04;
a39=a39*a38;
a05=a05*a20;
a39=a39+a05;
if (res[7]!=0) res[7][0]=a39;
a34=a34*a37;
a03=a03*a67;
a34=a34+a03;
a14=a14*a46;
a12=a12*a11;
a14=a14+a12;
a34=a34-a14;
a63=a63*a75;
a58=a58*a76;
a63=a63+a58;
a34=a34+a63;
a34=2.*a34;
if (res[8]!=0) res[8][0]=a34;
if (res[9]!=0) res[9][0]=a26;
a62=2.*a62;
a62=a27*a62;
a64=2.*a64;
a64=a64*a24;
a62=a62+a64;
a27=a27*a71;
a59=a59*a24;
a27=a27+a59;
a62=a62-a27;
a79=2.*a79;
a62=a62+a79;
if (res[10]!=0) res[10][0]=a62;
a16=a16-a69;
a16=a16+a55;
a16=a22*a16;
a55=a16*a25;
a53=2.*a53;
a55=a55*a53;
a23=2.*a23;
a43=a43-a31;
a43=a43+a21;
a22=a22*a43;
a25=a25*a22;
a16=a16*a54;
a25=a25+a16;
a23=a23*a25;
a55=a55+a23;
if (res[11]!=0) res[11][0]=a55;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_placement_margins(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f15(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_placement_margins_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_placement_margins_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_placement_margins_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_placement_margins_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_placement_margins_n_in(void) { return 56;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_placement_margins_n_out(void) { return 12;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_placement_margins_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_placement_margins_name_in(casadi_int i) {
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
case 10: return "d";
case 11: return "zeta";
case 12: return "out_trace";
case 13: return "out_det";
case 14: return "out_trace_d";
case 15: return "out_det_d";
case 16: return "out_damping";
case 17: return "adj_trace";
case 18: return "adj_det";
case 19: return "adj_trace_d";
case 20: return "adj_det_d";
case 21: return "adj_damping";
case 22: return "out_adj_m";
case 23: return "out_adj_Izz";
case 24: return "out_adj_a";
case 25: return "out_adj_b";
case 26: return "out_adj_u";
case 27: return "out_adj_rho";
case 28: return "out_adj_Ap";
case 29: return "out_adj_CL_gamma";
case 30: return "out_adj_C_alpha";
case 31: return "out_adj_Ct";
case 32: return "out_adj_d";
case 33: return "out_adj_zeta";
case 34: return "fwd_m";
case 35: return "fwd_Izz";
case 36: return "fwd_a";
case 37: return "fwd_b";
case 38: return "fwd_u";
case 39: return "fwd_rho";
case 40: return "fwd_Ap";
case 41: return "fwd_CL_gamma";
case 42: return "fwd_C_alpha";
case 43: return "fwd_Ct";
case 44: return "fwd_d";
case 45: return "fwd_zeta";
case 46: return "fwd_out_trace";
case 47: return "fwd_out_det";
case 48: return "fwd_out_trace_d";
case 49: return "fwd_out_det_d";
case 50: return "fwd_out_damping";
case 51: return "fwd_adj_trace";
case 52: return "fwd_adj_det";
case 53: return "fwd_adj_trace_d";
case 54: return "fwd_adj_det_d";
case 55: return "fwd_adj_damping";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_placement_margins_name_out(casadi_int i) {
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
case 10: return "fwd_adj_d";
case 11: return "fwd_adj_zeta";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_placement_margins_sparsity_in(casadi_int i) {
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
case 17: return casadi_s0;
case 18: return casadi_s0;
case 19: return casadi_s0;
case 20: return casadi_s0;
case 21: return casadi_s0;
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
case 32: return casadi_s1;
case 33: return casadi_s1;
case 34: return casadi_s0;
case 35: return casadi_s0;
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
case 51: return casadi_s0;
case 52: return casadi_s0;
case 53: return casadi_s0;
case 54: return casadi_s0;
case 55: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_placement_margins_sparsity_out(casadi_int i) {
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
CASADI_SYMBOL_EXPORT int fwd1_adj1_placement_margins_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 56;
if (sz_res) *sz_res = 12;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_placement_margins_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 56*sizeof(const casadi_real*);
if (sz_res) *sz_res = 12*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* placement_limits:(x_main,x_third,x_cg,h_cg)->(third_load,nose_over,tip_back,span) */
static int casadi_f16(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5;
a0=1.;
a1=arg[1]? arg[1][0] : 0;
a2=arg[2]? arg[2][0] : 0;
a3=a1-a2;
a4=arg[0]? arg[0][0] : 0;
a5=a4-a1;
a3=a3/a5;
a0=a0+a3;
if (res[0]!=0) res[0][0]=a0;
a2=a2-a4;
a0=arg[3]? arg[3][0] : 0;
a2=a2/a0;
a2=atan(a2);
if (res[1]!=0) res[1][0]=a2;
a2=-a2;
if (res[2]!=0) res[2][0]=a2;
a4=a4-a1;
a4=casadi_fabs(a4);
if (res[3]!=0) res[3][0]=a4;
return 0;
}
CASADI_SYMBOL_EXPORT int placement_limits(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f16(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int placement_limits_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void placement_limits_release(int mem) {
}
CASADI_SYMBOL_EXPORT void placement_limits_incref(void) {
}
CASADI_SYMBOL_EXPORT void placement_limits_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int placement_limits_n_in(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_int placement_limits_n_out(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_real placement_limits_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* placement_limits_name_in(casadi_int i) {
switch (i) {
case 0: return "x_main";
case 1: return "x_third";
case 2: return "x_cg";
case 3: return "h_cg";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* placement_limits_name_out(casadi_int i) {
switch (i) {
case 0: return "third_load";
case 1: return "nose_over";
case 2: return "tip_back";
case 3: return "span";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* placement_limits_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* placement_limits_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int placement_limits_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 4;
if (sz_res) *sz_res = 4;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int placement_limits_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 4*sizeof(const casadi_real*);
if (sz_res) *sz_res = 4*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_placement_limits:(x_main,x_third,x_cg,h_cg,out_third_load[1x1,0nz],out_nose_over[1x1,0nz],out_tip_back[1x1,0nz],out_span[1x1,0nz],fwd_x_main,fwd_x_third,fwd_x_cg,fwd_h_cg)->(fwd_third_load,fwd_nose_over,fwd_tip_back,fwd_span) */
static int casadi_f17(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5, a6, a7, a8;
a0=arg[9]? arg[9][0] : 0;
a1=arg[10]? arg[10][0] : 0;
a2=a0-a1;
a3=arg[0]? arg[0][0] : 0;
a4=arg[1]? arg[1][0] : 0;
a5=a3-a4;
a2=a2/a5;
a6=arg[2]? arg[2][0] : 0;
a7=a4-a6;
a7=a7/a5;
a7=a7/a5;
a5=arg[8]? arg[8][0] : 0;
a8=a5-a0;
a7=a7*a8;
a2=a2-a7;
if (res[0]!=0) res[0][0]=a2;
a1=a1-a5;
a2=arg[3]? arg[3][0] : 0;
a1=a1/a2;
a6=a6-a3;
a6=a6/a2;
a2=a6/a2;
a7=arg[11]? arg[11][0] : 0;
a2=a2*a7;
a1=a1-a2;
a2=1.;
a6=casadi_sq(a6);
a2=a2+a6;
a1=a1/a2;
if (res[1]!=0) res[1][0]=a1;
a1=-a1;
if (res[2]!=0) res[2][0]=a1;
a3=a3-a4;
a3=casadi_sign(a3);
a5=a5-a0;
a3=a3*a5;
if (res[3]!=0) res[3][0]=a3;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_placement_limits(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f17(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_placement_limits_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_placement_limits_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_placement_limits_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_placement_limits_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_placement_limits_n_in(void) { return 12;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_placement_limits_n_out(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_placement_limits_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_placement_limits_name_in(casadi_int i) {
switch (i) {
case 0: return "x_main";
case 1: return "x_third";
case 2: return "x_cg";
case 3: return "h_cg";
case 4: return "out_third_load";
case 5: return "out_nose_over";
case 6: return "out_tip_back";
case 7: return "out_span";
case 8: return "fwd_x_main";
case 9: return "fwd_x_third";
case 10: return "fwd_x_cg";
case 11: return "fwd_h_cg";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_placement_limits_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_third_load";
case 1: return "fwd_nose_over";
case 2: return "fwd_tip_back";
case 3: return "fwd_span";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_placement_limits_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s1;
case 5: return casadi_s1;
case 6: return casadi_s1;
case 7: return casadi_s1;
case 8: return casadi_s0;
case 9: return casadi_s0;
case 10: return casadi_s0;
case 11: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_placement_limits_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_placement_limits_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 12;
if (sz_res) *sz_res = 4;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_placement_limits_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
if (sz_res) *sz_res = 4*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_placement_limits:(x_main,x_third,x_cg,h_cg,out_third_load[1x1,0nz],out_nose_over[1x1,0nz],out_tip_back[1x1,0nz],out_span[1x1,0nz],adj_third_load,adj_nose_over,adj_tip_back,adj_span)->(adj_x_main,adj_x_third,adj_x_cg,adj_h_cg) */
static int casadi_f18(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5, a6, a7, a8;
a0=arg[0]? arg[0][0] : 0;
a1=arg[1]? arg[1][0] : 0;
a2=a0-a1;
a2=casadi_sign(a2);
a3=arg[11]? arg[11][0] : 0;
a2=a2*a3;
a3=arg[9]? arg[9][0] : 0;
a4=arg[10]? arg[10][0] : 0;
a3=a3-a4;
a4=1.;
a5=arg[2]? arg[2][0] : 0;
a6=a5-a0;
a7=arg[3]? arg[3][0] : 0;
a6=a6/a7;
a8=casadi_sq(a6);
a4=a4+a8;
a3=a3/a4;
a4=a3/a7;
a8=a2-a4;
a5=a1-a5;
a0=a0-a1;
a5=a5/a0;
a5=a5/a0;
a1=arg[8]? arg[8][0] : 0;
a5=a5*a1;
a8=a8-a5;
if (res[0]!=0) res[0][0]=a8;
a5=a5-a2;
a1=a1/a0;
a5=a5+a1;
if (res[1]!=0) res[1][0]=a5;
a4=a4-a1;
if (res[2]!=0) res[2][0]=a4;
a6=a6/a7;
a6=a6*a3;
a6=-a6;
if (res[3]!=0) res[3][0]=a6;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_placement_limits(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f18(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_placement_limits_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_placement_limits_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_placement_limits_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_placement_limits_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_placement_limits_n_in(void) { return 12;}
CASADI_SYMBOL_EXPORT casadi_int adj1_placement_limits_n_out(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_real adj1_placement_limits_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_placement_limits_name_in(casadi_int i) {
switch (i) {
case 0: return "x_main";
case 1: return "x_third";
case 2: return "x_cg";
case 3: return "h_cg";
case 4: return "out_third_load";
case 5: return "out_nose_over";
case 6: return "out_tip_back";
case 7: return "out_span";
case 8: return "adj_third_load";
case 9: return "adj_nose_over";
case 10: return "adj_tip_back";
case 11: return "adj_span";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_placement_limits_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_x_main";
case 1: return "adj_x_third";
case 2: return "adj_x_cg";
case 3: return "adj_h_cg";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_placement_limits_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s1;
case 5: return casadi_s1;
case 6: return casadi_s1;
case 7: return casadi_s1;
case 8: return casadi_s0;
case 9: return casadi_s0;
case 10: return casadi_s0;
case 11: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_placement_limits_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_placement_limits_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 12;
if (sz_res) *sz_res = 4;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_placement_limits_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
if (sz_res) *sz_res = 4*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_placement_limits:(x_main,x_third,x_cg,h_cg,out_third_load[1x1,0nz],out_nose_over[1x1,0nz],out_tip_back[1x1,0nz],out_span[1x1,0nz],adj_third_load,adj_nose_over,adj_tip_back,adj_span,out_adj_x_main[1x1,0nz],out_adj_x_third[1x1,0nz],out_adj_x_cg[1x1,0nz],out_adj_h_cg[1x1,0nz],fwd_x_main,fwd_x_third,fwd_x_cg,fwd_h_cg,fwd_out_third_load[1x1,0nz],fwd_out_nose_over[1x1,0nz],fwd_out_tip_back[1x1,0nz],fwd_out_span[1x1,0nz],fwd_adj_third_load,fwd_adj_nose_over,fwd_adj_tip_back,fwd_adj_span)->(fwd_adj_x_main,fwd_adj_x_third,fwd_adj_x_cg,fwd_adj_h_cg) */
static int casadi_f19(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15;
a00=arg[0]? arg[0][0] : 0;
a01=arg[1]? arg[1][0] : 0;
a02=a00-a01;
a02=casadi_sign(a02);
a03=arg[27]? arg[27][0] : 0;
a02=a02*a03;
a03=arg[25]? arg[25][0] : 0;
a04=arg[26]? arg[26][0] : 0;
a03=a03-a04;
a04=1.;
a05=arg[2]? arg[2][0] : 0;
a06=a05-a00;
a07=arg[3]? arg[3][0] : 0;
a06=a06/a07;
a08=casadi_sq(a06);
a04=a04+a08;
a03=a03/a04;
a08=arg[9]? arg[9][0] : 0;
a09=arg[10]? arg[10][0] : 0;
a08=a08-a09;
a08=a08/a04;
a04=a08/a04;
a09=2.*a06;
a10=arg[18]? arg[18][0] : 0;
a11=arg[16]? arg[16][0] : 0;
a12=a10-a11;
a12=a12/a07;
a13=a06/a07;
a14=arg[19]? arg[19][0] : 0;
a13=a13*a14;
a12=a12-a13;
a09=a09*a12;
a04=a04*a09;
a03=a03-a04;
a04=a03/a07;
a09=a08/a07;
a09=a09/a07;
a09=a09*a14;
a04=a04-a09;
a09=a02-a04;
a13=arg[8]? arg[8][0] : 0;
a15=arg[17]? arg[17][0] : 0;
a10=a15-a10;
a00=a00-a01;
a10=a10/a00;
a01=a01-a05;
a01=a01/a00;
a05=a01/a00;
a11=a11-a15;
a05=a05*a11;
a10=a10-a05;
a10=a10/a00;
a01=a01/a00;
a05=a01/a00;
a05=a05*a11;
a10=a10-a05;
a10=a13*a10;
a05=arg[24]? arg[24][0] : 0;
a01=a01*a05;
a10=a10+a01;
a09=a09-a10;
if (res[0]!=0) res[0][0]=a09;
a10=a10-a02;
a05=a05/a00;
a13=a13/a00;
a13=a13/a00;
a13=a13*a11;
a05=a05-a13;
a10=a10+a05;
if (res[1]!=0) res[1][0]=a10;
a04=a04-a05;
if (res[2]!=0) res[2][0]=a04;
a12=a12/a07;
a06=a06/a07;
a07=a06/a07;
a07=a07*a14;
a12=a12-a07;
a08=a08*a12;
a06=a06*a03;
a08=a08+a06;
a08=-a08;
if (res[3]!=0) res[3][0]=a08;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_placement_limits(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f19(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_placement_limits_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_placement_limits_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_placement_limits_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_placement_limits_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_placement_limits_n_in(void) { return 28;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_placement_limits_n_out(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_placement_limits_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_placement_limits_name_in(casadi_int i) {
switch (i) {
case 0: return "x_main";
case 1: return "x_third";
case 2: return "x_cg";
case 3: return "h_cg";
case 4: return "out_third_load";
case 5: return "out_nose_over";
case 6: return "out_tip_back";
case 7: return "out_span";
case 8: return "adj_third_load";
case 9: return "adj_nose_over";
case 10: return "adj_tip_back";
case 11: return "adj_span";
case 12: return "out_adj_x_main";
case 13: return "out_adj_x_third";
case 14: return "out_adj_x_cg";
case 15: return "out_adj_h_cg";
case 16: return "fwd_x_main";
case 17: return "fwd_x_third";
case 18: return "fwd_x_cg";
case 19: return "fwd_h_cg";
case 20: return "fwd_out_third_load";
case 21: return "fwd_out_nose_over";
case 22: return "fwd_out_tip_back";
case 23: return "fwd_out_span";
case 24: return "fwd_adj_third_load";
case 25: return "fwd_adj_nose_over";
case 26: return "fwd_adj_tip_back";
case 27: return "fwd_adj_span";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_placement_limits_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_x_main";
case 1: return "fwd_adj_x_third";
case 2: return "fwd_adj_x_cg";
case 3: return "fwd_adj_h_cg";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_placement_limits_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s1;
case 5: return casadi_s1;
case 6: return casadi_s1;
case 7: return casadi_s1;
case 8: return casadi_s0;
case 9: return casadi_s0;
case 10: return casadi_s0;
case 11: return casadi_s0;
case 12: return casadi_s1;
case 13: return casadi_s1;
case 14: return casadi_s1;
case 15: return casadi_s1;
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
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_placement_limits_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_placement_limits_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 28;
if (sz_res) *sz_res = 4;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_placement_limits_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 28*sizeof(const casadi_real*);
if (sz_res) *sz_res = 4*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
