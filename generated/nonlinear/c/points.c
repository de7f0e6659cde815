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

enum { N_IN = 27, N_ROWS = 198, N_RESULTS = 8 };
/* Of each result its first element and its part; of each element its row. */
static const int32_t FIRST[] = {0,7,56,63,196,207,284,295,504};
static const int PART[] = {1,2,2,4,8,16,16,32};
static const int16_t PLACE[] = {62,76,0,1,69,70,1,108,110,27,27,27,27,27,109,111,27,27,27,27,27,197,27,27,27,27,27,27,27,197,27,27,27,27,27,102,27,27,27,27,27,106,53,27,27,27,27,27,69,27,197,27,27,27,27,27,37,107,27,27,27,27,27,79,27,41,115,129,120,122,124,91,133,132,137,131,139,141,143,145,147,27,27,49,128,116,130,121,123,125,126,136,135,138,134,140,142,144,146,148,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,53,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,54,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,127,38,119,114,35,42,98,97,113,118,117,95,103,27,27,27,27,27,56,104,27,27,27,27,27,57,27,27,27,27,27,27,89,84,27,27,27,27,27,80,51,27,27,27,27,27,47,78,27,27,27,27,27,88,73,27,27,27,27,27,87,83,27,27,27,27,27,85,72,27,27,27,27,27,68,75,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,37,197,74,27,27,27,27,105,27,50,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,86,48,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,46,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,100,27,65,27,27,27,27,60,40,33,173,177,181,185,189,193,27,27,27,27,82,29,152,156,160,27,27,27,27,27,27,27,27,27,27,27,27,27,27,81,149,27,27,27,38,27,27,27,27,27,27,27,27,27,27,101,27,99,55,63,153,157,161,91,59,39,32,174,178,182,186,190,194,27,27,27,43,71,64,154,158,162,164,58,36,31,175,179,183,187,191,195,27,27,27,90,52,61,155,159,163,165,44,34,28,176,180,184,188,192,196,27,77,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,26,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,27,8};

APART void stretch0(lanes *restrict w)
{ LANE_LOOP {
V(0) W(19) * W(17);
W(28) = W(18) + v0;
V(2) W(10) * W(1);
W(29) = W(0) + v2;
V(4) W(21) * W(17);
W(30) = W(20) + v4;
V(6) -W(25);
W(31) = v6 + 1.0;
W(32) = 1.0 / W(22);
W(33) = W(14) * W(15);
V(10) W(11) * W(1);
W(34) = 1.0 / W(12);
V(12) -v10;
V(13) W(0) + v12;
W(35) = v13 * W(34);
W(36) = W(12) * W(12);
W(37) = 1.0 / W(8);
} }

APART void stretch1(lanes *restrict w)
{ LANE_LOOP {
W(38) = lane_atan(W(35));
W(39) = W(33) * W(38);
W(40) = W(39) * W(13);
W(41) = W(40) * W(36);
W(42) = W(16) * W(38);
V(5) (-0.5) * W(41);
V(6) W(7) + v5;
V(7) -W(42);
W(43) = v6 + v7;
} }

APART void stretch2(lanes *restrict w)
{ LANE_LOOP {
V(0) W(35) * W(35);
V(1) v0 + 1.0;
W(44) = 1.0 / v1;
} }

APART void stretch3(lanes *restrict w)
{ LANE_LOOP {
V(0) W(28) * W(29);
V(1) W(30) * W(12);
W(45) = 1.0 / v1;
W(46) = v0 * W(45);
V(4) W(46) * W(31);
W(47) = W(22) * W(46);
W(48) = lane_atan(W(47));
V(7) W(25) * W(48);
W(49) = v7 * W(32);
W(50) = v4 + W(49);
W(51) = W(22) * W(50);
W(52) = 1.0 / W(9);
W(53) = lane_cos(W(6));
W(54) = lane_sin(W(6));
} }

APART void stretch4(lanes *restrict w)
{ LANE_LOOP {
W(55) = lane_atan(W(51));
W(56) = W(23) * W(55);
} }

APART void stretch5(lanes *restrict w)
{ LANE_LOOP {
V(0) W(41) * W(11);
V(1) W(7) * W(11);
V(2) W(42) * W(11);
V(3) -v1;
V(4) 0.5 * v0;
V(5) v3 + v4;
W(57) = v5 + v2;
} }

APART void stretch6(lanes *restrict w)
{ LANE_LOOP {
W(58) = W(29) * W(34);
W(59) = W(0) * W(34);
V(2) W(28) * W(58);
W(60) = 1.0 / W(30);
W(61) = v2 * W(60);
V(5) W(61) * W(31);
W(62) = W(22) * W(61);
W(63) = lane_atan(W(62));
V(8) W(25) * W(63);
W(64) = v8 * W(32);
W(65) = v5 + W(64);
W(66) = W(22) * W(65);
} }

APART void stretch7(lanes *restrict w)
{ LANE_LOOP {
W(67) = lane_atan(W(66));
W(68) = W(23) * W(67);
} }

APART void stretch8(lanes *restrict w)
{ LANE_LOOP {
V(0) W(12) * W(53);
V(1) W(0) * W(54);
V(2) -v1;
W(69) = v0 + v2;
V(4) W(12) * W(54);
V(5) W(0) * W(53);
W(70) = v4 + v5;
} }

APART void stretch9(lanes *restrict w)
{ LANE_LOOP {
W(71) = lane_sin(W(56));
W(72) = W(24) * W(71);
W(73) = W(72) * W(17);
W(74) = W(73) * W(30);
V(4) (-2.0) * W(74);
V(5) W(43) + v4;
W(75) = v5 * W(37);
V(7) W(74) * W(10);
V(8) (-2.0) * v7;
V(9) W(57) + v8;
W(76) = v9 * W(52);
} }

APART void stretch10(lanes *restrict w)
{ LANE_LOOP {
V(0) W(47) * W(47);
V(1) v0 + 1.0;
W(77) = 1.0 / v1;
V(3) W(51) * W(51);
V(4) v3 + 1.0;
W(78) = 1.0 / v4;
W(79) = W(11) * W(52);
} }

APART void stretch11(lanes *restrict w)
{ LANE_LOOP {
W(51) = lane_cos(W(56));
} }

APART void stretch12(lanes *restrict w)
{ LANE_LOOP {
W(56) = W(44) * W(34);
V(1) W(33) * W(56);
V(2) W(13) * v1;
V(3) W(36) * v2;
W(47) = W(16) * W(56);
W(80) = 0.5 * v3;
W(81) = W(80) + W(47);
V(7) W(11) * v3;
V(8) W(11) * W(47);
V(9) 0.5 * v7;
W(82) = v9 + v8;
V(11) W(11) * W(34);
W(83) = v11 * W(44);
V(13) W(33) * W(83);
V(14) W(13) * v13;
W(84) = W(36) * v14;
W(85) = W(16) * W(83);
V(17) 0.5 * W(84);
W(86) = v17 + W(85);
W(87) = W(11) * W(84);
W(88) = W(11) * W(85);
} }

APART void stretch13(lanes *restrict w)
{ LANE_LOOP {
W(89) = W(8) * W(1);
} }

#if BY_PARAMETERS
APART void stretch14(lanes *restrict w)
{ LANE_LOOP {
W(90) = W(35) * W(34);
V(1) W(38) * W(37);
W(91) = -v1;
} }
#endif

APART void stretch15(lanes *restrict w)
{ LANE_LOOP {
W(35) = 0.5 * W(41);
} }

APART void stretch16(lanes *restrict w)
{ LANE_LOOP {
W(92) = lane_sin(W(68));
W(93) = W(24) * W(92);
W(94) = W(93) * W(17);
W(95) = W(94) * W(30);
W(96) = (-2.0) * W(95);
W(97) = W(43) + W(96);
W(98) = W(97) * W(37);
} }

APART void stretch17(lanes *restrict w)
{ LANE_LOOP {
V(0) W(58) * W(58);
V(1) v0 + 1.0;
W(43) = 1.0 / v1;
V(3) W(59) * W(59);
V(4) v3 + 1.0;
W(99) = 1.0 / v4;
V(6) W(62) * W(62);
V(7) v6 + 1.0;
W(100) = 1.0 / v7;
V(9) W(66) * W(66);
V(10) v9 + 1.0;
W(101) = 1.0 / v10;
} }

APART void stretch18(lanes *restrict w)
{ LANE_LOOP {
W(66) = lane_cos(W(68));
} }

APART void stretch19(lanes *restrict w)
{ LANE_LOOP {
V(0) W(1) * W(12);
W(68) = -v0;
} }

APART void stretch20(lanes *restrict w)
{ LANE_LOOP {
W(62) = W(68) + W(75);
} }

APART void stretch21(lanes *restrict w)
{ LANE_LOOP {
V(0) W(28) * W(45);
V(1) W(31) * v0;
V(2) W(22) * v0;
V(3) v2 * W(77);
V(4) W(25) * v3;
V(5) v4 * W(32);
V(6) v1 + v5;
V(7) W(22) * v6;
V(8) v7 * W(78);
W(68) = W(23) * v8;
W(102) = -W(54);
V(11) W(28) * W(10);
V(12) v11 * W(45);
V(13) W(31) * v12;
V(14) W(22) * v12;
V(15) v14 * W(77);
V(16) W(25) * v15;
V(17) v16 * W(32);
V(18) v13 + v17;
V(19) W(22) * v18;
V(20) v19 * W(78);
W(103) = W(23) * v20;
W(104) = -W(12);
V(23) 0.5 * W(87);
W(105) = v23 + W(88);
W(106) = -W(70);
W(107) = -W(79);
} }

APART void stretch22(lanes *restrict w)
{ LANE_LOOP {
V(0) W(51) * W(68);
V(1) W(24) * v0;
V(2) W(17) * v1;
V(3) W(30) * v2;
V(4) 2.0 * v3;
V(5) W(81) + v4;
V(6) v5 * W(37);
W(108) = -v6;
V(8) W(10) * v3;
V(9) (-2.0) * v8;
V(10) W(82) + v9;
W(109) = v10 * W(52);
V(12) W(51) * W(103);
V(13) W(24) * v12;
V(14) W(17) * v13;
V(15) W(30) * v14;
V(16) (-2.0) * v15;
V(17) W(86) + v16;
V(18) v17 * W(37);
W(110) = W(104) + v18;
V(20) W(10) * v15;
V(21) 2.0 * v20;
V(22) W(105) + v21;
V(23) v22 * W(52);
W(111) = -v23;
} }

#if BY_PARAMETERS
APART void stretch23(lanes *restrict w)
{ LANE_LOOP {
W(105) = W(30) * W(37);
W(104) = W(17) * W(105);
W(103) = W(24) * W(104);
W(68) = W(10) * W(52);
W(112) = W(30) * W(68);
W(113) = W(17) * W(112);
W(114) = W(24) * W(113);
V(7) W(16) * W(37);
V(8) W(36) * W(37);
V(9) W(13) * v8;
V(10) W(33) * v9;
V(11) 0.5 * v10;
V(12) v7 + v11;
V(13) v12 * W(44);
V(14) v13 * W(34);
W(115) = W(1) * v14;
V(16) W(42) * W(52);
V(17) W(7) * W(52);
V(18) W(41) * W(52);
V(19) W(16) * W(79);
V(20) W(36) * W(79);
V(21) W(13) * v20;
V(22) W(33) * v21;
V(23) 0.5 * v22;
V(24) v19 + v23;
V(25) v24 * W(44);
V(26) v25 * W(34);
V(27) W(1) * v26;
V(28) -v17;
V(29) -v27;
V(30) v28 + v29;
V(31) v30 + v16;
V(32) 0.5 * v18;
W(116) = v31 + v32;
V(34) W(90) * v13;
V(35) W(40) * W(37);
V(36) W(12) * v35;
W(117) = W(46) * W(45);
V(38) -W(1);
V(39) v38 + v34;
V(40) -v36;
W(118) = v39 + v40;
V(42) W(40) * W(79);
V(43) W(12) * v42;
V(44) W(90) * v25;
V(45) -v44;
W(119) = v45 + v43;
V(47) W(39) * v8;
W(120) = (-0.5) * v47;
V(49) W(39) * v20;
W(121) = 0.5 * v49;
V(51) W(38) * v9;
V(52) W(15) * v51;
W(122) = (-0.5) * v52;
V(54) W(38) * v21;
V(55) W(15) * v54;
W(123) = 0.5 * v55;
V(57) W(14) * v51;
W(124) = (-0.5) * v57;
V(59) W(14) * v54;
W(125) = 0.5 * v59;
W(126) = W(38) * W(79);
W(127) = W(49) * W(32);
} }
#endif

#if BY_PARAMETERS
APART void stretch24(lanes *restrict w)
{ LANE_LOOP {
V(0) W(75) * W(37);
W(79) = -v0;
V(2) W(76) * W(52);
W(49) = -v2;
V(4) W(51) * W(103);
V(5) W(23) * v4;
V(6) v5 * W(78);
V(7) W(25) * v6;
V(8) v7 * W(77);
V(9) W(22) * v8;
V(10) W(22) * v6;
V(11) W(31) * v10;
V(12) (-2.0) * v9;
V(13) (-2.0) * v11;
V(14) v12 + v13;
V(15) v14 * W(45);
V(16) W(28) * v15;
W(41) = W(1) * v16;
V(18) W(51) * W(114);
V(19) W(23) * v18;
V(20) v19 * W(78);
V(21) W(25) * v20;
V(22) v21 * W(77);
V(23) W(22) * v22;
V(24) W(22) * v20;
V(25) W(31) * v24;
V(26) (-2.0) * v23;
V(27) (-2.0) * v25;
V(28) v26 + v27;
V(29) v28 * W(45);
V(30) W(28) * v29;
V(31) W(1) * v30;
V(32) W(74) * W(52);
V(33) (-2.0) * v32;
W(128) = v31 + v33;
V(35) W(117) * v14;
V(36) W(30) * v35;
V(37) -v36;
W(129) = W(118) + v37;
V(39) W(117) * v28;
V(40) W(30) * v39;
V(41) -v40;
W(130) = W(119) + v41;
V(43) W(72) * W(105);
V(44) W(73) * W(37);
V(45) W(12) * v35;
V(46) (-2.0) * v44;
V(47) -v45;
W(131) = v46 + v47;
V(49) W(21) * W(131);
W(132) = W(29) * v15;
V(51) W(19) * W(132);
V(52) (-2.0) * v43;
V(53) v52 + v49;
W(133) = v53 + v51;
V(55) W(72) * W(112);
V(56) W(73) * W(68);
V(57) W(12) * v39;
V(58) (-2.0) * v56;
V(59) -v57;
W(134) = v58 + v59;
V(61) W(21) * W(134);
W(135) = W(29) * v29;
V(63) W(19) * W(135);
V(64) (-2.0) * v55;
V(65) v64 + v61;
W(136) = v65 + v63;
W(137) = W(17) * W(132);
W(138) = W(17) * W(135);
W(139) = W(17) * W(131);
W(140) = W(17) * W(134);
V(71) W(50) * v6;
V(72) W(127) * v10;
V(73) W(46) * v8;
V(74) (-2.0) * v71;
V(75) 2.0 * v72;
V(76) v74 + v75;
V(77) (-2.0) * v73;
W(141) = v76 + v77;
V(79) W(50) * v20;
V(80) W(127) * v24;
V(81) W(46) * v22;
V(82) (-2.0) * v79;
V(83) 2.0 * v80;
V(84) v82 + v83;
V(85) (-2.0) * v81;
W(142) = v84 + v85;
V(87) W(55) * v4;
W(143) = (-2.0) * v87;
V(89) W(55) * v18;
W(144) = (-2.0) * v89;
V(91) W(71) * W(104);
W(145) = (-2.0) * v91;
V(93) W(71) * W(113);
W(146) = (-2.0) * v93;
V(95) W(48) * v6;
V(96) W(46) * v10;
V(97) (-2.0) * v95;
V(98) 2.0 * v96;
W(147) = v97 + v98;
V(100) W(48) * v20;
V(101) W(46) * v24;
V(102) (-2.0) * v100;
V(103) 2.0 * v101;
W(148) = v102 + v103;
} }
#endif

APART void stretch25(lanes *restrict w)
{ LANE_LOOP {
W(127) = lane_atan(W(58));
W(119) = lane_atan(W(59));
V(2) W(89) * W(0);
W(118) = -v2;
W(117) = W(26) * W(8);
} }

APART void stretch26(lanes *restrict w)
{ LANE_LOOP {
W(114) = 2.0 * W(95);
V(1) W(95) * W(10);
V(2) (-2.0) * v1;
W(113) = W(57) + v2;
} }

APART void stretch27(lanes *restrict w)
{ LANE_LOOP {
W(95) = W(43) * W(34);
W(57) = W(99) * W(34);
V(2) W(28) * W(34);
V(3) v2 * W(60);
V(4) W(31) * v3;
V(5) W(22) * v3;
V(6) v5 * W(100);
V(7) W(25) * v6;
V(8) v7 * W(32);
V(9) v4 + v8;
V(10) W(22) * v9;
V(11) v10 * W(101);
W(112) = W(23) * v11;
W(68) = -W(89);
V(14) W(10) * W(34);
W(103) = v14 * W(43);
W(104) = -W(83);
V(17) W(28) * v14;
V(18) v17 * W(60);
V(19) W(31) * v18;
V(20) W(22) * v18;
V(21) v20 * W(100);
V(22) W(25) * v21;
V(23) v22 * W(32);
V(24) v19 + v23;
V(25) W(22) * v24;
V(26) v25 * W(101);
W(105) = W(23) * v26;
W(51) = (-0.5) * W(84);
W(78) = -W(85);
V(30) (-0.5) * W(87);
V(31) -W(88);
W(77) = v30 + v31;
V(33) W(0) * W(8);
W(75) = -v33;
W(74) = -W(11);
} }

APART void stretch28(lanes *restrict w)
{ LANE_LOOP {
V(0) W(66) * W(112);
V(1) W(24) * v0;
V(2) W(17) * v1;
V(3) W(30) * v2;
W(89) = 2.0 * v3;
V(5) W(81) + W(89);
V(6) v5 * W(37);
W(88) = -v6;
W(87) = -v5;
V(9) W(10) * v3;
V(10) (-2.0) * v9;
W(85) = W(82) + v10;
V(12) W(66) * W(105);
V(13) W(24) * v12;
V(14) W(17) * v13;
V(15) W(30) * v14;
W(84) = 2.0 * v15;
V(17) (-2.0) * v15;
W(83) = W(86) + v17;
W(73) = W(83) * W(37);
V(20) W(10) * v15;
V(21) (-2.0) * v20;
W(72) = W(77) + v21;
} }

#if BY_PARAMETERS
APART void stretch29(lanes *restrict w)
{ LANE_LOOP {
V(0) W(0) * W(1);
W(77) = -v0;
V(2) W(1) * W(34);
W(105) = v2 * W(43);
V(4) W(28) * v2;
V(5) v4 * W(60);
V(6) W(31) * v5;
V(7) W(22) * v5;
V(8) v7 * W(100);
V(9) W(25) * v8;
V(10) v9 * W(32);
V(11) v6 + v10;
V(12) W(22) * v11;
V(13) v12 * W(101);
W(112) = W(23) * v13;
V(15) v2 * W(44);
W(86) = -v15;
V(17) W(33) * v15;
V(18) W(13) * v17;
V(19) W(36) * v18;
W(82) = (-0.5) * v19;
V(21) W(16) * v15;
W(81) = -v21;
V(23) 0.5 * v19;
W(71) = v23 + v21;
W(55) = W(71) * W(37);
V(26) W(11) * v19;
V(27) W(11) * v21;
V(28) -W(7);
V(29) (-0.5) * v26;
V(30) v28 + v29;
V(31) -v27;
V(32) v30 + v31;
V(33) v32 + W(35);
W(52) = v33 + W(42);
V(35) W(58) * W(34);
V(36) v35 * W(43);
W(50) = -v36;
V(38) W(90) * W(44);
W(48) = -v38;
V(40) W(59) * W(34);
V(41) v40 * W(99);
W(46) = -v41;
V(43) W(28) * v35;
V(44) v43 * W(60);
V(45) W(31) * v44;
V(46) W(22) * v44;
V(47) v46 * W(100);
V(48) W(25) * v47;
V(49) v48 * W(32);
V(50) v45 + v49;
V(51) W(22) * v50;
V(52) v51 * W(101);
W(45) = W(23) * v52;
V(54) W(40) * W(12);
V(55) W(33) * v38;
V(56) W(13) * v55;
V(57) W(36) * v56;
V(58) (-0.5) * v57;
W(29) = v58 + v54;
V(60) W(16) * v38;
W(149) = -v60;
V(62) -W(29);
W(150) = v60 + v62;
V(64) W(11) * W(29);
V(65) W(11) * v60;
V(66) -v65;
W(151) = v66 + v64;
V(68) W(36) * W(39);
W(152) = 0.5 * v68;
V(70) v68 * W(37);
W(153) = (-0.5) * v70;
W(154) = (-0.5) * v68;
V(73) W(11) * v68;
W(155) = 0.5 * v73;
V(75) W(38) * W(15);
V(76) W(13) * v75;
V(77) W(36) * v76;
W(156) = 0.5 * v77;
V(79) v77 * W(37);
W(157) = (-0.5) * v79;
W(158) = (-0.5) * v77;
V(82) W(11) * v77;
W(159) = 0.5 * v82;
V(84) W(38) * W(14);
V(85) W(13) * v84;
V(86) W(36) * v85;
W(160) = 0.5 * v86;
V(88) v86 * W(37);
W(161) = (-0.5) * v88;
W(162) = (-0.5) * v86;
V(91) W(11) * v86;
W(163) = 0.5 * v91;
W(164) = -W(38);
W(165) = W(11) * W(38);
V(95) W(58) * W(19);
V(96) v95 * W(60);
V(97) W(61) * W(60);
V(98) v97 * W(21);
V(99) -v98;
V(100) v96 + v99;
V(101) W(31) * v100;
V(102) W(22) * v100;
V(103) v102 * W(100);
V(104) W(25) * v103;
V(105) v104 * W(32);
V(106) v101 + v105;
V(107) W(22) * v106;
V(108) v107 * W(101);
W(166) = W(23) * v108;
V(110) W(58) * W(60);
V(111) W(31) * v110;
V(112) W(22) * v110;
V(113) v112 * W(100);
V(114) W(25) * v113;
V(115) v114 * W(32);
V(116) v111 + v115;
V(117) W(22) * v116;
V(118) v117 * W(101);
W(167) = W(23) * v118;
V(120) W(58) * W(17);
V(121) v120 * W(60);
V(122) W(31) * v121;
V(123) W(22) * v121;
V(124) v123 * W(100);
V(125) W(25) * v124;
V(126) v125 * W(32);
V(127) v122 + v126;
V(128) W(22) * v127;
V(129) v128 * W(101);
W(168) = W(23) * v129;
V(131) W(31) * v97;
V(132) W(22) * v97;
V(133) v132 * W(100);
V(134) W(25) * v133;
V(135) v134 * W(32);
V(136) v131 + v135;
V(137) W(22) * v136;
V(138) v137 * W(101);
W(169) = W(23) * v138;
V(140) v97 * W(17);
V(141) W(31) * v140;
V(142) W(22) * v140;
V(143) v142 * W(100);
V(144) W(25) * v143;
V(145) v144 * W(32);
V(146) v141 + v145;
V(147) W(22) * v146;
V(148) v147 * W(101);
W(170) = W(23) * v148;
V(150) W(61) * W(100);
V(151) W(25) * v150;
V(152) v151 * W(32);
V(153) W(64) * W(32);
V(154) -v153;
V(155) v152 + v154;
V(156) W(22) * v155;
V(157) W(65) + v156;
V(158) v157 * W(101);
W(171) = W(23) * v158;
V(160) W(63) * W(32);
V(161) -W(61);
V(162) v161 + v160;
V(163) W(22) * v162;
V(164) v163 * W(101);
W(172) = W(23) * v164;
} }
#endif

#if BY_PARAMETERS
APART void stretch30(lanes *restrict w)
{ LANE_LOOP {
V(0) W(98) * W(37);
W(101) = -v0;
V(2) W(66) * W(112);
V(3) W(24) * v2;
V(4) W(17) * v3;
V(5) W(30) * v4;
W(100) = 2.0 * v5;
V(7) v5 * W(37);
W(99) = (-2.0) * v7;
W(43) = (-2.0) * v5;
V(10) W(10) * v5;
V(11) (-2.0) * v10;
W(90) = W(96) + v11;
V(13) W(66) * W(45);
V(14) W(24) * v13;
V(15) W(17) * v14;
V(16) W(30) * v15;
W(65) = (-2.0) * v16;
V(18) 2.0 * v16;
W(64) = W(150) + v18;
W(63) = W(64) * W(37);
V(21) W(10) * v16;
V(22) 2.0 * v21;
W(61) = W(151) + v22;
V(24) W(66) * W(166);
V(25) W(24) * v24;
V(26) W(17) * v25;
V(27) W(93) + v26;
V(28) W(30) * v27;
V(29) W(94) * W(21);
V(30) v28 + v29;
W(60) = 2.0 * v30;
V(32) v30 * W(37);
W(59) = (-2.0) * v32;
W(58) = (-2.0) * v30;
V(35) W(10) * v30;
W(44) = (-2.0) * v35;
V(37) W(66) * W(167);
V(38) W(24) * v37;
V(39) W(17) * v38;
V(40) W(30) * v39;
W(40) = 2.0 * v40;
V(42) v40 * W(37);
W(39) = (-2.0) * v42;
W(36) = (-2.0) * v40;
V(45) W(10) * v40;
W(34) = (-2.0) * v45;
V(47) W(66) * W(168);
V(48) W(24) * v47;
V(49) W(17) * v48;
V(50) W(30) * v49;
W(33) = 2.0 * v50;
V(52) v50 * W(37);
W(32) = (-2.0) * v52;
W(31) = (-2.0) * v50;
V(55) W(10) * v50;
W(28) = (-2.0) * v55;
V(57) W(66) * W(169);
V(58) W(24) * v57;
V(59) W(17) * v58;
V(60) W(30) * v59;
V(61) -v60;
V(62) W(94) + v61;
W(173) = 2.0 * v62;
V(64) v62 * W(37);
W(174) = (-2.0) * v64;
W(175) = (-2.0) * v62;
V(67) W(10) * v62;
W(176) = (-2.0) * v67;
V(69) W(94) * W(17);
V(70) W(66) * W(170);
V(71) W(24) * v70;
V(72) W(17) * v71;
V(73) W(30) * v72;
V(74) -v73;
V(75) v69 + v74;
W(177) = 2.0 * v75;
V(77) v75 * W(37);
W(178) = (-2.0) * v77;
W(179) = (-2.0) * v75;
V(80) W(10) * v75;
W(180) = (-2.0) * v80;
V(82) W(66) * W(171);
V(83) W(24) * v82;
V(84) W(17) * v83;
V(85) W(30) * v84;
W(181) = 2.0 * v85;
V(87) v85 * W(37);
W(182) = (-2.0) * v87;
W(183) = (-2.0) * v85;
V(90) W(10) * v85;
W(184) = (-2.0) * v90;
V(92) W(66) * W(67);
V(93) W(24) * v92;
V(94) W(17) * v93;
V(95) W(30) * v94;
W(185) = 2.0 * v95;
V(97) v95 * W(37);
W(186) = (-2.0) * v97;
W(187) = (-2.0) * v95;
V(100) W(10) * v95;
W(188) = (-2.0) * v100;
V(102) W(17) * W(92);
V(103) W(30) * v102;
W(189) = 2.0 * v103;
V(105) v103 * W(37);
W(190) = (-2.0) * v105;
W(191) = (-2.0) * v103;
V(108) W(10) * v103;
W(192) = (-2.0) * v108;
V(110) W(66) * W(172);
V(111) W(24) * v110;
V(112) W(17) * v111;
V(113) W(30) * v112;
W(193) = 2.0 * v113;
V(115) v113 * W(37);
W(194) = (-2.0) * v115;
W(195) = (-2.0) * v113;
V(118) W(10) * v113;
W(196) = (-2.0) * v118;
} }
#endif

static void constants(lanes *w)
{
    LANE_LOOP W(27) = 0.0;
    LANE_LOOP W(197) = 1.0;
}

static void evaluate(lanes *w, int asked)
{
    if (asked & 63) stretch0(w);
    if (asked & 45) stretch1(w);
    if (asked & 54) stretch2(w);
    if (asked & 7) stretch3(w);
    if (asked & 7) stretch4(w);
    if (asked & 13) stretch5(w);
    if (asked & 56) stretch6(w);
    if (asked & 56) stretch7(w);
    if (asked & 3) stretch8(w);
    if (asked & 5) stretch9(w);
    if (asked & 6) stretch10(w);
    if (asked & 6) stretch11(w);
    if (asked & 18) stretch12(w);
    if (asked & 24) stretch13(w);
    #if BY_PARAMETERS
    if (asked & 36) stretch14(w);
    #endif
    if (asked & 40) stretch15(w);
    if (asked & 40) stretch16(w);
    if (asked & 48) stretch17(w);
    if (asked & 48) stretch18(w);
    if (asked & 1) stretch19(w);
    if (asked & 1) stretch20(w);
    if (asked & 2) stretch21(w);
    if (asked & 2) stretch22(w);
    #if BY_PARAMETERS
    if (asked & 4) stretch23(w);
    #endif
    #if BY_PARAMETERS
    if (asked & 4) stretch24(w);
    #endif
    if (asked & 8) stretch25(w);
    if (asked & 8) stretch26(w);
    if (asked & 16) stretch27(w);
    if (asked & 16) stretch28(w);
    #if BY_PARAMETERS
    if (asked & 32) stretch29(w);
    #endif
    #if BY_PARAMETERS
    if (asked & 32) stretch30(w);
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
