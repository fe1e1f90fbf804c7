#include "core/server/radio_field.h"

#include <algorithm>

namespace usar::server {

namespace {

constexpr std::size_t most_remembered = 4096; // Bounds the cache, because clients may ask for any names.

} // namespace

void RadioField::forget() {
    stations_.reset();
    strengths_dbm_.clear();
}

const std::vector<sim::RadioStation>& RadioField::stations() {
    if (!stations_)
        stations_ = simulation_.radios();
    return *stations_;
}

const sim::RadioStation* RadioField::station(const std::string& name) {
    const auto& all = stations();
    const auto found = std::ranges::find(all, name, &sim::RadioStation::name);
    return found == all.end() || found->silent ? nullptr : &*found;
}

std::optional<double> RadioField::strength_dbm(const std::string& a, const std::string& b) {
    const auto pair = std::minmax(a, b);
    if (const auto known = strengths_dbm_.find(pair); known != strengths_dbm_.end())
        return known->second;
    const sim::RadioStation* const one = station(a);
    const sim::RadioStation* const other = station(b);
    std::optional<double> strength_dbm;
    if (one && other)
        strength_dbm = simulation_.radioStrength_dbm(*one, *other);
    if (strengths_dbm_.size() < most_remembered)
        strengths_dbm_[pair] = strength_dbm;
    return strength_dbm;
}

bool RadioField::reaches(const std::string& a, const std::string& b) {
    const auto strength = strength_dbm(a, b);
    return strength && *strength >= simulation_.options().radio.cutoff_dbm;
}

} // namespace usar::server
