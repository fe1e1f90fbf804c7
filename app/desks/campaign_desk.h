// Desk of the campaign dock: makes campaigns from the mission that is set up, flies them in the background, shows them.
#pragma once

#include <QElapsedTimer>
#include <QProcess>
#include <QTimer>

#include "app/desks/campaign_results.h"
#include "app/desks/campaign_setup.h"
#include "app/desks/desk.h"
#include "app/desks/fault_desk.h"
#include "app/desks/mission_desk.h"
#include "app/desks/run_flights.h"
#include "core/campaign/runs/campaign_process.h"

namespace usar::app {

/// One campaign at a time is flown or looked at. It is flown by usar-mission, so that the window and its robots are not
/// disturbed, and its results are followed in its folder. GUI thread.
class CampaignDesk : public Desk {
    Q_OBJECT
public:
    CampaignDesk(const DeskContext& context, MissionDesk& mission, FaultDesk& faults, RunFlights& flights)
        : Desk(context)
        , mission_(mission)
        , faults_(faults)
        , flights_(flights) {}

    void registerCommands() override;
    void wire() override;

    /// Takes the campaign of a file in place of one that is set up here. Errors are shown in the dock.
    void openFile(const QString& path);
    /// Shows the results in a folder; if its campaign's file is there, what is missing can be flown.
    void openResults(const QString& folder);

private:
    void wireResults();
    /// The mission that is set up; an error says what is missing.
    Result<CampaignBasis> basis() const;
    /// Fills the form with the mission that is set up, if the form can be seen.
    void showChoices();
    void run();
    void start(const QString& file, const QString& folder, int jobs);
    void resume();
    void save(const QString& path);
    void begin(const QString& folder);
    void takeResults(const std::vector<campaign::RunResult>& results);
    void takeEnd(const QString& trouble);
    /// True if the campaign's file is known, and its runs.
    bool resumable() const;
    /// True if every run has a result.
    bool complete() const;
    void showProgress();
    void showCauses();
    void flyRun(int number);
    /// Two runs of one seed; null where there is none.
    using RunsOfSeed = std::pair<const campaign::RunResult*, const campaign::RunResult*>;
    /// The two that are selected, or the one that is and that of the first other variant.
    RunsOfSeed chosenPair() const;
    /// The menu of the current row offers the other variants of its seed.
    void offerPartners();
    void flyPair(const campaign::RunResult* run, const campaign::RunResult* partner);
    void copyCommand();
    void writeReport();
    void complain(const Error& error);
    const campaign::RunResult* currentRun() const;
    widgets::CampaignPanel& panel() const { return *views_.campaign; }

    MissionDesk& mission_;
    FaultDesk& faults_;
    RunFlights& flights_;
    campaign::CampaignProcess process_;
    CampaignResults results_;
    QProcess report_;
    QString file_;      ///< The campaign of this file is flown or looked at; empty if it is not known.
    QString open_file_; ///< The form shows the campaign of this file; empty if it is set up here.
    QString proposed_;  ///< The folder that was proposed last; what the user typed instead is left alone.
    bool stopping_ = false;
    bool judged_ = false;          ///< The verdict is of all results that are there.
    QElapsedTimer since_start_;    ///< It runs since this start's earlier results were read.
    std::size_t before_start_ = 0; ///< So many results were there before.
    int failures_ = 0;
    QTimer choices_due_;
    QTimer causes_due_;
};

} // namespace usar::app
