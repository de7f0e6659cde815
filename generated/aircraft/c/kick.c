/* Generated from derive/ (digest 0a06213221c378cc) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`. */
/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
#define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
#define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
#define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
#define CASADI_PREFIX(ID) kick_ ## ID
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
/* Configuration this file was compiled with */
CASADI_SYMBOL_EXPORT void kick_casadi_version(int* major, int* minor, int* patch) {
*major = 3;
*minor = 8;
*patch = 2;
}
CASADI_SYMBOL_EXPORT int kick_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int kick_casadi_real_size(void) { return (int) sizeof(casadi_real); }
static const casadi_int casadi_s0[3] = {1, 1, 1};
static const casadi_int casadi_s1[4] = {1, 1, 0, 0};
/* kick:(S,x_S,m,Izz)->(dv,dr) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1;
a0=arg[0]? arg[0][0] : 0;
a1=arg[2]? arg[2][0] : 0;
a1=a0/a1;
if (res[0]!=0) res[0][0]=a1;
a1=arg[1]? arg[1][0] : 0;
a0=a0*a1;
a1=arg[3]? arg[3][0] : 0;
a0=a0/a1;
if (res[1]!=0) res[1][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int kick(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f0(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int kick_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void kick_release(int mem) {
}
CASADI_SYMBOL_EXPORT void kick_incref(void) {
}
CASADI_SYMBOL_EXPORT void kick_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int kick_n_in(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_int kick_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real kick_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* kick_name_in(casadi_int i) {
switch (i) {
case 0: return "S";
case 1: return "x_S";
case 2: return "m";
case 3: return "Izz";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* kick_name_out(casadi_int i) {
switch (i) {
case 0: return "dv";
case 1: return "dr";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* kick_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* kick_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int kick_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 4;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int kick_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 4*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_kick:(S,x_S,m,Izz,out_dv[1x1,0nz],out_dr[1x1,0nz],fwd_S,fwd_x_S,fwd_m,fwd_Izz)->(fwd_dv,fwd_dr) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4;
a0=arg[6]? arg[6][0] : 0;
a1=arg[2]? arg[2][0] : 0;
a2=a0/a1;
a3=arg[0]? arg[0][0] : 0;
a4=a3/a1;
a4=a4/a1;
a1=arg[8]? arg[8][0] : 0;
a4=a4*a1;
a2=a2-a4;
if (res[0]!=0) res[0][0]=a2;
a2=arg[1]? arg[1][0] : 0;
a0=a2*a0;
a4=arg[7]? arg[7][0] : 0;
a4=a3*a4;
a0=a0+a4;
a4=arg[3]? arg[3][0] : 0;
a0=a0/a4;
a3=a3*a2;
a3=a3/a4;
a3=a3/a4;
a4=arg[9]? arg[9][0] : 0;
a3=a3*a4;
a0=a0-a3;
if (res[1]!=0) res[1][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_kick(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f1(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_kick_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_kick_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_kick_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_kick_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_kick_n_in(void) { return 10;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_kick_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_kick_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_kick_name_in(casadi_int i) {
switch (i) {
case 0: return "S";
case 1: return "x_S";
case 2: return "m";
case 3: return "Izz";
case 4: return "out_dv";
case 5: return "out_dr";
case 6: return "fwd_S";
case 7: return "fwd_x_S";
case 8: return "fwd_m";
case 9: return "fwd_Izz";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_kick_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_dv";
case 1: return "fwd_dr";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_kick_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_kick_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_kick_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 10;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_kick_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_kick:(S,x_S,m,Izz,out_dv[1x1,0nz],out_dr[1x1,0nz],adj_dv,adj_dr)->(adj_S,adj_x_S,adj_m,adj_Izz) */
static int casadi_f2(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5, a6, a7;
a0=arg[1]? arg[1][0] : 0;
a1=arg[7]? arg[7][0] : 0;
a2=arg[3]? arg[3][0] : 0;
a3=a1/a2;
a4=a0*a3;
a5=arg[6]? arg[6][0] : 0;
a6=arg[2]? arg[2][0] : 0;
a7=a5/a6;
a4=a4+a7;
if (res[0]!=0) res[0][0]=a4;
a4=arg[0]? arg[0][0] : 0;
a3=a4*a3;
if (res[1]!=0) res[1][0]=a3;
a3=a4/a6;
a3=a3/a6;
a3=a3*a5;
a3=-a3;
if (res[2]!=0) res[2][0]=a3;
a4=a4*a0;
a4=a4/a2;
a4=a4/a2;
a4=a4*a1;
a4=-a4;
if (res[3]!=0) res[3][0]=a4;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_kick(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f2(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_kick_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_kick_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_kick_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_kick_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_kick_n_in(void) { return 8;}
CASADI_SYMBOL_EXPORT casadi_int adj1_kick_n_out(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_real adj1_kick_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_kick_name_in(casadi_int i) {
switch (i) {
case 0: return "S";
case 1: return "x_S";
case 2: return "m";
case 3: return "Izz";
case 4: return "out_dv";
case 5: return "out_dr";
case 6: return "adj_dv";
case 7: return "adj_dr";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_kick_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_S";
case 1: return "adj_x_S";
case 2: return "adj_m";
case 3: return "adj_Izz";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_kick_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* adj1_kick_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_kick_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 8;
if (sz_res) *sz_res = 4;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_kick_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 8*sizeof(const casadi_real*);
if (sz_res) *sz_res = 4*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_kick:(S,x_S,m,Izz,out_dv[1x1,0nz],out_dr[1x1,0nz],adj_dv,adj_dr,out_adj_S[1x1,0nz],out_adj_x_S[1x1,0nz],out_adj_m[1x1,0nz],out_adj_Izz[1x1,0nz],fwd_S,fwd_x_S,fwd_m,fwd_Izz,fwd_out_dv[1x1,0nz],fwd_out_dr[1x1,0nz],fwd_adj_dv,fwd_adj_dr)->(fwd_adj_S,fwd_adj_x_S,fwd_adj_m,fwd_adj_Izz) */
static int casadi_f3(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14;
a00=arg[7]? arg[7][0] : 0;
a01=arg[3]? arg[3][0] : 0;
a02=a00/a01;
a03=arg[13]? arg[13][0] : 0;
a04=a02*a03;
a05=arg[1]? arg[1][0] : 0;
a06=arg[19]? arg[19][0] : 0;
a07=a06/a01;
a08=a02/a01;
a09=arg[15]? arg[15][0] : 0;
a08=a08*a09;
a07=a07-a08;
a08=a05*a07;
a04=a04+a08;
a08=arg[18]? arg[18][0] : 0;
a10=arg[2]? arg[2][0] : 0;
a11=a08/a10;
a12=arg[6]? arg[6][0] : 0;
a13=a12/a10;
a13=a13/a10;
a14=arg[14]? arg[14][0] : 0;
a13=a13*a14;
a11=a11-a13;
a04=a04+a11;
if (res[0]!=0) res[0][0]=a04;
a04=arg[12]? arg[12][0] : 0;
a02=a02*a04;
a11=arg[0]? arg[0][0] : 0;
a07=a11*a07;
a02=a02+a07;
if (res[1]!=0) res[1][0]=a02;
a02=a04/a10;
a07=a11/a10;
a13=a07/a10;
a13=a13*a14;
a02=a02-a13;
a02=a02/a10;
a07=a07/a10;
a10=a07/a10;
a10=a10*a14;
a02=a02-a10;
a12=a12*a02;
a07=a07*a08;
a12=a12+a07;
a12=-a12;
if (res[2]!=0) res[2][0]=a12;
a04=a05*a04;
a03=a11*a03;
a04=a04+a03;
a04=a04/a01;
a11=a11*a05;
a11=a11/a01;
a05=a11/a01;
a05=a05*a09;
a04=a04-a05;
a04=a04/a01;
a11=a11/a01;
a01=a11/a01;
a01=a01*a09;
a04=a04-a01;
a00=a00*a04;
a11=a11*a06;
a00=a00+a11;
a00=-a00;
if (res[3]!=0) res[3][0]=a00;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_kick(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f3(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_kick_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_kick_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_kick_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_kick_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_kick_n_in(void) { return 20;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_kick_n_out(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_kick_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_kick_name_in(casadi_int i) {
switch (i) {
case 0: return "S";
case 1: return "x_S";
case 2: return "m";
case 3: return "Izz";
case 4: return "out_dv";
case 5: return "out_dr";
case 6: return "adj_dv";
case 7: return "adj_dr";
case 8: return "out_adj_S";
case 9: return "out_adj_x_S";
case 10: return "out_adj_m";
case 11: return "out_adj_Izz";
case 12: return "fwd_S";
case 13: return "fwd_x_S";
case 14: return "fwd_m";
case 15: return "fwd_Izz";
case 16: return "fwd_out_dv";
case 17: return "fwd_out_dr";
case 18: return "fwd_adj_dv";
case 19: return "fwd_adj_dr";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_kick_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_S";
case 1: return "fwd_adj_x_S";
case 2: return "fwd_adj_m";
case 3: return "fwd_adj_Izz";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_kick_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_kick_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_kick_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 20;
if (sz_res) *sz_res = 4;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_kick_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
if (sz_res) *sz_res = 4*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
