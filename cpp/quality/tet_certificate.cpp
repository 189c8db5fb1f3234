// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/tet_certificate.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "quality/tet_measures.hpp"
#include "quality/tet_piece.hpp"

namespace fgmesh {
namespace {

/// A place where the composition is known.
struct Sample {
  Vec3 place = Vec3::Zero();
  Composition value;
};

bool is_defined(const Composition& value) {
  return std::none_of(value.begin(), value.end(), [](double part) { return std::isnan(part); });
}

/// Takes note of two samples that differ by more than those known.
void compare(const Sample& a, const Sample& b, TetCertificate& certificate) {
  const double apart = difference(a.value, b.value);
  if (!(apart > certificate.variation)) return;
  certificate.variation = apart;
  certificate.apart = {a.place, b.place};
}

/// What both ways of bounding have in common: when to stop.
struct Goal {
  double threshold;  // with what is left to rounding
  int most_pieces;

  /// Decides, if the bound that is known of the variation allows it.
  bool is_reached(TetCertificate& certificate) const {
    if (certificate.bound <= threshold)
      certificate.proof = Proof::kProved;
    else if (certificate.variation > threshold)
      certificate.proof = Proof::kBroken;
    else if (certificate.pieces < most_pieces)
      return false;
    return true;
  }
};

/// Of two constituents: the largest less the smallest fraction. The piece that could hold the largest of all
/// is halved, or that which could hold the smallest, whichever promises more.
class RangeBound {
 public:
  RangeBound(const CompositionField& field, TetPiece piece, TetCertificate& certificate)
      : field_(field), certificate_(certificate) {
    for (int i = 0; i < 4; ++i) include({piece.corners[i], piece.values[i]});
    add(std::move(piece));
  }

  void run(const Goal& goal) {
    for (;;) {
      const int top = worst(highest_), bottom = worst(lowest_);
      certificate_.bound = pieces_[top].high[0] - pieces_[bottom].low[0];
      if (goal.is_reached(certificate_)) return;
      const double above = most_.value.empty() ? 1.0 : pieces_[top].high[0] - most_.value[0],
                   below = least_.value.empty() ? 1.0 : least_.value[0] - pieces_[bottom].low[0];
      const int split = above >= below ? top : bottom;
      Halves halves = halved(field_, pieces_[split]);
      alive_[split] = false;
      include({halves.middle, halves.value});
      for (TetPiece& half : halves.piece) add(std::move(half));
    }
  }

  /// As bound of what is proved with one piece, where no list of them is worth its time.
  static double of(const TetPiece& piece) { return piece.high[0] - piece.low[0]; }

 private:
  using Ranking = std::priority_queue<std::pair<double, int>>;

  void add(TetPiece piece) {
    const int index = static_cast<int>(pieces_.size());
    highest_.push({piece.high[0], index});
    lowest_.push({-piece.low[0], index});
    pieces_.push_back(std::move(piece));
    alive_.push_back(true);
    ++certificate_.pieces;
  }

  void include(const Sample& sample) {
    if (!is_defined(sample.value)) return;
    if (most_.value.empty() || sample.value[0] > most_.value[0]) most_ = sample;
    if (least_.value.empty() || sample.value[0] < least_.value[0]) least_ = sample;
    compare(most_, least_, certificate_);
  }

  int worst(Ranking& ranking) {
    while (!alive_[ranking.top().second]) ranking.pop();
    return ranking.top().second;
  }

  const CompositionField& field_;
  TetCertificate& certificate_;
  std::deque<TetPiece> pieces_;  // stay in place as more come
  std::vector<bool> alive_;
  Ranking highest_, lowest_;
  Sample most_, least_;
};

/// Of three constituents or more: the largest difference between a place in one piece and a place in another,
/// over all pairs of pieces. The pair that could differ most is divided.
class PairBound {
 public:
  PairBound(const CompositionField& field, TetPiece piece, TetCertificate& certificate)
      : field_(field), certificate_(certificate) {
    add(std::move(piece));
    consider(0, 0, std::numeric_limits<double>::infinity());
  }

  void run(const Goal& goal) {
    // Pairs cost much less than pieces, but there may be many more of them.
    constexpr int kPairsOfPiece = 8;
    for (;;) {
      certificate_.bound = pairs_.empty() ? certificate_.variation : pairs_.top().bound;
      if (goal.is_reached(certificate_)) return;
      if (considered_ > kPairsOfPiece * goal.most_pieces) return;
      const Pair pair = pairs_.top();
      pairs_.pop();
      if (pair.a == pair.b) {
        const auto [first, second] = halves_of(pair.a);
        consider(first, first, pair.bound);
        consider(first, second, pair.bound);
        consider(second, second, pair.bound);
        continue;
      }
      const bool larger = pieces_[pair.a].longest_edge_squared() >= pieces_[pair.b].longest_edge_squared();
      const auto [first, second] = halves_of(larger ? pair.a : pair.b);
      const int other = larger ? pair.b : pair.a;
      consider(first, other, pair.bound);
      consider(second, other, pair.bound);
    }
  }

  static double of(const TetPiece& a, const TetPiece& b) {
    Parts low, high;  // of the difference, from b to a
    for (std::size_t c = 0; c < a.low.size(); ++c) {
      low.push_back(a.low[c] - b.high[c]);
      high.push_back(a.high[c] - b.low[c]);
    }
    const double by_values = largest_magnitude(low, high);
    if (!a.knows_corners() || !b.knows_corners()) return by_values;
    const CornerSet at_a = farthest_corners(a, low, high);
    for (std::size_t c = 0; c < low.size(); ++c) {
      const double turned = -low[c];
      low[c] = -high[c];
      high[c] = turned;
    }
    const CornerSet at_b = farthest_corners(b, low, high);
    double apart = 0.0;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        if (holds(at_a, i) && holds(at_b, j))
          apart = std::max(apart, squared_difference(a.values[i], b.values[j]));
    return std::min(by_values, std::sqrt(apart) + bend(a, at_a) + bend(b, at_b));
  }

 private:
  struct Pair {
    double bound;
    int a, b;
    bool operator<(const Pair& other) const { return bound < other.bound; }
  };

  /// As Composition, but without asking for memory: pairs are many.
  using Parts = boost::container::small_vector<double, 8>;

  static double largest_magnitude(const Parts& low, const Parts& high) {
    double squares = 0.0, last_low = 0.0, last_high = 0.0;
    for (std::size_t c = 0; c < low.size(); ++c) {
      const double part = std::max(-low[c], high[c]);
      squares += part * part;
      last_low += low[c];
      last_high += high[c];
    }
    const double last = std::max(-last_low, last_high);
    return std::sqrt(squares + last * last);
  }

  /// Corners of the piece among which the difference is largest that lies between `low` and `high` and
  /// changes with the piece's fractions: half the slope of its square is the sum of the difference times the
  /// slopes, that of the last constituent included.
  static CornerSet farthest_corners(const TetPiece& piece, const Parts& low, const Parts& high) {
    double last_low = 0.0, last_high = 0.0;
    for (std::size_t c = 0; c < low.size(); ++c) {
      last_low += low[c];
      last_high += high[c];
    }
    Vec3 down = Vec3::Zero(), up = Vec3::Zero();
    for (std::size_t c = 0; c < low.size(); ++c) {
      const double least = low[c] + last_low, most = high[c] + last_high;
      for (int axis = 0; axis < 3; ++axis) {
        const double from = piece.slope_low[c][axis], to = piece.slope_high[c][axis];
        if (from == 0.0 && to == 0.0) continue;
        const double products[] = {least * from, least * to, most * from, most * to};
        down[axis] += *std::min_element(products, products + 4);
        up[axis] += *std::max_element(products, products + 4);
      }
    }
    return down.allFinite() && up.allFinite() ? highest_corners(piece.corners, down, up) : kAllCorners;
  }

  /// How far the composition can be from its interpolation between the corners.
  static double bend(const TetPiece& piece, CornerSet set) {
    if (is_single(set)) return 0.0;
    double last = 0.0, squares = 0.0;
    for (std::size_t c = 0; c < piece.low.size(); ++c) {
      const double off = nonlinearity(piece.corners, set, piece.slope_low[c], piece.slope_high[c]);
      squares += off * off;
      last += off;
    }
    return std::sqrt(squares + last * last);
  }

  int add(TetPiece piece) {
    for (int i = 0; i < 4; ++i) include({piece.corners[i], piece.values[i]});
    pieces_.push_back(std::move(piece));
    halves_.push_back({-1, -1});
    ++certificate_.pieces;
    return static_cast<int>(pieces_.size()) - 1;
  }

  void include(const Sample& sample) {
    if (!is_defined(sample.value)) return;
    for (const Sample& other : samples_)
      if (other.place == sample.place) return;
    for (const Sample& other : samples_) compare(other, sample, certificate_);
    // Those after the first are seldom the ones that differ most, and to compare all takes their square.
    constexpr std::size_t kMostSamples = 24;
    if (samples_.size() < kMostSamples) samples_.push_back(sample);
  }

  std::pair<int, int> halves_of(int index) {
    if (halves_[index].first < 0) {
      Halves halves = halved(field_, pieces_[index]);
      const int first = add(std::move(halves.piece[0]));
      halves_[index] = {first, add(std::move(halves.piece[1]))};
    }
    return halves_[index];
  }

  /// `bound`: what is known already of the pieces that they are parts of.
  void consider(int a, int b, double bound) {
    ++considered_;
    pairs_.push({std::min(bound, of(pieces_[a], pieces_[b])), a, b});
  }

  const CompositionField& field_;
  TetCertificate& certificate_;
  std::deque<TetPiece> pieces_;              // stay in place as more come
  std::vector<std::pair<int, int>> halves_;  // of each piece; -1 where it is not divided yet
  std::priority_queue<Pair> pairs_;
  std::vector<Sample> samples_;
  int considered_ = 0;
};

}  // namespace

TetCertificate certify_tet(const CompositionField& field, const Corners& tet,
                           const std::array<Composition, 4>& at_corners, double threshold, int most_pieces) {
  TetCertificate certificate;
  const Goal goal{threshold * (1.0 + kCertificateRounding), most_pieces};
  TetPiece whole = whole_piece(field, tet, at_corners);
  const bool two = field.constituents() == 2;
  for (const auto& [i, j] : kEdgeVertices)
    if (is_defined(whole.values[i]) && is_defined(whole.values[j]))
      compare({tet[i], whole.values[i]}, {tet[j], whole.values[j]}, certificate);
  certificate.bound = two ? RangeBound::of(whole) : PairBound::of(whole, whole);
  certificate.pieces = 1;
  if (goal.is_reached(certificate)) return certificate;
  certificate.pieces = 0;
  if (two)
    RangeBound(field, std::move(whole), certificate).run(goal);
  else
    PairBound(field, std::move(whole), certificate).run(goal);
  return certificate;
}

}  // namespace fgmesh
