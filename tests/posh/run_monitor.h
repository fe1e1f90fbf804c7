// Watches a run and complains when it breaks a rule that every run must keep (P2 to P20 and P22 of the properties).
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/posh/run/trace_event.h"

class RunMonitor final : public usar::posh::TraceObserver {
public:
    explicit RunMonitor(int most_acts) : most_acts_(most_acts) {}

    /// Empty: none. The first that was broken, with cycle and place.
    const std::string& complaint() const { return complaint_; }

    void takeProgram(const std::shared_ptr<const usar::posh::Program>& program) override;
    void take(const usar::posh::TraceRecord& record, std::string_view text) override;

private:
    using Index = usar::posh::Index;
    using Record = usar::posh::TraceRecord;
    struct Open {
        Index form = 0;
        std::int64_t pushed_ms = 0;
        Index next_step = 0; ///< of a pattern: the first that has not succeeded
    };
    struct DriveNotes {
        bool in_progress = false;
        bool ever_started = false;
        std::int64_t started_ms = 0;
        std::uint64_t started_cycle = 0;
    };

    void expect(bool holds, const char* rule, const Record& record);
    void beginCycle();
    void beginEpoch();
    void endCycle(const Record& record);
    void sense(const Record& record);
    void senseOfDrive(const Record& record, Index drive);
    void senseOfGoal(const Record& record, const usar::posh::ProgramForm& form, Index form_index);
    void drive(const Record& record);
    void start(const Record& record);
    void interrupt(const Record& record);
    void frame(const Record& record);
    void element(const Record& record);
    void examined(Index element, const Record& record);
    void act(const Record& record);
    void stepBegins(Index place, Index position, const Record& record);
    void stepSucceeds(Index place, Index position);
    void checkLimits(const Record& record);

    const usar::posh::Place& place(Index index) const { return program_->places[index]; }
    Index driveOf(Index place) const;
    std::vector<Open>& openOf(Index drive) { return open_[drive]; }
    Open* findOpen(Index form);

    int most_acts_;
    std::shared_ptr<const usar::posh::Program> program_;
    std::string complaint_;

    Index act_ = usar::posh::nowhere; ///< place of the current act
    bool ran_ = false;                ///< it, in this cycle
    usar::posh::ActResult last_result_ = usar::posh::ActResult::Finished;
    int runs_ = 0;
    bool failed_ = false; ///< something has, in this cycle
    Index goal_due_ = usar::posh::nowhere;

    std::map<Index, Record> answers_; ///< of this epoch, by sense call
    std::set<Index> skipped_;         ///< drives of this epoch
    std::set<Index> refused_;         ///< drives of this epoch whose trigger failed
    Index lowest_asked_ = 0;          ///< level of this epoch
    std::vector<DriveNotes> drives_;
    std::vector<std::vector<Open>> open_; ///< by drive, outermost first
};
