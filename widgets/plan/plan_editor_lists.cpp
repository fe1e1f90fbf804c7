// The lists below the plan: findings, differences, usages, and losses of an export.
#include <algorithm>

#include <QSaveFile>

#include "widgets/plan/plan_editor.h"
#include "widgets/plan/plan_picture.h"
#include "widgets/plan/plan_values_dialog.h"
#include "widgets/style/icons.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

using posh::PlanPart;

namespace {

QIcon iconOf(posh::Code code) {
    return severityOf(code) == Severity::Error ? icon(QStringLiteral("error"), tokens().danger)
                                               : icon(QStringLiteral("warning"), tokens().caution);
}

QIcon iconOf(posh::ChangeKind kind) {
    switch (kind) {
    case posh::ChangeKind::Added:
        return icon(QStringLiteral("plus"), tokens().ok);
    case posh::ChangeKind::Removed:
        return icon(QStringLiteral("minus"), tokens().danger);
    case posh::ChangeKind::Moved:
        return icon(QStringLiteral("unfold"), tokens().accent);
    default:
        return icon(QStringLiteral("note"), tokens().caution);
    }
}

QListWidgetItem* addRow(QListWidget& list, const QString& words, const posh::Spot& at, const QIcon& mark = {}) {
    auto* item = new QListWidgetItem(mark, words, &list);
    item->setData(Qt::UserRole, QVariantList{at.line, at.column, at.offset, at.length});
    return item;
}

} // namespace

void PlanEditor::showFindings() {
    const int row = finding_list_->currentRow();
    finding_list_->clear();
    for (const posh::Finding& finding : findings_)
        addRow(*finding_list_, QString::fromStdString(posh::toText(finding)), finding.at, iconOf(finding.code));
    for (const PlanNote& note : text_->notes())
        addRow(*finding_list_, note.words, note.at, icon(QStringLiteral("note"), tokens().accent));
    finding_list_->setCurrentRow(std::min(row, finding_list_->count() - 1));
    const int count = finding_list_->count();
    lists_->setTabText(0, count == 0 ? tr("Findings") : tr("Findings (%1)").arg(count));
    showFindingAtCursor();
}

/// Shows the finding in the cursor's line, else the number of findings.
void PlanEditor::showFindingAtCursor() {
    const auto errors = std::ranges::count_if(
        findings_, [](const posh::Finding& finding) { return severityOf(finding.code) == Severity::Error; });
    const auto warnings = std::ssize(findings_) - errors;
    if (const posh::Finding* const here = text_->findingAtCursor())
        finding_->setText(QString::fromStdString(posh::toText(*here)));
    else if (const PlanNote* const note = text_->noteAtCursor())
        finding_->setText(note->words);
    else if (!findings_.empty())
        finding_->setText(tr("Errors: %1, warnings: %2. F8 goes to the next.").arg(errors).arg(warnings));
    else
        finding_->setText((binds() ? tr("Nothing is wrong with the plan; it fits the robot.")
                                   : tr("Nothing is wrong with the plan.")) +
                          (text_->notes().empty() ? QString() : tr(" F8 goes to a note.")));
    mend_->hide();
    lamp_timer_.start();
}

Result<QStringList> PlanEditor::exportTo(const QString& path, posh::Dialect dialect) {
    catchUp();
    if (!isReadable(findings_))
        return failure("the text cannot be read", name().toStdString(), "mend its errors first");
    const posh::PlanExport made = posh::exportPlan(posh::readPlan(text_->planText()).plan, dialect);
    QSaveFile file(path);
    const QByteArray bytes = QByteArray::fromStdString(made.text);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size() || !file.commit())
        return failure("it cannot be written: " + file.errorString().toStdString(), path.toStdString(),
                       "choose another place");
    QStringList losses;
    usage_list_->clear();
    for (const posh::Loss& loss : made.losses) {
        losses << QString::fromStdString(loss.message);
        addRow(*usage_list_, losses.back(), loss.at, icon(QStringLiteral("warning"), tokens().caution));
    }
    lists_->setTabText(2, tr("Lost in the export (%1)").arg(losses.size()));
    if (!losses.isEmpty())
        lists_->setCurrentWidget(usage_list_);
    say(losses.isEmpty() ? tr("Written as %1; nothing was lost.").arg(path)
                         : tr("Written as %1; %2 things have no place in that dialect.").arg(path).arg(losses.size()));
    return losses;
}

Result<void> PlanEditor::savePicture(const QString& path) {
    catchUp();
    return savePlanPicture(*canvas_, path);
}

void PlanEditor::compareWith(const std::string& other, const QString& name) {
    catchUp();
    const posh::PlanReading before = posh::readPlan(other);
    difference_list_->clear();
    const std::vector<posh::PlanChange> changes = posh::planDifference(before.plan, checked_plan_);
    for (const posh::PlanChange& change : changes)
        addRow(*difference_list_, QString::fromStdString(change.line), change.after_at, iconOf(change.kind));
    if (changes.empty())
        addRow(*difference_list_, tr("No difference but in layout and comments"), {});
    if (!isReadable(before.findings) || !isReadable(findings_))
        addRow(*difference_list_, tr("Parts that cannot be read are left out"), {},
               icon(QStringLiteral("warning"), tokens().caution));
    lists_->setTabText(1, tr("Differences (%1)").arg(changes.size()));
    lists_->setCurrentWidget(difference_list_);
    lists_shown_->setChecked(true);
    say(tr("Against %1: %2.").arg(name, QString::fromStdString(posh::summaryOf(changes))));
}

void PlanEditor::showUsages() {
    const auto call = selectedCall();
    const auto part = call ? call : selectedPart();
    usage_list_->clear();
    if (!part)
        return;
    for (const PlanPart& usage : posh::usagesOf(drawn_plan_, *part)) {
        const PlanPart owner = posh::ownerOf(usage);
        const posh::Spot& at = posh::nameOf(drawn_plan_, usage)->at;
        const std::string words = usage.kind == posh::PartKind::Whole ? posh::describe(drawn_plan_, usage)
                                                                      : "in " + posh::describe(drawn_plan_, owner);
        addRow(*usage_list_, tr("Line %1: %2").arg(at.line).arg(QString::fromStdString(words)), at);
    }
    lists_->setTabText(2, tr("Usages (%1)").arg(usage_list_->count()));
    lists_->setCurrentWidget(usage_list_);
    lists_shown_->setChecked(true);
}

/// Wraps all parts of the range that is selected in the drawing.
void PlanEditor::wrapRange(posh::FormKind kind) {
    const auto partOf = [this](int node) {
        const auto call = callOfNode(drawn_plan_, canvas_->tree(), node);
        return call && posh::isStep(drawn_plan_, *call) ? call : partOfNode(drawn_plan_, canvas_->tree(), node);
    };
    const std::vector<int> nodes = canvas_->range();
    const auto first = gestures() ? partOf(nodes.front()) : std::nullopt;
    const auto last = gestures() ? partOf(nodes.back()) : std::nullopt;
    if (first && last)
        perform(posh::wrapParts(drawn_text_, *first, *last, kind));
}

/// Returns the robot's description of a sense or act, or the parameters of a form of the plan, or only the name.
agent::PrimitiveDescription PlanEditor::describe(const posh::Call& call, agent::PrimitiveKind kind) const {
    const auto known = std::ranges::find(primitives_, call.name.text, &agent::PrimitiveDescription::name);
    if (known != primitives_.end())
        return *known;
    agent::PrimitiveDescription description;
    description.name = call.name.text;
    description.kind = kind;
    for (const posh::Form& form : drawn_plan_.forms)
        if (posh::nameOf(form).text == call.name.text)
            for (const posh::Formal& formal : posh::formalsOf(form))
                description.parameters.push_back({formal.variable.name, formal.value.value, {}, 0.0, 0.0, {}, {}});
    return description;
}

void PlanEditor::editValues() {
    const auto part = gestures() ? selectedPart() : std::nullopt;
    const posh::Call* const call = part ? posh::callOf(drawn_plan_, *part) : nullptr;
    if (!call)
        return;
    const posh::SenseTest* const test = posh::senseOf(drawn_plan_, *part);
    auto* const dialog = test ? new PlanValuesDialog(describe(*call, agent::PrimitiveKind::Sense), *test, this)
                              : new PlanValuesDialog(describe(*call, agent::PrimitiveKind::Act), *call, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this,
            [this, dialog, part = *part, is_sense = test != nullptr, text = drawn_text_] {
                if (text != text_->planText())
                    return say(tr("The text has changed meanwhile; nothing was done."), true);
                perform(is_sense ? posh::replaceSense(text, part, dialog->test())
                                 : posh::replaceCall(text, part, dialog->call()));
            });
    dialog->open();
}

} // namespace usar::widgets
