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

enum { N_IN = 19, N_ROWS = 122, N_RESULTS = 8 };
/* Of each result its first element and its part; of each element its row. */
static const int32_t FIRST[] = {0,7,56,63,140,150,220,230,340};
static const int PART[] = {1,2,2,4,8,16,16,32};
static const int16_t PLACE[] = {63,40,0,1,38,39,1,46,66,19,19,19,19,19,64,67,19,19,19,19,19,121,19,19,19,19,19,19,19,121,19,19,19,19,19,65,19,19,19,19,19,68,35,19,19,19,19,19,38,19,121,19,19,19,19,19,23,69,19,19,19,19,19,56,19,71,73,75,77,79,81,59,60,19,19,70,72,74,76,78,80,82,83,84,19,19,19,19,19,19,19,19,19,19,19,19,19,19,19,19,19,19,19,19,19,19,19,19,19,19,19,35,19,19,19,19,19,19,19,19,19,19,36,19,19,19,19,19,19,19,19,19,19,19,19,19,19,19,19,19,24,26,61,41,62,30,33,32,37,34,20,50,19,19,19,19,19,20,29,19,19,19,19,19,20,19,19,19,19,19,19,43,85,19,19,19,19,19,44,86,19,19,19,19,19,42,87,19,19,19,19,19,46,54,19,19,19,19,19,25,53,19,19,19,19,19,47,88,19,19,19,19,19,19,19,19,19,19,19,19,19,19,19,19,19,19,23,121,89,19,19,19,55,19,95,19,19,19,19,19,19,19,19,19,45,96,19,19,19,19,19,19,19,19,19,19,97,19,19,19,19,19,19,19,19,52,19,98,19,19,19,116,19,19,19,19,19,90,99,104,108,112,19,19,19,19,19,19,91,100,19,19,19,19,26,19,56,19,51,93,102,105,109,113,59,60,19,19,19,49,92,101,106,110,114,117,119,19,19,19,48,94,103,107,111,115,118,120,19,18,19,19,19,19,19,19,19,19,19,8};

APART void stretch0(lanes *restrict w)
{ LANE_LOOP {
W(20) = 1.0 / W(12);
W(21) = W(14) * W(15);
W(22) = W(12) * W(12);
W(23) = 1.0 / W(8);
} }

APART void stretch1(lanes *restrict w)
{ LANE_LOOP {
V(0) W(10) * W(1);
V(1) W(0) + v0;
W(24) = v1 * W(20);
W(25) = W(16) * W(24);
V(4) W(11) * W(1);
V(5) -v4;
V(6) W(0) + v5;
W(26) = v6 * W(20);
W(27) = W(21) * W(26);
W(28) = W(27) * W(13);
W(29) = W(28) * W(22);
W(30) = W(17) * W(26);
W(31) = (-2.0) * W(25);
V(13) W(7) + W(31);
V(14) (-0.5) * W(29);
V(15) v13 + v14;
V(16) -W(30);
W(32) = v15 + v16;
W(33) = W(32) * W(23);
} }

APART void stretch2(lanes *restrict w)
{ LANE_LOOP {
W(34) = 1.0 / W(9);
W(35) = lane_cos(W(6));
W(36) = lane_sin(W(6));
} }

APART void stretch3(lanes *restrict w)
{ LANE_LOOP {
V(0) W(29) * W(11);
V(1) W(7) * W(11);
V(2) W(25) * W(10);
V(3) W(30) * W(11);
V(4) 0.5 * v0;
V(5) -v1;
V(6) v4 + v5;
V(7) (-2.0) * v2;
V(8) v6 + v7;
W(37) = v8 + v3;
} }

APART void stretch4(lanes *restrict w)
{ LANE_LOOP {
V(0) W(12) * W(35);
V(1) W(0) * W(36);
V(2) -v1;
W(38) = v0 + v2;
V(4) W(12) * W(36);
V(5) W(0) * W(35);
W(39) = v4 + v5;
} }

APART void stretch5(lanes *restrict w)
{ LANE_LOOP {
W(40) = W(37) * W(34);
} }

APART void stretch6(lanes *restrict w)
{ LANE_LOOP {
W(41) = W(11) * W(34);
} }

APART void stretch7(lanes *restrict w)
{ LANE_LOOP {
V(0) W(16) * W(20);
V(1) W(21) * W(20);
V(2) W(13) * v1;
V(3) W(22) * v2;
W(42) = W(17) * W(20);
W(43) = 2.0 * v0;
W(44) = 0.5 * v3;
V(7) W(43) + W(44);
W(45) = v7 + W(42);
V(9) W(45) * W(23);
W(46) = -v9;
V(11) W(11) * v3;
V(12) W(10) * v0;
V(13) W(11) * W(42);
V(14) 0.5 * v11;
V(15) (-2.0) * v12;
V(16) v14 + v15;
W(47) = v16 + v13;
W(48) = W(11) * W(20);
V(19) W(21) * W(48);
V(20) W(13) * v19;
W(49) = W(22) * v20;
W(50) = W(10) * W(20);
W(51) = W(16) * W(50);
W(52) = W(17) * W(48);
V(25) 0.5 * W(49);
V(26) (-2.0) * W(51);
V(27) v25 + v26;
W(53) = v27 + W(52);
W(54) = W(53) * W(23);
V(30) W(11) * W(49);
V(31) W(10) * W(51);
V(32) W(11) * W(52);
V(33) 0.5 * v30;
V(34) 2.0 * v31;
V(35) v33 + v34;
W(55) = v35 + v32;
} }

#if BY_PARAMETERS
APART void stretch8(lanes *restrict w)
{ LANE_LOOP {
V(0) W(33) * W(23);
W(56) = -v0;
W(57) = W(26) * W(20);
W(58) = W(24) * W(20);
V(4) W(24) * W(23);
W(59) = (-2.0) * v4;
V(6) W(26) * W(23);
W(60) = -v6;
} }
#endif

APART void stretch9(lanes *restrict w)
{ LANE_LOOP {
W(61) = W(0) * W(20);
W(62) = 0.5 * W(29);
} }

APART void stretch10(lanes *restrict w)
{ LANE_LOOP {
V(0) W(1) * W(12);
V(1) -v0;
W(63) = W(33) + v1;
} }

APART void stretch11(lanes *restrict w)
{ LANE_LOOP {
W(64) = W(47) * W(34);
W(65) = -W(36);
V(2) -W(12);
W(66) = v2 + W(54);
V(4) W(55) * W(34);
W(67) = -v4;
W(68) = -W(39);
W(69) = -W(41);
} }

#if BY_PARAMETERS
APART void stretch12(lanes *restrict w)
{ LANE_LOOP {
V(0) W(40) * W(34);
W(70) = -v0;
V(2) W(16) * W(23);
V(3) v2 * W(20);
V(4) W(1) * v3;
W(71) = (-2.0) * v4;
V(6) W(10) * W(34);
V(7) W(16) * v6;
V(8) v7 * W(20);
V(9) W(1) * v8;
V(10) W(25) * W(34);
V(11) (-2.0) * v9;
V(12) (-2.0) * v10;
W(72) = v11 + v12;
V(14) W(17) * W(23);
V(15) W(22) * W(23);
V(16) W(13) * v15;
V(17) W(21) * v16;
V(18) 0.5 * v17;
V(19) v14 + v18;
V(20) v19 * W(20);
W(73) = W(1) * v20;
V(22) W(30) * W(34);
V(23) W(7) * W(34);
V(24) W(29) * W(34);
V(25) W(17) * W(41);
V(26) W(22) * W(41);
V(27) W(13) * v26;
V(28) W(21) * v27;
V(29) 0.5 * v28;
V(30) v25 + v29;
V(31) v30 * W(20);
V(32) W(1) * v31;
V(33) -v23;
V(34) v22 + v33;
V(35) 0.5 * v24;
V(36) v34 + v35;
V(37) -v32;
W(74) = v36 + v37;
V(39) W(57) * v19;
V(40) W(28) * W(23);
V(41) W(12) * v40;
V(42) W(58) * v2;
V(43) -W(1);
V(44) v43 + v39;
V(45) -v41;
V(46) v44 + v45;
V(47) 2.0 * v42;
W(75) = v46 + v47;
V(49) W(28) * W(41);
V(50) W(12) * v49;
V(51) W(57) * v30;
V(52) W(58) * v7;
V(53) -v51;
V(54) v50 + v53;
V(55) 2.0 * v52;
W(76) = v54 + v55;
V(57) W(27) * v15;
W(77) = (-0.5) * v57;
V(59) W(27) * v26;
W(78) = 0.5 * v59;
V(61) W(26) * v16;
V(62) W(15) * v61;
W(79) = (-0.5) * v62;
V(64) W(26) * v27;
V(65) W(15) * v64;
W(80) = 0.5 * v65;
V(67) W(14) * v61;
W(81) = (-0.5) * v67;
V(69) W(14) * v64;
W(82) = 0.5 * v69;
V(71) W(24) * v6;
W(83) = (-2.0) * v71;
W(84) = W(26) * W(41);
} }
#endif

APART void stretch13(lanes *restrict w)
{ LANE_LOOP {
W(41) = 2.0 * W(25);
W(34) = W(18) * W(8);
} }

APART void stretch14(lanes *restrict w)
{ LANE_LOOP {
W(25) = -W(45);
W(29) = -W(48);
W(85) = 2.0 * W(51);
W(86) = (-0.5) * W(49);
W(87) = -W(52);
W(88) = -W(55);
W(89) = -W(11);
} }

#if BY_PARAMETERS
APART void stretch15(lanes *restrict w)
{ LANE_LOOP {
W(55) = W(1) * W(20);
V(1) W(16) * W(55);
W(52) = 2.0 * v1;
V(3) v1 * W(23);
W(51) = (-2.0) * v3;
W(49) = (-2.0) * v1;
V(6) W(10) * v1;
V(7) (-2.0) * v6;
W(48) = W(31) + v7;
W(45) = -W(55);
V(10) W(21) * W(55);
V(11) W(13) * v10;
V(12) W(22) * v11;
W(90) = (-0.5) * v12;
V(14) W(17) * W(55);
W(91) = -v14;
V(16) 0.5 * v12;
W(92) = v16 + v14;
W(93) = W(92) * W(23);
V(19) W(11) * v12;
V(20) W(11) * v14;
V(21) -W(7);
V(22) v21 + W(62);
V(23) v22 + W(30);
V(24) (-0.5) * v19;
V(25) v23 + v24;
V(26) -v20;
W(94) = v25 + v26;
W(95) = -W(58);
W(96) = -W(57);
V(30) W(61) * W(20);
W(97) = -v30;
V(32) W(16) * W(58);
W(98) = (-2.0) * v32;
V(34) W(28) * W(12);
V(35) W(21) * W(57);
V(36) W(13) * v35;
V(37) W(22) * v36;
V(38) (-0.5) * v37;
W(99) = v34 + v38;
V(40) W(17) * W(57);
W(100) = -v40;
V(42) 2.0 * v32;
V(43) -W(99);
V(44) v42 + v43;
W(101) = v44 + v40;
W(102) = W(101) * W(23);
V(47) W(11) * W(99);
V(48) W(10) * v32;
V(49) W(11) * v40;
V(50) 2.0 * v48;
V(51) v47 + v50;
V(52) -v49;
W(103) = v51 + v52;
V(54) W(22) * W(27);
W(104) = 0.5 * v54;
V(56) v54 * W(23);
W(105) = (-0.5) * v56;
W(106) = (-0.5) * v54;
V(59) W(11) * v54;
W(107) = 0.5 * v59;
V(61) W(26) * W(15);
V(62) W(13) * v61;
V(63) W(22) * v62;
W(108) = 0.5 * v63;
V(65) v63 * W(23);
W(109) = (-0.5) * v65;
W(110) = (-0.5) * v63;
V(68) W(11) * v63;
W(111) = 0.5 * v68;
V(70) W(26) * W(14);
V(71) W(13) * v70;
V(72) W(22) * v71;
W(112) = 0.5 * v72;
V(74) v72 * W(23);
W(113) = (-0.5) * v74;
W(114) = (-0.5) * v72;
V(77) W(11) * v72;
W(115) = 0.5 * v77;
W(116) = 2.0 * W(24);
W(117) = (-2.0) * W(24);
V(81) W(10) * W(24);
W(118) = (-2.0) * v81;
W(119) = -W(26);
W(120) = W(11) * W(26);
} }
#endif

static void constants(lanes *w)
{
    LANE_LOOP W(19) = 0.0;
    LANE_LOOP W(121) = 1.0;
}

static void evaluate(lanes *w, int asked)
{
    if (asked & 63) stretch0(w);
    if (asked & 45) stretch1(w);
    if (asked & 7) stretch2(w);
    if (asked & 13) stretch3(w);
    if (asked & 3) stretch4(w);
    if (asked & 5) stretch5(w);
    if (asked & 6) stretch6(w);
    if (asked & 18) stretch7(w);
    #if BY_PARAMETERS
    if (asked & 36) stretch8(w);
    #endif
    if (asked & 40) stretch9(w);
    if (asked & 1) stretch10(w);
    if (asked & 2) stretch11(w);
    #if BY_PARAMETERS
    if (asked & 4) stretch12(w);
    #endif
    if (asked & 8) stretch13(w);
    if (asked & 16) stretch14(w);
    #if BY_PARAMETERS
    if (asked & 32) stretch15(w);
    #endif
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
