#include "app/desks/campaign_desk.h"

#include <algorithm>
#include <chrono>

#include <QClipboard>
#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>
#include <QUrl>

#include "core/campaign/comparison/failure_causes.h"
#include "core/campaign/plan/campaign_writer.h"
#include "core/campaign/plan/manifest.h"
#include "core/mission/runs/mission_runner.h"
#include "core/server/embedded/program_files.h"
#include "widgets/campaign/campaign_panel.h"
#include "widgets/panels/dialogs.h"

namespace usar::app {

namespace {

const QString campaign_filter = QStringLiteral("Campaigns (*.json)");

QString summaryOf(const campaign::Campaign& campaign, const QString& path) {
    qint64 runs = 0;
    for (const campaign::CampaignMission& mission : campaign.missions)
        runs += qint64(mission.seeds) * qint64(std::max<std::size_t>(1, mission.worlds.size()));
    return CampaignDesk::tr("%1, from %2: missions %3, variants %4, runs %5")
        .arg(QString::fromStdString(campaign.name), QFileInfo(path).fileName())
        .arg(campaign.missions.size())
        .arg(campaign.variants.size())
        .arg(runs * qint64(campaign.variants.size()));
}

} // namespace

void CampaignDesk::registerCommands() {
    const auto idle = [this] { return !process_.running(); };
    const auto row = [this] { return currentRun() != nullptr; };
    add("campaign.run", idle, [this] { run(); });
    add(
        "campaign.stop", [this] { return process_.running() && !stopping_; },
        [this] {
            stopping_ = true;
            process_.stop();
            showProgress();
        });
    add(
        "campaign.resume", [this, idle] { return idle() && resumable() && !complete(); }, [this] { resume(); });
    add("campaign.open", idle, [this] {
        widgets::askForFile(window_, tr("Open campaign"), server::campaignsFolder(), campaign_filter,
                            [this](const QString& path) { openFile(path); });
    });
    add("campaign.open_results", idle, [this] {
        widgets::askForFolder(window_, tr("Open the results of a campaign"), control_.resultFolder(),
                              [this](const QString& folder) { openResults(folder); });
    });
    add(
        "campaign.save", [this] { return open_file_.isEmpty(); }, // The fields are hidden while a file is open.
        [this] {
            widgets::askWhereToSave(window_, tr("Save campaign"), tr("campaign.json"), campaign_filter,
                                    [this](const QString& path) { save(path); });
        });
    add("campaign.fly", row, [this] { flyRun(currentRun()->number); });
    add(
        "campaign.fly_pair", [this] { return !flights_.flyingPair() && chosenPair().second; },
        [this] {
            const auto [first, second] = chosenPair();
            flyPair(first, second);
        });
    add("campaign.copy", row, [this] { copyCommand(); });
    add(
        "campaign.report",
        [this, idle] {
            return idle() && !results_.head().variants.isEmpty() && !results_.results().empty() &&
                   report_.state() == QProcess::NotRunning;
        },
        [this] { writeReport(); });
}

void CampaignDesk::wire() {
    auto* const form = panel().form();
    form->setActions(action("campaign.run"), action("campaign.save"), action("campaign.open"),
                     action("campaign.open_results"));
    panel().setActions(action("campaign.stop"), action("campaign.resume"));
    panel().runs()->setActions(action("campaign.fly"), action("campaign.fly_pair"), action("campaign.copy"));
    panel().verdict()->setAction(action("campaign.report"));
    connect(form, &widgets::CampaignForm::changed, this, [form] { form->setTrouble({}); });
    connect(form, &widgets::CampaignForm::folderWanted, this, [this, form] {
        widgets::askForFolder(window_, tr("Folder for the campaign's results"), control_.resultFolder(),
                              [form](const QString& folder) { form->setFolder(folder); });
    });
    connect(form, &widgets::CampaignForm::ownCampaignWanted, this, [this, form] {
        open_file_.clear();
        form->setFile({});
        proposed_.clear();
        form->setFolder({});
        showChoices();
        commands_.refresh();
    });
    connect(panel().runs(), &widgets::RunsView::runChosen, this, &CampaignDesk::flyRun);
    connect(panel().causes(), &widgets::CauseList::runChosen, this, &CampaignDesk::flyRun);
    connect(panel().runs(), &widgets::RunsView::currentChanged, this, [this] {
        offerPartners();
        commands_.refresh();
    });
    connect(panel().runs(), &widgets::RunsView::partnerChosen, this, [this](int number) {
        if (!flights_.flyingPair())
            flyPair(currentRun(), results_.result(number));
    });
    connect(&flights_, &RunFlights::pairChanged, &commands_, &widgets::CommandRegistry::refresh);
    wireResults();
    choices_due_.setInterval(std::chrono::milliseconds(500)); // Many parts of the window set up a mission.
    connect(&choices_due_, &QTimer::timeout, this, &CampaignDesk::showChoices);
    choices_due_.start();
    causes_due_.setSingleShot(true);
    causes_due_.setInterval(std::chrono::milliseconds(300));
    connect(&causes_due_, &QTimer::timeout, this, &CampaignDesk::showCauses);
}

void CampaignDesk::wireResults() {
    connect(&process_, &campaign::CampaignProcess::ended, this, &CampaignDesk::takeEnd);
    connect(&results_, &CampaignResults::begun, this, [this] {
        showProgress();
        commands_.refresh();
    });
    connect(&results_, &CampaignResults::came, this, &CampaignDesk::takeResults);
    connect(&results_, &CampaignResults::failed, this,
            [this](const QString& sentence) { panel().setTrouble(sentence); });
    connect(&results_, &CampaignResults::caughtUp, this, [this] {
        if (process_.running() && !since_start_.isValid()) {
            since_start_.start();
            before_start_ = results_.results().size();
        }
        if (process_.running() || judged_ || results_.results().empty())
            return;
        judged_ = true;
        results_.judge();
        commands_.refresh();
    });
    connect(&results_, &CampaignResults::judged, panel().verdict(), &widgets::VerdictView::setVerdicts);
    connect(&report_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
        if (error != QProcess::FailedToStart)
            return; // It has started, so it also finishes.
        commands_.refresh();
        panel().setTrouble(tr("The report cannot be written: %1").arg(report_.errorString()));
    });
    connect(&report_, &QProcess::finished, this, [this](int exit_code, QProcess::ExitStatus status) {
        commands_.refresh();
        if (status != QProcess::NormalExit || exit_code == mission::BadInput)
            return panel().setTrouble(QString::fromUtf8(report_.readAllStandardError()).trimmed());
        const QString path = report_.arguments().last();
        notices_.note("campaign-report", tr("The report is in %1.").arg(path));
        QDesktopServices::openUrl(QUrl::fromLocalFile(path));
    });
}

Result<CampaignBasis> CampaignDesk::basis() const {
    if (control_.level().isEmpty())
        return failure("there is no world to fly in: a replay has none, and no simulator is connected", {},
                       "Connect to one first, or open a campaign's file");
    CampaignBasis basis;
    const std::string name = mission_.name();
    auto mission = mission_.setUpNow(name.empty() ? server::worldTitle(control_.level()).toStdString() : name);
    if (!mission)
        return tl::unexpected(mission.error());
    basis.mission = *std::move(mission);
    const auto kinds = control_.plugins().kinds();
    const auto robot = std::ranges::find(kinds, basis.mission.robot_class, &agent::RobotDescription::class_name);
    if (robot == kinds.end())
        return failure("no plugin flies this robot", basis.mission.robot_class, "Choose another robot");
    basis.robot = *robot;
    basis.dock_faults = faults_.texts();
    return basis;
}

void CampaignDesk::showChoices() {
    auto* const form = panel().form();
    if (!form->isVisible())
        return;
    const auto basis = this->basis();
    if (form->wish().folder == proposed_) { // Who empties the field is about to type another folder.
        const QString folders = QDir(control_.resultFolder()).filePath("campaigns");
        const QString name = open_file_.isEmpty() ? control_.level() : QFileInfo(open_file_).completeBaseName();
        proposed_ = open_file_.isEmpty()
                        ? freeFolder(folders, name.isEmpty() ? "campaign" : name)
                        : QDir(folders).filePath(name); // The same again, so that it can be gone on with.
        form->setFolder(proposed_);
    }
    form->setFaultCount(static_cast<int>(faults_.texts().size()));
    if (!basis)
        return form->setMission({}, QString::fromStdString(basis.error().text()));
    const mission::Mission& mission = basis->mission;
    const auto behavior = std::ranges::find(basis->robot.behaviors, mission.behavior, &agent::BehaviorDescription::id);
    const Vec2 size_m = mission.area_in_map.max_m - mission.area_in_map.min_m;
    form->setMission(
        tr("%1 from %2 in %3, %4 × %5 m")
            .arg(QString::fromStdString(basis->robot.name), QString::fromStdString(mission.start), control_.level())
            .arg(size_m.x(), 0, 'f', 0)
            .arg(size_m.y(), 0, 'f', 0),
        {});
    form->setBehaviors(behaviorsOf(basis->robot), QString::fromStdString(mission.behavior));
    if (behavior != basis->robot.behaviors.end())
        form->setParameters(parametersOf(*behavior, mission));
}

void CampaignDesk::openFile(const QString& path) {
    const auto read = campaign::readCampaignFile(path);
    if (!read)
        return complain(read.error());
    auto* const form = panel().form();
    open_file_ = path;
    form->setFile(summaryOf(*read, path));
    form->setTrouble({});
    proposed_.clear();
    form->setFolder({});
    panel().showPage(widgets::CampaignPanel::SetUp);
    raise(views_.campaign_dock);
    showChoices();
    commands_.refresh();
}

void CampaignDesk::openResults(const QString& folder) {
    if (!QFileInfo::exists(QDir(folder).filePath(campaign::manifest_file)))
        return complain(
            {"this folder holds no campaign", folder.toStdString(), "Choose one that holds a file manifest.jsonl"});
    const QString file = QDir(folder).filePath(campaign_file);
    file_ = QFileInfo::exists(file) ? file : QString();
    begin(folder);
    panel().showPage(widgets::CampaignPanel::Runs);
    raise(views_.campaign_dock);
    commands_.refresh();
}

void CampaignDesk::run() {
    const widgets::CampaignWish wish = panel().form()->wish();
    if (!open_file_.isEmpty()) {
        if (wish.folder.isEmpty())
            return complain({"there is no folder for the results", "Folder", "Choose one"});
        return start(open_file_, wish.folder, wish.jobs);
    }
    const auto basis = this->basis();
    if (!basis)
        return complain(basis.error());
    const auto file = keepCampaign(*basis, wish);
    if (!file)
        return complain(file.error());
    start(*file, QFileInfo(*file).absolutePath(), wish.jobs);
}

void CampaignDesk::start(const QString& file, const QString& folder, int jobs) {
    file_ = file;
    panel().form()->setTrouble({});
    begin(folder);
    process_.start(server::missionProgram(), file, folder, jobs);
    panel().showPage(widgets::CampaignPanel::Runs);
    raise(views_.campaign_dock);
    showProgress();
    commands_.refresh();
}

void CampaignDesk::resume() {
    start(file_, results_.folder(), panel().form()->wish().jobs);
}

void CampaignDesk::save(const QString& path) {
    const auto basis = this->basis();
    if (!basis)
        return complain(basis.error());
    const QFileInfo info(path);
    const QString mission_path = info.dir().filePath(info.completeBaseName() + "-mission.json");
    const auto files = campaignFiles(*basis, panel().form()->wish(), path, mission_path);
    if (!files)
        return complain(files.error());
    // The dialog has asked about the campaign's file, and a campaign that is replaced takes its own mission with it.
    if (!textOf(path).contains(QFileInfo(mission_path).fileName().toUtf8()))
        if (const auto vacant = checkVacant(mission_path, files->mission); !vacant)
            return complain(vacant.error());
    for (const auto& [place, text] : {std::pair(mission_path, files->mission), std::pair(path, files->campaign)})
        if (const auto kept = campaign::writeWhole(place, text); !kept)
            return complain(kept.error());
    notices_.note("campaign-saved", tr("Saved the campaign %1 and its mission beside it; usar-mission campaign flies "
                                       "it, too.")
                                        .arg(path));
}

void CampaignDesk::begin(const QString& folder) {
    stopping_ = judged_ = false;
    failures_ = 0;
    before_start_ = 0;
    since_start_.invalidate();
    panel().setTrouble({});
    panel().table().begin(campaignMetrics());
    panel().causes()->setCauses({}, false);
    panel().verdict()->setVerdicts({}, tr("It is said here when the campaign has ended or is stopped."));
    results_.follow(folder);
    showProgress();
}

void CampaignDesk::takeResults(const std::vector<campaign::RunResult>& results) {
    std::vector<widgets::CampaignRun> rows;
    for (const campaign::RunResult& result : results) {
        rows.push_back(rowOf(result));
        failures_ += result.outcome != campaign::Outcome::Done;
    }
    judged_ = false;
    panel().table().append(rows);
    offerPartners();
    if (!causes_due_.isActive())
        causes_due_.start();
    showProgress();
}

void CampaignDesk::takeEnd(const QString& trouble) {
    QString words = trouble;
    panel().setTrouble(words.remove(" with --out")); // The folder is a field here.
    stopping_ = judged_ = false;
    showProgress();
    commands_.refresh();
}

/// Before the runs are counted there is nothing to go on with; what is wrong with the file is mended in the file.
bool CampaignDesk::resumable() const {
    return !file_.isEmpty() && results_.head().runs > 0;
}

bool CampaignDesk::complete() const {
    const auto runs = static_cast<std::size_t>(results_.head().runs);
    return runs > 0 && results_.results().size() >= runs;
}

void CampaignDesk::showProgress() {
    using enum widgets::CampaignState;
    const int done = static_cast<int>(results_.results().size());
    widgets::CampaignProgress progress{.title = results_.head().name,
                                       .runs = results_.head().runs,
                                       .done = done,
                                       .failures = failures_,
                                       .can_resume = resumable()};
    if (process_.running())
        progress.state = stopping_ ? Stopping : Running;
    else if (!results_.folder().isEmpty())
        progress.state = complete() ? Complete : Stopped;
    if (since_start_.isValid() && since_start_.elapsed() > 0)
        progress.rate_hz = 1000.0 * (done - static_cast<int>(before_start_)) / double(since_start_.elapsed());
    panel().setProgress(progress);
}

void CampaignDesk::showCauses() {
    const std::vector<campaign::RunResult>& results = results_.results();
    std::vector<widgets::CauseRow> rows;
    for (const campaign::FailureCause& cause : campaign::failureCauses(results)) {
        const QString reason = QString::fromStdString(cause.reason);
        const bool is_usual = cause.outcome == campaign::Outcome::Failed;
        widgets::CauseRow row{is_usual ? reason : campaign::wordOf(cause.outcome) + ": " + reason,
                              QString::fromStdString(campaign::variantCounts(results, cause.indices)),
                              {}};
        for (std::size_t i = 0; i < cause.indices.size(); ++i) {
            const campaign::RunResult& run = results[cause.indices[i]];
            row.runs.push_back(
                {run.number,
                 tr("Run %1, %2, seed %3").arg(run.number).arg(QString::fromStdString(run.variant)).arg(run.seed),
                 QString::fromStdString(run.reason), QString::fromStdString(cause.places[i])});
        }
        rows.push_back(std::move(row));
    }
    panel().causes()->setCauses(rows, !results.empty());
}

const campaign::RunResult* CampaignDesk::currentRun() const {
    const auto number = panel().runs()->currentRun();
    return number ? results_.result(*number) : nullptr;
}

void CampaignDesk::flyRun(int number) {
    if (const campaign::RunResult* const run = results_.result(number))
        flights_.fly(*run, results_.folder());
}

CampaignDesk::RunsOfSeed CampaignDesk::chosenPair() const {
    const std::vector<int> selected = panel().runs()->selectedRuns();
    if (selected.size() == 2) {
        const campaign::RunResult* const first = results_.result(selected[0]);
        const campaign::RunResult* const second = results_.result(selected[1]);
        return first && second && first->pair == second->pair ? RunsOfSeed{first, second} : RunsOfSeed{};
    }
    const campaign::RunResult* const run = selected.size() == 1 ? currentRun() : nullptr;
    const auto partners = run ? results_.partnersOf(*run) : std::vector<const campaign::RunResult*>();
    return partners.empty() ? RunsOfSeed{} : RunsOfSeed{run, partners.front()};
}

void CampaignDesk::offerPartners() {
    std::vector<widgets::RunPartner> offers;
    if (const campaign::RunResult* const run = currentRun())
        for (const campaign::RunResult* const partner : results_.partnersOf(*run))
            offers.push_back({partner->number, QString::fromStdString(partner->variant)});
    panel().runs()->setPartners(offers);
}

void CampaignDesk::flyPair(const campaign::RunResult* run, const campaign::RunResult* partner) {
    if (!run || !partner)
        return;
    const bool in_order = run->number < partner->number; // The first variant comes first, whichever row was chosen.
    flights_.flyPair(in_order ? *run : *partner, in_order ? *partner : *run, results_.folder());
}

void CampaignDesk::copyCommand() {
    const campaign::RunResult* const run = currentRun();
    if (!run)
        return;
    if (const auto command = wholeCommandOf(*run, results_.folder()))
        QGuiApplication::clipboard()->setText(*command);
    else
        notices_.complain("campaign-run", command.error());
}

void CampaignDesk::writeReport() {
    const QString path = QDir(results_.folder()).filePath("report.html");
    report_.start(server::missionProgram(), {"compare", results_.folder(), "--html", path});
    commands_.refresh();
}

void CampaignDesk::complain(const Error& error) {
    const QString sentence = QString::fromStdString(error.text());
    panel().showPage(widgets::CampaignPanel::SetUp);
    panel().form()->setTrouble(sentence);
}

} // namespace usar::app
