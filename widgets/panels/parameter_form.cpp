#include "widgets/panels/parameter_form.h"

#include <algorithm>

#include "widgets/panels/parameter_row.h"
#include "widgets/style/empty_state.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"
#include "widgets/style/tool_button.h"

namespace usar::widgets {

ParameterForm::ParameterForm(QWidget* parent)
    : QWidget(parent)
    , search_(
          makeSearchLine(tr("Search parameters"), tr("Shows only parameters whose name or help contains this"), this)) {
    laidOut(new QVBoxLayout(this), {}, gap::small, {makeTools(), nothing_, scroll_})->setStretchFactor(scroll_, 1);
    nothing_->setWordWrap(true);
    nothing_->hide();
    scroll_->setWidgetResizable(true);
    scroll_->setFrameShape(QFrame::NoFrame);
    scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll_->setFocusPolicy(Qt::NoFocus);
    empty_state_ =
        new EmptyState(this, tr("No parameters yet"), tr("Choose a robot and a behavior; its settings appear here."));
    search_->hide();
    modified_only_->hide();
    applyFilter();
}

QWidget* ParameterForm::makeTools() {
    auto* tools = new QWidget(this);
    modified_only_ = makeToolButton(tr("Show only parameters that differ from their defaults"), tools);
    modified_only_->setText(tr("Modified"));
    modified_only_->setCheckable(true);
    reset_all_ = makeToolButton(tr("Reset all parameters to their defaults"), tools, "reset");
    laidOut(new QHBoxLayout(tools), {}, gap::tiny, {search_, modified_only_, reset_all_})->setStretchFactor(search_, 1);
    connect(search_, &QLineEdit::textChanged, this, &ParameterForm::applyFilter);
    connect(modified_only_, &QToolButton::toggled, this, &ParameterForm::applyFilter);
    connect(reset_all_, &QToolButton::clicked, this, &ParameterForm::resetAll);
    return tools;
}

void ParameterForm::setSpecs(const std::vector<agent::ParameterSpec>& specs) {
    if (specs == specs_)
        return;
    if (!specs_.empty())
        keptValues() = modified();
    specs_ = specs;
    buildRows();
    empty_state_->setVisible(specs_.empty());
    empty_state_->raise();
    search_->setVisible(!specs_.empty());
    modified_only_->setVisible(!specs_.empty());
    setValues(keptValues());
}

ParameterForm::Values& ParameterForm::keptValues() {
    const auto known = std::ranges::find(kept_, specs_, &decltype(kept_)::value_type::first);
    return known != kept_.end() ? known->second : kept_.emplace_back(specs_, Values{}).second;
}

void ParameterForm::buildRows() {
    groups_.clear();
    rows_.clear();
    auto* page = new QWidget;
    for (const agent::ParameterSpec& spec : specs_) {
        auto* row = new ParameterRow(spec, page);
        connect(row, &ParameterRow::edited, this, &ParameterForm::rowEdited);
        groupOf(spec.group).rows.push_back(row);
        rows_.push_back(row);
    }
    auto* column = laidOut(new QVBoxLayout(page), {0, 0, gap::small, gap::small}, gap::tiny);
    for (auto& [name, group] : groups_) {
        group.header = mutedLabel(QString::fromStdString(name), page);
        group.header->setContentsMargins(0, column->isEmpty() ? 0 : gap::small, 0, 0);
        column->addWidget(group.header);
        for (ParameterRow* row : group.rows)
            column->addWidget(row);
    }
    column->addStretch();
    // Deleted later, because code that reacts to an edit of one of its rows may set other specs.
    if (QWidget* old = scroll_->takeWidget())
        old->deleteLater();
    scroll_->setWidget(page);
}

ParameterForm::Group& ParameterForm::groupOf(const std::string& name) {
    const auto found = std::ranges::find(groups_, name, &std::pair<std::string, Group>::first);
    return found != groups_.end() ? found->second : groups_.emplace_back(name, Group{}).second;
}

void ParameterForm::setValues(const Values& values) {
    for (ParameterRow* row : rows_)
        if (const auto found = values.find(row->spec().id); found != values.end())
            row->setValue(found->second);
    applyFilter();
}

ParameterForm::Values ParameterForm::values() const {
    Values all;
    for (const ParameterRow* row : rows_)
        all[row->spec().id] = row->value();
    return all;
}

ParameterForm::Values ParameterForm::modified() const {
    Values changes;
    for (const ParameterRow* row : rows_)
        if (row->modified())
            changes[row->spec().id] = row->value();
    return changes;
}

void ParameterForm::resetAll() {
    if (modified().empty())
        return;
    for (ParameterRow* row : rows_)
        row->setValue(row->spec().default_value);
    applyFilter();
    emit changed(values());
}

void ParameterForm::applyFilter() {
    const QString words = search_->text().trimmed();
    bool any = false;
    for (auto& [name, group] : groups_) {
        bool any_in_group = false;
        for (ParameterRow* row : group.rows) {
            const bool fits = row->matches(words) && (!modified_only_->isChecked() || row->modified());
            row->setVisible(fits);
            any_in_group = any_in_group || fits;
        }
        group.header->setVisible(any_in_group && !name.empty());
        any = any || any_in_group;
    }
    nothing_->setText(words.isEmpty() ? tr("Every parameter is at its default.")
                                      : tr("No parameter matches “%1”.").arg(words));
    nothing_->setVisible(!any && !groups_.empty());
    reset_all_->setVisible(!modified().empty());
}

// A row that an edit makes unmodified stays visible until the filter changes, so that it does not vanish while being
// edited.
void ParameterForm::rowEdited() {
    reset_all_->setVisible(!modified().empty());
    emit changed(values());
}

} // namespace usar::widgets
