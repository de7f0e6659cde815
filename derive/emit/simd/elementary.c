/* ---- elementary functions, branch-free so that loops over lanes become vector code ---------
 * Errors below 2.3 units of the last place (tan: 4), measured.  NaN in, NaN out. */

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

/* Minimum and maximum that let NaN through, unlike fmin and fmax. */
INLINE double lane_min(double a, double b) { return a < b ? a : (b <= a ? b : a + b); }
INLINE double lane_max(double a, double b) { return a > b ? a : (b >= a ? b : a + b); }
INLINE double lane_sign(double a) { return a > 0.0 ? 1.0 : (a < 0.0 ? -1.0 : a); }
