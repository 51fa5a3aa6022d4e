#include "lab/polygon.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <numbers>
#include <utility>

#include "lab/csv_read.hpp"
#include "lab/options.hpp"
#include "lab/record.hpp"

namespace mpm {

double signed_area(const Outline& outline) {
    double twice = 0;
    for (std::size_t i = 2; i < outline.size(); ++i) {  // triangles at the first corner: no digits are lost far from the origin
        const Vec<2> a = outline[i - 1] - outline[0], b = outline[i] - outline[0];
        twice += a[0] * b[1] - a[1] * b[0];
    }
    return twice / 2;
}

Outline circle(const Vec<2>& centre, double r, int n) {
    Outline corners;
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        corners.push_back(centre + r * Vec<2>(std::cos(angle), std::sin(angle)));
    }
    return corners;
}

Polygon::Polygon(Outline outer, std::vector<Outline> holes) {
    outlines_.push_back(std::move(outer));
    for (Outline& hole : holes) outlines_.push_back(std::move(hole));
    detail::check_outlines(outlines_);
    build();
    check_holes();
}

/// Outlines do not meet: a hole lies where any corner of it does. To the right of its rightmost corner are only edges of others; their
/// number is odd if it lies in the outer outline and in no other hole.
void Polygon::check_holes() const {
    for (std::size_t k = 1; k < outlines_.size(); ++k) {
        const Outline& hole = outlines_[k];
        const auto rightmost = std::max_element(hole.begin(), hole.end(), [](const Vec<2>& a, const Vec<2>& b) { return a[0] < b[0]; });
        if (!inside(*rightmost))
            throw BadInput("polygon: hole " + std::to_string(k) + " does not lie in the outline, or lies in another hole");
    }
}

void Polygon::build() {
    bounds_ = {outer().front(), outer().front()};
    for (const Vec<2>& x : outer()) bounds_ = around(bounds_, {x, x});
    for (const Outline& outline : outlines_)
        for (const Vec<2>& x : outline) levels_.push_back(x[1]);
    std::sort(levels_.begin(), levels_.end());
    levels_.erase(std::unique(levels_.begin(), levels_.end()), levels_.end());

    const std::size_t leaves = std::bit_ceil(levels_.size() - 1);
    tree_.resize(2 * leaves);  // node k has the children 2 k and 2 k + 1
    const auto level = [&](double y) {
        return static_cast<std::size_t>(std::lower_bound(levels_.begin(), levels_.end(), y) - levels_.begin());
    };
    for (const Outline& outline : outlines_)
        for (std::size_t i = 0; i < outline.size(); ++i) {
            Edge edge{outline[i], outline[(i + 1) % outline.size()]};
            if (edge.low[1] > edge.high[1]) std::swap(edge.low, edge.high);
            for (std::size_t l = leaves + level(edge.low[1]), r = leaves + level(edge.high[1]); l < r; l /= 2, r /= 2) {
                if (l % 2 == 1) tree_[l++].push_back(edge);
                if (r % 2 == 1) tree_[--r].push_back(edge);
            }
        }
    for (std::size_t k = 1; k < tree_.size(); ++k) {
        std::size_t leaf = k;
        while (leaf < leaves) leaf *= 2;
        if (tree_[k].size() < 2) continue;
        const double y = (levels_[leaf - leaves] + levels_[leaf - leaves + 1]) / 2;
        std::sort(tree_[k].begin(), tree_[k].end(), [&](const Edge& a, const Edge& b) { return a.x(y) < b.x(y); });
    }
}

bool Polygon::inside(const Vec<2>& x) const {
    const auto above = std::upper_bound(levels_.begin(), levels_.end(), x[1]);
    if (above == levels_.begin() || above == levels_.end()) return false;
    std::ptrdiff_t right = 0;  // edges to the right of x
    for (std::size_t k = tree_.size() / 2 + static_cast<std::size_t>(above - levels_.begin()) - 1; k > 0; k /= 2) {
        const auto& edges = tree_[k];
        right += edges.end() - std::partition_point(edges.begin(), edges.end(), [&](const Edge& e) { return e.x(x[1]) <= x[0]; });
    }
    return right % 2 == 1;
}

double Polygon::area() const {
    double sum = std::abs(signed_area(outer()));
    for (std::size_t i = 1; i < outlines_.size(); ++i) sum -= std::abs(signed_area(outlines_[i]));
    return sum;
}

double Polygon::perimeter() const {
    double sum = 0;
    for (const Outline& outline : outlines_)
        for (std::size_t i = 0; i < outline.size(); ++i) sum += (outline[(i + 1) % outline.size()] - outline[i]).norm();
    return sum;
}

namespace {

/// Reads the numbers of a line with blanks or one comma between; false unless they are exactly two.
bool read_corner(std::string_view line, Vec<2>& x) {
    const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    const auto skip = [&] {
        while (!line.empty() && blank(line.front())) line.remove_prefix(1);
    };
    for (const int d : {0, 1}) {
        skip();
        if (d == 1 && !line.empty() && line.front() == ',') line.remove_prefix(1), skip();
        if (line.size() > 1 && line.front() == '+' && line[1] != '-') line.remove_prefix(1);
        const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), x[d]);
        if (error != std::errc()) return false;
        line.remove_prefix(static_cast<std::size_t>(end - line.data()));
        if (d == 0 && !line.empty() && line.front() != ',' && !blank(line.front())) return false;
    }
    skip();
    return line.empty();
}

}  // namespace

Polygon read_polygon(const std::string& path) {
    const std::string text = read_file(path);
    std::vector<Outline> outlines(1);
    std::size_t number = 0;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        const std::string_view whole(text.data() + from, end - from), line = whole.substr(0, whole.find('#'));
        from = end + 1;
        ++number;
        if (line.find_first_not_of(" \t\r") == std::string_view::npos) {
            if (whole.size() == line.size() && !outlines.back().empty()) outlines.emplace_back();  // not a mere comment
            continue;
        }
        Vec<2>& x = outlines.back().emplace_back();
        if (!read_corner(line, x))
            throw FileTrouble("cannot read '" + one_line(path, 300) + "': line " + std::to_string(number) +
                              " is not x, y: " + one_line(line));
    }
    if (outlines.back().empty() && outlines.size() > 1) outlines.pop_back();
    for (Outline& outline : outlines)
        if (outline.size() > 1 && outline.front() == outline.back()) outline.pop_back();
    Outline outer = std::move(outlines.front());
    outlines.erase(outlines.begin());
    try {
        return Polygon(std::move(outer), std::move(outlines));
    } catch (const BadInput& bad) {
        throw BadInput("'" + one_line(path, 300) + "': " + bad.what());
    }
}

}  // namespace mpm
