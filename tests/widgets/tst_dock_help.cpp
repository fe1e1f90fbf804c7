// "What is this?" has an answer for each dock.
#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/style/theme.h"
#include "widgets/window/window_views.h"

namespace tst_dock_help {

using namespace usar::widgets;

class tst_DockHelp : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { applyTheme(Theme::Dark); }
    void eachDockSaysWhatItIsFor();
};

void tst_DockHelp::eachDockSaysWhatItIsFor() {
    QMainWindow window;
    const WindowViews views = makeViews(window);
    QVERIFY(views.docks.size() >= 14);
    QStringList texts;
    for (const QDockWidget* dock : views.docks) {
        const QString help = dock->whatsThis().mid(dock->windowTitle().size() + 2);
        QVERIFY2(help.split(' ').size() >= 8 && help.endsWith('.'), qPrintable(dock->objectName()));
        texts << help;
    }
    QCOMPARE(texts.removeDuplicates(), 0);
}

USAR_TEST(tst_DockHelp)

} // namespace tst_dock_help

#include "tst_dock_help.moc"
