// A golden run: a plan, what its senses and acts answer in each cycle, and the trace that must come of it.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <QString>
#include <QStringList>

#include "core/posh/run/engine.h"
#include "tests/doubles/stub_host.h"

using Settings = std::vector<std::pair<std::string, usar::posh::Value>>;

struct TraceVector {
    struct Cycle {
        usar::posh::Milliseconds time{0};
        Settings senses;
        std::map<std::string, usar::posh::ActResult> results; ///< of this cycle only
    };
    std::string plan;
    Settings defaults;
    std::map<std::string, usar::posh::ActResult> results;
    std::map<std::string, Settings> effects; ///< of each run of an act
    usar::posh::EngineOptions options;
    std::vector<Cycle> cycles;
    std::string expected;
};

/// Files NAME.json of a folder, with their whole paths.
QStringList traceVectorFiles(const QString& folder);

/// A file that is none fails the test (an exception).
TraceVector readTraceVector(const QString& file);

/// The trace of the run.
std::string runVector(const TraceVector& vector);
