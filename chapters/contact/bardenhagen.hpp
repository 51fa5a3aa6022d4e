/// Contact of several bodies on the grid (Bardenhagen et al. 2000; review 5.1, lines 14 to 26 of Algorithm 6): every body moves by its own
/// field; where two share a node, velocities of approach are corrected. For USL, USF as printed, and MUSL, in both mappings.
#pragma once
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "chapters/contact/gap.hpp"
#include "lab/contact_log.hpp"
#include "lab/monitor.hpp"

namespace mpm {

/// The part of a velocity difference dv across faces with normal n that contact takes away: all that approaches, and of the rest along the
/// faces as much as Coulomb's law lets it (5.5 to 5.8). Homogeneous, so that it holds for impulses too.
template <int D> struct Correction {
    double pushes = 0;
    Vec<D> rubs = Vec<D>::Zero();
};
template <int D> Correction<D> correction(const Vec<D>& dv, const Vec<D>& n, double mu) {
    const double approach = dv.dot(n);                                        // 21; D of (5.8)
    if (!(approach > 0)) return {};                                           // 23: release
    const Vec<D> along = dv - approach * n;
    const double slip = along.norm();
    if (!(slip > 0)) return {approach, Vec<D>::Zero()};
    return {approach, std::min(mu * approach / slip, 1.0) * along};           // mu' = min(mu, slip/D) (5.7)
}

/// The seam `coupling` (lab/boundary.hpp).
template <int D> class Bardenhagen {
public:
    using Log = ContactLog<D>;
    ContactChoice choice;
    std::vector<RigidWall<D>> walls;
    std::shared_ptr<Log> log;

    explicit Bardenhagen(const ContactChoice& chosen = {}, std::vector<RigidWall<D>> w = {},
                         std::shared_ptr<Log> l = std::make_shared<Log>())
        : choice(chosen), walls(std::move(w)), log(std::move(l)) {}

    /// Bonded bodies have one velocity at all times. Others meet the stress update of USF as they were mapped, as printed.
    template <class Bodies> void start(Bodies& bodies, double t, double) {
        if (choice.law() != ContactChoice::Law::bonded) return;
        shared_.find(bodies, walls, t);
        bond(bodies, t, &Node<Bodies>::mv);
    }
    template <class Bodies> void operator()(Bodies& bodies, double t, double dt) {
        if (choice.law() == ContactChoice::Law::none) return;
        shared_.find(bodies, walls, t);
        if (choice.law() == ContactChoice::Law::bonded) {
            bond(bodies, t, &Node<Bodies>::mv);
            return bond(bodies, t + dt, &Node<Bodies>::mv_new);
        }
        shared_.measure(bodies, walls, choice, t);
        meet(t);
        correct(bodies);
        account(t, dt);
    }
    /// The second mapping of MUSL, whose velocities only strain: the same nodes, normals and gaps.
    template <class Bodies> void again(Bodies& bodies, double t, double dt) {
        if (choice.law() == ContactChoice::Law::bonded) bond(bodies, t + dt, &Node<Bodies>::mv_new);
        else if (choice.law() != ContactChoice::Law::none) correct(bodies);
    }

    double dissipated() const { return log->friction + log->normal; }
    /// Impulse and work of the walls since the last call.
    Supply supply() {
        Supply sum;
        for (int d = 0; d < D; ++d) sum.impulse[static_cast<std::size_t>(d)] = log->wall_impulse[d];
        sum.work = log->wall_work;
        log->wall_impulse = Vec<D>::Zero();
        log->wall_work = 0;
        return sum;
    }

private:
    template <class Bodies> using Node = typename Bodies::value_type::Node;

    /// Two sides of a node; or one, a, and the centre of mass of all.
    struct Meeting {
        Side<D>*a, *b;
        Vec<D> n;                       // from a to b
        Vec<D> J = Vec<D>::Zero();      // impulse that a gives to b
    };

    template <class Bodies> static auto& grid_node(Bodies& bodies, const Side<D>& side, const SharedNode<D>& node) {
        return bodies[static_cast<std::size_t>(side.party)].grid[node.node];
    }
    const RigidWall<D>* wall(const Side<D>& side) const { return shared_.is_wall(side) ? &walls[shared_.wall(side)] : nullptr; }

    /// All bodies on a node get the velocity of their centre of mass (5.3), or that of a wall.
    template <class Bodies, class Field> void bond(Bodies& bodies, double t, Field field) {
        for (const SharedNode<D>& node : shared_.nodes) {
            double m = 0;
            Vec<D> mv = Vec<D>::Zero();
            const Vec<D>* held = nullptr;
            Vec<D> v_wall;
            for (const Side<D>& side : shared_.of(node)) {
                if (const RigidWall<D>* w = wall(side)) v_wall = w->velocity(t), held = &v_wall;
                else m += side.m, mv += grid_node(bodies, side, node).*field;
            }
            const Vec<D> v = held ? v_wall : Vec<D>(mv / m);
            for (const Side<D>& side : shared_.of(node))
                if (!wall(side)) grid_node(bodies, side, node).*field = side.m * v;
        }
    }

    /// Normals and gaps on all shared nodes (19).
    void meet(double t) {
        meetings_.clear(), first_.clear();
        for (const SharedNode<D>& node : shared_.nodes) {
            first_.push_back(meetings_.size());
            for (Side<D>& a : shared_.of(node)) {
                if (wall(a)) continue;
                bool any_closed = false;
                const Vec<D> own = own_normal(a);
                for (Side<D>& b : shared_.of(node)) {
                    if (&a == &b || (choice.collinear() && b.party < a.party)) continue;
                    const Vec<D> n = choice.collinear() ? common_normal(shared_, a, b, wall(b), choice.kind()) : own;
                    const bool touch = n.squaredNorm() > 0 && gap_between(shared_, node, a, b, wall(b), n, choice, t) <= 0;
                    if (!(n.squaredNorm() > 0)) ++log->without_normal;
                    any_closed = any_closed || touch;
                    if (choice.collinear() && touch) meetings_.push_back({&a, &b, n, Vec<D>::Zero()});
                }
                if (!choice.collinear() && any_closed) meetings_.push_back({&a, nullptr, own, Vec<D>::Zero()});
            }
        }
        first_.push_back(meetings_.size());
    }

    template <class Bodies> void correct(Bodies& bodies) {
        for (std::size_t k = 0; k < shared_.nodes.size(); ++k) {
            if (first_[k] == first_[k + 1]) continue;
            const SharedNode<D>& node = shared_.nodes[k];
            for (Side<D>& side : shared_.of(node)) {
                if (wall(side)) continue;
                const auto& at = grid_node(bodies, side, node);
                side.v_start = at.mv / side.m, side.v = at.mv_new / side.m, side.changed = false;
            }
            const std::span<Meeting> here(meetings_.data() + first_[k], first_[k + 1] - first_[k]);
            if (choice.collinear()) in_pairs(here);
            else as_printed(shared_.of(node), here);
            for (const Side<D>& side : shared_.of(node))
                if (side.changed && !wall(side)) grid_node(bodies, side, node).mv_new = side.m * side.v;
        }
    }

    /// Every body by itself against the velocity of the centre of mass, along its own normal (5.2, 5.3, 5.6).
    void as_printed(std::span<const Side<D>> sides, std::span<Meeting> meetings) const {
        double m = 0;
        Vec<D> v_cm = Vec<D>::Zero();                                                            // 14, 15, 20
        for (const Side<D>& side : sides)
            if (!wall(side)) m += side.m, v_cm += side.m * side.v;
        v_cm /= m;
        for (const Side<D>& side : sides)
            if (wall(side)) v_cm = side.v;                                                       // 5.1.5
        for (Meeting& meeting : meetings) {
            Side<D>& side = *meeting.a;
            const auto [pushes, rubs] = correction<D>(side.v - v_cm, meeting.n, choice.friction());
            meeting.J = side.m * (pushes * meeting.n + rubs);
            if (!(pushes > 0)) continue;
            side.v -= meeting.J / side.m;                                                        // 22
            side.changed = true;
        }
    }

    /// Pair after pair, each keeping its momentum, until no pair changes any more: one sweep for two bodies. A pair's impulse is corrected
    /// as a whole, so that what an early sweep pressed too much a later one takes back.
    void in_pairs(std::span<Meeting> meetings) const {
        for (Meeting& meeting : meetings) meeting.J = Vec<D>::Zero();
        const int most = meetings.size() == 1 ? 1 : 1000;
        for (int sweep = 0; sweep < most; ++sweep) {
            double change = 0, all = 0;
            for (auto& [a, b, n, J] : meetings) {
                const double m = 1 / (1 / a->m + 1 / b->m);
                const auto [pushes, rubs] = correction<D>(J + m * (a->v - b->v), n, choice.friction());
                const Vec<D> more = pushes * n + rubs - J;
                if (more.isZero(0)) continue;
                J += more;
                a->v -= more / a->m, b->v += more / b->m;
                a->changed = b->changed = true;
                change += more.norm(), all += J.norm();
            }
            if (!(change > 1e-15 * all)) break;
        }
    }

    /// Impulses act while velocities change from v_start to v: their work is that on the mean of both, as it is for every force.
    void account(double t, double dt) {
        bool touched = false;
        for (const Meeting& meeting : meetings_) {
            const Vec<D>& J = meeting.J;
            const double pushes = J.dot(meeting.n);
            if (!(pushes > 0)) continue;
            touched = true;
            const auto mean = [](const Side<D>& side) { return Vec<D>(0.5 * (side.v_start + side.v)); };
            const Vec<D> slip = meeting.b ? Vec<D>(mean(*meeting.a) - mean(*meeting.b)) : mean(*meeting.a);
            log->normal += pushes * slip.dot(meeting.n);
            log->friction += (J - pushes * meeting.n).dot(slip);
            log->pressed += pushes, log->rubbed += (J - pushes * meeting.n).norm(), log->in_play += J.norm();
            if (!meeting.b) log->made -= J;
            if (const RigidWall<D>* w = meeting.b ? wall(*meeting.b) : nullptr)
                log->wall_impulse -= J, log->wall_work -= J.dot(w->velocity(t));
        }
        log->nodes += static_cast<long>(shared_.nodes.size());
        if (!shared_.nodes.empty()) ++log->steps;
        if (!touched) return;
        if (std::isnan(log->touched)) log->touched = t + dt;
        log->parted = t + dt;
    }

    SharedNodes<D> shared_;
    std::vector<Meeting> meetings_;
    std::vector<std::size_t> first_;  // meeting of each shared node
};

}  // namespace mpm
