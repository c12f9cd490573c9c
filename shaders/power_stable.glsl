// (1 - x)^n for 0 <= x <= 1 and large n, from the small quantity x itself: exp(n log(1 - x)).
// 1 - x rounds to a float near 1 and loses x; the series of log(1 - x) does not (error < 1e-7 for x < 1/8).
float stable_power(float x, float n)
{
    float series = -x * (1.0 + x * (1.0 / 2.0 + x * (1.0 / 3.0 + x * (1.0 / 4.0 + x * (1.0 / 5.0 + x * (1.0 / 6.0 + x / 7.0))))));
    return exp(n * (x < 0.125 ? series : log(max(1.0 - x, 1e-30))));
}

