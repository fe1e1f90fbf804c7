// The plan of one robot and what it does, put together from what the robot publishes.
#pragma once

#include <optional>
#include <string>

#include "core/mission/session_update.h"
#include "core/posh/plan_reader.h"
#include "core/posh/run_activity.h"
#include "core/posh/trace_file.h"
#include "widgets/models/plan_activity.h"

namespace usar::app {

/// Keeps the trace of the run: a few bytes for each tick. GUI thread.
class PlanWatch {
public:
    PlanWatch() = default;
    PlanWatch(const PlanWatch&) = delete;
    PlanWatch& operator=(const PlanWatch&) = delete;

    enum class News { None, Activity, Plan };
    News take(const mission::SessionUpdate& update);

    /// No plan has decided yet.
    bool empty() const { return !activity_.program(); }
    const posh::Plan& plan() const { return reading_.plan; }
    const std::string& planText() const { return text_; }
    const posh::Findings& findings() const { return reading_.findings; }
    widgets::PlanSnapshot snapshot() const;

private:
    void restart();
    bool append(const std::string& bytes);
    bool readOn();

    std::string bytes_;
    std::optional<posh::TraceFile> file_; ///< over `bytes_`
    std::optional<posh::TraceFile::Cursor> cursor_;
    posh::RunActivity activity_;
    std::string text_;
    posh::PlanReading reading_;
    std::shared_ptr<const std::vector<std::string>> paths_;
};

} // namespace usar::app
