/* Generated from derive/ (digest 0a06213221c378cc) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`. */
/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
#define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
#define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
#define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
#define CASADI_PREFIX(ID) tire_ ## ID
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
#define casadi_f5 CASADI_PREFIX(f5)
#define casadi_f6 CASADI_PREFIX(f6)
#define casadi_f7 CASADI_PREFIX(f7)
#define casadi_f8 CASADI_PREFIX(f8)
#define casadi_f9 CASADI_PREFIX(f9)
#define casadi_fmin CASADI_PREFIX(fmin)
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
casadi_real casadi_fmin(casadi_real x, casadi_real y) {
/* Pre-c99 compatibility */
#if __STDC_VERSION__ < 199901L
return x<y ? x : y;
#else
return fmin(x, y);
#endif
}
/* Configuration this file was compiled with */
CASADI_SYMBOL_EXPORT void tire_casadi_version(int* major, int* minor, int* patch) {
*major = 3;
*minor = 8;
*patch = 2;
}
CASADI_SYMBOL_EXPORT int tire_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int tire_casadi_real_size(void) { return (int) sizeof(casadi_real); }
static const casadi_int casadi_s0[3] = {1, 1, 1};
static const casadi_int casadi_s1[4] = {1, 1, 0, 0};
/* tire_force:(alpha,Fz,B3,C3,B5,C5,B1,C1,D1,E1)->(F_y,alpha_bar,F_bar,C_c,mu) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5, a6, a7, a8, a9;
a0=arg[8]? arg[8][0] : 0;
a1=arg[7]? arg[7][0] : 0;
a2=arg[6]? arg[6][0] : 0;
a3=arg[2]? arg[2][0] : 0;
a4=arg[3]? arg[3][0] : 0;
a5=arg[1]? arg[1][0] : 0;
a4=a4*a5;
a3=a3+a4;
a4=arg[0]? arg[0][0] : 0;
a4=tan(a4);
a4=a3*a4;
a6=arg[4]? arg[4][0] : 0;
a7=arg[5]? arg[5][0] : 0;
a7=a7*a5;
a6=a6+a7;
a4=a4/a6;
a7=1.;
a8=arg[9]? arg[9][0] : 0;
a7=a7-a8;
a7=a4*a7;
a9=a2*a4;
a9=atan(a9);
a8=a8*a9;
a8=a8/a2;
a7=a7+a8;
a2=a2*a7;
a2=atan(a2);
a1=a1*a2;
a1=sin(a1);
a0=a0*a1;
a5=a0*a5;
a5=a5*a6;
if (res[0]!=0) res[0][0]=a5;
if (res[1]!=0) res[1][0]=a4;
if (res[2]!=0) res[2][0]=a0;
if (res[3]!=0) res[3][0]=a3;
if (res[4]!=0) res[4][0]=a6;
return 0;
}
CASADI_SYMBOL_EXPORT int tire_force(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f0(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int tire_force_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void tire_force_release(int mem) {
}
CASADI_SYMBOL_EXPORT void tire_force_incref(void) {
}
CASADI_SYMBOL_EXPORT void tire_force_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int tire_force_n_in(void) { return 10;}
CASADI_SYMBOL_EXPORT casadi_int tire_force_n_out(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_real tire_force_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* tire_force_name_in(casadi_int i) {
switch (i) {
case 0: return "alpha";
case 1: return "Fz";
case 2: return "B3";
case 3: return "C3";
case 4: return "B5";
case 5: return "C5";
case 6: return "B1";
case 7: return "C1";
case 8: return "D1";
case 9: return "E1";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* tire_force_name_out(casadi_int i) {
switch (i) {
case 0: return "F_y";
case 1: return "alpha_bar";
case 2: return "F_bar";
case 3: return "C_c";
case 4: return "mu";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* tire_force_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* tire_force_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int tire_force_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 10;
if (sz_res) *sz_res = 5;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int tire_force_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
if (sz_res) *sz_res = 5*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_tire_force:(alpha,Fz,B3,C3,B5,C5,B1,C1,D1,E1,out_F_y[1x1,0nz],out_alpha_bar[1x1,0nz],out_F_bar[1x1,0nz],out_C_c[1x1,0nz],out_mu[1x1,0nz],fwd_alpha,fwd_Fz,fwd_B3,fwd_C3,fwd_B5,fwd_C5,fwd_B1,fwd_C1,fwd_D1,fwd_E1)->(fwd_F_y,fwd_alpha_bar,fwd_F_bar,fwd_C_c,fwd_mu) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26;
a00=arg[4]? arg[4][0] : 0;
a01=arg[5]? arg[5][0] : 0;
a02=arg[1]? arg[1][0] : 0;
a03=a01*a02;
a00=a00+a03;
a03=arg[7]? arg[7][0] : 0;
a04=arg[6]? arg[6][0] : 0;
a05=arg[2]? arg[2][0] : 0;
a06=arg[3]? arg[3][0] : 0;
a07=a06*a02;
a05=a05+a07;
a07=arg[0]? arg[0][0] : 0;
a08=tan(a07);
a09=a05*a08;
a09=a09/a00;
a10=1.;
a11=arg[9]? arg[9][0] : 0;
a12=a10-a11;
a13=a09*a12;
a14=a04*a09;
a15=atan(a14);
a16=a11*a15;
a16=a16/a04;
a13=a13+a16;
a17=a04*a13;
a18=atan(a17);
a19=a03*a18;
a20=sin(a19);
a21=arg[23]? arg[23][0] : 0;
a21=a20*a21;
a22=arg[8]? arg[8][0] : 0;
a19=cos(a19);
a23=arg[22]? arg[22][0] : 0;
a18=a18*a23;
a23=arg[21]? arg[21][0] : 0;
a13=a13*a23;
a24=arg[17]? arg[17][0] : 0;
a25=arg[18]? arg[18][0] : 0;
a25=a02*a25;
a26=arg[16]? arg[16][0] : 0;
a06=a06*a26;
a25=a25+a06;
a24=a24+a25;
a08=a08*a24;
a25=arg[15]? arg[15][0] : 0;
a07=cos(a07);
a07=casadi_sq(a07);
a25=a25/a07;
a05=a05*a25;
a08=a08+a05;
a08=a08/a00;
a05=a09/a00;
a25=arg[19]? arg[19][0] : 0;
a07=arg[20]? arg[20][0] : 0;
a07=a02*a07;
a01=a01*a26;
a07=a07+a01;
a25=a25+a07;
a05=a05*a25;
a08=a08-a05;
a12=a12*a08;
a05=arg[24]? arg[24][0] : 0;
a07=a09*a05;
a12=a12-a07;
a15=a15*a05;
a09=a09*a23;
a05=a04*a08;
a09=a09+a05;
a14=casadi_sq(a14);
a14=a10+a14;
a09=a09/a14;
a11=a11*a09;
a15=a15+a11;
a15=a15/a04;
a16=a16/a04;
a16=a16*a23;
a15=a15-a16;
a12=a12+a15;
a04=a04*a12;
a13=a13+a04;
a17=casadi_sq(a17);
a10=a10+a17;
a13=a13/a10;
a03=a03*a13;
a18=a18+a03;
a19=a19*a18;
a19=a22*a19;
a21=a21+a19;
a19=a02*a21;
a22=a22*a20;
a26=a22*a26;
a19=a19+a26;
a00=a00*a19;
a22=a22*a02;
a22=a22*a25;
a00=a00+a22;
if (res[0]!=0) res[0][0]=a00;
if (res[1]!=0) res[1][0]=a08;
if (res[2]!=0) res[2][0]=a21;
if (res[3]!=0) res[3][0]=a24;
if (res[4]!=0) res[4][0]=a25;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_tire_force(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f1(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_tire_force_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_tire_force_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_tire_force_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_tire_force_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_tire_force_n_in(void) { return 25;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_tire_force_n_out(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_tire_force_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_tire_force_name_in(casadi_int i) {
switch (i) {
case 0: return "alpha";
case 1: return "Fz";
case 2: return "B3";
case 3: return "C3";
case 4: return "B5";
case 5: return "C5";
case 6: return "B1";
case 7: return "C1";
case 8: return "D1";
case 9: return "E1";
case 10: return "out_F_y";
case 11: return "out_alpha_bar";
case 12: return "out_F_bar";
case 13: return "out_C_c";
case 14: return "out_mu";
case 15: return "fwd_alpha";
case 16: return "fwd_Fz";
case 17: return "fwd_B3";
case 18: return "fwd_C3";
case 19: return "fwd_B5";
case 20: return "fwd_C5";
case 21: return "fwd_B1";
case 22: return "fwd_C1";
case 23: return "fwd_D1";
case 24: return "fwd_E1";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_tire_force_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_F_y";
case 1: return "fwd_alpha_bar";
case 2: return "fwd_F_bar";
case 3: return "fwd_C_c";
case 4: return "fwd_mu";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_tire_force_sparsity_in(casadi_int i) {
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
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_tire_force_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_tire_force_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 25;
if (sz_res) *sz_res = 5;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_tire_force_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 25*sizeof(const casadi_real*);
if (sz_res) *sz_res = 5*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_tire_force:(alpha,Fz,B3,C3,B5,C5,B1,C1,D1,E1,out_F_y[1x1,0nz],out_alpha_bar[1x1,0nz],out_F_bar[1x1,0nz],out_C_c[1x1,0nz],out_mu[1x1,0nz],adj_F_y,adj_alpha_bar,adj_F_bar,adj_C_c,adj_mu)->(adj_alpha,adj_Fz,adj_B3,adj_C3,adj_B5,adj_C5,adj_B1,adj_C1,adj_D1,adj_E1) */
static int casadi_f2(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26;
a00=arg[2]? arg[2][0] : 0;
a01=arg[3]? arg[3][0] : 0;
a02=arg[1]? arg[1][0] : 0;
a03=a01*a02;
a00=a00+a03;
a03=arg[16]? arg[16][0] : 0;
a04=arg[6]? arg[6][0] : 0;
a05=arg[9]? arg[9][0] : 0;
a06=arg[7]? arg[7][0] : 0;
a07=arg[0]? arg[0][0] : 0;
a08=tan(a07);
a09=a00*a08;
a10=arg[4]? arg[4][0] : 0;
a11=arg[5]? arg[5][0] : 0;
a12=a11*a02;
a10=a10+a12;
a09=a09/a10;
a12=1.;
a13=a12-a05;
a14=a09*a13;
a15=a04*a09;
a16=atan(a15);
a17=a05*a16;
a17=a17/a04;
a14=a14+a17;
a18=a04*a14;
a19=atan(a18);
a20=a06*a19;
a21=cos(a20);
a22=arg[8]? arg[8][0] : 0;
a23=arg[17]? arg[17][0] : 0;
a24=arg[15]? arg[15][0] : 0;
a25=a10*a24;
a26=a02*a25;
a23=a23+a26;
a26=a22*a23;
a21=a21*a26;
a06=a06*a21;
a18=casadi_sq(a18);
a18=a12+a18;
a06=a06/a18;
a05=a05*a06;
a15=casadi_sq(a15);
a12=a12+a15;
a05=a05/a12;
a12=a04*a05;
a03=a03+a12;
a12=a04*a06;
a13=a13*a12;
a03=a03+a13;
a13=a03/a10;
a00=a00*a13;
a07=cos(a07);
a07=casadi_sq(a07);
a00=a00/a07;
if (res[0]!=0) res[0][0]=a00;
a20=sin(a20);
a22=a22*a20;
a25=a22*a25;
a00=arg[19]? arg[19][0] : 0;
a22=a22*a02;
a22=a22*a24;
a00=a00+a22;
a10=a09/a10;
a10=a10*a03;
a00=a00-a10;
a11=a11*a00;
a25=a25+a11;
a11=arg[18]? arg[18][0] : 0;
a08=a08*a13;
a11=a11+a08;
a01=a01*a11;
a25=a25+a01;
if (res[1]!=0) res[1][0]=a25;
if (res[2]!=0) res[2][0]=a11;
a11=a02*a11;
if (res[3]!=0) res[3][0]=a11;
if (res[4]!=0) res[4][0]=a00;
a02=a02*a00;
if (res[5]!=0) res[5][0]=a02;
a14=a14*a06;
a17=a17/a04;
a17=a17*a12;
a14=a14-a17;
a05=a09*a05;
a14=a14+a05;
if (res[6]!=0) res[6][0]=a14;
a19=a19*a21;
if (res[7]!=0) res[7][0]=a19;
a20=a20*a23;
if (res[8]!=0) res[8][0]=a20;
a16=a16*a06;
a09=a09*a12;
a16=a16-a09;
if (res[9]!=0) res[9][0]=a16;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_tire_force(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f2(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_tire_force_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_tire_force_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_tire_force_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_tire_force_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_tire_force_n_in(void) { return 20;}
CASADI_SYMBOL_EXPORT casadi_int adj1_tire_force_n_out(void) { return 10;}
CASADI_SYMBOL_EXPORT casadi_real adj1_tire_force_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_tire_force_name_in(casadi_int i) {
switch (i) {
case 0: return "alpha";
case 1: return "Fz";
case 2: return "B3";
case 3: return "C3";
case 4: return "B5";
case 5: return "C5";
case 6: return "B1";
case 7: return "C1";
case 8: return "D1";
case 9: return "E1";
case 10: return "out_F_y";
case 11: return "out_alpha_bar";
case 12: return "out_F_bar";
case 13: return "out_C_c";
case 14: return "out_mu";
case 15: return "adj_F_y";
case 16: return "adj_alpha_bar";
case 17: return "adj_F_bar";
case 18: return "adj_C_c";
case 19: return "adj_mu";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_tire_force_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_alpha";
case 1: return "adj_Fz";
case 2: return "adj_B3";
case 3: return "adj_C3";
case 4: return "adj_B5";
case 5: return "adj_C5";
case 6: return "adj_B1";
case 7: return "adj_C1";
case 8: return "adj_D1";
case 9: return "adj_E1";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_tire_force_sparsity_in(casadi_int i) {
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
case 15: return casadi_s0;
case 16: return casadi_s0;
case 17: return casadi_s0;
case 18: return casadi_s0;
case 19: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_tire_force_sparsity_out(casadi_int i) {
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
CASADI_SYMBOL_EXPORT int adj1_tire_force_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 20;
if (sz_res) *sz_res = 10;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_tire_force_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
if (sz_res) *sz_res = 10*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_tire_force:(alpha,Fz,B3,C3,B5,C5,B1,C1,D1,E1,out_F_y[1x1,0nz],out_alpha_bar[1x1,0nz],out_F_bar[1x1,0nz],out_C_c[1x1,0nz],out_mu[1x1,0nz],adj_F_y,adj_alpha_bar,adj_F_bar,adj_C_c,adj_mu,out_adj_alpha[1x1,0nz],out_adj_Fz[1x1,0nz],out_adj_B3[1x1,0nz],out_adj_C3[1x1,0nz],out_adj_B5[1x1,0nz],out_adj_C5[1x1,0nz],out_adj_B1[1x1,0nz],out_adj_C1[1x1,0nz],out_adj_D1[1x1,0nz],out_adj_E1[1x1,0nz],fwd_alpha,fwd_Fz,fwd_B3,fwd_C3,fwd_B5,fwd_C5,fwd_B1,fwd_C1,fwd_D1,fwd_E1,fwd_out_F_y[1x1,0nz],fwd_out_alpha_bar[1x1,0nz],fwd_out_F_bar[1x1,0nz],fwd_out_C_c[1x1,0nz],fwd_out_mu[1x1,0nz],fwd_adj_F_y,fwd_adj_alpha_bar,fwd_adj_F_bar,fwd_adj_C_c,fwd_adj_mu)->(fwd_adj_alpha,fwd_adj_Fz,fwd_adj_B3,fwd_adj_C3,fwd_adj_B5,fwd_adj_C5,fwd_adj_B1,fwd_adj_C1,fwd_adj_D1,fwd_adj_E1) */
static int casadi_f3(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
a00=arg[16]? arg[16][0] : 0;
a01=arg[6]? arg[6][0] : 0;
a02=arg[9]? arg[9][0] : 0;
a03=arg[7]? arg[7][0] : 0;
a04=arg[2]? arg[2][0] : 0;
a05=arg[3]? arg[3][0] : 0;
a06=arg[1]? arg[1][0] : 0;
a07=a05*a06;
a04=a04+a07;
a07=arg[0]? arg[0][0] : 0;
a08=tan(a07);
a09=a04*a08;
a10=arg[4]? arg[4][0] : 0;
a11=arg[5]? arg[5][0] : 0;
a12=a11*a06;
a10=a10+a12;
a09=a09/a10;
a12=1.;
a13=a12-a02;
a14=a09*a13;
a15=a01*a09;
a16=atan(a15);
a17=a02*a16;
a17=a17/a01;
a14=a14+a17;
a18=a01*a14;
a19=atan(a18);
a20=a03*a19;
a21=cos(a20);
a22=arg[8]? arg[8][0] : 0;
a23=arg[17]? arg[17][0] : 0;
a24=arg[15]? arg[15][0] : 0;
a25=a10*a24;
a26=a06*a25;
a23=a23+a26;
a26=a22*a23;
a27=a21*a26;
a28=a03*a27;
a29=casadi_sq(a18);
a29=a12+a29;
a28=a28/a29;
a30=a02*a28;
a31=casadi_sq(a15);
a31=a12+a31;
a30=a30/a31;
a32=a01*a30;
a00=a00+a32;
a32=a01*a28;
a33=a13*a32;
a00=a00+a33;
a33=a00/a10;
a34=arg[32]? arg[32][0] : 0;
a35=arg[33]? arg[33][0] : 0;
a36=a06*a35;
a37=arg[31]? arg[31][0] : 0;
a38=a05*a37;
a36=a36+a38;
a34=a34+a36;
a36=a33*a34;
a38=arg[46]? arg[46][0] : 0;
a39=arg[36]? arg[36][0] : 0;
a40=a30*a39;
a41=arg[39]? arg[39][0] : 0;
a42=a28*a41;
a43=arg[37]? arg[37][0] : 0;
a44=a27*a43;
a45=arg[38]? arg[38][0] : 0;
a46=a23*a45;
a47=arg[47]? arg[47][0] : 0;
a48=a25*a37;
a49=arg[34]? arg[34][0] : 0;
a50=arg[35]? arg[35][0] : 0;
a51=a06*a50;
a52=a11*a37;
a51=a51+a52;
a49=a49+a51;
a51=a24*a49;
a52=arg[45]? arg[45][0] : 0;
a53=a10*a52;
a51=a51+a53;
a53=a06*a51;
a48=a48+a53;
a47=a47+a48;
a48=a22*a47;
a46=a46+a48;
a21=a21*a46;
a46=sin(a20);
a43=a19*a43;
a48=a14*a39;
a34=a08*a34;
a53=arg[30]? arg[30][0] : 0;
a54=cos(a07);
a54=casadi_sq(a54);
a54=a53/a54;
a55=a04*a54;
a34=a34+a55;
a34=a34/a10;
a55=a09/a10;
a55=a55*a49;
a34=a34-a55;
a55=a13*a34;
a56=a09*a41;
a55=a55-a56;
a56=a16*a41;
a57=a09*a39;
a58=a01*a34;
a57=a57+a58;
a58=casadi_sq(a15);
a58=a12+a58;
a58=a57/a58;
a59=a02*a58;
a56=a56+a59;
a56=a56/a01;
a59=a17/a01;
a59=a59*a39;
a56=a56-a59;
a55=a55+a56;
a59=a01*a55;
a48=a48+a59;
a59=casadi_sq(a18);
a12=a12+a59;
a12=a48/a12;
a59=a03*a12;
a43=a43+a59;
a46=a46*a43;
a26=a26*a46;
a21=a21-a26;
a03=a03*a21;
a44=a44+a03;
a44=a44/a29;
a29=a28/a29;
a18=2.*a18;
a18=a18*a48;
a29=a29*a18;
a44=a44-a29;
a02=a02*a44;
a42=a42+a02;
a42=a42/a31;
a31=a30/a31;
a15=2.*a15;
a15=a15*a57;
a31=a31*a15;
a42=a42-a31;
a31=a01*a42;
a40=a40+a31;
a38=a38+a40;
a40=a28*a39;
a31=a01*a44;
a40=a40+a31;
a13=a13*a40;
a41=a32*a41;
a13=a13-a41;
a38=a38+a13;
a13=a38/a10;
a41=a33/a10;
a41=a41*a49;
a13=a13-a41;
a41=a04*a13;
a36=a36+a41;
a41=cos(a07);
a31=casadi_sq(a41);
a36=a36/a31;
a04=a04*a33;
a04=a04/a31;
a04=a04/a31;
a41=2.*a41;
a07=sin(a07);
a07=a07*a53;
a41=a41*a07;
a04=a04*a41;
a36=a36+a04;
if (res[0]!=0) res[0][0]=a36;
a36=sin(a20);
a45=a36*a45;
a20=cos(a20);
a20=a20*a43;
a43=a22*a20;
a45=a45+a43;
a25=a25*a45;
a22=a22*a36;
a51=a22*a51;
a25=a25+a51;
a51=arg[19]? arg[19][0] : 0;
a43=a22*a06;
a04=a43*a24;
a51=a51+a04;
a04=a09/a10;
a41=a04*a00;
a51=a51-a41;
a50=a51*a50;
a41=arg[49]? arg[49][0] : 0;
a45=a06*a45;
a22=a22*a37;
a45=a45+a22;
a24=a24*a45;
a43=a43*a52;
a24=a24+a43;
a41=a41+a24;
a24=a34/a10;
a10=a04/a10;
a10=a10*a49;
a24=a24-a10;
a00=a00*a24;
a04=a04*a38;
a00=a00+a04;
a41=a41-a00;
a11=a11*a41;
a50=a50+a11;
a25=a25+a50;
a50=arg[18]? arg[18][0] : 0;
a11=a08*a33;
a50=a50+a11;
a35=a50*a35;
a11=arg[48]? arg[48][0] : 0;
a33=a33*a54;
a08=a08*a13;
a33=a33+a08;
a11=a11+a33;
a05=a05*a11;
a35=a35+a05;
a25=a25+a35;
if (res[1]!=0) res[1][0]=a25;
if (res[2]!=0) res[2][0]=a11;
a50=a50*a37;
a11=a06*a11;
a50=a50+a11;
if (res[3]!=0) res[3][0]=a50;
if (res[4]!=0) res[4][0]=a41;
a51=a51*a37;
a06=a06*a41;
a51=a51+a06;
if (res[5]!=0) res[5][0]=a51;
a55=a28*a55;
a14=a14*a44;
a55=a55+a14;
a56=a56/a01;
a17=a17/a01;
a01=a17/a01;
a01=a01*a39;
a56=a56-a01;
a56=a32*a56;
a17=a17*a40;
a56=a56+a17;
a55=a55-a56;
a30=a30*a34;
a42=a09*a42;
a30=a30+a42;
a55=a55+a30;
if (res[6]!=0) res[6][0]=a55;
a27=a27*a12;
a19=a19*a21;
a27=a27+a19;
if (res[7]!=0) res[7][0]=a27;
a23=a23*a20;
a36=a36*a47;
a23=a23+a36;
if (res[8]!=0) res[8][0]=a23;
a28=a28*a58;
a16=a16*a44;
a28=a28+a16;
a32=a32*a34;
a09=a09*a40;
a32=a32+a09;
a28=a28-a32;
if (res[9]!=0) res[9][0]=a28;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_tire_force(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f3(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_tire_force_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_tire_force_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_tire_force_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_tire_force_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_tire_force_n_in(void) { return 50;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_tire_force_n_out(void) { return 10;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_tire_force_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_tire_force_name_in(casadi_int i) {
switch (i) {
case 0: return "alpha";
case 1: return "Fz";
case 2: return "B3";
case 3: return "C3";
case 4: return "B5";
case 5: return "C5";
case 6: return "B1";
case 7: return "C1";
case 8: return "D1";
case 9: return "E1";
case 10: return "out_F_y";
case 11: return "out_alpha_bar";
case 12: return "out_F_bar";
case 13: return "out_C_c";
case 14: return "out_mu";
case 15: return "adj_F_y";
case 16: return "adj_alpha_bar";
case 17: return "adj_F_bar";
case 18: return "adj_C_c";
case 19: return "adj_mu";
case 20: return "out_adj_alpha";
case 21: return "out_adj_Fz";
case 22: return "out_adj_B3";
case 23: return "out_adj_C3";
case 24: return "out_adj_B5";
case 25: return "out_adj_C5";
case 26: return "out_adj_B1";
case 27: return "out_adj_C1";
case 28: return "out_adj_D1";
case 29: return "out_adj_E1";
case 30: return "fwd_alpha";
case 31: return "fwd_Fz";
case 32: return "fwd_B3";
case 33: return "fwd_C3";
case 34: return "fwd_B5";
case 35: return "fwd_C5";
case 36: return "fwd_B1";
case 37: return "fwd_C1";
case 38: return "fwd_D1";
case 39: return "fwd_E1";
case 40: return "fwd_out_F_y";
case 41: return "fwd_out_alpha_bar";
case 42: return "fwd_out_F_bar";
case 43: return "fwd_out_C_c";
case 44: return "fwd_out_mu";
case 45: return "fwd_adj_F_y";
case 46: return "fwd_adj_alpha_bar";
case 47: return "fwd_adj_F_bar";
case 48: return "fwd_adj_C_c";
case 49: return "fwd_adj_mu";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_tire_force_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_alpha";
case 1: return "fwd_adj_Fz";
case 2: return "fwd_adj_B3";
case 3: return "fwd_adj_C3";
case 4: return "fwd_adj_B5";
case 5: return "fwd_adj_C5";
case 6: return "fwd_adj_B1";
case 7: return "fwd_adj_C1";
case 8: return "fwd_adj_D1";
case 9: return "fwd_adj_E1";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_tire_force_sparsity_in(casadi_int i) {
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
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_tire_force_sparsity_out(casadi_int i) {
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
CASADI_SYMBOL_EXPORT int fwd1_adj1_tire_force_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 50;
if (sz_res) *sz_res = 10;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_tire_force_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 50*sizeof(const casadi_real*);
if (sz_res) *sz_res = 10*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* tire_slope:(Fz,B3,C3,B1,C1,D1)->(F_slope) */
static int casadi_f4(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3;
a0=arg[3]? arg[3][0] : 0;
a1=arg[4]? arg[4][0] : 0;
a0=a0*a1;
a1=arg[1]? arg[1][0] : 0;
a2=arg[2]? arg[2][0] : 0;
a3=arg[0]? arg[0][0] : 0;
a2=a2*a3;
a1=a1+a2;
a0=a0*a1;
a1=arg[5]? arg[5][0] : 0;
a0=a0*a1;
a0=a0*a3;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int tire_slope(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f4(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int tire_slope_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void tire_slope_release(int mem) {
}
CASADI_SYMBOL_EXPORT void tire_slope_incref(void) {
}
CASADI_SYMBOL_EXPORT void tire_slope_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int tire_slope_n_in(void) { return 6;}
CASADI_SYMBOL_EXPORT casadi_int tire_slope_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real tire_slope_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* tire_slope_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz";
case 1: return "B3";
case 2: return "C3";
case 3: return "B1";
case 4: return "C1";
case 5: return "D1";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* tire_slope_name_out(casadi_int i) {
switch (i) {
case 0: return "F_slope";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* tire_slope_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* tire_slope_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int tire_slope_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 6;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int tire_slope_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 6*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_tire_slope:(Fz,B3,C3,B1,C1,D1,out_F_slope[1x1,0nz],fwd_Fz,fwd_B3,fwd_C3,fwd_B1,fwd_C1,fwd_D1)->(fwd_F_slope) */
static int casadi_f5(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5, a6, a7, a8;
a0=arg[0]? arg[0][0] : 0;
a1=arg[5]? arg[5][0] : 0;
a2=arg[1]? arg[1][0] : 0;
a3=arg[2]? arg[2][0] : 0;
a4=a3*a0;
a2=a2+a4;
a4=arg[4]? arg[4][0] : 0;
a5=arg[10]? arg[10][0] : 0;
a5=a4*a5;
a6=arg[3]? arg[3][0] : 0;
a7=arg[11]? arg[11][0] : 0;
a7=a6*a7;
a5=a5+a7;
a5=a2*a5;
a6=a6*a4;
a4=arg[8]? arg[8][0] : 0;
a7=arg[9]? arg[9][0] : 0;
a7=a0*a7;
a8=arg[7]? arg[7][0] : 0;
a3=a3*a8;
a7=a7+a3;
a4=a4+a7;
a4=a6*a4;
a5=a5+a4;
a5=a1*a5;
a6=a6*a2;
a2=arg[12]? arg[12][0] : 0;
a2=a6*a2;
a5=a5+a2;
a0=a0*a5;
a6=a6*a1;
a6=a6*a8;
a0=a0+a6;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_tire_slope(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f5(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_tire_slope_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_tire_slope_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_tire_slope_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_tire_slope_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_tire_slope_n_in(void) { return 13;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_tire_slope_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_tire_slope_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_tire_slope_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz";
case 1: return "B3";
case 2: return "C3";
case 3: return "B1";
case 4: return "C1";
case 5: return "D1";
case 6: return "out_F_slope";
case 7: return "fwd_Fz";
case 8: return "fwd_B3";
case 9: return "fwd_C3";
case 10: return "fwd_B1";
case 11: return "fwd_C1";
case 12: return "fwd_D1";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_tire_slope_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_F_slope";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_tire_slope_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s1;
case 7: return casadi_s0;
case 8: return casadi_s0;
case 9: return casadi_s0;
case 10: return casadi_s0;
case 11: return casadi_s0;
case 12: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_tire_slope_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_tire_slope_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 13;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_tire_slope_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 13*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_tire_slope:(Fz,B3,C3,B1,C1,D1,out_F_slope[1x1,0nz],adj_F_slope)->(adj_Fz,adj_B3,adj_C3,adj_B1,adj_C1,adj_D1) */
static int casadi_f6(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5, a6, a7, a8, a9;
a0=arg[3]? arg[3][0] : 0;
a1=arg[4]? arg[4][0] : 0;
a2=a0*a1;
a3=arg[1]? arg[1][0] : 0;
a4=arg[2]? arg[2][0] : 0;
a5=arg[0]? arg[0][0] : 0;
a6=a4*a5;
a3=a3+a6;
a6=a2*a3;
a7=arg[5]? arg[5][0] : 0;
a8=a6*a7;
a9=arg[7]? arg[7][0] : 0;
a8=a8*a9;
a9=a5*a9;
a7=a7*a9;
a2=a2*a7;
a4=a4*a2;
a8=a8+a4;
if (res[0]!=0) res[0][0]=a8;
if (res[1]!=0) res[1][0]=a2;
a5=a5*a2;
if (res[2]!=0) res[2][0]=a5;
a3=a3*a7;
a1=a1*a3;
if (res[3]!=0) res[3][0]=a1;
a0=a0*a3;
if (res[4]!=0) res[4][0]=a0;
a6=a6*a9;
if (res[5]!=0) res[5][0]=a6;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_tire_slope(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f6(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_tire_slope_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_tire_slope_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_tire_slope_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_tire_slope_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_tire_slope_n_in(void) { return 8;}
CASADI_SYMBOL_EXPORT casadi_int adj1_tire_slope_n_out(void) { return 6;}
CASADI_SYMBOL_EXPORT casadi_real adj1_tire_slope_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_tire_slope_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz";
case 1: return "B3";
case 2: return "C3";
case 3: return "B1";
case 4: return "C1";
case 5: return "D1";
case 6: return "out_F_slope";
case 7: return "adj_F_slope";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_tire_slope_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_Fz";
case 1: return "adj_B3";
case 2: return "adj_C3";
case 3: return "adj_B1";
case 4: return "adj_C1";
case 5: return "adj_D1";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_tire_slope_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s1;
case 7: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_tire_slope_sparsity_out(casadi_int i) {
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
CASADI_SYMBOL_EXPORT int adj1_tire_slope_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 8;
if (sz_res) *sz_res = 6;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_tire_slope_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 8*sizeof(const casadi_real*);
if (sz_res) *sz_res = 6*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_tire_slope:(Fz,B3,C3,B1,C1,D1,out_F_slope[1x1,0nz],adj_F_slope,out_adj_Fz[1x1,0nz],out_adj_B3[1x1,0nz],out_adj_C3[1x1,0nz],out_adj_B1[1x1,0nz],out_adj_C1[1x1,0nz],out_adj_D1[1x1,0nz],fwd_Fz,fwd_B3,fwd_C3,fwd_B1,fwd_C1,fwd_D1,fwd_out_F_slope[1x1,0nz],fwd_adj_F_slope)->(fwd_adj_Fz,fwd_adj_B3,fwd_adj_C3,fwd_adj_B1,fwd_adj_C1,fwd_adj_D1) */
static int casadi_f7(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21;
a00=arg[7]? arg[7][0] : 0;
a01=arg[5]? arg[5][0] : 0;
a02=arg[1]? arg[1][0] : 0;
a03=arg[2]? arg[2][0] : 0;
a04=arg[0]? arg[0][0] : 0;
a05=a03*a04;
a02=a02+a05;
a05=arg[4]? arg[4][0] : 0;
a06=arg[17]? arg[17][0] : 0;
a07=a05*a06;
a08=arg[3]? arg[3][0] : 0;
a09=arg[18]? arg[18][0] : 0;
a10=a08*a09;
a07=a07+a10;
a10=a02*a07;
a11=a08*a05;
a12=arg[15]? arg[15][0] : 0;
a13=arg[16]? arg[16][0] : 0;
a14=a04*a13;
a15=arg[14]? arg[14][0] : 0;
a16=a03*a15;
a14=a14+a16;
a12=a12+a14;
a14=a11*a12;
a10=a10+a14;
a14=a01*a10;
a16=a11*a02;
a17=arg[19]? arg[19][0] : 0;
a18=a16*a17;
a14=a14+a18;
a14=a00*a14;
a18=a16*a01;
a19=arg[21]? arg[21][0] : 0;
a18=a18*a19;
a14=a14+a18;
a18=a04*a00;
a20=a01*a18;
a21=a11*a20;
a13=a21*a13;
a07=a20*a07;
a17=a18*a17;
a00=a00*a15;
a19=a04*a19;
a00=a00+a19;
a01=a01*a00;
a17=a17+a01;
a11=a11*a17;
a07=a07+a11;
a03=a03*a07;
a13=a13+a03;
a14=a14+a13;
if (res[0]!=0) res[0][0]=a14;
if (res[1]!=0) res[1][0]=a07;
a21=a21*a15;
a04=a04*a07;
a21=a21+a04;
if (res[2]!=0) res[2][0]=a21;
a21=a02*a20;
a09=a21*a09;
a20=a20*a12;
a02=a02*a17;
a20=a20+a02;
a05=a05*a20;
a09=a09+a05;
if (res[3]!=0) res[3][0]=a09;
a21=a21*a06;
a08=a08*a20;
a21=a21+a08;
if (res[4]!=0) res[4][0]=a21;
a18=a18*a10;
a16=a16*a00;
a18=a18+a16;
if (res[5]!=0) res[5][0]=a18;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_tire_slope(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f7(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_tire_slope_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_tire_slope_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_tire_slope_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_tire_slope_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_tire_slope_n_in(void) { return 22;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_tire_slope_n_out(void) { return 6;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_tire_slope_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_tire_slope_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz";
case 1: return "B3";
case 2: return "C3";
case 3: return "B1";
case 4: return "C1";
case 5: return "D1";
case 6: return "out_F_slope";
case 7: return "adj_F_slope";
case 8: return "out_adj_Fz";
case 9: return "out_adj_B3";
case 10: return "out_adj_C3";
case 11: return "out_adj_B1";
case 12: return "out_adj_C1";
case 13: return "out_adj_D1";
case 14: return "fwd_Fz";
case 15: return "fwd_B3";
case 16: return "fwd_C3";
case 17: return "fwd_B1";
case 18: return "fwd_C1";
case 19: return "fwd_D1";
case 20: return "fwd_out_F_slope";
case 21: return "fwd_adj_F_slope";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_tire_slope_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_Fz";
case 1: return "fwd_adj_B3";
case 2: return "fwd_adj_C3";
case 3: return "fwd_adj_B1";
case 4: return "fwd_adj_C1";
case 5: return "fwd_adj_D1";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_tire_slope_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s1;
case 7: return casadi_s0;
case 8: return casadi_s1;
case 9: return casadi_s1;
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
case 20: return casadi_s1;
case 21: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_tire_slope_sparsity_out(casadi_int i) {
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
CASADI_SYMBOL_EXPORT int fwd1_adj1_tire_slope_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 22;
if (sz_res) *sz_res = 6;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_tire_slope_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
if (sz_res) *sz_res = 6*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* tire_coefficient:(Fz,B3,C3)->(C_c) */
static int casadi_f8(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2;
a0=arg[1]? arg[1][0] : 0;
a1=arg[2]? arg[2][0] : 0;
a2=arg[0]? arg[0][0] : 0;
a1=a1*a2;
a0=a0+a1;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int tire_coefficient(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f8(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int tire_coefficient_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void tire_coefficient_release(int mem) {
}
CASADI_SYMBOL_EXPORT void tire_coefficient_incref(void) {
}
CASADI_SYMBOL_EXPORT void tire_coefficient_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int tire_coefficient_n_in(void) { return 3;}
CASADI_SYMBOL_EXPORT casadi_int tire_coefficient_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real tire_coefficient_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* tire_coefficient_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz";
case 1: return "B3";
case 2: return "C3";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* tire_coefficient_name_out(casadi_int i) {
switch (i) {
case 0: return "C_c";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* tire_coefficient_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* tire_coefficient_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int tire_coefficient_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 3;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int tire_coefficient_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 3*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_tire_coefficient:(Fz,B3,C3,out_C_c[1x1,0nz],fwd_Fz,fwd_B3,fwd_C3)->(fwd_C_c) */
static int casadi_f9(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3;
a0=arg[5]? arg[5][0] : 0;
a1=arg[0]? arg[0][0] : 0;
a2=arg[6]? arg[6][0] : 0;
a1=a1*a2;
a2=arg[2]? arg[2][0] : 0;
a3=arg[4]? arg[4][0] : 0;
a2=a2*a3;
a1=a1+a2;
a0=a0+a1;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_tire_coefficient(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f9(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_tire_coefficient_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_tire_coefficient_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_tire_coefficient_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_tire_coefficient_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_tire_coefficient_n_in(void) { return 7;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_tire_coefficient_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_tire_coefficient_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_tire_coefficient_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz";
case 1: return "B3";
case 2: return "C3";
case 3: return "out_C_c";
case 4: return "fwd_Fz";
case 5: return "fwd_B3";
case 6: return "fwd_C3";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_tire_coefficient_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_C_c";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_tire_coefficient_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s1;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_tire_coefficient_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_tire_coefficient_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 7;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_tire_coefficient_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 7*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_tire_coefficient:(Fz,B3,C3,out_C_c[1x1,0nz],adj_C_c)->(adj_Fz,adj_B3,adj_C3) */
static int casadi_f10(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1;
a0=arg[2]? arg[2][0] : 0;
a1=arg[4]? arg[4][0] : 0;
a0=a0*a1;
if (res[0]!=0) res[0][0]=a0;
if (res[1]!=0) res[1][0]=a1;
a0=arg[0]? arg[0][0] : 0;
a0=a0*a1;
if (res[2]!=0) res[2][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_tire_coefficient(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f10(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_tire_coefficient_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_tire_coefficient_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_tire_coefficient_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_tire_coefficient_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_tire_coefficient_n_in(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_int adj1_tire_coefficient_n_out(void) { return 3;}
CASADI_SYMBOL_EXPORT casadi_real adj1_tire_coefficient_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_tire_coefficient_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz";
case 1: return "B3";
case 2: return "C3";
case 3: return "out_C_c";
case 4: return "adj_C_c";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_tire_coefficient_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_Fz";
case 1: return "adj_B3";
case 2: return "adj_C3";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_tire_coefficient_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s1;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_tire_coefficient_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_tire_coefficient_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5;
if (sz_res) *sz_res = 3;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_tire_coefficient_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
if (sz_res) *sz_res = 3*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_tire_coefficient:(Fz,B3,C3,out_C_c[1x1,0nz],adj_C_c,out_adj_Fz[1x1,0nz],out_adj_B3[1x1,0nz],out_adj_C3[1x1,0nz],fwd_Fz,fwd_B3,fwd_C3,fwd_out_C_c[1x1,0nz],fwd_adj_C_c)->(fwd_adj_Fz,fwd_adj_B3,fwd_adj_C3) */
static int casadi_f11(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3;
a0=arg[4]? arg[4][0] : 0;
a1=arg[10]? arg[10][0] : 0;
a1=a0*a1;
a2=arg[2]? arg[2][0] : 0;
a3=arg[12]? arg[12][0] : 0;
a2=a2*a3;
a1=a1+a2;
if (res[0]!=0) res[0][0]=a1;
if (res[1]!=0) res[1][0]=a3;
a1=arg[8]? arg[8][0] : 0;
a0=a0*a1;
a1=arg[0]? arg[0][0] : 0;
a1=a1*a3;
a0=a0+a1;
if (res[2]!=0) res[2][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_tire_coefficient(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f11(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_tire_coefficient_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_tire_coefficient_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_tire_coefficient_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_tire_coefficient_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_tire_coefficient_n_in(void) { return 13;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_tire_coefficient_n_out(void) { return 3;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_tire_coefficient_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_tire_coefficient_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz";
case 1: return "B3";
case 2: return "C3";
case 3: return "out_C_c";
case 4: return "adj_C_c";
case 5: return "out_adj_Fz";
case 6: return "out_adj_B3";
case 7: return "out_adj_C3";
case 8: return "fwd_Fz";
case 9: return "fwd_B3";
case 10: return "fwd_C3";
case 11: return "fwd_out_C_c";
case 12: return "fwd_adj_C_c";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_tire_coefficient_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_Fz";
case 1: return "fwd_adj_B3";
case 2: return "fwd_adj_C3";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_tire_coefficient_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s1;
case 4: return casadi_s0;
case 5: return casadi_s1;
case 6: return casadi_s1;
case 7: return casadi_s1;
case 8: return casadi_s0;
case 9: return casadi_s0;
case 10: return casadi_s0;
case 11: return casadi_s1;
case 12: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_tire_coefficient_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_tire_coefficient_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 13;
if (sz_res) *sz_res = 3;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_tire_coefficient_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 13*sizeof(const casadi_real*);
if (sz_res) *sz_res = 3*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* tire_friction:(Fz,B5,C5)->(mu) */
static int casadi_f12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2;
a0=arg[1]? arg[1][0] : 0;
a1=arg[2]? arg[2][0] : 0;
a2=arg[0]? arg[0][0] : 0;
a1=a1*a2;
a0=a0+a1;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int tire_friction(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f12(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int tire_friction_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void tire_friction_release(int mem) {
}
CASADI_SYMBOL_EXPORT void tire_friction_incref(void) {
}
CASADI_SYMBOL_EXPORT void tire_friction_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int tire_friction_n_in(void) { return 3;}
CASADI_SYMBOL_EXPORT casadi_int tire_friction_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real tire_friction_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* tire_friction_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz";
case 1: return "B5";
case 2: return "C5";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* tire_friction_name_out(casadi_int i) {
switch (i) {
case 0: return "mu";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* tire_friction_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* tire_friction_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int tire_friction_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 3;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int tire_friction_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 3*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_tire_friction:(Fz,B5,C5,out_mu[1x1,0nz],fwd_Fz,fwd_B5,fwd_C5)->(fwd_mu) */
static int casadi_f13(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3;
a0=arg[5]? arg[5][0] : 0;
a1=arg[0]? arg[0][0] : 0;
a2=arg[6]? arg[6][0] : 0;
a1=a1*a2;
a2=arg[2]? arg[2][0] : 0;
a3=arg[4]? arg[4][0] : 0;
a2=a2*a3;
a1=a1+a2;
a0=a0+a1;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_tire_friction(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f13(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_tire_friction_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_tire_friction_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_tire_friction_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_tire_friction_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_tire_friction_n_in(void) { return 7;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_tire_friction_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_tire_friction_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_tire_friction_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz";
case 1: return "B5";
case 2: return "C5";
case 3: return "out_mu";
case 4: return "fwd_Fz";
case 5: return "fwd_B5";
case 6: return "fwd_C5";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_tire_friction_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_mu";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_tire_friction_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s1;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_tire_friction_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_tire_friction_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 7;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_tire_friction_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 7*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_tire_friction:(Fz,B5,C5,out_mu[1x1,0nz],adj_mu)->(adj_Fz,adj_B5,adj_C5) */
static int casadi_f14(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1;
a0=arg[2]? arg[2][0] : 0;
a1=arg[4]? arg[4][0] : 0;
a0=a0*a1;
if (res[0]!=0) res[0][0]=a0;
if (res[1]!=0) res[1][0]=a1;
a0=arg[0]? arg[0][0] : 0;
a0=a0*a1;
if (res[2]!=0) res[2][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_tire_friction(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f14(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_tire_friction_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_tire_friction_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_tire_friction_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_tire_friction_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_tire_friction_n_in(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_int adj1_tire_friction_n_out(void) { return 3;}
CASADI_SYMBOL_EXPORT casadi_real adj1_tire_friction_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_tire_friction_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz";
case 1: return "B5";
case 2: return "C5";
case 3: return "out_mu";
case 4: return "adj_mu";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_tire_friction_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_Fz";
case 1: return "adj_B5";
case 2: return "adj_C5";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_tire_friction_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s1;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_tire_friction_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_tire_friction_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5;
if (sz_res) *sz_res = 3;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_tire_friction_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
if (sz_res) *sz_res = 3*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_tire_friction:(Fz,B5,C5,out_mu[1x1,0nz],adj_mu,out_adj_Fz[1x1,0nz],out_adj_B5[1x1,0nz],out_adj_C5[1x1,0nz],fwd_Fz,fwd_B5,fwd_C5,fwd_out_mu[1x1,0nz],fwd_adj_mu)->(fwd_adj_Fz,fwd_adj_B5,fwd_adj_C5) */
static int casadi_f15(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3;
a0=arg[4]? arg[4][0] : 0;
a1=arg[10]? arg[10][0] : 0;
a1=a0*a1;
a2=arg[2]? arg[2][0] : 0;
a3=arg[12]? arg[12][0] : 0;
a2=a2*a3;
a1=a1+a2;
if (res[0]!=0) res[0][0]=a1;
if (res[1]!=0) res[1][0]=a3;
a1=arg[8]? arg[8][0] : 0;
a0=a0*a1;
a1=arg[0]? arg[0][0] : 0;
a1=a1*a3;
a0=a0+a1;
if (res[2]!=0) res[2][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_tire_friction(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f15(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_tire_friction_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_tire_friction_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_tire_friction_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_tire_friction_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_tire_friction_n_in(void) { return 13;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_tire_friction_n_out(void) { return 3;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_tire_friction_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_tire_friction_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz";
case 1: return "B5";
case 2: return "C5";
case 3: return "out_mu";
case 4: return "adj_mu";
case 5: return "out_adj_Fz";
case 6: return "out_adj_B5";
case 7: return "out_adj_C5";
case 8: return "fwd_Fz";
case 9: return "fwd_B5";
case 10: return "fwd_C5";
case 11: return "fwd_out_mu";
case 12: return "fwd_adj_mu";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_tire_friction_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_Fz";
case 1: return "fwd_adj_B5";
case 2: return "fwd_adj_C5";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_tire_friction_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s1;
case 4: return casadi_s0;
case 5: return casadi_s1;
case 6: return casadi_s1;
case 7: return casadi_s1;
case 8: return casadi_s0;
case 9: return casadi_s0;
case 10: return casadi_s0;
case 11: return casadi_s1;
case 12: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_tire_friction_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_tire_friction_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 13;
if (sz_res) *sz_res = 3;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_tire_friction_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 13*sizeof(const casadi_real*);
if (sz_res) *sz_res = 3*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* magic_formula_of_shape:(C1)->(B1,D1) */
static int casadi_f16(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0;
a0=arg[0]? arg[0][0] : 0;
a0=1./a0;
if (res[0]!=0) res[0][0]=a0;
a0=1.;
if (res[1]!=0) res[1][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int magic_formula_of_shape(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f16(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int magic_formula_of_shape_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void magic_formula_of_shape_release(int mem) {
}
CASADI_SYMBOL_EXPORT void magic_formula_of_shape_incref(void) {
}
CASADI_SYMBOL_EXPORT void magic_formula_of_shape_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int magic_formula_of_shape_n_in(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_int magic_formula_of_shape_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real magic_formula_of_shape_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* magic_formula_of_shape_name_in(casadi_int i) {
switch (i) {
case 0: return "C1";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* magic_formula_of_shape_name_out(casadi_int i) {
switch (i) {
case 0: return "B1";
case 1: return "D1";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* magic_formula_of_shape_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* magic_formula_of_shape_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int magic_formula_of_shape_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 1;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int magic_formula_of_shape_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 1*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_magic_formula_of_shape:(C1,out_B1[1x1,0nz],out_D1[1x1,0nz],fwd_C1)->(fwd_B1,fwd_D1) */
static int casadi_f17(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1;
a0=arg[0]? arg[0][0] : 0;
a1=1./a0;
a1=a1/a0;
a0=arg[3]? arg[3][0] : 0;
a1=a1*a0;
a1=-a1;
if (res[0]!=0) res[0][0]=a1;
a1=0.;
if (res[1]!=0) res[1][0]=a1;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_magic_formula_of_shape(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f17(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_magic_formula_of_shape_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_magic_formula_of_shape_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_magic_formula_of_shape_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_magic_formula_of_shape_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_magic_formula_of_shape_n_in(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_magic_formula_of_shape_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_magic_formula_of_shape_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_magic_formula_of_shape_name_in(casadi_int i) {
switch (i) {
case 0: return "C1";
case 1: return "out_B1";
case 2: return "out_D1";
case 3: return "fwd_C1";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_magic_formula_of_shape_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_B1";
case 1: return "fwd_D1";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_magic_formula_of_shape_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s1;
case 2: return casadi_s1;
case 3: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_magic_formula_of_shape_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_magic_formula_of_shape_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 4;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_magic_formula_of_shape_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 4*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_magic_formula_of_shape:(C1,out_B1[1x1,0nz],out_D1[1x1,0nz],adj_B1,adj_D1)->(adj_C1) */
static int casadi_f18(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1;
a0=arg[0]? arg[0][0] : 0;
a1=1./a0;
a1=a1/a0;
a0=arg[3]? arg[3][0] : 0;
a1=a1*a0;
a1=-a1;
if (res[0]!=0) res[0][0]=a1;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_magic_formula_of_shape(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f18(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_magic_formula_of_shape_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_magic_formula_of_shape_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_magic_formula_of_shape_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_magic_formula_of_shape_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_magic_formula_of_shape_n_in(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_int adj1_magic_formula_of_shape_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real adj1_magic_formula_of_shape_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_magic_formula_of_shape_name_in(casadi_int i) {
switch (i) {
case 0: return "C1";
case 1: return "out_B1";
case 2: return "out_D1";
case 3: return "adj_B1";
case 4: return "adj_D1";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_magic_formula_of_shape_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_C1";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_magic_formula_of_shape_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s1;
case 2: return casadi_s1;
case 3: return casadi_s0;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_magic_formula_of_shape_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_magic_formula_of_shape_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_magic_formula_of_shape_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_magic_formula_of_shape:(C1,out_B1[1x1,0nz],out_D1[1x1,0nz],adj_B1,adj_D1,out_adj_C1[1x1,0nz],fwd_C1,fwd_out_B1[1x1,0nz],fwd_out_D1[1x1,0nz],fwd_adj_B1,fwd_adj_D1)->(fwd_adj_C1) */
static int casadi_f19(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5;
a0=arg[0]? arg[0][0] : 0;
a1=1./a0;
a2=a1/a0;
a3=arg[9]? arg[9][0] : 0;
a3=a2*a3;
a4=arg[3]? arg[3][0] : 0;
a1=a1/a0;
a5=arg[6]? arg[6][0] : 0;
a1=a1*a5;
a1=a1/a0;
a2=a2/a0;
a2=a2*a5;
a1=a1+a2;
a4=a4*a1;
a3=a3-a4;
a3=-a3;
if (res[0]!=0) res[0][0]=a3;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_magic_formula_of_shape(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f19(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_magic_formula_of_shape_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_magic_formula_of_shape_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_magic_formula_of_shape_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_magic_formula_of_shape_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_magic_formula_of_shape_n_in(void) { return 11;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_magic_formula_of_shape_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_magic_formula_of_shape_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_magic_formula_of_shape_name_in(casadi_int i) {
switch (i) {
case 0: return "C1";
case 1: return "out_B1";
case 2: return "out_D1";
case 3: return "adj_B1";
case 4: return "adj_D1";
case 5: return "out_adj_C1";
case 6: return "fwd_C1";
case 7: return "fwd_out_B1";
case 8: return "fwd_out_D1";
case 9: return "fwd_adj_B1";
case 10: return "fwd_adj_D1";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_magic_formula_of_shape_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_C1";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_magic_formula_of_shape_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_magic_formula_of_shape_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_magic_formula_of_shape_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 11;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_magic_formula_of_shape_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 11*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* mf_lateral:(alpha,Fz,FNOMIN,tangent,PCY1,PDY1,PDY2,PEY1,PEY2,PEY3,PKY1,PKY2,PKY4,PHY1,PHY2,PVY1,PVY2,LFZO,LCY,LMUY,LEY,LKY,LHY,LVY)->(F_mf) */
static int casadi_f20(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13;
a00=arg[1]? arg[1][0] : 0;
a01=arg[19]? arg[19][0] : 0;
a02=arg[5]? arg[5][0] : 0;
a03=arg[6]? arg[6][0] : 0;
a04=arg[2]? arg[2][0] : 0;
a05=arg[17]? arg[17][0] : 0;
a06=a04*a05;
a06=a00-a06;
a07=a04*a05;
a06=a06/a07;
a03=a03*a06;
a02=a02+a03;
a02=a01*a02;
a02=a00*a02;
a03=arg[18]? arg[18][0] : 0;
a08=arg[4]? arg[4][0] : 0;
a03=a03*a08;
a04=a04*a05;
a05=arg[21]? arg[21][0] : 0;
a04=a04*a05;
a05=arg[10]? arg[10][0] : 0;
a04=a04*a05;
a05=arg[12]? arg[12][0] : 0;
a07=a00/a07;
a08=arg[11]? arg[11][0] : 0;
a07=a07/a08;
a07=atan(a07);
a05=a05*a07;
a05=sin(a05);
a04=a04*a05;
a05=a03*a02;
a04=a04/a05;
a05=arg[22]? arg[22][0] : 0;
a07=arg[13]? arg[13][0] : 0;
a08=arg[14]? arg[14][0] : 0;
a08=a08*a06;
a07=a07+a08;
a05=a05*a07;
a07=arg[0]? arg[0][0] : 0;
a08=1.;
a09=arg[3]? arg[3][0] : 0;
a10=a08-a09;
a10=a07*a10;
a05=a05+a10;
a07=tan(a07);
a09=a09*a07;
a05=a05+a09;
a09=a04*a05;
a07=arg[20]? arg[20][0] : 0;
a10=arg[7]? arg[7][0] : 0;
a11=arg[8]? arg[8][0] : 0;
a11=a11*a06;
a10=a10+a11;
a07=a07*a10;
a10=arg[9]? arg[9][0] : 0;
a11=0.;
a11=a11<=a05;
a12=a11?a08:0;
a11=!a11;
a13=-1.;
a11=a11?a13:0;
a12=a12+a11;
a10=a10*a12;
a10=a08-a10;
a07=a07*a10;
a08=casadi_fmin(a08,a07);
a07=a04*a05;
a04=a04*a05;
a04=atan(a04);
a07=a07-a04;
a08=a08*a07;
a09=a09-a08;
a09=atan(a09);
a03=a03*a09;
a03=sin(a03);
a02=a02*a03;
a00=a00*a01;
a01=arg[23]? arg[23][0] : 0;
a00=a00*a01;
a01=arg[15]? arg[15][0] : 0;
a03=arg[16]? arg[16][0] : 0;
a03=a03*a06;
a01=a01+a03;
a00=a00*a01;
a02=a02+a00;
if (res[0]!=0) res[0][0]=a02;
return 0;
}
CASADI_SYMBOL_EXPORT int mf_lateral(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f20(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int mf_lateral_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void mf_lateral_release(int mem) {
}
CASADI_SYMBOL_EXPORT void mf_lateral_incref(void) {
}
CASADI_SYMBOL_EXPORT void mf_lateral_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int mf_lateral_n_in(void) { return 24;}
CASADI_SYMBOL_EXPORT casadi_int mf_lateral_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real mf_lateral_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* mf_lateral_name_in(casadi_int i) {
switch (i) {
case 0: return "alpha";
case 1: return "Fz";
case 2: return "FNOMIN";
case 3: return "tangent";
case 4: return "PCY1";
case 5: return "PDY1";
case 6: return "PDY2";
case 7: return "PEY1";
case 8: return "PEY2";
case 9: return "PEY3";
case 10: return "PKY1";
case 11: return "PKY2";
case 12: return "PKY4";
case 13: return "PHY1";
case 14: return "PHY2";
case 15: return "PVY1";
case 16: return "PVY2";
case 17: return "LFZO";
case 18: return "LCY";
case 19: return "LMUY";
case 20: return "LEY";
case 21: return "LKY";
case 22: return "LHY";
case 23: return "LVY";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* mf_lateral_name_out(casadi_int i) {
switch (i) {
case 0: return "F_mf";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* mf_lateral_sparsity_in(casadi_int i) {
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
case 20: return casadi_s0;
case 21: return casadi_s0;
case 22: return casadi_s0;
case 23: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* mf_lateral_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int mf_lateral_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 24;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int mf_lateral_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 24*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_mf_lateral:(alpha,Fz,FNOMIN,tangent,PCY1,PDY1,PDY2,PEY1,PEY2,PEY3,PKY1,PKY2,PKY4,PHY1,PHY2,PVY1,PVY2,LFZO,LCY,LMUY,LEY,LKY,LHY,LVY,out_F_mf[1x1,0nz],fwd_alpha,fwd_Fz,fwd_FNOMIN,fwd_tangent,fwd_PCY1,fwd_PDY1,fwd_PDY2,fwd_PEY1,fwd_PEY2,fwd_PEY3,fwd_PKY1,fwd_PKY2,fwd_PKY4,fwd_PHY1,fwd_PHY2,fwd_PVY1,fwd_PVY2,fwd_LFZO,fwd_LCY,fwd_LMUY,fwd_LEY,fwd_LKY,fwd_LHY,fwd_LVY)->(fwd_F_mf) */
static int casadi_f21(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
a00=arg[18]? arg[18][0] : 0;
a01=arg[4]? arg[4][0] : 0;
a02=a00*a01;
a03=arg[2]? arg[2][0] : 0;
a04=arg[17]? arg[17][0] : 0;
a05=a03*a04;
a06=arg[21]? arg[21][0] : 0;
a07=a05*a06;
a08=arg[10]? arg[10][0] : 0;
a09=a07*a08;
a10=arg[12]? arg[12][0] : 0;
a11=arg[1]? arg[1][0] : 0;
a12=a03*a04;
a13=a11/a12;
a14=arg[11]? arg[11][0] : 0;
a15=a13/a14;
a16=atan(a15);
a17=a10*a16;
a18=sin(a17);
a19=a09*a18;
a20=arg[19]? arg[19][0] : 0;
a21=arg[5]? arg[5][0] : 0;
a22=arg[6]? arg[6][0] : 0;
a23=a03*a04;
a23=a11-a23;
a23=a23/a12;
a24=a22*a23;
a21=a21+a24;
a24=a20*a21;
a25=a11*a24;
a26=a02*a25;
a19=a19/a26;
a27=arg[22]? arg[22][0] : 0;
a28=arg[13]? arg[13][0] : 0;
a29=arg[14]? arg[14][0] : 0;
a30=a29*a23;
a28=a28+a30;
a30=a27*a28;
a31=arg[0]? arg[0][0] : 0;
a32=1.;
a33=arg[3]? arg[3][0] : 0;
a34=a32-a33;
a35=a31*a34;
a30=a30+a35;
a35=tan(a31);
a36=a33*a35;
a30=a30+a36;
a36=a19*a30;
a37=arg[20]? arg[20][0] : 0;
a38=arg[7]? arg[7][0] : 0;
a39=arg[8]? arg[8][0] : 0;
a40=a39*a23;
a38=a38+a40;
a40=a37*a38;
a41=arg[9]? arg[9][0] : 0;
a42=0.;
a42=a42<=a30;
a43=a42?a32:0;
a42=!a42;
a44=-1.;
a42=a42?a44:0;
a43=a43+a42;
a41=a41*a43;
a41=a32-a41;
a42=a40*a41;
a44=casadi_fmin(a32,a42);
a45=a19*a30;
a46=a19*a30;
a47=atan(a46);
a45=a45-a47;
a47=a44*a45;
a36=a36-a47;
a47=atan(a36);
a48=a02*a47;
a49=sin(a48);
a50=arg[26]? arg[26][0] : 0;
a24=a24*a50;
a51=arg[44]? arg[44][0] : 0;
a21=a21*a51;
a52=arg[30]? arg[30][0] : 0;
a53=arg[31]? arg[31][0] : 0;
a53=a23*a53;
a54=arg[27]? arg[27][0] : 0;
a55=a04*a54;
a56=arg[42]? arg[42][0] : 0;
a57=a03*a56;
a55=a55+a57;
a55=a50-a55;
a55=a55/a12;
a57=a23/a12;
a58=a04*a54;
a59=a03*a56;
a58=a58+a59;
a57=a57*a58;
a55=a55-a57;
a22=a22*a55;
a53=a53+a22;
a52=a52+a53;
a52=a20*a52;
a21=a21+a52;
a21=a11*a21;
a24=a24+a21;
a49=a49*a24;
a48=cos(a48);
a21=arg[43]? arg[43][0] : 0;
a01=a01*a21;
a21=arg[29]? arg[29][0] : 0;
a00=a00*a21;
a01=a01+a00;
a47=a47*a01;
a04=a04*a54;
a03=a03*a56;
a04=a04+a03;
a06=a06*a04;
a04=arg[46]? arg[46][0] : 0;
a05=a05*a04;
a06=a06+a05;
a08=a08*a06;
a06=arg[35]? arg[35][0] : 0;
a07=a07*a06;
a08=a08+a07;
a18=a18*a08;
a17=cos(a17);
a08=arg[37]? arg[37][0] : 0;
a16=a16*a08;
a08=a50/a12;
a13=a13/a12;
a13=a13*a58;
a08=a08-a13;
a08=a08/a14;
a14=a15/a14;
a13=arg[36]? arg[36][0] : 0;
a14=a14*a13;
a08=a08-a14;
a15=casadi_sq(a15);
a15=a32+a15;
a08=a08/a15;
a10=a10*a08;
a16=a16+a10;
a17=a17*a16;
a09=a09*a17;
a18=a18+a09;
a18=a18/a26;
a26=a19/a26;
a01=a25*a01;
a24=a02*a24;
a01=a01+a24;
a26=a26*a01;
a18=a18-a26;
a26=a30*a18;
a01=arg[47]? arg[47][0] : 0;
a28=a28*a01;
a01=arg[38]? arg[38][0] : 0;
a24=arg[39]? arg[39][0] : 0;
a24=a23*a24;
a29=a29*a55;
a24=a24+a29;
a01=a01+a24;
a27=a27*a01;
a28=a28+a27;
a27=arg[25]? arg[25][0] : 0;
a34=a34*a27;
a01=arg[28]? arg[28][0] : 0;
a24=a31*a01;
a34=a34-a24;
a28=a28+a34;
a35=a35*a01;
a31=cos(a31);
a31=casadi_sq(a31);
a27=a27/a31;
a33=a33*a27;
a35=a35+a33;
a28=a28+a35;
a35=a19*a28;
a26=a26+a35;
a35=a42<=a32;
a42=a32<=a42;
a42=a42+a35;
a35=a35/a42;
a42=arg[45]? arg[45][0] : 0;
a38=a38*a42;
a42=arg[32]? arg[32][0] : 0;
a33=arg[33]? arg[33][0] : 0;
a33=a23*a33;
a39=a39*a55;
a33=a33+a39;
a42=a42+a33;
a37=a37*a42;
a38=a38+a37;
a41=a41*a38;
a38=arg[34]? arg[34][0] : 0;
a43=a43*a38;
a40=a40*a43;
a41=a41-a40;
a35=a35*a41;
a45=a45*a35;
a35=a30*a18;
a41=a19*a28;
a35=a35+a41;
a30=a30*a18;
a19=a19*a28;
a30=a30+a19;
a46=casadi_sq(a46);
a46=a32+a46;
a30=a30/a46;
a35=a35-a30;
a44=a44*a35;
a45=a45+a44;
a26=a26-a45;
a36=casadi_sq(a36);
a32=a32+a36;
a26=a26/a32;
a02=a02*a26;
a47=a47+a02;
a48=a48*a47;
a25=a25*a48;
a49=a49+a25;
a25=arg[15]? arg[15][0] : 0;
a48=arg[16]? arg[16][0] : 0;
a47=a48*a23;
a25=a25+a47;
a47=arg[23]? arg[23][0] : 0;
a50=a20*a50;
a51=a11*a51;
a50=a50+a51;
a50=a47*a50;
a11=a11*a20;
a20=arg[48]? arg[48][0] : 0;
a20=a11*a20;
a50=a50+a20;
a25=a25*a50;
a11=a11*a47;
a47=arg[40]? arg[40][0] : 0;
a50=arg[41]? arg[41][0] : 0;
a23=a23*a50;
a48=a48*a55;
a23=a23+a48;
a47=a47+a23;
a11=a11*a47;
a25=a25+a11;
a49=a49+a25;
if (res[0]!=0) res[0][0]=a49;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_mf_lateral(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f21(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_mf_lateral_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_mf_lateral_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_mf_lateral_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_mf_lateral_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_mf_lateral_n_in(void) { return 49;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_mf_lateral_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_mf_lateral_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_mf_lateral_name_in(casadi_int i) {
switch (i) {
case 0: return "alpha";
case 1: return "Fz";
case 2: return "FNOMIN";
case 3: return "tangent";
case 4: return "PCY1";
case 5: return "PDY1";
case 6: return "PDY2";
case 7: return "PEY1";
case 8: return "PEY2";
case 9: return "PEY3";
case 10: return "PKY1";
case 11: return "PKY2";
case 12: return "PKY4";
case 13: return "PHY1";
case 14: return "PHY2";
case 15: return "PVY1";
case 16: return "PVY2";
case 17: return "LFZO";
case 18: return "LCY";
case 19: return "LMUY";
case 20: return "LEY";
case 21: return "LKY";
case 22: return "LHY";
case 23: return "LVY";
case 24: return "out_F_mf";
case 25: return "fwd_alpha";
case 26: return "fwd_Fz";
case 27: return "fwd_FNOMIN";
case 28: return "fwd_tangent";
case 29: return "fwd_PCY1";
case 30: return "fwd_PDY1";
case 31: return "fwd_PDY2";
case 32: return "fwd_PEY1";
case 33: return "fwd_PEY2";
case 34: return "fwd_PEY3";
case 35: return "fwd_PKY1";
case 36: return "fwd_PKY2";
case 37: return "fwd_PKY4";
case 38: return "fwd_PHY1";
case 39: return "fwd_PHY2";
case 40: return "fwd_PVY1";
case 41: return "fwd_PVY2";
case 42: return "fwd_LFZO";
case 43: return "fwd_LCY";
case 44: return "fwd_LMUY";
case 45: return "fwd_LEY";
case 46: return "fwd_LKY";
case 47: return "fwd_LHY";
case 48: return "fwd_LVY";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_mf_lateral_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_F_mf";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_mf_lateral_sparsity_in(casadi_int i) {
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
case 20: return casadi_s0;
case 21: return casadi_s0;
case 22: return casadi_s0;
case 23: return casadi_s0;
case 24: return casadi_s1;
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
case 42: return casadi_s0;
case 43: return casadi_s0;
case 44: return casadi_s0;
case 45: return casadi_s0;
case 46: return casadi_s0;
case 47: return casadi_s0;
case 48: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_mf_lateral_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_mf_lateral_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 49;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_mf_lateral_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 49*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_mf_lateral:(alpha,Fz,FNOMIN,tangent,PCY1,PDY1,PDY2,PEY1,PEY2,PEY3,PKY1,PKY2,PKY4,PHY1,PHY2,PVY1,PVY2,LFZO,LCY,LMUY,LEY,LKY,LHY,LVY,out_F_mf[1x1,0nz],adj_F_mf)->(adj_alpha,adj_Fz,adj_FNOMIN,adj_tangent,adj_PCY1,adj_PDY1,adj_PDY2,adj_PEY1,adj_PEY2,adj_PEY3,adj_PKY1,adj_PKY2,adj_PKY4,adj_PHY1,adj_PHY2,adj_PVY1,adj_PVY2,adj_LFZO,adj_LCY,adj_LMUY,adj_LEY,adj_LKY,adj_LHY,adj_LVY) */
static int casadi_f22(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
casadi_real a48, a49, a50, a51, a52, a53, a54;
a00=arg[3]? arg[3][0] : 0;
a01=arg[2]? arg[2][0] : 0;
a02=arg[17]? arg[17][0] : 0;
a03=a01*a02;
a04=arg[21]? arg[21][0] : 0;
a05=a03*a04;
a06=arg[10]? arg[10][0] : 0;
a07=a05*a06;
a08=arg[12]? arg[12][0] : 0;
a09=arg[1]? arg[1][0] : 0;
a10=a01*a02;
a11=a09/a10;
a12=arg[11]? arg[11][0] : 0;
a13=a11/a12;
a14=atan(a13);
a15=a08*a14;
a16=sin(a15);
a17=a07*a16;
a18=arg[18]? arg[18][0] : 0;
a19=arg[4]? arg[4][0] : 0;
a20=a18*a19;
a21=arg[19]? arg[19][0] : 0;
a22=arg[5]? arg[5][0] : 0;
a23=arg[6]? arg[6][0] : 0;
a24=a01*a02;
a24=a09-a24;
a24=a24/a10;
a25=a23*a24;
a22=a22+a25;
a25=a21*a22;
a26=a09*a25;
a27=a20*a26;
a17=a17/a27;
a28=1.;
a29=arg[20]? arg[20][0] : 0;
a30=arg[7]? arg[7][0] : 0;
a31=arg[8]? arg[8][0] : 0;
a32=a31*a24;
a30=a30+a32;
a32=a29*a30;
a33=arg[9]? arg[9][0] : 0;
a34=0.;
a35=arg[22]? arg[22][0] : 0;
a36=arg[13]? arg[13][0] : 0;
a37=arg[14]? arg[14][0] : 0;
a38=a37*a24;
a36=a36+a38;
a38=a35*a36;
a39=arg[0]? arg[0][0] : 0;
a40=a28-a00;
a41=a39*a40;
a38=a38+a41;
a41=tan(a39);
a42=a00*a41;
a38=a38+a42;
a34=a34<=a38;
a42=a34?a28:0;
a34=!a34;
a43=-1.;
a34=a34?a43:0;
a42=a42+a34;
a33=a33*a42;
a33=a28-a33;
a34=a32*a33;
a43=casadi_fmin(a28,a34);
a44=a17*a38;
a45=a17*a38;
a46=a17*a38;
a47=atan(a46);
a45=a45-a47;
a47=a43*a45;
a44=a44-a47;
a47=atan(a44);
a48=a20*a47;
a49=cos(a48);
a50=arg[25]? arg[25][0] : 0;
a51=a26*a50;
a49=a49*a51;
a51=a20*a49;
a44=casadi_sq(a44);
a44=a28+a44;
a51=a51/a44;
a43=a43*a51;
a46=casadi_sq(a46);
a46=a28+a46;
a46=a43/a46;
a44=a17*a46;
a52=a17*a43;
a44=a44-a52;
a52=a17*a51;
a44=a44+a52;
a00=a00*a44;
a52=cos(a39);
a52=casadi_sq(a52);
a00=a00/a52;
a40=a40*a44;
a00=a00+a40;
if (res[0]!=0) res[0][0]=a00;
a00=arg[23]? arg[23][0] : 0;
a40=arg[15]? arg[15][0] : 0;
a52=arg[16]? arg[16][0] : 0;
a53=a52*a24;
a40=a40+a53;
a40=a40*a50;
a53=a00*a40;
a54=a21*a53;
a15=cos(a15);
a46=a38*a46;
a43=a38*a43;
a46=a46-a43;
a38=a38*a51;
a46=a46+a38;
a38=a46/a27;
a07=a07*a38;
a15=a15*a07;
a08=a08*a15;
a07=casadi_sq(a13);
a07=a28+a07;
a08=a08/a07;
a07=a08/a12;
a43=a07/a10;
a54=a54+a43;
a48=sin(a48);
a48=a48*a50;
a17=a17/a27;
a17=a17*a46;
a20=a20*a17;
a48=a48-a20;
a25=a25*a48;
a54=a54+a25;
a25=a09*a21;
a00=a25*a00;
a00=a00*a50;
a52=a52*a00;
a50=a34<=a28;
a28=a28<=a34;
a28=a28+a50;
a50=a50/a28;
a45=a45*a51;
a50=a50*a45;
a33=a33*a50;
a29=a29*a33;
a31=a31*a29;
a52=a52-a31;
a35=a35*a44;
a37=a37*a35;
a52=a52+a37;
a48=a09*a48;
a21=a21*a48;
a23=a23*a21;
a52=a52+a23;
a23=a52/a10;
a54=a54+a23;
if (res[1]!=0) res[1][0]=a54;
a16=a16*a38;
a06=a06*a16;
a04=a04*a06;
a38=a02*a04;
a11=a11/a10;
a11=a11*a07;
a10=a24/a10;
a10=a10*a52;
a11=a11+a10;
a10=a02*a11;
a38=a38-a10;
a02=a02*a23;
a38=a38-a02;
if (res[2]!=0) res[2][0]=a38;
a41=a41*a44;
a39=a39*a44;
a41=a41-a39;
if (res[3]!=0) res[3][0]=a41;
a47=a47*a49;
a26=a26*a17;
a47=a47-a26;
a18=a18*a47;
if (res[4]!=0) res[4][0]=a18;
if (res[5]!=0) res[5][0]=a21;
a21=a24*a21;
if (res[6]!=0) res[6][0]=a21;
a21=-a29;
if (res[7]!=0) res[7][0]=a21;
a29=a24*a29;
a29=-a29;
if (res[8]!=0) res[8][0]=a29;
a32=a32*a50;
a42=a42*a32;
if (res[9]!=0) res[9][0]=a42;
a05=a05*a16;
if (res[10]!=0) res[10][0]=a05;
a13=a13/a12;
a13=a13*a08;
a13=-a13;
if (res[11]!=0) res[11][0]=a13;
a14=a14*a15;
if (res[12]!=0) res[12][0]=a14;
if (res[13]!=0) res[13][0]=a35;
a35=a24*a35;
if (res[14]!=0) res[14][0]=a35;
if (res[15]!=0) res[15][0]=a00;
a24=a24*a00;
if (res[16]!=0) res[16][0]=a24;
a04=a01*a04;
a11=a01*a11;
a04=a04-a11;
a01=a01*a23;
a04=a04-a01;
if (res[17]!=0) res[17][0]=a04;
a19=a19*a47;
if (res[18]!=0) res[18][0]=a19;
a09=a09*a53;
a22=a22*a48;
a09=a09+a22;
if (res[19]!=0) res[19][0]=a09;
a30=a30*a33;
a30=-a30;
if (res[20]!=0) res[20][0]=a30;
a03=a03*a06;
if (res[21]!=0) res[21][0]=a03;
a36=a36*a44;
if (res[22]!=0) res[22][0]=a36;
a25=a25*a40;
if (res[23]!=0) res[23][0]=a25;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_mf_lateral(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f22(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_mf_lateral_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_mf_lateral_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_mf_lateral_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_mf_lateral_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_mf_lateral_n_in(void) { return 26;}
CASADI_SYMBOL_EXPORT casadi_int adj1_mf_lateral_n_out(void) { return 24;}
CASADI_SYMBOL_EXPORT casadi_real adj1_mf_lateral_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_mf_lateral_name_in(casadi_int i) {
switch (i) {
case 0: return "alpha";
case 1: return "Fz";
case 2: return "FNOMIN";
case 3: return "tangent";
case 4: return "PCY1";
case 5: return "PDY1";
case 6: return "PDY2";
case 7: return "PEY1";
case 8: return "PEY2";
case 9: return "PEY3";
case 10: return "PKY1";
case 11: return "PKY2";
case 12: return "PKY4";
case 13: return "PHY1";
case 14: return "PHY2";
case 15: return "PVY1";
case 16: return "PVY2";
case 17: return "LFZO";
case 18: return "LCY";
case 19: return "LMUY";
case 20: return "LEY";
case 21: return "LKY";
case 22: return "LHY";
case 23: return "LVY";
case 24: return "out_F_mf";
case 25: return "adj_F_mf";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_mf_lateral_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_alpha";
case 1: return "adj_Fz";
case 2: return "adj_FNOMIN";
case 3: return "adj_tangent";
case 4: return "adj_PCY1";
case 5: return "adj_PDY1";
case 6: return "adj_PDY2";
case 7: return "adj_PEY1";
case 8: return "adj_PEY2";
case 9: return "adj_PEY3";
case 10: return "adj_PKY1";
case 11: return "adj_PKY2";
case 12: return "adj_PKY4";
case 13: return "adj_PHY1";
case 14: return "adj_PHY2";
case 15: return "adj_PVY1";
case 16: return "adj_PVY2";
case 17: return "adj_LFZO";
case 18: return "adj_LCY";
case 19: return "adj_LMUY";
case 20: return "adj_LEY";
case 21: return "adj_LKY";
case 22: return "adj_LHY";
case 23: return "adj_LVY";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_mf_lateral_sparsity_in(casadi_int i) {
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
case 20: return casadi_s0;
case 21: return casadi_s0;
case 22: return casadi_s0;
case 23: return casadi_s0;
case 24: return casadi_s1;
case 25: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_mf_lateral_sparsity_out(casadi_int i) {
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
case 20: return casadi_s0;
case 21: return casadi_s0;
case 22: return casadi_s0;
case 23: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_mf_lateral_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 26;
if (sz_res) *sz_res = 24;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_mf_lateral_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 26*sizeof(const casadi_real*);
if (sz_res) *sz_res = 24*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_mf_lateral:(alpha,Fz,FNOMIN,tangent,PCY1,PDY1,PDY2,PEY1,PEY2,PEY3,PKY1,PKY2,PKY4,PHY1,PHY2,PVY1,PVY2,LFZO,LCY,LMUY,LEY,LKY,LHY,LVY,out_F_mf[1x1,0nz],adj_F_mf,out_adj_alpha[1x1,0nz],out_adj_Fz[1x1,0nz],out_adj_FNOMIN[1x1,0nz],out_adj_tangent[1x1,0nz],out_adj_PCY1[1x1,0nz],out_adj_PDY1[1x1,0nz],out_adj_PDY2[1x1,0nz],out_adj_PEY1[1x1,0nz],out_adj_PEY2[1x1,0nz],out_adj_PEY3[1x1,0nz],out_adj_PKY1[1x1,0nz],out_adj_PKY2[1x1,0nz],out_adj_PKY4[1x1,0nz],out_adj_PHY1[1x1,0nz],out_adj_PHY2[1x1,0nz],out_adj_PVY1[1x1,0nz],out_adj_PVY2[1x1,0nz],out_adj_LFZO[1x1,0nz],out_adj_LCY[1x1,0nz],out_adj_LMUY[1x1,0nz],out_adj_LEY[1x1,0nz],out_adj_LKY[1x1,0nz],out_adj_LHY[1x1,0nz],out_adj_LVY[1x1,0nz],fwd_alpha,fwd_Fz,fwd_FNOMIN,fwd_tangent,fwd_PCY1,fwd_PDY1,fwd_PDY2,fwd_PEY1,fwd_PEY2,fwd_PEY3,fwd_PKY1,fwd_PKY2,fwd_PKY4,fwd_PHY1,fwd_PHY2,fwd_PVY1,fwd_PVY2,fwd_LFZO,fwd_LCY,fwd_LMUY,fwd_LEY,fwd_LKY,fwd_LHY,fwd_LVY,fwd_out_F_mf[1x1,0nz],fwd_adj_F_mf)->(fwd_adj_alpha,fwd_adj_Fz,fwd_adj_FNOMIN,fwd_adj_tangent,fwd_adj_PCY1,fwd_adj_PDY1,fwd_adj_PDY2,fwd_adj_PEY1,fwd_adj_PEY2,fwd_adj_PEY3,fwd_adj_PKY1,fwd_adj_PKY2,fwd_adj_PKY4,fwd_adj_PHY1,fwd_adj_PHY2,fwd_adj_PVY1,fwd_adj_PVY2,fwd_adj_LFZO,fwd_adj_LCY,fwd_adj_LMUY,fwd_adj_LEY,fwd_adj_LKY,fwd_adj_LHY,fwd_adj_LVY) */
static int casadi_f23(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a000, a001, a002, a003, a004, a005, a006, a007, a008, a009, a010, a011;
casadi_real a012, a013, a014, a015, a016, a017, a018, a019, a020, a021, a022, a023;
casadi_real a024, a025, a026, a027, a028, a029, a030, a031, a032, a033, a034, a035;
casadi_real a036, a037, a038, a039, a040, a041, a042, a043, a044, a045, a046, a047;
casadi_real a048, a049, a050, a051, a052, a053, a054, a055, a056, a057, a058, a059;
casadi_real a060, a061, a062, a063, a064, a065, a066, a067, a068, a069, a070, a071;
casadi_real a072, a073, a074, a075, a076, a077, a078, a079, a080, a081, a082, a083;
casadi_real a084, a085, a086, a087, a088, a089, a090, a091, a092, a093, a094, a095;
casadi_real a096, a097, a098, a099, a100, a101, a102, a103, a104, a105, a106, a107;
casadi_real a108, a109, a110;
a000=arg[2]? arg[2][0] : 0;
a001=arg[17]? arg[17][0] : 0;
a002=a000*a001;
a003=arg[21]? arg[21][0] : 0;
a004=a002*a003;
a005=arg[10]? arg[10][0] : 0;
a006=a004*a005;
a007=arg[12]? arg[12][0] : 0;
a008=arg[1]? arg[1][0] : 0;
a009=a000*a001;
a010=a008/a009;
a011=arg[11]? arg[11][0] : 0;
a012=a010/a011;
a013=atan(a012);
a014=a007*a013;
a015=sin(a014);
a016=a006*a015;
a017=arg[18]? arg[18][0] : 0;
a018=arg[4]? arg[4][0] : 0;
a019=a017*a018;
a020=arg[19]? arg[19][0] : 0;
a021=arg[5]? arg[5][0] : 0;
a022=arg[6]? arg[6][0] : 0;
a023=a000*a001;
a023=a008-a023;
a023=a023/a009;
a024=a022*a023;
a021=a021+a024;
a024=a020*a021;
a025=a008*a024;
a026=a019*a025;
a016=a016/a026;
a027=1.;
a028=arg[20]? arg[20][0] : 0;
a029=arg[7]? arg[7][0] : 0;
a030=arg[8]? arg[8][0] : 0;
a031=a030*a023;
a029=a029+a031;
a031=a028*a029;
a032=arg[9]? arg[9][0] : 0;
a033=0.;
a034=arg[22]? arg[22][0] : 0;
a035=arg[13]? arg[13][0] : 0;
a036=arg[14]? arg[14][0] : 0;
a037=a036*a023;
a035=a035+a037;
a037=a034*a035;
a038=arg[0]? arg[0][0] : 0;
a039=arg[3]? arg[3][0] : 0;
a040=a027-a039;
a041=a038*a040;
a037=a037+a041;
a041=tan(a038);
a042=a039*a041;
a037=a037+a042;
a033=a033<=a037;
a042=a033?a027:0;
a033=!a033;
a043=-1.;
a033=a033?a043:0;
a042=a042+a033;
a032=a032*a042;
a032=a027-a032;
a033=a031*a032;
a043=casadi_fmin(a027,a033);
a044=a016*a037;
a045=a016*a037;
a046=a016*a037;
a047=atan(a046);
a045=a045-a047;
a047=a043*a045;
a044=a044-a047;
a047=atan(a044);
a048=a019*a047;
a049=cos(a048);
a050=arg[25]? arg[25][0] : 0;
a051=a025*a050;
a052=a049*a051;
a053=a019*a052;
a054=casadi_sq(a044);
a054=a027+a054;
a053=a053/a054;
a055=a043*a053;
a056=casadi_sq(a046);
a056=a027+a056;
a057=a055/a056;
a058=a016*a057;
a059=a016*a055;
a058=a058-a059;
a059=a016*a053;
a058=a058+a059;
a059=arg[53]? arg[53][0] : 0;
a060=a058*a059;
a061=arg[52]? arg[52][0] : 0;
a062=a001*a061;
a063=arg[67]? arg[67][0] : 0;
a064=a000*a063;
a062=a062+a064;
a064=a003*a062;
a065=arg[71]? arg[71][0] : 0;
a066=a002*a065;
a064=a064+a066;
a066=a005*a064;
a067=arg[60]? arg[60][0] : 0;
a068=a004*a067;
a066=a066+a068;
a068=a015*a066;
a069=cos(a014);
a070=arg[62]? arg[62][0] : 0;
a071=a013*a070;
a072=arg[51]? arg[51][0] : 0;
a073=a072/a009;
a074=a010/a009;
a075=a001*a061;
a076=a000*a063;
a075=a075+a076;
a074=a074*a075;
a073=a073-a074;
a074=a073/a011;
a076=a012/a011;
a077=arg[61]? arg[61][0] : 0;
a076=a076*a077;
a074=a074-a076;
a076=casadi_sq(a012);
a076=a027+a076;
a076=a074/a076;
a078=a007*a076;
a071=a071+a078;
a069=a069*a071;
a078=a006*a069;
a068=a068+a078;
a068=a068/a026;
a078=a016/a026;
a079=arg[68]? arg[68][0] : 0;
a080=a018*a079;
a081=arg[54]? arg[54][0] : 0;
a082=a017*a081;
a080=a080+a082;
a082=a025*a080;
a083=a024*a072;
a084=arg[69]? arg[69][0] : 0;
a085=a021*a084;
a086=arg[55]? arg[55][0] : 0;
a087=arg[56]? arg[56][0] : 0;
a088=a023*a087;
a089=a001*a061;
a090=a000*a063;
a089=a089+a090;
a089=a072-a089;
a089=a089/a009;
a090=a023/a009;
a090=a090*a075;
a089=a089-a090;
a090=a022*a089;
a088=a088+a090;
a086=a086+a088;
a088=a020*a086;
a085=a085+a088;
a088=a008*a085;
a083=a083+a088;
a088=a019*a083;
a082=a082+a088;
a078=a078*a082;
a068=a068-a078;
a078=a057*a068;
a088=a033<=a027;
a090=a027<=a033;
a090=a090+a088;
a088=a088/a090;
a090=arg[70]? arg[70][0] : 0;
a091=a029*a090;
a092=arg[57]? arg[57][0] : 0;
a093=arg[58]? arg[58][0] : 0;
a094=a023*a093;
a095=a030*a089;
a094=a094+a095;
a092=a092+a094;
a094=a028*a092;
a091=a091+a094;
a094=a032*a091;
a095=arg[59]? arg[59][0] : 0;
a095=a042*a095;
a096=a031*a095;
a094=a094-a096;
a088=a088*a094;
a094=a053*a088;
a096=a052*a080;
a097=a050*a083;
a098=arg[75]? arg[75][0] : 0;
a099=a025*a098;
a097=a097+a099;
a049=a049*a097;
a097=sin(a048);
a099=a047*a080;
a100=a037*a068;
a101=arg[72]? arg[72][0] : 0;
a102=a035*a101;
a103=arg[63]? arg[63][0] : 0;
a104=arg[64]? arg[64][0] : 0;
a105=a023*a104;
a106=a036*a089;
a105=a105+a106;
a103=a103+a105;
a105=a034*a103;
a102=a102+a105;
a105=arg[50]? arg[50][0] : 0;
a106=a040*a105;
a107=a038*a059;
a106=a106-a107;
a102=a102+a106;
a106=a041*a059;
a107=cos(a038);
a107=casadi_sq(a107);
a107=a105/a107;
a108=a039*a107;
a106=a106+a108;
a102=a102+a106;
a106=a016*a102;
a100=a100+a106;
a088=a045*a088;
a106=a037*a068;
a108=a016*a102;
a106=a106+a108;
a108=a037*a068;
a109=a016*a102;
a108=a108+a109;
a109=casadi_sq(a046);
a109=a027+a109;
a109=a108/a109;
a106=a106-a109;
a109=a043*a106;
a088=a088+a109;
a100=a100-a088;
a088=casadi_sq(a044);
a088=a027+a088;
a088=a100/a088;
a109=a019*a088;
a099=a099+a109;
a097=a097*a099;
a051=a051*a097;
a049=a049-a051;
a051=a019*a049;
a096=a096+a051;
a096=a096/a054;
a054=a053/a054;
a044=2.*a044;
a044=a044*a100;
a054=a054*a044;
a096=a096-a054;
a043=a043*a096;
a094=a094+a043;
a043=a094/a056;
a056=a057/a056;
a046=2.*a046;
a046=a046*a108;
a056=a056*a046;
a043=a043-a056;
a056=a016*a043;
a078=a078+a056;
a056=a055*a068;
a046=a016*a094;
a056=a056+a046;
a078=a078-a056;
a056=a053*a068;
a046=a016*a096;
a056=a056+a046;
a078=a078+a056;
a056=a039*a078;
a060=a060+a056;
a056=cos(a038);
a046=casadi_sq(a056);
a060=a060/a046;
a039=a039*a058;
a039=a039/a046;
a039=a039/a046;
a056=2.*a056;
a046=sin(a038);
a046=a046*a105;
a056=a056*a046;
a039=a039*a056;
a060=a060+a039;
a040=a040*a078;
a059=a058*a059;
a040=a040-a059;
a060=a060+a040;
if (res[0]!=0) res[0][0]=a060;
a060=arg[23]? arg[23][0] : 0;
a040=arg[15]? arg[15][0] : 0;
a059=arg[16]? arg[16][0] : 0;
a039=a059*a023;
a040=a040+a039;
a039=a040*a050;
a056=a060*a039;
a046=a056*a084;
a108=arg[73]? arg[73][0] : 0;
a054=a039*a108;
a044=arg[65]? arg[65][0] : 0;
a100=arg[66]? arg[66][0] : 0;
a051=a023*a100;
a097=a059*a089;
a051=a051+a097;
a044=a044+a051;
a044=a050*a044;
a040=a040*a098;
a044=a044+a040;
a040=a060*a044;
a054=a054+a040;
a040=a020*a054;
a046=a046+a040;
a040=cos(a014);
a051=a037*a057;
a097=a037*a055;
a051=a051-a097;
a097=a037*a053;
a051=a051+a097;
a097=a051/a026;
a109=a006*a097;
a110=a040*a109;
a070=a110*a070;
a066=a097*a066;
a057=a057*a102;
a043=a037*a043;
a057=a057+a043;
a055=a055*a102;
a094=a037*a094;
a055=a055+a094;
a057=a057-a055;
a102=a053*a102;
a037=a037*a096;
a102=a102+a037;
a057=a057+a102;
a102=a057/a026;
a037=a097/a026;
a037=a037*a082;
a102=a102-a037;
a006=a006*a102;
a066=a066+a006;
a040=a040*a066;
a014=sin(a014);
a014=a014*a071;
a109=a109*a014;
a040=a040-a109;
a109=a007*a040;
a070=a070+a109;
a109=casadi_sq(a012);
a109=a027+a109;
a070=a070/a109;
a007=a007*a110;
a007=a007/a109;
a109=a007/a109;
a014=2.*a012;
a014=a014*a074;
a109=a109*a014;
a070=a070-a109;
a109=a070/a011;
a014=a007/a011;
a071=a014/a011;
a071=a071*a077;
a109=a109-a071;
a071=a109/a009;
a066=a014/a009;
a066=a066/a009;
a066=a066*a075;
a071=a071-a066;
a046=a046+a071;
a071=sin(a048);
a066=a071*a050;
a016=a016/a026;
a006=a016*a051;
a037=a019*a006;
a066=a066-a037;
a085=a066*a085;
a048=cos(a048);
a048=a048*a099;
a048=a050*a048;
a071=a071*a098;
a048=a048+a071;
a080=a006*a080;
a068=a068/a026;
a026=a016/a026;
a026=a026*a082;
a068=a068-a026;
a051=a051*a068;
a016=a016*a057;
a051=a051+a016;
a019=a019*a051;
a080=a080+a019;
a048=a048-a080;
a024=a024*a048;
a085=a085+a024;
a046=a046+a085;
a085=a008*a020;
a024=a085*a060;
a080=a024*a050;
a100=a080*a100;
a019=a020*a072;
a016=a008*a084;
a019=a019+a016;
a060=a060*a019;
a108=a085*a108;
a060=a060+a108;
a050=a050*a060;
a024=a024*a098;
a050=a050+a024;
a024=a059*a050;
a100=a100+a024;
a024=a033<=a027;
a027=a027<=a033;
a027=a027+a024;
a024=a024/a027;
a027=a045*a053;
a027=a024*a027;
a033=a032*a027;
a098=a028*a033;
a093=a098*a093;
a090=a033*a090;
a053=a053*a106;
a045=a045*a096;
a053=a053+a045;
a024=a024*a053;
a032=a032*a024;
a095=a027*a095;
a032=a032-a095;
a028=a028*a032;
a090=a090+a028;
a028=a030*a090;
a093=a093+a028;
a100=a100-a093;
a093=a034*a058;
a104=a093*a104;
a101=a058*a101;
a034=a034*a078;
a101=a101+a034;
a034=a036*a101;
a104=a104+a034;
a100=a100+a104;
a104=a008*a066;
a034=a020*a104;
a087=a034*a087;
a084=a104*a084;
a066=a066*a072;
a048=a008*a048;
a066=a066+a048;
a020=a020*a066;
a084=a084+a020;
a020=a022*a084;
a087=a087+a020;
a100=a100+a087;
a087=a100/a009;
a059=a059*a080;
a030=a030*a098;
a059=a059-a030;
a036=a036*a093;
a059=a059+a036;
a022=a022*a034;
a059=a059+a022;
a022=a059/a009;
a036=a022/a009;
a036=a036*a075;
a087=a087-a036;
a046=a046+a087;
if (res[1]!=0) res[1][0]=a046;
a046=a015*a097;
a036=a005*a046;
a030=a003*a036;
a020=a030*a063;
a065=a036*a065;
a067=a046*a067;
a097=a097*a069;
a015=a015*a102;
a097=a097+a015;
a005=a005*a097;
a067=a067+a005;
a003=a003*a067;
a065=a065+a003;
a003=a001*a065;
a020=a020+a003;
a010=a010/a009;
a003=a010*a014;
a005=a023/a009;
a015=a005*a059;
a003=a003+a015;
a015=a003*a063;
a073=a073/a009;
a102=a010/a009;
a102=a102*a075;
a073=a073-a102;
a014=a014*a073;
a010=a010*a109;
a014=a014+a010;
a010=a089/a009;
a009=a005/a009;
a009=a009*a075;
a010=a010-a009;
a059=a059*a010;
a005=a005*a100;
a059=a059+a005;
a014=a014+a059;
a059=a001*a014;
a015=a015+a059;
a020=a020-a015;
a063=a022*a063;
a001=a001*a087;
a063=a063+a001;
a020=a020-a063;
if (res[2]!=0) res[2][0]=a020;
a107=a058*a107;
a041=a041*a078;
a107=a107+a041;
a105=a058*a105;
a038=a038*a078;
a105=a105+a038;
a107=a107-a105;
if (res[3]!=0) res[3][0]=a107;
a107=a047*a052;
a105=a025*a006;
a107=a107-a105;
a079=a107*a079;
a052=a052*a088;
a047=a047*a049;
a052=a052+a047;
a006=a006*a083;
a025=a025*a051;
a006=a006+a025;
a052=a052-a006;
a017=a017*a052;
a079=a079+a017;
if (res[4]!=0) res[4][0]=a079;
if (res[5]!=0) res[5][0]=a084;
a034=a034*a089;
a084=a023*a084;
a034=a034+a084;
if (res[6]!=0) res[6][0]=a034;
a034=-a090;
if (res[7]!=0) res[7][0]=a034;
a098=a098*a089;
a090=a023*a090;
a098=a098+a090;
a098=-a098;
if (res[8]!=0) res[8][0]=a098;
a027=a027*a091;
a031=a031*a024;
a027=a027+a031;
a042=a042*a027;
if (res[9]!=0) res[9][0]=a042;
a046=a046*a064;
a004=a004*a097;
a046=a046+a004;
if (res[10]!=0) res[10][0]=a046;
a074=a074/a011;
a012=a012/a011;
a011=a012/a011;
a011=a011*a077;
a074=a074-a011;
a007=a007*a074;
a012=a012*a070;
a007=a007+a012;
a007=-a007;
if (res[11]!=0) res[11][0]=a007;
a110=a110*a076;
a013=a013*a040;
a110=a110+a013;
if (res[12]!=0) res[12][0]=a110;
if (res[13]!=0) res[13][0]=a101;
a093=a093*a089;
a101=a023*a101;
a093=a093+a101;
if (res[14]!=0) res[14][0]=a093;
if (res[15]!=0) res[15][0]=a050;
a080=a080*a089;
a023=a023*a050;
a080=a080+a023;
if (res[16]!=0) res[16][0]=a080;
a030=a030*a061;
a065=a000*a065;
a030=a030+a065;
a003=a003*a061;
a014=a000*a014;
a003=a003+a014;
a030=a030-a003;
a022=a022*a061;
a000=a000*a087;
a022=a022+a000;
a030=a030-a022;
if (res[17]!=0) res[17][0]=a030;
a107=a107*a081;
a018=a018*a052;
a107=a107+a018;
if (res[18]!=0) res[18][0]=a107;
a056=a056*a072;
a008=a008*a054;
a056=a056+a008;
a104=a104*a086;
a021=a021*a066;
a104=a104+a021;
a056=a056+a104;
if (res[19]!=0) res[19][0]=a056;
a033=a033*a092;
a029=a029*a032;
a033=a033+a029;
a033=-a033;
if (res[20]!=0) res[20][0]=a033;
a036=a036*a062;
a002=a002*a067;
a036=a036+a002;
if (res[21]!=0) res[21][0]=a036;
a058=a058*a103;
a035=a035*a078;
a058=a058+a035;
if (res[22]!=0) res[22][0]=a058;
a039=a039*a019;
a085=a085*a044;
a039=a039+a085;
if (res[23]!=0) res[23][0]=a039;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_mf_lateral(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f23(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_mf_lateral_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_mf_lateral_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_mf_lateral_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_mf_lateral_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_mf_lateral_n_in(void) { return 76;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_mf_lateral_n_out(void) { return 24;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_mf_lateral_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_mf_lateral_name_in(casadi_int i) {
switch (i) {
case 0: return "alpha";
case 1: return "Fz";
case 2: return "FNOMIN";
case 3: return "tangent";
case 4: return "PCY1";
case 5: return "PDY1";
case 6: return "PDY2";
case 7: return "PEY1";
case 8: return "PEY2";
case 9: return "PEY3";
case 10: return "PKY1";
case 11: return "PKY2";
case 12: return "PKY4";
case 13: return "PHY1";
case 14: return "PHY2";
case 15: return "PVY1";
case 16: return "PVY2";
case 17: return "LFZO";
case 18: return "LCY";
case 19: return "LMUY";
case 20: return "LEY";
case 21: return "LKY";
case 22: return "LHY";
case 23: return "LVY";
case 24: return "out_F_mf";
case 25: return "adj_F_mf";
case 26: return "out_adj_alpha";
case 27: return "out_adj_Fz";
case 28: return "out_adj_FNOMIN";
case 29: return "out_adj_tangent";
case 30: return "out_adj_PCY1";
case 31: return "out_adj_PDY1";
case 32: return "out_adj_PDY2";
case 33: return "out_adj_PEY1";
case 34: return "out_adj_PEY2";
case 35: return "out_adj_PEY3";
case 36: return "out_adj_PKY1";
case 37: return "out_adj_PKY2";
case 38: return "out_adj_PKY4";
case 39: return "out_adj_PHY1";
case 40: return "out_adj_PHY2";
case 41: return "out_adj_PVY1";
case 42: return "out_adj_PVY2";
case 43: return "out_adj_LFZO";
case 44: return "out_adj_LCY";
case 45: return "out_adj_LMUY";
case 46: return "out_adj_LEY";
case 47: return "out_adj_LKY";
case 48: return "out_adj_LHY";
case 49: return "out_adj_LVY";
case 50: return "fwd_alpha";
case 51: return "fwd_Fz";
case 52: return "fwd_FNOMIN";
case 53: return "fwd_tangent";
case 54: return "fwd_PCY1";
case 55: return "fwd_PDY1";
case 56: return "fwd_PDY2";
case 57: return "fwd_PEY1";
case 58: return "fwd_PEY2";
case 59: return "fwd_PEY3";
case 60: return "fwd_PKY1";
case 61: return "fwd_PKY2";
case 62: return "fwd_PKY4";
case 63: return "fwd_PHY1";
case 64: return "fwd_PHY2";
case 65: return "fwd_PVY1";
case 66: return "fwd_PVY2";
case 67: return "fwd_LFZO";
case 68: return "fwd_LCY";
case 69: return "fwd_LMUY";
case 70: return "fwd_LEY";
case 71: return "fwd_LKY";
case 72: return "fwd_LHY";
case 73: return "fwd_LVY";
case 74: return "fwd_out_F_mf";
case 75: return "fwd_adj_F_mf";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_mf_lateral_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_alpha";
case 1: return "fwd_adj_Fz";
case 2: return "fwd_adj_FNOMIN";
case 3: return "fwd_adj_tangent";
case 4: return "fwd_adj_PCY1";
case 5: return "fwd_adj_PDY1";
case 6: return "fwd_adj_PDY2";
case 7: return "fwd_adj_PEY1";
case 8: return "fwd_adj_PEY2";
case 9: return "fwd_adj_PEY3";
case 10: return "fwd_adj_PKY1";
case 11: return "fwd_adj_PKY2";
case 12: return "fwd_adj_PKY4";
case 13: return "fwd_adj_PHY1";
case 14: return "fwd_adj_PHY2";
case 15: return "fwd_adj_PVY1";
case 16: return "fwd_adj_PVY2";
case 17: return "fwd_adj_LFZO";
case 18: return "fwd_adj_LCY";
case 19: return "fwd_adj_LMUY";
case 20: return "fwd_adj_LEY";
case 21: return "fwd_adj_LKY";
case 22: return "fwd_adj_LHY";
case 23: return "fwd_adj_LVY";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_mf_lateral_sparsity_in(casadi_int i) {
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
case 20: return casadi_s0;
case 21: return casadi_s0;
case 22: return casadi_s0;
case 23: return casadi_s0;
case 24: return casadi_s1;
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
case 66: return casadi_s0;
case 67: return casadi_s0;
case 68: return casadi_s0;
case 69: return casadi_s0;
case 70: return casadi_s0;
case 71: return casadi_s0;
case 72: return casadi_s0;
case 73: return casadi_s0;
case 74: return casadi_s1;
case 75: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_mf_lateral_sparsity_out(casadi_int i) {
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
case 20: return casadi_s0;
case 21: return casadi_s0;
case 22: return casadi_s0;
case 23: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_mf_lateral_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 76;
if (sz_res) *sz_res = 24;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_mf_lateral_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 76*sizeof(const casadi_real*);
if (sz_res) *sz_res = 24*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* relative_deflection:(delta_tire,d_tire)->(e_z) */
static int casadi_f24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1;
a0=arg[0]? arg[0][0] : 0;
a1=arg[1]? arg[1][0] : 0;
a0=a0/a1;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int relative_deflection(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f24(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int relative_deflection_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void relative_deflection_release(int mem) {
}
CASADI_SYMBOL_EXPORT void relative_deflection_incref(void) {
}
CASADI_SYMBOL_EXPORT void relative_deflection_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int relative_deflection_n_in(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_int relative_deflection_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real relative_deflection_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* relative_deflection_name_in(casadi_int i) {
switch (i) {
case 0: return "delta_tire";
case 1: return "d_tire";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* relative_deflection_name_out(casadi_int i) {
switch (i) {
case 0: return "e_z";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* relative_deflection_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* relative_deflection_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int relative_deflection_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 2;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int relative_deflection_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 2*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_relative_deflection:(delta_tire,d_tire,out_e_z[1x1,0nz],fwd_delta_tire,fwd_d_tire)->(fwd_e_z) */
static int casadi_f25(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2;
a0=arg[3]? arg[3][0] : 0;
a1=arg[1]? arg[1][0] : 0;
a0=a0/a1;
a2=arg[0]? arg[0][0] : 0;
a2=a2/a1;
a2=a2/a1;
a1=arg[4]? arg[4][0] : 0;
a2=a2*a1;
a0=a0-a2;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_relative_deflection(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f25(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_relative_deflection_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_relative_deflection_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_relative_deflection_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_relative_deflection_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_relative_deflection_n_in(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_relative_deflection_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_relative_deflection_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_relative_deflection_name_in(casadi_int i) {
switch (i) {
case 0: return "delta_tire";
case 1: return "d_tire";
case 2: return "out_e_z";
case 3: return "fwd_delta_tire";
case 4: return "fwd_d_tire";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_relative_deflection_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_e_z";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_relative_deflection_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s1;
case 3: return casadi_s0;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_relative_deflection_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_relative_deflection_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_relative_deflection_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_relative_deflection:(delta_tire,d_tire,out_e_z[1x1,0nz],adj_e_z)->(adj_delta_tire,adj_d_tire) */
static int casadi_f26(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2;
a0=arg[3]? arg[3][0] : 0;
a1=arg[1]? arg[1][0] : 0;
a2=a0/a1;
if (res[0]!=0) res[0][0]=a2;
a2=arg[0]? arg[0][0] : 0;
a2=a2/a1;
a2=a2/a1;
a2=a2*a0;
a2=-a2;
if (res[1]!=0) res[1][0]=a2;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_relative_deflection(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f26(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_relative_deflection_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_relative_deflection_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_relative_deflection_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_relative_deflection_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_relative_deflection_n_in(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_int adj1_relative_deflection_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real adj1_relative_deflection_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_relative_deflection_name_in(casadi_int i) {
switch (i) {
case 0: return "delta_tire";
case 1: return "d_tire";
case 2: return "out_e_z";
case 3: return "adj_e_z";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_relative_deflection_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_delta_tire";
case 1: return "adj_d_tire";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_relative_deflection_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s1;
case 3: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_relative_deflection_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_relative_deflection_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 4;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_relative_deflection_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 4*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_relative_deflection:(delta_tire,d_tire,out_e_z[1x1,0nz],adj_e_z,out_adj_delta_tire[1x1,0nz],out_adj_d_tire[1x1,0nz],fwd_delta_tire,fwd_d_tire,fwd_out_e_z[1x1,0nz],fwd_adj_e_z)->(fwd_adj_delta_tire,fwd_adj_d_tire) */
static int casadi_f27(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5, a6;
a0=arg[9]? arg[9][0] : 0;
a1=arg[1]? arg[1][0] : 0;
a2=a0/a1;
a3=arg[3]? arg[3][0] : 0;
a4=a3/a1;
a4=a4/a1;
a5=arg[7]? arg[7][0] : 0;
a4=a4*a5;
a2=a2-a4;
if (res[0]!=0) res[0][0]=a2;
a2=arg[6]? arg[6][0] : 0;
a2=a2/a1;
a4=arg[0]? arg[0][0] : 0;
a4=a4/a1;
a6=a4/a1;
a6=a6*a5;
a2=a2-a6;
a2=a2/a1;
a4=a4/a1;
a1=a4/a1;
a1=a1*a5;
a2=a2-a1;
a3=a3*a2;
a4=a4*a0;
a3=a3+a4;
a3=-a3;
if (res[1]!=0) res[1][0]=a3;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_relative_deflection(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f27(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_relative_deflection_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_relative_deflection_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_relative_deflection_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_relative_deflection_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_relative_deflection_n_in(void) { return 10;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_relative_deflection_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_relative_deflection_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_relative_deflection_name_in(casadi_int i) {
switch (i) {
case 0: return "delta_tire";
case 1: return "d_tire";
case 2: return "out_e_z";
case 3: return "adj_e_z";
case 4: return "out_adj_delta_tire";
case 5: return "out_adj_d_tire";
case 6: return "fwd_delta_tire";
case 7: return "fwd_d_tire";
case 8: return "fwd_out_e_z";
case 9: return "fwd_adj_e_z";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_relative_deflection_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_delta_tire";
case 1: return "fwd_adj_d_tire";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_relative_deflection_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s1;
case 3: return casadi_s0;
case 4: return casadi_s1;
case 5: return casadi_s1;
case 6: return casadi_s0;
case 7: return casadi_s0;
case 8: return casadi_s1;
case 9: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_relative_deflection_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_relative_deflection_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 10;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_relative_deflection_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* outside_diameter:(d_rim,w_tire)->(d_tire) */
static int casadi_f28(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2;
a0=arg[0]? arg[0][0] : 0;
a1=1.8400000000000001e+00;
a2=arg[1]? arg[1][0] : 0;
a1=a1*a2;
a0=a0+a1;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int outside_diameter(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f28(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int outside_diameter_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void outside_diameter_release(int mem) {
}
CASADI_SYMBOL_EXPORT void outside_diameter_incref(void) {
}
CASADI_SYMBOL_EXPORT void outside_diameter_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int outside_diameter_n_in(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_int outside_diameter_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real outside_diameter_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* outside_diameter_name_in(casadi_int i) {
switch (i) {
case 0: return "d_rim";
case 1: return "w_tire";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* outside_diameter_name_out(casadi_int i) {
switch (i) {
case 0: return "d_tire";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* outside_diameter_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* outside_diameter_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int outside_diameter_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 2;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int outside_diameter_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 2*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_outside_diameter:(d_rim,w_tire,out_d_tire[1x1,0nz],fwd_d_rim,fwd_w_tire)->(fwd_d_tire) */
static int casadi_f29(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2;
a0=arg[3]? arg[3][0] : 0;
a1=1.8400000000000001e+00;
a2=arg[4]? arg[4][0] : 0;
a1=a1*a2;
a0=a0+a1;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_outside_diameter(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f29(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_outside_diameter_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_outside_diameter_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_outside_diameter_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_outside_diameter_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_outside_diameter_n_in(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_outside_diameter_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_outside_diameter_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_outside_diameter_name_in(casadi_int i) {
switch (i) {
case 0: return "d_rim";
case 1: return "w_tire";
case 2: return "out_d_tire";
case 3: return "fwd_d_rim";
case 4: return "fwd_w_tire";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_outside_diameter_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_d_tire";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_outside_diameter_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s1;
case 3: return casadi_s0;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_outside_diameter_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_outside_diameter_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_outside_diameter_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_outside_diameter:(d_rim,w_tire,out_d_tire[1x1,0nz],adj_d_tire)->(adj_d_rim,adj_w_tire) */
static int casadi_f30(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1;
a0=arg[3]? arg[3][0] : 0;
if (res[0]!=0) res[0][0]=a0;
a1=1.8400000000000001e+00;
a1=a1*a0;
if (res[1]!=0) res[1][0]=a1;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_outside_diameter(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f30(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_outside_diameter_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_outside_diameter_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_outside_diameter_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_outside_diameter_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_outside_diameter_n_in(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_int adj1_outside_diameter_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real adj1_outside_diameter_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_outside_diameter_name_in(casadi_int i) {
switch (i) {
case 0: return "d_rim";
case 1: return "w_tire";
case 2: return "out_d_tire";
case 3: return "adj_d_tire";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_outside_diameter_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_d_rim";
case 1: return "adj_w_tire";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_outside_diameter_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s1;
case 3: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_outside_diameter_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_outside_diameter_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 4;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_outside_diameter_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 4*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_outside_diameter:(d_rim,w_tire,out_d_tire[1x1,0nz],adj_d_tire,out_adj_d_rim[1x1,0nz],out_adj_w_tire[1x1,0nz],fwd_d_rim,fwd_w_tire,fwd_out_d_tire[1x1,0nz],fwd_adj_d_tire)->(fwd_adj_d_rim,fwd_adj_w_tire) */
static int casadi_f31(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1;
a0=arg[9]? arg[9][0] : 0;
if (res[0]!=0) res[0][0]=a0;
a1=1.8400000000000001e+00;
a1=a1*a0;
if (res[1]!=0) res[1][0]=a1;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_outside_diameter(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f31(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_outside_diameter_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_outside_diameter_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_outside_diameter_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_outside_diameter_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_outside_diameter_n_in(void) { return 10;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_outside_diameter_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_outside_diameter_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_outside_diameter_name_in(casadi_int i) {
switch (i) {
case 0: return "d_rim";
case 1: return "w_tire";
case 2: return "out_d_tire";
case 3: return "adj_d_tire";
case 4: return "out_adj_d_rim";
case 5: return "out_adj_w_tire";
case 6: return "fwd_d_rim";
case 7: return "fwd_w_tire";
case 8: return "fwd_out_d_tire";
case 9: return "fwd_adj_d_tire";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_outside_diameter_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_d_rim";
case 1: return "fwd_adj_w_tire";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_outside_diameter_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s1;
case 3: return casadi_s0;
case 4: return casadi_s1;
case 5: return casadi_s1;
case 6: return casadi_s0;
case 7: return casadi_s0;
case 8: return casadi_s1;
case 9: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_outside_diameter_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_outside_diameter_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 10;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_outside_diameter_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* magic_formula:(alpha_bar,B1,C1,D1,E1)->(F_bar) */
static int casadi_f32(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5;
a0=arg[3]? arg[3][0] : 0;
a1=arg[2]? arg[2][0] : 0;
a2=arg[1]? arg[1][0] : 0;
a3=arg[0]? arg[0][0] : 0;
a4=1.;
a5=arg[4]? arg[4][0] : 0;
a4=a4-a5;
a4=a3*a4;
a3=a2*a3;
a3=atan(a3);
a5=a5*a3;
a5=a5/a2;
a4=a4+a5;
a2=a2*a4;
a2=atan(a2);
a1=a1*a2;
a1=sin(a1);
a0=a0*a1;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int magic_formula(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f32(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int magic_formula_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void magic_formula_release(int mem) {
}
CASADI_SYMBOL_EXPORT void magic_formula_incref(void) {
}
CASADI_SYMBOL_EXPORT void magic_formula_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int magic_formula_n_in(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_int magic_formula_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real magic_formula_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* magic_formula_name_in(casadi_int i) {
switch (i) {
case 0: return "alpha_bar";
case 1: return "B1";
case 2: return "C1";
case 3: return "D1";
case 4: return "E1";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* magic_formula_name_out(casadi_int i) {
switch (i) {
case 0: return "F_bar";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* magic_formula_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* magic_formula_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int magic_formula_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int magic_formula_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_magic_formula:(alpha_bar,B1,C1,D1,E1,out_F_bar[1x1,0nz],fwd_alpha_bar,fwd_B1,fwd_C1,fwd_D1,fwd_E1)->(fwd_F_bar) */
static int casadi_f33(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18;
a00=arg[2]? arg[2][0] : 0;
a01=arg[1]? arg[1][0] : 0;
a02=arg[0]? arg[0][0] : 0;
a03=1.;
a04=arg[4]? arg[4][0] : 0;
a05=a03-a04;
a06=a02*a05;
a07=a01*a02;
a08=atan(a07);
a09=a04*a08;
a09=a09/a01;
a06=a06+a09;
a10=a01*a06;
a11=atan(a10);
a12=a00*a11;
a13=sin(a12);
a14=arg[9]? arg[9][0] : 0;
a13=a13*a14;
a14=arg[3]? arg[3][0] : 0;
a12=cos(a12);
a15=arg[8]? arg[8][0] : 0;
a11=a11*a15;
a15=arg[7]? arg[7][0] : 0;
a06=a06*a15;
a16=arg[6]? arg[6][0] : 0;
a05=a05*a16;
a17=arg[10]? arg[10][0] : 0;
a18=a02*a17;
a05=a05-a18;
a08=a08*a17;
a02=a02*a15;
a16=a01*a16;
a02=a02+a16;
a07=casadi_sq(a07);
a07=a03+a07;
a02=a02/a07;
a04=a04*a02;
a08=a08+a04;
a08=a08/a01;
a09=a09/a01;
a09=a09*a15;
a08=a08-a09;
a05=a05+a08;
a01=a01*a05;
a06=a06+a01;
a10=casadi_sq(a10);
a03=a03+a10;
a06=a06/a03;
a00=a00*a06;
a11=a11+a00;
a12=a12*a11;
a14=a14*a12;
a13=a13+a14;
if (res[0]!=0) res[0][0]=a13;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_magic_formula(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f33(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_magic_formula_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_magic_formula_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_magic_formula_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_magic_formula_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_magic_formula_n_in(void) { return 11;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_magic_formula_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_magic_formula_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_magic_formula_name_in(casadi_int i) {
switch (i) {
case 0: return "alpha_bar";
case 1: return "B1";
case 2: return "C1";
case 3: return "D1";
case 4: return "E1";
case 5: return "out_F_bar";
case 6: return "fwd_alpha_bar";
case 7: return "fwd_B1";
case 8: return "fwd_C1";
case 9: return "fwd_D1";
case 10: return "fwd_E1";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_magic_formula_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_F_bar";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_magic_formula_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s1;
case 6: return casadi_s0;
case 7: return casadi_s0;
case 8: return casadi_s0;
case 9: return casadi_s0;
case 10: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_magic_formula_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_magic_formula_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 11;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_magic_formula_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 11*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_magic_formula:(alpha_bar,B1,C1,D1,E1,out_F_bar[1x1,0nz],adj_F_bar)->(adj_alpha_bar,adj_B1,adj_C1,adj_D1,adj_E1) */
static int casadi_f34(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15;
a00=arg[1]? arg[1][0] : 0;
a01=arg[4]? arg[4][0] : 0;
a02=arg[2]? arg[2][0] : 0;
a03=arg[0]? arg[0][0] : 0;
a04=1.;
a05=a04-a01;
a06=a03*a05;
a07=a00*a03;
a08=atan(a07);
a09=a01*a08;
a09=a09/a00;
a06=a06+a09;
a10=a00*a06;
a11=atan(a10);
a12=a02*a11;
a13=cos(a12);
a14=arg[3]? arg[3][0] : 0;
a15=arg[6]? arg[6][0] : 0;
a14=a14*a15;
a13=a13*a14;
a02=a02*a13;
a10=casadi_sq(a10);
a10=a04+a10;
a02=a02/a10;
a01=a01*a02;
a07=casadi_sq(a07);
a04=a04+a07;
a01=a01/a04;
a04=a00*a01;
a07=a00*a02;
a05=a05*a07;
a04=a04+a05;
if (res[0]!=0) res[0][0]=a04;
a06=a06*a02;
a09=a09/a00;
a09=a09*a07;
a06=a06-a09;
a01=a03*a01;
a06=a06+a01;
if (res[1]!=0) res[1][0]=a06;
a11=a11*a13;
if (res[2]!=0) res[2][0]=a11;
a12=sin(a12);
a12=a12*a15;
if (res[3]!=0) res[3][0]=a12;
a08=a08*a02;
a03=a03*a07;
a08=a08-a03;
if (res[4]!=0) res[4][0]=a08;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_magic_formula(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f34(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_magic_formula_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_magic_formula_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_magic_formula_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_magic_formula_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_magic_formula_n_in(void) { return 7;}
CASADI_SYMBOL_EXPORT casadi_int adj1_magic_formula_n_out(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_real adj1_magic_formula_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_magic_formula_name_in(casadi_int i) {
switch (i) {
case 0: return "alpha_bar";
case 1: return "B1";
case 2: return "C1";
case 3: return "D1";
case 4: return "E1";
case 5: return "out_F_bar";
case 6: return "adj_F_bar";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_magic_formula_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_alpha_bar";
case 1: return "adj_B1";
case 2: return "adj_C1";
case 3: return "adj_D1";
case 4: return "adj_E1";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_magic_formula_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s1;
case 6: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_magic_formula_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_magic_formula_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 7;
if (sz_res) *sz_res = 5;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_magic_formula_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 7*sizeof(const casadi_real*);
if (sz_res) *sz_res = 5*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_magic_formula:(alpha_bar,B1,C1,D1,E1,out_F_bar[1x1,0nz],adj_F_bar,out_adj_alpha_bar[1x1,0nz],out_adj_B1[1x1,0nz],out_adj_C1[1x1,0nz],out_adj_D1[1x1,0nz],out_adj_E1[1x1,0nz],fwd_alpha_bar,fwd_B1,fwd_C1,fwd_D1,fwd_E1,fwd_out_F_bar[1x1,0nz],fwd_adj_F_bar)->(fwd_adj_alpha_bar,fwd_adj_B1,fwd_adj_C1,fwd_adj_D1,fwd_adj_E1) */
static int casadi_f35(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
a00=arg[4]? arg[4][0] : 0;
a01=arg[2]? arg[2][0] : 0;
a02=arg[1]? arg[1][0] : 0;
a03=arg[0]? arg[0][0] : 0;
a04=1.;
a05=a04-a00;
a06=a03*a05;
a07=a02*a03;
a08=atan(a07);
a09=a00*a08;
a09=a09/a02;
a06=a06+a09;
a10=a02*a06;
a11=atan(a10);
a12=a01*a11;
a13=cos(a12);
a14=arg[3]? arg[3][0] : 0;
a15=arg[6]? arg[6][0] : 0;
a16=a14*a15;
a17=a13*a16;
a18=a01*a17;
a19=casadi_sq(a10);
a19=a04+a19;
a18=a18/a19;
a20=a00*a18;
a21=casadi_sq(a07);
a21=a04+a21;
a20=a20/a21;
a22=arg[13]? arg[13][0] : 0;
a23=a20*a22;
a24=arg[16]? arg[16][0] : 0;
a25=a18*a24;
a26=arg[14]? arg[14][0] : 0;
a27=a17*a26;
a28=arg[15]? arg[15][0] : 0;
a28=a15*a28;
a29=arg[18]? arg[18][0] : 0;
a14=a14*a29;
a28=a28+a14;
a13=a13*a28;
a28=sin(a12);
a26=a11*a26;
a14=a06*a22;
a30=arg[12]? arg[12][0] : 0;
a31=a05*a30;
a32=a03*a24;
a31=a31-a32;
a32=a08*a24;
a33=a03*a22;
a34=a02*a30;
a33=a33+a34;
a34=casadi_sq(a07);
a34=a04+a34;
a34=a33/a34;
a35=a00*a34;
a32=a32+a35;
a32=a32/a02;
a35=a09/a02;
a35=a35*a22;
a32=a32-a35;
a31=a31+a32;
a35=a02*a31;
a14=a14+a35;
a35=casadi_sq(a10);
a04=a04+a35;
a04=a14/a04;
a35=a01*a04;
a26=a26+a35;
a28=a28*a26;
a16=a16*a28;
a13=a13-a16;
a01=a01*a13;
a27=a27+a01;
a27=a27/a19;
a19=a18/a19;
a10=2.*a10;
a10=a10*a14;
a19=a19*a10;
a27=a27-a19;
a00=a00*a27;
a25=a25+a00;
a25=a25/a21;
a21=a20/a21;
a07=2.*a07;
a07=a07*a33;
a21=a21*a07;
a25=a25-a21;
a21=a02*a25;
a23=a23+a21;
a21=a18*a22;
a07=a02*a27;
a21=a21+a07;
a05=a05*a21;
a07=a02*a18;
a24=a07*a24;
a05=a05-a24;
a23=a23+a05;
if (res[0]!=0) res[0][0]=a23;
a31=a18*a31;
a06=a06*a27;
a31=a31+a06;
a32=a32/a02;
a09=a09/a02;
a02=a09/a02;
a02=a02*a22;
a32=a32-a02;
a32=a07*a32;
a09=a09*a21;
a32=a32+a09;
a31=a31-a32;
a20=a20*a30;
a25=a03*a25;
a20=a20+a25;
a31=a31+a20;
if (res[1]!=0) res[1][0]=a31;
a17=a17*a04;
a11=a11*a13;
a17=a17+a11;
if (res[2]!=0) res[2][0]=a17;
a17=cos(a12);
a17=a17*a26;
a15=a15*a17;
a12=sin(a12);
a12=a12*a29;
a15=a15+a12;
if (res[3]!=0) res[3][0]=a15;
a18=a18*a34;
a08=a08*a27;
a18=a18+a08;
a07=a07*a30;
a03=a03*a21;
a07=a07+a03;
a18=a18-a07;
if (res[4]!=0) res[4][0]=a18;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_magic_formula(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f35(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_magic_formula_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_magic_formula_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_magic_formula_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_magic_formula_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_magic_formula_n_in(void) { return 19;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_magic_formula_n_out(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_magic_formula_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_magic_formula_name_in(casadi_int i) {
switch (i) {
case 0: return "alpha_bar";
case 1: return "B1";
case 2: return "C1";
case 3: return "D1";
case 4: return "E1";
case 5: return "out_F_bar";
case 6: return "adj_F_bar";
case 7: return "out_adj_alpha_bar";
case 8: return "out_adj_B1";
case 9: return "out_adj_C1";
case 10: return "out_adj_D1";
case 11: return "out_adj_E1";
case 12: return "fwd_alpha_bar";
case 13: return "fwd_B1";
case 14: return "fwd_C1";
case 15: return "fwd_D1";
case 16: return "fwd_E1";
case 17: return "fwd_out_F_bar";
case 18: return "fwd_adj_F_bar";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_magic_formula_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_alpha_bar";
case 1: return "fwd_adj_B1";
case 2: return "fwd_adj_C1";
case 3: return "fwd_adj_D1";
case 4: return "fwd_adj_E1";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_magic_formula_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s1;
case 6: return casadi_s0;
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
case 17: return casadi_s1;
case 18: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_magic_formula_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_magic_formula_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 19;
if (sz_res) *sz_res = 5;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_magic_formula_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 19*sizeof(const casadi_real*);
if (sz_res) *sz_res = 5*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* measured_coefficients:(alpha,F_y,F_peak,Fz)->(C_c,mu) */
static int casadi_f36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2;
a0=arg[1]? arg[1][0] : 0;
a1=arg[3]? arg[3][0] : 0;
a2=arg[0]? arg[0][0] : 0;
a2=a1*a2;
a0=a0/a2;
if (res[0]!=0) res[0][0]=a0;
a0=arg[2]? arg[2][0] : 0;
a0=a0/a1;
if (res[1]!=0) res[1][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int measured_coefficients(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f36(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int measured_coefficients_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void measured_coefficients_release(int mem) {
}
CASADI_SYMBOL_EXPORT void measured_coefficients_incref(void) {
}
CASADI_SYMBOL_EXPORT void measured_coefficients_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int measured_coefficients_n_in(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_int measured_coefficients_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real measured_coefficients_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* measured_coefficients_name_in(casadi_int i) {
switch (i) {
case 0: return "alpha";
case 1: return "F_y";
case 2: return "F_peak";
case 3: return "Fz";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* measured_coefficients_name_out(casadi_int i) {
switch (i) {
case 0: return "C_c";
case 1: return "mu";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* measured_coefficients_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* measured_coefficients_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int measured_coefficients_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 4;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int measured_coefficients_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 4*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_measured_coefficients:(alpha,F_y,F_peak,Fz,out_C_c[1x1,0nz],out_mu[1x1,0nz],fwd_alpha,fwd_F_y,fwd_F_peak,fwd_Fz)->(fwd_C_c,fwd_mu) */
static int casadi_f37(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5;
a0=arg[7]? arg[7][0] : 0;
a1=arg[3]? arg[3][0] : 0;
a2=arg[0]? arg[0][0] : 0;
a3=a1*a2;
a0=a0/a3;
a4=arg[1]? arg[1][0] : 0;
a4=a4/a3;
a4=a4/a3;
a3=arg[9]? arg[9][0] : 0;
a2=a2*a3;
a5=arg[6]? arg[6][0] : 0;
a5=a1*a5;
a2=a2+a5;
a4=a4*a2;
a0=a0-a4;
if (res[0]!=0) res[0][0]=a0;
a0=arg[8]? arg[8][0] : 0;
a0=a0/a1;
a4=arg[2]? arg[2][0] : 0;
a4=a4/a1;
a4=a4/a1;
a4=a4*a3;
a0=a0-a4;
if (res[1]!=0) res[1][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_measured_coefficients(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f37(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_measured_coefficients_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_measured_coefficients_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_measured_coefficients_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_measured_coefficients_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_measured_coefficients_n_in(void) { return 10;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_measured_coefficients_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_measured_coefficients_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_measured_coefficients_name_in(casadi_int i) {
switch (i) {
case 0: return "alpha";
case 1: return "F_y";
case 2: return "F_peak";
case 3: return "Fz";
case 4: return "out_C_c";
case 5: return "out_mu";
case 6: return "fwd_alpha";
case 7: return "fwd_F_y";
case 8: return "fwd_F_peak";
case 9: return "fwd_Fz";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_measured_coefficients_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_C_c";
case 1: return "fwd_mu";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_measured_coefficients_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s1;
case 5: return casadi_s1;
case 6: return casadi_s0;
case 7: return casadi_s0;
case 8: return casadi_s0;
case 9: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_measured_coefficients_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_measured_coefficients_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 10;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_measured_coefficients_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_measured_coefficients:(alpha,F_y,F_peak,Fz,out_C_c[1x1,0nz],out_mu[1x1,0nz],adj_C_c,adj_mu)->(adj_alpha,adj_F_y,adj_F_peak,adj_Fz) */
static int casadi_f38(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5;
a0=arg[3]? arg[3][0] : 0;
a1=arg[1]? arg[1][0] : 0;
a2=arg[0]? arg[0][0] : 0;
a3=a0*a2;
a1=a1/a3;
a1=a1/a3;
a4=arg[6]? arg[6][0] : 0;
a1=a1*a4;
a5=a0*a1;
a5=-a5;
if (res[0]!=0) res[0][0]=a5;
a4=a4/a3;
if (res[1]!=0) res[1][0]=a4;
a4=arg[7]? arg[7][0] : 0;
a3=a4/a0;
if (res[2]!=0) res[2][0]=a3;
a3=arg[2]? arg[2][0] : 0;
a3=a3/a0;
a3=a3/a0;
a3=a3*a4;
a2=a2*a1;
a3=a3+a2;
a3=-a3;
if (res[3]!=0) res[3][0]=a3;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_measured_coefficients(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f38(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_measured_coefficients_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_measured_coefficients_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_measured_coefficients_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_measured_coefficients_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_measured_coefficients_n_in(void) { return 8;}
CASADI_SYMBOL_EXPORT casadi_int adj1_measured_coefficients_n_out(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_real adj1_measured_coefficients_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_measured_coefficients_name_in(casadi_int i) {
switch (i) {
case 0: return "alpha";
case 1: return "F_y";
case 2: return "F_peak";
case 3: return "Fz";
case 4: return "out_C_c";
case 5: return "out_mu";
case 6: return "adj_C_c";
case 7: return "adj_mu";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_measured_coefficients_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_alpha";
case 1: return "adj_F_y";
case 2: return "adj_F_peak";
case 3: return "adj_Fz";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_measured_coefficients_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s1;
case 5: return casadi_s1;
case 6: return casadi_s0;
case 7: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_measured_coefficients_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_measured_coefficients_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 8;
if (sz_res) *sz_res = 4;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_measured_coefficients_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 8*sizeof(const casadi_real*);
if (sz_res) *sz_res = 4*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_measured_coefficients:(alpha,F_y,F_peak,Fz,out_C_c[1x1,0nz],out_mu[1x1,0nz],adj_C_c,adj_mu,out_adj_alpha[1x1,0nz],out_adj_F_y[1x1,0nz],out_adj_F_peak[1x1,0nz],out_adj_Fz[1x1,0nz],fwd_alpha,fwd_F_y,fwd_F_peak,fwd_Fz,fwd_out_C_c[1x1,0nz],fwd_out_mu[1x1,0nz],fwd_adj_C_c,fwd_adj_mu)->(fwd_adj_alpha,fwd_adj_F_y,fwd_adj_F_peak,fwd_adj_Fz) */
static int casadi_f39(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12;
a00=arg[1]? arg[1][0] : 0;
a01=arg[3]? arg[3][0] : 0;
a02=arg[0]? arg[0][0] : 0;
a03=a01*a02;
a00=a00/a03;
a04=a00/a03;
a05=arg[6]? arg[6][0] : 0;
a06=a04*a05;
a07=arg[15]? arg[15][0] : 0;
a08=a06*a07;
a09=arg[13]? arg[13][0] : 0;
a09=a09/a03;
a00=a00/a03;
a10=a02*a07;
a11=arg[12]? arg[12][0] : 0;
a12=a01*a11;
a10=a10+a12;
a00=a00*a10;
a09=a09-a00;
a09=a09/a03;
a00=a04/a03;
a00=a00*a10;
a09=a09-a00;
a09=a05*a09;
a00=arg[18]? arg[18][0] : 0;
a04=a04*a00;
a09=a09+a04;
a04=a01*a09;
a08=a08+a04;
a08=-a08;
if (res[0]!=0) res[0][0]=a08;
a00=a00/a03;
a05=a05/a03;
a05=a05/a03;
a05=a05*a10;
a00=a00-a05;
if (res[1]!=0) res[1][0]=a00;
a00=arg[19]? arg[19][0] : 0;
a05=a00/a01;
a10=arg[7]? arg[7][0] : 0;
a03=a10/a01;
a03=a03/a01;
a03=a03*a07;
a05=a05-a03;
if (res[2]!=0) res[2][0]=a05;
a05=arg[14]? arg[14][0] : 0;
a05=a05/a01;
a03=arg[2]? arg[2][0] : 0;
a03=a03/a01;
a08=a03/a01;
a08=a08*a07;
a05=a05-a08;
a05=a05/a01;
a03=a03/a01;
a01=a03/a01;
a01=a01*a07;
a05=a05-a01;
a10=a10*a05;
a03=a03*a00;
a10=a10+a03;
a06=a06*a11;
a02=a02*a09;
a06=a06+a02;
a10=a10+a06;
a10=-a10;
if (res[3]!=0) res[3][0]=a10;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_measured_coefficients(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f39(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_measured_coefficients_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_measured_coefficients_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_measured_coefficients_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_measured_coefficients_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_measured_coefficients_n_in(void) { return 20;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_measured_coefficients_n_out(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_measured_coefficients_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_measured_coefficients_name_in(casadi_int i) {
switch (i) {
case 0: return "alpha";
case 1: return "F_y";
case 2: return "F_peak";
case 3: return "Fz";
case 4: return "out_C_c";
case 5: return "out_mu";
case 6: return "adj_C_c";
case 7: return "adj_mu";
case 8: return "out_adj_alpha";
case 9: return "out_adj_F_y";
case 10: return "out_adj_F_peak";
case 11: return "out_adj_Fz";
case 12: return "fwd_alpha";
case 13: return "fwd_F_y";
case 14: return "fwd_F_peak";
case 15: return "fwd_Fz";
case 16: return "fwd_out_C_c";
case 17: return "fwd_out_mu";
case 18: return "fwd_adj_C_c";
case 19: return "fwd_adj_mu";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_measured_coefficients_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_alpha";
case 1: return "fwd_adj_F_y";
case 2: return "fwd_adj_F_peak";
case 3: return "fwd_adj_Fz";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_measured_coefficients_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s1;
case 5: return casadi_s1;
case 6: return casadi_s0;
case 7: return casadi_s0;
case 8: return casadi_s1;
case 9: return casadi_s1;
case 10: return casadi_s1;
case 11: return casadi_s1;
case 12: return casadi_s0;
case 13: return casadi_s0;
case 14: return casadi_s0;
case 15: return casadi_s0;
case 16: return casadi_s1;
case 17: return casadi_s1;
case 18: return casadi_s0;
case 19: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_measured_coefficients_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_measured_coefficients_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 20;
if (sz_res) *sz_res = 4;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_measured_coefficients_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
if (sz_res) *sz_res = 4*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* normalised_data:(alpha,F_y,Fz,C_c,mu)->(alpha_bar,F_bar) */
static int casadi_f40(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2;
a0=arg[3]? arg[3][0] : 0;
a1=arg[0]? arg[0][0] : 0;
a1=tan(a1);
a0=a0*a1;
a1=arg[4]? arg[4][0] : 0;
a0=a0/a1;
if (res[0]!=0) res[0][0]=a0;
a0=arg[1]? arg[1][0] : 0;
a2=arg[2]? arg[2][0] : 0;
a2=a2*a1;
a0=a0/a2;
if (res[1]!=0) res[1][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int normalised_data(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f40(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int normalised_data_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void normalised_data_release(int mem) {
}
CASADI_SYMBOL_EXPORT void normalised_data_incref(void) {
}
CASADI_SYMBOL_EXPORT void normalised_data_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int normalised_data_n_in(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_int normalised_data_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real normalised_data_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* normalised_data_name_in(casadi_int i) {
switch (i) {
case 0: return "alpha";
case 1: return "F_y";
case 2: return "Fz";
case 3: return "C_c";
case 4: return "mu";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* normalised_data_name_out(casadi_int i) {
switch (i) {
case 0: return "alpha_bar";
case 1: return "F_bar";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* normalised_data_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* normalised_data_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int normalised_data_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int normalised_data_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_normalised_data:(alpha,F_y,Fz,C_c,mu,out_alpha_bar[1x1,0nz],out_F_bar[1x1,0nz],fwd_alpha,fwd_F_y,fwd_Fz,fwd_C_c,fwd_mu)->(fwd_alpha_bar,fwd_F_bar) */
static int casadi_f41(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5;
a0=arg[0]? arg[0][0] : 0;
a1=tan(a0);
a2=arg[10]? arg[10][0] : 0;
a2=a1*a2;
a3=arg[3]? arg[3][0] : 0;
a4=arg[7]? arg[7][0] : 0;
a0=cos(a0);
a0=casadi_sq(a0);
a4=a4/a0;
a4=a3*a4;
a2=a2+a4;
a4=arg[4]? arg[4][0] : 0;
a2=a2/a4;
a3=a3*a1;
a3=a3/a4;
a3=a3/a4;
a1=arg[11]? arg[11][0] : 0;
a3=a3*a1;
a2=a2-a3;
if (res[0]!=0) res[0][0]=a2;
a2=arg[8]? arg[8][0] : 0;
a3=arg[2]? arg[2][0] : 0;
a0=a3*a4;
a2=a2/a0;
a5=arg[1]? arg[1][0] : 0;
a5=a5/a0;
a5=a5/a0;
a0=arg[9]? arg[9][0] : 0;
a4=a4*a0;
a3=a3*a1;
a4=a4+a3;
a5=a5*a4;
a2=a2-a5;
if (res[1]!=0) res[1][0]=a2;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_normalised_data(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f41(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_normalised_data_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_normalised_data_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_normalised_data_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_normalised_data_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_normalised_data_n_in(void) { return 12;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_normalised_data_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_normalised_data_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_normalised_data_name_in(casadi_int i) {
switch (i) {
case 0: return "alpha";
case 1: return "F_y";
case 2: return "Fz";
case 3: return "C_c";
case 4: return "mu";
case 5: return "out_alpha_bar";
case 6: return "out_F_bar";
case 7: return "fwd_alpha";
case 8: return "fwd_F_y";
case 9: return "fwd_Fz";
case 10: return "fwd_C_c";
case 11: return "fwd_mu";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_normalised_data_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_alpha_bar";
case 1: return "fwd_F_bar";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_normalised_data_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s1;
case 6: return casadi_s1;
case 7: return casadi_s0;
case 8: return casadi_s0;
case 9: return casadi_s0;
case 10: return casadi_s0;
case 11: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_normalised_data_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_normalised_data_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 12;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_normalised_data_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_normalised_data:(alpha,F_y,Fz,C_c,mu,out_alpha_bar[1x1,0nz],out_F_bar[1x1,0nz],adj_alpha_bar,adj_F_bar)->(adj_alpha,adj_F_y,adj_Fz,adj_C_c,adj_mu) */
static int casadi_f42(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5, a6, a7, a8;
a0=arg[3]? arg[3][0] : 0;
a1=arg[7]? arg[7][0] : 0;
a2=arg[4]? arg[4][0] : 0;
a3=a1/a2;
a4=a0*a3;
a5=arg[0]? arg[0][0] : 0;
a6=cos(a5);
a6=casadi_sq(a6);
a4=a4/a6;
if (res[0]!=0) res[0][0]=a4;
a4=arg[8]? arg[8][0] : 0;
a6=arg[2]? arg[2][0] : 0;
a7=a6*a2;
a8=a4/a7;
if (res[1]!=0) res[1][0]=a8;
a8=arg[1]? arg[1][0] : 0;
a8=a8/a7;
a8=a8/a7;
a8=a8*a4;
a4=a2*a8;
a4=-a4;
if (res[2]!=0) res[2][0]=a4;
a5=tan(a5);
a3=a5*a3;
if (res[3]!=0) res[3][0]=a3;
a6=a6*a8;
a0=a0*a5;
a0=a0/a2;
a0=a0/a2;
a0=a0*a1;
a6=a6+a0;
a6=-a6;
if (res[4]!=0) res[4][0]=a6;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_normalised_data(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f42(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_normalised_data_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_normalised_data_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_normalised_data_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_normalised_data_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_normalised_data_n_in(void) { return 9;}
CASADI_SYMBOL_EXPORT casadi_int adj1_normalised_data_n_out(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_real adj1_normalised_data_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_normalised_data_name_in(casadi_int i) {
switch (i) {
case 0: return "alpha";
case 1: return "F_y";
case 2: return "Fz";
case 3: return "C_c";
case 4: return "mu";
case 5: return "out_alpha_bar";
case 6: return "out_F_bar";
case 7: return "adj_alpha_bar";
case 8: return "adj_F_bar";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_normalised_data_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_alpha";
case 1: return "adj_F_y";
case 2: return "adj_Fz";
case 3: return "adj_C_c";
case 4: return "adj_mu";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_normalised_data_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s1;
case 6: return casadi_s1;
case 7: return casadi_s0;
case 8: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_normalised_data_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_normalised_data_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 9;
if (sz_res) *sz_res = 5;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_normalised_data_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 9*sizeof(const casadi_real*);
if (sz_res) *sz_res = 5*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_normalised_data:(alpha,F_y,Fz,C_c,mu,out_alpha_bar[1x1,0nz],out_F_bar[1x1,0nz],adj_alpha_bar,adj_F_bar,out_adj_alpha[1x1,0nz],out_adj_F_y[1x1,0nz],out_adj_Fz[1x1,0nz],out_adj_C_c[1x1,0nz],out_adj_mu[1x1,0nz],fwd_alpha,fwd_F_y,fwd_Fz,fwd_C_c,fwd_mu,fwd_out_alpha_bar[1x1,0nz],fwd_out_F_bar[1x1,0nz],fwd_adj_alpha_bar,fwd_adj_F_bar)->(fwd_adj_alpha,fwd_adj_F_y,fwd_adj_Fz,fwd_adj_C_c,fwd_adj_mu) */
static int casadi_f43(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20;
a00=arg[7]? arg[7][0] : 0;
a01=arg[4]? arg[4][0] : 0;
a02=a00/a01;
a03=arg[17]? arg[17][0] : 0;
a04=a02*a03;
a05=arg[3]? arg[3][0] : 0;
a06=arg[21]? arg[21][0] : 0;
a07=a06/a01;
a08=a02/a01;
a09=arg[18]? arg[18][0] : 0;
a08=a08*a09;
a07=a07-a08;
a08=a05*a07;
a04=a04+a08;
a08=arg[0]? arg[0][0] : 0;
a10=cos(a08);
a11=casadi_sq(a10);
a04=a04/a11;
a12=a05*a02;
a12=a12/a11;
a12=a12/a11;
a10=2.*a10;
a11=sin(a08);
a13=arg[14]? arg[14][0] : 0;
a11=a11*a13;
a10=a10*a11;
a12=a12*a10;
a04=a04+a12;
if (res[0]!=0) res[0][0]=a04;
a04=arg[22]? arg[22][0] : 0;
a12=arg[2]? arg[2][0] : 0;
a10=a12*a01;
a11=a04/a10;
a14=arg[8]? arg[8][0] : 0;
a15=a14/a10;
a15=a15/a10;
a16=arg[16]? arg[16][0] : 0;
a17=a01*a16;
a18=a12*a09;
a17=a17+a18;
a15=a15*a17;
a11=a11-a15;
if (res[1]!=0) res[1][0]=a11;
a11=arg[1]? arg[1][0] : 0;
a11=a11/a10;
a15=a11/a10;
a18=a15*a14;
a19=a18*a09;
a20=arg[15]? arg[15][0] : 0;
a20=a20/a10;
a11=a11/a10;
a11=a11*a17;
a20=a20-a11;
a20=a20/a10;
a10=a15/a10;
a10=a10*a17;
a20=a20-a10;
a14=a14*a20;
a15=a15*a04;
a14=a14+a15;
a15=a01*a14;
a19=a19+a15;
a19=-a19;
if (res[2]!=0) res[2][0]=a19;
a19=cos(a08);
a19=casadi_sq(a19);
a13=a13/a19;
a02=a02*a13;
a08=tan(a08);
a07=a08*a07;
a02=a02+a07;
if (res[3]!=0) res[3][0]=a02;
a18=a18*a16;
a12=a12*a14;
a18=a18+a12;
a03=a08*a03;
a13=a05*a13;
a03=a03+a13;
a03=a03/a01;
a05=a05*a08;
a05=a05/a01;
a08=a05/a01;
a08=a08*a09;
a03=a03-a08;
a03=a03/a01;
a05=a05/a01;
a01=a05/a01;
a01=a01*a09;
a03=a03-a01;
a00=a00*a03;
a05=a05*a06;
a00=a00+a05;
a18=a18+a00;
a18=-a18;
if (res[4]!=0) res[4][0]=a18;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_normalised_data(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f43(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_normalised_data_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_normalised_data_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_normalised_data_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_normalised_data_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_normalised_data_n_in(void) { return 23;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_normalised_data_n_out(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_normalised_data_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_normalised_data_name_in(casadi_int i) {
switch (i) {
case 0: return "alpha";
case 1: return "F_y";
case 2: return "Fz";
case 3: return "C_c";
case 4: return "mu";
case 5: return "out_alpha_bar";
case 6: return "out_F_bar";
case 7: return "adj_alpha_bar";
case 8: return "adj_F_bar";
case 9: return "out_adj_alpha";
case 10: return "out_adj_F_y";
case 11: return "out_adj_Fz";
case 12: return "out_adj_C_c";
case 13: return "out_adj_mu";
case 14: return "fwd_alpha";
case 15: return "fwd_F_y";
case 16: return "fwd_Fz";
case 17: return "fwd_C_c";
case 18: return "fwd_mu";
case 19: return "fwd_out_alpha_bar";
case 20: return "fwd_out_F_bar";
case 21: return "fwd_adj_alpha_bar";
case 22: return "fwd_adj_F_bar";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_normalised_data_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_alpha";
case 1: return "fwd_adj_F_y";
case 2: return "fwd_adj_Fz";
case 3: return "fwd_adj_C_c";
case 4: return "fwd_adj_mu";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_normalised_data_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s1;
case 6: return casadi_s1;
case 7: return casadi_s0;
case 8: return casadi_s0;
case 9: return casadi_s1;
case 10: return casadi_s1;
case 11: return casadi_s1;
case 12: return casadi_s1;
case 13: return casadi_s1;
case 14: return casadi_s0;
case 15: return casadi_s0;
case 16: return casadi_s0;
case 17: return casadi_s0;
case 18: return casadi_s0;
case 19: return casadi_s1;
case 20: return casadi_s1;
case 21: return casadi_s0;
case 22: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_normalised_data_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_normalised_data_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 23;
if (sz_res) *sz_res = 5;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_normalised_data_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 23*sizeof(const casadi_real*);
if (sz_res) *sz_res = 5*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
