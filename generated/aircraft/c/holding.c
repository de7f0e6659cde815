/* Generated from derive/ (digest 0a06213221c378cc) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`. */
/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
#define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
#define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
#define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
#define CASADI_PREFIX(ID) holding_ ## ID
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
#define casadi_f2 CASADI_PREFIX(f2)
#define casadi_f3 CASADI_PREFIX(f3)
#define casadi_f4 CASADI_PREFIX(f4)
#define casadi_f5 CASADI_PREFIX(f5)
#define casadi_f6 CASADI_PREFIX(f6)
#define casadi_f7 CASADI_PREFIX(f7)
#define casadi_f8 CASADI_PREFIX(f8)
#define casadi_f9 CASADI_PREFIX(f9)
#define casadi_fmax CASADI_PREFIX(fmax)
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
casadi_real casadi_fmax(casadi_real x, casadi_real y) {
/* Pre-c99 compatibility */
#if __STDC_VERSION__ < 199901L
return x>y ? x : y;
#else
return fmax(x, y);
#endif
}
casadi_real casadi_fmin(casadi_real x, casadi_real y) {
/* Pre-c99 compatibility */
#if __STDC_VERSION__ < 199901L
return x<y ? x : y;
#else
return fmin(x, y);
#endif
}
/* Configuration this file was compiled with */
CASADI_SYMBOL_EXPORT void holding_casadi_version(int* major, int* minor, int* patch) {
*major = 3;
*minor = 8;
*patch = 2;
}
CASADI_SYMBOL_EXPORT int holding_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int holding_casadi_real_size(void) { return (int) sizeof(casadi_real); }
static const casadi_int casadi_s0[3] = {1, 1, 1};
static const casadi_int casadi_s1[4] = {1, 1, 0, 0};
/* moved_loads:(Fz_left,Fz_right,Mx_held,track)->(N_left,N_right) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3;
a0=arg[0]? arg[0][0] : 0;
a1=arg[2]? arg[2][0] : 0;
a2=arg[3]? arg[3][0] : 0;
a3=a1/a2;
a0=a0+a3;
if (res[0]!=0) res[0][0]=a0;
a0=arg[1]? arg[1][0] : 0;
a1=a1/a2;
a0=a0-a1;
if (res[1]!=0) res[1][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int moved_loads(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f0(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int moved_loads_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void moved_loads_release(int mem) {
}
CASADI_SYMBOL_EXPORT void moved_loads_incref(void) {
}
CASADI_SYMBOL_EXPORT void moved_loads_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int moved_loads_n_in(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_int moved_loads_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real moved_loads_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* moved_loads_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz_left";
case 1: return "Fz_right";
case 2: return "Mx_held";
case 3: return "track";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* moved_loads_name_out(casadi_int i) {
switch (i) {
case 0: return "N_left";
case 1: return "N_right";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* moved_loads_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* moved_loads_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int moved_loads_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 4;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int moved_loads_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 4*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_moved_loads:(Fz_left,Fz_right,Mx_held,track,out_N_left[1x1,0nz],out_N_right[1x1,0nz],fwd_Fz_left,fwd_Fz_right,fwd_Mx_held,fwd_track)->(fwd_N_left,fwd_N_right) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5, a6;
a0=arg[6]? arg[6][0] : 0;
a1=arg[8]? arg[8][0] : 0;
a2=arg[3]? arg[3][0] : 0;
a3=a1/a2;
a4=arg[2]? arg[2][0] : 0;
a5=a4/a2;
a5=a5/a2;
a6=arg[9]? arg[9][0] : 0;
a5=a5*a6;
a3=a3-a5;
a0=a0+a3;
if (res[0]!=0) res[0][0]=a0;
a0=arg[7]? arg[7][0] : 0;
a1=a1/a2;
a4=a4/a2;
a4=a4/a2;
a4=a4*a6;
a1=a1-a4;
a0=a0-a1;
if (res[1]!=0) res[1][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_moved_loads(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f1(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_moved_loads_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_moved_loads_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_moved_loads_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_moved_loads_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_moved_loads_n_in(void) { return 10;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_moved_loads_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_moved_loads_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_moved_loads_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz_left";
case 1: return "Fz_right";
case 2: return "Mx_held";
case 3: return "track";
case 4: return "out_N_left";
case 5: return "out_N_right";
case 6: return "fwd_Fz_left";
case 7: return "fwd_Fz_right";
case 8: return "fwd_Mx_held";
case 9: return "fwd_track";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_moved_loads_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_N_left";
case 1: return "fwd_N_right";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_moved_loads_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_moved_loads_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_moved_loads_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 10;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_moved_loads_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_moved_loads:(Fz_left,Fz_right,Mx_held,track,out_N_left[1x1,0nz],out_N_right[1x1,0nz],adj_N_left,adj_N_right)->(adj_Fz_left,adj_Fz_right,adj_Mx_held,adj_track) */
static int casadi_f2(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4;
a0=arg[6]? arg[6][0] : 0;
if (res[0]!=0) res[0][0]=a0;
a1=arg[7]? arg[7][0] : 0;
if (res[1]!=0) res[1][0]=a1;
a2=arg[3]? arg[3][0] : 0;
a3=a0/a2;
a4=a1/a2;
a3=a3-a4;
if (res[2]!=0) res[2][0]=a3;
a3=arg[2]? arg[2][0] : 0;
a4=a3/a2;
a4=a4/a2;
a4=a4*a1;
a3=a3/a2;
a3=a3/a2;
a3=a3*a0;
a4=a4-a3;
if (res[3]!=0) res[3][0]=a4;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_moved_loads(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f2(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_moved_loads_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_moved_loads_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_moved_loads_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_moved_loads_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_moved_loads_n_in(void) { return 8;}
CASADI_SYMBOL_EXPORT casadi_int adj1_moved_loads_n_out(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_real adj1_moved_loads_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_moved_loads_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz_left";
case 1: return "Fz_right";
case 2: return "Mx_held";
case 3: return "track";
case 4: return "out_N_left";
case 5: return "out_N_right";
case 6: return "adj_N_left";
case 7: return "adj_N_right";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_moved_loads_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_Fz_left";
case 1: return "adj_Fz_right";
case 2: return "adj_Mx_held";
case 3: return "adj_track";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_moved_loads_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* adj1_moved_loads_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_moved_loads_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 8;
if (sz_res) *sz_res = 4;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_moved_loads_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 8*sizeof(const casadi_real*);
if (sz_res) *sz_res = 4*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_moved_loads:(Fz_left,Fz_right,Mx_held,track,out_N_left[1x1,0nz],out_N_right[1x1,0nz],adj_N_left,adj_N_right,out_adj_Fz_left[1x1,0nz],out_adj_Fz_right[1x1,0nz],out_adj_Mx_held[1x1,0nz],out_adj_track[1x1,0nz],fwd_Fz_left,fwd_Fz_right,fwd_Mx_held,fwd_track,fwd_out_N_left[1x1,0nz],fwd_out_N_right[1x1,0nz],fwd_adj_N_left,fwd_adj_N_right)->(fwd_adj_Fz_left,fwd_adj_Fz_right,fwd_adj_Mx_held,fwd_adj_track) */
static int casadi_f3(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10;
a00=arg[18]? arg[18][0] : 0;
if (res[0]!=0) res[0][0]=a00;
a01=arg[19]? arg[19][0] : 0;
if (res[1]!=0) res[1][0]=a01;
a02=arg[3]? arg[3][0] : 0;
a03=a00/a02;
a04=arg[6]? arg[6][0] : 0;
a05=a04/a02;
a05=a05/a02;
a06=arg[15]? arg[15][0] : 0;
a05=a05*a06;
a03=a03-a05;
a05=a01/a02;
a07=arg[7]? arg[7][0] : 0;
a08=a07/a02;
a08=a08/a02;
a08=a08*a06;
a05=a05-a08;
a03=a03-a05;
if (res[2]!=0) res[2][0]=a03;
a03=arg[14]? arg[14][0] : 0;
a05=a03/a02;
a08=arg[2]? arg[2][0] : 0;
a09=a08/a02;
a10=a09/a02;
a10=a10*a06;
a05=a05-a10;
a05=a05/a02;
a09=a09/a02;
a10=a09/a02;
a10=a10*a06;
a05=a05-a10;
a07=a07*a05;
a09=a09*a01;
a07=a07+a09;
a03=a03/a02;
a08=a08/a02;
a09=a08/a02;
a09=a09*a06;
a03=a03-a09;
a03=a03/a02;
a08=a08/a02;
a02=a08/a02;
a02=a02*a06;
a03=a03-a02;
a04=a04*a03;
a08=a08*a00;
a04=a04+a08;
a07=a07-a04;
if (res[3]!=0) res[3][0]=a07;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_moved_loads(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f3(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_moved_loads_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_moved_loads_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_moved_loads_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_moved_loads_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_moved_loads_n_in(void) { return 20;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_moved_loads_n_out(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_moved_loads_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_moved_loads_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz_left";
case 1: return "Fz_right";
case 2: return "Mx_held";
case 3: return "track";
case 4: return "out_N_left";
case 5: return "out_N_right";
case 6: return "adj_N_left";
case 7: return "adj_N_right";
case 8: return "out_adj_Fz_left";
case 9: return "out_adj_Fz_right";
case 10: return "out_adj_Mx_held";
case 11: return "out_adj_track";
case 12: return "fwd_Fz_left";
case 13: return "fwd_Fz_right";
case 14: return "fwd_Mx_held";
case 15: return "fwd_track";
case 16: return "fwd_out_N_left";
case 17: return "fwd_out_N_right";
case 18: return "fwd_adj_N_left";
case 19: return "fwd_adj_N_right";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_moved_loads_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_Fz_left";
case 1: return "fwd_adj_Fz_right";
case 2: return "fwd_adj_Mx_held";
case 3: return "fwd_adj_track";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_moved_loads_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_moved_loads_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_moved_loads_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 20;
if (sz_res) *sz_res = 4;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_moved_loads_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
if (sz_res) *sz_res = 4*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* friction_used:(F_x,F_y,Fz,B5,C5,surface_left)->(used) */
static int casadi_f4(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5;
a0=arg[0]? arg[0][0] : 0;
a0=casadi_sq(a0);
a1=arg[1]? arg[1][0] : 0;
a1=casadi_sq(a1);
a0=a0+a1;
a0=sqrt(a0);
a1=arg[5]? arg[5][0] : 0;
a2=1.0000000000000000e-03;
a3=arg[3]? arg[3][0] : 0;
a4=arg[4]? arg[4][0] : 0;
a5=arg[2]? arg[2][0] : 0;
a4=a4*a5;
a3=a3+a4;
a2=casadi_fmax(a2,a3);
a1=a1*a2;
a2=1.;
a2=casadi_fmax(a2,a5);
a1=a1*a2;
a0=a0/a1;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int friction_used(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f4(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int friction_used_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void friction_used_release(int mem) {
}
CASADI_SYMBOL_EXPORT void friction_used_incref(void) {
}
CASADI_SYMBOL_EXPORT void friction_used_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int friction_used_n_in(void) { return 6;}
CASADI_SYMBOL_EXPORT casadi_int friction_used_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real friction_used_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* friction_used_name_in(casadi_int i) {
switch (i) {
case 0: return "F_x";
case 1: return "F_y";
case 2: return "Fz";
case 3: return "B5";
case 4: return "C5";
case 5: return "surface_left";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* friction_used_name_out(casadi_int i) {
switch (i) {
case 0: return "used";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* friction_used_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* friction_used_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int friction_used_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 6;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int friction_used_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 6*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_friction_used:(F_x,F_y,Fz,B5,C5,surface_left,out_used[1x1,0nz],fwd_F_x,fwd_F_y,fwd_Fz,fwd_B5,fwd_C5,fwd_surface_left)->(fwd_used) */
static int casadi_f5(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12;
a00=arg[0]? arg[0][0] : 0;
a01=2.*a00;
a02=arg[7]? arg[7][0] : 0;
a01=a01*a02;
a02=arg[1]? arg[1][0] : 0;
a03=2.*a02;
a04=arg[8]? arg[8][0] : 0;
a03=a03*a04;
a01=a01+a03;
a00=casadi_sq(a00);
a02=casadi_sq(a02);
a00=a00+a02;
a00=sqrt(a00);
a02=2.*a00;
a01=a01/a02;
a02=arg[5]? arg[5][0] : 0;
a03=1.0000000000000000e-03;
a04=arg[3]? arg[3][0] : 0;
a05=arg[4]? arg[4][0] : 0;
a06=arg[2]? arg[2][0] : 0;
a07=a05*a06;
a04=a04+a07;
a07=casadi_fmax(a03,a04);
a08=a02*a07;
a09=1.;
a10=casadi_fmax(a09,a06);
a11=a08*a10;
a01=a01/a11;
a00=a00/a11;
a00=a00/a11;
a11=arg[12]? arg[12][0] : 0;
a07=a07*a11;
a11=a03<=a04;
a04=a04<=a03;
a04=a04+a11;
a11=a11/a04;
a04=arg[10]? arg[10][0] : 0;
a03=arg[11]? arg[11][0] : 0;
a03=a06*a03;
a12=arg[9]? arg[9][0] : 0;
a05=a05*a12;
a03=a03+a05;
a04=a04+a03;
a11=a11*a04;
a02=a02*a11;
a07=a07+a02;
a10=a10*a07;
a07=a09<=a06;
a06=a06<=a09;
a06=a06+a07;
a07=a07/a06;
a07=a07*a12;
a08=a08*a07;
a10=a10+a08;
a00=a00*a10;
a01=a01-a00;
if (res[0]!=0) res[0][0]=a01;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_friction_used(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f5(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_friction_used_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_friction_used_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_friction_used_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_friction_used_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_friction_used_n_in(void) { return 13;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_friction_used_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_friction_used_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_friction_used_name_in(casadi_int i) {
switch (i) {
case 0: return "F_x";
case 1: return "F_y";
case 2: return "Fz";
case 3: return "B5";
case 4: return "C5";
case 5: return "surface_left";
case 6: return "out_used";
case 7: return "fwd_F_x";
case 8: return "fwd_F_y";
case 9: return "fwd_Fz";
case 10: return "fwd_B5";
case 11: return "fwd_C5";
case 12: return "fwd_surface_left";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_friction_used_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_used";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_friction_used_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_friction_used_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_friction_used_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 13;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_friction_used_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 13*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_friction_used:(F_x,F_y,Fz,B5,C5,surface_left,out_used[1x1,0nz],adj_used)->(adj_F_x,adj_F_y,adj_Fz,adj_B5,adj_C5,adj_surface_left) */
static int casadi_f6(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15;
a00=arg[0]? arg[0][0] : 0;
a01=2.*a00;
a02=arg[7]? arg[7][0] : 0;
a03=arg[5]? arg[5][0] : 0;
a04=1.0000000000000000e-03;
a05=arg[3]? arg[3][0] : 0;
a06=arg[4]? arg[4][0] : 0;
a07=arg[2]? arg[2][0] : 0;
a08=a06*a07;
a05=a05+a08;
a08=casadi_fmax(a04,a05);
a09=a03*a08;
a10=1.;
a11=casadi_fmax(a10,a07);
a12=a09*a11;
a13=a02/a12;
a00=casadi_sq(a00);
a14=arg[1]? arg[1][0] : 0;
a15=casadi_sq(a14);
a00=a00+a15;
a00=sqrt(a00);
a15=2.*a00;
a13=a13/a15;
a01=a01*a13;
if (res[0]!=0) res[0][0]=a01;
a14=2.*a14;
a14=a14*a13;
if (res[1]!=0) res[1][0]=a14;
a14=a10<=a07;
a10=a07<=a10;
a10=a10+a14;
a14=a14/a10;
a00=a00/a12;
a00=a00/a12;
a00=a00*a02;
a09=a09*a00;
a14=a14*a09;
a09=a04<=a05;
a05=a05<=a04;
a05=a05+a09;
a09=a09/a05;
a11=a11*a00;
a03=a03*a11;
a09=a09*a03;
a06=a06*a09;
a14=a14+a06;
a14=-a14;
if (res[2]!=0) res[2][0]=a14;
a14=-a09;
if (res[3]!=0) res[3][0]=a14;
a07=a07*a09;
a07=-a07;
if (res[4]!=0) res[4][0]=a07;
a08=a08*a11;
a08=-a08;
if (res[5]!=0) res[5][0]=a08;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_friction_used(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f6(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_friction_used_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_friction_used_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_friction_used_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_friction_used_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_friction_used_n_in(void) { return 8;}
CASADI_SYMBOL_EXPORT casadi_int adj1_friction_used_n_out(void) { return 6;}
CASADI_SYMBOL_EXPORT casadi_real adj1_friction_used_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_friction_used_name_in(casadi_int i) {
switch (i) {
case 0: return "F_x";
case 1: return "F_y";
case 2: return "Fz";
case 3: return "B5";
case 4: return "C5";
case 5: return "surface_left";
case 6: return "out_used";
case 7: return "adj_used";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_friction_used_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_F_x";
case 1: return "adj_F_y";
case 2: return "adj_Fz";
case 3: return "adj_B5";
case 4: return "adj_C5";
case 5: return "adj_surface_left";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_friction_used_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* adj1_friction_used_sparsity_out(casadi_int i) {
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
CASADI_SYMBOL_EXPORT int adj1_friction_used_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 8;
if (sz_res) *sz_res = 6;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_friction_used_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 8*sizeof(const casadi_real*);
if (sz_res) *sz_res = 6*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_friction_used:(F_x,F_y,Fz,B5,C5,surface_left,out_used[1x1,0nz],adj_used,out_adj_F_x[1x1,0nz],out_adj_F_y[1x1,0nz],out_adj_Fz[1x1,0nz],out_adj_B5[1x1,0nz],out_adj_C5[1x1,0nz],out_adj_surface_left[1x1,0nz],fwd_F_x,fwd_F_y,fwd_Fz,fwd_B5,fwd_C5,fwd_surface_left,fwd_out_used[1x1,0nz],fwd_adj_used)->(fwd_adj_F_x,fwd_adj_F_y,fwd_adj_Fz,fwd_adj_B5,fwd_adj_C5,fwd_adj_surface_left) */
static int casadi_f7(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29;
a00=arg[7]? arg[7][0] : 0;
a01=arg[5]? arg[5][0] : 0;
a02=1.0000000000000000e-03;
a03=arg[3]? arg[3][0] : 0;
a04=arg[4]? arg[4][0] : 0;
a05=arg[2]? arg[2][0] : 0;
a06=a04*a05;
a03=a03+a06;
a06=casadi_fmax(a02,a03);
a07=a01*a06;
a08=1.;
a09=casadi_fmax(a08,a05);
a10=a07*a09;
a11=a00/a10;
a12=arg[0]? arg[0][0] : 0;
a13=casadi_sq(a12);
a14=arg[1]? arg[1][0] : 0;
a15=casadi_sq(a14);
a13=a13+a15;
a13=sqrt(a13);
a15=2.*a13;
a16=a11/a15;
a17=arg[14]? arg[14][0] : 0;
a18=2.*a17;
a18=a16*a18;
a19=2.*a12;
a20=arg[21]? arg[21][0] : 0;
a21=a20/a10;
a11=a11/a10;
a22=arg[19]? arg[19][0] : 0;
a23=a06*a22;
a24=a02<=a03;
a25=a03<=a02;
a25=a25+a24;
a24=a24/a25;
a25=arg[17]? arg[17][0] : 0;
a26=arg[18]? arg[18][0] : 0;
a27=a05*a26;
a28=arg[16]? arg[16][0] : 0;
a29=a04*a28;
a27=a27+a29;
a25=a25+a27;
a24=a24*a25;
a25=a01*a24;
a23=a23+a25;
a25=a09*a23;
a27=a08<=a05;
a29=a05<=a08;
a29=a29+a27;
a27=a27/a29;
a27=a27*a28;
a29=a07*a27;
a25=a25+a29;
a11=a11*a25;
a21=a21-a11;
a21=a21/a15;
a15=a16/a15;
a12=2.*a12;
a12=a12*a17;
a17=2.*a14;
a11=arg[15]? arg[15][0] : 0;
a17=a17*a11;
a12=a12+a17;
a17=2.*a13;
a12=a12/a17;
a17=2.*a12;
a15=a15*a17;
a21=a21-a15;
a19=a19*a21;
a18=a18+a19;
if (res[0]!=0) res[0][0]=a18;
a11=2.*a11;
a16=a16*a11;
a14=2.*a14;
a14=a14*a21;
a16=a16+a14;
if (res[1]!=0) res[1][0]=a16;
a16=a08<=a05;
a08=a05<=a08;
a08=a08+a16;
a16=a16/a08;
a13=a13/a10;
a08=a13/a10;
a14=a08*a00;
a23=a14*a23;
a12=a12/a10;
a13=a13/a10;
a13=a13*a25;
a12=a12-a13;
a12=a12/a10;
a10=a08/a10;
a10=a10*a25;
a12=a12-a10;
a00=a00*a12;
a08=a08*a20;
a00=a00+a08;
a07=a07*a00;
a23=a23+a07;
a16=a16*a23;
a23=a02<=a03;
a03=a03<=a02;
a03=a03+a23;
a23=a23/a03;
a03=a09*a14;
a02=a01*a03;
a02=a23*a02;
a26=a02*a26;
a22=a03*a22;
a14=a14*a27;
a09=a09*a00;
a14=a14+a09;
a01=a01*a14;
a22=a22+a01;
a23=a23*a22;
a04=a04*a23;
a26=a26+a04;
a16=a16+a26;
a16=-a16;
if (res[2]!=0) res[2][0]=a16;
a16=-a23;
if (res[3]!=0) res[3][0]=a16;
a02=a02*a28;
a05=a05*a23;
a02=a02+a05;
a02=-a02;
if (res[4]!=0) res[4][0]=a02;
a03=a03*a24;
a06=a06*a14;
a03=a03+a06;
a03=-a03;
if (res[5]!=0) res[5][0]=a03;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_friction_used(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f7(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_friction_used_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_friction_used_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_friction_used_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_friction_used_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_friction_used_n_in(void) { return 22;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_friction_used_n_out(void) { return 6;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_friction_used_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_friction_used_name_in(casadi_int i) {
switch (i) {
case 0: return "F_x";
case 1: return "F_y";
case 2: return "Fz";
case 3: return "B5";
case 4: return "C5";
case 5: return "surface_left";
case 6: return "out_used";
case 7: return "adj_used";
case 8: return "out_adj_F_x";
case 9: return "out_adj_F_y";
case 10: return "out_adj_Fz";
case 11: return "out_adj_B5";
case 12: return "out_adj_C5";
case 13: return "out_adj_surface_left";
case 14: return "fwd_F_x";
case 15: return "fwd_F_y";
case 16: return "fwd_Fz";
case 17: return "fwd_B5";
case 18: return "fwd_C5";
case 19: return "fwd_surface_left";
case 20: return "fwd_out_used";
case 21: return "fwd_adj_used";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_friction_used_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_F_x";
case 1: return "fwd_adj_F_y";
case 2: return "fwd_adj_Fz";
case 3: return "fwd_adj_B5";
case 4: return "fwd_adj_C5";
case 5: return "fwd_adj_surface_left";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_friction_used_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_friction_used_sparsity_out(casadi_int i) {
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
CASADI_SYMBOL_EXPORT int fwd1_adj1_friction_used_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 22;
if (sz_res) *sz_res = 6;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_friction_used_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
if (sz_res) *sz_res = 6*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* clause_winds:(m,g,rho,S_wing,CL_max)->(V_stall,wind_large,wind_small) */
static int casadi_f8(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4;
a0=1.4142135623730951e+00;
a1=arg[1]? arg[1][0] : 0;
a1=sqrt(a1);
a0=a0*a1;
a1=arg[0]? arg[0][0] : 0;
a1=sqrt(a1);
a0=a0*a1;
a1=arg[4]? arg[4][0] : 0;
a1=sqrt(a1);
a2=arg[3]? arg[3][0] : 0;
a2=sqrt(a2);
a1=a1*a2;
a2=arg[2]? arg[2][0] : 0;
a2=sqrt(a2);
a1=a1*a2;
a0=a0/a1;
if (res[0]!=0) res[0][0]=a0;
a1=1.2861111111111112e+01;
a2=1.0288888888888890e+01;
a3=2.0000000000000001e-01;
a4=a3*a0;
a2=casadi_fmax(a2,a4);
a1=casadi_fmin(a1,a2);
if (res[1]!=0) res[1][0]=a1;
a3=a3*a0;
if (res[2]!=0) res[2][0]=a3;
return 0;
}
CASADI_SYMBOL_EXPORT int clause_winds(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f8(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int clause_winds_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void clause_winds_release(int mem) {
}
CASADI_SYMBOL_EXPORT void clause_winds_incref(void) {
}
CASADI_SYMBOL_EXPORT void clause_winds_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int clause_winds_n_in(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_int clause_winds_n_out(void) { return 3;}
CASADI_SYMBOL_EXPORT casadi_real clause_winds_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* clause_winds_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "g";
case 2: return "rho";
case 3: return "S_wing";
case 4: return "CL_max";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* clause_winds_name_out(casadi_int i) {
switch (i) {
case 0: return "V_stall";
case 1: return "wind_large";
case 2: return "wind_small";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* clause_winds_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* clause_winds_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int clause_winds_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5;
if (sz_res) *sz_res = 3;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int clause_winds_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
if (sz_res) *sz_res = 3*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_clause_winds:(m,g,rho,S_wing,CL_max,out_V_stall[1x1,0nz],out_wind_large[1x1,0nz],out_wind_small[1x1,0nz],fwd_m,fwd_g,fwd_rho,fwd_S_wing,fwd_CL_max)->(fwd_V_stall,fwd_wind_large,fwd_wind_small) */
static int casadi_f9(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5, a6, a7, a8;
a0=arg[0]? arg[0][0] : 0;
a0=sqrt(a0);
a1=1.4142135623730951e+00;
a2=arg[9]? arg[9][0] : 0;
a3=arg[1]? arg[1][0] : 0;
a3=sqrt(a3);
a4=2.*a3;
a2=a2/a4;
a2=a1*a2;
a2=a0*a2;
a1=a1*a3;
a3=arg[8]? arg[8][0] : 0;
a4=2.*a0;
a3=a3/a4;
a3=a1*a3;
a2=a2+a3;
a3=arg[4]? arg[4][0] : 0;
a3=sqrt(a3);
a4=arg[3]? arg[3][0] : 0;
a4=sqrt(a4);
a5=a3*a4;
a6=arg[2]? arg[2][0] : 0;
a6=sqrt(a6);
a7=a5*a6;
a2=a2/a7;
a1=a1*a0;
a1=a1/a7;
a7=a1/a7;
a0=arg[12]? arg[12][0] : 0;
a8=2.*a3;
a0=a0/a8;
a0=a4*a0;
a8=arg[11]? arg[11][0] : 0;
a4=2.*a4;
a8=a8/a4;
a3=a3*a8;
a0=a0+a3;
a0=a6*a0;
a3=arg[10]? arg[10][0] : 0;
a6=2.*a6;
a3=a3/a6;
a5=a5*a3;
a0=a0+a5;
a7=a7*a0;
a2=a2-a7;
if (res[0]!=0) res[0][0]=a2;
a7=1.0288888888888890e+01;
a0=2.0000000000000001e-01;
a1=a0*a1;
a5=casadi_fmax(a7,a1);
a3=1.2861111111111112e+01;
a6=a5<=a3;
a3=a3<=a5;
a3=a3+a6;
a6=a6/a3;
a3=a7<=a1;
a1=a1<=a7;
a1=a1+a3;
a3=a3/a1;
a1=a0*a2;
a3=a3*a1;
a6=a6*a3;
if (res[1]!=0) res[1][0]=a6;
a0=a0*a2;
if (res[2]!=0) res[2][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_clause_winds(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f9(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_clause_winds_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_clause_winds_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_clause_winds_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_clause_winds_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_clause_winds_n_in(void) { return 13;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_clause_winds_n_out(void) { return 3;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_clause_winds_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_clause_winds_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "g";
case 2: return "rho";
case 3: return "S_wing";
case 4: return "CL_max";
case 5: return "out_V_stall";
case 6: return "out_wind_large";
case 7: return "out_wind_small";
case 8: return "fwd_m";
case 9: return "fwd_g";
case 10: return "fwd_rho";
case 11: return "fwd_S_wing";
case 12: return "fwd_CL_max";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_clause_winds_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_V_stall";
case 1: return "fwd_wind_large";
case 2: return "fwd_wind_small";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_clause_winds_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s1;
case 6: return casadi_s1;
case 7: return casadi_s1;
case 8: return casadi_s0;
case 9: return casadi_s0;
case 10: return casadi_s0;
case 11: return casadi_s0;
case 12: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_clause_winds_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_clause_winds_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 13;
if (sz_res) *sz_res = 3;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_clause_winds_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 13*sizeof(const casadi_real*);
if (sz_res) *sz_res = 3*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_clause_winds:(m,g,rho,S_wing,CL_max,out_V_stall[1x1,0nz],out_wind_large[1x1,0nz],out_wind_small[1x1,0nz],adj_V_stall,adj_wind_large,adj_wind_small)->(adj_m,adj_g,adj_rho,adj_S_wing,adj_CL_max) */
static int casadi_f10(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15;
a00=1.4142135623730951e+00;
a01=arg[1]? arg[1][0] : 0;
a01=sqrt(a01);
a02=a00*a01;
a03=2.0000000000000001e-01;
a04=arg[10]? arg[10][0] : 0;
a04=a03*a04;
a05=1.0288888888888890e+01;
a06=arg[0]? arg[0][0] : 0;
a06=sqrt(a06);
a07=a02*a06;
a08=arg[4]? arg[4][0] : 0;
a08=sqrt(a08);
a09=arg[3]? arg[3][0] : 0;
a09=sqrt(a09);
a10=a08*a09;
a11=arg[2]? arg[2][0] : 0;
a11=sqrt(a11);
a12=a10*a11;
a07=a07/a12;
a13=a03*a07;
a14=a05<=a13;
a15=a13<=a05;
a15=a15+a14;
a14=a14/a15;
a05=casadi_fmax(a05,a13);
a13=1.2861111111111112e+01;
a15=a05<=a13;
a13=a13<=a05;
a13=a13+a15;
a15=a15/a13;
a13=arg[9]? arg[9][0] : 0;
a15=a15*a13;
a14=a14*a15;
a03=a03*a14;
a04=a04+a03;
a03=arg[8]? arg[8][0] : 0;
a04=a04+a03;
a03=a04/a12;
a02=a02*a03;
a14=2.*a06;
a02=a02/a14;
if (res[0]!=0) res[0][0]=a02;
a06=a06*a03;
a00=a00*a06;
a01=2.*a01;
a00=a00/a01;
if (res[1]!=0) res[1][0]=a00;
a07=a07/a12;
a07=a07*a04;
a10=a10*a07;
a04=2.*a11;
a10=a10/a04;
a10=-a10;
if (res[2]!=0) res[2][0]=a10;
a11=a11*a07;
a07=a08*a11;
a10=2.*a09;
a07=a07/a10;
a07=-a07;
if (res[3]!=0) res[3][0]=a07;
a09=a09*a11;
a08=2.*a08;
a09=a09/a08;
a09=-a09;
if (res[4]!=0) res[4][0]=a09;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_clause_winds(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f10(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_clause_winds_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_clause_winds_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_clause_winds_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_clause_winds_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_clause_winds_n_in(void) { return 11;}
CASADI_SYMBOL_EXPORT casadi_int adj1_clause_winds_n_out(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_real adj1_clause_winds_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_clause_winds_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "g";
case 2: return "rho";
case 3: return "S_wing";
case 4: return "CL_max";
case 5: return "out_V_stall";
case 6: return "out_wind_large";
case 7: return "out_wind_small";
case 8: return "adj_V_stall";
case 9: return "adj_wind_large";
case 10: return "adj_wind_small";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_clause_winds_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_m";
case 1: return "adj_g";
case 2: return "adj_rho";
case 3: return "adj_S_wing";
case 4: return "adj_CL_max";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_clause_winds_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s1;
case 6: return casadi_s1;
case 7: return casadi_s1;
case 8: return casadi_s0;
case 9: return casadi_s0;
case 10: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_clause_winds_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_clause_winds_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 11;
if (sz_res) *sz_res = 5;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_clause_winds_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 11*sizeof(const casadi_real*);
if (sz_res) *sz_res = 5*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_clause_winds:(m,g,rho,S_wing,CL_max,out_V_stall[1x1,0nz],out_wind_large[1x1,0nz],out_wind_small[1x1,0nz],adj_V_stall,adj_wind_large,adj_wind_small,out_adj_m[1x1,0nz],out_adj_g[1x1,0nz],out_adj_rho[1x1,0nz],out_adj_S_wing[1x1,0nz],out_adj_CL_max[1x1,0nz],fwd_m,fwd_g,fwd_rho,fwd_S_wing,fwd_CL_max,fwd_out_V_stall[1x1,0nz],fwd_out_wind_large[1x1,0nz],fwd_out_wind_small[1x1,0nz],fwd_adj_V_stall,fwd_adj_wind_large,fwd_adj_wind_small)->(fwd_adj_m,fwd_adj_g,fwd_adj_rho,fwd_adj_S_wing,fwd_adj_CL_max) */
static int casadi_f11(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24;
a00=2.0000000000000001e-01;
a01=arg[10]? arg[10][0] : 0;
a01=a00*a01;
a02=1.0288888888888890e+01;
a03=1.4142135623730951e+00;
a04=arg[1]? arg[1][0] : 0;
a04=sqrt(a04);
a05=a03*a04;
a06=arg[0]? arg[0][0] : 0;
a06=sqrt(a06);
a07=a05*a06;
a08=arg[4]? arg[4][0] : 0;
a08=sqrt(a08);
a09=arg[3]? arg[3][0] : 0;
a09=sqrt(a09);
a10=a08*a09;
a11=arg[2]? arg[2][0] : 0;
a11=sqrt(a11);
a12=a10*a11;
a07=a07/a12;
a13=a00*a07;
a14=a02<=a13;
a15=a13<=a02;
a15=a15+a14;
a14=a14/a15;
a02=casadi_fmax(a02,a13);
a13=1.2861111111111112e+01;
a15=a02<=a13;
a13=a13<=a02;
a13=a13+a15;
a15=a15/a13;
a13=arg[9]? arg[9][0] : 0;
a13=a15*a13;
a13=a14*a13;
a13=a00*a13;
a01=a01+a13;
a13=arg[8]? arg[8][0] : 0;
a01=a01+a13;
a13=a01/a12;
a02=arg[17]? arg[17][0] : 0;
a16=2.*a04;
a02=a02/a16;
a16=a03*a02;
a17=a13*a16;
a18=arg[26]? arg[26][0] : 0;
a18=a00*a18;
a19=arg[25]? arg[25][0] : 0;
a15=a15*a19;
a14=a14*a15;
a00=a00*a14;
a18=a18+a00;
a00=arg[24]? arg[24][0] : 0;
a18=a18+a00;
a00=a18/a12;
a14=a13/a12;
a15=arg[20]? arg[20][0] : 0;
a19=2.*a08;
a15=a15/a19;
a19=a09*a15;
a20=arg[19]? arg[19][0] : 0;
a21=2.*a09;
a20=a20/a21;
a21=a08*a20;
a19=a19+a21;
a21=a11*a19;
a22=arg[18]? arg[18][0] : 0;
a23=2.*a11;
a22=a22/a23;
a23=a10*a22;
a21=a21+a23;
a14=a14*a21;
a00=a00-a14;
a14=a05*a00;
a17=a17+a14;
a14=2.*a06;
a17=a17/a14;
a23=a05*a13;
a23=a23/a14;
a23=a23/a14;
a14=arg[16]? arg[16][0] : 0;
a24=2.*a06;
a14=a14/a24;
a24=2.*a14;
a23=a23*a24;
a17=a17-a23;
if (res[0]!=0) res[0][0]=a17;
a17=a13*a14;
a00=a06*a00;
a17=a17+a00;
a17=a03*a17;
a04=2.*a04;
a17=a17/a04;
a13=a06*a13;
a03=a03*a13;
a03=a03/a04;
a03=a03/a04;
a02=2.*a02;
a03=a03*a02;
a17=a17-a03;
if (res[1]!=0) res[1][0]=a17;
a17=a07/a12;
a03=a17*a01;
a19=a03*a19;
a06=a06*a16;
a05=a05*a14;
a06=a06+a05;
a06=a06/a12;
a07=a07/a12;
a07=a07*a21;
a06=a06-a07;
a06=a06/a12;
a12=a17/a12;
a12=a12*a21;
a06=a06-a12;
a01=a01*a06;
a17=a17*a18;
a01=a01+a17;
a17=a10*a01;
a19=a19+a17;
a17=2.*a11;
a19=a19/a17;
a10=a10*a03;
a10=a10/a17;
a10=a10/a17;
a17=2.*a22;
a10=a10*a17;
a19=a19-a10;
a19=-a19;
if (res[2]!=0) res[2][0]=a19;
a19=a11*a03;
a10=a19*a15;
a03=a03*a22;
a11=a11*a01;
a03=a03+a11;
a11=a08*a03;
a10=a10+a11;
a11=2.*a09;
a10=a10/a11;
a01=a08*a19;
a01=a01/a11;
a01=a01/a11;
a11=2.*a20;
a01=a01*a11;
a10=a10-a01;
a10=-a10;
if (res[3]!=0) res[3][0]=a10;
a20=a19*a20;
a03=a09*a03;
a20=a20+a03;
a08=2.*a08;
a20=a20/a08;
a09=a09*a19;
a09=a09/a08;
a09=a09/a08;
a15=2.*a15;
a09=a09*a15;
a20=a20-a09;
a20=-a20;
if (res[4]!=0) res[4][0]=a20;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_clause_winds(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f11(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_clause_winds_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_clause_winds_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_clause_winds_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_clause_winds_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_clause_winds_n_in(void) { return 27;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_clause_winds_n_out(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_clause_winds_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_clause_winds_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "g";
case 2: return "rho";
case 3: return "S_wing";
case 4: return "CL_max";
case 5: return "out_V_stall";
case 6: return "out_wind_large";
case 7: return "out_wind_small";
case 8: return "adj_V_stall";
case 9: return "adj_wind_large";
case 10: return "adj_wind_small";
case 11: return "out_adj_m";
case 12: return "out_adj_g";
case 13: return "out_adj_rho";
case 14: return "out_adj_S_wing";
case 15: return "out_adj_CL_max";
case 16: return "fwd_m";
case 17: return "fwd_g";
case 18: return "fwd_rho";
case 19: return "fwd_S_wing";
case 20: return "fwd_CL_max";
case 21: return "fwd_out_V_stall";
case 22: return "fwd_out_wind_large";
case 23: return "fwd_out_wind_small";
case 24: return "fwd_adj_V_stall";
case 25: return "fwd_adj_wind_large";
case 26: return "fwd_adj_wind_small";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_clause_winds_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_m";
case 1: return "fwd_adj_g";
case 2: return "fwd_adj_rho";
case 3: return "fwd_adj_S_wing";
case 4: return "fwd_adj_CL_max";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_clause_winds_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s1;
case 6: return casadi_s1;
case 7: return casadi_s1;
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
case 24: return casadi_s0;
case 25: return casadi_s0;
case 26: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_clause_winds_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_clause_winds_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 27;
if (sz_res) *sz_res = 5;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_clause_winds_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 27*sizeof(const casadi_real*);
if (sz_res) *sz_res = 5*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
