/* Generated from derive/ (digest 0a06213221c378cc) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`. */
/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
#define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
#define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
#define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
#define CASADI_PREFIX(ID) loads_ ## ID
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
#define casadi_f68 CASADI_PREFIX(f68)
#define casadi_f69 CASADI_PREFIX(f69)
#define casadi_f7 CASADI_PREFIX(f7)
#define casadi_f70 CASADI_PREFIX(f70)
#define casadi_f71 CASADI_PREFIX(f71)
#define casadi_f72 CASADI_PREFIX(f72)
#define casadi_f73 CASADI_PREFIX(f73)
#define casadi_f74 CASADI_PREFIX(f74)
#define casadi_f75 CASADI_PREFIX(f75)
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
#ifndef casadi_nan
#define casadi_nan NAN
#endif
casadi_real casadi_fmin(casadi_real x, casadi_real y) {
/* Pre-c99 compatibility */
#if __STDC_VERSION__ < 199901L
return x<y ? x : y;
#else
return fmin(x, y);
#endif
}
/* Configuration this file was compiled with */
CASADI_SYMBOL_EXPORT void loads_casadi_version(int* major, int* minor, int* patch) {
*major = 3;
*minor = 8;
*patch = 2;
}
CASADI_SYMBOL_EXPORT int loads_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int loads_casadi_real_size(void) { return (int) sizeof(casadi_real); }
static const casadi_int casadi_s0[3] = {1, 1, 1};
static const casadi_int casadi_s1[4] = {1, 1, 0, 0};
/* a_follows:(x_cg,x_main)->(a) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1;
a0=arg[0]? arg[0][0] : 0;
a1=arg[1]? arg[1][0] : 0;
a0=a0-a1;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int a_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f0(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int a_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void a_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void a_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void a_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int a_follows_n_in(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_int a_follows_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real a_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* a_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "x_cg";
case 1: return "x_main";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* a_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "a";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* a_follows_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* a_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int a_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 2;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int a_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 2*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_a_follows:(x_cg,x_main,out_a[1x1,0nz],fwd_x_cg,fwd_x_main)->(fwd_a) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1;
a0=arg[3]? arg[3][0] : 0;
a1=arg[4]? arg[4][0] : 0;
a0=a0-a1;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_a_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f1(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_a_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_a_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_a_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_a_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_a_follows_n_in(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_a_follows_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_a_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_a_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "x_cg";
case 1: return "x_main";
case 2: return "out_a";
case 3: return "fwd_x_cg";
case 4: return "fwd_x_main";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_a_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_a";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_a_follows_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s1;
case 3: return casadi_s0;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_a_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_a_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_a_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_a_follows:(x_cg,x_main,out_a[1x1,0nz],adj_a)->(adj_x_cg,adj_x_main) */
static int casadi_f2(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0;
a0=arg[3]? arg[3][0] : 0;
if (res[0]!=0) res[0][0]=a0;
a0=-a0;
if (res[1]!=0) res[1][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_a_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f2(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_a_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_a_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_a_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_a_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_a_follows_n_in(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_int adj1_a_follows_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real adj1_a_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_a_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "x_cg";
case 1: return "x_main";
case 2: return "out_a";
case 3: return "adj_a";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_a_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_x_cg";
case 1: return "adj_x_main";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_a_follows_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s1;
case 3: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_a_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_a_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 4;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_a_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 4*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_a_follows:(x_cg,x_main,out_a[1x1,0nz],adj_a,out_adj_x_cg[1x1,0nz],out_adj_x_main[1x1,0nz],fwd_x_cg,fwd_x_main,fwd_out_a[1x1,0nz],fwd_adj_a)->(fwd_adj_x_cg,fwd_adj_x_main) */
static int casadi_f3(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0;
a0=arg[9]? arg[9][0] : 0;
if (res[0]!=0) res[0][0]=a0;
a0=-a0;
if (res[1]!=0) res[1][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_a_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f3(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_a_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_a_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_a_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_a_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_a_follows_n_in(void) { return 10;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_a_follows_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_a_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_a_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "x_cg";
case 1: return "x_main";
case 2: return "out_a";
case 3: return "adj_a";
case 4: return "out_adj_x_cg";
case 5: return "out_adj_x_main";
case 6: return "fwd_x_cg";
case 7: return "fwd_x_main";
case 8: return "fwd_out_a";
case 9: return "fwd_adj_a";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_a_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_x_cg";
case 1: return "fwd_adj_x_main";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_a_follows_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_a_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_a_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 10;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_a_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* b_follows:(x_cg,x_tail)->(b) */
static int casadi_f4(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1;
a0=arg[1]? arg[1][0] : 0;
a1=arg[0]? arg[0][0] : 0;
a0=a0-a1;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int b_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f4(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int b_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void b_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void b_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void b_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int b_follows_n_in(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_int b_follows_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real b_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* b_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "x_cg";
case 1: return "x_tail";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* b_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "b";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* b_follows_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* b_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int b_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 2;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int b_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 2*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_b_follows:(x_cg,x_tail,out_b[1x1,0nz],fwd_x_cg,fwd_x_tail)->(fwd_b) */
static int casadi_f5(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1;
a0=arg[4]? arg[4][0] : 0;
a1=arg[3]? arg[3][0] : 0;
a0=a0-a1;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_b_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f5(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_b_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_b_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_b_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_b_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_b_follows_n_in(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_b_follows_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_b_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_b_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "x_cg";
case 1: return "x_tail";
case 2: return "out_b";
case 3: return "fwd_x_cg";
case 4: return "fwd_x_tail";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_b_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_b";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_b_follows_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s1;
case 3: return casadi_s0;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_b_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_b_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_b_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_b_follows:(x_cg,x_tail,out_b[1x1,0nz],adj_b)->(adj_x_cg,adj_x_tail) */
static int casadi_f6(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1;
a0=arg[3]? arg[3][0] : 0;
a1=-a0;
if (res[0]!=0) res[0][0]=a1;
if (res[1]!=0) res[1][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_b_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f6(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_b_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_b_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_b_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_b_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_b_follows_n_in(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_int adj1_b_follows_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real adj1_b_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_b_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "x_cg";
case 1: return "x_tail";
case 2: return "out_b";
case 3: return "adj_b";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_b_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_x_cg";
case 1: return "adj_x_tail";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_b_follows_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s1;
case 3: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_b_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_b_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 4;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_b_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 4*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_b_follows:(x_cg,x_tail,out_b[1x1,0nz],adj_b,out_adj_x_cg[1x1,0nz],out_adj_x_tail[1x1,0nz],fwd_x_cg,fwd_x_tail,fwd_out_b[1x1,0nz],fwd_adj_b)->(fwd_adj_x_cg,fwd_adj_x_tail) */
static int casadi_f7(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1;
a0=arg[9]? arg[9][0] : 0;
a1=-a0;
if (res[0]!=0) res[0][0]=a1;
if (res[1]!=0) res[1][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_b_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f7(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_b_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_b_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_b_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_b_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_b_follows_n_in(void) { return 10;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_b_follows_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_b_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_b_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "x_cg";
case 1: return "x_tail";
case 2: return "out_b";
case 3: return "adj_b";
case 4: return "out_adj_x_cg";
case 5: return "out_adj_x_tail";
case 6: return "fwd_x_cg";
case 7: return "fwd_x_tail";
case 8: return "fwd_out_b";
case 9: return "fwd_adj_b";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_b_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_x_cg";
case 1: return "fwd_adj_x_tail";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_b_follows_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_b_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_b_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 10;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_b_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* L_follows:(a,b)->(L) */
static int casadi_f8(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1;
a0=arg[0]? arg[0][0] : 0;
a1=arg[1]? arg[1][0] : 0;
a0=a0+a1;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int L_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f8(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int L_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void L_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void L_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void L_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int L_follows_n_in(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_int L_follows_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real L_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* L_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "a";
case 1: return "b";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* L_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "L";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* L_follows_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* L_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int L_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 2;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int L_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 2*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_L_follows:(a,b,out_L[1x1,0nz],fwd_a,fwd_b)->(fwd_L) */
static int casadi_f9(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1;
a0=arg[3]? arg[3][0] : 0;
a1=arg[4]? arg[4][0] : 0;
a0=a0+a1;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_L_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f9(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_L_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_L_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_L_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_L_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_L_follows_n_in(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_L_follows_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_L_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_L_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "a";
case 1: return "b";
case 2: return "out_L";
case 3: return "fwd_a";
case 4: return "fwd_b";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_L_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_L";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_L_follows_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s1;
case 3: return casadi_s0;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_L_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_L_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_L_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_L_follows:(a,b,out_L[1x1,0nz],adj_L)->(adj_a,adj_b) */
static int casadi_f10(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0;
a0=arg[3]? arg[3][0] : 0;
if (res[0]!=0) res[0][0]=a0;
if (res[1]!=0) res[1][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_L_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f10(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_L_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_L_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_L_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_L_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_L_follows_n_in(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_int adj1_L_follows_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real adj1_L_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_L_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "a";
case 1: return "b";
case 2: return "out_L";
case 3: return "adj_L";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_L_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_a";
case 1: return "adj_b";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_L_follows_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s1;
case 3: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_L_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_L_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 4;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_L_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 4*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_L_follows:(a,b,out_L[1x1,0nz],adj_L,out_adj_a[1x1,0nz],out_adj_b[1x1,0nz],fwd_a,fwd_b,fwd_out_L[1x1,0nz],fwd_adj_L)->(fwd_adj_a,fwd_adj_b) */
static int casadi_f11(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0;
a0=arg[9]? arg[9][0] : 0;
if (res[0]!=0) res[0][0]=a0;
if (res[1]!=0) res[1][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_L_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f11(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_L_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_L_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_L_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_L_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_L_follows_n_in(void) { return 10;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_L_follows_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_L_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_L_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "a";
case 1: return "b";
case 2: return "out_L";
case 3: return "adj_L";
case 4: return "out_adj_a";
case 5: return "out_adj_b";
case 6: return "fwd_a";
case 7: return "fwd_b";
case 8: return "fwd_out_L";
case 9: return "fwd_adj_L";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_L_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_a";
case 1: return "fwd_adj_b";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_L_follows_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_L_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_L_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 10;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_L_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* f_follows:(b,L)->(f) */
static int casadi_f12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1;
a0=arg[0]? arg[0][0] : 0;
a1=arg[1]? arg[1][0] : 0;
a0=a0/a1;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int f_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f12(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int f_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void f_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void f_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void f_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int f_follows_n_in(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_int f_follows_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real f_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* f_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "b";
case 1: return "L";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* f_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "f";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* f_follows_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* f_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int f_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 2;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int f_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 2*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_f_follows:(b,L,out_f[1x1,0nz],fwd_b,fwd_L)->(fwd_f) */
static int casadi_f13(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
CASADI_SYMBOL_EXPORT int fwd1_f_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f13(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_f_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_f_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_f_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_f_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_f_follows_n_in(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_f_follows_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_f_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_f_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "b";
case 1: return "L";
case 2: return "out_f";
case 3: return "fwd_b";
case 4: return "fwd_L";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_f_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_f";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_f_follows_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s1;
case 3: return casadi_s0;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_f_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_f_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_f_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_f_follows:(b,L,out_f[1x1,0nz],adj_f)->(adj_b,adj_L) */
static int casadi_f14(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
CASADI_SYMBOL_EXPORT int adj1_f_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f14(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_f_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_f_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_f_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_f_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_f_follows_n_in(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_int adj1_f_follows_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real adj1_f_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_f_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "b";
case 1: return "L";
case 2: return "out_f";
case 3: return "adj_f";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_f_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_b";
case 1: return "adj_L";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_f_follows_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s1;
case 3: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_f_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_f_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 4;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_f_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 4*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_f_follows:(b,L,out_f[1x1,0nz],adj_f,out_adj_b[1x1,0nz],out_adj_L[1x1,0nz],fwd_b,fwd_L,fwd_out_f[1x1,0nz],fwd_adj_f)->(fwd_adj_b,fwd_adj_L) */
static int casadi_f15(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
CASADI_SYMBOL_EXPORT int fwd1_adj1_f_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f15(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_f_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_f_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_f_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_f_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_f_follows_n_in(void) { return 10;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_f_follows_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_f_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_f_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "b";
case 1: return "L";
case 2: return "out_f";
case 3: return "adj_f";
case 4: return "out_adj_b";
case 5: return "out_adj_L";
case 6: return "fwd_b";
case 7: return "fwd_L";
case 8: return "fwd_out_f";
case 9: return "fwd_adj_f";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_f_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_b";
case 1: return "fwd_adj_L";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_f_follows_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_f_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_f_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 10;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_f_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* Fz_follows:(m,g,f)->(Fz) */
static int casadi_f16(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1;
a0=5.0000000000000000e-01;
a1=arg[2]? arg[2][0] : 0;
a0=a0*a1;
a1=arg[1]? arg[1][0] : 0;
a0=a0*a1;
a1=arg[0]? arg[0][0] : 0;
a0=a0*a1;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int Fz_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f16(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int Fz_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void Fz_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void Fz_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void Fz_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int Fz_follows_n_in(void) { return 3;}
CASADI_SYMBOL_EXPORT casadi_int Fz_follows_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real Fz_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* Fz_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "g";
case 2: return "f";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* Fz_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "Fz";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* Fz_follows_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* Fz_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int Fz_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 3;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int Fz_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 3*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_Fz_follows:(m,g,f,out_Fz[1x1,0nz],fwd_m,fwd_g,fwd_f)->(fwd_Fz) */
static int casadi_f17(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4;
a0=arg[0]? arg[0][0] : 0;
a1=arg[1]? arg[1][0] : 0;
a2=5.0000000000000000e-01;
a3=arg[6]? arg[6][0] : 0;
a3=a2*a3;
a3=a1*a3;
a4=arg[2]? arg[2][0] : 0;
a2=a2*a4;
a4=arg[5]? arg[5][0] : 0;
a4=a2*a4;
a3=a3+a4;
a0=a0*a3;
a2=a2*a1;
a1=arg[4]? arg[4][0] : 0;
a2=a2*a1;
a0=a0+a2;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_Fz_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f17(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_Fz_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_Fz_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_Fz_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_Fz_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_Fz_follows_n_in(void) { return 7;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_Fz_follows_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_Fz_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_Fz_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "g";
case 2: return "f";
case 3: return "out_Fz";
case 4: return "fwd_m";
case 5: return "fwd_g";
case 6: return "fwd_f";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_Fz_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_Fz";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_Fz_follows_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_Fz_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_Fz_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 7;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_Fz_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 7*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_Fz_follows:(m,g,f,out_Fz[1x1,0nz],adj_Fz)->(adj_m,adj_g,adj_f) */
static int casadi_f18(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4;
a0=5.0000000000000000e-01;
a1=arg[2]? arg[2][0] : 0;
a1=a0*a1;
a2=arg[1]? arg[1][0] : 0;
a3=a1*a2;
a4=arg[4]? arg[4][0] : 0;
a3=a3*a4;
if (res[0]!=0) res[0][0]=a3;
a3=arg[0]? arg[0][0] : 0;
a3=a3*a4;
a1=a1*a3;
if (res[1]!=0) res[1][0]=a1;
a2=a2*a3;
a0=a0*a2;
if (res[2]!=0) res[2][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_Fz_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f18(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_Fz_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_Fz_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_Fz_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_Fz_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_Fz_follows_n_in(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_int adj1_Fz_follows_n_out(void) { return 3;}
CASADI_SYMBOL_EXPORT casadi_real adj1_Fz_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_Fz_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "g";
case 2: return "f";
case 3: return "out_Fz";
case 4: return "adj_Fz";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_Fz_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_m";
case 1: return "adj_g";
case 2: return "adj_f";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_Fz_follows_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s1;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_Fz_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_Fz_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5;
if (sz_res) *sz_res = 3;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_Fz_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
if (sz_res) *sz_res = 3*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_Fz_follows:(m,g,f,out_Fz[1x1,0nz],adj_Fz,out_adj_m[1x1,0nz],out_adj_g[1x1,0nz],out_adj_f[1x1,0nz],fwd_m,fwd_g,fwd_f,fwd_out_Fz[1x1,0nz],fwd_adj_Fz)->(fwd_adj_m,fwd_adj_g,fwd_adj_f) */
static int casadi_f19(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5, a6, a7, a8, a9;
a0=arg[4]? arg[4][0] : 0;
a1=arg[1]? arg[1][0] : 0;
a2=5.0000000000000000e-01;
a3=arg[10]? arg[10][0] : 0;
a3=a2*a3;
a4=a1*a3;
a5=arg[2]? arg[2][0] : 0;
a5=a2*a5;
a6=arg[9]? arg[9][0] : 0;
a7=a5*a6;
a4=a4+a7;
a4=a0*a4;
a7=a5*a1;
a8=arg[12]? arg[12][0] : 0;
a7=a7*a8;
a4=a4+a7;
if (res[0]!=0) res[0][0]=a4;
a4=arg[0]? arg[0][0] : 0;
a7=a4*a0;
a3=a7*a3;
a9=arg[8]? arg[8][0] : 0;
a0=a0*a9;
a4=a4*a8;
a0=a0+a4;
a5=a5*a0;
a3=a3+a5;
if (res[1]!=0) res[1][0]=a3;
a7=a7*a6;
a1=a1*a0;
a7=a7+a1;
a2=a2*a7;
if (res[2]!=0) res[2][0]=a2;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_Fz_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f19(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_Fz_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_Fz_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_Fz_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_Fz_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_Fz_follows_n_in(void) { return 13;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_Fz_follows_n_out(void) { return 3;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_Fz_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_Fz_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "g";
case 2: return "f";
case 3: return "out_Fz";
case 4: return "adj_Fz";
case 5: return "out_adj_m";
case 6: return "out_adj_g";
case 7: return "out_adj_f";
case 8: return "fwd_m";
case 9: return "fwd_g";
case 10: return "fwd_f";
case 11: return "fwd_out_Fz";
case 12: return "fwd_adj_Fz";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_Fz_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_m";
case 1: return "fwd_adj_g";
case 2: return "fwd_adj_f";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_Fz_follows_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_Fz_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_Fz_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 13;
if (sz_res) *sz_res = 3;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_Fz_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 13*sizeof(const casadi_real*);
if (sz_res) *sz_res = 3*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* F_tail_load_follows:(m,g,f)->(F_tail_load) */
static int casadi_f20(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2;
a0=arg[1]? arg[1][0] : 0;
a1=arg[0]? arg[0][0] : 0;
a0=a0*a1;
a1=1.;
a2=arg[2]? arg[2][0] : 0;
a1=a1-a2;
a0=a0*a1;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int F_tail_load_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f20(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int F_tail_load_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void F_tail_load_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void F_tail_load_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void F_tail_load_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int F_tail_load_follows_n_in(void) { return 3;}
CASADI_SYMBOL_EXPORT casadi_int F_tail_load_follows_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real F_tail_load_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* F_tail_load_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "g";
case 2: return "f";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* F_tail_load_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "F_tail_load";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* F_tail_load_follows_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* F_tail_load_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int F_tail_load_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 3;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int F_tail_load_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 3*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_F_tail_load_follows:(m,g,f,out_F_tail_load[1x1,0nz],fwd_m,fwd_g,fwd_f)->(fwd_F_tail_load) */
static int casadi_f21(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4;
a0=1.;
a1=arg[2]? arg[2][0] : 0;
a0=a0-a1;
a1=arg[0]? arg[0][0] : 0;
a2=arg[5]? arg[5][0] : 0;
a2=a1*a2;
a3=arg[1]? arg[1][0] : 0;
a4=arg[4]? arg[4][0] : 0;
a4=a3*a4;
a2=a2+a4;
a0=a0*a2;
a3=a3*a1;
a1=arg[6]? arg[6][0] : 0;
a3=a3*a1;
a0=a0-a3;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_F_tail_load_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f21(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_F_tail_load_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_F_tail_load_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_F_tail_load_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_F_tail_load_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_F_tail_load_follows_n_in(void) { return 7;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_F_tail_load_follows_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_F_tail_load_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_F_tail_load_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "g";
case 2: return "f";
case 3: return "out_F_tail_load";
case 4: return "fwd_m";
case 5: return "fwd_g";
case 6: return "fwd_f";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_F_tail_load_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_F_tail_load";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_F_tail_load_follows_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_F_tail_load_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_F_tail_load_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 7;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_F_tail_load_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 7*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_F_tail_load_follows:(m,g,f,out_F_tail_load[1x1,0nz],adj_F_tail_load)->(adj_m,adj_g,adj_f) */
static int casadi_f22(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3;
a0=arg[1]? arg[1][0] : 0;
a1=1.;
a2=arg[2]? arg[2][0] : 0;
a1=a1-a2;
a2=arg[4]? arg[4][0] : 0;
a1=a1*a2;
a3=a0*a1;
if (res[0]!=0) res[0][0]=a3;
a3=arg[0]? arg[0][0] : 0;
a1=a3*a1;
if (res[1]!=0) res[1][0]=a1;
a0=a0*a3;
a0=a0*a2;
a0=-a0;
if (res[2]!=0) res[2][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_F_tail_load_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f22(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_F_tail_load_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_F_tail_load_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_F_tail_load_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_F_tail_load_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_F_tail_load_follows_n_in(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_int adj1_F_tail_load_follows_n_out(void) { return 3;}
CASADI_SYMBOL_EXPORT casadi_real adj1_F_tail_load_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_F_tail_load_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "g";
case 2: return "f";
case 3: return "out_F_tail_load";
case 4: return "adj_F_tail_load";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_F_tail_load_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_m";
case 1: return "adj_g";
case 2: return "adj_f";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_F_tail_load_follows_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s1;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_F_tail_load_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_F_tail_load_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5;
if (sz_res) *sz_res = 3;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_F_tail_load_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
if (sz_res) *sz_res = 3*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_F_tail_load_follows:(m,g,f,out_F_tail_load[1x1,0nz],adj_F_tail_load,out_adj_m[1x1,0nz],out_adj_g[1x1,0nz],out_adj_f[1x1,0nz],fwd_m,fwd_g,fwd_f,fwd_out_F_tail_load[1x1,0nz],fwd_adj_F_tail_load)->(fwd_adj_m,fwd_adj_g,fwd_adj_f) */
static int casadi_f23(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5, a6, a7;
a0=1.;
a1=arg[2]? arg[2][0] : 0;
a0=a0-a1;
a1=arg[4]? arg[4][0] : 0;
a2=a0*a1;
a3=arg[9]? arg[9][0] : 0;
a4=a2*a3;
a5=arg[1]? arg[1][0] : 0;
a6=arg[12]? arg[12][0] : 0;
a0=a0*a6;
a7=arg[10]? arg[10][0] : 0;
a7=a1*a7;
a0=a0-a7;
a7=a5*a0;
a4=a4+a7;
if (res[0]!=0) res[0][0]=a4;
a4=arg[8]? arg[8][0] : 0;
a2=a2*a4;
a7=arg[0]? arg[0][0] : 0;
a0=a7*a0;
a2=a2+a0;
if (res[1]!=0) res[1][0]=a2;
a3=a7*a3;
a4=a5*a4;
a3=a3+a4;
a1=a1*a3;
a5=a5*a7;
a5=a5*a6;
a1=a1+a5;
a1=-a1;
if (res[2]!=0) res[2][0]=a1;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_F_tail_load_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f23(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_F_tail_load_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_F_tail_load_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_F_tail_load_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_F_tail_load_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_F_tail_load_follows_n_in(void) { return 13;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_F_tail_load_follows_n_out(void) { return 3;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_F_tail_load_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_F_tail_load_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "g";
case 2: return "f";
case 3: return "out_F_tail_load";
case 4: return "adj_F_tail_load";
case 5: return "out_adj_m";
case 6: return "out_adj_g";
case 7: return "out_adj_f";
case 8: return "fwd_m";
case 9: return "fwd_g";
case 10: return "fwd_f";
case 11: return "fwd_out_F_tail_load";
case 12: return "fwd_adj_F_tail_load";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_F_tail_load_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_m";
case 1: return "fwd_adj_g";
case 2: return "fwd_adj_f";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_F_tail_load_follows_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_F_tail_load_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_F_tail_load_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 13;
if (sz_res) *sz_res = 3;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_F_tail_load_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 13*sizeof(const casadi_real*);
if (sz_res) *sz_res = 3*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* C_alpha_follows:(Fz,B3,C3)->(C_alpha) */
static int casadi_f24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2;
a0=arg[1]? arg[1][0] : 0;
a1=arg[2]? arg[2][0] : 0;
a2=arg[0]? arg[0][0] : 0;
a1=a1*a2;
a0=a0+a1;
a0=a0*a2;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int C_alpha_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f24(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int C_alpha_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void C_alpha_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void C_alpha_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void C_alpha_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int C_alpha_follows_n_in(void) { return 3;}
CASADI_SYMBOL_EXPORT casadi_int C_alpha_follows_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real C_alpha_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* C_alpha_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz";
case 1: return "B3";
case 2: return "C3";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* C_alpha_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "C_alpha";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* C_alpha_follows_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* C_alpha_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int C_alpha_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 3;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int C_alpha_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 3*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_C_alpha_follows:(Fz,B3,C3,out_C_alpha[1x1,0nz],fwd_Fz,fwd_B3,fwd_C3)->(fwd_C_alpha) */
static int casadi_f25(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5;
a0=arg[0]? arg[0][0] : 0;
a1=arg[5]? arg[5][0] : 0;
a2=arg[6]? arg[6][0] : 0;
a2=a0*a2;
a3=arg[2]? arg[2][0] : 0;
a4=arg[4]? arg[4][0] : 0;
a5=a3*a4;
a2=a2+a5;
a1=a1+a2;
a1=a0*a1;
a2=arg[1]? arg[1][0] : 0;
a3=a3*a0;
a2=a2+a3;
a2=a2*a4;
a1=a1+a2;
if (res[0]!=0) res[0][0]=a1;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_C_alpha_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f25(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_C_alpha_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_C_alpha_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_C_alpha_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_C_alpha_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_C_alpha_follows_n_in(void) { return 7;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_C_alpha_follows_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_C_alpha_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_C_alpha_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz";
case 1: return "B3";
case 2: return "C3";
case 3: return "out_C_alpha";
case 4: return "fwd_Fz";
case 5: return "fwd_B3";
case 6: return "fwd_C3";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_C_alpha_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_C_alpha";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_C_alpha_follows_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_C_alpha_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_C_alpha_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 7;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_C_alpha_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 7*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_C_alpha_follows:(Fz,B3,C3,out_C_alpha[1x1,0nz],adj_C_alpha)->(adj_Fz,adj_B3,adj_C3) */
static int casadi_f26(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3;
a0=arg[1]? arg[1][0] : 0;
a1=arg[2]? arg[2][0] : 0;
a2=arg[0]? arg[0][0] : 0;
a3=a1*a2;
a0=a0+a3;
a3=arg[4]? arg[4][0] : 0;
a0=a0*a3;
a3=a2*a3;
a1=a1*a3;
a0=a0+a1;
if (res[0]!=0) res[0][0]=a0;
if (res[1]!=0) res[1][0]=a3;
a2=a2*a3;
if (res[2]!=0) res[2][0]=a2;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_C_alpha_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f26(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_C_alpha_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_C_alpha_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_C_alpha_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_C_alpha_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_C_alpha_follows_n_in(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_int adj1_C_alpha_follows_n_out(void) { return 3;}
CASADI_SYMBOL_EXPORT casadi_real adj1_C_alpha_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_C_alpha_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz";
case 1: return "B3";
case 2: return "C3";
case 3: return "out_C_alpha";
case 4: return "adj_C_alpha";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_C_alpha_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_Fz";
case 1: return "adj_B3";
case 2: return "adj_C3";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_C_alpha_follows_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s1;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_C_alpha_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_C_alpha_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5;
if (sz_res) *sz_res = 3;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_C_alpha_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
if (sz_res) *sz_res = 3*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_C_alpha_follows:(Fz,B3,C3,out_C_alpha[1x1,0nz],adj_C_alpha,out_adj_Fz[1x1,0nz],out_adj_B3[1x1,0nz],out_adj_C3[1x1,0nz],fwd_Fz,fwd_B3,fwd_C3,fwd_out_C_alpha[1x1,0nz],fwd_adj_C_alpha)->(fwd_adj_Fz,fwd_adj_B3,fwd_adj_C3) */
static int casadi_f27(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5, a6, a7;
a0=arg[4]? arg[4][0] : 0;
a1=arg[9]? arg[9][0] : 0;
a2=arg[0]? arg[0][0] : 0;
a3=arg[10]? arg[10][0] : 0;
a4=a2*a3;
a5=arg[2]? arg[2][0] : 0;
a6=arg[8]? arg[8][0] : 0;
a7=a5*a6;
a4=a4+a7;
a1=a1+a4;
a1=a0*a1;
a4=arg[1]? arg[1][0] : 0;
a7=a5*a2;
a4=a4+a7;
a7=arg[12]? arg[12][0] : 0;
a4=a4*a7;
a1=a1+a4;
a4=a2*a0;
a3=a4*a3;
a0=a0*a6;
a7=a2*a7;
a0=a0+a7;
a5=a5*a0;
a3=a3+a5;
a1=a1+a3;
if (res[0]!=0) res[0][0]=a1;
if (res[1]!=0) res[1][0]=a0;
a4=a4*a6;
a2=a2*a0;
a4=a4+a2;
if (res[2]!=0) res[2][0]=a4;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_C_alpha_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f27(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_C_alpha_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_C_alpha_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_C_alpha_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_C_alpha_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_C_alpha_follows_n_in(void) { return 13;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_C_alpha_follows_n_out(void) { return 3;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_C_alpha_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_C_alpha_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz";
case 1: return "B3";
case 2: return "C3";
case 3: return "out_C_alpha";
case 4: return "adj_C_alpha";
case 5: return "out_adj_Fz";
case 6: return "out_adj_B3";
case 7: return "out_adj_C3";
case 8: return "fwd_Fz";
case 9: return "fwd_B3";
case 10: return "fwd_C3";
case 11: return "fwd_out_C_alpha";
case 12: return "fwd_adj_C_alpha";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_C_alpha_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_Fz";
case 1: return "fwd_adj_B3";
case 2: return "fwd_adj_C3";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_C_alpha_follows_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_C_alpha_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_C_alpha_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 13;
if (sz_res) *sz_res = 3;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_C_alpha_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 13*sizeof(const casadi_real*);
if (sz_res) *sz_res = 3*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* Ct_follows:(F_tail_load,K1,K2,K3,K4)->(Ct) */
static int casadi_f28(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3;
a0=arg[0]? arg[0][0] : 0;
a1=casadi_sq(a0);
a1=casadi_sq(a1);
a2=arg[4]? arg[4][0] : 0;
a1=a1*a2;
a2=casadi_sq(a0);
a2=a0*a2;
a3=arg[3]? arg[3][0] : 0;
a2=a2*a3;
a1=a1+a2;
a2=casadi_sq(a0);
a3=arg[2]? arg[2][0] : 0;
a2=a2*a3;
a1=a1+a2;
a2=arg[1]? arg[1][0] : 0;
a0=a0*a2;
a1=a1+a0;
if (res[0]!=0) res[0][0]=a1;
return 0;
}
CASADI_SYMBOL_EXPORT int Ct_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f28(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int Ct_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void Ct_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void Ct_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void Ct_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int Ct_follows_n_in(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_int Ct_follows_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real Ct_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* Ct_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "F_tail_load";
case 1: return "K1";
case 2: return "K2";
case 3: return "K3";
case 4: return "K4";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* Ct_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* Ct_follows_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* Ct_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int Ct_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int Ct_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_Ct_follows:(F_tail_load,K1,K2,K3,K4,out_Ct[1x1,0nz],fwd_F_tail_load,fwd_K1,fwd_K2,fwd_K3,fwd_K4)->(fwd_Ct) */
static int casadi_f29(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5, a6;
a0=arg[4]? arg[4][0] : 0;
a1=arg[0]? arg[0][0] : 0;
a2=casadi_sq(a1);
a3=2.*a2;
a4=2.*a1;
a5=arg[6]? arg[6][0] : 0;
a4=a4*a5;
a3=a3*a4;
a0=a0*a3;
a2=casadi_sq(a2);
a3=arg[10]? arg[10][0] : 0;
a2=a2*a3;
a0=a0+a2;
a2=arg[3]? arg[3][0] : 0;
a3=casadi_sq(a1);
a4=a3*a5;
a6=2.*a1;
a6=a6*a5;
a6=a1*a6;
a4=a4+a6;
a2=a2*a4;
a3=a1*a3;
a4=arg[9]? arg[9][0] : 0;
a3=a3*a4;
a2=a2+a3;
a0=a0+a2;
a2=arg[2]? arg[2][0] : 0;
a3=2.*a1;
a3=a3*a5;
a2=a2*a3;
a3=casadi_sq(a1);
a4=arg[8]? arg[8][0] : 0;
a3=a3*a4;
a2=a2+a3;
a0=a0+a2;
a2=arg[1]? arg[1][0] : 0;
a2=a2*a5;
a5=arg[7]? arg[7][0] : 0;
a1=a1*a5;
a2=a2+a1;
a0=a0+a2;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_Ct_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f29(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_Ct_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_Ct_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_Ct_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_Ct_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_Ct_follows_n_in(void) { return 11;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_Ct_follows_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_Ct_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_Ct_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "F_tail_load";
case 1: return "K1";
case 2: return "K2";
case 3: return "K3";
case 4: return "K4";
case 5: return "out_Ct";
case 6: return "fwd_F_tail_load";
case 7: return "fwd_K1";
case 8: return "fwd_K2";
case 9: return "fwd_K3";
case 10: return "fwd_K4";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_Ct_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_Ct_follows_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_Ct_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_Ct_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 11;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_Ct_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 11*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_Ct_follows:(F_tail_load,K1,K2,K3,K4,out_Ct[1x1,0nz],adj_Ct)->(adj_F_tail_load,adj_K1,adj_K2,adj_K3,adj_K4) */
static int casadi_f30(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5, a6, a7;
a0=arg[1]? arg[1][0] : 0;
a1=arg[6]? arg[6][0] : 0;
a0=a0*a1;
a2=arg[0]? arg[0][0] : 0;
a3=2.*a2;
a4=arg[2]? arg[2][0] : 0;
a4=a4*a1;
a3=a3*a4;
a0=a0+a3;
a3=casadi_sq(a2);
a4=arg[3]? arg[3][0] : 0;
a4=a4*a1;
a5=a3*a4;
a0=a0+a5;
a5=2.*a2;
a4=a2*a4;
a5=a5*a4;
a0=a0+a5;
a5=2.*a2;
a4=casadi_sq(a2);
a6=2.*a4;
a7=arg[4]? arg[4][0] : 0;
a7=a7*a1;
a6=a6*a7;
a5=a5*a6;
a0=a0+a5;
if (res[0]!=0) res[0][0]=a0;
a0=a2*a1;
if (res[1]!=0) res[1][0]=a0;
a0=casadi_sq(a2);
a0=a0*a1;
if (res[2]!=0) res[2][0]=a0;
a2=a2*a3;
a2=a2*a1;
if (res[3]!=0) res[3][0]=a2;
a4=casadi_sq(a4);
a4=a4*a1;
if (res[4]!=0) res[4][0]=a4;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_Ct_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f30(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_Ct_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_Ct_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_Ct_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_Ct_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_Ct_follows_n_in(void) { return 7;}
CASADI_SYMBOL_EXPORT casadi_int adj1_Ct_follows_n_out(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_real adj1_Ct_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_Ct_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "F_tail_load";
case 1: return "K1";
case 2: return "K2";
case 3: return "K3";
case 4: return "K4";
case 5: return "out_Ct";
case 6: return "adj_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_Ct_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_F_tail_load";
case 1: return "adj_K1";
case 2: return "adj_K2";
case 3: return "adj_K3";
case 4: return "adj_K4";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_Ct_follows_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* adj1_Ct_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_Ct_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 7;
if (sz_res) *sz_res = 5;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_Ct_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 7*sizeof(const casadi_real*);
if (sz_res) *sz_res = 5*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_Ct_follows:(F_tail_load,K1,K2,K3,K4,out_Ct[1x1,0nz],adj_Ct,out_adj_F_tail_load[1x1,0nz],out_adj_K1[1x1,0nz],out_adj_K2[1x1,0nz],out_adj_K3[1x1,0nz],out_adj_K4[1x1,0nz],fwd_F_tail_load,fwd_K1,fwd_K2,fwd_K3,fwd_K4,fwd_out_Ct[1x1,0nz],fwd_adj_Ct)->(fwd_adj_F_tail_load,fwd_adj_K1,fwd_adj_K2,fwd_adj_K3,fwd_adj_K4) */
static int casadi_f31(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14;
a00=arg[6]? arg[6][0] : 0;
a01=arg[13]? arg[13][0] : 0;
a01=a00*a01;
a02=arg[1]? arg[1][0] : 0;
a03=arg[18]? arg[18][0] : 0;
a02=a02*a03;
a01=a01+a02;
a02=arg[2]? arg[2][0] : 0;
a04=a02*a00;
a05=arg[12]? arg[12][0] : 0;
a06=2.*a05;
a04=a04*a06;
a06=arg[0]? arg[0][0] : 0;
a07=2.*a06;
a08=arg[14]? arg[14][0] : 0;
a08=a00*a08;
a02=a02*a03;
a08=a08+a02;
a07=a07*a08;
a04=a04+a07;
a01=a01+a04;
a04=arg[3]? arg[3][0] : 0;
a07=a04*a00;
a08=2.*a06;
a08=a08*a05;
a02=a07*a08;
a09=casadi_sq(a06);
a10=arg[15]? arg[15][0] : 0;
a10=a00*a10;
a04=a04*a03;
a10=a10+a04;
a04=a09*a10;
a02=a02+a04;
a01=a01+a02;
a02=a06*a07;
a04=2.*a05;
a02=a02*a04;
a04=2.*a06;
a07=a07*a05;
a10=a06*a10;
a07=a07+a10;
a04=a04*a07;
a02=a02+a04;
a01=a01+a02;
a02=casadi_sq(a06);
a04=2.*a02;
a07=arg[4]? arg[4][0] : 0;
a10=a07*a00;
a11=a04*a10;
a12=2.*a05;
a11=a11*a12;
a12=2.*a06;
a13=2.*a06;
a13=a13*a05;
a14=2.*a13;
a10=a10*a14;
a14=arg[16]? arg[16][0] : 0;
a14=a00*a14;
a07=a07*a03;
a14=a14+a07;
a04=a04*a14;
a10=a10+a04;
a12=a12*a10;
a11=a11+a12;
a01=a01+a11;
if (res[0]!=0) res[0][0]=a01;
a01=a00*a05;
a11=a06*a03;
a01=a01+a11;
if (res[1]!=0) res[1][0]=a01;
a01=2.*a06;
a01=a01*a05;
a01=a00*a01;
a11=casadi_sq(a06);
a11=a11*a03;
a01=a01+a11;
if (res[2]!=0) res[2][0]=a01;
a05=a09*a05;
a08=a06*a08;
a05=a05+a08;
a05=a00*a05;
a06=a06*a09;
a06=a06*a03;
a05=a05+a06;
if (res[3]!=0) res[3][0]=a05;
a05=2.*a02;
a05=a05*a13;
a00=a00*a05;
a02=casadi_sq(a02);
a02=a02*a03;
a00=a00+a02;
if (res[4]!=0) res[4][0]=a00;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_Ct_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f31(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_Ct_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_Ct_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_Ct_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_Ct_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_Ct_follows_n_in(void) { return 19;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_Ct_follows_n_out(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_Ct_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_Ct_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "F_tail_load";
case 1: return "K1";
case 2: return "K2";
case 3: return "K3";
case 4: return "K4";
case 5: return "out_Ct";
case 6: return "adj_Ct";
case 7: return "out_adj_F_tail_load";
case 8: return "out_adj_K1";
case 9: return "out_adj_K2";
case 10: return "out_adj_K3";
case 11: return "out_adj_K4";
case 12: return "fwd_F_tail_load";
case 13: return "fwd_K1";
case 14: return "fwd_K2";
case 15: return "fwd_K3";
case 16: return "fwd_K4";
case 17: return "fwd_out_Ct";
case 18: return "fwd_adj_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_Ct_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_F_tail_load";
case 1: return "fwd_adj_K1";
case 2: return "fwd_adj_K2";
case 3: return "fwd_adj_K3";
case 4: return "fwd_adj_K4";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_Ct_follows_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_Ct_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_Ct_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 19;
if (sz_res) *sz_res = 5;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_Ct_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 19*sizeof(const casadi_real*);
if (sz_res) *sz_res = 5*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* f_follows_with_nose_wheel:(a,x_cg,x_nose)->(f) */
static int casadi_f32(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4;
a0=arg[0]? arg[0][0] : 0;
a1=0.;
a1=a0<a1;
a2=arg[2]? arg[2][0] : 0;
a3=arg[1]? arg[1][0] : 0;
a4=a2-a3;
a0=a0-a3;
a0=a0+a2;
a4=a4/a0;
a4=a1?a4:0;
a1=!a1;
a0=casadi_nan;
a1=a1?a0:0;
a4=a4+a1;
if (res[0]!=0) res[0][0]=a4;
return 0;
}
CASADI_SYMBOL_EXPORT int f_follows_with_nose_wheel(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f32(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int f_follows_with_nose_wheel_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void f_follows_with_nose_wheel_release(int mem) {
}
CASADI_SYMBOL_EXPORT void f_follows_with_nose_wheel_incref(void) {
}
CASADI_SYMBOL_EXPORT void f_follows_with_nose_wheel_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int f_follows_with_nose_wheel_n_in(void) { return 3;}
CASADI_SYMBOL_EXPORT casadi_int f_follows_with_nose_wheel_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real f_follows_with_nose_wheel_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* f_follows_with_nose_wheel_name_in(casadi_int i) {
switch (i) {
case 0: return "a";
case 1: return "x_cg";
case 2: return "x_nose";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* f_follows_with_nose_wheel_name_out(casadi_int i) {
switch (i) {
case 0: return "f";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* f_follows_with_nose_wheel_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* f_follows_with_nose_wheel_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int f_follows_with_nose_wheel_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 3;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int f_follows_with_nose_wheel_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 3*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_f_follows_with_nose_wheel:(a,x_cg,x_nose,out_f[1x1,0nz],fwd_a,fwd_x_cg,fwd_x_nose)->(fwd_f) */
static int casadi_f33(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5, a6;
a0=arg[0]? arg[0][0] : 0;
a1=0.;
a1=a0<a1;
a2=arg[6]? arg[6][0] : 0;
a3=arg[5]? arg[5][0] : 0;
a4=a2-a3;
a5=arg[1]? arg[1][0] : 0;
a0=a0-a5;
a6=arg[2]? arg[2][0] : 0;
a0=a0+a6;
a4=a4/a0;
a6=a6-a5;
a6=a6/a0;
a6=a6/a0;
a0=arg[4]? arg[4][0] : 0;
a0=a0-a3;
a0=a0+a2;
a6=a6*a0;
a4=a4-a6;
a1=a1?a4:0;
if (res[0]!=0) res[0][0]=a1;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_f_follows_with_nose_wheel(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f33(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_f_follows_with_nose_wheel_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_f_follows_with_nose_wheel_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_f_follows_with_nose_wheel_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_f_follows_with_nose_wheel_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_f_follows_with_nose_wheel_n_in(void) { return 7;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_f_follows_with_nose_wheel_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_f_follows_with_nose_wheel_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_f_follows_with_nose_wheel_name_in(casadi_int i) {
switch (i) {
case 0: return "a";
case 1: return "x_cg";
case 2: return "x_nose";
case 3: return "out_f";
case 4: return "fwd_a";
case 5: return "fwd_x_cg";
case 6: return "fwd_x_nose";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_f_follows_with_nose_wheel_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_f";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_f_follows_with_nose_wheel_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_f_follows_with_nose_wheel_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_f_follows_with_nose_wheel_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 7;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_f_follows_with_nose_wheel_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 7*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_f_follows_with_nose_wheel:(a,x_cg,x_nose,out_f[1x1,0nz],adj_f)->(adj_a,adj_x_cg,adj_x_nose) */
static int casadi_f34(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4;
a0=arg[0]? arg[0][0] : 0;
a1=0.;
a1=a0<a1;
a2=arg[2]? arg[2][0] : 0;
a3=arg[1]? arg[1][0] : 0;
a4=a2-a3;
a0=a0-a3;
a0=a0+a2;
a4=a4/a0;
a4=a4/a0;
a2=arg[4]? arg[4][0] : 0;
a4=a4*a2;
a3=-a4;
a3=a1?a3:0;
if (res[0]!=0) res[0][0]=a3;
a2=a2/a0;
a0=a4-a2;
a0=a1?a0:0;
if (res[1]!=0) res[1][0]=a0;
a2=a2-a4;
a1=a1?a2:0;
if (res[2]!=0) res[2][0]=a1;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_f_follows_with_nose_wheel(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f34(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_f_follows_with_nose_wheel_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_f_follows_with_nose_wheel_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_f_follows_with_nose_wheel_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_f_follows_with_nose_wheel_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_f_follows_with_nose_wheel_n_in(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_int adj1_f_follows_with_nose_wheel_n_out(void) { return 3;}
CASADI_SYMBOL_EXPORT casadi_real adj1_f_follows_with_nose_wheel_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_f_follows_with_nose_wheel_name_in(casadi_int i) {
switch (i) {
case 0: return "a";
case 1: return "x_cg";
case 2: return "x_nose";
case 3: return "out_f";
case 4: return "adj_f";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_f_follows_with_nose_wheel_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_a";
case 1: return "adj_x_cg";
case 2: return "adj_x_nose";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_f_follows_with_nose_wheel_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s1;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_f_follows_with_nose_wheel_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_f_follows_with_nose_wheel_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5;
if (sz_res) *sz_res = 3;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_f_follows_with_nose_wheel_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
if (sz_res) *sz_res = 3*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_f_follows_with_nose_wheel:(a,x_cg,x_nose,out_f[1x1,0nz],adj_f,out_adj_a[1x1,0nz],out_adj_x_cg[1x1,0nz],out_adj_x_nose[1x1,0nz],fwd_a,fwd_x_cg,fwd_x_nose,fwd_out_f[1x1,0nz],fwd_adj_f)->(fwd_adj_a,fwd_adj_x_cg,fwd_adj_x_nose) */
static int casadi_f35(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5, a6, a7, a8;
a0=arg[0]? arg[0][0] : 0;
a1=0.;
a1=a0<a1;
a2=arg[4]? arg[4][0] : 0;
a3=arg[10]? arg[10][0] : 0;
a4=arg[9]? arg[9][0] : 0;
a5=a3-a4;
a6=arg[1]? arg[1][0] : 0;
a0=a0-a6;
a7=arg[2]? arg[2][0] : 0;
a0=a0+a7;
a5=a5/a0;
a7=a7-a6;
a7=a7/a0;
a6=a7/a0;
a8=arg[8]? arg[8][0] : 0;
a8=a8-a4;
a8=a8+a3;
a6=a6*a8;
a5=a5-a6;
a5=a5/a0;
a7=a7/a0;
a6=a7/a0;
a6=a6*a8;
a5=a5-a6;
a5=a2*a5;
a6=arg[12]? arg[12][0] : 0;
a7=a7*a6;
a5=a5+a7;
a7=-a5;
a7=a1?a7:0;
if (res[0]!=0) res[0][0]=a7;
a6=a6/a0;
a2=a2/a0;
a2=a2/a0;
a2=a2*a8;
a6=a6-a2;
a2=a5-a6;
a2=a1?a2:0;
if (res[1]!=0) res[1][0]=a2;
a6=a6-a5;
a1=a1?a6:0;
if (res[2]!=0) res[2][0]=a1;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_f_follows_with_nose_wheel(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f35(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_f_follows_with_nose_wheel_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_f_follows_with_nose_wheel_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_f_follows_with_nose_wheel_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_f_follows_with_nose_wheel_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_f_follows_with_nose_wheel_n_in(void) { return 13;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_f_follows_with_nose_wheel_n_out(void) { return 3;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_f_follows_with_nose_wheel_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_f_follows_with_nose_wheel_name_in(casadi_int i) {
switch (i) {
case 0: return "a";
case 1: return "x_cg";
case 2: return "x_nose";
case 3: return "out_f";
case 4: return "adj_f";
case 5: return "out_adj_a";
case 6: return "out_adj_x_cg";
case 7: return "out_adj_x_nose";
case 8: return "fwd_a";
case 9: return "fwd_x_cg";
case 10: return "fwd_x_nose";
case 11: return "fwd_out_f";
case 12: return "fwd_adj_f";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_f_follows_with_nose_wheel_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_a";
case 1: return "fwd_adj_x_cg";
case 2: return "fwd_adj_x_nose";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_f_follows_with_nose_wheel_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_f_follows_with_nose_wheel_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_f_follows_with_nose_wheel_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 13;
if (sz_res) *sz_res = 3;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_f_follows_with_nose_wheel_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 13*sizeof(const casadi_real*);
if (sz_res) *sz_res = 3*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* F_tail_load_follows_with_nose_wheel:(m,a,g,f)->(F_tail_load) */
static int casadi_f36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4;
a0=arg[1]? arg[1][0] : 0;
a1=0.;
a0=a0<a1;
a2=arg[2]? arg[2][0] : 0;
a3=arg[0]? arg[0][0] : 0;
a2=a2*a3;
a3=1.;
a4=arg[3]? arg[3][0] : 0;
a3=a3-a4;
a1=casadi_fmin(a1,a3);
a2=a2*a1;
a2=a0?a2:0;
a0=!a0;
a1=casadi_nan;
a0=a0?a1:0;
a2=a2+a0;
if (res[0]!=0) res[0][0]=a2;
return 0;
}
CASADI_SYMBOL_EXPORT int F_tail_load_follows_with_nose_wheel(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f36(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int F_tail_load_follows_with_nose_wheel_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void F_tail_load_follows_with_nose_wheel_release(int mem) {
}
CASADI_SYMBOL_EXPORT void F_tail_load_follows_with_nose_wheel_incref(void) {
}
CASADI_SYMBOL_EXPORT void F_tail_load_follows_with_nose_wheel_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int F_tail_load_follows_with_nose_wheel_n_in(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_int F_tail_load_follows_with_nose_wheel_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real F_tail_load_follows_with_nose_wheel_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* F_tail_load_follows_with_nose_wheel_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "a";
case 2: return "g";
case 3: return "f";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* F_tail_load_follows_with_nose_wheel_name_out(casadi_int i) {
switch (i) {
case 0: return "F_tail_load";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* F_tail_load_follows_with_nose_wheel_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* F_tail_load_follows_with_nose_wheel_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int F_tail_load_follows_with_nose_wheel_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 4;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int F_tail_load_follows_with_nose_wheel_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 4*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_F_tail_load_follows_with_nose_wheel:(m,a,g,f,out_F_tail_load[1x1,0nz],fwd_m,fwd_a,fwd_g,fwd_f)->(fwd_F_tail_load) */
static int casadi_f37(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5, a6, a7;
a0=arg[1]? arg[1][0] : 0;
a1=0.;
a0=a0<a1;
a2=1.;
a3=arg[3]? arg[3][0] : 0;
a2=a2-a3;
a3=casadi_fmin(a1,a2);
a4=arg[0]? arg[0][0] : 0;
a5=arg[7]? arg[7][0] : 0;
a5=a4*a5;
a6=arg[2]? arg[2][0] : 0;
a7=arg[5]? arg[5][0] : 0;
a7=a6*a7;
a5=a5+a7;
a3=a3*a5;
a6=a6*a4;
a4=a2<=a1;
a1=a1<=a2;
a1=a1+a4;
a4=a4/a1;
a1=arg[8]? arg[8][0] : 0;
a4=a4*a1;
a6=a6*a4;
a3=a3-a6;
a0=a0?a3:0;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_F_tail_load_follows_with_nose_wheel(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f37(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_F_tail_load_follows_with_nose_wheel_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_F_tail_load_follows_with_nose_wheel_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_F_tail_load_follows_with_nose_wheel_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_F_tail_load_follows_with_nose_wheel_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_F_tail_load_follows_with_nose_wheel_n_in(void) { return 9;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_F_tail_load_follows_with_nose_wheel_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_F_tail_load_follows_with_nose_wheel_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_F_tail_load_follows_with_nose_wheel_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "a";
case 2: return "g";
case 3: return "f";
case 4: return "out_F_tail_load";
case 5: return "fwd_m";
case 6: return "fwd_a";
case 7: return "fwd_g";
case 8: return "fwd_f";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_F_tail_load_follows_with_nose_wheel_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_F_tail_load";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_F_tail_load_follows_with_nose_wheel_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s1;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s0;
case 8: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_F_tail_load_follows_with_nose_wheel_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_F_tail_load_follows_with_nose_wheel_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 9;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_F_tail_load_follows_with_nose_wheel_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 9*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_F_tail_load_follows_with_nose_wheel:(m,a,g,f,out_F_tail_load[1x1,0nz],adj_F_tail_load)->(adj_m,adj_a[1x1,0nz],adj_g,adj_f) */
static int casadi_f38(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5, a6;
a0=arg[1]? arg[1][0] : 0;
a1=0.;
a0=a0<a1;
a2=arg[2]? arg[2][0] : 0;
a3=1.;
a4=arg[3]? arg[3][0] : 0;
a3=a3-a4;
a4=casadi_fmin(a1,a3);
a5=arg[5]? arg[5][0] : 0;
a4=a4*a5;
a6=a2*a4;
a6=a0?a6:0;
if (res[0]!=0) res[0][0]=a6;
a6=arg[0]? arg[0][0] : 0;
a4=a6*a4;
a4=a0?a4:0;
if (res[2]!=0) res[2][0]=a4;
a4=a3<=a1;
a1=a1<=a3;
a1=a1+a4;
a4=a4/a1;
a2=a2*a6;
a2=a2*a5;
a4=a4*a2;
a4=-a4;
a0=a0?a4:0;
if (res[3]!=0) res[3][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_F_tail_load_follows_with_nose_wheel(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f38(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_F_tail_load_follows_with_nose_wheel_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_F_tail_load_follows_with_nose_wheel_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_F_tail_load_follows_with_nose_wheel_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_F_tail_load_follows_with_nose_wheel_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_F_tail_load_follows_with_nose_wheel_n_in(void) { return 6;}
CASADI_SYMBOL_EXPORT casadi_int adj1_F_tail_load_follows_with_nose_wheel_n_out(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_real adj1_F_tail_load_follows_with_nose_wheel_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_F_tail_load_follows_with_nose_wheel_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "a";
case 2: return "g";
case 3: return "f";
case 4: return "out_F_tail_load";
case 5: return "adj_F_tail_load";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_F_tail_load_follows_with_nose_wheel_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_m";
case 1: return "adj_a";
case 2: return "adj_g";
case 3: return "adj_f";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_F_tail_load_follows_with_nose_wheel_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s1;
case 5: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_F_tail_load_follows_with_nose_wheel_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s1;
case 2: return casadi_s0;
case 3: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_F_tail_load_follows_with_nose_wheel_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 6;
if (sz_res) *sz_res = 4;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_F_tail_load_follows_with_nose_wheel_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 6*sizeof(const casadi_real*);
if (sz_res) *sz_res = 4*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_F_tail_load_follows_with_nose_wheel:(m,a,g,f,out_F_tail_load[1x1,0nz],adj_F_tail_load,out_adj_m[1x1,0nz],out_adj_a[1x1,0nz],out_adj_g[1x1,0nz],out_adj_f[1x1,0nz],fwd_m,fwd_a,fwd_g,fwd_f,fwd_out_F_tail_load[1x1,0nz],fwd_adj_F_tail_load)->(fwd_adj_m,fwd_adj_a[1x1,0nz],fwd_adj_g,fwd_adj_f) */
static int casadi_f39(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
a00=arg[1]? arg[1][0] : 0;
a01=0.;
a00=a00<a01;
a02=1.;
a03=arg[3]? arg[3][0] : 0;
a02=a02-a03;
a03=casadi_fmin(a01,a02);
a04=arg[5]? arg[5][0] : 0;
a05=a03*a04;
a06=arg[12]? arg[12][0] : 0;
a07=a05*a06;
a08=arg[2]? arg[2][0] : 0;
a09=arg[15]? arg[15][0] : 0;
a03=a03*a09;
a10=a02<=a01;
a11=a01<=a02;
a11=a11+a10;
a10=a10/a11;
a11=arg[13]? arg[13][0] : 0;
a10=a10*a11;
a10=a04*a10;
a03=a03-a10;
a10=a08*a03;
a07=a07+a10;
a07=a00?a07:0;
if (res[0]!=0) res[0][0]=a07;
a07=arg[10]? arg[10][0] : 0;
a05=a05*a07;
a10=arg[0]? arg[0][0] : 0;
a03=a10*a03;
a05=a05+a03;
a05=a00?a05:0;
if (res[2]!=0) res[2][0]=a05;
a05=a02<=a01;
a01=a01<=a02;
a01=a01+a05;
a05=a05/a01;
a06=a10*a06;
a07=a08*a07;
a06=a06+a07;
a04=a04*a06;
a08=a08*a10;
a08=a08*a09;
a04=a04+a08;
a05=a05*a04;
a05=-a05;
a00=a00?a05:0;
if (res[3]!=0) res[3][0]=a00;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_F_tail_load_follows_with_nose_wheel(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f39(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_F_tail_load_follows_with_nose_wheel_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_F_tail_load_follows_with_nose_wheel_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_F_tail_load_follows_with_nose_wheel_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_F_tail_load_follows_with_nose_wheel_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_F_tail_load_follows_with_nose_wheel_n_in(void) { return 16;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_F_tail_load_follows_with_nose_wheel_n_out(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_F_tail_load_follows_with_nose_wheel_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_F_tail_load_follows_with_nose_wheel_name_in(casadi_int i) {
switch (i) {
case 0: return "m";
case 1: return "a";
case 2: return "g";
case 3: return "f";
case 4: return "out_F_tail_load";
case 5: return "adj_F_tail_load";
case 6: return "out_adj_m";
case 7: return "out_adj_a";
case 8: return "out_adj_g";
case 9: return "out_adj_f";
case 10: return "fwd_m";
case 11: return "fwd_a";
case 12: return "fwd_g";
case 13: return "fwd_f";
case 14: return "fwd_out_F_tail_load";
case 15: return "fwd_adj_F_tail_load";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_F_tail_load_follows_with_nose_wheel_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_m";
case 1: return "fwd_adj_a";
case 2: return "fwd_adj_g";
case 3: return "fwd_adj_f";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_F_tail_load_follows_with_nose_wheel_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s1;
case 5: return casadi_s0;
case 6: return casadi_s1;
case 7: return casadi_s1;
case 8: return casadi_s1;
case 9: return casadi_s1;
case 10: return casadi_s0;
case 11: return casadi_s0;
case 12: return casadi_s0;
case 13: return casadi_s0;
case 14: return casadi_s1;
case 15: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_F_tail_load_follows_with_nose_wheel_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s1;
case 2: return casadi_s0;
case 3: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_F_tail_load_follows_with_nose_wheel_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 16;
if (sz_res) *sz_res = 4;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_F_tail_load_follows_with_nose_wheel_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
if (sz_res) *sz_res = 4*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* a_third_follows_with_nose_wheel:(a,x_cg,x_nose)->(a_third) */
static int casadi_f40(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2;
a0=arg[0]? arg[0][0] : 0;
a1=0.;
a0=a0<a1;
a1=arg[1]? arg[1][0] : 0;
a2=arg[2]? arg[2][0] : 0;
a1=a1-a2;
a1=a0?a1:0;
a0=!a0;
a2=casadi_nan;
a0=a0?a2:0;
a1=a1+a0;
if (res[0]!=0) res[0][0]=a1;
return 0;
}
CASADI_SYMBOL_EXPORT int a_third_follows_with_nose_wheel(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f40(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int a_third_follows_with_nose_wheel_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void a_third_follows_with_nose_wheel_release(int mem) {
}
CASADI_SYMBOL_EXPORT void a_third_follows_with_nose_wheel_incref(void) {
}
CASADI_SYMBOL_EXPORT void a_third_follows_with_nose_wheel_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int a_third_follows_with_nose_wheel_n_in(void) { return 3;}
CASADI_SYMBOL_EXPORT casadi_int a_third_follows_with_nose_wheel_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real a_third_follows_with_nose_wheel_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* a_third_follows_with_nose_wheel_name_in(casadi_int i) {
switch (i) {
case 0: return "a";
case 1: return "x_cg";
case 2: return "x_nose";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* a_third_follows_with_nose_wheel_name_out(casadi_int i) {
switch (i) {
case 0: return "a_third";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* a_third_follows_with_nose_wheel_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* a_third_follows_with_nose_wheel_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int a_third_follows_with_nose_wheel_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 3;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int a_third_follows_with_nose_wheel_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 3*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_a_third_follows_with_nose_wheel:(a,x_cg,x_nose,out_a_third[1x1,0nz],fwd_a,fwd_x_cg,fwd_x_nose)->(fwd_a_third) */
static int casadi_f41(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2;
a0=arg[0]? arg[0][0] : 0;
a1=0.;
a0=a0<a1;
a1=arg[5]? arg[5][0] : 0;
a2=arg[6]? arg[6][0] : 0;
a1=a1-a2;
a0=a0?a1:0;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_a_third_follows_with_nose_wheel(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f41(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_a_third_follows_with_nose_wheel_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_a_third_follows_with_nose_wheel_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_a_third_follows_with_nose_wheel_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_a_third_follows_with_nose_wheel_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_a_third_follows_with_nose_wheel_n_in(void) { return 7;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_a_third_follows_with_nose_wheel_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_a_third_follows_with_nose_wheel_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_a_third_follows_with_nose_wheel_name_in(casadi_int i) {
switch (i) {
case 0: return "a";
case 1: return "x_cg";
case 2: return "x_nose";
case 3: return "out_a_third";
case 4: return "fwd_a";
case 5: return "fwd_x_cg";
case 6: return "fwd_x_nose";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_a_third_follows_with_nose_wheel_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_a_third";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_a_third_follows_with_nose_wheel_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_a_third_follows_with_nose_wheel_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_a_third_follows_with_nose_wheel_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 7;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_a_third_follows_with_nose_wheel_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 7*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_a_third_follows_with_nose_wheel:(a,x_cg,x_nose,out_a_third[1x1,0nz],adj_a_third)->(adj_a[1x1,0nz],adj_x_cg,adj_x_nose) */
static int casadi_f42(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2;
a0=arg[0]? arg[0][0] : 0;
a1=0.;
a0=a0<a1;
a1=arg[4]? arg[4][0] : 0;
a2=a0?a1:0;
if (res[1]!=0) res[1][0]=a2;
a1=-a1;
a0=a0?a1:0;
if (res[2]!=0) res[2][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_a_third_follows_with_nose_wheel(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f42(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_a_third_follows_with_nose_wheel_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_a_third_follows_with_nose_wheel_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_a_third_follows_with_nose_wheel_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_a_third_follows_with_nose_wheel_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_a_third_follows_with_nose_wheel_n_in(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_int adj1_a_third_follows_with_nose_wheel_n_out(void) { return 3;}
CASADI_SYMBOL_EXPORT casadi_real adj1_a_third_follows_with_nose_wheel_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_a_third_follows_with_nose_wheel_name_in(casadi_int i) {
switch (i) {
case 0: return "a";
case 1: return "x_cg";
case 2: return "x_nose";
case 3: return "out_a_third";
case 4: return "adj_a_third";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_a_third_follows_with_nose_wheel_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_a";
case 1: return "adj_x_cg";
case 2: return "adj_x_nose";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_a_third_follows_with_nose_wheel_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s1;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_a_third_follows_with_nose_wheel_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s1;
case 1: return casadi_s0;
case 2: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_a_third_follows_with_nose_wheel_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5;
if (sz_res) *sz_res = 3;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_a_third_follows_with_nose_wheel_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
if (sz_res) *sz_res = 3*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_a_third_follows_with_nose_wheel:(a,x_cg,x_nose,out_a_third[1x1,0nz],adj_a_third,out_adj_a[1x1,0nz],out_adj_x_cg[1x1,0nz],out_adj_x_nose[1x1,0nz],fwd_a,fwd_x_cg,fwd_x_nose,fwd_out_a_third[1x1,0nz],fwd_adj_a_third)->(fwd_adj_a[1x1,0nz],fwd_adj_x_cg,fwd_adj_x_nose) */
static int casadi_f43(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2;
a0=arg[0]? arg[0][0] : 0;
a1=0.;
a0=a0<a1;
a1=arg[12]? arg[12][0] : 0;
a2=a0?a1:0;
if (res[1]!=0) res[1][0]=a2;
a1=-a1;
a0=a0?a1:0;
if (res[2]!=0) res[2][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_a_third_follows_with_nose_wheel(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f43(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_a_third_follows_with_nose_wheel_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_a_third_follows_with_nose_wheel_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_a_third_follows_with_nose_wheel_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_a_third_follows_with_nose_wheel_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_a_third_follows_with_nose_wheel_n_in(void) { return 13;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_a_third_follows_with_nose_wheel_n_out(void) { return 3;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_a_third_follows_with_nose_wheel_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_a_third_follows_with_nose_wheel_name_in(casadi_int i) {
switch (i) {
case 0: return "a";
case 1: return "x_cg";
case 2: return "x_nose";
case 3: return "out_a_third";
case 4: return "adj_a_third";
case 5: return "out_adj_a";
case 6: return "out_adj_x_cg";
case 7: return "out_adj_x_nose";
case 8: return "fwd_a";
case 9: return "fwd_x_cg";
case 10: return "fwd_x_nose";
case 11: return "fwd_out_a_third";
case 12: return "fwd_adj_a_third";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_a_third_follows_with_nose_wheel_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_a";
case 1: return "fwd_adj_x_cg";
case 2: return "fwd_adj_x_nose";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_a_third_follows_with_nose_wheel_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_a_third_follows_with_nose_wheel_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s1;
case 1: return casadi_s0;
case 2: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_a_third_follows_with_nose_wheel_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 13;
if (sz_res) *sz_res = 3;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_a_third_follows_with_nose_wheel_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 13*sizeof(const casadi_real*);
if (sz_res) *sz_res = 3*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* B3_third_follows_with_tail_wheel:(Ct,F_tail_load,B1_third,C1_third,D1_third)->(B3_third) */
static int casadi_f44(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4;
a0=0.;
a1=arg[0]? arg[0][0] : 0;
a2=arg[1]? arg[1][0] : 0;
a3=a1*a2;
a0=a0<a3;
a3=arg[2]? arg[2][0] : 0;
a4=arg[3]? arg[3][0] : 0;
a3=a3*a4;
a4=arg[4]? arg[4][0] : 0;
a3=a3*a4;
a3=a3*a2;
a1=a1/a3;
a1=a0?a1:0;
a0=!a0;
a3=casadi_nan;
a0=a0?a3:0;
a1=a1+a0;
if (res[0]!=0) res[0][0]=a1;
return 0;
}
CASADI_SYMBOL_EXPORT int B3_third_follows_with_tail_wheel(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f44(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int B3_third_follows_with_tail_wheel_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void B3_third_follows_with_tail_wheel_release(int mem) {
}
CASADI_SYMBOL_EXPORT void B3_third_follows_with_tail_wheel_incref(void) {
}
CASADI_SYMBOL_EXPORT void B3_third_follows_with_tail_wheel_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int B3_third_follows_with_tail_wheel_n_in(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_int B3_third_follows_with_tail_wheel_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real B3_third_follows_with_tail_wheel_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* B3_third_follows_with_tail_wheel_name_in(casadi_int i) {
switch (i) {
case 0: return "Ct";
case 1: return "F_tail_load";
case 2: return "B1_third";
case 3: return "C1_third";
case 4: return "D1_third";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* B3_third_follows_with_tail_wheel_name_out(casadi_int i) {
switch (i) {
case 0: return "B3_third";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* B3_third_follows_with_tail_wheel_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* B3_third_follows_with_tail_wheel_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int B3_third_follows_with_tail_wheel_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int B3_third_follows_with_tail_wheel_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_B3_third_follows_with_tail_wheel:(Ct,F_tail_load,B1_third,C1_third,D1_third,out_B3_third[1x1,0nz],fwd_Ct,fwd_F_tail_load,fwd_B1_third,fwd_C1_third,fwd_D1_third)->(fwd_B3_third) */
static int casadi_f45(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5, a6, a7, a8, a9;
a0=0.;
a1=arg[0]? arg[0][0] : 0;
a2=arg[1]? arg[1][0] : 0;
a3=a1*a2;
a0=a0<a3;
a3=arg[6]? arg[6][0] : 0;
a4=arg[2]? arg[2][0] : 0;
a5=arg[3]? arg[3][0] : 0;
a6=a4*a5;
a7=arg[4]? arg[4][0] : 0;
a8=a6*a7;
a9=a8*a2;
a3=a3/a9;
a1=a1/a9;
a1=a1/a9;
a9=arg[8]? arg[8][0] : 0;
a5=a5*a9;
a9=arg[9]? arg[9][0] : 0;
a4=a4*a9;
a5=a5+a4;
a7=a7*a5;
a5=arg[10]? arg[10][0] : 0;
a6=a6*a5;
a7=a7+a6;
a2=a2*a7;
a7=arg[7]? arg[7][0] : 0;
a8=a8*a7;
a2=a2+a8;
a1=a1*a2;
a3=a3-a1;
a0=a0?a3:0;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_B3_third_follows_with_tail_wheel(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f45(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_B3_third_follows_with_tail_wheel_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_B3_third_follows_with_tail_wheel_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_B3_third_follows_with_tail_wheel_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_B3_third_follows_with_tail_wheel_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_B3_third_follows_with_tail_wheel_n_in(void) { return 11;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_B3_third_follows_with_tail_wheel_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_B3_third_follows_with_tail_wheel_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_B3_third_follows_with_tail_wheel_name_in(casadi_int i) {
switch (i) {
case 0: return "Ct";
case 1: return "F_tail_load";
case 2: return "B1_third";
case 3: return "C1_third";
case 4: return "D1_third";
case 5: return "out_B3_third";
case 6: return "fwd_Ct";
case 7: return "fwd_F_tail_load";
case 8: return "fwd_B1_third";
case 9: return "fwd_C1_third";
case 10: return "fwd_D1_third";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_B3_third_follows_with_tail_wheel_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_B3_third";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_B3_third_follows_with_tail_wheel_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_B3_third_follows_with_tail_wheel_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_B3_third_follows_with_tail_wheel_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 11;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_B3_third_follows_with_tail_wheel_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 11*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_B3_third_follows_with_tail_wheel:(Ct,F_tail_load,B1_third,C1_third,D1_third,out_B3_third[1x1,0nz],adj_B3_third)->(adj_Ct,adj_F_tail_load,adj_B1_third,adj_C1_third,adj_D1_third) */
static int casadi_f46(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10;
a00=0.;
a01=arg[0]? arg[0][0] : 0;
a02=arg[1]? arg[1][0] : 0;
a03=a01*a02;
a00=a00<a03;
a03=arg[6]? arg[6][0] : 0;
a04=arg[2]? arg[2][0] : 0;
a05=arg[3]? arg[3][0] : 0;
a06=a04*a05;
a07=arg[4]? arg[4][0] : 0;
a08=a06*a07;
a09=a08*a02;
a10=a03/a09;
a10=a00?a10:0;
if (res[0]!=0) res[0][0]=a10;
a01=a01/a09;
a01=a01/a09;
a01=a01*a03;
a08=a08*a01;
a08=-a08;
a08=a00?a08:0;
if (res[1]!=0) res[1][0]=a08;
a02=a02*a01;
a07=a07*a02;
a05=a05*a07;
a05=-a05;
a05=a00?a05:0;
if (res[2]!=0) res[2][0]=a05;
a04=a04*a07;
a04=-a04;
a04=a00?a04:0;
if (res[3]!=0) res[3][0]=a04;
a06=a06*a02;
a06=-a06;
a00=a00?a06:0;
if (res[4]!=0) res[4][0]=a00;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_B3_third_follows_with_tail_wheel(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f46(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_B3_third_follows_with_tail_wheel_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_B3_third_follows_with_tail_wheel_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_B3_third_follows_with_tail_wheel_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_B3_third_follows_with_tail_wheel_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_B3_third_follows_with_tail_wheel_n_in(void) { return 7;}
CASADI_SYMBOL_EXPORT casadi_int adj1_B3_third_follows_with_tail_wheel_n_out(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_real adj1_B3_third_follows_with_tail_wheel_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_B3_third_follows_with_tail_wheel_name_in(casadi_int i) {
switch (i) {
case 0: return "Ct";
case 1: return "F_tail_load";
case 2: return "B1_third";
case 3: return "C1_third";
case 4: return "D1_third";
case 5: return "out_B3_third";
case 6: return "adj_B3_third";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_B3_third_follows_with_tail_wheel_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_Ct";
case 1: return "adj_F_tail_load";
case 2: return "adj_B1_third";
case 3: return "adj_C1_third";
case 4: return "adj_D1_third";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_B3_third_follows_with_tail_wheel_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* adj1_B3_third_follows_with_tail_wheel_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_B3_third_follows_with_tail_wheel_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 7;
if (sz_res) *sz_res = 5;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_B3_third_follows_with_tail_wheel_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 7*sizeof(const casadi_real*);
if (sz_res) *sz_res = 5*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_B3_third_follows_with_tail_wheel:(Ct,F_tail_load,B1_third,C1_third,D1_third,out_B3_third[1x1,0nz],adj_B3_third,out_adj_Ct[1x1,0nz],out_adj_F_tail_load[1x1,0nz],out_adj_B1_third[1x1,0nz],out_adj_C1_third[1x1,0nz],out_adj_D1_third[1x1,0nz],fwd_Ct,fwd_F_tail_load,fwd_B1_third,fwd_C1_third,fwd_D1_third,fwd_out_B3_third[1x1,0nz],fwd_adj_B3_third)->(fwd_adj_Ct,fwd_adj_F_tail_load,fwd_adj_B1_third,fwd_adj_C1_third,fwd_adj_D1_third) */
static int casadi_f47(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20;
a00=0.;
a01=arg[0]? arg[0][0] : 0;
a02=arg[1]? arg[1][0] : 0;
a03=a01*a02;
a00=a00<a03;
a03=arg[18]? arg[18][0] : 0;
a04=arg[2]? arg[2][0] : 0;
a05=arg[3]? arg[3][0] : 0;
a06=a04*a05;
a07=arg[4]? arg[4][0] : 0;
a08=a06*a07;
a09=a08*a02;
a10=a03/a09;
a11=arg[6]? arg[6][0] : 0;
a12=a11/a09;
a12=a12/a09;
a13=arg[14]? arg[14][0] : 0;
a14=a05*a13;
a15=arg[15]? arg[15][0] : 0;
a16=a04*a15;
a14=a14+a16;
a16=a07*a14;
a17=arg[16]? arg[16][0] : 0;
a18=a06*a17;
a16=a16+a18;
a18=a02*a16;
a19=arg[13]? arg[13][0] : 0;
a20=a08*a19;
a18=a18+a20;
a12=a12*a18;
a10=a10-a12;
a10=a00?a10:0;
if (res[0]!=0) res[0][0]=a10;
a01=a01/a09;
a10=a01/a09;
a12=a10*a11;
a16=a12*a16;
a20=arg[12]? arg[12][0] : 0;
a20=a20/a09;
a01=a01/a09;
a01=a01*a18;
a20=a20-a01;
a20=a20/a09;
a09=a10/a09;
a09=a09*a18;
a20=a20-a09;
a11=a11*a20;
a10=a10*a03;
a11=a11+a10;
a08=a08*a11;
a16=a16+a08;
a16=-a16;
a16=a00?a16:0;
if (res[1]!=0) res[1][0]=a16;
a16=a02*a12;
a08=a07*a16;
a15=a08*a15;
a17=a16*a17;
a12=a12*a19;
a02=a02*a11;
a12=a12+a02;
a07=a07*a12;
a17=a17+a07;
a05=a05*a17;
a15=a15+a05;
a15=-a15;
a15=a00?a15:0;
if (res[2]!=0) res[2][0]=a15;
a08=a08*a13;
a04=a04*a17;
a08=a08+a04;
a08=-a08;
a08=a00?a08:0;
if (res[3]!=0) res[3][0]=a08;
a16=a16*a14;
a06=a06*a12;
a16=a16+a06;
a16=-a16;
a00=a00?a16:0;
if (res[4]!=0) res[4][0]=a00;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_B3_third_follows_with_tail_wheel(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f47(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_B3_third_follows_with_tail_wheel_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_B3_third_follows_with_tail_wheel_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_B3_third_follows_with_tail_wheel_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_B3_third_follows_with_tail_wheel_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_B3_third_follows_with_tail_wheel_n_in(void) { return 19;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_B3_third_follows_with_tail_wheel_n_out(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_B3_third_follows_with_tail_wheel_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_B3_third_follows_with_tail_wheel_name_in(casadi_int i) {
switch (i) {
case 0: return "Ct";
case 1: return "F_tail_load";
case 2: return "B1_third";
case 3: return "C1_third";
case 4: return "D1_third";
case 5: return "out_B3_third";
case 6: return "adj_B3_third";
case 7: return "out_adj_Ct";
case 8: return "out_adj_F_tail_load";
case 9: return "out_adj_B1_third";
case 10: return "out_adj_C1_third";
case 11: return "out_adj_D1_third";
case 12: return "fwd_Ct";
case 13: return "fwd_F_tail_load";
case 14: return "fwd_B1_third";
case 15: return "fwd_C1_third";
case 16: return "fwd_D1_third";
case 17: return "fwd_out_B3_third";
case 18: return "fwd_adj_B3_third";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_B3_third_follows_with_tail_wheel_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_Ct";
case 1: return "fwd_adj_F_tail_load";
case 2: return "fwd_adj_B1_third";
case 3: return "fwd_adj_C1_third";
case 4: return "fwd_adj_D1_third";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_B3_third_follows_with_tail_wheel_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_B3_third_follows_with_tail_wheel_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_B3_third_follows_with_tail_wheel_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 19;
if (sz_res) *sz_res = 5;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_B3_third_follows_with_tail_wheel_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 19*sizeof(const casadi_real*);
if (sz_res) *sz_res = 5*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* C3_third_follows_with_tail_wheel:(Ct,F_tail_load)->(C3_third) */
static int casadi_f48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2;
a0=0.;
a1=arg[0]? arg[0][0] : 0;
a2=arg[1]? arg[1][0] : 0;
a1=a1*a2;
a0=a0<a1;
a0=!a0;
a1=casadi_nan;
a0=a0?a1:0;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int C3_third_follows_with_tail_wheel(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f48(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int C3_third_follows_with_tail_wheel_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void C3_third_follows_with_tail_wheel_release(int mem) {
}
CASADI_SYMBOL_EXPORT void C3_third_follows_with_tail_wheel_incref(void) {
}
CASADI_SYMBOL_EXPORT void C3_third_follows_with_tail_wheel_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int C3_third_follows_with_tail_wheel_n_in(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_int C3_third_follows_with_tail_wheel_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real C3_third_follows_with_tail_wheel_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* C3_third_follows_with_tail_wheel_name_in(casadi_int i) {
switch (i) {
case 0: return "Ct";
case 1: return "F_tail_load";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* C3_third_follows_with_tail_wheel_name_out(casadi_int i) {
switch (i) {
case 0: return "C3_third";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* C3_third_follows_with_tail_wheel_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* C3_third_follows_with_tail_wheel_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int C3_third_follows_with_tail_wheel_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 2;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int C3_third_follows_with_tail_wheel_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 2*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_C3_third_follows_with_tail_wheel:(Ct,F_tail_load,out_C3_third[1x1,0nz],fwd_Ct,fwd_F_tail_load)->(fwd_C3_third) */
static int casadi_f49(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0;
a0=0.;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_C3_third_follows_with_tail_wheel(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f49(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_C3_third_follows_with_tail_wheel_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_C3_third_follows_with_tail_wheel_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_C3_third_follows_with_tail_wheel_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_C3_third_follows_with_tail_wheel_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_C3_third_follows_with_tail_wheel_n_in(void) { return 5;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_C3_third_follows_with_tail_wheel_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_C3_third_follows_with_tail_wheel_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_C3_third_follows_with_tail_wheel_name_in(casadi_int i) {
switch (i) {
case 0: return "Ct";
case 1: return "F_tail_load";
case 2: return "out_C3_third";
case 3: return "fwd_Ct";
case 4: return "fwd_F_tail_load";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_C3_third_follows_with_tail_wheel_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_C3_third";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_C3_third_follows_with_tail_wheel_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s1;
case 3: return casadi_s0;
case 4: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_C3_third_follows_with_tail_wheel_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_C3_third_follows_with_tail_wheel_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_C3_third_follows_with_tail_wheel_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_C3_third_follows_with_tail_wheel:(Ct,F_tail_load,out_C3_third[1x1,0nz],adj_C3_third)->(adj_Ct[1x1,0nz],adj_F_tail_load[1x1,0nz]) */
static int casadi_f50(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_C3_third_follows_with_tail_wheel(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f50(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_C3_third_follows_with_tail_wheel_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_C3_third_follows_with_tail_wheel_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_C3_third_follows_with_tail_wheel_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_C3_third_follows_with_tail_wheel_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_C3_third_follows_with_tail_wheel_n_in(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_int adj1_C3_third_follows_with_tail_wheel_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real adj1_C3_third_follows_with_tail_wheel_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_C3_third_follows_with_tail_wheel_name_in(casadi_int i) {
switch (i) {
case 0: return "Ct";
case 1: return "F_tail_load";
case 2: return "out_C3_third";
case 3: return "adj_C3_third";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_C3_third_follows_with_tail_wheel_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_Ct";
case 1: return "adj_F_tail_load";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_C3_third_follows_with_tail_wheel_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s1;
case 3: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_C3_third_follows_with_tail_wheel_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s1;
case 1: return casadi_s1;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_C3_third_follows_with_tail_wheel_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 4;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_C3_third_follows_with_tail_wheel_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 4*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_C3_third_follows_with_tail_wheel:(Ct,F_tail_load,out_C3_third[1x1,0nz],adj_C3_third,out_adj_Ct[1x1,0nz],out_adj_F_tail_load[1x1,0nz],fwd_Ct,fwd_F_tail_load,fwd_out_C3_third[1x1,0nz],fwd_adj_C3_third)->(fwd_adj_Ct[1x1,0nz],fwd_adj_F_tail_load[1x1,0nz]) */
static int casadi_f51(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_C3_third_follows_with_tail_wheel(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f51(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_C3_third_follows_with_tail_wheel_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_C3_third_follows_with_tail_wheel_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_C3_third_follows_with_tail_wheel_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_C3_third_follows_with_tail_wheel_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_C3_third_follows_with_tail_wheel_n_in(void) { return 10;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_C3_third_follows_with_tail_wheel_n_out(void) { return 2;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_C3_third_follows_with_tail_wheel_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_C3_third_follows_with_tail_wheel_name_in(casadi_int i) {
switch (i) {
case 0: return "Ct";
case 1: return "F_tail_load";
case 2: return "out_C3_third";
case 3: return "adj_C3_third";
case 4: return "out_adj_Ct";
case 5: return "out_adj_F_tail_load";
case 6: return "fwd_Ct";
case 7: return "fwd_F_tail_load";
case 8: return "fwd_out_C3_third";
case 9: return "fwd_adj_C3_third";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_C3_third_follows_with_tail_wheel_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_Ct";
case 1: return "fwd_adj_F_tail_load";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_C3_third_follows_with_tail_wheel_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_C3_third_follows_with_tail_wheel_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s1;
case 1: return casadi_s1;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_C3_third_follows_with_tail_wheel_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 10;
if (sz_res) *sz_res = 2;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_C3_third_follows_with_tail_wheel_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
if (sz_res) *sz_res = 2*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* p_rated_follows:(p_tire)->(p_rated) */
static int casadi_f52(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0;
a0=arg[0]? arg[0][0] : 0;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int p_rated_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f52(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int p_rated_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void p_rated_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void p_rated_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void p_rated_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int p_rated_follows_n_in(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_int p_rated_follows_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real p_rated_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* p_rated_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "p_tire";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* p_rated_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "p_rated";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* p_rated_follows_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* p_rated_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int p_rated_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 1;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int p_rated_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 1*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_p_rated_follows:(p_tire,out_p_rated[1x1,0nz],fwd_p_tire)->(fwd_p_rated) */
static int casadi_f53(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0;
a0=arg[2]? arg[2][0] : 0;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_p_rated_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f53(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_p_rated_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_p_rated_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_p_rated_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_p_rated_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_p_rated_follows_n_in(void) { return 3;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_p_rated_follows_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_p_rated_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_p_rated_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "p_tire";
case 1: return "out_p_rated";
case 2: return "fwd_p_tire";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_p_rated_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_p_rated";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_p_rated_follows_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s1;
case 2: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_p_rated_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_p_rated_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 3;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_p_rated_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 3*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_p_rated_follows:(p_tire,out_p_rated[1x1,0nz],adj_p_rated)->(adj_p_tire) */
static int casadi_f54(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0;
a0=arg[2]? arg[2][0] : 0;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_p_rated_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f54(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_p_rated_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_p_rated_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_p_rated_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_p_rated_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_p_rated_follows_n_in(void) { return 3;}
CASADI_SYMBOL_EXPORT casadi_int adj1_p_rated_follows_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real adj1_p_rated_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_p_rated_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "p_tire";
case 1: return "out_p_rated";
case 2: return "adj_p_rated";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_p_rated_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_p_tire";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_p_rated_follows_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s1;
case 2: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_p_rated_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_p_rated_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 3;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_p_rated_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 3*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_p_rated_follows:(p_tire,out_p_rated[1x1,0nz],adj_p_rated,out_adj_p_tire[1x1,0nz],fwd_p_tire,fwd_out_p_rated[1x1,0nz],fwd_adj_p_rated)->(fwd_adj_p_tire) */
static int casadi_f55(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0;
a0=arg[6]? arg[6][0] : 0;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_p_rated_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f55(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_p_rated_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_p_rated_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_p_rated_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_p_rated_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_p_rated_follows_n_in(void) { return 7;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_p_rated_follows_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_p_rated_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_p_rated_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "p_tire";
case 1: return "out_p_rated";
case 2: return "adj_p_rated";
case 3: return "out_adj_p_tire";
case 4: return "fwd_p_tire";
case 5: return "fwd_out_p_rated";
case 6: return "fwd_adj_p_rated";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_p_rated_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_p_tire";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_p_rated_follows_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s1;
case 2: return casadi_s0;
case 3: return casadi_s1;
case 4: return casadi_s0;
case 5: return casadi_s1;
case 6: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_p_rated_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_p_rated_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 7;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_p_rated_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 7*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* delta_tire_follows:(Fz,d_tire,w_tire,p_tire,p_rated,C_z)->(delta_tire) */
static int casadi_f56(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5, a6;
a0=arg[2]? arg[2][0] : 0;
a1=arg[0]? arg[0][0] : 0;
a2=arg[1]? arg[1][0] : 0;
a2=sqrt(a2);
a3=sqrt(a0);
a2=a2*a3;
a2=a2*a0;
a3=8.0000000000000002e-02;
a4=arg[4]? arg[4][0] : 0;
a3=a3*a4;
a4=arg[3]? arg[3][0] : 0;
a3=a3+a4;
a2=a2*a3;
a1=a1/a2;
a2=5.5999999999999996e+00;
a3=arg[5]? arg[5][0] : 0;
a2=a2*a3;
a2=a1<=a2;
a4=2.3148148148148149e+00;
a5=9.2159999999999997e-01;
a6=8.6399999999999999e-01;
a6=a6*a1;
a6=a6/a3;
a5=a5+a6;
a5=sqrt(a5);
a4=a4*a5;
a5=2.2222222222222223e+00;
a4=a4-a5;
a4=a3*a4;
a4=a2?a4:0;
a2=!a2;
a5=4.1666666666666669e-01;
a5=a5*a1;
a3=a3+a5;
a2=a2?a3:0;
a4=a4+a2;
a0=a0*a4;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int delta_tire_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f56(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int delta_tire_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void delta_tire_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void delta_tire_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void delta_tire_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int delta_tire_follows_n_in(void) { return 6;}
CASADI_SYMBOL_EXPORT casadi_int delta_tire_follows_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real delta_tire_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* delta_tire_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz";
case 1: return "d_tire";
case 2: return "w_tire";
case 3: return "p_tire";
case 4: return "p_rated";
case 5: return "C_z";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* delta_tire_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "delta_tire";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* delta_tire_follows_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* delta_tire_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int delta_tire_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 6;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int delta_tire_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 6*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_delta_tire_follows:(Fz,d_tire,w_tire,p_tire,p_rated,C_z,out_delta_tire[1x1,0nz],fwd_Fz,fwd_d_tire,fwd_w_tire,fwd_p_tire,fwd_p_rated,fwd_C_z)->(fwd_delta_tire) */
static int casadi_f57(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22;
a00=arg[0]? arg[0][0] : 0;
a01=arg[1]? arg[1][0] : 0;
a01=sqrt(a01);
a02=arg[2]? arg[2][0] : 0;
a03=sqrt(a02);
a04=a01*a03;
a05=a04*a02;
a06=8.0000000000000002e-02;
a07=arg[4]? arg[4][0] : 0;
a07=a06*a07;
a08=arg[3]? arg[3][0] : 0;
a07=a07+a08;
a08=a05*a07;
a00=a00/a08;
a09=5.5999999999999996e+00;
a10=arg[5]? arg[5][0] : 0;
a09=a09*a10;
a09=a00<=a09;
a11=2.3148148148148149e+00;
a12=9.2159999999999997e-01;
a13=8.6399999999999999e-01;
a14=a13*a00;
a14=a14/a10;
a12=a12+a14;
a12=sqrt(a12);
a15=a11*a12;
a16=2.2222222222222223e+00;
a15=a15-a16;
a16=a10*a15;
a16=a09?a16:0;
a17=!a09;
a18=4.1666666666666669e-01;
a19=a18*a00;
a19=a10+a19;
a19=a17?a19:0;
a16=a16+a19;
a19=arg[9]? arg[9][0] : 0;
a16=a16*a19;
a20=arg[12]? arg[12][0] : 0;
a15=a15*a20;
a21=arg[7]? arg[7][0] : 0;
a21=a21/a08;
a00=a00/a08;
a08=arg[8]? arg[8][0] : 0;
a22=2.*a01;
a08=a08/a22;
a08=a03*a08;
a03=2.*a03;
a03=a19/a03;
a01=a01*a03;
a08=a08+a01;
a08=a02*a08;
a04=a04*a19;
a08=a08+a04;
a07=a07*a08;
a08=arg[11]? arg[11][0] : 0;
a06=a06*a08;
a08=arg[10]? arg[10][0] : 0;
a06=a06+a08;
a05=a05*a06;
a07=a07+a05;
a00=a00*a07;
a21=a21-a00;
a13=a13*a21;
a13=a13/a10;
a14=a14/a10;
a14=a14*a20;
a13=a13-a14;
a12=2.*a12;
a13=a13/a12;
a11=a11*a13;
a10=a10*a11;
a15=a15+a10;
a09=a09?a15:0;
a18=a18*a21;
a20=a20+a18;
a17=a17?a20:0;
a09=a09+a17;
a02=a02*a09;
a16=a16+a02;
if (res[0]!=0) res[0][0]=a16;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_delta_tire_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f57(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_delta_tire_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_delta_tire_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_delta_tire_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_delta_tire_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_delta_tire_follows_n_in(void) { return 13;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_delta_tire_follows_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_delta_tire_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_delta_tire_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz";
case 1: return "d_tire";
case 2: return "w_tire";
case 3: return "p_tire";
case 4: return "p_rated";
case 5: return "C_z";
case 6: return "out_delta_tire";
case 7: return "fwd_Fz";
case 8: return "fwd_d_tire";
case 9: return "fwd_w_tire";
case 10: return "fwd_p_tire";
case 11: return "fwd_p_rated";
case 12: return "fwd_C_z";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_delta_tire_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_delta_tire";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_delta_tire_follows_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_delta_tire_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_delta_tire_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 13;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_delta_tire_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 13*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_delta_tire_follows:(Fz,d_tire,w_tire,p_tire,p_rated,C_z,out_delta_tire[1x1,0nz],adj_delta_tire)->(adj_Fz,adj_d_tire,adj_w_tire,adj_p_tire,adj_p_rated,adj_C_z) */
static int casadi_f58(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21;
a00=arg[0]? arg[0][0] : 0;
a01=arg[1]? arg[1][0] : 0;
a01=sqrt(a01);
a02=arg[2]? arg[2][0] : 0;
a03=sqrt(a02);
a04=a01*a03;
a05=a04*a02;
a06=8.0000000000000002e-02;
a07=arg[4]? arg[4][0] : 0;
a07=a06*a07;
a08=arg[3]? arg[3][0] : 0;
a07=a07+a08;
a08=a05*a07;
a00=a00/a08;
a09=5.5999999999999996e+00;
a10=arg[5]? arg[5][0] : 0;
a09=a09*a10;
a09=a00<=a09;
a11=!a09;
a12=4.1666666666666669e-01;
a13=arg[7]? arg[7][0] : 0;
a14=a02*a13;
a15=a12*a14;
a15=a11?a15:0;
a16=8.6399999999999999e-01;
a17=2.3148148148148149e+00;
a18=a10*a14;
a18=a17*a18;
a19=9.2159999999999997e-01;
a20=a16*a00;
a20=a20/a10;
a19=a19+a20;
a19=sqrt(a19);
a21=2.*a19;
a18=a18/a21;
a21=a18/a10;
a16=a16*a21;
a16=a09?a16:0;
a15=a15+a16;
a16=a15/a08;
if (res[0]!=0) res[0][0]=a16;
a08=a00/a08;
a08=a08*a15;
a07=a07*a08;
a02=a02*a07;
a15=a03*a02;
a16=2.*a01;
a15=a15/a16;
a15=-a15;
if (res[1]!=0) res[1][0]=a15;
a17=a17*a19;
a19=2.2222222222222223e+00;
a17=a17-a19;
a19=a10*a17;
a19=a09?a19:0;
a12=a12*a00;
a12=a10+a12;
a12=a11?a12:0;
a19=a19+a12;
a19=a19*a13;
a04=a04*a07;
a19=a19-a04;
a01=a01*a02;
a03=2.*a03;
a01=a01/a03;
a19=a19-a01;
if (res[2]!=0) res[2][0]=a19;
a05=a05*a08;
a08=-a05;
if (res[3]!=0) res[3][0]=a08;
a06=a06*a05;
a06=-a06;
if (res[4]!=0) res[4][0]=a06;
a11=a11?a14:0;
a17=a17*a14;
a17=a09?a17:0;
a11=a11+a17;
a20=a20/a10;
a20=a20*a18;
a20=-a20;
a09=a09?a20:0;
a11=a11+a09;
if (res[5]!=0) res[5][0]=a11;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_delta_tire_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f58(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_delta_tire_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_delta_tire_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_delta_tire_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_delta_tire_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_delta_tire_follows_n_in(void) { return 8;}
CASADI_SYMBOL_EXPORT casadi_int adj1_delta_tire_follows_n_out(void) { return 6;}
CASADI_SYMBOL_EXPORT casadi_real adj1_delta_tire_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_delta_tire_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz";
case 1: return "d_tire";
case 2: return "w_tire";
case 3: return "p_tire";
case 4: return "p_rated";
case 5: return "C_z";
case 6: return "out_delta_tire";
case 7: return "adj_delta_tire";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_delta_tire_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_Fz";
case 1: return "adj_d_tire";
case 2: return "adj_w_tire";
case 3: return "adj_p_tire";
case 4: return "adj_p_rated";
case 5: return "adj_C_z";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_delta_tire_follows_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* adj1_delta_tire_follows_sparsity_out(casadi_int i) {
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
CASADI_SYMBOL_EXPORT int adj1_delta_tire_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 8;
if (sz_res) *sz_res = 6;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_delta_tire_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 8*sizeof(const casadi_real*);
if (sz_res) *sz_res = 6*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_delta_tire_follows:(Fz,d_tire,w_tire,p_tire,p_rated,C_z,out_delta_tire[1x1,0nz],adj_delta_tire,out_adj_Fz[1x1,0nz],out_adj_d_tire[1x1,0nz],out_adj_w_tire[1x1,0nz],out_adj_p_tire[1x1,0nz],out_adj_p_rated[1x1,0nz],out_adj_C_z[1x1,0nz],fwd_Fz,fwd_d_tire,fwd_w_tire,fwd_p_tire,fwd_p_rated,fwd_C_z,fwd_out_delta_tire[1x1,0nz],fwd_adj_delta_tire)->(fwd_adj_Fz,fwd_adj_d_tire,fwd_adj_w_tire,fwd_adj_p_tire,fwd_adj_p_rated,fwd_adj_C_z) */
static int casadi_f59(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40;
a00=arg[0]? arg[0][0] : 0;
a01=arg[1]? arg[1][0] : 0;
a01=sqrt(a01);
a02=arg[2]? arg[2][0] : 0;
a03=sqrt(a02);
a04=a01*a03;
a05=a04*a02;
a06=8.0000000000000002e-02;
a07=arg[4]? arg[4][0] : 0;
a07=a06*a07;
a08=arg[3]? arg[3][0] : 0;
a07=a07+a08;
a08=a05*a07;
a00=a00/a08;
a09=5.5999999999999996e+00;
a10=arg[5]? arg[5][0] : 0;
a09=a09*a10;
a09=a00<=a09;
a11=!a09;
a12=4.1666666666666669e-01;
a13=arg[7]? arg[7][0] : 0;
a14=arg[16]? arg[16][0] : 0;
a15=a13*a14;
a16=arg[21]? arg[21][0] : 0;
a17=a02*a16;
a15=a15+a17;
a17=a12*a15;
a17=a11?a17:0;
a18=8.6399999999999999e-01;
a19=2.3148148148148149e+00;
a20=a02*a13;
a21=arg[19]? arg[19][0] : 0;
a22=a20*a21;
a23=a10*a15;
a22=a22+a23;
a22=a19*a22;
a23=9.2159999999999997e-01;
a24=a18*a00;
a24=a24/a10;
a23=a23+a24;
a23=sqrt(a23);
a25=2.*a23;
a22=a22/a25;
a26=a10*a20;
a26=a19*a26;
a26=a26/a25;
a25=a26/a25;
a27=arg[14]? arg[14][0] : 0;
a27=a27/a08;
a28=a00/a08;
a29=arg[15]? arg[15][0] : 0;
a30=2.*a01;
a29=a29/a30;
a30=a03*a29;
a31=2.*a03;
a31=a14/a31;
a32=a01*a31;
a30=a30+a32;
a32=a02*a30;
a33=a04*a14;
a32=a32+a33;
a33=a07*a32;
a34=arg[18]? arg[18][0] : 0;
a34=a06*a34;
a35=arg[17]? arg[17][0] : 0;
a34=a34+a35;
a35=a05*a34;
a33=a33+a35;
a28=a28*a33;
a27=a27-a28;
a28=a18*a27;
a28=a28/a10;
a35=a24/a10;
a35=a35*a21;
a28=a28-a35;
a35=2.*a23;
a35=a28/a35;
a36=2.*a35;
a25=a25*a36;
a22=a22-a25;
a25=a22/a10;
a36=a26/a10;
a37=a36/a10;
a37=a37*a21;
a25=a25-a37;
a25=a18*a25;
a25=a09?a25:0;
a17=a17+a25;
a25=a17/a08;
a37=a12*a20;
a37=a11?a37:0;
a18=a18*a36;
a18=a09?a18:0;
a37=a37+a18;
a18=a37/a08;
a18=a18/a08;
a18=a18*a33;
a25=a25-a18;
if (res[0]!=0) res[0][0]=a25;
a25=a00/a08;
a18=a25*a37;
a36=a07*a18;
a38=a02*a36;
a39=a38*a31;
a14=a36*a14;
a34=a18*a34;
a40=a27/a08;
a08=a25/a08;
a08=a08*a33;
a40=a40-a08;
a37=a37*a40;
a25=a25*a17;
a37=a37+a25;
a07=a07*a37;
a34=a34+a07;
a02=a02*a34;
a14=a14+a02;
a02=a03*a14;
a39=a39+a02;
a02=2.*a01;
a39=a39/a02;
a07=a03*a38;
a07=a07/a02;
a07=a07/a02;
a02=2.*a29;
a07=a07*a02;
a39=a39-a07;
a39=-a39;
if (res[1]!=0) res[1][0]=a39;
a23=a19*a23;
a39=2.2222222222222223e+00;
a23=a23-a39;
a39=a23*a21;
a19=a19*a35;
a35=a10*a19;
a39=a39+a35;
a39=a09?a39:0;
a27=a12*a27;
a27=a21+a27;
a27=a11?a27:0;
a39=a39+a27;
a13=a13*a39;
a39=a10*a23;
a39=a09?a39:0;
a12=a12*a00;
a12=a10+a12;
a12=a11?a12:0;
a39=a39+a12;
a39=a39*a16;
a13=a13+a39;
a36=a36*a30;
a04=a04*a34;
a36=a36+a04;
a13=a13-a36;
a29=a38*a29;
a14=a01*a14;
a29=a29+a14;
a03=2.*a03;
a29=a29/a03;
a01=a01*a38;
a01=a01/a03;
a01=a01/a03;
a31=2.*a31;
a01=a01*a31;
a29=a29-a01;
a13=a13-a29;
if (res[2]!=0) res[2][0]=a13;
a18=a18*a32;
a05=a05*a37;
a18=a18+a05;
a05=-a18;
if (res[3]!=0) res[3][0]=a05;
a06=a06*a18;
a06=-a06;
if (res[4]!=0) res[4][0]=a06;
a11=a11?a15:0;
a20=a20*a19;
a23=a23*a15;
a20=a20+a23;
a20=a09?a20:0;
a11=a11+a20;
a28=a28/a10;
a24=a24/a10;
a10=a24/a10;
a10=a10*a21;
a28=a28-a10;
a26=a26*a28;
a24=a24*a22;
a26=a26+a24;
a26=-a26;
a09=a09?a26:0;
a11=a11+a09;
if (res[5]!=0) res[5][0]=a11;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_delta_tire_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f59(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_delta_tire_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_delta_tire_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_delta_tire_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_delta_tire_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_delta_tire_follows_n_in(void) { return 22;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_delta_tire_follows_n_out(void) { return 6;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_delta_tire_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_delta_tire_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz";
case 1: return "d_tire";
case 2: return "w_tire";
case 3: return "p_tire";
case 4: return "p_rated";
case 5: return "C_z";
case 6: return "out_delta_tire";
case 7: return "adj_delta_tire";
case 8: return "out_adj_Fz";
case 9: return "out_adj_d_tire";
case 10: return "out_adj_w_tire";
case 11: return "out_adj_p_tire";
case 12: return "out_adj_p_rated";
case 13: return "out_adj_C_z";
case 14: return "fwd_Fz";
case 15: return "fwd_d_tire";
case 16: return "fwd_w_tire";
case 17: return "fwd_p_tire";
case 18: return "fwd_p_rated";
case 19: return "fwd_C_z";
case 20: return "fwd_out_delta_tire";
case 21: return "fwd_adj_delta_tire";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_delta_tire_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_Fz";
case 1: return "fwd_adj_d_tire";
case 2: return "fwd_adj_w_tire";
case 3: return "fwd_adj_p_tire";
case 4: return "fwd_adj_p_rated";
case 5: return "fwd_adj_C_z";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_delta_tire_follows_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_delta_tire_follows_sparsity_out(casadi_int i) {
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
CASADI_SYMBOL_EXPORT int fwd1_adj1_delta_tire_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 22;
if (sz_res) *sz_res = 6;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_delta_tire_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
if (sz_res) *sz_res = 6*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* sigma_follows:(Fz,d_tire,w_tire,p_tire,p_rated,C_z)->(sigma) */
static int casadi_f60(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5, a6, a7, a8, a9;
a0=arg[2]? arg[2][0] : 0;
a1=arg[0]? arg[0][0] : 0;
a2=arg[1]? arg[1][0] : 0;
a3=sqrt(a2);
a4=sqrt(a0);
a3=a3*a4;
a3=a3*a0;
a4=8.0000000000000002e-02;
a5=arg[4]? arg[4][0] : 0;
a4=a4*a5;
a6=arg[3]? arg[3][0] : 0;
a4=a4+a6;
a3=a3*a4;
a1=a1/a3;
a3=5.5999999999999996e+00;
a4=arg[5]? arg[5][0] : 0;
a3=a3*a4;
a3=a1<=a3;
a7=2.3148148148148149e+00;
a8=9.2159999999999997e-01;
a9=8.6399999999999999e-01;
a9=a9*a1;
a9=a9/a4;
a8=a8+a9;
a8=sqrt(a8);
a7=a7*a8;
a8=2.2222222222222223e+00;
a7=a7-a8;
a7=a4*a7;
a7=a3?a7:0;
a3=!a3;
a8=4.1666666666666669e-01;
a8=a8*a1;
a4=a4+a8;
a3=a3?a4:0;
a7=a7+a3;
a7=a0*a7;
a7=a7/a2;
a2=5.2999999999999999e-02;
a2=a7<=a2;
a3=11.;
a3=a3*a7;
a3=a2?a3:0;
a2=!a2;
a4=6.8000000000000005e-02;
a4=a7<=a4;
a8=-500.;
a1=casadi_sq(a7);
a8=a8*a1;
a1=64.;
a1=a1*a7;
a8=a8+a1;
a1=1.4045000000000001e+00;
a8=a8-a1;
a8=a4?a8:0;
a4=!a4;
a1=9.0749999999999997e-01;
a9=4.;
a9=a9*a7;
a1=a1-a9;
a4=a4?a1:0;
a8=a8+a4;
a2=a2?a8:0;
a3=a3+a2;
a3=a3*a0;
a0=2.7999999999999998e+00;
a2=8.0000000000000004e-01;
a2=a2*a6;
a2=a2/a5;
a0=a0-a2;
a3=a3*a0;
if (res[0]!=0) res[0][0]=a3;
return 0;
}
CASADI_SYMBOL_EXPORT int sigma_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f60(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int sigma_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void sigma_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void sigma_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void sigma_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int sigma_follows_n_in(void) { return 6;}
CASADI_SYMBOL_EXPORT casadi_int sigma_follows_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real sigma_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* sigma_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz";
case 1: return "d_tire";
case 2: return "w_tire";
case 3: return "p_tire";
case 4: return "p_rated";
case 5: return "C_z";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* sigma_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "sigma";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* sigma_follows_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* sigma_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int sigma_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 6;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int sigma_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 6*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_sigma_follows:(Fz,d_tire,w_tire,p_tire,p_rated,C_z,out_sigma[1x1,0nz],fwd_Fz,fwd_d_tire,fwd_w_tire,fwd_p_tire,fwd_p_rated,fwd_C_z)->(fwd_sigma) */
static int casadi_f61(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30;
a00=2.7999999999999998e+00;
a01=8.0000000000000004e-01;
a02=arg[3]? arg[3][0] : 0;
a03=a01*a02;
a04=arg[4]? arg[4][0] : 0;
a03=a03/a04;
a00=a00-a03;
a05=arg[2]? arg[2][0] : 0;
a06=arg[0]? arg[0][0] : 0;
a07=arg[1]? arg[1][0] : 0;
a08=sqrt(a07);
a09=sqrt(a05);
a10=a08*a09;
a11=a10*a05;
a12=8.0000000000000002e-02;
a13=a12*a04;
a13=a13+a02;
a02=a11*a13;
a06=a06/a02;
a14=5.5999999999999996e+00;
a15=arg[5]? arg[5][0] : 0;
a14=a14*a15;
a14=a06<=a14;
a16=2.3148148148148149e+00;
a17=9.2159999999999997e-01;
a18=8.6399999999999999e-01;
a19=a18*a06;
a19=a19/a15;
a17=a17+a19;
a17=sqrt(a17);
a20=a16*a17;
a21=2.2222222222222223e+00;
a20=a20-a21;
a21=a15*a20;
a21=a14?a21:0;
a22=!a14;
a23=4.1666666666666669e-01;
a24=a23*a06;
a24=a15+a24;
a24=a22?a24:0;
a21=a21+a24;
a24=a05*a21;
a24=a24/a07;
a25=5.2999999999999999e-02;
a25=a24<=a25;
a26=11.;
a27=arg[9]? arg[9][0] : 0;
a21=a21*a27;
a28=arg[12]? arg[12][0] : 0;
a20=a20*a28;
a29=arg[7]? arg[7][0] : 0;
a29=a29/a02;
a06=a06/a02;
a02=arg[8]? arg[8][0] : 0;
a30=2.*a08;
a30=a02/a30;
a30=a09*a30;
a09=2.*a09;
a09=a27/a09;
a08=a08*a09;
a30=a30+a08;
a30=a05*a30;
a10=a10*a27;
a30=a30+a10;
a13=a13*a30;
a30=arg[11]? arg[11][0] : 0;
a12=a12*a30;
a10=arg[10]? arg[10][0] : 0;
a12=a12+a10;
a11=a11*a12;
a13=a13+a11;
a06=a06*a13;
a29=a29-a06;
a18=a18*a29;
a18=a18/a15;
a19=a19/a15;
a19=a19*a28;
a18=a18-a19;
a17=2.*a17;
a18=a18/a17;
a16=a16*a18;
a15=a15*a16;
a20=a20+a15;
a14=a14?a20:0;
a23=a23*a29;
a28=a28+a23;
a22=a22?a28:0;
a14=a14+a22;
a14=a05*a14;
a21=a21+a14;
a21=a21/a07;
a07=a24/a07;
a07=a07*a02;
a21=a21-a07;
a07=a26*a21;
a07=a25?a07:0;
a02=!a25;
a14=6.8000000000000005e-02;
a14=a24<=a14;
a22=-500.;
a28=2.*a24;
a28=a28*a21;
a28=a22*a28;
a23=64.;
a29=a23*a21;
a28=a28+a29;
a28=a14?a28:0;
a29=!a14;
a20=4.;
a21=a20*a21;
a21=-a21;
a21=a29?a21:0;
a28=a28+a21;
a28=a02?a28:0;
a07=a07+a28;
a07=a05*a07;
a26=a26*a24;
a25=a25?a26:0;
a26=casadi_sq(a24);
a22=a22*a26;
a23=a23*a24;
a22=a22+a23;
a23=1.4045000000000001e+00;
a22=a22-a23;
a14=a14?a22:0;
a22=9.0749999999999997e-01;
a20=a20*a24;
a22=a22-a20;
a29=a29?a22:0;
a14=a14+a29;
a02=a02?a14:0;
a25=a25+a02;
a27=a25*a27;
a07=a07+a27;
a00=a00*a07;
a25=a25*a05;
a01=a01*a10;
a01=a01/a04;
a03=a03/a04;
a03=a03*a30;
a01=a01-a03;
a25=a25*a01;
a00=a00-a25;
if (res[0]!=0) res[0][0]=a00;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_sigma_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f61(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_sigma_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_sigma_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_sigma_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_sigma_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_sigma_follows_n_in(void) { return 13;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_sigma_follows_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_sigma_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_sigma_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz";
case 1: return "d_tire";
case 2: return "w_tire";
case 3: return "p_tire";
case 4: return "p_rated";
case 5: return "C_z";
case 6: return "out_sigma";
case 7: return "fwd_Fz";
case 8: return "fwd_d_tire";
case 9: return "fwd_w_tire";
case 10: return "fwd_p_tire";
case 11: return "fwd_p_rated";
case 12: return "fwd_C_z";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_sigma_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_sigma";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_sigma_follows_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_sigma_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_sigma_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 13;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_sigma_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 13*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_sigma_follows:(Fz,d_tire,w_tire,p_tire,p_rated,C_z,out_sigma[1x1,0nz],adj_sigma)->(adj_Fz,adj_d_tire,adj_w_tire,adj_p_tire,adj_p_rated,adj_C_z) */
static int casadi_f62(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37;
a00=arg[0]? arg[0][0] : 0;
a01=arg[1]? arg[1][0] : 0;
a02=sqrt(a01);
a03=arg[2]? arg[2][0] : 0;
a04=sqrt(a03);
a05=a02*a04;
a06=a05*a03;
a07=8.0000000000000002e-02;
a08=arg[4]? arg[4][0] : 0;
a09=a07*a08;
a10=arg[3]? arg[3][0] : 0;
a09=a09+a10;
a11=a06*a09;
a00=a00/a11;
a12=5.5999999999999996e+00;
a13=arg[5]? arg[5][0] : 0;
a12=a12*a13;
a12=a00<=a12;
a14=!a12;
a15=4.1666666666666669e-01;
a16=2.3148148148148149e+00;
a17=9.2159999999999997e-01;
a18=8.6399999999999999e-01;
a19=a18*a00;
a19=a19/a13;
a17=a17+a19;
a17=sqrt(a17);
a20=a16*a17;
a21=2.2222222222222223e+00;
a20=a20-a21;
a21=a13*a20;
a21=a12?a21:0;
a22=a15*a00;
a22=a13+a22;
a22=a14?a22:0;
a21=a21+a22;
a22=a03*a21;
a22=a22/a01;
a23=6.8000000000000005e-02;
a23=a22<=a23;
a24=!a23;
a25=5.2999999999999999e-02;
a25=a22<=a25;
a26=!a25;
a27=4.;
a28=2.7999999999999998e+00;
a29=8.0000000000000004e-01;
a10=a29*a10;
a10=a10/a08;
a28=a28-a10;
a30=arg[7]? arg[7][0] : 0;
a28=a28*a30;
a31=a03*a28;
a32=a27*a31;
a32=-a32;
a32=a26?a32:0;
a32=a24?a32:0;
a33=64.;
a34=a33*a31;
a34=a26?a34:0;
a34=a23?a34:0;
a32=a32+a34;
a34=2.*a22;
a35=-500.;
a36=a35*a31;
a34=a34*a36;
a34=a26?a34:0;
a34=a23?a34:0;
a32=a32+a34;
a34=11.;
a31=a34*a31;
a31=a25?a31:0;
a32=a32+a31;
a31=a32/a01;
a36=a03*a31;
a15=a15*a36;
a15=a14?a15:0;
a37=a13*a36;
a16=a16*a37;
a17=2.*a17;
a16=a16/a17;
a17=a16/a13;
a18=a18*a17;
a18=a12?a18:0;
a15=a15+a18;
a18=a15/a11;
if (res[0]!=0) res[0][0]=a18;
a01=a22/a01;
a01=a01*a32;
a00=a00/a11;
a00=a00*a15;
a09=a09*a00;
a15=a03*a09;
a11=a04*a15;
a32=2.*a02;
a11=a11/a32;
a01=a01+a11;
a01=-a01;
if (res[1]!=0) res[1][0]=a01;
a34=a34*a22;
a25=a25?a34:0;
a34=casadi_sq(a22);
a35=a35*a34;
a33=a33*a22;
a35=a35+a33;
a33=1.4045000000000001e+00;
a35=a35-a33;
a23=a23?a35:0;
a35=9.0749999999999997e-01;
a27=a27*a22;
a35=a35-a27;
a24=a24?a35:0;
a23=a23+a24;
a26=a26?a23:0;
a25=a25+a26;
a28=a25*a28;
a21=a21*a31;
a28=a28+a21;
a05=a05*a09;
a28=a28-a05;
a02=a02*a15;
a04=2.*a04;
a02=a02/a04;
a28=a28-a02;
if (res[2]!=0) res[2][0]=a28;
a25=a25*a03;
a25=a25*a30;
a30=a25/a08;
a29=a29*a30;
a06=a06*a00;
a29=a29+a06;
a29=-a29;
if (res[3]!=0) res[3][0]=a29;
a10=a10/a08;
a10=a10*a25;
a07=a07*a06;
a10=a10-a07;
if (res[4]!=0) res[4][0]=a10;
a14=a14?a36:0;
a20=a20*a36;
a20=a12?a20:0;
a14=a14+a20;
a19=a19/a13;
a19=a19*a16;
a19=-a19;
a12=a12?a19:0;
a14=a14+a12;
if (res[5]!=0) res[5][0]=a14;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_sigma_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f62(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_sigma_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_sigma_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_sigma_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_sigma_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_sigma_follows_n_in(void) { return 8;}
CASADI_SYMBOL_EXPORT casadi_int adj1_sigma_follows_n_out(void) { return 6;}
CASADI_SYMBOL_EXPORT casadi_real adj1_sigma_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_sigma_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz";
case 1: return "d_tire";
case 2: return "w_tire";
case 3: return "p_tire";
case 4: return "p_rated";
case 5: return "C_z";
case 6: return "out_sigma";
case 7: return "adj_sigma";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_sigma_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_Fz";
case 1: return "adj_d_tire";
case 2: return "adj_w_tire";
case 3: return "adj_p_tire";
case 4: return "adj_p_rated";
case 5: return "adj_C_z";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_sigma_follows_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* adj1_sigma_follows_sparsity_out(casadi_int i) {
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
CASADI_SYMBOL_EXPORT int adj1_sigma_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 8;
if (sz_res) *sz_res = 6;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_sigma_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 8*sizeof(const casadi_real*);
if (sz_res) *sz_res = 6*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_sigma_follows:(Fz,d_tire,w_tire,p_tire,p_rated,C_z,out_sigma[1x1,0nz],adj_sigma,out_adj_Fz[1x1,0nz],out_adj_d_tire[1x1,0nz],out_adj_w_tire[1x1,0nz],out_adj_p_tire[1x1,0nz],out_adj_p_rated[1x1,0nz],out_adj_C_z[1x1,0nz],fwd_Fz,fwd_d_tire,fwd_w_tire,fwd_p_tire,fwd_p_rated,fwd_C_z,fwd_out_sigma[1x1,0nz],fwd_adj_sigma)->(fwd_adj_Fz,fwd_adj_d_tire,fwd_adj_w_tire,fwd_adj_p_tire,fwd_adj_p_rated,fwd_adj_C_z) */
static int casadi_f63(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
casadi_real a60, a61;
a00=arg[0]? arg[0][0] : 0;
a01=arg[1]? arg[1][0] : 0;
a02=sqrt(a01);
a03=arg[2]? arg[2][0] : 0;
a04=sqrt(a03);
a05=a02*a04;
a06=a05*a03;
a07=8.0000000000000002e-02;
a08=arg[4]? arg[4][0] : 0;
a09=a07*a08;
a10=arg[3]? arg[3][0] : 0;
a09=a09+a10;
a11=a06*a09;
a00=a00/a11;
a12=5.5999999999999996e+00;
a13=arg[5]? arg[5][0] : 0;
a12=a12*a13;
a12=a00<=a12;
a14=!a12;
a15=4.1666666666666669e-01;
a16=2.3148148148148149e+00;
a17=9.2159999999999997e-01;
a18=8.6399999999999999e-01;
a19=a18*a00;
a19=a19/a13;
a17=a17+a19;
a17=sqrt(a17);
a20=a16*a17;
a21=2.2222222222222223e+00;
a20=a20-a21;
a21=a13*a20;
a21=a12?a21:0;
a22=a15*a00;
a22=a13+a22;
a22=a14?a22:0;
a21=a21+a22;
a22=a03*a21;
a22=a22/a01;
a23=6.8000000000000005e-02;
a23=a22<=a23;
a24=!a23;
a25=5.2999999999999999e-02;
a25=a22<=a25;
a26=!a25;
a27=4.;
a28=2.7999999999999998e+00;
a29=8.0000000000000004e-01;
a10=a29*a10;
a10=a10/a08;
a28=a28-a10;
a30=arg[7]? arg[7][0] : 0;
a31=a28*a30;
a32=a03*a31;
a33=a27*a32;
a33=-a33;
a33=a26?a33:0;
a33=a24?a33:0;
a34=64.;
a35=a34*a32;
a35=a26?a35:0;
a35=a23?a35:0;
a33=a33+a35;
a35=2.*a22;
a36=-500.;
a37=a36*a32;
a38=a35*a37;
a38=a26?a38:0;
a38=a23?a38:0;
a33=a33+a38;
a38=11.;
a32=a38*a32;
a32=a25?a32:0;
a33=a33+a32;
a32=a33/a01;
a39=arg[16]? arg[16][0] : 0;
a40=a32*a39;
a41=a31*a39;
a42=arg[21]? arg[21][0] : 0;
a28=a28*a42;
a43=arg[17]? arg[17][0] : 0;
a44=a29*a43;
a44=a44/a08;
a45=a10/a08;
a46=arg[18]? arg[18][0] : 0;
a45=a45*a46;
a44=a44-a45;
a45=a30*a44;
a28=a28-a45;
a45=a03*a28;
a41=a41+a45;
a45=a27*a41;
a45=-a45;
a45=a26?a45:0;
a45=a24?a45:0;
a47=a34*a41;
a47=a26?a47:0;
a47=a23?a47:0;
a45=a45+a47;
a47=a21*a39;
a48=arg[19]? arg[19][0] : 0;
a49=a20*a48;
a50=arg[14]? arg[14][0] : 0;
a50=a50/a11;
a51=a00/a11;
a52=arg[15]? arg[15][0] : 0;
a53=2.*a02;
a53=a52/a53;
a54=a04*a53;
a55=2.*a04;
a55=a39/a55;
a56=a02*a55;
a54=a54+a56;
a56=a03*a54;
a57=a05*a39;
a56=a56+a57;
a57=a09*a56;
a58=a07*a46;
a58=a58+a43;
a43=a06*a58;
a57=a57+a43;
a51=a51*a57;
a50=a50-a51;
a51=a18*a50;
a51=a51/a13;
a43=a19/a13;
a43=a43*a48;
a51=a51-a43;
a43=2.*a17;
a43=a51/a43;
a59=a16*a43;
a60=a13*a59;
a49=a49+a60;
a49=a12?a49:0;
a60=a15*a50;
a60=a48+a60;
a60=a14?a60:0;
a49=a49+a60;
a60=a03*a49;
a47=a47+a60;
a47=a47/a01;
a60=a22/a01;
a60=a60*a52;
a47=a47-a60;
a60=2.*a47;
a37=a37*a60;
a60=a36*a41;
a35=a35*a60;
a37=a37+a35;
a37=a26?a37:0;
a37=a23?a37:0;
a45=a45+a37;
a41=a38*a41;
a41=a25?a41:0;
a45=a45+a41;
a41=a45/a01;
a37=a32/a01;
a37=a37*a52;
a41=a41-a37;
a37=a03*a41;
a40=a40+a37;
a37=a15*a40;
a37=a14?a37:0;
a35=a03*a32;
a60=a35*a48;
a61=a13*a40;
a60=a60+a61;
a60=a16*a60;
a17=2.*a17;
a60=a60/a17;
a61=a13*a35;
a16=a16*a61;
a16=a16/a17;
a17=a16/a17;
a43=2.*a43;
a17=a17*a43;
a60=a60-a17;
a17=a60/a13;
a43=a16/a13;
a61=a43/a13;
a61=a61*a48;
a17=a17-a61;
a17=a18*a17;
a17=a12?a17:0;
a37=a37+a17;
a17=a37/a11;
a15=a15*a35;
a15=a14?a15:0;
a18=a18*a43;
a18=a12?a18:0;
a15=a15+a18;
a18=a15/a11;
a18=a18/a11;
a18=a18*a57;
a17=a17-a18;
if (res[0]!=0) res[0][0]=a17;
a17=a47/a01;
a18=a22/a01;
a01=a18/a01;
a01=a01*a52;
a17=a17-a01;
a33=a33*a17;
a18=a18*a45;
a33=a33+a18;
a00=a00/a11;
a18=a00*a15;
a45=a09*a18;
a17=a03*a45;
a01=a17*a55;
a52=a45*a39;
a58=a18*a58;
a50=a50/a11;
a11=a00/a11;
a11=a11*a57;
a50=a50-a11;
a15=a15*a50;
a00=a00*a37;
a15=a15+a00;
a09=a09*a15;
a58=a58+a09;
a09=a03*a58;
a52=a52+a09;
a09=a04*a52;
a01=a01+a09;
a09=2.*a02;
a01=a01/a09;
a00=a04*a17;
a00=a00/a09;
a00=a00/a09;
a09=2.*a53;
a00=a00*a09;
a01=a01-a00;
a33=a33+a01;
a33=-a33;
if (res[1]!=0) res[1][0]=a33;
a33=a38*a47;
a33=a25?a33:0;
a01=2.*a22;
a01=a01*a47;
a01=a36*a01;
a00=a34*a47;
a01=a01+a00;
a01=a23?a01:0;
a47=a27*a47;
a47=-a47;
a47=a24?a47:0;
a01=a01+a47;
a01=a26?a01:0;
a33=a33+a01;
a31=a31*a33;
a38=a38*a22;
a25=a25?a38:0;
a38=casadi_sq(a22);
a36=a36*a38;
a34=a34*a22;
a36=a36+a34;
a34=1.4045000000000001e+00;
a36=a36-a34;
a23=a23?a36:0;
a36=9.0749999999999997e-01;
a27=a27*a22;
a36=a36-a27;
a24=a24?a36:0;
a23=a23+a24;
a26=a26?a23:0;
a25=a25+a26;
a28=a25*a28;
a31=a31+a28;
a32=a32*a49;
a21=a21*a41;
a32=a32+a21;
a31=a31+a32;
a45=a45*a54;
a05=a05*a58;
a45=a45+a05;
a31=a31-a45;
a53=a17*a53;
a52=a02*a52;
a53=a53+a52;
a04=2.*a04;
a53=a53/a04;
a02=a02*a17;
a02=a02/a04;
a02=a02/a04;
a55=2.*a55;
a02=a02*a55;
a53=a53-a02;
a31=a31-a53;
if (res[2]!=0) res[2][0]=a31;
a33=a03*a33;
a39=a25*a39;
a33=a33+a39;
a33=a30*a33;
a25=a25*a03;
a42=a25*a42;
a33=a33+a42;
a42=a33/a08;
a25=a25*a30;
a30=a25/a08;
a30=a30/a08;
a30=a30*a46;
a42=a42-a30;
a29=a29*a42;
a18=a18*a56;
a06=a06*a15;
a18=a18+a06;
a29=a29+a18;
a29=-a29;
if (res[3]!=0) res[3][0]=a29;
a44=a44/a08;
a10=a10/a08;
a08=a10/a08;
a08=a08*a46;
a44=a44-a08;
a25=a25*a44;
a10=a10*a33;
a25=a25+a10;
a07=a07*a18;
a25=a25-a07;
if (res[4]!=0) res[4][0]=a25;
a14=a14?a40:0;
a35=a35*a59;
a20=a20*a40;
a35=a35+a20;
a35=a12?a35:0;
a14=a14+a35;
a51=a51/a13;
a19=a19/a13;
a13=a19/a13;
a13=a13*a48;
a51=a51-a13;
a16=a16*a51;
a19=a19*a60;
a16=a16+a19;
a16=-a16;
a12=a12?a16:0;
a14=a14+a12;
if (res[5]!=0) res[5][0]=a14;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_sigma_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f63(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_sigma_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_sigma_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_sigma_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_sigma_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_sigma_follows_n_in(void) { return 22;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_sigma_follows_n_out(void) { return 6;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_sigma_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_sigma_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz";
case 1: return "d_tire";
case 2: return "w_tire";
case 3: return "p_tire";
case 4: return "p_rated";
case 5: return "C_z";
case 6: return "out_sigma";
case 7: return "adj_sigma";
case 8: return "out_adj_Fz";
case 9: return "out_adj_d_tire";
case 10: return "out_adj_w_tire";
case 11: return "out_adj_p_tire";
case 12: return "out_adj_p_rated";
case 13: return "out_adj_C_z";
case 14: return "fwd_Fz";
case 15: return "fwd_d_tire";
case 16: return "fwd_w_tire";
case 17: return "fwd_p_tire";
case 18: return "fwd_p_rated";
case 19: return "fwd_C_z";
case 20: return "fwd_out_sigma";
case 21: return "fwd_adj_sigma";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_sigma_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_Fz";
case 1: return "fwd_adj_d_tire";
case 2: return "fwd_adj_w_tire";
case 3: return "fwd_adj_p_tire";
case 4: return "fwd_adj_p_rated";
case 5: return "fwd_adj_C_z";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_sigma_follows_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_sigma_follows_sparsity_out(casadi_int i) {
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
CASADI_SYMBOL_EXPORT int fwd1_adj1_sigma_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 22;
if (sz_res) *sz_res = 6;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_sigma_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
if (sz_res) *sz_res = 6*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* C3_follows:(Fz,d_tire,w_tire,p_tire,p_rated,C_z,C_N)->(C3) */
static int casadi_f64(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12;
a00=arg[6]? arg[6][0] : 0;
a01=arg[2]? arg[2][0] : 0;
a02=casadi_sq(a01);
a00=a00*a02;
a02=4.4000000000000000e-01;
a03=arg[4]? arg[4][0] : 0;
a02=a02*a03;
a04=arg[3]? arg[3][0] : 0;
a02=a02+a04;
a00=a00*a02;
a02=a00*a01;
a05=arg[0]? arg[0][0] : 0;
a06=arg[1]? arg[1][0] : 0;
a07=sqrt(a06);
a08=sqrt(a01);
a07=a07*a08;
a07=a07*a01;
a08=8.0000000000000002e-02;
a08=a08*a03;
a08=a08+a04;
a07=a07*a08;
a08=a05/a07;
a04=5.5999999999999996e+00;
a03=arg[5]? arg[5][0] : 0;
a09=a04*a03;
a09=a08<=a09;
a10=9.2159999999999997e-01;
a11=8.6399999999999999e-01;
a11=a11*a08;
a11=a11/a03;
a10=a10+a11;
a10=sqrt(a10);
a11=1./a10;
a11=a09?a11:0;
a09=!a09;
a12=4.1666666666666669e-01;
a09=a09?a12:0;
a11=a11+a09;
a02=a02*a11;
a04=a04*a03;
a04=a08<=a04;
a11=2.3148148148148149e+00;
a11=a11*a10;
a10=2.2222222222222223e+00;
a11=a11-a10;
a11=a03*a11;
a11=a04?a11:0;
a04=!a04;
a12=a12*a08;
a03=a03+a12;
a04=a04?a03:0;
a11=a11+a04;
a01=a01*a11;
a01=a01/a06;
a11=8.7499999999999994e-02;
a04=a01<=a11;
a03=1.2000000000000000e+00;
a12=1.7600000000000001e+01;
a12=a12*a01;
a12=a03-a12;
a12=a04?a12:0;
a04=!a04;
a08=-3.4000000000000002e-01;
a04=a04?a08:0;
a12=a12+a04;
a02=a02*a12;
a07=a07*a06;
a02=a02/a07;
a11=a01<=a11;
a07=-8.8000000000000007e+00;
a06=casadi_sq(a01);
a07=a07*a06;
a03=a03*a01;
a07=a07+a03;
a07=a11?a07:0;
a11=!a11;
a03=6.7375000000000004e-02;
a06=3.4000000000000002e-01;
a06=a06*a01;
a03=a03-a06;
a11=a11?a03:0;
a07=a07+a11;
a00=a00*a07;
a00=a00/a05;
a02=a02-a00;
a02=a02/a05;
if (res[0]!=0) res[0][0]=a02;
return 0;
}
CASADI_SYMBOL_EXPORT int C3_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f64(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int C3_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void C3_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void C3_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void C3_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int C3_follows_n_in(void) { return 7;}
CASADI_SYMBOL_EXPORT casadi_int C3_follows_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real C3_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* C3_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz";
case 1: return "d_tire";
case 2: return "w_tire";
case 3: return "p_tire";
case 4: return "p_rated";
case 5: return "C_z";
case 6: return "C_N";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* C3_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "C3";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* C3_follows_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* C3_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int C3_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 7;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int C3_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 7*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_C3_follows:(Fz,d_tire,w_tire,p_tire,p_rated,C_z,C_N,out_C3[1x1,0nz],fwd_Fz,fwd_d_tire,fwd_w_tire,fwd_p_tire,fwd_p_rated,fwd_C_z,fwd_C_N)->(fwd_C3) */
static int casadi_f65(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40;
a00=arg[2]? arg[2][0] : 0;
a01=arg[0]? arg[0][0] : 0;
a02=arg[1]? arg[1][0] : 0;
a03=sqrt(a02);
a04=sqrt(a00);
a05=a03*a04;
a06=a05*a00;
a07=8.0000000000000002e-02;
a08=arg[4]? arg[4][0] : 0;
a09=a07*a08;
a10=arg[3]? arg[3][0] : 0;
a09=a09+a10;
a11=a06*a09;
a12=a01/a11;
a13=5.5999999999999996e+00;
a14=arg[5]? arg[5][0] : 0;
a15=a13*a14;
a15=a12<=a15;
a16=2.3148148148148149e+00;
a17=9.2159999999999997e-01;
a18=8.6399999999999999e-01;
a19=a18*a12;
a19=a19/a14;
a17=a17+a19;
a17=sqrt(a17);
a20=a16*a17;
a21=2.2222222222222223e+00;
a20=a20-a21;
a21=a14*a20;
a21=a15?a21:0;
a22=!a15;
a23=4.1666666666666669e-01;
a24=a23*a12;
a24=a14+a24;
a24=a22?a24:0;
a21=a21+a24;
a24=a00*a21;
a24=a24/a02;
a25=8.7499999999999994e-02;
a26=a24<=a25;
a27=1.2000000000000000e+00;
a28=1.7600000000000001e+01;
a29=a28*a24;
a29=a27-a29;
a29=a26?a29:0;
a30=!a26;
a31=-3.4000000000000002e-01;
a30=a30?a31:0;
a29=a29+a30;
a13=a13*a14;
a13=a12<=a13;
a30=1./a17;
a31=a13?a30:0;
a32=!a13;
a32=a32?a23:0;
a31=a31+a32;
a32=4.4000000000000000e-01;
a08=a32*a08;
a08=a08+a10;
a10=casadi_sq(a00);
a33=arg[14]? arg[14][0] : 0;
a33=a10*a33;
a34=arg[6]? arg[6][0] : 0;
a35=2.*a00;
a36=arg[10]? arg[10][0] : 0;
a35=a35*a36;
a35=a34*a35;
a33=a33+a35;
a33=a08*a33;
a34=a34*a10;
a10=arg[12]? arg[12][0] : 0;
a32=a32*a10;
a35=arg[11]? arg[11][0] : 0;
a32=a32+a35;
a32=a34*a32;
a33=a33+a32;
a32=a00*a33;
a34=a34*a08;
a08=a34*a36;
a32=a32+a08;
a32=a31*a32;
a08=a34*a00;
a30=a30/a17;
a37=arg[8]? arg[8][0] : 0;
a38=a37/a11;
a12=a12/a11;
a39=arg[9]? arg[9][0] : 0;
a40=2.*a03;
a40=a39/a40;
a40=a04*a40;
a04=2.*a04;
a04=a36/a04;
a03=a03*a04;
a40=a40+a03;
a40=a00*a40;
a05=a05*a36;
a40=a40+a05;
a09=a09*a40;
a07=a07*a10;
a07=a07+a35;
a06=a06*a07;
a09=a09+a06;
a12=a12*a09;
a38=a38-a12;
a18=a18*a38;
a18=a18/a14;
a19=a19/a14;
a12=arg[13]? arg[13][0] : 0;
a19=a19*a12;
a18=a18-a19;
a17=2.*a17;
a18=a18/a17;
a30=a30*a18;
a30=a08*a30;
a30=-a30;
a13=a13?a30:0;
a32=a32+a13;
a32=a29*a32;
a08=a08*a31;
a21=a21*a36;
a20=a20*a12;
a16=a16*a18;
a14=a14*a16;
a20=a20+a14;
a15=a15?a20:0;
a23=a23*a38;
a12=a12+a23;
a22=a22?a12:0;
a15=a15+a22;
a00=a00*a15;
a21=a21+a00;
a21=a21/a02;
a00=a24/a02;
a00=a00*a39;
a21=a21-a00;
a28=a28*a21;
a28=a08*a28;
a28=-a28;
a26=a26?a28:0;
a32=a32+a26;
a26=a11*a02;
a32=a32/a26;
a08=a08*a29;
a08=a08/a26;
a26=a08/a26;
a02=a02*a09;
a11=a11*a39;
a02=a02+a11;
a26=a26*a02;
a32=a32-a26;
a25=a24<=a25;
a26=-8.8000000000000007e+00;
a02=casadi_sq(a24);
a02=a26*a02;
a11=a27*a24;
a02=a02+a11;
a02=a25?a02:0;
a11=!a25;
a39=6.7375000000000004e-02;
a09=3.4000000000000002e-01;
a29=a09*a24;
a39=a39-a29;
a39=a11?a39:0;
a02=a02+a39;
a33=a02*a33;
a24=2.*a24;
a24=a24*a21;
a26=a26*a24;
a27=a27*a21;
a26=a26+a27;
a25=a25?a26:0;
a09=a09*a21;
a09=-a09;
a11=a11?a09:0;
a25=a25+a11;
a25=a34*a25;
a33=a33+a25;
a33=a33/a01;
a34=a34*a02;
a34=a34/a01;
a02=a34/a01;
a02=a02*a37;
a33=a33-a02;
a32=a32-a33;
a32=a32/a01;
a08=a08-a34;
a08=a08/a01;
a08=a08/a01;
a08=a08*a37;
a32=a32-a08;
if (res[0]!=0) res[0][0]=a32;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_C3_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f65(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_C3_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_C3_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_C3_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_C3_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_C3_follows_n_in(void) { return 15;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_C3_follows_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_C3_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_C3_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz";
case 1: return "d_tire";
case 2: return "w_tire";
case 3: return "p_tire";
case 4: return "p_rated";
case 5: return "C_z";
case 6: return "C_N";
case 7: return "out_C3";
case 8: return "fwd_Fz";
case 9: return "fwd_d_tire";
case 10: return "fwd_w_tire";
case 11: return "fwd_p_tire";
case 12: return "fwd_p_rated";
case 13: return "fwd_C_z";
case 14: return "fwd_C_N";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_C3_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_C3";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_C3_follows_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s1;
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_C3_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_C3_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 15;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_C3_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 15*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_C3_follows:(Fz,d_tire,w_tire,p_tire,p_rated,C_z,C_N,out_C3[1x1,0nz],adj_C3)->(adj_Fz,adj_d_tire,adj_w_tire,adj_p_tire,adj_p_rated,adj_C_z,adj_C_N) */
static int casadi_f66(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
a00=arg[6]? arg[6][0] : 0;
a01=arg[2]? arg[2][0] : 0;
a02=casadi_sq(a01);
a03=a00*a02;
a04=4.4000000000000000e-01;
a05=arg[4]? arg[4][0] : 0;
a06=a04*a05;
a07=arg[3]? arg[3][0] : 0;
a06=a06+a07;
a08=a03*a06;
a09=arg[0]? arg[0][0] : 0;
a10=arg[1]? arg[1][0] : 0;
a11=sqrt(a10);
a12=sqrt(a01);
a13=a11*a12;
a14=a13*a01;
a15=8.0000000000000002e-02;
a05=a15*a05;
a05=a05+a07;
a07=a14*a05;
a16=a09/a07;
a17=5.5999999999999996e+00;
a18=arg[5]? arg[5][0] : 0;
a19=a17*a18;
a19=a16<=a19;
a20=2.3148148148148149e+00;
a21=9.2159999999999997e-01;
a22=8.6399999999999999e-01;
a23=a22*a16;
a23=a23/a18;
a21=a21+a23;
a21=sqrt(a21);
a24=a20*a21;
a25=2.2222222222222223e+00;
a24=a24-a25;
a25=a18*a24;
a25=a19?a25:0;
a26=!a19;
a27=4.1666666666666669e-01;
a28=a27*a16;
a28=a18+a28;
a28=a26?a28:0;
a25=a25+a28;
a28=a01*a25;
a28=a28/a10;
a29=8.7499999999999994e-02;
a30=a28<=a29;
a31=-8.8000000000000007e+00;
a32=casadi_sq(a28);
a32=a31*a32;
a33=1.2000000000000000e+00;
a34=a33*a28;
a32=a32+a34;
a32=a30?a32:0;
a34=!a30;
a35=6.7375000000000004e-02;
a36=3.4000000000000002e-01;
a37=a36*a28;
a35=a35-a37;
a35=a34?a35:0;
a32=a32+a35;
a35=a08*a32;
a35=a35/a09;
a37=a35/a09;
a38=arg[8]? arg[8][0] : 0;
a39=a38/a09;
a37=a37*a39;
a40=a08*a01;
a17=a17*a18;
a17=a16<=a17;
a41=1./a21;
a42=a17?a41:0;
a43=!a17;
a43=a43?a27:0;
a42=a42+a43;
a43=a40*a42;
a29=a28<=a29;
a44=1.7600000000000001e+01;
a45=a44*a28;
a45=a33-a45;
a45=a29?a45:0;
a46=!a29;
a47=-3.4000000000000002e-01;
a46=a46?a47:0;
a45=a45+a46;
a46=a43*a45;
a47=a07*a10;
a46=a46/a47;
a35=a46-a35;
a35=a35/a09;
a35=a35/a09;
a35=a35*a38;
a37=a37-a35;
a09=a39/a09;
a35=a08*a09;
a36=a36*a35;
a34=a34?a36:0;
a33=a33*a35;
a33=-a33;
a33=a30?a33:0;
a34=a34+a33;
a33=2.*a28;
a31=a31*a35;
a33=a33*a31;
a33=-a33;
a30=a30?a33:0;
a34=a34+a30;
a30=a39/a47;
a43=a43*a30;
a44=a44*a43;
a44=-a44;
a29=a29?a44:0;
a34=a34+a29;
a29=a34/a10;
a44=a01*a29;
a27=a27*a44;
a27=a26?a27:0;
a43=a18*a44;
a20=a20*a43;
a20=a19?a20:0;
a41=a41/a21;
a45=a45*a30;
a40=a40*a45;
a41=a41*a40;
a41=-a41;
a17=a17?a41:0;
a20=a20+a17;
a21=2.*a21;
a20=a20/a21;
a21=a20/a18;
a22=a22*a21;
a27=a27+a22;
a22=a27/a07;
a37=a37+a22;
if (res[0]!=0) res[0][0]=a37;
a46=a46/a47;
a46=a46*a39;
a39=a07*a46;
a28=a28/a10;
a28=a28*a34;
a39=a39+a28;
a10=a10*a46;
a16=a16/a07;
a16=a16*a27;
a10=a10+a16;
a05=a05*a10;
a16=a01*a05;
a27=a12*a16;
a07=2.*a11;
a27=a27/a07;
a39=a39+a27;
a39=-a39;
if (res[1]!=0) res[1][0]=a39;
a25=a25*a29;
a13=a13*a05;
a25=a25-a13;
a11=a11*a16;
a12=2.*a12;
a11=a11/a12;
a25=a25-a11;
a42=a42*a45;
a08=a08*a42;
a25=a25+a08;
a08=2.*a01;
a01=a01*a42;
a32=a32*a09;
a01=a01-a32;
a06=a06*a01;
a00=a00*a06;
a08=a08*a00;
a25=a25+a08;
if (res[2]!=0) res[2][0]=a25;
a03=a03*a01;
a14=a14*a10;
a10=a03-a14;
if (res[3]!=0) res[3][0]=a10;
a04=a04*a03;
a15=a15*a14;
a04=a04-a15;
if (res[4]!=0) res[4][0]=a04;
a26=a26?a44:0;
a24=a24*a44;
a19=a19?a24:0;
a26=a26+a19;
a23=a23/a18;
a23=a23*a20;
a26=a26-a23;
if (res[5]!=0) res[5][0]=a26;
a02=a02*a06;
if (res[6]!=0) res[6][0]=a02;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_C3_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f66(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_C3_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_C3_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_C3_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_C3_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_C3_follows_n_in(void) { return 9;}
CASADI_SYMBOL_EXPORT casadi_int adj1_C3_follows_n_out(void) { return 7;}
CASADI_SYMBOL_EXPORT casadi_real adj1_C3_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_C3_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz";
case 1: return "d_tire";
case 2: return "w_tire";
case 3: return "p_tire";
case 4: return "p_rated";
case 5: return "C_z";
case 6: return "C_N";
case 7: return "out_C3";
case 8: return "adj_C3";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_C3_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_Fz";
case 1: return "adj_d_tire";
case 2: return "adj_w_tire";
case 3: return "adj_p_tire";
case 4: return "adj_p_rated";
case 5: return "adj_C_z";
case 6: return "adj_C_N";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_C3_follows_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s1;
case 8: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_C3_follows_sparsity_out(casadi_int i) {
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
CASADI_SYMBOL_EXPORT int adj1_C3_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 9;
if (sz_res) *sz_res = 7;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_C3_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 9*sizeof(const casadi_real*);
if (sz_res) *sz_res = 7*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_C3_follows:(Fz,d_tire,w_tire,p_tire,p_rated,C_z,C_N,out_C3[1x1,0nz],adj_C3,out_adj_Fz[1x1,0nz],out_adj_d_tire[1x1,0nz],out_adj_w_tire[1x1,0nz],out_adj_p_tire[1x1,0nz],out_adj_p_rated[1x1,0nz],out_adj_C_z[1x1,0nz],out_adj_C_N[1x1,0nz],fwd_Fz,fwd_d_tire,fwd_w_tire,fwd_p_tire,fwd_p_rated,fwd_C_z,fwd_C_N,fwd_out_C3[1x1,0nz],fwd_adj_C3)->(fwd_adj_Fz,fwd_adj_d_tire,fwd_adj_w_tire,fwd_adj_p_tire,fwd_adj_p_rated,fwd_adj_C_z,fwd_adj_C_N) */
static int casadi_f67(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
casadi_real a72, a73, a74, a75, a76, a77, a78, a79, a80, a81, a82, a83;
a00=arg[8]? arg[8][0] : 0;
a01=arg[0]? arg[0][0] : 0;
a02=a00/a01;
a03=arg[2]? arg[2][0] : 0;
a04=arg[1]? arg[1][0] : 0;
a05=sqrt(a04);
a06=sqrt(a03);
a07=a05*a06;
a08=a07*a03;
a09=8.0000000000000002e-02;
a10=arg[4]? arg[4][0] : 0;
a11=a09*a10;
a12=arg[3]? arg[3][0] : 0;
a11=a11+a12;
a13=a08*a11;
a14=a01/a13;
a15=5.5999999999999996e+00;
a16=arg[5]? arg[5][0] : 0;
a17=a15*a16;
a17=a14<=a17;
a18=2.3148148148148149e+00;
a19=9.2159999999999997e-01;
a20=8.6399999999999999e-01;
a21=a20*a14;
a21=a21/a16;
a19=a19+a21;
a19=sqrt(a19);
a22=a18*a19;
a23=2.2222222222222223e+00;
a22=a22-a23;
a23=a16*a22;
a23=a17?a23:0;
a24=!a17;
a25=4.1666666666666669e-01;
a26=a25*a14;
a26=a16+a26;
a26=a24?a26:0;
a23=a23+a26;
a26=a03*a23;
a26=a26/a04;
a27=8.7499999999999994e-02;
a28=a26<=a27;
a29=-8.8000000000000007e+00;
a30=casadi_sq(a26);
a30=a29*a30;
a31=1.2000000000000000e+00;
a32=a31*a26;
a30=a30+a32;
a30=a28?a30:0;
a32=!a28;
a33=6.7375000000000004e-02;
a34=3.4000000000000002e-01;
a35=a34*a26;
a33=a33-a35;
a33=a32?a33:0;
a30=a30+a33;
a33=4.4000000000000000e-01;
a10=a33*a10;
a10=a10+a12;
a12=casadi_sq(a03);
a35=arg[22]? arg[22][0] : 0;
a36=a12*a35;
a37=arg[6]? arg[6][0] : 0;
a38=2.*a03;
a39=arg[18]? arg[18][0] : 0;
a38=a38*a39;
a40=a37*a38;
a36=a36+a40;
a40=a10*a36;
a41=a37*a12;
a42=arg[20]? arg[20][0] : 0;
a43=a33*a42;
a44=arg[19]? arg[19][0] : 0;
a43=a43+a44;
a45=a41*a43;
a40=a40+a45;
a45=a30*a40;
a46=a41*a10;
a47=2.*a26;
a48=a23*a39;
a49=arg[21]? arg[21][0] : 0;
a50=a22*a49;
a51=arg[16]? arg[16][0] : 0;
a52=a51/a13;
a53=a14/a13;
a54=arg[17]? arg[17][0] : 0;
a55=2.*a05;
a55=a54/a55;
a56=a06*a55;
a57=2.*a06;
a57=a39/a57;
a58=a05*a57;
a56=a56+a58;
a58=a03*a56;
a59=a07*a39;
a58=a58+a59;
a59=a11*a58;
a42=a09*a42;
a42=a42+a44;
a44=a08*a42;
a59=a59+a44;
a53=a53*a59;
a52=a52-a53;
a53=a20*a52;
a53=a53/a16;
a44=a21/a16;
a44=a44*a49;
a53=a53-a44;
a44=2.*a19;
a44=a53/a44;
a60=a18*a44;
a61=a16*a60;
a50=a50+a61;
a50=a17?a50:0;
a61=a25*a52;
a61=a49+a61;
a61=a24?a61:0;
a50=a50+a61;
a61=a03*a50;
a48=a48+a61;
a48=a48/a04;
a61=a26/a04;
a61=a61*a54;
a48=a48-a61;
a47=a47*a48;
a47=a29*a47;
a61=a31*a48;
a47=a47+a61;
a47=a28?a47:0;
a61=a34*a48;
a61=-a61;
a61=a32?a61:0;
a47=a47+a61;
a61=a46*a47;
a45=a45+a61;
a45=a45/a01;
a61=a46*a30;
a61=a61/a01;
a62=a61/a01;
a62=a62*a51;
a45=a45-a62;
a62=a45/a01;
a63=a61/a01;
a64=a63/a01;
a64=a64*a51;
a62=a62-a64;
a62=a02*a62;
a64=arg[24]? arg[24][0] : 0;
a65=a64/a01;
a66=a02/a01;
a66=a66*a51;
a65=a65-a66;
a63=a63*a65;
a62=a62+a63;
a27=a26<=a27;
a63=1.7600000000000001e+01;
a66=a63*a26;
a66=a31-a66;
a66=a27?a66:0;
a67=!a27;
a68=-3.4000000000000002e-01;
a67=a67?a68:0;
a66=a66+a67;
a15=a15*a16;
a15=a14<=a15;
a67=1./a19;
a68=a15?a67:0;
a69=!a15;
a69=a69?a25:0;
a68=a68+a69;
a69=a03*a40;
a70=a46*a39;
a69=a69+a70;
a70=a68*a69;
a71=a46*a03;
a72=a67/a19;
a72=a72*a44;
a73=a71*a72;
a73=-a73;
a73=a15?a73:0;
a70=a70+a73;
a73=a66*a70;
a74=a71*a68;
a75=a63*a48;
a76=a74*a75;
a76=-a76;
a76=a27?a76:0;
a73=a73+a76;
a76=a13*a04;
a73=a73/a76;
a77=a74*a66;
a77=a77/a76;
a78=a77/a76;
a79=a04*a59;
a80=a13*a54;
a79=a79+a80;
a78=a78*a79;
a73=a73-a78;
a45=a73-a45;
a45=a45/a01;
a61=a77-a61;
a61=a61/a01;
a78=a61/a01;
a78=a78*a51;
a45=a45-a78;
a45=a45/a01;
a61=a61/a01;
a78=a61/a01;
a78=a78*a51;
a45=a45-a78;
a00=a00*a45;
a61=a61*a64;
a00=a00+a61;
a62=a62-a00;
a00=a02/a01;
a61=a46*a00;
a64=a34*a61;
a64=a32?a64:0;
a45=a31*a61;
a45=-a45;
a45=a28?a45:0;
a64=a64+a45;
a45=2.*a26;
a61=a29*a61;
a78=a45*a61;
a78=-a78;
a78=a28?a78:0;
a64=a64+a78;
a78=a02/a76;
a80=a74*a78;
a80=a63*a80;
a80=-a80;
a80=a27?a80:0;
a64=a64+a80;
a80=a64/a04;
a81=a80*a39;
a82=a00*a40;
a83=a65/a01;
a01=a00/a01;
a01=a01*a51;
a83=a83-a01;
a01=a46*a83;
a82=a82+a01;
a34=a34*a82;
a32=a32?a34:0;
a31=a31*a82;
a31=-a31;
a31=a28?a31:0;
a32=a32+a31;
a31=2.*a48;
a61=a61*a31;
a29=a29*a82;
a45=a45*a29;
a61=a61+a45;
a61=-a61;
a28=a28?a61:0;
a32=a32+a28;
a70=a78*a70;
a28=a65/a76;
a61=a78/a76;
a61=a61*a79;
a28=a28-a61;
a74=a74*a28;
a70=a70+a74;
a63=a63*a70;
a63=-a63;
a63=a27?a63:0;
a32=a32+a63;
a63=a32/a04;
a70=a80/a04;
a70=a70*a54;
a63=a63-a70;
a70=a03*a63;
a81=a81+a70;
a70=a25*a81;
a70=a24?a70:0;
a74=a03*a80;
a61=a74*a49;
a45=a16*a81;
a61=a61+a45;
a61=a18*a61;
a61=a17?a61:0;
a67=a67/a19;
a45=a66*a78;
a69=a45*a69;
a78=a78*a75;
a78=-a78;
a27=a27?a78:0;
a66=a66*a28;
a27=a27+a66;
a66=a71*a27;
a69=a69+a66;
a69=a67*a69;
a71=a71*a45;
a66=a72/a19;
a28=a67/a19;
a28=a28*a44;
a66=a66+a28;
a66=a71*a66;
a69=a69-a66;
a69=-a69;
a69=a15?a69:0;
a61=a61+a69;
a19=2.*a19;
a61=a61/a19;
a69=a16*a74;
a18=a18*a69;
a18=a17?a18:0;
a67=a67*a71;
a67=-a67;
a67=a15?a67:0;
a18=a18+a67;
a18=a18/a19;
a19=a18/a19;
a44=2.*a44;
a19=a19*a44;
a61=a61-a19;
a19=a61/a16;
a44=a18/a16;
a67=a44/a16;
a67=a67*a49;
a19=a19-a67;
a19=a20*a19;
a70=a70+a19;
a19=a70/a13;
a25=a25*a74;
a25=a24?a25:0;
a20=a20*a44;
a25=a25+a20;
a20=a25/a13;
a20=a20/a13;
a20=a20*a59;
a19=a19-a20;
a62=a62+a19;
if (res[0]!=0) res[0][0]=a62;
a77=a77/a76;
a62=a77*a02;
a19=a62*a59;
a73=a73/a76;
a76=a77/a76;
a76=a76*a79;
a73=a73-a76;
a02=a02*a73;
a77=a77*a65;
a02=a02+a77;
a77=a13*a02;
a19=a19+a77;
a48=a48/a04;
a26=a26/a04;
a77=a26/a04;
a77=a77*a54;
a48=a48-a77;
a64=a64*a48;
a26=a26*a32;
a64=a64+a26;
a19=a19+a64;
a64=a04*a62;
a14=a14/a13;
a26=a14*a25;
a64=a64+a26;
a26=a11*a64;
a32=a03*a26;
a48=a32*a57;
a77=a26*a39;
a42=a64*a42;
a62=a62*a54;
a04=a04*a02;
a62=a62+a04;
a52=a52/a13;
a13=a14/a13;
a13=a13*a59;
a52=a52-a13;
a25=a25*a52;
a14=a14*a70;
a25=a25+a14;
a62=a62+a25;
a11=a11*a62;
a42=a42+a11;
a11=a03*a42;
a77=a77+a11;
a11=a06*a77;
a48=a48+a11;
a11=2.*a05;
a48=a48/a11;
a25=a06*a32;
a25=a25/a11;
a25=a25/a11;
a11=2.*a55;
a25=a25*a11;
a48=a48-a25;
a19=a19+a48;
a19=-a19;
if (res[1]!=0) res[1][0]=a19;
a80=a80*a50;
a23=a23*a63;
a80=a80+a23;
a26=a26*a56;
a07=a07*a42;
a26=a26+a07;
a80=a80-a26;
a55=a32*a55;
a77=a05*a77;
a55=a55+a77;
a06=2.*a06;
a55=a55/a06;
a05=a05*a32;
a05=a05/a06;
a05=a05/a06;
a57=2.*a57;
a05=a05*a57;
a55=a55-a05;
a80=a80-a55;
a55=a68*a45;
a40=a55*a40;
a45=a45*a72;
a45=-a45;
a15=a15?a45:0;
a68=a68*a27;
a15=a15+a68;
a46=a46*a15;
a40=a40+a46;
a80=a80+a40;
a40=a03*a55;
a46=a30*a00;
a40=a40-a46;
a46=a10*a40;
a68=a37*a46;
a27=2.*a39;
a68=a68*a27;
a27=2.*a03;
a35=a46*a35;
a43=a40*a43;
a55=a55*a39;
a03=a03*a15;
a55=a55+a03;
a00=a00*a47;
a30=a30*a83;
a00=a00+a30;
a55=a55-a00;
a10=a10*a55;
a43=a43+a10;
a37=a37*a43;
a35=a35+a37;
a27=a27*a35;
a68=a68+a27;
a80=a80+a68;
if (res[2]!=0) res[2][0]=a80;
a40=a40*a36;
a41=a41*a55;
a40=a40+a41;
a64=a64*a58;
a08=a08*a62;
a64=a64+a08;
a08=a40-a64;
if (res[3]!=0) res[3][0]=a08;
a33=a33*a40;
a09=a09*a64;
a33=a33-a09;
if (res[4]!=0) res[4][0]=a33;
a24=a24?a81:0;
a74=a74*a60;
a22=a22*a81;
a74=a74+a22;
a17=a17?a74:0;
a24=a24+a17;
a53=a53/a16;
a21=a21/a16;
a16=a21/a16;
a16=a16*a49;
a53=a53-a16;
a18=a18*a53;
a21=a21*a61;
a18=a18+a21;
a24=a24-a18;
if (res[5]!=0) res[5][0]=a24;
a46=a46*a38;
a12=a12*a43;
a46=a46+a12;
if (res[6]!=0) res[6][0]=a46;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_C3_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f67(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_C3_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_C3_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_C3_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_C3_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_C3_follows_n_in(void) { return 25;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_C3_follows_n_out(void) { return 7;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_C3_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_C3_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz";
case 1: return "d_tire";
case 2: return "w_tire";
case 3: return "p_tire";
case 4: return "p_rated";
case 5: return "C_z";
case 6: return "C_N";
case 7: return "out_C3";
case 8: return "adj_C3";
case 9: return "out_adj_Fz";
case 10: return "out_adj_d_tire";
case 11: return "out_adj_w_tire";
case 12: return "out_adj_p_tire";
case 13: return "out_adj_p_rated";
case 14: return "out_adj_C_z";
case 15: return "out_adj_C_N";
case 16: return "fwd_Fz";
case 17: return "fwd_d_tire";
case 18: return "fwd_w_tire";
case 19: return "fwd_p_tire";
case 20: return "fwd_p_rated";
case 21: return "fwd_C_z";
case 22: return "fwd_C_N";
case 23: return "fwd_out_C3";
case 24: return "fwd_adj_C3";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_C3_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_Fz";
case 1: return "fwd_adj_d_tire";
case 2: return "fwd_adj_w_tire";
case 3: return "fwd_adj_p_tire";
case 4: return "fwd_adj_p_rated";
case 5: return "fwd_adj_C_z";
case 6: return "fwd_adj_C_N";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_C3_follows_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
case 1: return casadi_s0;
case 2: return casadi_s0;
case 3: return casadi_s0;
case 4: return casadi_s0;
case 5: return casadi_s0;
case 6: return casadi_s0;
case 7: return casadi_s1;
case 8: return casadi_s0;
case 9: return casadi_s1;
case 10: return casadi_s1;
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
case 23: return casadi_s1;
case 24: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_C3_follows_sparsity_out(casadi_int i) {
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
CASADI_SYMBOL_EXPORT int fwd1_adj1_C3_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 25;
if (sz_res) *sz_res = 7;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_C3_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 25*sizeof(const casadi_real*);
if (sz_res) *sz_res = 7*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* B3_follows:(Fz,C3,d_tire,w_tire,p_tire,p_rated,C_z,C_N)->(B3) */
static int casadi_f68(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5, a6, a7, a8, a9;
a0=arg[7]? arg[7][0] : 0;
a1=arg[3]? arg[3][0] : 0;
a2=casadi_sq(a1);
a0=a0*a2;
a2=4.4000000000000000e-01;
a3=arg[5]? arg[5][0] : 0;
a2=a2*a3;
a4=arg[4]? arg[4][0] : 0;
a2=a2+a4;
a0=a0*a2;
a2=arg[0]? arg[0][0] : 0;
a5=arg[2]? arg[2][0] : 0;
a6=sqrt(a5);
a7=sqrt(a1);
a6=a6*a7;
a6=a6*a1;
a7=8.0000000000000002e-02;
a7=a7*a3;
a7=a7+a4;
a6=a6*a7;
a6=a2/a6;
a7=5.5999999999999996e+00;
a4=arg[6]? arg[6][0] : 0;
a7=a7*a4;
a7=a6<=a7;
a3=2.3148148148148149e+00;
a8=9.2159999999999997e-01;
a9=8.6399999999999999e-01;
a9=a9*a6;
a9=a9/a4;
a8=a8+a9;
a8=sqrt(a8);
a3=a3*a8;
a8=2.2222222222222223e+00;
a3=a3-a8;
a3=a4*a3;
a3=a7?a3:0;
a7=!a7;
a8=4.1666666666666669e-01;
a8=a8*a6;
a4=a4+a8;
a7=a7?a4:0;
a3=a3+a7;
a1=a1*a3;
a1=a1/a5;
a5=8.7499999999999994e-02;
a5=a1<=a5;
a3=-8.8000000000000007e+00;
a7=casadi_sq(a1);
a3=a3*a7;
a7=1.2000000000000000e+00;
a7=a7*a1;
a3=a3+a7;
a3=a5?a3:0;
a5=!a5;
a7=6.7375000000000004e-02;
a4=3.4000000000000002e-01;
a4=a4*a1;
a7=a7-a4;
a5=a5?a7:0;
a3=a3+a5;
a0=a0*a3;
a0=a0/a2;
a3=arg[1]? arg[1][0] : 0;
a3=a3*a2;
a0=a0-a3;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int B3_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f68(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int B3_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void B3_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void B3_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void B3_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int B3_follows_n_in(void) { return 8;}
CASADI_SYMBOL_EXPORT casadi_int B3_follows_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real B3_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* B3_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz";
case 1: return "C3";
case 2: return "d_tire";
case 3: return "w_tire";
case 4: return "p_tire";
case 5: return "p_rated";
case 6: return "C_z";
case 7: return "C_N";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* B3_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "B3";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* B3_follows_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* B3_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int B3_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 8;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int B3_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 8*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_B3_follows:(Fz,C3,d_tire,w_tire,p_tire,p_rated,C_z,C_N,out_B3[1x1,0nz],fwd_Fz,fwd_C3,fwd_d_tire,fwd_w_tire,fwd_p_tire,fwd_p_rated,fwd_C_z,fwd_C_N)->(fwd_B3) */
static int casadi_f69(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37;
a00=arg[3]? arg[3][0] : 0;
a01=arg[0]? arg[0][0] : 0;
a02=arg[2]? arg[2][0] : 0;
a03=sqrt(a02);
a04=sqrt(a00);
a05=a03*a04;
a06=a05*a00;
a07=8.0000000000000002e-02;
a08=arg[5]? arg[5][0] : 0;
a09=a07*a08;
a10=arg[4]? arg[4][0] : 0;
a09=a09+a10;
a11=a06*a09;
a12=a01/a11;
a13=5.5999999999999996e+00;
a14=arg[6]? arg[6][0] : 0;
a13=a13*a14;
a13=a12<=a13;
a15=2.3148148148148149e+00;
a16=9.2159999999999997e-01;
a17=8.6399999999999999e-01;
a18=a17*a12;
a18=a18/a14;
a16=a16+a18;
a16=sqrt(a16);
a19=a15*a16;
a20=2.2222222222222223e+00;
a19=a19-a20;
a20=a14*a19;
a20=a13?a20:0;
a21=!a13;
a22=4.1666666666666669e-01;
a23=a22*a12;
a23=a14+a23;
a23=a21?a23:0;
a20=a20+a23;
a23=a00*a20;
a23=a23/a02;
a24=8.7499999999999994e-02;
a24=a23<=a24;
a25=-8.8000000000000007e+00;
a26=casadi_sq(a23);
a26=a25*a26;
a27=1.2000000000000000e+00;
a28=a27*a23;
a26=a26+a28;
a26=a24?a26:0;
a28=!a24;
a29=6.7375000000000004e-02;
a30=3.4000000000000002e-01;
a31=a30*a23;
a29=a29-a31;
a29=a28?a29:0;
a26=a26+a29;
a29=4.4000000000000000e-01;
a08=a29*a08;
a08=a08+a10;
a10=casadi_sq(a00);
a31=arg[16]? arg[16][0] : 0;
a31=a10*a31;
a32=arg[7]? arg[7][0] : 0;
a33=2.*a00;
a34=arg[12]? arg[12][0] : 0;
a33=a33*a34;
a33=a32*a33;
a31=a31+a33;
a31=a08*a31;
a32=a32*a10;
a10=arg[14]? arg[14][0] : 0;
a29=a29*a10;
a33=arg[13]? arg[13][0] : 0;
a29=a29+a33;
a29=a32*a29;
a31=a31+a29;
a31=a26*a31;
a32=a32*a08;
a08=2.*a23;
a20=a20*a34;
a29=arg[15]? arg[15][0] : 0;
a19=a19*a29;
a35=arg[9]? arg[9][0] : 0;
a36=a35/a11;
a12=a12/a11;
a11=arg[11]? arg[11][0] : 0;
a37=2.*a03;
a37=a11/a37;
a37=a04*a37;
a04=2.*a04;
a04=a34/a04;
a03=a03*a04;
a37=a37+a03;
a37=a00*a37;
a05=a05*a34;
a37=a37+a05;
a09=a09*a37;
a07=a07*a10;
a07=a07+a33;
a06=a06*a07;
a09=a09+a06;
a12=a12*a09;
a36=a36-a12;
a17=a17*a36;
a17=a17/a14;
a18=a18/a14;
a18=a18*a29;
a17=a17-a18;
a16=2.*a16;
a17=a17/a16;
a15=a15*a17;
a14=a14*a15;
a19=a19+a14;
a13=a13?a19:0;
a22=a22*a36;
a29=a29+a22;
a21=a21?a29:0;
a13=a13+a21;
a00=a00*a13;
a20=a20+a00;
a20=a20/a02;
a23=a23/a02;
a23=a23*a11;
a20=a20-a23;
a08=a08*a20;
a25=a25*a08;
a27=a27*a20;
a25=a25+a27;
a24=a24?a25:0;
a30=a30*a20;
a30=-a30;
a28=a28?a30:0;
a24=a24+a28;
a24=a32*a24;
a31=a31+a24;
a31=a31/a01;
a32=a32*a26;
a32=a32/a01;
a32=a32/a01;
a32=a32*a35;
a31=a31-a32;
a32=arg[10]? arg[10][0] : 0;
a01=a01*a32;
a32=arg[1]? arg[1][0] : 0;
a32=a32*a35;
a01=a01+a32;
a31=a31-a01;
if (res[0]!=0) res[0][0]=a31;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_B3_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f69(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_B3_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_B3_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_B3_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_B3_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_B3_follows_n_in(void) { return 17;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_B3_follows_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_B3_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_B3_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz";
case 1: return "C3";
case 2: return "d_tire";
case 3: return "w_tire";
case 4: return "p_tire";
case 5: return "p_rated";
case 6: return "C_z";
case 7: return "C_N";
case 8: return "out_B3";
case 9: return "fwd_Fz";
case 10: return "fwd_C3";
case 11: return "fwd_d_tire";
case 12: return "fwd_w_tire";
case 13: return "fwd_p_tire";
case 14: return "fwd_p_rated";
case 15: return "fwd_C_z";
case 16: return "fwd_C_N";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_B3_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_B3";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_B3_follows_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_B3_follows_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_B3_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 17;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_B3_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 17*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_B3_follows:(Fz,C3,d_tire,w_tire,p_tire,p_rated,C_z,C_N,out_B3[1x1,0nz],adj_B3)->(adj_Fz,adj_C3,adj_d_tire,adj_w_tire,adj_p_tire,adj_p_rated,adj_C_z,adj_C_N) */
static int casadi_f70(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38;
a00=arg[0]? arg[0][0] : 0;
a01=arg[2]? arg[2][0] : 0;
a02=sqrt(a01);
a03=arg[3]? arg[3][0] : 0;
a04=sqrt(a03);
a05=a02*a04;
a06=a05*a03;
a07=8.0000000000000002e-02;
a08=arg[5]? arg[5][0] : 0;
a09=a07*a08;
a10=arg[4]? arg[4][0] : 0;
a09=a09+a10;
a11=a06*a09;
a12=a00/a11;
a13=5.5999999999999996e+00;
a14=arg[6]? arg[6][0] : 0;
a13=a13*a14;
a13=a12<=a13;
a15=!a13;
a16=4.1666666666666669e-01;
a17=2.3148148148148149e+00;
a18=9.2159999999999997e-01;
a19=8.6399999999999999e-01;
a20=a19*a12;
a20=a20/a14;
a18=a18+a20;
a18=sqrt(a18);
a21=a17*a18;
a22=2.2222222222222223e+00;
a21=a21-a22;
a22=a14*a21;
a22=a13?a22:0;
a23=a16*a12;
a23=a14+a23;
a23=a15?a23:0;
a22=a22+a23;
a23=a03*a22;
a23=a23/a01;
a24=8.7499999999999994e-02;
a24=a23<=a24;
a25=!a24;
a26=3.4000000000000002e-01;
a27=arg[7]? arg[7][0] : 0;
a28=casadi_sq(a03);
a29=a27*a28;
a30=4.4000000000000000e-01;
a08=a30*a08;
a08=a08+a10;
a10=a29*a08;
a31=arg[9]? arg[9][0] : 0;
a32=a31/a00;
a33=a10*a32;
a34=a26*a33;
a34=-a34;
a34=a25?a34:0;
a35=1.2000000000000000e+00;
a36=a35*a33;
a36=a24?a36:0;
a34=a34+a36;
a36=2.*a23;
a37=-8.8000000000000007e+00;
a33=a37*a33;
a36=a36*a33;
a36=a24?a36:0;
a34=a34+a36;
a36=a34/a01;
a33=a03*a36;
a16=a16*a33;
a16=a15?a16:0;
a38=a14*a33;
a17=a17*a38;
a18=2.*a18;
a17=a17/a18;
a18=a17/a14;
a19=a19*a18;
a19=a13?a19:0;
a16=a16+a19;
a19=a16/a11;
a18=arg[1]? arg[1][0] : 0;
a18=a18*a31;
a38=casadi_sq(a23);
a37=a37*a38;
a35=a35*a23;
a37=a37+a35;
a24=a24?a37:0;
a37=6.7375000000000004e-02;
a26=a26*a23;
a37=a37-a26;
a25=a25?a37:0;
a24=a24+a25;
a10=a10*a24;
a10=a10/a00;
a10=a10/a00;
a10=a10*a31;
a18=a18+a10;
a19=a19-a18;
if (res[0]!=0) res[0][0]=a19;
a00=a00*a31;
a00=-a00;
if (res[1]!=0) res[1][0]=a00;
a23=a23/a01;
a23=a23*a34;
a12=a12/a11;
a12=a12*a16;
a09=a09*a12;
a16=a03*a09;
a11=a04*a16;
a34=2.*a02;
a11=a11/a34;
a23=a23+a11;
a23=-a23;
if (res[2]!=0) res[2][0]=a23;
a22=a22*a36;
a05=a05*a09;
a22=a22-a05;
a02=a02*a16;
a04=2.*a04;
a02=a02/a04;
a22=a22-a02;
a03=2.*a03;
a24=a24*a32;
a08=a08*a24;
a27=a27*a08;
a03=a03*a27;
a22=a22+a03;
if (res[3]!=0) res[3][0]=a22;
a29=a29*a24;
a06=a06*a12;
a12=a29-a06;
if (res[4]!=0) res[4][0]=a12;
a30=a30*a29;
a07=a07*a06;
a30=a30-a07;
if (res[5]!=0) res[5][0]=a30;
a15=a15?a33:0;
a21=a21*a33;
a21=a13?a21:0;
a15=a15+a21;
a20=a20/a14;
a20=a20*a17;
a20=-a20;
a13=a13?a20:0;
a15=a15+a13;
if (res[6]!=0) res[6][0]=a15;
a28=a28*a08;
if (res[7]!=0) res[7][0]=a28;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_B3_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f70(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_B3_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_B3_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_B3_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_B3_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_B3_follows_n_in(void) { return 10;}
CASADI_SYMBOL_EXPORT casadi_int adj1_B3_follows_n_out(void) { return 8;}
CASADI_SYMBOL_EXPORT casadi_real adj1_B3_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_B3_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz";
case 1: return "C3";
case 2: return "d_tire";
case 3: return "w_tire";
case 4: return "p_tire";
case 5: return "p_rated";
case 6: return "C_z";
case 7: return "C_N";
case 8: return "out_B3";
case 9: return "adj_B3";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_B3_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_Fz";
case 1: return "adj_C3";
case 2: return "adj_d_tire";
case 3: return "adj_w_tire";
case 4: return "adj_p_tire";
case 5: return "adj_p_rated";
case 6: return "adj_C_z";
case 7: return "adj_C_N";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_B3_follows_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* adj1_B3_follows_sparsity_out(casadi_int i) {
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
CASADI_SYMBOL_EXPORT int adj1_B3_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 10;
if (sz_res) *sz_res = 8;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_B3_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
if (sz_res) *sz_res = 8*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_B3_follows:(Fz,C3,d_tire,w_tire,p_tire,p_rated,C_z,C_N,out_B3[1x1,0nz],adj_B3,out_adj_Fz[1x1,0nz],out_adj_C3[1x1,0nz],out_adj_d_tire[1x1,0nz],out_adj_w_tire[1x1,0nz],out_adj_p_tire[1x1,0nz],out_adj_p_rated[1x1,0nz],out_adj_C_z[1x1,0nz],out_adj_C_N[1x1,0nz],fwd_Fz,fwd_C3,fwd_d_tire,fwd_w_tire,fwd_p_tire,fwd_p_rated,fwd_C_z,fwd_C_N,fwd_out_B3[1x1,0nz],fwd_adj_B3)->(fwd_adj_Fz,fwd_adj_C3,fwd_adj_d_tire,fwd_adj_w_tire,fwd_adj_p_tire,fwd_adj_p_rated,fwd_adj_C_z,fwd_adj_C_N) */
static int casadi_f71(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
casadi_real a60, a61, a62, a63, a64, a65, a66, a67;
a00=arg[0]? arg[0][0] : 0;
a01=arg[2]? arg[2][0] : 0;
a02=sqrt(a01);
a03=arg[3]? arg[3][0] : 0;
a04=sqrt(a03);
a05=a02*a04;
a06=a05*a03;
a07=8.0000000000000002e-02;
a08=arg[5]? arg[5][0] : 0;
a09=a07*a08;
a10=arg[4]? arg[4][0] : 0;
a09=a09+a10;
a11=a06*a09;
a12=a00/a11;
a13=5.5999999999999996e+00;
a14=arg[6]? arg[6][0] : 0;
a13=a13*a14;
a13=a12<=a13;
a15=!a13;
a16=4.1666666666666669e-01;
a17=2.3148148148148149e+00;
a18=9.2159999999999997e-01;
a19=8.6399999999999999e-01;
a20=a19*a12;
a20=a20/a14;
a18=a18+a20;
a18=sqrt(a18);
a21=a17*a18;
a22=2.2222222222222223e+00;
a21=a21-a22;
a22=a14*a21;
a22=a13?a22:0;
a23=a16*a12;
a23=a14+a23;
a23=a15?a23:0;
a22=a22+a23;
a23=a03*a22;
a23=a23/a01;
a24=8.7499999999999994e-02;
a24=a23<=a24;
a25=!a24;
a26=3.4000000000000002e-01;
a27=arg[7]? arg[7][0] : 0;
a28=casadi_sq(a03);
a29=a27*a28;
a30=4.4000000000000000e-01;
a08=a30*a08;
a08=a08+a10;
a10=a29*a08;
a31=arg[9]? arg[9][0] : 0;
a32=a31/a00;
a33=a10*a32;
a34=a26*a33;
a34=-a34;
a34=a25?a34:0;
a35=1.2000000000000000e+00;
a36=a35*a33;
a36=a24?a36:0;
a34=a34+a36;
a36=2.*a23;
a37=-8.8000000000000007e+00;
a33=a37*a33;
a38=a36*a33;
a38=a24?a38:0;
a34=a34+a38;
a38=a34/a01;
a39=arg[21]? arg[21][0] : 0;
a40=a38*a39;
a41=arg[25]? arg[25][0] : 0;
a42=a28*a41;
a43=2.*a03;
a43=a43*a39;
a44=a27*a43;
a42=a42+a44;
a44=a08*a42;
a45=arg[23]? arg[23][0] : 0;
a46=a30*a45;
a47=arg[22]? arg[22][0] : 0;
a46=a46+a47;
a48=a29*a46;
a44=a44+a48;
a48=a32*a44;
a49=arg[27]? arg[27][0] : 0;
a50=a49/a00;
a51=a32/a00;
a52=arg[18]? arg[18][0] : 0;
a51=a51*a52;
a50=a50-a51;
a51=a10*a50;
a48=a48+a51;
a51=a26*a48;
a51=-a51;
a51=a25?a51:0;
a53=a35*a48;
a53=a24?a53:0;
a51=a51+a53;
a53=a22*a39;
a54=arg[24]? arg[24][0] : 0;
a55=a21*a54;
a56=a52/a11;
a57=a12/a11;
a58=arg[20]? arg[20][0] : 0;
a59=2.*a02;
a59=a58/a59;
a60=a04*a59;
a61=2.*a04;
a61=a39/a61;
a62=a02*a61;
a60=a60+a62;
a62=a03*a60;
a63=a05*a39;
a62=a62+a63;
a63=a09*a62;
a45=a07*a45;
a45=a45+a47;
a47=a06*a45;
a63=a63+a47;
a57=a57*a63;
a56=a56-a57;
a57=a19*a56;
a57=a57/a14;
a47=a20/a14;
a47=a47*a54;
a57=a57-a47;
a47=2.*a18;
a47=a57/a47;
a64=a17*a47;
a65=a14*a64;
a55=a55+a65;
a55=a13?a55:0;
a65=a16*a56;
a65=a54+a65;
a65=a15?a65:0;
a55=a55+a65;
a65=a03*a55;
a53=a53+a65;
a53=a53/a01;
a65=a23/a01;
a65=a65*a58;
a53=a53-a65;
a65=2.*a53;
a33=a33*a65;
a48=a37*a48;
a36=a36*a48;
a33=a33+a36;
a33=a24?a33:0;
a51=a51+a33;
a33=a51/a01;
a36=a38/a01;
a36=a36*a58;
a33=a33-a36;
a36=a03*a33;
a40=a40+a36;
a36=a16*a40;
a36=a15?a36:0;
a48=a03*a38;
a65=a48*a54;
a66=a14*a40;
a65=a65+a66;
a65=a17*a65;
a18=2.*a18;
a65=a65/a18;
a66=a14*a48;
a17=a17*a66;
a17=a17/a18;
a18=a17/a18;
a47=2.*a47;
a18=a18*a47;
a65=a65-a18;
a18=a65/a14;
a47=a17/a14;
a66=a47/a14;
a66=a66*a54;
a18=a18-a66;
a18=a19*a18;
a18=a13?a18:0;
a36=a36+a18;
a18=a36/a11;
a16=a16*a48;
a16=a15?a16:0;
a19=a19*a47;
a19=a13?a19:0;
a16=a16+a19;
a19=a16/a11;
a19=a19/a11;
a19=a19*a63;
a18=a18-a19;
a19=arg[19]? arg[19][0] : 0;
a19=a31*a19;
a47=arg[1]? arg[1][0] : 0;
a47=a47*a49;
a19=a19+a47;
a47=casadi_sq(a23);
a47=a37*a47;
a66=a35*a23;
a47=a47+a66;
a47=a24?a47:0;
a66=6.7375000000000004e-02;
a67=a26*a23;
a66=a66-a67;
a66=a25?a66:0;
a47=a47+a66;
a44=a47*a44;
a66=2.*a23;
a66=a66*a53;
a37=a37*a66;
a35=a35*a53;
a37=a37+a35;
a24=a24?a37:0;
a26=a26*a53;
a26=-a26;
a25=a25?a26:0;
a24=a24+a25;
a25=a10*a24;
a44=a44+a25;
a44=a44/a00;
a10=a10*a47;
a10=a10/a00;
a25=a10/a00;
a25=a25*a52;
a44=a44-a25;
a44=a44/a00;
a10=a10/a00;
a25=a10/a00;
a25=a25*a52;
a44=a44-a25;
a44=a31*a44;
a10=a10*a49;
a44=a44+a10;
a19=a19+a44;
a18=a18-a19;
if (res[0]!=0) res[0][0]=a18;
a31=a31*a52;
a00=a00*a49;
a31=a31+a00;
a31=-a31;
if (res[1]!=0) res[1][0]=a31;
a53=a53/a01;
a23=a23/a01;
a01=a23/a01;
a01=a01*a58;
a53=a53-a01;
a34=a34*a53;
a23=a23*a51;
a34=a34+a23;
a12=a12/a11;
a23=a12*a16;
a51=a09*a23;
a53=a03*a51;
a01=a53*a61;
a58=a51*a39;
a45=a23*a45;
a56=a56/a11;
a11=a12/a11;
a11=a11*a63;
a56=a56-a11;
a16=a16*a56;
a12=a12*a36;
a16=a16+a12;
a09=a09*a16;
a45=a45+a09;
a09=a03*a45;
a58=a58+a09;
a09=a04*a58;
a01=a01+a09;
a09=2.*a02;
a01=a01/a09;
a12=a04*a53;
a12=a12/a09;
a12=a12/a09;
a09=2.*a59;
a12=a12*a09;
a01=a01-a12;
a34=a34+a01;
a34=-a34;
if (res[2]!=0) res[2][0]=a34;
a38=a38*a55;
a22=a22*a33;
a38=a38+a22;
a51=a51*a60;
a05=a05*a45;
a51=a51+a05;
a38=a38-a51;
a59=a53*a59;
a58=a02*a58;
a59=a59+a58;
a04=2.*a04;
a59=a59/a04;
a02=a02*a53;
a02=a02/a04;
a02=a02/a04;
a61=2.*a61;
a02=a02*a61;
a59=a59-a02;
a38=a38-a59;
a59=a47*a32;
a02=a08*a59;
a61=a27*a02;
a39=2.*a39;
a61=a61*a39;
a03=2.*a03;
a41=a02*a41;
a46=a59*a46;
a32=a32*a24;
a47=a47*a50;
a32=a32+a47;
a08=a08*a32;
a46=a46+a08;
a27=a27*a46;
a41=a41+a27;
a03=a03*a41;
a61=a61+a03;
a38=a38+a61;
if (res[3]!=0) res[3][0]=a38;
a59=a59*a42;
a29=a29*a32;
a59=a59+a29;
a23=a23*a62;
a06=a06*a16;
a23=a23+a06;
a06=a59-a23;
if (res[4]!=0) res[4][0]=a06;
a30=a30*a59;
a07=a07*a23;
a30=a30-a07;
if (res[5]!=0) res[5][0]=a30;
a15=a15?a40:0;
a48=a48*a64;
a21=a21*a40;
a48=a48+a21;
a48=a13?a48:0;
a15=a15+a48;
a57=a57/a14;
a20=a20/a14;
a14=a20/a14;
a14=a14*a54;
a57=a57-a14;
a17=a17*a57;
a20=a20*a65;
a17=a17+a20;
a17=-a17;
a13=a13?a17:0;
a15=a15+a13;
if (res[6]!=0) res[6][0]=a15;
a02=a02*a43;
a28=a28*a46;
a02=a02+a28;
if (res[7]!=0) res[7][0]=a02;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_B3_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f71(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_B3_follows_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_B3_follows_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_B3_follows_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_B3_follows_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_B3_follows_n_in(void) { return 28;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_B3_follows_n_out(void) { return 8;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_B3_follows_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_B3_follows_name_in(casadi_int i) {
switch (i) {
case 0: return "Fz";
case 1: return "C3";
case 2: return "d_tire";
case 3: return "w_tire";
case 4: return "p_tire";
case 5: return "p_rated";
case 6: return "C_z";
case 7: return "C_N";
case 8: return "out_B3";
case 9: return "adj_B3";
case 10: return "out_adj_Fz";
case 11: return "out_adj_C3";
case 12: return "out_adj_d_tire";
case 13: return "out_adj_w_tire";
case 14: return "out_adj_p_tire";
case 15: return "out_adj_p_rated";
case 16: return "out_adj_C_z";
case 17: return "out_adj_C_N";
case 18: return "fwd_Fz";
case 19: return "fwd_C3";
case 20: return "fwd_d_tire";
case 21: return "fwd_w_tire";
case 22: return "fwd_p_tire";
case 23: return "fwd_p_rated";
case 24: return "fwd_C_z";
case 25: return "fwd_C_N";
case 26: return "fwd_out_B3";
case 27: return "fwd_adj_B3";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_B3_follows_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_Fz";
case 1: return "fwd_adj_C3";
case 2: return "fwd_adj_d_tire";
case 3: return "fwd_adj_w_tire";
case 4: return "fwd_adj_p_tire";
case 5: return "fwd_adj_p_rated";
case 6: return "fwd_adj_C_z";
case 7: return "fwd_adj_C_N";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_B3_follows_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_B3_follows_sparsity_out(casadi_int i) {
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
CASADI_SYMBOL_EXPORT int fwd1_adj1_B3_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 28;
if (sz_res) *sz_res = 8;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_B3_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 28*sizeof(const casadi_real*);
if (sz_res) *sz_res = 8*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* Ct_follows_from_size:(F_tail_load,C_z,C_N,d_tail,w_tail,p_tail)->(Ct) */
static int casadi_f72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a0, a1, a2, a3, a4, a5, a6, a7, a8;
a0=1.4399999999999999e+00;
a1=arg[2]? arg[2][0] : 0;
a0=a0*a1;
a1=arg[5]? arg[5][0] : 0;
a0=a0*a1;
a2=arg[4]? arg[4][0] : 0;
a3=casadi_sq(a2);
a0=a0*a3;
a3=arg[0]? arg[0][0] : 0;
a4=1.0800000000000001e+00;
a5=arg[3]? arg[3][0] : 0;
a6=sqrt(a5);
a7=sqrt(a2);
a6=a6*a7;
a4=a4*a6;
a4=a4*a1;
a4=a4*a2;
a3=a3/a4;
a4=5.5999999999999996e+00;
a1=arg[1]? arg[1][0] : 0;
a4=a4*a1;
a4=a3<=a4;
a6=2.3148148148148149e+00;
a7=9.2159999999999997e-01;
a8=8.6399999999999999e-01;
a8=a8*a3;
a8=a8/a1;
a7=a7+a8;
a7=sqrt(a7);
a6=a6*a7;
a7=2.2222222222222223e+00;
a6=a6-a7;
a6=a1*a6;
a6=a4?a6:0;
a4=!a4;
a7=4.1666666666666669e-01;
a7=a7*a3;
a1=a1+a7;
a4=a4?a1:0;
a6=a6+a4;
a2=a2*a6;
a2=a2/a5;
a5=8.7499999999999994e-02;
a5=a2<=a5;
a6=-8.8000000000000007e+00;
a4=casadi_sq(a2);
a6=a6*a4;
a4=1.2000000000000000e+00;
a4=a4*a2;
a6=a6+a4;
a6=a5?a6:0;
a5=!a5;
a4=6.7375000000000004e-02;
a1=3.4000000000000002e-01;
a1=a1*a2;
a4=a4-a1;
a5=a5?a4:0;
a6=a6+a5;
a0=a0*a6;
if (res[0]!=0) res[0][0]=a0;
return 0;
}
CASADI_SYMBOL_EXPORT int Ct_follows_from_size(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f72(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int Ct_follows_from_size_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void Ct_follows_from_size_release(int mem) {
}
CASADI_SYMBOL_EXPORT void Ct_follows_from_size_incref(void) {
}
CASADI_SYMBOL_EXPORT void Ct_follows_from_size_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int Ct_follows_from_size_n_in(void) { return 6;}
CASADI_SYMBOL_EXPORT casadi_int Ct_follows_from_size_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real Ct_follows_from_size_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* Ct_follows_from_size_name_in(casadi_int i) {
switch (i) {
case 0: return "F_tail_load";
case 1: return "C_z";
case 2: return "C_N";
case 3: return "d_tail";
case 4: return "w_tail";
case 5: return "p_tail";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* Ct_follows_from_size_name_out(casadi_int i) {
switch (i) {
case 0: return "Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* Ct_follows_from_size_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* Ct_follows_from_size_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int Ct_follows_from_size_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 6;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int Ct_follows_from_size_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 6*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_Ct_follows_from_size:(F_tail_load,C_z,C_N,d_tail,w_tail,p_tail,out_Ct[1x1,0nz],fwd_F_tail_load,fwd_C_z,fwd_C_N,fwd_d_tail,fwd_w_tail,fwd_p_tail)->(fwd_Ct) */
static int casadi_f73(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33;
a00=arg[4]? arg[4][0] : 0;
a01=arg[0]? arg[0][0] : 0;
a02=1.0800000000000001e+00;
a03=arg[3]? arg[3][0] : 0;
a04=sqrt(a03);
a05=sqrt(a00);
a06=a04*a05;
a06=a02*a06;
a07=arg[5]? arg[5][0] : 0;
a08=a06*a07;
a09=a08*a00;
a01=a01/a09;
a10=5.5999999999999996e+00;
a11=arg[1]? arg[1][0] : 0;
a10=a10*a11;
a10=a01<=a10;
a12=2.3148148148148149e+00;
a13=9.2159999999999997e-01;
a14=8.6399999999999999e-01;
a15=a14*a01;
a15=a15/a11;
a13=a13+a15;
a13=sqrt(a13);
a16=a12*a13;
a17=2.2222222222222223e+00;
a16=a16-a17;
a17=a11*a16;
a17=a10?a17:0;
a18=!a10;
a19=4.1666666666666669e-01;
a20=a19*a01;
a20=a11+a20;
a20=a18?a20:0;
a17=a17+a20;
a20=a00*a17;
a20=a20/a03;
a21=8.7499999999999994e-02;
a21=a20<=a21;
a22=-8.8000000000000007e+00;
a23=casadi_sq(a20);
a23=a22*a23;
a24=1.2000000000000000e+00;
a25=a24*a20;
a23=a23+a25;
a23=a21?a23:0;
a25=!a21;
a26=6.7375000000000004e-02;
a27=3.4000000000000002e-01;
a28=a27*a20;
a26=a26-a28;
a26=a25?a26:0;
a23=a23+a26;
a26=casadi_sq(a00);
a28=1.4399999999999999e+00;
a29=arg[9]? arg[9][0] : 0;
a29=a28*a29;
a29=a07*a29;
a30=arg[2]? arg[2][0] : 0;
a28=a28*a30;
a30=arg[12]? arg[12][0] : 0;
a31=a28*a30;
a29=a29+a31;
a29=a26*a29;
a28=a28*a07;
a31=2.*a00;
a32=arg[11]? arg[11][0] : 0;
a31=a31*a32;
a31=a28*a31;
a29=a29+a31;
a23=a23*a29;
a28=a28*a26;
a26=2.*a20;
a17=a17*a32;
a29=arg[8]? arg[8][0] : 0;
a16=a16*a29;
a31=arg[7]? arg[7][0] : 0;
a31=a31/a09;
a01=a01/a09;
a09=arg[10]? arg[10][0] : 0;
a33=2.*a04;
a33=a09/a33;
a33=a05*a33;
a05=2.*a05;
a05=a32/a05;
a04=a04*a05;
a33=a33+a04;
a02=a02*a33;
a07=a07*a02;
a06=a06*a30;
a07=a07+a06;
a07=a00*a07;
a08=a08*a32;
a07=a07+a08;
a01=a01*a07;
a31=a31-a01;
a14=a14*a31;
a14=a14/a11;
a15=a15/a11;
a15=a15*a29;
a14=a14-a15;
a13=2.*a13;
a14=a14/a13;
a12=a12*a14;
a11=a11*a12;
a16=a16+a11;
a10=a10?a16:0;
a19=a19*a31;
a29=a29+a19;
a18=a18?a29:0;
a10=a10+a18;
a00=a00*a10;
a17=a17+a00;
a17=a17/a03;
a20=a20/a03;
a20=a20*a09;
a17=a17-a20;
a26=a26*a17;
a22=a22*a26;
a24=a24*a17;
a22=a22+a24;
a21=a21?a22:0;
a27=a27*a17;
a27=-a27;
a25=a25?a27:0;
a21=a21+a25;
a28=a28*a21;
a23=a23+a28;
if (res[0]!=0) res[0][0]=a23;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_Ct_follows_from_size(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f73(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_Ct_follows_from_size_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_Ct_follows_from_size_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_Ct_follows_from_size_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_Ct_follows_from_size_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_Ct_follows_from_size_n_in(void) { return 13;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_Ct_follows_from_size_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_Ct_follows_from_size_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_Ct_follows_from_size_name_in(casadi_int i) {
switch (i) {
case 0: return "F_tail_load";
case 1: return "C_z";
case 2: return "C_N";
case 3: return "d_tail";
case 4: return "w_tail";
case 5: return "p_tail";
case 6: return "out_Ct";
case 7: return "fwd_F_tail_load";
case 8: return "fwd_C_z";
case 9: return "fwd_C_N";
case 10: return "fwd_d_tail";
case 11: return "fwd_w_tail";
case 12: return "fwd_p_tail";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_Ct_follows_from_size_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_Ct_follows_from_size_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_Ct_follows_from_size_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s0;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_Ct_follows_from_size_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 13;
if (sz_res) *sz_res = 1;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_Ct_follows_from_size_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 13*sizeof(const casadi_real*);
if (sz_res) *sz_res = 1*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* adj1_Ct_follows_from_size:(F_tail_load,C_z,C_N,d_tail,w_tail,p_tail,out_Ct[1x1,0nz],adj_Ct)->(adj_F_tail_load,adj_C_z,adj_C_N,adj_d_tail,adj_w_tail,adj_p_tail) */
static int casadi_f74(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34;
a00=arg[0]? arg[0][0] : 0;
a01=1.0800000000000001e+00;
a02=arg[3]? arg[3][0] : 0;
a03=sqrt(a02);
a04=arg[4]? arg[4][0] : 0;
a05=sqrt(a04);
a06=a03*a05;
a06=a01*a06;
a07=arg[5]? arg[5][0] : 0;
a08=a06*a07;
a09=a08*a04;
a00=a00/a09;
a10=5.5999999999999996e+00;
a11=arg[1]? arg[1][0] : 0;
a10=a10*a11;
a10=a00<=a10;
a12=!a10;
a13=4.1666666666666669e-01;
a14=2.3148148148148149e+00;
a15=9.2159999999999997e-01;
a16=8.6399999999999999e-01;
a17=a16*a00;
a17=a17/a11;
a15=a15+a17;
a15=sqrt(a15);
a18=a14*a15;
a19=2.2222222222222223e+00;
a18=a18-a19;
a19=a11*a18;
a19=a10?a19:0;
a20=a13*a00;
a20=a11+a20;
a20=a12?a20:0;
a19=a19+a20;
a20=a04*a19;
a20=a20/a02;
a21=8.7499999999999994e-02;
a21=a20<=a21;
a22=!a21;
a23=3.4000000000000002e-01;
a24=1.4399999999999999e+00;
a25=arg[2]? arg[2][0] : 0;
a25=a24*a25;
a26=a25*a07;
a27=casadi_sq(a04);
a28=a26*a27;
a29=arg[7]? arg[7][0] : 0;
a28=a28*a29;
a30=a23*a28;
a30=-a30;
a30=a22?a30:0;
a31=1.2000000000000000e+00;
a32=a31*a28;
a32=a21?a32:0;
a30=a30+a32;
a32=2.*a20;
a33=-8.8000000000000007e+00;
a28=a33*a28;
a32=a32*a28;
a32=a21?a32:0;
a30=a30+a32;
a32=a30/a02;
a28=a04*a32;
a13=a13*a28;
a13=a12?a13:0;
a34=a11*a28;
a14=a14*a34;
a15=2.*a15;
a14=a14/a15;
a15=a14/a11;
a16=a16*a15;
a16=a10?a16:0;
a13=a13+a16;
a16=a13/a09;
if (res[0]!=0) res[0][0]=a16;
a12=a12?a28:0;
a18=a18*a28;
a18=a10?a18:0;
a12=a12+a18;
a17=a17/a11;
a17=a17*a14;
a17=-a17;
a10=a10?a17:0;
a12=a12+a10;
if (res[1]!=0) res[1][0]=a12;
a12=casadi_sq(a20);
a33=a33*a12;
a31=a31*a20;
a33=a33+a31;
a21=a21?a33:0;
a33=6.7375000000000004e-02;
a23=a23*a20;
a33=a33-a23;
a22=a22?a33:0;
a21=a21+a22;
a21=a21*a29;
a27=a27*a21;
a29=a07*a27;
a24=a24*a29;
if (res[2]!=0) res[2][0]=a24;
a20=a20/a02;
a20=a20*a30;
a00=a00/a09;
a00=a00*a13;
a13=a04*a00;
a07=a07*a13;
a01=a01*a07;
a07=a05*a01;
a09=2.*a03;
a07=a07/a09;
a20=a20+a07;
a20=-a20;
if (res[3]!=0) res[3][0]=a20;
a19=a19*a32;
a08=a08*a00;
a19=a19-a08;
a03=a03*a01;
a05=2.*a05;
a03=a03/a05;
a19=a19-a03;
a04=2.*a04;
a26=a26*a21;
a04=a04*a26;
a19=a19+a04;
if (res[4]!=0) res[4][0]=a19;
a25=a25*a27;
a06=a06*a13;
a25=a25-a06;
if (res[5]!=0) res[5][0]=a25;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_Ct_follows_from_size(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f74(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_Ct_follows_from_size_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_Ct_follows_from_size_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_Ct_follows_from_size_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_Ct_follows_from_size_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_Ct_follows_from_size_n_in(void) { return 8;}
CASADI_SYMBOL_EXPORT casadi_int adj1_Ct_follows_from_size_n_out(void) { return 6;}
CASADI_SYMBOL_EXPORT casadi_real adj1_Ct_follows_from_size_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_Ct_follows_from_size_name_in(casadi_int i) {
switch (i) {
case 0: return "F_tail_load";
case 1: return "C_z";
case 2: return "C_N";
case 3: return "d_tail";
case 4: return "w_tail";
case 5: return "p_tail";
case 6: return "out_Ct";
case 7: return "adj_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_Ct_follows_from_size_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_F_tail_load";
case 1: return "adj_C_z";
case 2: return "adj_C_N";
case 3: return "adj_d_tail";
case 4: return "adj_w_tail";
case 5: return "adj_p_tail";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_Ct_follows_from_size_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* adj1_Ct_follows_from_size_sparsity_out(casadi_int i) {
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
CASADI_SYMBOL_EXPORT int adj1_Ct_follows_from_size_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 8;
if (sz_res) *sz_res = 6;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_Ct_follows_from_size_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 8*sizeof(const casadi_real*);
if (sz_res) *sz_res = 6*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
/* fwd1_adj1_Ct_follows_from_size:(F_tail_load,C_z,C_N,d_tail,w_tail,p_tail,out_Ct[1x1,0nz],adj_Ct,out_adj_F_tail_load[1x1,0nz],out_adj_C_z[1x1,0nz],out_adj_C_N[1x1,0nz],out_adj_d_tail[1x1,0nz],out_adj_w_tail[1x1,0nz],out_adj_p_tail[1x1,0nz],fwd_F_tail_load,fwd_C_z,fwd_C_N,fwd_d_tail,fwd_w_tail,fwd_p_tail,fwd_out_Ct[1x1,0nz],fwd_adj_Ct)->(fwd_adj_F_tail_load,fwd_adj_C_z,fwd_adj_C_N,fwd_adj_d_tail,fwd_adj_w_tail,fwd_adj_p_tail) */
static int casadi_f75(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58;
a00=arg[0]? arg[0][0] : 0;
a01=1.0800000000000001e+00;
a02=arg[3]? arg[3][0] : 0;
a03=sqrt(a02);
a04=arg[4]? arg[4][0] : 0;
a05=sqrt(a04);
a06=a03*a05;
a06=a01*a06;
a07=arg[5]? arg[5][0] : 0;
a08=a06*a07;
a09=a08*a04;
a00=a00/a09;
a10=5.5999999999999996e+00;
a11=arg[1]? arg[1][0] : 0;
a10=a10*a11;
a10=a00<=a10;
a12=!a10;
a13=4.1666666666666669e-01;
a14=2.3148148148148149e+00;
a15=9.2159999999999997e-01;
a16=8.6399999999999999e-01;
a17=a16*a00;
a17=a17/a11;
a15=a15+a17;
a15=sqrt(a15);
a18=a14*a15;
a19=2.2222222222222223e+00;
a18=a18-a19;
a19=a11*a18;
a19=a10?a19:0;
a20=a13*a00;
a20=a11+a20;
a20=a12?a20:0;
a19=a19+a20;
a20=a04*a19;
a20=a20/a02;
a21=8.7499999999999994e-02;
a21=a20<=a21;
a22=!a21;
a23=3.4000000000000002e-01;
a24=1.4399999999999999e+00;
a25=arg[2]? arg[2][0] : 0;
a25=a24*a25;
a26=a25*a07;
a27=casadi_sq(a04);
a28=a26*a27;
a29=arg[7]? arg[7][0] : 0;
a30=a28*a29;
a31=a23*a30;
a31=-a31;
a31=a22?a31:0;
a32=1.2000000000000000e+00;
a33=a32*a30;
a33=a21?a33:0;
a31=a31+a33;
a33=2.*a20;
a34=-8.8000000000000007e+00;
a30=a34*a30;
a35=a33*a30;
a35=a21?a35:0;
a31=a31+a35;
a35=a31/a02;
a36=arg[18]? arg[18][0] : 0;
a37=a35*a36;
a38=arg[16]? arg[16][0] : 0;
a38=a24*a38;
a39=a07*a38;
a40=arg[19]? arg[19][0] : 0;
a41=a25*a40;
a39=a39+a41;
a41=a27*a39;
a42=2.*a04;
a42=a42*a36;
a43=a26*a42;
a41=a41+a43;
a41=a29*a41;
a43=arg[21]? arg[21][0] : 0;
a28=a28*a43;
a41=a41+a28;
a28=a23*a41;
a28=-a28;
a28=a22?a28:0;
a44=a32*a41;
a44=a21?a44:0;
a28=a28+a44;
a44=a19*a36;
a45=arg[15]? arg[15][0] : 0;
a46=a18*a45;
a47=arg[14]? arg[14][0] : 0;
a47=a47/a09;
a48=a00/a09;
a49=arg[17]? arg[17][0] : 0;
a50=2.*a03;
a50=a49/a50;
a51=a05*a50;
a52=2.*a05;
a52=a36/a52;
a53=a03*a52;
a51=a51+a53;
a51=a01*a51;
a53=a07*a51;
a54=a06*a40;
a53=a53+a54;
a54=a04*a53;
a55=a08*a36;
a54=a54+a55;
a48=a48*a54;
a47=a47-a48;
a48=a16*a47;
a48=a48/a11;
a55=a17/a11;
a55=a55*a45;
a48=a48-a55;
a55=2.*a15;
a55=a48/a55;
a56=a14*a55;
a57=a11*a56;
a46=a46+a57;
a46=a10?a46:0;
a57=a13*a47;
a57=a45+a57;
a57=a12?a57:0;
a46=a46+a57;
a57=a04*a46;
a44=a44+a57;
a44=a44/a02;
a57=a20/a02;
a57=a57*a49;
a44=a44-a57;
a57=2.*a44;
a30=a30*a57;
a41=a34*a41;
a33=a33*a41;
a30=a30+a33;
a30=a21?a30:0;
a28=a28+a30;
a30=a28/a02;
a33=a35/a02;
a33=a33*a49;
a30=a30-a33;
a33=a04*a30;
a37=a37+a33;
a33=a13*a37;
a33=a12?a33:0;
a41=a04*a35;
a57=a41*a45;
a58=a11*a37;
a57=a57+a58;
a57=a14*a57;
a15=2.*a15;
a57=a57/a15;
a58=a11*a41;
a14=a14*a58;
a14=a14/a15;
a15=a14/a15;
a55=2.*a55;
a15=a15*a55;
a57=a57-a15;
a15=a57/a11;
a55=a14/a11;
a58=a55/a11;
a58=a58*a45;
a15=a15-a58;
a15=a16*a15;
a15=a10?a15:0;
a33=a33+a15;
a15=a33/a09;
a13=a13*a41;
a13=a12?a13:0;
a16=a16*a55;
a16=a10?a16:0;
a13=a13+a16;
a16=a13/a09;
a16=a16/a09;
a16=a16*a54;
a15=a15-a16;
if (res[0]!=0) res[0][0]=a15;
a12=a12?a37:0;
a41=a41*a56;
a18=a18*a37;
a41=a41+a18;
a41=a10?a41:0;
a12=a12+a41;
a48=a48/a11;
a17=a17/a11;
a11=a17/a11;
a11=a11*a45;
a48=a48-a11;
a14=a14*a48;
a17=a17*a57;
a14=a14+a17;
a14=-a14;
a10=a10?a14:0;
a12=a12+a10;
if (res[1]!=0) res[1][0]=a12;
a12=casadi_sq(a20);
a12=a34*a12;
a10=a32*a20;
a12=a12+a10;
a12=a21?a12:0;
a10=6.7375000000000004e-02;
a14=a23*a20;
a10=a10-a14;
a10=a22?a10:0;
a12=a12+a10;
a10=a12*a29;
a14=a27*a10;
a17=a14*a40;
a42=a10*a42;
a57=2.*a20;
a57=a57*a44;
a34=a34*a57;
a32=a32*a44;
a34=a34+a32;
a21=a21?a34:0;
a23=a23*a44;
a23=-a23;
a22=a22?a23:0;
a21=a21+a22;
a29=a29*a21;
a12=a12*a43;
a29=a29+a12;
a27=a27*a29;
a42=a42+a27;
a27=a07*a42;
a17=a17+a27;
a24=a24*a17;
if (res[2]!=0) res[2][0]=a24;
a44=a44/a02;
a20=a20/a02;
a02=a20/a02;
a02=a02*a49;
a44=a44-a02;
a31=a31*a44;
a20=a20*a28;
a31=a31+a20;
a00=a00/a09;
a20=a00*a13;
a28=a04*a20;
a44=a07*a28;
a44=a01*a44;
a02=a44*a52;
a40=a28*a40;
a49=a20*a36;
a47=a47/a09;
a09=a00/a09;
a09=a09*a54;
a47=a47-a09;
a13=a13*a47;
a00=a00*a33;
a13=a13+a00;
a00=a04*a13;
a49=a49+a00;
a07=a07*a49;
a40=a40+a07;
a01=a01*a40;
a40=a05*a01;
a02=a02+a40;
a40=2.*a03;
a02=a02/a40;
a07=a05*a44;
a07=a07/a40;
a07=a07/a40;
a40=2.*a50;
a07=a07*a40;
a02=a02-a07;
a31=a31+a02;
a31=-a31;
if (res[3]!=0) res[3][0]=a31;
a35=a35*a46;
a19=a19*a30;
a35=a35+a19;
a20=a20*a53;
a08=a08*a13;
a20=a20+a08;
a35=a35-a20;
a50=a44*a50;
a01=a03*a01;
a50=a50+a01;
a05=2.*a05;
a50=a50/a05;
a03=a03*a44;
a03=a03/a05;
a03=a03/a05;
a52=2.*a52;
a03=a03*a52;
a50=a50-a03;
a35=a35-a50;
a50=a26*a10;
a36=2.*a36;
a50=a50*a36;
a04=2.*a04;
a10=a10*a39;
a26=a26*a29;
a10=a10+a26;
a04=a04*a10;
a50=a50+a04;
a35=a35+a50;
if (res[4]!=0) res[4][0]=a35;
a14=a14*a38;
a25=a25*a42;
a14=a14+a25;
a28=a28*a51;
a06=a06*a49;
a28=a28+a06;
a14=a14-a28;
if (res[5]!=0) res[5][0]=a14;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_Ct_follows_from_size(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f75(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_Ct_follows_from_size_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_Ct_follows_from_size_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_Ct_follows_from_size_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_Ct_follows_from_size_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_Ct_follows_from_size_n_in(void) { return 22;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_Ct_follows_from_size_n_out(void) { return 6;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_Ct_follows_from_size_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_Ct_follows_from_size_name_in(casadi_int i) {
switch (i) {
case 0: return "F_tail_load";
case 1: return "C_z";
case 2: return "C_N";
case 3: return "d_tail";
case 4: return "w_tail";
case 5: return "p_tail";
case 6: return "out_Ct";
case 7: return "adj_Ct";
case 8: return "out_adj_F_tail_load";
case 9: return "out_adj_C_z";
case 10: return "out_adj_C_N";
case 11: return "out_adj_d_tail";
case 12: return "out_adj_w_tail";
case 13: return "out_adj_p_tail";
case 14: return "fwd_F_tail_load";
case 15: return "fwd_C_z";
case 16: return "fwd_C_N";
case 17: return "fwd_d_tail";
case 18: return "fwd_w_tail";
case 19: return "fwd_p_tail";
case 20: return "fwd_out_Ct";
case 21: return "fwd_adj_Ct";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_Ct_follows_from_size_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_F_tail_load";
case 1: return "fwd_adj_C_z";
case 2: return "fwd_adj_C_N";
case 3: return "fwd_adj_d_tail";
case 4: return "fwd_adj_w_tail";
case 5: return "fwd_adj_p_tail";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_Ct_follows_from_size_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_Ct_follows_from_size_sparsity_out(casadi_int i) {
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
CASADI_SYMBOL_EXPORT int fwd1_adj1_Ct_follows_from_size_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 22;
if (sz_res) *sz_res = 6;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 0;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_Ct_follows_from_size_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
if (sz_res) *sz_res = 6*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 0*sizeof(casadi_real);
return 0;
}
