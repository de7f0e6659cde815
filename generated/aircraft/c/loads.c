/* Generated from derive/ (digest 4e3da0958760807a) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`. */
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
  a0=(a0-a1);
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
  a0=(a0-a1);
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
  a0=(-a0);
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
  a0=(-a0);
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
  a0=(a0-a1);
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
  a0=(a0-a1);
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
  a1=(-a0);
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
  a1=(-a0);
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
  a0=(a0+a1);
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
  a0=(a0+a1);
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
  a0=(a0/a1);
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
  a0=(a0/a1);
  a2=arg[0]? arg[0][0] : 0;
  a2=(a2/a1);
  a2=(a2/a1);
  a1=arg[4]? arg[4][0] : 0;
  a2=(a2*a1);
  a0=(a0-a2);
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
  a2=(a0/a1);
  if (res[0]!=0) res[0][0]=a2;
  a2=arg[0]? arg[0][0] : 0;
  a2=(a2/a1);
  a2=(a2/a1);
  a2=(a2*a0);
  a2=(-a2);
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
  a2=(a0/a1);
  a3=arg[3]? arg[3][0] : 0;
  a4=(a3/a1);
  a4=(a4/a1);
  a5=arg[7]? arg[7][0] : 0;
  a4=(a4*a5);
  a2=(a2-a4);
  if (res[0]!=0) res[0][0]=a2;
  a2=arg[6]? arg[6][0] : 0;
  a2=(a2/a1);
  a4=arg[0]? arg[0][0] : 0;
  a4=(a4/a1);
  a6=(a4/a1);
  a6=(a6*a5);
  a2=(a2-a6);
  a2=(a2/a1);
  a4=(a4/a1);
  a1=(a4/a1);
  a1=(a1*a5);
  a2=(a2-a1);
  a3=(a3*a2);
  a4=(a4*a0);
  a3=(a3+a4);
  a3=(-a3);
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
  a0=(a0*a1);
  a1=arg[1]? arg[1][0] : 0;
  a0=(a0*a1);
  a1=arg[0]? arg[0][0] : 0;
  a0=(a0*a1);
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
  a3=(a2*a3);
  a3=(a1*a3);
  a4=arg[2]? arg[2][0] : 0;
  a2=(a2*a4);
  a4=arg[5]? arg[5][0] : 0;
  a4=(a2*a4);
  a3=(a3+a4);
  a0=(a0*a3);
  a2=(a2*a1);
  a1=arg[4]? arg[4][0] : 0;
  a2=(a2*a1);
  a0=(a0+a2);
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
  a1=(a0*a1);
  a2=arg[1]? arg[1][0] : 0;
  a3=(a1*a2);
  a4=arg[4]? arg[4][0] : 0;
  a3=(a3*a4);
  if (res[0]!=0) res[0][0]=a3;
  a3=arg[0]? arg[0][0] : 0;
  a3=(a3*a4);
  a1=(a1*a3);
  if (res[1]!=0) res[1][0]=a1;
  a2=(a2*a3);
  a0=(a0*a2);
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
  a3=(a2*a3);
  a4=(a1*a3);
  a5=arg[2]? arg[2][0] : 0;
  a5=(a2*a5);
  a6=arg[9]? arg[9][0] : 0;
  a7=(a5*a6);
  a4=(a4+a7);
  a4=(a0*a4);
  a7=(a5*a1);
  a8=arg[12]? arg[12][0] : 0;
  a7=(a7*a8);
  a4=(a4+a7);
  if (res[0]!=0) res[0][0]=a4;
  a4=arg[0]? arg[0][0] : 0;
  a7=(a4*a0);
  a3=(a7*a3);
  a9=arg[8]? arg[8][0] : 0;
  a0=(a0*a9);
  a4=(a4*a8);
  a0=(a0+a4);
  a5=(a5*a0);
  a3=(a3+a5);
  if (res[1]!=0) res[1][0]=a3;
  a7=(a7*a6);
  a1=(a1*a0);
  a7=(a7+a1);
  a2=(a2*a7);
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
  a0=(a0*a1);
  a1=1.;
  a2=arg[2]? arg[2][0] : 0;
  a1=(a1-a2);
  a0=(a0*a1);
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
  a0=(a0-a1);
  a1=arg[0]? arg[0][0] : 0;
  a2=arg[5]? arg[5][0] : 0;
  a2=(a1*a2);
  a3=arg[1]? arg[1][0] : 0;
  a4=arg[4]? arg[4][0] : 0;
  a4=(a3*a4);
  a2=(a2+a4);
  a0=(a0*a2);
  a3=(a3*a1);
  a1=arg[6]? arg[6][0] : 0;
  a3=(a3*a1);
  a0=(a0-a3);
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
  a1=(a1-a2);
  a2=arg[4]? arg[4][0] : 0;
  a1=(a1*a2);
  a3=(a0*a1);
  if (res[0]!=0) res[0][0]=a3;
  a3=arg[0]? arg[0][0] : 0;
  a1=(a3*a1);
  if (res[1]!=0) res[1][0]=a1;
  a0=(a0*a3);
  a0=(a0*a2);
  a0=(-a0);
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
  a0=(a0-a1);
  a1=arg[4]? arg[4][0] : 0;
  a2=(a0*a1);
  a3=arg[9]? arg[9][0] : 0;
  a4=(a2*a3);
  a5=arg[1]? arg[1][0] : 0;
  a6=arg[12]? arg[12][0] : 0;
  a0=(a0*a6);
  a7=arg[10]? arg[10][0] : 0;
  a7=(a1*a7);
  a0=(a0-a7);
  a7=(a5*a0);
  a4=(a4+a7);
  if (res[0]!=0) res[0][0]=a4;
  a4=arg[8]? arg[8][0] : 0;
  a2=(a2*a4);
  a7=arg[0]? arg[0][0] : 0;
  a0=(a7*a0);
  a2=(a2+a0);
  if (res[1]!=0) res[1][0]=a2;
  a3=(a7*a3);
  a4=(a5*a4);
  a3=(a3+a4);
  a1=(a1*a3);
  a5=(a5*a7);
  a5=(a5*a6);
  a1=(a1+a5);
  a1=(-a1);
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
  a1=(a1*a2);
  a0=(a0+a1);
  a0=(a0*a2);
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
  a2=(a0*a2);
  a3=arg[2]? arg[2][0] : 0;
  a4=arg[4]? arg[4][0] : 0;
  a5=(a3*a4);
  a2=(a2+a5);
  a1=(a1+a2);
  a1=(a0*a1);
  a2=arg[1]? arg[1][0] : 0;
  a3=(a3*a0);
  a2=(a2+a3);
  a2=(a2*a4);
  a1=(a1+a2);
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
  a3=(a1*a2);
  a0=(a0+a3);
  a3=arg[4]? arg[4][0] : 0;
  a0=(a0*a3);
  a3=(a2*a3);
  a1=(a1*a3);
  a0=(a0+a1);
  if (res[0]!=0) res[0][0]=a0;
  if (res[1]!=0) res[1][0]=a3;
  a2=(a2*a3);
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
  a4=(a2*a3);
  a5=arg[2]? arg[2][0] : 0;
  a6=arg[8]? arg[8][0] : 0;
  a7=(a5*a6);
  a4=(a4+a7);
  a1=(a1+a4);
  a1=(a0*a1);
  a4=arg[1]? arg[1][0] : 0;
  a7=(a5*a2);
  a4=(a4+a7);
  a7=arg[12]? arg[12][0] : 0;
  a4=(a4*a7);
  a1=(a1+a4);
  a4=(a2*a0);
  a3=(a4*a3);
  a0=(a0*a6);
  a7=(a2*a7);
  a0=(a0+a7);
  a5=(a5*a0);
  a3=(a3+a5);
  a1=(a1+a3);
  if (res[0]!=0) res[0][0]=a1;
  if (res[1]!=0) res[1][0]=a0;
  a4=(a4*a6);
  a2=(a2*a0);
  a4=(a4+a2);
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
  a1=(a1*a2);
  a2=casadi_sq(a0);
  a2=(a0*a2);
  a3=arg[3]? arg[3][0] : 0;
  a2=(a2*a3);
  a1=(a1+a2);
  a2=casadi_sq(a0);
  a3=arg[2]? arg[2][0] : 0;
  a2=(a2*a3);
  a1=(a1+a2);
  a2=arg[1]? arg[1][0] : 0;
  a0=(a0*a2);
  a1=(a1+a0);
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
  a3=(2.*a2);
  a4=(2.*a1);
  a5=arg[6]? arg[6][0] : 0;
  a4=(a4*a5);
  a3=(a3*a4);
  a0=(a0*a3);
  a2=casadi_sq(a2);
  a3=arg[10]? arg[10][0] : 0;
  a2=(a2*a3);
  a0=(a0+a2);
  a2=arg[3]? arg[3][0] : 0;
  a3=casadi_sq(a1);
  a4=(a3*a5);
  a6=(2.*a1);
  a6=(a6*a5);
  a6=(a1*a6);
  a4=(a4+a6);
  a2=(a2*a4);
  a3=(a1*a3);
  a4=arg[9]? arg[9][0] : 0;
  a3=(a3*a4);
  a2=(a2+a3);
  a0=(a0+a2);
  a2=arg[2]? arg[2][0] : 0;
  a3=(2.*a1);
  a3=(a3*a5);
  a2=(a2*a3);
  a3=casadi_sq(a1);
  a4=arg[8]? arg[8][0] : 0;
  a3=(a3*a4);
  a2=(a2+a3);
  a0=(a0+a2);
  a2=arg[1]? arg[1][0] : 0;
  a2=(a2*a5);
  a5=arg[7]? arg[7][0] : 0;
  a1=(a1*a5);
  a2=(a2+a1);
  a0=(a0+a2);
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
  a0=(a0*a1);
  a2=arg[0]? arg[0][0] : 0;
  a3=(2.*a2);
  a4=arg[2]? arg[2][0] : 0;
  a4=(a4*a1);
  a3=(a3*a4);
  a0=(a0+a3);
  a3=casadi_sq(a2);
  a4=arg[3]? arg[3][0] : 0;
  a4=(a4*a1);
  a5=(a3*a4);
  a0=(a0+a5);
  a5=(2.*a2);
  a4=(a2*a4);
  a5=(a5*a4);
  a0=(a0+a5);
  a5=(2.*a2);
  a4=casadi_sq(a2);
  a6=(2.*a4);
  a7=arg[4]? arg[4][0] : 0;
  a7=(a7*a1);
  a6=(a6*a7);
  a5=(a5*a6);
  a0=(a0+a5);
  if (res[0]!=0) res[0][0]=a0;
  a0=(a2*a1);
  if (res[1]!=0) res[1][0]=a0;
  a0=casadi_sq(a2);
  a0=(a0*a1);
  if (res[2]!=0) res[2][0]=a0;
  a2=(a2*a3);
  a2=(a2*a1);
  if (res[3]!=0) res[3][0]=a2;
  a4=casadi_sq(a4);
  a4=(a4*a1);
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
  a01=(a00*a01);
  a02=arg[1]? arg[1][0] : 0;
  a03=arg[18]? arg[18][0] : 0;
  a02=(a02*a03);
  a01=(a01+a02);
  a02=arg[2]? arg[2][0] : 0;
  a04=(a02*a00);
  a05=arg[12]? arg[12][0] : 0;
  a06=(2.*a05);
  a04=(a04*a06);
  a06=arg[0]? arg[0][0] : 0;
  a07=(2.*a06);
  a08=arg[14]? arg[14][0] : 0;
  a08=(a00*a08);
  a02=(a02*a03);
  a08=(a08+a02);
  a07=(a07*a08);
  a04=(a04+a07);
  a01=(a01+a04);
  a04=arg[3]? arg[3][0] : 0;
  a07=(a04*a00);
  a08=(2.*a06);
  a08=(a08*a05);
  a02=(a07*a08);
  a09=casadi_sq(a06);
  a10=arg[15]? arg[15][0] : 0;
  a10=(a00*a10);
  a04=(a04*a03);
  a10=(a10+a04);
  a04=(a09*a10);
  a02=(a02+a04);
  a01=(a01+a02);
  a02=(a06*a07);
  a04=(2.*a05);
  a02=(a02*a04);
  a04=(2.*a06);
  a07=(a07*a05);
  a10=(a06*a10);
  a07=(a07+a10);
  a04=(a04*a07);
  a02=(a02+a04);
  a01=(a01+a02);
  a02=casadi_sq(a06);
  a04=(2.*a02);
  a07=arg[4]? arg[4][0] : 0;
  a10=(a07*a00);
  a11=(a04*a10);
  a12=(2.*a05);
  a11=(a11*a12);
  a12=(2.*a06);
  a13=(2.*a06);
  a13=(a13*a05);
  a14=(2.*a13);
  a10=(a10*a14);
  a14=arg[16]? arg[16][0] : 0;
  a14=(a00*a14);
  a07=(a07*a03);
  a14=(a14+a07);
  a04=(a04*a14);
  a10=(a10+a04);
  a12=(a12*a10);
  a11=(a11+a12);
  a01=(a01+a11);
  if (res[0]!=0) res[0][0]=a01;
  a01=(a00*a05);
  a11=(a06*a03);
  a01=(a01+a11);
  if (res[1]!=0) res[1][0]=a01;
  a01=(2.*a06);
  a01=(a01*a05);
  a01=(a00*a01);
  a11=casadi_sq(a06);
  a11=(a11*a03);
  a01=(a01+a11);
  if (res[2]!=0) res[2][0]=a01;
  a05=(a09*a05);
  a08=(a06*a08);
  a05=(a05+a08);
  a05=(a00*a05);
  a06=(a06*a09);
  a06=(a06*a03);
  a05=(a05+a06);
  if (res[3]!=0) res[3][0]=a05;
  a05=(2.*a02);
  a05=(a05*a13);
  a00=(a00*a05);
  a02=casadi_sq(a02);
  a02=(a02*a03);
  a00=(a00+a02);
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
  a1=(a0<a1);
  a2=arg[2]? arg[2][0] : 0;
  a3=arg[1]? arg[1][0] : 0;
  a4=(a2-a3);
  a0=(a0-a3);
  a0=(a0+a2);
  a4=(a4/a0);
  a4=(a1?a4:0);
  a1=(!a1);
  a0=casadi_nan;
  a1=(a1?a0:0);
  a4=(a4+a1);
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
  a1=(a0<a1);
  a2=arg[6]? arg[6][0] : 0;
  a3=arg[5]? arg[5][0] : 0;
  a4=(a2-a3);
  a5=arg[1]? arg[1][0] : 0;
  a0=(a0-a5);
  a6=arg[2]? arg[2][0] : 0;
  a0=(a0+a6);
  a4=(a4/a0);
  a6=(a6-a5);
  a6=(a6/a0);
  a6=(a6/a0);
  a0=arg[4]? arg[4][0] : 0;
  a0=(a0-a3);
  a0=(a0+a2);
  a6=(a6*a0);
  a4=(a4-a6);
  a1=(a1?a4:0);
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
  a1=(a0<a1);
  a2=arg[2]? arg[2][0] : 0;
  a3=arg[1]? arg[1][0] : 0;
  a4=(a2-a3);
  a0=(a0-a3);
  a0=(a0+a2);
  a4=(a4/a0);
  a4=(a4/a0);
  a2=arg[4]? arg[4][0] : 0;
  a4=(a4*a2);
  a3=(-a4);
  a3=(a1?a3:0);
  if (res[0]!=0) res[0][0]=a3;
  a2=(a2/a0);
  a0=(a4-a2);
  a0=(a1?a0:0);
  if (res[1]!=0) res[1][0]=a0;
  a2=(a2-a4);
  a1=(a1?a2:0);
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
  a1=(a0<a1);
  a2=arg[4]? arg[4][0] : 0;
  a3=arg[10]? arg[10][0] : 0;
  a4=arg[9]? arg[9][0] : 0;
  a5=(a3-a4);
  a6=arg[1]? arg[1][0] : 0;
  a0=(a0-a6);
  a7=arg[2]? arg[2][0] : 0;
  a0=(a0+a7);
  a5=(a5/a0);
  a7=(a7-a6);
  a7=(a7/a0);
  a6=(a7/a0);
  a8=arg[8]? arg[8][0] : 0;
  a8=(a8-a4);
  a8=(a8+a3);
  a6=(a6*a8);
  a5=(a5-a6);
  a5=(a5/a0);
  a7=(a7/a0);
  a6=(a7/a0);
  a6=(a6*a8);
  a5=(a5-a6);
  a5=(a2*a5);
  a6=arg[12]? arg[12][0] : 0;
  a7=(a7*a6);
  a5=(a5+a7);
  a7=(-a5);
  a7=(a1?a7:0);
  if (res[0]!=0) res[0][0]=a7;
  a6=(a6/a0);
  a2=(a2/a0);
  a2=(a2/a0);
  a2=(a2*a8);
  a6=(a6-a2);
  a2=(a5-a6);
  a2=(a1?a2:0);
  if (res[1]!=0) res[1][0]=a2;
  a6=(a6-a5);
  a1=(a1?a6:0);
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
  a0=(a0<a1);
  a2=arg[2]? arg[2][0] : 0;
  a3=arg[0]? arg[0][0] : 0;
  a2=(a2*a3);
  a3=1.;
  a4=arg[3]? arg[3][0] : 0;
  a3=(a3-a4);
  a1=casadi_fmin(a1,a3);
  a2=(a2*a1);
  a2=(a0?a2:0);
  a0=(!a0);
  a1=casadi_nan;
  a0=(a0?a1:0);
  a2=(a2+a0);
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
  a0=(a0<a1);
  a2=1.;
  a3=arg[3]? arg[3][0] : 0;
  a2=(a2-a3);
  a3=casadi_fmin(a1,a2);
  a4=arg[0]? arg[0][0] : 0;
  a5=arg[7]? arg[7][0] : 0;
  a5=(a4*a5);
  a6=arg[2]? arg[2][0] : 0;
  a7=arg[5]? arg[5][0] : 0;
  a7=(a6*a7);
  a5=(a5+a7);
  a3=(a3*a5);
  a6=(a6*a4);
  a4=(a2<=a1);
  a1=(a1<=a2);
  a1=(a1+a4);
  a4=(a4/a1);
  a1=arg[8]? arg[8][0] : 0;
  a4=(a4*a1);
  a6=(a6*a4);
  a3=(a3-a6);
  a0=(a0?a3:0);
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
  a0=(a0<a1);
  a2=arg[2]? arg[2][0] : 0;
  a3=1.;
  a4=arg[3]? arg[3][0] : 0;
  a3=(a3-a4);
  a4=casadi_fmin(a1,a3);
  a5=arg[5]? arg[5][0] : 0;
  a4=(a4*a5);
  a6=(a2*a4);
  a6=(a0?a6:0);
  if (res[0]!=0) res[0][0]=a6;
  a6=arg[0]? arg[0][0] : 0;
  a4=(a6*a4);
  a4=(a0?a4:0);
  if (res[2]!=0) res[2][0]=a4;
  a4=(a3<=a1);
  a1=(a1<=a3);
  a1=(a1+a4);
  a4=(a4/a1);
  a2=(a2*a6);
  a2=(a2*a5);
  a4=(a4*a2);
  a4=(-a4);
  a0=(a0?a4:0);
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
  a00=(a00<a01);
  a02=1.;
  a03=arg[3]? arg[3][0] : 0;
  a02=(a02-a03);
  a03=casadi_fmin(a01,a02);
  a04=arg[5]? arg[5][0] : 0;
  a05=(a03*a04);
  a06=arg[12]? arg[12][0] : 0;
  a07=(a05*a06);
  a08=arg[2]? arg[2][0] : 0;
  a09=arg[15]? arg[15][0] : 0;
  a03=(a03*a09);
  a10=(a02<=a01);
  a11=(a01<=a02);
  a11=(a11+a10);
  a10=(a10/a11);
  a11=arg[13]? arg[13][0] : 0;
  a10=(a10*a11);
  a10=(a04*a10);
  a03=(a03-a10);
  a10=(a08*a03);
  a07=(a07+a10);
  a07=(a00?a07:0);
  if (res[0]!=0) res[0][0]=a07;
  a07=arg[10]? arg[10][0] : 0;
  a05=(a05*a07);
  a10=arg[0]? arg[0][0] : 0;
  a03=(a10*a03);
  a05=(a05+a03);
  a05=(a00?a05:0);
  if (res[2]!=0) res[2][0]=a05;
  a05=(a02<=a01);
  a01=(a01<=a02);
  a01=(a01+a05);
  a05=(a05/a01);
  a06=(a10*a06);
  a07=(a08*a07);
  a06=(a06+a07);
  a04=(a04*a06);
  a08=(a08*a10);
  a08=(a08*a09);
  a04=(a04+a08);
  a05=(a05*a04);
  a05=(-a05);
  a00=(a00?a05:0);
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


