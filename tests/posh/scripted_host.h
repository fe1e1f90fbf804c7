// Senses and acts by chance, yet the same for the same seed, cycle and number of acts before, whatever the plan asks.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string_view>

#include "core/posh/run/host.h"

class ScriptedHost final : public usar::posh::Host {
public:
    struct Habits {
        std::uint64_t seed = 0;
        bool runs_long = true; ///< acts may answer Running
        bool throws = false;   ///< now and then
    };
    explicit ScriptedHost(const Habits& habits) : habits_(habits) {}

    void begin(std::uint64_t cycle) {
        cycle_ = cycle;
        acts_ = 0;
    }
    bool hasSense(std::string_view) const override { return true; }
    bool hasAct(std::string_view) const override { return true; }
    void bind(const usar::posh::Program& program) override { program_ = &program; }
    void sense(usar::posh::CallSite site, usar::posh::Value& answer) override {
        const std::string& call = program_->sense_calls[site.call].text;
        if (call == "never")
            answer = false;
        else
            answer = valueBy(chance(call, cycle_ / 3, call.size() % 2 ? acts_ : 0));
        perhapsThrow(call);
    }
    void init(usar::posh::CallSite site) override { perhapsThrow(program_->act_calls[site.call].text); }
    usar::posh::ActResult run(usar::posh::CallSite site) override {
        const std::string& call = program_->act_calls[site.call].text;
        perhapsThrow(call);
        return resultBy(chance(call, cycle_, acts_++));
    }
    void done(usar::posh::CallSite site, usar::posh::DoneReason) override {
        perhapsThrow(program_->act_calls[site.call].text);
    }

private:
    /// FNV over the words, stirred.
    std::uint64_t chance(std::string_view call, std::uint64_t a, std::uint64_t b) const {
        std::uint64_t hash = 1469598103934665603u ^ habits_.seed;
        for (const char c : call)
            hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
        for (const std::uint64_t word : {a, b}) {
            hash = (hash ^ word) * 1099511628211u;
            hash ^= hash >> 29;
        }
        hash *= 0xbf58476d1ce4e5b9u;
        return hash ^ (hash >> 32);
    }
    static usar::posh::Value valueBy(std::uint64_t number) {
        using namespace usar::posh;
        switch (number % 8) {
        case 0:
            return std::monostate{};
        case 1:
            return static_cast<std::int64_t>(number / 8 % 4);
        case 2:
            return static_cast<double>(number / 8 % 7) / 2.0;
        case 3:
            return std::string(number / 8 % 2 ? "near" : "far");
        case 4:
            return Symbol{"near"};
        default:
            return number / 8 % 2 != 0;
        }
    }
    usar::posh::ActResult resultBy(std::uint64_t number) const {
        using usar::posh::ActResult;
        switch (number % 8) {
        case 0:
            return ActResult::Failed;
        case 1:
        case 2:
            return ActResult::Finished;
        case 3:
        case 4:
        case 5:
            return habits_.runs_long ? ActResult::Running : ActResult::RunningOnce;
        default:
            return ActResult::RunningOnce;
        }
    }
    void perhapsThrow(std::string_view call) const {
        if (habits_.throws && chance(call, cycle_, acts_ + 77) % 16 == 0)
            throw std::runtime_error("by chance");
    }

    Habits habits_;
    const usar::posh::Program* program_ = nullptr;
    std::uint64_t cycle_ = 0;
    std::uint64_t acts_ = 0;
};
