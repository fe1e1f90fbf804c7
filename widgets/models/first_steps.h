// The first steps of a new user, as a value.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace usar::widgets {

/// In the order in which they are taken.
enum class FirstStep { Spawn, Area, Start };

/// A step that was done stays done, whatever is selected later. A plain value.
class FirstSteps {
public:
    void setDone(FirstStep step) { done_[static_cast<std::size_t>(step)] = true; }
    bool isDone(FirstStep step) const { return done_[static_cast<std::size_t>(step)]; }
    /// False: the chosen behavior needs no area, so nobody is asked for one.
    void setAreaNeeded(bool needed) { area_needed_ = needed; }

    /// The steps to show.
    std::vector<FirstStep> steps() const {
        if (area_needed_)
            return {FirstStep::Spawn, FirstStep::Area, FirstStep::Start};
        return {FirstStep::Spawn, FirstStep::Start};
    }
    /// The first of them that is not done; nullopt when a mission was started, however its task came about.
    std::optional<FirstStep> next() const {
        if (complete())
            return std::nullopt;
        const std::vector<FirstStep> shown = steps();
        return *std::ranges::find_if(shown, [this](FirstStep step) { return !isDone(step); });
    }
    bool complete() const { return isDone(FirstStep::Start); }

private:
    std::array<bool, 3> done_{};
    bool area_needed_ = true;
};

} // namespace usar::widgets
