/* Generated from derive/ (digest bfd9ab80ef38709d) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`. */
/* Functions of states, inputs and parameters at many points, some of them side by side. */
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

enum { LANES = 16 };
#define INLINE static inline __attribute__((always_inline))
#define APART static __attribute__((noinline))
#define SHOWN __attribute__((visibility("default")))
#define LANE_LOOP _Pragma("omp simd") for (int l = 0; l < LANES; ++l)
#define W(k) w[k][l]
#define V(k) const double v##k =
typedef double lanes[LANES];

/* ---- elementary functions, branch-free so that loops over lanes become vector code ---------
 * Errors of few units of the last place, as tests/test_elementary.py says.  NaN in, NaN out. */

INLINE int64_t bits(double x) { int64_t b; memcpy(&b, &x, sizeof b); return b; }
INLINE double from_bits(int64_t b) { double x; memcpy(&x, &b, sizeof x); return x; }

/* x where the mask is -1, 0 where it is 0.  Masks, because gcc takes ?: apart into paths and puts
 * them together again with one division for each path. */
INLINE double only(int64_t mask, double x) { return from_bits(mask & bits(x)); }

/* t of lane_atan and the angle to add. */
INLINE double fold(double z, double *offset)
{
    const int64_t mid = -(int64_t)(z > 0.41421356237309503), big = -(int64_t)(z > 2.414213562373095);
    *offset = only(mid, 0.7853981633974483) + only(big, 0.7853981633974483);
    return (only(~big, z) - only(mid, 1.0)) / (only(~big, 1.0) + only(mid, z));
}

/* atan: |x| to t in [-tan(pi/8), tan(pi/8)] by t = z, (z - 1) / (z + 1) or -1 / z, then
 * t + t s P(s) with s = t t. */
INLINE double lane_atan(double x)
{
    double offset;
    const double t = fold(fabs(x), &offset), s = t * t, s2 = s * s;
    const double p = (-0.3333333333333015 + s2 * (-0.14285714195261148 + s2 * (-0.09090782412337584 + s2 * (-0.06641121186601258 + s2 * -0.04359095370168373)))) + s * (0.19999999999088952 + s2 * (0.11111106653580938 + s2 * (0.07690068299297602 + s2 * (0.05692538997871437 + s2 * 0.021259847052258217))));
    return copysign(offset + (t + t * s * p), x);
}

/* (-1)^k sin(x - n pi), n = k + shift, k = round(x / pi - shift): sine with shift 0, cosine 1/2.
 * Three-part Cody-Waite reduction, good to |x| = 1.6e6; beyond that NaN, not wrong
 * digits. */
INLINE double lane_wave(double x, double shift)
{
    const double magic = 6755399441055744.0;    /* 1.5 * 2^52: adding it rounds to a whole number */
    const double rounded = x * 0.3183098861837907 - shift + magic, n = rounded - magic + shift;
    const double r0 = ((x - n * 3.1415926534682512) - n * 1.2154201012607932e-10) - n * 4.044532497591901e-21;
    const double r = from_bits(bits(r0) | -(int64_t)!(fabs(x) < 1.6e6));
    const double s = r * r, s2 = s * s;
    const double p = (-0.16666666666666666 + s2 * (-0.0001984126984120885 + s2 * (-2.5052106866687343e-08 + s2 * -7.642983119287835e-13))) + s * (0.008333333333333193 + s2 * (2.755731921107215e-06 + s2 * (1.6058939391233316e-10 + s2 * 2.721085003160315e-15)));
    return from_bits(bits(r + r * s * p) ^ (int64_t)((uint64_t)bits(rounded) << 63));
}

INLINE double lane_sin(double x) { return lane_wave(x, 0.0); }
INLINE double lane_cos(double x) { return -lane_wave(x, 0.5); }
INLINE double lane_tan(double x) { return lane_sin(x) / lane_cos(x); }

/* 2^n for whole numbers from -1022 to 1023, as they stand in the last bits of n + magic. */
INLINE double two_to(int64_t n) { return from_bits((int64_t)((uint64_t)(n + 1023) << 52)); }

/* r and n of x = n log 2 + r, |r| <= log(2) / 2; the whole number is handed on as an integer. */
INLINE double halve(double x, int64_t *n)
{
    const double magic = 6755399441055744.0, rounded = x * 1.4426950408889634 + magic;
    const double whole = rounded - magic;
    *n = bits(rounded) - bits(magic);
    return (x - whole * 0.6931471804855391) - whole * 7.440617110012397e-11;
}

/* exp(s) - 1 for |s| <= log(2) / 2 */
INLINE double small_expm1(double s)
{
    const double s2 = s * s, p = (0.5000000000000011 + s2 * (0.04166666666652901 + s2 * (0.0013888888943991541 + s2 * (2.4801492673882887e-05 + s2 * 2.763041554362714e-07)))) + s * (0.16666666666666402 + s2 * (0.00833333333350108 + s2 * (0.0001984126949183641 + s2 * (2.7557599835008617e-06 + s2 * 2.4995723761300685e-08))));
    return s + s2 * p;
}

/* exp: beyond what a number can hold infinity or 0, in two factors that both can be held. */
INLINE double lane_exp(double x)
{
    const double most = x > 710.0 ? 710.0 : x, y = most < -746.0 ? -746.0 : most;
    int64_t n;
    const double e = small_expm1(halve(y, &n)), one = two_to(n >> 1), two = two_to(n - (n >> 1));
    return (one + one * e) * two;
}

/* exp(x) - 1, exact where x is small; up to 700. */
INLINE double bounded_expm1(double x)
{
    const double y = x < -40.0 ? -40.0 : x;
    int64_t n;
    const double e = small_expm1(halve(y, &n)), power = two_to(n);
    return power * e + (power - 1.0);
}

INLINE double lane_expm1(double x)
{
    const double large = lane_exp(x), small = bounded_expm1(x > 40.0 ? 40.0 : x);
    return x > 40.0 ? large : small;
}

/* log(2^n (1 + f)) + more, 1 + f between the roots of 1/2 and 2. */
INLINE double sum_log(double n, double f, double more)
{
    const double t = f / (2.0 + f), s = t * t, s2 = s * s, half = 0.5 * f * f;
    const double p = (0.6666666666666735 + s2 * (0.28571428743261834 + s2 * (0.18183569731612698 + s2 * 0.14797505200529643))) + s * (0.39999999999411096 + s2 * (0.22222198476116337 + s2 * 0.15313903480505622));
    return n * 0.6931471804855391 - ((half - (t * (half + s * p) + (n * 7.440617110012397e-11 + more))) - f);
}

/* n and f of x = 2^n (1 + f), x > 0 and normal. */
INLINE double take_apart(double x, double *n)
{
    const int64_t root = 0x3fe6a09e667f3bcd, apart = bits(x) - root, power = apart >> 52;
    *n = from_bits(power + 0x4338000000000000) - 6755399441055744.0;
    return from_bits((apart & 0xfffffffffffff) + root) - 1.0;
}

INLINE double lane_log(double x)
{
    const int tiny = x < DBL_MIN;
    double n;
    const double f = take_apart(tiny ? x * 0x1p54 : x, &n);
    const double finite = sum_log(tiny ? n - 54.0 : n, f, 0.0);
    const double sound = x < INFINITY ? finite : x, lost = x < 0.0 ? NAN : sound;
    return x == 0.0 ? -INFINITY : lost;
}

/* log(1 + x): what is lost in 1 + x is added again. */
INLINE double lane_log1p(double x)
{
    const double u = 1.0 + x, rest = u > 0x1p53 ? 0.0 : (x - (u - 1.0)) / u;
    double n;
    const double finite = sum_log(n, take_apart(u, &n), rest);
    const double sound = x < INFINITY ? finite : x, lost = x < -1.0 ? NAN : sound;
    return x == -1.0 ? -INFINITY : lost;
}

/* x^y; a negative x has whole powers only.  Its error is |y log x| units of the last place. */
INLINE double lane_pow(double x, double y)
{
    const double size = lane_exp(y * lane_log(fabs(x))), half = 0.5 * y;
    const double odd = half == floor(half) ? 1.0 : -1.0, whole = y == floor(y) ? odd : NAN;
    const double signed_size = x < 0.0 ? whole * size : size;
    return y == 0.0 || x == 1.0 ? 1.0 : signed_size;
}

INLINE double lane_tanh(double x)
{
    const double size = fabs(x), e = bounded_expm1(2.0 * (size > 20.0 ? 20.0 : size));
    return copysign(e / (e + 2.0), x);
}

INLINE double lane_sinh(double x)
{
    const double size = fabs(x), e = bounded_expm1(size > 40.0 ? 40.0 : size);
    const double half = lane_exp(0.5 * size);
    return copysign(size > 40.0 ? 0.5 * half * half : 0.5 * (e + e / (e + 1.0)), x);
}

INLINE double lane_cosh(double x)
{
    const double size = fabs(x), half = lane_exp(0.5 * size), e = lane_exp(size > 40.0 ? 40.0 : size);
    return size > 40.0 ? 0.5 * half * half : 0.5 * (e + 1.0 / e);
}

INLINE double lane_asinh(double x)
{
    const double size = fabs(x), most = size > 1e9 ? 1e9 : size, square = most * most;
    const double near = lane_log1p(most + square / (1.0 + sqrt(1.0 + square)));
    const double far = lane_log(size) + 0.6931471805599453;
    return copysign(size > 1e9 ? far : near, x);
}

INLINE double lane_acosh(double x)
{
    const double t = x - 1.0, most = t > 1e9 ? 1e9 : t;
    const double near = lane_log1p(most + sqrt(most * (most + 2.0)));
    const double far = lane_log(x) + 0.6931471805599453;
    return t > 1e9 ? far : near;
}

INLINE double lane_atanh(double x)
{
    const double size = fabs(x);
    return copysign(0.5 * lane_log1p(2.0 * size / (1.0 - size)), x);
}

INLINE double lane_asin(double x) { return lane_atan(x / sqrt((1.0 - x) * (1.0 + x))); }
INLINE double lane_acos(double x) { return 2.0 * lane_atan(sqrt((1.0 - x) / (1.0 + x))); }

/* Angle of (x, y), with the signs of zero as in C. */
INLINE double lane_atan2(double y, double x)
{
    const double a = fabs(x), b = fabs(y), more = a > b ? a : b, less = a > b ? b : a;
    const double ratio = less == more ? (more == 0.0 ? 0.0 : 1.0) : less / more;
    const double angle = lane_atan(ratio), first = b > a ? 1.5707963267948966 - angle : angle;
    const double turned = bits(x) < 0 ? 3.141592653589793 - first : first;
    return copysign(a + b == a + b ? turned : a + b, y);
}

INLINE double lane_hypot(double x, double y) { return sqrt(x * x + y * y); }

/* Minimum and maximum that let NaN through, unlike fmin and fmax. */
INLINE double lane_min(double a, double b) { return a < b ? a : (b <= a ? b : a + b); }
INLINE double lane_max(double a, double b) { return a > b ? a : (b >= a ? b : a + b); }

INLINE double lane_sign(double a) { return a > 0.0 ? 1.0 : (a < 0.0 ? -1.0 : a); }


/* What is wanted of each point: `size` elements of the results, numbered through all of them. */
typedef struct {
    double *data;                          /* [n][size] */
    int64_t size;
    const int32_t *element;                /* [size] */
} wanted_t;

typedef struct {
    int64_t n, threads, n_wanted;
    const double *const *given;            /* [N_IN] columns [n], or one number with stride 0 */
    const int64_t *stride;
    const wanted_t *wanted;
} points_t;

enum { N_IN = 12, N_ROWS = 35, N_RESULTS = 4 };
/* Of each result its first element and its part; of each element its row. */
static const int32_t FIRST[] = {0,1,2,3,4};
static const int PART[] = {64,128,256,512};
static const int16_t PLACE[] = {20,19,28,27};

APART void stretch0(lanes *restrict w)
{ LANE_LOOP {
V(0) W(5) * W(3);
V(1) fabs(v0);
V(2) 4.440892098500626e-16 * v1;
V(3) v2 + 1e-300;
V(4) -v3;
V(5) v0 + v4;
V(6) W(6) * v5;
V(7) v0 + v3;
V(8) W(6) * v7;
V(9) lane_min(v6, v8);
V(10) fabs(v9);
V(11) v9 + (-1e-300);
V(12) (-4.440892098500626e-16) * v10;
V(13) v11 + v12;
V(14) v13 <= 0.0 ? 1.0 : 0.0;
V(15) lane_max(v6, v8);
V(16) fabs(v15);
V(17) v15 + 1e-300;
V(18) 4.440892098500626e-16 * v16;
V(19) v17 + v18;
V(20) 0.0 <= v19 ? 1.0 : 0.0;
V(21) (v14 != 0.0) & (v20 != 0.0) ? 1.0 : 0.0;
V(22) 1.0 / v19;
V(23) fabs(v22);
V(24) v22 + (-1e-300);
V(25) (-4.440892098500626e-16) * v23;
V(26) v24 + v25;
W(13) = v21 != 0.0 ? (-INFINITY) : v26;
V(28) 1.0 / v13;
V(29) fabs(v28);
V(30) v28 + 1e-300;
V(31) 4.440892098500626e-16 * v29;
V(32) v30 + v31;
W(14) = v21 != 0.0 ? INFINITY : v32;
V(34) W(4) + W(5);
V(35) fabs(v34);
V(36) 4.440892098500626e-16 * v35;
V(37) v36 + 1e-300;
V(38) -v37;
W(15) = v34 + v38;
W(16) = v34 + v37;
V(41) 1.0 / W(6);
V(42) fabs(v41);
V(43) 4.440892098500626e-16 * v42;
V(44) v43 + 1e-300;
V(45) -v44;
W(17) = v41 + v45;
W(18) = v41 + v44;
V(48) 0.5 * W(8);
V(49) fabs(v48);
V(50) 4.440892098500626e-16 * v49;
V(51) v50 + 1e-300;
V(52) -v51;
V(53) v48 + v52;
V(54) W(9) * v53;
V(55) v48 + v51;
V(56) W(9) * v55;
V(57) lane_min(v54, v56);
V(58) fabs(v57);
V(59) v57 + (-1e-300);
V(60) (-4.440892098500626e-16) * v58;
V(61) v59 + v60;
V(62) W(7) * v61;
V(63) lane_max(v54, v56);
V(64) fabs(v63);
V(65) v63 + 1e-300;
V(66) 4.440892098500626e-16 * v64;
V(67) v65 + v66;
V(68) W(7) * v67;
V(69) lane_min(v62, v68);
V(70) fabs(v69);
V(71) v69 + (-1e-300);
V(72) (-4.440892098500626e-16) * v70;
V(73) v71 + v72;
V(74) W(6) * W(6);
V(75) 4.440892098500626e-16 * v74;
V(76) v75 + 1e-300;
V(77) -v76;
V(78) v74 + v77;
V(79) v73 * v78;
V(80) v74 + v76;
V(81) v73 * v80;
V(82) lane_min(v79, v81);
V(83) lane_max(v62, v68);
V(84) fabs(v83);
V(85) v83 + 1e-300;
V(86) 4.440892098500626e-16 * v84;
V(87) v85 + v86;
V(88) v87 * v78;
V(89) lane_min(v82, v88);
V(90) v87 * v80;
V(91) lane_min(v89, v90);
V(92) fabs(v91);
V(93) v91 + (-1e-300);
V(94) (-4.440892098500626e-16) * v92;
W(19) = v93 + v94;
V(96) lane_max(v79, v81);
V(97) lane_max(v96, v88);
V(98) lane_max(v97, v90);
V(99) fabs(v98);
V(100) v98 + 1e-300;
V(101) 4.440892098500626e-16 * v99;
W(20) = v100 + v101;
} }

APART void stretch1(lanes *restrict w)
{ LANE_LOOP {
V(0) W(10) * W(0);
V(1) W(10) * W(1);
V(2) lane_min(v0, v1);
V(3) fabs(v2);
V(4) v2 + (-1e-300);
V(5) (-4.440892098500626e-16) * v3;
V(6) v4 + v5;
V(7) v6 * W(13);
V(8) v6 * W(14);
V(9) 2.0 * v7;
V(10) 2.0 * v8;
V(11) lane_min(v9, v10);
V(12) lane_max(v0, v1);
V(13) fabs(v12);
V(14) v12 + 1e-300;
V(15) 4.440892098500626e-16 * v13;
V(16) v14 + v15;
V(17) v16 * W(13);
V(18) 2.0 * v17;
V(19) lane_min(v11, v18);
V(20) v16 * W(14);
V(21) 2.0 * v20;
V(22) lane_min(v19, v21);
V(23) fabs(v22);
V(24) v22 + (-1e-300);
V(25) (-4.440892098500626e-16) * v23;
V(26) v24 + v25;
V(27) v26 * W(15);
V(28) v26 * W(16);
V(29) lane_min(v27, v28);
V(30) lane_max(v9, v10);
V(31) lane_max(v30, v18);
V(32) lane_max(v31, v21);
V(33) fabs(v32);
V(34) v32 + 1e-300;
V(35) 4.440892098500626e-16 * v33;
V(36) v34 + v35;
V(37) v36 * W(15);
V(38) lane_min(v29, v37);
V(39) v36 * W(16);
V(40) lane_min(v38, v39);
V(41) fabs(v40);
V(42) v40 + (-1e-300);
V(43) (-4.440892098500626e-16) * v41;
V(44) v42 + v43;
V(45) W(5) * v44;
V(46) lane_max(v27, v28);
V(47) lane_max(v46, v37);
V(48) lane_max(v47, v39);
V(49) fabs(v48);
V(50) v48 + 1e-300;
V(51) 4.440892098500626e-16 * v49;
V(52) v50 + v51;
V(53) W(5) * v52;
V(54) lane_min(v45, v53);
V(55) fabs(v54);
V(56) W(4) * v44;
V(57) W(4) * v52;
V(58) lane_min(v56, v57);
V(59) fabs(v58);
V(60) W(6) * W(0);
V(61) W(6) * W(1);
V(62) lane_min(v60, v61);
V(63) fabs(v62);
V(64) v58 + (-2e-300);
V(65) (-4.440892098500626e-16) * v59;
V(66) v64 + v65;
V(67) v66 + v62;
V(68) (-4.440892098500626e-16) * v63;
V(69) v67 + v68;
V(70) fabs(v69);
V(71) v54 + (-2e-300);
V(72) (-4.440892098500626e-16) * v55;
V(73) v71 + v72;
V(74) v73 + v69;
V(75) (-4.440892098500626e-16) * v70;
V(76) v74 + v75;
V(77) fabs(v76);
V(78) v76 + (-1e-300);
V(79) (-4.440892098500626e-16) * v77;
V(80) v78 + v79;
V(81) v80 * W(17);
V(82) v80 * W(18);
V(83) lane_min(v81, v82);
V(84) lane_max(v45, v53);
V(85) fabs(v84);
V(86) lane_max(v56, v57);
V(87) fabs(v86);
V(88) lane_max(v60, v61);
V(89) fabs(v88);
V(90) v86 + 2e-300;
V(91) 4.440892098500626e-16 * v87;
V(92) v90 + v91;
V(93) v92 + v88;
V(94) 4.440892098500626e-16 * v89;
V(95) v93 + v94;
V(96) fabs(v95);
V(97) v84 + 2e-300;
V(98) 4.440892098500626e-16 * v85;
V(99) v97 + v98;
V(100) v99 + v95;
V(101) 4.440892098500626e-16 * v96;
V(102) v100 + v101;
V(103) fabs(v102);
V(104) v102 + 1e-300;
V(105) 4.440892098500626e-16 * v103;
V(106) v104 + v105;
V(107) v106 * W(17);
V(108) lane_min(v83, v107);
V(109) v106 * W(18);
V(110) lane_min(v108, v109);
V(111) fabs(v110);
V(112) v110 + (-1e-300);
V(113) (-4.440892098500626e-16) * v111;
V(114) v112 + v113;
V(115) v114 * W(19);
V(116) v114 * W(20);
V(117) lane_min(v115, v116);
V(118) lane_max(v81, v82);
V(119) lane_max(v118, v107);
V(120) lane_max(v119, v109);
V(121) fabs(v120);
V(122) v120 + 1e-300;
V(123) 4.440892098500626e-16 * v121;
V(124) v122 + v123;
V(125) v124 * W(19);
V(126) lane_min(v117, v125);
V(127) v124 * W(20);
V(128) lane_min(v126, v127);
V(129) fabs(v128);
V(130) v128 + (-1e-300);
V(131) (-4.440892098500626e-16) * v129;
V(132) v130 + v131;
W(21) = W(5) * v132;
V(134) lane_max(v115, v116);
V(135) lane_max(v134, v125);
V(136) lane_max(v135, v127);
V(137) fabs(v136);
V(138) v136 + 1e-300;
V(139) 4.440892098500626e-16 * v137;
V(140) v138 + v139;
W(22) = W(5) * v140;
W(23) = W(2) * W(5);
V(143) fabs(W(23));
V(144) 4.440892098500626e-16 * v143;
W(24) = v144 + 1e-300;
V(146) W(4) * v6;
V(147) W(4) * v16;
W(25) = 2.0 * v146;
W(26) = 2.0 * v147;
V(150) W(11) * v114;
V(151) W(11) * v124;
V(152) lane_min(v150, v151);
V(153) fabs(v152);
V(154) v152 + (-1e-300);
V(155) (-4.440892098500626e-16) * v153;
V(156) v154 + v155;
W(27) = W(5) * v156;
V(158) lane_max(v150, v151);
V(159) fabs(v158);
V(160) v158 + 1e-300;
V(161) 4.440892098500626e-16 * v159;
V(162) v160 + v161;
W(28) = W(5) * v162;
} }

APART void stretch2(lanes *restrict w)
{ LANE_LOOP {
V(0) W(10) * W(15);
V(1) W(10) * W(16);
V(2) 2.0 * v0;
V(3) 2.0 * v1;
V(4) lane_min(v2, v3);
V(5) lane_min(v4, v2);
V(6) lane_min(v5, v3);
V(7) fabs(v6);
V(8) v6 + (-1e-300);
V(9) (-4.440892098500626e-16) * v7;
V(10) v8 + v9;
V(11) v10 * W(13);
V(12) v10 * W(14);
V(13) lane_min(v11, v12);
V(14) lane_max(v2, v3);
V(15) lane_max(v14, v2);
V(16) lane_max(v15, v3);
V(17) fabs(v16);
V(18) v16 + 1e-300;
V(19) 4.440892098500626e-16 * v17;
V(20) v18 + v19;
V(21) v20 * W(13);
V(22) lane_min(v13, v21);
V(23) v20 * W(14);
V(24) lane_min(v22, v23);
V(25) fabs(v24);
V(26) v24 + (-1e-300);
V(27) (-4.440892098500626e-16) * v25;
V(28) v26 + v27;
V(29) W(5) * v28;
V(30) lane_max(v11, v12);
V(31) lane_max(v30, v21);
V(32) lane_max(v31, v23);
V(33) fabs(v32);
V(34) v32 + 1e-300;
V(35) 4.440892098500626e-16 * v33;
V(36) v34 + v35;
V(37) W(5) * v36;
V(38) lane_min(v29, v37);
V(39) fabs(v38);
V(40) v38 + (-1e-300);
V(41) (-4.440892098500626e-16) * v39;
V(42) v40 + v41;
V(43) v42 * W(17);
V(44) v42 * W(18);
V(45) lane_min(v43, v44);
V(46) lane_max(v29, v37);
V(47) fabs(v46);
V(48) v46 + 1e-300;
V(49) 4.440892098500626e-16 * v47;
V(50) v48 + v49;
V(51) v50 * W(17);
V(52) lane_min(v45, v51);
V(53) v50 * W(18);
V(54) lane_min(v52, v53);
V(55) fabs(v54);
V(56) W(4) * v28;
V(57) W(4) * v36;
V(58) lane_min(v56, v57);
V(59) fabs(v58);
V(60) W(6) + (-1e-300);
V(61) v60 + v58;
V(62) (-4.440892098500626e-16) * v59;
V(63) v61 + v62;
V(64) fabs(v63);
V(65) v63 + (-1e-300);
V(66) (-4.440892098500626e-16) * v64;
V(67) v65 + v66;
V(68) v67 * W(17);
V(69) v67 * W(18);
V(70) lane_min(v68, v69);
V(71) lane_max(v56, v57);
V(72) fabs(v71);
V(73) W(6) + 1e-300;
V(74) v73 + v71;
V(75) 4.440892098500626e-16 * v72;
V(76) v74 + v75;
V(77) fabs(v76);
V(78) v76 + 1e-300;
V(79) 4.440892098500626e-16 * v77;
V(80) v78 + v79;
V(81) v80 * W(17);
V(82) lane_min(v70, v81);
V(83) v80 * W(18);
V(84) lane_min(v82, v83);
V(85) fabs(v84);
V(86) v54 + (-2e-300);
V(87) (-4.440892098500626e-16) * v55;
V(88) v86 + v87;
V(89) v88 + v84;
V(90) (-4.440892098500626e-16) * v85;
V(91) v89 + v90;
V(92) fabs(v91);
V(93) v91 + (-1e-300);
V(94) (-4.440892098500626e-16) * v92;
V(95) v93 + v94;
V(96) v95 * W(19);
V(97) v95 * W(20);
V(98) lane_min(v96, v97);
V(99) lane_max(v43, v44);
V(100) lane_max(v99, v51);
V(101) lane_max(v100, v53);
V(102) fabs(v101);
V(103) lane_max(v68, v69);
V(104) lane_max(v103, v81);
V(105) lane_max(v104, v83);
V(106) fabs(v105);
V(107) v101 + 2e-300;
V(108) 4.440892098500626e-16 * v102;
V(109) v107 + v108;
V(110) v109 + v105;
V(111) 4.440892098500626e-16 * v106;
V(112) v110 + v111;
V(113) fabs(v112);
V(114) v112 + 1e-300;
V(115) 4.440892098500626e-16 * v113;
V(116) v114 + v115;
V(117) v116 * W(19);
V(118) lane_min(v98, v117);
V(119) v116 * W(20);
V(120) lane_min(v118, v119);
V(121) fabs(v120);
V(122) v120 + (-1e-300);
V(123) (-4.440892098500626e-16) * v121;
V(124) v122 + v123;
W(29) = W(5) * v124;
V(126) lane_max(v96, v97);
V(127) lane_max(v126, v117);
V(128) lane_max(v127, v119);
V(129) fabs(v128);
V(130) v128 + 1e-300;
V(131) 4.440892098500626e-16 * v129;
V(132) v130 + v131;
W(30) = W(5) * v132;
V(134) W(4) * W(10);
V(135) 2.0 * v134;
V(136) fabs(v135);
V(137) 4.440892098500626e-16 * v136;
W(31) = v137 + 1e-300;
W(32) = (-2.0) * v134;
V(140) W(11) * v95;
V(141) W(11) * v116;
V(142) lane_min(v140, v141);
V(143) fabs(v142);
V(144) v142 + (-1e-300);
V(145) (-4.440892098500626e-16) * v143;
V(146) v144 + v145;
W(33) = W(5) * v146;
V(148) lane_max(v140, v141);
V(149) fabs(v148);
V(150) v148 + 1e-300;
V(151) 4.440892098500626e-16 * v149;
V(152) v150 + v151;
W(34) = W(5) * v152;
} }

APART void stretch3(lanes *restrict w)
{ LANE_LOOP {
V(0) lane_min(W(21), W(22));
V(1) fabs(v0);
V(2) lane_max(W(25), W(26));
V(3) fabs(v2);
V(4) W(23) + 1e-300;
V(5) v4 + W(24);
V(6) v5 + v2;
V(7) 4.440892098500626e-16 * v3;
V(8) v6 + v7;
V(9) fabs(v8);
V(10) v0 + (-2e-300);
V(11) (-4.440892098500626e-16) * v1;
V(12) v10 + v11;
V(13) -v8;
V(14) v12 + v13;
V(15) (-4.440892098500626e-16) * v9;
V(16) v14 + v15;
V(17) fabs(v16);
V(18) lane_min(W(27), W(28));
V(19) fabs(v18);
V(20) v16 + (-2e-300);
V(21) (-4.440892098500626e-16) * v17;
V(22) v20 + v21;
V(23) v22 + v18;
V(24) (-4.440892098500626e-16) * v19;
V(25) v23 + v24;
V(26) fabs(v25);
V(27) v25 + (-1e-300);
V(28) (-4.440892098500626e-16) * v26;
W(20) = v27 + v28;
} }

APART void stretch4(lanes *restrict w)
{ LANE_LOOP {
V(0) lane_max(W(21), W(22));
V(1) fabs(v0);
V(2) lane_min(W(25), W(26));
V(3) fabs(v2);
V(4) W(23) + (-1e-300);
V(5) -W(24);
V(6) v4 + v5;
V(7) v6 + v2;
V(8) (-4.440892098500626e-16) * v3;
V(9) v7 + v8;
V(10) fabs(v9);
V(11) v0 + 2e-300;
V(12) 4.440892098500626e-16 * v1;
V(13) v11 + v12;
V(14) -v9;
V(15) v13 + v14;
V(16) 4.440892098500626e-16 * v10;
V(17) v15 + v16;
V(18) fabs(v17);
V(19) lane_max(W(27), W(28));
V(20) fabs(v19);
V(21) v17 + 2e-300;
V(22) 4.440892098500626e-16 * v18;
V(23) v21 + v22;
V(24) v23 + v19;
V(25) 4.440892098500626e-16 * v20;
V(26) v24 + v25;
V(27) fabs(v26);
V(28) v26 + 1e-300;
V(29) 4.440892098500626e-16 * v27;
W(19) = v28 + v29;
} }

APART void stretch5(lanes *restrict w)
{ LANE_LOOP {
V(0) lane_min(W(29), W(30));
V(1) fabs(v0);
V(2) v0 + (-1e-300);
V(3) (-4.440892098500626e-16) * v1;
V(4) v2 + v3;
V(5) v4 + W(32);
V(6) -W(31);
V(7) v5 + v6;
V(8) fabs(v7);
V(9) lane_min(W(33), W(34));
V(10) fabs(v9);
V(11) v7 + (-2e-300);
V(12) (-4.440892098500626e-16) * v8;
V(13) v11 + v12;
V(14) v13 + v9;
V(15) (-4.440892098500626e-16) * v10;
V(16) v14 + v15;
V(17) fabs(v16);
V(18) v16 + (-1e-300);
V(19) (-4.440892098500626e-16) * v17;
W(28) = v18 + v19;
} }

APART void stretch6(lanes *restrict w)
{ LANE_LOOP {
V(0) lane_max(W(29), W(30));
V(1) fabs(v0);
V(2) W(32) + 1e-300;
V(3) v2 + W(31);
V(4) v3 + v0;
V(5) 4.440892098500626e-16 * v1;
V(6) v4 + v5;
V(7) fabs(v6);
V(8) lane_max(W(33), W(34));
V(9) fabs(v8);
V(10) v6 + 2e-300;
V(11) 4.440892098500626e-16 * v7;
V(12) v10 + v11;
V(13) v12 + v8;
V(14) 4.440892098500626e-16 * v9;
V(15) v13 + v14;
V(16) fabs(v15);
V(17) v15 + 1e-300;
V(18) 4.440892098500626e-16 * v16;
W(27) = v17 + v18;
} }

static void constants(lanes *w)
{
    LANE_LOOP W(12) = 0.0;
}

static void evaluate(lanes *w, int asked)
{
    if (asked & 960) stretch0(w);
    if (asked & 192) stretch1(w);
    if (asked & 768) stretch2(w);
    if (asked & 64) stretch3(w);
    if (asked & 128) stretch4(w);
    if (asked & 256) stretch5(w);
    if (asked & 512) stretch6(w);
}


/* Which parts of the results are asked for, one bit each. */
static int parts(const points_t *job)
{
    int found = 0;
    for (int64_t j = 0; j < job->n_wanted; ++j)
        for (int64_t k = 0; k < job->wanted[j].size; ++k)
            for (int r = 0; r < N_RESULTS; ++r)
                if (job->wanted[j].element[k] >= FIRST[r] && job->wanted[j].element[k] < FIRST[r + 1])
                    found |= PART[r];
    return found;
}

/* Points `from` to `end`, no more than there are lanes: unused lanes repeat the last. */
static void some(const points_t *job, int asked, lanes *w, int64_t from, int64_t end)
{
    const int count = (int)(end - from);
    for (int k = 0; k < N_IN; ++k) {
        const int64_t stride = job->stride[k];
        const double *column = job->given[k] + stride * from;
        for (int l = 0; l < LANES && stride; ++l)
            w[k][l] = column[l < count ? l : count - 1];
    }
    evaluate(w, asked);
    for (int64_t j = 0; j < job->n_wanted; ++j) {
        const wanted_t *wanted = job->wanted + j;
        double *out = wanted->data + from * wanted->size;
        for (int64_t k = 0; k < wanted->size; ++k)
            for (int l = 0; l < count; ++l)
                out[l * wanted->size + k] = w[PLACE[wanted->element[k]]][l];
    }
}

SHOWN void points(const points_t *job)
{
    const int64_t blocks = (job->n + LANES - 1) / LANES;
    const int asked = parts(job);
#pragma omp parallel num_threads((int)job->threads) if (job->threads > 1)
    {
        lanes w[N_ROWS] __attribute__((aligned(64)));
        constants(w);
        for (int k = 0; k < N_IN; ++k)
            for (int l = 0; l < LANES; ++l)
                w[k][l] = *job->given[k];
#pragma omp for schedule(static)
        for (int64_t b = 0; b < blocks; ++b) {
            const int64_t from = b * LANES, end = from + LANES;
            some(job, asked, w, from, end < job->n ? end : job->n);
        }
    }
}
