#include "core/base/diagnostic.h"

#include <algorithm>
#include <limits>

#include "core/base/index.h"
#include "core/base/stable_order.h"

namespace marey {

bool Diagnostics::count_repeat(DiagnosticCode code, std::string_view merge_key) {
  for (std::size_t i = 0; i < list_.size(); ++i) {
    if (list_[i].code != code || merge_keys_[i] != merge_key) continue;
    if (list_[i].count < std::numeric_limits<int>::max()) ++list_[i].count;
    return true;
  }
  return false;
}

void Diagnostics::add(Diagnostic diagnostic, std::string_view merge_key) {
  if (count_repeat(diagnostic.code, merge_key)) return;
  list_.push_back(std::move(diagnostic));
  merge_keys_.emplace_back(merge_key);
}

void Diagnostics::sort_by_place() {
  const auto key = [this](int i) {
    const TextPlace& place = list_[idx(i)].place;
    return place.line == 0 ? std::pair(std::numeric_limits<int>::max(), 0) : std::pair(place.line, place.column);
  };
  Diagnostics sorted;
  for (const int i : stable_order(size_of(list_), [&](int a, int b) { return key(a) < key(b); })) {
    sorted.list_.push_back(std::move(list_[idx(i)]));
    sorted.merge_keys_.push_back(std::move(merge_keys_[idx(i)]));
  }
  *this = std::move(sorted);
}

const Diagnostic* Diagnostics::find(DiagnosticCode code) const {
  const auto found = std::find_if(list_.begin(), list_.end(), [code](const Diagnostic& d) { return d.code == code; });
  return found == list_.end() ? nullptr : &*found;
}

int Diagnostics::count(Severity severity) const {
  return static_cast<int>(
      std::count_if(list_.begin(), list_.end(), [severity](const Diagnostic& d) { return d.severity == severity; }));
}

std::vector<TextPlace> Diagnostics::places() const {
  std::vector<TextPlace> places;
  for (const Diagnostic& diagnostic : list_) places.push_back(diagnostic.place);
  return places;
}

}  // namespace marey
