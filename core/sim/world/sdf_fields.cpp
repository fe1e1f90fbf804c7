#include "core/sim/world/sdf_fields.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <mutex>
#include <sstream>
#include <system_error>

#include <unistd.h>

#include <sdf/Box.hh>
#include <sdf/Capsule.hh>
#include <sdf/Console.hh>
#include <sdf/Cylinder.hh>
#include <sdf/Sphere.hh>
#include <sdf/parser.hh>

#include "core/base/numbers.h"

namespace usar::sim {

namespace {

std::string placeIn(const std::filesystem::path& file, const std::optional<int>& line) {
    return line ? file.string() + ":" + std::to_string(*line) : file.string();
}

/// Makes libsdformat's console without its log file. The console opens ~/.sdformat/sdformat.log when it is made, and
/// offers no other way than to find another home: here it gets an environment of its own, in which home is no folder.
/// Nothing of the process's environment changes. Only before `main`, while no other thread reads the environment.
bool makeConsoleWithoutLog() {
    char no_home[] = "HOME=/dev/null";
    char* only_home[] = {no_home, nullptr};
    char** const real = environ;
    environ = only_home;
    sdf::Console::Instance();
    environ = real;
    return true;
}

[[maybe_unused]] const bool console_is_made = makeConsoleWithoutLog();

/// While it exists, libsdformat's console writes into `heard()`.
class Listener {
public:
    Listener()
        : console_(sdf::Console::Instance())
        , messages_(console_->GetMsgStream().GetStream())
        , log_(console_->GetLogStream().GetStream()) {
        console_->GetMsgStream().SetStream(&text_);
        console_->GetLogStream().SetStream(nullptr);
    }
    ~Listener() {
        console_->GetMsgStream().SetStream(messages_);
        console_->GetLogStream().SetStream(log_);
    }
    Listener(const Listener&) = delete;
    Listener& operator=(const Listener&) = delete;

    std::string heard() const { return text_.str(); }

private:
    sdf::ConsolePtr console_;
    std::ostream* messages_;
    std::ostream* log_;
    std::ostringstream text_;
};

/// Broken XML has no error of its own: the reason and the line appear only on the console.
tl::unexpected<Error> unreadable(const std::string& heard, const std::filesystem::path& file) {
    constexpr std::string_view reason_mark = "XML_ERROR_";
    constexpr std::string_view line_mark = "Line number=";
    const std::size_t reason = heard.find(reason_mark);
    if (reason == std::string::npos)
        return failure("this is not SDFormat", file.string(), fix_sdf);
    const std::string word = heard.substr(reason + reason_mark.size());
    const std::size_t line = heard.find(line_mark);
    const auto number =
        line == std::string::npos
            ? std::nullopt
            : std::optional(static_cast<int>(readNumberPrefix(heard.substr(line + line_mark.size())).value));
    return failure("the XML is broken (" + word.substr(0, word.find(' ')) + ")", placeIn(file, number), fix_sdf);
}

std::string textIn(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Line of the start tag number `number` (from 0) with this name, not counting comments.
std::optional<int> lineOfTag(const std::filesystem::path& file, const std::string& name, int number) {
    const std::string text = textIn(file);
    const std::string tag = "<" + name;
    int line = 1;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (text.compare(at, 4, "<!--") == 0) {
            const std::size_t end = std::min(text.find("-->", at), text.size());
            line += static_cast<int>(std::count(text.begin() + static_cast<std::ptrdiff_t>(at),
                                                text.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
            at = end;
        } else if (text.compare(at, tag.size(), tag) == 0 && number-- == 0) {
            return line;
        } else if (text[at] == '\n') {
            ++line;
        }
    }
    return std::nullopt;
}

std::optional<int> lineOf(const sdf::Element& element, const std::filesystem::path& file) {
    const sdf::ElementPtr parent = element.GetParent();
    if (element.LineNumber() || !parent)
        return element.LineNumber();
    int number = 0;
    for (sdf::ElementPtr other = parent->GetFirstElement(); other && other.get() != &element;
         other = other->GetNextElement())
        number += other->GetName() == element.GetName() ? 1 : 0;
    return lineOfTag(file, element.GetName(), number);
}

/// The description of all elements. The library reads it from text, which takes longer than reading one of our files.
const sdf::ElementPtr& wholeDescription() {
    static const sdf::ElementPtr described = [] {
        const auto made = std::make_shared<sdf::SDF>();
        sdf::init(made);
        return made->Root();
    }();
    return described;
}

/// The part of a description that a file with this text needs. The library copies the whole description of an element
/// each time that the element occurs: 668 others for a link, of which a robot uses some fifty. What may be missing and
/// is not mentioned in the file, not even in the type of a sensor, is left out.
sdf::ElementPtr neededPart(const sdf::ElementPtr& whole, std::string_view text) {
    if (whole->GetElementDescriptionCount() == 0 || whole->GetValue())
        return whole->Clone();
    auto part = std::make_shared<sdf::Element>();
    part->SetName(whole->GetName());
    part->SetRequired(whole->GetRequired());
    part->SetDescription(whole->GetDescription());
    part->SetCopyChildren(whole->GetCopyChildren());
    part->SetReferenceSDF(whole->ReferenceSDF());
    for (const sdf::ParamPtr& attribute : whole->GetAttributes())
        part->AddAttribute(attribute->GetKey(), attribute->GetTypeName(), attribute->GetDefaultAsString(),
                           attribute->GetRequired(), attribute->GetDescription());
    for (unsigned int i = 0; i < whole->GetElementDescriptionCount(); ++i) {
        const sdf::ElementPtr child = whole->GetElementDescription(i);
        const bool may_miss = child->GetRequired() == "0" || child->GetRequired() == "*";
        if (!may_miss || child->GetElementDescriptionCount() == 0 || text.find(child->GetName()) != text.npos)
            part->AddElementDescription(neededPart(child, text));
    }
    return part;
}

/// An empty document for a file with this text. The library rewrites files of older versions, with other elements.
sdf::SDFPtr emptyDocument(std::string_view text) {
    const sdf::ElementPtr& whole = wholeDescription();
    const auto document = std::make_shared<sdf::SDF>();
    const bool is_current = text.find("version=\"" + sdf::SDF::Version() + '"') != text.npos;
    document->Root(is_current ? neededPart(whole, text) : whole->Clone());
    return document;
}

} // namespace

Result<sdf::Root> loadSdf(const std::filesystem::path& file) {
    // The library has one console for the whole process, and a canceled world may still be being read by its thread.
    static std::mutex one_at_a_time;
    const std::scoped_lock lock(one_at_a_time);
    const Listener listener;
    std::error_code trouble;
    sdf::Root root;
    sdf::Errors errors;
    const sdf::SDFPtr document = emptyDocument(textIn(file));
    if (!sdf::readFile(std::filesystem::absolute(file, trouble).string(), document, errors) && errors.empty())
        return unreadable(listener.heard(), file);
    if (errors.empty())
        errors = root.Load(document);
    if (errors.empty())
        return root;
    const sdf::Error& first = errors.front();
    if (first.Code() == sdf::ErrorCode::FILE_READ)
        return unreadable(listener.heard(), file);
    return failure(first.Message(), placeIn(file, first.LineNumber()), fix_sdf);
}

tl::unexpected<Error> refusal(const std::string& what, const std::filesystem::path& file, const sdf::Element& element) {
    return failure(what, placeIn(file, lineOf(element, file)), fix_sdf);
}

Pose toPose(const ignition::math::Pose3d& pose) {
    const ignition::math::Vector3d angles_rad = pose.Rot().Euler();
    return {toVec3(pose.Pos()), angles_rad.X(), angles_rad.Y(), angles_rad.Z()};
}

Vec3 toVec3(const ignition::math::Vector3d& vector) {
    return {vector.X(), vector.Y(), vector.Z()};
}

std::optional<SizedShape> shapeIn(const sdf::Geometry& geometry) {
    const auto rod = [](const auto& shape, auto solid) {
        solid.radius_m = shape.Radius();
        solid.height_m = shape.Length();
        return SizedShape{solid, std::min(solid.radius_m, solid.height_m)};
    };
    switch (geometry.Type()) {
    case sdf::GeometryType::BOX:
        return SizedShape{BoxShape{toVec3(geometry.BoxShape()->Size())}, geometry.BoxShape()->Size().Min()};
    case sdf::GeometryType::SPHERE:
        return SizedShape{SphereShape{geometry.SphereShape()->Radius()}, geometry.SphereShape()->Radius()};
    case sdf::GeometryType::CYLINDER:
        return rod(*geometry.CylinderShape(), CylinderShape{});
    case sdf::GeometryType::CAPSULE:
        return rod(*geometry.CapsuleShape(), CapsuleShape{});
    default:
        return std::nullopt;
    }
}

std::optional<std::string> attributeOf(const sdf::Element& element, const std::string& name) {
    const auto attribute = element.GetAttribute(name);
    if (!attribute || attribute->GetAsString().empty())
        return std::nullopt;
    return attribute->GetAsString();
}

std::optional<double> numberOf(const sdf::Element& element, const std::string& attribute) {
    const auto text = attributeOf(element, attribute);
    const auto number = text ? readNumber(*text) : std::nullopt;
    return number && std::isfinite(*number) ? number : std::nullopt;
}

std::string textOf(const sdf::Element& parent, const std::string& name) {
    const sdf::ElementConstPtr child = parent.FindElement(name);
    return child && child->GetValue() ? child->GetValue()->GetAsString() : std::string();
}

bool readNumbers(std::string_view text, double* values, std::size_t count) {
    constexpr std::string_view blanks = " \t\r\n";
    std::size_t at = 0;
    for (std::size_t i = 0; i < count; ++i) {
        at = text.find_first_not_of(blanks, at);
        if (at == std::string_view::npos)
            return false;
        const std::size_t end = std::min(text.find_first_of(blanks, at), text.size());
        const auto number = readNumber(text.substr(at, end - at));
        if (!number || !std::isfinite(*number))
            return false;
        values[i] = *number;
        at = end;
    }
    return text.find_first_not_of(blanks, at) == std::string_view::npos;
}

} // namespace usar::sim
