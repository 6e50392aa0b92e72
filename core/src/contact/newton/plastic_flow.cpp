#include "plastic_flow.hpp"

#include <algorithm>
#include <cmath>

namespace contactd {
namespace {

constexpr double on_bound = 1e-9;    // relative distance from a bound within which elements count as on it
constexpr double near_bound = 1e-3;  // the same for tractions that have returned to it
constexpr double stiff = 1e3;        // hardening over the stiffness of an element
constexpr double from_push = 10;     // push that ends flow over that which ends slip
constexpr double with_close = 1.5;   // times the self-influence: of an element with its close neighbours

}  // namespace

PlasticFlow::PlasticFlow(const FlowLaw& law, const Contact& contact, const std::vector<double>& self)
    : law_(law),
      g_(contact.bound),
      m_(contact.size()),
      self_(self),
      flows_(m_),
      incoming_(m_),
      behind_(m_),
      change_(m_) {
    for (double& value : self_) value *= with_close / law.diagonal();
}

double PlasticFlow::size(const Field& p, std::size_t e) const {
    return std::sqrt(p.x[e] * p.x[e] + p.y[e] * p.y[e]);
}

void PlasticFlow::scale(Field& p, std::size_t e, double length) const {
    const double factor = length / size(p, e);
    p.x[e] *= factor;
    p.y[e] *= factor;
}

// Returns the yield stress that a particle carries on.
double PlasticFlow::behind(std::size_t e, double v, double length, bool slips) const {
    if (flows_[e]) return length;
    return slips && v < g_[e] && law_.hardening > 0 ? g_[e] : v;
}

void PlasticFlow::divide_by_size(Field& p, std::vector<char>& slips) {
    const bool softens = law_.hardening < 0;
    const auto divide = [&](std::size_t e, double v) {
        incoming_[e] = v;
        const double length = size(p, e), g = g_[e];
        const bool yields = v < g, held = length <= (yields ? v : g) * (1 + on_bound);
        if (!(length > 0) || (held && !slips[e] && !flows_[e])) {
            slips[e] = flows_[e] = 0;
        } else if (!yields || (!softens && (slips[e] || length > g * (1 + on_bound)))) {
            slips[e] = 1;
            flows_[e] = 0;
            scale(p, e, g);
        } else {
            slips[e] = 0;
            flows_[e] = 1;
            if (softens && length > v) scale(p, e, v);
        }
        return behind(e, v, size(p, e), slips[e] != 0);
    };
    law_.travel(divide, behind_);
}

void PlasticFlow::divide_by_slip(Field& p, const Field& s, double push, std::vector<char>& slips) {
    // If an element slips along its traction, flow ends, but not before the traction has returned to the yield stress.
    // Hardening that is much stiffer than the bodies is nearly adhesion, and ends at once. In steady rolling, elements
    // that begin to flow from the bound of friction leave it at once, because it would become the yield stress of all
    // elements behind them.
    const double k = law_.hardening / law_.diagonal(), held = from_push * push;
    const auto divide = [&](std::size_t e, double v) {
        incoming_[e] = v;
        const double length = size(p, e), g = g_[e];
        const double flow = length > 0 ? -(s.x[e] * p.x[e] + s.y[e] * p.y[e]) / length : 0;
        const bool is_stiff = law_.hardening * self_[e] > stiff;
        if (flows_[e] && flow < -held && (is_stiff || length <= v * (1 + near_bound))) {
            flows_[e] = 0;
            if (!is_stiff && length > v) scale(p, e, v);
        }
        if (flows_[e] && v >= g) {
            flows_[e] = 0;
            slips[e] = 1;
        } else if (slips[e] && v < g && (k < 0 || v + k * flow < g * (1 - on_bound))) {
            slips[e] = 0;
            flows_[e] = 1;
            if (k > 0 && law_.upstream) scale(p, e, v + k * std::max(flow, 0.0));
        } else if (!slips[e] && v < g && length > v * (1 + on_bound) &&
                   (flow >= -held || (!is_stiff && length > v * (1 + near_bound)))) {
            flows_[e] = 1;
            if (flow < -held && k > 0 && law_.upstream) scale(p, e, v);
        }
        return behind(e, v, size(p, e), slips[e] != 0);
    };
    law_.travel(divide, behind_);
}

std::size_t PlasticFlow::divide_at_start(Field& p, const Field& s, const std::vector<double>& flexibility,
                                         std::vector<char>& slips) {
    std::size_t moved = 0;
    const double k = law_.hardening / law_.diagonal();
    const auto divide = [&](std::size_t e, double v) {
        incoming_[e] = v;
        slips[e] = flows_[e] = 0;
        const double stiffness = 1 / flexibility[e], g = g_[e];
        const double x = p.x[e] - s.x[e] * stiffness, y = p.y[e] - s.y[e] * stiffness;
        const double length = std::sqrt(x * x + y * y), held = std::min(v, g);
        if (!(length > held * (1 - on_bound))) return v;
        double bound = g;
        if (v < g) {
            const double flow = std::max(length - v, 0.0) / std::max(stiffness + k, 0.2 * stiffness);
            bound = std::clamp(v + k * flow, std::min(law_.least, v), g);
        }
        flows_[e] = bound < g;
        slips[e] = !flows_[e];
        if (x * p.x[e] + y * p.y[e] <= 0) {
            p.x[e] = x;
            p.y[e] = y;
            ++moved;
        } else {
            moved += size(p, e) < bound * (1 - on_bound);
        }
        scale(p, e, bound);
        return behind(e, v, bound, slips[e] != 0);
    };
    law_.travel(divide, behind_);
    return moved;
}

double PlasticFlow::linearise(const Field& p, const Field& s, Linearisation& law, Field& r) {
    Linearisation::Flow& flow = *law.flow;
    const double diagonal = law_.diagonal();
    double back = 0;
    for (std::size_t e = 0; e < m_; ++e) {
        flow.direction.x[e] = flow.direction.y[e] = 0;
        if (!flows_[e]) continue;
        const double length = size(p, e), x = p.x[e] / length, y = p.y[e] / length;
        const double against = -(s.x[e] * x + s.y[e] * y), free = std::max(against, 0.0);
        const double hardened = incoming_[e] + law_.hardening / diagonal * free;
        const bool is_least = hardened < law_.least;
        back += (free - against) * (free - against);
        flow.direction.x[e] = x;
        flow.direction.y[e] = y;
        flow.slope[e] = is_least ? 0 : law_.hardening;
        flow.follows[e] = !is_least;
        flow.unit[e] = self_[e] / (1 + self_[e] * std::abs(law_.hardening));
        law.tangent_stiffness[e] = free / length;
        const double along = -flow.unit[e] * diagonal * (length - std::max(hardened, law_.least));
        r.x[e] = -s.x[e] - against * x + along * x;
        r.y[e] = -s.y[e] - against * y + along * y;
    }
    return back;
}

void PlasticFlow::correct_image(const Linearisation& law, const Vectors& step, const Vectors& response,
                                const MutableVectors& image) const {
    const Linearisation::Flow& flow = *law.flow;
    const double diagonal = law_.diagonal();
    const auto correct = [&](std::size_t e, double v) {
        if (!flows_[e]) return law.slips[e] && incoming_[e] < g_[e] ? 0 : v;
        const double x = flow.direction.x[e], y = flow.direction.y[e];
        const double of_step = step.x[e] * x + step.y[e] * y, of_slip = response.x[e] * x + response.y[e] * y;
        const double along =
            flow.unit[e] * (diagonal * of_step + flow.slope[e] * of_slip - (flow.follows[e] ? diagonal * v : 0.0));
        const double now = image.x[e] * x + image.y[e] * y;
        image.x[e] += (along - now) * x;
        image.y[e] += (along - now) * y;
        return of_step;
    };
    if (law_.upstream)
        law_.upstream->travel(0, correct, change_);
    else
        for (std::size_t e = 0; e < m_; ++e) correct(e, 0);
}

}  // namespace contactd
