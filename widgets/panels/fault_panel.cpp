#include "widgets/panels/fault_panel.h"

#include <cmath>

#include <QHeaderView>
#include <QLineEdit>

#include "widgets/panels/quantity_box.h"
#include "widgets/style/empty_state.h"
#include "widgets/style/scroll_box.h"
#include "widgets/style/theme.h"
#include "widgets/style/tips.h"

namespace usar::widgets {

namespace {

constexpr int id_role = Qt::UserRole;
constexpr int state_role = Qt::UserRole + 1;
constexpr double longest_s = 1e6;

/// Returns a keyword as the user reads it: "Sensor bias" for "sensor_bias".
QString titleOf(QString word) {
    word.replace('_', ' ');
    return word.left(1).toUpper() + word.mid(1);
}

/// Returns the label of a quantity: "Toward" for "toward_deg".
QString labelOf(QString key) {
    if (key.endsWith("_deg"))
        key.chop(4);
    return key.size() == 1 ? key : titleOf(key);
}

QString wordOf(FaultState state) {
    const QString words[] = {FaultPanel::tr("to come"), FaultPanel::tr("active"), FaultPanel::tr("over")};
    return words[static_cast<std::size_t>(state)];
}

QColor inkOf(FaultState state) {
    constexpr StateShape shapes[] = {StateShape::Waiting, StateShape::Bad, StateShape::Off};
    return stateColor(shapes[static_cast<std::size_t>(state)]);
}

/// Makes a field of the form as wide as the form.
void fillRow(QWidget* field) {
    field->setMinimumHeight(minimum_target);
    field->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QuantityBox* timeBox(const QString& at_zero, const QString& name, const QString& help) {
    auto* box = new QuantityBox;
    box->setRange(0.0, longest_s);
    box->setDecimals(1);
    box->setSuffix(FaultPanel::tr(" s"));
    box->setSpecialValueText(at_zero);
    box->setAccessibleName(name);
    tellRange(box, help);
    fillRow(box);
    return box;
}

/// Replaces the names and keeps the current text, even if an editable box no longer has it among its names.
void setNames(QComboBox* box, const QString& all, const QStringList& names) {
    const QString shown = box->currentText();
    const QSignalBlocker quiet(box);
    box->clear();
    box->addItem(all);
    box->addItems(names);
    const int at = box->findText(shown);
    if (at >= 0)
        box->setCurrentIndex(at);
    else if (box->isEditable() && !shown.isEmpty())
        box->setEditText(shown);
}

} // namespace

FaultPanel::FaultPanel(QWidget* parent)
    : QWidget(parent)
    , from_(timeBox(tr("now"), tr("Begins"), tr("Simulated time from now until the fault begins")))
    , lasts_(timeBox(tr("until it is ended"), tr("Lasts"),
                     tr("Simulated time that the fault lasts; 0: until you end it"))) {
    makeForm();
    makeList();
    auto* const scrolled = new QWidget;
    laidOut(new QVBoxLayout(scrolled), {}, gap::small, {kind_, help_, form_->parentWidget(), text_, list_})
        ->setStretchFactor(list_, 1);
    auto* const scroll = new ScrollBox(scrolled);
    auto* const buttons = new QWidget; // Outside of what scrolls, so that they are always seen.
    laidOut(new QHBoxLayout(buttons), {}, gap::small, {inject_, end_})->setStretchFactor(inject_, 1);
    laidOut(new QVBoxLayout(this), {gap::small, gap::small, gap::small, gap::small}, gap::small, {scroll, buttons})
        ->setStretchFactor(scroll, 1);
    empty_state_ = new EmptyState(this, tr("No simulator to break"),
                                  tr("Faults are made by the embedded simulator. Connect to it, and sensors, links, "
                                     "batteries, rotors and the wind can go wrong here on request."));
    onThemeChange(this, [this] { inkStates(); });
    setAvailable(false);
    setRobots({});
    setSensors({});
}

void FaultPanel::makeForm() {
    kind_->setAccessibleName(tr("Kind of fault"));
    kind_->setMinimumHeight(minimum_target);
    help_->setWordWrap(true);
    form_ = new QFormLayout(new QWidget);
    form_->setContentsMargins(0, 0, 0, 0);
    form_->setHorizontalSpacing(gap::medium);
    form_->setVerticalSpacing(gap::tiny);
    form_->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
    sensor_->setEditable(true);
    sensor_->setInsertPolicy(QComboBox::NoInsert);
    for (auto& [name, box] : {std::pair(tr("Robot"), robot_), std::pair(tr("Sensor"), sensor_)}) {
        box->setAccessibleName(name);
        fillRow(box);
        box->setMinimumContentsLength(8);
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        form_->addRow(name, box);
        connect(box, &QComboBox::currentTextChanged, this, &FaultPanel::showText);
    }
    sensor_->setToolTip(tr("The sensor by name or type; you can type one that is not listed"));
    form_->addRow(tr("Begins"), from_);
    form_->addRow(tr("Lasts"), lasts_);
    text_->setFont(codeFont());
    text_->setWordWrap(true);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    named(text_, tr("The fault as text"),
          tr("The same as text, for the list \"faults\" of a mission file and for --fault"));
    inject_->setProperty("role", "primary");
    connect(kind_, &QComboBox::currentIndexChanged, this, &FaultPanel::showKind);
    for (QuantityBox* box : {from_, lasts_})
        connect(box, &QuantityBox::valueChanged, this, &FaultPanel::showText);
}

void FaultPanel::makeList() {
    list_->setHeaderLabels({tr("Faults of this run"), tr("State")});
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setAccessibleName(tr("Faults of this run"));
    list_->header()->setStretchLastSection(false);
    list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    list_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    list_->setMinimumHeight(80);
    connect(list_, &QTreeWidget::itemSelectionChanged, this, &FaultPanel::selectionChanged);
}

void FaultPanel::setActions(QAction* inject, QAction* end) {
    followAction(inject_, inject);
    followAction(end_, end);
}

void FaultPanel::setKinds(std::vector<FaultKindInfo> kinds) {
    kinds_ = std::move(kinds);
    const QSignalBlocker quiet(kind_);
    kind_->clear();
    for (const FaultKindInfo& kind : kinds_)
        kind_->addItem(titleOf(kind.word), kind.word);
    showKind();
}

void FaultPanel::showKind() {
    for (const Field& field : fields_)
        form_->removeRow(field.box);
    fields_.clear();
    if (kind_->currentIndex() < 0)
        return;
    const FaultKindInfo& kind = kinds_[static_cast<std::size_t>(kind_->currentIndex())];
    help_->setText(kind.help.left(1).toUpper() + kind.help.mid(1) + '.');
    for (const FaultQuantity& quantity : kind.quantities)
        fields_.push_back(addNumber(quantity));
    form_->setRowVisible(robot_, kind.of_robot);
    form_->setRowVisible(sensor_, kind.of_sensor);
    showText();
}

FaultPanel::Field FaultPanel::addNumber(const FaultQuantity& quantity) {
    auto* box = new QuantityBox;
    box->setRange(quantity.smallest, quantity.largest);
    box->setDecimals(4);
    box->setSingleStep(quantity.largest <= 1.0 ? 0.05 : 1.0);
    if (!quantity.unit.isEmpty())
        box->setSuffix(quantity.unit == "deg" ? QStringLiteral("°") : ' ' + quantity.unit);
    box->setValue(quantity.usual);
    tellRange(box, quantity.help.left(1).toUpper() + quantity.help.mid(1));
    box->setAccessibleName(labelOf(quantity.key));
    fillRow(box);
    form_->insertRow(2 + static_cast<int>(fields_.size()), labelOf(quantity.key), box); // Below robot and sensor.
    connect(box, &QuantityBox::valueChanged, this, &FaultPanel::showText);
    return {quantity.key, box, quantity.usual};
}

void FaultPanel::setRobots(const QStringList& names) {
    setNames(robot_, tr("every robot"), names);
    showText();
}

void FaultPanel::setSensors(const QStringList& names) {
    if (sensor_->lineEdit()->hasFocus())
        return; // Not while the user is typing there.
    setNames(sensor_, tr("every sensor"), names);
    showText();
}

QString FaultPanel::text() const {
    if (kind_->currentIndex() < 0)
        return {};
    const FaultKindInfo& kind = kinds_[static_cast<std::size_t>(kind_->currentIndex())];
    QString text = kind.word;
    if (kind.of_robot && robot_->currentIndex() > 0)
        text += " robot=" + robot_->currentText();
    const QString sensor = sensor_->currentText().trimmed();
    if (kind.of_sensor && !sensor.isEmpty() && sensor != sensor_->itemText(0))
        text += " sensor=" + sensor;
    for (const Field& field : fields_)
        if (field.box->value() != field.usual)
            text += ' ' + field.key + '=' + QString::number(field.box->value(), 'g', 12);
    if (from_->value() > 0.0)
        text += " from=" + QString::number(from_->value(), 'g', 12);
    if (lasts_->value() > 0.0)
        text += " for=" + QString::number(lasts_->value(), 'g', 12);
    return text;
}

void FaultPanel::setFaults(const std::vector<FaultRow>& faults) {
    const int selected = endable();
    const QSignalBlocker quiet(list_);
    list_->clear();
    for (const FaultRow& fault : faults) {
        auto* item = new QTreeWidgetItem({fault.text, wordOf(fault.state)});
        item->setData(0, id_role, fault.id);
        item->setData(0, state_role, static_cast<int>(fault.state));
        item->setToolTip(0, fault.text + (fault.when.isEmpty() ? QString() : '\n' + fault.when));
        list_->insertTopLevelItem(0, item);
        if (fault.id == selected && fault.state != FaultState::Over)
            list_->setCurrentItem(item);
    }
    inkStates();
    emit selectionChanged();
}

void FaultPanel::inkStates() {
    for (int i = 0; i < list_->topLevelItemCount(); ++i) {
        QTreeWidgetItem* const item = list_->topLevelItem(i);
        item->setForeground(1, inkOf(static_cast<FaultState>(item->data(0, state_role).toInt())));
    }
}

void FaultPanel::setAvailable(bool on) {
    empty_state_->setVisible(!on);
    for (int i = 0; i < layout()->count(); ++i)
        if (QWidget* part = layout()->itemAt(i)->widget())
            part->setVisible(on);
}

int FaultPanel::endable() const {
    const auto selected = list_->selectedItems();
    if (selected.isEmpty() || selected.first()->data(0, state_role).toInt() == static_cast<int>(FaultState::Over))
        return 0;
    return selected.first()->data(0, id_role).toInt();
}

bool FaultPanel::anyToEnd() const {
    for (int i = 0; i < list_->topLevelItemCount(); ++i)
        if (list_->topLevelItem(i)->data(0, state_role).toInt() != static_cast<int>(FaultState::Over))
            return true;
    return false;
}

QString faultTimes(Seconds from, Seconds lasts) {
    const QString begin = FaultPanel::tr("From %1 s of the simulation's clock").arg(from.count(), 0, 'f', 1);
    return std::isfinite(lasts.count()) ? begin + FaultPanel::tr(" for %1 s").arg(lasts.count(), 0, 'f', 1) : begin;
}

} // namespace usar::widgets
