// The words and keys of commands, read from a table.
#include <set>

#include <QMainWindow>
#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/commands/command_palette.h"
#include "widgets/commands/command_registry.h"
#include "widgets/style/icons.h"
#include "widgets/window/window_views.h"

namespace tst_command_table {

using namespace usar::widgets;

class tst_CommandTable : public QObject {
    Q_OBJECT
private slots:
    void aRowIsRead();
    void keysAreRead_data();
    void keysAreRead();
    void textThatIsNoTableIsEmpty();
    void everyCommandOfTheProgramIsComplete();
    void noIdAndNoKeyIsUsedTwice();
    void everyMenuItemIsACommand();
    void commandsSpeakPlainly();
    void aNewcomersWordFindsACommand_data();
    void aNewcomersWordFindsACommand();
};

void tst_CommandTable::aRowIsRead() {
    const auto table = readCommandTable(R"({"Map": {"map.follow": {"text": "Follow robot", "icon": "follow",
        "checkable": true, "keys": ["Shift+F"], "words": "center, lock on", "help": "Keeps the robot in the center"}, "map.fit": {"text": "Fit"}}})");
    QCOMPARE(table.size(), 2u);
    QCOMPARE(table[0].id, QString("map.fit"));
    QCOMPARE(table[0].group, QString("Map"));
    QVERIFY(!table[0].checkable);
    QVERIFY(table[0].shortcuts.isEmpty());
    QCOMPARE(table[1].text, QString("Follow robot"));
    QCOMPARE(table[1].help, QString("Keeps the robot in the center"));
    QCOMPARE(table[1].icon, QString("follow"));
    QVERIFY(table[1].checkable);
    QCOMPARE(table[1].words, QStringList({"center", "lock on"}));
    QVERIFY(table[0].words.isEmpty());
}

void tst_CommandTable::keysAreRead_data() {
    QTest::addColumn<QByteArray>("keys");
    QTest::addColumn<QList<QKeySequence>>("read");
    QTest::newRow("a letter") << QByteArray(R"(["G"])") << QList<QKeySequence>{QKeySequence(Qt::Key_G)};
    QTest::newRow("two") << QByteArray(R"(["Alt++", "Alt+="])")
                         << QList<QKeySequence>{QKeySequence(Qt::ALT | Qt::Key_Plus),
                                                QKeySequence(Qt::ALT | Qt::Key_Equal)};
    QTest::newRow("a bracket") << QByteArray(R"(["Ctrl+["])")
                               << QList<QKeySequence>{QKeySequence(Qt::CTRL | Qt::Key_BracketLeft)};
    QTest::newRow("that of the desktop") << QByteArray(R"(["StandardKey::Undo"])")
                                         << QList<QKeySequence>{QKeySequence(QKeySequence::Undo)};
    QTest::newRow("none") << QByteArray("[]") << QList<QKeySequence>{};
}

void tst_CommandTable::keysAreRead() {
    QFETCH(QByteArray, keys);
    const auto table = readCommandTable(R"({"Any": {"any.one": {"text": "One", "keys": )" + keys + "}}}");
    QCOMPARE(table.size(), 1u);
    QTEST(table[0].shortcuts, "read");
}

void tst_CommandTable::textThatIsNoTableIsEmpty() {
    QVERIFY(readCommandTable("").empty());
    QVERIFY(readCommandTable("{\"Map\": {").empty());
}

void tst_CommandTable::everyCommandOfTheProgramIsComplete() {
    QVERIFY(commandTable().size() > 100);
    for (const CommandSpec& spec : commandTable()) {
        QVERIFY2(!spec.text.isEmpty() && !spec.help.isEmpty(), qPrintable(spec.id));
        QVERIFY2(spec.icon.isEmpty() || iconNames().contains(spec.icon), qPrintable(spec.id + ": " + spec.icon));
        QCOMPARE(&commandSpec(spec.id), &spec);
    }
}

void tst_CommandTable::noIdAndNoKeyIsUsedTwice() {
    std::set<QString> used;
    for (const CommandSpec& spec : commandTable()) {
        QVERIFY2(used.insert(spec.id).second, qPrintable(spec.id));
        for (const QKeySequence& keys : spec.shortcuts)
            QVERIFY2(used.insert(keys.toString()).second, qPrintable(spec.id + " has the key of another command"));
    }
}

void tst_CommandTable::everyMenuItemIsACommand() {
    QMainWindow window;
    CommandRegistry commands(&window);
    for (const CommandSpec& spec : commandTable())
        commands.add(spec, [](bool) {});
    for (const char* const of_a_desk : {"view.dock.map", "view.dock.world", "view.dock.history", "view.dock.campaign"})
        commands.add({.id = of_a_desk, .text = "Dock", .group = "View"}, [](bool) {});
    const MessageList messages;
    adoptMessageActions(commands, messages.actions());
    const auto submenus = makeMenus(*window.menuBar(), commands); // Asserts that each id is known.
    QCOMPARE(submenus.size(), std::size_t(4));
    QCOMPARE(submenus.at("recent")->title(), QString("Open r&ecent"));
    QVERIFY(submenus.at("worlds")->isEmpty());
    QCOMPARE(submenus.at("samples")->actions().size(), 4);
    QVERIFY(submenus.at("layouts")->actions().contains(commands.action("view.layout_save")));
    QCOMPARE(window.menuBar()->actions().size(), 13);
    QCOMPARE(window.menuBar()->actions().front()->text(), QString("&File"));
    const QMenu* const view = window.menuBar()->actions()[11]->menu();
    QVERIFY(view->actions().contains(commands.action("view.dock.map")));
    QVERIFY(view->actions().contains(commands.action("view.dock.world")));
    QVERIFY(view->actions().contains(submenus.at("layouts")->menuAction()));
    QVERIFY(view->actions()[view->actions().size() - 6]->isSeparator());
}

void tst_CommandTable::commandsSpeakPlainly() {
    for (const CommandSpec& spec : commandTable())
        for (const char* const odd : {"way point", "epoch", "pinned", "verdict", "Forget", "Bring back", "what broke",
                                      "message on", " s on", "one simulated second"})
            QVERIFY2(!spec.text.contains(odd) && !spec.help.contains(odd), qPrintable(spec.id));
}

void tst_CommandTable::aNewcomersWordFindsACommand_data() {
    QTest::addColumn<QString>("id");
    const std::pair<const char*, const char*> words[]{
        {"undo", "edit.undo"},
        {"export", "file.export_map"},
        {"geotiff", "file.export_map"},
        {"point cloud", "file.export_map"},
        {"speed", "time.faster"},
        {"reset", "view.operate"},
        {"save", "file.export"},
        {"quit", "file.quit"},
        {"exit", "file.quit"},
        {"zoom", "map.zoom_in"},
        {"theme", "view.dark"},
        {"light", "view.dark"},
        {"help", "help.shortcuts"},
        {"keyboard", "help.shortcuts"},
        {"tutorial", "view.hint"},
        {"settings", "view.dark"},
        {"preferences", "file.folder"},
        {"run", "mission.start"},
        {"go", "mission.start"},
        {"launch", "mission.start"},
        {"fly", "mission.start"},
        {"take off", "mission.start"},
        {"abort", "mission.stop"},
        {"emergency", "mission.stop_all"},
        {"kill", "mission.stop_all"},
        {"hover", "mission.pause"},
        {"resume", "mission.pause"},
        {"region", "mission.area"},
        {"rectangle", "mission.area"},
        {"manual", "drive.take"},
        {"joystick", "drive.take"},
        {"steer", "drive.take"},
        {"brake", "drive.stop"},
        {"respawn", "robot.spawn_again"},
        {"restart", "robot.spawn_again"},
        {"trail", "robot.trace"},
        {"screenshot", "camera.save"},
        {"pan", "camera.left"},
        {"tilt", "camera.up"},
        {"lamp", "camera.light"},
        {"crosshair", "camera.overlay"},
        {"center", "map.follow"},
        {"overview", "map.fit_world"},
        {"freeze", "time.pause"},
        {"turbo", "time.max"},
        {"fast forward", "time.max"},
        {"log", "file.record"},
        {"rewind", "replay.back"},
        {"seek", "replay.forward"},
        {"console", "messages.command"},
        {"filter", "messages.find"},
        {"network", "link.connect"},
        {"wifi", "radio.show"},
        {"checkpoint", "simulator.save_snapshot"},
        {"import", "file.open"},
        {"rotate", "world.turn_left"},
        {"remove", "world.delete"},
        {"route", "world.waypoints"},
        {"reload", "plugins.rescan"},
        {"behavior tree", "plan.edit"},
        {"damage", "faults.inject"},
        {"repair", "faults.end"},
        {"where", "file.show_folder"},
    };
    for (const auto& [word, id] : words)
        QTest::newRow(word) << QString(id);
}

void tst_CommandTable::aNewcomersWordFindsACommand() {
    QFETCH(QString, id);
    const CommandSpec& spec = commandSpec(id);
    QVERIFY(matchScore(QTest::currentDataTag(), spec.text + " " + spec.group, spec.words));
}

USAR_TEST(tst_CommandTable)

} // namespace tst_command_table

#include "tst_command_table.moc"
