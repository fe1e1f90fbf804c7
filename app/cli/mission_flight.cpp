#include "app/cli/mission_flight.h"

#include <cmath>
#include <ctime>
#include <memory>
#include <optional>
#include <utility>

#include <QCoreApplication>
#include <QElapsedTimer>

#include "app/cli/console.h"
#include "app/host/true_figures.h"
#include "core/mission/reports/progress_bar.h"
#include "core/mission/runs/mission_runner.h"
#include "core/server/embedded/program_files.h"
#include "core/server/embedded/quit_signals.h"
#include "core/server/embedded/simulator_files.h"

namespace usar::app {

namespace {

/// Processor time of this process so far, in seconds.
double processorTime_s() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Ends as the other verbs do, and adds a key cpu_s. A unity build would give their summaries the key, too, if this had
/// the name of their function.
int endFlight(int exit_code, QJsonObject summary) {
    summary["cpu_s"] = std::round(processorTime_s() * 1000.0) / 1000.0;
    return end(exit_code, summary);
}

int refuse(const Error& error, const mission::MissionOptions* options, const mission::Mission* plan = nullptr) {
    complain(error.text());
    return endFlight(mission::BadInput, mission::toJson(mission::refusedRun(error, options, plan)));
}

Result<std::vector<sim::Fault>> faultsOf(const mission::MissionOptions& options, const mission::Mission& plan) {
    auto faults = server::readFaults(server::textsOf(plan.faults));
    if (!faults)
        return tl::unexpected(mission::atValue(plan, "faults", faults.error()));
    auto more = server::readFaults(options.faults);
    if (!more)
        return more;
    faults->insert(faults->end(), more->begin(), more->end());
    return faults;
}

/// Starts a simulator for the mission's world; returns nullptr if the command line names a server. Fills `run_options`
/// with the details of whichever is used.
Result<std::unique_ptr<server::HeadlessSimulator>> serverFor(const mission::MissionOptions& options,
                                                             const mission::Mission& plan,
                                                             mission::RunOptions& run_options, Preloaded& loaded) {
    if (const auto possible = mission::checkFaultsArePossible(options, plan); !possible)
        return tl::unexpected(possible.error());
    if (options.server) {
        run_options.host = options.server->host;
        run_options.port = options.server->port;
        run_options.equipment_advice = server::equipmentAdvice().toStdString();
        return nullptr;
    }
    auto faults = faultsOf(options, plan);
    if (!faults)
        return tl::unexpected(faults.error());
    auto world = loaded.takeWorld(QString::fromStdString(plan.world));
    if (!world)
        return tl::unexpected(mission::atValue(plan, "world", world.error()));
    auto simulator = server::HeadlessSimulator::serve(
        *std::move(world),
        {.seed = options.seed,
         .speed_x = options.speed_x,
         .faults = *std::move(faults),
         .battery_life = options.battery_life_s ? Seconds{*options.battery_life_s} : sim::survey_battery_life,
         .own_thread = options.speed_x.has_value()});
    if (!simulator)
        return tl::unexpected(mission::atValue(plan, "world", simulator.error()));
    run_options.port = (*simulator)->port();
    run_options.in_process = (*simulator)->inProcess();
    run_options.truth = app::truthOf(**simulator);
    run_options.world_extent = (*simulator)->extent();
    run_options.dry_above_m = (*simulator)->dryAbove_m();
    run_options.true_figures = [one = simulator->get()] { return app::trueFiguresOf(*one); };
    return simulator;
}

/// `earlier`: the run that this one continues; null: none.
int run(const mission::MissionOptions& options, mission::Mission plan, Preloaded& loaded,
        std::shared_ptr<const mission::RecordedScan> earlier = {}) {
    if (const auto applied = mission::applyTo(plan, options); !applied)
        return refuse(applied.error(), &options, &plan);
    const agent::PluginLoader& plugins = loaded.plugins(options.plugin_folders);
    mission::RunOptions run_options;
    run_options.seed = options.seed;
    run_options.result_folder = options.result_folder;
    run_options.files = options.files;
    run_options.formats = options.formats;
    run_options.recording = options.recording;
    run_options.recording_limit = options.recording_limit_bytes;
    run_options.course = options.course;
    if (options.one_thread)
        run_options.behavior_thread = agent::BehaviorThread::Callers;
    run_options.limits.session.flight = mission::limitOf(options, plan);
    run_options.earlier = std::move(earlier);
    run_options.behavior_host = server::behaviorHostProgram();
    const auto simulator = serverFor(options, plan, run_options, loaded);
    if (!simulator)
        return refuse(simulator.error(), &options, &plan);
    mission::MissionRunner runner(std::move(plan), plugins, std::move(run_options));
    mission::ProgressBar bar(app::isTerminal());
    QElapsedTimer wall;
    wall.start();
    QObject::connect(&runner, &mission::MissionRunner::progressed, [&](const auto& progress) {
        tell(bar.show(progress, Seconds(static_cast<double>(wall.elapsed()) / 1000.0), app::terminalColumns()));
    });
    QObject::connect(&runner, &mission::MissionRunner::noticed,
                     [&](const auto& notice) { tell(bar.say(notice.text)); });
    QObject::connect(&runner, &mission::MissionRunner::finished, qApp, [](int code) { QCoreApplication::exit(code); });
    if (*simulator) {
        (*simulator)->onFault(&runner, [&](const QString& sentence) { runner.noteFault(sentence); });
        (*simulator)->onSilenced(&runner, [&](const QString& name) { runner.robotSilenced(name); });
        (*simulator)->onVanished(&runner, [&](const QString& name) { runner.robotVanished(name); });
    }
    server::QuitSignals signals_;
    QObject::connect(&signals_, &server::QuitSignals::quit, &runner, &mission::MissionRunner::interrupt);
    runner.start();
    const int exit_code = QCoreApplication::exec();
    tell(bar.say(runner.summary()["reason"].toString().toStdString()));
    return endFlight(exit_code, runner.summary());
}

int goOn(mission::MissionOptions options, Preloaded& loaded) {
    auto earlier = mission::readRecordedScan(options.continued, mission::needPoints(options.formats));
    if (!earlier)
        return refuse(earlier.error(), &options);
    if (!earlier->missing.empty())
        complain(earlier->missing + " What was scanned there is flown again.");
    if (earlier->flown.seed && !options.seed_chosen)
        options.seed = *earlier->flown.seed;
    mission::Mission plan = earlier->flown.mission;
    if (!plan.claims.empty())
        return refuse({"a test cannot be continued, because its claims count from its start",
                       options.continued.toStdString(), "Fly its mission again"},
                      &options, &plan);
    return run(options, std::move(plan), loaded, std::make_shared<const mission::RecordedScan>(*std::move(earlier)));
}

Result<sim::PreparedWorld> readWorld(const QString& name) {
    return server::loadWorld(name).and_then(sim::PreparedWorld::make);
}

} // namespace

const agent::PluginLoader& Preloaded::plugins(const QStringList& more_folders) {
    const QStringList folders = server::pluginFolders() + more_folders;
    if (plugins_.folders() != folders)
        plugins_.scan(folders);
    return plugins_;
}

void Preloaded::load(const QString& world) {
    plugins({});
    server::loadRobots(); // It keeps the robots that it reads for the next call.
    if (world_ && world_name_ == world)
        return;
    world_.reset();
    world_name_ = world;
    if (auto read = readWorld(world))
        world_ = *std::move(read);
}

Result<sim::PreparedWorld> Preloaded::takeWorld(const QString& name) {
    if (!world_ || world_name_ != name)
        return readWorld(name);
    return *std::exchange(world_, std::nullopt);
}

void preloadFor(const QStringList& arguments, Preloaded& loaded) {
    const auto options = mission::readMissionOptions(arguments);
    if (!options || options->mission_file.isEmpty() || options->server)
        return;
    auto plan = mission::readMissionFile(options->mission_file);
    if (plan && mission::applyTo(*plan, *options))
        loaded.load(QString::fromStdString(plan->world));
}

int flyMission(const QStringList& arguments, Preloaded& loaded) {
    const auto options = mission::readMissionOptions(arguments);
    if (!options)
        return refuse(options.error(), nullptr);
    if (!options->continued.isEmpty())
        return goOn(*options, loaded);
    auto plan = mission::readMissionFile(options->mission_file);
    if (!plan)
        return refuse(plan.error(), &*options);
    mission::MissionOptions flown = *options;
    if (!flown.seed_chosen)
        flown.seed = plan->seed.value_or(flown.seed);
    return run(flown, *std::move(plan), loaded);
}

} // namespace usar::app
