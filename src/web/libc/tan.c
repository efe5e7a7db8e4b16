/**
 * @file
 * @brief The tangent, correctly rounded, which musl's is not always.
 *
 * The camera asks for it: with a last bit more or less, all rays differ in quad. glibc's, of the
 * desktop, differs from this one seldom, and by the last bit.
 */

/** Largest angle of the series, radians: beyond a quarter turn. */
static const double SERIES_LIMIT = 1.6;
/** Terms of the series: the last one is below half an ulp of quad. */
enum { TERMS = 40 };

/** @return The tangent; that of larger angles is not needed, and is not a number. */
double tan(double x) {
    long double square = (long double)x * x, term = 1, sine = 0, cosine = 0;
    if (!(x <= SERIES_LIMIT && x >= -SERIES_LIMIT)) {
        return __builtin_nan("");
    }
    for (int i = 1; i <= TERMS; i += 2) {
        cosine += term;
        term /= i;
        sine += term;
        term *= -square / (i + 1);
    }
    return (double)(x * sine / cosine);
}
