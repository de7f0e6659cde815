/* Generated from derive/ (digest 2782b10879527e9a) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`. */
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
casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
casadi_real a72, a73, a74, a75, a76;
a00=arg[0]? arg[0][2] : 0;
a01=arg[0]? arg[0][1] : 0;
a02=a00*a01;
a03=0.;
a04=5.0000000000000000e-01;
a05=arg[2]? arg[2][26] : 0;
a06=arg[2]? arg[2][27] : 0;
a05=a05*a06;
a07=arg[2]? arg[2][12] : 0;
a08=1.0000000000000001e-01;
a09=a07+a08;
a10=-a09;
a11=arg[2]? arg[2][11] : 0;
a12=arg[1]? arg[1][3] : 0;
a13=arg[2]? arg[2][10] : 0;
a13=a12*a13;
a14=arg[2]? arg[2][9] : 0;
a13=a13+a14;
a14=1.;
a15=arg[2]? arg[2][8] : 0;
a15=a14-a15;
a16=arg[2]? arg[2][1] : 0;
a17=9.9999999999999995e-07;
a18=1000000.;
a19=arg[0]? arg[0][0] : 0;
a20=arg[1]? arg[1][0] : 0;
a21=arg[0]? arg[0][5] : 0;
a22=cos(a21);
a22=a20*a22;
a23=arg[1]? arg[1][1] : 0;
a24=sin(a21);
a24=a23*a24;
a22=a22+a24;
a24=a19-a22;
a25=casadi_sq(a24);
a25=a25+a17;
a25=sqrt(a25);
a24=a24*a25;
a25=arg[1]? arg[1][2] : 0;
a26=2.*a25;
a27=arg[2]? arg[2][6] : 0;
a28=arg[2]? arg[2][7] : 0;
a29=casadi_sq(a28);
a30=9.9999999999999998e-13;
a29=a29+a30;
a29=sqrt(a29);
a27=a27*a29;
a26=a26/a27;
a24=a24+a26;
a27=a18*a24;
a27=casadi_fmin(a14,a27);
a27=casadi_fmax(a03,a27);
a29=casadi_sq(a27);
a29=a27*a29;
a29=a17*a29;
a31=3.;
a32=casadi_sq(a27);
a32=a31*a32;
a33=8.;
a27=a33*a27;
a32=a32-a27;
a27=6.;
a32=a32+a27;
a29=a29*a32;
a32=-9.9999999999999995e-07;
a24=a32+a24;
a24=casadi_fmax(a03,a24);
a29=a29+a24;
a29=a29+a17;
a24=sqrt(a29);
a24=atan2(a03,a24);
a24=a16+a24;
a15=a15*a24;
a13=a13+a15;
a11=a11*a13;
a09=casadi_fmin(a09,a11);
a10=casadi_fmax(a10,a09);
a09=2.0000000000000001e-01;
a11=-5.;
a13=a11*a07;
a15=5.;
a24=a15*a10;
a13=a13-a24;
a13=a13+a04;
a13=casadi_fmax(a03,a13);
a24=casadi_sq(a13);
a24=a13*a24;
a24=a09*a24;
a13=a04*a13;
a13=a14-a13;
a24=a24*a13;
a24=a10+a24;
a07=a11*a07;
a10=a15*a10;
a07=a07+a10;
a07=a07+a04;
a07=casadi_fmax(a03,a07);
a10=casadi_sq(a07);
a10=a07*a10;
a10=a09*a10;
a07=a04*a07;
a07=a14-a07;
a10=a10*a07;
a24=a24-a10;
a24=a04*a24;
a10=arg[2]? arg[2][13] : 0;
a24=a24*a10;
a24=a24*a28;
a10=arg[2]? arg[2][14] : 0;
a24=a24*a10;
a24=a24*a29;
a05=a05-a24;
a29=arg[2]? arg[2][22] : 0;
a10=a29+a08;
a07=-a10;
a13=arg[2]? arg[2][20] : 0;
a34=arg[2]? arg[2][21] : 0;
a34=a34*a16;
a13=a13+a34;
a10=casadi_fmin(a10,a13);
a07=casadi_fmax(a07,a10);
a10=a11*a29;
a13=a15*a07;
a10=a10-a13;
a10=a10+a04;
a10=casadi_fmax(a03,a10);
a13=casadi_sq(a10);
a13=a10*a13;
a13=a09*a13;
a10=a04*a10;
a10=a14-a10;
a13=a13*a10;
a13=a07+a13;
a29=a11*a29;
a07=a15*a07;
a29=a29+a07;
a29=a29+a04;
a29=casadi_fmax(a03,a29);
a07=casadi_sq(a29);
a07=a29*a07;
a07=a09*a07;
a29=a04*a29;
a29=a14-a29;
a07=a07*a29;
a13=a13-a07;
a07=arg[2]? arg[2][15] : 0;
a29=a04*a07;
a10=a19-a22;
a34=casadi_sq(a10);
a35=1.0000000000000000e-08;
a34=a34+a35;
a35=cos(a21);
a23=a23*a35;
a35=sin(a21);
a20=a20*a35;
a23=a23-a20;
a20=a01-a23;
a35=casadi_sq(a20);
a35=a34+a35;
a29=a29*a35;
a29=a29*a28;
a36=a13*a29;
a36=a36*a10;
a34=sqrt(a34);
a36=a36/a34;
a05=a05-a36;
a36=arg[2]? arg[2][25] : 0;
a37=cos(a16);
a36=a36*a37;
a37=arg[2]? arg[2][30] : 0;
a38=sin(a16);
a37=a37*a38;
a38=a36+a37;
a38=a05*a38;
a39=arg[2]? arg[2][28] : 0;
a40=cos(a16);
a39=a39*a40;
a40=arg[2]? arg[2][29] : 0;
a41=sin(a16);
a40=a40*a41;
a39=a39+a40;
a24=a24*a39;
a39=arg[2]? arg[2][19] : 0;
a39=a39*a29;
a40=arg[2]? arg[2][16] : 0;
a41=arg[2]? arg[2][17] : 0;
a41=a41*a16;
a40=a40+a41;
a41=arg[2]? arg[2][18] : 0;
a41=a41*a12;
a40=a40+a41;
a39=a39*a40;
a24=a24+a39;
a39=arg[2]? arg[2][31] : 0;
a39=a25*a39;
a40=cos(a16);
a39=a39*a40;
a24=a24+a39;
a38=a38+a24;
a38=a04*a38;
a39=arg[2]? arg[2][0] : 0;
a40=cos(a16);
a39=a39*a40;
a40=arg[2]? arg[2][4] : 0;
a41=sin(a16);
a40=a40*a41;
a39=a39+a40;
a40=a36+a37;
a40=a39-a40;
a38=a38/a40;
a38=-a38;
a38=casadi_fmax(a03,a38);
a41=arg[1]? arg[1][4] : 0;
a12=arg[2]? arg[2][36] : 0;
a42=1.0000000000000000e-03;
a43=arg[2]? arg[2][34] : 0;
a44=arg[2]? arg[2][35] : 0;
a45=a44*a38;
a45=a43+a45;
a45=casadi_fmax(a42,a45);
a12=a12*a45;
a45=arg[2]? arg[2][41] : 0;
a46=a12-a45;
a46=a41*a46;
a46=a46+a45;
a46=a46/a12;
a45=5.0000000000000004e-06;
a47=a46+a45;
a48=-a47;
a49=a00*a39;
a49=a49+a01;
a50=arg[2]? arg[2][2] : 0;
a51=sin(a50);
a51=a49*a51;
a52=a04*a00;
a53=arg[2]? arg[2][3] : 0;
a52=a52*a53;
a54=a19+a52;
a55=cos(a50);
a54=a54*a55;
a54=a51+a54;
a55=arg[2]? arg[2][5] : 0;
a56=casadi_sq(a55);
a56=casadi_sq(a56);
a57=casadi_sq(a54);
a58=cos(a50);
a58=a49*a58;
a59=a19+a52;
a60=sin(a50);
a59=a59*a60;
a58=a58-a59;
a59=casadi_sq(a58);
a57=a57+a59;
a57=casadi_sq(a57);
a56=a56+a57;
a56=sqrt(a56);
a57=sqrt(a56);
a59=a54/a57;
a47=casadi_fmin(a47,a59);
a48=casadi_fmax(a48,a47);
a47=1.0000000000000001e-05;
a59=-100000.;
a60=a59*a46;
a61=100000.;
a62=a61*a48;
a60=a60-a62;
a60=a60+a04;
a60=casadi_fmax(a03,a60);
a62=casadi_sq(a60);
a62=a60*a62;
a62=a47*a62;
a60=a04*a60;
a60=a14-a60;
a62=a62*a60;
a62=a48+a62;
a46=a59*a46;
a48=a61*a48;
a46=a46+a48;
a46=a46+a04;
a46=casadi_fmax(a03,a46);
a48=casadi_sq(a46);
a48=a46*a48;
a48=a47*a48;
a46=a04*a46;
a46=a14-a46;
a48=a48*a46;
a62=a62-a48;
a48=casadi_sq(a62);
a48=a14-a48;
a48=sqrt(a48);
a46=a48+a45;
a60=-a46;
a63=2.0000000000000000e-02;
a64=50.;
a65=a64*a41;
a66=arg[2]? arg[2][40] : 0;
a67=arg[2]? arg[2][39] : 0;
a68=arg[2]? arg[2][37] : 0;
a69=arg[2]? arg[2][38] : 0;
a70=a69-a14;
a70=casadi_fmax(a30,a70);
a70=sqrt(a70);
a70=a68*a70;
a70=1./a70;
a71=-a70;
a72=arg[2]? arg[2][32] : 0;
a73=arg[2]? arg[2][33] : 0;
a74=a73*a38;
a74=a72+a74;
a74=casadi_fmax(a03,a74);
a54=casadi_sq(a54);
a75=casadi_sq(a55);
a75=a17*a75;
a54=a54+a75;
a76=sqrt(a54);
a76=a58/a76;
a74=a74*a76;
a74=a74/a12;
a74=casadi_fmin(a74,a70);
a71=casadi_fmax(a71,a74);
a74=a14-a69;
a74=a71*a74;
a71=a68*a71;
a71=atan(a71);
a71=a69*a71;
a71=a71/a68;
a74=a74+a71;
a74=a68*a74;
a74=atan(a74);
a74=a67*a74;
a74=sin(a74);
a74=a66*a74;
a71=casadi_sq(a58);
a71=a71+a54;
a71=sqrt(a71);
a74=a74*a71;
a71=a58*a74;
a71=a71/a56;
a71=a71+a30;
a54=casadi_sq(a58);
a54=a54/a56;
a56=4.9999999999999999e-13;
a54=a54+a56;
a71=a71/a54;
a54=a64*a71;
a65=a65-a54;
a65=casadi_fmin(a14,a65);
a65=casadi_fmax(a03,a65);
a54=casadi_sq(a65);
a54=a65*a54;
a54=a63*a54;
a76=casadi_sq(a65);
a76=a31*a76;
a65=a33*a65;
a76=a76-a65;
a76=a76+a27;
a54=a54*a76;
a41=a41-a71;
a41=a41-a63;
a41=casadi_fmax(a03,a41);
a54=a54+a41;
a58=a58*a54;
a58=a58/a57;
a74=a74/a57;
a58=a58+a74;
a58=casadi_fmin(a58,a46);
a60=casadi_fmax(a60,a58);
a58=a59*a48;
a46=a61*a60;
a58=a58-a46;
a58=a58+a04;
a58=casadi_fmax(a03,a58);
a46=casadi_sq(a58);
a46=a58*a46;
a46=a47*a46;
a58=a04*a58;
a58=a14-a58;
a46=a46*a58;
a46=a60+a46;
a48=a59*a48;
a60=a61*a60;
a48=a48+a60;
a48=a48+a04;
a48=casadi_fmax(a03,a48);
a60=casadi_sq(a48);
a60=a48*a60;
a60=a47*a60;
a48=a04*a48;
a48=a14-a48;
a60=a60*a48;
a46=a46-a60;
a46=a38*a46;
a46=a46*a12;
a60=sin(a50);
a60=a46*a60;
a62=a38*a62;
a62=a62*a12;
a12=cos(a50);
a12=a62*a12;
a60=a60-a12;
a12=arg[1]? arg[1][5] : 0;
a48=arg[2]? arg[2][42] : 0;
a44=a44*a38;
a43=a43+a44;
a43=casadi_fmax(a42,a43);
a48=a48*a43;
a43=arg[2]? arg[2][43] : 0;
a44=a48-a43;
a44=a12*a44;
a44=a44+a43;
a44=a44/a48;
a43=a44+a45;
a58=-a43;
a74=a19-a52;
a57=cos(a50);
a74=a74*a57;
a74=a74-a51;
a51=casadi_sq(a55);
a51=casadi_sq(a51);
a57=casadi_sq(a74);
a54=cos(a50);
a49=a49*a54;
a52=a19-a52;
a54=sin(a50);
a52=a52*a54;
a49=a49+a52;
a52=casadi_sq(a49);
a57=a57+a52;
a57=casadi_sq(a57);
a51=a51+a57;
a51=sqrt(a51);
a57=sqrt(a51);
a52=a74/a57;
a43=casadi_fmin(a43,a52);
a58=casadi_fmax(a58,a43);
a43=a59*a44;
a52=a61*a58;
a43=a43-a52;
a43=a43+a04;
a43=casadi_fmax(a03,a43);
a52=casadi_sq(a43);
a52=a43*a52;
a52=a47*a52;
a43=a04*a43;
a43=a14-a43;
a52=a52*a43;
a52=a58+a52;
a44=a59*a44;
a58=a61*a58;
a44=a44+a58;
a44=a44+a04;
a44=casadi_fmax(a03,a44);
a58=casadi_sq(a44);
a58=a44*a58;
a58=a47*a58;
a44=a04*a44;
a44=a14-a44;
a58=a58*a44;
a52=a52-a58;
a58=a38*a52;
a58=a58*a48;
a44=cos(a50);
a44=a58*a44;
a52=casadi_sq(a52);
a52=a14-a52;
a52=sqrt(a52);
a43=a52+a45;
a54=-a43;
a41=a64*a12;
a71=-a70;
a73=a73*a38;
a72=a72+a73;
a72=casadi_fmax(a03,a72);
a74=casadi_sq(a74);
a74=a74+a75;
a73=sqrt(a74);
a73=a49/a73;
a72=a72*a73;
a72=a72/a48;
a72=casadi_fmin(a72,a70);
a71=casadi_fmax(a71,a72);
a72=a14-a69;
a72=a71*a72;
a71=a68*a71;
a71=atan(a71);
a69=a69*a71;
a69=a69/a68;
a72=a72+a69;
a68=a68*a72;
a68=atan(a68);
a67=a67*a68;
a67=sin(a67);
a66=a66*a67;
a67=casadi_sq(a49);
a67=a67+a74;
a67=sqrt(a67);
a66=a66*a67;
a67=a49*a66;
a67=a67/a51;
a67=a67+a30;
a74=casadi_sq(a49);
a74=a74/a51;
a74=a74+a56;
a67=a67/a74;
a64=a64*a67;
a41=a41-a64;
a41=casadi_fmin(a14,a41);
a41=casadi_fmax(a03,a41);
a64=casadi_sq(a41);
a64=a41*a64;
a64=a63*a64;
a74=casadi_sq(a41);
a74=a31*a74;
a41=a33*a41;
a74=a74-a41;
a74=a74+a27;
a64=a64*a74;
a12=a12-a67;
a12=a12-a63;
a12=casadi_fmax(a03,a12);
a64=a64+a12;
a49=a49*a64;
a49=a49/a57;
a66=a66/a57;
a49=a49+a66;
a49=casadi_fmin(a49,a43);
a54=casadi_fmax(a54,a49);
a49=a59*a52;
a43=a61*a54;
a49=a49-a43;
a49=a49+a04;
a49=casadi_fmax(a03,a49);
a43=casadi_sq(a49);
a43=a49*a43;
a43=a47*a43;
a49=a04*a49;
a49=a14-a49;
a43=a43*a49;
a43=a54+a43;
a52=a59*a52;
a54=a61*a54;
a52=a52+a54;
a52=a52+a04;
a52=casadi_fmax(a03,a52);
a54=casadi_sq(a52);
a54=a52*a54;
a54=a47*a54;
a52=a04*a52;
a52=a14-a52;
a54=a54*a52;
a43=a43-a54;
a38=a38*a43;
a38=a38*a48;
a48=sin(a50);
a48=a38*a48;
a44=a44+a48;
a48=a60-a44;
a05=a05*a39;
a05=a05+a24;
a05=a05/a40;
a05=casadi_fmax(a03,a05);
a40=arg[2]? arg[2][55] : 0;
a24=arg[2]? arg[2][50] : 0;
a43=arg[2]? arg[2][48] : 0;
a54=arg[2]? arg[2][49] : 0;
a54=a54*a05;
a43=a43+a54;
a42=casadi_fmax(a42,a43);
a24=a24*a42;
a40=a40/a24;
a42=a40+a45;
a43=-a42;
a54=arg[1]? arg[1][6] : 0;
a52=arg[2]? arg[2][44] : 0;
a52=a54*a52;
a49=arg[1]? arg[1][7] : 0;
a52=a52+a49;
a49=arg[2]? arg[2][45] : 0;
a66=a14-a49;
a52=a52*a66;
a66=cos(a52);
a66=a19*a66;
a57=a36+a37;
a57=a00*a57;
a57=a57+a01;
a64=sin(a52);
a64=a57*a64;
a66=a66+a64;
a55=casadi_sq(a55);
a55=casadi_sq(a55);
a64=casadi_sq(a66);
a12=cos(a52);
a57=a57*a12;
a12=sin(a52);
a12=a19*a12;
a57=a57-a12;
a12=casadi_sq(a57);
a64=a64+a12;
a64=casadi_sq(a64);
a55=a55+a64;
a55=sqrt(a55);
a55=sqrt(a55);
a64=a66/a55;
a42=casadi_fmin(a42,a64);
a43=casadi_fmax(a43,a42);
a42=a59*a40;
a64=a61*a43;
a42=a42-a64;
a42=a42+a04;
a42=casadi_fmax(a03,a42);
a64=casadi_sq(a42);
a64=a42*a64;
a64=a47*a64;
a42=a04*a42;
a42=a14-a42;
a64=a64*a42;
a64=a43+a64;
a40=a59*a40;
a43=a61*a43;
a40=a40+a43;
a40=a40+a04;
a40=casadi_fmax(a03,a40);
a43=casadi_sq(a40);
a43=a40*a43;
a43=a47*a43;
a40=a04*a40;
a40=a14-a40;
a43=a43*a40;
a64=a64-a43;
a43=casadi_sq(a64);
a43=a14-a43;
a43=sqrt(a43);
a45=a43+a45;
a40=-a45;
a42=arg[2]? arg[2][54] : 0;
a12=arg[2]? arg[2][53] : 0;
a63=arg[2]? arg[2][51] : 0;
a67=arg[2]? arg[2][52] : 0;
a74=a67-a14;
a30=casadi_fmax(a30,a74);
a30=sqrt(a30);
a30=a63*a30;
a30=1./a30;
a74=-a30;
a41=arg[2]? arg[2][46] : 0;
a56=arg[2]? arg[2][47] : 0;
a56=a56*a05;
a41=a41+a56;
a41=casadi_fmax(a03,a41);
a66=casadi_sq(a66);
a66=a66+a75;
a75=sqrt(a66);
a75=a57/a75;
a41=a41*a75;
a41=a41/a24;
a41=casadi_fmin(a41,a30);
a74=casadi_fmax(a74,a41);
a41=a63*a74;
a41=atan(a41);
a41=a67*a41;
a41=a41/a63;
a67=a67-a14;
a74=a74*a67;
a41=a41-a74;
a63=a63*a41;
a63=atan(a63);
a12=a12*a63;
a12=sin(a12);
a42=a42*a12;
a57=casadi_sq(a57);
a57=a57+a66;
a57=sqrt(a57);
a42=a42*a57;
a42=a42/a55;
a42=casadi_fmin(a42,a45);
a40=casadi_fmax(a40,a42);
a42=a59*a43;
a45=a61*a40;
a42=a42-a45;
a42=a42+a04;
a42=casadi_fmax(a03,a42);
a45=casadi_sq(a42);
a45=a42*a45;
a45=a47*a45;
a42=a04*a42;
a42=a14-a42;
a45=a45*a42;
a45=a40+a45;
a59=a59*a43;
a61=a61*a40;
a59=a59+a61;
a59=a59+a04;
a59=casadi_fmax(a03,a59);
a61=casadi_sq(a59);
a61=a59*a61;
a47=a47*a61;
a59=a04*a59;
a59=a14-a59;
a47=a47*a59;
a45=a45-a47;
a45=a05*a45;
a45=a45*a24;
a49=a14-a49;
a45=a45*a49;
a49=sin(a52);
a49=a45*a49;
a05=a05*a64;
a05=a05*a24;
a24=cos(a52);
a24=a05*a24;
a49=a49-a24;
a48=a48+a49;
a48=a48+a25;
a25=arg[2]? arg[2][23] : 0;
a13=casadi_sq(a13);
a49=arg[2]? arg[2][24] : 0;
a13=a13*a49;
a25=a25+a13;
a25=a25*a29;
a25=a25*a10;
a25=a25/a34;
a48=a48-a25;
a48=a48/a06;
a02=a02+a48;
if (res[0]!=0) res[0][0]=a02;
a02=arg[1]? arg[1][10] : 0;
a48=arg[2]? arg[2][73] : 0;
a48=a04*a48;
a25=arg[2]? arg[2][70] : 0;
a08=a25+a08;
a10=-a08;
a13=arg[2]? arg[2][71] : 0;
a49=arg[2]? arg[2][69] : 0;
a24=sin(a16);
a49=a49*a24;
a24=arg[2]? arg[2][68] : 0;
a16=cos(a16);
a24=a24*a16;
a49=a49-a24;
a16=a00*a49;
a16=a16+a01;
a16=a16-a23;
a22=a19-a22;
a23=casadi_sq(a22);
a23=a23+a17;
a23=sqrt(a23);
a22=a22*a23;
a22=a22+a26;
a18=a18*a22;
a18=casadi_fmin(a14,a18);
a18=casadi_fmax(a03,a18);
a26=casadi_sq(a18);
a26=a18*a26;
a26=a17*a26;
a23=casadi_sq(a18);
a31=a31*a23;
a33=a33*a18;
a31=a31-a33;
a31=a31+a27;
a26=a26*a31;
a22=a22+a32;
a22=casadi_fmax(a03,a22);
a26=a26+a22;
a26=a26+a17;
a17=sqrt(a26);
a17=atan2(a16,a17);
a22=arg[1]? arg[1][8] : 0;
a32=arg[2]? arg[2][56] : 0;
a54=a54*a32;
a22=a22-a54;
a54=arg[2]? arg[2][72] : 0;
a54=a22*a54;
a17=a17-a54;
a13=a13*a17;
a08=casadi_fmin(a08,a13);
a10=casadi_fmax(a10,a08);
a08=a11*a25;
a13=a15*a10;
a08=a08-a13;
a08=a08+a04;
a08=casadi_fmax(a03,a08);
a13=casadi_sq(a08);
a13=a08*a13;
a13=a09*a13;
a08=a04*a08;
a08=a14-a08;
a13=a13*a08;
a13=a10+a13;
a11=a11*a25;
a15=a15*a10;
a11=a11+a15;
a11=a11+a04;
a03=casadi_fmax(a03,a11);
a11=casadi_sq(a03);
a11=a03*a11;
a09=a09*a11;
a03=a04*a03;
a14=a14-a03;
a09=a09*a14;
a13=a13-a09;
a48=a48*a13;
a13=arg[2]? arg[2][74] : 0;
a48=a48*a13;
a48=a48*a28;
a16=casadi_sq(a16);
a26=a26+a16;
a48=a48*a26;
a26=a02-a48;
a16=arg[2]? arg[2][58] : 0;
a13=arg[2]? arg[2][60] : 0;
a16=a16*a13;
a09=2.5000000000000000e-01;
a09=a09*a07;
a35=sqrt(a35);
a09=a09*a35;
a09=a09*a00;
a09=a09*a28;
a16=a16*a09;
a28=arg[2]? arg[2][57] : 0;
a20=atan2(a20,a34);
a28=a28*a20;
a34=arg[2]? arg[2][59] : 0;
a34=a34*a22;
a28=a28+a34;
a28=a29*a28;
a16=a16+a28;
a26=a26+a16;
a16=sin(a50);
a62=a62*a16;
a16=cos(a50);
a46=a46*a16;
a62=a62+a46;
a26=a26-a62;
a46=sin(a50);
a58=a58*a46;
a50=cos(a50);
a38=a38*a50;
a58=a58-a38;
a26=a26+a58;
a38=sin(a52);
a05=a05*a38;
a52=cos(a52);
a45=a45*a52;
a05=a05+a45;
a26=a26-a05;
a26=a26/a06;
a06=a00*a19;
a26=a26-a06;
if (res[0]!=0) res[0][1]=a26;
a26=arg[2]? arg[2][66] : 0;
a06=casadi_sq(a13);
a26=a26*a06;
a26=a26*a09;
a13=a13*a29;
a29=arg[2]? arg[2][64] : 0;
a09=arg[1]? arg[1][9] : 0;
a29=a29*a09;
a09=arg[2]? arg[2][65] : 0;
a09=a09*a20;
a29=a29+a09;
a09=arg[2]? arg[2][67] : 0;
a09=a09*a22;
a29=a29+a09;
a13=a13*a29;
a26=a26+a13;
a48=a48*a49;
a02=a02*a24;
a48=a48+a02;
a26=a26-a48;
a60=a04*a60;
a60=a60*a53;
a26=a26+a60;
a04=a04*a44;
a04=a04*a53;
a26=a26+a04;
a62=a62*a39;
a26=a26-a62;
a58=a58*a39;
a26=a26+a58;
a36=a36+a37;
a05=a05*a36;
a26=a26-a05;
a05=arg[2]? arg[2][78] : 0;
a26=a26/a05;
if (res[0]!=0) res[0][2]=a26;
a26=cos(a21);
a26=a19*a26;
a05=sin(a21);
a05=a01*a05;
a26=a26-a05;
if (res[0]!=0) res[0][3]=a26;
a26=sin(a21);
a19=a19*a26;
a21=cos(a21);
a01=a01*a21;
a19=a19+a01;
if (res[0]!=0) res[0][4]=a19;
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
casadi_real a216, a217, a218, a219, a220, a221, a222, a223, a224, a225, a226, a227;
casadi_real a228, a229, a230, a231, a232, a233, a234, a235, a236, a237, a238, a239;
casadi_real a240, a241, a242, a243, a244, a245, a246, a247, a248, a249, a250, a251;
a000=arg[0]? arg[0][1] : 0;
a001=arg[4]? arg[4][2] : 0;
a002=a000*a001;
a003=arg[0]? arg[0][2] : 0;
a004=arg[4]? arg[4][1] : 0;
a005=a003*a004;
a002=a002+a005;
a005=arg[2]? arg[2][2] : 0;
a006=sin(a005);
a007=arg[2]? arg[2][36] : 0;
a008=1.0000000000000000e-03;
a009=arg[2]? arg[2][34] : 0;
a010=arg[2]? arg[2][35] : 0;
a011=0.;
a012=5.0000000000000000e-01;
a013=arg[2]? arg[2][26] : 0;
a014=arg[2]? arg[2][27] : 0;
a015=a013*a014;
a016=arg[2]? arg[2][12] : 0;
a017=1.0000000000000001e-01;
a018=a016+a017;
a019=-a018;
a020=arg[2]? arg[2][11] : 0;
a021=arg[1]? arg[1][3] : 0;
a022=arg[2]? arg[2][10] : 0;
a023=a021*a022;
a024=arg[2]? arg[2][9] : 0;
a023=a023+a024;
a024=1.;
a025=arg[2]? arg[2][8] : 0;
a025=a024-a025;
a026=arg[2]? arg[2][1] : 0;
a027=9.9999999999999995e-07;
a028=1000000.;
a029=arg[0]? arg[0][0] : 0;
a030=arg[1]? arg[1][0] : 0;
a031=arg[0]? arg[0][5] : 0;
a032=cos(a031);
a033=a030*a032;
a034=arg[1]? arg[1][1] : 0;
a035=sin(a031);
a036=a034*a035;
a033=a033+a036;
a036=a029-a033;
a037=casadi_sq(a036);
a037=a037+a027;
a037=sqrt(a037);
a038=a036*a037;
a039=arg[1]? arg[1][2] : 0;
a040=2.*a039;
a041=arg[2]? arg[2][6] : 0;
a042=arg[2]? arg[2][7] : 0;
a043=casadi_sq(a042);
a044=9.9999999999999998e-13;
a043=a043+a044;
a043=sqrt(a043);
a045=a041*a043;
a040=a040/a045;
a038=a038+a040;
a046=a028*a038;
a047=casadi_fmin(a024,a046);
a048=casadi_fmax(a011,a047);
a049=casadi_sq(a048);
a050=a048*a049;
a050=a027*a050;
a051=3.;
a052=casadi_sq(a048);
a052=a051*a052;
a053=8.;
a054=a053*a048;
a052=a052-a054;
a054=6.;
a052=a052+a054;
a055=a050*a052;
a056=-9.9999999999999995e-07;
a038=a056+a038;
a057=casadi_fmax(a011,a038);
a055=a055+a057;
a055=a055+a027;
a057=sqrt(a055);
a057=atan2(a011,a057);
a057=a026+a057;
a058=a025*a057;
a023=a023+a058;
a058=a020*a023;
a059=casadi_fmin(a018,a058);
a060=casadi_fmax(a019,a059);
a061=2.0000000000000001e-01;
a062=-5.;
a063=a062*a016;
a064=5.;
a065=a064*a060;
a063=a063-a065;
a063=a063+a012;
a065=casadi_fmax(a011,a063);
a066=casadi_sq(a065);
a067=a065*a066;
a067=a061*a067;
a068=a012*a065;
a068=a024-a068;
a069=a067*a068;
a069=a060+a069;
a016=a062*a016;
a060=a064*a060;
a016=a016+a060;
a016=a016+a012;
a060=casadi_fmax(a011,a016);
a070=casadi_sq(a060);
a071=a060*a070;
a071=a061*a071;
a072=a012*a060;
a072=a024-a072;
a073=a071*a072;
a069=a069-a073;
a069=a012*a069;
a073=arg[2]? arg[2][13] : 0;
a074=a069*a073;
a075=a074*a042;
a076=arg[2]? arg[2][14] : 0;
a077=a075*a076;
a078=a077*a055;
a015=a015-a078;
a079=arg[2]? arg[2][22] : 0;
a080=a079+a017;
a081=-a080;
a082=arg[2]? arg[2][20] : 0;
a083=arg[2]? arg[2][21] : 0;
a084=a083*a026;
a082=a082+a084;
a084=casadi_fmin(a080,a082);
a085=casadi_fmax(a081,a084);
a086=a062*a079;
a087=a064*a085;
a086=a086-a087;
a086=a086+a012;
a087=casadi_fmax(a011,a086);
a088=casadi_sq(a087);
a089=a087*a088;
a089=a061*a089;
a090=a012*a087;
a090=a024-a090;
a091=a089*a090;
a091=a085+a091;
a079=a062*a079;
a085=a064*a085;
a079=a079+a085;
a079=a079+a012;
a085=casadi_fmax(a011,a079);
a092=casadi_sq(a085);
a093=a085*a092;
a093=a061*a093;
a094=a012*a085;
a094=a024-a094;
a095=a093*a094;
a091=a091-a095;
a095=arg[2]? arg[2][15] : 0;
a096=a012*a095;
a097=a029-a033;
a098=casadi_sq(a097);
a099=1.0000000000000000e-08;
a098=a098+a099;
a099=cos(a031);
a100=a034*a099;
a101=sin(a031);
a102=a030*a101;
a100=a100-a102;
a102=a000-a100;
a103=casadi_sq(a102);
a103=a098+a103;
a104=a096*a103;
a105=a104*a042;
a106=a091*a105;
a107=a106*a097;
a108=sqrt(a098);
a107=a107/a108;
a015=a015-a107;
a109=arg[2]? arg[2][25] : 0;
a110=cos(a026);
a111=a109*a110;
a112=arg[2]? arg[2][30] : 0;
a113=sin(a026);
a114=a112*a113;
a115=a111+a114;
a116=a015*a115;
a117=arg[2]? arg[2][28] : 0;
a118=cos(a026);
a119=a117*a118;
a120=arg[2]? arg[2][29] : 0;
a121=sin(a026);
a122=a120*a121;
a119=a119+a122;
a122=a078*a119;
a123=arg[2]? arg[2][19] : 0;
a124=a123*a105;
a125=arg[2]? arg[2][16] : 0;
a126=arg[2]? arg[2][17] : 0;
a127=a126*a026;
a125=a125+a127;
a127=arg[2]? arg[2][18] : 0;
a128=a127*a021;
a125=a125+a128;
a128=a124*a125;
a122=a122+a128;
a128=arg[2]? arg[2][31] : 0;
a129=a039*a128;
a130=cos(a026);
a131=a129*a130;
a122=a122+a131;
a116=a116+a122;
a116=a012*a116;
a131=arg[2]? arg[2][0] : 0;
a132=cos(a026);
a133=a131*a132;
a134=arg[2]? arg[2][4] : 0;
a135=sin(a026);
a136=a134*a135;
a133=a133+a136;
a136=a111+a114;
a136=a133-a136;
a116=a116/a136;
a137=-a116;
a138=casadi_fmax(a011,a137);
a139=a010*a138;
a139=a009+a139;
a140=casadi_fmax(a008,a139);
a141=a007*a140;
a142=a003*a133;
a142=a142+a000;
a143=cos(a005);
a144=a142*a143;
a145=a012*a003;
a146=arg[2]? arg[2][3] : 0;
a147=a145*a146;
a148=a029+a147;
a149=sin(a005);
a150=a148*a149;
a144=a144-a150;
a150=2.0000000000000000e-02;
a151=50.;
a152=arg[1]? arg[1][4] : 0;
a153=a151*a152;
a154=arg[2]? arg[2][40] : 0;
a155=arg[2]? arg[2][39] : 0;
a156=arg[2]? arg[2][37] : 0;
a157=arg[2]? arg[2][38] : 0;
a158=a157-a024;
a159=casadi_fmax(a044,a158);
a159=sqrt(a159);
a160=a156*a159;
a161=1./a160;
a162=-a161;
a163=arg[2]? arg[2][32] : 0;
a164=arg[2]? arg[2][33] : 0;
a165=a164*a138;
a165=a163+a165;
a166=casadi_fmax(a011,a165);
a167=sin(a005);
a168=a142*a167;
a169=a029+a147;
a170=cos(a005);
a171=a169*a170;
a171=a168+a171;
a172=casadi_sq(a171);
a173=arg[2]? arg[2][5] : 0;
a174=casadi_sq(a173);
a174=a027*a174;
a172=a172+a174;
a175=sqrt(a172);
a176=a144/a175;
a177=a166*a176;
a177=a177/a141;
a178=casadi_fmin(a177,a161);
a179=casadi_fmax(a162,a178);
a180=a024-a157;
a181=a179*a180;
a182=a156*a179;
a183=atan(a182);
a184=a157*a183;
a184=a184/a156;
a181=a181+a184;
a185=a156*a181;
a186=atan(a185);
a187=a155*a186;
a188=sin(a187);
a189=a154*a188;
a190=casadi_sq(a144);
a190=a190+a172;
a190=sqrt(a190);
a172=a189*a190;
a191=a144*a172;
a192=casadi_sq(a173);
a193=casadi_sq(a192);
a194=casadi_sq(a171);
a195=casadi_sq(a144);
a194=a194+a195;
a195=casadi_sq(a194);
a193=a193+a195;
a193=sqrt(a193);
a191=a191/a193;
a195=a191+a044;
a196=casadi_sq(a144);
a196=a196/a193;
a197=4.9999999999999999e-13;
a198=a196+a197;
a195=a195/a198;
a199=a151*a195;
a153=a153-a199;
a199=casadi_fmin(a024,a153);
a200=casadi_fmax(a011,a199);
a201=casadi_sq(a200);
a202=a200*a201;
a202=a150*a202;
a203=casadi_sq(a200);
a203=a051*a203;
a204=a053*a200;
a203=a203-a204;
a203=a203+a054;
a204=a202*a203;
a205=a152-a195;
a205=a205-a150;
a206=casadi_fmax(a011,a205);
a204=a204+a206;
a206=a144*a204;
a207=sqrt(a193);
a206=a206/a207;
a208=a172/a207;
a209=a206+a208;
a210=arg[2]? arg[2][41] : 0;
a211=a141-a210;
a212=a152*a211;
a212=a212+a210;
a212=a212/a141;
a210=5.0000000000000004e-06;
a213=a212+a210;
a214=-a213;
a215=a171/a207;
a216=casadi_fmin(a213,a215);
a217=casadi_fmax(a214,a216);
a218=1.0000000000000001e-05;
a219=-100000.;
a220=a219*a212;
a221=100000.;
a222=a221*a217;
a220=a220-a222;
a220=a220+a012;
a222=casadi_fmax(a011,a220);
a223=casadi_sq(a222);
a224=a222*a223;
a224=a218*a224;
a225=a012*a222;
a225=a024-a225;
a226=a224*a225;
a226=a217+a226;
a227=a219*a212;
a217=a221*a217;
a227=a227+a217;
a227=a227+a012;
a217=casadi_fmax(a011,a227);
a228=casadi_sq(a217);
a229=a217*a228;
a229=a218*a229;
a230=a012*a217;
a230=a024-a230;
a231=a229*a230;
a226=a226-a231;
a231=casadi_sq(a226);
a231=a024-a231;
a231=sqrt(a231);
a232=a231+a210;
a233=casadi_fmin(a209,a232);
a234=-a232;
a235=a233<=a234;
a236=a234<=a233;
a237=a235+a236;
a235=a235/a237;
a238=2.*a226;
a239=a214<=a216;
a216=a216<=a214;
a214=a216+a239;
a239=a239/a214;
a240=a213<=a215;
a213=a215<=a213;
a241=a240+a213;
a240=a240/a241;
a242=arg[5]? arg[5][4] : 0;
a211=a211*a242;
a243=arg[6]? arg[6][36] : 0;
a140=a140*a243;
a243=a008<=a139;
a139=a139<=a008;
a139=a139+a243;
a243=a243/a139;
a139=arg[6]? arg[6][34] : 0;
a244=arg[6]? arg[6][35] : 0;
a245=a138*a244;
a246=a011<=a137;
a137=a137<=a011;
a137=a137+a246;
a246=a246/a137;
a137=arg[6]? arg[6][26] : 0;
a137=a014*a137;
a247=arg[6]? arg[6][27] : 0;
a013=a013*a247;
a137=a137+a013;
a013=a019<=a059;
a059=a059<=a019;
a019=a059+a013;
a013=a013/a019;
a248=a018<=a058;
a058=a058<=a018;
a018=a248+a058;
a248=a248/a018;
a249=arg[6]? arg[6][12] : 0;
a248=a248*a249;
a058=a058/a018;
a018=arg[6]? arg[6][11] : 0;
a023=a023*a018;
a018=arg[5]? arg[5][3] : 0;
a022=a022*a018;
a250=arg[6]? arg[6][10] : 0;
a250=a021*a250;
a022=a022+a250;
a250=arg[6]? arg[6][9] : 0;
a022=a022+a250;
a250=arg[6]? arg[6][1] : 0;
a025=a025*a250;
a251=arg[6]? arg[6][8] : 0;
a057=a057*a251;
a025=a025-a057;
a022=a022+a025;
a020=a020*a022;
a023=a023+a020;
a058=a058*a023;
a248=a248+a058;
a013=a013*a248;
a059=a059/a019;
a059=a059*a249;
a013=a013-a059;
a059=a011<=a063;
a063=a063<=a011;
a063=a063+a059;
a059=a059/a063;
a063=a062*a249;
a019=a064*a013;
a063=a063-a019;
a059=a059*a063;
a066=a066*a059;
a063=2.*a065;
a063=a063*a059;
a065=a065*a063;
a066=a066+a065;
a066=a061*a066;
a068=a068*a066;
a059=a012*a059;
a067=a067*a059;
a068=a068-a067;
a068=a013+a068;
a067=a011<=a016;
a016=a016<=a011;
a016=a016+a067;
a067=a067/a016;
a249=a062*a249;
a013=a064*a013;
a249=a249+a013;
a067=a067*a249;
a070=a070*a067;
a249=2.*a060;
a249=a249*a067;
a060=a060*a249;
a070=a070+a060;
a070=a061*a070;
a072=a072*a070;
a067=a012*a067;
a071=a071*a067;
a072=a072-a071;
a068=a068-a072;
a068=a012*a068;
a073=a073*a068;
a068=arg[6]? arg[6][13] : 0;
a069=a069*a068;
a073=a073+a069;
a073=a042*a073;
a069=arg[6]? arg[6][7] : 0;
a074=a074*a069;
a073=a073+a074;
a076=a076*a073;
a073=arg[6]? arg[6][14] : 0;
a075=a075*a073;
a076=a076+a075;
a055=a055*a076;
a076=a011<=a047;
a047=a047<=a011;
a047=a047+a076;
a076=a076/a047;
a047=a046<=a024;
a046=a024<=a046;
a046=a046+a047;
a047=a047/a046;
a046=arg[4]? arg[4][0] : 0;
a075=arg[5]? arg[5][0] : 0;
a032=a032*a075;
a073=sin(a031);
a074=arg[4]? arg[4][5] : 0;
a073=a073*a074;
a073=a030*a073;
a032=a032-a073;
a073=arg[5]? arg[5][1] : 0;
a035=a035*a073;
a068=cos(a031);
a068=a068*a074;
a068=a034*a068;
a035=a035+a068;
a032=a032+a035;
a035=a046-a032;
a068=a037*a035;
a072=2.*a036;
a072=a072*a035;
a037=2.*a037;
a072=a072/a037;
a036=a036*a072;
a068=a068+a036;
a036=arg[5]? arg[5][2] : 0;
a072=2.*a036;
a072=a072/a045;
a045=a040/a045;
a037=arg[6]? arg[6][6] : 0;
a037=a043*a037;
a035=2.*a042;
a035=a035*a069;
a043=2.*a043;
a035=a035/a043;
a041=a041*a035;
a037=a037+a041;
a045=a045*a037;
a072=a072-a045;
a068=a068+a072;
a045=a028*a068;
a047=a047*a045;
a076=a076*a047;
a049=a049*a076;
a047=2.*a048;
a047=a047*a076;
a047=a048*a047;
a049=a049+a047;
a049=a027*a049;
a052=a052*a049;
a048=2.*a048;
a048=a048*a076;
a048=a051*a048;
a076=a053*a076;
a048=a048-a076;
a050=a050*a048;
a052=a052+a050;
a050=a011<=a038;
a038=a038<=a011;
a038=a038+a050;
a050=a050/a038;
a050=a050*a068;
a052=a052+a050;
a077=a077*a052;
a055=a055+a077;
a137=a137-a055;
a077=a081<=a084;
a084=a084<=a081;
a081=a084+a077;
a077=a077/a081;
a052=a080<=a082;
a082=a082<=a080;
a080=a052+a082;
a052=a052/a080;
a050=arg[6]? arg[6][22] : 0;
a052=a052*a050;
a082=a082/a080;
a080=arg[6]? arg[6][20] : 0;
a068=arg[6]? arg[6][21] : 0;
a068=a026*a068;
a083=a083*a250;
a068=a068+a083;
a080=a080+a068;
a082=a082*a080;
a052=a052+a082;
a077=a077*a052;
a084=a084/a081;
a084=a084*a050;
a077=a077-a084;
a084=a011<=a086;
a086=a086<=a011;
a086=a086+a084;
a084=a084/a086;
a086=a062*a050;
a081=a064*a077;
a086=a086-a081;
a084=a084*a086;
a088=a088*a084;
a086=2.*a087;
a086=a086*a084;
a087=a087*a086;
a088=a088+a087;
a088=a061*a088;
a090=a090*a088;
a084=a012*a084;
a089=a089*a084;
a090=a090-a089;
a090=a077+a090;
a089=a011<=a079;
a079=a079<=a011;
a079=a079+a089;
a089=a089/a079;
a050=a062*a050;
a077=a064*a077;
a050=a050+a077;
a089=a089*a050;
a092=a092*a089;
a050=2.*a085;
a050=a050*a089;
a085=a085*a050;
a092=a092+a085;
a092=a061*a092;
a094=a094*a092;
a089=a012*a089;
a093=a093*a089;
a094=a094-a093;
a090=a090-a094;
a094=a105*a090;
a093=arg[6]? arg[6][15] : 0;
a089=a012*a093;
a089=a103*a089;
a092=2.*a097;
a085=a046-a032;
a092=a092*a085;
a050=2.*a102;
a099=a099*a073;
a073=sin(a031);
a073=a073*a074;
a034=a034*a073;
a099=a099-a034;
a101=a101*a075;
a075=cos(a031);
a075=a075*a074;
a030=a030*a075;
a101=a101+a030;
a099=a099-a101;
a101=a004-a099;
a050=a050*a101;
a050=a092+a050;
a096=a096*a050;
a089=a089+a096;
a089=a042*a089;
a104=a104*a069;
a089=a089+a104;
a104=a091*a089;
a094=a094+a104;
a094=a097*a094;
a106=a106*a085;
a094=a094+a106;
a094=a094/a108;
a107=a107/a108;
a106=2.*a108;
a092=a092/a106;
a107=a107*a092;
a094=a094-a107;
a137=a137-a094;
a115=a115*a137;
a094=arg[6]? arg[6][25] : 0;
a110=a110*a094;
a094=sin(a026);
a094=a094*a250;
a109=a109*a094;
a110=a110-a109;
a109=arg[6]? arg[6][30] : 0;
a113=a113*a109;
a109=cos(a026);
a109=a109*a250;
a112=a112*a109;
a113=a113+a112;
a112=a110+a113;
a112=a015*a112;
a115=a115+a112;
a119=a119*a055;
a055=arg[6]? arg[6][28] : 0;
a118=a118*a055;
a055=sin(a026);
a055=a055*a250;
a117=a117*a055;
a118=a118-a117;
a117=arg[6]? arg[6][29] : 0;
a121=a121*a117;
a117=cos(a026);
a117=a117*a250;
a120=a120*a117;
a121=a121+a120;
a118=a118+a121;
a078=a078*a118;
a119=a119+a078;
a078=arg[6]? arg[6][19] : 0;
a078=a105*a078;
a123=a123*a089;
a078=a078+a123;
a125=a125*a078;
a078=arg[6]? arg[6][16] : 0;
a123=arg[6]? arg[6][17] : 0;
a123=a026*a123;
a126=a126*a250;
a123=a123+a126;
a078=a078+a123;
a123=arg[6]? arg[6][18] : 0;
a021=a021*a123;
a127=a127*a018;
a021=a021+a127;
a078=a078+a021;
a124=a124*a078;
a125=a125+a124;
a119=a119+a125;
a128=a128*a036;
a125=arg[6]? arg[6][31] : 0;
a125=a039*a125;
a128=a128+a125;
a130=a130*a128;
a128=sin(a026);
a128=a128*a250;
a129=a129*a128;
a130=a130-a129;
a119=a119+a130;
a115=a115+a119;
a115=a012*a115;
a115=a115/a136;
a116=a116/a136;
a130=arg[6]? arg[6][0] : 0;
a132=a132*a130;
a130=sin(a026);
a130=a130*a250;
a131=a131*a130;
a132=a132-a131;
a131=arg[6]? arg[6][4] : 0;
a135=a135*a131;
a131=cos(a026);
a131=a131*a250;
a134=a134*a131;
a135=a135+a134;
a132=a132+a135;
a135=a110+a113;
a135=a132-a135;
a116=a116*a135;
a115=a115-a116;
a246=a246*a115;
a115=a010*a246;
a245=a245-a115;
a245=a139+a245;
a243=a243*a245;
a007=a007*a243;
a140=a140+a007;
a007=arg[6]? arg[6][41] : 0;
a243=a140-a007;
a152=a152*a243;
a211=a211+a152;
a211=a211+a007;
a211=a211/a141;
a212=a212/a141;
a212=a212*a140;
a211=a211-a212;
a240=a240*a211;
a213=a213/a241;
a241=a133*a001;
a212=a003*a132;
a241=a241+a212;
a241=a241+a004;
a167=a167*a241;
a212=cos(a005);
a007=arg[6]? arg[6][2] : 0;
a212=a212*a007;
a212=a142*a212;
a167=a167+a212;
a212=a012*a001;
a212=a146*a212;
a152=arg[6]? arg[6][3] : 0;
a145=a145*a152;
a212=a212+a145;
a145=a046+a212;
a170=a170*a145;
a145=sin(a005);
a145=a145*a007;
a169=a169*a145;
a170=a170-a169;
a170=a167+a170;
a169=a170/a207;
a215=a215/a207;
a192=2.*a192;
a145=2.*a173;
a243=arg[6]? arg[6][5] : 0;
a145=a145*a243;
a192=a192*a145;
a194=2.*a194;
a145=2.*a171;
a145=a145*a170;
a245=2.*a144;
a143=a143*a241;
a115=sin(a005);
a115=a115*a007;
a115=a142*a115;
a143=a143-a115;
a115=a046+a212;
a149=a149*a115;
a115=cos(a005);
a115=a115*a007;
a148=a148*a115;
a149=a149+a148;
a143=a143-a149;
a245=a245*a143;
a145=a145+a245;
a194=a194*a145;
a192=a192+a194;
a194=2.*a193;
a192=a192/a194;
a194=2.*a207;
a194=a192/a194;
a215=a215*a194;
a169=a169-a215;
a213=a213*a169;
a240=a240+a213;
a239=a239*a240;
a216=a216/a214;
a216=a216*a211;
a239=a239-a216;
a216=a011<=a220;
a220=a220<=a011;
a220=a220+a216;
a216=a216/a220;
a220=a219*a211;
a214=a221*a239;
a220=a220-a214;
a216=a216*a220;
a223=a223*a216;
a220=2.*a222;
a220=a220*a216;
a222=a222*a220;
a223=a223+a222;
a223=a218*a223;
a225=a225*a223;
a216=a012*a216;
a224=a224*a216;
a225=a225-a224;
a225=a239+a225;
a224=a011<=a227;
a227=a227<=a011;
a227=a227+a224;
a224=a224/a227;
a211=a219*a211;
a239=a221*a239;
a211=a211+a239;
a224=a224*a211;
a228=a228*a224;
a211=2.*a217;
a211=a211*a224;
a217=a217*a211;
a228=a228+a217;
a228=a218*a228;
a230=a230*a228;
a224=a012*a224;
a229=a229*a224;
a230=a230-a229;
a225=a225-a230;
a238=a238*a225;
a230=2.*a231;
a238=a238/a230;
a235=a235*a238;
a236=a236/a237;
a237=a209<=a232;
a232=a232<=a209;
a209=a237+a232;
a237=a237/a209;
a204=a204*a143;
a230=a011<=a199;
a199=a199<=a011;
a199=a199+a230;
a230=a230/a199;
a199=a153<=a024;
a153=a024<=a153;
a153=a153+a199;
a199=a199/a153;
a153=a151*a242;
a172=a172*a143;
a229=arg[6]? arg[6][40] : 0;
a188=a188*a229;
a187=cos(a187);
a224=arg[6]? arg[6][39] : 0;
a186=a186*a224;
a228=arg[6]? arg[6][37] : 0;
a181=a181*a228;
a217=a178<=a162;
a162=a162<=a178;
a178=a217+a162;
a217=a217/a178;
a160=a161/a160;
a211=a159*a228;
a239=a044<=a158;
a158=a158<=a044;
a158=a158+a239;
a239=a239/a158;
a158=arg[6]? arg[6][38] : 0;
a239=a239*a158;
a159=2.*a159;
a239=a239/a159;
a239=a156*a239;
a211=a211+a239;
a160=a160*a211;
a217=a217*a160;
a162=a162/a178;
a178=a177<=a161;
a211=a161<=a177;
a239=a178+a211;
a178=a178/a239;
a159=a011<=a165;
a165=a165<=a011;
a165=a165+a159;
a159=a159/a165;
a165=arg[6]? arg[6][32] : 0;
a227=arg[6]? arg[6][33] : 0;
a216=a138*a227;
a223=a164*a246;
a216=a216-a223;
a216=a165+a216;
a159=a159*a216;
a159=a176*a159;
a216=a143/a175;
a176=a176/a175;
a171=2.*a171;
a171=a171*a170;
a170=2.*a173;
a170=a170*a243;
a170=a027*a170;
a171=a171+a170;
a175=2.*a175;
a175=a171/a175;
a176=a176*a175;
a216=a216-a176;
a166=a166*a216;
a159=a159+a166;
a159=a159/a141;
a177=a177/a141;
a177=a177*a140;
a159=a159-a177;
a178=a178*a159;
a211=a211/a239;
a211=a211*a160;
a178=a178-a211;
a162=a162*a178;
a217=a217+a162;
a180=a180*a217;
a162=a179*a158;
a180=a180-a162;
a183=a183*a158;
a179=a179*a228;
a217=a156*a217;
a179=a179+a217;
a182=casadi_sq(a182);
a182=a024+a182;
a179=a179/a182;
a179=a157*a179;
a183=a183+a179;
a183=a183/a156;
a184=a184/a156;
a184=a184*a228;
a183=a183-a184;
a180=a180+a183;
a180=a156*a180;
a181=a181+a180;
a185=casadi_sq(a185);
a185=a024+a185;
a181=a181/a185;
a181=a155*a181;
a186=a186+a181;
a187=a187*a186;
a187=a154*a187;
a188=a188+a187;
a188=a190*a188;
a187=2.*a144;
a187=a187*a143;
a187=a187+a171;
a190=2.*a190;
a187=a187/a190;
a189=a189*a187;
a188=a188+a189;
a189=a144*a188;
a172=a172+a189;
a172=a172/a193;
a191=a191/a193;
a191=a191*a192;
a172=a172-a191;
a172=a172/a198;
a195=a195/a198;
a198=2.*a144;
a198=a198*a143;
a198=a198/a193;
a196=a196/a193;
a196=a196*a192;
a198=a198-a196;
a195=a195*a198;
a172=a172-a195;
a195=a151*a172;
a153=a153-a195;
a199=a199*a153;
a230=a230*a199;
a201=a201*a230;
a199=2.*a200;
a199=a199*a230;
a199=a200*a199;
a201=a201+a199;
a201=a150*a201;
a203=a203*a201;
a200=2.*a200;
a200=a200*a230;
a200=a051*a200;
a230=a053*a230;
a200=a200-a230;
a202=a202*a200;
a203=a203+a202;
a202=a011<=a205;
a205=a205<=a011;
a205=a205+a202;
a202=a202/a205;
a242=a242-a172;
a202=a202*a242;
a203=a203+a202;
a144=a144*a203;
a204=a204+a144;
a204=a204/a207;
a206=a206/a207;
a206=a206*a194;
a204=a204-a206;
a188=a188/a207;
a208=a208/a207;
a208=a208*a194;
a188=a188-a208;
a204=a204+a188;
a237=a237*a204;
a232=a232/a209;
a232=a232*a238;
a237=a237-a232;
a236=a236*a237;
a235=a235+a236;
a236=a219*a231;
a234=casadi_fmax(a234,a233);
a233=a221*a234;
a236=a236-a233;
a236=a236+a012;
a233=casadi_fmax(a011,a236);
a237=casadi_sq(a233);
a232=a233*a237;
a232=a218*a232;
a209=a011<=a236;
a236=a236<=a011;
a236=a236+a209;
a209=a209/a236;
a236=a219*a238;
a204=a221*a235;
a236=a236+a204;
a209=a209*a236;
a236=a012*a209;
a236=a232*a236;
a204=a012*a233;
a204=a024-a204;
a237=a237*a209;
a188=2.*a233;
a188=a188*a209;
a233=a233*a188;
a237=a237+a233;
a237=a218*a237;
a237=a204*a237;
a236=a236-a237;
a236=a235+a236;
a231=a219*a231;
a237=a221*a234;
a231=a231+a237;
a231=a231+a012;
a237=casadi_fmax(a011,a231);
a233=a012*a237;
a233=a024-a233;
a188=casadi_sq(a237);
a209=a011<=a231;
a231=a231<=a011;
a231=a231+a209;
a209=a209/a231;
a235=a221*a235;
a238=a219*a238;
a235=a235-a238;
a209=a209*a235;
a235=a188*a209;
a238=2.*a237;
a238=a238*a209;
a238=a237*a238;
a235=a235+a238;
a235=a218*a235;
a235=a233*a235;
a237=a237*a188;
a237=a218*a237;
a209=a012*a209;
a209=a237*a209;
a235=a235-a209;
a236=a236-a235;
a236=a138*a236;
a232=a232*a204;
a234=a234+a232;
a237=a237*a233;
a234=a234-a237;
a237=a234*a246;
a236=a236-a237;
a236=a141*a236;
a234=a138*a234;
a237=a234*a140;
a236=a236+a237;
a237=a006*a236;
a234=a234*a141;
a233=cos(a005);
a233=a233*a007;
a233=a234*a233;
a237=a237+a233;
a233=cos(a005);
a225=a138*a225;
a232=a226*a246;
a225=a225-a232;
a225=a141*a225;
a226=a138*a226;
a140=a226*a140;
a225=a225+a140;
a140=a233*a225;
a226=a226*a141;
a141=sin(a005);
a141=a141*a007;
a141=a226*a141;
a140=a140-a141;
a237=a237-a140;
a140=cos(a005);
a141=arg[2]? arg[2][42] : 0;
a232=a010*a138;
a009=a009+a232;
a232=casadi_fmax(a008,a009);
a204=a141*a232;
a235=arg[1]? arg[1][5] : 0;
a209=arg[2]? arg[2][43] : 0;
a188=a204-a209;
a238=a235*a188;
a238=a238+a209;
a238=a238/a204;
a209=a238+a210;
a231=-a209;
a208=a029-a147;
a194=cos(a005);
a207=a208*a194;
a207=a207-a168;
a168=casadi_sq(a173);
a206=casadi_sq(a168);
a144=casadi_sq(a207);
a203=cos(a005);
a202=a142*a203;
a147=a029-a147;
a242=sin(a005);
a172=a147*a242;
a202=a202+a172;
a172=casadi_sq(a202);
a144=a144+a172;
a172=casadi_sq(a144);
a206=a206+a172;
a206=sqrt(a206);
a172=sqrt(a206);
a205=a207/a172;
a200=casadi_fmin(a209,a205);
a230=a231<=a200;
a201=a200<=a231;
a199=a201+a230;
a230=a230/a199;
a153=a209<=a205;
a209=a205<=a209;
a195=a153+a209;
a153=a153/a195;
a198=arg[5]? arg[5][5] : 0;
a188=a188*a198;
a196=arg[6]? arg[6][42] : 0;
a232=a232*a196;
a196=a008<=a009;
a009=a009<=a008;
a009=a009+a196;
a196=a196/a009;
a244=a138*a244;
a010=a010*a246;
a244=a244-a010;
a139=a139+a244;
a196=a196*a139;
a141=a141*a196;
a232=a232+a141;
a141=arg[6]? arg[6][43] : 0;
a196=a232-a141;
a196=a235*a196;
a188=a188+a196;
a188=a188+a141;
a188=a188/a204;
a141=a238/a204;
a141=a141*a232;
a188=a188-a141;
a153=a153*a188;
a209=a209/a195;
a195=a046-a212;
a194=a194*a195;
a195=sin(a005);
a195=a195*a007;
a208=a208*a195;
a194=a194-a208;
a194=a194-a167;
a167=a194/a172;
a205=a205/a172;
a168=2.*a168;
a208=2.*a173;
a208=a208*a243;
a168=a168*a208;
a144=2.*a144;
a208=2.*a207;
a208=a208*a194;
a195=2.*a202;
a203=a203*a241;
a241=sin(a005);
a241=a241*a007;
a142=a142*a241;
a203=a203-a142;
a212=a046-a212;
a242=a242*a212;
a212=cos(a005);
a212=a212*a007;
a147=a147*a212;
a242=a242+a147;
a203=a203+a242;
a195=a195*a203;
a208=a208+a195;
a144=a144*a208;
a168=a168+a144;
a144=2.*a206;
a168=a168/a144;
a144=2.*a172;
a144=a168/a144;
a205=a205*a144;
a167=a167-a205;
a209=a209*a167;
a153=a153+a209;
a230=a230*a153;
a201=a201/a199;
a201=a201*a188;
a230=a230-a201;
a201=a219*a238;
a231=casadi_fmax(a231,a200);
a200=a221*a231;
a201=a201-a200;
a201=a201+a012;
a200=casadi_fmax(a011,a201);
a199=a012*a200;
a199=a024-a199;
a153=casadi_sq(a200);
a209=a011<=a201;
a201=a201<=a011;
a201=a201+a209;
a209=a209/a201;
a201=a219*a188;
a167=a221*a230;
a201=a201-a167;
a209=a209*a201;
a201=a153*a209;
a167=2.*a200;
a167=a167*a209;
a167=a200*a167;
a201=a201+a167;
a201=a218*a201;
a201=a199*a201;
a200=a200*a153;
a200=a218*a200;
a209=a012*a209;
a209=a200*a209;
a201=a201-a209;
a201=a230+a201;
a238=a219*a238;
a209=a221*a231;
a238=a238+a209;
a238=a238+a012;
a209=casadi_fmax(a011,a238);
a153=a012*a209;
a153=a024-a153;
a167=casadi_sq(a209);
a205=a011<=a238;
a238=a238<=a011;
a238=a238+a205;
a205=a205/a238;
a188=a219*a188;
a230=a221*a230;
a188=a188+a230;
a205=a205*a188;
a188=a167*a205;
a230=2.*a209;
a230=a230*a205;
a230=a209*a230;
a188=a188+a230;
a188=a218*a188;
a188=a153*a188;
a209=a209*a167;
a209=a218*a209;
a205=a012*a205;
a205=a209*a205;
a188=a188-a205;
a201=a201-a188;
a188=a138*a201;
a200=a200*a199;
a231=a231+a200;
a209=a209*a153;
a231=a231-a209;
a209=a231*a246;
a188=a188-a209;
a188=a204*a188;
a209=a138*a231;
a153=a209*a232;
a188=a188+a153;
a153=a140*a188;
a209=a209*a204;
a200=sin(a005);
a200=a200*a007;
a200=a209*a200;
a153=a153-a200;
a200=sin(a005);
a199=a151*a235;
a205=-a161;
a167=a164*a138;
a163=a163+a167;
a167=casadi_fmax(a011,a163);
a230=casadi_sq(a207);
a230=a230+a174;
a238=sqrt(a230);
a208=a202/a238;
a195=a167*a208;
a195=a195/a204;
a242=casadi_fmin(a195,a161);
a147=casadi_fmax(a205,a242);
a212=a024-a157;
a142=a147*a212;
a241=a156*a147;
a141=atan(a241);
a196=a157*a141;
a196=a196/a156;
a142=a142+a196;
a139=a156*a142;
a244=atan(a139);
a010=a155*a244;
a009=sin(a010);
a192=a154*a009;
a193=casadi_sq(a202);
a193=a193+a230;
a193=sqrt(a193);
a230=a192*a193;
a143=a202*a230;
a143=a143/a206;
a191=a143+a044;
a189=casadi_sq(a202);
a189=a189/a206;
a197=a189+a197;
a191=a191/a197;
a187=a151*a191;
a199=a199-a187;
a187=casadi_fmin(a024,a199);
a190=casadi_fmax(a011,a187);
a171=casadi_sq(a190);
a186=a190*a171;
a186=a150*a186;
a181=casadi_sq(a190);
a181=a051*a181;
a185=a053*a190;
a181=a181-a185;
a181=a181+a054;
a185=a186*a181;
a235=a235-a191;
a235=a235-a150;
a180=casadi_fmax(a011,a235);
a185=a185+a180;
a180=a202*a185;
a180=a180/a172;
a183=a230/a172;
a184=a180+a183;
a179=casadi_sq(a231);
a179=a024-a179;
a179=sqrt(a179);
a182=a179+a210;
a217=casadi_fmin(a184,a182);
a162=-a182;
a178=a217<=a162;
a211=a162<=a217;
a239=a178+a211;
a178=a178/a239;
a231=2.*a231;
a231=a231*a201;
a201=2.*a179;
a231=a231/a201;
a178=a178*a231;
a211=a211/a239;
a239=a184<=a182;
a182=a182<=a184;
a184=a239+a182;
a239=a239/a184;
a185=a185*a203;
a201=a011<=a187;
a187=a187<=a011;
a187=a187+a201;
a201=a201/a187;
a187=a199<=a024;
a199=a024<=a199;
a199=a199+a187;
a187=a187/a199;
a199=a151*a198;
a230=a230*a203;
a009=a009*a229;
a010=cos(a010);
a244=a244*a224;
a142=a142*a228;
a224=a242<=a205;
a205=a205<=a242;
a242=a224+a205;
a224=a224/a242;
a224=a224*a160;
a205=a205/a242;
a242=a195<=a161;
a161=a161<=a195;
a229=a242+a161;
a242=a242/a229;
a159=a011<=a163;
a163=a163<=a011;
a163=a163+a159;
a159=a159/a163;
a227=a138*a227;
a164=a164*a246;
a227=a227-a164;
a165=a165+a227;
a159=a159*a165;
a159=a208*a159;
a165=a203/a238;
a208=a208/a238;
a207=2.*a207;
a207=a207*a194;
a207=a207+a170;
a238=2.*a238;
a238=a207/a238;
a208=a208*a238;
a165=a165-a208;
a167=a167*a165;
a159=a159+a167;
a159=a159/a204;
a195=a195/a204;
a195=a195*a232;
a159=a159-a195;
a242=a242*a159;
a161=a161/a229;
a161=a161*a160;
a242=a242-a161;
a205=a205*a242;
a224=a224+a205;
a212=a212*a224;
a205=a147*a158;
a212=a212-a205;
a141=a141*a158;
a147=a147*a228;
a224=a156*a224;
a147=a147+a224;
a241=casadi_sq(a241);
a241=a024+a241;
a147=a147/a241;
a157=a157*a147;
a141=a141+a157;
a141=a141/a156;
a196=a196/a156;
a196=a196*a228;
a141=a141-a196;
a212=a212+a141;
a156=a156*a212;
a142=a142+a156;
a139=casadi_sq(a139);
a139=a024+a139;
a142=a142/a139;
a155=a155*a142;
a244=a244+a155;
a010=a010*a244;
a154=a154*a010;
a009=a009+a154;
a009=a193*a009;
a154=2.*a202;
a154=a154*a203;
a154=a154+a207;
a193=2.*a193;
a154=a154/a193;
a192=a192*a154;
a009=a009+a192;
a192=a202*a009;
a230=a230+a192;
a230=a230/a206;
a143=a143/a206;
a143=a143*a168;
a230=a230-a143;
a230=a230/a197;
a191=a191/a197;
a197=2.*a202;
a197=a197*a203;
a197=a197/a206;
a189=a189/a206;
a189=a189*a168;
a197=a197-a189;
a191=a191*a197;
a230=a230-a191;
a151=a151*a230;
a199=a199-a151;
a187=a187*a199;
a201=a201*a187;
a171=a171*a201;
a187=2.*a190;
a187=a187*a201;
a187=a190*a187;
a171=a171+a187;
a150=a150*a171;
a181=a181*a150;
a190=2.*a190;
a190=a190*a201;
a190=a051*a190;
a201=a053*a201;
a190=a190-a201;
a186=a186*a190;
a181=a181+a186;
a186=a011<=a235;
a235=a235<=a011;
a235=a235+a186;
a186=a186/a235;
a198=a198-a230;
a186=a186*a198;
a181=a181+a186;
a202=a202*a181;
a185=a185+a202;
a185=a185/a172;
a180=a180/a172;
a180=a180*a144;
a185=a185-a180;
a009=a009/a172;
a183=a183/a172;
a183=a183*a144;
a009=a009-a183;
a185=a185+a009;
a239=a239*a185;
a182=a182/a184;
a182=a182*a231;
a239=a239-a182;
a211=a211*a239;
a178=a178+a211;
a211=a219*a179;
a162=casadi_fmax(a162,a217);
a217=a221*a162;
a211=a211-a217;
a211=a211+a012;
a217=casadi_fmax(a011,a211);
a239=casadi_sq(a217);
a182=a217*a239;
a182=a218*a182;
a184=a011<=a211;
a211=a211<=a011;
a211=a211+a184;
a184=a184/a211;
a211=a219*a231;
a185=a221*a178;
a211=a211+a185;
a184=a184*a211;
a211=a012*a184;
a211=a182*a211;
a185=a012*a217;
a185=a024-a185;
a239=a239*a184;
a009=2.*a217;
a009=a009*a184;
a217=a217*a009;
a239=a239+a217;
a239=a218*a239;
a239=a185*a239;
a211=a211-a239;
a211=a178+a211;
a179=a219*a179;
a239=a221*a162;
a179=a179+a239;
a179=a179+a012;
a239=casadi_fmax(a011,a179);
a217=a012*a239;
a217=a024-a217;
a009=casadi_sq(a239);
a184=a011<=a179;
a179=a179<=a011;
a179=a179+a184;
a184=a184/a179;
a178=a221*a178;
a231=a219*a231;
a178=a178-a231;
a184=a184*a178;
a178=a009*a184;
a231=2.*a239;
a231=a231*a184;
a231=a239*a231;
a178=a178+a231;
a178=a218*a178;
a178=a217*a178;
a239=a239*a009;
a239=a218*a239;
a184=a012*a184;
a184=a239*a184;
a178=a178-a184;
a211=a211-a178;
a211=a138*a211;
a182=a182*a185;
a162=a162+a182;
a239=a239*a217;
a162=a162-a239;
a246=a162*a246;
a211=a211-a246;
a211=a204*a211;
a138=a138*a162;
a232=a138*a232;
a211=a211+a232;
a232=a200*a211;
a138=a138*a204;
a204=cos(a005);
a204=a204*a007;
a204=a138*a204;
a232=a232+a204;
a153=a153+a232;
a232=a237-a153;
a204=arg[1]? arg[1][6] : 0;
a162=arg[2]? arg[2][44] : 0;
a246=a204*a162;
a239=arg[1]? arg[1][7] : 0;
a246=a246+a239;
a239=arg[2]? arg[2][45] : 0;
a217=a024-a239;
a182=a246*a217;
a185=sin(a182);
a239=a024-a239;
a178=arg[2]? arg[2][50] : 0;
a184=arg[2]? arg[2][48] : 0;
a009=arg[2]? arg[2][49] : 0;
a231=a015*a133;
a231=a231+a122;
a231=a231/a136;
a122=casadi_fmax(a011,a231);
a179=a009*a122;
a184=a184+a179;
a179=casadi_fmax(a008,a184);
a183=a178*a179;
a144=arg[2]? arg[2][55] : 0;
a144=a144/a183;
a172=a144+a210;
a180=-a172;
a202=cos(a182);
a181=a029*a202;
a186=a111+a114;
a198=a003*a186;
a198=a198+a000;
a230=sin(a182);
a235=a198*a230;
a181=a181+a235;
a235=casadi_sq(a173);
a190=casadi_sq(a235);
a201=casadi_sq(a181);
a150=cos(a182);
a171=a198*a150;
a187=sin(a182);
a199=a029*a187;
a171=a171-a199;
a199=casadi_sq(a171);
a201=a201+a199;
a199=casadi_sq(a201);
a190=a190+a199;
a190=sqrt(a190);
a199=sqrt(a190);
a151=a181/a199;
a191=casadi_fmin(a172,a151);
a197=casadi_fmax(a180,a191);
a189=a219*a144;
a168=a221*a197;
a189=a189-a168;
a189=a189+a012;
a168=casadi_fmax(a011,a189);
a206=casadi_sq(a168);
a203=a168*a206;
a203=a218*a203;
a143=a012*a168;
a143=a024-a143;
a192=a203*a143;
a192=a197+a192;
a154=a219*a144;
a197=a221*a197;
a154=a154+a197;
a154=a154+a012;
a197=casadi_fmax(a011,a154);
a193=casadi_sq(a197);
a207=a197*a193;
a207=a218*a207;
a010=a012*a197;
a010=a024-a010;
a244=a207*a010;
a192=a192-a244;
a244=casadi_sq(a192);
a244=a024-a244;
a244=sqrt(a244);
a210=a244+a210;
a155=-a210;
a142=arg[2]? arg[2][54] : 0;
a139=arg[2]? arg[2][53] : 0;
a156=arg[2]? arg[2][51] : 0;
a212=arg[2]? arg[2][52] : 0;
a141=a212-a024;
a196=casadi_fmax(a044,a141);
a196=sqrt(a196);
a228=a156*a196;
a157=1./a228;
a147=-a157;
a241=arg[2]? arg[2][46] : 0;
a224=arg[2]? arg[2][47] : 0;
a158=a224*a122;
a241=a241+a158;
a158=casadi_fmax(a011,a241);
a205=casadi_sq(a181);
a205=a205+a174;
a174=sqrt(a205);
a242=a171/a174;
a161=a158*a242;
a161=a161/a183;
a160=casadi_fmin(a161,a157);
a229=casadi_fmax(a147,a160);
a159=a156*a229;
a195=atan(a159);
a167=a212*a195;
a167=a167/a156;
a165=a212-a024;
a208=a229*a165;
a208=a167-a208;
a238=a156*a208;
a194=atan(a238);
a227=a139*a194;
a164=sin(a227);
a163=a142*a164;
a177=casadi_sq(a171);
a177=a177+a205;
a177=sqrt(a177);
a205=a163*a177;
a205=a205/a199;
a166=casadi_fmin(a205,a210);
a216=casadi_fmax(a155,a166);
a176=a219*a244;
a175=a221*a216;
a176=a176-a175;
a176=a176+a012;
a175=casadi_fmax(a011,a176);
a223=casadi_sq(a175);
a222=a175*a223;
a222=a218*a222;
a220=a012*a175;
a220=a024-a220;
a214=a222*a220;
a214=a216+a214;
a240=a219*a244;
a216=a221*a216;
a240=a240+a216;
a240=a240+a012;
a216=casadi_fmax(a011,a240);
a213=casadi_sq(a216);
a169=a216*a213;
a169=a218*a169;
a215=a012*a216;
a215=a024-a215;
a145=a169*a215;
a214=a214-a145;
a145=a011<=a231;
a245=a231<=a011;
a245=a245+a145;
a145=a145/a245;
a137=a133*a137;
a015=a015*a132;
a137=a137+a015;
a137=a137+a119;
a137=a137/a136;
a231=a231/a136;
a231=a231*a135;
a137=a137-a231;
a145=a145*a137;
a137=a214*a145;
a231=a166<=a155;
a155=a155<=a166;
a166=a231+a155;
a231=a231/a166;
a135=2.*a192;
a136=a180<=a191;
a191=a191<=a180;
a180=a191+a136;
a136=a136/a180;
a119=a172<=a151;
a172=a151<=a172;
a015=a119+a172;
a119=a119/a015;
a245=arg[6]? arg[6][55] : 0;
a245=a245/a183;
a144=a144/a183;
a149=arg[6]? arg[6][50] : 0;
a179=a179*a149;
a149=a008<=a184;
a184=a184<=a008;
a184=a184+a149;
a149=a149/a184;
a184=arg[6]? arg[6][48] : 0;
a008=arg[6]? arg[6][49] : 0;
a008=a122*a008;
a009=a009*a145;
a008=a008+a009;
a184=a184+a008;
a149=a149*a184;
a178=a178*a149;
a179=a179+a178;
a144=a144*a179;
a245=a245-a144;
a119=a119*a245;
a172=a172/a015;
a202=a202*a046;
a015=sin(a182);
a144=arg[5]? arg[5][6] : 0;
a162=a162*a144;
a178=arg[6]? arg[6][44] : 0;
a178=a204*a178;
a162=a162+a178;
a178=arg[5]? arg[5][7] : 0;
a162=a162+a178;
a217=a217*a162;
a162=arg[6]? arg[6][45] : 0;
a246=a246*a162;
a217=a217-a246;
a015=a015*a217;
a015=a029*a015;
a202=a202-a015;
a186=a186*a001;
a015=a110+a113;
a015=a003*a015;
a186=a186+a015;
a186=a186+a004;
a230=a230*a186;
a015=cos(a182);
a015=a015*a217;
a015=a198*a015;
a230=a230+a015;
a202=a202+a230;
a230=a202/a199;
a151=a151/a199;
a235=2.*a235;
a173=2.*a173;
a173=a173*a243;
a235=a235*a173;
a201=2.*a201;
a173=2.*a181;
a173=a173*a202;
a243=2.*a171;
a150=a150*a186;
a186=sin(a182);
a186=a186*a217;
a198=a198*a186;
a150=a150-a198;
a187=a187*a046;
a198=cos(a182);
a198=a198*a217;
a198=a029*a198;
a187=a187+a198;
a150=a150-a187;
a243=a243*a150;
a173=a173+a243;
a201=a201*a173;
a235=a235+a201;
a190=2.*a190;
a235=a235/a190;
a190=2.*a199;
a235=a235/a190;
a151=a151*a235;
a230=a230-a151;
a172=a172*a230;
a119=a119+a172;
a136=a136*a119;
a191=a191/a180;
a191=a191*a245;
a136=a136-a191;
a191=a011<=a189;
a189=a189<=a011;
a189=a189+a191;
a191=a191/a189;
a189=a219*a245;
a180=a221*a136;
a189=a189-a180;
a191=a191*a189;
a206=a206*a191;
a189=2.*a168;
a189=a189*a191;
a168=a168*a189;
a206=a206+a168;
a206=a218*a206;
a143=a143*a206;
a191=a012*a191;
a203=a203*a191;
a143=a143-a203;
a143=a136+a143;
a203=a011<=a154;
a154=a154<=a011;
a154=a154+a203;
a203=a203/a154;
a245=a219*a245;
a136=a221*a136;
a245=a245+a136;
a203=a203*a245;
a193=a193*a203;
a245=2.*a197;
a245=a245*a203;
a197=a197*a245;
a193=a193+a197;
a193=a218*a193;
a010=a010*a193;
a203=a012*a203;
a207=a207*a203;
a010=a010-a207;
a143=a143-a010;
a135=a135*a143;
a244=2.*a244;
a135=a135/a244;
a231=a231*a135;
a155=a155/a166;
a166=a205<=a210;
a210=a210<=a205;
a244=a166+a210;
a166=a166/a244;
a010=arg[6]? arg[6][54] : 0;
a164=a164*a010;
a227=cos(a227);
a010=arg[6]? arg[6][53] : 0;
a194=a194*a010;
a010=arg[6]? arg[6][51] : 0;
a208=a208*a010;
a207=arg[6]? arg[6][52] : 0;
a195=a195*a207;
a203=a229*a010;
a193=a160<=a147;
a147=a147<=a160;
a160=a193+a147;
a193=a193/a160;
a228=a157/a228;
a197=a196*a010;
a245=a044<=a141;
a141=a141<=a044;
a141=a141+a245;
a245=a245/a141;
a245=a245*a207;
a196=2.*a196;
a245=a245/a196;
a245=a156*a245;
a197=a197+a245;
a228=a228*a197;
a193=a193*a228;
a147=a147/a160;
a160=a161<=a157;
a157=a157<=a161;
a197=a160+a157;
a160=a160/a197;
a245=a011<=a241;
a241=a241<=a011;
a241=a241+a245;
a245=a245/a241;
a241=arg[6]? arg[6][46] : 0;
a196=arg[6]? arg[6][47] : 0;
a196=a122*a196;
a224=a224*a145;
a196=a196+a224;
a241=a241+a196;
a245=a245*a241;
a245=a242*a245;
a241=a150/a174;
a242=a242/a174;
a181=2.*a181;
a181=a181*a202;
a181=a181+a170;
a174=2.*a174;
a174=a181/a174;
a242=a242*a174;
a241=a241-a242;
a158=a158*a241;
a245=a245+a158;
a245=a245/a183;
a161=a161/a183;
a161=a161*a179;
a245=a245-a161;
a160=a160*a245;
a157=a157/a197;
a157=a157*a228;
a160=a160-a157;
a147=a147*a160;
a193=a193+a147;
a147=a156*a193;
a203=a203+a147;
a159=casadi_sq(a159);
a159=a024+a159;
a203=a203/a159;
a212=a212*a203;
a195=a195+a212;
a195=a195/a156;
a167=a167/a156;
a167=a167*a010;
a195=a195-a167;
a165=a165*a193;
a229=a229*a207;
a165=a165+a229;
a195=a195-a165;
a156=a156*a195;
a208=a208+a156;
a238=casadi_sq(a238);
a238=a024+a238;
a208=a208/a238;
a139=a139*a208;
a194=a194+a139;
a227=a227*a194;
a142=a142*a227;
a164=a164+a142;
a164=a177*a164;
a171=2.*a171;
a171=a171*a150;
a171=a171+a181;
a177=2.*a177;
a171=a171/a177;
a163=a163*a171;
a164=a164+a163;
a164=a164/a199;
a205=a205/a199;
a205=a205*a235;
a164=a164-a205;
a166=a166*a164;
a210=a210/a244;
a210=a210*a135;
a166=a166-a210;
a155=a155*a166;
a231=a231+a155;
a155=a011<=a176;
a176=a176<=a011;
a176=a176+a155;
a155=a155/a176;
a176=a219*a135;
a166=a221*a231;
a176=a176+a166;
a155=a155*a176;
a176=a012*a155;
a222=a222*a176;
a223=a223*a155;
a176=2.*a175;
a176=a176*a155;
a175=a175*a176;
a223=a223+a175;
a223=a218*a223;
a220=a220*a223;
a222=a222-a220;
a222=a231+a222;
a220=a011<=a240;
a240=a240<=a011;
a240=a240+a220;
a220=a220/a240;
a221=a221*a231;
a219=a219*a135;
a221=a221-a219;
a220=a220*a221;
a213=a213*a220;
a221=2.*a216;
a221=a221*a220;
a216=a216*a221;
a213=a213+a216;
a218=a218*a213;
a215=a215*a218;
a220=a012*a220;
a169=a169*a220;
a215=a215-a169;
a222=a222-a215;
a222=a122*a222;
a137=a137+a222;
a137=a183*a137;
a214=a122*a214;
a222=a214*a179;
a137=a137+a222;
a137=a239*a137;
a214=a214*a183;
a162=a214*a162;
a137=a137-a162;
a162=a185*a137;
a214=a214*a239;
a239=cos(a182);
a239=a239*a217;
a239=a214*a239;
a162=a162+a239;
a239=cos(a182);
a145=a192*a145;
a143=a122*a143;
a145=a145+a143;
a145=a183*a145;
a122=a122*a192;
a179=a122*a179;
a145=a145+a179;
a179=a239*a145;
a122=a122*a183;
a183=sin(a182);
a183=a183*a217;
a183=a122*a183;
a179=a179-a183;
a162=a162-a179;
a232=a232+a162;
a232=a232+a036;
a036=arg[6]? arg[6][23] : 0;
a162=arg[2]? arg[2][24] : 0;
a179=2.*a091;
a179=a179*a090;
a179=a162*a179;
a091=casadi_sq(a091);
a090=arg[6]? arg[6][24] : 0;
a090=a091*a090;
a179=a179+a090;
a036=a036+a179;
a036=a105*a036;
a179=arg[2]? arg[2][23] : 0;
a091=a091*a162;
a179=a179+a091;
a091=a179*a089;
a036=a036+a091;
a036=a097*a036;
a179=a179*a105;
a085=a179*a085;
a036=a036+a085;
a036=a036/a108;
a179=a179*a097;
a179=a179/a108;
a097=a179/a108;
a097=a097*a092;
a036=a036-a097;
a232=a232-a036;
a232=a232/a014;
a006=a234*a006;
a233=a226*a233;
a006=a006-a233;
a140=a209*a140;
a200=a138*a200;
a140=a140+a200;
a200=a006-a140;
a185=a214*a185;
a239=a122*a239;
a185=a185-a239;
a200=a200+a185;
a200=a200+a039;
a200=a200-a179;
a200=a200/a014;
a200=a200/a014;
a200=a200*a247;
a232=a232-a200;
a002=a002+a232;
if (res[0]!=0) res[0][0]=a002;
a002=arg[5]? arg[5][10] : 0;
a033=a029-a033;
a232=casadi_sq(a033);
a232=a232+a027;
a232=sqrt(a232);
a200=a033*a232;
a200=a200+a040;
a040=a028*a200;
a179=casadi_fmin(a024,a040);
a039=casadi_fmax(a011,a179);
a185=casadi_sq(a039);
a239=a039*a185;
a239=a027*a239;
a233=casadi_sq(a039);
a233=a051*a233;
a036=a053*a039;
a233=a233-a036;
a233=a233+a054;
a054=a239*a233;
a200=a200+a056;
a056=casadi_fmax(a011,a200);
a054=a054+a056;
a054=a054+a027;
a056=arg[2]? arg[2][69] : 0;
a036=sin(a026);
a097=a056*a036;
a085=arg[2]? arg[2][68] : 0;
a091=cos(a026);
a162=a085*a091;
a097=a097-a162;
a090=a003*a097;
a090=a090+a000;
a090=a090-a100;
a100=casadi_sq(a090);
a100=a054+a100;
a183=arg[2]? arg[2][74] : 0;
a192=arg[2]? arg[2][70] : 0;
a017=a192+a017;
a143=-a017;
a222=arg[2]? arg[2][71] : 0;
a215=sqrt(a054);
a169=atan2(a090,a215);
a220=arg[1]? arg[1][8] : 0;
a218=arg[2]? arg[2][56] : 0;
a213=a204*a218;
a220=a220-a213;
a213=arg[2]? arg[2][72] : 0;
a216=a220*a213;
a169=a169-a216;
a216=a222*a169;
a221=casadi_fmin(a017,a216);
a219=casadi_fmax(a143,a221);
a135=a062*a192;
a231=a064*a219;
a135=a135-a231;
a135=a135+a012;
a231=casadi_fmax(a011,a135);
a240=casadi_sq(a231);
a223=a231*a240;
a223=a061*a223;
a175=a012*a231;
a175=a024-a175;
a176=a223*a175;
a176=a219+a176;
a192=a062*a192;
a219=a064*a219;
a192=a192+a219;
a192=a192+a012;
a219=casadi_fmax(a011,a192);
a155=casadi_sq(a219);
a166=a219*a155;
a166=a061*a166;
a210=a012*a219;
a210=a024-a210;
a244=a166*a210;
a176=a176-a244;
a244=arg[6]? arg[6][73] : 0;
a244=a012*a244;
a244=a176*a244;
a164=arg[2]? arg[2][73] : 0;
a164=a012*a164;
a205=a143<=a221;
a221=a221<=a143;
a143=a221+a205;
a205=a205/a143;
a235=a017<=a216;
a216=a216<=a017;
a017=a235+a216;
a235=a235/a017;
a199=arg[6]? arg[6][70] : 0;
a235=a235*a199;
a216=a216/a017;
a017=arg[6]? arg[6][71] : 0;
a169=a169*a017;
a017=casadi_sq(a090);
a017=a017+a054;
a054=a215/a017;
a163=a097*a001;
a171=arg[6]? arg[6][69] : 0;
a036=a036*a171;
a171=cos(a026);
a171=a171*a250;
a056=a056*a171;
a036=a036+a056;
a056=arg[6]? arg[6][68] : 0;
a091=a091*a056;
a026=sin(a026);
a026=a026*a250;
a085=a085*a026;
a091=a091-a085;
a036=a036-a091;
a085=a003*a036;
a163=a163+a085;
a163=a163+a004;
a163=a163-a099;
a054=a054*a163;
a017=a090/a017;
a099=a011<=a179;
a179=a179<=a011;
a179=a179+a099;
a099=a099/a179;
a179=a040<=a024;
a024=a024<=a040;
a024=a024+a179;
a179=a179/a024;
a032=a046-a032;
a024=a232*a032;
a040=2.*a033;
a040=a040*a032;
a232=2.*a232;
a040=a040/a232;
a033=a033*a040;
a024=a024+a033;
a024=a024+a072;
a028=a028*a024;
a179=a179*a028;
a099=a099*a179;
a185=a185*a099;
a179=2.*a039;
a179=a179*a099;
a179=a039*a179;
a185=a185+a179;
a027=a027*a185;
a233=a233*a027;
a039=2.*a039;
a039=a039*a099;
a051=a051*a039;
a053=a053*a099;
a051=a051-a053;
a239=a239*a051;
a233=a233+a239;
a239=a011<=a200;
a200=a200<=a011;
a200=a200+a239;
a239=a239/a200;
a239=a239*a024;
a233=a233+a239;
a215=2.*a215;
a215=a233/a215;
a017=a017*a215;
a054=a054-a017;
a017=arg[5]? arg[5][8] : 0;
a218=a218*a144;
a144=arg[6]? arg[6][56] : 0;
a204=a204*a144;
a218=a218+a204;
a017=a017-a218;
a213=a213*a017;
a218=arg[6]? arg[6][72] : 0;
a218=a220*a218;
a213=a213+a218;
a054=a054-a213;
a222=a222*a054;
a169=a169+a222;
a216=a216*a169;
a235=a235+a216;
a205=a205*a235;
a221=a221/a143;
a221=a221*a199;
a205=a205-a221;
a221=a011<=a135;
a135=a135<=a011;
a135=a135+a221;
a221=a221/a135;
a135=a062*a199;
a143=a064*a205;
a135=a135-a143;
a221=a221*a135;
a240=a240*a221;
a135=2.*a231;
a135=a135*a221;
a231=a231*a135;
a240=a240+a231;
a240=a061*a240;
a175=a175*a240;
a221=a012*a221;
a223=a223*a221;
a175=a175-a223;
a175=a205+a175;
a223=a011<=a192;
a192=a192<=a011;
a192=a192+a223;
a223=a223/a192;
a062=a062*a199;
a064=a064*a205;
a062=a062+a064;
a223=a223*a062;
a155=a155*a223;
a062=2.*a219;
a062=a062*a223;
a219=a219*a062;
a155=a155+a219;
a061=a061*a155;
a210=a210*a061;
a223=a012*a223;
a166=a166*a223;
a210=a210-a166;
a175=a175-a210;
a175=a164*a175;
a244=a244+a175;
a244=a183*a244;
a164=a164*a176;
a176=arg[6]? arg[6][74] : 0;
a176=a164*a176;
a244=a244+a176;
a244=a042*a244;
a164=a164*a183;
a183=a164*a069;
a244=a244+a183;
a244=a100*a244;
a164=a164*a042;
a090=2.*a090;
a090=a090*a163;
a233=a233+a090;
a233=a164*a233;
a244=a244+a233;
a233=a002-a244;
a090=2.5000000000000000e-01;
a095=a090*a095;
a103=sqrt(a103);
a163=a095*a103;
a183=a163*a003;
a176=a183*a042;
a175=arg[2]? arg[2][60] : 0;
a210=arg[6]? arg[6][58] : 0;
a210=a175*a210;
a166=arg[2]? arg[2][58] : 0;
a223=arg[6]? arg[6][60] : 0;
a061=a166*a223;
a210=a210+a061;
a210=a176*a210;
a166=a166*a175;
a090=a090*a093;
a090=a103*a090;
a103=2.*a103;
a050=a050/a103;
a095=a095*a050;
a090=a090+a095;
a090=a003*a090;
a163=a163*a001;
a090=a090+a163;
a042=a042*a090;
a183=a183*a069;
a042=a042+a183;
a183=a166*a042;
a210=a210+a183;
a183=arg[2]? arg[2][57] : 0;
a069=atan2(a102,a108);
a090=a183*a069;
a163=arg[2]? arg[2][59] : 0;
a095=a163*a220;
a090=a090+a095;
a095=a090*a089;
a050=arg[6]? arg[6][57] : 0;
a050=a069*a050;
a103=casadi_sq(a102);
a103=a103+a098;
a108=a108/a103;
a108=a108*a101;
a102=a102/a103;
a102=a102*a092;
a108=a108-a102;
a183=a183*a108;
a050=a050+a183;
a183=arg[6]? arg[6][59] : 0;
a183=a220*a183;
a163=a163*a017;
a183=a183+a163;
a050=a050+a183;
a050=a105*a050;
a095=a095+a050;
a210=a210+a095;
a233=a233+a210;
a210=sin(a005);
a225=a210*a225;
a095=cos(a005);
a095=a095*a007;
a095=a226*a095;
a225=a225+a095;
a095=cos(a005);
a236=a095*a236;
a050=sin(a005);
a050=a050*a007;
a050=a234*a050;
a236=a236-a050;
a225=a225+a236;
a233=a233-a225;
a236=sin(a005);
a188=a236*a188;
a050=cos(a005);
a050=a050*a007;
a050=a209*a050;
a188=a188+a050;
a050=cos(a005);
a211=a050*a211;
a005=sin(a005);
a005=a005*a007;
a005=a138*a005;
a211=a211-a005;
a188=a188-a211;
a233=a233+a188;
a211=sin(a182);
a145=a211*a145;
a005=cos(a182);
a005=a005*a217;
a005=a122*a005;
a145=a145+a005;
a005=cos(a182);
a137=a005*a137;
a182=sin(a182);
a182=a182*a217;
a182=a214*a182;
a137=a137-a182;
a145=a145+a137;
a233=a233-a145;
a233=a233/a014;
a137=arg[1]? arg[1][10] : 0;
a164=a164*a100;
a100=a137-a164;
a166=a166*a176;
a090=a105*a090;
a166=a166+a090;
a100=a100+a166;
a226=a226*a210;
a234=a234*a095;
a226=a226+a234;
a100=a100-a226;
a209=a209*a236;
a138=a138*a050;
a209=a209-a138;
a100=a100+a209;
a122=a122*a211;
a214=a214*a005;
a122=a122+a214;
a100=a100-a122;
a100=a100/a014;
a100=a100/a014;
a100=a100*a247;
a233=a233-a100;
a100=a029*a001;
a003=a003*a046;
a100=a100+a003;
a233=a233-a100;
if (res[0]!=0) res[0][1]=a233;
a233=casadi_sq(a175);
a100=arg[6]? arg[6][66] : 0;
a100=a233*a100;
a003=arg[2]? arg[2][66] : 0;
a247=2.*a175;
a247=a247*a223;
a247=a003*a247;
a100=a100+a247;
a100=a176*a100;
a003=a003*a233;
a042=a003*a042;
a100=a100+a042;
a042=arg[2]? arg[2][64] : 0;
a233=arg[1]? arg[1][9] : 0;
a247=a042*a233;
a014=arg[2]? arg[2][65] : 0;
a214=a014*a069;
a247=a247+a214;
a214=arg[2]? arg[2][67] : 0;
a005=a214*a220;
a247=a247+a005;
a223=a105*a223;
a089=a175*a089;
a223=a223+a089;
a223=a247*a223;
a175=a175*a105;
a105=arg[6]? arg[6][64] : 0;
a233=a233*a105;
a105=arg[5]? arg[5][9] : 0;
a042=a042*a105;
a233=a233+a042;
a042=arg[6]? arg[6][65] : 0;
a069=a069*a042;
a014=a014*a108;
a069=a069+a014;
a233=a233+a069;
a069=arg[6]? arg[6][67] : 0;
a220=a220*a069;
a214=a214*a017;
a220=a220+a214;
a233=a233+a220;
a233=a175*a233;
a223=a223+a233;
a100=a100+a223;
a244=a097*a244;
a036=a164*a036;
a244=a244+a036;
a002=a162*a002;
a091=a137*a091;
a002=a002+a091;
a244=a244+a002;
a100=a100-a244;
a237=a012*a237;
a237=a146*a237;
a006=a012*a006;
a244=a006*a152;
a237=a237+a244;
a100=a100+a237;
a153=a012*a153;
a153=a146*a153;
a012=a012*a140;
a152=a012*a152;
a153=a153+a152;
a100=a100+a153;
a225=a133*a225;
a153=a226*a132;
a225=a225+a153;
a100=a100-a225;
a188=a133*a188;
a132=a209*a132;
a188=a188+a132;
a100=a100+a188;
a111=a111+a114;
a145=a111*a145;
a110=a110+a113;
a110=a122*a110;
a145=a145+a110;
a100=a100-a145;
a145=arg[2]? arg[2][78] : 0;
a100=a100/a145;
a003=a003*a176;
a175=a175*a247;
a003=a003+a175;
a164=a164*a097;
a137=a137*a162;
a164=a164+a137;
a003=a003-a164;
a006=a006*a146;
a003=a003+a006;
a012=a012*a146;
a003=a003+a012;
a226=a226*a133;
a003=a003-a226;
a209=a209*a133;
a003=a003+a209;
a122=a122*a111;
a003=a003-a122;
a003=a003/a145;
a003=a003/a145;
a145=arg[6]? arg[6][78] : 0;
a003=a003*a145;
a100=a100-a003;
if (res[0]!=0) res[0][2]=a100;
a100=cos(a031);
a100=a100*a046;
a003=sin(a031);
a003=a003*a074;
a003=a029*a003;
a100=a100-a003;
a003=sin(a031);
a003=a003*a004;
a145=cos(a031);
a145=a145*a074;
a145=a000*a145;
a003=a003+a145;
a100=a100-a003;
if (res[0]!=0) res[0][3]=a100;
a100=sin(a031);
a100=a100*a046;
a046=cos(a031);
a046=a046*a074;
a029=a029*a046;
a100=a100+a029;
a029=cos(a031);
a029=a029*a004;
a031=sin(a031);
a031=a031*a074;
a000=a000*a031;
a029=a029-a000;
a100=a100+a029;
if (res[0]!=0) res[0][4]=a100;
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
casadi_real a408, a409, a410, a411, a412, a413, a414, a415, a416, a417, a418, a419;
casadi_real a420;
a000=arg[0]? arg[0][5] : 0;
a001=sin(a000);
a002=arg[4]? arg[4][4] : 0;
a001=a001*a002;
a003=cos(a000);
a004=arg[4]? arg[4][3] : 0;
a003=a003*a004;
a001=a001+a003;
a003=arg[0]? arg[0][2] : 0;
a005=arg[4]? arg[4][1] : 0;
a006=a003*a005;
a001=a001-a006;
a006=arg[0]? arg[0][0] : 0;
a007=arg[1]? arg[1][0] : 0;
a008=cos(a000);
a009=a007*a008;
a010=arg[1]? arg[1][1] : 0;
a011=sin(a000);
a012=a010*a011;
a009=a009+a012;
a012=a006-a009;
a013=casadi_sq(a012);
a014=9.9999999999999995e-07;
a013=a013+a014;
a013=sqrt(a013);
a015=1000000.;
a016=a012*a013;
a017=arg[1]? arg[1][2] : 0;
a018=2.*a017;
a019=arg[2]? arg[2][6] : 0;
a020=arg[2]? arg[2][7] : 0;
a021=casadi_sq(a020);
a022=9.9999999999999998e-13;
a021=a021+a022;
a021=sqrt(a021);
a023=a019*a021;
a018=a018/a023;
a016=a016+a018;
a024=a015*a016;
a025=1.;
a026=a024<=a025;
a027=a025<=a024;
a027=a027+a026;
a026=a026/a027;
a027=0.;
a024=casadi_fmin(a025,a024);
a028=a027<=a024;
a029=a024<=a027;
a029=a029+a028;
a028=a028/a029;
a029=8.;
a024=casadi_fmax(a027,a024);
a030=casadi_sq(a024);
a031=a024*a030;
a031=a014*a031;
a032=5.0000000000000000e-01;
a033=arg[2]? arg[2][73] : 0;
a033=a032*a033;
a034=arg[2]? arg[2][70] : 0;
a035=1.0000000000000001e-01;
a036=a034+a035;
a037=-a036;
a038=arg[2]? arg[2][71] : 0;
a039=arg[2]? arg[2][69] : 0;
a040=arg[2]? arg[2][1] : 0;
a041=sin(a040);
a042=a039*a041;
a043=arg[2]? arg[2][68] : 0;
a044=cos(a040);
a045=a043*a044;
a042=a042-a045;
a046=a003*a042;
a047=arg[0]? arg[0][1] : 0;
a046=a046+a047;
a048=cos(a000);
a049=a010*a048;
a050=sin(a000);
a051=a007*a050;
a049=a049-a051;
a046=a046-a049;
a051=3.;
a052=casadi_sq(a024);
a052=a051*a052;
a053=a029*a024;
a052=a052-a053;
a053=6.;
a052=a052+a053;
a054=a031*a052;
a055=-9.9999999999999995e-07;
a016=a016+a055;
a056=casadi_fmax(a027,a016);
a054=a054+a056;
a054=a054+a014;
a056=sqrt(a054);
a057=atan2(a046,a056);
a058=arg[1]? arg[1][8] : 0;
a059=arg[1]? arg[1][6] : 0;
a060=arg[2]? arg[2][56] : 0;
a061=a059*a060;
a058=a058-a061;
a061=arg[2]? arg[2][72] : 0;
a062=a058*a061;
a057=a057-a062;
a062=a038*a057;
a063=casadi_fmin(a036,a062);
a064=casadi_fmax(a037,a063);
a065=2.0000000000000001e-01;
a066=-5.;
a067=a066*a034;
a068=5.;
a069=a068*a064;
a067=a067-a069;
a067=a067+a032;
a069=casadi_fmax(a027,a067);
a070=casadi_sq(a069);
a071=a069*a070;
a071=a065*a071;
a072=a032*a069;
a072=a025-a072;
a073=a071*a072;
a073=a064+a073;
a034=a066*a034;
a064=a068*a064;
a034=a034+a064;
a034=a034+a032;
a064=casadi_fmax(a027,a034);
a074=casadi_sq(a064);
a075=a064*a074;
a075=a065*a075;
a076=a032*a064;
a076=a025-a076;
a077=a075*a076;
a073=a073-a077;
a077=a033*a073;
a078=arg[2]? arg[2][74] : 0;
a079=a077*a078;
a080=a079*a020;
a081=arg[4]? arg[4][2] : 0;
a082=arg[2]? arg[2][78] : 0;
a083=a081/a082;
a084=a042*a083;
a085=arg[2]? arg[2][27] : 0;
a086=a005/a085;
a084=a084+a086;
a087=a080*a084;
a088=casadi_sq(a046);
a088=a088+a054;
a089=a046/a088;
a090=a062<=a036;
a036=a036<=a062;
a062=a036+a090;
a090=a090/a062;
a091=a037<=a063;
a063=a063<=a037;
a037=a063+a091;
a091=a091/a037;
a092=a027<=a034;
a034=a034<=a027;
a034=a034+a092;
a092=a092/a034;
a034=casadi_sq(a046);
a054=a054+a034;
a084=a054*a084;
a034=a020*a084;
a078=a078*a034;
a033=a033*a078;
a076=a076*a033;
a076=a065*a076;
a074=a074*a076;
a075=a075*a033;
a075=a032*a075;
a074=a074-a075;
a075=2.*a064;
a064=a064*a076;
a075=a075*a064;
a074=a074+a075;
a092=a092*a074;
a074=a068*a092;
a074=a074-a033;
a075=a027<=a067;
a067=a067<=a027;
a067=a067+a075;
a075=a075/a067;
a071=a071*a033;
a071=a032*a071;
a072=a072*a033;
a072=a065*a072;
a070=a070*a072;
a071=a071-a070;
a070=2.*a069;
a069=a069*a072;
a070=a070*a069;
a071=a071-a070;
a075=a075*a071;
a071=a068*a075;
a074=a074-a071;
a091=a091*a074;
a090=a090*a091;
a038=a038*a090;
a089=a089*a038;
a071=2.*a056;
a089=a089/a071;
a089=a087+a089;
a031=a031*a089;
a071=a029*a031;
a070=2.*a024;
a031=a051*a031;
a070=a070*a031;
a071=a071-a070;
a052=a052*a089;
a052=a014*a052;
a030=a030*a052;
a071=a071-a030;
a030=2.*a024;
a024=a024*a052;
a030=a030*a024;
a071=a071-a030;
a028=a028*a071;
a026=a026*a028;
a026=a015*a026;
a028=a027<=a016;
a016=a016<=a027;
a016=a016+a028;
a028=a028/a016;
a028=a028*a089;
a026=a026-a028;
a028=a013*a026;
a089=2.*a012;
a012=a012*a026;
a013=2.*a013;
a012=a012/a013;
a089=a089*a012;
a028=a028+a089;
a001=a001+a028;
a089=arg[2]? arg[2][44] : 0;
a012=a059*a089;
a013=arg[1]? arg[1][7] : 0;
a012=a012+a013;
a013=arg[2]? arg[2][45] : 0;
a016=a025-a013;
a071=a012*a016;
a030=sin(a071);
a024=arg[2]? arg[2][25] : 0;
a052=cos(a040);
a070=a024*a052;
a031=arg[2]? arg[2][30] : 0;
a069=sin(a040);
a072=a031*a069;
a033=a070+a072;
a067=a003*a033;
a067=a067+a047;
a064=cos(a071);
a076=a067*a064;
a093=a006*a030;
a076=a076-a093;
a093=2.*a076;
a094=arg[2]? arg[2][54] : 0;
a095=arg[2]? arg[2][53] : 0;
a096=arg[2]? arg[2][51] : 0;
a097=arg[2]? arg[2][52] : 0;
a098=a097-a025;
a099=casadi_fmax(a022,a098);
a099=sqrt(a099);
a100=a096*a099;
a101=1./a100;
a102=-a101;
a103=arg[2]? arg[2][46] : 0;
a104=arg[2]? arg[2][47] : 0;
a105=arg[2]? arg[2][26] : 0;
a106=a105*a085;
a107=arg[2]? arg[2][12] : 0;
a108=a107+a035;
a109=-a108;
a110=arg[2]? arg[2][11] : 0;
a111=arg[1]? arg[1][3] : 0;
a112=arg[2]? arg[2][10] : 0;
a113=a111*a112;
a114=arg[2]? arg[2][9] : 0;
a113=a113+a114;
a114=arg[2]? arg[2][8] : 0;
a114=a025-a114;
a115=a006-a009;
a116=casadi_sq(a115);
a116=a116+a014;
a116=sqrt(a116);
a117=a115*a116;
a117=a117+a018;
a118=a015*a117;
a119=casadi_fmin(a025,a118);
a120=casadi_fmax(a027,a119);
a121=casadi_sq(a120);
a122=a120*a121;
a122=a014*a122;
a123=casadi_sq(a120);
a123=a051*a123;
a124=a029*a120;
a123=a123-a124;
a123=a123+a053;
a124=a122*a123;
a055=a055+a117;
a117=casadi_fmax(a027,a055);
a124=a124+a117;
a124=a124+a014;
a117=sqrt(a124);
a117=atan2(a027,a117);
a117=a040+a117;
a125=a114*a117;
a113=a113+a125;
a125=a110*a113;
a126=casadi_fmin(a108,a125);
a127=casadi_fmax(a109,a126);
a128=a066*a107;
a129=a068*a127;
a128=a128-a129;
a128=a128+a032;
a129=casadi_fmax(a027,a128);
a130=casadi_sq(a129);
a131=a129*a130;
a131=a065*a131;
a132=a032*a129;
a132=a025-a132;
a133=a131*a132;
a133=a127+a133;
a107=a066*a107;
a127=a068*a127;
a107=a107+a127;
a107=a107+a032;
a127=casadi_fmax(a027,a107);
a134=casadi_sq(a127);
a135=a127*a134;
a135=a065*a135;
a136=a032*a127;
a136=a025-a136;
a137=a135*a136;
a133=a133-a137;
a133=a032*a133;
a137=arg[2]? arg[2][13] : 0;
a138=a133*a137;
a139=a138*a020;
a140=arg[2]? arg[2][14] : 0;
a141=a139*a140;
a142=a141*a124;
a106=a106-a142;
a143=arg[2]? arg[2][22] : 0;
a035=a143+a035;
a144=-a035;
a145=arg[2]? arg[2][20] : 0;
a146=arg[2]? arg[2][21] : 0;
a147=a146*a040;
a145=a145+a147;
a147=casadi_fmin(a035,a145);
a148=casadi_fmax(a144,a147);
a149=a066*a143;
a150=a068*a148;
a149=a149-a150;
a149=a149+a032;
a150=casadi_fmax(a027,a149);
a151=casadi_sq(a150);
a152=a150*a151;
a152=a065*a152;
a153=a032*a150;
a153=a025-a153;
a154=a152*a153;
a154=a148+a154;
a143=a066*a143;
a148=a068*a148;
a143=a143+a148;
a143=a143+a032;
a148=casadi_fmax(a027,a143);
a155=casadi_sq(a148);
a156=a148*a155;
a156=a065*a156;
a157=a032*a148;
a157=a025-a157;
a158=a156*a157;
a154=a154-a158;
a158=arg[2]? arg[2][15] : 0;
a159=a032*a158;
a009=a006-a009;
a160=casadi_sq(a009);
a161=1.0000000000000000e-08;
a160=a160+a161;
a049=a047-a049;
a161=casadi_sq(a049);
a161=a160+a161;
a162=a159*a161;
a163=a162*a020;
a164=a154*a163;
a165=a164*a009;
a166=sqrt(a160);
a165=a165/a166;
a106=a106-a165;
a167=arg[2]? arg[2][0] : 0;
a168=cos(a040);
a169=a167*a168;
a170=arg[2]? arg[2][4] : 0;
a171=sin(a040);
a172=a170*a171;
a169=a169+a172;
a172=a106*a169;
a173=arg[2]? arg[2][28] : 0;
a174=cos(a040);
a175=a173*a174;
a176=arg[2]? arg[2][29] : 0;
a177=sin(a040);
a178=a176*a177;
a175=a175+a178;
a178=a142*a175;
a179=arg[2]? arg[2][19] : 0;
a180=a179*a163;
a181=arg[2]? arg[2][16] : 0;
a182=arg[2]? arg[2][17] : 0;
a183=a182*a040;
a181=a181+a183;
a183=arg[2]? arg[2][18] : 0;
a184=a183*a111;
a181=a181+a184;
a184=a180*a181;
a178=a178+a184;
a184=arg[2]? arg[2][31] : 0;
a185=a017*a184;
a186=cos(a040);
a187=a185*a186;
a178=a178+a187;
a172=a172+a178;
a187=a070+a072;
a187=a169-a187;
a172=a172/a187;
a188=casadi_fmax(a027,a172);
a189=a104*a188;
a103=a103+a189;
a189=casadi_fmax(a027,a103);
a190=cos(a071);
a191=a006*a190;
a192=sin(a071);
a193=a067*a192;
a191=a191+a193;
a193=casadi_sq(a191);
a194=arg[2]? arg[2][5] : 0;
a195=casadi_sq(a194);
a195=a014*a195;
a193=a193+a195;
a196=sqrt(a193);
a197=a076/a196;
a198=a189*a197;
a199=arg[2]? arg[2][50] : 0;
a200=1.0000000000000000e-03;
a201=arg[2]? arg[2][48] : 0;
a202=arg[2]? arg[2][49] : 0;
a203=a202*a188;
a201=a201+a203;
a203=casadi_fmax(a200,a201);
a204=a199*a203;
a198=a198/a204;
a205=casadi_fmin(a198,a101);
a206=casadi_fmax(a102,a205);
a207=a096*a206;
a208=atan(a207);
a209=a097*a208;
a209=a209/a096;
a210=a097-a025;
a211=a206*a210;
a211=a209-a211;
a212=a096*a211;
a213=atan(a212);
a214=a095*a213;
a215=sin(a214);
a216=a094*a215;
a217=casadi_sq(a076);
a217=a217+a193;
a217=sqrt(a217);
a193=a216*a217;
a218=casadi_sq(a194);
a219=casadi_sq(a218);
a220=casadi_sq(a191);
a221=casadi_sq(a076);
a220=a220+a221;
a221=casadi_sq(a220);
a219=a219+a221;
a219=sqrt(a219);
a221=sqrt(a219);
a193=a193/a221;
a222=arg[2]? arg[2][55] : 0;
a222=a222/a204;
a223=5.0000000000000004e-06;
a224=a222+a223;
a225=-a224;
a226=a191/a221;
a227=casadi_fmin(a224,a226);
a228=casadi_fmax(a225,a227);
a229=1.0000000000000001e-05;
a230=-100000.;
a231=a230*a222;
a232=100000.;
a233=a232*a228;
a231=a231-a233;
a231=a231+a032;
a233=casadi_fmax(a027,a231);
a234=casadi_sq(a233);
a235=a233*a234;
a235=a229*a235;
a236=a032*a233;
a236=a025-a236;
a237=a235*a236;
a237=a228+a237;
a238=a230*a222;
a228=a232*a228;
a238=a238+a228;
a238=a238+a032;
a228=casadi_fmax(a027,a238);
a239=casadi_sq(a228);
a240=a228*a239;
a240=a229*a240;
a241=a032*a228;
a241=a025-a241;
a242=a240*a241;
a237=a237-a242;
a242=casadi_sq(a237);
a242=a025-a242;
a242=sqrt(a242);
a243=a242+a223;
a244=a193<=a243;
a245=a243<=a193;
a246=a244+a245;
a244=a244/a246;
a247=-a243;
a243=casadi_fmin(a193,a243);
a248=a247<=a243;
a249=a243<=a247;
a250=a249+a248;
a248=a248/a250;
a251=a230*a242;
a247=casadi_fmax(a247,a243);
a243=a232*a247;
a251=a251+a243;
a251=a251+a032;
a243=a027<=a251;
a252=a251<=a027;
a252=a252+a243;
a243=a243/a252;
a251=casadi_fmax(a027,a251);
a252=casadi_sq(a251);
a253=a251*a252;
a253=a229*a253;
a013=a025-a013;
a254=sin(a071);
a255=arg[4]? arg[4][0] : 0;
a256=a255/a085;
a257=a254*a256;
a258=cos(a071);
a259=a070+a072;
a260=a259*a083;
a260=a260+a086;
a261=a258*a260;
a257=a257-a261;
a261=a013*a257;
a262=a204*a261;
a263=a188*a262;
a264=a253*a263;
a264=a032*a264;
a265=a032*a251;
a265=a025-a265;
a266=a265*a263;
a266=a229*a266;
a252=a252*a266;
a264=a264-a252;
a252=2.*a251;
a251=a251*a266;
a252=a252*a251;
a264=a264-a252;
a243=a243*a264;
a264=a232*a243;
a264=a264+a263;
a252=a230*a242;
a251=a232*a247;
a252=a252-a251;
a252=a252+a032;
a251=a027<=a252;
a266=a252<=a027;
a266=a266+a251;
a251=a251/a266;
a252=casadi_fmax(a027,a252);
a266=casadi_sq(a252);
a267=a032*a252;
a267=a025-a267;
a268=a267*a263;
a268=a229*a268;
a269=a266*a268;
a266=a252*a266;
a266=a229*a266;
a263=a266*a263;
a263=a032*a263;
a269=a269-a263;
a263=2.*a252;
a252=a252*a268;
a263=a263*a252;
a269=a269+a263;
a251=a251*a269;
a269=a232*a251;
a264=a264-a269;
a248=a248*a264;
a244=a244*a248;
a269=a244/a221;
a216=a216*a269;
a263=2.*a217;
a216=a216/a263;
a093=a093*a216;
a263=a198<=a101;
a252=a101<=a198;
a268=a263+a252;
a263=a263/a268;
a270=a102<=a205;
a205=a205<=a102;
a102=a205+a270;
a270=a270/a102;
a214=cos(a214);
a217=a217*a269;
a094=a094*a217;
a214=a214*a094;
a095=a095*a214;
a212=casadi_sq(a212);
a212=a025+a212;
a095=a095/a212;
a097=a097*a095;
a207=casadi_sq(a207);
a207=a025+a207;
a097=a097/a207;
a207=a096*a097;
a212=a096*a095;
a210=a210*a212;
a207=a207-a210;
a270=a270*a207;
a263=a263*a270;
a210=a263/a204;
a189=a189*a210;
a094=a189/a196;
a093=a093+a094;
a076=2.*a076;
a220=2.*a220;
a193=a193/a221;
a193=a193*a244;
a244=a226/a221;
a094=a226<=a224;
a224=a224<=a226;
a226=a224+a094;
a094=a094/a226;
a269=a225<=a227;
a227=a227<=a225;
a225=a227+a269;
a269=a269/a225;
a271=a027<=a238;
a238=a238<=a027;
a238=a238+a271;
a271=a271/a238;
a238=sin(a071);
a272=a238*a260;
a273=cos(a071);
a274=a273*a256;
a272=a272+a274;
a274=a204*a272;
a275=a188*a274;
a276=2.*a237;
a243=a230*a243;
a251=a230*a251;
a243=a243+a251;
a245=a245/a246;
a245=a245*a248;
a249=a249/a250;
a249=a249*a264;
a245=a245-a249;
a243=a243+a245;
a242=2.*a242;
a243=a243/a242;
a276=a276*a243;
a275=a275+a276;
a241=a241*a275;
a241=a229*a241;
a239=a239*a241;
a240=a240*a275;
a240=a032*a240;
a239=a239-a240;
a240=2.*a228;
a228=a228*a241;
a240=a240*a228;
a239=a239+a240;
a271=a271*a239;
a239=a232*a271;
a239=a239-a275;
a240=a027<=a231;
a231=a231<=a027;
a231=a231+a240;
a240=a240/a231;
a235=a235*a275;
a235=a032*a235;
a236=a236*a275;
a236=a229*a236;
a234=a234*a236;
a235=a235-a234;
a234=2.*a233;
a233=a233*a236;
a234=a234*a233;
a235=a235-a234;
a240=a240*a235;
a235=a232*a240;
a239=a239-a235;
a269=a269*a239;
a094=a094*a269;
a244=a244*a094;
a193=a193+a244;
a244=2.*a221;
a193=a193/a244;
a219=2.*a219;
a193=a193/a219;
a220=a220*a193;
a076=a076*a220;
a093=a093-a076;
a030=a030*a093;
a001=a001-a030;
a030=2.*a191;
a076=a197/a196;
a076=a076*a189;
a196=2.*a196;
a076=a076/a196;
a216=a216-a076;
a030=a030*a216;
a094=a094/a221;
a030=a030+a094;
a191=2.*a191;
a191=a191*a220;
a030=a030-a191;
a190=a190*a030;
a001=a001+a190;
a190=arg[2]? arg[2][2] : 0;
a191=sin(a190);
a220=2.0000000000000000e-02;
a094=50.;
a221=arg[1]? arg[1][5] : 0;
a076=a094*a221;
a196=a003*a169;
a196=a196+a047;
a189=cos(a190);
a219=a196*a189;
a244=a032*a003;
a235=arg[2]? arg[2][3] : 0;
a234=a244*a235;
a233=a006-a234;
a236=a233*a191;
a219=a219+a236;
a236=arg[2]? arg[2][40] : 0;
a275=arg[2]? arg[2][39] : 0;
a231=arg[2]? arg[2][37] : 0;
a228=arg[2]? arg[2][38] : 0;
a241=a228-a025;
a276=casadi_fmax(a022,a241);
a276=sqrt(a276);
a243=a231*a276;
a242=1./a243;
a245=-a242;
a249=arg[2]? arg[2][32] : 0;
a264=arg[2]? arg[2][33] : 0;
a070=a070+a072;
a072=a106*a070;
a072=a072+a178;
a072=a032*a072;
a072=a072/a187;
a178=-a072;
a250=casadi_fmax(a027,a178);
a248=a264*a250;
a248=a249+a248;
a246=casadi_fmax(a027,a248);
a251=a006-a234;
a277=cos(a190);
a278=a251*a277;
a279=sin(a190);
a280=a196*a279;
a278=a278-a280;
a281=casadi_sq(a278);
a281=a281+a195;
a282=sqrt(a281);
a283=a219/a282;
a284=a246*a283;
a285=arg[2]? arg[2][42] : 0;
a286=arg[2]? arg[2][34] : 0;
a287=arg[2]? arg[2][35] : 0;
a288=a287*a250;
a288=a286+a288;
a289=casadi_fmax(a200,a288);
a290=a285*a289;
a284=a284/a290;
a291=casadi_fmin(a284,a242);
a292=casadi_fmax(a245,a291);
a293=a025-a228;
a294=a292*a293;
a295=a231*a292;
a296=atan(a295);
a297=a228*a296;
a297=a297/a231;
a294=a294+a297;
a298=a231*a294;
a299=atan(a298);
a300=a275*a299;
a301=sin(a300);
a302=a236*a301;
a303=casadi_sq(a219);
a303=a303+a281;
a303=sqrt(a303);
a281=a302*a303;
a304=a219*a281;
a305=casadi_sq(a194);
a306=casadi_sq(a305);
a307=casadi_sq(a278);
a308=casadi_sq(a219);
a307=a307+a308;
a308=casadi_sq(a307);
a306=a306+a308;
a306=sqrt(a306);
a304=a304/a306;
a308=a304+a022;
a309=casadi_sq(a219);
a309=a309/a306;
a310=4.9999999999999999e-13;
a311=a309+a310;
a308=a308/a311;
a312=a094*a308;
a076=a076-a312;
a312=casadi_fmin(a025,a076);
a313=casadi_fmax(a027,a312);
a314=casadi_sq(a313);
a315=a313*a314;
a315=a220*a315;
a316=casadi_sq(a313);
a316=a051*a316;
a317=a029*a313;
a316=a316-a317;
a316=a316+a053;
a317=a315*a316;
a318=a221-a308;
a318=a318-a220;
a319=casadi_fmax(a027,a318);
a317=a317+a319;
a319=a219*a317;
a320=sqrt(a306);
a319=a319/a320;
a321=a281/a320;
a322=a319+a321;
a323=arg[2]? arg[2][43] : 0;
a324=a290-a323;
a325=a221*a324;
a325=a325+a323;
a325=a325/a290;
a323=a325+a223;
a326=-a323;
a327=a278/a320;
a328=casadi_fmin(a323,a327);
a329=casadi_fmax(a326,a328);
a330=a230*a325;
a331=a232*a329;
a330=a330-a331;
a330=a330+a032;
a331=casadi_fmax(a027,a330);
a332=casadi_sq(a331);
a333=a331*a332;
a333=a229*a333;
a334=a032*a331;
a334=a025-a334;
a335=a333*a334;
a335=a329+a335;
a336=a230*a325;
a329=a232*a329;
a336=a336+a329;
a336=a336+a032;
a329=casadi_fmax(a027,a336);
a337=casadi_sq(a329);
a338=a329*a337;
a338=a229*a338;
a339=a032*a329;
a339=a025-a339;
a340=a338*a339;
a335=a335-a340;
a340=casadi_sq(a335);
a340=a025-a340;
a340=sqrt(a340);
a341=a340+a223;
a342=a322<=a341;
a343=a341<=a322;
a344=a342+a343;
a342=a342/a344;
a345=-a341;
a322=casadi_fmin(a322,a341);
a341=a345<=a322;
a346=a322<=a345;
a347=a346+a341;
a341=a341/a347;
a348=a230*a340;
a345=casadi_fmax(a345,a322);
a322=a232*a345;
a348=a348+a322;
a348=a348+a032;
a322=a027<=a348;
a349=a348<=a027;
a349=a349+a322;
a322=a322/a349;
a348=casadi_fmax(a027,a348);
a349=casadi_sq(a348);
a350=a348*a349;
a350=a229*a350;
a351=sin(a190);
a352=a235*a083;
a352=a032*a352;
a352=a352-a256;
a353=a351*a352;
a354=cos(a190);
a355=a169*a083;
a355=a355+a086;
a356=a354*a355;
a353=a353-a356;
a356=a290*a353;
a357=a250*a356;
a358=a350*a357;
a358=a032*a358;
a359=a032*a348;
a359=a025-a359;
a360=a359*a357;
a360=a229*a360;
a349=a349*a360;
a358=a358-a349;
a349=2.*a348;
a348=a348*a360;
a349=a349*a348;
a358=a358-a349;
a322=a322*a358;
a358=a232*a322;
a358=a358+a357;
a349=a230*a340;
a348=a232*a345;
a349=a349-a348;
a349=a349+a032;
a348=a027<=a349;
a360=a349<=a027;
a360=a360+a348;
a348=a348/a360;
a349=casadi_fmax(a027,a349);
a360=casadi_sq(a349);
a361=a032*a349;
a361=a025-a361;
a362=a361*a357;
a362=a229*a362;
a363=a360*a362;
a360=a349*a360;
a360=a229*a360;
a357=a360*a357;
a357=a032*a357;
a363=a363-a357;
a357=2.*a349;
a349=a349*a362;
a357=a357*a349;
a363=a363+a357;
a348=a348*a363;
a363=a232*a348;
a358=a358-a363;
a341=a341*a358;
a342=a342*a341;
a363=a342/a320;
a317=a317*a363;
a357=2.*a219;
a308=a308/a311;
a349=a027<=a318;
a318=a318<=a027;
a318=a318+a349;
a349=a349/a318;
a363=a219*a363;
a349=a349*a363;
a318=a076<=a025;
a076=a025<=a076;
a076=a076+a318;
a318=a318/a076;
a076=a027<=a312;
a312=a312<=a027;
a312=a312+a076;
a076=a076/a312;
a312=2.*a313;
a315=a315*a363;
a362=a051*a315;
a312=a312*a362;
a315=a029*a315;
a312=a312-a315;
a316=a316*a363;
a316=a220*a316;
a314=a314*a316;
a312=a312+a314;
a314=2.*a313;
a313=a313*a316;
a314=a314*a313;
a312=a312+a314;
a076=a076*a312;
a318=a318*a076;
a076=a094*a318;
a076=a349+a076;
a308=a308*a076;
a312=a308/a306;
a357=a357*a312;
a317=a317+a357;
a076=a076/a311;
a311=a076/a306;
a281=a281*a311;
a317=a317-a281;
a281=2.*a219;
a357=a342/a320;
a311=a219*a311;
a357=a357-a311;
a302=a302*a357;
a311=2.*a303;
a302=a302/a311;
a281=a281*a302;
a317=a317+a281;
a281=a284<=a242;
a311=a242<=a284;
a312=a281+a311;
a281=a281/a312;
a314=a245<=a291;
a291=a291<=a245;
a245=a291+a314;
a314=a314/a245;
a300=cos(a300);
a303=a303*a357;
a357=a236*a303;
a300=a300*a357;
a357=a275*a300;
a298=casadi_sq(a298);
a298=a025+a298;
a357=a357/a298;
a298=a228*a357;
a295=casadi_sq(a295);
a295=a025+a295;
a298=a298/a295;
a295=a231*a298;
a313=a231*a357;
a293=a293*a313;
a295=a295+a293;
a314=a314*a295;
a281=a281*a314;
a293=a281/a290;
a246=a246*a293;
a316=a246/a282;
a317=a317+a316;
a219=2.*a219;
a307=2.*a307;
a304=a304/a306;
a304=a304*a076;
a309=a309/a306;
a309=a309*a308;
a304=a304-a309;
a321=a321/a320;
a321=a321*a342;
a319=a319/a320;
a319=a319*a342;
a321=a321+a319;
a319=a327/a320;
a342=a327<=a323;
a323=a323<=a327;
a327=a323+a342;
a342=a342/a327;
a309=a326<=a328;
a328=a328<=a326;
a326=a328+a309;
a309=a309/a326;
a308=a027<=a336;
a336=a336<=a027;
a336=a336+a308;
a308=a308/a336;
a336=sin(a190);
a076=a336*a355;
a316=cos(a190);
a363=a316*a352;
a076=a076+a363;
a363=a290*a076;
a315=a250*a363;
a362=2.*a335;
a322=a230*a322;
a348=a230*a348;
a322=a322+a348;
a343=a343/a344;
a343=a343*a341;
a346=a346/a347;
a346=a346*a358;
a343=a343-a346;
a322=a322+a343;
a340=2.*a340;
a322=a322/a340;
a362=a362*a322;
a315=a315-a362;
a338=a338*a315;
a338=a032*a338;
a339=a339*a315;
a339=a229*a339;
a337=a337*a339;
a338=a338-a337;
a337=2.*a329;
a329=a329*a339;
a337=a337*a329;
a338=a338-a337;
a308=a308*a338;
a338=a232*a308;
a338=a338+a315;
a337=a027<=a330;
a330=a330<=a027;
a330=a330+a337;
a337=a337/a330;
a334=a334*a315;
a334=a229*a334;
a332=a332*a334;
a333=a333*a315;
a333=a032*a333;
a332=a332-a333;
a333=2.*a331;
a331=a331*a334;
a333=a333*a331;
a332=a332+a333;
a337=a337*a332;
a332=a232*a337;
a338=a338-a332;
a309=a309*a338;
a342=a342*a309;
a319=a319*a342;
a321=a321+a319;
a319=2.*a320;
a321=a321/a319;
a304=a304-a321;
a306=2.*a306;
a304=a304/a306;
a307=a307*a304;
a219=a219*a307;
a317=a317+a219;
a191=a191*a317;
a001=a001+a191;
a219=2.*a278;
a306=a283/a282;
a306=a306*a246;
a282=2.*a282;
a306=a306/a282;
a302=a302-a306;
a219=a219*a302;
a342=a342/a320;
a219=a219+a342;
a278=2.*a278;
a278=a278*a307;
a219=a219+a278;
a277=a277*a219;
a001=a001+a277;
a278=sin(a190);
a307=arg[1]? arg[1][4] : 0;
a342=a094*a307;
a320=cos(a190);
a306=a196*a320;
a282=a006+a234;
a246=a282*a278;
a306=a306-a246;
a246=-a242;
a321=a264*a250;
a249=a249+a321;
a321=casadi_fmax(a027,a249);
a234=a006+a234;
a319=cos(a190);
a332=a234*a319;
a280=a280+a332;
a332=casadi_sq(a280);
a332=a332+a195;
a195=sqrt(a332);
a333=a306/a195;
a331=a321*a333;
a334=arg[2]? arg[2][36] : 0;
a315=a287*a250;
a286=a286+a315;
a315=casadi_fmax(a200,a286);
a330=a334*a315;
a331=a331/a330;
a329=casadi_fmin(a331,a242);
a339=casadi_fmax(a246,a329);
a362=a025-a228;
a322=a339*a362;
a340=a231*a339;
a343=atan(a340);
a346=a228*a343;
a346=a346/a231;
a322=a322+a346;
a358=a231*a322;
a347=atan(a358);
a341=a275*a347;
a344=sin(a341);
a348=a236*a344;
a364=casadi_sq(a306);
a364=a364+a332;
a364=sqrt(a364);
a332=a348*a364;
a365=a306*a332;
a366=casadi_sq(a194);
a367=casadi_sq(a366);
a368=casadi_sq(a280);
a369=casadi_sq(a306);
a368=a368+a369;
a369=casadi_sq(a368);
a367=a367+a369;
a367=sqrt(a367);
a365=a365/a367;
a369=a365+a022;
a370=casadi_sq(a306);
a370=a370/a367;
a310=a370+a310;
a369=a369/a310;
a371=a094*a369;
a342=a342-a371;
a371=casadi_fmin(a025,a342);
a372=casadi_fmax(a027,a371);
a373=casadi_sq(a372);
a374=a372*a373;
a374=a220*a374;
a375=casadi_sq(a372);
a375=a051*a375;
a376=a029*a372;
a375=a375-a376;
a375=a375+a053;
a053=a374*a375;
a376=a307-a369;
a376=a376-a220;
a377=casadi_fmax(a027,a376);
a053=a053+a377;
a377=a306*a053;
a378=sqrt(a367);
a377=a377/a378;
a379=a332/a378;
a380=a377+a379;
a381=arg[2]? arg[2][41] : 0;
a382=a330-a381;
a383=a307*a382;
a383=a383+a381;
a383=a383/a330;
a381=a383+a223;
a384=-a381;
a385=a280/a378;
a386=casadi_fmin(a381,a385);
a387=casadi_fmax(a384,a386);
a388=a230*a383;
a389=a232*a387;
a388=a388-a389;
a388=a388+a032;
a389=casadi_fmax(a027,a388);
a390=casadi_sq(a389);
a391=a389*a390;
a391=a229*a391;
a392=a032*a389;
a392=a025-a392;
a393=a391*a392;
a393=a387+a393;
a394=a230*a383;
a387=a232*a387;
a394=a394+a387;
a394=a394+a032;
a387=casadi_fmax(a027,a394);
a395=casadi_sq(a387);
a396=a387*a395;
a396=a229*a396;
a397=a032*a387;
a397=a025-a397;
a398=a396*a397;
a393=a393-a398;
a398=casadi_sq(a393);
a398=a025-a398;
a398=sqrt(a398);
a223=a398+a223;
a399=a380<=a223;
a400=a223<=a380;
a401=a399+a400;
a399=a399/a401;
a402=-a223;
a380=casadi_fmin(a380,a223);
a223=a402<=a380;
a403=a380<=a402;
a404=a403+a223;
a223=a223/a404;
a405=a230*a398;
a402=casadi_fmax(a402,a380);
a380=a232*a402;
a405=a405+a380;
a405=a405+a032;
a380=a027<=a405;
a406=a405<=a027;
a406=a406+a380;
a380=a380/a406;
a405=casadi_fmax(a027,a405);
a406=casadi_sq(a405);
a407=a405*a406;
a407=a229*a407;
a408=sin(a190);
a409=a235*a083;
a409=a032*a409;
a409=a409+a256;
a410=a408*a409;
a411=cos(a190);
a412=a169*a083;
a412=a412+a086;
a413=a411*a412;
a410=a410-a413;
a413=a330*a410;
a414=a250*a413;
a415=a407*a414;
a415=a032*a415;
a416=a032*a405;
a416=a025-a416;
a417=a416*a414;
a417=a229*a417;
a406=a406*a417;
a415=a415-a406;
a406=2.*a405;
a405=a405*a417;
a406=a406*a405;
a415=a415-a406;
a380=a380*a415;
a415=a232*a380;
a415=a415+a414;
a406=a230*a398;
a405=a232*a402;
a406=a406-a405;
a406=a406+a032;
a405=a027<=a406;
a417=a406<=a027;
a417=a417+a405;
a405=a405/a417;
a406=casadi_fmax(a027,a406);
a417=casadi_sq(a406);
a418=a032*a406;
a418=a025-a418;
a419=a418*a414;
a419=a229*a419;
a420=a417*a419;
a417=a406*a417;
a417=a229*a417;
a414=a417*a414;
a414=a032*a414;
a420=a420-a414;
a414=2.*a406;
a406=a406*a419;
a414=a414*a406;
a420=a420+a414;
a405=a405*a420;
a420=a232*a405;
a415=a415-a420;
a223=a223*a415;
a399=a399*a223;
a420=a399/a378;
a053=a053*a420;
a414=2.*a306;
a369=a369/a310;
a406=a027<=a376;
a376=a376<=a027;
a376=a376+a406;
a406=a406/a376;
a420=a306*a420;
a406=a406*a420;
a376=a342<=a025;
a342=a025<=a342;
a342=a342+a376;
a376=a376/a342;
a342=a027<=a371;
a371=a371<=a027;
a371=a371+a342;
a342=a342/a371;
a371=2.*a372;
a374=a374*a420;
a419=a051*a374;
a371=a371*a419;
a374=a029*a374;
a371=a371-a374;
a375=a375*a420;
a220=a220*a375;
a373=a373*a220;
a371=a371+a373;
a373=2.*a372;
a372=a372*a220;
a373=a373*a372;
a371=a371+a373;
a342=a342*a371;
a376=a376*a342;
a342=a094*a376;
a342=a406+a342;
a369=a369*a342;
a371=a369/a367;
a414=a414*a371;
a053=a053+a414;
a342=a342/a310;
a310=a342/a367;
a332=a332*a310;
a053=a053-a332;
a332=2.*a306;
a414=a399/a378;
a310=a306*a310;
a414=a414-a310;
a348=a348*a414;
a310=2.*a364;
a348=a348/a310;
a332=a332*a348;
a053=a053+a332;
a332=a331<=a242;
a310=a242<=a331;
a371=a332+a310;
a332=a332/a371;
a373=a246<=a329;
a329=a329<=a246;
a246=a329+a373;
a373=a373/a246;
a341=cos(a341);
a364=a364*a414;
a236=a236*a364;
a341=a341*a236;
a275=a275*a341;
a358=casadi_sq(a358);
a358=a025+a358;
a275=a275/a358;
a228=a228*a275;
a340=casadi_sq(a340);
a340=a025+a340;
a228=a228/a340;
a340=a231*a228;
a358=a231*a275;
a362=a362*a358;
a340=a340+a362;
a373=a373*a340;
a332=a332*a373;
a362=a332/a330;
a321=a321*a362;
a236=a321/a195;
a053=a053+a236;
a306=2.*a306;
a368=2.*a368;
a365=a365/a367;
a365=a365*a342;
a370=a370/a367;
a370=a370*a369;
a365=a365-a370;
a379=a379/a378;
a379=a379*a399;
a377=a377/a378;
a377=a377*a399;
a379=a379+a377;
a377=a385/a378;
a399=a385<=a381;
a381=a381<=a385;
a385=a381+a399;
a399=a399/a385;
a370=a384<=a386;
a386=a386<=a384;
a384=a386+a370;
a370=a370/a384;
a369=a027<=a394;
a394=a394<=a027;
a394=a394+a369;
a369=a369/a394;
a394=sin(a190);
a342=a394*a412;
a236=cos(a190);
a414=a236*a409;
a342=a342+a414;
a414=a330*a342;
a372=a250*a414;
a220=2.*a393;
a380=a230*a380;
a405=a230*a405;
a380=a380+a405;
a400=a400/a401;
a400=a400*a223;
a403=a403/a404;
a403=a403*a415;
a400=a400-a403;
a380=a380+a400;
a398=2.*a398;
a380=a380/a398;
a220=a220*a380;
a372=a372+a220;
a397=a397*a372;
a397=a229*a397;
a395=a395*a397;
a396=a396*a372;
a396=a032*a396;
a395=a395-a396;
a396=2.*a387;
a387=a387*a397;
a396=a396*a387;
a395=a395+a396;
a369=a369*a395;
a395=a232*a369;
a395=a395-a372;
a396=a027<=a388;
a388=a388<=a027;
a388=a388+a396;
a396=a396/a388;
a391=a391*a372;
a391=a032*a391;
a392=a392*a372;
a229=a229*a392;
a390=a390*a229;
a391=a391-a390;
a390=2.*a389;
a389=a389*a229;
a390=a390*a389;
a391=a391-a390;
a396=a396*a391;
a232=a232*a396;
a395=a395-a232;
a370=a370*a395;
a399=a399*a370;
a377=a377*a399;
a379=a379+a377;
a377=2.*a378;
a379=a379/a377;
a365=a365-a379;
a367=2.*a367;
a365=a365/a367;
a368=a368*a365;
a306=a306*a368;
a053=a053+a306;
a278=a278*a053;
a001=a001-a278;
a306=2.*a280;
a367=a333/a195;
a367=a367*a321;
a195=2.*a195;
a367=a367/a195;
a348=a348-a367;
a306=a306*a348;
a399=a399/a378;
a306=a306+a399;
a280=2.*a280;
a280=a280*a368;
a306=a306+a280;
a319=a319*a306;
a001=a001+a319;
a280=2.*a009;
a368=arg[2]? arg[2][23] : 0;
a399=casadi_sq(a154);
a378=arg[2]? arg[2][24] : 0;
a367=a399*a378;
a368=a368+a367;
a367=a368*a163;
a195=a367*a009;
a195=a195/a166;
a321=a195/a166;
a321=a321*a256;
a379=casadi_sq(a049);
a379=a379+a160;
a160=a049/a379;
a377=arg[2]? arg[2][65] : 0;
a232=arg[2]? arg[2][60] : 0;
a391=a232*a163;
a390=a391*a083;
a389=a377*a390;
a229=arg[2]? arg[2][57] : 0;
a392=a163*a086;
a372=a229*a392;
a389=a389+a372;
a160=a160*a389;
a321=a321-a160;
a165=a165/a166;
a160=a027<=a172;
a372=a172<=a027;
a372=a372+a160;
a160=a160/a372;
a266=a266*a267;
a247=a247+a266;
a253=a253*a265;
a247=a247-a253;
a262=a247*a262;
a274=a237*a274;
a262=a262-a274;
a274=a027<=a103;
a103=a103<=a027;
a103=a103+a274;
a274=a274/a103;
a197=a197*a210;
a274=a274*a197;
a104=a104*a274;
a262=a262+a104;
a104=a200<=a201;
a201=a201<=a200;
a201=a201+a104;
a104=a104/a201;
a247=a188*a247;
a261=a247*a261;
a237=a188*a237;
a272=a237*a272;
a261=a261-a272;
a198=a198/a204;
a198=a198*a263;
a261=a261-a198;
a222=a222/a204;
a271=a230*a271;
a240=a230*a240;
a271=a271+a240;
a224=a224/a226;
a224=a224*a269;
a227=a227/a225;
a227=a227*a239;
a224=a224-a227;
a271=a271+a224;
a222=a222*a271;
a261=a261-a222;
a199=a199*a261;
a104=a104*a199;
a202=a202*a104;
a262=a262+a202;
a160=a160*a262;
a262=a160/a187;
a202=a169*a262;
a199=a027<=a178;
a178=a178<=a027;
a178=a178+a199;
a199=a199/a178;
a360=a360*a361;
a345=a345+a360;
a350=a350*a359;
a345=a345-a350;
a356=a345*a356;
a350=a027<=a248;
a248=a248<=a027;
a248=a248+a350;
a350=a350/a248;
a283=a283*a293;
a350=a350*a283;
a283=a264*a350;
a356=a356+a283;
a363=a335*a363;
a356=a356+a363;
a363=a200<=a288;
a288=a288<=a200;
a288=a288+a363;
a363=a363/a288;
a345=a250*a345;
a353=a345*a353;
a284=a284/a290;
a284=a284*a281;
a353=a353-a284;
a335=a250*a335;
a076=a335*a076;
a353=a353+a076;
a325=a325/a290;
a308=a230*a308;
a337=a230*a337;
a308=a308+a337;
a323=a323/a327;
a323=a323*a309;
a328=a328/a326;
a328=a328*a338;
a323=a323-a328;
a308=a308+a323;
a325=a325*a308;
a353=a353-a325;
a308=a308/a290;
a221=a221*a308;
a353=a353+a221;
a285=a285*a353;
a363=a363*a285;
a285=a287*a363;
a356=a356+a285;
a414=a393*a414;
a356=a356-a414;
a417=a417*a418;
a402=a402+a417;
a407=a407*a416;
a402=a402-a407;
a413=a402*a413;
a356=a356+a413;
a413=a027<=a249;
a249=a249<=a027;
a249=a249+a413;
a413=a413/a249;
a333=a333*a362;
a413=a413*a333;
a264=a264*a413;
a356=a356+a264;
a264=a200<=a286;
a286=a286<=a200;
a286=a286+a264;
a264=a264/a286;
a402=a250*a402;
a410=a402*a410;
a393=a250*a393;
a342=a393*a342;
a410=a410-a342;
a331=a331/a330;
a331=a331*a332;
a410=a410-a331;
a383=a383/a330;
a369=a230*a369;
a230=a230*a396;
a369=a369+a230;
a381=a381/a385;
a381=a381*a370;
a386=a386/a384;
a386=a386*a395;
a381=a381-a386;
a369=a369+a381;
a383=a383*a369;
a410=a410-a383;
a369=a369/a330;
a307=a307*a369;
a410=a410+a307;
a334=a334*a410;
a264=a264*a334;
a287=a287*a264;
a356=a356+a287;
a199=a199*a356;
a356=a199/a187;
a356=a032*a356;
a070=a070*a356;
a202=a202-a070;
a165=a165*a202;
a321=a321+a165;
a165=2.*a166;
a321=a321/a165;
a165=2.5000000000000000e-01;
a158=a165*a158;
a070=arg[2]? arg[2][66] : 0;
a287=casadi_sq(a232);
a334=a070*a287;
a383=a334*a083;
a381=arg[2]? arg[2][58] : 0;
a386=a381*a232;
a395=a386*a086;
a383=a383+a395;
a395=a020*a383;
a384=a003*a395;
a370=a158*a384;
a385=sqrt(a161);
a230=2.*a385;
a370=a370/a230;
a230=arg[2]? arg[2][64] : 0;
a396=arg[1]? arg[1][9] : 0;
a331=a230*a396;
a332=atan2(a049,a166);
a377=a377*a332;
a331=a331+a377;
a377=arg[2]? arg[2][67] : 0;
a342=a377*a058;
a331=a331+a342;
a342=a331*a083;
a286=a232*a342;
a229=a229*a332;
a200=arg[2]? arg[2][59] : 0;
a333=a200*a058;
a229=a229+a333;
a333=a229*a086;
a286=a286+a333;
a333=a256/a166;
a362=a009*a333;
a368=a368*a362;
a286=a286-a368;
a368=a262-a356;
a181=a181*a368;
a179=a179*a181;
a286=a286+a179;
a179=a202/a166;
a009=a009*a179;
a249=a154*a009;
a286=a286-a249;
a249=a020*a286;
a159=a159*a249;
a370=a370+a159;
a321=a321+a370;
a280=a280*a321;
a367=a367*a333;
a164=a164*a179;
a367=a367+a164;
a280=a280-a367;
a001=a001+a280;
a367=a027<=a055;
a055=a055<=a027;
a055=a055+a367;
a367=a367/a055;
a175=a175*a368;
a175=a175-a202;
a141=a141*a175;
a367=a367*a141;
a055=a118<=a025;
a025=a025<=a118;
a025=a025+a055;
a055=a055/a025;
a025=a027<=a119;
a119=a119<=a027;
a119=a119+a025;
a025=a025/a119;
a119=2.*a120;
a122=a122*a141;
a051=a051*a122;
a119=a119*a051;
a029=a029*a122;
a119=a119-a029;
a123=a123*a141;
a123=a014*a123;
a121=a121*a123;
a119=a119+a121;
a121=2.*a120;
a120=a120*a123;
a121=a121*a120;
a119=a119+a121;
a025=a025*a119;
a055=a055*a025;
a015=a015*a055;
a367=a367+a015;
a015=a116*a367;
a055=2.*a115;
a115=a115*a367;
a116=2.*a116;
a115=a115/a116;
a055=a055*a115;
a015=a015+a055;
a001=a001+a015;
if (res[0]!=0) res[0][0]=a001;
a001=cos(a000);
a001=a001*a002;
a055=sin(a000);
a055=a055*a004;
a001=a001-a055;
a056=a056/a088;
a056=a056*a038;
a046=2.*a046;
a046=a046*a087;
a056=a056-a046;
a001=a001+a056;
a064=a064*a093;
a192=a192*a030;
a064=a064+a192;
a001=a001+a064;
a189=a189*a317;
a320=a320*a053;
a189=a189+a320;
a320=a306-a219;
a279=a279*a320;
a189=a189+a279;
a001=a001+a189;
a166=a166/a379;
a166=a166*a389;
a049=2.*a049;
a049=a049*a370;
a166=a166+a049;
a001=a001+a166;
a049=a003*a255;
a001=a001+a049;
if (res[0]!=0) res[0][1]=a001;
a001=arg[4]? arg[4][5] : 0;
a049=a006*a005;
a001=a001-a049;
a158=a158*a385;
a395=a158*a395;
a001=a001+a395;
a395=a042*a056;
a001=a001+a395;
a033=a033*a064;
a001=a001+a033;
a191=a191+a277;
a191=a191+a278;
a319=a319-a191;
a191=a235*a319;
a191=a032*a191;
a001=a001+a191;
a191=a169*a189;
a001=a001+a191;
a191=a047*a255;
a001=a001+a191;
if (res[0]!=0) res[0][2]=a001;
if (res[0]!=0) res[0][3]=a027;
if (res[0]!=0) res[0][4]=a027;
a001=cos(a000);
a191=a006*a002;
a001=a001*a191;
a191=sin(a000);
a002=a047*a002;
a191=a191*a002;
a001=a001-a191;
a191=cos(a000);
a047=a047*a004;
a191=a191*a047;
a001=a001-a191;
a191=sin(a000);
a004=a006*a004;
a191=a191*a004;
a001=a001-a191;
a191=cos(a000);
a166=a056+a166;
a004=a007*a166;
a191=a191*a004;
a001=a001+a191;
a191=sin(a000);
a004=a010*a166;
a191=a191*a004;
a001=a001+a191;
a191=cos(a000);
a028=a028+a280;
a028=a028+a015;
a010=a010*a028;
a191=a191*a010;
a001=a001-a191;
a000=sin(a000);
a007=a007*a028;
a000=a000*a007;
a001=a001+a000;
if (res[0]!=0) res[0][5]=a001;
a050=a050*a166;
a008=a008*a028;
a050=a050-a008;
if (res[1]!=0) res[1][0]=a050;
a048=a048*a166;
a011=a011*a028;
a048=a048+a011;
a048=-a048;
if (res[1]!=0) res[1][1]=a048;
a186=a186*a368;
a184=a184*a186;
a184=a256+a184;
a026=a026+a367;
a367=a026/a023;
a367=2.*a367;
a184=a184+a367;
if (res[1]!=0) res[1][2]=a184;
a180=a180*a368;
a183=a183*a180;
a184=a125<=a108;
a108=a108<=a125;
a125=a108+a184;
a184=a184/a125;
a367=a109<=a126;
a126=a126<=a109;
a109=a126+a367;
a367=a367/a109;
a048=a027<=a107;
a107=a107<=a027;
a107=a107+a048;
a048=a048/a107;
a124=a124*a175;
a140=a140*a124;
a175=a020*a140;
a137=a137*a175;
a137=a032*a137;
a135=a135*a137;
a135=a032*a135;
a136=a136*a137;
a136=a065*a136;
a134=a134*a136;
a135=a135-a134;
a134=2.*a127;
a127=a127*a136;
a134=a134*a127;
a135=a135-a134;
a048=a048*a135;
a135=a068*a048;
a135=a135+a137;
a134=a027<=a128;
a128=a128<=a027;
a128=a128+a134;
a134=a134/a128;
a132=a132*a137;
a132=a065*a132;
a130=a130*a132;
a131=a131*a137;
a131=a032*a131;
a130=a130-a131;
a131=2.*a129;
a129=a129*a132;
a131=a131*a129;
a130=a130+a131;
a134=a134*a130;
a130=a068*a134;
a135=a135-a130;
a367=a367*a135;
a184=a184*a367;
a110=a110*a184;
a112=a112*a110;
a183=a183+a112;
if (res[1]!=0) res[1][3]=a183;
a376=a094*a376;
a406=a406+a376;
a382=a382*a369;
a406=a406+a382;
if (res[1]!=0) res[1][4]=a406;
a094=a094*a318;
a349=a349+a094;
a324=a324*a308;
a349=a349+a324;
if (res[1]!=0) res[1][5]=a349;
a349=sin(a071);
a247=a247*a204;
a013=a247*a013;
a324=a013*a260;
a349=a349*a324;
a324=cos(a071);
a237=a237*a204;
a260=a237*a260;
a324=a324*a260;
a349=a349-a324;
a324=sin(a071);
a260=a237*a256;
a324=a324*a260;
a349=a349+a324;
a324=cos(a071);
a256=a013*a256;
a324=a324*a256;
a349=a349+a324;
a324=cos(a071);
a256=a006*a093;
a324=a324*a256;
a349=a349-a324;
a324=sin(a071);
a093=a067*a093;
a324=a324*a093;
a349=a349-a324;
a324=cos(a071);
a067=a067*a030;
a324=a324*a067;
a349=a349+a324;
a071=sin(a071);
a006=a006*a030;
a071=a071*a006;
a349=a349-a071;
a016=a016*a349;
a089=a089*a016;
a377=a377*a390;
a200=a200*a392;
a377=a377+a200;
a061=a061*a038;
a377=a377-a061;
a060=a060*a377;
a089=a089-a060;
if (res[1]!=0) res[1][6]=a089;
if (res[1]!=0) res[1][7]=a016;
if (res[1]!=0) res[1][8]=a377;
a230=a230*a390;
if (res[1]!=0) res[1][9]=a230;
a230=a045*a083;
a230=a086-a230;
if (res[1]!=0) res[1][10]=a230;
a335=a335*a290;
a336=a335*a336;
a345=a345*a290;
a354=a345*a354;
a336=a336-a354;
a354=a336*a083;
a393=a393*a330;
a394=a393*a394;
a402=a402*a330;
a411=a402*a411;
a394=a394+a411;
a411=a394*a083;
a354=a354-a411;
a262=a106*a262;
a354=a354+a262;
a189=a003*a189;
a354=a354+a189;
a072=a072/a187;
a072=a072*a199;
a172=a172/a187;
a172=a172*a160;
a072=a072-a172;
a354=a354+a072;
a168=a168*a354;
if (res[2]!=0) res[2][0]=a168;
a168=sin(a040);
a172=arg[1]? arg[1][10] : 0;
a160=a172*a083;
a056=a003*a056;
a080=a080*a054;
a054=a080*a083;
a056=a056-a054;
a160=a160+a056;
a043=a043*a160;
a168=a168*a043;
a043=cos(a040);
a039=a039*a056;
a043=a043*a039;
a168=a168+a043;
a043=cos(a040);
a170=a170*a354;
a043=a043*a170;
a168=a168+a043;
a043=sin(a040);
a167=a167*a354;
a043=a043*a167;
a168=a168-a043;
a043=sin(a040);
a185=a185*a368;
a043=a043*a185;
a168=a168-a043;
a182=a182*a180;
a168=a168+a182;
a182=cos(a040);
a142=a142*a368;
a176=a176*a142;
a182=a182*a176;
a168=a168+a182;
a182=sin(a040);
a173=a173*a142;
a182=a182*a173;
a168=a168-a182;
a182=cos(a040);
a064=a003*a064;
a238=a237*a238;
a258=a013*a258;
a238=a238+a258;
a258=a238*a083;
a173=a064-a258;
a173=a173-a072;
a106=a106*a356;
a173=a173-a106;
a031=a031*a173;
a182=a182*a031;
a168=a168+a182;
a182=sin(a040);
a064=a064-a258;
a064=a064-a072;
a064=a064-a106;
a024=a024*a064;
a182=a182*a024;
a168=a168-a182;
a182=a145<=a035;
a035=a035<=a145;
a145=a035+a182;
a182=a182/a145;
a024=a144<=a147;
a147=a147<=a144;
a144=a147+a024;
a024=a024/a144;
a106=a027<=a143;
a143=a143<=a027;
a143=a143+a106;
a106=a106/a143;
a154=2.*a154;
a362=a163*a362;
a378=a378*a362;
a154=a154*a378;
a009=a163*a009;
a154=a154+a009;
a157=a157*a154;
a157=a065*a157;
a155=a155*a157;
a156=a156*a154;
a156=a032*a156;
a155=a155-a156;
a156=2.*a148;
a148=a148*a157;
a156=a156*a148;
a155=a155+a156;
a106=a106*a155;
a155=a068*a106;
a155=a155-a154;
a156=a027<=a149;
a149=a149<=a027;
a149=a149+a156;
a156=a156/a149;
a152=a152*a154;
a152=a032*a152;
a153=a153*a154;
a065=a065*a153;
a151=a151*a065;
a152=a152-a151;
a151=2.*a150;
a150=a150*a065;
a151=a151*a150;
a152=a152-a151;
a156=a156*a152;
a068=a068*a156;
a155=a155-a068;
a024=a024*a155;
a182=a182*a024;
a146=a146*a182;
a168=a168+a146;
a114=a114*a110;
a168=a168+a114;
if (res[2]!=0) res[2][1]=a168;
a168=sin(a190);
a114=a345*a355;
a168=a168*a114;
a114=cos(a190);
a355=a335*a355;
a114=a114*a355;
a168=a168+a114;
a114=sin(a190);
a355=a402*a412;
a114=a114*a355;
a168=a168+a114;
a114=cos(a190);
a412=a393*a412;
a114=a114*a412;
a168=a168-a114;
a114=cos(a190);
a412=a345*a352;
a114=a114*a412;
a168=a168+a114;
a114=sin(a190);
a352=a335*a352;
a114=a114*a352;
a168=a168-a114;
a114=cos(a190);
a233=a233*a317;
a114=a114*a233;
a168=a168+a114;
a114=sin(a190);
a317=a196*a317;
a114=a114*a317;
a168=a168-a114;
a114=sin(a190);
a251=a251*a219;
a114=a114*a251;
a168=a168-a114;
a114=sin(a190);
a251=a393*a409;
a114=a114*a251;
a168=a168+a114;
a114=cos(a190);
a409=a402*a409;
a114=a114*a409;
a168=a168+a114;
a114=cos(a190);
a282=a282*a053;
a114=a114*a282;
a168=a168-a114;
a114=sin(a190);
a053=a196*a053;
a114=a114*a053;
a168=a168-a114;
a114=sin(a190);
a234=a234*a306;
a114=a114*a234;
a168=a168-a114;
a190=cos(a190);
a196=a196*a320;
a190=a190*a196;
a168=a168+a190;
if (res[2]!=0) res[2][2]=a168;
a335=a335*a316;
a345=a345*a351;
a335=a335+a345;
a345=a032*a335;
a351=a345*a083;
a402=a402*a408;
a393=a393*a236;
a402=a402-a393;
a393=a032*a402;
a236=a393*a083;
a351=a351+a236;
a244=a244*a319;
a351=a351+a244;
if (res[2]!=0) res[2][3]=a351;
a171=a171*a354;
if (res[2]!=0) res[2][4]=a171;
a171=2.*a194;
a305=2.*a305;
a305=a305*a304;
a171=a171*a305;
a305=2.*a194;
a218=2.*a218;
a218=a218*a193;
a305=a305*a218;
a171=a171-a305;
a305=2.*a194;
a216=a216+a302;
a216=a216+a348;
a014=a014*a216;
a305=a305*a014;
a171=a171+a305;
a194=2.*a194;
a366=2.*a366;
a366=a366*a365;
a194=a194*a366;
a171=a171+a194;
if (res[2]!=0) res[2][5]=a171;
a018=a018/a023;
a018=a018*a026;
a026=a021*a018;
a026=-a026;
if (res[2]!=0) res[2][6]=a026;
a158=a158*a003;
a383=a158*a383;
a079=a079*a084;
a383=a383-a079;
a162=a162*a286;
a383=a383+a162;
a138=a138*a140;
a383=a383+a138;
a138=2.*a020;
a019=a019*a018;
a021=2.*a021;
a019=a019/a021;
a138=a138*a019;
a383=a383-a138;
if (res[2]!=0) res[2][7]=a383;
a117=a117*a110;
a117=-a117;
if (res[2]!=0) res[2][8]=a117;
if (res[2]!=0) res[2][9]=a110;
a110=a111*a110;
if (res[2]!=0) res[2][10]=a110;
a113=a113*a184;
if (res[2]!=0) res[2][11]=a113;
a048=a066*a048;
a134=a066*a134;
a048=a048+a134;
a108=a108/a125;
a108=a108*a367;
a126=a126/a109;
a126=a126*a135;
a108=a108-a126;
a048=a048+a108;
if (res[2]!=0) res[2][12]=a048;
a133=a133*a175;
if (res[2]!=0) res[2][13]=a133;
a139=a139*a124;
if (res[2]!=0) res[2][14]=a139;
a385=a385*a384;
a165=a165*a385;
a161=a161*a249;
a161=a032*a161;
a165=a165+a161;
if (res[2]!=0) res[2][15]=a165;
if (res[2]!=0) res[2][16]=a180;
a165=a040*a180;
if (res[2]!=0) res[2][17]=a165;
a111=a111*a180;
if (res[2]!=0) res[2][18]=a111;
a181=a163*a181;
if (res[2]!=0) res[2][19]=a181;
if (res[2]!=0) res[2][20]=a182;
a040=a040*a182;
if (res[2]!=0) res[2][21]=a040;
a106=a066*a106;
a156=a066*a156;
a106=a106+a156;
a035=a035/a145;
a035=a035*a024;
a147=a147/a144;
a147=a147*a155;
a035=a035-a147;
a106=a106+a035;
if (res[2]!=0) res[2][22]=a106;
a106=-a362;
if (res[2]!=0) res[2][23]=a106;
a399=a399*a362;
a399=-a399;
if (res[2]!=0) res[2][24]=a399;
a052=a052*a064;
if (res[2]!=0) res[2][25]=a052;
a052=a085*a202;
if (res[2]!=0) res[2][26]=a052;
a105=a105*a202;
a202=a172-a080;
a158=a158*a020;
a386=a386*a158;
a229=a163*a229;
a386=a386+a229;
a202=a202+a386;
a202=a202-a394;
a202=a202+a336;
a202=a202-a238;
a202=a202/a085;
a202=a202/a085;
a202=a202*a005;
a402=a402-a335;
a013=a013*a254;
a237=a237*a273;
a013=a013-a237;
a402=a402+a013;
a402=a402+a017;
a402=a402-a195;
a402=a402/a085;
a402=a402/a085;
a402=a402*a255;
a202=a202+a402;
a105=a105-a202;
if (res[2]!=0) res[2][27]=a105;
a174=a174*a142;
if (res[2]!=0) res[2][28]=a174;
a177=a177*a142;
if (res[2]!=0) res[2][29]=a177;
a069=a069*a173;
if (res[2]!=0) res[2][30]=a069;
a017=a017*a186;
if (res[2]!=0) res[2][31]=a017;
a017=a350+a413;
if (res[2]!=0) res[2][32]=a017;
a350=a250*a350;
a413=a250*a413;
a350=a350+a413;
if (res[2]!=0) res[2][33]=a350;
a350=a363+a264;
if (res[2]!=0) res[2][34]=a350;
a363=a250*a363;
a250=a250*a264;
a363=a363+a250;
if (res[2]!=0) res[2][35]=a363;
a315=a315*a410;
if (res[2]!=0) res[2][36]=a315;
a294=a294*a357;
a297=a297/a231;
a297=a297*a313;
a294=a294-a297;
a298=a292*a298;
a294=a294+a298;
a322=a322*a275;
a294=a294+a322;
a346=a346/a231;
a346=a346*a358;
a294=a294-a346;
a228=a339*a228;
a294=a294+a228;
a242=a242/a243;
a311=a311/a312;
a311=a311*a314;
a291=a291/a245;
a291=a291*a295;
a311=a311-a291;
a310=a310/a371;
a310=a310*a373;
a311=a311+a310;
a329=a329/a246;
a329=a329*a340;
a311=a311-a329;
a242=a242*a311;
a311=a276*a242;
a294=a294-a311;
if (res[2]!=0) res[2][37]=a294;
a296=a296*a357;
a292=a292*a313;
a296=a296-a292;
a343=a343*a275;
a296=a296+a343;
a339=a339*a358;
a296=a296-a339;
a339=a022<=a241;
a241=a241<=a022;
a241=a241+a339;
a339=a339/a241;
a231=a231*a242;
a276=2.*a276;
a231=a231/a276;
a339=a339*a231;
a296=a296-a339;
if (res[2]!=0) res[2][38]=a296;
a299=a299*a300;
a347=a347*a341;
a299=a299+a347;
if (res[2]!=0) res[2][39]=a299;
a301=a301*a303;
a344=a344*a364;
a301=a301+a344;
if (res[2]!=0) res[2][40]=a301;
a369=a369-a307;
if (res[2]!=0) res[2][41]=a369;
a289=a289*a353;
if (res[2]!=0) res[2][42]=a289;
a308=a308-a221;
if (res[2]!=0) res[2][43]=a308;
a016=a059*a016;
if (res[2]!=0) res[2][44]=a016;
a247=a247*a257;
a012=a012*a349;
a247=a247+a012;
a247=-a247;
if (res[2]!=0) res[2][45]=a247;
if (res[2]!=0) res[2][46]=a274;
a274=a188*a274;
if (res[2]!=0) res[2][47]=a274;
if (res[2]!=0) res[2][48]=a104;
a188=a188*a104;
if (res[2]!=0) res[2][49]=a188;
a203=a203*a261;
if (res[2]!=0) res[2][50]=a203;
a211=a211*a095;
a209=a209/a096;
a209=a209*a212;
a211=a211-a209;
a097=a206*a097;
a211=a211+a097;
a101=a101/a100;
a252=a252/a268;
a252=a252*a270;
a205=a205/a102;
a205=a205*a207;
a252=a252-a205;
a101=a101*a252;
a252=a099*a101;
a211=a211-a252;
if (res[2]!=0) res[2][51]=a211;
a208=a208*a095;
a206=a206*a212;
a208=a208-a206;
a206=a022<=a098;
a098=a098<=a022;
a098=a098+a206;
a206=a206/a098;
a096=a096*a101;
a099=2.*a099;
a096=a096/a099;
a206=a206*a096;
a208=a208-a206;
if (res[2]!=0) res[2][52]=a208;
a213=a213*a214;
if (res[2]!=0) res[2][53]=a213;
a215=a215*a217;
if (res[2]!=0) res[2][54]=a215;
a271=a271/a204;
if (res[2]!=0) res[2][55]=a271;
a059=a059*a377;
a059=-a059;
if (res[2]!=0) res[2][56]=a059;
a059=a332*a392;
if (res[2]!=0) res[2][57]=a059;
a086=a158*a086;
a059=a232*a086;
if (res[2]!=0) res[2][58]=a059;
a392=a058*a392;
if (res[2]!=0) res[2][59]=a392;
a163=a163*a342;
a232=2.*a232;
a083=a158*a083;
a070=a070*a083;
a232=a232*a070;
a163=a163+a232;
a381=a381*a086;
a163=a163+a381;
if (res[2]!=0) res[2][60]=a163;
if (res[2]!=0) res[2][61]=a027;
if (res[2]!=0) res[2][62]=a027;
if (res[2]!=0) res[2][63]=a027;
a396=a396*a390;
if (res[2]!=0) res[2][64]=a396;
a332=a332*a390;
if (res[2]!=0) res[2][65]=a332;
a287=a287*a083;
if (res[2]!=0) res[2][66]=a287;
a390=a058*a390;
if (res[2]!=0) res[2][67]=a390;
a044=a044*a160;
a044=-a044;
if (res[2]!=0) res[2][68]=a044;
a041=a041*a056;
if (res[2]!=0) res[2][69]=a041;
a092=a066*a092;
a066=a066*a075;
a092=a092+a066;
a036=a036/a062;
a036=a036*a091;
a063=a063/a037;
a063=a063*a074;
a036=a036-a063;
a092=a092+a036;
if (res[2]!=0) res[2][70]=a092;
a057=a057*a090;
if (res[2]!=0) res[2][71]=a057;
a058=a058*a038;
a058=-a058;
if (res[2]!=0) res[2][72]=a058;
a073=a073*a078;
a032=a032*a073;
a032=-a032;
if (res[2]!=0) res[2][73]=a032;
a077=a077*a034;
a077=-a077;
if (res[2]!=0) res[2][74]=a077;
if (res[2]!=0) res[2][75]=a027;
if (res[2]!=0) res[2][76]=a027;
if (res[2]!=0) res[2][77]=a027;
a334=a334*a158;
a391=a391*a331;
a334=a334+a391;
a080=a080*a042;
a172=a172*a045;
a080=a080+a172;
a334=a334-a080;
a393=a393*a235;
a334=a334+a393;
a345=a345*a235;
a334=a334+a345;
a394=a394*a169;
a334=a334-a394;
a336=a336*a169;
a334=a334+a336;
a238=a238*a259;
a334=a334-a238;
a334=a334/a082;
a334=a334/a082;
a334=a334*a081;
a334=-a334;
if (res[2]!=0) res[2][78]=a334;
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
casadi_real a780, a781, a782, a783, a784, a785, a786, a787, a788, a789, a790, a791;
casadi_real a792, a793, a794, a795, a796, a797, a798, a799, a800, a801, a802, a803;
casadi_real a804, a805, a806, a807, a808, a809, a810, a811, a812, a813, a814, a815;
casadi_real a816, a817, a818, a819, a820, a821, a822, a823;
a000=arg[4]? arg[4][4] : 0;
a001=arg[0]? arg[0][5] : 0;
a002=cos(a001);
a003=arg[8]? arg[8][5] : 0;
a002=a002*a003;
a002=a000*a002;
a004=sin(a001);
a005=arg[12]? arg[12][4] : 0;
a004=a004*a005;
a002=a002+a004;
a004=cos(a001);
a006=arg[12]? arg[12][3] : 0;
a004=a004*a006;
a007=arg[4]? arg[4][3] : 0;
a008=sin(a001);
a008=a008*a003;
a008=a007*a008;
a004=a004-a008;
a002=a002+a004;
a004=arg[4]? arg[4][1] : 0;
a008=arg[8]? arg[8][2] : 0;
a009=a004*a008;
a010=arg[0]? arg[0][2] : 0;
a011=arg[12]? arg[12][1] : 0;
a012=a010*a011;
a009=a009+a012;
a002=a002-a009;
a009=1000000.;
a012=arg[0]? arg[0][0] : 0;
a013=arg[1]? arg[1][0] : 0;
a014=cos(a001);
a015=a013*a014;
a016=arg[1]? arg[1][1] : 0;
a017=sin(a001);
a018=a016*a017;
a015=a015+a018;
a018=a012-a015;
a019=casadi_sq(a018);
a020=9.9999999999999995e-07;
a019=a019+a020;
a019=sqrt(a019);
a021=a018*a019;
a022=arg[1]? arg[1][2] : 0;
a023=2.*a022;
a024=arg[2]? arg[2][6] : 0;
a025=arg[2]? arg[2][7] : 0;
a026=casadi_sq(a025);
a027=9.9999999999999998e-13;
a026=a026+a027;
a026=sqrt(a026);
a028=a024*a026;
a023=a023/a028;
a021=a021+a023;
a029=a009*a021;
a030=1.;
a031=a029<=a030;
a032=a030<=a029;
a032=a032+a031;
a031=a031/a032;
a032=0.;
a033=casadi_fmin(a030,a029);
a034=a032<=a033;
a035=a033<=a032;
a035=a035+a034;
a034=a034/a035;
a035=8.;
a036=casadi_fmax(a032,a033);
a037=casadi_sq(a036);
a038=a036*a037;
a038=a020*a038;
a039=5.0000000000000000e-01;
a040=arg[2]? arg[2][73] : 0;
a040=a039*a040;
a041=arg[2]? arg[2][70] : 0;
a042=1.0000000000000001e-01;
a043=a041+a042;
a044=-a043;
a045=arg[2]? arg[2][71] : 0;
a046=arg[2]? arg[2][69] : 0;
a047=arg[2]? arg[2][1] : 0;
a048=sin(a047);
a049=a046*a048;
a050=arg[2]? arg[2][68] : 0;
a051=cos(a047);
a052=a050*a051;
a049=a049-a052;
a053=a010*a049;
a054=arg[0]? arg[0][1] : 0;
a053=a053+a054;
a055=cos(a001);
a056=a016*a055;
a057=sin(a001);
a058=a013*a057;
a056=a056-a058;
a053=a053-a056;
a058=3.;
a059=casadi_sq(a036);
a059=a058*a059;
a060=a035*a036;
a059=a059-a060;
a060=6.;
a059=a059+a060;
a061=a038*a059;
a062=-9.9999999999999995e-07;
a021=a021+a062;
a063=casadi_fmax(a032,a021);
a061=a061+a063;
a061=a061+a020;
a063=sqrt(a061);
a064=atan2(a053,a063);
a065=arg[1]? arg[1][8] : 0;
a066=arg[1]? arg[1][6] : 0;
a067=arg[2]? arg[2][56] : 0;
a068=a066*a067;
a065=a065-a068;
a068=arg[2]? arg[2][72] : 0;
a069=a065*a068;
a064=a064-a069;
a069=a045*a064;
a070=casadi_fmin(a043,a069);
a071=casadi_fmax(a044,a070);
a072=2.0000000000000001e-01;
a073=-5.;
a074=a073*a041;
a075=5.;
a076=a075*a071;
a074=a074-a076;
a074=a074+a039;
a076=casadi_fmax(a032,a074);
a077=casadi_sq(a076);
a078=a076*a077;
a078=a072*a078;
a079=a039*a076;
a079=a030-a079;
a080=a078*a079;
a080=a071+a080;
a041=a073*a041;
a071=a075*a071;
a041=a041+a071;
a041=a041+a039;
a071=casadi_fmax(a032,a041);
a081=casadi_sq(a071);
a082=a071*a081;
a082=a072*a082;
a083=a039*a071;
a083=a030-a083;
a084=a082*a083;
a080=a080-a084;
a084=a040*a080;
a085=arg[2]? arg[2][74] : 0;
a086=a084*a085;
a087=a086*a025;
a088=arg[4]? arg[4][2] : 0;
a089=arg[2]? arg[2][78] : 0;
a090=a088/a089;
a091=a049*a090;
a092=arg[2]? arg[2][27] : 0;
a093=a004/a092;
a091=a091+a093;
a094=a087*a091;
a095=casadi_sq(a053);
a095=a095+a061;
a096=a053/a095;
a097=a069<=a043;
a098=a043<=a069;
a099=a098+a097;
a097=a097/a099;
a100=a044<=a070;
a101=a070<=a044;
a102=a101+a100;
a100=a100/a102;
a103=a032<=a041;
a104=a041<=a032;
a104=a104+a103;
a103=a103/a104;
a104=casadi_sq(a053);
a104=a061+a104;
a105=a104*a091;
a106=a025*a105;
a107=a085*a106;
a108=a040*a107;
a109=a083*a108;
a109=a072*a109;
a110=a081*a109;
a111=a082*a108;
a111=a039*a111;
a110=a110-a111;
a111=2.*a071;
a112=a071*a109;
a113=a111*a112;
a110=a110+a113;
a110=a103*a110;
a110=a075*a110;
a110=a110-a108;
a113=a032<=a074;
a114=a074<=a032;
a114=a114+a113;
a113=a113/a114;
a114=a078*a108;
a114=a039*a114;
a115=a079*a108;
a115=a072*a115;
a116=a077*a115;
a114=a114-a116;
a116=2.*a076;
a117=a076*a115;
a118=a116*a117;
a114=a114-a118;
a114=a113*a114;
a114=a075*a114;
a110=a110-a114;
a110=a100*a110;
a110=a097*a110;
a114=a045*a110;
a118=a096*a114;
a119=2.*a063;
a118=a118/a119;
a120=a094+a118;
a121=a038*a120;
a122=a035*a121;
a123=2.*a036;
a121=a058*a121;
a124=a123*a121;
a122=a122-a124;
a124=a059*a120;
a124=a020*a124;
a125=a037*a124;
a122=a122-a125;
a125=2.*a036;
a126=a036*a124;
a127=a125*a126;
a122=a122-a127;
a122=a034*a122;
a122=a031*a122;
a122=a009*a122;
a127=a032<=a021;
a128=a021<=a032;
a128=a128+a127;
a127=a127/a128;
a128=a127*a120;
a122=a122-a128;
a128=2.*a018;
a129=arg[8]? arg[8][0] : 0;
a130=arg[9]? arg[9][0] : 0;
a131=a014*a130;
a132=sin(a001);
a132=a132*a003;
a133=a013*a132;
a131=a131-a133;
a133=arg[9]? arg[9][1] : 0;
a134=a017*a133;
a135=cos(a001);
a135=a135*a003;
a136=a016*a135;
a134=a134+a136;
a131=a131+a134;
a134=a129-a131;
a128=a128*a134;
a136=2.*a019;
a128=a128/a136;
a136=a122*a128;
a137=a032<=a033;
a033=a033<=a032;
a033=a033+a137;
a137=a137/a033;
a033=a029<=a030;
a029=a030<=a029;
a029=a029+a033;
a033=a033/a029;
a029=a019*a134;
a138=a018*a128;
a029=a029+a138;
a138=arg[9]? arg[9][2] : 0;
a139=2.*a138;
a139=a139/a028;
a140=a023/a028;
a141=arg[10]? arg[10][6] : 0;
a142=a026*a141;
a143=2.*a025;
a144=arg[10]? arg[10][7] : 0;
a143=a143*a144;
a145=2.*a026;
a143=a143/a145;
a145=a024*a143;
a142=a142+a145;
a140=a140*a142;
a139=a139-a140;
a029=a029+a139;
a140=a009*a029;
a033=a033*a140;
a137=a137*a033;
a033=a037*a137;
a140=2.*a036;
a140=a140*a137;
a145=a036*a140;
a033=a033+a145;
a033=a020*a033;
a145=a120*a033;
a146=arg[10]? arg[10][73] : 0;
a146=a039*a146;
a147=a080*a146;
a148=a044<=a070;
a070=a070<=a044;
a044=a070+a148;
a148=a148/a044;
a149=a043<=a069;
a069=a069<=a043;
a043=a149+a069;
a149=a149/a043;
a150=arg[10]? arg[10][70] : 0;
a149=a149*a150;
a069=a069/a043;
a043=arg[10]? arg[10][71] : 0;
a151=a064*a043;
a152=casadi_sq(a053);
a152=a152+a061;
a061=a063/a152;
a153=a049*a008;
a154=arg[10]? arg[10][69] : 0;
a155=a048*a154;
a156=cos(a047);
a157=arg[10]? arg[10][1] : 0;
a156=a156*a157;
a158=a046*a156;
a155=a155+a158;
a158=arg[10]? arg[10][68] : 0;
a159=a051*a158;
a160=sin(a047);
a160=a160*a157;
a161=a050*a160;
a159=a159-a161;
a155=a155-a159;
a161=a010*a155;
a153=a153+a161;
a161=arg[8]? arg[8][1] : 0;
a153=a153+a161;
a162=a055*a133;
a163=sin(a001);
a163=a163*a003;
a164=a016*a163;
a162=a162-a164;
a164=a057*a130;
a165=cos(a001);
a165=a165*a003;
a166=a013*a165;
a164=a164+a166;
a162=a162-a164;
a153=a153-a162;
a061=a061*a153;
a152=a053/a152;
a033=a059*a033;
a164=2.*a036;
a164=a164*a137;
a164=a058*a164;
a166=a035*a137;
a164=a164-a166;
a166=a038*a164;
a033=a033+a166;
a166=a032<=a021;
a021=a021<=a032;
a021=a021+a166;
a166=a166/a021;
a166=a166*a029;
a033=a033+a166;
a166=2.*a063;
a166=a033/a166;
a152=a152*a166;
a061=a061-a152;
a152=arg[9]? arg[9][8] : 0;
a029=arg[9]? arg[9][6] : 0;
a021=a067*a029;
a167=arg[10]? arg[10][56] : 0;
a168=a066*a167;
a021=a021+a168;
a152=a152-a021;
a021=a068*a152;
a168=arg[10]? arg[10][72] : 0;
a169=a065*a168;
a021=a021+a169;
a061=a061-a021;
a021=a045*a061;
a151=a151+a021;
a069=a069*a151;
a149=a149+a069;
a148=a148*a149;
a070=a070/a044;
a070=a070*a150;
a148=a148-a070;
a070=a032<=a074;
a074=a074<=a032;
a074=a074+a070;
a070=a070/a074;
a074=a073*a150;
a044=a075*a148;
a074=a074-a044;
a070=a070*a074;
a074=a077*a070;
a044=2.*a076;
a044=a044*a070;
a149=a076*a044;
a074=a074+a149;
a074=a072*a074;
a149=a079*a074;
a069=a039*a070;
a151=a078*a069;
a149=a149-a151;
a149=a148+a149;
a151=a032<=a041;
a041=a041<=a032;
a041=a041+a151;
a151=a151/a041;
a150=a073*a150;
a148=a075*a148;
a150=a150+a148;
a151=a151*a150;
a150=a081*a151;
a148=2.*a071;
a148=a148*a151;
a041=a071*a148;
a150=a150+a041;
a150=a072*a150;
a041=a083*a150;
a021=a039*a151;
a169=a082*a021;
a041=a041-a169;
a149=a149-a041;
a041=a040*a149;
a147=a147+a041;
a041=a085*a147;
a169=arg[10]? arg[10][74] : 0;
a170=a084*a169;
a041=a041+a170;
a170=a025*a041;
a171=a086*a144;
a170=a170+a171;
a171=a091*a170;
a172=a090*a155;
a173=arg[12]? arg[12][2] : 0;
a174=a173/a089;
a175=a090/a089;
a176=arg[10]? arg[10][78] : 0;
a175=a175*a176;
a174=a174-a175;
a175=a049*a174;
a172=a172+a175;
a175=a011/a092;
a177=a093/a092;
a178=arg[10]? arg[10][27] : 0;
a177=a177*a178;
a175=a175-a177;
a172=a172+a175;
a177=a087*a172;
a171=a171+a177;
a177=a153/a095;
a179=a096/a095;
a180=2.*a053;
a180=a180*a153;
a180=a180+a033;
a179=a179*a180;
a177=a177-a179;
a177=a114*a177;
a043=a110*a043;
a148=a109*a148;
a146=a107*a146;
a169=a106*a169;
a179=a105*a144;
a181=2.*a053;
a181=a181*a153;
a033=a033+a181;
a091=a091*a033;
a172=a104*a172;
a091=a091+a172;
a172=a025*a091;
a179=a179+a172;
a085=a085*a179;
a169=a169+a085;
a040=a040*a169;
a146=a146+a040;
a083=a083*a146;
a021=a108*a021;
a083=a083-a021;
a083=a072*a083;
a081=a081*a083;
a148=a148+a081;
a150=a108*a150;
a082=a082*a146;
a150=a150+a082;
a150=a039*a150;
a148=a148-a150;
a150=2.*a151;
a112=a112*a150;
a109=a109*a151;
a071=a071*a083;
a109=a109+a071;
a111=a111*a109;
a112=a112+a111;
a148=a148+a112;
a103=a103*a148;
a148=a075*a103;
a148=a148-a146;
a074=a108*a074;
a078=a078*a146;
a074=a074+a078;
a074=a039*a074;
a044=a115*a044;
a079=a079*a146;
a108=a108*a069;
a079=a079-a108;
a079=a072*a079;
a077=a077*a079;
a044=a044+a077;
a074=a074-a044;
a044=2.*a070;
a117=a117*a044;
a115=a115*a070;
a076=a076*a079;
a115=a115+a076;
a116=a116*a115;
a117=a117+a116;
a074=a074-a117;
a113=a113*a074;
a074=a075*a113;
a148=a148-a074;
a100=a100*a148;
a097=a097*a100;
a045=a045*a097;
a043=a043+a045;
a096=a096*a043;
a177=a177+a096;
a177=a177/a119;
a118=a118/a119;
a119=2.*a166;
a118=a118*a119;
a177=a177-a118;
a177=a171+a177;
a038=a038*a177;
a145=a145+a038;
a038=a035*a145;
a118=2.*a137;
a121=a121*a118;
a145=a058*a145;
a123=a123*a145;
a121=a121+a123;
a038=a038-a121;
a140=a124*a140;
a120=a120*a164;
a059=a059*a177;
a120=a120+a059;
a120=a020*a120;
a037=a037*a120;
a140=a140+a037;
a038=a038-a140;
a140=2.*a137;
a126=a126*a140;
a124=a124*a137;
a036=a036*a120;
a124=a124+a036;
a125=a125*a124;
a126=a126+a125;
a038=a038-a126;
a034=a034*a038;
a031=a031*a034;
a031=a009*a031;
a127=a127*a177;
a031=a031-a127;
a127=a019*a031;
a136=a136+a127;
a127=a018*a122;
a177=2.*a019;
a127=a127/a177;
a034=2.*a134;
a034=a127*a034;
a038=2.*a018;
a134=a122*a134;
a018=a018*a031;
a134=a134+a018;
a134=a134/a177;
a177=a127/a177;
a128=2.*a128;
a177=a177*a128;
a134=a134-a177;
a134=a038*a134;
a034=a034+a134;
a136=a136+a034;
a002=a002+a136;
a034=arg[2]? arg[2][25] : 0;
a134=cos(a047);
a177=a034*a134;
a128=arg[2]? arg[2][30] : 0;
a018=sin(a047);
a126=a128*a018;
a125=a177+a126;
a124=a010*a125;
a124=a124+a054;
a036=arg[2]? arg[2][44] : 0;
a120=a066*a036;
a137=arg[1]? arg[1][7] : 0;
a120=a120+a137;
a137=arg[2]? arg[2][45] : 0;
a140=a030-a137;
a037=a120*a140;
a059=cos(a037);
a164=a124*a059;
a121=sin(a037);
a123=a012*a121;
a164=a164-a123;
a123=2.*a164;
a145=arg[2]? arg[2][54] : 0;
a118=arg[2]? arg[2][53] : 0;
a119=arg[2]? arg[2][51] : 0;
a096=arg[2]? arg[2][52] : 0;
a045=a096-a030;
a074=casadi_fmax(a027,a045);
a074=sqrt(a074);
a117=a119*a074;
a116=1./a117;
a115=-a116;
a076=arg[2]? arg[2][46] : 0;
a079=arg[2]? arg[2][47] : 0;
a070=arg[2]? arg[2][26] : 0;
a044=a070*a092;
a077=arg[2]? arg[2][12] : 0;
a108=a077+a042;
a069=-a108;
a146=arg[2]? arg[2][11] : 0;
a078=arg[1]? arg[1][3] : 0;
a112=arg[2]? arg[2][10] : 0;
a111=a078*a112;
a109=arg[2]? arg[2][9] : 0;
a111=a111+a109;
a109=arg[2]? arg[2][8] : 0;
a109=a030-a109;
a071=a012-a015;
a083=casadi_sq(a071);
a083=a083+a020;
a083=sqrt(a083);
a151=a071*a083;
a151=a151+a023;
a150=a009*a151;
a082=casadi_fmin(a030,a150);
a081=casadi_fmax(a032,a082);
a021=casadi_sq(a081);
a040=a081*a021;
a040=a020*a040;
a085=casadi_sq(a081);
a085=a058*a085;
a172=a035*a081;
a085=a085-a172;
a085=a085+a060;
a172=a040*a085;
a062=a062+a151;
a151=casadi_fmax(a032,a062);
a172=a172+a151;
a172=a172+a020;
a151=sqrt(a172);
a151=atan2(a032,a151);
a151=a047+a151;
a181=a109*a151;
a111=a111+a181;
a181=a146*a111;
a182=casadi_fmin(a108,a181);
a183=casadi_fmax(a069,a182);
a184=a073*a077;
a185=a075*a183;
a184=a184-a185;
a184=a184+a039;
a185=casadi_fmax(a032,a184);
a186=casadi_sq(a185);
a187=a185*a186;
a187=a072*a187;
a188=a039*a185;
a188=a030-a188;
a189=a187*a188;
a189=a183+a189;
a077=a073*a077;
a183=a075*a183;
a077=a077+a183;
a077=a077+a039;
a183=casadi_fmax(a032,a077);
a190=casadi_sq(a183);
a191=a183*a190;
a191=a072*a191;
a192=a039*a183;
a192=a030-a192;
a193=a191*a192;
a189=a189-a193;
a189=a039*a189;
a193=arg[2]? arg[2][13] : 0;
a194=a189*a193;
a195=a194*a025;
a196=arg[2]? arg[2][14] : 0;
a197=a195*a196;
a198=a197*a172;
a044=a044-a198;
a199=arg[2]? arg[2][22] : 0;
a042=a199+a042;
a200=-a042;
a201=arg[2]? arg[2][20] : 0;
a202=arg[2]? arg[2][21] : 0;
a203=a202*a047;
a201=a201+a203;
a203=casadi_fmin(a042,a201);
a204=casadi_fmax(a200,a203);
a205=a073*a199;
a206=a075*a204;
a205=a205-a206;
a205=a205+a039;
a206=casadi_fmax(a032,a205);
a207=casadi_sq(a206);
a208=a206*a207;
a208=a072*a208;
a209=a039*a206;
a209=a030-a209;
a210=a208*a209;
a210=a204+a210;
a199=a073*a199;
a204=a075*a204;
a199=a199+a204;
a199=a199+a039;
a204=casadi_fmax(a032,a199);
a211=casadi_sq(a204);
a212=a204*a211;
a212=a072*a212;
a213=a039*a204;
a213=a030-a213;
a214=a212*a213;
a210=a210-a214;
a214=arg[2]? arg[2][15] : 0;
a215=a039*a214;
a015=a012-a015;
a216=casadi_sq(a015);
a217=1.0000000000000000e-08;
a216=a216+a217;
a056=a054-a056;
a217=casadi_sq(a056);
a217=a216+a217;
a218=a215*a217;
a219=a218*a025;
a220=a210*a219;
a221=a220*a015;
a222=sqrt(a216);
a221=a221/a222;
a044=a044-a221;
a223=arg[2]? arg[2][0] : 0;
a224=cos(a047);
a225=a223*a224;
a226=arg[2]? arg[2][4] : 0;
a227=sin(a047);
a228=a226*a227;
a225=a225+a228;
a228=a044*a225;
a229=arg[2]? arg[2][28] : 0;
a230=cos(a047);
a231=a229*a230;
a232=arg[2]? arg[2][29] : 0;
a233=sin(a047);
a234=a232*a233;
a231=a231+a234;
a234=a198*a231;
a235=arg[2]? arg[2][19] : 0;
a236=a235*a219;
a237=arg[2]? arg[2][16] : 0;
a238=arg[2]? arg[2][17] : 0;
a239=a238*a047;
a237=a237+a239;
a239=arg[2]? arg[2][18] : 0;
a240=a239*a078;
a237=a237+a240;
a240=a236*a237;
a234=a234+a240;
a240=arg[2]? arg[2][31] : 0;
a241=a022*a240;
a242=cos(a047);
a243=a241*a242;
a234=a234+a243;
a228=a228+a234;
a243=a177+a126;
a243=a225-a243;
a228=a228/a243;
a244=casadi_fmax(a032,a228);
a245=a079*a244;
a076=a076+a245;
a245=casadi_fmax(a032,a076);
a246=cos(a037);
a247=a012*a246;
a248=sin(a037);
a249=a124*a248;
a247=a247+a249;
a249=casadi_sq(a247);
a250=arg[2]? arg[2][5] : 0;
a251=casadi_sq(a250);
a251=a020*a251;
a249=a249+a251;
a252=sqrt(a249);
a253=a164/a252;
a254=a245*a253;
a255=arg[2]? arg[2][50] : 0;
a256=1.0000000000000000e-03;
a257=arg[2]? arg[2][48] : 0;
a258=arg[2]? arg[2][49] : 0;
a259=a258*a244;
a257=a257+a259;
a259=casadi_fmax(a256,a257);
a260=a255*a259;
a254=a254/a260;
a261=casadi_fmin(a254,a116);
a262=casadi_fmax(a115,a261);
a263=a119*a262;
a264=atan(a263);
a265=a096*a264;
a265=a265/a119;
a266=a096-a030;
a267=a262*a266;
a267=a265-a267;
a268=a119*a267;
a269=atan(a268);
a270=a118*a269;
a271=sin(a270);
a272=a145*a271;
a273=casadi_sq(a164);
a273=a273+a249;
a273=sqrt(a273);
a249=a272*a273;
a274=casadi_sq(a250);
a275=casadi_sq(a274);
a276=casadi_sq(a247);
a277=casadi_sq(a164);
a276=a276+a277;
a277=casadi_sq(a276);
a275=a275+a277;
a275=sqrt(a275);
a277=sqrt(a275);
a249=a249/a277;
a278=arg[2]? arg[2][55] : 0;
a278=a278/a260;
a279=5.0000000000000004e-06;
a280=a278+a279;
a281=-a280;
a282=a247/a277;
a283=casadi_fmin(a280,a282);
a284=casadi_fmax(a281,a283);
a285=1.0000000000000001e-05;
a286=-100000.;
a287=a286*a278;
a288=100000.;
a289=a288*a284;
a287=a287-a289;
a287=a287+a039;
a289=casadi_fmax(a032,a287);
a290=casadi_sq(a289);
a291=a289*a290;
a291=a285*a291;
a292=a039*a289;
a292=a030-a292;
a293=a291*a292;
a293=a284+a293;
a294=a286*a278;
a284=a288*a284;
a294=a294+a284;
a294=a294+a039;
a284=casadi_fmax(a032,a294);
a295=casadi_sq(a284);
a296=a284*a295;
a296=a285*a296;
a297=a039*a284;
a297=a030-a297;
a298=a296*a297;
a293=a293-a298;
a298=casadi_sq(a293);
a298=a030-a298;
a298=sqrt(a298);
a299=a298+a279;
a300=a249<=a299;
a301=a299<=a249;
a302=a300+a301;
a300=a300/a302;
a303=-a299;
a304=casadi_fmin(a249,a299);
a305=a303<=a304;
a306=a304<=a303;
a307=a306+a305;
a305=a305/a307;
a308=a286*a298;
a309=casadi_fmax(a303,a304);
a310=a288*a309;
a308=a308+a310;
a308=a308+a039;
a310=a032<=a308;
a311=a308<=a032;
a311=a311+a310;
a310=a310/a311;
a311=casadi_fmax(a032,a308);
a312=casadi_sq(a311);
a313=a311*a312;
a313=a285*a313;
a137=a030-a137;
a314=sin(a037);
a315=arg[4]? arg[4][0] : 0;
a316=a315/a092;
a317=a314*a316;
a318=cos(a037);
a319=a177+a126;
a320=a319*a090;
a320=a320+a093;
a321=a318*a320;
a317=a317-a321;
a321=a137*a317;
a322=a260*a321;
a323=a244*a322;
a324=a313*a323;
a324=a039*a324;
a325=a039*a311;
a325=a030-a325;
a326=a325*a323;
a326=a285*a326;
a327=a312*a326;
a324=a324-a327;
a327=2.*a311;
a328=a311*a326;
a329=a327*a328;
a324=a324-a329;
a324=a310*a324;
a329=a288*a324;
a329=a329+a323;
a330=a286*a298;
a331=a288*a309;
a330=a330-a331;
a330=a330+a039;
a331=a032<=a330;
a332=a330<=a032;
a332=a332+a331;
a331=a331/a332;
a332=casadi_fmax(a032,a330);
a333=casadi_sq(a332);
a334=a039*a332;
a334=a030-a334;
a335=a334*a323;
a335=a285*a335;
a336=a333*a335;
a337=a332*a333;
a337=a285*a337;
a338=a337*a323;
a338=a039*a338;
a336=a336-a338;
a338=2.*a332;
a339=a332*a335;
a340=a338*a339;
a336=a336+a340;
a336=a331*a336;
a340=a288*a336;
a329=a329-a340;
a340=a305*a329;
a341=a300*a340;
a342=a341/a277;
a343=a272*a342;
a344=2.*a273;
a343=a343/a344;
a345=a123*a343;
a346=a254<=a116;
a347=a116<=a254;
a348=a346+a347;
a346=a346/a348;
a349=a115<=a261;
a350=a261<=a115;
a351=a350+a349;
a349=a349/a351;
a352=cos(a270);
a353=a273*a342;
a354=a145*a353;
a355=a352*a354;
a356=a118*a355;
a357=casadi_sq(a268);
a357=a030+a357;
a356=a356/a357;
a358=a096*a356;
a359=casadi_sq(a263);
a359=a030+a359;
a358=a358/a359;
a360=a119*a358;
a361=a119*a356;
a362=a266*a361;
a360=a360-a362;
a362=a349*a360;
a363=a346*a362;
a364=a363/a260;
a365=a245*a364;
a366=a365/a252;
a345=a345+a366;
a367=2.*a164;
a368=2.*a276;
a369=a249/a277;
a370=a369*a341;
a371=a282/a277;
a372=a282<=a280;
a373=a280<=a282;
a374=a373+a372;
a372=a372/a374;
a375=a281<=a283;
a376=a283<=a281;
a377=a376+a375;
a375=a375/a377;
a378=a032<=a294;
a379=a294<=a032;
a379=a379+a378;
a378=a378/a379;
a379=sin(a037);
a380=a379*a320;
a381=cos(a037);
a382=a381*a316;
a380=a380+a382;
a382=a260*a380;
a383=a244*a382;
a384=2.*a293;
a324=a286*a324;
a336=a286*a336;
a324=a324+a336;
a301=a301/a302;
a340=a301*a340;
a306=a306/a307;
a329=a306*a329;
a340=a340-a329;
a324=a324+a340;
a340=2.*a298;
a324=a324/a340;
a329=a384*a324;
a383=a383+a329;
a329=a297*a383;
a329=a285*a329;
a307=a295*a329;
a302=a296*a383;
a302=a039*a302;
a307=a307-a302;
a302=2.*a284;
a336=a284*a329;
a385=a302*a336;
a307=a307+a385;
a307=a378*a307;
a385=a288*a307;
a385=a385-a383;
a386=a032<=a287;
a387=a287<=a032;
a387=a387+a386;
a386=a386/a387;
a387=a291*a383;
a387=a039*a387;
a388=a292*a383;
a388=a285*a388;
a389=a290*a388;
a387=a387-a389;
a389=2.*a289;
a390=a289*a388;
a391=a389*a390;
a387=a387-a391;
a387=a386*a387;
a391=a288*a387;
a385=a385-a391;
a391=a375*a385;
a392=a372*a391;
a393=a371*a392;
a370=a370+a393;
a393=2.*a277;
a370=a370/a393;
a394=2.*a275;
a395=a370/a394;
a396=a368*a395;
a397=a367*a396;
a345=a345-a397;
a397=cos(a037);
a398=a036*a029;
a399=arg[10]? arg[10][44] : 0;
a400=a066*a399;
a398=a398+a400;
a400=arg[9]? arg[9][7] : 0;
a398=a398+a400;
a400=a140*a398;
a401=arg[10]? arg[10][45] : 0;
a402=a120*a401;
a400=a400-a402;
a397=a397*a400;
a402=a345*a397;
a403=a125*a008;
a404=arg[10]? arg[10][25] : 0;
a405=a134*a404;
a406=sin(a047);
a406=a406*a157;
a407=a034*a406;
a405=a405-a407;
a407=arg[10]? arg[10][30] : 0;
a408=a018*a407;
a409=cos(a047);
a409=a409*a157;
a410=a128*a409;
a408=a408+a410;
a410=a405+a408;
a411=a010*a410;
a403=a403+a411;
a403=a403+a161;
a411=a059*a403;
a412=sin(a037);
a412=a412*a400;
a413=a124*a412;
a411=a411-a413;
a413=a121*a129;
a397=a012*a397;
a413=a413+a397;
a411=a411-a413;
a413=2.*a411;
a413=a343*a413;
a397=arg[10]? arg[10][54] : 0;
a414=a271*a397;
a415=cos(a270);
a416=arg[10]? arg[10][53] : 0;
a417=a269*a416;
a418=arg[10]? arg[10][51] : 0;
a419=a267*a418;
a420=arg[10]? arg[10][52] : 0;
a421=a264*a420;
a422=a262*a418;
a423=a261<=a115;
a115=a115<=a261;
a261=a423+a115;
a423=a423/a261;
a424=a116/a117;
a425=a074*a418;
a426=a027<=a045;
a427=a045<=a027;
a427=a427+a426;
a426=a426/a427;
a426=a426*a420;
a427=2.*a074;
a426=a426/a427;
a427=a119*a426;
a425=a425+a427;
a424=a424*a425;
a423=a423*a424;
a115=a115/a261;
a261=a254<=a116;
a427=a116<=a254;
a428=a261+a427;
a261=a261/a428;
a429=a032<=a076;
a430=a076<=a032;
a430=a430+a429;
a429=a429/a430;
a430=arg[10]? arg[10][46] : 0;
a431=arg[10]? arg[10][47] : 0;
a432=a244*a431;
a433=a032<=a228;
a434=a228<=a032;
a434=a434+a433;
a433=a433/a434;
a434=arg[10]? arg[10][26] : 0;
a435=a092*a434;
a436=a070*a178;
a435=a435+a436;
a436=a069<=a182;
a437=a182<=a069;
a438=a437+a436;
a436=a436/a438;
a439=a108<=a181;
a440=a181<=a108;
a441=a439+a440;
a439=a439/a441;
a442=arg[10]? arg[10][12] : 0;
a439=a439*a442;
a440=a440/a441;
a441=arg[10]? arg[10][11] : 0;
a443=a111*a441;
a444=arg[9]? arg[9][3] : 0;
a445=a112*a444;
a446=arg[10]? arg[10][10] : 0;
a447=a078*a446;
a445=a445+a447;
a447=arg[10]? arg[10][9] : 0;
a445=a445+a447;
a447=a109*a157;
a448=arg[10]? arg[10][8] : 0;
a449=a151*a448;
a447=a447-a449;
a445=a445+a447;
a447=a146*a445;
a443=a443+a447;
a440=a440*a443;
a439=a439+a440;
a436=a436*a439;
a437=a437/a438;
a437=a437*a442;
a436=a436-a437;
a437=a032<=a184;
a438=a184<=a032;
a438=a438+a437;
a437=a437/a438;
a438=a073*a442;
a439=a075*a436;
a438=a438-a439;
a437=a437*a438;
a438=a186*a437;
a439=2.*a185;
a439=a439*a437;
a440=a185*a439;
a438=a438+a440;
a438=a072*a438;
a440=a188*a438;
a443=a039*a437;
a447=a187*a443;
a440=a440-a447;
a440=a436+a440;
a447=a032<=a077;
a449=a077<=a032;
a449=a449+a447;
a447=a447/a449;
a442=a073*a442;
a436=a075*a436;
a442=a442+a436;
a447=a447*a442;
a442=a190*a447;
a436=2.*a183;
a436=a436*a447;
a449=a183*a436;
a442=a442+a449;
a442=a072*a442;
a449=a192*a442;
a450=a039*a447;
a451=a191*a450;
a449=a449-a451;
a440=a440-a449;
a440=a039*a440;
a449=a193*a440;
a451=arg[10]? arg[10][13] : 0;
a452=a189*a451;
a449=a449+a452;
a452=a025*a449;
a453=a194*a144;
a452=a452+a453;
a453=a196*a452;
a454=arg[10]? arg[10][14] : 0;
a455=a195*a454;
a453=a453+a455;
a455=a172*a453;
a456=a032<=a082;
a457=a082<=a032;
a457=a457+a456;
a456=a456/a457;
a457=a150<=a030;
a458=a030<=a150;
a458=a458+a457;
a457=a457/a458;
a458=a129-a131;
a459=a083*a458;
a460=2.*a071;
a460=a460*a458;
a461=2.*a083;
a460=a460/a461;
a461=a071*a460;
a459=a459+a461;
a459=a459+a139;
a461=a009*a459;
a457=a457*a461;
a456=a456*a457;
a457=a021*a456;
a461=2.*a081;
a461=a461*a456;
a462=a081*a461;
a457=a457+a462;
a457=a020*a457;
a462=a085*a457;
a463=2.*a081;
a463=a463*a456;
a463=a058*a463;
a464=a035*a456;
a463=a463-a464;
a464=a040*a463;
a462=a462+a464;
a464=a032<=a062;
a465=a062<=a032;
a465=a465+a464;
a464=a464/a465;
a464=a464*a459;
a462=a462+a464;
a464=a197*a462;
a455=a455+a464;
a435=a435-a455;
a464=a200<=a203;
a459=a203<=a200;
a465=a459+a464;
a464=a464/a465;
a466=a042<=a201;
a467=a201<=a042;
a468=a466+a467;
a466=a466/a468;
a469=arg[10]? arg[10][22] : 0;
a466=a466*a469;
a467=a467/a468;
a468=arg[10]? arg[10][20] : 0;
a470=arg[10]? arg[10][21] : 0;
a471=a047*a470;
a472=a202*a157;
a471=a471+a472;
a468=a468+a471;
a467=a467*a468;
a466=a466+a467;
a464=a464*a466;
a459=a459/a465;
a459=a459*a469;
a464=a464-a459;
a459=a032<=a205;
a465=a205<=a032;
a465=a465+a459;
a459=a459/a465;
a465=a073*a469;
a466=a075*a464;
a465=a465-a466;
a459=a459*a465;
a465=a207*a459;
a466=2.*a206;
a466=a466*a459;
a467=a206*a466;
a465=a465+a467;
a465=a072*a465;
a467=a209*a465;
a468=a039*a459;
a471=a208*a468;
a467=a467-a471;
a467=a464+a467;
a471=a032<=a199;
a472=a199<=a032;
a472=a472+a471;
a471=a471/a472;
a469=a073*a469;
a464=a075*a464;
a469=a469+a464;
a471=a471*a469;
a469=a211*a471;
a464=2.*a204;
a464=a464*a471;
a472=a204*a464;
a469=a469+a472;
a469=a072*a469;
a472=a213*a469;
a473=a039*a471;
a474=a212*a473;
a472=a472-a474;
a467=a467-a472;
a472=a219*a467;
a474=arg[10]? arg[10][15] : 0;
a475=a039*a474;
a476=a217*a475;
a477=2.*a015;
a131=a129-a131;
a477=a477*a131;
a478=2.*a056;
a162=a161-a162;
a478=a478*a162;
a478=a477+a478;
a479=a215*a478;
a476=a476+a479;
a479=a025*a476;
a480=a218*a144;
a479=a479+a480;
a480=a210*a479;
a472=a472+a480;
a480=a015*a472;
a481=a220*a131;
a480=a480+a481;
a480=a480/a222;
a481=a221/a222;
a482=2.*a222;
a482=a477/a482;
a481=a481*a482;
a480=a480-a481;
a435=a435-a480;
a481=a225*a435;
a483=arg[10]? arg[10][0] : 0;
a484=a224*a483;
a485=sin(a047);
a485=a485*a157;
a486=a223*a485;
a484=a484-a486;
a486=arg[10]? arg[10][4] : 0;
a487=a227*a486;
a488=cos(a047);
a488=a488*a157;
a489=a226*a488;
a487=a487+a489;
a484=a484+a487;
a487=a044*a484;
a481=a481+a487;
a487=a231*a455;
a489=arg[10]? arg[10][28] : 0;
a490=a230*a489;
a491=sin(a047);
a491=a491*a157;
a492=a229*a491;
a490=a490-a492;
a492=arg[10]? arg[10][29] : 0;
a493=a233*a492;
a494=cos(a047);
a494=a494*a157;
a495=a232*a494;
a493=a493+a495;
a490=a490+a493;
a493=a198*a490;
a487=a487+a493;
a493=arg[10]? arg[10][19] : 0;
a495=a219*a493;
a496=a235*a479;
a495=a495+a496;
a496=a237*a495;
a497=arg[10]? arg[10][16] : 0;
a498=arg[10]? arg[10][17] : 0;
a499=a047*a498;
a500=a238*a157;
a499=a499+a500;
a497=a497+a499;
a499=arg[10]? arg[10][18] : 0;
a500=a078*a499;
a501=a239*a444;
a500=a500+a501;
a497=a497+a500;
a500=a236*a497;
a496=a496+a500;
a487=a487+a496;
a496=a240*a138;
a500=arg[10]? arg[10][31] : 0;
a501=a022*a500;
a496=a496+a501;
a501=a242*a496;
a502=sin(a047);
a502=a502*a157;
a503=a241*a502;
a501=a501-a503;
a487=a487+a501;
a481=a481+a487;
a481=a481/a243;
a501=a228/a243;
a503=a405+a408;
a503=a484-a503;
a501=a501*a503;
a481=a481-a501;
a433=a433*a481;
a501=a079*a433;
a432=a432+a501;
a430=a430+a432;
a429=a429*a430;
a430=a253*a429;
a432=a411/a252;
a501=a253/a252;
a504=2.*a247;
a505=a246*a129;
a506=sin(a037);
a506=a506*a400;
a507=a012*a506;
a505=a505-a507;
a507=a248*a403;
a508=cos(a037);
a508=a508*a400;
a509=a124*a508;
a507=a507+a509;
a505=a505+a507;
a504=a504*a505;
a507=2.*a250;
a509=arg[10]? arg[10][5] : 0;
a507=a507*a509;
a507=a020*a507;
a504=a504+a507;
a510=2.*a252;
a510=a504/a510;
a501=a501*a510;
a432=a432-a501;
a501=a245*a432;
a430=a430+a501;
a430=a430/a260;
a501=a254/a260;
a511=arg[10]? arg[10][50] : 0;
a512=a259*a511;
a513=a256<=a257;
a514=a257<=a256;
a514=a514+a513;
a513=a513/a514;
a514=arg[10]? arg[10][48] : 0;
a515=arg[10]? arg[10][49] : 0;
a516=a244*a515;
a517=a258*a433;
a516=a516+a517;
a514=a514+a516;
a513=a513*a514;
a514=a255*a513;
a512=a512+a514;
a501=a501*a512;
a430=a430-a501;
a261=a261*a430;
a427=a427/a428;
a427=a427*a424;
a261=a261-a427;
a115=a115*a261;
a423=a423+a115;
a115=a119*a423;
a422=a422+a115;
a115=casadi_sq(a263);
a115=a030+a115;
a115=a422/a115;
a261=a096*a115;
a421=a421+a261;
a421=a421/a119;
a261=a265/a119;
a261=a261*a418;
a421=a421-a261;
a261=a266*a423;
a427=a262*a420;
a261=a261+a427;
a261=a421-a261;
a427=a119*a261;
a419=a419+a427;
a427=casadi_sq(a268);
a427=a030+a427;
a427=a419/a427;
a428=a118*a427;
a417=a417+a428;
a415=a415*a417;
a428=a145*a415;
a414=a414+a428;
a428=a342*a414;
a501=a032<=a308;
a308=a308<=a032;
a308=a308+a501;
a501=a501/a308;
a308=a304<=a303;
a303=a303<=a304;
a304=a308+a303;
a308=a308/a304;
a514=2.*a293;
a516=a281<=a283;
a283=a283<=a281;
a281=a283+a516;
a516=a516/a281;
a517=a280<=a282;
a280=a282<=a280;
a518=a517+a280;
a517=a517/a518;
a519=arg[10]? arg[10][55] : 0;
a519=a519/a260;
a520=a278/a260;
a520=a520*a512;
a519=a519-a520;
a517=a517*a519;
a280=a280/a518;
a518=a505/a277;
a282=a282/a277;
a520=2.*a274;
a521=2.*a250;
a521=a521*a509;
a520=a520*a521;
a276=2.*a276;
a522=2.*a247;
a522=a522*a505;
a523=2.*a164;
a523=a523*a411;
a522=a522+a523;
a276=a276*a522;
a520=a520+a276;
a275=2.*a275;
a520=a520/a275;
a275=2.*a277;
a275=a520/a275;
a282=a282*a275;
a518=a518-a282;
a280=a280*a518;
a517=a517+a280;
a516=a516*a517;
a283=a283/a281;
a283=a283*a519;
a516=a516-a283;
a283=a032<=a287;
a287=a287<=a032;
a287=a287+a283;
a283=a283/a287;
a287=a286*a519;
a281=a288*a516;
a287=a287-a281;
a283=a283*a287;
a287=a290*a283;
a281=2.*a289;
a281=a281*a283;
a517=a289*a281;
a287=a287+a517;
a287=a285*a287;
a517=a292*a287;
a280=a039*a283;
a282=a291*a280;
a517=a517-a282;
a517=a516+a517;
a282=a032<=a294;
a294=a294<=a032;
a294=a294+a282;
a282=a282/a294;
a294=a286*a519;
a516=a288*a516;
a294=a294+a516;
a282=a282*a294;
a294=a295*a282;
a516=2.*a284;
a516=a516*a282;
a276=a284*a516;
a294=a294+a276;
a294=a285*a294;
a276=a297*a294;
a523=a039*a282;
a524=a296*a523;
a276=a276-a524;
a517=a517-a276;
a514=a514*a517;
a298=2.*a298;
a514=a514/a298;
a308=a308*a514;
a303=a303/a304;
a304=a249<=a299;
a299=a299<=a249;
a298=a304+a299;
a304=a304/a298;
a414=a273*a414;
a164=2.*a164;
a164=a164*a411;
a164=a164+a504;
a504=2.*a273;
a164=a164/a504;
a504=a272*a164;
a414=a414+a504;
a414=a414/a277;
a249=a249/a277;
a249=a249*a275;
a414=a414-a249;
a304=a304*a414;
a299=a299/a298;
a299=a299*a514;
a304=a304-a299;
a303=a303*a304;
a308=a308+a303;
a303=a288*a308;
a304=a286*a514;
a303=a303-a304;
a501=a501*a303;
a303=a312*a501;
a304=2.*a311;
a304=a304*a501;
a299=a311*a304;
a303=a303+a299;
a303=a285*a303;
a299=a323*a303;
a298=a322*a433;
a249=a321*a512;
a504=cos(a037);
a504=a504*a400;
a276=a316*a504;
a524=arg[12]? arg[12][0] : 0;
a525=a524/a092;
a526=a316/a092;
a526=a526*a178;
a525=a525-a526;
a526=a314*a525;
a276=a276+a526;
a526=a405+a408;
a527=a090*a526;
a528=a319*a174;
a527=a527+a528;
a527=a527+a175;
a528=a318*a527;
a529=sin(a037);
a529=a529*a400;
a530=a320*a529;
a528=a528-a530;
a276=a276-a528;
a528=a137*a276;
a530=a317*a401;
a528=a528-a530;
a530=a260*a528;
a249=a249+a530;
a530=a244*a249;
a298=a298+a530;
a530=a313*a298;
a299=a299+a530;
a299=a039*a299;
a304=a326*a304;
a530=a325*a298;
a531=a039*a501;
a532=a323*a531;
a530=a530-a532;
a530=a285*a530;
a312=a312*a530;
a304=a304+a312;
a299=a299-a304;
a304=2.*a501;
a328=a328*a304;
a326=a326*a501;
a311=a311*a530;
a326=a326+a311;
a327=a327*a326;
a328=a328+a327;
a299=a299-a328;
a310=a310*a299;
a299=a288*a310;
a299=a299+a298;
a328=a032<=a330;
a330=a330<=a032;
a330=a330+a328;
a328=a328/a330;
a330=a286*a514;
a327=a288*a308;
a330=a330+a327;
a328=a328*a330;
a330=a039*a328;
a327=a323*a330;
a326=a334*a298;
a327=a327+a326;
a327=a285*a327;
a326=a333*a327;
a311=2.*a332;
a311=a311*a328;
a530=a335*a311;
a326=a326-a530;
a298=a337*a298;
a333=a333*a328;
a311=a332*a311;
a333=a333+a311;
a333=a285*a333;
a323=a323*a333;
a298=a298-a323;
a298=a039*a298;
a326=a326-a298;
a298=-a328;
a298=2.*a298;
a339=a339*a298;
a332=a332*a327;
a335=a335*a328;
a332=a332-a335;
a338=a338*a332;
a339=a339+a338;
a326=a326+a339;
a331=a331*a326;
a326=a288*a331;
a299=a299-a326;
a305=a305*a299;
a300=a300*a305;
a326=a300/a277;
a339=a342/a277;
a339=a339*a275;
a326=a326-a339;
a272=a272*a326;
a428=a428+a272;
a428=a428/a344;
a344=a343/a344;
a272=2.*a164;
a344=a344*a272;
a428=a428-a344;
a123=a123*a428;
a413=a413+a123;
a429=a364*a429;
a123=a358*a418;
a344=a356*a420;
a416=a355*a416;
a397=a353*a397;
a342=a342*a164;
a273=a273*a326;
a342=a342+a273;
a145=a145*a342;
a397=a397+a145;
a352=a352*a397;
a270=sin(a270);
a270=a270*a417;
a354=a354*a270;
a352=a352-a354;
a118=a118*a352;
a416=a416+a118;
a416=a416/a357;
a357=a356/a357;
a268=2.*a268;
a268=a268*a419;
a357=a357*a268;
a416=a416-a357;
a096=a096*a416;
a344=a344+a096;
a344=a344/a359;
a359=a358/a359;
a263=2.*a263;
a263=a263*a422;
a359=a359*a263;
a344=a344-a359;
a359=a119*a344;
a123=a123+a359;
a420=a361*a420;
a359=a356*a418;
a263=a119*a416;
a359=a359+a263;
a266=a266*a359;
a420=a420+a266;
a123=a123-a420;
a349=a349*a123;
a346=a346*a349;
a420=a346/a260;
a266=a364/a260;
a266=a266*a512;
a420=a420-a266;
a245=a245*a420;
a429=a429+a245;
a245=a429/a252;
a366=a366/a252;
a366=a366*a510;
a245=a245-a366;
a413=a413+a245;
a411=2.*a411;
a411=a396*a411;
a522=2.*a522;
a522=a395*a522;
a414=a414/a277;
a245=a369/a277;
a245=a245*a275;
a414=a414-a245;
a341=a341*a414;
a369=a369*a300;
a341=a341+a369;
a518=a518/a277;
a369=a371/a277;
a369=a369*a275;
a518=a518-a369;
a518=a392*a518;
a516=a329*a516;
a369=a382*a433;
a300=a380*a512;
a414=cos(a037);
a414=a414*a400;
a245=a320*a414;
a366=a379*a527;
a245=a245+a366;
a366=a381*a525;
a266=sin(a037);
a266=a266*a400;
a263=a316*a266;
a366=a366-a263;
a245=a245+a366;
a366=a260*a245;
a300=a300+a366;
a366=a244*a300;
a369=a369+a366;
a366=2.*a517;
a366=a324*a366;
a310=a286*a310;
a331=a286*a331;
a310=a310+a331;
a301=a301*a305;
a306=a306*a299;
a301=a301-a306;
a310=a310+a301;
a310=a310/a340;
a324=a324/a340;
a514=-a514;
a514=2.*a514;
a324=a324*a514;
a310=a310-a324;
a384=a384*a310;
a366=a366+a384;
a369=a369+a366;
a297=a297*a369;
a523=a383*a523;
a297=a297-a523;
a297=a285*a297;
a295=a295*a297;
a516=a516+a295;
a294=a383*a294;
a296=a296*a369;
a294=a294+a296;
a294=a039*a294;
a516=a516-a294;
a294=2.*a282;
a336=a336*a294;
a329=a329*a282;
a284=a284*a297;
a329=a329+a284;
a302=a302*a329;
a336=a336+a302;
a516=a516+a336;
a378=a378*a516;
a516=a288*a378;
a516=a516-a369;
a287=a383*a287;
a291=a291*a369;
a287=a287+a291;
a287=a039*a287;
a281=a388*a281;
a292=a292*a369;
a383=a383*a280;
a292=a292-a383;
a292=a285*a292;
a290=a290*a292;
a281=a281+a290;
a287=a287-a281;
a281=2.*a283;
a390=a390*a281;
a388=a388*a283;
a289=a289*a292;
a388=a388+a289;
a389=a389*a388;
a390=a390+a389;
a287=a287-a390;
a386=a386*a287;
a287=a288*a386;
a516=a516-a287;
a375=a375*a516;
a372=a372*a375;
a371=a371*a372;
a518=a518+a371;
a341=a341+a518;
a341=a341/a393;
a370=a370/a393;
a393=2.*a275;
a370=a370*a393;
a341=a341-a370;
a341=a341/a394;
a394=a395/a394;
a520=2.*a520;
a394=a394*a520;
a341=a341-a394;
a368=a368*a341;
a522=a522+a368;
a367=a367*a522;
a411=a411+a367;
a413=a413-a411;
a121=a121*a413;
a402=a402+a121;
a002=a002-a402;
a402=a253/a252;
a121=a402*a365;
a411=2.*a252;
a121=a121/a411;
a343=a343-a121;
a367=2.*a505;
a367=a343*a367;
a368=2.*a247;
a394=a432/a252;
a252=a402/a252;
a252=a252*a510;
a394=a394-a252;
a365=a365*a394;
a402=a402*a429;
a365=a365+a402;
a365=a365/a411;
a121=a121/a411;
a510=2.*a510;
a121=a121*a510;
a365=a365-a121;
a428=a428-a365;
a365=a368*a428;
a367=a367+a365;
a372=a372/a277;
a392=a392/a277;
a277=a392/a277;
a277=a277*a275;
a372=a372-a277;
a367=a367+a372;
a505=2.*a505;
a505=a396*a505;
a247=2.*a247;
a522=a247*a522;
a505=a505+a522;
a367=a367-a505;
a246=a246*a367;
a368=a368*a343;
a368=a368+a392;
a247=a247*a396;
a368=a368-a247;
a506=a368*a506;
a246=a246-a506;
a002=a002+a246;
a246=2.0000000000000000e-02;
a506=50.;
a247=arg[1]? arg[1][5] : 0;
a396=a506*a247;
a392=a010*a225;
a392=a392+a054;
a505=arg[2]? arg[2][2] : 0;
a522=cos(a505);
a372=a392*a522;
a277=a039*a010;
a275=arg[2]? arg[2][3] : 0;
a365=a277*a275;
a121=a012-a365;
a510=sin(a505);
a411=a121*a510;
a372=a372+a411;
a411=arg[2]? arg[2][40] : 0;
a402=arg[2]? arg[2][39] : 0;
a429=arg[2]? arg[2][37] : 0;
a394=arg[2]? arg[2][38] : 0;
a252=a394-a030;
a520=casadi_fmax(a027,a252);
a520=sqrt(a520);
a370=a429*a520;
a393=1./a370;
a518=-a393;
a371=arg[2]? arg[2][32] : 0;
a287=arg[2]? arg[2][33] : 0;
a177=a177+a126;
a126=a044*a177;
a126=a126+a234;
a126=a039*a126;
a126=a126/a243;
a234=-a126;
a390=casadi_fmax(a032,a234);
a389=a287*a390;
a389=a371+a389;
a388=casadi_fmax(a032,a389);
a289=a012-a365;
a292=cos(a505);
a283=a289*a292;
a281=sin(a505);
a290=a392*a281;
a283=a283-a290;
a383=casadi_sq(a283);
a383=a383+a251;
a280=sqrt(a383);
a369=a372/a280;
a291=a388*a369;
a336=arg[2]? arg[2][42] : 0;
a302=arg[2]? arg[2][34] : 0;
a329=arg[2]? arg[2][35] : 0;
a284=a329*a390;
a284=a302+a284;
a297=casadi_fmax(a256,a284);
a282=a336*a297;
a291=a291/a282;
a294=casadi_fmin(a291,a393);
a296=casadi_fmax(a518,a294);
a295=a030-a394;
a523=a296*a295;
a366=a429*a296;
a384=atan(a366);
a310=a394*a384;
a310=a310/a429;
a523=a523+a310;
a324=a429*a523;
a514=atan(a324);
a340=a402*a514;
a301=sin(a340);
a306=a411*a301;
a299=casadi_sq(a372);
a299=a299+a383;
a299=sqrt(a299);
a383=a306*a299;
a305=a372*a383;
a331=casadi_sq(a250);
a263=casadi_sq(a331);
a422=casadi_sq(a283);
a096=casadi_sq(a372);
a422=a422+a096;
a096=casadi_sq(a422);
a263=a263+a096;
a263=sqrt(a263);
a305=a305/a263;
a096=a305+a027;
a357=casadi_sq(a372);
a357=a357/a263;
a268=4.9999999999999999e-13;
a419=a357+a268;
a096=a096/a419;
a118=a506*a096;
a396=a396-a118;
a118=casadi_fmin(a030,a396);
a354=casadi_fmax(a032,a118);
a270=casadi_sq(a354);
a417=a354*a270;
a417=a246*a417;
a397=casadi_sq(a354);
a397=a058*a397;
a145=a035*a354;
a397=a397-a145;
a397=a397+a060;
a145=a417*a397;
a273=a247-a096;
a273=a273-a246;
a326=casadi_fmax(a032,a273);
a145=a145+a326;
a326=a372*a145;
a164=sqrt(a263);
a326=a326/a164;
a272=a383/a164;
a339=a326+a272;
a338=arg[2]? arg[2][43] : 0;
a332=a282-a338;
a335=a247*a332;
a335=a335+a338;
a335=a335/a282;
a338=a335+a279;
a328=-a338;
a327=a283/a164;
a298=casadi_fmin(a338,a327);
a323=casadi_fmax(a328,a298);
a311=a286*a335;
a530=a288*a323;
a311=a311-a530;
a311=a311+a039;
a530=casadi_fmax(a032,a311);
a501=casadi_sq(a530);
a304=a530*a501;
a304=a285*a304;
a312=a039*a530;
a312=a030-a312;
a532=a304*a312;
a532=a323+a532;
a533=a286*a335;
a323=a288*a323;
a533=a533+a323;
a533=a533+a039;
a323=casadi_fmax(a032,a533);
a534=casadi_sq(a323);
a535=a323*a534;
a535=a285*a535;
a536=a039*a323;
a536=a030-a536;
a537=a535*a536;
a532=a532-a537;
a537=casadi_sq(a532);
a537=a030-a537;
a537=sqrt(a537);
a538=a537+a279;
a539=a339<=a538;
a540=a538<=a339;
a541=a539+a540;
a539=a539/a541;
a542=-a538;
a543=casadi_fmin(a339,a538);
a544=a542<=a543;
a545=a543<=a542;
a546=a545+a544;
a544=a544/a546;
a547=a286*a537;
a548=casadi_fmax(a542,a543);
a549=a288*a548;
a547=a547+a549;
a547=a547+a039;
a549=a032<=a547;
a550=a547<=a032;
a550=a550+a549;
a549=a549/a550;
a550=casadi_fmax(a032,a547);
a551=casadi_sq(a550);
a552=a550*a551;
a552=a285*a552;
a553=sin(a505);
a554=a275*a090;
a554=a039*a554;
a554=a554-a316;
a555=a553*a554;
a556=cos(a505);
a557=a225*a090;
a557=a557+a093;
a558=a556*a557;
a555=a555-a558;
a558=a282*a555;
a559=a390*a558;
a560=a552*a559;
a560=a039*a560;
a561=a039*a550;
a561=a030-a561;
a562=a561*a559;
a562=a285*a562;
a563=a551*a562;
a560=a560-a563;
a563=2.*a550;
a564=a550*a562;
a565=a563*a564;
a560=a560-a565;
a560=a549*a560;
a565=a288*a560;
a565=a565+a559;
a566=a286*a537;
a567=a288*a548;
a566=a566-a567;
a566=a566+a039;
a567=a032<=a566;
a568=a566<=a032;
a568=a568+a567;
a567=a567/a568;
a568=casadi_fmax(a032,a566);
a569=casadi_sq(a568);
a570=a039*a568;
a570=a030-a570;
a571=a570*a559;
a571=a285*a571;
a572=a569*a571;
a573=a568*a569;
a573=a285*a573;
a574=a573*a559;
a574=a039*a574;
a572=a572-a574;
a574=2.*a568;
a575=a568*a571;
a576=a574*a575;
a572=a572+a576;
a572=a567*a572;
a576=a288*a572;
a565=a565-a576;
a576=a544*a565;
a577=a539*a576;
a578=a577/a164;
a579=a145*a578;
a580=2.*a372;
a581=a096/a419;
a582=a032<=a273;
a583=a273<=a032;
a583=a583+a582;
a582=a582/a583;
a583=a372*a578;
a584=a582*a583;
a585=a396<=a030;
a586=a030<=a396;
a586=a586+a585;
a585=a585/a586;
a586=a032<=a118;
a587=a118<=a032;
a587=a587+a586;
a586=a586/a587;
a587=2.*a354;
a588=a417*a583;
a589=a058*a588;
a590=a587*a589;
a588=a035*a588;
a590=a590-a588;
a588=a397*a583;
a588=a246*a588;
a591=a270*a588;
a590=a590+a591;
a591=2.*a354;
a592=a354*a588;
a593=a591*a592;
a590=a590+a593;
a590=a586*a590;
a590=a585*a590;
a590=a506*a590;
a584=a584+a590;
a590=a581*a584;
a593=a590/a263;
a594=a580*a593;
a579=a579+a594;
a594=a584/a419;
a595=a594/a263;
a596=a383*a595;
a579=a579-a596;
a596=2.*a372;
a597=a577/a164;
a598=a372*a595;
a598=a597-a598;
a599=a306*a598;
a600=2.*a299;
a599=a599/a600;
a601=a596*a599;
a579=a579+a601;
a601=a291<=a393;
a602=a393<=a291;
a603=a601+a602;
a601=a601/a603;
a604=a518<=a294;
a605=a294<=a518;
a606=a605+a604;
a604=a604/a606;
a607=cos(a340);
a608=a299*a598;
a609=a411*a608;
a610=a607*a609;
a611=a402*a610;
a612=casadi_sq(a324);
a612=a030+a612;
a611=a611/a612;
a613=a394*a611;
a614=casadi_sq(a366);
a614=a030+a614;
a613=a613/a614;
a615=a429*a613;
a616=a429*a611;
a617=a295*a616;
a615=a615+a617;
a617=a604*a615;
a618=a601*a617;
a619=a618/a282;
a620=a388*a619;
a621=a620/a280;
a579=a579+a621;
a622=2.*a372;
a623=2.*a422;
a624=a305/a263;
a625=a624*a594;
a626=a357/a263;
a627=a626*a590;
a625=a625-a627;
a627=a272/a164;
a628=a627*a577;
a629=a326/a164;
a630=a629*a577;
a628=a628+a630;
a630=a327/a164;
a631=a327<=a338;
a632=a338<=a327;
a633=a632+a631;
a631=a631/a633;
a634=a328<=a298;
a635=a298<=a328;
a636=a635+a634;
a634=a634/a636;
a637=a032<=a533;
a638=a533<=a032;
a638=a638+a637;
a637=a637/a638;
a638=sin(a505);
a639=a638*a557;
a640=cos(a505);
a641=a640*a554;
a639=a639+a641;
a641=a282*a639;
a642=a390*a641;
a643=2.*a532;
a560=a286*a560;
a572=a286*a572;
a560=a560+a572;
a540=a540/a541;
a576=a540*a576;
a545=a545/a546;
a565=a545*a565;
a576=a576-a565;
a560=a560+a576;
a576=2.*a537;
a560=a560/a576;
a565=a643*a560;
a642=a642-a565;
a565=a535*a642;
a565=a039*a565;
a546=a536*a642;
a546=a285*a546;
a541=a534*a546;
a565=a565-a541;
a541=2.*a323;
a572=a323*a546;
a644=a541*a572;
a565=a565-a644;
a565=a637*a565;
a644=a288*a565;
a644=a644+a642;
a645=a032<=a311;
a646=a311<=a032;
a646=a646+a645;
a645=a645/a646;
a646=a312*a642;
a646=a285*a646;
a647=a501*a646;
a648=a304*a642;
a648=a039*a648;
a647=a647-a648;
a648=2.*a530;
a649=a530*a646;
a650=a648*a649;
a647=a647+a650;
a647=a645*a647;
a650=a288*a647;
a644=a644-a650;
a650=a634*a644;
a651=a631*a650;
a652=a630*a651;
a628=a628+a652;
a652=2.*a164;
a628=a628/a652;
a625=a625-a628;
a653=2.*a263;
a625=a625/a653;
a654=a623*a625;
a655=a622*a654;
a579=a579+a655;
a655=cos(a505);
a656=arg[10]? arg[10][2] : 0;
a655=a655*a656;
a657=a579*a655;
a658=a032<=a118;
a118=a118<=a032;
a118=a118+a658;
a658=a658/a118;
a118=a396<=a030;
a396=a030<=a396;
a396=a396+a118;
a118=a118/a396;
a396=arg[9]? arg[9][5] : 0;
a659=a506*a396;
a660=a225*a008;
a661=a010*a484;
a660=a660+a661;
a660=a660+a161;
a661=a522*a660;
a662=sin(a505);
a662=a662*a656;
a663=a392*a662;
a661=a661-a663;
a663=a039*a008;
a664=a275*a663;
a665=arg[10]? arg[10][3] : 0;
a666=a277*a665;
a664=a664+a666;
a666=a129-a664;
a667=a510*a666;
a655=a121*a655;
a667=a667+a655;
a661=a661+a667;
a667=a383*a661;
a655=arg[10]? arg[10][40] : 0;
a668=a301*a655;
a669=cos(a340);
a670=arg[10]? arg[10][39] : 0;
a671=a514*a670;
a672=arg[10]? arg[10][37] : 0;
a673=a523*a672;
a674=a294<=a518;
a518=a518<=a294;
a294=a674+a518;
a674=a674/a294;
a675=a393/a370;
a676=a520*a672;
a677=a027<=a252;
a678=a252<=a027;
a678=a678+a677;
a677=a677/a678;
a678=arg[10]? arg[10][38] : 0;
a677=a677*a678;
a679=2.*a520;
a677=a677/a679;
a679=a429*a677;
a676=a676+a679;
a675=a675*a676;
a674=a674*a675;
a518=a518/a294;
a294=a291<=a393;
a679=a393<=a291;
a680=a294+a679;
a294=a294/a680;
a681=a032<=a389;
a682=a389<=a032;
a682=a682+a681;
a681=a681/a682;
a682=arg[10]? arg[10][32] : 0;
a683=arg[10]? arg[10][33] : 0;
a684=a390*a683;
a685=a032<=a234;
a686=a234<=a032;
a686=a686+a685;
a685=a685/a686;
a686=a177*a435;
a405=a405+a408;
a408=a044*a405;
a686=a686+a408;
a686=a686+a487;
a686=a039*a686;
a686=a686/a243;
a487=a126/a243;
a487=a487*a503;
a686=a686-a487;
a685=a685*a686;
a487=a287*a685;
a684=a684-a487;
a684=a682+a684;
a681=a681*a684;
a684=a369*a681;
a487=a661/a280;
a408=a369/a280;
a687=2.*a283;
a688=a129-a664;
a689=a292*a688;
a690=sin(a505);
a690=a690*a656;
a691=a289*a690;
a689=a689-a691;
a691=a281*a660;
a692=cos(a505);
a692=a692*a656;
a693=a392*a692;
a691=a691+a693;
a689=a689-a691;
a687=a687*a689;
a687=a687+a507;
a693=2.*a280;
a693=a687/a693;
a408=a408*a693;
a487=a487-a408;
a408=a388*a487;
a684=a684+a408;
a684=a684/a282;
a408=a291/a282;
a694=arg[10]? arg[10][42] : 0;
a695=a297*a694;
a696=a256<=a284;
a697=a284<=a256;
a697=a697+a696;
a696=a696/a697;
a697=arg[10]? arg[10][34] : 0;
a698=arg[10]? arg[10][35] : 0;
a699=a390*a698;
a700=a329*a685;
a699=a699-a700;
a699=a697+a699;
a696=a696*a699;
a699=a336*a696;
a695=a695+a699;
a408=a408*a695;
a684=a684-a408;
a294=a294*a684;
a679=a679/a680;
a679=a679*a675;
a294=a294-a679;
a518=a518*a294;
a674=a674+a518;
a518=a295*a674;
a294=a296*a678;
a518=a518-a294;
a294=a384*a678;
a679=a296*a672;
a680=a429*a674;
a679=a679+a680;
a680=casadi_sq(a366);
a680=a030+a680;
a680=a679/a680;
a408=a394*a680;
a294=a294+a408;
a294=a294/a429;
a408=a310/a429;
a408=a408*a672;
a294=a294-a408;
a518=a518+a294;
a408=a429*a518;
a673=a673+a408;
a408=casadi_sq(a324);
a408=a030+a408;
a408=a673/a408;
a699=a402*a408;
a671=a671+a699;
a669=a669*a671;
a699=a411*a669;
a668=a668+a699;
a699=a299*a668;
a700=2.*a372;
a700=a700*a661;
a700=a700+a687;
a687=2.*a299;
a700=a700/a687;
a687=a306*a700;
a699=a699+a687;
a687=a372*a699;
a667=a667+a687;
a667=a667/a263;
a305=a305/a263;
a687=2.*a331;
a701=2.*a250;
a701=a701*a509;
a687=a687*a701;
a422=2.*a422;
a702=2.*a283;
a702=a702*a689;
a703=2.*a372;
a703=a703*a661;
a702=a702+a703;
a422=a422*a702;
a687=a687+a422;
a422=2.*a263;
a687=a687/a422;
a305=a305*a687;
a667=a667-a305;
a305=a667/a419;
a096=a096/a419;
a422=2.*a372;
a422=a422*a661;
a422=a422/a263;
a357=a357/a263;
a357=a357*a687;
a422=a422-a357;
a096=a096*a422;
a305=a305-a096;
a096=a506*a305;
a659=a659-a096;
a118=a118*a659;
a658=a658*a118;
a118=a270*a658;
a659=2.*a354;
a659=a659*a658;
a096=a354*a659;
a118=a118+a096;
a118=a246*a118;
a096=a397*a118;
a357=2.*a354;
a357=a357*a658;
a357=a058*a357;
a703=a035*a658;
a357=a357-a703;
a703=a417*a357;
a096=a096+a703;
a703=a032<=a273;
a273=a273<=a032;
a273=a273+a703;
a703=a703/a273;
a273=a396-a305;
a703=a703*a273;
a096=a096+a703;
a703=a578*a096;
a273=a032<=a547;
a547=a547<=a032;
a547=a547+a273;
a273=a273/a547;
a547=a543<=a542;
a542=a542<=a543;
a543=a547+a542;
a547=a547/a543;
a704=2.*a532;
a705=a328<=a298;
a298=a298<=a328;
a328=a298+a705;
a705=a705/a328;
a706=a338<=a327;
a338=a327<=a338;
a707=a706+a338;
a706=a706/a707;
a708=a332*a396;
a709=arg[10]? arg[10][43] : 0;
a710=a695-a709;
a711=a247*a710;
a708=a708+a711;
a708=a708+a709;
a708=a708/a282;
a709=a335/a282;
a709=a709*a695;
a708=a708-a709;
a706=a706*a708;
a338=a338/a707;
a707=a689/a164;
a327=a327/a164;
a709=2.*a164;
a709=a687/a709;
a327=a327*a709;
a707=a707-a327;
a338=a338*a707;
a706=a706+a338;
a705=a705*a706;
a298=a298/a328;
a298=a298*a708;
a705=a705-a298;
a298=a032<=a311;
a311=a311<=a032;
a311=a311+a298;
a298=a298/a311;
a311=a286*a708;
a328=a288*a705;
a311=a311-a328;
a298=a298*a311;
a311=a501*a298;
a328=2.*a530;
a328=a328*a298;
a706=a530*a328;
a311=a311+a706;
a311=a285*a311;
a706=a312*a311;
a338=a039*a298;
a327=a304*a338;
a706=a706-a327;
a706=a705+a706;
a327=a032<=a533;
a533=a533<=a032;
a533=a533+a327;
a327=a327/a533;
a533=a286*a708;
a705=a288*a705;
a533=a533+a705;
a327=a327*a533;
a533=a534*a327;
a705=2.*a323;
a705=a705*a327;
a711=a323*a705;
a533=a533+a711;
a533=a285*a533;
a711=a536*a533;
a712=a039*a327;
a713=a535*a712;
a711=a711-a713;
a706=a706-a711;
a704=a704*a706;
a537=2.*a537;
a704=a704/a537;
a547=a547*a704;
a542=a542/a543;
a543=a339<=a538;
a538=a538<=a339;
a339=a543+a538;
a543=a543/a339;
a537=a145*a661;
a096=a372*a096;
a537=a537+a096;
a537=a537/a164;
a326=a326/a164;
a326=a326*a709;
a537=a537-a326;
a326=a699/a164;
a272=a272/a164;
a272=a272*a709;
a326=a326-a272;
a272=a537+a326;
a543=a543*a272;
a538=a538/a339;
a538=a538*a704;
a543=a543-a538;
a542=a542*a543;
a547=a547+a542;
a542=a288*a547;
a543=a286*a704;
a542=a542-a543;
a273=a273*a542;
a542=a551*a273;
a543=2.*a550;
a543=a543*a273;
a538=a550*a543;
a542=a542+a538;
a542=a285*a542;
a538=a559*a542;
a339=a555*a695;
a272=cos(a505);
a272=a272*a656;
a096=a554*a272;
a711=a090*a665;
a713=a275*a174;
a711=a711+a713;
a711=a039*a711;
a711=a711-a525;
a713=a553*a711;
a096=a096+a713;
a713=a090*a484;
a714=a225*a174;
a713=a713+a714;
a713=a713+a175;
a714=a556*a713;
a715=sin(a505);
a715=a715*a656;
a716=a557*a715;
a714=a714-a716;
a096=a096-a714;
a714=a282*a096;
a339=a339+a714;
a714=a390*a339;
a716=a558*a685;
a714=a714-a716;
a716=a552*a714;
a538=a538+a716;
a538=a039*a538;
a543=a562*a543;
a716=a561*a714;
a717=a039*a273;
a718=a559*a717;
a716=a716-a718;
a716=a285*a716;
a551=a551*a716;
a543=a543+a551;
a538=a538-a543;
a543=2.*a273;
a564=a564*a543;
a562=a562*a273;
a550=a550*a716;
a562=a562+a550;
a563=a563*a562;
a564=a564+a563;
a538=a538-a564;
a549=a549*a538;
a538=a288*a549;
a538=a538+a714;
a564=a032<=a566;
a566=a566<=a032;
a566=a566+a564;
a564=a564/a566;
a566=a286*a704;
a563=a288*a547;
a566=a566+a563;
a564=a564*a566;
a566=a039*a564;
a563=a559*a566;
a562=a570*a714;
a563=a563+a562;
a563=a285*a563;
a562=a569*a563;
a550=2.*a568;
a550=a550*a564;
a716=a571*a550;
a562=a562-a716;
a714=a573*a714;
a569=a569*a564;
a550=a568*a550;
a569=a569+a550;
a569=a285*a569;
a559=a559*a569;
a714=a714-a559;
a714=a039*a714;
a562=a562-a714;
a714=-a564;
a714=2.*a714;
a575=a575*a714;
a568=a568*a563;
a571=a571*a564;
a568=a568-a571;
a574=a574*a568;
a575=a575+a574;
a562=a562+a575;
a567=a567*a562;
a562=a288*a567;
a538=a538-a562;
a544=a544*a538;
a539=a539*a544;
a562=a539/a164;
a575=a578/a164;
a575=a575*a709;
a562=a562-a575;
a145=a145*a562;
a703=a703+a145;
a145=2.*a661;
a145=a593*a145;
a305=a305/a419;
a575=a581/a419;
a575=a575*a422;
a305=a305-a575;
a584=a584*a305;
a578=a578*a661;
a562=a372*a562;
a578=a578+a562;
a582=a582*a578;
a562=2.*a658;
a589=a589*a562;
a118=a583*a118;
a417=a417*a578;
a118=a118+a417;
a417=a058*a118;
a587=a587*a417;
a589=a589+a587;
a118=a035*a118;
a589=a589-a118;
a659=a588*a659;
a583=a583*a357;
a397=a397*a578;
a583=a583+a397;
a583=a246*a583;
a270=a270*a583;
a659=a659+a270;
a589=a589+a659;
a659=2.*a658;
a592=a592*a659;
a588=a588*a658;
a354=a354*a583;
a588=a588+a354;
a591=a591*a588;
a592=a592+a591;
a589=a589+a592;
a586=a586*a589;
a585=a585*a586;
a586=a506*a585;
a586=a582+a586;
a581=a581*a586;
a584=a584+a581;
a581=a584/a263;
a593=a593/a263;
a593=a593*a687;
a581=a581-a593;
a580=a580*a581;
a145=a145+a580;
a703=a703+a145;
a699=a595*a699;
a586=a586/a419;
a419=a594/a419;
a419=a419*a422;
a586=a586-a419;
a419=a586/a263;
a145=a595/a263;
a145=a145*a687;
a419=a419-a145;
a383=a383*a419;
a699=a699+a383;
a703=a703-a699;
a699=2.*a661;
a699=a599*a699;
a668=a598*a668;
a383=a539/a164;
a597=a597/a164;
a597=a597*a709;
a383=a383-a597;
a595=a595*a661;
a372=a372*a419;
a595=a595+a372;
a383=a383-a595;
a306=a306*a383;
a668=a668+a306;
a668=a668/a600;
a600=a599/a600;
a306=2.*a700;
a600=a600*a306;
a668=a668-a600;
a596=a596*a668;
a699=a699+a596;
a703=a703+a699;
a681=a619*a681;
a699=a613*a672;
a596=a611*a678;
a600=a610*a670;
a306=a608*a655;
a598=a598*a700;
a299=a299*a383;
a598=a598+a299;
a299=a411*a598;
a306=a306+a299;
a607=a607*a306;
a340=sin(a340);
a340=a340*a671;
a609=a609*a340;
a607=a607-a609;
a609=a402*a607;
a600=a600+a609;
a600=a600/a612;
a612=a611/a612;
a324=2.*a324;
a324=a324*a673;
a612=a612*a324;
a600=a600-a612;
a612=a394*a600;
a596=a596+a612;
a596=a596/a614;
a614=a613/a614;
a366=2.*a366;
a366=a366*a679;
a614=a614*a366;
a596=a596-a614;
a614=a429*a596;
a699=a699+a614;
a614=a611*a672;
a366=a429*a600;
a614=a614+a366;
a295=a295*a614;
a366=a616*a678;
a295=a295-a366;
a699=a699+a295;
a604=a604*a699;
a601=a601*a604;
a295=a601/a282;
a366=a619/a282;
a366=a366*a695;
a295=a295-a366;
a388=a388*a295;
a681=a681+a388;
a388=a681/a280;
a621=a621/a280;
a621=a621*a693;
a388=a388-a621;
a703=a703+a388;
a661=2.*a661;
a661=a654*a661;
a702=2.*a702;
a702=a625*a702;
a667=a667/a263;
a388=a624/a263;
a388=a388*a687;
a667=a667-a388;
a594=a594*a667;
a624=a624*a586;
a594=a594+a624;
a422=a422/a263;
a263=a626/a263;
a263=a263*a687;
a422=a422-a263;
a590=a590*a422;
a626=a626*a584;
a590=a590+a626;
a594=a594-a590;
a326=a326/a164;
a590=a627/a164;
a590=a590*a709;
a326=a326-a590;
a326=a577*a326;
a627=a627*a539;
a326=a326+a627;
a537=a537/a164;
a627=a629/a164;
a627=a627*a709;
a537=a537-a627;
a577=a577*a537;
a629=a629*a539;
a577=a577+a629;
a326=a326+a577;
a707=a707/a164;
a577=a630/a164;
a577=a577*a709;
a707=a707-a577;
a707=a651*a707;
a533=a642*a533;
a577=a639*a695;
a629=cos(a505);
a629=a629*a656;
a539=a557*a629;
a537=a638*a713;
a539=a539+a537;
a537=a640*a711;
a627=sin(a505);
a627=a627*a656;
a590=a554*a627;
a537=a537-a590;
a539=a539+a537;
a537=a282*a539;
a577=a577+a537;
a537=a390*a577;
a590=a641*a685;
a537=a537-a590;
a590=2.*a706;
a590=a560*a590;
a549=a286*a549;
a567=a286*a567;
a549=a549+a567;
a540=a540*a544;
a545=a545*a538;
a540=a540-a545;
a549=a549+a540;
a549=a549/a576;
a560=a560/a576;
a704=-a704;
a704=2.*a704;
a560=a560*a704;
a549=a549-a560;
a643=a643*a549;
a590=a590+a643;
a537=a537-a590;
a535=a535*a537;
a533=a533+a535;
a533=a039*a533;
a705=a546*a705;
a536=a536*a537;
a712=a642*a712;
a536=a536-a712;
a536=a285*a536;
a534=a534*a536;
a705=a705+a534;
a533=a533-a705;
a705=2.*a327;
a572=a572*a705;
a546=a546*a327;
a323=a323*a536;
a546=a546+a323;
a541=a541*a546;
a572=a572+a541;
a533=a533-a572;
a637=a637*a533;
a533=a288*a637;
a533=a533+a537;
a328=a646*a328;
a312=a312*a537;
a338=a642*a338;
a312=a312-a338;
a312=a285*a312;
a501=a501*a312;
a328=a328+a501;
a642=a642*a311;
a304=a304*a537;
a642=a642+a304;
a642=a039*a642;
a328=a328-a642;
a642=2.*a298;
a649=a649*a642;
a646=a646*a298;
a530=a530*a312;
a646=a646+a530;
a648=a648*a646;
a649=a649+a648;
a328=a328+a649;
a645=a645*a328;
a328=a288*a645;
a533=a533-a328;
a634=a634*a533;
a631=a631*a634;
a630=a630*a631;
a707=a707+a630;
a326=a326+a707;
a326=a326/a652;
a628=a628/a652;
a652=2.*a709;
a628=a628*a652;
a326=a326-a628;
a594=a594-a326;
a594=a594/a653;
a653=a625/a653;
a687=2.*a687;
a653=a653*a687;
a594=a594-a653;
a623=a623*a594;
a702=a702+a623;
a622=a622*a702;
a661=a661+a622;
a703=a703+a661;
a661=a510*a703;
a657=a657+a661;
a002=a002+a657;
a661=a369/a280;
a622=a661*a620;
a623=2.*a280;
a622=a622/a623;
a599=a599-a622;
a653=2.*a689;
a653=a599*a653;
a687=2.*a283;
a326=a487/a280;
a280=a661/a280;
a280=a280*a693;
a326=a326-a280;
a620=a620*a326;
a661=a661*a681;
a620=a620+a661;
a620=a620/a623;
a622=a622/a623;
a693=2.*a693;
a622=a622*a693;
a620=a620-a622;
a668=a668-a620;
a620=a687*a668;
a653=a653+a620;
a631=a631/a164;
a651=a651/a164;
a164=a651/a164;
a164=a164*a709;
a631=a631-a164;
a653=a653+a631;
a689=2.*a689;
a689=a654*a689;
a283=2.*a283;
a702=a283*a702;
a689=a689+a702;
a653=a653+a689;
a689=a292*a653;
a687=a687*a599;
a687=a687+a651;
a283=a283*a654;
a687=a687+a283;
a690=a687*a690;
a689=a689-a690;
a002=a002+a689;
a690=arg[1]? arg[1][4] : 0;
a283=a506*a690;
a654=cos(a505);
a651=a392*a654;
a702=a012+a365;
a631=sin(a505);
a164=a702*a631;
a651=a651-a164;
a164=-a393;
a709=a287*a390;
a371=a371+a709;
a709=casadi_fmax(a032,a371);
a365=a012+a365;
a620=cos(a505);
a622=a365*a620;
a290=a290+a622;
a622=casadi_sq(a290);
a622=a622+a251;
a251=sqrt(a622);
a693=a651/a251;
a623=a709*a693;
a661=arg[2]? arg[2][36] : 0;
a681=a329*a390;
a302=a302+a681;
a681=casadi_fmax(a256,a302);
a326=a661*a681;
a623=a623/a326;
a280=casadi_fmin(a623,a393);
a628=casadi_fmax(a164,a280);
a652=a030-a394;
a707=a628*a652;
a630=a429*a628;
a328=atan(a630);
a649=a394*a328;
a649=a649/a429;
a707=a707+a649;
a648=a429*a707;
a646=atan(a648);
a530=a402*a646;
a312=sin(a530);
a298=a411*a312;
a642=casadi_sq(a651);
a642=a642+a622;
a642=sqrt(a642);
a622=a298*a642;
a304=a651*a622;
a537=casadi_sq(a250);
a311=casadi_sq(a537);
a501=casadi_sq(a290);
a338=casadi_sq(a651);
a501=a501+a338;
a338=casadi_sq(a501);
a311=a311+a338;
a311=sqrt(a311);
a304=a304/a311;
a338=a304+a027;
a572=casadi_sq(a651);
a572=a572/a311;
a268=a572+a268;
a338=a338/a268;
a541=a506*a338;
a283=a283-a541;
a541=casadi_fmin(a030,a283);
a546=casadi_fmax(a032,a541);
a323=casadi_sq(a546);
a536=a546*a323;
a536=a246*a536;
a327=casadi_sq(a546);
a327=a058*a327;
a705=a035*a546;
a327=a327-a705;
a327=a327+a060;
a060=a536*a327;
a705=a690-a338;
a705=a705-a246;
a534=casadi_fmax(a032,a705);
a060=a060+a534;
a534=a651*a060;
a712=sqrt(a311);
a534=a534/a712;
a535=a622/a712;
a590=a534+a535;
a643=arg[2]? arg[2][41] : 0;
a549=a326-a643;
a560=a690*a549;
a560=a560+a643;
a560=a560/a326;
a643=a560+a279;
a704=-a643;
a576=a290/a712;
a540=casadi_fmin(a643,a576);
a545=casadi_fmax(a704,a540);
a538=a286*a560;
a544=a288*a545;
a538=a538-a544;
a538=a538+a039;
a544=casadi_fmax(a032,a538);
a567=casadi_sq(a544);
a626=a544*a567;
a626=a285*a626;
a584=a039*a544;
a584=a030-a584;
a422=a626*a584;
a422=a545+a422;
a263=a286*a560;
a545=a288*a545;
a263=a263+a545;
a263=a263+a039;
a545=casadi_fmax(a032,a263);
a624=casadi_sq(a545);
a586=a545*a624;
a586=a285*a586;
a667=a039*a545;
a667=a030-a667;
a388=a586*a667;
a422=a422-a388;
a388=casadi_sq(a422);
a388=a030-a388;
a388=sqrt(a388);
a279=a388+a279;
a621=a590<=a279;
a366=a279<=a590;
a679=a621+a366;
a621=a621/a679;
a612=-a279;
a324=casadi_fmin(a590,a279);
a673=a612<=a324;
a609=a324<=a612;
a340=a609+a673;
a673=a673/a340;
a671=a286*a388;
a306=casadi_fmax(a612,a324);
a299=a288*a306;
a671=a671+a299;
a671=a671+a039;
a299=a032<=a671;
a383=a671<=a032;
a383=a383+a299;
a299=a299/a383;
a383=casadi_fmax(a032,a671);
a700=casadi_sq(a383);
a595=a383*a700;
a595=a285*a595;
a372=sin(a505);
a419=a275*a090;
a419=a039*a419;
a419=a419+a316;
a597=a372*a419;
a145=cos(a505);
a580=a225*a090;
a580=a580+a093;
a581=a145*a580;
a597=a597-a581;
a581=a326*a597;
a593=a390*a581;
a589=a595*a593;
a589=a039*a589;
a592=a039*a383;
a592=a030-a592;
a591=a592*a593;
a591=a285*a591;
a588=a700*a591;
a589=a589-a588;
a588=2.*a383;
a354=a383*a591;
a583=a588*a354;
a589=a589-a583;
a589=a299*a589;
a583=a288*a589;
a583=a583+a593;
a658=a286*a388;
a659=a288*a306;
a658=a658-a659;
a658=a658+a039;
a659=a032<=a658;
a270=a658<=a032;
a270=a270+a659;
a659=a659/a270;
a270=casadi_fmax(a032,a658);
a397=casadi_sq(a270);
a578=a039*a270;
a578=a030-a578;
a357=a578*a593;
a357=a285*a357;
a118=a397*a357;
a587=a270*a397;
a587=a285*a587;
a417=a587*a593;
a417=a039*a417;
a118=a118-a417;
a417=2.*a270;
a562=a270*a357;
a305=a417*a562;
a118=a118+a305;
a118=a659*a118;
a305=a288*a118;
a583=a583-a305;
a305=a673*a583;
a575=a621*a305;
a574=a575/a712;
a568=a060*a574;
a571=2.*a651;
a564=a338/a268;
a563=a032<=a705;
a714=a705<=a032;
a714=a714+a563;
a563=a563/a714;
a714=a651*a574;
a559=a563*a714;
a550=a283<=a030;
a716=a030<=a283;
a716=a716+a550;
a550=a550/a716;
a716=a032<=a541;
a273=a541<=a032;
a273=a273+a716;
a716=a716/a273;
a273=2.*a546;
a543=a536*a714;
a551=a058*a543;
a718=a273*a551;
a543=a035*a543;
a718=a718-a543;
a543=a327*a714;
a543=a246*a543;
a719=a323*a543;
a718=a718+a719;
a719=2.*a546;
a720=a546*a543;
a721=a719*a720;
a718=a718+a721;
a718=a716*a718;
a718=a550*a718;
a718=a506*a718;
a559=a559+a718;
a718=a564*a559;
a721=a718/a311;
a722=a571*a721;
a568=a568+a722;
a722=a559/a268;
a723=a722/a311;
a724=a622*a723;
a568=a568-a724;
a724=2.*a651;
a725=a575/a712;
a726=a651*a723;
a726=a725-a726;
a727=a298*a726;
a728=2.*a642;
a727=a727/a728;
a729=a724*a727;
a568=a568+a729;
a729=a623<=a393;
a730=a393<=a623;
a731=a729+a730;
a729=a729/a731;
a732=a164<=a280;
a733=a280<=a164;
a734=a733+a732;
a732=a732/a734;
a735=cos(a530);
a736=a642*a726;
a737=a411*a736;
a738=a735*a737;
a739=a402*a738;
a740=casadi_sq(a648);
a740=a030+a740;
a739=a739/a740;
a741=a394*a739;
a742=casadi_sq(a630);
a742=a030+a742;
a741=a741/a742;
a743=a429*a741;
a744=a429*a739;
a745=a652*a744;
a743=a743+a745;
a745=a732*a743;
a746=a729*a745;
a747=a746/a326;
a748=a709*a747;
a749=a748/a251;
a568=a568+a749;
a750=2.*a651;
a751=2.*a501;
a752=a304/a311;
a753=a752*a722;
a754=a572/a311;
a755=a754*a718;
a753=a753-a755;
a755=a535/a712;
a756=a755*a575;
a757=a534/a712;
a758=a757*a575;
a756=a756+a758;
a758=a576/a712;
a759=a576<=a643;
a760=a643<=a576;
a761=a760+a759;
a759=a759/a761;
a762=a704<=a540;
a763=a540<=a704;
a764=a763+a762;
a762=a762/a764;
a765=a032<=a263;
a766=a263<=a032;
a766=a766+a765;
a765=a765/a766;
a766=sin(a505);
a767=a766*a580;
a768=cos(a505);
a769=a768*a419;
a767=a767+a769;
a769=a326*a767;
a770=a390*a769;
a771=2.*a422;
a589=a286*a589;
a118=a286*a118;
a589=a589+a118;
a366=a366/a679;
a305=a366*a305;
a609=a609/a340;
a583=a609*a583;
a305=a305-a583;
a589=a589+a305;
a305=2.*a388;
a589=a589/a305;
a583=a771*a589;
a770=a770+a583;
a583=a667*a770;
a583=a285*a583;
a340=a624*a583;
a679=a586*a770;
a679=a039*a679;
a340=a340-a679;
a679=2.*a545;
a118=a545*a583;
a772=a679*a118;
a340=a340+a772;
a340=a765*a340;
a772=a288*a340;
a772=a772-a770;
a773=a032<=a538;
a774=a538<=a032;
a774=a774+a773;
a773=a773/a774;
a774=a626*a770;
a774=a039*a774;
a775=a584*a770;
a775=a285*a775;
a776=a567*a775;
a774=a774-a776;
a776=2.*a544;
a777=a544*a775;
a778=a776*a777;
a774=a774-a778;
a774=a773*a774;
a778=a288*a774;
a772=a772-a778;
a778=a762*a772;
a779=a759*a778;
a780=a758*a779;
a756=a756+a780;
a780=2.*a712;
a756=a756/a780;
a753=a753-a756;
a781=2.*a311;
a753=a753/a781;
a782=a751*a753;
a783=a750*a782;
a568=a568+a783;
a783=cos(a505);
a783=a783*a656;
a784=a568*a783;
a785=a032<=a541;
a541=a541<=a032;
a541=a541+a785;
a785=a785/a541;
a541=a283<=a030;
a283=a030<=a283;
a283=a283+a541;
a541=a541/a283;
a283=arg[9]? arg[9][4] : 0;
a786=a506*a283;
a787=a654*a660;
a788=sin(a505);
a788=a788*a656;
a789=a392*a788;
a787=a787-a789;
a789=a129+a664;
a790=a631*a789;
a783=a702*a783;
a790=a790+a783;
a787=a787-a790;
a790=a622*a787;
a783=a312*a655;
a791=cos(a530);
a792=a646*a670;
a793=a707*a672;
a794=a280<=a164;
a164=a164<=a280;
a280=a794+a164;
a794=a794/a280;
a794=a794*a675;
a164=a164/a280;
a280=a623<=a393;
a795=a393<=a623;
a796=a280+a795;
a280=a280/a796;
a797=a032<=a371;
a798=a371<=a032;
a798=a798+a797;
a797=a797/a798;
a798=a390*a683;
a799=a287*a685;
a798=a798-a799;
a682=a682+a798;
a797=a797*a682;
a682=a693*a797;
a798=a787/a251;
a799=a693/a251;
a800=2.*a290;
a664=a129+a664;
a801=a620*a664;
a802=sin(a505);
a802=a802*a656;
a803=a365*a802;
a801=a801-a803;
a691=a691+a801;
a800=a800*a691;
a800=a800+a507;
a507=2.*a251;
a507=a800/a507;
a799=a799*a507;
a798=a798-a799;
a799=a709*a798;
a682=a682+a799;
a682=a682/a326;
a799=a623/a326;
a801=arg[10]? arg[10][36] : 0;
a803=a681*a801;
a804=a256<=a302;
a805=a302<=a256;
a805=a805+a804;
a804=a804/a805;
a805=a390*a698;
a806=a329*a685;
a805=a805-a806;
a697=a697+a805;
a804=a804*a697;
a697=a661*a804;
a803=a803+a697;
a799=a799*a803;
a682=a682-a799;
a280=a280*a682;
a795=a795/a796;
a795=a795*a675;
a280=a280-a795;
a164=a164*a280;
a794=a794+a164;
a164=a652*a794;
a280=a628*a678;
a164=a164-a280;
a280=a328*a678;
a795=a628*a672;
a796=a429*a794;
a795=a795+a796;
a796=casadi_sq(a630);
a796=a030+a796;
a796=a795/a796;
a799=a394*a796;
a280=a280+a799;
a280=a280/a429;
a799=a649/a429;
a799=a799*a672;
a280=a280-a799;
a164=a164+a280;
a799=a429*a164;
a793=a793+a799;
a799=casadi_sq(a648);
a799=a030+a799;
a799=a793/a799;
a697=a402*a799;
a792=a792+a697;
a791=a791*a792;
a697=a411*a791;
a783=a783+a697;
a697=a642*a783;
a805=2.*a651;
a805=a805*a787;
a805=a805+a800;
a800=2.*a642;
a805=a805/a800;
a800=a298*a805;
a697=a697+a800;
a800=a651*a697;
a790=a790+a800;
a790=a790/a311;
a304=a304/a311;
a800=2.*a537;
a806=2.*a250;
a806=a806*a509;
a800=a800*a806;
a501=2.*a501;
a807=2.*a290;
a807=a807*a691;
a808=2.*a651;
a808=a808*a787;
a807=a807+a808;
a501=a501*a807;
a800=a800+a501;
a501=2.*a311;
a800=a800/a501;
a304=a304*a800;
a790=a790-a304;
a304=a790/a268;
a338=a338/a268;
a501=2.*a651;
a501=a501*a787;
a501=a501/a311;
a572=a572/a311;
a572=a572*a800;
a501=a501-a572;
a338=a338*a501;
a304=a304-a338;
a338=a506*a304;
a786=a786-a338;
a541=a541*a786;
a785=a785*a541;
a541=a323*a785;
a786=2.*a546;
a786=a786*a785;
a338=a546*a786;
a541=a541+a338;
a541=a246*a541;
a338=a327*a541;
a572=2.*a546;
a572=a572*a785;
a572=a058*a572;
a808=a035*a785;
a572=a572-a808;
a808=a536*a572;
a338=a338+a808;
a808=a032<=a705;
a705=a705<=a032;
a705=a705+a808;
a808=a808/a705;
a705=a283-a304;
a808=a808*a705;
a338=a338+a808;
a808=a574*a338;
a705=a032<=a671;
a671=a671<=a032;
a671=a671+a705;
a705=a705/a671;
a671=a324<=a612;
a612=a612<=a324;
a324=a671+a612;
a671=a671/a324;
a809=2.*a422;
a810=a704<=a540;
a540=a540<=a704;
a704=a540+a810;
a810=a810/a704;
a811=a643<=a576;
a643=a576<=a643;
a812=a811+a643;
a811=a811/a812;
a813=a549*a283;
a814=arg[10]? arg[10][41] : 0;
a815=a803-a814;
a816=a690*a815;
a813=a813+a816;
a813=a813+a814;
a813=a813/a326;
a814=a560/a326;
a814=a814*a803;
a813=a813-a814;
a811=a811*a813;
a643=a643/a812;
a812=a691/a712;
a576=a576/a712;
a814=2.*a712;
a814=a800/a814;
a576=a576*a814;
a812=a812-a576;
a643=a643*a812;
a811=a811+a643;
a810=a810*a811;
a540=a540/a704;
a540=a540*a813;
a810=a810-a540;
a540=a032<=a538;
a538=a538<=a032;
a538=a538+a540;
a540=a540/a538;
a538=a286*a813;
a704=a288*a810;
a538=a538-a704;
a540=a540*a538;
a538=a567*a540;
a704=2.*a544;
a704=a704*a540;
a811=a544*a704;
a538=a538+a811;
a538=a285*a538;
a811=a584*a538;
a643=a039*a540;
a576=a626*a643;
a811=a811-a576;
a811=a810+a811;
a576=a032<=a263;
a263=a263<=a032;
a263=a263+a576;
a576=a576/a263;
a263=a286*a813;
a810=a288*a810;
a263=a263+a810;
a576=a576*a263;
a263=a624*a576;
a810=2.*a545;
a810=a810*a576;
a816=a545*a810;
a263=a263+a816;
a263=a285*a263;
a816=a667*a263;
a817=a039*a576;
a818=a586*a817;
a816=a816-a818;
a811=a811-a816;
a809=a809*a811;
a388=2.*a388;
a809=a809/a388;
a671=a671*a809;
a612=a612/a324;
a324=a590<=a279;
a279=a279<=a590;
a590=a324+a279;
a324=a324/a590;
a388=a060*a787;
a338=a651*a338;
a388=a388+a338;
a388=a388/a712;
a534=a534/a712;
a534=a534*a814;
a388=a388-a534;
a534=a697/a712;
a535=a535/a712;
a535=a535*a814;
a534=a534-a535;
a535=a388+a534;
a324=a324*a535;
a279=a279/a590;
a279=a279*a809;
a324=a324-a279;
a612=a612*a324;
a671=a671+a612;
a612=a288*a671;
a324=a286*a809;
a612=a612-a324;
a705=a705*a612;
a612=a700*a705;
a324=2.*a383;
a324=a324*a705;
a279=a383*a324;
a612=a612+a279;
a612=a285*a612;
a279=a593*a612;
a590=a597*a803;
a535=cos(a505);
a535=a535*a656;
a338=a419*a535;
a816=a090*a665;
a818=a275*a174;
a816=a816+a818;
a816=a039*a816;
a816=a816+a525;
a818=a372*a816;
a338=a338+a818;
a818=a090*a484;
a819=a225*a174;
a818=a818+a819;
a818=a818+a175;
a819=a145*a818;
a820=sin(a505);
a820=a820*a656;
a821=a580*a820;
a819=a819-a821;
a338=a338-a819;
a819=a326*a338;
a590=a590+a819;
a819=a390*a590;
a821=a581*a685;
a819=a819-a821;
a821=a595*a819;
a279=a279+a821;
a279=a039*a279;
a324=a591*a324;
a821=a592*a819;
a822=a039*a705;
a823=a593*a822;
a821=a821-a823;
a821=a285*a821;
a700=a700*a821;
a324=a324+a700;
a279=a279-a324;
a324=2.*a705;
a354=a354*a324;
a591=a591*a705;
a383=a383*a821;
a591=a591+a383;
a588=a588*a591;
a354=a354+a588;
a279=a279-a354;
a299=a299*a279;
a279=a288*a299;
a279=a279+a819;
a354=a032<=a658;
a658=a658<=a032;
a658=a658+a354;
a354=a354/a658;
a658=a286*a809;
a588=a288*a671;
a658=a658+a588;
a354=a354*a658;
a658=a039*a354;
a588=a593*a658;
a591=a578*a819;
a588=a588+a591;
a588=a285*a588;
a591=a397*a588;
a383=2.*a270;
a383=a383*a354;
a821=a357*a383;
a591=a591-a821;
a819=a587*a819;
a397=a397*a354;
a383=a270*a383;
a397=a397+a383;
a397=a285*a397;
a593=a593*a397;
a819=a819-a593;
a819=a039*a819;
a591=a591-a819;
a819=-a354;
a819=2.*a819;
a562=a562*a819;
a270=a270*a588;
a357=a357*a354;
a270=a270-a357;
a417=a417*a270;
a562=a562+a417;
a591=a591+a562;
a659=a659*a591;
a591=a288*a659;
a279=a279-a591;
a673=a673*a279;
a621=a621*a673;
a591=a621/a712;
a562=a574/a712;
a562=a562*a814;
a591=a591-a562;
a060=a060*a591;
a808=a808+a060;
a060=2.*a787;
a060=a721*a060;
a304=a304/a268;
a562=a564/a268;
a562=a562*a501;
a304=a304-a562;
a559=a559*a304;
a574=a574*a787;
a591=a651*a591;
a574=a574+a591;
a563=a563*a574;
a591=2.*a785;
a551=a551*a591;
a541=a714*a541;
a536=a536*a574;
a541=a541+a536;
a536=a058*a541;
a273=a273*a536;
a551=a551+a273;
a541=a035*a541;
a551=a551-a541;
a786=a543*a786;
a714=a714*a572;
a327=a327*a574;
a714=a714+a327;
a246=a246*a714;
a323=a323*a246;
a786=a786+a323;
a551=a551+a786;
a786=2.*a785;
a720=a720*a786;
a543=a543*a785;
a546=a546*a246;
a543=a543+a546;
a719=a719*a543;
a720=a720+a719;
a551=a551+a720;
a716=a716*a551;
a550=a550*a716;
a716=a506*a550;
a716=a563+a716;
a564=a564*a716;
a559=a559+a564;
a564=a559/a311;
a721=a721/a311;
a721=a721*a800;
a564=a564-a721;
a571=a571*a564;
a060=a060+a571;
a808=a808+a060;
a697=a723*a697;
a716=a716/a268;
a268=a722/a268;
a268=a268*a501;
a716=a716-a268;
a268=a716/a311;
a060=a723/a311;
a060=a060*a800;
a268=a268-a060;
a622=a622*a268;
a697=a697+a622;
a808=a808-a697;
a697=2.*a787;
a697=a727*a697;
a783=a726*a783;
a622=a621/a712;
a725=a725/a712;
a725=a725*a814;
a622=a622-a725;
a723=a723*a787;
a651=a651*a268;
a723=a723+a651;
a622=a622-a723;
a298=a298*a622;
a783=a783+a298;
a783=a783/a728;
a728=a727/a728;
a298=2.*a805;
a728=a728*a298;
a783=a783-a728;
a724=a724*a783;
a697=a697+a724;
a808=a808+a697;
a797=a747*a797;
a697=a741*a672;
a724=a739*a678;
a670=a738*a670;
a655=a736*a655;
a726=a726*a805;
a642=a642*a622;
a726=a726+a642;
a411=a411*a726;
a655=a655+a411;
a735=a735*a655;
a530=sin(a530);
a530=a530*a792;
a737=a737*a530;
a735=a735-a737;
a402=a402*a735;
a670=a670+a402;
a670=a670/a740;
a740=a739/a740;
a648=2.*a648;
a648=a648*a793;
a740=a740*a648;
a670=a670-a740;
a394=a394*a670;
a724=a724+a394;
a724=a724/a742;
a742=a741/a742;
a630=2.*a630;
a630=a630*a795;
a742=a742*a630;
a724=a724-a742;
a742=a429*a724;
a697=a697+a742;
a742=a739*a672;
a630=a429*a670;
a742=a742+a630;
a652=a652*a742;
a678=a744*a678;
a652=a652-a678;
a697=a697+a652;
a732=a732*a697;
a729=a729*a732;
a652=a729/a326;
a678=a747/a326;
a678=a678*a803;
a652=a652-a678;
a709=a709*a652;
a797=a797+a709;
a709=a797/a251;
a749=a749/a251;
a749=a749*a507;
a709=a709-a749;
a808=a808+a709;
a787=2.*a787;
a787=a782*a787;
a807=2.*a807;
a807=a753*a807;
a790=a790/a311;
a709=a752/a311;
a709=a709*a800;
a790=a790-a709;
a722=a722*a790;
a752=a752*a716;
a722=a722+a752;
a501=a501/a311;
a311=a754/a311;
a311=a311*a800;
a501=a501-a311;
a718=a718*a501;
a754=a754*a559;
a718=a718+a754;
a722=a722-a718;
a534=a534/a712;
a718=a755/a712;
a718=a718*a814;
a534=a534-a718;
a534=a575*a534;
a755=a755*a621;
a534=a534+a755;
a388=a388/a712;
a755=a757/a712;
a755=a755*a814;
a388=a388-a755;
a575=a575*a388;
a757=a757*a621;
a575=a575+a757;
a534=a534+a575;
a812=a812/a712;
a575=a758/a712;
a575=a575*a814;
a812=a812-a575;
a812=a779*a812;
a810=a583*a810;
a575=a767*a803;
a757=cos(a505);
a757=a757*a656;
a621=a580*a757;
a388=a766*a818;
a621=a621+a388;
a388=a768*a816;
a755=sin(a505);
a755=a755*a656;
a718=a419*a755;
a388=a388-a718;
a621=a621+a388;
a388=a326*a621;
a575=a575+a388;
a388=a390*a575;
a718=a769*a685;
a388=a388-a718;
a718=2.*a811;
a718=a589*a718;
a299=a286*a299;
a659=a286*a659;
a299=a299+a659;
a366=a366*a673;
a609=a609*a279;
a366=a366-a609;
a299=a299+a366;
a299=a299/a305;
a589=a589/a305;
a809=-a809;
a809=2.*a809;
a589=a589*a809;
a299=a299-a589;
a771=a771*a299;
a718=a718+a771;
a388=a388+a718;
a667=a667*a388;
a817=a770*a817;
a667=a667-a817;
a667=a285*a667;
a624=a624*a667;
a810=a810+a624;
a263=a770*a263;
a586=a586*a388;
a263=a263+a586;
a263=a039*a263;
a810=a810-a263;
a263=2.*a576;
a118=a118*a263;
a583=a583*a576;
a545=a545*a667;
a583=a583+a545;
a679=a679*a583;
a118=a118+a679;
a810=a810+a118;
a765=a765*a810;
a810=a288*a765;
a810=a810-a388;
a538=a770*a538;
a626=a626*a388;
a538=a538+a626;
a538=a039*a538;
a704=a775*a704;
a584=a584*a388;
a770=a770*a643;
a584=a584-a770;
a285=a285*a584;
a567=a567*a285;
a704=a704+a567;
a538=a538-a704;
a704=2.*a540;
a777=a777*a704;
a775=a775*a540;
a544=a544*a285;
a775=a775+a544;
a776=a776*a775;
a777=a777+a776;
a538=a538-a777;
a773=a773*a538;
a288=a288*a773;
a810=a810-a288;
a762=a762*a810;
a759=a759*a762;
a758=a758*a759;
a812=a812+a758;
a534=a534+a812;
a534=a534/a780;
a756=a756/a780;
a780=2.*a814;
a756=a756*a780;
a534=a534-a756;
a722=a722-a534;
a722=a722/a781;
a781=a753/a781;
a800=2.*a800;
a781=a781*a800;
a722=a722-a781;
a751=a751*a722;
a807=a807+a751;
a750=a750*a807;
a787=a787+a750;
a808=a808+a787;
a787=a631*a808;
a784=a784+a787;
a002=a002-a784;
a787=a693/a251;
a750=a787*a748;
a751=2.*a251;
a750=a750/a751;
a727=a727-a750;
a781=2.*a691;
a781=a727*a781;
a800=2.*a290;
a534=a798/a251;
a251=a787/a251;
a251=a251*a507;
a534=a534-a251;
a748=a748*a534;
a787=a787*a797;
a748=a748+a787;
a748=a748/a751;
a750=a750/a751;
a507=2.*a507;
a750=a750*a507;
a748=a748-a750;
a783=a783-a748;
a748=a800*a783;
a781=a781+a748;
a759=a759/a712;
a779=a779/a712;
a712=a779/a712;
a712=a712*a814;
a759=a759-a712;
a781=a781+a759;
a691=2.*a691;
a691=a782*a691;
a290=2.*a290;
a807=a290*a807;
a691=a691+a807;
a781=a781+a691;
a691=a620*a781;
a800=a800*a727;
a800=a800+a779;
a290=a290*a782;
a800=a800+a290;
a802=a800*a802;
a691=a691-a802;
a002=a002+a691;
a802=arg[2]? arg[2][23] : 0;
a290=casadi_sq(a210);
a782=arg[2]? arg[2][24] : 0;
a779=a290*a782;
a802=a802+a779;
a779=a802*a219;
a807=a779*a015;
a807=a807/a222;
a759=a807/a222;
a712=a759*a316;
a814=casadi_sq(a056);
a814=a814+a216;
a748=a056/a814;
a750=arg[2]? arg[2][65] : 0;
a507=arg[2]? arg[2][60] : 0;
a751=a507*a219;
a787=a751*a090;
a797=a750*a787;
a534=arg[2]? arg[2][57] : 0;
a251=a219*a093;
a756=a534*a251;
a797=a797+a756;
a756=a748*a797;
a712=a712-a756;
a221=a221/a222;
a756=a032<=a228;
a780=a228<=a032;
a780=a780+a756;
a756=a756/a780;
a780=a337*a334;
a309=a309+a780;
a780=a313*a325;
a309=a309-a780;
a780=a309*a322;
a812=a293*a382;
a780=a780-a812;
a812=a032<=a076;
a076=a076<=a032;
a076=a076+a812;
a812=a812/a076;
a076=a253*a364;
a076=a812*a076;
a758=a079*a076;
a780=a780+a758;
a758=a256<=a257;
a257=a257<=a256;
a257=a257+a758;
a758=a758/a257;
a257=a244*a309;
a288=a257*a321;
a538=a244*a293;
a777=a538*a380;
a288=a288-a777;
a254=a254/a260;
a777=a254*a363;
a288=a288-a777;
a278=a278/a260;
a307=a286*a307;
a387=a286*a387;
a307=a307+a387;
a373=a373/a374;
a391=a373*a391;
a376=a376/a377;
a385=a376*a385;
a391=a391-a385;
a307=a307+a391;
a391=a278*a307;
a288=a288-a391;
a391=a255*a288;
a391=a758*a391;
a385=a258*a391;
a780=a780+a385;
a780=a756*a780;
a385=a780/a243;
a377=a225*a385;
a374=a032<=a234;
a234=a234<=a032;
a234=a234+a374;
a374=a374/a234;
a234=a573*a570;
a548=a548+a234;
a234=a552*a561;
a548=a548-a234;
a234=a548*a558;
a387=a032<=a389;
a389=a389<=a032;
a389=a389+a387;
a387=a387/a389;
a389=a369*a619;
a389=a387*a389;
a777=a287*a389;
a234=a234+a777;
a777=a532*a641;
a234=a234+a777;
a777=a256<=a284;
a284=a284<=a256;
a284=a284+a777;
a777=a777/a284;
a284=a390*a548;
a776=a284*a555;
a291=a291/a282;
a775=a291*a618;
a776=a776-a775;
a775=a390*a532;
a544=a775*a639;
a776=a776+a544;
a335=a335/a282;
a565=a286*a565;
a647=a286*a647;
a565=a565+a647;
a632=a632/a633;
a650=a632*a650;
a635=a635/a636;
a644=a635*a644;
a650=a650-a644;
a565=a565+a650;
a650=a335*a565;
a776=a776-a650;
a650=a565/a282;
a644=a247*a650;
a776=a776+a644;
a644=a336*a776;
a644=a777*a644;
a636=a329*a644;
a234=a234+a636;
a636=a422*a769;
a234=a234-a636;
a636=a587*a578;
a306=a306+a636;
a636=a595*a592;
a306=a306-a636;
a636=a306*a581;
a234=a234+a636;
a636=a032<=a371;
a371=a371<=a032;
a371=a371+a636;
a636=a636/a371;
a371=a693*a747;
a371=a636*a371;
a633=a287*a371;
a234=a234+a633;
a633=a256<=a302;
a302=a302<=a256;
a302=a302+a633;
a633=a633/a302;
a302=a390*a306;
a256=a302*a597;
a647=a390*a422;
a544=a647*a767;
a256=a256-a544;
a623=a623/a326;
a544=a623*a746;
a256=a256-a544;
a560=a560/a326;
a340=a286*a340;
a774=a286*a774;
a340=a340+a774;
a760=a760/a761;
a778=a760*a778;
a763=a763/a764;
a772=a763*a772;
a778=a778-a772;
a340=a340+a778;
a778=a560*a340;
a256=a256-a778;
a778=a340/a326;
a772=a690*a778;
a256=a256+a772;
a772=a661*a256;
a772=a633*a772;
a764=a329*a772;
a234=a234+a764;
a234=a374*a234;
a764=a234/a243;
a761=a039*a764;
a774=a177*a761;
a377=a377-a774;
a774=a221*a377;
a712=a712+a774;
a774=2.*a222;
a712=a712/a774;
a544=2.5000000000000000e-01;
a214=a544*a214;
a285=arg[2]? arg[2][66] : 0;
a540=casadi_sq(a507);
a704=a285*a540;
a567=a704*a090;
a584=arg[2]? arg[2][58] : 0;
a770=a584*a507;
a643=a770*a093;
a567=a567+a643;
a643=a025*a567;
a388=a010*a643;
a626=a214*a388;
a118=sqrt(a217);
a679=2.*a118;
a626=a626/a679;
a583=arg[2]? arg[2][64] : 0;
a545=arg[1]? arg[1][9] : 0;
a667=a583*a545;
a576=atan2(a056,a222);
a263=a750*a576;
a667=a667+a263;
a263=arg[2]? arg[2][67] : 0;
a586=a263*a065;
a667=a667+a586;
a586=a667*a090;
a624=a507*a586;
a817=a534*a576;
a718=arg[2]? arg[2][59] : 0;
a771=a718*a065;
a817=a817+a771;
a771=a817*a093;
a624=a624+a771;
a771=a316/a222;
a299=a015*a771;
a589=a802*a299;
a624=a624-a589;
a589=a385-a761;
a809=a237*a589;
a305=a235*a809;
a624=a624+a305;
a305=a377/a222;
a366=a015*a305;
a609=a210*a366;
a624=a624-a609;
a609=a025*a624;
a279=a215*a609;
a279=a626+a279;
a673=a712+a279;
a659=2.*a131;
a659=a673*a659;
a754=2.*a015;
a559=arg[10]? arg[10][23] : 0;
a501=2.*a210;
a501=a501*a467;
a311=a782*a501;
a752=arg[10]? arg[10][24] : 0;
a716=a290*a752;
a311=a311+a716;
a559=a559+a311;
a311=a219*a559;
a716=a802*a479;
a311=a311+a716;
a716=a015*a311;
a790=a779*a131;
a716=a716+a790;
a716=a716/a222;
a790=a807/a222;
a790=a790*a482;
a716=a716-a790;
a790=a716/a222;
a709=a759/a222;
a709=a709*a482;
a790=a790-a709;
a790=a316*a790;
a759=a759*a525;
a790=a790+a759;
a759=a162/a814;
a709=a748/a814;
a749=2.*a056;
a749=a749*a162;
a749=a749+a477;
a709=a709*a749;
a759=a759-a709;
a759=a797*a759;
a709=arg[10]? arg[10][65] : 0;
a477=a787*a709;
a678=arg[10]? arg[10][60] : 0;
a630=a219*a678;
a795=a507*a479;
a630=a630+a795;
a795=a090*a630;
a394=a751*a174;
a795=a795+a394;
a394=a750*a795;
a477=a477+a394;
a394=arg[10]? arg[10][57] : 0;
a740=a251*a394;
a648=a093*a479;
a793=a219*a175;
a648=a648+a793;
a793=a534*a648;
a740=a740+a793;
a477=a477+a740;
a748=a748*a477;
a759=a759+a748;
a790=a790-a759;
a480=a480/a222;
a759=a221/a222;
a759=a759*a482;
a480=a480-a759;
a480=a377*a480;
a759=a385*a484;
a337=a337*a330;
a334=a334*a333;
a337=a337-a334;
a308=a308+a337;
a325=a325*a303;
a313=a313*a531;
a325=a325-a313;
a308=a308-a325;
a322=a322*a308;
a249=a309*a249;
a322=a322+a249;
a382=a382*a517;
a300=a293*a300;
a382=a382+a300;
a322=a322-a382;
a431=a076*a431;
a364=a364*a432;
a253=a253*a420;
a364=a364+a253;
a812=a812*a364;
a079=a079*a812;
a431=a431+a079;
a322=a322+a431;
a515=a391*a515;
a511=a288*a511;
a309=a309*a433;
a308=a244*a308;
a309=a309+a308;
a321=a321*a309;
a528=a257*a528;
a321=a321+a528;
a293=a293*a433;
a517=a244*a517;
a293=a293+a517;
a380=a380*a293;
a245=a538*a245;
a380=a380+a245;
a321=a321-a380;
a430=a430/a260;
a380=a254/a260;
a380=a380*a512;
a430=a430-a380;
a363=a363*a430;
a254=a254*a346;
a363=a363+a254;
a321=a321-a363;
a519=a519/a260;
a363=a278/a260;
a363=a363*a512;
a519=a519-a363;
a519=a307*a519;
a378=a286*a378;
a386=a286*a386;
a378=a378+a386;
a373=a373*a375;
a376=a376*a516;
a373=a373-a376;
a378=a378+a373;
a278=a278*a378;
a519=a519+a278;
a321=a321-a519;
a255=a255*a321;
a511=a511+a255;
a758=a758*a511;
a258=a258*a758;
a515=a515+a258;
a322=a322+a515;
a756=a756*a322;
a322=a756/a243;
a515=a385/a243;
a515=a515*a503;
a322=a322-a515;
a515=a225*a322;
a759=a759+a515;
a405=a761*a405;
a573=a573*a566;
a570=a570*a569;
a573=a573-a570;
a547=a547+a573;
a561=a561*a542;
a552=a552*a717;
a561=a561-a552;
a547=a547-a561;
a558=a558*a547;
a339=a548*a339;
a558=a558+a339;
a339=a389*a683;
a619=a619*a487;
a369=a369*a295;
a619=a619+a369;
a387=a387*a619;
a619=a287*a387;
a339=a339+a619;
a558=a558+a339;
a641=a641*a706;
a577=a532*a577;
a641=a641+a577;
a558=a558+a641;
a641=a644*a698;
a694=a776*a694;
a547=a390*a547;
a548=a548*a685;
a547=a547-a548;
a555=a555*a547;
a096=a284*a096;
a555=a555+a096;
a684=a684/a282;
a096=a291/a282;
a096=a096*a695;
a684=a684-a096;
a618=a618*a684;
a291=a291*a601;
a618=a618+a291;
a555=a555-a618;
a706=a390*a706;
a532=a532*a685;
a706=a706-a532;
a639=a639*a706;
a539=a775*a539;
a639=a639+a539;
a555=a555+a639;
a708=a708/a282;
a639=a335/a282;
a639=a639*a695;
a708=a708-a639;
a565=a565*a708;
a637=a286*a637;
a645=a286*a645;
a637=a637+a645;
a632=a632*a634;
a635=a635*a533;
a632=a632-a635;
a637=a637+a632;
a335=a335*a637;
a565=a565+a335;
a555=a555-a565;
a396=a650*a396;
a637=a637/a282;
a565=a650/a282;
a565=a565*a695;
a637=a637-a565;
a247=a247*a637;
a396=a396+a247;
a555=a555+a396;
a336=a336*a555;
a694=a694+a336;
a777=a777*a694;
a694=a329*a777;
a641=a641+a694;
a558=a558+a641;
a769=a769*a811;
a575=a422*a575;
a769=a769+a575;
a558=a558-a769;
a587=a587*a658;
a578=a578*a397;
a587=a587-a578;
a671=a671+a587;
a592=a592*a612;
a595=a595*a822;
a592=a592-a595;
a671=a671-a592;
a581=a581*a671;
a590=a306*a590;
a581=a581+a590;
a558=a558+a581;
a683=a371*a683;
a747=a747*a798;
a693=a693*a652;
a747=a747+a693;
a636=a636*a747;
a287=a287*a636;
a683=a683+a287;
a558=a558+a683;
a698=a772*a698;
a801=a256*a801;
a671=a390*a671;
a306=a306*a685;
a671=a671-a306;
a597=a597*a671;
a338=a302*a338;
a597=a597+a338;
a811=a390*a811;
a422=a422*a685;
a811=a811-a422;
a767=a767*a811;
a621=a647*a621;
a767=a767+a621;
a597=a597-a767;
a682=a682/a326;
a767=a623/a326;
a767=a767*a803;
a682=a682-a767;
a746=a746*a682;
a623=a623*a729;
a746=a746+a623;
a597=a597-a746;
a813=a813/a326;
a746=a560/a326;
a746=a746*a803;
a813=a813-a746;
a340=a340*a813;
a765=a286*a765;
a286=a286*a773;
a765=a765+a286;
a760=a760*a762;
a763=a763*a810;
a760=a760-a763;
a765=a765+a760;
a560=a560*a765;
a340=a340+a560;
a597=a597-a340;
a283=a778*a283;
a765=a765/a326;
a340=a778/a326;
a340=a340*a803;
a765=a765-a340;
a690=a690*a765;
a283=a283+a690;
a597=a597+a283;
a661=a661*a597;
a801=a801+a661;
a633=a633*a801;
a329=a329*a633;
a698=a698+a329;
a558=a558+a698;
a374=a374*a558;
a558=a374/a243;
a764=a764/a243;
a764=a764*a503;
a558=a558-a764;
a558=a039*a558;
a177=a177*a558;
a405=a405+a177;
a759=a759-a405;
a221=a221*a759;
a480=a480+a221;
a790=a790+a480;
a790=a790/a774;
a712=a712/a774;
a774=2.*a482;
a712=a712*a774;
a790=a790-a712;
a474=a544*a474;
a712=a388*a474;
a774=a643*a008;
a480=a567*a144;
a221=arg[10]? arg[10][66] : 0;
a405=a540*a221;
a177=2.*a507;
a177=a177*a678;
a764=a285*a177;
a405=a405+a764;
a764=a090*a405;
a698=a704*a174;
a764=a764+a698;
a698=arg[10]? arg[10][58] : 0;
a329=a507*a698;
a801=a584*a678;
a329=a329+a801;
a801=a093*a329;
a661=a770*a175;
a801=a801+a661;
a764=a764+a801;
a801=a025*a764;
a480=a480+a801;
a801=a010*a480;
a774=a774+a801;
a801=a214*a774;
a712=a712+a801;
a712=a712/a679;
a626=a626/a679;
a679=2.*a118;
a679=a478/a679;
a801=2.*a679;
a626=a626*a801;
a712=a712-a626;
a475=a609*a475;
a626=a624*a144;
a801=a586*a678;
a661=arg[10]? arg[10][64] : 0;
a690=a545*a661;
a340=arg[9]? arg[9][9] : 0;
a560=a583*a340;
a690=a690+a560;
a709=a576*a709;
a560=casadi_sq(a056);
a560=a560+a216;
a216=a222/a560;
a216=a216*a162;
a560=a056/a560;
a560=a560*a482;
a216=a216-a560;
a750=a750*a216;
a709=a709+a750;
a690=a690+a709;
a709=arg[10]? arg[10][67] : 0;
a750=a065*a709;
a560=a263*a152;
a750=a750+a560;
a690=a690+a750;
a750=a090*a690;
a560=a667*a174;
a750=a750+a560;
a560=a507*a750;
a801=a801+a560;
a394=a576*a394;
a534=a534*a216;
a394=a394+a534;
a534=arg[10]? arg[10][59] : 0;
a560=a065*a534;
a760=a718*a152;
a560=a560+a760;
a394=a394+a560;
a560=a093*a394;
a760=a817*a175;
a560=a560+a760;
a801=a801+a560;
a559=a299*a559;
a560=a771*a131;
a760=a525/a222;
a763=a771/a222;
a763=a763*a482;
a760=a760-a763;
a763=a015*a760;
a560=a560+a763;
a802=a802*a560;
a559=a559+a802;
a801=a801-a559;
a493=a809*a493;
a497=a589*a497;
a559=a322-a558;
a237=a237*a559;
a497=a497+a237;
a235=a235*a497;
a493=a493+a235;
a801=a801+a493;
a493=a366*a467;
a131=a305*a131;
a235=a759/a222;
a237=a305/a222;
a237=a237*a482;
a235=a235-a237;
a015=a015*a235;
a131=a131+a015;
a015=a210*a131;
a493=a493+a015;
a801=a801-a493;
a493=a025*a801;
a626=a626+a493;
a215=a215*a626;
a475=a475+a215;
a712=a712+a475;
a790=a790+a712;
a790=a754*a790;
a659=a659+a790;
a311=a771*a311;
a760=a779*a760;
a311=a311+a760;
a472=a305*a472;
a235=a220*a235;
a472=a472+a235;
a311=a311+a472;
a659=a659-a311;
a002=a002+a659;
a311=a032<=a062;
a062=a062<=a032;
a062=a062+a311;
a311=a311/a062;
a062=a231*a589;
a062=a062-a377;
a472=a197*a062;
a235=a311*a472;
a760=a150<=a030;
a030=a030<=a150;
a030=a030+a760;
a760=a760/a030;
a030=a032<=a082;
a082=a082<=a032;
a082=a082+a030;
a030=a030/a082;
a082=2.*a081;
a150=a040*a472;
a790=a058*a150;
a475=a082*a790;
a150=a035*a150;
a475=a475-a150;
a150=a085*a472;
a150=a020*a150;
a215=a021*a150;
a475=a475+a215;
a215=2.*a081;
a493=a081*a150;
a015=a215*a493;
a475=a475+a015;
a475=a030*a475;
a475=a760*a475;
a475=a009*a475;
a235=a235+a475;
a475=a235*a460;
a453=a062*a453;
a490=a589*a490;
a231=a231*a559;
a490=a490+a231;
a490=a490-a759;
a197=a197*a490;
a453=a453+a197;
a311=a311*a453;
a197=2.*a456;
a790=a790*a197;
a457=a472*a457;
a040=a040*a453;
a457=a457+a040;
a058=a058*a457;
a082=a082*a058;
a790=a790+a082;
a035=a035*a457;
a790=a790-a035;
a461=a150*a461;
a472=a472*a463;
a085=a085*a453;
a472=a472+a085;
a472=a020*a472;
a021=a021*a472;
a461=a461+a021;
a790=a790+a461;
a461=2.*a456;
a493=a493*a461;
a150=a150*a456;
a081=a081*a472;
a150=a150+a081;
a215=a215*a150;
a493=a493+a215;
a790=a790+a493;
a030=a030*a790;
a760=a760*a030;
a009=a009*a760;
a311=a311+a009;
a009=a083*a311;
a475=a475+a009;
a009=a071*a235;
a760=2.*a083;
a009=a009/a760;
a030=2.*a458;
a030=a009*a030;
a790=2.*a071;
a458=a235*a458;
a071=a071*a311;
a458=a458+a071;
a458=a458/a760;
a760=a009/a760;
a460=2.*a460;
a760=a760*a460;
a458=a458-a760;
a458=a790*a458;
a030=a030+a458;
a475=a475+a030;
a002=a002+a475;
if (res[0]!=0) res[0][0]=a002;
a002=cos(a001);
a002=a002*a005;
a030=sin(a001);
a030=a030*a003;
a030=a000*a030;
a002=a002-a030;
a030=cos(a001);
a030=a030*a003;
a030=a007*a030;
a458=sin(a001);
a458=a458*a006;
a030=a030+a458;
a002=a002-a030;
a166=a166/a095;
a063=a063/a095;
a095=a063/a095;
a095=a095*a180;
a166=a166-a095;
a166=a114*a166;
a095=a063*a043;
a166=a166+a095;
a153=2.*a153;
a153=a094*a153;
a053=2.*a053;
a171=a053*a171;
a153=a153+a171;
a166=a166-a153;
a002=a002+a166;
a153=a059*a413;
a412=a345*a412;
a153=a153-a412;
a508=a368*a508;
a412=a248*a367;
a508=a508+a412;
a153=a153+a508;
a002=a002+a153;
a508=a522*a703;
a662=a579*a662;
a508=a508-a662;
a662=a654*a808;
a788=a568*a788;
a662=a662-a788;
a508=a508+a662;
a662=a800-a687;
a692=a662*a692;
a788=a781-a653;
a412=a281*a788;
a692=a692+a412;
a508=a508+a692;
a002=a002+a508;
a482=a482/a814;
a222=a222/a814;
a814=a222/a814;
a814=a814*a749;
a482=a482-a814;
a482=a797*a482;
a477=a222*a477;
a482=a482+a477;
a162=2.*a162;
a162=a279*a162;
a056=2.*a056;
a712=a056*a712;
a162=a162+a712;
a482=a482+a162;
a002=a002+a482;
a162=a315*a008;
a712=a010*a524;
a162=a162+a712;
a002=a002+a162;
if (res[0]!=0) res[0][1]=a002;
a002=arg[12]? arg[12][5] : 0;
a162=a004*a129;
a712=a012*a011;
a162=a162+a712;
a002=a002-a162;
a474=a118*a474;
a162=a214*a679;
a474=a474+a162;
a643=a643*a474;
a214=a214*a118;
a480=a214*a480;
a643=a643+a480;
a002=a002+a643;
a063=a063*a114;
a053=a053*a094;
a063=a063-a053;
a053=a063*a155;
a094=a049*a166;
a053=a053+a094;
a002=a002+a053;
a059=a059*a345;
a248=a248*a368;
a059=a059+a248;
a410=a059*a410;
a125=a125*a153;
a410=a410+a125;
a002=a002+a410;
a620=a620*a800;
a510=a510*a579;
a292=a292*a687;
a510=a510+a292;
a631=a631*a568;
a510=a510+a631;
a620=a620-a510;
a510=a620*a665;
a657=a657+a689;
a657=a657+a784;
a691=a691-a657;
a657=a275*a691;
a510=a510+a657;
a510=a039*a510;
a002=a002+a510;
a522=a522*a579;
a654=a654*a568;
a522=a522+a654;
a281=a281*a662;
a522=a522+a281;
a281=a522*a484;
a654=a225*a508;
a281=a281+a654;
a002=a002+a281;
a281=a315*a161;
a654=a054*a524;
a281=a281+a654;
a002=a002+a281;
if (res[0]!=0) res[0][2]=a002;
if (res[0]!=0) res[0][3]=a032;
if (res[0]!=0) res[0][4]=a032;
a002=cos(a001);
a281=a000*a129;
a654=a012*a005;
a281=a281+a654;
a002=a002*a281;
a281=a012*a000;
a654=sin(a001);
a654=a654*a003;
a281=a281*a654;
a002=a002-a281;
a281=a054*a000;
a654=cos(a001);
a654=a654*a003;
a281=a281*a654;
a654=sin(a001);
a000=a000*a161;
a005=a054*a005;
a000=a000+a005;
a654=a654*a000;
a281=a281+a654;
a002=a002-a281;
a281=cos(a001);
a161=a007*a161;
a654=a054*a006;
a161=a161+a654;
a281=a281*a161;
a054=a054*a007;
a161=sin(a001);
a161=a161*a003;
a054=a054*a161;
a281=a281-a054;
a002=a002-a281;
a281=a012*a007;
a054=cos(a001);
a054=a054*a003;
a281=a281*a054;
a054=sin(a001);
a007=a007*a129;
a006=a012*a006;
a007=a007+a006;
a054=a054*a007;
a281=a281+a054;
a002=a002-a281;
a281=cos(a001);
a222=a222*a797;
a056=a056*a279;
a222=a222+a056;
a222=a063+a222;
a056=a222*a130;
a482=a166+a482;
a279=a013*a482;
a056=a056+a279;
a281=a281*a056;
a056=a013*a222;
a279=sin(a001);
a279=a279*a003;
a056=a056*a279;
a281=a281-a056;
a002=a002+a281;
a281=a016*a222;
a056=cos(a001);
a056=a056*a003;
a281=a281*a056;
a056=sin(a001);
a279=a222*a133;
a797=a016*a482;
a279=a279+a797;
a056=a056*a279;
a281=a281+a056;
a002=a002+a281;
a281=cos(a001);
a019=a019*a122;
a038=a038*a127;
a019=a019+a038;
a754=a754*a673;
a779=a779*a771;
a220=a220*a305;
a779=a779+a220;
a754=a754-a779;
a019=a019+a754;
a083=a083*a235;
a790=a790*a009;
a083=a083+a790;
a019=a019+a083;
a133=a019*a133;
a136=a136+a659;
a136=a136+a475;
a475=a016*a136;
a133=a133+a475;
a281=a281*a133;
a016=a016*a019;
a133=sin(a001);
a133=a133*a003;
a016=a016*a133;
a281=a281-a016;
a002=a002-a281;
a281=a013*a019;
a016=cos(a001);
a016=a016*a003;
a281=a281*a016;
a001=sin(a001);
a130=a019*a130;
a013=a013*a136;
a130=a130+a013;
a001=a001*a130;
a281=a281+a001;
a002=a002+a281;
if (res[0]!=0) res[0][5]=a002;
a165=a222*a165;
a057=a057*a482;
a165=a165+a057;
a014=a014*a136;
a132=a019*a132;
a014=a014-a132;
a165=a165-a014;
if (res[1]!=0) res[1][0]=a165;
a055=a055*a482;
a222=a222*a163;
a055=a055-a222;
a019=a019*a135;
a017=a017*a136;
a019=a019+a017;
a055=a055+a019;
a055=-a055;
if (res[1]!=0) res[1][1]=a055;
a055=a242*a589;
a500=a055*a500;
a242=a242*a559;
a502=a589*a502;
a242=a242-a502;
a240=a240*a242;
a500=a500+a240;
a500=a525+a500;
a031=a031+a311;
a311=a031/a028;
a122=a122+a235;
a235=a122/a028;
a235=a235/a028;
a235=a235*a142;
a311=a311-a235;
a311=2.*a311;
a500=a500+a311;
if (res[1]!=0) res[1][2]=a500;
a500=a236*a589;
a499=a500*a499;
a495=a589*a495;
a236=a236*a559;
a495=a495+a236;
a239=a239*a495;
a499=a499+a239;
a239=a181<=a108;
a108=a108<=a181;
a181=a108+a239;
a239=a239/a181;
a236=a069<=a182;
a182=a182<=a069;
a069=a182+a236;
a236=a236/a069;
a311=a032<=a077;
a077=a077<=a032;
a077=a077+a311;
a311=a311/a077;
a077=a172*a062;
a235=a196*a077;
a240=a025*a235;
a502=a193*a240;
a502=a039*a502;
a019=a191*a502;
a019=a039*a019;
a017=a192*a502;
a017=a072*a017;
a136=a190*a017;
a019=a019-a136;
a136=2.*a183;
a135=a183*a017;
a222=a136*a135;
a019=a019-a222;
a019=a311*a019;
a019=a075*a019;
a019=a019+a502;
a222=a032<=a184;
a184=a184<=a032;
a184=a184+a222;
a222=a222/a184;
a184=a188*a502;
a184=a072*a184;
a163=a186*a184;
a482=a187*a502;
a482=a039*a482;
a163=a163-a482;
a482=2.*a185;
a165=a185*a184;
a014=a482*a165;
a163=a163+a014;
a163=a222*a163;
a163=a075*a163;
a019=a019-a163;
a019=a236*a019;
a019=a239*a019;
a163=a146*a019;
a446=a163*a446;
a441=a019*a441;
a442=a502*a442;
a451=a240*a451;
a014=a235*a144;
a454=a077*a454;
a062=a062*a462;
a172=a172*a490;
a062=a062+a172;
a196=a196*a062;
a454=a454+a196;
a196=a025*a454;
a014=a014+a196;
a193=a193*a014;
a451=a451+a193;
a451=a039*a451;
a191=a191*a451;
a442=a442+a191;
a442=a039*a442;
a436=a017*a436;
a192=a192*a451;
a450=a502*a450;
a192=a192-a450;
a192=a072*a192;
a190=a190*a192;
a436=a436+a190;
a442=a442-a436;
a436=2.*a447;
a135=a135*a436;
a017=a017*a447;
a183=a183*a192;
a017=a017+a183;
a136=a136*a017;
a135=a135+a136;
a442=a442-a135;
a311=a311*a442;
a442=a075*a311;
a442=a442+a451;
a439=a184*a439;
a188=a188*a451;
a443=a502*a443;
a188=a188-a443;
a188=a072*a188;
a186=a186*a188;
a439=a439+a186;
a502=a502*a438;
a187=a187*a451;
a502=a502+a187;
a502=a039*a502;
a439=a439-a502;
a502=2.*a437;
a165=a165*a502;
a184=a184*a437;
a185=a185*a188;
a184=a184+a185;
a482=a482*a184;
a165=a165+a482;
a439=a439+a165;
a222=a222*a439;
a439=a075*a222;
a442=a442-a439;
a236=a236*a442;
a239=a239*a236;
a146=a146*a239;
a441=a441+a146;
a112=a112*a441;
a446=a446+a112;
a499=a499+a446;
if (res[1]!=0) res[1][3]=a499;
a550=a506*a550;
a563=a563+a550;
a778=a778*a815;
a549=a549*a765;
a778=a778+a549;
a563=a563+a778;
if (res[1]!=0) res[1][4]=a563;
a506=a506*a585;
a582=a582+a506;
a650=a650*a710;
a332=a332*a637;
a650=a650+a332;
a582=a582+a650;
if (res[1]!=0) res[1][5]=a582;
a582=sin(a037);
a650=a257*a260;
a332=a650*a137;
a710=a332*a320;
a506=a582*a710;
a585=cos(a037);
a563=a538*a260;
a778=a563*a320;
a549=a585*a778;
a506=a506-a549;
a549=sin(a037);
a815=a563*a316;
a550=a549*a815;
a506=a506+a550;
a550=cos(a037);
a499=a332*a316;
a446=a550*a499;
a506=a506+a446;
a446=cos(a037);
a112=a012*a345;
a146=a446*a112;
a506=a506-a146;
a146=sin(a037);
a439=a124*a345;
a165=a146*a439;
a506=a506-a165;
a165=cos(a037);
a482=a124*a368;
a184=a165*a482;
a506=a506+a184;
a184=sin(a037);
a185=a012*a368;
a188=a184*a185;
a506=a506-a188;
a188=a140*a506;
a399=a188*a399;
a437=cos(a037);
a437=a437*a400;
a710=a710*a437;
a309=a260*a309;
a257=a257*a512;
a309=a309+a257;
a137=a137*a309;
a257=a650*a401;
a137=a137-a257;
a257=a320*a137;
a437=a332*a527;
a257=a257+a437;
a582=a582*a257;
a710=a710+a582;
a293=a260*a293;
a538=a538*a512;
a293=a293+a538;
a320=a320*a293;
a527=a563*a527;
a320=a320+a527;
a585=a585*a320;
a320=sin(a037);
a320=a320*a400;
a778=a778*a320;
a585=a585-a778;
a710=a710-a585;
a585=cos(a037);
a585=a585*a400;
a815=a815*a585;
a585=a316*a293;
a778=a563*a525;
a585=a585+a778;
a549=a549*a585;
a815=a815+a549;
a710=a710+a815;
a316=a316*a137;
a525=a332*a525;
a316=a316+a525;
a550=a550*a316;
a316=sin(a037);
a316=a316*a400;
a499=a499*a316;
a550=a550-a499;
a710=a710+a550;
a550=a345*a129;
a499=a012*a413;
a550=a550+a499;
a446=a446*a550;
a550=sin(a037);
a550=a550*a400;
a112=a112*a550;
a446=a446-a112;
a710=a710-a446;
a446=cos(a037);
a446=a446*a400;
a439=a439*a446;
a345=a345*a403;
a413=a124*a413;
a345=a345+a413;
a146=a146*a345;
a439=a439+a146;
a710=a710-a439;
a403=a368*a403;
a124=a124*a367;
a403=a403+a124;
a165=a165*a403;
a403=sin(a037);
a403=a403*a400;
a482=a482*a403;
a165=a165-a482;
a710=a710+a165;
a037=cos(a037);
a037=a037*a400;
a185=a185*a037;
a368=a368*a129;
a012=a012*a367;
a368=a368+a012;
a184=a184*a368;
a185=a185+a184;
a710=a710-a185;
a140=a140*a710;
a401=a506*a401;
a140=a140-a401;
a036=a036*a140;
a399=a399+a036;
a036=a263*a787;
a401=a718*a251;
a036=a036+a401;
a401=a068*a114;
a036=a036-a401;
a167=a036*a167;
a709=a787*a709;
a263=a263*a795;
a709=a709+a263;
a534=a251*a534;
a718=a718*a648;
a534=a534+a718;
a709=a709+a534;
a168=a114*a168;
a068=a068*a043;
a168=a168+a068;
a709=a709-a168;
a067=a067*a709;
a167=a167+a067;
a399=a399-a167;
if (res[1]!=0) res[1][6]=a399;
if (res[1]!=0) res[1][7]=a140;
if (res[1]!=0) res[1][8]=a709;
a661=a787*a661;
a583=a583*a795;
a661=a661+a583;
if (res[1]!=0) res[1][9]=a661;
a661=a090*a159;
a583=a052*a174;
a661=a661+a583;
a661=a175-a661;
if (res[1]!=0) res[1][10]=a661;
a706=a282*a706;
a661=a775*a695;
a706=a706+a661;
a661=a638*a706;
a775=a775*a282;
a629=a775*a629;
a661=a661+a629;
a547=a282*a547;
a695=a284*a695;
a547=a547+a695;
a695=a556*a547;
a284=a284*a282;
a715=a284*a715;
a695=a695-a715;
a661=a661-a695;
a695=a090*a661;
a638=a775*a638;
a556=a284*a556;
a638=a638-a556;
a556=a638*a174;
a695=a695+a556;
a811=a326*a811;
a556=a647*a803;
a811=a811+a556;
a556=a766*a811;
a647=a647*a326;
a757=a647*a757;
a556=a556+a757;
a671=a326*a671;
a803=a302*a803;
a671=a671+a803;
a803=a145*a671;
a302=a302*a326;
a820=a302*a820;
a803=a803-a820;
a556=a556+a803;
a803=a090*a556;
a766=a647*a766;
a145=a302*a145;
a766=a766+a145;
a145=a766*a174;
a803=a803+a145;
a695=a695-a803;
a803=a385*a435;
a322=a044*a322;
a803=a803+a322;
a695=a695+a803;
a803=a522*a008;
a508=a010*a508;
a803=a803+a508;
a695=a695+a803;
a686=a686/a243;
a126=a126/a243;
a803=a126/a243;
a803=a803*a503;
a686=a686-a803;
a686=a234*a686;
a374=a126*a374;
a686=a686+a374;
a481=a481/a243;
a228=a228/a243;
a243=a228/a243;
a243=a243*a503;
a481=a481-a243;
a481=a780*a481;
a756=a228*a756;
a481=a481+a756;
a686=a686-a481;
a695=a695+a686;
a224=a224*a695;
a481=a638*a090;
a756=a766*a090;
a481=a481-a756;
a385=a044*a385;
a481=a481+a385;
a522=a010*a522;
a481=a481+a522;
a126=a126*a234;
a228=a228*a780;
a126=a126-a228;
a481=a481+a126;
a485=a481*a485;
a224=a224-a485;
if (res[2]!=0) res[2][0]=a224;
a224=arg[1]? arg[1][10] : 0;
a485=a224*a090;
a228=a010*a063;
a780=a087*a104;
a234=a780*a090;
a228=a228-a234;
a485=a485+a228;
a234=a050*a485;
a522=cos(a047);
a522=a522*a157;
a234=a234*a522;
a522=sin(a047);
a158=a485*a158;
a385=arg[9]? arg[9][10] : 0;
a756=a090*a385;
a243=a224*a174;
a756=a756+a243;
a063=a063*a008;
a166=a010*a166;
a063=a063+a166;
a104=a104*a170;
a087=a087*a033;
a104=a104+a087;
a087=a090*a104;
a033=a780*a174;
a087=a087+a033;
a063=a063-a087;
a756=a756+a063;
a050=a050*a756;
a158=a158+a050;
a522=a522*a158;
a234=a234+a522;
a522=cos(a047);
a154=a228*a154;
a158=a046*a063;
a154=a154+a158;
a522=a522*a154;
a046=a046*a228;
a154=sin(a047);
a154=a154*a157;
a046=a046*a154;
a522=a522-a046;
a234=a234+a522;
a522=cos(a047);
a486=a481*a486;
a046=a226*a695;
a486=a486+a046;
a522=a522*a486;
a226=a226*a481;
a486=sin(a047);
a486=a486*a157;
a226=a226*a486;
a522=a522-a226;
a234=a234+a522;
a522=a223*a481;
a226=cos(a047);
a226=a226*a157;
a522=a522*a226;
a226=sin(a047);
a483=a481*a483;
a223=a223*a695;
a483=a483+a223;
a226=a226*a483;
a522=a522+a226;
a234=a234-a522;
a522=a241*a589;
a226=cos(a047);
a226=a226*a157;
a522=a522*a226;
a226=sin(a047);
a496=a589*a496;
a241=a241*a559;
a496=a496+a241;
a226=a226*a496;
a522=a522+a226;
a234=a234-a522;
a498=a500*a498;
a238=a238*a495;
a498=a498+a238;
a234=a234+a498;
a498=cos(a047);
a238=a198*a589;
a492=a238*a492;
a589=a589*a455;
a198=a198*a559;
a589=a589+a198;
a198=a232*a589;
a492=a492+a198;
a498=a498*a492;
a232=a232*a238;
a492=sin(a047);
a492=a492*a157;
a232=a232*a492;
a498=a498-a232;
a234=a234+a498;
a498=a229*a238;
a232=cos(a047);
a232=a232*a157;
a498=a498*a232;
a232=sin(a047);
a489=a238*a489;
a229=a229*a589;
a489=a489+a229;
a232=a232*a489;
a498=a498+a232;
a234=a234-a498;
a498=cos(a047);
a232=a010*a059;
a489=a563*a379;
a229=a332*a318;
a489=a489+a229;
a229=a489*a090;
a492=a232-a229;
a492=a492-a126;
a198=a044*a761;
a492=a492-a198;
a407=a492*a407;
a059=a059*a008;
a153=a010*a153;
a059=a059+a153;
a379=a379*a293;
a414=a563*a414;
a379=a379+a414;
a318=a318*a137;
a529=a332*a529;
a318=a318-a529;
a379=a379+a318;
a318=a090*a379;
a529=a489*a174;
a318=a318+a529;
a529=a059-a318;
a529=a529-a686;
a761=a761*a435;
a044=a044*a558;
a761=a761+a044;
a529=a529-a761;
a044=a128*a529;
a407=a407+a044;
a498=a498*a407;
a128=a128*a492;
a407=sin(a047);
a407=a407*a157;
a128=a128*a407;
a498=a498-a128;
a234=a234+a498;
a232=a232-a229;
a232=a232-a126;
a232=a232-a198;
a198=a034*a232;
a126=cos(a047);
a126=a126*a157;
a198=a198*a126;
a126=sin(a047);
a404=a232*a404;
a059=a059-a318;
a059=a059-a686;
a059=a059-a761;
a034=a034*a059;
a404=a404+a034;
a126=a126*a404;
a198=a198+a126;
a234=a234-a198;
a198=a201<=a042;
a042=a042<=a201;
a201=a042+a198;
a198=a198/a201;
a126=a200<=a203;
a203=a203<=a200;
a200=a203+a126;
a126=a126/a200;
a404=a032<=a199;
a199=a199<=a032;
a199=a199+a404;
a404=a404/a199;
a210=2.*a210;
a199=a219*a299;
a034=a782*a199;
a761=a210*a034;
a686=a219*a366;
a761=a761+a686;
a686=a213*a761;
a686=a072*a686;
a318=a211*a686;
a229=a212*a761;
a229=a039*a229;
a318=a318-a229;
a229=2.*a204;
a498=a204*a686;
a128=a229*a498;
a318=a318+a128;
a318=a404*a318;
a318=a075*a318;
a318=a318-a761;
a128=a032<=a205;
a205=a205<=a032;
a205=a205+a128;
a128=a128/a205;
a205=a208*a761;
a205=a039*a205;
a407=a209*a761;
a407=a072*a407;
a044=a207*a407;
a205=a205-a044;
a044=2.*a206;
a558=a206*a407;
a435=a044*a558;
a205=a205-a435;
a205=a128*a205;
a205=a075*a205;
a318=a318-a205;
a318=a126*a318;
a318=a198*a318;
a470=a318*a470;
a464=a686*a464;
a467=2.*a467;
a034=a034*a467;
a752=a199*a752;
a299=a299*a479;
a560=a219*a560;
a299=a299+a560;
a782=a782*a299;
a752=a752+a782;
a210=a210*a752;
a034=a034+a210;
a366=a366*a479;
a131=a219*a131;
a366=a366+a131;
a034=a034+a366;
a213=a213*a034;
a473=a761*a473;
a213=a213-a473;
a213=a072*a213;
a211=a211*a213;
a464=a464+a211;
a469=a761*a469;
a212=a212*a034;
a469=a469+a212;
a469=a039*a469;
a464=a464-a469;
a469=2.*a471;
a498=a498*a469;
a686=a686*a471;
a204=a204*a213;
a686=a686+a204;
a229=a229*a686;
a498=a498+a229;
a464=a464+a498;
a404=a404*a464;
a464=a075*a404;
a464=a464-a034;
a465=a761*a465;
a208=a208*a034;
a465=a465+a208;
a465=a039*a465;
a466=a407*a466;
a209=a209*a034;
a761=a761*a468;
a209=a209-a761;
a072=a072*a209;
a207=a207*a072;
a466=a466+a207;
a465=a465-a466;
a466=2.*a459;
a558=a558*a466;
a407=a407*a459;
a206=a206*a072;
a407=a407+a206;
a044=a044*a407;
a558=a558+a044;
a465=a465-a558;
a128=a128*a465;
a075=a075*a128;
a464=a464-a075;
a126=a126*a464;
a198=a198*a126;
a202=a202*a198;
a470=a470+a202;
a234=a234+a470;
a109=a109*a441;
a448=a163*a448;
a109=a109-a448;
a234=a234+a109;
if (res[2]!=0) res[2][1]=a234;
a234=a284*a557;
a109=cos(a505);
a109=a109*a656;
a234=a234*a109;
a109=sin(a505);
a448=a557*a547;
a470=a284*a713;
a448=a448+a470;
a109=a109*a448;
a234=a234+a109;
a109=cos(a505);
a448=a557*a706;
a713=a775*a713;
a448=a448+a713;
a109=a109*a448;
a557=a775*a557;
a448=sin(a505);
a448=a448*a656;
a557=a557*a448;
a109=a109-a557;
a234=a234+a109;
a109=a302*a580;
a557=cos(a505);
a557=a557*a656;
a109=a109*a557;
a557=sin(a505);
a448=a580*a671;
a713=a302*a818;
a448=a448+a713;
a557=a557*a448;
a109=a109+a557;
a234=a234+a109;
a109=cos(a505);
a557=a580*a811;
a818=a647*a818;
a557=a557+a818;
a109=a109*a557;
a580=a647*a580;
a557=sin(a505);
a557=a557*a656;
a580=a580*a557;
a109=a109-a580;
a234=a234-a109;
a109=cos(a505);
a580=a554*a547;
a557=a284*a711;
a580=a580+a557;
a109=a109*a580;
a580=a284*a554;
a557=sin(a505);
a557=a557*a656;
a580=a580*a557;
a109=a109-a580;
a234=a234+a109;
a109=a775*a554;
a580=cos(a505);
a580=a580*a656;
a109=a109*a580;
a580=sin(a505);
a554=a554*a706;
a711=a775*a711;
a554=a554+a711;
a580=a580*a554;
a109=a109+a580;
a234=a234-a109;
a109=cos(a505);
a666=a579*a666;
a580=a121*a703;
a666=a666+a580;
a109=a109*a666;
a121=a121*a579;
a666=sin(a505);
a666=a666*a656;
a121=a121*a666;
a109=a109-a121;
a234=a234+a109;
a109=a392*a579;
a121=cos(a505);
a121=a121*a656;
a109=a109*a121;
a121=sin(a505);
a579=a579*a660;
a703=a392*a703;
a579=a579+a703;
a121=a121*a579;
a109=a109+a121;
a234=a234-a109;
a109=a289*a687;
a121=cos(a505);
a121=a121*a656;
a109=a109*a121;
a121=sin(a505);
a687=a687*a688;
a289=a289*a653;
a687=a687+a289;
a121=a121*a687;
a109=a109+a121;
a234=a234-a109;
a109=a647*a419;
a121=cos(a505);
a121=a121*a656;
a109=a109*a121;
a121=sin(a505);
a687=a419*a811;
a289=a647*a816;
a687=a687+a289;
a121=a121*a687;
a109=a109+a121;
a234=a234+a109;
a109=cos(a505);
a121=a419*a671;
a816=a302*a816;
a121=a121+a816;
a109=a109*a121;
a419=a302*a419;
a121=sin(a505);
a121=a121*a656;
a419=a419*a121;
a109=a109-a419;
a234=a234+a109;
a109=cos(a505);
a789=a568*a789;
a419=a702*a808;
a789=a789+a419;
a109=a109*a789;
a702=a702*a568;
a789=sin(a505);
a789=a789*a656;
a702=a702*a789;
a109=a109-a702;
a234=a234-a109;
a109=a392*a568;
a702=cos(a505);
a702=a702*a656;
a109=a109*a702;
a702=sin(a505);
a568=a568*a660;
a808=a392*a808;
a568=a568+a808;
a702=a702*a568;
a109=a109+a702;
a234=a234-a109;
a109=a365*a800;
a702=cos(a505);
a702=a702*a656;
a109=a109*a702;
a702=sin(a505);
a800=a800*a664;
a365=a365*a781;
a800=a800+a365;
a702=a702*a800;
a109=a109+a702;
a234=a234-a109;
a109=cos(a505);
a660=a662*a660;
a788=a392*a788;
a660=a660+a788;
a109=a109*a660;
a392=a392*a662;
a505=sin(a505);
a505=a505*a656;
a392=a392*a505;
a109=a109-a392;
a234=a234+a109;
if (res[2]!=0) res[2][2]=a234;
a706=a640*a706;
a627=a775*a627;
a706=a706-a627;
a547=a553*a547;
a272=a284*a272;
a547=a547+a272;
a706=a706+a547;
a547=a039*a706;
a272=a090*a547;
a775=a775*a640;
a284=a284*a553;
a775=a775+a284;
a284=a039*a775;
a553=a284*a174;
a272=a272+a553;
a671=a372*a671;
a535=a302*a535;
a671=a671+a535;
a811=a768*a811;
a755=a647*a755;
a811=a811-a755;
a671=a671-a811;
a811=a039*a671;
a755=a090*a811;
a302=a302*a372;
a647=a647*a768;
a302=a302-a647;
a647=a039*a302;
a768=a647*a174;
a755=a755+a768;
a272=a272+a755;
a620=a620*a663;
a277=a277*a691;
a620=a620+a277;
a272=a272+a620;
if (res[2]!=0) res[2][3]=a272;
a481=a481*a488;
a227=a227*a695;
a481=a481+a227;
if (res[2]!=0) res[2][4]=a481;
a331=2.*a331;
a481=a331*a625;
a227=2.*a509;
a481=a481*a227;
a227=2.*a250;
a701=2.*a701;
a625=a625*a701;
a331=a331*a594;
a625=a625+a331;
a227=a227*a625;
a481=a481+a227;
a274=2.*a274;
a227=a274*a395;
a625=2.*a509;
a227=a227*a625;
a625=2.*a250;
a521=2.*a521;
a395=a395*a521;
a274=a274*a341;
a395=a395+a274;
a625=a625*a395;
a227=a227+a625;
a481=a481-a227;
a343=a343+a599;
a343=a343+a727;
a343=a020*a343;
a727=2.*a509;
a343=a343*a727;
a727=2.*a250;
a428=a428+a668;
a428=a428+a783;
a020=a020*a428;
a727=a727*a020;
a343=a343+a727;
a481=a481+a343;
a537=2.*a537;
a343=a537*a753;
a509=2.*a509;
a343=a343*a509;
a250=2.*a250;
a806=2.*a806;
a753=a753*a806;
a537=a537*a722;
a753=a753+a537;
a250=a250*a753;
a343=a343+a250;
a481=a481+a343;
if (res[2]!=0) res[2][5]=a481;
a023=a023/a028;
a481=a023*a122;
a343=a481*a143;
a139=a139/a028;
a028=a023/a028;
a028=a028*a142;
a139=a139-a028;
a122=a122*a139;
a023=a023*a031;
a122=a122+a023;
a023=a026*a122;
a343=a343+a023;
a343=-a343;
if (res[2]!=0) res[2][6]=a343;
a474=a010*a474;
a008=a214*a008;
a474=a474+a008;
a567=a567*a474;
a214=a214*a010;
a764=a214*a764;
a567=a567+a764;
a105=a105*a041;
a086=a086*a091;
a105=a105+a086;
a567=a567-a105;
a624=a624*a476;
a218=a218*a801;
a624=a624+a218;
a567=a567+a624;
a235=a235*a449;
a194=a194*a454;
a235=a235+a194;
a567=a567+a235;
a235=a024*a481;
a026=2.*a026;
a235=a235/a026;
a194=2.*a144;
a194=a235*a194;
a454=2.*a025;
a481=a481*a141;
a024=a024*a122;
a481=a481+a024;
a481=a481/a026;
a235=a235/a026;
a143=2.*a143;
a235=a235*a143;
a481=a481-a235;
a454=a454*a481;
a194=a194+a454;
a567=a567-a194;
if (res[2]!=0) res[2][7]=a567;
a567=a163*a157;
a151=a151*a441;
a567=a567+a151;
a567=-a567;
if (res[2]!=0) res[2][8]=a567;
if (res[2]!=0) res[2][9]=a441;
a163=a163*a444;
a441=a078*a441;
a163=a163+a441;
if (res[2]!=0) res[2][10]=a163;
a019=a019*a445;
a111=a111*a239;
a019=a019+a111;
if (res[2]!=0) res[2][11]=a019;
a311=a073*a311;
a222=a073*a222;
a311=a311+a222;
a108=a108/a181;
a108=a108*a236;
a182=a182/a069;
a182=a182*a442;
a108=a108-a182;
a311=a311+a108;
if (res[2]!=0) res[2][12]=a311;
a240=a240*a440;
a189=a189*a014;
a240=a240+a189;
if (res[2]!=0) res[2][13]=a240;
a077=a077*a452;
a195=a195*a062;
a077=a077+a195;
if (res[2]!=0) res[2][14]=a077;
a388=a388*a679;
a118=a118*a774;
a388=a388+a118;
a544=a544*a388;
a609=a609*a478;
a217=a217*a626;
a609=a609+a217;
a609=a039*a609;
a544=a544+a609;
if (res[2]!=0) res[2][15]=a544;
if (res[2]!=0) res[2][16]=a495;
a544=a500*a157;
a609=a047*a495;
a544=a544+a609;
if (res[2]!=0) res[2][17]=a544;
a500=a500*a444;
a078=a078*a495;
a500=a500+a078;
if (res[2]!=0) res[2][18]=a500;
a809=a809*a479;
a497=a219*a497;
a809=a809+a497;
if (res[2]!=0) res[2][19]=a809;
if (res[2]!=0) res[2][20]=a198;
a318=a318*a157;
a047=a047*a198;
a318=a318+a047;
if (res[2]!=0) res[2][21]=a318;
a404=a073*a404;
a128=a073*a128;
a404=a404+a128;
a042=a042/a201;
a042=a042*a126;
a203=a203/a200;
a203=a203*a464;
a042=a042-a203;
a404=a404+a042;
if (res[2]!=0) res[2][22]=a404;
a404=-a299;
if (res[2]!=0) res[2][23]=a404;
a199=a199*a501;
a290=a290*a299;
a199=a199+a290;
a199=-a199;
if (res[2]!=0) res[2][24]=a199;
a134=a134*a059;
a232=a232*a406;
a134=a134-a232;
if (res[2]!=0) res[2][25]=a134;
a134=a377*a178;
a232=a092*a759;
a134=a134+a232;
if (res[2]!=0) res[2][26]=a134;
a377=a377*a434;
a070=a070*a759;
a377=a377+a070;
a070=a385-a104;
a759=a214*a025;
a329=a759*a329;
a025=a025*a474;
a214=a214*a144;
a025=a025+a214;
a214=a770*a025;
a329=a329+a214;
a214=a817*a479;
a394=a219*a394;
a214=a214+a394;
a329=a329+a214;
a070=a070+a329;
a070=a070-a556;
a070=a070+a661;
a070=a070-a379;
a070=a070/a092;
a329=a224-a780;
a770=a770*a759;
a817=a219*a817;
a770=a770+a817;
a329=a329+a770;
a329=a329-a766;
a329=a329+a638;
a329=a329-a489;
a329=a329/a092;
a770=a329/a092;
a770=a770*a178;
a070=a070-a770;
a070=a070/a092;
a329=a329/a092;
a770=a329/a092;
a770=a770*a178;
a070=a070-a770;
a004=a004*a070;
a329=a329*a011;
a004=a004+a329;
a671=a671-a706;
a137=a314*a137;
a504=a332*a504;
a137=a137+a504;
a293=a381*a293;
a266=a563*a266;
a293=a293-a266;
a137=a137-a293;
a671=a671+a137;
a671=a671+a138;
a671=a671-a716;
a671=a671/a092;
a302=a302-a775;
a332=a332*a314;
a563=a563*a381;
a332=a332-a563;
a302=a302+a332;
a302=a302+a022;
a302=a302-a807;
a302=a302/a092;
a807=a302/a092;
a807=a807*a178;
a671=a671-a807;
a671=a671/a092;
a302=a302/a092;
a092=a302/a092;
a092=a092*a178;
a671=a671-a092;
a315=a315*a671;
a302=a302*a524;
a315=a315+a302;
a004=a004+a315;
a377=a377-a004;
if (res[2]!=0) res[2][27]=a377;
a230=a230*a589;
a491=a238*a491;
a230=a230-a491;
if (res[2]!=0) res[2][28]=a230;
a238=a238*a494;
a233=a233*a589;
a238=a238+a233;
if (res[2]!=0) res[2][29]=a238;
a492=a492*a409;
a018=a018*a529;
a492=a492+a018;
if (res[2]!=0) res[2][30]=a492;
a055=a055*a138;
a022=a022*a242;
a055=a055+a022;
if (res[2]!=0) res[2][31]=a055;
a055=a387+a636;
if (res[2]!=0) res[2][32]=a055;
a387=a390*a387;
a389=a389*a685;
a387=a387-a389;
a636=a390*a636;
a371=a371*a685;
a636=a636-a371;
a387=a387+a636;
if (res[2]!=0) res[2][33]=a387;
a387=a777+a633;
if (res[2]!=0) res[2][34]=a387;
a777=a390*a777;
a644=a644*a685;
a777=a777-a644;
a390=a390*a633;
a772=a772*a685;
a390=a390-a772;
a777=a777+a390;
if (res[2]!=0) res[2][35]=a777;
a256=a256*a804;
a681=a681*a597;
a256=a256+a681;
if (res[2]!=0) res[2][36]=a256;
a518=a611*a518;
a523=a523*a600;
a518=a518+a523;
a294=a294/a429;
a310=a310/a429;
a523=a310/a429;
a523=a523*a672;
a294=a294-a523;
a294=a616*a294;
a310=a310*a614;
a294=a294+a310;
a518=a518-a294;
a613=a613*a674;
a596=a296*a596;
a613=a613+a596;
a518=a518+a613;
a164=a739*a164;
a707=a707*a670;
a164=a164+a707;
a518=a518+a164;
a280=a280/a429;
a649=a649/a429;
a164=a649/a429;
a164=a164*a672;
a280=a280-a164;
a280=a744*a280;
a649=a649*a742;
a280=a280+a649;
a518=a518-a280;
a741=a741*a794;
a724=a628*a724;
a741=a741+a724;
a518=a518+a741;
a393=a393/a370;
a602=a602/a603;
a617=a602*a617;
a605=a605/a606;
a615=a605*a615;
a617=a617-a615;
a730=a730/a731;
a745=a730*a745;
a617=a617+a745;
a733=a733/a734;
a743=a733*a743;
a617=a617-a743;
a743=a393*a617;
a734=a743*a677;
a602=a602*a604;
a605=a605*a699;
a602=a602-a605;
a730=a730*a732;
a602=a602+a730;
a733=a733*a697;
a602=a602-a733;
a602=a393*a602;
a675=a675/a370;
a393=a393/a370;
a393=a393*a676;
a675=a675+a393;
a617=a617*a675;
a602=a602-a617;
a617=a520*a602;
a734=a734+a617;
a518=a518-a734;
if (res[2]!=0) res[2][37]=a518;
a611=a611*a680;
a384=a384*a600;
a611=a611+a384;
a616=a616*a674;
a296=a296*a614;
a616=a616+a296;
a611=a611-a616;
a739=a739*a796;
a328=a328*a670;
a739=a739+a328;
a611=a611+a739;
a744=a744*a794;
a628=a628*a742;
a744=a744+a628;
a611=a611-a744;
a744=a027<=a252;
a252=a252<=a027;
a252=a252+a744;
a744=a744/a252;
a672=a743*a672;
a602=a429*a602;
a672=a672+a602;
a520=2.*a520;
a672=a672/a520;
a429=a429*a743;
a429=a429/a520;
a429=a429/a520;
a677=2.*a677;
a429=a429*a677;
a672=a672-a429;
a744=a744*a672;
a611=a611-a744;
if (res[2]!=0) res[2][38]=a611;
a610=a610*a408;
a514=a514*a607;
a610=a610+a514;
a738=a738*a799;
a646=a646*a735;
a738=a738+a646;
a610=a610+a738;
if (res[2]!=0) res[2][39]=a610;
a608=a608*a669;
a301=a301*a598;
a608=a608+a301;
a736=a736*a791;
a312=a312*a726;
a736=a736+a312;
a608=a608+a736;
if (res[2]!=0) res[2][40]=a608;
a765=a765-a283;
if (res[2]!=0) res[2][41]=a765;
a776=a776*a696;
a297=a297*a555;
a776=a776+a297;
if (res[2]!=0) res[2][42]=a776;
a637=a637-a396;
if (res[2]!=0) res[2][43]=a637;
a188=a188*a029;
a140=a066*a140;
a188=a188+a140;
if (res[2]!=0) res[2][44]=a188;
a317=a317*a309;
a650=a650*a276;
a317=a317+a650;
a506=a506*a398;
a120=a120*a710;
a506=a506+a120;
a317=a317+a506;
a317=-a317;
if (res[2]!=0) res[2][45]=a317;
if (res[2]!=0) res[2][46]=a812;
a076=a076*a433;
a812=a244*a812;
a076=a076+a812;
if (res[2]!=0) res[2][47]=a076;
if (res[2]!=0) res[2][48]=a758;
a391=a391*a433;
a244=a244*a758;
a391=a391+a244;
if (res[2]!=0) res[2][49]=a391;
a288=a288*a513;
a259=a259*a321;
a288=a288+a259;
if (res[2]!=0) res[2][50]=a288;
a261=a356*a261;
a267=a267*a416;
a261=a261+a267;
a421=a421/a119;
a265=a265/a119;
a267=a265/a119;
a267=a267*a418;
a421=a421-a267;
a421=a361*a421;
a265=a265*a359;
a421=a421+a265;
a261=a261-a421;
a358=a358*a423;
a344=a262*a344;
a358=a358+a344;
a261=a261+a358;
a116=a116/a117;
a347=a347/a348;
a362=a347*a362;
a350=a350/a351;
a360=a350*a360;
a362=a362-a360;
a360=a116*a362;
a351=a360*a426;
a347=a347*a349;
a350=a350*a123;
a347=a347-a350;
a347=a116*a347;
a424=a424/a117;
a116=a116/a117;
a116=a116*a425;
a424=a424+a116;
a362=a362*a424;
a347=a347-a362;
a362=a074*a347;
a351=a351+a362;
a261=a261-a351;
if (res[2]!=0) res[2][51]=a261;
a356=a356*a115;
a264=a264*a416;
a356=a356+a264;
a361=a361*a423;
a262=a262*a359;
a361=a361+a262;
a356=a356-a361;
a361=a027<=a045;
a045=a045<=a027;
a045=a045+a361;
a361=a361/a045;
a418=a360*a418;
a347=a119*a347;
a418=a418+a347;
a074=2.*a074;
a418=a418/a074;
a119=a119*a360;
a119=a119/a074;
a119=a119/a074;
a426=2.*a426;
a119=a119*a426;
a418=a418-a119;
a361=a361*a418;
a356=a356-a361;
if (res[2]!=0) res[2][52]=a356;
a355=a355*a427;
a269=a269*a352;
a355=a355+a269;
if (res[2]!=0) res[2][53]=a355;
a353=a353*a415;
a271=a271*a342;
a353=a353+a271;
if (res[2]!=0) res[2][54]=a353;
a378=a378/a260;
a307=a307/a260;
a307=a307/a260;
a307=a307*a512;
a378=a378-a307;
if (res[2]!=0) res[2][55]=a378;
a036=a036*a029;
a066=a066*a709;
a036=a036+a066;
a036=-a036;
if (res[2]!=0) res[2][56]=a036;
a036=a251*a216;
a066=a576*a648;
a036=a036+a066;
if (res[2]!=0) res[2][57]=a036;
a036=a759*a093;
a066=a036*a678;
a093=a093*a025;
a175=a759*a175;
a093=a093+a175;
a175=a507*a093;
a066=a066+a175;
if (res[2]!=0) res[2][58]=a066;
a251=a251*a152;
a648=a065*a648;
a251=a251+a648;
if (res[2]!=0) res[2][59]=a251;
a586=a586*a479;
a219=a219*a750;
a586=a586+a219;
a219=a759*a090;
a750=a285*a219;
a678=2.*a678;
a750=a750*a678;
a507=2.*a507;
a221=a219*a221;
a090=a090*a025;
a174=a759*a174;
a090=a090+a174;
a285=a285*a090;
a221=a221+a285;
a507=a507*a221;
a750=a750+a507;
a586=a586+a750;
a036=a036*a698;
a584=a584*a093;
a036=a036+a584;
a586=a586+a036;
if (res[2]!=0) res[2][60]=a586;
if (res[2]!=0) res[2][61]=a032;
if (res[2]!=0) res[2][62]=a032;
if (res[2]!=0) res[2][63]=a032;
a340=a787*a340;
a545=a545*a795;
a340=a340+a545;
if (res[2]!=0) res[2][64]=a340;
a216=a787*a216;
a576=a576*a795;
a216=a216+a576;
if (res[2]!=0) res[2][65]=a216;
a219=a219*a177;
a540=a540*a090;
a219=a219+a540;
if (res[2]!=0) res[2][66]=a219;
a787=a787*a152;
a795=a065*a795;
a787=a787+a795;
if (res[2]!=0) res[2][67]=a787;
a051=a051*a756;
a485=a485*a160;
a051=a051-a485;
a051=-a051;
if (res[2]!=0) res[2][68]=a051;
a228=a228*a156;
a048=a048*a063;
a228=a228+a048;
if (res[2]!=0) res[2][69]=a228;
a103=a073*a103;
a073=a073*a113;
a103=a103+a073;
a098=a098/a099;
a098=a098*a100;
a101=a101/a102;
a101=a101*a148;
a098=a098-a101;
a103=a103+a098;
if (res[2]!=0) res[2][70]=a103;
a110=a110*a061;
a064=a064*a097;
a110=a110+a064;
if (res[2]!=0) res[2][71]=a110;
a114=a114*a152;
a065=a065*a043;
a114=a114+a065;
a114=-a114;
if (res[2]!=0) res[2][72]=a114;
a107=a107*a149;
a080=a080*a169;
a107=a107+a080;
a039=a039*a107;
a039=-a039;
if (res[2]!=0) res[2][73]=a039;
a106=a106*a147;
a084=a084*a179;
a106=a106+a084;
a106=-a106;
if (res[2]!=0) res[2][74]=a106;
if (res[2]!=0) res[2][75]=a032;
if (res[2]!=0) res[2][76]=a032;
if (res[2]!=0) res[2][77]=a032;
a405=a759*a405;
a025=a704*a025;
a405=a405+a025;
a630=a667*a630;
a690=a751*a690;
a630=a630+a690;
a405=a405+a630;
a104=a049*a104;
a155=a780*a155;
a104=a104+a155;
a385=a052*a385;
a159=a224*a159;
a385=a385+a159;
a104=a104+a385;
a405=a405-a104;
a811=a275*a811;
a104=a647*a665;
a811=a811+a104;
a405=a405+a811;
a547=a275*a547;
a665=a284*a665;
a547=a547+a665;
a405=a405+a547;
a556=a225*a556;
a547=a766*a484;
a556=a556+a547;
a405=a405-a556;
a661=a225*a661;
a484=a638*a484;
a661=a661+a484;
a405=a405+a661;
a379=a319*a379;
a526=a489*a526;
a379=a379+a526;
a405=a405-a379;
a405=a405/a089;
a704=a704*a759;
a751=a751*a667;
a704=a704+a751;
a780=a780*a049;
a224=a224*a052;
a780=a780+a224;
a704=a704-a780;
a647=a647*a275;
a704=a704+a647;
a284=a284*a275;
a704=a704+a284;
a766=a766*a225;
a704=a704-a766;
a638=a638*a225;
a704=a704+a638;
a489=a489*a319;
a704=a704-a489;
a704=a704/a089;
a489=a704/a089;
a489=a489*a176;
a405=a405-a489;
a405=a405/a089;
a704=a704/a089;
a089=a704/a089;
a089=a089*a176;
a405=a405-a089;
a088=a088*a405;
a704=a704*a173;
a088=a088+a704;
a088=-a088;
if (res[2]!=0) res[2][78]=a088;
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
casadi_real a72, a73, a74, a75, a76, a77, a78, a79, a80, a81, a82, a83;
casadi_real a84, a85, a86, a87, a88, a89, a90;
a00=0.;
a01=5.0000000000000000e-01;
a02=arg[2]? arg[2][26] : 0;
a03=arg[2]? arg[2][27] : 0;
a04=a02*a03;
a05=arg[2]? arg[2][12] : 0;
a06=1.0000000000000001e-01;
a07=a05+a06;
a08=-a07;
a09=arg[2]? arg[2][11] : 0;
a10=arg[1]? arg[1][3] : 0;
a11=arg[2]? arg[2][10] : 0;
a11=a10*a11;
a12=arg[2]? arg[2][9] : 0;
a11=a11+a12;
a12=1.;
a13=arg[2]? arg[2][8] : 0;
a13=a12-a13;
a14=arg[2]? arg[2][1] : 0;
a15=9.9999999999999995e-07;
a16=1000000.;
a17=arg[0]? arg[0][0] : 0;
a18=arg[1]? arg[1][0] : 0;
a19=arg[0]? arg[0][5] : 0;
a20=cos(a19);
a20=a18*a20;
a21=arg[1]? arg[1][1] : 0;
a22=sin(a19);
a22=a21*a22;
a20=a20+a22;
a22=a17-a20;
a23=casadi_sq(a22);
a23=a23+a15;
a23=sqrt(a23);
a22=a22*a23;
a23=arg[1]? arg[1][2] : 0;
a24=2.*a23;
a25=arg[2]? arg[2][6] : 0;
a26=arg[2]? arg[2][7] : 0;
a27=casadi_sq(a26);
a28=9.9999999999999998e-13;
a27=a27+a28;
a27=sqrt(a27);
a25=a25*a27;
a24=a24/a25;
a22=a22+a24;
a25=a16*a22;
a25=casadi_fmin(a12,a25);
a25=casadi_fmax(a00,a25);
a27=casadi_sq(a25);
a27=a25*a27;
a27=a15*a27;
a29=3.;
a30=casadi_sq(a25);
a30=a29*a30;
a31=8.;
a25=a31*a25;
a30=a30-a25;
a25=6.;
a30=a30+a25;
a27=a27*a30;
a30=-9.9999999999999995e-07;
a22=a30+a22;
a22=casadi_fmax(a00,a22);
a27=a27+a22;
a27=a27+a15;
a22=sqrt(a27);
a22=atan2(a00,a22);
a22=a14+a22;
a13=a13*a22;
a11=a11+a13;
a09=a09*a11;
a07=casadi_fmin(a07,a09);
a08=casadi_fmax(a08,a07);
a07=2.0000000000000001e-01;
a09=-5.;
a13=a09*a05;
a22=5.;
a32=a22*a08;
a13=a13-a32;
a13=a13+a01;
a13=casadi_fmax(a00,a13);
a32=casadi_sq(a13);
a32=a13*a32;
a32=a07*a32;
a13=a01*a13;
a13=a12-a13;
a32=a32*a13;
a32=a08+a32;
a05=a09*a05;
a08=a22*a08;
a05=a05+a08;
a05=a05+a01;
a05=casadi_fmax(a00,a05);
a08=casadi_sq(a05);
a08=a05*a08;
a08=a07*a08;
a05=a01*a05;
a05=a12-a05;
a08=a08*a05;
a32=a32-a08;
a08=a01*a32;
a05=arg[2]? arg[2][13] : 0;
a08=a08*a05;
a08=a08*a26;
a05=arg[2]? arg[2][14] : 0;
a08=a08*a05;
a08=a08*a27;
a04=a04-a08;
a27=arg[2]? arg[2][22] : 0;
a05=a27+a06;
a13=-a05;
a33=arg[2]? arg[2][20] : 0;
a34=arg[2]? arg[2][21] : 0;
a34=a34*a14;
a33=a33+a34;
a05=casadi_fmin(a05,a33);
a13=casadi_fmax(a13,a05);
a05=a09*a27;
a33=a22*a13;
a05=a05-a33;
a05=a05+a01;
a05=casadi_fmax(a00,a05);
a33=casadi_sq(a05);
a33=a05*a33;
a33=a07*a33;
a05=a01*a05;
a05=a12-a05;
a33=a33*a05;
a33=a13+a33;
a27=a09*a27;
a13=a22*a13;
a27=a27+a13;
a27=a27+a01;
a27=casadi_fmax(a00,a27);
a13=casadi_sq(a27);
a13=a27*a13;
a13=a07*a13;
a27=a01*a27;
a27=a12-a27;
a13=a13*a27;
a33=a33-a13;
a13=arg[2]? arg[2][15] : 0;
a27=a01*a13;
a05=a17-a20;
a34=casadi_sq(a05);
a35=1.0000000000000000e-08;
a34=a34+a35;
a35=arg[0]? arg[0][1] : 0;
a36=cos(a19);
a21=a21*a36;
a36=sin(a19);
a18=a18*a36;
a21=a21-a18;
a18=a35-a21;
a36=casadi_sq(a18);
a36=a34+a36;
a27=a27*a36;
a27=a27*a26;
a37=a33*a27;
a38=a37*a05;
a34=sqrt(a34);
a38=a38/a34;
a04=a04-a38;
a39=arg[2]? arg[2][25] : 0;
a40=cos(a14);
a40=a39*a40;
a41=arg[2]? arg[2][30] : 0;
a42=sin(a14);
a42=a41*a42;
a43=a40+a42;
a43=a04*a43;
a44=arg[2]? arg[2][28] : 0;
a45=cos(a14);
a44=a44*a45;
a45=arg[2]? arg[2][29] : 0;
a46=sin(a14);
a45=a45*a46;
a46=a44+a45;
a46=a08*a46;
a47=arg[2]? arg[2][19] : 0;
a47=a47*a27;
a48=arg[2]? arg[2][16] : 0;
a49=arg[2]? arg[2][17] : 0;
a49=a49*a14;
a48=a48+a49;
a49=arg[2]? arg[2][18] : 0;
a49=a49*a10;
a48=a48+a49;
a47=a47*a48;
a46=a46+a47;
a48=arg[2]? arg[2][31] : 0;
a48=a23*a48;
a49=cos(a14);
a48=a48*a49;
a46=a46+a48;
a43=a43+a46;
a43=a01*a43;
a49=arg[2]? arg[2][0] : 0;
a10=cos(a14);
a10=a49*a10;
a50=a40+a42;
a50=a10-a50;
a51=arg[2]? arg[2][4] : 0;
a52=sin(a14);
a52=a51*a52;
a50=a50+a52;
a43=a43/a50;
a43=-a43;
a43=casadi_fmax(a00,a43);
if (res[0]!=0) res[0][0]=a43;
a53=arg[0]? arg[0][2] : 0;
a54=a10+a52;
a54=a53*a54;
a54=a54+a35;
a55=arg[2]? arg[2][2] : 0;
a56=cos(a55);
a56=a54*a56;
a57=a01*a53;
a58=arg[2]? arg[2][3] : 0;
a57=a57*a58;
a59=a17+a57;
a60=sin(a55);
a59=a59*a60;
a56=a56-a59;
a59=sin(a55);
a59=a54*a59;
a60=a17+a57;
a61=cos(a55);
a60=a60*a61;
a60=a59+a60;
a61=casadi_sq(a60);
a62=arg[2]? arg[2][5] : 0;
a63=casadi_sq(a62);
a63=a15*a63;
a61=a61+a63;
a64=sqrt(a61);
a64=a56/a64;
a65=atan(a64);
if (res[0]!=0) res[0][1]=a65;
a65=arg[1]? arg[1][4] : 0;
a66=arg[2]? arg[2][36] : 0;
a67=1.0000000000000000e-03;
a68=arg[2]? arg[2][34] : 0;
a69=arg[2]? arg[2][35] : 0;
a70=a69*a43;
a70=a68+a70;
a70=casadi_fmax(a67,a70);
a66=a66*a70;
a70=arg[2]? arg[2][41] : 0;
a71=a66-a70;
a71=a65*a71;
a71=a71+a70;
a71=a71/a66;
a70=5.0000000000000004e-06;
a72=a71+a70;
a73=-a72;
a74=casadi_sq(a62);
a74=casadi_sq(a74);
a75=casadi_sq(a60);
a76=casadi_sq(a56);
a75=a75+a76;
a75=casadi_sq(a75);
a74=a74+a75;
a74=sqrt(a74);
a75=sqrt(a74);
a60=a60/a75;
a72=casadi_fmin(a72,a60);
a73=casadi_fmax(a73,a72);
a72=1.0000000000000001e-05;
a60=-100000.;
a76=a60*a71;
a77=100000.;
a78=a77*a73;
a76=a76-a78;
a76=a76+a01;
a76=casadi_fmax(a00,a76);
a78=casadi_sq(a76);
a78=a76*a78;
a78=a72*a78;
a76=a01*a76;
a76=a12-a76;
a78=a78*a76;
a78=a73+a78;
a71=a60*a71;
a73=a77*a73;
a71=a71+a73;
a71=a71+a01;
a71=casadi_fmax(a00,a71);
a73=casadi_sq(a71);
a73=a71*a73;
a73=a72*a73;
a71=a01*a71;
a71=a12-a71;
a73=a73*a71;
a78=a78-a73;
a73=a43*a78;
a73=a73*a66;
if (res[0]!=0) res[0][2]=a73;
a78=casadi_sq(a78);
a78=a12-a78;
a78=sqrt(a78);
a71=a78+a70;
a76=-a71;
a79=2.0000000000000000e-02;
a80=50.;
a81=a80*a65;
a82=arg[2]? arg[2][40] : 0;
a83=arg[2]? arg[2][39] : 0;
a84=arg[2]? arg[2][37] : 0;
a85=arg[2]? arg[2][38] : 0;
a86=a85-a12;
a86=casadi_fmax(a28,a86);
a86=sqrt(a86);
a86=a84*a86;
a86=1./a86;
a87=-a86;
a88=arg[2]? arg[2][32] : 0;
a89=arg[2]? arg[2][33] : 0;
a90=a89*a43;
a90=a88+a90;
a90=casadi_fmax(a00,a90);
a90=a90*a64;
a90=a90/a66;
a90=casadi_fmin(a90,a86);
a87=casadi_fmax(a87,a90);
a90=a12-a85;
a90=a87*a90;
a87=a84*a87;
a87=atan(a87);
a87=a85*a87;
a87=a87/a84;
a90=a90+a87;
a90=a84*a90;
a90=atan(a90);
a90=a83*a90;
a90=sin(a90);
a90=a82*a90;
a87=casadi_sq(a56);
a87=a87+a61;
a87=sqrt(a87);
a90=a90*a87;
a87=a56*a90;
a87=a87/a74;
a87=a87+a28;
a61=casadi_sq(a56);
a61=a61/a74;
a74=4.9999999999999999e-13;
a61=a61+a74;
a87=a87/a61;
a61=a80*a87;
a81=a81-a61;
a81=casadi_fmin(a12,a81);
a81=casadi_fmax(a00,a81);
a61=casadi_sq(a81);
a61=a81*a61;
a61=a79*a61;
a64=casadi_sq(a81);
a64=a29*a64;
a81=a31*a81;
a64=a64-a81;
a64=a64+a25;
a61=a61*a64;
a65=a65-a87;
a65=a65-a79;
a65=casadi_fmax(a00,a65);
a61=a61+a65;
a56=a56*a61;
a56=a56/a75;
a90=a90/a75;
a56=a56+a90;
a56=casadi_fmin(a56,a71);
a76=casadi_fmax(a76,a56);
a56=a60*a78;
a71=a77*a76;
a56=a56-a71;
a56=a56+a01;
a56=casadi_fmax(a00,a56);
a71=casadi_sq(a56);
a71=a56*a71;
a71=a72*a71;
a56=a01*a56;
a56=a12-a56;
a71=a71*a56;
a71=a76+a71;
a78=a60*a78;
a76=a77*a76;
a78=a78+a76;
a78=a78+a01;
a78=casadi_fmax(a00,a78);
a76=casadi_sq(a78);
a76=a78*a76;
a76=a72*a76;
a78=a01*a78;
a78=a12-a78;
a76=a76*a78;
a71=a71-a76;
a71=a43*a71;
a71=a71*a66;
if (res[0]!=0) res[0][3]=a71;
if (res[0]!=0) res[0][4]=a43;
a66=cos(a55);
a54=a54*a66;
a66=a17-a57;
a76=sin(a55);
a66=a66*a76;
a54=a54+a66;
a57=a17-a57;
a66=cos(a55);
a57=a57*a66;
a57=a57-a59;
a59=casadi_sq(a57);
a59=a59+a63;
a66=sqrt(a59);
a66=a54/a66;
a76=atan(a66);
if (res[0]!=0) res[0][5]=a76;
a76=arg[1]? arg[1][5] : 0;
a78=arg[2]? arg[2][42] : 0;
a69=a69*a43;
a68=a68+a69;
a68=casadi_fmax(a67,a68);
a78=a78*a68;
a68=arg[2]? arg[2][43] : 0;
a69=a78-a68;
a69=a76*a69;
a69=a69+a68;
a69=a69/a78;
a68=a69+a70;
a56=-a68;
a90=casadi_sq(a62);
a90=casadi_sq(a90);
a75=casadi_sq(a57);
a61=casadi_sq(a54);
a75=a75+a61;
a75=casadi_sq(a75);
a90=a90+a75;
a90=sqrt(a90);
a75=sqrt(a90);
a57=a57/a75;
a68=casadi_fmin(a68,a57);
a56=casadi_fmax(a56,a68);
a68=a60*a69;
a57=a77*a56;
a68=a68-a57;
a68=a68+a01;
a68=casadi_fmax(a00,a68);
a57=casadi_sq(a68);
a57=a68*a57;
a57=a72*a57;
a68=a01*a68;
a68=a12-a68;
a57=a57*a68;
a57=a56+a57;
a69=a60*a69;
a56=a77*a56;
a69=a69+a56;
a69=a69+a01;
a69=casadi_fmax(a00,a69);
a56=casadi_sq(a69);
a56=a69*a56;
a56=a72*a56;
a69=a01*a69;
a69=a12-a69;
a56=a56*a69;
a57=a57-a56;
a56=a43*a57;
a56=a56*a78;
if (res[0]!=0) res[0][6]=a56;
a57=casadi_sq(a57);
a57=a12-a57;
a57=sqrt(a57);
a69=a57+a70;
a68=-a69;
a61=a80*a76;
a65=-a86;
a89=a89*a43;
a88=a88+a89;
a88=casadi_fmax(a00,a88);
a88=a88*a66;
a88=a88/a78;
a88=casadi_fmin(a88,a86);
a65=casadi_fmax(a65,a88);
a88=a12-a85;
a88=a65*a88;
a65=a84*a65;
a65=atan(a65);
a85=a85*a65;
a85=a85/a84;
a88=a88+a85;
a84=a84*a88;
a84=atan(a84);
a83=a83*a84;
a83=sin(a83);
a82=a82*a83;
a83=casadi_sq(a54);
a83=a83+a59;
a83=sqrt(a83);
a82=a82*a83;
a83=a54*a82;
a83=a83/a90;
a83=a83+a28;
a59=casadi_sq(a54);
a59=a59/a90;
a59=a59+a74;
a83=a83/a59;
a80=a80*a83;
a61=a61-a80;
a61=casadi_fmin(a12,a61);
a61=casadi_fmax(a00,a61);
a80=casadi_sq(a61);
a80=a61*a80;
a80=a79*a80;
a59=casadi_sq(a61);
a59=a29*a59;
a61=a31*a61;
a59=a59-a61;
a59=a59+a25;
a80=a80*a59;
a76=a76-a83;
a76=a76-a79;
a76=casadi_fmax(a00,a76);
a80=a80+a76;
a54=a54*a80;
a54=a54/a75;
a82=a82/a75;
a54=a54+a82;
a54=casadi_fmin(a54,a69);
a68=casadi_fmax(a68,a54);
a54=a60*a57;
a69=a77*a68;
a54=a54-a69;
a54=a54+a01;
a54=casadi_fmax(a00,a54);
a69=casadi_sq(a54);
a69=a54*a69;
a69=a72*a69;
a54=a01*a54;
a54=a12-a54;
a69=a69*a54;
a69=a68+a69;
a57=a60*a57;
a68=a77*a68;
a57=a57+a68;
a57=a57+a01;
a57=casadi_fmax(a00,a57);
a68=casadi_sq(a57);
a68=a57*a68;
a68=a72*a68;
a57=a01*a57;
a57=a12-a57;
a68=a68*a57;
a69=a69-a68;
a43=a43*a69;
a43=a43*a78;
if (res[0]!=0) res[0][7]=a43;
a78=a10+a52;
a04=a04*a78;
a04=a04+a46;
a04=a04/a50;
a04=casadi_fmax(a00,a04);
if (res[0]!=0) res[0][8]=a04;
a50=a40+a42;
a50=a53*a50;
a50=a50+a35;
a46=arg[1]? arg[1][6] : 0;
a78=arg[2]? arg[2][44] : 0;
a78=a46*a78;
a69=arg[1]? arg[1][7] : 0;
a78=a78+a69;
a69=arg[2]? arg[2][45] : 0;
a68=a12-a69;
a78=a78*a68;
a68=cos(a78);
a68=a50*a68;
a57=sin(a78);
a57=a17*a57;
a68=a68-a57;
a57=cos(a78);
a57=a17*a57;
a54=sin(a78);
a50=a50*a54;
a57=a57+a50;
a50=casadi_sq(a57);
a50=a50+a63;
a63=sqrt(a50);
a63=a68/a63;
a54=atan(a63);
if (res[0]!=0) res[0][9]=a54;
a54=arg[2]? arg[2][55] : 0;
a82=arg[2]? arg[2][50] : 0;
a75=arg[2]? arg[2][48] : 0;
a80=arg[2]? arg[2][49] : 0;
a80=a80*a04;
a75=a75+a80;
a67=casadi_fmax(a67,a75);
a82=a82*a67;
a54=a54/a82;
a67=a54+a70;
a75=-a67;
a62=casadi_sq(a62);
a62=casadi_sq(a62);
a80=casadi_sq(a57);
a76=casadi_sq(a68);
a80=a80+a76;
a80=casadi_sq(a80);
a62=a62+a80;
a62=sqrt(a62);
a62=sqrt(a62);
a57=a57/a62;
a67=casadi_fmin(a67,a57);
a75=casadi_fmax(a75,a67);
a67=a60*a54;
a57=a77*a75;
a67=a67-a57;
a67=a67+a01;
a67=casadi_fmax(a00,a67);
a57=casadi_sq(a67);
a57=a67*a57;
a57=a72*a57;
a67=a01*a67;
a67=a12-a67;
a57=a57*a67;
a57=a75+a57;
a54=a60*a54;
a75=a77*a75;
a54=a54+a75;
a54=a54+a01;
a54=casadi_fmax(a00,a54);
a75=casadi_sq(a54);
a75=a54*a75;
a75=a72*a75;
a54=a01*a54;
a54=a12-a54;
a75=a75*a54;
a57=a57-a75;
a75=a04*a57;
a75=a75*a82;
if (res[0]!=0) res[0][10]=a75;
a57=casadi_sq(a57);
a57=a12-a57;
a57=sqrt(a57);
a70=a57+a70;
a54=-a70;
a67=arg[2]? arg[2][54] : 0;
a80=arg[2]? arg[2][53] : 0;
a76=arg[2]? arg[2][51] : 0;
a79=arg[2]? arg[2][52] : 0;
a83=a79-a12;
a83=casadi_fmax(a28,a83);
a83=sqrt(a83);
a83=a76*a83;
a83=1./a83;
a59=-a83;
a61=arg[2]? arg[2][46] : 0;
a74=arg[2]? arg[2][47] : 0;
a74=a74*a04;
a61=a61+a74;
a61=casadi_fmax(a00,a61);
a61=a61*a63;
a61=a61/a82;
a61=casadi_fmin(a61,a83);
a59=casadi_fmax(a59,a61);
a61=a76*a59;
a61=atan(a61);
a61=a79*a61;
a61=a61/a76;
a79=a79-a12;
a59=a59*a79;
a61=a61-a59;
a76=a76*a61;
a76=atan(a76);
a80=a80*a76;
a80=sin(a80);
a67=a67*a80;
a68=casadi_sq(a68);
a68=a68+a50;
a68=sqrt(a68);
a67=a67*a68;
a67=a67/a62;
a67=casadi_fmin(a67,a70);
a54=casadi_fmax(a54,a67);
a67=a60*a57;
a70=a77*a54;
a67=a67-a70;
a67=a67+a01;
a67=casadi_fmax(a00,a67);
a70=casadi_sq(a67);
a70=a67*a70;
a70=a72*a70;
a67=a01*a67;
a67=a12-a67;
a70=a70*a67;
a70=a54+a70;
a60=a60*a57;
a77=a77*a54;
a60=a60+a77;
a60=a60+a01;
a60=casadi_fmax(a00,a60);
a77=casadi_sq(a60);
a77=a60*a77;
a72=a72*a77;
a60=a01*a60;
a60=a12-a60;
a72=a72*a60;
a70=a70-a72;
a04=a04*a70;
a04=a04*a82;
a69=a12-a69;
a04=a04*a69;
if (res[0]!=0) res[0][11]=a04;
if (res[0]!=0) res[0][12]=a14;
a18=atan2(a18,a34);
if (res[0]!=0) res[0][13]=a18;
if (res[0]!=0) res[0][14]=a33;
if (res[0]!=0) res[0][15]=a37;
a37=arg[2]? arg[2][23] : 0;
a33=casadi_sq(a33);
a69=arg[2]? arg[2][24] : 0;
a33=a33*a69;
a37=a37+a33;
a37=a37*a27;
if (res[0]!=0) res[0][16]=a37;
a33=arg[2]? arg[2][58] : 0;
a69=arg[2]? arg[2][60] : 0;
a33=a33*a69;
a82=2.5000000000000000e-01;
a82=a82*a13;
a36=sqrt(a36);
a82=a82*a36;
a82=a82*a53;
a82=a82*a26;
a33=a33*a82;
a36=arg[2]? arg[2][57] : 0;
a36=a36*a18;
a13=arg[2]? arg[2][59] : 0;
a70=arg[1]? arg[1][8] : 0;
a72=arg[2]? arg[2][56] : 0;
a46=a46*a72;
a70=a70-a46;
a13=a13*a70;
a36=a36+a13;
a36=a27*a36;
a33=a33+a36;
if (res[0]!=0) res[0][17]=a33;
a36=arg[2]? arg[2][63] : 0;
a13=casadi_sq(a69);
a13=a13*a82;
a36=a36*a13;
a82=a69*a27;
a46=arg[2]? arg[2][61] : 0;
a72=arg[1]? arg[1][9] : 0;
a46=a46*a72;
a60=arg[2]? arg[2][62] : 0;
a60=a60*a18;
a46=a46+a60;
a82=a82*a46;
a36=a36+a82;
if (res[0]!=0) res[0][18]=a36;
if (res[0]!=0) res[0][19]=a47;
a82=arg[2]? arg[2][66] : 0;
a82=a82*a13;
a69=a69*a27;
a27=arg[2]? arg[2][64] : 0;
a27=a27*a72;
a72=arg[2]? arg[2][65] : 0;
a72=a72*a18;
a27=a27+a72;
a72=arg[2]? arg[2][67] : 0;
a72=a72*a70;
a27=a27+a72;
a69=a69*a27;
a82=a82+a69;
if (res[0]!=0) res[0][20]=a82;
a69=arg[2]? arg[2][69] : 0;
a27=sin(a14);
a27=a69*a27;
a72=arg[2]? arg[2][68] : 0;
a18=cos(a14);
a18=a72*a18;
a27=a27-a18;
a53=a53*a27;
a53=a53+a35;
a53=a53-a21;
a20=a17-a20;
a21=casadi_sq(a20);
a21=a21+a15;
a21=sqrt(a21);
a20=a20*a21;
a20=a20+a24;
a16=a16*a20;
a16=casadi_fmin(a12,a16);
a16=casadi_fmax(a00,a16);
a24=casadi_sq(a16);
a24=a16*a24;
a24=a15*a24;
a21=casadi_sq(a16);
a29=a29*a21;
a31=a31*a16;
a29=a29-a31;
a29=a29+a25;
a24=a24*a29;
a20=a20+a30;
a20=casadi_fmax(a00,a20);
a24=a24+a20;
a24=a24+a15;
a15=sqrt(a24);
a15=atan2(a53,a15);
if (res[0]!=0) res[0][21]=a15;
a20=arg[2]? arg[2][70] : 0;
a06=a20+a06;
a30=-a06;
a29=arg[2]? arg[2][71] : 0;
a25=arg[2]? arg[2][72] : 0;
a70=a70*a25;
a15=a15-a70;
a29=a29*a15;
a06=casadi_fmin(a06,a29);
a30=casadi_fmax(a30,a06);
a06=a09*a20;
a29=a22*a30;
a06=a06-a29;
a06=a06+a01;
a06=casadi_fmax(a00,a06);
a29=casadi_sq(a06);
a29=a06*a29;
a29=a07*a29;
a06=a01*a06;
a06=a12-a06;
a29=a29*a06;
a29=a30+a29;
a09=a09*a20;
a22=a22*a30;
a09=a09+a22;
a09=a09+a01;
a00=casadi_fmax(a00,a09);
a09=casadi_sq(a00);
a09=a00*a09;
a07=a07*a09;
a00=a01*a00;
a12=a12-a00;
a07=a07*a12;
a29=a29-a07;
if (res[0]!=0) res[0][22]=a29;
a07=arg[2]? arg[2][73] : 0;
a07=a01*a07;
a07=a07*a29;
a29=arg[2]? arg[2][74] : 0;
a07=a07*a29;
a07=a07*a26;
a53=casadi_sq(a53);
a24=a24+a53;
a07=a07*a24;
if (res[0]!=0) res[0][23]=a07;
if (res[0]!=0) res[0][24]=a11;
if (res[0]!=0) res[0][25]=a32;
if (res[0]!=0) res[0][26]=a08;
a32=sin(a19);
a32=a17*a32;
a11=cos(a19);
a11=a35*a11;
a32=a32+a11;
a32=casadi_sq(a32);
a11=cos(a19);
a17=a17*a11;
a11=sin(a19);
a35=a35*a11;
a17=a17-a35;
a17=casadi_sq(a17);
a32=a32+a17;
a32=a32+a28;
a32=sqrt(a32);
if (res[0]!=0) res[0][27]=a32;
a28=sin(a55);
a28=a71*a28;
a17=cos(a55);
a17=a73*a17;
a28=a28-a17;
a17=cos(a55);
a17=a56*a17;
a35=sin(a55);
a35=a43*a35;
a17=a17+a35;
a35=a28-a17;
a11=sin(a78);
a11=a04*a11;
a24=cos(a78);
a24=a75*a24;
a11=a11-a24;
a35=a35+a11;
a35=a35+a23;
a37=a37*a05;
a37=a37/a34;
a35=a35-a37;
if (res[0]!=0) res[0][28]=a35;
a37=arg[1]? arg[1][10] : 0;
a34=a37-a07;
a34=a34+a33;
a33=sin(a55);
a73=a73*a33;
a33=cos(a55);
a71=a71*a33;
a73=a73+a71;
a34=a34-a73;
a71=sin(a55);
a56=a56*a71;
a55=cos(a55);
a43=a43*a55;
a56=a56-a43;
a34=a34+a56;
a43=sin(a78);
a75=a75*a43;
a78=cos(a78);
a04=a04*a78;
a75=a75+a04;
a34=a34-a75;
if (res[0]!=0) res[0][29]=a34;
a27=a07*a27;
a18=a37*a18;
a27=a27+a18;
a82=a82-a27;
a27=a01*a28;
a27=a27*a58;
a82=a82+a27;
a01=a01*a17;
a01=a01*a58;
a82=a82+a01;
a01=a10+a52;
a01=a73*a01;
a82=a82-a01;
a10=a10+a52;
a10=a56*a10;
a82=a82+a10;
a40=a40+a42;
a40=a75*a40;
a82=a82-a40;
if (res[0]!=0) res[0][30]=a82;
a35=a35/a03;
if (res[0]!=0) res[0][31]=a35;
a34=a34/a03;
if (res[0]!=0) res[0][32]=a34;
a02=a02*a03;
a02=a02-a08;
a02=a02-a38;
if (res[0]!=0) res[0][33]=a02;
a37=a37*a72;
a02=sin(a14);
a37=a37*a02;
a72=a07*a72;
a02=sin(a14);
a72=a72*a02;
a07=a07*a69;
a69=cos(a14);
a07=a07*a69;
a72=a72+a07;
a37=a37-a72;
a37=a37-a36;
a36=a73*a51;
a72=cos(a14);
a36=a36*a72;
a37=a37-a36;
a36=sin(a14);
a49=a49*a36;
a73=a73*a49;
a37=a37+a73;
a73=a56*a51;
a36=cos(a14);
a73=a73*a36;
a37=a37+a73;
a56=a56*a49;
a37=a37-a56;
a56=a75*a41;
a73=cos(a14);
a56=a56*a73;
a37=a37-a56;
a56=sin(a14);
a39=a39*a56;
a75=a75*a39;
a37=a37+a75;
if (res[0]!=0) res[0][34]=a37;
a37=a28*a49;
a44=a08*a44;
a08=a08*a45;
a44=a44+a08;
a44=a44+a47;
a37=a37-a44;
a44=cos(a14);
a51=a51*a44;
a28=a28*a51;
a37=a37-a28;
a49=a17*a49;
a37=a37-a49;
a17=a17*a51;
a37=a37+a17;
a41=a11*a41;
a14=cos(a14);
a41=a41*a14;
a37=a37-a41;
a11=a11*a39;
a37=a37+a11;
a37=a37-a48;
if (res[0]!=0) res[0][35]=a37;
a37=arg[2]? arg[2][75] : 0;
a32=a32-a37;
if (res[0]!=0) res[0][36]=a32;
a32=-5.0000000000000000e-01;
a37=arg[2]? arg[2][76] : 0;
a32=a32*a37;
a37=arg[0]? arg[0][4] : 0;
a37=casadi_fabs(a37);
a32=a32+a37;
if (res[0]!=0) res[0][37]=a32;
a19=casadi_fabs(a19);
a32=arg[2]? arg[2][77] : 0;
a19=a19-a32;
if (res[0]!=0) res[0][38]=a19;
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
casadi_real a156, a157, a158, a159, a160, a161, a162, a163, a164, a165, a166, a167;
casadi_real a168, a169, a170, a171, a172, a173, a174, a175, a176, a177, a178, a179;
casadi_real a180, a181, a182, a183, a184, a185, a186, a187, a188, a189, a190;
a000=0.;
a001=5.0000000000000000e-01;
a002=arg[2]? arg[2][26] : 0;
a003=arg[2]? arg[2][27] : 0;
a004=a002*a003;
a005=arg[2]? arg[2][12] : 0;
a006=1.0000000000000001e-01;
a007=a005+a006;
a008=-a007;
a009=arg[2]? arg[2][11] : 0;
a010=arg[1]? arg[1][3] : 0;
a011=arg[2]? arg[2][10] : 0;
a012=a010*a011;
a013=arg[2]? arg[2][9] : 0;
a012=a012+a013;
a013=1.;
a014=arg[2]? arg[2][8] : 0;
a014=a013-a014;
a015=arg[2]? arg[2][1] : 0;
a016=9.9999999999999995e-07;
a017=1000000.;
a018=arg[0]? arg[0][0] : 0;
a019=arg[1]? arg[1][0] : 0;
a020=arg[0]? arg[0][5] : 0;
a021=cos(a020);
a022=a019*a021;
a023=arg[1]? arg[1][1] : 0;
a024=sin(a020);
a025=a023*a024;
a022=a022+a025;
a025=a018-a022;
a026=casadi_sq(a025);
a026=a026+a016;
a026=sqrt(a026);
a027=a025*a026;
a028=arg[1]? arg[1][2] : 0;
a029=2.*a028;
a030=arg[2]? arg[2][6] : 0;
a031=arg[2]? arg[2][7] : 0;
a032=casadi_sq(a031);
a033=9.9999999999999998e-13;
a032=a032+a033;
a032=sqrt(a032);
a034=a030*a032;
a029=a029/a034;
a027=a027+a029;
a035=a017*a027;
a036=casadi_fmin(a013,a035);
a037=casadi_fmax(a000,a036);
a038=casadi_sq(a037);
a039=a037*a038;
a039=a016*a039;
a040=3.;
a041=casadi_sq(a037);
a041=a040*a041;
a042=8.;
a043=a042*a037;
a041=a041-a043;
a043=6.;
a041=a041+a043;
a044=a039*a041;
a045=-9.9999999999999995e-07;
a027=a045+a027;
a046=casadi_fmax(a000,a027);
a044=a044+a046;
a044=a044+a016;
a046=sqrt(a044);
a046=atan2(a000,a046);
a046=a015+a046;
a047=a014*a046;
a012=a012+a047;
a047=a009*a012;
a048=casadi_fmin(a007,a047);
a049=casadi_fmax(a008,a048);
a050=2.0000000000000001e-01;
a051=-5.;
a052=a051*a005;
a053=5.;
a054=a053*a049;
a052=a052-a054;
a052=a052+a001;
a054=casadi_fmax(a000,a052);
a055=casadi_sq(a054);
a056=a054*a055;
a056=a050*a056;
a057=a001*a054;
a057=a013-a057;
a058=a056*a057;
a058=a049+a058;
a005=a051*a005;
a049=a053*a049;
a005=a005+a049;
a005=a005+a001;
a049=casadi_fmax(a000,a005);
a059=casadi_sq(a049);
a060=a049*a059;
a060=a050*a060;
a061=a001*a049;
a061=a013-a061;
a062=a060*a061;
a058=a058-a062;
a058=a001*a058;
a062=arg[2]? arg[2][13] : 0;
a063=a058*a062;
a064=a063*a031;
a065=arg[2]? arg[2][14] : 0;
a066=a064*a065;
a067=a066*a044;
a004=a004-a067;
a068=arg[2]? arg[2][22] : 0;
a069=a068+a006;
a070=-a069;
a071=arg[2]? arg[2][20] : 0;
a072=arg[2]? arg[2][21] : 0;
a073=a072*a015;
a071=a071+a073;
a073=casadi_fmin(a069,a071);
a074=casadi_fmax(a070,a073);
a075=a051*a068;
a076=a053*a074;
a075=a075-a076;
a075=a075+a001;
a076=casadi_fmax(a000,a075);
a077=casadi_sq(a076);
a078=a076*a077;
a078=a050*a078;
a079=a001*a076;
a079=a013-a079;
a080=a078*a079;
a080=a074+a080;
a068=a051*a068;
a074=a053*a074;
a068=a068+a074;
a068=a068+a001;
a074=casadi_fmax(a000,a068);
a081=casadi_sq(a074);
a082=a074*a081;
a082=a050*a082;
a083=a001*a074;
a083=a013-a083;
a084=a082*a083;
a080=a080-a084;
a084=arg[2]? arg[2][15] : 0;
a085=a001*a084;
a086=a018-a022;
a087=casadi_sq(a086);
a088=1.0000000000000000e-08;
a087=a087+a088;
a088=arg[0]? arg[0][1] : 0;
a089=cos(a020);
a090=a023*a089;
a091=sin(a020);
a092=a019*a091;
a090=a090-a092;
a092=a088-a090;
a093=casadi_sq(a092);
a093=a087+a093;
a094=a085*a093;
a095=a094*a031;
a096=a080*a095;
a097=a096*a086;
a098=sqrt(a087);
a097=a097/a098;
a004=a004-a097;
a099=arg[2]? arg[2][25] : 0;
a100=cos(a015);
a101=a099*a100;
a102=arg[2]? arg[2][30] : 0;
a103=sin(a015);
a104=a102*a103;
a105=a101+a104;
a106=a004*a105;
a107=arg[2]? arg[2][28] : 0;
a108=cos(a015);
a109=a107*a108;
a110=arg[2]? arg[2][29] : 0;
a111=sin(a015);
a112=a110*a111;
a113=a109+a112;
a114=a067*a113;
a115=arg[2]? arg[2][19] : 0;
a116=a115*a095;
a117=arg[2]? arg[2][16] : 0;
a118=arg[2]? arg[2][17] : 0;
a119=a118*a015;
a117=a117+a119;
a119=arg[2]? arg[2][18] : 0;
a120=a119*a010;
a117=a117+a120;
a120=a116*a117;
a114=a114+a120;
a120=arg[2]? arg[2][31] : 0;
a121=a028*a120;
a122=cos(a015);
a123=a121*a122;
a114=a114+a123;
a106=a106+a114;
a106=a001*a106;
a123=arg[2]? arg[2][0] : 0;
a124=cos(a015);
a125=a123*a124;
a126=a101+a104;
a126=a125-a126;
a127=arg[2]? arg[2][4] : 0;
a128=sin(a015);
a129=a127*a128;
a126=a126+a129;
a106=a106/a126;
a130=-a106;
a131=a000<=a130;
a132=a130<=a000;
a132=a132+a131;
a131=a131/a132;
a132=arg[6]? arg[6][26] : 0;
a133=a003*a132;
a134=arg[6]? arg[6][27] : 0;
a135=a002*a134;
a133=a133+a135;
a135=a008<=a048;
a048=a048<=a008;
a008=a048+a135;
a135=a135/a008;
a136=a007<=a047;
a047=a047<=a007;
a007=a136+a047;
a136=a136/a007;
a137=arg[6]? arg[6][12] : 0;
a136=a136*a137;
a047=a047/a007;
a007=arg[6]? arg[6][11] : 0;
a012=a012*a007;
a007=arg[5]? arg[5][3] : 0;
a011=a011*a007;
a138=arg[6]? arg[6][10] : 0;
a138=a010*a138;
a011=a011+a138;
a138=arg[6]? arg[6][9] : 0;
a011=a011+a138;
a138=arg[6]? arg[6][1] : 0;
a014=a014*a138;
a139=arg[6]? arg[6][8] : 0;
a046=a046*a139;
a014=a014-a046;
a011=a011+a014;
a009=a009*a011;
a012=a012+a009;
a047=a047*a012;
a136=a136+a047;
a135=a135*a136;
a048=a048/a008;
a048=a048*a137;
a135=a135-a048;
a048=a000<=a052;
a052=a052<=a000;
a052=a052+a048;
a048=a048/a052;
a052=a051*a137;
a008=a053*a135;
a052=a052-a008;
a048=a048*a052;
a055=a055*a048;
a052=2.*a054;
a052=a052*a048;
a054=a054*a052;
a055=a055+a054;
a055=a050*a055;
a057=a057*a055;
a048=a001*a048;
a056=a056*a048;
a057=a057-a056;
a057=a135+a057;
a056=a000<=a005;
a005=a005<=a000;
a005=a005+a056;
a056=a056/a005;
a137=a051*a137;
a135=a053*a135;
a137=a137+a135;
a056=a056*a137;
a059=a059*a056;
a137=2.*a049;
a137=a137*a056;
a049=a049*a137;
a059=a059+a049;
a059=a050*a059;
a061=a061*a059;
a056=a001*a056;
a060=a060*a056;
a061=a061-a060;
a057=a057-a061;
a061=a001*a057;
a062=a062*a061;
a061=arg[6]? arg[6][13] : 0;
a058=a058*a061;
a062=a062+a058;
a062=a031*a062;
a058=arg[6]? arg[6][7] : 0;
a063=a063*a058;
a062=a062+a063;
a065=a065*a062;
a062=arg[6]? arg[6][14] : 0;
a064=a064*a062;
a065=a065+a064;
a044=a044*a065;
a065=a000<=a036;
a036=a036<=a000;
a036=a036+a065;
a065=a065/a036;
a036=a035<=a013;
a035=a013<=a035;
a035=a035+a036;
a036=a036/a035;
a035=arg[4]? arg[4][0] : 0;
a064=arg[5]? arg[5][0] : 0;
a021=a021*a064;
a062=sin(a020);
a063=arg[4]? arg[4][5] : 0;
a062=a062*a063;
a062=a019*a062;
a021=a021-a062;
a062=arg[5]? arg[5][1] : 0;
a024=a024*a062;
a061=cos(a020);
a061=a061*a063;
a061=a023*a061;
a024=a024+a061;
a021=a021+a024;
a024=a035-a021;
a061=a026*a024;
a060=2.*a025;
a060=a060*a024;
a026=2.*a026;
a060=a060/a026;
a025=a025*a060;
a061=a061+a025;
a025=arg[5]? arg[5][2] : 0;
a060=2.*a025;
a060=a060/a034;
a034=a029/a034;
a026=arg[6]? arg[6][6] : 0;
a026=a032*a026;
a024=2.*a031;
a024=a024*a058;
a032=2.*a032;
a024=a024/a032;
a030=a030*a024;
a026=a026+a030;
a034=a034*a026;
a060=a060-a034;
a061=a061+a060;
a034=a017*a061;
a036=a036*a034;
a065=a065*a036;
a038=a038*a065;
a036=2.*a037;
a036=a036*a065;
a036=a037*a036;
a038=a038+a036;
a038=a016*a038;
a041=a041*a038;
a037=2.*a037;
a037=a037*a065;
a037=a040*a037;
a065=a042*a065;
a037=a037-a065;
a039=a039*a037;
a041=a041+a039;
a039=a000<=a027;
a027=a027<=a000;
a027=a027+a039;
a039=a039/a027;
a039=a039*a061;
a041=a041+a039;
a066=a066*a041;
a044=a044+a066;
a133=a133-a044;
a066=a070<=a073;
a073=a073<=a070;
a070=a073+a066;
a066=a066/a070;
a041=a069<=a071;
a071=a071<=a069;
a069=a041+a071;
a041=a041/a069;
a039=arg[6]? arg[6][22] : 0;
a041=a041*a039;
a071=a071/a069;
a069=arg[6]? arg[6][20] : 0;
a061=arg[6]? arg[6][21] : 0;
a061=a015*a061;
a072=a072*a138;
a061=a061+a072;
a069=a069+a061;
a071=a071*a069;
a041=a041+a071;
a066=a066*a041;
a073=a073/a070;
a073=a073*a039;
a066=a066-a073;
a073=a000<=a075;
a075=a075<=a000;
a075=a075+a073;
a073=a073/a075;
a075=a051*a039;
a070=a053*a066;
a075=a075-a070;
a073=a073*a075;
a077=a077*a073;
a075=2.*a076;
a075=a075*a073;
a076=a076*a075;
a077=a077+a076;
a077=a050*a077;
a079=a079*a077;
a073=a001*a073;
a078=a078*a073;
a079=a079-a078;
a079=a066+a079;
a078=a000<=a068;
a068=a068<=a000;
a068=a068+a078;
a078=a078/a068;
a039=a051*a039;
a066=a053*a066;
a039=a039+a066;
a078=a078*a039;
a081=a081*a078;
a039=2.*a074;
a039=a039*a078;
a074=a074*a039;
a081=a081+a074;
a081=a050*a081;
a083=a083*a081;
a078=a001*a078;
a082=a082*a078;
a083=a083-a082;
a079=a079-a083;
a083=a095*a079;
a082=arg[6]? arg[6][15] : 0;
a078=a001*a082;
a078=a093*a078;
a081=2.*a086;
a074=a035-a021;
a081=a081*a074;
a039=2.*a092;
a066=arg[4]? arg[4][1] : 0;
a089=a089*a062;
a062=sin(a020);
a062=a062*a063;
a023=a023*a062;
a089=a089-a023;
a091=a091*a064;
a064=cos(a020);
a064=a064*a063;
a019=a019*a064;
a091=a091+a019;
a089=a089-a091;
a091=a066-a089;
a039=a039*a091;
a039=a081+a039;
a085=a085*a039;
a078=a078+a085;
a078=a031*a078;
a094=a094*a058;
a078=a078+a094;
a094=a080*a078;
a083=a083+a094;
a094=a086*a083;
a096=a096*a074;
a094=a094+a096;
a094=a094/a098;
a097=a097/a098;
a096=2.*a098;
a081=a081/a096;
a097=a097*a081;
a094=a094-a097;
a133=a133-a094;
a105=a105*a133;
a097=arg[6]? arg[6][25] : 0;
a100=a100*a097;
a096=sin(a015);
a096=a096*a138;
a096=a099*a096;
a100=a100-a096;
a096=arg[6]? arg[6][30] : 0;
a103=a103*a096;
a085=cos(a015);
a085=a085*a138;
a085=a102*a085;
a103=a103+a085;
a085=a100+a103;
a085=a004*a085;
a105=a105+a085;
a113=a113*a044;
a085=arg[6]? arg[6][28] : 0;
a108=a108*a085;
a085=sin(a015);
a085=a085*a138;
a107=a107*a085;
a108=a108-a107;
a107=arg[6]? arg[6][29] : 0;
a111=a111*a107;
a107=cos(a015);
a107=a107*a138;
a110=a110*a107;
a111=a111+a110;
a110=a108+a111;
a110=a067*a110;
a113=a113+a110;
a110=arg[6]? arg[6][19] : 0;
a110=a095*a110;
a115=a115*a078;
a110=a110+a115;
a117=a117*a110;
a110=arg[6]? arg[6][16] : 0;
a115=arg[6]? arg[6][17] : 0;
a115=a015*a115;
a118=a118*a138;
a115=a115+a118;
a110=a110+a115;
a115=arg[6]? arg[6][18] : 0;
a010=a010*a115;
a119=a119*a007;
a010=a010+a119;
a110=a110+a010;
a116=a116*a110;
a117=a117+a116;
a113=a113+a117;
a120=a120*a025;
a116=arg[6]? arg[6][31] : 0;
a116=a028*a116;
a120=a120+a116;
a122=a122*a120;
a120=sin(a015);
a120=a120*a138;
a121=a121*a120;
a122=a122-a121;
a113=a113+a122;
a105=a105+a113;
a105=a001*a105;
a105=a105/a126;
a106=a106/a126;
a121=arg[6]? arg[6][0] : 0;
a124=a124*a121;
a120=sin(a015);
a120=a120*a138;
a120=a123*a120;
a124=a124-a120;
a120=a100+a103;
a120=a124-a120;
a116=arg[6]? arg[6][4] : 0;
a128=a128*a116;
a110=cos(a015);
a110=a110*a138;
a110=a127*a110;
a128=a128+a110;
a120=a120+a128;
a106=a106*a120;
a105=a105-a106;
a131=a131*a105;
a105=-a131;
if (res[0]!=0) res[0][0]=a105;
a106=arg[2]? arg[2][2] : 0;
a110=cos(a106);
a010=a125+a129;
a119=arg[4]? arg[4][2] : 0;
a007=a010*a119;
a115=arg[0]? arg[0][2] : 0;
a118=a124+a128;
a118=a115*a118;
a007=a007+a118;
a007=a007+a066;
a118=a110*a007;
a010=a115*a010;
a010=a010+a088;
a107=sin(a106);
a085=arg[6]? arg[6][2] : 0;
a107=a107*a085;
a107=a010*a107;
a118=a118-a107;
a107=sin(a106);
a019=arg[2]? arg[2][3] : 0;
a064=a001*a119;
a064=a019*a064;
a023=a001*a115;
a062=arg[6]? arg[6][3] : 0;
a068=a023*a062;
a064=a064+a068;
a068=a035+a064;
a068=a107*a068;
a023=a023*a019;
a073=a018+a023;
a077=cos(a106);
a077=a077*a085;
a077=a073*a077;
a068=a068+a077;
a118=a118-a068;
a068=sin(a106);
a077=a010*a068;
a076=a018+a023;
a075=cos(a106);
a070=a076*a075;
a070=a077+a070;
a041=casadi_sq(a070);
a071=arg[2]? arg[2][5] : 0;
a069=casadi_sq(a071);
a069=a016*a069;
a041=a041+a069;
a061=sqrt(a041);
a072=a118/a061;
a110=a010*a110;
a073=a073*a107;
a110=a110-a073;
a073=a110/a061;
a107=a073/a061;
a027=2.*a070;
a068=a068*a007;
a037=cos(a106);
a037=a037*a085;
a037=a010*a037;
a068=a068+a037;
a037=a035+a064;
a075=a075*a037;
a037=sin(a106);
a037=a037*a085;
a076=a076*a037;
a075=a075-a076;
a075=a068+a075;
a027=a027*a075;
a076=2.*a071;
a037=arg[6]? arg[6][5] : 0;
a076=a076*a037;
a076=a016*a076;
a027=a027+a076;
a061=2.*a061;
a061=a027/a061;
a107=a107*a061;
a072=a072-a107;
a107=casadi_sq(a073);
a107=a013+a107;
a107=a072/a107;
if (res[0]!=0) res[0][1]=a107;
a107=arg[2]? arg[2][36] : 0;
a061=1.0000000000000000e-03;
a065=arg[2]? arg[2][34] : 0;
a038=arg[2]? arg[2][35] : 0;
a130=casadi_fmax(a000,a130);
a036=a038*a130;
a036=a065+a036;
a034=casadi_fmax(a061,a036);
a026=a107*a034;
a030=arg[1]? arg[1][4] : 0;
a024=arg[2]? arg[2][41] : 0;
a032=a026-a024;
a056=a030*a032;
a056=a056+a024;
a056=a056/a026;
a024=5.0000000000000004e-06;
a059=a056+a024;
a049=-a059;
a137=casadi_sq(a071);
a135=casadi_sq(a137);
a005=casadi_sq(a070);
a048=casadi_sq(a110);
a005=a005+a048;
a048=casadi_sq(a005);
a135=a135+a048;
a135=sqrt(a135);
a048=sqrt(a135);
a055=a070/a048;
a054=casadi_fmin(a059,a055);
a052=a049<=a054;
a008=a054<=a049;
a136=a008+a052;
a052=a052/a136;
a047=a059<=a055;
a059=a055<=a059;
a012=a047+a059;
a047=a047/a012;
a009=arg[5]? arg[5][4] : 0;
a032=a032*a009;
a014=arg[6]? arg[6][36] : 0;
a034=a034*a014;
a014=a061<=a036;
a036=a036<=a061;
a036=a036+a014;
a014=a014/a036;
a036=arg[6]? arg[6][34] : 0;
a046=arg[6]? arg[6][35] : 0;
a139=a130*a046;
a140=a038*a131;
a139=a139-a140;
a139=a036+a139;
a014=a014*a139;
a107=a107*a014;
a034=a034+a107;
a107=arg[6]? arg[6][41] : 0;
a014=a034-a107;
a014=a030*a014;
a032=a032+a014;
a032=a032+a107;
a032=a032/a026;
a107=a056/a026;
a107=a107*a034;
a032=a032-a107;
a047=a047*a032;
a059=a059/a012;
a012=a075/a048;
a055=a055/a048;
a137=2.*a137;
a107=2.*a071;
a107=a107*a037;
a137=a137*a107;
a005=2.*a005;
a070=2.*a070;
a070=a070*a075;
a075=2.*a110;
a075=a075*a118;
a070=a070+a075;
a005=a005*a070;
a137=a137+a005;
a005=2.*a135;
a137=a137/a005;
a005=2.*a048;
a005=a137/a005;
a055=a055*a005;
a012=a012-a055;
a059=a059*a012;
a047=a047+a059;
a052=a052*a047;
a008=a008/a136;
a008=a008*a032;
a052=a052-a008;
a008=-100000.;
a136=a008*a056;
a047=100000.;
a049=casadi_fmax(a049,a054);
a054=a047*a049;
a136=a136-a054;
a136=a136+a001;
a054=casadi_fmax(a000,a136);
a059=a001*a054;
a059=a013-a059;
a012=1.0000000000000001e-05;
a055=casadi_sq(a054);
a070=a000<=a136;
a136=a136<=a000;
a136=a136+a070;
a070=a070/a136;
a136=a008*a032;
a075=a047*a052;
a136=a136-a075;
a070=a070*a136;
a136=a055*a070;
a075=2.*a054;
a075=a075*a070;
a075=a054*a075;
a136=a136+a075;
a136=a012*a136;
a136=a059*a136;
a054=a054*a055;
a054=a012*a054;
a070=a001*a070;
a070=a054*a070;
a136=a136-a070;
a136=a052+a136;
a056=a008*a056;
a070=a047*a049;
a056=a056+a070;
a056=a056+a001;
a070=casadi_fmax(a000,a056);
a055=a001*a070;
a055=a013-a055;
a075=casadi_sq(a070);
a107=a000<=a056;
a056=a056<=a000;
a056=a056+a107;
a107=a107/a056;
a032=a008*a032;
a052=a047*a052;
a032=a032+a052;
a107=a107*a032;
a032=a075*a107;
a052=2.*a070;
a052=a052*a107;
a052=a070*a052;
a032=a032+a052;
a032=a012*a032;
a032=a055*a032;
a070=a070*a075;
a070=a012*a070;
a107=a001*a107;
a107=a070*a107;
a032=a032-a107;
a136=a136-a032;
a032=a130*a136;
a054=a054*a059;
a049=a049+a054;
a070=a070*a055;
a049=a049-a070;
a070=a049*a131;
a032=a032-a070;
a032=a026*a032;
a070=a130*a049;
a055=a070*a034;
a032=a032+a055;
if (res[0]!=0) res[0][2]=a032;
a055=2.0000000000000000e-02;
a054=50.;
a059=a054*a030;
a107=arg[2]? arg[2][40] : 0;
a075=arg[2]? arg[2][39] : 0;
a052=arg[2]? arg[2][37] : 0;
a056=arg[2]? arg[2][38] : 0;
a014=a056-a013;
a139=casadi_fmax(a033,a014);
a139=sqrt(a139);
a140=a052*a139;
a141=1./a140;
a142=-a141;
a143=arg[2]? arg[2][32] : 0;
a144=arg[2]? arg[2][33] : 0;
a145=a144*a130;
a145=a143+a145;
a146=casadi_fmax(a000,a145);
a147=a146*a073;
a147=a147/a026;
a148=casadi_fmin(a147,a141);
a149=casadi_fmax(a142,a148);
a150=a013-a056;
a151=a149*a150;
a152=a052*a149;
a153=atan(a152);
a154=a056*a153;
a154=a154/a052;
a151=a151+a154;
a155=a052*a151;
a156=atan(a155);
a157=a075*a156;
a158=sin(a157);
a159=a107*a158;
a160=casadi_sq(a110);
a160=a160+a041;
a160=sqrt(a160);
a041=a159*a160;
a161=a110*a041;
a161=a161/a135;
a162=a161+a033;
a163=casadi_sq(a110);
a163=a163/a135;
a164=4.9999999999999999e-13;
a165=a163+a164;
a162=a162/a165;
a166=a054*a162;
a059=a059-a166;
a166=casadi_fmin(a013,a059);
a167=casadi_fmax(a000,a166);
a168=casadi_sq(a167);
a169=a167*a168;
a169=a055*a169;
a170=casadi_sq(a167);
a170=a040*a170;
a171=a042*a167;
a170=a170-a171;
a170=a170+a043;
a171=a169*a170;
a030=a030-a162;
a030=a030-a055;
a172=casadi_fmax(a000,a030);
a171=a171+a172;
a172=a110*a171;
a172=a172/a048;
a173=a041/a048;
a174=a172+a173;
a175=casadi_sq(a049);
a175=a013-a175;
a175=sqrt(a175);
a176=a175+a024;
a177=casadi_fmin(a174,a176);
a178=-a176;
a179=a177<=a178;
a180=a178<=a177;
a181=a179+a180;
a179=a179/a181;
a049=2.*a049;
a049=a049*a136;
a136=2.*a175;
a049=a049/a136;
a179=a179*a049;
a180=a180/a181;
a181=a174<=a176;
a176=a176<=a174;
a174=a181+a176;
a181=a181/a174;
a171=a171*a118;
a136=a000<=a166;
a166=a166<=a000;
a166=a166+a136;
a136=a136/a166;
a166=a059<=a013;
a059=a013<=a059;
a059=a059+a166;
a166=a166/a059;
a059=a054*a009;
a041=a041*a118;
a182=arg[6]? arg[6][40] : 0;
a158=a158*a182;
a157=cos(a157);
a183=arg[6]? arg[6][39] : 0;
a156=a156*a183;
a184=arg[6]? arg[6][37] : 0;
a151=a151*a184;
a185=a148<=a142;
a142=a142<=a148;
a148=a185+a142;
a185=a185/a148;
a140=a141/a140;
a186=a139*a184;
a187=a033<=a014;
a014=a014<=a033;
a014=a014+a187;
a187=a187/a014;
a014=arg[6]? arg[6][38] : 0;
a187=a187*a014;
a139=2.*a139;
a187=a187/a139;
a187=a052*a187;
a186=a186+a187;
a140=a140*a186;
a185=a185*a140;
a142=a142/a148;
a148=a147<=a141;
a186=a141<=a147;
a187=a148+a186;
a148=a148/a187;
a139=a000<=a145;
a145=a145<=a000;
a145=a145+a139;
a139=a139/a145;
a145=arg[6]? arg[6][32] : 0;
a188=arg[6]? arg[6][33] : 0;
a189=a130*a188;
a190=a144*a131;
a189=a189-a190;
a189=a145+a189;
a139=a139*a189;
a073=a073*a139;
a146=a146*a072;
a073=a073+a146;
a073=a073/a026;
a147=a147/a026;
a147=a147*a034;
a073=a073-a147;
a148=a148*a073;
a186=a186/a187;
a186=a186*a140;
a148=a148-a186;
a142=a142*a148;
a185=a185+a142;
a150=a150*a185;
a142=a149*a014;
a150=a150-a142;
a153=a153*a014;
a149=a149*a184;
a185=a052*a185;
a149=a149+a185;
a152=casadi_sq(a152);
a152=a013+a152;
a149=a149/a152;
a149=a056*a149;
a153=a153+a149;
a153=a153/a052;
a154=a154/a052;
a154=a154*a184;
a153=a153-a154;
a150=a150+a153;
a150=a052*a150;
a151=a151+a150;
a155=casadi_sq(a155);
a155=a013+a155;
a151=a151/a155;
a151=a075*a151;
a156=a156+a151;
a157=a157*a156;
a157=a107*a157;
a158=a158+a157;
a158=a160*a158;
a157=2.*a110;
a157=a157*a118;
a157=a157+a027;
a160=2.*a160;
a157=a157/a160;
a159=a159*a157;
a158=a158+a159;
a159=a110*a158;
a041=a041+a159;
a041=a041/a135;
a161=a161/a135;
a161=a161*a137;
a041=a041-a161;
a041=a041/a165;
a162=a162/a165;
a165=2.*a110;
a165=a165*a118;
a165=a165/a135;
a163=a163/a135;
a163=a163*a137;
a165=a165-a163;
a162=a162*a165;
a041=a041-a162;
a162=a054*a041;
a059=a059-a162;
a166=a166*a059;
a136=a136*a166;
a168=a168*a136;
a166=2.*a167;
a166=a166*a136;
a166=a167*a166;
a168=a168+a166;
a168=a055*a168;
a170=a170*a168;
a167=2.*a167;
a167=a167*a136;
a167=a040*a167;
a136=a042*a136;
a167=a167-a136;
a169=a169*a167;
a170=a170+a169;
a169=a000<=a030;
a030=a030<=a000;
a030=a030+a169;
a169=a169/a030;
a009=a009-a041;
a169=a169*a009;
a170=a170+a169;
a110=a110*a170;
a171=a171+a110;
a171=a171/a048;
a172=a172/a048;
a172=a172*a005;
a171=a171-a172;
a158=a158/a048;
a173=a173/a048;
a173=a173*a005;
a158=a158-a173;
a171=a171+a158;
a181=a181*a171;
a176=a176/a174;
a176=a176*a049;
a181=a181-a176;
a180=a180*a181;
a179=a179+a180;
a180=a008*a175;
a178=casadi_fmax(a178,a177);
a177=a047*a178;
a180=a180-a177;
a180=a180+a001;
a177=casadi_fmax(a000,a180);
a181=casadi_sq(a177);
a176=a177*a181;
a176=a012*a176;
a174=a000<=a180;
a180=a180<=a000;
a180=a180+a174;
a174=a174/a180;
a180=a008*a049;
a171=a047*a179;
a180=a180+a171;
a174=a174*a180;
a180=a001*a174;
a180=a176*a180;
a171=a001*a177;
a171=a013-a171;
a181=a181*a174;
a158=2.*a177;
a158=a158*a174;
a177=a177*a158;
a181=a181+a177;
a181=a012*a181;
a181=a171*a181;
a180=a180-a181;
a180=a179+a180;
a175=a008*a175;
a181=a047*a178;
a175=a175+a181;
a175=a175+a001;
a181=casadi_fmax(a000,a175);
a177=a001*a181;
a177=a013-a177;
a158=casadi_sq(a181);
a174=a000<=a175;
a175=a175<=a000;
a175=a175+a174;
a174=a174/a175;
a179=a047*a179;
a049=a008*a049;
a179=a179-a049;
a174=a174*a179;
a179=a158*a174;
a049=2.*a181;
a049=a049*a174;
a049=a181*a049;
a179=a179+a049;
a179=a012*a179;
a179=a177*a179;
a181=a181*a158;
a181=a012*a181;
a174=a001*a174;
a174=a181*a174;
a179=a179-a174;
a180=a180-a179;
a180=a130*a180;
a176=a176*a171;
a178=a178+a176;
a181=a181*a177;
a178=a178-a181;
a181=a178*a131;
a180=a180-a181;
a180=a026*a180;
a178=a130*a178;
a034=a178*a034;
a180=a180+a034;
if (res[0]!=0) res[0][3]=a180;
if (res[0]!=0) res[0][4]=a105;
a105=cos(a106);
a007=a105*a007;
a034=sin(a106);
a034=a034*a085;
a034=a010*a034;
a007=a007-a034;
a034=sin(a106);
a181=a035-a064;
a181=a034*a181;
a177=a018-a023;
a176=cos(a106);
a176=a176*a085;
a176=a177*a176;
a181=a181+a176;
a007=a007+a181;
a023=a018-a023;
a181=cos(a106);
a176=a023*a181;
a176=a176-a077;
a077=casadi_sq(a176);
a077=a077+a069;
a171=sqrt(a077);
a179=a007/a171;
a010=a010*a105;
a177=a177*a034;
a010=a010+a177;
a177=a010/a171;
a034=a177/a171;
a105=2.*a176;
a064=a035-a064;
a181=a181*a064;
a064=sin(a106);
a064=a064*a085;
a023=a023*a064;
a181=a181-a023;
a181=a181-a068;
a105=a105*a181;
a105=a105+a076;
a171=2.*a171;
a171=a105/a171;
a034=a034*a171;
a179=a179-a034;
a034=casadi_sq(a177);
a034=a013+a034;
a034=a179/a034;
if (res[0]!=0) res[0][5]=a034;
a034=arg[2]? arg[2][42] : 0;
a171=a038*a130;
a065=a065+a171;
a171=casadi_fmax(a061,a065);
a068=a034*a171;
a023=arg[1]? arg[1][5] : 0;
a064=arg[2]? arg[2][43] : 0;
a174=a068-a064;
a158=a023*a174;
a158=a158+a064;
a158=a158/a068;
a064=a158+a024;
a049=-a064;
a175=casadi_sq(a071);
a173=casadi_sq(a175);
a005=casadi_sq(a176);
a048=casadi_sq(a010);
a005=a005+a048;
a048=casadi_sq(a005);
a173=a173+a048;
a173=sqrt(a173);
a048=sqrt(a173);
a172=a176/a048;
a110=casadi_fmin(a064,a172);
a170=a049<=a110;
a169=a110<=a049;
a009=a169+a170;
a170=a170/a009;
a041=a064<=a172;
a064=a172<=a064;
a030=a041+a064;
a041=a041/a030;
a167=arg[5]? arg[5][5] : 0;
a174=a174*a167;
a136=arg[6]? arg[6][42] : 0;
a171=a171*a136;
a136=a061<=a065;
a065=a065<=a061;
a065=a065+a136;
a136=a136/a065;
a046=a130*a046;
a038=a038*a131;
a046=a046-a038;
a036=a036+a046;
a136=a136*a036;
a034=a034*a136;
a171=a171+a034;
a034=arg[6]? arg[6][43] : 0;
a136=a171-a034;
a136=a023*a136;
a174=a174+a136;
a174=a174+a034;
a174=a174/a068;
a034=a158/a068;
a034=a034*a171;
a174=a174-a034;
a041=a041*a174;
a064=a064/a030;
a030=a181/a048;
a172=a172/a048;
a175=2.*a175;
a034=2.*a071;
a034=a034*a037;
a175=a175*a034;
a005=2.*a005;
a176=2.*a176;
a176=a176*a181;
a181=2.*a010;
a181=a181*a007;
a176=a176+a181;
a005=a005*a176;
a175=a175+a005;
a005=2.*a173;
a175=a175/a005;
a005=2.*a048;
a005=a175/a005;
a172=a172*a005;
a030=a030-a172;
a064=a064*a030;
a041=a041+a064;
a170=a170*a041;
a169=a169/a009;
a169=a169*a174;
a170=a170-a169;
a169=a008*a158;
a049=casadi_fmax(a049,a110);
a110=a047*a049;
a169=a169-a110;
a169=a169+a001;
a110=casadi_fmax(a000,a169);
a009=a001*a110;
a009=a013-a009;
a041=casadi_sq(a110);
a064=a000<=a169;
a169=a169<=a000;
a169=a169+a064;
a064=a064/a169;
a169=a008*a174;
a030=a047*a170;
a169=a169-a030;
a064=a064*a169;
a169=a041*a064;
a030=2.*a110;
a030=a030*a064;
a030=a110*a030;
a169=a169+a030;
a169=a012*a169;
a169=a009*a169;
a110=a110*a041;
a110=a012*a110;
a064=a001*a064;
a064=a110*a064;
a169=a169-a064;
a169=a170+a169;
a158=a008*a158;
a064=a047*a049;
a158=a158+a064;
a158=a158+a001;
a064=casadi_fmax(a000,a158);
a041=a001*a064;
a041=a013-a041;
a030=casadi_sq(a064);
a172=a000<=a158;
a158=a158<=a000;
a158=a158+a172;
a172=a172/a158;
a174=a008*a174;
a170=a047*a170;
a174=a174+a170;
a172=a172*a174;
a174=a030*a172;
a170=2.*a064;
a170=a170*a172;
a170=a064*a170;
a174=a174+a170;
a174=a012*a174;
a174=a041*a174;
a064=a064*a030;
a064=a012*a064;
a172=a001*a172;
a172=a064*a172;
a174=a174-a172;
a169=a169-a174;
a174=a130*a169;
a110=a110*a009;
a049=a049+a110;
a064=a064*a041;
a049=a049-a064;
a064=a049*a131;
a174=a174-a064;
a174=a068*a174;
a064=a130*a049;
a041=a064*a171;
a174=a174+a041;
if (res[0]!=0) res[0][6]=a174;
a041=a054*a023;
a110=-a141;
a009=a144*a130;
a143=a143+a009;
a009=casadi_fmax(a000,a143);
a172=a009*a177;
a172=a172/a068;
a030=casadi_fmin(a172,a141);
a170=casadi_fmax(a110,a030);
a158=a013-a056;
a176=a170*a158;
a181=a052*a170;
a034=atan(a181);
a136=a056*a034;
a136=a136/a052;
a176=a176+a136;
a036=a052*a176;
a046=atan(a036);
a038=a075*a046;
a065=sin(a038);
a168=a107*a065;
a166=casadi_sq(a010);
a166=a166+a077;
a166=sqrt(a166);
a077=a168*a166;
a059=a010*a077;
a059=a059/a173;
a162=a059+a033;
a165=casadi_sq(a010);
a165=a165/a173;
a164=a165+a164;
a162=a162/a164;
a163=a054*a162;
a041=a041-a163;
a163=casadi_fmin(a013,a041);
a137=casadi_fmax(a000,a163);
a135=casadi_sq(a137);
a118=a137*a135;
a118=a055*a118;
a161=casadi_sq(a137);
a161=a040*a161;
a159=a042*a137;
a161=a161-a159;
a161=a161+a043;
a159=a118*a161;
a023=a023-a162;
a023=a023-a055;
a157=casadi_fmax(a000,a023);
a159=a159+a157;
a157=a010*a159;
a157=a157/a048;
a160=a077/a048;
a027=a157+a160;
a156=casadi_sq(a049);
a156=a013-a156;
a156=sqrt(a156);
a151=a156+a024;
a155=casadi_fmin(a027,a151);
a150=-a151;
a153=a155<=a150;
a154=a150<=a155;
a149=a153+a154;
a153=a153/a149;
a049=2.*a049;
a049=a049*a169;
a169=2.*a156;
a049=a049/a169;
a153=a153*a049;
a154=a154/a149;
a149=a027<=a151;
a151=a151<=a027;
a027=a149+a151;
a149=a149/a027;
a159=a159*a007;
a169=a000<=a163;
a163=a163<=a000;
a163=a163+a169;
a169=a169/a163;
a163=a041<=a013;
a041=a013<=a041;
a041=a041+a163;
a163=a163/a041;
a041=a054*a167;
a077=a077*a007;
a065=a065*a182;
a038=cos(a038);
a046=a046*a183;
a176=a176*a184;
a183=a030<=a110;
a110=a110<=a030;
a030=a183+a110;
a183=a183/a030;
a183=a183*a140;
a110=a110/a030;
a030=a172<=a141;
a141=a141<=a172;
a182=a030+a141;
a030=a030/a182;
a152=a000<=a143;
a143=a143<=a000;
a143=a143+a152;
a152=a152/a143;
a188=a130*a188;
a144=a144*a131;
a188=a188-a144;
a145=a145+a188;
a152=a152*a145;
a177=a177*a152;
a009=a009*a179;
a177=a177+a009;
a177=a177/a068;
a172=a172/a068;
a172=a172*a171;
a177=a177-a172;
a030=a030*a177;
a141=a141/a182;
a141=a141*a140;
a030=a030-a141;
a110=a110*a030;
a183=a183+a110;
a158=a158*a183;
a110=a170*a014;
a158=a158-a110;
a034=a034*a014;
a170=a170*a184;
a183=a052*a183;
a170=a170+a183;
a181=casadi_sq(a181);
a181=a013+a181;
a170=a170/a181;
a056=a056*a170;
a034=a034+a056;
a034=a034/a052;
a136=a136/a052;
a136=a136*a184;
a034=a034-a136;
a158=a158+a034;
a052=a052*a158;
a176=a176+a052;
a036=casadi_sq(a036);
a036=a013+a036;
a176=a176/a036;
a075=a075*a176;
a046=a046+a075;
a038=a038*a046;
a107=a107*a038;
a065=a065+a107;
a065=a166*a065;
a107=2.*a010;
a107=a107*a007;
a107=a107+a105;
a166=2.*a166;
a107=a107/a166;
a168=a168*a107;
a065=a065+a168;
a168=a010*a065;
a077=a077+a168;
a077=a077/a173;
a059=a059/a173;
a059=a059*a175;
a077=a077-a059;
a077=a077/a164;
a162=a162/a164;
a164=2.*a010;
a164=a164*a007;
a164=a164/a173;
a165=a165/a173;
a165=a165*a175;
a164=a164-a165;
a162=a162*a164;
a077=a077-a162;
a054=a054*a077;
a041=a041-a054;
a163=a163*a041;
a169=a169*a163;
a135=a135*a169;
a163=2.*a137;
a163=a163*a169;
a163=a137*a163;
a135=a135+a163;
a055=a055*a135;
a161=a161*a055;
a137=2.*a137;
a137=a137*a169;
a137=a040*a137;
a169=a042*a169;
a137=a137-a169;
a118=a118*a137;
a161=a161+a118;
a118=a000<=a023;
a023=a023<=a000;
a023=a023+a118;
a118=a118/a023;
a167=a167-a077;
a118=a118*a167;
a161=a161+a118;
a010=a010*a161;
a159=a159+a010;
a159=a159/a048;
a157=a157/a048;
a157=a157*a005;
a159=a159-a157;
a065=a065/a048;
a160=a160/a048;
a160=a160*a005;
a065=a065-a160;
a159=a159+a065;
a149=a149*a159;
a151=a151/a027;
a151=a151*a049;
a149=a149-a151;
a154=a154*a149;
a153=a153+a154;
a154=a008*a156;
a150=casadi_fmax(a150,a155);
a155=a047*a150;
a154=a154-a155;
a154=a154+a001;
a155=casadi_fmax(a000,a154);
a149=casadi_sq(a155);
a151=a155*a149;
a151=a012*a151;
a027=a000<=a154;
a154=a154<=a000;
a154=a154+a027;
a027=a027/a154;
a154=a008*a049;
a159=a047*a153;
a154=a154+a159;
a027=a027*a154;
a154=a001*a027;
a154=a151*a154;
a159=a001*a155;
a159=a013-a159;
a149=a149*a027;
a065=2.*a155;
a065=a065*a027;
a155=a155*a065;
a149=a149+a155;
a149=a012*a149;
a149=a159*a149;
a154=a154-a149;
a154=a153+a154;
a156=a008*a156;
a149=a047*a150;
a156=a156+a149;
a156=a156+a001;
a149=casadi_fmax(a000,a156);
a155=a001*a149;
a155=a013-a155;
a065=casadi_sq(a149);
a027=a000<=a156;
a156=a156<=a000;
a156=a156+a027;
a027=a027/a156;
a153=a047*a153;
a049=a008*a049;
a153=a153-a049;
a027=a027*a153;
a153=a065*a027;
a049=2.*a149;
a049=a049*a027;
a049=a149*a049;
a153=a153+a049;
a153=a012*a153;
a153=a155*a153;
a149=a149*a065;
a149=a012*a149;
a027=a001*a027;
a027=a149*a027;
a153=a153-a027;
a154=a154-a153;
a154=a130*a154;
a151=a151*a159;
a150=a150+a151;
a149=a149*a155;
a150=a150-a149;
a131=a150*a131;
a154=a154-a131;
a154=a068*a154;
a130=a130*a150;
a171=a130*a171;
a154=a154+a171;
if (res[0]!=0) res[0][7]=a154;
a171=a125+a129;
a150=a004*a171;
a150=a150+a114;
a150=a150/a126;
a114=a000<=a150;
a131=a150<=a000;
a131=a131+a114;
a114=a114/a131;
a171=a171*a133;
a133=a124+a128;
a004=a004*a133;
a171=a171+a004;
a171=a171+a113;
a171=a171/a126;
a126=a150/a126;
a126=a126*a120;
a171=a171-a126;
a114=a114*a171;
if (res[0]!=0) res[0][8]=a114;
a171=arg[1]? arg[1][6] : 0;
a126=arg[2]? arg[2][44] : 0;
a120=a171*a126;
a113=arg[1]? arg[1][7] : 0;
a120=a120+a113;
a113=arg[2]? arg[2][45] : 0;
a004=a013-a113;
a133=a120*a004;
a131=cos(a133);
a149=a101+a104;
a155=a149*a119;
a151=a100+a103;
a151=a115*a151;
a155=a155+a151;
a155=a155+a066;
a151=a131*a155;
a149=a115*a149;
a149=a149+a088;
a159=sin(a133);
a153=arg[5]? arg[5][6] : 0;
a126=a126*a153;
a027=arg[6]? arg[6][44] : 0;
a027=a171*a027;
a126=a126+a027;
a027=arg[5]? arg[5][7] : 0;
a126=a126+a027;
a004=a004*a126;
a126=arg[6]? arg[6][45] : 0;
a120=a120*a126;
a004=a004-a120;
a159=a159*a004;
a159=a149*a159;
a151=a151-a159;
a159=sin(a133);
a120=a159*a035;
a027=cos(a133);
a027=a027*a004;
a027=a018*a027;
a120=a120+a027;
a151=a151-a120;
a120=cos(a133);
a027=a018*a120;
a065=sin(a133);
a049=a149*a065;
a027=a027+a049;
a049=casadi_sq(a027);
a049=a049+a069;
a069=sqrt(a049);
a156=a151/a069;
a131=a149*a131;
a159=a018*a159;
a131=a131-a159;
a159=a131/a069;
a160=a159/a069;
a005=2.*a027;
a120=a120*a035;
a048=sin(a133);
a048=a048*a004;
a048=a018*a048;
a120=a120-a048;
a065=a065*a155;
a155=cos(a133);
a155=a155*a004;
a149=a149*a155;
a065=a065+a149;
a120=a120+a065;
a005=a005*a120;
a005=a005+a076;
a069=2.*a069;
a069=a005/a069;
a160=a160*a069;
a156=a156-a160;
a160=casadi_sq(a159);
a160=a013+a160;
a160=a156/a160;
if (res[0]!=0) res[0][9]=a160;
a160=arg[2]? arg[2][50] : 0;
a069=arg[2]? arg[2][48] : 0;
a076=arg[2]? arg[2][49] : 0;
a150=casadi_fmax(a000,a150);
a065=a076*a150;
a069=a069+a065;
a065=casadi_fmax(a061,a069);
a149=a160*a065;
a155=arg[2]? arg[2][55] : 0;
a155=a155/a149;
a048=a155+a024;
a157=-a048;
a010=casadi_sq(a071);
a161=casadi_sq(a010);
a118=casadi_sq(a027);
a167=casadi_sq(a131);
a118=a118+a167;
a167=casadi_sq(a118);
a161=a161+a167;
a161=sqrt(a161);
a167=sqrt(a161);
a077=a027/a167;
a023=casadi_fmin(a048,a077);
a137=casadi_fmax(a157,a023);
a169=a008*a155;
a055=a047*a137;
a169=a169-a055;
a169=a169+a001;
a055=casadi_fmax(a000,a169);
a135=casadi_sq(a055);
a163=a055*a135;
a163=a012*a163;
a041=a001*a055;
a041=a013-a041;
a054=a163*a041;
a054=a137+a054;
a162=a008*a155;
a137=a047*a137;
a162=a162+a137;
a162=a162+a001;
a137=casadi_fmax(a000,a162);
a164=casadi_sq(a137);
a165=a137*a164;
a165=a012*a165;
a175=a001*a137;
a175=a013-a175;
a173=a165*a175;
a054=a054-a173;
a173=a054*a114;
a007=a157<=a023;
a023=a023<=a157;
a157=a023+a007;
a007=a007/a157;
a059=a048<=a077;
a048=a077<=a048;
a168=a059+a048;
a059=a059/a168;
a107=arg[6]? arg[6][55] : 0;
a107=a107/a149;
a155=a155/a149;
a166=arg[6]? arg[6][50] : 0;
a065=a065*a166;
a166=a061<=a069;
a069=a069<=a061;
a069=a069+a166;
a166=a166/a069;
a069=arg[6]? arg[6][48] : 0;
a061=arg[6]? arg[6][49] : 0;
a061=a150*a061;
a076=a076*a114;
a061=a061+a076;
a069=a069+a061;
a166=a166*a069;
a160=a160*a166;
a065=a065+a160;
a155=a155*a065;
a107=a107-a155;
a059=a059*a107;
a048=a048/a168;
a168=a120/a167;
a077=a077/a167;
a010=2.*a010;
a071=2.*a071;
a071=a071*a037;
a010=a010*a071;
a118=2.*a118;
a027=2.*a027;
a027=a027*a120;
a120=2.*a131;
a120=a120*a151;
a027=a027+a120;
a118=a118*a027;
a010=a010+a118;
a161=2.*a161;
a010=a010/a161;
a161=2.*a167;
a010=a010/a161;
a077=a077*a010;
a168=a168-a077;
a048=a048*a168;
a059=a059+a048;
a007=a007*a059;
a023=a023/a157;
a023=a023*a107;
a007=a007-a023;
a023=a000<=a169;
a169=a169<=a000;
a169=a169+a023;
a023=a023/a169;
a169=a008*a107;
a157=a047*a007;
a169=a169-a157;
a023=a023*a169;
a135=a135*a023;
a169=2.*a055;
a169=a169*a023;
a055=a055*a169;
a135=a135+a055;
a135=a012*a135;
a041=a041*a135;
a023=a001*a023;
a163=a163*a023;
a041=a041-a163;
a041=a007+a041;
a163=a000<=a162;
a162=a162<=a000;
a162=a162+a163;
a163=a163/a162;
a107=a008*a107;
a007=a047*a007;
a107=a107+a007;
a163=a163*a107;
a164=a164*a163;
a107=2.*a137;
a107=a107*a163;
a137=a137*a107;
a164=a164+a137;
a164=a012*a164;
a175=a175*a164;
a163=a001*a163;
a165=a165*a163;
a175=a175-a165;
a041=a041-a175;
a175=a150*a041;
a173=a173+a175;
a173=a149*a173;
a175=a150*a054;
a165=a175*a065;
a173=a173+a165;
if (res[0]!=0) res[0][10]=a173;
a113=a013-a113;
a165=casadi_sq(a054);
a165=a013-a165;
a165=sqrt(a165);
a024=a165+a024;
a163=-a024;
a164=arg[2]? arg[2][54] : 0;
a137=arg[2]? arg[2][53] : 0;
a107=arg[2]? arg[2][51] : 0;
a007=arg[2]? arg[2][52] : 0;
a162=a007-a013;
a023=casadi_fmax(a033,a162);
a023=sqrt(a023);
a135=a107*a023;
a055=1./a135;
a169=-a055;
a157=arg[2]? arg[2][46] : 0;
a059=arg[2]? arg[2][47] : 0;
a048=a059*a150;
a157=a157+a048;
a048=casadi_fmax(a000,a157);
a168=a048*a159;
a168=a168/a149;
a077=casadi_fmin(a168,a055);
a161=casadi_fmax(a169,a077);
a118=a107*a161;
a027=atan(a118);
a120=a007*a027;
a120=a120/a107;
a071=a007-a013;
a037=a161*a071;
a037=a120-a037;
a155=a107*a037;
a160=atan(a155);
a166=a137*a160;
a069=sin(a166);
a061=a164*a069;
a076=casadi_sq(a131);
a076=a076+a049;
a076=sqrt(a076);
a049=a061*a076;
a049=a049/a167;
a105=casadi_fmin(a049,a024);
a038=casadi_fmax(a163,a105);
a046=a008*a165;
a075=a047*a038;
a046=a046-a075;
a046=a046+a001;
a075=casadi_fmax(a000,a046);
a176=casadi_sq(a075);
a036=a075*a176;
a036=a012*a036;
a052=a001*a075;
a052=a013-a052;
a158=a036*a052;
a158=a038+a158;
a034=a008*a165;
a038=a047*a038;
a034=a034+a038;
a034=a034+a001;
a038=casadi_fmax(a000,a034);
a136=casadi_sq(a038);
a184=a038*a136;
a184=a012*a184;
a056=a001*a038;
a056=a013-a056;
a170=a184*a056;
a158=a158-a170;
a170=a158*a114;
a181=a105<=a163;
a163=a163<=a105;
a105=a181+a163;
a181=a181/a105;
a054=2.*a054;
a054=a054*a041;
a165=2.*a165;
a054=a054/a165;
a181=a181*a054;
a163=a163/a105;
a105=a049<=a024;
a024=a024<=a049;
a165=a105+a024;
a105=a105/a165;
a041=arg[6]? arg[6][54] : 0;
a069=a069*a041;
a166=cos(a166);
a041=arg[6]? arg[6][53] : 0;
a160=a160*a041;
a041=arg[6]? arg[6][51] : 0;
a037=a037*a041;
a183=arg[6]? arg[6][52] : 0;
a027=a027*a183;
a014=a161*a041;
a110=a077<=a169;
a169=a169<=a077;
a077=a110+a169;
a110=a110/a077;
a135=a055/a135;
a030=a023*a041;
a141=a033<=a162;
a162=a162<=a033;
a162=a162+a141;
a141=a141/a162;
a141=a141*a183;
a023=2.*a023;
a141=a141/a023;
a141=a107*a141;
a030=a030+a141;
a135=a135*a030;
a110=a110*a135;
a169=a169/a077;
a077=a168<=a055;
a055=a055<=a168;
a030=a077+a055;
a077=a077/a030;
a141=a000<=a157;
a157=a157<=a000;
a157=a157+a141;
a141=a141/a157;
a157=arg[6]? arg[6][46] : 0;
a023=arg[6]? arg[6][47] : 0;
a023=a150*a023;
a059=a059*a114;
a023=a023+a059;
a157=a157+a023;
a141=a141*a157;
a159=a159*a141;
a048=a048*a156;
a159=a159+a048;
a159=a159/a149;
a168=a168/a149;
a168=a168*a065;
a159=a159-a168;
a077=a077*a159;
a055=a055/a030;
a055=a055*a135;
a077=a077-a055;
a169=a169*a077;
a110=a110+a169;
a169=a107*a110;
a014=a014+a169;
a118=casadi_sq(a118);
a118=a013+a118;
a014=a014/a118;
a007=a007*a014;
a027=a027+a007;
a027=a027/a107;
a120=a120/a107;
a120=a120*a041;
a027=a027-a120;
a071=a071*a110;
a161=a161*a183;
a071=a071+a161;
a027=a027-a071;
a107=a107*a027;
a037=a037+a107;
a155=casadi_sq(a155);
a155=a013+a155;
a037=a037/a155;
a137=a137*a037;
a160=a160+a137;
a166=a166*a160;
a164=a164*a166;
a069=a069+a164;
a069=a076*a069;
a131=2.*a131;
a131=a131*a151;
a131=a131+a005;
a076=2.*a076;
a131=a131/a076;
a061=a061*a131;
a069=a069+a061;
a069=a069/a167;
a049=a049/a167;
a049=a049*a010;
a069=a069-a049;
a105=a105*a069;
a024=a024/a165;
a024=a024*a054;
a105=a105-a024;
a163=a163*a105;
a181=a181+a163;
a163=a000<=a046;
a046=a046<=a000;
a046=a046+a163;
a163=a163/a046;
a046=a008*a054;
a105=a047*a181;
a046=a046+a105;
a163=a163*a046;
a046=a001*a163;
a036=a036*a046;
a176=a176*a163;
a046=2.*a075;
a046=a046*a163;
a075=a075*a046;
a176=a176+a075;
a176=a012*a176;
a052=a052*a176;
a036=a036-a052;
a036=a181+a036;
a052=a000<=a034;
a034=a034<=a000;
a034=a034+a052;
a052=a052/a034;
a047=a047*a181;
a008=a008*a054;
a047=a047-a008;
a052=a052*a047;
a136=a136*a052;
a047=2.*a038;
a047=a047*a052;
a038=a038*a047;
a136=a136+a038;
a012=a012*a136;
a056=a056*a012;
a052=a001*a052;
a184=a184*a052;
a056=a056-a184;
a036=a036-a056;
a036=a150*a036;
a170=a170+a036;
a170=a149*a170;
a150=a150*a158;
a065=a150*a065;
a170=a170+a065;
a170=a113*a170;
a150=a150*a149;
a126=a150*a126;
a170=a170-a126;
if (res[0]!=0) res[0][11]=a170;
if (res[0]!=0) res[0][12]=a138;
a126=casadi_sq(a092);
a126=a126+a087;
a087=a098/a126;
a087=a087*a091;
a126=a092/a126;
a126=a126*a081;
a087=a087-a126;
if (res[0]!=0) res[0][13]=a087;
if (res[0]!=0) res[0][14]=a079;
if (res[0]!=0) res[0][15]=a083;
a083=arg[6]? arg[6][23] : 0;
a126=arg[2]? arg[2][24] : 0;
a091=2.*a080;
a091=a091*a079;
a091=a126*a091;
a080=casadi_sq(a080);
a079=arg[6]? arg[6][24] : 0;
a079=a080*a079;
a091=a091+a079;
a083=a083+a091;
a083=a095*a083;
a091=arg[2]? arg[2][23] : 0;
a080=a080*a126;
a091=a091+a080;
a080=a091*a078;
a083=a083+a080;
if (res[0]!=0) res[0][16]=a083;
a080=2.5000000000000000e-01;
a084=a080*a084;
a093=sqrt(a093);
a126=a084*a093;
a079=a126*a115;
a065=a079*a031;
a158=arg[2]? arg[2][60] : 0;
a036=arg[6]? arg[6][58] : 0;
a036=a158*a036;
a056=arg[2]? arg[2][58] : 0;
a184=arg[6]? arg[6][60] : 0;
a052=a056*a184;
a036=a036+a052;
a036=a065*a036;
a056=a056*a158;
a080=a080*a082;
a080=a093*a080;
a093=2.*a093;
a039=a039/a093;
a084=a084*a039;
a080=a080+a084;
a080=a115*a080;
a126=a126*a119;
a080=a080+a126;
a080=a031*a080;
a079=a079*a058;
a080=a080+a079;
a079=a056*a080;
a036=a036+a079;
a079=arg[2]? arg[2][57] : 0;
a092=atan2(a092,a098);
a126=a079*a092;
a084=arg[2]? arg[2][59] : 0;
a039=arg[1]? arg[1][8] : 0;
a093=arg[2]? arg[2][56] : 0;
a082=a171*a093;
a039=a039-a082;
a082=a084*a039;
a126=a126+a082;
a082=a126*a078;
a052=arg[6]? arg[6][57] : 0;
a052=a092*a052;
a079=a079*a087;
a052=a052+a079;
a079=arg[6]? arg[6][59] : 0;
a079=a039*a079;
a012=arg[5]? arg[5][8] : 0;
a093=a093*a153;
a153=arg[6]? arg[6][56] : 0;
a171=a171*a153;
a093=a093+a171;
a012=a012-a093;
a084=a084*a012;
a079=a079+a084;
a052=a052+a079;
a052=a095*a052;
a082=a082+a052;
a036=a036+a082;
if (res[0]!=0) res[0][17]=a036;
a082=casadi_sq(a158);
a052=a082*a065;
a079=arg[6]? arg[6][63] : 0;
a079=a052*a079;
a084=arg[2]? arg[2][63] : 0;
a093=2.*a158;
a093=a093*a184;
a093=a065*a093;
a082=a082*a080;
a093=a093+a082;
a084=a084*a093;
a079=a079+a084;
a084=arg[2]? arg[2][61] : 0;
a082=arg[1]? arg[1][9] : 0;
a080=a084*a082;
a171=arg[2]? arg[2][62] : 0;
a153=a171*a092;
a080=a080+a153;
a153=a095*a184;
a136=a158*a078;
a153=a153+a136;
a080=a080*a153;
a153=a158*a095;
a136=arg[6]? arg[6][61] : 0;
a136=a082*a136;
a038=arg[5]? arg[5][9] : 0;
a084=a084*a038;
a136=a136+a084;
a084=arg[6]? arg[6][62] : 0;
a084=a092*a084;
a171=a171*a087;
a084=a084+a171;
a136=a136+a084;
a153=a153*a136;
a080=a080+a153;
a079=a079+a080;
if (res[0]!=0) res[0][18]=a079;
if (res[0]!=0) res[0][19]=a117;
a080=arg[6]? arg[6][66] : 0;
a052=a052*a080;
a080=arg[2]? arg[2][66] : 0;
a080=a080*a093;
a052=a052+a080;
a080=arg[2]? arg[2][64] : 0;
a093=a080*a082;
a153=arg[2]? arg[2][65] : 0;
a136=a153*a092;
a093=a093+a136;
a136=arg[2]? arg[2][67] : 0;
a084=a136*a039;
a093=a093+a084;
a184=a095*a184;
a078=a158*a078;
a184=a184+a078;
a093=a093*a184;
a158=a158*a095;
a184=arg[6]? arg[6][64] : 0;
a082=a082*a184;
a080=a080*a038;
a082=a082+a080;
a080=arg[6]? arg[6][65] : 0;
a092=a092*a080;
a153=a153*a087;
a092=a092+a153;
a082=a082+a092;
a092=arg[6]? arg[6][67] : 0;
a092=a039*a092;
a136=a136*a012;
a092=a092+a136;
a082=a082+a092;
a158=a158*a082;
a093=a093+a158;
a052=a052+a093;
if (res[0]!=0) res[0][20]=a052;
a022=a018-a022;
a093=casadi_sq(a022);
a093=a093+a016;
a093=sqrt(a093);
a158=a022*a093;
a158=a158+a029;
a029=a017*a158;
a082=casadi_fmin(a013,a029);
a092=casadi_fmax(a000,a082);
a136=casadi_sq(a092);
a153=a092*a136;
a153=a016*a153;
a087=casadi_sq(a092);
a087=a040*a087;
a080=a042*a092;
a087=a087-a080;
a087=a087+a043;
a043=a153*a087;
a158=a158+a045;
a045=casadi_fmax(a000,a158);
a043=a043+a045;
a043=a043+a016;
a045=sqrt(a043);
a080=arg[2]? arg[2][69] : 0;
a038=sin(a015);
a184=a080*a038;
a078=arg[2]? arg[2][68] : 0;
a084=cos(a015);
a171=a078*a084;
a184=a184-a171;
a047=a115*a184;
a047=a047+a088;
a047=a047-a090;
a090=casadi_sq(a047);
a090=a090+a043;
a008=a045/a090;
a119=a184*a119;
a054=arg[6]? arg[6][69] : 0;
a038=a038*a054;
a181=cos(a015);
a181=a181*a138;
a181=a080*a181;
a038=a038+a181;
a181=arg[6]? arg[6][68] : 0;
a084=a084*a181;
a034=sin(a015);
a034=a034*a138;
a034=a078*a034;
a084=a084-a034;
a038=a038-a084;
a115=a115*a038;
a119=a119+a115;
a119=a119+a066;
a119=a119-a089;
a008=a008*a119;
a090=a047/a090;
a089=a000<=a082;
a082=a082<=a000;
a082=a082+a089;
a089=a089/a082;
a082=a029<=a013;
a029=a013<=a029;
a029=a029+a082;
a082=a082/a029;
a021=a035-a021;
a029=a093*a021;
a115=2.*a022;
a115=a115*a021;
a093=2.*a093;
a115=a115/a093;
a022=a022*a115;
a029=a029+a022;
a029=a029+a060;
a017=a017*a029;
a082=a082*a017;
a089=a089*a082;
a136=a136*a089;
a082=2.*a092;
a082=a082*a089;
a082=a092*a082;
a136=a136+a082;
a016=a016*a136;
a087=a087*a016;
a092=2.*a092;
a092=a092*a089;
a040=a040*a092;
a042=a042*a089;
a040=a040-a042;
a153=a153*a040;
a087=a087+a153;
a153=a000<=a158;
a158=a158<=a000;
a158=a158+a153;
a153=a153/a158;
a153=a153*a029;
a087=a087+a153;
a153=2.*a045;
a153=a087/a153;
a090=a090*a153;
a008=a008-a090;
if (res[0]!=0) res[0][21]=a008;
a090=arg[2]? arg[2][70] : 0;
a006=a090+a006;
a153=-a006;
a029=arg[2]? arg[2][71] : 0;
a045=atan2(a047,a045);
a158=arg[2]? arg[2][72] : 0;
a040=a039*a158;
a045=a045-a040;
a040=a029*a045;
a042=casadi_fmin(a006,a040);
a089=a153<=a042;
a092=a042<=a153;
a016=a092+a089;
a089=a089/a016;
a136=a006<=a040;
a040=a040<=a006;
a006=a136+a040;
a136=a136/a006;
a082=arg[6]? arg[6][70] : 0;
a136=a136*a082;
a040=a040/a006;
a006=arg[6]? arg[6][71] : 0;
a045=a045*a006;
a158=a158*a012;
a012=arg[6]? arg[6][72] : 0;
a039=a039*a012;
a158=a158+a039;
a008=a008-a158;
a029=a029*a008;
a045=a045+a029;
a040=a040*a045;
a136=a136+a040;
a089=a089*a136;
a092=a092/a016;
a092=a092*a082;
a089=a089-a092;
a092=a051*a090;
a153=casadi_fmax(a153,a042);
a042=a053*a153;
a092=a092-a042;
a092=a092+a001;
a042=casadi_fmax(a000,a092);
a016=a001*a042;
a016=a013-a016;
a136=casadi_sq(a042);
a040=a000<=a092;
a092=a092<=a000;
a092=a092+a040;
a040=a040/a092;
a092=a051*a082;
a045=a053*a089;
a092=a092-a045;
a040=a040*a092;
a092=a136*a040;
a045=2.*a042;
a045=a045*a040;
a045=a042*a045;
a092=a092+a045;
a092=a050*a092;
a092=a016*a092;
a042=a042*a136;
a042=a050*a042;
a040=a001*a040;
a040=a042*a040;
a092=a092-a040;
a092=a089+a092;
a090=a051*a090;
a040=a053*a153;
a090=a090+a040;
a090=a090+a001;
a040=casadi_fmax(a000,a090);
a136=a001*a040;
a013=a013-a136;
a136=casadi_sq(a040);
a045=a000<=a090;
a090=a090<=a000;
a090=a090+a045;
a045=a045/a090;
a051=a051*a082;
a053=a053*a089;
a051=a051+a053;
a045=a045*a051;
a051=a136*a045;
a053=2.*a040;
a053=a053*a045;
a053=a040*a053;
a051=a051+a053;
a051=a050*a051;
a051=a013*a051;
a040=a040*a136;
a050=a050*a040;
a045=a001*a045;
a045=a050*a045;
a051=a051-a045;
a092=a092-a051;
if (res[0]!=0) res[0][22]=a092;
a051=casadi_sq(a047);
a043=a043+a051;
a051=arg[2]? arg[2][74] : 0;
a042=a042*a016;
a153=a153+a042;
a050=a050*a013;
a153=a153-a050;
a050=arg[6]? arg[6][73] : 0;
a050=a001*a050;
a050=a153*a050;
a013=arg[2]? arg[2][73] : 0;
a013=a001*a013;
a092=a013*a092;
a050=a050+a092;
a050=a051*a050;
a013=a013*a153;
a153=arg[6]? arg[6][74] : 0;
a153=a013*a153;
a050=a050+a153;
a050=a031*a050;
a013=a013*a051;
a058=a013*a058;
a050=a050+a058;
a050=a043*a050;
a013=a013*a031;
a047=2.*a047;
a047=a047*a119;
a087=a087+a047;
a087=a013*a087;
a050=a050+a087;
if (res[0]!=0) res[0][23]=a050;
if (res[0]!=0) res[0][24]=a011;
if (res[0]!=0) res[0][25]=a057;
if (res[0]!=0) res[0][26]=a044;
a057=sin(a020);
a011=a018*a057;
a087=cos(a020);
a047=a088*a087;
a011=a011+a047;
a047=2.*a011;
a057=a057*a035;
a119=cos(a020);
a119=a119*a063;
a119=a018*a119;
a057=a057+a119;
a087=a087*a066;
a119=sin(a020);
a119=a119*a063;
a119=a088*a119;
a087=a087-a119;
a057=a057+a087;
a047=a047*a057;
a057=cos(a020);
a087=a018*a057;
a119=sin(a020);
a031=a088*a119;
a087=a087-a031;
a031=2.*a087;
a057=a057*a035;
a035=sin(a020);
a035=a035*a063;
a018=a018*a035;
a057=a057-a018;
a119=a119*a066;
a066=cos(a020);
a066=a066*a063;
a088=a088*a066;
a119=a119+a088;
a057=a057-a119;
a031=a031*a057;
a047=a047+a031;
a011=casadi_sq(a011);
a087=casadi_sq(a087);
a011=a011+a087;
a011=a011+a033;
a011=sqrt(a011);
a011=2.*a011;
a047=a047/a011;
if (res[0]!=0) res[0][27]=a047;
a011=sin(a106);
a033=a011*a180;
a178=a178*a026;
a087=cos(a106);
a087=a087*a085;
a087=a178*a087;
a033=a033+a087;
a087=cos(a106);
a031=a087*a032;
a070=a070*a026;
a026=sin(a106);
a026=a026*a085;
a026=a070*a026;
a031=a031-a026;
a033=a033-a031;
a031=cos(a106);
a026=a031*a174;
a064=a064*a068;
a057=sin(a106);
a057=a057*a085;
a057=a064*a057;
a026=a026-a057;
a057=sin(a106);
a119=a057*a154;
a130=a130*a068;
a068=cos(a106);
a068=a068*a085;
a068=a130*a068;
a119=a119+a068;
a026=a026+a119;
a119=a033-a026;
a068=sin(a133);
a088=a068*a170;
a150=a150*a113;
a113=cos(a133);
a113=a113*a004;
a113=a150*a113;
a088=a088+a113;
a113=cos(a133);
a066=a113*a173;
a175=a175*a149;
a149=sin(a133);
a149=a149*a004;
a149=a175*a149;
a066=a066-a149;
a088=a088-a066;
a119=a119+a088;
a119=a119+a025;
a083=a086*a083;
a091=a091*a095;
a074=a091*a074;
a083=a083+a074;
a083=a083/a098;
a091=a091*a086;
a091=a091/a098;
a098=a091/a098;
a098=a098*a081;
a083=a083-a098;
a119=a119-a083;
if (res[0]!=0) res[0][28]=a119;
a083=arg[5]? arg[5][10] : 0;
a098=a083-a050;
a098=a098+a036;
a036=sin(a106);
a032=a036*a032;
a081=cos(a106);
a081=a081*a085;
a081=a070*a081;
a032=a032+a081;
a081=cos(a106);
a180=a081*a180;
a086=sin(a106);
a086=a086*a085;
a086=a178*a086;
a180=a180-a086;
a032=a032+a180;
a098=a098-a032;
a180=sin(a106);
a174=a180*a174;
a086=cos(a106);
a086=a086*a085;
a086=a064*a086;
a174=a174+a086;
a086=cos(a106);
a154=a086*a154;
a106=sin(a106);
a106=a106*a085;
a106=a130*a106;
a154=a154-a106;
a174=a174-a154;
a098=a098+a174;
a154=sin(a133);
a173=a154*a173;
a106=cos(a133);
a106=a106*a004;
a106=a175*a106;
a173=a173+a106;
a106=cos(a133);
a170=a106*a170;
a133=sin(a133);
a133=a133*a004;
a133=a150*a133;
a170=a170-a133;
a173=a173+a170;
a098=a098-a173;
if (res[0]!=0) res[0][29]=a098;
a184=a184*a050;
a013=a013*a043;
a038=a013*a038;
a184=a184+a038;
a171=a171*a083;
a038=arg[1]? arg[1][10] : 0;
a084=a038*a084;
a171=a171+a084;
a184=a184+a171;
a052=a052-a184;
a184=a001*a033;
a184=a019*a184;
a011=a178*a011;
a087=a070*a087;
a011=a011-a087;
a087=a001*a011;
a087=a087*a062;
a184=a184+a087;
a052=a052+a184;
a184=a001*a026;
a019=a019*a184;
a031=a064*a031;
a057=a130*a057;
a031=a031+a057;
a001=a001*a031;
a001=a001*a062;
a019=a019+a001;
a052=a052+a019;
a019=a125+a129;
a019=a019*a032;
a070=a070*a036;
a178=a178*a081;
a070=a070+a178;
a178=a124+a128;
a178=a070*a178;
a019=a019+a178;
a052=a052-a019;
a125=a125+a129;
a125=a125*a174;
a064=a064*a180;
a130=a130*a086;
a064=a064-a130;
a124=a124+a128;
a124=a064*a124;
a125=a125+a124;
a052=a052+a125;
a101=a101+a104;
a101=a101*a173;
a154=a175*a154;
a106=a150*a106;
a154=a154+a106;
a100=a100+a103;
a100=a154*a100;
a101=a101+a100;
a052=a052-a101;
if (res[0]!=0) res[0][30]=a052;
a119=a119/a003;
a052=a011-a031;
a150=a150*a068;
a175=a175*a113;
a150=a150-a175;
a052=a052+a150;
a052=a052+a028;
a052=a052-a091;
a052=a052/a003;
a052=a052/a003;
a052=a052*a134;
a119=a119-a052;
if (res[0]!=0) res[0][31]=a119;
a098=a098/a003;
a119=a038-a013;
a056=a056*a065;
a095=a095*a126;
a056=a056+a095;
a119=a119+a056;
a119=a119-a070;
a119=a119+a064;
a119=a119-a154;
a119=a119/a003;
a119=a119/a003;
a119=a119*a134;
a098=a098-a119;
if (res[0]!=0) res[0][32]=a098;
a003=a003*a132;
a002=a002*a134;
a003=a003+a002;
a003=a003-a044;
a003=a003-a094;
if (res[0]!=0) res[0][33]=a003;
a003=sin(a015);
a083=a078*a083;
a094=a038*a181;
a083=a083+a094;
a003=a003*a083;
a038=a038*a078;
a083=cos(a015);
a083=a083*a138;
a038=a038*a083;
a003=a003+a038;
a038=sin(a015);
a083=a078*a050;
a181=a013*a181;
a083=a083+a181;
a038=a038*a083;
a078=a013*a078;
a083=cos(a015);
a083=a083*a138;
a078=a078*a083;
a038=a038+a078;
a078=cos(a015);
a050=a080*a050;
a054=a013*a054;
a050=a050+a054;
a078=a078*a050;
a013=a013*a080;
a080=sin(a015);
a080=a080*a138;
a013=a013*a080;
a078=a078-a013;
a038=a038+a078;
a003=a003-a038;
a003=a003-a079;
a079=cos(a015);
a038=a127*a032;
a078=a070*a116;
a038=a038+a078;
a079=a079*a038;
a038=a070*a127;
a078=sin(a015);
a078=a078*a138;
a038=a038*a078;
a079=a079-a038;
a003=a003-a079;
a079=sin(a015);
a038=a123*a079;
a032=a038*a032;
a079=a079*a121;
a121=cos(a015);
a121=a121*a138;
a123=a123*a121;
a079=a079+a123;
a070=a070*a079;
a032=a032+a070;
a003=a003+a032;
a032=cos(a015);
a070=a127*a174;
a123=a064*a116;
a070=a070+a123;
a032=a032*a070;
a070=a064*a127;
a123=sin(a015);
a123=a123*a138;
a070=a070*a123;
a032=a032-a070;
a003=a003+a032;
a174=a038*a174;
a064=a064*a079;
a174=a174+a064;
a003=a003-a174;
a174=cos(a015);
a064=a102*a173;
a032=a154*a096;
a064=a064+a032;
a174=a174*a064;
a064=a154*a102;
a032=sin(a015);
a032=a032*a138;
a064=a064*a032;
a174=a174-a064;
a003=a003-a174;
a174=sin(a015);
a064=a099*a174;
a173=a064*a173;
a174=a174*a097;
a097=cos(a015);
a097=a097*a138;
a099=a099*a097;
a174=a174+a099;
a154=a154*a174;
a173=a173+a154;
a003=a003+a173;
if (res[0]!=0) res[0][34]=a003;
a003=a038*a033;
a173=a011*a079;
a003=a003+a173;
a109=a109*a044;
a108=a067*a108;
a109=a109+a108;
a112=a112*a044;
a067=a067*a111;
a112=a112+a067;
a109=a109+a112;
a109=a109+a117;
a003=a003-a109;
a109=cos(a015);
a117=a127*a109;
a033=a117*a033;
a109=a109*a116;
a116=sin(a015);
a116=a116*a138;
a127=a127*a116;
a109=a109-a127;
a011=a011*a109;
a033=a033+a011;
a003=a003-a033;
a038=a038*a026;
a079=a031*a079;
a038=a038+a079;
a003=a003-a038;
a117=a117*a026;
a031=a031*a109;
a117=a117+a031;
a003=a003+a117;
a117=cos(a015);
a031=a102*a088;
a096=a150*a096;
a031=a031+a096;
a117=a117*a031;
a102=a150*a102;
a015=sin(a015);
a015=a015*a138;
a102=a102*a015;
a117=a117-a102;
a003=a003-a117;
a064=a064*a088;
a150=a150*a174;
a064=a064+a150;
a003=a003+a064;
a003=a003-a122;
if (res[0]!=0) res[0][35]=a003;
a003=arg[6]? arg[6][75] : 0;
a047=a047-a003;
if (res[0]!=0) res[0][36]=a047;
a047=-5.0000000000000000e-01;
a003=arg[6]? arg[6][76] : 0;
a047=a047*a003;
a003=arg[0]? arg[0][4] : 0;
a003=casadi_sign(a003);
a122=arg[4]? arg[4][4] : 0;
a003=a003*a122;
a047=a047+a003;
if (res[0]!=0) res[0][37]=a047;
a020=casadi_sign(a020);
a020=a020*a063;
a063=arg[6]? arg[6][77] : 0;
a020=a020-a063;
if (res[0]!=0) res[0][38]=a020;
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
casadi_real a444;
a000=arg[0]? arg[0][5] : 0;
a001=cos(a000);
a002=arg[0]? arg[0][0] : 0;
a003=a002*a001;
a004=arg[0]? arg[0][1] : 0;
a005=sin(a000);
a006=a004*a005;
a003=a003-a006;
a006=2.*a003;
a007=arg[4]? arg[4][36] : 0;
a008=arg[4]? arg[4][27] : 0;
a008=a007+a008;
a009=sin(a000);
a010=a002*a009;
a011=cos(a000);
a012=a004*a011;
a010=a010+a012;
a012=casadi_sq(a010);
a003=casadi_sq(a003);
a012=a012+a003;
a003=9.9999999999999998e-13;
a012=a012+a003;
a012=sqrt(a012);
a012=2.*a012;
a008=a008/a012;
a006=a006*a008;
a001=a001*a006;
a010=2.*a010;
a010=a010*a008;
a009=a009*a010;
a001=a001+a009;
a009=arg[1]? arg[1][0] : 0;
a008=cos(a000);
a012=a009*a008;
a013=arg[1]? arg[1][1] : 0;
a014=sin(a000);
a015=a013*a014;
a012=a012+a015;
a015=a002-a012;
a016=casadi_sq(a015);
a017=9.9999999999999995e-07;
a016=a016+a017;
a016=sqrt(a016);
a018=0.;
a019=a015*a016;
a020=arg[1]? arg[1][2] : 0;
a021=2.*a020;
a022=arg[2]? arg[2][6] : 0;
a023=arg[2]? arg[2][7] : 0;
a024=casadi_sq(a023);
a024=a024+a003;
a024=sqrt(a024);
a025=a022*a024;
a021=a021/a025;
a019=a019+a021;
a026=-9.9999999999999995e-07;
a027=a019+a026;
a028=a018<=a027;
a029=a027<=a018;
a029=a029+a028;
a028=a028/a029;
a029=5.0000000000000000e-01;
a030=arg[2]? arg[2][73] : 0;
a030=a029*a030;
a031=arg[2]? arg[2][70] : 0;
a032=1.0000000000000001e-01;
a033=a031+a032;
a034=-a033;
a035=arg[2]? arg[2][71] : 0;
a036=arg[0]? arg[0][2] : 0;
a037=arg[2]? arg[2][69] : 0;
a038=arg[2]? arg[2][1] : 0;
a039=sin(a038);
a040=a037*a039;
a041=arg[2]? arg[2][68] : 0;
a042=cos(a038);
a043=a041*a042;
a040=a040-a043;
a044=a036*a040;
a044=a044+a004;
a045=cos(a000);
a046=a013*a045;
a047=sin(a000);
a048=a009*a047;
a046=a046-a048;
a044=a044-a046;
a048=1.;
a049=1000000.;
a019=a049*a019;
a050=casadi_fmin(a048,a019);
a051=casadi_fmax(a018,a050);
a052=casadi_sq(a051);
a053=a051*a052;
a053=a017*a053;
a054=3.;
a055=casadi_sq(a051);
a055=a054*a055;
a056=8.;
a057=a056*a051;
a055=a055-a057;
a057=6.;
a055=a055+a057;
a058=a053*a055;
a027=casadi_fmax(a018,a027);
a058=a058+a027;
a058=a058+a017;
a027=sqrt(a058);
a059=atan2(a044,a027);
a060=arg[1]? arg[1][8] : 0;
a061=arg[1]? arg[1][6] : 0;
a062=arg[2]? arg[2][56] : 0;
a063=a061*a062;
a060=a060-a063;
a063=arg[2]? arg[2][72] : 0;
a064=a060*a063;
a059=a059-a064;
a064=a035*a059;
a065=casadi_fmin(a033,a064);
a066=casadi_fmax(a034,a065);
a067=2.0000000000000001e-01;
a068=-5.;
a069=a068*a031;
a070=5.;
a071=a070*a066;
a069=a069-a071;
a069=a069+a029;
a071=casadi_fmax(a018,a069);
a072=casadi_sq(a071);
a073=a071*a072;
a073=a067*a073;
a074=a029*a071;
a074=a048-a074;
a075=a073*a074;
a075=a066+a075;
a031=a068*a031;
a066=a070*a066;
a031=a031+a066;
a031=a031+a029;
a066=casadi_fmax(a018,a031);
a076=casadi_sq(a066);
a077=a066*a076;
a077=a067*a077;
a078=a029*a066;
a078=a048-a078;
a079=a077*a078;
a075=a075-a079;
a079=a030*a075;
a080=arg[2]? arg[2][74] : 0;
a081=a079*a080;
a082=a081*a023;
a083=arg[4]? arg[4][23] : 0;
a084=cos(a038);
a085=arg[4]? arg[4][34] : 0;
a084=a084*a085;
a086=a037*a084;
a087=sin(a038);
a087=a087*a085;
a088=a041*a087;
a086=a086+a088;
a088=arg[4]? arg[4][30] : 0;
a089=a040*a088;
a086=a086+a089;
a089=arg[4]? arg[4][32] : 0;
a090=arg[2]? arg[2][27] : 0;
a091=a089/a090;
a092=arg[4]? arg[4][29] : 0;
a091=a091+a092;
a086=a086+a091;
a083=a083-a086;
a086=a082*a083;
a092=casadi_sq(a044);
a092=a092+a058;
a093=a044/a092;
a094=a064<=a033;
a033=a033<=a064;
a064=a033+a094;
a094=a094/a064;
a095=a034<=a065;
a065=a065<=a034;
a034=a065+a095;
a095=a095/a034;
a096=a018<=a031;
a031=a031<=a018;
a031=a031+a096;
a096=a096/a031;
a031=casadi_sq(a044);
a058=a058+a031;
a083=a058*a083;
a031=a023*a083;
a080=a080*a031;
a030=a030*a080;
a097=arg[4]? arg[4][22] : 0;
a030=a030+a097;
a077=a077*a030;
a077=a029*a077;
a078=a078*a030;
a078=a067*a078;
a076=a076*a078;
a077=a077-a076;
a076=2.*a066;
a066=a066*a078;
a076=a076*a066;
a077=a077-a076;
a096=a096*a077;
a077=a070*a096;
a077=a077+a030;
a076=a018<=a069;
a069=a069<=a018;
a069=a069+a076;
a076=a076/a069;
a074=a074*a030;
a074=a067*a074;
a072=a072*a074;
a073=a073*a030;
a073=a029*a073;
a072=a072-a073;
a073=2.*a071;
a071=a071*a074;
a073=a073*a071;
a072=a072+a073;
a076=a076*a072;
a072=a070*a076;
a077=a077-a072;
a095=a095*a077;
a094=a094*a095;
a035=a035*a094;
a072=arg[4]? arg[4][21] : 0;
a072=a035+a072;
a093=a093*a072;
a073=2.*a027;
a093=a093/a073;
a093=a086-a093;
a028=a028*a093;
a073=a019<=a048;
a019=a048<=a019;
a019=a019+a073;
a073=a073/a019;
a019=a018<=a050;
a050=a050<=a018;
a050=a050+a019;
a019=a019/a050;
a050=2.*a051;
a053=a053*a093;
a071=a054*a053;
a050=a050*a071;
a053=a056*a053;
a050=a050-a053;
a055=a055*a093;
a055=a017*a055;
a052=a052*a055;
a050=a050+a052;
a052=2.*a051;
a051=a051*a055;
a052=a052*a051;
a050=a050+a052;
a019=a019*a050;
a073=a073*a019;
a073=a049*a073;
a028=a028+a073;
a073=a016*a028;
a019=2.*a015;
a015=a015*a028;
a016=2.*a016;
a015=a015/a016;
a019=a019*a015;
a073=a073+a019;
a001=a001+a073;
a019=arg[2]? arg[2][44] : 0;
a015=a061*a019;
a016=arg[1]? arg[1][7] : 0;
a015=a015+a016;
a016=arg[2]? arg[2][45] : 0;
a050=a048-a016;
a052=a015*a050;
a051=cos(a052);
a055=a002*a051;
a093=arg[2]? arg[2][25] : 0;
a053=cos(a038);
a071=a093*a053;
a074=arg[2]? arg[2][30] : 0;
a030=sin(a038);
a069=a074*a030;
a066=a071+a069;
a078=a036*a066;
a078=a078+a004;
a097=sin(a052);
a098=a078*a097;
a055=a055+a098;
a098=arg[2]? arg[2][5] : 0;
a099=casadi_sq(a098);
a100=casadi_sq(a099);
a101=casadi_sq(a055);
a102=cos(a052);
a103=a078*a102;
a104=sin(a052);
a105=a002*a104;
a103=a103-a105;
a105=casadi_sq(a103);
a101=a101+a105;
a105=casadi_sq(a101);
a100=a100+a105;
a100=sqrt(a100);
a105=sqrt(a100);
a106=a055/a105;
a107=arg[2]? arg[2][55] : 0;
a108=arg[2]? arg[2][50] : 0;
a109=1.0000000000000000e-03;
a110=arg[2]? arg[2][48] : 0;
a111=arg[2]? arg[2][49] : 0;
a112=arg[2]? arg[2][26] : 0;
a113=a112*a090;
a114=arg[2]? arg[2][12] : 0;
a115=a114+a032;
a116=-a115;
a117=arg[2]? arg[2][11] : 0;
a118=arg[1]? arg[1][3] : 0;
a119=arg[2]? arg[2][10] : 0;
a120=a118*a119;
a121=arg[2]? arg[2][9] : 0;
a120=a120+a121;
a121=arg[2]? arg[2][8] : 0;
a121=a048-a121;
a122=a002-a012;
a123=casadi_sq(a122);
a123=a123+a017;
a123=sqrt(a123);
a124=a122*a123;
a124=a124+a021;
a125=a049*a124;
a126=casadi_fmin(a048,a125);
a127=casadi_fmax(a018,a126);
a128=casadi_sq(a127);
a129=a127*a128;
a129=a017*a129;
a130=casadi_sq(a127);
a130=a054*a130;
a131=a056*a127;
a130=a130-a131;
a130=a130+a057;
a131=a129*a130;
a026=a026+a124;
a124=casadi_fmax(a018,a026);
a131=a131+a124;
a131=a131+a017;
a124=sqrt(a131);
a124=atan2(a018,a124);
a124=a038+a124;
a132=a121*a124;
a120=a120+a132;
a132=a117*a120;
a133=casadi_fmin(a115,a132);
a134=casadi_fmax(a116,a133);
a135=a068*a114;
a136=a070*a134;
a135=a135-a136;
a135=a135+a029;
a136=casadi_fmax(a018,a135);
a137=casadi_sq(a136);
a138=a136*a137;
a138=a067*a138;
a139=a029*a136;
a139=a048-a139;
a140=a138*a139;
a140=a134+a140;
a114=a068*a114;
a134=a070*a134;
a114=a114+a134;
a114=a114+a029;
a134=casadi_fmax(a018,a114);
a141=casadi_sq(a134);
a142=a134*a141;
a142=a067*a142;
a143=a029*a134;
a143=a048-a143;
a144=a142*a143;
a140=a140-a144;
a140=a029*a140;
a144=arg[2]? arg[2][13] : 0;
a145=a140*a144;
a146=a145*a023;
a147=arg[2]? arg[2][14] : 0;
a148=a146*a147;
a149=a148*a131;
a113=a113-a149;
a150=arg[2]? arg[2][22] : 0;
a032=a150+a032;
a151=-a032;
a152=arg[2]? arg[2][20] : 0;
a153=arg[2]? arg[2][21] : 0;
a154=a153*a038;
a152=a152+a154;
a154=casadi_fmin(a032,a152);
a155=casadi_fmax(a151,a154);
a156=a068*a150;
a157=a070*a155;
a156=a156-a157;
a156=a156+a029;
a157=casadi_fmax(a018,a156);
a158=casadi_sq(a157);
a159=a157*a158;
a159=a067*a159;
a160=a029*a157;
a160=a048-a160;
a161=a159*a160;
a161=a155+a161;
a150=a068*a150;
a155=a070*a155;
a150=a150+a155;
a150=a150+a029;
a155=casadi_fmax(a018,a150);
a162=casadi_sq(a155);
a163=a155*a162;
a163=a067*a163;
a164=a029*a155;
a164=a048-a164;
a165=a163*a164;
a161=a161-a165;
a165=arg[2]? arg[2][15] : 0;
a166=a029*a165;
a012=a002-a012;
a167=casadi_sq(a012);
a168=1.0000000000000000e-08;
a167=a167+a168;
a046=a004-a046;
a168=casadi_sq(a046);
a168=a167+a168;
a169=a166*a168;
a170=a169*a023;
a171=a161*a170;
a172=a171*a012;
a173=sqrt(a167);
a172=a172/a173;
a113=a113-a172;
a174=arg[2]? arg[2][0] : 0;
a175=cos(a038);
a176=a174*a175;
a177=arg[2]? arg[2][4] : 0;
a178=sin(a038);
a179=a177*a178;
a180=a176+a179;
a181=a113*a180;
a182=arg[2]? arg[2][28] : 0;
a183=cos(a038);
a184=a182*a183;
a185=arg[2]? arg[2][29] : 0;
a186=sin(a038);
a187=a185*a186;
a188=a184+a187;
a189=a149*a188;
a190=arg[2]? arg[2][19] : 0;
a191=a190*a170;
a192=arg[2]? arg[2][16] : 0;
a193=arg[2]? arg[2][17] : 0;
a194=a193*a038;
a192=a192+a194;
a194=arg[2]? arg[2][18] : 0;
a195=a194*a118;
a192=a192+a195;
a195=a191*a192;
a189=a189+a195;
a195=arg[2]? arg[2][31] : 0;
a196=a020*a195;
a197=cos(a038);
a198=a196*a197;
a189=a189+a198;
a181=a181+a189;
a198=a071+a069;
a198=a176-a198;
a198=a198+a179;
a181=a181/a198;
a199=casadi_fmax(a018,a181);
a200=a111*a199;
a110=a110+a200;
a200=casadi_fmax(a109,a110);
a201=a108*a200;
a107=a107/a201;
a202=5.0000000000000004e-06;
a203=a107+a202;
a204=a106<=a203;
a205=a203<=a106;
a206=a205+a204;
a204=a204/a206;
a207=-a203;
a203=casadi_fmin(a203,a106);
a208=a207<=a203;
a209=a203<=a207;
a210=a209+a208;
a208=a208/a210;
a211=100000.;
a212=-100000.;
a213=a212*a107;
a207=casadi_fmax(a207,a203);
a203=a211*a207;
a213=a213+a203;
a213=a213+a029;
a203=a018<=a213;
a214=a213<=a018;
a214=a214+a203;
a203=a203/a214;
a214=1.0000000000000001e-05;
a213=casadi_fmax(a018,a213);
a215=casadi_sq(a213);
a216=a213*a215;
a216=a214*a216;
a217=sin(a052);
a218=sin(a038);
a219=a093*a218;
a220=a219*a085;
a221=cos(a038);
a221=a221*a085;
a222=a074*a221;
a220=a220-a222;
a222=a071+a069;
a222=a222*a088;
a220=a220-a222;
a220=a220-a091;
a222=a217*a220;
a223=cos(a052);
a224=arg[4]? arg[4][35] : 0;
a219=a219*a224;
a225=cos(a038);
a225=a225*a224;
a226=a074*a225;
a219=a219-a226;
a226=arg[4]? arg[4][31] : 0;
a227=a226/a090;
a228=arg[4]? arg[4][28] : 0;
a227=a227+a228;
a219=a219+a227;
a228=a223*a219;
a222=a222-a228;
a228=arg[4]? arg[4][10] : 0;
a222=a222+a228;
a228=a201*a222;
a229=a199*a228;
a230=a212*a107;
a231=a211*a207;
a230=a230-a231;
a230=a230+a029;
a231=casadi_fmax(a018,a230);
a232=casadi_sq(a231);
a233=a231*a232;
a233=a214*a233;
a234=a029*a231;
a234=a048-a234;
a235=a233*a234;
a207=a207+a235;
a235=a029*a213;
a235=a048-a235;
a236=a216*a235;
a207=a207-a236;
a236=2.*a207;
a237=casadi_sq(a207);
a237=a048-a237;
a237=sqrt(a237);
a238=a212*a237;
a239=a237+a202;
a240=-a239;
a241=arg[2]? arg[2][54] : 0;
a242=arg[2]? arg[2][53] : 0;
a243=arg[2]? arg[2][51] : 0;
a244=arg[2]? arg[2][52] : 0;
a245=a244-a048;
a246=casadi_fmax(a003,a245);
a246=sqrt(a246);
a247=a243*a246;
a248=1./a247;
a249=-a248;
a250=arg[2]? arg[2][46] : 0;
a251=arg[2]? arg[2][47] : 0;
a252=a251*a199;
a250=a250+a252;
a252=casadi_fmax(a018,a250);
a253=casadi_sq(a055);
a254=casadi_sq(a098);
a254=a017*a254;
a253=a253+a254;
a255=sqrt(a253);
a256=a103/a255;
a257=a252*a256;
a257=a257/a201;
a258=casadi_fmin(a257,a248);
a259=casadi_fmax(a249,a258);
a260=a243*a259;
a261=atan(a260);
a262=a244*a261;
a262=a262/a243;
a263=a244-a048;
a264=a259*a263;
a264=a262-a264;
a265=a243*a264;
a266=atan(a265);
a267=a242*a266;
a268=sin(a267);
a269=a241*a268;
a270=casadi_sq(a103);
a270=a270+a253;
a270=sqrt(a270);
a253=a269*a270;
a253=a253/a105;
a271=casadi_fmin(a253,a239);
a272=casadi_fmax(a240,a271);
a273=a211*a272;
a238=a238+a273;
a238=a238+a029;
a273=a018<=a238;
a274=a238<=a018;
a274=a274+a273;
a273=a273/a274;
a238=casadi_fmax(a018,a238);
a274=casadi_sq(a238);
a275=a238*a274;
a275=a214*a275;
a016=a048-a016;
a276=cos(a052);
a277=a276*a220;
a278=sin(a052);
a279=a278*a219;
a277=a277+a279;
a279=arg[4]? arg[4][11] : 0;
a277=a277+a279;
a279=a016*a277;
a280=a201*a279;
a281=a199*a280;
a282=a275*a281;
a282=a029*a282;
a283=a029*a238;
a283=a048-a283;
a284=a283*a281;
a284=a214*a284;
a274=a274*a284;
a282=a282-a274;
a274=2.*a238;
a238=a238*a284;
a274=a274*a238;
a282=a282-a274;
a273=a273*a282;
a282=a212*a273;
a274=a212*a237;
a238=a211*a272;
a274=a274-a238;
a274=a274+a029;
a238=a018<=a274;
a284=a274<=a018;
a284=a284+a238;
a238=a238/a284;
a274=casadi_fmax(a018,a274);
a284=casadi_sq(a274);
a285=a029*a274;
a285=a048-a285;
a286=a285*a281;
a286=a214*a286;
a287=a284*a286;
a284=a274*a284;
a284=a214*a284;
a288=a284*a281;
a288=a029*a288;
a287=a287-a288;
a288=2.*a274;
a274=a274*a286;
a288=a288*a274;
a287=a287+a288;
a238=a238*a287;
a287=a212*a238;
a282=a282+a287;
a287=a239<=a253;
a239=a253<=a239;
a288=a239+a287;
a287=a287/a288;
a274=a240<=a271;
a271=a271<=a240;
a240=a271+a274;
a274=a274/a240;
a273=a211*a273;
a273=a273+a281;
a238=a211*a238;
a273=a273-a238;
a274=a274*a273;
a287=a287*a274;
a271=a271/a240;
a271=a271*a273;
a287=a287-a271;
a282=a282+a287;
a237=2.*a237;
a282=a282/a237;
a236=a236*a282;
a229=a229-a236;
a216=a216*a229;
a216=a029*a216;
a235=a235*a229;
a235=a214*a235;
a215=a215*a235;
a216=a216-a215;
a215=2.*a213;
a213=a213*a235;
a215=a215*a213;
a216=a216-a215;
a203=a203*a216;
a216=a211*a203;
a216=a216+a229;
a215=a018<=a230;
a230=a230<=a018;
a230=a230+a215;
a215=a215/a230;
a234=a234*a229;
a234=a214*a234;
a232=a232*a234;
a233=a233*a229;
a233=a029*a233;
a232=a232-a233;
a233=2.*a231;
a231=a231*a234;
a233=a233*a231;
a232=a232+a233;
a215=a215*a232;
a232=a211*a215;
a216=a216-a232;
a208=a208*a216;
a204=a204*a208;
a232=a204/a105;
a233=2.*a055;
a101=2.*a101;
a253=a253/a105;
a239=a239/a288;
a239=a239*a274;
a253=a253*a239;
a106=a106/a105;
a106=a106*a204;
a253=a253+a106;
a106=2.*a105;
a253=a253/a106;
a100=2.*a100;
a253=a253/a100;
a101=a101*a253;
a233=a233*a101;
a232=a232-a233;
a055=2.*a055;
a239=a239/a105;
a269=a269*a239;
a105=2.*a270;
a269=a269/a105;
a105=a256/a255;
a233=a257<=a248;
a100=a248<=a257;
a106=a233+a100;
a233=a233/a106;
a204=a249<=a258;
a258=a258<=a249;
a249=a258+a204;
a204=a204/a249;
a267=cos(a267);
a270=a270*a239;
a241=a241*a270;
a267=a267*a241;
a242=a242*a267;
a265=casadi_sq(a265);
a265=a048+a265;
a242=a242/a265;
a244=a244*a242;
a260=casadi_sq(a260);
a260=a048+a260;
a244=a244/a260;
a260=a243*a244;
a265=a243*a242;
a263=a263*a265;
a260=a260-a263;
a204=a204*a260;
a233=a233*a204;
a263=a233/a201;
a252=a252*a263;
a241=arg[4]? arg[4][9] : 0;
a239=casadi_sq(a256);
a239=a048+a239;
a241=a241/a239;
a252=a252+a241;
a105=a105*a252;
a241=2.*a255;
a105=a105/a241;
a105=a269-a105;
a055=a055*a105;
a232=a232+a055;
a051=a051*a232;
a001=a001+a051;
a051=2.*a103;
a051=a051*a269;
a103=2.*a103;
a103=a103*a101;
a051=a051-a103;
a252=a252/a255;
a051=a051+a252;
a104=a104*a051;
a001=a001-a104;
a104=arg[2]? arg[2][2] : 0;
a252=cos(a104);
a255=a029*a036;
a103=arg[2]? arg[2][3] : 0;
a101=a255*a103;
a269=a002-a101;
a055=a269*a252;
a241=a176+a179;
a239=a036*a241;
a239=a239+a004;
a274=sin(a104);
a288=a239*a274;
a055=a055-a288;
a231=casadi_sq(a098);
a234=casadi_sq(a231);
a229=casadi_sq(a055);
a230=cos(a104);
a213=a239*a230;
a235=a002-a101;
a236=sin(a104);
a282=a235*a236;
a213=a213+a282;
a282=casadi_sq(a213);
a229=a229+a282;
a282=casadi_sq(a229);
a234=a234+a282;
a234=sqrt(a234);
a282=sqrt(a234);
a237=a055/a282;
a287=arg[1]? arg[1][5] : 0;
a271=arg[2]? arg[2][42] : 0;
a273=arg[2]? arg[2][34] : 0;
a240=arg[2]? arg[2][35] : 0;
a071=a071+a069;
a069=a113*a071;
a069=a069+a189;
a069=a029*a069;
a069=a069/a198;
a189=-a069;
a238=casadi_fmax(a018,a189);
a281=a240*a238;
a281=a273+a281;
a286=casadi_fmax(a109,a281);
a289=a271*a286;
a290=arg[2]? arg[2][43] : 0;
a291=a289-a290;
a292=a287*a291;
a292=a292+a290;
a292=a292/a289;
a290=a292+a202;
a293=a237<=a290;
a294=a290<=a237;
a295=a294+a293;
a293=a293/a295;
a296=-a290;
a290=casadi_fmin(a290,a237);
a297=a296<=a290;
a298=a290<=a296;
a299=a298+a297;
a297=a297/a299;
a300=a212*a292;
a296=casadi_fmax(a296,a290);
a290=a211*a296;
a300=a300+a290;
a300=a300+a029;
a290=a018<=a300;
a301=a300<=a018;
a301=a301+a290;
a290=a290/a301;
a300=casadi_fmax(a018,a300);
a301=casadi_sq(a300);
a302=a300*a301;
a302=a214*a302;
a303=sin(a104);
a304=cos(a038);
a304=a304*a085;
a305=a177*a304;
a306=sin(a038);
a307=a174*a306;
a308=a307*a085;
a305=a305-a308;
a308=a176+a179;
a308=a308*a088;
a305=a305+a308;
a305=a305+a091;
a308=a303*a305;
a309=cos(a104);
a310=cos(a038);
a311=a177*a310;
a312=a311*a224;
a313=a307*a224;
a312=a312-a313;
a313=a103*a088;
a313=a029*a313;
a312=a312+a313;
a312=a312-a227;
a313=a309*a312;
a308=a308+a313;
a313=arg[4]? arg[4][6] : 0;
a308=a308+a313;
a313=a289*a308;
a314=a238*a313;
a315=a212*a292;
a316=a211*a296;
a315=a315-a316;
a315=a315+a029;
a316=casadi_fmax(a018,a315);
a317=casadi_sq(a316);
a318=a316*a317;
a318=a214*a318;
a319=a029*a316;
a319=a048-a319;
a320=a318*a319;
a296=a296+a320;
a320=a029*a300;
a320=a048-a320;
a321=a302*a320;
a296=a296-a321;
a321=2.*a296;
a322=casadi_sq(a296);
a322=a048-a322;
a322=sqrt(a322);
a323=a212*a322;
a324=a322+a202;
a325=-a324;
a326=2.0000000000000000e-02;
a327=50.;
a328=a327*a287;
a329=arg[2]? arg[2][40] : 0;
a330=arg[2]? arg[2][39] : 0;
a331=arg[2]? arg[2][37] : 0;
a332=arg[2]? arg[2][38] : 0;
a333=a332-a048;
a334=casadi_fmax(a003,a333);
a334=sqrt(a334);
a335=a331*a334;
a336=1./a335;
a337=-a336;
a338=arg[2]? arg[2][32] : 0;
a339=arg[2]? arg[2][33] : 0;
a340=a339*a238;
a340=a338+a340;
a341=casadi_fmax(a018,a340);
a342=casadi_sq(a055);
a342=a342+a254;
a343=sqrt(a342);
a344=a213/a343;
a345=a341*a344;
a345=a345/a289;
a346=casadi_fmin(a345,a336);
a347=casadi_fmax(a337,a346);
a348=a048-a332;
a349=a347*a348;
a350=a331*a347;
a351=atan(a350);
a352=a332*a351;
a352=a352/a331;
a349=a349+a352;
a353=a331*a349;
a354=atan(a353);
a355=a330*a354;
a356=sin(a355);
a357=a329*a356;
a358=casadi_sq(a213);
a358=a358+a342;
a358=sqrt(a358);
a342=a357*a358;
a359=a213*a342;
a359=a359/a234;
a360=a359+a003;
a361=casadi_sq(a213);
a361=a361/a234;
a362=4.9999999999999999e-13;
a363=a361+a362;
a360=a360/a363;
a364=a327*a360;
a328=a328-a364;
a364=casadi_fmin(a048,a328);
a365=casadi_fmax(a018,a364);
a366=casadi_sq(a365);
a367=a365*a366;
a367=a326*a367;
a368=casadi_sq(a365);
a368=a054*a368;
a369=a056*a365;
a368=a368-a369;
a368=a368+a057;
a369=a367*a368;
a370=a287-a360;
a370=a370-a326;
a371=casadi_fmax(a018,a370);
a369=a369+a371;
a371=a213*a369;
a371=a371/a282;
a372=a342/a282;
a373=a371+a372;
a374=casadi_fmin(a373,a324);
a375=casadi_fmax(a325,a374);
a376=a211*a375;
a323=a323+a376;
a323=a323+a029;
a376=a018<=a323;
a377=a323<=a018;
a377=a377+a376;
a376=a376/a377;
a323=casadi_fmax(a018,a323);
a377=casadi_sq(a323);
a378=a323*a377;
a378=a214*a378;
a379=sin(a104);
a380=a379*a312;
a381=cos(a104);
a382=a381*a305;
a380=a380-a382;
a382=arg[4]? arg[4][7] : 0;
a380=a380+a382;
a382=a289*a380;
a383=a238*a382;
a384=a378*a383;
a384=a029*a384;
a385=a029*a323;
a385=a048-a385;
a386=a385*a383;
a386=a214*a386;
a377=a377*a386;
a384=a384-a377;
a377=2.*a323;
a323=a323*a386;
a377=a377*a323;
a384=a384-a377;
a376=a376*a384;
a384=a212*a376;
a377=a212*a322;
a323=a211*a375;
a377=a377-a323;
a377=a377+a029;
a323=a018<=a377;
a386=a377<=a018;
a386=a386+a323;
a323=a323/a386;
a377=casadi_fmax(a018,a377);
a386=casadi_sq(a377);
a387=a029*a377;
a387=a048-a387;
a388=a387*a383;
a388=a214*a388;
a389=a386*a388;
a386=a377*a386;
a386=a214*a386;
a390=a386*a383;
a390=a029*a390;
a389=a389-a390;
a390=2.*a377;
a377=a377*a388;
a390=a390*a377;
a389=a389+a390;
a323=a323*a389;
a389=a212*a323;
a384=a384+a389;
a389=a324<=a373;
a373=a373<=a324;
a324=a373+a389;
a389=a389/a324;
a390=a325<=a374;
a374=a374<=a325;
a325=a374+a390;
a390=a390/a325;
a376=a211*a376;
a376=a376+a383;
a323=a211*a323;
a376=a376-a323;
a390=a390*a376;
a389=a389*a390;
a374=a374/a325;
a374=a374*a376;
a389=a389-a374;
a384=a384+a389;
a322=2.*a322;
a384=a384/a322;
a321=a321*a384;
a314=a314-a321;
a302=a302*a314;
a302=a029*a302;
a320=a320*a314;
a320=a214*a320;
a301=a301*a320;
a302=a302-a301;
a301=2.*a300;
a300=a300*a320;
a301=a301*a300;
a302=a302-a301;
a290=a290*a302;
a302=a211*a290;
a302=a302+a314;
a301=a018<=a315;
a315=a315<=a018;
a315=a315+a301;
a301=a301/a315;
a319=a319*a314;
a319=a214*a319;
a317=a317*a319;
a318=a318*a314;
a318=a029*a318;
a317=a317-a318;
a318=2.*a316;
a316=a316*a319;
a318=a318*a316;
a317=a317+a318;
a301=a301*a317;
a317=a211*a301;
a302=a302-a317;
a297=a297*a302;
a293=a293*a297;
a317=a293/a282;
a318=2.*a055;
a229=2.*a229;
a359=a359/a234;
a316=a018<=a370;
a370=a370<=a018;
a370=a370+a316;
a316=a316/a370;
a373=a373/a324;
a373=a373*a390;
a390=a373/a282;
a324=a213*a390;
a316=a316*a324;
a370=a328<=a048;
a328=a048<=a328;
a328=a328+a370;
a370=a370/a328;
a328=a018<=a364;
a364=a364<=a018;
a364=a364+a328;
a328=a328/a364;
a364=2.*a365;
a367=a367*a324;
a319=a054*a367;
a364=a364*a319;
a367=a056*a367;
a364=a364-a367;
a368=a368*a324;
a368=a326*a368;
a366=a366*a368;
a364=a364+a366;
a366=2.*a365;
a365=a365*a368;
a366=a366*a365;
a364=a364+a366;
a328=a328*a364;
a370=a370*a328;
a328=a327*a370;
a328=a316+a328;
a364=a328/a363;
a359=a359*a364;
a361=a361/a234;
a360=a360/a363;
a360=a360*a328;
a361=a361*a360;
a359=a359-a361;
a372=a372/a282;
a372=a372*a373;
a371=a371/a282;
a371=a371*a373;
a372=a372+a371;
a237=a237/a282;
a237=a237*a293;
a372=a372+a237;
a237=2.*a282;
a372=a372/a237;
a359=a359-a372;
a372=2.*a234;
a359=a359/a372;
a229=a229*a359;
a318=a318*a229;
a317=a317+a318;
a055=2.*a055;
a373=a373/a282;
a364=a364/a234;
a282=a213*a364;
a373=a373-a282;
a357=a357*a373;
a282=2.*a358;
a357=a357/a282;
a282=a344/a343;
a318=a345<=a336;
a372=a336<=a345;
a237=a318+a372;
a318=a318/a237;
a293=a337<=a346;
a346=a346<=a337;
a337=a346+a293;
a293=a293/a337;
a355=cos(a355);
a358=a358*a373;
a373=a329*a358;
a355=a355*a373;
a373=a330*a355;
a353=casadi_sq(a353);
a353=a048+a353;
a373=a373/a353;
a353=a332*a373;
a350=casadi_sq(a350);
a350=a048+a350;
a353=a353/a350;
a350=a331*a353;
a371=a331*a373;
a348=a348*a371;
a350=a350+a348;
a293=a293*a350;
a318=a318*a293;
a348=a318/a289;
a341=a341*a348;
a361=arg[4]? arg[4][5] : 0;
a328=casadi_sq(a344);
a328=a048+a328;
a361=a361/a328;
a341=a341+a361;
a282=a282*a341;
a361=2.*a343;
a282=a282/a361;
a282=a357-a282;
a055=a055*a282;
a317=a317+a055;
a252=a252*a317;
a001=a001+a252;
a369=a369*a390;
a390=2.*a213;
a360=a360/a234;
a390=a390*a360;
a369=a369+a390;
a342=a342*a364;
a369=a369-a342;
a342=2.*a213;
a342=a342*a357;
a369=a369+a342;
a213=2.*a213;
a213=a213*a229;
a369=a369+a213;
a341=a341/a343;
a369=a369+a341;
a236=a236*a369;
a001=a001+a236;
a341=cos(a104);
a343=a002+a101;
a213=a343*a341;
a288=a288+a213;
a213=casadi_sq(a098);
a229=casadi_sq(a213);
a342=casadi_sq(a288);
a357=cos(a104);
a364=a239*a357;
a101=a002+a101;
a390=sin(a104);
a360=a101*a390;
a364=a364-a360;
a360=casadi_sq(a364);
a342=a342+a360;
a360=casadi_sq(a342);
a229=a229+a360;
a229=sqrt(a229);
a360=sqrt(a229);
a234=a288/a360;
a055=arg[1]? arg[1][4] : 0;
a361=arg[2]? arg[2][36] : 0;
a328=a240*a238;
a273=a273+a328;
a328=casadi_fmax(a109,a273);
a363=a361*a328;
a366=arg[2]? arg[2][41] : 0;
a365=a363-a366;
a368=a055*a365;
a368=a368+a366;
a368=a368/a363;
a366=a368+a202;
a324=a234<=a366;
a367=a366<=a234;
a319=a367+a324;
a324=a324/a319;
a314=-a366;
a366=casadi_fmin(a366,a234);
a315=a314<=a366;
a300=a366<=a314;
a320=a300+a315;
a315=a315/a320;
a321=a212*a368;
a314=casadi_fmax(a314,a366);
a366=a211*a314;
a321=a321+a366;
a321=a321+a029;
a366=a018<=a321;
a384=a321<=a018;
a384=a384+a366;
a366=a366/a384;
a321=casadi_fmax(a018,a321);
a384=casadi_sq(a321);
a322=a321*a384;
a322=a214*a322;
a389=sin(a104);
a374=a307*a085;
a376=cos(a038);
a376=a376*a085;
a325=a177*a376;
a374=a374-a325;
a176=a176+a179;
a176=a176*a088;
a374=a374-a176;
a374=a374-a091;
a176=a389*a374;
a179=cos(a104);
a307=a307*a224;
a311=a311*a224;
a307=a307-a311;
a311=a103*a088;
a311=a029*a311;
a307=a307+a311;
a307=a307+a227;
a311=a179*a307;
a176=a176-a311;
a311=arg[4]? arg[4][2] : 0;
a176=a176+a311;
a311=a363*a176;
a325=a238*a311;
a323=a212*a368;
a383=a211*a314;
a323=a323-a383;
a323=a323+a029;
a383=casadi_fmax(a018,a323);
a377=casadi_sq(a383);
a388=a383*a377;
a388=a214*a388;
a391=a029*a383;
a391=a048-a391;
a392=a388*a391;
a314=a314+a392;
a392=a029*a321;
a392=a048-a392;
a393=a322*a392;
a314=a314-a393;
a393=2.*a314;
a394=casadi_sq(a314);
a394=a048-a394;
a394=sqrt(a394);
a395=a212*a394;
a202=a394+a202;
a396=-a202;
a397=a327*a055;
a398=-a336;
a399=a339*a238;
a338=a338+a399;
a399=casadi_fmax(a018,a338);
a400=casadi_sq(a288);
a400=a400+a254;
a254=sqrt(a400);
a401=a364/a254;
a402=a399*a401;
a402=a402/a363;
a403=casadi_fmin(a402,a336);
a404=casadi_fmax(a398,a403);
a405=a048-a332;
a406=a404*a405;
a407=a331*a404;
a408=atan(a407);
a409=a332*a408;
a409=a409/a331;
a406=a406+a409;
a410=a331*a406;
a411=atan(a410);
a412=a330*a411;
a413=sin(a412);
a414=a329*a413;
a415=casadi_sq(a364);
a415=a415+a400;
a415=sqrt(a415);
a400=a414*a415;
a416=a364*a400;
a416=a416/a229;
a417=a416+a003;
a418=casadi_sq(a364);
a418=a418/a229;
a362=a418+a362;
a417=a417/a362;
a419=a327*a417;
a397=a397-a419;
a419=casadi_fmin(a048,a397);
a420=casadi_fmax(a018,a419);
a421=casadi_sq(a420);
a422=a420*a421;
a422=a326*a422;
a423=casadi_sq(a420);
a423=a054*a423;
a424=a056*a420;
a423=a423-a424;
a423=a423+a057;
a057=a422*a423;
a424=a055-a417;
a424=a424-a326;
a425=casadi_fmax(a018,a424);
a057=a057+a425;
a425=a364*a057;
a425=a425/a360;
a426=a400/a360;
a427=a425+a426;
a428=casadi_fmin(a427,a202);
a429=casadi_fmax(a396,a428);
a430=a211*a429;
a395=a395+a430;
a395=a395+a029;
a430=a018<=a395;
a431=a395<=a018;
a431=a431+a430;
a430=a430/a431;
a395=casadi_fmax(a018,a395);
a431=casadi_sq(a395);
a432=a395*a431;
a432=a214*a432;
a433=cos(a104);
a434=a433*a374;
a435=sin(a104);
a436=a435*a307;
a434=a434+a436;
a436=arg[4]? arg[4][3] : 0;
a434=a434+a436;
a436=a363*a434;
a437=a238*a436;
a438=a432*a437;
a438=a029*a438;
a439=a029*a395;
a439=a048-a439;
a440=a439*a437;
a440=a214*a440;
a431=a431*a440;
a438=a438-a431;
a431=2.*a395;
a395=a395*a440;
a431=a431*a395;
a438=a438-a431;
a430=a430*a438;
a438=a212*a430;
a431=a212*a394;
a395=a211*a429;
a431=a431-a395;
a431=a431+a029;
a395=a018<=a431;
a440=a431<=a018;
a440=a440+a395;
a395=a395/a440;
a431=casadi_fmax(a018,a431);
a440=casadi_sq(a431);
a441=a029*a431;
a441=a048-a441;
a442=a441*a437;
a442=a214*a442;
a443=a440*a442;
a440=a431*a440;
a440=a214*a440;
a444=a440*a437;
a444=a029*a444;
a443=a443-a444;
a444=2.*a431;
a431=a431*a442;
a444=a444*a431;
a443=a443+a444;
a395=a395*a443;
a443=a212*a395;
a438=a438+a443;
a443=a202<=a427;
a427=a427<=a202;
a202=a427+a443;
a443=a443/a202;
a444=a396<=a428;
a428=a428<=a396;
a396=a428+a444;
a444=a444/a396;
a430=a211*a430;
a430=a430+a437;
a395=a211*a395;
a430=a430-a395;
a444=a444*a430;
a443=a443*a444;
a428=a428/a396;
a428=a428*a430;
a443=a443-a428;
a438=a438+a443;
a394=2.*a394;
a438=a438/a394;
a393=a393*a438;
a325=a325-a393;
a322=a322*a325;
a322=a029*a322;
a392=a392*a325;
a392=a214*a392;
a384=a384*a392;
a322=a322-a384;
a384=2.*a321;
a321=a321*a392;
a384=a384*a321;
a322=a322-a384;
a366=a366*a322;
a322=a211*a366;
a322=a322+a325;
a384=a018<=a323;
a323=a323<=a018;
a323=a323+a384;
a384=a384/a323;
a391=a391*a325;
a214=a214*a391;
a377=a377*a214;
a388=a388*a325;
a388=a029*a388;
a377=a377-a388;
a388=2.*a383;
a383=a383*a214;
a388=a388*a383;
a377=a377+a388;
a384=a384*a377;
a211=a211*a384;
a322=a322-a211;
a315=a315*a322;
a324=a324*a315;
a211=a324/a360;
a377=2.*a288;
a342=2.*a342;
a416=a416/a229;
a388=a018<=a424;
a424=a424<=a018;
a424=a424+a388;
a388=a388/a424;
a427=a427/a202;
a427=a427*a444;
a444=a427/a360;
a202=a364*a444;
a388=a388*a202;
a424=a397<=a048;
a397=a048<=a397;
a397=a397+a424;
a424=a424/a397;
a397=a018<=a419;
a419=a419<=a018;
a419=a419+a397;
a397=a397/a419;
a419=2.*a420;
a422=a422*a202;
a383=a054*a422;
a419=a419*a383;
a422=a056*a422;
a419=a419-a422;
a423=a423*a202;
a326=a326*a423;
a421=a421*a326;
a419=a419+a421;
a421=2.*a420;
a420=a420*a326;
a421=a421*a420;
a419=a419+a421;
a397=a397*a419;
a424=a424*a397;
a397=a327*a424;
a397=a388+a397;
a419=a397/a362;
a416=a416*a419;
a418=a418/a229;
a417=a417/a362;
a417=a417*a397;
a418=a418*a417;
a416=a416-a418;
a426=a426/a360;
a426=a426*a427;
a425=a425/a360;
a425=a425*a427;
a426=a426+a425;
a234=a234/a360;
a234=a234*a324;
a426=a426+a234;
a234=2.*a360;
a426=a426/a234;
a416=a416-a426;
a426=2.*a229;
a416=a416/a426;
a342=a342*a416;
a377=a377*a342;
a211=a211+a377;
a288=2.*a288;
a427=a427/a360;
a419=a419/a229;
a360=a364*a419;
a427=a427-a360;
a414=a414*a427;
a360=2.*a415;
a414=a414/a360;
a360=a401/a254;
a377=a402<=a336;
a426=a336<=a402;
a234=a377+a426;
a377=a377/a234;
a324=a398<=a403;
a403=a403<=a398;
a398=a403+a324;
a324=a324/a398;
a412=cos(a412);
a415=a415*a427;
a329=a329*a415;
a412=a412*a329;
a330=a330*a412;
a410=casadi_sq(a410);
a410=a048+a410;
a330=a330/a410;
a332=a332*a330;
a407=casadi_sq(a407);
a407=a048+a407;
a332=a332/a407;
a407=a331*a332;
a410=a331*a330;
a405=a405*a410;
a407=a407+a405;
a324=a324*a407;
a377=a377*a324;
a405=a377/a363;
a399=a399*a405;
a329=arg[4]? arg[4][1] : 0;
a427=casadi_sq(a401);
a427=a048+a427;
a329=a329/a427;
a399=a399+a329;
a360=a360*a399;
a329=2.*a254;
a360=a360/a329;
a360=a414-a360;
a288=a288*a360;
a211=a211+a288;
a341=a341*a211;
a001=a001+a341;
a057=a057*a444;
a444=2.*a364;
a417=a417/a229;
a444=a444*a417;
a057=a057+a444;
a400=a400*a419;
a057=a057-a400;
a400=2.*a364;
a400=a400*a414;
a057=a057+a400;
a364=2.*a364;
a364=a364*a342;
a057=a057+a364;
a399=a399/a254;
a057=a057+a399;
a390=a390*a057;
a001=a001-a390;
a399=2.*a012;
a254=arg[2]? arg[2][23] : 0;
a364=casadi_sq(a161);
a342=arg[2]? arg[2][24] : 0;
a400=a364*a342;
a254=a254+a400;
a400=a254*a170;
a414=a400*a012;
a414=a414/a173;
a419=a414/a173;
a419=a419*a227;
a444=casadi_sq(a046);
a444=a444+a167;
a167=a046/a444;
a417=arg[2]? arg[2][65] : 0;
a229=arg[2]? arg[2][60] : 0;
a288=a229*a170;
a329=arg[4]? arg[4][20] : 0;
a329=a088+a329;
a288=a288*a329;
a427=a417*a288;
a425=arg[2]? arg[2][62] : 0;
a418=a229*a170;
a397=arg[4]? arg[4][18] : 0;
a397=a397-a085;
a418=a418*a397;
a362=a425*a418;
a427=a427+a362;
a362=arg[2]? arg[2][57] : 0;
a421=arg[4]? arg[4][17] : 0;
a421=a091+a421;
a420=a170*a421;
a326=a362*a420;
a427=a427+a326;
a326=arg[4]? arg[4][13] : 0;
a427=a427+a326;
a167=a167*a427;
a419=a419-a167;
a172=a172/a173;
a167=arg[4]? arg[4][33] : 0;
a326=a018<=a181;
a423=a181<=a018;
a423=a423+a326;
a326=a326/a423;
a284=a284*a285;
a272=a272+a284;
a275=a275*a283;
a272=a272-a275;
a280=a272*a280;
a275=a018<=a250;
a250=a250<=a018;
a250=a250+a275;
a275=a275/a250;
a256=a256*a263;
a275=a275*a256;
a251=a251*a275;
a280=a280+a251;
a228=a207*a228;
a280=a280+a228;
a228=a109<=a110;
a110=a110<=a109;
a110=a110+a228;
a228=a228/a110;
a272=a199*a272;
a279=a272*a279;
a257=a257/a201;
a257=a257*a233;
a279=a279-a257;
a207=a199*a207;
a222=a207*a222;
a279=a279+a222;
a107=a107/a201;
a203=a212*a203;
a215=a212*a215;
a203=a203+a215;
a205=a205/a206;
a205=a205*a208;
a209=a209/a210;
a209=a209*a216;
a205=a205-a209;
a203=a203+a205;
a107=a107*a203;
a279=a279-a107;
a108=a108*a279;
a228=a228*a108;
a111=a111*a228;
a280=a280+a111;
a111=arg[4]? arg[4][8] : 0;
a280=a280+a111;
a326=a326*a280;
a280=a326/a198;
a180=a180*a280;
a111=a018<=a189;
a189=a189<=a018;
a189=a189+a111;
a111=a111/a189;
a386=a386*a387;
a375=a375+a386;
a378=a378*a385;
a375=a375-a378;
a382=a375*a382;
a378=a018<=a340;
a340=a340<=a018;
a340=a340+a378;
a378=a378/a340;
a344=a344*a348;
a378=a378*a344;
a344=a339*a378;
a382=a382+a344;
a313=a296*a313;
a382=a382+a313;
a313=a109<=a281;
a281=a281<=a109;
a281=a281+a313;
a313=a313/a281;
a375=a238*a375;
a380=a375*a380;
a345=a345/a289;
a345=a345*a318;
a380=a380-a345;
a296=a238*a296;
a308=a296*a308;
a380=a380+a308;
a292=a292/a289;
a290=a212*a290;
a301=a212*a301;
a290=a290+a301;
a294=a294/a295;
a294=a294*a297;
a298=a298/a299;
a298=a298*a302;
a294=a294-a298;
a290=a290+a294;
a292=a292*a290;
a380=a380-a292;
a290=a290/a289;
a287=a287*a290;
a380=a380+a287;
a271=a271*a380;
a313=a313*a271;
a271=a240*a313;
a382=a382+a271;
a271=arg[4]? arg[4][4] : 0;
a382=a382+a271;
a440=a440*a441;
a429=a429+a440;
a432=a432*a439;
a429=a429-a432;
a436=a429*a436;
a382=a382+a436;
a436=a018<=a338;
a338=a338<=a018;
a338=a338+a436;
a436=a436/a338;
a401=a401*a405;
a436=a436*a401;
a339=a339*a436;
a382=a382+a339;
a311=a314*a311;
a382=a382+a311;
a311=a109<=a273;
a273=a273<=a109;
a273=a273+a311;
a311=a311/a273;
a429=a238*a429;
a434=a429*a434;
a402=a402/a363;
a402=a402*a377;
a434=a434-a402;
a314=a238*a314;
a176=a314*a176;
a434=a434+a176;
a368=a368/a363;
a366=a212*a366;
a212=a212*a384;
a366=a366+a212;
a367=a367/a319;
a367=a367*a315;
a300=a300/a320;
a300=a300*a322;
a367=a367-a300;
a366=a366+a367;
a368=a368*a366;
a434=a434-a368;
a366=a366/a363;
a055=a055*a366;
a434=a434+a055;
a361=a361*a434;
a311=a311*a361;
a240=a240*a311;
a382=a382+a240;
a240=arg[4]? arg[4][0] : 0;
a382=a382+a240;
a111=a111*a382;
a382=a111/a198;
a382=a029*a382;
a071=a071*a382;
a180=a180-a071;
a071=a167+a180;
a172=a172*a071;
a419=a419+a172;
a172=2.*a173;
a419=a419/a172;
a172=2.5000000000000000e-01;
a165=a172*a165;
a240=casadi_sq(a229);
a361=arg[2]? arg[2][66] : 0;
a361=a361*a329;
a368=arg[2]? arg[2][63] : 0;
a368=a368*a397;
a361=a361+a368;
a368=a240*a361;
a367=arg[2]? arg[2][58] : 0;
a300=a367*a229;
a322=a300*a421;
a368=a368+a322;
a322=a023*a368;
a320=a036*a322;
a315=a165*a320;
a319=sqrt(a168);
a212=2.*a319;
a315=a315/a212;
a212=arg[2]? arg[2][64] : 0;
a384=arg[1]? arg[1][9] : 0;
a176=a212*a384;
a402=atan2(a046,a173);
a417=a417*a402;
a176=a176+a417;
a417=arg[2]? arg[2][67] : 0;
a377=a417*a060;
a176=a176+a377;
a176=a176*a329;
a377=a229*a176;
a273=arg[2]? arg[2][61] : 0;
a109=a273*a384;
a425=a425*a402;
a109=a109+a425;
a109=a109*a397;
a425=a229*a109;
a377=a377+a425;
a362=a362*a402;
a425=arg[2]? arg[2][59] : 0;
a339=a425*a060;
a362=a362+a339;
a339=a362*a421;
a377=a377+a339;
a339=arg[4]? arg[4][16] : 0;
a401=a227/a173;
a405=a012*a401;
a339=a339-a405;
a254=a254*a339;
a377=a377+a254;
a254=arg[4]? arg[4][19] : 0;
a254=a254-a224;
a405=a280-a382;
a254=a254+a405;
a192=a192*a254;
a190=a190*a192;
a377=a377+a190;
a190=arg[4]? arg[4][15] : 0;
a071=a071/a173;
a012=a012*a071;
a190=a190-a012;
a012=a161*a190;
a377=a377+a012;
a012=a023*a377;
a166=a166*a012;
a315=a315+a166;
a419=a419+a315;
a399=a399*a419;
a400=a400*a401;
a171=a171*a071;
a400=a400+a171;
a399=a399-a400;
a001=a001+a399;
a400=a018<=a026;
a026=a026<=a018;
a026=a026+a400;
a400=a400/a026;
a026=arg[4]? arg[4][26] : 0;
a187=a187*a224;
a184=a184*a224;
a187=a187+a184;
a187=a187+a167;
a026=a026-a187;
a188=a188*a405;
a026=a026+a188;
a026=a026-a180;
a148=a148*a026;
a400=a400*a148;
a188=a125<=a048;
a048=a048<=a125;
a048=a048+a188;
a188=a188/a048;
a048=a018<=a126;
a126=a126<=a018;
a126=a126+a048;
a048=a048/a126;
a126=2.*a127;
a129=a129*a148;
a054=a054*a129;
a126=a126*a054;
a056=a056*a129;
a126=a126-a056;
a130=a130*a148;
a130=a017*a130;
a128=a128*a130;
a126=a126+a128;
a128=2.*a127;
a127=a127*a130;
a128=a128*a127;
a126=a126+a128;
a048=a048*a126;
a188=a188*a048;
a049=a049*a188;
a400=a400+a049;
a049=a123*a400;
a188=2.*a122;
a122=a122*a400;
a123=2.*a123;
a122=a122/a123;
a188=a188*a122;
a049=a049+a188;
a001=a001+a049;
if (res[0]!=0) res[0][0]=a001;
a011=a011*a010;
a005=a005*a006;
a011=a011-a005;
a044=2.*a044;
a044=a044*a086;
a027=a027/a092;
a027=a027*a072;
a044=a044+a027;
a011=a011+a044;
a097=a097*a232;
a102=a102*a051;
a097=a097+a102;
a011=a011+a097;
a230=a230*a369;
a102=a211-a317;
a274=a274*a102;
a230=a230+a274;
a357=a357*a057;
a230=a230+a357;
a011=a011+a230;
a173=a173/a444;
a173=a173*a427;
a046=2.*a046;
a046=a046*a315;
a173=a173+a046;
a011=a011+a173;
if (res[0]!=0) res[0][1]=a011;
a040=a040*a044;
a165=a165*a319;
a322=a165*a322;
a040=a040+a322;
a066=a066*a097;
a040=a040+a066;
a252=a252+a236;
a341=a341-a252;
a341=a341-a390;
a103=a103*a341;
a103=a029*a103;
a040=a040+a103;
a241=a241*a230;
a040=a040+a241;
if (res[0]!=0) res[0][2]=a040;
if (res[0]!=0) res[0][3]=a018;
a040=arg[0]? arg[0][4] : 0;
a040=casadi_sign(a040);
a241=arg[4]? arg[4][37] : 0;
a040=a040*a241;
if (res[0]!=0) res[0][4]=a040;
a040=casadi_sign(a000);
a103=arg[4]? arg[4][38] : 0;
a040=a040*a103;
a390=cos(a000);
a252=a004*a006;
a390=a390*a252;
a040=a040-a390;
a390=sin(a000);
a006=a002*a006;
a390=a390*a006;
a040=a040-a390;
a390=sin(a000);
a004=a004*a010;
a390=a390*a004;
a040=a040-a390;
a390=cos(a000);
a010=a002*a010;
a390=a390*a010;
a040=a040+a390;
a390=cos(a000);
a173=a044+a173;
a010=a009*a173;
a390=a390*a010;
a040=a040+a390;
a390=sin(a000);
a010=a013*a173;
a390=a390*a010;
a040=a040+a390;
a390=cos(a000);
a073=a073+a399;
a073=a073+a049;
a013=a013*a073;
a390=a390*a013;
a040=a040-a390;
a000=sin(a000);
a009=a009*a073;
a000=a000*a009;
a040=a040+a000;
if (res[0]!=0) res[0][5]=a040;
a047=a047*a173;
a008=a008*a073;
a047=a047-a008;
if (res[1]!=0) res[1][0]=a047;
a045=a045*a173;
a014=a014*a073;
a045=a045+a014;
a045=-a045;
if (res[1]!=0) res[1][1]=a045;
a045=a405-a224;
a197=a197*a045;
a195=a195*a197;
a227=a227+a195;
a028=a028+a400;
a400=a028/a025;
a400=2.*a400;
a227=a227+a400;
if (res[1]!=0) res[1][2]=a227;
a191=a191*a254;
a194=a194*a191;
a254=arg[4]? arg[4][24] : 0;
a227=a132<=a115;
a115=a115<=a132;
a132=a115+a227;
a227=a227/a132;
a400=a116<=a133;
a133=a133<=a116;
a116=a133+a400;
a400=a400/a116;
a195=a018<=a114;
a114=a114<=a018;
a114=a114+a195;
a195=a195/a114;
a114=arg[4]? arg[4][25] : 0;
a131=a131*a026;
a147=a147*a131;
a026=a023*a147;
a144=a144*a026;
a144=a029*a144;
a114=a114+a144;
a142=a142*a114;
a142=a029*a142;
a143=a143*a114;
a143=a067*a143;
a141=a141*a143;
a142=a142-a141;
a141=2.*a134;
a134=a134*a143;
a141=a141*a134;
a142=a142-a141;
a195=a195*a142;
a142=a070*a195;
a142=a142+a114;
a141=a018<=a135;
a135=a135<=a018;
a135=a135+a141;
a141=a141/a135;
a139=a139*a114;
a139=a067*a139;
a137=a137*a139;
a138=a138*a114;
a138=a029*a138;
a137=a137-a138;
a138=2.*a136;
a136=a136*a139;
a138=a138*a136;
a137=a137+a138;
a141=a141*a137;
a137=a070*a141;
a142=a142-a137;
a400=a400*a142;
a227=a227*a400;
a117=a117*a227;
a254=a254+a117;
a119=a119*a254;
a194=a194+a119;
if (res[1]!=0) res[1][3]=a194;
a424=a327*a424;
a388=a388+a424;
a365=a365*a366;
a388=a388+a365;
if (res[1]!=0) res[1][4]=a388;
a327=a327*a370;
a316=a316+a327;
a291=a291*a290;
a316=a316+a291;
if (res[1]!=0) res[1][5]=a316;
a316=cos(a052);
a207=a207*a201;
a291=a207*a220;
a316=a316*a291;
a291=sin(a052);
a272=a272*a201;
a016=a272*a016;
a220=a016*a220;
a291=a291*a220;
a316=a316-a291;
a291=sin(a052);
a220=a207*a219;
a291=a291*a220;
a316=a316+a291;
a291=cos(a052);
a219=a016*a219;
a291=a291*a219;
a316=a316+a291;
a291=cos(a052);
a219=a078*a232;
a291=a291*a219;
a316=a316+a291;
a291=sin(a052);
a232=a002*a232;
a291=a291*a232;
a316=a316-a291;
a291=cos(a052);
a002=a002*a051;
a291=a291*a002;
a316=a316-a291;
a052=sin(a052);
a078=a078*a051;
a052=a052*a078;
a316=a316-a052;
a050=a050*a316;
a019=a019*a050;
a417=a417*a288;
a063=a063*a035;
a417=a417-a063;
a425=a425*a420;
a417=a417+a425;
a062=a062*a417;
a019=a019-a062;
if (res[1]!=0) res[1][6]=a019;
if (res[1]!=0) res[1][7]=a050;
if (res[1]!=0) res[1][8]=a417;
a212=a212*a288;
a273=a273*a418;
a212=a212+a273;
if (res[1]!=0) res[1][9]=a212;
a212=sin(a038);
a212=a212*a085;
a273=a041*a212;
a043=a043*a088;
a273=a273-a043;
a273=a273+a091;
if (res[1]!=0) res[1][10]=a273;
a429=a429*a363;
a435=a429*a435;
a314=a314*a363;
a179=a314*a179;
a435=a435-a179;
a179=a435*a224;
a296=a296*a289;
a309=a296*a309;
a375=a375*a289;
a379=a375*a379;
a309=a309+a379;
a379=a309*a224;
a179=a179-a379;
a303=a296*a303;
a381=a375*a381;
a303=a303-a381;
a381=a303*a085;
a179=a179-a381;
a389=a314*a389;
a433=a429*a433;
a389=a389+a433;
a433=a389*a085;
a179=a179+a433;
a306=a306*a179;
a433=a303*a088;
a381=a389*a088;
a379=a433-a381;
a280=a113*a280;
a379=a379+a280;
a230=a036*a230;
a379=a379+a230;
a069=a069/a198;
a069=a069*a111;
a181=a181/a198;
a181=a181*a326;
a069=a069-a181;
a379=a379+a069;
a175=a175*a379;
a306=a306+a175;
if (res[2]!=0) res[2][0]=a306;
a306=sin(a038);
a278=a016*a278;
a223=a207*a223;
a278=a278-a223;
a223=a278*a074;
a223=a223*a224;
a306=a306*a223;
a223=sin(a038);
a175=a309*a224;
a181=a435*a224;
a175=a175-a181;
a181=a177*a175;
a223=a223*a181;
a306=a306-a223;
a223=cos(a038);
a181=a278*a224;
a207=a207*a217;
a016=a016*a276;
a207=a207+a016;
a016=a207*a085;
a181=a181+a016;
a016=a093*a181;
a223=a223*a016;
a306=a306+a223;
a223=sin(a038);
a016=a207*a074;
a016=a016*a085;
a223=a223*a016;
a306=a306+a223;
a223=sin(a038);
a016=a303*a177;
a016=a016*a085;
a223=a223*a016;
a306=a306-a223;
a223=cos(a038);
a179=a174*a179;
a223=a223*a179;
a306=a306+a223;
a223=sin(a038);
a179=a389*a177;
a179=a179*a085;
a223=a223*a179;
a306=a306+a223;
a223=sin(a038);
a082=a082*a058;
a058=a082*a037;
a058=a058*a085;
a223=a223*a058;
a306=a306+a223;
a223=cos(a038);
a058=a082*a041;
a058=a058*a085;
a223=a223*a058;
a306=a306-a223;
a223=cos(a038);
a058=arg[1]? arg[1][10] : 0;
a179=a058*a041;
a179=a179*a085;
a223=a223*a179;
a306=a306+a223;
a223=sin(a038);
a179=a058*a088;
a044=a036*a044;
a085=a082*a088;
a044=a044-a085;
a179=a179+a044;
a041=a041*a179;
a223=a223*a041;
a306=a306+a223;
a223=cos(a038);
a037=a037*a044;
a223=a223*a037;
a306=a306+a223;
a223=arg[4]? arg[4][12] : 0;
a306=a306+a223;
a223=cos(a038);
a433=a433-a381;
a433=a433+a280;
a433=a433+a230;
a433=a433+a069;
a177=a177*a433;
a223=a223*a177;
a306=a306+a223;
a223=sin(a038);
a174=a174*a379;
a223=a223*a174;
a306=a306-a223;
a223=sin(a038);
a196=a196*a045;
a223=a223*a196;
a306=a306-a223;
a193=a193*a191;
a306=a306+a193;
a193=cos(a038);
a405=a149*a405;
a223=a149*a224;
a223=a405-a223;
a185=a185*a223;
a193=a193*a185;
a306=a306+a193;
a193=sin(a038);
a149=a149*a224;
a405=a405-a149;
a182=a182*a405;
a193=a193*a182;
a306=a306-a193;
a193=cos(a038);
a097=a036*a097;
a182=a207*a088;
a149=a097-a182;
a149=a149-a069;
a113=a113*a382;
a149=a149-a113;
a074=a074*a149;
a193=a193*a074;
a306=a306+a193;
a193=sin(a038);
a097=a097-a182;
a097=a097-a069;
a097=a097-a113;
a093=a093*a097;
a193=a193*a093;
a306=a306-a193;
a193=a152<=a032;
a032=a032<=a152;
a152=a032+a193;
a193=a193/a152;
a093=a151<=a154;
a154=a154<=a151;
a151=a154+a093;
a093=a093/a151;
a113=a018<=a150;
a150=a150<=a018;
a150=a150+a113;
a113=a113/a150;
a161=2.*a161;
a339=a170*a339;
a342=a342*a339;
a161=a161*a342;
a342=arg[4]? arg[4][14] : 0;
a161=a161+a342;
a190=a170*a190;
a161=a161+a190;
a163=a163*a161;
a163=a029*a163;
a164=a164*a161;
a164=a067*a164;
a162=a162*a164;
a163=a163-a162;
a162=2.*a155;
a155=a155*a164;
a162=a162*a155;
a163=a163-a162;
a113=a113*a163;
a163=a070*a113;
a163=a163+a161;
a162=a018<=a156;
a156=a156<=a018;
a156=a156+a162;
a162=a162/a156;
a160=a160*a161;
a067=a067*a160;
a158=a158*a067;
a159=a159*a161;
a159=a029*a159;
a158=a158-a159;
a159=2.*a157;
a157=a157*a067;
a159=a159*a157;
a158=a158+a159;
a162=a162*a158;
a070=a070*a162;
a163=a163-a070;
a093=a093*a163;
a193=a193*a093;
a153=a153*a193;
a306=a306+a153;
a121=a121*a254;
a306=a306+a121;
if (res[2]!=0) res[2][1]=a306;
a306=sin(a104);
a121=a375*a305;
a306=a306*a121;
a121=cos(a104);
a305=a296*a305;
a121=a121*a305;
a306=a306+a121;
a121=sin(a104);
a305=a429*a374;
a121=a121*a305;
a306=a306-a121;
a121=cos(a104);
a374=a314*a374;
a121=a121*a374;
a306=a306+a121;
a121=cos(a104);
a375=a375*a312;
a121=a121*a375;
a306=a306+a121;
a121=sin(a104);
a296=a296*a312;
a121=a121*a296;
a306=a306-a121;
a121=sin(a104);
a314=a314*a307;
a121=a121*a314;
a306=a306+a121;
a121=cos(a104);
a429=a429*a307;
a121=a121*a429;
a306=a306+a121;
a121=sin(a104);
a269=a269*a317;
a121=a121*a269;
a306=a306-a121;
a121=cos(a104);
a235=a235*a369;
a121=a121*a235;
a306=a306+a121;
a121=sin(a104);
a369=a239*a369;
a121=a121*a369;
a306=a306-a121;
a121=sin(a104);
a343=a343*a211;
a121=a121*a343;
a306=a306-a121;
a121=cos(a104);
a102=a239*a102;
a121=a121*a102;
a306=a306+a121;
a121=cos(a104);
a101=a101*a057;
a121=a121*a101;
a306=a306-a121;
a104=sin(a104);
a239=a239*a057;
a104=a104*a239;
a306=a306-a104;
if (res[2]!=0) res[2][2]=a306;
a306=a029*a309;
a306=a306*a088;
a104=a029*a435;
a104=a104*a088;
a306=a306+a104;
a255=a255*a341;
a306=a306+a255;
if (res[2]!=0) res[2][3]=a306;
a310=a310*a175;
a304=a303*a304;
a310=a310+a304;
a376=a389*a376;
a310=a310-a376;
a178=a178*a433;
a310=a310+a178;
if (res[2]!=0) res[2][4]=a310;
a310=2.*a098;
a231=2.*a231;
a231=a231*a359;
a310=a310*a231;
a231=2.*a098;
a099=2.*a099;
a099=a099*a253;
a231=a231*a099;
a310=a310-a231;
a231=2.*a098;
a213=2.*a213;
a213=a213*a416;
a231=a231*a213;
a310=a310+a231;
a098=2.*a098;
a105=a105+a282;
a105=a105+a360;
a017=a017*a105;
a098=a098*a017;
a310=a310+a098;
if (res[2]!=0) res[2][5]=a310;
a021=a021/a025;
a021=a021*a028;
a028=a024*a021;
a028=-a028;
if (res[2]!=0) res[2][6]=a028;
a081=a081*a083;
a165=a165*a036;
a368=a165*a368;
a081=a081+a368;
a169=a169*a377;
a081=a081+a169;
a145=a145*a147;
a081=a081+a145;
a145=2.*a023;
a022=a022*a021;
a024=2.*a024;
a022=a022/a024;
a145=a145*a022;
a081=a081-a145;
if (res[2]!=0) res[2][7]=a081;
a124=a124*a254;
a124=-a124;
if (res[2]!=0) res[2][8]=a124;
if (res[2]!=0) res[2][9]=a254;
a254=a118*a254;
if (res[2]!=0) res[2][10]=a254;
a120=a120*a227;
if (res[2]!=0) res[2][11]=a120;
a195=a068*a195;
a141=a068*a141;
a195=a195+a141;
a115=a115/a132;
a115=a115*a400;
a133=a133/a116;
a133=a133*a142;
a115=a115-a133;
a195=a195+a115;
if (res[2]!=0) res[2][12]=a195;
a140=a140*a026;
if (res[2]!=0) res[2][13]=a140;
a146=a146*a131;
if (res[2]!=0) res[2][14]=a146;
a319=a319*a320;
a172=a172*a319;
a168=a168*a012;
a168=a029*a168;
a172=a172+a168;
if (res[2]!=0) res[2][15]=a172;
if (res[2]!=0) res[2][16]=a191;
a172=a038*a191;
if (res[2]!=0) res[2][17]=a172;
a118=a118*a191;
if (res[2]!=0) res[2][18]=a118;
a192=a170*a192;
if (res[2]!=0) res[2][19]=a192;
if (res[2]!=0) res[2][20]=a193;
a038=a038*a193;
if (res[2]!=0) res[2][21]=a038;
a113=a068*a113;
a162=a068*a162;
a113=a113+a162;
a032=a032/a152;
a032=a032*a093;
a154=a154/a151;
a154=a154*a163;
a032=a032-a154;
a113=a113+a032;
if (res[2]!=0) res[2][22]=a113;
if (res[2]!=0) res[2][23]=a339;
a364=a364*a339;
if (res[2]!=0) res[2][24]=a364;
a218=a218*a181;
a053=a053*a097;
a218=a218+a053;
if (res[2]!=0) res[2][25]=a218;
a218=a090*a167;
a053=a090*a180;
a218=a218+a053;
if (res[2]!=0) res[2][26]=a218;
a167=a112*a167;
a218=a058-a082;
a165=a165*a023;
a300=a300*a165;
a362=a170*a362;
a300=a300+a362;
a218=a218+a300;
a218=a218-a389;
a218=a218+a303;
a218=a218-a207;
a218=a218/a090;
a218=a218/a090;
a218=a218*a089;
a167=a167-a218;
a435=a435-a309;
a435=a435+a278;
a435=a435+a020;
a435=a435-a414;
a435=a435/a090;
a435=a435/a090;
a435=a435*a226;
a167=a167-a435;
a112=a112*a180;
a167=a167+a112;
if (res[2]!=0) res[2][27]=a167;
a183=a183*a405;
if (res[2]!=0) res[2][28]=a183;
a186=a186*a223;
if (res[2]!=0) res[2][29]=a186;
a030=a030*a149;
a278=a278*a225;
a207=a207*a221;
a278=a278+a207;
a030=a030-a278;
if (res[2]!=0) res[2][30]=a030;
a020=a020*a197;
if (res[2]!=0) res[2][31]=a020;
a020=a378+a436;
if (res[2]!=0) res[2][32]=a020;
a378=a238*a378;
a436=a238*a436;
a378=a378+a436;
if (res[2]!=0) res[2][33]=a378;
a378=a313+a311;
if (res[2]!=0) res[2][34]=a378;
a313=a238*a313;
a238=a238*a311;
a313=a313+a238;
if (res[2]!=0) res[2][35]=a313;
a328=a328*a434;
if (res[2]!=0) res[2][36]=a328;
a349=a349*a373;
a352=a352/a331;
a352=a352*a371;
a349=a349-a352;
a353=a347*a353;
a349=a349+a353;
a406=a406*a330;
a349=a349+a406;
a409=a409/a331;
a409=a409*a410;
a349=a349-a409;
a332=a404*a332;
a349=a349+a332;
a336=a336/a335;
a372=a372/a237;
a372=a372*a293;
a346=a346/a337;
a346=a346*a350;
a372=a372-a346;
a426=a426/a234;
a426=a426*a324;
a372=a372+a426;
a403=a403/a398;
a403=a403*a407;
a372=a372-a403;
a336=a336*a372;
a372=a334*a336;
a349=a349-a372;
if (res[2]!=0) res[2][37]=a349;
a351=a351*a373;
a347=a347*a371;
a351=a351-a347;
a408=a408*a330;
a351=a351+a408;
a404=a404*a410;
a351=a351-a404;
a404=a003<=a333;
a333=a333<=a003;
a333=a333+a404;
a404=a404/a333;
a331=a331*a336;
a334=2.*a334;
a331=a331/a334;
a404=a404*a331;
a351=a351-a404;
if (res[2]!=0) res[2][38]=a351;
a354=a354*a355;
a411=a411*a412;
a354=a354+a411;
if (res[2]!=0) res[2][39]=a354;
a356=a356*a358;
a413=a413*a415;
a356=a356+a413;
if (res[2]!=0) res[2][40]=a356;
a366=a366-a055;
if (res[2]!=0) res[2][41]=a366;
a286=a286*a380;
if (res[2]!=0) res[2][42]=a286;
a290=a290-a287;
if (res[2]!=0) res[2][43]=a290;
a050=a061*a050;
if (res[2]!=0) res[2][44]=a050;
a272=a272*a277;
a015=a015*a316;
a272=a272+a015;
a272=-a272;
if (res[2]!=0) res[2][45]=a272;
if (res[2]!=0) res[2][46]=a275;
a275=a199*a275;
if (res[2]!=0) res[2][47]=a275;
if (res[2]!=0) res[2][48]=a228;
a199=a199*a228;
if (res[2]!=0) res[2][49]=a199;
a200=a200*a279;
if (res[2]!=0) res[2][50]=a200;
a264=a264*a242;
a262=a262/a243;
a262=a262*a265;
a264=a264-a262;
a244=a259*a244;
a264=a264+a244;
a248=a248/a247;
a100=a100/a106;
a100=a100*a204;
a258=a258/a249;
a258=a258*a260;
a100=a100-a258;
a248=a248*a100;
a100=a246*a248;
a264=a264-a100;
if (res[2]!=0) res[2][51]=a264;
a261=a261*a242;
a259=a259*a265;
a261=a261-a259;
a259=a003<=a245;
a245=a245<=a003;
a245=a245+a259;
a259=a259/a245;
a243=a243*a248;
a246=2.*a246;
a243=a243/a246;
a259=a259*a243;
a261=a261-a259;
if (res[2]!=0) res[2][52]=a261;
a266=a266*a267;
if (res[2]!=0) res[2][53]=a266;
a268=a268*a270;
if (res[2]!=0) res[2][54]=a268;
a203=a203/a201;
if (res[2]!=0) res[2][55]=a203;
a061=a061*a417;
a061=-a061;
if (res[2]!=0) res[2][56]=a061;
a061=a402*a420;
if (res[2]!=0) res[2][57]=a061;
a421=a165*a421;
a061=a229*a421;
if (res[2]!=0) res[2][58]=a061;
a420=a060*a420;
if (res[2]!=0) res[2][59]=a420;
a176=a170*a176;
a170=a170*a109;
a176=a176+a170;
a229=2.*a229;
a361=a165*a361;
a229=a229*a361;
a176=a176+a229;
a367=a367*a421;
a176=a176+a367;
if (res[2]!=0) res[2][60]=a176;
a176=a384*a418;
if (res[2]!=0) res[2][61]=a176;
a418=a402*a418;
if (res[2]!=0) res[2][62]=a418;
a240=a240*a165;
a397=a240*a397;
if (res[2]!=0) res[2][63]=a397;
a384=a384*a288;
if (res[2]!=0) res[2][64]=a384;
a402=a402*a288;
if (res[2]!=0) res[2][65]=a402;
a240=a240*a329;
if (res[2]!=0) res[2][66]=a240;
a288=a060*a288;
if (res[2]!=0) res[2][67]=a288;
a058=a058*a212;
a087=a082*a087;
a058=a058-a087;
a042=a042*a179;
a058=a058-a042;
if (res[2]!=0) res[2][68]=a058;
a039=a039*a044;
a082=a082*a084;
a039=a039-a082;
if (res[2]!=0) res[2][69]=a039;
a096=a068*a096;
a068=a068*a076;
a096=a096+a068;
a033=a033/a064;
a033=a033*a095;
a065=a065/a034;
a065=a065*a077;
a033=a033-a065;
a096=a096+a033;
if (res[2]!=0) res[2][70]=a096;
a059=a059*a094;
if (res[2]!=0) res[2][71]=a059;
a060=a060*a035;
a060=-a060;
if (res[2]!=0) res[2][72]=a060;
a075=a075*a080;
a029=a029*a075;
if (res[2]!=0) res[2][73]=a029;
a079=a079*a031;
if (res[2]!=0) res[2][74]=a079;
a007=-a007;
if (res[2]!=0) res[2][75]=a007;
a007=-5.0000000000000000e-01;
a007=a007*a241;
if (res[2]!=0) res[2][76]=a007;
a103=-a103;
if (res[2]!=0) res[2][77]=a103;
if (res[2]!=0) res[2][78]=a018;
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
casadi_real a816;
a000=arg[0]? arg[0][5] : 0;
a001=cos(a000);
a002=arg[4]? arg[4][36] : 0;
a003=arg[4]? arg[4][27] : 0;
a002=a002+a003;
a003=arg[0]? arg[0][0] : 0;
a004=sin(a000);
a005=a003*a004;
a006=arg[0]? arg[0][1] : 0;
a007=cos(a000);
a008=a006*a007;
a005=a005+a008;
a008=casadi_sq(a005);
a009=a003*a001;
a010=sin(a000);
a011=a006*a010;
a009=a009-a011;
a011=casadi_sq(a009);
a008=a008+a011;
a011=9.9999999999999998e-13;
a008=a008+a011;
a008=sqrt(a008);
a012=2.*a008;
a002=a002/a012;
a013=arg[8]? arg[8][0] : 0;
a014=a001*a013;
a015=sin(a000);
a016=arg[8]? arg[8][5] : 0;
a015=a015*a016;
a017=a003*a015;
a014=a014-a017;
a017=arg[8]? arg[8][1] : 0;
a018=a010*a017;
a019=cos(a000);
a019=a019*a016;
a020=a006*a019;
a018=a018+a020;
a014=a014-a018;
a018=2.*a014;
a018=a002*a018;
a020=2.*a009;
a021=arg[12]? arg[12][36] : 0;
a022=arg[12]? arg[12][27] : 0;
a022=a021+a022;
a022=a022/a012;
a012=a002/a012;
a023=2.*a005;
a024=a004*a013;
a025=cos(a000);
a025=a025*a016;
a026=a003*a025;
a024=a024+a026;
a026=a007*a017;
a027=sin(a000);
a027=a027*a016;
a028=a006*a027;
a026=a026-a028;
a024=a024+a026;
a023=a023*a024;
a009=2.*a009;
a009=a009*a014;
a023=a023+a009;
a008=2.*a008;
a023=a023/a008;
a023=2.*a023;
a012=a012*a023;
a022=a022-a012;
a012=a020*a022;
a018=a018+a012;
a001=a001*a018;
a020=a020*a002;
a015=a020*a015;
a001=a001-a015;
a005=2.*a005;
a015=a005*a002;
a025=a015*a025;
a024=2.*a024;
a002=a002*a024;
a005=a005*a022;
a002=a002+a005;
a004=a004*a002;
a025=a025+a004;
a001=a001+a025;
a025=0.;
a004=arg[1]? arg[1][0] : 0;
a005=cos(a000);
a022=a004*a005;
a024=arg[1]? arg[1][1] : 0;
a012=sin(a000);
a023=a024*a012;
a022=a022+a023;
a023=a003-a022;
a008=casadi_sq(a023);
a009=9.9999999999999995e-07;
a008=a008+a009;
a008=sqrt(a008);
a014=a023*a008;
a026=arg[1]? arg[1][2] : 0;
a028=2.*a026;
a029=arg[2]? arg[2][6] : 0;
a030=arg[2]? arg[2][7] : 0;
a031=casadi_sq(a030);
a031=a031+a011;
a031=sqrt(a031);
a032=a029*a031;
a028=a028/a032;
a014=a014+a028;
a033=-9.9999999999999995e-07;
a034=a014+a033;
a035=a025<=a034;
a036=a034<=a025;
a036=a036+a035;
a035=a035/a036;
a036=5.0000000000000000e-01;
a037=arg[2]? arg[2][73] : 0;
a037=a036*a037;
a038=arg[2]? arg[2][70] : 0;
a039=1.0000000000000001e-01;
a040=a038+a039;
a041=-a040;
a042=arg[2]? arg[2][71] : 0;
a043=arg[0]? arg[0][2] : 0;
a044=arg[2]? arg[2][69] : 0;
a045=arg[2]? arg[2][1] : 0;
a046=sin(a045);
a047=a044*a046;
a048=arg[2]? arg[2][68] : 0;
a049=cos(a045);
a050=a048*a049;
a047=a047-a050;
a051=a043*a047;
a051=a051+a006;
a052=cos(a000);
a053=a024*a052;
a054=sin(a000);
a055=a004*a054;
a053=a053-a055;
a051=a051-a053;
a055=1.;
a056=1000000.;
a014=a056*a014;
a057=casadi_fmin(a055,a014);
a058=casadi_fmax(a025,a057);
a059=casadi_sq(a058);
a060=a058*a059;
a060=a009*a060;
a061=3.;
a062=casadi_sq(a058);
a062=a061*a062;
a063=8.;
a064=a063*a058;
a062=a062-a064;
a064=6.;
a062=a062+a064;
a065=a060*a062;
a066=casadi_fmax(a025,a034);
a065=a065+a066;
a065=a065+a009;
a066=sqrt(a065);
a067=atan2(a051,a066);
a068=arg[1]? arg[1][8] : 0;
a069=arg[1]? arg[1][6] : 0;
a070=arg[2]? arg[2][56] : 0;
a071=a069*a070;
a068=a068-a071;
a071=arg[2]? arg[2][72] : 0;
a072=a068*a071;
a067=a067-a072;
a072=a042*a067;
a073=casadi_fmin(a040,a072);
a074=casadi_fmax(a041,a073);
a075=2.0000000000000001e-01;
a076=-5.;
a077=a076*a038;
a078=5.;
a079=a078*a074;
a077=a077-a079;
a077=a077+a036;
a079=casadi_fmax(a025,a077);
a080=casadi_sq(a079);
a081=a079*a080;
a081=a075*a081;
a082=a036*a079;
a082=a055-a082;
a083=a081*a082;
a083=a074+a083;
a038=a076*a038;
a074=a078*a074;
a038=a038+a074;
a038=a038+a036;
a074=casadi_fmax(a025,a038);
a084=casadi_sq(a074);
a085=a074*a084;
a085=a075*a085;
a086=a036*a074;
a086=a055-a086;
a087=a085*a086;
a083=a083-a087;
a087=a037*a083;
a088=arg[2]? arg[2][74] : 0;
a089=a087*a088;
a090=a089*a030;
a091=arg[4]? arg[4][23] : 0;
a092=cos(a045);
a093=arg[4]? arg[4][34] : 0;
a094=a092*a093;
a095=a044*a094;
a096=sin(a045);
a097=a096*a093;
a098=a048*a097;
a095=a095+a098;
a098=arg[4]? arg[4][30] : 0;
a099=a047*a098;
a095=a095+a099;
a099=arg[4]? arg[4][32] : 0;
a100=arg[2]? arg[2][27] : 0;
a101=a099/a100;
a102=arg[4]? arg[4][29] : 0;
a102=a101+a102;
a095=a095+a102;
a091=a091-a095;
a095=a090*a091;
a103=casadi_sq(a051);
a103=a103+a065;
a104=a051/a103;
a105=a072<=a040;
a106=a040<=a072;
a107=a106+a105;
a105=a105/a107;
a108=a041<=a073;
a109=a073<=a041;
a110=a109+a108;
a108=a108/a110;
a111=a025<=a038;
a112=a038<=a025;
a112=a112+a111;
a111=a111/a112;
a112=casadi_sq(a051);
a112=a065+a112;
a113=a112*a091;
a114=a030*a113;
a115=a088*a114;
a116=a037*a115;
a117=arg[4]? arg[4][22] : 0;
a116=a116+a117;
a117=a085*a116;
a117=a036*a117;
a118=a086*a116;
a118=a075*a118;
a119=a084*a118;
a117=a117-a119;
a119=2.*a074;
a120=a074*a118;
a121=a119*a120;
a117=a117-a121;
a117=a111*a117;
a117=a078*a117;
a117=a117+a116;
a121=a025<=a077;
a122=a077<=a025;
a122=a122+a121;
a121=a121/a122;
a122=a082*a116;
a122=a075*a122;
a123=a080*a122;
a124=a081*a116;
a124=a036*a124;
a123=a123-a124;
a124=2.*a079;
a125=a079*a122;
a126=a124*a125;
a123=a123+a126;
a123=a121*a123;
a123=a078*a123;
a117=a117-a123;
a117=a108*a117;
a117=a105*a117;
a123=a042*a117;
a126=arg[4]? arg[4][21] : 0;
a126=a123+a126;
a127=a104*a126;
a128=2.*a066;
a127=a127/a128;
a129=a095-a127;
a130=a035*a129;
a131=a014<=a055;
a132=a055<=a014;
a132=a132+a131;
a131=a131/a132;
a132=a025<=a057;
a133=a057<=a025;
a133=a133+a132;
a132=a132/a133;
a133=2.*a058;
a134=a060*a129;
a135=a061*a134;
a136=a133*a135;
a134=a063*a134;
a136=a136-a134;
a134=a062*a129;
a134=a009*a134;
a137=a059*a134;
a136=a136+a137;
a137=2.*a058;
a138=a058*a134;
a139=a137*a138;
a136=a136+a139;
a136=a132*a136;
a136=a131*a136;
a136=a056*a136;
a130=a130+a136;
a136=2.*a023;
a139=arg[9]? arg[9][0] : 0;
a140=a005*a139;
a141=sin(a000);
a141=a141*a016;
a142=a004*a141;
a140=a140-a142;
a142=arg[9]? arg[9][1] : 0;
a143=a012*a142;
a144=cos(a000);
a144=a144*a016;
a145=a024*a144;
a143=a143+a145;
a140=a140+a143;
a143=a013-a140;
a136=a136*a143;
a145=2.*a008;
a136=a136/a145;
a145=a130*a136;
a146=arg[10]? arg[10][73] : 0;
a146=a036*a146;
a147=a083*a146;
a148=a041<=a073;
a073=a073<=a041;
a041=a073+a148;
a148=a148/a041;
a149=a040<=a072;
a072=a072<=a040;
a040=a149+a072;
a149=a149/a040;
a150=arg[10]? arg[10][70] : 0;
a149=a149*a150;
a072=a072/a040;
a040=arg[10]? arg[10][71] : 0;
a151=a067*a040;
a152=casadi_sq(a051);
a152=a152+a065;
a065=a066/a152;
a153=arg[8]? arg[8][2] : 0;
a154=a047*a153;
a155=arg[10]? arg[10][69] : 0;
a156=a046*a155;
a157=cos(a045);
a158=arg[10]? arg[10][1] : 0;
a157=a157*a158;
a159=a044*a157;
a156=a156+a159;
a159=arg[10]? arg[10][68] : 0;
a160=a049*a159;
a161=sin(a045);
a161=a161*a158;
a162=a048*a161;
a160=a160-a162;
a156=a156-a160;
a162=a043*a156;
a154=a154+a162;
a154=a154+a017;
a162=a052*a142;
a163=sin(a000);
a163=a163*a016;
a164=a024*a163;
a162=a162-a164;
a164=a054*a139;
a165=cos(a000);
a165=a165*a016;
a166=a004*a165;
a164=a164+a166;
a162=a162-a164;
a154=a154-a162;
a065=a065*a154;
a152=a051/a152;
a164=a025<=a057;
a057=a057<=a025;
a057=a057+a164;
a164=a164/a057;
a057=a014<=a055;
a014=a055<=a014;
a014=a014+a057;
a057=a057/a014;
a014=a008*a143;
a166=a023*a136;
a014=a014+a166;
a166=arg[9]? arg[9][2] : 0;
a167=2.*a166;
a167=a167/a032;
a168=a028/a032;
a169=arg[10]? arg[10][6] : 0;
a170=a031*a169;
a171=2.*a030;
a172=arg[10]? arg[10][7] : 0;
a171=a171*a172;
a173=2.*a031;
a171=a171/a173;
a173=a029*a171;
a170=a170+a173;
a168=a168*a170;
a167=a167-a168;
a014=a014+a167;
a168=a056*a014;
a057=a057*a168;
a164=a164*a057;
a057=a059*a164;
a168=2.*a058;
a168=a168*a164;
a173=a058*a168;
a057=a057+a173;
a057=a009*a057;
a173=a062*a057;
a174=2.*a058;
a174=a174*a164;
a174=a061*a174;
a175=a063*a164;
a174=a174-a175;
a175=a060*a174;
a173=a173+a175;
a175=a025<=a034;
a034=a034<=a025;
a034=a034+a175;
a175=a175/a034;
a175=a175*a014;
a173=a173+a175;
a175=2.*a066;
a175=a173/a175;
a152=a152*a175;
a065=a065-a152;
a152=arg[9]? arg[9][8] : 0;
a014=arg[9]? arg[9][6] : 0;
a034=a070*a014;
a176=arg[10]? arg[10][56] : 0;
a177=a069*a176;
a034=a034+a177;
a152=a152-a034;
a034=a071*a152;
a177=arg[10]? arg[10][72] : 0;
a178=a068*a177;
a034=a034+a178;
a065=a065-a034;
a034=a042*a065;
a151=a151+a034;
a072=a072*a151;
a149=a149+a072;
a148=a148*a149;
a073=a073/a041;
a073=a073*a150;
a148=a148-a073;
a073=a025<=a077;
a077=a077<=a025;
a077=a077+a073;
a073=a073/a077;
a077=a076*a150;
a041=a078*a148;
a077=a077-a041;
a073=a073*a077;
a077=a080*a073;
a041=2.*a079;
a041=a041*a073;
a149=a079*a041;
a077=a077+a149;
a077=a075*a077;
a149=a082*a077;
a072=a036*a073;
a151=a081*a072;
a149=a149-a151;
a149=a148+a149;
a151=a025<=a038;
a038=a038<=a025;
a038=a038+a151;
a151=a151/a038;
a150=a076*a150;
a148=a078*a148;
a150=a150+a148;
a151=a151*a150;
a150=a084*a151;
a148=2.*a074;
a148=a148*a151;
a038=a074*a148;
a150=a150+a038;
a150=a075*a150;
a038=a086*a150;
a034=a036*a151;
a178=a085*a034;
a038=a038-a178;
a149=a149-a038;
a038=a037*a149;
a147=a147+a038;
a038=a088*a147;
a178=arg[10]? arg[10][74] : 0;
a179=a087*a178;
a038=a038+a179;
a179=a030*a038;
a180=a089*a172;
a179=a179+a180;
a180=a091*a179;
a181=arg[12]? arg[12][23] : 0;
a182=a094*a155;
a183=arg[12]? arg[12][34] : 0;
a092=a092*a183;
a184=sin(a045);
a184=a184*a158;
a184=a093*a184;
a092=a092-a184;
a184=a044*a092;
a182=a182+a184;
a184=a097*a159;
a185=cos(a045);
a185=a185*a158;
a185=a093*a185;
a096=a096*a183;
a185=a185+a096;
a096=a048*a185;
a184=a184+a096;
a182=a182+a184;
a184=a098*a156;
a096=arg[12]? arg[12][30] : 0;
a186=a047*a096;
a184=a184+a186;
a182=a182+a184;
a184=arg[12]? arg[12][32] : 0;
a186=a184/a100;
a101=a101/a100;
a187=arg[10]? arg[10][27] : 0;
a101=a101*a187;
a186=a186-a101;
a101=arg[12]? arg[12][29] : 0;
a186=a186+a101;
a182=a182+a186;
a181=a181-a182;
a182=a090*a181;
a180=a180+a182;
a182=a154/a103;
a101=a104/a103;
a188=2.*a051;
a188=a188*a154;
a188=a188+a173;
a101=a101*a188;
a182=a182-a101;
a182=a126*a182;
a040=a117*a040;
a150=a116*a150;
a146=a115*a146;
a178=a114*a178;
a101=a113*a172;
a189=2.*a051;
a189=a189*a154;
a173=a173+a189;
a091=a091*a173;
a181=a112*a181;
a091=a091+a181;
a181=a030*a091;
a101=a101+a181;
a088=a088*a101;
a178=a178+a088;
a037=a037*a178;
a146=a146+a037;
a037=arg[12]? arg[12][22] : 0;
a146=a146+a037;
a085=a085*a146;
a150=a150+a085;
a150=a036*a150;
a148=a118*a148;
a086=a086*a146;
a034=a116*a034;
a086=a086-a034;
a086=a075*a086;
a084=a084*a086;
a148=a148+a084;
a150=a150-a148;
a148=2.*a151;
a120=a120*a148;
a118=a118*a151;
a074=a074*a086;
a118=a118+a074;
a119=a119*a118;
a120=a120+a119;
a150=a150-a120;
a111=a111*a150;
a150=a078*a111;
a150=a150+a146;
a041=a122*a041;
a082=a082*a146;
a072=a116*a072;
a082=a082-a072;
a082=a075*a082;
a080=a080*a082;
a041=a041+a080;
a116=a116*a077;
a081=a081*a146;
a116=a116+a081;
a116=a036*a116;
a041=a041-a116;
a116=2.*a073;
a125=a125*a116;
a122=a122*a073;
a079=a079*a082;
a122=a122+a079;
a124=a124*a122;
a125=a125+a124;
a041=a041+a125;
a121=a121*a041;
a041=a078*a121;
a150=a150-a041;
a108=a108*a150;
a105=a105*a108;
a042=a042*a105;
a040=a040+a042;
a042=arg[12]? arg[12][21] : 0;
a042=a040+a042;
a104=a104*a042;
a182=a182+a104;
a182=a182/a128;
a127=a127/a128;
a128=2.*a175;
a127=a127*a128;
a182=a182-a127;
a182=a180-a182;
a035=a035*a182;
a127=2.*a164;
a135=a135*a127;
a057=a129*a057;
a060=a060*a182;
a057=a057+a060;
a060=a061*a057;
a133=a133*a060;
a135=a135+a133;
a057=a063*a057;
a135=a135-a057;
a168=a134*a168;
a129=a129*a174;
a062=a062*a182;
a129=a129+a062;
a129=a009*a129;
a059=a059*a129;
a168=a168+a059;
a135=a135+a168;
a168=2.*a164;
a138=a138*a168;
a134=a134*a164;
a058=a058*a129;
a134=a134+a058;
a137=a137*a134;
a138=a138+a137;
a135=a135+a138;
a132=a132*a135;
a131=a131*a132;
a131=a056*a131;
a035=a035+a131;
a131=a008*a035;
a145=a145+a131;
a131=a023*a130;
a132=2.*a008;
a131=a131/a132;
a135=2.*a143;
a135=a131*a135;
a138=2.*a023;
a143=a130*a143;
a023=a023*a035;
a143=a143+a023;
a143=a143/a132;
a132=a131/a132;
a136=2.*a136;
a132=a132*a136;
a143=a143-a132;
a143=a138*a143;
a135=a135+a143;
a145=a145+a135;
a001=a001+a145;
a135=arg[2]? arg[2][44] : 0;
a143=a069*a135;
a132=arg[1]? arg[1][7] : 0;
a143=a143+a132;
a132=arg[2]? arg[2][45] : 0;
a136=a055-a132;
a023=a143*a136;
a137=cos(a023);
a134=a003*a137;
a058=arg[2]? arg[2][25] : 0;
a129=cos(a045);
a164=a058*a129;
a168=arg[2]? arg[2][30] : 0;
a059=sin(a045);
a062=a168*a059;
a182=a164+a062;
a174=a043*a182;
a174=a174+a006;
a057=sin(a023);
a133=a174*a057;
a134=a134+a133;
a133=arg[2]? arg[2][5] : 0;
a060=casadi_sq(a133);
a127=casadi_sq(a060);
a128=casadi_sq(a134);
a104=cos(a023);
a041=a174*a104;
a125=sin(a023);
a124=a003*a125;
a041=a041-a124;
a124=casadi_sq(a041);
a128=a128+a124;
a124=casadi_sq(a128);
a127=a127+a124;
a127=sqrt(a127);
a124=sqrt(a127);
a122=a134/a124;
a079=arg[2]? arg[2][55] : 0;
a082=arg[2]? arg[2][50] : 0;
a073=1.0000000000000000e-03;
a116=arg[2]? arg[2][48] : 0;
a081=arg[2]? arg[2][49] : 0;
a146=arg[2]? arg[2][26] : 0;
a077=a146*a100;
a080=arg[2]? arg[2][12] : 0;
a072=a080+a039;
a120=-a072;
a119=arg[2]? arg[2][11] : 0;
a118=arg[1]? arg[1][3] : 0;
a074=arg[2]? arg[2][10] : 0;
a086=a118*a074;
a151=arg[2]? arg[2][9] : 0;
a086=a086+a151;
a151=arg[2]? arg[2][8] : 0;
a151=a055-a151;
a148=a003-a022;
a084=casadi_sq(a148);
a084=a084+a009;
a084=sqrt(a084);
a034=a148*a084;
a034=a034+a028;
a085=a056*a034;
a037=casadi_fmin(a055,a085);
a088=casadi_fmax(a025,a037);
a181=casadi_sq(a088);
a189=a088*a181;
a189=a009*a189;
a190=casadi_sq(a088);
a190=a061*a190;
a191=a063*a088;
a190=a190-a191;
a190=a190+a064;
a191=a189*a190;
a033=a033+a034;
a034=casadi_fmax(a025,a033);
a191=a191+a034;
a191=a191+a009;
a034=sqrt(a191);
a034=atan2(a025,a034);
a034=a045+a034;
a192=a151*a034;
a086=a086+a192;
a192=a119*a086;
a193=casadi_fmin(a072,a192);
a194=casadi_fmax(a120,a193);
a195=a076*a080;
a196=a078*a194;
a195=a195-a196;
a195=a195+a036;
a196=casadi_fmax(a025,a195);
a197=casadi_sq(a196);
a198=a196*a197;
a198=a075*a198;
a199=a036*a196;
a199=a055-a199;
a200=a198*a199;
a200=a194+a200;
a080=a076*a080;
a194=a078*a194;
a080=a080+a194;
a080=a080+a036;
a194=casadi_fmax(a025,a080);
a201=casadi_sq(a194);
a202=a194*a201;
a202=a075*a202;
a203=a036*a194;
a203=a055-a203;
a204=a202*a203;
a200=a200-a204;
a200=a036*a200;
a204=arg[2]? arg[2][13] : 0;
a205=a200*a204;
a206=a205*a030;
a207=arg[2]? arg[2][14] : 0;
a208=a206*a207;
a209=a208*a191;
a077=a077-a209;
a210=arg[2]? arg[2][22] : 0;
a039=a210+a039;
a211=-a039;
a212=arg[2]? arg[2][20] : 0;
a213=arg[2]? arg[2][21] : 0;
a214=a213*a045;
a212=a212+a214;
a214=casadi_fmin(a039,a212);
a215=casadi_fmax(a211,a214);
a216=a076*a210;
a217=a078*a215;
a216=a216-a217;
a216=a216+a036;
a217=casadi_fmax(a025,a216);
a218=casadi_sq(a217);
a219=a217*a218;
a219=a075*a219;
a220=a036*a217;
a220=a055-a220;
a221=a219*a220;
a221=a215+a221;
a210=a076*a210;
a215=a078*a215;
a210=a210+a215;
a210=a210+a036;
a215=casadi_fmax(a025,a210);
a222=casadi_sq(a215);
a223=a215*a222;
a223=a075*a223;
a224=a036*a215;
a224=a055-a224;
a225=a223*a224;
a221=a221-a225;
a225=arg[2]? arg[2][15] : 0;
a226=a036*a225;
a022=a003-a022;
a227=casadi_sq(a022);
a228=1.0000000000000000e-08;
a227=a227+a228;
a053=a006-a053;
a228=casadi_sq(a053);
a228=a227+a228;
a229=a226*a228;
a230=a229*a030;
a231=a221*a230;
a232=a231*a022;
a233=sqrt(a227);
a232=a232/a233;
a077=a077-a232;
a234=arg[2]? arg[2][0] : 0;
a235=cos(a045);
a236=a234*a235;
a237=arg[2]? arg[2][4] : 0;
a238=sin(a045);
a239=a237*a238;
a240=a236+a239;
a241=a077*a240;
a242=arg[2]? arg[2][28] : 0;
a243=cos(a045);
a244=a242*a243;
a245=arg[2]? arg[2][29] : 0;
a246=sin(a045);
a247=a245*a246;
a248=a244+a247;
a249=a209*a248;
a250=arg[2]? arg[2][19] : 0;
a251=a250*a230;
a252=arg[2]? arg[2][16] : 0;
a253=arg[2]? arg[2][17] : 0;
a254=a253*a045;
a252=a252+a254;
a254=arg[2]? arg[2][18] : 0;
a255=a254*a118;
a252=a252+a255;
a255=a251*a252;
a249=a249+a255;
a255=arg[2]? arg[2][31] : 0;
a256=a026*a255;
a257=cos(a045);
a258=a256*a257;
a249=a249+a258;
a241=a241+a249;
a258=a164+a062;
a258=a236-a258;
a258=a258+a239;
a241=a241/a258;
a259=casadi_fmax(a025,a241);
a260=a081*a259;
a116=a116+a260;
a260=casadi_fmax(a073,a116);
a261=a082*a260;
a079=a079/a261;
a262=5.0000000000000004e-06;
a263=a079+a262;
a264=a122<=a263;
a265=a263<=a122;
a266=a265+a264;
a264=a264/a266;
a267=-a263;
a268=casadi_fmin(a263,a122);
a269=a267<=a268;
a270=a268<=a267;
a271=a270+a269;
a269=a269/a271;
a272=100000.;
a273=-100000.;
a274=a273*a079;
a275=casadi_fmax(a267,a268);
a276=a272*a275;
a274=a274+a276;
a274=a274+a036;
a276=a025<=a274;
a277=a274<=a025;
a277=a277+a276;
a276=a276/a277;
a277=sin(a023);
a278=sin(a045);
a279=a058*a278;
a280=a279*a093;
a281=cos(a045);
a282=a281*a093;
a283=a168*a282;
a280=a280-a283;
a283=a164+a062;
a284=a283*a098;
a280=a280-a284;
a280=a280-a102;
a284=a277*a280;
a285=cos(a023);
a286=arg[4]? arg[4][35] : 0;
a287=a279*a286;
a288=cos(a045);
a289=a288*a286;
a290=a168*a289;
a287=a287-a290;
a290=arg[4]? arg[4][31] : 0;
a291=a290/a100;
a292=arg[4]? arg[4][28] : 0;
a292=a291+a292;
a287=a287+a292;
a293=a285*a287;
a284=a284-a293;
a293=arg[4]? arg[4][10] : 0;
a284=a284+a293;
a293=a261*a284;
a294=a259*a293;
a295=1.0000000000000001e-05;
a296=a273*a079;
a297=a272*a275;
a296=a296-a297;
a296=a296+a036;
a297=casadi_fmax(a025,a296);
a298=casadi_sq(a297);
a299=a297*a298;
a299=a295*a299;
a300=a036*a297;
a300=a055-a300;
a301=a299*a300;
a275=a275+a301;
a301=casadi_fmax(a025,a274);
a302=casadi_sq(a301);
a303=a301*a302;
a303=a295*a303;
a304=a036*a301;
a304=a055-a304;
a305=a303*a304;
a275=a275-a305;
a305=2.*a275;
a306=casadi_sq(a275);
a306=a055-a306;
a306=sqrt(a306);
a307=a273*a306;
a308=a306+a262;
a309=-a308;
a310=arg[2]? arg[2][54] : 0;
a311=arg[2]? arg[2][53] : 0;
a312=arg[2]? arg[2][51] : 0;
a313=arg[2]? arg[2][52] : 0;
a314=a313-a055;
a315=casadi_fmax(a011,a314);
a315=sqrt(a315);
a316=a312*a315;
a317=1./a316;
a318=-a317;
a319=arg[2]? arg[2][46] : 0;
a320=arg[2]? arg[2][47] : 0;
a321=a320*a259;
a319=a319+a321;
a321=casadi_fmax(a025,a319);
a322=casadi_sq(a134);
a323=casadi_sq(a133);
a323=a009*a323;
a322=a322+a323;
a324=sqrt(a322);
a325=a041/a324;
a326=a321*a325;
a326=a326/a261;
a327=casadi_fmin(a326,a317);
a328=casadi_fmax(a318,a327);
a329=a312*a328;
a330=atan(a329);
a331=a313*a330;
a331=a331/a312;
a332=a313-a055;
a333=a328*a332;
a333=a331-a333;
a334=a312*a333;
a335=atan(a334);
a336=a311*a335;
a337=sin(a336);
a338=a310*a337;
a339=casadi_sq(a041);
a339=a339+a322;
a339=sqrt(a339);
a322=a338*a339;
a322=a322/a124;
a340=casadi_fmin(a322,a308);
a341=casadi_fmax(a309,a340);
a342=a272*a341;
a307=a307+a342;
a307=a307+a036;
a342=a025<=a307;
a343=a307<=a025;
a343=a343+a342;
a342=a342/a343;
a343=casadi_fmax(a025,a307);
a344=casadi_sq(a343);
a345=a343*a344;
a345=a295*a345;
a132=a055-a132;
a346=cos(a023);
a347=a346*a280;
a348=sin(a023);
a349=a348*a287;
a347=a347+a349;
a349=arg[4]? arg[4][11] : 0;
a347=a347+a349;
a349=a132*a347;
a350=a261*a349;
a351=a259*a350;
a352=a345*a351;
a352=a036*a352;
a353=a036*a343;
a353=a055-a353;
a354=a353*a351;
a354=a295*a354;
a355=a344*a354;
a352=a352-a355;
a355=2.*a343;
a356=a343*a354;
a357=a355*a356;
a352=a352-a357;
a352=a342*a352;
a357=a273*a352;
a358=a273*a306;
a359=a272*a341;
a358=a358-a359;
a358=a358+a036;
a359=a025<=a358;
a360=a358<=a025;
a360=a360+a359;
a359=a359/a360;
a360=casadi_fmax(a025,a358);
a361=casadi_sq(a360);
a362=a036*a360;
a362=a055-a362;
a363=a362*a351;
a363=a295*a363;
a364=a361*a363;
a365=a360*a361;
a365=a295*a365;
a366=a365*a351;
a366=a036*a366;
a364=a364-a366;
a366=2.*a360;
a367=a360*a363;
a368=a366*a367;
a364=a364+a368;
a364=a359*a364;
a368=a273*a364;
a357=a357+a368;
a368=a308<=a322;
a369=a322<=a308;
a370=a369+a368;
a368=a368/a370;
a371=a309<=a340;
a372=a340<=a309;
a373=a372+a371;
a371=a371/a373;
a352=a272*a352;
a352=a352+a351;
a364=a272*a364;
a352=a352-a364;
a364=a371*a352;
a374=a368*a364;
a372=a372/a373;
a352=a372*a352;
a374=a374-a352;
a357=a357+a374;
a374=2.*a306;
a357=a357/a374;
a352=a305*a357;
a294=a294-a352;
a352=a025<=a274;
a274=a274<=a025;
a274=a274+a352;
a352=a352/a274;
a274=arg[10]? arg[10][55] : 0;
a274=a274/a261;
a373=a079/a261;
a375=arg[10]? arg[10][50] : 0;
a376=a260*a375;
a377=a073<=a116;
a378=a116<=a073;
a378=a378+a377;
a377=a377/a378;
a378=arg[10]? arg[10][48] : 0;
a379=arg[10]? arg[10][49] : 0;
a380=a259*a379;
a381=a025<=a241;
a382=a241<=a025;
a382=a382+a381;
a381=a381/a382;
a382=arg[10]? arg[10][26] : 0;
a383=a100*a382;
a384=a146*a187;
a383=a383+a384;
a384=a120<=a193;
a385=a193<=a120;
a386=a385+a384;
a384=a384/a386;
a387=a072<=a192;
a388=a192<=a072;
a389=a387+a388;
a387=a387/a389;
a390=arg[10]? arg[10][12] : 0;
a387=a387*a390;
a388=a388/a389;
a389=arg[10]? arg[10][11] : 0;
a391=a086*a389;
a392=arg[9]? arg[9][3] : 0;
a393=a074*a392;
a394=arg[10]? arg[10][10] : 0;
a395=a118*a394;
a393=a393+a395;
a395=arg[10]? arg[10][9] : 0;
a393=a393+a395;
a395=a151*a158;
a396=arg[10]? arg[10][8] : 0;
a397=a034*a396;
a395=a395-a397;
a393=a393+a395;
a395=a119*a393;
a391=a391+a395;
a388=a388*a391;
a387=a387+a388;
a384=a384*a387;
a385=a385/a386;
a385=a385*a390;
a384=a384-a385;
a385=a025<=a195;
a386=a195<=a025;
a386=a386+a385;
a385=a385/a386;
a386=a076*a390;
a387=a078*a384;
a386=a386-a387;
a385=a385*a386;
a386=a197*a385;
a387=2.*a196;
a387=a387*a385;
a388=a196*a387;
a386=a386+a388;
a386=a075*a386;
a388=a199*a386;
a391=a036*a385;
a395=a198*a391;
a388=a388-a395;
a388=a384+a388;
a395=a025<=a080;
a397=a080<=a025;
a397=a397+a395;
a395=a395/a397;
a390=a076*a390;
a384=a078*a384;
a390=a390+a384;
a395=a395*a390;
a390=a201*a395;
a384=2.*a194;
a384=a384*a395;
a397=a194*a384;
a390=a390+a397;
a390=a075*a390;
a397=a203*a390;
a398=a036*a395;
a399=a202*a398;
a397=a397-a399;
a388=a388-a397;
a388=a036*a388;
a397=a204*a388;
a399=arg[10]? arg[10][13] : 0;
a400=a200*a399;
a397=a397+a400;
a400=a030*a397;
a401=a205*a172;
a400=a400+a401;
a401=a207*a400;
a402=arg[10]? arg[10][14] : 0;
a403=a206*a402;
a401=a401+a403;
a403=a191*a401;
a404=a025<=a037;
a405=a037<=a025;
a405=a405+a404;
a404=a404/a405;
a405=a085<=a055;
a406=a055<=a085;
a406=a406+a405;
a405=a405/a406;
a406=a013-a140;
a407=a084*a406;
a408=2.*a148;
a408=a408*a406;
a409=2.*a084;
a408=a408/a409;
a409=a148*a408;
a407=a407+a409;
a407=a407+a167;
a409=a056*a407;
a405=a405*a409;
a404=a404*a405;
a405=a181*a404;
a409=2.*a088;
a409=a409*a404;
a410=a088*a409;
a405=a405+a410;
a405=a009*a405;
a410=a190*a405;
a411=2.*a088;
a411=a411*a404;
a411=a061*a411;
a412=a063*a404;
a411=a411-a412;
a412=a189*a411;
a410=a410+a412;
a412=a025<=a033;
a413=a033<=a025;
a413=a413+a412;
a412=a412/a413;
a412=a412*a407;
a410=a410+a412;
a412=a208*a410;
a403=a403+a412;
a383=a383-a403;
a412=a211<=a214;
a407=a214<=a211;
a413=a407+a412;
a412=a412/a413;
a414=a039<=a212;
a415=a212<=a039;
a416=a414+a415;
a414=a414/a416;
a417=arg[10]? arg[10][22] : 0;
a414=a414*a417;
a415=a415/a416;
a416=arg[10]? arg[10][20] : 0;
a418=arg[10]? arg[10][21] : 0;
a419=a045*a418;
a420=a213*a158;
a419=a419+a420;
a416=a416+a419;
a415=a415*a416;
a414=a414+a415;
a412=a412*a414;
a407=a407/a413;
a407=a407*a417;
a412=a412-a407;
a407=a025<=a216;
a413=a216<=a025;
a413=a413+a407;
a407=a407/a413;
a413=a076*a417;
a414=a078*a412;
a413=a413-a414;
a407=a407*a413;
a413=a218*a407;
a414=2.*a217;
a414=a414*a407;
a415=a217*a414;
a413=a413+a415;
a413=a075*a413;
a415=a220*a413;
a416=a036*a407;
a419=a219*a416;
a415=a415-a419;
a415=a412+a415;
a419=a025<=a210;
a420=a210<=a025;
a420=a420+a419;
a419=a419/a420;
a417=a076*a417;
a412=a078*a412;
a417=a417+a412;
a419=a419*a417;
a417=a222*a419;
a412=2.*a215;
a412=a412*a419;
a420=a215*a412;
a417=a417+a420;
a417=a075*a417;
a420=a224*a417;
a421=a036*a419;
a422=a223*a421;
a420=a420-a422;
a415=a415-a420;
a420=a230*a415;
a422=arg[10]? arg[10][15] : 0;
a423=a036*a422;
a424=a228*a423;
a425=2.*a022;
a140=a013-a140;
a425=a425*a140;
a426=2.*a053;
a162=a017-a162;
a426=a426*a162;
a426=a425+a426;
a427=a226*a426;
a424=a424+a427;
a427=a030*a424;
a428=a229*a172;
a427=a427+a428;
a428=a221*a427;
a420=a420+a428;
a428=a022*a420;
a429=a231*a140;
a428=a428+a429;
a428=a428/a233;
a429=a232/a233;
a430=2.*a233;
a430=a425/a430;
a429=a429*a430;
a428=a428-a429;
a383=a383-a428;
a429=a240*a383;
a431=arg[10]? arg[10][0] : 0;
a432=a235*a431;
a433=sin(a045);
a433=a433*a158;
a434=a234*a433;
a432=a432-a434;
a434=arg[10]? arg[10][4] : 0;
a435=a238*a434;
a436=cos(a045);
a436=a436*a158;
a437=a237*a436;
a435=a435+a437;
a437=a432+a435;
a438=a077*a437;
a429=a429+a438;
a438=a248*a403;
a439=arg[10]? arg[10][28] : 0;
a440=a243*a439;
a441=sin(a045);
a441=a441*a158;
a442=a242*a441;
a440=a440-a442;
a442=arg[10]? arg[10][29] : 0;
a443=a246*a442;
a444=cos(a045);
a444=a444*a158;
a445=a245*a444;
a443=a443+a445;
a445=a440+a443;
a446=a209*a445;
a438=a438+a446;
a446=arg[10]? arg[10][19] : 0;
a447=a230*a446;
a448=a250*a427;
a447=a447+a448;
a448=a252*a447;
a449=arg[10]? arg[10][16] : 0;
a450=arg[10]? arg[10][17] : 0;
a451=a045*a450;
a452=a253*a158;
a451=a451+a452;
a449=a449+a451;
a451=arg[10]? arg[10][18] : 0;
a452=a118*a451;
a453=a254*a392;
a452=a452+a453;
a449=a449+a452;
a452=a251*a449;
a448=a448+a452;
a438=a438+a448;
a448=a255*a166;
a452=arg[10]? arg[10][31] : 0;
a453=a026*a452;
a448=a448+a453;
a453=a257*a448;
a454=sin(a045);
a454=a454*a158;
a455=a256*a454;
a453=a453-a455;
a438=a438+a453;
a429=a429+a438;
a429=a429/a258;
a453=a241/a258;
a455=arg[10]? arg[10][25] : 0;
a456=a129*a455;
a457=sin(a045);
a457=a457*a158;
a458=a058*a457;
a456=a456-a458;
a458=arg[10]? arg[10][30] : 0;
a459=a059*a458;
a460=cos(a045);
a460=a460*a158;
a461=a168*a460;
a459=a459+a461;
a461=a456+a459;
a461=a432-a461;
a461=a461+a435;
a453=a453*a461;
a429=a429-a453;
a381=a381*a429;
a453=a081*a381;
a380=a380+a453;
a378=a378+a380;
a377=a377*a378;
a378=a082*a377;
a376=a376+a378;
a373=a373*a376;
a274=a274-a373;
a373=a273*a274;
a378=a267<=a268;
a268=a268<=a267;
a267=a268+a378;
a378=a378/a267;
a380=a263<=a122;
a263=a122<=a263;
a453=a380+a263;
a380=a380/a453;
a380=a380*a274;
a263=a263/a453;
a453=a137*a013;
a462=sin(a023);
a463=a135*a014;
a464=arg[10]? arg[10][44] : 0;
a465=a069*a464;
a463=a463+a465;
a465=arg[9]? arg[9][7] : 0;
a463=a463+a465;
a465=a136*a463;
a466=arg[10]? arg[10][45] : 0;
a467=a143*a466;
a465=a465-a467;
a462=a462*a465;
a467=a003*a462;
a453=a453-a467;
a467=a182*a153;
a468=a456+a459;
a469=a043*a468;
a467=a467+a469;
a467=a467+a017;
a469=a057*a467;
a470=cos(a023);
a470=a470*a465;
a471=a174*a470;
a469=a469+a471;
a453=a453+a469;
a469=a453/a124;
a471=a122/a124;
a472=2.*a060;
a473=2.*a133;
a474=arg[10]? arg[10][5] : 0;
a473=a473*a474;
a472=a472*a473;
a475=2.*a128;
a476=2.*a134;
a476=a476*a453;
a477=2.*a041;
a478=a104*a467;
a479=sin(a023);
a479=a479*a465;
a480=a174*a479;
a478=a478-a480;
a480=a125*a013;
a481=cos(a023);
a481=a481*a465;
a482=a003*a481;
a480=a480+a482;
a478=a478-a480;
a477=a477*a478;
a476=a476+a477;
a475=a475*a476;
a472=a472+a475;
a475=2.*a127;
a472=a472/a475;
a475=2.*a124;
a475=a472/a475;
a471=a471*a475;
a469=a469-a471;
a263=a263*a469;
a380=a380+a263;
a378=a378*a380;
a268=a268/a267;
a268=a268*a274;
a378=a378-a268;
a268=a272*a378;
a373=a373+a268;
a352=a352*a373;
a373=a302*a352;
a268=2.*a301;
a268=a268*a352;
a267=a301*a268;
a373=a373+a267;
a373=a295*a373;
a267=a294*a373;
a380=a293*a381;
a263=a284*a376;
a471=cos(a023);
a471=a471*a465;
a477=a280*a471;
a480=a278*a455;
a482=cos(a045);
a482=a482*a158;
a483=a058*a482;
a480=a480+a483;
a483=a093*a480;
a484=a279*a183;
a483=a483+a484;
a484=a282*a458;
a281=a281*a183;
a485=sin(a045);
a485=a485*a158;
a485=a093*a485;
a281=a281-a485;
a485=a168*a281;
a484=a484+a485;
a483=a483-a484;
a484=a456+a459;
a484=a098*a484;
a283=a283*a096;
a484=a484+a283;
a483=a483-a484;
a483=a483-a186;
a484=a277*a483;
a477=a477+a484;
a480=a286*a480;
a484=arg[12]? arg[12][35] : 0;
a279=a279*a484;
a480=a480+a279;
a279=a289*a458;
a288=a288*a484;
a283=sin(a045);
a283=a283*a158;
a283=a286*a283;
a288=a288-a283;
a283=a168*a288;
a279=a279+a283;
a480=a480-a279;
a279=arg[12]? arg[12][31] : 0;
a283=a279/a100;
a291=a291/a100;
a291=a291*a187;
a283=a283-a291;
a291=arg[12]? arg[12][28] : 0;
a283=a283+a291;
a480=a480+a283;
a291=a285*a480;
a485=sin(a023);
a485=a485*a465;
a486=a287*a485;
a291=a291-a486;
a477=a477-a291;
a291=arg[12]? arg[12][10] : 0;
a477=a477+a291;
a291=a261*a477;
a263=a263+a291;
a291=a259*a263;
a380=a380+a291;
a291=a025<=a296;
a486=a296<=a025;
a486=a486+a291;
a291=a291/a486;
a486=a273*a274;
a487=a272*a378;
a486=a486-a487;
a291=a291*a486;
a486=a298*a291;
a487=2.*a297;
a487=a487*a291;
a488=a297*a487;
a486=a486+a488;
a486=a295*a486;
a488=a300*a486;
a489=a036*a291;
a490=a299*a489;
a488=a488-a490;
a378=a378+a488;
a373=a304*a373;
a488=a036*a352;
a490=a303*a488;
a373=a373-a490;
a378=a378-a373;
a373=2.*a378;
a373=a357*a373;
a490=a025<=a307;
a307=a307<=a025;
a307=a307+a490;
a490=a490/a307;
a307=a340<=a309;
a309=a309<=a340;
a340=a307+a309;
a307=a307/a340;
a491=2.*a275;
a491=a491*a378;
a306=2.*a306;
a491=a491/a306;
a307=a307*a491;
a309=a309/a340;
a340=a322<=a308;
a308=a308<=a322;
a306=a340+a308;
a340=a340/a306;
a492=arg[10]? arg[10][54] : 0;
a493=a337*a492;
a494=cos(a336);
a495=arg[10]? arg[10][53] : 0;
a496=a335*a495;
a497=arg[10]? arg[10][51] : 0;
a498=a333*a497;
a499=arg[10]? arg[10][52] : 0;
a500=a330*a499;
a501=a328*a497;
a502=a327<=a318;
a503=a318<=a327;
a504=a502+a503;
a502=a502/a504;
a505=a317/a316;
a506=a315*a497;
a507=a011<=a314;
a508=a314<=a011;
a508=a508+a507;
a507=a507/a508;
a507=a507*a499;
a508=2.*a315;
a507=a507/a508;
a508=a312*a507;
a506=a506+a508;
a505=a505*a506;
a502=a502*a505;
a503=a503/a504;
a504=a326<=a317;
a508=a317<=a326;
a509=a504+a508;
a504=a504/a509;
a510=a025<=a319;
a511=a319<=a025;
a511=a511+a510;
a510=a510/a511;
a511=arg[10]? arg[10][46] : 0;
a512=arg[10]? arg[10][47] : 0;
a513=a259*a512;
a514=a320*a381;
a513=a513+a514;
a511=a511+a513;
a510=a510*a511;
a511=a325*a510;
a513=a478/a324;
a514=a325/a324;
a515=2.*a134;
a515=a515*a453;
a516=2.*a133;
a516=a516*a474;
a516=a009*a516;
a515=a515+a516;
a517=2.*a324;
a517=a515/a517;
a514=a514*a517;
a513=a513-a514;
a514=a321*a513;
a511=a511+a514;
a511=a511/a261;
a514=a326/a261;
a514=a514*a376;
a511=a511-a514;
a504=a504*a511;
a508=a508/a509;
a508=a508*a505;
a504=a504-a508;
a503=a503*a504;
a502=a502+a503;
a503=a312*a502;
a501=a501+a503;
a503=casadi_sq(a329);
a503=a055+a503;
a503=a501/a503;
a504=a313*a503;
a500=a500+a504;
a500=a500/a312;
a504=a331/a312;
a504=a504*a497;
a500=a500-a504;
a504=a332*a502;
a508=a328*a499;
a504=a504+a508;
a504=a500-a504;
a508=a312*a504;
a498=a498+a508;
a508=casadi_sq(a334);
a508=a055+a508;
a508=a498/a508;
a509=a311*a508;
a496=a496+a509;
a494=a494*a496;
a509=a310*a494;
a493=a493+a509;
a509=a339*a493;
a514=2.*a041;
a514=a514*a478;
a514=a514+a515;
a515=2.*a339;
a514=a514/a515;
a515=a338*a514;
a509=a509+a515;
a509=a509/a124;
a515=a322/a124;
a515=a515*a475;
a509=a509-a515;
a340=a340*a509;
a308=a308/a306;
a308=a308*a491;
a340=a340-a308;
a309=a309*a340;
a307=a307+a309;
a309=a272*a307;
a340=a273*a491;
a309=a309-a340;
a490=a490*a309;
a309=a344*a490;
a340=2.*a343;
a340=a340*a490;
a308=a343*a340;
a309=a309+a308;
a309=a295*a309;
a308=a351*a309;
a306=a350*a381;
a515=a349*a376;
a518=a346*a483;
a519=sin(a023);
a519=a519*a465;
a520=a280*a519;
a518=a518-a520;
a520=cos(a023);
a520=a520*a465;
a521=a287*a520;
a522=a348*a480;
a521=a521+a522;
a518=a518+a521;
a521=arg[12]? arg[12][11] : 0;
a518=a518+a521;
a521=a132*a518;
a522=a347*a466;
a521=a521-a522;
a522=a261*a521;
a515=a515+a522;
a522=a259*a515;
a306=a306+a522;
a522=a345*a306;
a308=a308+a522;
a308=a036*a308;
a340=a354*a340;
a522=a353*a306;
a523=a036*a490;
a524=a351*a523;
a522=a522-a524;
a522=a295*a522;
a344=a344*a522;
a340=a340+a344;
a308=a308-a340;
a340=2.*a490;
a356=a356*a340;
a354=a354*a490;
a343=a343*a522;
a354=a354+a343;
a355=a355*a354;
a356=a356+a355;
a308=a308-a356;
a342=a342*a308;
a308=a273*a342;
a356=a025<=a358;
a358=a358<=a025;
a358=a358+a356;
a356=a356/a358;
a358=a273*a491;
a355=a272*a307;
a358=a358+a355;
a356=a356*a358;
a358=a036*a356;
a355=a351*a358;
a354=a362*a306;
a355=a355+a354;
a355=a295*a355;
a354=a361*a355;
a343=2.*a360;
a343=a343*a356;
a522=a363*a343;
a354=a354-a522;
a522=a365*a306;
a361=a361*a356;
a343=a360*a343;
a361=a361+a343;
a361=a295*a361;
a351=a351*a361;
a522=a522-a351;
a522=a036*a522;
a354=a354-a522;
a522=-a356;
a522=2.*a522;
a367=a367*a522;
a360=a360*a355;
a363=a363*a356;
a360=a360-a363;
a366=a366*a360;
a367=a367+a366;
a354=a354+a367;
a359=a359*a354;
a354=a273*a359;
a308=a308+a354;
a342=a272*a342;
a342=a342+a306;
a359=a272*a359;
a342=a342-a359;
a371=a371*a342;
a368=a368*a371;
a372=a372*a342;
a368=a368-a372;
a308=a308+a368;
a308=a308/a374;
a357=a357/a374;
a491=-a491;
a491=2.*a491;
a357=a357*a491;
a308=a308-a357;
a305=a305*a308;
a373=a373+a305;
a380=a380-a373;
a373=a303*a380;
a267=a267+a373;
a267=a036*a267;
a373=a304*a294;
a373=a295*a373;
a268=a373*a268;
a304=a304*a380;
a488=a294*a488;
a304=a304-a488;
a304=a295*a304;
a488=a302*a304;
a268=a268+a488;
a267=a267-a268;
a268=a301*a373;
a488=2.*a352;
a488=a268*a488;
a305=2.*a301;
a352=a373*a352;
a301=a301*a304;
a352=a352+a301;
a352=a305*a352;
a488=a488+a352;
a267=a267-a488;
a267=a276*a267;
a488=a272*a267;
a488=a488+a380;
a352=a025<=a296;
a296=a296<=a025;
a296=a296+a352;
a352=a352/a296;
a296=a300*a294;
a296=a295*a296;
a487=a296*a487;
a300=a300*a380;
a489=a294*a489;
a300=a300-a489;
a300=a295*a300;
a489=a298*a300;
a487=a487+a489;
a486=a294*a486;
a380=a299*a380;
a486=a486+a380;
a486=a036*a486;
a487=a487-a486;
a486=a297*a296;
a380=2.*a291;
a380=a486*a380;
a489=2.*a297;
a291=a296*a291;
a297=a297*a300;
a291=a291+a297;
a291=a489*a291;
a380=a380+a291;
a487=a487+a380;
a487=a352*a487;
a380=a272*a487;
a488=a488-a380;
a380=a269*a488;
a291=a264*a380;
a297=a291/a124;
a303=a303*a294;
a303=a036*a303;
a302=a302*a373;
a303=a303-a302;
a305=a305*a268;
a303=a303-a305;
a276=a276*a303;
a303=a272*a276;
a303=a303+a294;
a298=a298*a296;
a299=a299*a294;
a299=a036*a299;
a298=a298-a299;
a489=a489*a486;
a298=a298+a489;
a352=a352*a298;
a298=a272*a352;
a303=a303-a298;
a269=a269*a303;
a264=a264*a269;
a298=a264/a124;
a489=a298/a124;
a489=a489*a475;
a297=a297-a489;
a128=2.*a128;
a322=a322/a124;
a369=a369/a370;
a364=a369*a364;
a370=a322*a364;
a122=a122/a124;
a489=a122*a264;
a370=a370+a489;
a489=2.*a124;
a370=a370/a489;
a127=2.*a127;
a486=a370/a127;
a299=a128*a486;
a294=2.*a453;
a294=a299*a294;
a296=2.*a134;
a476=2.*a476;
a476=a486*a476;
a509=a509/a124;
a305=a322/a124;
a305=a305*a475;
a509=a509-a305;
a509=a364*a509;
a369=a369*a371;
a322=a322*a369;
a509=a509+a322;
a469=a469/a124;
a322=a122/a124;
a322=a322*a475;
a469=a469-a322;
a264=a264*a469;
a122=a122*a291;
a264=a264+a122;
a509=a509+a264;
a509=a509/a489;
a370=a370/a489;
a489=2.*a475;
a370=a370*a489;
a509=a509-a370;
a509=a509/a127;
a127=a486/a127;
a472=2.*a472;
a127=a127*a472;
a509=a509-a127;
a128=a128*a509;
a476=a476+a128;
a128=a296*a476;
a294=a294+a128;
a297=a297-a294;
a364=a364/a124;
a294=a338*a364;
a128=2.*a339;
a294=a294/a128;
a127=a325/a324;
a472=a326<=a317;
a370=a317<=a326;
a489=a472+a370;
a472=a472/a489;
a264=a318<=a327;
a327=a327<=a318;
a318=a327+a264;
a264=a264/a318;
a122=cos(a336);
a291=a339*a364;
a469=a310*a291;
a322=a122*a469;
a371=a311*a322;
a305=casadi_sq(a334);
a305=a055+a305;
a371=a371/a305;
a268=a313*a371;
a302=casadi_sq(a329);
a302=a055+a302;
a268=a268/a302;
a373=a312*a268;
a300=a312*a371;
a301=a332*a300;
a373=a373-a301;
a301=a264*a373;
a304=a472*a301;
a308=a304/a261;
a357=a321*a308;
a491=arg[4]? arg[4][9] : 0;
a374=casadi_sq(a325);
a374=a055+a374;
a491=a491/a374;
a357=a357+a491;
a368=a127*a357;
a372=2.*a324;
a368=a368/a372;
a342=a294-a368;
a453=2.*a453;
a453=a342*a453;
a134=2.*a134;
a493=a364*a493;
a369=a369/a124;
a124=a364/a124;
a124=a124*a475;
a369=a369-a124;
a338=a338*a369;
a493=a493+a338;
a493=a493/a128;
a128=a294/a128;
a338=2.*a514;
a128=a128*a338;
a493=a493-a128;
a128=a513/a324;
a338=a127/a324;
a338=a338*a517;
a128=a128-a338;
a128=a357*a128;
a510=a308*a510;
a338=a268*a497;
a124=a371*a499;
a495=a322*a495;
a492=a291*a492;
a364=a364*a514;
a339=a339*a369;
a364=a364+a339;
a310=a310*a364;
a492=a492+a310;
a122=a122*a492;
a336=sin(a336);
a336=a336*a496;
a469=a469*a336;
a122=a122-a469;
a311=a311*a122;
a495=a495+a311;
a495=a495/a305;
a305=a371/a305;
a334=2.*a334;
a334=a334*a498;
a305=a305*a334;
a495=a495-a305;
a313=a313*a495;
a124=a124+a313;
a124=a124/a302;
a302=a268/a302;
a329=2.*a329;
a329=a329*a501;
a302=a302*a329;
a124=a124-a302;
a302=a312*a124;
a338=a338+a302;
a499=a300*a499;
a302=a371*a497;
a329=a312*a495;
a302=a302+a329;
a332=a332*a302;
a499=a499+a332;
a338=a338-a499;
a264=a264*a338;
a472=a472*a264;
a499=a472/a261;
a332=a308/a261;
a332=a332*a376;
a499=a499-a332;
a321=a321*a499;
a510=a510+a321;
a321=arg[12]? arg[12][9] : 0;
a321=a321/a374;
a491=a491/a374;
a374=2.*a325;
a374=a374*a513;
a491=a491*a374;
a321=a321-a491;
a510=a510+a321;
a127=a127*a510;
a128=a128+a127;
a128=a128/a372;
a368=a368/a372;
a372=2.*a517;
a368=a368*a372;
a128=a128-a368;
a128=a493-a128;
a368=a134*a128;
a453=a453+a368;
a297=a297+a453;
a137=a137*a297;
a296=a296*a299;
a298=a298-a296;
a134=a134*a342;
a298=a298+a134;
a462=a298*a462;
a137=a137-a462;
a001=a001+a137;
a137=2.*a041;
a462=a137*a294;
a041=2.*a041;
a134=a041*a299;
a462=a462-a134;
a357=a357/a324;
a462=a462+a357;
a481=a462*a481;
a134=2.*a478;
a294=a294*a134;
a137=a137*a493;
a294=a294+a137;
a478=2.*a478;
a299=a299*a478;
a041=a041*a476;
a299=a299+a041;
a294=a294-a299;
a510=a510/a324;
a357=a357/a324;
a357=a357*a517;
a510=a510-a357;
a294=a294+a510;
a125=a125*a294;
a481=a481+a125;
a001=a001-a481;
a481=arg[2]? arg[2][2] : 0;
a125=cos(a481);
a510=a036*a043;
a357=arg[2]? arg[2][3] : 0;
a517=a510*a357;
a324=a003-a517;
a299=a324*a125;
a041=a236+a239;
a476=a043*a041;
a476=a476+a006;
a478=sin(a481);
a137=a476*a478;
a299=a299-a137;
a493=casadi_sq(a133);
a134=casadi_sq(a493);
a296=casadi_sq(a299);
a453=cos(a481);
a368=a476*a453;
a372=a003-a517;
a127=sin(a481);
a321=a372*a127;
a368=a368+a321;
a321=casadi_sq(a368);
a296=a296+a321;
a321=casadi_sq(a296);
a134=a134+a321;
a134=sqrt(a134);
a321=sqrt(a134);
a491=a299/a321;
a374=arg[1]? arg[1][5] : 0;
a332=arg[2]? arg[2][42] : 0;
a329=arg[2]? arg[2][34] : 0;
a501=arg[2]? arg[2][35] : 0;
a164=a164+a062;
a062=a077*a164;
a062=a062+a249;
a062=a036*a062;
a062=a062/a258;
a249=-a062;
a313=casadi_fmax(a025,a249);
a305=a501*a313;
a305=a329+a305;
a334=casadi_fmax(a073,a305);
a498=a332*a334;
a311=arg[2]? arg[2][43] : 0;
a469=a498-a311;
a336=a374*a469;
a336=a336+a311;
a336=a336/a498;
a311=a336+a262;
a496=a491<=a311;
a492=a311<=a491;
a310=a492+a496;
a496=a496/a310;
a339=-a311;
a369=casadi_fmin(a311,a491);
a514=a339<=a369;
a475=a369<=a339;
a359=a475+a514;
a514=a514/a359;
a306=a273*a336;
a354=casadi_fmax(a339,a369);
a367=a272*a354;
a306=a306+a367;
a306=a306+a036;
a367=a025<=a306;
a366=a306<=a025;
a366=a366+a367;
a367=a367/a366;
a366=sin(a481);
a360=cos(a045);
a363=a360*a093;
a356=a237*a363;
a355=sin(a045);
a522=a234*a355;
a351=a522*a093;
a356=a356-a351;
a351=a236+a239;
a343=a351*a098;
a356=a356+a343;
a356=a356+a102;
a343=a366*a356;
a490=cos(a481);
a340=cos(a045);
a344=a237*a340;
a524=a344*a286;
a525=a522*a286;
a524=a524-a525;
a525=a357*a098;
a525=a036*a525;
a524=a524+a525;
a524=a524-a292;
a525=a490*a524;
a343=a343+a525;
a525=arg[4]? arg[4][6] : 0;
a343=a343+a525;
a525=a498*a343;
a526=a313*a525;
a527=a273*a336;
a528=a272*a354;
a527=a527-a528;
a527=a527+a036;
a528=casadi_fmax(a025,a527);
a529=casadi_sq(a528);
a530=a528*a529;
a530=a295*a530;
a531=a036*a528;
a531=a055-a531;
a532=a530*a531;
a354=a354+a532;
a532=casadi_fmax(a025,a306);
a533=casadi_sq(a532);
a534=a532*a533;
a534=a295*a534;
a535=a036*a532;
a535=a055-a535;
a536=a534*a535;
a354=a354-a536;
a536=2.*a354;
a537=casadi_sq(a354);
a537=a055-a537;
a537=sqrt(a537);
a538=a273*a537;
a539=a537+a262;
a540=-a539;
a541=2.0000000000000000e-02;
a542=50.;
a543=a542*a374;
a544=arg[2]? arg[2][40] : 0;
a545=arg[2]? arg[2][39] : 0;
a546=arg[2]? arg[2][37] : 0;
a547=arg[2]? arg[2][38] : 0;
a548=a547-a055;
a549=casadi_fmax(a011,a548);
a549=sqrt(a549);
a550=a546*a549;
a551=1./a550;
a552=-a551;
a553=arg[2]? arg[2][32] : 0;
a554=arg[2]? arg[2][33] : 0;
a555=a554*a313;
a555=a553+a555;
a556=casadi_fmax(a025,a555);
a557=casadi_sq(a299);
a557=a557+a323;
a558=sqrt(a557);
a559=a368/a558;
a560=a556*a559;
a560=a560/a498;
a561=casadi_fmin(a560,a551);
a562=casadi_fmax(a552,a561);
a563=a055-a547;
a564=a562*a563;
a565=a546*a562;
a566=atan(a565);
a567=a547*a566;
a567=a567/a546;
a564=a564+a567;
a568=a546*a564;
a569=atan(a568);
a570=a545*a569;
a571=sin(a570);
a572=a544*a571;
a573=casadi_sq(a368);
a573=a573+a557;
a573=sqrt(a573);
a557=a572*a573;
a574=a368*a557;
a574=a574/a134;
a575=a574+a011;
a576=casadi_sq(a368);
a576=a576/a134;
a577=4.9999999999999999e-13;
a578=a576+a577;
a575=a575/a578;
a579=a542*a575;
a543=a543-a579;
a579=casadi_fmin(a055,a543);
a580=casadi_fmax(a025,a579);
a581=casadi_sq(a580);
a582=a580*a581;
a582=a541*a582;
a583=casadi_sq(a580);
a583=a061*a583;
a584=a063*a580;
a583=a583-a584;
a583=a583+a064;
a584=a582*a583;
a585=a374-a575;
a585=a585-a541;
a586=casadi_fmax(a025,a585);
a584=a584+a586;
a586=a368*a584;
a586=a586/a321;
a587=a557/a321;
a588=a586+a587;
a589=casadi_fmin(a588,a539);
a590=casadi_fmax(a540,a589);
a591=a272*a590;
a538=a538+a591;
a538=a538+a036;
a591=a025<=a538;
a592=a538<=a025;
a592=a592+a591;
a591=a591/a592;
a592=casadi_fmax(a025,a538);
a593=casadi_sq(a592);
a594=a592*a593;
a594=a295*a594;
a595=sin(a481);
a596=a595*a524;
a597=cos(a481);
a598=a597*a356;
a596=a596-a598;
a598=arg[4]? arg[4][7] : 0;
a596=a596+a598;
a598=a498*a596;
a599=a313*a598;
a600=a594*a599;
a600=a036*a600;
a601=a036*a592;
a601=a055-a601;
a602=a601*a599;
a602=a295*a602;
a603=a593*a602;
a600=a600-a603;
a603=2.*a592;
a604=a592*a602;
a605=a603*a604;
a600=a600-a605;
a600=a591*a600;
a605=a273*a600;
a606=a273*a537;
a607=a272*a590;
a606=a606-a607;
a606=a606+a036;
a607=a025<=a606;
a608=a606<=a025;
a608=a608+a607;
a607=a607/a608;
a608=casadi_fmax(a025,a606);
a609=casadi_sq(a608);
a610=a036*a608;
a610=a055-a610;
a611=a610*a599;
a611=a295*a611;
a612=a609*a611;
a613=a608*a609;
a613=a295*a613;
a614=a613*a599;
a614=a036*a614;
a612=a612-a614;
a614=2.*a608;
a615=a608*a611;
a616=a614*a615;
a612=a612+a616;
a612=a607*a612;
a616=a273*a612;
a605=a605+a616;
a616=a539<=a588;
a617=a588<=a539;
a618=a617+a616;
a616=a616/a618;
a619=a540<=a589;
a620=a589<=a540;
a621=a620+a619;
a619=a619/a621;
a600=a272*a600;
a600=a600+a599;
a612=a272*a612;
a600=a600-a612;
a612=a619*a600;
a622=a616*a612;
a620=a620/a621;
a600=a620*a600;
a622=a622-a600;
a605=a605+a622;
a622=2.*a537;
a605=a605/a622;
a600=a536*a605;
a526=a526-a600;
a600=a025<=a306;
a306=a306<=a025;
a306=a306+a600;
a600=a600/a306;
a306=arg[9]? arg[9][5] : 0;
a621=a469*a306;
a623=arg[10]? arg[10][42] : 0;
a624=a334*a623;
a625=a073<=a305;
a626=a305<=a073;
a626=a626+a625;
a625=a625/a626;
a626=arg[10]? arg[10][34] : 0;
a627=arg[10]? arg[10][35] : 0;
a628=a313*a627;
a629=a025<=a249;
a630=a249<=a025;
a630=a630+a629;
a629=a629/a630;
a630=a164*a383;
a456=a456+a459;
a459=a077*a456;
a630=a630+a459;
a630=a630+a438;
a630=a036*a630;
a630=a630/a258;
a438=a062/a258;
a438=a438*a461;
a630=a630-a438;
a629=a629*a630;
a438=a501*a629;
a628=a628-a438;
a628=a626+a628;
a625=a625*a628;
a628=a332*a625;
a624=a624+a628;
a628=arg[10]? arg[10][43] : 0;
a438=a624-a628;
a459=a374*a438;
a621=a621+a459;
a621=a621+a628;
a621=a621/a498;
a628=a336/a498;
a628=a628*a624;
a621=a621-a628;
a628=a273*a621;
a459=a339<=a369;
a369=a369<=a339;
a339=a369+a459;
a459=a459/a339;
a631=a311<=a491;
a311=a491<=a311;
a632=a631+a311;
a631=a631/a632;
a631=a631*a621;
a311=a311/a632;
a632=a036*a153;
a633=a357*a632;
a634=arg[10]? arg[10][3] : 0;
a635=a510*a634;
a633=a633+a635;
a635=a013-a633;
a636=a125*a635;
a637=sin(a481);
a638=arg[10]? arg[10][2] : 0;
a637=a637*a638;
a639=a324*a637;
a636=a636-a639;
a639=a041*a153;
a640=a432+a435;
a641=a043*a640;
a639=a639+a641;
a639=a639+a017;
a641=a478*a639;
a642=cos(a481);
a642=a642*a638;
a643=a476*a642;
a641=a641+a643;
a636=a636-a641;
a643=a636/a321;
a644=a491/a321;
a645=2.*a493;
a646=2.*a133;
a646=a646*a474;
a645=a645*a646;
a647=2.*a296;
a648=2.*a299;
a648=a648*a636;
a649=2.*a368;
a650=a453*a639;
a651=sin(a481);
a651=a651*a638;
a652=a476*a651;
a650=a650-a652;
a652=a013-a633;
a653=a127*a652;
a654=cos(a481);
a654=a654*a638;
a655=a372*a654;
a653=a653+a655;
a650=a650+a653;
a649=a649*a650;
a648=a648+a649;
a647=a647*a648;
a645=a645+a647;
a647=2.*a134;
a645=a645/a647;
a647=2.*a321;
a647=a645/a647;
a644=a644*a647;
a643=a643-a644;
a311=a311*a643;
a631=a631+a311;
a459=a459*a631;
a369=a369/a339;
a369=a369*a621;
a459=a459-a369;
a369=a272*a459;
a628=a628+a369;
a600=a600*a628;
a628=a533*a600;
a369=2.*a532;
a369=a369*a600;
a339=a532*a369;
a628=a628+a339;
a628=a295*a628;
a339=a526*a628;
a631=a343*a624;
a311=cos(a481);
a311=a311*a638;
a644=a356*a311;
a649=a363*a434;
a360=a360*a183;
a653=sin(a045);
a653=a653*a158;
a653=a093*a653;
a360=a360-a653;
a653=a237*a360;
a649=a649+a653;
a653=a355*a431;
a655=cos(a045);
a655=a655*a158;
a656=a234*a655;
a653=a653+a656;
a656=a093*a653;
a657=a522*a183;
a656=a656+a657;
a649=a649-a656;
a656=a432+a435;
a656=a098*a656;
a351=a351*a096;
a656=a656+a351;
a649=a649+a656;
a649=a649+a186;
a656=a366*a649;
a644=a644+a656;
a656=a340*a434;
a351=sin(a045);
a351=a351*a158;
a657=a237*a351;
a656=a656-a657;
a657=a286*a656;
a658=a344*a484;
a657=a657+a658;
a658=a286*a653;
a659=a522*a484;
a658=a658+a659;
a657=a657-a658;
a658=a098*a634;
a659=a357*a096;
a658=a658+a659;
a658=a036*a658;
a657=a657+a658;
a657=a657-a283;
a658=a490*a657;
a659=sin(a481);
a659=a659*a638;
a660=a524*a659;
a658=a658-a660;
a644=a644+a658;
a658=arg[12]? arg[12][6] : 0;
a644=a644+a658;
a658=a498*a644;
a631=a631+a658;
a658=a313*a631;
a660=a525*a629;
a658=a658-a660;
a660=a025<=a527;
a661=a527<=a025;
a661=a661+a660;
a660=a660/a661;
a661=a273*a621;
a662=a272*a459;
a661=a661-a662;
a660=a660*a661;
a661=a529*a660;
a662=2.*a528;
a662=a662*a660;
a663=a528*a662;
a661=a661+a663;
a661=a295*a661;
a663=a531*a661;
a664=a036*a660;
a665=a530*a664;
a663=a663-a665;
a459=a459+a663;
a628=a535*a628;
a663=a036*a600;
a665=a534*a663;
a628=a628-a665;
a459=a459-a628;
a628=2.*a459;
a628=a605*a628;
a665=a025<=a538;
a538=a538<=a025;
a538=a538+a665;
a665=a665/a538;
a538=a589<=a540;
a540=a540<=a589;
a589=a538+a540;
a538=a538/a589;
a666=2.*a354;
a666=a666*a459;
a537=2.*a537;
a666=a666/a537;
a538=a538*a666;
a540=a540/a589;
a589=a588<=a539;
a539=a539<=a588;
a588=a589+a539;
a589=a589/a588;
a537=a584*a650;
a667=a025<=a579;
a668=a579<=a025;
a668=a668+a667;
a667=a667/a668;
a668=a543<=a055;
a669=a055<=a543;
a669=a669+a668;
a668=a668/a669;
a669=a542*a306;
a670=a557*a650;
a671=arg[10]? arg[10][40] : 0;
a672=a571*a671;
a673=cos(a570);
a674=arg[10]? arg[10][39] : 0;
a675=a569*a674;
a676=arg[10]? arg[10][37] : 0;
a677=a564*a676;
a678=a561<=a552;
a679=a552<=a561;
a680=a678+a679;
a678=a678/a680;
a681=a551/a550;
a682=a549*a676;
a683=a011<=a548;
a684=a548<=a011;
a684=a684+a683;
a683=a683/a684;
a684=arg[10]? arg[10][38] : 0;
a683=a683*a684;
a685=2.*a549;
a683=a683/a685;
a685=a546*a683;
a682=a682+a685;
a681=a681*a682;
a678=a678*a681;
a679=a679/a680;
a680=a560<=a551;
a685=a551<=a560;
a686=a680+a685;
a680=a680/a686;
a687=a025<=a555;
a688=a555<=a025;
a688=a688+a687;
a687=a687/a688;
a688=arg[10]? arg[10][32] : 0;
a689=arg[10]? arg[10][33] : 0;
a690=a313*a689;
a691=a554*a629;
a690=a690-a691;
a690=a688+a690;
a687=a687*a690;
a690=a559*a687;
a691=a650/a558;
a692=a559/a558;
a693=2.*a299;
a693=a693*a636;
a693=a693+a516;
a694=2.*a558;
a694=a693/a694;
a692=a692*a694;
a691=a691-a692;
a692=a556*a691;
a690=a690+a692;
a690=a690/a498;
a692=a560/a498;
a692=a692*a624;
a690=a690-a692;
a680=a680*a690;
a685=a685/a686;
a685=a685*a681;
a680=a680-a685;
a679=a679*a680;
a678=a678+a679;
a679=a563*a678;
a680=a562*a684;
a679=a679-a680;
a680=a566*a684;
a685=a562*a676;
a686=a546*a678;
a685=a685+a686;
a686=casadi_sq(a565);
a686=a055+a686;
a686=a685/a686;
a692=a547*a686;
a680=a680+a692;
a680=a680/a546;
a692=a567/a546;
a692=a692*a676;
a680=a680-a692;
a679=a679+a680;
a692=a546*a679;
a677=a677+a692;
a692=casadi_sq(a568);
a692=a055+a692;
a692=a677/a692;
a695=a545*a692;
a675=a675+a695;
a673=a673*a675;
a695=a544*a673;
a672=a672+a695;
a695=a573*a672;
a696=2.*a368;
a696=a696*a650;
a696=a696+a693;
a693=2.*a573;
a696=a696/a693;
a693=a572*a696;
a695=a695+a693;
a693=a368*a695;
a670=a670+a693;
a670=a670/a134;
a693=a574/a134;
a693=a693*a645;
a670=a670-a693;
a693=a670/a578;
a697=a575/a578;
a698=2.*a368;
a698=a698*a650;
a698=a698/a134;
a699=a576/a134;
a699=a699*a645;
a698=a698-a699;
a697=a697*a698;
a693=a693-a697;
a697=a542*a693;
a669=a669-a697;
a668=a668*a669;
a667=a667*a668;
a668=a581*a667;
a669=2.*a580;
a669=a669*a667;
a697=a580*a669;
a668=a668+a697;
a668=a541*a668;
a697=a583*a668;
a699=2.*a580;
a699=a699*a667;
a699=a061*a699;
a700=a063*a667;
a699=a699-a700;
a700=a582*a699;
a697=a697+a700;
a700=a025<=a585;
a701=a585<=a025;
a701=a701+a700;
a700=a700/a701;
a701=a306-a693;
a700=a700*a701;
a697=a697+a700;
a700=a368*a697;
a537=a537+a700;
a537=a537/a321;
a700=a586/a321;
a700=a700*a647;
a537=a537-a700;
a700=a695/a321;
a701=a587/a321;
a701=a701*a647;
a700=a700-a701;
a701=a537+a700;
a589=a589*a701;
a539=a539/a588;
a539=a539*a666;
a589=a589-a539;
a540=a540*a589;
a538=a538+a540;
a540=a272*a538;
a589=a273*a666;
a540=a540-a589;
a665=a665*a540;
a540=a593*a665;
a589=2.*a592;
a589=a589*a665;
a539=a592*a589;
a540=a540+a539;
a540=a295*a540;
a539=a599*a540;
a588=a596*a624;
a701=cos(a481);
a701=a701*a638;
a702=a524*a701;
a703=a595*a657;
a702=a702+a703;
a703=a597*a649;
a704=sin(a481);
a704=a704*a638;
a705=a356*a704;
a703=a703-a705;
a702=a702-a703;
a703=arg[12]? arg[12][7] : 0;
a702=a702+a703;
a703=a498*a702;
a588=a588+a703;
a703=a313*a588;
a705=a598*a629;
a703=a703-a705;
a705=a594*a703;
a539=a539+a705;
a539=a036*a539;
a589=a602*a589;
a705=a601*a703;
a706=a036*a665;
a707=a599*a706;
a705=a705-a707;
a705=a295*a705;
a593=a593*a705;
a589=a589+a593;
a539=a539-a589;
a589=2.*a665;
a604=a604*a589;
a602=a602*a665;
a592=a592*a705;
a602=a602+a592;
a603=a603*a602;
a604=a604+a603;
a539=a539-a604;
a591=a591*a539;
a539=a273*a591;
a604=a025<=a606;
a606=a606<=a025;
a606=a606+a604;
a604=a604/a606;
a606=a273*a666;
a603=a272*a538;
a606=a606+a603;
a604=a604*a606;
a606=a036*a604;
a603=a599*a606;
a602=a610*a703;
a603=a603+a602;
a603=a295*a603;
a602=a609*a603;
a592=2.*a608;
a592=a592*a604;
a705=a611*a592;
a602=a602-a705;
a705=a613*a703;
a609=a609*a604;
a592=a608*a592;
a609=a609+a592;
a609=a295*a609;
a599=a599*a609;
a705=a705-a599;
a705=a036*a705;
a602=a602-a705;
a705=-a604;
a705=2.*a705;
a615=a615*a705;
a608=a608*a603;
a611=a611*a604;
a608=a608-a611;
a614=a614*a608;
a615=a615+a614;
a602=a602+a615;
a607=a607*a602;
a602=a273*a607;
a539=a539+a602;
a591=a272*a591;
a591=a591+a703;
a607=a272*a607;
a591=a591-a607;
a619=a619*a591;
a616=a616*a619;
a620=a620*a591;
a616=a616-a620;
a539=a539+a616;
a539=a539/a622;
a605=a605/a622;
a666=-a666;
a666=2.*a666;
a605=a605*a666;
a539=a539-a605;
a536=a536*a539;
a628=a628+a536;
a658=a658-a628;
a628=a534*a658;
a339=a339+a628;
a339=a036*a339;
a628=a535*a526;
a628=a295*a628;
a369=a628*a369;
a535=a535*a658;
a663=a526*a663;
a535=a535-a663;
a535=a295*a535;
a663=a533*a535;
a369=a369+a663;
a339=a339-a369;
a369=a532*a628;
a663=2.*a600;
a663=a369*a663;
a536=2.*a532;
a600=a628*a600;
a532=a532*a535;
a600=a600+a532;
a600=a536*a600;
a663=a663+a600;
a339=a339-a663;
a339=a367*a339;
a663=a272*a339;
a663=a663+a658;
a600=a025<=a527;
a527=a527<=a025;
a527=a527+a600;
a600=a600/a527;
a527=a531*a526;
a527=a295*a527;
a662=a527*a662;
a531=a531*a658;
a664=a526*a664;
a531=a531-a664;
a531=a295*a531;
a664=a529*a531;
a662=a662+a664;
a661=a526*a661;
a658=a530*a658;
a661=a661+a658;
a661=a036*a661;
a662=a662-a661;
a661=a528*a527;
a658=2.*a660;
a658=a661*a658;
a664=2.*a528;
a660=a527*a660;
a528=a528*a531;
a660=a660+a528;
a660=a664*a660;
a658=a658+a660;
a662=a662+a658;
a662=a600*a662;
a658=a272*a662;
a663=a663-a658;
a658=a514*a663;
a660=a496*a658;
a528=a660/a321;
a534=a534*a526;
a534=a036*a534;
a533=a533*a628;
a534=a534-a533;
a536=a536*a369;
a534=a534-a536;
a367=a367*a534;
a534=a272*a367;
a534=a534+a526;
a529=a529*a527;
a530=a530*a526;
a530=a036*a530;
a529=a529-a530;
a664=a664*a661;
a529=a529+a664;
a600=a600*a529;
a529=a272*a600;
a534=a534-a529;
a514=a514*a534;
a496=a496*a514;
a529=a496/a321;
a664=a529/a321;
a664=a664*a647;
a528=a528-a664;
a296=2.*a296;
a574=a574/a134;
a664=a025<=a585;
a585=a585<=a025;
a585=a585+a664;
a664=a664/a585;
a617=a617/a618;
a612=a617*a612;
a618=a612/a321;
a585=a368*a618;
a661=a664*a585;
a530=a543<=a055;
a543=a055<=a543;
a543=a543+a530;
a530=a530/a543;
a543=a025<=a579;
a579=a579<=a025;
a579=a579+a543;
a543=a543/a579;
a579=2.*a580;
a526=a582*a585;
a527=a061*a526;
a536=a579*a527;
a526=a063*a526;
a536=a536-a526;
a526=a583*a585;
a526=a541*a526;
a369=a581*a526;
a536=a536+a369;
a369=2.*a580;
a533=a580*a526;
a628=a369*a533;
a536=a536+a628;
a536=a543*a536;
a536=a530*a536;
a536=a542*a536;
a661=a661+a536;
a536=a661/a578;
a628=a574*a536;
a576=a576/a134;
a575=a575/a578;
a531=a575*a661;
a532=a576*a531;
a628=a628-a532;
a587=a587/a321;
a532=a587*a612;
a586=a586/a321;
a535=a586*a612;
a532=a532+a535;
a491=a491/a321;
a535=a491*a496;
a532=a532+a535;
a535=2.*a321;
a532=a532/a535;
a628=a628-a532;
a539=2.*a134;
a628=a628/a539;
a605=a296*a628;
a666=2.*a636;
a666=a605*a666;
a622=2.*a299;
a648=2.*a648;
a648=a628*a648;
a670=a670/a134;
a616=a574/a134;
a616=a616*a645;
a670=a670-a616;
a670=a536*a670;
a616=a618*a650;
a617=a617*a619;
a619=a617/a321;
a620=a618/a321;
a620=a620*a647;
a619=a619-a620;
a620=a368*a619;
a616=a616+a620;
a664=a664*a616;
a620=2.*a667;
a527=a527*a620;
a668=a585*a668;
a582=a582*a616;
a668=a668+a582;
a582=a061*a668;
a579=a579*a582;
a527=a527+a579;
a668=a063*a668;
a527=a527-a668;
a669=a526*a669;
a585=a585*a699;
a583=a583*a616;
a585=a585+a583;
a585=a541*a585;
a581=a581*a585;
a669=a669+a581;
a527=a527+a669;
a669=2.*a667;
a533=a533*a669;
a526=a526*a667;
a580=a580*a585;
a526=a526+a580;
a369=a369*a526;
a533=a533+a369;
a527=a527+a533;
a543=a543*a527;
a530=a530*a543;
a543=a542*a530;
a543=a664+a543;
a527=a543/a578;
a533=a536/a578;
a533=a533*a698;
a527=a527-a533;
a574=a574*a527;
a670=a670+a574;
a574=a698/a134;
a533=a576/a134;
a533=a533*a645;
a574=a574-a533;
a574=a531*a574;
a693=a693/a578;
a578=a575/a578;
a578=a578*a698;
a693=a693-a578;
a661=a661*a693;
a575=a575*a543;
a661=a661+a575;
a576=a576*a661;
a574=a574+a576;
a670=a670-a574;
a700=a700/a321;
a574=a587/a321;
a574=a574*a647;
a700=a700-a574;
a700=a612*a700;
a587=a587*a617;
a700=a700+a587;
a537=a537/a321;
a587=a586/a321;
a587=a587*a647;
a537=a537-a587;
a537=a612*a537;
a586=a586*a617;
a537=a537+a586;
a700=a700+a537;
a643=a643/a321;
a537=a491/a321;
a537=a537*a647;
a643=a643-a537;
a496=a496*a643;
a491=a491*a660;
a496=a496+a491;
a700=a700+a496;
a700=a700/a535;
a532=a532/a535;
a535=2.*a647;
a532=a532*a535;
a700=a700-a532;
a670=a670-a700;
a670=a670/a539;
a539=a628/a539;
a700=2.*a645;
a539=a539*a700;
a670=a670-a539;
a296=a296*a670;
a648=a648+a296;
a296=a622*a648;
a666=a666+a296;
a528=a528+a666;
a612=a612/a321;
a536=a536/a134;
a666=a368*a536;
a666=a612-a666;
a296=a572*a666;
a539=2.*a573;
a296=a296/a539;
a700=a559/a558;
a532=a560<=a551;
a535=a551<=a560;
a496=a532+a535;
a532=a532/a496;
a491=a552<=a561;
a561=a561<=a552;
a552=a561+a491;
a491=a491/a552;
a660=cos(a570);
a643=a573*a666;
a537=a544*a643;
a586=a660*a537;
a587=a545*a586;
a574=casadi_sq(a568);
a574=a055+a574;
a587=a587/a574;
a576=a547*a587;
a575=casadi_sq(a565);
a575=a055+a575;
a576=a576/a575;
a543=a546*a576;
a693=a546*a587;
a578=a563*a693;
a543=a543+a578;
a578=a491*a543;
a698=a532*a578;
a533=a698/a498;
a369=a556*a533;
a526=arg[4]? arg[4][5] : 0;
a580=casadi_sq(a559);
a580=a055+a580;
a526=a526/a580;
a369=a369+a526;
a585=a700*a369;
a667=2.*a558;
a585=a585/a667;
a669=a296-a585;
a636=2.*a636;
a636=a669*a636;
a299=2.*a299;
a672=a666*a672;
a617=a617/a321;
a612=a612/a321;
a612=a612*a647;
a617=a617-a612;
a612=a536*a650;
a527=a527/a134;
a647=a536/a134;
a647=a647*a645;
a527=a527-a647;
a647=a368*a527;
a612=a612+a647;
a617=a617-a612;
a572=a572*a617;
a672=a672+a572;
a672=a672/a539;
a539=a296/a539;
a572=2.*a696;
a539=a539*a572;
a672=a672-a539;
a539=a691/a558;
a572=a700/a558;
a572=a572*a694;
a539=a539-a572;
a539=a369*a539;
a687=a533*a687;
a572=a576*a676;
a612=a587*a684;
a647=a586*a674;
a321=a643*a671;
a666=a666*a696;
a573=a573*a617;
a666=a666+a573;
a573=a544*a666;
a321=a321+a573;
a660=a660*a321;
a570=sin(a570);
a570=a570*a675;
a537=a537*a570;
a660=a660-a537;
a537=a545*a660;
a647=a647+a537;
a647=a647/a574;
a574=a587/a574;
a568=2.*a568;
a568=a568*a677;
a574=a574*a568;
a647=a647-a574;
a574=a547*a647;
a612=a612+a574;
a612=a612/a575;
a575=a576/a575;
a565=2.*a565;
a565=a565*a685;
a575=a575*a565;
a612=a612-a575;
a575=a546*a612;
a572=a572+a575;
a575=a587*a676;
a565=a546*a647;
a575=a575+a565;
a563=a563*a575;
a565=a693*a684;
a563=a563-a565;
a572=a572+a563;
a491=a491*a572;
a532=a532*a491;
a563=a532/a498;
a565=a533/a498;
a565=a565*a624;
a563=a563-a565;
a556=a556*a563;
a687=a687+a556;
a556=arg[12]? arg[12][5] : 0;
a556=a556/a580;
a526=a526/a580;
a580=2.*a559;
a580=a580*a691;
a526=a526*a580;
a556=a556-a526;
a687=a687+a556;
a700=a700*a687;
a539=a539+a700;
a539=a539/a667;
a585=a585/a667;
a667=2.*a694;
a585=a585*a667;
a539=a539-a585;
a539=a672-a539;
a585=a299*a539;
a636=a636+a585;
a528=a528+a636;
a636=a125*a528;
a622=a622*a605;
a529=a529+a622;
a299=a299*a669;
a529=a529+a299;
a637=a529*a637;
a636=a636-a637;
a001=a001+a636;
a637=a584*a618;
a299=2.*a368;
a531=a531/a134;
a622=a299*a531;
a637=a637+a622;
a622=a557*a536;
a637=a637-a622;
a622=2.*a368;
a585=a622*a296;
a637=a637+a585;
a368=2.*a368;
a585=a368*a605;
a637=a637+a585;
a369=a369/a558;
a637=a637+a369;
a654=a637*a654;
a618=a618*a697;
a584=a584*a619;
a618=a618+a584;
a584=2.*a650;
a584=a531*a584;
a661=a661/a134;
a531=a531/a134;
a531=a531*a645;
a661=a661-a531;
a299=a299*a661;
a584=a584+a299;
a618=a618+a584;
a536=a536*a695;
a557=a557*a527;
a536=a536+a557;
a618=a618-a536;
a536=2.*a650;
a296=a296*a536;
a622=a622*a672;
a296=a296+a622;
a618=a618+a296;
a650=2.*a650;
a605=a605*a650;
a368=a368*a648;
a605=a605+a368;
a618=a618+a605;
a687=a687/a558;
a369=a369/a558;
a369=a369*a694;
a687=a687-a369;
a618=a618+a687;
a687=a127*a618;
a654=a654+a687;
a001=a001+a654;
a687=cos(a481);
a369=a003+a517;
a694=a369*a687;
a137=a137+a694;
a694=casadi_sq(a133);
a558=casadi_sq(a694);
a605=casadi_sq(a137);
a368=cos(a481);
a648=a476*a368;
a517=a003+a517;
a650=sin(a481);
a296=a517*a650;
a648=a648-a296;
a296=casadi_sq(a648);
a605=a605+a296;
a296=casadi_sq(a605);
a558=a558+a296;
a558=sqrt(a558);
a296=sqrt(a558);
a622=a137/a296;
a672=arg[1]? arg[1][4] : 0;
a536=arg[2]? arg[2][36] : 0;
a557=a501*a313;
a329=a329+a557;
a557=casadi_fmax(a073,a329);
a527=a536*a557;
a695=arg[2]? arg[2][41] : 0;
a584=a527-a695;
a299=a672*a584;
a299=a299+a695;
a299=a299/a527;
a695=a299+a262;
a661=a622<=a695;
a531=a695<=a622;
a645=a531+a661;
a661=a661/a645;
a134=-a695;
a619=casadi_fmin(a695,a622);
a697=a134<=a619;
a585=a619<=a134;
a667=a585+a697;
a697=a697/a667;
a700=a273*a299;
a556=casadi_fmax(a134,a619);
a526=a272*a556;
a700=a700+a526;
a700=a700+a036;
a526=a025<=a700;
a580=a700<=a025;
a580=a580+a526;
a526=a526/a580;
a580=sin(a481);
a565=a522*a093;
a685=cos(a045);
a574=a685*a093;
a568=a237*a574;
a565=a565-a568;
a236=a236+a239;
a239=a236*a098;
a565=a565-a239;
a565=a565-a102;
a239=a580*a565;
a568=cos(a481);
a677=a522*a286;
a537=a344*a286;
a677=a677-a537;
a537=a357*a098;
a537=a036*a537;
a677=a677+a537;
a677=a677+a292;
a537=a568*a677;
a239=a239-a537;
a537=arg[4]? arg[4][2] : 0;
a239=a239+a537;
a537=a527*a239;
a570=a313*a537;
a675=a273*a299;
a321=a272*a556;
a675=a675-a321;
a675=a675+a036;
a321=casadi_fmax(a025,a675);
a573=casadi_sq(a321);
a617=a321*a573;
a617=a295*a617;
a696=a036*a321;
a696=a055-a696;
a581=a617*a696;
a556=a556+a581;
a581=casadi_fmax(a025,a700);
a583=casadi_sq(a581);
a616=a581*a583;
a616=a295*a616;
a699=a036*a581;
a699=a055-a699;
a668=a616*a699;
a556=a556-a668;
a668=2.*a556;
a579=casadi_sq(a556);
a579=a055-a579;
a579=sqrt(a579);
a582=a273*a579;
a262=a579+a262;
a620=-a262;
a591=a542*a672;
a607=-a551;
a703=a554*a313;
a553=a553+a703;
a703=casadi_fmax(a025,a553);
a602=casadi_sq(a137);
a602=a602+a323;
a323=sqrt(a602);
a615=a648/a323;
a614=a703*a615;
a614=a614/a527;
a608=casadi_fmin(a614,a551);
a611=casadi_fmax(a607,a608);
a604=a055-a547;
a603=a611*a604;
a705=a546*a611;
a599=atan(a705);
a592=a547*a599;
a592=a592/a546;
a603=a603+a592;
a665=a546*a603;
a589=atan(a665);
a593=a545*a589;
a707=sin(a593);
a708=a544*a707;
a709=casadi_sq(a648);
a709=a709+a602;
a709=sqrt(a709);
a602=a708*a709;
a710=a648*a602;
a710=a710/a558;
a711=a710+a011;
a712=casadi_sq(a648);
a712=a712/a558;
a577=a712+a577;
a711=a711/a577;
a713=a542*a711;
a591=a591-a713;
a713=casadi_fmin(a055,a591);
a714=casadi_fmax(a025,a713);
a715=casadi_sq(a714);
a716=a714*a715;
a716=a541*a716;
a717=casadi_sq(a714);
a717=a061*a717;
a718=a063*a714;
a717=a717-a718;
a717=a717+a064;
a064=a716*a717;
a718=a672-a711;
a718=a718-a541;
a719=casadi_fmax(a025,a718);
a064=a064+a719;
a719=a648*a064;
a719=a719/a296;
a720=a602/a296;
a721=a719+a720;
a722=casadi_fmin(a721,a262);
a723=casadi_fmax(a620,a722);
a724=a272*a723;
a582=a582+a724;
a582=a582+a036;
a724=a025<=a582;
a725=a582<=a025;
a725=a725+a724;
a724=a724/a725;
a725=casadi_fmax(a025,a582);
a726=casadi_sq(a725);
a727=a725*a726;
a727=a295*a727;
a728=cos(a481);
a729=a728*a565;
a730=sin(a481);
a731=a730*a677;
a729=a729+a731;
a731=arg[4]? arg[4][3] : 0;
a729=a729+a731;
a731=a527*a729;
a732=a313*a731;
a733=a727*a732;
a733=a036*a733;
a734=a036*a725;
a734=a055-a734;
a735=a734*a732;
a735=a295*a735;
a736=a726*a735;
a733=a733-a736;
a736=2.*a725;
a737=a725*a735;
a738=a736*a737;
a733=a733-a738;
a733=a724*a733;
a738=a273*a733;
a739=a273*a579;
a740=a272*a723;
a739=a739-a740;
a739=a739+a036;
a740=a025<=a739;
a741=a739<=a025;
a741=a741+a740;
a740=a740/a741;
a741=casadi_fmax(a025,a739);
a742=casadi_sq(a741);
a743=a036*a741;
a743=a055-a743;
a744=a743*a732;
a744=a295*a744;
a745=a742*a744;
a746=a741*a742;
a746=a295*a746;
a747=a746*a732;
a747=a036*a747;
a745=a745-a747;
a747=2.*a741;
a748=a741*a744;
a749=a747*a748;
a745=a745+a749;
a745=a740*a745;
a749=a273*a745;
a738=a738+a749;
a749=a262<=a721;
a750=a721<=a262;
a751=a750+a749;
a749=a749/a751;
a752=a620<=a722;
a753=a722<=a620;
a754=a753+a752;
a752=a752/a754;
a733=a272*a733;
a733=a733+a732;
a745=a272*a745;
a733=a733-a745;
a745=a752*a733;
a755=a749*a745;
a753=a753/a754;
a733=a753*a733;
a755=a755-a733;
a738=a738+a755;
a755=2.*a579;
a738=a738/a755;
a733=a668*a738;
a570=a570-a733;
a733=a025<=a700;
a700=a700<=a025;
a700=a700+a733;
a733=a733/a700;
a700=arg[9]? arg[9][4] : 0;
a754=a584*a700;
a756=arg[10]? arg[10][36] : 0;
a757=a557*a756;
a758=a073<=a329;
a759=a329<=a073;
a759=a759+a758;
a758=a758/a759;
a759=a313*a627;
a760=a501*a629;
a759=a759-a760;
a626=a626+a759;
a758=a758*a626;
a626=a536*a758;
a757=a757+a626;
a626=arg[10]? arg[10][41] : 0;
a759=a757-a626;
a760=a672*a759;
a754=a754+a760;
a754=a754+a626;
a754=a754/a527;
a626=a299/a527;
a626=a626*a757;
a754=a754-a626;
a626=a273*a754;
a760=a134<=a619;
a619=a619<=a134;
a134=a619+a760;
a760=a760/a134;
a761=a695<=a622;
a695=a622<=a695;
a762=a761+a695;
a761=a761/a762;
a761=a761*a754;
a695=a695/a762;
a762=a013+a633;
a763=a687*a762;
a764=sin(a481);
a764=a764*a638;
a765=a369*a764;
a763=a763-a765;
a641=a641+a763;
a763=a641/a296;
a765=a622/a296;
a766=2.*a694;
a767=2.*a133;
a767=a767*a474;
a766=a766*a767;
a768=2.*a605;
a769=2.*a137;
a769=a769*a641;
a770=2.*a648;
a771=a368*a639;
a772=sin(a481);
a772=a772*a638;
a773=a476*a772;
a771=a771-a773;
a633=a013+a633;
a773=a650*a633;
a774=cos(a481);
a774=a774*a638;
a775=a517*a774;
a773=a773+a775;
a771=a771-a773;
a770=a770*a771;
a769=a769+a770;
a768=a768*a769;
a766=a766+a768;
a768=2.*a558;
a766=a766/a768;
a768=2.*a296;
a768=a766/a768;
a765=a765*a768;
a763=a763-a765;
a695=a695*a763;
a761=a761+a695;
a760=a760*a761;
a619=a619/a134;
a619=a619*a754;
a760=a760-a619;
a619=a272*a760;
a626=a626+a619;
a733=a733*a626;
a626=a583*a733;
a619=2.*a581;
a619=a619*a733;
a134=a581*a619;
a626=a626+a134;
a626=a295*a626;
a134=a570*a626;
a761=a239*a757;
a695=cos(a481);
a695=a695*a638;
a765=a565*a695;
a770=a093*a653;
a773=a522*a183;
a770=a770+a773;
a773=a574*a434;
a685=a685*a183;
a775=sin(a045);
a775=a775*a158;
a775=a093*a775;
a685=a685-a775;
a775=a237*a685;
a773=a773+a775;
a770=a770-a773;
a432=a432+a435;
a432=a098*a432;
a236=a236*a096;
a432=a432+a236;
a770=a770-a432;
a770=a770-a186;
a432=a580*a770;
a765=a765+a432;
a653=a286*a653;
a522=a522*a484;
a653=a653+a522;
a656=a286*a656;
a344=a344*a484;
a656=a656+a344;
a653=a653-a656;
a656=a098*a634;
a344=a357*a096;
a656=a656+a344;
a656=a036*a656;
a653=a653+a656;
a653=a653+a283;
a656=a568*a653;
a344=sin(a481);
a344=a344*a638;
a522=a677*a344;
a656=a656-a522;
a765=a765-a656;
a656=arg[12]? arg[12][2] : 0;
a765=a765+a656;
a656=a527*a765;
a761=a761+a656;
a656=a313*a761;
a522=a537*a629;
a656=a656-a522;
a522=a025<=a675;
a432=a675<=a025;
a432=a432+a522;
a522=a522/a432;
a432=a273*a754;
a236=a272*a760;
a432=a432-a236;
a522=a522*a432;
a432=a573*a522;
a236=2.*a321;
a236=a236*a522;
a435=a321*a236;
a432=a432+a435;
a432=a295*a432;
a435=a696*a432;
a773=a036*a522;
a775=a617*a773;
a435=a435-a775;
a760=a760+a435;
a626=a699*a626;
a435=a036*a733;
a775=a616*a435;
a626=a626-a775;
a760=a760-a626;
a626=2.*a760;
a626=a738*a626;
a775=a025<=a582;
a582=a582<=a025;
a582=a582+a775;
a775=a775/a582;
a582=a722<=a620;
a620=a620<=a722;
a722=a582+a620;
a582=a582/a722;
a776=2.*a556;
a776=a776*a760;
a579=2.*a579;
a776=a776/a579;
a582=a582*a776;
a620=a620/a722;
a722=a721<=a262;
a262=a262<=a721;
a721=a722+a262;
a722=a722/a721;
a579=a064*a771;
a777=a025<=a713;
a778=a713<=a025;
a778=a778+a777;
a777=a777/a778;
a778=a591<=a055;
a779=a055<=a591;
a779=a779+a778;
a778=a778/a779;
a779=a542*a700;
a780=a602*a771;
a781=a707*a671;
a782=cos(a593);
a783=a589*a674;
a784=a603*a676;
a785=a608<=a607;
a786=a607<=a608;
a787=a785+a786;
a785=a785/a787;
a785=a785*a681;
a786=a786/a787;
a787=a614<=a551;
a788=a551<=a614;
a789=a787+a788;
a787=a787/a789;
a790=a025<=a553;
a791=a553<=a025;
a791=a791+a790;
a790=a790/a791;
a791=a313*a689;
a792=a554*a629;
a791=a791-a792;
a688=a688+a791;
a790=a790*a688;
a688=a615*a790;
a791=a771/a323;
a792=a615/a323;
a793=2.*a137;
a793=a793*a641;
a793=a793+a516;
a516=2.*a323;
a516=a793/a516;
a792=a792*a516;
a791=a791-a792;
a792=a703*a791;
a688=a688+a792;
a688=a688/a527;
a792=a614/a527;
a792=a792*a757;
a688=a688-a792;
a787=a787*a688;
a788=a788/a789;
a788=a788*a681;
a787=a787-a788;
a786=a786*a787;
a785=a785+a786;
a786=a604*a785;
a787=a611*a684;
a786=a786-a787;
a787=a599*a684;
a788=a611*a676;
a789=a546*a785;
a788=a788+a789;
a789=casadi_sq(a705);
a789=a055+a789;
a789=a788/a789;
a792=a547*a789;
a787=a787+a792;
a787=a787/a546;
a792=a592/a546;
a792=a792*a676;
a787=a787-a792;
a786=a786+a787;
a792=a546*a786;
a784=a784+a792;
a792=casadi_sq(a665);
a792=a055+a792;
a792=a784/a792;
a794=a545*a792;
a783=a783+a794;
a782=a782*a783;
a794=a544*a782;
a781=a781+a794;
a794=a709*a781;
a795=2.*a648;
a795=a795*a771;
a795=a795+a793;
a793=2.*a709;
a795=a795/a793;
a793=a708*a795;
a794=a794+a793;
a793=a648*a794;
a780=a780+a793;
a780=a780/a558;
a793=a710/a558;
a793=a793*a766;
a780=a780-a793;
a793=a780/a577;
a796=a711/a577;
a797=2.*a648;
a797=a797*a771;
a797=a797/a558;
a798=a712/a558;
a798=a798*a766;
a797=a797-a798;
a796=a796*a797;
a793=a793-a796;
a796=a542*a793;
a779=a779-a796;
a778=a778*a779;
a777=a777*a778;
a778=a715*a777;
a779=2.*a714;
a779=a779*a777;
a796=a714*a779;
a778=a778+a796;
a778=a541*a778;
a796=a717*a778;
a798=2.*a714;
a798=a798*a777;
a798=a061*a798;
a799=a063*a777;
a798=a798-a799;
a799=a716*a798;
a796=a796+a799;
a799=a025<=a718;
a800=a718<=a025;
a800=a800+a799;
a799=a799/a800;
a800=a700-a793;
a799=a799*a800;
a796=a796+a799;
a799=a648*a796;
a579=a579+a799;
a579=a579/a296;
a799=a719/a296;
a799=a799*a768;
a579=a579-a799;
a799=a794/a296;
a800=a720/a296;
a800=a800*a768;
a799=a799-a800;
a800=a579+a799;
a722=a722*a800;
a262=a262/a721;
a262=a262*a776;
a722=a722-a262;
a620=a620*a722;
a582=a582+a620;
a620=a272*a582;
a722=a273*a776;
a620=a620-a722;
a775=a775*a620;
a620=a726*a775;
a722=2.*a725;
a722=a722*a775;
a262=a725*a722;
a620=a620+a262;
a620=a295*a620;
a262=a732*a620;
a721=a729*a757;
a800=a728*a770;
a801=sin(a481);
a801=a801*a638;
a802=a565*a801;
a800=a800-a802;
a802=cos(a481);
a802=a802*a638;
a803=a677*a802;
a804=a730*a653;
a803=a803+a804;
a800=a800+a803;
a803=arg[12]? arg[12][3] : 0;
a800=a800+a803;
a803=a527*a800;
a721=a721+a803;
a803=a313*a721;
a804=a731*a629;
a803=a803-a804;
a804=a727*a803;
a262=a262+a804;
a262=a036*a262;
a722=a735*a722;
a804=a734*a803;
a805=a036*a775;
a806=a732*a805;
a804=a804-a806;
a804=a295*a804;
a726=a726*a804;
a722=a722+a726;
a262=a262-a722;
a722=2.*a775;
a737=a737*a722;
a735=a735*a775;
a725=a725*a804;
a735=a735+a725;
a736=a736*a735;
a737=a737+a736;
a262=a262-a737;
a724=a724*a262;
a262=a273*a724;
a737=a025<=a739;
a739=a739<=a025;
a739=a739+a737;
a737=a737/a739;
a739=a273*a776;
a736=a272*a582;
a739=a739+a736;
a737=a737*a739;
a739=a036*a737;
a736=a732*a739;
a735=a743*a803;
a736=a736+a735;
a736=a295*a736;
a735=a742*a736;
a725=2.*a741;
a725=a725*a737;
a804=a744*a725;
a735=a735-a804;
a804=a746*a803;
a742=a742*a737;
a725=a741*a725;
a742=a742+a725;
a742=a295*a742;
a732=a732*a742;
a804=a804-a732;
a804=a036*a804;
a735=a735-a804;
a804=-a737;
a804=2.*a804;
a748=a748*a804;
a741=a741*a736;
a744=a744*a737;
a741=a741-a744;
a747=a747*a741;
a748=a748+a747;
a735=a735+a748;
a740=a740*a735;
a735=a273*a740;
a262=a262+a735;
a724=a272*a724;
a724=a724+a803;
a740=a272*a740;
a724=a724-a740;
a752=a752*a724;
a749=a749*a752;
a753=a753*a724;
a749=a749-a753;
a262=a262+a749;
a262=a262/a755;
a738=a738/a755;
a776=-a776;
a776=2.*a776;
a738=a738*a776;
a262=a262-a738;
a668=a668*a262;
a626=a626+a668;
a656=a656-a626;
a626=a616*a656;
a134=a134+a626;
a134=a036*a134;
a626=a699*a570;
a626=a295*a626;
a619=a626*a619;
a699=a699*a656;
a435=a570*a435;
a699=a699-a435;
a699=a295*a699;
a435=a583*a699;
a619=a619+a435;
a134=a134-a619;
a619=a581*a626;
a435=2.*a733;
a435=a619*a435;
a668=2.*a581;
a733=a626*a733;
a581=a581*a699;
a733=a733+a581;
a733=a668*a733;
a435=a435+a733;
a134=a134-a435;
a134=a526*a134;
a435=a272*a134;
a435=a435+a656;
a733=a025<=a675;
a675=a675<=a025;
a675=a675+a733;
a733=a733/a675;
a675=a696*a570;
a675=a295*a675;
a236=a675*a236;
a696=a696*a656;
a773=a570*a773;
a696=a696-a773;
a295=a295*a696;
a696=a573*a295;
a236=a236+a696;
a432=a570*a432;
a656=a617*a656;
a432=a432+a656;
a432=a036*a432;
a236=a236-a432;
a432=a321*a675;
a656=2.*a522;
a656=a432*a656;
a696=2.*a321;
a522=a675*a522;
a321=a321*a295;
a522=a522+a321;
a522=a696*a522;
a656=a656+a522;
a236=a236+a656;
a236=a733*a236;
a656=a272*a236;
a435=a435-a656;
a656=a697*a435;
a522=a661*a656;
a321=a522/a296;
a616=a616*a570;
a616=a036*a616;
a583=a583*a626;
a616=a616-a583;
a668=a668*a619;
a616=a616-a668;
a526=a526*a616;
a616=a272*a526;
a616=a616+a570;
a573=a573*a675;
a617=a617*a570;
a617=a036*a617;
a573=a573-a617;
a696=a696*a432;
a573=a573+a696;
a733=a733*a573;
a272=a272*a733;
a616=a616-a272;
a697=a697*a616;
a661=a661*a697;
a272=a661/a296;
a573=a272/a296;
a573=a573*a768;
a321=a321-a573;
a605=2.*a605;
a710=a710/a558;
a573=a025<=a718;
a718=a718<=a025;
a718=a718+a573;
a573=a573/a718;
a750=a750/a751;
a745=a750*a745;
a751=a745/a296;
a718=a648*a751;
a696=a573*a718;
a432=a591<=a055;
a591=a055<=a591;
a591=a591+a432;
a432=a432/a591;
a591=a025<=a713;
a713=a713<=a025;
a713=a713+a591;
a591=a591/a713;
a713=2.*a714;
a617=a716*a718;
a570=a061*a617;
a675=a713*a570;
a617=a063*a617;
a675=a675-a617;
a617=a717*a718;
a617=a541*a617;
a668=a715*a617;
a675=a675+a668;
a668=2.*a714;
a619=a714*a617;
a583=a668*a619;
a675=a675+a583;
a675=a591*a675;
a675=a432*a675;
a675=a542*a675;
a696=a696+a675;
a675=a696/a577;
a583=a710*a675;
a712=a712/a558;
a711=a711/a577;
a626=a711*a696;
a295=a712*a626;
a583=a583-a295;
a720=a720/a296;
a295=a720*a745;
a719=a719/a296;
a773=a719*a745;
a295=a295+a773;
a622=a622/a296;
a773=a622*a661;
a295=a295+a773;
a773=2.*a296;
a295=a295/a773;
a583=a583-a295;
a581=2.*a558;
a583=a583/a581;
a699=a605*a583;
a262=2.*a641;
a262=a699*a262;
a738=2.*a137;
a769=2.*a769;
a769=a583*a769;
a780=a780/a558;
a776=a710/a558;
a776=a776*a766;
a780=a780-a776;
a780=a675*a780;
a776=a751*a771;
a750=a750*a752;
a752=a750/a296;
a755=a751/a296;
a755=a755*a768;
a752=a752-a755;
a755=a648*a752;
a776=a776+a755;
a573=a573*a776;
a755=2.*a777;
a570=a570*a755;
a778=a718*a778;
a716=a716*a776;
a778=a778+a716;
a716=a061*a778;
a713=a713*a716;
a570=a570+a713;
a778=a063*a778;
a570=a570-a778;
a779=a617*a779;
a718=a718*a798;
a717=a717*a776;
a718=a718+a717;
a541=a541*a718;
a715=a715*a541;
a779=a779+a715;
a570=a570+a779;
a779=2.*a777;
a619=a619*a779;
a617=a617*a777;
a714=a714*a541;
a617=a617+a714;
a668=a668*a617;
a619=a619+a668;
a570=a570+a619;
a591=a591*a570;
a432=a432*a591;
a591=a542*a432;
a591=a573+a591;
a570=a591/a577;
a619=a675/a577;
a619=a619*a797;
a570=a570-a619;
a710=a710*a570;
a780=a780+a710;
a710=a797/a558;
a619=a712/a558;
a619=a619*a766;
a710=a710-a619;
a710=a626*a710;
a793=a793/a577;
a577=a711/a577;
a577=a577*a797;
a793=a793-a577;
a696=a696*a793;
a711=a711*a591;
a696=a696+a711;
a712=a712*a696;
a710=a710+a712;
a780=a780-a710;
a799=a799/a296;
a710=a720/a296;
a710=a710*a768;
a799=a799-a710;
a799=a745*a799;
a720=a720*a750;
a799=a799+a720;
a579=a579/a296;
a720=a719/a296;
a720=a720*a768;
a579=a579-a720;
a579=a745*a579;
a719=a719*a750;
a579=a579+a719;
a799=a799+a579;
a763=a763/a296;
a579=a622/a296;
a579=a579*a768;
a763=a763-a579;
a661=a661*a763;
a622=a622*a522;
a661=a661+a622;
a799=a799+a661;
a799=a799/a773;
a295=a295/a773;
a773=2.*a768;
a295=a295*a773;
a799=a799-a295;
a780=a780-a799;
a780=a780/a581;
a581=a583/a581;
a799=2.*a766;
a581=a581*a799;
a780=a780-a581;
a605=a605*a780;
a769=a769+a605;
a605=a738*a769;
a262=a262+a605;
a321=a321+a262;
a745=a745/a296;
a675=a675/a558;
a262=a648*a675;
a262=a745-a262;
a605=a708*a262;
a581=2.*a709;
a605=a605/a581;
a799=a615/a323;
a295=a614<=a551;
a773=a551<=a614;
a661=a295+a773;
a295=a295/a661;
a622=a607<=a608;
a608=a608<=a607;
a607=a608+a622;
a622=a622/a607;
a522=cos(a593);
a763=a709*a262;
a579=a544*a763;
a719=a522*a579;
a720=a545*a719;
a710=casadi_sq(a665);
a710=a055+a710;
a720=a720/a710;
a712=a547*a720;
a711=casadi_sq(a705);
a711=a055+a711;
a712=a712/a711;
a591=a546*a712;
a793=a546*a720;
a577=a604*a793;
a591=a591+a577;
a577=a622*a591;
a797=a295*a577;
a619=a797/a527;
a668=a703*a619;
a617=arg[4]? arg[4][1] : 0;
a714=casadi_sq(a615);
a714=a055+a714;
a617=a617/a714;
a668=a668+a617;
a541=a799*a668;
a777=2.*a323;
a541=a541/a777;
a779=a605-a541;
a641=2.*a641;
a641=a779*a641;
a137=2.*a137;
a781=a262*a781;
a750=a750/a296;
a745=a745/a296;
a745=a745*a768;
a750=a750-a745;
a745=a675*a771;
a570=a570/a558;
a768=a675/a558;
a768=a768*a766;
a570=a570-a768;
a768=a648*a570;
a745=a745+a768;
a750=a750-a745;
a708=a708*a750;
a781=a781+a708;
a781=a781/a581;
a581=a605/a581;
a708=2.*a795;
a581=a581*a708;
a781=a781-a581;
a581=a791/a323;
a708=a799/a323;
a708=a708*a516;
a581=a581-a708;
a581=a668*a581;
a790=a619*a790;
a708=a712*a676;
a745=a720*a684;
a674=a719*a674;
a671=a763*a671;
a262=a262*a795;
a709=a709*a750;
a262=a262+a709;
a544=a544*a262;
a671=a671+a544;
a522=a522*a671;
a593=sin(a593);
a593=a593*a783;
a579=a579*a593;
a522=a522-a579;
a545=a545*a522;
a674=a674+a545;
a674=a674/a710;
a710=a720/a710;
a665=2.*a665;
a665=a665*a784;
a710=a710*a665;
a674=a674-a710;
a547=a547*a674;
a745=a745+a547;
a745=a745/a711;
a711=a712/a711;
a705=2.*a705;
a705=a705*a788;
a711=a711*a705;
a745=a745-a711;
a711=a546*a745;
a708=a708+a711;
a711=a720*a676;
a705=a546*a674;
a711=a711+a705;
a604=a604*a711;
a684=a793*a684;
a604=a604-a684;
a708=a708+a604;
a622=a622*a708;
a295=a295*a622;
a604=a295/a527;
a684=a619/a527;
a684=a684*a757;
a604=a604-a684;
a703=a703*a604;
a790=a790+a703;
a703=arg[12]? arg[12][1] : 0;
a703=a703/a714;
a617=a617/a714;
a714=2.*a615;
a714=a714*a791;
a617=a617*a714;
a703=a703-a617;
a790=a790+a703;
a799=a799*a790;
a581=a581+a799;
a581=a581/a777;
a541=a541/a777;
a777=2.*a516;
a541=a541*a777;
a581=a581-a541;
a581=a781-a581;
a541=a137*a581;
a641=a641+a541;
a321=a321+a641;
a641=a687*a321;
a738=a738*a699;
a272=a272+a738;
a137=a137*a779;
a272=a272+a137;
a764=a272*a764;
a641=a641-a764;
a001=a001+a641;
a764=a064*a751;
a137=2.*a648;
a626=a626/a558;
a738=a137*a626;
a764=a764+a738;
a738=a602*a675;
a764=a764-a738;
a738=2.*a648;
a541=a738*a605;
a764=a764+a541;
a648=2.*a648;
a541=a648*a699;
a764=a764+a541;
a668=a668/a323;
a764=a764+a668;
a774=a764*a774;
a751=a751*a796;
a064=a064*a752;
a751=a751+a064;
a064=2.*a771;
a064=a626*a064;
a696=a696/a558;
a626=a626/a558;
a626=a626*a766;
a696=a696-a626;
a137=a137*a696;
a064=a064+a137;
a751=a751+a064;
a675=a675*a794;
a602=a602*a570;
a675=a675+a602;
a751=a751-a675;
a675=2.*a771;
a605=a605*a675;
a738=a738*a781;
a605=a605+a738;
a751=a751+a605;
a771=2.*a771;
a699=a699*a771;
a648=a648*a769;
a699=a699+a648;
a751=a751+a699;
a790=a790/a323;
a668=a668/a323;
a668=a668*a516;
a790=a790-a668;
a751=a751+a790;
a790=a650*a751;
a774=a774+a790;
a001=a001-a774;
a790=arg[2]? arg[2][23] : 0;
a668=casadi_sq(a221);
a516=arg[2]? arg[2][24] : 0;
a323=a668*a516;
a790=a790+a323;
a323=a790*a230;
a699=a323*a022;
a699=a699/a233;
a648=a699/a233;
a769=a648*a292;
a771=casadi_sq(a053);
a771=a771+a227;
a605=a053/a771;
a738=arg[2]? arg[2][65] : 0;
a781=arg[2]? arg[2][60] : 0;
a675=a781*a230;
a602=arg[4]? arg[4][20] : 0;
a602=a098+a602;
a570=a675*a602;
a794=a738*a570;
a064=arg[2]? arg[2][62] : 0;
a137=a781*a230;
a696=arg[4]? arg[4][18] : 0;
a696=a696-a093;
a626=a137*a696;
a766=a064*a626;
a794=a794+a766;
a766=arg[2]? arg[2][57] : 0;
a558=arg[4]? arg[4][17] : 0;
a102=a102+a558;
a558=a230*a102;
a752=a766*a558;
a794=a794+a752;
a752=arg[4]? arg[4][13] : 0;
a794=a794+a752;
a752=a605*a794;
a769=a769-a752;
a232=a232/a233;
a752=arg[4]? arg[4][33] : 0;
a796=a025<=a241;
a541=a241<=a025;
a541=a541+a796;
a796=a796/a541;
a541=a365*a362;
a341=a341+a541;
a541=a345*a353;
a341=a341-a541;
a541=a341*a350;
a777=a025<=a319;
a319=a319<=a025;
a319=a319+a777;
a777=a777/a319;
a319=a325*a308;
a319=a777*a319;
a799=a320*a319;
a541=a541+a799;
a799=a275*a293;
a541=a541+a799;
a799=a073<=a116;
a116=a116<=a073;
a116=a116+a799;
a799=a799/a116;
a116=a259*a341;
a703=a116*a349;
a326=a326/a261;
a617=a326*a304;
a703=a703-a617;
a617=a259*a275;
a714=a617*a284;
a703=a703+a714;
a079=a079/a261;
a276=a273*a276;
a352=a273*a352;
a276=a276+a352;
a265=a265/a266;
a269=a265*a269;
a270=a270/a271;
a303=a270*a303;
a269=a269-a303;
a276=a276+a269;
a269=a079*a276;
a703=a703-a269;
a269=a082*a703;
a269=a799*a269;
a303=a081*a269;
a541=a541+a303;
a303=arg[4]? arg[4][8] : 0;
a541=a541+a303;
a541=a796*a541;
a303=a541/a258;
a271=a240*a303;
a266=a025<=a249;
a249=a249<=a025;
a249=a249+a266;
a266=a266/a249;
a249=a613*a610;
a590=a590+a249;
a249=a594*a601;
a590=a590-a249;
a249=a590*a598;
a352=a025<=a555;
a555=a555<=a025;
a555=a555+a352;
a352=a352/a555;
a555=a559*a533;
a555=a352*a555;
a714=a554*a555;
a249=a249+a714;
a714=a354*a525;
a249=a249+a714;
a714=a073<=a305;
a305=a305<=a073;
a305=a305+a714;
a714=a714/a305;
a305=a313*a590;
a684=a305*a596;
a560=a560/a498;
a705=a560*a698;
a684=a684-a705;
a705=a313*a354;
a788=a705*a343;
a684=a684+a788;
a336=a336/a498;
a367=a273*a367;
a600=a273*a600;
a367=a367+a600;
a492=a492/a310;
a514=a492*a514;
a475=a475/a359;
a534=a475*a534;
a514=a514-a534;
a367=a367+a514;
a514=a336*a367;
a684=a684-a514;
a514=a367/a498;
a534=a374*a514;
a684=a684+a534;
a534=a332*a684;
a534=a714*a534;
a359=a501*a534;
a249=a249+a359;
a359=arg[4]? arg[4][4] : 0;
a249=a249+a359;
a359=a746*a743;
a723=a723+a359;
a359=a727*a734;
a723=a723-a359;
a359=a723*a731;
a249=a249+a359;
a359=a025<=a553;
a553=a553<=a025;
a553=a553+a359;
a359=a359/a553;
a553=a615*a619;
a553=a359*a553;
a310=a554*a553;
a249=a249+a310;
a310=a556*a537;
a249=a249+a310;
a310=a073<=a329;
a329=a329<=a073;
a329=a329+a310;
a310=a310/a329;
a329=a313*a723;
a073=a329*a729;
a614=a614/a527;
a600=a614*a797;
a073=a073-a600;
a600=a313*a556;
a788=a600*a239;
a073=a073+a788;
a299=a299/a527;
a526=a273*a526;
a733=a273*a733;
a526=a526+a733;
a531=a531/a645;
a697=a531*a697;
a585=a585/a667;
a616=a585*a616;
a697=a697-a616;
a526=a526+a697;
a697=a299*a526;
a073=a073-a697;
a697=a526/a527;
a616=a672*a697;
a073=a073+a616;
a616=a536*a073;
a616=a310*a616;
a667=a501*a616;
a249=a249+a667;
a667=arg[4]? arg[4][0] : 0;
a249=a249+a667;
a249=a266*a249;
a667=a249/a258;
a645=a036*a667;
a733=a164*a645;
a271=a271-a733;
a733=a752+a271;
a788=a232*a733;
a769=a769+a788;
a788=2.*a233;
a769=a769/a788;
a547=2.5000000000000000e-01;
a225=a547*a225;
a710=casadi_sq(a781);
a665=arg[2]? arg[2][66] : 0;
a784=a665*a602;
a545=arg[2]? arg[2][63] : 0;
a579=a545*a696;
a784=a784+a579;
a579=a710*a784;
a593=arg[2]? arg[2][58] : 0;
a783=a593*a781;
a671=a783*a102;
a579=a579+a671;
a671=a030*a579;
a544=a043*a671;
a709=a225*a544;
a750=sqrt(a228);
a795=2.*a750;
a709=a709/a795;
a768=arg[2]? arg[2][64] : 0;
a296=arg[1]? arg[1][9] : 0;
a715=a768*a296;
a718=atan2(a053,a233);
a717=a738*a718;
a715=a715+a717;
a717=arg[2]? arg[2][67] : 0;
a776=a717*a068;
a715=a715+a776;
a776=a715*a602;
a798=a781*a776;
a778=arg[2]? arg[2][61] : 0;
a713=a778*a296;
a716=a064*a718;
a713=a713+a716;
a716=a713*a696;
a755=a781*a716;
a798=a798+a755;
a755=a766*a718;
a749=arg[2]? arg[2][59] : 0;
a753=a749*a068;
a755=a755+a753;
a753=a755*a102;
a798=a798+a753;
a753=arg[4]? arg[4][16] : 0;
a724=a292/a233;
a740=a022*a724;
a753=a753-a740;
a740=a790*a753;
a798=a798+a740;
a740=arg[4]? arg[4][19] : 0;
a740=a740-a286;
a803=a303-a645;
a740=a740+a803;
a735=a252*a740;
a748=a250*a735;
a798=a798+a748;
a748=arg[4]? arg[4][15] : 0;
a747=a733/a233;
a741=a022*a747;
a748=a748-a741;
a741=a221*a748;
a798=a798+a741;
a741=a030*a798;
a744=a226*a741;
a744=a709+a744;
a737=a769+a744;
a736=2.*a140;
a736=a737*a736;
a804=2.*a022;
a732=arg[10]? arg[10][23] : 0;
a725=2.*a221;
a725=a725*a415;
a775=a516*a725;
a722=arg[10]? arg[10][24] : 0;
a726=a668*a722;
a775=a775+a726;
a732=a732+a775;
a775=a230*a732;
a726=a790*a427;
a775=a775+a726;
a726=a022*a775;
a806=a323*a140;
a726=a726+a806;
a726=a726/a233;
a806=a699/a233;
a806=a806*a430;
a726=a726-a806;
a806=a726/a233;
a807=a648/a233;
a807=a807*a430;
a806=a806-a807;
a292=a292*a806;
a648=a648*a283;
a292=a292+a648;
a648=a162/a771;
a806=a605/a771;
a807=2.*a053;
a807=a807*a162;
a807=a807+a425;
a806=a806*a807;
a648=a648-a806;
a648=a794*a648;
a806=arg[10]? arg[10][65] : 0;
a425=a570*a806;
a808=arg[10]? arg[10][60] : 0;
a809=a230*a808;
a810=a781*a427;
a809=a809+a810;
a809=a602*a809;
a810=arg[12]? arg[12][20] : 0;
a810=a096+a810;
a675=a675*a810;
a809=a809+a675;
a675=a738*a809;
a425=a425+a675;
a675=arg[10]? arg[10][62] : 0;
a811=a626*a675;
a812=a230*a808;
a813=a781*a427;
a812=a812+a813;
a812=a696*a812;
a813=arg[12]? arg[12][18] : 0;
a813=a813-a183;
a137=a137*a813;
a812=a812+a137;
a137=a064*a812;
a811=a811+a137;
a425=a425+a811;
a811=arg[10]? arg[10][57] : 0;
a137=a558*a811;
a814=a102*a427;
a815=arg[12]? arg[12][17] : 0;
a815=a186+a815;
a816=a230*a815;
a814=a814+a816;
a816=a766*a814;
a137=a137+a816;
a425=a425+a137;
a137=arg[12]? arg[12][13] : 0;
a425=a425+a137;
a605=a605*a425;
a648=a648+a605;
a292=a292-a648;
a428=a428/a233;
a648=a232/a233;
a648=a648*a430;
a428=a428-a648;
a733=a733*a428;
a428=arg[12]? arg[12][33] : 0;
a437=a303*a437;
a365=a365*a358;
a362=a362*a361;
a365=a365-a362;
a307=a307+a365;
a353=a353*a309;
a345=a345*a523;
a353=a353-a345;
a307=a307-a353;
a350=a350*a307;
a515=a341*a515;
a350=a350+a515;
a512=a319*a512;
a308=a308*a513;
a325=a325*a499;
a308=a308+a325;
a777=a777*a308;
a320=a320*a777;
a512=a512+a320;
a350=a350+a512;
a293=a293*a378;
a263=a275*a263;
a293=a293+a263;
a350=a350+a293;
a379=a269*a379;
a375=a703*a375;
a341=a341*a381;
a307=a259*a307;
a341=a341+a307;
a349=a349*a341;
a521=a116*a521;
a349=a349+a521;
a511=a511/a261;
a521=a326/a261;
a521=a521*a376;
a511=a511-a521;
a304=a304*a511;
a326=a326*a472;
a304=a304+a326;
a349=a349-a304;
a275=a275*a381;
a378=a259*a378;
a275=a275+a378;
a284=a284*a275;
a477=a617*a477;
a284=a284+a477;
a349=a349+a284;
a274=a274/a261;
a284=a079/a261;
a284=a284*a376;
a274=a274-a284;
a274=a276*a274;
a267=a273*a267;
a487=a273*a487;
a267=a267+a487;
a265=a265*a380;
a270=a270*a488;
a265=a265-a270;
a267=a267+a265;
a079=a079*a267;
a274=a274+a079;
a349=a349-a274;
a082=a082*a349;
a375=a375+a082;
a799=a799*a375;
a081=a081*a799;
a379=a379+a081;
a350=a350+a379;
a379=arg[12]? arg[12][8] : 0;
a350=a350+a379;
a796=a796*a350;
a350=a796/a258;
a379=a303/a258;
a379=a379*a461;
a350=a350-a379;
a240=a240*a350;
a437=a437+a240;
a456=a645*a456;
a613=a613*a606;
a610=a610*a609;
a613=a613-a610;
a538=a538+a613;
a601=a601*a540;
a594=a594*a706;
a601=a601-a594;
a538=a538-a601;
a598=a598*a538;
a588=a590*a588;
a598=a598+a588;
a588=a555*a689;
a533=a533*a691;
a559=a559*a563;
a533=a533+a559;
a352=a352*a533;
a533=a554*a352;
a588=a588+a533;
a598=a598+a588;
a525=a525*a459;
a631=a354*a631;
a525=a525+a631;
a598=a598+a525;
a525=a534*a627;
a623=a684*a623;
a538=a313*a538;
a590=a590*a629;
a538=a538-a590;
a596=a596*a538;
a702=a305*a702;
a596=a596+a702;
a690=a690/a498;
a702=a560/a498;
a702=a702*a624;
a690=a690-a702;
a698=a698*a690;
a560=a560*a532;
a698=a698+a560;
a596=a596-a698;
a459=a313*a459;
a354=a354*a629;
a459=a459-a354;
a343=a343*a459;
a644=a705*a644;
a343=a343+a644;
a596=a596+a343;
a621=a621/a498;
a343=a336/a498;
a343=a343*a624;
a621=a621-a343;
a367=a367*a621;
a339=a273*a339;
a662=a273*a662;
a339=a339+a662;
a492=a492*a658;
a475=a475*a663;
a492=a492-a475;
a339=a339+a492;
a336=a336*a339;
a367=a367+a336;
a596=a596-a367;
a306=a514*a306;
a339=a339/a498;
a367=a514/a498;
a367=a367*a624;
a339=a339-a367;
a374=a374*a339;
a306=a306+a374;
a596=a596+a306;
a332=a332*a596;
a623=a623+a332;
a714=a714*a623;
a623=a501*a714;
a525=a525+a623;
a598=a598+a525;
a525=arg[12]? arg[12][4] : 0;
a598=a598+a525;
a746=a746*a739;
a743=a743*a742;
a746=a746-a743;
a582=a582+a746;
a734=a734*a620;
a727=a727*a805;
a734=a734-a727;
a582=a582-a734;
a731=a731*a582;
a721=a723*a721;
a731=a731+a721;
a598=a598+a731;
a689=a553*a689;
a619=a619*a791;
a615=a615*a604;
a619=a619+a615;
a359=a359*a619;
a554=a554*a359;
a689=a689+a554;
a598=a598+a689;
a537=a537*a760;
a761=a556*a761;
a537=a537+a761;
a598=a598+a537;
a627=a616*a627;
a756=a073*a756;
a582=a313*a582;
a723=a723*a629;
a582=a582-a723;
a729=a729*a582;
a800=a329*a800;
a729=a729+a800;
a688=a688/a527;
a800=a614/a527;
a800=a800*a757;
a688=a688-a800;
a797=a797*a688;
a614=a614*a295;
a797=a797+a614;
a729=a729-a797;
a760=a313*a760;
a556=a556*a629;
a760=a760-a556;
a239=a239*a760;
a765=a600*a765;
a239=a239+a765;
a729=a729+a239;
a754=a754/a527;
a239=a299/a527;
a239=a239*a757;
a754=a754-a239;
a526=a526*a754;
a134=a273*a134;
a273=a273*a236;
a134=a134+a273;
a531=a531*a656;
a585=a585*a435;
a531=a531-a585;
a134=a134+a531;
a299=a299*a134;
a526=a526+a299;
a729=a729-a526;
a700=a697*a700;
a134=a134/a527;
a526=a697/a527;
a526=a526*a757;
a134=a134-a526;
a672=a672*a134;
a700=a700+a672;
a729=a729+a700;
a536=a536*a729;
a756=a756+a536;
a310=a310*a756;
a501=a501*a310;
a627=a627+a501;
a598=a598+a627;
a627=arg[12]? arg[12][0] : 0;
a598=a598+a627;
a266=a266*a598;
a598=a266/a258;
a667=a667/a258;
a667=a667*a461;
a598=a598-a667;
a598=a036*a598;
a164=a164*a598;
a456=a456+a164;
a437=a437-a456;
a456=a428+a437;
a232=a232*a456;
a733=a733+a232;
a292=a292+a733;
a292=a292/a788;
a769=a769/a788;
a788=2.*a430;
a769=a769*a788;
a292=a292-a769;
a422=a547*a422;
a769=a544*a422;
a788=a671*a153;
a733=a579*a172;
a232=2.*a781;
a232=a232*a808;
a164=a784*a232;
a667=arg[10]? arg[10][66] : 0;
a667=a602*a667;
a665=a665*a810;
a667=a667+a665;
a665=arg[10]? arg[10][63] : 0;
a665=a696*a665;
a545=a545*a813;
a665=a665+a545;
a667=a667+a665;
a665=a710*a667;
a164=a164+a665;
a665=arg[10]? arg[10][58] : 0;
a545=a781*a665;
a627=a593*a808;
a545=a545+a627;
a627=a102*a545;
a501=a783*a815;
a627=a627+a501;
a164=a164+a627;
a627=a030*a164;
a733=a733+a627;
a627=a043*a733;
a788=a788+a627;
a627=a225*a788;
a769=a769+a627;
a769=a769/a795;
a709=a709/a795;
a795=2.*a750;
a795=a426/a795;
a627=2.*a795;
a709=a709*a627;
a769=a769-a709;
a423=a741*a423;
a709=a798*a172;
a627=a776*a808;
a501=arg[10]? arg[10][64] : 0;
a756=a296*a501;
a536=arg[9]? arg[9][9] : 0;
a672=a768*a536;
a756=a756+a672;
a806=a718*a806;
a672=casadi_sq(a053);
a672=a672+a227;
a227=a233/a672;
a227=a227*a162;
a672=a053/a672;
a672=a672*a430;
a227=a227-a672;
a738=a738*a227;
a806=a806+a738;
a756=a756+a806;
a806=arg[10]? arg[10][67] : 0;
a738=a068*a806;
a672=a717*a152;
a738=a738+a672;
a756=a756+a738;
a756=a602*a756;
a715=a715*a810;
a756=a756+a715;
a715=a781*a756;
a627=a627+a715;
a715=a716*a808;
a738=arg[10]? arg[10][61] : 0;
a672=a296*a738;
a526=a778*a536;
a672=a672+a526;
a675=a718*a675;
a064=a064*a227;
a675=a675+a064;
a672=a672+a675;
a672=a696*a672;
a713=a713*a813;
a672=a672+a713;
a713=a781*a672;
a715=a715+a713;
a627=a627+a715;
a811=a718*a811;
a766=a766*a227;
a811=a811+a766;
a766=arg[10]? arg[10][59] : 0;
a715=a068*a766;
a713=a749*a152;
a715=a715+a713;
a811=a811+a715;
a715=a102*a811;
a713=a755*a815;
a715=a715+a713;
a627=a627+a715;
a732=a753*a732;
a715=arg[12]? arg[12][16] : 0;
a713=a724*a140;
a675=a283/a233;
a064=a724/a233;
a064=a064*a430;
a675=a675-a064;
a064=a022*a675;
a713=a713+a064;
a715=a715-a713;
a790=a790*a715;
a732=a732+a790;
a627=a627+a732;
a446=a735*a446;
a449=a740*a449;
a732=arg[12]? arg[12][19] : 0;
a732=a732-a484;
a790=a350-a598;
a732=a732+a790;
a252=a252*a732;
a449=a449+a252;
a250=a250*a449;
a446=a446+a250;
a627=a627+a446;
a446=a748*a415;
a250=arg[12]? arg[12][15] : 0;
a140=a747*a140;
a456=a456/a233;
a252=a747/a233;
a252=a252*a430;
a456=a456-a252;
a022=a022*a456;
a140=a140+a022;
a250=a250-a140;
a140=a221*a250;
a446=a446+a140;
a627=a627+a446;
a446=a030*a627;
a709=a709+a446;
a226=a226*a709;
a423=a423+a226;
a769=a769+a423;
a292=a292+a769;
a292=a804*a292;
a736=a736+a292;
a775=a724*a775;
a675=a323*a675;
a775=a775+a675;
a420=a747*a420;
a456=a231*a456;
a420=a420+a456;
a775=a775+a420;
a736=a736-a775;
a001=a001+a736;
a775=a025<=a033;
a033=a033<=a025;
a033=a033+a775;
a775=a775/a033;
a033=arg[4]? arg[4][26] : 0;
a420=a247*a286;
a456=a244*a286;
a420=a420+a456;
a420=a420+a752;
a033=a033-a420;
a420=a248*a803;
a033=a033+a420;
a033=a033-a271;
a420=a208*a033;
a456=a775*a420;
a675=a085<=a055;
a055=a055<=a085;
a055=a055+a675;
a675=a675/a055;
a055=a025<=a037;
a037=a037<=a025;
a037=a037+a055;
a055=a055/a037;
a037=2.*a088;
a085=a189*a420;
a292=a061*a085;
a423=a037*a292;
a085=a063*a085;
a423=a423-a085;
a085=a190*a420;
a085=a009*a085;
a226=a181*a085;
a423=a423+a226;
a226=2.*a088;
a446=a088*a085;
a140=a226*a446;
a423=a423+a140;
a423=a055*a423;
a423=a675*a423;
a423=a056*a423;
a456=a456+a423;
a423=a456*a408;
a401=a033*a401;
a140=arg[12]? arg[12][26] : 0;
a443=a286*a443;
a247=a247*a484;
a443=a443+a247;
a440=a286*a440;
a244=a244*a484;
a440=a440+a244;
a443=a443+a440;
a443=a443+a428;
a140=a140-a443;
a445=a803*a445;
a248=a248*a790;
a445=a445+a248;
a140=a140+a445;
a140=a140-a437;
a208=a208*a140;
a401=a401+a208;
a775=a775*a401;
a208=2.*a404;
a292=a292*a208;
a405=a420*a405;
a189=a189*a401;
a405=a405+a189;
a061=a061*a405;
a037=a037*a061;
a292=a292+a037;
a063=a063*a405;
a292=a292-a063;
a409=a085*a409;
a420=a420*a411;
a190=a190*a401;
a420=a420+a190;
a420=a009*a420;
a181=a181*a420;
a409=a409+a181;
a292=a292+a409;
a409=2.*a404;
a446=a446*a409;
a085=a085*a404;
a088=a088*a420;
a085=a085+a088;
a226=a226*a085;
a446=a446+a226;
a292=a292+a446;
a055=a055*a292;
a675=a675*a055;
a056=a056*a675;
a775=a775+a056;
a056=a084*a775;
a423=a423+a056;
a056=a148*a456;
a675=2.*a084;
a056=a056/a675;
a055=2.*a406;
a055=a056*a055;
a292=2.*a148;
a406=a456*a406;
a148=a148*a775;
a406=a406+a148;
a406=a406/a675;
a675=a056/a675;
a408=2.*a408;
a675=a675*a408;
a406=a406-a675;
a406=a292*a406;
a055=a055+a406;
a423=a423+a055;
a001=a001+a423;
if (res[0]!=0) res[0][0]=a001;
a007=a007*a002;
a027=a015*a027;
a007=a007-a027;
a019=a020*a019;
a010=a010*a018;
a019=a019+a010;
a007=a007-a019;
a154=2.*a154;
a154=a095*a154;
a051=2.*a051;
a180=a051*a180;
a154=a154+a180;
a175=a175/a103;
a066=a066/a103;
a103=a066/a103;
a103=a103*a188;
a175=a175-a103;
a175=a126*a175;
a042=a066*a042;
a175=a175+a042;
a154=a154+a175;
a007=a007+a154;
a470=a298*a470;
a175=a057*a297;
a470=a470+a175;
a175=a104*a294;
a479=a462*a479;
a175=a175-a479;
a470=a470+a175;
a007=a007+a470;
a175=a453*a618;
a651=a637*a651;
a175=a175-a651;
a651=a272-a529;
a642=a651*a642;
a479=a321-a528;
a042=a478*a479;
a642=a642+a042;
a175=a175+a642;
a642=a368*a751;
a772=a764*a772;
a642=a642-a772;
a175=a175+a642;
a007=a007+a175;
a430=a430/a771;
a233=a233/a771;
a771=a233/a771;
a771=a771*a807;
a430=a430-a771;
a430=a794*a430;
a425=a233*a425;
a430=a430+a425;
a162=2.*a162;
a162=a744*a162;
a053=2.*a053;
a769=a053*a769;
a162=a162+a769;
a430=a430+a162;
a007=a007+a430;
if (res[0]!=0) res[0][1]=a007;
a051=a051*a095;
a066=a066*a126;
a051=a051+a066;
a156=a051*a156;
a047=a047*a154;
a156=a156+a047;
a422=a750*a422;
a047=a225*a795;
a422=a422+a047;
a671=a671*a422;
a225=a225*a750;
a733=a225*a733;
a671=a671+a733;
a156=a156+a671;
a057=a057*a298;
a104=a104*a462;
a057=a057+a104;
a468=a057*a468;
a182=a182*a470;
a468=a468+a182;
a156=a156+a468;
a687=a687*a272;
a125=a125*a529;
a127=a127*a637;
a125=a125+a127;
a687=a687-a125;
a650=a650*a764;
a687=a687-a650;
a634=a687*a634;
a636=a636+a654;
a641=a641-a636;
a641=a641-a774;
a357=a357*a641;
a634=a634+a357;
a634=a036*a634;
a156=a156+a634;
a453=a453*a637;
a478=a478*a651;
a453=a453+a478;
a368=a368*a764;
a453=a453+a368;
a640=a453*a640;
a041=a041*a175;
a640=a640+a041;
a156=a156+a640;
if (res[0]!=0) res[0][2]=a156;
if (res[0]!=0) res[0][3]=a025;
a156=arg[0]? arg[0][4] : 0;
a156=casadi_sign(a156);
a640=arg[12]? arg[12][37] : 0;
a156=a156*a640;
if (res[0]!=0) res[0][4]=a156;
a156=casadi_sign(a000);
a041=arg[12]? arg[12][38] : 0;
a156=a156*a041;
a368=cos(a000);
a478=a020*a017;
a634=a006*a018;
a478=a478+a634;
a368=a368*a478;
a478=a006*a020;
a634=sin(a000);
a634=a634*a016;
a478=a478*a634;
a368=a368-a478;
a156=a156-a368;
a368=a003*a020;
a478=cos(a000);
a478=a478*a016;
a368=a368*a478;
a478=sin(a000);
a020=a020*a013;
a018=a003*a018;
a020=a020+a018;
a478=a478*a020;
a368=a368+a478;
a156=a156-a368;
a368=a006*a015;
a478=cos(a000);
a478=a478*a016;
a368=a368*a478;
a478=sin(a000);
a017=a015*a017;
a006=a006*a002;
a017=a017+a006;
a478=a478*a017;
a368=a368+a478;
a156=a156-a368;
a368=cos(a000);
a478=a015*a013;
a002=a003*a002;
a478=a478+a002;
a368=a368*a478;
a015=a003*a015;
a478=sin(a000);
a478=a478*a016;
a015=a015*a478;
a368=a368-a015;
a156=a156+a368;
a368=cos(a000);
a233=a233*a794;
a053=a053*a744;
a233=a233+a053;
a233=a051+a233;
a053=a233*a139;
a430=a154+a430;
a744=a004*a430;
a053=a053+a744;
a368=a368*a053;
a053=a004*a233;
a744=sin(a000);
a744=a744*a016;
a053=a053*a744;
a368=a368-a053;
a156=a156+a368;
a368=a024*a233;
a053=cos(a000);
a053=a053*a016;
a368=a368*a053;
a053=sin(a000);
a744=a233*a142;
a794=a024*a430;
a744=a744+a794;
a053=a053*a744;
a368=a368+a053;
a156=a156+a368;
a368=cos(a000);
a008=a008*a130;
a138=a138*a131;
a008=a008+a138;
a804=a804*a737;
a323=a323*a724;
a231=a231*a747;
a323=a323+a231;
a804=a804-a323;
a008=a008+a804;
a084=a084*a456;
a292=a292*a056;
a084=a084+a292;
a008=a008+a084;
a142=a008*a142;
a145=a145+a736;
a145=a145+a423;
a423=a024*a145;
a142=a142+a423;
a368=a368*a142;
a024=a024*a008;
a142=sin(a000);
a142=a142*a016;
a024=a024*a142;
a368=a368-a024;
a156=a156-a368;
a368=a004*a008;
a024=cos(a000);
a024=a024*a016;
a368=a368*a024;
a000=sin(a000);
a139=a008*a139;
a004=a004*a145;
a139=a139+a004;
a000=a000*a139;
a368=a368+a000;
a156=a156+a368;
if (res[0]!=0) res[0][5]=a156;
a165=a233*a165;
a054=a054*a430;
a165=a165+a054;
a005=a005*a145;
a141=a008*a141;
a005=a005-a141;
a165=a165-a005;
if (res[1]!=0) res[1][0]=a165;
a052=a052*a430;
a233=a233*a163;
a052=a052-a233;
a008=a008*a144;
a012=a012*a145;
a008=a008+a012;
a052=a052+a008;
a052=-a052;
if (res[1]!=0) res[1][1]=a052;
a052=a803-a286;
a008=a257*a052;
a452=a008*a452;
a012=a790-a484;
a257=a257*a012;
a454=a052*a454;
a257=a257-a454;
a255=a255*a257;
a452=a452+a255;
a283=a283+a452;
a035=a035+a775;
a775=a035/a032;
a130=a130+a456;
a456=a130/a032;
a456=a456/a032;
a456=a456*a170;
a775=a775-a456;
a775=2.*a775;
a283=a283+a775;
if (res[1]!=0) res[1][2]=a283;
a283=a251*a740;
a451=a283*a451;
a740=a740*a447;
a251=a251*a732;
a740=a740+a251;
a254=a254*a740;
a451=a451+a254;
a254=arg[4]? arg[4][24] : 0;
a251=a192<=a072;
a072=a072<=a192;
a192=a072+a251;
a251=a251/a192;
a732=a120<=a193;
a193=a193<=a120;
a120=a193+a732;
a732=a732/a120;
a447=a025<=a080;
a080=a080<=a025;
a080=a080+a447;
a447=a447/a080;
a080=arg[4]? arg[4][25] : 0;
a775=a191*a033;
a456=a207*a775;
a452=a030*a456;
a255=a204*a452;
a255=a036*a255;
a080=a080+a255;
a255=a202*a080;
a255=a036*a255;
a454=a203*a080;
a454=a075*a454;
a145=a201*a454;
a255=a255-a145;
a145=2.*a194;
a144=a194*a454;
a233=a145*a144;
a255=a255-a233;
a255=a447*a255;
a255=a078*a255;
a255=a255+a080;
a233=a025<=a195;
a195=a195<=a025;
a195=a195+a233;
a233=a233/a195;
a195=a199*a080;
a195=a075*a195;
a163=a197*a195;
a430=a198*a080;
a430=a036*a430;
a163=a163-a430;
a430=2.*a196;
a165=a196*a195;
a005=a430*a165;
a163=a163+a005;
a163=a233*a163;
a163=a078*a163;
a255=a255-a163;
a255=a732*a255;
a255=a251*a255;
a163=a119*a255;
a254=a254+a163;
a394=a254*a394;
a163=arg[12]? arg[12][24] : 0;
a389=a255*a389;
a390=a080*a390;
a005=arg[12]? arg[12][25] : 0;
a399=a452*a399;
a141=a456*a172;
a402=a775*a402;
a033=a033*a410;
a191=a191*a140;
a033=a033+a191;
a207=a207*a033;
a402=a402+a207;
a207=a030*a402;
a141=a141+a207;
a204=a204*a141;
a399=a399+a204;
a399=a036*a399;
a005=a005+a399;
a202=a202*a005;
a390=a390+a202;
a390=a036*a390;
a384=a454*a384;
a203=a203*a005;
a398=a080*a398;
a203=a203-a398;
a203=a075*a203;
a201=a201*a203;
a384=a384+a201;
a390=a390-a384;
a384=2.*a395;
a144=a144*a384;
a454=a454*a395;
a194=a194*a203;
a454=a454+a194;
a145=a145*a454;
a144=a144+a145;
a390=a390-a144;
a447=a447*a390;
a390=a078*a447;
a390=a390+a005;
a387=a195*a387;
a199=a199*a005;
a391=a080*a391;
a199=a199-a391;
a199=a075*a199;
a197=a197*a199;
a387=a387+a197;
a080=a080*a386;
a198=a198*a005;
a080=a080+a198;
a080=a036*a080;
a387=a387-a080;
a080=2.*a385;
a165=a165*a080;
a195=a195*a385;
a196=a196*a199;
a195=a195+a196;
a430=a430*a195;
a165=a165+a430;
a387=a387+a165;
a233=a233*a387;
a387=a078*a233;
a390=a390-a387;
a732=a732*a390;
a251=a251*a732;
a119=a119*a251;
a389=a389+a119;
a163=a163+a389;
a074=a074*a163;
a394=a394+a074;
a451=a451+a394;
if (res[1]!=0) res[1][3]=a451;
a432=a542*a432;
a573=a573+a432;
a697=a697*a759;
a584=a584*a134;
a697=a697+a584;
a573=a573+a697;
if (res[1]!=0) res[1][4]=a573;
a542=a542*a530;
a664=a664+a542;
a514=a514*a438;
a469=a469*a339;
a514=a514+a469;
a664=a664+a514;
if (res[1]!=0) res[1][5]=a664;
a664=cos(a023);
a514=a617*a261;
a469=a514*a280;
a438=a664*a469;
a542=sin(a023);
a530=a116*a261;
a573=a530*a132;
a697=a573*a280;
a584=a542*a697;
a438=a438-a584;
a584=sin(a023);
a759=a514*a287;
a432=a584*a759;
a438=a438+a432;
a432=cos(a023);
a451=a573*a287;
a394=a432*a451;
a438=a438+a394;
a394=cos(a023);
a074=a174*a298;
a389=a394*a074;
a438=a438+a389;
a389=sin(a023);
a119=a003*a298;
a387=a389*a119;
a438=a438-a387;
a387=cos(a023);
a165=a003*a462;
a430=a387*a165;
a438=a438-a430;
a430=sin(a023);
a195=a174*a462;
a196=a430*a195;
a438=a438-a196;
a196=a136*a438;
a464=a196*a464;
a275=a261*a275;
a617=a617*a376;
a275=a275+a617;
a617=a280*a275;
a199=a514*a483;
a617=a617+a199;
a664=a664*a617;
a617=sin(a023);
a617=a617*a465;
a469=a469*a617;
a664=a664-a469;
a469=cos(a023);
a469=a469*a465;
a697=a697*a469;
a341=a261*a341;
a116=a116*a376;
a341=a341+a116;
a132=a132*a341;
a116=a530*a466;
a132=a132-a116;
a280=a280*a132;
a483=a573*a483;
a280=a280+a483;
a542=a542*a280;
a697=a697+a542;
a664=a664-a697;
a697=cos(a023);
a697=a697*a465;
a759=a759*a697;
a697=a287*a275;
a542=a514*a480;
a697=a697+a542;
a584=a584*a697;
a759=a759+a584;
a664=a664+a759;
a287=a287*a132;
a480=a573*a480;
a287=a287+a480;
a432=a432*a287;
a287=sin(a023);
a287=a287*a465;
a451=a451*a287;
a432=a432-a451;
a664=a664+a432;
a432=a298*a467;
a451=a174*a297;
a432=a432+a451;
a394=a394*a432;
a432=sin(a023);
a432=a432*a465;
a074=a074*a432;
a394=a394-a074;
a664=a664+a394;
a394=cos(a023);
a394=a394*a465;
a119=a119*a394;
a298=a298*a013;
a297=a003*a297;
a298=a298+a297;
a389=a389*a298;
a119=a119+a389;
a664=a664-a119;
a013=a462*a013;
a003=a003*a294;
a013=a013+a003;
a387=a387*a013;
a013=sin(a023);
a013=a013*a465;
a165=a165*a013;
a387=a387-a165;
a664=a664-a387;
a023=cos(a023);
a023=a023*a465;
a195=a195*a023;
a462=a462*a467;
a174=a174*a294;
a462=a462+a174;
a430=a430*a462;
a195=a195+a430;
a664=a664-a195;
a136=a136*a664;
a466=a438*a466;
a136=a136-a466;
a135=a135*a136;
a464=a464+a135;
a135=a717*a570;
a466=a071*a123;
a135=a135-a466;
a466=a749*a558;
a135=a135+a466;
a176=a135*a176;
a806=a570*a806;
a717=a717*a809;
a806=a806+a717;
a177=a123*a177;
a071=a071*a040;
a177=a177+a071;
a806=a806-a177;
a766=a558*a766;
a749=a749*a814;
a766=a766+a749;
a806=a806+a766;
a070=a070*a806;
a176=a176+a070;
a464=a464-a176;
if (res[1]!=0) res[1][6]=a464;
if (res[1]!=0) res[1][7]=a136;
if (res[1]!=0) res[1][8]=a806;
a501=a570*a501;
a768=a768*a809;
a501=a501+a768;
a738=a626*a738;
a778=a778*a812;
a738=a738+a778;
a501=a501+a738;
if (res[1]!=0) res[1][9]=a501;
a501=sin(a045);
a738=a501*a093;
a778=a738*a159;
a768=cos(a045);
a768=a768*a158;
a768=a093*a768;
a501=a501*a183;
a768=a768+a501;
a501=a048*a768;
a778=a778+a501;
a160=a098*a160;
a050=a050*a096;
a160=a160+a050;
a778=a778-a160;
a778=a778+a186;
if (res[1]!=0) res[1][10]=a778;
a778=a329*a527;
a186=a778*a730;
a160=a600*a527;
a050=a160*a568;
a186=a186-a050;
a050=a186*a286;
a501=a705*a498;
a464=a501*a490;
a176=a305*a498;
a070=a176*a595;
a464=a464+a070;
a070=a464*a286;
a050=a050-a070;
a070=a501*a366;
a766=a176*a597;
a070=a070-a766;
a766=a070*a093;
a050=a050-a766;
a766=a160*a580;
a749=a778*a728;
a766=a766+a749;
a749=a766*a093;
a050=a050+a749;
a655=a050*a655;
a582=a527*a582;
a329=a329*a757;
a582=a582+a329;
a730=a730*a582;
a802=a778*a802;
a730=a730+a802;
a527=a527*a760;
a600=a600*a757;
a527=a527+a600;
a568=a568*a527;
a344=a160*a344;
a568=a568-a344;
a730=a730-a568;
a568=a286*a730;
a344=a186*a484;
a568=a568+a344;
a459=a498*a459;
a705=a705*a624;
a459=a459+a705;
a490=a490*a459;
a659=a501*a659;
a490=a490-a659;
a498=a498*a538;
a305=a305*a624;
a498=a498+a305;
a595=a595*a498;
a701=a176*a701;
a595=a595+a701;
a490=a490+a595;
a595=a286*a490;
a701=a464*a484;
a595=a595+a701;
a568=a568-a595;
a366=a366*a459;
a311=a501*a311;
a366=a366+a311;
a597=a597*a498;
a704=a176*a704;
a597=a597-a704;
a366=a366-a597;
a597=a093*a366;
a704=a070*a183;
a597=a597+a704;
a568=a568-a597;
a580=a580*a527;
a695=a160*a695;
a580=a580+a695;
a728=a728*a582;
a801=a778*a801;
a728=a728-a801;
a580=a580+a728;
a728=a093*a580;
a801=a766*a183;
a728=a728+a801;
a568=a568+a728;
a355=a355*a568;
a655=a655+a355;
a355=a098*a366;
a728=a070*a096;
a355=a355+a728;
a728=a098*a580;
a801=a766*a096;
a728=a728+a801;
a801=a355-a728;
a695=a303*a383;
a350=a077*a350;
a695=a695+a350;
a801=a801+a695;
a350=a453*a153;
a175=a043*a175;
a350=a350+a175;
a801=a801+a350;
a630=a630/a258;
a062=a062/a258;
a175=a062/a258;
a175=a175*a461;
a630=a630-a175;
a630=a249*a630;
a266=a062*a266;
a630=a630+a266;
a429=a429/a258;
a241=a241/a258;
a258=a241/a258;
a258=a258*a461;
a429=a429-a258;
a429=a541*a429;
a796=a241*a796;
a429=a429+a796;
a630=a630-a429;
a801=a801+a630;
a235=a235*a801;
a429=a070*a098;
a796=a766*a098;
a258=a429-a796;
a303=a077*a303;
a258=a258+a303;
a453=a043*a453;
a258=a258+a453;
a062=a062*a249;
a241=a241*a541;
a062=a062-a241;
a258=a258+a062;
a433=a258*a433;
a235=a235-a433;
a655=a655+a235;
if (res[2]!=0) res[2][0]=a655;
a655=a573*a348;
a235=a514*a285;
a655=a655-a235;
a235=a655*a168;
a433=a235*a286;
a241=cos(a045);
a241=a241*a158;
a433=a433*a241;
a241=sin(a045);
a348=a348*a132;
a520=a573*a520;
a348=a348+a520;
a285=a285*a275;
a485=a514*a485;
a285=a285-a485;
a348=a348-a285;
a285=a168*a348;
a485=a655*a458;
a285=a285+a485;
a285=a286*a285;
a235=a235*a484;
a285=a285+a235;
a241=a241*a285;
a433=a433+a241;
a241=a464*a286;
a285=a186*a286;
a241=a241-a285;
a285=a237*a241;
a235=cos(a045);
a235=a235*a158;
a285=a285*a235;
a235=sin(a045);
a485=a241*a434;
a520=a286*a490;
a541=a464*a484;
a520=a520+a541;
a541=a286*a730;
a249=a186*a484;
a541=a541+a249;
a520=a520-a541;
a541=a237*a520;
a485=a485+a541;
a235=a235*a485;
a285=a285+a235;
a433=a433-a285;
a285=cos(a045);
a235=a655*a286;
a485=a514*a277;
a541=a573*a346;
a485=a485+a541;
a541=a485*a093;
a235=a235+a541;
a541=a235*a455;
a249=a286*a348;
a461=a655*a484;
a249=a249+a461;
a277=a277*a275;
a514=a514*a471;
a277=a277+a514;
a346=a346*a132;
a573=a573*a519;
a346=a346-a573;
a277=a277+a346;
a346=a093*a277;
a573=a485*a183;
a346=a346+a573;
a249=a249+a346;
a346=a058*a249;
a541=a541+a346;
a285=a285*a541;
a541=a058*a235;
a346=sin(a045);
a346=a346*a158;
a541=a541*a346;
a285=a285-a541;
a433=a433+a285;
a285=a485*a168;
a541=a285*a093;
a346=cos(a045);
a346=a346*a158;
a541=a541*a346;
a346=sin(a045);
a573=a168*a277;
a519=a485*a458;
a573=a573+a519;
a573=a093*a573;
a285=a285*a183;
a573=a573+a285;
a346=a346*a573;
a541=a541+a346;
a433=a433+a541;
a541=a070*a237;
a346=a541*a093;
a573=cos(a045);
a573=a573*a158;
a346=a346*a573;
a573=sin(a045);
a285=a237*a366;
a519=a070*a434;
a285=a285+a519;
a285=a093*a285;
a541=a541*a183;
a285=a285+a541;
a573=a573*a285;
a346=a346+a573;
a433=a433-a346;
a346=cos(a045);
a573=a050*a431;
a568=a234*a568;
a573=a573+a568;
a346=a346*a573;
a050=a234*a050;
a573=sin(a045);
a573=a573*a158;
a050=a050*a573;
a346=a346-a050;
a433=a433+a346;
a346=a766*a237;
a050=a346*a093;
a573=cos(a045);
a573=a573*a158;
a050=a050*a573;
a573=sin(a045);
a568=a237*a580;
a285=a766*a434;
a568=a568+a285;
a568=a093*a568;
a346=a346*a183;
a568=a568+a346;
a573=a573*a568;
a050=a050+a573;
a433=a433+a050;
a050=a090*a112;
a573=a050*a044;
a568=a573*a093;
a346=cos(a045);
a346=a346*a158;
a568=a568*a346;
a346=sin(a045);
a112=a112*a179;
a090=a090*a173;
a112=a112+a090;
a090=a044*a112;
a173=a050*a155;
a090=a090+a173;
a090=a093*a090;
a573=a573*a183;
a090=a090+a573;
a346=a346*a090;
a568=a568+a346;
a433=a433+a568;
a568=cos(a045);
a346=a048*a112;
a090=a050*a159;
a346=a346+a090;
a346=a093*a346;
a090=a050*a048;
a573=a090*a183;
a346=a346+a573;
a568=a568*a346;
a090=a090*a093;
a346=sin(a045);
a346=a346*a158;
a090=a090*a346;
a568=a568-a090;
a433=a433-a568;
a568=cos(a045);
a090=arg[9]? arg[9][10] : 0;
a346=a048*a090;
a573=arg[1]? arg[1][10] : 0;
a173=a573*a159;
a346=a346+a173;
a346=a093*a346;
a173=a573*a048;
a183=a173*a183;
a346=a346+a183;
a568=a568*a346;
a173=a173*a093;
a093=sin(a045);
a093=a093*a158;
a173=a173*a093;
a568=a568-a173;
a433=a433+a568;
a568=a573*a098;
a173=a043*a051;
a093=a050*a098;
a173=a173-a093;
a568=a568+a173;
a093=a048*a568;
a346=cos(a045);
a346=a346*a158;
a093=a093*a346;
a346=sin(a045);
a159=a568*a159;
a183=a098*a090;
a179=a573*a096;
a183=a183+a179;
a051=a051*a153;
a154=a043*a154;
a051=a051+a154;
a154=a098*a112;
a179=a050*a096;
a154=a154+a179;
a051=a051-a154;
a183=a183+a051;
a048=a048*a183;
a159=a159+a048;
a346=a346*a159;
a093=a093+a346;
a433=a433+a093;
a093=cos(a045);
a155=a173*a155;
a346=a044*a051;
a155=a155+a346;
a093=a093*a155;
a044=a044*a173;
a155=sin(a045);
a155=a155*a158;
a044=a044*a155;
a093=a093-a044;
a433=a433+a093;
a093=arg[12]? arg[12][12] : 0;
a433=a433+a093;
a093=cos(a045);
a429=a429-a796;
a429=a429+a303;
a429=a429+a453;
a429=a429+a062;
a434=a429*a434;
a355=a355-a728;
a355=a355+a695;
a355=a355+a350;
a355=a355+a630;
a350=a237*a355;
a434=a434+a350;
a093=a093*a434;
a237=a237*a429;
a434=sin(a045);
a434=a434*a158;
a237=a237*a434;
a093=a093-a237;
a433=a433+a093;
a093=a234*a258;
a237=cos(a045);
a237=a237*a158;
a093=a093*a237;
a237=sin(a045);
a258=a258*a431;
a234=a234*a801;
a258=a258+a234;
a237=a237*a258;
a093=a093+a237;
a433=a433-a093;
a093=a256*a052;
a237=cos(a045);
a237=a237*a158;
a093=a093*a237;
a237=sin(a045);
a052=a052*a448;
a256=a256*a012;
a052=a052+a256;
a237=a237*a052;
a093=a093+a237;
a433=a433-a093;
a450=a283*a450;
a253=a253*a740;
a450=a450+a253;
a433=a433+a450;
a450=cos(a045);
a253=a209*a803;
a093=a209*a286;
a093=a253-a093;
a442=a093*a442;
a803=a803*a403;
a790=a209*a790;
a803=a803+a790;
a790=a286*a403;
a237=a209*a484;
a790=a790+a237;
a790=a803-a790;
a237=a245*a790;
a442=a442+a237;
a450=a450*a442;
a245=a245*a093;
a442=sin(a045);
a442=a442*a158;
a245=a245*a442;
a450=a450-a245;
a433=a433+a450;
a450=a209*a286;
a253=a253-a450;
a450=a242*a253;
a245=cos(a045);
a245=a245*a158;
a450=a450*a245;
a245=sin(a045);
a439=a253*a439;
a286=a286*a403;
a209=a209*a484;
a286=a286+a209;
a803=a803-a286;
a242=a242*a803;
a439=a439+a242;
a245=a245*a439;
a450=a450+a245;
a433=a433-a450;
a450=cos(a045);
a245=a043*a057;
a439=a485*a098;
a242=a245-a439;
a242=a242-a062;
a286=a077*a645;
a242=a242-a286;
a458=a242*a458;
a057=a057*a153;
a470=a043*a470;
a057=a057+a470;
a470=a098*a277;
a209=a485*a096;
a470=a470+a209;
a209=a057-a470;
a209=a209-a630;
a645=a645*a383;
a077=a077*a598;
a645=a645+a077;
a209=a209-a645;
a077=a168*a209;
a458=a458+a077;
a450=a450*a458;
a168=a168*a242;
a458=sin(a045);
a458=a458*a158;
a168=a168*a458;
a450=a450-a168;
a433=a433+a450;
a245=a245-a439;
a245=a245-a062;
a245=a245-a286;
a286=a058*a245;
a062=cos(a045);
a062=a062*a158;
a286=a286*a062;
a062=sin(a045);
a455=a245*a455;
a057=a057-a470;
a057=a057-a630;
a057=a057-a645;
a058=a058*a057;
a455=a455+a058;
a062=a062*a455;
a286=a286+a062;
a433=a433-a286;
a286=a212<=a039;
a039=a039<=a212;
a212=a039+a286;
a286=a286/a212;
a062=a211<=a214;
a214=a214<=a211;
a211=a214+a062;
a062=a062/a211;
a455=a025<=a210;
a210=a210<=a025;
a210=a210+a455;
a455=a455/a210;
a221=2.*a221;
a210=a230*a753;
a058=a516*a210;
a645=a221*a058;
a630=arg[4]? arg[4][14] : 0;
a645=a645+a630;
a630=a230*a748;
a645=a645+a630;
a630=a223*a645;
a630=a036*a630;
a470=a224*a645;
a470=a075*a470;
a439=a222*a470;
a630=a630-a439;
a439=2.*a215;
a450=a215*a470;
a168=a439*a450;
a630=a630-a168;
a630=a455*a630;
a630=a078*a630;
a630=a630+a645;
a168=a025<=a216;
a216=a216<=a025;
a216=a216+a168;
a168=a168/a216;
a216=a220*a645;
a216=a075*a216;
a458=a218*a216;
a077=a219*a645;
a077=a036*a077;
a458=a458-a077;
a077=2.*a217;
a598=a217*a216;
a383=a077*a598;
a458=a458+a383;
a458=a168*a458;
a458=a078*a458;
a630=a630-a458;
a630=a062*a630;
a630=a286*a630;
a418=a630*a418;
a417=a645*a417;
a415=2.*a415;
a058=a058*a415;
a722=a210*a722;
a753=a753*a427;
a715=a230*a715;
a753=a753+a715;
a516=a516*a753;
a722=a722+a516;
a221=a221*a722;
a058=a058+a221;
a221=arg[12]? arg[12][14] : 0;
a058=a058+a221;
a748=a748*a427;
a250=a230*a250;
a748=a748+a250;
a058=a058+a748;
a223=a223*a058;
a417=a417+a223;
a417=a036*a417;
a412=a470*a412;
a224=a224*a058;
a421=a645*a421;
a224=a224-a421;
a224=a075*a224;
a222=a222*a224;
a412=a412+a222;
a417=a417-a412;
a412=2.*a419;
a450=a450*a412;
a470=a470*a419;
a215=a215*a224;
a470=a470+a215;
a439=a439*a470;
a450=a450+a439;
a417=a417-a450;
a455=a455*a417;
a417=a078*a455;
a417=a417+a058;
a414=a216*a414;
a220=a220*a058;
a416=a645*a416;
a220=a220-a416;
a075=a075*a220;
a218=a218*a075;
a414=a414+a218;
a645=a645*a413;
a219=a219*a058;
a645=a645+a219;
a645=a036*a645;
a414=a414-a645;
a645=2.*a407;
a598=a598*a645;
a216=a216*a407;
a217=a217*a075;
a216=a216+a217;
a077=a077*a216;
a598=a598+a077;
a414=a414+a598;
a168=a168*a414;
a078=a078*a168;
a417=a417-a078;
a062=a062*a417;
a286=a286*a062;
a213=a213*a286;
a418=a418+a213;
a433=a433+a418;
a151=a151*a163;
a396=a254*a396;
a151=a151-a396;
a433=a433+a151;
if (res[2]!=0) res[2][1]=a433;
a433=a176*a356;
a151=cos(a481);
a151=a151*a638;
a433=a433*a151;
a151=sin(a481);
a396=a356*a498;
a418=a176*a649;
a396=a396+a418;
a151=a151*a396;
a433=a433+a151;
a151=cos(a481);
a396=a356*a459;
a649=a501*a649;
a396=a396+a649;
a151=a151*a396;
a356=a501*a356;
a396=sin(a481);
a396=a396*a638;
a356=a356*a396;
a151=a151-a356;
a433=a433+a151;
a151=a778*a565;
a356=cos(a481);
a356=a356*a638;
a151=a151*a356;
a356=sin(a481);
a396=a565*a582;
a649=a778*a770;
a396=a396+a649;
a356=a356*a396;
a151=a151+a356;
a433=a433-a151;
a151=cos(a481);
a356=a565*a527;
a770=a160*a770;
a356=a356+a770;
a151=a151*a356;
a565=a160*a565;
a356=sin(a481);
a356=a356*a638;
a565=a565*a356;
a151=a151-a565;
a433=a433+a151;
a151=cos(a481);
a498=a524*a498;
a565=a176*a657;
a498=a498+a565;
a151=a151*a498;
a176=a176*a524;
a498=sin(a481);
a498=a498*a638;
a176=a176*a498;
a151=a151-a176;
a433=a433+a151;
a151=a501*a524;
a176=cos(a481);
a176=a176*a638;
a151=a151*a176;
a176=sin(a481);
a524=a524*a459;
a501=a501*a657;
a524=a524+a501;
a176=a176*a524;
a151=a151+a176;
a433=a433-a151;
a151=a160*a677;
a176=cos(a481);
a176=a176*a638;
a151=a151*a176;
a176=sin(a481);
a527=a677*a527;
a160=a160*a653;
a527=a527+a160;
a176=a176*a527;
a151=a151+a176;
a433=a433+a151;
a151=cos(a481);
a582=a677*a582;
a653=a778*a653;
a582=a582+a653;
a151=a151*a582;
a778=a778*a677;
a677=sin(a481);
a677=a677*a638;
a778=a778*a677;
a151=a151-a778;
a433=a433+a151;
a151=a324*a529;
a778=cos(a481);
a778=a778*a638;
a151=a151*a778;
a778=sin(a481);
a529=a529*a635;
a324=a324*a528;
a529=a529+a324;
a778=a778*a529;
a151=a151+a778;
a433=a433-a151;
a151=cos(a481);
a652=a637*a652;
a778=a372*a618;
a652=a652+a778;
a151=a151*a652;
a372=a372*a637;
a652=sin(a481);
a652=a652*a638;
a372=a372*a652;
a151=a151-a372;
a433=a433+a151;
a151=a476*a637;
a372=cos(a481);
a372=a372*a638;
a151=a151*a372;
a372=sin(a481);
a637=a637*a639;
a618=a476*a618;
a637=a637+a618;
a372=a372*a637;
a151=a151+a372;
a433=a433-a151;
a151=a369*a272;
a372=cos(a481);
a372=a372*a638;
a151=a151*a372;
a372=sin(a481);
a272=a272*a762;
a369=a369*a321;
a272=a272+a369;
a372=a372*a272;
a151=a151+a372;
a433=a433-a151;
a151=cos(a481);
a372=a651*a639;
a479=a476*a479;
a372=a372+a479;
a151=a151*a372;
a651=a476*a651;
a372=sin(a481);
a372=a372*a638;
a651=a651*a372;
a151=a151-a651;
a433=a433+a151;
a151=cos(a481);
a633=a764*a633;
a651=a517*a751;
a633=a633+a651;
a151=a151*a633;
a517=a517*a764;
a633=sin(a481);
a633=a633*a638;
a517=a517*a633;
a151=a151-a517;
a433=a433-a151;
a151=a476*a764;
a517=cos(a481);
a517=a517*a638;
a151=a151*a517;
a481=sin(a481);
a764=a764*a639;
a476=a476*a751;
a764=a764+a476;
a481=a481*a764;
a151=a151+a481;
a433=a433-a151;
if (res[2]!=0) res[2][2]=a433;
a433=a036*a490;
a433=a098*a433;
a151=a036*a464;
a151=a151*a096;
a433=a433+a151;
a151=a036*a730;
a098=a098*a151;
a151=a036*a186;
a151=a151*a096;
a098=a098+a151;
a433=a433+a098;
a687=a687*a632;
a510=a510*a641;
a687=a687+a510;
a433=a433+a687;
if (res[2]!=0) res[2][3]=a433;
a340=a340*a520;
a241=a241*a351;
a340=a340-a241;
a363=a363*a366;
a360=a070*a360;
a363=a363+a360;
a340=a340+a363;
a574=a574*a580;
a685=a766*a685;
a574=a574+a685;
a340=a340-a574;
a429=a429*a436;
a238=a238*a355;
a429=a429+a238;
a340=a340+a429;
if (res[2]!=0) res[2][4]=a340;
a493=2.*a493;
a340=a493*a628;
a429=2.*a474;
a340=a340*a429;
a429=2.*a133;
a646=2.*a646;
a628=a628*a646;
a493=a493*a670;
a628=a628+a493;
a429=a429*a628;
a340=a340+a429;
a060=2.*a060;
a429=a060*a486;
a628=2.*a474;
a429=a429*a628;
a628=2.*a133;
a473=2.*a473;
a486=a486*a473;
a060=a060*a509;
a486=a486+a060;
a628=a628*a486;
a429=a429+a628;
a340=a340-a429;
a694=2.*a694;
a429=a694*a583;
a628=2.*a474;
a429=a429*a628;
a628=2.*a133;
a767=2.*a767;
a583=a583*a767;
a694=a694*a780;
a583=a583+a694;
a628=a628*a583;
a429=a429+a628;
a340=a340+a429;
a342=a342+a669;
a342=a342+a779;
a342=a009*a342;
a474=2.*a474;
a342=a342*a474;
a133=2.*a133;
a128=a128+a539;
a128=a128+a581;
a009=a009*a128;
a133=a133*a009;
a342=a342+a133;
a340=a340+a342;
if (res[2]!=0) res[2][5]=a340;
a028=a028/a032;
a340=a028*a130;
a342=a340*a171;
a167=a167/a032;
a032=a028/a032;
a032=a032*a170;
a167=a167-a032;
a130=a130*a167;
a028=a028*a035;
a130=a130+a028;
a028=a031*a130;
a342=a342+a028;
a342=-a342;
if (res[2]!=0) res[2][6]=a342;
a113=a113*a038;
a089=a089*a091;
a113=a113+a089;
a422=a043*a422;
a153=a225*a153;
a422=a422+a153;
a579=a579*a422;
a225=a225*a043;
a164=a225*a164;
a579=a579+a164;
a113=a113+a579;
a798=a798*a424;
a229=a229*a627;
a798=a798+a229;
a113=a113+a798;
a456=a456*a397;
a205=a205*a402;
a456=a456+a205;
a113=a113+a456;
a456=a029*a340;
a031=2.*a031;
a456=a456/a031;
a205=2.*a172;
a205=a456*a205;
a402=2.*a030;
a340=a340*a169;
a029=a029*a130;
a340=a340+a029;
a340=a340/a031;
a456=a456/a031;
a171=2.*a171;
a456=a456*a171;
a340=a340-a456;
a402=a402*a340;
a205=a205+a402;
a113=a113-a205;
if (res[2]!=0) res[2][7]=a113;
a113=a254*a158;
a034=a034*a163;
a113=a113+a034;
a113=-a113;
if (res[2]!=0) res[2][8]=a113;
if (res[2]!=0) res[2][9]=a163;
a254=a254*a392;
a163=a118*a163;
a254=a254+a163;
if (res[2]!=0) res[2][10]=a254;
a255=a255*a393;
a086=a086*a251;
a255=a255+a086;
if (res[2]!=0) res[2][11]=a255;
a447=a076*a447;
a233=a076*a233;
a447=a447+a233;
a072=a072/a192;
a072=a072*a732;
a193=a193/a120;
a193=a193*a390;
a072=a072-a193;
a447=a447+a072;
if (res[2]!=0) res[2][12]=a447;
a452=a452*a388;
a200=a200*a141;
a452=a452+a200;
if (res[2]!=0) res[2][13]=a452;
a775=a775*a400;
a206=a206*a033;
a775=a775+a206;
if (res[2]!=0) res[2][14]=a775;
a544=a544*a795;
a750=a750*a788;
a544=a544+a750;
a547=a547*a544;
a741=a741*a426;
a228=a228*a709;
a741=a741+a228;
a741=a036*a741;
a547=a547+a741;
if (res[2]!=0) res[2][15]=a547;
if (res[2]!=0) res[2][16]=a740;
a547=a283*a158;
a741=a045*a740;
a547=a547+a741;
if (res[2]!=0) res[2][17]=a547;
a283=a283*a392;
a118=a118*a740;
a283=a283+a118;
if (res[2]!=0) res[2][18]=a283;
a735=a735*a427;
a449=a230*a449;
a735=a735+a449;
if (res[2]!=0) res[2][19]=a735;
if (res[2]!=0) res[2][20]=a286;
a630=a630*a158;
a045=a045*a286;
a630=a630+a045;
if (res[2]!=0) res[2][21]=a630;
a455=a076*a455;
a168=a076*a168;
a455=a455+a168;
a039=a039/a212;
a039=a039*a062;
a214=a214/a211;
a214=a214*a417;
a039=a039-a214;
a455=a455+a039;
if (res[2]!=0) res[2][22]=a455;
if (res[2]!=0) res[2][23]=a753;
a210=a210*a725;
a668=a668*a753;
a210=a210+a668;
if (res[2]!=0) res[2][24]=a210;
a235=a235*a482;
a278=a278*a249;
a235=a235+a278;
a129=a129*a057;
a245=a245*a457;
a129=a129-a245;
a235=a235+a129;
if (res[2]!=0) res[2][25]=a235;
a235=a752*a187;
a129=a100*a428;
a235=a235+a129;
a129=a271*a187;
a245=a100*a437;
a129=a129+a245;
a235=a235+a129;
if (res[2]!=0) res[2][26]=a235;
a752=a752*a382;
a428=a146*a428;
a752=a752+a428;
a428=a090-a112;
a235=a225*a030;
a545=a235*a545;
a030=a030*a422;
a225=a225*a172;
a030=a030+a225;
a225=a783*a030;
a545=a545+a225;
a225=a755*a427;
a811=a230*a811;
a225=a225+a811;
a545=a545+a225;
a428=a428+a545;
a428=a428-a580;
a428=a428+a366;
a428=a428-a277;
a428=a428/a100;
a366=a573-a050;
a783=a783*a235;
a755=a230*a755;
a783=a783+a755;
a366=a366+a783;
a366=a366-a766;
a366=a366+a070;
a366=a366-a485;
a366=a366/a100;
a070=a366/a100;
a070=a070*a187;
a428=a428-a070;
a428=a428/a100;
a366=a366/a100;
a070=a366/a100;
a070=a070*a187;
a428=a428-a070;
a099=a099*a428;
a366=a366*a184;
a099=a099+a366;
a752=a752-a099;
a730=a730-a490;
a730=a730+a348;
a730=a730+a166;
a730=a730-a726;
a730=a730/a100;
a186=a186-a464;
a186=a186+a655;
a186=a186+a026;
a186=a186-a699;
a186=a186/a100;
a699=a186/a100;
a699=a699*a187;
a730=a730-a699;
a730=a730/a100;
a186=a186/a100;
a100=a186/a100;
a100=a100*a187;
a730=a730-a100;
a290=a290*a730;
a186=a186*a279;
a290=a290+a186;
a752=a752-a290;
a271=a271*a382;
a146=a146*a437;
a271=a271+a146;
a752=a752+a271;
if (res[2]!=0) res[2][27]=a752;
a243=a243*a803;
a253=a253*a441;
a243=a243-a253;
if (res[2]!=0) res[2][28]=a243;
a093=a093*a444;
a246=a246*a790;
a093=a093+a246;
if (res[2]!=0) res[2][29]=a093;
a242=a242*a460;
a059=a059*a209;
a242=a242+a059;
a289=a289*a348;
a655=a655*a288;
a289=a289+a655;
a282=a282*a277;
a485=a485*a281;
a282=a282+a485;
a289=a289+a282;
a242=a242-a289;
if (res[2]!=0) res[2][30]=a242;
a008=a008*a166;
a026=a026*a257;
a008=a008+a026;
if (res[2]!=0) res[2][31]=a008;
a008=a352+a359;
if (res[2]!=0) res[2][32]=a008;
a352=a313*a352;
a555=a555*a629;
a352=a352-a555;
a359=a313*a359;
a553=a553*a629;
a359=a359-a553;
a352=a352+a359;
if (res[2]!=0) res[2][33]=a352;
a352=a714+a310;
if (res[2]!=0) res[2][34]=a352;
a714=a313*a714;
a534=a534*a629;
a714=a714-a534;
a313=a313*a310;
a616=a616*a629;
a313=a313-a616;
a714=a714+a313;
if (res[2]!=0) res[2][35]=a714;
a073=a073*a758;
a557=a557*a729;
a073=a073+a557;
if (res[2]!=0) res[2][36]=a073;
a679=a587*a679;
a564=a564*a647;
a679=a679+a564;
a680=a680/a546;
a567=a567/a546;
a564=a567/a546;
a564=a564*a676;
a680=a680-a564;
a680=a693*a680;
a567=a567*a575;
a680=a680+a567;
a679=a679-a680;
a576=a576*a678;
a612=a562*a612;
a576=a576+a612;
a679=a679+a576;
a786=a720*a786;
a603=a603*a674;
a786=a786+a603;
a679=a679+a786;
a787=a787/a546;
a592=a592/a546;
a786=a592/a546;
a786=a786*a676;
a787=a787-a786;
a787=a793*a787;
a592=a592*a711;
a787=a787+a592;
a679=a679-a787;
a712=a712*a785;
a745=a611*a745;
a712=a712+a745;
a679=a679+a712;
a551=a551/a550;
a535=a535/a496;
a578=a535*a578;
a561=a561/a552;
a543=a561*a543;
a578=a578-a543;
a773=a773/a661;
a577=a773*a577;
a578=a578+a577;
a608=a608/a607;
a591=a608*a591;
a578=a578-a591;
a591=a551*a578;
a607=a591*a683;
a535=a535*a491;
a561=a561*a572;
a535=a535-a561;
a773=a773*a622;
a535=a535+a773;
a608=a608*a708;
a535=a535-a608;
a535=a551*a535;
a681=a681/a550;
a551=a551/a550;
a551=a551*a682;
a681=a681+a551;
a578=a578*a681;
a535=a535-a578;
a578=a549*a535;
a607=a607+a578;
a679=a679-a607;
if (res[2]!=0) res[2][37]=a679;
a587=a587*a686;
a566=a566*a647;
a587=a587+a566;
a693=a693*a678;
a562=a562*a575;
a693=a693+a562;
a587=a587-a693;
a720=a720*a789;
a599=a599*a674;
a720=a720+a599;
a587=a587+a720;
a793=a793*a785;
a611=a611*a711;
a793=a793+a611;
a587=a587-a793;
a793=a011<=a548;
a548=a548<=a011;
a548=a548+a793;
a793=a793/a548;
a676=a591*a676;
a535=a546*a535;
a676=a676+a535;
a549=2.*a549;
a676=a676/a549;
a546=a546*a591;
a546=a546/a549;
a546=a546/a549;
a683=2.*a683;
a546=a546*a683;
a676=a676-a546;
a793=a793*a676;
a587=a587-a793;
if (res[2]!=0) res[2][38]=a587;
a586=a586*a692;
a569=a569*a660;
a586=a586+a569;
a719=a719*a792;
a589=a589*a522;
a719=a719+a589;
a586=a586+a719;
if (res[2]!=0) res[2][39]=a586;
a643=a643*a673;
a571=a571*a666;
a643=a643+a571;
a763=a763*a782;
a707=a707*a262;
a763=a763+a707;
a643=a643+a763;
if (res[2]!=0) res[2][40]=a643;
a134=a134-a700;
if (res[2]!=0) res[2][41]=a134;
a684=a684*a625;
a334=a334*a596;
a684=a684+a334;
if (res[2]!=0) res[2][42]=a684;
a339=a339-a306;
if (res[2]!=0) res[2][43]=a339;
a196=a196*a014;
a136=a069*a136;
a196=a196+a136;
if (res[2]!=0) res[2][44]=a196;
a347=a347*a341;
a530=a530*a518;
a347=a347+a530;
a438=a438*a463;
a143=a143*a664;
a438=a438+a143;
a347=a347+a438;
a347=-a347;
if (res[2]!=0) res[2][45]=a347;
if (res[2]!=0) res[2][46]=a777;
a319=a319*a381;
a777=a259*a777;
a319=a319+a777;
if (res[2]!=0) res[2][47]=a319;
if (res[2]!=0) res[2][48]=a799;
a269=a269*a381;
a259=a259*a799;
a269=a269+a259;
if (res[2]!=0) res[2][49]=a269;
a703=a703*a377;
a260=a260*a349;
a703=a703+a260;
if (res[2]!=0) res[2][50]=a703;
a504=a371*a504;
a333=a333*a495;
a504=a504+a333;
a500=a500/a312;
a331=a331/a312;
a333=a331/a312;
a333=a333*a497;
a500=a500-a333;
a500=a300*a500;
a331=a331*a302;
a500=a500+a331;
a504=a504-a500;
a268=a268*a502;
a124=a328*a124;
a268=a268+a124;
a504=a504+a268;
a317=a317/a316;
a370=a370/a489;
a301=a370*a301;
a327=a327/a318;
a373=a327*a373;
a301=a301-a373;
a373=a317*a301;
a318=a373*a507;
a370=a370*a264;
a327=a327*a338;
a370=a370-a327;
a370=a317*a370;
a505=a505/a316;
a317=a317/a316;
a317=a317*a506;
a505=a505+a317;
a301=a301*a505;
a370=a370-a301;
a301=a315*a370;
a318=a318+a301;
a504=a504-a318;
if (res[2]!=0) res[2][51]=a504;
a371=a371*a503;
a330=a330*a495;
a371=a371+a330;
a300=a300*a502;
a328=a328*a302;
a300=a300+a328;
a371=a371-a300;
a300=a011<=a314;
a314=a314<=a011;
a314=a314+a300;
a300=a300/a314;
a497=a373*a497;
a370=a312*a370;
a497=a497+a370;
a315=2.*a315;
a497=a497/a315;
a312=a312*a373;
a312=a312/a315;
a312=a312/a315;
a507=2.*a507;
a312=a312*a507;
a497=a497-a312;
a300=a300*a497;
a371=a371-a300;
if (res[2]!=0) res[2][52]=a371;
a322=a322*a508;
a335=a335*a122;
a322=a322+a335;
if (res[2]!=0) res[2][53]=a322;
a291=a291*a494;
a337=a337*a364;
a291=a291+a337;
if (res[2]!=0) res[2][54]=a291;
a267=a267/a261;
a276=a276/a261;
a276=a276/a261;
a276=a276*a376;
a267=a267-a276;
if (res[2]!=0) res[2][55]=a267;
a135=a135*a014;
a069=a069*a806;
a135=a135+a069;
a135=-a135;
if (res[2]!=0) res[2][56]=a135;
a135=a558*a227;
a069=a718*a814;
a135=a135+a069;
if (res[2]!=0) res[2][57]=a135;
a135=a235*a102;
a069=a135*a808;
a102=a102*a030;
a815=a235*a815;
a102=a102+a815;
a815=a781*a102;
a069=a069+a815;
if (res[2]!=0) res[2][58]=a069;
a558=a558*a152;
a814=a068*a814;
a558=a558+a814;
if (res[2]!=0) res[2][59]=a558;
a776=a776*a427;
a756=a230*a756;
a776=a776+a756;
a716=a716*a427;
a230=a230*a672;
a716=a716+a230;
a776=a776+a716;
a716=a235*a784;
a808=2.*a808;
a716=a716*a808;
a781=2.*a781;
a784=a784*a030;
a667=a235*a667;
a784=a784+a667;
a781=a781*a784;
a716=a716+a781;
a776=a776+a716;
a135=a135*a665;
a593=a593*a102;
a135=a135+a593;
a776=a776+a135;
if (res[2]!=0) res[2][60]=a776;
a776=a626*a536;
a135=a296*a812;
a776=a776+a135;
if (res[2]!=0) res[2][61]=a776;
a626=a626*a227;
a812=a718*a812;
a626=a626+a812;
if (res[2]!=0) res[2][62]=a626;
a232=a235*a232;
a030=a710*a030;
a232=a232+a030;
a696=a696*a232;
a710=a710*a235;
a813=a710*a813;
a696=a696+a813;
if (res[2]!=0) res[2][63]=a696;
a536=a570*a536;
a296=a296*a809;
a536=a536+a296;
if (res[2]!=0) res[2][64]=a536;
a227=a570*a227;
a718=a718*a809;
a227=a227+a718;
if (res[2]!=0) res[2][65]=a227;
a602=a602*a232;
a710=a710*a810;
a602=a602+a710;
if (res[2]!=0) res[2][66]=a602;
a570=a570*a152;
a809=a068*a809;
a570=a570+a809;
if (res[2]!=0) res[2][67]=a570;
a738=a738*a090;
a573=a573*a768;
a738=a738+a573;
a097=a097*a112;
a185=a050*a185;
a097=a097+a185;
a738=a738-a097;
a049=a049*a183;
a568=a568*a161;
a049=a049-a568;
a738=a738-a049;
if (res[2]!=0) res[2][68]=a738;
a173=a173*a157;
a046=a046*a051;
a173=a173+a046;
a094=a094*a112;
a050=a050*a092;
a094=a094+a050;
a173=a173-a094;
if (res[2]!=0) res[2][69]=a173;
a111=a076*a111;
a076=a076*a121;
a111=a111+a076;
a106=a106/a107;
a106=a106*a108;
a109=a109/a110;
a109=a109*a150;
a106=a106-a109;
a111=a111+a106;
if (res[2]!=0) res[2][70]=a111;
a117=a117*a065;
a067=a067*a105;
a117=a117+a067;
if (res[2]!=0) res[2][71]=a117;
a123=a123*a152;
a068=a068*a040;
a123=a123+a068;
a123=-a123;
if (res[2]!=0) res[2][72]=a123;
a115=a115*a149;
a083=a083*a178;
a115=a115+a083;
a036=a036*a115;
if (res[2]!=0) res[2][73]=a036;
a114=a114*a147;
a087=a087*a101;
a114=a114+a087;
if (res[2]!=0) res[2][74]=a114;
a021=-a021;
if (res[2]!=0) res[2][75]=a021;
a021=-5.0000000000000000e-01;
a021=a021*a640;
if (res[2]!=0) res[2][76]=a021;
a041=-a041;
if (res[2]!=0) res[2][77]=a041;
if (res[2]!=0) res[2][78]=a025;
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
a0=a0*a1;
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
a0=a0/a1;
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
a1=a1/a2;
a0=a0*a1;
a1=casadi_sq(a1);
a2=4.;
a1=a1+a2;
a1=sqrt(a1);
a2=2.;
a1=a1+a2;
a0=a0/a1;
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
a1=a1/a2;
a0=a0/a1;
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
a0=a0*a1;
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
a0=a0*a1;
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
a0=a0*a1;
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
a0=a0*a1;
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
a0=a0*a1;
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
a0=-a0;
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
a0=a0+a1;
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
a0=a0+a1;
a1=arg[4]? arg[4][0] : 0;
a2=arg[2]? arg[2][0] : 0;
a1=a1-a2;
a2=arg[0]? arg[0][0] : 0;
a2=tan(a2);
a1=a1*a2;
a0=a0-a1;
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
a1=a1*a3;
a3=arg[4]? arg[4][0] : 0;
a4=arg[2]? arg[2][0] : 0;
a3=a3-a4;
a5=sin(a2);
a3=a3*a5;
a1=a1+a3;
a3=arg[7]? arg[7][0] : 0;
a5=a1*a3;
a6=arg[8]? arg[8][0] : 0;
a5=a5*a6;
a7=arg[1]? arg[1][0] : 0;
a8=cos(a2);
a7=a7*a8;
a8=arg[5]? arg[5][0] : 0;
a9=arg[3]? arg[3][0] : 0;
a8=a8-a9;
a2=sin(a2);
a8=a8*a2;
a7=a7+a8;
a1=a1-a7;
a5=a5/a1;
a0=a0*a5;
a5=5.0000000000000000e-01;
a5=a5*a3;
a5=a5*a6;
a0=a0+a5;
a0=a0/a4;
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
a0=a0*a2;
a2=arg[4]? arg[4][0] : 0;
a3=arg[2]? arg[2][0] : 0;
a2=a2-a3;
a3=sin(a1);
a2=a2*a3;
a0=a0+a2;
a2=arg[7]? arg[7][0] : 0;
a2=a0*a2;
a3=arg[8]? arg[8][0] : 0;
a2=a2*a3;
a3=arg[1]? arg[1][0] : 0;
a4=cos(a1);
a3=a3*a4;
a4=arg[5]? arg[5][0] : 0;
a5=arg[3]? arg[3][0] : 0;
a4=a4-a5;
a1=sin(a1);
a4=a4*a1;
a3=a3+a4;
a0=a0-a3;
a2=a2/a0;
a2=a2/a5;
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
a1=a1*a3;
a3=arg[5]? arg[5][0] : 0;
a4=arg[2]? arg[2][0] : 0;
a3=a3-a4;
a5=sin(a2);
a3=a3*a5;
a1=a1+a3;
a3=arg[8]? arg[8][0] : 0;
a5=a1*a3;
a6=arg[9]? arg[9][0] : 0;
a5=a5*a6;
a7=arg[1]? arg[1][0] : 0;
a8=cos(a2);
a7=a7*a8;
a8=arg[6]? arg[6][0] : 0;
a9=arg[3]? arg[3][0] : 0;
a8=a8-a9;
a2=sin(a2);
a8=a8*a2;
a7=a7+a8;
a1=a1-a7;
a5=a5/a1;
a0=a0*a5;
a5=5.0000000000000000e-01;
a5=a5*a3;
a5=a5*a6;
a0=a0+a5;
a0=2.*a0;
a5=arg[4]? arg[4][0] : 0;
a0=a0*a5;
a3=sqrt(a3);
a4=sqrt(a4);
a3=a3*a4;
a0=a0/a3;
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
a0=a0*a2;
a2=arg[5]? arg[5][0] : 0;
a3=arg[2]? arg[2][0] : 0;
a2=a2-a3;
a3=sin(a1);
a2=a2*a3;
a0=a0+a2;
a2=arg[8]? arg[8][0] : 0;
a3=a0*a2;
a4=arg[9]? arg[9][0] : 0;
a3=a3*a4;
a4=arg[1]? arg[1][0] : 0;
a5=cos(a1);
a4=a4*a5;
a5=arg[6]? arg[6][0] : 0;
a6=arg[3]? arg[3][0] : 0;
a5=a5-a6;
a1=sin(a1);
a5=a5*a1;
a4=a4+a5;
a0=a0-a4;
a3=a3/a0;
a3=2.*a3;
a0=arg[4]? arg[4][0] : 0;
a3=a3*a0;
a2=sqrt(a2);
a6=sqrt(a6);
a2=a2*a6;
a3=a3/a2;
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
a0=a0*a1;
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
a0=a0<a1;
a1=-3.4906585039886601e-01;
a1=a0?a1:0;
a0=!a0;
a2=1.7453292519943300e-01;
a0=a0?a2:0;
a1=a1+a0;
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
a0=a0*a1;
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
a0=a0*a1;
a1=arg[1]? arg[1][0] : 0;
a0=a0*a1;
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
a0=a0*a1;
a1=arg[0]? arg[0][0] : 0;
a0=a0*a1;
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
a2=a1*a2;
a3=arg[2]? arg[2][0] : 0;
a1=a1*a3;
a2=a2+a1;
a2=casadi_sq(a2);
a0=a0*a2;
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
a0=a0*a1;
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
a0=-a0;
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
a0=a0*a1;
a1=arg[1]? arg[1][0] : 0;
a0=a0*a1;
a1=arg[2]? arg[2][0] : 0;
a0=a0/a1;
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
a0=a0*a1;
a1=arg[0]? arg[0][0] : 0;
a1=casadi_sq(a1);
a2=arg[1]? arg[1][0] : 0;
a1=a1/a2;
a0=a0/a1;
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
a0=a0*a1;
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
a0=2.*a0;
a1=arg[1]? arg[1][0] : 0;
a1=2.*a1;
a0=a0-a1;
a1=4.6000000000000002e-01;
a0=a0-a1;
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
a0=a0*a1;
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
a0=a0*a1;
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
