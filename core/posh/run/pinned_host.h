// A host between a plan and its robot that replaces chosen answers by fixed ones, to try out what would happen.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/posh/run/host.h"

namespace usar::posh {

/// Passes everything on to the robot's host, except for the calls that are pinned. A call is named as in a trace:
/// fly("lake", $speed=9). Pins may be set and released between cycles and stay when the program is replaced. A pinned
/// act does not reach the robot, but if it was started there before it was pinned, its done is passed on. Senses and
/// acts that are built into the engine cannot be pinned.
class PinnedHost final : public Host {
public:
    /// `host` must outlive it.
    explicit PinnedHost(Host& host) : host_(host) {}

    void pinSense(const std::string& call, Value answer);
    void pinAct(const std::string& call, ActResult result);
    /// Releases the sense and the act of that name; does nothing if neither is pinned.
    void release(const std::string& call);
    void releaseAll();
    /// Returns whether a pinned act has run since the last call of this function. In that case the robot has received
    /// no command from it.
    bool takeActed() { return std::exchange(acted_, false); }
    bool isPinned(std::string_view call) const { return senses_.contains(call) || acts_.contains(call); }

    bool hasSense(std::string_view name) const override { return host_.hasSense(name); }
    bool hasAct(std::string_view name) const override { return host_.hasAct(name); }
    void bind(const Program& program) override;
    void sense(CallSite site, Value& answer) override;
    void init(CallSite site) override;
    ActResult run(CallSite site) override;
    void done(CallSite site, DoneReason reason) override;

private:
    /// Finds the pins of all calls of the program, so that a cycle needs no search.
    void findPins();

    Host& host_;
    const Program* program_ = nullptr;
    std::map<std::string, Value, std::less<>> senses_;
    std::map<std::string, ActResult, std::less<>> acts_;
    std::vector<const Value*> pinned_senses_;              ///< indexed by sense call; nullptr if not pinned
    std::vector<std::optional<ActResult>> pinned_results_; ///< indexed by act call; nullopt if not pinned
    bool begun_ = false;                                   ///< whether the current act was started on the robot
    bool acted_ = false;
};

} // namespace usar::posh
