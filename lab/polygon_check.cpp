// Whether outlines bound a polygon: a sweep over the edges from left to right (Shamos and Hoey 1976) that stops at the first crossing.
#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "lab/options.hpp"
#include "lab/orientation.hpp"
#include "lab/polygon.hpp"
#include "lab/record.hpp"

namespace mpm {
namespace {

/// An edge from its left to its right end; of a vertical one, from its lower to its upper.
struct Side {
    Vec<2> left, right;
    std::size_t outline, number, of;  // the edge from corner `number` of that outline to the next of its `of` corners

    bool follows(const Side& other) const { return outline == other.outline && number == (other.number + 1) % of; }
};

bool before(const Vec<2>& a, const Vec<2>& b) { return std::tie(a[0], a[1]) < std::tie(b[0], b[1]); }

std::string outline_name(std::size_t i) { return i == 0 ? "the outline" : "hole " + std::to_string(i); }
std::string at(const Vec<2>& x) { return "(" + number_text(x[0]) + ", " + number_text(x[1]) + ")"; }

/// Whether a sweep line meets `a` below `b`; both are on it, and they do not cross.
bool under(const Side* a, const Side* b) {
    if (a == b) return false;
    int side = 0;  // of b, seen from a
    if (!before(b->left, a->left)) {
        side = orientation(a->left, a->right, b->left);
        if (side == 0) side = orientation(a->left, a->right, b->right);
    } else {
        side = -orientation(b->left, b->right, a->left);
        if (side == 0) side = -orientation(b->left, b->right, a->right);
    }
    return side != 0 ? side > 0 : std::tie(a->outline, a->number) < std::tie(b->outline, b->number);
}

bool between(const Vec<2>& x, const Side& s) {  // for x on the line of s
    return !before(x, s.left) && !before(s.right, x);
}

/// Whether two edges have a point in common beside the corner that joins them.
bool meet(const Side& a, const Side& b) {
    const int al = orientation(b.left, b.right, a.left), ar = orientation(b.left, b.right, a.right);
    const int bl = orientation(a.left, a.right, b.left), br = orientation(a.left, a.right, b.right);
    if (a.follows(b) || b.follows(a)) {  // they share an end: only on one line, and on one side of that end, they share more
        const bool one_line = al == 0 && ar == 0;
        return one_line && before(std::max(a.left, b.left, before), std::min(a.right, b.right, before));
    }
    if (al * ar < 0 && bl * br < 0) return true;
    return (al == 0 && between(a.left, b)) || (ar == 0 && between(a.right, b)) || (bl == 0 && between(b.left, a)) ||
           (br == 0 && between(b.right, a));
}

[[noreturn]] void refuse(const Side& a, const Side& b, double unit) {
    const auto edge = [&](const Side& s) {
        return "edge " + std::to_string(s.number + 1) + " from " + at(s.left * unit) + " to " + at(s.right * unit);
    };
    const bool same = a.outline == b.outline;
    const Side &first = std::tie(a.outline, a.number) < std::tie(b.outline, b.number) ? a : b, &second = &first == &a ? b : a;
    throw BadInput("polygon: " + outline_name(first.outline) + " crosses or touches " + (same ? "itself" : outline_name(second.outline)) +
                   ": " + edge(first) + ", " + edge(second));
}

/// Throws at the first two edges that meet.
void sweep(const std::vector<Side>& sides, double unit) {
    struct Event {
        const Vec<2>* x;
        bool starts;
        const Side* side;
    };
    std::vector<Event> events;
    for (const Side& side : sides) events.insert(events.end(), {{&side.left, true, &side}, {&side.right, false, &side}});
    std::sort(events.begin(), events.end(), [](const Event& a, const Event& b) {  // at one corner, edges end before others start
        return before(*a.x, *b.x) || (!before(*b.x, *a.x) && a.starts < b.starts);
    });
    std::set<const Side*, decltype(&under)> line(&under);
    std::vector<decltype(line)::iterator> places(sides.size());
    const auto compare = [&](const Side* a, const Side* b) {
        if (meet(*a, *b)) refuse(*a, *b, unit);
    };
    for (const Event& event : events) {
        auto& place = places[static_cast<std::size_t>(event.side - sides.data())];
        if (event.starts) place = line.insert(event.side).first;
        const bool below = place != line.begin(), above = std::next(place) != line.end();
        if (event.starts) {
            if (below) compare(*std::prev(place), event.side);
            if (above) compare(event.side, *std::next(place));
        } else {
            if (below && above) compare(*std::prev(place), *std::next(place));
            line.erase(place);
        }
    }
}

/// Enough corners, of finite numbers.
void check_alone(const Outline& outline, std::size_t number) {
    const std::string name = outline_name(number);
    if (outline.size() < 3)
        throw BadInput("polygon: " + name + " has " + std::to_string(outline.size()) + " corners, at least 3 are needed");
    for (std::size_t i = 0; i < outline.size(); ++i)
        if (!outline[i].allFinite()) throw BadInput("polygon: corner " + std::to_string(i + 1) + " of " + name + " is " + at(outline[i]));
}

/// No corner twice.
void check_corners(const std::vector<Outline>& outlines) {
    std::vector<std::tuple<Vec<2>, std::size_t, std::size_t>> corners;
    for (std::size_t k = 0; k < outlines.size(); ++k)
        for (std::size_t i = 0; i < outlines[k].size(); ++i) corners.emplace_back(outlines[k][i], k, i);
    std::sort(corners.begin(), corners.end(), [](const auto& a, const auto& b) {
        return before(std::get<0>(a), std::get<0>(b)) ||
               (!before(std::get<0>(b), std::get<0>(a)) &&
                std::tie(std::get<1>(a), std::get<2>(a)) < std::tie(std::get<1>(b), std::get<2>(b)));
    });
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const auto& [x, k, n] = corners[i - 1];
        const auto& [y, l, m] = corners[i];
        if (x == y)
            throw BadInput("polygon: corner " + std::to_string(n + 1) + " of " + outline_name(k) + " and corner " + std::to_string(m + 1) +
                           " of " + outline_name(l) + " are the same, " + at(x));
    }
}

/// A power of two near the largest coordinate: with coordinates over it no product overflows, and no digit changes.
double unit_of(const std::vector<Outline>& outlines) {
    double largest = 0;
    for (const Outline& outline : outlines)
        for (const Vec<2>& x : outline) largest = std::max(largest, x.cwiseAbs().maxCoeff());
    return std::ldexp(1.0, std::ilogb(largest));  // > 0, since no corner is there twice
}

/// The edges of an outline in units; throws where they lie on one line.
void add_sides(const Outline& outline, std::size_t k, double unit, std::vector<Side>& sides) {
    bool flat = true;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec<2> a = outline[i] / unit, b = outline[(i + 1) % outline.size()] / unit;
        flat = flat && orientation(outline[0] / unit, outline[1] / unit, b) == 0;
        sides.push_back(before(a, b) ? Side{a, b, k, i, outline.size()} : Side{b, a, k, i, outline.size()});
    }
    if (flat) throw BadInput("polygon: " + outline_name(k) + " encloses no area: its corners lie on one line");
}

}  // namespace

void detail::check_outlines(const std::vector<Outline>& outlines) {
    for (std::size_t k = 0; k < outlines.size(); ++k) check_alone(outlines[k], k);
    check_corners(outlines);
    const double unit = unit_of(outlines);
    std::vector<Side> sides;
    for (std::size_t k = 0; k < outlines.size(); ++k) add_sides(outlines[k], k, unit, sides);
    sweep(sides, unit);
}

}  // namespace mpm
