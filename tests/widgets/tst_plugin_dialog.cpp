// The list of plugins: which are used, which are not and why, and which get a process of their own.
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/panels/plugin_dialog.h"

namespace tst_plugin_dialog {

using namespace usar::widgets;

namespace {

const PluginRow good{"AirRobot",
                     "1.0",
                     "loaded",
                     {},
                     {"airrobot/cpp", "airrobot/posh"},
                     {"USARBot.AirRobot"},
                     {"INS", "Sonar"},
                     "/plugins/libairrobot.so",
                     false};
const PluginRow bad{"libbad.so",          {}, "refused", "It has no metadata. Build it anew.", {}, {}, {},
                    "/plugins/libbad.so", {}};

} // namespace

class tst_PluginDialog : public QObject {
    Q_OBJECT
private slots:
    void eachPluginHasARow();
    void theReasonOfARefusalIsShown();
    void theSensorsThatItNeedsAreNamed();
    void theSelectedOneStaysSelected();
    void aCheckMarkAsksForAProcessOfItsOwn();
    void anEmptyListNamesTheFolders();

private:
    static QTreeWidget& list(const PluginDialog& dialog) { return *dialog.findChild<QTreeWidget*>(); }
};

void tst_PluginDialog::eachPluginHasARow() {
    PluginDialog dialog({"/plugins"});
    dialog.setPlugins({good, bad});
    QCOMPARE(list(dialog).topLevelItemCount(), 2);
    const QTreeWidgetItem* const first = list(dialog).topLevelItem(0);
    QCOMPARE(first->text(0), QString("AirRobot"));
    QCOMPARE(first->text(1), QString("1.0"));
    QCOMPARE(first->text(2), QString("loaded"));
    QCOMPARE(first->text(3), QString("airrobot/cpp, airrobot/posh"));
    QCOMPARE(list(dialog).topLevelItem(1)->text(2), QString("refused"));
    QVERIFY(!dialog.isModal());
}

void tst_PluginDialog::theReasonOfARefusalIsShown() {
    PluginDialog dialog({"/plugins"});
    dialog.setPlugins({good, bad});
    QVERIFY(dialog.details().startsWith("Select a plugin"));
    list(dialog).setCurrentItem(list(dialog).topLevelItem(1));
    QVERIFY2(dialog.details().startsWith(bad.reason), qPrintable(dialog.details()));
    QVERIFY(dialog.details().contains(bad.file));
    list(dialog).setCurrentItem(list(dialog).topLevelItem(0));
    QVERIFY2(dialog.details().contains("USARBot.AirRobot"), qPrintable(dialog.details()));
    QVERIFY(!dialog.details().contains(bad.reason));
}

void tst_PluginDialog::theSensorsThatItNeedsAreNamed() {
    PluginDialog dialog({"/plugins"});
    dialog.setPlugins({good, bad});
    list(dialog).setCurrentItem(list(dialog).topLevelItem(0));
    QVERIFY2(dialog.details().contains("\nNeeds sensors: INS, Sonar\n"), qPrintable(dialog.details()));
    list(dialog).setCurrentItem(list(dialog).topLevelItem(1));
    QVERIFY2(dialog.details().contains("\nNeeds sensors: –\n"), qPrintable(dialog.details()));
}

void tst_PluginDialog::theSelectedOneStaysSelected() {
    PluginDialog dialog({"/plugins"});
    dialog.setPlugins({good, bad});
    list(dialog).setCurrentItem(list(dialog).topLevelItem(1));
    dialog.setPlugins({bad, good});
    QCOMPARE(list(dialog).indexOfTopLevelItem(list(dialog).currentItem()), 0);
    QVERIFY(dialog.details().contains(bad.reason));
}

void tst_PluginDialog::aCheckMarkAsksForAProcessOfItsOwn() {
    PluginDialog dialog({"/plugins"});
    const QSignalSpy asked(&dialog, &PluginDialog::isolationRequested);
    dialog.setPlugins({good, bad});
    QCOMPARE(asked.size(), 0);
    list(dialog).topLevelItem(0)->setCheckState(4, Qt::Checked);
    QCOMPARE(asked.size(), 1);
    QCOMPARE(asked[0][0].toString(), QString("AirRobot"));
    QCOMPARE(asked[0][1].toBool(), true);
    QVERIFY2(!list(dialog).topLevelItem(1)->data(4, Qt::CheckStateRole).isValid(), "it has no name to be known by");
    QSignalSpy rescan(&dialog, &PluginDialog::rescanRequested);
    QTest::mouseClick(dialog.findChild<QPushButton*>(), Qt::LeftButton);
    QCOMPARE(rescan.size(), 1);
}

void tst_PluginDialog::anEmptyListNamesTheFolders() {
    PluginDialog dialog({"/plugins", "/more"});
    dialog.setPlugins({});
    QCOMPARE(dialog.details(), QString("No plugin was found in /plugins, /more."));
}

USAR_TEST(tst_PluginDialog)

} // namespace tst_plugin_dialog

#include "tst_plugin_dialog.moc"
