#include "app/desks/view_desk.h"

#include <utility>

#include <QDesktopServices>
#include <QFileInfo>
#include <QJsonDocument>
#include <QUrl>

#include "core/link/across_threads.h"
#include "core/mission/files/file_set.h"
#include "core/mission/fleet/robot_words.h"
#include "core/server/embedded/program_files.h"
#include "widgets/commands/command_palette.h"
#include "widgets/models/notice_place.h"
#include "widgets/panels/dialogs.h"
#include "widgets/window/map_commands.h"

namespace usar::app {

namespace {

/// A file or folder beside the settings.
QString besideSettings(const char* name) {
    return QFileInfo(QSettings().fileName()).path() + name;
}

} // namespace

ViewDesk::ViewDesk(const DeskContext& context, QMainWindow& window, const QString& theme)
    : Desk(context)
    , layouts_(window, context.commands, besideSettings("/layouts"))
    , docks_(window, context.views, context.commands, layouts_)
    , keys_(context.commands, besideSettings("/keys.json"))
    , themes_(context.commands)
    , help_(window, context.views, context.commands)
    , main_window_(window)
    , theme_(theme) {}

void ViewDesk::registerCommands() {
    mission::EditHistory* const history = &control_.history();
    add(
        "edit.undo", [history] { return history->canUndo(); }, [history] { history->undo(); });
    add(
        "edit.redo", [history] { return history->canRedo(); }, [history] { history->redo(); });
    layouts_.registerCommands();
    widgets::registerMapCommands(commands_, views_.map);
    themes_.registerCommands();
    add("view.hint", [this] { views_.hint->setDismissed(false); });
    auto* palette = new widgets::CommandPalette(commands_, &main_window_);
    add("view.palette", [palette] { palette->open(); });
    commands_.offer([this] { return plots(); });
    docks_.registerCommands();
    help_.registerCommands();
    add(
        "relief.save", [this] { return views_.relief->hasPicture(); }, [this] { saveReliefPicture(); });
    add("help.manual", [this] { openManual(); });
}

void ViewDesk::saveReliefPicture() {
    const QImage picture = views_.relief->canvas().picture(); // The current one, not the one when the dialog closes.
    if (picture.isNull())
        return;
    widgets::askWhereToSave(&main_window_, tr("Save 3D picture"), tr("3d-view.png"), tr("Pictures (*.png)"),
                            [this, picture](const QString& path) {
                                pool_.start(HandedOver([this, picture, path] {
                                    const QFileInfo file(path);
                                    mission::FileSet files(file.path(), file.completeBaseName(), {});
                                    files.image('.' + file.suffix(), picture);
                                    link::post(this, [this, path, error = files.error()] {
                                        if (error)
                                            notices_.complain("relief", *error);
                                        else
                                            notices_.note("relief", tr("Saved the picture %1.").arg(path));
                                    });
                                }));
                            });
}

void ViewDesk::openManual() {
    const QString manual = server::manualPage();
    if (QFileInfo::exists(manual)) {
        QDesktopServices::openUrl(QUrl::fromLocalFile(manual));
        return;
    }
    notices_.complain("manual", Error{"the manual is not installed", manual.toStdString(),
                                      "Install the package usar-mission-control-doc; in a build of your own, install "
                                      "cmark-gfm and build again"});
}

std::vector<widgets::PaletteOffer> ViewDesk::plots() const {
    views_.sensors->refresh(); // It does not while it is hidden.
    std::vector<widgets::PaletteOffer> offers;
    for (const auto& [path, unit] : views_.sensors->model().numbers())
        offers.push_back(
            {tr("Plot %1").arg(path), tr("Sensors"), {"graph", "chart", "curve"}, [this, path = path, unit = unit] {
                 raise(views_.plots_dock);
                 views_.plots->addSeries(path, unit);
             }});
    return offers;
}

void ViewDesk::wire() {
    views_.relief->setSaveAction(action("relief.save"));
    connect(views_.relief, &widgets::ReliefView::hasPictureChanged, this, [this] { commands_.refresh(); });
    wireHistory();
    wireFiles();
    docks_.wire();
    connect(views_.notifications, &widgets::NotificationCenter::activated, this, &ViewDesk::goTo);
    connect(&selection_, &Selection::changed, this, [this](RobotId id) {
        if (id.valid())
            docks_.showForRobot();
        views_.hint->setInReplay(robot() && robot()->isReplay());
    });
    const auto key = [this](const char* id) { return action(id)->shortcut().toString(QKeySequence::NativeText); };
    views_.hint->setWhatNext(tr("On its way. In the simulator, %1 makes time run faster. %2 pauses the robot. At the "
                                "end a card shows the result.")
                                 .arg(key("time.faster"), key("mission.pause")));
}

void ViewDesk::goTo(const QString& notice_key) {
    const widgets::NoticePlace place = widgets::placeOf(notice_key);
    for (const Robot* const one : control_.robots())
        if (one->view().id == place.robot_id || nameOf(*one) == place.robot_name)
            selection_.select(one->view().id);
    for (QDockWidget* const dock : views_.docks)
        if (dock->objectName() == place.dock)
            raise(dock);
    if (!place.command.isEmpty())
        action(place.command)->trigger();
}

void ViewDesk::wireHistory() {
    mission::EditHistory* const history = &control_.history();
    views_.history->setHistory(history->stack(), [history](int row) { return history->reasonOf(row); });
    connect(history, &mission::EditHistory::changed, this, &ViewDesk::showHistory);
    connect(&commands_, &widgets::CommandRegistry::sent, this, [this, history](const widgets::CommandSpec& spec) {
        const bool about_all = spec.id.endsWith("_all") || spec.group == widgets::commandSpec("world.go").group;
        const bool of_mission = spec.group == widgets::commandSpec("mission.start").group;
        const QString names = about_all    ? QString()
                              : of_mission ? mission::robotsText(views_.robots->chosenNames())
                              : robot()    ? nameOf(*robot())
                                           : QString();
        history->note(names.isEmpty() ? spec.text : tr("%1 (%2)").arg(spec.text, names));
    });
    auto* const layers = views_.layers;
    connect(layers, &widgets::LayersPanel::edited, this,
            [history, layers](const QString& what, const QByteArray& before, const QByteArray& after) {
                history->add(
                    mission::valueEdit<QByteArray>("layers/" + what, tr("change layer %1").arg(what), before, after,
                                                   [layers](const QByteArray& state) { layers->restoreState(state); }));
            });
    auto* const plots = views_.plots;
    connect(
        plots, &widgets::PlotView::edited, this,
        [history, plots](const QString& text, const QJsonArray& before, const QJsonArray& after) {
            history->addStep(mission::valueEdit<QJsonArray>(
                "plots", text, before, after, [plots](const QJsonArray& canvases) { plots->setCanvases(canvases); }));
        });
    auto* const card = views_.spawn_card;
    connect(card, &widgets::SpawnCard::choiceEdited, this,
            [history, card](const widgets::SpawnChoice& before, const widgets::SpawnChoice& after) {
                history->add(mission::valueEdit<widgets::SpawnChoice>(
                    "spawn", tr("change robot to spawn"), before, after,
                    [card](const widgets::SpawnChoice& choice) { card->setChoice(choice); }));
            });
    showHistory();
}

void ViewDesk::showHistory() {
    const mission::EditHistory& history = control_.history();
    action("edit.undo")->setText(tr("Undo %1").arg(history.undoText()).trimmed());
    action("edit.redo")->setText(tr("Redo %1").arg(history.redoText()).trimmed());
    views_.history->refresh();
    commands_.refresh();
}

void ViewDesk::wireFiles() {
    using widgets::LayoutKeeper;
    connect(&keys_, &widgets::KeyFile::failed, this, [this](const Error& error) { notices_.complain("keys", error); });
    keys_.read();
    connect(&layouts_, &LayoutKeeper::failed, this, [this](const Error& error) { notices_.complain("layout", error); });
    connect(
        &layouts_, &LayoutKeeper::docksEdited, this,
        [this](const QString& text, const auto& before, const auto& after) {
            control_.history().addStep(mission::valueEdit<widgets::DockState>(
                "layout", text, before, after, [this](const widgets::DockState& state) { layouts_.setDocks(state); }));
        });
    connect(&layouts_, &LayoutKeeper::layoutsEdited, this,
            [this](const QString& text, const auto& before, const auto& after) {
                control_.history().addStep(mission::valueEdit<widgets::Layouts>(
                    "layouts", text, before, after, [this](const widgets::Layouts& all) { layouts_.setLayouts(all); }));
            });
    layouts_.addView(
        "plots", [this] { return views_.plots->plotLayout(); }, [this](const QJsonObject& plots) { showPlots(plots); });
    layouts_.addView(
        "relief", [this] { return views_.relief->state(); },
        [this](const QJsonObject& state) { views_.relief->setState(state); });
    layouts_.read();
}

void ViewDesk::showPlots(const QJsonObject& plots) {
    if (const Result<void> restored = views_.plots->setPlotLayout(plots); !restored)
        notices_.say(Severity::Warning, "plot", QString::fromStdString(restored.error().text()));
}

void ViewDesk::restore(const QSettings& settings) {
    themes_.choose(theme_.isEmpty() ? settings.value("theme").toString() : theme_);
    const bool sized = main_window_.restoreGeometry(settings.value("geometry").toByteArray());
    docks_.restore(sized, settings.value("layout").toByteArray(),
                   settings.value("waiting_docks", docks_.waiting()).toStringList());
    views_.hint->setDismissed(settings.value("hint_dismissed", false).toBool());
    help_.tour().setTaken(settings.value("tour_taken", false).toBool());
    views_.layers->restoreState(settings.value("layers").toByteArray());
    showPlots(QJsonDocument::fromJson(settings.value("plots").toString().toUtf8()).object());
    views_.relief->setState(QJsonDocument::fromJson(settings.value("relief").toString().toUtf8()).object());
}

void ViewDesk::save(SettingsSheet& settings) const {
    settings.setValue("theme", themes_.name());
    settings.setValue("geometry", main_window_.saveGeometry());
    settings.setValue("layout", docks_.state());
    settings.setValue("waiting_docks", docks_.waiting());
    settings.setValue("hint_dismissed", views_.hint->dismissed());
    settings.setValue("tour_taken", help_.tour().taken());
    settings.setValue("layers", views_.layers->saveState());
    settings.setValue("plots", QString(QJsonDocument(views_.plots->plotLayout()).toJson(QJsonDocument::Compact)));
    settings.setValue("relief", QString(QJsonDocument(views_.relief->state()).toJson(QJsonDocument::Compact)));
}

} // namespace usar::app
