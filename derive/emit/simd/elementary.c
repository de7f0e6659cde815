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
    const int64_t mid = -(int64_t)(z > @TAN_PI_8@), big = -(int64_t)(z > @COT_PI_8@);
    *offset = only(mid, 0.7853981633974483) + only(big, 0.7853981633974483);
    return (only(~big, z) - only(mid, 1.0)) / (only(~big, 1.0) + only(mid, z));
}

/* atan: |x| to t in [-tan(pi/8), tan(pi/8)] by t = z, (z - 1) / (z + 1) or -1 / z, then
 * t + t s P(s) with s = t t. */
INLINE double lane_atan(double x)
{
    double offset;
    const double t = fold(fabs(x), &offset), s = t * t, s2 = s * s;
    const double p = @ATAN@;
    return copysign(offset + (t + t * s * p), x);
}

/* (-1)^k sin(x - n pi), n = k + shift, k = round(x / pi - shift): sine with shift 0, cosine 1/2.
 * Three-part Cody-Waite reduction, good to |x| = 1.6e6; beyond that NaN, not wrong
 * digits. */
INLINE double lane_wave(double x, double shift)
{
    const double magic = 6755399441055744.0;    /* 1.5 * 2^52: adding it rounds to a whole number */
    const double rounded = x * 0.3183098861837907 - shift + magic, n = rounded - magic + shift;
    const double r0 = ((x - n * @PI_HIGH@) - n * @PI_MIDDLE@) - n * @PI_LOW@;
    const double r = from_bits(bits(r0) | -(int64_t)!(fabs(x) < 1.6e6));
    const double s = r * r, s2 = s * s;
    const double p = @SIN@;
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
    return (x - whole * @LN2_HIGH@) - whole * @LN2_LOW@;
}

/* exp(s) - 1 for |s| <= log(2) / 2 */
INLINE double small_expm1(double s)
{
    const double s2 = s * s, p = @EXP@;
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
    const double p = @LOG@;
    return n * @LN2_HIGH@ - ((half - (t * (half + s * p) + (n * @LN2_LOW@ + more))) - f);
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
