/* Generated from derive/ (digest bfd9ab80ef38709d) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`. */
/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) model_ ## ID
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
#define casadi_s0 CASADI_PREFIX(s0)
#define casadi_s1 CASADI_PREFIX(s1)
#define casadi_s10 CASADI_PREFIX(s10)
#define casadi_s11 CASADI_PREFIX(s11)
#define casadi_s12 CASADI_PREFIX(s12)
#define casadi_s13 CASADI_PREFIX(s13)
#define casadi_s14 CASADI_PREFIX(s14)
#define casadi_s15 CASADI_PREFIX(s15)
#define casadi_s2 CASADI_PREFIX(s2)
#define casadi_s3 CASADI_PREFIX(s3)
#define casadi_s4 CASADI_PREFIX(s4)
#define casadi_s5 CASADI_PREFIX(s5)
#define casadi_s6 CASADI_PREFIX(s6)
#define casadi_s7 CASADI_PREFIX(s7)
#define casadi_s8 CASADI_PREFIX(s8)
#define casadi_s9 CASADI_PREFIX(s9)
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
CASADI_SYMBOL_EXPORT void model_casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int model_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int model_casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {7, 1, 1};
static const casadi_int casadi_s1[3] = {1, 1, 1};
static const casadi_int casadi_s2[3] = {11, 1, 1};
static const casadi_int casadi_s3[4] = {7, 1, 0, 0};
static const casadi_int casadi_s4[4] = {1, 1, 0, 0};
static const casadi_int casadi_s5[4] = {11, 1, 0, 0};
static const casadi_int casadi_s6[3] = {10, 1, 1};
static const casadi_int casadi_s7[4] = {10, 1, 0, 0};
static const casadi_int casadi_s8[3] = {7, 7, 1};
static const casadi_int casadi_s9[3] = {7, 11, 1};
static const casadi_int casadi_s10[3] = {10, 7, 1};
static const casadi_int casadi_s11[3] = {10, 11, 1};
static const casadi_int casadi_s12[10] = 
  {7, 7, 0, 0, 0, 0, 0, 0,
  0, 0};
static const casadi_int casadi_s13[14] = 
  {7, 11, 0, 0, 0, 0, 0, 0,
  0, 0, 0, 0, 0, 0};
static const casadi_int casadi_s14[10] = 
  {10, 7, 0, 0, 0, 0, 0, 0,
  0, 0};
static const casadi_int casadi_s15[14] = 
  {10, 11, 0, 0, 0, 0, 0, 0,
  0, 0, 0, 0, 0, 0};

/* linear_rhs:(x[7],u,p[11])->(xdot[7]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10;
  a00=arg[1]? arg[1][0] : 0;
  a01=arg[2]? arg[2][8] : 0;
  a02=arg[2]? arg[2][2] : 0;
  a03=arg[0]? arg[0][1] : 0;
  a04=(a02*a03);
  a05=arg[0]? arg[0][0] : 0;
  a04=(a04+a05);
  a06=arg[2]? arg[2][4] : 0;
  a04=(a04/a06);
  a01=(a01*a04);
  a01=(2.*a01);
  a04=(a00-a01);
  a07=5.0000000000000000e-01;
  a08=arg[2]? arg[2][6] : 0;
  a07=(a07*a08);
  a08=arg[2]? arg[2][7] : 0;
  a07=(a07*a08);
  a08=arg[2]? arg[2][3] : 0;
  a09=(a08*a03);
  a09=(a05-a09);
  a09=(a09/a06);
  a07=(a07*a09);
  a10=arg[2]? arg[2][5] : 0;
  a07=(a07*a10);
  a10=casadi_sq(a06);
  a07=(a07*a10);
  a04=(a04-a07);
  a10=arg[2]? arg[2][9] : 0;
  a10=(a10*a09);
  a04=(a04-a10);
  a09=arg[2]? arg[2][0] : 0;
  a04=(a04/a09);
  a09=(a03*a06);
  a04=(a04-a09);
  if (res[0]!=0) res[0][0]=a04;
  a07=(a07*a08);
  a00=(a00*a08);
  a01=(a01*a02);
  a00=(a00+a01);
  a07=(a07-a00);
  a10=(a10*a08);
  a07=(a07+a10);
  a10=arg[2]? arg[2][1] : 0;
  a07=(a07/a10);
  if (res[0]!=0) res[0][1]=a07;
  if (res[0]!=0) res[0][2]=a05;
  if (res[0]!=0) res[0][3]=a03;
  a07=arg[0]? arg[0][6] : 0;
  a10=cos(a07);
  a10=(a06*a10);
  a08=sin(a07);
  a08=(a05*a08);
  a10=(a10-a08);
  if (res[0]!=0) res[0][4]=a10;
  a10=sin(a07);
  a06=(a06*a10);
  a07=cos(a07);
  a05=(a05*a07);
  a06=(a06+a05);
  if (res[0]!=0) res[0][5]=a06;
  if (res[0]!=0) res[0][6]=a03;
  return 0;
}

CASADI_SYMBOL_EXPORT int linear_rhs(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int linear_rhs_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void linear_rhs_release(int mem) {
}

CASADI_SYMBOL_EXPORT void linear_rhs_incref(void) {
}

CASADI_SYMBOL_EXPORT void linear_rhs_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int linear_rhs_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int linear_rhs_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real linear_rhs_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* linear_rhs_name_in(casadi_int i) {
  switch (i) {
    case 0: return "x";
    case 1: return "u";
    case 2: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* linear_rhs_name_out(casadi_int i) {
  switch (i) {
    case 0: return "xdot";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* linear_rhs_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* linear_rhs_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int linear_rhs_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int linear_rhs_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* fwd1_linear_rhs:(x[7],u,p[11],out_xdot[7x1,0nz],fwd_x[7],fwd_u,fwd_p[11])->(fwd_xdot[7]) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22;
  a00=arg[5]? arg[5][0] : 0;
  a01=arg[2]? arg[2][2] : 0;
  a02=arg[0]? arg[0][1] : 0;
  a03=(a01*a02);
  a04=arg[0]? arg[0][0] : 0;
  a03=(a03+a04);
  a05=arg[2]? arg[2][4] : 0;
  a03=(a03/a05);
  a06=arg[6]? arg[6][8] : 0;
  a06=(a03*a06);
  a07=arg[2]? arg[2][8] : 0;
  a08=arg[6]? arg[6][2] : 0;
  a09=(a02*a08);
  a10=arg[4]? arg[4][1] : 0;
  a11=(a01*a10);
  a09=(a09+a11);
  a11=arg[4]? arg[4][0] : 0;
  a09=(a09+a11);
  a09=(a09/a05);
  a12=(a03/a05);
  a13=arg[6]? arg[6][4] : 0;
  a12=(a12*a13);
  a09=(a09-a12);
  a09=(a07*a09);
  a06=(a06+a09);
  a06=(2.*a06);
  a09=(a00-a06);
  a12=casadi_sq(a05);
  a14=arg[2]? arg[2][5] : 0;
  a15=arg[2]? arg[2][3] : 0;
  a16=(a15*a02);
  a16=(a04-a16);
  a16=(a16/a05);
  a17=arg[2]? arg[2][7] : 0;
  a18=5.0000000000000000e-01;
  a19=arg[6]? arg[6][6] : 0;
  a19=(a18*a19);
  a19=(a17*a19);
  a20=arg[2]? arg[2][6] : 0;
  a18=(a18*a20);
  a20=arg[6]? arg[6][7] : 0;
  a20=(a18*a20);
  a19=(a19+a20);
  a19=(a16*a19);
  a18=(a18*a17);
  a17=arg[6]? arg[6][3] : 0;
  a20=(a02*a17);
  a21=(a15*a10);
  a20=(a20+a21);
  a20=(a11-a20);
  a20=(a20/a05);
  a21=(a16/a05);
  a21=(a21*a13);
  a20=(a20-a21);
  a21=(a18*a20);
  a19=(a19+a21);
  a19=(a14*a19);
  a18=(a18*a16);
  a21=arg[6]? arg[6][5] : 0;
  a21=(a18*a21);
  a19=(a19+a21);
  a19=(a12*a19);
  a18=(a18*a14);
  a14=(2.*a05);
  a14=(a14*a13);
  a14=(a18*a14);
  a19=(a19+a14);
  a09=(a09-a19);
  a14=arg[6]? arg[6][9] : 0;
  a14=(a16*a14);
  a21=arg[2]? arg[2][9] : 0;
  a20=(a21*a20);
  a14=(a14+a20);
  a09=(a09-a14);
  a20=arg[2]? arg[2][0] : 0;
  a09=(a09/a20);
  a22=arg[1]? arg[1][0] : 0;
  a07=(a07*a03);
  a07=(2.*a07);
  a03=(a22-a07);
  a18=(a18*a12);
  a03=(a03-a18);
  a21=(a21*a16);
  a03=(a03-a21);
  a03=(a03/a20);
  a03=(a03/a20);
  a20=arg[6]? arg[6][0] : 0;
  a03=(a03*a20);
  a09=(a09-a03);
  a03=(a05*a10);
  a02=(a02*a13);
  a03=(a03+a02);
  a09=(a09-a03);
  if (res[0]!=0) res[0][0]=a09;
  a19=(a15*a19);
  a09=(a18*a17);
  a19=(a19+a09);
  a00=(a15*a00);
  a09=(a22*a17);
  a00=(a00+a09);
  a06=(a01*a06);
  a08=(a07*a08);
  a06=(a06+a08);
  a00=(a00+a06);
  a19=(a19-a00);
  a14=(a15*a14);
  a17=(a21*a17);
  a14=(a14+a17);
  a19=(a19+a14);
  a14=arg[2]? arg[2][1] : 0;
  a19=(a19/a14);
  a18=(a18*a15);
  a22=(a22*a15);
  a07=(a07*a01);
  a22=(a22+a07);
  a18=(a18-a22);
  a21=(a21*a15);
  a18=(a18+a21);
  a18=(a18/a14);
  a18=(a18/a14);
  a14=arg[6]? arg[6][1] : 0;
  a18=(a18*a14);
  a19=(a19-a18);
  if (res[0]!=0) res[0][1]=a19;
  if (res[0]!=0) res[0][2]=a11;
  if (res[0]!=0) res[0][3]=a10;
  a19=arg[0]? arg[0][6] : 0;
  a18=cos(a19);
  a18=(a18*a13);
  a14=sin(a19);
  a21=arg[4]? arg[4][6] : 0;
  a14=(a14*a21);
  a14=(a05*a14);
  a18=(a18-a14);
  a14=sin(a19);
  a14=(a14*a11);
  a15=cos(a19);
  a15=(a15*a21);
  a15=(a04*a15);
  a14=(a14+a15);
  a18=(a18-a14);
  if (res[0]!=0) res[0][4]=a18;
  a18=sin(a19);
  a18=(a18*a13);
  a13=cos(a19);
  a13=(a13*a21);
  a05=(a05*a13);
  a18=(a18+a05);
  a05=cos(a19);
  a05=(a05*a11);
  a19=sin(a19);
  a19=(a19*a21);
  a04=(a04*a19);
  a05=(a05-a04);
  a18=(a18+a05);
  if (res[0]!=0) res[0][5]=a18;
  if (res[0]!=0) res[0][6]=a10;
  return 0;
}

CASADI_SYMBOL_EXPORT int fwd1_linear_rhs(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f1(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int fwd1_linear_rhs_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void fwd1_linear_rhs_release(int mem) {
}

CASADI_SYMBOL_EXPORT void fwd1_linear_rhs_incref(void) {
}

CASADI_SYMBOL_EXPORT void fwd1_linear_rhs_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int fwd1_linear_rhs_n_in(void) { return 7;}

CASADI_SYMBOL_EXPORT casadi_int fwd1_linear_rhs_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real fwd1_linear_rhs_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* fwd1_linear_rhs_name_in(casadi_int i) {
  switch (i) {
    case 0: return "x";
    case 1: return "u";
    case 2: return "p";
    case 3: return "out_xdot";
    case 4: return "fwd_x";
    case 5: return "fwd_u";
    case 6: return "fwd_p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* fwd1_linear_rhs_name_out(casadi_int i) {
  switch (i) {
    case 0: return "fwd_xdot";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* fwd1_linear_rhs_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    case 3: return casadi_s3;
    case 4: return casadi_s0;
    case 5: return casadi_s1;
    case 6: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* fwd1_linear_rhs_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int fwd1_linear_rhs_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 7;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int fwd1_linear_rhs_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 7*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* adj1_linear_rhs:(x[7],u,p[11],out_xdot[7x1,0nz],adj_xdot[7])->(adj_x[7],adj_u,adj_p[11]) */
static int casadi_f2(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34;
  a00=arg[0]? arg[0][6] : 0;
  a01=cos(a00);
  a02=arg[4]? arg[4][5] : 0;
  a01=(a01*a02);
  a03=sin(a00);
  a04=arg[4]? arg[4][4] : 0;
  a03=(a03*a04);
  a01=(a01-a03);
  a03=arg[4]? arg[4][2] : 0;
  a01=(a01+a03);
  a03=arg[2]? arg[2][9] : 0;
  a05=arg[2]? arg[2][3] : 0;
  a06=arg[4]? arg[4][1] : 0;
  a07=arg[2]? arg[2][1] : 0;
  a08=(a06/a07);
  a09=(a05*a08);
  a10=arg[4]? arg[4][0] : 0;
  a11=arg[2]? arg[2][0] : 0;
  a12=(a10/a11);
  a09=(a09-a12);
  a13=(a03*a09);
  a14=5.0000000000000000e-01;
  a15=arg[2]? arg[2][6] : 0;
  a15=(a14*a15);
  a16=arg[2]? arg[2][7] : 0;
  a17=(a15*a16);
  a18=arg[2]? arg[2][5] : 0;
  a19=arg[2]? arg[2][4] : 0;
  a20=casadi_sq(a19);
  a21=(a05*a08);
  a21=(a21-a12);
  a22=(a20*a21);
  a23=(a18*a22);
  a24=(a17*a23);
  a13=(a13+a24);
  a24=(a13/a19);
  a01=(a01+a24);
  a25=arg[2]? arg[2][8] : 0;
  a26=arg[2]? arg[2][2] : 0;
  a27=(a26*a08);
  a27=(a27+a12);
  a27=(-a27);
  a27=(2.*a27);
  a28=(a25*a27);
  a29=(a28/a19);
  a01=(a01+a29);
  if (res[0]!=0) res[0][0]=a01;
  a01=arg[4]? arg[4][6] : 0;
  a30=arg[4]? arg[4][3] : 0;
  a01=(a01+a30);
  a30=(a19*a10);
  a01=(a01-a30);
  a30=(a05*a24);
  a01=(a01-a30);
  a30=(a26*a29);
  a01=(a01+a30);
  if (res[0]!=0) res[0][1]=a01;
  a01=0.;
  if (res[0]!=0) res[0][2]=a01;
  if (res[0]!=0) res[0][3]=a01;
  if (res[0]!=0) res[0][4]=a01;
  if (res[0]!=0) res[0][5]=a01;
  a30=cos(a00);
  a31=(a19*a02);
  a30=(a30*a31);
  a31=sin(a00);
  a32=arg[0]? arg[0][0] : 0;
  a33=(a32*a02);
  a31=(a31*a33);
  a30=(a30-a31);
  a31=cos(a00);
  a33=(a32*a04);
  a31=(a31*a33);
  a30=(a30-a31);
  a31=sin(a00);
  a33=(a19*a04);
  a31=(a31*a33);
  a30=(a30-a31);
  if (res[0]!=0) res[0][6]=a30;
  a30=(a05*a08);
  a12=(a12-a30);
  if (res[1]!=0) res[1][0]=a12;
  a12=arg[1]? arg[1][0] : 0;
  a30=arg[0]? arg[0][1] : 0;
  a31=(a26*a30);
  a31=(a31+a32);
  a31=(a31/a19);
  a25=(a25*a31);
  a25=(2.*a25);
  a33=(a12-a25);
  a34=(a05*a30);
  a32=(a32-a34);
  a32=(a32/a19);
  a17=(a17*a32);
  a18=(a17*a18);
  a20=(a18*a20);
  a33=(a33-a20);
  a03=(a03*a32);
  a33=(a33-a03);
  a33=(a33/a11);
  a33=(a33/a11);
  a33=(a33*a10);
  a33=(-a33);
  if (res[2]!=0) res[2][0]=a33;
  a33=(a20*a05);
  a11=(a12*a05);
  a26=(a25*a26);
  a11=(a11+a26);
  a33=(a33-a11);
  a05=(a03*a05);
  a33=(a33+a05);
  a33=(a33/a07);
  a33=(a33/a07);
  a33=(a33*a06);
  a33=(-a33);
  if (res[2]!=0) res[2][1]=a33;
  a29=(a30*a29);
  a25=(a25*a08);
  a29=(a29-a25);
  if (res[2]!=0) res[2][2]=a29;
  a03=(a03*a08);
  a12=(a12*a08);
  a03=(a03-a12);
  a20=(a20*a08);
  a03=(a03+a20);
  a24=(a30*a24);
  a03=(a03-a24);
  if (res[2]!=0) res[2][3]=a03;
  a03=sin(a00);
  a03=(a03*a02);
  a00=cos(a00);
  a00=(a00*a04);
  a03=(a03+a00);
  a30=(a30*a10);
  a03=(a03-a30);
  a30=(2.*a19);
  a18=(a18*a21);
  a30=(a30*a18);
  a03=(a03+a30);
  a30=(a32/a19);
  a30=(a30*a13);
  a03=(a03-a30);
  a19=(a31/a19);
  a19=(a19*a28);
  a03=(a03-a19);
  if (res[2]!=0) res[2][4]=a03;
  a17=(a17*a22);
  if (res[2]!=0) res[2][5]=a17;
  a23=(a32*a23);
  a16=(a16*a23);
  a14=(a14*a16);
  if (res[2]!=0) res[2][6]=a14;
  a15=(a15*a23);
  if (res[2]!=0) res[2][7]=a15;
  a31=(a31*a27);
  if (res[2]!=0) res[2][8]=a31;
  a32=(a32*a09);
  if (res[2]!=0) res[2][9]=a32;
  if (res[2]!=0) res[2][10]=a01;
  return 0;
}

CASADI_SYMBOL_EXPORT int adj1_linear_rhs(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f2(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int adj1_linear_rhs_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void adj1_linear_rhs_release(int mem) {
}

CASADI_SYMBOL_EXPORT void adj1_linear_rhs_incref(void) {
}

CASADI_SYMBOL_EXPORT void adj1_linear_rhs_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int adj1_linear_rhs_n_in(void) { return 5;}

CASADI_SYMBOL_EXPORT casadi_int adj1_linear_rhs_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real adj1_linear_rhs_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* adj1_linear_rhs_name_in(casadi_int i) {
  switch (i) {
    case 0: return "x";
    case 1: return "u";
    case 2: return "p";
    case 3: return "out_xdot";
    case 4: return "adj_xdot";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* adj1_linear_rhs_name_out(casadi_int i) {
  switch (i) {
    case 0: return "adj_x";
    case 1: return "adj_u";
    case 2: return "adj_p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* adj1_linear_rhs_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    case 3: return casadi_s3;
    case 4: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* adj1_linear_rhs_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int adj1_linear_rhs_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int adj1_linear_rhs_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* fwd1_adj1_linear_rhs:(x[7],u,p[11],out_xdot[7x1,0nz],adj_xdot[7],out_adj_x[7x1,0nz],out_adj_u[1x1,0nz],out_adj_p[11x1,0nz],fwd_x[7],fwd_u,fwd_p[11],fwd_out_xdot[7x1,0nz],fwd_adj_xdot[7])->(fwd_adj_x[7],fwd_adj_u,fwd_adj_p[11]) */
static int casadi_f3(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66;
  a00=arg[0]? arg[0][6] : 0;
  a01=cos(a00);
  a02=arg[12]? arg[12][5] : 0;
  a01=(a01*a02);
  a03=arg[4]? arg[4][5] : 0;
  a04=sin(a00);
  a05=arg[8]? arg[8][6] : 0;
  a04=(a04*a05);
  a04=(a03*a04);
  a01=(a01-a04);
  a04=arg[4]? arg[4][4] : 0;
  a06=cos(a00);
  a06=(a06*a05);
  a06=(a04*a06);
  a07=sin(a00);
  a08=arg[12]? arg[12][4] : 0;
  a07=(a07*a08);
  a06=(a06+a07);
  a01=(a01-a06);
  a06=arg[12]? arg[12][2] : 0;
  a01=(a01+a06);
  a06=arg[2]? arg[2][3] : 0;
  a07=arg[4]? arg[4][1] : 0;
  a09=arg[2]? arg[2][1] : 0;
  a10=(a07/a09);
  a11=(a06*a10);
  a12=arg[4]? arg[4][0] : 0;
  a13=arg[2]? arg[2][0] : 0;
  a14=(a12/a13);
  a11=(a11-a14);
  a15=arg[10]? arg[10][9] : 0;
  a16=(a11*a15);
  a17=arg[2]? arg[2][9] : 0;
  a18=arg[10]? arg[10][3] : 0;
  a19=(a10*a18);
  a20=arg[12]? arg[12][1] : 0;
  a21=(a20/a09);
  a22=(a10/a09);
  a23=arg[10]? arg[10][1] : 0;
  a22=(a22*a23);
  a21=(a21-a22);
  a22=(a06*a21);
  a19=(a19+a22);
  a22=arg[12]? arg[12][0] : 0;
  a24=(a22/a13);
  a25=(a14/a13);
  a26=arg[10]? arg[10][0] : 0;
  a25=(a25*a26);
  a24=(a24-a25);
  a19=(a19-a24);
  a25=(a17*a19);
  a16=(a16+a25);
  a25=arg[2]? arg[2][5] : 0;
  a27=arg[2]? arg[2][4] : 0;
  a28=casadi_sq(a27);
  a29=(a06*a10);
  a29=(a29-a14);
  a30=(a28*a29);
  a31=(a25*a30);
  a32=arg[2]? arg[2][7] : 0;
  a33=5.0000000000000000e-01;
  a34=arg[10]? arg[10][6] : 0;
  a34=(a33*a34);
  a35=(a32*a34);
  a36=arg[2]? arg[2][6] : 0;
  a36=(a33*a36);
  a37=arg[10]? arg[10][7] : 0;
  a38=(a36*a37);
  a35=(a35+a38);
  a38=(a31*a35);
  a39=(a36*a32);
  a40=arg[10]? arg[10][5] : 0;
  a41=(a30*a40);
  a42=(2.*a27);
  a43=arg[10]? arg[10][4] : 0;
  a42=(a42*a43);
  a44=(a29*a42);
  a45=(a10*a18);
  a46=(a06*a21);
  a45=(a45+a46);
  a45=(a45-a24);
  a46=(a28*a45);
  a44=(a44+a46);
  a46=(a25*a44);
  a41=(a41+a46);
  a46=(a39*a41);
  a38=(a38+a46);
  a16=(a16+a38);
  a38=(a16/a27);
  a46=(a17*a11);
  a47=(a39*a31);
  a46=(a46+a47);
  a47=(a46/a27);
  a48=(a47/a27);
  a48=(a48*a43);
  a38=(a38-a48);
  a01=(a01+a38);
  a48=arg[2]? arg[2][2] : 0;
  a49=(a48*a10);
  a49=(a49+a14);
  a49=(-a49);
  a49=(2.*a49);
  a14=arg[10]? arg[10][8] : 0;
  a50=(a49*a14);
  a51=arg[2]? arg[2][8] : 0;
  a52=arg[10]? arg[10][2] : 0;
  a53=(a10*a52);
  a54=(a48*a21);
  a53=(a53+a54);
  a53=(a53+a24);
  a53=(-a53);
  a53=(2.*a53);
  a54=(a51*a53);
  a50=(a50+a54);
  a54=(a50/a27);
  a55=(a51*a49);
  a56=(a55/a27);
  a57=(a56/a27);
  a57=(a57*a43);
  a54=(a54-a57);
  a01=(a01+a54);
  if (res[0]!=0) res[0][0]=a01;
  a01=arg[12]? arg[12][6] : 0;
  a57=arg[12]? arg[12][3] : 0;
  a01=(a01+a57);
  a57=(a12*a43);
  a58=(a27*a22);
  a57=(a57+a58);
  a01=(a01-a57);
  a57=(a47*a18);
  a58=(a06*a38);
  a57=(a57+a58);
  a01=(a01-a57);
  a57=(a56*a52);
  a58=(a48*a54);
  a57=(a57+a58);
  a01=(a01+a57);
  if (res[0]!=0) res[0][1]=a01;
  a01=0.;
  if (res[0]!=0) res[0][2]=a01;
  if (res[0]!=0) res[0][3]=a01;
  if (res[0]!=0) res[0][4]=a01;
  if (res[0]!=0) res[0][5]=a01;
  a57=cos(a00);
  a58=(a03*a43);
  a59=(a27*a02);
  a58=(a58+a59);
  a57=(a57*a58);
  a58=(a27*a03);
  a59=sin(a00);
  a59=(a59*a05);
  a58=(a58*a59);
  a57=(a57-a58);
  a58=arg[0]? arg[0][0] : 0;
  a59=(a58*a03);
  a60=cos(a00);
  a60=(a60*a05);
  a59=(a59*a60);
  a60=sin(a00);
  a61=arg[8]? arg[8][0] : 0;
  a62=(a03*a61);
  a63=(a58*a02);
  a62=(a62+a63);
  a60=(a60*a62);
  a59=(a59+a60);
  a57=(a57-a59);
  a59=cos(a00);
  a60=(a04*a61);
  a62=(a58*a08);
  a60=(a60+a62);
  a59=(a59*a60);
  a60=(a58*a04);
  a62=sin(a00);
  a62=(a62*a05);
  a60=(a60*a62);
  a59=(a59-a60);
  a57=(a57-a59);
  a59=(a27*a04);
  a60=cos(a00);
  a60=(a60*a05);
  a59=(a59*a60);
  a60=sin(a00);
  a62=(a04*a43);
  a63=(a27*a08);
  a62=(a62+a63);
  a60=(a60*a62);
  a59=(a59+a60);
  a57=(a57-a59);
  if (res[0]!=0) res[0][6]=a57;
  a57=(a10*a18);
  a59=(a06*a21);
  a57=(a57+a59);
  a24=(a24-a57);
  if (res[1]!=0) res[1][0]=a24;
  a24=arg[9]? arg[9][0] : 0;
  a57=arg[0]? arg[0][1] : 0;
  a59=(a48*a57);
  a59=(a59+a58);
  a59=(a59/a27);
  a14=(a59*a14);
  a60=(a57*a52);
  a62=arg[8]? arg[8][1] : 0;
  a63=(a48*a62);
  a60=(a60+a63);
  a60=(a60+a61);
  a60=(a60/a27);
  a63=(a59/a27);
  a63=(a63*a43);
  a60=(a60-a63);
  a63=(a51*a60);
  a14=(a14+a63);
  a14=(2.*a14);
  a63=(a24-a14);
  a64=(a06*a57);
  a58=(a58-a64);
  a58=(a58/a27);
  a35=(a58*a35);
  a64=(a57*a18);
  a65=(a06*a62);
  a64=(a64+a65);
  a61=(a61-a64);
  a61=(a61/a27);
  a64=(a58/a27);
  a64=(a64*a43);
  a61=(a61-a64);
  a64=(a39*a61);
  a35=(a35+a64);
  a64=(a25*a35);
  a39=(a39*a58);
  a40=(a39*a40);
  a64=(a64+a40);
  a40=(a28*a64);
  a25=(a39*a25);
  a42=(a25*a42);
  a40=(a40+a42);
  a63=(a63-a40);
  a15=(a58*a15);
  a42=(a17*a61);
  a15=(a15+a42);
  a63=(a63-a15);
  a63=(a63/a13);
  a42=arg[1]? arg[1][0] : 0;
  a51=(a51*a59);
  a51=(2.*a51);
  a65=(a42-a51);
  a28=(a25*a28);
  a65=(a65-a28);
  a17=(a17*a58);
  a65=(a65-a17);
  a65=(a65/a13);
  a66=(a65/a13);
  a66=(a66*a26);
  a63=(a63-a66);
  a63=(a63/a13);
  a65=(a65/a13);
  a13=(a65/a13);
  a13=(a13*a26);
  a63=(a63-a13);
  a63=(a12*a63);
  a65=(a65*a22);
  a63=(a63+a65);
  a63=(-a63);
  if (res[2]!=0) res[2][0]=a63;
  a63=(a06*a40);
  a65=(a28*a18);
  a63=(a63+a65);
  a65=(a06*a24);
  a13=(a42*a18);
  a65=(a65+a13);
  a13=(a48*a14);
  a52=(a51*a52);
  a13=(a13+a52);
  a65=(a65+a13);
  a63=(a63-a65);
  a65=(a06*a15);
  a18=(a17*a18);
  a65=(a65+a18);
  a63=(a63+a65);
  a63=(a63/a09);
  a65=(a28*a06);
  a18=(a42*a06);
  a48=(a51*a48);
  a18=(a18+a48);
  a65=(a65-a18);
  a06=(a17*a06);
  a65=(a65+a06);
  a65=(a65/a09);
  a06=(a65/a09);
  a06=(a06*a23);
  a63=(a63-a06);
  a63=(a63/a09);
  a65=(a65/a09);
  a09=(a65/a09);
  a09=(a09*a23);
  a63=(a63-a09);
  a07=(a07*a63);
  a65=(a65*a20);
  a07=(a07+a65);
  a07=(-a07);
  if (res[2]!=0) res[2][1]=a07;
  a56=(a56*a62);
  a54=(a57*a54);
  a56=(a56+a54);
  a14=(a10*a14);
  a51=(a51*a21);
  a14=(a14+a51);
  a56=(a56-a14);
  if (res[2]!=0) res[2][2]=a56;
  a15=(a10*a15);
  a17=(a17*a21);
  a15=(a15+a17);
  a24=(a10*a24);
  a42=(a42*a21);
  a24=(a24+a42);
  a15=(a15-a24);
  a10=(a10*a40);
  a28=(a28*a21);
  a10=(a10+a28);
  a15=(a15+a10);
  a47=(a47*a62);
  a38=(a57*a38);
  a47=(a47+a38);
  a15=(a15-a47);
  if (res[2]!=0) res[2][3]=a15;
  a15=cos(a00);
  a15=(a15*a05);
  a03=(a03*a15);
  a15=sin(a00);
  a15=(a15*a02);
  a03=(a03+a15);
  a15=cos(a00);
  a15=(a15*a08);
  a00=sin(a00);
  a00=(a00*a05);
  a04=(a04*a00);
  a15=(a15-a04);
  a03=(a03+a15);
  a12=(a12*a62);
  a57=(a57*a22);
  a12=(a12+a57);
  a03=(a03-a12);
  a12=(a25*a29);
  a57=(2.*a43);
  a12=(a12*a57);
  a57=(2.*a27);
  a29=(a29*a64);
  a25=(a25*a45);
  a29=(a29+a25);
  a57=(a57*a29);
  a12=(a12+a57);
  a03=(a03+a12);
  a12=(a61/a27);
  a57=(a58/a27);
  a29=(a57/a27);
  a29=(a29*a43);
  a12=(a12-a29);
  a46=(a46*a12);
  a57=(a57*a16);
  a46=(a46+a57);
  a03=(a03-a46);
  a46=(a60/a27);
  a57=(a59/a27);
  a27=(a57/a27);
  a27=(a27*a43);
  a46=(a46-a27);
  a55=(a55*a46);
  a57=(a57*a50);
  a55=(a55+a57);
  a03=(a03-a55);
  if (res[2]!=0) res[2][4]=a03;
  a30=(a30*a35);
  a39=(a39*a44);
  a30=(a30+a39);
  if (res[2]!=0) res[2][5]=a30;
  a30=(a58*a31);
  a37=(a30*a37);
  a31=(a31*a61);
  a41=(a58*a41);
  a31=(a31+a41);
  a32=(a32*a31);
  a37=(a37+a32);
  a33=(a33*a37);
  if (res[2]!=0) res[2][6]=a33;
  a30=(a30*a34);
  a36=(a36*a31);
  a30=(a30+a36);
  if (res[2]!=0) res[2][7]=a30;
  a49=(a49*a60);
  a59=(a59*a53);
  a49=(a49+a59);
  if (res[2]!=0) res[2][8]=a49;
  a11=(a11*a61);
  a58=(a58*a19);
  a11=(a11+a58);
  if (res[2]!=0) res[2][9]=a11;
  if (res[2]!=0) res[2][10]=a01;
  return 0;
}

CASADI_SYMBOL_EXPORT int fwd1_adj1_linear_rhs(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f3(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int fwd1_adj1_linear_rhs_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void fwd1_adj1_linear_rhs_release(int mem) {
}

CASADI_SYMBOL_EXPORT void fwd1_adj1_linear_rhs_incref(void) {
}

CASADI_SYMBOL_EXPORT void fwd1_adj1_linear_rhs_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_linear_rhs_n_in(void) { return 13;}

CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_linear_rhs_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_linear_rhs_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* fwd1_adj1_linear_rhs_name_in(casadi_int i) {
  switch (i) {
    case 0: return "x";
    case 1: return "u";
    case 2: return "p";
    case 3: return "out_xdot";
    case 4: return "adj_xdot";
    case 5: return "out_adj_x";
    case 6: return "out_adj_u";
    case 7: return "out_adj_p";
    case 8: return "fwd_x";
    case 9: return "fwd_u";
    case 10: return "fwd_p";
    case 11: return "fwd_out_xdot";
    case 12: return "fwd_adj_xdot";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* fwd1_adj1_linear_rhs_name_out(casadi_int i) {
  switch (i) {
    case 0: return "fwd_adj_x";
    case 1: return "fwd_adj_u";
    case 2: return "fwd_adj_p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_linear_rhs_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    case 3: return casadi_s3;
    case 4: return casadi_s0;
    case 5: return casadi_s3;
    case 6: return casadi_s4;
    case 7: return casadi_s5;
    case 8: return casadi_s0;
    case 9: return casadi_s1;
    case 10: return casadi_s2;
    case 11: return casadi_s3;
    case 12: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_linear_rhs_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int fwd1_adj1_linear_rhs_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 13;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int fwd1_adj1_linear_rhs_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 13*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* linear_outputs:(x[7],u,p[11])->(y[10]) */
static int casadi_f4(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1, a2, a3, a4, a5, a6, a7, a8;
  a0=arg[2]? arg[2][2] : 0;
  a1=arg[0]? arg[0][1] : 0;
  a2=(a0*a1);
  a3=arg[0]? arg[0][0] : 0;
  a2=(a2+a3);
  a4=arg[2]? arg[2][4] : 0;
  a2=(a2/a4);
  if (res[0]!=0) res[0][0]=a2;
  a5=arg[2]? arg[2][3] : 0;
  a1=(a5*a1);
  a1=(a3-a1);
  a1=(a1/a4);
  if (res[0]!=0) res[0][1]=a1;
  a3=(a3/a4);
  if (res[0]!=0) res[0][2]=a3;
  a3=arg[2]? arg[2][8] : 0;
  a3=(a3*a2);
  a3=(2.*a3);
  if (res[0]!=0) res[0][3]=a3;
  a2=5.0000000000000000e-01;
  a6=arg[2]? arg[2][6] : 0;
  a2=(a2*a6);
  a6=arg[2]? arg[2][7] : 0;
  a2=(a2*a6);
  a2=(a2*a1);
  a6=arg[2]? arg[2][5] : 0;
  a2=(a2*a6);
  a4=casadi_sq(a4);
  a2=(a2*a4);
  if (res[0]!=0) res[0][4]=a2;
  a4=arg[2]? arg[2][9] : 0;
  a4=(a4*a1);
  if (res[0]!=0) res[0][5]=a4;
  a1=arg[1]? arg[1][0] : 0;
  a6=(a1-a3);
  a6=(a6-a2);
  a6=(a6-a4);
  a7=arg[2]? arg[2][0] : 0;
  a8=(a6/a7);
  if (res[0]!=0) res[0][6]=a8;
  if (res[0]!=0) res[0][7]=a6;
  a2=(a2*a5);
  a1=(a1*a5);
  a3=(a3*a0);
  a1=(a1+a3);
  a2=(a2-a1);
  a4=(a4*a5);
  a2=(a2+a4);
  if (res[0]!=0) res[0][8]=a2;
  a2=arg[2]? arg[2][10] : 0;
  a2=(a2*a7);
  if (res[0]!=0) res[0][9]=a2;
  return 0;
}

CASADI_SYMBOL_EXPORT int linear_outputs(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f4(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int linear_outputs_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void linear_outputs_release(int mem) {
}

CASADI_SYMBOL_EXPORT void linear_outputs_incref(void) {
}

CASADI_SYMBOL_EXPORT void linear_outputs_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int linear_outputs_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int linear_outputs_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real linear_outputs_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* linear_outputs_name_in(casadi_int i) {
  switch (i) {
    case 0: return "x";
    case 1: return "u";
    case 2: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* linear_outputs_name_out(casadi_int i) {
  switch (i) {
    case 0: return "y";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* linear_outputs_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* linear_outputs_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int linear_outputs_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int linear_outputs_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* fwd1_linear_outputs:(x[7],u,p[11],out_y[10x1,0nz],fwd_x[7],fwd_u,fwd_p[11])->(fwd_y[10]) */
static int casadi_f5(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17;
  a00=arg[0]? arg[0][1] : 0;
  a01=arg[6]? arg[6][2] : 0;
  a02=(a00*a01);
  a03=arg[2]? arg[2][2] : 0;
  a04=arg[4]? arg[4][1] : 0;
  a05=(a03*a04);
  a02=(a02+a05);
  a05=arg[4]? arg[4][0] : 0;
  a02=(a02+a05);
  a06=arg[2]? arg[2][4] : 0;
  a02=(a02/a06);
  a07=(a03*a00);
  a08=arg[0]? arg[0][0] : 0;
  a07=(a07+a08);
  a07=(a07/a06);
  a09=(a07/a06);
  a10=arg[6]? arg[6][4] : 0;
  a09=(a09*a10);
  a02=(a02-a09);
  if (res[0]!=0) res[0][0]=a02;
  a09=arg[6]? arg[6][3] : 0;
  a11=(a00*a09);
  a12=arg[2]? arg[2][3] : 0;
  a04=(a12*a04);
  a11=(a11+a04);
  a11=(a05-a11);
  a11=(a11/a06);
  a00=(a12*a00);
  a00=(a08-a00);
  a00=(a00/a06);
  a04=(a00/a06);
  a04=(a04*a10);
  a11=(a11-a04);
  if (res[0]!=0) res[0][1]=a11;
  a05=(a05/a06);
  a08=(a08/a06);
  a08=(a08/a06);
  a08=(a08*a10);
  a05=(a05-a08);
  if (res[0]!=0) res[0][2]=a05;
  a05=arg[6]? arg[6][8] : 0;
  a05=(a07*a05);
  a08=arg[2]? arg[2][8] : 0;
  a02=(a08*a02);
  a05=(a05+a02);
  a05=(2.*a05);
  if (res[0]!=0) res[0][3]=a05;
  a02=casadi_sq(a06);
  a04=arg[2]? arg[2][5] : 0;
  a13=arg[2]? arg[2][7] : 0;
  a14=5.0000000000000000e-01;
  a15=arg[6]? arg[6][6] : 0;
  a15=(a14*a15);
  a15=(a13*a15);
  a16=arg[2]? arg[2][6] : 0;
  a14=(a14*a16);
  a16=arg[6]? arg[6][7] : 0;
  a16=(a14*a16);
  a15=(a15+a16);
  a15=(a00*a15);
  a14=(a14*a13);
  a13=(a14*a11);
  a15=(a15+a13);
  a15=(a04*a15);
  a14=(a14*a00);
  a13=arg[6]? arg[6][5] : 0;
  a13=(a14*a13);
  a15=(a15+a13);
  a15=(a02*a15);
  a14=(a14*a04);
  a06=(2.*a06);
  a06=(a06*a10);
  a06=(a14*a06);
  a15=(a15+a06);
  if (res[0]!=0) res[0][4]=a15;
  a06=arg[6]? arg[6][9] : 0;
  a06=(a00*a06);
  a10=arg[2]? arg[2][9] : 0;
  a11=(a10*a11);
  a06=(a06+a11);
  if (res[0]!=0) res[0][5]=a06;
  a11=arg[5]? arg[5][0] : 0;
  a04=(a11-a05);
  a04=(a04-a15);
  a04=(a04-a06);
  a13=arg[2]? arg[2][0] : 0;
  a16=(a04/a13);
  a17=arg[1]? arg[1][0] : 0;
  a08=(a08*a07);
  a08=(2.*a08);
  a07=(a17-a08);
  a14=(a14*a02);
  a07=(a07-a14);
  a10=(a10*a00);
  a07=(a07-a10);
  a07=(a07/a13);
  a07=(a07/a13);
  a00=arg[6]? arg[6][0] : 0;
  a07=(a07*a00);
  a16=(a16-a07);
  if (res[0]!=0) res[0][6]=a16;
  if (res[0]!=0) res[0][7]=a04;
  a15=(a12*a15);
  a14=(a14*a09);
  a15=(a15+a14);
  a11=(a12*a11);
  a17=(a17*a09);
  a11=(a11+a17);
  a03=(a03*a05);
  a08=(a08*a01);
  a03=(a03+a08);
  a11=(a11+a03);
  a15=(a15-a11);
  a12=(a12*a06);
  a10=(a10*a09);
  a12=(a12+a10);
  a15=(a15+a12);
  if (res[0]!=0) res[0][8]=a15;
  a15=arg[6]? arg[6][10] : 0;
  a13=(a13*a15);
  a15=arg[2]? arg[2][10] : 0;
  a15=(a15*a00);
  a13=(a13+a15);
  if (res[0]!=0) res[0][9]=a13;
  return 0;
}

CASADI_SYMBOL_EXPORT int fwd1_linear_outputs(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f5(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int fwd1_linear_outputs_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void fwd1_linear_outputs_release(int mem) {
}

CASADI_SYMBOL_EXPORT void fwd1_linear_outputs_incref(void) {
}

CASADI_SYMBOL_EXPORT void fwd1_linear_outputs_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int fwd1_linear_outputs_n_in(void) { return 7;}

CASADI_SYMBOL_EXPORT casadi_int fwd1_linear_outputs_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real fwd1_linear_outputs_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* fwd1_linear_outputs_name_in(casadi_int i) {
  switch (i) {
    case 0: return "x";
    case 1: return "u";
    case 2: return "p";
    case 3: return "out_y";
    case 4: return "fwd_x";
    case 5: return "fwd_u";
    case 6: return "fwd_p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* fwd1_linear_outputs_name_out(casadi_int i) {
  switch (i) {
    case 0: return "fwd_y";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* fwd1_linear_outputs_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    case 3: return casadi_s7;
    case 4: return casadi_s0;
    case 5: return casadi_s1;
    case 6: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* fwd1_linear_outputs_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int fwd1_linear_outputs_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 7;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int fwd1_linear_outputs_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 7*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* adj1_linear_outputs:(x[7],u,p[11],out_y[10x1,0nz],adj_y[10])->(adj_x[7],adj_u,adj_p[11]) */
static int casadi_f6(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30;
  a00=arg[4]? arg[4][2] : 0;
  a01=arg[2]? arg[2][4] : 0;
  a02=(a00/a01);
  a03=arg[2]? arg[2][9] : 0;
  a04=arg[2]? arg[2][3] : 0;
  a05=arg[4]? arg[4][8] : 0;
  a06=(a04*a05);
  a07=arg[4]? arg[4][7] : 0;
  a08=arg[4]? arg[4][6] : 0;
  a09=arg[2]? arg[2][0] : 0;
  a10=(a08/a09);
  a07=(a07+a10);
  a06=(a06-a07);
  a10=arg[4]? arg[4][5] : 0;
  a06=(a06+a10);
  a10=(a03*a06);
  a11=5.0000000000000000e-01;
  a12=arg[2]? arg[2][6] : 0;
  a12=(a11*a12);
  a13=arg[2]? arg[2][7] : 0;
  a14=(a12*a13);
  a15=arg[2]? arg[2][5] : 0;
  a16=casadi_sq(a01);
  a17=(a04*a05);
  a17=(a17-a07);
  a18=arg[4]? arg[4][4] : 0;
  a17=(a17+a18);
  a18=(a16*a17);
  a19=(a15*a18);
  a20=(a14*a19);
  a10=(a10+a20);
  a20=arg[4]? arg[4][1] : 0;
  a10=(a10+a20);
  a20=(a10/a01);
  a02=(a02+a20);
  a21=arg[2]? arg[2][8] : 0;
  a22=arg[4]? arg[4][3] : 0;
  a23=arg[2]? arg[2][2] : 0;
  a24=(a23*a05);
  a24=(a24+a07);
  a22=(a22-a24);
  a22=(2.*a22);
  a24=(a21*a22);
  a25=arg[4]? arg[4][0] : 0;
  a24=(a24+a25);
  a25=(a24/a01);
  a02=(a02+a25);
  if (res[0]!=0) res[0][0]=a02;
  a02=(a23*a25);
  a26=(a04*a20);
  a02=(a02-a26);
  if (res[0]!=0) res[0][1]=a02;
  a02=0.;
  if (res[0]!=0) res[0][2]=a02;
  if (res[0]!=0) res[0][3]=a02;
  if (res[0]!=0) res[0][4]=a02;
  if (res[0]!=0) res[0][5]=a02;
  if (res[0]!=0) res[0][6]=a02;
  a26=(a04*a05);
  a07=(a07-a26);
  if (res[1]!=0) res[1][0]=a07;
  a07=arg[2]? arg[2][10] : 0;
  a26=arg[4]? arg[4][9] : 0;
  a07=(a07*a26);
  a27=arg[1]? arg[1][0] : 0;
  a28=arg[0]? arg[0][1] : 0;
  a23=(a23*a28);
  a29=arg[0]? arg[0][0] : 0;
  a23=(a23+a29);
  a23=(a23/a01);
  a21=(a21*a23);
  a21=(2.*a21);
  a30=(a27-a21);
  a04=(a04*a28);
  a04=(a29-a04);
  a04=(a04/a01);
  a14=(a14*a04);
  a15=(a14*a15);
  a16=(a15*a16);
  a30=(a30-a16);
  a03=(a03*a04);
  a30=(a30-a03);
  a30=(a30/a09);
  a30=(a30/a09);
  a30=(a30*a08);
  a07=(a07-a30);
  if (res[2]!=0) res[2][0]=a07;
  if (res[2]!=0) res[2][1]=a02;
  a25=(a28*a25);
  a21=(a21*a05);
  a25=(a25-a21);
  if (res[2]!=0) res[2][2]=a25;
  a03=(a03*a05);
  a27=(a27*a05);
  a03=(a03-a27);
  a16=(a16*a05);
  a03=(a03+a16);
  a28=(a28*a20);
  a03=(a03-a28);
  if (res[2]!=0) res[2][3]=a03;
  a03=(2.*a01);
  a15=(a15*a17);
  a03=(a03*a15);
  a29=(a29/a01);
  a29=(a29/a01);
  a29=(a29*a00);
  a03=(a03-a29);
  a29=(a04/a01);
  a29=(a29*a10);
  a03=(a03-a29);
  a01=(a23/a01);
  a01=(a01*a24);
  a03=(a03-a01);
  if (res[2]!=0) res[2][4]=a03;
  a14=(a14*a18);
  if (res[2]!=0) res[2][5]=a14;
  a19=(a04*a19);
  a13=(a13*a19);
  a11=(a11*a13);
  if (res[2]!=0) res[2][6]=a11;
  a12=(a12*a19);
  if (res[2]!=0) res[2][7]=a12;
  a23=(a23*a22);
  if (res[2]!=0) res[2][8]=a23;
  a04=(a04*a06);
  if (res[2]!=0) res[2][9]=a04;
  a09=(a09*a26);
  if (res[2]!=0) res[2][10]=a09;
  return 0;
}

CASADI_SYMBOL_EXPORT int adj1_linear_outputs(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f6(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int adj1_linear_outputs_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void adj1_linear_outputs_release(int mem) {
}

CASADI_SYMBOL_EXPORT void adj1_linear_outputs_incref(void) {
}

CASADI_SYMBOL_EXPORT void adj1_linear_outputs_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int adj1_linear_outputs_n_in(void) { return 5;}

CASADI_SYMBOL_EXPORT casadi_int adj1_linear_outputs_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real adj1_linear_outputs_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* adj1_linear_outputs_name_in(casadi_int i) {
  switch (i) {
    case 0: return "x";
    case 1: return "u";
    case 2: return "p";
    case 3: return "out_y";
    case 4: return "adj_y";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* adj1_linear_outputs_name_out(casadi_int i) {
  switch (i) {
    case 0: return "adj_x";
    case 1: return "adj_u";
    case 2: return "adj_p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* adj1_linear_outputs_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    case 3: return casadi_s7;
    case 4: return casadi_s6;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* adj1_linear_outputs_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int adj1_linear_outputs_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int adj1_linear_outputs_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* fwd1_adj1_linear_outputs:(x[7],u,p[11],out_y[10x1,0nz],adj_y[10],out_adj_x[7x1,0nz],out_adj_u[1x1,0nz],out_adj_p[11x1,0nz],fwd_x[7],fwd_u,fwd_p[11],fwd_out_y[10x1,0nz],fwd_adj_y[10])->(fwd_adj_x[7],fwd_adj_u,fwd_adj_p[11]) */
static int casadi_f7(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  a00=arg[12]? arg[12][2] : 0;
  a01=arg[2]? arg[2][4] : 0;
  a02=(a00/a01);
  a03=arg[4]? arg[4][2] : 0;
  a04=(a03/a01);
  a04=(a04/a01);
  a05=arg[10]? arg[10][4] : 0;
  a04=(a04*a05);
  a02=(a02-a04);
  a04=arg[2]? arg[2][3] : 0;
  a06=arg[4]? arg[4][8] : 0;
  a07=(a04*a06);
  a08=arg[4]? arg[4][7] : 0;
  a09=arg[4]? arg[4][6] : 0;
  a10=arg[2]? arg[2][0] : 0;
  a11=(a09/a10);
  a08=(a08+a11);
  a07=(a07-a08);
  a12=arg[4]? arg[4][5] : 0;
  a07=(a07+a12);
  a12=arg[10]? arg[10][9] : 0;
  a13=(a07*a12);
  a14=arg[2]? arg[2][9] : 0;
  a15=arg[10]? arg[10][3] : 0;
  a16=(a06*a15);
  a17=arg[12]? arg[12][8] : 0;
  a18=(a04*a17);
  a16=(a16+a18);
  a18=arg[12]? arg[12][7] : 0;
  a19=arg[12]? arg[12][6] : 0;
  a20=(a19/a10);
  a11=(a11/a10);
  a21=arg[10]? arg[10][0] : 0;
  a11=(a11*a21);
  a20=(a20-a11);
  a18=(a18+a20);
  a16=(a16-a18);
  a20=arg[12]? arg[12][5] : 0;
  a16=(a16+a20);
  a20=(a14*a16);
  a13=(a13+a20);
  a20=arg[2]? arg[2][5] : 0;
  a11=casadi_sq(a01);
  a22=(a04*a06);
  a22=(a22-a08);
  a23=arg[4]? arg[4][4] : 0;
  a22=(a22+a23);
  a23=(a11*a22);
  a24=(a20*a23);
  a25=arg[2]? arg[2][7] : 0;
  a26=5.0000000000000000e-01;
  a27=arg[10]? arg[10][6] : 0;
  a27=(a26*a27);
  a28=(a25*a27);
  a29=arg[2]? arg[2][6] : 0;
  a29=(a26*a29);
  a30=arg[10]? arg[10][7] : 0;
  a31=(a29*a30);
  a28=(a28+a31);
  a31=(a24*a28);
  a32=(a29*a25);
  a33=arg[10]? arg[10][5] : 0;
  a34=(a23*a33);
  a35=(2.*a01);
  a35=(a35*a05);
  a36=(a22*a35);
  a37=(a06*a15);
  a38=(a04*a17);
  a37=(a37+a38);
  a37=(a37-a18);
  a38=arg[12]? arg[12][4] : 0;
  a37=(a37+a38);
  a38=(a11*a37);
  a36=(a36+a38);
  a38=(a20*a36);
  a34=(a34+a38);
  a38=(a32*a34);
  a31=(a31+a38);
  a13=(a13+a31);
  a31=arg[12]? arg[12][1] : 0;
  a13=(a13+a31);
  a31=(a13/a01);
  a38=(a14*a07);
  a39=(a32*a24);
  a38=(a38+a39);
  a39=arg[4]? arg[4][1] : 0;
  a38=(a38+a39);
  a39=(a38/a01);
  a40=(a39/a01);
  a40=(a40*a05);
  a31=(a31-a40);
  a02=(a02+a31);
  a40=arg[4]? arg[4][3] : 0;
  a41=arg[2]? arg[2][2] : 0;
  a42=(a41*a06);
  a42=(a42+a08);
  a40=(a40-a42);
  a40=(2.*a40);
  a42=arg[10]? arg[10][8] : 0;
  a08=(a40*a42);
  a43=arg[2]? arg[2][8] : 0;
  a44=arg[12]? arg[12][3] : 0;
  a45=arg[10]? arg[10][2] : 0;
  a46=(a06*a45);
  a47=(a41*a17);
  a46=(a46+a47);
  a46=(a46+a18);
  a44=(a44-a46);
  a44=(2.*a44);
  a46=(a43*a44);
  a08=(a08+a46);
  a46=arg[12]? arg[12][0] : 0;
  a08=(a08+a46);
  a46=(a08/a01);
  a47=(a43*a40);
  a48=arg[4]? arg[4][0] : 0;
  a47=(a47+a48);
  a48=(a47/a01);
  a49=(a48/a01);
  a49=(a49*a05);
  a46=(a46-a49);
  a02=(a02+a46);
  if (res[0]!=0) res[0][0]=a02;
  a02=(a48*a45);
  a49=(a41*a46);
  a02=(a02+a49);
  a49=(a39*a15);
  a50=(a04*a31);
  a49=(a49+a50);
  a02=(a02-a49);
  if (res[0]!=0) res[0][1]=a02;
  a02=0.;
  if (res[0]!=0) res[0][2]=a02;
  if (res[0]!=0) res[0][3]=a02;
  if (res[0]!=0) res[0][4]=a02;
  if (res[0]!=0) res[0][5]=a02;
  if (res[0]!=0) res[0][6]=a02;
  a49=(a06*a15);
  a50=(a04*a17);
  a49=(a49+a50);
  a18=(a18-a49);
  if (res[1]!=0) res[1][0]=a18;
  a18=arg[4]? arg[4][9] : 0;
  a49=arg[10]? arg[10][10] : 0;
  a49=(a18*a49);
  a50=arg[2]? arg[2][10] : 0;
  a51=arg[12]? arg[12][9] : 0;
  a50=(a50*a51);
  a49=(a49+a50);
  a50=arg[9]? arg[9][0] : 0;
  a52=arg[0]? arg[0][1] : 0;
  a53=(a41*a52);
  a54=arg[0]? arg[0][0] : 0;
  a53=(a53+a54);
  a53=(a53/a01);
  a42=(a53*a42);
  a45=(a52*a45);
  a55=arg[8]? arg[8][1] : 0;
  a41=(a41*a55);
  a45=(a45+a41);
  a41=arg[8]? arg[8][0] : 0;
  a45=(a45+a41);
  a45=(a45/a01);
  a56=(a53/a01);
  a56=(a56*a05);
  a45=(a45-a56);
  a56=(a43*a45);
  a42=(a42+a56);
  a42=(2.*a42);
  a56=(a50-a42);
  a57=(a04*a52);
  a57=(a54-a57);
  a57=(a57/a01);
  a28=(a57*a28);
  a15=(a52*a15);
  a04=(a04*a55);
  a15=(a15+a04);
  a15=(a41-a15);
  a15=(a15/a01);
  a04=(a57/a01);
  a04=(a04*a05);
  a15=(a15-a04);
  a04=(a32*a15);
  a28=(a28+a04);
  a04=(a20*a28);
  a32=(a32*a57);
  a33=(a32*a33);
  a04=(a04+a33);
  a33=(a11*a04);
  a20=(a32*a20);
  a35=(a20*a35);
  a33=(a33+a35);
  a56=(a56-a33);
  a12=(a57*a12);
  a35=(a14*a15);
  a12=(a12+a35);
  a56=(a56-a12);
  a56=(a56/a10);
  a35=arg[1]? arg[1][0] : 0;
  a43=(a43*a53);
  a43=(2.*a43);
  a58=(a35-a43);
  a11=(a20*a11);
  a58=(a58-a11);
  a14=(a14*a57);
  a58=(a58-a14);
  a58=(a58/a10);
  a59=(a58/a10);
  a59=(a59*a21);
  a56=(a56-a59);
  a56=(a56/a10);
  a58=(a58/a10);
  a59=(a58/a10);
  a59=(a59*a21);
  a56=(a56-a59);
  a09=(a09*a56);
  a58=(a58*a19);
  a09=(a09+a58);
  a49=(a49-a09);
  if (res[2]!=0) res[2][0]=a49;
  if (res[2]!=0) res[2][1]=a02;
  a48=(a48*a55);
  a46=(a52*a46);
  a48=(a48+a46);
  a42=(a06*a42);
  a43=(a43*a17);
  a42=(a42+a43);
  a48=(a48-a42);
  if (res[2]!=0) res[2][2]=a48;
  a12=(a06*a12);
  a14=(a14*a17);
  a12=(a12+a14);
  a50=(a06*a50);
  a35=(a35*a17);
  a50=(a50+a35);
  a12=(a12-a50);
  a06=(a06*a33);
  a11=(a11*a17);
  a06=(a06+a11);
  a12=(a12+a06);
  a39=(a39*a55);
  a52=(a52*a31);
  a39=(a39+a52);
  a12=(a12-a39);
  if (res[2]!=0) res[2][3]=a12;
  a12=(a20*a22);
  a39=(2.*a05);
  a12=(a12*a39);
  a39=(2.*a01);
  a22=(a22*a04);
  a20=(a20*a37);
  a22=(a22+a20);
  a39=(a39*a22);
  a12=(a12+a39);
  a41=(a41/a01);
  a54=(a54/a01);
  a39=(a54/a01);
  a39=(a39*a05);
  a41=(a41-a39);
  a41=(a41/a01);
  a54=(a54/a01);
  a39=(a54/a01);
  a39=(a39*a05);
  a41=(a41-a39);
  a03=(a03*a41);
  a54=(a54*a00);
  a03=(a03+a54);
  a12=(a12-a03);
  a03=(a15/a01);
  a54=(a57/a01);
  a00=(a54/a01);
  a00=(a00*a05);
  a03=(a03-a00);
  a38=(a38*a03);
  a54=(a54*a13);
  a38=(a38+a54);
  a12=(a12-a38);
  a38=(a45/a01);
  a54=(a53/a01);
  a01=(a54/a01);
  a01=(a01*a05);
  a38=(a38-a01);
  a47=(a47*a38);
  a54=(a54*a08);
  a47=(a47+a54);
  a12=(a12-a47);
  if (res[2]!=0) res[2][4]=a12;
  a23=(a23*a28);
  a32=(a32*a36);
  a23=(a23+a32);
  if (res[2]!=0) res[2][5]=a23;
  a23=(a57*a24);
  a30=(a23*a30);
  a24=(a24*a15);
  a34=(a57*a34);
  a24=(a24+a34);
  a25=(a25*a24);
  a30=(a30+a25);
  a26=(a26*a30);
  if (res[2]!=0) res[2][6]=a26;
  a23=(a23*a27);
  a29=(a29*a24);
  a23=(a23+a29);
  if (res[2]!=0) res[2][7]=a23;
  a40=(a40*a45);
  a53=(a53*a44);
  a40=(a40+a53);
  if (res[2]!=0) res[2][8]=a40;
  a07=(a07*a15);
  a57=(a57*a16);
  a07=(a07+a57);
  if (res[2]!=0) res[2][9]=a07;
  a18=(a18*a21);
  a10=(a10*a51);
  a18=(a18+a10);
  if (res[2]!=0) res[2][10]=a18;
  return 0;
}

CASADI_SYMBOL_EXPORT int fwd1_adj1_linear_outputs(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f7(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int fwd1_adj1_linear_outputs_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void fwd1_adj1_linear_outputs_release(int mem) {
}

CASADI_SYMBOL_EXPORT void fwd1_adj1_linear_outputs_incref(void) {
}

CASADI_SYMBOL_EXPORT void fwd1_adj1_linear_outputs_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_linear_outputs_n_in(void) { return 13;}

CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_linear_outputs_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_linear_outputs_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* fwd1_adj1_linear_outputs_name_in(casadi_int i) {
  switch (i) {
    case 0: return "x";
    case 1: return "u";
    case 2: return "p";
    case 3: return "out_y";
    case 4: return "adj_y";
    case 5: return "out_adj_x";
    case 6: return "out_adj_u";
    case 7: return "out_adj_p";
    case 8: return "fwd_x";
    case 9: return "fwd_u";
    case 10: return "fwd_p";
    case 11: return "fwd_out_y";
    case 12: return "fwd_adj_y";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* fwd1_adj1_linear_outputs_name_out(casadi_int i) {
  switch (i) {
    case 0: return "fwd_adj_x";
    case 1: return "fwd_adj_u";
    case 2: return "fwd_adj_p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_linear_outputs_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    case 3: return casadi_s7;
    case 4: return casadi_s6;
    case 5: return casadi_s3;
    case 6: return casadi_s4;
    case 7: return casadi_s5;
    case 8: return casadi_s0;
    case 9: return casadi_s1;
    case 10: return casadi_s2;
    case 11: return casadi_s7;
    case 12: return casadi_s6;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_linear_outputs_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int fwd1_adj1_linear_outputs_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 13;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int fwd1_adj1_linear_outputs_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 13*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* linear_jacobians:(x[7],u,p[11])->(fx[7x7],fu[7],fp[7x11],gx[10x7],gu[10],gp[10x11]) */
static int casadi_f8(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56;
  a00=arg[2]? arg[2][8] : 0;
  a01=arg[2]? arg[2][4] : 0;
  a02=(a00/a01);
  a02=(2.*a02);
  a03=arg[2]? arg[2][6] : 0;
  a04=arg[2]? arg[2][7] : 0;
  a05=(a03*a04);
  a06=arg[2]? arg[2][5] : 0;
  a05=(a05*a06);
  a07=5.0000000000000000e-01;
  a08=casadi_sq(a01);
  a07=(a07*a08);
  a05=(a05*a07);
  a08=(a05/a01);
  a09=(a02+a08);
  a10=arg[2]? arg[2][9] : 0;
  a11=(a10/a01);
  a09=(a09+a11);
  a12=arg[2]? arg[2][0] : 0;
  a13=(a09/a12);
  a13=(-a13);
  if (res[0]!=0) res[0][0]=a13;
  a14=arg[2]? arg[2][3] : 0;
  a15=(a14*a08);
  a16=arg[2]? arg[2][2] : 0;
  a17=(a16*a02);
  a15=(a15-a17);
  a17=(a14*a11);
  a15=(a15+a17);
  a17=arg[2]? arg[2][1] : 0;
  a18=(a15/a17);
  if (res[0]!=0) res[0][1]=a18;
  a18=1.;
  if (res[0]!=0) res[0][2]=a18;
  a19=0.;
  if (res[0]!=0) res[0][3]=a19;
  a20=arg[0]? arg[0][6] : 0;
  a21=sin(a20);
  a21=(-a21);
  if (res[0]!=0) res[0][4]=a21;
  a21=cos(a20);
  if (res[0]!=0) res[0][5]=a21;
  if (res[0]!=0) res[0][6]=a19;
  a21=(a14/a01);
  a22=(a21*a05);
  a23=(a16/a01);
  a24=(a00*a23);
  a24=(2.*a24);
  a25=(a22-a24);
  a26=(a10*a21);
  a25=(a25+a26);
  a27=(a25/a12);
  a28=(a27-a01);
  if (res[0]!=0) res[0][7]=a28;
  a28=(a16*a24);
  a29=(a14*a22);
  a28=(a28+a29);
  a29=(a14*a26);
  a28=(a28+a29);
  a29=(a28/a17);
  a29=(-a29);
  if (res[0]!=0) res[0][8]=a29;
  if (res[0]!=0) res[0][9]=a19;
  if (res[0]!=0) res[0][10]=a18;
  if (res[0]!=0) res[0][11]=a19;
  if (res[0]!=0) res[0][12]=a19;
  if (res[0]!=0) res[0][13]=a18;
  if (res[0]!=0) res[0][14]=a19;
  if (res[0]!=0) res[0][15]=a19;
  if (res[0]!=0) res[0][16]=a19;
  if (res[0]!=0) res[0][17]=a19;
  if (res[0]!=0) res[0][18]=a19;
  if (res[0]!=0) res[0][19]=a19;
  if (res[0]!=0) res[0][20]=a19;
  if (res[0]!=0) res[0][21]=a19;
  if (res[0]!=0) res[0][22]=a19;
  if (res[0]!=0) res[0][23]=a19;
  if (res[0]!=0) res[0][24]=a19;
  if (res[0]!=0) res[0][25]=a19;
  if (res[0]!=0) res[0][26]=a19;
  if (res[0]!=0) res[0][27]=a19;
  if (res[0]!=0) res[0][28]=a19;
  if (res[0]!=0) res[0][29]=a19;
  if (res[0]!=0) res[0][30]=a19;
  if (res[0]!=0) res[0][31]=a19;
  if (res[0]!=0) res[0][32]=a19;
  if (res[0]!=0) res[0][33]=a19;
  if (res[0]!=0) res[0][34]=a19;
  if (res[0]!=0) res[0][35]=a19;
  if (res[0]!=0) res[0][36]=a19;
  if (res[0]!=0) res[0][37]=a19;
  if (res[0]!=0) res[0][38]=a19;
  if (res[0]!=0) res[0][39]=a19;
  if (res[0]!=0) res[0][40]=a19;
  if (res[0]!=0) res[0][41]=a19;
  if (res[0]!=0) res[0][42]=a19;
  if (res[0]!=0) res[0][43]=a19;
  if (res[0]!=0) res[0][44]=a19;
  if (res[0]!=0) res[0][45]=a19;
  a29=sin(a20);
  a29=(a01*a29);
  a30=arg[0]? arg[0][0] : 0;
  a31=cos(a20);
  a31=(a30*a31);
  a29=(a29+a31);
  a29=(-a29);
  if (res[0]!=0) res[0][46]=a29;
  a29=cos(a20);
  a29=(a01*a29);
  a31=sin(a20);
  a31=(a30*a31);
  a29=(a29-a31);
  if (res[0]!=0) res[0][47]=a29;
  if (res[0]!=0) res[0][48]=a19;
  a29=(1./a12);
  if (res[1]!=0) res[1][0]=a29;
  a31=(a14/a17);
  a31=(-a31);
  if (res[1]!=0) res[1][1]=a31;
  if (res[1]!=0) res[1][2]=a19;
  if (res[1]!=0) res[1][3]=a19;
  if (res[1]!=0) res[1][4]=a19;
  if (res[1]!=0) res[1][5]=a19;
  if (res[1]!=0) res[1][6]=a19;
  a31=arg[0]? arg[0][1] : 0;
  a32=(a16*a31);
  a32=(a32+a30);
  a33=(a32/a01);
  a34=(a00*a33);
  a34=(2.*a34);
  a35=(a03*a04);
  a36=(a14*a31);
  a36=(a30-a36);
  a37=(a36/a01);
  a35=(a35*a37);
  a38=(a06*a35);
  a38=(a38*a07);
  a39=arg[1]? arg[1][0] : 0;
  a40=(a38-a39);
  a41=(a10*a37);
  a40=(a40+a41);
  a42=(a34+a40);
  a43=casadi_sq(a12);
  a42=(a42/a43);
  if (res[2]!=0) res[2][0]=a42;
  if (res[2]!=0) res[2][1]=a19;
  if (res[2]!=0) res[2][2]=a19;
  if (res[2]!=0) res[2][3]=a19;
  if (res[2]!=0) res[2][4]=a19;
  if (res[2]!=0) res[2][5]=a19;
  if (res[2]!=0) res[2][6]=a19;
  if (res[2]!=0) res[2][7]=a19;
  a38=(a38*a14);
  a39=(a39*a14);
  a43=(a34*a16);
  a39=(a39+a43);
  a38=(a38-a39);
  a41=(a41*a14);
  a38=(a38+a41);
  a41=casadi_sq(a17);
  a38=(a38/a41);
  a38=(-a38);
  if (res[2]!=0) res[2][8]=a38;
  if (res[2]!=0) res[2][9]=a19;
  if (res[2]!=0) res[2][10]=a19;
  if (res[2]!=0) res[2][11]=a19;
  if (res[2]!=0) res[2][12]=a19;
  if (res[2]!=0) res[2][13]=a19;
  a38=(a31/a01);
  a41=(a00*a38);
  a41=(2.*a41);
  a39=(a41/a12);
  a39=(-a39);
  if (res[2]!=0) res[2][14]=a39;
  a43=(a16*a41);
  a34=(a34+a43);
  a43=(a34/a17);
  a43=(-a43);
  if (res[2]!=0) res[2][15]=a43;
  if (res[2]!=0) res[2][16]=a19;
  if (res[2]!=0) res[2][17]=a19;
  if (res[2]!=0) res[2][18]=a19;
  if (res[2]!=0) res[2][19]=a19;
  if (res[2]!=0) res[2][20]=a19;
  a43=(a31/a01);
  a44=(a43*a05);
  a45=(a10*a43);
  a46=(a44+a45);
  a47=(a46/a12);
  if (res[2]!=0) res[2][21]=a47;
  a48=(a14*a44);
  a49=(a14*a45);
  a48=(a48+a49);
  a40=(a40-a48);
  a48=(a40/a17);
  if (res[2]!=0) res[2][22]=a48;
  if (res[2]!=0) res[2][23]=a19;
  if (res[2]!=0) res[2][24]=a19;
  if (res[2]!=0) res[2][25]=a19;
  if (res[2]!=0) res[2][26]=a19;
  if (res[2]!=0) res[2][27]=a19;
  a48=casadi_sq(a01);
  a36=(a36/a48);
  a10=(a10*a36);
  a32=(a32/a48);
  a00=(a00*a32);
  a00=(-a00);
  a00=(2.*a00);
  a49=(a06*a01);
  a49=(a49*a35);
  a05=(a36*a05);
  a49=(a49-a05);
  a05=(a00+a49);
  a05=(a10-a05);
  a50=(a05/a12);
  a31=(a50-a31);
  if (res[2]!=0) res[2][28]=a31;
  a31=(a14*a49);
  a51=(a16*a00);
  a31=(a31-a51);
  a51=(a14*a10);
  a31=(a31-a51);
  a51=(a31/a17);
  if (res[2]!=0) res[2][29]=a51;
  if (res[2]!=0) res[2][30]=a19;
  if (res[2]!=0) res[2][31]=a19;
  a51=cos(a20);
  if (res[2]!=0) res[2][32]=a51;
  a20=sin(a20);
  if (res[2]!=0) res[2][33]=a20;
  if (res[2]!=0) res[2][34]=a19;
  a35=(a35*a07);
  a20=(a35/a12);
  a20=(-a20);
  if (res[2]!=0) res[2][35]=a20;
  a51=(a14*a35);
  a52=(a51/a17);
  if (res[2]!=0) res[2][36]=a52;
  if (res[2]!=0) res[2][37]=a19;
  if (res[2]!=0) res[2][38]=a19;
  if (res[2]!=0) res[2][39]=a19;
  if (res[2]!=0) res[2][40]=a19;
  if (res[2]!=0) res[2][41]=a19;
  a06=(a37*a06);
  a06=(a06*a07);
  a04=(a04*a06);
  a07=(a04/a12);
  a07=(-a07);
  if (res[2]!=0) res[2][42]=a07;
  a52=(a14*a04);
  a53=(a52/a17);
  if (res[2]!=0) res[2][43]=a53;
  if (res[2]!=0) res[2][44]=a19;
  if (res[2]!=0) res[2][45]=a19;
  if (res[2]!=0) res[2][46]=a19;
  if (res[2]!=0) res[2][47]=a19;
  if (res[2]!=0) res[2][48]=a19;
  a03=(a03*a06);
  a06=(a03/a12);
  a06=(-a06);
  if (res[2]!=0) res[2][49]=a06;
  a53=(a14*a03);
  a54=(a53/a17);
  if (res[2]!=0) res[2][50]=a54;
  if (res[2]!=0) res[2][51]=a19;
  if (res[2]!=0) res[2][52]=a19;
  if (res[2]!=0) res[2][53]=a19;
  if (res[2]!=0) res[2][54]=a19;
  if (res[2]!=0) res[2][55]=a19;
  a33=(2.*a33);
  a54=(a33/a12);
  a54=(-a54);
  if (res[2]!=0) res[2][56]=a54;
  a16=(a16*a33);
  a55=(a16/a17);
  a55=(-a55);
  if (res[2]!=0) res[2][57]=a55;
  if (res[2]!=0) res[2][58]=a19;
  if (res[2]!=0) res[2][59]=a19;
  if (res[2]!=0) res[2][60]=a19;
  if (res[2]!=0) res[2][61]=a19;
  if (res[2]!=0) res[2][62]=a19;
  a55=(a37/a12);
  a55=(-a55);
  if (res[2]!=0) res[2][63]=a55;
  a56=(a14*a37);
  a17=(a56/a17);
  if (res[2]!=0) res[2][64]=a17;
  if (res[2]!=0) res[2][65]=a19;
  if (res[2]!=0) res[2][66]=a19;
  if (res[2]!=0) res[2][67]=a19;
  if (res[2]!=0) res[2][68]=a19;
  if (res[2]!=0) res[2][69]=a19;
  if (res[2]!=0) res[2][70]=a19;
  if (res[2]!=0) res[2][71]=a19;
  if (res[2]!=0) res[2][72]=a19;
  if (res[2]!=0) res[2][73]=a19;
  if (res[2]!=0) res[2][74]=a19;
  if (res[2]!=0) res[2][75]=a19;
  if (res[2]!=0) res[2][76]=a19;
  a17=(1./a01);
  if (res[3]!=0) res[3][0]=a17;
  a17=(1./a01);
  if (res[3]!=0) res[3][1]=a17;
  a01=(1./a01);
  if (res[3]!=0) res[3][2]=a01;
  if (res[3]!=0) res[3][3]=a02;
  if (res[3]!=0) res[3][4]=a08;
  if (res[3]!=0) res[3][5]=a11;
  if (res[3]!=0) res[3][6]=a13;
  a09=(-a09);
  if (res[3]!=0) res[3][7]=a09;
  if (res[3]!=0) res[3][8]=a15;
  if (res[3]!=0) res[3][9]=a19;
  if (res[3]!=0) res[3][10]=a23;
  a21=(-a21);
  if (res[3]!=0) res[3][11]=a21;
  if (res[3]!=0) res[3][12]=a19;
  if (res[3]!=0) res[3][13]=a24;
  a22=(-a22);
  if (res[3]!=0) res[3][14]=a22;
  a26=(-a26);
  if (res[3]!=0) res[3][15]=a26;
  if (res[3]!=0) res[3][16]=a27;
  if (res[3]!=0) res[3][17]=a25;
  a28=(-a28);
  if (res[3]!=0) res[3][18]=a28;
  if (res[3]!=0) res[3][19]=a19;
  if (res[3]!=0) res[3][20]=a19;
  if (res[3]!=0) res[3][21]=a19;
  if (res[3]!=0) res[3][22]=a19;
  if (res[3]!=0) res[3][23]=a19;
  if (res[3]!=0) res[3][24]=a19;
  if (res[3]!=0) res[3][25]=a19;
  if (res[3]!=0) res[3][26]=a19;
  if (res[3]!=0) res[3][27]=a19;
  if (res[3]!=0) res[3][28]=a19;
  if (res[3]!=0) res[3][29]=a19;
  if (res[3]!=0) res[3][30]=a19;
  if (res[3]!=0) res[3][31]=a19;
  if (res[3]!=0) res[3][32]=a19;
  if (res[3]!=0) res[3][33]=a19;
  if (res[3]!=0) res[3][34]=a19;
  if (res[3]!=0) res[3][35]=a19;
  if (res[3]!=0) res[3][36]=a19;
  if (res[3]!=0) res[3][37]=a19;
  if (res[3]!=0) res[3][38]=a19;
  if (res[3]!=0) res[3][39]=a19;
  if (res[3]!=0) res[3][40]=a19;
  if (res[3]!=0) res[3][41]=a19;
  if (res[3]!=0) res[3][42]=a19;
  if (res[3]!=0) res[3][43]=a19;
  if (res[3]!=0) res[3][44]=a19;
  if (res[3]!=0) res[3][45]=a19;
  if (res[3]!=0) res[3][46]=a19;
  if (res[3]!=0) res[3][47]=a19;
  if (res[3]!=0) res[3][48]=a19;
  if (res[3]!=0) res[3][49]=a19;
  if (res[3]!=0) res[3][50]=a19;
  if (res[3]!=0) res[3][51]=a19;
  if (res[3]!=0) res[3][52]=a19;
  if (res[3]!=0) res[3][53]=a19;
  if (res[3]!=0) res[3][54]=a19;
  if (res[3]!=0) res[3][55]=a19;
  if (res[3]!=0) res[3][56]=a19;
  if (res[3]!=0) res[3][57]=a19;
  if (res[3]!=0) res[3][58]=a19;
  if (res[3]!=0) res[3][59]=a19;
  if (res[3]!=0) res[3][60]=a19;
  if (res[3]!=0) res[3][61]=a19;
  if (res[3]!=0) res[3][62]=a19;
  if (res[3]!=0) res[3][63]=a19;
  if (res[3]!=0) res[3][64]=a19;
  if (res[3]!=0) res[3][65]=a19;
  if (res[3]!=0) res[3][66]=a19;
  if (res[3]!=0) res[3][67]=a19;
  if (res[3]!=0) res[3][68]=a19;
  if (res[3]!=0) res[3][69]=a19;
  if (res[4]!=0) res[4][0]=a19;
  if (res[4]!=0) res[4][1]=a19;
  if (res[4]!=0) res[4][2]=a19;
  if (res[4]!=0) res[4][3]=a19;
  if (res[4]!=0) res[4][4]=a19;
  if (res[4]!=0) res[4][5]=a19;
  if (res[4]!=0) res[4][6]=a29;
  if (res[4]!=0) res[4][7]=a18;
  a14=(-a14);
  if (res[4]!=0) res[4][8]=a14;
  if (res[4]!=0) res[4][9]=a19;
  if (res[5]!=0) res[5][0]=a19;
  if (res[5]!=0) res[5][1]=a19;
  if (res[5]!=0) res[5][2]=a19;
  if (res[5]!=0) res[5][3]=a19;
  if (res[5]!=0) res[5][4]=a19;
  if (res[5]!=0) res[5][5]=a19;
  if (res[5]!=0) res[5][6]=a42;
  if (res[5]!=0) res[5][7]=a19;
  if (res[5]!=0) res[5][8]=a19;
  a42=arg[2]? arg[2][10] : 0;
  if (res[5]!=0) res[5][9]=a42;
  if (res[5]!=0) res[5][10]=a19;
  if (res[5]!=0) res[5][11]=a19;
  if (res[5]!=0) res[5][12]=a19;
  if (res[5]!=0) res[5][13]=a19;
  if (res[5]!=0) res[5][14]=a19;
  if (res[5]!=0) res[5][15]=a19;
  if (res[5]!=0) res[5][16]=a19;
  if (res[5]!=0) res[5][17]=a19;
  if (res[5]!=0) res[5][18]=a19;
  if (res[5]!=0) res[5][19]=a19;
  if (res[5]!=0) res[5][20]=a38;
  if (res[5]!=0) res[5][21]=a19;
  if (res[5]!=0) res[5][22]=a19;
  if (res[5]!=0) res[5][23]=a41;
  if (res[5]!=0) res[5][24]=a19;
  if (res[5]!=0) res[5][25]=a19;
  if (res[5]!=0) res[5][26]=a39;
  a41=(-a41);
  if (res[5]!=0) res[5][27]=a41;
  a34=(-a34);
  if (res[5]!=0) res[5][28]=a34;
  if (res[5]!=0) res[5][29]=a19;
  if (res[5]!=0) res[5][30]=a19;
  a43=(-a43);
  if (res[5]!=0) res[5][31]=a43;
  if (res[5]!=0) res[5][32]=a19;
  if (res[5]!=0) res[5][33]=a19;
  a44=(-a44);
  if (res[5]!=0) res[5][34]=a44;
  a45=(-a45);
  if (res[5]!=0) res[5][35]=a45;
  if (res[5]!=0) res[5][36]=a47;
  if (res[5]!=0) res[5][37]=a46;
  if (res[5]!=0) res[5][38]=a40;
  if (res[5]!=0) res[5][39]=a19;
  a32=(-a32);
  if (res[5]!=0) res[5][40]=a32;
  a36=(-a36);
  if (res[5]!=0) res[5][41]=a36;
  a30=(a30/a48);
  a30=(-a30);
  if (res[5]!=0) res[5][42]=a30;
  if (res[5]!=0) res[5][43]=a00;
  if (res[5]!=0) res[5][44]=a49;
  a10=(-a10);
  if (res[5]!=0) res[5][45]=a10;
  if (res[5]!=0) res[5][46]=a50;
  if (res[5]!=0) res[5][47]=a05;
  if (res[5]!=0) res[5][48]=a31;
  if (res[5]!=0) res[5][49]=a19;
  if (res[5]!=0) res[5][50]=a19;
  if (res[5]!=0) res[5][51]=a19;
  if (res[5]!=0) res[5][52]=a19;
  if (res[5]!=0) res[5][53]=a19;
  if (res[5]!=0) res[5][54]=a35;
  if (res[5]!=0) res[5][55]=a19;
  if (res[5]!=0) res[5][56]=a20;
  a35=(-a35);
  if (res[5]!=0) res[5][57]=a35;
  if (res[5]!=0) res[5][58]=a51;
  if (res[5]!=0) res[5][59]=a19;
  if (res[5]!=0) res[5][60]=a19;
  if (res[5]!=0) res[5][61]=a19;
  if (res[5]!=0) res[5][62]=a19;
  if (res[5]!=0) res[5][63]=a19;
  if (res[5]!=0) res[5][64]=a04;
  if (res[5]!=0) res[5][65]=a19;
  if (res[5]!=0) res[5][66]=a07;
  a04=(-a04);
  if (res[5]!=0) res[5][67]=a04;
  if (res[5]!=0) res[5][68]=a52;
  if (res[5]!=0) res[5][69]=a19;
  if (res[5]!=0) res[5][70]=a19;
  if (res[5]!=0) res[5][71]=a19;
  if (res[5]!=0) res[5][72]=a19;
  if (res[5]!=0) res[5][73]=a19;
  if (res[5]!=0) res[5][74]=a03;
  if (res[5]!=0) res[5][75]=a19;
  if (res[5]!=0) res[5][76]=a06;
  a03=(-a03);
  if (res[5]!=0) res[5][77]=a03;
  if (res[5]!=0) res[5][78]=a53;
  if (res[5]!=0) res[5][79]=a19;
  if (res[5]!=0) res[5][80]=a19;
  if (res[5]!=0) res[5][81]=a19;
  if (res[5]!=0) res[5][82]=a19;
  if (res[5]!=0) res[5][83]=a33;
  if (res[5]!=0) res[5][84]=a19;
  if (res[5]!=0) res[5][85]=a19;
  if (res[5]!=0) res[5][86]=a54;
  a33=(-a33);
  if (res[5]!=0) res[5][87]=a33;
  a16=(-a16);
  if (res[5]!=0) res[5][88]=a16;
  if (res[5]!=0) res[5][89]=a19;
  if (res[5]!=0) res[5][90]=a19;
  if (res[5]!=0) res[5][91]=a19;
  if (res[5]!=0) res[5][92]=a19;
  if (res[5]!=0) res[5][93]=a19;
  if (res[5]!=0) res[5][94]=a19;
  if (res[5]!=0) res[5][95]=a37;
  if (res[5]!=0) res[5][96]=a55;
  a37=(-a37);
  if (res[5]!=0) res[5][97]=a37;
  if (res[5]!=0) res[5][98]=a56;
  if (res[5]!=0) res[5][99]=a19;
  if (res[5]!=0) res[5][100]=a19;
  if (res[5]!=0) res[5][101]=a19;
  if (res[5]!=0) res[5][102]=a19;
  if (res[5]!=0) res[5][103]=a19;
  if (res[5]!=0) res[5][104]=a19;
  if (res[5]!=0) res[5][105]=a19;
  if (res[5]!=0) res[5][106]=a19;
  if (res[5]!=0) res[5][107]=a19;
  if (res[5]!=0) res[5][108]=a19;
  if (res[5]!=0) res[5][109]=a12;
  return 0;
}

CASADI_SYMBOL_EXPORT int linear_jacobians(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f8(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int linear_jacobians_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void linear_jacobians_release(int mem) {
}

CASADI_SYMBOL_EXPORT void linear_jacobians_incref(void) {
}

CASADI_SYMBOL_EXPORT void linear_jacobians_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int linear_jacobians_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int linear_jacobians_n_out(void) { return 6;}

CASADI_SYMBOL_EXPORT casadi_real linear_jacobians_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* linear_jacobians_name_in(casadi_int i) {
  switch (i) {
    case 0: return "x";
    case 1: return "u";
    case 2: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* linear_jacobians_name_out(casadi_int i) {
  switch (i) {
    case 0: return "fx";
    case 1: return "fu";
    case 2: return "fp";
    case 3: return "gx";
    case 4: return "gu";
    case 5: return "gp";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* linear_jacobians_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* linear_jacobians_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    case 1: return casadi_s0;
    case 2: return casadi_s9;
    case 3: return casadi_s10;
    case 4: return casadi_s6;
    case 5: return casadi_s11;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int linear_jacobians_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int linear_jacobians_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* fwd1_linear_jacobians:(x[7],u,p[11],out_fx[7x7,0nz],out_fu[7x1,0nz],out_fp[7x11,0nz],out_gx[10x7,0nz],out_gu[10x1,0nz],out_gp[10x11,0nz],fwd_x[7],fwd_u,fwd_p[11])->(fwd_fx[7x7],fwd_fu[7],fwd_fp[7x11],fwd_gx[10x7],fwd_gu[10],fwd_gp[10x11]) */
static int casadi_f9(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  a00=arg[11]? arg[11][8] : 0;
  a01=arg[2]? arg[2][4] : 0;
  a02=(a00/a01);
  a03=arg[2]? arg[2][8] : 0;
  a04=(a03/a01);
  a05=(a04/a01);
  a06=arg[11]? arg[11][4] : 0;
  a05=(a05*a06);
  a02=(a02-a05);
  a02=(2.*a02);
  a05=5.0000000000000000e-01;
  a07=casadi_sq(a01);
  a07=(a05*a07);
  a08=arg[2]? arg[2][5] : 0;
  a09=arg[2]? arg[2][7] : 0;
  a10=arg[11]? arg[11][6] : 0;
  a11=(a09*a10);
  a12=arg[2]? arg[2][6] : 0;
  a13=arg[11]? arg[11][7] : 0;
  a14=(a12*a13);
  a11=(a11+a14);
  a11=(a08*a11);
  a14=(a12*a09);
  a15=arg[11]? arg[11][5] : 0;
  a16=(a14*a15);
  a11=(a11+a16);
  a11=(a07*a11);
  a14=(a14*a08);
  a16=(2.*a01);
  a16=(a16*a06);
  a05=(a05*a16);
  a16=(a14*a05);
  a11=(a11+a16);
  a16=(a11/a01);
  a14=(a14*a07);
  a17=(a14/a01);
  a18=(a17/a01);
  a18=(a18*a06);
  a16=(a16-a18);
  a18=(a02+a16);
  a19=arg[11]? arg[11][9] : 0;
  a20=(a19/a01);
  a21=arg[2]? arg[2][9] : 0;
  a22=(a21/a01);
  a23=(a22/a01);
  a23=(a23*a06);
  a20=(a20-a23);
  a18=(a18+a20);
  a23=arg[2]? arg[2][0] : 0;
  a24=(a18/a23);
  a04=(2.*a04);
  a25=(a04+a17);
  a25=(a25+a22);
  a25=(a25/a23);
  a25=(a25/a23);
  a26=arg[11]? arg[11][0] : 0;
  a25=(a25*a26);
  a24=(a24-a25);
  a24=(-a24);
  if (res[0]!=0) res[0][0]=a24;
  a25=arg[11]? arg[11][3] : 0;
  a27=(a17*a25);
  a28=arg[2]? arg[2][3] : 0;
  a29=(a28*a16);
  a27=(a27+a29);
  a29=arg[11]? arg[11][2] : 0;
  a30=(a04*a29);
  a31=arg[2]? arg[2][2] : 0;
  a32=(a31*a02);
  a30=(a30+a32);
  a27=(a27-a30);
  a30=(a22*a25);
  a32=(a28*a20);
  a30=(a30+a32);
  a27=(a27+a30);
  a30=arg[2]? arg[2][1] : 0;
  a32=(a27/a30);
  a17=(a28*a17);
  a04=(a31*a04);
  a17=(a17-a04);
  a22=(a28*a22);
  a17=(a17+a22);
  a17=(a17/a30);
  a17=(a17/a30);
  a22=arg[11]? arg[11][1] : 0;
  a17=(a17*a22);
  a32=(a32-a17);
  if (res[0]!=0) res[0][1]=a32;
  a32=0.;
  if (res[0]!=0) res[0][2]=a32;
  if (res[0]!=0) res[0][3]=a32;
  a17=arg[0]? arg[0][6] : 0;
  a04=cos(a17);
  a33=arg[9]? arg[9][6] : 0;
  a04=(a04*a33);
  a04=(-a04);
  if (res[0]!=0) res[0][4]=a04;
  a04=sin(a17);
  a04=(a04*a33);
  a04=(-a04);
  if (res[0]!=0) res[0][5]=a04;
  if (res[0]!=0) res[0][6]=a32;
  a04=(a25/a01);
  a34=(a28/a01);
  a35=(a34/a01);
  a35=(a35*a06);
  a04=(a04-a35);
  a35=(a14*a04);
  a36=(a34*a11);
  a35=(a35+a36);
  a36=(a31/a01);
  a37=(a36*a00);
  a38=(a29/a01);
  a39=(a36/a01);
  a39=(a39*a06);
  a38=(a38-a39);
  a39=(a03*a38);
  a37=(a37+a39);
  a37=(2.*a37);
  a39=(a35-a37);
  a40=(a34*a19);
  a41=(a21*a04);
  a40=(a40+a41);
  a39=(a39+a40);
  a41=(a39/a23);
  a42=(a34*a14);
  a36=(a03*a36);
  a36=(2.*a36);
  a43=(a42-a36);
  a34=(a21*a34);
  a43=(a43+a34);
  a43=(a43/a23);
  a43=(a43/a23);
  a43=(a43*a26);
  a41=(a41-a43);
  a43=(a41-a06);
  if (res[0]!=0) res[0][7]=a43;
  a43=(a36*a29);
  a44=(a31*a37);
  a43=(a43+a44);
  a44=(a42*a25);
  a45=(a28*a35);
  a44=(a44+a45);
  a43=(a43+a44);
  a44=(a34*a25);
  a45=(a28*a40);
  a44=(a44+a45);
  a43=(a43+a44);
  a44=(a43/a30);
  a36=(a31*a36);
  a42=(a28*a42);
  a36=(a36+a42);
  a34=(a28*a34);
  a36=(a36+a34);
  a36=(a36/a30);
  a36=(a36/a30);
  a36=(a36*a22);
  a44=(a44-a36);
  a44=(-a44);
  if (res[0]!=0) res[0][8]=a44;
  if (res[0]!=0) res[0][9]=a32;
  if (res[0]!=0) res[0][10]=a32;
  if (res[0]!=0) res[0][11]=a32;
  if (res[0]!=0) res[0][12]=a32;
  if (res[0]!=0) res[0][13]=a32;
  if (res[0]!=0) res[0][14]=a32;
  if (res[0]!=0) res[0][15]=a32;
  if (res[0]!=0) res[0][16]=a32;
  if (res[0]!=0) res[0][17]=a32;
  if (res[0]!=0) res[0][18]=a32;
  if (res[0]!=0) res[0][19]=a32;
  if (res[0]!=0) res[0][20]=a32;
  if (res[0]!=0) res[0][21]=a32;
  if (res[0]!=0) res[0][22]=a32;
  if (res[0]!=0) res[0][23]=a32;
  if (res[0]!=0) res[0][24]=a32;
  if (res[0]!=0) res[0][25]=a32;
  if (res[0]!=0) res[0][26]=a32;
  if (res[0]!=0) res[0][27]=a32;
  if (res[0]!=0) res[0][28]=a32;
  if (res[0]!=0) res[0][29]=a32;
  if (res[0]!=0) res[0][30]=a32;
  if (res[0]!=0) res[0][31]=a32;
  if (res[0]!=0) res[0][32]=a32;
  if (res[0]!=0) res[0][33]=a32;
  if (res[0]!=0) res[0][34]=a32;
  if (res[0]!=0) res[0][35]=a32;
  if (res[0]!=0) res[0][36]=a32;
  if (res[0]!=0) res[0][37]=a32;
  if (res[0]!=0) res[0][38]=a32;
  if (res[0]!=0) res[0][39]=a32;
  if (res[0]!=0) res[0][40]=a32;
  if (res[0]!=0) res[0][41]=a32;
  if (res[0]!=0) res[0][42]=a32;
  if (res[0]!=0) res[0][43]=a32;
  if (res[0]!=0) res[0][44]=a32;
  if (res[0]!=0) res[0][45]=a32;
  a44=sin(a17);
  a44=(a44*a06);
  a36=cos(a17);
  a36=(a36*a33);
  a36=(a01*a36);
  a44=(a44+a36);
  a36=cos(a17);
  a34=arg[9]? arg[9][0] : 0;
  a36=(a36*a34);
  a42=arg[0]? arg[0][0] : 0;
  a45=sin(a17);
  a45=(a45*a33);
  a45=(a42*a45);
  a36=(a36-a45);
  a44=(a44+a36);
  a44=(-a44);
  if (res[0]!=0) res[0][46]=a44;
  a44=cos(a17);
  a44=(a44*a06);
  a36=sin(a17);
  a36=(a36*a33);
  a36=(a01*a36);
  a44=(a44-a36);
  a36=sin(a17);
  a36=(a36*a34);
  a45=cos(a17);
  a45=(a45*a33);
  a45=(a42*a45);
  a36=(a36+a45);
  a44=(a44-a36);
  if (res[0]!=0) res[0][47]=a44;
  if (res[0]!=0) res[0][48]=a32;
  a44=(1./a23);
  a44=(a44/a23);
  a44=(a44*a26);
  a44=(-a44);
  if (res[1]!=0) res[1][0]=a44;
  a36=(a25/a30);
  a45=(a28/a30);
  a45=(a45/a30);
  a45=(a45*a22);
  a36=(a36-a45);
  a36=(-a36);
  if (res[1]!=0) res[1][1]=a36;
  if (res[1]!=0) res[1][2]=a32;
  if (res[1]!=0) res[1][3]=a32;
  if (res[1]!=0) res[1][4]=a32;
  if (res[1]!=0) res[1][5]=a32;
  if (res[1]!=0) res[1][6]=a32;
  a36=arg[0]? arg[0][1] : 0;
  a45=(a31*a36);
  a45=(a45+a42);
  a46=(a45/a01);
  a47=(a46*a00);
  a48=(a36*a29);
  a49=arg[9]? arg[9][1] : 0;
  a50=(a31*a49);
  a48=(a48+a50);
  a48=(a48+a34);
  a50=(a48/a01);
  a51=(a46/a01);
  a51=(a51*a06);
  a50=(a50-a51);
  a51=(a03*a50);
  a47=(a47+a51);
  a47=(2.*a47);
  a51=(a12*a09);
  a52=(a28*a36);
  a52=(a42-a52);
  a53=(a52/a01);
  a54=(a51*a53);
  a55=(a54*a15);
  a56=(a09*a10);
  a57=(a12*a13);
  a56=(a56+a57);
  a56=(a53*a56);
  a57=(a36*a25);
  a58=(a28*a49);
  a57=(a57+a58);
  a57=(a34-a57);
  a58=(a57/a01);
  a59=(a53/a01);
  a59=(a59*a06);
  a58=(a58-a59);
  a51=(a51*a58);
  a56=(a56+a51);
  a51=(a08*a56);
  a55=(a55+a51);
  a55=(a07*a55);
  a51=(a08*a54);
  a59=(a51*a05);
  a55=(a55+a59);
  a59=arg[10]? arg[10][0] : 0;
  a60=(a55-a59);
  a61=(a53*a19);
  a62=(a21*a58);
  a61=(a61+a62);
  a60=(a60+a61);
  a62=(a47+a60);
  a63=casadi_sq(a23);
  a62=(a62/a63);
  a64=(a03*a46);
  a64=(2.*a64);
  a51=(a51*a07);
  a65=arg[1]? arg[1][0] : 0;
  a66=(a51-a65);
  a67=(a21*a53);
  a66=(a66+a67);
  a68=(a64+a66);
  a68=(a68/a63);
  a68=(a68/a63);
  a63=(2.*a23);
  a63=(a63*a26);
  a68=(a68*a63);
  a62=(a62-a68);
  if (res[2]!=0) res[2][0]=a62;
  if (res[2]!=0) res[2][1]=a32;
  if (res[2]!=0) res[2][2]=a32;
  if (res[2]!=0) res[2][3]=a32;
  if (res[2]!=0) res[2][4]=a32;
  if (res[2]!=0) res[2][5]=a32;
  if (res[2]!=0) res[2][6]=a32;
  if (res[2]!=0) res[2][7]=a32;
  a55=(a28*a55);
  a68=(a51*a25);
  a55=(a55+a68);
  a59=(a28*a59);
  a68=(a65*a25);
  a59=(a59+a68);
  a68=(a31*a47);
  a63=(a64*a29);
  a68=(a68+a63);
  a59=(a59+a68);
  a55=(a55-a59);
  a61=(a28*a61);
  a59=(a67*a25);
  a61=(a61+a59);
  a55=(a55+a61);
  a61=casadi_sq(a30);
  a55=(a55/a61);
  a51=(a51*a28);
  a65=(a65*a28);
  a59=(a64*a31);
  a65=(a65+a59);
  a51=(a51-a65);
  a67=(a67*a28);
  a51=(a51+a67);
  a51=(a51/a61);
  a51=(a51/a61);
  a61=(2.*a30);
  a61=(a61*a22);
  a51=(a51*a61);
  a55=(a55-a51);
  a55=(-a55);
  if (res[2]!=0) res[2][8]=a55;
  if (res[2]!=0) res[2][9]=a32;
  if (res[2]!=0) res[2][10]=a32;
  if (res[2]!=0) res[2][11]=a32;
  if (res[2]!=0) res[2][12]=a32;
  if (res[2]!=0) res[2][13]=a32;
  a55=(a36/a01);
  a51=(a55*a00);
  a61=(a49/a01);
  a67=(a55/a01);
  a67=(a67*a06);
  a61=(a61-a67);
  a67=(a03*a61);
  a51=(a51+a67);
  a51=(2.*a51);
  a67=(a51/a23);
  a55=(a03*a55);
  a55=(2.*a55);
  a65=(a55/a23);
  a65=(a65/a23);
  a65=(a65*a26);
  a67=(a67-a65);
  a67=(-a67);
  if (res[2]!=0) res[2][14]=a67;
  a65=(a55*a29);
  a59=(a31*a51);
  a65=(a65+a59);
  a47=(a47+a65);
  a65=(a47/a30);
  a55=(a31*a55);
  a64=(a64+a55);
  a64=(a64/a30);
  a64=(a64/a30);
  a64=(a64*a22);
  a65=(a65-a64);
  a65=(-a65);
  if (res[2]!=0) res[2][15]=a65;
  if (res[2]!=0) res[2][16]=a32;
  if (res[2]!=0) res[2][17]=a32;
  if (res[2]!=0) res[2][18]=a32;
  if (res[2]!=0) res[2][19]=a32;
  if (res[2]!=0) res[2][20]=a32;
  a65=(a49/a01);
  a36=(a36/a01);
  a64=(a36/a01);
  a64=(a64*a06);
  a65=(a65-a64);
  a64=(a14*a65);
  a55=(a36*a11);
  a64=(a64+a55);
  a55=(a36*a19);
  a59=(a21*a65);
  a55=(a55+a59);
  a59=(a64+a55);
  a68=(a59/a23);
  a63=(a36*a14);
  a36=(a21*a36);
  a69=(a63+a36);
  a69=(a69/a23);
  a69=(a69/a23);
  a69=(a69*a26);
  a68=(a68-a69);
  if (res[2]!=0) res[2][21]=a68;
  a69=(a63*a25);
  a70=(a28*a64);
  a69=(a69+a70);
  a70=(a36*a25);
  a71=(a28*a55);
  a70=(a70+a71);
  a69=(a69+a70);
  a60=(a60-a69);
  a69=(a60/a30);
  a63=(a28*a63);
  a36=(a28*a36);
  a63=(a63+a36);
  a66=(a66-a63);
  a66=(a66/a30);
  a66=(a66/a30);
  a66=(a66*a22);
  a69=(a69-a66);
  if (res[2]!=0) res[2][22]=a69;
  if (res[2]!=0) res[2][23]=a32;
  if (res[2]!=0) res[2][24]=a32;
  if (res[2]!=0) res[2][25]=a32;
  if (res[2]!=0) res[2][26]=a32;
  if (res[2]!=0) res[2][27]=a32;
  a69=casadi_sq(a01);
  a52=(a52/a69);
  a19=(a52*a19);
  a57=(a57/a69);
  a66=(a52/a69);
  a63=(2.*a01);
  a63=(a63*a06);
  a66=(a66*a63);
  a57=(a57-a66);
  a66=(a21*a57);
  a19=(a19+a66);
  a45=(a45/a69);
  a00=(a45*a00);
  a48=(a48/a69);
  a66=(a45/a69);
  a66=(a66*a63);
  a48=(a48-a66);
  a66=(a03*a48);
  a00=(a00+a66);
  a00=(-a00);
  a00=(2.*a00);
  a66=(a01*a15);
  a36=(a08*a06);
  a66=(a66+a36);
  a66=(a54*a66);
  a36=(a08*a01);
  a70=(a36*a56);
  a66=(a66+a70);
  a70=(a14*a57);
  a11=(a52*a11);
  a70=(a70+a11);
  a66=(a66-a70);
  a70=(a00+a66);
  a70=(a19-a70);
  a11=(a70/a23);
  a21=(a21*a52);
  a03=(a03*a45);
  a03=(-a03);
  a03=(2.*a03);
  a36=(a36*a54);
  a52=(a52*a14);
  a36=(a36-a52);
  a52=(a03+a36);
  a52=(a21-a52);
  a52=(a52/a23);
  a52=(a52/a23);
  a52=(a52*a26);
  a11=(a11-a52);
  a49=(a11-a49);
  if (res[2]!=0) res[2][28]=a49;
  a49=(a36*a25);
  a52=(a28*a66);
  a49=(a49+a52);
  a52=(a03*a29);
  a14=(a31*a00);
  a52=(a52+a14);
  a49=(a49-a52);
  a52=(a21*a25);
  a14=(a28*a19);
  a52=(a52+a14);
  a49=(a49-a52);
  a52=(a49/a30);
  a36=(a28*a36);
  a03=(a31*a03);
  a36=(a36-a03);
  a21=(a28*a21);
  a36=(a36-a21);
  a36=(a36/a30);
  a36=(a36/a30);
  a36=(a36*a22);
  a52=(a52-a36);
  if (res[2]!=0) res[2][29]=a52;
  if (res[2]!=0) res[2][30]=a32;
  if (res[2]!=0) res[2][31]=a32;
  a52=sin(a17);
  a52=(a52*a33);
  a52=(-a52);
  if (res[2]!=0) res[2][32]=a52;
  a17=cos(a17);
  a17=(a17*a33);
  if (res[2]!=0) res[2][33]=a17;
  if (res[2]!=0) res[2][34]=a32;
  a56=(a07*a56);
  a17=(a54*a05);
  a56=(a56+a17);
  a17=(a56/a23);
  a54=(a54*a07);
  a33=(a54/a23);
  a33=(a33/a23);
  a33=(a33*a26);
  a17=(a17-a33);
  a17=(-a17);
  if (res[2]!=0) res[2][35]=a17;
  a33=(a54*a25);
  a52=(a28*a56);
  a33=(a33+a52);
  a52=(a33/a30);
  a54=(a28*a54);
  a54=(a54/a30);
  a54=(a54/a30);
  a54=(a54*a22);
  a52=(a52-a54);
  if (res[2]!=0) res[2][36]=a52;
  if (res[2]!=0) res[2][37]=a32;
  if (res[2]!=0) res[2][38]=a32;
  if (res[2]!=0) res[2][39]=a32;
  if (res[2]!=0) res[2][40]=a32;
  if (res[2]!=0) res[2][41]=a32;
  a52=(a53*a08);
  a54=(a52*a07);
  a13=(a54*a13);
  a08=(a08*a58);
  a15=(a53*a15);
  a08=(a08+a15);
  a07=(a07*a08);
  a52=(a52*a05);
  a07=(a07+a52);
  a52=(a09*a07);
  a13=(a13+a52);
  a52=(a13/a23);
  a09=(a09*a54);
  a05=(a09/a23);
  a05=(a05/a23);
  a05=(a05*a26);
  a52=(a52-a05);
  a52=(-a52);
  if (res[2]!=0) res[2][42]=a52;
  a05=(a09*a25);
  a08=(a28*a13);
  a05=(a05+a08);
  a08=(a05/a30);
  a09=(a28*a09);
  a09=(a09/a30);
  a09=(a09/a30);
  a09=(a09*a22);
  a08=(a08-a09);
  if (res[2]!=0) res[2][43]=a08;
  if (res[2]!=0) res[2][44]=a32;
  if (res[2]!=0) res[2][45]=a32;
  if (res[2]!=0) res[2][46]=a32;
  if (res[2]!=0) res[2][47]=a32;
  if (res[2]!=0) res[2][48]=a32;
  a10=(a54*a10);
  a07=(a12*a07);
  a10=(a10+a07);
  a07=(a10/a23);
  a12=(a12*a54);
  a54=(a12/a23);
  a54=(a54/a23);
  a54=(a54*a26);
  a07=(a07-a54);
  a07=(-a07);
  if (res[2]!=0) res[2][49]=a07;
  a54=(a12*a25);
  a08=(a28*a10);
  a54=(a54+a08);
  a08=(a54/a30);
  a12=(a28*a12);
  a12=(a12/a30);
  a12=(a12/a30);
  a12=(a12*a22);
  a08=(a08-a12);
  if (res[2]!=0) res[2][50]=a08;
  if (res[2]!=0) res[2][51]=a32;
  if (res[2]!=0) res[2][52]=a32;
  if (res[2]!=0) res[2][53]=a32;
  if (res[2]!=0) res[2][54]=a32;
  if (res[2]!=0) res[2][55]=a32;
  a50=(2.*a50);
  a08=(a50/a23);
  a46=(2.*a46);
  a12=(a46/a23);
  a12=(a12/a23);
  a12=(a12*a26);
  a08=(a08-a12);
  a08=(-a08);
  if (res[2]!=0) res[2][56]=a08;
  a29=(a46*a29);
  a12=(a31*a50);
  a29=(a29+a12);
  a12=(a29/a30);
  a31=(a31*a46);
  a31=(a31/a30);
  a31=(a31/a30);
  a31=(a31*a22);
  a12=(a12-a31);
  a12=(-a12);
  if (res[2]!=0) res[2][57]=a12;
  if (res[2]!=0) res[2][58]=a32;
  if (res[2]!=0) res[2][59]=a32;
  if (res[2]!=0) res[2][60]=a32;
  if (res[2]!=0) res[2][61]=a32;
  if (res[2]!=0) res[2][62]=a32;
  a12=(a58/a23);
  a31=(a53/a23);
  a31=(a31/a23);
  a31=(a31*a26);
  a12=(a12-a31);
  a12=(-a12);
  if (res[2]!=0) res[2][63]=a12;
  a31=(a53*a25);
  a23=(a28*a58);
  a31=(a31+a23);
  a23=(a31/a30);
  a28=(a28*a53);
  a28=(a28/a30);
  a28=(a28/a30);
  a28=(a28*a22);
  a23=(a23-a28);
  if (res[2]!=0) res[2][64]=a23;
  if (res[2]!=0) res[2][65]=a32;
  if (res[2]!=0) res[2][66]=a32;
  if (res[2]!=0) res[2][67]=a32;
  if (res[2]!=0) res[2][68]=a32;
  if (res[2]!=0) res[2][69]=a32;
  if (res[2]!=0) res[2][70]=a32;
  if (res[2]!=0) res[2][71]=a32;
  if (res[2]!=0) res[2][72]=a32;
  if (res[2]!=0) res[2][73]=a32;
  if (res[2]!=0) res[2][74]=a32;
  if (res[2]!=0) res[2][75]=a32;
  if (res[2]!=0) res[2][76]=a32;
  a23=(1./a01);
  a23=(a23/a01);
  a23=(a23*a06);
  a23=(-a23);
  if (res[3]!=0) res[3][0]=a23;
  a23=(1./a01);
  a23=(a23/a01);
  a23=(a23*a06);
  a23=(-a23);
  if (res[3]!=0) res[3][1]=a23;
  a23=(1./a01);
  a23=(a23/a01);
  a23=(a23*a06);
  a23=(-a23);
  if (res[3]!=0) res[3][2]=a23;
  if (res[3]!=0) res[3][3]=a02;
  if (res[3]!=0) res[3][4]=a16;
  if (res[3]!=0) res[3][5]=a20;
  if (res[3]!=0) res[3][6]=a24;
  a18=(-a18);
  if (res[3]!=0) res[3][7]=a18;
  if (res[3]!=0) res[3][8]=a27;
  if (res[3]!=0) res[3][9]=a32;
  if (res[3]!=0) res[3][10]=a38;
  a04=(-a04);
  if (res[3]!=0) res[3][11]=a04;
  if (res[3]!=0) res[3][12]=a32;
  if (res[3]!=0) res[3][13]=a37;
  a35=(-a35);
  if (res[3]!=0) res[3][14]=a35;
  a40=(-a40);
  if (res[3]!=0) res[3][15]=a40;
  if (res[3]!=0) res[3][16]=a41;
  if (res[3]!=0) res[3][17]=a39;
  a43=(-a43);
  if (res[3]!=0) res[3][18]=a43;
  if (res[3]!=0) res[3][19]=a32;
  if (res[3]!=0) res[3][20]=a32;
  if (res[3]!=0) res[3][21]=a32;
  if (res[3]!=0) res[3][22]=a32;
  if (res[3]!=0) res[3][23]=a32;
  if (res[3]!=0) res[3][24]=a32;
  if (res[3]!=0) res[3][25]=a32;
  if (res[3]!=0) res[3][26]=a32;
  if (res[3]!=0) res[3][27]=a32;
  if (res[3]!=0) res[3][28]=a32;
  if (res[3]!=0) res[3][29]=a32;
  if (res[3]!=0) res[3][30]=a32;
  if (res[3]!=0) res[3][31]=a32;
  if (res[3]!=0) res[3][32]=a32;
  if (res[3]!=0) res[3][33]=a32;
  if (res[3]!=0) res[3][34]=a32;
  if (res[3]!=0) res[3][35]=a32;
  if (res[3]!=0) res[3][36]=a32;
  if (res[3]!=0) res[3][37]=a32;
  if (res[3]!=0) res[3][38]=a32;
  if (res[3]!=0) res[3][39]=a32;
  if (res[3]!=0) res[3][40]=a32;
  if (res[3]!=0) res[3][41]=a32;
  if (res[3]!=0) res[3][42]=a32;
  if (res[3]!=0) res[3][43]=a32;
  if (res[3]!=0) res[3][44]=a32;
  if (res[3]!=0) res[3][45]=a32;
  if (res[3]!=0) res[3][46]=a32;
  if (res[3]!=0) res[3][47]=a32;
  if (res[3]!=0) res[3][48]=a32;
  if (res[3]!=0) res[3][49]=a32;
  if (res[3]!=0) res[3][50]=a32;
  if (res[3]!=0) res[3][51]=a32;
  if (res[3]!=0) res[3][52]=a32;
  if (res[3]!=0) res[3][53]=a32;
  if (res[3]!=0) res[3][54]=a32;
  if (res[3]!=0) res[3][55]=a32;
  if (res[3]!=0) res[3][56]=a32;
  if (res[3]!=0) res[3][57]=a32;
  if (res[3]!=0) res[3][58]=a32;
  if (res[3]!=0) res[3][59]=a32;
  if (res[3]!=0) res[3][60]=a32;
  if (res[3]!=0) res[3][61]=a32;
  if (res[3]!=0) res[3][62]=a32;
  if (res[3]!=0) res[3][63]=a32;
  if (res[3]!=0) res[3][64]=a32;
  if (res[3]!=0) res[3][65]=a32;
  if (res[3]!=0) res[3][66]=a32;
  if (res[3]!=0) res[3][67]=a32;
  if (res[3]!=0) res[3][68]=a32;
  if (res[3]!=0) res[3][69]=a32;
  if (res[4]!=0) res[4][0]=a32;
  if (res[4]!=0) res[4][1]=a32;
  if (res[4]!=0) res[4][2]=a32;
  if (res[4]!=0) res[4][3]=a32;
  if (res[4]!=0) res[4][4]=a32;
  if (res[4]!=0) res[4][5]=a32;
  if (res[4]!=0) res[4][6]=a44;
  if (res[4]!=0) res[4][7]=a32;
  a25=(-a25);
  if (res[4]!=0) res[4][8]=a25;
  if (res[4]!=0) res[4][9]=a32;
  if (res[5]!=0) res[5][0]=a32;
  if (res[5]!=0) res[5][1]=a32;
  if (res[5]!=0) res[5][2]=a32;
  if (res[5]!=0) res[5][3]=a32;
  if (res[5]!=0) res[5][4]=a32;
  if (res[5]!=0) res[5][5]=a32;
  if (res[5]!=0) res[5][6]=a62;
  if (res[5]!=0) res[5][7]=a32;
  if (res[5]!=0) res[5][8]=a32;
  a62=arg[11]? arg[11][10] : 0;
  if (res[5]!=0) res[5][9]=a62;
  if (res[5]!=0) res[5][10]=a32;
  if (res[5]!=0) res[5][11]=a32;
  if (res[5]!=0) res[5][12]=a32;
  if (res[5]!=0) res[5][13]=a32;
  if (res[5]!=0) res[5][14]=a32;
  if (res[5]!=0) res[5][15]=a32;
  if (res[5]!=0) res[5][16]=a32;
  if (res[5]!=0) res[5][17]=a32;
  if (res[5]!=0) res[5][18]=a32;
  if (res[5]!=0) res[5][19]=a32;
  if (res[5]!=0) res[5][20]=a61;
  if (res[5]!=0) res[5][21]=a32;
  if (res[5]!=0) res[5][22]=a32;
  if (res[5]!=0) res[5][23]=a51;
  if (res[5]!=0) res[5][24]=a32;
  if (res[5]!=0) res[5][25]=a32;
  if (res[5]!=0) res[5][26]=a67;
  a51=(-a51);
  if (res[5]!=0) res[5][27]=a51;
  a47=(-a47);
  if (res[5]!=0) res[5][28]=a47;
  if (res[5]!=0) res[5][29]=a32;
  if (res[5]!=0) res[5][30]=a32;
  a65=(-a65);
  if (res[5]!=0) res[5][31]=a65;
  if (res[5]!=0) res[5][32]=a32;
  if (res[5]!=0) res[5][33]=a32;
  a64=(-a64);
  if (res[5]!=0) res[5][34]=a64;
  a55=(-a55);
  if (res[5]!=0) res[5][35]=a55;
  if (res[5]!=0) res[5][36]=a68;
  if (res[5]!=0) res[5][37]=a59;
  if (res[5]!=0) res[5][38]=a60;
  if (res[5]!=0) res[5][39]=a32;
  a48=(-a48);
  if (res[5]!=0) res[5][40]=a48;
  a57=(-a57);
  if (res[5]!=0) res[5][41]=a57;
  a34=(a34/a69);
  a42=(a42/a69);
  a42=(a42/a69);
  a42=(a42*a63);
  a34=(a34-a42);
  a34=(-a34);
  if (res[5]!=0) res[5][42]=a34;
  if (res[5]!=0) res[5][43]=a00;
  if (res[5]!=0) res[5][44]=a66;
  a19=(-a19);
  if (res[5]!=0) res[5][45]=a19;
  if (res[5]!=0) res[5][46]=a11;
  if (res[5]!=0) res[5][47]=a70;
  if (res[5]!=0) res[5][48]=a49;
  if (res[5]!=0) res[5][49]=a32;
  if (res[5]!=0) res[5][50]=a32;
  if (res[5]!=0) res[5][51]=a32;
  if (res[5]!=0) res[5][52]=a32;
  if (res[5]!=0) res[5][53]=a32;
  if (res[5]!=0) res[5][54]=a56;
  if (res[5]!=0) res[5][55]=a32;
  if (res[5]!=0) res[5][56]=a17;
  a56=(-a56);
  if (res[5]!=0) res[5][57]=a56;
  if (res[5]!=0) res[5][58]=a33;
  if (res[5]!=0) res[5][59]=a32;
  if (res[5]!=0) res[5][60]=a32;
  if (res[5]!=0) res[5][61]=a32;
  if (res[5]!=0) res[5][62]=a32;
  if (res[5]!=0) res[5][63]=a32;
  if (res[5]!=0) res[5][64]=a13;
  if (res[5]!=0) res[5][65]=a32;
  if (res[5]!=0) res[5][66]=a52;
  a13=(-a13);
  if (res[5]!=0) res[5][67]=a13;
  if (res[5]!=0) res[5][68]=a05;
  if (res[5]!=0) res[5][69]=a32;
  if (res[5]!=0) res[5][70]=a32;
  if (res[5]!=0) res[5][71]=a32;
  if (res[5]!=0) res[5][72]=a32;
  if (res[5]!=0) res[5][73]=a32;
  if (res[5]!=0) res[5][74]=a10;
  if (res[5]!=0) res[5][75]=a32;
  if (res[5]!=0) res[5][76]=a07;
  a10=(-a10);
  if (res[5]!=0) res[5][77]=a10;
  if (res[5]!=0) res[5][78]=a54;
  if (res[5]!=0) res[5][79]=a32;
  if (res[5]!=0) res[5][80]=a32;
  if (res[5]!=0) res[5][81]=a32;
  if (res[5]!=0) res[5][82]=a32;
  if (res[5]!=0) res[5][83]=a50;
  if (res[5]!=0) res[5][84]=a32;
  if (res[5]!=0) res[5][85]=a32;
  if (res[5]!=0) res[5][86]=a08;
  a50=(-a50);
  if (res[5]!=0) res[5][87]=a50;
  a29=(-a29);
  if (res[5]!=0) res[5][88]=a29;
  if (res[5]!=0) res[5][89]=a32;
  if (res[5]!=0) res[5][90]=a32;
  if (res[5]!=0) res[5][91]=a32;
  if (res[5]!=0) res[5][92]=a32;
  if (res[5]!=0) res[5][93]=a32;
  if (res[5]!=0) res[5][94]=a32;
  if (res[5]!=0) res[5][95]=a58;
  if (res[5]!=0) res[5][96]=a12;
  a58=(-a58);
  if (res[5]!=0) res[5][97]=a58;
  if (res[5]!=0) res[5][98]=a31;
  if (res[5]!=0) res[5][99]=a32;
  if (res[5]!=0) res[5][100]=a32;
  if (res[5]!=0) res[5][101]=a32;
  if (res[5]!=0) res[5][102]=a32;
  if (res[5]!=0) res[5][103]=a32;
  if (res[5]!=0) res[5][104]=a32;
  if (res[5]!=0) res[5][105]=a32;
  if (res[5]!=0) res[5][106]=a32;
  if (res[5]!=0) res[5][107]=a32;
  if (res[5]!=0) res[5][108]=a32;
  if (res[5]!=0) res[5][109]=a26;
  return 0;
}

CASADI_SYMBOL_EXPORT int fwd1_linear_jacobians(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f9(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int fwd1_linear_jacobians_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void fwd1_linear_jacobians_release(int mem) {
}

CASADI_SYMBOL_EXPORT void fwd1_linear_jacobians_incref(void) {
}

CASADI_SYMBOL_EXPORT void fwd1_linear_jacobians_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int fwd1_linear_jacobians_n_in(void) { return 12;}

CASADI_SYMBOL_EXPORT casadi_int fwd1_linear_jacobians_n_out(void) { return 6;}

CASADI_SYMBOL_EXPORT casadi_real fwd1_linear_jacobians_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* fwd1_linear_jacobians_name_in(casadi_int i) {
  switch (i) {
    case 0: return "x";
    case 1: return "u";
    case 2: return "p";
    case 3: return "out_fx";
    case 4: return "out_fu";
    case 5: return "out_fp";
    case 6: return "out_gx";
    case 7: return "out_gu";
    case 8: return "out_gp";
    case 9: return "fwd_x";
    case 10: return "fwd_u";
    case 11: return "fwd_p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* fwd1_linear_jacobians_name_out(casadi_int i) {
  switch (i) {
    case 0: return "fwd_fx";
    case 1: return "fwd_fu";
    case 2: return "fwd_fp";
    case 3: return "fwd_gx";
    case 4: return "fwd_gu";
    case 5: return "fwd_gp";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* fwd1_linear_jacobians_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    case 3: return casadi_s12;
    case 4: return casadi_s3;
    case 5: return casadi_s13;
    case 6: return casadi_s14;
    case 7: return casadi_s7;
    case 8: return casadi_s15;
    case 9: return casadi_s0;
    case 10: return casadi_s1;
    case 11: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* fwd1_linear_jacobians_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    case 1: return casadi_s0;
    case 2: return casadi_s9;
    case 3: return casadi_s10;
    case 4: return casadi_s6;
    case 5: return casadi_s11;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int fwd1_linear_jacobians_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int fwd1_linear_jacobians_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* adj1_linear_jacobians:(x[7],u,p[11],out_fx[7x7,0nz],out_fu[7x1,0nz],out_fp[7x11,0nz],out_gx[10x7,0nz],out_gu[10x1,0nz],out_gp[10x11,0nz],adj_fx[7x7],adj_fu[7],adj_fp[7x11],adj_gx[10x7],adj_gu[10],adj_gp[10x11])->(adj_x[7],adj_u,adj_p[11]) */
static int casadi_f10(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a000, a001, a002, a003, a004, a005, a006, a007, a008, a009, a010, a011;
  casadi_real a012, a013, a014, a015, a016, a017, a018, a019, a020, a021, a022, a023;
  casadi_real a024, a025, a026, a027, a028, a029, a030, a031, a032, a033, a034, a035;
  casadi_real a036, a037, a038, a039, a040, a041, a042, a043, a044, a045, a046, a047;
  casadi_real a048, a049, a050, a051, a052, a053, a054, a055, a056, a057, a058, a059;
  casadi_real a060, a061, a062, a063, a064, a065, a066, a067, a068, a069, a070, a071;
  casadi_real a072, a073, a074, a075, a076, a077, a078, a079, a080, a081, a082, a083;
  casadi_real a084, a085, a086, a087, a088, a089, a090, a091, a092, a093, a094, a095;
  casadi_real a096, a097, a098, a099, a100, a101, a102, a103, a104;
  a000=arg[2]? arg[2][9] : 0;
  a001=arg[14]? arg[14][47] : 0;
  a002=arg[14]? arg[14][46] : 0;
  a003=arg[11]? arg[11][28] : 0;
  a002=(a002+a003);
  a004=arg[2]? arg[2][0] : 0;
  a005=(a002/a004);
  a001=(a001+a005);
  a005=arg[14]? arg[14][45] : 0;
  a006=arg[2]? arg[2][3] : 0;
  a007=arg[14]? arg[14][48] : 0;
  a008=arg[11]? arg[11][29] : 0;
  a009=arg[2]? arg[2][1] : 0;
  a010=(a008/a009);
  a007=(a007+a010);
  a010=(a006*a007);
  a005=(a005+a010);
  a005=(a001-a005);
  a010=(a000*a005);
  a011=arg[14]? arg[14][41] : 0;
  a012=arg[2]? arg[2][6] : 0;
  a013=arg[2]? arg[2][7] : 0;
  a014=(a012*a013);
  a015=arg[2]? arg[2][5] : 0;
  a016=(a014*a015);
  a017=5.0000000000000000e-01;
  a018=arg[2]? arg[2][4] : 0;
  a019=casadi_sq(a018);
  a019=(a017*a019);
  a020=(a016*a019);
  a021=arg[14]? arg[14][44] : 0;
  a022=(a006*a007);
  a021=(a021+a022);
  a021=(a021-a001);
  a022=(a020*a021);
  a011=(a011+a022);
  a010=(a010-a011);
  a011=casadi_sq(a018);
  a022=(a010/a011);
  a023=arg[14]? arg[14][95] : 0;
  a024=arg[14]? arg[14][97] : 0;
  a023=(a023-a024);
  a024=arg[14]? arg[14][98] : 0;
  a025=arg[11]? arg[11][64] : 0;
  a026=(a025/a009);
  a024=(a024+a026);
  a026=(a006*a024);
  a023=(a023+a026);
  a026=arg[14]? arg[14][96] : 0;
  a027=arg[11]? arg[11][63] : 0;
  a026=(a026+a027);
  a027=(a026/a004);
  a023=(a023-a027);
  a027=arg[14]? arg[14][74] : 0;
  a028=arg[14]? arg[14][77] : 0;
  a027=(a027-a028);
  a028=arg[14]? arg[14][78] : 0;
  a029=arg[11]? arg[11][50] : 0;
  a030=(a029/a009);
  a028=(a028+a030);
  a030=(a006*a028);
  a027=(a027+a030);
  a030=arg[14]? arg[14][76] : 0;
  a031=arg[11]? arg[11][49] : 0;
  a030=(a030+a031);
  a031=(a030/a004);
  a027=(a027-a031);
  a031=(a012*a027);
  a032=arg[14]? arg[14][64] : 0;
  a033=arg[14]? arg[14][67] : 0;
  a032=(a032-a033);
  a033=arg[14]? arg[14][68] : 0;
  a034=arg[11]? arg[11][43] : 0;
  a035=(a034/a009);
  a033=(a033+a035);
  a035=(a006*a033);
  a032=(a032+a035);
  a035=arg[14]? arg[14][66] : 0;
  a036=arg[11]? arg[11][42] : 0;
  a035=(a035+a036);
  a036=(a035/a004);
  a032=(a032-a036);
  a036=(a013*a032);
  a031=(a031+a036);
  a036=(a019*a031);
  a037=(a015*a036);
  a023=(a023+a037);
  a037=arg[14]? arg[14][38] : 0;
  a038=arg[11]? arg[11][22] : 0;
  a039=(a038/a009);
  a037=(a037+a039);
  a039=arg[14]? arg[14][6] : 0;
  a040=arg[11]? arg[11][0] : 0;
  a039=(a039+a040);
  a040=casadi_sq(a004);
  a041=(a039/a040);
  a042=(a037+a041);
  a043=arg[11]? arg[11][8] : 0;
  a044=casadi_sq(a009);
  a045=(a043/a044);
  a046=(a006*a045);
  a046=(a042-a046);
  a047=(a000*a046);
  a023=(a023+a047);
  a047=(a012*a013);
  a048=arg[14]? arg[14][54] : 0;
  a049=arg[14]? arg[14][57] : 0;
  a048=(a048-a049);
  a049=arg[14]? arg[14][58] : 0;
  a050=arg[11]? arg[11][36] : 0;
  a051=(a050/a009);
  a049=(a049+a051);
  a051=(a006*a049);
  a048=(a048+a051);
  a051=arg[14]? arg[14][56] : 0;
  a052=arg[11]? arg[11][35] : 0;
  a051=(a051+a052);
  a052=(a051/a004);
  a048=(a048-a052);
  a052=(a019*a048);
  a053=(a015*a018);
  a054=(a053*a021);
  a052=(a052+a054);
  a054=(a006*a045);
  a054=(a042-a054);
  a055=(a019*a054);
  a056=(a015*a055);
  a052=(a052+a056);
  a056=(a047*a052);
  a023=(a023+a056);
  a056=(a023/a018);
  a022=(a022+a056);
  a056=arg[14]? arg[14][42] : 0;
  a057=(a056/a011);
  a057=(a022-a057);
  a058=arg[14]? arg[14][83] : 0;
  a059=arg[14]? arg[14][87] : 0;
  a058=(a058-a059);
  a059=arg[2]? arg[2][2] : 0;
  a060=arg[14]? arg[14][88] : 0;
  a061=arg[11]? arg[11][57] : 0;
  a062=(a061/a009);
  a060=(a060+a062);
  a062=(a059*a060);
  a058=(a058-a062);
  a062=arg[14]? arg[14][86] : 0;
  a063=arg[11]? arg[11][56] : 0;
  a062=(a062+a063);
  a063=(a062/a004);
  a058=(a058-a063);
  a058=(2.*a058);
  a063=arg[2]? arg[2][8] : 0;
  a064=(a059*a045);
  a065=arg[14]? arg[14][28] : 0;
  a066=arg[11]? arg[11][15] : 0;
  a067=(a066/a009);
  a065=(a065+a067);
  a064=(a064-a065);
  a064=(a064+a041);
  a064=(2.*a064);
  a041=(a063*a064);
  a058=(a058+a041);
  a041=(a058/a018);
  a067=arg[14]? arg[14][40] : 0;
  a068=arg[14]? arg[14][43] : 0;
  a069=(a059*a007);
  a068=(a068-a069);
  a068=(a068-a001);
  a068=(2.*a068);
  a001=(a063*a068);
  a067=(a067+a001);
  a001=(a067/a011);
  a041=(a041-a001);
  a057=(a057+a041);
  a001=arg[0]? arg[0][6] : 0;
  a069=sin(a001);
  a070=arg[9]? arg[9][47] : 0;
  a069=(a069*a070);
  a057=(a057-a069);
  a069=cos(a001);
  a071=arg[9]? arg[9][46] : 0;
  a069=(a069*a071);
  a057=(a057-a069);
  if (res[0]!=0) res[0][0]=a057;
  a057=arg[14]? arg[14][37] : 0;
  a069=arg[14]? arg[14][36] : 0;
  a072=arg[11]? arg[11][21] : 0;
  a069=(a069+a072);
  a072=(a069/a004);
  a057=(a057+a072);
  a072=arg[14]? arg[14][35] : 0;
  a073=(a006*a037);
  a072=(a072+a073);
  a072=(a057-a072);
  a073=(a000*a072);
  a074=arg[14]? arg[14][31] : 0;
  a073=(a073-a074);
  a074=arg[14]? arg[14][34] : 0;
  a075=(a006*a037);
  a074=(a074+a075);
  a057=(a057-a074);
  a074=(a020*a057);
  a073=(a073+a074);
  a074=(a073/a018);
  a074=(a074-a003);
  a003=arg[14]? arg[14][20] : 0;
  a075=arg[14]? arg[14][23] : 0;
  a076=arg[14]? arg[14][27] : 0;
  a075=(a075-a076);
  a076=(a059*a065);
  a075=(a075-a076);
  a076=arg[14]? arg[14][26] : 0;
  a077=arg[11]? arg[11][14] : 0;
  a076=(a076+a077);
  a077=(a076/a004);
  a075=(a075-a077);
  a075=(2.*a075);
  a077=(a063*a075);
  a003=(a003+a077);
  a077=(a003/a018);
  a074=(a074+a077);
  a077=(a006*a022);
  a074=(a074-a077);
  a077=(a059*a041);
  a074=(a074+a077);
  if (res[0]!=0) res[0][1]=a074;
  a074=0.;
  if (res[0]!=0) res[0][2]=a074;
  if (res[0]!=0) res[0][3]=a074;
  if (res[0]!=0) res[0][4]=a074;
  if (res[0]!=0) res[0][5]=a074;
  a074=cos(a001);
  a077=arg[11]? arg[11][33] : 0;
  a074=(a074*a077);
  a077=sin(a001);
  a078=arg[11]? arg[11][32] : 0;
  a077=(a077*a078);
  a074=(a074-a077);
  a077=cos(a001);
  a078=arg[0]? arg[0][0] : 0;
  a079=(a078*a070);
  a077=(a077*a079);
  a074=(a074-a077);
  a077=sin(a001);
  a079=(a018*a070);
  a077=(a077*a079);
  a074=(a074-a077);
  a077=sin(a001);
  a079=(a078*a071);
  a077=(a077*a079);
  a074=(a074+a077);
  a077=cos(a001);
  a079=(a018*a071);
  a077=(a077*a079);
  a074=(a074-a077);
  a077=sin(a001);
  a079=arg[9]? arg[9][5] : 0;
  a077=(a077*a079);
  a074=(a074-a077);
  a077=cos(a001);
  a079=arg[9]? arg[9][4] : 0;
  a077=(a077*a079);
  a074=(a074-a077);
  if (res[0]!=0) res[0][6]=a074;
  a074=(a006*a045);
  a074=(a074-a042);
  if (res[1]!=0) res[1][0]=a074;
  a074=arg[14]? arg[14][109] : 0;
  a042=arg[0]? arg[0][1] : 0;
  a077=(a006*a042);
  a077=(a078-a077);
  a079=(a077/a018);
  a080=(a079/a004);
  a080=(a080/a004);
  a080=(a080*a026);
  a074=(a074+a080);
  a080=(a059*a042);
  a080=(a080+a078);
  a026=(a080/a018);
  a081=(2.*a026);
  a082=(a081/a004);
  a082=(a082/a004);
  a082=(a082*a062);
  a074=(a074+a082);
  a082=(a079*a015);
  a062=(a082*a019);
  a083=(a012*a062);
  a084=(a083/a004);
  a084=(a084/a004);
  a084=(a084*a030);
  a074=(a074+a084);
  a084=(a013*a062);
  a030=(a084/a004);
  a030=(a030/a004);
  a030=(a030*a035);
  a074=(a074+a030);
  a047=(a047*a079);
  a030=(a047*a019);
  a035=(a030/a004);
  a035=(a035/a004);
  a035=(a035*a051);
  a074=(a074+a035);
  a077=(a077/a011);
  a035=(a000*a077);
  a080=(a080/a011);
  a051=(a063*a080);
  a051=(-a051);
  a051=(2.*a051);
  a053=(a053*a047);
  a085=(a077*a020);
  a053=(a053-a085);
  a085=(a051+a053);
  a085=(a035-a085);
  a085=(a085/a004);
  a085=(a085/a004);
  a085=(a085*a002);
  a074=(a074-a085);
  a085=(a042/a018);
  a002=(a085*a020);
  a086=(a000*a085);
  a087=(a002+a086);
  a087=(a087/a004);
  a087=(a087/a004);
  a087=(a087*a069);
  a074=(a074-a087);
  a087=(a042/a018);
  a069=(a063*a087);
  a069=(2.*a069);
  a088=(a069/a004);
  a088=(a088/a004);
  a088=(a088*a076);
  a074=(a074+a088);
  a088=(2.*a004);
  a076=(a063*a026);
  a076=(2.*a076);
  a089=(a015*a047);
  a090=(a089*a019);
  a091=arg[1]? arg[1][0] : 0;
  a092=(a090-a091);
  a093=(a000*a079);
  a092=(a092+a093);
  a094=(a076+a092);
  a094=(a094/a040);
  a094=(a094/a040);
  a094=(a094*a039);
  a088=(a088*a094);
  a074=(a074-a088);
  a088=(1./a004);
  a088=(a088/a004);
  a094=arg[13]? arg[13][6] : 0;
  a039=arg[10]? arg[10][0] : 0;
  a094=(a094+a039);
  a088=(a088*a094);
  a074=(a074-a088);
  a088=(a006/a018);
  a094=(a088*a020);
  a039=(a059/a018);
  a040=(a063*a039);
  a040=(2.*a040);
  a095=(a094-a040);
  a096=(a000*a088);
  a095=(a095+a096);
  a095=(a095/a004);
  a095=(a095/a004);
  a097=arg[12]? arg[12][16] : 0;
  a098=arg[9]? arg[9][7] : 0;
  a097=(a097+a098);
  a095=(a095*a097);
  a074=(a074-a095);
  a095=(a063/a018);
  a099=(2.*a095);
  a100=(a020/a018);
  a101=(a099+a100);
  a102=(a000/a018);
  a101=(a101+a102);
  a101=(a101/a004);
  a101=(a101/a004);
  a103=arg[12]? arg[12][6] : 0;
  a104=arg[9]? arg[9][0] : 0;
  a103=(a103+a104);
  a101=(a101*a103);
  a074=(a074+a101);
  if (res[2]!=0) res[2][0]=a074;
  a074=(a059*a081);
  a074=(a074/a009);
  a074=(a074/a009);
  a074=(a074*a061);
  a061=(a006*a079);
  a061=(a061/a009);
  a061=(a061/a009);
  a061=(a061*a025);
  a074=(a074-a061);
  a061=(a006*a083);
  a061=(a061/a009);
  a061=(a061/a009);
  a061=(a061*a029);
  a074=(a074-a061);
  a061=(a006*a084);
  a061=(a061/a009);
  a061=(a061/a009);
  a061=(a061*a034);
  a074=(a074-a061);
  a061=(a006*a030);
  a061=(a061/a009);
  a061=(a061/a009);
  a061=(a061*a050);
  a074=(a074-a061);
  a061=(a006*a053);
  a050=(a059*a051);
  a061=(a061-a050);
  a050=(a006*a035);
  a061=(a061-a050);
  a061=(a061/a009);
  a061=(a061/a009);
  a061=(a061*a008);
  a074=(a074-a061);
  a061=(a006*a002);
  a008=(a006*a086);
  a061=(a061+a008);
  a092=(a092-a061);
  a092=(a092/a009);
  a092=(a092/a009);
  a092=(a092*a038);
  a074=(a074-a092);
  a092=(a059*a069);
  a092=(a076+a092);
  a092=(a092/a009);
  a092=(a092/a009);
  a092=(a092*a066);
  a074=(a074+a092);
  a092=(2.*a009);
  a066=(a090*a006);
  a038=(a091*a006);
  a061=(a076*a059);
  a038=(a038+a061);
  a066=(a066-a038);
  a038=(a093*a006);
  a066=(a066+a038);
  a066=(a066/a044);
  a066=(a066/a044);
  a066=(a066*a043);
  a092=(a092*a066);
  a074=(a074+a092);
  a092=(a006/a009);
  a092=(a092/a009);
  a066=arg[10]? arg[10][1] : 0;
  a092=(a092*a066);
  a074=(a074+a092);
  a092=(a059*a040);
  a043=(a006*a094);
  a092=(a092+a043);
  a043=(a006*a096);
  a092=(a092+a043);
  a092=(a092/a009);
  a092=(a092/a009);
  a043=arg[9]? arg[9][8] : 0;
  a092=(a092*a043);
  a074=(a074+a092);
  a092=(a006*a100);
  a044=(a059*a099);
  a092=(a092-a044);
  a044=(a006*a102);
  a092=(a092+a044);
  a092=(a092/a009);
  a092=(a092/a009);
  a044=arg[9]? arg[9][1] : 0;
  a092=(a092*a044);
  a074=(a074-a092);
  if (res[2]!=0) res[2][1]=a074;
  a076=(a076*a045);
  a081=(a081*a060);
  a051=(a051*a007);
  a081=(a081+a051);
  a069=(a069*a065);
  a081=(a081+a069);
  a076=(a076-a081);
  a041=(a042*a041);
  a076=(a076+a041);
  a041=arg[12]? arg[12][18] : 0;
  a043=(a043/a009);
  a041=(a041+a043);
  a040=(a040*a041);
  a076=(a076-a040);
  a040=arg[12]? arg[12][10] : 0;
  a043=arg[12]? arg[12][13] : 0;
  a081=(a059*a041);
  a043=(a043-a081);
  a081=arg[12]? arg[12][17] : 0;
  a097=(a097/a004);
  a081=(a081+a097);
  a043=(a043-a081);
  a043=(2.*a043);
  a063=(a063*a043);
  a040=(a040+a063);
  a063=(a040/a018);
  a076=(a076+a063);
  a063=arg[12]? arg[12][8] : 0;
  a044=(a044/a009);
  a063=(a063+a044);
  a099=(a099*a063);
  a076=(a076-a099);
  if (res[2]!=0) res[2][2]=a076;
  a024=(a079*a024);
  a076=arg[13]? arg[13][8] : 0;
  a024=(a024-a076);
  a083=(a083*a028);
  a024=(a024+a083);
  a084=(a084*a033);
  a024=(a024+a084);
  a030=(a030*a049);
  a024=(a024+a030);
  a035=(a035*a007);
  a024=(a024-a035);
  a053=(a053*a007);
  a024=(a024+a053);
  a086=(a086*a037);
  a024=(a024-a086);
  a002=(a002*a037);
  a024=(a024-a002);
  a093=(a093*a045);
  a024=(a024-a093);
  a091=(a091*a045);
  a024=(a024+a091);
  a090=(a090*a045);
  a024=(a024-a090);
  a042=(a042*a022);
  a024=(a024-a042);
  a066=(a066/a009);
  a024=(a024-a066);
  a096=(a096*a041);
  a024=(a024-a096);
  a094=(a094*a041);
  a024=(a024-a094);
  a094=arg[12]? arg[12][15] : 0;
  a096=(a006*a041);
  a094=(a094+a096);
  a094=(a081-a094);
  a000=(a000*a094);
  a096=arg[12]? arg[12][11] : 0;
  a000=(a000-a096);
  a096=arg[12]? arg[12][14] : 0;
  a041=(a006*a041);
  a096=(a096+a041);
  a081=(a081-a096);
  a020=(a020*a081);
  a000=(a000+a020);
  a020=(a000/a018);
  a024=(a024+a020);
  a020=(a102*a063);
  a024=(a024+a020);
  a020=(a100*a063);
  a024=(a024+a020);
  if (res[2]!=0) res[2][3]=a024;
  a024=(a047*a021);
  a020=(a015*a024);
  a096=(1./a018);
  a096=(a096/a018);
  a041=arg[12]? arg[12][2] : 0;
  a096=(a096*a041);
  a041=(1./a018);
  a041=(a041/a018);
  a066=arg[12]? arg[12][1] : 0;
  a041=(a041*a066);
  a096=(a096+a041);
  a041=(1./a018);
  a041=(a041/a018);
  a066=arg[12]? arg[12][0] : 0;
  a041=(a041*a066);
  a096=(a096+a041);
  a020=(a020-a096);
  a096=(2.*a018);
  a078=(a078/a011);
  a078=(a078/a011);
  a078=(a078*a056);
  a056=(a080/a011);
  a056=(a056*a067);
  a078=(a078+a056);
  a011=(a077/a011);
  a011=(a011*a010);
  a078=(a078-a011);
  a096=(a096*a078);
  a020=(a020+a096);
  a096=(a085/a018);
  a096=(a096*a073);
  a020=(a020-a096);
  a096=(a087/a018);
  a096=(a096*a003);
  a020=(a020-a096);
  a096=(a079/a018);
  a096=(a096*a023);
  a020=(a020-a096);
  a096=(a026/a018);
  a096=(a096*a058);
  a020=(a020-a096);
  a096=cos(a001);
  a096=(a096*a070);
  a020=(a020+a096);
  a001=sin(a001);
  a001=(a001*a071);
  a020=(a020-a001);
  a020=(a020-a098);
  a098=(a039/a018);
  a098=(a098*a040);
  a020=(a020-a098);
  a098=(a088/a018);
  a098=(a098*a000);
  a020=(a020-a098);
  a102=(a102/a018);
  a098=arg[12]? arg[12][5] : 0;
  a000=(a006*a063);
  a098=(a098+a000);
  a000=arg[12]? arg[12][7] : 0;
  a103=(a103/a004);
  a000=(a000+a103);
  a098=(a098-a000);
  a102=(a102*a098);
  a020=(a020-a102);
  a100=(a100/a018);
  a102=arg[12]? arg[12][4] : 0;
  a006=(a006*a063);
  a102=(a102+a006);
  a102=(a102-a000);
  a100=(a100*a102);
  a020=(a020-a100);
  a100=(2.*a018);
  a082=(a082*a031);
  a048=(a047*a048);
  a082=(a082+a048);
  a089=(a089*a054);
  a082=(a082+a089);
  a057=(a085*a057);
  a021=(a077*a021);
  a057=(a057-a021);
  a081=(a088*a081);
  a057=(a057+a081);
  a102=(a102/a018);
  a057=(a057+a102);
  a016=(a016*a057);
  a082=(a082+a016);
  a017=(a017*a082);
  a100=(a100*a017);
  a020=(a020+a100);
  a095=(a095/a018);
  a100=arg[12]? arg[12][3] : 0;
  a059=(a059*a063);
  a100=(a100-a059);
  a100=(a100-a000);
  a100=(2.*a100);
  a095=(a095*a100);
  a020=(a020-a095);
  if (res[2]!=0) res[2][4]=a020;
  a036=(a079*a036);
  a024=(a018*a024);
  a036=(a036+a024);
  a047=(a047*a055);
  a036=(a036+a047);
  a019=(a019*a057);
  a014=(a014*a019);
  a036=(a036+a014);
  if (res[2]!=0) res[2][5]=a036;
  a027=(a062*a027);
  a052=(a079*a052);
  a036=(a013*a052);
  a027=(a027+a036);
  a015=(a015*a019);
  a013=(a013*a015);
  a027=(a027+a013);
  if (res[2]!=0) res[2][6]=a027;
  a062=(a062*a032);
  a052=(a012*a052);
  a062=(a062+a052);
  a012=(a012*a015);
  a062=(a062+a012);
  if (res[2]!=0) res[2][7]=a062;
  a087=(a087*a075);
  a080=(a080*a068);
  a087=(a087-a080);
  a026=(a026*a064);
  a087=(a087+a026);
  a039=(a039*a043);
  a087=(a087+a039);
  a100=(a100/a018);
  a087=(a087+a100);
  if (res[2]!=0) res[2][8]=a087;
  a077=(a077*a005);
  a085=(a085*a072);
  a077=(a077+a085);
  a079=(a079*a046);
  a077=(a077+a079);
  a088=(a088*a094);
  a077=(a077+a088);
  a098=(a098/a018);
  a077=(a077+a098);
  if (res[2]!=0) res[2][9]=a077;
  a077=arg[14]? arg[14][9] : 0;
  if (res[2]!=0) res[2][10]=a077;
  return 0;
}

CASADI_SYMBOL_EXPORT int adj1_linear_jacobians(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f10(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int adj1_linear_jacobians_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void adj1_linear_jacobians_release(int mem) {
}

CASADI_SYMBOL_EXPORT void adj1_linear_jacobians_incref(void) {
}

CASADI_SYMBOL_EXPORT void adj1_linear_jacobians_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int adj1_linear_jacobians_n_in(void) { return 15;}

CASADI_SYMBOL_EXPORT casadi_int adj1_linear_jacobians_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real adj1_linear_jacobians_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* adj1_linear_jacobians_name_in(casadi_int i) {
  switch (i) {
    case 0: return "x";
    case 1: return "u";
    case 2: return "p";
    case 3: return "out_fx";
    case 4: return "out_fu";
    case 5: return "out_fp";
    case 6: return "out_gx";
    case 7: return "out_gu";
    case 8: return "out_gp";
    case 9: return "adj_fx";
    case 10: return "adj_fu";
    case 11: return "adj_fp";
    case 12: return "adj_gx";
    case 13: return "adj_gu";
    case 14: return "adj_gp";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* adj1_linear_jacobians_name_out(casadi_int i) {
  switch (i) {
    case 0: return "adj_x";
    case 1: return "adj_u";
    case 2: return "adj_p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* adj1_linear_jacobians_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    case 3: return casadi_s12;
    case 4: return casadi_s3;
    case 5: return casadi_s13;
    case 6: return casadi_s14;
    case 7: return casadi_s7;
    case 8: return casadi_s15;
    case 9: return casadi_s8;
    case 10: return casadi_s0;
    case 11: return casadi_s9;
    case 12: return casadi_s10;
    case 13: return casadi_s6;
    case 14: return casadi_s11;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* adj1_linear_jacobians_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int adj1_linear_jacobians_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 15;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int adj1_linear_jacobians_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 15*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* fwd1_adj1_linear_jacobians:(x[7],u,p[11],out_fx[7x7,0nz],out_fu[7x1,0nz],out_fp[7x11,0nz],out_gx[10x7,0nz],out_gu[10x1,0nz],out_gp[10x11,0nz],adj_fx[7x7],adj_fu[7],adj_fp[7x11],adj_gx[10x7],adj_gu[10],adj_gp[10x11],out_adj_x[7x1,0nz],out_adj_u[1x1,0nz],out_adj_p[11x1,0nz],fwd_x[7],fwd_u,fwd_p[11],fwd_out_fx[7x7,0nz],fwd_out_fu[7x1,0nz],fwd_out_fp[7x11,0nz],fwd_out_gx[10x7,0nz],fwd_out_gu[10x1,0nz],fwd_out_gp[10x11,0nz],fwd_adj_fx[7x7],fwd_adj_fu[7],fwd_adj_fp[7x11],fwd_adj_gx[10x7],fwd_adj_gu[10],fwd_adj_gp[10x11])->(fwd_adj_x[7],fwd_adj_u,fwd_adj_p[11]) */
static int casadi_f11(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
  casadi_real a192, a193, a194, a195, a196, a197, a198, a199, a200, a201, a202, a203;
  casadi_real a204, a205;
  a000=arg[14]? arg[14][47] : 0;
  a001=arg[14]? arg[14][46] : 0;
  a002=arg[11]? arg[11][28] : 0;
  a001=(a001+a002);
  a002=arg[2]? arg[2][0] : 0;
  a003=(a001/a002);
  a000=(a000+a003);
  a004=arg[14]? arg[14][45] : 0;
  a005=arg[2]? arg[2][3] : 0;
  a006=arg[14]? arg[14][48] : 0;
  a007=arg[11]? arg[11][29] : 0;
  a008=arg[2]? arg[2][1] : 0;
  a009=(a007/a008);
  a006=(a006+a009);
  a010=(a005*a006);
  a004=(a004+a010);
  a004=(a000-a004);
  a010=arg[20]? arg[20][9] : 0;
  a011=(a004*a010);
  a012=arg[2]? arg[2][9] : 0;
  a013=arg[32]? arg[32][47] : 0;
  a014=arg[32]? arg[32][46] : 0;
  a015=arg[29]? arg[29][28] : 0;
  a014=(a014+a015);
  a016=(a014/a002);
  a003=(a003/a002);
  a017=arg[20]? arg[20][0] : 0;
  a003=(a003*a017);
  a016=(a016-a003);
  a013=(a013+a016);
  a016=arg[32]? arg[32][45] : 0;
  a003=arg[20]? arg[20][3] : 0;
  a018=(a006*a003);
  a019=arg[32]? arg[32][48] : 0;
  a020=arg[29]? arg[29][29] : 0;
  a021=(a020/a008);
  a009=(a009/a008);
  a022=arg[20]? arg[20][1] : 0;
  a009=(a009*a022);
  a021=(a021-a009);
  a019=(a019+a021);
  a021=(a005*a019);
  a018=(a018+a021);
  a016=(a016+a018);
  a016=(a013-a016);
  a018=(a012*a016);
  a011=(a011+a018);
  a018=arg[32]? arg[32][41] : 0;
  a021=arg[14]? arg[14][44] : 0;
  a009=(a005*a006);
  a021=(a021+a009);
  a021=(a021-a000);
  a009=5.0000000000000000e-01;
  a023=arg[2]? arg[2][4] : 0;
  a024=casadi_sq(a023);
  a024=(a009*a024);
  a025=arg[2]? arg[2][5] : 0;
  a026=arg[2]? arg[2][7] : 0;
  a027=arg[20]? arg[20][6] : 0;
  a028=(a026*a027);
  a029=arg[2]? arg[2][6] : 0;
  a030=arg[20]? arg[20][7] : 0;
  a031=(a029*a030);
  a028=(a028+a031);
  a031=(a025*a028);
  a032=(a029*a026);
  a033=arg[20]? arg[20][5] : 0;
  a034=(a032*a033);
  a031=(a031+a034);
  a034=(a024*a031);
  a035=(a032*a025);
  a036=(2.*a023);
  a037=arg[20]? arg[20][4] : 0;
  a036=(a036*a037);
  a036=(a009*a036);
  a038=(a035*a036);
  a034=(a034+a038);
  a038=(a021*a034);
  a039=(a035*a024);
  a040=arg[32]? arg[32][44] : 0;
  a041=(a006*a003);
  a042=(a005*a019);
  a041=(a041+a042);
  a040=(a040+a041);
  a040=(a040-a013);
  a041=(a039*a040);
  a038=(a038+a041);
  a018=(a018+a038);
  a011=(a011-a018);
  a018=casadi_sq(a023);
  a038=(a011/a018);
  a041=(a012*a004);
  a042=arg[14]? arg[14][41] : 0;
  a043=(a039*a021);
  a042=(a042+a043);
  a041=(a041-a042);
  a042=(a041/a018);
  a043=(a042/a018);
  a044=(2.*a023);
  a044=(a044*a037);
  a043=(a043*a044);
  a038=(a038-a043);
  a043=arg[32]? arg[32][95] : 0;
  a045=arg[32]? arg[32][97] : 0;
  a043=(a043-a045);
  a045=arg[14]? arg[14][98] : 0;
  a046=arg[11]? arg[11][64] : 0;
  a047=(a046/a008);
  a045=(a045+a047);
  a048=(a045*a003);
  a049=arg[32]? arg[32][98] : 0;
  a050=arg[29]? arg[29][64] : 0;
  a051=(a050/a008);
  a047=(a047/a008);
  a047=(a047*a022);
  a051=(a051-a047);
  a049=(a049+a051);
  a051=(a005*a049);
  a048=(a048+a051);
  a043=(a043+a048);
  a048=arg[32]? arg[32][96] : 0;
  a051=arg[29]? arg[29][63] : 0;
  a048=(a048+a051);
  a051=(a048/a002);
  a047=arg[14]? arg[14][96] : 0;
  a052=arg[11]? arg[11][63] : 0;
  a047=(a047+a052);
  a052=(a047/a002);
  a053=(a052/a002);
  a053=(a053*a017);
  a051=(a051-a053);
  a043=(a043-a051);
  a051=arg[14]? arg[14][74] : 0;
  a053=arg[14]? arg[14][77] : 0;
  a051=(a051-a053);
  a053=arg[14]? arg[14][78] : 0;
  a054=arg[11]? arg[11][50] : 0;
  a055=(a054/a008);
  a053=(a053+a055);
  a056=(a005*a053);
  a051=(a051+a056);
  a056=arg[14]? arg[14][76] : 0;
  a057=arg[11]? arg[11][49] : 0;
  a056=(a056+a057);
  a057=(a056/a002);
  a051=(a051-a057);
  a058=(a029*a051);
  a059=arg[14]? arg[14][64] : 0;
  a060=arg[14]? arg[14][67] : 0;
  a059=(a059-a060);
  a060=arg[14]? arg[14][68] : 0;
  a061=arg[11]? arg[11][43] : 0;
  a062=(a061/a008);
  a060=(a060+a062);
  a063=(a005*a060);
  a059=(a059+a063);
  a063=arg[14]? arg[14][66] : 0;
  a064=arg[11]? arg[11][42] : 0;
  a063=(a063+a064);
  a064=(a063/a002);
  a059=(a059-a064);
  a065=(a026*a059);
  a058=(a058+a065);
  a065=(a024*a058);
  a066=(a065*a033);
  a067=(a058*a036);
  a068=(a051*a027);
  a069=arg[32]? arg[32][74] : 0;
  a070=arg[32]? arg[32][77] : 0;
  a069=(a069-a070);
  a070=(a053*a003);
  a071=arg[32]? arg[32][78] : 0;
  a072=arg[29]? arg[29][50] : 0;
  a073=(a072/a008);
  a055=(a055/a008);
  a055=(a055*a022);
  a073=(a073-a055);
  a071=(a071+a073);
  a073=(a005*a071);
  a070=(a070+a073);
  a069=(a069+a070);
  a070=arg[32]? arg[32][76] : 0;
  a073=arg[29]? arg[29][49] : 0;
  a070=(a070+a073);
  a073=(a070/a002);
  a057=(a057/a002);
  a057=(a057*a017);
  a073=(a073-a057);
  a069=(a069-a073);
  a073=(a029*a069);
  a068=(a068+a073);
  a073=(a059*a030);
  a057=arg[32]? arg[32][64] : 0;
  a055=arg[32]? arg[32][67] : 0;
  a057=(a057-a055);
  a055=(a060*a003);
  a074=arg[32]? arg[32][68] : 0;
  a075=arg[29]? arg[29][43] : 0;
  a076=(a075/a008);
  a062=(a062/a008);
  a062=(a062*a022);
  a076=(a076-a062);
  a074=(a074+a076);
  a076=(a005*a074);
  a055=(a055+a076);
  a057=(a057+a055);
  a055=arg[32]? arg[32][66] : 0;
  a076=arg[29]? arg[29][42] : 0;
  a055=(a055+a076);
  a076=(a055/a002);
  a064=(a064/a002);
  a064=(a064*a017);
  a076=(a076-a064);
  a057=(a057-a076);
  a076=(a026*a057);
  a073=(a073+a076);
  a068=(a068+a073);
  a073=(a024*a068);
  a067=(a067+a073);
  a073=(a025*a067);
  a066=(a066+a073);
  a043=(a043+a066);
  a066=arg[14]? arg[14][38] : 0;
  a073=arg[11]? arg[11][22] : 0;
  a076=(a073/a008);
  a066=(a066+a076);
  a064=arg[14]? arg[14][6] : 0;
  a062=arg[11]? arg[11][0] : 0;
  a064=(a064+a062);
  a062=casadi_sq(a002);
  a077=(a064/a062);
  a078=(a066+a077);
  a079=arg[11]? arg[11][8] : 0;
  a080=casadi_sq(a008);
  a081=(a079/a080);
  a082=(a005*a081);
  a082=(a078-a082);
  a083=(a082*a010);
  a084=arg[32]? arg[32][38] : 0;
  a085=arg[29]? arg[29][22] : 0;
  a086=(a085/a008);
  a076=(a076/a008);
  a076=(a076*a022);
  a086=(a086-a076);
  a084=(a084+a086);
  a086=arg[32]? arg[32][6] : 0;
  a076=arg[29]? arg[29][0] : 0;
  a086=(a086+a076);
  a076=(a086/a062);
  a087=(a077/a062);
  a088=(2.*a002);
  a088=(a088*a017);
  a087=(a087*a088);
  a076=(a076-a087);
  a087=(a084+a076);
  a089=(a081*a003);
  a090=arg[29]? arg[29][8] : 0;
  a091=(a090/a080);
  a092=(a081/a080);
  a093=(2.*a008);
  a093=(a093*a022);
  a092=(a092*a093);
  a091=(a091-a092);
  a092=(a005*a091);
  a089=(a089+a092);
  a089=(a087-a089);
  a092=(a012*a089);
  a083=(a083+a092);
  a043=(a043+a083);
  a083=arg[14]? arg[14][54] : 0;
  a092=arg[14]? arg[14][57] : 0;
  a083=(a083-a092);
  a092=arg[14]? arg[14][58] : 0;
  a094=arg[11]? arg[11][36] : 0;
  a095=(a094/a008);
  a092=(a092+a095);
  a096=(a005*a092);
  a083=(a083+a096);
  a096=arg[14]? arg[14][56] : 0;
  a097=arg[11]? arg[11][35] : 0;
  a096=(a096+a097);
  a097=(a096/a002);
  a083=(a083-a097);
  a098=(a024*a083);
  a099=(a025*a023);
  a100=(a099*a021);
  a098=(a098+a100);
  a100=(a005*a081);
  a078=(a078-a100);
  a100=(a024*a078);
  a101=(a025*a100);
  a098=(a098+a101);
  a101=(a026*a027);
  a102=(a029*a030);
  a101=(a101+a102);
  a102=(a098*a101);
  a103=(a029*a026);
  a104=(a083*a036);
  a105=arg[32]? arg[32][54] : 0;
  a106=arg[32]? arg[32][57] : 0;
  a105=(a105-a106);
  a106=(a092*a003);
  a107=arg[32]? arg[32][58] : 0;
  a108=arg[29]? arg[29][36] : 0;
  a109=(a108/a008);
  a095=(a095/a008);
  a095=(a095*a022);
  a109=(a109-a095);
  a107=(a107+a109);
  a109=(a005*a107);
  a106=(a106+a109);
  a105=(a105+a106);
  a106=arg[32]? arg[32][56] : 0;
  a109=arg[29]? arg[29][35] : 0;
  a106=(a106+a109);
  a109=(a106/a002);
  a097=(a097/a002);
  a097=(a097*a017);
  a109=(a109-a097);
  a105=(a105-a109);
  a109=(a024*a105);
  a104=(a104+a109);
  a109=(a023*a033);
  a097=(a025*a037);
  a109=(a109+a097);
  a097=(a021*a109);
  a095=(a099*a040);
  a097=(a097+a095);
  a104=(a104+a097);
  a097=(a100*a033);
  a095=(a078*a036);
  a110=(a081*a003);
  a111=(a005*a091);
  a110=(a110+a111);
  a110=(a087-a110);
  a111=(a024*a110);
  a095=(a095+a111);
  a111=(a025*a095);
  a097=(a097+a111);
  a104=(a104+a097);
  a097=(a103*a104);
  a102=(a102+a097);
  a043=(a043+a102);
  a102=(a043/a023);
  a097=arg[14]? arg[14][95] : 0;
  a111=arg[14]? arg[14][97] : 0;
  a097=(a097-a111);
  a111=(a005*a045);
  a097=(a097+a111);
  a097=(a097-a052);
  a052=(a025*a065);
  a097=(a097+a052);
  a052=(a012*a082);
  a097=(a097+a052);
  a052=(a103*a098);
  a097=(a097+a052);
  a052=(a097/a023);
  a111=(a052/a023);
  a111=(a111*a037);
  a102=(a102-a111);
  a038=(a038+a102);
  a102=arg[32]? arg[32][42] : 0;
  a111=(a102/a018);
  a112=arg[14]? arg[14][42] : 0;
  a113=(a112/a018);
  a113=(a113/a018);
  a113=(a113*a044);
  a111=(a111-a113);
  a111=(a038-a111);
  a113=arg[32]? arg[32][83] : 0;
  a114=arg[32]? arg[32][87] : 0;
  a113=(a113-a114);
  a114=arg[14]? arg[14][88] : 0;
  a115=arg[11]? arg[11][57] : 0;
  a116=(a115/a008);
  a114=(a114+a116);
  a117=arg[20]? arg[20][2] : 0;
  a118=(a114*a117);
  a119=arg[2]? arg[2][2] : 0;
  a120=arg[32]? arg[32][88] : 0;
  a121=arg[29]? arg[29][57] : 0;
  a122=(a121/a008);
  a116=(a116/a008);
  a116=(a116*a022);
  a122=(a122-a116);
  a120=(a120+a122);
  a122=(a119*a120);
  a118=(a118+a122);
  a113=(a113-a118);
  a118=arg[32]? arg[32][86] : 0;
  a122=arg[29]? arg[29][56] : 0;
  a118=(a118+a122);
  a122=(a118/a002);
  a116=arg[14]? arg[14][86] : 0;
  a123=arg[11]? arg[11][56] : 0;
  a116=(a116+a123);
  a123=(a116/a002);
  a124=(a123/a002);
  a124=(a124*a017);
  a122=(a122-a124);
  a113=(a113-a122);
  a113=(2.*a113);
  a122=(a119*a081);
  a124=arg[14]? arg[14][28] : 0;
  a125=arg[11]? arg[11][15] : 0;
  a126=(a125/a008);
  a124=(a124+a126);
  a122=(a122-a124);
  a122=(a122+a077);
  a122=(2.*a122);
  a077=arg[20]? arg[20][8] : 0;
  a127=(a122*a077);
  a128=arg[2]? arg[2][8] : 0;
  a129=(a081*a117);
  a130=(a119*a091);
  a129=(a129+a130);
  a130=arg[32]? arg[32][28] : 0;
  a131=arg[29]? arg[29][15] : 0;
  a132=(a131/a008);
  a126=(a126/a008);
  a126=(a126*a022);
  a132=(a132-a126);
  a130=(a130+a132);
  a129=(a129-a130);
  a129=(a129+a076);
  a129=(2.*a129);
  a076=(a128*a129);
  a127=(a127+a076);
  a113=(a113+a127);
  a127=(a113/a023);
  a076=arg[14]? arg[14][83] : 0;
  a132=arg[14]? arg[14][87] : 0;
  a076=(a076-a132);
  a132=(a119*a114);
  a076=(a076-a132);
  a076=(a076-a123);
  a076=(2.*a076);
  a123=(a128*a122);
  a076=(a076+a123);
  a123=(a076/a023);
  a132=(a123/a023);
  a132=(a132*a037);
  a127=(a127-a132);
  a132=arg[32]? arg[32][40] : 0;
  a126=arg[14]? arg[14][43] : 0;
  a133=(a119*a006);
  a126=(a126-a133);
  a126=(a126-a000);
  a126=(2.*a126);
  a000=(a126*a077);
  a133=arg[32]? arg[32][43] : 0;
  a134=(a006*a117);
  a135=(a119*a019);
  a134=(a134+a135);
  a133=(a133-a134);
  a133=(a133-a013);
  a133=(2.*a133);
  a013=(a128*a133);
  a000=(a000+a013);
  a132=(a132+a000);
  a000=(a132/a018);
  a013=arg[14]? arg[14][40] : 0;
  a134=(a128*a126);
  a013=(a013+a134);
  a134=(a013/a018);
  a135=(a134/a018);
  a135=(a135*a044);
  a000=(a000-a135);
  a127=(a127-a000);
  a111=(a111+a127);
  a000=arg[9]? arg[9][47] : 0;
  a135=arg[0]? arg[0][6] : 0;
  a136=cos(a135);
  a137=arg[18]? arg[18][6] : 0;
  a136=(a136*a137);
  a136=(a000*a136);
  a138=sin(a135);
  a139=arg[27]? arg[27][47] : 0;
  a138=(a138*a139);
  a136=(a136+a138);
  a111=(a111-a136);
  a136=cos(a135);
  a138=arg[27]? arg[27][46] : 0;
  a136=(a136*a138);
  a140=arg[9]? arg[9][46] : 0;
  a141=sin(a135);
  a141=(a141*a137);
  a141=(a140*a141);
  a136=(a136-a141);
  a111=(a111-a136);
  if (res[0]!=0) res[0][0]=a111;
  a111=arg[14]? arg[14][37] : 0;
  a136=arg[14]? arg[14][36] : 0;
  a141=arg[11]? arg[11][21] : 0;
  a136=(a136+a141);
  a141=(a136/a002);
  a111=(a111+a141);
  a142=arg[14]? arg[14][35] : 0;
  a143=(a005*a066);
  a142=(a142+a143);
  a142=(a111-a142);
  a143=(a142*a010);
  a144=arg[32]? arg[32][37] : 0;
  a145=arg[32]? arg[32][36] : 0;
  a146=arg[29]? arg[29][21] : 0;
  a145=(a145+a146);
  a146=(a145/a002);
  a141=(a141/a002);
  a141=(a141*a017);
  a146=(a146-a141);
  a144=(a144+a146);
  a146=arg[32]? arg[32][35] : 0;
  a141=(a066*a003);
  a147=(a005*a084);
  a141=(a141+a147);
  a146=(a146+a141);
  a146=(a144-a146);
  a141=(a012*a146);
  a143=(a143+a141);
  a141=arg[32]? arg[32][31] : 0;
  a143=(a143-a141);
  a141=arg[14]? arg[14][34] : 0;
  a147=(a005*a066);
  a141=(a141+a147);
  a111=(a111-a141);
  a141=(a111*a034);
  a147=arg[32]? arg[32][34] : 0;
  a148=(a066*a003);
  a149=(a005*a084);
  a148=(a148+a149);
  a147=(a147+a148);
  a144=(a144-a147);
  a147=(a039*a144);
  a141=(a141+a147);
  a143=(a143+a141);
  a141=(a143/a023);
  a147=(a012*a142);
  a148=arg[14]? arg[14][31] : 0;
  a147=(a147-a148);
  a148=(a039*a111);
  a147=(a147+a148);
  a148=(a147/a023);
  a148=(a148/a023);
  a148=(a148*a037);
  a141=(a141-a148);
  a141=(a141-a015);
  a015=arg[32]? arg[32][20] : 0;
  a148=arg[14]? arg[14][23] : 0;
  a149=arg[14]? arg[14][27] : 0;
  a148=(a148-a149);
  a149=(a119*a124);
  a148=(a148-a149);
  a149=arg[14]? arg[14][26] : 0;
  a150=arg[11]? arg[11][14] : 0;
  a149=(a149+a150);
  a150=(a149/a002);
  a148=(a148-a150);
  a148=(2.*a148);
  a151=(a148*a077);
  a152=arg[32]? arg[32][23] : 0;
  a153=arg[32]? arg[32][27] : 0;
  a152=(a152-a153);
  a153=(a124*a117);
  a154=(a119*a130);
  a153=(a153+a154);
  a152=(a152-a153);
  a153=arg[32]? arg[32][26] : 0;
  a154=arg[29]? arg[29][14] : 0;
  a153=(a153+a154);
  a154=(a153/a002);
  a150=(a150/a002);
  a150=(a150*a017);
  a154=(a154-a150);
  a152=(a152-a154);
  a152=(2.*a152);
  a154=(a128*a152);
  a151=(a151+a154);
  a015=(a015+a151);
  a151=(a015/a023);
  a154=arg[14]? arg[14][20] : 0;
  a150=(a128*a148);
  a154=(a154+a150);
  a150=(a154/a023);
  a150=(a150/a023);
  a150=(a150*a037);
  a151=(a151-a150);
  a141=(a141+a151);
  a042=(a042+a052);
  a052=(a042*a003);
  a151=(a005*a038);
  a052=(a052+a151);
  a141=(a141-a052);
  a123=(a123-a134);
  a134=(a123*a117);
  a052=(a119*a127);
  a134=(a134+a052);
  a141=(a141+a134);
  if (res[0]!=0) res[0][1]=a141;
  a141=0.;
  if (res[0]!=0) res[0][2]=a141;
  if (res[0]!=0) res[0][3]=a141;
  if (res[0]!=0) res[0][4]=a141;
  if (res[0]!=0) res[0][5]=a141;
  a141=cos(a135);
  a134=arg[29]? arg[29][33] : 0;
  a141=(a141*a134);
  a134=arg[11]? arg[11][33] : 0;
  a052=sin(a135);
  a052=(a052*a137);
  a134=(a134*a052);
  a141=(a141-a134);
  a134=arg[11]? arg[11][32] : 0;
  a052=cos(a135);
  a052=(a052*a137);
  a134=(a134*a052);
  a052=sin(a135);
  a151=arg[29]? arg[29][32] : 0;
  a052=(a052*a151);
  a134=(a134+a052);
  a141=(a141-a134);
  a134=cos(a135);
  a052=arg[18]? arg[18][0] : 0;
  a151=(a000*a052);
  a150=arg[0]? arg[0][0] : 0;
  a155=(a150*a139);
  a151=(a151+a155);
  a134=(a134*a151);
  a151=(a150*a000);
  a155=sin(a135);
  a155=(a155*a137);
  a151=(a151*a155);
  a134=(a134-a151);
  a141=(a141-a134);
  a134=(a023*a000);
  a151=cos(a135);
  a151=(a151*a137);
  a134=(a134*a151);
  a151=sin(a135);
  a155=(a000*a037);
  a156=(a023*a139);
  a155=(a155+a156);
  a151=(a151*a155);
  a134=(a134+a151);
  a141=(a141-a134);
  a134=(a150*a140);
  a151=cos(a135);
  a151=(a151*a137);
  a134=(a134*a151);
  a151=sin(a135);
  a155=(a140*a052);
  a156=(a150*a138);
  a155=(a155+a156);
  a151=(a151*a155);
  a134=(a134+a151);
  a141=(a141+a134);
  a134=cos(a135);
  a151=(a140*a037);
  a155=(a023*a138);
  a151=(a151+a155);
  a134=(a134*a151);
  a151=(a023*a140);
  a155=sin(a135);
  a155=(a155*a137);
  a151=(a151*a155);
  a134=(a134-a151);
  a141=(a141-a134);
  a134=arg[9]? arg[9][5] : 0;
  a151=cos(a135);
  a151=(a151*a137);
  a134=(a134*a151);
  a151=sin(a135);
  a155=arg[27]? arg[27][5] : 0;
  a151=(a151*a155);
  a134=(a134+a151);
  a141=(a141-a134);
  a134=cos(a135);
  a151=arg[27]? arg[27][4] : 0;
  a134=(a134*a151);
  a151=arg[9]? arg[9][4] : 0;
  a155=sin(a135);
  a155=(a155*a137);
  a151=(a151*a155);
  a134=(a134-a151);
  a141=(a141-a134);
  if (res[0]!=0) res[0][6]=a141;
  a141=(a081*a003);
  a134=(a005*a091);
  a141=(a141+a134);
  a141=(a141-a087);
  if (res[1]!=0) res[1][0]=a141;
  a141=arg[32]? arg[32][109] : 0;
  a087=arg[0]? arg[0][1] : 0;
  a134=(a087*a003);
  a151=arg[18]? arg[18][1] : 0;
  a155=(a005*a151);
  a134=(a134+a155);
  a134=(a052-a134);
  a155=(a134/a023);
  a156=(a005*a087);
  a156=(a150-a156);
  a157=(a156/a023);
  a158=(a157/a023);
  a158=(a158*a037);
  a155=(a155-a158);
  a158=(a155/a002);
  a159=(a157/a002);
  a160=(a159/a002);
  a160=(a160*a017);
  a158=(a158-a160);
  a158=(a158/a002);
  a159=(a159/a002);
  a160=(a159/a002);
  a160=(a160*a017);
  a158=(a158-a160);
  a047=(a047*a158);
  a159=(a159*a048);
  a047=(a047+a159);
  a141=(a141+a047);
  a047=(a087*a117);
  a159=(a119*a151);
  a047=(a047+a159);
  a047=(a047+a052);
  a159=(a047/a023);
  a048=(a119*a087);
  a048=(a048+a150);
  a158=(a048/a023);
  a160=(a158/a023);
  a160=(a160*a037);
  a159=(a159-a160);
  a160=(2.*a159);
  a161=(a160/a002);
  a162=(2.*a158);
  a163=(a162/a002);
  a164=(a163/a002);
  a164=(a164*a017);
  a161=(a161-a164);
  a161=(a161/a002);
  a163=(a163/a002);
  a164=(a163/a002);
  a164=(a164*a017);
  a161=(a161-a164);
  a116=(a116*a161);
  a163=(a163*a118);
  a116=(a116+a163);
  a141=(a141+a116);
  a116=(a157*a025);
  a163=(a116*a024);
  a118=(a163*a027);
  a161=(a025*a155);
  a164=(a157*a033);
  a161=(a161+a164);
  a164=(a024*a161);
  a165=(a116*a036);
  a164=(a164+a165);
  a165=(a029*a164);
  a118=(a118+a165);
  a165=(a118/a002);
  a166=(a029*a163);
  a167=(a166/a002);
  a168=(a167/a002);
  a168=(a168*a017);
  a165=(a165-a168);
  a165=(a165/a002);
  a167=(a167/a002);
  a168=(a167/a002);
  a168=(a168*a017);
  a165=(a165-a168);
  a056=(a056*a165);
  a167=(a167*a070);
  a056=(a056+a167);
  a141=(a141+a056);
  a056=(a163*a030);
  a167=(a026*a164);
  a056=(a056+a167);
  a167=(a056/a002);
  a070=(a026*a163);
  a165=(a070/a002);
  a168=(a165/a002);
  a168=(a168*a017);
  a167=(a167-a168);
  a167=(a167/a002);
  a165=(a165/a002);
  a168=(a165/a002);
  a168=(a168*a017);
  a167=(a167-a168);
  a063=(a063*a167);
  a165=(a165*a055);
  a063=(a063+a165);
  a141=(a141+a063);
  a101=(a157*a101);
  a063=(a103*a155);
  a101=(a101+a063);
  a063=(a024*a101);
  a103=(a103*a157);
  a165=(a103*a036);
  a063=(a063+a165);
  a165=(a063/a002);
  a055=(a103*a024);
  a167=(a055/a002);
  a168=(a167/a002);
  a168=(a168*a017);
  a165=(a165-a168);
  a165=(a165/a002);
  a167=(a167/a002);
  a168=(a167/a002);
  a168=(a168*a017);
  a165=(a165-a168);
  a096=(a096*a165);
  a167=(a167*a106);
  a096=(a096+a167);
  a141=(a141+a096);
  a156=(a156/a018);
  a096=(a156*a010);
  a134=(a134/a018);
  a167=(a156/a018);
  a167=(a167*a044);
  a134=(a134-a167);
  a167=(a012*a134);
  a096=(a096+a167);
  a048=(a048/a018);
  a167=(a048*a077);
  a047=(a047/a018);
  a106=(a048/a018);
  a106=(a106*a044);
  a047=(a047-a106);
  a106=(a128*a047);
  a167=(a167+a106);
  a167=(-a167);
  a167=(2.*a167);
  a109=(a103*a109);
  a106=(a099*a101);
  a109=(a109+a106);
  a106=(a039*a134);
  a165=(a156*a034);
  a106=(a106+a165);
  a109=(a109-a106);
  a106=(a167+a109);
  a106=(a096-a106);
  a106=(a106/a002);
  a165=(a012*a156);
  a168=(a128*a048);
  a168=(-a168);
  a168=(2.*a168);
  a099=(a099*a103);
  a169=(a156*a039);
  a099=(a099-a169);
  a169=(a168+a099);
  a169=(a165-a169);
  a169=(a169/a002);
  a170=(a169/a002);
  a170=(a170*a017);
  a106=(a106-a170);
  a106=(a106/a002);
  a169=(a169/a002);
  a170=(a169/a002);
  a170=(a170*a017);
  a106=(a106-a170);
  a001=(a001*a106);
  a169=(a169*a014);
  a001=(a001+a169);
  a141=(a141-a001);
  a001=(a151/a023);
  a169=(a087/a023);
  a014=(a169/a023);
  a014=(a014*a037);
  a001=(a001-a014);
  a014=(a039*a001);
  a106=(a169*a034);
  a014=(a014+a106);
  a106=(a169*a010);
  a170=(a012*a001);
  a106=(a106+a170);
  a170=(a014+a106);
  a170=(a170/a002);
  a171=(a169*a039);
  a172=(a012*a169);
  a173=(a171+a172);
  a173=(a173/a002);
  a174=(a173/a002);
  a174=(a174*a017);
  a170=(a170-a174);
  a170=(a170/a002);
  a173=(a173/a002);
  a174=(a173/a002);
  a174=(a174*a017);
  a170=(a170-a174);
  a136=(a136*a170);
  a173=(a173*a145);
  a136=(a136+a173);
  a141=(a141-a136);
  a136=(a087/a023);
  a173=(a136*a077);
  a145=(a151/a023);
  a170=(a136/a023);
  a170=(a170*a037);
  a145=(a145-a170);
  a170=(a128*a145);
  a173=(a173+a170);
  a173=(2.*a173);
  a170=(a173/a002);
  a174=(a128*a136);
  a174=(2.*a174);
  a175=(a174/a002);
  a176=(a175/a002);
  a176=(a176*a017);
  a170=(a170-a176);
  a170=(a170/a002);
  a175=(a175/a002);
  a176=(a175/a002);
  a176=(a176*a017);
  a170=(a170-a176);
  a149=(a149*a170);
  a175=(a175*a153);
  a149=(a149+a175);
  a141=(a141+a149);
  a149=(a128*a158);
  a149=(2.*a149);
  a175=(a025*a103);
  a153=(a175*a024);
  a170=arg[1]? arg[1][0] : 0;
  a176=(a153-a170);
  a177=(a012*a157);
  a176=(a176+a177);
  a178=(a149+a176);
  a178=(a178/a062);
  a179=(a178/a062);
  a180=(a179*a064);
  a181=(2.*a017);
  a180=(a180*a181);
  a181=(2.*a002);
  a182=(a158*a077);
  a183=(a128*a159);
  a182=(a182+a183);
  a182=(2.*a182);
  a183=(a103*a033);
  a184=(a025*a101);
  a183=(a183+a184);
  a184=(a024*a183);
  a185=(a175*a036);
  a184=(a184+a185);
  a185=arg[19]? arg[19][0] : 0;
  a186=(a184-a185);
  a187=(a157*a010);
  a188=(a012*a155);
  a187=(a187+a188);
  a186=(a186+a187);
  a188=(a182+a186);
  a188=(a188/a062);
  a178=(a178/a062);
  a178=(a178*a088);
  a188=(a188-a178);
  a188=(a188/a062);
  a062=(a179/a062);
  a062=(a062*a088);
  a188=(a188-a062);
  a064=(a064*a188);
  a179=(a179*a086);
  a064=(a064+a179);
  a181=(a181*a064);
  a180=(a180+a181);
  a141=(a141-a180);
  a180=(1./a002);
  a181=(a180/a002);
  a064=arg[31]? arg[31][6] : 0;
  a179=arg[28]? arg[28][0] : 0;
  a064=(a064+a179);
  a064=(a181*a064);
  a179=arg[13]? arg[13][6] : 0;
  a086=arg[10]? arg[10][0] : 0;
  a179=(a179+a086);
  a180=(a180/a002);
  a180=(a180*a017);
  a180=(a180/a002);
  a181=(a181/a002);
  a181=(a181*a017);
  a180=(a180+a181);
  a179=(a179*a180);
  a064=(a064-a179);
  a141=(a141-a064);
  a064=arg[12]? arg[12][16] : 0;
  a179=arg[9]? arg[9][7] : 0;
  a064=(a064+a179);
  a179=(a003/a023);
  a180=(a005/a023);
  a181=(a180/a023);
  a181=(a181*a037);
  a179=(a179-a181);
  a181=(a039*a179);
  a086=(a180*a034);
  a181=(a181+a086);
  a086=(a119/a023);
  a188=(a086*a077);
  a062=(a117/a023);
  a088=(a086/a023);
  a088=(a088*a037);
  a062=(a062-a088);
  a088=(a128*a062);
  a188=(a188+a088);
  a188=(2.*a188);
  a088=(a181-a188);
  a178=(a180*a010);
  a189=(a012*a179);
  a178=(a178+a189);
  a088=(a088+a178);
  a088=(a088/a002);
  a189=(a180*a039);
  a190=(a128*a086);
  a190=(2.*a190);
  a191=(a189-a190);
  a192=(a012*a180);
  a191=(a191+a192);
  a191=(a191/a002);
  a193=(a191/a002);
  a193=(a193*a017);
  a088=(a088-a193);
  a088=(a088/a002);
  a191=(a191/a002);
  a193=(a191/a002);
  a193=(a193*a017);
  a088=(a088-a193);
  a088=(a064*a088);
  a193=arg[30]? arg[30][16] : 0;
  a194=arg[27]? arg[27][7] : 0;
  a193=(a193+a194);
  a191=(a191*a193);
  a088=(a088+a191);
  a141=(a141-a088);
  a088=arg[12]? arg[12][6] : 0;
  a191=arg[9]? arg[9][0] : 0;
  a088=(a088+a191);
  a191=(a077/a023);
  a195=(a128/a023);
  a196=(a195/a023);
  a196=(a196*a037);
  a191=(a191-a196);
  a196=(2.*a191);
  a197=(a034/a023);
  a198=(a039/a023);
  a199=(a198/a023);
  a199=(a199*a037);
  a197=(a197-a199);
  a199=(a196+a197);
  a200=(a010/a023);
  a201=(a012/a023);
  a202=(a201/a023);
  a202=(a202*a037);
  a200=(a200-a202);
  a199=(a199+a200);
  a199=(a199/a002);
  a202=(2.*a195);
  a203=(a202+a198);
  a203=(a203+a201);
  a203=(a203/a002);
  a204=(a203/a002);
  a204=(a204*a017);
  a199=(a199-a204);
  a199=(a199/a002);
  a203=(a203/a002);
  a204=(a203/a002);
  a204=(a204*a017);
  a199=(a199-a204);
  a199=(a088*a199);
  a204=arg[30]? arg[30][6] : 0;
  a205=arg[27]? arg[27][0] : 0;
  a204=(a204+a205);
  a203=(a203*a204);
  a199=(a199+a203);
  a141=(a141+a199);
  if (res[2]!=0) res[2][0]=a141;
  a141=(a162*a117);
  a199=(a119*a160);
  a141=(a141+a199);
  a141=(a141/a008);
  a199=(a119*a162);
  a199=(a199/a008);
  a203=(a199/a008);
  a203=(a203*a022);
  a141=(a141-a203);
  a141=(a141/a008);
  a199=(a199/a008);
  a203=(a199/a008);
  a203=(a203*a022);
  a141=(a141-a203);
  a115=(a115*a141);
  a199=(a199*a121);
  a115=(a115+a199);
  a199=(a157*a003);
  a121=(a005*a155);
  a199=(a199+a121);
  a199=(a199/a008);
  a121=(a005*a157);
  a121=(a121/a008);
  a141=(a121/a008);
  a141=(a141*a022);
  a199=(a199-a141);
  a199=(a199/a008);
  a121=(a121/a008);
  a141=(a121/a008);
  a141=(a141*a022);
  a199=(a199-a141);
  a046=(a046*a199);
  a121=(a121*a050);
  a046=(a046+a121);
  a115=(a115-a046);
  a046=(a166*a003);
  a121=(a005*a118);
  a046=(a046+a121);
  a046=(a046/a008);
  a121=(a005*a166);
  a121=(a121/a008);
  a050=(a121/a008);
  a050=(a050*a022);
  a046=(a046-a050);
  a046=(a046/a008);
  a121=(a121/a008);
  a050=(a121/a008);
  a050=(a050*a022);
  a046=(a046-a050);
  a054=(a054*a046);
  a121=(a121*a072);
  a054=(a054+a121);
  a115=(a115-a054);
  a054=(a070*a003);
  a121=(a005*a056);
  a054=(a054+a121);
  a054=(a054/a008);
  a121=(a005*a070);
  a121=(a121/a008);
  a072=(a121/a008);
  a072=(a072*a022);
  a054=(a054-a072);
  a054=(a054/a008);
  a121=(a121/a008);
  a072=(a121/a008);
  a072=(a072*a022);
  a054=(a054-a072);
  a061=(a061*a054);
  a121=(a121*a075);
  a061=(a061+a121);
  a115=(a115-a061);
  a061=(a055*a003);
  a121=(a005*a063);
  a061=(a061+a121);
  a061=(a061/a008);
  a121=(a005*a055);
  a121=(a121/a008);
  a075=(a121/a008);
  a075=(a075*a022);
  a061=(a061-a075);
  a061=(a061/a008);
  a121=(a121/a008);
  a075=(a121/a008);
  a075=(a075*a022);
  a061=(a061-a075);
  a094=(a094*a061);
  a121=(a121*a108);
  a094=(a094+a121);
  a115=(a115-a094);
  a094=(a099*a003);
  a121=(a005*a109);
  a094=(a094+a121);
  a121=(a168*a117);
  a108=(a119*a167);
  a121=(a121+a108);
  a094=(a094-a121);
  a121=(a165*a003);
  a108=(a005*a096);
  a121=(a121+a108);
  a094=(a094-a121);
  a094=(a094/a008);
  a121=(a005*a099);
  a108=(a119*a168);
  a121=(a121-a108);
  a108=(a005*a165);
  a121=(a121-a108);
  a121=(a121/a008);
  a108=(a121/a008);
  a108=(a108*a022);
  a094=(a094-a108);
  a094=(a094/a008);
  a121=(a121/a008);
  a108=(a121/a008);
  a108=(a108*a022);
  a094=(a094-a108);
  a007=(a007*a094);
  a121=(a121*a020);
  a007=(a007+a121);
  a115=(a115-a007);
  a007=(a171*a003);
  a121=(a005*a014);
  a007=(a007+a121);
  a121=(a172*a003);
  a020=(a005*a106);
  a121=(a121+a020);
  a007=(a007+a121);
  a186=(a186-a007);
  a186=(a186/a008);
  a007=(a005*a171);
  a121=(a005*a172);
  a007=(a007+a121);
  a176=(a176-a007);
  a176=(a176/a008);
  a007=(a176/a008);
  a007=(a007*a022);
  a186=(a186-a007);
  a186=(a186/a008);
  a176=(a176/a008);
  a007=(a176/a008);
  a007=(a007*a022);
  a186=(a186-a007);
  a073=(a073*a186);
  a176=(a176*a085);
  a073=(a073+a176);
  a115=(a115-a073);
  a073=(a174*a117);
  a176=(a119*a173);
  a073=(a073+a176);
  a073=(a182+a073);
  a073=(a073/a008);
  a176=(a119*a174);
  a176=(a149+a176);
  a176=(a176/a008);
  a085=(a176/a008);
  a085=(a085*a022);
  a073=(a073-a085);
  a073=(a073/a008);
  a176=(a176/a008);
  a085=(a176/a008);
  a085=(a085*a022);
  a073=(a073-a085);
  a125=(a125*a073);
  a176=(a176*a131);
  a125=(a125+a176);
  a115=(a115+a125);
  a125=(a153*a005);
  a176=(a170*a005);
  a131=(a149*a119);
  a176=(a176+a131);
  a125=(a125-a176);
  a176=(a177*a005);
  a125=(a125+a176);
  a125=(a125/a080);
  a176=(a125/a080);
  a131=(a176*a079);
  a073=(2.*a022);
  a131=(a131*a073);
  a073=(2.*a008);
  a085=(a005*a184);
  a186=(a153*a003);
  a085=(a085+a186);
  a186=(a005*a185);
  a007=(a170*a003);
  a186=(a186+a007);
  a007=(a119*a182);
  a121=(a149*a117);
  a007=(a007+a121);
  a186=(a186+a007);
  a085=(a085-a186);
  a186=(a005*a187);
  a007=(a177*a003);
  a186=(a186+a007);
  a085=(a085+a186);
  a085=(a085/a080);
  a125=(a125/a080);
  a125=(a125*a093);
  a085=(a085-a125);
  a085=(a085/a080);
  a080=(a176/a080);
  a080=(a080*a093);
  a085=(a085-a080);
  a079=(a079*a085);
  a176=(a176*a090);
  a079=(a079+a176);
  a073=(a073*a079);
  a131=(a131+a073);
  a115=(a115+a131);
  a131=arg[10]? arg[10][1] : 0;
  a073=(a003/a008);
  a079=(a005/a008);
  a176=(a079/a008);
  a176=(a176*a022);
  a073=(a073-a176);
  a073=(a073/a008);
  a079=(a079/a008);
  a176=(a079/a008);
  a176=(a176*a022);
  a073=(a073-a176);
  a073=(a131*a073);
  a176=arg[28]? arg[28][1] : 0;
  a079=(a079*a176);
  a073=(a073+a079);
  a115=(a115+a073);
  a073=arg[9]? arg[9][8] : 0;
  a079=(a190*a117);
  a090=(a119*a188);
  a079=(a079+a090);
  a090=(a189*a003);
  a085=(a005*a181);
  a090=(a090+a085);
  a079=(a079+a090);
  a090=(a192*a003);
  a085=(a005*a178);
  a090=(a090+a085);
  a079=(a079+a090);
  a079=(a079/a008);
  a090=(a119*a190);
  a085=(a005*a189);
  a090=(a090+a085);
  a085=(a005*a192);
  a090=(a090+a085);
  a090=(a090/a008);
  a085=(a090/a008);
  a085=(a085*a022);
  a079=(a079-a085);
  a079=(a079/a008);
  a090=(a090/a008);
  a085=(a090/a008);
  a085=(a085*a022);
  a079=(a079-a085);
  a079=(a073*a079);
  a085=arg[27]? arg[27][8] : 0;
  a090=(a090*a085);
  a079=(a079+a090);
  a115=(a115+a079);
  a079=arg[9]? arg[9][1] : 0;
  a090=(a198*a003);
  a080=(a005*a197);
  a090=(a090+a080);
  a080=(a202*a117);
  a093=(a119*a196);
  a080=(a080+a093);
  a090=(a090-a080);
  a080=(a201*a003);
  a093=(a005*a200);
  a080=(a080+a093);
  a090=(a090+a080);
  a090=(a090/a008);
  a080=(a005*a198);
  a093=(a119*a202);
  a080=(a080-a093);
  a093=(a005*a201);
  a080=(a080+a093);
  a080=(a080/a008);
  a093=(a080/a008);
  a093=(a093*a022);
  a090=(a090-a093);
  a090=(a090/a008);
  a080=(a080/a008);
  a093=(a080/a008);
  a093=(a093*a022);
  a090=(a090-a093);
  a090=(a079*a090);
  a093=arg[27]? arg[27][1] : 0;
  a080=(a080*a093);
  a090=(a090+a080);
  a115=(a115-a090);
  if (res[2]!=0) res[2][1]=a115;
  a182=(a081*a182);
  a149=(a149*a091);
  a182=(a182+a149);
  a114=(a114*a160);
  a162=(a162*a120);
  a114=(a114+a162);
  a167=(a006*a167);
  a168=(a168*a019);
  a167=(a167+a168);
  a114=(a114+a167);
  a124=(a124*a173);
  a174=(a174*a130);
  a124=(a124+a174);
  a114=(a114+a124);
  a182=(a182-a114);
  a123=(a123*a151);
  a127=(a087*a127);
  a123=(a123+a127);
  a182=(a182+a123);
  a123=arg[12]? arg[12][18] : 0;
  a073=(a073/a008);
  a123=(a123+a073);
  a188=(a123*a188);
  a127=arg[30]? arg[30][18] : 0;
  a085=(a085/a008);
  a073=(a073/a008);
  a073=(a073*a022);
  a085=(a085-a073);
  a127=(a127+a085);
  a190=(a190*a127);
  a188=(a188+a190);
  a182=(a182-a188);
  a188=arg[30]? arg[30][10] : 0;
  a190=arg[12]? arg[12][13] : 0;
  a085=(a119*a123);
  a190=(a190-a085);
  a085=arg[12]? arg[12][17] : 0;
  a064=(a064/a002);
  a085=(a085+a064);
  a190=(a190-a085);
  a190=(2.*a190);
  a077=(a190*a077);
  a073=arg[30]? arg[30][13] : 0;
  a114=(a123*a117);
  a124=(a119*a127);
  a114=(a114+a124);
  a073=(a073-a114);
  a114=arg[30]? arg[30][17] : 0;
  a193=(a193/a002);
  a064=(a064/a002);
  a064=(a064*a017);
  a193=(a193-a064);
  a114=(a114+a193);
  a073=(a073-a114);
  a073=(2.*a073);
  a193=(a128*a073);
  a077=(a077+a193);
  a188=(a188+a077);
  a077=(a188/a023);
  a193=arg[12]? arg[12][10] : 0;
  a128=(a128*a190);
  a193=(a193+a128);
  a128=(a193/a023);
  a128=(a128/a023);
  a128=(a128*a037);
  a077=(a077-a128);
  a182=(a182+a077);
  a077=arg[12]? arg[12][8] : 0;
  a079=(a079/a008);
  a077=(a077+a079);
  a196=(a077*a196);
  a128=arg[30]? arg[30][8] : 0;
  a093=(a093/a008);
  a079=(a079/a008);
  a079=(a079*a022);
  a093=(a093-a079);
  a128=(a128+a093);
  a202=(a202*a128);
  a196=(a196+a202);
  a182=(a182-a196);
  if (res[2]!=0) res[2][2]=a182;
  a045=(a045*a155);
  a049=(a157*a049);
  a045=(a045+a049);
  a049=arg[31]? arg[31][8] : 0;
  a045=(a045-a049);
  a053=(a053*a118);
  a166=(a166*a071);
  a053=(a053+a166);
  a045=(a045+a053);
  a060=(a060*a056);
  a070=(a070*a074);
  a060=(a060+a070);
  a045=(a045+a060);
  a092=(a092*a063);
  a055=(a055*a107);
  a092=(a092+a055);
  a045=(a045+a092);
  a096=(a006*a096);
  a165=(a165*a019);
  a096=(a096+a165);
  a045=(a045-a096);
  a006=(a006*a109);
  a099=(a099*a019);
  a006=(a006+a099);
  a045=(a045+a006);
  a106=(a066*a106);
  a172=(a172*a084);
  a106=(a106+a172);
  a045=(a045-a106);
  a066=(a066*a014);
  a171=(a171*a084);
  a066=(a066+a171);
  a045=(a045-a066);
  a187=(a081*a187);
  a177=(a177*a091);
  a187=(a187+a177);
  a045=(a045-a187);
  a185=(a081*a185);
  a170=(a170*a091);
  a185=(a185+a170);
  a045=(a045+a185);
  a081=(a081*a184);
  a153=(a153*a091);
  a081=(a081+a153);
  a045=(a045-a081);
  a042=(a042*a151);
  a087=(a087*a038);
  a042=(a042+a087);
  a045=(a045-a042);
  a176=(a176/a008);
  a131=(a131/a008);
  a131=(a131/a008);
  a131=(a131*a022);
  a176=(a176-a131);
  a045=(a045-a176);
  a178=(a123*a178);
  a192=(a192*a127);
  a178=(a178+a192);
  a045=(a045-a178);
  a181=(a123*a181);
  a189=(a189*a127);
  a181=(a181+a189);
  a045=(a045-a181);
  a181=arg[12]? arg[12][15] : 0;
  a189=(a005*a123);
  a181=(a181+a189);
  a181=(a085-a181);
  a010=(a181*a010);
  a189=arg[30]? arg[30][15] : 0;
  a178=(a123*a003);
  a192=(a005*a127);
  a178=(a178+a192);
  a189=(a189+a178);
  a189=(a114-a189);
  a178=(a012*a189);
  a010=(a010+a178);
  a178=arg[30]? arg[30][11] : 0;
  a010=(a010-a178);
  a178=arg[12]? arg[12][14] : 0;
  a192=(a005*a123);
  a178=(a178+a192);
  a085=(a085-a178);
  a034=(a085*a034);
  a178=arg[30]? arg[30][14] : 0;
  a123=(a123*a003);
  a127=(a005*a127);
  a123=(a123+a127);
  a178=(a178+a123);
  a114=(a114-a178);
  a178=(a039*a114);
  a034=(a034+a178);
  a010=(a010+a034);
  a034=(a010/a023);
  a012=(a012*a181);
  a178=arg[12]? arg[12][11] : 0;
  a012=(a012-a178);
  a039=(a039*a085);
  a012=(a012+a039);
  a039=(a012/a023);
  a039=(a039/a023);
  a039=(a039*a037);
  a034=(a034-a039);
  a045=(a045+a034);
  a034=(a077*a200);
  a039=(a201*a128);
  a034=(a034+a039);
  a045=(a045+a034);
  a034=(a077*a197);
  a039=(a198*a128);
  a034=(a034+a039);
  a045=(a045+a034);
  if (res[2]!=0) res[2][3]=a045;
  a045=(a103*a021);
  a034=(a045*a033);
  a039=(a021*a101);
  a178=(a103*a040);
  a039=(a039+a178);
  a178=(a025*a039);
  a034=(a034+a178);
  a178=(1./a023);
  a123=(a178/a023);
  a127=arg[30]? arg[30][2] : 0;
  a127=(a123*a127);
  a192=arg[12]? arg[12][2] : 0;
  a178=(a178/a023);
  a178=(a178*a037);
  a178=(a178/a023);
  a123=(a123/a023);
  a123=(a123*a037);
  a178=(a178+a123);
  a192=(a192*a178);
  a127=(a127-a192);
  a192=(1./a023);
  a178=(a192/a023);
  a123=arg[30]? arg[30][1] : 0;
  a123=(a178*a123);
  a176=arg[12]? arg[12][1] : 0;
  a192=(a192/a023);
  a192=(a192*a037);
  a192=(a192/a023);
  a178=(a178/a023);
  a178=(a178*a037);
  a192=(a192+a178);
  a176=(a176*a192);
  a123=(a123-a176);
  a127=(a127+a123);
  a123=(1./a023);
  a176=(a123/a023);
  a192=arg[30]? arg[30][0] : 0;
  a192=(a176*a192);
  a178=arg[12]? arg[12][0] : 0;
  a123=(a123/a023);
  a123=(a123*a037);
  a123=(a123/a023);
  a176=(a176/a023);
  a176=(a176*a037);
  a123=(a123+a176);
  a178=(a178*a123);
  a192=(a192-a178);
  a127=(a127+a192);
  a034=(a034-a127);
  a150=(a150/a018);
  a127=(a150/a018);
  a192=(a127*a112);
  a178=(a048/a018);
  a123=(a178*a013);
  a192=(a192+a123);
  a123=(a156/a018);
  a176=(a123*a041);
  a192=(a192-a176);
  a176=(2.*a037);
  a192=(a192*a176);
  a176=(2.*a023);
  a052=(a052/a018);
  a150=(a150/a018);
  a150=(a150*a044);
  a052=(a052-a150);
  a052=(a052/a018);
  a150=(a127/a018);
  a150=(a150*a044);
  a052=(a052-a150);
  a112=(a112*a052);
  a127=(a127*a102);
  a112=(a112+a127);
  a127=(a047/a018);
  a102=(a178/a018);
  a102=(a102*a044);
  a127=(a127-a102);
  a013=(a013*a127);
  a178=(a178*a132);
  a013=(a013+a178);
  a112=(a112+a013);
  a013=(a134/a018);
  a018=(a123/a018);
  a018=(a018*a044);
  a013=(a013-a018);
  a041=(a041*a013);
  a123=(a123*a011);
  a041=(a041+a123);
  a112=(a112-a041);
  a176=(a176*a112);
  a192=(a192+a176);
  a034=(a034+a192);
  a192=(a001/a023);
  a176=(a169/a023);
  a112=(a176/a023);
  a112=(a112*a037);
  a192=(a192-a112);
  a147=(a147*a192);
  a176=(a176*a143);
  a147=(a147+a176);
  a034=(a034-a147);
  a147=(a145/a023);
  a176=(a136/a023);
  a143=(a176/a023);
  a143=(a143*a037);
  a147=(a147-a143);
  a154=(a154*a147);
  a176=(a176*a015);
  a154=(a154+a176);
  a034=(a034-a154);
  a154=(a155/a023);
  a176=(a157/a023);
  a015=(a176/a023);
  a015=(a015*a037);
  a154=(a154-a015);
  a097=(a097*a154);
  a176=(a176*a043);
  a097=(a097+a176);
  a034=(a034-a097);
  a097=(a159/a023);
  a176=(a158/a023);
  a043=(a176/a023);
  a043=(a043*a037);
  a097=(a097-a043);
  a076=(a076*a097);
  a176=(a176*a113);
  a076=(a076+a176);
  a034=(a034-a076);
  a076=cos(a135);
  a076=(a076*a139);
  a139=sin(a135);
  a139=(a139*a137);
  a000=(a000*a139);
  a076=(a076-a000);
  a034=(a034+a076);
  a076=cos(a135);
  a076=(a076*a137);
  a140=(a140*a076);
  a135=sin(a135);
  a135=(a135*a138);
  a140=(a140+a135);
  a034=(a034-a140);
  a034=(a034-a194);
  a194=(a062/a023);
  a140=(a086/a023);
  a135=(a140/a023);
  a135=(a135*a037);
  a194=(a194-a135);
  a193=(a193*a194);
  a140=(a140*a188);
  a193=(a193+a140);
  a034=(a034-a193);
  a193=(a179/a023);
  a140=(a180/a023);
  a188=(a140/a023);
  a188=(a188*a037);
  a193=(a193-a188);
  a012=(a012*a193);
  a140=(a140*a010);
  a012=(a012+a140);
  a034=(a034-a012);
  a012=arg[12]? arg[12][5] : 0;
  a140=(a005*a077);
  a012=(a012+a140);
  a140=arg[12]? arg[12][7] : 0;
  a088=(a088/a002);
  a140=(a140+a088);
  a012=(a012-a140);
  a200=(a200/a023);
  a201=(a201/a023);
  a010=(a201/a023);
  a010=(a010*a037);
  a200=(a200-a010);
  a200=(a012*a200);
  a010=arg[30]? arg[30][5] : 0;
  a193=(a077*a003);
  a188=(a005*a128);
  a193=(a193+a188);
  a010=(a010+a193);
  a193=arg[30]? arg[30][7] : 0;
  a204=(a204/a002);
  a088=(a088/a002);
  a088=(a088*a017);
  a204=(a204-a088);
  a193=(a193+a204);
  a010=(a010-a193);
  a201=(a201*a010);
  a200=(a200+a201);
  a034=(a034-a200);
  a200=arg[12]? arg[12][4] : 0;
  a201=(a005*a077);
  a200=(a200+a201);
  a200=(a200-a140);
  a197=(a197/a023);
  a198=(a198/a023);
  a201=(a198/a023);
  a201=(a201*a037);
  a197=(a197-a201);
  a197=(a200*a197);
  a201=arg[30]? arg[30][4] : 0;
  a003=(a077*a003);
  a005=(a005*a128);
  a003=(a003+a005);
  a201=(a201+a003);
  a201=(a201-a193);
  a198=(a198*a201);
  a197=(a197+a198);
  a034=(a034-a197);
  a197=(a116*a058);
  a198=(a103*a083);
  a197=(a197+a198);
  a198=(a175*a078);
  a197=(a197+a198);
  a198=(a169*a111);
  a003=(a156*a021);
  a198=(a198-a003);
  a003=(a180*a085);
  a198=(a198+a003);
  a200=(a200/a023);
  a198=(a198+a200);
  a003=(a035*a198);
  a197=(a197+a003);
  a197=(a009*a197);
  a003=(2.*a037);
  a197=(a197*a003);
  a003=(2.*a023);
  a058=(a058*a161);
  a116=(a116*a068);
  a058=(a058+a116);
  a083=(a083*a101);
  a105=(a103*a105);
  a083=(a083+a105);
  a058=(a058+a083);
  a078=(a078*a183);
  a175=(a175*a110);
  a078=(a078+a175);
  a058=(a058+a078);
  a031=(a198*a031);
  a111=(a111*a001);
  a144=(a169*a144);
  a111=(a111+a144);
  a021=(a021*a134);
  a040=(a156*a040);
  a021=(a021+a040);
  a111=(a111-a021);
  a085=(a085*a179);
  a114=(a180*a114);
  a085=(a085+a114);
  a111=(a111+a085);
  a201=(a201/a023);
  a200=(a200/a023);
  a200=(a200*a037);
  a201=(a201-a200);
  a111=(a111+a201);
  a035=(a035*a111);
  a031=(a031+a035);
  a058=(a058+a031);
  a009=(a009*a058);
  a003=(a003*a009);
  a197=(a197+a003);
  a034=(a034+a197);
  a197=arg[12]? arg[12][3] : 0;
  a003=(a119*a077);
  a197=(a197-a003);
  a197=(a197-a140);
  a197=(2.*a197);
  a191=(a191/a023);
  a195=(a195/a023);
  a140=(a195/a023);
  a140=(a140*a037);
  a191=(a191-a140);
  a191=(a197*a191);
  a140=arg[30]? arg[30][3] : 0;
  a077=(a077*a117);
  a119=(a119*a128);
  a077=(a077+a119);
  a140=(a140-a077);
  a140=(a140-a193);
  a140=(2.*a140);
  a195=(a195*a140);
  a191=(a191+a195);
  a034=(a034-a191);
  if (res[2]!=0) res[2][4]=a034;
  a065=(a065*a155);
  a067=(a157*a067);
  a065=(a065+a067);
  a045=(a045*a037);
  a039=(a023*a039);
  a045=(a045+a039);
  a065=(a065+a045);
  a100=(a100*a101);
  a103=(a103*a095);
  a100=(a100+a103);
  a065=(a065+a100);
  a100=(a024*a198);
  a028=(a100*a028);
  a198=(a198*a036);
  a024=(a024*a111);
  a198=(a198+a024);
  a032=(a032*a198);
  a028=(a028+a032);
  a065=(a065+a028);
  if (res[2]!=0) res[2][5]=a065;
  a051=(a051*a164);
  a069=(a163*a069);
  a051=(a051+a069);
  a069=(a157*a098);
  a065=(a069*a030);
  a098=(a098*a155);
  a104=(a157*a104);
  a098=(a098+a104);
  a104=(a026*a098);
  a065=(a065+a104);
  a051=(a051+a065);
  a065=(a025*a100);
  a030=(a065*a030);
  a100=(a100*a033);
  a025=(a025*a198);
  a100=(a100+a025);
  a026=(a026*a100);
  a030=(a030+a026);
  a051=(a051+a030);
  if (res[2]!=0) res[2][6]=a051;
  a059=(a059*a164);
  a163=(a163*a057);
  a059=(a059+a163);
  a069=(a069*a027);
  a098=(a029*a098);
  a069=(a069+a098);
  a059=(a059+a069);
  a065=(a065*a027);
  a029=(a029*a100);
  a065=(a065+a029);
  a059=(a059+a065);
  if (res[2]!=0) res[2][7]=a059;
  a148=(a148*a145);
  a136=(a136*a152);
  a148=(a148+a136);
  a126=(a126*a047);
  a048=(a048*a133);
  a126=(a126+a048);
  a148=(a148-a126);
  a122=(a122*a159);
  a158=(a158*a129);
  a122=(a122+a158);
  a148=(a148+a122);
  a190=(a190*a062);
  a086=(a086*a073);
  a190=(a190+a086);
  a148=(a148+a190);
  a140=(a140/a023);
  a197=(a197/a023);
  a197=(a197/a023);
  a197=(a197*a037);
  a140=(a140-a197);
  a148=(a148+a140);
  if (res[2]!=0) res[2][8]=a148;
  a004=(a004*a134);
  a156=(a156*a016);
  a004=(a004+a156);
  a142=(a142*a001);
  a169=(a169*a146);
  a142=(a142+a169);
  a004=(a004+a142);
  a082=(a082*a155);
  a157=(a157*a089);
  a082=(a082+a157);
  a004=(a004+a082);
  a181=(a181*a179);
  a180=(a180*a189);
  a181=(a181+a180);
  a004=(a004+a181);
  a010=(a010/a023);
  a012=(a012/a023);
  a012=(a012/a023);
  a012=(a012*a037);
  a010=(a010-a012);
  a004=(a004+a010);
  if (res[2]!=0) res[2][9]=a004;
  a004=arg[32]? arg[32][9] : 0;
  if (res[2]!=0) res[2][10]=a004;
  return 0;
}

CASADI_SYMBOL_EXPORT int fwd1_adj1_linear_jacobians(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f11(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int fwd1_adj1_linear_jacobians_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void fwd1_adj1_linear_jacobians_release(int mem) {
}

CASADI_SYMBOL_EXPORT void fwd1_adj1_linear_jacobians_incref(void) {
}

CASADI_SYMBOL_EXPORT void fwd1_adj1_linear_jacobians_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_linear_jacobians_n_in(void) { return 33;}

CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_linear_jacobians_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_linear_jacobians_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* fwd1_adj1_linear_jacobians_name_in(casadi_int i) {
  switch (i) {
    case 0: return "x";
    case 1: return "u";
    case 2: return "p";
    case 3: return "out_fx";
    case 4: return "out_fu";
    case 5: return "out_fp";
    case 6: return "out_gx";
    case 7: return "out_gu";
    case 8: return "out_gp";
    case 9: return "adj_fx";
    case 10: return "adj_fu";
    case 11: return "adj_fp";
    case 12: return "adj_gx";
    case 13: return "adj_gu";
    case 14: return "adj_gp";
    case 15: return "out_adj_x";
    case 16: return "out_adj_u";
    case 17: return "out_adj_p";
    case 18: return "fwd_x";
    case 19: return "fwd_u";
    case 20: return "fwd_p";
    case 21: return "fwd_out_fx";
    case 22: return "fwd_out_fu";
    case 23: return "fwd_out_fp";
    case 24: return "fwd_out_gx";
    case 25: return "fwd_out_gu";
    case 26: return "fwd_out_gp";
    case 27: return "fwd_adj_fx";
    case 28: return "fwd_adj_fu";
    case 29: return "fwd_adj_fp";
    case 30: return "fwd_adj_gx";
    case 31: return "fwd_adj_gu";
    case 32: return "fwd_adj_gp";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* fwd1_adj1_linear_jacobians_name_out(casadi_int i) {
  switch (i) {
    case 0: return "fwd_adj_x";
    case 1: return "fwd_adj_u";
    case 2: return "fwd_adj_p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_linear_jacobians_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    case 3: return casadi_s12;
    case 4: return casadi_s3;
    case 5: return casadi_s13;
    case 6: return casadi_s14;
    case 7: return casadi_s7;
    case 8: return casadi_s15;
    case 9: return casadi_s8;
    case 10: return casadi_s0;
    case 11: return casadi_s9;
    case 12: return casadi_s10;
    case 13: return casadi_s6;
    case 14: return casadi_s11;
    case 15: return casadi_s3;
    case 16: return casadi_s4;
    case 17: return casadi_s5;
    case 18: return casadi_s0;
    case 19: return casadi_s1;
    case 20: return casadi_s2;
    case 21: return casadi_s12;
    case 22: return casadi_s3;
    case 23: return casadi_s13;
    case 24: return casadi_s14;
    case 25: return casadi_s7;
    case 26: return casadi_s15;
    case 27: return casadi_s8;
    case 28: return casadi_s0;
    case 29: return casadi_s9;
    case 30: return casadi_s10;
    case 31: return casadi_s6;
    case 32: return casadi_s11;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_linear_jacobians_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int fwd1_adj1_linear_jacobians_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 33;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int fwd1_adj1_linear_jacobians_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 33*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


