#include "app/plan_watch.h"

#include <utility>

#include "core/posh/value_text.h"

namespace usar::app {

namespace {

Seconds seconds(std::int64_t time_ms) {
    return Seconds(static_cast<double>(time_ms) / 1000.0);
}

widgets::PlanActivity shown(const posh::PlaceActivity& place) {
    widgets::PlanActivity activity;
    activity.running = place.running;
    if (place.last_active_ms)
        activity.last_active = seconds(*place.last_active_ms);
    activity.started = place.started;
    activity.succeeded = place.succeeded;
    activity.failed = place.failed;
    activity.skipped = place.skipped;
    activity.hold_back = QString::fromStdString(place.hold_back);
    if (place.answer)
        activity.answer =
            widgets::SenseAnswer{QString::fromStdString(posh::toText(place.answer->value)), place.answer->holds,
                                 seconds(place.answer->since_ms), seconds(place.answer->asked_ms)};
    return activity;
}

std::shared_ptr<const std::vector<std::string>> pathsOf(const posh::Program& program) {
    auto paths = std::make_shared<std::vector<std::string>>();
    for (posh::Index place = 0; place < program.places.size(); ++place)
        paths->push_back(posh::pathOf(program, place));
    return paths;
}

} // namespace

void PlanWatch::restart() {
    cursor_.reset();
    file_.reset();
    bytes_.clear();
    activity_.start(nullptr);
    paths_.reset();
}

PlanWatch::News PlanWatch::take(const mission::SessionUpdate& update) {
    if (update.rewound)
        restart();
    News news = update.rewound ? News::Plan : News::None;
    for (const agent::Published& published : update.published)
        if (const auto* const trace = std::get_if<agent::PlanTrace>(&published)) {
            const bool other_plan = append(trace->bytes);
            if (news != News::Plan)
                news = other_plan ? News::Plan : News::Activity;
        }
    return news;
}

/// A trace that begins is another run. True where another plan begins.
bool PlanWatch::append(const std::string& bytes) {
    const bool begins = bytes.starts_with(posh::trace_codec::magic);
    if (begins)
        restart();
    bytes_ += bytes;
    if (file_)
        file_->extend(bytes_);
    else if (auto opened = posh::TraceFile::open(bytes_))
        cursor_ = file_.emplace(*std::move(opened)).begin();
    return readOn() || begins;
}

bool PlanWatch::readOn() {
    bool other_plan = false;
    while (cursor_) {
        const posh::TracedCycle* const cycle = cursor_->next();
        if (!cycle)
            break;
        if (cycle->program && cycle->program != activity_.program()) {
            activity_.start(cycle->program);
            paths_ = pathsOf(*cycle->program);
            text_ = file_->planText(file_->planCount() - 1);
            reading_ = posh::readPlan(text_);
            other_plan = true;
        }
        for (const auto& entry : cycle->events)
            activity_.take(entry.record, cycle->textOf(entry));
        for (const auto& entry : cycle->behind)
            activity_.take(entry.record, cycle->textOf(entry));
    }
    return other_plan;
}

widgets::PlanSnapshot PlanWatch::snapshot() const {
    widgets::PlanSnapshot snapshot;
    snapshot.paths = paths_;
    for (const posh::PlaceActivity& place : activity_.places())
        snapshot.activities.push_back(shown(place));
    snapshot.now = seconds(activity_.now_ms());
    return snapshot;
}

} // namespace usar::app
