// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/wear/garment_scene.h"
#include "core/wear/joint_groups.h"

#include <algorithm>

namespace hygroloom {
namespace {

constexpr int nothing = -1;

/// An end of a piece, and what it is sewn to.
struct PieceEnd {
    int other = nothing; ///< number of the end it is joined with; ends are 2 x piece for its first segment, and one more for its last
    double yarns = 0, rooms = 0;
};

class Pieces {
public:
    explicit Pieces(const ClothPanels& panels) : panels_(panels), ends_(2 * panels.first.size()) {}

    /// Whether the joint became one of pieces end to end.
    bool join(const SeamJoint& joint)
    {
        const int a = free_end(joint.a), b = free_end(joint.b);
        if (a == nothing || b == nothing || is_warp(a / 2) != is_warp(b / 2)) return false;
        if (a == b) return false;
        end(a) = {b, joint.yarns, joint.rooms};
        end(b) = {a, joint.yarns, joint.rooms};
        return true;
    }
    /// Writes all chains, the warp's first.
    void write(ClothPanels& panels)
    {
        std::vector<bool> done(panels_.first.size());
        for (bool warp : {true, false}) {
            for (int piece = 0; piece < count(); ++piece) {
                if (is_warp(piece) != warp || done[static_cast<std::size_t>(piece)]) continue;
                const int start = first_end(piece);
                int at = start;
                do {
                    done[static_cast<std::size_t>(at / 2)] = true;
                    at = end(add(panels, at)).other;
                } while (at != nothing && at != start);
                panels.chain_ends.push_back(static_cast<int>(panels.order.size()));
            }
            if (warp) panels.warp_chains = static_cast<int>(panels.chain_ends.size());
        }
    }

private:
    int count() const { return static_cast<int>(panels_.first.size()); }
    bool is_warp(int piece) const { return piece < panels_.warp_pieces; }
    PieceEnd& end(int number) { return ends_[static_cast<std::size_t>(number)]; }
    /// The piece that a segment is of, by bisection: pieces are in order.
    int piece_of(int segment) const
    {
        const auto after = std::upper_bound(panels_.first.begin(), panels_.first.end(), segment);
        return static_cast<int>(after - panels_.first.begin()) - 1;
    }
    /// The end of a piece at this segment, unless it is joined.
    int free_end(int segment)
    {
        const int piece = piece_of(segment);
        const auto at = static_cast<std::size_t>(piece);
        if (panels_.first[at] == segment && end(2 * piece).other == nothing) return 2 * piece;
        if (panels_.last[at] - 1 == segment && end(2 * piece + 1).other == nothing) return 2 * piece + 1;
        return nothing;
    }
    /// An end of the piece's chain that is not joined; in a ring, the piece's own first.
    int first_end(int piece)
    {
        int at = 2 * piece;
        do {
            if (end(at).other == nothing) return at;
            at = end(at).other ^ 1;
        } while (at != 2 * piece);
        return at;
    }
    /// Adds a piece from one end on; returns its other end.
    int add(ClothPanels& panels, int from)
    {
        const auto piece = static_cast<std::size_t>(from / 2);
        const int first = panels_.first[piece], last = panels_.last[piece] - 1;
        for (int k = 0; k <= last - first; ++k) {
            panels.order.push_back(from % 2 == 0 ? first + k : last - k);
            panels.joint_yarns.push_back(-1);
            panels.joint_rooms.push_back(-1);
        }
        const int to = from ^ 1;
        if (end(to).other != nothing) {
            panels.joint_yarns.back() = end(to).yarns;
            panels.joint_rooms.back() = end(to).rooms;
        }
        return to;
    }

    const ClothPanels& panels_;
    std::vector<PieceEnd> ends_;
};

} // namespace

void sew(Cloth& cloth, std::vector<SeamJoint> joints)
{
    std::stable_sort(joints.begin(), joints.end(), [](const SeamJoint& a, const SeamJoint& b) { return a.yarns > b.yarns; });
    Pieces pieces(cloth.panels);
    std::vector<SeamJoint> left;
    for (const SeamJoint& joint : joints)
        if (!pieces.join(joint)) left.push_back(joint);
    pieces.write(cloth.panels);
    const auto crossing_of = [&](int segment) {
        const int weft = segment - cloth.crossings();
        return weft < 0 ? segment : weft % cloth.ends * cloth.picks + weft / cloth.ends;
    };
    cloth.seams = grouped<ClothSeams>(cloth.crossings(), std::move(left), [&](const SeamJoint& joint) {
        return std::array<int, 2>{crossing_of(joint.a), crossing_of(joint.b)};
    });
}

} // namespace hygroloom
