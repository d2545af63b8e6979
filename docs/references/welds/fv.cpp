// Reference welds by finite volumes: axisymmetric (r, z) spots and three-dimensional half seams. See README.md.
//
// Shares no code and no particle idea with the program that it judges: graded tensor mesh, cell enthalpies, fluxes of the
// conductivity integral through cell faces, RKL2 steps with a fixed step limit. Build:
//   g++ -O3 -march=native -std=c++17 -o fv fv.cpp
// Run: ./fv key=value ... ; prints one line of key=value results (SI units).
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>
using std::string;
using std::vector;

static std::map<string, string> args;
static double num(const string& key, double otherwise) {
    auto found = args.find(key);
    return found == args.end() ? otherwise : atof(found->second.c_str());
}
static string text(const string& key, const string& otherwise) {
    auto found = args.find(key);
    return found == args.end() ? otherwise : found->second;
}

// A table "x:y,x:y": linear between its points, constant beyond.
struct Table {
    vector<double> x, y;
    explicit Table(const string& from) {
        const char* at = from.c_str();
        while (*at) {
            char* end;
            x.push_back(strtod(at, &end));
            y.push_back(strtod(end + 1, &end));
            at = *end ? end + 1 : end;
        }
    }
    double at(double p) const {
        if (p <= x.front()) return y.front();
        if (p >= x.back()) return y.back();
        size_t k = std::upper_bound(x.begin(), x.end(), p) - x.begin();
        return y[k - 1] + (y[k] - y[k - 1]) * (p - x[k - 1]) / (x[k] - x[k - 1]);
    }
};

// Enthalpy h(T) and conductivity integral theta(T) on a fine temperature grid, and theta(h) by look-up in each phase.
struct Material {
    double rho, ts, tl, hs, hl, hmax, largest_slope = 0;
    vector<double> T, h, theta;
    int n[3] = {4000, 4000, 40000};
    vector<float> dummy;
    vector<double> value[3], rise[3];
    double low[3], per[3];
    Material() {
        rho = num("rho", 2500), ts = num("ts", 847), tl = num("tl", 905);
        double hf = num("hf", 3.97e5);
        Table cs(text("cs", "0:1050")), cl(text("cl", "0:1180")), ks(text("ks", "0:200")), kl(text("kl", "0:95"));
        double top = num("tmax", 12000);
        vector<double> grid;
        for (double t = 0; t < top; t += 0.5) grid.push_back(t);
        for (int k = 0; k <= 64; ++k) grid.push_back(ts + (tl - ts) * k / 64);
        for (const Table* t : {&cs, &cl, &ks, &kl}) grid.insert(grid.end(), t->x.begin(), t->x.end());
        std::sort(grid.begin(), grid.end());
        grid.erase(std::unique(grid.begin(), grid.end()), grid.end());
        double cm = 0.5 * (cs.at(ts) + cl.at(tl)) + hf / (tl - ts);
        auto c = [&](double t) { return t < ts ? cs.at(t) : t < tl ? cm : cl.at(t); };
        auto k = [&](double t) {
            if (t < ts) return ks.at(t);
            if (t > tl) return kl.at(t);
            return ks.at(ts) + (kl.at(tl) - ks.at(ts)) * (t - ts) / (tl - ts);
        };
        T = grid;
        h.assign(T.size(), 0), theta = h;
        for (size_t i = 1; i < T.size(); ++i) {
            double dt = T[i] - T[i - 1], mid = 0.5 * (T[i] + T[i - 1]);
            h[i] = h[i - 1] + c(mid) * dt, theta[i] = theta[i - 1] + k(mid) * dt;
            if (mid < num("tslope", 5000)) largest_slope = std::max(largest_slope, k(mid) / c(mid));
        }
        hs = interp(T, h, ts), hl = interp(T, h, tl), hmax = h.back();
        double ends[4] = {0, hs, hl, hmax};
        for (int p = 0; p < 3; ++p) {
            low[p] = ends[p], per[p] = n[p] / (ends[p + 1] - ends[p]);
            vector<double> v(n[p] + 1);
            for (int i = 0; i <= n[p]; ++i) v[i] = interp(h, theta, ends[p] + i / per[p]);
            value[p] = v, rise[p].assign(n[p] + 1, 0);
            for (int i = 0; i < n[p]; ++i) rise[p][i] = v[i + 1] - v[i];
        }
    }
    static double interp(const vector<double>& x, const vector<double>& y, double p) {
        size_t k = std::upper_bound(x.begin(), x.end(), p) - x.begin();
        k = std::min(std::max<size_t>(k, 1), x.size() - 1);
        return y[k - 1] + (y[k] - y[k - 1]) * (p - x[k - 1]) / (x[k] - x[k - 1]);
    }
    inline double potential(double e) const {
        int p = (e >= hs) + (e >= hl);
        double at = (e - low[p]) * per[p];
        int i = std::min(std::max((int)at, 0), n[p] - 1);
        return value[p][i] + (at - i) * rise[p][i];
    }
    double temperature(double th) const { return interp(theta, T, th); }
    double enthalpy(double t) const { return interp(T, h, t); }
    double potential_at(double t) const { return interp(T, theta, t); }
};

// Edges of one axis: `fine` over [from, to], growing by `growth` beyond, ending at `low` and `high`.
static vector<double> edges(double low, double from, double to, double high, double fine, double growth, double most) {
    int count = std::max(2, (int)std::lround((to - from) / fine));
    vector<double> middle;
    for (int i = 0; i <= count; ++i) middle.push_back(from + (to - from) * i / count);
    auto tail = [&](double length) {
        vector<double> sizes;
        double sum = 0, size = (to - from) / count;
        while (sum < length * (1 - 1e-9)) size = std::min(size * growth, most), sizes.push_back(size), sum += size;
        for (double& s : sizes) s *= length / sum;
        return sizes;
    };
    vector<double> all;
    if (from > low + 1e-12) {
        auto sizes = tail(from - low);
        double at = from;
        vector<double> back;
        for (double s : sizes) back.push_back(at -= s);
        all.assign(back.rbegin(), back.rend());
        all.front() = low;
    }
    all.insert(all.end(), middle.begin(), middle.end());
    if (to < high - 1e-12) {
        double at = to;
        for (double s : tail(high - to)) all.push_back(at += s);
        all.back() = high;
    }
    return all;
}

struct Axis {
    int n;
    vector<double> edge, centre, size, up, down, measure;  // up/down: coefficient of the difference to the next/previous
    Axis(const vector<double>& e, bool radial) : n(e.size() - 1), edge(e) {
        centre.resize(n), size.resize(n), up.assign(n, 0), down.assign(n, 0), measure.resize(n);
        for (int i = 0; i < n; ++i) {
            centre[i] = 0.5 * (e[i] + e[i + 1]), size[i] = e[i + 1] - e[i];
            measure[i] = radial ? M_PI * (e[i + 1] * e[i + 1] - e[i] * e[i]) : size[i];
        }
        for (int i = 0; i + 1 < n; ++i) {
            double area = radial ? 2 * M_PI * e[i + 1] : 1;
            double g = area / (centre[i + 1] - centre[i]);
            up[i] = g / measure[i], down[i + 1] = g / measure[i + 1];
        }
    }
};

// The cubic through the four nodes next to where f falls through `level` between nodes i and i + 1.
static double crossing(const vector<double>& x, const vector<double>& f, int i, double level) {
    int first = std::max(0, std::min(i - 1, (int)x.size() - 4)), last = std::min((int)x.size(), first + 4);
    auto at = [&](double p) {
        double sum = 0;
        for (int a = first; a < last; ++a) {
            double term = f[a];
            for (int b = first; b < last; ++b) if (b != a) term *= (p - x[b]) / (x[a] - x[b]);
            sum += term;
        }
        return sum;
    };
    double in = x[i], out = x[i + 1];
    for (int k = 0; k < 50; ++k) { double mid = 0.5 * (in + out); (at(mid) > level ? in : out) = mid; }
    return 0.5 * (in + out);
}
// Where f last lies above `level`; `end` if it does at the last node, zero if nowhere.
static double last_crossing(const vector<double>& x, const vector<double>& f, double level, double end) {
    for (int i = (int)x.size() - 1; i >= 0; --i)
        if (f[i] > level) return i + 1 == (int)x.size() ? end : crossing(x, f, i, level);
    return 0;
}
static double peak_of(const vector<double>& x, const vector<double>& f) {
    int at = std::max_element(f.begin(), f.end()) - f.begin();
    if (at == 0 || at + 1 == (int)f.size() || f[at - 1] == 0 || f[at + 1] == 0) return f[at];
    double a = x[at] - x[at - 1], b = x[at + 1] - x[at], l = (f[at - 1] - f[at]) / -a, r = (f[at + 1] - f[at]) / b;
    double bend = (r - l) / (a + b), slope = (l * b + r * a) / (a + b);
    return bend < 0 ? f[at] - slope * slope / (4 * bend) : f[at];
}

int main(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
        string a = argv[i];
        size_t eq = a.find('=');
        args[a.substr(0, eq)] = a.substr(eq + 1);
    }
    const bool radial = text("kind", "spot") == "spot";
    Material m;
    const double fine = num("d", 25e-6), growth = num("growth", 1.05), most = num("most", 1);
    const double depth = num("thickness", 3e-3), zf = num("zf", 0.8e-3);
    Axis X(radial ? edges(0, 0, num("rf", 1e-3), num("radius", 6e-3), fine, growth, most)
                  : edges(num("x0", 0), num("xf0", 2e-3), num("xf1", 9e-3), num("x1", 12e-3), fine * num("dxratio", 1), growth, most), radial);
    Axis Y(radial ? vector<double>{0, 1} : edges(0, 0, num("yf", 1e-3), num("y1", 5e-3), fine, growth, most), false);
    Axis Z(edges(0, 0, std::min(zf, depth), depth, fine, growth, most), false);
    const int nx = X.n, ny = Y.n, nz = Z.n;
    const size_t N = (size_t)nx * ny * nz, top = (size_t)nx * ny;

    // The beam: absorbed power over time as a table; its place.
    Table power(text("power", "0:500,0.015:500"));
    const bool hat = text("beam", "gauss") == "hat";
    const double rs = num("rs", 0.6e-3 / std::sqrt(2.0)), speed = num("speed", 0), from = num("from", 4e-3);
    const double on = power.x.back();
    auto mean_power = [&](double a, double b) {
        double sum = 0;
        for (size_t i = 0; i + 1 < power.x.size(); ++i) {
            double lo = std::max(a, power.x[i]), hi = std::min(b, power.x[i + 1]);
            if (hi > lo) {
                auto at = [&](double t) { return power.y[i] + (power.y[i + 1] - power.y[i]) * (t - power.x[i]) / (power.x[i + 1] - power.x[i]); };
                sum += 0.5 * (at(lo) + at(hi)) * (hi - lo);
            }
        }
        return sum / (b - a);
    };
    vector<double> shape(nx), across(ny, 1);
    auto gauss = [&](double a, double b) { return 0.5 * (std::erf(b / rs) - std::erf(a / rs)); };
    if (radial)
        for (int i = 0; i < nx; ++i) {
            auto inside = [&](double r) { return hat ? std::min(1.0, r * r / (rs * rs)) : -std::expm1(-r * r / (rs * rs)); };
            shape[i] = (inside(X.edge[i + 1]) - inside(X.edge[i])) / X.measure[i];
        }
    else
        for (int j = 0; j < ny; ++j) across[j] = gauss(Y.edge[j], Y.edge[j + 1]) / Y.size[j];
    auto place = [&](double a, double b) {  // mean density along x over a span of time
        if (radial) return;
        const int points = 16;
        std::fill(shape.begin(), shape.end(), 0);
        for (int q = 0; q < points; ++q) {
            double c = from + speed * (a + (b - a) * (q + 0.5) / points);
            double before = std::erf((X.edge[0] - c) / rs);
            for (int i = 0; i < nx; ++i) {
                double next = std::erf((X.edge[i + 1] - c) / rs);
                shape[i] += 0.5 * (next - before) / X.size[i] / points;
                before = next;
            }
        }
    };

    const double conv = num("conv", 0), emis = num("emis", 0) * 5.670374419e-8, amb = num("ambient", 293);
    const bool losses = conv > 0 || emis > 0, below = num("bottomloss", 0) > 0;
    auto loss = [&](double t) { return conv * (t - amb) + emis * (std::pow(t, 4) - std::pow(amb, 4)); };
    // Flux that leaves a face whose first cell has potential `th` and size `dz`, with q entering from the laser.
    auto face_loss = [&](double th, double dz, double q) {
        double lost = 0;
        for (int k = 0; k < 4; ++k) lost = loss(m.temperature(th + (q - lost) * 0.5 * dz));
        return lost;
    };

    double biggest = 0;
    for (int i = 0; i < nx; ++i)
        for (int j = 0; j < ny; ++j)
            for (int k = 0; k < nz; ++k)
                biggest = std::max(biggest, X.up[i] + X.down[i] + Y.up[j] + Y.down[j] + Z.up[k] + Z.down[k]);
    const double euler = 1 / (biggest / m.rho * m.largest_slope);  // 2/lambda with lambda <= 2 biggest a
    const double longest = radial ? on / num("steps", 300) : num("courant", 0.02) * rs / speed;

    const double start = num("start", 293);
    vector<double> h(N, m.enthalpy(start)), th(N), u(N, 0), before(N, 0), rate0(N), lasers(top, 0), drain(top, 0), drainb(top, 0), next(N);
    const double inv = 1 / m.rho;
    auto potentials = [&]() { for (size_t c = 0; c < N; ++c) th[c] = m.potential(h[c] + u[c]); };
    auto find_losses = [&]() {
        if (!losses) return;
        for (size_t c = 0; c < top; ++c) {
            drain[c] = face_loss(th[c], Z.size[0], lasers[c]);
            if (below) drainb[c] = face_loss(th[c + top * (nz - 1)], Z.size[nz - 1], 0);
        }
    };
    auto sweep = [&](vector<double>& out, double a, double b, double cnow, double c0, bool first) {
        // out = a u + b out + cnow L + c0 rate0 (or L itself into out when `first`)
        for (int k = 0; k < nz; ++k)
            for (int j = 0; j < ny; ++j) {
                size_t row = ((size_t)k * ny + j) * nx;
                const double *t = &th[row], *yu = j + 1 < ny ? t + nx : t, *yd = j ? t - nx : t;
                const double *zu = k + 1 < nz ? t + top : t, *zd = k ? t - top : t;
                double gyu = Y.up[j], gyd = Y.down[j], gzu = Z.up[k], gzd = Z.down[k];
                double faceT = k == 0 ? 1 / Z.size[0] : 0, faceB = k == nz - 1 && below ? 1 / Z.size[k] : 0;
                size_t col = (size_t)j * nx;
                for (int i = 0; i < nx; ++i) {
                    double l = gyu * (yu[i] - t[i]) + gyd * (yd[i] - t[i]) + gzu * (zu[i] - t[i]) + gzd * (zd[i] - t[i]);
                    if (i + 1 < nx) l += X.up[i] * (t[i + 1] - t[i]);
                    if (i) l += X.down[i] * (t[i - 1] - t[i]);
                    l += faceT * (lasers[col + i] - drain[col + i]) - faceB * drainb[col + i];
                    l *= inv;
                    size_t c = row + i;
                    out[c] = first ? l : a * u[c] + b * out[c] + cnow * l + c0 * rate0[c];
                }
            }
    };
    auto bj = [](int j) { return j < 2 ? 1.0 / 3 : (j * j + j - 2.0) / (2.0 * j * (j + 1)); };

    const double liq = m.potential_at(m.tl), sol = m.potential_at(m.ts);
    double W[2] = {0, 0}, D[2] = {0, 0}, L[2] = {0, 0}, peak = start, frozen = 0, hottest = start, tW = 0, tD = 0, bottom = 0;
    double time = 0, absorbed = 0, over = -1;
    long sweeps = 0, steps = 0;
    const double end = num("end", 1.0);
    vector<double> surface(top), plane;
    while (time < end) {
        // The next step: not past a kink of the power; short just after one.
        double stop = end;
        for (double t : power.x) if (t > time + 1e-12) stop = std::min(stop, t);
        double since = time;
        for (double t : power.x) if (t <= time + 1e-12) since = std::min(since, time - t);
        double dt = std::min(std::min(time < on - 1e-12 ? longest : std::min(longest, on / num("offsteps", 2000)), std::max(4 * euler, num("ramp", 0.05) * since)), stop - time);
        if (!radial && time < on && dt < stop - time && 2 * dt > stop - time) dt = 0.5 * (stop - time);
        int s = 3;
        while ((s * s + s - 2.0) / 4 * euler * 0.98 < dt) s += 2;
        place(time, time + dt);
        double p = mean_power(time, time + dt);
        for (int j = 0; j < ny; ++j) for (int i = 0; i < nx; ++i) lasers[(size_t)j * nx + i] = p * shape[i] * across[j];
        for (int j = 0; j < ny; ++j) for (int i = 0; i < nx; ++i) absorbed += lasers[(size_t)j * nx + i] * X.measure[i] * Y.measure[j] * dt;
        std::fill(u.begin(), u.end(), 0), std::fill(before.begin(), before.end(), 0);
        potentials(), find_losses(), sweep(rate0, 0, 0, 0, 0, true);
        double w1 = 4 / (s * s + s - 2.0);
        for (size_t c = 0; c < N; ++c) u[c] = bj(1) * w1 * dt * rate0[c];
        for (int j = 2; j <= s; ++j) {
            potentials(), find_losses();
            double mu = (2 * j - 1.0) / j * bj(j) / bj(j - 1), nu = -(j - 1.0) / j * bj(j) / bj(j - 2), mt = mu * w1;
            sweep(before, mu, nu, mt * dt, -(1 - bj(j - 1)) * mt * dt, false);
            std::swap(before, u);
        }
        sweeps += s, ++steps;
        for (size_t c = 0; c < N; ++c) h[c] += u[c], u[c] = 0;
        time += dt;
        potentials();
        // Measure: the laser as it is at the end of the step.
        place(time - 1e-6 * dt, time);
        p = mean_power(time - 1e-6 * dt, time);
        double dz = Z.size[0];
        for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i) {
                size_t c = (size_t)j * nx + i;
                double q = p * shape[i] * across[j];
                if (losses) q -= face_loss(th[c], dz, q);
                // theta = s - q z + C z^2 through the two top cells, whose means lie C dz^2/12 above the centres' values
                double a = th[c] + q * 0.5 * dz, b = th[c + top] + q * 1.5 * dz, C = (b - a) / (2 * dz * dz);
                surface[c] = a - C * (0.25 + 1.0 / 12) * dz * dz;
            }
        // Column below the symmetry line: values at r = 0 or y = 0.
        auto on_axis = [&](double first, double second, const Axis& A) {
            double a = A.centre[0] * A.centre[0], b = A.centre[1] * A.centre[1];
            return first - (second - first) * a / (b - a);
        };
        vector<double> zs(nz + 1, 0), col(nz + 1);
        for (int k = 0; k < nz; ++k) zs[k + 1] = Z.centre[k];
        double now_over = -1e30, Wn[2] = {0, 0}, Dn[2] = {0, 0}, Ln[2] = {0, 0};
        double levels[2] = {liq, sol};
        if (radial) {
            vector<double> xs(nx + 1, 0), row(nx + 1);
            for (int i = 0; i < nx; ++i) xs[i + 1] = X.centre[i], row[i + 1] = surface[i];
            row[0] = on_axis(surface[0], surface[1], X);
            col[0] = row[0];
            for (int k = 0; k < nz; ++k) col[k + 1] = on_axis(th[(size_t)k * nx], th[(size_t)k * nx + 1], X);
            for (int l = 0; l < 2; ++l) Wn[l] = 2 * last_crossing(xs, row, levels[l], X.edge[nx]), Dn[l] = last_crossing(zs, col, levels[l], depth);
            double bt = m.temperature(col[nz]);
            bottom = std::max(bottom, bt);
            peak = std::max(peak, m.temperature(row[0]));
        } else {
            vector<double> ws[2], ds[2], ys(ny + 1, 0), row(ny + 1), line(nx);
            for (int j = 0; j < ny; ++j) ys[j + 1] = Y.centre[j];
            for (int i = 0; i < nx; ++i) {
                for (int j = 0; j < ny; ++j) row[j + 1] = surface[(size_t)j * nx + i];
                row[0] = on_axis(row[1], row[2], Y), line[i] = row[0], col[0] = row[0];
                for (int l = 0; l < 2; ++l) {
                    if (row[0] < levels[l]) { ws[l].push_back(0), ds[l].push_back(0); continue; }
                    for (int k = 0; k < nz; ++k) col[k + 1] = on_axis(th[k * top + i], th[k * top + nx + i], Y);
                    ws[l].push_back(2 * last_crossing(ys, row, levels[l], Y.edge[ny])), ds[l].push_back(last_crossing(zs, col, levels[l], depth));
                }
            }
            vector<double> back(line.rbegin(), line.rend()), xb;
            for (int i = nx - 1; i >= 0; --i) xb.push_back(-X.centre[i]);
            for (int l = 0; l < 2; ++l) {
                Wn[l] = peak_of(X.centre, ws[l]), Dn[l] = peak_of(X.centre, ds[l]);
                if (*std::max_element(line.begin(), line.end()) > levels[l])
                    Ln[l] = last_crossing(X.centre, line, levels[l], X.edge[nx]) + last_crossing(xb, back, levels[l], -X.edge[0]);
            }
            peak = std::max(peak, m.temperature(peak_of(X.centre, line)));
        }
        for (int l = 0; l < 2; ++l) {
            if (l == 0 && Wn[0] > W[0]) tW = time;
            if (l == 0 && Dn[0] > D[0]) tD = time;
            W[l] = std::max(W[l], Wn[l]), D[l] = std::max(D[l], Dn[l]), L[l] = std::max(L[l], Ln[l]);
        }
        for (size_t c = 0; c < N; ++c) now_over = std::max(now_over, h[c] - m.hs);
        if (over > 0 && now_over <= 0) frozen = time - dt * now_over / (now_over - over);
        over = now_over;
        if (time >= on - 1e-12 && over <= 0) break;
    }
    double stored = 0, h0 = m.enthalpy(start);
    for (int k = 0; k < nz; ++k) for (int j = 0; j < ny; ++j) for (int i = 0; i < nx; ++i)
        stored += m.rho * (h[((size_t)k * ny + j) * nx + i] - h0) * X.measure[i] * Y.measure[j] * Z.measure[k];
    printf("width=%.8e depth=%.8e width_s=%.8e depth_s=%.8e length=%.8e length_s=%.8e peak=%.3f frozen=%.8e bottom=%.2f t_width=%.6e t_depth=%.6e cells=%zu steps=%ld sweeps=%ld energy=%.3e\n",
           W[0], D[0], W[1], D[1], L[0], L[1], peak, frozen, bottom, tW, tD, N, steps, sweeps, losses ? 0 : stored / absorbed - 1);
    (void)hottest;
}
