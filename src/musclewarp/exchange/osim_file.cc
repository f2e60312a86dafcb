// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/osim_file.h"

#include <algorithm>
#include <pugixml.hpp>
#include <string_view>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/text.h"
#include "musclewarp/base/xml_text.h"
#include "musclewarp/exchange/osim_text.h"
#include "musclewarp/opensim/multivariate_polynomial.h"
#include "musclewarp/opensim/osim_xml.h"

namespace musclewarp {
namespace {

constexpr double kMetres = 1e-3;                    // in a mm
constexpr std::string_view kMark = "\xEF\xBB\xBF";  // of UTF-8

// Whether a name ends with "Joint", as those of all joints do.
bool IsJoint(pugi::xml_node node) {
  const std::string name = node.name();
  return name.size() >= 5 && name.compare(name.size() - 5, 5, "Joint") == 0 &&
         node.attribute("name");
}

pugi::xml_node JointAround(pugi::xml_node coordinate) {
  pugi::xml_node joint = coordinate;
  while (joint && !IsJoint(joint)) joint = joint.parent();
  return joint;
}

// The path of a coordinate, by its name in a Model, in a model of OpenSim 4:
// older joints, which are in bodies, are moved to the set of joints under their
// names.
std::string CoordinatePath(const pugi::xml_document& document,
                           const std::string& where,
                           const std::string& name) {
  const size_t slash = name.find('/');
  const std::string joint_name =
      slash == std::string::npos ? "" : name.substr(0, slash);
  const std::string last = LastName(name);
  const pugi::xml_node coordinate =
      document.find_node([&](pugi::xml_node node) {
        return std::string(node.name()) == "Coordinate" &&
               node.attribute("name").value() == last &&
               (joint_name.empty() ||
                JointAround(node).attribute("name").value() == joint_name);
      });
  const pugi::xml_node joint = JointAround(coordinate);
  if (!joint) {
    throw InputError(where + ": coordinate \"" + name + "\"",
                     "is not in a joint with a name",
                     "check the model");
  }
  return std::string("/jointset/") + joint.attribute("name").value() + "/" +
         last;
}

// Returns the polynomial with all monomials up to its order, as OpenSim has
// them.
MultivariatePolynomial AllTermsOf(const PathFunction& path) {
  MultivariatePolynomial polynomial;
  polynomial.dimension = static_cast<int>(path.exponents.cols());
  polynomial.order = path.exponents.rowwise().sum().maxCoeff();
  const Eigen::MatrixXi monomials =
      Monomials(polynomial.dimension, polynomial.order);
  std::map<std::vector<int>, double> terms;
  const auto exponents_of = [](const Eigen::MatrixXi& all, Eigen::Index row) {
    std::vector<int> exponents(all.cols());
    for (Eigen::Index k = 0; k < all.cols(); ++k) exponents[k] = all(row, k);
    return exponents;
  };
  for (Eigen::Index i = 0; i < path.exponents.rows(); ++i) {
    terms[exponents_of(path.exponents, i)] = path.coefficients[i];
  }
  polynomial.coefficients.resize(monomials.rows());
  for (Eigen::Index i = 0; i < monomials.rows(); ++i) {
    const auto term = terms.find(exponents_of(monomials, i));
    polynomial.coefficients[i] = term == terms.end() ? 0 : term->second;
  }
  return polynomial;
}

std::string Numbers(const Eigen::VectorXd& values) {
  std::string text;
  for (const double value : values) {
    text += (text.empty() ? "" : " ") + NumberText(value, 17);
  }
  return text;
}

// The lines of the element, each with its depth.
std::string PathText(const std::string& coordinates,
                     const MultivariatePolynomial& length,
                     bool has_property,
                     const std::string& newline,
                     const std::string& indent,
                     const std::string& step) {
  std::string text;
  int depth = 0;
  const auto line = [&](const std::string& words) {
    if (!text.empty()) {
      text += newline + indent;
      for (int i = 0; i < depth; ++i) text += step;
    }
    text += words;
  };
  if (!has_property) {
    line("<path>");
    ++depth;
  }
  line("<FunctionBasedPath name=\"path\">");
  ++depth;
  line("<coordinate_paths>" + coordinates + "</coordinate_paths>");
  line("<length_function>");
  ++depth;
  line("<MultivariatePolynomialFunction>");
  ++depth;
  line("<dimension>" + std::to_string(length.dimension) + "</dimension>");
  line("<order>" + std::to_string(length.order) + "</order>");
  line("<coefficients>" + Numbers(kMetres * length.coefficients) +
       "</coefficients>");
  --depth;
  line("</MultivariatePolynomialFunction>");
  --depth;
  line("</length_function>");
  --depth;
  line("</FunctionBasedPath>");
  if (!has_property) {
    --depth;
    line("</path>");
  }
  return text;
}

}  // namespace

std::string WithFunctionPaths(
    const std::string& bytes,
    const std::string& where,
    const std::vector<std::string>& coordinates,
    const std::map<std::string, PathFunction>& paths) {
  const std::string text = DecodeXml(bytes).utf8;
  const bool has_mark = bytes.compare(0, kMark.size(), kMark) == 0;
  pugi::xml_document document;
  ParseOsim(text, where, &document);
  const bool has_returns = text.find("\r\n") != std::string::npos;
  std::vector<TextEdit> edits;
  for (const auto& item : paths) {
    const pugi::xml_node path = PathOfMuscle(document, where, item.first);
    std::string names;
    for (const int k : item.second.coordinates) {
      names += (names.empty() ? "" : " ") +
               XmlEscaped(CoordinatePath(document, where, coordinates[k]));
    }
    TextEdit edit;
    edit.begin = BeginOf(path);
    edit.end = EndOf(text, path);
    const std::string indent = IndentAt(text, edit.begin);
    const bool has_tabs = indent.find('\t') != std::string::npos;
    edit.text = PathText(names,
                         AllTermsOf(item.second),
                         std::string(path.parent().name()) == "path",
                         has_returns ? "\r\n" : "\n",
                         indent,
                         has_tabs ? "\t" : "    ");
    edits.push_back(std::move(edit));
  }
  std::string edited = WithEdits(text, std::move(edits));
  edited = WithUtf8Declaration(std::move(edited));
  return has_mark ? std::string(kMark) + edited : edited;
}

}  // namespace musclewarp
