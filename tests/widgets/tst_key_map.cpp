// The keys that the user gives to commands: by hand in the sheet, and as a file.
#include <QLabel>
#include <QMainWindow>
#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/commands/key_map.h"
#include "widgets/commands/shortcut_sheet.h"

namespace tst_key_map {

using namespace usar::widgets;

namespace {

/// Three commands, and a place for plain keys.
struct Bench {
    QMainWindow window;
    QLabel* map = new QLabel;
    QLabel* other = new QLabel;
    CommandRegistry registry{&window};
    QStringList ran;

    Bench() {
        auto* const both = new QWidget;
        map->setParent(both);
        other->setParent(both);
        map->setFocusPolicy(Qt::StrongFocus);
        other->setFocusPolicy(Qt::StrongFocus);
        window.setCentralWidget(both);
        add("map.fit", "Fit", {QKeySequence("F")});
        add("messages.find", "Search", {QKeySequence("Ctrl+F")});
        add("file.export", "Export", {});
        registry.setPlacesOfPlainKeys({map});
        window.show();
        window.activateWindow();
    }
    void add(const QString& id, const QString& text, const QList<QKeySequence>& keys) {
        registry.add({id, text, "Group", text + ".", {}, keys}, [this, id](bool) { ran << id; });
    }
    QString keyOf(const QString& id) const {
        return QKeySequence::listToString(registry.action(id)->shortcuts(), QKeySequence::PortableText);
    }
};

KeyButton* buttonOf(const QWidget& sheet, const QString& id) {
    for (KeyButton* const button : sheet.findChildren<KeyButton*>())
        if (button->id() == id)
            return button;
    return nullptr;
}

QByteArray file(const char* rest) {
    return QByteArray("{\"format\": \"mission-control-keys\", ") + rest + "}";
}

} // namespace

class tst_KeyMap : public QObject {
    Q_OBJECT
private slots:
    void aKeyIsGivenByAClickAndAPress() {
        Bench bench;
        ShortcutSheet sheet(bench.registry, &bench.window);
        sheet.setEditing(true);
        sheet.show();
        KeyButton* const button = buttonOf(sheet, "file.export");
        QVERIFY(button);
        QTest::mouseClick(button, Qt::LeftButton);
        QVERIFY(button->waits());
        QTest::keyClick(button, Qt::Key_Shift, Qt::ShiftModifier); // Alone it is no key yet.
        QVERIFY(button->waits());
        QTest::keyClick(button, Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(bench.keyOf("file.export"), QString("Ctrl+Shift+E"));
        QVERIFY2(sheet.message().contains("Export"), qPrintable(sheet.message()));
        QVERIFY(bench.registry.action("file.export")->toolTip().contains("Ctrl+Shift+E"));
        QTRY_VERIFY(buttonOf(sheet, "file.export")->text().contains("Ctrl+Shift+E"));
        QVERIFY(bench.ran.isEmpty());
    }

    void aKeyOfAnotherCommandIsTakenByASecondPress() {
        Bench bench;
        ShortcutSheet sheet(bench.registry, &bench.window);
        sheet.setEditing(true);
        sheet.show();
        KeyButton* const button = buttonOf(sheet, "file.export");
        QTest::mouseClick(button, Qt::LeftButton);
        QTest::keyClick(button, Qt::Key_F, Qt::ControlModifier);
        QVERIFY2(sheet.message().contains("already runs \"Search\""), qPrintable(sheet.message()));
        QCOMPARE(bench.keyOf("messages.find"), QString("Ctrl+F"));
        QTest::keyClick(button, Qt::Key_F, Qt::ControlModifier);
        QCOMPARE(bench.keyOf("file.export"), QString("Ctrl+F"));
        QCOMPARE(bench.keyOf("messages.find"), QString());
        QVERIFY(bench.ran.isEmpty());
    }

    void whatEndsTheWaiting_data() {
        QTest::addColumn<Qt::Key>("key");
        QTest::addColumn<QString>("keys");
        QTest::addColumn<bool>("waits");
        QTest::newRow("Escape leaves the key") << Qt::Key_Escape << "F" << false;
        QTest::newRow("Delete takes it away") << Qt::Key_Delete << "" << false;
        QTest::newRow("Tab is not possible") << Qt::Key_Tab << "F" << true;
        QTest::newRow("Return is not possible") << Qt::Key_Return << "F" << true;
    }

    void whatEndsTheWaiting() {
        QFETCH(Qt::Key, key);
        QFETCH(QString, keys);
        QFETCH(bool, waits);
        Bench bench;
        ShortcutSheet sheet(bench.registry, &bench.window);
        sheet.setEditing(true);
        sheet.show();
        KeyButton* const button = buttonOf(sheet, "map.fit");
        QTest::mouseClick(button, Qt::LeftButton);
        QTest::keyClick(button, key);
        QCOMPARE(bench.keyOf("map.fit"), keys);
        QCOMPARE(button->waits(), waits);
        QVERIFY(sheet.isVisible());
    }

    void aPlainKeyWorksOnlyInItsPlaces() {
        Bench bench;
        QVERIFY(QTest::qWaitForWindowActive(&bench.window));
        bench.registry.setKeys("map.fit", {QKeySequence("Ctrl+U")});
        bench.registry.setKeys("file.export", {QKeySequence("E")});
        bench.other->setFocus();
        QTest::keyClick(&bench.window, Qt::Key_U, Qt::ControlModifier);
        QTest::keyClick(bench.window.windowHandle(), Qt::Key_E);
        QCOMPARE(bench.ran, QStringList{"map.fit"});
        bench.map->setFocus();
        QTest::keyClick(bench.window.windowHandle(), Qt::Key_E);
        QCOMPARE(bench.ran, (QStringList{"map.fit", "file.export"}));
    }

    void theUsualKeysComeBack() {
        Bench bench;
        giveKey(bench.registry, "file.export", QKeySequence("Ctrl+F"));
        QCOMPARE(bench.registry.changedKeys().size(), std::size_t(2));
        bench.registry.takeKeys({});
        QVERIFY(bench.registry.changedKeys().empty());
        QCOMPARE(bench.keyOf("messages.find"), QString("Ctrl+F"));
        QCOMPARE(bench.keyOf("file.export"), QString());
    }

    void whatIsWrittenIsRead() {
        Bench bench;
        giveKey(bench.registry, "file.export", QKeySequence("Ctrl+F"));
        giveKey(bench.registry, "map.fit", QKeySequence("Meta+Shift+PgUp"));
        const KeyChoices changed = bench.registry.changedKeys();
        const auto read = readKeys(keysText(changed), "keys.json");
        QVERIFY(read);
        QVERIFY(*read == changed);
        bench.registry.takeKeys({});
        bench.registry.takeKeys(*read);
        QVERIFY(bench.registry.changedKeys() == changed);
    }

    void keysOfAFileThatCannotBeGivenAreLeftOut() {
        Bench bench;
        bench.registry.takeKeys({{"file.export", {QKeySequence("F"), QKeySequence("Ctrl+9")}}, {"gone", {}}});
        QCOMPARE(bench.keyOf("map.fit"), QString("F"));
        QCOMPARE(bench.keyOf("file.export"), QString("Ctrl+9"));
    }

    void aDamagedFileIsRefusedInWords_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("words");
        QTest::newRow("cut off") << file("\"version\": 1").chopped(3) << "line 1";
        QTest::newRow("another file") << QByteArray("{}") << "no file of keys";
        QTest::newRow("newer") << file("\"version\": 2") << "newer version";
        QTest::newRow("no key") << file("\"version\": 1, \"keys\": {\"map.fit\": [\"Ctrl+Banana\"]}") << "Ctrl+Banana";
        QTest::newRow("a number") << file("\"version\": 1, \"keys\": {\"map.fit\": [5]}") << "is no key";
    }

    void aDamagedFileIsRefusedInWords() {
        QFETCH(QByteArray, text);
        QFETCH(QString, words);
        const auto keys = readKeys(text, "keys.json");
        QVERIFY(!keys);
        QVERIFY2(keys.error().text().find(words.toStdString()) != std::string::npos, keys.error().text().c_str());
        QVERIFY(!keys.error().mend.empty());
    }
};

USAR_TEST(tst_KeyMap)

} // namespace tst_key_map

#include "tst_key_map.moc"
