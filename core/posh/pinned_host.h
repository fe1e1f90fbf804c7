// A host between a plan and its robot that gives fixed answers where a person wants them: what if.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/posh/host.h"

namespace usar::posh {

/// Passes everything on but what is pinned. Calls are named as traces write them: fly("lake", $speed=9). Pins may come
/// and go between cycles and outlive the program. A pinned act does not reach the robot, but one that was begun there
/// is ended there. What is built into the engine cannot be pinned.
class PinnedHost final : public Host {
public:
    /// `host` must outlive it.
    explicit PinnedHost(Host& host) : host_(host) {}

    void pinSense(const std::string& call, Value answer);
    void pinAct(const std::string& call, ActResult result);
    void release(const std::string& call);
    void releaseAll();
    /// Whether an act was answered for since the last call: the robot was not told what to do.
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
    void findPins();

    Host& host_;
    const Program* program_ = nullptr;
    std::map<std::string, Value, std::less<>> senses_;
    std::map<std::string, ActResult, std::less<>> acts_;
    std::vector<const Value*> pinned_senses_;              ///< by call; null: not pinned
    std::vector<std::optional<ActResult>> pinned_results_; ///< by call
    bool begun_ = false;                                   ///< the current act, on the robot
    bool acted_ = false;
};

} // namespace usar::posh
