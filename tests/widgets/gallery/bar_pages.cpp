#include <QMainWindow>
#include <QVBoxLayout>

#include "tests/widgets/gallery/pages.h"
#include "widgets/bars/connection_bar.h"
#include "widgets/bars/strips.h"
#include "widgets/bars/time_bar.h"
#include "widgets/commands/command_palette.h"
#include "widgets/commands/shortcut_sheet.h"
#include "widgets/map/layers_panel.h"
#include "widgets/map/spawn_card.h"
#include "widgets/panels/behavior_parts.h"
#include "widgets/style/theme.h"

namespace usar::gallery {

using namespace usar::widgets;

namespace {

QWidget* topBar(ServerChoice choice, const ConnectionStatus& status) {
    auto* bar = new QWidget;
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, gap::small, 0);
    auto* connection = new ConnectionBar;
    connection->setServer(choice);
    connection->setStatus(status);
    if (status.state == ConnectionState::Connected)
        connection->setRate(48.0, Seconds(0.0004));
    auto* time = new TimeBar;
    time->setClock(Seconds(751.0));
    time->setRealTimeFactor(1.0);
    time->setSteerable(choice == ServerChoice::Embedded);
    row->addWidget(connection, 1);
    row->addWidget(time);
    row->addWidget(makeStopButton(QStringLiteral("STOP ALL"), {}));
    return bar;
}

} // namespace

std::unique_ptr<QWidget> barsPage() {
    auto page = std::make_unique<QWidget>();
    page->resize(1280, 10);
    auto* column = new QVBoxLayout(page.get());
    const QString reason = QStringLiteral("No answer from 10.0.0.5:3000 after 5 s. Is USARSim running there?");
    column->addWidget(
        topBar(ServerChoice::Embedded, {ConnectionState::Connected, QStringLiteral("tall_test"), {}, {}}));
    column->addWidget(topBar(ServerChoice::Real, {ConnectionState::Waiting, {}, reason, Seconds(4.0)}));
    column->addWidget(topBar(ServerChoice::Real, {ConnectionState::Connecting, {}, {}, {}}));
    column->addWidget(topBar(ServerChoice::Real, {ConnectionState::Disconnected, {}, reason, {}}));
    column->addWidget(topBar(ServerChoice::Embedded, {}));
    auto* strip = new HintStrip;
    strip->setDone(FirstStep::Spawn);
    column->addWidget(strip);
    auto* row = new QHBoxLayout;
    auto* area = new AreaForm;
    area->setArea(Rectangle{Vec2(-30, -20), Vec2(30, 20)});
    row->addWidget(area);
    auto* layers = new LayersPanel;
    layers->setLayer(MapLayer::Grid, {false, 0.4});
    row->addWidget(layers);
    auto* over = new QWidget;
    over->setMinimumSize(420, 300);
    row->addWidget(over);
    auto* card = new SpawnCard(over);
    agent::RobotDescription air{"USARBot.AirRobot", "AirRobot", {}, {}};
    air.behaviors.push_back({"airrobot/cpp", "Terrain survey (C++)", "Scans.", true, {}});
    card->setRobots({air});
    card->openFor(0, QStringLiteral("PlayerStart"), QStringLiteral("R1"), over->mapToGlobal(QPoint(16, 16)));
    column->addLayout(row);
    return page;
}

namespace {

std::unique_ptr<CommandRegistry> sampleCommands(QWidget* window) {
    auto registry = std::make_unique<CommandRegistry>(window);
    struct Sample {
        const char* id;
        const char* text;
        const char* group;
        const char* icon;
        const char* keys;
    };
    const Sample samples[] = {
        {"map.fit", "Fit mission in view", "Map", "fit", "F"},
        {"map.follow", "Follow the selected robot", "Map", "follow", "Ctrl+F"},
        {"map.area", "Draw the mission area", "Map", "area", "A"},
        {"mission.start", "Start behavior", "Mission", "play", "Ctrl+Return"},
        {"mission.land", "Land now", "Mission", "land", "Ctrl+L"},
        {"mission.export", "Export results", "Mission", "export", "Ctrl+E"},
        {"view.theme", "Light or dark", "View", "sun", "Ctrl+T"},
        {"help.keys", "Keys and gestures", "Help", "help", "F1"},
    };
    for (const Sample& s : samples)
        registry->add({QString::fromLatin1(s.id),
                       QString::fromLatin1(s.text),
                       QString::fromLatin1(s.group),
                       {},
                       QString::fromLatin1(s.icon),
                       {QKeySequence(QString::fromLatin1(s.keys))}},
                      {});
    return registry;
}

/// A page that keeps its registry alive.
class RegistryPage : public QWidget {
public:
    RegistryPage() : registry_(sampleCommands(this)) { resize(840, 480); }
    CommandRegistry& registry() { return *registry_; }

private:
    std::unique_ptr<CommandRegistry> registry_;
};

} // namespace

std::unique_ptr<QWidget> palettePage() {
    auto page = std::make_unique<RegistryPage>();
    auto* column = new QVBoxLayout(page.get());
    auto* palette = new CommandPalette(page->registry(), page.get());
    palette->open();
    palette->setWindowFlags(Qt::Widget);
    column->addWidget(palette);
    return page;
}

std::unique_ptr<QWidget> sheetPage() {
    auto page = std::make_unique<RegistryPage>();
    auto* column = new QVBoxLayout(page.get());
    auto* sheet = makeShortcutSheet(page->registry(), page.get());
    sheet->setWindowFlags(Qt::Widget);
    column->addWidget(sheet);
    return page;
}

} // namespace usar::gallery
