#include <QTest>
#include <QUndoStack>
#include <QUndoView>

#include "tests/suite/suite.h"
#include "widgets/panels/history_panel.h"
#include "widgets/style/theme.h"

namespace tst_history_panel {

using namespace usar::widgets;

class tst_HistoryPanel : public QObject {
    Q_OBJECT
private slots:
    void rowsAreLargeEnoughToBeClicked();
};

void tst_HistoryPanel::rowsAreLargeEnoughToBeClicked() {
    applyTheme(Theme::Dark);
    QUndoStack stack;
    HistoryPanel panel;
    panel.setHistory(&stack, [](int row) { return row == 0 ? QStringLiteral("it was sent") : QString(); });
    stack.push(new QUndoCommand(QStringLiteral("spawn R1")));
    stack.push(new QUndoCommand(QStringLiteral("draw area")));
    panel.refresh();
    panel.show();
    const auto* const list = panel.findChild<QUndoView*>();
    QCOMPARE(list->model()->rowCount(), 3); // the beginning, too
    for (int row = 0; row < 3; ++row)
        QVERIFY(list->visualRect(list->model()->index(row, 0)).height() >= minimum_target);
    QVERIFY(list->mapTo(&panel, QPoint()).x() >= gap::small);
}

USAR_TEST(tst_HistoryPanel)

} // namespace tst_history_panel

#include "tst_history_panel.moc"
