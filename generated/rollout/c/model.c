/* Generated from derive/ (digest 64e19826779c900d) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`. */
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
#define casadi_f76 CASADI_PREFIX(f76)
#define casadi_f77 CASADI_PREFIX(f77)
#define casadi_f78 CASADI_PREFIX(f78)
#define casadi_f79 CASADI_PREFIX(f79)
#define casadi_f8 CASADI_PREFIX(f8)
#define casadi_f80 CASADI_PREFIX(f80)
#define casadi_f81 CASADI_PREFIX(f81)
#define casadi_f82 CASADI_PREFIX(f82)
#define casadi_f83 CASADI_PREFIX(f83)
#define casadi_f84 CASADI_PREFIX(f84)
#define casadi_f85 CASADI_PREFIX(f85)
#define casadi_f86 CASADI_PREFIX(f86)
#define casadi_f87 CASADI_PREFIX(f87)
#define casadi_f88 CASADI_PREFIX(f88)
#define casadi_f89 CASADI_PREFIX(f89)
#define casadi_f9 CASADI_PREFIX(f9)
#define casadi_f90 CASADI_PREFIX(f90)
#define casadi_f91 CASADI_PREFIX(f91)
#define casadi_f92 CASADI_PREFIX(f92)
#define casadi_f93 CASADI_PREFIX(f93)
#define casadi_f94 CASADI_PREFIX(f94)
#define casadi_f95 CASADI_PREFIX(f95)
#define casadi_fabs CASADI_PREFIX(fabs)
#define casadi_fmax CASADI_PREFIX(fmax)
#define casadi_fmin CASADI_PREFIX(fmin)
#define casadi_s0 CASADI_PREFIX(s0)
#define casadi_s1 CASADI_PREFIX(s1)
#define casadi_s2 CASADI_PREFIX(s2)
#define casadi_s3 CASADI_PREFIX(s3)
#define casadi_s4 CASADI_PREFIX(s4)
#define casadi_s5 CASADI_PREFIX(s5)
#define casadi_s6 CASADI_PREFIX(s6)
#define casadi_s7 CASADI_PREFIX(s7)
#define casadi_s8 CASADI_PREFIX(s8)
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

casadi_real casadi_fmin(casadi_real x, casadi_real y) {
/* Pre-c99 compatibility */
#if __STDC_VERSION__ < 199901L
  return x<y ? x : y;
#else
  return fmin(x, y);
#endif
}

casadi_real casadi_fmax(casadi_real x, casadi_real y) {
/* Pre-c99 compatibility */
#if __STDC_VERSION__ < 199901L
  return x>y ? x : y;
#else
  return fmax(x, y);
#endif
}

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
CASADI_SYMBOL_EXPORT void model_casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int model_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int model_casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {6, 1, 1};
static const casadi_int casadi_s1[3] = {11, 1, 1};
static const casadi_int casadi_s2[3] = {79, 1, 1};
static const casadi_int casadi_s3[4] = {6, 1, 0, 0};
static const casadi_int casadi_s4[4] = {11, 1, 0, 0};
static const casadi_int casadi_s5[4] = {79, 1, 0, 0};
static const casadi_int casadi_s6[3] = {39, 1, 1};
static const casadi_int casadi_s7[4] = {39, 1, 0, 0};
static const casadi_int casadi_s8[3] = {1, 1, 1};

/* rollout_rhs:(x[6],u[11],p[79])->(xdot[6]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68;
  a00=arg[0]? arg[0][2] : 0;
  a01=arg[0]? arg[0][1] : 0;
  a02=(a00*a01);
  a03=0.;
  a04=arg[2]? arg[2][26] : 0;
  a05=arg[2]? arg[2][27] : 0;
  a04=(a04*a05);
  a06=5.0000000000000000e-01;
  a07=arg[2]? arg[2][12] : 0;
  a08=1.0000000000000001e-01;
  a09=(a07+a08);
  a10=(-a09);
  a11=arg[2]? arg[2][11] : 0;
  a12=arg[1]? arg[1][3] : 0;
  a13=arg[2]? arg[2][10] : 0;
  a13=(a12*a13);
  a14=arg[2]? arg[2][9] : 0;
  a13=(a13+a14);
  a14=1.;
  a15=arg[2]? arg[2][8] : 0;
  a15=(a14-a15);
  a16=arg[2]? arg[2][1] : 0;
  a17=arg[0]? arg[0][0] : 0;
  a18=arg[1]? arg[1][0] : 0;
  a19=arg[0]? arg[0][5] : 0;
  a20=cos(a19);
  a20=(a18*a20);
  a21=arg[1]? arg[1][1] : 0;
  a22=sin(a19);
  a22=(a21*a22);
  a20=(a20+a22);
  a22=(a17-a20);
  a23=casadi_sq(a22);
  a24=1.0000000000000000e-04;
  a23=(a23+a24);
  a23=sqrt(a23);
  a22=(a22*a23);
  a23=(a06*a22);
  a25=arg[1]? arg[1][2] : 0;
  a26=arg[2]? arg[2][6] : 0;
  a27=arg[2]? arg[2][7] : 0;
  a28=casadi_sq(a27);
  a29=9.9999999999999998e-13;
  a28=(a28+a29);
  a28=sqrt(a28);
  a26=(a26*a28);
  a26=(a25/a26);
  a23=(a23+a26);
  a28=(2.*a26);
  a22=(a22+a28);
  a22=casadi_sq(a22);
  a28=1.0000000000000000e-08;
  a22=(a22+a28);
  a22=sqrt(a22);
  a22=(a06*a22);
  a23=(a23+a22);
  a22=sqrt(a23);
  a22=atan2(a03,a22);
  a22=(a16+a22);
  a15=(a15*a22);
  a13=(a13+a15);
  a11=(a11*a13);
  a09=casadi_fmin(a09,a11);
  a10=casadi_fmax(a10,a09);
  a09=2.0000000000000001e-01;
  a11=-5.;
  a13=(a11*a07);
  a15=5.;
  a22=(a15*a10);
  a13=(a13-a22);
  a13=(a13+a06);
  a13=casadi_fmax(a03,a13);
  a22=casadi_sq(a13);
  a22=(a13*a22);
  a22=(a09*a22);
  a13=(a06*a13);
  a13=(a14-a13);
  a22=(a22*a13);
  a22=(a10+a22);
  a07=(a11*a07);
  a10=(a15*a10);
  a07=(a07+a10);
  a07=(a07+a06);
  a07=casadi_fmax(a03,a07);
  a10=casadi_sq(a07);
  a10=(a07*a10);
  a10=(a09*a10);
  a07=(a06*a07);
  a07=(a14-a07);
  a10=(a10*a07);
  a22=(a22-a10);
  a22=(a06*a22);
  a10=arg[2]? arg[2][13] : 0;
  a22=(a22*a10);
  a22=(a22*a27);
  a10=arg[2]? arg[2][14] : 0;
  a22=(a22*a10);
  a22=(a22*a23);
  a04=(a04-a22);
  a23=arg[2]? arg[2][22] : 0;
  a10=(a23+a08);
  a07=(-a10);
  a13=arg[2]? arg[2][20] : 0;
  a30=arg[2]? arg[2][21] : 0;
  a30=(a30*a16);
  a13=(a13+a30);
  a10=casadi_fmin(a10,a13);
  a07=casadi_fmax(a07,a10);
  a10=(a11*a23);
  a13=(a15*a07);
  a10=(a10-a13);
  a10=(a10+a06);
  a10=casadi_fmax(a03,a10);
  a13=casadi_sq(a10);
  a13=(a10*a13);
  a13=(a09*a13);
  a10=(a06*a10);
  a10=(a14-a10);
  a13=(a13*a10);
  a13=(a07+a13);
  a23=(a11*a23);
  a07=(a15*a07);
  a23=(a23+a07);
  a23=(a23+a06);
  a23=casadi_fmax(a03,a23);
  a07=casadi_sq(a23);
  a07=(a23*a07);
  a07=(a09*a07);
  a23=(a06*a23);
  a23=(a14-a23);
  a07=(a07*a23);
  a13=(a13-a07);
  a07=arg[2]? arg[2][15] : 0;
  a23=(a06*a07);
  a10=(a17-a20);
  a30=casadi_sq(a10);
  a30=(a30+a28);
  a31=cos(a19);
  a21=(a21*a31);
  a31=sin(a19);
  a18=(a18*a31);
  a21=(a21-a18);
  a18=(a01-a21);
  a31=casadi_sq(a18);
  a31=(a30+a31);
  a23=(a23*a31);
  a23=(a23*a27);
  a32=(a13*a23);
  a32=(a32*a10);
  a30=sqrt(a30);
  a32=(a32/a30);
  a04=(a04-a32);
  a32=arg[2]? arg[2][0] : 0;
  a33=cos(a16);
  a32=(a32*a33);
  a33=arg[2]? arg[2][4] : 0;
  a34=sin(a16);
  a33=(a33*a34);
  a32=(a32+a33);
  a33=(a04*a32);
  a34=arg[2]? arg[2][28] : 0;
  a35=cos(a16);
  a34=(a34*a35);
  a35=arg[2]? arg[2][29] : 0;
  a36=sin(a16);
  a35=(a35*a36);
  a34=(a34+a35);
  a22=(a22*a34);
  a34=arg[2]? arg[2][19] : 0;
  a34=(a34*a23);
  a35=arg[2]? arg[2][16] : 0;
  a36=arg[2]? arg[2][17] : 0;
  a36=(a36*a16);
  a35=(a35+a36);
  a36=arg[2]? arg[2][18] : 0;
  a36=(a36*a12);
  a35=(a35+a36);
  a34=(a34*a35);
  a22=(a22+a34);
  a34=arg[2]? arg[2][31] : 0;
  a34=(a25*a34);
  a35=cos(a16);
  a34=(a34*a35);
  a22=(a22+a34);
  a33=(a33+a22);
  a34=arg[2]? arg[2][25] : 0;
  a35=cos(a16);
  a34=(a34*a35);
  a35=arg[2]? arg[2][30] : 0;
  a36=sin(a16);
  a35=(a35*a36);
  a36=(a34+a35);
  a36=(a32-a36);
  a33=(a33/a36);
  a33=casadi_fmax(a03,a33);
  a12=arg[2]? arg[2][55] : 0;
  a37=arg[2]? arg[2][50] : 0;
  a38=1.0000000000000000e-03;
  a39=arg[2]? arg[2][48] : 0;
  a40=arg[2]? arg[2][49] : 0;
  a40=(a40*a33);
  a39=(a39+a40);
  a39=casadi_fmax(a38,a39);
  a37=(a37*a39);
  a12=(a12/a37);
  a39=5.0000000000000004e-06;
  a40=(a12+a39);
  a41=(-a40);
  a42=arg[1]? arg[1][6] : 0;
  a43=arg[2]? arg[2][44] : 0;
  a43=(a42*a43);
  a44=arg[1]? arg[1][7] : 0;
  a43=(a43+a44);
  a44=arg[2]? arg[2][45] : 0;
  a45=(a14-a44);
  a43=(a43*a45);
  a45=cos(a43);
  a45=(a17*a45);
  a46=(a34+a35);
  a46=(a00*a46);
  a46=(a46+a01);
  a47=sin(a43);
  a47=(a46*a47);
  a45=(a45+a47);
  a47=arg[2]? arg[2][5] : 0;
  a48=casadi_sq(a47);
  a48=casadi_sq(a48);
  a49=casadi_sq(a45);
  a50=cos(a43);
  a46=(a46*a50);
  a50=sin(a43);
  a50=(a17*a50);
  a46=(a46-a50);
  a50=casadi_sq(a46);
  a49=(a49+a50);
  a49=casadi_sq(a49);
  a48=(a48+a49);
  a48=sqrt(a48);
  a48=sqrt(a48);
  a49=(a45/a48);
  a40=casadi_fmin(a40,a49);
  a41=casadi_fmax(a41,a40);
  a40=1.0000000000000001e-05;
  a49=-100000.;
  a50=(a49*a12);
  a51=100000.;
  a52=(a51*a41);
  a50=(a50-a52);
  a50=(a50+a06);
  a50=casadi_fmax(a03,a50);
  a52=casadi_sq(a50);
  a52=(a50*a52);
  a52=(a40*a52);
  a50=(a06*a50);
  a50=(a14-a50);
  a52=(a52*a50);
  a52=(a41+a52);
  a12=(a49*a12);
  a41=(a51*a41);
  a12=(a12+a41);
  a12=(a12+a06);
  a12=casadi_fmax(a03,a12);
  a41=casadi_sq(a12);
  a41=(a12*a41);
  a41=(a40*a41);
  a12=(a06*a12);
  a12=(a14-a12);
  a41=(a41*a12);
  a52=(a52-a41);
  a41=casadi_sq(a52);
  a41=(a14-a41);
  a41=sqrt(a41);
  a12=(a41+a39);
  a50=(-a12);
  a53=arg[2]? arg[2][54] : 0;
  a54=arg[2]? arg[2][53] : 0;
  a55=arg[2]? arg[2][51] : 0;
  a56=arg[2]? arg[2][52] : 0;
  a57=(a56-a14);
  a57=casadi_fmax(a29,a57);
  a57=sqrt(a57);
  a57=(a55*a57);
  a57=(1./a57);
  a58=(-a57);
  a59=arg[2]? arg[2][46] : 0;
  a60=arg[2]? arg[2][47] : 0;
  a60=(a60*a33);
  a59=(a59+a60);
  a59=casadi_fmax(a03,a59);
  a45=casadi_sq(a45);
  a60=9.9999999999999995e-07;
  a61=casadi_sq(a47);
  a60=(a60*a61);
  a45=(a45+a60);
  a61=sqrt(a45);
  a61=(a46/a61);
  a59=(a59*a61);
  a59=(a59/a37);
  a59=casadi_fmin(a59,a57);
  a58=casadi_fmax(a58,a59);
  a59=(a55*a58);
  a59=atan(a59);
  a59=(a56*a59);
  a59=(a59/a55);
  a56=(a56-a14);
  a58=(a58*a56);
  a59=(a59-a58);
  a55=(a55*a59);
  a55=atan(a55);
  a54=(a54*a55);
  a54=sin(a54);
  a53=(a53*a54);
  a46=casadi_sq(a46);
  a46=(a46+a45);
  a46=sqrt(a46);
  a53=(a53*a46);
  a53=(a53/a48);
  a12=casadi_fmin(a12,a53);
  a50=casadi_fmax(a50,a12);
  a12=(a49*a41);
  a53=(a51*a50);
  a12=(a12-a53);
  a12=(a12+a06);
  a12=casadi_fmax(a03,a12);
  a53=casadi_sq(a12);
  a53=(a12*a53);
  a53=(a40*a53);
  a12=(a06*a12);
  a12=(a14-a12);
  a53=(a53*a12);
  a53=(a50+a53);
  a41=(a49*a41);
  a50=(a51*a50);
  a41=(a41+a50);
  a41=(a41+a06);
  a41=casadi_fmax(a03,a41);
  a50=casadi_sq(a41);
  a50=(a41*a50);
  a50=(a40*a50);
  a41=(a06*a41);
  a41=(a14-a41);
  a50=(a50*a41);
  a53=(a53-a50);
  a53=(a33*a53);
  a53=(a53*a37);
  a44=(a14-a44);
  a53=(a53*a44);
  a44=sin(a43);
  a44=(a53*a44);
  a33=(a33*a52);
  a33=(a33*a37);
  a37=cos(a43);
  a37=(a33*a37);
  a44=(a44-a37);
  a44=(a44+a25);
  a25=(a34+a35);
  a04=(a04*a25);
  a04=(a04+a22);
  a04=(a06*a04);
  a04=(a04/a36);
  a04=(-a04);
  a04=casadi_fmax(a03,a04);
  a36=arg[1]? arg[1][4] : 0;
  a22=arg[2]? arg[2][36] : 0;
  a25=arg[2]? arg[2][34] : 0;
  a37=arg[2]? arg[2][35] : 0;
  a52=(a37*a04);
  a52=(a25+a52);
  a52=casadi_fmax(a38,a52);
  a22=(a22*a52);
  a52=arg[2]? arg[2][41] : 0;
  a50=(a22-a52);
  a36=(a36*a50);
  a36=(a36+a52);
  a36=(a36/a22);
  a52=(a36+a39);
  a50=(-a52);
  a41=(a00*a32);
  a41=(a41+a01);
  a12=arg[2]? arg[2][2] : 0;
  a48=sin(a12);
  a48=(a41*a48);
  a46=(a06*a00);
  a45=arg[2]? arg[2][3] : 0;
  a46=(a46*a45);
  a54=(a17+a46);
  a55=cos(a12);
  a54=(a54*a55);
  a54=(a48+a54);
  a55=casadi_sq(a47);
  a55=casadi_sq(a55);
  a59=casadi_sq(a54);
  a58=cos(a12);
  a58=(a41*a58);
  a56=(a17+a46);
  a57=sin(a12);
  a56=(a56*a57);
  a58=(a58-a56);
  a56=casadi_sq(a58);
  a59=(a59+a56);
  a59=casadi_sq(a59);
  a55=(a55+a59);
  a55=sqrt(a55);
  a55=sqrt(a55);
  a59=(a54/a55);
  a52=casadi_fmin(a52,a59);
  a50=casadi_fmax(a50,a52);
  a52=(a49*a36);
  a59=(a51*a50);
  a52=(a52-a59);
  a52=(a52+a06);
  a52=casadi_fmax(a03,a52);
  a59=casadi_sq(a52);
  a59=(a52*a59);
  a59=(a40*a59);
  a52=(a06*a52);
  a52=(a14-a52);
  a59=(a59*a52);
  a59=(a50+a59);
  a36=(a49*a36);
  a50=(a51*a50);
  a36=(a36+a50);
  a36=(a36+a06);
  a36=casadi_fmax(a03,a36);
  a50=casadi_sq(a36);
  a50=(a36*a50);
  a50=(a40*a50);
  a36=(a06*a36);
  a36=(a14-a36);
  a50=(a50*a36);
  a59=(a59-a50);
  a50=(a04*a59);
  a50=(a50*a22);
  a36=cos(a12);
  a36=(a50*a36);
  a59=casadi_sq(a59);
  a59=(a14-a59);
  a59=sqrt(a59);
  a52=(a59+a39);
  a56=(-a52);
  a57=arg[2]? arg[2][40] : 0;
  a61=arg[2]? arg[2][39] : 0;
  a62=arg[2]? arg[2][37] : 0;
  a63=arg[2]? arg[2][38] : 0;
  a64=(a63-a14);
  a29=casadi_fmax(a29,a64);
  a29=sqrt(a29);
  a29=(a62*a29);
  a29=(1./a29);
  a64=(-a29);
  a65=arg[2]? arg[2][32] : 0;
  a66=arg[2]? arg[2][33] : 0;
  a67=(a66*a04);
  a67=(a65+a67);
  a67=casadi_fmax(a03,a67);
  a54=casadi_sq(a54);
  a54=(a54+a60);
  a68=sqrt(a54);
  a68=(a58/a68);
  a67=(a67*a68);
  a67=(a67/a22);
  a67=casadi_fmin(a67,a29);
  a64=casadi_fmax(a64,a67);
  a67=(a14-a63);
  a67=(a64*a67);
  a64=(a62*a64);
  a64=atan(a64);
  a64=(a63*a64);
  a64=(a64/a62);
  a67=(a67+a64);
  a67=(a62*a67);
  a67=atan(a67);
  a67=(a61*a67);
  a67=sin(a67);
  a67=(a57*a67);
  a58=casadi_sq(a58);
  a58=(a58+a54);
  a58=sqrt(a58);
  a67=(a67*a58);
  a67=(a67/a55);
  a52=casadi_fmin(a52,a67);
  a56=casadi_fmax(a56,a52);
  a52=(a49*a59);
  a67=(a51*a56);
  a52=(a52-a67);
  a52=(a52+a06);
  a52=casadi_fmax(a03,a52);
  a67=casadi_sq(a52);
  a67=(a52*a67);
  a67=(a40*a67);
  a52=(a06*a52);
  a52=(a14-a52);
  a67=(a67*a52);
  a67=(a56+a67);
  a59=(a49*a59);
  a56=(a51*a56);
  a59=(a59+a56);
  a59=(a59+a06);
  a59=casadi_fmax(a03,a59);
  a56=casadi_sq(a59);
  a56=(a59*a56);
  a56=(a40*a56);
  a59=(a06*a59);
  a59=(a14-a59);
  a56=(a56*a59);
  a67=(a67-a56);
  a67=(a04*a67);
  a67=(a67*a22);
  a22=sin(a12);
  a22=(a67*a22);
  a36=(a36-a22);
  a44=(a44-a36);
  a22=arg[1]? arg[1][5] : 0;
  a56=arg[2]? arg[2][42] : 0;
  a37=(a37*a04);
  a25=(a25+a37);
  a38=casadi_fmax(a38,a25);
  a56=(a56*a38);
  a38=arg[2]? arg[2][43] : 0;
  a25=(a56-a38);
  a22=(a22*a25);
  a22=(a22+a38);
  a22=(a22/a56);
  a38=(a22+a39);
  a25=(-a38);
  a37=(a17-a46);
  a59=cos(a12);
  a37=(a37*a59);
  a37=(a37-a48);
  a47=casadi_sq(a47);
  a47=casadi_sq(a47);
  a48=casadi_sq(a37);
  a59=cos(a12);
  a41=(a41*a59);
  a46=(a17-a46);
  a59=sin(a12);
  a46=(a46*a59);
  a41=(a41+a46);
  a46=casadi_sq(a41);
  a48=(a48+a46);
  a48=casadi_sq(a48);
  a47=(a47+a48);
  a47=sqrt(a47);
  a47=sqrt(a47);
  a48=(a37/a47);
  a38=casadi_fmin(a38,a48);
  a25=casadi_fmax(a25,a38);
  a38=(a49*a22);
  a48=(a51*a25);
  a38=(a38-a48);
  a38=(a38+a06);
  a38=casadi_fmax(a03,a38);
  a48=casadi_sq(a38);
  a48=(a38*a48);
  a48=(a40*a48);
  a38=(a06*a38);
  a38=(a14-a38);
  a48=(a48*a38);
  a48=(a25+a48);
  a22=(a49*a22);
  a25=(a51*a25);
  a22=(a22+a25);
  a22=(a22+a06);
  a22=casadi_fmax(a03,a22);
  a25=casadi_sq(a22);
  a25=(a22*a25);
  a25=(a40*a25);
  a22=(a06*a22);
  a22=(a14-a22);
  a25=(a25*a22);
  a48=(a48-a25);
  a25=(a04*a48);
  a25=(a25*a56);
  a22=cos(a12);
  a22=(a25*a22);
  a48=casadi_sq(a48);
  a48=(a14-a48);
  a48=sqrt(a48);
  a39=(a48+a39);
  a38=(-a39);
  a46=(-a29);
  a66=(a66*a04);
  a65=(a65+a66);
  a65=casadi_fmax(a03,a65);
  a37=casadi_sq(a37);
  a37=(a37+a60);
  a60=sqrt(a37);
  a60=(a41/a60);
  a65=(a65*a60);
  a65=(a65/a56);
  a65=casadi_fmin(a65,a29);
  a46=casadi_fmax(a46,a65);
  a65=(a14-a63);
  a65=(a46*a65);
  a46=(a62*a46);
  a46=atan(a46);
  a63=(a63*a46);
  a63=(a63/a62);
  a65=(a65+a63);
  a62=(a62*a65);
  a62=atan(a62);
  a61=(a61*a62);
  a61=sin(a61);
  a57=(a57*a61);
  a41=casadi_sq(a41);
  a41=(a41+a37);
  a41=sqrt(a41);
  a57=(a57*a41);
  a57=(a57/a47);
  a39=casadi_fmin(a39,a57);
  a38=casadi_fmax(a38,a39);
  a39=(a49*a48);
  a57=(a51*a38);
  a39=(a39-a57);
  a39=(a39+a06);
  a39=casadi_fmax(a03,a39);
  a57=casadi_sq(a39);
  a57=(a39*a57);
  a57=(a40*a57);
  a39=(a06*a39);
  a39=(a14-a39);
  a57=(a57*a39);
  a57=(a38+a57);
  a49=(a49*a48);
  a51=(a51*a38);
  a49=(a49+a51);
  a49=(a49+a06);
  a49=casadi_fmax(a03,a49);
  a51=casadi_sq(a49);
  a51=(a49*a51);
  a40=(a40*a51);
  a49=(a06*a49);
  a49=(a14-a49);
  a40=(a40*a49);
  a57=(a57-a40);
  a04=(a04*a57);
  a04=(a04*a56);
  a56=sin(a12);
  a56=(a04*a56);
  a22=(a22+a56);
  a44=(a44-a22);
  a56=arg[2]? arg[2][23] : 0;
  a13=casadi_sq(a13);
  a57=arg[2]? arg[2][24] : 0;
  a13=(a13*a57);
  a56=(a56+a13);
  a56=(a56*a23);
  a56=(a56*a10);
  a56=(a56/a30);
  a44=(a44-a56);
  a44=(a44/a05);
  a02=(a02+a44);
  if (res[0]!=0) res[0][0]=a02;
  a02=arg[1]? arg[1][10] : 0;
  a44=arg[2]? arg[2][73] : 0;
  a44=(a06*a44);
  a56=arg[2]? arg[2][70] : 0;
  a08=(a56+a08);
  a10=(-a08);
  a13=arg[2]? arg[2][71] : 0;
  a57=arg[2]? arg[2][69] : 0;
  a40=sin(a16);
  a57=(a57*a40);
  a40=arg[2]? arg[2][68] : 0;
  a16=cos(a16);
  a40=(a40*a16);
  a57=(a57-a40);
  a16=(a00*a57);
  a16=(a16+a01);
  a16=(a16-a21);
  a20=(a17-a20);
  a21=casadi_sq(a20);
  a21=(a21+a24);
  a21=sqrt(a21);
  a20=(a20*a21);
  a21=(a06*a20);
  a21=(a21+a26);
  a26=(2.*a26);
  a20=(a20+a26);
  a20=casadi_sq(a20);
  a20=(a20+a28);
  a20=sqrt(a20);
  a20=(a06*a20);
  a21=(a21+a20);
  a20=sqrt(a21);
  a20=atan2(a16,a20);
  a28=arg[1]? arg[1][8] : 0;
  a26=arg[2]? arg[2][56] : 0;
  a42=(a42*a26);
  a28=(a28-a42);
  a42=arg[2]? arg[2][72] : 0;
  a42=(a28*a42);
  a20=(a20-a42);
  a13=(a13*a20);
  a08=casadi_fmin(a08,a13);
  a10=casadi_fmax(a10,a08);
  a08=(a11*a56);
  a13=(a15*a10);
  a08=(a08-a13);
  a08=(a08+a06);
  a08=casadi_fmax(a03,a08);
  a13=casadi_sq(a08);
  a13=(a08*a13);
  a13=(a09*a13);
  a08=(a06*a08);
  a08=(a14-a08);
  a13=(a13*a08);
  a13=(a10+a13);
  a11=(a11*a56);
  a15=(a15*a10);
  a11=(a11+a15);
  a11=(a11+a06);
  a03=casadi_fmax(a03,a11);
  a11=casadi_sq(a03);
  a11=(a03*a11);
  a09=(a09*a11);
  a03=(a06*a03);
  a14=(a14-a03);
  a09=(a09*a14);
  a13=(a13-a09);
  a44=(a44*a13);
  a13=arg[2]? arg[2][74] : 0;
  a44=(a44*a13);
  a44=(a44*a27);
  a16=casadi_sq(a16);
  a21=(a21+a16);
  a44=(a44*a21);
  a21=(a02-a44);
  a16=sin(a12);
  a16=(a25*a16);
  a21=(a21+a16);
  a16=arg[2]? arg[2][58] : 0;
  a13=arg[2]? arg[2][60] : 0;
  a16=(a16*a13);
  a09=2.5000000000000000e-01;
  a09=(a09*a07);
  a31=sqrt(a31);
  a09=(a09*a31);
  a09=(a09*a00);
  a09=(a09*a27);
  a16=(a16*a09);
  a27=arg[2]? arg[2][57] : 0;
  a18=atan2(a18,a30);
  a27=(a27*a18);
  a30=arg[2]? arg[2][59] : 0;
  a30=(a30*a28);
  a27=(a27+a30);
  a27=(a23*a27);
  a16=(a16+a27);
  a21=(a21+a16);
  a16=cos(a12);
  a04=(a04*a16);
  a21=(a21-a04);
  a16=sin(a12);
  a50=(a50*a16);
  a16=cos(a12);
  a67=(a67*a16);
  a50=(a50+a67);
  a21=(a21-a50);
  a67=sin(a43);
  a33=(a33*a67);
  a43=cos(a43);
  a53=(a53*a43);
  a33=(a33+a53);
  a21=(a21-a33);
  a21=(a21/a05);
  a05=(a00*a17);
  a21=(a21-a05);
  if (res[0]!=0) res[0][1]=a21;
  a21=arg[2]? arg[2][66] : 0;
  a05=casadi_sq(a13);
  a21=(a21*a05);
  a21=(a21*a09);
  a13=(a13*a23);
  a23=arg[2]? arg[2][64] : 0;
  a09=arg[1]? arg[1][9] : 0;
  a23=(a23*a09);
  a09=arg[2]? arg[2][65] : 0;
  a09=(a09*a18);
  a23=(a23+a09);
  a09=arg[2]? arg[2][67] : 0;
  a09=(a09*a28);
  a23=(a23+a09);
  a13=(a13*a23);
  a21=(a21+a13);
  a44=(a44*a57);
  a02=(a02*a40);
  a44=(a44+a02);
  a21=(a21-a44);
  a44=(a06*a45);
  a44=(a44*a36);
  a21=(a21-a44);
  a06=(a06*a45);
  a06=(a06*a22);
  a21=(a21+a06);
  a50=(a50*a32);
  a21=(a21-a50);
  a34=(a34+a35);
  a33=(a33*a34);
  a21=(a21-a33);
  a12=sin(a12);
  a25=(a25*a12);
  a25=(a25-a04);
  a32=(a32*a25);
  a21=(a21+a32);
  a32=arg[2]? arg[2][78] : 0;
  a21=(a21/a32);
  if (res[0]!=0) res[0][2]=a21;
  a21=cos(a19);
  a21=(a17*a21);
  a32=sin(a19);
  a32=(a01*a32);
  a21=(a21-a32);
  if (res[0]!=0) res[0][3]=a21;
  a21=sin(a19);
  a17=(a17*a21);
  a19=cos(a19);
  a01=(a01*a19);
  a17=(a17+a01);
  if (res[0]!=0) res[0][4]=a17;
  if (res[0]!=0) res[0][5]=a00;
  return 0;
}

CASADI_SYMBOL_EXPORT int rollout_rhs(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rollout_rhs_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rollout_rhs_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rollout_rhs_incref(void) {
}

CASADI_SYMBOL_EXPORT void rollout_rhs_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rollout_rhs_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int rollout_rhs_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real rollout_rhs_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rollout_rhs_name_in(casadi_int i) {
  switch (i) {
    case 0: return "x";
    case 1: return "u";
    case 2: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rollout_rhs_name_out(casadi_int i) {
  switch (i) {
    case 0: return "xdot";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rollout_rhs_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rollout_rhs_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rollout_rhs_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int rollout_rhs_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* fwd1_rollout_rhs:(x[6],u[11],p[79],out_xdot[6x1,0nz],fwd_x[6],fwd_u[11],fwd_p[79])->(fwd_xdot[6]) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
  casadi_real a204, a205, a206, a207, a208, a209, a210, a211, a212, a213, a214, a215;
  casadi_real a216, a217, a218, a219, a220;
  a000=arg[0]? arg[0][1] : 0;
  a001=arg[4]? arg[4][2] : 0;
  a002=(a000*a001);
  a003=arg[0]? arg[0][2] : 0;
  a004=arg[4]? arg[4][1] : 0;
  a005=(a003*a004);
  a002=(a002+a005);
  a005=arg[1]? arg[1][6] : 0;
  a006=arg[2]? arg[2][44] : 0;
  a007=(a005*a006);
  a008=arg[1]? arg[1][7] : 0;
  a007=(a007+a008);
  a008=1.;
  a009=arg[2]? arg[2][45] : 0;
  a010=(a008-a009);
  a011=(a007*a010);
  a012=sin(a011);
  a009=(a008-a009);
  a013=arg[2]? arg[2][50] : 0;
  a014=1.0000000000000000e-03;
  a015=arg[2]? arg[2][48] : 0;
  a016=arg[2]? arg[2][49] : 0;
  a017=0.;
  a018=arg[2]? arg[2][26] : 0;
  a019=arg[2]? arg[2][27] : 0;
  a020=(a018*a019);
  a021=5.0000000000000000e-01;
  a022=arg[2]? arg[2][12] : 0;
  a023=1.0000000000000001e-01;
  a024=(a022+a023);
  a025=(-a024);
  a026=arg[2]? arg[2][11] : 0;
  a027=arg[1]? arg[1][3] : 0;
  a028=arg[2]? arg[2][10] : 0;
  a029=(a027*a028);
  a030=arg[2]? arg[2][9] : 0;
  a029=(a029+a030);
  a030=arg[2]? arg[2][8] : 0;
  a030=(a008-a030);
  a031=arg[2]? arg[2][1] : 0;
  a032=arg[0]? arg[0][0] : 0;
  a033=arg[1]? arg[1][0] : 0;
  a034=arg[0]? arg[0][5] : 0;
  a035=cos(a034);
  a036=(a033*a035);
  a037=arg[1]? arg[1][1] : 0;
  a038=sin(a034);
  a039=(a037*a038);
  a036=(a036+a039);
  a039=(a032-a036);
  a040=casadi_sq(a039);
  a041=1.0000000000000000e-04;
  a040=(a040+a041);
  a040=sqrt(a040);
  a042=(a039*a040);
  a043=(a021*a042);
  a044=arg[1]? arg[1][2] : 0;
  a045=arg[2]? arg[2][6] : 0;
  a046=arg[2]? arg[2][7] : 0;
  a047=casadi_sq(a046);
  a048=9.9999999999999998e-13;
  a047=(a047+a048);
  a047=sqrt(a047);
  a049=(a045*a047);
  a050=(a044/a049);
  a043=(a043+a050);
  a051=(2.*a050);
  a042=(a042+a051);
  a051=casadi_sq(a042);
  a052=1.0000000000000000e-08;
  a051=(a051+a052);
  a051=sqrt(a051);
  a053=(a021*a051);
  a043=(a043+a053);
  a053=sqrt(a043);
  a053=atan2(a017,a053);
  a053=(a031+a053);
  a054=(a030*a053);
  a029=(a029+a054);
  a054=(a026*a029);
  a055=casadi_fmin(a024,a054);
  a056=casadi_fmax(a025,a055);
  a057=2.0000000000000001e-01;
  a058=-5.;
  a059=(a058*a022);
  a060=5.;
  a061=(a060*a056);
  a059=(a059-a061);
  a059=(a059+a021);
  a061=casadi_fmax(a017,a059);
  a062=casadi_sq(a061);
  a063=(a061*a062);
  a063=(a057*a063);
  a064=(a021*a061);
  a064=(a008-a064);
  a065=(a063*a064);
  a065=(a056+a065);
  a022=(a058*a022);
  a056=(a060*a056);
  a022=(a022+a056);
  a022=(a022+a021);
  a056=casadi_fmax(a017,a022);
  a066=casadi_sq(a056);
  a067=(a056*a066);
  a067=(a057*a067);
  a068=(a021*a056);
  a068=(a008-a068);
  a069=(a067*a068);
  a065=(a065-a069);
  a065=(a021*a065);
  a069=arg[2]? arg[2][13] : 0;
  a070=(a065*a069);
  a071=(a070*a046);
  a072=arg[2]? arg[2][14] : 0;
  a073=(a071*a072);
  a074=(a073*a043);
  a020=(a020-a074);
  a075=arg[2]? arg[2][22] : 0;
  a076=(a075+a023);
  a077=(-a076);
  a078=arg[2]? arg[2][20] : 0;
  a079=arg[2]? arg[2][21] : 0;
  a080=(a079*a031);
  a078=(a078+a080);
  a080=casadi_fmin(a076,a078);
  a081=casadi_fmax(a077,a080);
  a082=(a058*a075);
  a083=(a060*a081);
  a082=(a082-a083);
  a082=(a082+a021);
  a083=casadi_fmax(a017,a082);
  a084=casadi_sq(a083);
  a085=(a083*a084);
  a085=(a057*a085);
  a086=(a021*a083);
  a086=(a008-a086);
  a087=(a085*a086);
  a087=(a081+a087);
  a075=(a058*a075);
  a081=(a060*a081);
  a075=(a075+a081);
  a075=(a075+a021);
  a081=casadi_fmax(a017,a075);
  a088=casadi_sq(a081);
  a089=(a081*a088);
  a089=(a057*a089);
  a090=(a021*a081);
  a090=(a008-a090);
  a091=(a089*a090);
  a087=(a087-a091);
  a091=arg[2]? arg[2][15] : 0;
  a092=(a021*a091);
  a093=(a032-a036);
  a094=casadi_sq(a093);
  a094=(a094+a052);
  a095=cos(a034);
  a096=(a037*a095);
  a097=sin(a034);
  a098=(a033*a097);
  a096=(a096-a098);
  a098=(a000-a096);
  a099=casadi_sq(a098);
  a099=(a094+a099);
  a100=(a092*a099);
  a101=(a100*a046);
  a102=(a087*a101);
  a103=(a102*a093);
  a104=sqrt(a094);
  a103=(a103/a104);
  a020=(a020-a103);
  a105=arg[2]? arg[2][0] : 0;
  a106=cos(a031);
  a107=(a105*a106);
  a108=arg[2]? arg[2][4] : 0;
  a109=sin(a031);
  a110=(a108*a109);
  a107=(a107+a110);
  a110=(a020*a107);
  a111=arg[2]? arg[2][28] : 0;
  a112=cos(a031);
  a113=(a111*a112);
  a114=arg[2]? arg[2][29] : 0;
  a115=sin(a031);
  a116=(a114*a115);
  a113=(a113+a116);
  a116=(a074*a113);
  a117=arg[2]? arg[2][19] : 0;
  a118=(a117*a101);
  a119=arg[2]? arg[2][16] : 0;
  a120=arg[2]? arg[2][17] : 0;
  a121=(a120*a031);
  a119=(a119+a121);
  a121=arg[2]? arg[2][18] : 0;
  a122=(a121*a027);
  a119=(a119+a122);
  a122=(a118*a119);
  a116=(a116+a122);
  a122=arg[2]? arg[2][31] : 0;
  a123=(a044*a122);
  a124=cos(a031);
  a125=(a123*a124);
  a116=(a116+a125);
  a110=(a110+a116);
  a125=arg[2]? arg[2][25] : 0;
  a126=cos(a031);
  a127=(a125*a126);
  a128=arg[2]? arg[2][30] : 0;
  a129=sin(a031);
  a130=(a128*a129);
  a131=(a127+a130);
  a131=(a107-a131);
  a110=(a110/a131);
  a132=casadi_fmax(a017,a110);
  a133=(a016*a132);
  a015=(a015+a133);
  a133=casadi_fmax(a014,a015);
  a134=(a013*a133);
  a135=arg[2]? arg[2][55] : 0;
  a135=(a135/a134);
  a136=5.0000000000000004e-06;
  a137=(a135+a136);
  a138=(-a137);
  a139=cos(a011);
  a140=(a032*a139);
  a141=(a127+a130);
  a142=(a003*a141);
  a142=(a142+a000);
  a143=sin(a011);
  a144=(a142*a143);
  a140=(a140+a144);
  a144=arg[2]? arg[2][5] : 0;
  a145=casadi_sq(a144);
  a146=casadi_sq(a145);
  a147=casadi_sq(a140);
  a148=cos(a011);
  a149=(a142*a148);
  a150=sin(a011);
  a151=(a032*a150);
  a149=(a149-a151);
  a151=casadi_sq(a149);
  a147=(a147+a151);
  a151=casadi_sq(a147);
  a146=(a146+a151);
  a146=sqrt(a146);
  a151=sqrt(a146);
  a152=(a140/a151);
  a153=casadi_fmin(a137,a152);
  a154=casadi_fmax(a138,a153);
  a155=1.0000000000000001e-05;
  a156=-100000.;
  a157=(a156*a135);
  a158=100000.;
  a159=(a158*a154);
  a157=(a157-a159);
  a157=(a157+a021);
  a159=casadi_fmax(a017,a157);
  a160=casadi_sq(a159);
  a161=(a159*a160);
  a161=(a155*a161);
  a162=(a021*a159);
  a162=(a008-a162);
  a163=(a161*a162);
  a163=(a154+a163);
  a164=(a156*a135);
  a154=(a158*a154);
  a164=(a164+a154);
  a164=(a164+a021);
  a154=casadi_fmax(a017,a164);
  a165=casadi_sq(a154);
  a166=(a154*a165);
  a166=(a155*a166);
  a167=(a021*a154);
  a167=(a008-a167);
  a168=(a166*a167);
  a163=(a163-a168);
  a168=casadi_sq(a163);
  a168=(a008-a168);
  a168=sqrt(a168);
  a169=(a168+a136);
  a170=(-a169);
  a171=arg[2]? arg[2][54] : 0;
  a172=arg[2]? arg[2][53] : 0;
  a173=arg[2]? arg[2][51] : 0;
  a174=arg[2]? arg[2][52] : 0;
  a175=(a174-a008);
  a176=casadi_fmax(a048,a175);
  a176=sqrt(a176);
  a177=(a173*a176);
  a178=(1./a177);
  a179=(-a178);
  a180=arg[2]? arg[2][46] : 0;
  a181=arg[2]? arg[2][47] : 0;
  a182=(a181*a132);
  a180=(a180+a182);
  a182=casadi_fmax(a017,a180);
  a183=casadi_sq(a140);
  a184=9.9999999999999995e-07;
  a185=casadi_sq(a144);
  a185=(a184*a185);
  a183=(a183+a185);
  a186=sqrt(a183);
  a187=(a149/a186);
  a188=(a182*a187);
  a188=(a188/a134);
  a189=casadi_fmin(a188,a178);
  a190=casadi_fmax(a179,a189);
  a191=(a173*a190);
  a192=atan(a191);
  a193=(a174*a192);
  a193=(a193/a173);
  a194=(a174-a008);
  a195=(a190*a194);
  a195=(a193-a195);
  a196=(a173*a195);
  a197=atan(a196);
  a198=(a172*a197);
  a199=sin(a198);
  a200=(a171*a199);
  a201=casadi_sq(a149);
  a201=(a201+a183);
  a201=sqrt(a201);
  a183=(a200*a201);
  a183=(a183/a151);
  a202=casadi_fmin(a169,a183);
  a203=casadi_fmax(a170,a202);
  a204=(a156*a168);
  a205=(a158*a203);
  a204=(a204-a205);
  a204=(a204+a021);
  a205=casadi_fmax(a017,a204);
  a206=casadi_sq(a205);
  a207=(a205*a206);
  a207=(a155*a207);
  a208=(a021*a205);
  a208=(a008-a208);
  a209=(a207*a208);
  a209=(a203+a209);
  a210=(a156*a168);
  a203=(a158*a203);
  a210=(a210+a203);
  a210=(a210+a021);
  a203=casadi_fmax(a017,a210);
  a211=casadi_sq(a203);
  a212=(a203*a211);
  a212=(a155*a212);
  a213=(a021*a203);
  a213=(a008-a213);
  a214=(a212*a213);
  a209=(a209-a214);
  a214=(a017<=a110);
  a215=(a110<=a017);
  a215=(a215+a214);
  a214=(a214/a215);
  a215=arg[6]? arg[6][26] : 0;
  a215=(a019*a215);
  a216=arg[6]? arg[6][27] : 0;
  a018=(a018*a216);
  a215=(a215+a018);
  a018=(a025<=a055);
  a055=(a055<=a025);
  a025=(a055+a018);
  a018=(a018/a025);
  a217=(a024<=a054);
  a054=(a054<=a024);
  a024=(a217+a054);
  a217=(a217/a024);
  a218=arg[6]? arg[6][12] : 0;
  a217=(a217*a218);
  a054=(a054/a024);
  a024=arg[6]? arg[6][11] : 0;
  a029=(a029*a024);
  a024=arg[5]? arg[5][3] : 0;
  a028=(a028*a024);
  a219=arg[6]? arg[6][10] : 0;
  a219=(a027*a219);
  a028=(a028+a219);
  a219=arg[6]? arg[6][9] : 0;
  a028=(a028+a219);
  a219=arg[6]? arg[6][1] : 0;
  a030=(a030*a219);
  a220=arg[6]? arg[6][8] : 0;
  a053=(a053*a220);
  a030=(a030-a053);
  a028=(a028+a030);
  a026=(a026*a028);
  a029=(a029+a026);
  a054=(a054*a029);
  a217=(a217+a054);
  a018=(a018*a217);
  a055=(a055/a025);
  a055=(a055*a218);
  a018=(a018-a055);
  a055=(a017<=a059);
  a059=(a059<=a017);
  a059=(a059+a055);
  a055=(a055/a059);
  a059=(a058*a218);
  a025=(a060*a018);
  a059=(a059-a025);
  a055=(a055*a059);
  a062=(a062*a055);
  a059=(2.*a061);
  a059=(a059*a055);
  a061=(a061*a059);
  a062=(a062+a061);
  a062=(a057*a062);
  a064=(a064*a062);
  a055=(a021*a055);
  a063=(a063*a055);
  a064=(a064-a063);
  a064=(a018+a064);
  a063=(a017<=a022);
  a022=(a022<=a017);
  a022=(a022+a063);
  a063=(a063/a022);
  a218=(a058*a218);
  a018=(a060*a018);
  a218=(a218+a018);
  a063=(a063*a218);
  a066=(a066*a063);
  a218=(2.*a056);
  a218=(a218*a063);
  a056=(a056*a218);
  a066=(a066+a056);
  a066=(a057*a066);
  a068=(a068*a066);
  a063=(a021*a063);
  a067=(a067*a063);
  a068=(a068-a067);
  a064=(a064-a068);
  a064=(a021*a064);
  a069=(a069*a064);
  a064=arg[6]? arg[6][13] : 0;
  a065=(a065*a064);
  a069=(a069+a065);
  a069=(a046*a069);
  a065=arg[6]? arg[6][7] : 0;
  a070=(a070*a065);
  a069=(a069+a070);
  a072=(a072*a069);
  a069=arg[6]? arg[6][14] : 0;
  a071=(a071*a069);
  a072=(a072+a071);
  a043=(a043*a072);
  a072=arg[4]? arg[4][0] : 0;
  a071=arg[5]? arg[5][0] : 0;
  a035=(a035*a071);
  a069=sin(a034);
  a070=arg[4]? arg[4][5] : 0;
  a069=(a069*a070);
  a069=(a033*a069);
  a035=(a035-a069);
  a069=arg[5]? arg[5][1] : 0;
  a038=(a038*a069);
  a064=cos(a034);
  a064=(a064*a070);
  a064=(a037*a064);
  a038=(a038+a064);
  a035=(a035+a038);
  a038=(a072-a035);
  a064=(a040*a038);
  a068=(2.*a039);
  a068=(a068*a038);
  a040=(2.*a040);
  a068=(a068/a040);
  a039=(a039*a068);
  a064=(a064+a039);
  a039=(a021*a064);
  a068=arg[5]? arg[5][2] : 0;
  a040=(a068/a049);
  a049=(a050/a049);
  a038=arg[6]? arg[6][6] : 0;
  a038=(a047*a038);
  a067=(2.*a046);
  a067=(a067*a065);
  a047=(2.*a047);
  a067=(a067/a047);
  a045=(a045*a067);
  a038=(a038+a045);
  a049=(a049*a038);
  a040=(a040-a049);
  a039=(a039+a040);
  a042=(2.*a042);
  a049=(2.*a040);
  a064=(a064+a049);
  a042=(a042*a064);
  a051=(2.*a051);
  a042=(a042/a051);
  a042=(a021*a042);
  a039=(a039+a042);
  a073=(a073*a039);
  a043=(a043+a073);
  a215=(a215-a043);
  a073=(a077<=a080);
  a080=(a080<=a077);
  a077=(a080+a073);
  a073=(a073/a077);
  a039=(a076<=a078);
  a078=(a078<=a076);
  a076=(a039+a078);
  a039=(a039/a076);
  a042=arg[6]? arg[6][22] : 0;
  a039=(a039*a042);
  a078=(a078/a076);
  a076=arg[6]? arg[6][20] : 0;
  a051=arg[6]? arg[6][21] : 0;
  a051=(a031*a051);
  a079=(a079*a219);
  a051=(a051+a079);
  a076=(a076+a051);
  a078=(a078*a076);
  a039=(a039+a078);
  a073=(a073*a039);
  a080=(a080/a077);
  a080=(a080*a042);
  a073=(a073-a080);
  a080=(a017<=a082);
  a082=(a082<=a017);
  a082=(a082+a080);
  a080=(a080/a082);
  a082=(a058*a042);
  a077=(a060*a073);
  a082=(a082-a077);
  a080=(a080*a082);
  a084=(a084*a080);
  a082=(2.*a083);
  a082=(a082*a080);
  a083=(a083*a082);
  a084=(a084+a083);
  a084=(a057*a084);
  a086=(a086*a084);
  a080=(a021*a080);
  a085=(a085*a080);
  a086=(a086-a085);
  a086=(a073+a086);
  a085=(a017<=a075);
  a075=(a075<=a017);
  a075=(a075+a085);
  a085=(a085/a075);
  a042=(a058*a042);
  a073=(a060*a073);
  a042=(a042+a073);
  a085=(a085*a042);
  a088=(a088*a085);
  a042=(2.*a081);
  a042=(a042*a085);
  a081=(a081*a042);
  a088=(a088+a081);
  a088=(a057*a088);
  a090=(a090*a088);
  a085=(a021*a085);
  a089=(a089*a085);
  a090=(a090-a089);
  a086=(a086-a090);
  a090=(a101*a086);
  a089=arg[6]? arg[6][15] : 0;
  a085=(a021*a089);
  a085=(a099*a085);
  a088=(2.*a093);
  a081=(a072-a035);
  a088=(a088*a081);
  a042=(2.*a098);
  a095=(a095*a069);
  a069=sin(a034);
  a069=(a069*a070);
  a037=(a037*a069);
  a095=(a095-a037);
  a097=(a097*a071);
  a071=cos(a034);
  a071=(a071*a070);
  a033=(a033*a071);
  a097=(a097+a033);
  a095=(a095-a097);
  a097=(a004-a095);
  a042=(a042*a097);
  a042=(a088+a042);
  a092=(a092*a042);
  a085=(a085+a092);
  a085=(a046*a085);
  a100=(a100*a065);
  a085=(a085+a100);
  a100=(a087*a085);
  a090=(a090+a100);
  a090=(a093*a090);
  a102=(a102*a081);
  a090=(a090+a102);
  a090=(a090/a104);
  a103=(a103/a104);
  a102=(2.*a104);
  a088=(a088/a102);
  a103=(a103*a088);
  a090=(a090-a103);
  a215=(a215-a090);
  a090=(a107*a215);
  a103=arg[6]? arg[6][0] : 0;
  a106=(a106*a103);
  a103=sin(a031);
  a103=(a103*a219);
  a105=(a105*a103);
  a106=(a106-a105);
  a105=arg[6]? arg[6][4] : 0;
  a109=(a109*a105);
  a105=cos(a031);
  a105=(a105*a219);
  a108=(a108*a105);
  a109=(a109+a108);
  a106=(a106+a109);
  a109=(a020*a106);
  a090=(a090+a109);
  a113=(a113*a043);
  a043=arg[6]? arg[6][28] : 0;
  a112=(a112*a043);
  a043=sin(a031);
  a043=(a043*a219);
  a111=(a111*a043);
  a112=(a112-a111);
  a111=arg[6]? arg[6][29] : 0;
  a115=(a115*a111);
  a111=cos(a031);
  a111=(a111*a219);
  a114=(a114*a111);
  a115=(a115+a114);
  a112=(a112+a115);
  a074=(a074*a112);
  a113=(a113+a074);
  a074=arg[6]? arg[6][19] : 0;
  a074=(a101*a074);
  a117=(a117*a085);
  a074=(a074+a117);
  a119=(a119*a074);
  a074=arg[6]? arg[6][16] : 0;
  a117=arg[6]? arg[6][17] : 0;
  a117=(a031*a117);
  a120=(a120*a219);
  a117=(a117+a120);
  a074=(a074+a117);
  a117=arg[6]? arg[6][18] : 0;
  a027=(a027*a117);
  a121=(a121*a024);
  a027=(a027+a121);
  a074=(a074+a027);
  a118=(a118*a074);
  a119=(a119+a118);
  a113=(a113+a119);
  a122=(a122*a068);
  a119=arg[6]? arg[6][31] : 0;
  a119=(a044*a119);
  a122=(a122+a119);
  a124=(a124*a122);
  a122=sin(a031);
  a122=(a122*a219);
  a123=(a123*a122);
  a124=(a124-a123);
  a113=(a113+a124);
  a090=(a090+a113);
  a090=(a090/a131);
  a110=(a110/a131);
  a124=arg[6]? arg[6][25] : 0;
  a126=(a126*a124);
  a124=sin(a031);
  a124=(a124*a219);
  a125=(a125*a124);
  a126=(a126-a125);
  a125=arg[6]? arg[6][30] : 0;
  a129=(a129*a125);
  a125=cos(a031);
  a125=(a125*a219);
  a128=(a128*a125);
  a129=(a129+a128);
  a128=(a126+a129);
  a128=(a106-a128);
  a110=(a110*a128);
  a090=(a090-a110);
  a214=(a214*a090);
  a090=(a209*a214);
  a110=(a202<=a170);
  a170=(a170<=a202);
  a202=(a110+a170);
  a110=(a110/a202);
  a125=(2.*a163);
  a124=(a138<=a153);
  a153=(a153<=a138);
  a138=(a153+a124);
  a124=(a124/a138);
  a123=(a137<=a152);
  a137=(a152<=a137);
  a122=(a123+a137);
  a123=(a123/a122);
  a119=arg[6]? arg[6][55] : 0;
  a119=(a119/a134);
  a135=(a135/a134);
  a118=arg[6]? arg[6][50] : 0;
  a133=(a133*a118);
  a118=(a014<=a015);
  a015=(a015<=a014);
  a015=(a015+a118);
  a118=(a118/a015);
  a015=arg[6]? arg[6][48] : 0;
  a074=arg[6]? arg[6][49] : 0;
  a074=(a132*a074);
  a016=(a016*a214);
  a074=(a074+a016);
  a015=(a015+a074);
  a118=(a118*a015);
  a013=(a013*a118);
  a133=(a133+a013);
  a135=(a135*a133);
  a119=(a119-a135);
  a123=(a123*a119);
  a137=(a137/a122);
  a139=(a139*a072);
  a122=sin(a011);
  a135=arg[5]? arg[5][6] : 0;
  a006=(a006*a135);
  a013=arg[6]? arg[6][44] : 0;
  a013=(a005*a013);
  a006=(a006+a013);
  a013=arg[5]? arg[5][7] : 0;
  a006=(a006+a013);
  a010=(a010*a006);
  a006=arg[6]? arg[6][45] : 0;
  a007=(a007*a006);
  a010=(a010-a007);
  a122=(a122*a010);
  a122=(a032*a122);
  a139=(a139-a122);
  a141=(a141*a001);
  a122=(a126+a129);
  a122=(a003*a122);
  a141=(a141+a122);
  a141=(a141+a004);
  a143=(a143*a141);
  a122=cos(a011);
  a122=(a122*a010);
  a122=(a142*a122);
  a143=(a143+a122);
  a139=(a139+a143);
  a143=(a139/a151);
  a152=(a152/a151);
  a145=(2.*a145);
  a122=(2.*a144);
  a007=arg[6]? arg[6][5] : 0;
  a122=(a122*a007);
  a145=(a145*a122);
  a147=(2.*a147);
  a122=(2.*a140);
  a122=(a122*a139);
  a013=(2.*a149);
  a148=(a148*a141);
  a141=sin(a011);
  a141=(a141*a010);
  a142=(a142*a141);
  a148=(a148-a142);
  a150=(a150*a072);
  a142=cos(a011);
  a142=(a142*a010);
  a142=(a032*a142);
  a150=(a150+a142);
  a148=(a148-a150);
  a013=(a013*a148);
  a122=(a122+a013);
  a147=(a147*a122);
  a145=(a145+a147);
  a146=(2.*a146);
  a145=(a145/a146);
  a146=(2.*a151);
  a145=(a145/a146);
  a152=(a152*a145);
  a143=(a143-a152);
  a137=(a137*a143);
  a123=(a123+a137);
  a124=(a124*a123);
  a153=(a153/a138);
  a153=(a153*a119);
  a124=(a124-a153);
  a153=(a017<=a157);
  a157=(a157<=a017);
  a157=(a157+a153);
  a153=(a153/a157);
  a157=(a156*a119);
  a138=(a158*a124);
  a157=(a157-a138);
  a153=(a153*a157);
  a160=(a160*a153);
  a157=(2.*a159);
  a157=(a157*a153);
  a159=(a159*a157);
  a160=(a160+a159);
  a160=(a155*a160);
  a162=(a162*a160);
  a153=(a021*a153);
  a161=(a161*a153);
  a162=(a162-a161);
  a162=(a124+a162);
  a161=(a017<=a164);
  a164=(a164<=a017);
  a164=(a164+a161);
  a161=(a161/a164);
  a119=(a156*a119);
  a124=(a158*a124);
  a119=(a119+a124);
  a161=(a161*a119);
  a165=(a165*a161);
  a119=(2.*a154);
  a119=(a119*a161);
  a154=(a154*a119);
  a165=(a165+a154);
  a165=(a155*a165);
  a167=(a167*a165);
  a161=(a021*a161);
  a166=(a166*a161);
  a167=(a167-a166);
  a162=(a162-a167);
  a125=(a125*a162);
  a168=(2.*a168);
  a125=(a125/a168);
  a110=(a110*a125);
  a170=(a170/a202);
  a202=(a183<=a169);
  a169=(a169<=a183);
  a168=(a169+a202);
  a202=(a202/a168);
  a167=arg[6]? arg[6][54] : 0;
  a199=(a199*a167);
  a198=cos(a198);
  a167=arg[6]? arg[6][53] : 0;
  a197=(a197*a167);
  a167=arg[6]? arg[6][51] : 0;
  a195=(a195*a167);
  a166=arg[6]? arg[6][52] : 0;
  a192=(a192*a166);
  a161=(a190*a167);
  a165=(a189<=a179);
  a179=(a179<=a189);
  a189=(a165+a179);
  a165=(a165/a189);
  a177=(a178/a177);
  a154=(a176*a167);
  a119=(a048<=a175);
  a175=(a175<=a048);
  a175=(a175+a119);
  a119=(a119/a175);
  a119=(a119*a166);
  a176=(2.*a176);
  a119=(a119/a176);
  a119=(a173*a119);
  a154=(a154+a119);
  a177=(a177*a154);
  a165=(a165*a177);
  a179=(a179/a189);
  a189=(a188<=a178);
  a178=(a178<=a188);
  a154=(a189+a178);
  a189=(a189/a154);
  a119=(a017<=a180);
  a180=(a180<=a017);
  a180=(a180+a119);
  a119=(a119/a180);
  a180=arg[6]? arg[6][46] : 0;
  a176=arg[6]? arg[6][47] : 0;
  a176=(a132*a176);
  a181=(a181*a214);
  a176=(a176+a181);
  a180=(a180+a176);
  a119=(a119*a180);
  a119=(a187*a119);
  a180=(a148/a186);
  a187=(a187/a186);
  a140=(2.*a140);
  a140=(a140*a139);
  a139=(2.*a144);
  a139=(a139*a007);
  a184=(a184*a139);
  a140=(a140+a184);
  a186=(2.*a186);
  a186=(a140/a186);
  a187=(a187*a186);
  a180=(a180-a187);
  a182=(a182*a180);
  a119=(a119+a182);
  a119=(a119/a134);
  a188=(a188/a134);
  a188=(a188*a133);
  a119=(a119-a188);
  a189=(a189*a119);
  a178=(a178/a154);
  a178=(a178*a177);
  a189=(a189-a178);
  a179=(a179*a189);
  a165=(a165+a179);
  a179=(a173*a165);
  a161=(a161+a179);
  a191=casadi_sq(a191);
  a191=(a008+a191);
  a161=(a161/a191);
  a174=(a174*a161);
  a192=(a192+a174);
  a192=(a192/a173);
  a193=(a193/a173);
  a193=(a193*a167);
  a192=(a192-a193);
  a194=(a194*a165);
  a190=(a190*a166);
  a194=(a194+a190);
  a192=(a192-a194);
  a173=(a173*a192);
  a195=(a195+a173);
  a196=casadi_sq(a196);
  a196=(a008+a196);
  a195=(a195/a196);
  a172=(a172*a195);
  a197=(a197+a172);
  a198=(a198*a197);
  a171=(a171*a198);
  a199=(a199+a171);
  a199=(a201*a199);
  a149=(2.*a149);
  a149=(a149*a148);
  a149=(a149+a140);
  a201=(2.*a201);
  a149=(a149/a201);
  a200=(a200*a149);
  a199=(a199+a200);
  a199=(a199/a151);
  a183=(a183/a151);
  a183=(a183*a145);
  a199=(a199-a183);
  a202=(a202*a199);
  a169=(a169/a168);
  a169=(a169*a125);
  a202=(a202-a169);
  a170=(a170*a202);
  a110=(a110+a170);
  a170=(a017<=a204);
  a204=(a204<=a017);
  a204=(a204+a170);
  a170=(a170/a204);
  a204=(a156*a125);
  a202=(a158*a110);
  a204=(a204+a202);
  a170=(a170*a204);
  a204=(a021*a170);
  a207=(a207*a204);
  a206=(a206*a170);
  a204=(2.*a205);
  a204=(a204*a170);
  a205=(a205*a204);
  a206=(a206+a205);
  a206=(a155*a206);
  a208=(a208*a206);
  a207=(a207-a208);
  a207=(a110+a207);
  a208=(a017<=a210);
  a210=(a210<=a017);
  a210=(a210+a208);
  a208=(a208/a210);
  a110=(a158*a110);
  a125=(a156*a125);
  a110=(a110-a125);
  a208=(a208*a110);
  a211=(a211*a208);
  a110=(2.*a203);
  a110=(a110*a208);
  a203=(a203*a110);
  a211=(a211+a203);
  a211=(a155*a211);
  a213=(a213*a211);
  a208=(a021*a208);
  a212=(a212*a208);
  a213=(a213-a212);
  a207=(a207-a213);
  a207=(a132*a207);
  a090=(a090+a207);
  a090=(a134*a090);
  a209=(a132*a209);
  a207=(a209*a133);
  a090=(a090+a207);
  a090=(a009*a090);
  a209=(a209*a134);
  a006=(a209*a006);
  a090=(a090-a006);
  a006=(a012*a090);
  a209=(a209*a009);
  a009=cos(a011);
  a009=(a009*a010);
  a009=(a209*a009);
  a006=(a006+a009);
  a009=cos(a011);
  a214=(a163*a214);
  a162=(a132*a162);
  a214=(a214+a162);
  a214=(a134*a214);
  a132=(a132*a163);
  a133=(a132*a133);
  a214=(a214+a133);
  a133=(a009*a214);
  a132=(a132*a134);
  a134=sin(a011);
  a134=(a134*a010);
  a134=(a132*a134);
  a133=(a133-a134);
  a006=(a006-a133);
  a006=(a006+a068);
  a068=arg[2]? arg[2][2] : 0;
  a133=cos(a068);
  a134=arg[2]? arg[2][36] : 0;
  a163=arg[2]? arg[2][34] : 0;
  a162=arg[2]? arg[2][35] : 0;
  a207=(a127+a130);
  a213=(a020*a207);
  a213=(a213+a116);
  a213=(a021*a213);
  a213=(a213/a131);
  a116=(-a213);
  a212=casadi_fmax(a017,a116);
  a208=(a162*a212);
  a208=(a163+a208);
  a211=casadi_fmax(a014,a208);
  a203=(a134*a211);
  a110=arg[1]? arg[1][4] : 0;
  a125=arg[2]? arg[2][41] : 0;
  a210=(a203-a125);
  a206=(a110*a210);
  a206=(a206+a125);
  a206=(a206/a203);
  a125=(a206+a136);
  a205=(-a125);
  a204=(a003*a107);
  a204=(a204+a000);
  a170=sin(a068);
  a202=(a204*a170);
  a169=(a021*a003);
  a168=arg[2]? arg[2][3] : 0;
  a199=(a169*a168);
  a183=(a032+a199);
  a145=cos(a068);
  a151=(a183*a145);
  a151=(a202+a151);
  a200=casadi_sq(a144);
  a149=casadi_sq(a200);
  a201=casadi_sq(a151);
  a140=cos(a068);
  a148=(a204*a140);
  a171=(a032+a199);
  a198=sin(a068);
  a197=(a171*a198);
  a148=(a148-a197);
  a197=casadi_sq(a148);
  a201=(a201+a197);
  a197=casadi_sq(a201);
  a149=(a149+a197);
  a149=sqrt(a149);
  a197=sqrt(a149);
  a172=(a151/a197);
  a195=casadi_fmin(a125,a172);
  a196=(a205<=a195);
  a173=(a195<=a205);
  a192=(a173+a196);
  a196=(a196/a192);
  a194=(a125<=a172);
  a125=(a172<=a125);
  a190=(a194+a125);
  a194=(a194/a190);
  a166=arg[5]? arg[5][4] : 0;
  a210=(a210*a166);
  a166=arg[6]? arg[6][36] : 0;
  a211=(a211*a166);
  a166=(a014<=a208);
  a208=(a208<=a014);
  a208=(a208+a166);
  a166=(a166/a208);
  a208=arg[6]? arg[6][34] : 0;
  a165=arg[6]? arg[6][35] : 0;
  a193=(a212*a165);
  a167=(a017<=a116);
  a116=(a116<=a017);
  a116=(a116+a167);
  a167=(a167/a116);
  a207=(a207*a215);
  a215=(a126+a129);
  a020=(a020*a215);
  a207=(a207+a020);
  a207=(a207+a113);
  a207=(a021*a207);
  a207=(a207/a131);
  a213=(a213/a131);
  a213=(a213*a128);
  a207=(a207-a213);
  a167=(a167*a207);
  a207=(a162*a167);
  a193=(a193-a207);
  a193=(a208+a193);
  a166=(a166*a193);
  a134=(a134*a166);
  a211=(a211+a134);
  a134=arg[6]? arg[6][41] : 0;
  a166=(a211-a134);
  a110=(a110*a166);
  a210=(a210+a110);
  a210=(a210+a134);
  a210=(a210/a203);
  a134=(a206/a203);
  a134=(a134*a211);
  a210=(a210-a134);
  a194=(a194*a210);
  a125=(a125/a190);
  a190=(a107*a001);
  a134=(a003*a106);
  a190=(a190+a134);
  a190=(a190+a004);
  a170=(a170*a190);
  a134=cos(a068);
  a110=arg[6]? arg[6][2] : 0;
  a134=(a134*a110);
  a134=(a204*a134);
  a170=(a170+a134);
  a134=(a021*a001);
  a134=(a168*a134);
  a166=arg[6]? arg[6][3] : 0;
  a169=(a169*a166);
  a134=(a134+a169);
  a169=(a072+a134);
  a145=(a145*a169);
  a169=sin(a068);
  a169=(a169*a110);
  a183=(a183*a169);
  a145=(a145-a183);
  a145=(a170+a145);
  a183=(a145/a197);
  a172=(a172/a197);
  a200=(2.*a200);
  a169=(2.*a144);
  a169=(a169*a007);
  a200=(a200*a169);
  a201=(2.*a201);
  a169=(2.*a151);
  a169=(a169*a145);
  a193=(2.*a148);
  a140=(a140*a190);
  a207=sin(a068);
  a207=(a207*a110);
  a207=(a204*a207);
  a140=(a140-a207);
  a207=(a072+a134);
  a198=(a198*a207);
  a207=cos(a068);
  a207=(a207*a110);
  a171=(a171*a207);
  a198=(a198+a171);
  a140=(a140-a198);
  a193=(a193*a140);
  a169=(a169+a193);
  a201=(a201*a169);
  a200=(a200+a201);
  a149=(2.*a149);
  a200=(a200/a149);
  a149=(2.*a197);
  a200=(a200/a149);
  a172=(a172*a200);
  a183=(a183-a172);
  a125=(a125*a183);
  a194=(a194+a125);
  a196=(a196*a194);
  a173=(a173/a192);
  a173=(a173*a210);
  a196=(a196-a173);
  a173=(a156*a206);
  a205=casadi_fmax(a205,a195);
  a195=(a158*a205);
  a173=(a173-a195);
  a173=(a173+a021);
  a195=casadi_fmax(a017,a173);
  a192=(a021*a195);
  a192=(a008-a192);
  a194=casadi_sq(a195);
  a125=(a017<=a173);
  a173=(a173<=a017);
  a173=(a173+a125);
  a125=(a125/a173);
  a173=(a156*a210);
  a183=(a158*a196);
  a173=(a173-a183);
  a125=(a125*a173);
  a173=(a194*a125);
  a183=(2.*a195);
  a183=(a183*a125);
  a183=(a195*a183);
  a173=(a173+a183);
  a173=(a155*a173);
  a173=(a192*a173);
  a195=(a195*a194);
  a195=(a155*a195);
  a125=(a021*a125);
  a125=(a195*a125);
  a173=(a173-a125);
  a173=(a196+a173);
  a206=(a156*a206);
  a125=(a158*a205);
  a206=(a206+a125);
  a206=(a206+a021);
  a125=casadi_fmax(a017,a206);
  a194=(a021*a125);
  a194=(a008-a194);
  a183=casadi_sq(a125);
  a172=(a017<=a206);
  a206=(a206<=a017);
  a206=(a206+a172);
  a172=(a172/a206);
  a210=(a156*a210);
  a196=(a158*a196);
  a210=(a210+a196);
  a172=(a172*a210);
  a210=(a183*a172);
  a196=(2.*a125);
  a196=(a196*a172);
  a196=(a125*a196);
  a210=(a210+a196);
  a210=(a155*a210);
  a210=(a194*a210);
  a125=(a125*a183);
  a125=(a155*a125);
  a172=(a021*a172);
  a172=(a125*a172);
  a210=(a210-a172);
  a173=(a173-a210);
  a210=(a212*a173);
  a195=(a195*a192);
  a205=(a205+a195);
  a125=(a125*a194);
  a205=(a205-a125);
  a125=(a205*a167);
  a210=(a210-a125);
  a210=(a203*a210);
  a125=(a212*a205);
  a194=(a125*a211);
  a210=(a210+a194);
  a194=(a133*a210);
  a125=(a125*a203);
  a195=sin(a068);
  a195=(a195*a110);
  a195=(a125*a195);
  a194=(a194-a195);
  a195=sin(a068);
  a192=casadi_sq(a205);
  a192=(a008-a192);
  a192=sqrt(a192);
  a172=(a192+a136);
  a183=arg[2]? arg[2][40] : 0;
  a196=arg[2]? arg[2][39] : 0;
  a206=arg[2]? arg[2][37] : 0;
  a149=arg[2]? arg[2][38] : 0;
  a201=(a149-a008);
  a169=casadi_fmax(a048,a201);
  a169=sqrt(a169);
  a193=(a206*a169);
  a198=(1./a193);
  a171=(-a198);
  a207=arg[2]? arg[2][32] : 0;
  a213=arg[2]? arg[2][33] : 0;
  a128=(a213*a212);
  a128=(a207+a128);
  a131=casadi_fmax(a017,a128);
  a113=casadi_sq(a151);
  a113=(a113+a185);
  a020=sqrt(a113);
  a215=(a148/a020);
  a116=(a131*a215);
  a116=(a116/a203);
  a174=casadi_fmin(a116,a198);
  a161=casadi_fmax(a171,a174);
  a191=(a008-a149);
  a179=(a161*a191);
  a189=(a206*a161);
  a178=atan(a189);
  a177=(a149*a178);
  a177=(a177/a206);
  a179=(a179+a177);
  a154=(a206*a179);
  a119=atan(a154);
  a188=(a196*a119);
  a182=sin(a188);
  a180=(a183*a182);
  a187=casadi_sq(a148);
  a187=(a187+a113);
  a187=sqrt(a187);
  a113=(a180*a187);
  a113=(a113/a197);
  a186=casadi_fmin(a172,a113);
  a139=(-a172);
  a176=(a186<=a139);
  a181=(a139<=a186);
  a175=(a176+a181);
  a176=(a176/a175);
  a205=(2.*a205);
  a205=(a205*a173);
  a173=(2.*a192);
  a205=(a205/a173);
  a176=(a176*a205);
  a181=(a181/a175);
  a175=(a113<=a172);
  a172=(a172<=a113);
  a173=(a172+a175);
  a175=(a175/a173);
  a124=arg[6]? arg[6][40] : 0;
  a182=(a182*a124);
  a188=cos(a188);
  a164=arg[6]? arg[6][39] : 0;
  a119=(a119*a164);
  a153=arg[6]? arg[6][37] : 0;
  a179=(a179*a153);
  a160=(a174<=a171);
  a171=(a171<=a174);
  a174=(a160+a171);
  a160=(a160/a174);
  a193=(a198/a193);
  a159=(a169*a153);
  a157=(a048<=a201);
  a201=(a201<=a048);
  a201=(a201+a157);
  a157=(a157/a201);
  a201=arg[6]? arg[6][38] : 0;
  a157=(a157*a201);
  a169=(2.*a169);
  a157=(a157/a169);
  a157=(a206*a157);
  a159=(a159+a157);
  a193=(a193*a159);
  a160=(a160*a193);
  a171=(a171/a174);
  a174=(a116<=a198);
  a159=(a198<=a116);
  a157=(a174+a159);
  a174=(a174/a157);
  a169=(a017<=a128);
  a128=(a128<=a017);
  a128=(a128+a169);
  a169=(a169/a128);
  a128=arg[6]? arg[6][32] : 0;
  a048=arg[6]? arg[6][33] : 0;
  a138=(a212*a048);
  a123=(a213*a167);
  a138=(a138-a123);
  a138=(a128+a138);
  a169=(a169*a138);
  a169=(a215*a169);
  a138=(a140/a020);
  a215=(a215/a020);
  a151=(2.*a151);
  a151=(a151*a145);
  a151=(a151+a184);
  a020=(2.*a020);
  a020=(a151/a020);
  a215=(a215*a020);
  a138=(a138-a215);
  a131=(a131*a138);
  a169=(a169+a131);
  a169=(a169/a203);
  a116=(a116/a203);
  a116=(a116*a211);
  a169=(a169-a116);
  a174=(a174*a169);
  a159=(a159/a157);
  a159=(a159*a193);
  a174=(a174-a159);
  a171=(a171*a174);
  a160=(a160+a171);
  a191=(a191*a160);
  a171=(a161*a201);
  a191=(a191-a171);
  a178=(a178*a201);
  a161=(a161*a153);
  a160=(a206*a160);
  a161=(a161+a160);
  a189=casadi_sq(a189);
  a189=(a008+a189);
  a161=(a161/a189);
  a161=(a149*a161);
  a178=(a178+a161);
  a178=(a178/a206);
  a177=(a177/a206);
  a177=(a177*a153);
  a178=(a178-a177);
  a191=(a191+a178);
  a191=(a206*a191);
  a179=(a179+a191);
  a154=casadi_sq(a154);
  a154=(a008+a154);
  a179=(a179/a154);
  a179=(a196*a179);
  a119=(a119+a179);
  a188=(a188*a119);
  a188=(a183*a188);
  a182=(a182+a188);
  a182=(a187*a182);
  a148=(2.*a148);
  a148=(a148*a140);
  a148=(a148+a151);
  a187=(2.*a187);
  a148=(a148/a187);
  a180=(a180*a148);
  a182=(a182+a180);
  a182=(a182/a197);
  a113=(a113/a197);
  a113=(a113*a200);
  a182=(a182-a113);
  a175=(a175*a182);
  a172=(a172/a173);
  a172=(a172*a205);
  a175=(a175-a172);
  a181=(a181*a175);
  a176=(a176+a181);
  a181=(a156*a192);
  a139=casadi_fmax(a139,a186);
  a186=(a158*a139);
  a181=(a181-a186);
  a181=(a181+a021);
  a186=casadi_fmax(a017,a181);
  a175=casadi_sq(a186);
  a172=(a186*a175);
  a172=(a155*a172);
  a173=(a017<=a181);
  a181=(a181<=a017);
  a181=(a181+a173);
  a173=(a173/a181);
  a181=(a156*a205);
  a182=(a158*a176);
  a181=(a181+a182);
  a173=(a173*a181);
  a181=(a021*a173);
  a181=(a172*a181);
  a182=(a021*a186);
  a182=(a008-a182);
  a175=(a175*a173);
  a113=(2.*a186);
  a113=(a113*a173);
  a186=(a186*a113);
  a175=(a175+a186);
  a175=(a155*a175);
  a175=(a182*a175);
  a181=(a181-a175);
  a181=(a176+a181);
  a192=(a156*a192);
  a175=(a158*a139);
  a192=(a192+a175);
  a192=(a192+a021);
  a175=casadi_fmax(a017,a192);
  a186=(a021*a175);
  a186=(a008-a186);
  a113=casadi_sq(a175);
  a173=(a017<=a192);
  a192=(a192<=a017);
  a192=(a192+a173);
  a173=(a173/a192);
  a176=(a158*a176);
  a205=(a156*a205);
  a176=(a176-a205);
  a173=(a173*a176);
  a176=(a113*a173);
  a205=(2.*a175);
  a205=(a205*a173);
  a205=(a175*a205);
  a176=(a176+a205);
  a176=(a155*a176);
  a176=(a186*a176);
  a175=(a175*a113);
  a175=(a155*a175);
  a173=(a021*a173);
  a173=(a175*a173);
  a176=(a176-a173);
  a181=(a181-a176);
  a181=(a212*a181);
  a172=(a172*a182);
  a139=(a139+a172);
  a175=(a175*a186);
  a139=(a139-a175);
  a175=(a139*a167);
  a181=(a181-a175);
  a181=(a203*a181);
  a139=(a212*a139);
  a211=(a139*a211);
  a181=(a181+a211);
  a211=(a195*a181);
  a139=(a139*a203);
  a203=cos(a068);
  a203=(a203*a110);
  a203=(a139*a203);
  a211=(a211+a203);
  a194=(a194-a211);
  a006=(a006-a194);
  a211=cos(a068);
  a203=arg[2]? arg[2][42] : 0;
  a175=(a162*a212);
  a163=(a163+a175);
  a175=casadi_fmax(a014,a163);
  a186=(a203*a175);
  a172=arg[1]? arg[1][5] : 0;
  a182=arg[2]? arg[2][43] : 0;
  a176=(a186-a182);
  a173=(a172*a176);
  a173=(a173+a182);
  a173=(a173/a186);
  a182=(a173+a136);
  a113=(-a182);
  a205=(a032-a199);
  a192=cos(a068);
  a200=(a205*a192);
  a200=(a200-a202);
  a202=casadi_sq(a144);
  a197=casadi_sq(a202);
  a180=casadi_sq(a200);
  a148=cos(a068);
  a187=(a204*a148);
  a199=(a032-a199);
  a151=sin(a068);
  a140=(a199*a151);
  a187=(a187+a140);
  a140=casadi_sq(a187);
  a180=(a180+a140);
  a140=casadi_sq(a180);
  a197=(a197+a140);
  a197=sqrt(a197);
  a140=sqrt(a197);
  a188=(a200/a140);
  a119=casadi_fmin(a182,a188);
  a179=(a113<=a119);
  a154=(a119<=a113);
  a191=(a154+a179);
  a179=(a179/a191);
  a178=(a182<=a188);
  a182=(a188<=a182);
  a177=(a178+a182);
  a178=(a178/a177);
  a161=arg[5]? arg[5][5] : 0;
  a176=(a176*a161);
  a161=arg[6]? arg[6][42] : 0;
  a175=(a175*a161);
  a161=(a014<=a163);
  a163=(a163<=a014);
  a163=(a163+a161);
  a161=(a161/a163);
  a165=(a212*a165);
  a162=(a162*a167);
  a165=(a165-a162);
  a208=(a208+a165);
  a161=(a161*a208);
  a203=(a203*a161);
  a175=(a175+a203);
  a203=arg[6]? arg[6][43] : 0;
  a161=(a175-a203);
  a172=(a172*a161);
  a176=(a176+a172);
  a176=(a176+a203);
  a176=(a176/a186);
  a203=(a173/a186);
  a203=(a203*a175);
  a176=(a176-a203);
  a178=(a178*a176);
  a182=(a182/a177);
  a177=(a072-a134);
  a192=(a192*a177);
  a177=sin(a068);
  a177=(a177*a110);
  a205=(a205*a177);
  a192=(a192-a205);
  a192=(a192-a170);
  a170=(a192/a140);
  a188=(a188/a140);
  a202=(2.*a202);
  a144=(2.*a144);
  a144=(a144*a007);
  a202=(a202*a144);
  a180=(2.*a180);
  a144=(2.*a200);
  a144=(a144*a192);
  a007=(2.*a187);
  a148=(a148*a190);
  a190=sin(a068);
  a190=(a190*a110);
  a204=(a204*a190);
  a148=(a148-a204);
  a134=(a072-a134);
  a151=(a151*a134);
  a134=cos(a068);
  a134=(a134*a110);
  a199=(a199*a134);
  a151=(a151+a199);
  a148=(a148+a151);
  a007=(a007*a148);
  a144=(a144+a007);
  a180=(a180*a144);
  a202=(a202+a180);
  a197=(2.*a197);
  a202=(a202/a197);
  a197=(2.*a140);
  a202=(a202/a197);
  a188=(a188*a202);
  a170=(a170-a188);
  a182=(a182*a170);
  a178=(a178+a182);
  a179=(a179*a178);
  a154=(a154/a191);
  a154=(a154*a176);
  a179=(a179-a154);
  a154=(a156*a173);
  a113=casadi_fmax(a113,a119);
  a119=(a158*a113);
  a154=(a154-a119);
  a154=(a154+a021);
  a119=casadi_fmax(a017,a154);
  a191=(a021*a119);
  a191=(a008-a191);
  a178=casadi_sq(a119);
  a182=(a017<=a154);
  a154=(a154<=a017);
  a154=(a154+a182);
  a182=(a182/a154);
  a154=(a156*a176);
  a170=(a158*a179);
  a154=(a154-a170);
  a182=(a182*a154);
  a154=(a178*a182);
  a170=(2.*a119);
  a170=(a170*a182);
  a170=(a119*a170);
  a154=(a154+a170);
  a154=(a155*a154);
  a154=(a191*a154);
  a119=(a119*a178);
  a119=(a155*a119);
  a182=(a021*a182);
  a182=(a119*a182);
  a154=(a154-a182);
  a154=(a179+a154);
  a173=(a156*a173);
  a182=(a158*a113);
  a173=(a173+a182);
  a173=(a173+a021);
  a182=casadi_fmax(a017,a173);
  a178=(a021*a182);
  a178=(a008-a178);
  a170=casadi_sq(a182);
  a188=(a017<=a173);
  a173=(a173<=a017);
  a173=(a173+a188);
  a188=(a188/a173);
  a176=(a156*a176);
  a179=(a158*a179);
  a176=(a176+a179);
  a188=(a188*a176);
  a176=(a170*a188);
  a179=(2.*a182);
  a179=(a179*a188);
  a179=(a182*a179);
  a176=(a176+a179);
  a176=(a155*a176);
  a176=(a178*a176);
  a182=(a182*a170);
  a182=(a155*a182);
  a188=(a021*a188);
  a188=(a182*a188);
  a176=(a176-a188);
  a154=(a154-a176);
  a176=(a212*a154);
  a119=(a119*a191);
  a113=(a113+a119);
  a182=(a182*a178);
  a113=(a113-a182);
  a182=(a113*a167);
  a176=(a176-a182);
  a176=(a186*a176);
  a182=(a212*a113);
  a178=(a182*a175);
  a176=(a176+a178);
  a178=(a211*a176);
  a182=(a182*a186);
  a119=sin(a068);
  a119=(a119*a110);
  a119=(a182*a119);
  a178=(a178-a119);
  a119=sin(a068);
  a191=casadi_sq(a113);
  a191=(a008-a191);
  a191=sqrt(a191);
  a136=(a191+a136);
  a188=(-a198);
  a170=(a213*a212);
  a207=(a207+a170);
  a170=casadi_fmax(a017,a207);
  a179=casadi_sq(a200);
  a179=(a179+a185);
  a185=sqrt(a179);
  a173=(a187/a185);
  a197=(a170*a173);
  a197=(a197/a186);
  a180=casadi_fmin(a197,a198);
  a144=casadi_fmax(a188,a180);
  a007=(a008-a149);
  a151=(a144*a007);
  a199=(a206*a144);
  a134=atan(a199);
  a204=(a149*a134);
  a204=(a204/a206);
  a151=(a151+a204);
  a190=(a206*a151);
  a205=atan(a190);
  a177=(a196*a205);
  a203=sin(a177);
  a172=(a183*a203);
  a161=casadi_sq(a187);
  a161=(a161+a179);
  a161=sqrt(a161);
  a179=(a172*a161);
  a179=(a179/a140);
  a208=casadi_fmin(a136,a179);
  a165=(-a136);
  a162=(a208<=a165);
  a163=(a165<=a208);
  a014=(a162+a163);
  a162=(a162/a014);
  a113=(2.*a113);
  a113=(a113*a154);
  a154=(2.*a191);
  a113=(a113/a154);
  a162=(a162*a113);
  a163=(a163/a014);
  a014=(a179<=a136);
  a136=(a136<=a179);
  a154=(a136+a014);
  a014=(a014/a154);
  a203=(a203*a124);
  a177=cos(a177);
  a205=(a205*a164);
  a151=(a151*a153);
  a164=(a180<=a188);
  a188=(a188<=a180);
  a180=(a164+a188);
  a164=(a164/a180);
  a164=(a164*a193);
  a188=(a188/a180);
  a180=(a197<=a198);
  a198=(a198<=a197);
  a124=(a180+a198);
  a180=(a180/a124);
  a189=(a017<=a207);
  a207=(a207<=a017);
  a207=(a207+a189);
  a189=(a189/a207);
  a048=(a212*a048);
  a213=(a213*a167);
  a048=(a048-a213);
  a128=(a128+a048);
  a189=(a189*a128);
  a189=(a173*a189);
  a128=(a148/a185);
  a173=(a173/a185);
  a200=(2.*a200);
  a200=(a200*a192);
  a200=(a200+a184);
  a185=(2.*a185);
  a185=(a200/a185);
  a173=(a173*a185);
  a128=(a128-a173);
  a170=(a170*a128);
  a189=(a189+a170);
  a189=(a189/a186);
  a197=(a197/a186);
  a197=(a197*a175);
  a189=(a189-a197);
  a180=(a180*a189);
  a198=(a198/a124);
  a198=(a198*a193);
  a180=(a180-a198);
  a188=(a188*a180);
  a164=(a164+a188);
  a007=(a007*a164);
  a188=(a144*a201);
  a007=(a007-a188);
  a134=(a134*a201);
  a144=(a144*a153);
  a164=(a206*a164);
  a144=(a144+a164);
  a199=casadi_sq(a199);
  a199=(a008+a199);
  a144=(a144/a199);
  a149=(a149*a144);
  a134=(a134+a149);
  a134=(a134/a206);
  a204=(a204/a206);
  a204=(a204*a153);
  a134=(a134-a204);
  a007=(a007+a134);
  a206=(a206*a007);
  a151=(a151+a206);
  a190=casadi_sq(a190);
  a190=(a008+a190);
  a151=(a151/a190);
  a196=(a196*a151);
  a205=(a205+a196);
  a177=(a177*a205);
  a183=(a183*a177);
  a203=(a203+a183);
  a203=(a161*a203);
  a187=(2.*a187);
  a187=(a187*a148);
  a187=(a187+a200);
  a161=(2.*a161);
  a187=(a187/a161);
  a172=(a172*a187);
  a203=(a203+a172);
  a203=(a203/a140);
  a179=(a179/a140);
  a179=(a179*a202);
  a203=(a203-a179);
  a014=(a014*a203);
  a136=(a136/a154);
  a136=(a136*a113);
  a014=(a014-a136);
  a163=(a163*a014);
  a162=(a162+a163);
  a163=(a156*a191);
  a165=casadi_fmax(a165,a208);
  a208=(a158*a165);
  a163=(a163-a208);
  a163=(a163+a021);
  a208=casadi_fmax(a017,a163);
  a014=casadi_sq(a208);
  a136=(a208*a014);
  a136=(a155*a136);
  a154=(a017<=a163);
  a163=(a163<=a017);
  a163=(a163+a154);
  a154=(a154/a163);
  a163=(a156*a113);
  a203=(a158*a162);
  a163=(a163+a203);
  a154=(a154*a163);
  a163=(a021*a154);
  a163=(a136*a163);
  a203=(a021*a208);
  a203=(a008-a203);
  a014=(a014*a154);
  a179=(2.*a208);
  a179=(a179*a154);
  a208=(a208*a179);
  a014=(a014+a208);
  a014=(a155*a014);
  a014=(a203*a014);
  a163=(a163-a014);
  a163=(a162+a163);
  a191=(a156*a191);
  a014=(a158*a165);
  a191=(a191+a014);
  a191=(a191+a021);
  a014=casadi_fmax(a017,a191);
  a208=(a021*a014);
  a208=(a008-a208);
  a179=casadi_sq(a014);
  a154=(a017<=a191);
  a191=(a191<=a017);
  a191=(a191+a154);
  a154=(a154/a191);
  a158=(a158*a162);
  a156=(a156*a113);
  a158=(a158-a156);
  a154=(a154*a158);
  a158=(a179*a154);
  a156=(2.*a014);
  a156=(a156*a154);
  a156=(a014*a156);
  a158=(a158+a156);
  a158=(a155*a158);
  a158=(a208*a158);
  a014=(a014*a179);
  a155=(a155*a014);
  a154=(a021*a154);
  a154=(a155*a154);
  a158=(a158-a154);
  a163=(a163-a158);
  a163=(a212*a163);
  a136=(a136*a203);
  a165=(a165+a136);
  a155=(a155*a208);
  a165=(a165-a155);
  a167=(a165*a167);
  a163=(a163-a167);
  a163=(a186*a163);
  a212=(a212*a165);
  a175=(a212*a175);
  a163=(a163+a175);
  a175=(a119*a163);
  a212=(a212*a186);
  a186=cos(a068);
  a186=(a186*a110);
  a186=(a212*a186);
  a175=(a175+a186);
  a178=(a178+a175);
  a006=(a006-a178);
  a175=arg[6]? arg[6][23] : 0;
  a186=arg[2]? arg[2][24] : 0;
  a165=(2.*a087);
  a165=(a165*a086);
  a165=(a186*a165);
  a087=casadi_sq(a087);
  a086=arg[6]? arg[6][24] : 0;
  a086=(a087*a086);
  a165=(a165+a086);
  a175=(a175+a165);
  a175=(a101*a175);
  a165=arg[2]? arg[2][23] : 0;
  a087=(a087*a186);
  a165=(a165+a087);
  a087=(a165*a085);
  a175=(a175+a087);
  a175=(a093*a175);
  a165=(a165*a101);
  a081=(a165*a081);
  a175=(a175+a081);
  a175=(a175/a104);
  a165=(a165*a093);
  a165=(a165/a104);
  a093=(a165/a104);
  a093=(a093*a088);
  a175=(a175-a093);
  a006=(a006-a175);
  a006=(a006/a019);
  a012=(a209*a012);
  a009=(a132*a009);
  a012=(a012-a009);
  a012=(a012+a044);
  a133=(a125*a133);
  a195=(a139*a195);
  a133=(a133-a195);
  a012=(a012-a133);
  a211=(a182*a211);
  a119=(a212*a119);
  a211=(a211+a119);
  a012=(a012-a211);
  a012=(a012-a165);
  a012=(a012/a019);
  a012=(a012/a019);
  a012=(a012*a216);
  a006=(a006-a012);
  a002=(a002+a006);
  if (res[0]!=0) res[0][0]=a002;
  a002=arg[5]? arg[5][10] : 0;
  a036=(a032-a036);
  a006=casadi_sq(a036);
  a006=(a006+a041);
  a006=sqrt(a006);
  a041=(a036*a006);
  a012=(a021*a041);
  a012=(a012+a050);
  a050=(2.*a050);
  a041=(a041+a050);
  a050=casadi_sq(a041);
  a050=(a050+a052);
  a050=sqrt(a050);
  a052=(a021*a050);
  a012=(a012+a052);
  a052=arg[2]? arg[2][69] : 0;
  a165=sin(a031);
  a119=(a052*a165);
  a195=arg[2]? arg[2][68] : 0;
  a044=cos(a031);
  a009=(a195*a044);
  a119=(a119-a009);
  a175=(a003*a119);
  a175=(a175+a000);
  a175=(a175-a096);
  a096=casadi_sq(a175);
  a096=(a012+a096);
  a093=arg[2]? arg[2][74] : 0;
  a081=arg[2]? arg[2][70] : 0;
  a023=(a081+a023);
  a087=(-a023);
  a186=arg[2]? arg[2][71] : 0;
  a086=sqrt(a012);
  a167=atan2(a175,a086);
  a155=arg[1]? arg[1][8] : 0;
  a208=arg[2]? arg[2][56] : 0;
  a136=(a005*a208);
  a155=(a155-a136);
  a136=arg[2]? arg[2][72] : 0;
  a203=(a155*a136);
  a167=(a167-a203);
  a203=(a186*a167);
  a158=casadi_fmin(a023,a203);
  a154=casadi_fmax(a087,a158);
  a014=(a058*a081);
  a179=(a060*a154);
  a014=(a014-a179);
  a014=(a014+a021);
  a179=casadi_fmax(a017,a014);
  a156=casadi_sq(a179);
  a113=(a179*a156);
  a113=(a057*a113);
  a162=(a021*a179);
  a162=(a008-a162);
  a191=(a113*a162);
  a191=(a154+a191);
  a081=(a058*a081);
  a154=(a060*a154);
  a081=(a081+a154);
  a081=(a081+a021);
  a154=casadi_fmax(a017,a081);
  a202=casadi_sq(a154);
  a140=(a154*a202);
  a140=(a057*a140);
  a172=(a021*a154);
  a008=(a008-a172);
  a172=(a140*a008);
  a191=(a191-a172);
  a172=arg[6]? arg[6][73] : 0;
  a172=(a021*a172);
  a172=(a191*a172);
  a187=arg[2]? arg[2][73] : 0;
  a187=(a021*a187);
  a161=(a087<=a158);
  a158=(a158<=a087);
  a087=(a158+a161);
  a161=(a161/a087);
  a200=(a023<=a203);
  a203=(a203<=a023);
  a023=(a200+a203);
  a200=(a200/a023);
  a148=arg[6]? arg[6][70] : 0;
  a200=(a200*a148);
  a203=(a203/a023);
  a023=arg[6]? arg[6][71] : 0;
  a167=(a167*a023);
  a023=casadi_sq(a175);
  a023=(a023+a012);
  a012=(a086/a023);
  a183=(a119*a001);
  a177=arg[6]? arg[6][69] : 0;
  a165=(a165*a177);
  a177=cos(a031);
  a177=(a177*a219);
  a052=(a052*a177);
  a165=(a165+a052);
  a052=arg[6]? arg[6][68] : 0;
  a044=(a044*a052);
  a031=sin(a031);
  a031=(a031*a219);
  a195=(a195*a031);
  a044=(a044-a195);
  a165=(a165-a044);
  a195=(a003*a165);
  a183=(a183+a195);
  a183=(a183+a004);
  a183=(a183-a095);
  a012=(a012*a183);
  a023=(a175/a023);
  a035=(a072-a035);
  a095=(a006*a035);
  a195=(2.*a036);
  a195=(a195*a035);
  a006=(2.*a006);
  a195=(a195/a006);
  a036=(a036*a195);
  a095=(a095+a036);
  a036=(a021*a095);
  a036=(a036+a040);
  a041=(2.*a041);
  a040=(2.*a040);
  a095=(a095+a040);
  a041=(a041*a095);
  a050=(2.*a050);
  a041=(a041/a050);
  a041=(a021*a041);
  a036=(a036+a041);
  a086=(2.*a086);
  a086=(a036/a086);
  a023=(a023*a086);
  a012=(a012-a023);
  a023=arg[5]? arg[5][8] : 0;
  a208=(a208*a135);
  a135=arg[6]? arg[6][56] : 0;
  a005=(a005*a135);
  a208=(a208+a005);
  a023=(a023-a208);
  a136=(a136*a023);
  a208=arg[6]? arg[6][72] : 0;
  a208=(a155*a208);
  a136=(a136+a208);
  a012=(a012-a136);
  a186=(a186*a012);
  a167=(a167+a186);
  a203=(a203*a167);
  a200=(a200+a203);
  a161=(a161*a200);
  a158=(a158/a087);
  a158=(a158*a148);
  a161=(a161-a158);
  a158=(a017<=a014);
  a014=(a014<=a017);
  a014=(a014+a158);
  a158=(a158/a014);
  a014=(a058*a148);
  a087=(a060*a161);
  a014=(a014-a087);
  a158=(a158*a014);
  a156=(a156*a158);
  a014=(2.*a179);
  a014=(a014*a158);
  a179=(a179*a014);
  a156=(a156+a179);
  a156=(a057*a156);
  a162=(a162*a156);
  a158=(a021*a158);
  a113=(a113*a158);
  a162=(a162-a113);
  a162=(a161+a162);
  a113=(a017<=a081);
  a081=(a081<=a017);
  a081=(a081+a113);
  a113=(a113/a081);
  a058=(a058*a148);
  a060=(a060*a161);
  a058=(a058+a060);
  a113=(a113*a058);
  a202=(a202*a113);
  a058=(2.*a154);
  a058=(a058*a113);
  a154=(a154*a058);
  a202=(a202+a154);
  a057=(a057*a202);
  a008=(a008*a057);
  a113=(a021*a113);
  a140=(a140*a113);
  a008=(a008-a140);
  a162=(a162-a008);
  a162=(a187*a162);
  a172=(a172+a162);
  a172=(a093*a172);
  a187=(a187*a191);
  a191=arg[6]? arg[6][74] : 0;
  a191=(a187*a191);
  a172=(a172+a191);
  a172=(a046*a172);
  a187=(a187*a093);
  a093=(a187*a065);
  a172=(a172+a093);
  a172=(a096*a172);
  a187=(a187*a046);
  a175=(2.*a175);
  a175=(a175*a183);
  a036=(a036+a175);
  a036=(a187*a036);
  a172=(a172+a036);
  a036=(a002-a172);
  a175=sin(a068);
  a183=(a175*a176);
  a093=cos(a068);
  a093=(a093*a110);
  a093=(a182*a093);
  a183=(a183+a093);
  a036=(a036+a183);
  a183=2.5000000000000000e-01;
  a091=(a183*a091);
  a099=sqrt(a099);
  a093=(a091*a099);
  a191=(a093*a003);
  a162=(a191*a046);
  a008=arg[2]? arg[2][60] : 0;
  a140=arg[6]? arg[6][58] : 0;
  a140=(a008*a140);
  a113=arg[2]? arg[2][58] : 0;
  a057=arg[6]? arg[6][60] : 0;
  a202=(a113*a057);
  a140=(a140+a202);
  a140=(a162*a140);
  a113=(a113*a008);
  a183=(a183*a089);
  a183=(a099*a183);
  a099=(2.*a099);
  a042=(a042/a099);
  a091=(a091*a042);
  a183=(a183+a091);
  a183=(a003*a183);
  a093=(a093*a001);
  a183=(a183+a093);
  a046=(a046*a183);
  a191=(a191*a065);
  a046=(a046+a191);
  a191=(a113*a046);
  a140=(a140+a191);
  a191=arg[2]? arg[2][57] : 0;
  a065=atan2(a098,a104);
  a183=(a191*a065);
  a093=arg[2]? arg[2][59] : 0;
  a091=(a093*a155);
  a183=(a183+a091);
  a091=(a183*a085);
  a042=arg[6]? arg[6][57] : 0;
  a042=(a065*a042);
  a099=casadi_sq(a098);
  a099=(a099+a094);
  a104=(a104/a099);
  a104=(a104*a097);
  a098=(a098/a099);
  a098=(a098*a088);
  a104=(a104-a098);
  a191=(a191*a104);
  a042=(a042+a191);
  a191=arg[6]? arg[6][59] : 0;
  a191=(a155*a191);
  a093=(a093*a023);
  a191=(a191+a093);
  a042=(a042+a191);
  a042=(a101*a042);
  a091=(a091+a042);
  a140=(a140+a091);
  a036=(a036+a140);
  a140=cos(a068);
  a163=(a140*a163);
  a091=sin(a068);
  a091=(a091*a110);
  a091=(a212*a091);
  a163=(a163-a091);
  a036=(a036-a163);
  a091=sin(a068);
  a210=(a091*a210);
  a042=cos(a068);
  a042=(a042*a110);
  a042=(a125*a042);
  a210=(a210+a042);
  a042=cos(a068);
  a181=(a042*a181);
  a191=sin(a068);
  a191=(a191*a110);
  a191=(a139*a191);
  a181=(a181-a191);
  a210=(a210+a181);
  a036=(a036-a210);
  a181=sin(a011);
  a214=(a181*a214);
  a191=cos(a011);
  a191=(a191*a010);
  a191=(a132*a191);
  a214=(a214+a191);
  a191=cos(a011);
  a090=(a191*a090);
  a011=sin(a011);
  a011=(a011*a010);
  a011=(a209*a011);
  a090=(a090-a011);
  a214=(a214+a090);
  a036=(a036-a214);
  a036=(a036/a019);
  a090=arg[1]? arg[1][10] : 0;
  a187=(a187*a096);
  a096=(a090-a187);
  a175=(a182*a175);
  a096=(a096+a175);
  a113=(a113*a162);
  a183=(a101*a183);
  a113=(a113+a183);
  a096=(a096+a113);
  a212=(a212*a140);
  a096=(a096-a212);
  a125=(a125*a091);
  a139=(a139*a042);
  a125=(a125+a139);
  a096=(a096-a125);
  a132=(a132*a181);
  a209=(a209*a191);
  a132=(a132+a209);
  a096=(a096-a132);
  a096=(a096/a019);
  a096=(a096/a019);
  a096=(a096*a216);
  a036=(a036-a096);
  a096=(a032*a001);
  a003=(a003*a072);
  a096=(a096+a003);
  a036=(a036-a096);
  if (res[0]!=0) res[0][1]=a036;
  a036=casadi_sq(a008);
  a096=arg[6]? arg[6][66] : 0;
  a096=(a036*a096);
  a003=arg[2]? arg[2][66] : 0;
  a216=(2.*a008);
  a216=(a216*a057);
  a216=(a003*a216);
  a096=(a096+a216);
  a096=(a162*a096);
  a003=(a003*a036);
  a046=(a003*a046);
  a096=(a096+a046);
  a046=arg[2]? arg[2][64] : 0;
  a036=arg[1]? arg[1][9] : 0;
  a216=(a046*a036);
  a019=arg[2]? arg[2][65] : 0;
  a209=(a019*a065);
  a216=(a216+a209);
  a209=arg[2]? arg[2][67] : 0;
  a191=(a209*a155);
  a216=(a216+a191);
  a057=(a101*a057);
  a085=(a008*a085);
  a057=(a057+a085);
  a057=(a216*a057);
  a008=(a008*a101);
  a101=arg[6]? arg[6][64] : 0;
  a036=(a036*a101);
  a101=arg[5]? arg[5][9] : 0;
  a046=(a046*a101);
  a036=(a036+a046);
  a046=arg[6]? arg[6][65] : 0;
  a065=(a065*a046);
  a019=(a019*a104);
  a065=(a065+a019);
  a036=(a036+a065);
  a065=arg[6]? arg[6][67] : 0;
  a155=(a155*a065);
  a209=(a209*a023);
  a155=(a155+a209);
  a036=(a036+a155);
  a036=(a008*a036);
  a057=(a057+a036);
  a096=(a096+a057);
  a172=(a119*a172);
  a165=(a187*a165);
  a172=(a172+a165);
  a002=(a009*a002);
  a044=(a090*a044);
  a002=(a002+a044);
  a172=(a172+a002);
  a096=(a096-a172);
  a172=(a021*a166);
  a172=(a133*a172);
  a002=(a021*a168);
  a194=(a002*a194);
  a172=(a172+a194);
  a096=(a096-a172);
  a166=(a021*a166);
  a166=(a211*a166);
  a021=(a021*a168);
  a178=(a021*a178);
  a166=(a166+a178);
  a096=(a096+a166);
  a210=(a107*a210);
  a166=(a125*a106);
  a210=(a210+a166);
  a096=(a096-a210);
  a127=(a127+a130);
  a214=(a127*a214);
  a126=(a126+a129);
  a126=(a132*a126);
  a214=(a214+a126);
  a096=(a096-a214);
  a214=sin(a068);
  a126=(a182*a214);
  a126=(a126-a212);
  a106=(a126*a106);
  a214=(a214*a176);
  a068=cos(a068);
  a068=(a068*a110);
  a182=(a182*a068);
  a214=(a214+a182);
  a214=(a214-a163);
  a214=(a107*a214);
  a106=(a106+a214);
  a096=(a096+a106);
  a106=arg[2]? arg[2][78] : 0;
  a096=(a096/a106);
  a003=(a003*a162);
  a008=(a008*a216);
  a003=(a003+a008);
  a187=(a187*a119);
  a090=(a090*a009);
  a187=(a187+a090);
  a003=(a003-a187);
  a002=(a002*a133);
  a003=(a003-a002);
  a021=(a021*a211);
  a003=(a003+a021);
  a125=(a125*a107);
  a003=(a003-a125);
  a132=(a132*a127);
  a003=(a003-a132);
  a107=(a107*a126);
  a003=(a003+a107);
  a003=(a003/a106);
  a003=(a003/a106);
  a106=arg[6]? arg[6][78] : 0;
  a003=(a003*a106);
  a096=(a096-a003);
  if (res[0]!=0) res[0][2]=a096;
  a096=cos(a034);
  a096=(a096*a072);
  a003=sin(a034);
  a003=(a003*a070);
  a003=(a032*a003);
  a096=(a096-a003);
  a003=sin(a034);
  a003=(a003*a004);
  a106=cos(a034);
  a106=(a106*a070);
  a106=(a000*a106);
  a003=(a003+a106);
  a096=(a096-a003);
  if (res[0]!=0) res[0][3]=a096;
  a096=sin(a034);
  a096=(a096*a072);
  a072=cos(a034);
  a072=(a072*a070);
  a032=(a032*a072);
  a096=(a096+a032);
  a032=cos(a034);
  a032=(a032*a004);
  a034=sin(a034);
  a034=(a034*a070);
  a000=(a000*a034);
  a032=(a032-a000);
  a096=(a096+a032);
  if (res[0]!=0) res[0][4]=a096;
  if (res[0]!=0) res[0][5]=a001;
  return 0;
}

CASADI_SYMBOL_EXPORT int fwd1_rollout_rhs(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f1(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int fwd1_rollout_rhs_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void fwd1_rollout_rhs_release(int mem) {
}

CASADI_SYMBOL_EXPORT void fwd1_rollout_rhs_incref(void) {
}

CASADI_SYMBOL_EXPORT void fwd1_rollout_rhs_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int fwd1_rollout_rhs_n_in(void) { return 7;}

CASADI_SYMBOL_EXPORT casadi_int fwd1_rollout_rhs_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real fwd1_rollout_rhs_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* fwd1_rollout_rhs_name_in(casadi_int i) {
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

CASADI_SYMBOL_EXPORT const char* fwd1_rollout_rhs_name_out(casadi_int i) {
  switch (i) {
    case 0: return "fwd_xdot";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* fwd1_rollout_rhs_sparsity_in(casadi_int i) {
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

CASADI_SYMBOL_EXPORT const casadi_int* fwd1_rollout_rhs_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int fwd1_rollout_rhs_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 7;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int fwd1_rollout_rhs_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 7*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* adj1_rollout_rhs:(x[6],u[11],p[79],out_xdot[6x1,0nz],adj_xdot[6])->(adj_x[6],adj_u[11],adj_p[79]) */
static int casadi_f2(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
  casadi_real a204, a205, a206, a207, a208, a209, a210, a211, a212, a213, a214, a215;
  casadi_real a216, a217, a218, a219, a220, a221, a222, a223, a224, a225, a226, a227;
  casadi_real a228, a229, a230, a231, a232, a233, a234, a235, a236, a237, a238, a239;
  casadi_real a240, a241, a242, a243, a244, a245, a246, a247, a248, a249, a250, a251;
  casadi_real a252, a253, a254, a255, a256, a257, a258, a259, a260, a261, a262, a263;
  casadi_real a264, a265, a266, a267, a268, a269, a270, a271, a272, a273, a274, a275;
  casadi_real a276, a277, a278, a279, a280, a281, a282, a283, a284, a285, a286, a287;
  casadi_real a288, a289, a290, a291, a292, a293, a294, a295, a296, a297, a298, a299;
  casadi_real a300, a301, a302, a303, a304, a305, a306, a307, a308, a309, a310, a311;
  casadi_real a312, a313, a314, a315, a316, a317, a318, a319, a320, a321, a322, a323;
  casadi_real a324, a325, a326, a327, a328, a329, a330, a331, a332, a333, a334, a335;
  casadi_real a336, a337, a338, a339, a340, a341, a342, a343, a344, a345, a346, a347;
  casadi_real a348, a349, a350, a351, a352, a353, a354, a355, a356, a357, a358, a359;
  casadi_real a360, a361, a362, a363, a364, a365, a366, a367, a368, a369, a370, a371;
  casadi_real a372, a373, a374, a375, a376, a377, a378, a379, a380, a381, a382, a383;
  casadi_real a384, a385, a386, a387, a388, a389, a390, a391, a392, a393, a394, a395;
  casadi_real a396, a397, a398, a399, a400, a401, a402, a403, a404, a405, a406, a407;
  casadi_real a408;
  a000=arg[0]? arg[0][5] : 0;
  a001=sin(a000);
  a002=arg[4]? arg[4][4] : 0;
  a001=(a001*a002);
  a003=cos(a000);
  a004=arg[4]? arg[4][3] : 0;
  a003=(a003*a004);
  a001=(a001+a003);
  a003=arg[0]? arg[0][2] : 0;
  a005=arg[4]? arg[4][1] : 0;
  a006=(a003*a005);
  a001=(a001-a006);
  a006=arg[0]? arg[0][0] : 0;
  a007=arg[1]? arg[1][0] : 0;
  a008=cos(a000);
  a009=(a007*a008);
  a010=arg[1]? arg[1][1] : 0;
  a011=sin(a000);
  a012=(a010*a011);
  a009=(a009+a012);
  a012=(a006-a009);
  a013=casadi_sq(a012);
  a014=1.0000000000000000e-04;
  a013=(a013+a014);
  a013=sqrt(a013);
  a015=(a012*a013);
  a016=arg[1]? arg[1][2] : 0;
  a017=arg[2]? arg[2][6] : 0;
  a018=arg[2]? arg[2][7] : 0;
  a019=casadi_sq(a018);
  a020=9.9999999999999998e-13;
  a019=(a019+a020);
  a019=sqrt(a019);
  a021=(a017*a019);
  a022=(a016/a021);
  a023=(2.*a022);
  a023=(a015+a023);
  a024=(2.*a023);
  a025=5.0000000000000000e-01;
  a026=arg[2]? arg[2][73] : 0;
  a026=(a025*a026);
  a027=arg[2]? arg[2][70] : 0;
  a028=1.0000000000000001e-01;
  a029=(a027+a028);
  a030=(-a029);
  a031=arg[2]? arg[2][71] : 0;
  a032=arg[2]? arg[2][69] : 0;
  a033=arg[2]? arg[2][1] : 0;
  a034=sin(a033);
  a035=(a032*a034);
  a036=arg[2]? arg[2][68] : 0;
  a037=cos(a033);
  a038=(a036*a037);
  a035=(a035-a038);
  a039=(a003*a035);
  a040=arg[0]? arg[0][1] : 0;
  a039=(a039+a040);
  a041=cos(a000);
  a042=(a010*a041);
  a043=sin(a000);
  a044=(a007*a043);
  a042=(a042-a044);
  a039=(a039-a042);
  a015=(a025*a015);
  a015=(a015+a022);
  a023=casadi_sq(a023);
  a044=1.0000000000000000e-08;
  a023=(a023+a044);
  a023=sqrt(a023);
  a045=(a025*a023);
  a015=(a015+a045);
  a045=sqrt(a015);
  a046=atan2(a039,a045);
  a047=arg[1]? arg[1][8] : 0;
  a048=arg[1]? arg[1][6] : 0;
  a049=arg[2]? arg[2][56] : 0;
  a050=(a048*a049);
  a047=(a047-a050);
  a050=arg[2]? arg[2][72] : 0;
  a051=(a047*a050);
  a046=(a046-a051);
  a051=(a031*a046);
  a052=casadi_fmin(a029,a051);
  a053=casadi_fmax(a030,a052);
  a054=2.0000000000000001e-01;
  a055=0.;
  a056=-5.;
  a057=(a056*a027);
  a058=5.;
  a059=(a058*a053);
  a057=(a057-a059);
  a057=(a057+a025);
  a059=casadi_fmax(a055,a057);
  a060=casadi_sq(a059);
  a061=(a059*a060);
  a061=(a054*a061);
  a062=1.;
  a063=(a025*a059);
  a063=(a062-a063);
  a064=(a061*a063);
  a064=(a053+a064);
  a027=(a056*a027);
  a053=(a058*a053);
  a027=(a027+a053);
  a027=(a027+a025);
  a053=casadi_fmax(a055,a027);
  a065=casadi_sq(a053);
  a066=(a053*a065);
  a066=(a054*a066);
  a067=(a025*a053);
  a067=(a062-a067);
  a068=(a066*a067);
  a064=(a064-a068);
  a068=(a026*a064);
  a069=arg[2]? arg[2][74] : 0;
  a070=(a068*a069);
  a071=(a070*a018);
  a072=arg[4]? arg[4][2] : 0;
  a073=arg[2]? arg[2][78] : 0;
  a074=(a072/a073);
  a075=(a035*a074);
  a076=arg[2]? arg[2][27] : 0;
  a077=(a005/a076);
  a075=(a075+a077);
  a078=(a071*a075);
  a079=casadi_sq(a039);
  a079=(a079+a015);
  a080=(a039/a079);
  a081=(a051<=a029);
  a029=(a029<=a051);
  a051=(a029+a081);
  a081=(a081/a051);
  a082=(a030<=a052);
  a052=(a052<=a030);
  a030=(a052+a082);
  a082=(a082/a030);
  a083=(a055<=a027);
  a027=(a027<=a055);
  a027=(a027+a083);
  a083=(a083/a027);
  a027=casadi_sq(a039);
  a015=(a015+a027);
  a075=(a015*a075);
  a027=(a018*a075);
  a069=(a069*a027);
  a026=(a026*a069);
  a067=(a067*a026);
  a067=(a054*a067);
  a065=(a065*a067);
  a066=(a066*a026);
  a066=(a025*a066);
  a065=(a065-a066);
  a066=(2.*a053);
  a053=(a053*a067);
  a066=(a066*a053);
  a065=(a065+a066);
  a083=(a083*a065);
  a065=(a058*a083);
  a065=(a065-a026);
  a066=(a055<=a057);
  a057=(a057<=a055);
  a057=(a057+a066);
  a066=(a066/a057);
  a061=(a061*a026);
  a061=(a025*a061);
  a063=(a063*a026);
  a063=(a054*a063);
  a060=(a060*a063);
  a061=(a061-a060);
  a060=(2.*a059);
  a059=(a059*a063);
  a060=(a060*a059);
  a061=(a061-a060);
  a066=(a066*a061);
  a061=(a058*a066);
  a065=(a065-a061);
  a082=(a082*a065);
  a081=(a081*a082);
  a031=(a031*a081);
  a080=(a080*a031);
  a061=(2.*a045);
  a080=(a080/a061);
  a080=(a078+a080);
  a061=(a025*a080);
  a023=(2.*a023);
  a061=(a061/a023);
  a024=(a024*a061);
  a061=(a025*a080);
  a061=(a024+a061);
  a023=(a013*a061);
  a060=(2.*a012);
  a012=(a012*a061);
  a013=(2.*a013);
  a012=(a012/a013);
  a060=(a060*a012);
  a023=(a023+a060);
  a001=(a001-a023);
  a060=arg[2]? arg[2][2] : 0;
  a012=sin(a060);
  a013=arg[2]? arg[2][0] : 0;
  a061=cos(a033);
  a059=(a013*a061);
  a063=arg[2]? arg[2][4] : 0;
  a026=sin(a033);
  a057=(a063*a026);
  a059=(a059+a057);
  a057=(a003*a059);
  a057=(a057+a040);
  a053=cos(a060);
  a067=(a057*a053);
  a084=(a025*a003);
  a085=arg[2]? arg[2][3] : 0;
  a086=(a084*a085);
  a087=(a006-a086);
  a088=(a087*a012);
  a067=(a067+a088);
  a088=(2.*a067);
  a089=arg[2]? arg[2][40] : 0;
  a090=arg[2]? arg[2][39] : 0;
  a091=arg[2]? arg[2][37] : 0;
  a092=arg[2]? arg[2][38] : 0;
  a093=(a092-a062);
  a094=casadi_fmax(a020,a093);
  a094=sqrt(a094);
  a095=(a091*a094);
  a096=(1./a095);
  a097=(-a096);
  a098=arg[2]? arg[2][32] : 0;
  a099=arg[2]? arg[2][33] : 0;
  a100=arg[2]? arg[2][26] : 0;
  a101=(a100*a076);
  a102=arg[2]? arg[2][12] : 0;
  a103=(a102+a028);
  a104=(-a103);
  a105=arg[2]? arg[2][11] : 0;
  a106=arg[1]? arg[1][3] : 0;
  a107=arg[2]? arg[2][10] : 0;
  a108=(a106*a107);
  a109=arg[2]? arg[2][9] : 0;
  a108=(a108+a109);
  a109=arg[2]? arg[2][8] : 0;
  a109=(a062-a109);
  a110=(a006-a009);
  a111=casadi_sq(a110);
  a111=(a111+a014);
  a111=sqrt(a111);
  a014=(a110*a111);
  a112=(a025*a014);
  a112=(a112+a022);
  a113=(2.*a022);
  a014=(a014+a113);
  a113=casadi_sq(a014);
  a113=(a113+a044);
  a113=sqrt(a113);
  a114=(a025*a113);
  a112=(a112+a114);
  a114=sqrt(a112);
  a114=atan2(a055,a114);
  a114=(a033+a114);
  a115=(a109*a114);
  a108=(a108+a115);
  a115=(a105*a108);
  a116=casadi_fmin(a103,a115);
  a117=casadi_fmax(a104,a116);
  a118=(a056*a102);
  a119=(a058*a117);
  a118=(a118-a119);
  a118=(a118+a025);
  a119=casadi_fmax(a055,a118);
  a120=casadi_sq(a119);
  a121=(a119*a120);
  a121=(a054*a121);
  a122=(a025*a119);
  a122=(a062-a122);
  a123=(a121*a122);
  a123=(a117+a123);
  a102=(a056*a102);
  a117=(a058*a117);
  a102=(a102+a117);
  a102=(a102+a025);
  a117=casadi_fmax(a055,a102);
  a124=casadi_sq(a117);
  a125=(a117*a124);
  a125=(a054*a125);
  a126=(a025*a117);
  a126=(a062-a126);
  a127=(a125*a126);
  a123=(a123-a127);
  a123=(a025*a123);
  a127=arg[2]? arg[2][13] : 0;
  a128=(a123*a127);
  a129=(a128*a018);
  a130=arg[2]? arg[2][14] : 0;
  a131=(a129*a130);
  a132=(a131*a112);
  a101=(a101-a132);
  a133=arg[2]? arg[2][22] : 0;
  a028=(a133+a028);
  a134=(-a028);
  a135=arg[2]? arg[2][20] : 0;
  a136=arg[2]? arg[2][21] : 0;
  a137=(a136*a033);
  a135=(a135+a137);
  a137=casadi_fmin(a028,a135);
  a138=casadi_fmax(a134,a137);
  a139=(a056*a133);
  a140=(a058*a138);
  a139=(a139-a140);
  a139=(a139+a025);
  a140=casadi_fmax(a055,a139);
  a141=casadi_sq(a140);
  a142=(a140*a141);
  a142=(a054*a142);
  a143=(a025*a140);
  a143=(a062-a143);
  a144=(a142*a143);
  a144=(a138+a144);
  a133=(a056*a133);
  a138=(a058*a138);
  a133=(a133+a138);
  a133=(a133+a025);
  a138=casadi_fmax(a055,a133);
  a145=casadi_sq(a138);
  a146=(a138*a145);
  a146=(a054*a146);
  a147=(a025*a138);
  a147=(a062-a147);
  a148=(a146*a147);
  a144=(a144-a148);
  a148=arg[2]? arg[2][15] : 0;
  a149=(a025*a148);
  a009=(a006-a009);
  a150=casadi_sq(a009);
  a150=(a150+a044);
  a042=(a040-a042);
  a044=casadi_sq(a042);
  a044=(a150+a044);
  a151=(a149*a044);
  a152=(a151*a018);
  a153=(a144*a152);
  a154=(a153*a009);
  a155=sqrt(a150);
  a154=(a154/a155);
  a101=(a101-a154);
  a156=arg[2]? arg[2][25] : 0;
  a157=cos(a033);
  a158=(a156*a157);
  a159=arg[2]? arg[2][30] : 0;
  a160=sin(a033);
  a161=(a159*a160);
  a162=(a158+a161);
  a163=(a101*a162);
  a164=arg[2]? arg[2][28] : 0;
  a165=cos(a033);
  a166=(a164*a165);
  a167=arg[2]? arg[2][29] : 0;
  a168=sin(a033);
  a169=(a167*a168);
  a166=(a166+a169);
  a169=(a132*a166);
  a170=arg[2]? arg[2][19] : 0;
  a171=(a170*a152);
  a172=arg[2]? arg[2][16] : 0;
  a173=arg[2]? arg[2][17] : 0;
  a174=(a173*a033);
  a172=(a172+a174);
  a174=arg[2]? arg[2][18] : 0;
  a175=(a174*a106);
  a172=(a172+a175);
  a175=(a171*a172);
  a169=(a169+a175);
  a175=arg[2]? arg[2][31] : 0;
  a176=(a016*a175);
  a177=cos(a033);
  a178=(a176*a177);
  a169=(a169+a178);
  a163=(a163+a169);
  a163=(a025*a163);
  a178=(a158+a161);
  a178=(a059-a178);
  a163=(a163/a178);
  a179=(-a163);
  a180=casadi_fmax(a055,a179);
  a181=(a099*a180);
  a181=(a098+a181);
  a182=casadi_fmax(a055,a181);
  a183=(a006-a086);
  a184=cos(a060);
  a185=(a183*a184);
  a186=sin(a060);
  a187=(a057*a186);
  a185=(a185-a187);
  a188=casadi_sq(a185);
  a189=9.9999999999999995e-07;
  a190=arg[2]? arg[2][5] : 0;
  a191=casadi_sq(a190);
  a191=(a189*a191);
  a188=(a188+a191);
  a192=sqrt(a188);
  a193=(a067/a192);
  a194=(a182*a193);
  a195=arg[2]? arg[2][42] : 0;
  a196=1.0000000000000000e-03;
  a197=arg[2]? arg[2][34] : 0;
  a198=arg[2]? arg[2][35] : 0;
  a199=(a198*a180);
  a199=(a197+a199);
  a200=casadi_fmax(a196,a199);
  a201=(a195*a200);
  a194=(a194/a201);
  a202=casadi_fmin(a194,a096);
  a203=casadi_fmax(a097,a202);
  a204=(a062-a092);
  a205=(a203*a204);
  a206=(a091*a203);
  a207=atan(a206);
  a208=(a092*a207);
  a208=(a208/a091);
  a205=(a205+a208);
  a209=(a091*a205);
  a210=atan(a209);
  a211=(a090*a210);
  a212=sin(a211);
  a213=(a089*a212);
  a214=casadi_sq(a067);
  a214=(a214+a188);
  a214=sqrt(a214);
  a188=(a213*a214);
  a215=casadi_sq(a190);
  a216=casadi_sq(a215);
  a217=casadi_sq(a185);
  a218=casadi_sq(a067);
  a217=(a217+a218);
  a218=casadi_sq(a217);
  a216=(a216+a218);
  a216=sqrt(a216);
  a218=sqrt(a216);
  a188=(a188/a218);
  a219=arg[1]? arg[1][5] : 0;
  a220=arg[2]? arg[2][43] : 0;
  a221=(a201-a220);
  a222=(a219*a221);
  a222=(a222+a220);
  a222=(a222/a201);
  a220=5.0000000000000004e-06;
  a223=(a222+a220);
  a224=(-a223);
  a225=(a185/a218);
  a226=casadi_fmin(a223,a225);
  a227=casadi_fmax(a224,a226);
  a228=1.0000000000000001e-05;
  a229=-100000.;
  a230=(a229*a222);
  a231=100000.;
  a232=(a231*a227);
  a230=(a230-a232);
  a230=(a230+a025);
  a232=casadi_fmax(a055,a230);
  a233=casadi_sq(a232);
  a234=(a232*a233);
  a234=(a228*a234);
  a235=(a025*a232);
  a235=(a062-a235);
  a236=(a234*a235);
  a236=(a227+a236);
  a237=(a229*a222);
  a227=(a231*a227);
  a237=(a237+a227);
  a237=(a237+a025);
  a227=casadi_fmax(a055,a237);
  a238=casadi_sq(a227);
  a239=(a227*a238);
  a239=(a228*a239);
  a240=(a025*a227);
  a240=(a062-a240);
  a241=(a239*a240);
  a236=(a236-a241);
  a241=casadi_sq(a236);
  a241=(a062-a241);
  a241=sqrt(a241);
  a242=(a241+a220);
  a243=(a188<=a242);
  a244=(a242<=a188);
  a245=(a244+a243);
  a243=(a243/a245);
  a246=(-a242);
  a242=casadi_fmin(a242,a188);
  a247=(a246<=a242);
  a248=(a242<=a246);
  a249=(a248+a247);
  a247=(a247/a249);
  a250=(a229*a241);
  a246=casadi_fmax(a246,a242);
  a242=(a231*a246);
  a250=(a250+a242);
  a250=(a250+a025);
  a242=(a055<=a250);
  a251=(a250<=a055);
  a251=(a251+a242);
  a242=(a242/a251);
  a250=casadi_fmax(a055,a250);
  a251=casadi_sq(a250);
  a252=(a250*a251);
  a252=(a228*a252);
  a253=sin(a060);
  a254=(a025*a085);
  a255=(a254*a074);
  a256=arg[4]? arg[4][0] : 0;
  a257=(a256/a076);
  a255=(a255-a257);
  a258=(a253*a255);
  a259=cos(a060);
  a260=(a059*a074);
  a261=(a260+a077);
  a262=(a259*a261);
  a258=(a258-a262);
  a262=(a201*a258);
  a263=(a180*a262);
  a264=(a252*a263);
  a264=(a025*a264);
  a265=(a025*a250);
  a265=(a062-a265);
  a266=(a265*a263);
  a266=(a228*a266);
  a251=(a251*a266);
  a264=(a264-a251);
  a251=(2.*a250);
  a250=(a250*a266);
  a251=(a251*a250);
  a264=(a264-a251);
  a242=(a242*a264);
  a264=(a231*a242);
  a264=(a264+a263);
  a251=(a229*a241);
  a250=(a231*a246);
  a251=(a251-a250);
  a251=(a251+a025);
  a250=(a055<=a251);
  a266=(a251<=a055);
  a266=(a266+a250);
  a250=(a250/a266);
  a251=casadi_fmax(a055,a251);
  a266=casadi_sq(a251);
  a267=(a025*a251);
  a267=(a062-a267);
  a268=(a267*a263);
  a268=(a228*a268);
  a269=(a266*a268);
  a266=(a251*a266);
  a266=(a228*a266);
  a263=(a266*a263);
  a263=(a025*a263);
  a269=(a269-a263);
  a263=(2.*a251);
  a251=(a251*a268);
  a263=(a263*a251);
  a269=(a269+a263);
  a250=(a250*a269);
  a269=(a231*a250);
  a264=(a264-a269);
  a247=(a247*a264);
  a243=(a243*a247);
  a269=(a243/a218);
  a213=(a213*a269);
  a263=(2.*a214);
  a213=(a213/a263);
  a088=(a088*a213);
  a263=(a194<=a096);
  a251=(a096<=a194);
  a268=(a263+a251);
  a263=(a263/a268);
  a270=(a097<=a202);
  a202=(a202<=a097);
  a097=(a202+a270);
  a270=(a270/a097);
  a211=cos(a211);
  a214=(a214*a269);
  a269=(a089*a214);
  a211=(a211*a269);
  a269=(a090*a211);
  a209=casadi_sq(a209);
  a209=(a062+a209);
  a269=(a269/a209);
  a209=(a092*a269);
  a206=casadi_sq(a206);
  a206=(a062+a206);
  a209=(a209/a206);
  a206=(a091*a209);
  a271=(a091*a269);
  a204=(a204*a271);
  a206=(a206+a204);
  a270=(a270*a206);
  a263=(a263*a270);
  a204=(a263/a201);
  a182=(a182*a204);
  a272=(a182/a192);
  a088=(a088+a272);
  a067=(2.*a067);
  a217=(2.*a217);
  a188=(a188/a218);
  a188=(a188*a243);
  a243=(a225/a218);
  a272=(a225<=a223);
  a223=(a223<=a225);
  a225=(a223+a272);
  a272=(a272/a225);
  a273=(a224<=a226);
  a226=(a226<=a224);
  a224=(a226+a273);
  a273=(a273/a224);
  a274=(a055<=a237);
  a237=(a237<=a055);
  a237=(a237+a274);
  a274=(a274/a237);
  a237=sin(a060);
  a275=(a237*a260);
  a276=sin(a060);
  a277=(a276*a077);
  a275=(a275+a277);
  a277=cos(a060);
  a278=(a277*a255);
  a275=(a275+a278);
  a278=(a201*a275);
  a279=(a180*a278);
  a280=(2.*a236);
  a242=(a229*a242);
  a250=(a229*a250);
  a242=(a242+a250);
  a244=(a244/a245);
  a244=(a244*a247);
  a248=(a248/a249);
  a248=(a248*a264);
  a244=(a244-a248);
  a242=(a242+a244);
  a241=(2.*a241);
  a242=(a242/a241);
  a280=(a280*a242);
  a279=(a279-a280);
  a239=(a239*a279);
  a239=(a025*a239);
  a240=(a240*a279);
  a240=(a228*a240);
  a238=(a238*a240);
  a239=(a239-a238);
  a238=(2.*a227);
  a227=(a227*a240);
  a238=(a238*a227);
  a239=(a239-a238);
  a274=(a274*a239);
  a239=(a231*a274);
  a239=(a239+a279);
  a238=(a055<=a230);
  a230=(a230<=a055);
  a230=(a230+a238);
  a238=(a238/a230);
  a235=(a235*a279);
  a235=(a228*a235);
  a233=(a233*a235);
  a234=(a234*a279);
  a234=(a025*a234);
  a233=(a233-a234);
  a234=(2.*a232);
  a232=(a232*a235);
  a234=(a234*a232);
  a233=(a233+a234);
  a238=(a238*a233);
  a233=(a231*a238);
  a239=(a239-a233);
  a273=(a273*a239);
  a272=(a272*a273);
  a243=(a243*a272);
  a188=(a188+a243);
  a243=(2.*a218);
  a188=(a188/a243);
  a216=(2.*a216);
  a188=(a188/a216);
  a217=(a217*a188);
  a067=(a067*a217);
  a088=(a088-a067);
  a012=(a012*a088);
  a001=(a001+a012);
  a067=(2.*a185);
  a216=(a193/a192);
  a216=(a216*a182);
  a192=(2.*a192);
  a216=(a216/a192);
  a213=(a213-a216);
  a067=(a067*a213);
  a272=(a272/a218);
  a067=(a067+a272);
  a185=(2.*a185);
  a185=(a185*a217);
  a067=(a067-a185);
  a184=(a184*a067);
  a001=(a001+a184);
  a185=sin(a060);
  a217=cos(a060);
  a272=(a057*a217);
  a218=(a006+a086);
  a216=(a218*a185);
  a272=(a272-a216);
  a216=(2.*a272);
  a192=(-a096);
  a182=(a099*a180);
  a098=(a098+a182);
  a182=casadi_fmax(a055,a098);
  a086=(a006+a086);
  a243=cos(a060);
  a233=(a086*a243);
  a187=(a187+a233);
  a233=casadi_sq(a187);
  a233=(a233+a191);
  a234=sqrt(a233);
  a232=(a272/a234);
  a235=(a182*a232);
  a279=arg[2]? arg[2][36] : 0;
  a230=(a198*a180);
  a197=(a197+a230);
  a230=casadi_fmax(a196,a197);
  a227=(a279*a230);
  a235=(a235/a227);
  a240=casadi_fmin(a235,a096);
  a280=casadi_fmax(a192,a240);
  a242=(a062-a092);
  a241=(a280*a242);
  a244=(a091*a280);
  a248=atan(a244);
  a264=(a092*a248);
  a264=(a264/a091);
  a241=(a241+a264);
  a249=(a091*a241);
  a247=atan(a249);
  a245=(a090*a247);
  a250=sin(a245);
  a281=(a089*a250);
  a282=casadi_sq(a272);
  a282=(a282+a233);
  a282=sqrt(a282);
  a233=(a281*a282);
  a283=casadi_sq(a190);
  a284=casadi_sq(a283);
  a285=casadi_sq(a187);
  a286=casadi_sq(a272);
  a285=(a285+a286);
  a286=casadi_sq(a285);
  a284=(a284+a286);
  a284=sqrt(a284);
  a286=sqrt(a284);
  a233=(a233/a286);
  a287=arg[1]? arg[1][4] : 0;
  a288=arg[2]? arg[2][41] : 0;
  a289=(a227-a288);
  a290=(a287*a289);
  a290=(a290+a288);
  a290=(a290/a227);
  a288=(a290+a220);
  a291=(-a288);
  a292=(a187/a286);
  a293=casadi_fmin(a288,a292);
  a294=casadi_fmax(a291,a293);
  a295=(a229*a290);
  a296=(a231*a294);
  a295=(a295-a296);
  a295=(a295+a025);
  a296=casadi_fmax(a055,a295);
  a297=casadi_sq(a296);
  a298=(a296*a297);
  a298=(a228*a298);
  a299=(a025*a296);
  a299=(a062-a299);
  a300=(a298*a299);
  a300=(a294+a300);
  a301=(a229*a290);
  a294=(a231*a294);
  a301=(a301+a294);
  a301=(a301+a025);
  a294=casadi_fmax(a055,a301);
  a302=casadi_sq(a294);
  a303=(a294*a302);
  a303=(a228*a303);
  a304=(a025*a294);
  a304=(a062-a304);
  a305=(a303*a304);
  a300=(a300-a305);
  a305=casadi_sq(a300);
  a305=(a062-a305);
  a305=sqrt(a305);
  a306=(a305+a220);
  a307=(a233<=a306);
  a308=(a306<=a233);
  a309=(a308+a307);
  a307=(a307/a309);
  a310=(-a306);
  a306=casadi_fmin(a306,a233);
  a311=(a310<=a306);
  a312=(a306<=a310);
  a313=(a312+a311);
  a311=(a311/a313);
  a314=(a229*a305);
  a310=casadi_fmax(a310,a306);
  a306=(a231*a310);
  a314=(a314+a306);
  a314=(a314+a025);
  a306=(a055<=a314);
  a315=(a314<=a055);
  a315=(a315+a306);
  a306=(a306/a315);
  a314=casadi_fmax(a055,a314);
  a315=casadi_sq(a314);
  a316=(a314*a315);
  a316=(a228*a316);
  a317=sin(a060);
  a318=(a025*a085);
  a319=(a318*a074);
  a319=(a319+a257);
  a320=(a317*a319);
  a321=cos(a060);
  a322=(a059*a074);
  a322=(a322+a077);
  a323=(a321*a322);
  a320=(a320-a323);
  a323=(a227*a320);
  a324=(a180*a323);
  a325=(a316*a324);
  a325=(a025*a325);
  a326=(a025*a314);
  a326=(a062-a326);
  a327=(a326*a324);
  a327=(a228*a327);
  a315=(a315*a327);
  a325=(a325-a315);
  a315=(2.*a314);
  a314=(a314*a327);
  a315=(a315*a314);
  a325=(a325-a315);
  a306=(a306*a325);
  a325=(a231*a306);
  a325=(a325+a324);
  a315=(a229*a305);
  a314=(a231*a310);
  a315=(a315-a314);
  a315=(a315+a025);
  a314=(a055<=a315);
  a327=(a315<=a055);
  a327=(a327+a314);
  a314=(a314/a327);
  a315=casadi_fmax(a055,a315);
  a327=casadi_sq(a315);
  a328=(a025*a315);
  a328=(a062-a328);
  a329=(a328*a324);
  a329=(a228*a329);
  a330=(a327*a329);
  a327=(a315*a327);
  a327=(a228*a327);
  a324=(a327*a324);
  a324=(a025*a324);
  a330=(a330-a324);
  a324=(2.*a315);
  a315=(a315*a329);
  a324=(a324*a315);
  a330=(a330+a324);
  a314=(a314*a330);
  a330=(a231*a314);
  a325=(a325-a330);
  a311=(a311*a325);
  a307=(a307*a311);
  a330=(a307/a286);
  a281=(a281*a330);
  a324=(2.*a282);
  a281=(a281/a324);
  a216=(a216*a281);
  a324=(a235<=a096);
  a315=(a096<=a235);
  a329=(a324+a315);
  a324=(a324/a329);
  a331=(a192<=a240);
  a240=(a240<=a192);
  a192=(a240+a331);
  a331=(a331/a192);
  a245=cos(a245);
  a282=(a282*a330);
  a089=(a089*a282);
  a245=(a245*a089);
  a090=(a090*a245);
  a249=casadi_sq(a249);
  a249=(a062+a249);
  a090=(a090/a249);
  a092=(a092*a090);
  a244=casadi_sq(a244);
  a244=(a062+a244);
  a092=(a092/a244);
  a244=(a091*a092);
  a249=(a091*a090);
  a242=(a242*a249);
  a244=(a244+a242);
  a331=(a331*a244);
  a324=(a324*a331);
  a242=(a324/a227);
  a182=(a182*a242);
  a089=(a182/a234);
  a216=(a216+a089);
  a272=(2.*a272);
  a285=(2.*a285);
  a233=(a233/a286);
  a233=(a233*a307);
  a307=(a292/a286);
  a089=(a292<=a288);
  a288=(a288<=a292);
  a292=(a288+a089);
  a089=(a089/a292);
  a330=(a291<=a293);
  a293=(a293<=a291);
  a291=(a293+a330);
  a330=(a330/a291);
  a332=(a055<=a301);
  a301=(a301<=a055);
  a301=(a301+a332);
  a332=(a332/a301);
  a301=(2.*a300);
  a306=(a229*a306);
  a314=(a229*a314);
  a306=(a306+a314);
  a308=(a308/a309);
  a308=(a308*a311);
  a312=(a312/a313);
  a312=(a312*a325);
  a308=(a308-a312);
  a306=(a306+a308);
  a305=(2.*a305);
  a306=(a306/a305);
  a301=(a301*a306);
  a306=sin(a060);
  a305=(a306*a322);
  a308=cos(a060);
  a312=(a308*a319);
  a305=(a305+a312);
  a312=(a227*a305);
  a325=(a180*a312);
  a301=(a301+a325);
  a304=(a304*a301);
  a304=(a228*a304);
  a302=(a302*a304);
  a303=(a303*a301);
  a303=(a025*a303);
  a302=(a302-a303);
  a303=(2.*a294);
  a294=(a294*a304);
  a303=(a303*a294);
  a302=(a302+a303);
  a332=(a332*a302);
  a302=(a231*a332);
  a302=(a302-a301);
  a303=(a055<=a295);
  a295=(a295<=a055);
  a295=(a295+a303);
  a303=(a303/a295);
  a298=(a298*a301);
  a298=(a025*a298);
  a299=(a299*a301);
  a299=(a228*a299);
  a297=(a297*a299);
  a298=(a298-a297);
  a297=(2.*a296);
  a296=(a296*a299);
  a297=(a297*a296);
  a298=(a298-a297);
  a303=(a303*a298);
  a298=(a231*a303);
  a302=(a302-a298);
  a330=(a330*a302);
  a089=(a089*a330);
  a307=(a307*a089);
  a233=(a233+a307);
  a307=(2.*a286);
  a233=(a233/a307);
  a284=(2.*a284);
  a233=(a233/a284);
  a285=(a285*a233);
  a272=(a272*a285);
  a216=(a216-a272);
  a185=(a185*a216);
  a001=(a001-a185);
  a272=(2.*a187);
  a284=(a232/a234);
  a284=(a284*a182);
  a234=(2.*a234);
  a284=(a284/a234);
  a281=(a281-a284);
  a272=(a272*a281);
  a089=(a089/a286);
  a272=(a272+a089);
  a187=(2.*a187);
  a187=(a187*a285);
  a272=(a272-a187);
  a243=(a243*a272);
  a001=(a001+a243);
  a187=arg[2]? arg[2][44] : 0;
  a285=(a048*a187);
  a089=arg[1]? arg[1][7] : 0;
  a285=(a285+a089);
  a089=arg[2]? arg[2][45] : 0;
  a286=(a062-a089);
  a284=(a285*a286);
  a234=sin(a284);
  a182=(a158+a161);
  a307=(a003*a182);
  a307=(a307+a040);
  a298=cos(a284);
  a297=(a307*a298);
  a296=(a006*a234);
  a297=(a297-a296);
  a296=(2.*a297);
  a299=arg[2]? arg[2][54] : 0;
  a301=arg[2]? arg[2][53] : 0;
  a295=arg[2]? arg[2][51] : 0;
  a294=arg[2]? arg[2][52] : 0;
  a304=(a294-a062);
  a325=casadi_fmax(a020,a304);
  a325=sqrt(a325);
  a313=(a295*a325);
  a311=(1./a313);
  a309=(-a311);
  a314=arg[2]? arg[2][46] : 0;
  a333=arg[2]? arg[2][47] : 0;
  a334=(a101*a059);
  a334=(a334+a169);
  a334=(a334/a178);
  a169=casadi_fmax(a055,a334);
  a335=(a333*a169);
  a314=(a314+a335);
  a335=casadi_fmax(a055,a314);
  a336=cos(a284);
  a337=(a006*a336);
  a338=sin(a284);
  a339=(a307*a338);
  a337=(a337+a339);
  a339=casadi_sq(a337);
  a339=(a339+a191);
  a191=sqrt(a339);
  a340=(a297/a191);
  a341=(a335*a340);
  a342=arg[2]? arg[2][50] : 0;
  a343=arg[2]? arg[2][48] : 0;
  a344=arg[2]? arg[2][49] : 0;
  a345=(a344*a169);
  a343=(a343+a345);
  a345=casadi_fmax(a196,a343);
  a346=(a342*a345);
  a341=(a341/a346);
  a347=casadi_fmin(a341,a311);
  a348=casadi_fmax(a309,a347);
  a349=(a295*a348);
  a350=atan(a349);
  a351=(a294*a350);
  a351=(a351/a295);
  a352=(a294-a062);
  a353=(a348*a352);
  a353=(a351-a353);
  a354=(a295*a353);
  a355=atan(a354);
  a356=(a301*a355);
  a357=sin(a356);
  a358=(a299*a357);
  a359=casadi_sq(a297);
  a359=(a359+a339);
  a359=sqrt(a359);
  a339=(a358*a359);
  a360=casadi_sq(a190);
  a361=casadi_sq(a360);
  a362=casadi_sq(a337);
  a363=casadi_sq(a297);
  a362=(a362+a363);
  a363=casadi_sq(a362);
  a361=(a361+a363);
  a361=sqrt(a361);
  a363=sqrt(a361);
  a339=(a339/a363);
  a364=arg[2]? arg[2][55] : 0;
  a364=(a364/a346);
  a365=(a364+a220);
  a366=(-a365);
  a367=(a337/a363);
  a368=casadi_fmin(a365,a367);
  a369=casadi_fmax(a366,a368);
  a370=(a229*a364);
  a371=(a231*a369);
  a370=(a370-a371);
  a370=(a370+a025);
  a371=casadi_fmax(a055,a370);
  a372=casadi_sq(a371);
  a373=(a371*a372);
  a373=(a228*a373);
  a374=(a025*a371);
  a374=(a062-a374);
  a375=(a373*a374);
  a375=(a369+a375);
  a376=(a229*a364);
  a369=(a231*a369);
  a376=(a376+a369);
  a376=(a376+a025);
  a369=casadi_fmax(a055,a376);
  a377=casadi_sq(a369);
  a378=(a369*a377);
  a378=(a228*a378);
  a379=(a025*a369);
  a379=(a062-a379);
  a380=(a378*a379);
  a375=(a375-a380);
  a380=casadi_sq(a375);
  a380=(a062-a380);
  a380=sqrt(a380);
  a220=(a380+a220);
  a381=(a339<=a220);
  a382=(a220<=a339);
  a383=(a382+a381);
  a381=(a381/a383);
  a384=(-a220);
  a220=casadi_fmin(a220,a339);
  a385=(a384<=a220);
  a386=(a220<=a384);
  a387=(a386+a385);
  a385=(a385/a387);
  a388=(a229*a380);
  a384=casadi_fmax(a384,a220);
  a220=(a231*a384);
  a388=(a388+a220);
  a388=(a388+a025);
  a220=(a055<=a388);
  a389=(a388<=a055);
  a389=(a389+a220);
  a220=(a220/a389);
  a388=casadi_fmax(a055,a388);
  a389=casadi_sq(a388);
  a390=(a388*a389);
  a390=(a228*a390);
  a089=(a062-a089);
  a391=sin(a284);
  a392=(a391*a257);
  a393=cos(a284);
  a158=(a158+a161);
  a161=(a158*a074);
  a161=(a161+a077);
  a394=(a393*a161);
  a392=(a392-a394);
  a394=(a089*a392);
  a395=(a346*a394);
  a396=(a169*a395);
  a397=(a390*a396);
  a397=(a025*a397);
  a398=(a025*a388);
  a398=(a062-a398);
  a399=(a398*a396);
  a399=(a228*a399);
  a389=(a389*a399);
  a397=(a397-a389);
  a389=(2.*a388);
  a388=(a388*a399);
  a389=(a389*a388);
  a397=(a397-a389);
  a220=(a220*a397);
  a397=(a231*a220);
  a397=(a397+a396);
  a389=(a229*a380);
  a388=(a231*a384);
  a389=(a389-a388);
  a389=(a389+a025);
  a388=(a055<=a389);
  a399=(a389<=a055);
  a399=(a399+a388);
  a388=(a388/a399);
  a389=casadi_fmax(a055,a389);
  a399=casadi_sq(a389);
  a400=(a025*a389);
  a400=(a062-a400);
  a401=(a400*a396);
  a401=(a228*a401);
  a402=(a399*a401);
  a399=(a389*a399);
  a399=(a228*a399);
  a396=(a399*a396);
  a396=(a025*a396);
  a402=(a402-a396);
  a396=(2.*a389);
  a389=(a389*a401);
  a396=(a396*a389);
  a402=(a402+a396);
  a388=(a388*a402);
  a402=(a231*a388);
  a397=(a397-a402);
  a385=(a385*a397);
  a381=(a381*a385);
  a402=(a381/a363);
  a358=(a358*a402);
  a396=(2.*a359);
  a358=(a358/a396);
  a296=(a296*a358);
  a396=(a341<=a311);
  a389=(a311<=a341);
  a401=(a396+a389);
  a396=(a396/a401);
  a403=(a309<=a347);
  a347=(a347<=a309);
  a309=(a347+a403);
  a403=(a403/a309);
  a356=cos(a356);
  a359=(a359*a402);
  a299=(a299*a359);
  a356=(a356*a299);
  a301=(a301*a356);
  a354=casadi_sq(a354);
  a354=(a062+a354);
  a301=(a301/a354);
  a294=(a294*a301);
  a349=casadi_sq(a349);
  a062=(a062+a349);
  a294=(a294/a062);
  a062=(a295*a294);
  a349=(a295*a301);
  a352=(a352*a349);
  a062=(a062-a352);
  a403=(a403*a062);
  a396=(a396*a403);
  a352=(a396/a346);
  a335=(a335*a352);
  a354=(a335/a191);
  a296=(a296+a354);
  a297=(2.*a297);
  a362=(2.*a362);
  a339=(a339/a363);
  a339=(a339*a381);
  a381=(a367/a363);
  a354=(a367<=a365);
  a365=(a365<=a367);
  a367=(a365+a354);
  a354=(a354/a367);
  a299=(a366<=a368);
  a368=(a368<=a366);
  a366=(a368+a299);
  a299=(a299/a366);
  a402=(a055<=a376);
  a376=(a376<=a055);
  a376=(a376+a402);
  a402=(a402/a376);
  a376=sin(a284);
  a404=(a376*a161);
  a405=cos(a284);
  a406=(a405*a257);
  a404=(a404+a406);
  a406=(a346*a404);
  a407=(a169*a406);
  a408=(2.*a375);
  a220=(a229*a220);
  a388=(a229*a388);
  a220=(a220+a388);
  a382=(a382/a383);
  a382=(a382*a385);
  a386=(a386/a387);
  a386=(a386*a397);
  a382=(a382-a386);
  a220=(a220+a382);
  a380=(2.*a380);
  a220=(a220/a380);
  a408=(a408*a220);
  a407=(a407+a408);
  a379=(a379*a407);
  a379=(a228*a379);
  a377=(a377*a379);
  a378=(a378*a407);
  a378=(a025*a378);
  a377=(a377-a378);
  a378=(2.*a369);
  a369=(a369*a379);
  a378=(a378*a369);
  a377=(a377+a378);
  a402=(a402*a377);
  a377=(a231*a402);
  a377=(a377-a407);
  a378=(a055<=a370);
  a370=(a370<=a055);
  a370=(a370+a378);
  a378=(a378/a370);
  a373=(a373*a407);
  a373=(a025*a373);
  a374=(a374*a407);
  a228=(a228*a374);
  a372=(a372*a228);
  a373=(a373-a372);
  a372=(2.*a371);
  a371=(a371*a228);
  a372=(a372*a371);
  a373=(a373-a372);
  a378=(a378*a373);
  a231=(a231*a378);
  a377=(a377-a231);
  a299=(a299*a377);
  a354=(a354*a299);
  a381=(a381*a354);
  a339=(a339+a381);
  a381=(2.*a363);
  a339=(a339/a381);
  a361=(2.*a361);
  a339=(a339/a361);
  a362=(a362*a339);
  a297=(a297*a362);
  a296=(a296-a297);
  a234=(a234*a296);
  a001=(a001-a234);
  a234=(2.*a337);
  a297=(a340/a191);
  a297=(a297*a335);
  a191=(2.*a191);
  a297=(a297/a191);
  a358=(a358-a297);
  a234=(a234*a358);
  a354=(a354/a363);
  a234=(a234+a354);
  a337=(2.*a337);
  a337=(a337*a362);
  a234=(a234-a337);
  a336=(a336*a234);
  a001=(a001+a336);
  a336=(2.*a009);
  a337=arg[2]? arg[2][23] : 0;
  a362=casadi_sq(a144);
  a354=arg[2]? arg[2][24] : 0;
  a363=(a362*a354);
  a337=(a337+a363);
  a363=(a337*a152);
  a297=(a363*a009);
  a297=(a297/a155);
  a191=(a297/a155);
  a191=(a191*a257);
  a335=casadi_sq(a042);
  a335=(a335+a150);
  a150=(a042/a335);
  a361=arg[2]? arg[2][65] : 0;
  a381=arg[2]? arg[2][60] : 0;
  a231=(a381*a152);
  a373=(a231*a074);
  a372=(a361*a373);
  a371=arg[2]? arg[2][57] : 0;
  a228=(a152*a077);
  a374=(a371*a228);
  a372=(a372+a374);
  a150=(a150*a372);
  a191=(a191-a150);
  a154=(a154/a155);
  a150=(a055<=a334);
  a374=(a334<=a055);
  a374=(a374+a150);
  a150=(a150/a374);
  a399=(a399*a400);
  a384=(a384+a399);
  a390=(a390*a398);
  a384=(a384-a390);
  a395=(a384*a395);
  a406=(a375*a406);
  a395=(a395-a406);
  a406=(a055<=a314);
  a314=(a314<=a055);
  a314=(a314+a406);
  a406=(a406/a314);
  a340=(a340*a352);
  a406=(a406*a340);
  a333=(a333*a406);
  a395=(a395+a333);
  a333=(a196<=a343);
  a343=(a343<=a196);
  a343=(a343+a333);
  a333=(a333/a343);
  a384=(a169*a384);
  a394=(a384*a394);
  a375=(a169*a375);
  a404=(a375*a404);
  a394=(a394-a404);
  a341=(a341/a346);
  a341=(a341*a396);
  a394=(a394-a341);
  a364=(a364/a346);
  a402=(a229*a402);
  a378=(a229*a378);
  a402=(a402+a378);
  a365=(a365/a367);
  a365=(a365*a299);
  a368=(a368/a366);
  a368=(a368*a377);
  a365=(a365-a368);
  a402=(a402+a365);
  a364=(a364*a402);
  a394=(a394-a364);
  a342=(a342*a394);
  a333=(a333*a342);
  a344=(a344*a333);
  a395=(a395+a344);
  a150=(a150*a395);
  a395=(a150/a178);
  a344=(a059*a395);
  a342=(a055<=a179);
  a179=(a179<=a055);
  a179=(a179+a342);
  a342=(a342/a179);
  a266=(a266*a267);
  a246=(a246+a266);
  a252=(a252*a265);
  a246=(a246-a252);
  a262=(a246*a262);
  a252=(a055<=a181);
  a181=(a181<=a055);
  a181=(a181+a252);
  a252=(a252/a181);
  a193=(a193*a204);
  a252=(a252*a193);
  a193=(a099*a252);
  a262=(a262+a193);
  a278=(a236*a278);
  a262=(a262+a278);
  a278=(a196<=a199);
  a199=(a199<=a196);
  a199=(a199+a278);
  a278=(a278/a199);
  a246=(a180*a246);
  a258=(a246*a258);
  a194=(a194/a201);
  a194=(a194*a263);
  a258=(a258-a194);
  a236=(a180*a236);
  a275=(a236*a275);
  a258=(a258+a275);
  a222=(a222/a201);
  a274=(a229*a274);
  a238=(a229*a238);
  a274=(a274+a238);
  a223=(a223/a225);
  a223=(a223*a273);
  a226=(a226/a224);
  a226=(a226*a239);
  a223=(a223-a226);
  a274=(a274+a223);
  a222=(a222*a274);
  a258=(a258-a222);
  a274=(a274/a201);
  a219=(a219*a274);
  a258=(a258+a219);
  a195=(a195*a258);
  a278=(a278*a195);
  a195=(a198*a278);
  a262=(a262+a195);
  a327=(a327*a328);
  a310=(a310+a327);
  a316=(a316*a326);
  a310=(a310-a316);
  a323=(a310*a323);
  a262=(a262+a323);
  a323=(a055<=a098);
  a098=(a098<=a055);
  a098=(a098+a323);
  a323=(a323/a098);
  a232=(a232*a242);
  a323=(a323*a232);
  a099=(a099*a323);
  a262=(a262+a099);
  a312=(a300*a312);
  a262=(a262-a312);
  a312=(a196<=a197);
  a197=(a197<=a196);
  a197=(a197+a312);
  a312=(a312/a197);
  a310=(a180*a310);
  a320=(a310*a320);
  a235=(a235/a227);
  a235=(a235*a324);
  a320=(a320-a235);
  a300=(a180*a300);
  a305=(a300*a305);
  a320=(a320-a305);
  a290=(a290/a227);
  a332=(a229*a332);
  a229=(a229*a303);
  a332=(a332+a229);
  a288=(a288/a292);
  a288=(a288*a330);
  a293=(a293/a291);
  a293=(a293*a302);
  a288=(a288-a293);
  a332=(a332+a288);
  a290=(a290*a332);
  a320=(a320-a290);
  a332=(a332/a227);
  a287=(a287*a332);
  a320=(a320+a287);
  a279=(a279*a320);
  a312=(a312*a279);
  a198=(a198*a312);
  a262=(a262+a198);
  a342=(a342*a262);
  a262=(a342/a178);
  a262=(a025*a262);
  a162=(a162*a262);
  a344=(a344-a162);
  a154=(a154*a344);
  a191=(a191+a154);
  a154=(2.*a155);
  a191=(a191/a154);
  a154=2.5000000000000000e-01;
  a148=(a154*a148);
  a162=arg[2]? arg[2][66] : 0;
  a198=casadi_sq(a381);
  a279=(a162*a198);
  a290=(a279*a074);
  a288=arg[2]? arg[2][58] : 0;
  a293=(a288*a381);
  a302=(a293*a077);
  a290=(a290+a302);
  a302=(a018*a290);
  a291=(a003*a302);
  a330=(a148*a291);
  a292=sqrt(a044);
  a229=(2.*a292);
  a330=(a330/a229);
  a229=arg[2]? arg[2][64] : 0;
  a303=arg[1]? arg[1][9] : 0;
  a305=(a229*a303);
  a235=atan2(a042,a155);
  a361=(a361*a235);
  a305=(a305+a361);
  a361=arg[2]? arg[2][67] : 0;
  a324=(a361*a047);
  a305=(a305+a324);
  a324=(a305*a074);
  a197=(a381*a324);
  a371=(a371*a235);
  a196=arg[2]? arg[2][59] : 0;
  a099=(a196*a047);
  a371=(a371+a099);
  a099=(a371*a077);
  a197=(a197+a099);
  a099=(a257/a155);
  a232=(a009*a099);
  a337=(a337*a232);
  a197=(a197-a337);
  a337=(a395-a262);
  a172=(a172*a337);
  a170=(a170*a172);
  a197=(a197+a170);
  a170=(a344/a155);
  a009=(a009*a170);
  a242=(a144*a009);
  a197=(a197-a242);
  a242=(a018*a197);
  a149=(a149*a242);
  a330=(a330+a149);
  a191=(a191+a330);
  a336=(a336*a191);
  a363=(a363*a099);
  a153=(a153*a170);
  a363=(a363+a153);
  a336=(a336-a363);
  a001=(a001+a336);
  a014=(2.*a014);
  a166=(a166*a337);
  a166=(a166-a344);
  a131=(a131*a166);
  a363=(a025*a131);
  a113=(2.*a113);
  a363=(a363/a113);
  a014=(a014*a363);
  a363=(a025*a131);
  a363=(a014+a363);
  a113=(a111*a363);
  a153=(2.*a110);
  a110=(a110*a363);
  a111=(2.*a111);
  a110=(a110/a111);
  a153=(a153*a110);
  a113=(a113+a153);
  a001=(a001+a113);
  if (res[0]!=0) res[0][0]=a001;
  a001=cos(a000);
  a001=(a001*a002);
  a153=sin(a000);
  a153=(a153*a004);
  a001=(a001-a153);
  a045=(a045/a079);
  a045=(a045*a031);
  a039=(2.*a039);
  a039=(a039*a078);
  a045=(a045-a039);
  a001=(a001+a045);
  a053=(a053*a088);
  a217=(a217*a216);
  a053=(a053+a217);
  a217=(a272-a067);
  a186=(a186*a217);
  a053=(a053+a186);
  a001=(a001+a053);
  a298=(a298*a296);
  a338=(a338*a234);
  a298=(a298+a338);
  a001=(a001+a298);
  a155=(a155/a335);
  a155=(a155*a372);
  a042=(2.*a042);
  a042=(a042*a330);
  a155=(a155+a042);
  a001=(a001+a155);
  a042=(a003*a256);
  a001=(a001+a042);
  if (res[0]!=0) res[0][1]=a001;
  a001=arg[4]? arg[4][5] : 0;
  a042=(a006*a005);
  a001=(a001-a042);
  a148=(a148*a292);
  a302=(a148*a302);
  a001=(a001+a302);
  a302=(a035*a045);
  a001=(a001+a302);
  a012=(a012+a184);
  a012=(a012+a185);
  a243=(a243-a012);
  a085=(a085*a243);
  a085=(a025*a085);
  a001=(a001+a085);
  a085=(a059*a053);
  a001=(a001+a085);
  a182=(a182*a298);
  a001=(a001+a182);
  a182=(a040*a256);
  a001=(a001+a182);
  if (res[0]!=0) res[0][2]=a001;
  if (res[0]!=0) res[0][3]=a055;
  if (res[0]!=0) res[0][4]=a055;
  a001=cos(a000);
  a182=(a006*a002);
  a001=(a001*a182);
  a182=sin(a000);
  a002=(a040*a002);
  a182=(a182*a002);
  a001=(a001-a182);
  a182=cos(a000);
  a040=(a040*a004);
  a182=(a182*a040);
  a001=(a001-a182);
  a182=sin(a000);
  a004=(a006*a004);
  a182=(a182*a004);
  a001=(a001-a182);
  a182=cos(a000);
  a155=(a045+a155);
  a004=(a007*a155);
  a182=(a182*a004);
  a001=(a001+a182);
  a182=sin(a000);
  a004=(a010*a155);
  a182=(a182*a004);
  a001=(a001+a182);
  a182=cos(a000);
  a023=(a023-a336);
  a023=(a023-a113);
  a010=(a010*a023);
  a182=(a182*a010);
  a001=(a001+a182);
  a000=sin(a000);
  a007=(a007*a023);
  a000=(a000*a007);
  a001=(a001-a000);
  if (res[0]!=0) res[0][5]=a001;
  a043=(a043*a155);
  a008=(a008*a023);
  a043=(a043+a008);
  if (res[1]!=0) res[1][0]=a043;
  a011=(a011*a023);
  a041=(a041*a155);
  a011=(a011-a041);
  if (res[1]!=0) res[1][1]=a011;
  a177=(a177*a337);
  a175=(a175*a177);
  a175=(a257+a175);
  a024=(-a024);
  a024=(2.*a024);
  a024=(a024-a080);
  a014=(2.*a014);
  a024=(a024+a014);
  a024=(a024+a131);
  a131=(a024/a021);
  a175=(a175+a131);
  if (res[1]!=0) res[1][2]=a175;
  a171=(a171*a337);
  a174=(a174*a171);
  a175=(a115<=a103);
  a103=(a103<=a115);
  a115=(a103+a175);
  a175=(a175/a115);
  a131=(a104<=a116);
  a116=(a116<=a104);
  a104=(a116+a131);
  a131=(a131/a104);
  a014=(a055<=a102);
  a102=(a102<=a055);
  a102=(a102+a014);
  a014=(a014/a102);
  a112=(a112*a166);
  a130=(a130*a112);
  a166=(a018*a130);
  a127=(a127*a166);
  a127=(a025*a127);
  a125=(a125*a127);
  a125=(a025*a125);
  a126=(a126*a127);
  a126=(a054*a126);
  a124=(a124*a126);
  a125=(a125-a124);
  a124=(2.*a117);
  a117=(a117*a126);
  a124=(a124*a117);
  a125=(a125-a124);
  a014=(a014*a125);
  a125=(a058*a014);
  a125=(a125+a127);
  a124=(a055<=a118);
  a118=(a118<=a055);
  a118=(a118+a124);
  a124=(a124/a118);
  a122=(a122*a127);
  a122=(a054*a122);
  a120=(a120*a122);
  a121=(a121*a127);
  a121=(a025*a121);
  a120=(a120-a121);
  a121=(2.*a119);
  a119=(a119*a122);
  a121=(a121*a119);
  a120=(a120+a121);
  a124=(a124*a120);
  a120=(a058*a124);
  a125=(a125-a120);
  a131=(a131*a125);
  a175=(a175*a131);
  a105=(a105*a175);
  a107=(a107*a105);
  a174=(a174+a107);
  if (res[1]!=0) res[1][3]=a174;
  a289=(a289*a332);
  if (res[1]!=0) res[1][4]=a289;
  a221=(a221*a274);
  if (res[1]!=0) res[1][5]=a221;
  a221=sin(a284);
  a384=(a384*a346);
  a089=(a384*a089);
  a289=(a089*a161);
  a221=(a221*a289);
  a289=cos(a284);
  a375=(a375*a346);
  a161=(a375*a161);
  a289=(a289*a161);
  a221=(a221-a289);
  a289=sin(a284);
  a161=(a375*a257);
  a289=(a289*a161);
  a221=(a221+a289);
  a289=cos(a284);
  a257=(a089*a257);
  a289=(a289*a257);
  a221=(a221+a289);
  a289=cos(a284);
  a257=(a006*a296);
  a289=(a289*a257);
  a221=(a221-a289);
  a289=sin(a284);
  a296=(a307*a296);
  a289=(a289*a296);
  a221=(a221-a289);
  a289=cos(a284);
  a307=(a307*a234);
  a289=(a289*a307);
  a221=(a221+a289);
  a284=sin(a284);
  a006=(a006*a234);
  a284=(a284*a006);
  a221=(a221-a284);
  a286=(a286*a221);
  a187=(a187*a286);
  a361=(a361*a373);
  a196=(a196*a228);
  a361=(a361+a196);
  a050=(a050*a031);
  a361=(a361-a050);
  a049=(a049*a361);
  a187=(a187-a049);
  if (res[1]!=0) res[1][6]=a187;
  if (res[1]!=0) res[1][7]=a286;
  if (res[1]!=0) res[1][8]=a361;
  a229=(a229*a373);
  if (res[1]!=0) res[1][9]=a229;
  a229=(a038*a074);
  a229=(a077-a229);
  if (res[1]!=0) res[1][10]=a229;
  a236=(a236*a201);
  a237=(a236*a237);
  a246=(a246*a201);
  a259=(a246*a259);
  a237=(a237-a259);
  a201=(a237*a074);
  a300=(a300*a227);
  a306=(a300*a306);
  a310=(a310*a227);
  a321=(a310*a321);
  a306=(a306+a321);
  a321=(a306*a074);
  a201=(a201-a321);
  a053=(a003*a053);
  a201=(a201+a053);
  a163=(a163/a178);
  a163=(a163*a342);
  a334=(a334/a178);
  a334=(a334*a150);
  a163=(a163-a334);
  a201=(a201+a163);
  a395=(a101*a395);
  a201=(a201+a395);
  a061=(a061*a201);
  if (res[2]!=0) res[2][0]=a061;
  a061=sin(a033);
  a395=arg[1]? arg[1][10] : 0;
  a334=(a395*a074);
  a045=(a003*a045);
  a071=(a071*a015);
  a015=(a071*a074);
  a045=(a045-a015);
  a334=(a334+a045);
  a036=(a036*a334);
  a061=(a061*a036);
  a036=cos(a033);
  a032=(a032*a045);
  a036=(a036*a032);
  a061=(a061+a036);
  a036=cos(a033);
  a298=(a003*a298);
  a376=(a375*a376);
  a393=(a089*a393);
  a376=(a376+a393);
  a393=(a376*a074);
  a101=(a101*a262);
  a262=(a393+a101);
  a262=(a298-a262);
  a262=(a262-a163);
  a159=(a159*a262);
  a036=(a036*a159);
  a061=(a061+a036);
  a036=sin(a033);
  a393=(a393+a101);
  a298=(a298-a393);
  a298=(a298-a163);
  a156=(a156*a298);
  a036=(a036*a156);
  a061=(a061-a036);
  a036=sin(a033);
  a176=(a176*a337);
  a036=(a036*a176);
  a061=(a061-a036);
  a173=(a173*a171);
  a061=(a061+a173);
  a173=cos(a033);
  a132=(a132*a337);
  a167=(a167*a132);
  a173=(a173*a167);
  a061=(a061+a173);
  a173=sin(a033);
  a164=(a164*a132);
  a173=(a173*a164);
  a061=(a061-a173);
  a173=cos(a033);
  a063=(a063*a201);
  a173=(a173*a063);
  a061=(a061+a173);
  a173=sin(a033);
  a013=(a013*a201);
  a173=(a173*a013);
  a061=(a061-a173);
  a173=(a135<=a028);
  a028=(a028<=a135);
  a135=(a028+a173);
  a173=(a173/a135);
  a013=(a134<=a137);
  a137=(a137<=a134);
  a134=(a137+a013);
  a013=(a013/a134);
  a063=(a055<=a133);
  a133=(a133<=a055);
  a133=(a133+a063);
  a063=(a063/a133);
  a144=(2.*a144);
  a232=(a152*a232);
  a354=(a354*a232);
  a144=(a144*a354);
  a009=(a152*a009);
  a144=(a144+a009);
  a147=(a147*a144);
  a147=(a054*a147);
  a145=(a145*a147);
  a146=(a146*a144);
  a146=(a025*a146);
  a145=(a145-a146);
  a146=(2.*a138);
  a138=(a138*a147);
  a146=(a146*a138);
  a145=(a145+a146);
  a063=(a063*a145);
  a145=(a058*a063);
  a145=(a145-a144);
  a146=(a055<=a139);
  a139=(a139<=a055);
  a139=(a139+a146);
  a146=(a146/a139);
  a142=(a142*a144);
  a142=(a025*a142);
  a143=(a143*a144);
  a054=(a054*a143);
  a141=(a141*a054);
  a142=(a142-a141);
  a141=(2.*a140);
  a140=(a140*a054);
  a141=(a141*a140);
  a142=(a142-a141);
  a146=(a146*a142);
  a058=(a058*a146);
  a145=(a145-a058);
  a013=(a013*a145);
  a173=(a173*a013);
  a136=(a136*a173);
  a061=(a061+a136);
  a109=(a109*a105);
  a061=(a061+a109);
  if (res[2]!=0) res[2][1]=a061;
  a061=cos(a060);
  a260=(a236*a260);
  a061=(a061*a260);
  a260=sin(a060);
  a109=(a310*a322);
  a260=(a260*a109);
  a061=(a061+a260);
  a260=cos(a060);
  a322=(a300*a322);
  a260=(a260*a322);
  a061=(a061-a260);
  a260=sin(a060);
  a261=(a246*a261);
  a260=(a260*a261);
  a061=(a061+a260);
  a260=cos(a060);
  a261=(a236*a077);
  a260=(a260*a261);
  a061=(a061+a260);
  a260=cos(a060);
  a261=(a246*a255);
  a260=(a260*a261);
  a061=(a061+a260);
  a260=sin(a060);
  a255=(a236*a255);
  a260=(a260*a255);
  a061=(a061-a260);
  a260=cos(a060);
  a087=(a087*a088);
  a260=(a260*a087);
  a061=(a061+a260);
  a260=sin(a060);
  a088=(a057*a088);
  a260=(a260*a088);
  a061=(a061-a260);
  a260=sin(a060);
  a183=(a183*a067);
  a260=(a260*a183);
  a061=(a061-a260);
  a260=cos(a060);
  a183=(a310*a319);
  a260=(a260*a183);
  a061=(a061+a260);
  a260=sin(a060);
  a319=(a300*a319);
  a260=(a260*a319);
  a061=(a061+a260);
  a260=cos(a060);
  a218=(a218*a216);
  a260=(a260*a218);
  a061=(a061-a260);
  a260=sin(a060);
  a216=(a057*a216);
  a260=(a260*a216);
  a061=(a061-a260);
  a260=sin(a060);
  a086=(a086*a272);
  a260=(a260*a086);
  a061=(a061-a260);
  a060=cos(a060);
  a057=(a057*a217);
  a060=(a060*a057);
  a061=(a061+a060);
  if (res[2]!=0) res[2][2]=a061;
  a277=(a236*a277);
  a246=(a246*a253);
  a277=(a277+a246);
  a246=(a277*a074);
  a246=(a025*a246);
  a300=(a300*a308);
  a310=(a310*a317);
  a300=(a300-a310);
  a310=(a300*a074);
  a310=(a025*a310);
  a246=(a246-a310);
  a084=(a084*a243);
  a246=(a246+a084);
  if (res[2]!=0) res[2][3]=a246;
  a026=(a026*a201);
  if (res[2]!=0) res[2][4]=a026;
  a026=(2.*a190);
  a213=(a213+a281);
  a213=(a213+a358);
  a189=(a189*a213);
  a026=(a026*a189);
  a189=(2.*a190);
  a215=(2.*a215);
  a215=(a215*a188);
  a189=(a189*a215);
  a215=(2.*a190);
  a283=(2.*a283);
  a283=(a283*a233);
  a215=(a215*a283);
  a189=(a189+a215);
  a026=(a026-a189);
  a190=(2.*a190);
  a360=(2.*a360);
  a360=(a360*a339);
  a190=(a190*a360);
  a026=(a026-a190);
  if (res[2]!=0) res[2][5]=a026;
  a022=(a022/a021);
  a022=(a022*a024);
  a024=(a019*a022);
  a024=(-a024);
  if (res[2]!=0) res[2][6]=a024;
  a148=(a148*a003);
  a290=(a148*a290);
  a070=(a070*a075);
  a290=(a290-a070);
  a151=(a151*a197);
  a290=(a290+a151);
  a128=(a128*a130);
  a290=(a290+a128);
  a128=(2.*a018);
  a017=(a017*a022);
  a019=(2.*a019);
  a017=(a017/a019);
  a128=(a128*a017);
  a290=(a290-a128);
  if (res[2]!=0) res[2][7]=a290;
  a114=(a114*a105);
  a114=(-a114);
  if (res[2]!=0) res[2][8]=a114;
  if (res[2]!=0) res[2][9]=a105;
  a105=(a106*a105);
  if (res[2]!=0) res[2][10]=a105;
  a108=(a108*a175);
  if (res[2]!=0) res[2][11]=a108;
  a014=(a056*a014);
  a124=(a056*a124);
  a014=(a014+a124);
  a103=(a103/a115);
  a103=(a103*a131);
  a116=(a116/a104);
  a116=(a116*a125);
  a103=(a103-a116);
  a014=(a014+a103);
  if (res[2]!=0) res[2][12]=a014;
  a123=(a123*a166);
  if (res[2]!=0) res[2][13]=a123;
  a129=(a129*a112);
  if (res[2]!=0) res[2][14]=a129;
  a292=(a292*a291);
  a154=(a154*a292);
  a044=(a044*a242);
  a044=(a025*a044);
  a154=(a154+a044);
  if (res[2]!=0) res[2][15]=a154;
  if (res[2]!=0) res[2][16]=a171;
  a154=(a033*a171);
  if (res[2]!=0) res[2][17]=a154;
  a106=(a106*a171);
  if (res[2]!=0) res[2][18]=a106;
  a172=(a152*a172);
  if (res[2]!=0) res[2][19]=a172;
  if (res[2]!=0) res[2][20]=a173;
  a033=(a033*a173);
  if (res[2]!=0) res[2][21]=a033;
  a063=(a056*a063);
  a146=(a056*a146);
  a063=(a063+a146);
  a028=(a028/a135);
  a028=(a028*a013);
  a137=(a137/a134);
  a137=(a137*a145);
  a028=(a028-a137);
  a063=(a063+a028);
  if (res[2]!=0) res[2][22]=a063;
  a063=(-a232);
  if (res[2]!=0) res[2][23]=a063;
  a362=(a362*a232);
  a362=(-a362);
  if (res[2]!=0) res[2][24]=a362;
  a157=(a157*a298);
  if (res[2]!=0) res[2][25]=a157;
  a157=(a076*a344);
  if (res[2]!=0) res[2][26]=a157;
  a100=(a100*a344);
  a344=(a395-a071);
  a236=(a236*a276);
  a344=(a344+a236);
  a148=(a148*a018);
  a293=(a293*a148);
  a371=(a152*a371);
  a293=(a293+a371);
  a344=(a344+a293);
  a344=(a344-a259);
  a344=(a344-a306);
  a344=(a344-a376);
  a344=(a344/a076);
  a344=(a344/a076);
  a344=(a344*a005);
  a089=(a089*a391);
  a375=(a375*a405);
  a089=(a089-a375);
  a089=(a089+a016);
  a089=(a089-a300);
  a089=(a089-a277);
  a089=(a089-a297);
  a089=(a089/a076);
  a089=(a089/a076);
  a089=(a089*a256);
  a344=(a344+a089);
  a100=(a100-a344);
  if (res[2]!=0) res[2][27]=a100;
  a165=(a165*a132);
  if (res[2]!=0) res[2][28]=a165;
  a168=(a168*a132);
  if (res[2]!=0) res[2][29]=a168;
  a160=(a160*a262);
  if (res[2]!=0) res[2][30]=a160;
  a016=(a016*a177);
  if (res[2]!=0) res[2][31]=a016;
  a016=(a252+a323);
  if (res[2]!=0) res[2][32]=a016;
  a252=(a180*a252);
  a323=(a180*a323);
  a252=(a252+a323);
  if (res[2]!=0) res[2][33]=a252;
  a252=(a278+a312);
  if (res[2]!=0) res[2][34]=a252;
  a278=(a180*a278);
  a180=(a180*a312);
  a278=(a278+a180);
  if (res[2]!=0) res[2][35]=a278;
  a230=(a230*a320);
  if (res[2]!=0) res[2][36]=a230;
  a205=(a205*a269);
  a208=(a208/a091);
  a208=(a208*a271);
  a205=(a205-a208);
  a209=(a203*a209);
  a205=(a205+a209);
  a241=(a241*a090);
  a205=(a205+a241);
  a264=(a264/a091);
  a264=(a264*a249);
  a205=(a205-a264);
  a092=(a280*a092);
  a205=(a205+a092);
  a096=(a096/a095);
  a251=(a251/a268);
  a251=(a251*a270);
  a202=(a202/a097);
  a202=(a202*a206);
  a251=(a251-a202);
  a315=(a315/a329);
  a315=(a315*a331);
  a251=(a251+a315);
  a240=(a240/a192);
  a240=(a240*a244);
  a251=(a251-a240);
  a096=(a096*a251);
  a251=(a094*a096);
  a205=(a205-a251);
  if (res[2]!=0) res[2][37]=a205;
  a207=(a207*a269);
  a203=(a203*a271);
  a207=(a207-a203);
  a248=(a248*a090);
  a207=(a207+a248);
  a280=(a280*a249);
  a207=(a207-a280);
  a280=(a020<=a093);
  a093=(a093<=a020);
  a093=(a093+a280);
  a280=(a280/a093);
  a091=(a091*a096);
  a094=(2.*a094);
  a091=(a091/a094);
  a280=(a280*a091);
  a207=(a207-a280);
  if (res[2]!=0) res[2][38]=a207;
  a210=(a210*a211);
  a247=(a247*a245);
  a210=(a210+a247);
  if (res[2]!=0) res[2][39]=a210;
  a212=(a212*a214);
  a250=(a250*a282);
  a212=(a212+a250);
  if (res[2]!=0) res[2][40]=a212;
  a332=(a332-a287);
  if (res[2]!=0) res[2][41]=a332;
  a200=(a200*a258);
  if (res[2]!=0) res[2][42]=a200;
  a274=(a274-a219);
  if (res[2]!=0) res[2][43]=a274;
  a286=(a048*a286);
  if (res[2]!=0) res[2][44]=a286;
  a384=(a384*a392);
  a285=(a285*a221);
  a384=(a384+a285);
  a384=(-a384);
  if (res[2]!=0) res[2][45]=a384;
  if (res[2]!=0) res[2][46]=a406;
  a406=(a169*a406);
  if (res[2]!=0) res[2][47]=a406;
  if (res[2]!=0) res[2][48]=a333;
  a169=(a169*a333);
  if (res[2]!=0) res[2][49]=a169;
  a345=(a345*a394);
  if (res[2]!=0) res[2][50]=a345;
  a353=(a353*a301);
  a351=(a351/a295);
  a351=(a351*a349);
  a353=(a353-a351);
  a294=(a348*a294);
  a353=(a353+a294);
  a311=(a311/a313);
  a389=(a389/a401);
  a389=(a389*a403);
  a347=(a347/a309);
  a347=(a347*a062);
  a389=(a389-a347);
  a311=(a311*a389);
  a389=(a325*a311);
  a353=(a353-a389);
  if (res[2]!=0) res[2][51]=a353;
  a350=(a350*a301);
  a348=(a348*a349);
  a350=(a350-a348);
  a348=(a020<=a304);
  a304=(a304<=a020);
  a304=(a304+a348);
  a348=(a348/a304);
  a295=(a295*a311);
  a325=(2.*a325);
  a295=(a295/a325);
  a348=(a348*a295);
  a350=(a350-a348);
  if (res[2]!=0) res[2][52]=a350;
  a355=(a355*a356);
  if (res[2]!=0) res[2][53]=a355;
  a357=(a357*a359);
  if (res[2]!=0) res[2][54]=a357;
  a402=(a402/a346);
  if (res[2]!=0) res[2][55]=a402;
  a048=(a048*a361);
  a048=(-a048);
  if (res[2]!=0) res[2][56]=a048;
  a048=(a235*a228);
  if (res[2]!=0) res[2][57]=a048;
  a077=(a148*a077);
  a048=(a381*a077);
  if (res[2]!=0) res[2][58]=a048;
  a228=(a047*a228);
  if (res[2]!=0) res[2][59]=a228;
  a152=(a152*a324);
  a381=(2.*a381);
  a074=(a148*a074);
  a162=(a162*a074);
  a381=(a381*a162);
  a152=(a152+a381);
  a288=(a288*a077);
  a152=(a152+a288);
  if (res[2]!=0) res[2][60]=a152;
  if (res[2]!=0) res[2][61]=a055;
  if (res[2]!=0) res[2][62]=a055;
  if (res[2]!=0) res[2][63]=a055;
  a303=(a303*a373);
  if (res[2]!=0) res[2][64]=a303;
  a235=(a235*a373);
  if (res[2]!=0) res[2][65]=a235;
  a198=(a198*a074);
  if (res[2]!=0) res[2][66]=a198;
  a373=(a047*a373);
  if (res[2]!=0) res[2][67]=a373;
  a037=(a037*a334);
  a037=(-a037);
  if (res[2]!=0) res[2][68]=a037;
  a034=(a034*a045);
  if (res[2]!=0) res[2][69]=a034;
  a083=(a056*a083);
  a056=(a056*a066);
  a083=(a083+a056);
  a029=(a029/a051);
  a029=(a029*a082);
  a052=(a052/a030);
  a052=(a052*a065);
  a029=(a029-a052);
  a083=(a083+a029);
  if (res[2]!=0) res[2][70]=a083;
  a046=(a046*a081);
  if (res[2]!=0) res[2][71]=a046;
  a047=(a047*a031);
  a047=(-a047);
  if (res[2]!=0) res[2][72]=a047;
  a064=(a064*a069);
  a025=(a025*a064);
  a025=(-a025);
  if (res[2]!=0) res[2][73]=a025;
  a068=(a068*a027);
  a068=(-a068);
  if (res[2]!=0) res[2][74]=a068;
  if (res[2]!=0) res[2][75]=a055;
  if (res[2]!=0) res[2][76]=a055;
  if (res[2]!=0) res[2][77]=a055;
  a279=(a279*a148);
  a231=(a231*a305);
  a279=(a279+a231);
  a071=(a071*a035);
  a395=(a395*a038);
  a071=(a071+a395);
  a279=(a279-a071);
  a318=(a318*a300);
  a279=(a279-a318);
  a254=(a254*a277);
  a279=(a279+a254);
  a306=(a306*a059);
  a279=(a279-a306);
  a376=(a376*a158);
  a279=(a279-a376);
  a059=(a059*a237);
  a279=(a279+a059);
  a279=(a279/a073);
  a279=(a279/a073);
  a279=(a279*a072);
  a279=(-a279);
  if (res[2]!=0) res[2][78]=a279;
  return 0;
}

CASADI_SYMBOL_EXPORT int adj1_rollout_rhs(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f2(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int adj1_rollout_rhs_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void adj1_rollout_rhs_release(int mem) {
}

CASADI_SYMBOL_EXPORT void adj1_rollout_rhs_incref(void) {
}

CASADI_SYMBOL_EXPORT void adj1_rollout_rhs_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int adj1_rollout_rhs_n_in(void) { return 5;}

CASADI_SYMBOL_EXPORT casadi_int adj1_rollout_rhs_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real adj1_rollout_rhs_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* adj1_rollout_rhs_name_in(casadi_int i) {
  switch (i) {
    case 0: return "x";
    case 1: return "u";
    case 2: return "p";
    case 3: return "out_xdot";
    case 4: return "adj_xdot";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* adj1_rollout_rhs_name_out(casadi_int i) {
  switch (i) {
    case 0: return "adj_x";
    case 1: return "adj_u";
    case 2: return "adj_p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* adj1_rollout_rhs_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    case 3: return casadi_s3;
    case 4: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* adj1_rollout_rhs_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int adj1_rollout_rhs_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int adj1_rollout_rhs_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* fwd1_adj1_rollout_rhs:(x[6],u[11],p[79],out_xdot[6x1,0nz],adj_xdot[6],out_adj_x[6x1,0nz],out_adj_u[11x1,0nz],out_adj_p[79x1,0nz],fwd_x[6],fwd_u[11],fwd_p[79],fwd_out_xdot[6x1,0nz],fwd_adj_xdot[6])->(fwd_adj_x[6],fwd_adj_u[11],fwd_adj_p[79]) */
static int casadi_f3(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
  casadi_real a204, a205, a206, a207, a208, a209, a210, a211, a212, a213, a214, a215;
  casadi_real a216, a217, a218, a219, a220, a221, a222, a223, a224, a225, a226, a227;
  casadi_real a228, a229, a230, a231, a232, a233, a234, a235, a236, a237, a238, a239;
  casadi_real a240, a241, a242, a243, a244, a245, a246, a247, a248, a249, a250, a251;
  casadi_real a252, a253, a254, a255, a256, a257, a258, a259, a260, a261, a262, a263;
  casadi_real a264, a265, a266, a267, a268, a269, a270, a271, a272, a273, a274, a275;
  casadi_real a276, a277, a278, a279, a280, a281, a282, a283, a284, a285, a286, a287;
  casadi_real a288, a289, a290, a291, a292, a293, a294, a295, a296, a297, a298, a299;
  casadi_real a300, a301, a302, a303, a304, a305, a306, a307, a308, a309, a310, a311;
  casadi_real a312, a313, a314, a315, a316, a317, a318, a319, a320, a321, a322, a323;
  casadi_real a324, a325, a326, a327, a328, a329, a330, a331, a332, a333, a334, a335;
  casadi_real a336, a337, a338, a339, a340, a341, a342, a343, a344, a345, a346, a347;
  casadi_real a348, a349, a350, a351, a352, a353, a354, a355, a356, a357, a358, a359;
  casadi_real a360, a361, a362, a363, a364, a365, a366, a367, a368, a369, a370, a371;
  casadi_real a372, a373, a374, a375, a376, a377, a378, a379, a380, a381, a382, a383;
  casadi_real a384, a385, a386, a387, a388, a389, a390, a391, a392, a393, a394, a395;
  casadi_real a396, a397, a398, a399, a400, a401, a402, a403, a404, a405, a406, a407;
  casadi_real a408, a409, a410, a411, a412, a413, a414, a415, a416, a417, a418, a419;
  casadi_real a420, a421, a422, a423, a424, a425, a426, a427, a428, a429, a430, a431;
  casadi_real a432, a433, a434, a435, a436, a437, a438, a439, a440, a441, a442, a443;
  casadi_real a444, a445, a446, a447, a448, a449, a450, a451, a452, a453, a454, a455;
  casadi_real a456, a457, a458, a459, a460, a461, a462, a463, a464, a465, a466, a467;
  casadi_real a468, a469, a470, a471, a472, a473, a474, a475, a476, a477, a478, a479;
  casadi_real a480, a481, a482, a483, a484, a485, a486, a487, a488, a489, a490, a491;
  casadi_real a492, a493, a494, a495, a496, a497, a498, a499, a500, a501, a502, a503;
  casadi_real a504, a505, a506, a507, a508, a509, a510, a511, a512, a513, a514, a515;
  casadi_real a516, a517, a518, a519, a520, a521, a522, a523, a524, a525, a526, a527;
  casadi_real a528, a529, a530, a531, a532, a533, a534, a535, a536, a537, a538, a539;
  casadi_real a540, a541, a542, a543, a544, a545, a546, a547, a548, a549, a550, a551;
  casadi_real a552, a553, a554, a555, a556, a557, a558, a559, a560, a561, a562, a563;
  casadi_real a564, a565, a566, a567, a568, a569, a570, a571, a572, a573, a574, a575;
  casadi_real a576, a577, a578, a579, a580, a581, a582, a583, a584, a585, a586, a587;
  casadi_real a588, a589, a590, a591, a592, a593, a594, a595, a596, a597, a598, a599;
  casadi_real a600, a601, a602, a603, a604, a605, a606, a607, a608, a609, a610, a611;
  casadi_real a612, a613, a614, a615, a616, a617, a618, a619, a620, a621, a622, a623;
  casadi_real a624, a625, a626, a627, a628, a629, a630, a631, a632, a633, a634, a635;
  casadi_real a636, a637, a638, a639, a640, a641, a642, a643, a644, a645, a646, a647;
  casadi_real a648, a649, a650, a651, a652, a653, a654, a655, a656, a657, a658, a659;
  casadi_real a660, a661, a662, a663, a664, a665, a666, a667, a668, a669, a670, a671;
  casadi_real a672, a673, a674, a675, a676, a677, a678, a679, a680, a681, a682, a683;
  casadi_real a684, a685, a686, a687, a688, a689, a690, a691, a692, a693, a694, a695;
  casadi_real a696, a697, a698, a699, a700, a701, a702, a703, a704, a705, a706, a707;
  casadi_real a708, a709, a710, a711, a712, a713, a714, a715, a716, a717, a718, a719;
  casadi_real a720, a721, a722, a723, a724, a725, a726, a727, a728, a729, a730, a731;
  casadi_real a732, a733, a734, a735, a736, a737, a738, a739, a740, a741, a742, a743;
  casadi_real a744, a745, a746, a747, a748, a749, a750, a751, a752, a753, a754, a755;
  casadi_real a756, a757, a758, a759, a760, a761, a762, a763, a764, a765, a766, a767;
  casadi_real a768, a769, a770, a771, a772, a773, a774, a775, a776, a777, a778, a779;
  casadi_real a780, a781, a782, a783, a784;
  a000=arg[4]? arg[4][4] : 0;
  a001=arg[0]? arg[0][5] : 0;
  a002=cos(a001);
  a003=arg[8]? arg[8][5] : 0;
  a002=(a002*a003);
  a002=(a000*a002);
  a004=sin(a001);
  a005=arg[12]? arg[12][4] : 0;
  a004=(a004*a005);
  a002=(a002+a004);
  a004=cos(a001);
  a006=arg[12]? arg[12][3] : 0;
  a004=(a004*a006);
  a007=arg[4]? arg[4][3] : 0;
  a008=sin(a001);
  a008=(a008*a003);
  a008=(a007*a008);
  a004=(a004-a008);
  a002=(a002+a004);
  a004=arg[4]? arg[4][1] : 0;
  a008=arg[8]? arg[8][2] : 0;
  a009=(a004*a008);
  a010=arg[0]? arg[0][2] : 0;
  a011=arg[12]? arg[12][1] : 0;
  a012=(a010*a011);
  a009=(a009+a012);
  a002=(a002-a009);
  a009=arg[0]? arg[0][0] : 0;
  a012=arg[1]? arg[1][0] : 0;
  a013=cos(a001);
  a014=(a012*a013);
  a015=arg[1]? arg[1][1] : 0;
  a016=sin(a001);
  a017=(a015*a016);
  a014=(a014+a017);
  a017=(a009-a014);
  a018=casadi_sq(a017);
  a019=1.0000000000000000e-04;
  a018=(a018+a019);
  a018=sqrt(a018);
  a020=(a017*a018);
  a021=arg[1]? arg[1][2] : 0;
  a022=arg[2]? arg[2][6] : 0;
  a023=arg[2]? arg[2][7] : 0;
  a024=casadi_sq(a023);
  a025=9.9999999999999998e-13;
  a024=(a024+a025);
  a024=sqrt(a024);
  a026=(a022*a024);
  a027=(a021/a026);
  a028=(2.*a027);
  a028=(a020+a028);
  a029=(2.*a028);
  a030=5.0000000000000000e-01;
  a031=arg[2]? arg[2][73] : 0;
  a031=(a030*a031);
  a032=arg[2]? arg[2][70] : 0;
  a033=1.0000000000000001e-01;
  a034=(a032+a033);
  a035=(-a034);
  a036=arg[2]? arg[2][71] : 0;
  a037=arg[2]? arg[2][69] : 0;
  a038=arg[2]? arg[2][1] : 0;
  a039=sin(a038);
  a040=(a037*a039);
  a041=arg[2]? arg[2][68] : 0;
  a042=cos(a038);
  a043=(a041*a042);
  a040=(a040-a043);
  a044=(a010*a040);
  a045=arg[0]? arg[0][1] : 0;
  a044=(a044+a045);
  a046=cos(a001);
  a047=(a015*a046);
  a048=sin(a001);
  a049=(a012*a048);
  a047=(a047-a049);
  a044=(a044-a047);
  a020=(a030*a020);
  a020=(a020+a027);
  a049=casadi_sq(a028);
  a050=1.0000000000000000e-08;
  a049=(a049+a050);
  a049=sqrt(a049);
  a051=(a030*a049);
  a020=(a020+a051);
  a051=sqrt(a020);
  a052=atan2(a044,a051);
  a053=arg[1]? arg[1][8] : 0;
  a054=arg[1]? arg[1][6] : 0;
  a055=arg[2]? arg[2][56] : 0;
  a056=(a054*a055);
  a053=(a053-a056);
  a056=arg[2]? arg[2][72] : 0;
  a057=(a053*a056);
  a052=(a052-a057);
  a057=(a036*a052);
  a058=casadi_fmin(a034,a057);
  a059=casadi_fmax(a035,a058);
  a060=2.0000000000000001e-01;
  a061=0.;
  a062=-5.;
  a063=(a062*a032);
  a064=5.;
  a065=(a064*a059);
  a063=(a063-a065);
  a063=(a063+a030);
  a065=casadi_fmax(a061,a063);
  a066=casadi_sq(a065);
  a067=(a065*a066);
  a067=(a060*a067);
  a068=1.;
  a069=(a030*a065);
  a069=(a068-a069);
  a070=(a067*a069);
  a070=(a059+a070);
  a032=(a062*a032);
  a059=(a064*a059);
  a032=(a032+a059);
  a032=(a032+a030);
  a059=casadi_fmax(a061,a032);
  a071=casadi_sq(a059);
  a072=(a059*a071);
  a072=(a060*a072);
  a073=(a030*a059);
  a073=(a068-a073);
  a074=(a072*a073);
  a070=(a070-a074);
  a074=(a031*a070);
  a075=arg[2]? arg[2][74] : 0;
  a076=(a074*a075);
  a077=(a076*a023);
  a078=arg[4]? arg[4][2] : 0;
  a079=arg[2]? arg[2][78] : 0;
  a080=(a078/a079);
  a081=(a040*a080);
  a082=arg[2]? arg[2][27] : 0;
  a083=(a004/a082);
  a081=(a081+a083);
  a084=(a077*a081);
  a085=casadi_sq(a044);
  a085=(a085+a020);
  a086=(a044/a085);
  a087=(a057<=a034);
  a088=(a034<=a057);
  a089=(a088+a087);
  a087=(a087/a089);
  a090=(a035<=a058);
  a091=(a058<=a035);
  a092=(a091+a090);
  a090=(a090/a092);
  a093=(a061<=a032);
  a094=(a032<=a061);
  a094=(a094+a093);
  a093=(a093/a094);
  a094=casadi_sq(a044);
  a094=(a020+a094);
  a095=(a094*a081);
  a096=(a023*a095);
  a097=(a075*a096);
  a098=(a031*a097);
  a099=(a073*a098);
  a099=(a060*a099);
  a100=(a071*a099);
  a101=(a072*a098);
  a101=(a030*a101);
  a100=(a100-a101);
  a101=(2.*a059);
  a102=(a059*a099);
  a103=(a101*a102);
  a100=(a100+a103);
  a100=(a093*a100);
  a100=(a064*a100);
  a100=(a100-a098);
  a103=(a061<=a063);
  a104=(a063<=a061);
  a104=(a104+a103);
  a103=(a103/a104);
  a104=(a067*a098);
  a104=(a030*a104);
  a105=(a069*a098);
  a105=(a060*a105);
  a106=(a066*a105);
  a104=(a104-a106);
  a106=(2.*a065);
  a107=(a065*a105);
  a108=(a106*a107);
  a104=(a104-a108);
  a104=(a103*a104);
  a104=(a064*a104);
  a100=(a100-a104);
  a100=(a090*a100);
  a100=(a087*a100);
  a104=(a036*a100);
  a108=(a086*a104);
  a109=(2.*a051);
  a108=(a108/a109);
  a110=(a084+a108);
  a111=(a030*a110);
  a112=(2.*a049);
  a111=(a111/a112);
  a113=(a029*a111);
  a114=(a030*a110);
  a114=(a113+a114);
  a115=(2.*a017);
  a116=arg[8]? arg[8][0] : 0;
  a117=arg[9]? arg[9][0] : 0;
  a118=(a013*a117);
  a119=sin(a001);
  a119=(a119*a003);
  a120=(a012*a119);
  a118=(a118-a120);
  a120=arg[9]? arg[9][1] : 0;
  a121=(a016*a120);
  a122=cos(a001);
  a122=(a122*a003);
  a123=(a015*a122);
  a121=(a121+a123);
  a118=(a118+a121);
  a121=(a116-a118);
  a115=(a115*a121);
  a123=(2.*a018);
  a115=(a115/a123);
  a123=(a114*a115);
  a124=(a018*a121);
  a125=(a017*a115);
  a124=(a124+a125);
  a125=arg[9]? arg[9][2] : 0;
  a126=(a125/a026);
  a127=(a027/a026);
  a128=arg[10]? arg[10][6] : 0;
  a129=(a024*a128);
  a130=(2.*a023);
  a131=arg[10]? arg[10][7] : 0;
  a130=(a130*a131);
  a132=(2.*a024);
  a130=(a130/a132);
  a132=(a022*a130);
  a129=(a129+a132);
  a127=(a127*a129);
  a126=(a126-a127);
  a127=(2.*a126);
  a127=(a124+a127);
  a132=(2.*a127);
  a132=(a111*a132);
  a133=arg[10]? arg[10][73] : 0;
  a133=(a030*a133);
  a134=(a070*a133);
  a135=(a035<=a058);
  a058=(a058<=a035);
  a035=(a058+a135);
  a135=(a135/a035);
  a136=(a034<=a057);
  a057=(a057<=a034);
  a034=(a136+a057);
  a136=(a136/a034);
  a137=arg[10]? arg[10][70] : 0;
  a136=(a136*a137);
  a057=(a057/a034);
  a034=arg[10]? arg[10][71] : 0;
  a138=(a052*a034);
  a139=casadi_sq(a044);
  a139=(a139+a020);
  a020=(a051/a139);
  a140=(a040*a008);
  a141=arg[10]? arg[10][69] : 0;
  a142=(a039*a141);
  a143=cos(a038);
  a144=arg[10]? arg[10][1] : 0;
  a143=(a143*a144);
  a145=(a037*a143);
  a142=(a142+a145);
  a145=arg[10]? arg[10][68] : 0;
  a146=(a042*a145);
  a147=sin(a038);
  a147=(a147*a144);
  a148=(a041*a147);
  a146=(a146-a148);
  a142=(a142-a146);
  a148=(a010*a142);
  a140=(a140+a148);
  a148=arg[8]? arg[8][1] : 0;
  a140=(a140+a148);
  a149=(a046*a120);
  a150=sin(a001);
  a150=(a150*a003);
  a151=(a015*a150);
  a149=(a149-a151);
  a151=(a048*a117);
  a152=cos(a001);
  a152=(a152*a003);
  a153=(a012*a152);
  a151=(a151+a153);
  a149=(a149-a151);
  a140=(a140-a149);
  a020=(a020*a140);
  a139=(a044/a139);
  a124=(a030*a124);
  a124=(a124+a126);
  a028=(2.*a028);
  a028=(a028*a127);
  a049=(2.*a049);
  a028=(a028/a049);
  a049=(a030*a028);
  a124=(a124+a049);
  a049=(2.*a051);
  a049=(a124/a049);
  a139=(a139*a049);
  a020=(a020-a139);
  a139=arg[9]? arg[9][8] : 0;
  a127=arg[9]? arg[9][6] : 0;
  a151=(a055*a127);
  a153=arg[10]? arg[10][56] : 0;
  a154=(a054*a153);
  a151=(a151+a154);
  a139=(a139-a151);
  a151=(a056*a139);
  a154=arg[10]? arg[10][72] : 0;
  a155=(a053*a154);
  a151=(a151+a155);
  a020=(a020-a151);
  a151=(a036*a020);
  a138=(a138+a151);
  a057=(a057*a138);
  a136=(a136+a057);
  a135=(a135*a136);
  a058=(a058/a035);
  a058=(a058*a137);
  a135=(a135-a058);
  a058=(a061<=a063);
  a063=(a063<=a061);
  a063=(a063+a058);
  a058=(a058/a063);
  a063=(a062*a137);
  a035=(a064*a135);
  a063=(a063-a035);
  a058=(a058*a063);
  a063=(a066*a058);
  a035=(2.*a065);
  a035=(a035*a058);
  a136=(a065*a035);
  a063=(a063+a136);
  a063=(a060*a063);
  a136=(a069*a063);
  a057=(a030*a058);
  a138=(a067*a057);
  a136=(a136-a138);
  a136=(a135+a136);
  a138=(a061<=a032);
  a032=(a032<=a061);
  a032=(a032+a138);
  a138=(a138/a032);
  a137=(a062*a137);
  a135=(a064*a135);
  a137=(a137+a135);
  a138=(a138*a137);
  a137=(a071*a138);
  a135=(2.*a059);
  a135=(a135*a138);
  a032=(a059*a135);
  a137=(a137+a032);
  a137=(a060*a137);
  a032=(a073*a137);
  a151=(a030*a138);
  a155=(a072*a151);
  a032=(a032-a155);
  a136=(a136-a032);
  a032=(a031*a136);
  a134=(a134+a032);
  a032=(a075*a134);
  a155=arg[10]? arg[10][74] : 0;
  a156=(a074*a155);
  a032=(a032+a156);
  a156=(a023*a032);
  a157=(a076*a131);
  a156=(a156+a157);
  a157=(a081*a156);
  a158=(a080*a142);
  a159=arg[12]? arg[12][2] : 0;
  a160=(a159/a079);
  a161=(a080/a079);
  a162=arg[10]? arg[10][78] : 0;
  a161=(a161*a162);
  a160=(a160-a161);
  a161=(a040*a160);
  a158=(a158+a161);
  a161=(a011/a082);
  a163=(a083/a082);
  a164=arg[10]? arg[10][27] : 0;
  a163=(a163*a164);
  a161=(a161-a163);
  a158=(a158+a161);
  a163=(a077*a158);
  a157=(a157+a163);
  a163=(a140/a085);
  a165=(a086/a085);
  a166=(2.*a044);
  a166=(a166*a140);
  a166=(a166+a124);
  a165=(a165*a166);
  a163=(a163-a165);
  a163=(a104*a163);
  a034=(a100*a034);
  a135=(a099*a135);
  a133=(a097*a133);
  a155=(a096*a155);
  a165=(a095*a131);
  a167=(2.*a044);
  a167=(a167*a140);
  a124=(a124+a167);
  a081=(a081*a124);
  a158=(a094*a158);
  a081=(a081+a158);
  a158=(a023*a081);
  a165=(a165+a158);
  a075=(a075*a165);
  a155=(a155+a075);
  a031=(a031*a155);
  a133=(a133+a031);
  a073=(a073*a133);
  a151=(a098*a151);
  a073=(a073-a151);
  a073=(a060*a073);
  a071=(a071*a073);
  a135=(a135+a071);
  a137=(a098*a137);
  a072=(a072*a133);
  a137=(a137+a072);
  a137=(a030*a137);
  a135=(a135-a137);
  a137=(2.*a138);
  a102=(a102*a137);
  a099=(a099*a138);
  a059=(a059*a073);
  a099=(a099+a059);
  a101=(a101*a099);
  a102=(a102+a101);
  a135=(a135+a102);
  a093=(a093*a135);
  a135=(a064*a093);
  a135=(a135-a133);
  a063=(a098*a063);
  a067=(a067*a133);
  a063=(a063+a067);
  a063=(a030*a063);
  a035=(a105*a035);
  a069=(a069*a133);
  a098=(a098*a057);
  a069=(a069-a098);
  a069=(a060*a069);
  a066=(a066*a069);
  a035=(a035+a066);
  a063=(a063-a035);
  a035=(2.*a058);
  a107=(a107*a035);
  a105=(a105*a058);
  a065=(a065*a069);
  a105=(a105+a065);
  a106=(a106*a105);
  a107=(a107+a106);
  a063=(a063-a107);
  a103=(a103*a063);
  a063=(a064*a103);
  a135=(a135-a063);
  a090=(a090*a135);
  a087=(a087*a090);
  a036=(a036*a087);
  a034=(a034+a036);
  a086=(a086*a034);
  a163=(a163+a086);
  a163=(a163/a109);
  a108=(a108/a109);
  a109=(2.*a049);
  a108=(a108*a109);
  a163=(a163-a108);
  a163=(a157+a163);
  a108=(a030*a163);
  a108=(a108/a112);
  a111=(a111/a112);
  a028=(2.*a028);
  a111=(a111*a028);
  a108=(a108-a111);
  a029=(a029*a108);
  a132=(a132+a029);
  a029=(a030*a163);
  a029=(a132+a029);
  a108=(a018*a029);
  a123=(a123+a108);
  a108=(a017*a114);
  a111=(2.*a018);
  a108=(a108/a111);
  a028=(2.*a121);
  a028=(a108*a028);
  a112=(2.*a017);
  a121=(a114*a121);
  a017=(a017*a029);
  a121=(a121+a017);
  a121=(a121/a111);
  a111=(a108/a111);
  a115=(2.*a115);
  a111=(a111*a115);
  a121=(a121-a111);
  a121=(a112*a121);
  a028=(a028+a121);
  a123=(a123+a028);
  a002=(a002-a123);
  a028=arg[2]? arg[2][0] : 0;
  a121=cos(a038);
  a111=(a028*a121);
  a115=arg[2]? arg[2][4] : 0;
  a017=sin(a038);
  a029=(a115*a017);
  a111=(a111+a029);
  a029=(a010*a111);
  a029=(a029+a045);
  a109=arg[2]? arg[2][2] : 0;
  a086=cos(a109);
  a036=(a029*a086);
  a063=(a030*a010);
  a107=arg[2]? arg[2][3] : 0;
  a106=(a063*a107);
  a105=(a009-a106);
  a065=sin(a109);
  a069=(a105*a065);
  a036=(a036+a069);
  a069=(2.*a036);
  a058=arg[2]? arg[2][40] : 0;
  a035=arg[2]? arg[2][39] : 0;
  a066=arg[2]? arg[2][37] : 0;
  a098=arg[2]? arg[2][38] : 0;
  a057=(a098-a068);
  a133=casadi_fmax(a025,a057);
  a133=sqrt(a133);
  a067=(a066*a133);
  a102=(1./a067);
  a101=(-a102);
  a099=arg[2]? arg[2][32] : 0;
  a059=arg[2]? arg[2][33] : 0;
  a073=arg[2]? arg[2][26] : 0;
  a138=(a073*a082);
  a137=arg[2]? arg[2][12] : 0;
  a072=(a137+a033);
  a071=(-a072);
  a151=arg[2]? arg[2][11] : 0;
  a031=arg[1]? arg[1][3] : 0;
  a075=arg[2]? arg[2][10] : 0;
  a158=(a031*a075);
  a167=arg[2]? arg[2][9] : 0;
  a158=(a158+a167);
  a167=arg[2]? arg[2][8] : 0;
  a167=(a068-a167);
  a168=(a009-a014);
  a169=casadi_sq(a168);
  a169=(a169+a019);
  a169=sqrt(a169);
  a019=(a168*a169);
  a170=(a030*a019);
  a170=(a170+a027);
  a171=(2.*a027);
  a019=(a019+a171);
  a171=casadi_sq(a019);
  a171=(a171+a050);
  a171=sqrt(a171);
  a172=(a030*a171);
  a170=(a170+a172);
  a172=sqrt(a170);
  a172=atan2(a061,a172);
  a172=(a038+a172);
  a173=(a167*a172);
  a158=(a158+a173);
  a173=(a151*a158);
  a174=casadi_fmin(a072,a173);
  a175=casadi_fmax(a071,a174);
  a176=(a062*a137);
  a177=(a064*a175);
  a176=(a176-a177);
  a176=(a176+a030);
  a177=casadi_fmax(a061,a176);
  a178=casadi_sq(a177);
  a179=(a177*a178);
  a179=(a060*a179);
  a180=(a030*a177);
  a180=(a068-a180);
  a181=(a179*a180);
  a181=(a175+a181);
  a137=(a062*a137);
  a175=(a064*a175);
  a137=(a137+a175);
  a137=(a137+a030);
  a175=casadi_fmax(a061,a137);
  a182=casadi_sq(a175);
  a183=(a175*a182);
  a183=(a060*a183);
  a184=(a030*a175);
  a184=(a068-a184);
  a185=(a183*a184);
  a181=(a181-a185);
  a181=(a030*a181);
  a185=arg[2]? arg[2][13] : 0;
  a186=(a181*a185);
  a187=(a186*a023);
  a188=arg[2]? arg[2][14] : 0;
  a189=(a187*a188);
  a190=(a189*a170);
  a138=(a138-a190);
  a191=arg[2]? arg[2][22] : 0;
  a033=(a191+a033);
  a192=(-a033);
  a193=arg[2]? arg[2][20] : 0;
  a194=arg[2]? arg[2][21] : 0;
  a195=(a194*a038);
  a193=(a193+a195);
  a195=casadi_fmin(a033,a193);
  a196=casadi_fmax(a192,a195);
  a197=(a062*a191);
  a198=(a064*a196);
  a197=(a197-a198);
  a197=(a197+a030);
  a198=casadi_fmax(a061,a197);
  a199=casadi_sq(a198);
  a200=(a198*a199);
  a200=(a060*a200);
  a201=(a030*a198);
  a201=(a068-a201);
  a202=(a200*a201);
  a202=(a196+a202);
  a191=(a062*a191);
  a196=(a064*a196);
  a191=(a191+a196);
  a191=(a191+a030);
  a196=casadi_fmax(a061,a191);
  a203=casadi_sq(a196);
  a204=(a196*a203);
  a204=(a060*a204);
  a205=(a030*a196);
  a205=(a068-a205);
  a206=(a204*a205);
  a202=(a202-a206);
  a206=arg[2]? arg[2][15] : 0;
  a207=(a030*a206);
  a014=(a009-a014);
  a208=casadi_sq(a014);
  a208=(a208+a050);
  a047=(a045-a047);
  a050=casadi_sq(a047);
  a050=(a208+a050);
  a209=(a207*a050);
  a210=(a209*a023);
  a211=(a202*a210);
  a212=(a211*a014);
  a213=sqrt(a208);
  a212=(a212/a213);
  a138=(a138-a212);
  a214=arg[2]? arg[2][25] : 0;
  a215=cos(a038);
  a216=(a214*a215);
  a217=arg[2]? arg[2][30] : 0;
  a218=sin(a038);
  a219=(a217*a218);
  a220=(a216+a219);
  a221=(a138*a220);
  a222=arg[2]? arg[2][28] : 0;
  a223=cos(a038);
  a224=(a222*a223);
  a225=arg[2]? arg[2][29] : 0;
  a226=sin(a038);
  a227=(a225*a226);
  a224=(a224+a227);
  a227=(a190*a224);
  a228=arg[2]? arg[2][19] : 0;
  a229=(a228*a210);
  a230=arg[2]? arg[2][16] : 0;
  a231=arg[2]? arg[2][17] : 0;
  a232=(a231*a038);
  a230=(a230+a232);
  a232=arg[2]? arg[2][18] : 0;
  a233=(a232*a031);
  a230=(a230+a233);
  a233=(a229*a230);
  a227=(a227+a233);
  a233=arg[2]? arg[2][31] : 0;
  a234=(a021*a233);
  a235=cos(a038);
  a236=(a234*a235);
  a227=(a227+a236);
  a221=(a221+a227);
  a221=(a030*a221);
  a236=(a216+a219);
  a236=(a111-a236);
  a221=(a221/a236);
  a237=(-a221);
  a238=casadi_fmax(a061,a237);
  a239=(a059*a238);
  a239=(a099+a239);
  a240=casadi_fmax(a061,a239);
  a241=(a009-a106);
  a242=cos(a109);
  a243=(a241*a242);
  a244=sin(a109);
  a245=(a029*a244);
  a243=(a243-a245);
  a246=casadi_sq(a243);
  a247=9.9999999999999995e-07;
  a248=arg[2]? arg[2][5] : 0;
  a249=casadi_sq(a248);
  a249=(a247*a249);
  a246=(a246+a249);
  a250=sqrt(a246);
  a251=(a036/a250);
  a252=(a240*a251);
  a253=arg[2]? arg[2][42] : 0;
  a254=1.0000000000000000e-03;
  a255=arg[2]? arg[2][34] : 0;
  a256=arg[2]? arg[2][35] : 0;
  a257=(a256*a238);
  a257=(a255+a257);
  a258=casadi_fmax(a254,a257);
  a259=(a253*a258);
  a252=(a252/a259);
  a260=casadi_fmin(a252,a102);
  a261=casadi_fmax(a101,a260);
  a262=(a068-a098);
  a263=(a261*a262);
  a264=(a066*a261);
  a265=atan(a264);
  a266=(a098*a265);
  a266=(a266/a066);
  a263=(a263+a266);
  a267=(a066*a263);
  a268=atan(a267);
  a269=(a035*a268);
  a270=sin(a269);
  a271=(a058*a270);
  a272=casadi_sq(a036);
  a272=(a272+a246);
  a272=sqrt(a272);
  a246=(a271*a272);
  a273=casadi_sq(a248);
  a274=casadi_sq(a273);
  a275=casadi_sq(a243);
  a276=casadi_sq(a036);
  a275=(a275+a276);
  a276=casadi_sq(a275);
  a274=(a274+a276);
  a274=sqrt(a274);
  a276=sqrt(a274);
  a246=(a246/a276);
  a277=arg[1]? arg[1][5] : 0;
  a278=arg[2]? arg[2][43] : 0;
  a279=(a259-a278);
  a280=(a277*a279);
  a280=(a280+a278);
  a280=(a280/a259);
  a278=5.0000000000000004e-06;
  a281=(a280+a278);
  a282=(-a281);
  a283=(a243/a276);
  a284=casadi_fmin(a281,a283);
  a285=casadi_fmax(a282,a284);
  a286=1.0000000000000001e-05;
  a287=-100000.;
  a288=(a287*a280);
  a289=100000.;
  a290=(a289*a285);
  a288=(a288-a290);
  a288=(a288+a030);
  a290=casadi_fmax(a061,a288);
  a291=casadi_sq(a290);
  a292=(a290*a291);
  a292=(a286*a292);
  a293=(a030*a290);
  a293=(a068-a293);
  a294=(a292*a293);
  a294=(a285+a294);
  a295=(a287*a280);
  a285=(a289*a285);
  a295=(a295+a285);
  a295=(a295+a030);
  a285=casadi_fmax(a061,a295);
  a296=casadi_sq(a285);
  a297=(a285*a296);
  a297=(a286*a297);
  a298=(a030*a285);
  a298=(a068-a298);
  a299=(a297*a298);
  a294=(a294-a299);
  a299=casadi_sq(a294);
  a299=(a068-a299);
  a299=sqrt(a299);
  a300=(a299+a278);
  a301=(a246<=a300);
  a302=(a300<=a246);
  a303=(a302+a301);
  a301=(a301/a303);
  a304=(-a300);
  a305=casadi_fmin(a300,a246);
  a306=(a304<=a305);
  a307=(a305<=a304);
  a308=(a307+a306);
  a306=(a306/a308);
  a309=(a287*a299);
  a310=casadi_fmax(a304,a305);
  a311=(a289*a310);
  a309=(a309+a311);
  a309=(a309+a030);
  a311=(a061<=a309);
  a312=(a309<=a061);
  a312=(a312+a311);
  a311=(a311/a312);
  a312=casadi_fmax(a061,a309);
  a313=casadi_sq(a312);
  a314=(a312*a313);
  a314=(a286*a314);
  a315=sin(a109);
  a316=(a030*a107);
  a317=(a316*a080);
  a318=arg[4]? arg[4][0] : 0;
  a319=(a318/a082);
  a317=(a317-a319);
  a320=(a315*a317);
  a321=cos(a109);
  a322=(a111*a080);
  a323=(a322+a083);
  a324=(a321*a323);
  a320=(a320-a324);
  a324=(a259*a320);
  a325=(a238*a324);
  a326=(a314*a325);
  a326=(a030*a326);
  a327=(a030*a312);
  a327=(a068-a327);
  a328=(a327*a325);
  a328=(a286*a328);
  a329=(a313*a328);
  a326=(a326-a329);
  a329=(2.*a312);
  a330=(a312*a328);
  a331=(a329*a330);
  a326=(a326-a331);
  a326=(a311*a326);
  a331=(a289*a326);
  a331=(a331+a325);
  a332=(a287*a299);
  a333=(a289*a310);
  a332=(a332-a333);
  a332=(a332+a030);
  a333=(a061<=a332);
  a334=(a332<=a061);
  a334=(a334+a333);
  a333=(a333/a334);
  a334=casadi_fmax(a061,a332);
  a335=casadi_sq(a334);
  a336=(a030*a334);
  a336=(a068-a336);
  a337=(a336*a325);
  a337=(a286*a337);
  a338=(a335*a337);
  a339=(a334*a335);
  a339=(a286*a339);
  a340=(a339*a325);
  a340=(a030*a340);
  a338=(a338-a340);
  a340=(2.*a334);
  a341=(a334*a337);
  a342=(a340*a341);
  a338=(a338+a342);
  a338=(a333*a338);
  a342=(a289*a338);
  a331=(a331-a342);
  a342=(a306*a331);
  a343=(a301*a342);
  a344=(a343/a276);
  a345=(a271*a344);
  a346=(2.*a272);
  a345=(a345/a346);
  a347=(a069*a345);
  a348=(a252<=a102);
  a349=(a102<=a252);
  a350=(a348+a349);
  a348=(a348/a350);
  a351=(a101<=a260);
  a352=(a260<=a101);
  a353=(a352+a351);
  a351=(a351/a353);
  a354=cos(a269);
  a355=(a272*a344);
  a356=(a058*a355);
  a357=(a354*a356);
  a358=(a035*a357);
  a359=casadi_sq(a267);
  a359=(a068+a359);
  a358=(a358/a359);
  a360=(a098*a358);
  a361=casadi_sq(a264);
  a361=(a068+a361);
  a360=(a360/a361);
  a362=(a066*a360);
  a363=(a066*a358);
  a364=(a262*a363);
  a362=(a362+a364);
  a364=(a351*a362);
  a365=(a348*a364);
  a366=(a365/a259);
  a367=(a240*a366);
  a368=(a367/a250);
  a347=(a347+a368);
  a369=(2.*a036);
  a370=(2.*a275);
  a371=(a246/a276);
  a372=(a371*a343);
  a373=(a283/a276);
  a374=(a283<=a281);
  a375=(a281<=a283);
  a376=(a375+a374);
  a374=(a374/a376);
  a377=(a282<=a284);
  a378=(a284<=a282);
  a379=(a378+a377);
  a377=(a377/a379);
  a380=(a061<=a295);
  a381=(a295<=a061);
  a381=(a381+a380);
  a380=(a380/a381);
  a381=sin(a109);
  a382=(a381*a322);
  a383=sin(a109);
  a384=(a383*a083);
  a382=(a382+a384);
  a384=cos(a109);
  a385=(a384*a317);
  a382=(a382+a385);
  a385=(a259*a382);
  a386=(a238*a385);
  a387=(2.*a294);
  a326=(a287*a326);
  a338=(a287*a338);
  a326=(a326+a338);
  a302=(a302/a303);
  a342=(a302*a342);
  a307=(a307/a308);
  a331=(a307*a331);
  a342=(a342-a331);
  a326=(a326+a342);
  a342=(2.*a299);
  a326=(a326/a342);
  a331=(a387*a326);
  a386=(a386-a331);
  a331=(a297*a386);
  a331=(a030*a331);
  a308=(a298*a386);
  a308=(a286*a308);
  a303=(a296*a308);
  a331=(a331-a303);
  a303=(2.*a285);
  a338=(a285*a308);
  a388=(a303*a338);
  a331=(a331-a388);
  a331=(a380*a331);
  a388=(a289*a331);
  a388=(a388+a386);
  a389=(a061<=a288);
  a390=(a288<=a061);
  a390=(a390+a389);
  a389=(a389/a390);
  a390=(a293*a386);
  a390=(a286*a390);
  a391=(a291*a390);
  a392=(a292*a386);
  a392=(a030*a392);
  a391=(a391-a392);
  a392=(2.*a290);
  a393=(a290*a390);
  a394=(a392*a393);
  a391=(a391+a394);
  a391=(a389*a391);
  a394=(a289*a391);
  a388=(a388-a394);
  a394=(a377*a388);
  a395=(a374*a394);
  a396=(a373*a395);
  a372=(a372+a396);
  a396=(2.*a276);
  a372=(a372/a396);
  a397=(2.*a274);
  a398=(a372/a397);
  a399=(a370*a398);
  a400=(a369*a399);
  a347=(a347-a400);
  a400=cos(a109);
  a401=arg[10]? arg[10][2] : 0;
  a400=(a400*a401);
  a402=(a347*a400);
  a403=(a111*a008);
  a404=arg[10]? arg[10][0] : 0;
  a405=(a121*a404);
  a406=sin(a038);
  a406=(a406*a144);
  a407=(a028*a406);
  a405=(a405-a407);
  a407=arg[10]? arg[10][4] : 0;
  a408=(a017*a407);
  a409=cos(a038);
  a409=(a409*a144);
  a410=(a115*a409);
  a408=(a408+a410);
  a405=(a405+a408);
  a408=(a010*a405);
  a403=(a403+a408);
  a403=(a403+a148);
  a408=(a086*a403);
  a410=sin(a109);
  a410=(a410*a401);
  a411=(a029*a410);
  a408=(a408-a411);
  a411=(a030*a008);
  a412=(a107*a411);
  a413=arg[10]? arg[10][3] : 0;
  a414=(a063*a413);
  a412=(a412+a414);
  a414=(a116-a412);
  a415=(a065*a414);
  a400=(a105*a400);
  a415=(a415+a400);
  a408=(a408+a415);
  a415=(2.*a408);
  a415=(a345*a415);
  a400=arg[10]? arg[10][40] : 0;
  a416=(a270*a400);
  a417=cos(a269);
  a418=arg[10]? arg[10][39] : 0;
  a419=(a268*a418);
  a420=arg[10]? arg[10][37] : 0;
  a421=(a263*a420);
  a422=(a260<=a101);
  a101=(a101<=a260);
  a260=(a422+a101);
  a422=(a422/a260);
  a423=(a102/a067);
  a424=(a133*a420);
  a425=(a025<=a057);
  a426=(a057<=a025);
  a426=(a426+a425);
  a425=(a425/a426);
  a426=arg[10]? arg[10][38] : 0;
  a425=(a425*a426);
  a427=(2.*a133);
  a425=(a425/a427);
  a427=(a066*a425);
  a424=(a424+a427);
  a423=(a423*a424);
  a422=(a422*a423);
  a101=(a101/a260);
  a260=(a252<=a102);
  a427=(a102<=a252);
  a428=(a260+a427);
  a260=(a260/a428);
  a429=(a061<=a239);
  a430=(a239<=a061);
  a430=(a430+a429);
  a429=(a429/a430);
  a430=arg[10]? arg[10][32] : 0;
  a431=arg[10]? arg[10][33] : 0;
  a432=(a238*a431);
  a433=(a061<=a237);
  a434=(a237<=a061);
  a434=(a434+a433);
  a433=(a433/a434);
  a434=arg[10]? arg[10][26] : 0;
  a435=(a082*a434);
  a436=(a073*a164);
  a435=(a435+a436);
  a436=(a071<=a174);
  a437=(a174<=a071);
  a438=(a437+a436);
  a436=(a436/a438);
  a439=(a072<=a173);
  a440=(a173<=a072);
  a441=(a439+a440);
  a439=(a439/a441);
  a442=arg[10]? arg[10][12] : 0;
  a439=(a439*a442);
  a440=(a440/a441);
  a441=arg[10]? arg[10][11] : 0;
  a443=(a158*a441);
  a444=arg[9]? arg[9][3] : 0;
  a445=(a075*a444);
  a446=arg[10]? arg[10][10] : 0;
  a447=(a031*a446);
  a445=(a445+a447);
  a447=arg[10]? arg[10][9] : 0;
  a445=(a445+a447);
  a447=(a167*a144);
  a448=arg[10]? arg[10][8] : 0;
  a449=(a172*a448);
  a447=(a447-a449);
  a445=(a445+a447);
  a447=(a151*a445);
  a443=(a443+a447);
  a440=(a440*a443);
  a439=(a439+a440);
  a436=(a436*a439);
  a437=(a437/a438);
  a437=(a437*a442);
  a436=(a436-a437);
  a437=(a061<=a176);
  a438=(a176<=a061);
  a438=(a438+a437);
  a437=(a437/a438);
  a438=(a062*a442);
  a439=(a064*a436);
  a438=(a438-a439);
  a437=(a437*a438);
  a438=(a178*a437);
  a439=(2.*a177);
  a439=(a439*a437);
  a440=(a177*a439);
  a438=(a438+a440);
  a438=(a060*a438);
  a440=(a180*a438);
  a443=(a030*a437);
  a447=(a179*a443);
  a440=(a440-a447);
  a440=(a436+a440);
  a447=(a061<=a137);
  a449=(a137<=a061);
  a449=(a449+a447);
  a447=(a447/a449);
  a442=(a062*a442);
  a436=(a064*a436);
  a442=(a442+a436);
  a447=(a447*a442);
  a442=(a182*a447);
  a436=(2.*a175);
  a436=(a436*a447);
  a449=(a175*a436);
  a442=(a442+a449);
  a442=(a060*a442);
  a449=(a184*a442);
  a450=(a030*a447);
  a451=(a183*a450);
  a449=(a449-a451);
  a440=(a440-a449);
  a440=(a030*a440);
  a449=(a185*a440);
  a451=arg[10]? arg[10][13] : 0;
  a452=(a181*a451);
  a449=(a449+a452);
  a452=(a023*a449);
  a453=(a186*a131);
  a452=(a452+a453);
  a453=(a188*a452);
  a454=arg[10]? arg[10][14] : 0;
  a455=(a187*a454);
  a453=(a453+a455);
  a455=(a170*a453);
  a456=(a116-a118);
  a457=(a169*a456);
  a458=(2.*a168);
  a458=(a458*a456);
  a459=(2.*a169);
  a458=(a458/a459);
  a459=(a168*a458);
  a457=(a457+a459);
  a459=(a030*a457);
  a459=(a459+a126);
  a460=(2.*a019);
  a461=(2.*a126);
  a457=(a457+a461);
  a460=(a460*a457);
  a461=(2.*a171);
  a460=(a460/a461);
  a461=(a030*a460);
  a459=(a459+a461);
  a461=(a189*a459);
  a455=(a455+a461);
  a435=(a435-a455);
  a461=(a192<=a195);
  a462=(a195<=a192);
  a463=(a462+a461);
  a461=(a461/a463);
  a464=(a033<=a193);
  a465=(a193<=a033);
  a466=(a464+a465);
  a464=(a464/a466);
  a467=arg[10]? arg[10][22] : 0;
  a464=(a464*a467);
  a465=(a465/a466);
  a466=arg[10]? arg[10][20] : 0;
  a468=arg[10]? arg[10][21] : 0;
  a469=(a038*a468);
  a470=(a194*a144);
  a469=(a469+a470);
  a466=(a466+a469);
  a465=(a465*a466);
  a464=(a464+a465);
  a461=(a461*a464);
  a462=(a462/a463);
  a462=(a462*a467);
  a461=(a461-a462);
  a462=(a061<=a197);
  a463=(a197<=a061);
  a463=(a463+a462);
  a462=(a462/a463);
  a463=(a062*a467);
  a464=(a064*a461);
  a463=(a463-a464);
  a462=(a462*a463);
  a463=(a199*a462);
  a464=(2.*a198);
  a464=(a464*a462);
  a465=(a198*a464);
  a463=(a463+a465);
  a463=(a060*a463);
  a465=(a201*a463);
  a466=(a030*a462);
  a469=(a200*a466);
  a465=(a465-a469);
  a465=(a461+a465);
  a469=(a061<=a191);
  a470=(a191<=a061);
  a470=(a470+a469);
  a469=(a469/a470);
  a467=(a062*a467);
  a461=(a064*a461);
  a467=(a467+a461);
  a469=(a469*a467);
  a467=(a203*a469);
  a461=(2.*a196);
  a461=(a461*a469);
  a470=(a196*a461);
  a467=(a467+a470);
  a467=(a060*a467);
  a470=(a205*a467);
  a471=(a030*a469);
  a472=(a204*a471);
  a470=(a470-a472);
  a465=(a465-a470);
  a470=(a210*a465);
  a472=arg[10]? arg[10][15] : 0;
  a473=(a030*a472);
  a474=(a050*a473);
  a475=(2.*a014);
  a118=(a116-a118);
  a475=(a475*a118);
  a476=(2.*a047);
  a149=(a148-a149);
  a476=(a476*a149);
  a476=(a475+a476);
  a477=(a207*a476);
  a474=(a474+a477);
  a477=(a023*a474);
  a478=(a209*a131);
  a477=(a477+a478);
  a478=(a202*a477);
  a470=(a470+a478);
  a478=(a014*a470);
  a479=(a211*a118);
  a478=(a478+a479);
  a478=(a478/a213);
  a479=(a212/a213);
  a480=(2.*a213);
  a480=(a475/a480);
  a479=(a479*a480);
  a478=(a478-a479);
  a435=(a435-a478);
  a479=(a220*a435);
  a481=arg[10]? arg[10][25] : 0;
  a482=(a215*a481);
  a483=sin(a038);
  a483=(a483*a144);
  a484=(a214*a483);
  a482=(a482-a484);
  a484=arg[10]? arg[10][30] : 0;
  a485=(a218*a484);
  a486=cos(a038);
  a486=(a486*a144);
  a487=(a217*a486);
  a485=(a485+a487);
  a487=(a482+a485);
  a488=(a138*a487);
  a479=(a479+a488);
  a488=(a224*a455);
  a489=arg[10]? arg[10][28] : 0;
  a490=(a223*a489);
  a491=sin(a038);
  a491=(a491*a144);
  a492=(a222*a491);
  a490=(a490-a492);
  a492=arg[10]? arg[10][29] : 0;
  a493=(a226*a492);
  a494=cos(a038);
  a494=(a494*a144);
  a495=(a225*a494);
  a493=(a493+a495);
  a490=(a490+a493);
  a493=(a190*a490);
  a488=(a488+a493);
  a493=arg[10]? arg[10][19] : 0;
  a495=(a210*a493);
  a496=(a228*a477);
  a495=(a495+a496);
  a496=(a230*a495);
  a497=arg[10]? arg[10][16] : 0;
  a498=arg[10]? arg[10][17] : 0;
  a499=(a038*a498);
  a500=(a231*a144);
  a499=(a499+a500);
  a497=(a497+a499);
  a499=arg[10]? arg[10][18] : 0;
  a500=(a031*a499);
  a501=(a232*a444);
  a500=(a500+a501);
  a497=(a497+a500);
  a500=(a229*a497);
  a496=(a496+a500);
  a488=(a488+a496);
  a496=(a233*a125);
  a500=arg[10]? arg[10][31] : 0;
  a501=(a021*a500);
  a496=(a496+a501);
  a501=(a235*a496);
  a502=sin(a038);
  a502=(a502*a144);
  a503=(a234*a502);
  a501=(a501-a503);
  a488=(a488+a501);
  a479=(a479+a488);
  a479=(a030*a479);
  a479=(a479/a236);
  a501=(a221/a236);
  a503=(a482+a485);
  a503=(a405-a503);
  a501=(a501*a503);
  a479=(a479-a501);
  a433=(a433*a479);
  a501=(a059*a433);
  a432=(a432-a501);
  a432=(a430+a432);
  a429=(a429*a432);
  a432=(a251*a429);
  a501=(a408/a250);
  a504=(a251/a250);
  a505=(2.*a243);
  a506=(a116-a412);
  a507=(a242*a506);
  a508=sin(a109);
  a508=(a508*a401);
  a509=(a241*a508);
  a507=(a507-a509);
  a509=(a244*a403);
  a510=cos(a109);
  a510=(a510*a401);
  a511=(a029*a510);
  a509=(a509+a511);
  a507=(a507-a509);
  a505=(a505*a507);
  a511=(2.*a248);
  a512=arg[10]? arg[10][5] : 0;
  a511=(a511*a512);
  a511=(a247*a511);
  a505=(a505+a511);
  a513=(2.*a250);
  a513=(a505/a513);
  a504=(a504*a513);
  a501=(a501-a504);
  a504=(a240*a501);
  a432=(a432+a504);
  a432=(a432/a259);
  a504=(a252/a259);
  a514=arg[10]? arg[10][42] : 0;
  a515=(a258*a514);
  a516=(a254<=a257);
  a517=(a257<=a254);
  a517=(a517+a516);
  a516=(a516/a517);
  a517=arg[10]? arg[10][34] : 0;
  a518=arg[10]? arg[10][35] : 0;
  a519=(a238*a518);
  a520=(a256*a433);
  a519=(a519-a520);
  a519=(a517+a519);
  a516=(a516*a519);
  a519=(a253*a516);
  a515=(a515+a519);
  a504=(a504*a515);
  a432=(a432-a504);
  a260=(a260*a432);
  a427=(a427/a428);
  a427=(a427*a423);
  a260=(a260-a427);
  a101=(a101*a260);
  a422=(a422+a101);
  a101=(a262*a422);
  a260=(a261*a426);
  a101=(a101-a260);
  a260=(a265*a426);
  a427=(a261*a420);
  a428=(a066*a422);
  a427=(a427+a428);
  a428=casadi_sq(a264);
  a428=(a068+a428);
  a428=(a427/a428);
  a504=(a098*a428);
  a260=(a260+a504);
  a260=(a260/a066);
  a504=(a266/a066);
  a504=(a504*a420);
  a260=(a260-a504);
  a101=(a101+a260);
  a504=(a066*a101);
  a421=(a421+a504);
  a504=casadi_sq(a267);
  a504=(a068+a504);
  a504=(a421/a504);
  a519=(a035*a504);
  a419=(a419+a519);
  a417=(a417*a419);
  a519=(a058*a417);
  a416=(a416+a519);
  a519=(a344*a416);
  a520=(a061<=a309);
  a309=(a309<=a061);
  a309=(a309+a520);
  a520=(a520/a309);
  a309=(a305<=a304);
  a304=(a304<=a305);
  a305=(a309+a304);
  a309=(a309/a305);
  a521=(2.*a294);
  a522=(a282<=a284);
  a284=(a284<=a282);
  a282=(a284+a522);
  a522=(a522/a282);
  a523=(a281<=a283);
  a281=(a283<=a281);
  a524=(a523+a281);
  a523=(a523/a524);
  a525=arg[9]? arg[9][5] : 0;
  a526=(a279*a525);
  a527=arg[10]? arg[10][43] : 0;
  a528=(a515-a527);
  a529=(a277*a528);
  a526=(a526+a529);
  a526=(a526+a527);
  a526=(a526/a259);
  a527=(a280/a259);
  a527=(a527*a515);
  a526=(a526-a527);
  a523=(a523*a526);
  a281=(a281/a524);
  a524=(a507/a276);
  a283=(a283/a276);
  a527=(2.*a273);
  a529=(2.*a248);
  a529=(a529*a512);
  a527=(a527*a529);
  a275=(2.*a275);
  a530=(2.*a243);
  a530=(a530*a507);
  a531=(2.*a036);
  a531=(a531*a408);
  a530=(a530+a531);
  a275=(a275*a530);
  a527=(a527+a275);
  a274=(2.*a274);
  a527=(a527/a274);
  a274=(2.*a276);
  a274=(a527/a274);
  a283=(a283*a274);
  a524=(a524-a283);
  a281=(a281*a524);
  a523=(a523+a281);
  a522=(a522*a523);
  a284=(a284/a282);
  a284=(a284*a526);
  a522=(a522-a284);
  a284=(a061<=a288);
  a288=(a288<=a061);
  a288=(a288+a284);
  a284=(a284/a288);
  a288=(a287*a526);
  a282=(a289*a522);
  a288=(a288-a282);
  a284=(a284*a288);
  a288=(a291*a284);
  a282=(2.*a290);
  a282=(a282*a284);
  a523=(a290*a282);
  a288=(a288+a523);
  a288=(a286*a288);
  a523=(a293*a288);
  a281=(a030*a284);
  a283=(a292*a281);
  a523=(a523-a283);
  a523=(a522+a523);
  a283=(a061<=a295);
  a295=(a295<=a061);
  a295=(a295+a283);
  a283=(a283/a295);
  a295=(a287*a526);
  a522=(a289*a522);
  a295=(a295+a522);
  a283=(a283*a295);
  a295=(a296*a283);
  a522=(2.*a285);
  a522=(a522*a283);
  a275=(a285*a522);
  a295=(a295+a275);
  a295=(a286*a295);
  a275=(a298*a295);
  a531=(a030*a283);
  a532=(a297*a531);
  a275=(a275-a532);
  a523=(a523-a275);
  a521=(a521*a523);
  a299=(2.*a299);
  a521=(a521/a299);
  a309=(a309*a521);
  a304=(a304/a305);
  a305=(a246<=a300);
  a300=(a300<=a246);
  a299=(a300+a305);
  a305=(a305/a299);
  a416=(a272*a416);
  a036=(2.*a036);
  a036=(a036*a408);
  a036=(a036+a505);
  a505=(2.*a272);
  a036=(a036/a505);
  a505=(a271*a036);
  a416=(a416+a505);
  a416=(a416/a276);
  a246=(a246/a276);
  a246=(a246*a274);
  a416=(a416-a246);
  a305=(a305*a416);
  a300=(a300/a299);
  a300=(a300*a521);
  a305=(a305-a300);
  a304=(a304*a305);
  a309=(a309+a304);
  a304=(a289*a309);
  a305=(a287*a521);
  a304=(a304-a305);
  a520=(a520*a304);
  a304=(a313*a520);
  a305=(2.*a312);
  a305=(a305*a520);
  a300=(a312*a305);
  a304=(a304+a300);
  a304=(a286*a304);
  a300=(a325*a304);
  a299=(a320*a515);
  a246=cos(a109);
  a246=(a246*a401);
  a505=(a317*a246);
  a275=(a030*a413);
  a532=(a080*a275);
  a533=(a316*a160);
  a532=(a532+a533);
  a533=arg[12]? arg[12][0] : 0;
  a534=(a533/a082);
  a535=(a319/a082);
  a535=(a535*a164);
  a534=(a534-a535);
  a532=(a532-a534);
  a535=(a315*a532);
  a505=(a505+a535);
  a535=(a080*a405);
  a536=(a111*a160);
  a535=(a535+a536);
  a536=(a535+a161);
  a537=(a321*a536);
  a538=sin(a109);
  a538=(a538*a401);
  a539=(a323*a538);
  a537=(a537-a539);
  a505=(a505-a537);
  a537=(a259*a505);
  a299=(a299+a537);
  a537=(a238*a299);
  a539=(a324*a433);
  a537=(a537-a539);
  a539=(a314*a537);
  a300=(a300+a539);
  a300=(a030*a300);
  a305=(a328*a305);
  a539=(a327*a537);
  a540=(a030*a520);
  a541=(a325*a540);
  a539=(a539-a541);
  a539=(a286*a539);
  a313=(a313*a539);
  a305=(a305+a313);
  a300=(a300-a305);
  a305=(2.*a520);
  a330=(a330*a305);
  a328=(a328*a520);
  a312=(a312*a539);
  a328=(a328+a312);
  a329=(a329*a328);
  a330=(a330+a329);
  a300=(a300-a330);
  a311=(a311*a300);
  a300=(a289*a311);
  a300=(a300+a537);
  a330=(a061<=a332);
  a332=(a332<=a061);
  a332=(a332+a330);
  a330=(a330/a332);
  a332=(a287*a521);
  a329=(a289*a309);
  a332=(a332+a329);
  a330=(a330*a332);
  a332=(a030*a330);
  a329=(a325*a332);
  a328=(a336*a537);
  a329=(a329+a328);
  a329=(a286*a329);
  a328=(a335*a329);
  a312=(2.*a334);
  a312=(a312*a330);
  a539=(a337*a312);
  a328=(a328-a539);
  a537=(a339*a537);
  a335=(a335*a330);
  a312=(a334*a312);
  a335=(a335+a312);
  a335=(a286*a335);
  a325=(a325*a335);
  a537=(a537-a325);
  a537=(a030*a537);
  a328=(a328-a537);
  a537=(-a330);
  a537=(2.*a537);
  a341=(a341*a537);
  a334=(a334*a329);
  a337=(a337*a330);
  a334=(a334-a337);
  a340=(a340*a334);
  a341=(a341+a340);
  a328=(a328+a341);
  a333=(a333*a328);
  a328=(a289*a333);
  a300=(a300-a328);
  a306=(a306*a300);
  a301=(a301*a306);
  a328=(a301/a276);
  a341=(a344/a276);
  a341=(a341*a274);
  a328=(a328-a341);
  a271=(a271*a328);
  a519=(a519+a271);
  a519=(a519/a346);
  a346=(a345/a346);
  a271=(2.*a036);
  a346=(a346*a271);
  a519=(a519-a346);
  a069=(a069*a519);
  a415=(a415+a069);
  a429=(a366*a429);
  a069=(a360*a420);
  a346=(a358*a426);
  a271=(a357*a418);
  a341=(a355*a400);
  a344=(a344*a036);
  a272=(a272*a328);
  a344=(a344+a272);
  a272=(a058*a344);
  a341=(a341+a272);
  a354=(a354*a341);
  a269=sin(a269);
  a269=(a269*a419);
  a356=(a356*a269);
  a354=(a354-a356);
  a356=(a035*a354);
  a271=(a271+a356);
  a271=(a271/a359);
  a359=(a358/a359);
  a267=(2.*a267);
  a267=(a267*a421);
  a359=(a359*a267);
  a271=(a271-a359);
  a359=(a098*a271);
  a346=(a346+a359);
  a346=(a346/a361);
  a361=(a360/a361);
  a264=(2.*a264);
  a264=(a264*a427);
  a361=(a361*a264);
  a346=(a346-a361);
  a361=(a066*a346);
  a069=(a069+a361);
  a361=(a358*a420);
  a264=(a066*a271);
  a361=(a361+a264);
  a262=(a262*a361);
  a264=(a363*a426);
  a262=(a262-a264);
  a069=(a069+a262);
  a351=(a351*a069);
  a348=(a348*a351);
  a262=(a348/a259);
  a264=(a366/a259);
  a264=(a264*a515);
  a262=(a262-a264);
  a240=(a240*a262);
  a429=(a429+a240);
  a240=(a429/a250);
  a368=(a368/a250);
  a368=(a368*a513);
  a240=(a240-a368);
  a415=(a415+a240);
  a408=(2.*a408);
  a408=(a399*a408);
  a530=(2.*a530);
  a530=(a398*a530);
  a416=(a416/a276);
  a240=(a371/a276);
  a240=(a240*a274);
  a416=(a416-a240);
  a343=(a343*a416);
  a371=(a371*a301);
  a343=(a343+a371);
  a524=(a524/a276);
  a371=(a373/a276);
  a371=(a371*a274);
  a524=(a524-a371);
  a524=(a395*a524);
  a295=(a386*a295);
  a371=(a382*a515);
  a301=cos(a109);
  a301=(a301*a401);
  a416=(a322*a301);
  a240=(a381*a535);
  a416=(a416+a240);
  a240=cos(a109);
  a240=(a240*a401);
  a368=(a083*a240);
  a264=(a383*a161);
  a368=(a368+a264);
  a416=(a416+a368);
  a368=(a384*a532);
  a264=sin(a109);
  a264=(a264*a401);
  a427=(a317*a264);
  a368=(a368-a427);
  a416=(a416+a368);
  a368=(a259*a416);
  a371=(a371+a368);
  a368=(a238*a371);
  a427=(a385*a433);
  a368=(a368-a427);
  a427=(2.*a523);
  a427=(a326*a427);
  a311=(a287*a311);
  a333=(a287*a333);
  a311=(a311+a333);
  a302=(a302*a306);
  a307=(a307*a300);
  a302=(a302-a307);
  a311=(a311+a302);
  a311=(a311/a342);
  a326=(a326/a342);
  a521=(-a521);
  a521=(2.*a521);
  a326=(a326*a521);
  a311=(a311-a326);
  a387=(a387*a311);
  a427=(a427+a387);
  a368=(a368-a427);
  a297=(a297*a368);
  a295=(a295+a297);
  a295=(a030*a295);
  a522=(a308*a522);
  a298=(a298*a368);
  a531=(a386*a531);
  a298=(a298-a531);
  a298=(a286*a298);
  a296=(a296*a298);
  a522=(a522+a296);
  a295=(a295-a522);
  a522=(2.*a283);
  a338=(a338*a522);
  a308=(a308*a283);
  a285=(a285*a298);
  a308=(a308+a285);
  a303=(a303*a308);
  a338=(a338+a303);
  a295=(a295-a338);
  a380=(a380*a295);
  a295=(a289*a380);
  a295=(a295+a368);
  a282=(a390*a282);
  a293=(a293*a368);
  a281=(a386*a281);
  a293=(a293-a281);
  a293=(a286*a293);
  a291=(a291*a293);
  a282=(a282+a291);
  a386=(a386*a288);
  a292=(a292*a368);
  a386=(a386+a292);
  a386=(a030*a386);
  a282=(a282-a386);
  a386=(2.*a284);
  a393=(a393*a386);
  a390=(a390*a284);
  a290=(a290*a293);
  a390=(a390+a290);
  a392=(a392*a390);
  a393=(a393+a392);
  a282=(a282+a393);
  a389=(a389*a282);
  a282=(a289*a389);
  a295=(a295-a282);
  a377=(a377*a295);
  a374=(a374*a377);
  a373=(a373*a374);
  a524=(a524+a373);
  a343=(a343+a524);
  a343=(a343/a396);
  a372=(a372/a396);
  a396=(2.*a274);
  a372=(a372*a396);
  a343=(a343-a372);
  a343=(a343/a397);
  a397=(a398/a397);
  a527=(2.*a527);
  a397=(a397*a527);
  a343=(a343-a397);
  a370=(a370*a343);
  a530=(a530+a370);
  a369=(a369*a530);
  a408=(a408+a369);
  a415=(a415-a408);
  a408=(a065*a415);
  a402=(a402+a408);
  a002=(a002+a402);
  a408=(a251/a250);
  a369=(a408*a367);
  a370=(2.*a250);
  a369=(a369/a370);
  a345=(a345-a369);
  a397=(2.*a507);
  a397=(a345*a397);
  a527=(2.*a243);
  a372=(a501/a250);
  a250=(a408/a250);
  a250=(a250*a513);
  a372=(a372-a250);
  a367=(a367*a372);
  a408=(a408*a429);
  a367=(a367+a408);
  a367=(a367/a370);
  a369=(a369/a370);
  a513=(2.*a513);
  a369=(a369*a513);
  a367=(a367-a369);
  a519=(a519-a367);
  a367=(a527*a519);
  a397=(a397+a367);
  a374=(a374/a276);
  a395=(a395/a276);
  a276=(a395/a276);
  a276=(a276*a274);
  a374=(a374-a276);
  a397=(a397+a374);
  a507=(2.*a507);
  a507=(a399*a507);
  a243=(2.*a243);
  a530=(a243*a530);
  a507=(a507+a530);
  a397=(a397-a507);
  a507=(a242*a397);
  a527=(a527*a345);
  a527=(a527+a395);
  a243=(a243*a399);
  a527=(a527-a243);
  a508=(a527*a508);
  a507=(a507-a508);
  a002=(a002+a507);
  a508=cos(a109);
  a243=(a029*a508);
  a399=(a009+a106);
  a395=sin(a109);
  a530=(a399*a395);
  a243=(a243-a530);
  a530=(2.*a243);
  a374=(-a102);
  a276=(a059*a238);
  a099=(a099+a276);
  a276=casadi_fmax(a061,a099);
  a106=(a009+a106);
  a274=cos(a109);
  a367=(a106*a274);
  a245=(a245+a367);
  a367=casadi_sq(a245);
  a367=(a367+a249);
  a369=sqrt(a367);
  a513=(a243/a369);
  a370=(a276*a513);
  a408=arg[2]? arg[2][36] : 0;
  a429=(a256*a238);
  a255=(a255+a429);
  a429=casadi_fmax(a254,a255);
  a372=(a408*a429);
  a370=(a370/a372);
  a250=casadi_fmin(a370,a102);
  a396=casadi_fmax(a374,a250);
  a524=(a068-a098);
  a373=(a396*a524);
  a282=(a066*a396);
  a393=atan(a282);
  a392=(a098*a393);
  a392=(a392/a066);
  a373=(a373+a392);
  a390=(a066*a373);
  a290=atan(a390);
  a293=(a035*a290);
  a284=sin(a293);
  a386=(a058*a284);
  a292=casadi_sq(a243);
  a292=(a292+a367);
  a292=sqrt(a292);
  a367=(a386*a292);
  a368=casadi_sq(a248);
  a288=casadi_sq(a368);
  a291=casadi_sq(a245);
  a281=casadi_sq(a243);
  a291=(a291+a281);
  a281=casadi_sq(a291);
  a288=(a288+a281);
  a288=sqrt(a288);
  a281=sqrt(a288);
  a367=(a367/a281);
  a338=arg[1]? arg[1][4] : 0;
  a303=arg[2]? arg[2][41] : 0;
  a308=(a372-a303);
  a285=(a338*a308);
  a285=(a285+a303);
  a285=(a285/a372);
  a303=(a285+a278);
  a298=(-a303);
  a283=(a245/a281);
  a522=casadi_fmin(a303,a283);
  a296=casadi_fmax(a298,a522);
  a531=(a287*a285);
  a297=(a289*a296);
  a531=(a531-a297);
  a531=(a531+a030);
  a297=casadi_fmax(a061,a531);
  a427=casadi_sq(a297);
  a387=(a297*a427);
  a387=(a286*a387);
  a311=(a030*a297);
  a311=(a068-a311);
  a326=(a387*a311);
  a326=(a296+a326);
  a521=(a287*a285);
  a296=(a289*a296);
  a521=(a521+a296);
  a521=(a521+a030);
  a296=casadi_fmax(a061,a521);
  a342=casadi_sq(a296);
  a302=(a296*a342);
  a302=(a286*a302);
  a307=(a030*a296);
  a307=(a068-a307);
  a300=(a302*a307);
  a326=(a326-a300);
  a300=casadi_sq(a326);
  a300=(a068-a300);
  a300=sqrt(a300);
  a306=(a300+a278);
  a333=(a367<=a306);
  a359=(a306<=a367);
  a267=(a359+a333);
  a333=(a333/a267);
  a421=(-a306);
  a356=casadi_fmin(a306,a367);
  a269=(a421<=a356);
  a419=(a356<=a421);
  a341=(a419+a269);
  a269=(a269/a341);
  a272=(a287*a300);
  a328=casadi_fmax(a421,a356);
  a036=(a289*a328);
  a272=(a272+a036);
  a272=(a272+a030);
  a036=(a061<=a272);
  a340=(a272<=a061);
  a340=(a340+a036);
  a036=(a036/a340);
  a340=casadi_fmax(a061,a272);
  a334=casadi_sq(a340);
  a337=(a340*a334);
  a337=(a286*a337);
  a330=sin(a109);
  a329=(a030*a107);
  a537=(a329*a080);
  a537=(a537+a319);
  a325=(a330*a537);
  a312=cos(a109);
  a539=(a111*a080);
  a539=(a539+a083);
  a520=(a312*a539);
  a325=(a325-a520);
  a520=(a372*a325);
  a305=(a238*a520);
  a313=(a337*a305);
  a313=(a030*a313);
  a541=(a030*a340);
  a541=(a068-a541);
  a542=(a541*a305);
  a542=(a286*a542);
  a543=(a334*a542);
  a313=(a313-a543);
  a543=(2.*a340);
  a544=(a340*a542);
  a545=(a543*a544);
  a313=(a313-a545);
  a313=(a036*a313);
  a545=(a289*a313);
  a545=(a545+a305);
  a546=(a287*a300);
  a547=(a289*a328);
  a546=(a546-a547);
  a546=(a546+a030);
  a547=(a061<=a546);
  a548=(a546<=a061);
  a548=(a548+a547);
  a547=(a547/a548);
  a548=casadi_fmax(a061,a546);
  a549=casadi_sq(a548);
  a550=(a030*a548);
  a550=(a068-a550);
  a551=(a550*a305);
  a551=(a286*a551);
  a552=(a549*a551);
  a553=(a548*a549);
  a553=(a286*a553);
  a554=(a553*a305);
  a554=(a030*a554);
  a552=(a552-a554);
  a554=(2.*a548);
  a555=(a548*a551);
  a556=(a554*a555);
  a552=(a552+a556);
  a552=(a547*a552);
  a556=(a289*a552);
  a545=(a545-a556);
  a556=(a269*a545);
  a557=(a333*a556);
  a558=(a557/a281);
  a559=(a386*a558);
  a560=(2.*a292);
  a559=(a559/a560);
  a561=(a530*a559);
  a562=(a370<=a102);
  a563=(a102<=a370);
  a564=(a562+a563);
  a562=(a562/a564);
  a565=(a374<=a250);
  a566=(a250<=a374);
  a567=(a566+a565);
  a565=(a565/a567);
  a568=cos(a293);
  a569=(a292*a558);
  a570=(a058*a569);
  a571=(a568*a570);
  a572=(a035*a571);
  a573=casadi_sq(a390);
  a573=(a068+a573);
  a572=(a572/a573);
  a574=(a098*a572);
  a575=casadi_sq(a282);
  a575=(a068+a575);
  a574=(a574/a575);
  a576=(a066*a574);
  a577=(a066*a572);
  a578=(a524*a577);
  a576=(a576+a578);
  a578=(a565*a576);
  a579=(a562*a578);
  a580=(a579/a372);
  a581=(a276*a580);
  a582=(a581/a369);
  a561=(a561+a582);
  a583=(2.*a243);
  a584=(2.*a291);
  a585=(a367/a281);
  a586=(a585*a557);
  a587=(a283/a281);
  a588=(a283<=a303);
  a589=(a303<=a283);
  a590=(a589+a588);
  a588=(a588/a590);
  a591=(a298<=a522);
  a592=(a522<=a298);
  a593=(a592+a591);
  a591=(a591/a593);
  a594=(a061<=a521);
  a595=(a521<=a061);
  a595=(a595+a594);
  a594=(a594/a595);
  a595=(2.*a326);
  a313=(a287*a313);
  a552=(a287*a552);
  a313=(a313+a552);
  a359=(a359/a267);
  a556=(a359*a556);
  a419=(a419/a341);
  a545=(a419*a545);
  a556=(a556-a545);
  a313=(a313+a556);
  a556=(2.*a300);
  a313=(a313/a556);
  a545=(a595*a313);
  a341=sin(a109);
  a267=(a341*a539);
  a552=cos(a109);
  a596=(a552*a537);
  a267=(a267+a596);
  a596=(a372*a267);
  a597=(a238*a596);
  a545=(a545+a597);
  a597=(a307*a545);
  a597=(a286*a597);
  a598=(a342*a597);
  a599=(a302*a545);
  a599=(a030*a599);
  a598=(a598-a599);
  a599=(2.*a296);
  a600=(a296*a597);
  a601=(a599*a600);
  a598=(a598+a601);
  a598=(a594*a598);
  a601=(a289*a598);
  a601=(a601-a545);
  a602=(a061<=a531);
  a603=(a531<=a061);
  a603=(a603+a602);
  a602=(a602/a603);
  a603=(a387*a545);
  a603=(a030*a603);
  a604=(a311*a545);
  a604=(a286*a604);
  a605=(a427*a604);
  a603=(a603-a605);
  a605=(2.*a297);
  a606=(a297*a604);
  a607=(a605*a606);
  a603=(a603-a607);
  a603=(a602*a603);
  a607=(a289*a603);
  a601=(a601-a607);
  a607=(a591*a601);
  a608=(a588*a607);
  a609=(a587*a608);
  a586=(a586+a609);
  a609=(2.*a281);
  a586=(a586/a609);
  a610=(2.*a288);
  a611=(a586/a610);
  a612=(a584*a611);
  a613=(a583*a612);
  a561=(a561-a613);
  a613=cos(a109);
  a613=(a613*a401);
  a614=(a561*a613);
  a615=(a508*a403);
  a616=sin(a109);
  a616=(a616*a401);
  a617=(a029*a616);
  a615=(a615-a617);
  a617=(a116+a412);
  a618=(a395*a617);
  a613=(a399*a613);
  a618=(a618+a613);
  a615=(a615-a618);
  a618=(2.*a615);
  a618=(a559*a618);
  a613=(a284*a400);
  a619=cos(a293);
  a620=(a290*a418);
  a621=(a373*a420);
  a622=(a250<=a374);
  a374=(a374<=a250);
  a250=(a622+a374);
  a622=(a622/a250);
  a622=(a622*a423);
  a374=(a374/a250);
  a250=(a370<=a102);
  a623=(a102<=a370);
  a624=(a250+a623);
  a250=(a250/a624);
  a625=(a061<=a099);
  a626=(a099<=a061);
  a626=(a626+a625);
  a625=(a625/a626);
  a626=(a238*a431);
  a627=(a059*a433);
  a626=(a626-a627);
  a430=(a430+a626);
  a625=(a625*a430);
  a430=(a513*a625);
  a626=(a615/a369);
  a627=(a513/a369);
  a628=(2.*a245);
  a412=(a116+a412);
  a629=(a274*a412);
  a630=sin(a109);
  a630=(a630*a401);
  a631=(a106*a630);
  a629=(a629-a631);
  a509=(a509+a629);
  a628=(a628*a509);
  a628=(a628+a511);
  a629=(2.*a369);
  a629=(a628/a629);
  a627=(a627*a629);
  a626=(a626-a627);
  a627=(a276*a626);
  a430=(a430+a627);
  a430=(a430/a372);
  a627=(a370/a372);
  a631=arg[10]? arg[10][36] : 0;
  a632=(a429*a631);
  a633=(a254<=a255);
  a634=(a255<=a254);
  a634=(a634+a633);
  a633=(a633/a634);
  a634=(a238*a518);
  a635=(a256*a433);
  a634=(a634-a635);
  a517=(a517+a634);
  a633=(a633*a517);
  a517=(a408*a633);
  a632=(a632+a517);
  a627=(a627*a632);
  a430=(a430-a627);
  a250=(a250*a430);
  a623=(a623/a624);
  a623=(a623*a423);
  a250=(a250-a623);
  a374=(a374*a250);
  a622=(a622+a374);
  a374=(a524*a622);
  a250=(a396*a426);
  a374=(a374-a250);
  a250=(a393*a426);
  a623=(a396*a420);
  a624=(a066*a622);
  a623=(a623+a624);
  a624=casadi_sq(a282);
  a624=(a068+a624);
  a624=(a623/a624);
  a627=(a098*a624);
  a250=(a250+a627);
  a250=(a250/a066);
  a627=(a392/a066);
  a627=(a627*a420);
  a250=(a250-a627);
  a374=(a374+a250);
  a627=(a066*a374);
  a621=(a621+a627);
  a627=casadi_sq(a390);
  a627=(a068+a627);
  a627=(a621/a627);
  a517=(a035*a627);
  a620=(a620+a517);
  a619=(a619*a620);
  a517=(a058*a619);
  a613=(a613+a517);
  a517=(a558*a613);
  a634=(a061<=a272);
  a272=(a272<=a061);
  a272=(a272+a634);
  a634=(a634/a272);
  a272=(a356<=a421);
  a421=(a421<=a356);
  a356=(a272+a421);
  a272=(a272/a356);
  a635=(2.*a326);
  a636=(a298<=a522);
  a522=(a522<=a298);
  a298=(a522+a636);
  a636=(a636/a298);
  a637=(a303<=a283);
  a303=(a283<=a303);
  a638=(a637+a303);
  a637=(a637/a638);
  a639=arg[9]? arg[9][4] : 0;
  a640=(a308*a639);
  a641=arg[10]? arg[10][41] : 0;
  a642=(a632-a641);
  a643=(a338*a642);
  a640=(a640+a643);
  a640=(a640+a641);
  a640=(a640/a372);
  a641=(a285/a372);
  a641=(a641*a632);
  a640=(a640-a641);
  a637=(a637*a640);
  a303=(a303/a638);
  a638=(a509/a281);
  a283=(a283/a281);
  a641=(2.*a368);
  a643=(2.*a248);
  a643=(a643*a512);
  a641=(a641*a643);
  a291=(2.*a291);
  a644=(2.*a245);
  a644=(a644*a509);
  a645=(2.*a243);
  a645=(a645*a615);
  a644=(a644+a645);
  a291=(a291*a644);
  a641=(a641+a291);
  a288=(2.*a288);
  a641=(a641/a288);
  a288=(2.*a281);
  a288=(a641/a288);
  a283=(a283*a288);
  a638=(a638-a283);
  a303=(a303*a638);
  a637=(a637+a303);
  a636=(a636*a637);
  a522=(a522/a298);
  a522=(a522*a640);
  a636=(a636-a522);
  a522=(a061<=a531);
  a531=(a531<=a061);
  a531=(a531+a522);
  a522=(a522/a531);
  a531=(a287*a640);
  a298=(a289*a636);
  a531=(a531-a298);
  a522=(a522*a531);
  a531=(a427*a522);
  a298=(2.*a297);
  a298=(a298*a522);
  a637=(a297*a298);
  a531=(a531+a637);
  a531=(a286*a531);
  a637=(a311*a531);
  a303=(a030*a522);
  a283=(a387*a303);
  a637=(a637-a283);
  a637=(a636+a637);
  a283=(a061<=a521);
  a521=(a521<=a061);
  a521=(a521+a283);
  a283=(a283/a521);
  a521=(a287*a640);
  a636=(a289*a636);
  a521=(a521+a636);
  a283=(a283*a521);
  a521=(a342*a283);
  a636=(2.*a296);
  a636=(a636*a283);
  a291=(a296*a636);
  a521=(a521+a291);
  a521=(a286*a521);
  a291=(a307*a521);
  a645=(a030*a283);
  a646=(a302*a645);
  a291=(a291-a646);
  a637=(a637-a291);
  a635=(a635*a637);
  a300=(2.*a300);
  a635=(a635/a300);
  a272=(a272*a635);
  a421=(a421/a356);
  a356=(a367<=a306);
  a306=(a306<=a367);
  a300=(a306+a356);
  a356=(a356/a300);
  a613=(a292*a613);
  a243=(2.*a243);
  a243=(a243*a615);
  a243=(a243+a628);
  a628=(2.*a292);
  a243=(a243/a628);
  a628=(a386*a243);
  a613=(a613+a628);
  a613=(a613/a281);
  a367=(a367/a281);
  a367=(a367*a288);
  a613=(a613-a367);
  a356=(a356*a613);
  a306=(a306/a300);
  a306=(a306*a635);
  a356=(a356-a306);
  a421=(a421*a356);
  a272=(a272+a421);
  a421=(a289*a272);
  a356=(a287*a635);
  a421=(a421-a356);
  a634=(a634*a421);
  a421=(a334*a634);
  a356=(2.*a340);
  a356=(a356*a634);
  a306=(a340*a356);
  a421=(a421+a306);
  a421=(a286*a421);
  a306=(a305*a421);
  a300=(a325*a632);
  a367=cos(a109);
  a367=(a367*a401);
  a628=(a537*a367);
  a291=(a030*a413);
  a646=(a080*a291);
  a647=(a329*a160);
  a646=(a646+a647);
  a646=(a646+a534);
  a647=(a330*a646);
  a628=(a628+a647);
  a647=(a080*a405);
  a648=(a111*a160);
  a647=(a647+a648);
  a647=(a647+a161);
  a648=(a312*a647);
  a649=sin(a109);
  a649=(a649*a401);
  a650=(a539*a649);
  a648=(a648-a650);
  a628=(a628-a648);
  a648=(a372*a628);
  a300=(a300+a648);
  a648=(a238*a300);
  a650=(a520*a433);
  a648=(a648-a650);
  a650=(a337*a648);
  a306=(a306+a650);
  a306=(a030*a306);
  a356=(a542*a356);
  a650=(a541*a648);
  a651=(a030*a634);
  a652=(a305*a651);
  a650=(a650-a652);
  a650=(a286*a650);
  a334=(a334*a650);
  a356=(a356+a334);
  a306=(a306-a356);
  a356=(2.*a634);
  a544=(a544*a356);
  a542=(a542*a634);
  a340=(a340*a650);
  a542=(a542+a340);
  a543=(a543*a542);
  a544=(a544+a543);
  a306=(a306-a544);
  a036=(a036*a306);
  a306=(a289*a036);
  a306=(a306+a648);
  a544=(a061<=a546);
  a546=(a546<=a061);
  a546=(a546+a544);
  a544=(a544/a546);
  a546=(a287*a635);
  a543=(a289*a272);
  a546=(a546+a543);
  a544=(a544*a546);
  a546=(a030*a544);
  a543=(a305*a546);
  a542=(a550*a648);
  a543=(a543+a542);
  a543=(a286*a543);
  a542=(a549*a543);
  a340=(2.*a548);
  a340=(a340*a544);
  a650=(a551*a340);
  a542=(a542-a650);
  a648=(a553*a648);
  a549=(a549*a544);
  a340=(a548*a340);
  a549=(a549+a340);
  a549=(a286*a549);
  a305=(a305*a549);
  a648=(a648-a305);
  a648=(a030*a648);
  a542=(a542-a648);
  a648=(-a544);
  a648=(2.*a648);
  a555=(a555*a648);
  a548=(a548*a543);
  a551=(a551*a544);
  a548=(a548-a551);
  a554=(a554*a548);
  a555=(a555+a554);
  a542=(a542+a555);
  a547=(a547*a542);
  a542=(a289*a547);
  a306=(a306-a542);
  a269=(a269*a306);
  a333=(a333*a269);
  a542=(a333/a281);
  a555=(a558/a281);
  a555=(a555*a288);
  a542=(a542-a555);
  a386=(a386*a542);
  a517=(a517+a386);
  a517=(a517/a560);
  a560=(a559/a560);
  a386=(2.*a243);
  a560=(a560*a386);
  a517=(a517-a560);
  a530=(a530*a517);
  a618=(a618+a530);
  a625=(a580*a625);
  a530=(a574*a420);
  a560=(a572*a426);
  a418=(a571*a418);
  a400=(a569*a400);
  a558=(a558*a243);
  a292=(a292*a542);
  a558=(a558+a292);
  a058=(a058*a558);
  a400=(a400+a058);
  a568=(a568*a400);
  a293=sin(a293);
  a293=(a293*a620);
  a570=(a570*a293);
  a568=(a568-a570);
  a035=(a035*a568);
  a418=(a418+a035);
  a418=(a418/a573);
  a573=(a572/a573);
  a390=(2.*a390);
  a390=(a390*a621);
  a573=(a573*a390);
  a418=(a418-a573);
  a098=(a098*a418);
  a560=(a560+a098);
  a560=(a560/a575);
  a575=(a574/a575);
  a282=(2.*a282);
  a282=(a282*a623);
  a575=(a575*a282);
  a560=(a560-a575);
  a575=(a066*a560);
  a530=(a530+a575);
  a575=(a572*a420);
  a282=(a066*a418);
  a575=(a575+a282);
  a524=(a524*a575);
  a426=(a577*a426);
  a524=(a524-a426);
  a530=(a530+a524);
  a565=(a565*a530);
  a562=(a562*a565);
  a524=(a562/a372);
  a426=(a580/a372);
  a426=(a426*a632);
  a524=(a524-a426);
  a276=(a276*a524);
  a625=(a625+a276);
  a276=(a625/a369);
  a582=(a582/a369);
  a582=(a582*a629);
  a276=(a276-a582);
  a618=(a618+a276);
  a615=(2.*a615);
  a615=(a612*a615);
  a644=(2.*a644);
  a644=(a611*a644);
  a613=(a613/a281);
  a276=(a585/a281);
  a276=(a276*a288);
  a613=(a613-a276);
  a557=(a557*a613);
  a585=(a585*a333);
  a557=(a557+a585);
  a638=(a638/a281);
  a585=(a587/a281);
  a585=(a585*a288);
  a638=(a638-a585);
  a638=(a608*a638);
  a636=(a597*a636);
  a585=(2.*a637);
  a585=(a313*a585);
  a036=(a287*a036);
  a547=(a287*a547);
  a036=(a036+a547);
  a359=(a359*a269);
  a419=(a419*a306);
  a359=(a359-a419);
  a036=(a036+a359);
  a036=(a036/a556);
  a313=(a313/a556);
  a635=(-a635);
  a635=(2.*a635);
  a313=(a313*a635);
  a036=(a036-a313);
  a595=(a595*a036);
  a585=(a585+a595);
  a595=(a267*a632);
  a036=cos(a109);
  a036=(a036*a401);
  a313=(a539*a036);
  a635=(a341*a647);
  a313=(a313+a635);
  a635=(a552*a646);
  a556=sin(a109);
  a556=(a556*a401);
  a359=(a537*a556);
  a635=(a635-a359);
  a313=(a313+a635);
  a635=(a372*a313);
  a595=(a595+a635);
  a635=(a238*a595);
  a359=(a596*a433);
  a635=(a635-a359);
  a585=(a585+a635);
  a307=(a307*a585);
  a645=(a545*a645);
  a307=(a307-a645);
  a307=(a286*a307);
  a342=(a342*a307);
  a636=(a636+a342);
  a521=(a545*a521);
  a302=(a302*a585);
  a521=(a521+a302);
  a521=(a030*a521);
  a636=(a636-a521);
  a521=(2.*a283);
  a600=(a600*a521);
  a597=(a597*a283);
  a296=(a296*a307);
  a597=(a597+a296);
  a599=(a599*a597);
  a600=(a600+a599);
  a636=(a636+a600);
  a594=(a594*a636);
  a636=(a289*a594);
  a636=(a636-a585);
  a531=(a545*a531);
  a387=(a387*a585);
  a531=(a531+a387);
  a531=(a030*a531);
  a298=(a604*a298);
  a311=(a311*a585);
  a545=(a545*a303);
  a311=(a311-a545);
  a311=(a286*a311);
  a427=(a427*a311);
  a298=(a298+a427);
  a531=(a531-a298);
  a298=(2.*a522);
  a606=(a606*a298);
  a604=(a604*a522);
  a297=(a297*a311);
  a604=(a604+a297);
  a605=(a605*a604);
  a606=(a606+a605);
  a531=(a531-a606);
  a602=(a602*a531);
  a531=(a289*a602);
  a636=(a636-a531);
  a591=(a591*a636);
  a588=(a588*a591);
  a587=(a587*a588);
  a638=(a638+a587);
  a557=(a557+a638);
  a557=(a557/a609);
  a586=(a586/a609);
  a609=(2.*a288);
  a586=(a586*a609);
  a557=(a557-a586);
  a557=(a557/a610);
  a610=(a611/a610);
  a641=(2.*a641);
  a610=(a610*a641);
  a557=(a557-a610);
  a584=(a584*a557);
  a644=(a644+a584);
  a583=(a583*a644);
  a615=(a615+a583);
  a618=(a618-a615);
  a615=(a395*a618);
  a614=(a614+a615);
  a002=(a002-a614);
  a615=(a513/a369);
  a583=(a615*a581);
  a584=(2.*a369);
  a583=(a583/a584);
  a559=(a559-a583);
  a610=(2.*a509);
  a610=(a559*a610);
  a641=(2.*a245);
  a586=(a626/a369);
  a369=(a615/a369);
  a369=(a369*a629);
  a586=(a586-a369);
  a581=(a581*a586);
  a615=(a615*a625);
  a581=(a581+a615);
  a581=(a581/a584);
  a583=(a583/a584);
  a629=(2.*a629);
  a583=(a583*a629);
  a581=(a581-a583);
  a517=(a517-a581);
  a581=(a641*a517);
  a610=(a610+a581);
  a588=(a588/a281);
  a608=(a608/a281);
  a281=(a608/a281);
  a281=(a281*a288);
  a588=(a588-a281);
  a610=(a610+a588);
  a509=(2.*a509);
  a509=(a612*a509);
  a245=(2.*a245);
  a644=(a245*a644);
  a509=(a509+a644);
  a610=(a610-a509);
  a509=(a274*a610);
  a641=(a641*a559);
  a641=(a641+a608);
  a245=(a245*a612);
  a641=(a641-a245);
  a630=(a641*a630);
  a509=(a509-a630);
  a002=(a002+a509);
  a630=(a216+a219);
  a245=(a010*a630);
  a245=(a245+a045);
  a612=arg[2]? arg[2][44] : 0;
  a608=(a054*a612);
  a644=arg[1]? arg[1][7] : 0;
  a608=(a608+a644);
  a644=arg[2]? arg[2][45] : 0;
  a588=(a068-a644);
  a281=(a608*a588);
  a288=cos(a281);
  a581=(a245*a288);
  a583=sin(a281);
  a629=(a009*a583);
  a581=(a581-a629);
  a629=(2.*a581);
  a584=arg[2]? arg[2][54] : 0;
  a615=arg[2]? arg[2][53] : 0;
  a625=arg[2]? arg[2][51] : 0;
  a586=arg[2]? arg[2][52] : 0;
  a369=(a586-a068);
  a609=casadi_fmax(a025,a369);
  a609=sqrt(a609);
  a638=(a625*a609);
  a587=(1./a638);
  a531=(-a587);
  a606=arg[2]? arg[2][46] : 0;
  a605=arg[2]? arg[2][47] : 0;
  a604=(a138*a111);
  a604=(a604+a227);
  a604=(a604/a236);
  a227=casadi_fmax(a061,a604);
  a297=(a605*a227);
  a606=(a606+a297);
  a297=casadi_fmax(a061,a606);
  a311=cos(a281);
  a522=(a009*a311);
  a298=sin(a281);
  a427=(a245*a298);
  a522=(a522+a427);
  a427=casadi_sq(a522);
  a427=(a427+a249);
  a249=sqrt(a427);
  a545=(a581/a249);
  a303=(a297*a545);
  a585=arg[2]? arg[2][50] : 0;
  a387=arg[2]? arg[2][48] : 0;
  a600=arg[2]? arg[2][49] : 0;
  a599=(a600*a227);
  a387=(a387+a599);
  a599=casadi_fmax(a254,a387);
  a597=(a585*a599);
  a303=(a303/a597);
  a296=casadi_fmin(a303,a587);
  a307=casadi_fmax(a531,a296);
  a283=(a625*a307);
  a521=atan(a283);
  a302=(a586*a521);
  a302=(a302/a625);
  a342=(a586-a068);
  a645=(a307*a342);
  a645=(a302-a645);
  a635=(a625*a645);
  a359=atan(a635);
  a419=(a615*a359);
  a306=sin(a419);
  a269=(a584*a306);
  a547=casadi_sq(a581);
  a547=(a547+a427);
  a547=sqrt(a547);
  a427=(a269*a547);
  a333=casadi_sq(a248);
  a613=casadi_sq(a333);
  a276=casadi_sq(a522);
  a582=casadi_sq(a581);
  a276=(a276+a582);
  a582=casadi_sq(a276);
  a613=(a613+a582);
  a613=sqrt(a613);
  a582=sqrt(a613);
  a427=(a427/a582);
  a426=arg[2]? arg[2][55] : 0;
  a426=(a426/a597);
  a282=(a426+a278);
  a623=(-a282);
  a098=(a522/a582);
  a573=casadi_fmin(a282,a098);
  a390=casadi_fmax(a623,a573);
  a621=(a287*a426);
  a035=(a289*a390);
  a621=(a621-a035);
  a621=(a621+a030);
  a035=casadi_fmax(a061,a621);
  a570=casadi_sq(a035);
  a293=(a035*a570);
  a293=(a286*a293);
  a620=(a030*a035);
  a620=(a068-a620);
  a400=(a293*a620);
  a400=(a390+a400);
  a058=(a287*a426);
  a390=(a289*a390);
  a058=(a058+a390);
  a058=(a058+a030);
  a390=casadi_fmax(a061,a058);
  a292=casadi_sq(a390);
  a542=(a390*a292);
  a542=(a286*a542);
  a243=(a030*a390);
  a243=(a068-a243);
  a386=(a542*a243);
  a400=(a400-a386);
  a386=casadi_sq(a400);
  a386=(a068-a386);
  a386=sqrt(a386);
  a278=(a386+a278);
  a555=(a427<=a278);
  a554=(a278<=a427);
  a548=(a554+a555);
  a555=(a555/a548);
  a551=(-a278);
  a544=casadi_fmin(a278,a427);
  a543=(a551<=a544);
  a648=(a544<=a551);
  a305=(a648+a543);
  a543=(a543/a305);
  a340=(a287*a386);
  a650=casadi_fmax(a551,a544);
  a634=(a289*a650);
  a340=(a340+a634);
  a340=(a340+a030);
  a634=(a061<=a340);
  a356=(a340<=a061);
  a356=(a356+a634);
  a634=(a634/a356);
  a356=casadi_fmax(a061,a340);
  a334=casadi_sq(a356);
  a652=(a356*a334);
  a652=(a286*a652);
  a644=(a068-a644);
  a653=sin(a281);
  a654=(a653*a319);
  a655=cos(a281);
  a216=(a216+a219);
  a219=(a216*a080);
  a219=(a219+a083);
  a656=(a655*a219);
  a654=(a654-a656);
  a656=(a644*a654);
  a657=(a597*a656);
  a658=(a227*a657);
  a659=(a652*a658);
  a659=(a030*a659);
  a660=(a030*a356);
  a660=(a068-a660);
  a661=(a660*a658);
  a661=(a286*a661);
  a662=(a334*a661);
  a659=(a659-a662);
  a662=(2.*a356);
  a663=(a356*a661);
  a664=(a662*a663);
  a659=(a659-a664);
  a659=(a634*a659);
  a664=(a289*a659);
  a664=(a664+a658);
  a665=(a287*a386);
  a666=(a289*a650);
  a665=(a665-a666);
  a665=(a665+a030);
  a666=(a061<=a665);
  a667=(a665<=a061);
  a667=(a667+a666);
  a666=(a666/a667);
  a667=casadi_fmax(a061,a665);
  a668=casadi_sq(a667);
  a669=(a030*a667);
  a669=(a068-a669);
  a670=(a669*a658);
  a670=(a286*a670);
  a671=(a668*a670);
  a672=(a667*a668);
  a672=(a286*a672);
  a673=(a672*a658);
  a673=(a030*a673);
  a671=(a671-a673);
  a673=(2.*a667);
  a674=(a667*a670);
  a675=(a673*a674);
  a671=(a671+a675);
  a671=(a666*a671);
  a675=(a289*a671);
  a664=(a664-a675);
  a675=(a543*a664);
  a676=(a555*a675);
  a677=(a676/a582);
  a678=(a269*a677);
  a679=(2.*a547);
  a678=(a678/a679);
  a680=(a629*a678);
  a681=(a303<=a587);
  a682=(a587<=a303);
  a683=(a681+a682);
  a681=(a681/a683);
  a684=(a531<=a296);
  a685=(a296<=a531);
  a686=(a685+a684);
  a684=(a684/a686);
  a687=cos(a419);
  a688=(a547*a677);
  a689=(a584*a688);
  a690=(a687*a689);
  a691=(a615*a690);
  a692=casadi_sq(a635);
  a692=(a068+a692);
  a691=(a691/a692);
  a693=(a586*a691);
  a694=casadi_sq(a283);
  a694=(a068+a694);
  a693=(a693/a694);
  a695=(a625*a693);
  a696=(a625*a691);
  a697=(a342*a696);
  a695=(a695-a697);
  a697=(a684*a695);
  a698=(a681*a697);
  a699=(a698/a597);
  a700=(a297*a699);
  a701=(a700/a249);
  a680=(a680+a701);
  a702=(2.*a581);
  a703=(2.*a276);
  a704=(a427/a582);
  a705=(a704*a676);
  a706=(a098/a582);
  a707=(a098<=a282);
  a708=(a282<=a098);
  a709=(a708+a707);
  a707=(a707/a709);
  a710=(a623<=a573);
  a711=(a573<=a623);
  a712=(a711+a710);
  a710=(a710/a712);
  a713=(a061<=a058);
  a714=(a058<=a061);
  a714=(a714+a713);
  a713=(a713/a714);
  a714=sin(a281);
  a715=(a714*a219);
  a716=cos(a281);
  a717=(a716*a319);
  a715=(a715+a717);
  a717=(a597*a715);
  a718=(a227*a717);
  a719=(2.*a400);
  a659=(a287*a659);
  a671=(a287*a671);
  a659=(a659+a671);
  a554=(a554/a548);
  a675=(a554*a675);
  a648=(a648/a305);
  a664=(a648*a664);
  a675=(a675-a664);
  a659=(a659+a675);
  a675=(2.*a386);
  a659=(a659/a675);
  a664=(a719*a659);
  a718=(a718+a664);
  a664=(a243*a718);
  a664=(a286*a664);
  a305=(a292*a664);
  a548=(a542*a718);
  a548=(a030*a548);
  a305=(a305-a548);
  a548=(2.*a390);
  a671=(a390*a664);
  a720=(a548*a671);
  a305=(a305+a720);
  a305=(a713*a305);
  a720=(a289*a305);
  a720=(a720-a718);
  a721=(a061<=a621);
  a722=(a621<=a061);
  a722=(a722+a721);
  a721=(a721/a722);
  a722=(a293*a718);
  a722=(a030*a722);
  a723=(a620*a718);
  a723=(a286*a723);
  a724=(a570*a723);
  a722=(a722-a724);
  a724=(2.*a035);
  a725=(a035*a723);
  a726=(a724*a725);
  a722=(a722-a726);
  a722=(a721*a722);
  a726=(a289*a722);
  a720=(a720-a726);
  a726=(a710*a720);
  a727=(a707*a726);
  a728=(a706*a727);
  a705=(a705+a728);
  a728=(2.*a582);
  a705=(a705/a728);
  a729=(2.*a613);
  a730=(a705/a729);
  a731=(a703*a730);
  a732=(a702*a731);
  a680=(a680-a732);
  a732=cos(a281);
  a733=(a612*a127);
  a734=arg[10]? arg[10][44] : 0;
  a735=(a054*a734);
  a733=(a733+a735);
  a735=arg[9]? arg[9][7] : 0;
  a733=(a733+a735);
  a735=(a588*a733);
  a736=arg[10]? arg[10][45] : 0;
  a737=(a608*a736);
  a735=(a735-a737);
  a732=(a732*a735);
  a737=(a680*a732);
  a738=(a630*a008);
  a739=(a482+a485);
  a740=(a010*a739);
  a738=(a738+a740);
  a738=(a738+a148);
  a740=(a288*a738);
  a741=sin(a281);
  a741=(a741*a735);
  a742=(a245*a741);
  a740=(a740-a742);
  a742=(a583*a116);
  a732=(a009*a732);
  a742=(a742+a732);
  a740=(a740-a742);
  a742=(2.*a740);
  a742=(a678*a742);
  a732=arg[10]? arg[10][54] : 0;
  a743=(a306*a732);
  a744=cos(a419);
  a745=arg[10]? arg[10][53] : 0;
  a746=(a359*a745);
  a747=arg[10]? arg[10][51] : 0;
  a748=(a645*a747);
  a749=arg[10]? arg[10][52] : 0;
  a750=(a521*a749);
  a751=(a307*a747);
  a752=(a296<=a531);
  a531=(a531<=a296);
  a296=(a752+a531);
  a752=(a752/a296);
  a753=(a587/a638);
  a754=(a609*a747);
  a755=(a025<=a369);
  a756=(a369<=a025);
  a756=(a756+a755);
  a755=(a755/a756);
  a755=(a755*a749);
  a756=(2.*a609);
  a755=(a755/a756);
  a756=(a625*a755);
  a754=(a754+a756);
  a753=(a753*a754);
  a752=(a752*a753);
  a531=(a531/a296);
  a296=(a303<=a587);
  a756=(a587<=a303);
  a757=(a296+a756);
  a296=(a296/a757);
  a758=(a061<=a606);
  a759=(a606<=a061);
  a759=(a759+a758);
  a758=(a758/a759);
  a759=arg[10]? arg[10][46] : 0;
  a760=arg[10]? arg[10][47] : 0;
  a761=(a227*a760);
  a762=(a061<=a604);
  a763=(a604<=a061);
  a763=(a763+a762);
  a762=(a762/a763);
  a763=(a111*a435);
  a764=(a138*a405);
  a763=(a763+a764);
  a763=(a763+a488);
  a763=(a763/a236);
  a488=(a604/a236);
  a488=(a488*a503);
  a763=(a763-a488);
  a762=(a762*a763);
  a488=(a605*a762);
  a761=(a761+a488);
  a759=(a759+a761);
  a758=(a758*a759);
  a759=(a545*a758);
  a761=(a740/a249);
  a488=(a545/a249);
  a764=(2.*a522);
  a765=(a311*a116);
  a766=sin(a281);
  a766=(a766*a735);
  a767=(a009*a766);
  a765=(a765-a767);
  a767=(a298*a738);
  a768=cos(a281);
  a768=(a768*a735);
  a769=(a245*a768);
  a767=(a767+a769);
  a765=(a765+a767);
  a764=(a764*a765);
  a764=(a764+a511);
  a511=(2.*a249);
  a511=(a764/a511);
  a488=(a488*a511);
  a761=(a761-a488);
  a488=(a297*a761);
  a759=(a759+a488);
  a759=(a759/a597);
  a488=(a303/a597);
  a767=arg[10]? arg[10][50] : 0;
  a769=(a599*a767);
  a770=(a254<=a387);
  a771=(a387<=a254);
  a771=(a771+a770);
  a770=(a770/a771);
  a771=arg[10]? arg[10][48] : 0;
  a772=arg[10]? arg[10][49] : 0;
  a773=(a227*a772);
  a774=(a600*a762);
  a773=(a773+a774);
  a771=(a771+a773);
  a770=(a770*a771);
  a771=(a585*a770);
  a769=(a769+a771);
  a488=(a488*a769);
  a759=(a759-a488);
  a296=(a296*a759);
  a756=(a756/a757);
  a756=(a756*a753);
  a296=(a296-a756);
  a531=(a531*a296);
  a752=(a752+a531);
  a531=(a625*a752);
  a751=(a751+a531);
  a531=casadi_sq(a283);
  a531=(a068+a531);
  a531=(a751/a531);
  a296=(a586*a531);
  a750=(a750+a296);
  a750=(a750/a625);
  a296=(a302/a625);
  a296=(a296*a747);
  a750=(a750-a296);
  a296=(a342*a752);
  a756=(a307*a749);
  a296=(a296+a756);
  a296=(a750-a296);
  a756=(a625*a296);
  a748=(a748+a756);
  a756=casadi_sq(a635);
  a068=(a068+a756);
  a068=(a748/a068);
  a756=(a615*a068);
  a746=(a746+a756);
  a744=(a744*a746);
  a756=(a584*a744);
  a743=(a743+a756);
  a756=(a677*a743);
  a757=(a061<=a340);
  a340=(a340<=a061);
  a340=(a340+a757);
  a757=(a757/a340);
  a340=(a544<=a551);
  a551=(a551<=a544);
  a544=(a340+a551);
  a340=(a340/a544);
  a488=(2.*a400);
  a771=(a623<=a573);
  a573=(a573<=a623);
  a623=(a573+a771);
  a771=(a771/a623);
  a773=(a282<=a098);
  a282=(a098<=a282);
  a774=(a773+a282);
  a773=(a773/a774);
  a775=arg[10]? arg[10][55] : 0;
  a775=(a775/a597);
  a776=(a426/a597);
  a776=(a776*a769);
  a775=(a775-a776);
  a773=(a773*a775);
  a282=(a282/a774);
  a774=(a765/a582);
  a098=(a098/a582);
  a776=(2.*a333);
  a777=(2.*a248);
  a777=(a777*a512);
  a776=(a776*a777);
  a276=(2.*a276);
  a778=(2.*a522);
  a778=(a778*a765);
  a779=(2.*a581);
  a779=(a779*a740);
  a778=(a778+a779);
  a276=(a276*a778);
  a776=(a776+a276);
  a613=(2.*a613);
  a776=(a776/a613);
  a613=(2.*a582);
  a613=(a776/a613);
  a098=(a098*a613);
  a774=(a774-a098);
  a282=(a282*a774);
  a773=(a773+a282);
  a771=(a771*a773);
  a573=(a573/a623);
  a573=(a573*a775);
  a771=(a771-a573);
  a573=(a061<=a621);
  a621=(a621<=a061);
  a621=(a621+a573);
  a573=(a573/a621);
  a621=(a287*a775);
  a623=(a289*a771);
  a621=(a621-a623);
  a573=(a573*a621);
  a621=(a570*a573);
  a623=(2.*a035);
  a623=(a623*a573);
  a773=(a035*a623);
  a621=(a621+a773);
  a621=(a286*a621);
  a773=(a620*a621);
  a282=(a030*a573);
  a098=(a293*a282);
  a773=(a773-a098);
  a773=(a771+a773);
  a098=(a061<=a058);
  a058=(a058<=a061);
  a058=(a058+a098);
  a098=(a098/a058);
  a058=(a287*a775);
  a771=(a289*a771);
  a058=(a058+a771);
  a098=(a098*a058);
  a058=(a292*a098);
  a771=(2.*a390);
  a771=(a771*a098);
  a276=(a390*a771);
  a058=(a058+a276);
  a058=(a286*a058);
  a276=(a243*a058);
  a779=(a030*a098);
  a780=(a542*a779);
  a276=(a276-a780);
  a773=(a773-a276);
  a488=(a488*a773);
  a386=(2.*a386);
  a488=(a488/a386);
  a340=(a340*a488);
  a551=(a551/a544);
  a544=(a427<=a278);
  a278=(a278<=a427);
  a386=(a278+a544);
  a544=(a544/a386);
  a743=(a547*a743);
  a581=(2.*a581);
  a581=(a581*a740);
  a581=(a581+a764);
  a764=(2.*a547);
  a581=(a581/a764);
  a764=(a269*a581);
  a743=(a743+a764);
  a743=(a743/a582);
  a427=(a427/a582);
  a427=(a427*a613);
  a743=(a743-a427);
  a544=(a544*a743);
  a278=(a278/a386);
  a278=(a278*a488);
  a544=(a544-a278);
  a551=(a551*a544);
  a340=(a340+a551);
  a551=(a289*a340);
  a544=(a287*a488);
  a551=(a551-a544);
  a757=(a757*a551);
  a551=(a334*a757);
  a544=(2.*a356);
  a544=(a544*a757);
  a278=(a356*a544);
  a551=(a551+a278);
  a551=(a286*a551);
  a278=(a658*a551);
  a386=(a657*a762);
  a427=(a656*a769);
  a764=cos(a281);
  a764=(a764*a735);
  a276=(a319*a764);
  a780=(a653*a534);
  a276=(a276+a780);
  a482=(a482+a485);
  a485=(a080*a482);
  a780=(a216*a160);
  a485=(a485+a780);
  a485=(a485+a161);
  a780=(a655*a485);
  a781=sin(a281);
  a781=(a781*a735);
  a782=(a219*a781);
  a780=(a780-a782);
  a276=(a276-a780);
  a780=(a644*a276);
  a782=(a654*a736);
  a780=(a780-a782);
  a782=(a597*a780);
  a427=(a427+a782);
  a782=(a227*a427);
  a386=(a386+a782);
  a782=(a652*a386);
  a278=(a278+a782);
  a278=(a030*a278);
  a544=(a661*a544);
  a782=(a660*a386);
  a783=(a030*a757);
  a784=(a658*a783);
  a782=(a782-a784);
  a782=(a286*a782);
  a334=(a334*a782);
  a544=(a544+a334);
  a278=(a278-a544);
  a544=(2.*a757);
  a663=(a663*a544);
  a661=(a661*a757);
  a356=(a356*a782);
  a661=(a661+a356);
  a662=(a662*a661);
  a663=(a663+a662);
  a278=(a278-a663);
  a634=(a634*a278);
  a278=(a289*a634);
  a278=(a278+a386);
  a663=(a061<=a665);
  a665=(a665<=a061);
  a665=(a665+a663);
  a663=(a663/a665);
  a665=(a287*a488);
  a662=(a289*a340);
  a665=(a665+a662);
  a663=(a663*a665);
  a665=(a030*a663);
  a662=(a658*a665);
  a661=(a669*a386);
  a662=(a662+a661);
  a662=(a286*a662);
  a661=(a668*a662);
  a356=(2.*a667);
  a356=(a356*a663);
  a782=(a670*a356);
  a661=(a661-a782);
  a386=(a672*a386);
  a668=(a668*a663);
  a356=(a667*a356);
  a668=(a668+a356);
  a668=(a286*a668);
  a658=(a658*a668);
  a386=(a386-a658);
  a386=(a030*a386);
  a661=(a661-a386);
  a386=(-a663);
  a386=(2.*a386);
  a674=(a674*a386);
  a667=(a667*a662);
  a670=(a670*a663);
  a667=(a667-a670);
  a673=(a673*a667);
  a674=(a674+a673);
  a661=(a661+a674);
  a666=(a666*a661);
  a661=(a289*a666);
  a278=(a278-a661);
  a543=(a543*a278);
  a555=(a555*a543);
  a661=(a555/a582);
  a674=(a677/a582);
  a674=(a674*a613);
  a661=(a661-a674);
  a269=(a269*a661);
  a756=(a756+a269);
  a756=(a756/a679);
  a679=(a678/a679);
  a269=(2.*a581);
  a679=(a679*a269);
  a756=(a756-a679);
  a629=(a629*a756);
  a742=(a742+a629);
  a758=(a699*a758);
  a629=(a693*a747);
  a679=(a691*a749);
  a745=(a690*a745);
  a732=(a688*a732);
  a677=(a677*a581);
  a547=(a547*a661);
  a677=(a677+a547);
  a584=(a584*a677);
  a732=(a732+a584);
  a687=(a687*a732);
  a419=sin(a419);
  a419=(a419*a746);
  a689=(a689*a419);
  a687=(a687-a689);
  a615=(a615*a687);
  a745=(a745+a615);
  a745=(a745/a692);
  a692=(a691/a692);
  a635=(2.*a635);
  a635=(a635*a748);
  a692=(a692*a635);
  a745=(a745-a692);
  a586=(a586*a745);
  a679=(a679+a586);
  a679=(a679/a694);
  a694=(a693/a694);
  a283=(2.*a283);
  a283=(a283*a751);
  a694=(a694*a283);
  a679=(a679-a694);
  a694=(a625*a679);
  a629=(a629+a694);
  a749=(a696*a749);
  a694=(a691*a747);
  a283=(a625*a745);
  a694=(a694+a283);
  a342=(a342*a694);
  a749=(a749+a342);
  a629=(a629-a749);
  a684=(a684*a629);
  a681=(a681*a684);
  a749=(a681/a597);
  a342=(a699/a597);
  a342=(a342*a769);
  a749=(a749-a342);
  a297=(a297*a749);
  a758=(a758+a297);
  a297=(a758/a249);
  a701=(a701/a249);
  a701=(a701*a511);
  a297=(a297-a701);
  a742=(a742+a297);
  a740=(2.*a740);
  a740=(a731*a740);
  a778=(2.*a778);
  a778=(a730*a778);
  a743=(a743/a582);
  a297=(a704/a582);
  a297=(a297*a613);
  a743=(a743-a297);
  a676=(a676*a743);
  a704=(a704*a555);
  a676=(a676+a704);
  a774=(a774/a582);
  a704=(a706/a582);
  a704=(a704*a613);
  a774=(a774-a704);
  a774=(a727*a774);
  a771=(a664*a771);
  a704=(a717*a762);
  a555=(a715*a769);
  a743=cos(a281);
  a743=(a743*a735);
  a297=(a219*a743);
  a701=(a714*a485);
  a297=(a297+a701);
  a701=(a716*a534);
  a342=sin(a281);
  a342=(a342*a735);
  a283=(a319*a342);
  a701=(a701-a283);
  a297=(a297+a701);
  a701=(a597*a297);
  a555=(a555+a701);
  a701=(a227*a555);
  a704=(a704+a701);
  a701=(2.*a773);
  a701=(a659*a701);
  a634=(a287*a634);
  a666=(a287*a666);
  a634=(a634+a666);
  a554=(a554*a543);
  a648=(a648*a278);
  a554=(a554-a648);
  a634=(a634+a554);
  a634=(a634/a675);
  a659=(a659/a675);
  a488=(-a488);
  a488=(2.*a488);
  a659=(a659*a488);
  a634=(a634-a659);
  a719=(a719*a634);
  a701=(a701+a719);
  a704=(a704+a701);
  a243=(a243*a704);
  a779=(a718*a779);
  a243=(a243-a779);
  a243=(a286*a243);
  a292=(a292*a243);
  a771=(a771+a292);
  a058=(a718*a058);
  a542=(a542*a704);
  a058=(a058+a542);
  a058=(a030*a058);
  a771=(a771-a058);
  a058=(2.*a098);
  a671=(a671*a058);
  a664=(a664*a098);
  a390=(a390*a243);
  a664=(a664+a390);
  a548=(a548*a664);
  a671=(a671+a548);
  a771=(a771+a671);
  a713=(a713*a771);
  a771=(a289*a713);
  a771=(a771-a704);
  a621=(a718*a621);
  a293=(a293*a704);
  a621=(a621+a293);
  a621=(a030*a621);
  a623=(a723*a623);
  a620=(a620*a704);
  a718=(a718*a282);
  a620=(a620-a718);
  a286=(a286*a620);
  a570=(a570*a286);
  a623=(a623+a570);
  a621=(a621-a623);
  a623=(2.*a573);
  a725=(a725*a623);
  a723=(a723*a573);
  a035=(a035*a286);
  a723=(a723+a035);
  a724=(a724*a723);
  a725=(a725+a724);
  a621=(a621-a725);
  a721=(a721*a621);
  a289=(a289*a721);
  a771=(a771-a289);
  a710=(a710*a771);
  a707=(a707*a710);
  a706=(a706*a707);
  a774=(a774+a706);
  a676=(a676+a774);
  a676=(a676/a728);
  a705=(a705/a728);
  a728=(2.*a613);
  a705=(a705*a728);
  a676=(a676-a705);
  a676=(a676/a729);
  a729=(a730/a729);
  a776=(2.*a776);
  a729=(a729*a776);
  a676=(a676-a729);
  a703=(a703*a676);
  a778=(a778+a703);
  a702=(a702*a778);
  a740=(a740+a702);
  a742=(a742-a740);
  a583=(a583*a742);
  a737=(a737+a583);
  a002=(a002-a737);
  a737=(a545/a249);
  a583=(a737*a700);
  a740=(2.*a249);
  a583=(a583/a740);
  a678=(a678-a583);
  a702=(2.*a765);
  a702=(a678*a702);
  a703=(2.*a522);
  a729=(a761/a249);
  a249=(a737/a249);
  a249=(a249*a511);
  a729=(a729-a249);
  a700=(a700*a729);
  a737=(a737*a758);
  a700=(a700+a737);
  a700=(a700/a740);
  a583=(a583/a740);
  a511=(2.*a511);
  a583=(a583*a511);
  a700=(a700-a583);
  a756=(a756-a700);
  a700=(a703*a756);
  a702=(a702+a700);
  a707=(a707/a582);
  a727=(a727/a582);
  a582=(a727/a582);
  a582=(a582*a613);
  a707=(a707-a582);
  a702=(a702+a707);
  a765=(2.*a765);
  a765=(a731*a765);
  a522=(2.*a522);
  a778=(a522*a778);
  a765=(a765+a778);
  a702=(a702-a765);
  a311=(a311*a702);
  a703=(a703*a678);
  a703=(a703+a727);
  a522=(a522*a731);
  a703=(a703-a522);
  a766=(a703*a766);
  a311=(a311-a766);
  a002=(a002+a311);
  a311=arg[2]? arg[2][23] : 0;
  a766=casadi_sq(a202);
  a522=arg[2]? arg[2][24] : 0;
  a731=(a766*a522);
  a311=(a311+a731);
  a731=(a311*a210);
  a727=(a731*a014);
  a727=(a727/a213);
  a765=(a727/a213);
  a778=(a765*a319);
  a707=casadi_sq(a047);
  a707=(a707+a208);
  a582=(a047/a707);
  a613=arg[2]? arg[2][65] : 0;
  a700=arg[2]? arg[2][60] : 0;
  a583=(a700*a210);
  a511=(a583*a080);
  a740=(a613*a511);
  a737=arg[2]? arg[2][57] : 0;
  a758=(a210*a083);
  a729=(a737*a758);
  a740=(a740+a729);
  a729=(a582*a740);
  a778=(a778-a729);
  a212=(a212/a213);
  a729=(a061<=a604);
  a249=(a604<=a061);
  a249=(a249+a729);
  a729=(a729/a249);
  a249=(a672*a669);
  a650=(a650+a249);
  a249=(a652*a660);
  a650=(a650-a249);
  a249=(a650*a657);
  a776=(a400*a717);
  a249=(a249-a776);
  a776=(a061<=a606);
  a606=(a606<=a061);
  a606=(a606+a776);
  a776=(a776/a606);
  a606=(a545*a699);
  a606=(a776*a606);
  a705=(a605*a606);
  a249=(a249+a705);
  a705=(a254<=a387);
  a387=(a387<=a254);
  a387=(a387+a705);
  a705=(a705/a387);
  a387=(a227*a650);
  a728=(a387*a656);
  a774=(a227*a400);
  a706=(a774*a715);
  a728=(a728-a706);
  a303=(a303/a597);
  a706=(a303*a698);
  a728=(a728-a706);
  a426=(a426/a597);
  a305=(a287*a305);
  a722=(a287*a722);
  a305=(a305+a722);
  a708=(a708/a709);
  a726=(a708*a726);
  a711=(a711/a712);
  a720=(a711*a720);
  a726=(a726-a720);
  a305=(a305+a726);
  a726=(a426*a305);
  a728=(a728-a726);
  a726=(a585*a728);
  a726=(a705*a726);
  a720=(a600*a726);
  a249=(a249+a720);
  a249=(a729*a249);
  a720=(a249/a236);
  a712=(a111*a720);
  a709=(a061<=a237);
  a237=(a237<=a061);
  a237=(a237+a709);
  a709=(a709/a237);
  a237=(a339*a336);
  a310=(a310+a237);
  a237=(a314*a327);
  a310=(a310-a237);
  a237=(a310*a324);
  a722=(a061<=a239);
  a239=(a239<=a061);
  a239=(a239+a722);
  a722=(a722/a239);
  a239=(a251*a366);
  a239=(a722*a239);
  a706=(a059*a239);
  a237=(a237+a706);
  a706=(a294*a385);
  a237=(a237+a706);
  a706=(a254<=a257);
  a257=(a257<=a254);
  a257=(a257+a706);
  a706=(a706/a257);
  a257=(a238*a310);
  a289=(a257*a320);
  a252=(a252/a259);
  a621=(a252*a365);
  a289=(a289-a621);
  a621=(a238*a294);
  a725=(a621*a382);
  a289=(a289+a725);
  a280=(a280/a259);
  a331=(a287*a331);
  a391=(a287*a391);
  a331=(a331+a391);
  a375=(a375/a376);
  a394=(a375*a394);
  a378=(a378/a379);
  a388=(a378*a388);
  a394=(a394-a388);
  a331=(a331+a394);
  a394=(a280*a331);
  a289=(a289-a394);
  a394=(a331/a259);
  a388=(a277*a394);
  a289=(a289+a388);
  a388=(a253*a289);
  a388=(a706*a388);
  a379=(a256*a388);
  a237=(a237+a379);
  a379=(a553*a550);
  a328=(a328+a379);
  a379=(a337*a541);
  a328=(a328-a379);
  a379=(a328*a520);
  a237=(a237+a379);
  a379=(a061<=a099);
  a099=(a099<=a061);
  a099=(a099+a379);
  a379=(a379/a099);
  a099=(a513*a580);
  a099=(a379*a099);
  a376=(a059*a099);
  a237=(a237+a376);
  a376=(a326*a596);
  a237=(a237-a376);
  a376=(a254<=a255);
  a255=(a255<=a254);
  a255=(a255+a376);
  a376=(a376/a255);
  a255=(a238*a328);
  a254=(a255*a325);
  a370=(a370/a372);
  a391=(a370*a579);
  a254=(a254-a391);
  a391=(a238*a326);
  a725=(a391*a267);
  a254=(a254-a725);
  a285=(a285/a372);
  a598=(a287*a598);
  a603=(a287*a603);
  a598=(a598+a603);
  a589=(a589/a590);
  a607=(a589*a607);
  a592=(a592/a593);
  a601=(a592*a601);
  a607=(a607-a601);
  a598=(a598+a607);
  a607=(a285*a598);
  a254=(a254-a607);
  a607=(a598/a372);
  a601=(a338*a607);
  a254=(a254+a601);
  a601=(a408*a254);
  a601=(a376*a601);
  a593=(a256*a601);
  a237=(a237+a593);
  a237=(a709*a237);
  a593=(a237/a236);
  a590=(a030*a593);
  a603=(a220*a590);
  a712=(a712-a603);
  a603=(a212*a712);
  a778=(a778+a603);
  a603=(2.*a213);
  a778=(a778/a603);
  a725=2.5000000000000000e-01;
  a206=(a725*a206);
  a724=arg[2]? arg[2][66] : 0;
  a723=casadi_sq(a700);
  a035=(a724*a723);
  a286=(a035*a080);
  a573=arg[2]? arg[2][58] : 0;
  a623=(a573*a700);
  a570=(a623*a083);
  a286=(a286+a570);
  a570=(a023*a286);
  a620=(a010*a570);
  a718=(a206*a620);
  a282=sqrt(a050);
  a704=(2.*a282);
  a718=(a718/a704);
  a293=arg[2]? arg[2][64] : 0;
  a671=arg[1]? arg[1][9] : 0;
  a548=(a293*a671);
  a664=atan2(a047,a213);
  a390=(a613*a664);
  a548=(a548+a390);
  a390=arg[2]? arg[2][67] : 0;
  a243=(a390*a053);
  a548=(a548+a243);
  a243=(a548*a080);
  a098=(a700*a243);
  a058=(a737*a664);
  a542=arg[2]? arg[2][59] : 0;
  a292=(a542*a053);
  a058=(a058+a292);
  a292=(a058*a083);
  a098=(a098+a292);
  a292=(a319/a213);
  a779=(a014*a292);
  a701=(a311*a779);
  a098=(a098-a701);
  a701=(a720-a590);
  a719=(a230*a701);
  a634=(a228*a719);
  a098=(a098+a634);
  a634=(a712/a213);
  a659=(a014*a634);
  a488=(a202*a659);
  a098=(a098-a488);
  a488=(a023*a098);
  a675=(a207*a488);
  a675=(a718+a675);
  a554=(a778+a675);
  a648=(2.*a118);
  a648=(a554*a648);
  a278=(2.*a014);
  a543=arg[10]? arg[10][23] : 0;
  a666=(2.*a202);
  a666=(a666*a465);
  a283=(a522*a666);
  a751=arg[10]? arg[10][24] : 0;
  a586=(a766*a751);
  a283=(a283+a586);
  a543=(a543+a283);
  a283=(a210*a543);
  a586=(a311*a477);
  a283=(a283+a586);
  a586=(a014*a283);
  a692=(a731*a118);
  a586=(a586+a692);
  a586=(a586/a213);
  a692=(a727/a213);
  a692=(a692*a480);
  a586=(a586-a692);
  a692=(a586/a213);
  a635=(a765/a213);
  a635=(a635*a480);
  a692=(a692-a635);
  a692=(a319*a692);
  a765=(a765*a534);
  a692=(a692+a765);
  a765=(a149/a707);
  a635=(a582/a707);
  a748=(2.*a047);
  a748=(a748*a149);
  a748=(a748+a475);
  a635=(a635*a748);
  a765=(a765-a635);
  a765=(a740*a765);
  a635=arg[10]? arg[10][65] : 0;
  a475=(a511*a635);
  a615=arg[10]? arg[10][60] : 0;
  a689=(a210*a615);
  a419=(a700*a477);
  a689=(a689+a419);
  a419=(a080*a689);
  a746=(a583*a160);
  a419=(a419+a746);
  a746=(a613*a419);
  a475=(a475+a746);
  a746=arg[10]? arg[10][57] : 0;
  a732=(a758*a746);
  a584=(a083*a477);
  a547=(a210*a161);
  a584=(a584+a547);
  a547=(a737*a584);
  a732=(a732+a547);
  a475=(a475+a732);
  a582=(a582*a475);
  a765=(a765+a582);
  a692=(a692-a765);
  a478=(a478/a213);
  a765=(a212/a213);
  a765=(a765*a480);
  a478=(a478-a765);
  a478=(a712*a478);
  a765=(a720*a405);
  a672=(a672*a665);
  a669=(a669*a668);
  a672=(a672-a669);
  a340=(a340+a672);
  a660=(a660*a551);
  a652=(a652*a783);
  a660=(a660-a652);
  a340=(a340-a660);
  a657=(a657*a340);
  a427=(a650*a427);
  a657=(a657+a427);
  a717=(a717*a773);
  a555=(a400*a555);
  a717=(a717+a555);
  a657=(a657-a717);
  a760=(a606*a760);
  a699=(a699*a761);
  a545=(a545*a749);
  a699=(a699+a545);
  a776=(a776*a699);
  a605=(a605*a776);
  a760=(a760+a605);
  a657=(a657+a760);
  a772=(a726*a772);
  a767=(a728*a767);
  a650=(a650*a762);
  a340=(a227*a340);
  a650=(a650+a340);
  a656=(a656*a650);
  a780=(a387*a780);
  a656=(a656+a780);
  a400=(a400*a762);
  a773=(a227*a773);
  a400=(a400+a773);
  a715=(a715*a400);
  a297=(a774*a297);
  a715=(a715+a297);
  a656=(a656-a715);
  a759=(a759/a597);
  a715=(a303/a597);
  a715=(a715*a769);
  a759=(a759-a715);
  a698=(a698*a759);
  a303=(a303*a681);
  a698=(a698+a303);
  a656=(a656-a698);
  a775=(a775/a597);
  a698=(a426/a597);
  a698=(a698*a769);
  a775=(a775-a698);
  a775=(a305*a775);
  a713=(a287*a713);
  a721=(a287*a721);
  a713=(a713+a721);
  a708=(a708*a710);
  a711=(a711*a771);
  a708=(a708-a711);
  a713=(a713+a708);
  a426=(a426*a713);
  a775=(a775+a426);
  a656=(a656-a775);
  a585=(a585*a656);
  a767=(a767+a585);
  a705=(a705*a767);
  a600=(a600*a705);
  a772=(a772+a600);
  a657=(a657+a772);
  a729=(a729*a657);
  a657=(a729/a236);
  a772=(a720/a236);
  a772=(a772*a503);
  a657=(a657-a772);
  a772=(a111*a657);
  a765=(a765+a772);
  a487=(a590*a487);
  a339=(a339*a332);
  a336=(a336*a335);
  a339=(a339-a336);
  a309=(a309+a339);
  a327=(a327*a304);
  a314=(a314*a540);
  a327=(a327-a314);
  a309=(a309-a327);
  a324=(a324*a309);
  a299=(a310*a299);
  a324=(a324+a299);
  a299=(a239*a431);
  a366=(a366*a501);
  a251=(a251*a262);
  a366=(a366+a251);
  a722=(a722*a366);
  a366=(a059*a722);
  a299=(a299+a366);
  a324=(a324+a299);
  a385=(a385*a523);
  a371=(a294*a371);
  a385=(a385+a371);
  a324=(a324+a385);
  a385=(a388*a518);
  a514=(a289*a514);
  a309=(a238*a309);
  a310=(a310*a433);
  a309=(a309-a310);
  a320=(a320*a309);
  a505=(a257*a505);
  a320=(a320+a505);
  a432=(a432/a259);
  a505=(a252/a259);
  a505=(a505*a515);
  a432=(a432-a505);
  a365=(a365*a432);
  a252=(a252*a348);
  a365=(a365+a252);
  a320=(a320-a365);
  a523=(a238*a523);
  a294=(a294*a433);
  a523=(a523-a294);
  a382=(a382*a523);
  a416=(a621*a416);
  a382=(a382+a416);
  a320=(a320+a382);
  a526=(a526/a259);
  a382=(a280/a259);
  a382=(a382*a515);
  a526=(a526-a382);
  a331=(a331*a526);
  a380=(a287*a380);
  a389=(a287*a389);
  a380=(a380+a389);
  a375=(a375*a377);
  a378=(a378*a295);
  a375=(a375-a378);
  a380=(a380+a375);
  a280=(a280*a380);
  a331=(a331+a280);
  a320=(a320-a331);
  a525=(a394*a525);
  a380=(a380/a259);
  a331=(a394/a259);
  a331=(a331*a515);
  a380=(a380-a331);
  a277=(a277*a380);
  a525=(a525+a277);
  a320=(a320+a525);
  a253=(a253*a320);
  a514=(a514+a253);
  a706=(a706*a514);
  a514=(a256*a706);
  a385=(a385+a514);
  a324=(a324+a385);
  a553=(a553*a546);
  a550=(a550*a549);
  a553=(a553-a550);
  a272=(a272+a553);
  a541=(a541*a421);
  a337=(a337*a651);
  a541=(a541-a337);
  a272=(a272-a541);
  a520=(a520*a272);
  a300=(a328*a300);
  a520=(a520+a300);
  a324=(a324+a520);
  a431=(a099*a431);
  a580=(a580*a626);
  a513=(a513*a524);
  a580=(a580+a513);
  a379=(a379*a580);
  a059=(a059*a379);
  a431=(a431+a059);
  a324=(a324+a431);
  a596=(a596*a637);
  a595=(a326*a595);
  a596=(a596+a595);
  a324=(a324-a596);
  a518=(a601*a518);
  a631=(a254*a631);
  a272=(a238*a272);
  a328=(a328*a433);
  a272=(a272-a328);
  a325=(a325*a272);
  a628=(a255*a628);
  a325=(a325+a628);
  a430=(a430/a372);
  a628=(a370/a372);
  a628=(a628*a632);
  a430=(a430-a628);
  a579=(a579*a430);
  a370=(a370*a562);
  a579=(a579+a370);
  a325=(a325-a579);
  a637=(a238*a637);
  a326=(a326*a433);
  a637=(a637-a326);
  a267=(a267*a637);
  a313=(a391*a313);
  a267=(a267+a313);
  a325=(a325-a267);
  a640=(a640/a372);
  a267=(a285/a372);
  a267=(a267*a632);
  a640=(a640-a267);
  a598=(a598*a640);
  a594=(a287*a594);
  a287=(a287*a602);
  a594=(a594+a287);
  a589=(a589*a591);
  a592=(a592*a636);
  a589=(a589-a592);
  a594=(a594+a589);
  a285=(a285*a594);
  a598=(a598+a285);
  a325=(a325-a598);
  a639=(a607*a639);
  a594=(a594/a372);
  a598=(a607/a372);
  a598=(a598*a632);
  a594=(a594-a598);
  a338=(a338*a594);
  a639=(a639+a338);
  a325=(a325+a639);
  a408=(a408*a325);
  a631=(a631+a408);
  a376=(a376*a631);
  a256=(a256*a376);
  a518=(a518+a256);
  a324=(a324+a518);
  a709=(a709*a324);
  a324=(a709/a236);
  a593=(a593/a236);
  a593=(a593*a503);
  a324=(a324-a593);
  a324=(a030*a324);
  a220=(a220*a324);
  a487=(a487+a220);
  a765=(a765-a487);
  a212=(a212*a765);
  a478=(a478+a212);
  a692=(a692+a478);
  a692=(a692/a603);
  a778=(a778/a603);
  a603=(2.*a480);
  a778=(a778*a603);
  a692=(a692-a778);
  a472=(a725*a472);
  a778=(a620*a472);
  a603=(a570*a008);
  a478=(a286*a131);
  a212=arg[10]? arg[10][66] : 0;
  a487=(a723*a212);
  a220=(2.*a700);
  a220=(a220*a615);
  a593=(a724*a220);
  a487=(a487+a593);
  a593=(a080*a487);
  a518=(a035*a160);
  a593=(a593+a518);
  a518=arg[10]? arg[10][58] : 0;
  a256=(a700*a518);
  a631=(a573*a615);
  a256=(a256+a631);
  a631=(a083*a256);
  a408=(a623*a161);
  a631=(a631+a408);
  a593=(a593+a631);
  a631=(a023*a593);
  a478=(a478+a631);
  a631=(a010*a478);
  a603=(a603+a631);
  a631=(a206*a603);
  a778=(a778+a631);
  a778=(a778/a704);
  a718=(a718/a704);
  a704=(2.*a282);
  a704=(a476/a704);
  a631=(2.*a704);
  a718=(a718*a631);
  a778=(a778-a718);
  a473=(a488*a473);
  a718=(a098*a131);
  a631=(a243*a615);
  a408=arg[10]? arg[10][64] : 0;
  a338=(a671*a408);
  a598=arg[9]? arg[9][9] : 0;
  a285=(a293*a598);
  a338=(a338+a285);
  a635=(a664*a635);
  a285=casadi_sq(a047);
  a285=(a285+a208);
  a208=(a213/a285);
  a208=(a208*a149);
  a285=(a047/a285);
  a285=(a285*a480);
  a208=(a208-a285);
  a613=(a613*a208);
  a635=(a635+a613);
  a338=(a338+a635);
  a635=arg[10]? arg[10][67] : 0;
  a613=(a053*a635);
  a285=(a390*a139);
  a613=(a613+a285);
  a338=(a338+a613);
  a613=(a080*a338);
  a285=(a548*a160);
  a613=(a613+a285);
  a285=(a700*a613);
  a631=(a631+a285);
  a746=(a664*a746);
  a737=(a737*a208);
  a746=(a746+a737);
  a737=arg[10]? arg[10][59] : 0;
  a285=(a053*a737);
  a589=(a542*a139);
  a285=(a285+a589);
  a746=(a746+a285);
  a285=(a083*a746);
  a589=(a058*a161);
  a285=(a285+a589);
  a631=(a631+a285);
  a543=(a779*a543);
  a285=(a292*a118);
  a589=(a534/a213);
  a592=(a292/a213);
  a592=(a592*a480);
  a589=(a589-a592);
  a592=(a014*a589);
  a285=(a285+a592);
  a311=(a311*a285);
  a543=(a543+a311);
  a631=(a631-a543);
  a493=(a719*a493);
  a497=(a701*a497);
  a543=(a657-a324);
  a230=(a230*a543);
  a497=(a497+a230);
  a228=(a228*a497);
  a493=(a493+a228);
  a631=(a631+a493);
  a493=(a659*a465);
  a118=(a634*a118);
  a228=(a765/a213);
  a230=(a634/a213);
  a230=(a230*a480);
  a228=(a228-a230);
  a014=(a014*a228);
  a118=(a118+a014);
  a014=(a202*a118);
  a493=(a493+a014);
  a631=(a631-a493);
  a493=(a023*a631);
  a718=(a718+a493);
  a207=(a207*a718);
  a473=(a473+a207);
  a778=(a778+a473);
  a692=(a692+a778);
  a692=(a278*a692);
  a648=(a648+a692);
  a283=(a292*a283);
  a589=(a731*a589);
  a283=(a283+a589);
  a470=(a634*a470);
  a228=(a211*a228);
  a470=(a470+a228);
  a283=(a283+a470);
  a648=(a648-a283);
  a002=(a002+a648);
  a019=(2.*a019);
  a283=(a224*a701);
  a283=(a283-a712);
  a470=(a189*a283);
  a228=(a030*a470);
  a171=(2.*a171);
  a228=(a228/a171);
  a589=(a019*a228);
  a692=(a030*a470);
  a692=(a589+a692);
  a473=(a692*a458);
  a457=(2.*a457);
  a457=(a228*a457);
  a453=(a283*a453);
  a490=(a701*a490);
  a224=(a224*a543);
  a490=(a490+a224);
  a490=(a490-a765);
  a189=(a189*a490);
  a453=(a453+a189);
  a189=(a030*a453);
  a189=(a189/a171);
  a228=(a228/a171);
  a460=(2.*a460);
  a228=(a228*a460);
  a189=(a189-a228);
  a019=(a019*a189);
  a457=(a457+a019);
  a019=(a030*a453);
  a019=(a457+a019);
  a189=(a169*a019);
  a473=(a473+a189);
  a189=(a168*a692);
  a228=(2.*a169);
  a189=(a189/a228);
  a460=(2.*a456);
  a460=(a189*a460);
  a171=(2.*a168);
  a456=(a692*a456);
  a168=(a168*a019);
  a456=(a456+a168);
  a456=(a456/a228);
  a228=(a189/a228);
  a458=(2.*a458);
  a228=(a228*a458);
  a456=(a456-a228);
  a456=(a171*a456);
  a460=(a460+a456);
  a473=(a473+a460);
  a002=(a002+a473);
  if (res[0]!=0) res[0][0]=a002;
  a002=cos(a001);
  a002=(a002*a005);
  a460=sin(a001);
  a460=(a460*a003);
  a460=(a000*a460);
  a002=(a002-a460);
  a460=cos(a001);
  a460=(a460*a003);
  a460=(a007*a460);
  a456=sin(a001);
  a456=(a456*a006);
  a460=(a460+a456);
  a002=(a002-a460);
  a049=(a049/a085);
  a051=(a051/a085);
  a085=(a051/a085);
  a085=(a085*a166);
  a049=(a049-a085);
  a049=(a104*a049);
  a085=(a051*a034);
  a049=(a049+a085);
  a140=(2.*a140);
  a140=(a084*a140);
  a044=(2.*a044);
  a157=(a044*a157);
  a140=(a140+a157);
  a049=(a049-a140);
  a002=(a002+a049);
  a140=(a086*a415);
  a410=(a347*a410);
  a140=(a140-a410);
  a410=(a508*a618);
  a616=(a561*a616);
  a410=(a410-a616);
  a140=(a140+a410);
  a410=(a641-a527);
  a510=(a410*a510);
  a616=(a610-a397);
  a157=(a244*a616);
  a510=(a510+a157);
  a140=(a140+a510);
  a002=(a002+a140);
  a510=(a288*a742);
  a741=(a680*a741);
  a510=(a510-a741);
  a768=(a703*a768);
  a741=(a298*a702);
  a768=(a768+a741);
  a510=(a510+a768);
  a002=(a002+a510);
  a480=(a480/a707);
  a213=(a213/a707);
  a707=(a213/a707);
  a707=(a707*a748);
  a480=(a480-a707);
  a480=(a740*a480);
  a475=(a213*a475);
  a480=(a480+a475);
  a149=(2.*a149);
  a149=(a675*a149);
  a047=(2.*a047);
  a778=(a047*a778);
  a149=(a149+a778);
  a480=(a480+a149);
  a002=(a002+a480);
  a149=(a318*a008);
  a778=(a010*a533);
  a149=(a149+a778);
  a002=(a002+a149);
  if (res[0]!=0) res[0][1]=a002;
  a002=arg[12]? arg[12][5] : 0;
  a149=(a004*a116);
  a778=(a009*a011);
  a149=(a149+a778);
  a002=(a002-a149);
  a472=(a282*a472);
  a149=(a206*a704);
  a472=(a472+a149);
  a570=(a570*a472);
  a206=(a206*a282);
  a478=(a206*a478);
  a570=(a570+a478);
  a002=(a002+a570);
  a051=(a051*a104);
  a044=(a044*a084);
  a051=(a051-a044);
  a044=(a051*a142);
  a084=(a040*a049);
  a044=(a044+a084);
  a002=(a002+a044);
  a274=(a274*a641);
  a065=(a065*a347);
  a242=(a242*a527);
  a065=(a065+a242);
  a395=(a395*a561);
  a065=(a065+a395);
  a274=(a274-a065);
  a413=(a274*a413);
  a402=(a402+a507);
  a402=(a402+a614);
  a509=(a509-a402);
  a107=(a107*a509);
  a413=(a413+a107);
  a413=(a030*a413);
  a002=(a002+a413);
  a086=(a086*a347);
  a508=(a508*a561);
  a086=(a086+a508);
  a244=(a244*a410);
  a086=(a086+a244);
  a244=(a086*a405);
  a508=(a111*a140);
  a244=(a244+a508);
  a002=(a002+a244);
  a288=(a288*a680);
  a298=(a298*a703);
  a288=(a288+a298);
  a739=(a288*a739);
  a630=(a630*a510);
  a739=(a739+a630);
  a002=(a002+a739);
  a739=(a318*a148);
  a630=(a045*a533);
  a739=(a739+a630);
  a002=(a002+a739);
  if (res[0]!=0) res[0][2]=a002;
  if (res[0]!=0) res[0][3]=a061;
  if (res[0]!=0) res[0][4]=a061;
  a002=cos(a001);
  a739=(a000*a116);
  a630=(a009*a005);
  a739=(a739+a630);
  a002=(a002*a739);
  a739=(a009*a000);
  a630=sin(a001);
  a630=(a630*a003);
  a739=(a739*a630);
  a002=(a002-a739);
  a739=(a045*a000);
  a630=cos(a001);
  a630=(a630*a003);
  a739=(a739*a630);
  a630=sin(a001);
  a000=(a000*a148);
  a005=(a045*a005);
  a000=(a000+a005);
  a630=(a630*a000);
  a739=(a739+a630);
  a002=(a002-a739);
  a739=cos(a001);
  a148=(a007*a148);
  a630=(a045*a006);
  a148=(a148+a630);
  a739=(a739*a148);
  a045=(a045*a007);
  a148=sin(a001);
  a148=(a148*a003);
  a045=(a045*a148);
  a739=(a739-a045);
  a002=(a002-a739);
  a739=(a009*a007);
  a045=cos(a001);
  a045=(a045*a003);
  a739=(a739*a045);
  a045=sin(a001);
  a007=(a007*a116);
  a006=(a009*a006);
  a007=(a007+a006);
  a045=(a045*a007);
  a739=(a739+a045);
  a002=(a002-a739);
  a739=cos(a001);
  a213=(a213*a740);
  a047=(a047*a675);
  a213=(a213+a047);
  a213=(a051+a213);
  a047=(a213*a117);
  a480=(a049+a480);
  a675=(a012*a480);
  a047=(a047+a675);
  a739=(a739*a047);
  a047=(a012*a213);
  a675=sin(a001);
  a675=(a675*a003);
  a047=(a047*a675);
  a739=(a739-a047);
  a002=(a002+a739);
  a739=(a015*a213);
  a047=cos(a001);
  a047=(a047*a003);
  a739=(a739*a047);
  a047=sin(a001);
  a675=(a213*a120);
  a740=(a015*a480);
  a675=(a675+a740);
  a047=(a047*a675);
  a739=(a739+a047);
  a002=(a002+a739);
  a739=cos(a001);
  a018=(a018*a114);
  a112=(a112*a108);
  a018=(a018+a112);
  a278=(a278*a554);
  a731=(a731*a292);
  a211=(a211*a634);
  a731=(a731+a211);
  a278=(a278-a731);
  a018=(a018-a278);
  a169=(a169*a692);
  a171=(a171*a189);
  a169=(a169+a171);
  a018=(a018-a169);
  a120=(a018*a120);
  a123=(a123-a648);
  a123=(a123-a473);
  a473=(a015*a123);
  a120=(a120+a473);
  a739=(a739*a120);
  a015=(a015*a018);
  a120=sin(a001);
  a120=(a120*a003);
  a015=(a015*a120);
  a739=(a739-a015);
  a002=(a002+a739);
  a739=(a012*a018);
  a015=cos(a001);
  a015=(a015*a003);
  a739=(a739*a015);
  a001=sin(a001);
  a117=(a018*a117);
  a012=(a012*a123);
  a117=(a117+a012);
  a001=(a001*a117);
  a739=(a739+a001);
  a002=(a002-a739);
  if (res[0]!=0) res[0][5]=a002;
  a152=(a213*a152);
  a048=(a048*a480);
  a152=(a152+a048);
  a013=(a013*a123);
  a119=(a018*a119);
  a013=(a013-a119);
  a152=(a152+a013);
  if (res[1]!=0) res[1][0]=a152;
  a018=(a018*a122);
  a016=(a016*a123);
  a018=(a018+a016);
  a046=(a046*a480);
  a213=(a213*a150);
  a046=(a046-a213);
  a018=(a018-a046);
  if (res[1]!=0) res[1][1]=a018;
  a018=(a235*a701);
  a500=(a018*a500);
  a235=(a235*a543);
  a502=(a701*a502);
  a235=(a235-a502);
  a233=(a233*a235);
  a500=(a500+a233);
  a500=(a534+a500);
  a132=(-a132);
  a132=(2.*a132);
  a132=(a132-a163);
  a457=(2.*a457);
  a132=(a132+a457);
  a132=(a132+a453);
  a453=(a132/a026);
  a113=(-a113);
  a113=(2.*a113);
  a113=(a113-a110);
  a589=(2.*a589);
  a113=(a113+a589);
  a113=(a113+a470);
  a470=(a113/a026);
  a470=(a470/a026);
  a470=(a470*a129);
  a453=(a453-a470);
  a500=(a500+a453);
  if (res[1]!=0) res[1][2]=a500;
  a500=(a229*a701);
  a499=(a500*a499);
  a495=(a701*a495);
  a229=(a229*a543);
  a495=(a495+a229);
  a232=(a232*a495);
  a499=(a499+a232);
  a232=(a173<=a072);
  a072=(a072<=a173);
  a173=(a072+a232);
  a232=(a232/a173);
  a229=(a071<=a174);
  a174=(a174<=a071);
  a071=(a174+a229);
  a229=(a229/a071);
  a453=(a061<=a137);
  a137=(a137<=a061);
  a137=(a137+a453);
  a453=(a453/a137);
  a137=(a170*a283);
  a470=(a188*a137);
  a589=(a023*a470);
  a110=(a185*a589);
  a110=(a030*a110);
  a457=(a183*a110);
  a457=(a030*a457);
  a163=(a184*a110);
  a163=(a060*a163);
  a233=(a182*a163);
  a457=(a457-a233);
  a233=(2.*a175);
  a502=(a175*a163);
  a046=(a233*a502);
  a457=(a457-a046);
  a457=(a453*a457);
  a457=(a064*a457);
  a457=(a457+a110);
  a046=(a061<=a176);
  a176=(a176<=a061);
  a176=(a176+a046);
  a046=(a046/a176);
  a176=(a180*a110);
  a176=(a060*a176);
  a213=(a178*a176);
  a150=(a179*a110);
  a150=(a030*a150);
  a213=(a213-a150);
  a150=(2.*a177);
  a480=(a177*a176);
  a016=(a150*a480);
  a213=(a213+a016);
  a213=(a046*a213);
  a213=(a064*a213);
  a457=(a457-a213);
  a457=(a229*a457);
  a457=(a232*a457);
  a213=(a151*a457);
  a446=(a213*a446);
  a441=(a457*a441);
  a442=(a110*a442);
  a451=(a589*a451);
  a016=(a470*a131);
  a454=(a137*a454);
  a283=(a283*a459);
  a170=(a170*a490);
  a283=(a283+a170);
  a188=(a188*a283);
  a454=(a454+a188);
  a188=(a023*a454);
  a016=(a016+a188);
  a185=(a185*a016);
  a451=(a451+a185);
  a451=(a030*a451);
  a183=(a183*a451);
  a442=(a442+a183);
  a442=(a030*a442);
  a436=(a163*a436);
  a184=(a184*a451);
  a450=(a110*a450);
  a184=(a184-a450);
  a184=(a060*a184);
  a182=(a182*a184);
  a436=(a436+a182);
  a442=(a442-a436);
  a436=(2.*a447);
  a502=(a502*a436);
  a163=(a163*a447);
  a175=(a175*a184);
  a163=(a163+a175);
  a233=(a233*a163);
  a502=(a502+a233);
  a442=(a442-a502);
  a453=(a453*a442);
  a442=(a064*a453);
  a442=(a442+a451);
  a439=(a176*a439);
  a180=(a180*a451);
  a443=(a110*a443);
  a180=(a180-a443);
  a180=(a060*a180);
  a178=(a178*a180);
  a439=(a439+a178);
  a110=(a110*a438);
  a179=(a179*a451);
  a110=(a110+a179);
  a110=(a030*a110);
  a439=(a439-a110);
  a110=(2.*a437);
  a480=(a480*a110);
  a176=(a176*a437);
  a177=(a177*a180);
  a176=(a176+a177);
  a150=(a150*a176);
  a480=(a480+a150);
  a439=(a439+a480);
  a046=(a046*a439);
  a439=(a064*a046);
  a442=(a442-a439);
  a229=(a229*a442);
  a232=(a232*a229);
  a151=(a151*a232);
  a441=(a441+a151);
  a075=(a075*a441);
  a446=(a446+a075);
  a499=(a499+a446);
  if (res[1]!=0) res[1][3]=a499;
  a607=(a607*a642);
  a308=(a308*a594);
  a607=(a607+a308);
  if (res[1]!=0) res[1][4]=a607;
  a394=(a394*a528);
  a279=(a279*a380);
  a394=(a394+a279);
  if (res[1]!=0) res[1][5]=a394;
  a394=sin(a281);
  a279=(a387*a597);
  a528=(a279*a644);
  a607=(a528*a219);
  a308=(a394*a607);
  a642=cos(a281);
  a499=(a774*a597);
  a446=(a499*a219);
  a075=(a642*a446);
  a308=(a308-a075);
  a075=sin(a281);
  a151=(a499*a319);
  a439=(a075*a151);
  a308=(a308+a439);
  a439=cos(a281);
  a480=(a528*a319);
  a150=(a439*a480);
  a308=(a308+a150);
  a150=cos(a281);
  a176=(a009*a680);
  a177=(a150*a176);
  a308=(a308-a177);
  a177=sin(a281);
  a180=(a245*a680);
  a437=(a177*a180);
  a308=(a308-a437);
  a437=cos(a281);
  a110=(a245*a703);
  a179=(a437*a110);
  a308=(a308+a179);
  a179=sin(a281);
  a451=(a009*a703);
  a438=(a179*a451);
  a308=(a308-a438);
  a438=(a588*a308);
  a734=(a438*a734);
  a178=cos(a281);
  a178=(a178*a735);
  a607=(a607*a178);
  a650=(a597*a650);
  a387=(a387*a769);
  a650=(a650+a387);
  a644=(a644*a650);
  a387=(a279*a736);
  a644=(a644-a387);
  a387=(a219*a644);
  a178=(a528*a485);
  a387=(a387+a178);
  a394=(a394*a387);
  a607=(a607+a394);
  a400=(a597*a400);
  a774=(a774*a769);
  a400=(a400+a774);
  a219=(a219*a400);
  a485=(a499*a485);
  a219=(a219+a485);
  a642=(a642*a219);
  a219=sin(a281);
  a219=(a219*a735);
  a446=(a446*a219);
  a642=(a642-a446);
  a607=(a607-a642);
  a642=cos(a281);
  a642=(a642*a735);
  a151=(a151*a642);
  a642=(a319*a400);
  a446=(a499*a534);
  a642=(a642+a446);
  a075=(a075*a642);
  a151=(a151+a075);
  a607=(a607+a151);
  a319=(a319*a644);
  a534=(a528*a534);
  a319=(a319+a534);
  a439=(a439*a319);
  a319=sin(a281);
  a319=(a319*a735);
  a480=(a480*a319);
  a439=(a439-a480);
  a607=(a607+a439);
  a439=(a680*a116);
  a480=(a009*a742);
  a439=(a439+a480);
  a150=(a150*a439);
  a439=sin(a281);
  a439=(a439*a735);
  a176=(a176*a439);
  a150=(a150-a176);
  a607=(a607-a150);
  a150=cos(a281);
  a150=(a150*a735);
  a180=(a180*a150);
  a680=(a680*a738);
  a742=(a245*a742);
  a680=(a680+a742);
  a177=(a177*a680);
  a180=(a180+a177);
  a607=(a607-a180);
  a738=(a703*a738);
  a245=(a245*a702);
  a738=(a738+a245);
  a437=(a437*a738);
  a738=sin(a281);
  a738=(a738*a735);
  a110=(a110*a738);
  a437=(a437-a110);
  a607=(a607+a437);
  a281=cos(a281);
  a281=(a281*a735);
  a451=(a451*a281);
  a703=(a703*a116);
  a009=(a009*a702);
  a703=(a703+a009);
  a179=(a179*a703);
  a451=(a451+a179);
  a607=(a607-a451);
  a588=(a588*a607);
  a736=(a308*a736);
  a588=(a588-a736);
  a612=(a612*a588);
  a734=(a734+a612);
  a612=(a390*a511);
  a736=(a542*a758);
  a612=(a612+a736);
  a736=(a056*a104);
  a612=(a612-a736);
  a153=(a612*a153);
  a635=(a511*a635);
  a390=(a390*a419);
  a635=(a635+a390);
  a737=(a758*a737);
  a542=(a542*a584);
  a737=(a737+a542);
  a635=(a635+a737);
  a154=(a104*a154);
  a056=(a056*a034);
  a154=(a154+a056);
  a635=(a635-a154);
  a055=(a055*a635);
  a153=(a153+a055);
  a734=(a734-a153);
  if (res[1]!=0) res[1][6]=a734;
  if (res[1]!=0) res[1][7]=a588;
  if (res[1]!=0) res[1][8]=a635;
  a408=(a511*a408);
  a293=(a293*a419);
  a408=(a408+a293);
  if (res[1]!=0) res[1][9]=a408;
  a408=(a080*a146);
  a293=(a043*a160);
  a408=(a408+a293);
  a408=(a161-a408);
  if (res[1]!=0) res[1][10]=a408;
  a523=(a259*a523);
  a408=(a621*a515);
  a523=(a523+a408);
  a408=(a381*a523);
  a621=(a621*a259);
  a301=(a621*a301);
  a408=(a408+a301);
  a309=(a259*a309);
  a515=(a257*a515);
  a309=(a309+a515);
  a515=(a321*a309);
  a257=(a257*a259);
  a538=(a257*a538);
  a515=(a515-a538);
  a408=(a408-a515);
  a538=(a080*a408);
  a381=(a621*a381);
  a321=(a257*a321);
  a381=(a381-a321);
  a259=(a381*a160);
  a538=(a538+a259);
  a637=(a372*a637);
  a259=(a391*a632);
  a637=(a637+a259);
  a259=(a341*a637);
  a391=(a391*a372);
  a036=(a391*a036);
  a259=(a259+a036);
  a272=(a372*a272);
  a632=(a255*a632);
  a272=(a272+a632);
  a632=(a312*a272);
  a255=(a255*a372);
  a649=(a255*a649);
  a632=(a632-a649);
  a259=(a259+a632);
  a632=(a080*a259);
  a341=(a391*a341);
  a312=(a255*a312);
  a341=(a341+a312);
  a312=(a341*a160);
  a632=(a632+a312);
  a538=(a538-a632);
  a632=(a086*a008);
  a140=(a010*a140);
  a632=(a632+a140);
  a538=(a538+a632);
  a479=(a479/a236);
  a221=(a221/a236);
  a632=(a221/a236);
  a632=(a632*a503);
  a479=(a479-a632);
  a479=(a237*a479);
  a709=(a221*a709);
  a479=(a479+a709);
  a763=(a763/a236);
  a604=(a604/a236);
  a236=(a604/a236);
  a236=(a236*a503);
  a763=(a763-a236);
  a763=(a249*a763);
  a729=(a604*a729);
  a763=(a763+a729);
  a479=(a479-a763);
  a538=(a538+a479);
  a763=(a720*a435);
  a657=(a138*a657);
  a763=(a763+a657);
  a538=(a538+a763);
  a121=(a121*a538);
  a763=(a381*a080);
  a657=(a341*a080);
  a763=(a763-a657);
  a086=(a010*a086);
  a763=(a763+a086);
  a221=(a221*a237);
  a604=(a604*a249);
  a221=(a221-a604);
  a763=(a763+a221);
  a720=(a138*a720);
  a763=(a763+a720);
  a406=(a763*a406);
  a121=(a121-a406);
  if (res[2]!=0) res[2][0]=a121;
  a121=arg[1]? arg[1][10] : 0;
  a406=(a121*a080);
  a720=(a010*a051);
  a604=(a077*a094);
  a249=(a604*a080);
  a720=(a720-a249);
  a406=(a406+a720);
  a249=(a041*a406);
  a237=cos(a038);
  a237=(a237*a144);
  a249=(a249*a237);
  a237=sin(a038);
  a145=(a406*a145);
  a086=arg[9]? arg[9][10] : 0;
  a657=(a080*a086);
  a729=(a121*a160);
  a657=(a657+a729);
  a051=(a051*a008);
  a049=(a010*a049);
  a051=(a051+a049);
  a094=(a094*a156);
  a077=(a077*a124);
  a094=(a094+a077);
  a077=(a080*a094);
  a124=(a604*a160);
  a077=(a077+a124);
  a051=(a051-a077);
  a657=(a657+a051);
  a041=(a041*a657);
  a145=(a145+a041);
  a237=(a237*a145);
  a249=(a249+a237);
  a237=cos(a038);
  a141=(a720*a141);
  a145=(a037*a051);
  a141=(a141+a145);
  a237=(a237*a141);
  a037=(a037*a720);
  a141=sin(a038);
  a141=(a141*a144);
  a037=(a037*a141);
  a237=(a237-a037);
  a249=(a249+a237);
  a237=cos(a038);
  a037=(a010*a288);
  a141=(a499*a714);
  a145=(a528*a655);
  a141=(a141+a145);
  a145=(a141*a080);
  a041=(a138*a590);
  a077=(a145+a041);
  a077=(a037-a077);
  a077=(a077-a221);
  a484=(a077*a484);
  a288=(a288*a008);
  a510=(a010*a510);
  a288=(a288+a510);
  a714=(a714*a400);
  a743=(a499*a743);
  a714=(a714+a743);
  a655=(a655*a644);
  a781=(a528*a781);
  a655=(a655-a781);
  a714=(a714+a655);
  a655=(a080*a714);
  a781=(a141*a160);
  a655=(a655+a781);
  a590=(a590*a435);
  a138=(a138*a324);
  a590=(a590+a138);
  a138=(a655+a590);
  a138=(a288-a138);
  a138=(a138-a479);
  a324=(a217*a138);
  a484=(a484+a324);
  a237=(a237*a484);
  a217=(a217*a077);
  a484=sin(a038);
  a484=(a484*a144);
  a217=(a217*a484);
  a237=(a237-a217);
  a249=(a249+a237);
  a145=(a145+a041);
  a037=(a037-a145);
  a037=(a037-a221);
  a221=(a214*a037);
  a145=cos(a038);
  a145=(a145*a144);
  a221=(a221*a145);
  a145=sin(a038);
  a481=(a037*a481);
  a655=(a655+a590);
  a288=(a288-a655);
  a288=(a288-a479);
  a214=(a214*a288);
  a481=(a481+a214);
  a145=(a145*a481);
  a221=(a221+a145);
  a249=(a249-a221);
  a221=(a234*a701);
  a145=cos(a038);
  a145=(a145*a144);
  a221=(a221*a145);
  a145=sin(a038);
  a496=(a701*a496);
  a234=(a234*a543);
  a496=(a496+a234);
  a145=(a145*a496);
  a221=(a221+a145);
  a249=(a249-a221);
  a498=(a500*a498);
  a231=(a231*a495);
  a498=(a498+a231);
  a249=(a249+a498);
  a498=cos(a038);
  a231=(a190*a701);
  a492=(a231*a492);
  a701=(a701*a455);
  a190=(a190*a543);
  a701=(a701+a190);
  a190=(a225*a701);
  a492=(a492+a190);
  a498=(a498*a492);
  a225=(a225*a231);
  a492=sin(a038);
  a492=(a492*a144);
  a225=(a225*a492);
  a498=(a498-a225);
  a249=(a249+a498);
  a498=(a222*a231);
  a225=cos(a038);
  a225=(a225*a144);
  a498=(a498*a225);
  a225=sin(a038);
  a489=(a231*a489);
  a222=(a222*a701);
  a489=(a489+a222);
  a225=(a225*a489);
  a498=(a498+a225);
  a249=(a249-a498);
  a498=cos(a038);
  a407=(a763*a407);
  a225=(a115*a538);
  a407=(a407+a225);
  a498=(a498*a407);
  a115=(a115*a763);
  a407=sin(a038);
  a407=(a407*a144);
  a115=(a115*a407);
  a498=(a498-a115);
  a249=(a249+a498);
  a498=(a028*a763);
  a115=cos(a038);
  a115=(a115*a144);
  a498=(a498*a115);
  a115=sin(a038);
  a404=(a763*a404);
  a028=(a028*a538);
  a404=(a404+a028);
  a115=(a115*a404);
  a498=(a498+a115);
  a249=(a249-a498);
  a498=(a193<=a033);
  a033=(a033<=a193);
  a193=(a033+a498);
  a498=(a498/a193);
  a115=(a192<=a195);
  a195=(a195<=a192);
  a192=(a195+a115);
  a115=(a115/a192);
  a404=(a061<=a191);
  a191=(a191<=a061);
  a191=(a191+a404);
  a404=(a404/a191);
  a202=(2.*a202);
  a191=(a210*a779);
  a028=(a522*a191);
  a407=(a202*a028);
  a225=(a210*a659);
  a407=(a407+a225);
  a225=(a205*a407);
  a225=(a060*a225);
  a489=(a203*a225);
  a222=(a204*a407);
  a222=(a030*a222);
  a489=(a489-a222);
  a222=(2.*a196);
  a492=(a196*a225);
  a190=(a222*a492);
  a489=(a489+a190);
  a489=(a404*a489);
  a489=(a064*a489);
  a489=(a489-a407);
  a190=(a061<=a197);
  a197=(a197<=a061);
  a197=(a197+a190);
  a190=(a190/a197);
  a197=(a200*a407);
  a197=(a030*a197);
  a543=(a201*a407);
  a543=(a060*a543);
  a455=(a199*a543);
  a197=(a197-a455);
  a455=(2.*a198);
  a221=(a198*a543);
  a145=(a455*a221);
  a197=(a197-a145);
  a197=(a190*a197);
  a197=(a064*a197);
  a489=(a489-a197);
  a489=(a115*a489);
  a489=(a498*a489);
  a468=(a489*a468);
  a461=(a225*a461);
  a465=(2.*a465);
  a028=(a028*a465);
  a751=(a191*a751);
  a779=(a779*a477);
  a285=(a210*a285);
  a779=(a779+a285);
  a522=(a522*a779);
  a751=(a751+a522);
  a202=(a202*a751);
  a028=(a028+a202);
  a659=(a659*a477);
  a118=(a210*a118);
  a659=(a659+a118);
  a028=(a028+a659);
  a205=(a205*a028);
  a471=(a407*a471);
  a205=(a205-a471);
  a205=(a060*a205);
  a203=(a203*a205);
  a461=(a461+a203);
  a467=(a407*a467);
  a204=(a204*a028);
  a467=(a467+a204);
  a467=(a030*a467);
  a461=(a461-a467);
  a467=(2.*a469);
  a492=(a492*a467);
  a225=(a225*a469);
  a196=(a196*a205);
  a225=(a225+a196);
  a222=(a222*a225);
  a492=(a492+a222);
  a461=(a461+a492);
  a404=(a404*a461);
  a461=(a064*a404);
  a461=(a461-a028);
  a463=(a407*a463);
  a200=(a200*a028);
  a463=(a463+a200);
  a463=(a030*a463);
  a464=(a543*a464);
  a201=(a201*a028);
  a407=(a407*a466);
  a201=(a201-a407);
  a060=(a060*a201);
  a199=(a199*a060);
  a464=(a464+a199);
  a463=(a463-a464);
  a464=(2.*a462);
  a221=(a221*a464);
  a543=(a543*a462);
  a198=(a198*a060);
  a543=(a543+a198);
  a455=(a455*a543);
  a221=(a221+a455);
  a463=(a463-a221);
  a190=(a190*a463);
  a064=(a064*a190);
  a461=(a461-a064);
  a115=(a115*a461);
  a498=(a498*a115);
  a194=(a194*a498);
  a468=(a468+a194);
  a249=(a249+a468);
  a167=(a167*a441);
  a448=(a213*a448);
  a167=(a167-a448);
  a249=(a249+a167);
  if (res[2]!=0) res[2][1]=a249;
  a249=cos(a109);
  a167=(a322*a523);
  a535=(a621*a535);
  a167=(a167+a535);
  a249=(a249*a167);
  a322=(a621*a322);
  a167=sin(a109);
  a167=(a167*a401);
  a322=(a322*a167);
  a249=(a249-a322);
  a322=(a255*a539);
  a167=cos(a109);
  a167=(a167*a401);
  a322=(a322*a167);
  a167=sin(a109);
  a535=(a539*a272);
  a448=(a255*a647);
  a535=(a535+a448);
  a167=(a167*a535);
  a322=(a322+a167);
  a249=(a249+a322);
  a322=cos(a109);
  a167=(a539*a637);
  a647=(a391*a647);
  a167=(a167+a647);
  a322=(a322*a167);
  a539=(a391*a539);
  a167=sin(a109);
  a167=(a167*a401);
  a539=(a539*a167);
  a322=(a322-a539);
  a249=(a249-a322);
  a322=(a257*a323);
  a539=cos(a109);
  a539=(a539*a401);
  a322=(a322*a539);
  a539=sin(a109);
  a323=(a323*a309);
  a536=(a257*a536);
  a323=(a323+a536);
  a539=(a539*a323);
  a322=(a322+a539);
  a249=(a249+a322);
  a322=cos(a109);
  a539=(a083*a523);
  a323=(a621*a161);
  a539=(a539+a323);
  a322=(a322*a539);
  a539=(a621*a083);
  a323=sin(a109);
  a323=(a323*a401);
  a539=(a539*a323);
  a322=(a322-a539);
  a249=(a249+a322);
  a322=cos(a109);
  a539=(a317*a309);
  a323=(a257*a532);
  a539=(a539+a323);
  a322=(a322*a539);
  a539=(a257*a317);
  a323=sin(a109);
  a323=(a323*a401);
  a539=(a539*a323);
  a322=(a322-a539);
  a249=(a249+a322);
  a322=(a621*a317);
  a539=cos(a109);
  a539=(a539*a401);
  a322=(a322*a539);
  a539=sin(a109);
  a317=(a317*a523);
  a532=(a621*a532);
  a317=(a317+a532);
  a539=(a539*a317);
  a322=(a322+a539);
  a249=(a249-a322);
  a322=cos(a109);
  a414=(a347*a414);
  a539=(a105*a415);
  a414=(a414+a539);
  a322=(a322*a414);
  a105=(a105*a347);
  a414=sin(a109);
  a414=(a414*a401);
  a105=(a105*a414);
  a322=(a322-a105);
  a249=(a249+a322);
  a322=(a029*a347);
  a105=cos(a109);
  a105=(a105*a401);
  a322=(a322*a105);
  a105=sin(a109);
  a347=(a347*a403);
  a415=(a029*a415);
  a347=(a347+a415);
  a105=(a105*a347);
  a322=(a322+a105);
  a249=(a249-a322);
  a322=(a241*a527);
  a105=cos(a109);
  a105=(a105*a401);
  a322=(a322*a105);
  a105=sin(a109);
  a527=(a527*a506);
  a241=(a241*a397);
  a527=(a527+a241);
  a105=(a105*a527);
  a322=(a322+a105);
  a249=(a249-a322);
  a322=cos(a109);
  a105=(a537*a272);
  a527=(a255*a646);
  a105=(a105+a527);
  a322=(a322*a105);
  a105=(a255*a537);
  a527=sin(a109);
  a527=(a527*a401);
  a105=(a105*a527);
  a322=(a322-a105);
  a249=(a249+a322);
  a322=(a391*a537);
  a105=cos(a109);
  a105=(a105*a401);
  a322=(a322*a105);
  a105=sin(a109);
  a537=(a537*a637);
  a646=(a391*a646);
  a537=(a537+a646);
  a105=(a105*a537);
  a322=(a322+a105);
  a249=(a249+a322);
  a322=cos(a109);
  a617=(a561*a617);
  a105=(a399*a618);
  a617=(a617+a105);
  a322=(a322*a617);
  a399=(a399*a561);
  a617=sin(a109);
  a617=(a617*a401);
  a399=(a399*a617);
  a322=(a322-a399);
  a249=(a249-a322);
  a322=(a029*a561);
  a399=cos(a109);
  a399=(a399*a401);
  a322=(a322*a399);
  a399=sin(a109);
  a561=(a561*a403);
  a618=(a029*a618);
  a561=(a561+a618);
  a399=(a399*a561);
  a322=(a322+a399);
  a249=(a249-a322);
  a322=(a106*a641);
  a399=cos(a109);
  a399=(a399*a401);
  a322=(a322*a399);
  a399=sin(a109);
  a641=(a641*a412);
  a106=(a106*a610);
  a641=(a641+a106);
  a399=(a399*a641);
  a322=(a322+a399);
  a249=(a249-a322);
  a322=cos(a109);
  a403=(a410*a403);
  a616=(a029*a616);
  a403=(a403+a616);
  a322=(a322*a403);
  a029=(a029*a410);
  a109=sin(a109);
  a109=(a109*a401);
  a029=(a029*a109);
  a322=(a322-a029);
  a249=(a249+a322);
  if (res[2]!=0) res[2][2]=a249;
  a249=(a384*a523);
  a264=(a621*a264);
  a249=(a249-a264);
  a309=(a315*a309);
  a246=(a257*a246);
  a309=(a309+a246);
  a249=(a249+a309);
  a309=(a080*a249);
  a384=(a621*a384);
  a257=(a257*a315);
  a384=(a384+a257);
  a257=(a384*a160);
  a309=(a309+a257);
  a309=(a030*a309);
  a637=(a552*a637);
  a556=(a391*a556);
  a637=(a637-a556);
  a272=(a330*a272);
  a367=(a255*a367);
  a272=(a272+a367);
  a637=(a637-a272);
  a272=(a080*a637);
  a391=(a391*a552);
  a255=(a255*a330);
  a391=(a391-a255);
  a255=(a391*a160);
  a272=(a272+a255);
  a272=(a030*a272);
  a309=(a309-a272);
  a274=(a274*a411);
  a063=(a063*a509);
  a274=(a274+a063);
  a309=(a309+a274);
  if (res[2]!=0) res[2][3]=a309;
  a763=(a763*a409);
  a017=(a017*a538);
  a763=(a763+a017);
  if (res[2]!=0) res[2][4]=a763;
  a345=(a345+a559);
  a345=(a345+a678);
  a345=(a247*a345);
  a678=(2.*a512);
  a345=(a345*a678);
  a678=(2.*a248);
  a519=(a519+a517);
  a519=(a519+a756);
  a247=(a247*a519);
  a678=(a678*a247);
  a345=(a345+a678);
  a273=(2.*a273);
  a678=(a273*a398);
  a247=(2.*a512);
  a678=(a678*a247);
  a247=(2.*a248);
  a529=(2.*a529);
  a398=(a398*a529);
  a273=(a273*a343);
  a398=(a398+a273);
  a247=(a247*a398);
  a678=(a678+a247);
  a368=(2.*a368);
  a247=(a368*a611);
  a398=(2.*a512);
  a247=(a247*a398);
  a398=(2.*a248);
  a643=(2.*a643);
  a611=(a611*a643);
  a368=(a368*a557);
  a611=(a611+a368);
  a398=(a398*a611);
  a247=(a247+a398);
  a678=(a678+a247);
  a345=(a345-a678);
  a333=(2.*a333);
  a678=(a333*a730);
  a512=(2.*a512);
  a678=(a678*a512);
  a248=(2.*a248);
  a777=(2.*a777);
  a730=(a730*a777);
  a333=(a333*a676);
  a730=(a730+a333);
  a248=(a248*a730);
  a678=(a678+a248);
  a345=(a345-a678);
  if (res[2]!=0) res[2][5]=a345;
  a027=(a027/a026);
  a345=(a027*a113);
  a678=(a345*a130);
  a126=(a126/a026);
  a026=(a027/a026);
  a026=(a026*a129);
  a126=(a126-a026);
  a113=(a113*a126);
  a027=(a027*a132);
  a113=(a113+a027);
  a027=(a024*a113);
  a678=(a678+a027);
  a678=(-a678);
  if (res[2]!=0) res[2][6]=a678;
  a472=(a010*a472);
  a008=(a206*a008);
  a472=(a472+a008);
  a286=(a286*a472);
  a206=(a206*a010);
  a593=(a206*a593);
  a286=(a286+a593);
  a095=(a095*a032);
  a076=(a076*a081);
  a095=(a095+a076);
  a286=(a286-a095);
  a098=(a098*a474);
  a209=(a209*a631);
  a098=(a098+a209);
  a286=(a286+a098);
  a470=(a470*a449);
  a186=(a186*a454);
  a470=(a470+a186);
  a286=(a286+a470);
  a470=(a022*a345);
  a024=(2.*a024);
  a470=(a470/a024);
  a186=(2.*a131);
  a186=(a470*a186);
  a454=(2.*a023);
  a345=(a345*a128);
  a022=(a022*a113);
  a345=(a345+a022);
  a345=(a345/a024);
  a470=(a470/a024);
  a130=(2.*a130);
  a470=(a470*a130);
  a345=(a345-a470);
  a454=(a454*a345);
  a186=(a186+a454);
  a286=(a286-a186);
  if (res[2]!=0) res[2][7]=a286;
  a286=(a213*a144);
  a172=(a172*a441);
  a286=(a286+a172);
  a286=(-a286);
  if (res[2]!=0) res[2][8]=a286;
  if (res[2]!=0) res[2][9]=a441;
  a213=(a213*a444);
  a441=(a031*a441);
  a213=(a213+a441);
  if (res[2]!=0) res[2][10]=a213;
  a457=(a457*a445);
  a158=(a158*a232);
  a457=(a457+a158);
  if (res[2]!=0) res[2][11]=a457;
  a453=(a062*a453);
  a046=(a062*a046);
  a453=(a453+a046);
  a072=(a072/a173);
  a072=(a072*a229);
  a174=(a174/a071);
  a174=(a174*a442);
  a072=(a072-a174);
  a453=(a453+a072);
  if (res[2]!=0) res[2][12]=a453;
  a589=(a589*a440);
  a181=(a181*a016);
  a589=(a589+a181);
  if (res[2]!=0) res[2][13]=a589;
  a137=(a137*a452);
  a187=(a187*a283);
  a137=(a137+a187);
  if (res[2]!=0) res[2][14]=a137;
  a620=(a620*a704);
  a282=(a282*a603);
  a620=(a620+a282);
  a725=(a725*a620);
  a488=(a488*a476);
  a050=(a050*a718);
  a488=(a488+a050);
  a488=(a030*a488);
  a725=(a725+a488);
  if (res[2]!=0) res[2][15]=a725;
  if (res[2]!=0) res[2][16]=a495;
  a725=(a500*a144);
  a488=(a038*a495);
  a725=(a725+a488);
  if (res[2]!=0) res[2][17]=a725;
  a500=(a500*a444);
  a031=(a031*a495);
  a500=(a500+a031);
  if (res[2]!=0) res[2][18]=a500;
  a719=(a719*a477);
  a497=(a210*a497);
  a719=(a719+a497);
  if (res[2]!=0) res[2][19]=a719;
  if (res[2]!=0) res[2][20]=a498;
  a489=(a489*a144);
  a038=(a038*a498);
  a489=(a489+a038);
  if (res[2]!=0) res[2][21]=a489;
  a404=(a062*a404);
  a190=(a062*a190);
  a404=(a404+a190);
  a033=(a033/a193);
  a033=(a033*a115);
  a195=(a195/a192);
  a195=(a195*a461);
  a033=(a033-a195);
  a404=(a404+a033);
  if (res[2]!=0) res[2][22]=a404;
  a404=(-a779);
  if (res[2]!=0) res[2][23]=a404;
  a191=(a191*a666);
  a766=(a766*a779);
  a191=(a191+a766);
  a191=(-a191);
  if (res[2]!=0) res[2][24]=a191;
  a215=(a215*a288);
  a037=(a037*a483);
  a215=(a215-a037);
  if (res[2]!=0) res[2][25]=a215;
  a215=(a712*a164);
  a037=(a082*a765);
  a215=(a215+a037);
  if (res[2]!=0) res[2][26]=a215;
  a712=(a712*a434);
  a073=(a073*a765);
  a712=(a712+a073);
  a073=(a086-a094);
  a523=(a383*a523);
  a240=(a621*a240);
  a523=(a523+a240);
  a073=(a073+a523);
  a523=(a206*a023);
  a256=(a523*a256);
  a023=(a023*a472);
  a206=(a206*a131);
  a023=(a023+a206);
  a206=(a623*a023);
  a256=(a256+a206);
  a206=(a058*a477);
  a746=(a210*a746);
  a206=(a206+a746);
  a256=(a256+a206);
  a073=(a073+a256);
  a073=(a073-a515);
  a073=(a073-a259);
  a073=(a073-a714);
  a073=(a073/a082);
  a515=(a121-a604);
  a621=(a621*a383);
  a515=(a515+a621);
  a623=(a623*a523);
  a058=(a210*a058);
  a623=(a623+a058);
  a515=(a515+a623);
  a515=(a515-a321);
  a515=(a515-a341);
  a515=(a515-a141);
  a515=(a515/a082);
  a321=(a515/a082);
  a321=(a321*a164);
  a073=(a073-a321);
  a073=(a073/a082);
  a515=(a515/a082);
  a321=(a515/a082);
  a321=(a321*a164);
  a073=(a073-a321);
  a004=(a004*a073);
  a515=(a515*a011);
  a004=(a004+a515);
  a644=(a653*a644);
  a764=(a528*a764);
  a644=(a644+a764);
  a400=(a716*a400);
  a342=(a499*a342);
  a400=(a400-a342);
  a644=(a644-a400);
  a644=(a644+a125);
  a644=(a644-a637);
  a644=(a644-a249);
  a644=(a644-a586);
  a644=(a644/a082);
  a528=(a528*a653);
  a499=(a499*a716);
  a528=(a528-a499);
  a528=(a528+a021);
  a528=(a528-a391);
  a528=(a528-a384);
  a528=(a528-a727);
  a528=(a528/a082);
  a727=(a528/a082);
  a727=(a727*a164);
  a644=(a644-a727);
  a644=(a644/a082);
  a528=(a528/a082);
  a082=(a528/a082);
  a082=(a082*a164);
  a644=(a644-a082);
  a318=(a318*a644);
  a528=(a528*a533);
  a318=(a318+a528);
  a004=(a004+a318);
  a712=(a712-a004);
  if (res[2]!=0) res[2][27]=a712;
  a223=(a223*a701);
  a491=(a231*a491);
  a223=(a223-a491);
  if (res[2]!=0) res[2][28]=a223;
  a231=(a231*a494);
  a226=(a226*a701);
  a231=(a231+a226);
  if (res[2]!=0) res[2][29]=a231;
  a077=(a077*a486);
  a218=(a218*a138);
  a077=(a077+a218);
  if (res[2]!=0) res[2][30]=a077;
  a018=(a018*a125);
  a021=(a021*a235);
  a018=(a018+a021);
  if (res[2]!=0) res[2][31]=a018;
  a018=(a722+a379);
  if (res[2]!=0) res[2][32]=a018;
  a722=(a238*a722);
  a239=(a239*a433);
  a722=(a722-a239);
  a379=(a238*a379);
  a099=(a099*a433);
  a379=(a379-a099);
  a722=(a722+a379);
  if (res[2]!=0) res[2][33]=a722;
  a722=(a706+a376);
  if (res[2]!=0) res[2][34]=a722;
  a706=(a238*a706);
  a388=(a388*a433);
  a706=(a706-a388);
  a238=(a238*a376);
  a601=(a601*a433);
  a238=(a238-a601);
  a706=(a706+a238);
  if (res[2]!=0) res[2][35]=a706;
  a254=(a254*a633);
  a429=(a429*a325);
  a254=(a254+a429);
  if (res[2]!=0) res[2][36]=a254;
  a101=(a358*a101);
  a263=(a263*a271);
  a101=(a101+a263);
  a260=(a260/a066);
  a266=(a266/a066);
  a263=(a266/a066);
  a263=(a263*a420);
  a260=(a260-a263);
  a260=(a363*a260);
  a266=(a266*a361);
  a260=(a260+a266);
  a101=(a101-a260);
  a360=(a360*a422);
  a346=(a261*a346);
  a360=(a360+a346);
  a101=(a101+a360);
  a374=(a572*a374);
  a373=(a373*a418);
  a374=(a374+a373);
  a101=(a101+a374);
  a250=(a250/a066);
  a392=(a392/a066);
  a374=(a392/a066);
  a374=(a374*a420);
  a250=(a250-a374);
  a250=(a577*a250);
  a392=(a392*a575);
  a250=(a250+a392);
  a101=(a101-a250);
  a574=(a574*a622);
  a560=(a396*a560);
  a574=(a574+a560);
  a101=(a101+a574);
  a102=(a102/a067);
  a349=(a349/a350);
  a364=(a349*a364);
  a352=(a352/a353);
  a362=(a352*a362);
  a364=(a364-a362);
  a563=(a563/a564);
  a578=(a563*a578);
  a364=(a364+a578);
  a566=(a566/a567);
  a576=(a566*a576);
  a364=(a364-a576);
  a576=(a102*a364);
  a567=(a576*a425);
  a349=(a349*a351);
  a352=(a352*a069);
  a349=(a349-a352);
  a563=(a563*a565);
  a349=(a349+a563);
  a566=(a566*a530);
  a349=(a349-a566);
  a349=(a102*a349);
  a423=(a423/a067);
  a102=(a102/a067);
  a102=(a102*a424);
  a423=(a423+a102);
  a364=(a364*a423);
  a349=(a349-a364);
  a364=(a133*a349);
  a567=(a567+a364);
  a101=(a101-a567);
  if (res[2]!=0) res[2][37]=a101;
  a358=(a358*a428);
  a265=(a265*a271);
  a358=(a358+a265);
  a363=(a363*a422);
  a261=(a261*a361);
  a363=(a363+a261);
  a358=(a358-a363);
  a572=(a572*a624);
  a393=(a393*a418);
  a572=(a572+a393);
  a358=(a358+a572);
  a577=(a577*a622);
  a396=(a396*a575);
  a577=(a577+a396);
  a358=(a358-a577);
  a577=(a025<=a057);
  a057=(a057<=a025);
  a057=(a057+a577);
  a577=(a577/a057);
  a420=(a576*a420);
  a349=(a066*a349);
  a420=(a420+a349);
  a133=(2.*a133);
  a420=(a420/a133);
  a066=(a066*a576);
  a066=(a066/a133);
  a066=(a066/a133);
  a425=(2.*a425);
  a066=(a066*a425);
  a420=(a420-a066);
  a577=(a577*a420);
  a358=(a358-a577);
  if (res[2]!=0) res[2][38]=a358;
  a357=(a357*a504);
  a268=(a268*a354);
  a357=(a357+a268);
  a571=(a571*a627);
  a290=(a290*a568);
  a571=(a571+a290);
  a357=(a357+a571);
  if (res[2]!=0) res[2][39]=a357;
  a355=(a355*a417);
  a270=(a270*a344);
  a355=(a355+a270);
  a569=(a569*a619);
  a284=(a284*a558);
  a569=(a569+a284);
  a355=(a355+a569);
  if (res[2]!=0) res[2][40]=a355;
  a594=(a594-a639);
  if (res[2]!=0) res[2][41]=a594;
  a289=(a289*a516);
  a258=(a258*a320);
  a289=(a289+a258);
  if (res[2]!=0) res[2][42]=a289;
  a380=(a380-a525);
  if (res[2]!=0) res[2][43]=a380;
  a438=(a438*a127);
  a588=(a054*a588);
  a438=(a438+a588);
  if (res[2]!=0) res[2][44]=a438;
  a654=(a654*a650);
  a279=(a279*a276);
  a654=(a654+a279);
  a308=(a308*a733);
  a608=(a608*a607);
  a308=(a308+a608);
  a654=(a654+a308);
  a654=(-a654);
  if (res[2]!=0) res[2][45]=a654;
  if (res[2]!=0) res[2][46]=a776;
  a606=(a606*a762);
  a776=(a227*a776);
  a606=(a606+a776);
  if (res[2]!=0) res[2][47]=a606;
  if (res[2]!=0) res[2][48]=a705;
  a726=(a726*a762);
  a227=(a227*a705);
  a726=(a726+a227);
  if (res[2]!=0) res[2][49]=a726;
  a728=(a728*a770);
  a599=(a599*a656);
  a728=(a728+a599);
  if (res[2]!=0) res[2][50]=a728;
  a296=(a691*a296);
  a645=(a645*a745);
  a296=(a296+a645);
  a750=(a750/a625);
  a302=(a302/a625);
  a645=(a302/a625);
  a645=(a645*a747);
  a750=(a750-a645);
  a750=(a696*a750);
  a302=(a302*a694);
  a750=(a750+a302);
  a296=(a296-a750);
  a693=(a693*a752);
  a679=(a307*a679);
  a693=(a693+a679);
  a296=(a296+a693);
  a587=(a587/a638);
  a682=(a682/a683);
  a697=(a682*a697);
  a685=(a685/a686);
  a695=(a685*a695);
  a697=(a697-a695);
  a695=(a587*a697);
  a686=(a695*a755);
  a682=(a682*a684);
  a685=(a685*a629);
  a682=(a682-a685);
  a682=(a587*a682);
  a753=(a753/a638);
  a587=(a587/a638);
  a587=(a587*a754);
  a753=(a753+a587);
  a697=(a697*a753);
  a682=(a682-a697);
  a697=(a609*a682);
  a686=(a686+a697);
  a296=(a296-a686);
  if (res[2]!=0) res[2][51]=a296;
  a691=(a691*a531);
  a521=(a521*a745);
  a691=(a691+a521);
  a696=(a696*a752);
  a307=(a307*a694);
  a696=(a696+a307);
  a691=(a691-a696);
  a696=(a025<=a369);
  a369=(a369<=a025);
  a369=(a369+a696);
  a696=(a696/a369);
  a747=(a695*a747);
  a682=(a625*a682);
  a747=(a747+a682);
  a609=(2.*a609);
  a747=(a747/a609);
  a625=(a625*a695);
  a625=(a625/a609);
  a625=(a625/a609);
  a755=(2.*a755);
  a625=(a625*a755);
  a747=(a747-a625);
  a696=(a696*a747);
  a691=(a691-a696);
  if (res[2]!=0) res[2][52]=a691;
  a690=(a690*a068);
  a359=(a359*a687);
  a690=(a690+a359);
  if (res[2]!=0) res[2][53]=a690;
  a688=(a688*a744);
  a306=(a306*a677);
  a688=(a688+a306);
  if (res[2]!=0) res[2][54]=a688;
  a713=(a713/a597);
  a305=(a305/a597);
  a305=(a305/a597);
  a305=(a305*a769);
  a713=(a713-a305);
  if (res[2]!=0) res[2][55]=a713;
  a612=(a612*a127);
  a054=(a054*a635);
  a612=(a612+a054);
  a612=(-a612);
  if (res[2]!=0) res[2][56]=a612;
  a612=(a758*a208);
  a054=(a664*a584);
  a612=(a612+a054);
  if (res[2]!=0) res[2][57]=a612;
  a612=(a523*a083);
  a054=(a612*a615);
  a083=(a083*a023);
  a161=(a523*a161);
  a083=(a083+a161);
  a161=(a700*a083);
  a054=(a054+a161);
  if (res[2]!=0) res[2][58]=a054;
  a758=(a758*a139);
  a584=(a053*a584);
  a758=(a758+a584);
  if (res[2]!=0) res[2][59]=a758;
  a243=(a243*a477);
  a210=(a210*a613);
  a243=(a243+a210);
  a210=(a523*a080);
  a613=(a724*a210);
  a615=(2.*a615);
  a613=(a613*a615);
  a700=(2.*a700);
  a212=(a210*a212);
  a080=(a080*a023);
  a160=(a523*a160);
  a080=(a080+a160);
  a724=(a724*a080);
  a212=(a212+a724);
  a700=(a700*a212);
  a613=(a613+a700);
  a243=(a243+a613);
  a612=(a612*a518);
  a573=(a573*a083);
  a612=(a612+a573);
  a243=(a243+a612);
  if (res[2]!=0) res[2][60]=a243;
  if (res[2]!=0) res[2][61]=a061;
  if (res[2]!=0) res[2][62]=a061;
  if (res[2]!=0) res[2][63]=a061;
  a598=(a511*a598);
  a671=(a671*a419);
  a598=(a598+a671);
  if (res[2]!=0) res[2][64]=a598;
  a208=(a511*a208);
  a664=(a664*a419);
  a208=(a208+a664);
  if (res[2]!=0) res[2][65]=a208;
  a210=(a210*a220);
  a723=(a723*a080);
  a210=(a210+a723);
  if (res[2]!=0) res[2][66]=a210;
  a511=(a511*a139);
  a419=(a053*a419);
  a511=(a511+a419);
  if (res[2]!=0) res[2][67]=a511;
  a042=(a042*a657);
  a406=(a406*a147);
  a042=(a042-a406);
  a042=(-a042);
  if (res[2]!=0) res[2][68]=a042;
  a720=(a720*a143);
  a039=(a039*a051);
  a720=(a720+a039);
  if (res[2]!=0) res[2][69]=a720;
  a093=(a062*a093);
  a062=(a062*a103);
  a093=(a093+a062);
  a088=(a088/a089);
  a088=(a088*a090);
  a091=(a091/a092);
  a091=(a091*a135);
  a088=(a088-a091);
  a093=(a093+a088);
  if (res[2]!=0) res[2][70]=a093;
  a100=(a100*a020);
  a052=(a052*a087);
  a100=(a100+a052);
  if (res[2]!=0) res[2][71]=a100;
  a104=(a104*a139);
  a053=(a053*a034);
  a104=(a104+a053);
  a104=(-a104);
  if (res[2]!=0) res[2][72]=a104;
  a097=(a097*a136);
  a070=(a070*a155);
  a097=(a097+a070);
  a030=(a030*a097);
  a030=(-a030);
  if (res[2]!=0) res[2][73]=a030;
  a096=(a096*a134);
  a074=(a074*a165);
  a096=(a096+a074);
  a096=(-a096);
  if (res[2]!=0) res[2][74]=a096;
  if (res[2]!=0) res[2][75]=a061;
  if (res[2]!=0) res[2][76]=a061;
  if (res[2]!=0) res[2][77]=a061;
  a487=(a523*a487);
  a023=(a035*a023);
  a487=(a487+a023);
  a689=(a548*a689);
  a338=(a583*a338);
  a689=(a689+a338);
  a487=(a487+a689);
  a094=(a040*a094);
  a142=(a604*a142);
  a094=(a094+a142);
  a086=(a043*a086);
  a146=(a121*a146);
  a086=(a086+a146);
  a094=(a094+a086);
  a487=(a487-a094);
  a291=(a391*a291);
  a637=(a329*a637);
  a291=(a291+a637);
  a487=(a487-a291);
  a275=(a384*a275);
  a249=(a316*a249);
  a275=(a275+a249);
  a487=(a487+a275);
  a259=(a111*a259);
  a275=(a341*a405);
  a259=(a259+a275);
  a487=(a487-a259);
  a714=(a216*a714);
  a482=(a141*a482);
  a714=(a714+a482);
  a487=(a487-a714);
  a405=(a381*a405);
  a408=(a111*a408);
  a405=(a405+a408);
  a487=(a487+a405);
  a487=(a487/a079);
  a035=(a035*a523);
  a583=(a583*a548);
  a035=(a035+a583);
  a604=(a604*a040);
  a121=(a121*a043);
  a604=(a604+a121);
  a035=(a035-a604);
  a329=(a329*a391);
  a035=(a035-a329);
  a316=(a316*a384);
  a035=(a035+a316);
  a341=(a341*a111);
  a035=(a035-a341);
  a141=(a141*a216);
  a035=(a035-a141);
  a111=(a111*a381);
  a035=(a035+a111);
  a035=(a035/a079);
  a111=(a035/a079);
  a111=(a111*a162);
  a487=(a487-a111);
  a487=(a487/a079);
  a035=(a035/a079);
  a079=(a035/a079);
  a079=(a079*a162);
  a487=(a487-a079);
  a078=(a078*a487);
  a035=(a035*a159);
  a078=(a078+a035);
  a078=(-a078);
  if (res[2]!=0) res[2][78]=a078;
  return 0;
}

CASADI_SYMBOL_EXPORT int fwd1_adj1_rollout_rhs(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f3(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int fwd1_adj1_rollout_rhs_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void fwd1_adj1_rollout_rhs_release(int mem) {
}

CASADI_SYMBOL_EXPORT void fwd1_adj1_rollout_rhs_incref(void) {
}

CASADI_SYMBOL_EXPORT void fwd1_adj1_rollout_rhs_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_rollout_rhs_n_in(void) { return 13;}

CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_rollout_rhs_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_rollout_rhs_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* fwd1_adj1_rollout_rhs_name_in(casadi_int i) {
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

CASADI_SYMBOL_EXPORT const char* fwd1_adj1_rollout_rhs_name_out(casadi_int i) {
  switch (i) {
    case 0: return "fwd_adj_x";
    case 1: return "fwd_adj_u";
    case 2: return "fwd_adj_p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_rollout_rhs_sparsity_in(casadi_int i) {
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

CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_rollout_rhs_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int fwd1_adj1_rollout_rhs_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 13;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int fwd1_adj1_rollout_rhs_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 13*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* rollout_outputs:(x[6],u[11],p[79])->(y[39]) */
static int casadi_f4(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72, a73, a74, a75, a76, a77, a78;
  a00=0.;
  a01=5.0000000000000000e-01;
  a02=arg[2]? arg[2][26] : 0;
  a03=arg[2]? arg[2][27] : 0;
  a02=(a02*a03);
  a04=arg[2]? arg[2][12] : 0;
  a05=1.0000000000000001e-01;
  a06=(a04+a05);
  a07=(-a06);
  a08=arg[2]? arg[2][11] : 0;
  a09=arg[1]? arg[1][3] : 0;
  a10=arg[2]? arg[2][10] : 0;
  a10=(a09*a10);
  a11=arg[2]? arg[2][9] : 0;
  a10=(a10+a11);
  a11=1.;
  a12=arg[2]? arg[2][8] : 0;
  a12=(a11-a12);
  a13=arg[2]? arg[2][1] : 0;
  a14=arg[0]? arg[0][0] : 0;
  a15=arg[1]? arg[1][0] : 0;
  a16=arg[0]? arg[0][5] : 0;
  a17=cos(a16);
  a17=(a15*a17);
  a18=arg[1]? arg[1][1] : 0;
  a19=sin(a16);
  a19=(a18*a19);
  a17=(a17+a19);
  a19=(a14-a17);
  a20=casadi_sq(a19);
  a21=1.0000000000000000e-04;
  a20=(a20+a21);
  a20=sqrt(a20);
  a19=(a19*a20);
  a20=(a01*a19);
  a22=arg[1]? arg[1][2] : 0;
  a23=arg[2]? arg[2][6] : 0;
  a24=arg[2]? arg[2][7] : 0;
  a25=casadi_sq(a24);
  a26=9.9999999999999998e-13;
  a25=(a25+a26);
  a25=sqrt(a25);
  a23=(a23*a25);
  a23=(a22/a23);
  a20=(a20+a23);
  a25=(2.*a23);
  a19=(a19+a25);
  a19=casadi_sq(a19);
  a25=1.0000000000000000e-08;
  a19=(a19+a25);
  a19=sqrt(a19);
  a19=(a01*a19);
  a20=(a20+a19);
  a19=sqrt(a20);
  a19=atan2(a00,a19);
  a19=(a13+a19);
  a12=(a12*a19);
  a10=(a10+a12);
  a08=(a08*a10);
  a06=casadi_fmin(a06,a08);
  a07=casadi_fmax(a07,a06);
  a06=2.0000000000000001e-01;
  a08=-5.;
  a12=(a08*a04);
  a19=5.;
  a27=(a19*a07);
  a12=(a12-a27);
  a12=(a12+a01);
  a12=casadi_fmax(a00,a12);
  a27=casadi_sq(a12);
  a27=(a12*a27);
  a27=(a06*a27);
  a12=(a01*a12);
  a12=(a11-a12);
  a27=(a27*a12);
  a27=(a07+a27);
  a04=(a08*a04);
  a07=(a19*a07);
  a04=(a04+a07);
  a04=(a04+a01);
  a04=casadi_fmax(a00,a04);
  a07=casadi_sq(a04);
  a07=(a04*a07);
  a07=(a06*a07);
  a04=(a01*a04);
  a04=(a11-a04);
  a07=(a07*a04);
  a27=(a27-a07);
  a07=(a01*a27);
  a04=arg[2]? arg[2][13] : 0;
  a07=(a07*a04);
  a07=(a07*a24);
  a04=arg[2]? arg[2][14] : 0;
  a07=(a07*a04);
  a07=(a07*a20);
  a02=(a02-a07);
  a20=arg[2]? arg[2][22] : 0;
  a04=(a20+a05);
  a12=(-a04);
  a28=arg[2]? arg[2][20] : 0;
  a29=arg[2]? arg[2][21] : 0;
  a29=(a29*a13);
  a28=(a28+a29);
  a04=casadi_fmin(a04,a28);
  a12=casadi_fmax(a12,a04);
  a04=(a08*a20);
  a28=(a19*a12);
  a04=(a04-a28);
  a04=(a04+a01);
  a04=casadi_fmax(a00,a04);
  a28=casadi_sq(a04);
  a28=(a04*a28);
  a28=(a06*a28);
  a04=(a01*a04);
  a04=(a11-a04);
  a28=(a28*a04);
  a28=(a12+a28);
  a20=(a08*a20);
  a12=(a19*a12);
  a20=(a20+a12);
  a20=(a20+a01);
  a20=casadi_fmax(a00,a20);
  a12=casadi_sq(a20);
  a12=(a20*a12);
  a12=(a06*a12);
  a20=(a01*a20);
  a20=(a11-a20);
  a12=(a12*a20);
  a28=(a28-a12);
  a12=arg[2]? arg[2][15] : 0;
  a20=(a01*a12);
  a04=(a14-a17);
  a29=casadi_sq(a04);
  a29=(a29+a25);
  a30=arg[0]? arg[0][1] : 0;
  a31=cos(a16);
  a18=(a18*a31);
  a31=sin(a16);
  a15=(a15*a31);
  a18=(a18-a15);
  a15=(a30-a18);
  a31=casadi_sq(a15);
  a31=(a29+a31);
  a20=(a20*a31);
  a20=(a20*a24);
  a32=(a28*a20);
  a33=(a32*a04);
  a29=sqrt(a29);
  a33=(a33/a29);
  a02=(a02-a33);
  a33=arg[2]? arg[2][25] : 0;
  a34=cos(a13);
  a34=(a33*a34);
  a35=arg[2]? arg[2][30] : 0;
  a36=sin(a13);
  a36=(a35*a36);
  a37=(a34+a36);
  a37=(a02*a37);
  a38=arg[2]? arg[2][28] : 0;
  a39=cos(a13);
  a38=(a38*a39);
  a39=arg[2]? arg[2][29] : 0;
  a40=sin(a13);
  a39=(a39*a40);
  a40=(a38+a39);
  a40=(a07*a40);
  a41=arg[2]? arg[2][19] : 0;
  a41=(a41*a20);
  a42=arg[2]? arg[2][16] : 0;
  a43=arg[2]? arg[2][17] : 0;
  a43=(a43*a13);
  a42=(a42+a43);
  a43=arg[2]? arg[2][18] : 0;
  a43=(a43*a09);
  a42=(a42+a43);
  a41=(a41*a42);
  a42=arg[2]? arg[2][31] : 0;
  a42=(a22*a42);
  a43=cos(a13);
  a42=(a42*a43);
  a42=(a41+a42);
  a40=(a40+a42);
  a37=(a37+a40);
  a37=(a01*a37);
  a43=arg[2]? arg[2][0] : 0;
  a09=cos(a13);
  a09=(a43*a09);
  a44=arg[2]? arg[2][4] : 0;
  a45=sin(a13);
  a45=(a44*a45);
  a09=(a09+a45);
  a45=(a34+a36);
  a45=(a09-a45);
  a37=(a37/a45);
  a37=(-a37);
  a37=casadi_fmax(a00,a37);
  if (res[0]!=0) res[0][0]=a37;
  a46=arg[0]? arg[0][2] : 0;
  a47=(a46*a09);
  a47=(a47+a30);
  a48=arg[2]? arg[2][2] : 0;
  a49=cos(a48);
  a49=(a47*a49);
  a50=(a01*a46);
  a51=arg[2]? arg[2][3] : 0;
  a50=(a50*a51);
  a52=(a14+a50);
  a53=sin(a48);
  a52=(a52*a53);
  a49=(a49-a52);
  a52=sin(a48);
  a52=(a47*a52);
  a53=(a14+a50);
  a54=cos(a48);
  a53=(a53*a54);
  a53=(a52+a53);
  a54=casadi_sq(a53);
  a55=9.9999999999999995e-07;
  a56=arg[2]? arg[2][5] : 0;
  a57=casadi_sq(a56);
  a55=(a55*a57);
  a54=(a54+a55);
  a57=sqrt(a54);
  a57=(a49/a57);
  a58=atan(a57);
  if (res[0]!=0) res[0][1]=a58;
  a58=arg[1]? arg[1][4] : 0;
  a59=arg[2]? arg[2][36] : 0;
  a60=1.0000000000000000e-03;
  a61=arg[2]? arg[2][34] : 0;
  a62=arg[2]? arg[2][35] : 0;
  a63=(a62*a37);
  a63=(a61+a63);
  a63=casadi_fmax(a60,a63);
  a59=(a59*a63);
  a63=arg[2]? arg[2][41] : 0;
  a64=(a59-a63);
  a58=(a58*a64);
  a58=(a58+a63);
  a58=(a58/a59);
  a63=5.0000000000000004e-06;
  a64=(a58+a63);
  a65=(-a64);
  a66=casadi_sq(a56);
  a66=casadi_sq(a66);
  a67=casadi_sq(a53);
  a68=casadi_sq(a49);
  a67=(a67+a68);
  a67=casadi_sq(a67);
  a66=(a66+a67);
  a66=sqrt(a66);
  a66=sqrt(a66);
  a53=(a53/a66);
  a64=casadi_fmin(a64,a53);
  a65=casadi_fmax(a65,a64);
  a64=1.0000000000000001e-05;
  a53=-100000.;
  a67=(a53*a58);
  a68=100000.;
  a69=(a68*a65);
  a67=(a67-a69);
  a67=(a67+a01);
  a67=casadi_fmax(a00,a67);
  a69=casadi_sq(a67);
  a69=(a67*a69);
  a69=(a64*a69);
  a67=(a01*a67);
  a67=(a11-a67);
  a69=(a69*a67);
  a69=(a65+a69);
  a58=(a53*a58);
  a65=(a68*a65);
  a58=(a58+a65);
  a58=(a58+a01);
  a58=casadi_fmax(a00,a58);
  a65=casadi_sq(a58);
  a65=(a58*a65);
  a65=(a64*a65);
  a58=(a01*a58);
  a58=(a11-a58);
  a65=(a65*a58);
  a69=(a69-a65);
  a65=(a37*a69);
  a65=(a65*a59);
  if (res[0]!=0) res[0][2]=a65;
  a69=casadi_sq(a69);
  a69=(a11-a69);
  a69=sqrt(a69);
  a58=(a69+a63);
  a67=(-a58);
  a70=arg[2]? arg[2][40] : 0;
  a71=arg[2]? arg[2][39] : 0;
  a72=arg[2]? arg[2][37] : 0;
  a73=arg[2]? arg[2][38] : 0;
  a74=(a73-a11);
  a74=casadi_fmax(a26,a74);
  a74=sqrt(a74);
  a74=(a72*a74);
  a74=(1./a74);
  a75=(-a74);
  a76=arg[2]? arg[2][32] : 0;
  a77=arg[2]? arg[2][33] : 0;
  a78=(a77*a37);
  a78=(a76+a78);
  a78=casadi_fmax(a00,a78);
  a78=(a78*a57);
  a78=(a78/a59);
  a78=casadi_fmin(a78,a74);
  a75=casadi_fmax(a75,a78);
  a78=(a11-a73);
  a78=(a75*a78);
  a75=(a72*a75);
  a75=atan(a75);
  a75=(a73*a75);
  a75=(a75/a72);
  a78=(a78+a75);
  a78=(a72*a78);
  a78=atan(a78);
  a78=(a71*a78);
  a78=sin(a78);
  a78=(a70*a78);
  a49=casadi_sq(a49);
  a49=(a49+a54);
  a49=sqrt(a49);
  a78=(a78*a49);
  a78=(a78/a66);
  a58=casadi_fmin(a58,a78);
  a67=casadi_fmax(a67,a58);
  a58=(a53*a69);
  a78=(a68*a67);
  a58=(a58-a78);
  a58=(a58+a01);
  a58=casadi_fmax(a00,a58);
  a78=casadi_sq(a58);
  a78=(a58*a78);
  a78=(a64*a78);
  a58=(a01*a58);
  a58=(a11-a58);
  a78=(a78*a58);
  a78=(a67+a78);
  a69=(a53*a69);
  a67=(a68*a67);
  a69=(a69+a67);
  a69=(a69+a01);
  a69=casadi_fmax(a00,a69);
  a67=casadi_sq(a69);
  a67=(a69*a67);
  a67=(a64*a67);
  a69=(a01*a69);
  a69=(a11-a69);
  a67=(a67*a69);
  a78=(a78-a67);
  a78=(a37*a78);
  a78=(a78*a59);
  if (res[0]!=0) res[0][3]=a78;
  if (res[0]!=0) res[0][4]=a37;
  a59=cos(a48);
  a47=(a47*a59);
  a59=(a14-a50);
  a67=sin(a48);
  a59=(a59*a67);
  a47=(a47+a59);
  a50=(a14-a50);
  a59=cos(a48);
  a50=(a50*a59);
  a50=(a50-a52);
  a52=casadi_sq(a50);
  a52=(a52+a55);
  a59=sqrt(a52);
  a59=(a47/a59);
  a67=atan(a59);
  if (res[0]!=0) res[0][5]=a67;
  a67=arg[1]? arg[1][5] : 0;
  a69=arg[2]? arg[2][42] : 0;
  a62=(a62*a37);
  a61=(a61+a62);
  a61=casadi_fmax(a60,a61);
  a69=(a69*a61);
  a61=arg[2]? arg[2][43] : 0;
  a62=(a69-a61);
  a67=(a67*a62);
  a67=(a67+a61);
  a67=(a67/a69);
  a61=(a67+a63);
  a62=(-a61);
  a58=casadi_sq(a56);
  a58=casadi_sq(a58);
  a66=casadi_sq(a50);
  a49=casadi_sq(a47);
  a66=(a66+a49);
  a66=casadi_sq(a66);
  a58=(a58+a66);
  a58=sqrt(a58);
  a58=sqrt(a58);
  a50=(a50/a58);
  a61=casadi_fmin(a61,a50);
  a62=casadi_fmax(a62,a61);
  a61=(a53*a67);
  a50=(a68*a62);
  a61=(a61-a50);
  a61=(a61+a01);
  a61=casadi_fmax(a00,a61);
  a50=casadi_sq(a61);
  a50=(a61*a50);
  a50=(a64*a50);
  a61=(a01*a61);
  a61=(a11-a61);
  a50=(a50*a61);
  a50=(a62+a50);
  a67=(a53*a67);
  a62=(a68*a62);
  a67=(a67+a62);
  a67=(a67+a01);
  a67=casadi_fmax(a00,a67);
  a62=casadi_sq(a67);
  a62=(a67*a62);
  a62=(a64*a62);
  a67=(a01*a67);
  a67=(a11-a67);
  a62=(a62*a67);
  a50=(a50-a62);
  a62=(a37*a50);
  a62=(a62*a69);
  if (res[0]!=0) res[0][6]=a62;
  a50=casadi_sq(a50);
  a50=(a11-a50);
  a50=sqrt(a50);
  a67=(a50+a63);
  a61=(-a67);
  a66=(-a74);
  a77=(a77*a37);
  a76=(a76+a77);
  a76=casadi_fmax(a00,a76);
  a76=(a76*a59);
  a76=(a76/a69);
  a76=casadi_fmin(a76,a74);
  a66=casadi_fmax(a66,a76);
  a76=(a11-a73);
  a76=(a66*a76);
  a66=(a72*a66);
  a66=atan(a66);
  a73=(a73*a66);
  a73=(a73/a72);
  a76=(a76+a73);
  a72=(a72*a76);
  a72=atan(a72);
  a71=(a71*a72);
  a71=sin(a71);
  a70=(a70*a71);
  a47=casadi_sq(a47);
  a47=(a47+a52);
  a47=sqrt(a47);
  a70=(a70*a47);
  a70=(a70/a58);
  a67=casadi_fmin(a67,a70);
  a61=casadi_fmax(a61,a67);
  a67=(a53*a50);
  a70=(a68*a61);
  a67=(a67-a70);
  a67=(a67+a01);
  a67=casadi_fmax(a00,a67);
  a70=casadi_sq(a67);
  a70=(a67*a70);
  a70=(a64*a70);
  a67=(a01*a67);
  a67=(a11-a67);
  a70=(a70*a67);
  a70=(a61+a70);
  a50=(a53*a50);
  a61=(a68*a61);
  a50=(a50+a61);
  a50=(a50+a01);
  a50=casadi_fmax(a00,a50);
  a61=casadi_sq(a50);
  a61=(a50*a61);
  a61=(a64*a61);
  a50=(a01*a50);
  a50=(a11-a50);
  a61=(a61*a50);
  a70=(a70-a61);
  a37=(a37*a70);
  a37=(a37*a69);
  if (res[0]!=0) res[0][7]=a37;
  a69=(a02*a09);
  a69=(a69+a40);
  a69=(a69/a45);
  a69=casadi_fmax(a00,a69);
  if (res[0]!=0) res[0][8]=a69;
  a45=(a34+a36);
  a45=(a46*a45);
  a45=(a45+a30);
  a40=arg[1]? arg[1][6] : 0;
  a70=arg[2]? arg[2][44] : 0;
  a70=(a40*a70);
  a61=arg[1]? arg[1][7] : 0;
  a70=(a70+a61);
  a61=arg[2]? arg[2][45] : 0;
  a50=(a11-a61);
  a70=(a70*a50);
  a50=cos(a70);
  a50=(a45*a50);
  a67=sin(a70);
  a67=(a14*a67);
  a50=(a50-a67);
  a67=cos(a70);
  a67=(a14*a67);
  a58=sin(a70);
  a45=(a45*a58);
  a67=(a67+a45);
  a45=casadi_sq(a67);
  a45=(a45+a55);
  a55=sqrt(a45);
  a55=(a50/a55);
  a58=atan(a55);
  if (res[0]!=0) res[0][9]=a58;
  a58=arg[2]? arg[2][55] : 0;
  a47=arg[2]? arg[2][50] : 0;
  a52=arg[2]? arg[2][48] : 0;
  a71=arg[2]? arg[2][49] : 0;
  a71=(a71*a69);
  a52=(a52+a71);
  a60=casadi_fmax(a60,a52);
  a47=(a47*a60);
  a58=(a58/a47);
  a60=(a58+a63);
  a52=(-a60);
  a56=casadi_sq(a56);
  a56=casadi_sq(a56);
  a71=casadi_sq(a67);
  a72=casadi_sq(a50);
  a71=(a71+a72);
  a71=casadi_sq(a71);
  a56=(a56+a71);
  a56=sqrt(a56);
  a56=sqrt(a56);
  a67=(a67/a56);
  a60=casadi_fmin(a60,a67);
  a52=casadi_fmax(a52,a60);
  a60=(a53*a58);
  a67=(a68*a52);
  a60=(a60-a67);
  a60=(a60+a01);
  a60=casadi_fmax(a00,a60);
  a67=casadi_sq(a60);
  a67=(a60*a67);
  a67=(a64*a67);
  a60=(a01*a60);
  a60=(a11-a60);
  a67=(a67*a60);
  a67=(a52+a67);
  a58=(a53*a58);
  a52=(a68*a52);
  a58=(a58+a52);
  a58=(a58+a01);
  a58=casadi_fmax(a00,a58);
  a52=casadi_sq(a58);
  a52=(a58*a52);
  a52=(a64*a52);
  a58=(a01*a58);
  a58=(a11-a58);
  a52=(a52*a58);
  a67=(a67-a52);
  a52=(a69*a67);
  a52=(a52*a47);
  if (res[0]!=0) res[0][10]=a52;
  a67=casadi_sq(a67);
  a67=(a11-a67);
  a67=sqrt(a67);
  a63=(a67+a63);
  a58=(-a63);
  a60=arg[2]? arg[2][54] : 0;
  a71=arg[2]? arg[2][53] : 0;
  a72=arg[2]? arg[2][51] : 0;
  a76=arg[2]? arg[2][52] : 0;
  a73=(a76-a11);
  a73=casadi_fmax(a26,a73);
  a73=sqrt(a73);
  a73=(a72*a73);
  a73=(1./a73);
  a66=(-a73);
  a74=arg[2]? arg[2][46] : 0;
  a59=arg[2]? arg[2][47] : 0;
  a59=(a59*a69);
  a74=(a74+a59);
  a74=casadi_fmax(a00,a74);
  a74=(a74*a55);
  a74=(a74/a47);
  a74=casadi_fmin(a74,a73);
  a66=casadi_fmax(a66,a74);
  a74=(a72*a66);
  a74=atan(a74);
  a74=(a76*a74);
  a74=(a74/a72);
  a76=(a76-a11);
  a66=(a66*a76);
  a74=(a74-a66);
  a72=(a72*a74);
  a72=atan(a72);
  a71=(a71*a72);
  a71=sin(a71);
  a60=(a60*a71);
  a50=casadi_sq(a50);
  a50=(a50+a45);
  a50=sqrt(a50);
  a60=(a60*a50);
  a60=(a60/a56);
  a63=casadi_fmin(a63,a60);
  a58=casadi_fmax(a58,a63);
  a63=(a53*a67);
  a60=(a68*a58);
  a63=(a63-a60);
  a63=(a63+a01);
  a63=casadi_fmax(a00,a63);
  a60=casadi_sq(a63);
  a60=(a63*a60);
  a60=(a64*a60);
  a63=(a01*a63);
  a63=(a11-a63);
  a60=(a60*a63);
  a60=(a58+a60);
  a53=(a53*a67);
  a68=(a68*a58);
  a53=(a53+a68);
  a53=(a53+a01);
  a53=casadi_fmax(a00,a53);
  a68=casadi_sq(a53);
  a68=(a53*a68);
  a64=(a64*a68);
  a53=(a01*a53);
  a53=(a11-a53);
  a64=(a64*a53);
  a60=(a60-a64);
  a69=(a69*a60);
  a69=(a69*a47);
  a61=(a11-a61);
  a69=(a69*a61);
  if (res[0]!=0) res[0][11]=a69;
  if (res[0]!=0) res[0][12]=a13;
  a15=atan2(a15,a29);
  if (res[0]!=0) res[0][13]=a15;
  if (res[0]!=0) res[0][14]=a28;
  if (res[0]!=0) res[0][15]=a32;
  a32=arg[2]? arg[2][23] : 0;
  a28=casadi_sq(a28);
  a61=arg[2]? arg[2][24] : 0;
  a28=(a28*a61);
  a32=(a32+a28);
  a32=(a32*a20);
  if (res[0]!=0) res[0][16]=a32;
  a28=arg[2]? arg[2][58] : 0;
  a61=arg[2]? arg[2][60] : 0;
  a28=(a28*a61);
  a47=2.5000000000000000e-01;
  a47=(a47*a12);
  a31=sqrt(a31);
  a47=(a47*a31);
  a47=(a47*a46);
  a47=(a47*a24);
  a28=(a28*a47);
  a31=arg[2]? arg[2][57] : 0;
  a31=(a31*a15);
  a12=arg[2]? arg[2][59] : 0;
  a60=arg[1]? arg[1][8] : 0;
  a64=arg[2]? arg[2][56] : 0;
  a40=(a40*a64);
  a60=(a60-a40);
  a12=(a12*a60);
  a31=(a31+a12);
  a31=(a20*a31);
  a28=(a28+a31);
  if (res[0]!=0) res[0][17]=a28;
  a31=arg[2]? arg[2][63] : 0;
  a12=casadi_sq(a61);
  a12=(a12*a47);
  a31=(a31*a12);
  a47=(a61*a20);
  a40=arg[2]? arg[2][61] : 0;
  a64=arg[1]? arg[1][9] : 0;
  a40=(a40*a64);
  a53=arg[2]? arg[2][62] : 0;
  a53=(a53*a15);
  a40=(a40+a53);
  a47=(a47*a40);
  a31=(a31+a47);
  if (res[0]!=0) res[0][18]=a31;
  if (res[0]!=0) res[0][19]=a41;
  a41=arg[2]? arg[2][66] : 0;
  a41=(a41*a12);
  a61=(a61*a20);
  a20=arg[2]? arg[2][64] : 0;
  a20=(a20*a64);
  a64=arg[2]? arg[2][65] : 0;
  a64=(a64*a15);
  a20=(a20+a64);
  a64=arg[2]? arg[2][67] : 0;
  a64=(a64*a60);
  a20=(a20+a64);
  a61=(a61*a20);
  a41=(a41+a61);
  if (res[0]!=0) res[0][20]=a41;
  a61=arg[2]? arg[2][69] : 0;
  a20=sin(a13);
  a20=(a61*a20);
  a64=arg[2]? arg[2][68] : 0;
  a15=cos(a13);
  a15=(a64*a15);
  a20=(a20-a15);
  a46=(a46*a20);
  a46=(a46+a30);
  a46=(a46-a18);
  a17=(a14-a17);
  a18=casadi_sq(a17);
  a18=(a18+a21);
  a18=sqrt(a18);
  a17=(a17*a18);
  a18=(a01*a17);
  a18=(a18+a23);
  a23=(2.*a23);
  a17=(a17+a23);
  a17=casadi_sq(a17);
  a17=(a17+a25);
  a17=sqrt(a17);
  a17=(a01*a17);
  a18=(a18+a17);
  a17=sqrt(a18);
  a17=atan2(a46,a17);
  if (res[0]!=0) res[0][21]=a17;
  a25=arg[2]? arg[2][70] : 0;
  a05=(a25+a05);
  a23=(-a05);
  a21=arg[2]? arg[2][71] : 0;
  a12=arg[2]? arg[2][72] : 0;
  a60=(a60*a12);
  a17=(a17-a60);
  a21=(a21*a17);
  a05=casadi_fmin(a05,a21);
  a23=casadi_fmax(a23,a05);
  a05=(a08*a25);
  a21=(a19*a23);
  a05=(a05-a21);
  a05=(a05+a01);
  a05=casadi_fmax(a00,a05);
  a21=casadi_sq(a05);
  a21=(a05*a21);
  a21=(a06*a21);
  a05=(a01*a05);
  a05=(a11-a05);
  a21=(a21*a05);
  a21=(a23+a21);
  a08=(a08*a25);
  a19=(a19*a23);
  a08=(a08+a19);
  a08=(a08+a01);
  a00=casadi_fmax(a00,a08);
  a08=casadi_sq(a00);
  a08=(a00*a08);
  a06=(a06*a08);
  a00=(a01*a00);
  a11=(a11-a00);
  a06=(a06*a11);
  a21=(a21-a06);
  if (res[0]!=0) res[0][22]=a21;
  a06=arg[2]? arg[2][73] : 0;
  a06=(a01*a06);
  a06=(a06*a21);
  a21=arg[2]? arg[2][74] : 0;
  a06=(a06*a21);
  a06=(a06*a24);
  a46=casadi_sq(a46);
  a18=(a18+a46);
  a06=(a06*a18);
  if (res[0]!=0) res[0][23]=a06;
  if (res[0]!=0) res[0][24]=a10;
  if (res[0]!=0) res[0][25]=a27;
  if (res[0]!=0) res[0][26]=a07;
  a27=sin(a16);
  a27=(a14*a27);
  a10=cos(a16);
  a10=(a30*a10);
  a27=(a27+a10);
  a27=casadi_sq(a27);
  a10=cos(a16);
  a14=(a14*a10);
  a10=sin(a16);
  a30=(a30*a10);
  a14=(a14-a30);
  a14=casadi_sq(a14);
  a27=(a27+a14);
  a27=(a27+a26);
  a27=sqrt(a27);
  if (res[0]!=0) res[0][27]=a27;
  a26=sin(a70);
  a26=(a69*a26);
  a26=(a26+a22);
  a22=cos(a70);
  a22=(a52*a22);
  a26=(a26-a22);
  a14=cos(a48);
  a14=(a65*a14);
  a30=sin(a48);
  a30=(a78*a30);
  a30=(a14-a30);
  a26=(a26-a30);
  a10=cos(a48);
  a10=(a62*a10);
  a26=(a26-a10);
  a18=sin(a48);
  a18=(a37*a18);
  a26=(a26-a18);
  a32=(a32*a04);
  a32=(a32/a29);
  a26=(a26-a32);
  if (res[0]!=0) res[0][28]=a26;
  a32=arg[1]? arg[1][10] : 0;
  a29=(a32-a06);
  a04=sin(a48);
  a04=(a62*a04);
  a29=(a29+a04);
  a29=(a29+a28);
  a28=cos(a48);
  a28=(a37*a28);
  a29=(a29-a28);
  a04=sin(a48);
  a04=(a65*a04);
  a29=(a29-a04);
  a46=cos(a48);
  a46=(a78*a46);
  a29=(a29-a46);
  a24=sin(a70);
  a24=(a52*a24);
  a29=(a29-a24);
  a21=cos(a70);
  a21=(a69*a21);
  a29=(a29-a21);
  if (res[0]!=0) res[0][29]=a29;
  a20=(a06*a20);
  a15=(a32*a15);
  a20=(a20+a15);
  a41=(a41-a20);
  a20=(a01*a51);
  a20=(a20*a30);
  a41=(a41-a20);
  a01=(a01*a51);
  a51=(a10+a18);
  a01=(a01*a51);
  a41=(a41+a01);
  a01=sin(a48);
  a01=(a62*a01);
  a51=(a01-a28);
  a51=(a09*a51);
  a41=(a41+a51);
  a51=(a04+a46);
  a09=(a09*a51);
  a41=(a41-a09);
  a09=(a24+a21);
  a34=(a34+a36);
  a09=(a09*a34);
  a41=(a41-a09);
  if (res[0]!=0) res[0][30]=a41;
  a26=(a26/a03);
  if (res[0]!=0) res[0][31]=a26;
  a29=(a29/a03);
  if (res[0]!=0) res[0][32]=a29;
  if (res[0]!=0) res[0][33]=a02;
  a32=(a32*a64);
  a02=sin(a13);
  a32=(a32*a02);
  a64=(a06*a64);
  a02=sin(a13);
  a64=(a64*a02);
  a06=(a06*a61);
  a61=cos(a13);
  a06=(a06*a61);
  a64=(a64+a06);
  a32=(a32-a64);
  a64=(a65*a43);
  a06=sin(a13);
  a64=(a64*a06);
  a06=sin(a48);
  a64=(a64*a06);
  a32=(a32+a64);
  a64=(a62*a44);
  a06=sin(a48);
  a64=(a64*a06);
  a06=cos(a13);
  a64=(a64*a06);
  a32=(a32+a64);
  a64=(a52*a33);
  a06=sin(a70);
  a64=(a64*a06);
  a06=sin(a13);
  a64=(a64*a06);
  a32=(a32+a64);
  a64=(a78*a43);
  a06=sin(a13);
  a64=(a64*a06);
  a06=cos(a48);
  a64=(a64*a06);
  a32=(a32+a64);
  a64=(a37*a43);
  a06=sin(a13);
  a64=(a64*a06);
  a06=cos(a48);
  a64=(a64*a06);
  a32=(a32+a64);
  a64=(a69*a33);
  a06=sin(a13);
  a64=(a64*a06);
  a06=cos(a70);
  a64=(a64*a06);
  a32=(a32+a64);
  a32=(a32-a31);
  a31=cos(a13);
  a31=(a44*a31);
  a28=(a28*a31);
  a32=(a32-a28);
  a04=(a04*a31);
  a32=(a32-a04);
  a46=(a46*a31);
  a32=(a32-a46);
  a46=cos(a13);
  a46=(a35*a46);
  a24=(a24*a46);
  a32=(a32-a24);
  a21=(a21*a46);
  a32=(a32-a21);
  a21=sin(a13);
  a21=(a43*a21);
  a01=(a01*a21);
  a32=(a32-a01);
  if (res[0]!=0) res[0][34]=a32;
  a65=(a65*a44);
  a32=cos(a13);
  a65=(a65*a32);
  a32=cos(a48);
  a65=(a65*a32);
  a38=(a07*a38);
  a07=(a07*a39);
  a38=(a38+a07);
  a65=(a65-a38);
  a62=(a62*a44);
  a38=cos(a13);
  a62=(a62*a38);
  a38=cos(a48);
  a62=(a62*a38);
  a65=(a65+a62);
  a52=(a52*a35);
  a35=cos(a70);
  a52=(a52*a35);
  a35=cos(a13);
  a52=(a52*a35);
  a65=(a65+a52);
  a43=(a78*a43);
  a52=sin(a13);
  a43=(a43*a52);
  a52=sin(a48);
  a43=(a43*a52);
  a65=(a65+a43);
  a78=(a78*a31);
  a31=sin(a48);
  a78=(a78*a31);
  a65=(a65-a78);
  a37=(a37*a44);
  a48=sin(a48);
  a37=(a37*a48);
  a48=cos(a13);
  a37=(a37*a48);
  a65=(a65+a37);
  a37=(a69*a33);
  a48=sin(a70);
  a37=(a37*a48);
  a48=sin(a13);
  a37=(a37*a48);
  a65=(a65+a37);
  a69=(a69*a46);
  a70=sin(a70);
  a69=(a69*a70);
  a65=(a65-a69);
  a33=(a33*a22);
  a13=sin(a13);
  a33=(a33*a13);
  a65=(a65-a33);
  a14=(a14*a21);
  a65=(a65-a14);
  a10=(a10*a21);
  a65=(a65-a10);
  a18=(a18*a21);
  a65=(a65-a18);
  a65=(a65-a42);
  if (res[0]!=0) res[0][35]=a65;
  a65=arg[2]? arg[2][75] : 0;
  a27=(a27-a65);
  if (res[0]!=0) res[0][36]=a27;
  a27=-5.0000000000000000e-01;
  a65=arg[2]? arg[2][76] : 0;
  a27=(a27*a65);
  a65=arg[0]? arg[0][4] : 0;
  a65=casadi_fabs(a65);
  a27=(a27+a65);
  if (res[0]!=0) res[0][37]=a27;
  a16=casadi_fabs(a16);
  a27=arg[2]? arg[2][77] : 0;
  a16=(a16-a27);
  if (res[0]!=0) res[0][38]=a16;
  return 0;
}

CASADI_SYMBOL_EXPORT int rollout_outputs(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f4(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rollout_outputs_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rollout_outputs_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rollout_outputs_incref(void) {
}

CASADI_SYMBOL_EXPORT void rollout_outputs_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rollout_outputs_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int rollout_outputs_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real rollout_outputs_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rollout_outputs_name_in(casadi_int i) {
  switch (i) {
    case 0: return "x";
    case 1: return "u";
    case 2: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rollout_outputs_name_out(casadi_int i) {
  switch (i) {
    case 0: return "y";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rollout_outputs_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rollout_outputs_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rollout_outputs_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int rollout_outputs_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* fwd1_rollout_outputs:(x[6],u[11],p[79],out_y[39x1,0nz],fwd_x[6],fwd_u[11],fwd_p[79])->(fwd_y[39]) */
static int casadi_f5(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
  casadi_real a156, a157, a158, a159, a160;
  a000=0.;
  a001=5.0000000000000000e-01;
  a002=arg[2]? arg[2][26] : 0;
  a003=arg[2]? arg[2][27] : 0;
  a004=(a002*a003);
  a005=arg[2]? arg[2][12] : 0;
  a006=1.0000000000000001e-01;
  a007=(a005+a006);
  a008=(-a007);
  a009=arg[2]? arg[2][11] : 0;
  a010=arg[1]? arg[1][3] : 0;
  a011=arg[2]? arg[2][10] : 0;
  a012=(a010*a011);
  a013=arg[2]? arg[2][9] : 0;
  a012=(a012+a013);
  a013=1.;
  a014=arg[2]? arg[2][8] : 0;
  a014=(a013-a014);
  a015=arg[2]? arg[2][1] : 0;
  a016=arg[0]? arg[0][0] : 0;
  a017=arg[1]? arg[1][0] : 0;
  a018=arg[0]? arg[0][5] : 0;
  a019=cos(a018);
  a020=(a017*a019);
  a021=arg[1]? arg[1][1] : 0;
  a022=sin(a018);
  a023=(a021*a022);
  a020=(a020+a023);
  a023=(a016-a020);
  a024=casadi_sq(a023);
  a025=1.0000000000000000e-04;
  a024=(a024+a025);
  a024=sqrt(a024);
  a026=(a023*a024);
  a027=(a001*a026);
  a028=arg[1]? arg[1][2] : 0;
  a029=arg[2]? arg[2][6] : 0;
  a030=arg[2]? arg[2][7] : 0;
  a031=casadi_sq(a030);
  a032=9.9999999999999998e-13;
  a031=(a031+a032);
  a031=sqrt(a031);
  a033=(a029*a031);
  a034=(a028/a033);
  a027=(a027+a034);
  a035=(2.*a034);
  a026=(a026+a035);
  a035=casadi_sq(a026);
  a036=1.0000000000000000e-08;
  a035=(a035+a036);
  a035=sqrt(a035);
  a037=(a001*a035);
  a027=(a027+a037);
  a037=sqrt(a027);
  a037=atan2(a000,a037);
  a037=(a015+a037);
  a038=(a014*a037);
  a012=(a012+a038);
  a038=(a009*a012);
  a039=casadi_fmin(a007,a038);
  a040=casadi_fmax(a008,a039);
  a041=2.0000000000000001e-01;
  a042=-5.;
  a043=(a042*a005);
  a044=5.;
  a045=(a044*a040);
  a043=(a043-a045);
  a043=(a043+a001);
  a045=casadi_fmax(a000,a043);
  a046=casadi_sq(a045);
  a047=(a045*a046);
  a047=(a041*a047);
  a048=(a001*a045);
  a048=(a013-a048);
  a049=(a047*a048);
  a049=(a040+a049);
  a005=(a042*a005);
  a040=(a044*a040);
  a005=(a005+a040);
  a005=(a005+a001);
  a040=casadi_fmax(a000,a005);
  a050=casadi_sq(a040);
  a051=(a040*a050);
  a051=(a041*a051);
  a052=(a001*a040);
  a052=(a013-a052);
  a053=(a051*a052);
  a049=(a049-a053);
  a049=(a001*a049);
  a053=arg[2]? arg[2][13] : 0;
  a054=(a049*a053);
  a055=(a054*a030);
  a056=arg[2]? arg[2][14] : 0;
  a057=(a055*a056);
  a058=(a057*a027);
  a004=(a004-a058);
  a059=arg[2]? arg[2][22] : 0;
  a060=(a059+a006);
  a061=(-a060);
  a062=arg[2]? arg[2][20] : 0;
  a063=arg[2]? arg[2][21] : 0;
  a064=(a063*a015);
  a062=(a062+a064);
  a064=casadi_fmin(a060,a062);
  a065=casadi_fmax(a061,a064);
  a066=(a042*a059);
  a067=(a044*a065);
  a066=(a066-a067);
  a066=(a066+a001);
  a067=casadi_fmax(a000,a066);
  a068=casadi_sq(a067);
  a069=(a067*a068);
  a069=(a041*a069);
  a070=(a001*a067);
  a070=(a013-a070);
  a071=(a069*a070);
  a071=(a065+a071);
  a059=(a042*a059);
  a065=(a044*a065);
  a059=(a059+a065);
  a059=(a059+a001);
  a065=casadi_fmax(a000,a059);
  a072=casadi_sq(a065);
  a073=(a065*a072);
  a073=(a041*a073);
  a074=(a001*a065);
  a074=(a013-a074);
  a075=(a073*a074);
  a071=(a071-a075);
  a075=arg[2]? arg[2][15] : 0;
  a076=(a001*a075);
  a077=(a016-a020);
  a078=casadi_sq(a077);
  a078=(a078+a036);
  a079=arg[0]? arg[0][1] : 0;
  a080=cos(a018);
  a081=(a021*a080);
  a082=sin(a018);
  a083=(a017*a082);
  a081=(a081-a083);
  a083=(a079-a081);
  a084=casadi_sq(a083);
  a084=(a078+a084);
  a085=(a076*a084);
  a086=(a085*a030);
  a087=(a071*a086);
  a088=(a087*a077);
  a089=sqrt(a078);
  a088=(a088/a089);
  a004=(a004-a088);
  a090=arg[2]? arg[2][25] : 0;
  a091=cos(a015);
  a092=(a090*a091);
  a093=arg[2]? arg[2][30] : 0;
  a094=sin(a015);
  a095=(a093*a094);
  a096=(a092+a095);
  a097=(a004*a096);
  a098=arg[2]? arg[2][28] : 0;
  a099=cos(a015);
  a100=(a098*a099);
  a101=arg[2]? arg[2][29] : 0;
  a102=sin(a015);
  a103=(a101*a102);
  a104=(a100+a103);
  a105=(a058*a104);
  a106=arg[2]? arg[2][19] : 0;
  a107=(a106*a086);
  a108=arg[2]? arg[2][16] : 0;
  a109=arg[2]? arg[2][17] : 0;
  a110=(a109*a015);
  a108=(a108+a110);
  a110=arg[2]? arg[2][18] : 0;
  a111=(a110*a010);
  a108=(a108+a111);
  a111=(a107*a108);
  a112=arg[2]? arg[2][31] : 0;
  a113=(a028*a112);
  a114=cos(a015);
  a115=(a113*a114);
  a111=(a111+a115);
  a105=(a105+a111);
  a097=(a097+a105);
  a097=(a001*a097);
  a111=arg[2]? arg[2][0] : 0;
  a115=cos(a015);
  a116=(a111*a115);
  a117=arg[2]? arg[2][4] : 0;
  a118=sin(a015);
  a119=(a117*a118);
  a116=(a116+a119);
  a119=(a092+a095);
  a119=(a116-a119);
  a097=(a097/a119);
  a120=(-a097);
  a121=(a000<=a120);
  a122=(a120<=a000);
  a122=(a122+a121);
  a121=(a121/a122);
  a122=arg[6]? arg[6][26] : 0;
  a122=(a003*a122);
  a123=arg[6]? arg[6][27] : 0;
  a002=(a002*a123);
  a122=(a122+a002);
  a002=(a008<=a039);
  a039=(a039<=a008);
  a008=(a039+a002);
  a002=(a002/a008);
  a124=(a007<=a038);
  a038=(a038<=a007);
  a007=(a124+a038);
  a124=(a124/a007);
  a125=arg[6]? arg[6][12] : 0;
  a124=(a124*a125);
  a038=(a038/a007);
  a007=arg[6]? arg[6][11] : 0;
  a012=(a012*a007);
  a007=arg[5]? arg[5][3] : 0;
  a011=(a011*a007);
  a126=arg[6]? arg[6][10] : 0;
  a126=(a010*a126);
  a011=(a011+a126);
  a126=arg[6]? arg[6][9] : 0;
  a011=(a011+a126);
  a126=arg[6]? arg[6][1] : 0;
  a014=(a014*a126);
  a127=arg[6]? arg[6][8] : 0;
  a037=(a037*a127);
  a014=(a014-a037);
  a011=(a011+a014);
  a009=(a009*a011);
  a012=(a012+a009);
  a038=(a038*a012);
  a124=(a124+a038);
  a002=(a002*a124);
  a039=(a039/a008);
  a039=(a039*a125);
  a002=(a002-a039);
  a039=(a000<=a043);
  a043=(a043<=a000);
  a043=(a043+a039);
  a039=(a039/a043);
  a043=(a042*a125);
  a008=(a044*a002);
  a043=(a043-a008);
  a039=(a039*a043);
  a046=(a046*a039);
  a043=(2.*a045);
  a043=(a043*a039);
  a045=(a045*a043);
  a046=(a046+a045);
  a046=(a041*a046);
  a048=(a048*a046);
  a039=(a001*a039);
  a047=(a047*a039);
  a048=(a048-a047);
  a048=(a002+a048);
  a047=(a000<=a005);
  a005=(a005<=a000);
  a005=(a005+a047);
  a047=(a047/a005);
  a125=(a042*a125);
  a002=(a044*a002);
  a125=(a125+a002);
  a047=(a047*a125);
  a050=(a050*a047);
  a125=(2.*a040);
  a125=(a125*a047);
  a040=(a040*a125);
  a050=(a050+a040);
  a050=(a041*a050);
  a052=(a052*a050);
  a047=(a001*a047);
  a051=(a051*a047);
  a052=(a052-a051);
  a048=(a048-a052);
  a052=(a001*a048);
  a053=(a053*a052);
  a052=arg[6]? arg[6][13] : 0;
  a049=(a049*a052);
  a053=(a053+a049);
  a053=(a030*a053);
  a049=arg[6]? arg[6][7] : 0;
  a054=(a054*a049);
  a053=(a053+a054);
  a056=(a056*a053);
  a053=arg[6]? arg[6][14] : 0;
  a055=(a055*a053);
  a056=(a056+a055);
  a027=(a027*a056);
  a056=arg[4]? arg[4][0] : 0;
  a055=arg[5]? arg[5][0] : 0;
  a019=(a019*a055);
  a053=sin(a018);
  a054=arg[4]? arg[4][5] : 0;
  a053=(a053*a054);
  a053=(a017*a053);
  a019=(a019-a053);
  a053=arg[5]? arg[5][1] : 0;
  a022=(a022*a053);
  a052=cos(a018);
  a052=(a052*a054);
  a052=(a021*a052);
  a022=(a022+a052);
  a019=(a019+a022);
  a022=(a056-a019);
  a052=(a024*a022);
  a051=(2.*a023);
  a051=(a051*a022);
  a024=(2.*a024);
  a051=(a051/a024);
  a023=(a023*a051);
  a052=(a052+a023);
  a023=(a001*a052);
  a051=arg[5]? arg[5][2] : 0;
  a024=(a051/a033);
  a033=(a034/a033);
  a022=arg[6]? arg[6][6] : 0;
  a022=(a031*a022);
  a047=(2.*a030);
  a047=(a047*a049);
  a031=(2.*a031);
  a047=(a047/a031);
  a029=(a029*a047);
  a022=(a022+a029);
  a033=(a033*a022);
  a024=(a024-a033);
  a023=(a023+a024);
  a026=(2.*a026);
  a033=(2.*a024);
  a052=(a052+a033);
  a026=(a026*a052);
  a035=(2.*a035);
  a026=(a026/a035);
  a026=(a001*a026);
  a023=(a023+a026);
  a057=(a057*a023);
  a027=(a027+a057);
  a122=(a122-a027);
  a057=(a061<=a064);
  a064=(a064<=a061);
  a061=(a064+a057);
  a057=(a057/a061);
  a023=(a060<=a062);
  a062=(a062<=a060);
  a060=(a023+a062);
  a023=(a023/a060);
  a026=arg[6]? arg[6][22] : 0;
  a023=(a023*a026);
  a062=(a062/a060);
  a060=arg[6]? arg[6][20] : 0;
  a035=arg[6]? arg[6][21] : 0;
  a035=(a015*a035);
  a063=(a063*a126);
  a035=(a035+a063);
  a060=(a060+a035);
  a062=(a062*a060);
  a023=(a023+a062);
  a057=(a057*a023);
  a064=(a064/a061);
  a064=(a064*a026);
  a057=(a057-a064);
  a064=(a000<=a066);
  a066=(a066<=a000);
  a066=(a066+a064);
  a064=(a064/a066);
  a066=(a042*a026);
  a061=(a044*a057);
  a066=(a066-a061);
  a064=(a064*a066);
  a068=(a068*a064);
  a066=(2.*a067);
  a066=(a066*a064);
  a067=(a067*a066);
  a068=(a068+a067);
  a068=(a041*a068);
  a070=(a070*a068);
  a064=(a001*a064);
  a069=(a069*a064);
  a070=(a070-a069);
  a070=(a057+a070);
  a069=(a000<=a059);
  a059=(a059<=a000);
  a059=(a059+a069);
  a069=(a069/a059);
  a026=(a042*a026);
  a057=(a044*a057);
  a026=(a026+a057);
  a069=(a069*a026);
  a072=(a072*a069);
  a026=(2.*a065);
  a026=(a026*a069);
  a065=(a065*a026);
  a072=(a072+a065);
  a072=(a041*a072);
  a074=(a074*a072);
  a069=(a001*a069);
  a073=(a073*a069);
  a074=(a074-a073);
  a070=(a070-a074);
  a074=(a086*a070);
  a073=arg[6]? arg[6][15] : 0;
  a069=(a001*a073);
  a069=(a084*a069);
  a072=(2.*a077);
  a065=(a056-a019);
  a072=(a072*a065);
  a026=(2.*a083);
  a057=arg[4]? arg[4][1] : 0;
  a080=(a080*a053);
  a053=sin(a018);
  a053=(a053*a054);
  a021=(a021*a053);
  a080=(a080-a021);
  a082=(a082*a055);
  a055=cos(a018);
  a055=(a055*a054);
  a017=(a017*a055);
  a082=(a082+a017);
  a080=(a080-a082);
  a082=(a057-a080);
  a026=(a026*a082);
  a026=(a072+a026);
  a076=(a076*a026);
  a069=(a069+a076);
  a069=(a030*a069);
  a085=(a085*a049);
  a069=(a069+a085);
  a085=(a071*a069);
  a074=(a074+a085);
  a085=(a077*a074);
  a087=(a087*a065);
  a085=(a085+a087);
  a085=(a085/a089);
  a088=(a088/a089);
  a087=(2.*a089);
  a072=(a072/a087);
  a088=(a088*a072);
  a085=(a085-a088);
  a122=(a122-a085);
  a096=(a096*a122);
  a085=arg[6]? arg[6][25] : 0;
  a091=(a091*a085);
  a088=sin(a015);
  a088=(a088*a126);
  a088=(a090*a088);
  a091=(a091-a088);
  a088=arg[6]? arg[6][30] : 0;
  a094=(a094*a088);
  a087=cos(a015);
  a087=(a087*a126);
  a087=(a093*a087);
  a094=(a094+a087);
  a087=(a091+a094);
  a087=(a004*a087);
  a096=(a096+a087);
  a104=(a104*a027);
  a087=arg[6]? arg[6][28] : 0;
  a099=(a099*a087);
  a087=sin(a015);
  a087=(a087*a126);
  a098=(a098*a087);
  a099=(a099-a098);
  a098=arg[6]? arg[6][29] : 0;
  a102=(a102*a098);
  a098=cos(a015);
  a098=(a098*a126);
  a101=(a101*a098);
  a102=(a102+a101);
  a101=(a099+a102);
  a101=(a058*a101);
  a104=(a104+a101);
  a101=arg[6]? arg[6][19] : 0;
  a101=(a086*a101);
  a106=(a106*a069);
  a101=(a101+a106);
  a108=(a108*a101);
  a101=arg[6]? arg[6][16] : 0;
  a106=arg[6]? arg[6][17] : 0;
  a106=(a015*a106);
  a109=(a109*a126);
  a106=(a106+a109);
  a101=(a101+a106);
  a106=arg[6]? arg[6][18] : 0;
  a010=(a010*a106);
  a110=(a110*a007);
  a010=(a010+a110);
  a101=(a101+a010);
  a107=(a107*a101);
  a108=(a108+a107);
  a112=(a112*a051);
  a107=arg[6]? arg[6][31] : 0;
  a107=(a028*a107);
  a112=(a112+a107);
  a114=(a114*a112);
  a112=sin(a015);
  a112=(a112*a126);
  a113=(a113*a112);
  a114=(a114-a113);
  a114=(a108+a114);
  a104=(a104+a114);
  a096=(a096+a104);
  a096=(a001*a096);
  a096=(a096/a119);
  a097=(a097/a119);
  a113=arg[6]? arg[6][0] : 0;
  a115=(a115*a113);
  a112=sin(a015);
  a112=(a112*a126);
  a112=(a111*a112);
  a115=(a115-a112);
  a112=arg[6]? arg[6][4] : 0;
  a118=(a118*a112);
  a107=cos(a015);
  a107=(a107*a126);
  a107=(a117*a107);
  a118=(a118+a107);
  a115=(a115+a118);
  a118=(a091+a094);
  a118=(a115-a118);
  a097=(a097*a118);
  a096=(a096-a097);
  a121=(a121*a096);
  a096=(-a121);
  if (res[0]!=0) res[0][0]=a096;
  a097=arg[2]? arg[2][2] : 0;
  a107=cos(a097);
  a101=arg[4]? arg[4][2] : 0;
  a010=(a116*a101);
  a110=arg[0]? arg[0][2] : 0;
  a007=(a110*a115);
  a010=(a010+a007);
  a010=(a010+a057);
  a007=(a107*a010);
  a106=(a110*a116);
  a106=(a106+a079);
  a109=sin(a097);
  a098=arg[6]? arg[6][2] : 0;
  a109=(a109*a098);
  a109=(a106*a109);
  a007=(a007-a109);
  a109=sin(a097);
  a087=arg[2]? arg[2][3] : 0;
  a076=(a001*a101);
  a076=(a087*a076);
  a017=(a001*a110);
  a055=arg[6]? arg[6][3] : 0;
  a021=(a017*a055);
  a076=(a076+a021);
  a021=(a056+a076);
  a021=(a109*a021);
  a017=(a017*a087);
  a053=(a016+a017);
  a059=cos(a097);
  a059=(a059*a098);
  a059=(a053*a059);
  a021=(a021+a059);
  a007=(a007-a021);
  a021=sin(a097);
  a059=(a106*a021);
  a064=(a016+a017);
  a068=cos(a097);
  a067=(a064*a068);
  a067=(a059+a067);
  a066=casadi_sq(a067);
  a061=9.9999999999999995e-07;
  a023=arg[2]? arg[2][5] : 0;
  a062=casadi_sq(a023);
  a062=(a061*a062);
  a066=(a066+a062);
  a060=sqrt(a066);
  a035=(a007/a060);
  a107=(a106*a107);
  a053=(a053*a109);
  a107=(a107-a053);
  a053=(a107/a060);
  a109=(a053/a060);
  a063=(2.*a067);
  a021=(a021*a010);
  a052=cos(a097);
  a052=(a052*a098);
  a052=(a106*a052);
  a021=(a021+a052);
  a052=(a056+a076);
  a068=(a068*a052);
  a052=sin(a097);
  a052=(a052*a098);
  a064=(a064*a052);
  a068=(a068-a064);
  a068=(a021+a068);
  a063=(a063*a068);
  a064=(2.*a023);
  a052=arg[6]? arg[6][5] : 0;
  a064=(a064*a052);
  a061=(a061*a064);
  a063=(a063+a061);
  a060=(2.*a060);
  a060=(a063/a060);
  a109=(a109*a060);
  a035=(a035-a109);
  a109=casadi_sq(a053);
  a109=(a013+a109);
  a109=(a035/a109);
  if (res[0]!=0) res[0][1]=a109;
  a109=arg[2]? arg[2][36] : 0;
  a060=1.0000000000000000e-03;
  a064=arg[2]? arg[2][34] : 0;
  a033=arg[2]? arg[2][35] : 0;
  a120=casadi_fmax(a000,a120);
  a022=(a033*a120);
  a022=(a064+a022);
  a029=casadi_fmax(a060,a022);
  a047=(a109*a029);
  a031=arg[1]? arg[1][4] : 0;
  a050=arg[2]? arg[2][41] : 0;
  a040=(a047-a050);
  a125=(a031*a040);
  a125=(a125+a050);
  a125=(a125/a047);
  a050=5.0000000000000004e-06;
  a002=(a125+a050);
  a005=(-a002);
  a039=casadi_sq(a023);
  a046=casadi_sq(a039);
  a045=casadi_sq(a067);
  a043=casadi_sq(a107);
  a045=(a045+a043);
  a043=casadi_sq(a045);
  a046=(a046+a043);
  a046=sqrt(a046);
  a043=sqrt(a046);
  a008=(a067/a043);
  a124=casadi_fmin(a002,a008);
  a038=(a005<=a124);
  a012=(a124<=a005);
  a009=(a012+a038);
  a038=(a038/a009);
  a014=(a002<=a008);
  a002=(a008<=a002);
  a037=(a014+a002);
  a014=(a014/a037);
  a127=arg[5]? arg[5][4] : 0;
  a040=(a040*a127);
  a127=arg[6]? arg[6][36] : 0;
  a029=(a029*a127);
  a127=(a060<=a022);
  a022=(a022<=a060);
  a022=(a022+a127);
  a127=(a127/a022);
  a022=arg[6]? arg[6][34] : 0;
  a128=arg[6]? arg[6][35] : 0;
  a129=(a120*a128);
  a130=(a033*a121);
  a129=(a129-a130);
  a129=(a022+a129);
  a127=(a127*a129);
  a109=(a109*a127);
  a029=(a029+a109);
  a109=arg[6]? arg[6][41] : 0;
  a127=(a029-a109);
  a031=(a031*a127);
  a040=(a040+a031);
  a040=(a040+a109);
  a040=(a040/a047);
  a109=(a125/a047);
  a109=(a109*a029);
  a040=(a040-a109);
  a014=(a014*a040);
  a002=(a002/a037);
  a037=(a068/a043);
  a008=(a008/a043);
  a039=(2.*a039);
  a109=(2.*a023);
  a109=(a109*a052);
  a039=(a039*a109);
  a045=(2.*a045);
  a067=(2.*a067);
  a067=(a067*a068);
  a068=(2.*a107);
  a068=(a068*a007);
  a067=(a067+a068);
  a045=(a045*a067);
  a039=(a039+a045);
  a046=(2.*a046);
  a039=(a039/a046);
  a046=(2.*a043);
  a039=(a039/a046);
  a008=(a008*a039);
  a037=(a037-a008);
  a002=(a002*a037);
  a014=(a014+a002);
  a038=(a038*a014);
  a012=(a012/a009);
  a012=(a012*a040);
  a038=(a038-a012);
  a012=-100000.;
  a009=(a012*a125);
  a014=100000.;
  a005=casadi_fmax(a005,a124);
  a124=(a014*a005);
  a009=(a009-a124);
  a009=(a009+a001);
  a124=casadi_fmax(a000,a009);
  a002=(a001*a124);
  a002=(a013-a002);
  a037=1.0000000000000001e-05;
  a008=casadi_sq(a124);
  a046=(a000<=a009);
  a009=(a009<=a000);
  a009=(a009+a046);
  a046=(a046/a009);
  a009=(a012*a040);
  a045=(a014*a038);
  a009=(a009-a045);
  a046=(a046*a009);
  a009=(a008*a046);
  a045=(2.*a124);
  a045=(a045*a046);
  a045=(a124*a045);
  a009=(a009+a045);
  a009=(a037*a009);
  a009=(a002*a009);
  a124=(a124*a008);
  a124=(a037*a124);
  a046=(a001*a046);
  a046=(a124*a046);
  a009=(a009-a046);
  a009=(a038+a009);
  a125=(a012*a125);
  a046=(a014*a005);
  a125=(a125+a046);
  a125=(a125+a001);
  a046=casadi_fmax(a000,a125);
  a008=(a001*a046);
  a008=(a013-a008);
  a045=casadi_sq(a046);
  a067=(a000<=a125);
  a125=(a125<=a000);
  a125=(a125+a067);
  a067=(a067/a125);
  a040=(a012*a040);
  a038=(a014*a038);
  a040=(a040+a038);
  a067=(a067*a040);
  a040=(a045*a067);
  a038=(2.*a046);
  a038=(a038*a067);
  a038=(a046*a038);
  a040=(a040+a038);
  a040=(a037*a040);
  a040=(a008*a040);
  a046=(a046*a045);
  a046=(a037*a046);
  a067=(a001*a067);
  a067=(a046*a067);
  a040=(a040-a067);
  a009=(a009-a040);
  a040=(a120*a009);
  a124=(a124*a002);
  a005=(a005+a124);
  a046=(a046*a008);
  a005=(a005-a046);
  a046=(a005*a121);
  a040=(a040-a046);
  a040=(a047*a040);
  a046=(a120*a005);
  a008=(a046*a029);
  a040=(a040+a008);
  if (res[0]!=0) res[0][2]=a040;
  a008=casadi_sq(a005);
  a008=(a013-a008);
  a008=sqrt(a008);
  a124=(a008+a050);
  a002=arg[2]? arg[2][40] : 0;
  a067=arg[2]? arg[2][39] : 0;
  a045=arg[2]? arg[2][37] : 0;
  a038=arg[2]? arg[2][38] : 0;
  a125=(a038-a013);
  a068=casadi_fmax(a032,a125);
  a068=sqrt(a068);
  a109=(a045*a068);
  a031=(1./a109);
  a127=(-a031);
  a129=arg[2]? arg[2][32] : 0;
  a130=arg[2]? arg[2][33] : 0;
  a131=(a130*a120);
  a131=(a129+a131);
  a132=casadi_fmax(a000,a131);
  a133=(a132*a053);
  a133=(a133/a047);
  a134=casadi_fmin(a133,a031);
  a135=casadi_fmax(a127,a134);
  a136=(a013-a038);
  a137=(a135*a136);
  a138=(a045*a135);
  a139=atan(a138);
  a140=(a038*a139);
  a140=(a140/a045);
  a137=(a137+a140);
  a141=(a045*a137);
  a142=atan(a141);
  a143=(a067*a142);
  a144=sin(a143);
  a145=(a002*a144);
  a146=casadi_sq(a107);
  a146=(a146+a066);
  a146=sqrt(a146);
  a066=(a145*a146);
  a066=(a066/a043);
  a147=casadi_fmin(a124,a066);
  a148=(-a124);
  a149=(a147<=a148);
  a150=(a148<=a147);
  a151=(a149+a150);
  a149=(a149/a151);
  a005=(2.*a005);
  a005=(a005*a009);
  a009=(2.*a008);
  a005=(a005/a009);
  a149=(a149*a005);
  a150=(a150/a151);
  a151=(a066<=a124);
  a124=(a124<=a066);
  a009=(a124+a151);
  a151=(a151/a009);
  a152=arg[6]? arg[6][40] : 0;
  a144=(a144*a152);
  a143=cos(a143);
  a153=arg[6]? arg[6][39] : 0;
  a142=(a142*a153);
  a154=arg[6]? arg[6][37] : 0;
  a137=(a137*a154);
  a155=(a134<=a127);
  a127=(a127<=a134);
  a134=(a155+a127);
  a155=(a155/a134);
  a109=(a031/a109);
  a156=(a068*a154);
  a157=(a032<=a125);
  a125=(a125<=a032);
  a125=(a125+a157);
  a157=(a157/a125);
  a125=arg[6]? arg[6][38] : 0;
  a157=(a157*a125);
  a068=(2.*a068);
  a157=(a157/a068);
  a157=(a045*a157);
  a156=(a156+a157);
  a109=(a109*a156);
  a155=(a155*a109);
  a127=(a127/a134);
  a134=(a133<=a031);
  a156=(a031<=a133);
  a157=(a134+a156);
  a134=(a134/a157);
  a068=(a000<=a131);
  a131=(a131<=a000);
  a131=(a131+a068);
  a068=(a068/a131);
  a131=arg[6]? arg[6][32] : 0;
  a158=arg[6]? arg[6][33] : 0;
  a159=(a120*a158);
  a160=(a130*a121);
  a159=(a159-a160);
  a159=(a131+a159);
  a068=(a068*a159);
  a053=(a053*a068);
  a132=(a132*a035);
  a053=(a053+a132);
  a053=(a053/a047);
  a133=(a133/a047);
  a133=(a133*a029);
  a053=(a053-a133);
  a134=(a134*a053);
  a156=(a156/a157);
  a156=(a156*a109);
  a134=(a134-a156);
  a127=(a127*a134);
  a155=(a155+a127);
  a136=(a136*a155);
  a127=(a135*a125);
  a136=(a136-a127);
  a139=(a139*a125);
  a135=(a135*a154);
  a155=(a045*a155);
  a135=(a135+a155);
  a138=casadi_sq(a138);
  a138=(a013+a138);
  a135=(a135/a138);
  a135=(a038*a135);
  a139=(a139+a135);
  a139=(a139/a045);
  a140=(a140/a045);
  a140=(a140*a154);
  a139=(a139-a140);
  a136=(a136+a139);
  a136=(a045*a136);
  a137=(a137+a136);
  a141=casadi_sq(a141);
  a141=(a013+a141);
  a137=(a137/a141);
  a137=(a067*a137);
  a142=(a142+a137);
  a143=(a143*a142);
  a143=(a002*a143);
  a144=(a144+a143);
  a144=(a146*a144);
  a107=(2.*a107);
  a107=(a107*a007);
  a107=(a107+a063);
  a146=(2.*a146);
  a107=(a107/a146);
  a145=(a145*a107);
  a144=(a144+a145);
  a144=(a144/a043);
  a066=(a066/a043);
  a066=(a066*a039);
  a144=(a144-a066);
  a151=(a151*a144);
  a124=(a124/a009);
  a124=(a124*a005);
  a151=(a151-a124);
  a150=(a150*a151);
  a149=(a149+a150);
  a150=(a012*a008);
  a148=casadi_fmax(a148,a147);
  a147=(a014*a148);
  a150=(a150-a147);
  a150=(a150+a001);
  a147=casadi_fmax(a000,a150);
  a151=casadi_sq(a147);
  a124=(a147*a151);
  a124=(a037*a124);
  a009=(a000<=a150);
  a150=(a150<=a000);
  a150=(a150+a009);
  a009=(a009/a150);
  a150=(a012*a005);
  a144=(a014*a149);
  a150=(a150+a144);
  a009=(a009*a150);
  a150=(a001*a009);
  a150=(a124*a150);
  a144=(a001*a147);
  a144=(a013-a144);
  a151=(a151*a009);
  a066=(2.*a147);
  a066=(a066*a009);
  a147=(a147*a066);
  a151=(a151+a147);
  a151=(a037*a151);
  a151=(a144*a151);
  a150=(a150-a151);
  a150=(a149+a150);
  a008=(a012*a008);
  a151=(a014*a148);
  a008=(a008+a151);
  a008=(a008+a001);
  a151=casadi_fmax(a000,a008);
  a147=(a001*a151);
  a147=(a013-a147);
  a066=casadi_sq(a151);
  a009=(a000<=a008);
  a008=(a008<=a000);
  a008=(a008+a009);
  a009=(a009/a008);
  a149=(a014*a149);
  a005=(a012*a005);
  a149=(a149-a005);
  a009=(a009*a149);
  a149=(a066*a009);
  a005=(2.*a151);
  a005=(a005*a009);
  a005=(a151*a005);
  a149=(a149+a005);
  a149=(a037*a149);
  a149=(a147*a149);
  a151=(a151*a066);
  a151=(a037*a151);
  a009=(a001*a009);
  a009=(a151*a009);
  a149=(a149-a009);
  a150=(a150-a149);
  a150=(a120*a150);
  a124=(a124*a144);
  a148=(a148+a124);
  a151=(a151*a147);
  a148=(a148-a151);
  a151=(a148*a121);
  a150=(a150-a151);
  a150=(a047*a150);
  a148=(a120*a148);
  a029=(a148*a029);
  a150=(a150+a029);
  if (res[0]!=0) res[0][3]=a150;
  if (res[0]!=0) res[0][4]=a096;
  a096=cos(a097);
  a010=(a096*a010);
  a029=sin(a097);
  a029=(a029*a098);
  a029=(a106*a029);
  a010=(a010-a029);
  a029=sin(a097);
  a151=(a056-a076);
  a151=(a029*a151);
  a147=(a016-a017);
  a124=cos(a097);
  a124=(a124*a098);
  a124=(a147*a124);
  a151=(a151+a124);
  a010=(a010+a151);
  a017=(a016-a017);
  a151=cos(a097);
  a124=(a017*a151);
  a124=(a124-a059);
  a059=casadi_sq(a124);
  a059=(a059+a062);
  a144=sqrt(a059);
  a149=(a010/a144);
  a106=(a106*a096);
  a147=(a147*a029);
  a106=(a106+a147);
  a147=(a106/a144);
  a029=(a147/a144);
  a096=(2.*a124);
  a076=(a056-a076);
  a151=(a151*a076);
  a076=sin(a097);
  a076=(a076*a098);
  a017=(a017*a076);
  a151=(a151-a017);
  a151=(a151-a021);
  a096=(a096*a151);
  a096=(a096+a061);
  a144=(2.*a144);
  a144=(a096/a144);
  a029=(a029*a144);
  a149=(a149-a029);
  a029=casadi_sq(a147);
  a029=(a013+a029);
  a029=(a149/a029);
  if (res[0]!=0) res[0][5]=a029;
  a029=arg[2]? arg[2][42] : 0;
  a144=(a033*a120);
  a064=(a064+a144);
  a144=casadi_fmax(a060,a064);
  a021=(a029*a144);
  a017=arg[1]? arg[1][5] : 0;
  a076=arg[2]? arg[2][43] : 0;
  a009=(a021-a076);
  a066=(a017*a009);
  a066=(a066+a076);
  a066=(a066/a021);
  a076=(a066+a050);
  a005=(-a076);
  a008=casadi_sq(a023);
  a039=casadi_sq(a008);
  a043=casadi_sq(a124);
  a145=casadi_sq(a106);
  a043=(a043+a145);
  a145=casadi_sq(a043);
  a039=(a039+a145);
  a039=sqrt(a039);
  a145=sqrt(a039);
  a107=(a124/a145);
  a146=casadi_fmin(a076,a107);
  a063=(a005<=a146);
  a007=(a146<=a005);
  a143=(a007+a063);
  a063=(a063/a143);
  a142=(a076<=a107);
  a076=(a107<=a076);
  a137=(a142+a076);
  a142=(a142/a137);
  a141=arg[5]? arg[5][5] : 0;
  a009=(a009*a141);
  a141=arg[6]? arg[6][42] : 0;
  a144=(a144*a141);
  a141=(a060<=a064);
  a064=(a064<=a060);
  a064=(a064+a141);
  a141=(a141/a064);
  a128=(a120*a128);
  a033=(a033*a121);
  a128=(a128-a033);
  a022=(a022+a128);
  a141=(a141*a022);
  a029=(a029*a141);
  a144=(a144+a029);
  a029=arg[6]? arg[6][43] : 0;
  a141=(a144-a029);
  a017=(a017*a141);
  a009=(a009+a017);
  a009=(a009+a029);
  a009=(a009/a021);
  a029=(a066/a021);
  a029=(a029*a144);
  a009=(a009-a029);
  a142=(a142*a009);
  a076=(a076/a137);
  a137=(a151/a145);
  a107=(a107/a145);
  a008=(2.*a008);
  a029=(2.*a023);
  a029=(a029*a052);
  a008=(a008*a029);
  a043=(2.*a043);
  a124=(2.*a124);
  a124=(a124*a151);
  a151=(2.*a106);
  a151=(a151*a010);
  a124=(a124+a151);
  a043=(a043*a124);
  a008=(a008+a043);
  a039=(2.*a039);
  a008=(a008/a039);
  a039=(2.*a145);
  a008=(a008/a039);
  a107=(a107*a008);
  a137=(a137-a107);
  a076=(a076*a137);
  a142=(a142+a076);
  a063=(a063*a142);
  a007=(a007/a143);
  a007=(a007*a009);
  a063=(a063-a007);
  a007=(a012*a066);
  a005=casadi_fmax(a005,a146);
  a146=(a014*a005);
  a007=(a007-a146);
  a007=(a007+a001);
  a146=casadi_fmax(a000,a007);
  a143=(a001*a146);
  a143=(a013-a143);
  a142=casadi_sq(a146);
  a076=(a000<=a007);
  a007=(a007<=a000);
  a007=(a007+a076);
  a076=(a076/a007);
  a007=(a012*a009);
  a137=(a014*a063);
  a007=(a007-a137);
  a076=(a076*a007);
  a007=(a142*a076);
  a137=(2.*a146);
  a137=(a137*a076);
  a137=(a146*a137);
  a007=(a007+a137);
  a007=(a037*a007);
  a007=(a143*a007);
  a146=(a146*a142);
  a146=(a037*a146);
  a076=(a001*a076);
  a076=(a146*a076);
  a007=(a007-a076);
  a007=(a063+a007);
  a066=(a012*a066);
  a076=(a014*a005);
  a066=(a066+a076);
  a066=(a066+a001);
  a076=casadi_fmax(a000,a066);
  a142=(a001*a076);
  a142=(a013-a142);
  a137=casadi_sq(a076);
  a107=(a000<=a066);
  a066=(a066<=a000);
  a066=(a066+a107);
  a107=(a107/a066);
  a009=(a012*a009);
  a063=(a014*a063);
  a009=(a009+a063);
  a107=(a107*a009);
  a009=(a137*a107);
  a063=(2.*a076);
  a063=(a063*a107);
  a063=(a076*a063);
  a009=(a009+a063);
  a009=(a037*a009);
  a009=(a142*a009);
  a076=(a076*a137);
  a076=(a037*a076);
  a107=(a001*a107);
  a107=(a076*a107);
  a009=(a009-a107);
  a007=(a007-a009);
  a009=(a120*a007);
  a146=(a146*a143);
  a005=(a005+a146);
  a076=(a076*a142);
  a005=(a005-a076);
  a076=(a005*a121);
  a009=(a009-a076);
  a009=(a021*a009);
  a076=(a120*a005);
  a142=(a076*a144);
  a009=(a009+a142);
  if (res[0]!=0) res[0][6]=a009;
  a142=casadi_sq(a005);
  a142=(a013-a142);
  a142=sqrt(a142);
  a146=(a142+a050);
  a143=(-a031);
  a107=(a130*a120);
  a129=(a129+a107);
  a107=casadi_fmax(a000,a129);
  a137=(a107*a147);
  a137=(a137/a021);
  a063=casadi_fmin(a137,a031);
  a066=casadi_fmax(a143,a063);
  a039=(a013-a038);
  a043=(a066*a039);
  a124=(a045*a066);
  a151=atan(a124);
  a029=(a038*a151);
  a029=(a029/a045);
  a043=(a043+a029);
  a017=(a045*a043);
  a141=atan(a017);
  a022=(a067*a141);
  a128=sin(a022);
  a033=(a002*a128);
  a064=casadi_sq(a106);
  a064=(a064+a059);
  a064=sqrt(a064);
  a059=(a033*a064);
  a059=(a059/a145);
  a136=casadi_fmin(a146,a059);
  a139=(-a146);
  a140=(a136<=a139);
  a135=(a139<=a136);
  a138=(a140+a135);
  a140=(a140/a138);
  a005=(2.*a005);
  a005=(a005*a007);
  a007=(2.*a142);
  a005=(a005/a007);
  a140=(a140*a005);
  a135=(a135/a138);
  a138=(a059<=a146);
  a146=(a146<=a059);
  a007=(a146+a138);
  a138=(a138/a007);
  a128=(a128*a152);
  a022=cos(a022);
  a141=(a141*a153);
  a043=(a043*a154);
  a153=(a063<=a143);
  a143=(a143<=a063);
  a063=(a153+a143);
  a153=(a153/a063);
  a153=(a153*a109);
  a143=(a143/a063);
  a063=(a137<=a031);
  a031=(a031<=a137);
  a152=(a063+a031);
  a063=(a063/a152);
  a155=(a000<=a129);
  a129=(a129<=a000);
  a129=(a129+a155);
  a155=(a155/a129);
  a158=(a120*a158);
  a130=(a130*a121);
  a158=(a158-a130);
  a131=(a131+a158);
  a155=(a155*a131);
  a147=(a147*a155);
  a107=(a107*a149);
  a147=(a147+a107);
  a147=(a147/a021);
  a137=(a137/a021);
  a137=(a137*a144);
  a147=(a147-a137);
  a063=(a063*a147);
  a031=(a031/a152);
  a031=(a031*a109);
  a063=(a063-a031);
  a143=(a143*a063);
  a153=(a153+a143);
  a039=(a039*a153);
  a143=(a066*a125);
  a039=(a039-a143);
  a151=(a151*a125);
  a066=(a066*a154);
  a153=(a045*a153);
  a066=(a066+a153);
  a124=casadi_sq(a124);
  a124=(a013+a124);
  a066=(a066/a124);
  a038=(a038*a066);
  a151=(a151+a038);
  a151=(a151/a045);
  a029=(a029/a045);
  a029=(a029*a154);
  a151=(a151-a029);
  a039=(a039+a151);
  a045=(a045*a039);
  a043=(a043+a045);
  a017=casadi_sq(a017);
  a017=(a013+a017);
  a043=(a043/a017);
  a067=(a067*a043);
  a141=(a141+a067);
  a022=(a022*a141);
  a002=(a002*a022);
  a128=(a128+a002);
  a128=(a064*a128);
  a106=(2.*a106);
  a106=(a106*a010);
  a106=(a106+a096);
  a064=(2.*a064);
  a106=(a106/a064);
  a033=(a033*a106);
  a128=(a128+a033);
  a128=(a128/a145);
  a059=(a059/a145);
  a059=(a059*a008);
  a128=(a128-a059);
  a138=(a138*a128);
  a146=(a146/a007);
  a146=(a146*a005);
  a138=(a138-a146);
  a135=(a135*a138);
  a140=(a140+a135);
  a135=(a012*a142);
  a139=casadi_fmax(a139,a136);
  a136=(a014*a139);
  a135=(a135-a136);
  a135=(a135+a001);
  a136=casadi_fmax(a000,a135);
  a138=casadi_sq(a136);
  a146=(a136*a138);
  a146=(a037*a146);
  a007=(a000<=a135);
  a135=(a135<=a000);
  a135=(a135+a007);
  a007=(a007/a135);
  a135=(a012*a005);
  a128=(a014*a140);
  a135=(a135+a128);
  a007=(a007*a135);
  a135=(a001*a007);
  a135=(a146*a135);
  a128=(a001*a136);
  a128=(a013-a128);
  a138=(a138*a007);
  a059=(2.*a136);
  a059=(a059*a007);
  a136=(a136*a059);
  a138=(a138+a136);
  a138=(a037*a138);
  a138=(a128*a138);
  a135=(a135-a138);
  a135=(a140+a135);
  a142=(a012*a142);
  a138=(a014*a139);
  a142=(a142+a138);
  a142=(a142+a001);
  a138=casadi_fmax(a000,a142);
  a136=(a001*a138);
  a136=(a013-a136);
  a059=casadi_sq(a138);
  a007=(a000<=a142);
  a142=(a142<=a000);
  a142=(a142+a007);
  a007=(a007/a142);
  a140=(a014*a140);
  a005=(a012*a005);
  a140=(a140-a005);
  a007=(a007*a140);
  a140=(a059*a007);
  a005=(2.*a138);
  a005=(a005*a007);
  a005=(a138*a005);
  a140=(a140+a005);
  a140=(a037*a140);
  a140=(a136*a140);
  a138=(a138*a059);
  a138=(a037*a138);
  a007=(a001*a007);
  a007=(a138*a007);
  a140=(a140-a007);
  a135=(a135-a140);
  a135=(a120*a135);
  a146=(a146*a128);
  a139=(a139+a146);
  a138=(a138*a136);
  a139=(a139-a138);
  a121=(a139*a121);
  a135=(a135-a121);
  a135=(a021*a135);
  a120=(a120*a139);
  a144=(a120*a144);
  a135=(a135+a144);
  if (res[0]!=0) res[0][7]=a135;
  a144=(a004*a116);
  a144=(a144+a105);
  a144=(a144/a119);
  a105=(a000<=a144);
  a139=(a144<=a000);
  a139=(a139+a105);
  a105=(a105/a139);
  a139=(a116*a122);
  a004=(a004*a115);
  a139=(a139+a004);
  a139=(a139+a104);
  a139=(a139/a119);
  a119=(a144/a119);
  a119=(a119*a118);
  a139=(a139-a119);
  a105=(a105*a139);
  if (res[0]!=0) res[0][8]=a105;
  a139=arg[1]? arg[1][6] : 0;
  a119=arg[2]? arg[2][44] : 0;
  a118=(a139*a119);
  a104=arg[1]? arg[1][7] : 0;
  a118=(a118+a104);
  a104=arg[2]? arg[2][45] : 0;
  a004=(a013-a104);
  a121=(a118*a004);
  a138=cos(a121);
  a136=(a092+a095);
  a146=(a136*a101);
  a128=(a091+a094);
  a128=(a110*a128);
  a146=(a146+a128);
  a146=(a146+a057);
  a128=(a138*a146);
  a136=(a110*a136);
  a136=(a136+a079);
  a140=sin(a121);
  a007=arg[5]? arg[5][6] : 0;
  a119=(a119*a007);
  a059=arg[6]? arg[6][44] : 0;
  a059=(a139*a059);
  a119=(a119+a059);
  a059=arg[5]? arg[5][7] : 0;
  a119=(a119+a059);
  a004=(a004*a119);
  a119=arg[6]? arg[6][45] : 0;
  a118=(a118*a119);
  a004=(a004-a118);
  a140=(a140*a004);
  a140=(a136*a140);
  a128=(a128-a140);
  a140=sin(a121);
  a118=(a140*a056);
  a059=cos(a121);
  a059=(a059*a004);
  a059=(a016*a059);
  a118=(a118+a059);
  a128=(a128-a118);
  a118=cos(a121);
  a059=(a016*a118);
  a005=sin(a121);
  a142=(a136*a005);
  a059=(a059+a142);
  a142=casadi_sq(a059);
  a142=(a142+a062);
  a062=sqrt(a142);
  a008=(a128/a062);
  a138=(a136*a138);
  a140=(a016*a140);
  a138=(a138-a140);
  a140=(a138/a062);
  a145=(a140/a062);
  a033=(2.*a059);
  a118=(a118*a056);
  a106=sin(a121);
  a106=(a106*a004);
  a106=(a016*a106);
  a118=(a118-a106);
  a005=(a005*a146);
  a146=cos(a121);
  a146=(a146*a004);
  a136=(a136*a146);
  a005=(a005+a136);
  a118=(a118+a005);
  a033=(a033*a118);
  a033=(a033+a061);
  a062=(2.*a062);
  a062=(a033/a062);
  a145=(a145*a062);
  a008=(a008-a145);
  a145=casadi_sq(a140);
  a145=(a013+a145);
  a145=(a008/a145);
  if (res[0]!=0) res[0][9]=a145;
  a145=arg[2]? arg[2][50] : 0;
  a062=arg[2]? arg[2][48] : 0;
  a061=arg[2]? arg[2][49] : 0;
  a144=casadi_fmax(a000,a144);
  a005=(a061*a144);
  a062=(a062+a005);
  a005=casadi_fmax(a060,a062);
  a136=(a145*a005);
  a146=arg[2]? arg[2][55] : 0;
  a146=(a146/a136);
  a106=(a146+a050);
  a064=(-a106);
  a096=casadi_sq(a023);
  a010=casadi_sq(a096);
  a002=casadi_sq(a059);
  a022=casadi_sq(a138);
  a002=(a002+a022);
  a022=casadi_sq(a002);
  a010=(a010+a022);
  a010=sqrt(a010);
  a022=sqrt(a010);
  a141=(a059/a022);
  a067=casadi_fmin(a106,a141);
  a043=casadi_fmax(a064,a067);
  a017=(a012*a146);
  a045=(a014*a043);
  a017=(a017-a045);
  a017=(a017+a001);
  a045=casadi_fmax(a000,a017);
  a039=casadi_sq(a045);
  a151=(a045*a039);
  a151=(a037*a151);
  a029=(a001*a045);
  a029=(a013-a029);
  a154=(a151*a029);
  a154=(a043+a154);
  a038=(a012*a146);
  a043=(a014*a043);
  a038=(a038+a043);
  a038=(a038+a001);
  a043=casadi_fmax(a000,a038);
  a066=casadi_sq(a043);
  a124=(a043*a066);
  a124=(a037*a124);
  a153=(a001*a043);
  a153=(a013-a153);
  a125=(a124*a153);
  a154=(a154-a125);
  a125=(a154*a105);
  a143=(a064<=a067);
  a067=(a067<=a064);
  a064=(a067+a143);
  a143=(a143/a064);
  a063=(a106<=a141);
  a106=(a141<=a106);
  a031=(a063+a106);
  a063=(a063/a031);
  a109=arg[6]? arg[6][55] : 0;
  a109=(a109/a136);
  a146=(a146/a136);
  a152=arg[6]? arg[6][50] : 0;
  a005=(a005*a152);
  a152=(a060<=a062);
  a062=(a062<=a060);
  a062=(a062+a152);
  a152=(a152/a062);
  a062=arg[6]? arg[6][48] : 0;
  a060=arg[6]? arg[6][49] : 0;
  a060=(a144*a060);
  a061=(a061*a105);
  a060=(a060+a061);
  a062=(a062+a060);
  a152=(a152*a062);
  a145=(a145*a152);
  a005=(a005+a145);
  a146=(a146*a005);
  a109=(a109-a146);
  a063=(a063*a109);
  a106=(a106/a031);
  a031=(a118/a022);
  a141=(a141/a022);
  a096=(2.*a096);
  a023=(2.*a023);
  a023=(a023*a052);
  a096=(a096*a023);
  a002=(2.*a002);
  a059=(2.*a059);
  a059=(a059*a118);
  a118=(2.*a138);
  a118=(a118*a128);
  a059=(a059+a118);
  a002=(a002*a059);
  a096=(a096+a002);
  a010=(2.*a010);
  a096=(a096/a010);
  a010=(2.*a022);
  a096=(a096/a010);
  a141=(a141*a096);
  a031=(a031-a141);
  a106=(a106*a031);
  a063=(a063+a106);
  a143=(a143*a063);
  a067=(a067/a064);
  a067=(a067*a109);
  a143=(a143-a067);
  a067=(a000<=a017);
  a017=(a017<=a000);
  a017=(a017+a067);
  a067=(a067/a017);
  a017=(a012*a109);
  a064=(a014*a143);
  a017=(a017-a064);
  a067=(a067*a017);
  a039=(a039*a067);
  a017=(2.*a045);
  a017=(a017*a067);
  a045=(a045*a017);
  a039=(a039+a045);
  a039=(a037*a039);
  a029=(a029*a039);
  a067=(a001*a067);
  a151=(a151*a067);
  a029=(a029-a151);
  a029=(a143+a029);
  a151=(a000<=a038);
  a038=(a038<=a000);
  a038=(a038+a151);
  a151=(a151/a038);
  a109=(a012*a109);
  a143=(a014*a143);
  a109=(a109+a143);
  a151=(a151*a109);
  a066=(a066*a151);
  a109=(2.*a043);
  a109=(a109*a151);
  a043=(a043*a109);
  a066=(a066+a043);
  a066=(a037*a066);
  a153=(a153*a066);
  a151=(a001*a151);
  a124=(a124*a151);
  a153=(a153-a124);
  a029=(a029-a153);
  a153=(a144*a029);
  a125=(a125+a153);
  a125=(a136*a125);
  a153=(a144*a154);
  a124=(a153*a005);
  a125=(a125+a124);
  if (res[0]!=0) res[0][10]=a125;
  a104=(a013-a104);
  a124=casadi_sq(a154);
  a124=(a013-a124);
  a124=sqrt(a124);
  a050=(a124+a050);
  a151=(-a050);
  a066=arg[2]? arg[2][54] : 0;
  a043=arg[2]? arg[2][53] : 0;
  a109=arg[2]? arg[2][51] : 0;
  a143=arg[2]? arg[2][52] : 0;
  a038=(a143-a013);
  a067=casadi_fmax(a032,a038);
  a067=sqrt(a067);
  a039=(a109*a067);
  a045=(1./a039);
  a017=(-a045);
  a064=arg[2]? arg[2][46] : 0;
  a063=arg[2]? arg[2][47] : 0;
  a106=(a063*a144);
  a064=(a064+a106);
  a106=casadi_fmax(a000,a064);
  a031=(a106*a140);
  a031=(a031/a136);
  a141=casadi_fmin(a031,a045);
  a010=casadi_fmax(a017,a141);
  a002=(a109*a010);
  a059=atan(a002);
  a118=(a143*a059);
  a118=(a118/a109);
  a023=(a143-a013);
  a052=(a010*a023);
  a052=(a118-a052);
  a146=(a109*a052);
  a145=atan(a146);
  a152=(a043*a145);
  a062=sin(a152);
  a060=(a066*a062);
  a061=casadi_sq(a138);
  a061=(a061+a142);
  a061=sqrt(a061);
  a142=(a060*a061);
  a142=(a142/a022);
  a147=casadi_fmin(a050,a142);
  a137=casadi_fmax(a151,a147);
  a107=(a012*a124);
  a149=(a014*a137);
  a107=(a107-a149);
  a107=(a107+a001);
  a149=casadi_fmax(a000,a107);
  a155=casadi_sq(a149);
  a131=(a149*a155);
  a131=(a037*a131);
  a158=(a001*a149);
  a158=(a013-a158);
  a130=(a131*a158);
  a130=(a137+a130);
  a129=(a012*a124);
  a137=(a014*a137);
  a129=(a129+a137);
  a129=(a129+a001);
  a137=casadi_fmax(a000,a129);
  a127=casadi_sq(a137);
  a134=(a137*a127);
  a134=(a037*a134);
  a156=(a001*a137);
  a156=(a013-a156);
  a157=(a134*a156);
  a130=(a130-a157);
  a157=(a130*a105);
  a053=(a147<=a151);
  a151=(a151<=a147);
  a147=(a053+a151);
  a053=(a053/a147);
  a154=(2.*a154);
  a154=(a154*a029);
  a124=(2.*a124);
  a154=(a154/a124);
  a053=(a053*a154);
  a151=(a151/a147);
  a147=(a142<=a050);
  a050=(a050<=a142);
  a124=(a050+a147);
  a147=(a147/a124);
  a029=arg[6]? arg[6][54] : 0;
  a062=(a062*a029);
  a152=cos(a152);
  a029=arg[6]? arg[6][53] : 0;
  a145=(a145*a029);
  a029=arg[6]? arg[6][51] : 0;
  a052=(a052*a029);
  a133=arg[6]? arg[6][52] : 0;
  a059=(a059*a133);
  a132=(a010*a029);
  a035=(a141<=a017);
  a017=(a017<=a141);
  a141=(a035+a017);
  a035=(a035/a141);
  a039=(a045/a039);
  a068=(a067*a029);
  a159=(a032<=a038);
  a038=(a038<=a032);
  a038=(a038+a159);
  a159=(a159/a038);
  a159=(a159*a133);
  a067=(2.*a067);
  a159=(a159/a067);
  a159=(a109*a159);
  a068=(a068+a159);
  a039=(a039*a068);
  a035=(a035*a039);
  a017=(a017/a141);
  a141=(a031<=a045);
  a045=(a045<=a031);
  a068=(a141+a045);
  a141=(a141/a068);
  a159=(a000<=a064);
  a064=(a064<=a000);
  a064=(a064+a159);
  a159=(a159/a064);
  a064=arg[6]? arg[6][46] : 0;
  a067=arg[6]? arg[6][47] : 0;
  a067=(a144*a067);
  a063=(a063*a105);
  a067=(a067+a063);
  a064=(a064+a067);
  a159=(a159*a064);
  a140=(a140*a159);
  a106=(a106*a008);
  a140=(a140+a106);
  a140=(a140/a136);
  a031=(a031/a136);
  a031=(a031*a005);
  a140=(a140-a031);
  a141=(a141*a140);
  a045=(a045/a068);
  a045=(a045*a039);
  a141=(a141-a045);
  a017=(a017*a141);
  a035=(a035+a017);
  a017=(a109*a035);
  a132=(a132+a017);
  a002=casadi_sq(a002);
  a002=(a013+a002);
  a132=(a132/a002);
  a143=(a143*a132);
  a059=(a059+a143);
  a059=(a059/a109);
  a118=(a118/a109);
  a118=(a118*a029);
  a059=(a059-a118);
  a023=(a023*a035);
  a010=(a010*a133);
  a023=(a023+a010);
  a059=(a059-a023);
  a109=(a109*a059);
  a052=(a052+a109);
  a146=casadi_sq(a146);
  a146=(a013+a146);
  a052=(a052/a146);
  a043=(a043*a052);
  a145=(a145+a043);
  a152=(a152*a145);
  a066=(a066*a152);
  a062=(a062+a066);
  a062=(a061*a062);
  a138=(2.*a138);
  a138=(a138*a128);
  a138=(a138+a033);
  a061=(2.*a061);
  a138=(a138/a061);
  a060=(a060*a138);
  a062=(a062+a060);
  a062=(a062/a022);
  a142=(a142/a022);
  a142=(a142*a096);
  a062=(a062-a142);
  a147=(a147*a062);
  a050=(a050/a124);
  a050=(a050*a154);
  a147=(a147-a050);
  a151=(a151*a147);
  a053=(a053+a151);
  a151=(a000<=a107);
  a107=(a107<=a000);
  a107=(a107+a151);
  a151=(a151/a107);
  a107=(a012*a154);
  a147=(a014*a053);
  a107=(a107+a147);
  a151=(a151*a107);
  a107=(a001*a151);
  a131=(a131*a107);
  a155=(a155*a151);
  a107=(2.*a149);
  a107=(a107*a151);
  a149=(a149*a107);
  a155=(a155+a149);
  a155=(a037*a155);
  a158=(a158*a155);
  a131=(a131-a158);
  a131=(a053+a131);
  a158=(a000<=a129);
  a129=(a129<=a000);
  a129=(a129+a158);
  a158=(a158/a129);
  a014=(a014*a053);
  a012=(a012*a154);
  a014=(a014-a012);
  a158=(a158*a014);
  a127=(a127*a158);
  a014=(2.*a137);
  a014=(a014*a158);
  a137=(a137*a014);
  a127=(a127+a137);
  a037=(a037*a127);
  a156=(a156*a037);
  a158=(a001*a158);
  a134=(a134*a158);
  a156=(a156-a134);
  a131=(a131-a156);
  a131=(a144*a131);
  a157=(a157+a131);
  a157=(a136*a157);
  a144=(a144*a130);
  a005=(a144*a005);
  a157=(a157+a005);
  a157=(a104*a157);
  a144=(a144*a136);
  a119=(a144*a119);
  a157=(a157-a119);
  if (res[0]!=0) res[0][11]=a157;
  if (res[0]!=0) res[0][12]=a126;
  a119=casadi_sq(a083);
  a119=(a119+a078);
  a078=(a089/a119);
  a078=(a078*a082);
  a119=(a083/a119);
  a119=(a119*a072);
  a078=(a078-a119);
  if (res[0]!=0) res[0][13]=a078;
  if (res[0]!=0) res[0][14]=a070;
  if (res[0]!=0) res[0][15]=a074;
  a074=arg[6]? arg[6][23] : 0;
  a119=arg[2]? arg[2][24] : 0;
  a082=(2.*a071);
  a082=(a082*a070);
  a082=(a119*a082);
  a071=casadi_sq(a071);
  a070=arg[6]? arg[6][24] : 0;
  a070=(a071*a070);
  a082=(a082+a070);
  a074=(a074+a082);
  a074=(a086*a074);
  a082=arg[2]? arg[2][23] : 0;
  a071=(a071*a119);
  a082=(a082+a071);
  a071=(a082*a069);
  a074=(a074+a071);
  if (res[0]!=0) res[0][16]=a074;
  a071=2.5000000000000000e-01;
  a075=(a071*a075);
  a084=sqrt(a084);
  a119=(a075*a084);
  a070=(a119*a110);
  a005=(a070*a030);
  a130=arg[2]? arg[2][60] : 0;
  a131=arg[6]? arg[6][58] : 0;
  a131=(a130*a131);
  a156=arg[2]? arg[2][58] : 0;
  a134=arg[6]? arg[6][60] : 0;
  a158=(a156*a134);
  a131=(a131+a158);
  a131=(a005*a131);
  a156=(a156*a130);
  a071=(a071*a073);
  a071=(a084*a071);
  a084=(2.*a084);
  a026=(a026/a084);
  a075=(a075*a026);
  a071=(a071+a075);
  a071=(a110*a071);
  a119=(a119*a101);
  a071=(a071+a119);
  a071=(a030*a071);
  a070=(a070*a049);
  a071=(a071+a070);
  a070=(a156*a071);
  a131=(a131+a070);
  a070=arg[2]? arg[2][57] : 0;
  a083=atan2(a083,a089);
  a119=(a070*a083);
  a075=arg[2]? arg[2][59] : 0;
  a026=arg[1]? arg[1][8] : 0;
  a084=arg[2]? arg[2][56] : 0;
  a073=(a139*a084);
  a026=(a026-a073);
  a073=(a075*a026);
  a119=(a119+a073);
  a073=(a119*a069);
  a158=arg[6]? arg[6][57] : 0;
  a158=(a083*a158);
  a070=(a070*a078);
  a158=(a158+a070);
  a070=arg[6]? arg[6][59] : 0;
  a070=(a026*a070);
  a037=arg[5]? arg[5][8] : 0;
  a084=(a084*a007);
  a007=arg[6]? arg[6][56] : 0;
  a139=(a139*a007);
  a084=(a084+a139);
  a037=(a037-a084);
  a075=(a075*a037);
  a070=(a070+a075);
  a158=(a158+a070);
  a158=(a086*a158);
  a073=(a073+a158);
  a131=(a131+a073);
  if (res[0]!=0) res[0][17]=a131;
  a073=casadi_sq(a130);
  a158=(a073*a005);
  a070=arg[6]? arg[6][63] : 0;
  a070=(a158*a070);
  a075=arg[2]? arg[2][63] : 0;
  a084=(2.*a130);
  a084=(a084*a134);
  a084=(a005*a084);
  a073=(a073*a071);
  a084=(a084+a073);
  a075=(a075*a084);
  a070=(a070+a075);
  a075=arg[2]? arg[2][61] : 0;
  a073=arg[1]? arg[1][9] : 0;
  a071=(a075*a073);
  a139=arg[2]? arg[2][62] : 0;
  a007=(a139*a083);
  a071=(a071+a007);
  a007=(a086*a134);
  a127=(a130*a069);
  a007=(a007+a127);
  a071=(a071*a007);
  a007=(a130*a086);
  a127=arg[6]? arg[6][61] : 0;
  a127=(a073*a127);
  a137=arg[5]? arg[5][9] : 0;
  a075=(a075*a137);
  a127=(a127+a075);
  a075=arg[6]? arg[6][62] : 0;
  a075=(a083*a075);
  a139=(a139*a078);
  a075=(a075+a139);
  a127=(a127+a075);
  a007=(a007*a127);
  a071=(a071+a007);
  a070=(a070+a071);
  if (res[0]!=0) res[0][18]=a070;
  if (res[0]!=0) res[0][19]=a108;
  a108=arg[6]? arg[6][66] : 0;
  a158=(a158*a108);
  a108=arg[2]? arg[2][66] : 0;
  a108=(a108*a084);
  a158=(a158+a108);
  a108=arg[2]? arg[2][64] : 0;
  a084=(a108*a073);
  a071=arg[2]? arg[2][65] : 0;
  a007=(a071*a083);
  a084=(a084+a007);
  a007=arg[2]? arg[2][67] : 0;
  a127=(a007*a026);
  a084=(a084+a127);
  a134=(a086*a134);
  a069=(a130*a069);
  a134=(a134+a069);
  a084=(a084*a134);
  a130=(a130*a086);
  a134=arg[6]? arg[6][64] : 0;
  a073=(a073*a134);
  a108=(a108*a137);
  a073=(a073+a108);
  a108=arg[6]? arg[6][65] : 0;
  a083=(a083*a108);
  a071=(a071*a078);
  a083=(a083+a071);
  a073=(a073+a083);
  a083=arg[6]? arg[6][67] : 0;
  a083=(a026*a083);
  a007=(a007*a037);
  a083=(a083+a007);
  a073=(a073+a083);
  a130=(a130*a073);
  a084=(a084+a130);
  a158=(a158+a084);
  if (res[0]!=0) res[0][20]=a158;
  a020=(a016-a020);
  a084=casadi_sq(a020);
  a084=(a084+a025);
  a084=sqrt(a084);
  a025=(a020*a084);
  a130=(a001*a025);
  a130=(a130+a034);
  a034=(2.*a034);
  a025=(a025+a034);
  a034=casadi_sq(a025);
  a034=(a034+a036);
  a034=sqrt(a034);
  a036=(a001*a034);
  a130=(a130+a036);
  a036=sqrt(a130);
  a073=arg[2]? arg[2][69] : 0;
  a083=sin(a015);
  a007=(a073*a083);
  a071=arg[2]? arg[2][68] : 0;
  a078=cos(a015);
  a108=(a071*a078);
  a007=(a007-a108);
  a137=(a110*a007);
  a137=(a137+a079);
  a137=(a137-a081);
  a081=casadi_sq(a137);
  a081=(a081+a130);
  a134=(a036/a081);
  a101=(a007*a101);
  a069=arg[6]? arg[6][69] : 0;
  a083=(a083*a069);
  a127=cos(a015);
  a127=(a127*a126);
  a127=(a073*a127);
  a083=(a083+a127);
  a127=arg[6]? arg[6][68] : 0;
  a078=(a078*a127);
  a075=sin(a015);
  a075=(a075*a126);
  a075=(a071*a075);
  a078=(a078-a075);
  a083=(a083-a078);
  a110=(a110*a083);
  a101=(a101+a110);
  a101=(a101+a057);
  a101=(a101-a080);
  a134=(a134*a101);
  a081=(a137/a081);
  a019=(a056-a019);
  a080=(a084*a019);
  a110=(2.*a020);
  a110=(a110*a019);
  a084=(2.*a084);
  a110=(a110/a084);
  a020=(a020*a110);
  a080=(a080+a020);
  a020=(a001*a080);
  a020=(a020+a024);
  a025=(2.*a025);
  a024=(2.*a024);
  a080=(a080+a024);
  a025=(a025*a080);
  a034=(2.*a034);
  a025=(a025/a034);
  a025=(a001*a025);
  a020=(a020+a025);
  a025=(2.*a036);
  a025=(a020/a025);
  a081=(a081*a025);
  a134=(a134-a081);
  if (res[0]!=0) res[0][21]=a134;
  a081=arg[2]? arg[2][70] : 0;
  a006=(a081+a006);
  a025=(-a006);
  a034=arg[2]? arg[2][71] : 0;
  a036=atan2(a137,a036);
  a080=arg[2]? arg[2][72] : 0;
  a024=(a026*a080);
  a036=(a036-a024);
  a024=(a034*a036);
  a110=casadi_fmin(a006,a024);
  a084=(a025<=a110);
  a019=(a110<=a025);
  a075=(a019+a084);
  a084=(a084/a075);
  a139=(a006<=a024);
  a024=(a024<=a006);
  a006=(a139+a024);
  a139=(a139/a006);
  a014=arg[6]? arg[6][70] : 0;
  a139=(a139*a014);
  a024=(a024/a006);
  a006=arg[6]? arg[6][71] : 0;
  a036=(a036*a006);
  a080=(a080*a037);
  a037=arg[6]? arg[6][72] : 0;
  a026=(a026*a037);
  a080=(a080+a026);
  a134=(a134-a080);
  a034=(a034*a134);
  a036=(a036+a034);
  a024=(a024*a036);
  a139=(a139+a024);
  a084=(a084*a139);
  a019=(a019/a075);
  a019=(a019*a014);
  a084=(a084-a019);
  a019=(a042*a081);
  a025=casadi_fmax(a025,a110);
  a110=(a044*a025);
  a019=(a019-a110);
  a019=(a019+a001);
  a110=casadi_fmax(a000,a019);
  a075=(a001*a110);
  a075=(a013-a075);
  a139=casadi_sq(a110);
  a024=(a000<=a019);
  a019=(a019<=a000);
  a019=(a019+a024);
  a024=(a024/a019);
  a019=(a042*a014);
  a036=(a044*a084);
  a019=(a019-a036);
  a024=(a024*a019);
  a019=(a139*a024);
  a036=(2.*a110);
  a036=(a036*a024);
  a036=(a110*a036);
  a019=(a019+a036);
  a019=(a041*a019);
  a019=(a075*a019);
  a110=(a110*a139);
  a110=(a041*a110);
  a024=(a001*a024);
  a024=(a110*a024);
  a019=(a019-a024);
  a019=(a084+a019);
  a081=(a042*a081);
  a024=(a044*a025);
  a081=(a081+a024);
  a081=(a081+a001);
  a024=casadi_fmax(a000,a081);
  a139=(a001*a024);
  a013=(a013-a139);
  a139=casadi_sq(a024);
  a036=(a000<=a081);
  a081=(a081<=a000);
  a081=(a081+a036);
  a036=(a036/a081);
  a042=(a042*a014);
  a044=(a044*a084);
  a042=(a042+a044);
  a036=(a036*a042);
  a042=(a139*a036);
  a044=(2.*a024);
  a044=(a044*a036);
  a044=(a024*a044);
  a042=(a042+a044);
  a042=(a041*a042);
  a042=(a013*a042);
  a024=(a024*a139);
  a041=(a041*a024);
  a036=(a001*a036);
  a036=(a041*a036);
  a042=(a042-a036);
  a019=(a019-a042);
  if (res[0]!=0) res[0][22]=a019;
  a042=casadi_sq(a137);
  a130=(a130+a042);
  a042=arg[2]? arg[2][74] : 0;
  a110=(a110*a075);
  a025=(a025+a110);
  a041=(a041*a013);
  a025=(a025-a041);
  a041=arg[6]? arg[6][73] : 0;
  a041=(a001*a041);
  a041=(a025*a041);
  a013=arg[2]? arg[2][73] : 0;
  a013=(a001*a013);
  a019=(a013*a019);
  a041=(a041+a019);
  a041=(a042*a041);
  a013=(a013*a025);
  a025=arg[6]? arg[6][74] : 0;
  a025=(a013*a025);
  a041=(a041+a025);
  a041=(a030*a041);
  a013=(a013*a042);
  a049=(a013*a049);
  a041=(a041+a049);
  a041=(a130*a041);
  a013=(a013*a030);
  a137=(2.*a137);
  a137=(a137*a101);
  a020=(a020+a137);
  a020=(a013*a020);
  a041=(a041+a020);
  if (res[0]!=0) res[0][23]=a041;
  if (res[0]!=0) res[0][24]=a011;
  if (res[0]!=0) res[0][25]=a048;
  if (res[0]!=0) res[0][26]=a027;
  a048=sin(a018);
  a011=(a016*a048);
  a020=cos(a018);
  a137=(a079*a020);
  a011=(a011+a137);
  a137=(2.*a011);
  a048=(a048*a056);
  a101=cos(a018);
  a101=(a101*a054);
  a101=(a016*a101);
  a048=(a048+a101);
  a020=(a020*a057);
  a101=sin(a018);
  a101=(a101*a054);
  a101=(a079*a101);
  a020=(a020-a101);
  a048=(a048+a020);
  a137=(a137*a048);
  a048=cos(a018);
  a020=(a016*a048);
  a101=sin(a018);
  a030=(a079*a101);
  a020=(a020-a030);
  a030=(2.*a020);
  a048=(a048*a056);
  a056=sin(a018);
  a056=(a056*a054);
  a016=(a016*a056);
  a048=(a048-a016);
  a101=(a101*a057);
  a057=cos(a018);
  a057=(a057*a054);
  a079=(a079*a057);
  a101=(a101+a079);
  a048=(a048-a101);
  a030=(a030*a048);
  a137=(a137+a030);
  a011=casadi_sq(a011);
  a020=casadi_sq(a020);
  a011=(a011+a020);
  a011=(a011+a032);
  a011=sqrt(a011);
  a011=(2.*a011);
  a137=(a137/a011);
  if (res[0]!=0) res[0][27]=a137;
  a011=sin(a121);
  a032=(a011*a157);
  a144=(a144*a104);
  a104=cos(a121);
  a104=(a104*a004);
  a104=(a144*a104);
  a032=(a032+a104);
  a032=(a032+a051);
  a051=cos(a121);
  a104=(a051*a125);
  a153=(a153*a136);
  a136=sin(a121);
  a136=(a136*a004);
  a136=(a153*a136);
  a104=(a104-a136);
  a032=(a032-a104);
  a136=cos(a097);
  a020=(a136*a040);
  a046=(a046*a047);
  a030=sin(a097);
  a030=(a030*a098);
  a030=(a046*a030);
  a020=(a020-a030);
  a030=sin(a097);
  a048=(a030*a150);
  a148=(a148*a047);
  a047=cos(a097);
  a047=(a047*a098);
  a047=(a148*a047);
  a048=(a048+a047);
  a048=(a020-a048);
  a032=(a032-a048);
  a047=cos(a097);
  a101=(a047*a009);
  a076=(a076*a021);
  a079=sin(a097);
  a079=(a079*a098);
  a079=(a076*a079);
  a101=(a101-a079);
  a032=(a032-a101);
  a079=sin(a097);
  a057=(a079*a135);
  a120=(a120*a021);
  a021=cos(a097);
  a021=(a021*a098);
  a021=(a120*a021);
  a057=(a057+a021);
  a032=(a032-a057);
  a074=(a077*a074);
  a082=(a082*a086);
  a065=(a082*a065);
  a074=(a074+a065);
  a074=(a074/a089);
  a082=(a082*a077);
  a082=(a082/a089);
  a089=(a082/a089);
  a089=(a089*a072);
  a074=(a074-a089);
  a032=(a032-a074);
  if (res[0]!=0) res[0][28]=a032;
  a074=arg[5]? arg[5][10] : 0;
  a089=(a074-a041);
  a072=sin(a097);
  a077=(a072*a009);
  a065=cos(a097);
  a065=(a065*a098);
  a065=(a076*a065);
  a077=(a077+a065);
  a089=(a089+a077);
  a089=(a089+a131);
  a131=cos(a097);
  a077=(a131*a135);
  a065=sin(a097);
  a065=(a065*a098);
  a065=(a120*a065);
  a077=(a077-a065);
  a089=(a089-a077);
  a065=sin(a097);
  a021=(a065*a040);
  a016=cos(a097);
  a016=(a016*a098);
  a016=(a046*a016);
  a021=(a021+a016);
  a089=(a089-a021);
  a016=cos(a097);
  a056=(a016*a150);
  a049=sin(a097);
  a049=(a049*a098);
  a049=(a148*a049);
  a056=(a056-a049);
  a089=(a089-a056);
  a049=sin(a121);
  a042=(a049*a125);
  a025=cos(a121);
  a025=(a025*a004);
  a025=(a153*a025);
  a042=(a042+a025);
  a089=(a089-a042);
  a025=cos(a121);
  a019=(a025*a157);
  a110=sin(a121);
  a110=(a110*a004);
  a110=(a144*a110);
  a019=(a019-a110);
  a089=(a089-a019);
  if (res[0]!=0) res[0][29]=a089;
  a007=(a007*a041);
  a013=(a013*a130);
  a083=(a013*a083);
  a007=(a007+a083);
  a108=(a108*a074);
  a083=arg[1]? arg[1][10] : 0;
  a078=(a083*a078);
  a108=(a108+a078);
  a007=(a007+a108);
  a158=(a158-a007);
  a136=(a046*a136);
  a030=(a148*a030);
  a030=(a136-a030);
  a007=(a001*a055);
  a007=(a030*a007);
  a108=(a001*a087);
  a108=(a108*a048);
  a007=(a007+a108);
  a158=(a158-a007);
  a047=(a076*a047);
  a079=(a120*a079);
  a007=(a047+a079);
  a055=(a001*a055);
  a007=(a007*a055);
  a001=(a001*a087);
  a087=(a101+a057);
  a001=(a001*a087);
  a007=(a007+a001);
  a158=(a158+a007);
  a007=sin(a097);
  a001=(a076*a007);
  a131=(a120*a131);
  a087=(a001-a131);
  a087=(a087*a115);
  a007=(a007*a009);
  a055=cos(a097);
  a055=(a055*a098);
  a055=(a076*a055);
  a007=(a007+a055);
  a055=(a007-a077);
  a055=(a116*a055);
  a087=(a087+a055);
  a158=(a158+a087);
  a065=(a046*a065);
  a016=(a148*a016);
  a087=(a065+a016);
  a087=(a087*a115);
  a115=(a021+a056);
  a116=(a116*a115);
  a087=(a087+a116);
  a158=(a158-a087);
  a092=(a092+a095);
  a095=(a042+a019);
  a092=(a092*a095);
  a049=(a153*a049);
  a025=(a144*a025);
  a095=(a049+a025);
  a091=(a091+a094);
  a095=(a095*a091);
  a092=(a092+a095);
  a158=(a158-a092);
  if (res[0]!=0) res[0][30]=a158;
  a032=(a032/a003);
  a011=(a144*a011);
  a011=(a011+a028);
  a051=(a153*a051);
  a011=(a011-a051);
  a011=(a011-a030);
  a011=(a011-a047);
  a011=(a011-a079);
  a011=(a011-a082);
  a011=(a011/a003);
  a011=(a011/a003);
  a011=(a011*a123);
  a032=(a032-a011);
  if (res[0]!=0) res[0][31]=a032;
  a089=(a089/a003);
  a032=(a083-a013);
  a072=(a076*a072);
  a032=(a032+a072);
  a156=(a156*a005);
  a086=(a086*a119);
  a156=(a156+a086);
  a032=(a032+a156);
  a032=(a032-a131);
  a032=(a032-a065);
  a032=(a032-a016);
  a032=(a032-a049);
  a032=(a032-a025);
  a032=(a032/a003);
  a032=(a032/a003);
  a032=(a032*a123);
  a089=(a089-a032);
  if (res[0]!=0) res[0][32]=a089;
  if (res[0]!=0) res[0][33]=a122;
  a122=sin(a015);
  a074=(a071*a074);
  a089=(a083*a127);
  a074=(a074+a089);
  a122=(a122*a074);
  a083=(a083*a071);
  a074=cos(a015);
  a074=(a074*a126);
  a083=(a083*a074);
  a122=(a122+a083);
  a083=sin(a015);
  a074=(a071*a041);
  a127=(a013*a127);
  a074=(a074+a127);
  a083=(a083*a074);
  a071=(a013*a071);
  a074=cos(a015);
  a074=(a074*a126);
  a071=(a071*a074);
  a083=(a083+a071);
  a071=cos(a015);
  a041=(a073*a041);
  a069=(a013*a069);
  a041=(a041+a069);
  a071=(a071*a041);
  a013=(a013*a073);
  a073=sin(a015);
  a073=(a073*a126);
  a013=(a013*a073);
  a071=(a071-a013);
  a083=(a083+a071);
  a122=(a122-a083);
  a083=sin(a097);
  a071=sin(a015);
  a013=(a111*a040);
  a073=(a046*a113);
  a013=(a013+a073);
  a013=(a071*a013);
  a073=(a046*a111);
  a041=cos(a015);
  a041=(a041*a126);
  a041=(a073*a041);
  a013=(a013+a041);
  a083=(a083*a013);
  a073=(a073*a071);
  a071=cos(a097);
  a071=(a071*a098);
  a073=(a073*a071);
  a083=(a083+a073);
  a122=(a122+a083);
  a083=cos(a015);
  a073=sin(a097);
  a071=(a117*a009);
  a013=(a076*a112);
  a071=(a071+a013);
  a071=(a073*a071);
  a013=(a076*a117);
  a041=cos(a097);
  a041=(a041*a098);
  a041=(a013*a041);
  a071=(a071+a041);
  a083=(a083*a071);
  a013=(a013*a073);
  a073=sin(a015);
  a073=(a073*a126);
  a013=(a013*a073);
  a083=(a083-a013);
  a122=(a122+a083);
  a083=sin(a015);
  a013=sin(a121);
  a073=(a090*a125);
  a071=(a153*a085);
  a073=(a073+a071);
  a073=(a013*a073);
  a071=(a153*a090);
  a041=cos(a121);
  a041=(a041*a004);
  a041=(a071*a041);
  a073=(a073+a041);
  a083=(a083*a073);
  a071=(a071*a013);
  a013=cos(a015);
  a013=(a013*a126);
  a071=(a071*a013);
  a083=(a083+a071);
  a122=(a122+a083);
  a083=cos(a097);
  a071=sin(a015);
  a013=(a111*a150);
  a073=(a148*a113);
  a013=(a013+a073);
  a013=(a071*a013);
  a073=(a148*a111);
  a041=cos(a015);
  a041=(a041*a126);
  a041=(a073*a041);
  a013=(a013+a041);
  a083=(a083*a013);
  a073=(a073*a071);
  a071=sin(a097);
  a071=(a071*a098);
  a073=(a073*a071);
  a083=(a083-a073);
  a122=(a122+a083);
  a083=cos(a097);
  a073=sin(a015);
  a071=(a111*a135);
  a013=(a120*a113);
  a071=(a071+a013);
  a071=(a073*a071);
  a013=(a120*a111);
  a041=cos(a015);
  a041=(a041*a126);
  a041=(a013*a041);
  a071=(a071+a041);
  a083=(a083*a071);
  a013=(a013*a073);
  a073=sin(a097);
  a073=(a073*a098);
  a013=(a013*a073);
  a083=(a083-a013);
  a122=(a122+a083);
  a083=cos(a121);
  a013=sin(a015);
  a073=(a090*a157);
  a071=(a144*a085);
  a073=(a073+a071);
  a073=(a013*a073);
  a071=(a144*a090);
  a041=cos(a015);
  a041=(a041*a126);
  a041=(a071*a041);
  a073=(a073+a041);
  a083=(a083*a073);
  a071=(a071*a013);
  a013=sin(a121);
  a013=(a013*a004);
  a071=(a071*a013);
  a083=(a083-a071);
  a122=(a122+a083);
  a122=(a122-a070);
  a070=cos(a015);
  a083=(a117*a070);
  a077=(a083*a077);
  a070=(a070*a112);
  a071=sin(a015);
  a071=(a071*a126);
  a071=(a117*a071);
  a070=(a070-a071);
  a131=(a131*a070);
  a077=(a077+a131);
  a122=(a122-a077);
  a021=(a083*a021);
  a065=(a065*a070);
  a021=(a021+a065);
  a122=(a122-a021);
  a056=(a083*a056);
  a016=(a016*a070);
  a056=(a056+a016);
  a122=(a122-a056);
  a056=cos(a015);
  a016=(a093*a056);
  a042=(a016*a042);
  a056=(a056*a088);
  a021=sin(a015);
  a021=(a021*a126);
  a021=(a093*a021);
  a056=(a056-a021);
  a049=(a049*a056);
  a042=(a042+a049);
  a122=(a122-a042);
  a019=(a016*a019);
  a025=(a025*a056);
  a019=(a019+a025);
  a122=(a122-a019);
  a019=sin(a015);
  a025=(a111*a019);
  a007=(a025*a007);
  a019=(a019*a113);
  a042=cos(a015);
  a042=(a042*a126);
  a042=(a111*a042);
  a019=(a019+a042);
  a001=(a001*a019);
  a007=(a007+a001);
  a122=(a122-a007);
  if (res[0]!=0) res[0][34]=a122;
  a122=cos(a097);
  a007=cos(a015);
  a040=(a117*a040);
  a001=(a046*a112);
  a040=(a040+a001);
  a040=(a007*a040);
  a046=(a046*a117);
  a001=sin(a015);
  a001=(a001*a126);
  a001=(a046*a001);
  a040=(a040-a001);
  a122=(a122*a040);
  a046=(a046*a007);
  a007=sin(a097);
  a007=(a007*a098);
  a046=(a046*a007);
  a122=(a122-a046);
  a100=(a100*a027);
  a099=(a058*a099);
  a100=(a100+a099);
  a103=(a103*a027);
  a058=(a058*a102);
  a103=(a103+a058);
  a100=(a100+a103);
  a122=(a122-a100);
  a100=cos(a097);
  a103=cos(a015);
  a009=(a117*a009);
  a058=(a076*a112);
  a009=(a009+a058);
  a009=(a103*a009);
  a076=(a076*a117);
  a058=sin(a015);
  a058=(a058*a126);
  a058=(a076*a058);
  a009=(a009-a058);
  a100=(a100*a009);
  a076=(a076*a103);
  a103=sin(a097);
  a103=(a103*a098);
  a076=(a076*a103);
  a100=(a100-a076);
  a122=(a122+a100);
  a100=cos(a015);
  a076=cos(a121);
  a125=(a093*a125);
  a088=(a153*a088);
  a125=(a125+a088);
  a125=(a076*a125);
  a153=(a153*a093);
  a093=sin(a121);
  a093=(a093*a004);
  a093=(a153*a093);
  a125=(a125-a093);
  a100=(a100*a125);
  a153=(a153*a076);
  a076=sin(a015);
  a076=(a076*a126);
  a153=(a153*a076);
  a100=(a100-a153);
  a122=(a122+a100);
  a100=sin(a097);
  a153=sin(a015);
  a076=(a111*a150);
  a113=(a148*a113);
  a076=(a076+a113);
  a076=(a153*a076);
  a111=(a148*a111);
  a113=cos(a015);
  a113=(a113*a126);
  a113=(a111*a113);
  a076=(a076+a113);
  a100=(a100*a076);
  a111=(a111*a153);
  a153=cos(a097);
  a153=(a153*a098);
  a111=(a111*a153);
  a100=(a100+a111);
  a122=(a122+a100);
  a100=sin(a097);
  a150=(a083*a150);
  a070=(a148*a070);
  a150=(a150+a070);
  a100=(a100*a150);
  a148=(a148*a083);
  a083=cos(a097);
  a083=(a083*a098);
  a148=(a148*a083);
  a100=(a100+a148);
  a122=(a122-a100);
  a100=cos(a015);
  a148=sin(a097);
  a135=(a117*a135);
  a112=(a120*a112);
  a135=(a135+a112);
  a135=(a148*a135);
  a120=(a120*a117);
  a097=cos(a097);
  a097=(a097*a098);
  a097=(a120*a097);
  a135=(a135+a097);
  a100=(a100*a135);
  a120=(a120*a148);
  a148=sin(a015);
  a148=(a148*a126);
  a120=(a120*a148);
  a100=(a100-a120);
  a122=(a122+a100);
  a100=sin(a015);
  a120=sin(a121);
  a148=(a090*a157);
  a135=(a144*a085);
  a148=(a148+a135);
  a148=(a120*a148);
  a135=(a144*a090);
  a097=cos(a121);
  a097=(a097*a004);
  a097=(a135*a097);
  a148=(a148+a097);
  a100=(a100*a148);
  a135=(a135*a120);
  a120=cos(a015);
  a120=(a120*a126);
  a135=(a135*a120);
  a100=(a100+a135);
  a122=(a122+a100);
  a100=sin(a121);
  a157=(a016*a157);
  a056=(a144*a056);
  a157=(a157+a056);
  a100=(a100*a157);
  a144=(a144*a016);
  a121=cos(a121);
  a121=(a121*a004);
  a144=(a144*a121);
  a100=(a100+a144);
  a122=(a122-a100);
  a100=sin(a015);
  a085=(a051*a085);
  a104=(a090*a104);
  a085=(a085+a104);
  a100=(a100*a085);
  a090=(a090*a051);
  a015=cos(a015);
  a015=(a015*a126);
  a090=(a090*a015);
  a100=(a100+a090);
  a122=(a122-a100);
  a020=(a025*a020);
  a136=(a136*a019);
  a020=(a020+a136);
  a122=(a122-a020);
  a101=(a025*a101);
  a047=(a047*a019);
  a101=(a101+a047);
  a122=(a122-a101);
  a025=(a025*a057);
  a079=(a079*a019);
  a025=(a025+a079);
  a122=(a122-a025);
  a122=(a122-a114);
  if (res[0]!=0) res[0][35]=a122;
  a122=arg[6]? arg[6][75] : 0;
  a137=(a137-a122);
  if (res[0]!=0) res[0][36]=a137;
  a137=-5.0000000000000000e-01;
  a122=arg[6]? arg[6][76] : 0;
  a137=(a137*a122);
  a122=arg[0]? arg[0][4] : 0;
  a122=casadi_sign(a122);
  a114=arg[4]? arg[4][4] : 0;
  a122=(a122*a114);
  a137=(a137+a122);
  if (res[0]!=0) res[0][37]=a137;
  a018=casadi_sign(a018);
  a018=(a018*a054);
  a054=arg[6]? arg[6][77] : 0;
  a018=(a018-a054);
  if (res[0]!=0) res[0][38]=a018;
  return 0;
}

CASADI_SYMBOL_EXPORT int fwd1_rollout_outputs(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f5(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int fwd1_rollout_outputs_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void fwd1_rollout_outputs_release(int mem) {
}

CASADI_SYMBOL_EXPORT void fwd1_rollout_outputs_incref(void) {
}

CASADI_SYMBOL_EXPORT void fwd1_rollout_outputs_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int fwd1_rollout_outputs_n_in(void) { return 7;}

CASADI_SYMBOL_EXPORT casadi_int fwd1_rollout_outputs_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real fwd1_rollout_outputs_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* fwd1_rollout_outputs_name_in(casadi_int i) {
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

CASADI_SYMBOL_EXPORT const char* fwd1_rollout_outputs_name_out(casadi_int i) {
  switch (i) {
    case 0: return "fwd_y";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* fwd1_rollout_outputs_sparsity_in(casadi_int i) {
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

CASADI_SYMBOL_EXPORT const casadi_int* fwd1_rollout_outputs_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int fwd1_rollout_outputs_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 7;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int fwd1_rollout_outputs_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 7*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* adj1_rollout_outputs:(x[6],u[11],p[79],out_y[39x1,0nz],adj_y[39])->(adj_x[6],adj_u[11],adj_p[79]) */
static int casadi_f6(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
  casadi_real a204, a205, a206, a207, a208, a209, a210, a211, a212, a213, a214, a215;
  casadi_real a216, a217, a218, a219, a220, a221, a222, a223, a224, a225, a226, a227;
  casadi_real a228, a229, a230, a231, a232, a233, a234, a235, a236, a237, a238, a239;
  casadi_real a240, a241, a242, a243, a244, a245, a246, a247, a248, a249, a250, a251;
  casadi_real a252, a253, a254, a255, a256, a257, a258, a259, a260, a261, a262, a263;
  casadi_real a264, a265, a266, a267, a268, a269, a270, a271, a272, a273, a274, a275;
  casadi_real a276, a277, a278, a279, a280, a281, a282, a283, a284, a285, a286, a287;
  casadi_real a288, a289, a290, a291, a292, a293, a294, a295, a296, a297, a298, a299;
  casadi_real a300, a301, a302, a303, a304, a305, a306, a307, a308, a309, a310, a311;
  casadi_real a312, a313, a314, a315, a316, a317, a318, a319, a320, a321, a322, a323;
  casadi_real a324, a325, a326, a327, a328, a329, a330, a331, a332, a333, a334, a335;
  casadi_real a336, a337, a338, a339, a340, a341, a342, a343, a344, a345, a346, a347;
  casadi_real a348, a349, a350, a351, a352, a353, a354, a355, a356, a357, a358, a359;
  casadi_real a360, a361, a362, a363, a364, a365, a366, a367, a368, a369, a370, a371;
  casadi_real a372, a373, a374, a375, a376, a377, a378, a379, a380, a381, a382, a383;
  casadi_real a384, a385, a386, a387, a388, a389, a390, a391, a392, a393, a394, a395;
  casadi_real a396, a397, a398, a399, a400, a401, a402, a403, a404, a405, a406, a407;
  casadi_real a408, a409, a410, a411, a412, a413, a414, a415, a416, a417, a418, a419;
  casadi_real a420, a421, a422, a423, a424, a425, a426, a427, a428, a429, a430, a431;
  casadi_real a432, a433, a434, a435, a436, a437, a438, a439, a440, a441, a442, a443;
  casadi_real a444, a445, a446, a447, a448, a449, a450, a451, a452, a453, a454, a455;
  casadi_real a456, a457, a458, a459, a460;
  a000=arg[0]? arg[0][5] : 0;
  a001=cos(a000);
  a002=arg[0]? arg[0][0] : 0;
  a003=(a002*a001);
  a004=arg[0]? arg[0][1] : 0;
  a005=sin(a000);
  a006=(a004*a005);
  a003=(a003-a006);
  a006=(2.*a003);
  a007=arg[4]? arg[4][36] : 0;
  a008=arg[4]? arg[4][27] : 0;
  a008=(a007+a008);
  a009=sin(a000);
  a010=(a002*a009);
  a011=cos(a000);
  a012=(a004*a011);
  a010=(a010+a012);
  a012=casadi_sq(a010);
  a003=casadi_sq(a003);
  a012=(a012+a003);
  a003=9.9999999999999998e-13;
  a012=(a012+a003);
  a012=sqrt(a012);
  a012=(2.*a012);
  a008=(a008/a012);
  a006=(a006*a008);
  a001=(a001*a006);
  a010=(2.*a010);
  a010=(a010*a008);
  a009=(a009*a010);
  a001=(a001+a009);
  a009=arg[1]? arg[1][0] : 0;
  a008=cos(a000);
  a012=(a009*a008);
  a013=arg[1]? arg[1][1] : 0;
  a014=sin(a000);
  a015=(a013*a014);
  a012=(a012+a015);
  a015=(a002-a012);
  a016=casadi_sq(a015);
  a017=1.0000000000000000e-04;
  a016=(a016+a017);
  a016=sqrt(a016);
  a018=(a015*a016);
  a019=arg[1]? arg[1][2] : 0;
  a020=arg[2]? arg[2][6] : 0;
  a021=arg[2]? arg[2][7] : 0;
  a022=casadi_sq(a021);
  a022=(a022+a003);
  a022=sqrt(a022);
  a023=(a020*a022);
  a024=(a019/a023);
  a025=(2.*a024);
  a025=(a018+a025);
  a026=(2.*a025);
  a027=5.0000000000000000e-01;
  a028=arg[2]? arg[2][73] : 0;
  a028=(a027*a028);
  a029=arg[2]? arg[2][70] : 0;
  a030=1.0000000000000001e-01;
  a031=(a029+a030);
  a032=(-a031);
  a033=arg[2]? arg[2][71] : 0;
  a034=arg[0]? arg[0][2] : 0;
  a035=arg[2]? arg[2][69] : 0;
  a036=arg[2]? arg[2][1] : 0;
  a037=sin(a036);
  a038=(a035*a037);
  a039=arg[2]? arg[2][68] : 0;
  a040=cos(a036);
  a041=(a039*a040);
  a038=(a038-a041);
  a042=(a034*a038);
  a042=(a042+a004);
  a043=cos(a000);
  a044=(a013*a043);
  a045=sin(a000);
  a046=(a009*a045);
  a044=(a044-a046);
  a042=(a042-a044);
  a018=(a027*a018);
  a018=(a018+a024);
  a025=casadi_sq(a025);
  a046=1.0000000000000000e-08;
  a025=(a025+a046);
  a025=sqrt(a025);
  a047=(a027*a025);
  a018=(a018+a047);
  a047=sqrt(a018);
  a048=atan2(a042,a047);
  a049=arg[1]? arg[1][8] : 0;
  a050=arg[1]? arg[1][6] : 0;
  a051=arg[2]? arg[2][56] : 0;
  a052=(a050*a051);
  a049=(a049-a052);
  a052=arg[2]? arg[2][72] : 0;
  a053=(a049*a052);
  a048=(a048-a053);
  a053=(a033*a048);
  a054=casadi_fmin(a031,a053);
  a055=casadi_fmax(a032,a054);
  a056=2.0000000000000001e-01;
  a057=0.;
  a058=-5.;
  a059=(a058*a029);
  a060=5.;
  a061=(a060*a055);
  a059=(a059-a061);
  a059=(a059+a027);
  a061=casadi_fmax(a057,a059);
  a062=casadi_sq(a061);
  a063=(a061*a062);
  a063=(a056*a063);
  a064=1.;
  a065=(a027*a061);
  a065=(a064-a065);
  a066=(a063*a065);
  a066=(a055+a066);
  a029=(a058*a029);
  a055=(a060*a055);
  a029=(a029+a055);
  a029=(a029+a027);
  a055=casadi_fmax(a057,a029);
  a067=casadi_sq(a055);
  a068=(a055*a067);
  a068=(a056*a068);
  a069=(a027*a055);
  a069=(a064-a069);
  a070=(a068*a069);
  a066=(a066-a070);
  a070=(a028*a066);
  a071=arg[2]? arg[2][74] : 0;
  a072=(a070*a071);
  a073=(a072*a021);
  a074=arg[4]? arg[4][23] : 0;
  a075=cos(a036);
  a076=arg[4]? arg[4][34] : 0;
  a075=(a075*a076);
  a077=(a035*a075);
  a078=sin(a036);
  a078=(a078*a076);
  a079=(a039*a078);
  a077=(a077+a079);
  a079=arg[4]? arg[4][30] : 0;
  a080=(a038*a079);
  a077=(a077+a080);
  a080=arg[4]? arg[4][32] : 0;
  a081=arg[2]? arg[2][27] : 0;
  a082=(a080/a081);
  a083=arg[4]? arg[4][29] : 0;
  a082=(a082+a083);
  a077=(a077+a082);
  a074=(a074-a077);
  a077=(a073*a074);
  a083=casadi_sq(a042);
  a083=(a083+a018);
  a084=(a042/a083);
  a085=(a053<=a031);
  a031=(a031<=a053);
  a053=(a031+a085);
  a085=(a085/a053);
  a086=(a032<=a054);
  a054=(a054<=a032);
  a032=(a054+a086);
  a086=(a086/a032);
  a087=(a057<=a029);
  a029=(a029<=a057);
  a029=(a029+a087);
  a087=(a087/a029);
  a029=casadi_sq(a042);
  a018=(a018+a029);
  a074=(a018*a074);
  a029=(a021*a074);
  a071=(a071*a029);
  a028=(a028*a071);
  a088=arg[4]? arg[4][22] : 0;
  a028=(a028+a088);
  a068=(a068*a028);
  a068=(a027*a068);
  a069=(a069*a028);
  a069=(a056*a069);
  a067=(a067*a069);
  a068=(a068-a067);
  a067=(2.*a055);
  a055=(a055*a069);
  a067=(a067*a055);
  a068=(a068-a067);
  a087=(a087*a068);
  a068=(a060*a087);
  a068=(a068+a028);
  a067=(a057<=a059);
  a059=(a059<=a057);
  a059=(a059+a067);
  a067=(a067/a059);
  a065=(a065*a028);
  a065=(a056*a065);
  a062=(a062*a065);
  a063=(a063*a028);
  a063=(a027*a063);
  a062=(a062-a063);
  a063=(2.*a061);
  a061=(a061*a065);
  a063=(a063*a061);
  a062=(a062+a063);
  a067=(a067*a062);
  a062=(a060*a067);
  a068=(a068-a062);
  a086=(a086*a068);
  a085=(a085*a086);
  a033=(a033*a085);
  a062=arg[4]? arg[4][21] : 0;
  a062=(a033+a062);
  a084=(a084*a062);
  a063=(2.*a047);
  a084=(a084/a063);
  a084=(a077-a084);
  a063=(a027*a084);
  a025=(2.*a025);
  a063=(a063/a025);
  a026=(a026*a063);
  a063=(a027*a084);
  a063=(a026+a063);
  a025=(a016*a063);
  a061=(2.*a015);
  a015=(a015*a063);
  a016=(2.*a016);
  a015=(a015/a016);
  a061=(a061*a015);
  a025=(a025+a061);
  a001=(a001+a025);
  a061=arg[2]? arg[2][44] : 0;
  a015=(a050*a061);
  a016=arg[1]? arg[1][7] : 0;
  a015=(a015+a016);
  a016=arg[2]? arg[2][45] : 0;
  a063=(a064-a016);
  a065=(a015*a063);
  a028=cos(a065);
  a059=(a002*a028);
  a055=arg[2]? arg[2][25] : 0;
  a069=cos(a036);
  a088=(a055*a069);
  a089=arg[2]? arg[2][30] : 0;
  a090=sin(a036);
  a091=(a089*a090);
  a092=(a088+a091);
  a093=(a034*a092);
  a093=(a093+a004);
  a094=sin(a065);
  a095=(a093*a094);
  a059=(a059+a095);
  a095=arg[2]? arg[2][5] : 0;
  a096=casadi_sq(a095);
  a097=casadi_sq(a096);
  a098=casadi_sq(a059);
  a099=cos(a065);
  a100=(a093*a099);
  a101=sin(a065);
  a102=(a002*a101);
  a100=(a100-a102);
  a102=casadi_sq(a100);
  a098=(a098+a102);
  a102=casadi_sq(a098);
  a097=(a097+a102);
  a097=sqrt(a097);
  a102=sqrt(a097);
  a103=(a059/a102);
  a104=arg[2]? arg[2][55] : 0;
  a105=arg[2]? arg[2][50] : 0;
  a106=1.0000000000000000e-03;
  a107=arg[2]? arg[2][48] : 0;
  a108=arg[2]? arg[2][49] : 0;
  a109=arg[2]? arg[2][26] : 0;
  a110=(a109*a081);
  a111=arg[2]? arg[2][12] : 0;
  a112=(a111+a030);
  a113=(-a112);
  a114=arg[2]? arg[2][11] : 0;
  a115=arg[1]? arg[1][3] : 0;
  a116=arg[2]? arg[2][10] : 0;
  a117=(a115*a116);
  a118=arg[2]? arg[2][9] : 0;
  a117=(a117+a118);
  a118=arg[2]? arg[2][8] : 0;
  a118=(a064-a118);
  a119=(a002-a012);
  a120=casadi_sq(a119);
  a120=(a120+a017);
  a120=sqrt(a120);
  a017=(a119*a120);
  a121=(a027*a017);
  a121=(a121+a024);
  a122=(2.*a024);
  a017=(a017+a122);
  a122=casadi_sq(a017);
  a122=(a122+a046);
  a122=sqrt(a122);
  a123=(a027*a122);
  a121=(a121+a123);
  a123=sqrt(a121);
  a123=atan2(a057,a123);
  a123=(a036+a123);
  a124=(a118*a123);
  a117=(a117+a124);
  a124=(a114*a117);
  a125=casadi_fmin(a112,a124);
  a126=casadi_fmax(a113,a125);
  a127=(a058*a111);
  a128=(a060*a126);
  a127=(a127-a128);
  a127=(a127+a027);
  a128=casadi_fmax(a057,a127);
  a129=casadi_sq(a128);
  a130=(a128*a129);
  a130=(a056*a130);
  a131=(a027*a128);
  a131=(a064-a131);
  a132=(a130*a131);
  a132=(a126+a132);
  a111=(a058*a111);
  a126=(a060*a126);
  a111=(a111+a126);
  a111=(a111+a027);
  a126=casadi_fmax(a057,a111);
  a133=casadi_sq(a126);
  a134=(a126*a133);
  a134=(a056*a134);
  a135=(a027*a126);
  a135=(a064-a135);
  a136=(a134*a135);
  a132=(a132-a136);
  a132=(a027*a132);
  a136=arg[2]? arg[2][13] : 0;
  a137=(a132*a136);
  a138=(a137*a021);
  a139=arg[2]? arg[2][14] : 0;
  a140=(a138*a139);
  a141=(a140*a121);
  a110=(a110-a141);
  a142=arg[2]? arg[2][22] : 0;
  a030=(a142+a030);
  a143=(-a030);
  a144=arg[2]? arg[2][20] : 0;
  a145=arg[2]? arg[2][21] : 0;
  a146=(a145*a036);
  a144=(a144+a146);
  a146=casadi_fmin(a030,a144);
  a147=casadi_fmax(a143,a146);
  a148=(a058*a142);
  a149=(a060*a147);
  a148=(a148-a149);
  a148=(a148+a027);
  a149=casadi_fmax(a057,a148);
  a150=casadi_sq(a149);
  a151=(a149*a150);
  a151=(a056*a151);
  a152=(a027*a149);
  a152=(a064-a152);
  a153=(a151*a152);
  a153=(a147+a153);
  a142=(a058*a142);
  a147=(a060*a147);
  a142=(a142+a147);
  a142=(a142+a027);
  a147=casadi_fmax(a057,a142);
  a154=casadi_sq(a147);
  a155=(a147*a154);
  a155=(a056*a155);
  a156=(a027*a147);
  a156=(a064-a156);
  a157=(a155*a156);
  a153=(a153-a157);
  a157=arg[2]? arg[2][15] : 0;
  a158=(a027*a157);
  a012=(a002-a012);
  a159=casadi_sq(a012);
  a159=(a159+a046);
  a044=(a004-a044);
  a046=casadi_sq(a044);
  a046=(a159+a046);
  a160=(a158*a046);
  a161=(a160*a021);
  a162=(a153*a161);
  a163=(a162*a012);
  a164=sqrt(a159);
  a163=(a163/a164);
  a110=(a110-a163);
  a165=arg[2]? arg[2][0] : 0;
  a166=cos(a036);
  a167=(a165*a166);
  a168=arg[2]? arg[2][4] : 0;
  a169=sin(a036);
  a170=(a168*a169);
  a167=(a167+a170);
  a170=(a110*a167);
  a171=arg[2]? arg[2][28] : 0;
  a172=cos(a036);
  a173=(a171*a172);
  a174=arg[2]? arg[2][29] : 0;
  a175=sin(a036);
  a176=(a174*a175);
  a177=(a173+a176);
  a178=(a141*a177);
  a179=arg[2]? arg[2][19] : 0;
  a180=(a179*a161);
  a181=arg[2]? arg[2][16] : 0;
  a182=arg[2]? arg[2][17] : 0;
  a183=(a182*a036);
  a181=(a181+a183);
  a183=arg[2]? arg[2][18] : 0;
  a184=(a183*a115);
  a181=(a181+a184);
  a184=(a180*a181);
  a185=arg[2]? arg[2][31] : 0;
  a186=(a019*a185);
  a187=cos(a036);
  a188=(a186*a187);
  a184=(a184+a188);
  a178=(a178+a184);
  a170=(a170+a178);
  a184=(a088+a091);
  a184=(a167-a184);
  a170=(a170/a184);
  a188=casadi_fmax(a057,a170);
  a189=(a108*a188);
  a107=(a107+a189);
  a189=casadi_fmax(a106,a107);
  a190=(a105*a189);
  a104=(a104/a190);
  a191=5.0000000000000004e-06;
  a192=(a104+a191);
  a193=(a103<=a192);
  a194=(a192<=a103);
  a195=(a194+a193);
  a193=(a193/a195);
  a196=(-a192);
  a192=casadi_fmin(a192,a103);
  a197=(a196<=a192);
  a198=(a192<=a196);
  a199=(a198+a197);
  a197=(a197/a199);
  a200=100000.;
  a201=-100000.;
  a202=(a201*a104);
  a196=casadi_fmax(a196,a192);
  a192=(a200*a196);
  a202=(a202+a192);
  a202=(a202+a027);
  a192=(a057<=a202);
  a203=(a202<=a057);
  a203=(a203+a192);
  a192=(a192/a203);
  a203=1.0000000000000001e-05;
  a202=casadi_fmax(a057,a202);
  a204=casadi_sq(a202);
  a205=(a202*a204);
  a205=(a203*a205);
  a206=cos(a065);
  a207=cos(a036);
  a208=arg[4]? arg[4][35] : 0;
  a207=(a207*a208);
  a209=(a206*a207);
  a210=(a089*a209);
  a211=sin(a065);
  a212=sin(a036);
  a212=(a212*a076);
  a213=(a211*a212);
  a214=(a055*a213);
  a210=(a210+a214);
  a214=sin(a065);
  a215=cos(a036);
  a216=(a089*a215);
  a217=(a216*a076);
  a218=(a088+a091);
  a218=(a218*a079);
  a217=(a217+a218);
  a217=(a217+a082);
  a219=(a214*a217);
  a210=(a210-a219);
  a219=cos(a065);
  a220=sin(a036);
  a220=(a220*a208);
  a221=(a055*a220);
  a222=arg[4]? arg[4][31] : 0;
  a223=(a222/a081);
  a224=arg[4]? arg[4][28] : 0;
  a223=(a223+a224);
  a221=(a221+a223);
  a224=(a219*a221);
  a210=(a210-a224);
  a224=arg[4]? arg[4][10] : 0;
  a210=(a210+a224);
  a224=(a190*a210);
  a225=(a188*a224);
  a226=(a201*a104);
  a227=(a200*a196);
  a226=(a226-a227);
  a226=(a226+a027);
  a227=casadi_fmax(a057,a226);
  a228=casadi_sq(a227);
  a229=(a227*a228);
  a229=(a203*a229);
  a230=(a027*a227);
  a230=(a064-a230);
  a231=(a229*a230);
  a196=(a196+a231);
  a231=(a027*a202);
  a231=(a064-a231);
  a232=(a205*a231);
  a196=(a196-a232);
  a232=(2.*a196);
  a233=casadi_sq(a196);
  a233=(a064-a233);
  a233=sqrt(a233);
  a234=(a201*a233);
  a235=(a233+a191);
  a236=(-a235);
  a237=arg[2]? arg[2][54] : 0;
  a238=arg[2]? arg[2][53] : 0;
  a239=arg[2]? arg[2][51] : 0;
  a240=arg[2]? arg[2][52] : 0;
  a241=(a240-a064);
  a242=casadi_fmax(a003,a241);
  a242=sqrt(a242);
  a243=(a239*a242);
  a244=(1./a243);
  a245=(-a244);
  a246=arg[2]? arg[2][46] : 0;
  a247=arg[2]? arg[2][47] : 0;
  a248=(a247*a188);
  a246=(a246+a248);
  a248=casadi_fmax(a057,a246);
  a249=casadi_sq(a059);
  a250=9.9999999999999995e-07;
  a251=casadi_sq(a095);
  a251=(a250*a251);
  a249=(a249+a251);
  a252=sqrt(a249);
  a253=(a100/a252);
  a254=(a248*a253);
  a254=(a254/a190);
  a255=casadi_fmin(a254,a244);
  a256=casadi_fmax(a245,a255);
  a257=(a239*a256);
  a258=atan(a257);
  a259=(a240*a258);
  a259=(a259/a239);
  a260=(a240-a064);
  a261=(a256*a260);
  a261=(a259-a261);
  a262=(a239*a261);
  a263=atan(a262);
  a264=(a238*a263);
  a265=sin(a264);
  a266=(a237*a265);
  a267=casadi_sq(a100);
  a267=(a267+a249);
  a267=sqrt(a267);
  a249=(a266*a267);
  a249=(a249/a102);
  a268=casadi_fmin(a235,a249);
  a269=casadi_fmax(a236,a268);
  a270=(a200*a269);
  a234=(a234+a270);
  a234=(a234+a027);
  a270=(a057<=a234);
  a271=(a234<=a057);
  a271=(a271+a270);
  a270=(a270/a271);
  a234=casadi_fmax(a057,a234);
  a271=casadi_sq(a234);
  a272=(a234*a271);
  a272=(a203*a272);
  a016=(a064-a016);
  a273=sin(a065);
  a274=sin(a036);
  a274=(a274*a208);
  a275=(a273*a274);
  a276=(a055*a275);
  a277=sin(a065);
  a277=(a277*a208);
  a278=(a216*a277);
  a276=(a276-a278);
  a278=sin(a036);
  a279=cos(a065);
  a279=(a279*a076);
  a280=(a278*a279);
  a281=(a055*a280);
  a276=(a276+a281);
  a281=cos(a065);
  a282=(a216*a076);
  a282=(a282+a218);
  a282=(a282+a082);
  a218=(a281*a282);
  a276=(a276-a218);
  a218=sin(a065);
  a283=(a218*a223);
  a276=(a276+a283);
  a283=arg[4]? arg[4][11] : 0;
  a276=(a276+a283);
  a283=(a016*a276);
  a284=(a190*a283);
  a285=(a188*a284);
  a286=(a272*a285);
  a286=(a027*a286);
  a287=(a027*a234);
  a287=(a064-a287);
  a288=(a287*a285);
  a288=(a203*a288);
  a271=(a271*a288);
  a286=(a286-a271);
  a271=(2.*a234);
  a234=(a234*a288);
  a271=(a271*a234);
  a286=(a286-a271);
  a270=(a270*a286);
  a286=(a201*a270);
  a271=(a201*a233);
  a234=(a200*a269);
  a271=(a271-a234);
  a271=(a271+a027);
  a234=(a057<=a271);
  a288=(a271<=a057);
  a288=(a288+a234);
  a234=(a234/a288);
  a271=casadi_fmax(a057,a271);
  a288=casadi_sq(a271);
  a289=(a027*a271);
  a289=(a064-a289);
  a290=(a289*a285);
  a290=(a203*a290);
  a291=(a288*a290);
  a288=(a271*a288);
  a288=(a203*a288);
  a292=(a288*a285);
  a292=(a027*a292);
  a291=(a291-a292);
  a292=(2.*a271);
  a271=(a271*a290);
  a292=(a292*a271);
  a291=(a291+a292);
  a234=(a234*a291);
  a291=(a201*a234);
  a286=(a286+a291);
  a291=(a235<=a249);
  a235=(a249<=a235);
  a292=(a291+a235);
  a291=(a291/a292);
  a271=(a236<=a268);
  a268=(a268<=a236);
  a236=(a268+a271);
  a271=(a271/a236);
  a270=(a200*a270);
  a270=(a270+a285);
  a234=(a200*a234);
  a270=(a270-a234);
  a271=(a271*a270);
  a291=(a291*a271);
  a268=(a268/a236);
  a268=(a268*a270);
  a291=(a291-a268);
  a286=(a286+a291);
  a233=(2.*a233);
  a286=(a286/a233);
  a232=(a232*a286);
  a225=(a225-a232);
  a205=(a205*a225);
  a205=(a027*a205);
  a231=(a231*a225);
  a231=(a203*a231);
  a204=(a204*a231);
  a205=(a205-a204);
  a204=(2.*a202);
  a202=(a202*a231);
  a204=(a204*a202);
  a205=(a205-a204);
  a192=(a192*a205);
  a205=(a200*a192);
  a205=(a205+a225);
  a204=(a057<=a226);
  a226=(a226<=a057);
  a226=(a226+a204);
  a204=(a204/a226);
  a230=(a230*a225);
  a230=(a203*a230);
  a228=(a228*a230);
  a229=(a229*a225);
  a229=(a027*a229);
  a228=(a228-a229);
  a229=(2.*a227);
  a227=(a227*a230);
  a229=(a229*a227);
  a228=(a228+a229);
  a204=(a204*a228);
  a228=(a200*a204);
  a205=(a205-a228);
  a197=(a197*a205);
  a193=(a193*a197);
  a228=(a193/a102);
  a229=(2.*a059);
  a098=(2.*a098);
  a249=(a249/a102);
  a235=(a235/a292);
  a235=(a235*a271);
  a249=(a249*a235);
  a103=(a103/a102);
  a103=(a103*a193);
  a249=(a249+a103);
  a103=(2.*a102);
  a249=(a249/a103);
  a097=(2.*a097);
  a249=(a249/a097);
  a098=(a098*a249);
  a229=(a229*a098);
  a228=(a228-a229);
  a059=(2.*a059);
  a235=(a235/a102);
  a266=(a266*a235);
  a102=(2.*a267);
  a266=(a266/a102);
  a102=(a253/a252);
  a229=(a254<=a244);
  a097=(a244<=a254);
  a103=(a229+a097);
  a229=(a229/a103);
  a193=(a245<=a255);
  a255=(a255<=a245);
  a245=(a255+a193);
  a193=(a193/a245);
  a264=cos(a264);
  a267=(a267*a235);
  a237=(a237*a267);
  a264=(a264*a237);
  a238=(a238*a264);
  a262=casadi_sq(a262);
  a262=(a064+a262);
  a238=(a238/a262);
  a240=(a240*a238);
  a257=casadi_sq(a257);
  a257=(a064+a257);
  a240=(a240/a257);
  a257=(a239*a240);
  a262=(a239*a238);
  a260=(a260*a262);
  a257=(a257-a260);
  a193=(a193*a257);
  a229=(a229*a193);
  a260=(a229/a190);
  a248=(a248*a260);
  a237=arg[4]? arg[4][9] : 0;
  a235=casadi_sq(a253);
  a235=(a064+a235);
  a237=(a237/a235);
  a248=(a248+a237);
  a102=(a102*a248);
  a237=(2.*a252);
  a102=(a102/a237);
  a102=(a266-a102);
  a059=(a059*a102);
  a228=(a228+a059);
  a028=(a028*a228);
  a001=(a001+a028);
  a028=(2.*a100);
  a028=(a028*a266);
  a100=(2.*a100);
  a100=(a100*a098);
  a028=(a028-a100);
  a248=(a248/a252);
  a028=(a028+a248);
  a101=(a101*a028);
  a001=(a001-a101);
  a101=arg[2]? arg[2][2] : 0;
  a248=cos(a101);
  a252=(a027*a034);
  a100=arg[2]? arg[2][3] : 0;
  a098=(a252*a100);
  a266=(a002-a098);
  a059=(a266*a248);
  a237=(a034*a167);
  a237=(a237+a004);
  a235=sin(a101);
  a271=(a237*a235);
  a059=(a059-a271);
  a292=casadi_sq(a095);
  a227=casadi_sq(a292);
  a230=casadi_sq(a059);
  a225=cos(a101);
  a226=(a237*a225);
  a202=(a002-a098);
  a231=sin(a101);
  a232=(a202*a231);
  a226=(a226+a232);
  a232=casadi_sq(a226);
  a230=(a230+a232);
  a232=casadi_sq(a230);
  a227=(a227+a232);
  a227=sqrt(a227);
  a232=sqrt(a227);
  a286=(a059/a232);
  a233=arg[1]? arg[1][5] : 0;
  a291=arg[2]? arg[2][42] : 0;
  a268=arg[2]? arg[2][34] : 0;
  a270=arg[2]? arg[2][35] : 0;
  a088=(a088+a091);
  a091=(a110*a088);
  a091=(a091+a178);
  a091=(a027*a091);
  a091=(a091/a184);
  a178=(-a091);
  a236=casadi_fmax(a057,a178);
  a234=(a270*a236);
  a234=(a268+a234);
  a285=casadi_fmax(a106,a234);
  a290=(a291*a285);
  a293=arg[2]? arg[2][43] : 0;
  a294=(a290-a293);
  a295=(a233*a294);
  a295=(a295+a293);
  a295=(a295/a290);
  a293=(a295+a191);
  a296=(a286<=a293);
  a297=(a293<=a286);
  a298=(a297+a296);
  a296=(a296/a298);
  a299=(-a293);
  a293=casadi_fmin(a293,a286);
  a300=(a299<=a293);
  a301=(a293<=a299);
  a302=(a301+a300);
  a300=(a300/a302);
  a303=(a201*a295);
  a299=casadi_fmax(a299,a293);
  a293=(a200*a299);
  a303=(a303+a293);
  a303=(a303+a027);
  a293=(a057<=a303);
  a304=(a303<=a057);
  a304=(a304+a293);
  a293=(a293/a304);
  a303=casadi_fmax(a057,a303);
  a304=casadi_sq(a303);
  a305=(a303*a304);
  a305=(a203*a305);
  a306=cos(a036);
  a307=cos(a101);
  a307=(a307*a208);
  a308=(a306*a307);
  a309=(a168*a308);
  a310=sin(a101);
  a311=cos(a036);
  a311=(a311*a076);
  a312=(a310*a311);
  a313=(a168*a312);
  a309=(a309+a313);
  a313=sin(a101);
  a314=(a167*a079);
  a315=sin(a036);
  a316=(a165*a315);
  a317=(a316*a076);
  a317=(a314-a317);
  a318=(a313*a317);
  a309=(a309+a318);
  a318=sin(a101);
  a319=(a318*a082);
  a309=(a309+a319);
  a319=cos(a101);
  a320=(a027*a100);
  a320=(a320*a079);
  a321=(a316*a208);
  a321=(a320-a321);
  a321=(a321-a223);
  a322=(a319*a321);
  a309=(a309+a322);
  a322=arg[4]? arg[4][6] : 0;
  a309=(a309+a322);
  a322=(a290*a309);
  a323=(a236*a322);
  a324=(a201*a295);
  a325=(a200*a299);
  a324=(a324-a325);
  a324=(a324+a027);
  a325=casadi_fmax(a057,a324);
  a326=casadi_sq(a325);
  a327=(a325*a326);
  a327=(a203*a327);
  a328=(a027*a325);
  a328=(a064-a328);
  a329=(a327*a328);
  a299=(a299+a329);
  a329=(a027*a303);
  a329=(a064-a329);
  a330=(a305*a329);
  a299=(a299-a330);
  a330=(2.*a299);
  a331=casadi_sq(a299);
  a331=(a064-a331);
  a331=sqrt(a331);
  a332=(a201*a331);
  a333=(a331+a191);
  a334=(-a333);
  a335=arg[2]? arg[2][40] : 0;
  a336=arg[2]? arg[2][39] : 0;
  a337=arg[2]? arg[2][37] : 0;
  a338=arg[2]? arg[2][38] : 0;
  a339=(a338-a064);
  a340=casadi_fmax(a003,a339);
  a340=sqrt(a340);
  a341=(a337*a340);
  a342=(1./a341);
  a343=(-a342);
  a344=arg[2]? arg[2][32] : 0;
  a345=arg[2]? arg[2][33] : 0;
  a346=(a345*a236);
  a346=(a344+a346);
  a347=casadi_fmax(a057,a346);
  a348=casadi_sq(a059);
  a348=(a348+a251);
  a349=sqrt(a348);
  a350=(a226/a349);
  a351=(a347*a350);
  a351=(a351/a290);
  a352=casadi_fmin(a351,a342);
  a353=casadi_fmax(a343,a352);
  a354=(a064-a338);
  a355=(a353*a354);
  a356=(a337*a353);
  a357=atan(a356);
  a358=(a338*a357);
  a358=(a358/a337);
  a355=(a355+a358);
  a359=(a337*a355);
  a360=atan(a359);
  a361=(a336*a360);
  a362=sin(a361);
  a363=(a335*a362);
  a364=casadi_sq(a226);
  a364=(a364+a348);
  a364=sqrt(a364);
  a348=(a363*a364);
  a348=(a348/a232);
  a365=casadi_fmin(a333,a348);
  a366=casadi_fmax(a334,a365);
  a367=(a200*a366);
  a332=(a332+a367);
  a332=(a332+a027);
  a367=(a057<=a332);
  a368=(a332<=a057);
  a368=(a368+a367);
  a367=(a367/a368);
  a332=casadi_fmax(a057,a332);
  a368=casadi_sq(a332);
  a369=(a332*a368);
  a369=(a203*a369);
  a370=sin(a101);
  a371=cos(a036);
  a371=(a371*a208);
  a372=(a370*a371);
  a373=(a168*a372);
  a374=sin(a036);
  a375=cos(a101);
  a375=(a375*a076);
  a376=(a374*a375);
  a377=(a165*a376);
  a373=(a373+a377);
  a377=cos(a101);
  a378=cos(a036);
  a379=(a168*a378);
  a380=(a379*a076);
  a380=(a380+a314);
  a380=(a380+a082);
  a314=(a377*a380);
  a373=(a373-a314);
  a314=sin(a101);
  a381=(a316*a208);
  a320=(a320-a381);
  a320=(a320-a223);
  a381=(a314*a320);
  a373=(a373+a381);
  a381=arg[4]? arg[4][7] : 0;
  a373=(a373+a381);
  a381=(a290*a373);
  a382=(a236*a381);
  a383=(a369*a382);
  a383=(a027*a383);
  a384=(a027*a332);
  a384=(a064-a384);
  a385=(a384*a382);
  a385=(a203*a385);
  a368=(a368*a385);
  a383=(a383-a368);
  a368=(2.*a332);
  a332=(a332*a385);
  a368=(a368*a332);
  a383=(a383-a368);
  a367=(a367*a383);
  a383=(a201*a367);
  a368=(a201*a331);
  a332=(a200*a366);
  a368=(a368-a332);
  a368=(a368+a027);
  a332=(a057<=a368);
  a385=(a368<=a057);
  a385=(a385+a332);
  a332=(a332/a385);
  a368=casadi_fmax(a057,a368);
  a385=casadi_sq(a368);
  a386=(a027*a368);
  a386=(a064-a386);
  a387=(a386*a382);
  a387=(a203*a387);
  a388=(a385*a387);
  a385=(a368*a385);
  a385=(a203*a385);
  a389=(a385*a382);
  a389=(a027*a389);
  a388=(a388-a389);
  a389=(2.*a368);
  a368=(a368*a387);
  a389=(a389*a368);
  a388=(a388+a389);
  a332=(a332*a388);
  a388=(a201*a332);
  a383=(a383+a388);
  a388=(a333<=a348);
  a333=(a348<=a333);
  a389=(a388+a333);
  a388=(a388/a389);
  a368=(a334<=a365);
  a365=(a365<=a334);
  a334=(a365+a368);
  a368=(a368/a334);
  a367=(a200*a367);
  a367=(a367+a382);
  a332=(a200*a332);
  a367=(a367-a332);
  a368=(a368*a367);
  a388=(a388*a368);
  a365=(a365/a334);
  a365=(a365*a367);
  a388=(a388-a365);
  a383=(a383+a388);
  a331=(2.*a331);
  a383=(a383/a331);
  a330=(a330*a383);
  a323=(a323-a330);
  a305=(a305*a323);
  a305=(a027*a305);
  a329=(a329*a323);
  a329=(a203*a329);
  a304=(a304*a329);
  a305=(a305-a304);
  a304=(2.*a303);
  a303=(a303*a329);
  a304=(a304*a303);
  a305=(a305-a304);
  a293=(a293*a305);
  a305=(a200*a293);
  a305=(a305+a323);
  a304=(a057<=a324);
  a324=(a324<=a057);
  a324=(a324+a304);
  a304=(a304/a324);
  a328=(a328*a323);
  a328=(a203*a328);
  a326=(a326*a328);
  a327=(a327*a323);
  a327=(a027*a327);
  a326=(a326-a327);
  a327=(2.*a325);
  a325=(a325*a328);
  a327=(a327*a325);
  a326=(a326+a327);
  a304=(a304*a326);
  a326=(a200*a304);
  a305=(a305-a326);
  a300=(a300*a305);
  a296=(a296*a300);
  a326=(a296/a232);
  a327=(2.*a059);
  a230=(2.*a230);
  a348=(a348/a232);
  a333=(a333/a389);
  a333=(a333*a368);
  a348=(a348*a333);
  a286=(a286/a232);
  a286=(a286*a296);
  a348=(a348+a286);
  a286=(2.*a232);
  a348=(a348/a286);
  a227=(2.*a227);
  a348=(a348/a227);
  a230=(a230*a348);
  a327=(a327*a230);
  a326=(a326-a327);
  a059=(2.*a059);
  a333=(a333/a232);
  a363=(a363*a333);
  a232=(2.*a364);
  a363=(a363/a232);
  a232=(a350/a349);
  a327=(a351<=a342);
  a227=(a342<=a351);
  a286=(a327+a227);
  a327=(a327/a286);
  a296=(a343<=a352);
  a352=(a352<=a343);
  a343=(a352+a296);
  a296=(a296/a343);
  a361=cos(a361);
  a364=(a364*a333);
  a333=(a335*a364);
  a361=(a361*a333);
  a333=(a336*a361);
  a359=casadi_sq(a359);
  a359=(a064+a359);
  a333=(a333/a359);
  a359=(a338*a333);
  a356=casadi_sq(a356);
  a356=(a064+a356);
  a359=(a359/a356);
  a356=(a337*a359);
  a368=(a337*a333);
  a354=(a354*a368);
  a356=(a356+a354);
  a296=(a296*a356);
  a327=(a327*a296);
  a354=(a327/a290);
  a347=(a347*a354);
  a389=arg[4]? arg[4][5] : 0;
  a325=casadi_sq(a350);
  a325=(a064+a325);
  a389=(a389/a325);
  a347=(a347+a389);
  a232=(a232*a347);
  a389=(2.*a349);
  a232=(a232/a389);
  a232=(a363-a232);
  a059=(a059*a232);
  a326=(a326+a059);
  a248=(a248*a326);
  a001=(a001+a248);
  a059=(2.*a226);
  a059=(a059*a363);
  a226=(2.*a226);
  a226=(a226*a230);
  a059=(a059-a226);
  a347=(a347/a349);
  a059=(a059+a347);
  a231=(a231*a059);
  a001=(a001+a231);
  a347=cos(a101);
  a349=(a002+a098);
  a226=(a349*a347);
  a271=(a271+a226);
  a226=casadi_sq(a095);
  a230=casadi_sq(a226);
  a363=casadi_sq(a271);
  a389=cos(a101);
  a325=(a237*a389);
  a098=(a002+a098);
  a328=sin(a101);
  a323=(a098*a328);
  a325=(a325-a323);
  a323=casadi_sq(a325);
  a363=(a363+a323);
  a323=casadi_sq(a363);
  a230=(a230+a323);
  a230=sqrt(a230);
  a323=sqrt(a230);
  a324=(a271/a323);
  a303=arg[1]? arg[1][4] : 0;
  a329=arg[2]? arg[2][36] : 0;
  a330=(a270*a236);
  a268=(a268+a330);
  a330=casadi_fmax(a106,a268);
  a383=(a329*a330);
  a331=arg[2]? arg[2][41] : 0;
  a388=(a383-a331);
  a365=(a303*a388);
  a365=(a365+a331);
  a365=(a365/a383);
  a331=(a365+a191);
  a367=(a324<=a331);
  a334=(a331<=a324);
  a332=(a334+a367);
  a367=(a367/a332);
  a382=(-a331);
  a331=casadi_fmin(a331,a324);
  a387=(a382<=a331);
  a390=(a331<=a382);
  a391=(a390+a387);
  a387=(a387/a391);
  a392=(a201*a365);
  a382=casadi_fmax(a382,a331);
  a331=(a200*a382);
  a392=(a392+a331);
  a392=(a392+a027);
  a331=(a057<=a392);
  a393=(a392<=a057);
  a393=(a393+a331);
  a331=(a331/a393);
  a392=casadi_fmax(a057,a392);
  a393=casadi_sq(a392);
  a394=(a392*a393);
  a394=(a203*a394);
  a395=cos(a036);
  a396=cos(a101);
  a396=(a396*a208);
  a397=(a395*a396);
  a398=(a168*a397);
  a399=sin(a036);
  a400=sin(a101);
  a400=(a400*a076);
  a401=(a399*a400);
  a402=(a165*a401);
  a398=(a398+a402);
  a402=sin(a101);
  a403=(a379*a076);
  a404=(a167*a079);
  a403=(a403+a404);
  a403=(a403+a082);
  a405=(a402*a403);
  a398=(a398-a405);
  a405=cos(a101);
  a316=(a316*a208);
  a406=(a027*a100);
  a406=(a406*a079);
  a406=(a406+a223);
  a316=(a316+a406);
  a407=(a405*a316);
  a398=(a398-a407);
  a407=arg[4]? arg[4][2] : 0;
  a398=(a398+a407);
  a407=(a383*a398);
  a408=(a236*a407);
  a409=(a201*a365);
  a410=(a200*a382);
  a409=(a409-a410);
  a409=(a409+a027);
  a410=casadi_fmax(a057,a409);
  a411=casadi_sq(a410);
  a412=(a410*a411);
  a412=(a203*a412);
  a413=(a027*a410);
  a413=(a064-a413);
  a414=(a412*a413);
  a382=(a382+a414);
  a414=(a027*a392);
  a414=(a064-a414);
  a415=(a394*a414);
  a382=(a382-a415);
  a415=(2.*a382);
  a416=casadi_sq(a382);
  a416=(a064-a416);
  a416=sqrt(a416);
  a417=(a201*a416);
  a191=(a416+a191);
  a418=(-a191);
  a419=(-a342);
  a420=(a345*a236);
  a344=(a344+a420);
  a420=casadi_fmax(a057,a344);
  a421=casadi_sq(a271);
  a421=(a421+a251);
  a251=sqrt(a421);
  a422=(a325/a251);
  a423=(a420*a422);
  a423=(a423/a383);
  a424=casadi_fmin(a423,a342);
  a425=casadi_fmax(a419,a424);
  a426=(a064-a338);
  a427=(a425*a426);
  a428=(a337*a425);
  a429=atan(a428);
  a430=(a338*a429);
  a430=(a430/a337);
  a427=(a427+a430);
  a431=(a337*a427);
  a432=atan(a431);
  a433=(a336*a432);
  a434=sin(a433);
  a435=(a335*a434);
  a436=casadi_sq(a325);
  a436=(a436+a421);
  a436=sqrt(a436);
  a421=(a435*a436);
  a421=(a421/a323);
  a437=casadi_fmin(a191,a421);
  a438=casadi_fmax(a418,a437);
  a439=(a200*a438);
  a417=(a417+a439);
  a417=(a417+a027);
  a439=(a057<=a417);
  a440=(a417<=a057);
  a440=(a440+a439);
  a439=(a439/a440);
  a417=casadi_fmax(a057,a417);
  a440=casadi_sq(a417);
  a441=(a417*a440);
  a441=(a203*a441);
  a442=sin(a036);
  a443=sin(a101);
  a443=(a443*a208);
  a444=(a442*a443);
  a445=(a165*a444);
  a446=sin(a101);
  a446=(a446*a208);
  a447=(a379*a446);
  a445=(a445-a447);
  a447=sin(a036);
  a448=cos(a101);
  a448=(a448*a076);
  a449=(a447*a448);
  a450=(a165*a449);
  a445=(a445+a450);
  a450=cos(a101);
  a451=(a379*a076);
  a451=(a451+a404);
  a451=(a451+a082);
  a404=(a450*a451);
  a445=(a445-a404);
  a404=sin(a101);
  a452=(a404*a406);
  a445=(a445+a452);
  a452=arg[4]? arg[4][3] : 0;
  a445=(a445+a452);
  a452=(a383*a445);
  a453=(a236*a452);
  a454=(a441*a453);
  a454=(a027*a454);
  a455=(a027*a417);
  a455=(a064-a455);
  a456=(a455*a453);
  a456=(a203*a456);
  a440=(a440*a456);
  a454=(a454-a440);
  a440=(2.*a417);
  a417=(a417*a456);
  a440=(a440*a417);
  a454=(a454-a440);
  a439=(a439*a454);
  a454=(a201*a439);
  a440=(a201*a416);
  a417=(a200*a438);
  a440=(a440-a417);
  a440=(a440+a027);
  a417=(a057<=a440);
  a456=(a440<=a057);
  a456=(a456+a417);
  a417=(a417/a456);
  a440=casadi_fmax(a057,a440);
  a456=casadi_sq(a440);
  a457=(a027*a440);
  a457=(a064-a457);
  a458=(a457*a453);
  a458=(a203*a458);
  a459=(a456*a458);
  a456=(a440*a456);
  a456=(a203*a456);
  a460=(a456*a453);
  a460=(a027*a460);
  a459=(a459-a460);
  a460=(2.*a440);
  a440=(a440*a458);
  a460=(a460*a440);
  a459=(a459+a460);
  a417=(a417*a459);
  a459=(a201*a417);
  a454=(a454+a459);
  a459=(a191<=a421);
  a191=(a421<=a191);
  a460=(a459+a191);
  a459=(a459/a460);
  a440=(a418<=a437);
  a437=(a437<=a418);
  a418=(a437+a440);
  a440=(a440/a418);
  a439=(a200*a439);
  a439=(a439+a453);
  a417=(a200*a417);
  a439=(a439-a417);
  a440=(a440*a439);
  a459=(a459*a440);
  a437=(a437/a418);
  a437=(a437*a439);
  a459=(a459-a437);
  a454=(a454+a459);
  a416=(2.*a416);
  a454=(a454/a416);
  a415=(a415*a454);
  a408=(a408-a415);
  a394=(a394*a408);
  a394=(a027*a394);
  a414=(a414*a408);
  a414=(a203*a414);
  a393=(a393*a414);
  a394=(a394-a393);
  a393=(2.*a392);
  a392=(a392*a414);
  a393=(a393*a392);
  a394=(a394-a393);
  a331=(a331*a394);
  a394=(a200*a331);
  a394=(a394+a408);
  a393=(a057<=a409);
  a409=(a409<=a057);
  a409=(a409+a393);
  a393=(a393/a409);
  a413=(a413*a408);
  a203=(a203*a413);
  a411=(a411*a203);
  a412=(a412*a408);
  a412=(a027*a412);
  a411=(a411-a412);
  a412=(2.*a410);
  a410=(a410*a203);
  a412=(a412*a410);
  a411=(a411+a412);
  a393=(a393*a411);
  a200=(a200*a393);
  a394=(a394-a200);
  a387=(a387*a394);
  a367=(a367*a387);
  a200=(a367/a323);
  a411=(2.*a271);
  a363=(2.*a363);
  a421=(a421/a323);
  a191=(a191/a460);
  a191=(a191*a440);
  a421=(a421*a191);
  a324=(a324/a323);
  a324=(a324*a367);
  a421=(a421+a324);
  a324=(2.*a323);
  a421=(a421/a324);
  a230=(2.*a230);
  a421=(a421/a230);
  a363=(a363*a421);
  a411=(a411*a363);
  a200=(a200-a411);
  a271=(2.*a271);
  a191=(a191/a323);
  a435=(a435*a191);
  a323=(2.*a436);
  a435=(a435/a323);
  a323=(a422/a251);
  a411=(a423<=a342);
  a230=(a342<=a423);
  a324=(a411+a230);
  a411=(a411/a324);
  a367=(a419<=a424);
  a424=(a424<=a419);
  a419=(a424+a367);
  a367=(a367/a419);
  a433=cos(a433);
  a436=(a436*a191);
  a335=(a335*a436);
  a433=(a433*a335);
  a336=(a336*a433);
  a431=casadi_sq(a431);
  a431=(a064+a431);
  a336=(a336/a431);
  a338=(a338*a336);
  a428=casadi_sq(a428);
  a428=(a064+a428);
  a338=(a338/a428);
  a428=(a337*a338);
  a431=(a337*a336);
  a426=(a426*a431);
  a428=(a428+a426);
  a367=(a367*a428);
  a411=(a411*a367);
  a426=(a411/a383);
  a420=(a420*a426);
  a335=arg[4]? arg[4][1] : 0;
  a191=casadi_sq(a422);
  a064=(a064+a191);
  a335=(a335/a064);
  a420=(a420+a335);
  a323=(a323*a420);
  a335=(2.*a251);
  a323=(a323/a335);
  a323=(a435-a323);
  a271=(a271*a323);
  a200=(a200+a271);
  a347=(a347*a200);
  a001=(a001+a347);
  a271=(2.*a325);
  a271=(a271*a435);
  a325=(2.*a325);
  a325=(a325*a363);
  a271=(a271-a325);
  a420=(a420/a251);
  a271=(a271+a420);
  a328=(a328*a271);
  a001=(a001-a328);
  a420=(2.*a012);
  a251=arg[2]? arg[2][23] : 0;
  a325=casadi_sq(a153);
  a363=arg[2]? arg[2][24] : 0;
  a435=(a325*a363);
  a251=(a251+a435);
  a435=(a251*a161);
  a335=(a435*a012);
  a335=(a335/a164);
  a064=(a335/a164);
  a064=(a064*a223);
  a191=casadi_sq(a044);
  a191=(a191+a159);
  a159=(a044/a191);
  a440=arg[2]? arg[2][65] : 0;
  a460=arg[2]? arg[2][60] : 0;
  a412=(a460*a161);
  a410=arg[4]? arg[4][20] : 0;
  a410=(a079+a410);
  a412=(a412*a410);
  a203=(a440*a412);
  a408=arg[2]? arg[2][62] : 0;
  a413=(a460*a161);
  a409=arg[4]? arg[4][18] : 0;
  a409=(a409-a076);
  a413=(a413*a409);
  a392=(a408*a413);
  a203=(a203+a392);
  a392=arg[2]? arg[2][57] : 0;
  a414=arg[4]? arg[4][17] : 0;
  a414=(a082+a414);
  a415=(a161*a414);
  a454=(a392*a415);
  a203=(a203+a454);
  a454=arg[4]? arg[4][13] : 0;
  a203=(a203+a454);
  a159=(a159*a203);
  a064=(a064-a159);
  a163=(a163/a164);
  a159=arg[4]? arg[4][33] : 0;
  a454=(a057<=a170);
  a416=(a170<=a057);
  a416=(a416+a454);
  a454=(a454/a416);
  a288=(a288*a289);
  a269=(a269+a288);
  a272=(a272*a287);
  a269=(a269-a272);
  a284=(a269*a284);
  a272=(a057<=a246);
  a246=(a246<=a057);
  a246=(a246+a272);
  a272=(a272/a246);
  a253=(a253*a260);
  a272=(a272*a253);
  a247=(a247*a272);
  a284=(a284+a247);
  a224=(a196*a224);
  a284=(a284+a224);
  a224=(a106<=a107);
  a107=(a107<=a106);
  a107=(a107+a224);
  a224=(a224/a107);
  a269=(a188*a269);
  a283=(a269*a283);
  a254=(a254/a190);
  a254=(a254*a229);
  a283=(a283-a254);
  a196=(a188*a196);
  a210=(a196*a210);
  a283=(a283+a210);
  a104=(a104/a190);
  a192=(a201*a192);
  a204=(a201*a204);
  a192=(a192+a204);
  a194=(a194/a195);
  a194=(a194*a197);
  a198=(a198/a199);
  a198=(a198*a205);
  a194=(a194-a198);
  a192=(a192+a194);
  a104=(a104*a192);
  a283=(a283-a104);
  a105=(a105*a283);
  a224=(a224*a105);
  a108=(a108*a224);
  a284=(a284+a108);
  a108=arg[4]? arg[4][8] : 0;
  a284=(a284+a108);
  a454=(a454*a284);
  a284=(a454/a184);
  a108=(a167*a284);
  a159=(a159+a108);
  a108=(a057<=a178);
  a178=(a178<=a057);
  a178=(a178+a108);
  a108=(a108/a178);
  a385=(a385*a386);
  a366=(a366+a385);
  a369=(a369*a384);
  a366=(a366-a369);
  a381=(a366*a381);
  a369=(a057<=a346);
  a346=(a346<=a057);
  a346=(a346+a369);
  a369=(a369/a346);
  a350=(a350*a354);
  a369=(a369*a350);
  a350=(a345*a369);
  a381=(a381+a350);
  a322=(a299*a322);
  a381=(a381+a322);
  a322=(a106<=a234);
  a234=(a234<=a106);
  a234=(a234+a322);
  a322=(a322/a234);
  a366=(a236*a366);
  a373=(a366*a373);
  a351=(a351/a290);
  a351=(a351*a327);
  a373=(a373-a351);
  a299=(a236*a299);
  a309=(a299*a309);
  a373=(a373+a309);
  a295=(a295/a290);
  a293=(a201*a293);
  a304=(a201*a304);
  a293=(a293+a304);
  a297=(a297/a298);
  a297=(a297*a300);
  a301=(a301/a302);
  a301=(a301*a305);
  a297=(a297-a301);
  a293=(a293+a297);
  a295=(a295*a293);
  a373=(a373-a295);
  a293=(a293/a290);
  a233=(a233*a293);
  a373=(a373+a233);
  a291=(a291*a373);
  a322=(a322*a291);
  a291=(a270*a322);
  a381=(a381+a291);
  a291=arg[4]? arg[4][4] : 0;
  a381=(a381+a291);
  a456=(a456*a457);
  a438=(a438+a456);
  a441=(a441*a455);
  a438=(a438-a441);
  a452=(a438*a452);
  a381=(a381+a452);
  a452=(a057<=a344);
  a344=(a344<=a057);
  a344=(a344+a452);
  a452=(a452/a344);
  a422=(a422*a426);
  a452=(a452*a422);
  a345=(a345*a452);
  a381=(a381+a345);
  a407=(a382*a407);
  a381=(a381+a407);
  a407=(a106<=a268);
  a268=(a268<=a106);
  a268=(a268+a407);
  a407=(a407/a268);
  a438=(a236*a438);
  a445=(a438*a445);
  a423=(a423/a383);
  a423=(a423*a411);
  a445=(a445-a423);
  a382=(a236*a382);
  a398=(a382*a398);
  a445=(a445+a398);
  a365=(a365/a383);
  a331=(a201*a331);
  a201=(a201*a393);
  a331=(a331+a201);
  a334=(a334/a332);
  a334=(a334*a387);
  a390=(a390/a391);
  a390=(a390*a394);
  a334=(a334-a390);
  a331=(a331+a334);
  a365=(a365*a331);
  a445=(a445-a365);
  a331=(a331/a383);
  a303=(a303*a331);
  a445=(a445+a303);
  a329=(a329*a445);
  a407=(a407*a329);
  a270=(a270*a407);
  a381=(a381+a270);
  a270=arg[4]? arg[4][0] : 0;
  a381=(a381+a270);
  a108=(a108*a381);
  a381=(a108/a184);
  a381=(a027*a381);
  a088=(a088*a381);
  a159=(a159-a088);
  a163=(a163*a159);
  a064=(a064+a163);
  a163=(2.*a164);
  a064=(a064/a163);
  a163=2.5000000000000000e-01;
  a157=(a163*a157);
  a088=casadi_sq(a460);
  a270=arg[2]? arg[2][66] : 0;
  a270=(a270*a410);
  a329=arg[2]? arg[2][63] : 0;
  a329=(a329*a409);
  a270=(a270+a329);
  a329=(a088*a270);
  a365=arg[2]? arg[2][58] : 0;
  a334=(a365*a460);
  a390=(a334*a414);
  a329=(a329+a390);
  a390=(a021*a329);
  a394=(a034*a390);
  a391=(a157*a394);
  a387=sqrt(a046);
  a332=(2.*a387);
  a391=(a391/a332);
  a332=arg[2]? arg[2][64] : 0;
  a201=arg[1]? arg[1][9] : 0;
  a393=(a332*a201);
  a398=atan2(a044,a164);
  a440=(a440*a398);
  a393=(a393+a440);
  a440=arg[2]? arg[2][67] : 0;
  a423=(a440*a049);
  a393=(a393+a423);
  a393=(a393*a410);
  a423=(a460*a393);
  a411=arg[2]? arg[2][61] : 0;
  a268=(a411*a201);
  a408=(a408*a398);
  a268=(a268+a408);
  a268=(a268*a409);
  a408=(a460*a268);
  a423=(a423+a408);
  a392=(a392*a398);
  a408=arg[2]? arg[2][59] : 0;
  a106=(a408*a049);
  a392=(a392+a106);
  a106=(a392*a414);
  a423=(a423+a106);
  a106=arg[4]? arg[4][16] : 0;
  a345=(a223/a164);
  a422=(a012*a345);
  a106=(a106-a422);
  a251=(a251*a106);
  a423=(a423+a251);
  a251=arg[4]? arg[4][19] : 0;
  a422=(a284-a381);
  a426=(a422-a208);
  a251=(a251+a426);
  a181=(a181*a251);
  a179=(a179*a181);
  a423=(a423+a179);
  a179=arg[4]? arg[4][15] : 0;
  a344=(a159/a164);
  a012=(a012*a344);
  a179=(a179-a012);
  a012=(a153*a179);
  a423=(a423+a012);
  a012=(a021*a423);
  a158=(a158*a012);
  a391=(a391+a158);
  a064=(a064+a391);
  a420=(a420*a064);
  a435=(a435*a345);
  a162=(a162*a344);
  a435=(a435+a162);
  a420=(a420-a435);
  a001=(a001+a420);
  a017=(2.*a017);
  a435=arg[4]? arg[4][26] : 0;
  a176=(a176*a208);
  a173=(a173*a208);
  a176=(a176+a173);
  a435=(a435-a176);
  a177=(a177*a422);
  a435=(a435+a177);
  a435=(a435-a159);
  a140=(a140*a435);
  a177=(a027*a140);
  a122=(2.*a122);
  a177=(a177/a122);
  a017=(a017*a177);
  a177=(a027*a140);
  a177=(a017+a177);
  a122=(a120*a177);
  a176=(2.*a119);
  a119=(a119*a177);
  a120=(2.*a120);
  a119=(a119/a120);
  a176=(a176*a119);
  a122=(a122+a176);
  a001=(a001+a122);
  if (res[0]!=0) res[0][0]=a001;
  a011=(a011*a010);
  a005=(a005*a006);
  a011=(a011-a005);
  a042=(2.*a042);
  a042=(a042*a077);
  a047=(a047/a083);
  a047=(a047*a062);
  a042=(a042+a047);
  a011=(a011+a042);
  a094=(a094*a228);
  a099=(a099*a028);
  a094=(a094+a099);
  a011=(a011+a094);
  a225=(a225*a059);
  a099=(a200-a326);
  a235=(a235*a099);
  a225=(a225+a235);
  a389=(a389*a271);
  a225=(a225+a389);
  a011=(a011+a225);
  a164=(a164/a191);
  a164=(a164*a203);
  a044=(2.*a044);
  a044=(a044*a391);
  a164=(a164+a044);
  a011=(a011+a164);
  if (res[0]!=0) res[0][1]=a011;
  a038=(a038*a042);
  a157=(a157*a387);
  a390=(a157*a390);
  a038=(a038+a390);
  a092=(a092*a094);
  a038=(a038+a092);
  a248=(a248+a231);
  a347=(a347-a248);
  a347=(a347-a328);
  a100=(a100*a347);
  a100=(a027*a100);
  a038=(a038+a100);
  a167=(a167*a225);
  a038=(a038+a167);
  if (res[0]!=0) res[0][2]=a038;
  if (res[0]!=0) res[0][3]=a057;
  a038=arg[0]? arg[0][4] : 0;
  a038=casadi_sign(a038);
  a167=arg[4]? arg[4][37] : 0;
  a038=(a038*a167);
  if (res[0]!=0) res[0][4]=a038;
  a038=casadi_sign(a000);
  a100=arg[4]? arg[4][38] : 0;
  a038=(a038*a100);
  a328=cos(a000);
  a248=(a004*a006);
  a328=(a328*a248);
  a038=(a038-a328);
  a328=sin(a000);
  a006=(a002*a006);
  a328=(a328*a006);
  a038=(a038-a328);
  a328=sin(a000);
  a004=(a004*a010);
  a328=(a328*a004);
  a038=(a038-a328);
  a328=cos(a000);
  a010=(a002*a010);
  a328=(a328*a010);
  a038=(a038+a328);
  a328=cos(a000);
  a164=(a042+a164);
  a010=(a009*a164);
  a328=(a328*a010);
  a038=(a038+a328);
  a328=sin(a000);
  a010=(a013*a164);
  a328=(a328*a010);
  a038=(a038+a328);
  a328=cos(a000);
  a025=(a025+a420);
  a025=(a025+a122);
  a013=(a013*a025);
  a328=(a328*a013);
  a038=(a038-a328);
  a000=sin(a000);
  a009=(a009*a025);
  a000=(a000*a009);
  a038=(a038+a000);
  if (res[0]!=0) res[0][5]=a038;
  a045=(a045*a164);
  a008=(a008*a025);
  a045=(a045-a008);
  if (res[1]!=0) res[1][0]=a045;
  a043=(a043*a164);
  a014=(a014*a025);
  a043=(a043+a014);
  a043=(-a043);
  if (res[1]!=0) res[1][1]=a043;
  a187=(a187*a426);
  a185=(a185*a187);
  a185=(a223+a185);
  a026=(2.*a026);
  a026=(a026+a084);
  a017=(2.*a017);
  a026=(a026+a017);
  a026=(a026+a140);
  a140=(a026/a023);
  a185=(a185+a140);
  if (res[1]!=0) res[1][2]=a185;
  a180=(a180*a251);
  a183=(a183*a180);
  a251=arg[4]? arg[4][24] : 0;
  a185=(a124<=a112);
  a112=(a112<=a124);
  a124=(a112+a185);
  a185=(a185/a124);
  a140=(a113<=a125);
  a125=(a125<=a113);
  a113=(a125+a140);
  a140=(a140/a113);
  a017=(a057<=a111);
  a111=(a111<=a057);
  a111=(a111+a017);
  a017=(a017/a111);
  a111=arg[4]? arg[4][25] : 0;
  a121=(a121*a435);
  a139=(a139*a121);
  a435=(a021*a139);
  a136=(a136*a435);
  a136=(a027*a136);
  a111=(a111+a136);
  a134=(a134*a111);
  a134=(a027*a134);
  a135=(a135*a111);
  a135=(a056*a135);
  a133=(a133*a135);
  a134=(a134-a133);
  a133=(2.*a126);
  a126=(a126*a135);
  a133=(a133*a126);
  a134=(a134-a133);
  a017=(a017*a134);
  a134=(a060*a017);
  a134=(a134+a111);
  a133=(a057<=a127);
  a127=(a127<=a057);
  a127=(a127+a133);
  a133=(a133/a127);
  a131=(a131*a111);
  a131=(a056*a131);
  a129=(a129*a131);
  a130=(a130*a111);
  a130=(a027*a130);
  a129=(a129-a130);
  a130=(2.*a128);
  a128=(a128*a131);
  a130=(a130*a128);
  a129=(a129+a130);
  a133=(a133*a129);
  a129=(a060*a133);
  a134=(a134-a129);
  a140=(a140*a134);
  a185=(a185*a140);
  a114=(a114*a185);
  a251=(a251+a114);
  a116=(a116*a251);
  a183=(a183+a116);
  if (res[1]!=0) res[1][3]=a183;
  a388=(a388*a331);
  if (res[1]!=0) res[1][4]=a388;
  a294=(a294*a293);
  if (res[1]!=0) res[1][5]=a294;
  a294=cos(a065);
  a269=(a269*a190);
  a016=(a269*a016);
  a388=(a016*a055);
  a274=(a388*a274);
  a294=(a294*a274);
  a274=cos(a065);
  a216=(a016*a216);
  a216=(a216*a208);
  a274=(a274*a216);
  a294=(a294-a274);
  a274=sin(a065);
  a196=(a196*a190);
  a216=(a196*a089);
  a207=(a216*a207);
  a274=(a274*a207);
  a294=(a294-a274);
  a274=sin(a065);
  a207=(a016*a055);
  a278=(a207*a278);
  a278=(a278*a076);
  a274=(a274*a278);
  a294=(a294-a274);
  a274=cos(a065);
  a278=(a196*a055);
  a212=(a278*a212);
  a274=(a274*a212);
  a294=(a294+a274);
  a274=sin(a065);
  a282=(a016*a282);
  a274=(a274*a282);
  a294=(a294+a274);
  a274=cos(a065);
  a217=(a196*a217);
  a274=(a274*a217);
  a294=(a294-a274);
  a274=sin(a065);
  a221=(a196*a221);
  a274=(a274*a221);
  a294=(a294+a274);
  a274=cos(a065);
  a223=(a016*a223);
  a274=(a274*a223);
  a294=(a294+a274);
  a274=cos(a065);
  a223=(a093*a228);
  a274=(a274*a223);
  a294=(a294+a274);
  a274=sin(a065);
  a228=(a002*a228);
  a274=(a274*a228);
  a294=(a294-a274);
  a274=cos(a065);
  a002=(a002*a028);
  a274=(a274*a002);
  a294=(a294-a274);
  a065=sin(a065);
  a093=(a093*a028);
  a065=(a065*a093);
  a294=(a294-a065);
  a063=(a063*a294);
  a061=(a061*a063);
  a440=(a440*a412);
  a052=(a052*a033);
  a440=(a440-a052);
  a408=(a408*a415);
  a440=(a440+a408);
  a051=(a051*a440);
  a061=(a061-a051);
  if (res[1]!=0) res[1][6]=a061;
  if (res[1]!=0) res[1][7]=a063;
  if (res[1]!=0) res[1][8]=a440;
  a332=(a332*a412);
  a411=(a411*a413);
  a332=(a332+a411);
  if (res[1]!=0) res[1][9]=a332;
  a332=sin(a036);
  a332=(a332*a076);
  a411=(a039*a332);
  a041=(a041*a079);
  a411=(a411-a041);
  a411=(a411+a082);
  if (res[1]!=0) res[1][10]=a411;
  a438=(a438*a383);
  a444=(a438*a444);
  a366=(a366*a290);
  a314=(a366*a314);
  a411=(a314*a208);
  a299=(a299*a290);
  a319=(a299*a319);
  a290=(a319*a208);
  a411=(a411+a290);
  a382=(a382*a383);
  a405=(a382*a405);
  a383=(a405*a208);
  a411=(a411+a383);
  a313=(a299*a313);
  a383=(a313*a076);
  a411=(a411+a383);
  a315=(a315*a411);
  a444=(a444-a315);
  a376=(a366*a376);
  a444=(a444+a376);
  a449=(a438*a449);
  a444=(a444+a449);
  a401=(a382*a401);
  a444=(a444+a401);
  a377=(a366*a377);
  a313=(a313-a377);
  a313=(a313*a079);
  a402=(a382*a402);
  a450=(a438*a450);
  a401=(a402+a450);
  a401=(a401*a079);
  a313=(a313-a401);
  a284=(a110*a284);
  a313=(a313+a284);
  a225=(a034*a225);
  a313=(a313+a225);
  a091=(a091/a184);
  a091=(a091*a108);
  a170=(a170/a184);
  a170=(a170*a454);
  a091=(a091-a170);
  a313=(a313+a091);
  a166=(a166*a313);
  a444=(a444+a166);
  if (res[2]!=0) res[2][0]=a444;
  a444=cos(a036);
  a388=(a388*a273);
  a388=(a388*a208);
  a444=(a444*a388);
  a388=cos(a036);
  a219=(a196*a219);
  a273=(a055*a219);
  a273=(a273*a208);
  a388=(a388*a273);
  a444=(a444-a388);
  a388=sin(a036);
  a273=(a366*a168);
  a370=(a273*a370);
  a370=(a370*a208);
  a388=(a388*a370);
  a444=(a444-a388);
  a388=cos(a036);
  a370=(a438*a165);
  a443=(a370*a443);
  a388=(a388*a443);
  a444=(a444+a388);
  a388=sin(a036);
  a216=(a216*a206);
  a216=(a216*a208);
  a388=(a388*a216);
  a444=(a444-a388);
  a388=sin(a036);
  a216=(a299*a168);
  a307=(a216*a307);
  a388=(a388*a307);
  a444=(a444-a388);
  a388=sin(a036);
  a307=(a382*a168);
  a396=(a307*a396);
  a388=(a388*a396);
  a444=(a444-a388);
  a388=cos(a036);
  a411=(a165*a411);
  a388=(a388*a411);
  a444=(a444-a388);
  a388=sin(a036);
  a277=(a016*a277);
  a281=(a016*a281);
  a411=(a281*a076);
  a277=(a277+a411);
  a214=(a196*a214);
  a411=(a214*a076);
  a277=(a277+a411);
  a411=(a089*a277);
  a388=(a388*a411);
  a444=(a444+a388);
  a388=sin(a036);
  a446=(a438*a446);
  a411=(a450*a076);
  a446=(a446+a411);
  a411=(a402*a076);
  a446=(a446+a411);
  a411=(a377*a076);
  a446=(a446+a411);
  a411=(a168*a446);
  a388=(a388*a411);
  a444=(a444+a388);
  a388=cos(a036);
  a207=(a207*a279);
  a388=(a388*a207);
  a444=(a444+a388);
  a388=cos(a036);
  a207=(a366*a165);
  a375=(a207*a375);
  a388=(a388*a375);
  a444=(a444+a388);
  a388=cos(a036);
  a375=(a438*a165);
  a448=(a375*a448);
  a388=(a388*a448);
  a444=(a444+a388);
  a388=cos(a036);
  a278=(a278*a211);
  a278=(a278*a076);
  a388=(a388*a278);
  a444=(a444+a388);
  a388=sin(a036);
  a278=(a299*a168);
  a310=(a278*a310);
  a310=(a310*a076);
  a388=(a388*a310);
  a444=(a444-a388);
  a388=cos(a036);
  a310=(a382*a165);
  a400=(a310*a400);
  a388=(a388*a400);
  a444=(a444+a388);
  a388=sin(a036);
  a073=(a073*a018);
  a018=(a073*a035);
  a018=(a018*a076);
  a388=(a388*a018);
  a444=(a444+a388);
  a388=cos(a036);
  a018=(a073*a039);
  a018=(a018*a076);
  a388=(a388*a018);
  a444=(a444-a388);
  a388=cos(a036);
  a018=arg[1]? arg[1][10] : 0;
  a400=(a018*a039);
  a400=(a400*a076);
  a388=(a388*a400);
  a444=(a444+a388);
  a388=sin(a036);
  a400=(a018*a079);
  a042=(a034*a042);
  a211=(a073*a079);
  a042=(a042-a211);
  a400=(a400+a042);
  a039=(a039*a400);
  a388=(a388*a039);
  a444=(a444+a388);
  a388=cos(a036);
  a035=(a035*a042);
  a388=(a388*a035);
  a444=(a444+a388);
  a388=arg[4]? arg[4][12] : 0;
  a444=(a444+a388);
  a388=cos(a036);
  a168=(a168*a313);
  a388=(a388*a168);
  a444=(a444+a388);
  a388=sin(a036);
  a165=(a165*a313);
  a388=(a388*a165);
  a444=(a444-a388);
  a388=sin(a036);
  a186=(a186*a426);
  a388=(a388*a186);
  a444=(a444-a388);
  a182=(a182*a180);
  a444=(a444+a182);
  a182=cos(a036);
  a422=(a141*a422);
  a388=(a141*a208);
  a388=(a422-a388);
  a174=(a174*a388);
  a182=(a182*a174);
  a444=(a444+a182);
  a182=sin(a036);
  a141=(a141*a208);
  a422=(a422-a141);
  a171=(a171*a422);
  a182=(a182*a171);
  a444=(a444-a182);
  a182=cos(a036);
  a094=(a034*a094);
  a171=(a214+a281);
  a171=(a171*a079);
  a141=(a094-a171);
  a141=(a141-a091);
  a110=(a110*a381);
  a141=(a141-a110);
  a089=(a089*a141);
  a182=(a182*a089);
  a444=(a444+a182);
  a182=sin(a036);
  a094=(a094-a171);
  a094=(a094-a091);
  a094=(a094-a110);
  a055=(a055*a094);
  a182=(a182*a055);
  a444=(a444-a182);
  a182=(a144<=a030);
  a030=(a030<=a144);
  a144=(a030+a182);
  a182=(a182/a144);
  a055=(a143<=a146);
  a146=(a146<=a143);
  a143=(a146+a055);
  a055=(a055/a143);
  a110=(a057<=a142);
  a142=(a142<=a057);
  a142=(a142+a110);
  a110=(a110/a142);
  a153=(2.*a153);
  a106=(a161*a106);
  a363=(a363*a106);
  a153=(a153*a363);
  a363=arg[4]? arg[4][14] : 0;
  a153=(a153+a363);
  a179=(a161*a179);
  a153=(a153+a179);
  a155=(a155*a153);
  a155=(a027*a155);
  a156=(a156*a153);
  a156=(a056*a156);
  a154=(a154*a156);
  a155=(a155-a154);
  a154=(2.*a147);
  a147=(a147*a156);
  a154=(a154*a147);
  a155=(a155-a154);
  a110=(a110*a155);
  a155=(a060*a110);
  a155=(a155+a153);
  a154=(a057<=a148);
  a148=(a148<=a057);
  a148=(a148+a154);
  a154=(a154/a148);
  a152=(a152*a153);
  a056=(a056*a152);
  a150=(a150*a056);
  a151=(a151*a153);
  a151=(a027*a151);
  a150=(a150-a151);
  a151=(2.*a149);
  a149=(a149*a056);
  a151=(a151*a149);
  a150=(a150+a151);
  a154=(a154*a150);
  a060=(a060*a154);
  a155=(a155-a060);
  a055=(a055*a155);
  a182=(a182*a055);
  a145=(a145*a182);
  a444=(a444+a145);
  a118=(a118*a251);
  a444=(a444+a118);
  if (res[2]!=0) res[2][1]=a444;
  a444=cos(a101);
  a273=(a273*a371);
  a444=(a444*a273);
  a273=cos(a101);
  a379=(a438*a379);
  a379=(a379*a208);
  a273=(a273*a379);
  a444=(a444-a273);
  a273=cos(a101);
  a370=(a370*a442);
  a370=(a370*a208);
  a273=(a273*a370);
  a444=(a444+a273);
  a273=sin(a101);
  a216=(a216*a306);
  a216=(a216*a208);
  a273=(a273*a216);
  a444=(a444-a273);
  a273=sin(a101);
  a307=(a307*a395);
  a307=(a307*a208);
  a273=(a273*a307);
  a444=(a444-a273);
  a273=sin(a101);
  a207=(a207*a374);
  a207=(a207*a076);
  a273=(a273*a207);
  a444=(a444-a273);
  a273=sin(a101);
  a375=(a375*a447);
  a375=(a375*a076);
  a273=(a273*a375);
  a444=(a444-a273);
  a273=cos(a101);
  a278=(a278*a311);
  a273=(a273*a278);
  a444=(a444+a273);
  a273=cos(a101);
  a310=(a310*a399);
  a310=(a310*a076);
  a273=(a273*a310);
  a444=(a444+a273);
  a273=cos(a101);
  a317=(a299*a317);
  a273=(a273*a317);
  a444=(a444+a273);
  a273=sin(a101);
  a451=(a438*a451);
  a273=(a273*a451);
  a444=(a444+a273);
  a273=cos(a101);
  a403=(a382*a403);
  a273=(a273*a403);
  a444=(a444-a273);
  a273=sin(a101);
  a380=(a366*a380);
  a273=(a273*a380);
  a444=(a444+a273);
  a273=cos(a101);
  a082=(a299*a082);
  a273=(a273*a082);
  a444=(a444+a273);
  a273=cos(a101);
  a320=(a366*a320);
  a273=(a273*a320);
  a444=(a444+a273);
  a273=sin(a101);
  a321=(a299*a321);
  a273=(a273*a321);
  a444=(a444-a273);
  a273=cos(a101);
  a406=(a438*a406);
  a273=(a273*a406);
  a444=(a444+a273);
  a273=sin(a101);
  a316=(a382*a316);
  a273=(a273*a316);
  a444=(a444+a273);
  a273=sin(a101);
  a266=(a266*a326);
  a273=(a273*a266);
  a444=(a444-a273);
  a273=cos(a101);
  a202=(a202*a059);
  a273=(a273*a202);
  a444=(a444+a273);
  a273=sin(a101);
  a059=(a237*a059);
  a273=(a273*a059);
  a444=(a444-a273);
  a273=sin(a101);
  a349=(a349*a200);
  a273=(a273*a349);
  a444=(a444-a273);
  a273=cos(a101);
  a099=(a237*a099);
  a273=(a273*a099);
  a444=(a444+a273);
  a273=cos(a101);
  a098=(a098*a271);
  a273=(a273*a098);
  a444=(a444-a273);
  a101=sin(a101);
  a237=(a237*a271);
  a101=(a101*a237);
  a444=(a444-a101);
  if (res[2]!=0) res[2][2]=a444;
  a444=(a319+a314);
  a444=(a444*a079);
  a444=(a027*a444);
  a438=(a438*a404);
  a405=(a405-a438);
  a079=(a405*a079);
  a079=(a027*a079);
  a444=(a444-a079);
  a252=(a252*a347);
  a444=(a444+a252);
  if (res[2]!=0) res[2][3]=a444;
  a366=(a366*a372);
  a308=(a299*a308);
  a366=(a366+a308);
  a382=(a382*a397);
  a366=(a366+a382);
  a378=(a378*a446);
  a366=(a366-a378);
  a312=(a299*a312);
  a366=(a366+a312);
  a169=(a169*a313);
  a366=(a366+a169);
  if (res[2]!=0) res[2][4]=a366;
  a366=(2.*a095);
  a102=(a102+a232);
  a102=(a102+a323);
  a250=(a250*a102);
  a366=(a366*a250);
  a250=(2.*a095);
  a096=(2.*a096);
  a096=(a096*a249);
  a250=(a250*a096);
  a096=(2.*a095);
  a292=(2.*a292);
  a292=(a292*a348);
  a096=(a096*a292);
  a250=(a250+a096);
  a095=(2.*a095);
  a226=(2.*a226);
  a226=(a226*a421);
  a095=(a095*a226);
  a250=(a250+a095);
  a366=(a366-a250);
  if (res[2]!=0) res[2][5]=a366;
  a024=(a024/a023);
  a024=(a024*a026);
  a026=(a022*a024);
  a026=(-a026);
  if (res[2]!=0) res[2][6]=a026;
  a072=(a072*a074);
  a157=(a157*a034);
  a329=(a157*a329);
  a072=(a072+a329);
  a160=(a160*a423);
  a072=(a072+a160);
  a137=(a137*a139);
  a072=(a072+a137);
  a137=(2.*a021);
  a020=(a020*a024);
  a022=(2.*a022);
  a020=(a020/a022);
  a137=(a137*a020);
  a072=(a072-a137);
  if (res[2]!=0) res[2][7]=a072;
  a123=(a123*a251);
  a123=(-a123);
  if (res[2]!=0) res[2][8]=a123;
  if (res[2]!=0) res[2][9]=a251;
  a251=(a115*a251);
  if (res[2]!=0) res[2][10]=a251;
  a117=(a117*a185);
  if (res[2]!=0) res[2][11]=a117;
  a017=(a058*a017);
  a133=(a058*a133);
  a017=(a017+a133);
  a112=(a112/a124);
  a112=(a112*a140);
  a125=(a125/a113);
  a125=(a125*a134);
  a112=(a112-a125);
  a017=(a017+a112);
  if (res[2]!=0) res[2][12]=a017;
  a132=(a132*a435);
  if (res[2]!=0) res[2][13]=a132;
  a138=(a138*a121);
  if (res[2]!=0) res[2][14]=a138;
  a387=(a387*a394);
  a163=(a163*a387);
  a046=(a046*a012);
  a046=(a027*a046);
  a163=(a163+a046);
  if (res[2]!=0) res[2][15]=a163;
  if (res[2]!=0) res[2][16]=a180;
  a163=(a036*a180);
  if (res[2]!=0) res[2][17]=a163;
  a115=(a115*a180);
  if (res[2]!=0) res[2][18]=a115;
  a181=(a161*a181);
  if (res[2]!=0) res[2][19]=a181;
  if (res[2]!=0) res[2][20]=a182;
  a036=(a036*a182);
  if (res[2]!=0) res[2][21]=a036;
  a110=(a058*a110);
  a154=(a058*a154);
  a110=(a110+a154);
  a030=(a030/a144);
  a030=(a030*a055);
  a146=(a146/a143);
  a146=(a146*a155);
  a030=(a030-a146);
  a110=(a110+a030);
  if (res[2]!=0) res[2][22]=a110;
  if (res[2]!=0) res[2][23]=a106;
  a325=(a325*a106);
  if (res[2]!=0) res[2][24]=a325;
  a275=(a016*a275);
  a220=(a219*a220);
  a275=(a275-a220);
  a280=(a016*a280);
  a275=(a275+a280);
  a213=(a196*a213);
  a275=(a275+a213);
  a069=(a069*a094);
  a275=(a275+a069);
  if (res[2]!=0) res[2][25]=a275;
  a275=(a081*a159);
  if (res[2]!=0) res[2][26]=a275;
  a109=(a109*a159);
  a159=(a018-a073);
  a299=(a299*a318);
  a159=(a159+a299);
  a157=(a157*a021);
  a334=(a334*a157);
  a392=(a161*a392);
  a334=(a334+a392);
  a159=(a159+a334);
  a159=(a159-a377);
  a159=(a159-a402);
  a159=(a159-a450);
  a159=(a159-a214);
  a159=(a159-a281);
  a159=(a159/a081);
  a159=(a159/a081);
  a159=(a159*a080);
  a016=(a016*a218);
  a016=(a016+a019);
  a016=(a016-a219);
  a016=(a016-a405);
  a016=(a016-a319);
  a016=(a016-a314);
  a016=(a016-a335);
  a016=(a016/a081);
  a016=(a016/a081);
  a016=(a016*a222);
  a159=(a159+a016);
  a109=(a109-a159);
  if (res[2]!=0) res[2][27]=a109;
  a172=(a172*a422);
  if (res[2]!=0) res[2][28]=a172;
  a175=(a175*a388);
  if (res[2]!=0) res[2][29]=a175;
  a196=(a196*a209);
  a215=(a215*a277);
  a196=(a196-a215);
  a090=(a090*a141);
  a196=(a196+a090);
  if (res[2]!=0) res[2][30]=a196;
  a019=(a019*a187);
  if (res[2]!=0) res[2][31]=a019;
  a019=(a369+a452);
  if (res[2]!=0) res[2][32]=a019;
  a369=(a236*a369);
  a452=(a236*a452);
  a369=(a369+a452);
  if (res[2]!=0) res[2][33]=a369;
  a369=(a322+a407);
  if (res[2]!=0) res[2][34]=a369;
  a322=(a236*a322);
  a236=(a236*a407);
  a322=(a322+a236);
  if (res[2]!=0) res[2][35]=a322;
  a330=(a330*a445);
  if (res[2]!=0) res[2][36]=a330;
  a355=(a355*a333);
  a358=(a358/a337);
  a358=(a358*a368);
  a355=(a355-a358);
  a359=(a353*a359);
  a355=(a355+a359);
  a427=(a427*a336);
  a355=(a355+a427);
  a430=(a430/a337);
  a430=(a430*a431);
  a355=(a355-a430);
  a338=(a425*a338);
  a355=(a355+a338);
  a342=(a342/a341);
  a227=(a227/a286);
  a227=(a227*a296);
  a352=(a352/a343);
  a352=(a352*a356);
  a227=(a227-a352);
  a230=(a230/a324);
  a230=(a230*a367);
  a227=(a227+a230);
  a424=(a424/a419);
  a424=(a424*a428);
  a227=(a227-a424);
  a342=(a342*a227);
  a227=(a340*a342);
  a355=(a355-a227);
  if (res[2]!=0) res[2][37]=a355;
  a357=(a357*a333);
  a353=(a353*a368);
  a357=(a357-a353);
  a429=(a429*a336);
  a357=(a357+a429);
  a425=(a425*a431);
  a357=(a357-a425);
  a425=(a003<=a339);
  a339=(a339<=a003);
  a339=(a339+a425);
  a425=(a425/a339);
  a337=(a337*a342);
  a340=(2.*a340);
  a337=(a337/a340);
  a425=(a425*a337);
  a357=(a357-a425);
  if (res[2]!=0) res[2][38]=a357;
  a360=(a360*a361);
  a432=(a432*a433);
  a360=(a360+a432);
  if (res[2]!=0) res[2][39]=a360;
  a362=(a362*a364);
  a434=(a434*a436);
  a362=(a362+a434);
  if (res[2]!=0) res[2][40]=a362;
  a331=(a331-a303);
  if (res[2]!=0) res[2][41]=a331;
  a285=(a285*a373);
  if (res[2]!=0) res[2][42]=a285;
  a293=(a293-a233);
  if (res[2]!=0) res[2][43]=a293;
  a063=(a050*a063);
  if (res[2]!=0) res[2][44]=a063;
  a269=(a269*a276);
  a015=(a015*a294);
  a269=(a269+a015);
  a269=(-a269);
  if (res[2]!=0) res[2][45]=a269;
  if (res[2]!=0) res[2][46]=a272;
  a272=(a188*a272);
  if (res[2]!=0) res[2][47]=a272;
  if (res[2]!=0) res[2][48]=a224;
  a188=(a188*a224);
  if (res[2]!=0) res[2][49]=a188;
  a189=(a189*a283);
  if (res[2]!=0) res[2][50]=a189;
  a261=(a261*a238);
  a259=(a259/a239);
  a259=(a259*a262);
  a261=(a261-a259);
  a240=(a256*a240);
  a261=(a261+a240);
  a244=(a244/a243);
  a097=(a097/a103);
  a097=(a097*a193);
  a255=(a255/a245);
  a255=(a255*a257);
  a097=(a097-a255);
  a244=(a244*a097);
  a097=(a242*a244);
  a261=(a261-a097);
  if (res[2]!=0) res[2][51]=a261;
  a258=(a258*a238);
  a256=(a256*a262);
  a258=(a258-a256);
  a256=(a003<=a241);
  a241=(a241<=a003);
  a241=(a241+a256);
  a256=(a256/a241);
  a239=(a239*a244);
  a242=(2.*a242);
  a239=(a239/a242);
  a256=(a256*a239);
  a258=(a258-a256);
  if (res[2]!=0) res[2][52]=a258;
  a263=(a263*a264);
  if (res[2]!=0) res[2][53]=a263;
  a265=(a265*a267);
  if (res[2]!=0) res[2][54]=a265;
  a192=(a192/a190);
  if (res[2]!=0) res[2][55]=a192;
  a050=(a050*a440);
  a050=(-a050);
  if (res[2]!=0) res[2][56]=a050;
  a050=(a398*a415);
  if (res[2]!=0) res[2][57]=a050;
  a414=(a157*a414);
  a050=(a460*a414);
  if (res[2]!=0) res[2][58]=a050;
  a415=(a049*a415);
  if (res[2]!=0) res[2][59]=a415;
  a393=(a161*a393);
  a161=(a161*a268);
  a393=(a393+a161);
  a460=(2.*a460);
  a270=(a157*a270);
  a460=(a460*a270);
  a393=(a393+a460);
  a365=(a365*a414);
  a393=(a393+a365);
  if (res[2]!=0) res[2][60]=a393;
  a393=(a201*a413);
  if (res[2]!=0) res[2][61]=a393;
  a413=(a398*a413);
  if (res[2]!=0) res[2][62]=a413;
  a088=(a088*a157);
  a409=(a088*a409);
  if (res[2]!=0) res[2][63]=a409;
  a201=(a201*a412);
  if (res[2]!=0) res[2][64]=a201;
  a398=(a398*a412);
  if (res[2]!=0) res[2][65]=a398;
  a088=(a088*a410);
  if (res[2]!=0) res[2][66]=a088;
  a412=(a049*a412);
  if (res[2]!=0) res[2][67]=a412;
  a018=(a018*a332);
  a078=(a073*a078);
  a018=(a018-a078);
  a040=(a040*a400);
  a018=(a018-a040);
  if (res[2]!=0) res[2][68]=a018;
  a037=(a037*a042);
  a073=(a073*a075);
  a037=(a037-a073);
  if (res[2]!=0) res[2][69]=a037;
  a087=(a058*a087);
  a058=(a058*a067);
  a087=(a087+a058);
  a031=(a031/a053);
  a031=(a031*a086);
  a054=(a054/a032);
  a054=(a054*a068);
  a031=(a031-a054);
  a087=(a087+a031);
  if (res[2]!=0) res[2][70]=a087;
  a048=(a048*a085);
  if (res[2]!=0) res[2][71]=a048;
  a049=(a049*a033);
  a049=(-a049);
  if (res[2]!=0) res[2][72]=a049;
  a066=(a066*a071);
  a027=(a027*a066);
  if (res[2]!=0) res[2][73]=a027;
  a070=(a070*a029);
  if (res[2]!=0) res[2][74]=a070;
  a007=(-a007);
  if (res[2]!=0) res[2][75]=a007;
  a007=-5.0000000000000000e-01;
  a007=(a007*a167);
  if (res[2]!=0) res[2][76]=a007;
  a100=(-a100);
  if (res[2]!=0) res[2][77]=a100;
  if (res[2]!=0) res[2][78]=a057;
  return 0;
}

CASADI_SYMBOL_EXPORT int adj1_rollout_outputs(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f6(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int adj1_rollout_outputs_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void adj1_rollout_outputs_release(int mem) {
}

CASADI_SYMBOL_EXPORT void adj1_rollout_outputs_incref(void) {
}

CASADI_SYMBOL_EXPORT void adj1_rollout_outputs_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int adj1_rollout_outputs_n_in(void) { return 5;}

CASADI_SYMBOL_EXPORT casadi_int adj1_rollout_outputs_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real adj1_rollout_outputs_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* adj1_rollout_outputs_name_in(casadi_int i) {
  switch (i) {
    case 0: return "x";
    case 1: return "u";
    case 2: return "p";
    case 3: return "out_y";
    case 4: return "adj_y";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* adj1_rollout_outputs_name_out(casadi_int i) {
  switch (i) {
    case 0: return "adj_x";
    case 1: return "adj_u";
    case 2: return "adj_p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* adj1_rollout_outputs_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    case 3: return casadi_s7;
    case 4: return casadi_s6;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* adj1_rollout_outputs_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int adj1_rollout_outputs_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int adj1_rollout_outputs_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* fwd1_adj1_rollout_outputs:(x[6],u[11],p[79],out_y[39x1,0nz],adj_y[39],out_adj_x[6x1,0nz],out_adj_u[11x1,0nz],out_adj_p[79x1,0nz],fwd_x[6],fwd_u[11],fwd_p[79],fwd_out_y[39x1,0nz],fwd_adj_y[39])->(fwd_adj_x[6],fwd_adj_u[11],fwd_adj_p[79]) */
static int casadi_f7(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
  casadi_real a204, a205, a206, a207, a208, a209, a210, a211, a212, a213, a214, a215;
  casadi_real a216, a217, a218, a219, a220, a221, a222, a223, a224, a225, a226, a227;
  casadi_real a228, a229, a230, a231, a232, a233, a234, a235, a236, a237, a238, a239;
  casadi_real a240, a241, a242, a243, a244, a245, a246, a247, a248, a249, a250, a251;
  casadi_real a252, a253, a254, a255, a256, a257, a258, a259, a260, a261, a262, a263;
  casadi_real a264, a265, a266, a267, a268, a269, a270, a271, a272, a273, a274, a275;
  casadi_real a276, a277, a278, a279, a280, a281, a282, a283, a284, a285, a286, a287;
  casadi_real a288, a289, a290, a291, a292, a293, a294, a295, a296, a297, a298, a299;
  casadi_real a300, a301, a302, a303, a304, a305, a306, a307, a308, a309, a310, a311;
  casadi_real a312, a313, a314, a315, a316, a317, a318, a319, a320, a321, a322, a323;
  casadi_real a324, a325, a326, a327, a328, a329, a330, a331, a332, a333, a334, a335;
  casadi_real a336, a337, a338, a339, a340, a341, a342, a343, a344, a345, a346, a347;
  casadi_real a348, a349, a350, a351, a352, a353, a354, a355, a356, a357, a358, a359;
  casadi_real a360, a361, a362, a363, a364, a365, a366, a367, a368, a369, a370, a371;
  casadi_real a372, a373, a374, a375, a376, a377, a378, a379, a380, a381, a382, a383;
  casadi_real a384, a385, a386, a387, a388, a389, a390, a391, a392, a393, a394, a395;
  casadi_real a396, a397, a398, a399, a400, a401, a402, a403, a404, a405, a406, a407;
  casadi_real a408, a409, a410, a411, a412, a413, a414, a415, a416, a417, a418, a419;
  casadi_real a420, a421, a422, a423, a424, a425, a426, a427, a428, a429, a430, a431;
  casadi_real a432, a433, a434, a435, a436, a437, a438, a439, a440, a441, a442, a443;
  casadi_real a444, a445, a446, a447, a448, a449, a450, a451, a452, a453, a454, a455;
  casadi_real a456, a457, a458, a459, a460, a461, a462, a463, a464, a465, a466, a467;
  casadi_real a468, a469, a470, a471, a472, a473, a474, a475, a476, a477, a478, a479;
  casadi_real a480, a481, a482, a483, a484, a485, a486, a487, a488, a489, a490, a491;
  casadi_real a492, a493, a494, a495, a496, a497, a498, a499, a500, a501, a502, a503;
  casadi_real a504, a505, a506, a507, a508, a509, a510, a511, a512, a513, a514, a515;
  casadi_real a516, a517, a518, a519, a520, a521, a522, a523, a524, a525, a526, a527;
  casadi_real a528, a529, a530, a531, a532, a533, a534, a535, a536, a537, a538, a539;
  casadi_real a540, a541, a542, a543, a544, a545, a546, a547, a548, a549, a550, a551;
  casadi_real a552, a553, a554, a555, a556, a557, a558, a559, a560, a561, a562, a563;
  casadi_real a564, a565, a566, a567, a568, a569, a570, a571, a572, a573, a574, a575;
  casadi_real a576, a577, a578, a579, a580, a581, a582, a583, a584, a585, a586, a587;
  casadi_real a588, a589, a590, a591, a592, a593, a594, a595, a596, a597, a598, a599;
  casadi_real a600, a601, a602, a603, a604, a605, a606, a607, a608, a609, a610, a611;
  casadi_real a612, a613, a614, a615, a616, a617, a618, a619, a620, a621, a622, a623;
  casadi_real a624, a625, a626, a627, a628, a629, a630, a631, a632, a633, a634, a635;
  casadi_real a636, a637, a638, a639, a640, a641, a642, a643, a644, a645, a646, a647;
  casadi_real a648, a649, a650, a651, a652, a653, a654, a655, a656, a657, a658, a659;
  casadi_real a660, a661, a662, a663, a664, a665, a666, a667, a668, a669, a670, a671;
  casadi_real a672, a673, a674, a675, a676, a677, a678, a679, a680, a681, a682, a683;
  casadi_real a684, a685, a686, a687, a688, a689, a690, a691, a692, a693, a694, a695;
  casadi_real a696, a697, a698, a699, a700, a701, a702, a703, a704, a705, a706, a707;
  casadi_real a708, a709, a710, a711, a712, a713, a714, a715, a716, a717, a718, a719;
  casadi_real a720, a721, a722, a723, a724, a725, a726, a727, a728, a729, a730, a731;
  casadi_real a732, a733, a734, a735, a736, a737, a738, a739, a740, a741, a742, a743;
  casadi_real a744, a745, a746, a747, a748, a749, a750, a751, a752, a753, a754, a755;
  casadi_real a756, a757, a758, a759, a760, a761, a762, a763, a764, a765, a766, a767;
  casadi_real a768, a769, a770, a771, a772, a773, a774, a775, a776, a777, a778, a779;
  casadi_real a780, a781, a782, a783, a784, a785, a786, a787, a788, a789, a790, a791;
  casadi_real a792, a793, a794, a795, a796, a797, a798, a799, a800, a801, a802, a803;
  casadi_real a804, a805, a806, a807, a808, a809, a810, a811, a812, a813, a814, a815;
  casadi_real a816, a817, a818, a819, a820, a821, a822, a823, a824, a825, a826, a827;
  casadi_real a828, a829, a830, a831, a832, a833, a834, a835, a836, a837, a838, a839;
  casadi_real a840, a841, a842, a843, a844, a845, a846, a847, a848, a849, a850, a851;
  casadi_real a852, a853, a854, a855, a856, a857, a858, a859, a860, a861, a862, a863;
  casadi_real a864, a865, a866, a867, a868, a869, a870, a871, a872, a873, a874, a875;
  casadi_real a876, a877, a878, a879, a880, a881, a882, a883, a884, a885, a886, a887;
  casadi_real a888;
  a000=arg[0]? arg[0][5] : 0;
  a001=cos(a000);
  a002=arg[4]? arg[4][36] : 0;
  a003=arg[4]? arg[4][27] : 0;
  a002=(a002+a003);
  a003=arg[0]? arg[0][0] : 0;
  a004=sin(a000);
  a005=(a003*a004);
  a006=arg[0]? arg[0][1] : 0;
  a007=cos(a000);
  a008=(a006*a007);
  a005=(a005+a008);
  a008=casadi_sq(a005);
  a009=(a003*a001);
  a010=sin(a000);
  a011=(a006*a010);
  a009=(a009-a011);
  a011=casadi_sq(a009);
  a008=(a008+a011);
  a011=9.9999999999999998e-13;
  a008=(a008+a011);
  a008=sqrt(a008);
  a012=(2.*a008);
  a002=(a002/a012);
  a013=arg[8]? arg[8][0] : 0;
  a014=(a001*a013);
  a015=sin(a000);
  a016=arg[8]? arg[8][5] : 0;
  a015=(a015*a016);
  a017=(a003*a015);
  a014=(a014-a017);
  a017=arg[8]? arg[8][1] : 0;
  a018=(a010*a017);
  a019=cos(a000);
  a019=(a019*a016);
  a020=(a006*a019);
  a018=(a018+a020);
  a014=(a014-a018);
  a018=(2.*a014);
  a018=(a002*a018);
  a020=(2.*a009);
  a021=arg[12]? arg[12][36] : 0;
  a022=arg[12]? arg[12][27] : 0;
  a022=(a021+a022);
  a022=(a022/a012);
  a012=(a002/a012);
  a023=(2.*a005);
  a024=(a004*a013);
  a025=cos(a000);
  a025=(a025*a016);
  a026=(a003*a025);
  a024=(a024+a026);
  a026=(a007*a017);
  a027=sin(a000);
  a027=(a027*a016);
  a028=(a006*a027);
  a026=(a026-a028);
  a024=(a024+a026);
  a023=(a023*a024);
  a009=(2.*a009);
  a009=(a009*a014);
  a023=(a023+a009);
  a008=(2.*a008);
  a023=(a023/a008);
  a023=(2.*a023);
  a012=(a012*a023);
  a022=(a022-a012);
  a012=(a020*a022);
  a018=(a018+a012);
  a001=(a001*a018);
  a020=(a020*a002);
  a015=(a020*a015);
  a001=(a001-a015);
  a005=(2.*a005);
  a015=(a005*a002);
  a025=(a015*a025);
  a024=(2.*a024);
  a002=(a002*a024);
  a005=(a005*a022);
  a002=(a002+a005);
  a004=(a004*a002);
  a025=(a025+a004);
  a001=(a001+a025);
  a025=arg[1]? arg[1][0] : 0;
  a004=cos(a000);
  a005=(a025*a004);
  a022=arg[1]? arg[1][1] : 0;
  a024=sin(a000);
  a012=(a022*a024);
  a005=(a005+a012);
  a012=(a003-a005);
  a023=casadi_sq(a012);
  a008=1.0000000000000000e-04;
  a023=(a023+a008);
  a023=sqrt(a023);
  a009=(a012*a023);
  a014=arg[1]? arg[1][2] : 0;
  a026=arg[2]? arg[2][6] : 0;
  a028=arg[2]? arg[2][7] : 0;
  a029=casadi_sq(a028);
  a029=(a029+a011);
  a029=sqrt(a029);
  a030=(a026*a029);
  a031=(a014/a030);
  a032=(2.*a031);
  a032=(a009+a032);
  a033=(2.*a032);
  a034=5.0000000000000000e-01;
  a035=arg[2]? arg[2][73] : 0;
  a035=(a034*a035);
  a036=arg[2]? arg[2][70] : 0;
  a037=1.0000000000000001e-01;
  a038=(a036+a037);
  a039=(-a038);
  a040=arg[2]? arg[2][71] : 0;
  a041=arg[0]? arg[0][2] : 0;
  a042=arg[2]? arg[2][69] : 0;
  a043=arg[2]? arg[2][1] : 0;
  a044=sin(a043);
  a045=(a042*a044);
  a046=arg[2]? arg[2][68] : 0;
  a047=cos(a043);
  a048=(a046*a047);
  a045=(a045-a048);
  a049=(a041*a045);
  a049=(a049+a006);
  a050=cos(a000);
  a051=(a022*a050);
  a052=sin(a000);
  a053=(a025*a052);
  a051=(a051-a053);
  a049=(a049-a051);
  a009=(a034*a009);
  a009=(a009+a031);
  a053=casadi_sq(a032);
  a054=1.0000000000000000e-08;
  a053=(a053+a054);
  a053=sqrt(a053);
  a055=(a034*a053);
  a009=(a009+a055);
  a055=sqrt(a009);
  a056=atan2(a049,a055);
  a057=arg[1]? arg[1][8] : 0;
  a058=arg[1]? arg[1][6] : 0;
  a059=arg[2]? arg[2][56] : 0;
  a060=(a058*a059);
  a057=(a057-a060);
  a060=arg[2]? arg[2][72] : 0;
  a061=(a057*a060);
  a056=(a056-a061);
  a061=(a040*a056);
  a062=casadi_fmin(a038,a061);
  a063=casadi_fmax(a039,a062);
  a064=2.0000000000000001e-01;
  a065=0.;
  a066=-5.;
  a067=(a066*a036);
  a068=5.;
  a069=(a068*a063);
  a067=(a067-a069);
  a067=(a067+a034);
  a069=casadi_fmax(a065,a067);
  a070=casadi_sq(a069);
  a071=(a069*a070);
  a071=(a064*a071);
  a072=1.;
  a073=(a034*a069);
  a073=(a072-a073);
  a074=(a071*a073);
  a074=(a063+a074);
  a036=(a066*a036);
  a063=(a068*a063);
  a036=(a036+a063);
  a036=(a036+a034);
  a063=casadi_fmax(a065,a036);
  a075=casadi_sq(a063);
  a076=(a063*a075);
  a076=(a064*a076);
  a077=(a034*a063);
  a077=(a072-a077);
  a078=(a076*a077);
  a074=(a074-a078);
  a078=(a035*a074);
  a079=arg[2]? arg[2][74] : 0;
  a080=(a078*a079);
  a081=(a080*a028);
  a082=arg[4]? arg[4][23] : 0;
  a083=cos(a043);
  a084=arg[4]? arg[4][34] : 0;
  a085=(a083*a084);
  a086=(a042*a085);
  a087=sin(a043);
  a088=(a087*a084);
  a089=(a046*a088);
  a086=(a086+a089);
  a089=arg[4]? arg[4][30] : 0;
  a090=(a045*a089);
  a086=(a086+a090);
  a090=arg[4]? arg[4][32] : 0;
  a091=arg[2]? arg[2][27] : 0;
  a092=(a090/a091);
  a093=arg[4]? arg[4][29] : 0;
  a093=(a092+a093);
  a086=(a086+a093);
  a082=(a082-a086);
  a086=(a081*a082);
  a094=casadi_sq(a049);
  a094=(a094+a009);
  a095=(a049/a094);
  a096=(a061<=a038);
  a097=(a038<=a061);
  a098=(a097+a096);
  a096=(a096/a098);
  a099=(a039<=a062);
  a100=(a062<=a039);
  a101=(a100+a099);
  a099=(a099/a101);
  a102=(a065<=a036);
  a103=(a036<=a065);
  a103=(a103+a102);
  a102=(a102/a103);
  a103=casadi_sq(a049);
  a103=(a009+a103);
  a104=(a103*a082);
  a105=(a028*a104);
  a106=(a079*a105);
  a107=(a035*a106);
  a108=arg[4]? arg[4][22] : 0;
  a107=(a107+a108);
  a108=(a076*a107);
  a108=(a034*a108);
  a109=(a077*a107);
  a109=(a064*a109);
  a110=(a075*a109);
  a108=(a108-a110);
  a110=(2.*a063);
  a111=(a063*a109);
  a112=(a110*a111);
  a108=(a108-a112);
  a108=(a102*a108);
  a108=(a068*a108);
  a108=(a108+a107);
  a112=(a065<=a067);
  a113=(a067<=a065);
  a113=(a113+a112);
  a112=(a112/a113);
  a113=(a073*a107);
  a113=(a064*a113);
  a114=(a070*a113);
  a115=(a071*a107);
  a115=(a034*a115);
  a114=(a114-a115);
  a115=(2.*a069);
  a116=(a069*a113);
  a117=(a115*a116);
  a114=(a114+a117);
  a114=(a112*a114);
  a114=(a068*a114);
  a108=(a108-a114);
  a108=(a099*a108);
  a108=(a096*a108);
  a114=(a040*a108);
  a117=arg[4]? arg[4][21] : 0;
  a117=(a114+a117);
  a118=(a095*a117);
  a119=(2.*a055);
  a118=(a118/a119);
  a120=(a086-a118);
  a121=(a034*a120);
  a122=(2.*a053);
  a121=(a121/a122);
  a123=(a033*a121);
  a124=(a034*a120);
  a124=(a123+a124);
  a125=(2.*a012);
  a126=arg[9]? arg[9][0] : 0;
  a127=(a004*a126);
  a128=sin(a000);
  a128=(a128*a016);
  a129=(a025*a128);
  a127=(a127-a129);
  a129=arg[9]? arg[9][1] : 0;
  a130=(a024*a129);
  a131=cos(a000);
  a131=(a131*a016);
  a132=(a022*a131);
  a130=(a130+a132);
  a127=(a127+a130);
  a130=(a013-a127);
  a125=(a125*a130);
  a132=(2.*a023);
  a125=(a125/a132);
  a132=(a124*a125);
  a133=(a023*a130);
  a134=(a012*a125);
  a133=(a133+a134);
  a134=arg[9]? arg[9][2] : 0;
  a135=(a134/a030);
  a136=(a031/a030);
  a137=arg[10]? arg[10][6] : 0;
  a138=(a029*a137);
  a139=(2.*a028);
  a140=arg[10]? arg[10][7] : 0;
  a139=(a139*a140);
  a141=(2.*a029);
  a139=(a139/a141);
  a141=(a026*a139);
  a138=(a138+a141);
  a136=(a136*a138);
  a135=(a135-a136);
  a136=(2.*a135);
  a136=(a133+a136);
  a141=(2.*a136);
  a141=(a121*a141);
  a142=arg[10]? arg[10][73] : 0;
  a142=(a034*a142);
  a143=(a074*a142);
  a144=(a039<=a062);
  a062=(a062<=a039);
  a039=(a062+a144);
  a144=(a144/a039);
  a145=(a038<=a061);
  a061=(a061<=a038);
  a038=(a145+a061);
  a145=(a145/a038);
  a146=arg[10]? arg[10][70] : 0;
  a145=(a145*a146);
  a061=(a061/a038);
  a038=arg[10]? arg[10][71] : 0;
  a147=(a056*a038);
  a148=casadi_sq(a049);
  a148=(a148+a009);
  a009=(a055/a148);
  a149=arg[8]? arg[8][2] : 0;
  a150=(a045*a149);
  a151=arg[10]? arg[10][69] : 0;
  a152=(a044*a151);
  a153=cos(a043);
  a154=arg[10]? arg[10][1] : 0;
  a153=(a153*a154);
  a155=(a042*a153);
  a152=(a152+a155);
  a155=arg[10]? arg[10][68] : 0;
  a156=(a047*a155);
  a157=sin(a043);
  a157=(a157*a154);
  a158=(a046*a157);
  a156=(a156-a158);
  a152=(a152-a156);
  a158=(a041*a152);
  a150=(a150+a158);
  a150=(a150+a017);
  a158=(a050*a129);
  a159=sin(a000);
  a159=(a159*a016);
  a160=(a022*a159);
  a158=(a158-a160);
  a160=(a052*a126);
  a161=cos(a000);
  a161=(a161*a016);
  a162=(a025*a161);
  a160=(a160+a162);
  a158=(a158-a160);
  a150=(a150-a158);
  a009=(a009*a150);
  a148=(a049/a148);
  a133=(a034*a133);
  a133=(a133+a135);
  a032=(2.*a032);
  a032=(a032*a136);
  a053=(2.*a053);
  a032=(a032/a053);
  a053=(a034*a032);
  a133=(a133+a053);
  a053=(2.*a055);
  a053=(a133/a053);
  a148=(a148*a053);
  a009=(a009-a148);
  a148=arg[9]? arg[9][8] : 0;
  a136=arg[9]? arg[9][6] : 0;
  a160=(a059*a136);
  a162=arg[10]? arg[10][56] : 0;
  a163=(a058*a162);
  a160=(a160+a163);
  a148=(a148-a160);
  a160=(a060*a148);
  a163=arg[10]? arg[10][72] : 0;
  a164=(a057*a163);
  a160=(a160+a164);
  a009=(a009-a160);
  a160=(a040*a009);
  a147=(a147+a160);
  a061=(a061*a147);
  a145=(a145+a061);
  a144=(a144*a145);
  a062=(a062/a039);
  a062=(a062*a146);
  a144=(a144-a062);
  a062=(a065<=a067);
  a067=(a067<=a065);
  a067=(a067+a062);
  a062=(a062/a067);
  a067=(a066*a146);
  a039=(a068*a144);
  a067=(a067-a039);
  a062=(a062*a067);
  a067=(a070*a062);
  a039=(2.*a069);
  a039=(a039*a062);
  a145=(a069*a039);
  a067=(a067+a145);
  a067=(a064*a067);
  a145=(a073*a067);
  a061=(a034*a062);
  a147=(a071*a061);
  a145=(a145-a147);
  a145=(a144+a145);
  a147=(a065<=a036);
  a036=(a036<=a065);
  a036=(a036+a147);
  a147=(a147/a036);
  a146=(a066*a146);
  a144=(a068*a144);
  a146=(a146+a144);
  a147=(a147*a146);
  a146=(a075*a147);
  a144=(2.*a063);
  a144=(a144*a147);
  a036=(a063*a144);
  a146=(a146+a036);
  a146=(a064*a146);
  a036=(a077*a146);
  a160=(a034*a147);
  a164=(a076*a160);
  a036=(a036-a164);
  a145=(a145-a036);
  a036=(a035*a145);
  a143=(a143+a036);
  a036=(a079*a143);
  a164=arg[10]? arg[10][74] : 0;
  a165=(a078*a164);
  a036=(a036+a165);
  a165=(a028*a036);
  a166=(a080*a140);
  a165=(a165+a166);
  a166=(a082*a165);
  a167=arg[12]? arg[12][23] : 0;
  a168=(a085*a151);
  a169=arg[12]? arg[12][34] : 0;
  a083=(a083*a169);
  a170=sin(a043);
  a170=(a170*a154);
  a170=(a084*a170);
  a083=(a083-a170);
  a170=(a042*a083);
  a168=(a168+a170);
  a170=(a088*a155);
  a171=cos(a043);
  a171=(a171*a154);
  a171=(a084*a171);
  a087=(a087*a169);
  a171=(a171+a087);
  a087=(a046*a171);
  a170=(a170+a087);
  a168=(a168+a170);
  a170=(a089*a152);
  a087=arg[12]? arg[12][30] : 0;
  a172=(a045*a087);
  a170=(a170+a172);
  a168=(a168+a170);
  a170=arg[12]? arg[12][32] : 0;
  a172=(a170/a091);
  a092=(a092/a091);
  a173=arg[10]? arg[10][27] : 0;
  a092=(a092*a173);
  a172=(a172-a092);
  a092=arg[12]? arg[12][29] : 0;
  a172=(a172+a092);
  a168=(a168+a172);
  a167=(a167-a168);
  a168=(a081*a167);
  a166=(a166+a168);
  a168=(a150/a094);
  a092=(a095/a094);
  a174=(2.*a049);
  a174=(a174*a150);
  a174=(a174+a133);
  a092=(a092*a174);
  a168=(a168-a092);
  a168=(a117*a168);
  a038=(a108*a038);
  a146=(a107*a146);
  a142=(a106*a142);
  a164=(a105*a164);
  a092=(a104*a140);
  a175=(2.*a049);
  a175=(a175*a150);
  a133=(a133+a175);
  a082=(a082*a133);
  a167=(a103*a167);
  a082=(a082+a167);
  a167=(a028*a082);
  a092=(a092+a167);
  a079=(a079*a092);
  a164=(a164+a079);
  a035=(a035*a164);
  a142=(a142+a035);
  a035=arg[12]? arg[12][22] : 0;
  a142=(a142+a035);
  a076=(a076*a142);
  a146=(a146+a076);
  a146=(a034*a146);
  a144=(a109*a144);
  a077=(a077*a142);
  a160=(a107*a160);
  a077=(a077-a160);
  a077=(a064*a077);
  a075=(a075*a077);
  a144=(a144+a075);
  a146=(a146-a144);
  a144=(2.*a147);
  a111=(a111*a144);
  a109=(a109*a147);
  a063=(a063*a077);
  a109=(a109+a063);
  a110=(a110*a109);
  a111=(a111+a110);
  a146=(a146-a111);
  a102=(a102*a146);
  a146=(a068*a102);
  a146=(a146+a142);
  a039=(a113*a039);
  a073=(a073*a142);
  a061=(a107*a061);
  a073=(a073-a061);
  a073=(a064*a073);
  a070=(a070*a073);
  a039=(a039+a070);
  a107=(a107*a067);
  a071=(a071*a142);
  a107=(a107+a071);
  a107=(a034*a107);
  a039=(a039-a107);
  a107=(2.*a062);
  a116=(a116*a107);
  a113=(a113*a062);
  a069=(a069*a073);
  a113=(a113+a069);
  a115=(a115*a113);
  a116=(a116+a115);
  a039=(a039+a116);
  a112=(a112*a039);
  a039=(a068*a112);
  a146=(a146-a039);
  a099=(a099*a146);
  a096=(a096*a099);
  a040=(a040*a096);
  a038=(a038+a040);
  a040=arg[12]? arg[12][21] : 0;
  a040=(a038+a040);
  a095=(a095*a040);
  a168=(a168+a095);
  a168=(a168/a119);
  a118=(a118/a119);
  a119=(2.*a053);
  a118=(a118*a119);
  a168=(a168-a118);
  a168=(a166-a168);
  a118=(a034*a168);
  a118=(a118/a122);
  a121=(a121/a122);
  a032=(2.*a032);
  a121=(a121*a032);
  a118=(a118-a121);
  a033=(a033*a118);
  a141=(a141+a033);
  a033=(a034*a168);
  a033=(a141+a033);
  a118=(a023*a033);
  a132=(a132+a118);
  a118=(a012*a124);
  a121=(2.*a023);
  a118=(a118/a121);
  a032=(2.*a130);
  a032=(a118*a032);
  a122=(2.*a012);
  a130=(a124*a130);
  a012=(a012*a033);
  a130=(a130+a012);
  a130=(a130/a121);
  a121=(a118/a121);
  a125=(2.*a125);
  a121=(a121*a125);
  a130=(a130-a121);
  a130=(a122*a130);
  a032=(a032+a130);
  a132=(a132+a032);
  a001=(a001+a132);
  a032=arg[2]? arg[2][44] : 0;
  a130=(a058*a032);
  a121=arg[1]? arg[1][7] : 0;
  a130=(a130+a121);
  a121=arg[2]? arg[2][45] : 0;
  a125=(a072-a121);
  a012=(a130*a125);
  a033=cos(a012);
  a119=(a003*a033);
  a095=arg[2]? arg[2][25] : 0;
  a039=cos(a043);
  a116=(a095*a039);
  a115=arg[2]? arg[2][30] : 0;
  a113=sin(a043);
  a069=(a115*a113);
  a073=(a116+a069);
  a062=(a041*a073);
  a062=(a062+a006);
  a107=sin(a012);
  a071=(a062*a107);
  a119=(a119+a071);
  a071=arg[2]? arg[2][5] : 0;
  a142=casadi_sq(a071);
  a067=casadi_sq(a142);
  a070=casadi_sq(a119);
  a061=cos(a012);
  a111=(a062*a061);
  a110=sin(a012);
  a109=(a003*a110);
  a111=(a111-a109);
  a109=casadi_sq(a111);
  a070=(a070+a109);
  a109=casadi_sq(a070);
  a067=(a067+a109);
  a067=sqrt(a067);
  a109=sqrt(a067);
  a063=(a119/a109);
  a077=arg[2]? arg[2][55] : 0;
  a147=arg[2]? arg[2][50] : 0;
  a144=1.0000000000000000e-03;
  a075=arg[2]? arg[2][48] : 0;
  a160=arg[2]? arg[2][49] : 0;
  a076=arg[2]? arg[2][26] : 0;
  a035=(a076*a091);
  a079=arg[2]? arg[2][12] : 0;
  a167=(a079+a037);
  a175=(-a167);
  a176=arg[2]? arg[2][11] : 0;
  a177=arg[1]? arg[1][3] : 0;
  a178=arg[2]? arg[2][10] : 0;
  a179=(a177*a178);
  a180=arg[2]? arg[2][9] : 0;
  a179=(a179+a180);
  a180=arg[2]? arg[2][8] : 0;
  a180=(a072-a180);
  a181=(a003-a005);
  a182=casadi_sq(a181);
  a182=(a182+a008);
  a182=sqrt(a182);
  a008=(a181*a182);
  a183=(a034*a008);
  a183=(a183+a031);
  a184=(2.*a031);
  a008=(a008+a184);
  a184=casadi_sq(a008);
  a184=(a184+a054);
  a184=sqrt(a184);
  a185=(a034*a184);
  a183=(a183+a185);
  a185=sqrt(a183);
  a185=atan2(a065,a185);
  a185=(a043+a185);
  a186=(a180*a185);
  a179=(a179+a186);
  a186=(a176*a179);
  a187=casadi_fmin(a167,a186);
  a188=casadi_fmax(a175,a187);
  a189=(a066*a079);
  a190=(a068*a188);
  a189=(a189-a190);
  a189=(a189+a034);
  a190=casadi_fmax(a065,a189);
  a191=casadi_sq(a190);
  a192=(a190*a191);
  a192=(a064*a192);
  a193=(a034*a190);
  a193=(a072-a193);
  a194=(a192*a193);
  a194=(a188+a194);
  a079=(a066*a079);
  a188=(a068*a188);
  a079=(a079+a188);
  a079=(a079+a034);
  a188=casadi_fmax(a065,a079);
  a195=casadi_sq(a188);
  a196=(a188*a195);
  a196=(a064*a196);
  a197=(a034*a188);
  a197=(a072-a197);
  a198=(a196*a197);
  a194=(a194-a198);
  a194=(a034*a194);
  a198=arg[2]? arg[2][13] : 0;
  a199=(a194*a198);
  a200=(a199*a028);
  a201=arg[2]? arg[2][14] : 0;
  a202=(a200*a201);
  a203=(a202*a183);
  a035=(a035-a203);
  a204=arg[2]? arg[2][22] : 0;
  a037=(a204+a037);
  a205=(-a037);
  a206=arg[2]? arg[2][20] : 0;
  a207=arg[2]? arg[2][21] : 0;
  a208=(a207*a043);
  a206=(a206+a208);
  a208=casadi_fmin(a037,a206);
  a209=casadi_fmax(a205,a208);
  a210=(a066*a204);
  a211=(a068*a209);
  a210=(a210-a211);
  a210=(a210+a034);
  a211=casadi_fmax(a065,a210);
  a212=casadi_sq(a211);
  a213=(a211*a212);
  a213=(a064*a213);
  a214=(a034*a211);
  a214=(a072-a214);
  a215=(a213*a214);
  a215=(a209+a215);
  a204=(a066*a204);
  a209=(a068*a209);
  a204=(a204+a209);
  a204=(a204+a034);
  a209=casadi_fmax(a065,a204);
  a216=casadi_sq(a209);
  a217=(a209*a216);
  a217=(a064*a217);
  a218=(a034*a209);
  a218=(a072-a218);
  a219=(a217*a218);
  a215=(a215-a219);
  a219=arg[2]? arg[2][15] : 0;
  a220=(a034*a219);
  a005=(a003-a005);
  a221=casadi_sq(a005);
  a221=(a221+a054);
  a051=(a006-a051);
  a054=casadi_sq(a051);
  a054=(a221+a054);
  a222=(a220*a054);
  a223=(a222*a028);
  a224=(a215*a223);
  a225=(a224*a005);
  a226=sqrt(a221);
  a225=(a225/a226);
  a035=(a035-a225);
  a227=arg[2]? arg[2][0] : 0;
  a228=cos(a043);
  a229=(a227*a228);
  a230=arg[2]? arg[2][4] : 0;
  a231=sin(a043);
  a232=(a230*a231);
  a229=(a229+a232);
  a232=(a035*a229);
  a233=arg[2]? arg[2][28] : 0;
  a234=cos(a043);
  a235=(a233*a234);
  a236=arg[2]? arg[2][29] : 0;
  a237=sin(a043);
  a238=(a236*a237);
  a239=(a235+a238);
  a240=(a203*a239);
  a241=arg[2]? arg[2][19] : 0;
  a242=(a241*a223);
  a243=arg[2]? arg[2][16] : 0;
  a244=arg[2]? arg[2][17] : 0;
  a245=(a244*a043);
  a243=(a243+a245);
  a245=arg[2]? arg[2][18] : 0;
  a246=(a245*a177);
  a243=(a243+a246);
  a246=(a242*a243);
  a247=arg[2]? arg[2][31] : 0;
  a248=(a014*a247);
  a249=cos(a043);
  a250=(a248*a249);
  a246=(a246+a250);
  a240=(a240+a246);
  a232=(a232+a240);
  a246=(a116+a069);
  a246=(a229-a246);
  a232=(a232/a246);
  a250=casadi_fmax(a065,a232);
  a251=(a160*a250);
  a075=(a075+a251);
  a251=casadi_fmax(a144,a075);
  a252=(a147*a251);
  a077=(a077/a252);
  a253=5.0000000000000004e-06;
  a254=(a077+a253);
  a255=(a063<=a254);
  a256=(a254<=a063);
  a257=(a256+a255);
  a255=(a255/a257);
  a258=(-a254);
  a259=casadi_fmin(a254,a063);
  a260=(a258<=a259);
  a261=(a259<=a258);
  a262=(a261+a260);
  a260=(a260/a262);
  a263=100000.;
  a264=-100000.;
  a265=(a264*a077);
  a266=casadi_fmax(a258,a259);
  a267=(a263*a266);
  a265=(a265+a267);
  a265=(a265+a034);
  a267=(a065<=a265);
  a268=(a265<=a065);
  a268=(a268+a267);
  a267=(a267/a268);
  a268=cos(a012);
  a269=cos(a043);
  a270=arg[4]? arg[4][35] : 0;
  a271=(a269*a270);
  a272=(a268*a271);
  a273=(a115*a272);
  a274=sin(a012);
  a275=sin(a043);
  a276=(a275*a084);
  a277=(a274*a276);
  a278=(a095*a277);
  a273=(a273+a278);
  a278=sin(a012);
  a279=cos(a043);
  a280=(a115*a279);
  a281=(a280*a084);
  a282=(a116+a069);
  a283=(a282*a089);
  a281=(a281+a283);
  a281=(a281+a093);
  a284=(a278*a281);
  a273=(a273-a284);
  a284=cos(a012);
  a285=sin(a043);
  a286=(a285*a270);
  a287=(a095*a286);
  a288=arg[4]? arg[4][31] : 0;
  a289=(a288/a091);
  a290=arg[4]? arg[4][28] : 0;
  a290=(a289+a290);
  a287=(a287+a290);
  a291=(a284*a287);
  a273=(a273-a291);
  a291=arg[4]? arg[4][10] : 0;
  a273=(a273+a291);
  a291=(a252*a273);
  a292=(a250*a291);
  a293=1.0000000000000001e-05;
  a294=(a264*a077);
  a295=(a263*a266);
  a294=(a294-a295);
  a294=(a294+a034);
  a295=casadi_fmax(a065,a294);
  a296=casadi_sq(a295);
  a297=(a295*a296);
  a297=(a293*a297);
  a298=(a034*a295);
  a298=(a072-a298);
  a299=(a297*a298);
  a266=(a266+a299);
  a299=casadi_fmax(a065,a265);
  a300=casadi_sq(a299);
  a301=(a299*a300);
  a301=(a293*a301);
  a302=(a034*a299);
  a302=(a072-a302);
  a303=(a301*a302);
  a266=(a266-a303);
  a303=(2.*a266);
  a304=casadi_sq(a266);
  a304=(a072-a304);
  a304=sqrt(a304);
  a305=(a264*a304);
  a306=(a304+a253);
  a307=(-a306);
  a308=arg[2]? arg[2][54] : 0;
  a309=arg[2]? arg[2][53] : 0;
  a310=arg[2]? arg[2][51] : 0;
  a311=arg[2]? arg[2][52] : 0;
  a312=(a311-a072);
  a313=casadi_fmax(a011,a312);
  a313=sqrt(a313);
  a314=(a310*a313);
  a315=(1./a314);
  a316=(-a315);
  a317=arg[2]? arg[2][46] : 0;
  a318=arg[2]? arg[2][47] : 0;
  a319=(a318*a250);
  a317=(a317+a319);
  a319=casadi_fmax(a065,a317);
  a320=casadi_sq(a119);
  a321=9.9999999999999995e-07;
  a322=casadi_sq(a071);
  a322=(a321*a322);
  a320=(a320+a322);
  a323=sqrt(a320);
  a324=(a111/a323);
  a325=(a319*a324);
  a325=(a325/a252);
  a326=casadi_fmin(a325,a315);
  a327=casadi_fmax(a316,a326);
  a328=(a310*a327);
  a329=atan(a328);
  a330=(a311*a329);
  a330=(a330/a310);
  a331=(a311-a072);
  a332=(a327*a331);
  a332=(a330-a332);
  a333=(a310*a332);
  a334=atan(a333);
  a335=(a309*a334);
  a336=sin(a335);
  a337=(a308*a336);
  a338=casadi_sq(a111);
  a338=(a338+a320);
  a338=sqrt(a338);
  a320=(a337*a338);
  a320=(a320/a109);
  a339=casadi_fmin(a306,a320);
  a340=casadi_fmax(a307,a339);
  a341=(a263*a340);
  a305=(a305+a341);
  a305=(a305+a034);
  a341=(a065<=a305);
  a342=(a305<=a065);
  a342=(a342+a341);
  a341=(a341/a342);
  a342=casadi_fmax(a065,a305);
  a343=casadi_sq(a342);
  a344=(a342*a343);
  a344=(a293*a344);
  a121=(a072-a121);
  a345=sin(a012);
  a346=sin(a043);
  a347=(a346*a270);
  a348=(a345*a347);
  a349=(a095*a348);
  a350=sin(a012);
  a351=(a350*a270);
  a352=(a280*a351);
  a349=(a349-a352);
  a352=sin(a043);
  a353=cos(a012);
  a354=(a353*a084);
  a355=(a352*a354);
  a356=(a095*a355);
  a349=(a349+a356);
  a356=cos(a012);
  a357=(a280*a084);
  a357=(a357+a283);
  a357=(a357+a093);
  a283=(a356*a357);
  a349=(a349-a283);
  a283=sin(a012);
  a358=(a283*a290);
  a349=(a349+a358);
  a358=arg[4]? arg[4][11] : 0;
  a349=(a349+a358);
  a358=(a121*a349);
  a359=(a252*a358);
  a360=(a250*a359);
  a361=(a344*a360);
  a361=(a034*a361);
  a362=(a034*a342);
  a362=(a072-a362);
  a363=(a362*a360);
  a363=(a293*a363);
  a364=(a343*a363);
  a361=(a361-a364);
  a364=(2.*a342);
  a365=(a342*a363);
  a366=(a364*a365);
  a361=(a361-a366);
  a361=(a341*a361);
  a366=(a264*a361);
  a367=(a264*a304);
  a368=(a263*a340);
  a367=(a367-a368);
  a367=(a367+a034);
  a368=(a065<=a367);
  a369=(a367<=a065);
  a369=(a369+a368);
  a368=(a368/a369);
  a369=casadi_fmax(a065,a367);
  a370=casadi_sq(a369);
  a371=(a034*a369);
  a371=(a072-a371);
  a372=(a371*a360);
  a372=(a293*a372);
  a373=(a370*a372);
  a374=(a369*a370);
  a374=(a293*a374);
  a375=(a374*a360);
  a375=(a034*a375);
  a373=(a373-a375);
  a375=(2.*a369);
  a376=(a369*a372);
  a377=(a375*a376);
  a373=(a373+a377);
  a373=(a368*a373);
  a377=(a264*a373);
  a366=(a366+a377);
  a377=(a306<=a320);
  a378=(a320<=a306);
  a379=(a377+a378);
  a377=(a377/a379);
  a380=(a307<=a339);
  a381=(a339<=a307);
  a382=(a381+a380);
  a380=(a380/a382);
  a361=(a263*a361);
  a361=(a361+a360);
  a373=(a263*a373);
  a361=(a361-a373);
  a373=(a380*a361);
  a383=(a377*a373);
  a381=(a381/a382);
  a361=(a381*a361);
  a383=(a383-a361);
  a366=(a366+a383);
  a383=(2.*a304);
  a366=(a366/a383);
  a361=(a303*a366);
  a292=(a292-a361);
  a361=(a065<=a265);
  a265=(a265<=a065);
  a265=(a265+a361);
  a361=(a361/a265);
  a265=arg[10]? arg[10][55] : 0;
  a265=(a265/a252);
  a382=(a077/a252);
  a384=arg[10]? arg[10][50] : 0;
  a385=(a251*a384);
  a386=(a144<=a075);
  a387=(a075<=a144);
  a387=(a387+a386);
  a386=(a386/a387);
  a387=arg[10]? arg[10][48] : 0;
  a388=arg[10]? arg[10][49] : 0;
  a389=(a250*a388);
  a390=(a065<=a232);
  a391=(a232<=a065);
  a391=(a391+a390);
  a390=(a390/a391);
  a391=arg[10]? arg[10][26] : 0;
  a392=(a091*a391);
  a393=(a076*a173);
  a392=(a392+a393);
  a393=(a175<=a187);
  a394=(a187<=a175);
  a395=(a394+a393);
  a393=(a393/a395);
  a396=(a167<=a186);
  a397=(a186<=a167);
  a398=(a396+a397);
  a396=(a396/a398);
  a399=arg[10]? arg[10][12] : 0;
  a396=(a396*a399);
  a397=(a397/a398);
  a398=arg[10]? arg[10][11] : 0;
  a400=(a179*a398);
  a401=arg[9]? arg[9][3] : 0;
  a402=(a178*a401);
  a403=arg[10]? arg[10][10] : 0;
  a404=(a177*a403);
  a402=(a402+a404);
  a404=arg[10]? arg[10][9] : 0;
  a402=(a402+a404);
  a404=(a180*a154);
  a405=arg[10]? arg[10][8] : 0;
  a406=(a185*a405);
  a404=(a404-a406);
  a402=(a402+a404);
  a404=(a176*a402);
  a400=(a400+a404);
  a397=(a397*a400);
  a396=(a396+a397);
  a393=(a393*a396);
  a394=(a394/a395);
  a394=(a394*a399);
  a393=(a393-a394);
  a394=(a065<=a189);
  a395=(a189<=a065);
  a395=(a395+a394);
  a394=(a394/a395);
  a395=(a066*a399);
  a396=(a068*a393);
  a395=(a395-a396);
  a394=(a394*a395);
  a395=(a191*a394);
  a396=(2.*a190);
  a396=(a396*a394);
  a397=(a190*a396);
  a395=(a395+a397);
  a395=(a064*a395);
  a397=(a193*a395);
  a400=(a034*a394);
  a404=(a192*a400);
  a397=(a397-a404);
  a397=(a393+a397);
  a404=(a065<=a079);
  a406=(a079<=a065);
  a406=(a406+a404);
  a404=(a404/a406);
  a399=(a066*a399);
  a393=(a068*a393);
  a399=(a399+a393);
  a404=(a404*a399);
  a399=(a195*a404);
  a393=(2.*a188);
  a393=(a393*a404);
  a406=(a188*a393);
  a399=(a399+a406);
  a399=(a064*a399);
  a406=(a197*a399);
  a407=(a034*a404);
  a408=(a196*a407);
  a406=(a406-a408);
  a397=(a397-a406);
  a397=(a034*a397);
  a406=(a198*a397);
  a408=arg[10]? arg[10][13] : 0;
  a409=(a194*a408);
  a406=(a406+a409);
  a409=(a028*a406);
  a410=(a199*a140);
  a409=(a409+a410);
  a410=(a201*a409);
  a411=arg[10]? arg[10][14] : 0;
  a412=(a200*a411);
  a410=(a410+a412);
  a412=(a183*a410);
  a413=(a013-a127);
  a414=(a182*a413);
  a415=(2.*a181);
  a415=(a415*a413);
  a416=(2.*a182);
  a415=(a415/a416);
  a416=(a181*a415);
  a414=(a414+a416);
  a416=(a034*a414);
  a416=(a416+a135);
  a417=(2.*a008);
  a418=(2.*a135);
  a414=(a414+a418);
  a417=(a417*a414);
  a418=(2.*a184);
  a417=(a417/a418);
  a418=(a034*a417);
  a416=(a416+a418);
  a418=(a202*a416);
  a412=(a412+a418);
  a392=(a392-a412);
  a418=(a205<=a208);
  a419=(a208<=a205);
  a420=(a419+a418);
  a418=(a418/a420);
  a421=(a037<=a206);
  a422=(a206<=a037);
  a423=(a421+a422);
  a421=(a421/a423);
  a424=arg[10]? arg[10][22] : 0;
  a421=(a421*a424);
  a422=(a422/a423);
  a423=arg[10]? arg[10][20] : 0;
  a425=arg[10]? arg[10][21] : 0;
  a426=(a043*a425);
  a427=(a207*a154);
  a426=(a426+a427);
  a423=(a423+a426);
  a422=(a422*a423);
  a421=(a421+a422);
  a418=(a418*a421);
  a419=(a419/a420);
  a419=(a419*a424);
  a418=(a418-a419);
  a419=(a065<=a210);
  a420=(a210<=a065);
  a420=(a420+a419);
  a419=(a419/a420);
  a420=(a066*a424);
  a421=(a068*a418);
  a420=(a420-a421);
  a419=(a419*a420);
  a420=(a212*a419);
  a421=(2.*a211);
  a421=(a421*a419);
  a422=(a211*a421);
  a420=(a420+a422);
  a420=(a064*a420);
  a422=(a214*a420);
  a423=(a034*a419);
  a426=(a213*a423);
  a422=(a422-a426);
  a422=(a418+a422);
  a426=(a065<=a204);
  a427=(a204<=a065);
  a427=(a427+a426);
  a426=(a426/a427);
  a424=(a066*a424);
  a418=(a068*a418);
  a424=(a424+a418);
  a426=(a426*a424);
  a424=(a216*a426);
  a418=(2.*a209);
  a418=(a418*a426);
  a427=(a209*a418);
  a424=(a424+a427);
  a424=(a064*a424);
  a427=(a218*a424);
  a428=(a034*a426);
  a429=(a217*a428);
  a427=(a427-a429);
  a422=(a422-a427);
  a427=(a223*a422);
  a429=arg[10]? arg[10][15] : 0;
  a430=(a034*a429);
  a431=(a054*a430);
  a432=(2.*a005);
  a127=(a013-a127);
  a432=(a432*a127);
  a433=(2.*a051);
  a158=(a017-a158);
  a433=(a433*a158);
  a433=(a432+a433);
  a434=(a220*a433);
  a431=(a431+a434);
  a434=(a028*a431);
  a435=(a222*a140);
  a434=(a434+a435);
  a435=(a215*a434);
  a427=(a427+a435);
  a435=(a005*a427);
  a436=(a224*a127);
  a435=(a435+a436);
  a435=(a435/a226);
  a436=(a225/a226);
  a437=(2.*a226);
  a437=(a432/a437);
  a436=(a436*a437);
  a435=(a435-a436);
  a392=(a392-a435);
  a436=(a229*a392);
  a438=arg[10]? arg[10][0] : 0;
  a439=(a228*a438);
  a440=sin(a043);
  a440=(a440*a154);
  a441=(a227*a440);
  a439=(a439-a441);
  a441=arg[10]? arg[10][4] : 0;
  a442=(a231*a441);
  a443=cos(a043);
  a443=(a443*a154);
  a444=(a230*a443);
  a442=(a442+a444);
  a439=(a439+a442);
  a442=(a035*a439);
  a436=(a436+a442);
  a442=(a239*a412);
  a444=arg[10]? arg[10][28] : 0;
  a445=(a234*a444);
  a446=sin(a043);
  a446=(a446*a154);
  a447=(a233*a446);
  a445=(a445-a447);
  a447=arg[10]? arg[10][29] : 0;
  a448=(a237*a447);
  a449=cos(a043);
  a449=(a449*a154);
  a450=(a236*a449);
  a448=(a448+a450);
  a450=(a445+a448);
  a451=(a203*a450);
  a442=(a442+a451);
  a451=arg[10]? arg[10][19] : 0;
  a452=(a223*a451);
  a453=(a241*a434);
  a452=(a452+a453);
  a453=(a243*a452);
  a454=arg[10]? arg[10][16] : 0;
  a455=arg[10]? arg[10][17] : 0;
  a456=(a043*a455);
  a457=(a244*a154);
  a456=(a456+a457);
  a454=(a454+a456);
  a456=arg[10]? arg[10][18] : 0;
  a457=(a177*a456);
  a458=(a245*a401);
  a457=(a457+a458);
  a454=(a454+a457);
  a457=(a242*a454);
  a453=(a453+a457);
  a457=(a247*a134);
  a458=arg[10]? arg[10][31] : 0;
  a459=(a014*a458);
  a457=(a457+a459);
  a459=(a249*a457);
  a460=sin(a043);
  a460=(a460*a154);
  a461=(a248*a460);
  a459=(a459-a461);
  a453=(a453+a459);
  a442=(a442+a453);
  a436=(a436+a442);
  a436=(a436/a246);
  a453=(a232/a246);
  a459=arg[10]? arg[10][25] : 0;
  a461=(a039*a459);
  a462=sin(a043);
  a462=(a462*a154);
  a463=(a095*a462);
  a461=(a461-a463);
  a463=arg[10]? arg[10][30] : 0;
  a464=(a113*a463);
  a465=cos(a043);
  a465=(a465*a154);
  a466=(a115*a465);
  a464=(a464+a466);
  a466=(a461+a464);
  a466=(a439-a466);
  a453=(a453*a466);
  a436=(a436-a453);
  a390=(a390*a436);
  a453=(a160*a390);
  a389=(a389+a453);
  a387=(a387+a389);
  a386=(a386*a387);
  a387=(a147*a386);
  a385=(a385+a387);
  a382=(a382*a385);
  a265=(a265-a382);
  a382=(a264*a265);
  a387=(a258<=a259);
  a259=(a259<=a258);
  a258=(a259+a387);
  a387=(a387/a258);
  a389=(a254<=a063);
  a254=(a063<=a254);
  a453=(a389+a254);
  a389=(a389/a453);
  a389=(a389*a265);
  a254=(a254/a453);
  a453=(a033*a013);
  a467=sin(a012);
  a468=(a032*a136);
  a469=arg[10]? arg[10][44] : 0;
  a470=(a058*a469);
  a468=(a468+a470);
  a470=arg[9]? arg[9][7] : 0;
  a468=(a468+a470);
  a470=(a125*a468);
  a471=arg[10]? arg[10][45] : 0;
  a472=(a130*a471);
  a470=(a470-a472);
  a467=(a467*a470);
  a472=(a003*a467);
  a453=(a453-a472);
  a472=(a073*a149);
  a473=(a461+a464);
  a474=(a041*a473);
  a472=(a472+a474);
  a472=(a472+a017);
  a474=(a107*a472);
  a475=cos(a012);
  a475=(a475*a470);
  a476=(a062*a475);
  a474=(a474+a476);
  a453=(a453+a474);
  a474=(a453/a109);
  a476=(a063/a109);
  a477=(2.*a142);
  a478=(2.*a071);
  a479=arg[10]? arg[10][5] : 0;
  a478=(a478*a479);
  a477=(a477*a478);
  a480=(2.*a070);
  a481=(2.*a119);
  a481=(a481*a453);
  a482=(2.*a111);
  a483=(a061*a472);
  a484=sin(a012);
  a484=(a484*a470);
  a485=(a062*a484);
  a483=(a483-a485);
  a485=(a110*a013);
  a486=cos(a012);
  a486=(a486*a470);
  a487=(a003*a486);
  a485=(a485+a487);
  a483=(a483-a485);
  a482=(a482*a483);
  a481=(a481+a482);
  a480=(a480*a481);
  a477=(a477+a480);
  a480=(2.*a067);
  a477=(a477/a480);
  a480=(2.*a109);
  a480=(a477/a480);
  a476=(a476*a480);
  a474=(a474-a476);
  a254=(a254*a474);
  a389=(a389+a254);
  a387=(a387*a389);
  a259=(a259/a258);
  a259=(a259*a265);
  a387=(a387-a259);
  a259=(a263*a387);
  a382=(a382+a259);
  a361=(a361*a382);
  a382=(a300*a361);
  a259=(2.*a299);
  a259=(a259*a361);
  a258=(a299*a259);
  a382=(a382+a258);
  a382=(a293*a382);
  a258=(a292*a382);
  a389=(a291*a390);
  a254=(a273*a385);
  a476=(a272*a463);
  a482=arg[12]? arg[12][35] : 0;
  a269=(a269*a482);
  a485=sin(a043);
  a485=(a485*a154);
  a485=(a270*a485);
  a269=(a269-a485);
  a485=(a268*a269);
  a487=sin(a012);
  a487=(a487*a470);
  a488=(a271*a487);
  a485=(a485-a488);
  a488=(a115*a485);
  a476=(a476+a488);
  a488=(a277*a459);
  a489=cos(a012);
  a489=(a489*a470);
  a490=(a276*a489);
  a491=cos(a043);
  a491=(a491*a154);
  a491=(a084*a491);
  a275=(a275*a169);
  a491=(a491+a275);
  a275=(a274*a491);
  a490=(a490+a275);
  a275=(a095*a490);
  a488=(a488+a275);
  a476=(a476+a488);
  a488=cos(a012);
  a488=(a488*a470);
  a275=(a281*a488);
  a492=(a279*a463);
  a493=sin(a043);
  a493=(a493*a154);
  a494=(a115*a493);
  a492=(a492-a494);
  a494=(a084*a492);
  a495=(a280*a169);
  a494=(a494+a495);
  a495=(a461+a464);
  a495=(a089*a495);
  a282=(a282*a087);
  a495=(a495+a282);
  a494=(a494+a495);
  a494=(a494+a172);
  a282=(a278*a494);
  a275=(a275+a282);
  a476=(a476-a275);
  a275=(a286*a459);
  a282=cos(a043);
  a282=(a282*a154);
  a282=(a270*a282);
  a285=(a285*a482);
  a282=(a282+a285);
  a285=(a095*a282);
  a275=(a275+a285);
  a285=arg[12]? arg[12][31] : 0;
  a496=(a285/a091);
  a289=(a289/a091);
  a289=(a289*a173);
  a496=(a496-a289);
  a289=arg[12]? arg[12][28] : 0;
  a496=(a496+a289);
  a275=(a275+a496);
  a289=(a284*a275);
  a497=sin(a012);
  a497=(a497*a470);
  a498=(a287*a497);
  a289=(a289-a498);
  a476=(a476-a289);
  a289=arg[12]? arg[12][10] : 0;
  a476=(a476+a289);
  a289=(a252*a476);
  a254=(a254+a289);
  a289=(a250*a254);
  a389=(a389+a289);
  a289=(a065<=a294);
  a498=(a294<=a065);
  a498=(a498+a289);
  a289=(a289/a498);
  a498=(a264*a265);
  a499=(a263*a387);
  a498=(a498-a499);
  a289=(a289*a498);
  a498=(a296*a289);
  a499=(2.*a295);
  a499=(a499*a289);
  a500=(a295*a499);
  a498=(a498+a500);
  a498=(a293*a498);
  a500=(a298*a498);
  a501=(a034*a289);
  a502=(a297*a501);
  a500=(a500-a502);
  a387=(a387+a500);
  a382=(a302*a382);
  a500=(a034*a361);
  a502=(a301*a500);
  a382=(a382-a502);
  a387=(a387-a382);
  a382=(2.*a387);
  a382=(a366*a382);
  a502=(a065<=a305);
  a305=(a305<=a065);
  a305=(a305+a502);
  a502=(a502/a305);
  a305=(a339<=a307);
  a307=(a307<=a339);
  a339=(a305+a307);
  a305=(a305/a339);
  a503=(2.*a266);
  a503=(a503*a387);
  a304=(2.*a304);
  a503=(a503/a304);
  a305=(a305*a503);
  a307=(a307/a339);
  a339=(a320<=a306);
  a306=(a306<=a320);
  a304=(a306+a339);
  a339=(a339/a304);
  a504=arg[10]? arg[10][54] : 0;
  a505=(a336*a504);
  a506=cos(a335);
  a507=arg[10]? arg[10][53] : 0;
  a508=(a334*a507);
  a509=arg[10]? arg[10][51] : 0;
  a510=(a332*a509);
  a511=arg[10]? arg[10][52] : 0;
  a512=(a329*a511);
  a513=(a327*a509);
  a514=(a326<=a316);
  a515=(a316<=a326);
  a516=(a514+a515);
  a514=(a514/a516);
  a517=(a315/a314);
  a518=(a313*a509);
  a519=(a011<=a312);
  a520=(a312<=a011);
  a520=(a520+a519);
  a519=(a519/a520);
  a519=(a519*a511);
  a520=(2.*a313);
  a519=(a519/a520);
  a520=(a310*a519);
  a518=(a518+a520);
  a517=(a517*a518);
  a514=(a514*a517);
  a515=(a515/a516);
  a516=(a325<=a315);
  a520=(a315<=a325);
  a521=(a516+a520);
  a516=(a516/a521);
  a522=(a065<=a317);
  a523=(a317<=a065);
  a523=(a523+a522);
  a522=(a522/a523);
  a523=arg[10]? arg[10][46] : 0;
  a524=arg[10]? arg[10][47] : 0;
  a525=(a250*a524);
  a526=(a318*a390);
  a525=(a525+a526);
  a523=(a523+a525);
  a522=(a522*a523);
  a523=(a324*a522);
  a525=(a483/a323);
  a526=(a324/a323);
  a527=(2.*a119);
  a527=(a527*a453);
  a528=(2.*a071);
  a528=(a528*a479);
  a528=(a321*a528);
  a527=(a527+a528);
  a529=(2.*a323);
  a529=(a527/a529);
  a526=(a526*a529);
  a525=(a525-a526);
  a526=(a319*a525);
  a523=(a523+a526);
  a523=(a523/a252);
  a526=(a325/a252);
  a526=(a526*a385);
  a523=(a523-a526);
  a516=(a516*a523);
  a520=(a520/a521);
  a520=(a520*a517);
  a516=(a516-a520);
  a515=(a515*a516);
  a514=(a514+a515);
  a515=(a310*a514);
  a513=(a513+a515);
  a515=casadi_sq(a328);
  a515=(a072+a515);
  a515=(a513/a515);
  a516=(a311*a515);
  a512=(a512+a516);
  a512=(a512/a310);
  a516=(a330/a310);
  a516=(a516*a509);
  a512=(a512-a516);
  a516=(a331*a514);
  a520=(a327*a511);
  a516=(a516+a520);
  a516=(a512-a516);
  a520=(a310*a516);
  a510=(a510+a520);
  a520=casadi_sq(a333);
  a520=(a072+a520);
  a520=(a510/a520);
  a521=(a309*a520);
  a508=(a508+a521);
  a506=(a506*a508);
  a521=(a308*a506);
  a505=(a505+a521);
  a521=(a338*a505);
  a526=(2.*a111);
  a526=(a526*a483);
  a526=(a526+a527);
  a527=(2.*a338);
  a526=(a526/a527);
  a527=(a337*a526);
  a521=(a521+a527);
  a521=(a521/a109);
  a527=(a320/a109);
  a527=(a527*a480);
  a521=(a521-a527);
  a339=(a339*a521);
  a306=(a306/a304);
  a306=(a306*a503);
  a339=(a339-a306);
  a307=(a307*a339);
  a305=(a305+a307);
  a307=(a263*a305);
  a339=(a264*a503);
  a307=(a307-a339);
  a502=(a502*a307);
  a307=(a343*a502);
  a339=(2.*a342);
  a339=(a339*a502);
  a306=(a342*a339);
  a307=(a307+a306);
  a307=(a293*a307);
  a306=(a360*a307);
  a304=(a359*a390);
  a527=(a358*a385);
  a530=(a348*a459);
  a531=cos(a012);
  a531=(a531*a470);
  a532=(a347*a531);
  a533=cos(a043);
  a533=(a533*a154);
  a533=(a270*a533);
  a346=(a346*a482);
  a533=(a533+a346);
  a346=(a345*a533);
  a532=(a532+a346);
  a346=(a095*a532);
  a530=(a530+a346);
  a346=(a351*a492);
  a534=cos(a012);
  a534=(a534*a470);
  a534=(a270*a534);
  a350=(a350*a482);
  a534=(a534+a350);
  a350=(a280*a534);
  a346=(a346+a350);
  a530=(a530-a346);
  a346=(a355*a459);
  a350=cos(a043);
  a350=(a350*a154);
  a535=(a354*a350);
  a353=(a353*a169);
  a536=sin(a012);
  a536=(a536*a470);
  a536=(a084*a536);
  a353=(a353-a536);
  a536=(a352*a353);
  a535=(a535+a536);
  a536=(a095*a535);
  a346=(a346+a536);
  a530=(a530+a346);
  a346=(a084*a492);
  a536=(a280*a169);
  a346=(a346+a536);
  a346=(a346+a495);
  a346=(a346+a172);
  a495=(a356*a346);
  a536=sin(a012);
  a536=(a536*a470);
  a537=(a357*a536);
  a495=(a495-a537);
  a530=(a530-a495);
  a495=cos(a012);
  a495=(a495*a470);
  a537=(a290*a495);
  a538=(a283*a496);
  a537=(a537+a538);
  a530=(a530+a537);
  a537=arg[12]? arg[12][11] : 0;
  a530=(a530+a537);
  a537=(a121*a530);
  a538=(a349*a471);
  a537=(a537-a538);
  a538=(a252*a537);
  a527=(a527+a538);
  a538=(a250*a527);
  a304=(a304+a538);
  a538=(a344*a304);
  a306=(a306+a538);
  a306=(a034*a306);
  a339=(a363*a339);
  a538=(a362*a304);
  a539=(a034*a502);
  a540=(a360*a539);
  a538=(a538-a540);
  a538=(a293*a538);
  a343=(a343*a538);
  a339=(a339+a343);
  a306=(a306-a339);
  a339=(2.*a502);
  a365=(a365*a339);
  a363=(a363*a502);
  a342=(a342*a538);
  a363=(a363+a342);
  a364=(a364*a363);
  a365=(a365+a364);
  a306=(a306-a365);
  a341=(a341*a306);
  a306=(a264*a341);
  a365=(a065<=a367);
  a367=(a367<=a065);
  a367=(a367+a365);
  a365=(a365/a367);
  a367=(a264*a503);
  a364=(a263*a305);
  a367=(a367+a364);
  a365=(a365*a367);
  a367=(a034*a365);
  a364=(a360*a367);
  a363=(a371*a304);
  a364=(a364+a363);
  a364=(a293*a364);
  a363=(a370*a364);
  a342=(2.*a369);
  a342=(a342*a365);
  a538=(a372*a342);
  a363=(a363-a538);
  a538=(a374*a304);
  a370=(a370*a365);
  a342=(a369*a342);
  a370=(a370+a342);
  a370=(a293*a370);
  a360=(a360*a370);
  a538=(a538-a360);
  a538=(a034*a538);
  a363=(a363-a538);
  a538=(-a365);
  a538=(2.*a538);
  a376=(a376*a538);
  a369=(a369*a364);
  a372=(a372*a365);
  a369=(a369-a372);
  a375=(a375*a369);
  a376=(a376+a375);
  a363=(a363+a376);
  a368=(a368*a363);
  a363=(a264*a368);
  a306=(a306+a363);
  a341=(a263*a341);
  a341=(a341+a304);
  a368=(a263*a368);
  a341=(a341-a368);
  a380=(a380*a341);
  a377=(a377*a380);
  a381=(a381*a341);
  a377=(a377-a381);
  a306=(a306+a377);
  a306=(a306/a383);
  a366=(a366/a383);
  a503=(-a503);
  a503=(2.*a503);
  a366=(a366*a503);
  a306=(a306-a366);
  a303=(a303*a306);
  a382=(a382+a303);
  a389=(a389-a382);
  a382=(a301*a389);
  a258=(a258+a382);
  a258=(a034*a258);
  a382=(a302*a292);
  a382=(a293*a382);
  a259=(a382*a259);
  a302=(a302*a389);
  a500=(a292*a500);
  a302=(a302-a500);
  a302=(a293*a302);
  a500=(a300*a302);
  a259=(a259+a500);
  a258=(a258-a259);
  a259=(a299*a382);
  a500=(2.*a361);
  a500=(a259*a500);
  a303=(2.*a299);
  a361=(a382*a361);
  a299=(a299*a302);
  a361=(a361+a299);
  a361=(a303*a361);
  a500=(a500+a361);
  a258=(a258-a500);
  a258=(a267*a258);
  a500=(a263*a258);
  a500=(a500+a389);
  a361=(a065<=a294);
  a294=(a294<=a065);
  a294=(a294+a361);
  a361=(a361/a294);
  a294=(a298*a292);
  a294=(a293*a294);
  a499=(a294*a499);
  a298=(a298*a389);
  a501=(a292*a501);
  a298=(a298-a501);
  a298=(a293*a298);
  a501=(a296*a298);
  a499=(a499+a501);
  a498=(a292*a498);
  a389=(a297*a389);
  a498=(a498+a389);
  a498=(a034*a498);
  a499=(a499-a498);
  a498=(a295*a294);
  a389=(2.*a289);
  a389=(a498*a389);
  a501=(2.*a295);
  a289=(a294*a289);
  a295=(a295*a298);
  a289=(a289+a295);
  a289=(a501*a289);
  a389=(a389+a289);
  a499=(a499+a389);
  a499=(a361*a499);
  a389=(a263*a499);
  a500=(a500-a389);
  a389=(a260*a500);
  a289=(a255*a389);
  a295=(a289/a109);
  a301=(a301*a292);
  a301=(a034*a301);
  a300=(a300*a382);
  a301=(a301-a300);
  a303=(a303*a259);
  a301=(a301-a303);
  a267=(a267*a301);
  a301=(a263*a267);
  a301=(a301+a292);
  a296=(a296*a294);
  a297=(a297*a292);
  a297=(a034*a297);
  a296=(a296-a297);
  a501=(a501*a498);
  a296=(a296+a501);
  a361=(a361*a296);
  a296=(a263*a361);
  a301=(a301-a296);
  a260=(a260*a301);
  a255=(a255*a260);
  a296=(a255/a109);
  a501=(a296/a109);
  a501=(a501*a480);
  a295=(a295-a501);
  a070=(2.*a070);
  a320=(a320/a109);
  a378=(a378/a379);
  a373=(a378*a373);
  a379=(a320*a373);
  a063=(a063/a109);
  a501=(a063*a255);
  a379=(a379+a501);
  a501=(2.*a109);
  a379=(a379/a501);
  a067=(2.*a067);
  a498=(a379/a067);
  a297=(a070*a498);
  a292=(2.*a453);
  a292=(a297*a292);
  a294=(2.*a119);
  a481=(2.*a481);
  a481=(a498*a481);
  a521=(a521/a109);
  a303=(a320/a109);
  a303=(a303*a480);
  a521=(a521-a303);
  a521=(a373*a521);
  a378=(a378*a380);
  a320=(a320*a378);
  a521=(a521+a320);
  a474=(a474/a109);
  a320=(a063/a109);
  a320=(a320*a480);
  a474=(a474-a320);
  a255=(a255*a474);
  a063=(a063*a289);
  a255=(a255+a063);
  a521=(a521+a255);
  a521=(a521/a501);
  a379=(a379/a501);
  a501=(2.*a480);
  a379=(a379*a501);
  a521=(a521-a379);
  a521=(a521/a067);
  a067=(a498/a067);
  a477=(2.*a477);
  a067=(a067*a477);
  a521=(a521-a067);
  a070=(a070*a521);
  a481=(a481+a070);
  a070=(a294*a481);
  a292=(a292+a070);
  a295=(a295-a292);
  a373=(a373/a109);
  a292=(a337*a373);
  a070=(2.*a338);
  a292=(a292/a070);
  a067=(a324/a323);
  a477=(a325<=a315);
  a379=(a315<=a325);
  a501=(a477+a379);
  a477=(a477/a501);
  a255=(a316<=a326);
  a326=(a326<=a316);
  a316=(a326+a255);
  a255=(a255/a316);
  a063=cos(a335);
  a289=(a338*a373);
  a474=(a308*a289);
  a320=(a063*a474);
  a380=(a309*a320);
  a303=casadi_sq(a333);
  a303=(a072+a303);
  a380=(a380/a303);
  a259=(a311*a380);
  a300=casadi_sq(a328);
  a300=(a072+a300);
  a259=(a259/a300);
  a382=(a310*a259);
  a298=(a310*a380);
  a299=(a331*a298);
  a382=(a382-a299);
  a299=(a255*a382);
  a302=(a477*a299);
  a306=(a302/a252);
  a366=(a319*a306);
  a503=arg[4]? arg[4][9] : 0;
  a383=casadi_sq(a324);
  a383=(a072+a383);
  a503=(a503/a383);
  a366=(a366+a503);
  a377=(a067*a366);
  a381=(2.*a323);
  a377=(a377/a381);
  a341=(a292-a377);
  a453=(2.*a453);
  a453=(a341*a453);
  a119=(2.*a119);
  a505=(a373*a505);
  a378=(a378/a109);
  a109=(a373/a109);
  a109=(a109*a480);
  a378=(a378-a109);
  a337=(a337*a378);
  a505=(a505+a337);
  a505=(a505/a070);
  a070=(a292/a070);
  a337=(2.*a526);
  a070=(a070*a337);
  a505=(a505-a070);
  a070=(a525/a323);
  a337=(a067/a323);
  a337=(a337*a529);
  a070=(a070-a337);
  a070=(a366*a070);
  a522=(a306*a522);
  a337=(a259*a509);
  a109=(a380*a511);
  a507=(a320*a507);
  a504=(a289*a504);
  a373=(a373*a526);
  a338=(a338*a378);
  a373=(a373+a338);
  a308=(a308*a373);
  a504=(a504+a308);
  a063=(a063*a504);
  a335=sin(a335);
  a335=(a335*a508);
  a474=(a474*a335);
  a063=(a063-a474);
  a309=(a309*a063);
  a507=(a507+a309);
  a507=(a507/a303);
  a303=(a380/a303);
  a333=(2.*a333);
  a333=(a333*a510);
  a303=(a303*a333);
  a507=(a507-a303);
  a311=(a311*a507);
  a109=(a109+a311);
  a109=(a109/a300);
  a300=(a259/a300);
  a328=(2.*a328);
  a328=(a328*a513);
  a300=(a300*a328);
  a109=(a109-a300);
  a300=(a310*a109);
  a337=(a337+a300);
  a511=(a298*a511);
  a300=(a380*a509);
  a328=(a310*a507);
  a300=(a300+a328);
  a331=(a331*a300);
  a511=(a511+a331);
  a337=(a337-a511);
  a255=(a255*a337);
  a477=(a477*a255);
  a511=(a477/a252);
  a331=(a306/a252);
  a331=(a331*a385);
  a511=(a511-a331);
  a319=(a319*a511);
  a522=(a522+a319);
  a319=arg[12]? arg[12][9] : 0;
  a319=(a319/a383);
  a503=(a503/a383);
  a383=(2.*a324);
  a383=(a383*a525);
  a503=(a503*a383);
  a319=(a319-a503);
  a522=(a522+a319);
  a067=(a067*a522);
  a070=(a070+a067);
  a070=(a070/a381);
  a377=(a377/a381);
  a381=(2.*a529);
  a377=(a377*a381);
  a070=(a070-a377);
  a070=(a505-a070);
  a377=(a119*a070);
  a453=(a453+a377);
  a295=(a295+a453);
  a033=(a033*a295);
  a294=(a294*a297);
  a296=(a296-a294);
  a119=(a119*a341);
  a296=(a296+a119);
  a467=(a296*a467);
  a033=(a033-a467);
  a001=(a001+a033);
  a033=(2.*a111);
  a467=(a033*a292);
  a111=(2.*a111);
  a119=(a111*a297);
  a467=(a467-a119);
  a366=(a366/a323);
  a467=(a467+a366);
  a486=(a467*a486);
  a119=(2.*a483);
  a292=(a292*a119);
  a033=(a033*a505);
  a292=(a292+a033);
  a483=(2.*a483);
  a297=(a297*a483);
  a111=(a111*a481);
  a297=(a297+a111);
  a292=(a292-a297);
  a522=(a522/a323);
  a366=(a366/a323);
  a366=(a366*a529);
  a522=(a522-a366);
  a292=(a292+a522);
  a110=(a110*a292);
  a486=(a486+a110);
  a001=(a001-a486);
  a486=arg[2]? arg[2][2] : 0;
  a110=cos(a486);
  a522=(a034*a041);
  a366=arg[2]? arg[2][3] : 0;
  a529=(a522*a366);
  a323=(a003-a529);
  a297=(a323*a110);
  a111=(a041*a229);
  a111=(a111+a006);
  a481=sin(a486);
  a483=(a111*a481);
  a297=(a297-a483);
  a033=casadi_sq(a071);
  a505=casadi_sq(a033);
  a119=casadi_sq(a297);
  a294=cos(a486);
  a453=(a111*a294);
  a377=(a003-a529);
  a381=sin(a486);
  a067=(a377*a381);
  a453=(a453+a067);
  a067=casadi_sq(a453);
  a119=(a119+a067);
  a067=casadi_sq(a119);
  a505=(a505+a067);
  a505=sqrt(a505);
  a067=sqrt(a505);
  a319=(a297/a067);
  a503=arg[1]? arg[1][5] : 0;
  a383=arg[2]? arg[2][42] : 0;
  a331=arg[2]? arg[2][34] : 0;
  a328=arg[2]? arg[2][35] : 0;
  a116=(a116+a069);
  a069=(a035*a116);
  a069=(a069+a240);
  a069=(a034*a069);
  a069=(a069/a246);
  a240=(-a069);
  a513=casadi_fmax(a065,a240);
  a311=(a328*a513);
  a311=(a331+a311);
  a303=casadi_fmax(a144,a311);
  a333=(a383*a303);
  a510=arg[2]? arg[2][43] : 0;
  a309=(a333-a510);
  a474=(a503*a309);
  a474=(a474+a510);
  a474=(a474/a333);
  a510=(a474+a253);
  a335=(a319<=a510);
  a508=(a510<=a319);
  a504=(a508+a335);
  a335=(a335/a504);
  a308=(-a510);
  a338=casadi_fmin(a510,a319);
  a378=(a308<=a338);
  a526=(a338<=a308);
  a480=(a526+a378);
  a378=(a378/a480);
  a368=(a264*a474);
  a304=casadi_fmax(a308,a338);
  a363=(a263*a304);
  a368=(a368+a363);
  a368=(a368+a034);
  a363=(a065<=a368);
  a376=(a368<=a065);
  a376=(a376+a363);
  a363=(a363/a376);
  a376=cos(a043);
  a375=cos(a486);
  a369=(a375*a270);
  a372=(a376*a369);
  a365=(a230*a372);
  a364=sin(a486);
  a538=cos(a043);
  a360=(a538*a084);
  a342=(a364*a360);
  a502=(a230*a342);
  a365=(a365+a502);
  a502=sin(a486);
  a339=(a229*a089);
  a343=sin(a043);
  a540=(a227*a343);
  a541=(a540*a084);
  a541=(a339-a541);
  a542=(a502*a541);
  a365=(a365+a542);
  a542=sin(a486);
  a543=(a542*a093);
  a365=(a365+a543);
  a543=cos(a486);
  a544=(a034*a366);
  a545=(a544*a089);
  a546=(a540*a270);
  a546=(a545-a546);
  a546=(a546-a290);
  a547=(a543*a546);
  a365=(a365+a547);
  a547=arg[4]? arg[4][6] : 0;
  a365=(a365+a547);
  a547=(a333*a365);
  a548=(a513*a547);
  a549=(a264*a474);
  a550=(a263*a304);
  a549=(a549-a550);
  a549=(a549+a034);
  a550=casadi_fmax(a065,a549);
  a551=casadi_sq(a550);
  a552=(a550*a551);
  a552=(a293*a552);
  a553=(a034*a550);
  a553=(a072-a553);
  a554=(a552*a553);
  a304=(a304+a554);
  a554=casadi_fmax(a065,a368);
  a555=casadi_sq(a554);
  a556=(a554*a555);
  a556=(a293*a556);
  a557=(a034*a554);
  a557=(a072-a557);
  a558=(a556*a557);
  a304=(a304-a558);
  a558=(2.*a304);
  a559=casadi_sq(a304);
  a559=(a072-a559);
  a559=sqrt(a559);
  a560=(a264*a559);
  a561=(a559+a253);
  a562=(-a561);
  a563=arg[2]? arg[2][40] : 0;
  a564=arg[2]? arg[2][39] : 0;
  a565=arg[2]? arg[2][37] : 0;
  a566=arg[2]? arg[2][38] : 0;
  a567=(a566-a072);
  a568=casadi_fmax(a011,a567);
  a568=sqrt(a568);
  a569=(a565*a568);
  a570=(1./a569);
  a571=(-a570);
  a572=arg[2]? arg[2][32] : 0;
  a573=arg[2]? arg[2][33] : 0;
  a574=(a573*a513);
  a574=(a572+a574);
  a575=casadi_fmax(a065,a574);
  a576=casadi_sq(a297);
  a576=(a576+a322);
  a577=sqrt(a576);
  a578=(a453/a577);
  a579=(a575*a578);
  a579=(a579/a333);
  a580=casadi_fmin(a579,a570);
  a581=casadi_fmax(a571,a580);
  a582=(a072-a566);
  a583=(a581*a582);
  a584=(a565*a581);
  a585=atan(a584);
  a586=(a566*a585);
  a586=(a586/a565);
  a583=(a583+a586);
  a587=(a565*a583);
  a588=atan(a587);
  a589=(a564*a588);
  a590=sin(a589);
  a591=(a563*a590);
  a592=casadi_sq(a453);
  a592=(a592+a576);
  a592=sqrt(a592);
  a576=(a591*a592);
  a576=(a576/a067);
  a593=casadi_fmin(a561,a576);
  a594=casadi_fmax(a562,a593);
  a595=(a263*a594);
  a560=(a560+a595);
  a560=(a560+a034);
  a595=(a065<=a560);
  a596=(a560<=a065);
  a596=(a596+a595);
  a595=(a595/a596);
  a596=casadi_fmax(a065,a560);
  a597=casadi_sq(a596);
  a598=(a596*a597);
  a598=(a293*a598);
  a599=sin(a486);
  a600=cos(a043);
  a601=(a600*a270);
  a602=(a599*a601);
  a603=(a230*a602);
  a604=sin(a043);
  a605=cos(a486);
  a606=(a605*a084);
  a607=(a604*a606);
  a608=(a227*a607);
  a603=(a603+a608);
  a608=cos(a486);
  a609=cos(a043);
  a610=(a230*a609);
  a611=(a610*a084);
  a611=(a611+a339);
  a611=(a611+a093);
  a339=(a608*a611);
  a603=(a603-a339);
  a339=sin(a486);
  a612=(a540*a270);
  a545=(a545-a612);
  a545=(a545-a290);
  a612=(a339*a545);
  a603=(a603+a612);
  a612=arg[4]? arg[4][7] : 0;
  a603=(a603+a612);
  a612=(a333*a603);
  a613=(a513*a612);
  a614=(a598*a613);
  a614=(a034*a614);
  a615=(a034*a596);
  a615=(a072-a615);
  a616=(a615*a613);
  a616=(a293*a616);
  a617=(a597*a616);
  a614=(a614-a617);
  a617=(2.*a596);
  a618=(a596*a616);
  a619=(a617*a618);
  a614=(a614-a619);
  a614=(a595*a614);
  a619=(a264*a614);
  a620=(a264*a559);
  a621=(a263*a594);
  a620=(a620-a621);
  a620=(a620+a034);
  a621=(a065<=a620);
  a622=(a620<=a065);
  a622=(a622+a621);
  a621=(a621/a622);
  a622=casadi_fmax(a065,a620);
  a623=casadi_sq(a622);
  a624=(a034*a622);
  a624=(a072-a624);
  a625=(a624*a613);
  a625=(a293*a625);
  a626=(a623*a625);
  a627=(a622*a623);
  a627=(a293*a627);
  a628=(a627*a613);
  a628=(a034*a628);
  a626=(a626-a628);
  a628=(2.*a622);
  a629=(a622*a625);
  a630=(a628*a629);
  a626=(a626+a630);
  a626=(a621*a626);
  a630=(a264*a626);
  a619=(a619+a630);
  a630=(a561<=a576);
  a631=(a576<=a561);
  a632=(a630+a631);
  a630=(a630/a632);
  a633=(a562<=a593);
  a634=(a593<=a562);
  a635=(a634+a633);
  a633=(a633/a635);
  a614=(a263*a614);
  a614=(a614+a613);
  a626=(a263*a626);
  a614=(a614-a626);
  a626=(a633*a614);
  a636=(a630*a626);
  a634=(a634/a635);
  a614=(a634*a614);
  a636=(a636-a614);
  a619=(a619+a636);
  a636=(2.*a559);
  a619=(a619/a636);
  a614=(a558*a619);
  a548=(a548-a614);
  a614=(a065<=a368);
  a368=(a368<=a065);
  a368=(a368+a614);
  a614=(a614/a368);
  a368=arg[9]? arg[9][5] : 0;
  a635=(a309*a368);
  a637=arg[10]? arg[10][42] : 0;
  a638=(a303*a637);
  a639=(a144<=a311);
  a640=(a311<=a144);
  a640=(a640+a639);
  a639=(a639/a640);
  a640=arg[10]? arg[10][34] : 0;
  a641=arg[10]? arg[10][35] : 0;
  a642=(a513*a641);
  a643=(a065<=a240);
  a644=(a240<=a065);
  a644=(a644+a643);
  a643=(a643/a644);
  a644=(a116*a392);
  a461=(a461+a464);
  a464=(a035*a461);
  a644=(a644+a464);
  a644=(a644+a442);
  a644=(a034*a644);
  a644=(a644/a246);
  a442=(a069/a246);
  a442=(a442*a466);
  a644=(a644-a442);
  a643=(a643*a644);
  a442=(a328*a643);
  a642=(a642-a442);
  a642=(a640+a642);
  a639=(a639*a642);
  a642=(a383*a639);
  a638=(a638+a642);
  a642=arg[10]? arg[10][43] : 0;
  a442=(a638-a642);
  a464=(a503*a442);
  a635=(a635+a464);
  a635=(a635+a642);
  a635=(a635/a333);
  a642=(a474/a333);
  a642=(a642*a638);
  a635=(a635-a642);
  a642=(a264*a635);
  a464=(a308<=a338);
  a338=(a338<=a308);
  a308=(a338+a464);
  a464=(a464/a308);
  a645=(a510<=a319);
  a510=(a319<=a510);
  a646=(a645+a510);
  a645=(a645/a646);
  a645=(a645*a635);
  a510=(a510/a646);
  a646=(a034*a149);
  a647=(a366*a646);
  a648=arg[10]? arg[10][3] : 0;
  a649=(a522*a648);
  a647=(a647+a649);
  a649=(a013-a647);
  a650=(a110*a649);
  a651=sin(a486);
  a652=arg[10]? arg[10][2] : 0;
  a651=(a651*a652);
  a653=(a323*a651);
  a650=(a650-a653);
  a653=(a229*a149);
  a654=(a041*a439);
  a653=(a653+a654);
  a653=(a653+a017);
  a654=(a481*a653);
  a655=cos(a486);
  a655=(a655*a652);
  a656=(a111*a655);
  a654=(a654+a656);
  a650=(a650-a654);
  a656=(a650/a067);
  a657=(a319/a067);
  a658=(2.*a033);
  a659=(2.*a071);
  a659=(a659*a479);
  a658=(a658*a659);
  a660=(2.*a119);
  a661=(2.*a297);
  a661=(a661*a650);
  a662=(2.*a453);
  a663=(a294*a653);
  a664=sin(a486);
  a664=(a664*a652);
  a665=(a111*a664);
  a663=(a663-a665);
  a665=(a013-a647);
  a666=(a381*a665);
  a667=cos(a486);
  a667=(a667*a652);
  a668=(a377*a667);
  a666=(a666+a668);
  a663=(a663+a666);
  a662=(a662*a663);
  a661=(a661+a662);
  a660=(a660*a661);
  a658=(a658+a660);
  a660=(2.*a505);
  a658=(a658/a660);
  a660=(2.*a067);
  a660=(a658/a660);
  a657=(a657*a660);
  a656=(a656-a657);
  a510=(a510*a656);
  a645=(a645+a510);
  a464=(a464*a645);
  a338=(a338/a308);
  a338=(a338*a635);
  a464=(a464-a338);
  a338=(a263*a464);
  a642=(a642+a338);
  a614=(a614*a642);
  a642=(a555*a614);
  a338=(2.*a554);
  a338=(a338*a614);
  a308=(a554*a338);
  a642=(a642+a308);
  a642=(a293*a642);
  a308=(a548*a642);
  a645=(a365*a638);
  a510=(a372*a441);
  a375=(a375*a482);
  a657=sin(a486);
  a657=(a657*a652);
  a657=(a270*a657);
  a375=(a375-a657);
  a657=(a376*a375);
  a662=sin(a043);
  a662=(a662*a154);
  a666=(a369*a662);
  a657=(a657-a666);
  a666=(a230*a657);
  a510=(a510+a666);
  a666=(a342*a441);
  a668=cos(a486);
  a668=(a668*a652);
  a669=(a360*a668);
  a538=(a538*a169);
  a670=sin(a043);
  a670=(a670*a154);
  a670=(a084*a670);
  a538=(a538-a670);
  a670=(a364*a538);
  a669=(a669+a670);
  a670=(a230*a669);
  a666=(a666+a670);
  a510=(a510+a666);
  a666=cos(a486);
  a666=(a666*a652);
  a670=(a541*a666);
  a671=(a089*a439);
  a672=(a229*a087);
  a671=(a671+a672);
  a672=(a343*a438);
  a673=cos(a043);
  a673=(a673*a154);
  a674=(a227*a673);
  a672=(a672+a674);
  a674=(a084*a672);
  a675=(a540*a169);
  a674=(a674+a675);
  a674=(a671-a674);
  a675=(a502*a674);
  a670=(a670+a675);
  a510=(a510+a670);
  a670=cos(a486);
  a670=(a670*a652);
  a675=(a093*a670);
  a676=(a542*a172);
  a675=(a675+a676);
  a510=(a510+a675);
  a675=(a034*a648);
  a675=(a089*a675);
  a544=(a544*a087);
  a675=(a675+a544);
  a544=(a270*a672);
  a676=(a540*a482);
  a544=(a544+a676);
  a544=(a675-a544);
  a544=(a544-a496);
  a676=(a543*a544);
  a677=sin(a486);
  a677=(a677*a652);
  a678=(a546*a677);
  a676=(a676-a678);
  a510=(a510+a676);
  a676=arg[12]? arg[12][6] : 0;
  a510=(a510+a676);
  a676=(a333*a510);
  a645=(a645+a676);
  a676=(a513*a645);
  a678=(a547*a643);
  a676=(a676-a678);
  a678=(a065<=a549);
  a679=(a549<=a065);
  a679=(a679+a678);
  a678=(a678/a679);
  a679=(a264*a635);
  a680=(a263*a464);
  a679=(a679-a680);
  a678=(a678*a679);
  a679=(a551*a678);
  a680=(2.*a550);
  a680=(a680*a678);
  a681=(a550*a680);
  a679=(a679+a681);
  a679=(a293*a679);
  a681=(a553*a679);
  a682=(a034*a678);
  a683=(a552*a682);
  a681=(a681-a683);
  a464=(a464+a681);
  a642=(a557*a642);
  a681=(a034*a614);
  a683=(a556*a681);
  a642=(a642-a683);
  a464=(a464-a642);
  a642=(2.*a464);
  a642=(a619*a642);
  a683=(a065<=a560);
  a560=(a560<=a065);
  a560=(a560+a683);
  a683=(a683/a560);
  a560=(a593<=a562);
  a562=(a562<=a593);
  a593=(a560+a562);
  a560=(a560/a593);
  a684=(2.*a304);
  a684=(a684*a464);
  a559=(2.*a559);
  a684=(a684/a559);
  a560=(a560*a684);
  a562=(a562/a593);
  a593=(a576<=a561);
  a561=(a561<=a576);
  a559=(a561+a593);
  a593=(a593/a559);
  a685=arg[10]? arg[10][40] : 0;
  a686=(a590*a685);
  a687=cos(a589);
  a688=arg[10]? arg[10][39] : 0;
  a689=(a588*a688);
  a690=arg[10]? arg[10][37] : 0;
  a691=(a583*a690);
  a692=(a580<=a571);
  a693=(a571<=a580);
  a694=(a692+a693);
  a692=(a692/a694);
  a695=(a570/a569);
  a696=(a568*a690);
  a697=(a011<=a567);
  a698=(a567<=a011);
  a698=(a698+a697);
  a697=(a697/a698);
  a698=arg[10]? arg[10][38] : 0;
  a697=(a697*a698);
  a699=(2.*a568);
  a697=(a697/a699);
  a699=(a565*a697);
  a696=(a696+a699);
  a695=(a695*a696);
  a692=(a692*a695);
  a693=(a693/a694);
  a694=(a579<=a570);
  a699=(a570<=a579);
  a700=(a694+a699);
  a694=(a694/a700);
  a701=(a065<=a574);
  a702=(a574<=a065);
  a702=(a702+a701);
  a701=(a701/a702);
  a702=arg[10]? arg[10][32] : 0;
  a703=arg[10]? arg[10][33] : 0;
  a704=(a513*a703);
  a705=(a573*a643);
  a704=(a704-a705);
  a704=(a702+a704);
  a701=(a701*a704);
  a704=(a578*a701);
  a705=(a663/a577);
  a706=(a578/a577);
  a707=(2.*a297);
  a707=(a707*a650);
  a707=(a707+a528);
  a708=(2.*a577);
  a708=(a707/a708);
  a706=(a706*a708);
  a705=(a705-a706);
  a706=(a575*a705);
  a704=(a704+a706);
  a704=(a704/a333);
  a706=(a579/a333);
  a706=(a706*a638);
  a704=(a704-a706);
  a694=(a694*a704);
  a699=(a699/a700);
  a699=(a699*a695);
  a694=(a694-a699);
  a693=(a693*a694);
  a692=(a692+a693);
  a693=(a582*a692);
  a694=(a581*a698);
  a693=(a693-a694);
  a694=(a585*a698);
  a699=(a581*a690);
  a700=(a565*a692);
  a699=(a699+a700);
  a700=casadi_sq(a584);
  a700=(a072+a700);
  a700=(a699/a700);
  a706=(a566*a700);
  a694=(a694+a706);
  a694=(a694/a565);
  a706=(a586/a565);
  a706=(a706*a690);
  a694=(a694-a706);
  a693=(a693+a694);
  a706=(a565*a693);
  a691=(a691+a706);
  a706=casadi_sq(a587);
  a706=(a072+a706);
  a706=(a691/a706);
  a709=(a564*a706);
  a689=(a689+a709);
  a687=(a687*a689);
  a709=(a563*a687);
  a686=(a686+a709);
  a709=(a592*a686);
  a710=(2.*a453);
  a710=(a710*a663);
  a710=(a710+a707);
  a707=(2.*a592);
  a710=(a710/a707);
  a707=(a591*a710);
  a709=(a709+a707);
  a709=(a709/a067);
  a707=(a576/a067);
  a707=(a707*a660);
  a709=(a709-a707);
  a593=(a593*a709);
  a561=(a561/a559);
  a561=(a561*a684);
  a593=(a593-a561);
  a562=(a562*a593);
  a560=(a560+a562);
  a562=(a263*a560);
  a593=(a264*a684);
  a562=(a562-a593);
  a683=(a683*a562);
  a562=(a597*a683);
  a593=(2.*a596);
  a593=(a593*a683);
  a561=(a596*a593);
  a562=(a562+a561);
  a562=(a293*a562);
  a561=(a613*a562);
  a559=(a603*a638);
  a707=(a602*a441);
  a711=cos(a486);
  a711=(a711*a652);
  a712=(a601*a711);
  a600=(a600*a482);
  a713=sin(a043);
  a713=(a713*a154);
  a713=(a270*a713);
  a600=(a600-a713);
  a713=(a599*a600);
  a712=(a712+a713);
  a713=(a230*a712);
  a707=(a707+a713);
  a713=(a607*a438);
  a714=cos(a043);
  a714=(a714*a154);
  a715=(a606*a714);
  a605=(a605*a169);
  a716=sin(a486);
  a716=(a716*a652);
  a716=(a084*a716);
  a605=(a605-a716);
  a716=(a604*a605);
  a715=(a715+a716);
  a716=(a227*a715);
  a713=(a713+a716);
  a707=(a707+a713);
  a713=(a609*a441);
  a716=sin(a043);
  a716=(a716*a154);
  a717=(a230*a716);
  a713=(a713-a717);
  a717=(a084*a713);
  a718=(a610*a169);
  a717=(a717+a718);
  a717=(a717+a671);
  a717=(a717+a172);
  a671=(a608*a717);
  a718=sin(a486);
  a718=(a718*a652);
  a719=(a611*a718);
  a671=(a671-a719);
  a707=(a707-a671);
  a671=cos(a486);
  a671=(a671*a652);
  a719=(a545*a671);
  a720=(a270*a672);
  a721=(a540*a482);
  a720=(a720+a721);
  a675=(a675-a720);
  a675=(a675-a496);
  a720=(a339*a675);
  a719=(a719+a720);
  a707=(a707+a719);
  a719=arg[12]? arg[12][7] : 0;
  a707=(a707+a719);
  a719=(a333*a707);
  a559=(a559+a719);
  a719=(a513*a559);
  a720=(a612*a643);
  a719=(a719-a720);
  a720=(a598*a719);
  a561=(a561+a720);
  a561=(a034*a561);
  a593=(a616*a593);
  a720=(a615*a719);
  a721=(a034*a683);
  a722=(a613*a721);
  a720=(a720-a722);
  a720=(a293*a720);
  a597=(a597*a720);
  a593=(a593+a597);
  a561=(a561-a593);
  a593=(2.*a683);
  a618=(a618*a593);
  a616=(a616*a683);
  a596=(a596*a720);
  a616=(a616+a596);
  a617=(a617*a616);
  a618=(a618+a617);
  a561=(a561-a618);
  a595=(a595*a561);
  a561=(a264*a595);
  a618=(a065<=a620);
  a620=(a620<=a065);
  a620=(a620+a618);
  a618=(a618/a620);
  a620=(a264*a684);
  a617=(a263*a560);
  a620=(a620+a617);
  a618=(a618*a620);
  a620=(a034*a618);
  a617=(a613*a620);
  a616=(a624*a719);
  a617=(a617+a616);
  a617=(a293*a617);
  a616=(a623*a617);
  a596=(2.*a622);
  a596=(a596*a618);
  a720=(a625*a596);
  a616=(a616-a720);
  a720=(a627*a719);
  a623=(a623*a618);
  a596=(a622*a596);
  a623=(a623+a596);
  a623=(a293*a623);
  a613=(a613*a623);
  a720=(a720-a613);
  a720=(a034*a720);
  a616=(a616-a720);
  a720=(-a618);
  a720=(2.*a720);
  a629=(a629*a720);
  a622=(a622*a617);
  a625=(a625*a618);
  a622=(a622-a625);
  a628=(a628*a622);
  a629=(a629+a628);
  a616=(a616+a629);
  a621=(a621*a616);
  a616=(a264*a621);
  a561=(a561+a616);
  a595=(a263*a595);
  a595=(a595+a719);
  a621=(a263*a621);
  a595=(a595-a621);
  a633=(a633*a595);
  a630=(a630*a633);
  a634=(a634*a595);
  a630=(a630-a634);
  a561=(a561+a630);
  a561=(a561/a636);
  a619=(a619/a636);
  a684=(-a684);
  a684=(2.*a684);
  a619=(a619*a684);
  a561=(a561-a619);
  a558=(a558*a561);
  a642=(a642+a558);
  a676=(a676-a642);
  a642=(a556*a676);
  a308=(a308+a642);
  a308=(a034*a308);
  a642=(a557*a548);
  a642=(a293*a642);
  a338=(a642*a338);
  a557=(a557*a676);
  a681=(a548*a681);
  a557=(a557-a681);
  a557=(a293*a557);
  a681=(a555*a557);
  a338=(a338+a681);
  a308=(a308-a338);
  a338=(a554*a642);
  a681=(2.*a614);
  a681=(a338*a681);
  a558=(2.*a554);
  a614=(a642*a614);
  a554=(a554*a557);
  a614=(a614+a554);
  a614=(a558*a614);
  a681=(a681+a614);
  a308=(a308-a681);
  a308=(a363*a308);
  a681=(a263*a308);
  a681=(a681+a676);
  a614=(a065<=a549);
  a549=(a549<=a065);
  a549=(a549+a614);
  a614=(a614/a549);
  a549=(a553*a548);
  a549=(a293*a549);
  a680=(a549*a680);
  a553=(a553*a676);
  a682=(a548*a682);
  a553=(a553-a682);
  a553=(a293*a553);
  a682=(a551*a553);
  a680=(a680+a682);
  a679=(a548*a679);
  a676=(a552*a676);
  a679=(a679+a676);
  a679=(a034*a679);
  a680=(a680-a679);
  a679=(a550*a549);
  a676=(2.*a678);
  a676=(a679*a676);
  a682=(2.*a550);
  a678=(a549*a678);
  a550=(a550*a553);
  a678=(a678+a550);
  a678=(a682*a678);
  a676=(a676+a678);
  a680=(a680+a676);
  a680=(a614*a680);
  a676=(a263*a680);
  a681=(a681-a676);
  a676=(a378*a681);
  a678=(a335*a676);
  a550=(a678/a067);
  a556=(a556*a548);
  a556=(a034*a556);
  a555=(a555*a642);
  a556=(a556-a555);
  a558=(a558*a338);
  a556=(a556-a558);
  a363=(a363*a556);
  a556=(a263*a363);
  a556=(a556+a548);
  a551=(a551*a549);
  a552=(a552*a548);
  a552=(a034*a552);
  a551=(a551-a552);
  a682=(a682*a679);
  a551=(a551+a682);
  a614=(a614*a551);
  a551=(a263*a614);
  a556=(a556-a551);
  a378=(a378*a556);
  a335=(a335*a378);
  a551=(a335/a067);
  a682=(a551/a067);
  a682=(a682*a660);
  a550=(a550-a682);
  a119=(2.*a119);
  a576=(a576/a067);
  a631=(a631/a632);
  a626=(a631*a626);
  a632=(a576*a626);
  a319=(a319/a067);
  a682=(a319*a335);
  a632=(a632+a682);
  a682=(2.*a067);
  a632=(a632/a682);
  a505=(2.*a505);
  a679=(a632/a505);
  a552=(a119*a679);
  a548=(2.*a650);
  a548=(a552*a548);
  a549=(2.*a297);
  a661=(2.*a661);
  a661=(a679*a661);
  a709=(a709/a067);
  a558=(a576/a067);
  a558=(a558*a660);
  a709=(a709-a558);
  a709=(a626*a709);
  a631=(a631*a633);
  a576=(a576*a631);
  a709=(a709+a576);
  a656=(a656/a067);
  a576=(a319/a067);
  a576=(a576*a660);
  a656=(a656-a576);
  a335=(a335*a656);
  a319=(a319*a678);
  a335=(a335+a319);
  a709=(a709+a335);
  a709=(a709/a682);
  a632=(a632/a682);
  a682=(2.*a660);
  a632=(a632*a682);
  a709=(a709-a632);
  a709=(a709/a505);
  a505=(a679/a505);
  a658=(2.*a658);
  a505=(a505*a658);
  a709=(a709-a505);
  a119=(a119*a709);
  a661=(a661+a119);
  a119=(a549*a661);
  a548=(a548+a119);
  a550=(a550-a548);
  a626=(a626/a067);
  a548=(a591*a626);
  a119=(2.*a592);
  a548=(a548/a119);
  a505=(a578/a577);
  a658=(a579<=a570);
  a632=(a570<=a579);
  a682=(a658+a632);
  a658=(a658/a682);
  a335=(a571<=a580);
  a580=(a580<=a571);
  a571=(a580+a335);
  a335=(a335/a571);
  a319=cos(a589);
  a678=(a592*a626);
  a656=(a563*a678);
  a576=(a319*a656);
  a633=(a564*a576);
  a558=casadi_sq(a587);
  a558=(a072+a558);
  a633=(a633/a558);
  a338=(a566*a633);
  a555=casadi_sq(a584);
  a555=(a072+a555);
  a338=(a338/a555);
  a642=(a565*a338);
  a553=(a565*a633);
  a554=(a582*a553);
  a642=(a642+a554);
  a554=(a335*a642);
  a557=(a658*a554);
  a561=(a557/a333);
  a619=(a575*a561);
  a684=arg[4]? arg[4][5] : 0;
  a636=casadi_sq(a578);
  a636=(a072+a636);
  a684=(a684/a636);
  a619=(a619+a684);
  a630=(a505*a619);
  a634=(2.*a577);
  a630=(a630/a634);
  a595=(a548-a630);
  a650=(2.*a650);
  a650=(a595*a650);
  a297=(2.*a297);
  a686=(a626*a686);
  a631=(a631/a067);
  a067=(a626/a067);
  a067=(a067*a660);
  a631=(a631-a067);
  a591=(a591*a631);
  a686=(a686+a591);
  a686=(a686/a119);
  a119=(a548/a119);
  a591=(2.*a710);
  a119=(a119*a591);
  a686=(a686-a119);
  a119=(a705/a577);
  a591=(a505/a577);
  a591=(a591*a708);
  a119=(a119-a591);
  a119=(a619*a119);
  a701=(a561*a701);
  a591=(a338*a690);
  a067=(a633*a698);
  a660=(a576*a688);
  a621=(a678*a685);
  a626=(a626*a710);
  a592=(a592*a631);
  a626=(a626+a592);
  a592=(a563*a626);
  a621=(a621+a592);
  a319=(a319*a621);
  a589=sin(a589);
  a589=(a589*a689);
  a656=(a656*a589);
  a319=(a319-a656);
  a656=(a564*a319);
  a660=(a660+a656);
  a660=(a660/a558);
  a558=(a633/a558);
  a587=(2.*a587);
  a587=(a587*a691);
  a558=(a558*a587);
  a660=(a660-a558);
  a558=(a566*a660);
  a067=(a067+a558);
  a067=(a067/a555);
  a555=(a338/a555);
  a584=(2.*a584);
  a584=(a584*a699);
  a555=(a555*a584);
  a067=(a067-a555);
  a555=(a565*a067);
  a591=(a591+a555);
  a555=(a633*a690);
  a584=(a565*a660);
  a555=(a555+a584);
  a582=(a582*a555);
  a584=(a553*a698);
  a582=(a582-a584);
  a591=(a591+a582);
  a335=(a335*a591);
  a658=(a658*a335);
  a582=(a658/a333);
  a584=(a561/a333);
  a584=(a584*a638);
  a582=(a582-a584);
  a575=(a575*a582);
  a701=(a701+a575);
  a575=arg[12]? arg[12][5] : 0;
  a575=(a575/a636);
  a684=(a684/a636);
  a636=(2.*a578);
  a636=(a636*a705);
  a684=(a684*a636);
  a575=(a575-a684);
  a701=(a701+a575);
  a505=(a505*a701);
  a119=(a119+a505);
  a119=(a119/a634);
  a630=(a630/a634);
  a634=(2.*a708);
  a630=(a630*a634);
  a119=(a119-a630);
  a119=(a686-a119);
  a630=(a297*a119);
  a650=(a650+a630);
  a550=(a550+a650);
  a650=(a110*a550);
  a549=(a549*a552);
  a551=(a551-a549);
  a297=(a297*a595);
  a551=(a551+a297);
  a651=(a551*a651);
  a650=(a650-a651);
  a001=(a001+a650);
  a651=(2.*a453);
  a297=(a651*a548);
  a453=(2.*a453);
  a549=(a453*a552);
  a297=(a297-a549);
  a619=(a619/a577);
  a297=(a297+a619);
  a667=(a297*a667);
  a549=(2.*a663);
  a548=(a548*a549);
  a651=(a651*a686);
  a548=(a548+a651);
  a663=(2.*a663);
  a552=(a552*a663);
  a453=(a453*a661);
  a552=(a552+a453);
  a548=(a548-a552);
  a701=(a701/a577);
  a619=(a619/a577);
  a619=(a619*a708);
  a701=(a701-a619);
  a548=(a548+a701);
  a701=(a381*a548);
  a667=(a667+a701);
  a001=(a001+a667);
  a701=cos(a486);
  a619=(a003+a529);
  a708=(a619*a701);
  a483=(a483+a708);
  a708=casadi_sq(a071);
  a577=casadi_sq(a708);
  a552=casadi_sq(a483);
  a453=cos(a486);
  a661=(a111*a453);
  a529=(a003+a529);
  a663=sin(a486);
  a651=(a529*a663);
  a661=(a661-a651);
  a651=casadi_sq(a661);
  a552=(a552+a651);
  a651=casadi_sq(a552);
  a577=(a577+a651);
  a577=sqrt(a577);
  a651=sqrt(a577);
  a686=(a483/a651);
  a549=arg[1]? arg[1][4] : 0;
  a630=arg[2]? arg[2][36] : 0;
  a634=(a328*a513);
  a331=(a331+a634);
  a634=casadi_fmax(a144,a331);
  a505=(a630*a634);
  a575=arg[2]? arg[2][41] : 0;
  a684=(a505-a575);
  a636=(a549*a684);
  a636=(a636+a575);
  a636=(a636/a505);
  a575=(a636+a253);
  a584=(a686<=a575);
  a699=(a575<=a686);
  a558=(a699+a584);
  a584=(a584/a558);
  a587=(-a575);
  a691=casadi_fmin(a575,a686);
  a656=(a587<=a691);
  a589=(a691<=a587);
  a689=(a589+a656);
  a656=(a656/a689);
  a621=(a264*a636);
  a592=casadi_fmax(a587,a691);
  a631=(a263*a592);
  a621=(a621+a631);
  a621=(a621+a034);
  a631=(a065<=a621);
  a710=(a621<=a065);
  a710=(a710+a631);
  a631=(a631/a710);
  a710=cos(a043);
  a719=cos(a486);
  a616=(a719*a270);
  a629=(a710*a616);
  a628=(a230*a629);
  a622=sin(a043);
  a625=sin(a486);
  a618=(a625*a084);
  a617=(a622*a618);
  a720=(a227*a617);
  a628=(a628+a720);
  a720=sin(a486);
  a613=(a610*a084);
  a596=(a229*a089);
  a613=(a613+a596);
  a613=(a613+a093);
  a683=(a720*a613);
  a628=(a628-a683);
  a683=cos(a486);
  a593=(a540*a270);
  a597=(a034*a366);
  a722=(a597*a089);
  a722=(a722+a290);
  a593=(a593+a722);
  a723=(a683*a593);
  a628=(a628-a723);
  a723=arg[4]? arg[4][2] : 0;
  a628=(a628+a723);
  a723=(a505*a628);
  a724=(a513*a723);
  a725=(a264*a636);
  a726=(a263*a592);
  a725=(a725-a726);
  a725=(a725+a034);
  a726=casadi_fmax(a065,a725);
  a727=casadi_sq(a726);
  a728=(a726*a727);
  a728=(a293*a728);
  a729=(a034*a726);
  a729=(a072-a729);
  a730=(a728*a729);
  a592=(a592+a730);
  a730=casadi_fmax(a065,a621);
  a731=casadi_sq(a730);
  a732=(a730*a731);
  a732=(a293*a732);
  a733=(a034*a730);
  a733=(a072-a733);
  a734=(a732*a733);
  a592=(a592-a734);
  a734=(2.*a592);
  a735=casadi_sq(a592);
  a735=(a072-a735);
  a735=sqrt(a735);
  a736=(a264*a735);
  a253=(a735+a253);
  a737=(-a253);
  a738=(-a570);
  a739=(a573*a513);
  a572=(a572+a739);
  a739=casadi_fmax(a065,a572);
  a740=casadi_sq(a483);
  a740=(a740+a322);
  a322=sqrt(a740);
  a741=(a661/a322);
  a742=(a739*a741);
  a742=(a742/a505);
  a743=casadi_fmin(a742,a570);
  a744=casadi_fmax(a738,a743);
  a745=(a072-a566);
  a746=(a744*a745);
  a747=(a565*a744);
  a748=atan(a747);
  a749=(a566*a748);
  a749=(a749/a565);
  a746=(a746+a749);
  a750=(a565*a746);
  a751=atan(a750);
  a752=(a564*a751);
  a753=sin(a752);
  a754=(a563*a753);
  a755=casadi_sq(a661);
  a755=(a755+a740);
  a755=sqrt(a755);
  a740=(a754*a755);
  a740=(a740/a651);
  a756=casadi_fmin(a253,a740);
  a757=casadi_fmax(a737,a756);
  a758=(a263*a757);
  a736=(a736+a758);
  a736=(a736+a034);
  a758=(a065<=a736);
  a759=(a736<=a065);
  a759=(a759+a758);
  a758=(a758/a759);
  a759=casadi_fmax(a065,a736);
  a760=casadi_sq(a759);
  a761=(a759*a760);
  a761=(a293*a761);
  a762=sin(a043);
  a763=sin(a486);
  a764=(a763*a270);
  a765=(a762*a764);
  a766=(a227*a765);
  a767=sin(a486);
  a768=(a767*a270);
  a769=(a610*a768);
  a766=(a766-a769);
  a769=sin(a043);
  a770=cos(a486);
  a771=(a770*a084);
  a772=(a769*a771);
  a773=(a227*a772);
  a766=(a766+a773);
  a773=cos(a486);
  a774=(a610*a084);
  a774=(a774+a596);
  a774=(a774+a093);
  a596=(a773*a774);
  a766=(a766-a596);
  a596=sin(a486);
  a775=(a596*a722);
  a766=(a766+a775);
  a775=arg[4]? arg[4][3] : 0;
  a766=(a766+a775);
  a775=(a505*a766);
  a776=(a513*a775);
  a777=(a761*a776);
  a777=(a034*a777);
  a778=(a034*a759);
  a778=(a072-a778);
  a779=(a778*a776);
  a779=(a293*a779);
  a780=(a760*a779);
  a777=(a777-a780);
  a780=(2.*a759);
  a781=(a759*a779);
  a782=(a780*a781);
  a777=(a777-a782);
  a777=(a758*a777);
  a782=(a264*a777);
  a783=(a264*a735);
  a784=(a263*a757);
  a783=(a783-a784);
  a783=(a783+a034);
  a784=(a065<=a783);
  a785=(a783<=a065);
  a785=(a785+a784);
  a784=(a784/a785);
  a785=casadi_fmax(a065,a783);
  a786=casadi_sq(a785);
  a787=(a034*a785);
  a787=(a072-a787);
  a788=(a787*a776);
  a788=(a293*a788);
  a789=(a786*a788);
  a790=(a785*a786);
  a790=(a293*a790);
  a791=(a790*a776);
  a791=(a034*a791);
  a789=(a789-a791);
  a791=(2.*a785);
  a792=(a785*a788);
  a793=(a791*a792);
  a789=(a789+a793);
  a789=(a784*a789);
  a793=(a264*a789);
  a782=(a782+a793);
  a793=(a253<=a740);
  a794=(a740<=a253);
  a795=(a793+a794);
  a793=(a793/a795);
  a796=(a737<=a756);
  a797=(a756<=a737);
  a798=(a797+a796);
  a796=(a796/a798);
  a777=(a263*a777);
  a777=(a777+a776);
  a789=(a263*a789);
  a777=(a777-a789);
  a789=(a796*a777);
  a799=(a793*a789);
  a797=(a797/a798);
  a777=(a797*a777);
  a799=(a799-a777);
  a782=(a782+a799);
  a799=(2.*a735);
  a782=(a782/a799);
  a777=(a734*a782);
  a724=(a724-a777);
  a777=(a065<=a621);
  a621=(a621<=a065);
  a621=(a621+a777);
  a777=(a777/a621);
  a621=arg[9]? arg[9][4] : 0;
  a798=(a684*a621);
  a800=arg[10]? arg[10][36] : 0;
  a801=(a634*a800);
  a802=(a144<=a331);
  a803=(a331<=a144);
  a803=(a803+a802);
  a802=(a802/a803);
  a803=(a513*a641);
  a804=(a328*a643);
  a803=(a803-a804);
  a640=(a640+a803);
  a802=(a802*a640);
  a640=(a630*a802);
  a801=(a801+a640);
  a640=arg[10]? arg[10][41] : 0;
  a803=(a801-a640);
  a804=(a549*a803);
  a798=(a798+a804);
  a798=(a798+a640);
  a798=(a798/a505);
  a640=(a636/a505);
  a640=(a640*a801);
  a798=(a798-a640);
  a640=(a264*a798);
  a804=(a587<=a691);
  a691=(a691<=a587);
  a587=(a691+a804);
  a804=(a804/a587);
  a805=(a575<=a686);
  a575=(a686<=a575);
  a806=(a805+a575);
  a805=(a805/a806);
  a805=(a805*a798);
  a575=(a575/a806);
  a806=(a013+a647);
  a807=(a701*a806);
  a808=sin(a486);
  a808=(a808*a652);
  a809=(a619*a808);
  a807=(a807-a809);
  a654=(a654+a807);
  a807=(a654/a651);
  a809=(a686/a651);
  a810=(2.*a708);
  a811=(2.*a071);
  a811=(a811*a479);
  a810=(a810*a811);
  a812=(2.*a552);
  a813=(2.*a483);
  a813=(a813*a654);
  a814=(2.*a661);
  a815=(a453*a653);
  a816=sin(a486);
  a816=(a816*a652);
  a817=(a111*a816);
  a815=(a815-a817);
  a647=(a013+a647);
  a817=(a663*a647);
  a818=cos(a486);
  a818=(a818*a652);
  a819=(a529*a818);
  a817=(a817+a819);
  a815=(a815-a817);
  a814=(a814*a815);
  a813=(a813+a814);
  a812=(a812*a813);
  a810=(a810+a812);
  a812=(2.*a577);
  a810=(a810/a812);
  a812=(2.*a651);
  a812=(a810/a812);
  a809=(a809*a812);
  a807=(a807-a809);
  a575=(a575*a807);
  a805=(a805+a575);
  a804=(a804*a805);
  a691=(a691/a587);
  a691=(a691*a798);
  a804=(a804-a691);
  a691=(a263*a804);
  a640=(a640+a691);
  a777=(a777*a640);
  a640=(a731*a777);
  a691=(2.*a730);
  a691=(a691*a777);
  a587=(a730*a691);
  a640=(a640+a587);
  a640=(a293*a640);
  a587=(a724*a640);
  a805=(a628*a801);
  a575=(a629*a441);
  a719=(a719*a482);
  a809=sin(a486);
  a809=(a809*a652);
  a809=(a270*a809);
  a719=(a719-a809);
  a809=(a710*a719);
  a814=sin(a043);
  a814=(a814*a154);
  a817=(a616*a814);
  a809=(a809-a817);
  a817=(a230*a809);
  a575=(a575+a817);
  a817=(a617*a438);
  a819=cos(a043);
  a819=(a819*a154);
  a820=(a618*a819);
  a821=cos(a486);
  a821=(a821*a652);
  a821=(a084*a821);
  a625=(a625*a169);
  a821=(a821+a625);
  a625=(a622*a821);
  a820=(a820+a625);
  a625=(a227*a820);
  a817=(a817+a625);
  a575=(a575+a817);
  a817=cos(a486);
  a817=(a817*a652);
  a625=(a613*a817);
  a822=(a084*a713);
  a823=(a610*a169);
  a822=(a822+a823);
  a823=(a089*a439);
  a824=(a229*a087);
  a823=(a823+a824);
  a822=(a822+a823);
  a822=(a822+a172);
  a824=(a720*a822);
  a625=(a625+a824);
  a575=(a575-a625);
  a672=(a270*a672);
  a540=(a540*a482);
  a672=(a672+a540);
  a540=(a034*a648);
  a540=(a089*a540);
  a597=(a597*a087);
  a540=(a540+a597);
  a540=(a540+a496);
  a672=(a672+a540);
  a597=(a683*a672);
  a625=sin(a486);
  a625=(a625*a652);
  a824=(a593*a625);
  a597=(a597-a824);
  a575=(a575-a597);
  a597=arg[12]? arg[12][2] : 0;
  a575=(a575+a597);
  a597=(a505*a575);
  a805=(a805+a597);
  a597=(a513*a805);
  a824=(a723*a643);
  a597=(a597-a824);
  a824=(a065<=a725);
  a825=(a725<=a065);
  a825=(a825+a824);
  a824=(a824/a825);
  a825=(a264*a798);
  a826=(a263*a804);
  a825=(a825-a826);
  a824=(a824*a825);
  a825=(a727*a824);
  a826=(2.*a726);
  a826=(a826*a824);
  a827=(a726*a826);
  a825=(a825+a827);
  a825=(a293*a825);
  a827=(a729*a825);
  a828=(a034*a824);
  a829=(a728*a828);
  a827=(a827-a829);
  a804=(a804+a827);
  a640=(a733*a640);
  a827=(a034*a777);
  a829=(a732*a827);
  a640=(a640-a829);
  a804=(a804-a640);
  a640=(2.*a804);
  a640=(a782*a640);
  a829=(a065<=a736);
  a736=(a736<=a065);
  a736=(a736+a829);
  a829=(a829/a736);
  a736=(a756<=a737);
  a737=(a737<=a756);
  a756=(a736+a737);
  a736=(a736/a756);
  a830=(2.*a592);
  a830=(a830*a804);
  a735=(2.*a735);
  a830=(a830/a735);
  a736=(a736*a830);
  a737=(a737/a756);
  a756=(a740<=a253);
  a253=(a253<=a740);
  a735=(a253+a756);
  a756=(a756/a735);
  a831=(a753*a685);
  a832=cos(a752);
  a833=(a751*a688);
  a834=(a746*a690);
  a835=(a743<=a738);
  a836=(a738<=a743);
  a837=(a835+a836);
  a835=(a835/a837);
  a835=(a835*a695);
  a836=(a836/a837);
  a837=(a742<=a570);
  a838=(a570<=a742);
  a839=(a837+a838);
  a837=(a837/a839);
  a840=(a065<=a572);
  a841=(a572<=a065);
  a841=(a841+a840);
  a840=(a840/a841);
  a841=(a513*a703);
  a842=(a573*a643);
  a841=(a841-a842);
  a702=(a702+a841);
  a840=(a840*a702);
  a702=(a741*a840);
  a841=(a815/a322);
  a842=(a741/a322);
  a843=(2.*a483);
  a843=(a843*a654);
  a843=(a843+a528);
  a528=(2.*a322);
  a528=(a843/a528);
  a842=(a842*a528);
  a841=(a841-a842);
  a842=(a739*a841);
  a702=(a702+a842);
  a702=(a702/a505);
  a842=(a742/a505);
  a842=(a842*a801);
  a702=(a702-a842);
  a837=(a837*a702);
  a838=(a838/a839);
  a838=(a838*a695);
  a837=(a837-a838);
  a836=(a836*a837);
  a835=(a835+a836);
  a836=(a745*a835);
  a837=(a744*a698);
  a836=(a836-a837);
  a837=(a748*a698);
  a838=(a744*a690);
  a839=(a565*a835);
  a838=(a838+a839);
  a839=casadi_sq(a747);
  a839=(a072+a839);
  a839=(a838/a839);
  a842=(a566*a839);
  a837=(a837+a842);
  a837=(a837/a565);
  a842=(a749/a565);
  a842=(a842*a690);
  a837=(a837-a842);
  a836=(a836+a837);
  a842=(a565*a836);
  a834=(a834+a842);
  a842=casadi_sq(a750);
  a842=(a072+a842);
  a842=(a834/a842);
  a844=(a564*a842);
  a833=(a833+a844);
  a832=(a832*a833);
  a844=(a563*a832);
  a831=(a831+a844);
  a844=(a755*a831);
  a845=(2.*a661);
  a845=(a845*a815);
  a845=(a845+a843);
  a843=(2.*a755);
  a845=(a845/a843);
  a843=(a754*a845);
  a844=(a844+a843);
  a844=(a844/a651);
  a843=(a740/a651);
  a843=(a843*a812);
  a844=(a844-a843);
  a756=(a756*a844);
  a253=(a253/a735);
  a253=(a253*a830);
  a756=(a756-a253);
  a737=(a737*a756);
  a736=(a736+a737);
  a737=(a263*a736);
  a756=(a264*a830);
  a737=(a737-a756);
  a829=(a829*a737);
  a737=(a760*a829);
  a756=(2.*a759);
  a756=(a756*a829);
  a253=(a759*a756);
  a737=(a737+a253);
  a737=(a293*a737);
  a253=(a776*a737);
  a735=(a766*a801);
  a843=(a765*a438);
  a846=cos(a043);
  a846=(a846*a154);
  a847=(a764*a846);
  a848=cos(a486);
  a848=(a848*a652);
  a848=(a270*a848);
  a763=(a763*a482);
  a848=(a848+a763);
  a763=(a762*a848);
  a847=(a847+a763);
  a763=(a227*a847);
  a843=(a843+a763);
  a763=(a768*a713);
  a849=cos(a486);
  a849=(a849*a652);
  a849=(a270*a849);
  a767=(a767*a482);
  a849=(a849+a767);
  a767=(a610*a849);
  a763=(a763+a767);
  a843=(a843-a763);
  a763=(a772*a438);
  a767=cos(a043);
  a767=(a767*a154);
  a850=(a771*a767);
  a770=(a770*a169);
  a851=sin(a486);
  a851=(a851*a652);
  a851=(a084*a851);
  a770=(a770-a851);
  a851=(a769*a770);
  a850=(a850+a851);
  a851=(a227*a850);
  a763=(a763+a851);
  a843=(a843+a763);
  a763=(a084*a713);
  a851=(a610*a169);
  a763=(a763+a851);
  a763=(a763+a823);
  a763=(a763+a172);
  a823=(a773*a763);
  a851=sin(a486);
  a851=(a851*a652);
  a852=(a774*a851);
  a823=(a823-a852);
  a843=(a843-a823);
  a823=cos(a486);
  a823=(a823*a652);
  a852=(a722*a823);
  a853=(a596*a540);
  a852=(a852+a853);
  a843=(a843+a852);
  a852=arg[12]? arg[12][3] : 0;
  a843=(a843+a852);
  a852=(a505*a843);
  a735=(a735+a852);
  a852=(a513*a735);
  a853=(a775*a643);
  a852=(a852-a853);
  a853=(a761*a852);
  a253=(a253+a853);
  a253=(a034*a253);
  a756=(a779*a756);
  a853=(a778*a852);
  a854=(a034*a829);
  a855=(a776*a854);
  a853=(a853-a855);
  a853=(a293*a853);
  a760=(a760*a853);
  a756=(a756+a760);
  a253=(a253-a756);
  a756=(2.*a829);
  a781=(a781*a756);
  a779=(a779*a829);
  a759=(a759*a853);
  a779=(a779+a759);
  a780=(a780*a779);
  a781=(a781+a780);
  a253=(a253-a781);
  a758=(a758*a253);
  a253=(a264*a758);
  a781=(a065<=a783);
  a783=(a783<=a065);
  a783=(a783+a781);
  a781=(a781/a783);
  a783=(a264*a830);
  a780=(a263*a736);
  a783=(a783+a780);
  a781=(a781*a783);
  a783=(a034*a781);
  a780=(a776*a783);
  a779=(a787*a852);
  a780=(a780+a779);
  a780=(a293*a780);
  a779=(a786*a780);
  a759=(2.*a785);
  a759=(a759*a781);
  a853=(a788*a759);
  a779=(a779-a853);
  a853=(a790*a852);
  a786=(a786*a781);
  a759=(a785*a759);
  a786=(a786+a759);
  a786=(a293*a786);
  a776=(a776*a786);
  a853=(a853-a776);
  a853=(a034*a853);
  a779=(a779-a853);
  a853=(-a781);
  a853=(2.*a853);
  a792=(a792*a853);
  a785=(a785*a780);
  a788=(a788*a781);
  a785=(a785-a788);
  a791=(a791*a785);
  a792=(a792+a791);
  a779=(a779+a792);
  a784=(a784*a779);
  a779=(a264*a784);
  a253=(a253+a779);
  a758=(a263*a758);
  a758=(a758+a852);
  a784=(a263*a784);
  a758=(a758-a784);
  a796=(a796*a758);
  a793=(a793*a796);
  a797=(a797*a758);
  a793=(a793-a797);
  a253=(a253+a793);
  a253=(a253/a799);
  a782=(a782/a799);
  a830=(-a830);
  a830=(2.*a830);
  a782=(a782*a830);
  a253=(a253-a782);
  a734=(a734*a253);
  a640=(a640+a734);
  a597=(a597-a640);
  a640=(a732*a597);
  a587=(a587+a640);
  a587=(a034*a587);
  a640=(a733*a724);
  a640=(a293*a640);
  a691=(a640*a691);
  a733=(a733*a597);
  a827=(a724*a827);
  a733=(a733-a827);
  a733=(a293*a733);
  a827=(a731*a733);
  a691=(a691+a827);
  a587=(a587-a691);
  a691=(a730*a640);
  a827=(2.*a777);
  a827=(a691*a827);
  a734=(2.*a730);
  a777=(a640*a777);
  a730=(a730*a733);
  a777=(a777+a730);
  a777=(a734*a777);
  a827=(a827+a777);
  a587=(a587-a827);
  a587=(a631*a587);
  a827=(a263*a587);
  a827=(a827+a597);
  a777=(a065<=a725);
  a725=(a725<=a065);
  a725=(a725+a777);
  a777=(a777/a725);
  a725=(a729*a724);
  a725=(a293*a725);
  a826=(a725*a826);
  a729=(a729*a597);
  a828=(a724*a828);
  a729=(a729-a828);
  a293=(a293*a729);
  a729=(a727*a293);
  a826=(a826+a729);
  a825=(a724*a825);
  a597=(a728*a597);
  a825=(a825+a597);
  a825=(a034*a825);
  a826=(a826-a825);
  a825=(a726*a725);
  a597=(2.*a824);
  a597=(a825*a597);
  a729=(2.*a726);
  a824=(a725*a824);
  a726=(a726*a293);
  a824=(a824+a726);
  a824=(a729*a824);
  a597=(a597+a824);
  a826=(a826+a597);
  a826=(a777*a826);
  a597=(a263*a826);
  a827=(a827-a597);
  a597=(a656*a827);
  a824=(a584*a597);
  a726=(a824/a651);
  a732=(a732*a724);
  a732=(a034*a732);
  a731=(a731*a640);
  a732=(a732-a731);
  a734=(a734*a691);
  a732=(a732-a734);
  a631=(a631*a732);
  a732=(a263*a631);
  a732=(a732+a724);
  a727=(a727*a725);
  a728=(a728*a724);
  a728=(a034*a728);
  a727=(a727-a728);
  a729=(a729*a825);
  a727=(a727+a729);
  a777=(a777*a727);
  a263=(a263*a777);
  a732=(a732-a263);
  a656=(a656*a732);
  a584=(a584*a656);
  a263=(a584/a651);
  a727=(a263/a651);
  a727=(a727*a812);
  a726=(a726-a727);
  a552=(2.*a552);
  a740=(a740/a651);
  a794=(a794/a795);
  a789=(a794*a789);
  a795=(a740*a789);
  a686=(a686/a651);
  a727=(a686*a584);
  a795=(a795+a727);
  a727=(2.*a651);
  a795=(a795/a727);
  a577=(2.*a577);
  a729=(a795/a577);
  a825=(a552*a729);
  a728=(2.*a654);
  a728=(a825*a728);
  a724=(2.*a483);
  a813=(2.*a813);
  a813=(a729*a813);
  a844=(a844/a651);
  a725=(a740/a651);
  a725=(a725*a812);
  a844=(a844-a725);
  a844=(a789*a844);
  a794=(a794*a796);
  a740=(a740*a794);
  a844=(a844+a740);
  a807=(a807/a651);
  a740=(a686/a651);
  a740=(a740*a812);
  a807=(a807-a740);
  a584=(a584*a807);
  a686=(a686*a824);
  a584=(a584+a686);
  a844=(a844+a584);
  a844=(a844/a727);
  a795=(a795/a727);
  a727=(2.*a812);
  a795=(a795*a727);
  a844=(a844-a795);
  a844=(a844/a577);
  a577=(a729/a577);
  a810=(2.*a810);
  a577=(a577*a810);
  a844=(a844-a577);
  a552=(a552*a844);
  a813=(a813+a552);
  a552=(a724*a813);
  a728=(a728+a552);
  a726=(a726-a728);
  a789=(a789/a651);
  a728=(a754*a789);
  a552=(2.*a755);
  a728=(a728/a552);
  a577=(a741/a322);
  a810=(a742<=a570);
  a795=(a570<=a742);
  a727=(a810+a795);
  a810=(a810/a727);
  a584=(a738<=a743);
  a743=(a743<=a738);
  a738=(a743+a584);
  a584=(a584/a738);
  a686=cos(a752);
  a824=(a755*a789);
  a807=(a563*a824);
  a740=(a686*a807);
  a796=(a564*a740);
  a725=casadi_sq(a750);
  a725=(a072+a725);
  a796=(a796/a725);
  a734=(a566*a796);
  a691=casadi_sq(a747);
  a691=(a072+a691);
  a734=(a734/a691);
  a731=(a565*a734);
  a640=(a565*a796);
  a293=(a745*a640);
  a731=(a731+a293);
  a293=(a584*a731);
  a828=(a810*a293);
  a730=(a828/a505);
  a733=(a739*a730);
  a253=arg[4]? arg[4][1] : 0;
  a782=casadi_sq(a741);
  a072=(a072+a782);
  a253=(a253/a072);
  a733=(a733+a253);
  a782=(a577*a733);
  a830=(2.*a322);
  a782=(a782/a830);
  a799=(a728-a782);
  a654=(2.*a654);
  a654=(a799*a654);
  a483=(2.*a483);
  a831=(a789*a831);
  a794=(a794/a651);
  a651=(a789/a651);
  a651=(a651*a812);
  a794=(a794-a651);
  a754=(a754*a794);
  a831=(a831+a754);
  a831=(a831/a552);
  a552=(a728/a552);
  a754=(2.*a845);
  a552=(a552*a754);
  a831=(a831-a552);
  a552=(a841/a322);
  a754=(a577/a322);
  a754=(a754*a528);
  a552=(a552-a754);
  a552=(a733*a552);
  a840=(a730*a840);
  a754=(a734*a690);
  a651=(a796*a698);
  a688=(a740*a688);
  a685=(a824*a685);
  a789=(a789*a845);
  a755=(a755*a794);
  a789=(a789+a755);
  a563=(a563*a789);
  a685=(a685+a563);
  a686=(a686*a685);
  a752=sin(a752);
  a752=(a752*a833);
  a807=(a807*a752);
  a686=(a686-a807);
  a564=(a564*a686);
  a688=(a688+a564);
  a688=(a688/a725);
  a725=(a796/a725);
  a750=(2.*a750);
  a750=(a750*a834);
  a725=(a725*a750);
  a688=(a688-a725);
  a566=(a566*a688);
  a651=(a651+a566);
  a651=(a651/a691);
  a691=(a734/a691);
  a747=(2.*a747);
  a747=(a747*a838);
  a691=(a691*a747);
  a651=(a651-a691);
  a691=(a565*a651);
  a754=(a754+a691);
  a691=(a796*a690);
  a747=(a565*a688);
  a691=(a691+a747);
  a745=(a745*a691);
  a698=(a640*a698);
  a745=(a745-a698);
  a754=(a754+a745);
  a584=(a584*a754);
  a810=(a810*a584);
  a745=(a810/a505);
  a698=(a730/a505);
  a698=(a698*a801);
  a745=(a745-a698);
  a739=(a739*a745);
  a840=(a840+a739);
  a739=arg[12]? arg[12][1] : 0;
  a739=(a739/a072);
  a253=(a253/a072);
  a072=(2.*a741);
  a072=(a072*a841);
  a253=(a253*a072);
  a739=(a739-a253);
  a840=(a840+a739);
  a577=(a577*a840);
  a552=(a552+a577);
  a552=(a552/a830);
  a782=(a782/a830);
  a830=(2.*a528);
  a782=(a782*a830);
  a552=(a552-a782);
  a552=(a831-a552);
  a782=(a483*a552);
  a654=(a654+a782);
  a726=(a726+a654);
  a654=(a701*a726);
  a724=(a724*a825);
  a263=(a263-a724);
  a483=(a483*a799);
  a263=(a263+a483);
  a808=(a263*a808);
  a654=(a654-a808);
  a001=(a001+a654);
  a808=(2.*a661);
  a483=(a808*a728);
  a661=(2.*a661);
  a724=(a661*a825);
  a483=(a483-a724);
  a733=(a733/a322);
  a483=(a483+a733);
  a818=(a483*a818);
  a724=(2.*a815);
  a728=(a728*a724);
  a808=(a808*a831);
  a728=(a728+a808);
  a815=(2.*a815);
  a825=(a825*a815);
  a661=(a661*a813);
  a825=(a825+a661);
  a728=(a728-a825);
  a840=(a840/a322);
  a733=(a733/a322);
  a733=(a733*a528);
  a840=(a840-a733);
  a728=(a728+a840);
  a840=(a663*a728);
  a818=(a818+a840);
  a001=(a001-a818);
  a840=arg[2]? arg[2][23] : 0;
  a733=casadi_sq(a215);
  a528=arg[2]? arg[2][24] : 0;
  a322=(a733*a528);
  a840=(a840+a322);
  a322=(a840*a223);
  a825=(a322*a005);
  a825=(a825/a226);
  a661=(a825/a226);
  a813=(a661*a290);
  a815=casadi_sq(a051);
  a815=(a815+a221);
  a808=(a051/a815);
  a831=arg[2]? arg[2][65] : 0;
  a724=arg[2]? arg[2][60] : 0;
  a782=(a724*a223);
  a830=arg[4]? arg[4][20] : 0;
  a830=(a089+a830);
  a577=(a782*a830);
  a739=(a831*a577);
  a253=arg[2]? arg[2][62] : 0;
  a072=(a724*a223);
  a698=arg[4]? arg[4][18] : 0;
  a698=(a698-a084);
  a747=(a072*a698);
  a838=(a253*a747);
  a739=(a739+a838);
  a838=arg[2]? arg[2][57] : 0;
  a566=arg[4]? arg[4][17] : 0;
  a566=(a093+a566);
  a725=(a223*a566);
  a750=(a838*a725);
  a739=(a739+a750);
  a750=arg[4]? arg[4][13] : 0;
  a739=(a739+a750);
  a750=(a808*a739);
  a813=(a813-a750);
  a225=(a225/a226);
  a750=arg[4]? arg[4][33] : 0;
  a834=(a065<=a232);
  a564=(a232<=a065);
  a564=(a564+a834);
  a834=(a834/a564);
  a564=(a374*a371);
  a340=(a340+a564);
  a564=(a344*a362);
  a340=(a340-a564);
  a564=(a340*a359);
  a807=(a065<=a317);
  a317=(a317<=a065);
  a317=(a317+a807);
  a807=(a807/a317);
  a317=(a324*a306);
  a317=(a807*a317);
  a752=(a318*a317);
  a564=(a564+a752);
  a752=(a266*a291);
  a564=(a564+a752);
  a752=(a144<=a075);
  a075=(a075<=a144);
  a075=(a075+a752);
  a752=(a752/a075);
  a075=(a250*a340);
  a833=(a075*a358);
  a325=(a325/a252);
  a685=(a325*a302);
  a833=(a833-a685);
  a685=(a250*a266);
  a563=(a685*a273);
  a833=(a833+a563);
  a077=(a077/a252);
  a267=(a264*a267);
  a361=(a264*a361);
  a267=(a267+a361);
  a256=(a256/a257);
  a260=(a256*a260);
  a261=(a261/a262);
  a301=(a261*a301);
  a260=(a260-a301);
  a267=(a267+a260);
  a260=(a077*a267);
  a833=(a833-a260);
  a260=(a147*a833);
  a260=(a752*a260);
  a301=(a160*a260);
  a564=(a564+a301);
  a301=arg[4]? arg[4][8] : 0;
  a564=(a564+a301);
  a564=(a834*a564);
  a301=(a564/a246);
  a262=(a229*a301);
  a750=(a750+a262);
  a262=(a065<=a240);
  a240=(a240<=a065);
  a240=(a240+a262);
  a262=(a262/a240);
  a240=(a627*a624);
  a594=(a594+a240);
  a240=(a598*a615);
  a594=(a594-a240);
  a240=(a594*a612);
  a257=(a065<=a574);
  a574=(a574<=a065);
  a574=(a574+a257);
  a257=(a257/a574);
  a574=(a578*a561);
  a574=(a257*a574);
  a361=(a573*a574);
  a240=(a240+a361);
  a361=(a304*a547);
  a240=(a240+a361);
  a361=(a144<=a311);
  a311=(a311<=a144);
  a311=(a311+a361);
  a361=(a361/a311);
  a311=(a513*a594);
  a563=(a311*a603);
  a579=(a579/a333);
  a755=(a579*a557);
  a563=(a563-a755);
  a755=(a513*a304);
  a794=(a755*a365);
  a563=(a563+a794);
  a474=(a474/a333);
  a363=(a264*a363);
  a614=(a264*a614);
  a363=(a363+a614);
  a508=(a508/a504);
  a378=(a508*a378);
  a526=(a526/a480);
  a556=(a526*a556);
  a378=(a378-a556);
  a363=(a363+a378);
  a378=(a474*a363);
  a563=(a563-a378);
  a378=(a363/a333);
  a556=(a503*a378);
  a563=(a563+a556);
  a556=(a383*a563);
  a556=(a361*a556);
  a480=(a328*a556);
  a240=(a240+a480);
  a480=arg[4]? arg[4][4] : 0;
  a240=(a240+a480);
  a480=(a790*a787);
  a757=(a757+a480);
  a480=(a761*a778);
  a757=(a757-a480);
  a480=(a757*a775);
  a240=(a240+a480);
  a480=(a065<=a572);
  a572=(a572<=a065);
  a572=(a572+a480);
  a480=(a480/a572);
  a572=(a741*a730);
  a572=(a480*a572);
  a504=(a573*a572);
  a240=(a240+a504);
  a504=(a592*a723);
  a240=(a240+a504);
  a504=(a144<=a331);
  a331=(a331<=a144);
  a331=(a331+a504);
  a504=(a504/a331);
  a331=(a513*a757);
  a144=(a331*a766);
  a742=(a742/a505);
  a614=(a742*a828);
  a144=(a144-a614);
  a614=(a513*a592);
  a794=(a614*a628);
  a144=(a144+a794);
  a636=(a636/a505);
  a631=(a264*a631);
  a777=(a264*a777);
  a631=(a631+a777);
  a699=(a699/a558);
  a656=(a699*a656);
  a589=(a589/a689);
  a732=(a589*a732);
  a656=(a656-a732);
  a631=(a631+a656);
  a656=(a636*a631);
  a144=(a144-a656);
  a656=(a631/a505);
  a732=(a549*a656);
  a144=(a144+a732);
  a732=(a630*a144);
  a732=(a504*a732);
  a689=(a328*a732);
  a240=(a240+a689);
  a689=arg[4]? arg[4][0] : 0;
  a240=(a240+a689);
  a240=(a262*a240);
  a689=(a240/a246);
  a558=(a034*a689);
  a777=(a116*a558);
  a750=(a750-a777);
  a777=(a225*a750);
  a813=(a813+a777);
  a777=(2.*a226);
  a813=(a813/a777);
  a794=2.5000000000000000e-01;
  a219=(a794*a219);
  a845=casadi_sq(a724);
  a812=arg[2]? arg[2][66] : 0;
  a793=(a812*a830);
  a797=arg[2]? arg[2][63] : 0;
  a758=(a797*a698);
  a793=(a793+a758);
  a758=(a845*a793);
  a784=arg[2]? arg[2][58] : 0;
  a852=(a784*a724);
  a779=(a852*a566);
  a758=(a758+a779);
  a779=(a028*a758);
  a792=(a041*a779);
  a791=(a219*a792);
  a785=sqrt(a054);
  a788=(2.*a785);
  a791=(a791/a788);
  a781=arg[2]? arg[2][64] : 0;
  a780=arg[1]? arg[1][9] : 0;
  a853=(a781*a780);
  a776=atan2(a051,a226);
  a759=(a831*a776);
  a853=(a853+a759);
  a759=arg[2]? arg[2][67] : 0;
  a829=(a759*a057);
  a853=(a853+a829);
  a829=(a853*a830);
  a756=(a724*a829);
  a760=arg[2]? arg[2][61] : 0;
  a855=(a760*a780);
  a856=(a253*a776);
  a855=(a855+a856);
  a856=(a855*a698);
  a857=(a724*a856);
  a756=(a756+a857);
  a857=(a838*a776);
  a858=arg[2]? arg[2][59] : 0;
  a859=(a858*a057);
  a857=(a857+a859);
  a859=(a857*a566);
  a756=(a756+a859);
  a859=arg[4]? arg[4][16] : 0;
  a860=(a290/a226);
  a861=(a005*a860);
  a859=(a859-a861);
  a861=(a840*a859);
  a756=(a756+a861);
  a861=arg[4]? arg[4][19] : 0;
  a862=(a301-a558);
  a863=(a862-a270);
  a861=(a861+a863);
  a864=(a243*a861);
  a865=(a241*a864);
  a756=(a756+a865);
  a865=arg[4]? arg[4][15] : 0;
  a866=(a750/a226);
  a867=(a005*a866);
  a865=(a865-a867);
  a867=(a215*a865);
  a756=(a756+a867);
  a867=(a028*a756);
  a868=(a220*a867);
  a868=(a791+a868);
  a869=(a813+a868);
  a870=(2.*a127);
  a870=(a869*a870);
  a871=(2.*a005);
  a872=arg[10]? arg[10][23] : 0;
  a873=(2.*a215);
  a873=(a873*a422);
  a874=(a528*a873);
  a875=arg[10]? arg[10][24] : 0;
  a876=(a733*a875);
  a874=(a874+a876);
  a872=(a872+a874);
  a874=(a223*a872);
  a876=(a840*a434);
  a874=(a874+a876);
  a876=(a005*a874);
  a877=(a322*a127);
  a876=(a876+a877);
  a876=(a876/a226);
  a877=(a825/a226);
  a877=(a877*a437);
  a876=(a876-a877);
  a877=(a876/a226);
  a878=(a661/a226);
  a878=(a878*a437);
  a877=(a877-a878);
  a877=(a290*a877);
  a661=(a661*a496);
  a877=(a877+a661);
  a661=(a158/a815);
  a878=(a808/a815);
  a879=(2.*a051);
  a879=(a879*a158);
  a879=(a879+a432);
  a878=(a878*a879);
  a661=(a661-a878);
  a661=(a739*a661);
  a878=arg[10]? arg[10][65] : 0;
  a432=(a577*a878);
  a880=arg[10]? arg[10][60] : 0;
  a881=(a223*a880);
  a882=(a724*a434);
  a881=(a881+a882);
  a881=(a830*a881);
  a882=arg[12]? arg[12][20] : 0;
  a882=(a087+a882);
  a782=(a782*a882);
  a881=(a881+a782);
  a782=(a831*a881);
  a432=(a432+a782);
  a782=arg[10]? arg[10][62] : 0;
  a883=(a747*a782);
  a884=(a223*a880);
  a885=(a724*a434);
  a884=(a884+a885);
  a884=(a698*a884);
  a885=arg[12]? arg[12][18] : 0;
  a885=(a885-a169);
  a072=(a072*a885);
  a884=(a884+a072);
  a072=(a253*a884);
  a883=(a883+a072);
  a432=(a432+a883);
  a883=arg[10]? arg[10][57] : 0;
  a072=(a725*a883);
  a886=(a566*a434);
  a887=arg[12]? arg[12][17] : 0;
  a887=(a172+a887);
  a888=(a223*a887);
  a886=(a886+a888);
  a888=(a838*a886);
  a072=(a072+a888);
  a432=(a432+a072);
  a072=arg[12]? arg[12][13] : 0;
  a432=(a432+a072);
  a808=(a808*a432);
  a661=(a661+a808);
  a877=(a877-a661);
  a435=(a435/a226);
  a661=(a225/a226);
  a661=(a661*a437);
  a435=(a435-a661);
  a435=(a750*a435);
  a661=arg[12]? arg[12][33] : 0;
  a808=(a301*a439);
  a374=(a374*a367);
  a371=(a371*a370);
  a374=(a374-a371);
  a305=(a305+a374);
  a362=(a362*a307);
  a344=(a344*a539);
  a362=(a362-a344);
  a305=(a305-a362);
  a359=(a359*a305);
  a527=(a340*a527);
  a359=(a359+a527);
  a524=(a317*a524);
  a306=(a306*a525);
  a324=(a324*a511);
  a306=(a306+a324);
  a807=(a807*a306);
  a318=(a318*a807);
  a524=(a524+a318);
  a359=(a359+a524);
  a291=(a291*a387);
  a254=(a266*a254);
  a291=(a291+a254);
  a359=(a359+a291);
  a388=(a260*a388);
  a384=(a833*a384);
  a340=(a340*a390);
  a305=(a250*a305);
  a340=(a340+a305);
  a358=(a358*a340);
  a537=(a075*a537);
  a358=(a358+a537);
  a523=(a523/a252);
  a537=(a325/a252);
  a537=(a537*a385);
  a523=(a523-a537);
  a302=(a302*a523);
  a325=(a325*a477);
  a302=(a302+a325);
  a358=(a358-a302);
  a266=(a266*a390);
  a387=(a250*a387);
  a266=(a266+a387);
  a273=(a273*a266);
  a476=(a685*a476);
  a273=(a273+a476);
  a358=(a358+a273);
  a265=(a265/a252);
  a273=(a077/a252);
  a273=(a273*a385);
  a265=(a265-a273);
  a265=(a267*a265);
  a258=(a264*a258);
  a499=(a264*a499);
  a258=(a258+a499);
  a256=(a256*a389);
  a261=(a261*a500);
  a256=(a256-a261);
  a258=(a258+a256);
  a077=(a077*a258);
  a265=(a265+a077);
  a358=(a358-a265);
  a147=(a147*a358);
  a384=(a384+a147);
  a752=(a752*a384);
  a160=(a160*a752);
  a388=(a388+a160);
  a359=(a359+a388);
  a388=arg[12]? arg[12][8] : 0;
  a359=(a359+a388);
  a834=(a834*a359);
  a359=(a834/a246);
  a388=(a301/a246);
  a388=(a388*a466);
  a359=(a359-a388);
  a388=(a229*a359);
  a808=(a808+a388);
  a661=(a661+a808);
  a461=(a558*a461);
  a627=(a627*a620);
  a624=(a624*a623);
  a627=(a627-a624);
  a560=(a560+a627);
  a615=(a615*a562);
  a598=(a598*a721);
  a615=(a615-a598);
  a560=(a560-a615);
  a612=(a612*a560);
  a559=(a594*a559);
  a612=(a612+a559);
  a559=(a574*a703);
  a561=(a561*a705);
  a578=(a578*a582);
  a561=(a561+a578);
  a257=(a257*a561);
  a561=(a573*a257);
  a559=(a559+a561);
  a612=(a612+a559);
  a547=(a547*a464);
  a645=(a304*a645);
  a547=(a547+a645);
  a612=(a612+a547);
  a547=(a556*a641);
  a637=(a563*a637);
  a560=(a513*a560);
  a594=(a594*a643);
  a560=(a560-a594);
  a603=(a603*a560);
  a707=(a311*a707);
  a603=(a603+a707);
  a704=(a704/a333);
  a707=(a579/a333);
  a707=(a707*a638);
  a704=(a704-a707);
  a557=(a557*a704);
  a579=(a579*a658);
  a557=(a557+a579);
  a603=(a603-a557);
  a464=(a513*a464);
  a304=(a304*a643);
  a464=(a464-a304);
  a365=(a365*a464);
  a510=(a755*a510);
  a365=(a365+a510);
  a603=(a603+a365);
  a635=(a635/a333);
  a365=(a474/a333);
  a365=(a365*a638);
  a635=(a635-a365);
  a363=(a363*a635);
  a308=(a264*a308);
  a680=(a264*a680);
  a308=(a308+a680);
  a508=(a508*a676);
  a526=(a526*a681);
  a508=(a508-a526);
  a308=(a308+a508);
  a474=(a474*a308);
  a363=(a363+a474);
  a603=(a603-a363);
  a368=(a378*a368);
  a308=(a308/a333);
  a363=(a378/a333);
  a363=(a363*a638);
  a308=(a308-a363);
  a503=(a503*a308);
  a368=(a368+a503);
  a603=(a603+a368);
  a383=(a383*a603);
  a637=(a637+a383);
  a361=(a361*a637);
  a637=(a328*a361);
  a547=(a547+a637);
  a612=(a612+a547);
  a547=arg[12]? arg[12][4] : 0;
  a612=(a612+a547);
  a790=(a790*a783);
  a787=(a787*a786);
  a790=(a790-a787);
  a736=(a736+a790);
  a778=(a778*a737);
  a761=(a761*a854);
  a778=(a778-a761);
  a736=(a736-a778);
  a775=(a775*a736);
  a735=(a757*a735);
  a775=(a775+a735);
  a612=(a612+a775);
  a703=(a572*a703);
  a730=(a730*a841);
  a741=(a741*a745);
  a730=(a730+a741);
  a480=(a480*a730);
  a573=(a573*a480);
  a703=(a703+a573);
  a612=(a612+a703);
  a723=(a723*a804);
  a805=(a592*a805);
  a723=(a723+a805);
  a612=(a612+a723);
  a641=(a732*a641);
  a800=(a144*a800);
  a736=(a513*a736);
  a757=(a757*a643);
  a736=(a736-a757);
  a766=(a766*a736);
  a843=(a331*a843);
  a766=(a766+a843);
  a702=(a702/a505);
  a843=(a742/a505);
  a843=(a843*a801);
  a702=(a702-a843);
  a828=(a828*a702);
  a742=(a742*a810);
  a828=(a828+a742);
  a766=(a766-a828);
  a804=(a513*a804);
  a592=(a592*a643);
  a804=(a804-a592);
  a628=(a628*a804);
  a575=(a614*a575);
  a628=(a628+a575);
  a766=(a766+a628);
  a798=(a798/a505);
  a628=(a636/a505);
  a628=(a628*a801);
  a798=(a798-a628);
  a631=(a631*a798);
  a587=(a264*a587);
  a264=(a264*a826);
  a587=(a587+a264);
  a699=(a699*a597);
  a589=(a589*a827);
  a699=(a699-a589);
  a587=(a587+a699);
  a636=(a636*a587);
  a631=(a631+a636);
  a766=(a766-a631);
  a621=(a656*a621);
  a587=(a587/a505);
  a631=(a656/a505);
  a631=(a631*a801);
  a587=(a587-a631);
  a549=(a549*a587);
  a621=(a621+a549);
  a766=(a766+a621);
  a630=(a630*a766);
  a800=(a800+a630);
  a504=(a504*a800);
  a328=(a328*a504);
  a641=(a641+a328);
  a612=(a612+a641);
  a641=arg[12]? arg[12][0] : 0;
  a612=(a612+a641);
  a262=(a262*a612);
  a612=(a262/a246);
  a689=(a689/a246);
  a689=(a689*a466);
  a612=(a612-a689);
  a612=(a034*a612);
  a116=(a116*a612);
  a461=(a461+a116);
  a661=(a661-a461);
  a225=(a225*a661);
  a435=(a435+a225);
  a877=(a877+a435);
  a877=(a877/a777);
  a813=(a813/a777);
  a777=(2.*a437);
  a813=(a813*a777);
  a877=(a877-a813);
  a429=(a794*a429);
  a813=(a792*a429);
  a777=(a779*a149);
  a435=(a758*a140);
  a225=(2.*a724);
  a225=(a225*a880);
  a461=(a793*a225);
  a116=arg[10]? arg[10][66] : 0;
  a116=(a830*a116);
  a812=(a812*a882);
  a116=(a116+a812);
  a812=arg[10]? arg[10][63] : 0;
  a812=(a698*a812);
  a797=(a797*a885);
  a812=(a812+a797);
  a116=(a116+a812);
  a812=(a845*a116);
  a461=(a461+a812);
  a812=arg[10]? arg[10][58] : 0;
  a797=(a724*a812);
  a689=(a784*a880);
  a797=(a797+a689);
  a689=(a566*a797);
  a641=(a852*a887);
  a689=(a689+a641);
  a461=(a461+a689);
  a689=(a028*a461);
  a435=(a435+a689);
  a689=(a041*a435);
  a777=(a777+a689);
  a689=(a219*a777);
  a813=(a813+a689);
  a813=(a813/a788);
  a791=(a791/a788);
  a788=(2.*a785);
  a788=(a433/a788);
  a689=(2.*a788);
  a791=(a791*a689);
  a813=(a813-a791);
  a430=(a867*a430);
  a791=(a756*a140);
  a689=(a829*a880);
  a641=arg[10]? arg[10][64] : 0;
  a328=(a780*a641);
  a800=arg[9]? arg[9][9] : 0;
  a630=(a781*a800);
  a328=(a328+a630);
  a878=(a776*a878);
  a630=casadi_sq(a051);
  a630=(a630+a221);
  a221=(a226/a630);
  a221=(a221*a158);
  a630=(a051/a630);
  a630=(a630*a437);
  a221=(a221-a630);
  a831=(a831*a221);
  a878=(a878+a831);
  a328=(a328+a878);
  a878=arg[10]? arg[10][67] : 0;
  a831=(a057*a878);
  a630=(a759*a148);
  a831=(a831+a630);
  a328=(a328+a831);
  a328=(a830*a328);
  a853=(a853*a882);
  a328=(a328+a853);
  a853=(a724*a328);
  a689=(a689+a853);
  a853=(a856*a880);
  a831=arg[10]? arg[10][61] : 0;
  a630=(a780*a831);
  a549=(a760*a800);
  a630=(a630+a549);
  a782=(a776*a782);
  a253=(a253*a221);
  a782=(a782+a253);
  a630=(a630+a782);
  a630=(a698*a630);
  a855=(a855*a885);
  a630=(a630+a855);
  a855=(a724*a630);
  a853=(a853+a855);
  a689=(a689+a853);
  a883=(a776*a883);
  a838=(a838*a221);
  a883=(a883+a838);
  a838=arg[10]? arg[10][59] : 0;
  a853=(a057*a838);
  a855=(a858*a148);
  a853=(a853+a855);
  a883=(a883+a853);
  a853=(a566*a883);
  a855=(a857*a887);
  a853=(a853+a855);
  a689=(a689+a853);
  a872=(a859*a872);
  a853=arg[12]? arg[12][16] : 0;
  a855=(a860*a127);
  a782=(a496/a226);
  a253=(a860/a226);
  a253=(a253*a437);
  a782=(a782-a253);
  a253=(a005*a782);
  a855=(a855+a253);
  a853=(a853-a855);
  a840=(a840*a853);
  a872=(a872+a840);
  a689=(a689+a872);
  a451=(a864*a451);
  a454=(a861*a454);
  a872=arg[12]? arg[12][19] : 0;
  a840=(a359-a612);
  a855=(a840-a482);
  a872=(a872+a855);
  a243=(a243*a872);
  a454=(a454+a243);
  a241=(a241*a454);
  a451=(a451+a241);
  a689=(a689+a451);
  a451=(a865*a422);
  a241=arg[12]? arg[12][15] : 0;
  a127=(a866*a127);
  a243=(a661/a226);
  a253=(a866/a226);
  a253=(a253*a437);
  a243=(a243-a253);
  a005=(a005*a243);
  a127=(a127+a005);
  a241=(a241-a127);
  a127=(a215*a241);
  a451=(a451+a127);
  a689=(a689+a451);
  a451=(a028*a689);
  a791=(a791+a451);
  a220=(a220*a791);
  a430=(a430+a220);
  a813=(a813+a430);
  a877=(a877+a813);
  a877=(a871*a877);
  a870=(a870+a877);
  a874=(a860*a874);
  a782=(a322*a782);
  a874=(a874+a782);
  a427=(a866*a427);
  a243=(a224*a243);
  a427=(a427+a243);
  a874=(a874+a427);
  a870=(a870-a874);
  a001=(a001+a870);
  a008=(2.*a008);
  a874=arg[4]? arg[4][26] : 0;
  a427=(a238*a270);
  a243=(a235*a270);
  a427=(a427+a243);
  a874=(a874-a427);
  a427=(a239*a862);
  a874=(a874+a427);
  a874=(a874-a750);
  a427=(a202*a874);
  a243=(a034*a427);
  a184=(2.*a184);
  a243=(a243/a184);
  a782=(a008*a243);
  a877=(a034*a427);
  a877=(a782+a877);
  a430=(a877*a415);
  a414=(2.*a414);
  a414=(a243*a414);
  a410=(a874*a410);
  a220=arg[12]? arg[12][26] : 0;
  a448=(a270*a448);
  a238=(a238*a482);
  a448=(a448+a238);
  a445=(a270*a445);
  a235=(a235*a482);
  a445=(a445+a235);
  a448=(a448+a445);
  a220=(a220-a448);
  a450=(a862*a450);
  a239=(a239*a840);
  a450=(a450+a239);
  a220=(a220+a450);
  a220=(a220-a661);
  a202=(a202*a220);
  a410=(a410+a202);
  a202=(a034*a410);
  a202=(a202/a184);
  a243=(a243/a184);
  a417=(2.*a417);
  a243=(a243*a417);
  a202=(a202-a243);
  a008=(a008*a202);
  a414=(a414+a008);
  a008=(a034*a410);
  a008=(a414+a008);
  a202=(a182*a008);
  a430=(a430+a202);
  a202=(a181*a877);
  a243=(2.*a182);
  a202=(a202/a243);
  a417=(2.*a413);
  a417=(a202*a417);
  a184=(2.*a181);
  a413=(a877*a413);
  a181=(a181*a008);
  a413=(a413+a181);
  a413=(a413/a243);
  a243=(a202/a243);
  a415=(2.*a415);
  a243=(a243*a415);
  a413=(a413-a243);
  a413=(a184*a413);
  a417=(a417+a413);
  a430=(a430+a417);
  a001=(a001+a430);
  if (res[0]!=0) res[0][0]=a001;
  a007=(a007*a002);
  a027=(a015*a027);
  a007=(a007-a027);
  a019=(a020*a019);
  a010=(a010*a018);
  a019=(a019+a010);
  a007=(a007-a019);
  a150=(2.*a150);
  a150=(a086*a150);
  a049=(2.*a049);
  a166=(a049*a166);
  a150=(a150+a166);
  a053=(a053/a094);
  a055=(a055/a094);
  a094=(a055/a094);
  a094=(a094*a174);
  a053=(a053-a094);
  a053=(a117*a053);
  a040=(a055*a040);
  a053=(a053+a040);
  a150=(a150+a053);
  a007=(a007+a150);
  a475=(a296*a475);
  a053=(a107*a295);
  a475=(a475+a053);
  a053=(a061*a292);
  a484=(a467*a484);
  a053=(a053-a484);
  a475=(a475+a053);
  a007=(a007+a475);
  a053=(a294*a548);
  a664=(a297*a664);
  a053=(a053-a664);
  a664=(a263-a551);
  a655=(a664*a655);
  a484=(a726-a550);
  a040=(a481*a484);
  a655=(a655+a040);
  a053=(a053+a655);
  a655=(a453*a728);
  a816=(a483*a816);
  a655=(a655-a816);
  a053=(a053+a655);
  a007=(a007+a053);
  a437=(a437/a815);
  a226=(a226/a815);
  a815=(a226/a815);
  a815=(a815*a879);
  a437=(a437-a815);
  a437=(a739*a437);
  a432=(a226*a432);
  a437=(a437+a432);
  a158=(2.*a158);
  a158=(a868*a158);
  a051=(2.*a051);
  a813=(a051*a813);
  a158=(a158+a813);
  a437=(a437+a158);
  a007=(a007+a437);
  if (res[0]!=0) res[0][1]=a007;
  a049=(a049*a086);
  a055=(a055*a117);
  a049=(a049+a055);
  a152=(a049*a152);
  a045=(a045*a150);
  a152=(a152+a045);
  a429=(a785*a429);
  a045=(a219*a788);
  a429=(a429+a045);
  a779=(a779*a429);
  a219=(a219*a785);
  a435=(a219*a435);
  a779=(a779+a435);
  a152=(a152+a779);
  a107=(a107*a296);
  a061=(a061*a467);
  a107=(a107+a061);
  a473=(a107*a473);
  a073=(a073*a475);
  a473=(a473+a073);
  a152=(a152+a473);
  a701=(a701*a263);
  a110=(a110*a551);
  a381=(a381*a297);
  a110=(a110+a381);
  a701=(a701-a110);
  a663=(a663*a483);
  a701=(a701-a663);
  a648=(a701*a648);
  a650=(a650+a667);
  a654=(a654-a650);
  a654=(a654-a818);
  a366=(a366*a654);
  a648=(a648+a366);
  a648=(a034*a648);
  a152=(a152+a648);
  a294=(a294*a297);
  a481=(a481*a664);
  a294=(a294+a481);
  a453=(a453*a483);
  a294=(a294+a453);
  a439=(a294*a439);
  a229=(a229*a053);
  a439=(a439+a229);
  a152=(a152+a439);
  if (res[0]!=0) res[0][2]=a152;
  if (res[0]!=0) res[0][3]=a065;
  a152=arg[0]? arg[0][4] : 0;
  a152=casadi_sign(a152);
  a439=arg[12]? arg[12][37] : 0;
  a152=(a152*a439);
  if (res[0]!=0) res[0][4]=a152;
  a152=casadi_sign(a000);
  a229=arg[12]? arg[12][38] : 0;
  a152=(a152*a229);
  a453=cos(a000);
  a481=(a020*a017);
  a648=(a006*a018);
  a481=(a481+a648);
  a453=(a453*a481);
  a481=(a006*a020);
  a648=sin(a000);
  a648=(a648*a016);
  a481=(a481*a648);
  a453=(a453-a481);
  a152=(a152-a453);
  a453=(a003*a020);
  a481=cos(a000);
  a481=(a481*a016);
  a453=(a453*a481);
  a481=sin(a000);
  a020=(a020*a013);
  a018=(a003*a018);
  a020=(a020+a018);
  a481=(a481*a020);
  a453=(a453+a481);
  a152=(a152-a453);
  a453=(a006*a015);
  a481=cos(a000);
  a481=(a481*a016);
  a453=(a453*a481);
  a481=sin(a000);
  a017=(a015*a017);
  a006=(a006*a002);
  a017=(a017+a006);
  a481=(a481*a017);
  a453=(a453+a481);
  a152=(a152-a453);
  a453=cos(a000);
  a481=(a015*a013);
  a002=(a003*a002);
  a481=(a481+a002);
  a453=(a453*a481);
  a015=(a003*a015);
  a481=sin(a000);
  a481=(a481*a016);
  a015=(a015*a481);
  a453=(a453-a015);
  a152=(a152+a453);
  a453=cos(a000);
  a226=(a226*a739);
  a051=(a051*a868);
  a226=(a226+a051);
  a226=(a049+a226);
  a051=(a226*a126);
  a437=(a150+a437);
  a868=(a025*a437);
  a051=(a051+a868);
  a453=(a453*a051);
  a051=(a025*a226);
  a868=sin(a000);
  a868=(a868*a016);
  a051=(a051*a868);
  a453=(a453-a051);
  a152=(a152+a453);
  a453=(a022*a226);
  a051=cos(a000);
  a051=(a051*a016);
  a453=(a453*a051);
  a051=sin(a000);
  a868=(a226*a129);
  a739=(a022*a437);
  a868=(a868+a739);
  a051=(a051*a868);
  a453=(a453+a051);
  a152=(a152+a453);
  a453=cos(a000);
  a023=(a023*a124);
  a122=(a122*a118);
  a023=(a023+a122);
  a871=(a871*a869);
  a322=(a322*a860);
  a224=(a224*a866);
  a322=(a322+a224);
  a871=(a871-a322);
  a023=(a023+a871);
  a182=(a182*a877);
  a184=(a184*a202);
  a182=(a182+a184);
  a023=(a023+a182);
  a129=(a023*a129);
  a132=(a132+a870);
  a132=(a132+a430);
  a430=(a022*a132);
  a129=(a129+a430);
  a453=(a453*a129);
  a022=(a022*a023);
  a129=sin(a000);
  a129=(a129*a016);
  a022=(a022*a129);
  a453=(a453-a022);
  a152=(a152-a453);
  a453=(a025*a023);
  a022=cos(a000);
  a022=(a022*a016);
  a453=(a453*a022);
  a000=sin(a000);
  a126=(a023*a126);
  a025=(a025*a132);
  a126=(a126+a025);
  a000=(a000*a126);
  a453=(a453+a000);
  a152=(a152+a453);
  if (res[0]!=0) res[0][5]=a152;
  a161=(a226*a161);
  a052=(a052*a437);
  a161=(a161+a052);
  a004=(a004*a132);
  a128=(a023*a128);
  a004=(a004-a128);
  a161=(a161-a004);
  if (res[1]!=0) res[1][0]=a161;
  a050=(a050*a437);
  a226=(a226*a159);
  a050=(a050-a226);
  a023=(a023*a131);
  a024=(a024*a132);
  a023=(a023+a024);
  a050=(a050+a023);
  a050=(-a050);
  if (res[1]!=0) res[1][1]=a050;
  a050=(a249*a863);
  a458=(a050*a458);
  a249=(a249*a855);
  a460=(a863*a460);
  a249=(a249-a460);
  a247=(a247*a249);
  a458=(a458+a247);
  a458=(a496+a458);
  a141=(2.*a141);
  a141=(a141+a168);
  a414=(2.*a414);
  a141=(a141+a414);
  a141=(a141+a410);
  a410=(a141/a030);
  a123=(2.*a123);
  a123=(a123+a120);
  a782=(2.*a782);
  a123=(a123+a782);
  a123=(a123+a427);
  a427=(a123/a030);
  a427=(a427/a030);
  a427=(a427*a138);
  a410=(a410-a427);
  a458=(a458+a410);
  if (res[1]!=0) res[1][2]=a458;
  a458=(a242*a861);
  a456=(a458*a456);
  a861=(a861*a452);
  a242=(a242*a872);
  a861=(a861+a242);
  a245=(a245*a861);
  a456=(a456+a245);
  a245=arg[4]? arg[4][24] : 0;
  a242=(a186<=a167);
  a167=(a167<=a186);
  a186=(a167+a242);
  a242=(a242/a186);
  a872=(a175<=a187);
  a187=(a187<=a175);
  a175=(a187+a872);
  a872=(a872/a175);
  a452=(a065<=a079);
  a079=(a079<=a065);
  a079=(a079+a452);
  a452=(a452/a079);
  a079=arg[4]? arg[4][25] : 0;
  a410=(a183*a874);
  a427=(a201*a410);
  a782=(a028*a427);
  a120=(a198*a782);
  a120=(a034*a120);
  a079=(a079+a120);
  a120=(a196*a079);
  a120=(a034*a120);
  a414=(a197*a079);
  a414=(a064*a414);
  a168=(a195*a414);
  a120=(a120-a168);
  a168=(2.*a188);
  a247=(a188*a414);
  a460=(a168*a247);
  a120=(a120-a460);
  a120=(a452*a120);
  a120=(a068*a120);
  a120=(a120+a079);
  a460=(a065<=a189);
  a189=(a189<=a065);
  a189=(a189+a460);
  a460=(a460/a189);
  a189=(a193*a079);
  a189=(a064*a189);
  a023=(a191*a189);
  a024=(a192*a079);
  a024=(a034*a024);
  a023=(a023-a024);
  a024=(2.*a190);
  a132=(a190*a189);
  a131=(a024*a132);
  a023=(a023+a131);
  a023=(a460*a023);
  a023=(a068*a023);
  a120=(a120-a023);
  a120=(a872*a120);
  a120=(a242*a120);
  a023=(a176*a120);
  a245=(a245+a023);
  a403=(a245*a403);
  a023=arg[12]? arg[12][24] : 0;
  a398=(a120*a398);
  a399=(a079*a399);
  a131=arg[12]? arg[12][25] : 0;
  a408=(a782*a408);
  a226=(a427*a140);
  a411=(a410*a411);
  a874=(a874*a416);
  a183=(a183*a220);
  a874=(a874+a183);
  a201=(a201*a874);
  a411=(a411+a201);
  a201=(a028*a411);
  a226=(a226+a201);
  a198=(a198*a226);
  a408=(a408+a198);
  a408=(a034*a408);
  a131=(a131+a408);
  a196=(a196*a131);
  a399=(a399+a196);
  a399=(a034*a399);
  a393=(a414*a393);
  a197=(a197*a131);
  a407=(a079*a407);
  a197=(a197-a407);
  a197=(a064*a197);
  a195=(a195*a197);
  a393=(a393+a195);
  a399=(a399-a393);
  a393=(2.*a404);
  a247=(a247*a393);
  a414=(a414*a404);
  a188=(a188*a197);
  a414=(a414+a188);
  a168=(a168*a414);
  a247=(a247+a168);
  a399=(a399-a247);
  a452=(a452*a399);
  a399=(a068*a452);
  a399=(a399+a131);
  a396=(a189*a396);
  a193=(a193*a131);
  a400=(a079*a400);
  a193=(a193-a400);
  a193=(a064*a193);
  a191=(a191*a193);
  a396=(a396+a191);
  a079=(a079*a395);
  a192=(a192*a131);
  a079=(a079+a192);
  a079=(a034*a079);
  a396=(a396-a079);
  a079=(2.*a394);
  a132=(a132*a079);
  a189=(a189*a394);
  a190=(a190*a193);
  a189=(a189+a190);
  a024=(a024*a189);
  a132=(a132+a024);
  a396=(a396+a132);
  a460=(a460*a396);
  a396=(a068*a460);
  a399=(a399-a396);
  a872=(a872*a399);
  a242=(a242*a872);
  a176=(a176*a242);
  a398=(a398+a176);
  a023=(a023+a398);
  a178=(a178*a023);
  a403=(a403+a178);
  a456=(a456+a403);
  if (res[1]!=0) res[1][3]=a456;
  a656=(a656*a803);
  a684=(a684*a587);
  a656=(a656+a684);
  if (res[1]!=0) res[1][4]=a656;
  a378=(a378*a442);
  a309=(a309*a308);
  a378=(a378+a309);
  if (res[1]!=0) res[1][5]=a378;
  a378=cos(a012);
  a309=(a075*a252);
  a442=(a309*a121);
  a656=(a442*a095);
  a684=(a656*a347);
  a803=(a378*a684);
  a456=cos(a012);
  a403=(a442*a280);
  a178=(a403*a270);
  a398=(a456*a178);
  a803=(a803-a398);
  a398=sin(a012);
  a176=(a685*a252);
  a396=(a176*a115);
  a132=(a396*a271);
  a024=(a398*a132);
  a803=(a803-a024);
  a024=sin(a012);
  a189=(a442*a095);
  a190=(a189*a352);
  a193=(a190*a084);
  a394=(a024*a193);
  a803=(a803-a394);
  a394=cos(a012);
  a079=(a176*a095);
  a192=(a079*a276);
  a131=(a394*a192);
  a803=(a803+a131);
  a131=sin(a012);
  a395=(a442*a357);
  a191=(a131*a395);
  a803=(a803+a191);
  a191=cos(a012);
  a400=(a176*a281);
  a247=(a191*a400);
  a803=(a803-a247);
  a247=sin(a012);
  a168=(a176*a287);
  a414=(a247*a168);
  a803=(a803+a414);
  a414=cos(a012);
  a188=(a442*a290);
  a197=(a414*a188);
  a803=(a803+a197);
  a197=cos(a012);
  a404=(a062*a296);
  a393=(a197*a404);
  a803=(a803+a393);
  a393=sin(a012);
  a195=(a003*a296);
  a407=(a393*a195);
  a803=(a803-a407);
  a407=cos(a012);
  a196=(a003*a467);
  a408=(a407*a196);
  a803=(a803-a408);
  a408=sin(a012);
  a198=(a062*a467);
  a201=(a408*a198);
  a803=(a803-a201);
  a201=(a125*a803);
  a469=(a201*a469);
  a340=(a252*a340);
  a075=(a075*a385);
  a340=(a340+a075);
  a121=(a121*a340);
  a075=(a309*a471);
  a121=(a121-a075);
  a075=(a095*a121);
  a183=(a442*a459);
  a075=(a075+a183);
  a347=(a347*a075);
  a533=(a656*a533);
  a347=(a347+a533);
  a378=(a378*a347);
  a347=sin(a012);
  a347=(a347*a470);
  a684=(a684*a347);
  a378=(a378-a684);
  a280=(a280*a121);
  a492=(a442*a492);
  a280=(a280+a492);
  a280=(a270*a280);
  a403=(a403*a482);
  a280=(a280+a403);
  a456=(a456*a280);
  a280=sin(a012);
  a280=(a280*a470);
  a178=(a178*a280);
  a456=(a456-a178);
  a378=(a378-a456);
  a456=cos(a012);
  a456=(a456*a470);
  a132=(a132*a456);
  a266=(a252*a266);
  a685=(a685*a385);
  a266=(a266+a685);
  a685=(a115*a266);
  a456=(a176*a463);
  a685=(a685+a456);
  a271=(a271*a685);
  a269=(a396*a269);
  a271=(a271+a269);
  a398=(a398*a271);
  a132=(a132+a398);
  a378=(a378-a132);
  a132=cos(a012);
  a132=(a132*a470);
  a193=(a193*a132);
  a132=(a095*a121);
  a398=(a442*a459);
  a132=(a132+a398);
  a352=(a352*a132);
  a350=(a189*a350);
  a352=(a352+a350);
  a352=(a084*a352);
  a190=(a190*a169);
  a352=(a352+a190);
  a024=(a024*a352);
  a193=(a193+a024);
  a378=(a378-a193);
  a193=(a095*a266);
  a024=(a176*a459);
  a193=(a193+a024);
  a276=(a276*a193);
  a491=(a079*a491);
  a276=(a276+a491);
  a394=(a394*a276);
  a276=sin(a012);
  a276=(a276*a470);
  a192=(a192*a276);
  a394=(a394-a192);
  a378=(a378+a394);
  a394=cos(a012);
  a394=(a394*a470);
  a395=(a395*a394);
  a357=(a357*a121);
  a346=(a442*a346);
  a357=(a357+a346);
  a131=(a131*a357);
  a395=(a395+a131);
  a378=(a378+a395);
  a281=(a281*a266);
  a494=(a176*a494);
  a281=(a281+a494);
  a191=(a191*a281);
  a281=sin(a012);
  a281=(a281*a470);
  a400=(a400*a281);
  a191=(a191-a400);
  a378=(a378-a191);
  a191=cos(a012);
  a191=(a191*a470);
  a168=(a168*a191);
  a287=(a287*a266);
  a275=(a176*a275);
  a287=(a287+a275);
  a247=(a247*a287);
  a168=(a168+a247);
  a378=(a378+a168);
  a290=(a290*a121);
  a496=(a442*a496);
  a290=(a290+a496);
  a414=(a414*a290);
  a290=sin(a012);
  a290=(a290*a470);
  a188=(a188*a290);
  a414=(a414-a188);
  a378=(a378+a414);
  a414=(a296*a472);
  a188=(a062*a295);
  a414=(a414+a188);
  a197=(a197*a414);
  a414=sin(a012);
  a414=(a414*a470);
  a404=(a404*a414);
  a197=(a197-a404);
  a378=(a378+a197);
  a197=cos(a012);
  a197=(a197*a470);
  a195=(a195*a197);
  a296=(a296*a013);
  a295=(a003*a295);
  a296=(a296+a295);
  a393=(a393*a296);
  a195=(a195+a393);
  a378=(a378-a195);
  a013=(a467*a013);
  a003=(a003*a292);
  a013=(a013+a003);
  a407=(a407*a013);
  a013=sin(a012);
  a013=(a013*a470);
  a196=(a196*a013);
  a407=(a407-a196);
  a378=(a378-a407);
  a012=cos(a012);
  a012=(a012*a470);
  a198=(a198*a012);
  a467=(a467*a472);
  a062=(a062*a292);
  a467=(a467+a062);
  a408=(a408*a467);
  a198=(a198+a408);
  a378=(a378-a198);
  a125=(a125*a378);
  a471=(a803*a471);
  a125=(a125-a471);
  a032=(a032*a125);
  a469=(a469+a032);
  a032=(a759*a577);
  a471=(a060*a114);
  a032=(a032-a471);
  a471=(a858*a725);
  a032=(a032+a471);
  a162=(a032*a162);
  a878=(a577*a878);
  a759=(a759*a881);
  a878=(a878+a759);
  a163=(a114*a163);
  a060=(a060*a038);
  a163=(a163+a060);
  a878=(a878-a163);
  a838=(a725*a838);
  a858=(a858*a886);
  a838=(a838+a858);
  a878=(a878+a838);
  a059=(a059*a878);
  a162=(a162+a059);
  a469=(a469-a162);
  if (res[1]!=0) res[1][6]=a469;
  if (res[1]!=0) res[1][7]=a125;
  if (res[1]!=0) res[1][8]=a878;
  a641=(a577*a641);
  a781=(a781*a881);
  a641=(a641+a781);
  a831=(a747*a831);
  a760=(a760*a884);
  a831=(a831+a760);
  a641=(a641+a831);
  if (res[1]!=0) res[1][9]=a641;
  a641=sin(a043);
  a831=(a641*a084);
  a760=(a831*a155);
  a781=cos(a043);
  a781=(a781*a154);
  a781=(a084*a781);
  a641=(a641*a169);
  a781=(a781+a641);
  a641=(a046*a781);
  a760=(a760+a641);
  a156=(a089*a156);
  a048=(a048*a087);
  a156=(a156+a048);
  a760=(a760-a156);
  a760=(a760+a172);
  if (res[1]!=0) res[1][10]=a760;
  a736=(a505*a736);
  a760=(a331*a801);
  a736=(a736+a760);
  a765=(a765*a736);
  a331=(a331*a505);
  a847=(a331*a847);
  a765=(a765+a847);
  a847=(a311*a333);
  a760=(a847*a339);
  a156=(a760*a270);
  a048=(a755*a333);
  a641=(a048*a543);
  a469=(a641*a270);
  a156=(a156+a469);
  a469=(a614*a505);
  a162=(a469*a683);
  a059=(a162*a270);
  a156=(a156+a059);
  a059=(a048*a502);
  a838=(a059*a084);
  a156=(a156+a838);
  a673=(a156*a673);
  a560=(a333*a560);
  a311=(a311*a638);
  a560=(a560+a311);
  a339=(a339*a560);
  a671=(a847*a671);
  a339=(a339+a671);
  a671=(a270*a339);
  a311=(a760*a482);
  a671=(a671+a311);
  a333=(a333*a464);
  a755=(a755*a638);
  a333=(a333+a755);
  a543=(a543*a333);
  a677=(a048*a677);
  a543=(a543-a677);
  a677=(a270*a543);
  a755=(a641*a482);
  a677=(a677+a755);
  a671=(a671+a677);
  a505=(a505*a804);
  a614=(a614*a801);
  a505=(a505+a614);
  a683=(a683*a505);
  a625=(a469*a625);
  a683=(a683-a625);
  a625=(a270*a683);
  a614=(a162*a482);
  a625=(a625+a614);
  a671=(a671+a625);
  a502=(a502*a333);
  a666=(a048*a666);
  a502=(a502+a666);
  a666=(a084*a502);
  a625=(a059*a169);
  a666=(a666+a625);
  a671=(a671+a666);
  a343=(a343*a671);
  a673=(a673+a343);
  a765=(a765-a673);
  a607=(a607*a560);
  a715=(a847*a715);
  a607=(a607+a715);
  a765=(a765+a607);
  a772=(a772*a736);
  a850=(a331*a850);
  a772=(a772+a850);
  a765=(a765+a772);
  a617=(a617*a505);
  a820=(a469*a820);
  a617=(a617+a820);
  a765=(a765+a617);
  a617=(a608*a560);
  a718=(a847*a718);
  a617=(a617-a718);
  a502=(a502-a617);
  a502=(a089*a502);
  a608=(a847*a608);
  a059=(a059-a608);
  a718=(a059*a087);
  a502=(a502+a718);
  a718=(a720*a505);
  a817=(a469*a817);
  a718=(a718+a817);
  a817=(a773*a736);
  a851=(a331*a851);
  a817=(a817-a851);
  a851=(a718+a817);
  a851=(a089*a851);
  a720=(a469*a720);
  a773=(a331*a773);
  a820=(a720+a773);
  a772=(a820*a087);
  a851=(a851+a772);
  a502=(a502-a851);
  a851=(a301*a392);
  a359=(a035*a359);
  a851=(a851+a359);
  a502=(a502+a851);
  a851=(a294*a149);
  a053=(a041*a053);
  a851=(a851+a053);
  a502=(a502+a851);
  a644=(a644/a246);
  a069=(a069/a246);
  a851=(a069/a246);
  a851=(a851*a466);
  a644=(a644-a851);
  a644=(a240*a644);
  a262=(a069*a262);
  a644=(a644+a262);
  a436=(a436/a246);
  a232=(a232/a246);
  a246=(a232/a246);
  a246=(a246*a466);
  a436=(a436-a246);
  a436=(a564*a436);
  a834=(a232*a834);
  a436=(a436+a834);
  a644=(a644-a436);
  a502=(a502+a644);
  a228=(a228*a502);
  a059=(a059*a089);
  a820=(a820*a089);
  a059=(a059-a820);
  a301=(a035*a301);
  a059=(a059+a301);
  a294=(a041*a294);
  a059=(a059+a294);
  a069=(a069*a240);
  a232=(a232*a564);
  a069=(a069-a232);
  a059=(a059+a069);
  a440=(a059*a440);
  a228=(a228-a440);
  a765=(a765+a228);
  if (res[2]!=0) res[2][0]=a765;
  a765=cos(a043);
  a075=(a345*a075);
  a531=(a656*a531);
  a075=(a075+a531);
  a075=(a270*a075);
  a656=(a656*a345);
  a345=(a656*a482);
  a075=(a075+a345);
  a765=(a765*a075);
  a656=(a656*a270);
  a075=sin(a043);
  a075=(a075*a154);
  a656=(a656*a075);
  a765=(a765-a656);
  a656=cos(a043);
  a075=(a176*a284);
  a345=(a075*a459);
  a284=(a284*a266);
  a497=(a176*a497);
  a284=(a284-a497);
  a497=(a095*a284);
  a345=(a345+a497);
  a345=(a270*a345);
  a497=(a095*a075);
  a531=(a497*a482);
  a345=(a345+a531);
  a656=(a656*a345);
  a497=(a497*a270);
  a345=sin(a043);
  a345=(a345*a154);
  a497=(a497*a345);
  a656=(a656-a497);
  a765=(a765-a656);
  a656=(a847*a230);
  a497=(a656*a599);
  a345=(a497*a270);
  a531=cos(a043);
  a531=(a531*a154);
  a345=(a345*a531);
  a531=sin(a043);
  a228=(a230*a560);
  a440=(a847*a441);
  a228=(a228+a440);
  a599=(a599*a228);
  a711=(a656*a711);
  a599=(a599+a711);
  a599=(a270*a599);
  a497=(a497*a482);
  a599=(a599+a497);
  a531=(a531*a599);
  a345=(a345+a531);
  a765=(a765-a345);
  a345=cos(a043);
  a531=(a227*a736);
  a599=(a331*a438);
  a531=(a531+a599);
  a599=(a764*a531);
  a497=(a331*a227);
  a848=(a497*a848);
  a599=(a599+a848);
  a345=(a345*a599);
  a764=(a497*a764);
  a599=sin(a043);
  a599=(a599*a154);
  a764=(a764*a599);
  a345=(a345-a764);
  a765=(a765+a345);
  a345=(a396*a268);
  a764=(a345*a270);
  a599=cos(a043);
  a599=(a599*a154);
  a764=(a764*a599);
  a599=sin(a043);
  a268=(a268*a685);
  a396=(a396*a487);
  a268=(a268-a396);
  a268=(a270*a268);
  a345=(a345*a482);
  a268=(a268+a345);
  a599=(a599*a268);
  a764=(a764+a599);
  a765=(a765-a764);
  a764=(a048*a230);
  a599=(a764*a369);
  a268=cos(a043);
  a268=(a268*a154);
  a599=(a599*a268);
  a268=sin(a043);
  a345=(a230*a333);
  a396=(a048*a441);
  a345=(a345+a396);
  a369=(a369*a345);
  a375=(a764*a375);
  a369=(a369+a375);
  a268=(a268*a369);
  a599=(a599+a268);
  a765=(a765-a599);
  a599=(a469*a230);
  a268=(a599*a616);
  a369=cos(a043);
  a369=(a369*a154);
  a268=(a268*a369);
  a369=sin(a043);
  a375=(a230*a505);
  a396=(a469*a441);
  a375=(a375+a396);
  a616=(a616*a375);
  a719=(a599*a719);
  a616=(a616+a719);
  a369=(a369*a616);
  a268=(a268+a369);
  a765=(a765-a268);
  a268=cos(a043);
  a369=(a156*a438);
  a671=(a227*a671);
  a369=(a369+a671);
  a268=(a268*a369);
  a156=(a227*a156);
  a369=sin(a043);
  a369=(a369*a154);
  a156=(a156*a369);
  a268=(a268-a156);
  a765=(a765-a268);
  a268=(a442*a351);
  a156=(a442*a356);
  a369=(a156*a084);
  a268=(a268+a369);
  a369=(a176*a278);
  a671=(a369*a084);
  a268=(a268+a671);
  a671=(a115*a268);
  a616=cos(a043);
  a616=(a616*a154);
  a671=(a671*a616);
  a616=sin(a043);
  a719=(a268*a463);
  a351=(a351*a121);
  a534=(a442*a534);
  a351=(a351+a534);
  a356=(a356*a121);
  a536=(a442*a536);
  a356=(a356-a536);
  a536=(a084*a356);
  a534=(a156*a169);
  a536=(a536+a534);
  a351=(a351+a536);
  a278=(a278*a266);
  a488=(a176*a488);
  a278=(a278+a488);
  a488=(a084*a278);
  a536=(a369*a169);
  a488=(a488+a536);
  a351=(a351+a488);
  a488=(a115*a351);
  a719=(a719+a488);
  a616=(a616*a719);
  a671=(a671+a616);
  a765=(a765+a671);
  a671=(a331*a768);
  a616=(a773*a084);
  a671=(a671+a616);
  a616=(a720*a084);
  a671=(a671+a616);
  a616=(a608*a084);
  a671=(a671+a616);
  a616=(a230*a671);
  a719=cos(a043);
  a719=(a719*a154);
  a616=(a616*a719);
  a719=sin(a043);
  a488=(a671*a441);
  a768=(a768*a736);
  a849=(a331*a849);
  a768=(a768+a849);
  a849=(a084*a817);
  a536=(a773*a169);
  a849=(a849+a536);
  a768=(a768+a849);
  a849=(a084*a718);
  a536=(a720*a169);
  a849=(a849+a536);
  a768=(a768+a849);
  a849=(a084*a617);
  a536=(a608*a169);
  a849=(a849+a536);
  a768=(a768+a849);
  a849=(a230*a768);
  a488=(a488+a849);
  a719=(a719*a488);
  a616=(a616+a719);
  a765=(a765+a616);
  a616=cos(a043);
  a132=(a354*a132);
  a353=(a189*a353);
  a132=(a132+a353);
  a616=(a616*a132);
  a189=(a189*a354);
  a354=sin(a043);
  a354=(a354*a154);
  a189=(a189*a354);
  a616=(a616-a189);
  a765=(a765+a616);
  a616=cos(a043);
  a189=(a227*a560);
  a354=(a847*a438);
  a189=(a189+a354);
  a354=(a606*a189);
  a132=(a847*a227);
  a605=(a132*a605);
  a354=(a354+a605);
  a616=(a616*a354);
  a606=(a132*a606);
  a354=sin(a043);
  a354=(a354*a154);
  a606=(a606*a354);
  a616=(a616-a606);
  a765=(a765+a616);
  a616=cos(a043);
  a606=(a227*a736);
  a354=(a331*a438);
  a606=(a606+a354);
  a354=(a771*a606);
  a605=(a331*a227);
  a770=(a605*a770);
  a354=(a354+a770);
  a616=(a616*a354);
  a771=(a605*a771);
  a354=sin(a043);
  a354=(a354*a154);
  a771=(a771*a354);
  a616=(a616-a771);
  a765=(a765+a616);
  a616=cos(a043);
  a193=(a274*a193);
  a489=(a079*a489);
  a193=(a193+a489);
  a193=(a084*a193);
  a079=(a079*a274);
  a274=(a079*a169);
  a193=(a193+a274);
  a616=(a616*a193);
  a079=(a079*a084);
  a193=sin(a043);
  a193=(a193*a154);
  a079=(a079*a193);
  a616=(a616-a079);
  a765=(a765+a616);
  a616=(a048*a230);
  a079=(a616*a364);
  a193=(a079*a084);
  a274=cos(a043);
  a274=(a274*a154);
  a193=(a193*a274);
  a274=sin(a043);
  a489=(a230*a333);
  a771=(a048*a441);
  a489=(a489+a771);
  a364=(a364*a489);
  a668=(a616*a668);
  a364=(a364+a668);
  a364=(a084*a364);
  a079=(a079*a169);
  a364=(a364+a079);
  a274=(a274*a364);
  a193=(a193+a274);
  a765=(a765-a193);
  a193=cos(a043);
  a274=(a227*a505);
  a364=(a469*a438);
  a274=(a274+a364);
  a364=(a618*a274);
  a079=(a469*a227);
  a821=(a079*a821);
  a364=(a364+a821);
  a193=(a193*a364);
  a618=(a079*a618);
  a364=sin(a043);
  a364=(a364*a154);
  a618=(a618*a364);
  a193=(a193-a618);
  a765=(a765+a193);
  a193=(a081*a103);
  a618=(a193*a042);
  a364=(a618*a084);
  a821=cos(a043);
  a821=(a821*a154);
  a364=(a364*a821);
  a821=sin(a043);
  a103=(a103*a165);
  a081=(a081*a133);
  a103=(a103+a081);
  a081=(a042*a103);
  a133=(a193*a151);
  a081=(a081+a133);
  a081=(a084*a081);
  a618=(a618*a169);
  a081=(a081+a618);
  a821=(a821*a081);
  a364=(a364+a821);
  a765=(a765+a364);
  a364=cos(a043);
  a821=(a046*a103);
  a081=(a193*a155);
  a821=(a821+a081);
  a821=(a084*a821);
  a081=(a193*a046);
  a618=(a081*a169);
  a821=(a821+a618);
  a364=(a364*a821);
  a081=(a081*a084);
  a821=sin(a043);
  a821=(a821*a154);
  a081=(a081*a821);
  a364=(a364-a081);
  a765=(a765-a364);
  a364=cos(a043);
  a081=arg[9]? arg[9][10] : 0;
  a821=(a046*a081);
  a618=arg[1]? arg[1][10] : 0;
  a133=(a618*a155);
  a821=(a821+a133);
  a821=(a084*a821);
  a133=(a618*a046);
  a165=(a133*a169);
  a821=(a821+a165);
  a364=(a364*a821);
  a133=(a133*a084);
  a821=sin(a043);
  a821=(a821*a154);
  a133=(a133*a821);
  a364=(a364-a133);
  a765=(a765+a364);
  a364=(a618*a089);
  a133=(a041*a049);
  a821=(a193*a089);
  a133=(a133-a821);
  a364=(a364+a133);
  a821=(a046*a364);
  a165=cos(a043);
  a165=(a165*a154);
  a821=(a821*a165);
  a165=sin(a043);
  a155=(a364*a155);
  a668=(a089*a081);
  a771=(a618*a087);
  a668=(a668+a771);
  a049=(a049*a149);
  a150=(a041*a150);
  a049=(a049+a150);
  a150=(a089*a103);
  a771=(a193*a087);
  a150=(a150+a771);
  a049=(a049-a150);
  a668=(a668+a049);
  a046=(a046*a668);
  a155=(a155+a046);
  a165=(a165*a155);
  a821=(a821+a165);
  a765=(a765+a821);
  a821=cos(a043);
  a151=(a133*a151);
  a165=(a042*a049);
  a151=(a151+a165);
  a821=(a821*a151);
  a042=(a042*a133);
  a151=sin(a043);
  a151=(a151*a154);
  a042=(a042*a151);
  a821=(a821-a042);
  a765=(a765+a821);
  a821=arg[12]? arg[12][12] : 0;
  a765=(a765+a821);
  a821=cos(a043);
  a441=(a059*a441);
  a042=(a230*a502);
  a441=(a441+a042);
  a821=(a821*a441);
  a230=(a230*a059);
  a441=sin(a043);
  a441=(a441*a154);
  a230=(a230*a441);
  a821=(a821-a230);
  a765=(a765+a821);
  a821=(a227*a059);
  a230=cos(a043);
  a230=(a230*a154);
  a821=(a821*a230);
  a230=sin(a043);
  a438=(a059*a438);
  a227=(a227*a502);
  a438=(a438+a227);
  a230=(a230*a438);
  a821=(a821+a230);
  a765=(a765-a821);
  a821=(a248*a863);
  a230=cos(a043);
  a230=(a230*a154);
  a821=(a821*a230);
  a230=sin(a043);
  a863=(a863*a457);
  a248=(a248*a855);
  a863=(a863+a248);
  a230=(a230*a863);
  a821=(a821+a230);
  a765=(a765-a821);
  a455=(a458*a455);
  a244=(a244*a861);
  a455=(a455+a244);
  a765=(a765+a455);
  a455=cos(a043);
  a244=(a203*a862);
  a821=(a203*a270);
  a821=(a244-a821);
  a447=(a821*a447);
  a862=(a862*a412);
  a840=(a203*a840);
  a862=(a862+a840);
  a840=(a270*a412);
  a230=(a203*a482);
  a840=(a840+a230);
  a840=(a862-a840);
  a230=(a236*a840);
  a447=(a447+a230);
  a455=(a455*a447);
  a236=(a236*a821);
  a447=sin(a043);
  a447=(a447*a154);
  a236=(a236*a447);
  a455=(a455-a236);
  a765=(a765+a455);
  a455=(a203*a270);
  a244=(a244-a455);
  a455=(a233*a244);
  a236=cos(a043);
  a236=(a236*a154);
  a455=(a455*a236);
  a236=sin(a043);
  a444=(a244*a444);
  a412=(a270*a412);
  a203=(a203*a482);
  a412=(a412+a203);
  a862=(a862-a412);
  a233=(a233*a862);
  a444=(a444+a233);
  a236=(a236*a444);
  a455=(a455+a236);
  a765=(a765-a455);
  a455=cos(a043);
  a236=(a041*a107);
  a444=(a369+a156);
  a233=(a444*a089);
  a412=(a236-a233);
  a412=(a412-a069);
  a203=(a035*a558);
  a412=(a412-a203);
  a463=(a412*a463);
  a107=(a107*a149);
  a475=(a041*a475);
  a107=(a107+a475);
  a475=(a278+a356);
  a475=(a089*a475);
  a444=(a444*a087);
  a475=(a475+a444);
  a444=(a107-a475);
  a444=(a444-a644);
  a558=(a558*a392);
  a035=(a035*a612);
  a558=(a558+a035);
  a444=(a444-a558);
  a035=(a115*a444);
  a463=(a463+a035);
  a455=(a455*a463);
  a115=(a115*a412);
  a463=sin(a043);
  a463=(a463*a154);
  a115=(a115*a463);
  a455=(a455-a115);
  a765=(a765+a455);
  a236=(a236-a233);
  a236=(a236-a069);
  a236=(a236-a203);
  a203=(a095*a236);
  a069=cos(a043);
  a069=(a069*a154);
  a203=(a203*a069);
  a069=sin(a043);
  a459=(a236*a459);
  a107=(a107-a475);
  a107=(a107-a644);
  a107=(a107-a558);
  a095=(a095*a107);
  a459=(a459+a095);
  a069=(a069*a459);
  a203=(a203+a069);
  a765=(a765-a203);
  a203=(a206<=a037);
  a037=(a037<=a206);
  a206=(a037+a203);
  a203=(a203/a206);
  a069=(a205<=a208);
  a208=(a208<=a205);
  a205=(a208+a069);
  a069=(a069/a205);
  a459=(a065<=a204);
  a204=(a204<=a065);
  a204=(a204+a459);
  a459=(a459/a204);
  a215=(2.*a215);
  a204=(a223*a859);
  a095=(a528*a204);
  a558=(a215*a095);
  a644=arg[4]? arg[4][14] : 0;
  a558=(a558+a644);
  a644=(a223*a865);
  a558=(a558+a644);
  a644=(a217*a558);
  a644=(a034*a644);
  a475=(a218*a558);
  a475=(a064*a475);
  a233=(a216*a475);
  a644=(a644-a233);
  a233=(2.*a209);
  a455=(a209*a475);
  a115=(a233*a455);
  a644=(a644-a115);
  a644=(a459*a644);
  a644=(a068*a644);
  a644=(a644+a558);
  a115=(a065<=a210);
  a210=(a210<=a065);
  a210=(a210+a115);
  a115=(a115/a210);
  a210=(a214*a558);
  a210=(a064*a210);
  a463=(a212*a210);
  a035=(a213*a558);
  a035=(a034*a035);
  a463=(a463-a035);
  a035=(2.*a211);
  a612=(a211*a210);
  a392=(a035*a612);
  a463=(a463+a392);
  a463=(a115*a463);
  a463=(a068*a463);
  a644=(a644-a463);
  a644=(a069*a644);
  a644=(a203*a644);
  a425=(a644*a425);
  a424=(a558*a424);
  a422=(2.*a422);
  a095=(a095*a422);
  a875=(a204*a875);
  a859=(a859*a434);
  a853=(a223*a853);
  a859=(a859+a853);
  a528=(a528*a859);
  a875=(a875+a528);
  a215=(a215*a875);
  a095=(a095+a215);
  a215=arg[12]? arg[12][14] : 0;
  a095=(a095+a215);
  a865=(a865*a434);
  a241=(a223*a241);
  a865=(a865+a241);
  a095=(a095+a865);
  a217=(a217*a095);
  a424=(a424+a217);
  a424=(a034*a424);
  a418=(a475*a418);
  a218=(a218*a095);
  a428=(a558*a428);
  a218=(a218-a428);
  a218=(a064*a218);
  a216=(a216*a218);
  a418=(a418+a216);
  a424=(a424-a418);
  a418=(2.*a426);
  a455=(a455*a418);
  a475=(a475*a426);
  a209=(a209*a218);
  a475=(a475+a209);
  a233=(a233*a475);
  a455=(a455+a233);
  a424=(a424-a455);
  a459=(a459*a424);
  a424=(a068*a459);
  a424=(a424+a095);
  a421=(a210*a421);
  a214=(a214*a095);
  a423=(a558*a423);
  a214=(a214-a423);
  a064=(a064*a214);
  a212=(a212*a064);
  a421=(a421+a212);
  a558=(a558*a420);
  a213=(a213*a095);
  a558=(a558+a213);
  a558=(a034*a558);
  a421=(a421-a558);
  a558=(2.*a419);
  a612=(a612*a558);
  a210=(a210*a419);
  a211=(a211*a064);
  a210=(a210+a211);
  a035=(a035*a210);
  a612=(a612+a035);
  a421=(a421+a612);
  a115=(a115*a421);
  a068=(a068*a115);
  a424=(a424-a068);
  a069=(a069*a424);
  a203=(a203*a069);
  a207=(a207*a203);
  a425=(a425+a207);
  a765=(a765+a425);
  a180=(a180*a023);
  a405=(a245*a405);
  a180=(a180-a405);
  a765=(a765+a180);
  if (res[2]!=0) res[2][1]=a765;
  a765=cos(a486);
  a228=(a601*a228);
  a600=(a656*a600);
  a228=(a228+a600);
  a765=(a765*a228);
  a656=(a656*a601);
  a601=sin(a486);
  a601=(a601*a652);
  a656=(a656*a601);
  a765=(a765-a656);
  a656=cos(a486);
  a601=(a610*a736);
  a713=(a331*a713);
  a601=(a601+a713);
  a601=(a270*a601);
  a610=(a331*a610);
  a713=(a610*a482);
  a601=(a601+a713);
  a656=(a656*a601);
  a610=(a610*a270);
  a601=sin(a486);
  a601=(a601*a652);
  a610=(a610*a601);
  a656=(a656-a610);
  a765=(a765-a656);
  a656=cos(a486);
  a531=(a762*a531);
  a846=(a497*a846);
  a531=(a531+a846);
  a531=(a270*a531);
  a497=(a497*a762);
  a762=(a497*a482);
  a531=(a531+a762);
  a656=(a656*a531);
  a497=(a497*a270);
  a531=sin(a486);
  a531=(a531*a652);
  a497=(a497*a531);
  a656=(a656-a497);
  a765=(a765+a656);
  a656=(a764*a376);
  a497=(a656*a270);
  a531=cos(a486);
  a531=(a531*a652);
  a497=(a497*a531);
  a531=sin(a486);
  a376=(a376*a345);
  a764=(a764*a662);
  a376=(a376-a764);
  a376=(a270*a376);
  a656=(a656*a482);
  a376=(a376+a656);
  a531=(a531*a376);
  a497=(a497+a531);
  a765=(a765-a497);
  a497=(a599*a710);
  a531=(a497*a270);
  a376=cos(a486);
  a376=(a376*a652);
  a531=(a531*a376);
  a376=sin(a486);
  a710=(a710*a375);
  a599=(a599*a814);
  a710=(a710-a599);
  a270=(a270*a710);
  a497=(a497*a482);
  a270=(a270+a497);
  a376=(a376*a270);
  a531=(a531+a376);
  a765=(a765-a531);
  a531=(a132*a604);
  a376=(a531*a084);
  a270=cos(a486);
  a270=(a270*a652);
  a376=(a376*a270);
  a270=sin(a486);
  a604=(a604*a189);
  a132=(a132*a714);
  a604=(a604+a132);
  a604=(a084*a604);
  a531=(a531*a169);
  a604=(a604+a531);
  a270=(a270*a604);
  a376=(a376+a270);
  a765=(a765-a376);
  a376=(a605*a769);
  a270=(a376*a084);
  a604=cos(a486);
  a604=(a604*a652);
  a270=(a270*a604);
  a604=sin(a486);
  a769=(a769*a606);
  a605=(a605*a767);
  a769=(a769+a605);
  a769=(a084*a769);
  a376=(a376*a169);
  a769=(a769+a376);
  a604=(a604*a769);
  a270=(a270+a604);
  a765=(a765-a270);
  a270=cos(a486);
  a489=(a360*a489);
  a538=(a616*a538);
  a489=(a489+a538);
  a270=(a270*a489);
  a616=(a616*a360);
  a360=sin(a486);
  a360=(a360*a652);
  a616=(a616*a360);
  a270=(a270-a616);
  a765=(a765+a270);
  a270=cos(a486);
  a274=(a622*a274);
  a819=(a079*a819);
  a274=(a274+a819);
  a274=(a084*a274);
  a079=(a079*a622);
  a169=(a079*a169);
  a274=(a274+a169);
  a270=(a270*a274);
  a079=(a079*a084);
  a084=sin(a486);
  a084=(a084*a652);
  a079=(a079*a084);
  a270=(a270-a079);
  a765=(a765+a270);
  a270=cos(a486);
  a079=(a541*a333);
  a674=(a048*a674);
  a079=(a079+a674);
  a270=(a270*a079);
  a541=(a048*a541);
  a079=sin(a486);
  a079=(a079*a652);
  a541=(a541*a079);
  a270=(a270-a541);
  a765=(a765+a270);
  a270=(a331*a774);
  a541=cos(a486);
  a541=(a541*a652);
  a270=(a270*a541);
  a541=sin(a486);
  a774=(a774*a736);
  a763=(a331*a763);
  a774=(a774+a763);
  a541=(a541*a774);
  a270=(a270+a541);
  a765=(a765+a270);
  a270=cos(a486);
  a541=(a613*a505);
  a822=(a469*a822);
  a541=(a541+a822);
  a270=(a270*a541);
  a613=(a469*a613);
  a541=sin(a486);
  a541=(a541*a652);
  a613=(a613*a541);
  a270=(a270-a613);
  a765=(a765-a270);
  a270=(a847*a611);
  a613=cos(a486);
  a613=(a613*a652);
  a270=(a270*a613);
  a613=sin(a486);
  a611=(a611*a560);
  a717=(a847*a717);
  a611=(a611+a717);
  a613=(a613*a611);
  a270=(a270+a613);
  a765=(a765+a270);
  a270=cos(a486);
  a613=(a093*a333);
  a172=(a048*a172);
  a613=(a613+a172);
  a270=(a270*a613);
  a093=(a048*a093);
  a613=sin(a486);
  a613=(a613*a652);
  a093=(a093*a613);
  a270=(a270-a093);
  a765=(a765+a270);
  a270=cos(a486);
  a093=(a545*a560);
  a675=(a847*a675);
  a093=(a093+a675);
  a270=(a270*a093);
  a545=(a847*a545);
  a093=sin(a486);
  a093=(a093*a652);
  a545=(a545*a093);
  a270=(a270-a545);
  a765=(a765+a270);
  a270=(a048*a546);
  a545=cos(a486);
  a545=(a545*a652);
  a270=(a270*a545);
  a545=sin(a486);
  a546=(a546*a333);
  a544=(a048*a544);
  a546=(a546+a544);
  a545=(a545*a546);
  a270=(a270+a545);
  a765=(a765-a270);
  a270=cos(a486);
  a545=(a722*a736);
  a540=(a331*a540);
  a545=(a545+a540);
  a270=(a270*a545);
  a722=(a331*a722);
  a545=sin(a486);
  a545=(a545*a652);
  a722=(a722*a545);
  a270=(a270-a722);
  a765=(a765+a270);
  a270=(a469*a593);
  a722=cos(a486);
  a722=(a722*a652);
  a270=(a270*a722);
  a722=sin(a486);
  a593=(a593*a505);
  a672=(a469*a672);
  a593=(a593+a672);
  a722=(a722*a593);
  a270=(a270+a722);
  a765=(a765+a270);
  a270=(a323*a551);
  a722=cos(a486);
  a722=(a722*a652);
  a270=(a270*a722);
  a722=sin(a486);
  a551=(a551*a649);
  a323=(a323*a550);
  a551=(a551+a323);
  a722=(a722*a551);
  a270=(a270+a722);
  a765=(a765-a270);
  a270=cos(a486);
  a665=(a297*a665);
  a722=(a377*a548);
  a665=(a665+a722);
  a270=(a270*a665);
  a377=(a377*a297);
  a665=sin(a486);
  a665=(a665*a652);
  a377=(a377*a665);
  a270=(a270-a377);
  a765=(a765+a270);
  a270=(a111*a297);
  a377=cos(a486);
  a377=(a377*a652);
  a270=(a270*a377);
  a377=sin(a486);
  a297=(a297*a653);
  a548=(a111*a548);
  a297=(a297+a548);
  a377=(a377*a297);
  a270=(a270+a377);
  a765=(a765-a270);
  a270=(a619*a263);
  a377=cos(a486);
  a377=(a377*a652);
  a270=(a270*a377);
  a377=sin(a486);
  a263=(a263*a806);
  a619=(a619*a726);
  a263=(a263+a619);
  a377=(a377*a263);
  a270=(a270+a377);
  a765=(a765-a270);
  a270=cos(a486);
  a377=(a664*a653);
  a484=(a111*a484);
  a377=(a377+a484);
  a270=(a270*a377);
  a664=(a111*a664);
  a377=sin(a486);
  a377=(a377*a652);
  a664=(a664*a377);
  a270=(a270-a664);
  a765=(a765+a270);
  a270=cos(a486);
  a647=(a483*a647);
  a664=(a529*a728);
  a647=(a647+a664);
  a270=(a270*a647);
  a529=(a529*a483);
  a647=sin(a486);
  a647=(a647*a652);
  a529=(a529*a647);
  a270=(a270-a529);
  a765=(a765-a270);
  a270=(a111*a483);
  a529=cos(a486);
  a529=(a529*a652);
  a270=(a270*a529);
  a486=sin(a486);
  a483=(a483*a653);
  a111=(a111*a728);
  a483=(a483+a111);
  a486=(a486*a483);
  a270=(a270+a486);
  a765=(a765-a270);
  if (res[2]!=0) res[2][2]=a765;
  a765=(a543+a339);
  a765=(a089*a765);
  a270=(a641+a760);
  a270=(a270*a087);
  a765=(a765+a270);
  a765=(a034*a765);
  a736=(a596*a736);
  a823=(a331*a823);
  a736=(a736+a823);
  a683=(a683-a736);
  a089=(a089*a683);
  a331=(a331*a596);
  a162=(a162-a331);
  a087=(a162*a087);
  a089=(a089+a087);
  a089=(a034*a089);
  a765=(a765-a089);
  a701=(a701*a646);
  a522=(a522*a654);
  a701=(a701+a522);
  a765=(a765+a701);
  if (res[2]!=0) res[2][3]=a765;
  a602=(a602*a560);
  a847=(a847*a712);
  a602=(a602+a847);
  a372=(a372*a333);
  a657=(a048*a657);
  a372=(a372+a657);
  a602=(a602+a372);
  a629=(a629*a505);
  a469=(a469*a809);
  a629=(a629+a469);
  a602=(a602+a629);
  a609=(a609*a768);
  a671=(a671*a716);
  a609=(a609-a671);
  a602=(a602-a609);
  a342=(a342*a333);
  a669=(a048*a669);
  a342=(a342+a669);
  a602=(a602+a342);
  a059=(a059*a443);
  a231=(a231*a502);
  a059=(a059+a231);
  a602=(a602+a059);
  if (res[2]!=0) res[2][4]=a602;
  a341=(a341+a595);
  a341=(a341+a799);
  a341=(a321*a341);
  a799=(2.*a479);
  a341=(a341*a799);
  a799=(2.*a071);
  a070=(a070+a119);
  a070=(a070+a552);
  a321=(a321*a070);
  a799=(a799*a321);
  a341=(a341+a799);
  a142=(2.*a142);
  a799=(a142*a498);
  a321=(2.*a479);
  a799=(a799*a321);
  a321=(2.*a071);
  a478=(2.*a478);
  a498=(a498*a478);
  a142=(a142*a521);
  a498=(a498+a142);
  a321=(a321*a498);
  a799=(a799+a321);
  a033=(2.*a033);
  a321=(a033*a679);
  a498=(2.*a479);
  a321=(a321*a498);
  a498=(2.*a071);
  a659=(2.*a659);
  a679=(a679*a659);
  a033=(a033*a709);
  a679=(a679+a033);
  a498=(a498*a679);
  a321=(a321+a498);
  a799=(a799+a321);
  a708=(2.*a708);
  a321=(a708*a729);
  a479=(2.*a479);
  a321=(a321*a479);
  a071=(2.*a071);
  a811=(2.*a811);
  a729=(a729*a811);
  a708=(a708*a844);
  a729=(a729+a708);
  a071=(a071*a729);
  a321=(a321+a071);
  a799=(a799+a321);
  a341=(a341-a799);
  if (res[2]!=0) res[2][5]=a341;
  a031=(a031/a030);
  a341=(a031*a123);
  a799=(a341*a139);
  a135=(a135/a030);
  a030=(a031/a030);
  a030=(a030*a138);
  a135=(a135-a030);
  a123=(a123*a135);
  a031=(a031*a141);
  a123=(a123+a031);
  a031=(a029*a123);
  a799=(a799+a031);
  a799=(-a799);
  if (res[2]!=0) res[2][6]=a799;
  a104=(a104*a036);
  a080=(a080*a082);
  a104=(a104+a080);
  a429=(a041*a429);
  a149=(a219*a149);
  a429=(a429+a149);
  a758=(a758*a429);
  a219=(a219*a041);
  a461=(a219*a461);
  a758=(a758+a461);
  a104=(a104+a758);
  a756=(a756*a431);
  a222=(a222*a689);
  a756=(a756+a222);
  a104=(a104+a756);
  a427=(a427*a406);
  a199=(a199*a411);
  a427=(a427+a199);
  a104=(a104+a427);
  a427=(a026*a341);
  a029=(2.*a029);
  a427=(a427/a029);
  a199=(2.*a140);
  a199=(a427*a199);
  a411=(2.*a028);
  a341=(a341*a137);
  a026=(a026*a123);
  a341=(a341+a026);
  a341=(a341/a029);
  a427=(a427/a029);
  a139=(2.*a139);
  a427=(a427*a139);
  a341=(a341-a427);
  a411=(a411*a341);
  a199=(a199+a411);
  a104=(a104-a199);
  if (res[2]!=0) res[2][7]=a104;
  a104=(a245*a154);
  a185=(a185*a023);
  a104=(a104+a185);
  a104=(-a104);
  if (res[2]!=0) res[2][8]=a104;
  if (res[2]!=0) res[2][9]=a023;
  a245=(a245*a401);
  a023=(a177*a023);
  a245=(a245+a023);
  if (res[2]!=0) res[2][10]=a245;
  a120=(a120*a402);
  a179=(a179*a242);
  a120=(a120+a179);
  if (res[2]!=0) res[2][11]=a120;
  a452=(a066*a452);
  a460=(a066*a460);
  a452=(a452+a460);
  a167=(a167/a186);
  a167=(a167*a872);
  a187=(a187/a175);
  a187=(a187*a399);
  a167=(a167-a187);
  a452=(a452+a167);
  if (res[2]!=0) res[2][12]=a452;
  a782=(a782*a397);
  a194=(a194*a226);
  a782=(a782+a194);
  if (res[2]!=0) res[2][13]=a782;
  a410=(a410*a409);
  a200=(a200*a874);
  a410=(a410+a200);
  if (res[2]!=0) res[2][14]=a410;
  a792=(a792*a788);
  a785=(a785*a777);
  a792=(a792+a785);
  a794=(a794*a792);
  a867=(a867*a433);
  a054=(a054*a791);
  a867=(a867+a054);
  a867=(a034*a867);
  a794=(a794+a867);
  if (res[2]!=0) res[2][15]=a794;
  if (res[2]!=0) res[2][16]=a861;
  a794=(a458*a154);
  a867=(a043*a861);
  a794=(a794+a867);
  if (res[2]!=0) res[2][17]=a794;
  a458=(a458*a401);
  a177=(a177*a861);
  a458=(a458+a177);
  if (res[2]!=0) res[2][18]=a458;
  a864=(a864*a434);
  a454=(a223*a454);
  a864=(a864+a454);
  if (res[2]!=0) res[2][19]=a864;
  if (res[2]!=0) res[2][20]=a203;
  a644=(a644*a154);
  a043=(a043*a203);
  a644=(a644+a043);
  if (res[2]!=0) res[2][21]=a644;
  a459=(a066*a459);
  a115=(a066*a115);
  a459=(a459+a115);
  a037=(a037/a206);
  a037=(a037*a069);
  a208=(a208/a205);
  a208=(a208*a424);
  a037=(a037-a208);
  a459=(a459+a037);
  if (res[2]!=0) res[2][22]=a459;
  if (res[2]!=0) res[2][23]=a859;
  a204=(a204*a873);
  a733=(a733*a859);
  a204=(a204+a733);
  if (res[2]!=0) res[2][24]=a204;
  a348=(a348*a121);
  a532=(a442*a532);
  a348=(a348+a532);
  a286=(a286*a284);
  a282=(a075*a282);
  a286=(a286+a282);
  a348=(a348-a286);
  a355=(a355*a121);
  a535=(a442*a535);
  a355=(a355+a535);
  a348=(a348+a355);
  a277=(a277*a266);
  a490=(a176*a490);
  a277=(a277+a490);
  a348=(a348+a277);
  a039=(a039*a107);
  a236=(a236*a462);
  a039=(a039-a236);
  a348=(a348+a039);
  if (res[2]!=0) res[2][25]=a348;
  a348=(a750*a173);
  a039=(a091*a661);
  a348=(a348+a039);
  if (res[2]!=0) res[2][26]=a348;
  a750=(a750*a391);
  a076=(a076*a661);
  a750=(a750+a076);
  a076=(a081-a103);
  a333=(a542*a333);
  a670=(a048*a670);
  a333=(a333+a670);
  a076=(a076+a333);
  a333=(a219*a028);
  a797=(a333*a797);
  a028=(a028*a429);
  a219=(a219*a140);
  a028=(a028+a219);
  a219=(a852*a028);
  a797=(a797+a219);
  a219=(a857*a434);
  a883=(a223*a883);
  a219=(a219+a883);
  a797=(a797+a219);
  a076=(a076+a797);
  a076=(a076-a617);
  a076=(a076-a718);
  a076=(a076-a817);
  a076=(a076-a278);
  a076=(a076-a356);
  a076=(a076/a091);
  a356=(a618-a193);
  a048=(a048*a542);
  a356=(a356+a048);
  a852=(a852*a333);
  a857=(a223*a857);
  a852=(a852+a857);
  a356=(a356+a852);
  a356=(a356-a608);
  a356=(a356-a720);
  a356=(a356-a773);
  a356=(a356-a369);
  a356=(a356-a156);
  a356=(a356/a091);
  a156=(a356/a091);
  a156=(a156*a173);
  a076=(a076-a156);
  a076=(a076/a091);
  a356=(a356/a091);
  a156=(a356/a091);
  a156=(a156*a173);
  a076=(a076-a156);
  a090=(a090*a076);
  a356=(a356*a170);
  a090=(a090+a356);
  a121=(a283*a121);
  a495=(a442*a495);
  a121=(a121+a495);
  a121=(a121+a134);
  a121=(a121-a284);
  a121=(a121-a683);
  a121=(a121-a543);
  a121=(a121-a339);
  a121=(a121-a876);
  a121=(a121/a091);
  a442=(a442*a283);
  a442=(a442+a014);
  a442=(a442-a075);
  a442=(a442-a162);
  a442=(a442-a641);
  a442=(a442-a760);
  a442=(a442-a825);
  a442=(a442/a091);
  a825=(a442/a091);
  a825=(a825*a173);
  a121=(a121-a825);
  a121=(a121/a091);
  a442=(a442/a091);
  a091=(a442/a091);
  a091=(a091*a173);
  a121=(a121-a091);
  a288=(a288*a121);
  a442=(a442*a285);
  a288=(a288+a442);
  a090=(a090+a288);
  a750=(a750-a090);
  if (res[2]!=0) res[2][27]=a750;
  a234=(a234*a862);
  a244=(a244*a446);
  a234=(a234-a244);
  if (res[2]!=0) res[2][28]=a234;
  a821=(a821*a449);
  a237=(a237*a840);
  a821=(a821+a237);
  if (res[2]!=0) res[2][29]=a821;
  a272=(a272*a266);
  a176=(a176*a485);
  a272=(a272+a176);
  a279=(a279*a351);
  a268=(a268*a493);
  a279=(a279-a268);
  a272=(a272-a279);
  a412=(a412*a465);
  a113=(a113*a444);
  a412=(a412+a113);
  a272=(a272+a412);
  if (res[2]!=0) res[2][30]=a272;
  a050=(a050*a134);
  a014=(a014*a249);
  a050=(a050+a014);
  if (res[2]!=0) res[2][31]=a050;
  a050=(a257+a480);
  if (res[2]!=0) res[2][32]=a050;
  a257=(a513*a257);
  a574=(a574*a643);
  a257=(a257-a574);
  a480=(a513*a480);
  a572=(a572*a643);
  a480=(a480-a572);
  a257=(a257+a480);
  if (res[2]!=0) res[2][33]=a257;
  a257=(a361+a504);
  if (res[2]!=0) res[2][34]=a257;
  a361=(a513*a361);
  a556=(a556*a643);
  a361=(a361-a556);
  a513=(a513*a504);
  a732=(a732*a643);
  a513=(a513-a732);
  a361=(a361+a513);
  if (res[2]!=0) res[2][35]=a361;
  a144=(a144*a802);
  a634=(a634*a766);
  a144=(a144+a634);
  if (res[2]!=0) res[2][36]=a144;
  a693=(a633*a693);
  a583=(a583*a660);
  a693=(a693+a583);
  a694=(a694/a565);
  a586=(a586/a565);
  a583=(a586/a565);
  a583=(a583*a690);
  a694=(a694-a583);
  a694=(a553*a694);
  a586=(a586*a555);
  a694=(a694+a586);
  a693=(a693-a694);
  a338=(a338*a692);
  a067=(a581*a067);
  a338=(a338+a067);
  a693=(a693+a338);
  a836=(a796*a836);
  a746=(a746*a688);
  a836=(a836+a746);
  a693=(a693+a836);
  a837=(a837/a565);
  a749=(a749/a565);
  a836=(a749/a565);
  a836=(a836*a690);
  a837=(a837-a836);
  a837=(a640*a837);
  a749=(a749*a691);
  a837=(a837+a749);
  a693=(a693-a837);
  a734=(a734*a835);
  a651=(a744*a651);
  a734=(a734+a651);
  a693=(a693+a734);
  a570=(a570/a569);
  a632=(a632/a682);
  a554=(a632*a554);
  a580=(a580/a571);
  a642=(a580*a642);
  a554=(a554-a642);
  a795=(a795/a727);
  a293=(a795*a293);
  a554=(a554+a293);
  a743=(a743/a738);
  a731=(a743*a731);
  a554=(a554-a731);
  a731=(a570*a554);
  a738=(a731*a697);
  a632=(a632*a335);
  a580=(a580*a591);
  a632=(a632-a580);
  a795=(a795*a584);
  a632=(a632+a795);
  a743=(a743*a754);
  a632=(a632-a743);
  a632=(a570*a632);
  a695=(a695/a569);
  a570=(a570/a569);
  a570=(a570*a696);
  a695=(a695+a570);
  a554=(a554*a695);
  a632=(a632-a554);
  a554=(a568*a632);
  a738=(a738+a554);
  a693=(a693-a738);
  if (res[2]!=0) res[2][37]=a693;
  a633=(a633*a700);
  a585=(a585*a660);
  a633=(a633+a585);
  a553=(a553*a692);
  a581=(a581*a555);
  a553=(a553+a581);
  a633=(a633-a553);
  a796=(a796*a839);
  a748=(a748*a688);
  a796=(a796+a748);
  a633=(a633+a796);
  a640=(a640*a835);
  a744=(a744*a691);
  a640=(a640+a744);
  a633=(a633-a640);
  a640=(a011<=a567);
  a567=(a567<=a011);
  a567=(a567+a640);
  a640=(a640/a567);
  a690=(a731*a690);
  a632=(a565*a632);
  a690=(a690+a632);
  a568=(2.*a568);
  a690=(a690/a568);
  a565=(a565*a731);
  a565=(a565/a568);
  a565=(a565/a568);
  a697=(2.*a697);
  a565=(a565*a697);
  a690=(a690-a565);
  a640=(a640*a690);
  a633=(a633-a640);
  if (res[2]!=0) res[2][38]=a633;
  a576=(a576*a706);
  a588=(a588*a319);
  a576=(a576+a588);
  a740=(a740*a842);
  a751=(a751*a686);
  a740=(a740+a751);
  a576=(a576+a740);
  if (res[2]!=0) res[2][39]=a576;
  a678=(a678*a687);
  a590=(a590*a626);
  a678=(a678+a590);
  a824=(a824*a832);
  a753=(a753*a789);
  a824=(a824+a753);
  a678=(a678+a824);
  if (res[2]!=0) res[2][40]=a678;
  a587=(a587-a621);
  if (res[2]!=0) res[2][41]=a587;
  a563=(a563*a639);
  a303=(a303*a603);
  a563=(a563+a303);
  if (res[2]!=0) res[2][42]=a563;
  a308=(a308-a368);
  if (res[2]!=0) res[2][43]=a308;
  a201=(a201*a136);
  a125=(a058*a125);
  a201=(a201+a125);
  if (res[2]!=0) res[2][44]=a201;
  a349=(a349*a340);
  a309=(a309*a530);
  a349=(a349+a309);
  a803=(a803*a468);
  a130=(a130*a378);
  a803=(a803+a130);
  a349=(a349+a803);
  a349=(-a349);
  if (res[2]!=0) res[2][45]=a349;
  if (res[2]!=0) res[2][46]=a807;
  a317=(a317*a390);
  a807=(a250*a807);
  a317=(a317+a807);
  if (res[2]!=0) res[2][47]=a317;
  if (res[2]!=0) res[2][48]=a752;
  a260=(a260*a390);
  a250=(a250*a752);
  a260=(a260+a250);
  if (res[2]!=0) res[2][49]=a260;
  a833=(a833*a386);
  a251=(a251*a358);
  a833=(a833+a251);
  if (res[2]!=0) res[2][50]=a833;
  a516=(a380*a516);
  a332=(a332*a507);
  a516=(a516+a332);
  a512=(a512/a310);
  a330=(a330/a310);
  a332=(a330/a310);
  a332=(a332*a509);
  a512=(a512-a332);
  a512=(a298*a512);
  a330=(a330*a300);
  a512=(a512+a330);
  a516=(a516-a512);
  a259=(a259*a514);
  a109=(a327*a109);
  a259=(a259+a109);
  a516=(a516+a259);
  a315=(a315/a314);
  a379=(a379/a501);
  a299=(a379*a299);
  a326=(a326/a316);
  a382=(a326*a382);
  a299=(a299-a382);
  a382=(a315*a299);
  a316=(a382*a519);
  a379=(a379*a255);
  a326=(a326*a337);
  a379=(a379-a326);
  a379=(a315*a379);
  a517=(a517/a314);
  a315=(a315/a314);
  a315=(a315*a518);
  a517=(a517+a315);
  a299=(a299*a517);
  a379=(a379-a299);
  a299=(a313*a379);
  a316=(a316+a299);
  a516=(a516-a316);
  if (res[2]!=0) res[2][51]=a516;
  a380=(a380*a515);
  a329=(a329*a507);
  a380=(a380+a329);
  a298=(a298*a514);
  a327=(a327*a300);
  a298=(a298+a327);
  a380=(a380-a298);
  a298=(a011<=a312);
  a312=(a312<=a011);
  a312=(a312+a298);
  a298=(a298/a312);
  a509=(a382*a509);
  a379=(a310*a379);
  a509=(a509+a379);
  a313=(2.*a313);
  a509=(a509/a313);
  a310=(a310*a382);
  a310=(a310/a313);
  a310=(a310/a313);
  a519=(2.*a519);
  a310=(a310*a519);
  a509=(a509-a310);
  a298=(a298*a509);
  a380=(a380-a298);
  if (res[2]!=0) res[2][52]=a380;
  a320=(a320*a520);
  a334=(a334*a063);
  a320=(a320+a334);
  if (res[2]!=0) res[2][53]=a320;
  a289=(a289*a506);
  a336=(a336*a373);
  a289=(a289+a336);
  if (res[2]!=0) res[2][54]=a289;
  a258=(a258/a252);
  a267=(a267/a252);
  a267=(a267/a252);
  a267=(a267*a385);
  a258=(a258-a267);
  if (res[2]!=0) res[2][55]=a258;
  a032=(a032*a136);
  a058=(a058*a878);
  a032=(a032+a058);
  a032=(-a032);
  if (res[2]!=0) res[2][56]=a032;
  a032=(a725*a221);
  a058=(a776*a886);
  a032=(a032+a058);
  if (res[2]!=0) res[2][57]=a032;
  a032=(a333*a566);
  a058=(a032*a880);
  a566=(a566*a028);
  a887=(a333*a887);
  a566=(a566+a887);
  a887=(a724*a566);
  a058=(a058+a887);
  if (res[2]!=0) res[2][58]=a058;
  a725=(a725*a148);
  a886=(a057*a886);
  a725=(a725+a886);
  if (res[2]!=0) res[2][59]=a725;
  a829=(a829*a434);
  a328=(a223*a328);
  a829=(a829+a328);
  a856=(a856*a434);
  a223=(a223*a630);
  a856=(a856+a223);
  a829=(a829+a856);
  a856=(a333*a793);
  a880=(2.*a880);
  a856=(a856*a880);
  a724=(2.*a724);
  a793=(a793*a028);
  a116=(a333*a116);
  a793=(a793+a116);
  a724=(a724*a793);
  a856=(a856+a724);
  a829=(a829+a856);
  a032=(a032*a812);
  a784=(a784*a566);
  a032=(a032+a784);
  a829=(a829+a032);
  if (res[2]!=0) res[2][60]=a829;
  a829=(a747*a800);
  a032=(a780*a884);
  a829=(a829+a032);
  if (res[2]!=0) res[2][61]=a829;
  a747=(a747*a221);
  a884=(a776*a884);
  a747=(a747+a884);
  if (res[2]!=0) res[2][62]=a747;
  a225=(a333*a225);
  a028=(a845*a028);
  a225=(a225+a028);
  a698=(a698*a225);
  a845=(a845*a333);
  a885=(a845*a885);
  a698=(a698+a885);
  if (res[2]!=0) res[2][63]=a698;
  a800=(a577*a800);
  a780=(a780*a881);
  a800=(a800+a780);
  if (res[2]!=0) res[2][64]=a800;
  a221=(a577*a221);
  a776=(a776*a881);
  a221=(a221+a776);
  if (res[2]!=0) res[2][65]=a221;
  a830=(a830*a225);
  a845=(a845*a882);
  a830=(a830+a845);
  if (res[2]!=0) res[2][66]=a830;
  a577=(a577*a148);
  a881=(a057*a881);
  a577=(a577+a881);
  if (res[2]!=0) res[2][67]=a577;
  a831=(a831*a081);
  a618=(a618*a781);
  a831=(a831+a618);
  a088=(a088*a103);
  a171=(a193*a171);
  a088=(a088+a171);
  a831=(a831-a088);
  a047=(a047*a668);
  a364=(a364*a157);
  a047=(a047-a364);
  a831=(a831-a047);
  if (res[2]!=0) res[2][68]=a831;
  a133=(a133*a153);
  a044=(a044*a049);
  a133=(a133+a044);
  a085=(a085*a103);
  a193=(a193*a083);
  a085=(a085+a193);
  a133=(a133-a085);
  if (res[2]!=0) res[2][69]=a133;
  a102=(a066*a102);
  a066=(a066*a112);
  a102=(a102+a066);
  a097=(a097/a098);
  a097=(a097*a099);
  a100=(a100/a101);
  a100=(a100*a146);
  a097=(a097-a100);
  a102=(a102+a097);
  if (res[2]!=0) res[2][70]=a102;
  a108=(a108*a009);
  a056=(a056*a096);
  a108=(a108+a056);
  if (res[2]!=0) res[2][71]=a108;
  a114=(a114*a148);
  a057=(a057*a038);
  a114=(a114+a057);
  a114=(-a114);
  if (res[2]!=0) res[2][72]=a114;
  a106=(a106*a145);
  a074=(a074*a164);
  a106=(a106+a074);
  a034=(a034*a106);
  if (res[2]!=0) res[2][73]=a034;
  a105=(a105*a143);
  a078=(a078*a092);
  a105=(a105+a078);
  if (res[2]!=0) res[2][74]=a105;
  a021=(-a021);
  if (res[2]!=0) res[2][75]=a021;
  a021=-5.0000000000000000e-01;
  a021=(a021*a439);
  if (res[2]!=0) res[2][76]=a021;
  a229=(-a229);
  if (res[2]!=0) res[2][77]=a229;
  if (res[2]!=0) res[2][78]=a065;
  return 0;
}

CASADI_SYMBOL_EXPORT int fwd1_adj1_rollout_outputs(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f7(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int fwd1_adj1_rollout_outputs_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void fwd1_adj1_rollout_outputs_release(int mem) {
}

CASADI_SYMBOL_EXPORT void fwd1_adj1_rollout_outputs_incref(void) {
}

CASADI_SYMBOL_EXPORT void fwd1_adj1_rollout_outputs_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_rollout_outputs_n_in(void) { return 13;}

CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_rollout_outputs_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_rollout_outputs_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* fwd1_adj1_rollout_outputs_name_in(casadi_int i) {
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

CASADI_SYMBOL_EXPORT const char* fwd1_adj1_rollout_outputs_name_out(casadi_int i) {
  switch (i) {
    case 0: return "fwd_adj_x";
    case 1: return "fwd_adj_u";
    case 2: return "fwd_adj_p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_rollout_outputs_sparsity_in(casadi_int i) {
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

CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_rollout_outputs_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int fwd1_adj1_rollout_outputs_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 13;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int fwd1_adj1_rollout_outputs_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 13*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* b_wing_follows:(S_wing)->(b_wing) */
static int casadi_f8(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1;
  a0=2.6457513110645907e+00;
  a1=arg[0]? arg[0][0] : 0;
  a1=sqrt(a1);
  a0=(a0*a1);
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int b_wing_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f8(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int b_wing_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void b_wing_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void b_wing_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void b_wing_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int b_wing_follows_n_in(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_int b_wing_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real b_wing_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* b_wing_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "S_wing";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* b_wing_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "b_wing";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* b_wing_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* b_wing_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int b_wing_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int b_wing_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* c_wing_follows:(b_wing,S_wing)->(c_wing) */
static int casadi_f9(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1;
  a0=arg[1]? arg[1][0] : 0;
  a1=arg[0]? arg[0][0] : 0;
  a0=(a0/a1);
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int c_wing_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f9(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int c_wing_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void c_wing_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void c_wing_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void c_wing_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int c_wing_follows_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int c_wing_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real c_wing_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* c_wing_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "b_wing";
    case 1: return "S_wing";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* c_wing_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "c_wing";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* c_wing_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    case 1: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* c_wing_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int c_wing_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 2;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int c_wing_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 2*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* CL_alpha_follows:(b_wing,S_wing)->(CL_alpha) */
static int casadi_f10(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1, a2;
  a0=6.2831853071795898e+00;
  a1=arg[0]? arg[0][0] : 0;
  a1=casadi_sq(a1);
  a2=arg[1]? arg[1][0] : 0;
  a1=(a1/a2);
  a0=(a0*a1);
  a1=casadi_sq(a1);
  a2=4.;
  a1=(a1+a2);
  a1=sqrt(a1);
  a2=2.;
  a1=(a1+a2);
  a0=(a0/a1);
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int CL_alpha_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f10(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int CL_alpha_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void CL_alpha_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void CL_alpha_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void CL_alpha_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int CL_alpha_follows_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int CL_alpha_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real CL_alpha_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* CL_alpha_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "b_wing";
    case 1: return "S_wing";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* CL_alpha_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "CL_alpha";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* CL_alpha_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    case 1: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* CL_alpha_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int CL_alpha_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 2;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int CL_alpha_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 2*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* CL_0_follows:()->(CL_0) */
static int casadi_f11(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=2.9999999999999999e-01;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int CL_0_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f11(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int CL_0_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void CL_0_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void CL_0_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void CL_0_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int CL_0_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int CL_0_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real CL_0_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* CL_0_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* CL_0_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "CL_0";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* CL_0_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* CL_0_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int CL_0_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int CL_0_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* CL_max_follows:()->(CL_max) */
static int casadi_f12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=1.5000000000000000e+00;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int CL_max_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f12(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int CL_max_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void CL_max_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void CL_max_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void CL_max_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int CL_max_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int CL_max_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real CL_max_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* CL_max_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* CL_max_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "CL_max";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* CL_max_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* CL_max_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int CL_max_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int CL_max_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* CD_0_follows:()->(CD_0) */
static int casadi_f13(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=3.5000000000000003e-02;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int CD_0_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f13(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int CD_0_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void CD_0_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void CD_0_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void CD_0_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int CD_0_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int CD_0_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real CD_0_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* CD_0_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* CD_0_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "CD_0";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* CD_0_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* CD_0_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int CD_0_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int CD_0_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* K_drag_follows:(b_wing,S_wing)->(K_drag) */
static int casadi_f14(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1, a2;
  a0=3.9788735772973799e-01;
  a1=arg[0]? arg[0][0] : 0;
  a1=casadi_sq(a1);
  a2=arg[1]? arg[1][0] : 0;
  a1=(a1/a2);
  a0=(a0/a1);
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int K_drag_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f14(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int K_drag_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void K_drag_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void K_drag_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void K_drag_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int K_drag_follows_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int K_drag_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real K_drag_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* K_drag_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "b_wing";
    case 1: return "S_wing";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* K_drag_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "K_drag";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* K_drag_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    case 1: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* K_drag_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int K_drag_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 2;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int K_drag_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 2*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* Cl_p_follows:(CL_alpha)->(Cl_p) */
static int casadi_f15(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1;
  a0=-1.6666666666666666e-01;
  a1=arg[0]? arg[0][0] : 0;
  a0=(a0*a1);
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int Cl_p_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f15(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int Cl_p_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void Cl_p_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void Cl_p_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void Cl_p_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int Cl_p_follows_n_in(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_int Cl_p_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real Cl_p_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* Cl_p_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "CL_alpha";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* Cl_p_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "Cl_p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* Cl_p_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* Cl_p_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int Cl_p_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int Cl_p_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* Cl_r_follows:(CL_0)->(Cl_r) */
static int casadi_f16(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1;
  a0=3.3333333333333331e-01;
  a1=arg[0]? arg[0][0] : 0;
  a0=(a0*a1);
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int Cl_r_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f16(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int Cl_r_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void Cl_r_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void Cl_r_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void Cl_r_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int Cl_r_follows_n_in(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_int Cl_r_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real Cl_r_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* Cl_r_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "CL_0";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* Cl_r_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "Cl_r";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* Cl_r_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* Cl_r_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int Cl_r_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int Cl_r_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* Cl_beta_follows:(CL_alpha)->(Cl_beta) */
static int casadi_f17(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1;
  a0=-1.3089969389957500e-02;
  a1=arg[0]? arg[0][0] : 0;
  a0=(a0*a1);
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int Cl_beta_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f17(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int Cl_beta_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void Cl_beta_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void Cl_beta_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void Cl_beta_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int Cl_beta_follows_n_in(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_int Cl_beta_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real Cl_beta_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* Cl_beta_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "CL_alpha";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* Cl_beta_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "Cl_beta";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* Cl_beta_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* Cl_beta_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int Cl_beta_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int Cl_beta_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* Cl_aileron_follows:(CL_alpha)->(Cl_aileron) */
static int casadi_f18(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1;
  a0=5.9999999999999998e-02;
  a1=arg[0]? arg[0][0] : 0;
  a0=(a0*a1);
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int Cl_aileron_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f18(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int Cl_aileron_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void Cl_aileron_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void Cl_aileron_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void Cl_aileron_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int Cl_aileron_follows_n_in(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_int Cl_aileron_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real Cl_aileron_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* Cl_aileron_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "CL_alpha";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* Cl_aileron_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "Cl_aileron";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* Cl_aileron_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* Cl_aileron_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int Cl_aileron_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int Cl_aileron_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* Cm_0_follows:()->(Cm_0) */
static int casadi_f19(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=-5.0000000000000003e-02;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int Cm_0_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f19(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int Cm_0_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void Cm_0_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void Cm_0_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void Cm_0_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int Cm_0_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int Cm_0_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real Cm_0_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* Cm_0_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* Cm_0_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "Cm_0";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* Cm_0_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* Cm_0_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int Cm_0_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int Cm_0_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* Cm_alpha_follows:()->(Cm_alpha) */
static int casadi_f20(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=0.;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int Cm_alpha_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f20(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int Cm_alpha_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void Cm_alpha_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void Cm_alpha_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void Cm_alpha_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int Cm_alpha_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int Cm_alpha_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real Cm_alpha_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* Cm_alpha_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* Cm_alpha_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "Cm_alpha";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* Cm_alpha_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* Cm_alpha_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int Cm_alpha_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int Cm_alpha_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* Cm_q_follows:()->(Cm_q) */
static int casadi_f21(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=0.;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int Cm_q_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f21(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int Cm_q_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void Cm_q_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void Cm_q_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void Cm_q_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int Cm_q_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int Cm_q_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real Cm_q_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* Cm_q_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* Cm_q_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "Cm_q";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* Cm_q_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* Cm_q_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int Cm_q_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int Cm_q_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* Cm_elevator_follows:()->(Cm_elevator) */
static int casadi_f22(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=0.;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int Cm_elevator_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f22(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int Cm_elevator_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void Cm_elevator_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void Cm_elevator_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void Cm_elevator_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int Cm_elevator_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int Cm_elevator_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real Cm_elevator_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* Cm_elevator_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* Cm_elevator_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "Cm_elevator";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* Cm_elevator_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* Cm_elevator_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int Cm_elevator_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int Cm_elevator_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* CY_beta_follows:()->(CY_beta) */
static int casadi_f23(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=0.;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int CY_beta_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f23(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int CY_beta_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void CY_beta_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void CY_beta_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void CY_beta_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int CY_beta_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int CY_beta_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real CY_beta_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* CY_beta_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* CY_beta_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "CY_beta";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* CY_beta_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* CY_beta_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int CY_beta_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int CY_beta_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* CY_r_follows:()->(CY_r) */
static int casadi_f24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=0.;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int CY_r_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f24(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int CY_r_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void CY_r_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void CY_r_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void CY_r_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int CY_r_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int CY_r_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real CY_r_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* CY_r_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* CY_r_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "CY_r";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* CY_r_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* CY_r_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int CY_r_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int CY_r_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* CY_rudder_follows:()->(CY_rudder) */
static int casadi_f25(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=0.;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int CY_rudder_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f25(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int CY_rudder_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void CY_rudder_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void CY_rudder_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void CY_rudder_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int CY_rudder_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int CY_rudder_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real CY_rudder_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* CY_rudder_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* CY_rudder_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "CY_rudder";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* CY_rudder_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* CY_rudder_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int CY_rudder_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int CY_rudder_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* Cn_beta_follows:()->(Cn_beta) */
static int casadi_f26(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=0.;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int Cn_beta_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f26(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int Cn_beta_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void Cn_beta_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void Cn_beta_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void Cn_beta_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int Cn_beta_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int Cn_beta_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real Cn_beta_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* Cn_beta_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* Cn_beta_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "Cn_beta";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* Cn_beta_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* Cn_beta_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int Cn_beta_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int Cn_beta_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* Cn_r_follows:()->(Cn_r) */
static int casadi_f27(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=0.;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int Cn_r_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f27(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int Cn_r_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void Cn_r_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void Cn_r_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void Cn_r_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int Cn_r_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int Cn_r_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real Cn_r_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* Cn_r_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* Cn_r_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "Cn_r";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* Cn_r_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* Cn_r_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int Cn_r_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int Cn_r_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* Cn_rudder_follows:()->(Cn_rudder) */
static int casadi_f28(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=0.;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int Cn_rudder_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f28(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int Cn_rudder_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void Cn_rudder_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void Cn_rudder_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void Cn_rudder_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int Cn_rudder_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int Cn_rudder_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real Cn_rudder_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* Cn_rudder_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* Cn_rudder_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "Cn_rudder";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* Cn_rudder_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* Cn_rudder_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int Cn_rudder_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int Cn_rudder_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* Cn_aileron_follows:()->(Cn_aileron) */
static int casadi_f29(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=0.;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int Cn_aileron_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f29(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int Cn_aileron_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void Cn_aileron_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void Cn_aileron_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void Cn_aileron_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int Cn_aileron_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int Cn_aileron_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real Cn_aileron_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* Cn_aileron_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* Cn_aileron_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "Cn_aileron";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* Cn_aileron_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* Cn_aileron_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int Cn_aileron_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int Cn_aileron_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* theta_ground_follows:()->(theta_ground) */
static int casadi_f30(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=0.;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int theta_ground_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f30(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int theta_ground_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void theta_ground_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void theta_ground_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void theta_ground_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int theta_ground_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int theta_ground_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real theta_ground_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* theta_ground_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* theta_ground_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "theta_ground";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* theta_ground_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* theta_ground_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int theta_ground_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int theta_ground_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* h_cg_follows:(b)->(h_cg) */
static int casadi_f31(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1;
  a0=2.0000000000000001e-01;
  a1=arg[0]? arg[0][0] : 0;
  a0=(a0*a1);
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int h_cg_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f31(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int h_cg_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void h_cg_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void h_cg_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void h_cg_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int h_cg_follows_n_in(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_int h_cg_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real h_cg_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* h_cg_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "b";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* h_cg_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "h_cg";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* h_cg_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* h_cg_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int h_cg_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int h_cg_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* a_third_follows:(b)->(a_third) */
static int casadi_f32(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=arg[0]? arg[0][0] : 0;
  a0=(-a0);
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int a_third_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f32(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int a_third_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void a_third_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void a_third_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void a_third_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int a_third_follows_n_in(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_int a_third_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real a_third_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* a_third_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "b";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* a_third_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "a_third";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* a_third_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* a_third_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int a_third_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int a_third_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* sag_main_follows:()->(sag_main) */
static int casadi_f33(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=8.9999999999999997e-02;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int sag_main_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f33(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int sag_main_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void sag_main_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void sag_main_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void sag_main_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int sag_main_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int sag_main_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real sag_main_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* sag_main_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* sag_main_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "sag_main";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* sag_main_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* sag_main_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int sag_main_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int sag_main_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* sag_third_follows:()->(sag_third) */
static int casadi_f34(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=5.0000000000000003e-02;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int sag_third_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f34(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int sag_third_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void sag_third_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void sag_third_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void sag_third_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int sag_third_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int sag_third_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real sag_third_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* sag_third_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* sag_third_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "sag_third";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* sag_third_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* sag_third_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int sag_third_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int sag_third_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* zeta_leg_follows:()->(zeta_leg) */
static int casadi_f35(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=1.4999999999999999e-01;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int zeta_leg_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f35(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int zeta_leg_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void zeta_leg_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void zeta_leg_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void zeta_leg_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int zeta_leg_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int zeta_leg_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real zeta_leg_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* zeta_leg_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* zeta_leg_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "zeta_leg";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* zeta_leg_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* zeta_leg_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int zeta_leg_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int zeta_leg_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* z_main_follows:(h_cg,sag_main)->(z_main) */
static int casadi_f36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1;
  a0=arg[0]? arg[0][0] : 0;
  a1=arg[1]? arg[1][0] : 0;
  a0=(a0+a1);
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int z_main_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f36(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int z_main_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void z_main_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void z_main_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void z_main_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int z_main_follows_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int z_main_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real z_main_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* z_main_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "h_cg";
    case 1: return "sag_main";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* z_main_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "z_main";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* z_main_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    case 1: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* z_main_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int z_main_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 2;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int z_main_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 2*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* z_third_follows:(theta_ground,h_cg,a_third,sag_third,a)->(z_third) */
static int casadi_f37(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1, a2;
  a0=arg[1]? arg[1][0] : 0;
  a1=arg[3]? arg[3][0] : 0;
  a0=(a0+a1);
  a1=arg[4]? arg[4][0] : 0;
  a2=arg[2]? arg[2][0] : 0;
  a1=(a1-a2);
  a2=arg[0]? arg[0][0] : 0;
  a2=tan(a2);
  a1=(a1*a2);
  a0=(a0-a1);
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int z_third_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f37(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int z_third_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void z_third_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void z_third_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void z_third_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int z_third_follows_n_in(void) { return 5;}

CASADI_SYMBOL_EXPORT casadi_int z_third_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real z_third_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* z_third_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "theta_ground";
    case 1: return "h_cg";
    case 2: return "a_third";
    case 3: return "sag_third";
    case 4: return "a";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* z_third_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "z_third";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* z_third_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    case 1: return casadi_s8;
    case 2: return casadi_s8;
    case 3: return casadi_s8;
    case 4: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* z_third_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int z_third_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int z_third_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* k_main_follows:(theta_ground,a_third,sag_main,sag_third,z_main,z_third,a,g,m)->(k_main) */
static int casadi_f38(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1, a2, a3, a4, a5, a6, a7, a8, a9;
  a0=-5.0000000000000000e-01;
  a1=arg[6]? arg[6][0] : 0;
  a2=arg[0]? arg[0][0] : 0;
  a3=cos(a2);
  a1=(a1*a3);
  a3=arg[4]? arg[4][0] : 0;
  a4=arg[2]? arg[2][0] : 0;
  a3=(a3-a4);
  a5=sin(a2);
  a3=(a3*a5);
  a1=(a1+a3);
  a3=arg[7]? arg[7][0] : 0;
  a5=(a1*a3);
  a6=arg[8]? arg[8][0] : 0;
  a5=(a5*a6);
  a7=arg[1]? arg[1][0] : 0;
  a8=cos(a2);
  a7=(a7*a8);
  a8=arg[5]? arg[5][0] : 0;
  a9=arg[3]? arg[3][0] : 0;
  a8=(a8-a9);
  a2=sin(a2);
  a8=(a8*a2);
  a7=(a7+a8);
  a1=(a1-a7);
  a5=(a5/a1);
  a0=(a0*a5);
  a5=5.0000000000000000e-01;
  a5=(a5*a3);
  a5=(a5*a6);
  a0=(a0+a5);
  a0=(a0/a4);
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int k_main_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f38(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int k_main_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void k_main_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void k_main_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void k_main_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int k_main_follows_n_in(void) { return 9;}

CASADI_SYMBOL_EXPORT casadi_int k_main_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real k_main_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* k_main_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "theta_ground";
    case 1: return "a_third";
    case 2: return "sag_main";
    case 3: return "sag_third";
    case 4: return "z_main";
    case 5: return "z_third";
    case 6: return "a";
    case 7: return "g";
    case 8: return "m";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* k_main_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "k_main";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* k_main_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    case 1: return casadi_s8;
    case 2: return casadi_s8;
    case 3: return casadi_s8;
    case 4: return casadi_s8;
    case 5: return casadi_s8;
    case 6: return casadi_s8;
    case 7: return casadi_s8;
    case 8: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* k_main_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int k_main_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 9;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int k_main_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 9*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* k_third_follows:(theta_ground,a_third,sag_main,sag_third,z_main,z_third,a,g,m)->(k_third) */
static int casadi_f39(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1, a2, a3, a4, a5;
  a0=arg[6]? arg[6][0] : 0;
  a1=arg[0]? arg[0][0] : 0;
  a2=cos(a1);
  a0=(a0*a2);
  a2=arg[4]? arg[4][0] : 0;
  a3=arg[2]? arg[2][0] : 0;
  a2=(a2-a3);
  a3=sin(a1);
  a2=(a2*a3);
  a0=(a0+a2);
  a2=arg[7]? arg[7][0] : 0;
  a2=(a0*a2);
  a3=arg[8]? arg[8][0] : 0;
  a2=(a2*a3);
  a3=arg[1]? arg[1][0] : 0;
  a4=cos(a1);
  a3=(a3*a4);
  a4=arg[5]? arg[5][0] : 0;
  a5=arg[3]? arg[3][0] : 0;
  a4=(a4-a5);
  a1=sin(a1);
  a4=(a4*a1);
  a3=(a3+a4);
  a0=(a0-a3);
  a2=(a2/a0);
  a2=(a2/a5);
  if (res[0]!=0) res[0][0]=a2;
  return 0;
}

CASADI_SYMBOL_EXPORT int k_third_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f39(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int k_third_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void k_third_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void k_third_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void k_third_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int k_third_follows_n_in(void) { return 9;}

CASADI_SYMBOL_EXPORT casadi_int k_third_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real k_third_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* k_third_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "theta_ground";
    case 1: return "a_third";
    case 2: return "sag_main";
    case 3: return "sag_third";
    case 4: return "z_main";
    case 5: return "z_third";
    case 6: return "a";
    case 7: return "g";
    case 8: return "m";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* k_third_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "k_third";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* k_third_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    case 1: return casadi_s8;
    case 2: return casadi_s8;
    case 3: return casadi_s8;
    case 4: return casadi_s8;
    case 5: return casadi_s8;
    case 6: return casadi_s8;
    case 7: return casadi_s8;
    case 8: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* k_third_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int k_third_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 9;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int k_third_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 9*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* c_main_follows:(theta_ground,a_third,sag_main,sag_third,zeta_leg,z_main,z_third,a,g,m)->(c_main) */
static int casadi_f40(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1, a2, a3, a4, a5, a6, a7, a8, a9;
  a0=-5.0000000000000000e-01;
  a1=arg[7]? arg[7][0] : 0;
  a2=arg[0]? arg[0][0] : 0;
  a3=cos(a2);
  a1=(a1*a3);
  a3=arg[5]? arg[5][0] : 0;
  a4=arg[2]? arg[2][0] : 0;
  a3=(a3-a4);
  a5=sin(a2);
  a3=(a3*a5);
  a1=(a1+a3);
  a3=arg[8]? arg[8][0] : 0;
  a5=(a1*a3);
  a6=arg[9]? arg[9][0] : 0;
  a5=(a5*a6);
  a7=arg[1]? arg[1][0] : 0;
  a8=cos(a2);
  a7=(a7*a8);
  a8=arg[6]? arg[6][0] : 0;
  a9=arg[3]? arg[3][0] : 0;
  a8=(a8-a9);
  a2=sin(a2);
  a8=(a8*a2);
  a7=(a7+a8);
  a1=(a1-a7);
  a5=(a5/a1);
  a0=(a0*a5);
  a5=5.0000000000000000e-01;
  a5=(a5*a3);
  a5=(a5*a6);
  a0=(a0+a5);
  a0=(2.*a0);
  a5=arg[4]? arg[4][0] : 0;
  a0=(a0*a5);
  a3=sqrt(a3);
  a4=sqrt(a4);
  a3=(a3*a4);
  a0=(a0/a3);
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int c_main_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f40(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int c_main_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void c_main_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void c_main_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void c_main_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int c_main_follows_n_in(void) { return 10;}

CASADI_SYMBOL_EXPORT casadi_int c_main_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real c_main_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* c_main_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "theta_ground";
    case 1: return "a_third";
    case 2: return "sag_main";
    case 3: return "sag_third";
    case 4: return "zeta_leg";
    case 5: return "z_main";
    case 6: return "z_third";
    case 7: return "a";
    case 8: return "g";
    case 9: return "m";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* c_main_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "c_main";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* c_main_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    case 1: return casadi_s8;
    case 2: return casadi_s8;
    case 3: return casadi_s8;
    case 4: return casadi_s8;
    case 5: return casadi_s8;
    case 6: return casadi_s8;
    case 7: return casadi_s8;
    case 8: return casadi_s8;
    case 9: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* c_main_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int c_main_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int c_main_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* c_third_follows:(theta_ground,a_third,sag_main,sag_third,zeta_leg,z_main,z_third,a,g,m)->(c_third) */
static int casadi_f41(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1, a2, a3, a4, a5, a6;
  a0=arg[7]? arg[7][0] : 0;
  a1=arg[0]? arg[0][0] : 0;
  a2=cos(a1);
  a0=(a0*a2);
  a2=arg[5]? arg[5][0] : 0;
  a3=arg[2]? arg[2][0] : 0;
  a2=(a2-a3);
  a3=sin(a1);
  a2=(a2*a3);
  a0=(a0+a2);
  a2=arg[8]? arg[8][0] : 0;
  a3=(a0*a2);
  a4=arg[9]? arg[9][0] : 0;
  a3=(a3*a4);
  a4=arg[1]? arg[1][0] : 0;
  a5=cos(a1);
  a4=(a4*a5);
  a5=arg[6]? arg[6][0] : 0;
  a6=arg[3]? arg[3][0] : 0;
  a5=(a5-a6);
  a1=sin(a1);
  a5=(a5*a1);
  a4=(a4+a5);
  a0=(a0-a4);
  a3=(a3/a0);
  a3=(2.*a3);
  a0=arg[4]? arg[4][0] : 0;
  a3=(a3*a0);
  a2=sqrt(a2);
  a6=sqrt(a6);
  a2=(a2*a6);
  a3=(a3/a2);
  if (res[0]!=0) res[0][0]=a3;
  return 0;
}

CASADI_SYMBOL_EXPORT int c_third_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f41(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int c_third_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void c_third_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void c_third_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void c_third_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int c_third_follows_n_in(void) { return 10;}

CASADI_SYMBOL_EXPORT casadi_int c_third_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real c_third_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* c_third_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "theta_ground";
    case 1: return "a_third";
    case 2: return "sag_main";
    case 3: return "sag_third";
    case 4: return "zeta_leg";
    case 5: return "z_main";
    case 6: return "z_third";
    case 7: return "a";
    case 8: return "g";
    case 9: return "m";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* c_third_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "c_third";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* c_third_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    case 1: return casadi_s8;
    case 2: return casadi_s8;
    case 3: return casadi_s8;
    case 4: return casadi_s8;
    case 5: return casadi_s8;
    case 6: return casadi_s8;
    case 7: return casadi_s8;
    case 8: return casadi_s8;
    case 9: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* c_third_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int c_third_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int c_third_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* track_follows:(b_wing)->(track) */
static int casadi_f42(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1;
  a0=2.0000000000000001e-01;
  a1=arg[0]? arg[0][0] : 0;
  a0=(a0*a1);
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int track_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f42(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int track_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void track_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void track_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void track_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int track_follows_n_in(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_int track_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real track_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* track_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "b_wing";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* track_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "track";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* track_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* track_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int track_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int track_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* toe_follows:()->(toe) */
static int casadi_f43(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=0.;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int toe_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f43(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int toe_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void toe_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void toe_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void toe_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int toe_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int toe_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real toe_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* toe_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* toe_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "toe";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* toe_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* toe_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int toe_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int toe_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* swivels_follows:()->(swivels) */
static int casadi_f44(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=0.;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int swivels_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f44(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int swivels_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void swivels_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void swivels_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void swivels_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int swivels_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int swivels_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real swivels_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* swivels_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* swivels_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "swivels";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* swivels_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* swivels_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int swivels_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int swivels_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* steering_ratio_follows:(a_third)->(steering_ratio) */
static int casadi_f45(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1, a2;
  a0=arg[0]? arg[0][0] : 0;
  a1=0.;
  a0=(a0<a1);
  a1=-3.4906585039886601e-01;
  a1=(a0?a1:0);
  a0=(!a0);
  a2=1.7453292519943300e-01;
  a0=(a0?a2:0);
  a1=(a1+a0);
  if (res[0]!=0) res[0][0]=a1;
  return 0;
}

CASADI_SYMBOL_EXPORT int steering_ratio_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f45(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int steering_ratio_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void steering_ratio_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void steering_ratio_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void steering_ratio_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int steering_ratio_follows_n_in(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_int steering_ratio_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real steering_ratio_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* steering_ratio_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "a_third";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* steering_ratio_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "steering_ratio";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* steering_ratio_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* steering_ratio_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int steering_ratio_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int steering_ratio_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* k_swivel_follows:()->(k_swivel) */
static int casadi_f46(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=0.;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int k_swivel_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f46(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int k_swivel_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void k_swivel_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void k_swivel_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void k_swivel_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int k_swivel_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int k_swivel_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real k_swivel_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* k_swivel_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* k_swivel_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "k_swivel";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* k_swivel_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* k_swivel_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int k_swivel_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int k_swivel_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* I_swivel_follows:()->(I_swivel) */
static int casadi_f47(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=2.0000000000000000e-02;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int I_swivel_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f47(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int I_swivel_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void I_swivel_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void I_swivel_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void I_swivel_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int I_swivel_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int I_swivel_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real I_swivel_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* I_swivel_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* I_swivel_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "I_swivel";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* I_swivel_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* I_swivel_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int I_swivel_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int I_swivel_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* c_swivel_follows:()->(c_swivel) */
static int casadi_f48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=5.0000000000000000e-01;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int c_swivel_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f48(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int c_swivel_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void c_swivel_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void c_swivel_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void c_swivel_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int c_swivel_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int c_swivel_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real c_swivel_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* c_swivel_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* c_swivel_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "c_swivel";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* c_swivel_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* c_swivel_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int c_swivel_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int c_swivel_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* trail_follows:()->(trail) */
static int casadi_f49(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=5.0000000000000003e-02;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int trail_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f49(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int trail_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void trail_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void trail_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void trail_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int trail_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int trail_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real trail_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* trail_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* trail_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "trail";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* trail_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* trail_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int trail_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int trail_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* break_out_follows:()->(break_out) */
static int casadi_f50(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=5.2359877559829904e-01;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int break_out_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f50(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int break_out_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void break_out_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void break_out_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void break_out_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int break_out_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int break_out_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real break_out_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* break_out_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* break_out_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "break_out";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* break_out_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* break_out_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int break_out_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int break_out_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* stop_follows:()->(stop) */
static int casadi_f51(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=6.2831853071795898e+00;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int stop_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f51(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int stop_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void stop_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void stop_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void stop_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int stop_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int stop_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real stop_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* stop_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* stop_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "stop";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* stop_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* stop_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int stop_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int stop_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* k_stop_follows:()->(k_stop) */
static int casadi_f52(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=0.;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int k_stop_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f52(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int k_stop_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void k_stop_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void k_stop_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void k_stop_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int k_stop_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int k_stop_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real k_stop_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* k_stop_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* k_stop_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "k_stop";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* k_stop_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* k_stop_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int k_stop_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int k_stop_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* surface_left_follows:()->(surface_left) */
static int casadi_f53(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=1.;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int surface_left_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f53(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int surface_left_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void surface_left_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void surface_left_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void surface_left_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int surface_left_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int surface_left_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real surface_left_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* surface_left_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* surface_left_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "surface_left";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* surface_left_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* surface_left_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int surface_left_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int surface_left_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* surface_right_follows:()->(surface_right) */
static int casadi_f54(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=1.;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int surface_right_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f54(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int surface_right_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void surface_right_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void surface_right_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void surface_right_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int surface_right_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int surface_right_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real surface_right_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* surface_right_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* surface_right_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "surface_right";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* surface_right_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* surface_right_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int surface_right_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int surface_right_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* surface_third_follows:()->(surface_third) */
static int casadi_f55(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=1.;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int surface_third_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f55(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int surface_third_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void surface_third_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void surface_third_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void surface_third_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int surface_third_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int surface_third_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real surface_third_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* surface_third_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* surface_third_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "surface_third";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* surface_third_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* surface_third_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int surface_third_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int surface_third_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* mu_roll_left_follows:()->(mu_roll_left) */
static int casadi_f56(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=2.0000000000000000e-02;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int mu_roll_left_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f56(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int mu_roll_left_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void mu_roll_left_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void mu_roll_left_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void mu_roll_left_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int mu_roll_left_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int mu_roll_left_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real mu_roll_left_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* mu_roll_left_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* mu_roll_left_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "mu_roll_left";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* mu_roll_left_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* mu_roll_left_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int mu_roll_left_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int mu_roll_left_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* mu_roll_right_follows:()->(mu_roll_right) */
static int casadi_f57(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=2.0000000000000000e-02;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int mu_roll_right_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f57(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int mu_roll_right_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void mu_roll_right_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void mu_roll_right_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void mu_roll_right_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int mu_roll_right_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int mu_roll_right_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real mu_roll_right_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* mu_roll_right_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* mu_roll_right_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "mu_roll_right";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* mu_roll_right_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* mu_roll_right_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int mu_roll_right_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int mu_roll_right_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* mu_roll_third_follows:()->(mu_roll_third) */
static int casadi_f58(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=2.0000000000000000e-02;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int mu_roll_third_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f58(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int mu_roll_third_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void mu_roll_third_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void mu_roll_third_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void mu_roll_third_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int mu_roll_third_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int mu_roll_third_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real mu_roll_third_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* mu_roll_third_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* mu_roll_third_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "mu_roll_third";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* mu_roll_third_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* mu_roll_third_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int mu_roll_third_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int mu_roll_third_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* B3_third_follows:(B3)->(B3_third) */
static int casadi_f59(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=arg[0]? arg[0][0] : 0;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int B3_third_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f59(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int B3_third_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void B3_third_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void B3_third_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void B3_third_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int B3_third_follows_n_in(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_int B3_third_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real B3_third_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* B3_third_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "B3";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* B3_third_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "B3_third";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* B3_third_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* B3_third_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int B3_third_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int B3_third_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* C3_third_follows:(C3)->(C3_third) */
static int casadi_f60(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=arg[0]? arg[0][0] : 0;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int C3_third_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f60(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int C3_third_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void C3_third_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void C3_third_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void C3_third_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int C3_third_follows_n_in(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_int C3_third_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real C3_third_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* C3_third_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "C3";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* C3_third_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "C3_third";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* C3_third_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* C3_third_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int C3_third_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int C3_third_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* B5_third_follows:(B5)->(B5_third) */
static int casadi_f61(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=arg[0]? arg[0][0] : 0;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int B5_third_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f61(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int B5_third_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void B5_third_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void B5_third_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void B5_third_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int B5_third_follows_n_in(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_int B5_third_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real B5_third_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* B5_third_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "B5";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* B5_third_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "B5_third";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* B5_third_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* B5_third_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int B5_third_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int B5_third_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* C5_third_follows:(C5)->(C5_third) */
static int casadi_f62(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=arg[0]? arg[0][0] : 0;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int C5_third_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f62(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int C5_third_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void C5_third_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void C5_third_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void C5_third_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int C5_third_follows_n_in(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_int C5_third_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real C5_third_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* C5_third_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "C5";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* C5_third_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "C5_third";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* C5_third_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* C5_third_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int C5_third_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int C5_third_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* B1_third_follows:(B1)->(B1_third) */
static int casadi_f63(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=arg[0]? arg[0][0] : 0;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int B1_third_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f63(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int B1_third_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void B1_third_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void B1_third_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void B1_third_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int B1_third_follows_n_in(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_int B1_third_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real B1_third_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* B1_third_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "B1";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* B1_third_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "B1_third";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* B1_third_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* B1_third_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int B1_third_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int B1_third_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* C1_third_follows:(C1)->(C1_third) */
static int casadi_f64(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=arg[0]? arg[0][0] : 0;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int C1_third_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f64(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int C1_third_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void C1_third_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void C1_third_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void C1_third_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int C1_third_follows_n_in(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_int C1_third_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real C1_third_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* C1_third_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "C1";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* C1_third_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "C1_third";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* C1_third_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* C1_third_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int C1_third_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int C1_third_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* D1_third_follows:(D1)->(D1_third) */
static int casadi_f65(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=arg[0]? arg[0][0] : 0;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int D1_third_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f65(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int D1_third_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void D1_third_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void D1_third_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void D1_third_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int D1_third_follows_n_in(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_int D1_third_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real D1_third_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* D1_third_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "D1";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* D1_third_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "D1_third";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* D1_third_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* D1_third_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int D1_third_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int D1_third_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* E1_third_follows:(E1)->(E1_third) */
static int casadi_f66(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=arg[0]? arg[0][0] : 0;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int E1_third_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f66(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int E1_third_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void E1_third_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void E1_third_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void E1_third_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int E1_third_follows_n_in(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_int E1_third_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real E1_third_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* E1_third_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "E1";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* E1_third_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "E1_third";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* E1_third_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* E1_third_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int E1_third_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int E1_third_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* length_follows:(b)->(length) */
static int casadi_f67(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1;
  a0=1.6666666666666667e+00;
  a1=arg[0]? arg[0][0] : 0;
  a0=(a0*a1);
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int length_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f67(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int length_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void length_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void length_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void length_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int length_follows_n_in(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_int length_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real length_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* length_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "b";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* length_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "length";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* length_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* length_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int length_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int length_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* Ixx_follows:(b_wing,m)->(Ixx) */
static int casadi_f68(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1;
  a0=1.5006250000000000e-02;
  a1=arg[0]? arg[0][0] : 0;
  a1=casadi_sq(a1);
  a0=(a0*a1);
  a1=arg[1]? arg[1][0] : 0;
  a0=(a0*a1);
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int Ixx_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f68(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int Ixx_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void Ixx_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void Ixx_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void Ixx_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int Ixx_follows_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int Ixx_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real Ixx_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* Ixx_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "b_wing";
    case 1: return "m";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* Ixx_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "Ixx";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* Ixx_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    case 1: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* Ixx_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int Ixx_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 2;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int Ixx_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 2*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* Iyy_follows:(m,length)->(Iyy) */
static int casadi_f69(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1;
  a0=3.3672250000000001e-02;
  a1=arg[1]? arg[1][0] : 0;
  a1=casadi_sq(a1);
  a0=(a0*a1);
  a1=arg[0]? arg[0][0] : 0;
  a0=(a0*a1);
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int Iyy_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f69(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int Iyy_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void Iyy_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void Iyy_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void Iyy_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int Iyy_follows_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int Iyy_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real Iyy_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* Iyy_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "m";
    case 1: return "length";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* Iyy_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "Iyy";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* Iyy_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    case 1: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* Iyy_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int Iyy_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 2;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int Iyy_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 2*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* Izz_follows:(b_wing,m,length)->(Izz) */
static int casadi_f70(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1, a2, a3;
  a0=arg[1]? arg[1][0] : 0;
  a1=9.8250000000000004e-02;
  a2=arg[0]? arg[0][0] : 0;
  a2=(a1*a2);
  a3=arg[2]? arg[2][0] : 0;
  a1=(a1*a3);
  a2=(a2+a1);
  a2=casadi_sq(a2);
  a0=(a0*a2);
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int Izz_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f70(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int Izz_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void Izz_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void Izz_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void Izz_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int Izz_follows_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int Izz_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real Izz_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* Izz_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "b_wing";
    case 1: return "m";
    case 2: return "length";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* Izz_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "Izz";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* Izz_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    case 1: return casadi_s8;
    case 2: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* Izz_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int Izz_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int Izz_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* Ixz_follows:()->(Ixz) */
static int casadi_f71(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=0.;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int Ixz_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f71(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int Ixz_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void Ixz_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void Ixz_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void Ixz_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int Ixz_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int Ixz_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real Ixz_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* Ixz_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* Ixz_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "Ixz";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* Ixz_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* Ixz_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int Ixz_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int Ixz_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* z_fin_follows:(b)->(z_fin) */
static int casadi_f72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1;
  a0=-1.0000000000000001e-01;
  a1=arg[0]? arg[0][0] : 0;
  a0=(a0*a1);
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int z_fin_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f72(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int z_fin_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void z_fin_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void z_fin_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void z_fin_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int z_fin_follows_n_in(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_int z_fin_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real z_fin_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* z_fin_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "b";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* z_fin_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "z_fin";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* z_fin_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* z_fin_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int z_fin_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int z_fin_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* fin_apart_follows:()->(fin_apart) */
static int casadi_f73(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=1.;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int fin_apart_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f73(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int fin_apart_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void fin_apart_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void fin_apart_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void fin_apart_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int fin_apart_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int fin_apart_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real fin_apart_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* fin_apart_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* fin_apart_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "fin_apart";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* fin_apart_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* fin_apart_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int fin_apart_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int fin_apart_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* tailplane_apart_follows:()->(tailplane_apart) */
static int casadi_f74(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=1.;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int tailplane_apart_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f74(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int tailplane_apart_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void tailplane_apart_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void tailplane_apart_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void tailplane_apart_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int tailplane_apart_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int tailplane_apart_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real tailplane_apart_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* tailplane_apart_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* tailplane_apart_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "tailplane_apart";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* tailplane_apart_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* tailplane_apart_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int tailplane_apart_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int tailplane_apart_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* CL_fin_follows:()->(CL_fin) */
static int casadi_f75(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=1.;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int CL_fin_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f75(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int CL_fin_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void CL_fin_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void CL_fin_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void CL_fin_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int CL_fin_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int CL_fin_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real CL_fin_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* CL_fin_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* CL_fin_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "CL_fin";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* CL_fin_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* CL_fin_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int CL_fin_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int CL_fin_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* tau_rudder_follows:()->(tau_rudder) */
static int casadi_f76(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=5.0000000000000000e-01;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int tau_rudder_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f76(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int tau_rudder_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void tau_rudder_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void tau_rudder_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void tau_rudder_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int tau_rudder_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int tau_rudder_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real tau_rudder_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* tau_rudder_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* tau_rudder_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "tau_rudder";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* tau_rudder_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* tau_rudder_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int tau_rudder_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int tau_rudder_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* rudder_max_follows:()->(rudder_max) */
static int casadi_f77(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=4.3633231299858199e-01;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int rudder_max_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f77(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rudder_max_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rudder_max_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rudder_max_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void rudder_max_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rudder_max_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int rudder_max_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real rudder_max_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rudder_max_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rudder_max_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "rudder_max";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rudder_max_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rudder_max_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rudder_max_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int rudder_max_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* x_h_follows:(b)->(x_h) */
static int casadi_f78(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=arg[0]? arg[0][0] : 0;
  a0=(-a0);
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int x_h_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f78(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int x_h_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void x_h_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void x_h_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void x_h_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int x_h_follows_n_in(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_int x_h_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real x_h_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* x_h_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "b";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* x_h_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "x_h";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* x_h_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* x_h_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int x_h_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int x_h_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* z_h_follows:()->(z_h) */
static int casadi_f79(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=0.;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int z_h_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f79(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int z_h_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void z_h_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void z_h_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void z_h_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int z_h_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int z_h_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real z_h_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* z_h_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* z_h_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "z_h";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* z_h_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* z_h_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int z_h_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int z_h_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* S_h_follows:(S_wing,c_wing,x_h)->(S_h) */
static int casadi_f80(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1;
  a0=-5.0000000000000000e-01;
  a1=arg[0]? arg[0][0] : 0;
  a0=(a0*a1);
  a1=arg[1]? arg[1][0] : 0;
  a0=(a0*a1);
  a1=arg[2]? arg[2][0] : 0;
  a0=(a0/a1);
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int S_h_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f80(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int S_h_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void S_h_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void S_h_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void S_h_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int S_h_follows_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int S_h_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real S_h_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* S_h_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "S_wing";
    case 1: return "c_wing";
    case 2: return "x_h";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* S_h_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "S_h";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* S_h_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    case 1: return casadi_s8;
    case 2: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* S_h_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int S_h_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int S_h_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* CL_h_follows:()->(CL_h) */
static int casadi_f81(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=3.8999999999999999e+00;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int CL_h_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f81(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int CL_h_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void CL_h_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void CL_h_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void CL_h_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int CL_h_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int CL_h_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real CL_h_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* CL_h_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* CL_h_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "CL_h";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* CL_h_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* CL_h_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int CL_h_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int CL_h_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* CL_h_max_follows:()->(CL_h_max) */
static int casadi_f82(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=1.;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int CL_h_max_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f82(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int CL_h_max_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void CL_h_max_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void CL_h_max_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void CL_h_max_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int CL_h_max_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int CL_h_max_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real CL_h_max_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* CL_h_max_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* CL_h_max_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "CL_h_max";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* CL_h_max_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* CL_h_max_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int CL_h_max_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int CL_h_max_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* tau_elevator_follows:()->(tau_elevator) */
static int casadi_f83(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=5.0000000000000000e-01;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int tau_elevator_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f83(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int tau_elevator_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void tau_elevator_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void tau_elevator_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void tau_elevator_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int tau_elevator_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int tau_elevator_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real tau_elevator_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* tau_elevator_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* tau_elevator_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "tau_elevator";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* tau_elevator_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* tau_elevator_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int tau_elevator_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int tau_elevator_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* i_h_follows:()->(i_h) */
static int casadi_f84(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=0.;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int i_h_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f84(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int i_h_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void i_h_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void i_h_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void i_h_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int i_h_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int i_h_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real i_h_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* i_h_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* i_h_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "i_h";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* i_h_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* i_h_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int i_h_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int i_h_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* downwash_follows:(b_wing,S_wing,CL_alpha)->(downwash) */
static int casadi_f85(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1, a2;
  a0=3.1830988618379102e-01;
  a1=arg[2]? arg[2][0] : 0;
  a0=(a0*a1);
  a1=arg[0]? arg[0][0] : 0;
  a1=casadi_sq(a1);
  a2=arg[1]? arg[1][0] : 0;
  a1=(a1/a2);
  a0=(a0/a1);
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int downwash_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f85(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int downwash_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void downwash_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void downwash_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void downwash_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int downwash_follows_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int downwash_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real downwash_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* downwash_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "b_wing";
    case 1: return "S_wing";
    case 2: return "CL_alpha";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* downwash_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "downwash";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* downwash_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    case 1: return casadi_s8;
    case 2: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* downwash_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int downwash_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int downwash_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* z_thrust_follows:()->(z_thrust) */
static int casadi_f86(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=0.;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int z_thrust_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f86(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int z_thrust_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void z_thrust_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void z_thrust_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void z_thrust_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int z_thrust_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int z_thrust_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real z_thrust_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* z_thrust_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* z_thrust_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "z_thrust";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* z_thrust_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* z_thrust_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int z_thrust_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int z_thrust_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* x_propeller_follows:(b)->(x_propeller) */
static int casadi_f87(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1;
  a0=4.0000000000000002e-01;
  a1=arg[0]? arg[0][0] : 0;
  a0=(a0*a1);
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int x_propeller_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f87(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int x_propeller_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void x_propeller_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void x_propeller_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void x_propeller_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int x_propeller_follows_n_in(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_int x_propeller_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real x_propeller_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* x_propeller_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "b";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* x_propeller_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "x_propeller";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* x_propeller_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* x_propeller_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int x_propeller_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int x_propeller_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* propeller_diameter_follows:(h_cg,z_thrust)->(propeller_diameter) */
static int casadi_f88(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1;
  a0=arg[0]? arg[0][0] : 0;
  a0=(2.*a0);
  a1=arg[1]? arg[1][0] : 0;
  a1=(2.*a1);
  a0=(a0-a1);
  a1=4.6000000000000002e-01;
  a0=(a0-a1);
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int propeller_diameter_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f88(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int propeller_diameter_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void propeller_diameter_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void propeller_diameter_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void propeller_diameter_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int propeller_diameter_follows_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int propeller_diameter_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real propeller_diameter_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* propeller_diameter_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "h_cg";
    case 1: return "z_thrust";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* propeller_diameter_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "propeller_diameter";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* propeller_diameter_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    case 1: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* propeller_diameter_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int propeller_diameter_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 2;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int propeller_diameter_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 2*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* A_disc_follows:(propeller_diameter)->(A_disc) */
static int casadi_f89(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1;
  a0=7.8539816339744795e-01;
  a1=arg[0]? arg[0][0] : 0;
  a1=casadi_sq(a1);
  a0=(a0*a1);
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int A_disc_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f89(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int A_disc_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void A_disc_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void A_disc_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void A_disc_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int A_disc_follows_n_in(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_int A_disc_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real A_disc_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* A_disc_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "propeller_diameter";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* A_disc_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "A_disc";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* A_disc_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* A_disc_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int A_disc_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int A_disc_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* x_tip_follows:()->(x_tip) */
static int casadi_f90(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=0.;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int x_tip_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f90(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int x_tip_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void x_tip_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void x_tip_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void x_tip_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int x_tip_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int x_tip_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real x_tip_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* x_tip_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* x_tip_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "x_tip";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* x_tip_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* x_tip_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int x_tip_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int x_tip_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* z_tip_follows:(b_wing)->(z_tip) */
static int casadi_f91(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1;
  a0=-2.5000000000000001e-02;
  a1=arg[0]? arg[0][0] : 0;
  a0=(a0*a1);
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int z_tip_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f91(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int z_tip_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void z_tip_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void z_tip_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void z_tip_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int z_tip_follows_n_in(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_int z_tip_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real z_tip_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* z_tip_follows_name_in(casadi_int i) {
  switch (i) {
    case 0: return "b_wing";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* z_tip_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "z_tip";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* z_tip_follows_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* z_tip_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int z_tip_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int z_tip_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* v_rest_follows:()->(v_rest) */
static int casadi_f92(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=1.0000000000000000e-02;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int v_rest_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f92(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int v_rest_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void v_rest_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void v_rest_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void v_rest_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int v_rest_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int v_rest_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real v_rest_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* v_rest_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* v_rest_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "v_rest";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* v_rest_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* v_rest_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int v_rest_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int v_rest_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* v_stop_follows:()->(v_stop) */
static int casadi_f93(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=1.0000000000000001e-01;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int v_stop_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f93(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int v_stop_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void v_stop_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void v_stop_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void v_stop_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int v_stop_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int v_stop_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real v_stop_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* v_stop_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* v_stop_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "v_stop";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* v_stop_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* v_stop_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int v_stop_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int v_stop_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* runway_width_follows:()->(runway_width) */
static int casadi_f94(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=1.8300000000000001e+01;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int runway_width_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f94(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int runway_width_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void runway_width_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void runway_width_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void runway_width_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int runway_width_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int runway_width_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real runway_width_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* runway_width_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* runway_width_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "runway_width";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* runway_width_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* runway_width_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int runway_width_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int runway_width_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* psi_loop_follows:()->(psi_loop) */
static int casadi_f95(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=1.5707963267949001e+00;
  if (res[0]!=0) res[0][0]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int psi_loop_follows(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f95(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int psi_loop_follows_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void psi_loop_follows_release(int mem) {
}

CASADI_SYMBOL_EXPORT void psi_loop_follows_incref(void) {
}

CASADI_SYMBOL_EXPORT void psi_loop_follows_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int psi_loop_follows_n_in(void) { return 0;}

CASADI_SYMBOL_EXPORT casadi_int psi_loop_follows_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real psi_loop_follows_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* psi_loop_follows_name_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* psi_loop_follows_name_out(casadi_int i) {
  switch (i) {
    case 0: return "psi_loop";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* psi_loop_follows_sparsity_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* psi_loop_follows_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int psi_loop_follows_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int psi_loop_follows_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 0*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


