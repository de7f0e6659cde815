/* Generated from derive/ (digest 0b025fe68865f259) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`. */
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

enum { N_IN = 20, N_ROWS = 65, N_RESULTS = 4 };
/* Of each result its first element and its part; of each element its row. */
static const int32_t FIRST[] = {0,1,2,3,4};
static const int PART[] = {64,128,256,512};
static const int16_t PLACE[] = {64,21,56,46};

APART void stretch0(lanes *restrict w)
{ LANE_LOOP {
V(0) W(13) * W(11);
V(1) fabs(v0);
V(2) 4.440892098500626e-16 * v1;
V(3) v2 + 1e-300;
V(4) W(12) + v0;
V(5) -v3;
V(6) v4 + v5;
V(7) fabs(v6);
V(8) v6 + (-1e-300);
V(9) (-4.440892098500626e-16) * v7;
W(21) = v8 + v9;
V(11) 0.15915494309189535 * W(0);
V(12) v11 + (-0.250000001);
V(13) ceil(v12);
V(14) 0.15915494309189535 * W(1);
V(15) v14 + (-0.249999999);
V(16) floor(v15);
V(17) v13 <= v16 ? 1.0 : 0.0;
V(18) v11 + 0.249999999;
V(19) ceil(v18);
V(20) v14 + 0.250000001;
V(21) floor(v20);
V(22) v19 <= v21 ? 1.0 : 0.0;
V(23) (v17 != 0.0) | (v22 != 0.0) ? 1.0 : 0.0;
V(24) lane_tan(W(0));
V(25) fabs(v24);
V(26) v24 + (-1e-300);
V(27) (-3.552713678800501e-15) * v25;
V(28) v26 + v27;
W(22) = v23 != 0.0 ? (-INFINITY) : v28;
V(30) W(21) * W(22);
V(31) lane_tan(W(1));
V(32) fabs(v31);
V(33) v31 + 1e-300;
V(34) 3.552713678800501e-15 * v32;
V(35) v33 + v34;
W(23) = v23 != 0.0 ? INFINITY : v35;
V(37) W(21) * W(23);
V(38) lane_min(v30, v37);
V(39) v4 + v3;
V(40) fabs(v39);
V(41) v39 + 1e-300;
V(42) 4.440892098500626e-16 * v40;
W(24) = v41 + v42;
V(44) W(24) * W(22);
V(45) lane_min(v38, v44);
V(46) W(24) * W(23);
V(47) lane_min(v45, v46);
V(48) fabs(v47);
V(49) v47 + (-1e-300);
V(50) (-4.440892098500626e-16) * v48;
V(51) v49 + v50;
V(52) W(15) * W(11);
V(53) fabs(v52);
V(54) 4.440892098500626e-16 * v53;
V(55) v54 + 1e-300;
V(56) W(14) + v52;
V(57) -v55;
V(58) v56 + v57;
V(59) fabs(v58);
V(60) v58 + (-1e-300);
V(61) (-4.440892098500626e-16) * v59;
W(25) = v60 + v61;
V(63) W(25) <= 0.0 ? 1.0 : 0.0;
V(64) v56 + v55;
V(65) fabs(v64);
V(66) v64 + 1e-300;
V(67) 4.440892098500626e-16 * v65;
W(26) = v66 + v67;
V(69) 0.0 <= W(26) ? 1.0 : 0.0;
V(70) (v63 != 0.0) & (v69 != 0.0) ? 1.0 : 0.0;
V(71) 1.0 / W(26);
V(72) fabs(v71);
V(73) v71 + (-1e-300);
V(74) (-4.440892098500626e-16) * v72;
V(75) v73 + v74;
W(27) = v70 != 0.0 ? (-INFINITY) : v75;
V(77) v51 * W(27);
V(78) 1.0 / W(25);
V(79) fabs(v78);
V(80) v78 + 1e-300;
V(81) 4.440892098500626e-16 * v79;
V(82) v80 + v81;
W(28) = v70 != 0.0 ? INFINITY : v82;
V(84) v51 * W(28);
V(85) lane_min(v77, v84);
V(86) lane_max(v30, v37);
V(87) lane_max(v86, v44);
V(88) lane_max(v87, v46);
V(89) fabs(v88);
V(90) v88 + 1e-300;
V(91) 4.440892098500626e-16 * v89;
V(92) v90 + v91;
V(93) v92 * W(27);
V(94) lane_min(v85, v93);
V(95) v92 * W(28);
V(96) lane_min(v94, v95);
V(97) fabs(v96);
V(98) v96 + (-1e-300);
V(99) (-4.440892098500626e-16) * v97;
W(29) = v98 + v99;
W(30) = -W(19);
V(102) W(30) + 1.0;
V(103) fabs(v102);
V(104) 4.440892098500626e-16 * v103;
V(105) v104 + 1e-300;
V(106) -v105;
V(107) v102 + v106;
V(108) W(29) * v107;
V(109) v102 + v105;
V(110) W(29) * v109;
V(111) lane_min(v108, v110);
V(112) lane_max(v77, v84);
V(113) lane_max(v112, v93);
V(114) lane_max(v113, v95);
V(115) fabs(v114);
V(116) v114 + 1e-300;
V(117) 4.440892098500626e-16 * v115;
W(31) = v116 + v117;
V(119) W(31) * v107;
V(120) lane_min(v111, v119);
V(121) W(31) * v109;
V(122) lane_min(v120, v121);
V(123) fabs(v122);
V(124) W(16) * W(29);
V(125) W(16) * W(31);
V(126) lane_min(v124, v125);
V(127) fabs(v126);
V(128) v126 + (-1e-300);
V(129) (-4.440892098500626e-16) * v127;
W(32) = v128 + v129;
V(131) lane_max(v124, v125);
V(132) fabs(v131);
V(133) v131 + 1e-300;
V(134) 4.440892098500626e-16 * v132;
W(33) = v133 + v134;
V(136) 1.0 / W(16);
V(137) fabs(v136);
V(138) 4.440892098500626e-16 * v137;
V(139) v138 + 1e-300;
V(140) -v139;
W(34) = v136 + v140;
W(35) = v136 + v139;
V(143) v122 + (-2e-300);
V(144) (-4.440892098500626e-16) * v123;
W(36) = v143 + v144;
V(146) lane_max(v108, v110);
V(147) lane_max(v146, v119);
V(148) lane_max(v147, v121);
V(149) fabs(v148);
V(150) v148 + 2e-300;
V(151) 4.440892098500626e-16 * v149;
W(37) = v150 + v151;
V(153) W(5) * W(3);
V(154) fabs(v153);
V(155) 4.440892098500626e-16 * v154;
V(156) v155 + 1e-300;
V(157) -v156;
V(158) v153 + v157;
V(159) W(6) * v158;
V(160) v153 + v156;
V(161) W(6) * v160;
V(162) lane_min(v159, v161);
V(163) fabs(v162);
V(164) v162 + (-1e-300);
V(165) (-4.440892098500626e-16) * v163;
V(166) v164 + v165;
V(167) v166 <= 0.0 ? 1.0 : 0.0;
V(168) lane_max(v159, v161);
V(169) fabs(v168);
V(170) v168 + 1e-300;
V(171) 4.440892098500626e-16 * v169;
V(172) v170 + v171;
V(173) 0.0 <= v172 ? 1.0 : 0.0;
V(174) (v167 != 0.0) & (v173 != 0.0) ? 1.0 : 0.0;
V(175) 1.0 / v172;
V(176) fabs(v175);
V(177) v175 + (-1e-300);
V(178) (-4.440892098500626e-16) * v176;
V(179) v177 + v178;
W(38) = v174 != 0.0 ? (-INFINITY) : v179;
V(181) 1.0 / v166;
V(182) fabs(v181);
V(183) v181 + 1e-300;
V(184) 4.440892098500626e-16 * v182;
V(185) v183 + v184;
W(39) = v174 != 0.0 ? INFINITY : v185;
V(187) W(4) + W(5);
V(188) fabs(v187);
V(189) 4.440892098500626e-16 * v188;
V(190) v189 + 1e-300;
V(191) -v190;
W(40) = v187 + v191;
W(41) = v187 + v190;
W(42) = W(6) * W(22);
W(43) = W(6) * W(23);
V(196) lane_min(W(42), W(43));
V(197) fabs(v196);
W(44) = v196 + (-2e-300);
W(45) = (-4.440892098500626e-16) * v197;
} }

APART void stretch1(lanes *restrict w)
{ LANE_LOOP {
W(46) = W(44) + W(45);
V(1) 1.0 / W(6);
V(2) fabs(v1);
V(3) 4.440892098500626e-16 * v2;
V(4) v3 + 1e-300;
V(5) -v4;
W(47) = v1 + v5;
W(48) = v1 + v4;
V(8) lane_max(W(42), W(43));
V(9) fabs(v8);
V(10) v8 + 2e-300;
V(11) 4.440892098500626e-16 * v9;
W(49) = v10 + v11;
V(13) 0.5 * W(8);
V(14) fabs(v13);
V(15) 4.440892098500626e-16 * v14;
V(16) v15 + 1e-300;
V(17) -v16;
V(18) v13 + v17;
V(19) W(9) * v18;
V(20) v13 + v16;
V(21) W(9) * v20;
V(22) lane_min(v19, v21);
V(23) fabs(v22);
V(24) v22 + (-1e-300);
V(25) (-4.440892098500626e-16) * v23;
V(26) v24 + v25;
V(27) W(7) * v26;
V(28) lane_max(v19, v21);
V(29) fabs(v28);
V(30) v28 + 1e-300;
V(31) 4.440892098500626e-16 * v29;
V(32) v30 + v31;
V(33) W(7) * v32;
V(34) lane_min(v27, v33);
V(35) fabs(v34);
V(36) v34 + (-1e-300);
V(37) (-4.440892098500626e-16) * v35;
V(38) v36 + v37;
V(39) W(6) * W(6);
V(40) 4.440892098500626e-16 * v39;
V(41) v40 + 1e-300;
V(42) -v41;
W(50) = v39 + v42;
V(44) v38 * W(50);
W(51) = v39 + v41;
V(46) v38 * W(51);
V(47) lane_min(v44, v46);
V(48) lane_max(v27, v33);
V(49) fabs(v48);
V(50) v48 + 1e-300;
V(51) 4.440892098500626e-16 * v49;
V(52) v50 + v51;
V(53) v52 * W(50);
V(54) lane_min(v47, v53);
V(55) v52 * W(51);
V(56) lane_min(v54, v55);
V(57) fabs(v56);
V(58) v56 + (-1e-300);
V(59) (-4.440892098500626e-16) * v57;
W(52) = v58 + v59;
V(61) lane_max(v44, v46);
V(62) lane_max(v61, v53);
V(63) lane_max(v62, v55);
V(64) fabs(v63);
V(65) v63 + 1e-300;
V(66) 4.440892098500626e-16 * v64;
W(53) = v65 + v66;
} }

APART void stretch2(lanes *restrict w)
{ LANE_LOOP {
V(0) lane_atan(W(32));
V(1) fabs(v0);
V(2) v0 + (-1e-300);
V(3) (-3.552713678800501e-15) * v1;
V(4) v2 + v3;
V(5) W(19) * v4;
V(6) lane_atan(W(33));
V(7) fabs(v6);
V(8) v6 + 1e-300;
V(9) 3.552713678800501e-15 * v7;
V(10) v8 + v9;
V(11) W(19) * v10;
V(12) lane_min(v5, v11);
V(13) fabs(v12);
V(14) v12 + (-1e-300);
V(15) (-4.440892098500626e-16) * v13;
V(16) v14 + v15;
V(17) v16 * W(34);
V(18) v16 * W(35);
V(19) lane_min(v17, v18);
V(20) lane_max(v5, v11);
V(21) fabs(v20);
V(22) v20 + 1e-300;
V(23) 4.440892098500626e-16 * v21;
V(24) v22 + v23;
V(25) v24 * W(34);
V(26) lane_min(v19, v25);
V(27) v24 * W(35);
V(28) lane_min(v26, v27);
V(29) fabs(v28);
V(30) W(36) + v28;
V(31) (-4.440892098500626e-16) * v29;
V(32) v30 + v31;
V(33) fabs(v32);
V(34) v32 + (-1e-300);
V(35) (-4.440892098500626e-16) * v33;
W(45) = v34 + v35;
V(37) W(16) * W(45);
V(38) lane_max(v17, v18);
V(39) lane_max(v38, v25);
V(40) lane_max(v39, v27);
V(41) fabs(v40);
V(42) W(37) + v40;
V(43) 4.440892098500626e-16 * v41;
V(44) v42 + v43;
V(45) fabs(v44);
V(46) v44 + 1e-300;
V(47) 4.440892098500626e-16 * v45;
W(44) = v46 + v47;
V(49) W(16) * W(44);
V(50) lane_min(v37, v49);
V(51) fabs(v50);
V(52) v50 + (-1e-300);
V(53) (-4.440892098500626e-16) * v51;
W(43) = v52 + v53;
V(55) lane_max(v37, v49);
V(56) fabs(v55);
V(57) v55 + 1e-300;
V(58) 4.440892098500626e-16 * v56;
W(42) = v57 + v58;
} }

APART void stretch3(lanes *restrict w)
{ LANE_LOOP {
V(0) lane_atan(W(43));
V(1) fabs(v0);
V(2) v0 + (-1e-300);
V(3) (-3.552713678800501e-15) * v1;
V(4) v2 + v3;
V(5) W(17) * v4;
V(6) lane_atan(W(42));
V(7) fabs(v6);
V(8) v6 + 1e-300;
V(9) 3.552713678800501e-15 * v7;
V(10) v8 + v9;
V(11) W(17) * v10;
V(12) lane_min(v5, v11);
V(13) fabs(v12);
V(14) v12 + (-1e-300);
V(15) (-4.440892098500626e-16) * v13;
W(37) = v14 + v15;
W(36) = 0.15915494309189535 * W(37);
V(18) W(36) + (-0.750000001);
V(19) ceil(v18);
V(20) lane_max(v5, v11);
V(21) fabs(v20);
V(22) v20 + 1e-300;
V(23) 4.440892098500626e-16 * v21;
W(35) = v22 + v23;
W(34) = 0.15915494309189535 * W(35);
V(26) W(34) + (-0.749999999);
V(27) floor(v26);
W(33) = v19 <= v27 ? 1.0 : 0.0;
V(29) fabs(W(37));
V(30) lane_min(v29, 1.0);
V(31) fabs(W(35));
V(32) lane_min(v31, 1.0);
W(32) = (-3.552713678800501e-15) * v30;
W(54) = (-3.552713678800501e-15) * v32;
V(35) W(36) + (-0.250000001);
V(36) ceil(v35);
V(37) W(34) + (-0.249999999);
V(38) floor(v37);
W(55) = v36 <= v38 ? 1.0 : 0.0;
W(56) = 3.552713678800501e-15 * v30;
W(57) = 3.552713678800501e-15 * v32;
} }

APART void stretch4(lanes *restrict w)
{ LANE_LOOP {
V(0) lane_sin(W(37));
V(1) lane_sin(W(35));
V(2) W(32) + v0;
V(3) W(54) + v1;
V(4) lane_min(v2, v3);
V(5) W(33) != 0.0 ? -1.0 : v4;
V(6) W(18) * v5;
V(7) W(56) + v0;
V(8) W(57) + v1;
V(9) lane_max(v7, v8);
V(10) W(55) != 0.0 ? 1.0 : v9;
V(11) W(18) * v10;
V(12) lane_min(v6, v11);
V(13) fabs(v12);
V(14) v12 + (-1e-300);
V(15) (-4.440892098500626e-16) * v13;
V(16) v14 + v15;
V(17) W(11) * v16;
V(18) lane_max(v6, v11);
V(19) fabs(v18);
V(20) v18 + 1e-300;
V(21) 4.440892098500626e-16 * v19;
V(22) v20 + v21;
V(23) W(11) * v22;
V(24) lane_min(v17, v23);
V(25) fabs(v24);
V(26) v24 + (-1e-300);
V(27) (-4.440892098500626e-16) * v25;
V(28) v26 + v27;
V(29) v28 * W(25);
V(30) v28 * W(26);
V(31) lane_min(v29, v30);
V(32) lane_max(v17, v23);
V(33) fabs(v32);
V(34) v32 + 1e-300;
V(35) 4.440892098500626e-16 * v33;
V(36) v34 + v35;
V(37) v36 * W(25);
V(38) lane_min(v31, v37);
V(39) v36 * W(26);
V(40) lane_min(v38, v39);
V(41) fabs(v40);
V(42) v40 + (-1e-300);
V(43) (-4.440892098500626e-16) * v41;
W(42) = v42 + v43;
V(45) W(42) * W(38);
V(46) W(42) * W(39);
V(47) 2.0 * v45;
V(48) 2.0 * v46;
V(49) lane_min(v47, v48);
V(50) lane_max(v29, v30);
V(51) lane_max(v50, v37);
V(52) lane_max(v51, v39);
V(53) fabs(v52);
V(54) v52 + 1e-300;
V(55) 4.440892098500626e-16 * v53;
W(43) = v54 + v55;
V(57) W(43) * W(38);
V(58) 2.0 * v57;
V(59) lane_min(v49, v58);
V(60) W(43) * W(39);
V(61) 2.0 * v60;
V(62) lane_min(v59, v61);
V(63) fabs(v62);
V(64) v62 + (-1e-300);
V(65) (-4.440892098500626e-16) * v63;
V(66) v64 + v65;
V(67) v66 * W(40);
V(68) v66 * W(41);
V(69) lane_min(v67, v68);
V(70) lane_max(v47, v48);
V(71) lane_max(v70, v58);
V(72) lane_max(v71, v61);
V(73) fabs(v72);
V(74) v72 + 1e-300;
V(75) 4.440892098500626e-16 * v73;
V(76) v74 + v75;
V(77) v76 * W(40);
V(78) lane_min(v69, v77);
V(79) v76 * W(41);
V(80) lane_min(v78, v79);
V(81) fabs(v80);
V(82) v80 + (-1e-300);
V(83) (-4.440892098500626e-16) * v81;
V(84) v82 + v83;
V(85) W(5) * v84;
V(86) lane_max(v67, v68);
V(87) lane_max(v86, v77);
V(88) lane_max(v87, v79);
V(89) fabs(v88);
V(90) v88 + 1e-300;
V(91) 4.440892098500626e-16 * v89;
V(92) v90 + v91;
V(93) W(5) * v92;
V(94) lane_min(v85, v93);
V(95) fabs(v94);
V(96) W(4) * v84;
V(97) W(4) * v92;
V(98) lane_min(v96, v97);
V(99) fabs(v98);
V(100) W(46) + v98;
V(101) (-4.440892098500626e-16) * v99;
V(102) v100 + v101;
V(103) fabs(v102);
V(104) v94 + (-2e-300);
V(105) (-4.440892098500626e-16) * v95;
V(106) v104 + v105;
V(107) v106 + v102;
V(108) (-4.440892098500626e-16) * v103;
V(109) v107 + v108;
V(110) fabs(v109);
V(111) v109 + (-1e-300);
V(112) (-4.440892098500626e-16) * v110;
W(58) = v111 + v112;
V(114) lane_max(v85, v93);
V(115) fabs(v114);
V(116) lane_max(v96, v97);
V(117) fabs(v116);
V(118) W(49) + v116;
V(119) 4.440892098500626e-16 * v117;
V(120) v118 + v119;
V(121) fabs(v120);
V(122) v114 + 2e-300;
V(123) 4.440892098500626e-16 * v115;
V(124) v122 + v123;
V(125) v124 + v120;
V(126) 4.440892098500626e-16 * v121;
V(127) v125 + v126;
V(128) fabs(v127);
V(129) v127 + 1e-300;
V(130) 4.440892098500626e-16 * v128;
W(59) = v129 + v130;
} }

APART void stretch5(lanes *restrict w)
{ LANE_LOOP {
W(57) = W(2) * W(5);
V(1) fabs(W(57));
V(2) 4.440892098500626e-16 * v1;
W(56) = v2 + 1e-300;
} }

APART void stretch6(lanes *restrict w)
{ LANE_LOOP {
V(0) W(58) * W(47);
V(1) W(58) * W(48);
V(2) lane_min(v0, v1);
V(3) W(59) * W(47);
V(4) lane_min(v2, v3);
V(5) W(59) * W(48);
V(6) lane_min(v4, v5);
V(7) fabs(v6);
V(8) v6 + (-1e-300);
V(9) (-4.440892098500626e-16) * v7;
W(55) = v8 + v9;
V(11) lane_max(v0, v1);
V(12) lane_max(v11, v3);
V(13) lane_max(v12, v5);
V(14) fabs(v13);
V(15) v13 + 1e-300;
V(16) 4.440892098500626e-16 * v14;
W(54) = v15 + v16;
V(18) W(4) * W(42);
V(19) W(4) * W(43);
W(32) = 2.0 * v18;
W(33) = 2.0 * v19;
} }

APART void stretch7(lanes *restrict w)
{ LANE_LOOP {
V(0) lane_atan(W(55));
V(1) fabs(v0);
V(2) v0 + (-1e-300);
V(3) (-3.552713678800501e-15) * v1;
V(4) v2 + v3;
V(5) v4 * W(52);
V(6) v4 * W(53);
V(7) lane_min(v5, v6);
V(8) lane_atan(W(54));
V(9) fabs(v8);
V(10) v8 + 1e-300;
V(11) 3.552713678800501e-15 * v9;
V(12) v10 + v11;
V(13) v12 * W(52);
V(14) lane_min(v7, v13);
V(15) v12 * W(53);
V(16) lane_min(v14, v15);
V(17) fabs(v16);
V(18) v16 + (-1e-300);
V(19) (-4.440892098500626e-16) * v17;
V(20) v18 + v19;
W(43) = W(5) * v20;
V(22) lane_max(v5, v6);
V(23) lane_max(v22, v13);
V(24) lane_max(v23, v15);
V(25) fabs(v24);
V(26) v24 + 1e-300;
V(27) 4.440892098500626e-16 * v25;
V(28) v26 + v27;
W(42) = W(5) * v28;
V(30) W(10) * v4;
V(31) W(10) * v12;
V(32) lane_min(v30, v31);
V(33) fabs(v32);
V(34) v32 + (-1e-300);
V(35) (-4.440892098500626e-16) * v33;
V(36) v34 + v35;
W(49) = W(5) * v36;
V(38) lane_max(v30, v31);
V(39) fabs(v38);
V(40) v38 + 1e-300;
V(41) 4.440892098500626e-16 * v39;
V(42) v40 + v41;
W(46) = W(5) * v42;
} }

APART void stretch8(lanes *restrict w)
{ LANE_LOOP {
V(0) W(16) * W(17);
V(1) fabs(v0);
V(2) 4.440892098500626e-16 * v1;
V(3) v2 + 1e-300;
V(4) -v3;
V(5) v0 + v4;
V(6) W(22) <= 0.0 ? 1.0 : 0.0;
V(7) 0.0 <= W(23) ? 1.0 : 0.0;
V(8) (v6 != 0.0) & (v7 != 0.0) ? 1.0 : 0.0;
V(9) v8 == 0.0 ? 1.0 : 0.0;
V(10) fabs(W(22));
V(11) fabs(W(23));
V(12) lane_min(v10, v11);
V(13) v12 * v12;
V(14) v9 != 0.0 ? v13 : 0.0;
V(15) v9 != 0.0 ? v14 : 0.0;
V(16) fabs(v15);
V(17) v15 + 1.0;
V(18) (-4.440892098500626e-16) * v16;
V(19) v17 + v18;
V(20) fabs(v19);
V(21) v19 + (-1e-300);
V(22) (-4.440892098500626e-16) * v20;
W(54) = v21 + v22;
V(24) W(21) * W(54);
V(25) lane_max(v10, v11);
V(26) v25 * v25;
V(27) 1.0000000000000004 * v26;
V(28) v27 + 1.0;
V(29) fabs(v28);
V(30) v28 + 1e-300;
V(31) 4.440892098500626e-16 * v29;
W(55) = v30 + v31;
V(33) W(21) * W(55);
V(34) lane_min(v24, v33);
V(35) W(24) * W(54);
V(36) lane_min(v34, v35);
V(37) W(24) * W(55);
V(38) lane_min(v36, v37);
V(39) fabs(v38);
V(40) v38 + (-1e-300);
V(41) (-4.440892098500626e-16) * v39;
V(42) v40 + v41;
V(43) v42 * W(27);
V(44) v42 * W(28);
V(45) lane_min(v43, v44);
V(46) lane_max(v24, v33);
V(47) lane_max(v46, v35);
V(48) lane_max(v47, v37);
V(49) fabs(v48);
V(50) v48 + 1e-300;
V(51) 4.440892098500626e-16 * v49;
V(52) v50 + v51;
V(53) v52 * W(27);
V(54) lane_min(v45, v53);
V(55) v52 * W(28);
V(56) lane_min(v54, v55);
V(57) fabs(v56);
V(58) v56 + (-1e-300);
V(59) (-4.440892098500626e-16) * v57;
V(60) v58 + v59;
V(61) W(16) * W(16);
V(62) 4.440892098500626e-16 * v61;
V(63) v62 + 1e-300;
V(64) -v63;
W(60) = v61 + v64;
V(66) W(29) <= 0.0 ? 1.0 : 0.0;
V(67) 0.0 <= W(31) ? 1.0 : 0.0;
V(68) (v66 != 0.0) & (v67 != 0.0) ? 1.0 : 0.0;
V(69) v68 == 0.0 ? 1.0 : 0.0;
V(70) fabs(W(29));
V(71) fabs(W(31));
V(72) lane_min(v70, v71);
V(73) v72 * v72;
V(74) v69 != 0.0 ? v73 : 0.0;
V(75) v69 != 0.0 ? v74 : 0.0;
V(76) fabs(v75);
V(77) v75 + (-1e-300);
V(78) (-4.440892098500626e-16) * v76;
V(79) v77 + v78;
V(80) W(60) * v79;
V(81) lane_max(v70, v71);
V(82) v81 * v81;
V(83) 1.0000000000000004 * v82;
V(84) v83 + 1e-300;
V(85) W(60) * v84;
V(86) lane_min(v80, v85);
W(61) = v61 + v63;
V(88) W(61) * v79;
V(89) lane_min(v86, v88);
V(90) W(61) * v84;
V(91) lane_min(v89, v90);
V(92) fabs(v91);
V(93) v91 + 1.0;
V(94) (-4.440892098500626e-16) * v92;
V(95) v93 + v94;
V(96) fabs(v95);
V(97) v95 + (-1e-300);
V(98) (-4.440892098500626e-16) * v96;
V(99) v97 + v98;
V(100) v99 <= 0.0 ? 1.0 : 0.0;
V(101) lane_max(v80, v85);
V(102) lane_max(v101, v88);
V(103) lane_max(v102, v90);
V(104) fabs(v103);
V(105) v103 + 1.0;
V(106) 4.440892098500626e-16 * v104;
V(107) v105 + v106;
V(108) fabs(v107);
V(109) v107 + 1e-300;
V(110) 4.440892098500626e-16 * v108;
V(111) v109 + v110;
V(112) 0.0 <= v111 ? 1.0 : 0.0;
V(113) (v100 != 0.0) & (v112 != 0.0) ? 1.0 : 0.0;
V(114) 1.0 / v111;
V(115) fabs(v114);
V(116) v114 + (-1e-300);
V(117) (-4.440892098500626e-16) * v115;
V(118) v116 + v117;
V(119) v113 != 0.0 ? (-INFINITY) : v118;
V(120) W(19) * v119;
V(121) 1.0 / v99;
V(122) fabs(v121);
V(123) v121 + 1e-300;
V(124) 4.440892098500626e-16 * v122;
V(125) v123 + v124;
V(126) v113 != 0.0 ? INFINITY : v125;
V(127) W(19) * v126;
V(128) lane_min(v120, v127);
V(129) fabs(v128);
V(130) W(30) + (-1e-300);
V(131) v130 + v128;
V(132) (-4.440892098500626e-16) * v129;
V(133) v131 + v132;
V(134) fabs(v133);
V(135) v133 + 1.0;
V(136) (-4.440892098500626e-16) * v134;
V(137) v135 + v136;
V(138) fabs(v137);
V(139) v137 + (-1e-300);
V(140) (-4.440892098500626e-16) * v138;
V(141) v139 + v140;
V(142) v60 * v141;
V(143) lane_max(v120, v127);
V(144) fabs(v143);
V(145) W(30) + 1e-300;
V(146) v145 + v143;
V(147) 4.440892098500626e-16 * v144;
V(148) v146 + v147;
V(149) fabs(v148);
V(150) v148 + 1.0;
V(151) 4.440892098500626e-16 * v149;
V(152) v150 + v151;
V(153) fabs(v152);
V(154) v152 + 1e-300;
V(155) 4.440892098500626e-16 * v153;
V(156) v154 + v155;
V(157) v60 * v156;
V(158) lane_min(v142, v157);
V(159) lane_max(v43, v44);
V(160) lane_max(v159, v53);
V(161) lane_max(v160, v55);
V(162) fabs(v161);
V(163) v161 + 1e-300;
V(164) 4.440892098500626e-16 * v162;
V(165) v163 + v164;
V(166) v165 * v141;
V(167) lane_min(v158, v166);
V(168) v165 * v156;
V(169) lane_min(v167, v168);
V(170) fabs(v169);
V(171) v169 + (-1e-300);
V(172) (-4.440892098500626e-16) * v170;
V(173) v171 + v172;
V(174) v5 * v173;
V(175) lane_max(v142, v157);
V(176) lane_max(v175, v166);
V(177) lane_max(v176, v168);
V(178) fabs(v177);
V(179) v177 + 1e-300;
V(180) 4.440892098500626e-16 * v178;
V(181) v179 + v180;
V(182) v5 * v181;
V(183) lane_min(v174, v182);
V(184) v0 + v3;
V(185) v184 * v173;
V(186) lane_min(v183, v185);
V(187) v184 * v181;
V(188) lane_min(v186, v187);
V(189) fabs(v188);
V(190) v188 + (-1e-300);
V(191) (-4.440892098500626e-16) * v189;
W(62) = v190 + v191;
V(193) lane_max(v174, v182);
V(194) lane_max(v193, v185);
V(195) lane_max(v194, v187);
V(196) fabs(v195);
V(197) v195 + 1e-300;
V(198) 4.440892098500626e-16 * v196;
W(63) = v197 + v198;
} }

APART void stretch9(lanes *restrict w)
{ LANE_LOOP {
V(0) W(50) <= 0.0 ? 1.0 : 0.0;
V(1) 0.0 <= W(51) ? 1.0 : 0.0;
V(2) (v0 != 0.0) & (v1 != 0.0) ? 1.0 : 0.0;
V(3) 1.0 / W(51);
V(4) fabs(v3);
V(5) v3 + (-1e-300);
V(6) (-4.440892098500626e-16) * v4;
V(7) v5 + v6;
W(31) = v2 != 0.0 ? (-INFINITY) : v7;
V(9) 1.0 / W(50);
V(10) fabs(v9);
V(11) v9 + 1e-300;
V(12) 4.440892098500626e-16 * v10;
V(13) v11 + v12;
W(30) = v2 != 0.0 ? INFINITY : v13;
V(15) W(6) * W(54);
V(16) W(6) * W(55);
V(17) lane_min(v15, v16);
V(18) fabs(v17);
V(19) v17 + (-2e-300);
V(20) (-4.440892098500626e-16) * v18;
W(29) = v19 + v20;
V(22) lane_max(v15, v16);
V(23) fabs(v22);
V(24) v22 + 2e-300;
V(25) 4.440892098500626e-16 * v23;
W(28) = v24 + v25;
} }

APART void stretch10(lanes *restrict w)
{ LANE_LOOP {
V(0) W(45) <= 0.0 ? 1.0 : 0.0;
V(1) 0.0 <= W(44) ? 1.0 : 0.0;
V(2) (v0 != 0.0) & (v1 != 0.0) ? 1.0 : 0.0;
V(3) v2 == 0.0 ? 1.0 : 0.0;
V(4) fabs(W(45));
V(5) fabs(W(44));
V(6) lane_min(v4, v5);
V(7) v6 * v6;
V(8) v3 != 0.0 ? v7 : 0.0;
V(9) v3 != 0.0 ? v8 : 0.0;
V(10) fabs(v9);
V(11) v9 + (-1e-300);
V(12) (-4.440892098500626e-16) * v10;
V(13) v11 + v12;
V(14) W(60) * v13;
V(15) lane_max(v4, v5);
V(16) v15 * v15;
V(17) 1.0000000000000004 * v16;
V(18) v17 + 1e-300;
V(19) W(60) * v18;
V(20) lane_min(v14, v19);
V(21) W(61) * v13;
V(22) lane_min(v20, v21);
V(23) W(61) * v18;
V(24) lane_min(v22, v23);
V(25) fabs(v24);
V(26) v24 + 1.0;
V(27) (-4.440892098500626e-16) * v25;
V(28) v26 + v27;
V(29) fabs(v28);
V(30) v28 + (-1e-300);
V(31) (-4.440892098500626e-16) * v29;
V(32) v30 + v31;
V(33) v32 <= 0.0 ? 1.0 : 0.0;
V(34) lane_max(v14, v19);
V(35) lane_max(v34, v21);
V(36) lane_max(v35, v23);
V(37) fabs(v36);
V(38) v36 + 1.0;
V(39) 4.440892098500626e-16 * v37;
V(40) v38 + v39;
V(41) fabs(v40);
V(42) v40 + 1e-300;
V(43) 4.440892098500626e-16 * v41;
V(44) v42 + v43;
V(45) 0.0 <= v44 ? 1.0 : 0.0;
V(46) (v33 != 0.0) & (v45 != 0.0) ? 1.0 : 0.0;
V(47) 1.0 / v44;
V(48) fabs(v47);
V(49) v47 + (-1e-300);
V(50) (-4.440892098500626e-16) * v48;
V(51) v49 + v50;
V(52) v46 != 0.0 ? (-INFINITY) : v51;
V(53) W(62) * v52;
V(54) 1.0 / v32;
V(55) fabs(v54);
V(56) v54 + 1e-300;
V(57) 4.440892098500626e-16 * v55;
V(58) v56 + v57;
V(59) v46 != 0.0 ? INFINITY : v58;
V(60) W(62) * v59;
V(61) lane_min(v53, v60);
V(62) W(63) * v52;
V(63) lane_min(v61, v62);
V(64) W(63) * v59;
V(65) lane_min(v63, v64);
V(66) fabs(v65);
V(67) v65 + (-1e-300);
V(68) (-4.440892098500626e-16) * v66;
V(69) v67 + v68;
V(70) W(18) * v69;
V(71) lane_max(v53, v60);
V(72) lane_max(v71, v62);
V(73) lane_max(v72, v64);
V(74) fabs(v73);
V(75) v73 + 1e-300;
V(76) 4.440892098500626e-16 * v74;
V(77) v75 + v76;
V(78) W(18) * v77;
V(79) lane_min(v70, v78);
V(80) fabs(v79);
V(81) v79 + (-1e-300);
V(82) (-4.440892098500626e-16) * v80;
W(55) = v81 + v82;
V(84) lane_max(v70, v78);
V(85) fabs(v84);
V(86) v84 + 1e-300;
V(87) 4.440892098500626e-16 * v85;
W(54) = v86 + v87;
} }

APART void stretch11(lanes *restrict w)
{ LANE_LOOP {
V(0) W(36) + (-0.500000001);
V(1) ceil(v0);
V(2) W(34) + (-0.499999999);
V(3) floor(v2);
W(63) = v1 <= v3 ? 1.0 : 0.0;
V(5) W(36) + (-1e-09);
V(6) ceil(v5);
V(7) W(34) + 1e-09;
V(8) floor(v7);
W(62) = v6 <= v8 ? 1.0 : 0.0;
} }

APART void stretch12(lanes *restrict w)
{ LANE_LOOP {
V(0) lane_cos(W(37));
V(1) lane_cos(W(35));
V(2) v0 + (-3.552713678800501e-15);
V(3) v1 + (-3.552713678800501e-15);
V(4) lane_min(v2, v3);
V(5) W(63) != 0.0 ? -1.0 : v4;
V(6) W(55) * v5;
V(7) v0 + 3.552713678800501e-15;
V(8) v1 + 3.552713678800501e-15;
V(9) lane_max(v7, v8);
V(10) W(62) != 0.0 ? 1.0 : v9;
V(11) W(55) * v10;
V(12) lane_min(v6, v11);
V(13) W(54) * v5;
V(14) lane_min(v12, v13);
V(15) W(54) * v10;
V(16) lane_min(v14, v15);
V(17) fabs(v16);
V(18) v16 + (-1e-300);
V(19) (-4.440892098500626e-16) * v17;
V(20) v18 + v19;
V(21) W(11) * v20;
V(22) lane_max(v6, v11);
V(23) lane_max(v22, v13);
V(24) lane_max(v23, v15);
V(25) fabs(v24);
V(26) v24 + 1e-300;
V(27) 4.440892098500626e-16 * v25;
V(28) v26 + v27;
V(29) W(11) * v28;
V(30) lane_min(v21, v29);
V(31) fabs(v30);
V(32) v30 + (-1e-300);
V(33) (-4.440892098500626e-16) * v31;
V(34) v32 + v33;
V(35) v34 * W(25);
V(36) v34 * W(26);
V(37) lane_min(v35, v36);
V(38) lane_max(v21, v29);
V(39) fabs(v38);
V(40) v38 + 1e-300;
V(41) 4.440892098500626e-16 * v39;
V(42) v40 + v41;
V(43) v42 * W(25);
V(44) lane_min(v37, v43);
V(45) v42 * W(26);
V(46) lane_min(v44, v45);
V(47) fabs(v46);
V(48) v46 + (-1e-300);
V(49) (-4.440892098500626e-16) * v47;
W(34) = v48 + v49;
V(51) W(34) * W(40);
V(52) W(34) * W(41);
V(53) 2.0 * v51;
V(54) 2.0 * v52;
V(55) lane_min(v53, v54);
V(56) lane_max(v35, v36);
V(57) lane_max(v56, v43);
V(58) lane_max(v57, v45);
V(59) fabs(v58);
V(60) v58 + 1e-300;
V(61) 4.440892098500626e-16 * v59;
W(36) = v60 + v61;
V(63) W(36) * W(40);
V(64) 2.0 * v63;
V(65) lane_min(v55, v64);
V(66) W(36) * W(41);
V(67) 2.0 * v66;
V(68) lane_min(v65, v67);
V(69) fabs(v68);
V(70) v68 + (-1e-300);
V(71) (-4.440892098500626e-16) * v69;
V(72) v70 + v71;
V(73) v72 * W(38);
V(74) v72 * W(39);
V(75) lane_min(v73, v74);
V(76) lane_max(v53, v54);
V(77) lane_max(v76, v64);
V(78) lane_max(v77, v67);
V(79) fabs(v78);
V(80) v78 + 1e-300;
V(81) 4.440892098500626e-16 * v79;
V(82) v80 + v81;
V(83) v82 * W(38);
V(84) lane_min(v75, v83);
V(85) v82 * W(39);
V(86) lane_min(v84, v85);
V(87) fabs(v86);
V(88) v86 + (-1e-300);
V(89) (-4.440892098500626e-16) * v87;
V(90) v88 + v89;
V(91) W(5) * v90;
V(92) lane_max(v73, v74);
V(93) lane_max(v92, v83);
V(94) lane_max(v93, v85);
V(95) fabs(v94);
V(96) v94 + 1e-300;
V(97) 4.440892098500626e-16 * v95;
V(98) v96 + v97;
V(99) W(5) * v98;
V(100) lane_min(v91, v99);
V(101) fabs(v100);
V(102) v100 + (-1e-300);
V(103) (-4.440892098500626e-16) * v101;
V(104) v102 + v103;
V(105) W(58) <= 0.0 ? 1.0 : 0.0;
V(106) 0.0 <= W(59) ? 1.0 : 0.0;
V(107) (v105 != 0.0) & (v106 != 0.0) ? 1.0 : 0.0;
V(108) v107 == 0.0 ? 1.0 : 0.0;
V(109) fabs(W(58));
V(110) fabs(W(59));
V(111) lane_min(v109, v110);
V(112) v111 * v111;
V(113) v108 != 0.0 ? v112 : 0.0;
V(114) v108 != 0.0 ? v113 : 0.0;
V(115) fabs(v114);
V(116) v114 + (-1e-300);
V(117) (-4.440892098500626e-16) * v115;
V(118) v116 + v117;
V(119) v118 * W(31);
V(120) v118 * W(30);
V(121) lane_min(v119, v120);
V(122) lane_max(v109, v110);
V(123) v122 * v122;
V(124) 1.0000000000000004 * v123;
V(125) v124 + 1e-300;
V(126) v125 * W(31);
V(127) lane_min(v121, v126);
V(128) v125 * W(30);
V(129) lane_min(v127, v128);
V(130) fabs(v129);
V(131) v129 + 1.0;
V(132) (-4.440892098500626e-16) * v130;
V(133) v131 + v132;
V(134) fabs(v133);
V(135) v133 + (-1e-300);
V(136) (-4.440892098500626e-16) * v134;
V(137) v135 + v136;
V(138) v137 <= 0.0 ? 1.0 : 0.0;
V(139) lane_max(v119, v120);
V(140) lane_max(v139, v126);
V(141) lane_max(v140, v128);
V(142) fabs(v141);
V(143) v141 + 1.0;
V(144) 4.440892098500626e-16 * v142;
V(145) v143 + v144;
V(146) fabs(v145);
V(147) v145 + 1e-300;
V(148) 4.440892098500626e-16 * v146;
V(149) v147 + v148;
V(150) 0.0 <= v149 ? 1.0 : 0.0;
V(151) (v138 != 0.0) & (v150 != 0.0) ? 1.0 : 0.0;
V(152) 1.0 / v149;
V(153) fabs(v152);
V(154) v152 + (-1e-300);
V(155) (-4.440892098500626e-16) * v153;
V(156) v154 + v155;
W(61) = v151 != 0.0 ? (-INFINITY) : v156;
V(158) v104 * W(61);
V(159) 1.0 / v137;
V(160) fabs(v159);
V(161) v159 + 1e-300;
V(162) 4.440892098500626e-16 * v160;
V(163) v161 + v162;
W(60) = v151 != 0.0 ? INFINITY : v163;
V(165) v104 * W(60);
V(166) lane_min(v158, v165);
V(167) lane_max(v91, v99);
V(168) fabs(v167);
V(169) v167 + 1e-300;
V(170) 4.440892098500626e-16 * v168;
V(171) v169 + v170;
V(172) v171 * W(61);
V(173) lane_min(v166, v172);
V(174) v171 * W(60);
V(175) lane_min(v173, v174);
V(176) fabs(v175);
V(177) v175 + (-1e-300);
V(178) (-4.440892098500626e-16) * v176;
V(179) v177 + v178;
W(44) = v179 * W(47);
W(45) = v179 * W(48);
V(182) lane_min(W(44), W(45));
V(183) lane_max(v158, v165);
V(184) lane_max(v183, v172);
V(185) lane_max(v184, v174);
V(186) fabs(v185);
V(187) v185 + 1e-300;
V(188) 4.440892098500626e-16 * v186;
V(189) v187 + v188;
W(51) = v189 * W(47);
V(191) lane_min(v182, W(51));
W(50) = v189 * W(48);
W(27) = lane_min(v191, W(50));
W(24) = fabs(W(27));
W(23) = W(4) * v90;
W(22) = W(4) * v98;
V(197) lane_min(W(23), W(22));
W(21) = fabs(v197);
W(64) = W(29) + v197;
} }

APART void stretch13(lanes *restrict w)
{ LANE_LOOP {
V(0) (-4.440892098500626e-16) * W(21);
V(1) W(64) + v0;
V(2) fabs(v1);
V(3) v1 + (-1e-300);
V(4) (-4.440892098500626e-16) * v2;
V(5) v3 + v4;
V(6) v5 * W(61);
V(7) v5 * W(60);
V(8) lane_min(v6, v7);
V(9) lane_max(W(23), W(22));
V(10) fabs(v9);
V(11) W(28) + v9;
V(12) 4.440892098500626e-16 * v10;
V(13) v11 + v12;
V(14) fabs(v13);
V(15) v13 + 1e-300;
V(16) 4.440892098500626e-16 * v14;
V(17) v15 + v16;
V(18) v17 * W(61);
V(19) lane_min(v8, v18);
V(20) v17 * W(60);
V(21) lane_min(v19, v20);
V(22) fabs(v21);
V(23) v21 + (-1e-300);
V(24) (-4.440892098500626e-16) * v22;
V(25) v23 + v24;
V(26) v25 * W(47);
V(27) v25 * W(48);
V(28) lane_min(v26, v27);
V(29) lane_max(v6, v7);
V(30) lane_max(v29, v18);
V(31) lane_max(v30, v20);
V(32) fabs(v31);
V(33) v31 + 1e-300;
V(34) 4.440892098500626e-16 * v32;
V(35) v33 + v34;
V(36) v35 * W(47);
V(37) lane_min(v28, v36);
V(38) v35 * W(48);
V(39) lane_min(v37, v38);
V(40) fabs(v39);
V(41) W(27) + (-2e-300);
V(42) (-4.440892098500626e-16) * W(24);
V(43) v41 + v42;
V(44) v43 + v39;
V(45) (-4.440892098500626e-16) * v40;
V(46) v44 + v45;
V(47) fabs(v46);
V(48) v46 + (-1e-300);
V(49) (-4.440892098500626e-16) * v47;
V(50) v48 + v49;
V(51) v50 * W(52);
V(52) v50 * W(53);
V(53) lane_min(v51, v52);
V(54) lane_max(W(44), W(45));
V(55) lane_max(v54, W(51));
V(56) lane_max(v55, W(50));
V(57) fabs(v56);
V(58) lane_max(v26, v27);
V(59) lane_max(v58, v36);
V(60) lane_max(v59, v38);
V(61) fabs(v60);
V(62) v56 + 2e-300;
V(63) 4.440892098500626e-16 * v57;
V(64) v62 + v63;
V(65) v64 + v60;
V(66) 4.440892098500626e-16 * v61;
V(67) v65 + v66;
V(68) fabs(v67);
V(69) v67 + 1e-300;
V(70) 4.440892098500626e-16 * v68;
V(71) v69 + v70;
V(72) v71 * W(52);
V(73) lane_min(v53, v72);
V(74) v71 * W(53);
V(75) lane_min(v73, v74);
V(76) fabs(v75);
V(77) v75 + (-1e-300);
V(78) (-4.440892098500626e-16) * v76;
V(79) v77 + v78;
W(62) = W(5) * v79;
V(81) lane_max(v51, v52);
V(82) lane_max(v81, v72);
V(83) lane_max(v82, v74);
V(84) fabs(v83);
V(85) v83 + 1e-300;
V(86) 4.440892098500626e-16 * v84;
V(87) v85 + v86;
W(63) = W(5) * v87;
V(89) W(4) * W(34);
V(90) W(4) * W(36);
W(54) = 2.0 * v89;
W(55) = 2.0 * v90;
V(93) W(10) * v50;
V(94) W(10) * v71;
V(95) lane_min(v93, v94);
V(96) fabs(v95);
V(97) v95 + (-1e-300);
V(98) (-4.440892098500626e-16) * v96;
V(99) v97 + v98;
W(29) = W(5) * v99;
V(101) lane_max(v93, v94);
V(102) fabs(v101);
V(103) v101 + 1e-300;
V(104) 4.440892098500626e-16 * v102;
V(105) v103 + v104;
W(30) = W(5) * v105;
} }

APART void stretch14(lanes *restrict w)
{ LANE_LOOP {
V(0) W(57) + 1e-300;
W(64) = v0 + W(56);
} }

APART void stretch15(lanes *restrict w)
{ LANE_LOOP {
V(0) lane_max(W(32), W(33));
V(1) fabs(v0);
V(2) W(64) + v0;
V(3) 4.440892098500626e-16 * v1;
V(4) v2 + v3;
V(5) fabs(v4);
V(6) -v4;
V(7) v6 + (-2e-300);
V(8) (-4.440892098500626e-16) * v5;
W(21) = v7 + v8;
} }

APART void stretch16(lanes *restrict w)
{ LANE_LOOP {
V(0) lane_min(W(43), W(42));
V(1) fabs(v0);
V(2) W(21) + v0;
V(3) (-4.440892098500626e-16) * v1;
V(4) v2 + v3;
V(5) fabs(v4);
V(6) lane_min(W(49), W(46));
V(7) fabs(v6);
V(8) v4 + (-2e-300);
V(9) (-4.440892098500626e-16) * v5;
V(10) v8 + v9;
V(11) v10 + v6;
V(12) (-4.440892098500626e-16) * v7;
V(13) v11 + v12;
V(14) fabs(v13);
V(15) v13 + (-1e-300);
V(16) (-4.440892098500626e-16) * v14;
W(64) = v15 + v16;
} }

APART void stretch17(lanes *restrict w)
{ LANE_LOOP {
V(0) W(57) + (-1e-300);
V(1) -W(56);
W(21) = v0 + v1;
} }

APART void stretch18(lanes *restrict w)
{ LANE_LOOP {
V(0) lane_min(W(32), W(33));
V(1) fabs(v0);
V(2) W(21) + v0;
V(3) (-4.440892098500626e-16) * v1;
V(4) v2 + v3;
V(5) fabs(v4);
V(6) -v4;
V(7) v6 + 2e-300;
V(8) 4.440892098500626e-16 * v5;
W(56) = v7 + v8;
} }

APART void stretch19(lanes *restrict w)
{ LANE_LOOP {
V(0) lane_max(W(43), W(42));
V(1) fabs(v0);
V(2) W(56) + v0;
V(3) 4.440892098500626e-16 * v1;
V(4) v2 + v3;
V(5) fabs(v4);
V(6) lane_max(W(49), W(46));
V(7) fabs(v6);
V(8) v4 + 2e-300;
V(9) 4.440892098500626e-16 * v5;
V(10) v8 + v9;
V(11) v10 + v6;
V(12) 4.440892098500626e-16 * v7;
V(13) v11 + v12;
V(14) fabs(v13);
V(15) v13 + 1e-300;
V(16) 4.440892098500626e-16 * v14;
W(21) = v15 + v16;
} }

APART void stretch20(lanes *restrict w)
{ LANE_LOOP {
V(0) lane_min(W(62), W(63));
V(1) fabs(v0);
V(2) lane_max(W(54), W(55));
V(3) fabs(v2);
V(4) v0 + (-2e-300);
V(5) (-4.440892098500626e-16) * v1;
V(6) v4 + v5;
V(7) -v2;
V(8) v6 + v7;
V(9) (-4.440892098500626e-16) * v3;
V(10) v8 + v9;
V(11) fabs(v10);
V(12) lane_min(W(29), W(30));
V(13) fabs(v12);
V(14) v10 + (-2e-300);
V(15) (-4.440892098500626e-16) * v11;
V(16) v14 + v15;
V(17) v16 + v12;
V(18) (-4.440892098500626e-16) * v13;
V(19) v17 + v18;
V(20) fabs(v19);
V(21) v19 + (-1e-300);
V(22) (-4.440892098500626e-16) * v20;
W(56) = v21 + v22;
} }

APART void stretch21(lanes *restrict w)
{ LANE_LOOP {
V(0) lane_max(W(62), W(63));
V(1) fabs(v0);
V(2) lane_min(W(54), W(55));
V(3) fabs(v2);
V(4) v0 + 2e-300;
V(5) 4.440892098500626e-16 * v1;
V(6) v4 + v5;
V(7) -v2;
V(8) v6 + v7;
V(9) 4.440892098500626e-16 * v3;
V(10) v8 + v9;
V(11) fabs(v10);
V(12) lane_max(W(29), W(30));
V(13) fabs(v12);
V(14) v10 + 2e-300;
V(15) 4.440892098500626e-16 * v11;
V(16) v14 + v15;
V(17) v16 + v12;
V(18) 4.440892098500626e-16 * v13;
V(19) v17 + v18;
V(20) fabs(v19);
V(21) v19 + 1e-300;
V(22) 4.440892098500626e-16 * v20;
W(46) = v21 + v22;
} }

static void constants(lanes *w)
{
    LANE_LOOP W(20) = 0.0;
}

static void evaluate(lanes *w, int asked)
{
    if (asked & 960) stretch0(w);
    if (asked & 960) stretch1(w);
    if (asked & 960) stretch2(w);
    if (asked & 960) stretch3(w);
    if (asked & 960) stretch4(w);
    if (asked & 192) stretch5(w);
    if (asked & 192) stretch6(w);
    if (asked & 192) stretch7(w);
    if (asked & 768) stretch8(w);
    if (asked & 768) stretch9(w);
    if (asked & 768) stretch10(w);
    if (asked & 768) stretch11(w);
    if (asked & 768) stretch12(w);
    if (asked & 768) stretch13(w);
    if (asked & 64) stretch14(w);
    if (asked & 64) stretch15(w);
    if (asked & 64) stretch16(w);
    if (asked & 128) stretch17(w);
    if (asked & 128) stretch18(w);
    if (asked & 128) stretch19(w);
    if (asked & 256) stretch20(w);
    if (asked & 512) stretch21(w);
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
