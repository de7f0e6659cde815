/* Generated from derive/ (digest 3592f43898c580f8) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`. */
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
#define casadi_f2 CASADI_PREFIX(f2)
#define casadi_f3 CASADI_PREFIX(f3)
#define casadi_f4 CASADI_PREFIX(f4)
#define casadi_f5 CASADI_PREFIX(f5)
#define casadi_f6 CASADI_PREFIX(f6)
#define casadi_f7 CASADI_PREFIX(f7)
#define casadi_f8 CASADI_PREFIX(f8)
#define casadi_f9 CASADI_PREFIX(f9)
#define casadi_fmax CASADI_PREFIX(fmax)
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
  a0=(2.*a0);
  a1=arg[9]? arg[9][0] : 0;
  a2=5.0000000000000000e-01;
  a3=arg[6]? arg[6][0] : 0;
  a2=(a2*a3);
  a3=arg[7]? arg[7][0] : 0;
  a2=(a2*a3);
  a3=arg[5]? arg[5][0] : 0;
  a2=(a2*a3);
  a3=arg[4]? arg[4][0] : 0;
  a4=casadi_sq(a3);
  a2=(a2*a4);
  a1=(a1+a2);
  a2=(a0+a1);
  a4=arg[0]? arg[0][0] : 0;
  a5=(a4*a3);
  a2=(a2/a5);
  a2=(-a2);
  if (res[0]!=0) res[0][0]=a2;
  a2=casadi_sq(a3);
  a4=(a4*a2);
  a2=arg[2]? arg[2][0] : 0;
  a6=(a0*a2);
  a7=arg[3]? arg[3][0] : 0;
  a8=(a1*a7);
  a6=(a6-a8);
  a4=(a4+a6);
  a4=(a4/a5);
  a4=(-a4);
  if (res[1]!=0) res[1][0]=a4;
  a4=arg[1]? arg[1][0] : 0;
  a4=(a4*a3);
  a6=(a6/a4);
  a6=(-a6);
  if (res[2]!=0) res[2][0]=a6;
  a2=casadi_sq(a2);
  a0=(a0*a2);
  a7=casadi_sq(a7);
  a1=(a1*a7);
  a0=(a0+a1);
  a0=(a0/a4);
  a0=(-a0);
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
  a00=(2.*a00);
  a01=arg[23]? arg[23][0] : 0;
  a02=arg[4]? arg[4][0] : 0;
  a03=casadi_sq(a02);
  a04=arg[5]? arg[5][0] : 0;
  a05=arg[7]? arg[7][0] : 0;
  a06=5.0000000000000000e-01;
  a07=arg[20]? arg[20][0] : 0;
  a07=(a06*a07);
  a07=(a05*a07);
  a08=arg[6]? arg[6][0] : 0;
  a06=(a06*a08);
  a08=arg[21]? arg[21][0] : 0;
  a08=(a06*a08);
  a07=(a07+a08);
  a07=(a04*a07);
  a06=(a06*a05);
  a05=arg[19]? arg[19][0] : 0;
  a05=(a06*a05);
  a07=(a07+a05);
  a07=(a03*a07);
  a06=(a06*a04);
  a04=(2.*a02);
  a05=arg[18]? arg[18][0] : 0;
  a04=(a04*a05);
  a04=(a06*a04);
  a07=(a07+a04);
  a01=(a01+a07);
  a07=(a00+a01);
  a04=arg[0]? arg[0][0] : 0;
  a08=(a04*a02);
  a07=(a07/a08);
  a09=arg[8]? arg[8][0] : 0;
  a09=(2.*a09);
  a10=arg[9]? arg[9][0] : 0;
  a06=(a06*a03);
  a10=(a10+a06);
  a06=(a09+a10);
  a06=(a06/a08);
  a06=(a06/a08);
  a03=arg[14]? arg[14][0] : 0;
  a11=(a02*a03);
  a12=(a04*a05);
  a11=(a11+a12);
  a06=(a06*a11);
  a07=(a07-a06);
  a07=(-a07);
  if (res[0]!=0) res[0][0]=a07;
  a07=casadi_sq(a02);
  a03=(a07*a03);
  a06=(2.*a02);
  a06=(a06*a05);
  a06=(a04*a06);
  a03=(a03+a06);
  a06=arg[2]? arg[2][0] : 0;
  a12=(a06*a00);
  a13=arg[16]? arg[16][0] : 0;
  a14=(a09*a13);
  a12=(a12+a14);
  a14=arg[3]? arg[3][0] : 0;
  a15=(a14*a01);
  a16=arg[17]? arg[17][0] : 0;
  a17=(a10*a16);
  a15=(a15+a17);
  a12=(a12-a15);
  a03=(a03+a12);
  a03=(a03/a08);
  a04=(a04*a07);
  a07=(a09*a06);
  a15=(a10*a14);
  a07=(a07-a15);
  a04=(a04+a07);
  a04=(a04/a08);
  a04=(a04/a08);
  a04=(a04*a11);
  a03=(a03-a04);
  a03=(-a03);
  if (res[1]!=0) res[1][0]=a03;
  a03=arg[1]? arg[1][0] : 0;
  a04=(a03*a02);
  a12=(a12/a04);
  a07=(a07/a04);
  a07=(a07/a04);
  a11=arg[15]? arg[15][0] : 0;
  a02=(a02*a11);
  a03=(a03*a05);
  a02=(a02+a03);
  a07=(a07*a02);
  a12=(a12-a07);
  a12=(-a12);
  if (res[2]!=0) res[2][0]=a12;
  a12=casadi_sq(a06);
  a00=(a12*a00);
  a06=(2.*a06);
  a06=(a06*a13);
  a06=(a09*a06);
  a00=(a00+a06);
  a06=casadi_sq(a14);
  a01=(a06*a01);
  a14=(2.*a14);
  a14=(a14*a16);
  a14=(a10*a14);
  a01=(a01+a14);
  a00=(a00+a01);
  a00=(a00/a04);
  a09=(a09*a12);
  a10=(a10*a06);
  a09=(a09+a10);
  a09=(a09/a04);
  a09=(a09/a04);
  a09=(a09*a02);
  a00=(a00-a09);
  a00=(-a00);
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
  a03=(a01*a02);
  a04=arg[8]? arg[8][0] : 0;
  a04=(2.*a04);
  a05=arg[2]? arg[2][0] : 0;
  a06=(a04*a05);
  a07=arg[9]? arg[9][0] : 0;
  a08=5.0000000000000000e-01;
  a09=arg[6]? arg[6][0] : 0;
  a09=(a08*a09);
  a10=arg[7]? arg[7][0] : 0;
  a11=(a09*a10);
  a12=arg[5]? arg[5][0] : 0;
  a13=(a11*a12);
  a14=casadi_sq(a00);
  a15=(a13*a14);
  a07=(a07+a15);
  a15=arg[3]? arg[3][0] : 0;
  a16=(a07*a15);
  a06=(a06-a16);
  a03=(a03+a06);
  a16=(a01*a00);
  a03=(a03/a16);
  a03=(a03/a16);
  a17=arg[15]? arg[15][0] : 0;
  a03=(a03*a17);
  a18=(a04+a07);
  a18=(a18/a16);
  a18=(a18/a16);
  a19=arg[14]? arg[14][0] : 0;
  a18=(a18*a19);
  a03=(a03+a18);
  a18=(a00*a03);
  a17=(a17/a16);
  a02=(a02*a17);
  a18=(a18-a02);
  if (res[0]!=0) res[0][0]=a18;
  a18=casadi_sq(a05);
  a02=(a04*a18);
  a20=casadi_sq(a15);
  a21=(a07*a20);
  a02=(a02+a21);
  a21=arg[1]? arg[1][0] : 0;
  a22=(a21*a00);
  a02=(a02/a22);
  a02=(a02/a22);
  a23=arg[17]? arg[17][0] : 0;
  a02=(a02*a23);
  a06=(a06/a22);
  a06=(a06/a22);
  a24=arg[16]? arg[16][0] : 0;
  a06=(a06*a24);
  a02=(a02+a06);
  a06=(a00*a02);
  if (res[1]!=0) res[1][0]=a06;
  a06=(2.*a05);
  a23=(a23/a22);
  a25=(a04*a23);
  a06=(a06*a25);
  a24=(a24/a22);
  a24=(a24+a17);
  a04=(a04*a24);
  a06=(a06+a04);
  a06=(-a06);
  if (res[2]!=0) res[2][0]=a06;
  a06=(a07*a24);
  a04=(2.*a15);
  a07=(a07*a23);
  a04=(a04*a07);
  a06=(a06-a04);
  if (res[3]!=0) res[3][0]=a06;
  a21=(a21*a02);
  a02=(2.*a00);
  a17=(a01*a17);
  a02=(a02*a17);
  a21=(a21-a02);
  a01=(a01*a03);
  a21=(a21+a01);
  a00=(2.*a00);
  a15=(a15*a24);
  a20=(a20*a23);
  a15=(a15-a20);
  a19=(a19/a16);
  a15=(a15-a19);
  a13=(a13*a15);
  a00=(a00*a13);
  a21=(a21+a00);
  if (res[4]!=0) res[4][0]=a21;
  a14=(a14*a15);
  a11=(a11*a14);
  if (res[5]!=0) res[5][0]=a11;
  a12=(a12*a14);
  a10=(a10*a12);
  a08=(a08*a10);
  if (res[6]!=0) res[6][0]=a08;
  a09=(a09*a12);
  if (res[7]!=0) res[7][0]=a09;
  a18=(a18*a23);
  a05=(a05*a24);
  a18=(a18+a05);
  a18=(a18+a19);
  a18=(-a18);
  a18=(2.*a18);
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
  a03=(a00*a02);
  a04=arg[8]? arg[8][0] : 0;
  a04=(2.*a04);
  a05=arg[2]? arg[2][0] : 0;
  a06=(a04*a05);
  a07=arg[9]? arg[9][0] : 0;
  a08=5.0000000000000000e-01;
  a09=arg[6]? arg[6][0] : 0;
  a09=(a08*a09);
  a10=arg[7]? arg[7][0] : 0;
  a11=(a09*a10);
  a12=arg[5]? arg[5][0] : 0;
  a13=(a11*a12);
  a14=casadi_sq(a01);
  a15=(a13*a14);
  a07=(a07+a15);
  a15=arg[3]? arg[3][0] : 0;
  a16=(a07*a15);
  a06=(a06-a16);
  a03=(a03+a06);
  a16=(a00*a01);
  a03=(a03/a16);
  a17=(a03/a16);
  a18=arg[15]? arg[15][0] : 0;
  a19=(a17*a18);
  a20=(a04+a07);
  a20=(a20/a16);
  a21=(a20/a16);
  a22=arg[14]? arg[14][0] : 0;
  a23=(a21*a22);
  a19=(a19+a23);
  a23=arg[32]? arg[32][0] : 0;
  a24=(a19*a23);
  a25=arg[28]? arg[28][0] : 0;
  a26=(a02*a25);
  a27=(2.*a01);
  a27=(a27*a23);
  a28=(a00*a27);
  a26=(a26+a28);
  a28=arg[36]? arg[36][0] : 0;
  a28=(2.*a28);
  a29=(a05*a28);
  a30=arg[30]? arg[30][0] : 0;
  a31=(a04*a30);
  a29=(a29+a31);
  a31=arg[37]? arg[37][0] : 0;
  a32=arg[34]? arg[34][0] : 0;
  a32=(a08*a32);
  a33=(a10*a32);
  a34=arg[35]? arg[35][0] : 0;
  a35=(a09*a34);
  a33=(a33+a35);
  a35=(a12*a33);
  a36=arg[33]? arg[33][0] : 0;
  a37=(a11*a36);
  a35=(a35+a37);
  a37=(a14*a35);
  a38=(2.*a01);
  a38=(a38*a23);
  a39=(a13*a38);
  a37=(a37+a39);
  a31=(a31+a37);
  a37=(a15*a31);
  a39=arg[31]? arg[31][0] : 0;
  a40=(a07*a39);
  a37=(a37+a40);
  a29=(a29-a37);
  a26=(a26+a29);
  a26=(a26/a16);
  a03=(a03/a16);
  a37=(a01*a25);
  a40=(a00*a23);
  a37=(a37+a40);
  a03=(a03*a37);
  a26=(a26-a03);
  a26=(a26/a16);
  a03=(a17/a16);
  a03=(a03*a37);
  a26=(a26-a03);
  a26=(a18*a26);
  a03=arg[43]? arg[43][0] : 0;
  a17=(a17*a03);
  a26=(a26+a17);
  a17=(a28+a31);
  a17=(a17/a16);
  a20=(a20/a16);
  a20=(a20*a37);
  a17=(a17-a20);
  a17=(a17/a16);
  a20=(a21/a16);
  a20=(a20*a37);
  a17=(a17-a20);
  a17=(a22*a17);
  a20=arg[42]? arg[42][0] : 0;
  a21=(a21*a20);
  a17=(a17+a21);
  a26=(a26+a17);
  a17=(a01*a26);
  a24=(a24+a17);
  a18=(a18/a16);
  a27=(a18*a27);
  a03=(a03/a16);
  a17=(a18/a16);
  a17=(a17*a37);
  a03=(a03-a17);
  a02=(a02*a03);
  a27=(a27+a02);
  a24=(a24-a27);
  if (res[0]!=0) res[0][0]=a24;
  a24=casadi_sq(a05);
  a27=(a04*a24);
  a02=casadi_sq(a15);
  a17=(a07*a02);
  a27=(a27+a17);
  a17=arg[1]? arg[1][0] : 0;
  a21=(a17*a01);
  a27=(a27/a21);
  a40=(a27/a21);
  a41=arg[17]? arg[17][0] : 0;
  a42=(a40*a41);
  a06=(a06/a21);
  a43=(a06/a21);
  a44=arg[16]? arg[16][0] : 0;
  a45=(a43*a44);
  a42=(a42+a45);
  a45=(a42*a23);
  a46=(a24*a28);
  a47=(2.*a05);
  a47=(a47*a30);
  a48=(a04*a47);
  a46=(a46+a48);
  a48=(a02*a31);
  a49=(2.*a15);
  a49=(a49*a39);
  a50=(a07*a49);
  a48=(a48+a50);
  a46=(a46+a48);
  a46=(a46/a21);
  a27=(a27/a21);
  a48=arg[29]? arg[29][0] : 0;
  a50=(a01*a48);
  a51=(a17*a23);
  a50=(a50+a51);
  a27=(a27*a50);
  a46=(a46-a27);
  a46=(a46/a21);
  a27=(a40/a21);
  a27=(a27*a50);
  a46=(a46-a27);
  a46=(a41*a46);
  a27=arg[45]? arg[45][0] : 0;
  a40=(a40*a27);
  a46=(a46+a40);
  a29=(a29/a21);
  a06=(a06/a21);
  a06=(a06*a50);
  a29=(a29-a06);
  a29=(a29/a21);
  a06=(a43/a21);
  a06=(a06*a50);
  a29=(a29-a06);
  a29=(a44*a29);
  a06=arg[44]? arg[44][0] : 0;
  a43=(a43*a06);
  a29=(a29+a43);
  a46=(a46+a29);
  a29=(a01*a46);
  a45=(a45+a29);
  if (res[1]!=0) res[1][0]=a45;
  a41=(a41/a21);
  a45=(a04*a41);
  a29=(2.*a30);
  a45=(a45*a29);
  a29=(2.*a05);
  a43=(a41*a28);
  a27=(a27/a21);
  a40=(a41/a21);
  a40=(a40*a50);
  a27=(a27-a40);
  a40=(a04*a27);
  a43=(a43+a40);
  a29=(a29*a43);
  a45=(a45+a29);
  a44=(a44/a21);
  a29=(a44+a18);
  a28=(a29*a28);
  a06=(a06/a21);
  a44=(a44/a21);
  a44=(a44*a50);
  a06=(a06-a44);
  a06=(a06+a03);
  a04=(a04*a06);
  a28=(a28+a04);
  a45=(a45+a28);
  a45=(-a45);
  if (res[2]!=0) res[2][0]=a45;
  a45=(a29*a31);
  a28=(a07*a06);
  a45=(a45+a28);
  a28=(a07*a41);
  a04=(2.*a39);
  a28=(a28*a04);
  a04=(2.*a15);
  a31=(a41*a31);
  a07=(a07*a27);
  a31=(a31+a07);
  a04=(a04*a31);
  a28=(a28+a04);
  a45=(a45-a28);
  if (res[3]!=0) res[3][0]=a45;
  a42=(a42*a48);
  a17=(a17*a46);
  a42=(a42+a17);
  a17=(a00*a18);
  a46=(2.*a23);
  a17=(a17*a46);
  a46=(2.*a01);
  a18=(a18*a25);
  a03=(a00*a03);
  a18=(a18+a03);
  a46=(a46*a18);
  a17=(a17+a46);
  a42=(a42-a17);
  a19=(a19*a25);
  a00=(a00*a26);
  a19=(a19+a00);
  a42=(a42+a19);
  a19=(a15*a29);
  a00=(a02*a41);
  a19=(a19-a00);
  a22=(a22/a16);
  a19=(a19-a22);
  a00=(a13*a19);
  a23=(2.*a23);
  a00=(a00*a23);
  a01=(2.*a01);
  a35=(a19*a35);
  a39=(a29*a39);
  a15=(a15*a06);
  a39=(a39+a15);
  a49=(a41*a49);
  a02=(a02*a27);
  a49=(a49+a02);
  a39=(a39-a49);
  a20=(a20/a16);
  a22=(a22/a16);
  a22=(a22*a37);
  a20=(a20-a22);
  a39=(a39-a20);
  a13=(a13*a39);
  a35=(a35+a13);
  a01=(a01*a35);
  a00=(a00+a01);
  a42=(a42+a00);
  if (res[4]!=0) res[4][0]=a42;
  a42=(a14*a19);
  a33=(a42*a33);
  a19=(a19*a38);
  a14=(a14*a39);
  a19=(a19+a14);
  a11=(a11*a19);
  a33=(a33+a11);
  if (res[5]!=0) res[5][0]=a33;
  a33=(a12*a42);
  a34=(a33*a34);
  a42=(a42*a36);
  a12=(a12*a19);
  a42=(a42+a12);
  a10=(a10*a42);
  a34=(a34+a10);
  a08=(a08*a34);
  if (res[6]!=0) res[6][0]=a08;
  a33=(a33*a32);
  a09=(a09*a42);
  a33=(a33+a09);
  if (res[7]!=0) res[7][0]=a33;
  a41=(a41*a47);
  a24=(a24*a27);
  a41=(a41+a24);
  a29=(a29*a30);
  a05=(a05*a06);
  a29=(a29+a05);
  a41=(a41+a29);
  a41=(a41+a20);
  a41=(-a41);
  a41=(2.*a41);
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
  a00=(2.*a00);
  a01=arg[2]? arg[2][0] : 0;
  a02=casadi_sq(a01);
  a03=arg[1]? arg[1][0] : 0;
  a04=arg[4]? arg[4][0] : 0;
  a05=(a03*a04);
  a02=(a02/a05);
  a06=arg[0]? arg[0][0] : 0;
  a07=(a06*a04);
  a07=(1./a07);
  a02=(a02+a07);
  a02=(a00*a02);
  a08=arg[9]? arg[9][0] : 0;
  a09=5.0000000000000000e-01;
  a10=arg[6]? arg[6][0] : 0;
  a09=(a09*a10);
  a10=arg[7]? arg[7][0] : 0;
  a09=(a09*a10);
  a10=arg[5]? arg[5][0] : 0;
  a09=(a09*a10);
  a10=casadi_sq(a04);
  a09=(a09*a10);
  a08=(a08+a09);
  a09=arg[3]? arg[3][0] : 0;
  a10=casadi_sq(a09);
  a10=(a10/a05);
  a10=(a10+a07);
  a10=(a08*a10);
  a02=(a02+a10);
  a10=(-a02);
  if (res[0]!=0) res[0][0]=a10;
  a10=(a00*a08);
  a07=(a01+a09);
  a07=casadi_sq(a07);
  a10=(a10*a07);
  a06=(a03*a06);
  a04=casadi_sq(a04);
  a06=(a06*a04);
  a10=(a10/a06);
  a00=(a00*a01);
  a00=(a00/a03);
  a10=(a10-a00);
  a08=(a08*a09);
  a08=(a08/a03);
  a10=(a10+a08);
  if (res[1]!=0) res[1][0]=a10;
  a08=-4.;
  a08=(a08*a10);
  a02=casadi_sq(a02);
  a08=(a08+a02);
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
  a04=(a02*a03);
  a01=(a01/a04);
  a05=arg[0]? arg[0][0] : 0;
  a06=(a05*a03);
  a07=(1./a06);
  a08=(a01+a07);
  a09=arg[21]? arg[21][0] : 0;
  a09=(2.*a09);
  a10=(a08*a09);
  a11=arg[8]? arg[8][0] : 0;
  a11=(2.*a11);
  a12=(2.*a00);
  a13=arg[15]? arg[15][0] : 0;
  a12=(a12*a13);
  a12=(a12/a04);
  a01=(a01/a04);
  a14=arg[14]? arg[14][0] : 0;
  a15=(a03*a14);
  a16=arg[17]? arg[17][0] : 0;
  a17=(a02*a16);
  a15=(a15+a17);
  a01=(a01*a15);
  a12=(a12-a01);
  a06=(a07/a06);
  a01=arg[13]? arg[13][0] : 0;
  a17=(a03*a01);
  a18=(a05*a16);
  a17=(a17+a18);
  a06=(a06*a17);
  a12=(a12-a06);
  a12=(a11*a12);
  a10=(a10+a12);
  a12=arg[3]? arg[3][0] : 0;
  a17=casadi_sq(a12);
  a17=(a17/a04);
  a07=(a17+a07);
  a18=arg[22]? arg[22][0] : 0;
  a19=casadi_sq(a03);
  a20=arg[5]? arg[5][0] : 0;
  a21=arg[7]? arg[7][0] : 0;
  a22=5.0000000000000000e-01;
  a23=arg[19]? arg[19][0] : 0;
  a23=(a22*a23);
  a23=(a21*a23);
  a24=arg[6]? arg[6][0] : 0;
  a22=(a22*a24);
  a24=arg[20]? arg[20][0] : 0;
  a24=(a22*a24);
  a23=(a23+a24);
  a23=(a20*a23);
  a22=(a22*a21);
  a21=arg[18]? arg[18][0] : 0;
  a21=(a22*a21);
  a23=(a23+a21);
  a23=(a19*a23);
  a22=(a22*a20);
  a20=(2.*a03);
  a20=(a20*a16);
  a20=(a22*a20);
  a23=(a23+a20);
  a18=(a18+a23);
  a23=(a07*a18);
  a20=arg[9]? arg[9][0] : 0;
  a22=(a22*a19);
  a20=(a20+a22);
  a22=(2.*a12);
  a19=arg[16]? arg[16][0] : 0;
  a22=(a22*a19);
  a22=(a22/a04);
  a17=(a17/a04);
  a17=(a17*a15);
  a22=(a22-a17);
  a22=(a22-a06);
  a22=(a20*a22);
  a23=(a23+a22);
  a10=(a10+a23);
  a23=(-a10);
  if (res[0]!=0) res[0][0]=a23;
  a23=(a00+a12);
  a22=casadi_sq(a23);
  a06=(a20*a09);
  a17=(a11*a18);
  a06=(a06+a17);
  a06=(a22*a06);
  a17=(a11*a20);
  a23=(2.*a23);
  a15=(a13+a19);
  a23=(a23*a15);
  a23=(a17*a23);
  a06=(a06+a23);
  a23=(a02*a05);
  a15=casadi_sq(a03);
  a04=(a23*a15);
  a06=(a06/a04);
  a17=(a17*a22);
  a17=(a17/a04);
  a17=(a17/a04);
  a05=(a05*a14);
  a01=(a02*a01);
  a05=(a05+a01);
  a15=(a15*a05);
  a03=(2.*a03);
  a03=(a03*a16);
  a23=(a23*a03);
  a15=(a15+a23);
  a17=(a17*a15);
  a06=(a06-a17);
  a09=(a00*a09);
  a13=(a11*a13);
  a09=(a09+a13);
  a09=(a09/a02);
  a00=(a11*a00);
  a00=(a00/a02);
  a00=(a00/a02);
  a00=(a00*a14);
  a09=(a09-a00);
  a06=(a06-a09);
  a18=(a12*a18);
  a19=(a20*a19);
  a18=(a18+a19);
  a18=(a18/a02);
  a12=(a20*a12);
  a12=(a12/a02);
  a12=(a12/a02);
  a12=(a12*a14);
  a18=(a18-a12);
  a06=(a06+a18);
  if (res[1]!=0) res[1][0]=a06;
  a18=-4.;
  a18=(a18*a06);
  a11=(a11*a08);
  a20=(a20*a07);
  a11=(a11+a20);
  a11=(2.*a11);
  a11=(a11*a10);
  a18=(a18+a11);
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
  a03=(2.*a03);
  a04=arg[9]? arg[9][0] : 0;
  a05=5.0000000000000000e-01;
  a06=arg[6]? arg[6][0] : 0;
  a06=(a05*a06);
  a07=arg[7]? arg[7][0] : 0;
  a08=(a06*a07);
  a09=arg[5]? arg[5][0] : 0;
  a10=(a08*a09);
  a11=casadi_sq(a01);
  a12=(a10*a11);
  a04=(a04+a12);
  a12=(a03*a04);
  a13=arg[2]? arg[2][0] : 0;
  a14=arg[3]? arg[3][0] : 0;
  a15=(a13+a14);
  a16=casadi_sq(a15);
  a17=(a12*a16);
  a18=arg[0]? arg[0][0] : 0;
  a19=(a00*a18);
  a20=(a19*a02);
  a17=(a17/a20);
  a17=(a17/a20);
  a21=-4.;
  a22=arg[15]? arg[15][0] : 0;
  a21=(a21*a22);
  a23=arg[14]? arg[14][0] : 0;
  a21=(a21+a23);
  a17=(a17*a21);
  a02=(a02*a17);
  a23=(a00*a02);
  a24=(a18*a01);
  a25=(1./a24);
  a24=(a25/a24);
  a26=casadi_sq(a13);
  a27=(a00*a01);
  a26=(a26/a27);
  a28=(a26+a25);
  a29=(a03*a28);
  a30=casadi_sq(a14);
  a30=(a30/a27);
  a25=(a30+a25);
  a31=(a04*a25);
  a29=(a29+a31);
  a29=(2.*a29);
  a29=(a29*a22);
  a22=arg[13]? arg[13][0] : 0;
  a29=(a29-a22);
  a22=(a04*a29);
  a31=(a03*a29);
  a32=(a22+a31);
  a24=(a24*a32);
  a32=(a01*a24);
  a23=(a23+a32);
  a23=(-a23);
  if (res[0]!=0) res[0][0]=a23;
  a23=(a03*a13);
  a23=(a23/a00);
  a23=(a23/a00);
  a23=(a23*a21);
  a32=(a04*a14);
  a32=(a32/a00);
  a32=(a32/a00);
  a32=(a32*a21);
  a23=(a23-a32);
  a02=(a18*a02);
  a23=(a23-a02);
  a30=(a30/a27);
  a30=(a30*a22);
  a26=(a26/a27);
  a26=(a26*a31);
  a30=(a30+a26);
  a26=(a01*a30);
  a23=(a23-a26);
  if (res[1]!=0) res[1][0]=a23;
  a15=(2.*a15);
  a20=(a21/a20);
  a12=(a12*a20);
  a15=(a15*a12);
  a12=(a21/a00);
  a23=(a03*a12);
  a23=(a15-a23);
  a26=(2.*a13);
  a31=(a31/a27);
  a26=(a26*a31);
  a23=(a23+a26);
  if (res[2]!=0) res[2][0]=a23;
  a21=(a21/a00);
  a23=(a04*a21);
  a23=(a23+a15);
  a15=(2.*a14);
  a22=(a22/a27);
  a15=(a15*a22);
  a23=(a23+a15);
  if (res[3]!=0) res[3][0]=a23;
  a23=(2.*a01);
  a14=(a14*a21);
  a16=(a16*a20);
  a03=(a03*a16);
  a14=(a14+a03);
  a25=(a25*a29);
  a14=(a14+a25);
  a10=(a10*a14);
  a23=(a23*a10);
  a01=(2.*a01);
  a19=(a19*a17);
  a01=(a01*a19);
  a23=(a23-a01);
  a18=(a18*a24);
  a23=(a23-a18);
  a00=(a00*a30);
  a23=(a23-a00);
  if (res[4]!=0) res[4][0]=a23;
  a11=(a11*a14);
  a08=(a08*a11);
  if (res[5]!=0) res[5][0]=a08;
  a09=(a09*a11);
  a07=(a07*a09);
  a05=(a05*a07);
  if (res[6]!=0) res[6][0]=a05;
  a06=(a06*a09);
  if (res[7]!=0) res[7][0]=a06;
  a04=(a04*a16);
  a13=(a13*a12);
  a04=(a04-a13);
  a28=(a28*a29);
  a04=(a04+a28);
  a04=(2.*a04);
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
  a02=(2.*a02);
  a03=arg[9]? arg[9][0] : 0;
  a04=5.0000000000000000e-01;
  a05=arg[6]? arg[6][0] : 0;
  a05=(a04*a05);
  a06=arg[7]? arg[7][0] : 0;
  a07=(a05*a06);
  a08=arg[5]? arg[5][0] : 0;
  a09=(a07*a08);
  a10=casadi_sq(a00);
  a11=(a09*a10);
  a03=(a03+a11);
  a11=(a02*a03);
  a12=arg[2]? arg[2][0] : 0;
  a13=arg[3]? arg[3][0] : 0;
  a14=(a12+a13);
  a15=casadi_sq(a14);
  a16=(a11*a15);
  a17=arg[1]? arg[1][0] : 0;
  a18=arg[0]? arg[0][0] : 0;
  a19=(a17*a18);
  a20=(a19*a01);
  a16=(a16/a20);
  a21=(a16/a20);
  a22=-4.;
  a23=arg[15]? arg[15][0] : 0;
  a24=(a22*a23);
  a25=arg[14]? arg[14][0] : 0;
  a24=(a24+a25);
  a25=(a21*a24);
  a26=(a01*a25);
  a27=arg[27]? arg[27][0] : 0;
  a28=(a26*a27);
  a29=(2.*a00);
  a30=arg[30]? arg[30][0] : 0;
  a29=(a29*a30);
  a31=(a25*a29);
  a32=arg[34]? arg[34][0] : 0;
  a32=(2.*a32);
  a33=(a03*a32);
  a34=arg[35]? arg[35][0] : 0;
  a35=arg[32]? arg[32][0] : 0;
  a35=(a04*a35);
  a36=(a06*a35);
  a37=arg[33]? arg[33][0] : 0;
  a38=(a05*a37);
  a36=(a36+a38);
  a38=(a08*a36);
  a39=arg[31]? arg[31][0] : 0;
  a40=(a07*a39);
  a38=(a38+a40);
  a40=(a10*a38);
  a41=(2.*a00);
  a41=(a41*a30);
  a42=(a09*a41);
  a40=(a40+a42);
  a34=(a34+a40);
  a40=(a02*a34);
  a33=(a33+a40);
  a40=(a15*a33);
  a42=(2.*a14);
  a43=arg[28]? arg[28][0] : 0;
  a44=arg[29]? arg[29][0] : 0;
  a45=(a43+a44);
  a42=(a42*a45);
  a46=(a11*a42);
  a40=(a40+a46);
  a40=(a40/a20);
  a16=(a16/a20);
  a46=(a18*a27);
  a47=arg[26]? arg[26][0] : 0;
  a48=(a17*a47);
  a46=(a46+a48);
  a48=(a01*a46);
  a29=(a19*a29);
  a48=(a48+a29);
  a16=(a16*a48);
  a40=(a40-a16);
  a40=(a40/a20);
  a16=(a21/a20);
  a16=(a16*a48);
  a40=(a40-a16);
  a40=(a24*a40);
  a16=arg[41]? arg[41][0] : 0;
  a22=(a22*a16);
  a29=arg[40]? arg[40][0] : 0;
  a22=(a22+a29);
  a21=(a21*a22);
  a40=(a40+a21);
  a01=(a01*a40);
  a31=(a31+a01);
  a01=(a17*a31);
  a28=(a28+a01);
  a01=(a18*a00);
  a21=(1./a01);
  a29=(a21/a01);
  a49=casadi_sq(a12);
  a50=(a17*a00);
  a49=(a49/a50);
  a51=(a49+a21);
  a52=(a02*a51);
  a53=casadi_sq(a13);
  a53=(a53/a50);
  a54=(a53+a21);
  a55=(a03*a54);
  a52=(a52+a55);
  a52=(2.*a52);
  a55=(a52*a23);
  a56=arg[13]? arg[13][0] : 0;
  a55=(a55-a56);
  a56=(a03*a55);
  a57=(a02*a55);
  a58=(a56+a57);
  a59=(a29*a58);
  a60=(a59*a30);
  a61=(a55*a34);
  a62=(a51*a32);
  a63=(2.*a12);
  a63=(a63*a43);
  a63=(a63/a50);
  a64=(a49/a50);
  a65=(a00*a27);
  a66=(a17*a30);
  a65=(a65+a66);
  a64=(a64*a65);
  a63=(a63-a64);
  a21=(a21/a01);
  a64=(a00*a47);
  a66=(a18*a30);
  a64=(a64+a66);
  a21=(a21*a64);
  a66=(a63-a21);
  a67=(a02*a66);
  a62=(a62+a67);
  a67=(a54*a34);
  a68=(2.*a13);
  a68=(a68*a44);
  a68=(a68/a50);
  a69=(a53/a50);
  a69=(a69*a65);
  a68=(a68-a69);
  a69=(a68-a21);
  a70=(a03*a69);
  a67=(a67+a70);
  a62=(a62+a67);
  a62=(2.*a62);
  a23=(a23*a62);
  a52=(a52*a16);
  a23=(a23+a52);
  a52=arg[39]? arg[39][0] : 0;
  a23=(a23-a52);
  a52=(a03*a23);
  a61=(a61+a52);
  a52=(a55*a32);
  a16=(a02*a23);
  a52=(a52+a16);
  a16=(a61+a52);
  a16=(a29*a16);
  a21=(a21/a01);
  a29=(a29/a01);
  a29=(a29*a64);
  a21=(a21+a29);
  a58=(a58*a21);
  a16=(a16-a58);
  a58=(a00*a16);
  a60=(a60+a58);
  a28=(a28+a60);
  a28=(-a28);
  if (res[0]!=0) res[0][0]=a28;
  a28=(a12*a32);
  a60=(a02*a43);
  a28=(a28+a60);
  a28=(a28/a17);
  a60=(a02*a12);
  a60=(a60/a17);
  a58=(a60/a17);
  a58=(a58*a27);
  a28=(a28-a58);
  a28=(a28/a17);
  a60=(a60/a17);
  a58=(a60/a17);
  a58=(a58*a27);
  a28=(a28-a58);
  a28=(a24*a28);
  a60=(a60*a22);
  a28=(a28+a60);
  a60=(a13*a34);
  a58=(a03*a44);
  a60=(a60+a58);
  a60=(a60/a17);
  a58=(a03*a13);
  a58=(a58/a17);
  a21=(a58/a17);
  a21=(a21*a27);
  a60=(a60-a21);
  a60=(a60/a17);
  a58=(a58/a17);
  a21=(a58/a17);
  a21=(a21*a27);
  a60=(a60-a21);
  a60=(a24*a60);
  a58=(a58*a22);
  a60=(a60+a58);
  a28=(a28-a60);
  a26=(a26*a47);
  a31=(a18*a31);
  a26=(a26+a31);
  a28=(a28-a26);
  a53=(a53/a50);
  a26=(a53*a56);
  a49=(a49/a50);
  a31=(a49*a57);
  a26=(a26+a31);
  a31=(a26*a30);
  a68=(a68/a50);
  a60=(a53/a50);
  a60=(a60*a65);
  a68=(a68-a60);
  a68=(a56*a68);
  a53=(a53*a61);
  a68=(a68+a53);
  a63=(a63/a50);
  a53=(a49/a50);
  a53=(a53*a65);
  a63=(a63-a53);
  a63=(a57*a63);
  a49=(a49*a52);
  a63=(a63+a49);
  a68=(a68+a63);
  a63=(a00*a68);
  a31=(a31+a63);
  a28=(a28-a31);
  if (res[1]!=0) res[1][0]=a28;
  a28=(a24/a20);
  a31=(a11*a28);
  a45=(2.*a45);
  a31=(a31*a45);
  a14=(2.*a14);
  a33=(a28*a33);
  a45=(a22/a20);
  a20=(a28/a20);
  a20=(a20*a48);
  a45=(a45-a20);
  a11=(a11*a45);
  a33=(a33+a11);
  a14=(a14*a33);
  a31=(a31+a14);
  a14=(a24/a17);
  a33=(a14*a32);
  a11=(a22/a17);
  a20=(a14/a17);
  a20=(a20*a27);
  a11=(a11-a20);
  a20=(a02*a11);
  a33=(a33+a20);
  a33=(a31-a33);
  a57=(a57/a50);
  a20=(2.*a43);
  a20=(a57*a20);
  a48=(2.*a12);
  a52=(a52/a50);
  a57=(a57/a50);
  a57=(a57*a65);
  a52=(a52-a57);
  a48=(a48*a52);
  a20=(a20+a48);
  a33=(a33+a20);
  if (res[2]!=0) res[2][0]=a33;
  a24=(a24/a17);
  a33=(a24*a34);
  a22=(a22/a17);
  a20=(a24/a17);
  a20=(a20*a27);
  a22=(a22-a20);
  a20=(a03*a22);
  a33=(a33+a20);
  a33=(a33+a31);
  a56=(a56/a50);
  a31=(2.*a44);
  a31=(a56*a31);
  a20=(2.*a13);
  a61=(a61/a50);
  a56=(a56/a50);
  a56=(a56*a65);
  a61=(a61-a56);
  a20=(a20*a61);
  a31=(a31+a20);
  a33=(a33+a31);
  if (res[3]!=0) res[3][0]=a33;
  a33=(a13*a24);
  a31=(a15*a28);
  a20=(a02*a31);
  a33=(a33+a20);
  a20=(a54*a55);
  a33=(a33+a20);
  a20=(a09*a33);
  a61=(2.*a30);
  a20=(a20*a61);
  a61=(2.*a00);
  a38=(a33*a38);
  a24=(a24*a44);
  a13=(a13*a22);
  a24=(a24+a13);
  a32=(a31*a32);
  a28=(a28*a42);
  a15=(a15*a45);
  a28=(a28+a15);
  a02=(a02*a28);
  a32=(a32+a02);
  a24=(a24+a32);
  a69=(a55*a69);
  a54=(a54*a23);
  a69=(a69+a54);
  a24=(a24+a69);
  a09=(a09*a24);
  a38=(a38+a09);
  a61=(a61*a38);
  a20=(a20+a61);
  a61=(a19*a25);
  a30=(2.*a30);
  a61=(a61*a30);
  a00=(2.*a00);
  a25=(a25*a46);
  a19=(a19*a40);
  a25=(a25+a19);
  a00=(a00*a25);
  a61=(a61+a00);
  a20=(a20-a61);
  a59=(a59*a47);
  a18=(a18*a16);
  a59=(a59+a18);
  a20=(a20-a59);
  a26=(a26*a27);
  a17=(a17*a68);
  a26=(a26+a17);
  a20=(a20-a26);
  if (res[4]!=0) res[4][0]=a20;
  a20=(a10*a33);
  a36=(a20*a36);
  a33=(a33*a41);
  a10=(a10*a24);
  a33=(a33+a10);
  a07=(a07*a33);
  a36=(a36+a07);
  if (res[5]!=0) res[5][0]=a36;
  a36=(a08*a20);
  a37=(a36*a37);
  a20=(a20*a39);
  a08=(a08*a33);
  a20=(a20+a08);
  a06=(a06*a20);
  a37=(a37+a06);
  a04=(a04*a37);
  if (res[6]!=0) res[6][0]=a04;
  a36=(a36*a35);
  a05=(a05*a20);
  a36=(a36+a05);
  if (res[7]!=0) res[7][0]=a36;
  a31=(a31*a34);
  a03=(a03*a28);
  a31=(a31+a03);
  a14=(a14*a43);
  a12=(a12*a11);
  a14=(a14+a12);
  a31=(a31-a14);
  a55=(a55*a66);
  a51=(a51*a23);
  a55=(a55+a51);
  a31=(a31+a55);
  a31=(2.*a31);
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
  casadi_real a0, a1, a2, a3, a4, a5, a6, a7, a8, a9;
  a0=5.0000000000000000e-01;
  a1=0.;
  a2=4.;
  a3=arg[2]? arg[2][0] : 0;
  a2=(a2*a3);
  a4=arg[1]? arg[1][0] : 0;
  a2=(a2*a4);
  a5=arg[0]? arg[0][0] : 0;
  a6=arg[3]? arg[3][0] : 0;
  a7=(a5-a6);
  a7=casadi_sq(a7);
  a2=(a2+a7);
  a7=casadi_fmax(a1,a2);
  a7=sqrt(a7);
  a7=(a0*a7);
  a8=(a6+a5);
  a9=(a0*a8);
  a9=(a7+a9);
  if (res[0]!=0) res[0][0]=a9;
  a2=(-a2);
  a1=casadi_fmax(a1,a2);
  a1=sqrt(a1);
  a1=(a0*a1);
  if (res[1]!=0) res[1][0]=a1;
  a0=(a0*a8);
  a0=(a0-a7);
  if (res[2]!=0) res[2][0]=a0;
  a0=(-a1);
  if (res[3]!=0) res[3][0]=a0;
  a9=(-a9);
  if (res[4]!=0) res[4][0]=a9;
  a6=(a6*a5);
  a3=(a3*a4);
  a6=(a6-a3);
  a6=sqrt(a6);
  if (res[5]!=0) res[5][0]=a6;
  if (res[6]!=0) res[6][0]=a1;
  a1=-5.0000000000000000e-01;
  a1=(a1*a8);
  a1=(a1/a6);
  if (res[7]!=0) res[7][0]=a1;
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
  casadi_real a12, a13, a14, a15, a16;
  a00=5.0000000000000000e-01;
  a01=0.;
  a02=4.;
  a03=arg[2]? arg[2][0] : 0;
  a04=(a02*a03);
  a05=arg[1]? arg[1][0] : 0;
  a06=(a04*a05);
  a07=arg[0]? arg[0][0] : 0;
  a08=arg[3]? arg[3][0] : 0;
  a09=(a07-a08);
  a10=casadi_sq(a09);
  a06=(a06+a10);
  a10=(a01<=a06);
  a11=(a06<=a01);
  a11=(a11+a10);
  a10=(a10/a11);
  a11=arg[14]? arg[14][0] : 0;
  a02=(a02*a11);
  a02=(a05*a02);
  a12=arg[13]? arg[13][0] : 0;
  a04=(a04*a12);
  a02=(a02+a04);
  a09=(2.*a09);
  a04=arg[12]? arg[12][0] : 0;
  a13=arg[15]? arg[15][0] : 0;
  a14=(a04-a13);
  a09=(a09*a14);
  a02=(a02+a09);
  a10=(a10*a02);
  a09=casadi_fmax(a01,a06);
  a09=sqrt(a09);
  a09=(2.*a09);
  a10=(a10/a09);
  a10=(a00*a10);
  a09=(a13+a04);
  a14=(a00*a09);
  a14=(a10+a14);
  if (res[0]!=0) res[0][0]=a14;
  a06=(-a06);
  a15=(a01<=a06);
  a16=(a06<=a01);
  a16=(a16+a15);
  a15=(a15/a16);
  a15=(a15*a02);
  a01=casadi_fmax(a01,a06);
  a01=sqrt(a01);
  a01=(2.*a01);
  a15=(a15/a01);
  a15=(a00*a15);
  a01=(-a15);
  if (res[1]!=0) res[1][0]=a01;
  a00=(a00*a09);
  a00=(a00-a10);
  if (res[2]!=0) res[2][0]=a00;
  if (res[3]!=0) res[3][0]=a15;
  a14=(-a14);
  if (res[4]!=0) res[4][0]=a14;
  a13=(a07*a13);
  a04=(a08*a04);
  a13=(a13+a04);
  a11=(a05*a11);
  a12=(a03*a12);
  a11=(a11+a12);
  a13=(a13-a11);
  a11=(a08*a07);
  a03=(a03*a05);
  a11=(a11-a03);
  a11=sqrt(a11);
  a03=(2.*a11);
  a13=(a13/a03);
  if (res[5]!=0) res[5][0]=a13;
  if (res[6]!=0) res[6][0]=a01;
  a01=-5.0000000000000000e-01;
  a09=(a01*a09);
  a09=(a09/a11);
  a08=(a08+a07);
  a01=(a01*a08);
  a01=(a01/a11);
  a01=(a01/a11);
  a01=(a01*a13);
  a09=(a09-a01);
  if (res[7]!=0) res[7][0]=a09;
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
  casadi_real a12, a13, a14, a15;
  a00=arg[3]? arg[3][0] : 0;
  a01=arg[17]? arg[17][0] : 0;
  a02=-5.0000000000000000e-01;
  a03=arg[0]? arg[0][0] : 0;
  a04=(a00+a03);
  a04=(a02*a04);
  a05=(a00*a03);
  a06=arg[2]? arg[2][0] : 0;
  a07=arg[1]? arg[1][0] : 0;
  a08=(a06*a07);
  a05=(a05-a08);
  a05=sqrt(a05);
  a04=(a04/a05);
  a04=(a04/a05);
  a08=arg[19]? arg[19][0] : 0;
  a04=(a04*a08);
  a01=(a01-a04);
  a04=(2.*a05);
  a01=(a01/a04);
  a04=(a00*a01);
  a08=(a08/a05);
  a02=(a02*a08);
  a08=5.0000000000000000e-01;
  a05=arg[14]? arg[14][0] : 0;
  a09=(a08*a05);
  a02=(a02+a09);
  a09=arg[12]? arg[12][0] : 0;
  a10=arg[16]? arg[16][0] : 0;
  a09=(a09-a10);
  a10=(a08*a09);
  a02=(a02+a10);
  a04=(a04+a02);
  a00=(a03-a00);
  a10=(2.*a00);
  a11=0.;
  a12=4.;
  a13=(a12*a06);
  a14=(a13*a07);
  a00=casadi_sq(a00);
  a14=(a14+a00);
  a00=(a11<=a14);
  a15=(a14<=a11);
  a15=(a15+a00);
  a00=(a00/a15);
  a09=(a09-a05);
  a09=(a08*a09);
  a05=casadi_fmax(a11,a14);
  a05=sqrt(a05);
  a05=(2.*a05);
  a09=(a09/a05);
  a00=(a00*a09);
  a14=(-a14);
  a09=(a11<=a14);
  a05=(a14<=a11);
  a05=(a05+a09);
  a09=(a09/a05);
  a05=arg[18]? arg[18][0] : 0;
  a15=arg[15]? arg[15][0] : 0;
  a05=(a05-a15);
  a15=arg[13]? arg[13][0] : 0;
  a05=(a05+a15);
  a08=(a08*a05);
  a11=casadi_fmax(a11,a14);
  a11=sqrt(a11);
  a11=(2.*a11);
  a08=(a08/a11);
  a09=(a09*a08);
  a00=(a00-a09);
  a10=(a10*a00);
  a04=(a04+a10);
  if (res[0]!=0) res[0][0]=a04;
  a13=(a13*a00);
  a06=(a06*a01);
  a13=(a13-a06);
  if (res[1]!=0) res[1][0]=a13;
  a00=(a07*a00);
  a12=(a12*a00);
  a07=(a07*a01);
  a12=(a12-a07);
  if (res[2]!=0) res[2][0]=a12;
  a03=(a03*a01);
  a03=(a03+a02);
  a03=(a03-a10);
  if (res[3]!=0) res[3][0]=a03;
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
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31;
  a00=arg[17]? arg[17][0] : 0;
  a01=-5.0000000000000000e-01;
  a02=arg[3]? arg[3][0] : 0;
  a03=arg[0]? arg[0][0] : 0;
  a04=(a02+a03);
  a04=(a01*a04);
  a05=(a02*a03);
  a06=arg[2]? arg[2][0] : 0;
  a07=arg[1]? arg[1][0] : 0;
  a08=(a06*a07);
  a05=(a05-a08);
  a05=sqrt(a05);
  a04=(a04/a05);
  a08=(a04/a05);
  a09=arg[19]? arg[19][0] : 0;
  a10=(a08*a09);
  a00=(a00-a10);
  a10=(2.*a05);
  a00=(a00/a10);
  a11=arg[27]? arg[27][0] : 0;
  a12=(a00*a11);
  a13=arg[41]? arg[41][0] : 0;
  a14=arg[24]? arg[24][0] : 0;
  a15=(a11+a14);
  a15=(a01*a15);
  a15=(a15/a05);
  a04=(a04/a05);
  a16=(a03*a11);
  a17=(a02*a14);
  a16=(a16+a17);
  a17=arg[26]? arg[26][0] : 0;
  a18=(a07*a17);
  a19=arg[25]? arg[25][0] : 0;
  a20=(a06*a19);
  a18=(a18+a20);
  a16=(a16-a18);
  a18=(2.*a05);
  a16=(a16/a18);
  a04=(a04*a16);
  a15=(a15-a04);
  a15=(a15/a05);
  a04=(a08/a05);
  a04=(a04*a16);
  a15=(a15-a04);
  a15=(a09*a15);
  a04=arg[43]? arg[43][0] : 0;
  a08=(a08*a04);
  a15=(a15+a08);
  a13=(a13-a15);
  a13=(a13/a10);
  a10=(a00/a10);
  a15=(2.*a16);
  a10=(a10*a15);
  a13=(a13-a10);
  a10=(a02*a13);
  a12=(a12+a10);
  a04=(a04/a05);
  a09=(a09/a05);
  a09=(a09/a05);
  a09=(a09*a16);
  a04=(a04-a09);
  a01=(a01*a04);
  a04=5.0000000000000000e-01;
  a09=arg[38]? arg[38][0] : 0;
  a16=(a04*a09);
  a01=(a01+a16);
  a16=arg[36]? arg[36][0] : 0;
  a05=arg[40]? arg[40][0] : 0;
  a16=(a16-a05);
  a05=(a04*a16);
  a01=(a01+a05);
  a12=(a12+a01);
  a05=0.;
  a10=4.;
  a15=(a10*a06);
  a08=(a15*a07);
  a02=(a03-a02);
  a18=casadi_sq(a02);
  a08=(a08+a18);
  a18=(a05<=a08);
  a20=(a08<=a05);
  a20=(a20+a18);
  a18=(a18/a20);
  a20=arg[12]? arg[12][0] : 0;
  a21=arg[16]? arg[16][0] : 0;
  a20=(a20-a21);
  a21=arg[14]? arg[14][0] : 0;
  a20=(a20-a21);
  a20=(a04*a20);
  a21=casadi_fmax(a05,a08);
  a21=sqrt(a21);
  a22=(2.*a21);
  a20=(a20/a22);
  a23=(a18*a20);
  a24=(-a08);
  a25=(a05<=a24);
  a26=(a24<=a05);
  a26=(a26+a25);
  a25=(a25/a26);
  a26=arg[18]? arg[18][0] : 0;
  a27=arg[15]? arg[15][0] : 0;
  a26=(a26-a27);
  a27=arg[13]? arg[13][0] : 0;
  a26=(a26+a27);
  a26=(a04*a26);
  a27=casadi_fmax(a05,a24);
  a27=sqrt(a27);
  a28=(2.*a27);
  a26=(a26/a28);
  a29=(a25*a26);
  a23=(a23-a29);
  a11=(a14-a11);
  a29=(2.*a11);
  a29=(a23*a29);
  a30=(2.*a02);
  a16=(a16-a09);
  a16=(a04*a16);
  a16=(a16/a22);
  a20=(a20/a22);
  a22=(a05<=a08);
  a08=(a08<=a05);
  a08=(a08+a22);
  a22=(a22/a08);
  a08=(a10*a17);
  a09=(a07*a08);
  a31=(a15*a19);
  a09=(a09+a31);
  a02=(2.*a02);
  a02=(a02*a11);
  a09=(a09+a02);
  a22=(a22*a09);
  a21=(2.*a21);
  a22=(a22/a21);
  a22=(2.*a22);
  a20=(a20*a22);
  a16=(a16-a20);
  a18=(a18*a16);
  a16=arg[42]? arg[42][0] : 0;
  a20=arg[39]? arg[39][0] : 0;
  a16=(a16-a20);
  a20=arg[37]? arg[37][0] : 0;
  a16=(a16+a20);
  a04=(a04*a16);
  a04=(a04/a28);
  a26=(a26/a28);
  a28=(a05<=a24);
  a24=(a24<=a05);
  a24=(a24+a28);
  a28=(a28/a24);
  a28=(a28*a09);
  a27=(2.*a27);
  a28=(a28/a27);
  a28=(-a28);
  a28=(2.*a28);
  a26=(a26*a28);
  a04=(a04-a26);
  a25=(a25*a04);
  a18=(a18-a25);
  a30=(a30*a18);
  a29=(a29+a30);
  a12=(a12+a29);
  if (res[0]!=0) res[0][0]=a12;
  a08=(a23*a08);
  a15=(a15*a18);
  a08=(a08+a15);
  a17=(a00*a17);
  a06=(a06*a13);
  a17=(a17+a06);
  a08=(a08-a17);
  if (res[1]!=0) res[1][0]=a08;
  a23=(a23*a19);
  a18=(a07*a18);
  a23=(a23+a18);
  a10=(a10*a23);
  a19=(a00*a19);
  a07=(a07*a13);
  a19=(a19+a07);
  a10=(a10-a19);
  if (res[2]!=0) res[2][0]=a10;
  a00=(a00*a14);
  a03=(a03*a13);
  a00=(a00+a03);
  a00=(a00+a01);
  a00=(a00-a29);
  if (res[3]!=0) res[3][0]=a00;
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

/* speed_window:(m,a,b,rho,Ap,CL_gamma,C_alpha,Ct)->(u_low,u_high) */
static int casadi_f12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12;
  a00=arg[6]? arg[6][0] : 0;
  a01=(2.*a00);
  a02=arg[7]? arg[7][0] : 0;
  a03=(a01*a02);
  a04=arg[1]? arg[1][0] : 0;
  a05=arg[2]? arg[2][0] : 0;
  a06=(a04+a05);
  a06=casadi_sq(a06);
  a03=(a03*a06);
  a06=(2.*a03);
  a07=-4.;
  a07=(a07*a03);
  a03=5.0000000000000000e-01;
  a08=arg[4]? arg[4][0] : 0;
  a08=(a03*a08);
  a09=arg[5]? arg[5][0] : 0;
  a08=(a08*a09);
  a09=arg[3]? arg[3][0] : 0;
  a08=(a08*a09);
  a09=(a05*a08);
  a10=arg[0]? arg[0][0] : 0;
  a09=(a09*a10);
  a07=(a07*a09);
  a11=casadi_sq(a04);
  a11=(a01*a11);
  a11=(a11*a08);
  a12=4.;
  a12=(a12*a00);
  a12=(a12*a04);
  a12=(a12*a05);
  a12=(a12*a08);
  a11=(a11+a12);
  a04=(a01*a04);
  a04=(a04*a10);
  a11=(a11-a04);
  a04=casadi_sq(a05);
  a01=(a01*a04);
  a01=(a01*a08);
  a11=(a11+a01);
  a02=(a02*a05);
  a02=(a02*a10);
  a11=(a11+a02);
  a02=casadi_sq(a11);
  a07=(a07+a02);
  a07=sqrt(a07);
  a07=(a07-a11);
  a06=(a06/a07);
  a06=sqrt(a06);
  if (res[0]!=0) res[0][0]=a06;
  a03=(a03*a07);
  a03=(a03/a09);
  a03=sqrt(a03);
  if (res[1]!=0) res[1][0]=a03;
  return 0;
}

CASADI_SYMBOL_EXPORT int speed_window(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f12(arg, res, iw, w, mem);
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
static int casadi_f13(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37;
  a00=arg[1]? arg[1][0] : 0;
  a01=arg[2]? arg[2][0] : 0;
  a02=(a00+a01);
  a03=casadi_sq(a02);
  a04=arg[7]? arg[7][0] : 0;
  a05=arg[16]? arg[16][0] : 0;
  a06=(2.*a05);
  a07=(a04*a06);
  a08=arg[6]? arg[6][0] : 0;
  a09=(2.*a08);
  a10=arg[17]? arg[17][0] : 0;
  a11=(a09*a10);
  a07=(a07+a11);
  a07=(a03*a07);
  a11=(a09*a04);
  a02=(2.*a02);
  a12=arg[11]? arg[11][0] : 0;
  a13=arg[12]? arg[12][0] : 0;
  a14=(a12+a13);
  a02=(a02*a14);
  a02=(a11*a02);
  a07=(a07+a02);
  a02=(2.*a07);
  a14=-4.;
  a11=(a11*a03);
  a03=(a14*a11);
  a15=5.0000000000000000e-01;
  a16=arg[4]? arg[4][0] : 0;
  a16=(a15*a16);
  a17=arg[5]? arg[5][0] : 0;
  a18=(a16*a17);
  a19=arg[3]? arg[3][0] : 0;
  a20=(a18*a19);
  a21=(a01*a20);
  a22=arg[0]? arg[0][0] : 0;
  a23=(a21*a22);
  a24=(a03*a23);
  a25=casadi_sq(a00);
  a26=(a09*a25);
  a27=(a26*a20);
  a28=4.;
  a08=(a28*a08);
  a29=(a08*a00);
  a30=(a29*a01);
  a31=(a30*a20);
  a27=(a27+a31);
  a31=(a09*a00);
  a32=(a31*a22);
  a27=(a27-a32);
  a32=casadi_sq(a01);
  a33=(a09*a32);
  a34=(a33*a20);
  a27=(a27+a34);
  a34=(a04*a01);
  a35=(a34*a22);
  a27=(a27+a35);
  a35=casadi_sq(a27);
  a24=(a24+a35);
  a24=sqrt(a24);
  a35=(a24-a27);
  a02=(a02/a35);
  a11=(2.*a11);
  a11=(a11/a35);
  a36=(a11/a35);
  a14=(a14*a07);
  a14=(a23*a14);
  a07=(a20*a13);
  a37=arg[14]? arg[14][0] : 0;
  a37=(a15*a37);
  a17=(a17*a37);
  a37=arg[15]? arg[15][0] : 0;
  a16=(a16*a37);
  a17=(a17+a16);
  a19=(a19*a17);
  a17=arg[13]? arg[13][0] : 0;
  a18=(a18*a17);
  a19=(a19+a18);
  a18=(a01*a19);
  a07=(a07+a18);
  a07=(a22*a07);
  a18=arg[10]? arg[10][0] : 0;
  a21=(a21*a18);
  a07=(a07+a21);
  a03=(a03*a07);
  a14=(a14+a03);
  a27=(2.*a27);
  a25=(a25*a06);
  a03=(2.*a00);
  a03=(a03*a12);
  a03=(a09*a03);
  a25=(a25+a03);
  a25=(a20*a25);
  a26=(a26*a19);
  a25=(a25+a26);
  a28=(a28*a05);
  a28=(a00*a28);
  a08=(a08*a12);
  a28=(a28+a08);
  a28=(a01*a28);
  a29=(a29*a13);
  a28=(a28+a29);
  a28=(a20*a28);
  a30=(a30*a19);
  a28=(a28+a30);
  a25=(a25+a28);
  a00=(a00*a06);
  a12=(a09*a12);
  a00=(a00+a12);
  a00=(a22*a00);
  a31=(a31*a18);
  a00=(a00+a31);
  a25=(a25-a00);
  a32=(a32*a06);
  a06=(2.*a01);
  a06=(a06*a13);
  a09=(a09*a06);
  a32=(a32+a09);
  a20=(a20*a32);
  a33=(a33*a19);
  a20=(a20+a33);
  a25=(a25+a20);
  a01=(a01*a10);
  a04=(a04*a13);
  a01=(a01+a04);
  a22=(a22*a01);
  a34=(a34*a18);
  a22=(a22+a34);
  a25=(a25+a22);
  a27=(a27*a25);
  a14=(a14+a27);
  a24=(2.*a24);
  a14=(a14/a24);
  a14=(a14-a25);
  a36=(a36*a14);
  a02=(a02-a36);
  a11=sqrt(a11);
  a11=(2.*a11);
  a02=(a02/a11);
  if (res[0]!=0) res[0][0]=a02;
  a14=(a15*a14);
  a14=(a14/a23);
  a15=(a15*a35);
  a15=(a15/a23);
  a23=(a15/a23);
  a23=(a23*a07);
  a14=(a14-a23);
  a15=sqrt(a15);
  a15=(2.*a15);
  a14=(a14/a15);
  if (res[1]!=0) res[1][0]=a14;
  return 0;
}

CASADI_SYMBOL_EXPORT int fwd1_speed_window(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f13(arg, res, iw, w, mem);
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
static int casadi_f14(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36;
  a00=arg[7]? arg[7][0] : 0;
  a01=arg[2]? arg[2][0] : 0;
  a02=(a00*a01);
  a03=arg[6]? arg[6][0] : 0;
  a04=(2.*a03);
  a05=arg[1]? arg[1][0] : 0;
  a06=casadi_sq(a05);
  a07=(a04*a06);
  a08=5.0000000000000000e-01;
  a09=arg[4]? arg[4][0] : 0;
  a09=(a08*a09);
  a10=arg[5]? arg[5][0] : 0;
  a11=(a09*a10);
  a12=arg[3]? arg[3][0] : 0;
  a13=(a11*a12);
  a14=(a07*a13);
  a15=4.;
  a03=(a15*a03);
  a16=(a03*a05);
  a17=(a16*a01);
  a18=(a17*a13);
  a14=(a14+a18);
  a18=(a04*a05);
  a19=arg[0]? arg[0][0] : 0;
  a20=(a18*a19);
  a14=(a14-a20);
  a20=casadi_sq(a01);
  a21=(a04*a20);
  a22=(a21*a13);
  a14=(a14+a22);
  a22=(a02*a19);
  a14=(a14+a22);
  a22=(2.*a14);
  a23=arg[11]? arg[11][0] : 0;
  a24=-4.;
  a25=(a04*a00);
  a26=(a05+a01);
  a27=casadi_sq(a26);
  a28=(a25*a27);
  a29=(a24*a28);
  a30=(a01*a13);
  a31=(a30*a19);
  a32=(a29*a31);
  a33=casadi_sq(a14);
  a32=(a32+a33);
  a32=sqrt(a32);
  a14=(a32-a14);
  a33=(a08*a14);
  a33=(a33/a31);
  a34=sqrt(a33);
  a34=(2.*a34);
  a23=(a23/a34);
  a34=(a23/a31);
  a34=(a08*a34);
  a28=(2.*a28);
  a28=(a28/a14);
  a35=(a28/a14);
  a36=arg[10]? arg[10][0] : 0;
  a28=sqrt(a28);
  a28=(2.*a28);
  a36=(a36/a28);
  a35=(a35*a36);
  a34=(a34-a35);
  a32=(2.*a32);
  a32=(a34/a32);
  a22=(a22*a32);
  a22=(a22-a34);
  a02=(a02*a22);
  a18=(a18*a22);
  a02=(a02-a18);
  a29=(a29*a32);
  a33=(a33/a31);
  a33=(a33*a23);
  a29=(a29-a33);
  a30=(a30*a29);
  a02=(a02+a30);
  if (res[0]!=0) res[0][0]=a02;
  a02=(a13*a22);
  a30=(a01*a02);
  a03=(a03*a30);
  a33=(a19*a22);
  a23=(a04*a33);
  a03=(a03-a23);
  a23=(2.*a05);
  a18=(a13*a22);
  a34=(a04*a18);
  a23=(a23*a34);
  a03=(a03+a23);
  a26=(2.*a26);
  a31=(a31*a32);
  a24=(a24*a31);
  a36=(a36/a14);
  a36=(2.*a36);
  a24=(a24+a36);
  a25=(a25*a24);
  a26=(a26*a25);
  a03=(a03+a26);
  if (res[1]!=0) res[1][0]=a03;
  a03=(a19*a22);
  a25=(a00*a03);
  a36=(2.*a01);
  a14=(a13*a22);
  a31=(a04*a14);
  a36=(a36*a31);
  a25=(a25+a36);
  a16=(a16*a02);
  a25=(a25+a16);
  a19=(a19*a29);
  a13=(a13*a19);
  a25=(a25+a13);
  a25=(a25+a26);
  if (res[2]!=0) res[2][0]=a25;
  a21=(a21*a22);
  a17=(a17*a22);
  a21=(a21+a17);
  a07=(a07*a22);
  a21=(a21+a07);
  a19=(a01*a19);
  a21=(a21+a19);
  a11=(a11*a21);
  if (res[3]!=0) res[3][0]=a11;
  a12=(a12*a21);
  a10=(a10*a12);
  a08=(a08*a10);
  if (res[4]!=0) res[4][0]=a08;
  a09=(a09*a12);
  if (res[5]!=0) res[5][0]=a09;
  a30=(a05*a30);
  a15=(a15*a30);
  a20=(a20*a14);
  a05=(a05*a33);
  a20=(a20-a05);
  a06=(a06*a18);
  a20=(a20+a06);
  a27=(a27*a24);
  a00=(a00*a27);
  a20=(a20+a00);
  a20=(2.*a20);
  a15=(a15+a20);
  if (res[6]!=0) res[6][0]=a15;
  a01=(a01*a03);
  a04=(a04*a27);
  a01=(a01+a04);
  if (res[7]!=0) res[7][0]=a01;
  return 0;
}

CASADI_SYMBOL_EXPORT int adj1_speed_window(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f14(arg, res, iw, w, mem);
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
static int casadi_f15(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72, a73, a74, a75;
  a00=arg[6]? arg[6][0] : 0;
  a01=(2.*a00);
  a02=arg[1]? arg[1][0] : 0;
  a03=casadi_sq(a02);
  a04=(a01*a03);
  a05=5.0000000000000000e-01;
  a06=arg[4]? arg[4][0] : 0;
  a06=(a05*a06);
  a07=arg[5]? arg[5][0] : 0;
  a08=(a06*a07);
  a09=arg[3]? arg[3][0] : 0;
  a10=(a08*a09);
  a11=(a04*a10);
  a12=4.;
  a00=(a12*a00);
  a13=(a00*a02);
  a14=arg[2]? arg[2][0] : 0;
  a15=(a13*a14);
  a16=(a15*a10);
  a11=(a11+a16);
  a16=(a01*a02);
  a17=arg[0]? arg[0][0] : 0;
  a18=(a16*a17);
  a11=(a11-a18);
  a18=casadi_sq(a14);
  a19=(a01*a18);
  a20=(a19*a10);
  a11=(a11+a20);
  a20=arg[7]? arg[7][0] : 0;
  a21=(a20*a14);
  a22=(a21*a17);
  a11=(a11+a22);
  a22=(2.*a11);
  a23=arg[11]? arg[11][0] : 0;
  a24=-4.;
  a25=(a01*a20);
  a26=(a02+a14);
  a27=casadi_sq(a26);
  a28=(a25*a27);
  a29=(a24*a28);
  a30=(a14*a10);
  a31=(a30*a17);
  a32=(a29*a31);
  a33=casadi_sq(a11);
  a32=(a32+a33);
  a32=sqrt(a32);
  a33=(a32-a11);
  a34=(a05*a33);
  a34=(a34/a31);
  a35=sqrt(a34);
  a36=(2.*a35);
  a23=(a23/a36);
  a37=(a23/a31);
  a38=(a05*a37);
  a28=(2.*a28);
  a28=(a28/a33);
  a39=(a28/a33);
  a40=arg[10]? arg[10][0] : 0;
  a41=sqrt(a28);
  a42=(2.*a41);
  a40=(a40/a42);
  a43=(a39*a40);
  a38=(a38-a43);
  a43=(2.*a32);
  a44=(a38/a43);
  a45=(a22*a44);
  a45=(a45-a38);
  a38=arg[27]? arg[27][0] : 0;
  a46=(a14*a38);
  a47=arg[22]? arg[22][0] : 0;
  a48=(a20*a47);
  a46=(a46+a48);
  a48=(a45*a46);
  a49=arg[26]? arg[26][0] : 0;
  a50=(2.*a49);
  a51=(a03*a50);
  a52=(2.*a02);
  a53=arg[21]? arg[21][0] : 0;
  a52=(a52*a53);
  a54=(a01*a52);
  a51=(a51+a54);
  a54=(a10*a51);
  a55=arg[24]? arg[24][0] : 0;
  a55=(a05*a55);
  a56=(a07*a55);
  a57=arg[25]? arg[25][0] : 0;
  a58=(a06*a57);
  a56=(a56+a58);
  a58=(a09*a56);
  a59=arg[23]? arg[23][0] : 0;
  a60=(a08*a59);
  a58=(a58+a60);
  a60=(a04*a58);
  a54=(a54+a60);
  a49=(a12*a49);
  a60=(a02*a49);
  a61=(a00*a53);
  a60=(a60+a61);
  a61=(a14*a60);
  a62=(a13*a47);
  a61=(a61+a62);
  a62=(a10*a61);
  a63=(a15*a58);
  a62=(a62+a63);
  a54=(a54+a62);
  a62=(a02*a50);
  a63=(a01*a53);
  a62=(a62+a63);
  a63=(a17*a62);
  a64=arg[20]? arg[20][0] : 0;
  a65=(a16*a64);
  a63=(a63+a65);
  a54=(a54-a63);
  a63=(a18*a50);
  a65=(2.*a14);
  a65=(a65*a47);
  a66=(a01*a65);
  a63=(a63+a66);
  a66=(a10*a63);
  a67=(a19*a58);
  a66=(a66+a67);
  a54=(a54+a66);
  a46=(a17*a46);
  a66=(a21*a64);
  a46=(a46+a66);
  a54=(a54+a46);
  a46=(2.*a54);
  a46=(a44*a46);
  a66=arg[31]? arg[31][0] : 0;
  a66=(a66/a36);
  a36=(a23/a36);
  a67=(a20*a50);
  a68=(a01*a38);
  a67=(a67+a68);
  a68=(a27*a67);
  a69=(2.*a26);
  a70=(a53+a47);
  a69=(a69*a70);
  a71=(a25*a69);
  a68=(a68+a71);
  a71=(a24*a68);
  a72=(a31*a71);
  a73=(a10*a47);
  a74=(a14*a58);
  a73=(a73+a74);
  a74=(a17*a73);
  a75=(a30*a64);
  a74=(a74+a75);
  a75=(a29*a74);
  a72=(a72+a75);
  a11=(2.*a11);
  a11=(a11*a54);
  a72=(a72+a11);
  a32=(2.*a32);
  a72=(a72/a32);
  a54=(a72-a54);
  a32=(a05*a54);
  a32=(a32/a31);
  a11=(a34/a31);
  a11=(a11*a74);
  a32=(a32-a11);
  a35=(2.*a35);
  a35=(a32/a35);
  a35=(2.*a35);
  a36=(a36*a35);
  a66=(a66-a36);
  a36=(a66/a31);
  a37=(a37/a31);
  a37=(a37*a74);
  a36=(a36-a37);
  a36=(a05*a36);
  a68=(2.*a68);
  a68=(a68/a33);
  a28=(a28/a33);
  a28=(a28*a54);
  a68=(a68-a28);
  a28=(a68/a33);
  a37=(a39/a33);
  a37=(a37*a54);
  a28=(a28-a37);
  a28=(a40*a28);
  a37=arg[30]? arg[30][0] : 0;
  a37=(a37/a42);
  a42=(a40/a42);
  a41=(2.*a41);
  a68=(a68/a41);
  a68=(2.*a68);
  a42=(a42*a68);
  a37=(a37-a42);
  a39=(a39*a37);
  a28=(a28+a39);
  a36=(a36-a28);
  a28=(a36/a43);
  a43=(a44/a43);
  a72=(2.*a72);
  a43=(a43*a72);
  a28=(a28-a43);
  a22=(a22*a28);
  a46=(a46+a22);
  a46=(a46-a36);
  a21=(a21*a46);
  a48=(a48+a21);
  a62=(a45*a62);
  a16=(a16*a46);
  a62=(a62+a16);
  a48=(a48-a62);
  a62=(a29*a44);
  a34=(a34/a31);
  a16=(a34*a23);
  a62=(a62-a16);
  a73=(a62*a73);
  a71=(a44*a71);
  a29=(a29*a28);
  a71=(a71+a29);
  a32=(a32/a31);
  a29=(a34/a31);
  a29=(a29*a74);
  a32=(a32-a29);
  a23=(a23*a32);
  a34=(a34*a66);
  a23=(a23+a34);
  a71=(a71-a23);
  a30=(a30*a71);
  a73=(a73+a30);
  a48=(a48+a73);
  if (res[0]!=0) res[0][0]=a48;
  a48=(a10*a45);
  a73=(a14*a48);
  a49=(a73*a49);
  a30=(a48*a47);
  a23=(a45*a58);
  a34=(a10*a46);
  a23=(a23+a34);
  a34=(a14*a23);
  a30=(a30+a34);
  a00=(a00*a30);
  a49=(a49+a00);
  a00=(a17*a45);
  a34=(a00*a50);
  a66=(a45*a64);
  a32=(a17*a46);
  a66=(a66+a32);
  a32=(a01*a66);
  a34=(a34+a32);
  a49=(a49-a34);
  a34=(a10*a45);
  a32=(a01*a34);
  a29=(2.*a53);
  a32=(a32*a29);
  a29=(2.*a02);
  a16=(a34*a50);
  a21=(a45*a58);
  a36=(a10*a46);
  a21=(a21+a36);
  a36=(a01*a21);
  a16=(a16+a36);
  a29=(a29*a16);
  a32=(a32+a29);
  a49=(a49+a32);
  a32=(a31*a44);
  a32=(a24*a32);
  a40=(a40/a33);
  a29=(2.*a40);
  a32=(a32+a29);
  a29=(a25*a32);
  a70=(2.*a70);
  a29=(a29*a70);
  a26=(2.*a26);
  a67=(a32*a67);
  a44=(a44*a74);
  a31=(a31*a28);
  a44=(a44+a31);
  a24=(a24*a44);
  a37=(a37/a33);
  a40=(a40/a33);
  a40=(a40*a54);
  a37=(a37-a40);
  a37=(2.*a37);
  a24=(a24+a37);
  a25=(a25*a24);
  a67=(a67+a25);
  a26=(a26*a67);
  a29=(a29+a26);
  a49=(a49+a29);
  if (res[1]!=0) res[1][0]=a49;
  a49=(a17*a45);
  a26=(a49*a38);
  a67=(a45*a64);
  a25=(a17*a46);
  a67=(a67+a25);
  a25=(a20*a67);
  a26=(a26+a25);
  a25=(a10*a45);
  a37=(a01*a25);
  a40=(2.*a47);
  a37=(a37*a40);
  a40=(2.*a14);
  a54=(a25*a50);
  a33=(a45*a58);
  a44=(a10*a46);
  a33=(a33+a44);
  a44=(a01*a33);
  a54=(a54+a44);
  a40=(a40*a54);
  a37=(a37+a40);
  a26=(a26+a37);
  a48=(a48*a60);
  a13=(a13*a23);
  a48=(a48+a13);
  a26=(a26+a48);
  a48=(a17*a62);
  a58=(a48*a58);
  a62=(a62*a64);
  a17=(a17*a71);
  a62=(a62+a17);
  a10=(a10*a62);
  a58=(a58+a10);
  a26=(a26+a58);
  a26=(a26+a29);
  if (res[2]!=0) res[2][0]=a26;
  a26=(a19*a45);
  a29=(a15*a45);
  a26=(a26+a29);
  a29=(a04*a45);
  a26=(a26+a29);
  a29=(a14*a48);
  a26=(a26+a29);
  a56=(a26*a56);
  a63=(a45*a63);
  a19=(a19*a46);
  a63=(a63+a19);
  a61=(a45*a61);
  a15=(a15*a46);
  a61=(a61+a15);
  a63=(a63+a61);
  a45=(a45*a51);
  a04=(a04*a46);
  a45=(a45+a04);
  a63=(a63+a45);
  a48=(a48*a47);
  a62=(a14*a62);
  a48=(a48+a62);
  a63=(a63+a48);
  a08=(a08*a63);
  a56=(a56+a08);
  if (res[3]!=0) res[3][0]=a56;
  a56=(a09*a26);
  a57=(a56*a57);
  a26=(a26*a59);
  a09=(a09*a63);
  a26=(a26+a09);
  a07=(a07*a26);
  a57=(a57+a07);
  a05=(a05*a57);
  if (res[4]!=0) res[4][0]=a05;
  a56=(a56*a55);
  a06=(a06*a26);
  a56=(a56+a06);
  if (res[5]!=0) res[5][0]=a56;
  a73=(a73*a53);
  a30=(a02*a30);
  a73=(a73+a30);
  a12=(a12*a73);
  a25=(a25*a65);
  a18=(a18*a33);
  a25=(a25+a18);
  a00=(a00*a53);
  a02=(a02*a66);
  a00=(a00+a02);
  a25=(a25-a00);
  a34=(a34*a52);
  a03=(a03*a21);
  a34=(a34+a03);
  a25=(a25+a34);
  a34=(a27*a32);
  a38=(a34*a38);
  a32=(a32*a69);
  a27=(a27*a24);
  a32=(a32+a27);
  a20=(a20*a32);
  a38=(a38+a20);
  a25=(a25+a38);
  a25=(2.*a25);
  a12=(a12+a25);
  if (res[6]!=0) res[6][0]=a12;
  a49=(a49*a47);
  a14=(a14*a67);
  a49=(a49+a14);
  a34=(a34*a50);
  a01=(a01*a32);
  a34=(a34+a01);
  a49=(a49+a34);
  if (res[7]!=0) res[7][0]=a49;
  return 0;
}

CASADI_SYMBOL_EXPORT int fwd1_adj1_speed_window(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f15(arg, res, iw, w, mem);
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


