// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/any_message/message_codec.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

#include "goal_alignment/common/quote.h"

namespace goal_alignment::any_message {
namespace {

constexpr const char* kHeader = "std_msgs/Header";

template <typename Value>
void append(Bytes& bytes, const Value& value) {
  const auto* begin = reinterpret_cast<const std::uint8_t*>(&value);  // little endian, like ROS
  bytes.insert(bytes.end(), begin, begin + sizeof value);
}

void appendText(Bytes& bytes, const std::string& text) {
  append(bytes, static_cast<std::uint32_t>(text.size()));
  bytes.insert(bytes.end(), text.begin(), text.end());
}

class Encoder {
 public:
  Encoder(MessageTypes& types, const Arguments* arguments, std::string source, ros::Time now)
      : types_(types), arguments_(arguments), source_(std::move(source)), now_(now) {}

  // `given` may be undefined or null: everything keeps its default.
  void message(const MessageDefinition& definition, const YAML::Node& given) {
    const YAML::Node fields = resolve(given);
    const bool absent = !fields.IsDefined() || fields.IsNull() || isOpen(fields);
    if (!absent && !fields.IsMap()) expect(fields, "a map with the fields of " + definition.type);
    if (!absent) refuseUnknown(definition, fields);
    for (const MessageField& field : definition.fields) {
      const YAML::Node value = absent ? YAML::Node(YAML::NodeType::Undefined) : fields[field.name];
      if (!value.IsDefined() && definition.type == kHeader && field.type == "time") {
        time(now_);
      } else {
        this->field(field, value);
      }
    }
  }

  void scalar(const std::string& type, const YAML::Node& node) {
    if (!node.IsDefined() || node.IsNull() || isOpen(node)) return zero(type);
    if (type == "duration" || type == "time") return moment(type, node);
    if (!node.IsScalar()) expect(node, "a " + type);
    const std::string text = arguments_ == nullptr ? node.Scalar() : arguments_->fill(node);
    if (type == "string") return appendText(bytes, text);
    if (!number(type, text)) expect(node, "a " + type, text);
  }

  Bytes bytes;

 private:
  [[noreturn]] void expect(const YAML::Node& node, const std::string& expected,
                           const std::string& text = "") const {
    YamlReader(source_).failAt(
        node.Mark(), fmt::format("expected {}, found {}", expected,
                                 text.empty() ? YamlReader::describe(node) : inQuotes(text)));
  }

  YAML::Node resolve(const YAML::Node& node) const {
    if (arguments_ == nullptr || !node.IsDefined()) return node;
    return arguments_->resolve(node);
  }

  // Without arguments nothing is known of it yet.
  bool isOpen(const YAML::Node& node) const {
    return arguments_ == nullptr && node.IsScalar() && node.Scalar().find('{') != std::string::npos;
  }

  void refuseUnknown(const MessageDefinition& definition, const YAML::Node& fields) const {
    for (const auto& entry : fields) {
      if (!entry.first.IsScalar()) expect(entry.first, "the name of a field");
      if (definition.find(entry.first.Scalar()) != nullptr) continue;
      YamlReader(source_).failAt(
          entry.first.Mark(), fmt::format("{} has no field {}, but {}", definition.type,
                                          inQuotes(entry.first.Scalar()), definition.fieldNames()));
    }
  }

  void field(const MessageField& field, const YAML::Node& given) {
    if (field.length == MessageField::kSingle) return element(field, given);
    const YAML::Node list = resolve(given);
    const bool absent = !list.IsDefined() || list.IsNull() || isOpen(list);
    const std::size_t fixed =
        field.length == MessageField::kAnyLength ? 0 : static_cast<std::size_t>(field.length);
    if (!absent && !list.IsSequence()) expect(list, "a list of " + field.type);
    const std::size_t count = absent ? fixed : list.size();
    if (field.length == MessageField::kAnyLength) {
      append(bytes, static_cast<std::uint32_t>(count));
    } else if (count != fixed) {
      expect(list, fmt::format("a list of {} {}", fixed, field.type),
             fmt::format("{} of them", count));
    }
    for (std::size_t i = 0; i < count; ++i)
      element(field, absent ? YAML::Node(YAML::NodeType::Undefined) : list[i]);
  }

  void element(const MessageField& field, const YAML::Node& node) {
    if (field.builtin()) return scalar(field.type, resolve(node));
    message(types_.message(field.type), node);
  }

  void zero(const std::string& type) {
    const std::size_t size = sizeOfBuiltin(type).value_or(0);
    bytes.insert(bytes.end(), size == 0 ? sizeof(std::uint32_t) : size, 0);
  }

  void time(const ros::Time& stamp) {
    append(bytes, stamp.sec);
    append(bytes, stamp.nsec);
  }

  void moment(const std::string& type, const YAML::Node& node) {
    const char* expected = type == "time" ? "seconds or `now`" : "seconds";
    if (!node.IsScalar()) expect(node, expected);
    const std::string text = arguments_ == nullptr ? node.Scalar() : arguments_->fill(node);
    if (type == "time" && text == "now") return time(now_);
    const auto seconds = parse<double>(text);
    // What both types can hold.
    if (!seconds || !std::isfinite(*seconds) || std::abs(*seconds) > 2147483647.0 ||
        (type == "time" && *seconds < 0)) {
      expect(node, expected, text);
    }
    if (type == "time") return time(ros::Time(*seconds));
    const ros::Duration duration(*seconds);
    append(bytes, duration.sec);
    append(bytes, duration.nsec);
  }

  template <typename Value>
  static std::optional<Value> parse(const std::string& text) {
    Value value{};
    if (!YAML::convert<Value>::decode(YAML::Node(text), value)) return std::nullopt;
    return value;
  }

  template <typename Value, typename Wide>
  bool integer(const std::string& text) {
    const auto value = parse<Wide>(text);
    if (!value || *value < static_cast<Wide>(std::numeric_limits<Value>::min()) ||
        *value > static_cast<Wide>(std::numeric_limits<Value>::max())) {
      return false;
    }
    append(bytes, static_cast<Value>(*value));
    return true;
  }

  // False: the text is no such number.
  bool number(const std::string& type, const std::string& text) {
    using Signed = std::int64_t;
    if (type == "bool") {
      const auto value = parse<bool>(text);
      if (value) append(bytes, static_cast<std::uint8_t>(*value ? 1 : 0));
      return value.has_value();
    }
    if (type == "float32" || type == "float64") {
      const auto value = parse<double>(text);
      if (!value) return false;
      type == "float32" ? append(bytes, static_cast<float>(*value)) : append(bytes, *value);
      return true;
    }
    if (type == "int8" || type == "byte") return integer<std::int8_t, Signed>(text);
    if (type == "uint8" || type == "char") return integer<std::uint8_t, Signed>(text);
    if (type == "int16") return integer<std::int16_t, Signed>(text);
    if (type == "uint16") return integer<std::uint16_t, Signed>(text);
    if (type == "int32") return integer<std::int32_t, Signed>(text);
    if (type == "uint32") return integer<std::uint32_t, Signed>(text);
    if (type == "int64") return integer<std::int64_t, Signed>(text);
    return text.find('-') == std::string::npos && integer<std::uint64_t, std::uint64_t>(text);
  }

  MessageTypes& types_;
  const Arguments* arguments_;
  std::string source_;
  ros::Time now_;
};

struct Place {
  MessageField field;
  std::size_t begin = 0;
  std::size_t size = 0;
};

/// Finds its way through a message's bytes.
class Walk {
 public:
  Walk(MessageTypes& types, const Bytes& bytes) : types_(types), bytes_(bytes) {}

  Place find(const MessageDefinition& definition, const std::string& path) {
    const std::size_t dot = path.find('.');
    const std::string name = path.substr(0, dot);
    for (const MessageField& field : definition.fields) {
      if (field.name != name) {
        skip(field);
      } else if (dot != std::string::npos) {
        return find(types_.message(field.type), path.substr(dot + 1));
      } else {
        const std::size_t begin = at_;
        skip(field);
        return {field, begin, at_ - begin};
      }
    }
    throw TypeError(fmt::format("{} has no field {}", definition.type, inQuotes(name)));
  }

 private:
  void skip(const MessageField& field) {
    std::size_t count = 1;
    if (field.length == MessageField::kAnyLength) {
      count = length();
    } else if (field.length != MessageField::kSingle) {
      count = static_cast<std::size_t>(field.length);
    }
    const std::optional<std::size_t> size = sizeOfBuiltin(field.type);
    if (size && *size > 0) return forward(count * *size);
    for (std::size_t i = 0; i < count; ++i) {
      if (size) {
        forward(length());
      } else {
        for (const MessageField& part : types_.message(field.type).fields)
          skip(part);
      }
    }
  }

  std::size_t length() {
    std::uint32_t value = 0;
    const std::size_t begin = at_;
    forward(sizeof value);
    std::memcpy(&value, bytes_.data() + begin, sizeof value);
    return value;
  }

  void forward(std::size_t count) {
    if (count > bytes_.size() - at_) throw TypeError("the message is cut short");
    at_ += count;
  }

  MessageTypes& types_;
  const Bytes& bytes_;
  std::size_t at_ = 0;
};

template <typename Value>
std::string numberText(const std::uint8_t* bytes) {
  Value value{};
  std::memcpy(&value, bytes, sizeof value);
  return fmt::format("{}", value);
}

std::string textOf(const Bytes& message, const Place& place) {
  const std::string& type = place.field.type;
  const std::uint8_t* bytes = message.data() + place.begin;
  if (type == "bool") return *bytes != 0 ? "true" : "false";
  if (type == "string") {
    return inQuotes(std::string(bytes + sizeof(std::uint32_t), bytes + place.size));
  }
  if (type == "float32") return numberText<float>(bytes);
  if (type == "float64") return numberText<double>(bytes);
  const bool is_signed = type.front() == 'i' || type == "byte";
  switch (place.size) {
    case 1:
      return is_signed ? fmt::format("{}", int{static_cast<std::int8_t>(*bytes)})
                       : fmt::format("{}", int{*bytes});
    case 2:
      return is_signed ? numberText<std::int16_t>(bytes) : numberText<std::uint16_t>(bytes);
    case 4:
      return is_signed ? numberText<std::int32_t>(bytes) : numberText<std::uint32_t>(bytes);
    default:
      return is_signed ? numberText<std::int64_t>(bytes) : numberText<std::uint64_t>(bytes);
  }
}

}  // namespace

Bytes encode(MessageTypes& types, const MessageDefinition& definition, const YAML::Node& fields,
             const Arguments& arguments, const ros::Time& now) {
  Encoder encoder(types, &arguments, arguments.source(), now);
  encoder.message(definition, fields);
  return std::move(encoder.bytes);
}

void check(MessageTypes& types, const MessageDefinition& definition, const YAML::Node& fields,
           const std::string& source) {
  Encoder(types, nullptr, source, {}).message(definition, fields);
}

namespace {

// Of a single value.
const MessageField& fieldAt(MessageTypes& types, const MessageDefinition& definition,
                            const std::string& path) {
  const std::size_t dot = path.find('.');
  const MessageField* field = definition.find(path.substr(0, dot));
  if (field == nullptr) {
    throw TypeError(fmt::format("{} has no field {}, but {}", definition.type,
                                inQuotes(path.substr(0, dot)), definition.fieldNames()));
  }
  const bool single = field->length == MessageField::kSingle;
  const bool has_more = dot != std::string::npos;
  if (!single || field->builtin() == has_more) {
    throw TypeError(fmt::format("{}: {} is no single value", definition.type, inQuotes(path)));
  }
  if (has_more) return fieldAt(types, types.message(field->type), path.substr(dot + 1));
  return *field;
}

}  // namespace

std::string typeAt(MessageTypes& types, const MessageDefinition& definition,
                   const std::string& path) {
  return fieldAt(types, definition, path).type;
}

void checkValue(MessageTypes& types, const MessageDefinition& definition, const std::string& path,
                const YAML::Node& expected, const Arguments& arguments) {
  Encoder wanted(types, &arguments, arguments.source(), {});
  wanted.scalar(fieldAt(types, definition, path).type, arguments.resolve(expected));
}

bool matches(MessageTypes& types, const MessageDefinition& definition, const Bytes& message,
             const std::string& path, const YAML::Node& expected, const Arguments& arguments,
             std::string& found) {
  const Place place = Walk(types, message).find(definition, path);
  Encoder wanted(types, &arguments, arguments.source(), {});
  wanted.scalar(place.field.type, arguments.resolve(expected));
  found = textOf(message, place);
  const auto begin = message.begin() + static_cast<std::ptrdiff_t>(place.begin);
  return Bytes(begin, begin + static_cast<std::ptrdiff_t>(place.size)) == wanted.bytes;
}

}  // namespace goal_alignment::any_message
