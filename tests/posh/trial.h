// A plan that runs against set answers, and says in one line what a cycle did.
#pragma once

#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <QString>

#include "core/posh/language/plan_reader.h"
#include "core/posh/run/engine.h"
#include "tests/doubles/stub_host.h"
#include "tests/doubles/trace_text.h"

inline constexpr auto running = usar::posh::ActResult::Running;
inline constexpr auto failed = usar::posh::ActResult::Failed;

/// As the stub, with acts and senses that can be told to throw; writes down what is called.
class TrialHost final : public usar::test::StubHost {
public:
    using CallSite = usar::posh::CallSite;
    std::set<std::string> throws; ///< "sense NAME", "init NAME", "run NAME", "done NAME"
    std::vector<std::string> calls;

    void sense(CallSite site, usar::posh::Value& answer) override {
        called("sense " + program().sense_calls[site.call].name);
        StubHost::sense(site, answer);
    }
    void init(CallSite site) override { called("init " + actName(site)); }
    usar::posh::ActResult run(CallSite site) override {
        called("run " + actName(site));
        return StubHost::run(site);
    }
    void done(CallSite site, usar::posh::DoneReason) override { called("done " + actName(site)); }

private:
    std::string actName(CallSite site) const { return program().act_calls[site.call].name; }
    void called(const std::string& what) {
        calls.push_back(what);
        if (throws.contains(what))
            throw std::runtime_error(what + " failed");
    }
};

inline std::shared_ptr<const usar::posh::Program> programOf(const std::string& text) {
    const usar::posh::PlanReading reading = usar::posh::readPlan(text);
    if (usar::posh::hasErrors(reading.findings))
        throw std::runtime_error(usar::posh::toText(reading.findings.front()) + " in " + text);
    const auto program = usar::posh::compile(reading.plan);
    if (!program)
        throw std::runtime_error(program.error().text());
    return *program;
}

/// Events are joined by "; " and named without their paths: "start work; init walk; run walk -> Running; end Fired".
class Trial {
public:
    explicit Trial(const std::string& plan, usar::posh::EngineOptions options = {},
                   usar::test::TraceDetail detail = usar::test::TraceDetail::Plain)
        : trace_(detail)
        , engine(host, programOf(plan), options) {
        engine.watch(&trace_);
    }

    QString cycle(int time_ms) {
        trace_.clear();
        engine.cycle(usar::posh::Milliseconds(time_ms));
        return taken();
    }
    /// What happened since the last cycle: the answer to a stop, or a replacement.
    QString taken() {
        QStringList events;
        for (const QString& line : QString::fromStdString(trace_.text()).split('\n', Qt::SkipEmptyParts))
            if (!line.startsWith("cycle"))
                events << brief(line.trimmed());
        trace_.clear();
        return events.join("; ");
    }

    TrialHost host;

private:
    static QString brief(const QString& line) {
        QStringList words;
        for (const QString& word : line.split(' '))
            if (!word.startsWith('/'))
                words << word;
        return words.join(' ');
    }
    usar::test::TraceText trace_;

public:
    usar::posh::Engine engine;
};
