// The questions of the plan editor: where to save, export and draw to, and what to do with changes that are not saved.
#include <QMessageBox>

#include "widgets/panels/dialogs.h"
#include "widgets/plan/editor/plan_editor.h"

namespace usar::widgets {

namespace {

/// Tells the error, if there is one; returns true if there is none.
bool worked(PlanEditor& editor, const auto& done) {
    if (!done)
        emit editor.failed(done.error());
    return done.has_value();
}

} // namespace

void PlanEditor::saveNow(const std::function<void()>& then) {
    if (path().isEmpty())
        return chooseWhereToSave(then);
    if (worked(*this, save(path())) && then)
        then();
}

void PlanEditor::chooseWhereToSave(const std::function<void()>& then) {
    askWhereToSave(this, tr("Save plan"), path().isEmpty() ? name() : path(), tr("POSH plans (*.lap)"),
                   [this, then](const QString& path) {
                       if (worked(*this, save(path)) && then)
                           then();
                   });
}

void PlanEditor::chooseWhereToExport(posh::Dialect dialect) {
    askWhereToSave(this, tr("Export plan"), name(), tr("POSH plans (*.lap)"), [this, dialect](const QString& path) {
        if (const auto lacks = exportTo(path, dialect); worked(*this, lacks))
            emit exported(path, *lacks);
    });
}

void PlanEditor::chooseWhereToDraw() {
    askWhereToSave(this, tr("Save plan as picture"), tr("plan.svg"), tr("Drawings (*.svg *.pdf *.png)"),
                   [this](const QString& path) { worked(*this, savePicture(path)); });
}

void PlanEditor::letGo(const std::function<void()>& go_on) {
    if (!isModified())
        return go_on();
    const QString key = QStringLiteral("unsaved");
    auto* box = findChild<QMessageBox*>(key, Qt::FindDirectChildrenOnly);
    if (!box) {
        box = new QMessageBox(QMessageBox::Question, tr("The plan is not saved"),
                              tr("%1 has changes that are not saved.").arg(name()),
                              QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
        box->setObjectName(key);
        box->setAttribute(Qt::WA_DeleteOnClose);
        box->setDefaultButton(QMessageBox::Save);
        box->setModal(false); // A message box is modal unless it is told otherwise.
    }
    disconnect(box, &QMessageBox::finished, this, nullptr);
    connect(box, &QMessageBox::finished, this, [this, box, go_on](int answer) {
        box->setObjectName({}); // The next action may ask again.
        if (answer == QMessageBox::Save)
            return saveNow(go_on);
        if (answer != QMessageBox::Discard)
            return;
        file_.forgetKept();
        text_->document()->setModified(false);
        go_on();
    });
    show();
    box->show();
    box->raise();
    box->activateWindow();
}

} // namespace usar::widgets
